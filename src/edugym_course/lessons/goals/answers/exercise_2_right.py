# %% a list of transitions
# says: Right: the steps are those that were taken, and the reward function is that of the task. Only the goal is new.
def final(steps):
    goal = steps[-1][-1]
    return [(s, goal, a, -1.0 + (then == goal), then, then == goal) for s, a, then in steps]


# %% one after the other, with `if`
def final(steps):
    _, _, goal = steps[len(steps) - 1]
    made = []
    for step in steps:
        if step[2] == goal:
            made.append([step[0], goal, step[1], 0, step[2], True])
        else:
            made.append([step[0], goal, step[1], -1, step[2], False])
    return made


# %% a generator
def final(steps):
    goal = steps[-1][2]
    for s, a, then in steps:
        yield s, goal, a, float(np.where(then == goal, 0, -1)), then, then == goal


# %% an array
def final(steps):
    s, a, then = np.array(steps).T
    reached = then == then[-1]
    return np.column_stack([s, 0 * s + then[-1], a, reached - 1.0, then, reached])
