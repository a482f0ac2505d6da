# %% the constructor with all fields
# says: Right: it never takes a random action, and yet it tries everything, for whatever it tries disappoints it. See it
#   race:
def optimist(wall):
    Q = np.ones((wall.height + 1, wall.n_grips))
    return QLearning(Q, 0.5, 0.9, EpsilonGreedy(0.0))


# %% filled afterwards
def optimist(wall):
    agent = QLearning.create(wall, learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0))
    agent.Q[:] = 1
    return agent


# %% the greedy strategy, whole numbers
def optimist(wall):
    return QLearning.create(wall, learning_rate=1 / 2, discount=9 / 10, exploration=Greedy(), initial_value=1)


# %% by _replace
def optimist(wall):
    agent = QLearning.create(wall, initial_value=1.0)
    return agent._replace(learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0))


# %% settings in a dictionary
settings = dict(learning_rate=0.5, discount=0.9, initial_value=1.0)
optimist = lambda wall: QLearning.create(wall, exploration=EpsilonGreedy(epsilon=0.0), **settings)


# %% from the spaces
def optimist(environment, value=1.0):
    shape = int(environment.observation_space.n), int(environment.action_space.n)
    return QLearning.create(shape, learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0), initial_value=value)


# %% novelty without a bonus
def optimist(wall):
    return CountBased.create(wall, bonus=0.0, learning_rate=0.5, discount=0.9, exploration=Greedy(), initial_value=1.0)


# %% partial
from functools import partial

optimist = partial(QLearning.create, learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0), initial_value=1.0)


# %% an own class
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
