# %% rounds about the exploring
# says: Right: an action that ties is as good as the first one, so each of them gets its share.
def choose(values, epsilon, rng):
    if rng.random() >= epsilon:
        best = [a for a in range(len(values)) if values[a] == max(values)]
        return best[int(rng.random() * len(best))]
    return int(rng.random() * len(values))


# %% probabilities
# slow
def choose(values, epsilon, rng):
    n = len(values)
    best = values == values.max()
    p = epsilon / n + (1 - epsilon) * best / best.sum()
    return rng.choice(n, p=p)


# %% one loop
def choose(values, epsilon, rng):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    best, ties = 0, 1
    for action in range(1, len(values)):
        if values[action] > values[best]:
            best, ties = action, 1
        elif values[action] == values[best]:
            ties += 1
            if rng.random() < 1 / ties:
                best = action
    return best
