"""The project of lesson 0b: ε-greedy with sample averages, from a blank file."""

from collections import Counter
from functools import partial
from typing import Any, NamedTuple

import gymnasium
import numpy as np
from gymnasium import spaces

from edugym.adapters.registration import make_environment
from edugym.agents.q_learning import QLearning
from edugym.agents.sample_average import SampleAverage
from edugym.mdp.protocol import Reals
from edugym_course.grading.curves import Race, compare_with_ours, program_of
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.programs import APART, Step, run_program
from edugym_course.grading.replay import LOW, Learner, Rule, mistakes_of_loops
from edugym_course.lessons.bandits.methods import EPSILON, LEARNING_RATE

N_STEPS, PULLS = 3_000, 100
FIRST_PULLS = 30
"""In so many runs the first arm is looked at: who breaks ties at random does not pull the same one in most of them."""
MOST_ALIKE = 0.6
FIRST = 1e9
"""The value of an arm that is pulled before all others."""


class Machines(gymnasium.Env[Any, Any]):
    """Four arms with rewards around means of their own; episodes end after 40 pulls.

    In every second world all means are below 0. An arm that was never pulled looks best there, with its value of 0.

    Args:
        seed: the number from which the means are drawn, and which says whether they are below 0.
        truncates: whether an end is a truncation.
        noisy: whether rewards also depend on chance.
    """

    def __init__(self, seed: int, truncates: bool = True, noisy: bool = True) -> None:
        """Draw the means."""
        rng = np.random.default_rng(APART + seed)
        self.observation_space, self.action_space = spaces.Discrete(1), spaces.Discrete(4)
        self._means: Reals = rng.permutation([-0.5, 0.5, 0.8, 1.0]) - 2.0 * (seed % 2)
        self._truncates, self._noise, self._pulls = truncates, 2.0 * noisy, 0

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[int, dict[str, Any]]:
        """Begin an episode; the arms stay the same."""
        super().reset(seed=seed)
        self._pulls = 0
        return 0, {}

    def step(self, action: int) -> tuple[int, float, bool, bool, dict[str, Any]]:
        """Pull an arm."""
        self._pulls += 1
        reward = float(self._means[action] + self._noise * self.np_random.normal())
        over = self._pulls == 40
        return 0, reward, over and not self._truncates, over and self._truncates, {}


class Counting(NamedTuple):
    """Sample averages with a mistake.

    Attributes:
        Q: shape (1, n_arms): the values.
        N: shape (1, n_arms): the pulls.
        plus: what is added to the number of pulls before the mean moves.
        shared: whether the pulls of all arms count for each.
        sums: whether rewards are added up, and not averaged.
        counts: whether the arm that was pulled most looks best.
        tries: whether each arm is pulled once before anything else.
        only: whether it learns only from the arms that look best.
    """

    Q: Reals
    N: Reals
    plus: float = 0.0
    shared: bool = False
    sums: bool = False
    counts: bool = False
    tries: bool = False
    only: bool = False

    def values(self, state: int) -> Reals:
        """What the arms look worth."""
        if self.counts:
            pulls: Reals = self.N[state]
            return pulls
        table: Reals = np.where((self.N[state] == 0) & self.tries, FIRST, self.Q[state])
        return table

    def act(self, state: int, rng: np.random.Generator) -> int:
        """ε-greedy."""
        values = self.values(state)
        if rng.random() < EPSILON:
            return int(rng.integers(len(values)))
        return int(rng.choice(np.flatnonzero(values == values.max())))

    def greedy(self, state: int, rng: np.random.Generator) -> int:
        """The arm that looks best."""
        return int(self.values(state).argmax())

    def learn(self, state: int, action: int, reward: float) -> None:
        """Move the value of the arm."""
        if self.only and self.Q[state, action] < self.Q[state].max():
            return
        self.N[state, action] += 1
        pulls = (self.N.sum() if self.shared else self.N[state, action]) + self.plus
        step = 1.0 if self.sums else 1.0 / pulls
        self.Q[state, action] += step * (reward - (0.0 if self.sums else self.Q[state, action]))


def right(shape: tuple[int, int]) -> Any:
    """Make an agent with the settings of the project."""
    return SampleAverage.create(shape)


def constant(shape: tuple[int, int]) -> Any:
    """Make one with a constant step size."""
    return QLearning.create(shape, learning_rate=LEARNING_RATE, discount=0.0)


def counting(shape: tuple[int, int], **mistake: Any) -> Any:
    """Make one with a mistake of `Counting`."""
    return Counting(np.zeros(shape), np.zeros(shape), **mistake)


def _wins(step: Step, before: Step | None) -> Step:
    return step._replace(reward=float(step.reward > 0))


RULE = Rule(
    Learner(right),
    {
        "the step size is constant: with 1/N(A) every reward counts equally in the mean": Learner(constant),
        "the mean moves by 1/(N + 1), as if a reward of 0 had come first: count the pull, then divide by N": Learner(
            partial(counting, plus=1.0)
        ),
        "the mean moves by 1/t, with the pulls of all arms together: each arm has a number of its own": Learner(
            partial(counting, shared=True)
        ),
        "rewards are added up and not averaged, so the arm that is pulled most looks best: divide by N": Learner(
            partial(counting, sums=True)
        ),
        "the arm that was *pulled* most is taken, and not that which pays best: is it N in place of Q?": Learner(
            partial(counting, counts=True)
        ),
        "every arm is pulled once before anything else; in the text the first values are 0, and ties are broken at"
        " random": Learner(partial(counting, tries=True)),
        "random pulls are not learned from, but every reward counts": Learner(partial(counting, only=True)),
        "a reward counts as 1 or 0, for a win or none: take the reward itself into the mean": Learner(right, _wins),
        LOW: mistakes_of_loops(right)[LOW],
    },
    EPSILON,
    otherwise="; look at three places: N has a number for each arm, N(A) counts the pull that is learned from, and"
    " nothing is forgotten when an episode ends",
    worlds=12,
    n_steps=350,
    world=Machines,
)
TEN_ARMS = Race(partial(make_environment, "Bandit", gap=0.5, max_steps=PULLS), N_STEPS, program_of(right), episodes=10)


def project_0b(answer: Any, seed: int) -> str:
    """Check a program with ε-greedy and sample averages."""
    RULE.check(answer, seed)
    first = Counter(
        run_program(answer, Machines(number), 10, number).steps[0].action
        for number in range(FIRST_PULLS * seed, FIRST_PULLS * (seed + 1))
    )
    ((arm, times),) = first.most_common(1)
    if times > MOST_ALIKE * FIRST_PULLS:
        raise WrongAnswer(
            f"in {times} of {FIRST_PULLS} runs my_program pulls arm {arm} first, though all arms look equally good"
            " then: argmax takes the first of several equal values; draw one of them at random"
        )
    return f"Right: every reward counts equally. {compare_with_ours(answer, TEN_ARMS, seed)}"
