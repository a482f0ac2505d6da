# %% unknown pairs too
# says: pairs that are not known change as well; leave them at U, which is what makes the agent curious
# says: after many sweeps with γ = 0.75, Q[
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if True:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return largest


# %% unknown pairs are 0
# says: pairs that are not known are set to 0; leave them at U, which is what makes the agent curious
# says: ], a pair that is
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
            else:
                self.Q[s, a] = 0.0
    return largest


# %% the test the wrong way round
# says: the test of `known` is the wrong way round
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 0:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return largest


# %% the end ignored
# says: after a terminal state there is no future: leave γ max_a Q(s', a) out where `ends` is 1
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return largest


# %% the own state
# says: the maximum is taken over the state itself instead of the next state
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[s])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return largest


# %% all discounted
# says: the whole target is discounted; γ belongs to the value of the next state only
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.discount * (self.rewards[s, a] + value)
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return largest


# %% minus
# says: the value of the next state is subtracted
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] - self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return largest


# %% plus equals
# says: the old value is still in the sum: Q(s, a) *becomes* the target, `=` and not `+=`
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] += new
    return largest


# %% returns nothing
# says: sweep() gives None: it should return the largest change of a value
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new


# %% returns the sum so far of values
# says: once nothing changes any more, sweep() should return 0, the largest change, but returns
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return self.Q.sum()


# %% returns 0
# says: compare the new value with the old one before you store it, and keep the largest change
# says: the largest change of the first sweep(), without its sign, is
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return 0.0


# %% compares after the change
# says: before you store it
# says: , but it returns
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                self.Q[s, a] = new
                largest = max(largest, abs(new - self.Q[s, a]))
    return largest


# %% self forgotten
# says: NameError
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return largest


# %% does not plan
# says: a new pair is known now, so `learn` should call self.plan(), which sweeps until nothing changes
def learn(self, state, action, reward, next_state, terminated):
    if self.known[state, action] == 0:
        self.known[state, action] = 1
        self.rewards[state, action] = reward
        self.next_states[state, action] = next_state
        self.ends[state, action] = 1 if terminated else 0


# %% plans once
# says: should call self.plan()
def learn(self, state, action, reward, next_state, terminated):
    if self.known[state, action] == 0:
        self.known[state, action] = 1
        self.rewards[state, action] = reward
        self.next_states[state, action] = next_state
        self.ends[state, action] = 1 if terminated else 0
        self.sweep()


# %% plans for a known pair too
# says: Q changes: that pair was known already, so `learn` need not plan again
def learn(self, state, action, reward, next_state, terminated):
    if self.known[state, action] == 0:
        self.known[state, action] = 1
        self.rewards[state, action] = reward
        self.next_states[state, action] = next_state
        self.ends[state, action] = 1 if terminated else 0
    self.plan()


# %% overwrites what is known
# says: that pair was known already, and then nothing should change
# says: the pair that was tried
def learn(self, state, action, reward, next_state, terminated):
    if True:
        self.known[state, action] = 1
        self.rewards[state, action] = reward
        self.next_states[state, action] = next_state
        self.ends[state, action] = 1 if terminated else 0
        self.plan()


# %% forgets known
# says: a pair is known, 1, as soon as it was tried once
def learn(self, state, action, reward, next_state, terminated):
    if self.known[state, action] == 0:
        self.rewards[state, action] = reward
        self.next_states[state, action] = next_state
        self.ends[state, action] = 1 if terminated else 0
        self.plan()


# %% no reward kept
# says: [state, action]` keeps what followed
def learn(self, state, action, reward, next_state, terminated):
    if self.known[state, action] == 0:
        self.known[state, action] = 1
        self.next_states[state, action] = next_state
        self.ends[state, action] = 1 if terminated else 0
        self.plan()


# %% never an end
# says: `ends` should be 1 if `terminated`, else 0
def learn(self, state, action, reward, next_state, terminated):
    if self.known[state, action] == 0:
        self.known[state, action] = 1
        self.rewards[state, action] = reward
        self.next_states[state, action] = next_state
        self.ends[state, action] = 0
        self.plan()


# %% not solved
# says: Not solved yet
def learn(self, state, action, reward, next_state, terminated):
    raise NotImplementedError


# %% no abs
# says: values fall as well as rise, and a fall counts too: `abs(new - old)`
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, new - self.Q[s, a])
                self.Q[s, a] = new
    return largest


# %% return in the outer loop
# says: only state 0 is swept
# says: is swept. `return` ends the loops: write it below both, as far to the left as the first `for`
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


# %% return in the inner loop
# says: only state 0 and action 0 is swept
# says: and action 0
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


# %% never stores
# says: sweep() changes no value: set Q[s, a] to the target
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
    return largest


# %% largest of the last state
# says: that is a change of the last state: keep the largest of all, and set it to 0.0 above both loops
def sweep(self):
    for s in range(self.Q.shape[0]):
        largest = 0.0
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return largest


# %% the sum
# says: that is the sum of all changes
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest += abs(new - self.Q[s, a])
                self.Q[s, a] = new
    return largest


# %% plans first
# says: ` is set only after self.plan(), which cannot use it then: remember first, and plan last
def learn(self, state, action, reward, next_state, terminated):
    if self.known[state, action] == 0:
        self.plan()
        self.known[state, action] = 1
        self.rewards[state, action] = reward
        self.next_states[state, action] = next_state
        self.ends[state, action] = 1 if terminated else 0


# %% an instance
# says: should be the class
MyRMax = RMax.create((6, 3))

# %% the package's
# says: known
# says: the agent should have a table `
MyRMax = RMax


# %% remembered for the next state
# says: it is remembered for next_state; what followed belongs to the pair that was tried, [state, action]
def learn(self, state, action, reward, next_state, terminated):
    if self.known[state, action] == 0:
        self.known[next_state, action] = 1
        self.rewards[next_state, action] = reward
        self.next_states[next_state, action] = next_state
        self.ends[next_state, action] = terminated
        self.plan()


# %% all actions of the state
# says: a pair that was not tried
def learn(self, state, action, reward, next_state, terminated):
    if self.known[state, action] == 0:
        self.known[state] = 1
        self.rewards[state, action] = reward
        self.next_states[state, action] = next_state
        self.ends[state, action] = terminated
        self.plan()


# %% rewards for the unknown
# says: sweep() changes the table `
# says: `: planning changes Q only
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
            else:
                self.rewards[s, a] = 100.0
    return largest


# %% a reward of 0 is unknown
# says: a known pair may have a reward of 0: ask `known`, and not the rewards, which pairs are known
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.rewards[s, a] != 0:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return largest


# %% a maximum that starts from 0
# says: the maximum starts from 0, and all values may be lower: start from the first one
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(0.0, *self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return largest


# %% break
# says: `break` leaves out all actions after the first that is not known: write `continue` there
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 0:
                break
            value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
            new = self.rewards[s, a] + self.discount * value
            largest = max(largest, abs(new - self.Q[s, a]))
            self.Q[s, a] = new
    return largest


# %% return where nothing is known
# says: the sweep ends at the first pair that is not known: leave out this pair alone, and go on
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 0:
                return largest
            value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
            new = self.rewards[s, a] + self.discount * value
            largest = max(largest, abs(new - self.Q[s, a]))
            self.Q[s, a] = new
    return largest


# %% the end the wrong way round
# says: the test of `ends` is the wrong way round: the value of the next state counts where it is 0
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = max(self.Q[self.next_states[s, a]]) if self.ends[s, a] == 1 else 0.0
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return largest


# %% the maximum of the table
# says: the maximum is taken over the whole table instead of the row of the next state
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else self.Q.max()
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return largest


# %% no discount
# says: the value of the next state is not discounted: multiply it by γ
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return largest


# %% the last state is left out
# says: state 5 is never swept: are all rows of Q?
# says: is never swept: are all rows of Q?
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0] - 1):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] = new
    return largest


# %% only falls
# says: values rise as well as fall, and a rise counts too: `abs(new - old)`
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, self.Q[s, a] - new)
                self.Q[s, a] = new
    return largest


# %% a learning rate
# says: : Q(s, a) *becomes* the target at once; there is no learning rate
# says: after one sweep Q[
# says: ], a pair that ends the episode, should be
def sweep(self):
    largest = 0.0
    for s in range(self.Q.shape[0]):
        for a in range(self.Q.shape[1]):
            if self.known[s, a] == 1:
                value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                new = self.rewards[s, a] + self.discount * value
                largest = max(largest, abs(new - self.Q[s, a]))
                self.Q[s, a] += 0.1 * (new - self.Q[s, a])
    return largest


# %% known the wrong way round
# says: nothing is remembered, and the pair is new: `learn` should do nothing only where self.known[state, action] is 1
def learn(self, state, action, reward, next_state, terminated):
    if not self.known[state, action]:
        return
    self.rewards[state, action] = reward
    self.next_states[state, action] = next_state
    self.ends[state, action] = 1 if terminated else 0
    self.known[state, action] = 1
    self.plan()


# %% known asks for the state
# says: nothing is remembered, and the pair is new: `learn` should do nothing only where self.known[state, action] is 1
def learn(self, state, action, reward, next_state, terminated):
    if max(self.known[state]) == 1:
        return
    self.rewards[state, action] = reward
    self.next_states[state, action] = next_state
    self.ends[state, action] = 1 if terminated else 0
    self.known[state, action] = 1
    self.plan()


# %% no plan at the end
# says: so `learn` should call self.plan(), which sweeps until nothing changes
# says: terminated=True
def learn(self, state, action, reward, next_state, terminated):
    if self.known[state, action] == 1:
        return
    self.rewards[state, action] = reward
    self.next_states[state, action] = next_state
    self.ends[state, action] = 1 if terminated else 0
    self.known[state, action] = 1
    if not terminated:
        self.plan()


# %% the terminal state is 0
# says: a pair that is not known stays at U, so `learn` leaves Q to self.plan()
def learn(self, state, action, reward, next_state, terminated):
    if self.known[state, action] == 1:
        return
    self.rewards[state, action] = reward
    self.next_states[state, action] = next_state
    self.ends[state, action] = 1 if terminated else 0
    self.known[state, action] = 1
    if terminated:
        self.Q[next_state] = 0.0
    self.plan()
