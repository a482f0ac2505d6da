# %% no end
# slow
# says: what is learned at the end of an episode is left out, and that is where the reward often is: learn first, and look then whether the episode is over
# in: weights in an array
# - theta[:, a] += 0.01 * delta * x
# + if not (terminated or truncated):
# +     theta[:, a] += 0.01 * delta * x

# %% the old message after a reset
# slow
# says: after an end the program goes on from the last state of the old episode: state, info = environment.reset() gives the first state of the new one
# in: weights in an array
# - o, _ = environment.reset()
# + environment.reset()

# %% the first message for ever
# slow
# says: the state stays the first one of the episode: is `state = next_state` missing?
# in: weights in an array
# - o = o2

# %% the least value
# slow
# says: low values are preferred to high ones: is there an `argmin`, or a minus sign too many, or does the value of one action stand in the place of another?
# in: weights in an array
# - a = int(rng.integers(N)) if rng.random() < 0.1 else int(q.argmax())
# + a = int(rng.integers(N)) if rng.random() < 0.1 else int(q.argmin())

# %% a row for each message
# slow
# says: each message is learned for itself, as in a row of a table: share what is learned by words
def my_program(environment, n_steps, seed):
    Q, rng = {}, np.random.default_rng(seed)
    o, _ = environment.reset(seed=seed)

    def row(o):
        return Q.setdefault(tuple(o[1:]), np.zeros(environment.action_space.n))

    for _ in range(n_steps):
        q = row(o)
        a = int(rng.integers(len(q))) if rng.random() < 0.1 else int(q.argmax())
        o, r, terminated, truncated, _ = environment.step(a)
        q[a] += 0.01 * (r - q[a])
        if terminated or truncated:
            o, _ = environment.reset()
    return lambda o: int(row(o).argmax())


# %% the places of words
# slow
# says: the place of a word in the message counts, and it should not
# in: weights in an array
# - theta = np.zeros((W, N))
# + theta = np.zeros((W * L, N))
# - x = np.zeros(W)
# + x = np.zeros(W * L)
# - x[o[k]] += 1 / L
# + x[o[k] * L + k - 1] += 1 / L

# %% the first word
# slow
# says: the first word alone is heard
# in: weights in an array
# - for k in range(1, L + 1):
# -     x[o[k]] += 1 / L
# + x[o[1]] = 1

# %% presence
# slow
# says: a word counts once, however often it occurs: x_w is its share of the message
# in: weights in an array
# - x[o[k]] += 1 / L
# + x[o[k]] = 1 / L

# %% counts, not shares
# slow
# says: the counts are not divided by the length L of the message
# in: weights in an array
# - x[o[k]] += 1 / L
# + x[o[k]] += 1

# %% the reward alone
# slow
# says: the weights move by R, not by R − q(O, A): without the difference they grow without end
# in: weights in an array
# - delta = r - q[a]
# + delta = r

# %% all actions
# slow
# says: the values of all actions are alike: do the weights of all move, or of none, or begin anew in each episode, or are all actions drawn at random? Learn about the one that was taken
# in: weights in an array
# - delta = r - q[a]
# - theta[:, a] += 0.01 * delta * x
# + delta = r - q
# + theta += 0.01 * np.outer(x, delta)

# %% a large rate
# slow
# says: the learning rate is much too large: it is 0.01 in the text
# in: weights in an array
# - theta[:, a] += 0.01 * delta * x
# + theta[:, a] += 0.5 * delta * x

# %% the hit points as a word
# slow
# says: ; the words are all entries of an observation but the first, and only the weights of the action taken move
# in: weights in an array
# - for k in range(1, L + 1):
# -     x[o[k]] += 1 / L
# + for k in range(L):
# +     x[o[k] % W] += 1 / L


# %% the weights of the next message
# slow
# says: the weights of the *next* message move: those of the message before the action should
# in: weights in an array
# - theta[:, a] += 0.01 * delta * x
# + theta[:, a] += 0.01 * delta * shares(o2)

# %% the next message alone
# slow
# says: it learns from the *next* message alone: keep the one before the action until its weights have moved
# in: a dictionary, word by word
# - listener.learn(words, action, reward)
# - words, over, steps = next_words, terminated or truncated, steps + 1
# + words, over, steps = next_words, terminated or truncated, steps + 1
# + listener.learn(words, action, reward)

# %% the value of the next message
# slow
# says: the value in R − q(O, A) is that of the *next* message: O is the one before the action
# in: weights in an array
# - delta = r - q[a]
# + delta = r - (shares(o2) @ theta)[a]

# %% nothing is learned
# slow
# says: the values of all actions are alike: do the weights of all move, or of none, or begin anew in each episode, or are all actions drawn at random? Learn about the one that was taken
# in: weights in an array
# - theta[:, a] += 0.01 * delta * x

# %% divided by L + 1
# slow
# says: the counts are divided by more than L, as by the length L + 1 of the observation: its first entry is no word
# in: weights in an array
# - x[o[k]] += 1 / L
# + x[o[k]] += 1 / len(o)

# %% without the first word
# slow
# says: the first word of each message is left out: the words begin with entry 1 of the observation
# in: weights in an array
# - for k in range(1, L + 1):
# + for k in range(2, L + 1):

# %% without the last word
# slow
# says: the last word of each message is left out: is a `range` too short?
# in: weights in an array
# - for k in range(1, L + 1):
# + for k in range(1, L):

# %% ε the wrong way round
# slow
# says: An action that looks best is as rare as a random one should be: have ε and 1 − ε changed places, or does the update move another value than Q(S, A), that of the action taken in the state that was left?
# in: weights in an array
# - a = int(rng.integers(N)) if rng.random() < 0.1 else int(q.argmax())
# + a = int(rng.integers(N)) if rng.random() > 0.1 else int(q.argmax())

# %% words with a fixed meaning
# slow
# says: observations the policy that my_program returns takes another action than the one that the steps of the program make look best
# in: weights in an array
# - return lambda o: int((shares(o) @ theta).argmax())
# + return lambda o: int(np.bincount(o[1:] % 4, minlength=4).argmax())

# %% a rate of 0.1
# slow
# says: the learning rate is too large, as 0.1: it is 0.01 in the text
# in: weights in an array
# - theta[:, a] += 0.01 * delta * x
# + theta[:, a] += 0.1 * delta * x

# %% a rate of 0.001
# slow
# says: the learning rate is much too small: it is 0.01 in the text
# in: weights in an array
# - theta[:, a] += 0.01 * delta * x
# + theta[:, a] += 0.001 * delta * x

# %% one step of Q-learning
# slow
# says: γ is 0.5, and it should be 0: the reward stands alone, without the value of the next message
# in: weights in an array
# - delta = r - q[a]
# + delta = r + (0.0 if terminated else 0.5 * (shares(o2) @ theta).max()) - q[a]

# %% Q-learning that looks far ahead
# slow
# says: γ is near 1, and it should be 0: the reward stands alone, without the value of the next message
# in: weights in an array
# - delta = r - q[a]
# + delta = r + (0.0 if terminated else 0.9 * (shares(o2) @ theta).max()) - q[a]

# %% first weights of 1
# slow
# says: the first weights are 1, and they should be 0
# in: weights in an array
# - theta = np.zeros((W, N))
# + theta = np.ones((W, N))

# %% first weights of 10
# slow
# says: the first weights are far above 0, as 10, and they should be 0
# in: weights in an array
# - theta = np.zeros((W, N))
# + theta = 10 * np.ones((W, N))

# %% the rest of each word
# slow
# says: words with the same rest, divided by the number of actions, share their weights; what a word means has to be learned
# in: weights in an array
# - x[o[k]] += 1 / L
# + x[o[k] % N] += 1 / L

# %% each word by itself
# slow
# says: each weight moves by R − θ, the error of its own word alone; q(O, A) is the sum over all words
# in: weights in an array
# - delta = r - q[a]
# - theta[:, a] += 0.01 * delta * x
# + theta[:, a] += 0.01 * (r - theta[:, a]) * x

# %% all words alike
# slow
# says: the weights of all words of a message move alike: the factor x_w(O) is missing in their step
# in: weights in an array
# - theta[:, a] += 0.01 * delta * x
# + theta[x > 0, a] += 0.01 * delta

# %% the last word
# slow
# says: the last word alone is heard: is x overwritten in a loop?
# in: weights in an array
# - x[o[k]] += 1 / L
# + x = np.zeros(W)
# + x[o[k]] = 1

# %% all weights of the action
# slow
# says: the weights of all words move, and those of the words that are not in the message should stay
# in: weights in an array
# - theta[:, a] += 0.01 * delta * x
# + theta[:, a] += 0.01 * delta

# %% always four actions
# slow
# says: my_program chooses the action 3: there are the actions 0 to 2
# in: weights in an array
# - environment.action_space.n,
# + 4,

# %% never the best one by chance
# slow
# says: or is the random action drawn among the others? (
# says: a random action may be any of them, the best one too
# in: weights in an array
# - a = int(rng.integers(N)) if rng.random() < 0.1 else int(q.argmax())
# + a = int(q.argmax())
# + if rng.random() < 0.1:
# +     a = int(rng.choice([other for other in range(N) if other != a]))

# %% R less the largest value
# slow
# says: the *largest* value is subtracted from R; it should be q(O, A), that of the action that was taken
# in: weights in an array
# - delta = r - q[a]
# + delta = r - q.max()

# %% ε is a half
# slow
# says: If all that is right, ε is about 0.5
# in: weights in an array
# - a = int(rng.integers(N)) if rng.random() < 0.1 else int(q.argmax())
# + a = int(rng.integers(N)) if rng.random() < 0.5 else int(q.argmax())

# %% the largest weight of each word
# slow
# says: the sum of the largest weights of the words is subtracted from R; it should be q(O, A), of the action that was taken
# in: weights in an array
# - delta = r - q[a]
# + delta = r - x @ theta.max(axis=1)

# %% twice the learning rate
# slow
# says: the learning rate is too large, as 0.02: it is 0.01 in the text
# in: weights in an array
# - theta[:, a] += 0.01 * delta * x
# + theta[:, a] += 0.02 * delta * x

# %% a policy that cuts the hit points twice
# slow
# says: does this policy look up the state that it is given, and take the *best* action, by values learned from all steps?
# in: weights in an array
# - return lambda o: int((shares(o) @ theta).argmax())
# + return lambda o: int((shares([0, *o[2:], o[-1]]) @ theta).argmax())

# %% the policy of half of the steps
# slow
# says: does this policy look up the state that it is given, and take the *best* action, by values learned from all steps?
# in: weights in an array
# - for _ in range(n_steps):
# + for t in range(n_steps):
# +     if t == n_steps // 2:
# +         old = theta.copy()
# - return lambda o: int((shares(o) @ theta).argmax())
# + return lambda o: int((shares(o) @ old).argmax())

# %% each row moves once
# slow
# says: a word moves once, however often it occurs: `theta[words, a] += ...` adds to a row once, `np.add.at` for each word
# in: weights in an array
# - theta[:, a] += 0.01 * delta * x
# + theta[o[1:], a] += 0.01 * delta / L

# %% nothing from the last step
# slow
# says: nothing is learned from the last step of an episode: its reward counts like any other
# in: weights in an array
# - theta[:, a] += 0.01 * delta * x
# + theta[:, a] += 0.01 * delta * x * (not terminated)

# %% nothing from a truncated step
# slow
# says: nothing is learned from a step that is truncated: its reward counts like any other
# in: weights in an array
# - theta[:, a] += 0.01 * delta * x
# + theta[:, a] += 0.01 * delta * x * (not truncated)

# %% twice as far for a word that comes twice
# slow
# says: a word that occurs twice is moved twice, each time by 2/L: go through the *different* words, or move each by 1/L
# in: a dictionary, word by word
# - self.weights[w, a] = self.weights.get((w, a), 0.0) + 0.01 * error / len(words)
# + self.weights[w, a] = self.weights.get((w, a), 0.0) + 0.01 * error * list(words).count(w) / len(words)
