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


# %% with a flag
def transition(self, state, action, rng):
    time, depth, chimes = state
    heard = action == 1 and chimes != 2
    luck = rng.random()
    if action == 2:
        depth = 0 if luck < 0.9 else max(depth - 1, 0)
    elif heard:
        depth = max(depth - 1, 0) if luck < 0.7 else depth
    else:
        depth = min(depth + 1, 2) if luck < 0.5 else depth
    if action == 1 and chimes < 2:
        chimes += 1
    return (time + 1, depth, chimes)


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


# %% by the method of Morning
def transition(self, state, action, rng):
    time, depth, chimes = state
    what = 0 if action == 1 and chimes == 2 else action
    time, depth = Morning().transition((time, depth), what, rng)
    return time, depth, chimes + 1 if action == 1 and chimes < 2 else chimes


# %% the space in numbers
@property
def observation_space(self):
    return MultiDiscrete([9, 3, 3])


# %% the start as a tuple
def initial(self, rng):
    return (0, 2, 0)


# %% the space as an array
@property
def observation_space(self):
    return MultiDiscrete(np.array([self.length + 1, 3, 3]))


def initial(self, rng):
    return tuple([0, 2, 0])
