// A worker for a reader's own agent: it loads Python, and runs the reader's program. The page stops it by ending it.
// What the program does runs in Python, checked, and after its first steps as JavaScript where it can be translated.

import { drawing } from './draws.js'
import { knowledge } from './knowledge.js'

const MOST_LINES = 200 // of what the program prints
const OFTEN = 200 // milliseconds between two looks at what it has printed
let printed = [], told = 0
let loading // a promise, since a second message may come meanwhile

onmessage = async ({ data }) => {
  try {
    const python = await (loading ??= load(data.sizes))
    if (data.kind === 'run') {
      printed = []
      postMessage({ kind: 'done', ...runs(python, data), printed })
    } else postMessage({ kind: 'ready' })
  } catch (error) {
    postMessage({ kind: 'done', error: error.message, line: null, broken: true })
  }
}

function print(line) {
  if (printed.length === MOST_LINES) return
  printed.push(printed.length === MOST_LINES - 1 ? '… (the rest is not shown)' : line)
  if (performance.now() - told < OFTEN) return
  told = performance.now()
  postMessage({ kind: 'printed', printed })
}

async function load(sizes) {
  const all = Object.values(sizes).reduce((sum, size) => sum + size, 0)
  let loaded = 0
  const fetched = self.fetch
  self.fetch = async (...asked) => { // tells how much has come
    const answer = await fetched(...asked)
    const counter = new TransformStream({
      transform(chunk, to) {
        loaded += chunk.length
        postMessage({ kind: 'loading', share: Math.min(1, loaded / all) })
        to.enqueue(chunk)
      },
    })
    return new Response(answer.body.pipeThrough(counter), { status: answer.status, headers: answer.headers })
  }
  const memories = [] // one of them is Python's, which Pyodide does not tell
  const { Memory } = WebAssembly
  WebAssembly.Memory = class extends Memory {
    constructor(size) {
      super(size)
      memories.push(this)
    }
  }
  const [packages, draws, tables, { loadPyodide }] = await Promise.all([
    self.fetch('python/packages.zip').then(answer => answer.arrayBuffer()),
    self.fetch('python/draws.wasm').then(answer => answer.arrayBuffer()),
    self.fetch('python/draws.json').then(answer => answer.json()),
    import('./python/pyodide.mjs'),
  ])
  const pyodide = await loadPyodide({ indexURL: new URL('python/', import.meta.url).href })
  pyodide.setStdout({ batched: print })
  WebAssembly.Memory = Memory
  self.fetch = fetched
  postMessage({ kind: 'loading', share: 1 })
  pyodide.unpackArchive(packages, 'zip', { extractDir: '/lib/python3.12/site-packages' })
  const memory = memories.find(({ buffer }) => buffer === pyodide._module.HEAP8.buffer)
  return begun(pyodide, memory, draws, tables)
}

async function begun(pyodide, memory, module, tables) {
  const mathematics = 'acos acosh asin asinh atan atan2 atanh cos cosh exp expm1 hypot log log10 log1p log2 pow sin sinh tan tanh'
  const libm = {}
  for (const name of mathematics.split(' ')) if (pyodide._module[`_${name}`]) libm[name] = pyodide._module[`_${name}`]
  const draw = await drawing(module, tables, memory, libm)
  const make = text => {
    const program = new Function('memory', 'draw', 'libm', text)(() => memory.buffer, draw, libm)
    return numbers => {
      try {
        if (memory.buffer !== pyodide._module.HEAP8.buffer) throw new Error('the memory of Python has moved')
        return Float64Array.from(program(numbers))
      } catch (error) {
        return error.message
      }
    }
  }
  const page = pyodide.pyimport('edugym_page')
  page.javascript.engine = page.Browser(make, pyodide.pyimport('pyodide.ffi').to_js, pyodide.toPy(Object.keys(libm)))
  return page
}

// The same program with each seed anew; the picture is that of the first.
function runs(python, data) {
  const curves = []
  let seconds = 0, said
  for (const [k, seed] of data.seeds.entries()) {
    postMessage({ kind: 'seed', k, n: data.seeds.length })
    const done = run(python, { ...data, seed, seen: !k })
    if (done.error) return done
    curves.push(done.curve)
    seconds += done.seconds
    said ??= done.said
  }
  return { curves, seconds, said }
}

function run(python, { source, task, steps, seed, seen, episodes, table, look, measured }) {
  const show = (visits, Q, games) => { // a program may also make a task of its own, which has no picture here
    if (!seen) return
    const known = visits.length === table.rows ? knowledge(visits.toJs(), Q.toJs(), table) : undefined
    postMessage({ kind: 'look', look: known, games: games.toJs() })
  }
  const told = python.run(source, task, steps, seed, episodes, show, look, table.cell.length, measured)
  const done = told.toJs({ dict_converter: Object.fromEntries })
  told.destroy()
  return done
}
