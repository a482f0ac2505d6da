# %% bootstraps after the end
# says: a terminal state has no future: leave its value out when `terminated`
def target(reward, values, discount, terminated):
    return reward + discount * max(values)


# %% no discount
# says: the value of the next state is not discounted
def target(reward, values, discount, terminated):
    return reward if terminated else reward + max(values)


# %% the mean
# says: the mean over the actions stands where the maximum should
def target(reward, values, discount, terminated):
    return reward if terminated else reward + discount * sum(values) / len(values)


# %% no reward
# says: the reward is missing
def target(reward, values, discount, terminated):
    return 0.0 if terminated else discount * max(values)


# %% a number
# says: reward, values, discount and terminated
target = 3.0
