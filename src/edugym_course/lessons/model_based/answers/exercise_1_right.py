# %% expanded
# says: Right: the larger γ is, the smaller an error is enough, since a far-sighted plan adds up more bumps.
def smallest_error(v, gamma):
    return 1 + v - gamma * v


# %% other names
def smallest_error(value, discount):
    return value * (1 - discount) + 1.0


# %% by bisection
def smallest_error(v, gamma):
    low, high = 0.0, 1000.0
    for _ in range(100):
        e = (low + high) / 2
        if (e - 1) / (1 - gamma) > v:
            high = e
        else:
            low = e
    return high
