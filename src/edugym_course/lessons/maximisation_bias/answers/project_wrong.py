# %% Q-learning
# says: in a casino that does not pay,
# says: of episodes 31 to 100 lead into it; with double Q-learning
# says: do, with Q-learning
# says: : what does the table that learns ask the *other* table? Its own argmax chooses the action in the next state, and the other table says what that action is worth
# in: two tables and a dictionary of names
# - own, other = (Q1, Q2) if rng.random() < 0.5 else (Q2, Q1)
# + own = other = Q1

# %% both by the table that learns
# says: what does the table that learns ask the *other* table?
# in: two tables and a dictionary of names
# - target += other[after, own[after].argmax()]
# + target += own[after].max()

# %% the other's maximum
# says: what does the table that learns ask the *other* table?
# in: two tables and a dictionary of names
# - target += other[after, own[after].argmax()]
# + target += other[after].max()

# %% one table keeps its zeros
# says: in a casino that pays, where one of
# says: machines wins 1 on average, the policy goes in and plays it in
# says: runs, and it should in
# says: it has learned little; are *both* tables changed, each in about half of the steps (one that keeps its zeros says 0 of everything)? Does the target count what follows in the *next* state, and only where `terminated` is False? Is Q(S, A) changed, and is the next step begun in the next state?
# in: two tables and a dictionary of names
# - own, other = (Q1, Q2) if rng.random() < 0.5 else (Q2, Q1)
# + own, other = Q1, Q2

# %% the worst action
# says: while it learns, it goes in; does the policy take the best action, of the state that it is given, by the sum of both tables, and is the state that reset() gives the next one?
# in: two tables and a dictionary of names
# - return lambda state: int((Q1 + Q2)[state].argmax())
# + return lambda state: int((Q1 + Q2)[state].argmin())

# %% the wrong sign
# says: does a value move *towards* the target, and is the best action that with the *largest* value?
# in: two tables and a dictionary of names
# - own[state, action] += 0.1 * (target - own[state, action])
# + own[state, action] += 0.1 * (own[state, action] - target)

# %% always random
# says: is ε 0.1, and not 0.9? Are the first values 0?
# in: two tables and a dictionary of names
# - if rng.random() < 0.1:
# + if True:

# %% nothing random
# says: it tries no action but the best one: a share ε = 0.1 of its actions are random ones
# in: two tables and a dictionary of names
# - if rng.random() < 0.1:
# + if False:

# %% one table acts
# says: an action that has paid 1, when the values of all others are still 0, is taken again in
# says: runs, and it should in 92%:
# says: is the best action that with the largest *sum* of both tables?
# in: two tables and a dictionary of names
# - total = Q1[state] + Q2[state]
# + total = Q1[state]

# %% the first of equals
# says: where each action ends an episode,
# says: where all values are equal, it begins with action
# says: runs: draw one of the best at random, as in rng.choice(np.flatnonzero(values == values.max()))
# in: two tables and a dictionary of names
# - action = int(rng.choice(np.flatnonzero(total == total.max())))
# + action = int(total.argmax())

# %% all at once
# says: an action that has paid 1 four times and then -1 is mostly left at once: is α 0.1? A value moves a tenth of
#   the way to its target
# in: two tables and a dictionary of names
# - own[state, action] += 0.1 * (target - own[state, action])
# + own[state, action] = target

# %% more and more at random
# says: it takes its favourite action in
# says: steps, and it should in about 92%: is ε 0.1?
# in: two tables and a dictionary of names
# - if rng.random() < 0.1:
# + if rng.random() < min(0.1 * (1 + _), 0.4):

# %% the state stands still
# says: or more: it
# in: two tables and a dictionary of names
# - state = after
# + state = state

# %% no policy
# says: gives None: return the policy, a function from a state to an action
# in: two tables and a dictionary of names
# - return lambda state: int((Q1 + Q2)[state].argmax())
# + policy = lambda state: int((Q1 + Q2)[state].argmax())

# %% the coin is not drawn from the seed
# says: does not repeat itself
# in: two tables and a dictionary of names
# - own, other = (Q1, Q2) if rng.random() < 0.5 else (Q2, Q1)
# + own, other = (Q1, Q2) if np.random.default_rng().random() < 0.5 else (Q2, Q1)
