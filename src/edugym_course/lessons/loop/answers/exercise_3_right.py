# %% in steps
# says: Right: that is all of Q-learning. See it race:
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0
    if not terminated:
        value = np.max(self.Q[next_state])
    error = reward + self.discount * value - self.Q[state, action]
    self.Q[state, action] += self.learning_rate * error


# %% a loop for the maximum
def learn(self, state, action, reward, next_state, terminated):
    best = self.Q[next_state, 0]
    for value in self.Q[next_state]:
        if value > best:
            best = value
    if terminated:
        best = 0.0
    self.Q[state, action] += self.learning_rate * (reward + self.discount * best - self.Q[state, action])


# %% the table is the last field
class MyAgent(NamedTuple):
    learning_rate: float = 0.5
    discount: float = 0.99
    Q: np.ndarray = np.zeros((1, 1))

    def act(self, state, rng):
        return 0

    def learn(self, state, action, reward, next_state, terminated):
        target = reward if terminated else reward + self.discount * max(self.Q[next_state])
        self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])
