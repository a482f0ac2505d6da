// One agent in the race: its card on the page, and the worker in which it learns.

import { estimate, short, within } from './chart.js'
import { Picture } from './picture.js'
import { soon } from './soon.js'
import { ending } from './verdict.js'

export class Lane {
  constructor(k, { onAgent, onBet, onLook }) {
    this.k = k
    this.onLook = onLook
    this.draw = this.draw.bind(this)
    this.id = 0
    this.article = document.createElement('article')
    this.article.style.setProperty('--lane', `var(--lane-${k})`)
    this.article.innerHTML = `<div class="agent"><span aria-hidden="true"></span><select aria-label="Agent ${k + 1}"></select></div><p class="says"></p><div class="picture"></div>`
      + '<p class="numbers"></p><button class="bet" type="button" aria-pressed="false">Bet on this one</button>'
    const find = selector => this.article.querySelector(selector)
    Object.assign(this, { name: find('.agent span'), select: find('select'), says: find('.says'), place: find('.picture'), numbers: find('.numbers'), bet: find('.bet') })
    this.select.onchange = () => onAgent(k, this.select.selectedIndex)
    this.bet.onclick = () => onBet(k)
    this.worker = new Worker('worker.js', { type: 'module' })
    this.worker.onmessage = ({ data }) => this.receive(data)
  }

  // Begin anew: `race` and `task` are the data of the page, `how` its settings.
  begin(race, task, agent, how) {
    const { label, says, kind, page, kernel } = race.agents[agent], lane = task.agents[agent]
    Object.assign(this, { label, how, look: null, steps: 0, curves: how.seeds.map(() => []), over: false, table: task.tables[lane.table] })
    if (this.race !== race) this.select.innerHTML = race.agents.map(({ label }) => `<option>${label}</option>`).join('')
    this.race = race
    this.select.selectedIndex = agent
    this.name.textContent = label
    this.says.innerHTML = `${says}: ${page ? `<a href="../${page}.html" target="_top">${kind}</a>` : kind}`
    this.numbers.textContent = ''
    this.picture = new Picture(this.place, task.scene, this.table, task.marks, `${race.name}, as ${label} learns it`)
    this.worker.postMessage({ kind: 'new', id: ++this.id, kernel, plan: lane, look: lane.look, table: this.table, ...how, at: how.at[this.k] })
  }

  rate(rate) {
    this.worker.postMessage({ kind: 'rate', rate })
  }

  receive(data) {
    if (data.kind === 'error') this.numbers.textContent = data.message
    if (data.id !== this.id) return
    const fresh = !this.look
    Object.assign(this, { look: data, steps: data.steps, over: data.over })
    data.points.forEach((points, k) => this.curves[k].push(...points))
    soon(this.draw)
    this.onLook(this, fresh)
  }

  draw() {
    const { look, how } = this
    if (!look) return
    this.picture.happen(look.look)
    this.picture.know(look, how.show, how.policy)
    this.numbers.innerHTML = this.told()
  }

  // How it plays now, or at the end in the last tenth of the race; and how it did meanwhile.
  told() {
    const { curves, how, over, race } = this, { greedy, exploring, n } = ending(curves, how.student)
    const now = over ? greedy : estimate(curves.map(curve => curve.at(-1)[1]), how.student)
    if (!this.steps) return `before training: <b>${within(now)}</b>`
    const what = race.measure ? '' : 'points ', when = over ? 'near the end' : `after ${short(this.steps)} steps`
    const some = n < curves.length ? ` (${n} of ${curves.length} seeds)` : ''
    const meanwhile = race.measure ? '' : exploring ? `${within(exploring)} in games of training${some}` : 'no game of training has ended'
    return `${what}<b>${within(now)}</b> ${when}<br>${meanwhile}`
  }
}
