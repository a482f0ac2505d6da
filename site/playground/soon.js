// Work for the screen, one piece a frame: so no task on the main thread is long.

const waiting = new Set()

// Call `draw` in one of the next frames, once however often it was asked for.
export function soon(draw) {
  if (!waiting.size) requestAnimationFrame(next)
  waiting.add(draw)
}

function next() {
  const [draw] = waiting
  waiting.delete(draw)
  if (waiting.size) requestAnimationFrame(next)
  draw()
}
