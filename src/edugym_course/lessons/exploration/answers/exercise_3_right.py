# %% roots and branches
# says: Right: counting tries says what is new here, the bonus says where to go, and no random step is needed. See it
#   race:
def act(self, state, rng):
    untried = [action for action in range(self.Q.shape[1]) if self.tries[state, action] == 0]
    return untried[0] if untried else self.greedy(state, rng)


def learn(self, state, action, reward, next_state, terminated):
    import math

    self.visits[next_state] += 1
    self.tries[state, action] += 1
    target = reward + self.bonus / math.sqrt(self.visits[next_state])
    if not terminated:
        target += self.discount * np.max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% the largest by a loop
def learn(self, state, action, reward, next_state, terminated):
    self.tries[state, action] = self.tries[state, action] + 1
    self.visits[next_state] = self.visits[next_state] + 1
    best = self.Q[next_state, 0]
    for other in range(1, self.Q.shape[1]):
        if self.Q[next_state, other] > best:
            best = self.Q[next_state, other]
    if terminated:
        best = 0.0
    r_plus = reward + self.bonus * self.visits[next_state] ** -0.5
    error = r_plus + self.discount * best - self.Q[state, action]
    self.Q[state, action] = self.Q[state, action] + self.learning_rate * error


# %% all and index
def act(self, state, rng):
    row = list(self.tries[state])
    if 0 in row:
        return row.index(0)
    return self.greedy(state, rng)
