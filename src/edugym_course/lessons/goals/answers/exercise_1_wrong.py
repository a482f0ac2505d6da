# %% the goal first
# says: the indices have changed places: the state comes first, then the goal
def greedy(Q, state, goal):
    return np.argmax(Q[goal, state])


# %% the lowest
# says: the action with the *lowest* value is taken
def greedy(Q, state, goal):
    return np.argmin(Q[state, goal])


# %% any goal
# says: the goal is left out: the best action for *some* goal is taken
def greedy(Q, state, goal):
    return np.argmax(Q[state].max(axis=0))


# %% the mean over goals
# says: the goal is left out: the values are averaged over all goals
def greedy(Q, state, goal):
    return np.argmax(Q[state].mean(axis=0))


# %% the mean over states
# says: the state is left out: the values are averaged over all states
def greedy(Q, state, goal):
    return np.argmax(Q[:, goal].mean(axis=0))


# %% a number of no action
# says: the search goes over the values of all goals, and so the number is none of an action
def greedy(Q, state, goal):
    return np.argmax(Q[state])


# %% the state twice
# says: it looks up Q[state, state], as if the goal were there already
def greedy(Q, state, goal):
    return np.argmax(Q[state, state])


# %% the goal twice
# says: it looks up Q[goal, goal]; the first index is the state
def greedy(Q, state, goal):
    return np.argmax(Q[goal, goal])


# %% the size
# says: the value that is largest in *size* is taken; −8 is lower than −1
def greedy(Q, state, goal):
    return np.argmax(abs(Q[state, goal]))


# %% close to 0
# says: the value closest to 0 is taken, and not the highest
def greedy(Q, state, goal):
    return np.argmin(abs(Q[state, goal]))


# %% from 0
# says: the search for the highest value starts from 0, and all values may be lower
def greedy(Q, state, goal):
    highest, best = 0, 0
    for action, value in enumerate(Q[state, goal]):
        if value > highest:
            highest, best = value, action
    return best


# %% from −1000
# says: the search for the highest value starts from −1000, and all values may be lower
def greedy(Q, state, goal):
    highest, best = -1000, 0
    for action, value in enumerate(Q[state, goal]):
        if value > highest:
            highest, best = value, action
    return best


# %% from −10
# says: the search for the highest value starts from −10, and all values may be lower
def greedy(Q, state, goal):
    highest, best = -10, 0
    for action, value in enumerate(Q[state, goal]):
        if value > highest:
            highest, best = value, action
    return best


# %% the value
# says: , the highest value; its action is wanted, so the place of it
def greedy(Q, state, goal):
    return np.max(Q[state, goal])


# %% the next one
# says: should give action
# says: that is none of the usual mistakes, so look at one row Q[state, goal] by hand
def greedy(Q, state, goal):
    return (np.argmax(Q[state, goal]) + 1) % 3


# %% no return
# says: gives None: is a `return` missing?
def greedy(Q, state, goal):
    np.argmax(Q[state, goal])


# %% a row
# says: should give the number of an action, a whole number, but gives an array: an action is the *index* of a value
#   (np.argmax(...) finds that of the highest)
def greedy(Q, state, goal):
    return Q[state, goal]


# %% called
# says: greedy should be a function of
# says: Q, state and goal
greedy = 2


# %% whole numbers
# says: the values are cut to whole numbers, and two that differ look alike
def greedy(Q, state, goal):
    return np.argmax(Q[state, goal].astype(int))


# %% whatever the goal is
# says: the goal is left out: it looks up Q[state, 0], whatever the goal is
def greedy(Q, state, goal):
    return np.argmax(Q[state, 0])


# %% all of the best
# says: , a whole number, but gives an array: return one of its entries
def greedy(Q, state, goal):
    return np.flatnonzero(Q[state, goal] == Q[state, goal].max())


# %% numbered from 1
# says: the number is too high by 1: the first action is 0
def greedy(Q, state, goal):
    return np.argmax(Q[state, goal]) + 1


# %% from action 1 on
# says: action 0 is left out: begin the search there
def greedy(Q, state, goal):
    best = 1
    for action in range(1, Q.shape[2]):
        if Q[state, goal, action] > Q[state, goal, best]:
            best = action
    return best


# %% up to the last but one
# says: the last action is left out: range(n) ends at n − 1
def greedy(Q, state, goal):
    return max(range(Q.shape[2] - 1), key=lambda action: Q[state, goal, action])


# %% returns too soon
# says: it is always action 0: is a `return` reached before all actions were looked at?
def greedy(Q, state, goal):
    for action in range(Q.shape[2]):
        return action


# %% the second
# says: the second highest value is taken
def greedy(Q, state, goal):
    return sorted(range(Q.shape[2]), key=lambda action: Q[state, goal, action])[-2]


# %% the highest value is not kept
# says: each value is compared with the first alone: keep the highest one so far
def greedy(Q, state, goal):
    best, highest = 0, Q[state, goal, 0]
    for action, value in enumerate(Q[state, goal]):
        if value > highest:
            best = action
    return best


# %% the largest pair
# says: it is always the last action, whatever the values are
def greedy(Q, state, goal):
    return max(enumerate(Q[state, goal]))[0]
