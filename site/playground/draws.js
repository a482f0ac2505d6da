// What translated code draws from: NumPy's random streams, where NumPy has them. PCG64 is WebAssembly; normal and
// exponential numbers are NumPy's ziggurats over it, as in numpy/random/src/distributions, with NumPy's tables.

export async function drawing(module, tables, memory, { exp, log1p }) {
  const stack = new WebAssembly.Global({ value: 'i32', mutable: true }, 0) // which drawing does not use
  const { instance } = await WebAssembly.instantiate(module, { env: { __linear_memory: memory, __stack_pointer: stack } })
  const { next_double, next_uint64, bounded } = instance.exports
  const { wi, ki, fi, we, ke, fe, normal_tail, normal_inverse_tail, exponential_tail } = tables

  function normal(stream) {
    for (;;) {
      const bits = next_uint64(stream), low = Number(BigInt.asUintN(32, bits)), high = Number(BigInt.asUintN(32, bits >> 32n))
      const k = low & 255, whole = (high & 0x1fffffff) * 8388608 + (low >>> 9)
      const x = low >>> 8 & 1 ? -(whole * wi[k]) : whole * wi[k]
      if (whole < ki[k]) return x
      if (k) {
        if ((fi[k - 1] - fi[k]) * next_double(stream) + fi[k] < exp(-0.5 * x * x)) return x
        continue
      }
      for (;;) {
        const beyond = -normal_inverse_tail * log1p(-next_double(stream)), height = -log1p(-next_double(stream))
        if (height + height > beyond * beyond) return whole / 256 & 1 ? -(normal_tail + beyond) : normal_tail + beyond
      }
    }
  }

  function exponential(stream) {
    for (;;) {
      const bits = next_uint64(stream), low = Number(BigInt.asUintN(32, bits)), high = Number(BigInt.asUintN(32, bits >> 32n))
      const k = low >>> 3 & 255, whole = high * 2097152 + (low >>> 11), x = whole * we[k]
      if (whole < ke[k]) return x
      if (!k) return exponential_tail - log1p(-next_double(stream))
      if ((fe[k - 1] - fe[k]) * next_double(stream) + fe[k] < exp(-x)) return x
    }
  }

  return { next_double, bounded, normal, exponential }
}
