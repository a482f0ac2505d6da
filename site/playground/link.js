// A link holds the settings: task, agents, seeds, sliders, and the reader's own program (see packed.js). How far the race
// is (`at`) it holds where the reader wants its results in it. A bet is nobody's but the reader's, so it holds none.

import { LONGEST } from './packed.js'

export const FIRST = { task: 'Boulder', strength: null, agents: [0, 1, 2], speed: null, seed: 0, several: null, steps: null,
  learning_rate: null, discount: null, epsilon: null, show: 'visits', policy: true, at: [0, 0, 0], play: false, code: false, blind: false, source: '' }
const MOST = 10_000_000 // steps of a race
const RANGES = { strength: [0, 99], agents: [0, 99], speed: [0, 9], seed: [0, 99], several: [1, 20], steps: [100, MOST],
  learning_rate: [0.01, 1], discount: [0, 1], epsilon: [0, 1], at: [0, MOST] }
const FRACTIONS = ['speed', 'learning_rate', 'discount', 'epsilon']
const CHOICES = ['visits', 'values', 'nothing']

// What a link says, as far as it can be true; the rest is as at first.
export function read(hash) {
  const state = structuredClone(FIRST)
  for (const [name, text] of new URLSearchParams(hash.slice(1))) {
    const first = FIRST[name]
    if (Array.isArray(first)) {
      const numbers = text.split('.').map(part => number(name, part))
      if (numbers.length === first.length && !numbers.includes(undefined)) state[name] = numbers
    } else if (typeof first === 'boolean') state[name] = text === 'true'
    else if (name === 'task' || (name === 'show' && CHOICES.includes(text))) state[name] = text
    else if (name === 'source' && text.length <= LONGEST && /^[\w-]*$/.test(text)) state.source = text
    else if (name in RANGES) state[name] = number(name, text) ?? first
  }
  return state
}

function number(name, text) {
  const value = Number(text), [low, high] = RANGES[name]
  if (!text || !(value >= low && value <= high)) return undefined
  return FRACTIONS.includes(name) || Number.isInteger(value) ? value : undefined
}

export function write(state) {
  const changed = Object.entries(state).filter(([name, value]) => String(value) !== String(FIRST[name]))
  return '#' + new URLSearchParams(changed.map(([name, value]) => [name, Array.isArray(value) ? value.join('.') : value]))
}
