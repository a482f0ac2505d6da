# %% counts last
# says: Right: one number more, and the next state depends on the state and the action alone again. See it learn:
def transition(self, state, action, rng):
    t, d, c = state
    u = rng.random()
    if action == 2:
        d = 0 if u < 0.9 else max(d - 1, 0)
    elif action == 1 and c < 2:
        if u < 0.7:
            d = max(d - 1, 0)
    elif u < 0.5:
        d = min(d + 1, 2)
    return t + 1, d, min(c + (action == 1), 2)


# %% an unheard chime becomes silence
def transition(self, state, action, rng):
    time, depth, chimes = state
    count = chimes
    if action == 1:
        count = min(chimes + 1, 2)
        if chimes == 2:
            action = 0
    luck = rng.random()
    if action == 0 and luck < 0.5:
        depth += 1
    if action == 1 and luck < 0.7:
        depth -= 1
    if action == 2:
        depth = 0 if luck < 0.9 else depth - 1
    return time + 1, max(0, min(2, depth)), count


# %% the space in numbers
@property
def observation_space(self):
    return MultiDiscrete([9, 3, 3])
