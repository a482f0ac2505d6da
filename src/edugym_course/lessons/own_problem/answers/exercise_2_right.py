# %% in one line
# says: Right: what is given on the way to a state is taken back when it is left. Here are both policies:
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    return reward + discount * (0 if terminated else potential(next_state)) - potential(state)


# %% with if
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    if terminated:
        return reward - potential(state)
    return reward + discount * potential(next_state) - potential(state)


# %% by multiplying
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    return reward + discount * potential(next_state) * (1 - terminated) - potential(state)


# %% other names
def shaped_reward(r, phi, s, s2, end, gamma):
    F = -phi(s)
    if not end:
        F += gamma * phi(s2)
    return r + F


# %% with NumPy
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    after = np.where(terminated, 0.0, potential(next_state))
    return reward + discount * after - potential(state)


# %% a helper inside
def shaped_reward(reward, potential, state, next_state, terminated, discount):
    def phi(s, end=False):
        return 0.0 if end else potential(s)

    return reward + discount * phi(next_state, terminated) - phi(state)


# %% a lambda
shaped_reward = lambda r, p, s, n, end, g: r - p(s) + g * p(n) * (not end)
