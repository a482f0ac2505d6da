# %% concatenate
# says: Right: the history includes the actions. See it race:
def push(self, window, action, seen):
    return np.concatenate((window[2:], np.array([action, seen])))


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
