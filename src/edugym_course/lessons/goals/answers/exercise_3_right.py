# %% a whole number
# says: Right: every step from t on is as likely. The pattern that it reached is a goal that step t was on the way to.
def future_goal(steps, t, rng):
    return steps[rng.integers(t, len(steps))][2]


# %% a number from 0 to 1
def future_goal(steps, t, rng):
    return steps[t + int(rng.random() * (len(steps) - t))][2]


# %% one of a list
def future_goal(steps, t, rng):
    return rng.choice([then for _, _, then in steps[t:]])
