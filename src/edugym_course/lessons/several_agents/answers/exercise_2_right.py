# %% by the two differences
# says: Right: player 1 gets the same from both columns, so it cannot use what it knows of your policy.
def safe_probability(payoffs):
    in_row_0 = payoffs[0, 0] - payoffs[0, 1]
    in_row_1 = payoffs[1, 0] - payoffs[1, 1]
    return in_row_1 / (in_row_1 - in_row_0)


# %% a linear system
def safe_probability(payoffs):
    (a, b), (c, d) = payoffs
    p, value = np.linalg.solve([[a - c, -1], [b - d, -1]], [-c, -d])
    return p


# %% solved as a game
def safe_probability(payoffs):
    return games.solve_zero_sum(payoffs).first[0]
