# %% the base of the edits
# says: that goes the other way: the night that she prefers must gain
def learn(rewards, first, second, prefers_first, learning_rate):
    difference = np.zeros_like(rewards)
    for pair in first:
        difference[pair] -= 1
    for pair in second:
        difference[pair] += 1
    p = 1 / (1 + np.exp((rewards * difference).sum()))
    return rewards + learning_rate * (prefers_first - p) * difference


# %% once each
# says: each pair of a state and an action counts once, and a night may take it more often
def learn(rewards, first, second, prefers_first, learning_rate):
    x = sum(rewards[s, a] for s, a in first) - sum(rewards[s, a] for s, a in second)
    error = prefers_first - 1 / (1 + np.exp(-x))
    new = rewards.copy()
    for pair in set(first):
        new[pair] += learning_rate * error
    for pair in set(second):
        new[pair] -= learning_rate * error
    return new


# %% in place
# says: changes the table that it is given: begin with rewards = rewards.copy()
def learn(rewards, first, second, prefers_first, learning_rate):
    x = sum(rewards[s, a] for s, a in first) - sum(rewards[s, a] for s, a in second)
    error = prefers_first - 1 / (1 + np.exp(-x))
    for pair in first:
        rewards[pair] += learning_rate * error
    for pair in second:
        rewards[pair] -= learning_rate * error
    return rewards


# %% no p
# says: p is left out: the error is y − p
def learn(rewards, first, second, prefers_first, learning_rate):
    new = rewards.copy()
    for pair in first:
        new[pair] += learning_rate * prefers_first
    for pair in second:
        new[pair] -= learning_rate * prefers_first
    return new


# %% the second is forgotten
# says: only the first night has changed: subtract the second
def learn(rewards, first, second, prefers_first, learning_rate):
    x = sum(rewards[s, a] for s, a in first) - sum(rewards[s, a] for s, a in second)
    error = prefers_first - 1 / (1 + np.exp(-x))
    new = rewards.copy()
    for pair in first:
        new[pair] += learning_rate * error
    return new


# %% signs for flags
# says: y is −1 where she prefers the second; it is 0 there
def learn(rewards, first, second, prefers_first, learning_rate):
    x = sum(rewards[s, a] for s, a in first) - sum(rewards[s, a] for s, a in second)
    error = (1 if prefers_first else -1) - 1 / (1 + np.exp(-x))
    new = rewards.copy()
    for pair in first:
        new[pair] += learning_rate * error
    for pair in second:
        new[pair] -= learning_rate * error
    return new


# %% no return, in place
# says: gives None, and has changed `rewards`: copy the table, and return the new one
def learn(rewards, first, second, prefers_first, learning_rate):
    for pair in first:
        rewards[pair] += learning_rate


# %% an entry
# says: should give an array of shape (3, 2), but gives one of shape ()
# says: : is it the whole table that you return?
def learn(rewards, first, second, prefers_first, learning_rate):
    return 0.3


# %% the second's p
# says: p is that of the second night: the first return less the second goes into σ
# in: step by step
# - error = (1.0 if prefers_first else 0.0) - 0.5 * (1 + np.tanh(x / 2))
# + error = (1.0 if prefers_first else 0.0) - 0.5 * (1 + np.tanh(-x / 2))


# %% a half
# says: p is 1/2, as with a table of zeros: work it out from the returns by `rewards`
# in: step by step
# - error = (1.0 if prefers_first else 0.0) - 0.5 * (1 + np.tanh(x / 2))
# + error = (1.0 if prefers_first else 0.0) - 0.5


# %% always preferred
# says: y is 1 in every case: it is 0 where she prefers the second
# in: step by step
# - error = (1.0 if prefers_first else 0.0) - 0.5 * (1 + np.tanh(x / 2))
# + error = 1.0 - 0.5 * (1 + np.tanh(x / 2))


# %% never preferred
# says: y is 0 in every case: it is 1 where she prefers the first
# in: step by step
# - error = (1.0 if prefers_first else 0.0) - 0.5 * (1 + np.tanh(x / 2))
# + error = -0.5 * (1 + np.tanh(x / 2))


# %% the slope
# says: that is the gradient of the squared error, with the slope p (1 − p); that of the log likelihood has none
# in: step by step
# - error = (1.0 if prefers_first else 0.0) - 0.5 * (1 + np.tanh(x / 2))
# + p = 0.5 * (1 + np.tanh(x / 2))
# + error = (prefers_first - p) * p * (1 - p)


# %% no rate
# says: the learning rate is left out
# in: step by step
# - new[s, a] += sign * learning_rate * error
# + new[s, a] += sign * error


# %% a mean
# says: the step is divided by the number of steps of a night; a return is a sum, not a mean
# in: step by step
# - new[s, a] += sign * learning_rate * error
# + new[s, a] += sign * learning_rate * error / len(night)


# %% the last step
# says: only the last step of each night has changed; all of them count
# in: step by step
# - for s, a in night:
# + for s, a in night[-1:]:


# %% the first step
# says: only the first step of each night has changed; all of them count
# in: step by step
# - for s, a in night:
# + for s, a in night[:1]:


# %% both gain
# says: the second night is added; what helps the first takes from the second
# in: step by step
# - for night, sign in ((first, 1), (second, -1)):
# + for night, sign in ((first, 1), (second, 1)):


# %% a night changed
# says: changes one of the nights, which others may still need
# in: step by step
# - new = np.array(rewards)
# + new = np.array(rewards)
# + first.append(first[0])


# %% a table
# says: rewards, first, second, prefers_first and learning_rate
learn = np.zeros((3, 2))


# %% a hard p
# says: p is 1 or 0, as if the teacher never erred: it is σ of the difference
def learn(rewards, first, second, prefers_first, learning_rate):
    new = rewards.copy()
    returns = [sum(rewards[pair] for pair in night) for night in (first, second)]
    p = float(returns[0] > returns[1])
    step = learning_rate * (prefers_first - p)
    for night, sign in ((first, 1), (second, -1)):
        for state, action in night:
            new[state, action] += sign * step
    return new


# %% mean rewards
# says: p follows from mean rewards; a return is a sum
def learn(rewards, first, second, prefers_first, learning_rate):
    new = rewards.copy()
    returns = [sum(rewards[pair] for pair in night) for night in (first, second)]
    p = 1 / (1 + np.exp(returns[1] / len(second) - returns[0] / len(first)))
    step = learning_rate * (prefers_first - p)
    for night, sign in ((first, 1), (second, -1)):
        for state, action in night:
            new[state, action] += sign * step
    return new


# %% a share of returns
# says: p is a share of the returns; it is σ of their difference
def learn(rewards, first, second, prefers_first, learning_rate):
    new = rewards.copy()
    returns = [sum(rewards[pair] for pair in night) for night in (first, second)]
    p = returns[0] / sum(returns) if sum(returns) else 0.0
    step = learning_rate * (prefers_first - p)
    for night, sign in ((first, 1), (second, -1)):
        for state, action in night:
            new[state, action] += sign * step
    return new


# %% all actions of a state
# says: all actions of a state have changed; only the one that was taken does
def learn(rewards, first, second, prefers_first, learning_rate):
    new = rewards.copy()
    returns = [sum(rewards[pair] for pair in night) for night in (first, second)]
    p = 1 / (1 + np.exp(returns[1] - returns[0]))
    step = learning_rate * (prefers_first - p)
    for night, sign in ((first, 1), (second, -1)):
        for state, action in night:
            new[state] += sign * step
    return new


# %% an empty table
# says: the old rewards are left out: add the step to them
def learn(rewards, first, second, prefers_first, learning_rate):
    new = np.zeros_like(rewards)
    returns = [sum(rewards[pair] for pair in night) for night in (first, second)]
    p = 1 / (1 + np.exp(returns[1] - returns[0]))
    step = learning_rate * (prefers_first - p)
    for night, sign in ((first, 1), (second, -1)):
        for state, action in night:
            new[state, action] += sign * step
    return new


# %% only the preferred night
# says: only the night that she prefers has changed; the other one loses as much
def learn(rewards, first, second, prefers_first, learning_rate):
    new = rewards.copy()
    returns = [sum(rewards[pair] for pair in night) for night in (first, second)]
    p = 1 / (1 + np.exp(returns[1] - returns[0]))
    for pair in first if prefers_first else second:
        new[pair] += learning_rate * abs(prefers_first - p)
    return new


# %% a difference for p
# says: p is the difference of the returns itself, and σ is missing
# in: with counts
# - p = 1 / (1 + np.exp(-(rewards * difference).sum()))
# + p = (rewards * difference).sum()


# %% from the old table
# says: a pair that comes again starts from the old table: add to what already stands there (+=)
def learn(rewards, first, second, prefers_first, learning_rate):
    x = sum(rewards[s, a] for s, a in first) - sum(rewards[s, a] for s, a in second)
    step = learning_rate * (prefers_first - 1 / (1 + np.exp(-x)))
    new = rewards.copy()
    for pair in first:
        new[pair] = rewards[pair] + step
    for pair in second:
        new[pair] = rewards[pair] - step
    return new


# %% the first night's return
# says: the right entries change, but α (y − p) is
# says: here, and should be
# in: with counts
# - p = 1 / (1 + np.exp(-(rewards * difference).sum()))
# + p = 1 / (1 + np.exp(-sum(rewards[pair] for pair in first)))

# %% p at every entry
# says: p changes on the way, with every entry: work it out once, from the old rewards
# in: step by step
# - new[s, a] += sign * learning_rate * error
# + new[s, a] += sign * learning_rate * (prefers_first - 1 / (1 + np.exp(sum(new[q] for q in second) - sum(new[q] for q in first))))
