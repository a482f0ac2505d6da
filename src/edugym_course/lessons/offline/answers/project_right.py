# %% sums and counts
def my_program(steps, n_states, n_actions, seed):
    shape = n_states, n_actions
    counts = np.zeros(shape)
    for s, a, *_ in steps:
        counts[s, a] += 1
    n = np.maximum(counts, 1)
    lowest = -100.0
    V = np.zeros(n_states)
    for _ in range(30):
        sums = np.zeros(shape)
        for s, a, r, after, terminated in steps:
            sums[s, a] += r if terminated else r + V[after]
        Q = np.where(counts > 0, np.maximum(lowest, sums / n - 2.0 / np.sqrt(n)), lowest)
        V = Q.max(axis=1)
    return lambda state: int(Q[state].argmax())


# %% only what was done often
def my_program(steps, n_states, n_actions, seed):
    targets = {}
    for step in steps:
        targets.setdefault(step[:2], []).append(step[2:])
    seen = {pair: found for pair, found in targets.items() if len(found) >= 2}
    V = [0.0] * n_states
    for _ in range(15):
        Q = [[-1000.0] * n_actions for _ in range(n_states)]
        for (s, a), found in seen.items():
            mean = sum(r + (0 if end else V[after]) for r, after, end in found) / len(found)
            Q[s][a] = mean - 2 / len(found) ** 0.5
        V = [max(row) if max(row) > -1000 else -50.0 for row in Q]
    return lambda state: Q[state].index(max(Q[state]))
