// Play a task yourself, by keys, mouse or touch; also blind, with no more than an agent sees.

import { short } from './chart.js'
import { Kernel, fetched } from './kernel.js'
import { Picture } from './picture.js'

const BEGIN = -1

export class Play {
  constructor(find) {
    Object.assign(this, { board: find('board'), seen: find('seen'), score: find('score'), actions: find('actions'), record: find('record'), blind: find('blind'), blindWhy: find('blind-why'), again: find('restart') })
    this.again.onclick = () => this.restart()
    addEventListener('keydown', event => this.key(event))
  }

  async open(race, task, streams) {
    if (this.task === task) return // only the tab was left: the game and its points stay
    this.asked = task
    const loaded = await fetched(race.play)
    if (this.asked !== task) return // another task came meanwhile
    Object.assign(this, { race, task, table: task.tables[task.play.table], returns: [] })
    this.kernel = new Kernel(loaded, task.play, [streams[0]])
    this.picture = new Picture(this.board, task.scene, this.table, [], `${race.name}, as you play it`)
    this.actions.innerHTML = task.actions.map(() => '<button type="button"><span></span><kbd></kbd></button>').join('')
    this.buttons = [...this.actions.children]
    this.buttons.forEach((button, k) => {
      button.onclick = () => this.step(k)
      button.lastElementChild.textContent = this.keys(k)
    })
    this.record.textContent = `${this.best()} ${this.others()}`
    this.restart()
  }

  // What there is to compare with.
  best() {
    return this.task.optimum === null ? '' : `The best possible is ${points(this.task.optimum)} on average.`
  }

  others() {
    const told = mean => Number(Math.abs(mean) >= 10 ? mean.toPrecision(2) : Math.abs(mean) >= 0.1 ? mean.toFixed(2) : mean.toPrecision(1))
    const gets = mean => mean && Math.abs(mean) < 1e-6 ? 'hardly ever a point' : `about ${points(told(mean))}`
    return this.task.others.map(([what, mean]) => `Somebody who ${what} gets ${gets(mean)}.`).join(' ')
  }

  // The digit of each action: that of its name, where it has one, else 1, 2, ...
  digits() {
    return this.task.actions.map((name, k) => k < 10 ? String((name.match(/ (\d+)$/)?.[1] ?? k + 1) % 10) : '')
  }

  keys(k) {
    const arrow = { ArrowLeft: '←', ArrowRight: '→', ArrowUp: '↑', ArrowDown: '↓' }[this.race.keys[k]]
    return [this.digits()[k], arrow ?? ''].filter(part => part !== '').join(' or ')
  }

  // What the actions are called here; '' for what is of no use.
  names() {
    const { buttons } = this.task
    return buttons[buttons.length > 1 ? this.result(1) : 0]
  }

  key(event) {
    if (!this.kernel || this.board.offsetParent === null || event.ctrlKey || event.metaKey || event.altKey) return
    if (/^(INPUT|SELECT)$/.test(event.target.tagName) && event.target.type !== 'checkbox') return
    const action = this.race.keys.includes(event.key) ? this.race.keys.indexOf(event.key) : this.digits().indexOf(event.key)
    if (event.key === 'r') this.restart()
    else if (action >= 0) this.step(action)
    else return
    event.preventDefault()
  }

  restart() {
    this.kernel.call(BEGIN)
    this.over = false
    this.show('')
  }

  step(action) {
    const name = this.names()[action]
    if (this.over || !name) return
    const before = this.result(1)
    this.kernel.call(action)
    const came = this.race.outcomes[Number(this.result(1) <= before)]
    const [reward, terminated, truncated] = [4, 5, 6].map(k => this.result(k))
    this.over = Boolean(terminated || truncated)
    this.show(`${name}: ${came ? `${came}, ` : ''}${points(reward)}`)
    if (!this.over) return
    this.returns.push(this.result(3))
    const mean = this.returns.reduce((sum, one) => sum + one, 0) / this.returns.length
    this.record.textContent = `Points in your games: ${this.returns.slice(-8).map(short).join(', ')}. On average ${short(mean)}. ${this.best()} ${this.others()}`
  }

  // How the game has ended.
  ending() {
    const total = this.result(3), { optimum } = this.task
    const end = this.result(5) ? 'It is over' : 'It is over: there are no steps left'
    if (optimum === null) return `${end}. You have ${points(total)}.`
    if (Math.abs(total - optimum) < 1e-9) return `You made it! You have ${points(total)}, the best possible.`
    if (total > optimum) return `You made it! You have ${points(total)}, more than the best player gets on average: you had luck, too.`
    return `${end}. You have ${points(total)}; the best possible is ${short(optimum)} on average.`
  }

  // The k-th part of what `play` in kernels.py returns.
  result(k) {
    return this.kernel.result(this.kernel.index(`result.${k}`))
  }

  show(what) {
    const { kernel, table, race, task: { codes } } = this, names = this.names()
    this.buttons.forEach((button, k) => {
      button.disabled = this.over
      if (this.over) return // nothing moves under the finger
      button.firstElementChild.textContent = names[k]
      button.hidden = !names[k]
    })
    this.board.classList.toggle('unseen', this.blind.checked && !this.over)
    this.picture.happen(this.task.play.look.map(k => kernel.result(k)))
    let row = this.result(1)
    const parts = table.sizes.map((_, k) => k).reverse().map(k => {
      const part = row % table.sizes[k] + table.lows[k]
      row = Math.floor(row / table.sizes[k])
      return `${race.numbers[k] ?? ''} ${codes[race.numbers[k]]?.[part] ?? part}`.trim()
    })
    this.board.dataset.seen = parts.reverse().join('\n')
    this.seen.textContent = `${race.told}: ${parts.join(', ')}.`
    const letters = Object.keys(codes).length ? ' The letters stand for numbers that are only names.' : ''
    this.blindWhy.textContent = this.blind.checked
      ? `${race.numbers.length ? 'The name before a number is only for you. ' : ''}Nobody tells the agent what its numbers mean: it has only them and the points to learn from.${letters}`
      : `Why play blind? Then you meet the game as the agent does: without a picture, you find out from your points alone what helps.${letters}`
    this.score.innerText = `${what}\nStep ${this.result(2)}${this.task.limit === null ? '' : ` of at most ${this.task.limit}`}, ${points(this.result(3))} so far.\n${this.over ? this.ending() : ''}`
    this.again.classList.toggle('due', this.over)
    this.again.firstChild.data = this.over ? 'Play again' : 'Start again'
  }
}

function points(n) {
  return `${short(n)} point${Math.abs(n) === 1 ? '' : 's'}`
}
