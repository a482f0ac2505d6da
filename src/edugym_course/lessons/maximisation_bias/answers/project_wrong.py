# %% Q-learning
# says: in a casino that does not pay, it goes in in
# says: of episodes 31 to 100; double Q-learning does in
# says: , Q-learning in
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
# says: it has learned little; are *both* tables changed, each in about half of the steps (one that keeps its zeros says 0 of everything)? Is α 0.1, is the best action by the sum of both tables taken but for ε = 0.1 of the steps, with ties drawn at random, and is the next step begun in the next state?
# in: two tables and a dictionary of names
# - own, other = (Q1, Q2) if rng.random() < 0.5 else (Q2, Q1)
# + own, other = Q1, Q2

# %% the worst action
# says: while it learns, it goes in; does the policy take the best action, of the state that it is given, by the sum of both tables?
# in: two tables and a dictionary of names
# - return lambda state: int((Q1 + Q2)[state].argmax())
# + return lambda state: int((Q1 + Q2)[state].argmin())

# %% the wrong sign
# says: or more: it
# in: two tables and a dictionary of names
# - own[state, action] += 0.1 * (target - own[state, action])
# + own[state, action] += 0.1 * (own[state, action] - target)

# %% the state stands still
# says: or more: it
# in: two tables and a dictionary of names
# - state = after
# + state = state

# %% always random
# says: or more: it has learned little
# in: two tables and a dictionary of names
# - own[state, action] += 0.1 * (target - own[state, action])
# + own[state, action] += 0.0

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
