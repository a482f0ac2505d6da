// A kernel: one of EduGym's loops with a task and an agent, compiled ahead of time to WebAssembly.
//
// It is called by one block of slots of 8 bytes. They hold numbers, the addresses of arrays, and those of random
// generators; the kernel itself says, in its section "edugym", which is which. Behind the arguments lie the results.

import { power } from './power.js'

const PAGE = 65536
const STACK = 16 * PAGE // the kernel's own data lie below, its stack grows down from here, and arrays lie above
const TYPES = { float64: Float64Array, int64: BigInt64Array, bool: Uint8Array, float32: Float32Array }
// These come from the browser. In their last digit they may differ from those of another machine.
const { cos, exp, expm1, log, log1p, sin, tanh } = Math
// Remainders and whole powers may not.
const MATHEMATICS = { cos, exp, expm1, log, log1p, pow: power, sin, tanh, fmod: (x, y) => x % y }

// Fetch a kernel by its fingerprint.
export async function fetched(fingerprint) {
  const answer = await fetch(`kernels/${fingerprint}.wasm`)
  if (!answer.ok) throw new Error('This page is older than its kernels: load it again.')
  return load(await answer.arrayBuffer(), fingerprint)
}

// Load a kernel, and refuse it unless it is the very one that was asked for.
export async function load(bytes, fingerprint) {
  const module = await WebAssembly.compile(bytes)
  const [note] = WebAssembly.Module.customSections(module, 'edugym')
  const manifest = note ? JSON.parse(new TextDecoder().decode(note)) : {}
  if (manifest.fingerprint !== fingerprint) throw new Error(`kernel ${fingerprint} is stale: build the page again`)
  return { module, manifest }
}

// Memory for so many kernels of one kind, which are called one after the other: they share the kernel's own data and the
// stack, which is empty between two calls. A browser has room for some hundred memories only, however small they are.
export class Room {
  constructor({ manifest }, plan, nStreams, n = 1) {
    const size = 8 * manifest.slots.length + 64 * nStreams + plan.arrays.reduce((sum, [, length]) => sum + 8 * length + 16, 0)
    this.memory = new WebAssembly.Memory({ initial: Math.ceil((STACK + n * (size + 16)) / PAGE) + 1 })
    this.free = STACK
  }

  take(bytes) {
    const place = this.free
    this.free += (bytes + 15) & ~15
    return place
  }
}

export class Kernel {
  // `plan` says what the slots hold at first, `streams` the states of the random generators of one seed, `settings` has
  // numbers by the ends of the names of slots: { '.discount': 0.9 }, and `room` is where it lies, by itself if none is given.
  constructor(loaded, plan, streams, settings = {}, room = new Room(loaded, plan, streams.length)) {
    const { module, manifest } = loaded
    this.slots = manifest.slots
    this.results = manifest.results
    this.room = room
    this.memory = room.memory
    this.block = this.take(8 * this.slots.length)
    this.arrays = plan.arrays.map(([type, length, fill]) => this.array(type, length, fill))
    this.names = {}
    this.generators = streams.map(words => this.generator(words))
    const view = this.view()
    plan.slots.forEach((content, k) => {
      const [name, kind] = this.slots[k]
      if (kind.startsWith('array')) {
        const array = this.arrays[content.slice(1)]
        this.names[name] = array
        content = array.byteOffset
      } else if (kind === 'generator') content = this.generators[content.slice(1)]
      const changed = Object.keys(settings).find(end => name.endsWith(end))
      this.put(view, k, changed ? settings[changed] : content)
    })
    this.run = new WebAssembly.Instance(module, { env: this.environment(module) }).exports.run
  }

  environment(module) {
    const given = { __linear_memory: this.memory }
    for (const { name, kind } of WebAssembly.Module.imports(module)) {
      if (kind === 'global') given[name] = new WebAssembly.Global({ value: 'i32', mutable: true }, STACK)
      if (kind === 'function') given[name] = MATHEMATICS[name]
    }
    return given
  }

  view() {
    return new DataView(this.memory.buffer)
  }

  take(bytes) {
    return this.room.take(bytes)
  }

  array(type, length, fill) {
    const array = new TYPES[type](this.memory.buffer, this.take(8 * length), length)
    const value = type === 'int64' ? BigInt : Number
    if (fill.length > 1) fill.forEach((number, k) => { array[k] = value(number) })
    else if (fill[0]) array.fill(value(fill[0])) // new memory is 0, and takes no room before it is used
    return array
  }

  // NumPy's PCG64: the address of state and increment, and half a number that may be left from the last draw.
  generator(words) {
    const generator = this.take(16), state = this.take(32), view = this.view()
    view.setUint32(generator, state, true)
    words.forEach((word, k) => view.setBigUint64(state + 8 * k, BigInt('0x' + word), true))
    return generator
  }

  put(view, k, content) {
    const place = this.block + 8 * k
    if (this.slots[k][1] === 'float64') view.setFloat64(place, Number(content), true)
    else view.setBigInt64(place, BigInt(content), true)
  }

  // Call the kernel with the first arguments given, and carry the result over to the next call.
  call(...first) {
    const view = this.view()
    first.forEach((number, k) => this.put(view, k, number))
    if (this.run(this.block)) throw new Error('the kernel has stopped: an index is out of range')
    const words = new BigInt64Array(this.memory.buffer, this.block, this.slots.length)
    const carried = this.slots.length - this.results // the last argument, and the result
    words.copyWithin(this.results - carried, this.results)
  }

  // The k-th number of the result.
  result(k) {
    const place = this.block + 8 * (this.results + k), kind = this.slots[this.results + k][1]
    if (kind === 'float64') return this.view().getFloat64(place, true)
    return kind === 'bool' ? Number(this.view().getUint8(place)) : Number(this.view().getBigInt64(place, true))
  }

  // The number of a result by its name.
  index(name) {
    return this.slots.findIndex(([slot]) => slot === name) - this.results
  }

  // The array whose name has this end, the shortest if there are several; undefined if there is none.
  find(end) {
    const found = Object.keys(this.names).filter(name => name.endsWith(end)).sort((a, b) => a.length - b.length)
    return this.names[found[0]]
  }
}
