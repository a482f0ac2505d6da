# %% from the end, by places
# says: Right: one pass backwards, and every node on the path has learned.
def back_up(values, counts, path, rewards, G, discount):
    for place in range(len(path) - 1, -1, -1):
        node, action = path[place]
        G = rewards[place] + discount * G
        counts[node, action] += 1
        n = counts[node, action]
        values[node, action] = values[node, action] + (G - values[node, action]) / n


# %% sums
def back_up(values, counts, path, rewards, G, discount):
    returns = []
    for reward in rewards[::-1]:
        G = reward + discount * G
        returns.insert(0, G)
    for pair, followed in zip(path, returns, strict=True):
        total = values[pair] * counts[pair] + followed
        counts[pair] += 1
        values[pair] = total / counts[pair]
