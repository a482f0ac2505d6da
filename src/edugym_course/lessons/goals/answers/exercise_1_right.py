# %% the place of the largest
# says: Right: one table for all goals. For another goal the same state has another best action.
def greedy(Q, state, goal):
    return np.argmax(Q[state][goal])


# %% a loop
def greedy(Q, state, goal):
    best = 0
    for action in range(Q.shape[2]):
        if Q[state, goal, action] > Q[state, goal, best]:
            best = action
    return best


# %% Python's max
def greedy(Q, state, goal):
    row = Q[state, goal].tolist()
    return row.index(max(row))
