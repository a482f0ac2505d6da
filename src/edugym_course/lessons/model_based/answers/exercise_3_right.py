# %% return early
# says: Right: the unknown is worth U, so the way to it is planned like any other way. In the race its policy goes on
#   exploring, since it has one table only, until all that matters is known; then it jumps to the optimum:
def learn(self, state, action, reward, next_state, terminated):
    if self.known[state, action]:
        return
    self.known[state, action] += 1
    self.rewards[state, action] = reward
    self.next_states[state, action] = next_state
    self.ends[state, action] = terminated
    self.plan()


# %% continue
def sweep(self):
    largest = 0.0
    n_states, n_actions = self.Q.shape
    for s in range(n_states):
        for a in range(n_actions):
            if self.known[s, a] == 0:
                continue
            old = self.Q[s, a]
            target = self.rewards[s, a]
            if not self.ends[s, a]:
                target += self.discount * self.Q[self.next_states[s, a]].max()
            self.Q[s, a] = target
            if abs(target - old) > largest:
                largest = abs(target - old)
    return largest


# %% from a copy
def sweep(self):
    old = self.Q.copy()
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(old[self.next_states[s, a]])
                self.Q[s, a] = self.rewards[s, a] + self.discount * value
    return np.max(np.abs(self.Q - old))


# %% 1 less the end
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = (1 - self.ends[s, a]) * max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return largest


# %% backwards
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0] - 1, -1, -1):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return largest


# %% int
def learn(self, state, action, reward, next_state, terminated):
    if self.known[state, action] == 0:
        self.known[state, action] = 1
        self.rewards[state, action] = reward
        self.next_states[state, action] = next_state
        self.ends[state, action] = int(terminated)
        self.plan()


# %% both methods
def learn(self, state, action, reward, next_state, terminated):
    if self.known[state, action] < 1:
        self.known[state, action] = 1
        self.rewards[state, action] = reward
        self.next_states[state, action] = next_state
        self.ends[state, action] = 1 if terminated else 0
        self.plan()


def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return largest


# %% all at once
def sweep(self):
    V = self.Q.max(axis=1)
    new = self.rewards + self.discount * np.where(self.ends == 1, 0.0, V[self.next_states])
    new = np.where(self.known == 1, new, self.Q)
    largest = np.abs(new - self.Q).max()
    self.Q[:] = new
    return largest


# %% the parameters of learn in another order
def learn(self, action, state, terminated, next_state, reward):
    if self.known[state, action] == 0:
        self.known[state, action] = 1
        self.rewards[state, action] = reward
        self.next_states[state, action] = next_state
        self.ends[state, action] = 1 if terminated else 0
        self.plan()


# %% learn is told whether the episode was cut off
def learn(self, state, action, reward, next_state, terminated, truncated):
    if self.known[state, action] == 0:
        self.known[state, action] = 1
        self.rewards[state, action] = reward
        self.next_states[state, action] = next_state
        self.ends[state, action] = 1 if terminated else 0
        self.plan()
