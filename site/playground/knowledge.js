// What an agent knows, by the cells of the picture, few numbers for a table however large: how often it was there, the
// value of the best action, and this action (-1 where several are equally good). It is the row that was visited most
// which stands for a cell; with `now`, the row that is observed, the one that fits what is now. A cell without a row
// has no value (NaN). `Q` has a number for each row and action; an agent may also have none.
export function knowledge(visits, Q, { rows, cells, cell, layer }, now) {
  const seen = new Float64Array(cells.length), most = new Float64Array(cells.length)
  const standing = new Int32Array(cells.length).fill(-1)
  const past = now === undefined ? -1 : Math.floor(now / cell.length), plane = now === undefined ? -1 : layer[now % cell.length]
  for (let row = 0; row < rows; row++) {
    const count = Number(visits[row]), observed = row % cell.length, k = cell[observed]
    if (!count || k < 0) continue
    seen[k] += count
    const fits = now === undefined || (layer[observed] === plane && (row - observed) / cell.length === past)
    if (fits && count > most[k]) { standing[k] = row; most[k] = count }
  }
  const values = new Float64Array(cells.length).fill(NaN), greedy = new Int8Array(cells.length).fill(-1)
  standing.forEach((row, k) => { if (row >= 0) [values[k], greedy[k]] = best(Q, row, Q.length / rows) })
  return { visits: seen, values, greedy }
}

function best(Q, row, actions) {
  let value = actions ? -Infinity : 0, greedy = -1
  for (let action = 0; action < actions; action++) {
    const one = Q[row * actions + action]
    if (one > value) [value, greedy] = [one, action]
    else if (one === value) greedy = -1
  }
  return [value, greedy]
}
