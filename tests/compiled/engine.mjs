// Runs translations in Node.js: one request a line of standard input, one answer a line of standard output.
// The first line says what draws, and where its files are.

import { readFileSync } from 'node:fs'
import { createInterface } from 'node:readline'

const memory = new WebAssembly.Memory({ initial: 512 })
const programs = []
let draw

const text = x => Object.is(x, -0) ? '-0' : String(x)
const answers = {
  async begin({ module, draws, tables }) {
    const { drawing } = await import(module)
    draw = await drawing(readFileSync(draws), tables, memory, Math)
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
}
for await (const line of createInterface({ input: process.stdin })) {
  const asked = JSON.parse(line)
  let answer
  try {
    answer = await answers[asked.kind](asked)
  } catch (error) {
    answer = { error: error.constructor.name, message: error.message }
  }
  process.stdout.write(JSON.stringify(answer) + '\n')
}
