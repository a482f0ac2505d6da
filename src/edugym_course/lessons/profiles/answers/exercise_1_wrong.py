# %% nothing
# says: Not solved yet
def ladder_score(returns, random, best):
    raise NotImplementedError


# %% no random play
# says: random play should score 0: take its return away from the return and from the best
def ladder_score(returns, random, best):
    return np.mean(np.array(returns) / np.array(best))


# %% the best alone below the line
# says: the denominator is the whole way from random play to the best, high - low
def ladder_score(returns, random, best):
    return np.mean((np.array(returns) - np.array(random)) / np.array(best))


# %% the mean first
# says: score each rung first, and take the mean of the scores
def ladder_score(returns, random, best):
    return (np.mean(returns) - np.mean(random)) / (np.mean(best) - np.mean(random))


# %% nothing below 0
# says: an agent that is worse than random play has a score below 0, which counts as it is
def ladder_score(returns, random, best):
    low = np.array(random)
    return np.mean(np.maximum((np.array(returns) - low) / (np.array(best) - low), 0))


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


# %% no function
# says: returns, random and best
ladder_score = 0.5
