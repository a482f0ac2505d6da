# %% ordinary
# says: it is divided by the number of episodes, as in ordinary importance sampling; divide by the sum of the weights
# in: two sums
# - return total / weights
# + return total / len(episodes)

# %% upside down
# says: the ratio is upside down: π, the policy to be judged, goes above b, which acted
# in: two sums
# - weight *= target[state, action] / behaviour[state, action]
# + weight *= behaviour[state, action] / target[state, action]

# %% a sum of ratios
# says: the ratios of an episode are added; its steps happened one after the other, so multiply them
# in: with arrays
# - weights = np.array([np.prod([ratios[s, a] for s, a, _ in episode]) for episode in episodes])
# + weights = np.array([np.sum([ratios[s, a] for s, a, _ in episode]) for episode in episodes])

# %% a mean of ratios
# says: the weight is the mean of the ratios; it is their product
# in: with arrays
# - weights = np.array([np.prod([ratios[s, a] for s, a, _ in episode]) for episode in episodes])
# + weights = np.array([np.mean([ratios[s, a] for s, a, _ in episode]) for episode in episodes])

# %% the last step
# says: only the last step of an episode has a ratio; multiply those of all steps
# in: two sums
# - weight *= target[state, action] / behaviour[state, action]
# + weight = target[state, action] / behaviour[state, action]

# %% the first step
# says: only the first step of an episode has a ratio; multiply those of all steps
# in: with arrays
# - weights = np.array([np.prod([ratios[s, a] for s, a, _ in episode]) for episode in episodes])
# + weights = np.array([ratios[episode[0][:2]] for episode in episodes])

# %% no weights
# says: every episode weighs the same: that is what b is worth, and the weights are left out
# in: with arrays
# - return np.average(returns, weights=weights)
# + return np.mean(returns)

# %% no behaviour
# says: the weights are products of π alone; b, which chose the episodes, is left out
# in: two sums
# - weight *= target[state, action] / behaviour[state, action]
# + weight *= target[state, action]

# %% not divided
# says: it is not divided by the sum of the weights
# in: two sums
# - return total / weights
# + return total

# %% per step
# says: the mean reward of a step takes the place of the return; an episode is worth the sum of its rewards
# in: with arrays
# - returns = np.array([sum(r for _, _, r in episode) for episode in episodes])
# + returns = np.array([np.mean([r for _, _, r in episode]) for episode in episodes])

# %% no return
# says: gives None: is a `return` missing?
# in: two sums
# - return total / weights
# + total / weights

# %% in place
# says: changes something that it is given, which others may still need
# in: with arrays
# - ratios = target / behaviour
# + target /= behaviour
# + ratios = target

# %% an array
# says: episodes, target and behaviour
weighted_estimate = np.zeros(3)

# %% the last reward
# says: only the last reward of an episode counts; its return is the sum of all
# in: two sums
# - gathered += reward
# + gathered = reward

# %% per decision
# says: each reward has the weight up to its step: that is per decision; here an episode has one weight
# in: two sums
# - gathered += reward
# + gathered += weight * reward
# - total += weight * gathered
# + total += gathered

# %% a weight that goes on
# says: the weight goes on from one episode to the next; each episode begins with 1
# in: two sums
# - total, weights = 0.0, 0.0
# + total, weights, weight = 0.0, 0.0, 1.0
# - weight, gathered = 1.0, 0.0
# + gathered = 0.0

# %% a return that goes on
# says: the return goes on from one episode to the next; each episode begins with 0
# in: two sums
# - total, weights = 0.0, 0.0
# + total, weights, gathered = 0.0, 0.0, 0.0
# - weight, gathered = 1.0, 0.0
# + weight = 1.0

# %% one episode
# says: only the first episode is looked at: does a `return` stand inside the loop?
# in: two sums
# - weights += weight
# + weights += weight
# + return total / weights

# %% by steps
# says: it is divided by the number of steps; divide by the sum of the weights
# in: two sums
# - return total / weights
# + return total / sum(len(episode) for episode in episodes)


# %% weights squared
# says: one episode alone is right, so look at the weights, at the two sums, and at what each episode begins with
def weighted_estimate(episodes, target, behaviour):
    total = weights = 0.0
    for episode in episodes:
        weight = np.prod([(target[s, a] / behaviour[s, a]) ** 2 for s, a, _ in episode])
        total += weight * sum(r for *_, r in episode)
        weights += weight
    return total / weights


# %% without the first step
# says: with one episode its weight cancels, and its return is left: look at the return, and at the two sums
def weighted_estimate(episodes, target, behaviour):
    weights = [np.prod([target[s, a] / behaviour[s, a] for s, a, _ in episode]) for episode in episodes]
    returns = [sum(r for *_, r in episode[1:]) for episode in episodes]
    return np.average(returns, weights=weights)


# %% a ratio of 0 is left out
# says: π never takes the first action of the first episode, whose weight is 0: leave no ratio out, and replace none
# in: two sums
# - weight *= target[state, action] / behaviour[state, action]
# + weight *= target[state, action] / behaviour[state, action] or 1.0
