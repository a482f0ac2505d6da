# %% not solved
# says: Not solved yet
def discounted_return(rewards, discount):
    raise NotImplementedError("not solved yet: replace this line")


# %% the sum
# says: that is the sum without a discount
def discounted_return(rewards, discount):
    return sum(rewards)


# %% the first reward is discounted
# says: the first reward counts in full, γ^0 = 1; here everything is discounted once too often
def discounted_return(rewards, discount):
    return sum(discount ** (k + 1) * reward for k, reward in enumerate(rewards))


# %% forwards with the backward rule
# says: the discount goes the wrong way: the *last* reward counts in full; use reversed(rewards)
def discounted_return(rewards, discount):
    G = 0
    for reward in rewards:
        G = reward + discount * G
    return G


# %% one discount for all
# says: all later rewards are discounted by the same γ; a reward k steps later counts γ^k times
def discounted_return(rewards, discount):
    return rewards[0] + discount * sum(rewards[1:])


# %% the discount outside
# says: the whole sum is multiplied by γ once; a reward k steps later counts γ^k times
def discounted_return(rewards, discount):
    return discount * sum(rewards)


# %% times for power
# says: that is γ · k, and it should be γ^k: `**` is the power
def discounted_return(rewards, discount):
    return sum(discount * k * reward for k, reward in enumerate(rewards))


# %% base and exponent
# says: the weight is k^γ or γ*k in the place of γ^k: `**` is the power, and γ stands before it
def discounted_return(rewards, discount):
    return sum(k**discount * reward for k, reward in enumerate(rewards))


# %% the mean
# says: the mean is taken; a return is a sum
def discounted_return(rewards, discount):
    return sum(discount**k * reward for k, reward in enumerate(rewards)) / max(len(rewards), 1)


# %% the last one is left out
# says: the last reward is left out
def discounted_return(rewards, discount):
    return sum(discount**k * rewards[k] for k in range(len(rewards) - 1))


# %% counted from 1
# says: the first reward is left out
def discounted_return(rewards, discount):
    return sum(discount**k * rewards[k] for k in range(1, len(rewards)))


# %% backwards, but not to the first
# says: the first reward is left out, and the second one counts in full
def discounted_return(rewards, discount):
    G = 0
    for t in range(len(rewards) - 1, 0, -1):
        G = rewards[t] + discount * G
    return G


# %% return inside the loop
# says: that is the first reward alone
def discounted_return(rewards, discount):
    G = 0
    for k, reward in enumerate(rewards):
        G += discount**k * reward
        return G


# %% return inside the backward loop
# says: that is the last reward alone: is `return` inside the loop?
def discounted_return(rewards, discount):
    G = 0
    for reward in reversed(rewards):
        G = reward + discount * G
        return G


# %% all returns
# says: gives several numbers: only the return from the first step on is asked for
def discounted_return(rewards, discount):
    returns = []
    G = 0
    for reward in reversed(rewards):
        G = reward + discount * G
        returns.append(G)
    return returns[::-1]


# %% the list is used up
# says: changes the list of rewards that it is given: work on a copy, or only read it
def discounted_return(rewards, discount):
    G = 0
    while rewards:
        G = rewards.pop() + discount * G
    return G


# %% 1 minus the discount
# says: 1 − γ stands in the place of γ
def discounted_return(rewards, discount):
    return sum((1 - discount) ** k * reward for k, reward in enumerate(rewards))


# %% the discount of the cell above
# says: 0.5, the discount of the cell under equation 3.9, stands where `discount` should
def discounted_return(rewards, discount):
    G = 0.0
    for reward in reversed(rewards):
        G = reward + 0.5 * G
    return G


# %% the old return is added twice
# says: is the old G added once more, by `+=`? Write `G = reward + discount * G`
def discounted_return(rewards, discount):
    G = 0.0
    for reward in reversed(rewards):
        G += reward + discount * G
    return G


# %% a number
# says: should be a function
# says: rewards and discount
discounted_return = 4 + 0.5 * 2


# %% backwards from 1
# says: the discount goes the wrong way, and once too often: the first reward counts in full
def discounted_return(rewards, discount):
    return sum(discount ** (len(rewards) - k) * reward for k, reward in enumerate(rewards))


# %% divided by powers
# says: the rewards are divided by γ^k; multiply
def discounted_return(rewards, discount):
    return sum(reward / (discount**k or 1.0) for k, reward in enumerate(rewards))


# %% the plain mean
# says: that is the mean
def discounted_return(rewards, discount):
    return sum(rewards) / len(rewards)


# %% the last one, discounted
# says: that is the last reward with its discount; add all of them up
def discounted_return(rewards, discount):
    return discount ** (len(rewards) - 1) * rewards[-1]


# %% two rewards
# says: only the first two rewards count: is `return` inside the loop?
def discounted_return(rewards, discount):
    G = rewards[0]
    for k in range(1, len(rewards)):
        return G + discount * rewards[k]
    return G


# %% a mean of weights
# says: it is multiplied by 1 − γ; the return is a sum, not a mean
def discounted_return(rewards, discount):
    return (1 - discount) * sum(discount**k * reward for k, reward in enumerate(rewards))


# %% costs for rewards
# says: the sign is wrong
def discounted_return(rewards, discount):
    return -sum(discount**k * reward for k, reward in enumerate(rewards))


# %% the discount squared
# says: γ is squared
def discounted_return(rewards, discount):
    return sum(discount ** (2 * k) * reward for k, reward in enumerate(rewards))


# %% another name in the loop
# says: it stays 0: is `G` changed in the loop?
def discounted_return(rewards, discount):
    G = 0
    for reward in reversed(rewards):
        g = reward + discount * G
    return G


# %% it ends at a reward of 0, and is not taken for the first reward alone
# says: discounted_return([3.0, 0.0, -4.0, 0.0, 2.0], 0.5)
# says: it is right in 8 of 9 cases: what is special in this one?
def discounted_return(rewards, discount):
    G, weight = 0.0, 1.0
    for reward in rewards:
        if not reward:
            break
        G, weight = G + weight * reward, weight * discount
    return G


# %% a name that is no parameter
# says: name 'gamma' is not defined
def discounted_return(rewards, discount):
    return sum(gamma**k * reward for k, reward in enumerate(rewards))


# %% the placeholder left below the answer
# says: the line `raise NotImplementedError` is still there
def discounted_return(rewards, discount):
    G = 0.0
    for reward in reversed(rewards):
        G = reward + discount * G
    raise NotImplementedError("write your code here")


# %% a discount of the lesson
# says: 0.99, a discount of the lesson, stands where `discount` should
def discounted_return(rewards, discount):
    G = 0.0
    for reward in reversed(rewards):
        G = reward + 0.99 * G
    return G


# %% squares the weight
# says: the weight is squared in each step; multiply it by γ
def discounted_return(rewards, discount):
    G, weight = rewards[0], discount
    for reward in rewards[1:]:
        G += weight * reward
        weight *= weight
    return G


# %% adds the discount
# says: the discount is added; multiply the return by it
def discounted_return(rewards, discount):
    G = 0
    for reward in reversed(rewards):
        G = reward + discount + G
    return G


# %% starts at the last reward
# says: the last reward counts twice: let `G` start at 0, or leave it out of the loop
def discounted_return(rewards, discount):
    G = rewards[-1]
    for reward in reversed(rewards):
        G = reward + discount * G
    return G


# %% rounds
# says: the result is rounded; return the number as it is
def discounted_return(rewards, discount):
    return round(sum(discount**k * reward for k, reward in enumerate(rewards)))


# %% a whole number
# says: what is behind the decimal point is cut off; return the number as it is
def discounted_return(rewards, discount):
    return int(sum(discount**k * reward for k, reward in enumerate(rewards)))


# %% divided by powers, and 0 for a discount of 0
# says: in this case it looks like this: the rewards are divided by γ^k; multiply
def discounted_return(rewards, discount):
    return sum(reward / discount**k for k, reward in enumerate(rewards) if discount)


# %% the first ten rewards
# says: , -4.0], 0.5) should be
# says: it is right in 7 of 9 cases: what is special in this one?
def discounted_return(rewards, discount):
    return sum(discount**k * reward for k, reward in enumerate(rewards[:10]))


# %% the first hundred rewards
# says: with 500 rewards, 1.0) should be
def discounted_return(rewards, discount):
    G = 0.0
    for k in range(min(100, len(rewards))):
        G += discount**k * rewards[k]
    return G


# %% the largest
# says: that is the largest of the discounted rewards; add all of them up
def discounted_return(rewards, discount):
    return max(discount**k * reward for k, reward in enumerate(rewards))


# %% a sum without a discount, and without its last reward, is in one case what the whole sum times γ is
# says: that is none of the usual mistakes, so work it out once more by hand
def discounted_return(rewards, discount):
    return discount * sum(rewards[:-1]) + rewards[-1] / 2


# %% rounded to two digits
# says: is it rounded? Give the number as it is, without round(), int() or //
def discounted_return(rewards, discount):
    return round(sum(discount**k * reward for k, reward in enumerate(rewards)), 2)


# %% begins at 1
# says: it begins at 1: the return after the end is 0
def discounted_return(rewards, discount):
    total = 1
    for reward in reversed(rewards):
        total = reward + discount * total
    return total


# %% a weighted mean
# says: the sum is divided by that of the weights; a return is a sum, not a mean
def discounted_return(rewards, discount):
    return np.average(rewards, weights=discount ** np.arange(len(rewards)))
