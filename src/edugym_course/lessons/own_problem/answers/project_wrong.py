# %% no Gymnasium
# says: MyEnvironment should inherit from gymnasium.Env: class MyEnvironment(gymnasium.Env)
# in: a walk in the wind
# - class MyEnvironment(gymnasium.Env):
# + class MyEnvironment:

# %% no space
# says: MyEnvironment should set self.
# says: in __init__, a space such as gymnasium.spaces.Discrete(4)
# in: a walk in the wind
# - self.observation_space = spaces.Discrete(9)
# + self.observation_space = 9

# %% numbers for actions
# says: the action space of MyEnvironment is
# says: , and it should be Discrete(n) with two actions or more
# in: a walk in the wind
# - self.action_space = spaces.Discrete(2)
# + self.action_space = spaces.Discrete(1)

# %% the observation alone
# says: reset should return two things, an observation and a dictionary, `return observation, {}`, but returns
# in: a walk in the wind
# - return self.place, {}
# + return self.place

# %% four things
# says: ) should return five things, observation, reward, terminated, truncated and a dictionary, but returns
# in: a walk in the wind
# - return self.place, -1.0, over, self.steps == 50, {}
# + return self.place, -1.0, over, {}

# %% a number for an end
# says: ) should say by True or False whether it is
# says:  but says
# in: a walk in the wind
# - return self.place, -1.0, over, self.steps == 50, {}
# + return self.place, -1.0, over, 0, {}

# %% too far
# says: gives the observation
# says: , which is not in the observation space
# says: : is the space too small, should the episode have ended before, or should reset set this anew?
# in: a walk in the wind
# - self.observation_space = spaces.Discrete(9)
# + self.observation_space = spaces.Discrete(8)

# %% a list
# says: : it has the shape (), and an element of the space has (1,)
# in: a walk in the wind
# - self.observation_space = spaces.Discrete(9)
# + self.observation_space = spaces.MultiDiscrete([9])
# - return self.place, {}
# + return [self.place], {}

# %% no end
# says: an episode of MyEnvironment has not ended after 10000 steps, of random actions or of one action again and again: when is `terminated` or `truncated` True?
# in: a walk in the wind
# - self.place += -1 if (action == 0) != wind else 1
# + self.place = 3 + action
# - over = self.place in (0, 8)
# - return self.place, -1.0, over, self.steps == 50, {}
# + over = False
# + return self.place, -1.0, over, False, {}

# %% chance of its own
# says: two environments with seed 0 and the same actions differ: begin reset with super().reset(seed=seed), draw all random numbers from the self.np_random that it makes, and keep nothing in the class itself
# in: a walk in the wind
# - wind = self.np_random.random() < 0.2
# + wind = np.random.default_rng().random() < 0.2

# %% the clock goes on
# says: episodes reset(seed=0) begins another episode than in a new environment: reset must set everything anew that an episode changes, and all random numbers should come from self.np_random
# in: a walk in the wind
# - self.place = int(self.np_random.integers(3, 6))
# - self.steps = 0
# + self.place = int(self.np_random.integers(3, 6))
# - return self.place, -1.0, over, self.steps == 50, {}
# + return self.place, -1.0, over, self.steps >= 60, {}

# %% nothing to decide
# says: whatever the actions are, the same is observed and paid: what should the agent decide?
# in: a walk in the wind
# - self.place += -1 if (action == 0) != wind else 1
# + self.place += -1 if wind else 1

# %% one array for ever
# says: Gymnasium's check_env
# in: a walk in the wind
# - self.observation_space = spaces.Discrete(9)
# + self.observation_space = spaces.MultiDiscrete([9])
# - self.place = int(self.np_random.integers(3, 6))
# + self.place = np.zeros(1, int)
# + self.place[0] = self.np_random.integers(3, 6)
# - over = self.place in (0, 8)
# + over = bool(self.place[0] in (0, 8))

# %% no reward
# says: ) gives None as the reward, the second of the five: it should be a number
# in: a walk in the wind
# - return self.place, -1.0, over, self.steps == 50, {}
# + return self.place, None, over, self.steps == 50, {}


# %% numbers of 64 bits
# says: : make an array of its kind of numbers, np.array(..., dtype=np.
import gymnasium
from gymnasium import spaces


class MyEnvironment(gymnasium.Env):
    def __init__(self):
        self.observation_space = spaces.Box(0.0, 8.0, (1,))
        self.action_space = spaces.Discrete(2)

    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed)
        self.place = 4.0
        return np.array([self.place]), {}

    def step(self, action):
        wind = self.np_random.random() < 0.2
        self.place += -1 if (action == 0) != wind else 1
        return np.array([self.place]), -1.0, self.place in (0, 8), False, {}


# %% the reward in an array
# says: the reward
# says: should be one number, but is a ndarray of shape (1,)
import gymnasium
from gymnasium import spaces


class MyEnvironment(gymnasium.Env):
    def __init__(self):
        self.observation_space = spaces.Discrete(9)
        self.action_space = spaces.Discrete(2)

    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed)
        self.place = 4
        return self.place, {}

    def step(self, action):
        wind = self.np_random.random() < 0.2
        self.place += -1 if (action == 0) != wind else 1
        return self.place, np.array([-1.0]), self.place in (0, 8), False, {}


# %% the reward first
# says: : the observation is the first of the five things, and the reward the second
# in: a walk in the wind
# - return self.place, -1.0, over, self.steps == 50, {}
# + return -1.0, self.place, over, self.steps == 50, {}

# %% beside its problem: she dozes
# says: MyEnvironment and your problem differ: an episode begins with (0, 1) in MyEnvironment, and with (0, 2) in your
#   problem: do both observe the same, in the same form?
# in: beside the problem that it should be
# - self.state = (0, 2)
# + self.state = (0, 1)

# %% beside its problem: paid twice
# says: MyEnvironment and your problem differ: after the action 0 at the observation (0, 2), the reward is 4 on average in MyEnvironment, and 2 in your
#   problem
# in: beside the problem that it should be
# - return np.array(self.state), reward, self.state[0] == 8, False, {}
# + return np.array(self.state), 2 * reward, self.state[0] == 8, False, {}

# %% beside its problem: no chime
# says: after the action 1 at the observation (0, 2), there follows (1, 1) in 0% of all cases in MyEnvironment, and in 7
# in: beside the problem that it should be
# - self.state = DAY.transition(before, action, self.np_random)
# + self.state = DAY.transition(before, 0 if action == 1 else action, self.np_random)

# %% beside its problem: the clock stops her
# slow
# says: it terminates
# says: at the observation (7, 0), it terminates in 0% of all cases in MyEnvironment, and in 100% in your problem
# in: beside the problem that it should be
# - return np.array(self.state), reward, self.state[0] == 8, False, {}
# + return np.array(self.state), reward, False, self.state[0] == 8, {}

# %% beside its problem: a fourth action
# says: MyEnvironment and your problem differ: in 20000 random steps the action 3 is taken at the observation (0, 2)
# says:  times in MyEnvironment, and 0 times in your problem
# in: beside the problem that it should be
# - self.action_space = spaces.Discrete(3)
# + self.action_space = spaces.Discrete(4)

# %% beside its problem: a third thing
# says: check MyEnvironment alone, or two things, (MyEnvironment, my_problem), but here are 3
# in: beside the problem that it should be
# - MyEnvironment = (ByHand, DAY)
# + MyEnvironment = (ByHand, DAY, 1)

# %% beside its problem: no problem
# says: my_problem must be an MDP, a value with the methods
# in: beside the problem that it should be
# - MyEnvironment = (ByHand, DAY)
# + MyEnvironment = [ByHand, None]

# %% beside its problem: one with real actions
# says: the actions of my_problem should be numbered, but are
# in: beside the problem that it should be
# - MyEnvironment = (ByHand, DAY)
# + import edugym
# + MyEnvironment = (ByHand, edugym.make_mdp("Trashbot"))

# %% beside its problem: no end penalty
# slow
# says: there follows
# says:  with the reward
# says:  and the end
# says: , and in your problem
# in: beside a problem of many places
# - if over:
# -     pays -= 3 * self.stock

# %% beside its problem: a smaller store
# slow
# in: beside a problem of many places
# says: , and in your problem
# - self.hour, self.stock = self.hour + 1, max(min(self.stock + action, 10) - wanted, 0)
# + self.hour, self.stock = self.hour + 1, max(min(self.stock + action, 9) - wanted, 0)

# %% beside its problem: other customers
# slow
# says: chance is another in many places; in one of them,
# says:  there follows
# says:  cases in
# says: % in your problem
# in: beside a problem of many places
# - wanted = int(self.np_random.choice(3))
# + wanted = int(self.np_random.choice(3, p=[0.4, 0.3, 0.3]))

# %% beside its problem: more than it can hold
# slow
# says: in MyEnvironment, and in your problem there follows
# in: beside a problem of many places
# - self.hour, self.stock = self.hour + 1, max(min(self.stock + action, 10) - wanted, 0)
# + self.hour, self.stock = self.hour + 1, max(min(self.stock + action, 10) - wanted, 0 if self.hour % 2 else 1)

# %% beside its problem: observed otherwise
# slow
# says: an episode begins with
# says: : do both observe the same, in the same form?
# in: beside a problem of many places
# - return np.array([0, 5]), {}
# + return np.array([5, 0]), {}

# %% beside its problem: no end penalty, where a reward is drawn
# slow
# says: random play gets
# says:  in an episode of
# in: beside a problem of many places
# - return min(state[1], 2) - 0.5 * action + last
# + return min(state[1], 2) - 0.5 * action + last + rng.random()
# - if over:
# -     pays -= 3 * self.stock
# + pays += self.np_random.random()

# %% beside its problem: begins elsewhere now and then
# slow
# says: % of all cases in
# says: an episode begins with
# in: beside a problem of many places
# - self.hour, self.stock = 0, 5
# - return np.array([0, 5]), {}
# + self.hour, self.stock = 0, 5 + int(self.np_random.random() < 0.1)
# + return np.array([0, self.stock]), {}

# %% beside its problem: one number for both
# says: an episode begins with the observation
# says:  in your problem: to be compared they should have one form
# in: beside a problem of many places
# - return np.array([0, 5]), {}
# + return 5, {}
# - return np.array([self.hour, self.stock]), float(pays), over, False, {}
# + return 11 * self.hour + self.stock, float(pays), over, False, {}
# - MyEnvironment = (ByHand, Stock())
# + ByHand.observation_space = spaces.Discrete(275)
# + MyEnvironment = (ByHand, Stock())

# %% all environments have one state
# slow
# says: an episode changes when another environment of the same class plays beside it: all that changes belongs to the object. Set it in reset, as self.state = [...], change no list or number of the class, and draw from self.np_random alone, after super().reset(seed=seed)
# in: a walk in the wind
# - self.place = int(self.np_random.integers(3, 6))
# - self.steps = 0
# + type(self).place, type(self).steps = int(self.np_random.integers(3, 6)), 0
# - self.place += -1 if (action == 0) != wind else 1
# + type(self).place += -1 if (action == 0) != wind else 1

# %% a float for a number
# says: : it should be one whole number, an int
# in: a walk in the wind
# - return self.place, {}
# + return float(self.place), {}

# %% one action never ends
# slow
# says: an episode of MyEnvironment has not ended after 10000 steps, of random actions or of one action again and again: when is `terminated` or `truncated` True?
# in: a walk in the wind
# - self.place += -1 if (action == 0) != wind else 1
# + self.place = min(max(self.place + (0 if action == 1 else -1 if wind else 1), 0), 8)
# - return self.place, -1.0, over, self.steps == 50, {}
# + return self.place, -1.0, over, False, {}

# %% the same luck in each episode
# slow
# says:  episodes that begin with reset(), without a seed, are all the same, and with other seeds they differ: seed is None then, def reset(self, *, seed=None, options=None), and super().reset(seed=seed) gets it as it is; self.np_random goes on
# in: a walk in the wind
# - super().reset(seed=seed)
# + super().reset(seed=seed or 0)

# %% the same seed by default
# says: the same, and with other seeds they differ: seed is None then, def reset(self, *, seed=None, options=None)
# in: a walk in the wind
# - def reset(self, *, seed=None, options=None):
# + def reset(self, *, seed=0, options=None):

# %% a part out of its space
# says: : does each of its parts lie in the space of that part?
# in: a walk in the wind
# - self.observation_space = spaces.Discrete(9)
# + self.observation_space = spaces.Dict({"at": spaces.MultiDiscrete([9, 51]), "odd": spaces.Discrete(2)})
# - return self.place, {}
# + return {"at": np.array([self.place, 0]), "odd": self.place}, {}

# %% truncated by NumPy
# says: of NumPy whether it is truncated, and Gymnasium's checker wants True or False of Python: bool(...)
# in: a walk in the wind
# - return self.place, -1.0, over, self.steps == 50, {}
# + return self.place, -1.0, over, np.int64(self.steps) == 50, {}

# %% truncated at once
# slow
# says: is that step `terminated`, and not truncated? Have the two changed places?
# in: a walk in the wind
# - return self.place, -1.0, over, self.steps == 50, {}
# + return self.place, -1.0, False, True, {}

# %% the place is kept sometimes
# slow
# says: episodes reset(seed=0) begins another episode than in a new environment
# in: a walk in the wind
# - self.place = int(self.np_random.integers(3, 6))
# - self.steps = 0
# + self.place = int(self.np_random.integers(3, 6)) if self.steps != 7 else 4
# + self.steps = 0

# %% another generator now and then
# slow
# says: two environments with seed 0 and the same actions differ
# in: a walk in the wind
# - wind = self.np_random.random() < 0.2
# + wind = self.np_random.random() < 0.2 if self.place != 7 else np.random.random() < 0.2

# %% the steps are counted on
# says:  episodes reset() begins another one than in a new environment: also without a seed, it must set everything anew that an episode changes
# in: a walk in the wind
# - self.steps = 0
# - return self.place, {}
# + if seed is not None or self.steps == 50:
# +     self.steps = 0
# + return self.place, {}

# %% actions of Python alone
# says: with actions such as np.int64(
# says: ) in place of
# says:  other episodes come. Agents often choose whole numbers of NumPy, so compare an action by `==`, not by `is`, and do not ask for its type
# in: a walk in the wind
# - self.place += -1 if (action == 0) != wind else 1
# + self.place += -1 if (isinstance(action, int) and action == 0) != wind else 1
