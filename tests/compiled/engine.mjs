// Runs translations in Node.js: one request a line of standard input, one answer a line of standard output.
// The first line says where the WebAssembly is that draws.

import { readFileSync } from 'node:fs'
import { createInterface } from 'node:readline'

const PAGE = 65536
const memory = new WebAssembly.Memory({ initial: 512 })
const programs = []
let draw

const text = x => Object.is(x, -0) ? '-0' : String(x)
const answers = {
  begin({ draws }) {
    const __stack_pointer = new WebAssembly.Global({ value: 'i32', mutable: true }, PAGE)
    const module = new WebAssembly.Module(readFileSync(draws))
    draw = new WebAssembly.Instance(module, { env: { __linear_memory: memory, __stack_pointer } }).exports
    return {}
  },
  load({ source }) {
    programs.push(new Function('memory', 'draw', 'libm', source)(() => memory.buffer, draw, Math))
    return { program: programs.length - 1 }
  },
  run({ program, numbers, regions }) {
    for (const [place, bytes] of regions) Buffer.from(memory.buffer).set(Buffer.from(bytes, 'base64'), place)
    const result = programs[program](numbers.map(Number)).map(text)
    const after = regions.map(([place, bytes]) =>
      Buffer.from(memory.buffer, place, Buffer.byteLength(bytes, 'base64')).toString('base64'))
    return { result, regions: after }
  },
  time({ program, numbers, regions }) {
    for (const [place, bytes] of regions) Buffer.from(memory.buffer).set(Buffer.from(bytes, 'base64'), place)
    programs[program](numbers.map(Number))
    const began = performance.now()
    programs[program](numbers.map(Number))
    return { milliseconds: performance.now() - began }
  },
}
for await (const line of createInterface({ input: process.stdin })) {
  const asked = JSON.parse(line)
  let answer
  try {
    answer = answers[asked.kind](asked)
  } catch (error) {
    answer = { error: error.constructor.name, message: error.message }
  }
  process.stdout.write(JSON.stringify(answer) + '\n')
}
