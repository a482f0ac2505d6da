# %% two branches
# says: Right: what was not tried for a long time looks better and better, until the agent goes and sees. See its race:
def imagine(self, s, a):
    tau = self.clock[0] - self.last[s, a]
    bonus = self.kappa * np.sqrt(tau)
    if self.last[s, a] == 0:
        return bonus + self.discount * np.max(self.Q[s])
    if self.ends[s, a]:
        return self.rewards[s, a] + bonus
    return self.rewards[s, a] + bonus + self.discount * np.max(self.Q[self.next_states[s, a]])


# %% 1 less the end
def imagine(self, s, a):
    if self.last[s, a] > 0:
        future = (1 - self.ends[s, a]) * self.Q[self.next_states[s, a]].max()
    else:
        future = self.Q[s].max()
    return self.rewards[s, a] + self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5 + self.discount * future


# %% other parameter names
def imagine(self, state, action):
    reward, next_state, ended = (
        self.rewards[state, action],
        self.next_states[state, action],
        self.ends[state, action] == 1,
    )
    if self.last[state, action] == 0:
        reward, next_state, ended = 0.0, state, False
    bonus = self.kappa * (self.clock[0] - self.last[state, action]) ** 0.5
    value = 0.0 if ended else max(self.Q[next_state])
    return reward + bonus + self.discount * value
