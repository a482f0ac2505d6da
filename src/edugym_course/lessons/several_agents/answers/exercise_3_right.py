# %% a mean of old and new
# says: Right: it is Q-learning with one change. The value of a state is that of its matrix game.
def learn(Q, V, state, action, other_action, reward, next_state, terminated):
    future = 0.0 if terminated else V[next_state]
    Q[state, action, other_action] = 0.5 * Q[state, action, other_action] + 0.5 * (reward + 0.9 * future)
    V[state] = games.solve_zero_sum(Q[state]).value


# %% step by step
def learn(Q, V, state, action, other_action, reward, next_state, terminated):
    if terminated:
        target = reward
    else:
        target = reward + 0.9 * V[next_state]
    error = target - Q[state][action][other_action]
    Q[state][action][other_action] += 0.5 * error
    V[state], _, _ = games.solve_zero_sum(Q[state])


# %% not terminated is 1
def learn(Q, V, state, action, other_action, reward, next_state, terminated):
    pair = state, action, other_action
    Q[pair] -= 0.5 * (Q[pair] - reward - 0.9 * V[next_state] * (1 - terminated))
    V[state] = games.solve_zero_sum(Q[state]).value
