# %% with differences of F to the power of k
# says: Right: a sum of a few terms, and no dice are thrown.
def largest_promise(n_machines, n_tries, win, lose):
    p = np.array([comb(n_tries, w) for w in range(n_tries + 1)]) / 2**n_tries
    x = np.array([(w * win + (n_tries - w) * lose) / n_tries for w in range(n_tries + 1)])
    at_most = np.cumsum(p) ** n_machines
    return (x * np.diff(at_most, prepend=0)).sum()


# %% from the top, by what is above each value
def largest_promise(n_machines, n_tries, win, lose):
    step = (win - lose) / n_tries
    promise, F = lose, 0.0
    for w in range(n_tries):
        F += comb(n_tries, w) * 0.5**n_tries
        promise += step * (1 - F**n_machines)
    return promise


# %% machine by machine
def largest_promise(n_machines, n_tries, win, lose):
    one = [comb(n_tries, w) / 2**n_tries for w in range(n_tries + 1)]
    best = one
    for _ in range(n_machines - 1):
        both = [0.0] * (n_tries + 1)
        for i, p in enumerate(best):
            for j, q in enumerate(one):
                both[max(i, j)] += p * q
        best = both
    return sum(p * (w * win + (n_tries - w) * lose) / n_tries for w, p in enumerate(best))
