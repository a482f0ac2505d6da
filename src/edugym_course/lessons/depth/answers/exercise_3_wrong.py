# %% the smallest value
# says: Q[
# says: that is none of the usual mistakes
# says: The steps after it are right, and at the next one G is cut: look at the third line, and at γ in the first
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
        if self.Q[s, a] > min(self.Q[s]):
            G = min(self.Q[s])


# %% the best value goes into the update
# says: Q[
# says: episode with states
# says: G is cut before the update, and the value of the action learns from it; the third line comes after the second
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        if self.Q[s, a] < max(self.Q[s]):
            G = max(self.Q[s])
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])


# %% the numbers of Q-learning
# says: G is cut at every action, so only one reward is in each target: cut where Q(S, A) is *below* the largest value
# says: ] should become
def hand_back(self, length):
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        best = 0.0 if k == length - 1 else max(self.Q[self.states[k + 1]])
        self.Q[s, a] += self.learning_rate * (self.rewards[k] + self.discount * best - self.Q[s, a])


# %% nothing
# says: `hand_back` changes nothing in Q
def hand_back(self, length):
    pass


# %% Monte Carlo
# says: G is never cut, so this is Monte Carlo: the third line is missing, or it stands behind the loop
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])


# %% the condition upside down
# says: the condition is upside down: G is cut where the action is *not* the best
# in: reversed
# - for k in reversed(range(length)):
# + for k in range(length - 1, -1, -1):
# - if self.Q[s, a] < max(self.Q[s]):
# + if self.Q[s, a] == max(self.Q[s]):


# %% asked before the update
# says: whether the action is the best is asked before the update; ask it after
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        exploring = self.Q[s, a] < max(self.Q[s])
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
        if exploring:
            G = max(self.Q[s])


# %% the loop ends
# says: the loop ends at the exploring action; the steps before it still learn, from the G that was cut
# in: reversed
# - for k in reversed(range(length)):
# + for k in range(length - 1, -1, -1):
# - G = max(self.Q[s])
# + break


# %% it goes on with its own value
# says: where G is cut it goes on with the *largest* value of the state, not with that of the action taken
# in: reversed
# - for k in reversed(range(length)):
# + for k in range(length - 1, -1, -1):
# - G = max(self.Q[s])
# + G = self.Q[s, a]


# %% it goes on with 0
# says: where G is cut it goes on with the largest value of the state, not with 0
# in: reversed
# - for k in reversed(range(length)):
# + for k in range(length - 1, -1, -1):
# - G = max(self.Q[s])
# + G = 0.0


# %% the mean of the row
# says: where G is cut it goes on with the *largest* value of the state, not with the mean
# in: reversed
# - for k in reversed(range(length)):
# + for k in range(length - 1, -1, -1):
# - G = max(self.Q[s])
# + G = self.Q[s].mean()


# %% the larger of the two
# says: G takes the largest value also where it is smaller; max(G, ...) keeps lucky returns
# in: reversed
# - for k in reversed(range(length)):
# + for k in range(length - 1, -1, -1):
# - G = max(self.Q[s])
# + G = max(G, max(self.Q[s]))


# %% discounted twice
# says: the largest value is discounted where G is cut, and once more in the next step
# in: reversed
# - for k in reversed(range(length)):
# + for k in range(length - 1, -1, -1):
# - G = max(self.Q[s])
# + G = self.discount * max(self.Q[s])


# %% forwards
# says: the loop runs forwards; go from the last step to the first
# in: reversed
# - for k in reversed(range(length)):
# + for k in range(length):


# %% the first step is left out
# says: the first step of the episode, number 0, learns nothing: range(length - 1, -1, -1) ends with 0
# in: reversed
# - for k in reversed(range(length)):
# + for k in range(length - 1, 0, -1):


# %% the last step is left out
# says: the last step of the episode learns nothing: start at length - 1
# in: reversed
# - for k in reversed(range(length)):
# + for k in range(length - 2, -1, -1):


# %% no discount
# says: the discount is missing: G becomes R + γ G
# in: reversed
# - for k in reversed(range(length)):
# + for k in range(length - 1, -1, -1):
# - G = self.rewards[k] + self.discount * G
# + G = self.rewards[k] + G


# %% all discounted
# says: the reward is discounted too; γ belongs to G only
# in: reversed
# - for k in reversed(range(length)):
# + for k in range(length - 1, -1, -1):
# - G = self.rewards[k] + self.discount * G
# + G = self.discount * (self.rewards[k] + G)


# %% the reward is not added up
# says: only one reward is in each target: G becomes R + γ G
# in: reversed
# - for k in reversed(range(length)):
# + for k in range(length - 1, -1, -1):
# - G = self.rewards[k] + self.discount * G
# + G = self.rewards[k]


# %% the old value is not subtracted
# says: the old value is not subtracted: Q moves by α [G − Q]
# in: reversed
# - for k in reversed(range(length)):
# + for k in range(length - 1, -1, -1):
# - self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
# + self.Q[s, a] += self.learning_rate * G


# %% set at once
# says: Q is set to G at once: move it by α [G − Q]
# in: reversed
# - for k in reversed(range(length)):
# + for k in range(length - 1, -1, -1):
# - self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
# + self.Q[s, a] = G


# %% the sign
# says: Q moves away from the target: the sign is wrong
# in: reversed
# - for k in reversed(range(length)):
# + for k in range(length - 1, -1, -1):
# - self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
# + self.Q[s, a] += self.learning_rate * (self.Q[s, a] - G)


# %% exploring actions learn nothing
# says: exploring actions learn nothing; they do, from what came after them
# in: reversed
# - for k in reversed(range(length)):
# + for k in range(length - 1, -1, -1):
# - G = self.rewards[k] + self.discount * G
# + G = self.rewards[k] + self.discount * G
# + if self.Q[s, a] < max(self.Q[s]):
# +     G = max(self.Q[s])
# +     continue


# %% a learning rate of its own
# says: a learning_rate of 0.1: use self.learning_rate
# says: everything fits
# in: reversed
# - for k in reversed(range(length)):
# + for k in range(length - 1, -1, -1):
# - self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
# + self.Q[s, a] += 0.1 * (G - self.Q[s, a])


# %% the sign, and a learning rate of its own
# says: the sign is wrong; and everything fits a learning_rate of 0.1
# in: reversed
# - for k in reversed(range(length)):
# + for k in range(length - 1, -1, -1):
# - self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
# + self.Q[s, a] += 0.1 * (self.Q[s, a] - G)


# %% Monte Carlo, and without the discount
# says: the third line is missing, or it stands behind the loop
# says: discount
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G += self.rewards[k]
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])


# %% self forgotten
# says: write `self.` before a field or a method
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + discount * G
        self.Q[s, a] += learning_rate * (G - self.Q[s, a])


# %% one step too many
# slow
# says: a value changes that is not on the path: the steps of the episode are 0 to length - 1
# in: reversed
# - for k in reversed(range(length)):
# + for k in range(length, -1, -1):


# %% an agent in place of the class
# says: MyAgent should be the class
MyAgent = NStepSARSA.create((12, 3))


# %% the reward of the next step
# says: `rewards[k]` is R_{k+1} already, the reward after step k
# in: the solution of hand_back
# - G = self.rewards[k] + self.discount * G
# + G = self.rewards[k + 1] + self.discount * G


# %% the old maximum
# says: the largest value is that of the row before the update; take it after
# in: reversed
# - G = self.rewards[k] + self.discount * G
# + G = self.rewards[k] + self.discount * G
# + best = max(self.Q[s])
# - G = max(self.Q[s])
# + G = best


# %% added
# says: where G is cut the largest value takes its place; it is not added
# in: reversed
# - G = max(self.Q[s])
# + G += max(self.Q[s])


# %% the reward discounted
# says: γ belongs to G, not to the reward
# in: reversed
# - G = self.rewards[k] + self.discount * G
# + G = self.discount * self.rewards[k] + G


# %% no rewards
# says: the rewards are missing: G becomes R + γ G
# in: reversed
# - G = self.rewards[k] + self.discount * G
# + G = self.discount * G


# %% minus
# says: the future is subtracted: G becomes R + γ G
# in: reversed
# - G = self.rewards[k] + self.discount * G
# + G = self.rewards[k] - self.discount * G


# %% set
# says: the old value is lost: Q moves by α [G − Q], so write +=
# in: reversed
# - self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
# + self.Q[s, a] = self.learning_rate * (G - self.Q[s, a])


# %% the weights exchanged
# says: α and 1 − α have changed places
# in: reversed
# - self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
# + self.Q[s, a] = self.learning_rate * self.Q[s, a] + (1 - self.learning_rate) * G


# %% a value after the end
# says: G starts with a value of the state after the end; after a terminal state there is no future
# in: the solution of learn, hand_back
# - self.states[k], self.actions[k], self.rewards[k] = state, action, reward
# + self.states[k], self.actions[k], self.rewards[k] = state, action, reward
# + self.states[k + 1] = next_state
# - G = 0.0
# - for k in range(length - 1, -1, -1):
# + G = max(self.Q[self.states[length]])
# + for k in reversed(range(length)):
# - best = max(self.Q[s])
# - if self.Q[s, a] < best:
# -     G = best
# + if self.Q[s, a] < max(self.Q[s]):
# +     G = max(self.Q[s])


# %% argmax for max
# says: where G is cut it goes on with the largest *value*, max; argmax is the number of an action
# in: reversed
# - for k in reversed(range(length)):
# + for k in range(length - 1, -1, -1):
# - G = max(self.Q[s])
# + G = np.argmax(self.Q[s])


# %% a maximum that starts from 0
# says: the search for the largest value starts from 0, and all values may be lower
# in: the solution of hand_back
# - best = max(self.Q[s])
# + best = max(0.0, *self.Q[s])


# %% the third line behind the loop
# says: G is never cut, so this is Monte Carlo: the third line is missing, or it stands behind the loop
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
    if self.Q[s, a] < max(self.Q[s]):
        G = max(self.Q[s])


# %% cut before the reward
# says: G is cut before the reward is added; the third line comes last
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        if self.Q[s, a] < max(self.Q[s]):
            G = max(self.Q[s])
        G = self.rewards[k] + self.discount * G
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])


# %% G is compared
# says: it asks whether G is below the largest value; ask whether Q(S, A) is
# in: reversed
# - for k in reversed(range(length)):
# + for k in range(length - 1, -1, -1):
# - if self.Q[s, a] < max(self.Q[s]):
# + if G < max(self.Q[s]):


# %% the smallest value
# says: where G is cut it goes on with the *largest* value of the state, not with the smallest
# in: reversed
# - for k in reversed(range(length)):
# + for k in range(length - 1, -1, -1):
# - G = max(self.Q[s])
# + G = min(self.Q[s])


# %% the step in place of the state
# says: `k` is the number of the step; the state of that step is self.states[k]
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        a = self.actions[k]
        G = self.rewards[k] + self.discount * G
        self.Q[k, a] += self.learning_rate * (G - self.Q[k, a])
        if self.Q[k, a] < max(self.Q[k]):
            G = max(self.Q[k])


# %% a start from the last state
# says: G starts with a value of the last state; after the end there is no future, so it starts at 0
# in: reversed
# - G = 0.0
# - for k in reversed(range(length)):
# + G = max(self.Q[self.states[length - 1]])
# + for k in range(length - 1, -1, -1):


# %% fields without self
# says: name 'rewards' is not defined (write `self.` before a field or a method)
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        G = rewards[k] + self.discount * G


# %% the number of the best action
# says: G is cut at an action that ties with the best where it is not the *first* of them, as argmax finds it: compare its
#   value with the largest
# in: while
# - if self.Q[s, a] != self.Q[s].max():
# + if a != np.argmax(self.Q[s]):


# %% the number of the last best action
# says: G is cut at an action that ties with the best where it is not the *last* of them: compare its value with the
#   largest
# in: while
# - if self.Q[s, a] != self.Q[s].max():
# + if a != max(range(self.Q.shape[1]), key=lambda b: (self.Q[s, b], b)):


# %% better than all others
# says: G is cut at an action that ties with the best, and is as good: cut only where its value is *below* the largest
# in: while
# - if self.Q[s, a] != self.Q[s].max():
# + if not self.Q[s, a] > np.delete(self.Q[s], a).max():


# %% a value that was not visited
# slow
# says: ] should stay
# says: a value changes that is not on the path: the steps of the episode are 0 to length - 1
def hand_back(self, length):
    G = 0.0
    for k in reversed(range(length)):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
        if self.Q[s, a] < max(self.Q[s]):
            G = max(self.Q[s])
    visited = {*zip(self.states[:length], self.actions[:length])}
    self.Q[next(pair for pair in np.ndindex(self.Q.shape) if pair not in visited)] -= 1.0


# %% the largest value of the table
# says: where G is cut it goes on with the largest value of that state, and not of the whole table
# in: while
# - G = self.Q[s].max()
# + G = self.Q.max()


# %% the reward once more
# says: where G is cut the largest value alone takes its place; the next step adds its own reward
# in: while
# - G = self.Q[s].max()
# + G = self.rewards[k] + self.discount * self.Q[s].max()


# %% the last reward for all
# says: every step takes the reward of the last one: write rewards[k]
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[length - 1] + self.discount * G
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
        if self.Q[s, a] < max(self.Q[s]):
            G = max(self.Q[s])


# %% the largest value of the table, twice
# says: the largest value is that of the row of the state, and not of the whole table
# in: while
# - if self.Q[s, a] != self.Q[s].max():
# -     G = self.Q[s].max()
# + if self.Q[s, a] != self.Q.max():
# +     G = self.Q.max()


# %% a return in the loop
# says: only the last step of the episode learns: is a `return` or a `break` inside the loop?
# in: while
# - k -= 1
# + return


# %% the old value is forgotten
# says: It is the last step of the episode, where G is still 0, so look at the first two lines
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        self.Q[s, a] = self.learning_rate * G
        if self.Q[s, a] < max(self.Q[s]):
            G = max(self.Q[s])


# %% half a return
# says: The steps after it are right, and at the next one G is not cut: look at your `if`, and at γ in the first line
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
        if self.Q[s, a] < max(self.Q[s]):
            G = max(self.Q[s])
        else:
            G = (G + self.Q[s, a]) / 2


# %% a little worse is as good
# says: and at the next one G is cut
# in: while
# - if self.Q[s, a] != self.Q[s].max():
# + if self.Q[s, a] < self.Q[s].max() - 0.01:
