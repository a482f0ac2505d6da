# %% an if and an else
# says: Right: two weights are enough to move the crossing. See it race:
def learn(self, state, action, reward, next_state, terminated):
    target = reward
    if not terminated:
        target += self.discount * max(self.Q[next_state])
    delta = target - self.Q[state, action]
    if delta > 0:
        self.Q[state, action] += self.learning_rate * (1 - self.kappa) * delta
    else:
        self.Q[state, action] += self.learning_rate * (1 + self.kappa) * delta


# %% an index
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    weight = (1 + self.kappa, 1 - self.kappa)[int(delta > 0)]
    self.Q[state][action] += self.learning_rate * weight * delta


# %% a new rate
def learn(self, state, action, reward, next_state, terminated):
    old = self.Q[state, action]
    target = reward if terminated else reward + self.discount * self.Q[next_state].max()
    rate = self.learning_rate * (1 - self.kappa if target >= old else 1 + self.kappa)
    self.Q[state, action] = (1 - rate) * old + rate * target
