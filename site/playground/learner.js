// An agent that learns, as `edugym.train` lets it: the same steps, the same evaluations, the same numbers.

import { Kernel } from './kernel.js'
import { knowledge } from './knowledge.js'

const BEGIN = -1, SHOW = -2

export class Learner {
  // `every` is how many steps lie between two points of the curve, and `steps` how many there are in all; `room` is that
  // of its kernel.
  constructor(loaded, plan, streams, settings, { steps, every }, room) {
    this.kernel = new Kernel(loaded, plan, streams, settings, room)
    this.total = steps
    this.every = every
    this.steps = 0
    this.curve = []
    this.kernel.call(BEGIN, 0)
    const { names } = this.kernel
    this.log = { sums: names['training.log.returns'], episodes: names['training.log.episodes'] }
    this.returns = names['evaluation.returns']
    this.visits = this.kernel.find('.visits') // of what counts around the agent, which comes first
    this.noted = names.values // where an agent has no row for a place: see sights.py
    this.values = this.noted ?? this.kernel.find('.Q')
    this.place = this.noted && this.kernel.find('.place')
    this.goal = this.kernel.find('.best_state')
    this.measure()
  }

  get over() {
    return this.steps >= this.total
  }

  // Take `n` training steps at most, up to the next point of the curve; return how many it were.
  advance(n) {
    const taken = Math.min(n, this.every - this.steps % this.every, this.total - this.steps)
    this.kernel.call(taken, 0)
    this.steps += taken
    if (this.steps % this.every === 0 || this.over) this.measure()
    return taken
  }

  // Evaluate the greedy policy, and add a point to the curve: steps, return, and the return while it explored.
  measure() {
    const { returns } = this, { sums, episodes } = this.log
    this.kernel.call(0, returns.length)
    const mean = returns.reduce((sum, one) => sum + one, 0) / returns.length
    this.curve.push([this.steps, mean, episodes[0] ? sums[0] / Number(episodes[0]) : null])
    sums[0] = 0
    episodes[0] = 0n
  }

  // What it knows (see knowledge.js). Go-Explore has a table for every goal: then the one is shown that leads to the
  // best state so far.
  knowledge(table, now) {
    if (this.noted) this.kernel.call(SHOW, 0)
    const { values, goal } = this, size = goal ? values.length / table.rows : values.length, first = goal ? Number(goal[0]) * size : 0
    return knowledge(this.visits, values.subarray(first, first + size), table, now)
  }

  // The row of the table that it observes, and the numbers that decide the picture: a row that remembers more begins
  // again after all observations.
  moment(look, { cell }) {
    const observed = this.kernel.index('result.1'), row = this.place ? Number(this.place[0]) : this.kernel.result(observed)
    return { row, look: look.map(k => k === observed ? row % cell.length : this.kernel.result(k)) }
  }
}
