"""The players of lesson 5: Q-learning on windows, and one with the right memory."""

from collections.abc import Sequence
from functools import partial
from typing import Annotated, Any, NamedTuple

from edugym.agents.q_learning import QLearning
from edugym.agents.settings import Counter, Table, new
from edugym.agents.strategies import EpsilonGreedy
from edugym.envs.memory_corridor import MemoryCorridor
from edugym.experiments.repeat import repeat
from edugym.experiments.results.tables import Results
from edugym.experiments.results.tables import joined as joined  # for the modules beside this one
from edugym.mdp.frame_stack import FrameStack
from edugym.mdp.protocol import Integers, Random, Reals
from edugym_course.lessons.memory.windows import DOORS

N_STEPS = 1_000_000
LEARNING_RATE = 0.1
DISCOUNT = 0.8
EPSILON = 0.1


class Rememberer(NamedTuple):
    """A player with the right memory: it writes down each marked door, and walks through the corridor by its notes.

    Attributes:
        doors: shape (1000,): the right door at each place, as far as it has seen it.
        length: shape (1,): the length of the present corridor, less 1.
        position: shape (1,): its place in it.
    """

    doors: Annotated[Integers, Table((1_000,))]
    length: Counter
    position: Counter

    def act(self, state: int, rng: Random) -> int:
        """Note the marked door at the last place, and open the door in the notes."""
        position = int(self.position[0])
        if position == self.length[0]:
            self.doors[position] = state
            self.length[0] += 1
            self.position[0] = 0
        else:
            self.position[0] += 1
        return int(self.doors[position])

    def learn(self, terminated: bool, truncated: bool) -> None:
        """Start anew after the end of an episode."""
        if terminated or truncated:
            self.length[0] = self.position[0] = 0

    @classmethod
    def create(cls, environment: Any) -> "Rememberer":
        """Create a player without notes."""
        return new(cls, None, {})


def learn(
    k: int,
    actions: bool = False,
    *,
    n_steps: int = N_STEPS,
    learning_rate: float = LEARNING_RATE,
    discount: float = DISCOUNT,
    epsilon: float = EPSILON,
    num_doors: int = DOORS,
    **how: Any,
) -> Results:
    """Train Q-learning on stacks.

    Args:
        k: the number of observations in a stack.
        actions: whether the actions between them are shown too.
        n_steps: the training steps of each run.
        learning_rate: α.
        discount: γ.
        epsilon: ε of ε-greedy exploration.
        num_doors: the number of doors at every place.
        **how: more arguments of `edugym.experiments.repeat`, such as `repetitions`, `seed` and `jobs`.
    """
    task = FrameStack.create(MemoryCorridor.create(num_doors), k, actions=actions)
    return learn_on(task, name(k), n_steps, learning_rate, discount, epsilon, **how)


def learn_on(
    task: Any,
    label: str,
    n_steps: int = N_STEPS,
    learning_rate: float = LEARNING_RATE,
    discount: float = DISCOUNT,
    epsilon: float = EPSILON,
    **how: Any,
) -> Results:
    """Train Q-learning on a task under a label; arguments as in `learn`."""
    exploration = EpsilonGreedy(epsilon)
    make = partial(QLearning.create, learning_rate=learning_rate, discount=discount, exploration=exploration)
    how = {"evaluate_every": max(n_steps // 25, 1), "evaluation_episodes": 40, **how}
    return repeat(task, {label: make}, n_steps, **how)


def learn_all(windows: Sequence[int], actions: bool = False, **how: Any) -> Results:
    """Train Q-learning on several windows; arguments as in `learn`."""
    return joined([learn(k, actions and k > 1, **how) for k in windows])


def remember(**how: Any) -> Results:
    """Watch the player with the right memory for an episode."""
    max_steps = 1_000
    return repeat("MemoryCorridor", {"notes": Rememberer.create}, max_steps, evaluate_every=max_steps, **how)


def name(k: int) -> str:
    """Return the label of a stack."""
    return f"k = {k}"


def late(results: Results, label: str) -> Reals:
    """Return the mean of the last five evaluations of every run with a label, shape (n_repetitions,)."""
    return results.late(label)
