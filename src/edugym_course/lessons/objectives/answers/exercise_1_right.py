# %% every pair
# says: Right: no other point is better than these. Weights play no part in it.
def pareto_optimal(points):
    kept = []
    for p in points:
        if not any(q[0] >= p[0] and q[1] >= p[1] and (q[0] > p[0] or q[1] > p[1]) for q in points):
            kept.append(p)
    return kept


# %% arrays
def pareto_optimal(points):
    p = np.array(points)
    better = (p[:, None] >= p).all(axis=2) & (p[:, None] > p).any(axis=2)
    return p[~better.any(axis=0)]


# %% from the highest value down
def pareto_optimal(points):
    best, good = -float("inf"), set()
    for value, time in sorted(set(points), reverse=True):
        if time > best:
            good.add((value, time))
            best = time
    return [p for p in points if p in good]
