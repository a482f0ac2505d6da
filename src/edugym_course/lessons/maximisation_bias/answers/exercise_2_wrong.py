# %% the same table twice
# says: the table that chooses the action also says what it is worth: that is Q-learning with two tables
# in: the solution of double_update
# - target += discount * other[next_state, own[next_state].argmax()]
# + target += discount * own[next_state].max()

# %% the other's maximum
# says: that is the largest value of the other table; the action is the best one of the table that learns
# in: the solution of double_update
# - target += discount * other[next_state, own[next_state].argmax()]
# + target += discount * other[next_state].max()

# %% roles swapped
# says: the roles are swapped: the table that learns chooses the action, and the other says what it is worth
# in: the solution of double_update
# - target += discount * other[next_state, own[next_state].argmax()]
# + target += discount * own[next_state, other[next_state].argmax()]

# %% the mean of both
# says: the tables are averaged before the maximum; one chooses, and the other says what that is worth
# in: the solution of double_update
# - target += discount * other[next_state, own[next_state].argmax()]
# + target += discount * ((own + other) / 2)[next_state].max()

# %% the smaller of both
# says: the smaller value of both counts: that is maxmin Q-learning
# in: the solution of double_update
# - target += discount * other[next_state, own[next_state].argmax()]
# + target += discount * np.minimum(own, other)[next_state].max()

# %% both learn
# says: both tables are changed; `first` says which one learns
def double_update(Q1, Q2, first, state, action, reward, next_state, terminated, learning_rate, discount):
    old1, old2 = Q1.copy(), Q2.copy()
    for Q, own, other in ((Q1, old1, old2), (Q2, old2, old1)):
        future = 0 if terminated else discount * other[next_state, own[next_state].argmax()]
        Q[state, action] += learning_rate * (reward + future - own[state, action])


# %% always the first
# says: Q1 is changed, whatever `first` says
# in: the solution of double_update
# - own, other = (Q1, Q2) if first else (Q2, Q1)
# + own, other = Q1, Q2

# %% always the second
# says: Q2 is changed, whatever `first` says
# in: the solution of double_update
# - own, other = (Q1, Q2) if first else (Q2, Q1)
# + own, other = Q2, Q1

# %% the wrong one
# says: the other table is changed: Q1 learns if `first` is True
# in: the solution of double_update
# - own, other = (Q1, Q2) if first else (Q2, Q1)
# + own, other = (Q2, Q1) if first else (Q1, Q2)

# %% beyond the end
# says: what comes after the end is counted: where `terminated` is True the target is the reward alone
# in: the solution of double_update
# - if not terminated:
# + if True:

# %% no future
# says: what comes after a step is left out
# in: the solution of double_update
# - target += discount * other[next_state, own[next_state].argmax()]
# + target += 0

# %% no discount
# says: the discount is left out
# in: the solution of double_update
# - target += discount * other[next_state, own[next_state].argmax()]
# + target += other[next_state, own[next_state].argmax()]

# %% the other's old value
# says: the old value is taken from the other table
# in: the solution of double_update
# - own[state, action] += learning_rate * (target - own[state, action])
# + own[state, action] += learning_rate * (target - other[state, action])

# %% no learning rate
# says: the learning rate is left out
# in: the solution of double_update
# - own[state, action] += learning_rate * (target - own[state, action])
# + own[state, action] = target

# %% nothing subtracted
# says: − Q(S, A) is left out: the target takes the place of the error
# in: the solution of double_update
# - own[state, action] += learning_rate * (target - own[state, action])
# + own[state, action] += learning_rate * target

# %% wrong way round
# says: `terminated` is taken the wrong way round: what follows counts where it is *False*
# in: the solution of double_update
# - if not terminated:
# + if terminated:

# %% no reward at the end
# says: the reward of the step that ends an episode is lost: where `terminated` is True the target is the reward
# in: the solution of double_update
# - target = reward
# + target = 0 if terminated else reward

# %% the end changes nothing
# says: the step that ends an episode changes nothing; it has a target, too: the reward alone
# in: the solution of double_update
# - own[state, action] += learning_rate * (target - own[state, action])
# + own[state, action] += (not terminated) * learning_rate * (target - own[state, action])

# %% all discounted
# says: the reward is discounted, too; only what follows is
# in: the solution of double_update
# - target = reward
# + target = reward if terminated else discount * reward

# %% discounted twice
# says: the target is discounted once more; only what follows is discounted, and once
# in: the solution of double_update
# - own[state, action] += learning_rate * (target - own[state, action])
# + target *= 1 if terminated else discount
# + own[state, action] += learning_rate * (target - own[state, action])

# %% only what follows
# says: the reward is left out where something follows
# in: the solution of double_update
# - target = reward
# + target = reward if terminated else 0

# %% subtracted
# says: what follows is subtracted; it is added to the reward
# in: the solution of double_update
# - target += discount * other[next_state, own[next_state].argmax()]
# + target -= discount * other[next_state, own[next_state].argmax()]

# %% both choose
# says: the action is the best one by both tables together; the table that learns chooses it alone
# in: the solution of double_update
# - target += discount * other[next_state, own[next_state].argmax()]
# + target += discount * other[next_state, (own + other)[next_state].argmax()]

# %% chosen too early
# says: the action is the best one of `state`; it is chosen in `next_state`
# in: the solution of double_update
# - target += discount * other[next_state, own[next_state].argmax()]
# + target += discount * other[next_state, own[state].argmax()]

# %% asked too early
# says: the other table is asked about `state`; what counts is the value in `next_state`
# in: the solution of double_update
# - target += discount * other[next_state, own[next_state].argmax()]
# + target += discount * other[state, own[next_state].argmax()]

# %% the action taken
# says: the other table is asked about the action that was taken; it is asked about the best one in `next_state`
# in: the solution of double_update
# - target += discount * other[next_state, own[next_state].argmax()]
# + target += discount * other[next_state, action]

# %% a number of an action
# says: argmax is the *number* of the best action; the other table says what it is worth
# in: the solution of double_update
# - target += discount * other[next_state, own[next_state].argmax()]
# + target += discount * own[next_state].argmax()

# %% the worst
# says: the action with the *smallest* value is chosen
# in: the solution of double_update
# - target += discount * other[next_state, own[next_state].argmax()]
# + target += discount * other[next_state, own[next_state].argmin()]

# %% the mean of the row
# says: that is the mean of the other table's values; it is asked about one action only
# in: the solution of double_update
# - target += discount * other[next_state, own[next_state].argmax()]
# + target += discount * other[next_state].mean()

# %% the next state learns
# says: the value of `next_state` is changed; what is learned is the value of `state`
# in: the solution of double_update
# - own[state, action] += learning_rate * (target - own[state, action])
# + own[next_state, action] += learning_rate * (target - own[next_state, action])

# %% a whole row
# says: the values of *all* actions of `state` are changed; learn about the action that was taken
# in: the solution of double_update
# - own[state, action] += learning_rate * (target - own[state, action])
# + own[state] += learning_rate * (target - own[state])

# %% away from it
# says: the value moves *away* from the target: the error is the target less the old value
# in: the solution of double_update
# - own[state, action] += learning_rate * (target - own[state, action])
# + own[state, action] += learning_rate * (own[state, action] - target)

# %% swapped rates
# says: the learning rate and the discount are swapped
# in: the solution of double_update
# - target += discount * other[next_state, own[next_state].argmax()]
# + target += learning_rate * other[next_state, own[next_state].argmax()]
# - own[state, action] += learning_rate * (target - own[state, action])
# + own[state, action] += discount * (target - own[state, action])


# %% two halves that differ
# says: it is right where `first` is True, and wrong where it is False: both halves are the same, but for the names of
#   the tables
def double_update(Q1, Q2, first, state, action, reward, next_state, terminated, learning_rate, discount):
    if first:
        target = reward if terminated else reward + discount * Q2[next_state, Q1[next_state].argmax()]
        Q1[state, action] += learning_rate * (target - Q1[state, action])
    else:
        target = reward if terminated else reward + discount * Q1[next_state, Q2[next_state].argmax()]
        Q2[state, action] = Q1[state, action] + learning_rate * (target - Q1[state, action])


# %% copies
# says: leaves the tables as they were before: change an entry in place, as in Q1[state, action] += ..., and return nothing
# in: the solution of double_update
# - own, other = (Q1, Q2) if first else (Q2, Q1)
# + own, other = (Q1.copy(), Q2.copy()) if first else (Q2.copy(), Q1.copy())

# %% the best value as an index
# says: raises IndexError
# in: the solution of double_update
# - target += discount * other[next_state, own[next_state].argmax()]
# + target += discount * other[next_state, own[next_state].max()]

# %% a number
# says: Q1, Q2, first, state, action, reward, next_state, terminated, learning_rate and discount
double_update = 0.5


# %% mostly the target
# says: α and 1 − α are swapped: the old value counts 1 − α
# in: the solution of double_update
# - own[state, action] += learning_rate * (target - own[state, action])
# + own[state, action] = learning_rate * own[state, action] + (1 - learning_rate) * target


# %% turned
# says: state and action are swapped: Q1[state, action]
# in: the solution of double_update
# - own[state, action] += learning_rate * (target - own[state, action])
# + own[action, state] += learning_rate * (target - own[action, state])


# %% the best action of any state
# says: learns here, action 1 looks best in state 0 to it, and the other says 4, so the target is 6.5, and the old value
#   4: compare these with yours
# in: the solution of double_update
# - target += discount * other[next_state, own[next_state].argmax()]
# + target += discount * other[next_state, own.argmax() % own.shape[1]]


# %% the end counts half
# says: learns here, the step ends its episode, so the target is
# says: the step ends its episode
# says: , and the old value
# says: : compare these with yours
# in: the solution of double_update
# - target = reward
# + target = reward / 2 if terminated else reward


# %% the smaller of two opinions
# says: of the two values of the chosen action the smaller one counts; the other table says alone what it is worth
# in: the solution of double_update
# - target += discount * other[next_state, own[next_state].argmax()]
# + best = own[next_state].argmax()
# + target += discount * min(own[next_state, best], other[next_state, best])
