# %% the signs
# says: good and bad surprises have changed places: whatever the sign of κ, bad ones weigh 1 + κ (κ > 0 avoids risk, as
#   β < 0 does)
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 1 + self.kappa if delta > 0 else 1 - self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% by the reward
# says: it asks whether the *reward* is good; a surprise is good if δ is above 0
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 1 - self.kappa if reward > 0 else 1 + self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% by the target
# says: it asks whether the *target* is above 0; a surprise is good if δ is
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * max(self.Q[next_state])
    w = 1 - self.kappa if target > 0 else 1 + self.kappa
    self.Q[state, action] += self.learning_rate * w * (target - self.Q[state, action])


# %% Q-learning
# says: the weight is missing: that is Q-learning
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% the rule of the lesson
# says: that is the weight of Delétang et al., 2σ(βδ); here are two weights, whatever the size of δ
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 2 / (1 + np.exp(self.kappa * delta))
    self.Q[state, action] += self.learning_rate * w * delta


# %% the rule of the lesson with its sign
# says: that is 2σ(κδ), the weight of Delétang et al., and κ has the opposite sign of β
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 2 / (1 + np.exp(-self.kappa * delta))
    self.Q[state, action] += self.learning_rate * w * delta


# %% only bad surprises
# says: nothing is learned from good surprises; they weigh 1 − κ
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    if delta < 0:
        self.Q[state, action] += self.learning_rate * (1 + self.kappa) * delta


# %% good ones without a weight
# says: good surprises have no weight of their own, 1 − κ
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 1.0
    if delta < 0:
        w = 1 + self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% bad ones without a weight
# says: bad surprises have no weight of their own, 1 + κ
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 1.0
    if delta > 0:
        w = 1 - self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% the 1 is missing
# says: the 1 is missing in the weights, which are 1 − κ and 1 + κ
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = -self.kappa if delta > 0 else self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% one weight
# says: the weight is 1 − κ always, for bad surprises too
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    self.Q[state, action] += self.learning_rate * (1 - self.kappa) * delta


# %% the weight on the target
# says: the weight belongs to the whole δ, not to the target alone
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    target = reward + self.discount * value
    w = 1 - self.kappa if target > self.Q[state, action] else 1 + self.kappa
    self.Q[state, action] += self.learning_rate * (w * target - self.Q[state, action])


# %% the weight alone
# says: δ is missing in the step, which is α times the weight times δ
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 1 - self.kappa if delta > 0 else 1 + self.kappa
    self.Q[state, action] += self.learning_rate * w


# %% minus
# says: the sign is wrong: it moves away from the target
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 1 - self.kappa if delta > 0 else 1 + self.kappa
    self.Q[state, action] -= self.learning_rate * w * delta


# %% the sign of δ
# says: δ has the wrong sign: it is the target less Q(S, A), not Q(S, A) less the target
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = self.Q[state, action] - (reward + self.discount * value)
    w = 1 - self.kappa if delta > 0 else 1 + self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% a fixed κ
# says: a κ of 0.5
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 0.5 if delta > 0 else 1.5
    self.Q[state, action] += self.learning_rate * w * delta


# %% self is forgotten
# says: write `self.` before a field
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + discount * value - self.Q[state, action]
    w = 1 - self.kappa if delta > 0 else 1 + self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% the weight is squared
# says: the weight counts twice
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 1 - self.kappa if delta > 0 else 1 + self.kappa
    delta = delta * w
    self.Q[state, action] += self.learning_rate * w * delta


# %% an agent instead of the class
# says: should be the class
TwoWeights = TwoWeights(np.zeros((3, 3)))


# %% a field is missing
# says: should keep its field `kappa`
class TwoWeights(NamedTuple):
    Q: np.ndarray
    learning_rate: float = 0.02
    discount: float = 1.0
    epsilon: float = 0.1

    def act(self, state, rng):
        return 0

    def learn(self, state, action, reward, next_state, terminated):
        delta = reward - self.Q[state, action]
        self.Q[state, action] += self.learning_rate * (0.5 if delta > 0 else 1.5) * delta


# %% the old value
# says: it asks whether the old *value* is above 0; a surprise is good if δ is
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 1 - self.kappa if self.Q[state, action] > 0 else 1 + self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% always more
# says: the weight is 1 + κ always, for good surprises too
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 1 + self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% κ alone
# says: κ itself stands where the weight should
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% half as much
# says: the weights are half as large as they should be
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = (1 - self.kappa if delta > 0 else 1 + self.kappa) / 2
    self.Q[state, action] += self.learning_rate * w * delta


# %% good surprises only
# says: nothing is learned from bad surprises; they weigh 1 + κ
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 1 - self.kappa if delta > 0 else 0.0
    self.Q[state, action] += self.learning_rate * w * delta


# %% no brackets, the last part alone loses Q
# says: − Q(S, A) is missing at the end of an episode: `a if terminated else b - Q` subtracts it from b only, so put brackets
#   around `a if terminated else b`
def learn(self, state, action, reward, next_state, terminated):
    value = self.discount * max(self.Q[next_state])
    delta = reward if terminated else reward + value - self.Q[state, action]
    w = 1 - self.kappa if delta > 0 else 1 + self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% no brackets, Q at the end alone
# says: − Q(S, A) is missing but at the end of an episode: `a if not terminated else b - Q` subtracts it from b only, so put
#   brackets around `a if not terminated else b`
def learn(self, state, action, reward, next_state, terminated):
    value = self.discount * max(self.Q[next_state])
    delta = reward + value if not terminated else reward - self.Q[state, action]
    w = 1 - self.kappa if delta > 0 else 1 + self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% no brackets, the reward at the end alone
# says: Python reads `R + a if terminated else b - Q` as `(R + a) if terminated else (b - Q)`: put brackets around
#   `a if terminated else b`
def learn(self, state, action, reward, next_state, terminated):
    value = self.discount * max(self.Q[next_state])
    delta = reward + 0.0 if terminated else value - self.Q[state, action]
    w = 1 - self.kappa if delta > 0 else 1 + self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% no brackets, only Q at the end
# says: Python reads `R + a if not terminated else b - Q` as `(R + a) if not terminated else (b - Q)`: put brackets around
#   `a if not terminated else b`
def learn(self, state, action, reward, next_state, terminated):
    value = self.discount * max(self.Q[next_state])
    delta = reward + value if not terminated else 0.0 - self.Q[state, action]
    w = 1 - self.kappa if delta > 0 else 1 + self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% an else is missing
# says: a good surprise is learned from twice, with both weights: is an `else` missing?
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    old = self.Q[state, action]
    if delta > 0:
        old += self.learning_rate * (1 - self.kappa) * delta
    old += self.learning_rate * (1 + self.kappa) * delta
    self.Q[state, action] = old


# %% the size of the surprise
# says: the weight is 1 − κδ; it should depend on the sign of δ only, whatever its size
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    self.Q[state, action] += self.learning_rate * (1 - self.kappa * delta) * delta


# %% the row of the next state
# slow
# says: another entry changes than should,
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 1 - self.kappa if delta > 0 else 1 + self.kappa
    self.Q[next_state, action] += self.learning_rate * w * delta


# %% weights that add up to 1
# says: , where 1 − κ is
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = self.kappa if delta > 0 else 1 - self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% a target without brackets
# says: Python reads `R + a if terminated else b` as `(R + a) if terminated else b`: put brackets around `a if
#   terminated else b`
def learn(self, state, action, reward, next_state, terminated):
    target = reward + 0.0 if terminated else self.discount * max(self.Q[next_state])
    delta = target - self.Q[state, action]
    w = 1 - self.kappa if delta > 0 else 1 + self.kappa
    self.Q[state, action] += self.learning_rate * w * delta
