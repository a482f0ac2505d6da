# ruff: noqa
# Right and wrong answers to the exercises of lesson 4; tests/lessons/test_answers.py tries them all.
# An answer stands in the place of the exercise's cell. Methods without their class replace those of the solution.

# %% setup
import math
from edugym.agents.tables import one_step_target


# %% exercise 1, right: a dictionary
# says: Right: for the image of 10 by 5 cells that is a number with 362 digits.
def table_entries(rows, columns, kind):
    return (
        3
        * {
            "vectorised": columns * rows * columns,
            "grid": 2 ** (rows * columns),
            "rgb": 256 ** (rows * columns * 3),
        }[kind]
    )


# %% exercise 1, right: through exponents of two
def table_entries(rows, columns, kind):
    if kind == "grid":
        return 3 * (1 << (rows * columns))
    if kind == "rgb":
        return 3 * (1 << (8 * 3 * rows * columns))
    return 3 * rows * columns**2


# %% exercise 1, right: math.prod
def table_entries(rows, columns, kind):
    values = {
        "vectorised": [columns, rows, columns],
        "grid": [2] * (rows * columns),
        "rgb": [256] * (3 * rows * columns),
    }
    return math.prod(values[kind]) * 3


# %% exercise 1, right: by the spaces
def table_entries(rows, columns, kind):
    from edugym.envs.catch import Catch

    space = Catch.create(rows, columns, kind).observation_space
    if kind == "vectorised":
        return int(np.prod(space.nvec)) * 3
    levels = int(space.high.max()) + 1
    return levels ** math.prod(space.shape) * 3


# %% exercise 1, right: floats
def table_entries(rows, columns, kind):
    cells = rows * columns
    if kind == "vectorised":
        return 3.0 * cells * columns
    base, exponent = (2.0, cells) if kind == "grid" else (256.0, 3 * cells)
    return 3 * base**exponent


# %% exercise 1, right: a loop
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns * columns * 3
    entries = 3
    for _ in range(rows * columns):
        entries *= 2 if kind == "grid" else 256**3
    return entries


# %% exercise 1, right: a match
def table_entries(rows, columns, kind):
    match kind:
        case "vectorised":
            n = columns * columns * rows
        case "grid":
            n = pow(2, rows * columns)
        case _:
            n = pow(256, 3 * rows * columns)
    return n + n + n


# %% exercise 1, wrong: no return
# says: is a `return` missing?
def table_entries(rows, columns, kind):
    entries = 3 * 2 ** (rows * columns)


# %% exercise 1, wrong: rows alone
# says: that is the number of rows; each of them holds a number for each of the three actions
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return columns * rows * columns
    return 2 ** (rows * columns) if kind == "grid" else 256 ** (rows * columns * 3)


# %% exercise 1, wrong: no paddle
# says: the paddle's column is missing: the agent sees it too
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns * 3
    return 3 * (2 ** (rows * columns) if kind == "grid" else 256 ** (rows * columns * 3))


# %% exercise 1, wrong: a row for the paddle
# says: the paddle stays in its row, and so it has no row of its own in the observation
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns * rows * columns * 3
    return 3 * (2 ** (rows * columns) if kind == "grid" else 256 ** (rows * columns * 3))


# %% exercise 1, wrong: the paper's slip
# says: the ball has a column of its own, with as many values as there are columns
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * rows * columns * 3
    return 3 * (2 ** (rows * columns) if kind == "grid" else 256 ** (rows * columns * 3))


# %% exercise 1, wrong: added
# says: the numbers of values are multiplied, not added
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return (rows + columns + columns) * 3
    return 3 * (2 ** (rows * columns) if kind == "grid" else 256 ** (rows * columns * 3))


# %% exercise 1, wrong: base and exponent
# says: base and exponent have changed places: each of the pixels has 2 values
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return 3 * ((rows * columns) ** 2 if kind == "grid" else 256 ** (rows * columns * 3))


# %% exercise 1, wrong: base and exponent of the image
# says: base and exponent have changed places
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return 2 ** (rows * columns) * 3 if kind == "grid" else (3 * rows * columns) ** 256 * 3


# %% exercise 1, wrong: colours as a power
# says: three colours: the exponent is 3 times the number of cells, not the number of cells to the power of 3
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return 2 ** (rows * columns) * 3 if kind == "grid" else 256 ** (rows * columns) ** 3 * 3


# %% exercise 1, wrong: a product
# says: the values of the pixels multiply: take 2 to the power of the number of pixels
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return 3 * (2 * rows * columns if kind == "grid" else 256 ** (rows * columns * 3))


# %% exercise 1, wrong: what occurs
# says: those are the boards with one ball and one paddle; a dense table has a row for every board that could be written
#   down
def table_entries(rows, columns, kind):
    return rows * columns**2 * 3


# %% exercise 1, wrong: one number a cell
# says: each cell has three numbers: red, green and blue
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return 3 * (2 if kind == "grid" else 256) ** (rows * columns)


# %% exercise 1, wrong: 255 values
# says: from 0 to 255 there are 256 values
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return 3 * (2 ** (rows * columns) if kind == "grid" else 255 ** (rows * columns * 3))


# %% exercise 1, wrong: a binary image
# says: a number of the image has 256 values, not 2
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return 3 * 2 ** (rows * columns * (1 if kind == "grid" else 3))


# %% exercise 1, wrong: the image is the grid
# says: that is the grid; the image has three numbers for each cell, with 256 values
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return 3 * 2 ** (rows * columns)


# %% exercise 1, wrong: actions in the exponent
# says: multiply by the number of actions; do not take the power
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return 2 ** (rows * columns * 3) if kind == "grid" else 256 ** (rows * columns * 3) * 3


# %% exercise 1, wrong: actions added in the exponent
# says: multiply by 3 at the end, outside of the power
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return 2 ** (rows * columns + 3) if kind == "grid" else 256 ** (rows * columns * 3) * 3


# %% exercise 1, wrong: one power for all numbers
# says: each number has its own number of values, so multiply these: there is no power here
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return 3 * 3 ** (rows * columns)
    return 3 * (2 ** (rows * columns) if kind == "grid" else 256 ** (rows * columns * 3))


# %% exercise 1, wrong: the grid for the numbers
# says: that is the formula for the grid
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return 2 ** (rows * columns) * 3
    return 3 * (2 ** (rows * columns) if kind == "grid" else 256 ** (rows * columns * 3))


# %% exercise 1, wrong: the power of the actions
# says: a row has an entry for each action, so multiply by 3; no power is taken
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return (rows * columns**2) ** 3
    return 3 * (2 ** (rows * columns) if kind == "grid" else 256 ** (rows * columns * 3))


# %% exercise 1, wrong: without the last row
# says: the last row belongs to the observations that could be written down, too
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return (rows - 1) * columns**2 * 3
    return 3 * (2 ** (rows * columns) if kind == "grid" else 256 ** (rows * columns * 3))


# %% exercise 1, wrong: pixels times actions
# says: that is the number of pixels times the actions
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return rows * columns * 3 if kind == "grid" else 256 ** (rows * columns * 3) * 3


# %% exercise 1, wrong: 256 values in the grid
# says: each pixel has 2 values here, not 256
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return 256 ** (rows * columns) * 3 if kind == "grid" else 256 ** (rows * columns * 3) * 3


# %% exercise 1, wrong: 3 values in the grid
# says: a pixel of the grid is 0 or 1, and that is all: there are 2 values, not 3
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return 3 ** (rows * columns) * 3 if kind == "grid" else 256 ** (rows * columns * 3) * 3


# %% exercise 1, wrong: three numbers for a cell
# says: the grid has one number for each cell, not three
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return 2 ** (rows * columns * 3) * 3 if kind == "grid" else 256 ** (rows * columns * 3) * 3


# %% exercise 1, wrong: the sum of the sides
# says: the number of pixels is rows times columns, not their sum
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return 2 ** (rows + columns) * 3 if kind == "grid" else 256 ** (rows * columns * 3) * 3


# %% exercise 1, wrong: a product for the image
# says: the values of the numbers multiply: take a power
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return 2 ** (rows * columns) * 3 if kind == "grid" else 256 * rows * columns * 3 * 3


# %% exercise 1, wrong: what occurs in the image
# says: those are the boards with one ball and one paddle; a dense table has a row for every image that could be written
#   down
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return 2 ** (rows * columns) * 3 if kind == "grid" else rows * columns**2 * 3


# %% exercise 1, wrong: colours outside of the exponent
# says: the three colours are in the exponent
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return 2 ** (rows * columns) * 3 if kind == "grid" else 256 ** (rows * columns) * 3 * 3


# %% exercise 1, wrong: a floating overflow
# says: raises OverflowError
def table_entries(rows, columns, kind):
    return float(10) ** 400


# %% exercise 1, wrong: whole numbers of NumPy
# says: NumPy's whole numbers overflow here; use Python's `**`
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return np.prod(np.full(rows * columns * (1 if kind == "grid" else 3), 2 if kind == "grid" else 256)) * 3


# %% exercise 1, wrong: the default board
# says: should be
# says: that is none of the usual mistakes, so work it out by hand for a small board
def table_entries(rows, columns, kind):
    return {"vectorised": 750, "grid": 3 * 2**50, "rgb": 3 * 256**150}[kind]


# %% exercise 1, wrong: a number
# says: should be a function
# says: rows, columns and kind
table_entries = 3 * 2**50


# %% exercise 1, wrong: counted from 0
# says: positions count from 0, but there are still `rows` of them, and `columns`
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return (rows - 1) * (columns - 1) ** 2 * 3
    return {"grid": 2, "rgb": 256**3}[kind] ** (rows * columns) * 3


# %% exercise 2, right: a dot product
# says: Right: the error times the features. See it catch:
def value(self, board, action):
    return self.features(board) @ self.w[:, action]


def learn(self, state, action, reward, next_state, terminated):
    target = reward
    if not terminated:
        target = reward + self.discount * max(
            [self.value(next_state, 0), self.value(next_state, 1), self.value(next_state, 2)]
        )
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * self.features(state)


# %% exercise 2, right: loops
def value(self, board, action):
    x = self.features(board)
    total = 0.0
    for i in range(len(x)):
        total += x[i] * self.w[i, action]
    return total


def learn(self, state, action, reward, next_state, terminated):
    best = -math.inf
    for a in range(3):
        best = max(best, self.value(next_state, a))
    if terminated:
        best = 0.0
    error = reward + self.discount * best - self.value(state, action)
    x = self.features(state)
    for i in range(len(x)):
        self.w[i, action] += self.learning_rate * error * x[i]


# %% exercise 2, right: all values at once
def learn(self, state, action, reward, next_state, terminated):
    following = (self.features(next_state) @ self.w).max()
    y = reward + self.discount * (1 - terminated) * following
    x = self.features(state)
    delta = y - x @ self.w[:, action]
    self.w[:, action] = self.w[:, action] + self.learning_rate * delta * x


# %% exercise 2, right: an early return
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    present = self.value(state, action)
    if terminated:
        self.w[:, action] += self.learning_rate * (reward - present) * x
        return
    best = np.max(np.array([self.value(next_state, a) for a in range(3)]))
    self.w[:, action] += self.learning_rate * (reward + self.discount * best - present) * x


# %% exercise 2, right: an outer product
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    chosen = np.zeros(3)
    chosen[action] = 1.0
    best = 0.0 if terminated else max(self.features(next_state) @ self.w)
    error = reward + self.discount * best - x @ self.w @ chosen
    self.w[:] += self.learning_rate * error * np.outer(x, chosen)


# %% exercise 2, right: np.dot
def value(self, board, action):
    return float(np.dot(self.w[:, action], self.features(board)))


# %% exercise 2, right: only active features
def learn(self, state, action, reward, next_state, terminated):
    q = np.zeros(3)
    if not terminated:
        for a in range(3):
            q[a] = self.value(next_state, a)
    error = reward + self.discount * np.max(q) * (not terminated) - self.value(state, action)
    x = self.features(state)
    for i in np.flatnonzero(x):
        self.w[i, action] += self.learning_rate * error * x[i]


# %% exercise 2, right: parameters in another order
def learn(self, action, state, next_state, reward, terminated):
    x = self.features(state)
    target = reward if terminated else reward + self.discount * (self.features(next_state) @ self.w).max()
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * x


# %% exercise 2, right: truncated is taken and not used
def learn(self, state, action, reward, next_state, terminated, truncated):
    x = self.features(state)
    target = reward if terminated else reward + self.discount * (self.features(next_state) @ self.w).max()
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * x


# %% exercise 2, wrong: terminal states are worth something
# says: after a terminal state nothing follows: there the target is the reward alone
# says: the episode over
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward + self.discount * (self.features(next_state) @ self.w).max()
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * x


# %% exercise 2, wrong: no bootstrapping
# says: the target misses the value of the next state
# says: ] should go from
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    self.w[:, action] += self.learning_rate * (reward - self.value(state, action)) * x


# %% exercise 2, wrong: no discount
# says: the discount is missing: multiply the value of the next state by it
# says: with the values
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward if terminated else reward + (self.features(next_state) @ self.w).max()
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * x


# %% exercise 2, wrong: the mean
# says: take the maximum over the actions in the next state, not the mean
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward if terminated else reward + self.discount * (self.features(next_state) @ self.w).mean()
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * x


# %% exercise 2, wrong: the same action again
# says: in the next state take the best action, not the one that was taken before
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward if terminated else reward + self.discount * self.value(next_state, action)
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * x


# %% exercise 2, wrong: a forgotten loop
# says: that is the next state's value of action 0 alone; take the largest one of all three
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward if terminated else reward + self.discount * self.value(next_state, 0)
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * x


# %% exercise 2, wrong: the best value of the same state
# says: the target has the features of `state` where those of `next_state` belong
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward if terminated else reward + self.discount * (x @ self.w).max()
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * x


# %% exercise 2, wrong: no features in the step
# says: the features are missing: each weight moves by the error times *its* feature
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * (self.features(next_state) @ self.w).max()
    self.w[:, action] += self.learning_rate * (target - self.value(state, action))


# %% exercise 2, wrong: the features of the next state
# says: each weight moves by the error times its feature of `state`, not of `next_state`
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(next_state)
    target = reward if terminated else reward + self.discount * (x @ self.w).max()
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * x


# %% exercise 2, wrong: active features alone
# says: only the sign of the feature, or whether it is 0, counts here; multiply by the feature itself
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward if terminated else reward + self.discount * (self.features(next_state) @ self.w).max()
    error = target - self.value(state, action)
    for i in range(len(x)):
        if x[i] != 0:
            self.w[i, action] += self.learning_rate * error


# %% exercise 2, wrong: numbers in place of the settings
# says: use `self.learning_rate` and `self.discount` in place of 0.1 and 0.9: the check takes others
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward if terminated else reward + 0.9 * (self.features(next_state) @ self.w).max()
    self.w[:, action] += 0.1 * (target - self.value(state, action)) * x


# %% exercise 2, wrong: a number in place of the learning rate
# says: use `self.learning_rate` in place of 0.1: the check takes another one
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward if terminated else reward + self.discount * (self.features(next_state) @ self.w).max()
    self.w[:, action] += 0.1 * (target - self.value(state, action)) * x


# %% exercise 2, wrong: a number in place of the discount
# says: use `self.discount` in place of 0.9: the check takes another one
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward if terminated else reward + 0.9 * (self.features(next_state) @ self.w).max()
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * x


# %% exercise 2, wrong: the error in the loop
# says: compute the error once, before any weight moves
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward if terminated else reward + self.discount * (self.features(next_state) @ self.w).max()
    for i in range(len(x)):
        self.w[i, action] += self.learning_rate * (target - self.value(state, action)) * x[i]


# %% exercise 2, wrong: the target in the loop
# says: compute the target and the error once, before any weight moves
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    for i in range(len(x)):
        target = reward if terminated else reward + self.discount * (self.features(next_state) @ self.w).max()
        self.w[i, action] += self.learning_rate * (target - self.value(state, action)) * x[i]


# %% exercise 2, wrong: no learning rate
# says: the learning rate is missing
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward if terminated else reward + self.discount * (self.features(next_state) @ self.w).max()
    self.w[:, action] += (target - self.value(state, action)) * x


# %% exercise 2, wrong: uphill
# says: the error has the wrong sign: it is the target less the present value
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward if terminated else reward + self.discount * (self.features(next_state) @ self.w).max()
    self.w[:, action] -= self.learning_rate * (target - self.value(state, action)) * x


# %% exercise 2, wrong: no present value
# says: the present value is missing in the error: target less value
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward if terminated else reward + self.discount * (self.features(next_state) @ self.w).max()
    self.w[:, action] += self.learning_rate * target * x


# %% exercise 2, wrong: all columns
# says: only the column of the action that was taken changes, not all of them
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward if terminated else reward + self.discount * (self.features(next_state) @ self.w).max()
    error = target - self.value(state, action)
    for a in range(3):
        self.w[:, a] += self.learning_rate * error * x


# %% exercise 2, wrong: set
# says: the weights are not moved but set: use += instead of =
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward if terminated else reward + self.discount * (self.features(next_state) @ self.w).max()
    self.w[:, action] = self.learning_rate * (target - self.value(state, action)) * x


# %% exercise 2, wrong: the whole gradient
# says: that is the full gradient, with the features of the next state in it; the semi-gradient leaves it out
def learn(self, state, action, reward, next_state, terminated):
    x, following = self.features(state), self.features(next_state)
    values = following @ self.w
    target = reward if terminated else reward + self.discount * values.max()
    error = target - self.value(state, action)
    self.w[:, action] += self.learning_rate * error * x
    if not terminated:
        self.w[:, values.argmax()] -= self.learning_rate * self.discount * error * following


# %% exercise 2, wrong: nothing at the end
# says: it learns nothing after a terminal state; the reward of the last step counts as well
def learn(self, state, action, reward, next_state, terminated):
    if terminated:
        return
    x = self.features(state)
    target = reward + self.discount * (self.features(next_state) @ self.w).max()
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * x


# %% exercise 2, wrong: a new array
# says: nothing changes: change the entries of `self.w` in place
def learn(self, state, action, reward, next_state, terminated):
    x = self.features(state)
    target = reward if terminated else reward + self.discount * (self.features(next_state) @ self.w).max()
    w = self.w.copy()
    w[:, action] += self.learning_rate * (target - self.value(state, action)) * x


# %% exercise 2, wrong: a new field
# says: change the entries of its arrays instead
def learn(self, state, action, reward, next_state, terminated):
    self.w = self.w + self.learning_rate


# %% exercise 2, wrong: the sum of the weights
# says: that is the sum of the weights; multiply each by its feature
# says: value with the features
def value(self, board, action):
    return self.w[:, action].sum()


# %% exercise 2, wrong: the best value
# says: that is the largest value of all actions; take the column of `action`
def value(self, board, action):
    return (self.features(board) @ self.w).max()


# %% exercise 2, wrong: all values
# says: should be one number
def value(self, board, action):
    return self.features(board) @ self.w


# %% exercise 2, wrong: a product without a sum
# says: should be one number
def value(self, board, action):
    return self.features(board) * self.w[:, action]


# %% exercise 2, wrong: a forgotten self
# says: write `self.` before a field
def learn(self, state, action, reward, next_state, terminated):
    self.w[:, action] += learning_rate * reward


# %% exercise 2, wrong: no class
# says: should be the class
MyAgent = QLearning.create((4, 2))


# %% exercise 2, wrong: truncated like terminated
# says: a truncated episode is treated as terminated, but only its clock ran out: the value of the next state still
#   counts
def learn(self, state, action, reward, next_state, terminated, truncated):
    x = self.features(state)
    over = terminated or truncated
    target = reward if over else reward + self.discount * (self.features(next_state) @ self.w).max()
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * x


# %% exercise 2, wrong: SARSA
# says: in the next state take the best action, not the one that comes next: that is SARSA
def learn(self, state, action, reward, next_state, next_action, terminated):
    x = self.features(state)
    target = reward if terminated else reward + self.discount * self.value(next_state, next_action)
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * x


# %% exercise 2, wrong: done
# says: is 'terminated' meant?
def learn(self, state, action, reward, next_state, done):
    self.w[:, action] += self.learning_rate * reward


# %% exercise 2, wrong: value writes into the weights
# says: value changes the entries of `self.w`; it should only read them, for `learn` changes them
def value(self, board, action):
    terms = self.w[:, action]
    terms *= self.features(board)
    return terms.sum()


# %% exercise 2, wrong: nine features written in
# says: two arrays of different sizes
def learn(self, state, action, reward, next_state, terminated):
    x = np.zeros(9)
    x[4] = 1.0
    target = reward if terminated else reward + self.discount * max(self.value(next_state, a) for a in range(3))
    self.w[:, action] += self.learning_rate * (target - self.value(state, action)) * x


# %% exercise 2, wrong: the learning rate is no field
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


# %% exercise 2, wrong: the minimum
# says: take the maximum over the actions in the next state, not the minimum
def learn(self, state, action, reward, next_state, terminated):
    following = min([self.value(next_state, a) for a in range(3)])
    target = reward if terminated else reward + self.discount * following
    error = target - self.value(state, action)
    self.w[:, action] += self.learning_rate * error * self.features(state)


# %% exercise 2, wrong: the sum
# says: take the maximum over the actions in the next state, not their sum
def learn(self, state, action, reward, next_state, terminated):
    following = sum([self.value(next_state, a) for a in range(3)])
    target = reward if terminated else reward + self.discount * following
    error = target - self.value(state, action)
    self.w[:, action] += self.learning_rate * error * self.features(state)


# %% exercise 2, wrong: the best present value
# says: the present value is that of the best action; it should be that of the action that was taken
def learn(self, state, action, reward, next_state, terminated):
    following = max([self.value(next_state, a) for a in range(3)])
    target = reward if terminated else reward + self.discount * following
    error = target - max([self.value(state, a) for a in range(3)])
    self.w[:, action] += self.learning_rate * error * self.features(state)


# %% exercise 2, wrong: no reward
# says: the reward is missing in the target
def learn(self, state, action, reward, next_state, terminated):
    following = max([self.value(next_state, a) for a in range(3)])
    target = 0.0 if terminated else self.discount * following
    error = target - self.value(state, action)
    self.w[:, action] += self.learning_rate * error * self.features(state)


# %% exercise 2, wrong: 0 at the end
# says: at the end the target is the reward, not 0
def learn(self, state, action, reward, next_state, terminated):
    following = max([self.value(next_state, a) for a in range(3)])
    target = 0.0 if terminated else reward + self.discount * following
    error = target - self.value(state, action)
    self.w[:, action] += self.learning_rate * error * self.features(state)


# %% exercise 2, wrong: the features squared
# says: the features are multiplied in twice
def learn(self, state, action, reward, next_state, terminated):
    following = max([self.value(next_state, a) for a in range(3)])
    target = reward if terminated else reward + self.discount * following
    error = target - self.value(state, action)
    self.w[:, action] += self.learning_rate * error * self.features(state) ** 2


# %% exercise 2, wrong: one third
# says: that is none of the usual mistakes, so compare your code with the equation, term by term
def learn(self, state, action, reward, next_state, terminated):
    following = max([self.value(next_state, a) for a in range(3)])
    target = reward + self.discount * following / 3 + 0.1
    error = target - self.value(state, action)
    self.w[:, action] += self.learning_rate * error * self.features(state)


# %% exercise 2, wrong: two thirds of the values
# says: in this case it looks like this:
def learn(self, state, action, reward, next_state, terminated):
    following = max([self.value(next_state, a) for a in range(3)])
    target = reward + (0.0 if terminated or state[0] > 0 else self.discount * following)
    error = target - self.value(state, action)
    self.w[:, action] += self.learning_rate * error * self.features(state)


# %% exercise 2, wrong: one product
# says: that is one term of the sum; take the sum over all features
def value(self, board, action):
    x = self.features(board)
    return x[0] * self.w[0, action]


# %% exercise 2, wrong: the values of all actions
# says: that is the sum over all actions; take the column of `action`
def value(self, board, action):
    x = self.features(board)
    return np.sum(x @ self.w)


# %% exercise 2, wrong: features that are there
# says: a feature is not only 0 or 1: multiply by it
def value(self, board, action):
    x = self.features(board)
    return self.w[x != 0, action].sum()


# %% exercise 2, wrong: the mean, another way
# says: that is the mean; take the sum
def value(self, board, action):
    x = self.features(board)
    return np.mean(x * self.w[:, action])


# %% exercise 2, wrong: the row
# says: that is the row of w with this number; take the column
def value(self, board, action):
    x = self.features(board)
    return sum(x[i] * self.w[action, i] for i in range(3))


# %% exercise 2, wrong: an array of its own
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


# %% exercise 3, right: with one_step_target
# says: Right: an old network gives the target, and every transition in memory has the same chance. See it learn:
def target_of(self, row):
    memory = self.memory
    dqn.forward(self.target, memory.next_states[row], self.h, self.Q)
    return one_step_target(memory.rewards[row], self.discount, np.max(self.Q), memory.terminated[row] == 1)


# %% exercise 3, right: a factor
def target_of(self, row):
    memory = self.memory
    dqn.forward(self.target, memory.next_states[row], self.h, self.Q)
    return memory.rewards[row] + (1 - memory.terminated[row]) * self.discount * np.max(self.Q[0])


# %% exercise 3, right: a loop for the maximum
def target_of(self, row):
    y = self.memory.rewards[row]
    if not self.memory.terminated[row]:
        dqn.forward(self.target, self.memory.next_states[row], self.h, self.Q)
        best = self.Q[0, 0]
        for a in range(1, self.Q.shape[1]):
            best = max(best, self.Q[0, a])
        y += self.discount * best
    return y


# %% exercise 3, right: a branch for a full memory
def row_for(self, u):
    n = len(self.memory.actions)
    if self.steps[0] < n:
        n = self.steps[0]
    return int(np.floor(u * n))


# %% exercise 3, right: backwards
def row_for(self, u):
    n = min(self.steps[0], len(self.memory.rewards))
    return n - 1 - int(u * n)


# %% exercise 3, right: math.floor
def row_for(self, u):
    return math.floor(u * min(int(self.steps[0]), self.memory.actions.shape[0]))


# %% exercise 3, right: own arrays
def target_of(self, row):
    memory = self.memory
    h, Q = np.zeros(len(self.h)), np.zeros(self.Q.shape)
    dqn.forward(self.target, memory.next_states[row], h, Q)
    return float(memory.rewards[row] + self.discount * Q.max() * (memory.terminated[row] == 0))


# %% exercise 3, wrong: terminated is forgotten
# says: after a terminal state nothing follows: where `terminated` is 1 the target is the reward alone
# says: of the next state by the old weights, target_of should return
def target_of(self, row):
    dqn.forward(self.target, self.memory.next_states[row], self.h, self.Q)
    return self.memory.rewards[row] + self.discount * self.Q[0].max()


# %% exercise 3, wrong: the present weights
# says: the values of the next state come from the old weights, `self.target`
# says: and the values
def target_of(self, row):
    if self.memory.terminated[row] == 1:
        return self.memory.rewards[row]
    dqn.forward(self.weights, self.memory.next_states[row], self.h, self.Q)
    return self.memory.rewards[row] + self.discount * self.Q[0].max()


# %% exercise 3, wrong: the present state
# says: the value should be that of the next state, `memory.next_states[row]`
def target_of(self, row):
    if self.memory.terminated[row] == 1:
        return self.memory.rewards[row]
    dqn.forward(self.target, self.memory.states[row], self.h, self.Q)
    return self.memory.rewards[row] + self.discount * self.Q[0].max()


# %% exercise 3, wrong: no discount
# says: the discount is missing
def target_of(self, row):
    if self.memory.terminated[row] == 1:
        return self.memory.rewards[row]
    dqn.forward(self.target, self.memory.next_states[row], self.h, self.Q)
    return self.memory.rewards[row] + self.Q[0].max()


# %% exercise 3, wrong: the mean
# says: take the largest value, not the mean
def target_of(self, row):
    if self.memory.terminated[row] == 1:
        return self.memory.rewards[row]
    dqn.forward(self.target, self.memory.next_states[row], self.h, self.Q)
    return self.memory.rewards[row] + self.discount * self.Q[0].mean()


# %% exercise 3, wrong: the action of the memory
# says: take the best action in the next state, not the one that was taken before
def target_of(self, row):
    memory = self.memory
    if memory.terminated[row] == 1:
        return memory.rewards[row]
    dqn.forward(self.target, memory.next_states[row], self.h, self.Q)
    return memory.rewards[row] + self.discount * self.Q[0, memory.actions[row]]


# %% exercise 3, wrong: argmax
# says: that is the number of the best action; its value is needed
def target_of(self, row):
    if self.memory.terminated[row] == 1:
        return self.memory.rewards[row]
    dqn.forward(self.target, self.memory.next_states[row], self.h, self.Q)
    return self.memory.rewards[row] + self.discount * self.Q[0].argmax()


# %% exercise 3, wrong: the reward alone
# says: the value of the next state is missing
def target_of(self, row):
    return self.memory.rewards[row]


# %% exercise 3, wrong: nothing at the end
# says: at the end of an episode the target is the reward, not 0
def target_of(self, row):
    if self.memory.terminated[row] == 1:
        return 0.0
    dqn.forward(self.target, self.memory.next_states[row], self.h, self.Q)
    return self.memory.rewards[row] + self.discount * self.Q[0].max()


# %% exercise 3, wrong: the other way round
# says: the terminal case is the wrong way round
def target_of(self, row):
    if self.memory.terminated[row] == 0:
        return self.memory.rewards[row]
    dqn.forward(self.target, self.memory.next_states[row], self.h, self.Q)
    return self.memory.rewards[row] + self.discount * self.Q[0].max()


# %% exercise 3, wrong: the error
# says: the present value belongs to the error, not to the target
def target_of(self, row):
    memory = self.memory
    y = memory.rewards[row]
    if memory.terminated[row] == 0:
        dqn.forward(self.target, memory.next_states[row], self.h, self.Q)
        y += self.discount * self.Q[0].max()
    dqn.forward(self.weights, memory.states[row], self.h, self.Q)
    return y - self.Q[0, memory.actions[row]]


# %% exercise 3, wrong: a row of values
# says: should be one number
def target_of(self, row):
    dqn.forward(self.target, self.memory.next_states[row], self.h, self.Q)
    return self.memory.rewards[row] + self.discount * self.Q[0]


# %% exercise 3, wrong: forward returns nothing
# says: NoneType
def target_of(self, row):
    return self.memory.rewards[row] + self.discount * dqn.forward(
        self.target, self.memory.next_states[row], self.h, self.Q
    )


# %% exercise 3, wrong: empty rows
# says: count the places that are filled
# says: transitions, in a memory of
def row_for(self, u):
    return int(u * len(self.memory.actions))


# %% exercise 3, wrong: beyond the memory
# says: the memory has no more places
# says: , but the places 0 to
def row_for(self, u):
    return int(u * self.steps[0])


# %% exercise 3, wrong: counted from 1
# says: places count from 0, so that the last one is their number less 1
def row_for(self, u):
    return int(u * min(self.steps[0], len(self.memory.actions))) + 1


# %% exercise 3, wrong: the last row never
# says: never comes up, and it should as often as the others
# says: , every filled place should be equally likely:
def row_for(self, u):
    return int(u * max(min(self.steps[0], len(self.memory.actions)) - 1, 1))


# %% exercise 3, wrong: rounded
# says: some places come up more often than others: multiply `u` by the number of filled places, and cut off by
#   int(...); neither round(...) nor a remainder by % is even
def row_for(self, u):
    return round(u * (min(self.steps[0], len(self.memory.actions)) - 1))


# %% exercise 3, wrong: a remainder
# says: nor a remainder by % is even
def row_for(self, u):
    return int(u * self.steps[0]) % len(self.memory.actions)


# %% exercise 3, wrong: not whole
# says: : make it one by int(...)
# says: ) should be a whole number, but is
def row_for(self, u):
    return u * min(self.steps[0], len(self.memory.actions))


# %% exercise 3, wrong: always the newest
# says: never comes up
def row_for(self, u):
    return (self.steps[0] - 1) % len(self.memory.actions)


# %% exercise 3, wrong: a function
# says: should be the class
MyDQN = lambda task: DQN.create(task)


# %% exercise 3, wrong: it writes into the memory
# says: changes `self.memory.rewards`
# says: `; it should only read it, and return a number
def target_of(self, row):
    memory = self.memory
    if memory.terminated[row] == 0:
        dqn.forward(self.target, memory.next_states[row], self.h, self.Q)
        memory.rewards[row] += self.discount * self.Q[0].max()
    return memory.rewards[row]


# %% exercise 3, wrong: random numbers of its own
# says: row_for(0.5) gives another place in every call: the random number is drawn already, it is `u`
def row_for(self, u):
    return int(np.random.random() * min(self.steps[0], len(self.memory.actions)))


# %% exercise 3, wrong: it counts the draws
# says: row_for(0.5) changes `self.steps`: only read it, and return a place
def row_for(self, u):
    self.steps[0] += 1
    return int(u * min(self.steps[0] - 1, len(self.memory.actions)))


# %% exercise 3, wrong: the array of steps
# says: take an entry of it
def row_for(self, u):
    return int(u * np.minimum(self.steps, len(self.memory.actions) * np.ones(2)))


# %% exercise 3, wrong: DQN for OpenDQN
# says: MyDQN should begin with `class MyDQN(lesson.OpenDQN):`, as it is OpenDQN that calls `target_of` and `row_for`
class MyDQN(DQN):
    __slots__ = ()

    def target_of(self, row):
        memory = self.memory
        if memory.terminated[row] == 1:
            return memory.rewards[row]
        dqn.forward(self.target, memory.next_states[row], self.h, self.Q)
        return memory.rewards[row] + self.discount * self.Q[0].max()

    def row_for(self, u):
        return int(u * min(self.steps[0], len(self.memory.actions)))


# %% exercise 3, wrong: a method under another name
# says: MyDQN has no method `row_for` of its own
# says: ` of its own, so it uses that of OpenDQN: is the name spelt as in the exercise, and does the method stand inside
#   the class?
class MyDQN(lesson.OpenDQN):
    __slots__ = ()

    def target_of(self, row):
        memory = self.memory
        if memory.terminated[row] == 1:
            return memory.rewards[row]
        dqn.forward(self.target, memory.next_states[row], self.h, self.Q)
        return memory.rewards[row] + self.discount * self.Q[0].max()

    def row_of(self, u):
        return int(u * min(self.steps[0], len(self.memory.actions)))


# %% exercise 3, wrong: the present weights and state
# says: the value should be that of the next state, by the old weights `self.target`
def target_of(self, row):
    memory = self.memory
    dqn.forward(self.weights, memory.states[row], self.h, self.Q)
    best = np.max(self.Q[0])
    if memory.terminated[row] == 1:
        return memory.rewards[row]
    return memory.rewards[row] + self.discount * best


# %% exercise 3, wrong: the minimum
# says: take the largest value, not the smallest
def target_of(self, row):
    memory = self.memory
    dqn.forward(self.target, memory.next_states[row], self.h, self.Q)
    best = np.min(self.Q[0])
    if memory.terminated[row] == 1:
        return memory.rewards[row]
    return memory.rewards[row] + self.discount * best


# %% exercise 3, wrong: the sum
# says: take the largest value, not the sum
def target_of(self, row):
    memory = self.memory
    dqn.forward(self.target, memory.next_states[row], self.h, self.Q)
    best = np.sum(self.Q[0])
    if memory.terminated[row] == 1:
        return memory.rewards[row]
    return memory.rewards[row] + self.discount * best


# %% exercise 3, wrong: the first value
# says: the index is missing: that is the value of action 0, and the largest one is needed
def target_of(self, row):
    memory = self.memory
    dqn.forward(self.target, memory.next_states[row], self.h, self.Q)
    best = self.Q[0, 0]
    if memory.terminated[row] == 1:
        return memory.rewards[row]
    return memory.rewards[row] + self.discount * best


# %% exercise 3, wrong: no reward
# says: the reward is missing
def target_of(self, row):
    memory = self.memory
    dqn.forward(self.target, memory.next_states[row], self.h, self.Q)
    best = np.max(self.Q[0])
    if memory.terminated[row] == 1:
        return 0.0
    return self.discount * best


# %% exercise 3, wrong: all is discounted
# says: the reward is discounted as well; only the next value should be
def target_of(self, row):
    memory = self.memory
    dqn.forward(self.target, memory.next_states[row], self.h, self.Q)
    best = np.max(self.Q[0])
    if memory.terminated[row] == 1:
        return memory.rewards[row]
    return self.discount * (memory.rewards[row] + best)


# %% exercise 3, wrong: double DQN
# says: that is the target of double DQN: here the old weights choose the action as well
def target_of(self, row):
    memory = self.memory
    dqn.forward(self.weights, memory.next_states[row], self.h, self.Q)
    chosen = int(np.argmax(self.Q[0]))
    dqn.forward(self.target, memory.next_states[row], self.h, self.Q)
    best = self.Q[0, chosen]
    if memory.terminated[row] == 1:
        return memory.rewards[row]
    return memory.rewards[row] + self.discount * best


# %% exercise 3, wrong: no value after a good step
# says: in this case it looks like this:
def target_of(self, row):
    memory = self.memory
    dqn.forward(self.target, memory.next_states[row], self.h, self.Q)
    best = np.max(self.Q[0])
    if memory.terminated[row] == 1:
        return memory.rewards[row]
    return memory.rewards[row] + (self.discount * best if row % 2 else 0.0)
