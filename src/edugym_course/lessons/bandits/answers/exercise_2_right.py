# %% with where
# says: Right: the less is known of an arm, the more it may be worth.
def upper_bounds(Q, N, c):
    t = N.sum() + 1
    with np.errstate(divide="ignore"):
        return np.where(N > 0, Q + c * np.sqrt(np.log(t) / N), np.inf)


# %% a list
def upper_bounds(Q, N, c):
    from math import inf, log, sqrt

    t = sum(N) + 1
    bounds = []
    for q, n in zip(Q, N):
        bounds.append(inf if n == 0 else q + c * sqrt(log(t) / n))
    return bounds
