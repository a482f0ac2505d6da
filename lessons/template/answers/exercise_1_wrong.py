# %% nothing
# says: Not solved yet
best_return = ...

# %% without the last reward
# says: that is what the road costs before the last step, which pays 1
best_return = -3

# %% the other sign
# says: the sign is wrong
best_return = 2

# %% anything else
# says: best_return is not 7
best_return = 7

# %% not a number
# says: best_return should be a number
best_return = "-2"
