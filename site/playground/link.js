// A link that holds everything seen: the task, the agents, the settings, the seed, the bet, and how far the race is.

export const FIRST = { task: 'Boulder', strength: null, agents: [0, 1, 2], speed: 1, seed: 0, several: 1, steps: null,
  learning_rate: null, discount: null, epsilon: null, show: 'visits', policy: true, bet: null, at: [0, 0, 0], play: false, blind: false }

export function read(hash) {
  const state = structuredClone(FIRST)
  for (const [name, text] of new URLSearchParams(hash.slice(1))) {
    if (!(name in FIRST)) continue
    if (Array.isArray(FIRST[name])) {
      const numbers = text.split('.').map(Number)
      if (numbers.length === 3 && numbers.every(n => Number.isInteger(n) && n >= 0)) state[name] = numbers
    } else if (typeof FIRST[name] === 'boolean') state[name] = text === 'true'
    else if (typeof FIRST[name] === 'string') state[name] = text
    else if (Number.isFinite(Number(text))) state[name] = Number(text)
  }
  return state
}

export function write(state) {
  const changed = Object.entries(state).filter(([name, value]) => String(value) !== String(FIRST[name]))
  return '#' + new URLSearchParams(changed.map(([name, value]) => [name, Array.isArray(value) ? value.join('.') : value]))
}
