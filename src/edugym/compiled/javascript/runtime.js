// What translated code calls: Python's and NumPy's operations, bit for bit. Where JavaScript might come to something
// else, or where Python raises an error, it throws `Doubt`: the interpreter then repeats the call.

class Doubt extends Error {}
const doubt = why => { throw new Doubt(why) }
const MOST = Number.MAX_SAFE_INTEGER

// Whole numbers. They are exact up to 53 bits. Most have 32, and V8 divides these much faster.
const whole = x => x >= -MOST && x <= MOST ? x : doubt('a whole number of more than 53 bits')
const quotient = (a, b) => {
  if (b > 0 && (a | 0) === a && (b | 0) === b) return Math.floor(a / b) + 0
  if (b === 0) doubt('division by zero')
  const rest = whole(a) % whole(b), exact = (a - rest) / b
  return (rest !== 0 && rest < 0 !== b < 0 ? exact - 1 : exact) + 0
}
const remainder = (a, b) => {
  if (b > 0 && (a | 0) === a && (b | 0) === b) {
    const rest = (a | 0) % (b | 0)
    return (rest < 0 ? rest + b : rest) + 0
  }
  if (b === 0) doubt('modulo by zero')
  const rest = whole(a) % whole(b)
  return (rest !== 0 && rest < 0 !== b < 0 ? rest + b : rest) + 0
}
const productModulo = (a, b, m) => {
  const product = a * b
  if (product >= -MOST && product <= MOST) return remainder(product + 0, m)
  if (a < 0 || a >= 4294967296 || b < 0 || b >= 4294967296 || m <= 0 || m > 4294967296) doubt('a product of more than 53 bits')
  const high = Math.floor(b / 65536), low = b % 65536
  return (a * high % m * 65536 + a * low) % m
}
const power = (base, exponent) => {
  if (exponent < 0) doubt('a negative power')
  let result = 1
  for (let left = exponent; ;) {
    if (left % 2) result = whole(result * base + 0)
    left = Math.floor(left / 2)
    if (!left) return result
    base = whole(base * base)
  }
}
const shifted = (a, n) => n < 0 ? doubt('a negative shift') : a === 0 ? 0 : whole(a * power(2, n))
const shiftedBack = (a, n) => n < 0 ? doubt('a negative shift') : n > 53 ? (a < 0 ? -1 : 0) : Math.floor(whole(a) / power(2, n))
const integer = x => (x | 0) === x ? x | 0 : x // V8 takes what comes from an array of reals for a real number
const small = x => (x | 0) === x ? x | 0 : doubt('more than 32 bits')
const both = (a, b) => small(a) & small(b), either = (a, b) => small(a) | small(b), one = (a, b) => small(a) ^ small(b)

// Real numbers.
const finite = x => Number.isFinite(x) ? x : doubt('not a finite number')
const divided = (a, b) => b === 0 ? doubt('division by zero') : a / b
const signed = (size, like) => like < 0 || Object.is(like, -0) ? -size : size
const copysign = (x, like) => like !== like ? doubt('NaN has no sign') : signed(Math.abs(x), like)
const modulo = (a, b) => {
  if (b === 0) doubt('modulo by zero')
  const rest = finite(a) % finite(b)
  return rest !== 0 ? (b < 0 !== rest < 0 ? rest + b : rest) : signed(0, b)
}
const floored = (a, b) => {
  if (b === 0) doubt('division by zero')
  let rest = finite(a) % finite(b), result = (a - rest) / b
  if (rest !== 0 && b < 0 !== rest < 0) result -= 1
  if (result === 0) return signed(0, a / b)
  const below = Math.floor(result)
  return result - below > 0.5 ? below + 1 : below
}
const root = x => x >= 0 ? Math.sqrt(x) : doubt('the root of a negative number')
const truncated = x => whole(Math.trunc(x)) + 0
const rounded = x => {
  const below = Math.floor(whole(x)), rest = x - below
  return (rest > 0.5 || (rest === 0.5 && below % 2 !== 0) ? below + 1 : below) + 0
}
const finiteOf = x => Number.isFinite(x) ? x : doubt('an infinite result')

// A number that may be whole or real: results that differ between the two are in doubt.
const mixed = x => x >= -MOST && x <= MOST && !Object.is(x, -0) ? x : doubt('a large number, or -0, that may be whole')

const sameReal = (a, b) => a === b || (a !== a && b !== b && doubt('NaN in tuples that are compared'))

// Numbers of both kinds.
const larger = (a, b) => b > a ? b : a
const smaller = (a, b) => b < a ? b : a
const clipped = (x, low, high) => x !== x ? x : low !== low ? low : high !== high ? high : smaller(larger(x, low), high)

// Arrays: `data` from `offset`, with `strides` in elements. Whole numbers of 64 bits are two of 32. An array of one axis
// has `length` and `stride` alone, so that a row of a table costs one small object.
const out = (i, n) => doubt(`index ${i} is out of bounds for size ${n}`)
const fromEnd = (i, n) => i < 0 && i >= -n ? i + n : out(i, n)
const at = (i, n) => i >>> 0 === i && i < n ? i : fromEnd(i, n)
const views = buffer => ({ reals: new Float64Array(buffer), halves: new Int32Array(buffer), bytes: new Uint8Array(buffer) })
const steps = shape => shape.map((_, axis) => shape.slice(axis + 1).reduce((a, b) => a * b, 1))
class Strided {
  constructor(data, offset, length, stride, axes, apart) {
    this.data = data
    this.offset = offset
    this.length = length
    this.stride = stride
    this.axes = axes
    this.apart = apart
  }
  static of(data, offset, shape, strides) {
    const line = shape.length === 1
    return new this(data, offset, shape[0], strides[0], line ? null : shape, line ? null : strides)
  }
  get shape() { return this.axes ?? [this.length] }
  get strides() { return this.apart ?? [this.stride] }
  get size() { return this.axes === null ? this.length : this.axes.reduce((a, b) => a * b, 1) }
  at3(i, j, k) { return this.part(i).at2(j, k) }
  put3(i, j, k, value) { this.part(i).put2(j, k, value) }
  // The part that numbers and slices [begin, end, step] pick, one for each of the first axes.
  part(...picked) {
    let { offset } = this
    const shape = [], strides = [], { shape: all, strides: paces } = this
    picked.forEach((one, axis) => {
      const n = all[axis], stride = paces[axis]
      if (typeof one === 'number') {
        offset += at(one, n) * stride
        return
      }
      const step = one[2] ?? 1, back = step < 0
      if (step === 0) doubt('a slice of step 0')
      const bound = (i, last) => i === null ? last : i < 0 ? Math.max(i + n, back ? -1 : 0) : Math.min(i, back ? n - 1 : n)
      const begin = bound(one[0], back ? n - 1 : 0), end = bound(one[1], back ? -1 : n)
      shape.push(Math.max(0, Math.ceil((end - begin) / step)))
      strides.push(stride * step)
      offset += begin * stride
    })
    const rest = picked.length
    return this.constructor.of(this.data, offset, [...shape, ...all.slice(rest)], [...strides, ...paces.slice(rest)])
  }
  // Its elements in order.
  *places(axis = 0, offset = this.offset) {
    if (axis === this.shape.length) yield offset
    else for (let i = 0; i < this.shape[axis]; i++) yield* this.places(axis + 1, offset + i * this.strides[axis])
  }
  flat() {
    const list = []
    if (this.axes === null) for (let i = 0; i < this.length; i++) list.push(this.get(this.offset + i * this.stride))
    else for (const place of this.places()) list.push(this.get(place))
    return list
  }
  fill(values) {
    let k = 0
    for (const place of this.places()) this.set(place, values[k++])
  }
}
// The methods of each class are written out, since V8 is quick only with those that meet one class.
class Real extends Strided {
  static data(n) { return new Float64Array(n) }
  get(place) { return this.data[place] }
  set(place, value) { this.data[place] = value }
  at1(i) { return this.data[this.offset + at(i, this.length) * this.stride] }
  at2(i, j) { return this.data[this.offset + at(i, this.length) * this.stride + at(j, this.axes[1]) * this.apart[1]] }
  put1(i, value) { this.data[this.offset + at(i, this.length) * this.stride] = value }
  put2(i, j, value) { this.data[this.offset + at(i, this.length) * this.stride + at(j, this.axes[1]) * this.apart[1]] = value }
}
const whole64 = (halves, place) => { // most have 32 bits, and stay integers to V8
  const low = halves[2 * place], high = halves[2 * place + 1]
  return high === low >> 31 ? low : whole(high * 4294967296 + (low >>> 0))
}
const put64 = (halves, place, value) => {
  halves[2 * place] = value
  halves[2 * place + 1] = (value | 0) === value ? value >> 31 : Math.floor(value / 4294967296)
}
const add64 = (halves, place, n) => {
  const low = halves[2 * place], sum = low + n
  if (halves[2 * place + 1] === low >> 31 && (sum | 0) === sum) {
    halves[2 * place] = sum
    halves[2 * place + 1] = sum >> 31
  } else put64(halves, place, whole(whole64(halves, place) + n))
}
class Whole extends Strided {
  static data(n) { return new Int32Array(2 * n) }
  get(place) { return whole64(this.data, place) }
  set(place, value) { put64(this.data, place, value) }
  at1(i) { return whole64(this.data, this.offset + at(i, this.length) * this.stride) }
  at2(i, j) { return whole64(this.data, this.offset + at(i, this.length) * this.stride + at(j, this.axes[1]) * this.apart[1]) }
  put1(i, value) { put64(this.data, this.offset + at(i, this.length) * this.stride, value) }
  put2(i, j, value) { put64(this.data, this.offset + at(i, this.length) * this.stride + at(j, this.axes[1]) * this.apart[1], value) }
}
class Flags extends Strided {
  static data(n) { return new Uint8Array(n) }
  get(place) { return this.data[place] !== 0 }
  set(place, value) { this.data[place] = value }
  at1(i) { return this.data[this.offset + at(i, this.length) * this.stride] !== 0 }
  at2(i, j) { return this.data[this.offset + at(i, this.length) * this.stride + at(j, this.axes[1]) * this.apart[1]] !== 0 }
  put1(i, value) { this.data[this.offset + at(i, this.length) * this.stride] = value }
  put2(i, j, value) { this.data[this.offset + at(i, this.length) * this.stride + at(j, this.axes[1]) * this.apart[1]] = value }
}
// A new array of zeros. Small ones share their data, since it takes longer to make data than to fill them.
const SHARED = 1024
const refill = kind => kind.pool = { data: kind.data(SHARED), used: 0 }
for (const kind of [Real, Whole, Flags]) refill(kind)
const room = (kind, n) => {
  const offset = kind.pool.used
  if (offset + n > SHARED) return n > SHARED ? new kind(kind.data(n), 0, n, 1, null, null) : (refill(kind), room(kind, n))
  kind.pool.used += n
  return new kind(kind.pool.data, offset, n, 1, null, null)
}
const made = (kind, shape, values) => {
  if (shape.some(n => n < 0)) doubt('a negative dimension')
  const size = shape.reduce((a, b) => a * b, 1), line = room(kind, size)
  const array = shape.length === 1 ? line : kind.of(line.data, line.offset, shape, steps(shape))
  if (values) for (let k = 0; k < size; k++) line.set(line.offset + k, values[k])
  return array
}
const filled = (kind, shape, value) => made(kind, shape, new Array(shape.reduce((a, b) => a * b, 1)).fill(value))
const numbered = n => made(Whole, [Math.max(0, n)], Array.from({ length: Math.max(0, n) }, (_, k) => k))
const broadcast = (a, b) => {
  const n = Math.max(a.length, b.length), shape = []
  for (let k = 1; k <= n; k++) {
    const one = a[a.length - k] ?? 1, other = b[b.length - k] ?? 1
    if (one !== other && one !== 1 && other !== 1) doubt('arrays of other shapes')
    shape.unshift(one === 1 ? other : one)
  }
  return shape
}
const spread = (a, shape) => {
  if (!(a instanceof Strided)) return new Array(shape.reduce((x, y) => x * y, 1)).fill(a)
  const extra = shape.length - a.shape.length
  const strides = shape.map((n, axis) => axis < extra || (a.shape[axis - extra] === 1 && n !== 1) ? 0 : a.strides[axis - extra])
  return a.constructor.of(a.data, a.offset, shape, strides).flat()
}
const shapeOf = a => a instanceof Strided ? a.shape : []
const paired = (kind, operation, a, b) => {
  if (!(a instanceof Strided) || b instanceof Strided || a.axes !== null) return spreadPairs(kind, operation, a, b)
  const array = room(kind, a.length) // as in Q[state] == highest
  for (let k = 0; k < a.length; k++) array.set(array.offset + k, operation(a.get(a.offset + k * a.stride), b))
  return array
}
const spreadPairs = (kind, operation, a, b) => {
  const shape = broadcast(shapeOf(a), shapeOf(b)), first = spread(a, shape), second = spread(b, shape)
  return made(kind, shape, first.map((x, k) => operation(x, second[k])))
}
const mapped = (kind, operation, a) => made(kind, [...a.shape], a.flat().map(x => operation(x)))
// Assigns an array or a number to all of an array. Where they overlap, all is read before anything is written.
const assign = (array, value) => {
  const shape = broadcast(array.shape, shapeOf(value))
  if (shape.length !== array.shape.length || shape.some((n, k) => n !== array.shape[k])) doubt('an array of another shape')
  array.fill(spread(value, shape))
}
const copied = (kind, a) => made(kind, [...a.shape], a.flat())

// Reductions of lists of numbers.
const extreme = (list, better) => {
  if (!list.length) doubt('the largest of nothing')
  let found = list[0]
  for (const x of list) {
    if (x !== x) return x
    if (better(x, found)) found = x
  }
  return found === 0 ? zeroOf(list) : found
}
// Which of 0 and -0 NumPy takes for the largest is the processor's business.
const zeroOf = list => {
  const zeros = list.filter(x => x === 0)
  return zeros.every(x => Object.is(x, zeros[0])) ? zeros[0] : doubt('0 and -0')
}
const greater = (a, b) => a > b, less = (a, b) => a < b
const largestOf = (data, offset, length, stride) => {
  if (!length) doubt('the largest of nothing')
  let found = data[offset]
  for (let k = 0, place = offset; k < length; k++, place += stride) {
    const x = data[place]
    if (x !== x) return x
    if (x > found) found = x
    else if (x === 0 && found === 0 && !Object.is(x, found)) doubt('0 and -0')
  }
  return found
}
const largest = a => a.axes === null && a instanceof Real ? largestOf(a.data, a.offset, a.length, a.stride) : extreme(a.flat(), greater)
const smallest = a => extreme(a.flat(), less)
const place = (list, better) => {
  if (!list.length) doubt('argmax of nothing')
  let found = 0
  for (let k = 0; k < list.length; k++) {
    if (list[k] !== list[k]) return k
    if (better(list[k], list[found])) found = k
  }
  return found
}
const placeOfLargestOf = (data, offset, length, stride) => {
  if (!length) doubt('argmax of nothing')
  let best = 0, found = data[offset]
  for (let k = 0, place = offset; k < length; k++, place += stride) {
    const x = data[place]
    if (x !== x) return k
    if (x > found) {
      found = x
      best = k
    }
  }
  return best
}
const placeOfLargest = a => a.axes === null && a instanceof Real ? placeOfLargestOf(a.data, a.offset, a.length, a.stride) : place(a.flat(), greater)
const placeOfSmallest = a => place(a.flat(), less)
const listExtreme = (list, better) => {
  if (!list.length) doubt('the largest of nothing')
  return list.reduce((found, x) => better(x, found) ? x : found)
}
// NumPy's order of additions.
const pairwise = (list, from, n) => {
  if (n < 8) {
    let sum = -0
    for (let k = 0; k < n; k++) sum += list[from + k]
    return sum
  }
  if (n <= 128) {
    const r = list.slice(from, from + 8)
    let k = 8
    for (; k < n - n % 8; k += 8) for (let j = 0; j < 8; j++) r[j] += list[from + k + j]
    let sum = ((r[0] + r[1]) + (r[2] + r[3])) + ((r[4] + r[5]) + (r[6] + r[7]))
    for (; k < n; k++) sum += list[from + k]
    return sum
  }
  const half = Math.floor(n / 2) - Math.floor(n / 2) % 8
  return pairwise(list, from, half) + pairwise(list, from + half, n - half)
}
const sumOfReals = a => {
  let expected = 1 // in memory in the order of the elements: otherwise NumPy adds in another order
  for (let axis = a.shape.length - 1; axis >= 0; axis--) {
    if (a.shape.length > 1 && a.shape[axis] !== 1 && a.strides[axis] !== expected) doubt('the sum of a part of a table')
    expected *= a.shape[axis]
  }
  const list = a.flat()
  if (!list.length) return 0
  return pairwise(list, 0, list.length)
}
const meanOf = a => divided(sumOfReals(a), a.size)
const sumOfWholes = list => list.reduce((sum, x) => whole(sum + x), 0)
const sumInTurn = (list, checked = x => x) =>
  list.length ? list.reduce((sum, x) => checked(sum + x), 0) : doubt('the sum of no real numbers')
// From Python 3.12 on `sum` keeps what rounding loses, but not for numbers of NumPy's.
const sumInDoubt = list => {
  let sum = 0, lost = 0
  for (const x of list) {
    const next = sum + x
    lost += Math.abs(sum) >= Math.abs(x) ? (sum - next) + x : (x - next) + sum
    sum = next
  }
  return list.length && sum + lost === sum ? sum : doubt('a sum whose last digit is in doubt')
}
const holds = x => x !== 0 && x !== false // NaN does
// The places that searches find, one after the other: the writer writes each search.
let places = Whole.data(SHARED), taken = 0
const search = most => {
  if (taken + most > SHARED) {
    places = Whole.data(Math.max(most, SHARED))
    taken = 0
  }
  return taken
}
const found = (begin, end) => {
  taken = end
  return new Whole(places, begin, end - begin, 1, null, null)
}
const whereNotZero = a => {
  const list = a.flat(), begin = search(list.length)
  let n = begin
  for (let k = 0; k < list.length; k++) if (holds(list[k])) places[2 * n++] = k
  return found(begin, n)
}
const countOf = list => list.reduce((sum, x) => sum + (x ? 1 : 0), 0)
const median = list => {
  const n = list.length, sorted = Float64Array.from(list).sort()
  if (!n) doubt('the median of nothing')
  if (list.some(x => x !== x)) return NaN
  const found = n % 2 ? sorted[(n - 1) / 2] : (sorted[n / 2 - 1] + sorted[n / 2]) / 2
  return found === 0 && list.some(x => Object.is(x, -0)) ? doubt('0 and -0') : found
}
const ordered = list => {
  if (list.some(x => x !== x)) doubt('NaN in what is sorted')
  return [...list].sort((a, b) => a < b ? -1 : a > b ? 1 : 0) // stable, as Python's: 0 and -0 stay in order
}

// Lists.
const item = (list, i) => list[at(i, list.length)]
const putItem = (list, i, value) => { list[at(i, list.length)] = value }
const popped = list => list.length ? list.pop() : doubt('pop from an empty list')
const repeated = (list, n) => Array.from({ length: Math.max(0, n) * list.length }, (_, k) => list[k % list.length])
const listSlice = (list, begin, end, step) => {
  const view = new Real(null, 0, list.length, 1, null, null).part([begin, end, step])
  return Array.from({ length: view.length }, (_, k) => list[view.offset + k * view.stride])
}
const differsFromAll = (list, x) => list.every(y => y !== x)

// Draws, from NumPy's own state: `draw` is WebAssembly that works on it.
const bounded = (state, low, high) => {
  const last = whole(high - low) - 1
  if (last < 0) doubt('low >= high')
  if (last === 0) return low
  if (last >= 4294967295) doubt('a draw of more than 32 bits')
  return low + (draw.bounded(state, last | 0) >>> 0)
}
const uniform = (state, low, high) => {
  const range = high - low
  if (!(range >= 0 && range < Infinity)) doubt('high - low < 0')
  return low + range * draw.next_double(state)
}
const scaled = scale => scale > 0 || Object.is(scale, 0) ? scale : doubt('scale < 0')
const normal = (state, loc, scale) => loc + scaled(scale) * draw.normal(state)
const exponential = (state, scale) => scaled(scale) * draw.exponential(state)
const weighted = (state, n, p) => {
  if (p.length !== n) doubt('a and p must have the same size')
  let total = 0
  for (const one of p) {
    if (!(one >= 0)) doubt('probabilities must not be negative')
    total += one
  }
  if (!(Math.abs(total - 1) <= 1e-8)) doubt('probabilities must sum to 1')
  // as NumPy: the sums so far, divided by the last of them, and where in them the draw would stand
  let sum = 0
  const sums = p.map((x, k) => sum = k ? sum + x : x), drawn = draw.next_double(state)
  let k = 0
  while (k < n && sums[k] / sum <= drawn) k++
  return k < n ? k : doubt('no draw')
}
