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


# %% backwards
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        state = self.states[t]
        delta = G - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% the power of γ under way
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    power = 1.0
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * power * delta * score
        power *= self.discount


# %% with the function of the package
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
        size = self.learning_rate * self.discount**t * delta
        follow_log_gradient(self.preferences, state, self.actions[t], self.probabilities, size)


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


# %% with arrays
def update(self, n):
    G = np.zeros(n + 1)
    for t in range(n - 1, -1, -1):
        G[t] = self.rewards[t] + self.discount * G[t + 1]
    for t in range(n):
        s = self.states[t]
        delta = G[t] - self.V[s]
        self.look(s)
        score = -self.probabilities
        score[self.actions[t]] += 1
        self.preferences[s] += self.learning_rate * self.discount**t * delta * score
        self.V[s] += self.value_learning_rate * delta


# %% the policy before the baseline
def update(self, n):
    for t in range(n - 1, -1, -1):
        if t < n - 1:
            self.rewards[t] += self.discount * self.rewards[t + 1]
    for t in range(n):
        s = self.states[t]
        self.look(s)
        delta = self.rewards[t] - self.V[s]
        for a in range(len(self.probabilities)):
            chosen = int(a == self.actions[t])
            self.preferences[s, a] += self.learning_rate * self.discount**t * delta * (chosen - self.probabilities[a])
        self.V[s] = (1 - self.value_learning_rate) * self.V[s] + self.value_learning_rate * self.rewards[t]


# %% parameters of learn in another order
def learn(self, truncated, action, state, terminated, reward):
    t = self.length[0]
    self.states[t], self.actions[t], self.rewards[t] = state, action, reward
    self.length[0] = t + 1
    if terminated or truncated:
        self.update(self.length[0])
        self.length[0] = 0


# %% a plain class
class MyREINFORCE:
    learning_rate, value_learning_rate, discount = 0.4, 0.4, 0.99

    def __init__(self, n_states, n_actions):
        self.preferences, self.V = np.zeros((n_states, n_actions)), np.zeros(n_states)
        self.probabilities, self.rewards = np.zeros(n_actions), np.zeros(200)
        self.states, self.actions, self.length = np.zeros(200, int), np.zeros(200, int), np.zeros(1, int)

    @classmethod
    def create(cls, task):
        return cls(int(np.prod(task.observation_space.nvec)), int(task.action_space.n))

    def look(self, state):
        softmax(self.preferences, state, self.probabilities)

    def act(self, state, rng):
        self.look(state)
        return draw_action(self.probabilities, rng)

    def learn(self, state, action, reward, terminated, truncated):
        t = self.length[0]
        self.states[t], self.actions[t], self.rewards[t] = state, action, reward
        self.length[0] = t + 1
        if terminated or truncated:
            self.update(self.length[0])
            self.length[0] = 0

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


# %% first the baseline of every step, then the policy
def update(self, n):
    G, deltas = 0.0, np.zeros(n)
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        deltas[t] = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * deltas[t]
    for t in range(n):
        state = self.states[t]
        delta = deltas[t]
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score
