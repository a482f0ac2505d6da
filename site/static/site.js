// What the pages do by themselves: films can be stopped, what scrolls takes the keyboard, sliders turn pictures, and the survey makes a file or a link.

const calm = matchMedia('(prefers-reduced-motion: reduce)')

// Films. A stopped film shows the picture that it had; where the reader's system asks for less motion, all begin stopped.
const films = [...document.querySelectorAll('article img[src$=".gif"]')]
if (films.length) {
  const button = document.createElement('button')
  button.type = 'button'
  button.className = 'films'
  let stopped = false
  const freeze = film => {
    const still = document.createElement('canvas')
    still.width = film.naturalWidth
    still.height = film.naturalHeight
    still.getContext('2d').drawImage(film, 0, 0)
    film.dataset.film = film.src
    film.src = still.toDataURL()
  }
  const set = stop => {
    stopped = stop
    button.textContent = stop ? 'Start the films' : 'Stop the films'
    for (const film of films) {
      if (!stop) film.src = film.dataset.film ?? film.src
      else if (film.complete && film.naturalWidth) freeze(film)
      else film.addEventListener('load', () => stopped && freeze(film), { once: true })
    }
  }
  button.addEventListener('click', () => set(!stopped))
  const place = films[0].closest('.gallery') ?? films[0].closest('p')
  place.after(button)
  set(calm.matches)
}

// The films of the gallery are large: they are loaded when the first race, which stands before them, is there.
const gallery = document.querySelector('.gallery'), LONGEST = 5000 // milliseconds that they wait
const waiting = gallery && setInterval(() => {
  const race = document.querySelector('iframe.playground').contentDocument
  if (!race?.querySelector('article:last-child .numbers b') && performance.now() < LONGEST) return
  clearInterval(waiting)
  gallery.classList.add('due')
  for (const film of gallery.querySelectorAll('img')) film.loading = 'eager'
}, 50)

// Whoever has no mouse scrolls a wide table, formula or program with the arrow keys.
const scrollable = '.table-wrapper, .highlight pre, .formula, .output, .picture'
const SMALLEST = 0.75 // of a formula that is too wide
const FAR = 1.2 // widths of the screen: of a table that is wider, whole columns are out of sight
const reach = () => {
  for (const box of document.querySelectorAll('.formula')) {
    const formula = box.querySelector('math')
    formula.style.fontSize = ''
    const share = (box.clientWidth - 2) / box.scrollWidth
    if (box.clientWidth && box.scrollWidth > box.clientWidth + 1) formula.style.fontSize = `${1.12 * Math.max(SMALLEST, share)}em`
  }
  for (const box of document.querySelectorAll(scrollable)) {
    if (box.scrollWidth > box.clientWidth + 1) box.tabIndex = 0
    else box.removeAttribute('tabindex')
    box.classList.toggle('far', box.scrollWidth > FAR * box.clientWidth) // see site.css
  }
}
addEventListener('load', reach)
addEventListener('resize', reach)
addEventListener('toggle', reach, true)  // what was folded had no width

// A page to project: a button fills the screen, and keys turn to the next part or back, as a clicker sends them.
const projected = document.querySelector('.projected')
if (projected) {
  const parts = [...document.querySelectorAll('article > section > section + section')] // the first belongs to the title
  // What is longer than the screen is turned over page by page, and at the end what was measured is opened.
  const turn = way => {
    const top = part => Math.round(part.getBoundingClientRect().top), page = 0.9 * innerHeight
    const next = parts.find(part => top(part) > 1), before = parts.findLast(part => top(part) < -1)
    const end = next ? top(next) : document.documentElement.scrollHeight - scrollY
    const fold = document.querySelector('details.measured:not([open])')
    const by = distance => scrollBy({ top: distance, behavior: 'instant' })
    const begin = before ? top(before) : -scrollY, slack = 0.05 * innerHeight
    if (way < 0) by(-begin > innerHeight + slack ? -page : begin)
    else if (end > innerHeight + slack) by(page)
    else if (next) by(end)
    else if (fold) {
      fold.open = true
      fold.scrollIntoView({ behavior: 'instant' })
    }
  }
  const ways = { ArrowRight: 1, PageDown: 1, ArrowLeft: -1, PageUp: -1 }
  addEventListener('keydown', event => {
    if (!ways[event.key] || event.ctrlKey || event.altKey || event.metaKey || event.target.closest('input, button, [tabindex]')) return
    event.preventDefault()
    turn(ways[event.key])
  })
  // Printed tables are as large as their longest line lets them be.
  for (const pre of document.querySelectorAll('article pre')) {
    const longest = Math.max(...pre.textContent.split('\n').map(({ length }) => length))
    pre.style.fontSize = `clamp(.6em, ${140 / longest}vw, .9em)`
  }
  const fill = projected.querySelector('button')
  fill.addEventListener('click', () => {
    fill.blur() // or it takes the keys that turn
    if (document.fullscreenElement) document.exitFullscreen()
    else document.documentElement.requestFullscreen()
  })
}

// A prediction: what was chosen is said there, and again beside what was measured.
for (const box of document.querySelectorAll('fieldset.prediction')) {
  const fold = [...document.querySelectorAll('details.measured')].find(one => box.compareDocumentPosition(one) & Node.DOCUMENT_POSITION_FOLLOWING)
  const says = Object.assign(document.createElement('p'), { className: 'chosen', role: 'status' }), beside = document.createElement('p')
  beside.className = 'chosen'
  box.append(says)
  fold?.querySelector('summary').after(beside)
  box.addEventListener('change', () => {
    const field = box.querySelector('input:checked') ?? box.querySelector('input[type=text]')
    const answer = field?.type === 'radio' ? field.parentElement.textContent.trim() : field?.value
    beside.textContent = `You chose: ${answer}`
    says.textContent = fold ? `You chose: ${answer}. Now open “${fold.querySelector('summary').textContent}” below.` : beside.textContent
  })
}

// Sliders of a lesson, of which one moves at a time. The pictures of its other values are loaded when it is first touched.
for (const book of document.querySelectorAll('.flipbook')) {
  const image = book.querySelector('img')
  const turns = [...book.querySelectorAll('.turn')].map(turn =>
    ({ pictures: JSON.parse(turn.dataset.pictures), slider: turn.querySelector('input'), says: turn.querySelector('output') }))
  const set = ({ pictures, slider, says }, place) => {
    const [value, src, alt] = pictures[place]
    slider.value = place
    says.textContent = value
    slider.setAttribute('aria-valuetext', value)
    return { src, alt }
  }
  for (const turn of turns) {
    const load = () => turn.pictures.forEach(([, file]) => { new Image().src = file })
    for (const touch of ['pointerdown', 'focus']) turn.slider.addEventListener(touch, load, { once: true })
    turn.slider.addEventListener('input', () => {
      for (const other of turns) if (other !== turn) set(other, other.slider.defaultValue)
      Object.assign(image, set(turn, turn.slider.value))
    })
  }
}

// Films of a lesson: step through an episode, or play it once.
const PAUSE = 250 // milliseconds that a frame stays
for (const film of document.querySelectorAll('.film')) {
  const { lines, frames, says } = JSON.parse(film.querySelector('script').textContent)
  const [play, slider, step, picture] = ['button', 'input', 'output', '.picture'].map(name => film.querySelector(name))
  let playing = 0
  const show = frame => {
    slider.value = step.textContent = frame
    slider.setAttribute('aria-valuetext', says[frame])
    picture.setAttribute('aria-label', says[frame])
    picture.innerHTML = frames[frame].flatMap(([first, end]) => lines.slice(first, end)).join('\n')
  }
  const stop = () => {
    clearInterval(playing)
    playing = 0
    play.textContent = 'Play'
  }
  slider.addEventListener('input', () => {
    stop()
    show(Number(slider.value))
  })
  play.addEventListener('click', () => {
    if (playing) return stop()
    play.textContent = 'Stop'
    if (slider.value === slider.max) show(0)
    playing = setInterval(() => {
      show(Number(slider.value) + 1)
      if (slider.value === slider.max) stop()
    }, PAUSE)
  })
}

// On paper nothing can be opened, so what is folded is printed open.
let opened = []
addEventListener('beforeprint', () => {
  opened = [...document.querySelectorAll('article details:not([open])')]
  for (const fold of opened) fold.open = true
})
addEventListener('afterprint', () => {
  for (const fold of opened) fold.open = false
})

// A playground in a page is as high as what it shows, so that nothing scrolls inside.
for (const frame of document.querySelectorAll('iframe.playground')) {
  const fit = () => {
    const inside = frame.contentDocument.body
    new ResizeObserver(() => { frame.style.height = `${inside.offsetHeight + 2}px` }).observe(inside)
    inside.ownerDocument.documentElement.style.overflowY = 'hidden'
  }
  if (frame.contentDocument?.body?.childElementCount) fit() // it was faster than this script
  else frame.addEventListener('load', fit)
}

// The survey. Nothing is sent: the answers are a file, or a link that shows them on this page again.
const survey = document.getElementById('survey')
if (survey) {
  const says = document.getElementById('survey-says')
  for (const [name, value] of new URLSearchParams(location.hash.slice(1))) {
    const field = survey.elements[name]
    if (field) field.value = value
  }
  const answers = () => [...new FormData(survey)].filter(([, value]) => value)
  const isEmpty = () => {
    const empty = answers().every(([name]) => name === 'lesson')
    if (empty) says.textContent = 'There is no answer yet: choose one, or write a remark.'
    return empty
  }
  survey.addEventListener('submit', event => {
    event.preventDefault()
    if (isEmpty()) return
    const statements = Object.fromEntries([...survey.querySelectorAll('fieldset')].map(box =>
      [box.querySelector('input').name, box.querySelector('legend').textContent]))
    const named = answers().map(([name, value]) => [statements[name] ?? name, value])
    const file = document.createElement('a')
    file.href = URL.createObjectURL(new Blob([JSON.stringify(Object.fromEntries(named), null, 2) + '\n'], { type: 'application/json' }))
    file.download = 'edugym-survey.json'
    file.click()
    URL.revokeObjectURL(file.href)
    says.textContent = 'Your browser has saved the file edugym-survey.json. Give it to your teacher if you like.'
  })
  document.getElementById('survey-link').addEventListener('click', () => {
    if (isEmpty()) return
    const link = document.createElement('a')
    link.href = location.href.split('#')[0] + '#' + new URLSearchParams(answers())
    link.textContent = 'This link shows your answers'
    says.replaceChildren(link, '. Copy it, and give it to whom you like.')
  })
}
