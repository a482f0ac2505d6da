# %% with one_step_target
# slow
# says: Right: an old network gives the target, and every transition in memory has the same chance. See it learn:
def target_of(self, row):
    memory = self.memory
    dqn.forward(self.target, memory.next_states[row], self.h, self.Q)
    return one_step_target(memory.rewards[row], self.discount, np.max(self.Q), memory.terminated[row] == 1)


# %% a loop for the maximum
# slow
def target_of(self, row):
    y = self.memory.rewards[row]
    if not self.memory.terminated[row]:
        dqn.forward(self.target, self.memory.next_states[row], self.h, self.Q)
        best = self.Q[0, 0]
        for a in range(1, self.Q.shape[1]):
            best = max(best, self.Q[0, a])
        y += self.discount * best
    return y


# %% backwards
# slow
def row_for(self, u):
    n = min(self.steps[0], len(self.memory.rewards))
    return n - 1 - int(u * n)
