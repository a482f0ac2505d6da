# %% a loop
# says: Right: 0 is random play and 1 the best play on every rung, so rungs with other rewards count the
#   same.
def ladder_score(returns, random, best):
    total = 0.0
    for k in range(len(returns)):
        total += (returns[k] - random[k]) / (best[k] - random[k])
    return total / len(returns)


# %% the equation as it stands
def ladder_score(returns, random, best):
    return np.mean((returns - random) / (best - random))


# %% how much is missing to the best
def ladder_score(returns, random, best):
    return 1 - ((best - returns) / (best - random)).mean()
