# %% lists of targets
# says: Right: every target at once, from the old table, and less for what is hardly known.
def pessimistic_sweep(steps, Q, penalty, lowest):
    targets = {}
    for state, action, reward, next_state, terminated in steps:
        target = reward if terminated else reward + Q[next_state].max()
        targets.setdefault((state, action), []).append(target)
    new = np.full(Q.shape, float(lowest))
    for pair, values in targets.items():
        new[pair] = max(lowest, np.mean(values) - penalty / np.sqrt(len(values)))
    return new


# %% sums and counts
def pessimistic_sweep(steps, Q, penalty, lowest):
    sums, counts = np.zeros(Q.shape), np.zeros(Q.shape)
    for s, a, r, after, terminated in steps:
        sums[s, a] += r + (1 - terminated) * max(Q[after])
        counts[s, a] += 1
    n = np.maximum(counts, 1)
    return np.where(counts > 0, np.maximum(lowest, sums / n - penalty / n**0.5), lowest)
