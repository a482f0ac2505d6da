# %% arrays
# says: Right: the objective in which an action is worst decides. So no amount of time makes up for a poor value.
def closest_action(Q, state, weights, utopian):
    distances = weights * np.abs(utopian - Q[state])
    return np.argmin(distances.max(axis=1))


# %% loops
def closest_action(Q, state, weights, utopian):
    best, shortest = None, float("inf")
    for action in range(Q.shape[1]):
        farthest = 0.0
        for i in range(2):
            farthest = max(farthest, weights[i] * abs(utopian[i] - Q[state, action, i]))
        if farthest < shortest:
            best, shortest = action, farthest
    return best


# %% the norm of the weighted difference
def closest_action(Q, state, weights, utopian):
    far = [np.linalg.norm(weights * (q - utopian), ord=np.inf) for q in Q[state]]
    return far.index(min(far))


# %% weights that add up to one
def closest_action(Q, state, weights, utopian):
    shares = weights / weights.sum()
    return min(range(len(Q[state])), key=lambda a: max(w * abs(z - q) for w, z, q in zip(shares, utopian, Q[state, a])))
