# %% forwards with a growing power
# says: Right. From the last reward to the first, one multiplication a step is enough, and no power of γ is needed.
def discounted_return(rewards, discount):
    total, weight = 0.0, 1.0
    for reward in rewards:
        total += weight * reward
        weight *= discount
    return total


# %% reduce
from functools import reduce

discounted_return = lambda rewards, discount: reduce(lambda G, r: r + discount * G, rewards[::-1], 0)


# %% an array without axes
def discounted_return(rewards, discount):
    return np.sum(np.array(rewards) * np.power(discount, np.arange(len(rewards))), keepdims=False)
