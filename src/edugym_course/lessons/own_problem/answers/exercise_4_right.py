# %% a plant
# says: A problem: 40 states, 2 actions, optimum 7.577.
my_problem = Plant()


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
