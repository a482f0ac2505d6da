"""The worked example of lesson 10: an alarm clock that learns when to wake a sleeper, and rewards for it."""

from typing import Any, NamedTuple

from gymnasium import spaces

from edugym.mdp.protocol import Random, Reals
from edugym.mdp.wrapper import wrapper
from edugym.rendering.scene import Scene
from edugym_course.lessons.own_problem.bedroom import bedroom

QUIET, CHIME, RING = 0, 1, 2
AWAKE, DOZING, ASLEEP = 0, 1, 2

State = tuple[int, int]


class Morning(NamedTuple):
    """Let her sleep as long as possible, and have her awake at half past eight.

    The state is (time, depth): the steps of ten minutes that have passed, and how deep she sleeps: 0 is awake, 1 dozing
    and 2 fast asleep. The lesson writes the same class in a cell.

    Attributes:
        length: T, the steps of the episode.
        ring: what each loud ring costs.
        late: what it costs when she is not awake at the end.
    """

    length: int = 8
    ring: float = 4.0
    late: float = 10.0

    @property
    def observation_space(self) -> spaces.MultiDiscrete:
        """The time, and the depth of sleep."""
        return spaces.MultiDiscrete([self.length + 1, 3])

    @property
    def action_space(self) -> spaces.Discrete:
        """Stay quiet, chime softly, ring loudly."""
        return spaces.Discrete(3)

    @property
    def action_names(self) -> tuple[str, ...]:
        """What the clock can do."""
        return "stay quiet", "chime", "ring"

    def initial(self, rng: Random) -> State:
        """Ten past seven: she is fast asleep."""
        return 0, 2

    def transition(self, state: State, action: int, rng: Random) -> State:
        """A ring nearly always wakes her; a chime makes her sleep lighter; in silence her sleep gets deeper."""
        time, depth = state
        luck = rng.random()
        if action == 2:
            depth = 0 if luck < 0.9 else max(depth - 1, 0)
        elif action == 1:
            depth = max(depth - 1, 0) if luck < 0.7 else depth
        else:
            depth = min(depth + 1, 2) if luck < 0.5 else depth
        return time + 1, depth

    def reward(self, state: State, action: int, next_state: State, rng: Random) -> float:
        """Sleep is worth its depth; a ring costs, and so does oversleeping."""
        time, depth = next_state
        reward = float(depth)
        if action == 2:
            reward -= self.ring
        if time == self.length and depth > 0:
            reward -= self.late
        return reward

    def terminal(self, state: State) -> bool:
        """At half past eight."""
        return state[0] == self.length

    def observation(self, state: State, rng: Random) -> State:
        """The whole state."""
        return state

    def scene(self, state: State, last_action: int | None = None) -> Scene:
        """Draw the bedroom."""
        return bedroom(state[0], state[1], self.length, last_action)


class PaidForWakefulness(Morning):
    """A careless reward: 2 for every ten minutes in which she is awake, less the cost of rings."""

    __slots__ = ()

    def reward(self, state: State, action: int, next_state: State, rng: Random) -> float:
        """Return 2 when she is awake, less the cost of a ring."""
        reward = 2.0 if next_state[1] == 0 else 0.0
        return reward - self.ring if action == 2 else reward


@wrapper
class WithBonus(NamedTuple):
    """A careless addition to the reward: a bonus each time she wakes.

    Attributes:
        mdp: the morning.
        bonus: how much.
    """

    mdp: Any
    bonus: float = 10.0

    def reward(self, state: State, action: int, next_state: State, rng: Random) -> float:
        """Add the bonus when she was not awake and is now."""
        bonus = self.bonus if state[1] > 0 and next_state[1] == 0 else 0.0
        reward: float = self.mdp.reward(state, action, next_state, rng) + bonus
        return reward


@wrapper
class WithPotential(NamedTuple):
    """A shaping reward that changes no optimal policy: γ φ(s') - φ(s).

    Attributes:
        mdp: the morning.
        phi: shape (T + 1, 3): the potential φ of every state, by time and depth; 0 at the end.
        discount: γ.
    """

    mdp: Any
    phi: Reals
    discount: float = 1.0

    def potential(self, state: State) -> float:
        """Return φ(s)."""
        return float(self.phi[state[0], state[1]])

    def reward(self, state: State, action: int, next_state: State, rng: Random) -> float:
        """Add what the potential gains."""
        gain = self.discount * self.potential(next_state) - self.potential(state)
        reward: float = self.mdp.reward(state, action, next_state, rng) + gain
        return reward
