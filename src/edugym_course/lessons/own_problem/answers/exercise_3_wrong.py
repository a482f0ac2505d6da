# %% three chimes work
# says: she hears every chime; after two of them a chime should be like silence (is it `chimes < 2`?)
# says: , rng) should lead to
# in: the solution of transition
# - elif action == 1 and chimes < 2:
# + elif action == 1 and chimes <= 2:


# %% deaf to rings too
# says: after two chimes a ring does nothing any more: she is deaf to chimes only
# in: the solution of transition
# - if action == 2:
# + if action == 2 and chimes < 2:


# %% counted first
# says: the second chime does nothing any more: look at how many chimes came *before* this one
def transition(self, state, action, rng):
    time, depth, chimes = state
    if action == 1:
        chimes = min(chimes + 1, 2)
    luck = rng.random()
    if action == 2:
        depth = 0 if luck < 0.9 else max(depth - 1, 0)
    elif action == 1 and chimes < 2:
        depth = max(depth - 1, 0) if luck < 0.7 else depth
    else:
        depth = min(depth + 1, 2) if luck < 0.5 else depth
    return time + 1, depth, chimes


# %% rings are counted
# says: rings are counted as well; count chimes only
# in: the solution of transition
# - if action == 1:
# + if action != 0:


# %% every step is counted
# says: every action is counted; count a chime only
# in: the solution of transition
# - if action == 1:
# -     chimes = min(chimes + 1, 2)
# - return time + 1, depth, chimes
# + return time + 1, depth, min(chimes + 1, 2)


# %% never counted
# says: chimes are not counted: the third number has to grow with every chime
# in: the solution of transition
# - if action == 1:
# -     chimes = min(chimes + 1, 2)


# %% the count goes on
# says: the count goes on above 2, and leaves the observation space: keep it at 2
# in: the solution of transition
# - if action == 1:
# -     chimes = min(chimes + 1, 2)
# - return time + 1, depth, chimes
# + return time + 1, depth, chimes + (action == 1)


# %% silence sets it back
# says: the count is set back by another action; she does not unlearn what she is used to
# in: the solution of transition
# - if action == 1:
# -     chimes = min(chimes + 1, 2)
# - return time + 1, depth, chimes
# + return time + 1, depth, min(chimes + 1, 2) if action == 1 else 0


# %% an unheard chime changes nothing
# says: a chime that she does not hear leaves her sleep as it is; it should be like silence, in which it gets deeper
# in: the solution of transition
# - elif action == 1 and chimes < 2:
# -     depth = max(depth - 1, 0) if luck < 0.7 else depth
# + elif action == 1:
# +     if chimes < 2:
# +         depth = max(depth - 1, 0) if luck < 0.7 else depth


# %% not counted while she is awake
# says: a chime counts also when she is awake
# in: the solution of transition
# - luck = rng.random()
# + luck = rng.random()
# + before = depth
# - if action == 1:
# + if action == 1 and before > 0:


# %% time stands still
# says: the time stands still: the first number has to grow by 1
# in: the solution of transition
# - return time + 1, depth, chimes
# + return time, depth, chimes


# %% the old method
# says: too many values to unpack
def transition(self, state, action, rng):
    time, depth = state
    luck = rng.random()
    if action == 2:
        depth = 0 if luck < 0.9 else max(depth - 1, 0)
    elif action == 1:
        depth = max(depth - 1, 0) if luck < 0.7 else depth
    else:
        depth = min(depth + 1, 2) if luck < 0.5 else depth
    return time + 1, depth


# %% the count is left out of what is returned
# says: should return three numbers in a tuple, (time, depth, chimes), but returns
# in: the solution of transition
# - if action == 1:
# -     chimes = min(chimes + 1, 2)
# - return time + 1, depth, chimes
# + return time + 1, depth


# %% no return
# says: is a `return` missing
def transition(self, state, action, rng):
    time, depth, chimes = state
    chimes = min(chimes + (action == 1), 2)


# %% the old start
# says: initial(rng) should return three numbers
def initial(self, rng):
    return 0, 2


# %% a start with chimes
# says: initial should return (0, 2, 0), fast asleep and no chime yet, but returns
def initial(self, rng):
    return 0, 2, 2


# %% two values for the count
# says: observation_space should be MultiDiscrete([self.length + 1, 3, 3]), one number for each part of the state, but
#   is
@property
def observation_space(self):
    return MultiDiscrete([self.length + 1, 3, 2])


# %% a value of the class
# says: should be the class
class UsedToIt(NamedTuple):
    length: int = 8


UsedToIt = UsedToIt()


# %% parameters exchanged
# says: transition of UsedToIt must take (self, state, action, rng)
# in: the solution of transition
# - def transition(self, state, action, rng):
# + def transition(self, action, state, rng):
# - if action == 1:
# -     chimes = min(chimes + 1, 2)
# - return time + 1, depth, chimes
# + return time + 1, depth, min(chimes + (action == 1), 2)


# %% the count is hidden
# says: should be the whole state, but is
# says: that method was right as it was, for only `observation_space`, `initial` and `transition` change
def observation(self, state, rng):
    return state[0], state[1], 0


# %% another end
# says: terminal((7, 0, 0)) should be False
def terminal(self, state):
    return state[0] >= self.length - 1


# %% pay for chimes
# says: reward((0, 0, 0), 0, (1, 1, 0), rng) should be 1, but is 0
# in: the solution of reward
# - reward = float(next_state[1])
# + reward = float(next_state[2])


# %% a quarter
# says: her depth is wrong: in silence, and with a chime that she does not hear, her sleep gets one step deeper with
#   probability 0.5, and 2 is the deepest
def transition(self, state, action, rng):
    time, depth, chimes = state
    if rng.random() < 0.25:
        depth = max(depth - 1, 0)
    return time + 1, depth, chimes


# %% too deep
# says: her depth is wrong: in silence, and with a chime that she does not hear, her sleep gets one step deeper with
#   probability 0.5, and 2 is the deepest
# in: the solution of transition
# - else:
# -     depth = min(depth + 1, 2) if luck < 0.5 else depth
# - if action == 1:
# -     chimes = min(chimes + 1, 2)
# + else:
# +     depth = depth + 1 if luck < 0.5 else depth
# + chimes = min(chimes + (action == 1), 2)


# %% a chime wakes her
# says: her depth is wrong: a chime that she hears makes her sleep one step lighter with probability 0.7
# in: the solution of transition
# - depth = max(depth - 1, 0) if luck < 0.7 else depth
# + depth = 0 if luck < 0.7 else depth
# - if action == 1:
# -     chimes = min(chimes + 1, 2)
# + chimes = min(chimes + (action == 1), 2)


# %% a ring is sure
# says: her depth is wrong: a ring wakes her with probability 0.9, and else makes her sleep one step lighter
# in: the solution of transition
# - depth = 0 if luck < 0.9 else max(depth - 1, 0)
# + depth = 0
# - if action == 1:
# -     chimes = min(chimes + 1, 2)
# + chimes = min(chimes + (action == 1), 2)


# %% two steps of time
# says: the time, the first number, should grow by 1
# in: the solution of transition
# - if action == 1:
# -     chimes = min(chimes + 1, 2)
# - return time + 1, depth, chimes
# + chimes = min(chimes + (action == 1), 2)
# + return time + 2, depth, chimes


# %% another order
# says: depth and chimes have changed places
# in: the solution of transition
# - if action == 1:
# -     chimes = min(chimes + 1, 2)
# - return time + 1, depth, chimes
# + chimes = min(chimes + (action == 1), 2)
# + return time + 1, chimes, depth


# %% chimes count twice
# says: the third number is wrong: every chime counts, whether she hears it or not, up to 2, and nothing else does
# in: the solution of transition
# - if action == 1:
# -     chimes = min(chimes + 1, 2)
# + chimes = min(chimes + 2 * (action == 1), 2)


# %% chimes that work
# says: the third number is wrong: every chime counts, whether she hears it or not, up to 2, and nothing else does
# in: the solution of transition
# - if action == 1:
# -     chimes = min(chimes + 1, 2)
# + chimes = min(chimes + (action == 1 and luck < 0.3), 2)


# %% the last chime is not heard
# says: transition((7, 0, 0), 1, rng) should lead to (8, 0, 1) (p = 1), but leads to
# in: the solution of transition
# - elif action == 1 and chimes < 2:
# + elif action == 1 and chimes < 2 and time < self.length - 1:
