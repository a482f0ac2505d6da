# %% from the end
# says: Right: what is believed, corrected wherever a reward or a next step tells otherwise.
def doubly_robust_value(episode, target, behaviour, Q):
    value = 0.0
    for state, action, reward in reversed(episode):
        rho = target[state, action] / behaviour[state, action]
        V = target[state] @ Q[state]
        value = V + rho * (reward + value - Q[state, action])
    return value


# %% written out
def doubly_robust_value(episode, target, behaviour, Q):
    total, weight = 0.0, 1.0
    for s, a, r in episode:
        total += weight * (target[s] * Q[s]).sum()
        weight *= target[s, a] / behaviour[s, a]
        total += weight * (r - Q[s, a])
    return float(total)


# %% by recursion
def doubly_robust_value(episode, target, behaviour, Q):
    if not episode:
        return 0.0
    (s, a, r), *later = episode
    rest = doubly_robust_value(later, target, behaviour, Q)
    return sum(target[s] * Q[s]) + target[s, a] / behaviour[s, a] * (r + rest - Q[s, a])
