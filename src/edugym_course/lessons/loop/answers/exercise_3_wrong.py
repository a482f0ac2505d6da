# %% nothing after the end is forgotten
# says: a terminal state has no future: its value is 0, so leave γ max_a Q(S', a) out when `terminated`
def learn(self, state, action, reward, next_state, terminated):
    target = reward + self.discount * max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% the reward alone
# says: the value of the next state is missing, γ max_a Q(S', a): without bootstrapping nothing is carried back
def learn(self, state, action, reward, next_state, terminated):
    self.Q[state, action] += self.learning_rate * (reward - self.Q[state, action])


# %% no discount
# says: the value of the next state is not discounted: multiply it by γ
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% the old value is missing
# says: − Q(S, A) is missing in the brackets: move by a share of the *difference* between target and Q(S, A)
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * target


# %% set instead of add
# says: the old value is lost: write `+=`, for the update is added to Q(S, A)
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * max(self.Q[next_state])
    self.Q[state, action] = self.learning_rate * (target - self.Q[state, action])


# %% the state that was left
# says: the maximum is taken over Q(S, a), the state that was left, instead of Q(S', a)
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * max(self.Q[state])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% no self
# says: write `self.` before a field
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + discount * max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% the brackets
# says: α belongs to the whole bracket, not to Q(S, A) alone
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * max(self.Q[next_state])
    self.Q[state, action] += target - self.learning_rate * self.Q[state, action]


# %% the test is the wrong way round
# says: the test of `terminated` is the wrong way round
def learn(self, state, action, reward, next_state, terminated):
    target = reward + self.discount * max(self.Q[next_state]) if terminated else reward
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% nothing is stored
# says: `learn` changes no table at all; it returns something instead
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * max(self.Q[next_state])
    return self.Q[state, action] + self.learning_rate * (target - self.Q[state, action])


# %% max of the table
# says: the maximum is taken over the whole table instead of the row of the next state
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * self.Q.max()
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% an instance
# says: should be the class
MyAgent = QLearning.create((6, 3))


# %% made with brackets
# says: MyAgent should be the class itself, but is what MyAgent(...) makes
# says: (...) makes: leave the brackets out
class MyAgent(NamedTuple):
    Q: np.ndarray
    learning_rate: float = 0.5
    discount: float = 0.99

    def act(self, state, rng):
        return 0

    def learn(self, state, action, reward, next_state, terminated):
        target = reward if terminated else reward + self.discount * max(self.Q[next_state])
        self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


MyAgent = MyAgent(np.zeros((800, 4)))


# %% a discount without its type
# says: MyAgent should keep its field `discount`
# in: the table is the last field
# - class MyAgent(NamedTuple):
# + class MyAgent(NamedTuple):
# +     Q: np.ndarray
# - discount: float = 0.99
# - Q: np.ndarray = np.zeros((1, 1))
# + discount = 0.99


# %% the minimum
# says: the minimum over the actions stands where the maximum should
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else min(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])


# %% the sum
# says: the sum over the actions stands where the maximum should
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else sum(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])


# %% the same action
# says: Q(S', A), the value of the *same* action, stands where the maximum over all actions should
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else self.Q[next_state, action]
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])


# %% the old value
# says: Q(S, A) stands where the maximum of Q(S', a) should
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else self.Q[state, action]
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])


# %% a maximum that starts from 0
# says: the maximum starts from 0, and all values may be lower: start from the first one
def learn(self, state, action, reward, next_state, terminated):
    best = 0.0
    for a in range(self.Q.shape[1]):
        if self.Q[next_state, a] > best and not terminated:
            best = self.Q[next_state, a]
    self.Q[state, action] += self.learning_rate * (reward + self.discount * best - self.Q[state, action])


# %% the first action
# says: only the first action of the next state is looked at
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else self.Q[next_state, 0]
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])


# %% the last action
# says: only the last action of the next state is looked at
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else self.Q[next_state, -1]
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])


# %% two actions
# says: only the first two actions of the next state are looked at, and there may be more
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state, 0], self.Q[next_state, 1])
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])


# %% the largest size
# says: the largest absolute value stands where the maximum should
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else np.abs(self.Q[next_state]).max()
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])


# %% nothing at the end
# says: at the end of an episode the reward is lost: only the *value of the next state* is 0 there
def learn(self, state, action, reward, next_state, terminated):
    target = (reward + self.discount * self.Q[next_state].max()) * (not terminated)
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% the reward discounted
# says: the reward is discounted; γ belongs to the value of the next state only
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else self.Q[next_state].max()
    self.Q[state, action] += self.learning_rate * (self.discount * (reward + value) - self.Q[state, action])


# %% a share of the target
# says: the old value is lost: α times the target is not Q(S, A) + α [target − Q(S, A)]
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else self.Q[next_state].max()
    self.Q[state, action] = self.learning_rate * (reward + self.discount * value)


# %% the next row
# says: it is Q[next_state, action] that changes, and it should be Q[state, action]
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else self.Q[next_state].max()
    self.Q[next_state, action] += self.learning_rate * (reward + self.discount * value - self.Q[next_state, action])


# %% the old value shrinks first
# says: Q(S, A) changes before the maximum is taken: compute the whole target from the old Q
def learn(self, state, action, reward, next_state, terminated):
    self.Q[state, action] *= 1 - self.learning_rate
    value = 0.0 if terminated else self.Q[next_state].max()
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value)


# %% nothing is learned at the end
# says: at the end of an episode nothing is learned, and that is where the reward is
def learn(self, state, action, reward, next_state, terminated):
    if not terminated:
        target = reward + self.discount * self.Q[next_state].max()
        self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% the next action
# says: Q(S', A'), the value of the action that comes next, stands where the maximum should: that is SARSA
def learn(self, state, action, reward, next_state, next_action, terminated):
    value = 0.0 if terminated else self.Q[next_state, next_action]
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])


# %% discounted twice
# says: the value of the next state is discounted twice
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else self.discount * max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])


# %% the maximum starts from -10
# says: the maximum starts from −10, and all values may be lower: start from the first one
def learn(self, state, action, reward, next_state, terminated):
    best = -10.0
    for value in self.Q[next_state]:
        best = max(best, value)
    target = reward if terminated else reward + self.discount * best
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% the maximum starts from -1
# says: the maximum starts from −1, and all values may be lower: start from the first one
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * max(-1.0, *self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% a maximum that starts from -100
# says: the maximum starts from −100, and all values may be lower: start from the first one
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * max(-100.0, *self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% a maximum that starts from -1000
# says: the maximum starts from −1000, and all values may be lower: start from the first one
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * max(-1000.0, *self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% brackets too early
# says: α stands before the reward alone: put the whole bracket into parentheses
def learn(self, state, action, reward, next_state, terminated):
    future = 0.0 if terminated else max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * reward + self.discount * future - self.Q[state, action]


# %% the discount before a difference
# says: Q(S, A) is discounted as well: γ belongs to the value of the next state only
def learn(self, state, action, reward, next_state, terminated):
    future = 0.0 if terminated else max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (reward + self.discount * (future - self.Q[state, action]))


# %% no else
# says: at the end of an episode it learns twice: is an `else` missing?
def learn(self, state, action, reward, next_state, terminated):
    if terminated:
        self.Q[state, action] += self.learning_rate * (reward - self.Q[state, action])
    target = reward + self.discount * max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% the maximum of one value
# says: that is a single number, and a row, a list or range(...) is needed there
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * max(self.Q[next_state, action])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% the last reward in full
# slow
# says: terminated=True), where
# says: in your code the reward counts once, and should count 0.25 times; Q[0, 0] counts 0 times, and should count 0.75 times
def learn(self, state, action, reward, next_state, terminated):
    if terminated:
        self.Q[state, action] = reward
    else:
        target = reward + self.discount * max(self.Q[next_state])
        self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% the second best
# slow
# says: in your code Q[3, 0] counts 0 times, and should count 0.175 times; Q[3, 1] counts 0.175 times, and should count 0
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else sorted(self.Q[next_state])[-2]
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])
