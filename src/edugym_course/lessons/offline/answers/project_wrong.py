# %% first values of zero
# says: the middle one of
# says: runs makes a clock worth
# says: , and it should be worth
# says: it has learned, but too little. In a log-book of our making
# says: what was never tried gets the lowest value, −90, and not 0
# in: sums and counts
# - Q = np.where(counts > 0, np.maximum(lowest, sums / n - 2.0 / np.sqrt(n)), lowest)
# + Q = np.where(counts > 0, sums / n - 2.0 / np.sqrt(n), 0.0)

# %% the worst action
# says: that is worse than the clock that collected the nights; does it take the *best* action, by its own state, and is no sign wrong?
# in: sums and counts
# - return lambda state: int(Q[state].argmax())
# + return lambda state: int(Q[state].argmin())

# %% few steps
# says: it has learned, but too little
# in: sums and counts
# - for s, a, *_ in steps:
# + steps = steps[:100]
# + for s, a, *_ in steps:

# %% imitation
# says: what counts is the *mean* of the targets, not their sum or their number; a penalty is small beside that
# in: sums and counts
# - Q = np.where(counts > 0, np.maximum(lowest, sums / n - 2.0 / np.sqrt(n)), lowest)
# + Q = counts

# %% always quiet
# says: it chooses the same action in every state, as it does where all values of a state are equal; does nothing follow where `terminated` is True (else all values sink), do they change from sweep to sweep, are they looked up in the state to which they belong, and is the best action taken?
def my_program(steps, n_states, n_actions, seed):
    return lambda state: 0


# %% one sweep
# says: a target is R (in the last step, too) plus the value of the *next* state, without discount, with new sums in each sweep, and ten sweeps or more. (Or are values whole numbers, as in np.full(..., -90)?)
# in: sums and counts
# - for _ in range(30):
# + for _ in range(1):


# %% the table
# says: should return a function from a state to an action, but what it returns is
def my_program(steps, n_states, n_actions, seed):
    return np.zeros((n_states, n_actions))


# %% nothing comes back
# says: (steps, 31, 3,
# says: gives None: return the policy, a function from a state to an action
# in: sums and counts
# - return lambda state: int(Q[state].argmax())
# + policy = lambda state: int(Q[state].argmax())

# %% an action that is not there
# says: , for the state
# in: sums and counts
# - return lambda state: int(Q[state].argmax())
# + return lambda state: 3

# %% a list
# says: steps, n_states, n_actions and seed
my_program = [0, 1, 2]

# %% beyond the end
# slow
# says: does nothing follow where `terminated` is True (else all values sink)
# in: sums and counts
# - for _ in range(30):
# + for _ in range(300):
# - sums[s, a] += r if terminated else r + V[after]
# + sums[s, a] += r + V[after]

# %% no penalty
# says: , which is enough (ours
# says: ). But in another log-book
# says: , and in the first state the program takes action
# says: instead of
# says: what rests on one step is little to go by: *subtract* a penalty, the larger the fewer the steps with this state *and* action
# in: sums and counts
# - Q = np.where(counts > 0, np.maximum(lowest, sums / n - 2.0 / np.sqrt(n)), lowest)
# + Q = np.where(counts > 0, np.maximum(lowest, sums / n), lowest)

# %% the mean of the next row
# says: the value of the next state is the *largest* of its row
# in: sums and counts
# - V = Q.max(axis=1)
# + V = Q.mean(axis=1)

# %% the last reward
# says: every step counts in the mean of its pair, with its own reward and next state (+= adds, and = forgets)
# in: sums and counts
# - sums[s, a] += r if terminated else r + V[after]
# + sums[s, a] = counts[s, a] * (r if terminated else r + V[after])

# %% only what was done six times
# says: does the program learn from *all* nights, from the first to the last, and from those of a rare pair? (With a learning rate that does not fall, what is learned last counts more than in a mean.)
# in: sums and counts
# - Q = np.where(counts > 0, np.maximum(lowest, sums / n - 2.0 / np.sqrt(n)), lowest)
# + Q = np.where(counts > 5, np.maximum(lowest, sums / n - 2.0 / np.sqrt(n)), lowest)

# %% actions are drawn
# says: returns draws its actions: asked twice about one state
# says: cases. It should take the *best* action, and never a random one
# in: sums and counts
# - return lambda state: int(Q[state].argmax())
# + rng = np.random.default_rng(seed)
# + return lambda state: int(rng.choice(n_actions))


# %% a median
# says: action 0 led in 25 nights to a state that brought 3, and in 15 to another that cost 20
# says: what is seldom counts in the mean, too; a median forgets it, and so does the most frequent next state. (Or is an action that was never tried worth 0 in the targets, where it should be worth −90?)
def my_program(steps, n_states, n_actions, seed):
    seen = {}
    for s, a, *step in steps:
        seen.setdefault((s, a), []).append(step)
    V, Q = np.zeros(n_states), np.full((n_states, n_actions), -90.0)
    for _ in range(12):
        for pair, lines in seen.items():
            targets = [r if terminated else r + V[after] for r, after, terminated in lines]
            Q[pair] = max(-90.0, np.median(targets) - 2.0 / np.sqrt(len(targets)))
        V = Q.max(axis=1)
    return lambda state: int(Q[state].argmax())


# %% the lowest reward
# says: action 1 cost 5 in each step of 40 nights, action 2 cost 7, and action 0 was never tried
# says: what was never tried gets the lowest value, −90, and not 0 or the lowest *reward*
# in: sums and counts
# - Q = np.where(counts > 0, np.maximum(lowest, sums / n - 2.0 / np.sqrt(n)), lowest)
# + Q = np.where(counts > 0, np.maximum(lowest, sums / n - 2.0 / np.sqrt(n)), min(step[2] for step in steps))

# %% a penalty in the end only
# says: action 0 leads to a state in which action 0 brought 1 in 39 nights and action 2 brought 1.1 in one
# says: the penalty is part of the value of the next state, too: subtract it in each sweep, not only in the end
# in: sums and counts
# - Q = np.where(counts > 0, np.maximum(lowest, sums / n - 2.0 / np.sqrt(n)), lowest)
# + Q = np.where(counts > 0, np.maximum(lowest, sums / n), lowest)
# - return lambda state: int(Q[state].argmax())
# + return lambda state: int((Q[state] - 2.0 / np.sqrt(n[state])).argmax())


# %% the most frequent next state
# says: what is seldom counts in the mean, too; a median forgets it, and so does the most frequent next state. (Or is an action that was never tried worth 0 in the targets, where it should be worth −90?)
def my_program(steps, n_states, n_actions, seed):
    found = {}
    for s, a, *step in steps:
        found.setdefault((s, a), []).append(step)
    Q = np.full((n_states, n_actions), -90.0)
    for _ in range(12):
        V = np.where(Q.max(axis=1) > -90.0, Q.max(axis=1), 0.0)
        for pair, lines in found.items():
            afters = [after for _, after, _ in lines]
            reward = np.mean([line[0] for line in lines]) - 2.0 / np.sqrt(len(lines))
            Q[pair] = reward + V[max(set(afters), key=afters.count)]
    return lambda state: int(Q[state].argmax())


# %% half of the nights
# says: action 0 leads to one of 14 states, in each of which one action brought 10, in two nights alone, and another cost 80; action 1 leads to a state that brought 6 in each of 10 nights
# says: does the program learn from *all* nights, from the first to the last, and from those of a rare pair? (With a learning rate that does not fall, what is learned last counts more than in a mean.)
# in: sums and counts
# - for s, a, *_ in steps:
# + steps = steps[: len(steps) // 2]
# + for s, a, *_ in steps:

# %% the last night is left out
# says: action 0 cost 80 in the first night and brought 3 in 24 others, action 2 cost 80 in the last night and brought 3 in 24 others, and action 1 brought 0 in each of 30
# says: the first night counts, and so does the last
# in: sums and counts
# - for s, a, *_ in steps:
# + steps = steps[:-10]
# + for s, a, *_ in steps:

# %% what was never tried is worth the mean of the others
# says: action 2 cost 5 at once in each of 80 nights, and the other two were never tried
# says: what was never tried is worth −90: what another action of its state brought tells nothing of it
# in: sums and counts
# - V = Q.max(axis=1)
# + tried = np.where(counts > 0, Q, 0.0).sum(axis=1) / np.maximum(1, (counts > 0).sum(axis=1))
# + Q = np.where((counts > 0) | (counts.sum(axis=1, keepdims=True) == 0), Q, tried[:, None])
# + V = Q.max(axis=1)

# %% no penalty in the last step
# says: action 0 leads to a last step in which action 0 brought 1 in 39 nights and action 2 brought 1.1 in one, and action 2 to a last step that brought 1.05 in each of 40
# says: the penalty belongs to the last step of a night, too
# in: sums and counts
# - counts[s, a] += 1
# + counts[s, a] += 1
# + ends = {(s, a) for s, a, _, _, terminated in steps if terminated}
# + last = np.array([[(s, a) in ends for a in range(n_actions)] for s in range(n_states)])
# - Q = np.where(counts > 0, np.maximum(lowest, sums / n - 2.0 / np.sqrt(n)), lowest)
# + Q = np.where(counts > 0, np.maximum(lowest, sums / n - 2.0 / np.sqrt(n) * ~last), lowest)

# %% equal steps count once
# says: every step counts in the mean of its pair, with its own reward and next state (+= adds, and = forgets)
# in: sums and counts
# - counts = np.zeros(shape)
# + counts, steps = np.zeros(shape), sorted(set(steps))

# %% the index among the actions that were tried
# says:  (It misses
# says:  such log-books, so
# says: look at what is simple first: the index of each count and value, whether every step is used, and what the policy returns
# in: sums and counts
# - return lambda state: int(Q[state].argmax())
# + return lambda state: int(Q[state][counts[state] > 0].argmax()) if counts[state].any() else 0

# %% whole numbers by the lowest value
# says: (Or are values whole numbers, as in np.full(..., -90)?)
# in: sums and counts
# - lowest = -100.0
# + lowest = -90
# - Q = np.where(counts > 0, np.maximum(lowest, sums / n - 2.0 / np.sqrt(n)), lowest)
# + Q = np.full(shape, lowest)
# + Q[counts > 0] = np.maximum(lowest, sums / n - 2.0 / np.sqrt(n))[counts > 0]

# %% always three actions
# says: : n_actions says how many there are
# in: sums and counts
# - return lambda state: int(Q[state].argmax())
# + return lambda state: int(Q[state][:3].argmax())

# %% no action where nobody was
# says: `return lambda state: best[state]` raises KeyError: there is no key
# in: sums and counts
# - return lambda state: int(Q[state].argmax())
# + best = {s: int(Q[s].argmax()) for s, *_ in steps}
# + return lambda state: best[state]

# %% the lowest of the next states
# says: what counts is the *mean* of the targets of a pair, not the lowest of them, and not the value of the worst next state
# in: only what was done often
# - mean = sum(r + (0 if end else V[after]) for r, after, end in found) / len(found)
# + mean = min(r + (0 if end else V[after]) for r, after, end in found)

# %% whole rewards
# says: does a reward lose what is behind its decimal point, as by int(reward)?
# in: sums and counts
# - sums[s, a] += r if terminated else r + V[after]
# + sums[s, a] += int(r) if terminated else int(r) + V[after]

# %% one step less
# says: a mean divides the sum by the *number* of the steps of its pair
# in: sums and counts
# - Q = np.where(counts > 0, np.maximum(lowest, sums / n - 2.0 / np.sqrt(n)), lowest)
# + Q = np.where(counts > 0, np.maximum(lowest, sums / np.maximum(n - 1, 1) - 2.0 / np.sqrt(n)), lowest)

# %% a large penalty
# says: what counts is the *mean* of the targets, not their sum or their number; a penalty is small beside that
# in: sums and counts
# - Q = np.where(counts > 0, np.maximum(lowest, sums / n - 2.0 / np.sqrt(n)), lowest)
# + Q = np.where(counts > 0, np.maximum(lowest, sums / n - 20.0 / np.sqrt(n)), lowest)
