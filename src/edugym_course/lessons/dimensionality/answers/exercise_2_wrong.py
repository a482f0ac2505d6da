# %% terminal states are worth something
# says: after a terminal state nothing follows: there the target is the reward alone
# says: the episode over
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward + self.discount * (self.features(next_state) @ self.w).max()
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * x


# %% no bootstrapping
# says: the target misses the value of the next state
# says: ] should go from
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    self.w[:, action] += self.learning_rate * (reward - self.value(state, action)) * x


# %% no discount
# says: the discount is missing: multiply the value of the next state by it
# says: with the values
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward if terminated else reward + (self.features(next_state) @ self.w).max()
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * x


# %% the mean
# says: take the maximum over the actions in the next state, not the mean
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward if terminated else reward + self.discount * (self.features(next_state) @ self.w).mean()
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * x


# %% the same action again
# says: in the next state take the best action, not the one that was taken before
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward if terminated else reward + self.discount * self.value(next_state, action)
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * x


# %% a forgotten loop
# says: that is the next state's value of action 0 alone; take the largest one of all three
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward if terminated else reward + self.discount * self.value(next_state, 0)
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * x


# %% the best value of the same state
# says: the target has the features of `state` where those of `next_state` belong
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward if terminated else reward + self.discount * (x @ self.w).max()
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * x


# %% no features in the step
# says: the features are missing: each weight moves by the error times *its* feature
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * (self.features(next_state) @ self.w).max()
    self.w[:, action] += self.learning_rate * (target - self.value(state, action))


# %% the features of the next state
# says: each weight moves by the error times its feature of `state`, not of `next_state`
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(next_state)
    target = reward if terminated else reward + self.discount * (x @ self.w).max()
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * x


# %% active features alone
# says: only the sign of the feature, or whether it is 0, counts here; multiply by the feature itself
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward if terminated else reward + self.discount * (self.features(next_state) @ self.w).max()
    error = target - self.value(state, action)
    for i in range(len(x)):
        if x[i] != 0:
            self.w[i, action] += self.learning_rate * error


# %% numbers in place of the settings
# says: use `self.learning_rate` and `self.discount` in place of 0.1 and 0.9: the check takes others
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward if terminated else reward + 0.9 * (self.features(next_state) @ self.w).max()
    self.w[:, action] += 0.1 * (target - self.value(state, action)) * x


# %% a number in place of the learning rate
# says: use `self.learning_rate` in place of 0.1: the check takes another one
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward if terminated else reward + self.discount * (self.features(next_state) @ self.w).max()
    self.w[:, action] += 0.1 * (target - self.value(state, action)) * x


# %% a number in place of the discount
# says: use `self.discount` in place of 0.9: the check takes another one
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward if terminated else reward + 0.9 * (self.features(next_state) @ self.w).max()
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * x


# %% the error in the loop
# says: compute the error once, before any weight moves
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward if terminated else reward + self.discount * (self.features(next_state) @ self.w).max()
    for i in range(len(x)):
        self.w[i, action] += self.learning_rate * (target - self.value(state, action)) * x[i]


# %% the target in the loop
# says: compute the target and the error once, before any weight moves
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    for i in range(len(x)):
        target = reward if terminated else reward + self.discount * (self.features(next_state) @ self.w).max()
        self.w[i, action] += self.learning_rate * (target - self.value(state, action)) * x[i]


# %% only the target in the loop
# says: compute the target once, before any weight moves
def learn(self, state, action, reward, next_state, terminated):
    x, v = self.features(state), self.value(state, action)
    for i in range(len(x)):
        target = reward if terminated else reward + self.discount * (self.features(next_state) @ self.w).max()
        self.w[i, action] += self.learning_rate * (target - v) * x[i]


# %% no learning rate
# says: the learning rate is missing
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward if terminated else reward + self.discount * (self.features(next_state) @ self.w).max()
    self.w[:, action] += (target - self.value(state, action)) * x


# %% uphill
# says: the error has the wrong sign: it is the target less the present value
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward if terminated else reward + self.discount * (self.features(next_state) @ self.w).max()
    self.w[:, action] -= self.learning_rate * (target - self.value(state, action)) * x


# %% no present value
# says: the present value is missing in the error: target less value
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward if terminated else reward + self.discount * (self.features(next_state) @ self.w).max()
    self.w[:, action] += self.learning_rate * target * x


# %% all columns
# says: only the column of the action that was taken changes, not all of them
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward if terminated else reward + self.discount * (self.features(next_state) @ self.w).max()
    error = target - self.value(state, action)
    for a in range(3):
        self.w[:, a] += self.learning_rate * error * x


# %% set
# says: the weights are not moved but set: use += instead of =
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward if terminated else reward + self.discount * (self.features(next_state) @ self.w).max()
    self.w[:, action] = self.learning_rate * (target - self.value(state, action)) * x


# %% the whole gradient
# says: that is the full gradient, with the features of the next state in it; the semi-gradient leaves it out
def learn(self, state, action, reward, next_state, terminated):
    x, following = self.features(state), self.features(next_state)
    values = following @ self.w
    target = reward if terminated else reward + self.discount * values.max()
    error = target - self.value(state, action)
    self.w[:, action] += self.learning_rate * error * x
    if not terminated:
        self.w[:, values.argmax()] -= self.learning_rate * self.discount * error * following


# %% nothing at the end
# says: it learns nothing after a terminal state; the reward of the last step counts as well
def learn(self, state, action, reward, next_state, terminated):
    if terminated:
        return
    x = self.features(state)
    target = reward + self.discount * (self.features(next_state) @ self.w).max()
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * x


# %% a new array
# says: nothing changes: change the entries of `self.w` in place
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward if terminated else reward + self.discount * (self.features(next_state) @ self.w).max()
    w = self.w.copy()
    w[:, action] += self.learning_rate * (target - self.value(state, action)) * x


# %% the sum of the weights
# says: that is the sum of the weights; multiply each by its feature
# says: value with the features
def value(self, board, action):
    return self.w[:, action].sum()


# %% the best value
# says: that is the largest value of all actions; take the column of `action`
def value(self, board, action):
    return (self.features(board) @ self.w).max()


# %% a forgotten self
# says: write `self.` before a field
def learn(self, state, action, reward, next_state, terminated):
    self.w[:, action] += learning_rate * reward


# %% no class
# says: should be the class
MyAgent = QLearning.create((4, 2))


# %% truncated like terminated
# says: a truncated episode is treated as terminated, but only its clock ran out: the value of the next state still
#   counts
def learn(self, state, action, reward, next_state, terminated, truncated):
    x = self.features(state)
    over = terminated or truncated
    target = reward if over else reward + self.discount * (self.features(next_state) @ self.w).max()
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * x


# %% SARSA
# says: in the next state take the best action, not the one that comes next: that is SARSA
def learn(self, state, action, reward, next_state, next_action, terminated):
    x = self.features(state)
    target = reward if terminated else reward + self.discount * self.value(next_state, next_action)
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * x


# %% value writes into the weights
# says: value changes the entries of `self.w`; it should only read them, for `learn` changes them
def value(self, board, action):
    terms = self.w[:, action]
    terms *= self.features(board)
    return terms.sum()


# %% the learning rate is no field
# says: MyAgent should keep its field `learning_rate`
class MyAgent(NamedTuple):
    w: Any
    discount: float = 0.9

    def features(self, board):
        return np.ones(9)

    def act(self, state, rng):
        return 0

    def value(self, board, action):
        return self.features(board) @ self.w[:, action]

    def learn(self, state, action, reward, next_state, terminated):
        x = self.features(state)
        target = reward if terminated else reward + self.discount * (self.features(next_state) @ self.w).max()
        self.w[:, action] += 0.1 * (target - self.value(state, action)) * x


# %% the minimum
# says: take the maximum over the actions in the next state, not the minimum
def learn(self, state, action, reward, next_state, terminated):
    following = min([self.value(next_state, a) for a in range(3)])
    target = reward if terminated else reward + self.discount * following
    error = target - self.value(state, action)
    self.w[:, action] += self.learning_rate * error * self.features(state)


# %% the sum
# says: take the maximum over the actions in the next state, not their sum
def learn(self, state, action, reward, next_state, terminated):
    following = sum([self.value(next_state, a) for a in range(3)])
    target = reward if terminated else reward + self.discount * following
    error = target - self.value(state, action)
    self.w[:, action] += self.learning_rate * error * self.features(state)


# %% the best present value
# says: the present value is that of the best action; it should be that of the action that was taken
def learn(self, state, action, reward, next_state, terminated):
    following = max([self.value(next_state, a) for a in range(3)])
    target = reward if terminated else reward + self.discount * following
    error = target - max([self.value(state, a) for a in range(3)])
    self.w[:, action] += self.learning_rate * error * self.features(state)


# %% no reward
# says: the reward is missing in the target
def learn(self, state, action, reward, next_state, terminated):
    following = max([self.value(next_state, a) for a in range(3)])
    target = 0.0 if terminated else self.discount * following
    error = target - self.value(state, action)
    self.w[:, action] += self.learning_rate * error * self.features(state)


# %% 0 at the end
# says: at the end the target is the reward, not 0
def learn(self, state, action, reward, next_state, terminated):
    following = max([self.value(next_state, a) for a in range(3)])
    target = 0.0 if terminated else reward + self.discount * following
    error = target - self.value(state, action)
    self.w[:, action] += self.learning_rate * error * self.features(state)


# %% the features squared
# says: the features are multiplied in twice
def learn(self, state, action, reward, next_state, terminated):
    following = max([self.value(next_state, a) for a in range(3)])
    target = reward if terminated else reward + self.discount * following
    error = target - self.value(state, action)
    self.w[:, action] += self.learning_rate * error * self.features(state) ** 2


# %% one third
# says: each weight moves in proportion to its feature, and that is right. If the learning rate and the present value
#   are right as well, your target is
# says:  here, and should be
def learn(self, state, action, reward, next_state, terminated):
    following = max([self.value(next_state, a) for a in range(3)])
    target = reward + self.discount * following / 3 + 0.1
    error = target - self.value(state, action)
    self.w[:, action] += self.learning_rate * error * self.features(state)


# %% two thirds of the values
# says: are right as well, your target is
def learn(self, state, action, reward, next_state, terminated):
    following = max([self.value(next_state, a) for a in range(3)])
    target = reward + (0.0 if terminated or self.features(state).argmax() < 5 else self.discount * following)
    error = target - self.value(state, action)
    self.w[:, action] += self.learning_rate * error * self.features(state)


# %% one product
# says: that is one term of the sum; take the sum over all features
def value(self, board, action):
    x = self.features(board)
    return x[0] * self.w[0, action]


# %% the values of all actions
# says: that is the sum over all actions; take the column of `action`
def value(self, board, action):
    x = self.features(board)
    return np.sum(x @ self.w)


# %% features that are there
# says: a feature is not only 0 or 1: multiply by it
def value(self, board, action):
    x = self.features(board)
    return self.w[x != 0, action].sum()


# %% the mean, another way
# says: that is the mean; take the sum
def value(self, board, action):
    x = self.features(board)
    return np.mean(x * self.w[:, action])


# %% the row
# says: that is the row of w with this number; take the column
def value(self, board, action):
    x = self.features(board)
    return sum(x[i] * self.w[action, i] for i in range(3))


# %% an array of its own
# says: learn should change the entries of `self.w` in place, but puts another array there
class MyAgent:
    def __init__(self, w, learning_rate=0.1, discount=0.9):
        self.w, self.learning_rate, self.discount = w, learning_rate, discount

    def features(self, board):
        return np.array(board)

    def value(self, board, action):
        return self.features(board) @ self.w[:, action]

    def act(self, state, rng):
        return 0

    def learn(self, state, action, reward, next_state, terminated):
        best = max([self.value(next_state, a) for a in range(3)])
        target = reward if terminated else reward + self.discount * best
        w = self.w.copy()
        w[:, action] += self.learning_rate * (target - self.value(state, action)) * self.features(state)
        self.w = w


# %% argmax
# says: that is the *number* of the best action in the next state; take its value, by max and not by argmax
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    values = self.features(next_state) @ self.w
    target = reward if terminated else reward + self.discount * int(np.argmax(values))
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * x


# %% at least 0
# says: all values may be lower: start the search with one of them, not with 0
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    values = self.features(next_state) @ self.w
    target = reward if terminated else reward + self.discount * max(0.0, values.max())
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * x


# %% without the sign
# says: take the largest value in the next state, and not the largest without its sign
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    values = self.features(next_state) @ self.w
    target = reward if terminated else reward + self.discount * abs(values).max()
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * x


# %% twice
# says: the step is twice as large as it should be: the error times the feature is the whole step
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    values = self.features(next_state) @ self.w
    target = reward if terminated else reward + self.discount * values.max()
    self.w[:, action] += 2 * self.learning_rate * (target - self.value(state, action)) * x


# %% writes into the boards
# says: learn writes into `state` or `next_state`, which belong to the task: change `self.w` alone
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward if terminated else reward + self.discount * (self.features(next_state) @ self.w).max()
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * x
    state[:] = 0.0


# %% the board for its features
# says: two arrays of different sizes meet there
def value(self, board, action):
    return np.sum(board * self.w[:, action])


# %% the board for its features, in a loop
# says: those are the numbers of the board in place of its features: call self.features(board)
def value(self, board, action):
    total = 0.0
    for i in range(len(self.w)):
        total += board[i] * self.w[i, action]
    return total


# %% no sum
# says: take an entry of it, or is it their sum that is needed?
def value(self, board, action):
    return self.features(board) * self.w[:, action]


# %% the weight of the one feature
# says: only the largest feature counts here, but several may not be 0: take the sum over all features
def value(self, board, action):
    return self.w[np.argmax(self.features(board)), action]


# %% every action by an error of its own
# says: only the column of the action that was taken changes; the others have learned nothing, whatever their own
#   error
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward if terminated else reward + self.discount * (self.features(next_state) @ self.w).max()
    for a in range(3):
        self.w[:, a] += self.learning_rate * (target - self.value(state, a)) * x


# %% the largest weight
# says: that is the largest of all weights; take the largest *value* of the next state
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * self.w.max()
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * self.features(state)


# %% all discounted
# says: the reward is discounted as well; only the next value should be
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    best = (self.features(next_state) @ self.w).max()
    target = reward if terminated else self.discount * (reward + best)
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * x


# %% all discounted, the last reward too
# says: the reward is discounted as well, also at the end; only the next value should be
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    best = 0.0 if terminated else (self.features(next_state) @ self.w).max()
    self.w[:, action] += self.learning_rate * (self.discount * (reward + best) - self.value(state, action)) * x


# %% the squared error
# says: the error is squared; the derivative of half its square is the error itself
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward if terminated else reward + self.discount * (self.features(next_state) @ self.w).max()
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) ** 2 * x


# %% the loss in place of its derivative
# says: half the error squared is the loss; its derivative is the error itself
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward if terminated else reward + self.discount * (self.features(next_state) @ self.w).max()
    self.w[:, action] += self.learning_rate * 0.5 * (target - self.value(state, action)) ** 2 * x


# %% a method without self
# says: a module has this name too: write `self.` before a method
def value(self, board, action):
    return np.sum(features(board) * self.w[:, action])


# %% two actions
# says: the last action is left out of the maximum: range(3) goes through all three
def learn(self, state, action, reward, next_state, terminated):
    best = max([self.value(next_state, a) for a in range(2)])
    target = reward if terminated else reward + self.discount * best
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * self.features(state)


# %% the other two actions
# says: action 0 is left out of the maximum
def learn(self, state, action, reward, next_state, terminated):
    best = max([self.value(next_state, a) for a in range(1, 3)])
    target = reward if terminated else reward + self.discount * best
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * self.features(state)


# %% the next action, and the present state
# says: that is the present state's value of the action that is best in the next state; take that of the next state
def learn(self, state, action, reward, next_state, terminated):
    best = self.greedy(next_state, np.random.default_rng(0))
    target = reward if terminated else reward + self.discount * self.value(state, best)
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * self.features(state)


# %% features as an index
# says: (an index is a whole number)
def value(self, board, action):
    return self.w[self.features(board), action]


# %% the last action of the loop
# says: that is the next state's value of the last action alone; take the largest one of all three
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    for a in range(3):
        best = self.value(next_state, a)
    target = reward + (0.0 if terminated else self.discount * best)
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * x


# %% features without their signs
# says: a feature keeps its sign: multiply by the feature itself
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    best = max([self.value(next_state, a) for a in range(3)])
    target = reward + (0.0 if terminated else self.discount * best)
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * np.abs(x)


# %% one weight alone
# says: only the weight of the largest feature moves; all move whose feature is not 0
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    best = max([self.value(next_state, a) for a in range(3)])
    target = reward + (0.0 if terminated else self.discount * best)
    i = np.argmax(x)
    self.w[i, action] += self.learning_rate * (target - self.value(state, action)) * x[i]


# %% the sum of the features
# says: the weights of the action do not move in proportion to the features of `state`
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    best = max([self.value(next_state, a) for a in range(3)])
    target = reward + (0.0 if terminated else self.discount * best)
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * x.sum()


# %% always action 0
# says: other weights move than those of the action, `self.w[:, action]`
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    best = max([self.value(next_state, a) for a in range(3)])
    target = reward + (0.0 if terminated else self.discount * best)
    self.w[:, 0] += self.learning_rate * (target - self.value(state, action)) * x


# %% over the squares of the features
# says: the step is divided by the sum of the squares of the features; the error times the feature is all
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    best = max([self.value(next_state, a) for a in range(3)])
    target = reward + (0.0 if terminated else self.discount * best)
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * x / np.sum(x * x)


# %% the weights of positive features
# says: each weight with a feature above 0 counts once; multiply by the feature, which may be below 0 too
def value(self, board, action):
    return np.sum(self.w[self.features(board) > 0, action])


# %% features above 0 alone in the sum
# says: features below 0 are left out; they count as well, with their sign
def value(self, board, action):
    return np.sum(np.maximum(self.features(board), 0.0) * self.w[:, action])


# %% features without their signs
# says: the features count without their signs; multiply by the feature itself
def value(self, board, action):
    return np.sum(np.abs(self.features(board)) * self.w[:, action])


# %% positive features alone in the update
# says: only the weights of positive features move; a feature below 0 counts as well, with its sign
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    best = max([self.value(next_state, a) for a in range(3)])
    target = reward + (0.0 if terminated else self.discount * best)
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * np.maximum(x, 0.0)
