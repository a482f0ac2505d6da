# %% a plant
# says: A problem: 40 states, 2 actions, optimum 7.577.
my_problem = Plant()

# %% a plant for a month
my_problem = Plant(days=30)


# %% a gambler with whole numbers
class Gambler(NamedTuple):
    """Bet 1 or 2 coins, or stop."""

    goal: int = 6
    action_names = ("bet 1", "bet 2", "stop")
    observation_space = property(lambda self: Discrete(self.goal + 3))
    action_space = property(lambda self: Discrete(3))

    def initial(self, rng):
        return 3

    def transition(self, state, action, rng):
        if action == 2:
            return self.goal + 2
        stake = min(action + 1, state, self.goal - state)
        return state + stake if rng.random() < 0.45 else state - stake

    def reward(self, state, action, next_state, rng):
        if action == 2:
            return state / 2
        return 6.0 if next_state == self.goal else 0.0

    def terminal(self, state):
        return state == 0 or state >= self.goal

    def observation(self, state, rng):
        return state


my_problem = Gambler(goal=8)


# %% a queue, with the time in the state
class Tills(NamedTuple):
    """Open a second till when the queue gets long."""

    hours: int = 8
    observation_space = property(lambda self: MultiDiscrete([self.hours + 1, 7]))
    action_space = property(lambda self: Discrete(2))

    def initial(self, rng):
        return 0, 0

    def transition(self, state, action, rng):
        hour, waiting = state
        comes = 2 if rng.random() < 0.5 else 0
        return hour + 1, min(max(waiting + comes - 1 - action, 0), 6)

    def reward(self, state, action, next_state, rng):
        return -1.0 * next_state[1] - 1.5 * action

    def terminal(self, state):
        return state[0] == self.hours

    def observation(self, state, rng):
        return state


my_problem = Tills()


# %% a phone
class Phone(NamedTuple):
    """Charge the phone now, or use it."""

    hours: int = 12
    observation_space = property(lambda self: MultiDiscrete([self.hours + 1, 5]))
    action_space = property(lambda self: Discrete(2))

    def initial(self, rng):
        return (0, 4)

    def transition(self, state, action, rng):
        hour, battery = state
        if action == 1:
            return (hour + 1, min(battery + 2, 4))
        return (hour + 1, max(battery - int(rng.random() * 3), 0))

    def reward(self, state, action, next_state, rng):
        if next_state[1] == 0:
            return -5
        return 1 if action == 0 else 0

    def terminal(self, state):
        return state[0] == self.hours

    def observation(self, state, rng):
        return state


my_problem = Phone()


# %% a bus stop
class BusStop(NamedTuple):
    """Wait for the bus, or walk."""

    longest: int = 10
    action_names = ("wait", "walk")
    observation_space = property(lambda self: Discrete(self.longest + 2))
    action_space = property(lambda self: Discrete(2))

    def initial(self, rng):
        return 0

    def transition(self, state, action, rng):
        if action == 1:
            return self.longest + 1
        return self.longest + 1 if rng.random() < 0.1 + 0.05 * state else min(state + 1, self.longest)

    def reward(self, state, action, next_state, rng):
        return -4.0 if action == 1 else -1.0 - 0.5 * (state < 3)

    def terminal(self, state):
        return state == self.longest + 1

    def observation(self, state, rng):
        return state


my_problem = BusStop(longest=4)._replace(longest=6)


# %% a ferry, as small as can be
class Ferry(NamedTuple):
    """Buy a ticket or jump on board: at the gate (0), on the pier (1), left behind (2), on board (3)."""

    observation_space = property(lambda self: Discrete(4))
    action_space = property(lambda self: Discrete(2))

    def initial(self, rng):
        return 0

    def transition(self, state, action, rng):
        if action == 1:
            return 3 if rng.random() < (0.9 if state == 0 else 0.5) else 2
        return 1 if state == 0 else 3

    def reward(self, state, action, next_state, rng):
        return (1.0 if next_state == 3 else 0.0) - (0.2 if action == 0 else 0.0)

    def terminal(self, state):
        return state >= 2

    def observation(self, state, rng):
        return state


my_problem = Ferry()
