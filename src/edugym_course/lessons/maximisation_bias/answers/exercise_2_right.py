# %% both cases written out
# says: Right: who chooses the action does not say what it is worth.
def double_update(Q1, Q2, first, state, action, reward, next_state, terminated, learning_rate, discount):
    if first:
        best = np.argmax(Q1[next_state])
        target = reward if terminated else reward + discount * Q2[next_state, best]
        Q1[state, action] += learning_rate * (target - Q1[state, action])
    else:
        best = np.argmax(Q2[next_state])
        target = reward if terminated else reward + discount * Q1[next_state, best]
        Q2[state, action] += learning_rate * (target - Q2[state, action])


# %% with a factor
def double_update(Q1, Q2, first, state, action, reward, next_state, terminated, learning_rate, discount):
    tables = [Q1, Q2]
    i = 0 if first else 1
    own, other = tables[i], tables[1 - i]
    future = other[next_state][own[next_state].argmax()] * (1 - terminated)
    own[state, action] = (1 - learning_rate) * own[state, action] + learning_rate * (reward + discount * future)
