# %% the placeholder
# says: Not solved yet
def update(self, n):
    raise NotImplementedError("not solved yet: replace this line")


# %% nothing
# says: update changes neither `preferences` nor `V`: change the entries of these arrays in place
def update(self, n):
    pass


# %% no γ^t
# says: the factor γ^t is missing in the step of the preferences
# says: and preferences[
# in: returns first, then the steps in order
# - self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score
# + self.preferences[state, a] += self.learning_rate * delta * score


# %% γ from the end
# says: the power of γ counts the steps from the *end*; t counts from the start
# in: returns first, then the steps in order
# - self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score
# + self.preferences[state, a] += self.learning_rate * self.discount ** (n - 1 - t) * delta * score


# %% one power too many
# says: the power of γ is one too high: the first step has γ^0 = 1
# in: returns first, then the steps in order
# - self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score
# + self.preferences[state, a] += self.learning_rate * self.discount ** (t + 1) * delta * score


# %% no baseline
# says: V(S_t) is not subtracted: δ is the return less the baseline
# in: returns first, then the steps in order
# - delta = self.rewards[t] - self.V[state]
# + delta = self.rewards[t]


# %% G for δ in the policy
# says: V moves, but the preferences move by G instead of δ
# in: returns first, then the steps in order
# - self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score
# + self.preferences[state, a] += self.learning_rate * self.discount**t * self.rewards[t] * score


# %% V stays
# says: the baseline V does not change
# in: returns first, then the steps in order
# - self.V[state] += self.value_learning_rate * delta


# %% V set
# says: V is set to α^w δ; write `+=`
# in: returns first, then the steps in order
# - self.V[state] += self.value_learning_rate * delta
# + self.V[state] = self.value_learning_rate * delta


# %% V by the whole δ
# says: V moves by the whole δ; multiply it by α^w
# in: returns first, then the steps in order
# - self.V[state] += self.value_learning_rate * delta
# + self.V[state] += delta


# %% V by G
# says: V moves by α^w G instead of α^w δ
# in: returns first, then the steps in order
# - self.V[state] += self.value_learning_rate * delta
# + self.V[state] += self.value_learning_rate * self.rewards[t]


# %% δ after V
# says: δ is computed again after V has changed; use the one from before
# in: returns first, then the steps in order
# - self.V[state] += self.value_learning_rate * delta
# + self.V[state] += self.value_learning_rate * delta
# + delta = self.rewards[t] - self.V[state]


# %% the rates exchanged
# says: the two learning rates have changed places
# in: returns first, then the steps in order
# - self.V[state] += self.value_learning_rate * delta
# + self.V[state] += self.learning_rate * delta
# - self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score
# + self.preferences[state, a] += self.value_learning_rate * self.discount**t * delta * score


# %% one rate
# says: V has a learning rate of its own, value_learning_rate
# in: returns first, then the steps in order
# - self.V[state] += self.value_learning_rate * delta
# + self.V[state] += self.learning_rate * delta


# %% rewards for returns
# says: that is the reward R_{t+1}, not the return G_t
# in: the solution of update
# - self.rewards[t] = G  # from here on: the return from step t


# %% not discounted
# says: the return is not discounted: G_t = R_{t+1} + γ G_{t+1}
# in: returns first, then the steps in order
# - G = self.rewards[t] + self.discount * G
# + G = self.rewards[t] + G


# %% the return of the whole episode
# says: every step gets the return of the whole episode; it should be the one from step t on
# in: returns first, then the steps in order
# - delta = self.rewards[t] - self.V[state]
# + delta = G - self.V[state]


# %% without its own reward
# says: the return G_t begins with the reward R_{t+1} = rewards[t], which is missing
# in: the solution of update
# - G = self.rewards[t] + self.discount * G
# - self.rewards[t] = G  # from here on: the return from step t
# + reward = self.rewards[t]
# + self.rewards[t] = self.discount * G
# + G = reward + self.discount * G


# %% from the start
# says: it adds the rewards from the start up to step t; the return adds those from step t on
# in: returns first, then the steps in order
# - for t in range(n - 1, -1, -1):
# + for t in range(n):


# %% the reward discounted too
# says: the reward R_{t+1} itself is discounted; only what follows it should be
# in: returns first, then the steps in order
# - G = self.rewards[t] + self.discount * G
# + G = self.discount * (self.rewards[t] + G)


# %% no π
# says: π is missing in the score: it is 1{a = A} − π(a|S)
# in: returns first, then the steps in order
# - score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
# + score = 1.0 if a == self.actions[t] else 0.0


# %% only the action taken
# says: only the preference of the action that was taken changes; all others change by −π
# in: returns first, then the steps in order
# - for a in range(len(self.probabilities)):
# + for a in range(len(self.probabilities)):
# +     if a != self.actions[t]:
# +         continue


# %% the sign
# says: the sign of the score is wrong: it is 1{a = A} − π(a|S)
# in: returns first, then the steps in order
# - self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score
# + self.preferences[state, a] -= self.learning_rate * self.discount**t * delta * score


# %% π added
# says: π should be subtracted in the score, not added
# in: returns first, then the steps in order
# - score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
# + score = (1.0 if a == self.actions[t] else 0.0) + self.probabilities[a]


# %% no 1{a = A}
# says: 1{a = A} is missing: the action that was taken gets 1 − π, the others −π
# in: returns first, then the steps in order
# - score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
# + score = -self.probabilities[a]


# %% not looked
# says: the probabilities are those of another state: call self.look(state) first
# in: returns first, then the steps in order
# - self.look(state)


# %% the last step missing
# says: the last step of the episode is left out: its number is n − 1
# in: returns first, then the steps in order
# - for t in range(n):
# + for t in range(n - 1):


# %% the whole buffer
# says: it goes through the whole of `rewards`; this episode has only its first n steps
# in: returns first, then the steps in order
# - for t in range(n - 1, -1, -1):
# + for t in range(len(self.rewards) - 1, -1, -1):


# %% the first step missing
# says: the first step of the episode is left out: range(n - 1, -1, -1) goes down to 0
# in: returns first, then the steps in order
# - for t in range(n):
# + for t in range(1, n):


# %% two mistakes
# says: ; and
# in: returns first, then the steps in order
# - self.V[state] += self.value_learning_rate * delta
# + self.V[state] += delta
# - self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score
# + self.preferences[state, a] += self.learning_rate * delta * score


# %% one index
# slow
# says: after the episode with states
# says: that is none of the usual mistakes, so follow this episode by hand
# in: returns first, then the steps in order
# - self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score
# + self.preferences[state] += self.learning_rate * self.discount**t * delta * score


# %% a list of rewards
# says: the table `rewards` should be a NumPy array, but is a list
def create(cls, task):
    n_states, n_actions = int(np.prod(task.observation_space.nvec)), int(task.action_space.n)
    episode = np.zeros(200, np.int64), np.zeros(200, np.int64), [0.0] * 200, np.zeros(1, np.int64)
    return cls(np.zeros((n_states, n_actions)), np.zeros(n_states), np.zeros(n_actions), *episode)


# %% a baseline for each action
# says: the table `V` should have the shape (7,)
def create(cls, task):
    n_states, n_actions = int(np.prod(task.observation_space.nvec)), int(task.action_space.n)
    episode = np.zeros(200, np.int64), np.zeros(200, np.int64), np.zeros(200), np.zeros(1, np.int64)
    return cls(np.zeros((n_states, n_actions)), np.zeros((n_states, n_actions)), np.zeros(n_actions), *episode)


# %% create gives the class back
# says: gives the class MyREINFORCE
def create(cls, task):
    return cls


# %% it learns from terminated episodes alone
# says: an episode that is cut off is over as well: call `update` also when `truncated`
def learn(self, state, action, reward, terminated, truncated):
    t = self.length[0]
    self.states[t], self.actions[t], self.rewards[t] = state, action, reward
    self.length[0] = t + 1
    if terminated:
        self.update(self.length[0])
    if terminated or truncated:
        self.length[0] = 0


# %% one reward too many
# says: the return begins with rewards[n], which an earlier episode has left there: the last reward of n steps is
#   rewards[n - 1]
# in: returns first, then the steps in order
# - for t in range(n - 1, -1, -1):
# + for t in range(n, -1, -1):


# %% the first visit alone
# says: a state that comes twice is updated twice, once for each step
# in: returns first, then the steps in order
# - state = self.states[t]
# + state = self.states[t]
# + if state in self.states[:t]:
# +     continue


# %% every δ before any change
# says: δ is computed with V from before the episode; that is sound too, but in this box V is the one that the
#   updates so far have left
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    deltas = self.rewards[:n] - self.V[self.states[:n]]
    for t in range(n):
        state = self.states[t]
        delta = deltas[t]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% V afterwards
# says: V moves after all steps of the policy; that is sound too, but in this box it moves first, in each step
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score
    for t in range(n):
        self.V[self.states[t]] += self.value_learning_rate * (self.rewards[t] - self.V[self.states[t]])


# %% every π before any change
# says: the probabilities are those from before the episode; they should be those of the preferences as the updates so
#   far have left them
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    scores = np.zeros((n, len(self.probabilities)))
    for t in range(n):
        self.look(self.states[t])
        scores[t] = -self.probabilities
        scores[t, self.actions[t]] += 1
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.preferences[state] += self.learning_rate * self.discount**t * delta * scores[t]


# %% the TD error
# says: that is the TD error of the actor-critic; here δ is the return less V(S_t)
def update(self, n):
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        if t < n - 1:
            delta += self.discount * self.V[self.states[t + 1]]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% the TD error, behind the end too
# says: that is the TD error of the actor-critic, and at the last step it looks up states[n], which is not of this
#   episode; here δ is the return less V(S_t)
def update(self, n):
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] + self.discount * self.V[self.states[t + 1]] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% looked at for each action
# says: the probabilities change between the actions of one step: call self.look(state) once, before that loop
# in: returns first, then the steps in order
# - self.look(state)
# - for a in range(len(self.probabilities)):
# + for a in range(len(self.probabilities)):
# +     self.look(state)


# %% the first return missing
# says: the return of the first step is missing, rewards[0] is still the reward: range(n - 1, -1, -1) goes down to 0
# in: returns first, then the steps in order
# - for t in range(n - 1, -1, -1):
# + for t in range(n - 1, 0, -1):


# %% the first return 0
# says: the return of the first step is missing, it is still 0: range(n - 1, -1, -1) goes down to 0
def update(self, n):
    G = np.zeros(n + 1)
    for t in range(n - 1, 0, -1):
        G[t] = self.rewards[t] + self.discount * G[t + 1]
    for t in range(n):
        state = self.states[t]
        delta = G[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% the state after the step
# says: that is the state after the step, states[t + 1], not S_t
# in: returns first, then the steps in order
# - state = self.states[t]
# + state = self.states[t + 1]


# %% V away
# says: V moves away from the return: the sign is wrong
# in: returns first, then the steps in order
# - self.V[state] += self.value_learning_rate * delta
# + self.V[state] -= self.value_learning_rate * delta


# %% discounted from the start
# says: G_t is discounted from step t on, and not from the start of the episode
# in: returns first, then the steps in order
# - G = self.rewards[t] + self.discount * G
# + G += self.discount**t * self.rewards[t]


# %% the last reward
# says: every step gets the last reward alone
# in: returns first, then the steps in order
# - G = self.rewards[t] + self.discount * G
# + G = self.rewards[n - 1]


# %% times π
# says: the score is that of ln π; here the derivative of the preference is multiplied by π
# in: returns first, then the steps in order
# - score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
# + score = self.probabilities[a] if a == self.actions[t] else 0.0


# %% divided by π
# says: that is 1/π for the action taken; the score of a softmax is 1{a = A} − π(a|S)
# in: returns first, then the steps in order
# - score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
# + score = 1.0 / self.probabilities[a] if a == self.actions[t] else 0.0


# %% the last state
# says: the preferences of the last state change in every step, not those of S_t
# in: returns first, then the steps in order
# - self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score
# + self.preferences[self.states[n - 1], a] += self.learning_rate * self.discount**t * delta * score


# %% return in the loop
# says: only the first step learns: is `return` inside the loop?
# in: the solution of update
# - for a in range(len(self.probabilities)):
# -     score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
# -     self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score
# + for a in range(len(self.probabilities)):
# +     score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
# +     self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score
# + return


# %% γ, not a power
# says: the factor is γ^t, discount**t, and not γ
# in: the solution of update
# - self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score
# + self.preferences[state, a] += self.learning_rate * self.discount * delta * score


# %% δ is missing
# says: δ is missing in the step of the preferences
# in: the solution of update
# - self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score
# + self.preferences[state, a] += self.learning_rate * self.discount**t * score


# %% preferences are set
# says: the preferences are set to their step; write `+=`
# in: the solution of update
# - self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score
# + self.preferences[state, a] = self.learning_rate * self.discount**t * delta * score


# %% look at t
# says: self.look takes the *state* of step t, self.states[t], and not t
# in: the solution of update
# - self.look(state)
# + self.look(t)


# %% no brackets
# says: set brackets around the score: the step is multiplied by (1{a = A} − π(a|S))
# in: the solution of update
# - score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
# - self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score
# + hit = 1.0 if a == self.actions[t] else 0.0
# + self.preferences[state, a] += self.learning_rate * self.discount**t * delta * hit - self.probabilities[a]


# %% no learning rate
# says: the learning rate of the preferences is missing
# in: the solution of update
# - self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score
# + self.preferences[state, a] += self.discount**t * delta * score


# %% 0.4 for α^θ
# says: use `self.learning_rate` in place of 0.4: the check takes another one
# in: the solution of update
# - self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score
# + self.preferences[state, a] += 0.4 * self.discount**t * delta * score


# %% 0.4 for α^w
# says: use `self.value_learning_rate` in place of 0.4: the check takes another one
# in: the solution of update
# - self.V[state] += self.value_learning_rate * delta
# + self.V[state] += 0.4 * delta


# %% 0.99 for γ
# says: use `self.discount` in place of 0.99: the check takes another one
# in: the solution of update
# - G = self.rewards[t] + self.discount * G
# + G = self.rewards[t] + 0.99 * G
# - self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score
# + self.preferences[state, a] += self.learning_rate * 0.99**t * delta * score


# %% 0.4 for both
# says: use `self.learning_rate` and `self.value_learning_rate` in place of 0.4: the check takes others
# in: the solution of update
# - self.V[state] += self.value_learning_rate * delta
# + self.V[state] += 0.4 * delta
# - self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score
# + self.preferences[state, a] += 0.4 * self.discount**t * delta * score


# %% the mean reward
# says: the baseline is V(S_t), not the mean of the rewards
def update(self, n):
    mean = np.mean(self.rewards[:n])
    for t in range(n - 2, -1, -1):
        self.rewards[t] += self.discount * self.rewards[t + 1]
    for t in range(n):
        s = self.states[t]
        delta = self.rewards[t] - mean
        self.V[s] += self.value_learning_rate * delta
        self.look(s)
        for a in range(len(self.probabilities)):
            score = (a == self.actions[t]) - self.probabilities[a]
            self.preferences[s, a] += self.learning_rate * self.discount**t * delta * score


# %% steps to go
# says: the power of γ counts the steps to the *end*; t counts from the start
def update(self, n):
    for t in range(n - 2, -1, -1):
        self.rewards[t] += self.discount * self.rewards[t + 1]
    for t in range(n):
        s = self.states[t]
        delta = self.rewards[t] - self.V[s]
        self.V[s] += self.value_learning_rate * delta
        self.look(s)
        for a in range(len(self.probabilities)):
            score = (a == self.actions[t]) - self.probabilities[a]
            self.preferences[s, a] += self.learning_rate * self.discount ** (n - t) * delta * score


# %% times t
# says: the factor is γ^t, discount**t, and not γ t
def update(self, n):
    for t in range(n - 2, -1, -1):
        self.rewards[t] += self.discount * self.rewards[t + 1]
    for t in range(n):
        s = self.states[t]
        delta = self.rewards[t] - self.V[s]
        self.V[s] += self.value_learning_rate * delta
        self.look(s)
        for a in range(len(self.probabilities)):
            score = (a == self.actions[t]) - self.probabilities[a]
            self.preferences[s, a] += self.learning_rate * self.discount * t * delta * score


# %% V discounted too
# says: γ^t belongs to the preferences alone; V moves by α^w δ
def update(self, n):
    for t in range(n - 2, -1, -1):
        self.rewards[t] += self.discount * self.rewards[t + 1]
    for t in range(n):
        s = self.states[t]
        delta = self.rewards[t] - self.V[s]
        self.V[s] += self.value_learning_rate * self.discount**t * delta
        self.look(s)
        for a in range(len(self.probabilities)):
            score = (a == self.actions[t]) - self.probabilities[a]
            self.preferences[s, a] += self.learning_rate * self.discount**t * delta * score


# %% the others go up
# says: the others get −π, not +π: it is 1{a = A} − π(a|S)
def update(self, n):
    for t in range(n - 2, -1, -1):
        self.rewards[t] += self.discount * self.rewards[t + 1]
    for t in range(n):
        s = self.states[t]
        delta = self.rewards[t] - self.V[s]
        self.V[s] += self.value_learning_rate * delta
        self.look(s)
        for a in range(len(self.probabilities)):
            score = 1 - self.probabilities[a] if a == self.actions[t] else self.probabilities[a]
            self.preferences[s, a] += self.learning_rate * self.discount**t * delta * score


# %% preferences in the score
# says: the score takes the probabilities π, not the preferences: 1{a = A} − π(a|S)
def update(self, n):
    for t in range(n - 2, -1, -1):
        self.rewards[t] += self.discount * self.rewards[t + 1]
    for t in range(n):
        s = self.states[t]
        delta = self.rewards[t] - self.V[s]
        self.V[s] += self.value_learning_rate * delta
        self.look(s)
        for a in range(len(self.probabilities)):
            score = (a == self.actions[t]) - self.preferences[s, a]
            self.preferences[s, a] += self.learning_rate * self.discount**t * delta * score


# %% a row for an entry
# says: preferences has two indices, the state and the action: self.preferences[a] is the whole row of state a
def update(self, n):
    for t in range(n - 2, -1, -1):
        self.rewards[t] += self.discount * self.rewards[t + 1]
    for t in range(n):
        s = self.states[t]
        delta = self.rewards[t] - self.V[s]
        self.V[s] += self.value_learning_rate * delta
        self.look(s)
        for a in range(len(self.probabilities)):
            score = (a == self.actions[t]) - self.probabilities[a]
            self.preferences[a] += self.learning_rate * self.discount**t * delta * score


# %% t for the state
# says: that is the number of the step; its state is self.states[t]
def update(self, n):
    for t in range(n - 2, -1, -1):
        self.rewards[t] += self.discount * self.rewards[t + 1]
    for t in range(n):
        s = t
        delta = self.rewards[t] - self.V[s]
        self.V[s] += self.value_learning_rate * delta
        self.look(s)
        for a in range(len(self.probabilities)):
            score = (a == self.actions[t]) - self.probabilities[a]
            self.preferences[s, a] += self.learning_rate * self.discount**t * delta * score


# %% the mean of the returns
# says: the baseline is V(S_t), not the mean of the returns
# in: returns first, then the steps in order
# - delta = self.rewards[t] - self.V[state]
# + delta = self.rewards[t] - np.mean(self.rewards[:n])


# %% the largest value
# says: the baseline is V(S_t), not the largest of all values
# in: returns first, then the steps in order
# - delta = self.rewards[t] - self.V[state]
# + delta = self.rewards[t] - np.max(self.V)


# %% V of the number of the step
# says: V[t] is the value of state t; that of the state of step t is V[self.states[t]]
# in: returns first, then the steps in order
# - delta = self.rewards[t] - self.V[state]
# - self.V[state] += self.value_learning_rate * delta
# + delta = self.rewards[t] - self.V[t]
# + self.V[t] += self.value_learning_rate * delta


# %% the row of the number of the step
# says: preferences[t] is the row of state t; that of step t is preferences[self.states[t]]
# in: returns first, then the steps in order
# - self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score
# + self.preferences[t, a] += self.learning_rate * self.discount**t * delta * score


# %% noted too early
# says: that is G_{t+1}, the return from the next step: is it noted before the reward of step t is added?
# in: returns first, then the steps in order
# - G = self.rewards[t] + self.discount * G
# - self.rewards[t] = G
# + self.rewards[t], G = G, self.rewards[t] + self.discount * G


# %% looked at once
# says: the probabilities are those of the first state for all steps: call self.look(state) for every step
# in: returns first, then the steps in order
# - for t in range(n):
# + self.look(self.states[0])
# + for t in range(n):
# - self.look(state)


# %% all as the one that was taken
# says: all actions get 1 − π; only the one that was taken should, and the others −π
# in: returns first, then the steps in order
# - score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
# + score = 1.0 - self.probabilities[a]


# %% all places
# says: it learns from all places of the arrays; the episode has only its first n steps: range(n)
# in: returns first, then the steps in order
# - for t in range(n):
# + for t in range(len(self.states)):

# %% the mean of the returns for the preferences alone
# says: V moves, but the baseline of the preferences is the mean of the returns, and it should be V(S_t)
# in: returns first, then the steps in order
# - for t in range(n):
# + mean = self.rewards[:n].mean()
# + for t in range(n):
# - self.look(state)
# + delta = self.rewards[t] - mean
# + self.look(state)


# %% 1 or −π
# says: the action that was taken gets 1 − π, not 1: π is subtracted for it, too
# in: returns first, then the steps in order
# - score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
# + score = 1.0 if a == self.actions[t] else -self.probabilities[a]


# %% R for δ in the policy
# says: V moves, but the preferences move by the reward instead of δ
# in: a sum for each return
# - step = self.learning_rate * self.discount**t * delta
# + step = self.learning_rate * self.discount**t * self.rewards[t]


# %% a list from the end
# says: the returns stand in the reverse order, as in a list that is filled from the last step on
def update(self, n):
    G, returns = 0.0, []
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        returns.append(G)
    for t in range(n):
        state, action = self.states[t], self.actions[t]
        delta = returns[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        step = self.learning_rate * self.discount**t * delta
        self.preferences[state] -= step * self.probabilities
        self.preferences[state, action] += step


# %% V behind the end
# says: the return begins behind the end with V of the last state; an episode that is over has nothing more to come
# in: returns first, then the steps in order
# - G = 0.0
# + G = self.V[self.states[n - 1]]
