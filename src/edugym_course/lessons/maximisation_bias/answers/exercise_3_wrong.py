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
