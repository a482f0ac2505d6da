# %% the mean
# says: the actions are averaged: that is the value of random play; you will take the best
# in: the solution of look_ahead
# - return max(values)
# + return sum(values) / len(values)

# %% the sum
# says: the actions are added up; you will take the best
# in: the solution of look_ahead
# - return max(values)
# + return sum(values)

# %% action 0
# says: only action 0 is looked at
# in: the solution of look_ahead
# - return max(values)
# + return values[0]

# %% the worst
# says: that is the value of the worst action
# in: the solution of look_ahead
# - return max(values)
# + return min(values)

# %% beyond the end
# says: it looks beyond the end: where `terminated` is True nothing follows
# in: the solution of look_ahead
# - future = 0.0 if terminated else look_ahead(model, next_state, depth - 1)
# + future = look_ahead(model, next_state, depth - 1)

# %% no probabilities
# says: the probabilities are left out
# in: the solution of look_ahead
# - value += probability * (reward + 0.9 * future)
# + value += reward + 0.9 * future

# %% one outcome
# says: only the first outcome of each action is looked at
# in: the solution of look_ahead
# - value += probability * (reward + 0.9 * future)
# + value += reward + 0.9 * future
# + break

# %% too far
# says: it looks one step too far: with 0 steps left the value is 0
# in: the solution of look_ahead
# - if depth == 0:
# + if depth < 0:

# %% too short
# says: it looks one step too short
# in: the solution of look_ahead
# - if depth == 0:
# + if depth == 1:

# %% no discount
# says: γ is left out
# in: the solution of look_ahead
# - value += probability * (reward + 0.9 * future)
# + value += probability * (reward + future)

# %% all discounted
# says: the first reward is discounted, too; γ only stands before what follows
# in: the solution of look_ahead
# - value += probability * (reward + 0.9 * future)
# + value += probability * 0.9 * (reward + future)

# %% the last reward alone
# says: only the last reward counts; each step's is added
# in: the solution of look_ahead
# - value += probability * (reward + 0.9 * future)
# + value += probability * ((reward if depth == 1 else 0) + 0.9 * future)

# %% no return
# says: is a `return` missing?
# in: the solution of look_ahead
# - return max(values)
# + max(values)

# %% a number
# says: model, state and depth
look_ahead = 12
