// The picture of a task: the environment's own background, what an agent knows, and what happens now.

const LOW = [68, 60, 140], MIDDLE = [33, 145, 140], HIGH = [253, 231, 37] // values, from dark to bright

const SMALLEST = 7 // pixels of a letter that can be read
const TALLEST = 1.6 // heights of a cell: of such a letter what has ink still fits

export class Picture {
  // `scene` and `table` are those of the task (see scenery.py), `marks` the signs of the actions.
  constructor(place, scene, table, marks, label) {
    Object.assign(this, { scene, table, marks })
    const box = `0 0 ${scene.width} ${scene.height}`
    place.innerHTML = `<svg viewBox="${box}" aria-hidden="true"><rect width="100%" height="100%" fill="${scene.colour}"/>`
      + `${scene.background}<g></g></svg><canvas aria-hidden="true"></canvas><svg viewBox="${box}" aria-hidden="true"></svg>`
    place.style.setProperty('--ratio', scene.width / scene.height)
    place.setAttribute('role', 'img')
    place.setAttribute('aria-label', label)
    for (const svg of place.querySelectorAll('svg')) { // as the package's own pictures have it
      svg.setAttribute('stroke-linejoin', 'round')
      svg.setAttribute('stroke-linecap', 'round')
      svg.setAttribute('font-family', 'FreeSans, Helvetica, Arial, sans-serif')
      svg.setAttribute('font-weight', 'bold')
    }
    this.canvas = place.querySelector('canvas')
    this.back = place.querySelector('g:last-child')
    this.front = place.lastElementChild
    this.drawn = ''
  }

  // What happens now, by the numbers that decide the picture.
  happen(look) {
    const { moves, moments, parts, behind } = this.scene
    const key = look.join()
    if (key === this.drawn) return
    this.drawn = key
    if (!moves) {
      const shown = moments[key] ?? []
      this.back.innerHTML = shown.filter(k => k < behind).map(k => parts[k]).join('')
      this.front.innerHTML = shown.filter(k => k >= behind).map(k => parts[k]).join('')
    } else if (moves.kind === 'arm') this.front.innerHTML = arm(moves, ...look)
    else {
      const [x, y] = look, [x0, y0] = moves.start
      this.front.innerHTML = `<g transform="translate(${x - x0} ${y0 - y})">${moves.sprite}</g>`
    }
  }

  // What the agent knows, see knowledge.js; `show` is "visits" or "values".
  know({ visits, values, greedy }, show, policy) {
    const { canvas, scene, table } = this
    if (!this.scale) this.measure()
    if (!this.scale) return // it is hidden
    const { scale } = this, pen = canvas.getContext('2d')
    pen.setTransform(scale, 0, 0, scale, 0, 0)
    pen.clearRect(0, 0, scene.width, scene.height)
    const most = Math.log1p(Math.max(1, ...visits))
    const shown = values.filter(value => !Number.isNaN(value))
    const low = Math.min(...shown), range = Math.max(...shown) - low || 1
    canvas.dataset.cells = shown.length // for tests
    for (const [k, [x, y, w, h]] of table.cells.entries()) {
      if (!visits[k]) continue
      if (show === 'visits') pen.fillStyle = `rgb(118 60 196 / ${0.55 * (Math.log1p(visits[k]) / most) ** 2})`
      else pen.fillStyle = Number.isNaN(values[k]) ? 'transparent' : colour((values[k] - low) / range)
      if (show !== 'nothing') pen.fillRect(x, y, w, h)
      const mark = policy && this.legible(w, h) && greedy[k] >= 0 && this.marks[greedy[k]]
      if (mark) this.sign(pen, mark, x + w / 2, y + h / 2, Math.max(0.85 * Math.min(w, h), this.smallest))
    }
  }

  legible(w, h) {
    return TALLEST * Math.min(w, h) > this.smallest
  }

  // Whether there is room for a sign anywhere.
  readable() {
    if (!this.scale) this.measure()
    return this.table.cells.some(([, , w, h]) => this.legible(w, h))
  }

  // How many of the screen's own pixels a unit of the scene has: to be called again when the page has another size.
  measure() {
    const { canvas, scene } = this
    this.scale = canvas.clientWidth * devicePixelRatio / scene.width
    this.smallest = SMALLEST * devicePixelRatio / this.scale
    canvas.width = Math.round(scene.width * this.scale)
    canvas.height = Math.round(scene.height * this.scale)
  }

  sign(pen, [dx, dy, text], x, y, size) {
    pen.font = `bold ${size}px Helvetica, Arial, sans-serif`
    pen.textAlign = 'center'
    pen.textBaseline = 'middle'
    pen.lineWidth = 0.19 * size
    pen.strokeStyle = 'rgb(255 255 255 / 0.85)'
    pen.fillStyle = '#1d1b26'
    pen.strokeText(text, x + dx, y + dy)
    pen.fillText(text, x + dx, y + dy)
  }
}

function colour(share) {
  const [from, to, part] = share < 0.5 ? [LOW, MIDDLE, 2 * share] : [MIDDLE, HIGH, 2 * share - 1]
  return `rgb(${from.map((c, k) => Math.round(c + part * (to[k] - c))).join(' ')} / 0.72)`
}

// Trashbot's arm by its angles, counterclockwise; y grows downwards in the picture.
function arm({ shoulder, links, box, ground, colours }, angle, bend, holding, outcome) {
  const delivered = outcome === 1
  const [x0, y0] = shoulder, [upper, fore, magnet] = links
  const x1 = x0 + upper * Math.cos(angle), y1 = y0 - upper * Math.sin(angle)
  const x2 = x1 + fore * Math.cos(angle + bend), y2 = y1 - fore * Math.sin(angle + bend)
  const size = box[2], [left, top] = delivered ? [x2 - size / 2, ground - size]
    : holding ? [x2 - size / 2, y2 + magnet] : box
  const path = `points="${x0},${y0} ${x1},${y1} ${x2},${y2}" fill="none"`
  const joints = [[x0, y0, 0.09], [x1, y1, 0.05], [x2, y2, 0.05]].map(([x, y, r]) =>
    `<circle cx="${x}" cy="${y}" r="${r}" fill="${colours.joint}" stroke="${colours.ink}" stroke-width="0.02"/>`)
  return `<rect x="${left}" y="${top}" width="${size}" height="${size}" fill="${colours.box}" stroke="${colours.ink}" stroke-width="0.02"/>`
    + `<polyline ${path} stroke="${colours.ink}" stroke-width="0.12"/><polyline ${path} stroke="${colours.link}" stroke-width="0.09"/>`
    + `<line x1="${x2}" y1="${y2}" x2="${x2}" y2="${y2 + magnet}" stroke="${colours.magnet}" stroke-width="0.06"/>${joints.join('')}`
}
