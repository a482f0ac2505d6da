# %% concatenate
# says: Right: the history includes the actions. See it race:
def push(self, window, action, seen):
    return np.concatenate((window[2:], np.array([action, seen])))


# %% append twice
def push(self, window, action, seen):
    return np.append(np.append(window[2:], action), seen)


# %% roll
def push(self, window, action, seen):
    new = np.roll(window, -2)
    new[-2] = action
    new[-1] = seen
    return new


# %% by a loop
def push(self, window, action, seen):
    new = np.zeros(len(window), np.int64)
    for i in range(len(window) - 2):
        new[i] = window[i + 2]
    new[len(window) - 2] = action
    new[len(window) - 1] = seen
    return new


# %% pairs of digits
def row(self, window):
    number = window[0]
    for i in range(1, len(window), 2):
        number = (number * self.n_actions + window[i]) * self.n_observations + window[i + 1]
    return number


# %% observations first
def row(self, window):
    number = 0
    for seen in window[::2]:
        number = number * self.n_observations + seen
    for action in window[1::2]:
        number = number * self.n_actions + action
    return number


# %% the latest digit first
def row(self, window):
    number, worth = 0, 1
    for i in range(len(window) - 1, -1, -1):
        number += window[i] * worth
        worth *= self.n_observations if i % 2 == 0 else self.n_actions
    return number


# %% actions first
def row(self, window):
    number = 0
    for i in range(self.k - 1):
        number = number * self.n_actions + window[2 * i + 1]
    for i in range(self.k):
        number = number * self.n_observations + window[2 * i]
    return number
