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

# %% copies
# says: are what they were before: change an entry in place, as in Q1[state, action] += ..., and return nothing
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
