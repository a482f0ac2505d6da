# %% nothing
# says: Not solved yet
def ladder_score(returns, random, best):
    raise NotImplementedError


# %% no random play
# says: random play should score 0: take its return away from that of the agent
# says: the denominator is the whole way from random play to the best, best - random
def ladder_score(returns, random, best):
    return np.mean(returns / best)


# %% the best alone below the line
# says: the denominator is the whole way from random play to the best, best - random
def ladder_score(returns, random, best):
    return np.mean((returns - random) / best)


# %% the mean first
# says: score each rung first, and take the mean of the scores
def ladder_score(returns, random, best):
    return (np.mean(returns) - np.mean(random)) / (np.mean(best) - np.mean(random))


# %% nothing below 0
# says: an agent that is worse than random play has a score below 0, which counts as it is
def ladder_score(returns, random, best):
    return np.mean(np.maximum((returns - random) / (best - random), 0))


# %% the sum
# says: the score is the mean over the rungs, not their sum
def ladder_score(returns, random, best):
    return sum((mine - low) / (high - low) for mine, low, high in zip(returns, random, best, strict=True))


# %% returns in the loop, and so only the last
# says: that is the score of the last rung alone
def ladder_score(returns, random, best):
    for mine, low, high in zip(returns, random, best, strict=True):
        score = (mine - low) / (high - low)
    return score


# %% three mistakes: what is missing to the best, undivided, on the first rung
# says: measure how far the agent is above random play, not how far it is below the best
# says: divide by the way from random play to the best, best - random
# says: that is the score of the first rung alone: is the `return` inside of the loop?
def ladder_score(returns, random, best):
    for mine, high in zip(returns, best, strict=True):
        return high - mine


# %% three mistakes: upside down, added, the median
# says: the numerator is the wrong way round
# says: take random play away from the best, do not add them
# says: that is the median; the score is the mean
def ladder_score(returns, random, best):
    return np.median((random - returns) / (best + random))


# %% three mistakes: the size alone, the wrong way round, without the first rung
# says: an agent that is worse than random play is below it: no absolute value
# says: the denominator is the wrong way round
# says: the first rung is missing in the sum; it has the index 0
def ladder_score(returns, random, best):
    return sum(abs(returns[k] - random[k]) / (random[k] - best[k]) for k in range(1, len(returns))) / len(returns)


# %% two mistakes: divided by what is missing, and without the last rung
# says: the denominator goes from random play to the best, not from the agent
# says: the last rung is missing in the sum
def ladder_score(returns, random, best):
    total = 0
    for k in range(len(returns) - 1):
        total += (returns[k] - random[k]) / (best[k] - returns[k])
    return total / len(returns)


# %% the first rung in the sum
# says: only the first rung is in the sum: is the `return` inside of the loop?
def ladder_score(returns, random, best):
    total = 0
    for mine, low, high in zip(returns, random, best, strict=True):
        total += (mine - low) / (high - low)
        return total / len(returns)


# %% whole numbers
# says: `//` gives whole numbers; write `/`
def ladder_score(returns, random, best):
    return np.mean((returns - random) // (best - random))


# %% per cent
# says: the best play scores 1: no percentage is wanted
def ladder_score(returns, random, best):
    return 100 * np.mean((returns - random) / (best - random))


# %% cut on both sides
# says: scores below 0 and above 1 count as they are
def ladder_score(returns, random, best):
    return np.mean(np.clip((returns - random) / (best - random), 0, 1))


# %% the numerator without brackets
# says: put the numerator in brackets: / comes before -
def ladder_score(returns, random, best):
    return np.mean(returns - random / (best - random))


# %% no brackets
# says: put the numerator in brackets, and the denominator: / comes before -
def ladder_score(returns, random, best):
    return np.mean(returns - random / best - random)


# %% upside down
# says: that is the right score upside down: the way of the agent stands above the line
def ladder_score(returns, random, best):
    return np.mean((best - random) / (returns - random))


# %% the denominator without brackets
# says: put the denominator in brackets: / comes before -
def ladder_score(returns, random, best):
    return np.mean((returns - random) / best - random)


# %% from the best, and the last rung alone in the sum
# says: measure from random play, not from the best
# says: only the last rung is in the sum: is there an `=` where `+=` should be?
def ladder_score(returns, random, best):
    total = 0
    for mine, low, high in zip(returns, random, best, strict=True):
        total = (mine - high) / (high - low)
    return total / len(returns)


# %% a number for each rung
# says: gives a number for each rung; their mean is wanted
def ladder_score(returns, random, best):
    return (returns - random) / (best - random)


# %% in place
# says: changes its array `returns`; make a new one, for the caller still needs the old one
def ladder_score(returns, random, best):
    returns -= random
    return np.mean(returns / (best - random))


# %% the range of the numbers
# says: that is none of the usual mistakes; here the rungs score
def ladder_score(returns, random, best):
    return np.mean(returns - random) / (best.max() - random.min())


# %% no function
# says: returns, random and best
ladder_score = 0.5


# %% the first rung for all
# says: each rung has its own random and best play; those of the first are taken for all
def ladder_score(returns, random, best):
    return ((returns - random[0]) / (best[0] - random[0])).mean()


# %% random play without its sign
# says: returns below 0 keep their sign: no absolute value
def ladder_score(returns, random, best):
    return np.mean((returns + abs(random)) / (best + abs(random)))


# %% the sizes below the line
# says: take the best and random play as they are, without their absolute values
def ladder_score(returns, random, best):
    return np.mean((returns - random) / (abs(best) + abs(random)))


# %% the best rung
# says: that is the score of the best rung alone
def ladder_score(returns, random, best):
    return max((returns - random) / (best - random))


# %% no score above 1
# says: scores above 1 count as they are
def ladder_score(returns, random, best):
    return np.mean(np.minimum((returns - random) / (best - random), 1))
