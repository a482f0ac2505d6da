# %% with an indicator
# says: Right: what one arm gains in preference, the others lose together.
def gradient_update(H, arm, reward, mean, learning_rate):
    pi = np.exp(H) / sum(np.exp(H))
    indicator = np.zeros(len(H))
    indicator[arm] = 1
    H += learning_rate * (reward - mean) * (indicator - pi)


# %% arm by arm
def gradient_update(H, arm, reward, mean, learning_rate):
    weights = [np.exp(h - max(H)) for h in H]
    pi = [w / sum(weights) for w in weights]
    for a in range(len(H)):
        if a == arm:
            H[a] = H[a] + learning_rate * (reward - mean) * (1 - pi[a])
        else:
            H[a] = H[a] - learning_rate * (reward - mean) * pi[a]
