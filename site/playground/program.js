// The same numbers in Python: the lines that make tasks and agents as the page has them. `state` is the page's.

// The settings of the sliders that an agent takes, where the reader has moved them.
export const given = ({ own }, state) => Object.keys(own).filter(name => state[name] !== null)

// The lines that make the task, as an agent sees it.
export function made({ seen }, race, state) {
  const { parameter, values, others } = race.strength, value = values[state.strength].replace('inf', 'float("inf")')
  const set = [`"${race.name}"`, `${parameter}=${value}`, ...others].join(', ')
  return `mdp = edugym.make_mdp(${set})\n${seen ? `mdp = ${seen}\n` : ''}`
}

export function create({ kind }, settings) {
  return `${kind}.create(${['mdp', ...settings.map(([name, value]) => `${name}=${value}`)].join(', ')})`
}

// An agent's settings as code, with those of the sliders that the reader has moved.
export function settled(agent, state) {
  const known = Object.fromEntries(agent.settings)
  for (const name of given(agent, state)) {
    if (name === 'epsilon') known.exploration = `edugym.EpsilonGreedy(${state.epsilon})`
    else known[name] = state[name]
  }
  return Object.entries(known)
}

// The whole race.
export function program(race, state) {
  const blocks = state.agents.map(k => race.agents[k]).map(agent => {
    return `# ${agent.label}\n${made(agent, race, state)}agent = edugym.${create(agent, settled(agent, state))}\n`
      + `run = edugym.${race.measure ? 'objectives.train_vectors' : 'train'}(mdp, agent, ${state.steps}, seed=${state.seed}, evaluation_episodes=${race.episodes})\n`
      + `print(${race.measure?.code ?? 'run.returns'})\n`
  })
  return `import edugym${race.measure ? '.objectives' : ''}\n\n${blocks.join('\n')}`
}
