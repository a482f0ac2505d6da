# %% up the slope
# slow
# says: It takes the same action for every image. Do its values become NaN? The usual reasons: W2 is changed before it hands the gradient back to W1, a minus sign is missing, or a learning rate is too large. Or are all first weights 0, all pixels rounded to 0 or 1, or all stored images one array, and not copies?
# in: a memory in arrays
# - self.W[1] -= 0.2 * h.T @ d / len(x)
# - self.W[0] -= 0.2 * x.T @ back / len(x)
# + self.W[1] += 0.2 * h.T @ d / len(x)
# + self.W[0] += 0.2 * x.T @ back / len(x)

# %% the worst
# slow
# says: It takes the worst actions: is the sign of the gradient wrong, is there an `argmin`, or is another action or reward stored than that of the step?
# in: a memory in arrays
# - return int(self.layers(image.reshape(1, -1))[2].argmax())
# + return int(self.layers(image.reshape(1, -1))[2].argmin())

# %% reward with a minus
# slow
# says: It takes the worst actions: is the sign of the gradient wrong, is there an `argmin`, or is another action or reward stored than that of the step?
# in: SARSA from each step once
# - delta = r - Q[a] if terminated else r + 0.9 * q(x2)[1][a2] - Q[a]
# + delta = -r - Q[a] if terminated else -r + 0.9 * q(x2)[1][a2] - Q[a]

# %% too fast
# slow
# says: It takes the same action for every image. Do its values become NaN? The usual reasons: W2 is changed before it hands the gradient back to W1, a minus sign is missing, or a learning rate is too large. Or are all first weights 0, all pixels rounded to 0 or 1, or all stored images one array, and not copies?
# in: SARSA from each step once
# - W += 0.05 * delta * np.outer(g, x)
# + W += 5.0 * delta * np.outer(g, x)

# %% too slow
# slow
# says: in a riddle of six images, the policy of
# says:  takes the right action in
# says:  of the questions after
# says:  steps; by chance it would be 33%.
# says: , so it learns too slowly: likely a learning rate or first weights that are too small, too few updates, weights that are never learned, or an ε below 0.1
# in: a memory in arrays
# - self.W[1] -= 0.2 * h.T @ d / len(x)
# - self.W[0] -= 0.2 * x.T @ back / len(x)
# + self.W[1] -= 0.002 * h.T @ d / len(x)
# + self.W[0] -= 0.002 * x.T @ back / len(x)

# %% weights of 0
# slow
# says: It takes the same action for every image. Do its values become NaN? The usual reasons: W2 is changed before it hands the gradient back to W1, a minus sign is missing, or a learning rate is too large. Or are all first weights 0, all pixels rounded to 0 or 1, or all stored images one array, and not copies?
# in: SARSA from each step once
# - W, b = rng.normal(0, np.sqrt(2 / n), (64, n)), np.zeros(64)
# - V, c = rng.normal(0, 0.1, (k, 64)), np.zeros(k)
# + W, b = np.zeros((64, n)), np.zeros(64)
# + V, c = np.zeros((k, 64)), np.zeros(k)

# %% rewards only
# slow
# says: the right action brings nothing but a better next image: the target is R + γ max Q(S', a), and S' is the state of the next step
# in: a memory in arrays
# - y = R[i] + 0.9 * goes_on[i] * old.layers(S2[i])[2].max(axis=1)
# + y = R[i]

# %% no end
# slow
# says: Its actions change with the image that it is shown after a terminated end, and nothing should hang on it: where `terminated` is True, the target is R alone, and the program goes on from the image that *reset* gives. (Or is its maximum over a whole batch, and not over the actions of each row? Or does W1 learn from that image, and not from the one in which the action was taken?)
# in: a memory in arrays
# - y = R[i] + 0.9 * goes_on[i] * old.layers(S2[i])[2].max(axis=1)
# + y = R[i] + 0.9 * old.layers(S2[i])[2].max(axis=1)

# %% a truncated end
# slow
# says: after the right action the episode is truncated: the clock was stopped, and the image that step gave (not that of reset) still has its value, so only `terminated` makes R alone the target
# in: a memory in arrays
# - S[t], A[t], R[t], S2[t], goes_on[t] = s.ravel(), a, r, s2.ravel(), not terminated
# + S[t], A[t], R[t], S2[t], goes_on[t] = s.ravel(), a, r, s2.ravel(), not (terminated or truncated)

# %% the image of reset
# slow
# says: after the right action the episode is truncated: the clock was stopped, and the image that step gave (not that of reset) still has its value, so only `terminated` makes R alone the target
# in: a memory in arrays
# - S[t], A[t], R[t], S2[t], goes_on[t] = s.ravel(), a, r, s2.ravel(), not terminated
# - s = s2
# + last = s.ravel()
# + s = environment.reset()[0] if terminated or truncated else s2
# + S[t], A[t], R[t], S2[t], goes_on[t] = last, a, r, s.ravel(), not terminated
# - if terminated or truncated:
# -     s, _ = environment.reset()

# %% the first state for ever
# slow
# says: while it learned, it caught
# says:  in the end. A policy sees a new image at each step. Does the program, too, or is `state = next_state` missing?
# in: a memory in arrays
# - s = s2

# %% all actions
# slow
# says: In this riddle,
# says: the right action brings 1 at once, and another one −1: does the gradient go back through both layers, to the weights of the action that was taken? Is each image stored with its own action and reward, and as numbers from 0 to 1, not as whole numbers?
# in: a memory in arrays
# - d = np.where(np.arange(q.shape[1]) == a[:, None], q - y[:, None], 0.0).clip(-1, 1)
# + d = (q - y[:, None]).clip(-1, 1)

# %% a target that is never brought up to date
# slow
# says: the right action brings nothing but a better next image: the target is R + γ max Q(S', a), and S' is the state of the next step
# in: a memory in arrays
# - if t % 50 == 0:
# + if t == 0:

# %% a random policy
# slow
# says: While it learned, it did: does the policy compute the values of the image that it is given, without ε? If it does, they have changed once more in the last steps: is the learning rate too large, or are rows of a batch drawn that were never stored?
# in: a memory in arrays
# - return network.best
# + return lambda image: int(rng.integers(k))

# %% a table of images
# slow
# says: it solves the riddles, but in the middle one of
# says:  runs on Catch in changing light it catches
# says:  of the balls, and it should be 70% or more: in steady light it catches
# says: : it knows the images that it met, as a table does, and here none comes twice
def my_program(environment, n_steps, seed):
    rng = np.random.default_rng(seed)
    Q = {}

    def row(s):
        return Q.setdefault(s.tobytes(), np.zeros(environment.action_space.n))

    def best(s):
        return int(rng.choice(np.flatnonzero(row(s) == row(s).max())))

    s, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        a = int(rng.integers(environment.action_space.n)) if rng.random() < 0.1 else best(s)
        s2, r, terminated, truncated, _ = environment.step(a)
        y = r if terminated else r + 0.9 * row(s2).max()
        row(s)[a] += 0.3 * (y - row(s)[a])
        s = environment.reset()[0] if terminated or truncated else s2
    return best


# %% no seed
# says: does not repeat itself
# in: SARSA from each step once
# - rng = np.random.default_rng(seed)
# + rng = np.random.default_rng()

# %% no end, one step at a time
# slow
# says: Its actions change with the image that it is shown after a terminated end, and nothing should hang on it: where `terminated` is True, the target is R alone, and the program goes on from the image that *reset* gives. (Or is its maximum over a whole batch, and not over the actions of each row? Or does W1 learn from that image, and not from the one in which the action was taken?)
# in: SARSA from each step once
# - delta = r - Q[a] if terminated else r + 0.9 * q(x2)[1][a2] - Q[a]
# + delta = r + 0.9 * q(x2)[1][a2] - Q[a]

# %% W2 before W1
# slow
# says: It takes the same action for every image. Do its values become NaN? The usual reasons: W2 is changed before it hands the gradient back to W1, a minus sign is missing, or a learning rate is too large. Or are all first weights 0, all pixels rounded to 0 or 1, or all stored images one array, and not copies?
# in: SARSA from each step once
# - g = V[a] * (h > 0)
# - V[a] += 0.05 * delta * h
# + V[a] += 0.05 * delta * h
# + g = V[a] * (h > 0)

# %% W2 before W1, in a batch
# slow
# says: It takes the same action for every image. Do its values become NaN? The usual reasons: W2 is changed before it hands the gradient back to W1, a minus sign is missing, or a learning rate is too large. Or are all first weights 0, all pixels rounded to 0 or 1, or all stored images one array, and not copies?
# in: a memory in arrays
# - back = (d @ self.W[1].T * (h > 0))[:, :-1]
# - self.W[1] -= 0.2 * h.T @ d / len(x)
# + self.W[1] -= 0.2 * h.T @ d / len(x)
# + back = (d @ self.W[1].T * (h > 0))[:, :-1]

# %% rewards in whole numbers
# slow
# says: the right action brings 0.5, and another one 0: is the reward stored as it is? An array of whole numbers makes 0 of it
# in: a memory in arrays
# - A, R, goes_on = np.zeros(n_steps, int), np.zeros(n_steps), np.zeros(n_steps)
# + A, R, goes_on = np.zeros(n_steps, int), np.zeros(n_steps, int), np.zeros(n_steps)

# %% a hidden layer that never learns
# slow
# says: idden units that keep their first weights
# in: a memory in arrays
# - self.W[0] -= 0.2 * x.T @ back / len(x)

# %% a large hidden layer that never learns, one step at a time
# slow
# says: it solves the riddles and catches the balls, but not a harder riddle, in which two pixels together tell the right action: after 4000 steps the policy of
# says: of the questions.
# says: Hidden units that keep their first weights get 39 to 87 %: does the gradient change W1 and b1, and not only W2 and b2? Is h_j never below 0, and g_j 0 where h_j is 0?
# says: Is h_j never below 0, and g_j 0 where h_j is 0?
# says: Are the first weights of a layer with n inputs of a size near 1/√n, and not much larger?
# in: SARSA from each step once
# - W, b = rng.normal(0, np.sqrt(2 / n), (64, n)), np.zeros(64)
# - V, c = rng.normal(0, 0.1, (k, 64)), np.zeros(k)
# + W, b = rng.normal(0, np.sqrt(0.5 / n), (256, n)), np.zeros(256)
# + V, c = rng.normal(0, 0.1, (k, 256)), np.zeros(k)
# - W += 0.05 * delta * np.outer(g, x)
# - b += 0.05 * delta * g

# %% a small hidden layer that never learns, one step at a time
# slow
# says: Where two pixels together tell the right action, it does not find it either.
# says: Hidden units that keep their first weights get 39 to 87 %: does the gradient change W1 and b1, and not only W2 and b2? Is h_j never below 0, and g_j 0 where h_j is 0?
# in: SARSA from each step once
# - W, b = rng.normal(0, np.sqrt(2 / n), (64, n)), np.zeros(64)
# - V, c = rng.normal(0, 0.1, (k, 64)), np.zeros(k)
# + W, b = rng.normal(0, np.sqrt(2 / n), (16, n)), np.zeros(16)
# + V, c = rng.normal(0, 0.1, (k, 16)), np.zeros(k)
# - W += 0.05 * delta * np.outer(g, x)
# - b += 0.05 * delta * g

# %% ε and 1 - ε
# says: steps, but while it learned the program took it in
# says: of the last ones: with ε = 0.1 it should take the best action nine times of ten.
# says: Is ε larger, have ε and 1 − ε changed places, or are all actions drawn at random?
# in: SARSA from each step once
# - return rng.integers(k) if rng.random() < 0.1 else np.argmax(q(x)[1])
# + return rng.integers(k) if rng.random() > 0.1 else np.argmax(q(x)[1])

# %% no discount
# slow
# says: the right action brings 2.5 at once. Another one leads to an image in which every action brings 0.2 and that comes again, so that it is worth 0.2 / (1 − γ): is this value multiplied by γ in the target, and is γ 0.9?
# in: SARSA from each step once
# - delta = r - Q[a] if terminated else r + 0.9 * q(x2)[1][a2] - Q[a]
# + delta = r - Q[a] if terminated else r + q(x2)[1][a2] - Q[a]

# %% another discount
# slow
# says: the right action brings 2.5 at once. Another one leads to an image in which every action brings 0.2 and that comes again, so that it is worth 0.2 / (1 − γ): is this value multiplied by γ in the target, and is γ 0.9?
# in: a memory in arrays
# - y = R[i] + 0.9 * goes_on[i] * old.layers(S2[i])[2].max(axis=1)
# + y = R[i] + 0.99 * goes_on[i] * old.layers(S2[i])[2].max(axis=1)

# %% half the discount
# slow
# says: In this riddle, the right action brings 0 and then a better image, and another one 0.7 at once: does the target have γ max Q(S', a), with γ = 0.9, by weights that learn, or that are brought up to date again and again, and is the error of the actions that were *not* taken 0?
# in: SARSA from each step once
# - delta = r - Q[a] if terminated else r + 0.9 * q(x2)[1][a2] - Q[a]
# + delta = r - Q[a] if terminated else r + 0.5 * q(x2)[1][a2] - Q[a]

# %% the largest value of the batch
# slow
# says: (Or is its maximum over a whole batch, and not over the actions of each row? Or does W1 learn from that image, and not from the one in which the action was taken?)
# in: a memory in arrays
# - y = R[i] + 0.9 * goes_on[i] * old.layers(S2[i])[2].max(axis=1)
# + y = R[i] + 0.9 * goes_on[i] * old.layers(S2[i])[2].max()

# %% the mean over the next actions
# slow
# says: the right action leads to an image in which one action brings 1 and the others −1, and another one to an image in which all bring −0.2: does the target have the *largest* value of S', and not their mean, or that of one action?
# in: a memory in arrays
# - y = R[i] + 0.9 * goes_on[i] * old.layers(S2[i])[2].max(axis=1)
# + y = R[i] + 0.9 * goes_on[i] * old.layers(S2[i])[2].mean(axis=1)

# %% the largest value or 0
# slow
# says: the right action brings -0.3 at once, and another one leads to an image in which every action brings -1: is the
#   largest value the largest of S', however low it is? A search for it that starts with 0 finds 0
# in: a memory in arrays
# - y = R[i] + 0.9 * goes_on[i] * old.layers(S2[i])[2].max(axis=1)
# + y = R[i] + 0.9 * goes_on[i] * old.layers(S2[i])[2].max(axis=1, initial=0.0)

# %% biases that are never learned
# slow
# says: only a black image counts, with which half of the episodes begin. All its pixels are 0, so that W1 does not matter and the values are those of the biases: are there biases, and does the gradient change b1 and b2?
# in: SARSA from each step once
# - c[a] += 0.05 * delta
# - W += 0.05 * delta * np.outer(g, x)
# - b += 0.05 * delta * g
# + W += 0.05 * delta * np.outer(g, x)

# %% ε = 0.5
# slow
# says: steps, but while it learned the program took it in
# says: of the last ones: with ε = 0.1 it should take the best action nine times of ten.
# says: Is ε larger, have ε and 1 − ε changed places, or are all actions drawn at random?
# in: a memory in arrays
# - a = network.best(s) if rng.random() > 0.1 else rng.integers(k)
# + a = network.best(s) if rng.random() > 0.5 else rng.integers(k)

# %% the minimum over the next actions
# slow
# says: It does not solve another riddle, in which the right action leads to an image in which one action brings 1 and the others −1, and another one to an image in which all bring −0.2: does the target have the *largest* value of S', and not their mean, or that of one action?
# in: a memory in arrays
# - y = R[i] + 0.9 * goes_on[i] * old.layers(S2[i])[2].max(axis=1)
# + y = R[i] + 0.9 * goes_on[i] * old.layers(S2[i])[2].min(axis=1)

# %% the next value of the action that was taken
# slow
# says: does the target have the *largest* value of S', and not their mean, or that of one action?
# in: SARSA from each step once
# - delta = r - Q[a] if terminated else r + 0.9 * q(x2)[1][a2] - Q[a]
# + delta = r - Q[a] if terminated else r + 0.9 * q(x2)[1][a] - Q[a]

# %% no exploration
# slow
# says: In the end it takes the same action nearly each time that it sees an image: does it explore, with ε = 0.1?
# in: SARSA from each step once
# - return rng.integers(k) if rng.random() < 0.1 else np.argmax(q(x)[1])
# + return np.argmax(q(x)[1])

# %% the last action is never drawn
# slow
# says: One of the images comes
# says: times, and there it never takes the action
# says: : is the random action one of *all* n actions, 0 to n - 1, as rng.integers(n) draws it, and is ε 0.1?
# in: SARSA from each step once
# - return rng.integers(k) if rng.random() < 0.1 else np.argmax(q(x)[1])
# + return rng.integers(k - 1) if rng.random() < 0.1 else np.argmax(q(x)[1])

# %% an ε that falls too slowly
# slow
# says: steps it does so in
# says: : is ε 0.1 from the first step on, or does it fall slowly? Or does it learn too slowly: is there an update at every step, with a learning rate and first weights like those of the text, and does an error move the weights of the action that was *taken*?
# in: a memory in arrays
# - a = network.best(s) if rng.random() > 0.1 else rng.integers(k)
# + a = network.best(s) if rng.random() > max(0.1, 1 - t / 10_000) else rng.integers(k)

# %% empty places of the memory
# slow
# says: are rows of a batch drawn that were never stored?
# in: a memory in arrays
# - i = rng.integers(t + 1, size=32)
# + i = rng.integers(n_steps, size=32)
