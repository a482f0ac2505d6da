# %% the constructor with all fields
# says: Right: it never takes a random action, and yet it tries everything, for all that it tries below the top disappoints it. See it
#   race:
def optimist(wall):
    Q = np.ones((wall.height + 1, wall.n_grips))
    return QLearning(Q, 0.5, 0.9, EpsilonGreedy(0.0))


# %% the greedy strategy, whole numbers
def optimist(wall):
    return QLearning.create(wall, learning_rate=1 / 2, discount=9 / 10, exploration=Greedy(), initial_value=1)


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


# %% a plain class, called with the wall
class Opt:
    def __init__(self, wall):
        self.Q = np.ones((wall.observation_space.n, wall.action_space.n))

    def act(self, state, rng):
        best = np.flatnonzero(self.Q[state] == self.Q[state].max())
        return int(rng.choice(best))

    def learn(self, state, action, reward, next_state, terminated):
        target = reward if terminated else reward + 0.9 * self.Q[next_state].max()
        self.Q[state, action] += 0.5 * (target - self.Q[state, action])


optimist = Opt
