# %% the smallest of the maxima
# says: the maximum of each table is taken first, and the smallest of these; first take the smallest value of each action
# in: the solution of maxmin_target
# - return reward + discount * tables[:, next_state].min(axis=0).max()
# + return reward + discount * tables[:, next_state].max(axis=1).min()

# %% the mean
# says: the tables are averaged; take the smallest value of each action
# in: the solution of maxmin_target
# - return reward + discount * tables[:, next_state].min(axis=0).max()
# + return reward + discount * tables[:, next_state].mean(axis=0).max()

# %% the largest of all
# says: that is the largest value of all tables; first take the smallest value of each action
# in: the solution of maxmin_target
# - return reward + discount * tables[:, next_state].min(axis=0).max()
# + return reward + discount * tables[:, next_state].max()

# %% the smallest of all
# says: that is the smallest value of all; take the largest of the actions' smallest values
# in: the solution of maxmin_target
# - return reward + discount * tables[:, next_state].min(axis=0).max()
# + return reward + discount * tables[:, next_state].min()

# %% the other way round
# says: the largest value of each action is taken, and the smallest of these: it is the other way round
# in: the solution of maxmin_target
# - return reward + discount * tables[:, next_state].min(axis=0).max()
# + return reward + discount * tables[:, next_state].max(axis=0).min()

# %% the other axis
# says: the minimum goes over the actions of each table; it goes over the tables, for each action
# in: the solution of maxmin_target
# - return reward + discount * tables[:, next_state].min(axis=0).max()
# + return reward + discount * tables[:, next_state].min(axis=1).max()

# %% the first table
# says: only the first table counts
# in: the solution of maxmin_target
# - return reward + discount * tables[:, next_state].min(axis=0).max()
# + return reward + discount * tables[0, next_state].max()

# %% all states
# says: the maximum goes over all states; take the row of the next state
# in: the solution of maxmin_target
# - return reward + discount * tables[:, next_state].min(axis=0).max()
# + return reward + discount * tables.min(axis=0).max()

# %% beyond the end
# says: what comes after the end is counted: where `terminated` is True the target is the reward alone
def maxmin_target(tables, reward, next_state, terminated, discount):
    return reward + discount * tables[:, next_state].min(axis=0).max()


# %% no future
# says: what comes after a step is left out
def maxmin_target(tables, reward, next_state, terminated, discount):
    return reward


# %% no discount
# says: the discount is left out
# in: the solution of maxmin_target
# - return reward + discount * tables[:, next_state].min(axis=0).max()
# + return reward + tables[:, next_state].min(axis=0).max()

# %% wrong way round
# says: `terminated` is taken the wrong way round: what follows counts where it is *False*
# in: the solution of maxmin_target
# - if terminated:
# + if not terminated:

# %% no reward at the end
# says: the reward of the step that ends an episode is lost: where `terminated` is True the target is the reward
# in: the solution of maxmin_target
# - return reward
# + return 0

# %% all discounted
# says: the reward is discounted, too; only what follows is
# in: the solution of maxmin_target
# - return reward + discount * tables[:, next_state].min(axis=0).max()
# + return discount * (reward + tables[:, next_state].min(axis=0).max())

# %% only what follows
# says: the reward is left out where something follows
# in: the solution of maxmin_target
# - return reward + discount * tables[:, next_state].min(axis=0).max()
# + return discount * tables[:, next_state].min(axis=0).max()

# %% subtracted
# says: what follows is subtracted; it is added to the reward
# in: the solution of maxmin_target
# - return reward + discount * tables[:, next_state].min(axis=0).max()
# + return reward - discount * tables[:, next_state].min(axis=0).max()

# %% two tables
# says: only the first two tables count; there may be more
# in: the solution of maxmin_target
# - return reward + discount * tables[:, next_state].min(axis=0).max()
# + return reward + discount * np.minimum(tables[0, next_state], tables[1, next_state]).max()

# %% the last index
# says: `next_state` is the last index; the shape is (tables, states, actions)
# in: the solution of maxmin_target
# - return reward + discount * tables[:, next_state].min(axis=0).max()
# + return reward + discount * tables[:, :, next_state].min(axis=0).max()

# %% the number of an action
# says: argmax is the *number* of an action; the target needs its value
# in: the solution of maxmin_target
# - return reward + discount * tables[:, next_state].min(axis=0).max()
# + return reward + discount * tables[:, next_state].min(axis=0).argmax()

# %% the number of a table
# says: argmin is the *number* of a table; take its value
# in: the solution of maxmin_target
# - return reward + discount * tables[:, next_state].min(axis=0).max()
# + return reward + discount * tables[:, next_state].argmin(axis=0).max()

# %% the sum
# says: the smallest values of the actions are added up; take the largest of them
# in: the solution of maxmin_target
# - return reward + discount * tables[:, next_state].min(axis=0).max()
# + return reward + discount * tables[:, next_state].min(axis=0).sum()

# %% the mean of the smallest
# says: the smallest values of the actions are averaged; take the largest of them
# in: the solution of maxmin_target
# - return reward + discount * tables[:, next_state].min(axis=0).max()
# + return reward + discount * tables[:, next_state].min(axis=0).mean()

# %% the first action
# says: only the first action counts: does `return` stand inside a loop?
# in: the solution of maxmin_target
# - return reward + discount * tables[:, next_state].min(axis=0).max()
# + for action in range(tables.shape[2]):
# +     return reward + discount * tables[:, next_state, action].min()

# %% from 0
# says: the search for the largest value begins at 0, and here all may be below: begin at −infinity
# in: the solution of maxmin_target
# - return reward + discount * tables[:, next_state].min(axis=0).max()
# + return reward + discount * max(0, *tables[:, next_state].min(axis=0))

# %% at most 0
# says: the search for the smallest value begins at 0, and here all may be above: begin at infinity
# in: the solution of maxmin_target
# - return reward + discount * tables[:, next_state].min(axis=0).max()
# + return reward + discount * np.minimum(0, tables[:, next_state].min(axis=0)).max()

# %% one value an action
# says: maxmin_target(
# in: the solution of maxmin_target
# - return reward + discount * tables[:, next_state].min(axis=0).max()
# + return reward + discount * tables[:, next_state].min(axis=0)


# %% changes the tables
# says: changes the tables that it is given: only return the target
def maxmin_target(tables, reward, next_state, terminated, discount):
    tables[0] = tables.min(axis=0)
    return reward + (0 if terminated else discount * tables[0, next_state].max())


# %% a number
# says: tables, reward, next_state, terminated and discount
maxmin_target = 0.5


# %% the last table
# says: only the last table counts: take the smallest value of each action
# in: the solution of maxmin_target
# - return reward + discount * tables[:, next_state].min(axis=0).max()
# + return reward + discount * tables[-1, next_state].max()


# %% state 0
# says: the row is that of state 0; take the row of the next state
# in: the solution of maxmin_target
# - return reward + discount * tables[:, next_state].min(axis=0).max()
# + return reward + discount * tables[:, 0].min(axis=0).max()


# %% the mean of all
# says: that is the mean of all values; take the smallest value of each action, and the largest of these
# in: the solution of maxmin_target
# - return reward + discount * tables[:, next_state].min(axis=0).max()
# + return reward + discount * tables[:, next_state].mean()


# %% the best action on average
# says: the smallest values of the actions in state 2 are [-7.5, -8.5, -5.5] here, and the largest of these is -5.5:
#   compare these with yours
# says: the smallest values of the actions in state
# says: here, and the largest of these is
# in: the solution of maxmin_target
# - return reward + discount * tables[:, next_state].min(axis=0).max()
# + return reward + discount * tables[:, next_state, tables[:, next_state].mean(axis=0).argmax()].min()


# %% the end counts half
# says: the step ends its episode, so its reward,
# says: , is all
# in: the solution of maxmin_target
# - return reward
# + return reward / 2
