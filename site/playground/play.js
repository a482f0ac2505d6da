// Play a task yourself, by keys, mouse or touch; also blind, with no more than an agent sees.

import { short } from './chart.js'
import { Kernel, fetched } from './kernel.js'
import { Picture } from './picture.js'

const BEGIN = -1

export class Play {
  constructor(find) {
    Object.assign(this, { board: find('board'), seen: find('seen'), score: find('score'), actions: find('actions'), record: find('record'), blind: find('blind') })
    find('restart').onclick = () => this.restart()
    addEventListener('keydown', event => this.key(event))
  }

  async open(race, task, streams) {
    this.asked = task
    const loaded = await fetched(race.play)
    if (this.asked !== task) return // another task came meanwhile
    Object.assign(this, { race, task, table: task.tables[task.play.table], returns: [] })
    this.kernel = new Kernel(loaded, task.play, [streams[0]])
    this.picture = new Picture(this.board, task.scene, this.table, [], `${race.name}, as you play it`)
    this.actions.innerHTML = task.actions.map((name, k) => `<button type="button">${name}<kbd>${this.keys(k)}</kbd></button>`).join('')
    this.actions.querySelectorAll('button').forEach((button, k) => { button.onclick = () => this.step(k) })
    this.record.textContent = task.optimum === null ? '' : `The best possible total is ${short(task.optimum)} on average.`
    this.restart()
  }

  keys(k) {
    const arrow = { ArrowLeft: '←', ArrowRight: '→', ArrowUp: '↑', ArrowDown: '↓' }[this.race.keys[k]]
    return [k < 9 ? k + 1 : '', arrow ?? ''].filter(Boolean).join(' or ')
  }

  key(event) {
    if (!this.kernel || this.board.offsetParent === null || event.ctrlKey || event.metaKey || event.altKey) return
    if (/^(INPUT|SELECT)$/.test(event.target.tagName) && event.target.type !== 'checkbox') return
    const action = this.race.keys.includes(event.key) ? this.race.keys.indexOf(event.key) : Number(event.key) - 1
    if (event.key === 'r') this.restart()
    else if (event.key.trim() && action >= 0 && action < this.task.actions.length) this.step(action)
    else return
    event.preventDefault()
  }

  restart() {
    this.kernel.call(BEGIN)
    this.over = false
    this.show('')
  }

  step(action) {
    if (this.over) return
    this.kernel.call(action)
    const [reward, terminated, truncated] = [4, 5, 6].map(k => this.result(k))
    this.over = Boolean(terminated || truncated)
    this.show(`${this.task.actions[action]}: reward ${short(reward)}`)
    if (!this.over) return
    this.returns.push(this.result(3))
    const mean = this.returns.reduce((sum, one) => sum + one, 0) / this.returns.length
    const best = this.task.optimum === null ? '' : `; the best possible is ${short(this.task.optimum)} on average`
    this.record.textContent = `Totals of your games: ${this.returns.slice(-8).map(short).join(', ')}. Mean of ${this.returns.length}: ${short(mean)}${best}.`
  }

  // The k-th part of what `play` in kernels.py returns.
  result(k) {
    return this.kernel.result(this.kernel.index(`result.${k}`))
  }

  show(what) {
    const { kernel, table, race } = this
    this.board.classList.toggle('unseen', this.blind.checked)
    this.picture.happen(this.task.play.look.map(k => kernel.result(k)))
    let row = this.result(1)
    const parts = table.sizes.map((_, k) => k).reverse().map(k => {
      const part = row % table.sizes[k] + table.lows[k]
      row = Math.floor(row / table.sizes[k])
      return `${race.numbers[k] ?? ''} ${part}`.trim()
    })
    this.seen.textContent = `${race.told}: ${parts.reverse().join(', ')}.`
    const end = this.result(5) ? 'The task has ended (terminated). Press R.' : this.over ? 'The step limit has cut it off (truncated). Press R.' : ''
    this.score.innerText = `${what}\nStep ${this.result(2)}, total ${short(this.result(3))}.\n${end}`
  }
}
