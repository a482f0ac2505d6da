# %% returns first, then the steps in order
# says: Right: returns minus a baseline, times the score. See it race:
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% a sum for each return
def update(self, n):
    for t in range(n):
        G = 0.0
        for k in range(t, n):
            G += self.discount ** (k - t) * self.rewards[k]
        state, action = self.states[t], self.actions[t]
        delta = G - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        step = self.learning_rate * self.discount**t * delta
        for a in range(len(self.probabilities)):
            self.preferences[state, a] -= step * self.probabilities[a]
        self.preferences[state, action] += step


# %% parameters of learn in another order
def learn(self, truncated, action, state, terminated, reward):
    t = self.length[0]
    self.states[t], self.actions[t], self.rewards[t] = state, action, reward
    self.length[0] = t + 1
    if terminated or truncated:
        self.update(self.length[0])
        self.length[0] = 0
