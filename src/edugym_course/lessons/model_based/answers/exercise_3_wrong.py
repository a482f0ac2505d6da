# %% unknown pairs too
# says: pairs that are not known change as well; leave them at U, which is what makes the agent curious
# says: after many sweeps with γ = 0.75, Q[
# in: the solution of sweep
# - if self.known[s, a] == 1:
# + if True:


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
# in: the solution of sweep
# - if self.known[s, a] == 1:
# + if self.known[s, a] == 0:


# %% the end ignored
# says: after a terminal state there is no future: leave γ max_a Q(s', a) out where `ends` is 1
# in: the solution of sweep
# - value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
# + value = max(self.Q[self.next_states[s, a]])


# %% the own state
# says: the maximum is taken over the state itself instead of the next state
# in: the solution of sweep
# - value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
# + value = 0.0 if self.ends[s, a] == 1 else max(self.Q[s])


# %% all discounted
# says: the whole target is discounted; γ belongs to the value of the next state only
# in: the solution of sweep
# - new = self.rewards[s, a] + self.discount * value
# + new = self.discount * (self.rewards[s, a] + value)


# %% minus
# says: the value of the next state is subtracted
# in: the solution of sweep
# - new = self.rewards[s, a] + self.discount * value
# + new = self.rewards[s, a] - self.discount * value


# %% plus equals
# says: the old value is still in the sum: Q(s, a) *becomes* the target, `=` and not `+=`
# in: the solution of sweep
# - self.Q[s, a] = new
# + self.Q[s, a] += new


# %% returns nothing
# says: sweep() gives None: it should return the largest change of a value
# in: the solution of sweep
# - return largest


# %% returns the sum so far of values
# says: once nothing changes any more, sweep() should return 0, the largest change, but returns
# in: the solution of sweep
# - return largest
# + return self.Q.sum()


# %% returns 0
# says: compare the new value with the old one before you store it, and keep the largest change
# says: the largest change of the first sweep(), without its sign, is
# in: the solution of sweep
# - return largest
# + return 0.0


# %% compares after the change
# says: before you store it
# says: , but it returns
# in: the solution of sweep
# - new = self.rewards[s, a] + self.discount * value
# + new = self.rewards[s, a] + self.discount * value
# + self.Q[s, a] = new
# - largest = max(largest, abs(new - self.Q[s, a]))
# - self.Q[s, a] = new
# + largest = max(largest, abs(new - self.Q[s, a]))


# %% self forgotten
# says: NameError
# in: the solution of sweep
# - new = self.rewards[s, a] + self.discount * value
# + new = self.rewards[s, a] + discount * value


# %% does not plan
# says: a new pair is known now, so `learn` should call self.plan(), which sweeps until nothing changes
# in: the solution of learn
# - self.plan()


# %% plans once
# says: should call self.plan()
# in: the solution of learn
# - self.plan()
# + self.sweep()


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
# in: the solution of learn
# - if self.known[state, action] == 0:
# + if True:


# %% forgets known
# says: a pair is known, 1, as soon as it was tried once
# in: the solution of learn
# - self.known[state, action] = 1


# %% no reward kept
# says: [state, action]` keeps what followed
# in: the solution of learn
# - self.rewards[state, action] = reward


# %% never an end
# says: `ends` should be 1 if `terminated`, else 0
# in: the solution of learn
# - self.ends[state, action] = 1 if terminated else 0
# + self.ends[state, action] = 0


# %% not solved
# says: Not solved yet
def learn(self, state, action, reward, next_state, terminated):
    raise NotImplementedError


# %% no abs
# says: values fall as well as rise, and a fall counts too: `abs(new - old)`
# in: the solution of sweep
# - largest = max(largest, abs(new - self.Q[s, a]))
# + largest = max(largest, new - self.Q[s, a])


# %% return in the outer loop
# says: only state 0 is swept
# says: is swept. `return` ends the loops: write it below both, as far to the left as the first `for`
# in: the solution of sweep
# - return largest
# +     return largest


# %% return in the inner loop
# says: only state 0 and action 0 is swept
# says: and action 0
# in: the solution of sweep
# - return largest
# +         return largest


# %% never stores
# says: sweep() changes no value: set Q[s, a] to the target
# in: the solution of sweep
# - self.Q[s, a] = new


# %% largest of the last state
# says: that is a change of the last state: keep the largest of all, and set it to 0.0 above both loops
# in: the solution of sweep
# - largest = 0.0
# - for s in range(self.Q.shape[0]):
# + for s in range(self.Q.shape[0]):
# +     largest = 0.0


# %% the sum
# says: that is the sum of all changes
# in: the solution of sweep
# - largest = max(largest, abs(new - self.Q[s, a]))
# + largest += abs(new - self.Q[s, a])


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
# in: the solution of sweep
# - if self.known[s, a] == 1:
# + if self.rewards[s, a] != 0:


# %% a maximum that starts from 0
# says: the maximum starts from 0, and all values may be lower: start from the first one
# in: the solution of sweep
# - value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
# + value = 0.0 if self.ends[s, a] == 1 else max(0.0, *self.Q[self.next_states[s, a]])


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
# in: the solution of sweep
# - value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
# + value = max(self.Q[self.next_states[s, a]]) if self.ends[s, a] == 1 else 0.0


# %% the maximum of the table
# says: the maximum is taken over the whole table instead of the row of the next state
# in: the solution of sweep
# - value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
# + value = 0.0 if self.ends[s, a] == 1 else self.Q.max()


# %% no discount
# says: the value of the next state is not discounted: multiply it by γ
# in: the solution of sweep
# - new = self.rewards[s, a] + self.discount * value
# + new = self.rewards[s, a] + value


# %% the last state is left out
# slow
# says: state 5 is never swept: are all rows of Q?
# says: is never swept: are all rows of Q?
# in: the solution of sweep
# - for s in range(self.Q.shape[0]):
# + for s in range(self.Q.shape[0] - 1):


# %% only falls
# says: values rise as well as fall, and a rise counts too: `abs(new - old)`
# in: the solution of sweep
# - largest = max(largest, abs(new - self.Q[s, a]))
# + largest = max(largest, self.Q[s, a] - new)


# %% a learning rate
# says: : Q(s, a) *becomes* the target at once; there is no learning rate
# says: after one sweep Q[
# says: ], a pair that ends the episode, should be
# in: the solution of sweep
# - self.Q[s, a] = new
# + self.Q[s, a] += 0.1 * (new - self.Q[s, a])


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


# %% the unknown loses value
# says: ], a pair that is not known, should stay 100, but is 75
# in: the solution of sweep
# - if self.known[s, a] == 1:
# + if self.known[s, a] == 0:
# +     self.Q[s, a] = 75.0
# + else:


# %% only known pairs count in the maximum
# says: , should add up the reward, -1,
# says: and γ times the largest value of state
# says: , which is 100 in your table: 74
# in: the solution of sweep
# - value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
# + n = self.next_states[s, a]
# + value = 0.0 if self.ends[s, a] == 1 else max(self.Q[n] * self.known[n])


# %% the end is that of the next state
# says: , should add up the reward, -1,
# says: and there the episode ended
# in: the solution of sweep
# - value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
# - new = self.rewards[s, a] + self.discount * value
# + value = max(self.Q[self.next_states[s, a]])
# + new = self.rewards[s, a] + self.discount * value * (1 - self.ends[s, 0])


# %% a relative change
# says: , but it returns 4.5: it is that of Q[1, 0], by -2004
# in: the solution of sweep
# - largest = max(largest, abs(new - self.Q[s, a]))
# + largest = max(largest, abs(new - self.Q[s, a]) / max(1.0, abs(new)))
