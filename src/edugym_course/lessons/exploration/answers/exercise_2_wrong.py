# %% not solved
# says: Not solved yet
def optimist(wall):
    raise NotImplementedError("not solved yet: replace this line")


# %% no return
# says: is a `return` missing?
def optimist(wall):
    QLearning.create(wall, learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0), initial_value=1.0)


# %% called already
# says: should be a function of the wall
# says: the wall that returns an agent
optimist = QLearning.create((31, 2), learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0), initial_value=1.0)


# %% the class
# says: should give an agent, but gives the class QLearning
def optimist(wall):
    return QLearning


# %% learning rate left out
# says: a learning rate of 0.1, and it should be 0.5
def optimist(wall):
    return QLearning.create(wall, discount=0.9, exploration=EpsilonGreedy(0.0), initial_value=1.0)


# %% learning rate 1
# says: a learning rate of 1, and it should be 0.5
def optimist(wall):
    return QLearning.create(wall, learning_rate=1.0, discount=0.9, exploration=EpsilonGreedy(0.0), initial_value=1.0)


# %% discount left out
# says: a discount of 0.99, and it should be 0.9
def optimist(wall):
    return QLearning.create(wall, learning_rate=0.5, exploration=EpsilonGreedy(0.0), initial_value=1.0)


# %% both left out
# says: a learning rate of 0.1
# says: a discount of 0.99
def optimist(wall):
    return QLearning.create(wall, exploration=EpsilonGreedy(0.0), initial_value=1.0)


# %% not optimistic
# says: that is the usual first value: `create` has a setting `initial_value`
def optimist(wall):
    return QLearning.create(wall, learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0))


# %% too optimistic
# says: every value in Q[0] should be 1, but is 10
# says: all values should start at 1
def optimist(wall):
    return QLearning.create(wall, learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0), initial_value=10)


# %% only the ground is optimistic
# says: should be 1, but is 0
def optimist(wall):
    agent = QLearning.create(wall, learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0))
    agent.Q[0] = 1
    return agent


# %% still exploring
# says: ε should be 0, but it is 0.1
# says: the optimist explores by its values alone, so ε should be 0, but it is
def optimist(wall):
    return QLearning.create(wall, learning_rate=0.5, discount=0.9, initial_value=1.0)


# %% softmax
# says: act(1, rng)
# says: should choose action 1
def optimist(wall):
    return QLearning.create(wall, learning_rate=0.5, discount=0.9, exploration=Softmax(0.5), initial_value=1.0)


# %% the wall is ignored
# says: should have the shape
def optimist(wall):
    return QLearning.create((31, 2), learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0), initial_value=1.0)


# %% off by one
# says: should have the shape (31, 2), but has (30, 2)
def optimist(wall):
    return QLearning(np.ones((wall.height, 2)), 0.5, 0.9, EpsilonGreedy(0.0))


# %% a table of whole numbers
# says: numbers, so every update loses what is behind the decimal point: make it with np.zeros(shape) or np.full(shape,
#   1.0)
def optimist(wall):
    return QLearning(np.ones((wall.height + 1, wall.n_grips), int), 0.5, 0.9, EpsilonGreedy(0.0))


# %% a list for a table
# says: should be a NumPy array, but is a list
def optimist(wall):
    return QLearning([[1.0] * wall.n_grips] * (wall.height + 1), 0.5, 0.9, EpsilonGreedy(0.0))


# %% a setting misspelt
# says: has no setting 'alpha'
def optimist(wall):
    return QLearning.create(wall, alpha=0.5, discount=0.9, exploration=EpsilonGreedy(0.0), initial_value=1.0)


# %% ε for the strategy
# says: exploration must be a strategy
def optimist(wall):
    return QLearning.create(wall, learning_rate=0.5, discount=0.9, exploration=0.0, initial_value=1.0)


# %% one agent for all walls
# says: two calls of optimist(wall) share one table: make a new one in every call
made = QLearning.create((31, 2), learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0), initial_value=1.0)


def optimist(wall):
    return made


# %% another name in the body
# says: the line `return QLearning.create(environment
# says: NameError
def optimist(wall):
    return QLearning.create(environment, learning_rate=0.5, discount=0.9)


# %% learning rate and discount interchanged
# says: a learning rate of 0.9
# says: a discount of 0.5
def optimist(wall):
    return QLearning.create(wall, learning_rate=0.9, discount=0.5, exploration=EpsilonGreedy(0.0), initial_value=1.0)


# %% SARSA
# says: that is SARSA
def optimist(wall):
    return SARSA.create(wall, learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0), initial_value=1.0)


# %% a parameter too many
# says: missing 1 required positional argument
def optimist(wall, height):
    return QLearning.create(wall, learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0), initial_value=1.0)


# %% the table is returned
# says: has no `act`
# says: should give an agent, but what it gives, of the type
def optimist(wall):
    return QLearning.create(wall, learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0), initial_value=1.0).Q


# %% at random
# says: it acts at random
# says: act(1, rng)
class Random(QLearning):
    __slots__ = ()

    def act(self, state, rng):
        return int(rng.random() * self.Q.shape[1])


def optimist(wall):
    Q = np.ones((wall.height + 1, wall.n_grips))
    return Random(Q, 0.5, 0.9, EpsilonGreedy(0.0))


# %% at random among equals and all others
# says: it acts at random
# says: act(2, rng)
class Loose(QLearning):
    __slots__ = ()

    def act(self, state, rng):
        values = self.Q[state]
        if np.sum(values == values.max()) > 1:
            return int(rng.random() * len(values))
        return int(np.argmax(values))


def optimist(wall):
    Q = np.ones((wall.height + 1, wall.n_grips))
    return Loose(Q, 0.5, 0.9, EpsilonGreedy(0.0))


# %% the first of equals
# says: ties should be broken at random, and it takes the first of equals
# says: act(2, rng)
class Early(QLearning):
    __slots__ = ()

    def act(self, state, rng):
        return int(np.argmax(self.Q[state]))


def optimist(wall):
    Q = np.ones((wall.height + 1, wall.n_grips))
    return Early(Q, 0.5, 0.9, EpsilonGreedy(0.0))


# %% the lowest value
# says: it takes the worst grip
class Pessimist(QLearning):
    __slots__ = ()

    def greedy(self, state, rng):
        return int(np.argmin(self.Q[state]))

    def act(self, state, rng):
        return self.greedy(state, rng)


def optimist(wall):
    Q = np.ones((wall.height + 1, wall.n_grips))
    return Pessimist(Q, 0.5, 0.9, EpsilonGreedy(0.0))


# %% the last of equals
# says: ties should be broken at random, and it takes the last of equals
# says: act(2, rng)
class Late(QLearning):
    __slots__ = ()

    def greedy(self, state, rng):
        return int(np.flatnonzero(self.Q[state] == self.Q[state].max())[-1])

    def act(self, state, rng):
        return self.greedy(state, rng)


def optimist(wall):
    Q = np.ones((wall.height + 1, wall.n_grips))
    return Late(Q, 0.5, 0.9, EpsilonGreedy(0.0))


# %% it explores by a rule of its own
# says: it still explores, with ε = 0.1
# says: act(1, rng)
class Restless(QLearning):
    __slots__ = ()

    def act(self, state, rng):
        return int(rng.integers(self.Q.shape[1])) if rng.random() < 0.1 else self.greedy(state, rng)


def optimist(wall):
    Q = np.ones((wall.height + 1, wall.n_grips))
    return Restless(Q, 0.5, 0.9, EpsilonGreedy(0.0))
