# %% two sums
# says: Right: an episode counts as much as the other policy would rather have played it.
def weighted_estimate(episodes, target, behaviour):
    total, weights = 0.0, 0.0
    for episode in episodes:
        weight, gathered = 1.0, 0.0
        for state, action, reward in episode:
            weight *= target[state, action] / behaviour[state, action]
            gathered += reward
        total += weight * gathered
        weights += weight
    return total / weights


# %% with arrays
def weighted_estimate(episodes, target, behaviour):
    ratios = target / behaviour
    weights = np.array([np.prod([ratios[s, a] for s, a, _ in episode]) for episode in episodes])
    returns = np.array([sum(r for _, _, r in episode) for episode in episodes])
    return np.average(returns, weights=weights)


# %% by logarithms
def weighted_estimate(episodes, target, behaviour):
    logs = [sum(np.log(target[s, a]) - np.log(behaviour[s, a]) for s, a, _ in episode) for episode in episodes]
    shares = np.exp(np.array(logs) - max(logs))
    return float(sum(w * sum(r for *_, r in e) for w, e in zip(shares, episodes)) / shares.sum())
