"""A student's task whose states hold arrays, from a notebook cell."""

TRAIL = """
class Trail(NamedTuple):
    steps: np.ndarray
    length: int

class Trails(NamedTuple):
    size: int
    max_steps: int = 12

    observation_space = property(lambda self: spaces.MultiDiscrete([self.size + 1, 3]))
    action_space = property(lambda self: spaces.Discrete(2))
    def initial(self, rng): return Trail(np.zeros(1, np.int64), 0)
    def transition(self, state, action, rng):
        longer = np.empty(len(state.steps) + 1, np.int64)
        longer[:-1] = state.steps
        longer[-1] = action + int(rng.random() * 2)
        return Trail(longer, state.length + 1)
    def reward(self, state, action, next_state, rng): return float(next_state.steps[-1]) + rng.normal(0.0, 0.1)
    def terminal(self, state): return len(state.steps) > self.size
    def observation(self, state, rng): return state.length, int(state.steps[-1])
"""
"""A student's task whose state holds an array that grows, with noise in everything."""
