# %% by loops
# says: Right: pessimistic about each action, and then the best of them.
def maxmin_target(tables, reward, next_state, terminated, discount):
    if terminated:
        return reward
    n_tables, _, n_actions = tables.shape
    pessimistic = [min(tables[i, next_state, a] for i in range(n_tables)) for a in range(n_actions)]
    return reward + discount * max(pessimistic)


# %% the whole minimum first
def maxmin_target(tables, reward, next_state, terminated, discount):
    Q = np.min(tables, axis=0)
    return reward + (not terminated) * discount * np.max(Q[next_state])
