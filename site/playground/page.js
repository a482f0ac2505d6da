// The page: it puts together menu, race, settings, link and game. What it knows of tasks comes from data/, written by
// the package; what it shows is in one `state`, which is what a link holds, and the reader's `bet`.

import { chart, short } from './chart.js'
import { read, write } from './link.js'
import { Lane } from './lane.js'
import { Play } from './play.js'
import { create, given, made, program, settled } from './program.js'
import { soon } from './soon.js'
import { LUCK, verdict } from './verdict.js'

const find = id => document.getElementById(id)
const data = await (await fetch('data/playground.json')).json()
const STEPS = [10_000, 100_000, 1_000_000, 10_000_000] // how long a race may be
const SINGLE = 20 // steps a second that an eye can follow
const LASTS = 50 // seconds of a race, where the reader has set no speed: in each, something is learned within 15
const OWN = { learning_rate: 'α', discount: 'γ', epsilon: 'ε' } // settings that agents may be given, in place of the lesson's
// On the page of the playground the address is that of the page around this one.
const whole = window.frameElement?.hasAttribute('data-address') ? parent : window
const SENT = 'The link holds this race as it was run'
let state, aside, raced, written, race, task, bet = null, running = false, charted = 0
const lanes = [0, 1, 2].map(k => new Lane(k, { onAgent, onBet, onLook }))
const play = new Play(find)
// Where npm does not answer, the page is built without an editor, and where the first race alone is shown, it needs none.
const needed = data.editor && !('first' in document.documentElement.dataset)
const editor = needed ? new (await import('./editor.js')).Editor(find, data, onCode) : null
lanes.forEach(lane => find('lanes').append(lane.article))

// Menus that do not depend on the task

find('tasks').innerHTML = data.races.map(({ name, challenge }) => `<a href="#task=${name}" title="${challenge}">${name}</a>`).join('')
find('tasks').onclick = event => {
  if (whole === window || !event.target.hash || event.ctrlKey || event.metaKey || event.shiftKey) return
  event.preventDefault()
  whole.location.hash = event.target.hash
}
// A link would change the address, and with it the task.
document.querySelector('.skip').onclick = event => {
  event.preventDefault()
  find('question').focus()
}
find('several').innerHTML = find('code-several').innerHTML = data.several.map(([n]) => `<option value="${n}">${n}</option>`).join('')
find('code-show').innerHTML = find('show').innerHTML
find('seed').innerHTML = data.seeds.map((_, k) => `<option>${k}</option>`).join('')

// From the state to the page

async function open() {
  state = read(whole.location.hash)
  written = aside = bet = null
  raced = false
  race = data.races.find(({ name }) => name === state.task) ?? data.races.find(({ name }) => name === 'Boulder')
  state.task = race.name
  state.code &&= Boolean(editor)
  state.play &&= !state.code
  for (const name in usual()) state[name] ??= usual()[name]
  state.strength = within(state.strength, race.strength.values.length)
  state.agents = state.agents.map(k => within(k, race.agents.length))
  state.seed = within(state.seed, data.seeds.length)
  if (!data.several.some(([n]) => n === state.several)) state.several = usual().several
  state.source ||= editor?.packed ?? '' // what the reader has written goes along
  for (const link of find('tasks').children) {
    if (link.textContent !== race.name) link.removeAttribute('aria-current')
    else link.setAttribute('aria-current', 'page')
  }
  document.title = `${race.name} · EduGym playground`
  find('question').textContent = race.question
  find('rules').textContent = race.rules
  find('plainly').textContent = race.plainly
  find('answer').textContent = race.answer
  find('answer').hidden = !race.answer
  find('why').textContent = race.why
  find('lesson').textContent = race.lesson
  find('lesson').href = race.link
  find('strength-name').textContent = race.strength.label
  find('strength').max = race.strength.values.length - 1
  find('code-strength-name').textContent = find('strength-name').textContent
  find('code-strength').innerHTML = race.strength.values.map((value, k) => `<option value="${k}">${value}</option>`).join('')
  find('steps').innerHTML = find('code-steps').innerHTML = [...new Set([...STEPS, race.steps, race.code.steps, state.steps])].sort((a, b) => a - b)
    .map(n => `<option value="${n}">${short(n)}</option>`).join('')
  find('tab-code').hidden = !editor
  uncover()
  await begin()
  await refresh()
}

// What a tab begins with. Where the code is changed, a change soon shows: at the settings of a race it may not.
const usual = () => state.code ? race.code : { strength: race.strength.first, steps: race.steps, several: race.seeds }

// A new race: everybody at the start, or as far as the link says. With `keep` it stays as it was when its tab was left.
async function begin(keep = false) {
  stop()
  const wanted = `data/${race.name}-${state.strength}.json`
  const answer = await (await fetch(wanted)).json()
  if (wanted !== `data/${race.name}-${state.strength}.json`) return // the reader has moved on
  task = answer
  for (const box of [find('lanes'), find('bench')]) box.classList.toggle('wide', task.scene.width > (box.id === 'lanes' ? 1.2 : 0.8) * task.scene.height)
  find('lanes').classList.toggle('several', state.several > 1)
  if (!state.code && !(keep && raced)) ready()
  controls()
  legend()
  find('code').textContent = program(race, state)
}

function ready() {
  raced = true
  charted = 0
  const seeds = Array.from({ length: state.several }, (_, k) => data.seeds[(state.seed + k) % data.seeds.length])
  const { steps, show, policy, at } = state
  const how = { seeds, student: student(), steps, every: Math.max(1, Math.floor(steps / 100)), show, policy, at }
  lanes.forEach((lane, k) => lane.begin(race, task, state.agents[k], { ...how, settings: slots(race.agents[state.agents[k]]) }))
  find('run').disabled = find('again').disabled = false
  invite()
}

function invite() {
  tell(state.at.some(Boolean) ? `${SENT} …` : bet === null ? 'Bet first, if you like. Then press Run.' : 'Your bet is placed. Press Run.')
}

// What the numbers, signs and colours below and in the pictures mean.
function legend() {
  const signs = new Map()
  if (state.policy) task.marks.forEach(([, , sign], k) => signs.set(sign, [...signs.get(sign) ?? [], task.actions[k]]))
  const numbered = [...signs.keys()].every(sign => /^\d+$/.test(sign)) // a door, or a machine
  const named = signs.size && numbered ? [`the number of the ${task.actions[0].split(' ')[0]}`] : [...signs].map(([sign, [first, ...more]]) => more.length ? `${sign} the ${first.replace(/ \d+$/, '')} that it would take` : first.endsWith(sign) ? first : `${sign} ${first}`)
  const colours = { visits: 'The darker the purple, the more often it was there.', values: 'The brighter, the more points it expects from there on.', nothing: '' }[state.show]
  const seeds = state.several > 1 ? `The numbers are means of ${state.several} seeds, with 95 % intervals; the pictures show seed ${state.seed}. ` : ''
  const says = pictures => {
    const signed = pictures.some(picture => picture?.readable()) ? `The signs in the picture say what it would do there: ${named.join(', ')}. `
      : 'The fields are too small here for signs of what it would do. '
    return `${named.length ? signed : ''}${colours} ${race.fields}`
  }
  find('legend').textContent = `${seeds}${says(lanes.map(({ picture }) => picture))}`
  if (state.code) find('code-legend').textContent = says(Object.values(editor.pictures ?? {}))
}

function controls() {
  const strength = race.strength.values[state.strength]
  find('strength').value = state.strength
  find('strength-shown').value = strength.replace('inf', '∞')
  find('strength').setAttribute('aria-valuetext', strength)
  find('speed').value = state.speed ?? Math.log10(rate())
  find('speed-shown').value = rate() === Infinity ? 'as fast as it goes' : `${short(Math.round(rate()))} steps a second`
  for (const name in OWN) {
    const usual = race.agents[0].own[name]
    find(name).value = state[name] ?? usual
    find(name).nextElementSibling.value = state[name] ?? `lesson: ${usual}`
  }
  const racing = [...new Set(state.agents)].map(k => race.agents[k]), unmoved = Object.entries(OWN).flatMap(([name, sign]) => {
    const others = racing.filter(({ own }) => !(name in own)).map(({ label }) => label)
    return others.length ? `${sign} changes nothing for ${others.join(', ')}.` : []
  })
  find('unmoved').textContent = unmoved.join(' ')
  for (const name of ['steps', 'several', 'show', 'seed']) find(name).value = state[name]
  for (const name of ['steps', 'several', 'strength']) find(`code-${name}`).value = state[name]
  find('code-show').value = state.show
  find('policy').checked = state.policy
  find('blind').checked = state.blind
  const begun = running || state.at.some(Boolean) || lanes.some(({ steps }) => steps)
  find('verdict').classList.toggle('awaited', begun) // it has its whole height from here on, so that nothing moves at the end
  lanes.forEach((lane, k) => {
    lane.bet.setAttribute('aria-pressed', bet === k)
    lane.bet.disabled = begun // whoever has seen something does not bet
    lane.bet.textContent = !begun ? 'Bet on this one' : bet === k ? 'Your bet' : 'Bets are closed'
    lane.bet.title = begun ? 'Bets close when the race begins. “Other luck” opens them again.' : ''
  })
  if (written !== write(state)) {
    written = write(state)
    whole.history.replaceState(null, '', written)
    find('shared').textContent = '' // what was copied was another link
  }
  const ended = lanes.length && lanes.every(({ over }) => over)
  find('whole').href = `../playground.html${write({ ...state, at: ended ? lanes.map(({ steps }) => steps) : state.at })}`
}

const slots = agent => Object.fromEntries(given(agent, state).map(name => [`.${name}`, state[name]]))
const student = () => data.several.find(([n]) => n === state.several)[1]
const within = (k, n) => Number.isInteger(k) && k >= 0 && k < n ? k : 0
const rate = () => state.speed === null ? state.steps / LASTS : state.speed >= Number(find('speed').max) ? Infinity : 10 ** state.speed
const tell = text => { find('verdict').textContent = text }

// What happens

function onLook(lane, fresh) {
  if (fresh || performance.now() - charted > 100 || lane.over) soon(draw)
  const over = lanes.every(({ over }) => over)
  if (running && over) finish()
  else if (fresh && state.at.some(Boolean) && lanes.every(({ look }) => look)) {
    tell(over ? `${SENT}: ${judged().replace(LUCK, '')} “Other luck” begins a race of your own.` : `${SENT} so far. Press Run to go on.`)
  }
}

const judged = () => verdict(lanes, student(), state.steps, bet, task.optimum)

function draw() {
  if (!lanes.every(({ look }) => look)) return // a new race has begun meanwhile
  charted = performance.now()
  chart(find('chart'), lanes.map(({ curves }) => curves), student(), { steps: state.steps, optimum: task.optimum, names: lanes.map(({ label }) => label) })
  const what = state.several > 1 ? `, mean of ${state.several} seeds with its 95 % interval` : ''
  const says = race.measure?.says ?? `Points in a game (the mean of ${race.episodes} games without random moves)`
  find('caption').textContent = `${says}, after so many steps of training${what}`
}

function finish() {
  stop()
  soon(draw)
  controls()
  tell(judged())
}

function stop() {
  running = false
  find('run').textContent = 'Run'
  lanes.forEach(lane => lane.rate(0))
}

// What is said while they learn.
function pace() {
  const minutes = (state.steps - Math.min(...lanes.map(({ steps }) => steps))) / rate() / 60
  const long = `At this speed the end comes in ${short(Math.round(minutes))} minutes: move it to the right to see who wins.`
  const fast = rate() > SINGLE && rate() < Infinity ? 'Move the speed to the left to follow single steps.' : ''
  tell(`They are learning … ${minutes < 2 ? fast : long}`)
}

function onAgent(k, agent) {
  state.agents[k] = agent
  if (bet === k) bet = null
  restart()
}

function onBet(k) {
  bet = bet === k ? null : k
  controls()
  invite()
}

function restart() {
  state.at = [0, 0, 0]
  return begin()
}

function set(name, value, what = restart) {
  state[name] = value
  what()
}

find('run').onclick = () => {
  if (running) {
    stop()
    tell('Paused. Press Run to go on.')
    return controls()
  }
  if (lanes.every(({ over }) => over)) return restart().then(() => find('run').onclick())
  running = true
  find('run').textContent = 'Pause'
  controls()
  pace()
  if (parent === window) find('verdict').scrollIntoView({ block: 'nearest' }) // a phone may have it below the screen
  lanes.forEach(lane => lane.rate(rate()))
}
find('again').onclick = () => set('seed', (state.seed + state.several) % data.seeds.length)
find('speed').oninput = event => {
  set('speed', event.target.valueAsNumber, controls)
  if (running) lanes.forEach(lane => lane.rate(rate()))
  if (running) pace()
}
find('strength').oninput = event => set('strength', event.target.valueAsNumber, () => restart().then(refresh))
for (const name in OWN) find(name).oninput = event => set(name, name === 'learning_rate' ? Math.max(0.01, event.target.valueAsNumber) : event.target.valueAsNumber)
find('own').onclick = () => { for (const name in OWN) state[name] = null; restart() }
for (const name of ['steps', 'several', 'strength']) find(`code-${name}`).onchange = event => set(name, Number(event.target.value), () => settle(restart().then(refresh)))
for (const name of ['steps', 'several', 'seed']) find(name).onchange = event => set(name, Number(event.target.value))
find('show').onchange = find('code-show').onchange = event => set('show', event.target.value, redraw)
find('policy').onchange = event => set('policy', event.target.checked, redraw)
find('blind').onchange = event => set('blind', event.target.checked, () => { controls(); play.show('') })

function remeasure() {
  if (!task) return // nothing is there yet
  for (const { picture } of lanes) picture?.measure()
  redraw()
  soon(draw)
  if (state.code) editor.measure()
}

function redraw() {
  controls()
  legend()
  for (const lane of lanes) {
    if (lane.how) Object.assign(lane.how, { show: state.show, policy: state.policy })
    soon(lane.draw)
  }
  if (state.code) editor.draw()
}

// Watch or play

const TABS = { race: 'race', play: 'play', code: 'code-panel' } // each with its panel
const chosen = () => state.code ? 'code' : state.play ? 'play' : 'race'

async function choose(name) {
  if (name !== 'race' && running) find('run').onclick()
  const turned = state.code !== (name === 'code'), { strength, steps, several } = state
  state.play = name === 'play'
  state.code = name === 'code'
  if (turned) {
    Object.assign(state, aside ?? usual())
    aside = { strength, steps, several }
  }
  uncover()
  if (turned) await begin(true)
  else controls()
  if (name !== 'race') return refresh()
  remeasure()
}

function uncover() {
  for (const [name, panel] of Object.entries(TABS)) {
    const on = name === chosen()
    find(panel).hidden = !on
    find(`tab-${name}`).setAttribute('aria-selected', on)
    find(`tab-${name}`).tabIndex = on ? 0 : -1
  }
  find('with-results').parentElement.hidden = chosen() !== 'race' // the others have none to send
}

async function refresh() {
  if (state.play) await play.open(race, task, data.seeds[state.seed])
  if (state.code) await settle(editor.open(race, task, state, {
    task: lane => made(lane, race, state),
    settings: agent => settled(agent, state),
    agent: agent => `agent = ${create({ kind: agent.kind.split('.').at(-1) }, settled(agent, state))}\n`,
    own: ({ own }) => Object.fromEntries(Object.entries(own).map(([name, value]) => [name, state[name] ?? value])),
    slots,
  }).then(legend))
}

// The editor runs nothing before this has come.
function settle(promise) {
  if (editor) editor.settled = promise
  return promise
}

for (const name of Object.keys(TABS)) find(`tab-${name}`).onclick = async () => {
  await choose(name)
  if (name !== 'play') return
  find('play').focus({ preventScroll: true }) // or the arrow keys would turn to the next tab
  find('play').scrollIntoView({ block: 'nearest' }) // picture, actions and points in one view
}
document.querySelector('.tabs').onkeydown = event => {
  if (!/^Arrow(Left|Right)$/.test(event.key)) return
  event.stopPropagation()
  const names = Object.keys(TABS).filter(name => !find(`tab-${name}`).hidden), step = event.key === 'ArrowRight' ? 1 : -1
  const name = names.at((names.indexOf(chosen()) + step) % names.length)
  choose(name).then(() => find(`tab-${name}`).focus())
}

// The reader has written something: `packed` is the program as letters, '' where it is the page's own, or too long.
function onCode(packed) {
  state.source = packed
  controls()
}

find('share').onclick = async () => {
  await editor?.pack()
  controls()
  const at = find('with-results').checked && chosen() === 'race' ? lanes.map(({ steps }) => steps) : [0, 0, 0]
  const link = whole.location.href.split('#')[0] + write({ ...state, at })
  const without = editor?.tooLong ? ' Your code is not in it, since it is too long for a link: send it as a file.' : ''
  try {
    await navigator.clipboard.writeText(link)
    find('shared').textContent = `Copied.${without}`
  } catch { // the browser does not let a page copy
    const shown = Object.assign(document.createElement('a'), { href: link, target: '_top', textContent: 'This is the link' })
    find('shared').replaceChildren(shown, `: copy it with the menu of your mouse or finger.${without}`)
  }
}
find('with-results').onchange = () => { find('shared').textContent = '' } // what was copied was another link
find('theme').onclick = () => {
  const theme = document.documentElement.dataset.theme === 'dark' ? 'light' : 'dark'
  document.documentElement.dataset.theme = localStorage.theme = theme
}
addEventListener('storage', setTheme) // the page around this one has changed it
whole.addEventListener('hashchange', () => { if (/=|^$/.test(whole.location.hash)) settle(open()) }) // others are headings
addEventListener('resize', remeasure)
await settle(open())
document.documentElement.dataset.ready = 'true' // see style.css
