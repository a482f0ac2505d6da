// "Change the code": a reader's own agent in Python, which races against one of the package's. Python is loaded with
// the first change; until then nothing of it is. Stop ends the worker, whatever the code does.

import { chart, short } from './chart.js'
import { Field } from './field.js'
import { LONGEST, pack, unpack } from './packed.js'
import { Picture } from './picture.js'
import { soon } from './soon.js'
import { duel } from './verdict.js'
import { Walk } from './walk.js'

const SHORT = `class MyAgent(NamedTuple):
    """Q-learning in a few lines. Change them!"""

    Q: np.ndarray

    def act(self, state, rng):
        if rng.random() < 0.1:
            return rng.integers(self.Q.shape[1])
        return self.greedy(state, rng)

    def greedy(self, state, rng):
        best = np.flatnonzero(self.Q[state] == self.Q[state].max())
        return rng.choice(best)

    def learn(self, state, action, reward, next_state, terminated):
        target = reward if terminated else reward + 0.99 * self.Q[next_state].max()
        self.Q[state, action] += 0.1 * (target - self.Q[state, action])


agent = MyAgent(edugym.QLearning.create(mdp).Q)
`
// With the settings of the race, so that the same algorithm learns as fast.
const short_one = ({ learning_rate, discount, epsilon }) => SHORT.replace('random() < 0.1', `random() < ${epsilon}`)
  .replace('0.99 *', `${discount} *`).replace('0.1 * (target', `${learning_rate} * (target`)
// A package's agent, where a default says what the last line of the program sets in its place.
const annotated = (source, settings) => settings.reduce((text, [name]) => text.replace(new RegExp(`^ {4}${name}: .*=.*$`, 'm'), line => `${line}  # the last line sets it`), source)
const LATE = 100 // points of a curve
const SILENT = 'Nothing has come from your agent for 20 s: it is slow, or a loop in it never ends. Stop ends it.'
const PATIENCE = 20_000 // milliseconds without a word of the reader's agent
const PAUSE = 500 // milliseconds without a change after which the link has the program
const KEPT = 'your last code' // what a template has replaced
const SIGNS = { learning_rate: 'α', discount: 'γ', epsilon: 'ε' }
const FROM_LINK = 'This code comes from the link. Read it before you press Run: it then runs in your browser.'

export class Editor {
  // `onCode` is told the program as letters of a link, see `pack`.
  constructor(find, { editor: sizes, seeds, several }, onCode) {
    Object.assign(this, { find, sizes, seeds, several, onCode, number: 0, template: 0, filled: '', packed: '' })
    this.curves = this.curves.bind(this)
    this.paint = { ours: () => this.knowledge('ours'), theirs: () => this.knowledge('theirs') }
    this.field = new Field(find('editor'), () => {
      this.python() // begins to load
      this.changed()
      clearTimeout(this.packing)
      this.packing = setTimeout(() => this.pack(), PAUSE)
    })
    find('template').onchange = () => {
      const before = this.edited() && this.field.text
      if (before && !confirm(`Replace your code? You find it again under “begin with: ${KEPT}”.`)) find('template').selectedIndex = this.template
      else this.settled = this.fill(before).then(() => { this.clear(); this.pack() })
    }
    find('rival').onchange = () => this.clear()
    find('run-code').onclick = () => this.run()
    find('stop-code').onclick = () => this.stop('Stopped. The next run loads Python again.')
    const megabytes = Object.values(sizes).reduce((sum, size) => sum + size, 0) / 1e6
    this.first = `With your first change or run, your browser loads Python: ${Math.round(megabytes)} MB.`
  }

  // Show a task; `settled`, which others may set too, is what Run waits for. `state` is the page's, `task` its data at
  // this strength. `code` writes the lines that make the task and an agent, and knows an agent's settings, as they are
  // called and by the slots of its kernel.
  async open(race, task, state, code) {
    const other = this.race !== race
    Object.assign(this, { race, task, state, code })
    if (other) {
      const names = race.agents.map(({ label }) => `<option>${label}</option>`).join('')
      this.find('template').innerHTML = `<option>a short one</option>${names}${this.kept ? `<option>${KEPT}</option>` : ''}`
      this.find('rival').innerHTML = names
      this.find('rival').selectedIndex = Math.max(0, race.agents.findIndex(({ noted }) => !noted)) // a table of it can be drawn
    }
    if (!this.edited()) await this.fill() // with the settings of the race as they are now
    await this.take(state.source)
    this.clear()
  }

  // Show the program of a link. It waits for Run.
  async take(packed) {
    if (packed === this.packed) return
    if (this.edited() && !confirm('Replace your code by that of the link?')) return this.onCode(this.packed)
    const text = await unpack(packed)
    this.packed = packed
    this.found = text === undefined ? 'The code in this link is damaged.' : FROM_LINK
    if (text !== undefined) this.field.text = text
  }

  // Tell the page the program as letters of a link: none where it is a template, or too long.
  async pack() {
    clearTimeout(this.packing)
    const packed = this.edited() ? await pack(this.field.text).catch(() => undefined) : ''
    this.tooLong = packed === undefined || packed.length > LONGEST
    this.packed = this.tooLong ? '' : packed
    this.onCode(this.packed)
  }

  edited() {
    return this.field.text !== this.filled
  }

  // Show the chosen template; `before` is the reader's program that it replaces, if any.
  async fill(before) {
    const menu = this.find('template'), own = menu.value === KEPT
    this.template = menu.selectedIndex
    this.found = undefined
    const kept = this.kept
    if (before) {
      if (!kept) menu.append(new Option(KEPT))
      this.kept = before
    }
    if (own) {
      this.field.text = kept
      return
    }
    const agent = this.race.agents[this.template - 1]
    const sources = agent && await (this.sources ??= fetch('data/sources.json').then(answer => answer.json()))
    this.filled = agent ? `${annotated(sources[agent.kind.split('.').at(-1)], this.code.settings(agent))}\n\n${this.code.agent(agent)}` : short_one(this.code.own(this.race.agents[0]))
    this.field.text = this.filled
  }

  clear() {
    if (this.running) this.stop('')
    this.walk?.stop()
    this.done = this.ran = this.failed = undefined
    this.ours = []
    this.theirs = []
    this.looks = {}
    this.unknown(false)
    this.pictures = Object.fromEntries(['ours', 'theirs'].map(id => [id, this.picture(id)]))
    this.walk = new Walk(look => this.pictures.ours.happen(look), this.task.look.length)
    this.print([])
    this.find('code-said').textContent = this.terms()
    this.tell(this.found ?? (this.worker ? 'Change something, and run it.' : this.first))
    this.draw()
  }

  // What both agents meet, and the rival's settings.
  terms() {
    const { race, state, lane } = this, { parameter, values, others } = race.strength, { seed, several } = state
    const task = [`${parameter}=${values[state.strength]}`, ...others].join(', ')
    const seeds = several > 1 ? `${several} seeds from ${seed} on` : `seed ${seed}`
    const settings = Object.entries(this.code.own(lane)).map(([name, value]) => `${SIGNS[name]} = ${value}`).join(', ')
    const vectors = race.measure ? ' Its learn may also take rewards, the vector of rewards.' : ''
    return `Both learn in ${race.name} with ${task}, for ${short(state.steps)} steps, ${seeds}. ${lane.label} has `
      + `${settings ? `${settings}, as in the settings of the race` : 'settings of its own'}. Your code finds the task as mdp; edugym.table_size(mdp) are its numbers of states and actions.${vectors}`
  }

  get student() {
    return this.several.find(([n]) => n === this.state.several)[1]
  }

  // What the rival sees is the task of both.
  get lane() {
    const agent = this.find('rival').selectedIndex, lane = this.task.agents[agent]
    return { ...this.race.agents[agent], plan: lane, table: this.task.tables[lane.table] }
  }

  picture(id) {
    const { race, task, lane } = this, name = id === 'ours' ? 'your agent' : lane.label
    return new Picture(this.find(id), task.scene, lane.table, task.marks, `${race.name}, as ${name} learns it`)
  }

  tell(text) {
    this.find('code-status').textContent = text
  }

  python() {
    if (this.worker) return this.worker
    this.worker = new Worker('own.js', { type: 'module' })
    this.worker.onmessage = ({ data }) => this.receive(data)
    this.worker.onerror = event => this.receive({ kind: 'done', error: event.message || 'Python could not be loaded.', line: null, broken: true })
    this.worker.postMessage({ kind: 'load', sizes: this.sizes })
    return this.worker
  }

  async run() {
    this.find('run-code').disabled = true
    await this.settled?.catch(() => {}) // what is still being arranged would end a run that has begun
    if (this.running) return
    this.found = undefined
    this.clear()
    this.field.mark(null)
    const { steps, seed, several } = this.state, { race, lane } = this, { table } = lane
    const chosen = Array.from({ length: several }, (_, k) => (seed + k) % this.seeds.length)
    this.ran = this.field.text
    this.running = true
    this.find('stop-code').disabled = false
    this.tell('Your agent learns …')
    this.wait()
    this.python().postMessage({ kind: 'run', sizes: this.sizes, source: this.ran, task: this.code.task(lane), steps, seeds: chosen, episodes: race.episodes,
      table, look: this.task.look, measured: race.measure?.code })
    this.rival ??= new Worker('worker.js', { type: 'module' })
    this.rival.onmessage = ({ data }) => {
      if (data.id !== this.number) return
      data.points.forEach((points, k) => (this.theirs[k] ??= []).push(...points))
      this.looks.theirs = data
      this.judge()
      soon(this.curves)
      soon(this.paint.theirs)
    }
    this.rival.postMessage({ kind: 'new', id: ++this.number, kernel: lane.kernel, plan: lane.plan, look: lane.plan.look, table,
      seeds: chosen.map(k => this.seeds[k]), steps, every: Math.max(1, Math.floor(steps / LATE)), settings: this.code.slots(lane), at: 0 })
    this.rival.postMessage({ kind: 'rate', rate: Infinity })
  }

  stop(text) {
    this.worker?.terminate()
    this.worker = undefined
    this.rival?.postMessage({ kind: 'rate', rate: 0 })
    this.end()
    this.tell(text)
  }

  // Say so when nothing comes: a loop of the reader's may never end.
  wait() {
    clearTimeout(this.waiting)
    if (!this.running || !this.loaded) return
    this.waiting = setTimeout(() => this.tell(SILENT), PATIENCE)
  }

  end() {
    this.running = false
    this.wait()
    this.find('run-code').disabled = false
    this.find('stop-code').disabled = true
  }

  receive(data) {
    if (this.find('code-status').textContent === SILENT) this.tell('Your agent learns …')
    this.wait()
    if (data.kind === 'loading' && !this.loaded) {
      this.loaded = data.share === 1
      this.tell(this.loaded ? 'Python starts: some seconds …' : `Python is loading: ${Math.floor(100 * data.share)} %`)
    }
    if (data.kind === 'ready' && !this.running) this.tell('Python is there. Press Run.')
    if (data.kind === 'ready' && this.running) this.tell('Your agent learns …')
    if (data.kind === 'look') {
      this.looks.ours = data.look
      this.walk.take(data.games, data.games.length > 1)
      soon(this.paint.ours)
    }
    if (data.kind === 'seed' && data.k) this.tell(`Your agent learns: ${data.k + 1} of ${data.n} seeds …`)
    if (data.printed) this.print(data.printed)
    if (data.kind !== 'done') return
    if (data.broken) this.stop('') // Python itself has come to an end: the next run loads it again
    this.end()
    if (data.error) {
      this.field.mark(data.line)
      this.failed = true
      this.unknown(!this.looks.ours?.visits.some(Boolean))
      soon(this.curves)
      return this.tell(`${data.line ? `Line ${data.line}. ` : ''}${data.error}`)
    }
    this.ours = data.curves
    this.done = data
    soon(this.curves)
    this.judge()
    if (data.said.length) this.find('code-said').textContent = data.said.join(' ')
  }

  // It has not played: nothing is said of what it does.
  unknown(is) {
    for (const id of ['ours', 'walks']) this.find(id).classList.toggle('unknown', is)
  }

  print(lines) {
    this.find('printed').textContent = lines.join('\n')
    this.find('printed').hidden = !lines.length
  }

  // The reader has changed the program: what is said of a run no longer is of what stands below.
  changed() {
    if (this.running || this.ran === undefined) return
    if (this.done) this.judge()
    else if (this.field.text !== this.ran) this.tell('The code has changed. Press Run.')
  }

  // Say who has won, as soon as both have ended.
  judge() {
    if (!this.done) return
    const { task, state, done, lane, ours, theirs, student, looks } = this
    if (!looks.theirs?.over) return this.tell(`Your agent has ended, ${lane.label} is still learning …`)
    const pace = state.steps * ours.length / done.seconds
    const says = duel({ curves: ours }, { label: lane.label, curves: theirs }, student, task.optimum)
    const told = this.field.text === this.ran ? says : `Before your last changes: i${says.slice(1)}`
    const luck = ours.length > 1 ? '' : ' Was it luck? “Seeds at once” repeats the race with other luck.'
    this.tell(`${told}${luck} Yours took ${done.seconds.toFixed(1)} s: ${short(Number(pace.toPrecision(2)))} steps a second, with evaluation.`)
  }

  // The page has another size.
  measure() {
    for (const picture of Object.values(this.pictures)) picture.measure()
    this.draw()
  }

  draw() {
    for (const part of [this.curves, this.paint.ours, this.paint.theirs]) soon(part)
  }

  curves() {
    const { task, state, race, lane } = this
    chart(this.find('code-chart'), [this.ours, this.theirs], this.student, { steps: state.steps, optimum: task.optimum, names: [this.failed ? '' : 'Your agent', lane.label] }) // who has failed has no line
    const says = race.measure?.says ?? `Points in a game (the mean of ${race.episodes} games without random moves)`
    const { several, seed } = state
    this.find('code-caption').textContent = several > 1 ? `${says}, mean of ${several} seeds with its 95 % interval. The pictures show seed ${seed}` : says
    this.find('rival-name').textContent = lane.label
  }

  knowledge(id) {
    const look = this.looks[id]
    if (look) this.pictures[id].know(look, this.state.show, this.state.policy)
    if (look?.look) this.pictures[id].happen(look.look) // where the rival's training is
  }
}
