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


# %% all at once
def sweep(self):
    V = self.Q.max(axis=1)
    new = self.rewards + self.discount * np.where(self.ends == 1, 0.0, V[self.next_states])
    new = np.where(self.known == 1, new, self.Q)
    largest = np.abs(new - self.Q).max()
    self.Q[:] = new
    return largest
