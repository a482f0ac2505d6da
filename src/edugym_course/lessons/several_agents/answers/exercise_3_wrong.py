# %% V stays
# says: after learn(Q, V,
# says: V is not changed: after Q it is the value of the matrix game Q[state]
# in: step by step
# - V[state], _, _ = games.solve_zero_sum(Q[state])

# %% the next state is solved
# says: the value of the *next* state is solved anew; it is Q[state] that has changed
# in: step by step
# - V[state], _, _ = games.solve_zero_sum(Q[state])
# + V[next_state], _, _ = games.solve_zero_sum(Q[next_state])

# %% V is the maximum
# says: V is the largest entry of Q[state], as if the other player wanted it too; it is the value of the game
# in: step by step
# - V[state], _, _ = games.solve_zero_sum(Q[state])
# + V[state] = Q[state].max()

# %% without chance
# says: V is what the best single action guarantees, max_a min_o Q; a random choice may guarantee more
# in: step by step
# - V[state], _, _ = games.solve_zero_sum(Q[state])
# + V[state] = Q[state].min(axis=1).max()

# %% min max
# says: V is min_o max_a Q, as if you saw the other's action before you choose
# in: step by step
# - V[state], _, _ = games.solve_zero_sum(Q[state])
# + V[state] = Q[state].max(axis=0).min()

# %% a mean
# says: V is the best *mean* over the other's actions, as if it tossed a coin
# in: step by step
# - V[state], _, _ = games.solve_zero_sum(Q[state])
# + V[state] = Q[state].mean(axis=1).max()

# %% V is the target
# says: V is set to the target of one step; it is the value of the matrix game Q[state]
# in: step by step
# - V[state], _, _ = games.solve_zero_sum(Q[state])
# + V[state] = target

# %% solved too early
# says: the game is solved before Q changes; first Q, then V
def learn(Q, V, state, action, other_action, reward, next_state, terminated):
    target = reward if terminated else reward + 0.9 * V[next_state]
    V[state] = games.solve_zero_sum(Q[state]).value
    Q[state, action, other_action] += 0.5 * (target - Q[state, action, other_action])


# %% V before Q, and before the target
# says: V changes before Q does: the game that it is solved for is the old one; first Q, then V
def learn(Q, V, state, action, other_action, reward, next_state, terminated):
    V[state] = games.solve_zero_sum(Q[state]).value
    target = reward if terminated else reward + 0.9 * V[next_state]
    Q[state, action, other_action] += 0.5 * (target - Q[state, action, other_action])


# %% columns
# says: rows and columns have changed places: your actions are the rows of Q[state], and you want a high payoff
# in: step by step
# - V[state], _, _ = games.solve_zero_sum(Q[state])
# + V[state], _, _ = games.solve_zero_sum(Q[state].T)

# %% a maximum ahead
# says: the target has max Q[next_state], as if the other player wanted it too; it is V[next_state]
# in: step by step
# - target = reward + 0.9 * V[next_state]
# + target = reward + 0.9 * Q[next_state].max()

# %% the other repeats
# says: the target takes for granted that the other repeats its action: max_a Q[next_state, a, other_action]; it is V[next_state]
# in: step by step
# - target = reward + 0.9 * V[next_state]
# + target = reward + 0.9 * Q[next_state][:, other_action].max()

# %% no chance ahead
# says: the target has max_a min_o Q[next_state]; a random choice may guarantee more: it is V[next_state]
# in: step by step
# - target = reward + 0.9 * V[next_state]
# + target = reward + 0.9 * Q[next_state].min(axis=1).max()

# %% the same pair
# says: the target has Q[next_state, action, other_action]; neither need do the same again
# in: step by step
# - target = reward + 0.9 * V[next_state]
# + target = reward + 0.9 * Q[next_state][action][other_action]

# %% the old state
# says: the target has V[state]; the future begins in the next state
# in: step by step
# - target = reward + 0.9 * V[next_state]
# + target = reward + 0.9 * V[state]

# %% no end
# says: the value of the next state counts after the end; a terminal state has no future, so the target is the reward
# in: step by step
# - if terminated:
# -     target = reward
# - else:
# -     target = reward + 0.9 * V[next_state]
# + target = reward + 0.9 * V[next_state]

# %% ends inverted
# says: `terminated` is the wrong way round: the value of the next state counts where the game goes on
# in: step by step
# - if terminated:
# + if not terminated:

# %% all of the other's actions
# says: all entries of Q[state, action] change; the other's action has a number of its own
# in: step by step
# - error = target - Q[state][action][other_action]
# + error = target - Q[state][action]
# - Q[state][action][other_action] += 0.5 * error
# + Q[state][action] += 0.5 * error

# %% Q of the next state
# says: Q[next_state, ...] changes; the pair of actions was taken in `state`
# in: step by step
# - error = target - Q[state][action][other_action]
# + error = target - Q[next_state][action][other_action]
# - Q[state][action][other_action] += 0.5 * error
# + Q[next_state][action][other_action] += 0.5 * error

# %% no plus
# says: `=` where `+=` is needed: the old value is lost
# in: step by step
# - Q[state][action][other_action] += 0.5 * error
# + Q[state][action][other_action] = 0.5 * error

# %% the whole way
# says: the whole way to the target is gone, as with α = 1; it is 0.5
# in: step by step
# - Q[state][action][other_action] += 0.5 * error
# + Q[state][action][other_action] += 1.0 * error

# %% no discount
# says: the discount is missing: γ is 0.9
# in: step by step
# - target = reward + 0.9 * V[next_state]
# + target = reward + V[next_state]

# %% no future
# says: the value of the next state is missing in the target
# in: step by step
# - target = reward + 0.9 * V[next_state]
# + target = reward

# %% the other's reward
# says: the reward counts with the wrong sign; it is your own
# in: step by step
# - if terminated:
# + reward = -reward
# + if terminated:

# %% of its own
# says: `learn` changes neither Q nor V: write into the arrays that it is given, Q[...] += ... and V[state] = ...
# in: step by step
# - if terminated:
# + Q, V = Q.copy(), V.copy()
# + if terminated:

# %% three tenths
# says: none of the usual mistakes
# in: step by step
# - Q[state][action][other_action] += 0.5 * error
# + Q[state][action][other_action] += 0.3 * error

# %% an equilibrium for a number
# says: raises ValueError
# in: step by step
# - V[state], _, _ = games.solve_zero_sum(Q[state])
# + V[state] = games.solve_zero_sum(Q[state])

# %% the class
# says: Q, V, state, action, other_action, reward, next_state and terminated
learn = games.MinimaxQ

# %% all discounted
# says: the reward is discounted, too; only the value of the next state is
# in: the solution of learn
# - target = reward if terminated else reward + 0.9 * V[next_state]
# + target = 0.9 * (reward if terminated else reward + V[next_state])

# %% rates swapped
# says: α and γ have changed places: α = 0.5, and γ = 0.9
# in: the solution of learn
# - target = reward if terminated else reward + 0.9 * V[next_state]
# + target = reward if terminated else reward + 0.5 * V[next_state]
# - Q[state, action, other_action] += 0.5 * (target - Q[state, action, other_action])
# + Q[state, action, other_action] += 0.9 * (target - Q[state, action, other_action])

# %% no last reward
# says: the reward of the last step is lost: where `terminated` is True, the target is the reward
# in: the solution of learn
# - target = reward if terminated else reward + 0.9 * V[next_state]
# + target = 0 if terminated else reward + 0.9 * V[next_state]

# %% nothing at the end
# says: the step that ends the game changes nothing; it has a target too, the reward
# in: the solution of learn
# - target = reward if terminated else reward + 0.9 * V[next_state]
# + if terminated:
# +     return
# + target = reward + 0.9 * V[next_state]

# %% away from it
# says: the value moves *away* from the target: the error is the target less the old value
# in: the solution of learn
# - Q[state, action, other_action] += 0.5 * (target - Q[state, action, other_action])
# + Q[state, action, other_action] -= 0.5 * (target - Q[state, action, other_action])

# %% the target added
# says: − Q(S, A, O) is left out: the target takes the place of the error
# in: the solution of learn
# - Q[state, action, other_action] += 0.5 * (target - Q[state, action, other_action])
# + Q[state, action, other_action] += 0.5 * target

# %% a copy
# says: Q is copied, and the copy changes; write into the array that is given
# in: the solution of learn
# - target = reward if terminated else reward + 0.9 * V[next_state]
# + target = reward if terminated else reward + 0.9 * V[next_state]
# + Q = Q.copy()

# %% axes mixed up
# says: V is max_o min_a Q, with the axes mixed up; it is the value of the game
# in: the solution of learn
# - V[state] = games.solve_zero_sum(Q[state]).value
# + V[state] = Q[state].min(axis=0).max()

# %% the mean of the game
# says: V is the mean of Q[state]; it is the value of the game
# in: the solution of learn
# - V[state] = games.solve_zero_sum(Q[state]).value
# + V[state] = Q[state].mean()

# %% half of the way
# says: V goes half of the way to the value of the game; it *is* the value of Q[state]
# in: the solution of learn
# - V[state] = games.solve_zero_sum(Q[state]).value
# + V[state] += 0.5 * (games.solve_zero_sum(Q[state]).value - V[state])

# %% all states
# says: the games of all states are solved anew; only that of `state` has changed
# in: the solution of learn
# - V[state] = games.solve_zero_sum(Q[state]).value
# + V[:] = [games.solve_zero_sum(one).value for one in Q]

# %% solved in the target
# says: the target solves the game of the next state anew; its value stands in V[next_state]
# in: the solution of learn
# - target = reward if terminated else reward + 0.9 * V[next_state]
# + target = reward if terminated else reward + 0.9 * games.solve_zero_sum(Q[next_state]).value


# %% less V
# says: the error is the target less V[state]; it is the target less the old Q(S, A, O)
# in: the solution of learn
# - Q[state, action, other_action] += 0.5 * (target - Q[state, action, other_action])
# + Q[state, action, other_action] += 0.5 * (target - V[state])


# %% a column
# says: all entries Q[state, :, other_action] change; your own action has a number, too
# in: the solution of learn
# - Q[state, action, other_action] += 0.5 * (target - Q[state, action, other_action])
# + Q[state, :, other_action] += 0.5 * (target - Q[state, :, other_action])


# %% the entry
# says: V is the entry of the two actions that were taken; it is the value of the game
# in: the solution of learn
# - V[state] = games.solve_zero_sum(Q[state]).value
# + V[state] = Q[state, action, other_action]


# %% not at the end
# says: V stays where the game ends; Q[state] has changed there, too
# in: the solution of learn
# - V[state] = games.solve_zero_sum(Q[state]).value
# + if not terminated:
# +     V[state] = games.solve_zero_sum(Q[state]).value


# %% subtracted
# says: what follows is subtracted; it is added to the reward
# in: the solution of learn
# - target = reward if terminated else reward + 0.9 * V[next_state]
# + target = reward if terminated else reward - 0.9 * V[next_state]


# %% the wrong sign of V
# says: V has the wrong sign: it is your own value, and your own actions are the rows
# in: step by step
# - V[state], _, _ = games.solve_zero_sum(Q[state])
# + V[state] = -games.solve_zero_sum(Q[state]).value


# %% best and worst mixed up
# says: V is min_a max_o Q, with best and worst mixed up; it is the value of the game
# in: step by step
# - V[state], _, _ = games.solve_zero_sum(Q[state])
# + V[state] = Q[state].max(axis=1).min()


# %% the discount for the learning rate
# says: the step is 0.9 of the way to the target; α is 0.5
# in: step by step
# - Q[state][action][other_action] += 0.5 * error
# + Q[state][action][other_action] += 0.9 * error


# %% the mean of the next state
# says: the target has the mean of Q[next_state]; it is V[next_state]
# in: step by step
# - target = reward + 0.9 * V[next_state]
# + target = reward + 0.9 * Q[next_state].mean()


# %% an unusual V
# says: Q is right in all cases, so look at V: V[state] is the value of the matrix game Q[state]
# in: step by step
# - V[state], _, _ = games.solve_zero_sum(Q[state])
# + V[state] = Q[state].min()


# %% an unusual future
# says: Q is right where the game ends, so look at what follows elsewhere: γ times V[next_state]
# in: step by step
# - target = reward + 0.9 * V[next_state]
# + target = reward + 0.9 * Q[next_state].min()


# %% an unusual end
# says: Q is right where the game goes on, so look at the end: there the target is the reward
# in: step by step
# - target = reward
# + target = V[state]


# %% a number that is taken out
# says: Q stays as it was: a number taken out of an array is a copy, so write into Q[state, action, other_action]
def learn(Q, V, state, action, other_action, reward, next_state, terminated):
    target = reward if terminated else reward + 0.9 * V[next_state]
    q = Q[state, action, other_action]
    q += 0.5 * (target - q)
    V[state] = games.solve_zero_sum(Q[state]).value


# %% another learning rate
# says: the step is a tenth of the way to the target; α is 0.5
def learn(Q, V, state, action, other_action, reward, next_state, terminated):
    target = reward if terminated else reward + 0.9 * V[next_state]
    Q[state, action, other_action] += 0.1 * (target - Q[state, action, other_action])
    V[state] = games.solve_zero_sum(Q[state]).value


# %% the whole table of the state
# says: all entries of Q[state] change; the pair of actions has one number
def learn(Q, V, state, action, other_action, reward, next_state, terminated):
    target = reward if terminated else reward + 0.9 * V[next_state]
    Q[state] += 0.5 * (target - Q[state])
    V[state] = games.solve_zero_sum(Q[state]).value


# %% twice
# says: the step is taken twice; once is enough
def learn(Q, V, state, action, other_action, reward, next_state, terminated):
    target = reward if terminated else reward + 0.9 * V[next_state]
    for _ in range(2):
        Q[state, action, other_action] += 0.5 * (target - Q[state, action, other_action])
    V[state] = games.solve_zero_sum(Q[state]).value


# %% no parentheses
# says: the old value goes wholly, so Q is α times the target: put the target − Q(S, A, O) in parentheses
def learn(Q, V, state, action, other_action, reward, next_state, terminated):
    future = 0 if terminated else V[next_state]
    Q[state, action, other_action] += 0.5 * (reward + 0.9 * future) - Q[state, action, other_action]
    V[state] = games.solve_zero_sum(Q[state]).value


# %% V alone
# says: V moves towards the target, and Q stays: first Q, and V is then the value of the matrix game Q[state]
def learn(Q, V, state, action, other_action, reward, next_state, terminated):
    target = reward if terminated else reward + 0.9 * V[next_state]
    V[state] += 0.5 * (target - V[state])
