// Trains an agent in Node as the page does. Reads a task from standard input, and writes what came of it as JSON.

import { readFileSync } from 'node:fs'
import { performance } from 'node:perf_hooks'

const asked = JSON.parse(readFileSync(0))
const { load } = await import(`${asked.page}/kernel.js`)
const { Learner } = await import(`${asked.page}/learner.js`)
const loaded = await load(readFileSync(asked.file), asked.fingerprint)
const learner = new Learner(loaded, asked.plan, asked.streams, asked.settings ?? {}, asked)
while (!learner.over) learner.advance(asked.chunk ?? learner.total)
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
