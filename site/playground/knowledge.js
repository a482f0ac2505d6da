// What an agent knows, by the rows of its table: how often it was there, the value of the best action, and this action
// (-1 where several are equally good). `Q` has a number for each row and action; an agent may also have none.
export function knowledge(visits, Q, rows) {
  const values = new Float64Array(rows), greedy = new Int8Array(rows).fill(-1), actions = Q.length / rows
  for (let row = 0; actions && row < rows; row++) {
    let best = -Infinity
    for (let action = 0; action < actions; action++) {
      const value = Q[row * actions + action]
      if (value > best) { best = value; greedy[row] = action } else if (value === best) greedy[row] = -1
    }
    values[row] = best
  }
  return { visits, values, greedy }
}
