# %% the old rewards
# says: the rewards are the old ones, of a goal that was missed: ask for each step anew whether it reaches the *new*
#   goal
def final(steps):
    goal = steps[-1][2]
    return [(s, goal, a, -1.0, then, then == goal) for s, a, then in steps]


# %% zeros
# says: every step is paid 0; only one that reaches the goal is
def final(steps):
    goal = steps[-1][2]
    return [(s, goal, a, 0.0, then, then == goal) for s, a, then in steps]


# %% one at the goal
# says: a step that reaches its goal is paid 0, not 1: hindsight keeps the reward of the task
def final(steps):
    goal = steps[-1][2]
    return [(s, goal, a, 1.0 if then == goal else -1.0, then, then == goal) for s, a, then in steps]


# %% one and zero
# says: the task pays 0 at the goal and −1 elsewhere, not 1 and 0
def final(steps):
    goal = steps[-1][2]
    return [(s, goal, a, float(then == goal), then, then == goal) for s, a, then in steps]


# %% the last one only
# says: an earlier step may reach the same pattern: look for the reward at every next state, not at the last one only
def final(steps):
    goal = steps[-1][2]
    return [
        (s, goal, a, 0.0 if t == len(steps) - 1 else -1.0, then, then == goal) for t, (s, a, then) in enumerate(steps)
    ]


# %% by the state
# says: the reward depends on the *next* state, not on the state before the step
def final(steps):
    goal = steps[-1][2]
    return [(s, goal, a, 0.0 if s == goal else -1.0, then, then == goal) for s, a, then in steps]


# %% the wrong way round
# says: the rewards are the wrong way round: −1 costs, 0 is for the goal
def final(steps):
    goal = steps[-1][2]
    return [(s, goal, a, 0.0 if then != goal else -1.0, then, then == goal) for s, a, then in steps]


# %% a cost
# says: a step that misses costs 1: its reward is −1
def final(steps):
    goal = steps[-1][2]
    return [(s, goal, a, 0.0 if then == goal else 1.0, then, then == goal) for s, a, then in steps]


# %% never ends
# says: no step terminates; with the new goal the episode would have ended there, and nothing comes after it
def final(steps):
    goal = steps[-1][2]
    return [(s, goal, a, 0.0 if then == goal else -1.0, then, False) for s, a, then in steps]


# %% ends once
# says: not only the last step terminates: an earlier one that reaches the same pattern does as well
def final(steps):
    goal = steps[-1][2]
    return [
        (s, goal, a, 0.0 if then == goal else -1.0, then, t == len(steps) - 1) for t, (s, a, then) in enumerate(steps)
    ]


# %% always ends
# says: every step terminates; only one that reaches the goal does
def final(steps):
    goal = steps[-1][2]
    return [(s, goal, a, 0.0 if then == goal else -1.0, then, True) for s, a, then in steps]


# %% ends by the state
# says: a step terminates when its *next* state is the goal, not its state
def final(steps):
    goal = steps[-1][2]
    return [(s, goal, a, 0.0 if then == goal else -1.0, then, s == goal) for s, a, then in steps]


# %% goes on at the goal
# says: `terminated` is the wrong way round: True where the goal is reached
def final(steps):
    goal = steps[-1][2]
    return [(s, goal, a, 0.0 if then == goal else -1.0, then, then != goal) for s, a, then in steps]


# %% before the last step
# says: the goal is the last *next* state, not the state before the last step
def final(steps):
    goal = steps[-1][0]
    return [(s, goal, a, 0.0 if then == goal else -1.0, then, then == goal) for s, a, then in steps]


# %% the first step
# says: the goal is what the *last* step achieved, not the first
def final(steps):
    goal = steps[0][2]
    return [(s, goal, a, 0.0 if then == goal else -1.0, then, then == goal) for s, a, then in steps]


# %% the start
# says: the goal is the start of the episode; take what its last step achieved
def final(steps):
    goal = steps[0][0]
    return [(s, goal, a, 0.0 if then == goal else -1.0, then, then == goal) for s, a, then in steps]


# %% its own goal
# says: each step has another goal, the one that it achieves itself; 'final' has one goal for the whole episode
def final(steps):
    return [(s, then, a, 0.0, then, True) for s, a, then in steps]


# %% without the last
# says: the last step is missing
def final(steps):
    goal = steps[-1][2]
    return [(s, goal, a, 0.0 if then == goal else -1.0, then, then == goal) for s, a, then in steps[:-1]]


# %% the last alone
# says: only the last step is there; the others are learned for the new goal too
def final(steps):
    goal = steps[-1][2]
    return [(s, goal, a, 0.0 if then == goal else -1.0, then, then == goal) for s, a, then in steps[-1:]]


# %% backwards
# says: the steps come in reverse order; keep the order of the episode
def final(steps):
    goal = steps[-1][2]
    return [(s, goal, a, 0.0 if then == goal else -1.0, then, then == goal) for s, a, then in steps[::-1]]


# %% two mistakes
# says: the rewards are the old ones, of a goal that was missed: ask for each step anew whether it reaches the *new*
#   goal; and no step terminates; with the new goal the episode would have ended there, and nothing comes after it
def final(steps):
    goal = steps[-1][2]
    return [(s, goal, a, -1.0, then, False) for s, a, then in steps]


# %% the distance
# says: the reward counts the switches that are wrong; the task pays the same for every step that misses
def final(steps):
    goal = steps[-1][2]
    return [(s, goal, a, -float(bin(then ^ goal).count("1")), then, then == goal) for s, a, then in steps]


# %% too few numbers
# says: should give a list of transitions (state, goal, action, reward, next_state, terminated), but one of them is
def final(steps):
    goal = steps[-1][2]
    return [(s, a, 0.0 if then == goal else -1.0, then, then == goal) for s, a, then in steps]


# %% changes what it is given
# says: changes its list `steps`; make a new one, for the caller still needs the old one
def final(steps):
    goal = steps[-1][2]
    for t, (s, a, then) in enumerate(steps):
        steps[t] = (s, goal, a, 0.0 if then == goal else -1.0, then, then == goal)
    return steps


# %% nothing is returned
# says: gives None: is a `return` missing?
def final(steps):
    goal = steps[-1][2]
    [(s, goal, a, -1.0, then, then == goal) for s, a, then in steps]


# %% one step twice
# says: transitions, but gives
# says: that is none of the usual mistakes, so go through the episode by hand, step by step
def final(steps):
    goal = steps[-1][2]
    made = [(s, goal, a, 0.0 if then == goal else -1.0, then, then == goal) for s, a, then in steps]
    return [*made, made[0]]


# %% what the function returns
# says: final should be a function of steps, but is of the type list
final = []


# %% a single number
# says: but one of them is 3
def final(steps):
    return 3


# %% the same object
# says: `is` asks whether two numbers are the same object, and large ones that are equal need not be: write `==`
def final(steps):
    goal = steps[-1][2]
    return [(s, goal, a, 0.0 if then is goal else -1.0, then, then is goal) for s, a, then in steps]


# %% three switches
# says: that is none of the usual mistakes, so go through the episode by hand, step by step
def final(steps):
    goal = steps[-1][2] % 8
    return [(s, goal, a, 0.0 if then == goal else -1.0, then, then == goal) for s, a, then in steps]


# %% a text as the goal
# says: should give transitions of numbers, but one of these holds the text
def final(steps):
    goal = bin(steps[-1][2])
    return [(s, goal, a, 0.0 if bin(then) == goal else -1.0, then, bin(then) == goal) for s, a, then in steps]


# %% returns in the loop
# says: only the first step is there: is the `return` inside of the loop?
def final(steps):
    goal, made = steps[-1][2], []
    for s, a, then in steps:
        made.append((s, goal, a, 0.0 if then == goal else -1.0, then, then == goal))
        return made


# %% ends where the goal is
# says: the steps after the first that reaches the goal are missing: learn all of them
def final(steps):
    goal, made = steps[-1][2], []
    for s, a, then in steps:
        made.append((s, goal, a, 0.0 if then == goal else -1.0, then, then == goal))
        if then == goal:
            break
    return made


# %% the goal after the action
# says: the entries stand in another order; it is (state, goal, action, reward, next_state, terminated)
def final(steps):
    goal = steps[-1][2]
    return [(s, a, goal, 0.0 if then == goal else -1.0, then, then == goal) for s, a, then in steps]


# %% without the first
# says: the first step is missing; it has the index 0
def final(steps):
    goal = steps[-1][2]
    return [(s, goal, a, 0.0 if then == goal else -1.0, then, then == goal) for s, a, then in steps[1:]]


# %% those that reach it
# says: only the steps that reach the goal are there; the others are learned for it too
def final(steps):
    goal = steps[-1][2]
    return [(s, goal, a, 0.0, then, True) for s, a, then in steps if then == goal]


# %% sorted
# says: the transitions are right, and do not stand in the order of the episode
def final(steps):
    goal = steps[-1][2]
    return sorted((s, goal, a, 0.0 if then == goal else -1.0, then, then == goal) for s, a, then in steps)


# %% the state twice
# says: ; over all episodes next_state alone differs
def final(steps):
    goal = steps[-1][2]
    return [(s, goal, a, 0.0 if then == goal else -1.0, s, then == goal) for s, a, then in steps]


# %% the highest pattern
# says: ; over all episodes goal and reward and terminated differ
def final(steps):
    goal = max(then for _, _, then in steps)
    return [(s, goal, a, 0.0 if then == goal else -1.0, then, then == goal) for s, a, then in steps]


# %% ends the first time
# says: not only the first step that reaches the goal terminates: a later one that reaches it again does as well
def final(steps):
    goal, over, made = steps[-1][2], False, []
    for s, a, n in steps:
        made.append((s, goal, a, 0.0 if n == goal else -1.0, n, n == goal and not over))
        over = over or n == goal
    return made
