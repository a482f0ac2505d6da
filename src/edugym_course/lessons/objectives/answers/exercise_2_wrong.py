# %% farthest
# says: should give action
# says: the action that is *farthest* is taken
# in: arrays
# - return np.argmin(distances.max(axis=1))
# + return np.argmax(distances.max(axis=1))


# %% the sum
# says: the distances of the objectives are added up; only the largest counts
# in: arrays
# - return np.argmin(distances.max(axis=1))
# + return np.argmin(distances.sum(axis=1))


# %% the mean
# says: the distances of the objectives are added up; only the largest counts
# in: arrays
# - return np.argmin(distances.max(axis=1))
# + return np.argmin(distances.mean(axis=1))


# %% the smallest
# says: the *smallest* distance of an action counts; it should be the largest of its objectives
# in: arrays
# - return np.argmin(distances.max(axis=1))
# + return np.argmin(distances.min(axis=1))


# %% no weights
# says: the weights are left out
# in: arrays
# - distances = weights * np.abs(utopian - Q[state])
# + distances = np.abs(utopian - Q[state])


# %% divided
# says: the distances are divided by the weights, or each has the weight of the other objective
# in: arrays
# - distances = weights * np.abs(utopian - Q[state])
# + distances = np.abs(utopian - Q[state]) / weights


# %% no size
# says: the absolute value is left out: a value beyond the utopian point is also at a distance
# in: arrays
# - distances = weights * np.abs(utopian - Q[state])
# + distances = weights * (utopian - Q[state])


# %% the other sign
# says: the sign is wrong, and the absolute value is left out: that is Q − z
# in: arrays
# - distances = weights * np.abs(utopian - Q[state])
# + distances = weights * (Q[state] - utopian)


# %% weighted values
# says: the values are weighted before they are taken from z; weigh the distances
# in: arrays
# - distances = weights * np.abs(utopian - Q[state])
# + distances = np.abs(utopian - weights * Q[state])


# %% Euclid
# says: the squares of the distances are added up, as in the Euclidean distance; only the largest counts
# in: arrays
# - return np.argmin(distances.max(axis=1))
# + return np.argmin(np.linalg.norm(distances, axis=1))


# %% a weighted sum
# says: that is the highest weighted sum, in which z plays no part
def closest_action(Q, state, weights, utopian):
    return np.argmax(Q[state] @ weights)


# %% the value alone
# says: only the first objective counts
# in: arrays
# - return np.argmin(distances.max(axis=1))
# + return np.argmin(distances[:, 0])


# %% the time alone
# says: only the second objective counts
# in: arrays
# - return np.argmin(distances.max(axis=1))
# + return np.argmin(distances[:, 1])


# %% no utopian point
# says: the utopian point is left out: the values themselves are compared
# in: arrays
# - distances = weights * np.abs(utopian - Q[state])
# + distances = weights * np.abs(Q[state])


# %% the first state
# says: the state is left out: it looks up Q[0]
# in: arrays
# - distances = weights * np.abs(utopian - Q[state])
# + distances = weights * np.abs(utopian - Q[0])


# %% the distance
# says: , the smallest distance; its action is wanted, so the place
# in: arrays
# - return np.argmin(distances.max(axis=1))
# + return distances.max(axis=1).min()


# %% the values times the weights
# says: that is none of the usual mistakes, so work out d(s, a) of two actions by hand
# in: arrays
# - return np.argmin(distances.max(axis=1))
# + return np.argmin(-(weights * Q[state]).max(axis=1))


# %% of all
# says: an action is the *index* of a value
# in: arrays
# - return np.argmin(distances.max(axis=1))
# + return distances.max(axis=1)


# %% nothing
# says: is a `return` missing?
# in: arrays
# - return np.argmin(distances.max(axis=1))
# + np.argmin(distances.max(axis=1))


# %% a number
# says: Q, state, weights and utopian
closest_action = 3


# %% added
# says: z and Q are added; a distance is a difference
# in: arrays
# - distances = weights * np.abs(utopian - Q[state])
# + distances = weights * np.abs(utopian + Q[state])


# %% only z
# says: only z is weighted; weigh the distances
# in: arrays
# - distances = weights * np.abs(utopian - Q[state])
# + distances = np.abs(weights * utopian - Q[state])


# %% they cancel
# says: the differences are added up, so that they cancel; take the absolute value of each, and the largest
# in: arrays
# - distances = weights * np.abs(utopian - Q[state])
# + distances = weights * (utopian - Q[state])
# - return np.argmin(distances.max(axis=1))
# + return np.argmin(np.abs(distances.sum(axis=1)))


# %% weighted squares
# says: squares are added up, each times its weight; only the largest distance counts
# in: arrays
# - distances = weights * np.abs(utopian - Q[state])
# + distances = weights * (utopian - Q[state]) ** 2
# - return np.argmin(distances.max(axis=1))
# + return np.argmin(distances.sum(axis=1))


# %% the other axis
# says: the largest distance is taken over the actions, with axis=0; it is that of each action, with axis=1
# in: arrays
# - return np.argmin(distances.max(axis=1))
# + return np.argmin(distances.max(axis=0))


# %% one number
# says: that is always action 0: does each action have a distance of its own (axis=1)? Does a search begin at
#   infinity, and does `return` stand below the loop?
# in: arrays
# - return np.argmin(distances.max(axis=1))
# + return np.argmin(distances.max())


# %% the best value
# says: that is the action with the best value; d counts both objectives
# in: arrays
# - return np.argmin(distances.max(axis=1))
# + return Q[state][:, 0].argmax()


# %% the best time
# says: that is the action with the best time; d counts both objectives
# in: arrays
# - return np.argmin(distances.max(axis=1))
# + return Q[state][:, 1].argmax()


# %% the product
# says: the distances of the objectives are multiplied; only the largest counts
# in: arrays
# - return np.argmin(distances.max(axis=1))
# + return np.argmin(distances.prod(axis=1))


# %% the indices of Q
# says: the indices of Q have changed places: it looks up Q[:, state], and Q[state] has the actions
def closest_action(Q, state, weights, utopian):
    return (weights * np.abs(utopian - Q[:, state])).max(axis=1).argmin()


# %% the absolute value of Q
# says: the absolute value of Q is taken, and not that of the distance z − Q
def closest_action(Q, state, weights, utopian):
    return (weights * (utopian - np.abs(Q[state]))).max(axis=1).argmin()


# %% squares
# says: the difference is squared before it is weighted; take its absolute value
# in: arrays
# - distances = weights * np.abs(utopian - Q[state])
# + distances = weights * (utopian - Q[state]) ** 2


# %% sizes first
# says: the absolute values of z and Q are taken before their difference; take that of the difference
# in: arrays
# - distances = weights * np.abs(utopian - Q[state])
# + distances = weights * np.abs(np.abs(utopian) - np.abs(Q[state]))


# %% changes the weights
# says: changes its array `weights`; make a new one
# in: arrays
# - distances = weights * np.abs(utopian - Q[state])
# + weights /= weights.sum()
# + distances = weights * np.abs(utopian - Q[state])


# %% the state before
# says: it looks up another state, Q[state - 1]
# in: arrays
# - distances = weights * np.abs(utopian - Q[state])
# + distances = weights * np.abs(utopian - Q[state - 1])


# %% weighted too late
# says: the distances are weighted after the largest is chosen; weigh each of them first
# in: arrays
# - distances = weights * np.abs(utopian - Q[state])
# - return np.argmin(distances.max(axis=1))
# + distances = np.abs(utopian - Q[state])
# + return np.argmin(distances.max(axis=1) * weights[distances.argmax(axis=1)])


# %% the absolute value too late
# says: the absolute value of the largest difference is taken; take that of each difference first
# in: arrays
# - distances = weights * np.abs(utopian - Q[state])
# - return np.argmin(distances.max(axis=1))
# + distances = weights * (utopian - Q[state])
# + return np.argmin(np.abs(distances.max(axis=1)))


# %% the best of the state
# says: the best values in this state stand in the place of `utopian`
# in: arrays
# - distances = weights * np.abs(utopian - Q[state])
# + distances = weights * np.abs(Q[state].max(axis=0) - Q[state])


# %% the larger weight
# says: only the objective with the larger weight counts
# in: arrays
# - return np.argmin(distances.max(axis=1))
# + return np.argmin(distances[:, weights.argmax()])


# %% not the last action
# says: the last action is left out: does the range of the loop end too early?
# in: arrays
# - return np.argmin(distances.max(axis=1))
# + return np.argmin(distances.max(axis=1)[:-1])


# %% not the first action
# says: the first action is left out: does the range of the loop begin too late?
# in: arrays
# - return np.argmin(distances.max(axis=1))
# + return 1 + np.argmin(distances.max(axis=1)[1:])


# %% two actions
# says: only the first two actions are compared: there may be more of them than objectives
# in: arrays
# - return np.argmin(distances.max(axis=1))
# + return np.argmin(distances.max(axis=1)[:2])


# %% no smallest so far
# says: that is always the last action: does the loop keep the smallest distance so far?
# in: loops
# - best, shortest = action, farthest
# + best = action


# %% all moved so that the point is 0
# says: changes its array `Q`; make a new one, for the caller still needs the old one
def closest_action(Q, state, weights, utopian):
    Q -= utopian
    Q *= weights
    weights[:], utopian[:] = 1.0, 0.0
    return np.abs(Q[state]).max(axis=1).argmin()


# %% a place in the whole table
# says: should give an action from 0 to 3, but gives
# says: : is it the place in a whole table, as argmax and argmin without an axis give it?
# in: arrays
# - return np.argmin(distances.max(axis=1))
# + return np.argmin(distances)


# %% signs mixed up
# says: the signs are mixed up: that is the largest of max w (Q − z)
# in: arrays
# - distances = weights * np.abs(utopian - Q[state])
# - return np.argmin(distances.max(axis=1))
# + return np.argmax((weights * (Q[state] - utopian)).max(axis=1))


# %% cut off at the point
# says: what lies beyond the utopian point counts 0; it has a distance, too
# in: arrays
# - distances = weights * np.abs(utopian - Q[state])
# + distances = weights * np.maximum(0.0, utopian - Q[state])


# %% absolute values subtracted
# says: the absolute values are subtracted; take that of the difference z − Q
# in: arrays
# - distances = weights * np.abs(utopian - Q[state])
# + distances = weights * (np.abs(utopian) - np.abs(Q[state]))


# %% tenths
# says: that is none of the usual mistakes, so work out d(s, a) of two actions by hand
def closest_action(Q, state, weights, utopian):
    return int(np.argmin((weights * np.abs(utopian - Q[state])).round(1).max(axis=1)))


# %% the weights of the text
# says: the weights are always 1 and 12, as in the text; use those that are given
def closest_action(Q, state, weights, utopian):
    return int(np.argmin((np.array([1.0, 12.0]) * np.abs(utopian - Q[state])).max(axis=1)))


# %% the point of the text
# says: the utopian point is always that of the text, (90, −1); use the one that is given
def closest_action(Q, state, weights, utopian):
    return int(np.argmin((weights * np.abs(np.array([90.0, -1.0]) - Q[state])).max(axis=1)))


# %% a little of the sum, too
# says: that is none of the usual mistakes, so work out d(s, a) of two actions by hand
def closest_action(Q, state, weights, utopian):
    distances = weights * np.abs(utopian - Q[state])
    return int(np.argmin(distances.max(axis=1) + 0.05 * distances.sum(axis=1)))
