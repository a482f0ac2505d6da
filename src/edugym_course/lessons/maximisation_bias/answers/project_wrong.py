# %% Q-learning
# slow
# says: in an environment of 2 steps the first step pays 1 and ends its episode, and the same action then pays -0.905 and
#   ends one too: a loss if one table has learned both, and a gain if each has learned one; after that the policy takes
#   this action again in
# says: runs, and it should in about 50%: in each step *one* table learns, and a coin says which, each time anew
# in: two tables and a dictionary of names
# - own, other = (Q1, Q2) if rng.random() < 0.5 else (Q2, Q1)
# + own = other = Q1

# %% one table learns nearly always
# slow
# says: in each step *one* table learns, and a coin says which, each time anew
# in: two tables and a dictionary of names
# - own, other = (Q1, Q2) if rng.random() < 0.5 else (Q2, Q1)
# + own, other = (Q1, Q2) if rng.random() < 0.1 else (Q2, Q1)

# %% both by the table that learns
# slow
# says: what does the table that learns ask the *other* table? Its own argmax chooses the action in the next state, and
#   the other table says what that action is worth
# in: two tables and a dictionary of names
# - target += other[after, own[after].argmax()]
# + target += own[after].max()

# %% the other's maximum
# slow
# says: what does the table that learns ask the *other* table?
# in: two tables and a dictionary of names
# - target += other[after, own[after].argmax()]
# + target += other[after].max()

# %% the mean over ties, and a future behind the end
# slow
# says: where `terminated` is True, nothing follows: the target is the reward
# in: two tables and a dictionary of names
# - if not terminated:
# + if True:
# - target += other[after, own[after].argmax()]
# + target += other[after][own[after] == own[after].max()].mean()

# %% the mean over ties, and a discount
# slow
# says: what does the table that learns ask the *other* table?
# in: two tables and a dictionary of names
# - target += other[after, own[after].argmax()]
# + target += 0.9 * other[after][own[after] == own[after].max()].mean()

# %% the mean of the other's values
# slow
# says: the same one pays 1 in two episodes of one step
# says: what does the table that learns ask the *other* table?
# in: two tables and a dictionary of names
# - target += other[after, own[after].argmax()]
# + target += other[after].mean()

# %% the roles swapped
# slow
# says: are the two swapped, or is the value of the other table taken from the target?
# in: two tables and a dictionary of names
# - target += other[after, own[after].argmax()]
# + target += own[after, other[after].argmax()]

# %% a random action next
# slow
# says: of 20 actions the same one pays 1 in two episodes of one step
# says: what does the table that learns ask the *other* table?
# in: two tables and a dictionary of names
# - target += other[after, own[after].argmax()]
# + target += other[after, rng.integers(shape[1])]

# %% double SARSA
# slow
# says: what does the table that learns ask the *other* table?
# in: two tables and a dictionary of names
# - target += other[after, own[after].argmax()]
# + target += other[after, (Q1 + Q2)[after].argmax() if rng.random() > 0.1 else rng.integers(shape[1])]

# %% double SARSA by the table that learns
# slow
# says: of 20 actions the same one pays 1 in 8 episodes of one step
# says: This is the *best* one, not one drawn at random nor the one that is taken next. (Or is the coin not a fair one?)
# in: two tables and a dictionary of names
# - target += other[after, own[after].argmax()]
# + target += other[after, own[after].argmax() if rng.random() > 0.1 else rng.integers(shape[1])]

# %% a discount
# slow
# says: the discount is 1, and α is 0.1: what follows in state 0 is worth 0.1, or 0
# in: two tables and a dictionary of names
# - target += other[after, own[after].argmax()]
# + target += 0.9 * other[after, own[after].argmax()]

# %% cut off is not ended
# slow
# says: only `terminated` means that nothing follows; a step that is truncated has its future, from the state that step gave, not the one that reset gives
# in: two tables and a dictionary of names
# - if not terminated:
# + if not (terminated or truncated):

# %% the end has a future
# slow
# says: where `terminated` is True, nothing follows: the target is the reward
# in: two tables and a dictionary of names
# - if not terminated:
# + if True:

# %% the other's action 0
# slow
# says: the same one pays 1 in two episodes of one step
# says: what does the table that learns ask the *other* table?
# in: two tables and a dictionary of names
# - target += other[after, own[after].argmax()]
# + target += other[after, 0]

# %% the state of the reset, to the end of the episode
# slow
# says: in a casino that pays, where one of
# says: machines wins 1 on average, the policy goes in and plays it in
# says: runs, and it should in
# says: : it has learned little; is the next step begun in the next state, and is the other table asked about the
#   *best* action there?
# in: two tables and a dictionary of names
# - state = after
# + pass

# %% the policy of one table
# slow
# says: in an environment of 1 step a first step has paid 1, and all else is still 0; after that the policy takes this
#   action again in
# says: the policy takes the *best* action, by the sum of both tables, and never a random one
# in: two tables and a dictionary of names
# - return lambda state: int((Q1 + Q2)[state].argmax())
# + return lambda state: int(Q1[state].argmax())

# %% Q-learning as soon as both tables know something
# slow
# says: in a casino that does not pay,
# says: of episodes 31 to 100 lead into it; with double Q-learning
# says: do, with Q-learning
# says: : what does the table that learns ask the *other* table? Its own argmax chooses the action in the next state, and the other table says what that action is worth
# in: two tables and a dictionary of names
# - target += other[after, own[after].argmax()]
# + target += (own if Q1.any() and Q2.any() else other)[after, own[after].argmax()]

# %% the worst action
# slow
# says: the policy takes the *best* action, by the sum of both tables, and never a random one
# in: two tables and a dictionary of names
# - return lambda state: int((Q1 + Q2)[state].argmax())
# + return lambda state: int((Q1 + Q2)[state].argmin())

# %% the wrong sign
# slow
# says: does a value move *towards* the target, and is the best action that with the *largest* value?
# in: two tables and a dictionary of names
# - own[state, action] += 0.1 * (target - own[state, action])
# + own[state, action] += 0.1 * (own[state, action] - target)

# %% a half at random
# slow
# says: is ε 0.1, are the first values 0, and is the best action that with the largest *sum* of both tables?
# in: two tables and a dictionary of names
# - if rng.random() < 0.1:
# + if rng.random() < 0.5:

# %% nothing is learned at an end
# says: is ε 0.1, is the step that ends an episode learned from, with the target R, and do both tables last from one episode to the next?
# in: two tables and a dictionary of names
# - own[state, action] += 0.1 * (target - own[state, action])
# + if not terminated:
# +     own[state, action] += 0.1 * (target - own[state, action])

# %% never the last action at random
# slow
# says: where each action ends an episode, it tries action
# says:  times where another one is its favourite, and an action
# says:  times on average: is the random action one of *all* n actions, 0 to n - 1, and each as likely? rng.integers(n) draws so
# in: two tables and a dictionary of names
# - action = int(rng.integers(shape[1]))
# + action = int(rng.integers(shape[1] - 1))

# %% always random
# says: is ε 0.1, is the step that ends an episode learned from, with the target R, and do both tables last from one episode to the next?
# in: two tables and a dictionary of names
# - if rng.random() < 0.1:
# + if True:

# %% nothing random
# slow
# says: it tries no action but the best one: a share ε = 0.1 of its actions are random ones
# in: two tables and a dictionary of names
# - if rng.random() < 0.1:
# + if False:

# %% one table acts
# says: an action that has paid 1, when the values of all others are still 0, is taken again in
# says: runs, and it should in 90%:
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
# slow
# says: a value moves a *tenth* of the way to its target (α = 0.1), and only that of the table that learns
# in: two tables and a dictionary of names
# - own[state, action] += 0.1 * (target - own[state, action])
# + own[state, action] = target

# %% more and more at random
# slow
# says: it takes its favourite action in
# says: steps, and it should in about 90%: is ε 0.1?
# in: two tables and a dictionary of names
# - if rng.random() < 0.1:
# + if rng.random() < min(0.1 * (1 + _), 0.4):

# %% the state stands still
# slow
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

# %% the reset is not looked at
# slow
# says: the next one begins in state 1, and an action there pays 1
# says: learn about the state that reset() gives: state, info = environment.reset(), and change its value, not that of the next one
# in: two tables and a dictionary of names
# - state, _ = environment.reset()
# + environment.reset()

# %% a coin for each episode
# slow
# says: the first step pays 1, and in the same episode the same action then pays -0.905 and ends it: a loss if one table has learned both, and a gain if each has learned one
# says: the coin is thrown in each *step*, not in each episode
# in: two tables and a dictionary of names
# - state, _ = environment.reset(seed=seed)
# + state, coin = environment.reset(seed=seed)[0], rng.random()
# - own, other = (Q1, Q2) if rng.random() < 0.5 else (Q2, Q1)
# + own, other = (Q1, Q2) if coin < 0.5 else (Q2, Q1)
# - state, _ = environment.reset()
# + state, coin = environment.reset()[0], rng.random()

# %% a learning rate that falls
# slow
# says: in an environment of 62 steps 60 steps pay nothing and are truncated, the next one pays 1 and ends its episode, and the same action then pays -0.905 and ends one too
# says: does α stay 0.1 to the last step?
# in: two tables and a dictionary of names
# - for _ in range(n_steps):
# + for taken in range(n_steps):
# - own[state, action] += 0.1 * (target - own[state, action])
# + own[state, action] += 0.1 / (1 + taken / 600) * (target - own[state, action])

# %% a coin that falls ever more often on one side
# slow
# says: are α = 0.1 and the coin the same in each step?
# in: two tables and a dictionary of names
# - for _ in range(n_steps):
# + for taken in range(n_steps):
# - own, other = (Q1, Q2) if rng.random() < 0.5 else (Q2, Q1)
# + own, other = (Q1, Q2) if rng.random() < 0.5 + taken / 100 else (Q2, Q1)

# %% an ε that falls
# slow
# says: in the second half of its 1000 steps in a casino of 3 machines,
# says: of the actions are others than those of its policy, and it should be about 6.7%: is ε 0.1, from the first step to the last, and is the random action one of all?
# in: two tables and a dictionary of names
# - if rng.random() < 0.1:
# + if rng.random() < 0.1 * 0.998**_:

# %% small first values
# slow
# says: all first values are 0
# in: two tables and a dictionary of names
# - Q1, Q2 = np.zeros(shape), np.zeros(shape)
# + Q1, Q2 = rng.random((2, *shape)) / 100

# %% an ε that grows
# slow
# says: of its actions are others than its favourite one in the first half of its runs, and
# says: in the second, and it should be about 10% from the first step to the last: is ε always 0.1?
# in: two tables and a dictionary of names
# - for _ in range(n_steps):
# + for taken in range(n_steps):
# - if rng.random() < 0.1:
# + if rng.random() < 0.05 + 0.15 * taken / n_steps:

# %% ε is 0.14
# slow
# says: of its actions are others than its favourite one, and it should be about 10%: its ε is about 0.1
# in: two tables and a dictionary of names
# - if rng.random() < 0.1:
# + if rng.random() < 0.14:

# %% random for a whole episode
# slow
# says: where each episode has two steps, in
# says: of the episodes both actions are others than the favourite ones, and it should be about 1%: draw anew in each step whether its action is random, not once an episode
# in: two tables and a dictionary of names
# - for _ in range(n_steps):
# + tries = rng.random() < 0.1
# + for _ in range(n_steps):
# - if rng.random() < 0.1:
# + if tries:
# - state, _ = environment.reset()
# + state, _ = environment.reset()
# + tries = rng.random() < 0.1

# %% another discount
# slow
# says: the discount is 1, and α is 0.1: what follows in state 0 is worth 0.1, or 0
# in: two tables and a dictionary of names
# - target += other[after, own[after].argmax()]
# + target += 0.99 * other[after, own[after].argmax()]

# %% ε is 0.12
# slow
# says: of its actions are others than its favourite one, and it should be about 10%: its ε is about 0.1
# in: with lists
# - action = int(rng.integers(n_actions)) if rng.random() < 0.1 else best(both(state))
# + action = int(rng.integers(n_actions)) if rng.random() < 0.12 else best(both(state))

# %% each tenth action
# slow
# says: is another action than its favourite one in
# says: runs: draw in each step whether its action is random, and do not count to ten
# in: with lists
# - action = int(rng.integers(n_actions)) if rng.random() < 0.1 else best(both(state))
# + action = int(rng.integers(n_actions)) if taken % 10 == 9 else best(both(state))

# %% α is 0.11
# slow
# says: a value moves a *tenth* of the way to its target (α = 0.1)
# in: with lists
# - tables[i][state][action] += 0.1 * (reward + future - tables[i][state][action])
# + tables[i][state][action] += 0.11 * (reward + future - tables[i][state][action])

# %% twice as many random actions
# slow
# says: of its actions are others than its favourite one, and
# says: : its ε is about 0.2
# in: two tables and a dictionary of names
# - if rng.random() < 0.1:
# + if rng.random() < 0.2:

# %% the next episode follows a truncated step
# slow
# says: a step that is truncated has its future, from the state that step gave, not the one that reset gives
# in: two tables and a dictionary of names
# - own, other = (Q1, Q2) if rng.random() < 0.5 else (Q2, Q1)
# + own, other = (Q1, Q2) if rng.random() < 0.5 else (Q2, Q1)
# + if truncated: after, _ = environment.reset()
# - if terminated or truncated:
# + if truncated: continue
# + if terminated:

# %% never the best one by chance
# slow
# says: where each of two actions ends an episode, and one is a favourite
# says: a random action may be any of them, the best one too
# in: with lists
# - action = int(rng.integers(n_actions)) if rng.random() < 0.1 else best(both(state))
# + action = best(both(state))
# + if rng.random() < 0.1:
# +     action = int(rng.choice([other for other in range(n_actions) if other != action]))

# %% one order for all ties
# slow
# says: where half of 10 actions lose 1 and the others pay nothing, it takes the action of the step before again in
# says: of the steps, and it should in about 20%: draw one of the best at random, anew in each step, also where some other action is worse
# in: two tables and a dictionary of names
# - Q1, Q2 = np.zeros(shape), np.zeros(shape)
# + Q1, Q2, order = np.zeros(shape), np.zeros(shape), rng.permutation(shape[1])
# - action = int(rng.choice(np.flatnonzero(total == total.max())))
# + action = int(order[np.argmax(total[order])])

# %% random actions are learned by one table
# slow
# says: of two actions the one that is taken first pays a little, so the other one is only tried at random; it pays -1 and then 0.96, which is a gain if one table has learned both. In
# says: runs it has, and it should in about 50%: throw the coin anew in each step, with another random number than the one that is compared with ε, and act by the *sum* of both
# in: two tables and a dictionary of names
# - if rng.random() < 0.1:
# + draw = rng.random()
# + if draw < 0.1:
# - own, other = (Q1, Q2) if rng.random() < 0.5 else (Q2, Q1)
# + own, other = (Q1, Q2) if draw < 0.5 else (Q2, Q1)

# %% a coin that falls on one side in a third
# slow
# says: the same action pays 1 in 8 episodes of one step, and then an action in state 1 pays -0.3 and leads to state 0, where the episode goes on: that is a gain if the table that does not learn has learned half of the 8
# says: is the coin a fair one, 0 or 1 with the same probability?
# in: two tables and a dictionary of names
# - own, other = (Q1, Q2) if rng.random() < 0.5 else (Q2, Q1)
# + own, other = (Q1, Q2) if rng.random() < 0.38 else (Q2, Q1)

# %% rewards that are cut off
# slow
# says: the first step pays 3 and ends its episode, and the same action then pays -2 and ends one too
# says: a reward counts in full: is it cut off at 1, or divided by something?
# in: two tables and a dictionary of names
# - target = reward
# + target = float(np.clip(reward, -1, 1))
