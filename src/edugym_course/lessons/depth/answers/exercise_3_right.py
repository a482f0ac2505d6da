# %% reversed
# says: Right: the reward passes through greedy actions, and is cut at the others. See it race:
def hand_back(self, length):
    G = 0.0
    for k in reversed(range(length)):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
        if self.Q[s, a] < max(self.Q[s]):
            G = max(self.Q[s])


# %% while
def hand_back(self, length):
    k, G = length - 1, 0.0
    while k >= 0:
        s, a = self.states[k], self.actions[k]
        G = G * self.discount + self.rewards[k]
        self.Q[s, a] = (1 - self.learning_rate) * self.Q[s, a] + self.learning_rate * G
        if self.Q[s, a] != self.Q[s].max():
            G = self.Q[s].max()
        k -= 1


# %% an own loop for the maximum
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
        best = self.Q[s, 0]
        for b in range(1, self.Q.shape[1]):
            if self.Q[s, b] > best:
                best = self.Q[s, b]
        G = G if self.Q[s, a] >= best else best
