// The field in which a reader edits. At first it is plain; with the first change CodeMirror takes its place, which is
// not loaded before. Where it cannot be loaded, the plain one stays.

const MODULES = ['codemirror-commands', 'codemirror-lang-python', 'codemirror-language', 'codemirror-state', 'codemirror-view', 'lezer-highlight']

export class Field {
  // `onEdit` is called when the reader has changed something.
  constructor(box, onEdit) {
    Object.assign(this, { box, onEdit, shown: '', area: box.querySelector('textarea'), gutter: box.querySelector('pre') })
    box.field = this // for tests
    this.area.oninput = () => {
      this.mark(null)
      this.enrich()
      onEdit()
    }
    this.area.oncompositionstart = () => {
      this.still = new Promise(done => this.area.addEventListener('compositionend', done, { once: true }))
    }
    this.area.onkeydown = event => this.indent(event)
    this.area.onscroll = () => { this.gutter.scrollTop = this.area.scrollTop }
  }

  get text() {
    return this.view ? this.view.state.doc.toString() : this.area.value
  }

  set text(text) {
    this.shown = text
    if (this.view) this.renew()
    else this.area.value = text
    this.mark(null)
  }

  // Mark the line with an error, and bring it into sight.
  mark(line) {
    if (this.view) return this.markRich(line)
    const { area, gutter } = this, count = area.value.split('\n').length
    gutter.innerHTML = Array.from({ length: count }, (_, k) => k + 1 === line ? `<b>${k + 1}</b>` : k + 1).join('\n')
    if (line) area.scrollTop = area.scrollHeight * (line - 1) / count - area.clientHeight / 2
    gutter.scrollTop = area.scrollTop
    area.setAttribute('aria-invalid', line !== null)
  }

  // A new line begins where the last one did, and after a colon further in.
  indent(event) {
    if (event.key !== 'Enter' || event.isComposing) return
    const before = this.area.value.slice(0, this.area.selectionStart).split('\n').at(-1)
    const spaces = before.match(/^ */)[0] + (before.trimEnd().endsWith(':') ? '    ' : '')
    event.preventDefault()
    document.execCommand('insertText', false, `\n${spaces}`) // unlike others, it can be undone
  }

  async enrich() {
    if (this.loading) return
    this.loading = Promise.all(MODULES.map(name => import(`./codemirror/${name}.js`)))
    try {
      this.mirror = Object.assign({}, ...await this.loading)
    } catch {
      return
    }
    await this.still
    const { area, box } = this, { value, selectionStart: anchor, selectionEnd: head } = area
    const focused = document.activeElement === area, { scrollTop, scrollLeft } = area
    this.view = new this.mirror.EditorView({ parent: box })
    this.renew()
    area.remove()
    this.gutter.remove()
    box.classList.add('rich')
    this.quiet = true
    this.view.dispatch({ changes: { from: 0, to: this.shown.length, insert: value }, selection: { anchor, head } }) // can be undone
    this.quiet = false
    Object.assign(this.view.scrollDOM, { scrollTop, scrollLeft })
    if (focused) this.view.focus()
  }

  // Begin anew with the text, without a past.
  renew() {
    this.view.setState(this.mirror.EditorState.create({ doc: this.shown, extensions: this.extensions() }))
  }

  extensions() {
    const { EditorState, EditorView, keymap, lineNumbers, gutterLineClass, history, historyKeymap, defaultKeymap, indentWithTab,
      python, indentUnit, bracketMatching, syntaxHighlighting, classHighlighter, GutterMarker, RangeSet, Decoration, StateEffect, StateField } = this.mirror
    const marker = new class extends GutterMarker { elementClass = 'wrong' }()
    const wrong = Decoration.line({ class: 'wrong' })
    this.effect = StateEffect.define()
    const marked = StateField.define({ // where the line with an error begins, if any
      create: () => null,
      update: (place, change) => {
        const told = change.effects.find(effect => effect.is(this.effect))
        return told ? told.value : change.docChanged ? null : place
      },
    })
    return [
      lineNumbers(), history(), python(), indentUnit.of('    '), bracketMatching(), syntaxHighlighting(classHighlighter), marked,
      EditorState.tabSize.of(4),
      keymap.of([indentWithTab, ...defaultKeymap, ...historyKeymap]), // Escape, then Tab, leaves the field, as its label says
      EditorView.decorations.compute([marked], state => state.field(marked) === null ? Decoration.none : Decoration.set(wrong.range(state.field(marked)))),
      gutterLineClass.compute([marked], state => state.field(marked) === null ? RangeSet.empty : RangeSet.of(marker.range(state.field(marked)))),
      EditorView.contentAttributes.compute([marked], state => ({ tabindex: '0', 'aria-label': this.area.ariaLabel, 'aria-invalid': String(state.field(marked) !== null) })),
      EditorView.updateListener.of(update => { if (update.docChanged && !this.quiet) this.onEdit() }),
    ]
  }

  markRich(line) {
    const { view, effect, mirror } = this, { doc } = view.state
    const place = line && line <= doc.lines ? doc.line(line).from : null
    const effects = [effect.of(place)]
    if (place !== null) effects.push(mirror.EditorView.scrollIntoView(place, { y: 'center' }))
    view.dispatch({ effects })
  }
}
