# %% in one line
# says: Right: what is given on the way to a state is taken back when it is left. Here are both policies:
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    return reward + discount * (0 if terminated else potential(next_state)) - potential(state)


# %% other names
def shaped_reward(r, phi, s, s2, end, gamma):
    F = -phi(s)
    if not end:
        F += gamma * phi(s2)
    return r + F


# %% a lambda
shaped_reward = lambda r, p, s, n, end, g: r - p(s) + g * p(n) * (not end)
