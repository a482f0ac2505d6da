# ruff: noqa
# Right and wrong answers to the exercises of lesson 1; tests/lessons/test_answers.py tries them all.
# An answer stands in the place of the exercise's cell. Methods without their class replace those of the solution.

# %% setup
# Training is left out: what exercise 4 checks is which experiment was done, not what came out.
import math
from decimal import Decimal
from fractions import Fraction
import edugym.training.repeat
from edugym import Greedy, SARSA, Softmax
from edugym.training.train import Run


def untrained(environment, agent, n_steps, *, seed, **how):
    return Run(np.array([0, n_steps]), np.zeros(2), np.zeros(2), np.zeros(2, int), agent, seed, 0.0, True)


edugym.training.repeat.train = untrained

# %% exercise 1, right: by logarithms
# says: Right: ε = 1.38 % is little, and yet one wrong grip in 145 costs half of the climbs.
epsilon = 2 - 2 * math.exp(math.log(0.5) / 100)

# %% exercise 1, right: four digits
epsilon = 0.0138

# %% exercise 1, right: six digits
epsilon = 0.013815

# %% exercise 1, right: in single precision
epsilon = np.float32(2 * (1 - 0.5 ** (1 / 100)))

# %% exercise 1, right: an array without axes
epsilon = np.array(2 * (1 - 0.5**0.01))

# %% exercise 1, right: a fraction
epsilon = Fraction(27631, 2_000_000)

# %% exercise 1, right: a decimal number
epsilon = Decimal("0.01382")

# %% exercise 1, right: by bisection
low, high = 0.0, 1.0
for _ in range(60):
    middle = (low + high) / 2
    if (1 - middle / 2) ** 100 >= 0.5:
        low = middle
    else:
        high = middle
epsilon = low

# %% exercise 1, right: log1p
epsilon = -2 * np.expm1(np.log(0.5) / 100)

# %% exercise 1, wrong: nothing was done
# says: with ε = 0.1, 0.59% of the climbs
# says: that is the value with which the cell began
epsilon = 0.1

# %% exercise 1, wrong: still the placeholder
# says: Not solved yet
# says: is still `...`; put your answer there.
epsilon = ...

# %% exercise 1, wrong: none
# says: Not solved yet
# says: is None; give it a value.
epsilon = None

# %% exercise 1, wrong: the wrong grip every time
# says: that is ε/2, the probability of a wrong grip; of two grips a random action takes the wrong one half of the time
epsilon = 1 - 0.5 ** (1 / 100)

# %% exercise 1, wrong: the logarithm's approximation
# says: that is ln 2/50, an approximation which is a little too large; solve (1 − ε/2)^100 = 1/2 exactly
epsilon = math.log(2) / 50

# %% exercise 1, wrong: 99 steps
# says: that is for 99 steps; from the ground, position 0, to the top, position 100, there are 100
epsilon = 2 * (1 - 0.5 ** (1 / 99))

# %% exercise 1, wrong: 101 steps
# says: that is for 101 steps; from the ground, position 0, to the top, position 100, there are 100
epsilon = 2 * (1 - 0.5 ** (1 / 101))

# %% exercise 1, wrong: probabilities added up
# says: 100 steps that go wrong with probability ε/2 do not add up to 100 · ε/2; multiply the probabilities that they go
#   right
epsilon = 0.5 / 100 * 2

# %% exercise 1, wrong: probabilities added up, wrong every time
# says: the probabilities of 100 steps do not add up; multiply the probabilities that they go right
epsilon = 0.5 / 100

# %% exercise 1, wrong: another wall
# says: that is for a wall of height 30, and this one has 100
epsilon = 2 * (1 - 0.5 ** (1 / 30))

# %% exercise 1, wrong: a step goes right with probability ε/2
# says: is no probability
# says: a step goes right with probability 1 − ε/2, not ε/2
epsilon = 2 * 0.5 ** (1 / 100)

# %% exercise 1, wrong: the probability of a right step
# says: that is the probability of a *right* step
epsilon = 0.5 ** (1 / 100)

# %% exercise 1, wrong: in percent
# says: that is in percent; a probability lies between 0 and 1
epsilon = 1.38

# %% exercise 1, wrong: a text
# says: : leave the quotes out
epsilon = "0.0138"

# %% exercise 1, wrong: a list
# says: : take an entry of it
epsilon = [0.0138]

# %% exercise 1, wrong: a truth value
# says: should be a number, but is the truth value
epsilon = (1 - 0.0138 / 2) ** 100 == 0.5

# %% exercise 1, wrong: rounded
# says: , by a little: give four digits or more
# says: half should, so ε must be
epsilon = 0.014

# %% exercise 1, wrong: much too large
# says: ε must be smaller
epsilon = 0.3

# %% exercise 1, wrong: no exploration
# says: ε must be larger
epsilon = 0

# %% exercise 1, wrong: a function
# says: should be a number, but is a function: call it, with parentheses
epsilon = lambda height: 2 * (1 - 0.5 ** (1 / height))

# %% exercise 1, wrong: a tuple by a comma
# says: take an entry
epsilon = (2 * (1 - 0.5 ** (1 / 100)),)

# %% exercise 1, wrong: integer division
# says: ε must be larger
epsilon = 2 * (1 - 0.5 ** (1 // 100))


# %% exercise 1, wrong: two thirds
# says: of two grips a random action takes the wrong one with probability 1/2, not 2/3
epsilon = 1.5 * (1 - 0.5 ** (1 / 100))


# %% exercise 1, wrong: two logarithms
# says: natural and decimal logarithms are mixed up
epsilon = 2 * (1 - 10 ** (math.log(0.5) / 100))


# %% exercise 1, wrong: below 0
# says: the sign is wrong: ε = 2 (1 − 0.5^(1/100))
epsilon = -2 * (1 - 0.5 ** (1 / 100))


# %% exercise 2, right: the constructor with all fields
# says: Right: it never takes a random action, and yet it tries everything, for whatever it tries disappoints it. See it
#   race:
def optimist(wall):
    Q = np.ones((wall.height + 1, wall.n_grips))
    return QLearning(Q, 0.5, 0.9, EpsilonGreedy(0.0))


# %% exercise 2, right: filled afterwards
def optimist(wall):
    agent = QLearning.create(wall, learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0))
    agent.Q[:] = 1
    return agent


# %% exercise 2, right: the greedy strategy, whole numbers
def optimist(wall):
    return QLearning.create(wall, learning_rate=1 / 2, discount=9 / 10, exploration=Greedy(), initial_value=1)


# %% exercise 2, right: by _replace
def optimist(wall):
    agent = QLearning.create(wall, initial_value=1.0)
    return agent._replace(learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0))


# %% exercise 2, right: settings in a dictionary
settings = dict(learning_rate=0.5, discount=0.9, initial_value=1.0)
optimist = lambda wall: QLearning.create(wall, exploration=EpsilonGreedy(epsilon=0.0), **settings)


# %% exercise 2, right: from the spaces
def optimist(environment, value=1.0):
    shape = int(environment.observation_space.n), int(environment.action_space.n)
    return QLearning.create(shape, learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0), initial_value=value)


# %% exercise 2, right: novelty without a bonus
def optimist(wall):
    return CountBased.create(wall, bonus=0.0, learning_rate=0.5, discount=0.9, exploration=Greedy(), initial_value=1.0)


# %% exercise 2, right: partial
from functools import partial

optimist = partial(QLearning.create, learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0), initial_value=1.0)


# %% exercise 2, right: an own class
class Optimist(NamedTuple):
    Q: np.ndarray

    def act(self, state, rng):
        best = np.flatnonzero(self.Q[state] == self.Q[state].max())
        return int(rng.choice(best))

    def learn(self, state, action, reward, next_state, terminated):
        target = reward if terminated else reward + 0.9 * self.Q[next_state].max()
        self.Q[state, action] += 0.5 * (target - self.Q[state, action])


def optimist(wall):
    return Optimist(np.ones((wall.observation_space.n, wall.action_space.n)))


# %% exercise 2, wrong: not solved
# says: Not solved yet
def optimist(wall):
    raise NotImplementedError("not solved yet: replace this line")


# %% exercise 2, wrong: no return
# says: is a `return` missing?
def optimist(wall):
    QLearning.create(wall, learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0), initial_value=1.0)


# %% exercise 2, wrong: called already
# says: should be a function of the wall
# says: the wall that returns an agent
optimist = QLearning.create((31, 2), learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0), initial_value=1.0)


# %% exercise 2, wrong: the class
# says: should give an agent, but gives the class QLearning
def optimist(wall):
    return QLearning


# %% exercise 2, wrong: learning rate left out
# says: a learning rate of 0.1, and it should be 0.5
def optimist(wall):
    return QLearning.create(wall, discount=0.9, exploration=EpsilonGreedy(0.0), initial_value=1.0)


# %% exercise 2, wrong: learning rate 1
# says: a learning rate of 1, and it should be 0.5
def optimist(wall):
    return QLearning.create(wall, learning_rate=1.0, discount=0.9, exploration=EpsilonGreedy(0.0), initial_value=1.0)


# %% exercise 2, wrong: discount left out
# says: a discount of 0.99, and it should be 0.9
def optimist(wall):
    return QLearning.create(wall, learning_rate=0.5, exploration=EpsilonGreedy(0.0), initial_value=1.0)


# %% exercise 2, wrong: both left out
# says: a learning rate of 0.1
# says: a discount of 0.99
def optimist(wall):
    return QLearning.create(wall, exploration=EpsilonGreedy(0.0), initial_value=1.0)


# %% exercise 2, wrong: not optimistic
# says: that is the usual first value: `create` has a setting `initial_value`
def optimist(wall):
    return QLearning.create(wall, learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0))


# %% exercise 2, wrong: too optimistic
# says: every value in Q[0] should be 1, but is 10
# says: all values should start at 1
def optimist(wall):
    return QLearning.create(wall, learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0), initial_value=10)


# %% exercise 2, wrong: only the ground is optimistic
# says: should be 1, but is 0
def optimist(wall):
    agent = QLearning.create(wall, learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0))
    agent.Q[0] = 1
    return agent


# %% exercise 2, wrong: still exploring
# says: ε should be 0, but it is 0.1
# says: the optimist explores by its values alone, so ε should be 0, but it is
def optimist(wall):
    return QLearning.create(wall, learning_rate=0.5, discount=0.9, initial_value=1.0)


# %% exercise 2, wrong: softmax
# says: act(1, rng)
# says: should choose action 1
def optimist(wall):
    return QLearning.create(wall, learning_rate=0.5, discount=0.9, exploration=Softmax(0.5), initial_value=1.0)


# %% exercise 2, wrong: the wall is ignored
# says: should have the shape
def optimist(wall):
    return QLearning.create((31, 2), learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0), initial_value=1.0)


# %% exercise 2, wrong: off by one
# says: should have the shape (31, 2), but has (30, 2)
def optimist(wall):
    return QLearning(np.ones((wall.height, 2)), 0.5, 0.9, EpsilonGreedy(0.0))


# %% exercise 2, wrong: a table of whole numbers
# says: numbers, so every update loses what is behind the decimal point: make it with np.zeros(shape) or np.full(shape,
#   1.0)
def optimist(wall):
    return QLearning(np.ones((wall.height + 1, wall.n_grips), int), 0.5, 0.9, EpsilonGreedy(0.0))


# %% exercise 2, wrong: a list for a table
# says: should be a NumPy array, but is a list
def optimist(wall):
    return QLearning([[1.0] * wall.n_grips] * (wall.height + 1), 0.5, 0.9, EpsilonGreedy(0.0))


# %% exercise 2, wrong: a setting misspelt
# says: has no setting 'alpha'
def optimist(wall):
    return QLearning.create(wall, alpha=0.5, discount=0.9, exploration=EpsilonGreedy(0.0), initial_value=1.0)


# %% exercise 2, wrong: ε for the strategy
# says: exploration must be a strategy
def optimist(wall):
    return QLearning.create(wall, learning_rate=0.5, discount=0.9, exploration=0.0, initial_value=1.0)


# %% exercise 2, wrong: one agent for all walls
# says: two calls of optimist(wall) share one table: make a new one in every call
made = QLearning.create((31, 2), learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0), initial_value=1.0)


def optimist(wall):
    return made


# %% exercise 2, wrong: another name in the body
# says: the line `return QLearning.create(environment
# says: NameError
def optimist(wall):
    return QLearning.create(environment, learning_rate=0.5, discount=0.9)


# %% exercise 2, wrong: learning rate and discount interchanged
# says: a learning rate of 0.9
# says: a discount of 0.5
def optimist(wall):
    return QLearning.create(wall, learning_rate=0.9, discount=0.5, exploration=EpsilonGreedy(0.0), initial_value=1.0)


# %% exercise 2, wrong: SARSA
# says: that is SARSA
def optimist(wall):
    return SARSA.create(wall, learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0), initial_value=1.0)


# %% exercise 2, wrong: a parameter too many
# says: missing 1 required positional argument
def optimist(wall, height):
    return QLearning.create(wall, learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0), initial_value=1.0)


# %% exercise 2, wrong: the table is returned
# says: has no `act`
# says: should give an agent, but what it gives, of the type
def optimist(wall):
    return QLearning.create(wall, learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0), initial_value=1.0).Q


# %% exercise 2, wrong: at random
# says: it acts at random
# says: act(1, rng)
class Random(QLearning):
    __slots__ = ()

    def act(self, state, rng):
        return int(rng.random() * self.Q.shape[1])


def optimist(wall):
    Q = np.ones((wall.height + 1, wall.n_grips))
    return Random(Q, 0.5, 0.9, EpsilonGreedy(0.0))


# %% exercise 2, wrong: at random among equals and all others
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


# %% exercise 2, wrong: the first of equals
# says: ties should be broken at random, and it takes the first of equals
# says: act(2, rng)
class Early(QLearning):
    __slots__ = ()

    def act(self, state, rng):
        return int(np.argmax(self.Q[state]))


def optimist(wall):
    Q = np.ones((wall.height + 1, wall.n_grips))
    return Early(Q, 0.5, 0.9, EpsilonGreedy(0.0))


# %% exercise 2, wrong: the lowest value
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


# %% exercise 2, wrong: the last of equals
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


# %% exercise 3, right: roots and branches
# says: Right: counting tries says what is new here, the bonus says where to go, and no random step is needed. See it
#   race:
def act(self, state, rng):
    untried = [action for action in range(self.Q.shape[1]) if self.tries[state, action] == 0]
    return untried[0] if untried else self.greedy(state, rng)


def learn(self, state, action, reward, next_state, terminated):
    import math

    self.visits[next_state] += 1
    self.tries[state, action] += 1
    target = reward + self.bonus / math.sqrt(self.visits[next_state])
    if not terminated:
        target += self.discount * np.max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, right: the largest by a loop
def learn(self, state, action, reward, next_state, terminated):
    self.tries[state, action] = self.tries[state, action] + 1
    self.visits[next_state] = self.visits[next_state] + 1
    best = self.Q[next_state, 0]
    for other in range(1, self.Q.shape[1]):
        if self.Q[next_state, other] > best:
            best = self.Q[next_state, other]
    if terminated:
        best = 0.0
    r_plus = reward + self.bonus * self.visits[next_state] ** -0.5
    error = r_plus + self.discount * best - self.Q[state, action]
    self.Q[state, action] = self.Q[state, action] + self.learning_rate * error


# %% exercise 3, right: a weighted mean
def learn(self, state, action, reward, next_state, terminated):
    self.tries[state, action] += 1
    self.visits[next_state] += 1
    n = self.visits[next_state]
    target = reward + self.bonus / np.sqrt(n) + self.discount * (1 - terminated) * self.Q[next_state].max()
    self.Q[state, action] = (1 - self.learning_rate) * self.Q[state, action] + self.learning_rate * target


# %% exercise 3, right: more parameters than needed
def learn(self, state, action, reward, next_state, terminated, truncated):
    self.tries[state][action] += 1
    self.visits[next_state] += 1
    future = 0 if terminated else self.Q[next_state].max()
    self.Q[state][action] += self.learning_rate * (
        reward + self.bonus / self.visits[next_state] ** 0.5 + self.discount * future - self.Q[state][action]
    )


# %% exercise 3, right: any untried grip, at random
def act(self, state, rng):
    n_actions = self.Q.shape[1]
    first = int(rng.random() * n_actions)
    for i in range(n_actions):
        action = (first + i) % n_actions
        if self.tries[state, action] < 1:
            return action
    return self.greedy(state, rng)


# %% exercise 3, right: the last untried grip, by argmin
def act(self, state, rng):
    if self.tries[state].min() == 0:
        return int(np.argmin(self.tries[state]))
    return self.greedy(state, rng)


# %% exercise 3, right: a numpy number
def act(self, state, rng):
    untried = np.flatnonzero(self.tries[state] == 0)
    if len(untried) > 0:
        return rng.choice(untried)
    best = np.flatnonzero(self.Q[state] == self.Q[state].max())
    return rng.choice(best)


# %% exercise 3, right: a plain class
class MyExplorer:
    def __init__(self, n_states, n_actions):
        self.Q = np.zeros((n_states, n_actions))
        self.visits = np.zeros(n_states, int)
        self.tries = np.zeros((n_states, n_actions), int)
        self.learning_rate, self.discount, self.bonus = 0.5, 0.9, 1.0

    @classmethod
    def create(cls, wall):
        return cls(wall.observation_space.n, wall.action_space.n)

    def greedy(self, state, rng):
        return rng.choice(np.flatnonzero(self.Q[state] == max(self.Q[state])))

    def act(self, state, rng):
        for action, tried in enumerate(self.tries[state]):
            if not tried:
                return action
        return self.greedy(state, rng)

    def learn(self, state, action, reward, next_state, terminated):
        self.tries[state, action] += 1
        self.visits[next_state] += 1
        target = reward + self.bonus / self.visits[next_state] ** 0.5
        if not terminated:
            target += self.discount * max(self.Q[next_state])
        self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, right: error first
def learn(self, state, action, reward, next_state, terminated):
    self.visits[next_state] += 1
    self.tries[state, action] += 1
    delta = reward - self.Q[state, action]
    delta += self.bonus / np.sqrt(self.visits[next_state])
    if not terminated:
        delta += self.discount * np.amax(self.Q[next_state, :])
    self.Q[state, action] += self.learning_rate * delta


# %% exercise 3, right: infinite value for the untried
def act(self, state, rng):
    values = np.where(self.tries[state] == 0, np.inf, self.Q[state])
    return int(rng.choice(np.flatnonzero(values == values.max())))


# %% exercise 3, right: all and index
def act(self, state, rng):
    row = list(self.tries[state])
    if 0 in row:
        return row.index(0)
    return self.greedy(state, rng)


# %% exercise 3, wrong: not solved
# says: Not solved yet
def learn(self, state, action, reward, next_state, terminated):
    raise NotImplementedError("not solved yet: replace this line")


# %% exercise 3, wrong: act not solved
# says: Not solved yet
def act(self, state, rng):
    raise NotImplementedError


# %% exercise 3, wrong: nothing
# says: changes no table at all
def learn(self, state, action, reward, next_state, terminated): ...


# %% exercise 3, wrong: the answer of the lesson's novelty agent
# says: `tries` does not count
def learn(self, state, action, reward, next_state, terminated):
    self.visits[next_state] += 1
    reward_and_bonus = reward + self.bonus / np.sqrt(self.visits[next_state])
    target = reward_and_bonus if terminated else reward_and_bonus + self.discount * max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: a visit is noted, not counted
# says: `visits` is set to 1 there
# says: ` is set to 1 there, and it should become one more: write `+= 1`
def learn(self, state, action, reward, next_state, terminated):
    self.tries[state, action] += 1
    self.visits[next_state] = 1


# %% exercise 3, wrong: counted down
# says: `tries` changes by -1 there
# says: there, and every time it should be one more
def learn(self, state, action, reward, next_state, terminated):
    self.visits[next_state] += 1
    self.tries[state, action] -= 1


# %% exercise 3, wrong: no bootstrapping
# says: without bootstrapping
def learn(self, state, action, reward, next_state, terminated):
    self.tries[state, action] += 1
    self.visits[next_state] += 1
    target = reward + self.bonus / self.visits[next_state] ** 0.5
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: mean for max
# says: the mean over the actions
def learn(self, state, action, reward, next_state, terminated):
    self.tries[state, action] += 1
    self.visits[next_state] += 1
    value = 0.0 if terminated else self.Q[next_state].mean()
    target = reward + self.bonus / self.visits[next_state] ** 0.5 + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: the state that was left
# says: it counts the state that was left; count the one that was *entered*, next_state
def learn(self, state, action, reward, next_state, terminated):
    self.tries[state, action] += 1
    self.visits[state] += 1
    value = 0.0 if terminated else max(self.Q[next_state])
    target = reward + self.bonus / self.visits[state] ** 0.5 + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: counted too late
# says: the bonus comes from the old count: count first, so that a first visit has n = 1
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    target = reward + self.bonus / self.visits[next_state] ** 0.5 + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])
    self.tries[state, action] += 1
    self.visits[next_state] += 1


# %% exercise 3, wrong: one visit too many
# says: the bonus is β/√(n + 1), one visit too many
def learn(self, state, action, reward, next_state, terminated):
    self.tries[state, action] += 1
    self.visits[next_state] += 1
    value = 0.0 if terminated else max(self.Q[next_state])
    target = reward + self.bonus / (self.visits[next_state] + 1) ** 0.5 + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: no root
# says: the root is missing: the bonus is β/√n
def learn(self, state, action, reward, next_state, terminated):
    self.tries[state, action] += 1
    self.visits[next_state] += 1
    value = 0.0 if terminated else max(self.Q[next_state])
    target = reward + self.bonus / self.visits[next_state] + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: terminated forgotten
# says: a terminal state has no future
def learn(self, state, action, reward, next_state, terminated):
    self.tries[state, action] += 1
    self.visits[next_state] += 1
    target = reward + self.bonus / self.visits[next_state] ** 0.5 + self.discount * max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: truncated treated as terminated
# says: only its clock ran out
def learn(self, state, action, reward, next_state, terminated, truncated):
    self.tries[state, action] += 1
    self.visits[next_state] += 1
    value = 0.0 if terminated or truncated else max(self.Q[next_state])
    target = reward + self.bonus / self.visits[next_state] ** 0.5 + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: numbers written out
# says: use self.learning_rate
# says: use self.discount
def learn(self, state, action, reward, next_state, terminated):
    self.tries[state, action] += 1
    self.visits[next_state] += 1
    value = 0.0 if terminated else max(self.Q[next_state])
    target = reward + self.bonus / self.visits[next_state] ** 0.5 + 0.9 * value
    self.Q[state, action] += 0.5 * (target - self.Q[state, action])


# %% exercise 3, wrong: β left out
# says: a first bonus of 1
def learn(self, state, action, reward, next_state, terminated):
    self.tries[state, action] += 1
    self.visits[next_state] += 1
    value = 0.0 if terminated else max(self.Q[next_state])
    target = reward + 1 / self.visits[next_state] ** 0.5 + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: max after the update
# says: compute the whole target from the old Q
def learn(self, state, action, reward, next_state, terminated):
    self.tries[state, action] += 1
    self.visits[next_state] += 1
    self.Q[state, action] *= 1 - self.learning_rate
    value = 0.0 if terminated else max(self.Q[next_state])
    target = reward + self.bonus / self.visits[next_state] ** 0.5 + self.discount * value
    self.Q[state, action] += self.learning_rate * target


# %% exercise 3, wrong: the old value forgotten
# says: − Q(S, A) is missing
def learn(self, state, action, reward, next_state, terminated):
    self.tries[state, action] += 1
    self.visits[next_state] += 1
    value = 0.0 if terminated else max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (
        reward + self.bonus / self.visits[next_state] ** 0.5 + self.discount * value
    )


# %% exercise 3, wrong: assigned, not added
# says: write `+=`
def learn(self, state, action, reward, next_state, terminated):
    self.tries[state, action] += 1
    self.visits[next_state] += 1
    value = 0.0 if terminated else max(self.Q[next_state])
    target = reward + self.bonus / self.visits[next_state] ** 0.5 + self.discount * value
    self.Q[state, action] = self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: the value is returned
# says: changes no table at all
# says: it returns something instead
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    return self.Q[state, action] + self.learning_rate * (reward + self.discount * value - self.Q[state, action])


# %% exercise 3, wrong: two mistakes
# says: the mean over the actions
# says: ; and
# says: count first
def learn(self, state, action, reward, next_state, terminated):
    bonus = self.bonus / self.visits[next_state] ** 0.5
    self.tries[state, action] += 1
    self.visits[next_state] += 1
    value = 0.0 if terminated else sum(self.Q[next_state]) / len(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (reward + bonus + self.discount * value - self.Q[state, action])


# %% exercise 3, wrong: a field is assigned
# says: the fields of a NamedTuple are fixed
# says: self.visits = self.visits + 1
def learn(self, state, action, reward, next_state, terminated):
    self.visits = self.visits + 1


# %% exercise 3, wrong: self forgotten
# says: write `self.` before a field
def learn(self, state, action, reward, next_state, terminated):
    visits[next_state] += 1


# %% exercise 3, wrong: index out of the table
# says: the order of the indices
# says: self.tries[action, state] += 1
def learn(self, state, action, reward, next_state, terminated):
    self.tries[action, state] += 1


# %% exercise 3, wrong: another parameter
# says: has the parameter 'done': is 'terminated' meant?
def learn(self, state, action, reward, next_state, done):
    self.tries[state, action] += 1


# %% exercise 3, wrong: act always greedy
# says: a grip that was never tried comes first, whatever Q says of it
# says: , rng), where tries[
def act(self, state, rng):
    return self.greedy(state, rng)


# %% exercise 3, wrong: act slips
# says: it still explores, with ε = 0.1
def act(self, state, rng):
    if rng.random() < 0.1:
        return int(rng.random() * self.Q.shape[1])
    for action in range(self.Q.shape[1]):
        if self.tries[state, action] == 0:
            return action
    return self.greedy(state, rng)


# %% exercise 3, wrong: act at random
# says: act(0, rng)
# says: it acts at random
def act(self, state, rng):
    return int(rng.random() * self.Q.shape[1])


# %% exercise 3, wrong: always the least tried
# says: once all grips were tried the *best* one counts, and it takes the one that was tried least
# says: act(3, rng)
def act(self, state, rng):
    return int(np.argmin(self.tries[state]))


# %% exercise 3, wrong: act without a return at the end
# says: is a `return` missing?
def act(self, state, rng):
    for action in range(self.Q.shape[1]):
        if self.tries[state, action] == 0:
            return action
    self.greedy(state, rng)


# %% exercise 3, wrong: only two grips
# says: a grip that was never tried comes first
def act(self, state, rng):
    for action in range(2):
        if self.tries[state, action] == 0:
            return action
    return self.greedy(state, rng)


# %% exercise 3, wrong: the untried grips as an array
# says: gives an array
def act(self, state, rng):
    untried = np.flatnonzero(self.tries[state] == 0)
    return untried if len(untried) else self.greedy(state, rng)


# %% exercise 3, wrong: act counts
# says: changes the table `tries`
def act(self, state, rng):
    best = self.greedy(state, rng)
    for action in range(self.Q.shape[1]):
        if self.tries[state, action] == 0:
            best = action
    self.tries[state, best] += 1
    return best


# %% exercise 3, wrong: ties not broken
# says: ties should be broken at random, and it takes the first of equals
def act(self, state, rng):
    for action in range(self.Q.shape[1]):
        if self.tries[state, action] == 0:
            return action
    return int(np.argmax(self.Q[state]))


# %% exercise 3, wrong: the value for the action
# says: should give the number of an action
def act(self, state, rng):
    return max(self.Q[state])


# %% exercise 3, wrong: another random source
# says: does not draw its random numbers from `rng`
def act(self, state, rng):
    for action in range(self.Q.shape[1]):
        if self.tries[state, action] == 0:
            return action
    return int(np.random.choice(np.flatnonzero(self.Q[state] == self.Q[state].max())))


# %% exercise 3, wrong: an instance for the class
# says: should be the class
MyExplorer = QLearning.create((4, 2))


# %% exercise 3, wrong: Go-Explore under another name
# says: should keep its field `bonus`
class MyExplorer(NamedTuple):
    Q: np.ndarray

    @classmethod
    def create(cls, wall):
        return QLearning.create(wall)


# %% exercise 3, wrong: precedence of the root
# says: `** 1 / 2` is `(... ** 1) / 2`: write `** 0.5` for the root
def learn(self, state, action, reward, next_state, terminated):
    self.tries[state, action] += 1
    self.visits[next_state] += 1
    v = 0.0 if terminated else max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (
        reward + self.bonus / self.visits[next_state] ** 1 / 2 + self.discount * v - self.Q[state, action]
    )


# %% exercise 3, wrong: the bonus under the discount
# says: the bonus is discounted; γ belongs to the value of the next state only
def learn(self, state, action, reward, next_state, terminated):
    self.tries[state, action] += 1
    self.visits[next_state] += 1
    v = 0.0 if terminated else max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (
        reward + self.discount * (self.bonus / self.visits[next_state] ** 0.5 + v) - self.Q[state, action]
    )


# %% exercise 3, wrong: the whole row learns
# says: 2 entries of `Q` change, and only one should
def learn(self, state, action, reward, next_state, terminated):
    self.tries[state, action] += 1
    self.visits[next_state] += 1
    v = 0.0 if terminated else max(self.Q[next_state])
    self.Q[state] += self.learning_rate * (
        reward + self.bonus / self.visits[next_state] ** 0.5 + self.discount * v - self.Q[state]
    )


# %% exercise 3, wrong: visits of both states
# says: 2 entries of `visits` change
def learn(self, state, action, reward, next_state, terminated):
    self.tries[state, action] += 1
    self.visits[next_state] += 1
    self.visits[state] += 1
    v = 0.0 if terminated else max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (
        reward + self.bonus / self.visits[next_state] ** 0.5 + self.discount * v - self.Q[state, action]
    )


# %% exercise 3, wrong: terminated replaced by a reward of 1
# says: a terminal state has no future
def learn(self, state, action, reward, next_state, terminated):
    self.tries[state, action] += 1
    self.visits[next_state] += 1
    v = 0.0 if reward == 1 else max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (
        reward + self.bonus / self.visits[next_state] ** 0.5 + self.discount * v - self.Q[state, action]
    )


# %% exercise 3, wrong: discount twice
# says: discounted twice
def learn(self, state, action, reward, next_state, terminated):
    self.tries[state, action] += 1
    self.visits[next_state] += 1
    v = 0.0 if terminated else self.discount * max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (
        reward + self.bonus / self.visits[next_state] ** 0.5 + self.discount * v - self.Q[state, action]
    )


# %% exercise 3, wrong: act returns in the loop
# says: a grip that was never tried comes first
def act(self, state, rng):
    for action in range(self.Q.shape[1]):
        if self.tries[state, action] == 0:
            return action
        return self.greedy(state, rng)


# %% exercise 3, wrong: greedy without rng
# says: greedy
def act(self, state, rng):
    for action in range(self.Q.shape[1]):
        if self.tries[state, action] == 0:
            return action
    return self.greedy(state)


# %% exercise 3, wrong: act prefers actions up to one try
# says: the *best* one counts
def act(self, state, rng):
    for action in range(self.Q.shape[1]):
        if self.tries[state, action] <= 1:
            return action
    return self.greedy(state, rng)


# %% exercise 3, wrong: decorated as static
# says: must have self as its first parameter
@staticmethod
def learn(state, action, reward, next_state, terminated):
    MyExplorer.visits[next_state] += 1


# %% exercise 3, wrong: counts the visit after it has divided
# says: the bonus comes from the old count, or from 1 at the first visit: count before you divide
def learn(self, state, action, reward, next_state, terminated):
    n = max(1, self.visits[next_state])  # not by zero
    target = reward + self.bonus / np.sqrt(n)
    if not terminated:
        target += self.discount * max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])
    self.visits[next_state] += 1
    self.tries[state, action] += 1


# %% exercise 3, wrong: one untried grip at most, by item
# says: `return int(np.where(self.tries[state] == 0)[0].item())` raises ValueError
def act(self, state, rng):
    if (self.tries[state] == 0).any():
        return int(np.where(self.tries[state] == 0)[0].item())
    return self.greedy(state, rng)


# %% exercise 3, wrong: only where one grip is left
# says: should choose a grip that was never tried, but chooses 0
def act(self, state, rng):
    if sum(self.tries[state] == 0) == 1:
        return int(self.tries[state].argmin())
    return self.greedy(state, rng)


# %% exercise 3, wrong: the count of the wrong state
# says: `visits` counts the state that was left; count the one that was *entered*, next_state
def learn(self, state, action, reward, next_state, terminated):
    self.visits[state] += 1
    self.tries[state, action] += 1
    bonus = self.bonus / max(self.visits[next_state], 0) ** 0.5
    future = 0.0 if terminated else self.discount * self.Q[next_state].max()
    self.Q[state, action] += self.learning_rate * (reward + bonus + future - self.Q[state, action])


# %% exercise 3, wrong: the bonus of the wrong state
# says: the bonus is that of the state that was left; it belongs to the one that was *entered*, next_state
def learn(self, state, action, reward, next_state, terminated):
    self.visits[next_state] += 1
    self.tries[state, action] += 1
    bonus = self.bonus / np.sqrt(self.visits[state])
    future = 0.0 if terminated else self.discount * self.Q[next_state].max()
    self.Q[state, action] += self.learning_rate * (reward + bonus + future - self.Q[state, action])


# %% exercise 3, wrong: the bonus of the action
# says: the bonus is computed from the number of tries of the action, n(s, a), and it should come from visits, n(s')
def learn(self, state, action, reward, next_state, terminated):
    self.visits[next_state] += 1
    self.tries[state, action] += 1
    bonus = self.bonus / np.sqrt(self.tries[state, action])
    future = 0.0 if terminated else self.discount * self.Q[next_state].max()
    self.Q[state, action] += self.learning_rate * (reward + bonus + future - self.Q[state, action])


# %% exercise 3, wrong: no count of states
# says: `visits` does not count
def learn(self, state, action, reward, next_state, terminated):
    self.tries[state, action] += 1
    bonus = self.bonus / np.sqrt(self.visits[next_state])
    future = 0.0 if terminated else self.discount * self.Q[next_state].max()
    self.Q[state, action] += self.learning_rate * (reward + bonus + future - self.Q[state, action])


# %% exercise 3, wrong: the last step is not counted
# says: `tries` does not change there, and every time it should be one more
def learn(self, state, action, reward, next_state, terminated):
    self.visits[next_state] += 1
    if not terminated:
        self.tries[state, action] += 1
    target = reward + self.bonus / np.sqrt(self.visits[next_state])
    if not terminated:
        target += self.discount * self.Q[next_state].max()
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: tries of the next state
# says: `tries` counts next_state; count the state in which the action was *taken*
def learn(self, state, action, reward, next_state, terminated):
    self.visits[next_state] += 1
    self.tries[next_state, action] += 1
    bonus = self.bonus / np.sqrt(self.visits[next_state])
    future = 0.0 if terminated else self.discount * self.Q[next_state].max()
    self.Q[state, action] += self.learning_rate * (reward + bonus + future - self.Q[state, action])


# %% exercise 3, wrong: indices exchanged
# says: state and action have changed places in `tries`
def learn(self, state, action, reward, next_state, terminated):
    self.visits[next_state] += 1
    self.tries[action % len(self.tries), state % self.tries.shape[1]] += 1
    bonus = self.bonus / np.sqrt(self.visits[next_state])
    future = 0.0 if terminated else self.discount * self.Q[next_state].max()
    self.Q[state, action] += self.learning_rate * (reward + bonus + future - self.Q[state, action])


# %% exercise 3, wrong: all is discounted
# says: the whole target is discounted; γ belongs to the value of the next state only
def learn(self, state, action, reward, next_state, terminated):
    self.visits[next_state] += 1
    self.tries[state, action] += 1
    bonus = self.bonus / np.sqrt(self.visits[next_state])
    future = 0.0 if terminated else self.Q[next_state].max()
    self.Q[state, action] += self.learning_rate * (self.discount * (reward + bonus + future) - self.Q[state, action])


# %% exercise 3, wrong: times the root
# says: the bonus grows with the count: it is β *divided* by √n
def learn(self, state, action, reward, next_state, terminated):
    self.visits[next_state] += 1
    self.tries[state, action] += 1
    bonus = self.bonus * np.sqrt(self.visits[next_state])
    future = 0.0 if terminated else self.discount * self.Q[next_state].max()
    self.Q[state, action] += self.learning_rate * (reward + bonus + future - self.Q[state, action])


# %% exercise 3, wrong: always the same bonus
# says: the bonus does not fade with the count: it is β/√n
def learn(self, state, action, reward, next_state, terminated):
    self.visits[next_state] += 1
    self.tries[state, action] += 1
    bonus = self.bonus
    future = 0.0 if terminated else self.discount * self.Q[next_state].max()
    self.Q[state, action] += self.learning_rate * (reward + bonus + future - self.Q[state, action])


# %% exercise 3, wrong: for the first visit
# says: only the first visit earns a bonus; every visit earns β/√n
def learn(self, state, action, reward, next_state, terminated):
    self.visits[next_state] += 1
    self.tries[state, action] += 1
    bonus = self.bonus if self.visits[next_state] == 1 else 0.0
    future = 0.0 if terminated else self.discount * self.Q[next_state].max()
    self.Q[state, action] += self.learning_rate * (reward + bonus + future - self.Q[state, action])


# %% exercise 3, wrong: a penalty
# says: the bonus is subtracted
def learn(self, state, action, reward, next_state, terminated):
    self.visits[next_state] += 1
    self.tries[state, action] += 1
    bonus = self.bonus / np.sqrt(self.visits[next_state])
    future = 0.0 if terminated else self.discount * self.Q[next_state].max()
    self.Q[state, action] += self.learning_rate * (reward - bonus + future - self.Q[state, action])


# %% exercise 3, wrong: no bonus
# says: the bonus is missing
def learn(self, state, action, reward, next_state, terminated):
    self.visits[next_state] += 1
    self.tries[state, action] += 1
    bonus = self.bonus / np.sqrt(self.visits[next_state])
    future = 0.0 if terminated else self.discount * self.Q[next_state].max()
    self.Q[state, action] += self.learning_rate * (reward + future - self.Q[state, action])


# %% exercise 3, wrong: no bonus at the end
# says: at the end of an episode the bonus is lost: only the *value of the next state* is 0 there
def learn(self, state, action, reward, next_state, terminated):
    self.visits[next_state] += 1
    self.tries[state, action] += 1
    bonus = 0.0 if terminated else self.bonus / np.sqrt(self.visits[next_state])
    future = 0.0 if terminated else self.discount * self.Q[next_state].max()
    self.Q[state, action] += self.learning_rate * (reward + bonus + future - self.Q[state, action])


# %% exercise 3, wrong: the worst once all are tried
# says: once all grips were tried the best one counts, and it takes the worst
def act(self, state, rng):
    untried = np.flatnonzero(self.tries[state] == 0)
    if len(untried):
        return int(untried[0])
    worst = np.flatnonzero(self.Q[state] == self.Q[state].min())
    return int(rng.choice(worst))


# %% exercise 3, wrong: the last of equals
# says: ties should be broken at random, and it takes the last of equals
def act(self, state, rng):
    untried = np.flatnonzero(self.tries[state] == 0)
    if len(untried):
        return int(untried[0])
    return int(np.flatnonzero(self.Q[state] == self.Q[state].max())[-1])


# %% exercise 4, right: a union of dictionaries
# says: Right. Runs that solve the lake: ε-greedy 0 of 5, novelty reward 0 of 5, Go-Explore 0 of 5, mine 0 of 5. Novelty
#   helps less here: a hole ends the episode and all later bonuses with it, and the reward, 14 steps away, is discounted
#   to a quarter of the first bonus.
frozen = repeat(
    lake,
    exploration.METHODS | {"mine": lambda e: QLearning.create(e, discount=0.9, initial_value=1.0)},
    20_000,
    repetitions=5,
)

# %% exercise 4, right: all labels written out
methods = {
    "mine": lambda e: GoExplore.create(e, learning_rate=0.5, discount=0.9, explore_steps=5),
    "Go-Explore": exploration.METHODS["Go-Explore"],
    "novelty reward": exploration.METHODS["novelty reward"],
    "ε-greedy": exploration.METHODS["ε-greedy"],
}
frozen = repeat(lake, methods, n_steps=20_000, repetitions=5)

# %% exercise 4, right: two of one's own
methods = dict(exploration.METHODS)
methods["SARSA"] = SARSA.create
methods["optimist"] = lambda e: QLearning.create(e, initial_value=1)
frozen = repeat(lake, methods, 20_000, repetitions=5, seed=3)


# %% exercise 4, right: an agent of one's own
class Sleeper(NamedTuple):
    Q: np.ndarray

    def act(self, state, rng):
        return 1

    def learn(self, state, action, reward):
        self.Q[state, action] = reward


frozen = repeat(lake, {**exploration.METHODS, "sleeper": lambda e: Sleeper(np.zeros((64, 4)))}, 20_000, repetitions=5)

# %% exercise 4, right: the id and its parameters
frozen = repeat(
    "FrozenLake-v1",
    {**exploration.METHODS, "mine": QLearning.create},
    20_000,
    repetitions=5,
    parameters={"map_name": "8x8", "is_slippery": False},
)


# %% exercise 4, right: a function that makes the lake
def make(layout_seed):
    return gym.make("FrozenLake-v1", map_name="8x8", is_slippery=False)


frozen = repeat(make(0), {**exploration.METHODS, "mine": CountBased.create}, 20_000, repetitions=5, jobs=1)

# %% exercise 4, right: one run after the other, more points
frozen = repeat(
    lake, {**exploration.METHODS, "mine": QLearning.create}, 20_000, repetitions=5, jobs=1, evaluate_every=500
)

# %% exercise 4, right: keyword arguments only
frozen = repeat(environment=lake, agents={**exploration.METHODS, "mine": SARSA.create}, n_steps=20_000, repetitions=5)

# %% exercise 4, wrong: nothing
# says: Not solved yet
frozen = None

# %% exercise 4, wrong: three methods
# says: frozen should have a fourth method, your own, beside the three of the lesson
frozen = repeat(lake, exploration.METHODS, 20_000, repetitions=5)

# %% exercise 4, wrong: one of the three again
# says: 'novelty reward' and 'mine' are the same agent
frozen = repeat(lake, {**exploration.METHODS, "mine": exploration.METHODS["novelty reward"]}, 20_000, repetitions=5)

# %% exercise 4, wrong: one agent under four names
# says: 'ε-greedy' and 'novelty reward' are the same agent
frozen = repeat(lake, {label: QLearning.create for label in [*exploration.METHODS, "mine"]}, 20_000, repetitions=5)

# %% exercise 4, wrong: other settings
# says: for 'ε-greedy' the learning_rate 0.5, but it has 0.1
frozen = repeat(
    lake, {**exploration.METHODS, "ε-greedy": QLearning.create, "mine": SARSA.create}, 20_000, repetitions=5
)

# %% exercise 4, wrong: 20 steps
# says: n_steps 20000, but it has n_steps 20
frozen = repeat(lake, {**exploration.METHODS, "mine": QLearning.create}, 20, repetitions=5)

# %% exercise 4, wrong: ten repetitions
# says: repetitions 5, but it has repetitions 10
frozen = repeat(lake, {**exploration.METHODS, "mine": QLearning.create}, 20_000)

# %% exercise 4, wrong: the wall
# says: environment FrozenLake-v1, but it has environment
frozen = repeat("Boulder", {**exploration.METHODS, "mine": QLearning.create}, 20_000, repetitions=5)

# %% exercise 4, wrong: the small lake
# says: map_name 8x8, but it has map_name 4x4
lake = gym.make("FrozenLake-v1", map_name="4x4", is_slippery=False)
frozen = repeat(lake, {**exploration.METHODS, "mine": QLearning.create}, 20_000, repetitions=5)

# %% exercise 4, wrong: a slippery lake
# says: is_slippery False, but it has is_slippery True
lake = gym.make("FrozenLake-v1", map_name="8x8", is_slippery=True)
frozen = repeat(lake, {**exploration.METHODS, "mine": QLearning.create}, 20_000, repetitions=5)

# %% exercise 4, wrong: only the two favourites
# says: should have the method 'novelty reward'
frozen = repeat(
    lake, {label: exploration.METHODS[label] for label in ("ε-greedy", "Go-Explore")}, 20_000, repetitions=5
)

# %% exercise 4, wrong: only the final returns
# says: should be what `repeat(...)` returns, but is of the type ndarray
frozen = repeat(lake, {**exploration.METHODS, "mine": QLearning.create}, 20_000, repetitions=5).final("mine")

# %% exercise 4, wrong: the table alone
# says: is of the type DataFrame
frozen = repeat(lake, {**exploration.METHODS, "mine": QLearning.create}, 20_000, repetitions=5).table

# %% exercise 4, wrong: the function
# says: call it
frozen = repeat

# %% exercise 4, wrong: the methods alone
# says: is of the type dict
frozen = {**exploration.METHODS}

# %% exercise 4, wrong: labels changed
# says: keep the labels
frozen = repeat(
    lake,
    {
        "greedy": exploration.METHODS["ε-greedy"],
        "novelty": exploration.METHODS["novelty reward"],
        "go": exploration.METHODS["Go-Explore"],
        "mine": QLearning.create,
    },
    20_000,
    repetitions=5,
)

# %% exercise 4, wrong: Go-Explore with another number of random steps
# says: explore_steps 20, but it has
frozen = repeat(
    lake,
    {
        **exploration.METHODS,
        "Go-Explore": lambda e: GoExplore.create(e, learning_rate=0.5, discount=0.9, explore_steps=40),
        "mine": QLearning.create,
    },
    20_000,
    repetitions=5,
)
