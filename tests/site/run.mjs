// Trains an agent in Node as the page does, between others with other seeds in the same memory. Reads a task from standard input, and writes what came of it as JSON.

import { readFileSync } from 'node:fs'
import { performance } from 'node:perf_hooks'

const asked = JSON.parse(readFileSync(0))
const { Room, load } = await import(`${asked.page}/kernel.js`)
const { Learner } = await import(`${asked.page}/learner.js`)
const loaded = await load(readFileSync(asked.file), asked.fingerprint)
const seeds = [...asked.before ?? [], asked.streams, ...asked.behind ?? []]
const room = new Room(loaded, asked.plan, asked.streams.length, seeds.length)
const learners = seeds.map(streams => new Learner(loaded, asked.plan, streams, asked.settings ?? {}, asked, room))
while (!learners[0].over) for (const one of learners) one.advance(asked.chunk ?? one.total)
const learner = learners[seeds.indexOf(asked.streams)]
const { kernel } = learner
if (learner.noted) kernel.call(-2, 0) // SHOW
const hex = bytes => Buffer.from(bytes.buffer, bytes.byteOffset, bytes.byteLength).toString('hex')
const words = new Uint8Array(kernel.memory.buffer, kernel.block + 8 * kernel.results, 8 * (kernel.slots.length - kernel.results))
process.stdout.write(JSON.stringify({
  arrays: kernel.arrays.map(hex),
  generators: kernel.generators.map(place => hex(new Uint8Array(kernel.memory.buffer, place, 48))),
  results: hex(words),
  curve: learner.curve,
  imports: WebAssembly.Module.imports(loaded.module).filter(({ kind }) => kind === 'function').map(({ name }) => name),
}))
