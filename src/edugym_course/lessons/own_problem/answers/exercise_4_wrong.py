# %% a queue with a step limit
# says: my_problem has `max_steps`, so the best action depends on how many steps are left: keep the time in the state,
#   and end the episode by `terminal`, as Morning does
# in: a ferry, as small as can be
# - class Ferry(NamedTuple):
# -     """Buy a ticket or jump on board: at the gate (0), on the pier (1), left behind (2), on board (3)."""
# + class Queue(NamedTuple):
# +     """Open a second till when the queue gets long."""
# - observation_space = property(lambda self: Discrete(4))
# + max_steps: int = 20
# + observation_space = property(lambda self: Discrete(7))
# - if action == 1:
# -     return 3 if rng.random() < (0.9 if state == 0 else 0.5) else 2
# - return 1 if state == 0 else 3
# + comes = 2 if rng.random() < 0.5 else 0
# + return min(max(state + comes - 1 - action, 0), 6)
# - return (1.0 if next_state == 3 else 0.0) - (0.2 if action == 0 else 0.0)
# + return -1.0 * next_state - 1.5 * action
# - return state >= 2
# + return False
# - my_problem = Ferry()
# + my_problem = Queue()


# %% the placeholder
# says: Not solved yet
my_problem = ...

# %% the template
# says: that is the problem with which the cell began: write one of your own, under its own name
my_problem = Template(days=8)


# %% the template, renamed, with other numbers
# says: that is the problem with which the cell began: write one of your own, under its own name
class Offers(NamedTuple):
    """A house within ten days."""

    weeks: int = 10

    action_names = ("hold", "let go")
    action_space = property(lambda self: Discrete(2))
    observation_space = property(lambda self: MultiDiscrete([self.weeks + 1, 5]))

    def initial(self, rng):
        return 0, 1 + int(rng.random() * 4)

    def transition(self, state, action, rng):
        week, _ = state
        return (week, 0) if action == 1 else (week + 1, 1 + int(rng.random() * 4))

    def reward(self, state, action, next_state, rng):
        return float(state[1]) if action == 1 else 0.0

    def terminal(self, state):
        return state[1] == 0 or state[0] == self.weeks

    def observation(self, state, rng):
        return state


my_problem = Offers()


# %% the problem of the lesson
# says: that is the problem of the lesson: write one of your own, under its own name
my_problem = Morning(late=20.0)


# %% the problem of the lesson, renamed
# says: that is the problem of the lesson: write one of your own, under its own name
class Awake(NamedTuple):
    late: float = 20.0
    transition, reward = Morning.transition, Morning.reward


my_problem = Awake()


# %% the sleeper of exercise 3
# says: that is the sleeper of exercise 3: write a problem of your own, under its own name
class UsedToIt(Morning):
    pass


my_problem = UsedToIt()


# %% nothing to choose
# says: my_problem should have two actions and four states or more, but has 1 and
class Watched(Plant):
    __slots__ = ()
    action_space = property(lambda self: Discrete(1))


my_problem = Watched()


# %% a name
# says: is the name
my_problem = "Boulder"


# %% no NamedTuple
# says: should inherit from NamedTuple, as the form does: class
# says: (NamedTuple), with its numbers as fields and without __init__
class Plain:
    days = 3
    action_space = Discrete(2)
    observation_space = MultiDiscrete([4, 2])

    def initial(self, rng):
        return 0, 0

    def transition(self, state, action, rng):
        return state[0] + 1, int(rng.random() < 0.5)

    def reward(self, state, action, next_state, rng):
        return 1.0 * (action == state[1])

    def terminal(self, state):
        return state[0] == self.days

    def observation(self, state, rng):
        return state


my_problem = Plain()


# %% a queue without end
# slow
# says: states: does a number in its state grow without end? Give it a largest value, for example by min(queue + 1, 10)
# says: my_problem has more than
class Queue(NamedTuple):
    action_space = property(lambda self: Discrete(2))
    observation_space = property(lambda self: MultiDiscrete([1_000_000, 2]))

    def initial(self, rng):
        return 1, 0

    def transition(self, state, action, rng):
        return state[0] + int(rng.random() < 0.6) - action, int(rng.random() * 2)

    def reward(self, state, action, next_state, rng):
        return -1.0 * state[0]

    def terminal(self, state):
        return state[0] < 1

    def observation(self, state, rng):
        return state


my_problem = Queue()


# %% no chance
# says: my_problem should have chance in its dynamics: use `rng` in `transition`
class Sure(Plant):
    __slots__ = ()

    def transition(self, state, action, rng):
        day, water = state
        return day + 1, max(min(water + 2 * action, 3) - 1, 0)


my_problem = Sure()


# %% one name too few
# says: action_names of Named must have a name for each action
class Named(Plant):
    __slots__ = ()
    action_names = ("wait",)


my_problem = Named()


# %% the actions do nothing
# says: the best policy of my_problem earns no more than random actions: do the actions matter?
class Weather(Plant):
    __slots__ = ()

    def transition(self, state, action, rng):
        return state[0] + 1, int(rng.random() * 4)

    def reward(self, state, action, next_state, rng):
        return 1.0 * next_state[1]


my_problem = Weather()


# %% watering is free
# says: is best in every state, so there is nothing to decide: give it a price, or lower that of another one
# says: in my_problem the action
class Free(Plant):
    __slots__ = ()

    def reward(self, state, action, next_state, rng):
        return 1.0 * next_state[1]


my_problem = Free()


# %% one reward for everything
# says: every transition of my_problem has the same reward, so all policies are equal
class Flat(Plant):
    __slots__ = ()

    def reward(self, state, action, next_state, rng):
        return 0.0


my_problem = Flat()


# %% states with fractions
# says: no finite model
class Fine(Plant):
    __slots__ = ()
    observation_space = property(lambda self: Box(0.0, 100.0, (2,)))

    def transition(self, state, action, rng):
        return state[0] + 1, state[1] + rng.random()

    def observation(self, state, rng):
        return np.array(state, np.float32)


my_problem = Fine()


# %% a pile without a limit
# says: observation of Dishes must return an element of MultiDiscrete([7 4]), but returned (4, 4) for state (4, 4)
# says: : is it made of whole numbers, is the space large enough, and is `terminal` True in time?
class Dishes(NamedTuple):
    """Wash up, or let the dishes pile up: the state is (evening, pile)."""

    evenings: int = 6
    action_space = property(lambda self: Discrete(2))
    observation_space = property(lambda self: MultiDiscrete([self.evenings + 1, 4]))

    def initial(self, rng):
        return 0, 0

    def transition(self, state, action, rng):
        evening, pile = state
        return evening + 1, max(pile - action, 0) + int(rng.random() < 0.5)

    def reward(self, state, action, next_state, rng):
        return -float(state[1]) - 0.8 * action

    def terminal(self, state):
        return state[0] == self.evenings

    def observation(self, state, rng):
        return state


my_problem = Dishes()


# %% charging takes no time
# says: an episode of my_problem may go on for ever, for example by
# says: : an end should come whatever the actions are, so keep a deadline in the state, like the time of the morning
class Lazy(Plant):
    __slots__ = ()

    def transition(self, state, action, rng):
        day, water = state
        if action == 1:
            return day, min(water + 2, 3)
        return day + 1, max(water - int(rng.random() < 0.6), 0)

    def reward(self, state, action, next_state, rng):
        return (1.0 if 0 < next_state[1] < 3 and action == 0 else 0.0) - 0.2 * action


my_problem = Lazy()


# %% observations that are no whole numbers
# says: a table needs observations that are whole numbers, but the observation space is Box
class Measured(Plant):
    __slots__ = ()
    observation_space = property(lambda self: Box(0.0, 100.0, (2,)))

    def observation(self, state, rng):
        return np.array(state, np.float32)


my_problem = Measured()
