# %% the whole episode
# says: steps before t are drawn too; what was achieved before a step is not its future
def future_goal(steps, t, rng):
    return steps[rng.integers(len(steps))][2]


# %% without itself
# says: the step t itself is never drawn; it achieves a pattern too
def future_goal(steps, t, rng):
    return steps[rng.integers(t + 1, max(t + 2, len(steps)))][2]


# %% without the last
# says: the last step is never drawn: `rng.integers(t, n)` leaves n out, not n − 1
def future_goal(steps, t, rng):
    return steps[rng.integers(t, len(steps) - 1)][2]


# %% the state before
# says: the pattern *before* the step that was drawn is taken; the step achieves its next state
def future_goal(steps, t, rng):
    return steps[rng.integers(t, len(steps))][0]


# %% final
# says: that is 'final': always what the last step achieved
def future_goal(steps, t, rng):
    return steps[-1][2]


# %% its own
# says: it is always what step t itself achieved; draw one of the steps from t on
def future_goal(steps, t, rng):
    return steps[t][2]


# %% each pattern once
# says: every *pattern* is as likely, and every *step* should be
def future_goal(steps, t, rng):
    return rng.choice(sorted({then for _, _, then in steps[t:]}))


# %% the number of the step
# says: that is the number of the step that was drawn; its next state is wanted
def future_goal(steps, t, rng):
    return rng.integers(t, len(steps))


# %% the past
# says: only steps up to t are drawn: what was achieved until then, and not from then on
def future_goal(steps, t, rng):
    return steps[rng.integers(t + 1)][2]


# %% a step
# says: should give the number of a pattern, a whole number, but gives (
def future_goal(steps, t, rng):
    return steps[rng.integers(t, len(steps))]


# %% its own random numbers
# says: does not draw its random numbers from `rng`
def future_goal(steps, t, rng):
    return steps[np.random.randint(t, len(steps))][2]


# %% another start
# says: , the same pattern in every call, for it takes no random number from `rng`
def future_goal(steps, t, rng):
    return steps[0][0]


# %% past the end
# says: should give a pattern from 0 to 7, but gives 8
def future_goal(steps, t, rng):
    return 8


# %% a number
# says: steps, t and rng
future_goal = 3


# %% a new generator in each call, which draws the last step first
# says: , the same pattern in every call, for it takes no random number from `rng`: is a new generator made in it, or none
#   used?
def future_goal(steps, t, rng):
    rng = np.random.default_rng(0)
    return steps[rng.integers(t, len(steps))][2]


# %% two steps at most
# says: future_goal(steps, t, rng)
# says: , where t = 2 and steps = [
# says: of calls, which is none of the usual mistakes
def future_goal(steps, t, rng):
    return steps[rng.integers(t, min(t + 2, len(steps)))][2]


# %% without t
# says: the draw begins at step 0, and so ends too early: add t to what is drawn
def future_goal(steps, t, rng):
    return steps[rng.integers(len(steps) - t)][2]


# %% the action
# says: that is the *action* of the step that was drawn; its next state is wanted
def future_goal(steps, t, rng):
    return steps[rng.integers(t, len(steps))][1]


# %% in place
# says: changes its list `steps`; make a new one, for the caller still needs the old one
def future_goal(steps, t, rng):
    del steps[:t]
    return steps[rng.integers(len(steps))][2]


# %% rounded
# says: which is none of the usual mistakes: the right patterns come, and not as often as they should
def future_goal(steps, t, rng):
    return steps[round(rng.uniform(t, len(steps) - 1))][2]
