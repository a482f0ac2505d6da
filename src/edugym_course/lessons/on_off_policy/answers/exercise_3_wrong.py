# %% the target is returned
# says: ; it returns something instead, which nobody reads
def learn(self, state, action, reward, next_state, terminated):
    value = (1 - self.target_epsilon) * max(self.Q[next_state]) + self.target_epsilon * np.mean(self.Q[next_state])
    return reward + self.discount * value


# %% Q-learning
# says: the maximum alone is Q-learning, which is right only for ε_π = 0; the random actions of the target policy are
#   missing
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% SARSA
# says: Q(S', A') of the action that comes next stands there: that is SARSA, and A' is chosen with the wrong ε
def learn(self, state, action, reward, next_state, next_action, terminated):
    target = reward if terminated else reward + self.discount * self.Q[next_state, next_action]
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% the other epsilon
# says: it uses `epsilon`, with which the agent acts; the values should be those of the *target* policy,
#   `target_epsilon`
def learn(self, state, action, reward, next_state, terminated):
    value = (1 - self.epsilon) * max(self.Q[next_state]) + self.epsilon * np.mean(self.Q[next_state])
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% weights interchanged
# says: ε_π and 1 − ε_π have changed places
def learn(self, state, action, reward, next_state, terminated):
    value = self.target_epsilon * max(self.Q[next_state]) + (1 - self.target_epsilon) * np.mean(self.Q[next_state])
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% the sum for the mean
# says: the sum over the actions stands where their mean should
def learn(self, state, action, reward, next_state, terminated):
    value = (1 - self.target_epsilon) * max(self.Q[next_state]) + self.target_epsilon * sum(self.Q[next_state])
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% the mean of the others
# says: the mean leaves out the best action; a random action may be the best one too
def learn(self, state, action, reward, next_state, terminated):
    row = self.Q[next_state]
    others = (sum(row) - max(row)) / (len(row) - 1)
    value = (1 - self.target_epsilon) * max(row) + self.target_epsilon * others
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% three actions
# says: it divides by 3, but there may be another number of actions: self.Q.shape[1]
def learn(self, state, action, reward, next_state, terminated):
    row = self.Q[next_state]
    value = (1 - self.target_epsilon) * max(row) + self.target_epsilon * sum(row) / 3
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% terminated forgotten
# says: a terminal state has no future: its value is 0, so the target is R alone when `terminated`
def learn(self, state, action, reward, next_state, terminated):
    value = (1 - self.target_epsilon) * max(self.Q[next_state]) + self.target_epsilon * np.mean(self.Q[next_state])
    target = reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% only the mean
# says: the plain mean is right only for ε_π = 1; with probability 1 − ε_π the target policy takes the best action
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * np.mean(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% the maximum in full
# says: the maximum counts in full, but it has the probability 1 − ε_π only
def learn(self, state, action, reward, next_state, terminated):
    value = max(self.Q[next_state]) + self.target_epsilon * np.mean(self.Q[next_state])
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% the mean is missing
# says: the mean over the random actions is missing, ε_π mean_a Q(S', a)
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * (1 - self.target_epsilon) * max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% the number of the best action
# says: argmax gives the *number* of the best action; its value is needed, max
def learn(self, state, action, reward, next_state, terminated):
    row = self.Q[next_state]
    value = (1 - self.target_epsilon) * np.argmax(row) + self.target_epsilon * np.mean(row)
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% the mean of the whole table
# says: the mean is taken over the whole table instead of the row of the next state
def learn(self, state, action, reward, next_state, terminated):
    value = (1 - self.target_epsilon) * max(self.Q[next_state]) + self.target_epsilon * np.mean(self.Q)
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% the state that was left
# says: the values are those of the state that was left, Q(S, a), instead of Q(S', a)
def learn(self, state, action, reward, next_state, terminated):
    value = (1 - self.target_epsilon) * max(self.Q[state]) + self.target_epsilon * np.mean(self.Q[state])
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% self is forgotten
# says: write `self.` before a field
def learn(self, state, action, reward, next_state, terminated):
    value = (1 - target_epsilon) * max(self.Q[next_state]) + target_epsilon * np.mean(self.Q[next_state])
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% an agent instead of the class
# says: should be the class
class Agent(NamedTuple):
    Q: np.ndarray


TwoPolicies = Agent(np.zeros((3, 3)))


# %% a field is missing
# says: should keep its field `target_epsilon`
class TwoPolicies(NamedTuple):
    Q: np.ndarray
    learning_rate: float = 0.03
    discount: float = 1.0
    epsilon: float = 0.1

    def act(self, state, rng):
        return 0

    def learn(self, state, action, reward, next_state, terminated):
        target = reward if terminated else reward + self.discount * max(self.Q[next_state])
        self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% the random part alone
# says: the best action is missing, (1 − ε_π) max_a Q(S', a)
def learn(self, state, action, reward, next_state, next_action, terminated):
    p, row = self.target_epsilon, self.Q[next_state]
    value = 0.0 if terminated else p * row.mean()
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])


# %% the minimum for the mean
# says: the minimum stands where the mean over the actions should
def learn(self, state, action, reward, next_state, next_action, terminated):
    p, row = self.target_epsilon, self.Q[next_state]
    value = 0.0 if terminated else (1 - p) * row.max() + p * row.min()
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])


# %% the next action for the mean
# says: Q(S', A') stands where the mean over the actions should; no action has to be drawn
def learn(self, state, action, reward, next_state, next_action, terminated):
    p, row = self.target_epsilon, self.Q[next_state]
    value = 0.0 if terminated else (1 - p) * row.max() + p * row[next_action]
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])


# %% the old value for the mean
# says: Q(S, A) stands where the mean of Q(S', a) should
def learn(self, state, action, reward, next_state, next_action, terminated):
    p, row = self.target_epsilon, self.Q[next_state]
    value = 0.0 if terminated else (1 - p) * row.max() + p * self.Q[state, action]
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])


# %% no next state
# says: the value of the next state is missing: without bootstrapping nothing is carried back
def learn(self, state, action, reward, next_state, next_action, terminated):
    p, row = self.target_epsilon, self.Q[next_state]
    value = 0.0 if terminated else 0.0
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])


# %% the larger ε
# says: should go from
def learn(self, state, action, reward, next_state, terminated):
    e = max(self.epsilon, self.target_epsilon)
    value = 0.0 if terminated else (1 - e) * max(self.Q[next_state]) + e * np.mean(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])


# %% γ on the maximum only
# says: the mean is not discounted: γ belongs to the whole bracket
def learn(self, state, action, reward, next_state, terminated):
    e, target = self.target_epsilon, reward
    if not terminated:
        target += self.discount * (1 - e) * max(self.Q[next_state]) + e * np.mean(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% the best action twice
# says: the best action counts too often: the mean over all actions has it already, with ε_π/n
def learn(self, state, action, reward, next_state, terminated):
    e, row = self.target_epsilon, self.Q[next_state]
    value = 0.0 if terminated else (1 - e + e / len(row)) * max(row) + e * np.mean(row)
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])


# %% divided twice
# says: the mean is divided by n once more
def learn(self, state, action, reward, next_state, terminated):
    e, row = self.target_epsilon, self.Q[next_state]
    value = 0.0 if terminated else (1 - e) * max(row) + e / len(row) * np.mean(row)
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])


# %% one action drawn
# slow
# says: a second time it gives something else: `learn` needs no random numbers
def learn(self, state, action, reward, next_state, terminated):
    row = self.Q[next_state]
    drawn = np.random.randint(len(row)) if np.random.random() < self.target_epsilon else np.argmax(row)
    value = 0.0 if terminated else row[drawn]
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])


# %% γ on the mean only
# says: the maximum is not discounted: γ belongs to the whole bracket
def learn(self, state, action, reward, next_state, terminated):
    e, target = self.target_epsilon, reward
    if not terminated:
        target += (1 - e) * max(self.Q[next_state]) + self.discount * e * np.mean(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% the number of states
# says: it divides by the number of states; n is the number of actions, self.Q.shape[1]
def learn(self, state, action, reward, next_state, terminated):
    e, row = self.target_epsilon, self.Q[next_state]
    value = 0.0 if terminated else (1 - e) * max(row) + e * sum(row) / len(self.Q)
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])


# %% a maximum that starts from 0
# says: the maximum starts from 0, and all values may be lower: start from the first one
# in: the solution of learn
# - best, mean = max(self.Q[next_state]), np.mean(self.Q[next_state])
# + best, mean = max(0.0, *self.Q[next_state]), np.mean(self.Q[next_state])


# %% epsilon before the maximum
# says: it uses `epsilon` before the maximum; both numbers are those of the target policy, `target_epsilon`
def learn(self, state, action, reward, next_state, terminated):
    here, there = self.Q[state], self.Q[next_state]
    value = (1 - self.epsilon) * max(there) + self.target_epsilon * np.mean(there)
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% epsilon before the mean
# says: it uses `epsilon` before the mean; both numbers are those of the target policy, `target_epsilon`
def learn(self, state, action, reward, next_state, terminated):
    here, there = self.Q[state], self.Q[next_state]
    value = (1 - self.target_epsilon) * max(there) + self.epsilon * np.mean(there)
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% the mean of the state left
# says: the mean is that of the state that was left; it belongs to the row of the next state
def learn(self, state, action, reward, next_state, terminated):
    here, there = self.Q[state], self.Q[next_state]
    value = (1 - self.target_epsilon) * max(there) + self.target_epsilon * np.mean(here)
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% the maximum of the state left
# says: the maximum is that of the state that was left; it belongs to the row of the next state
def learn(self, state, action, reward, next_state, terminated):
    here, there = self.Q[state], self.Q[next_state]
    value = (1 - self.target_epsilon) * max(here) + self.target_epsilon * np.mean(there)
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% the mean over the states
# says: the mean is taken over the states, a column of Q; it belongs to the row of the next state
def learn(self, state, action, reward, next_state, terminated):
    here, there = self.Q[state], self.Q[next_state]
    value = (1 - self.target_epsilon) * max(there) + self.target_epsilon * np.mean(self.Q[:, action])
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% the maximum divided
# says: the maximum, divided by n, stands where the mean over the actions should
def learn(self, state, action, reward, next_state, terminated):
    e, row = self.target_epsilon, self.Q[next_state]
    value = 0.0 if terminated else (1 - e) * max(row) + e / len(row) * max(row)
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])
