# %% a walk home
import gymnasium as gym
from gymnasium import spaces


class MyEnvironment(gym.Env):
    observation_space = spaces.Discrete(9)
    action_space = spaces.Discrete(2)

    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed)
        self.place, self.steps = int(self.np_random.integers(3, 6)), 0
        return self.place, {}

    def step(self, action):
        wind = self.np_random.random() < 0.2
        self.place += -1 if (action == 0) != wind else 1
        self.steps += 1
        over = self.place in (0, 8)
        return self.place, -1.0 if not over else 10.0 * (self.place == 8), over, self.steps == 50 and not over, {}


# %% a walk in the wind
import gymnasium
from gymnasium import spaces


class MyEnvironment(gymnasium.Env):
    def __init__(self):
        self.observation_space = spaces.Discrete(9)
        self.action_space = spaces.Discrete(2)
        self.steps = 0

    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed)
        self.place = int(self.np_random.integers(3, 6))
        self.steps = 0
        return self.place, {}

    def step(self, action):
        wind = self.np_random.random() < 0.2
        self.place += -1 if (action == 0) != wind else 1
        self.steps += 1
        over = self.place in (0, 8)
        return self.place, -1.0, over, self.steps == 50, {}


# %% a dictionary and two numbers
# slow
# in: a walk in the wind
# - self.observation_space = spaces.Discrete(9)
# + self.observation_space = spaces.Dict({"at": spaces.MultiDiscrete([9, 51]), "odd": spaces.Discrete(2)})
# - return self.place, {}
# + return {"at": np.array([self.place, 0]), "odd": self.place % 2}, {}
# - return self.place, -1.0, over, self.steps == 50, {}
# + return {"at": np.array([self.place, self.steps]), "odd": self.place % 2}, -1.0, over, self.steps == 50, {}

# %% a generator of its own
# in: a walk in the wind
# - super().reset(seed=seed)
# + super().reset(seed=seed)
# + if seed is not None or not hasattr(self, "rng"):
# +     self.rng = np.random.default_rng(seed)
# - self.place = int(self.np_random.integers(3, 6))
# + self.place = int(self.rng.integers(3, 6))
# - wind = self.np_random.random() < 0.2
# + wind = self.rng.random() < 0.2


# %% beside the problem that it should be
# says: Right: Gymnasium's checker passes it. Random play takes 8.0 steps and gets
#   -8.99. It plays like Morning.
import gymnasium as gym
from gymnasium import spaces

from edugym_course.lessons.own_problem.morning import Morning

DAY = Morning()


class ByHand(gym.Env):
    def __init__(self):
        self.observation_space = spaces.MultiDiscrete([9, 3])
        self.action_space = spaces.Discrete(3)

    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed)
        self.state = (0, 2)
        return np.array(self.state), {}

    def step(self, action):
        before = self.state
        self.state = DAY.transition(before, action, self.np_random)
        reward = DAY.reward(before, action, self.state, self.np_random)
        return np.array(self.state), reward, self.state[0] == 8, False, {}


MyEnvironment = (ByHand, DAY)


# %% without chance
# says: Right, if there is no chance in it (every seed gives the same episodes): Gymnasium's checker passes it. Random play takes 5.0 steps and gets 0.67.
import gymnasium as gym


class MyEnvironment(gym.Env):
    observation_space = gym.spaces.MultiDiscrete([6, 6])
    action_space = gym.spaces.Discrete(2)

    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed)
        self.step_number = self.place = 0
        return np.array([0, 0]), {}

    def step(self, action):
        self.step_number, self.place = self.step_number + 1, self.place + int(action)
        pays = 1.0 if self.place == 3 else 0.0
        return np.array([self.step_number, self.place]), pays, self.step_number == 5, False, {}


# %% beside a problem that draws otherwise
# slow
import gymnasium as gym
from gymnasium import spaces


class Queue:
    observation_space, action_space = spaces.MultiDiscrete([7, 6]), spaces.Discrete(2)

    def initial(self, rng):
        return 0, 2

    def transition(self, state, action, rng):
        return state[0] + 1, min(max(state[1] - action, 0) + int(rng.random() < 0.5), 5)

    def reward(self, state, action, next_state, rng):
        return -float(next_state[1]) - 0.5 * action

    def terminal(self, state):
        return state[0] == 6

    def observation(self, state, rng):
        return np.array(state)


class ByHand(gym.Env):
    observation_space, action_space = spaces.MultiDiscrete([7, 6]), spaces.Discrete(2)

    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed)
        self.hour, self.people = 0, 2
        return np.array([0, 2]), {}

    def step(self, action):
        arrivals = int(self.np_random.integers(2))
        self.hour, self.people = self.hour + 1, min(max(self.people - action, 0) + arrivals, 5)
        return np.array([self.hour, self.people]), -float(self.people) - 0.5 * action, self.hour == 6, False, {}


MyEnvironment = (ByHand, Queue())


# %% beside a problem of many places
# slow
import gymnasium as gym
from gymnasium import spaces


class Stock:
    observation_space, action_space = spaces.MultiDiscrete([25, 11]), spaces.Discrete(3)

    def initial(self, rng):
        return 0, 5

    def transition(self, state, action, rng):
        return state[0] + 1, max(min(state[1] + action, 10) - int(rng.integers(3)), 0)

    def reward(self, state, action, next_state, rng):
        last = -3.0 * next_state[1] if next_state[0] == 24 else 0.0
        return min(state[1], 2) - 0.5 * action + last

    def terminal(self, state):
        return state[0] == 24

    def observation(self, state, rng):
        return np.array(state)


class ByHand(gym.Env):
    observation_space, action_space = spaces.MultiDiscrete([25, 11]), spaces.Discrete(3)

    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed)
        self.hour, self.stock = 0, 5
        return np.array([0, 5]), {}

    def step(self, action):
        pays = min(self.stock, 2) - 0.5 * action
        wanted = int(self.np_random.choice(3))
        self.hour, self.stock = self.hour + 1, max(min(self.stock + action, 10) - wanted, 0)
        over = self.hour == 24
        if over:
            pays -= 3 * self.stock
        return np.array([self.hour, self.stock]), float(pays), over, False, {}


MyEnvironment = (ByHand, Stock())
