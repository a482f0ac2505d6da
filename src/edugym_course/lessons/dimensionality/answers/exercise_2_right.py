# %% a dot product
# says: Right: the error times the features. See it catch:
def value(self, board, action):
    return self.features(board) @ self.w[:, action]


def learn(self, state, action, reward, next_state, terminated):
    target = reward
    if not terminated:
        target = reward + self.discount * max(
            [self.value(next_state, 0), self.value(next_state, 1), self.value(next_state, 2)]
        )
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * self.features(state)


# %% loops
def value(self, board, action):
    x = self.features(board)
    total = 0.0
    for i in range(len(x)):
        total += x[i] * self.w[i, action]
    return total


def learn(self, state, action, reward, next_state, terminated):
    best = -math.inf
    for a in range(3):
        best = max(best, self.value(next_state, a))
    if terminated:
        best = 0.0
    error = reward + self.discount * best - self.value(state, action)
    x = self.features(state)
    for i in range(len(x)):
        self.w[i, action] += self.learning_rate * error * x[i]


# %% all values at once
def learn(self, state, action, reward, next_state, terminated):
    following = (self.features(next_state) @ self.w).max()
    y = reward + self.discount * (1 - terminated) * following
    x = self.features(state)
    delta = y - x @ self.w[:, action]
    self.w[:, action] = self.w[:, action] + self.learning_rate * delta * x


# %% an early return
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    present = self.value(state, action)
    if terminated:
        self.w[:, action] += self.learning_rate * (reward - present) * x
        return
    best = np.max(np.array([self.value(next_state, a) for a in range(3)]))
    self.w[:, action] += self.learning_rate * (reward + self.discount * best - present) * x


# %% an outer product
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    chosen = np.zeros(3)
    chosen[action] = 1.0
    best = 0.0 if terminated else max(self.features(next_state) @ self.w)
    error = reward + self.discount * best - x @ self.w @ chosen
    self.w[:] += self.learning_rate * error * np.outer(x, chosen)


# %% np.dot
def value(self, board, action):
    return float(np.dot(self.w[:, action], self.features(board)))


# %% only active features
def learn(self, state, action, reward, next_state, terminated):
    q = np.zeros(3)
    if not terminated:
        for a in range(3):
            q[a] = self.value(next_state, a)
    error = reward + self.discount * np.max(q) * (not terminated) - self.value(state, action)
    x = self.features(state)
    for i in np.flatnonzero(x):
        self.w[i, action] += self.learning_rate * error * x[i]


# %% parameters in another order
def learn(self, action, state, next_state, reward, terminated):
    x = self.features(state)
    target = reward if terminated else reward + self.discount * (self.features(next_state) @ self.w).max()
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * x


# %% truncated is taken and not used
def learn(self, state, action, reward, next_state, terminated, truncated):
    x = self.features(state)
    target = reward if terminated else reward + self.discount * (self.features(next_state) @ self.w).max()
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * x
