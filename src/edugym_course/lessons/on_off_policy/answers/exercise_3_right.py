# %% a sum and a length
# says: Right: one number says which policy the values belong to. ε_π = 0 is Q-learning, ε_π = ε expected SARSA. See it
#   race:
def learn(self, state, action, reward, next_state, terminated):
    row = self.Q[next_state]
    v = (1 - self.target_epsilon) * row.max() + self.target_epsilon * row.sum() / len(row)
    if terminated:
        v = 0
    self.Q[state, action] += self.learning_rate * (reward + self.discount * v - self.Q[state, action])


# %% probabilities of the actions
def learn(self, state, action, reward, next_state, terminated):
    n = self.Q.shape[1]
    best = np.argmax(self.Q[next_state])
    value = 0.0
    for a in range(n):
        p = self.target_epsilon / n
        if a == best:
            p += 1 - self.target_epsilon
        value += p * self.Q[next_state, a]
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% the package's functions
def learn(self, state, action, reward, next_state, terminated):
    value = epsilon_greedy_value(self.Q, next_state, self.target_epsilon)
    target = one_step_target(reward, self.discount, value, terminated)
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% a weighted mean of old and new
def learn(self, state, action, reward, next_state, terminated):
    e = self.target_epsilon
    future = (1 - e) * np.max(self.Q[next_state]) + e * self.Q[next_state].mean()
    target = reward + self.discount * future * (not terminated)
    self.Q[state, action] = (1 - self.learning_rate) * self.Q[state, action] + self.learning_rate * target


# %% the error first
def learn(self, state, action, reward, next_state, terminated):
    delta = reward - self.Q[state, action]
    if not terminated:
        delta += self.discount * (1 - self.target_epsilon) * max(self.Q[next_state])
        delta += self.discount * self.target_epsilon * sum(self.Q[next_state]) / self.Q.shape[1]
    self.Q[state, action] += self.learning_rate * delta


# %% more parameters than needed
def learn(self, state, action, reward, next_state, next_action, terminated, truncated):
    value = 0.0
    if not terminated:
        value = self.target_epsilon * np.mean(self.Q[next_state])
        value = value + (1.0 - self.target_epsilon) * self.Q[next_state].max()
    self.Q[state][action] += self.learning_rate * (reward + self.discount * value - self.Q[state][action])


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
