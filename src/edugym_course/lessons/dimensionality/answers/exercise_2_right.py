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


# %% nine weights in a loop
def learn(self, state, action, reward, next_state, terminated):
    target = reward
    if not terminated:
        target += self.discount * max(self.value(next_state, a) for a in range(3))
    error = target - self.value(state, action)
    x = self.features(state)
    for i in range(9):
        self.w[i, action] += self.learning_rate * error * x[i]
