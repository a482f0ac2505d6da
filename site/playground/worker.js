// A worker for one agent: it trains while the page stays free. With several seeds it trains several of its kind.

import { Room, fetched } from './kernel.js'
import { Learner } from './learner.js'

const FRAME = 33 // milliseconds between two pictures
const LANES = 3
// Milliseconds of work at most before it looks at its messages again: all lanes together leave a core to the page.
const BUSY = Math.min(25, FRAME * Math.max(1, navigator.hardwareConcurrency - 1) / LANES)
const SLOW = 20 // up to so many steps a second, the picture shows what the agent would do as things are now
const loading = {}
let task, learners = [], told = 0, rate = 0, pace = Infinity, owed = 0, last = 0, timer, chunk = 100 // steps between two looks at the clock

onmessage = async ({ data }) => {
  try {
    if (data.kind === 'new') await begin(data)
    else if (data.kind === 'rate') change(data.rate)
  } catch (error) {
    postMessage({ kind: 'error', message: error.message })
  }
}

async function begin(asked) {
  clearTimeout(timer)
  rate = told = 0
  task = asked
  learners = []
  const loaded = await (loading[asked.kernel] ??= fetched(asked.kernel))
  if (task !== asked) return // another task came meanwhile
  const room = new Room(loaded, asked.plan, asked.seeds[0].length, asked.seeds.length)
  const begun = asked.seeds.map(streams => new Learner(loaded, asked.plan, streams, asked.settings, asked, room))
  for (const learner of begun) while (learner.steps < Math.min(asked.at, asked.steps)) learner.advance(asked.at - learner.steps)
  learners = begun
  show()
  change(rate)
}

function change(asked) {
  clearTimeout(timer)
  rate = asked
  pace = rate || pace // also while it pauses
  last = performance.now()
  owed = rate ? 1 : 0 // the first step comes at once
  if (rate && learners.length) frame() // or else as soon as the kernel is there
}

function frame() {
  const began = performance.now()
  owed = rate === Infinity ? Infinity : owed + rate * (began - last) / 1000
  last = began
  while (owed >= 1 && !learners[0].over && performance.now() - began < BUSY) {
    const start = performance.now()
    const taken = learners.map(learner => learner.advance(Math.min(chunk, Math.floor(owed))))[0]
    owed -= taken
    chunk = performance.now() - start > 4 ? Math.max(1, chunk >> 1) : Math.min(2 * chunk, 1 << 20)
  }
  if (Number.isFinite(owed)) owed = Math.min(owed, rate) // who cannot keep up does not catch up later
  show()
  if (!learners[0].over) timer = setTimeout(frame, Math.max(0, FRAME - (performance.now() - began)))
}

// Tell the page what there is to see: of the curves, what is new.
function show() {
  const [learner] = learners, { table } = task, { steps, over } = learner
  const { row, look } = learner.moment(task.look, table)
  const known = learner.knowledge(table, pace <= SLOW || !steps ? row : undefined)
  const points = learners.map(({ curve }) => curve.slice(told))
  told = learner.curve.length
  postMessage({ kind: 'look', id: task.id, steps, over, points, look, ...known }, Object.values(known).map(array => array.buffer))
}
