# %% forwards with a growing power
# says: Right. From the last reward to the first, one multiplication a step is enough, and no power of γ is needed.
def discounted_return(rewards, discount):
    total, weight = 0.0, 1.0
    for reward in rewards:
        total += weight * reward
        weight *= discount
    return total


# %% powers
def discounted_return(rewards, discount):
    return sum(discount**k * reward for k, reward in enumerate(rewards))


# %% recursive
def discounted_return(rewards, discount):
    if not rewards:
        return 0
    return rewards[0] + discount * discounted_return(rewards[1:], discount)


# %% NumPy
def discounted_return(rewards, discount):
    return np.dot(rewards, discount ** np.arange(len(rewards)))


# %% reversed by a slice
def discounted_return(rewards, discount):
    G = 0
    for r in rewards[::-1]:
        G = discount * G + r
    return G


# %% indices
def discounted_return(rewards, discount):
    G = 0
    for t in range(len(rewards) - 1, -1, -1):
        G = rewards[t] + discount * G
    return float(G)


# %% reduce
from functools import reduce

discounted_return = lambda rewards, discount: reduce(lambda G, r: r + discount * G, rewards[::-1], 0)


# %% an array without axes
def discounted_return(rewards, discount):
    return np.sum(np.array(rewards) * np.power(discount, np.arange(len(rewards))), keepdims=False)


# %% from the last reward on
def discounted_return(rewards, discount):
    G = rewards[-1]
    for reward in reversed(rewards[:-1]):
        G = reward + discount * G
    return G
