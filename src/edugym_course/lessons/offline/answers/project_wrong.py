# %% first values of zero
# says: the middle one of
# says: runs makes a clock worth
# says: , and it should be worth
# says: it has learned something; do actions without a step get the lowest value instead of 0, is there a penalty for what is known from few steps, do all steps count, and are there as many sweeps as a night has steps? A night has no discount
# in: sums and counts
# - Q = np.where(counts > 0, np.maximum(lowest, sums / n - 2.0 / np.sqrt(n)), lowest)
# + Q = np.where(counts > 0, sums / n, 0.0)

# %% the worst action
# says: that is worse than the clock that collected the nights; does it take the *best* action, by its own state?
# in: sums and counts
# - return lambda state: int(Q[state].argmax())
# + return lambda state: int(Q[state].argmin())

# %% few steps
# says: it has learned something; do actions
# in: sums and counts
# - for s, a, *_ in steps:
# + steps = steps[:100]
# + for s, a, *_ in steps:

# %% imitation
# says: it has learned something; do actions
# in: sums and counts
# - Q = np.where(counts > 0, np.maximum(lowest, sums / n - 2.0 / np.sqrt(n)), lowest)
# + Q = counts

# %% always quiet
# says: it chooses the same action in every state; are the values looked up in the state to which they belong, does nothing follow where `terminated` is True, and is the best action taken?
def my_program(steps, n_states, n_actions, seed):
    return lambda state: 0


# %% one sweep
# says: it has learned something; do actions
# in: sums and counts
# - for _ in range(30):
# + for _ in range(1):


# %% the table
# says: should return a function from a state to an action, but returns
def my_program(steps, n_states, n_actions, seed):
    return np.zeros((n_states, n_actions))


# %% nothing comes back
# says: (steps, 31, 3,
# says: gives None: return the policy, a function from a state to an action
# in: sums and counts
# - return lambda state: int(Q[state].argmax())
# + policy = lambda state: int(Q[state].argmax())

# %% an action that is not there
# says: , for the state
# in: sums and counts
# - return lambda state: int(Q[state].argmax())
# + return lambda state: 3

# %% a list
# says: steps, n_states, n_actions and seed
my_program = [0, 1, 2]

# %% beyond the end
# says: does nothing follow where `terminated` is True, and is the best action taken?
# in: sums and counts
# - for _ in range(30):
# + for _ in range(300):
# - sums[s, a] += r if terminated else r + V[after]
# + sums[s, a] += r + V[after]
