// Games in a picture, step by step, at walking pace.

const PACE = 120 // milliseconds a step
const REST = 8 // steps that it rests at the end of a game
const CALM = matchMedia('(prefers-reduced-motion: reduce)')

export class Walk {
  // `show` is told the numbers that decide the picture, `size` of them.
  constructor(show, size) {
    Object.assign(this, { show, size, games: [], moment: 0 })
  }

  // Show these games, each the numbers of all its moments: at once, or when the game that is shown now has ended.
  take(games, atOnce) {
    if (!this.timer || atOnce) this.begin(games)
    else this.next = games
  }

  begin(games) {
    this.stop()
    this.games = games.filter(({ length }) => length)
    if (this.games.length) this.step()
  }

  step() {
    const { size, games: [game] } = this, last = game.length / size - 1
    if (CALM.matches) this.moment = Math.max(this.moment, last) // only how it ends
    const at = size * Math.min(this.moment, last)
    this.show(game.subarray(at, at + size))
    this.moment++
    if (this.moment <= last + REST) this.timer = setTimeout(() => this.step(), PACE)
    else if (this.next || this.games.length > 1) this.begin(this.next ?? this.games.slice(1))
    else this.stop()
  }

  stop() {
    clearTimeout(this.timer)
    this.timer = this.next = undefined
    this.moment = 0
  }
}
