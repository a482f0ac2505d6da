// Calls a kernel in Node once, and writes its last array. Reads what to call from standard input.

import { readFileSync } from 'node:fs'

const { page, file, fingerprint, plan, streams } = JSON.parse(readFileSync(0))
const { load, Kernel } = await import(`${page}/kernel.js`)
const kernel = new Kernel(await load(readFileSync(file), fingerprint), plan, streams)
kernel.call()
process.stdout.write(JSON.stringify([...kernel.arrays.at(-1)].map(String)))
