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

# %% below the root
# says: the root does not learn; every node on the path does
# in: from the end, by places
# - for place in range(len(path) - 1, -1, -1):
# + for place in range(len(path) - 1, 0, -1):

# %% the path alone from its end
# says: only `path` is gone through from its end; `rewards` goes with it
# in: from the end, by places
# - G = rewards[place] + discount * G
# + G = rewards[-1 - place] + discount * G

# %% the rewards alone from their end
# says: only `rewards` is gone through from its end; `path` goes with it
# in: from the end, by places
# - node, action = path[place]
# + node, action = path[-1 - place]

# %% G comes late
# says: the value moves before G has this step's reward: first G, then the value
# in: from the end, by places
# - values[node, action] = values[node, action] + (G - values[node, action]) / n
# + values[node, action] = values[node, action] + (followed - values[node, action]) / n
# - G = rewards[place] + discount * G
# + followed, G = G, rewards[place] + discount * G

# %% all discounted
# says: the reward is discounted, too; γ only stands before what follows
# in: from the end, by places
# - G = rewards[place] + discount * G
# + G = discount * (rewards[place] + G)

# %% the root's return for all
# says: every node gets the return from the root on; each learns from what followed after *it*
# in: from the end, by places
# - for place in range(len(path) - 1, -1, -1):
# + for reward in reversed(rewards):
# +     G = reward + discount * G
# + for place in range(len(path)):
# - G = rewards[place] + discount * G
# + pass

# %% the number of the node
# says: the error is divided by all choices in the node; N(node, A) counts this action alone
# in: from the end, by places
# - n = counts[node, action]
# + n = counts[node].sum()

# %% a whole row
# says: all actions of a node change; only the one that was taken does
# in: from the end, by places
# - counts[node, action] += 1
# + counts[node] += 1
# - n = counts[node, action]
# + n = counts[node]
# - values[node, action] = values[node, action] + (G - values[node, action]) / n
# + values[node] = values[node] + (G - values[node]) / n

# %% the highest value
# says: the highest value of a node is passed on; it is the return of this simulation
# in: from the end, by places
# - values[node, action] = values[node, action] + (G - values[node, action]) / n
# + values[node, action] = values[node, action] + (G - values[node, action]) / n
# + G = values[node].max()

# %% the roll-out alone
# says: every node gets the return of the roll-out as it is; on the way up the rewards are added
# in: from the end, by places
# - G = rewards[place] + discount * G
# + pass

# %% the roll-out behind each reward
# says: behind each reward follows the return of the roll-out; what follows is the G of the step after
# in: sums
# - returns = []
# + returns, followed = [], G
# - G = reward + discount * G
# + G = reward + discount * followed

# %% once too often
# says: γ stands before the return of the roll-out once too often
# in: sums
# - returns = []
# + returns, G = [], discount * G

# %% the highest return
# says: a value becomes the highest return; it is the *mean* of all
# in: from the end, by places
# - values[node, action] = values[node, action] + (G - values[node, action]) / n
# + values[node, action] = max(values[node, action], G)

# %% a return in the loop
# says: only the last node on the path learns: does a `return` stand inside the loop?
# in: from the end, by places
# - values[node, action] = values[node, action] + (G - values[node, action]) / n
# + values[node, action] = values[node, action] + (G - values[node, action]) / n
# + return

# %% the value is passed on
# says: the new value of a node is passed on; it is the return of this simulation
# in: from the end, by places
# - values[node, action] = values[node, action] + (G - values[node, action]) / n
# + values[node, action] = values[node, action] + (G - values[node, action]) / n
# + G = values[node, action]

# %% all are counted
# says: all actions of a node are counted; only the one that was taken is
# in: from the end, by places
# - counts[node, action] += 1
# + counts[node] += 1

# %% the reward alone is discounted
# says: γ stands before the reward; it stands before what follows
# in: from the end, by places
# - G = rewards[place] + discount * G
# + G = discount * rewards[place] + G

# %% half of both
# says: a value becomes the mean of the old value and the return; the old value stands for all returns before
# in: from the end, by places
# - values[node, action] = values[node, action] + (G - values[node, action]) / n
# + values[node, action] = (values[node, action] + G) / 2

# %% away
# says: the value moves away from the return: is it G − Q(node, A), with this sign?
# in: from the end, by places
# - values[node, action] = values[node, action] + (G - values[node, action]) / n
# + values[node, action] = values[node, action] - (G - values[node, action]) / n

# %% begun one too early
# says: the last step of the path is left out: does the loop begin at len(path) - 1?
# in: from the end, by places
# - for place in range(len(path) - 1, -1, -1):
# + for place in range(len(path) - 2, -1, -1):


# %% the path is used up
# says: changes its list `path`; make a new one, for the caller still needs the old one
def back_up(values, counts, path, rewards, G, discount):
    while path:
        entry = path.pop()
        G = rewards.pop() + discount * G
        counts[entry] += 1
        values[entry] += (G - values[entry]) / counts[entry]


# %% the roll-out without its discount
# says: γ is missing before the return of the roll-out
def back_up(values, counts, path, rewards, G, discount):
    for k, (node, action) in enumerate(path):
        following = [*rewards[k:-1], rewards[-1] + G]
        total = sum(discount**j * reward for j, reward in enumerate(following))
        counts[node, action] += 1
        values[node, action] += (total - values[node, action]) / counts[node, action]
