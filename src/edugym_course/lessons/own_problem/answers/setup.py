from gymnasium.spaces import Box

from edugym_course.lessons.own_problem.morning import Morning


class Plant(NamedTuple):
    """A plant that may dry out within ten days: the state is (day, water)."""

    days: int = 10
    action_space = property(lambda self: Discrete(2))
    observation_space = property(lambda self: MultiDiscrete([self.days + 1, 4]))

    def initial(self, rng):
        return 0, 2

    def transition(self, state, action, rng):
        day, water = state
        if action == 1:
            water = min(water + 2, 3)
        if rng.random() < 0.6:
            water = max(water - 1, 0)
        return day + 1, water

    def reward(self, state, action, next_state, rng):
        return (1.0 if 0 < next_state[1] < 3 else 0.0) - 0.2 * action

    def terminal(self, state):
        return state[0] == self.days or state[1] == 0

    def observation(self, state, rng):
        return state
