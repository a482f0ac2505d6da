# %% a sum and a length
# says: Right: one number says which policy the values belong to. ε_π = 0 is Q-learning, ε_π = ε expected SARSA. See it
#   race:
def learn(self, state, action, reward, next_state, terminated):
    row = self.Q[next_state]
    v = (1 - self.target_epsilon) * row.max() + self.target_epsilon * row.sum() / len(row)
    if terminated:
        v = 0
    self.Q[state, action] += self.learning_rate * (reward + self.discount * v - self.Q[state, action])


# %% a weighted mean of old and new
def learn(self, state, action, reward, next_state, terminated):
    e = self.target_epsilon
    future = (1 - e) * np.max(self.Q[next_state]) + e * self.Q[next_state].mean()
    target = reward + self.discount * future * (not terminated)
    self.Q[state, action] = (1 - self.learning_rate) * self.Q[state, action] + self.learning_rate * target


# %% a plain class
class TwoPolicies:
    def __init__(self, Q, learning_rate=0.03, discount=1.0, epsilon=0.1, target_epsilon=0.1):
        self.Q, self.learning_rate, self.discount = Q, learning_rate, discount
        self.epsilon, self.target_epsilon = epsilon, target_epsilon

    @classmethod
    def create(cls, environment, **settings):
        return cls(np.zeros(table_size(environment)), **settings)

    def act(self, state, rng):
        if rng.random() < self.epsilon:
            return int(rng.integers(self.Q.shape[1]))
        return int(rng.choice(np.flatnonzero(self.Q[state] == self.Q[state].max())))

    def learn(self, state, action, reward, next_state, terminated):
        value = (1 - self.target_epsilon) * self.Q[next_state].max() + self.target_epsilon * self.Q[next_state].mean()
        target = reward + (0.0 if terminated else self.discount * value)
        self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])
