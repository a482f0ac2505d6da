// Powers with whole exponents, rounded correctly, where browsers and C libraries disagree in the last bit. Adam corrects
// its averages by 1 - 0.999^t: from 0.999^16 on it matters.

const SPLIT = 2 ** 27 + 1 // Veltkamp's, which cuts a number into two halves of 26 bits
const SAFE = 2 ** -900 // below it the halves of a product are no longer exact

export function power(x, n) {
  const plain = Math.pow(x, n)
  if (!Number.isInteger(n) || n < 0 || !(Math.abs(plain) > SAFE && Math.abs(plain) < 1 / SAFE)) return plain
  let result = [1, 0]
  for (let square = [x, 0], k = n; k; k = Math.floor(k / 2)) {
    if (k % 2) result = product(result, square)
    if (k > 1) square = product(square, square)
  }
  return result[0]
}

// The product of two numbers of 106 bits, each the sum of two that do not overlap (Dekker, 1971).
function product([a, b], [c, d]) {
  const p = a * c, [a1, a2] = halves(a), [c1, c2] = halves(c)
  const rest = a1 * c1 - p + a1 * c2 + a2 * c1 + a2 * c2 + (a * d + b * c)
  const sum = p + rest
  return [sum, rest - (sum - p)]
}

function halves(a) {
  const shifted = SPLIT * a, high = shifted - (shifted - a)
  return [high, a - high]
}
