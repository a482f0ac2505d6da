// The learning curves: mean return over training steps, with the exact optimum, and with several seeds an interval.

const LEFT = 58, RIGHT = 12, TOP = 24, BOTTOM = 26 // pixels around the lines
const DASHES = ['', '9 4', '3 3'] // so that the lines differ without colours, too

// A number in a few characters.
export function short(n) {
  const [size, unit] = Math.abs(n) >= 1e6 ? [1e6, ' M'] : Math.abs(n) >= 1e4 ? [1e3, ' k'] : [1, '']
  return `${+(n / size).toPrecision(4 - unit.length / 2)}${unit}`.replace('-', '−')
}

// The mean of a number over seeds, and half of its interval of 95 %; `t` is Student's for so many seeds.
export function estimate(values, t) {
  const mean = values.reduce((sum, value) => sum + value, 0) / values.length
  const variance = values.reduce((sum, value) => sum + (value - mean) ** 2, 0) / Math.max(1, values.length - 1)
  return [mean, t * Math.sqrt(variance / values.length)]
}

// Such an estimate as text, with two digits of the interval.
export function within([mean, half]) {
  if (!half) return short(mean)
  const digits = Math.max(0, 1 - Math.floor(Math.log10(half)))
  return `${short(Number(mean.toFixed(digits)))} ± ${short(Number(half.toPrecision(2)))}`
}

// Steps, mean and half an interval at each point that all curves have.
export function summary(curves, t) {
  const length = curves.length && Math.min(...curves.map(curve => curve.length))
  return Array.from({ length }, (_, k) => [curves[0][k][0], ...estimate(curves.map(curve => curve[k][1]), t)])
}

// `agents` has for each agent the curves of its seeds. `names` are theirs, '' for one that the key leaves out.
export function chart(place, agents, t, { steps, optimum, names }) {
  if (!place.clientWidth) return // it is hidden
  const lines = agents.map(curves => summary(curves, t)), known = lines.flat()
  // An interval says nothing beyond what a game can bring.
  const seen = agents.flat(2).map(([, value]) => value), least = Math.min(...seen), most = Math.max(...seen, optimum ?? -Infinity)
  const inside = value => Math.min(most, Math.max(least, value))
  const ends = known.map(([, mean]) => mean).sort((a, b) => a - b)
  // How bad it was at the very start is left out where it would press all the rest together.
  let low = Math.min(ends[Math.floor(ends.length / 12)] ?? 0, optimum ?? Infinity), high = Math.max(ends.at(-1) ?? 0, optimum ?? -Infinity)
  if (high - ends[0] < 1.6 * (high - low) || low === high) low = Math.min(low, ends[0] ?? low)
  if (low > 0 && low < 0.3 * high) low = 0
  if (low === high) [low, high] = [low - 1, high + 1]
  const margin = 0.06 * (high - low)
  const key = names.map((name, k) => name && `<span><svg viewBox="0 0 30 8" aria-hidden="true"><path d="M0 4H30" stroke="var(--lane-${k})" stroke-width="3" stroke-dasharray="${DASHES[k]}"/></svg>${name}</span>`)
  if (low - margin > 0) key.push('<i>The scale does not begin at 0.</i>')
  if (ends[0] < low - margin) key.push('<i>Lines go on below the lower edge.</i>')
  if (optimum === null) key.push('<i>Too many states to compute the best possible.</i>')
  place.innerHTML = `<p class="key">${key.join('')}</p><div></div>`
  place = place.lastElementChild
  const { clientWidth: width, clientHeight: height } = place
  const x = step => LEFT + (width - LEFT - RIGHT) * step / steps
  const y = value => TOP + (height - TOP - BOTTOM) * (high + margin - value) / (high - low + 2 * margin)
  const parts = ticks(low, high).map(value => `<path d="M${LEFT} ${y(value)}H${width - RIGHT}" stroke="var(--line)"/>`
    + `<text x="${LEFT - 6}" y="${y(value) + 4}" text-anchor="end">${short(value)}</text>`)
  for (const share of [0, 0.25, 0.5, 0.75, 1]) {
    const anchor = share === 1 ? 'end' : share ? 'middle' : 'start'
    parts.push(`<text x="${x(share * steps)}" y="${height - 7}" text-anchor="${anchor}">${short(share * steps)}</text>`)
  }
  if (optimum !== null) parts.push(`<path d="M${LEFT} ${y(optimum)}H${width - RIGHT}" stroke="var(--optimum)" stroke-width="2" stroke-dasharray="2 5"/>`)
  parts.push(`<clipPath id="inside"><rect x="${LEFT - 2}" width="${width - LEFT - RIGHT + 4}" y="${TOP - 8}" height="${height - TOP - BOTTOM + 8}"/></clipPath><g clip-path="url(#inside)">`)
  lines.forEach((line, k) => {
    const points = sign => line.map(([step, mean, half]) => `${x(step).toFixed(1)},${y(inside(mean + sign * half)).toFixed(1)}`)
    if (line.some(([, , half]) => half)) {
      parts.push(`<polygon points="${[...points(1), ...points(-1).reverse()].join(' ')}" fill="var(--lane-${k})" opacity="0.2"/>`)
    }
    parts.push(`<polyline points="${points(0).join(' ')}" fill="none" stroke="var(--lane-${k})" stroke-width="2.5" stroke-dasharray="${DASHES[k]}" stroke-linejoin="round"/>`)
  })
  parts.push('</g>')
  if (optimum !== null) parts.push(`<text x="${width - RIGHT - 4}" y="${y(optimum) - 6}" text-anchor="end">best possible on average: ${short(optimum)}</text>`)
  place.innerHTML = `<svg viewBox="0 0 ${width} ${height}" role="img" aria-label="Learning curves">${parts.join('')}</svg>`
}

function ticks(low, high) {
  const size = 10 ** Math.floor(Math.log10((high - low) / 2)), step = [1, 2, 5].map(k => k * size).find(k => (high - low) / k <= 5) ?? 10 * size
  const first = Math.ceil(low / step)
  return Array.from({ length: Math.floor(high / step) - first + 1 }, (_, k) => (first + k) * step)
}
