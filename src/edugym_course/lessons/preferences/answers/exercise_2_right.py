# %% with counts
# says: Right: the error, times the rate, times where the two nights differ. What both did alike has not changed.
def learn(rewards, first, second, prefers_first, learning_rate):
    difference = np.zeros_like(rewards)
    for pair in first:
        difference[pair] += 1
    for pair in second:
        difference[pair] -= 1
    p = 1 / (1 + np.exp(-(rewards * difference).sum()))
    return rewards + learning_rate * (prefers_first - p) * difference


# %% step by step
def learn(rewards, first, second, prefers_first, learning_rate):
    x = sum(rewards[s, a] for s, a in first) - sum(rewards[s, a] for s, a in second)
    error = (1.0 if prefers_first else 0.0) - 0.5 * (1 + np.tanh(x / 2))
    new = np.array(rewards)
    for night, sign in ((first, 1), (second, -1)):
        for s, a in night:
            new[s, a] += sign * learning_rate * error
    return new
