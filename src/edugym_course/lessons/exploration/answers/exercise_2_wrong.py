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


# %% not optimistic
# says: that is the usual first value: `create` has a setting `initial_value`
def optimist(wall):
    return QLearning.create(wall, learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0))


# %% too optimistic
# says: every value in Q[0] should be 1, but is 10
# says: all values should start at 1
def optimist(wall):
    return QLearning.create(wall, learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0), initial_value=10)


# %% still exploring
# says: ε should be 0, but it is 0.1, the usual one: `create` has a setting `exploration`
# says: , the usual one: `create` has a setting `exploration`
# says: the optimist explores by its values alone, so ε should be 0, but it is
def optimist(wall):
    return QLearning.create(wall, learning_rate=0.5, discount=0.9, initial_value=1.0)


# %% softmax
# says: act(state, rng), where state = 1
# says: , by chance where one action is right: it sees a tie where there is none, or it explores, or it draws in proportion to something
def optimist(wall):
    return QLearning.create(wall, learning_rate=0.5, discount=0.9, exploration=Softmax(0.5), initial_value=1.0)


# %% a table of whole numbers
# says: numbers, so every update loses what is behind the decimal point: make it with np.zeros(shape) or np.full(shape,
#   1.0)
def optimist(wall):
    return QLearning(np.ones((wall.height + 1, wall.n_grips), int), 0.5, 0.9, EpsilonGreedy(0.0))


# %% one agent for all walls
# says: two calls of optimist(wall) share one table: make a new one in every call
made = QLearning.create((31, 2), learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0), initial_value=1.0)


def optimist(wall):
    return made


# %% a parameter too many
# says: missing 1 required positional argument
def optimist(wall, height):
    return QLearning.create(wall, learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0), initial_value=1.0)


# %% the table is returned
# says: has no `act`
# says: should give an agent, but what it gives, of the type
def optimist(wall):
    return QLearning.create(wall, learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0), initial_value=1.0).Q


# %% the first of equals
# says: ties should be broken at random, and it takes the first of equals
# says: act(state, rng), where state = 2
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


# %% another agent
# says: `create` has a setting `initial_value`; and the exercise asks for `QLearning`
# says: ; and the exercise asks for `QLearning`
def optimist(wall):
    return CountBased.create(wall, learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0))


# %% a wall of its own
# says: the table `Q` should have the shape (31, 2), a row for each position and a column for each grip of the `wall`
#   that `optimist` is given, but has (9, 3)
wall_of_mine = make_mdp("Boulder", height=8, n_grips=3)


def optimist(wall):
    settings = {"learning_rate": 0.5, "discount": 0.9, "exploration": EpsilonGreedy(0.0), "initial_value": 1.0}
    return QLearning.create(wall_of_mine, **settings)


# %% a table for every goal
# says: but has (31, 31, 2); and the exercise asks for `QLearning`
def optimist(wall):
    return GoExplore.create(wall, explore_steps=20, learning_rate=0.5, discount=0.9)


# %% with a bonus
# slow
# says: the exercise asks for `QLearning`
# says: , and optimist(wall) returns a `
def optimist(wall):
    return CountBased.create(wall, learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0), initial_value=1.0)
