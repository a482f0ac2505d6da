# %% from the first to the last
# says: the rewards are gone through from the first to the last; the *last* one comes first, for what follows it is known by then
# in: from the end, by places
# - for place in range(len(path) - 1, -1, -1):
# + for place in range(len(path)):

# %% no discount
# says: the discount is left out
# in: from the end, by places
# - G = rewards[place] + discount * G
# + G = rewards[place] + G

# %% the last reward for all
# says: every node gets the same return: on the way up each reward is added to what followed it
# in: from the end, by places
# - G = rewards[place] + discount * G
# + G = rewards[place] + discount * G if place == len(path) - 1 else G

# %% no roll-out
# says: the return of the roll-out is left out; G begins with it
# in: from the end, by places
# - G = rewards[place] + discount * G
# + G = rewards[place] + (discount * G if place < len(path) - 1 else 0)

# %% the latest return
# says: a value becomes the latest return; it is the *mean* of all
# in: from the end, by places
# - values[node, action] = values[node, action] + (G - values[node, action]) / n
# + values[node, action] = G

# %% a sum
# says: a value becomes the sum of the returns; it is their mean
# in: from the end, by places
# - values[node, action] = values[node, action] + (G - values[node, action]) / n
# + values[node, action] = values[node, action] + G

# %% nothing subtracted
# says: − Q(node, A) is left out: the return takes the place of the error
# in: from the end, by places
# - values[node, action] = values[node, action] + (G - values[node, action]) / n
# + values[node, action] = values[node, action] + G / n

# %% counted afterwards
# says: the error is divided by the number before this simulation: first count, then divide
# in: from the end, by places
# - n = counts[node, action]
# + n = max(counts[node, action] - 1, 1)

# %% counted twice
# says: the error is divided by one too many: this simulation counts once
# in: from the end, by places
# - n = counts[node, action]
# + n = counts[node, action] + 1

# %% not counted
# says: the simulation is not counted: N(node, A) goes up by 1
# in: from the end, by places
# - counts[node, action] += 1
# - n = counts[node, action]
# + n = counts[node, action] + 1

# %% the root alone
# says: only the root learns; every node on the path does
# in: from the end, by places
# - counts[node, action] += 1
# + if place > 0:
# +     continue
# + counts[node, action] += 1

# %% copies
# says: changes nothing: change entries in place, as in values[node, action] += ..., and return nothing
# in: from the end, by places
# - for place in range(len(path) - 1, -1, -1):
# + values, counts = values.copy(), counts.copy()
# + for place in range(len(path) - 1, -1, -1):

# %% a table
# says: values, counts, path, rewards, G and discount
back_up = [1, 2]
