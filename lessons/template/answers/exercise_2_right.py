# %% with a condition
# says: Right: what comes after the end of an episode counts nothing.
def target(reward, values, discount, terminated):
    return reward if terminated else reward + discount * max(values)


# %% with a factor
def target(reward, values, discount, terminated):
    return reward + (1 - terminated) * discount * np.max(values)
