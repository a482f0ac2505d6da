# %% no limit
# slow
# says: that is the most valuable treasure of all, however long it takes: does a dive that takes more than seven steps
#   count for nothing in what your program learns?
# in: late dives count for nothing
# - reward = value if steps <= 7 else 0.0
# + reward = value


# %% fewer than seven
# slow
# says: that is the best one of those nearer than seven steps, and exactly seven are allowed; if your program allows them,
#   is γ 1, and is α large enough for their values to come all the way back?
# in: late dives count for nothing
# - reward = value if steps <= 7 else 0.0
# + reward = value if steps < 7 else 0.0


# %% counted from the second step
# slow
# says: that is the best one with nine steps: are the steps counted from the first on, and anew in each dive, and is a dive that takes too long worth less than the poorest of the others?
# in: late dives count for nothing
# - reward = value if steps <= 7 else 0.0
# + reward = value if steps - 1 <= 8 else 0.0


# %% a price
# slow
# says: in nearly all seas that is what a price of about
# says: for each step prefers; a price cannot find every compromise, so let the limit itself say what a dive is worth
# in: late dives count for nothing
# - reward = value if steps <= 7 else 0.0
# + reward = value - 6.0


# %% the shore
# slow
# says: that is always the treasure at the shore: are there random dives, does each begin in the state that reset gives, with the steps counted anew? Does the *largest* of the next values (no mean) come back to the state that was left, and does the policy look it up in the state that it is given?
# in: late dives count for nothing
# - return lambda state: int(Q[state].argmax())
# + return lambda state: 0


# %% the deepest
# slow
# says: that is always the deepest treasure within seven steps; a nearer one may be worth more
# in: late dives count for nothing
# - reward = value if steps <= 7 else 0.0
# + reward = steps * (value > 0) if steps <= 7 else 0.0


# %% the poorest
# slow
# says: that is the poorest treasure within seven steps: is there an `argmin`, or a minus sign too many?
# in: late dives count for nothing
# - reward = value if steps <= 7 else 0.0
# + reward = (100.0 - value) * terminated if steps <= 7 else 0.0


# %% never down
# slow
# says: with the treasures
# says: comes to no treasure, and
# says: it should pick up the
# says: : does it look up the state that it is given, and take the best action, does each step after the seventh bring nothing, and are the first values not too high?
# in: late dives count for nothing
# - return lambda state: int(Q[state].argmax())
# + return lambda state: 1


# %% never counted anew
# slow
# says: each dive is short enough, but not the best: does the update belong to the state that was left and the action that was taken there, and does your program try all dives often enough?
# in: late dives count for nothing
# - state, _ = environment.reset()
# - steps = 0
# + state, _ = environment.reset()


# %% the same numbers in every run
# says: takes the same actions with seed
# in: late dives count for nothing
# - rng = np.random.default_rng(seed)
# + rng = np.random.default_rng(1)


# %% no policy
# says: return the policy, a function from a state to an action
# in: late dives count for nothing
# - return lambda state: int(Q[state].argmax())
# + Q


# %% a table
# says: should return a function from a state to an action
# in: late dives count for nothing
# - return lambda state: int(Q[state].argmax())
# + return Q


# %% steps too few
# says: of its 16000 steps: go on, episode after episode, until all are taken
# in: late dives count for nothing
# - for _ in range(n_steps):
# + for _ in range(200):


# %% goes on after the end
# says: takes a step after the end of an episode
# in: late dives count for nothing
# - state, _ = environment.reset()
# + steps = 0


# %% an action that there is not
# says: the policy that my_program returns
# in: late dives count for nothing
# - return lambda state: int(Q[state].argmax())
# + return lambda state: 2


# %% limits that change
# slow
# says: seas the dive takes too long; what is a dive worth that does? It must be less than the poorest of the others
# in: late dives count for nothing
# - reward = value if steps <= 7 else 0.0
# + reward = value if steps <= (7 if seed % 2 else 13) else 0.0


# %% a discount
# slow
# says: a treasure seems to count less the later it comes: is γ below 1, is α too small for its value to come all the way
#   back, does a target count random actions, as that of SARSA does, or does the table hold whole numbers, so that a part
#   of the value is lost in each update?
# in: late dives count for nothing
# - Q[state, action] += 0.5 * ((reward if terminated else reward + Q[after].max()) - Q[state, action])
# + Q[state, action] += 0.5 * ((reward if terminated else reward + 0.9 * Q[after].max()) - Q[state, action])


# %% one step more
# slow
# says: where the diver begins one cell away from the shore, the policy picks up the fifth treasure, after
# says: steps: at most seven are allowed. Is the step under way counted, too, or are eight allowed?
# in: late dives count for nothing
# - reward = value if steps <= 7 else 0.0
# + reward = value if steps <= 8 else 0.0


# %% a late dive is worth 5
# slow
# says: seas the dive takes too long; what is a dive worth that does? It must be less than the poorest of the others
# in: late dives count for nothing
# - reward = value if steps <= 7 else 0.0
# + reward = value if steps <= 7 else 5.0 * terminated


# %% a late dive is worth a tenth
# slow
# says: seas the dive takes too long
# in: late dives count for nothing
# - reward = value if steps <= 7 else 0.0
# + reward = value if steps <= 7 else value / 10


# %% every late step is paid
# slow
# says: comes to no treasure
# in: late dives count for nothing
# - reward = value if steps <= 7 else 0.0
# + reward = value if steps <= 7 else 5.0


# %% a small discount
# slow
# says: a treasure seems to count less the later it comes: is γ below 1, is α too small for its value to come all the way
#   back, does a target count random actions, as that of SARSA does, or does the table hold whole numbers, so that a part
#   of the value is lost in each update?
# in: late dives count for nothing
# - Q[state, action] += 0.5 * ((reward if terminated else reward + Q[after].max()) - Q[state, action])
# + Q[state, action] += 0.5 * ((reward if terminated else reward + 0.99 * Q[after].max()) - Q[state, action])


# %% a policy that draws
# slow
# says: the policy that my_program returns draws its actions: from the same start it picks up now the
# says: . It should take the *best* action by what was learned, and never a random one; and if there are many equal values, has it learned enough?
# in: late dives count for nothing
# - return lambda state: int(Q[state].argmax())
# + return lambda state: int(rng.integers(2)) if rng.random() < 0.1 else int(Q[state].argmax())


# %% too small a fine
# slow
# says: the policy picks up the fifth one
# says: and is a dive that takes too long worth less than the poorest of the others?
# in: late dives count for nothing
# - reward = value if steps <= 7 else 0.0
# + reward = value if steps <= 7 else value - 10.0


# %% a mean over all targets
# slow
# says: a treasure seems to count less the later it comes
# in: late dives count for nothing
# - Q[state, action] += 0.5 * ((reward if terminated else reward + Q[after].max()) - Q[state, action])
# + tried[state, action] += 1
# + target = reward if terminated else reward + Q[after].max()
# + Q[state, action] += (target - Q[state, action]) / tried[state, action]
# - Q = np.zeros((90, 2))
# + Q, tried = np.zeros((90, 2)), np.zeros((90, 2))

# %% γ is 0.995
# slow
# says: is γ
# in: late dives count for nothing
# - Q[state, action] += 0.5 * ((reward if terminated else reward + Q[after].max()) - Q[state, action])
# + Q[state, action] += 0.5 * ((reward if terminated else reward + 0.995 * Q[after].max()) - Q[state, action])

# %% steps from the cell
# slow
# says: where the diver begins two cells away from the shore, the fifth treasure is the best one: it is worth
# says: , and exactly seven steps away. The policy
# says: : are the steps counted from `reset` on, and not computed from the cell, and does each update belong to the state that was left?
# in: late dives count for nothing
# - steps += 1
# + steps = state // 9 + state % 9 + 1

# %% whole numbers
# slow
# says: only where all treasures are worth less than 1 it goes wrong: are values rounded or whole numbers, as in a table with dtype=int, or is a dive that takes too long worth more than these?
# in: late dives count for nothing
# - Q[state, action] += 0.5 * ((reward if terminated else reward + Q[after].max()) - Q[state, action])
# + Q[state, action] = int(reward if terminated else reward + Q[after].max())

# %% a late dive is worth 1
# slow
# says: seas the dive takes too long
# in: late dives count for nothing
# - reward = value if steps <= 7 else 0.0
# + reward = value if steps <= 7 else 1.1 * terminated

# %% a table of whole numbers, and large values
# slow
# says: a treasure seems to count less the later it comes
# in: late dives count for nothing
# - Q = np.zeros((90, 2))
# + Q = np.zeros((90, 2), dtype=np.int64)
