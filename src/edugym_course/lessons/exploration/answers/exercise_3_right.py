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


# %% a weighted mean
def learn(self, state, action, reward, next_state, terminated):
    self.tries[state, action] += 1
    self.visits[next_state] += 1
    n = self.visits[next_state]
    target = reward + self.bonus / np.sqrt(n) + self.discount * (1 - terminated) * self.Q[next_state].max()
    self.Q[state, action] = (1 - self.learning_rate) * self.Q[state, action] + self.learning_rate * target


# %% more parameters than needed
def learn(self, state, action, reward, next_state, terminated, truncated):
    self.tries[state][action] += 1
    self.visits[next_state] += 1
    future = 0 if terminated else self.Q[next_state].max()
    self.Q[state][action] += self.learning_rate * (
        reward + self.bonus / self.visits[next_state] ** 0.5 + self.discount * future - self.Q[state][action]
    )


# %% any untried grip, at random
def act(self, state, rng):
    n_actions = self.Q.shape[1]
    first = int(rng.random() * n_actions)
    for i in range(n_actions):
        action = (first + i) % n_actions
        if self.tries[state, action] < 1:
            return action
    return self.greedy(state, rng)


# %% the last untried grip, by argmin
def act(self, state, rng):
    if self.tries[state].min() == 0:
        return int(np.argmin(self.tries[state]))
    return self.greedy(state, rng)


# %% a numpy number
def act(self, state, rng):
    untried = np.flatnonzero(self.tries[state] == 0)
    if len(untried) > 0:
        return rng.choice(untried)
    best = np.flatnonzero(self.Q[state] == self.Q[state].max())
    return rng.choice(best)


# %% a plain class
class MyExplorer:
    def __init__(self, n_states, n_actions):
        self.Q = np.zeros((n_states, n_actions))
        self.visits = np.zeros(n_states, int)
        self.tries = np.zeros((n_states, n_actions), int)
        self.learning_rate, self.discount, self.bonus = 0.5, 0.9, 1.0

    @classmethod
    def create(cls, wall):
        return cls(wall.observation_space.n, wall.action_space.n)

    def greedy(self, state, rng):
        return rng.choice(np.flatnonzero(self.Q[state] == max(self.Q[state])))

    def act(self, state, rng):
        for action, tried in enumerate(self.tries[state]):
            if not tried:
                return action
        return self.greedy(state, rng)

    def learn(self, state, action, reward, next_state, terminated):
        self.tries[state, action] += 1
        self.visits[next_state] += 1
        target = reward + self.bonus / self.visits[next_state] ** 0.5
        if not terminated:
            target += self.discount * max(self.Q[next_state])
        self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% error first
def learn(self, state, action, reward, next_state, terminated):
    self.visits[next_state] += 1
    self.tries[state, action] += 1
    delta = reward - self.Q[state, action]
    delta += self.bonus / np.sqrt(self.visits[next_state])
    if not terminated:
        delta += self.discount * np.amax(self.Q[next_state, :])
    self.Q[state, action] += self.learning_rate * delta


# %% infinite value for the untried
def act(self, state, rng):
    values = np.where(self.tries[state] == 0, np.inf, self.Q[state])
    return int(rng.choice(np.flatnonzero(values == values.max())))


# %% all and index
def act(self, state, rng):
    row = list(self.tries[state])
    if 0 in row:
        return row.index(0)
    return self.greedy(state, rng)
