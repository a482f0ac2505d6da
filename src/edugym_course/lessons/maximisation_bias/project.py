"""The project of lesson 17: double Q-learning, from a blank file.

Which table learns is drawn by the program, so its steps do not say what it has learned. It is put to the test instead:
in a casino that does not pay, where who believes the largest value goes in, and in one that pays.
"""

from functools import cache, partial
from typing import Any, NamedTuple

import gymnasium
import numpy as np

from edugym.agents.double_q_learning import DoubleQLearning
from edugym.agents.q_learning import QLearning
from edugym.agents.strategies import EpsilonGreedy
from edugym.envs.casino import CASINO, HOME, IN, STREET, Casino
from edugym_course.grading.curves import program_of
from edugym_course.grading.errors import WrongAnswer, nobody_asks_why
from edugym_course.grading.programs import (
    APART,
    Run,
    require_reproducible,
    run_program,
)
from edugym_course.lessons.maximisation_bias.methods import DISCOUNT, EPSILON, LEARNING_RATE, MIDDLE

RUNS, PAYING_RUNS = 20, 5
N_STEPS, PAYING_STEPS = 200, 1_000
MOST = 0.3
"""The largest share of episodes in the casino: halfway between ours and Q-learning's there is room for chance."""
FEWEST = 0.6
"""The smallest share of runs whose policy plays the machine that pays."""
OFTEN = 0.5
BAD = Casino.create()
GOOD = Casino.create(n_machines=3, noise=0.5, advantage=1.1)
FAIR, FAIR_RUNS = Casino.create(loss=0.0), 4
"""A casino in which luck decides what is done next. In a few of a hundred runs its steps hang on nothing but the
exploration, and whoever throws the coin without the seed is found in another one of so many."""


class Shuffled(gymnasium.Env[Any, Any]):
    """A casino in which states and actions have other numbers.

    Args:
        casino: the casino.
        seed: the number from which the new numbers are drawn.
    """

    def __init__(self, casino: Casino, seed: int) -> None:
        """Draw the numbers."""
        rng = np.random.default_rng(APART + seed)
        self.observation_space, self.action_space = casino.observation_space, casino.action_space
        self._casino, self._state = casino, STREET
        self._states, self._actions = rng.permutation(3), rng.permutation(int(casino.action_space.n))

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[int, dict[str, Any]]:
        """Stand in the street."""
        super().reset(seed=seed)
        self._state = STREET
        return self.shown(STREET), {}

    def step(self, action: int) -> tuple[int, float, bool, bool, dict[str, Any]]:
        """Take a step in the casino."""
        taken, rng = self.meant(action), self.np_random
        following = self._casino.transition(self._state, taken, rng)
        reward = self._casino.reward(self._state, taken, following, rng)
        self._state = following
        return self.shown(following), reward, following == HOME, False, {}

    def shown(self, state: int) -> int:
        """Return the number of a state."""
        return int(self._states[state])

    def meant(self, action: int) -> int:
        """Return what an action is in the casino."""
        return int(self._actions[action])


class Visits(NamedTuple):
    """What a program did in a casino.

    Attributes:
        run: its run.
        went_in: for each episode, whether it led into the casino.
        plays: the machine that its policy plays; -1 if it goes home.
    """

    run: Run
    went_in: list[bool]
    plays: int


def visit(program: Any, casino: Casino, n_steps: int, seed: int) -> Visits:
    """Run a program in a casino with shuffled numbers, and look at what its policy does."""
    environment = Shuffled(casino, seed)
    run = run_program(program, environment, n_steps, seed)
    street, inside = environment.shown(STREET), environment.shown(CASINO)
    went_in = [step.next_state == inside for step in run.steps if step.state == street]
    goes_in = environment.meant(int(run.policy(street))) == IN
    return Visits(run, went_in, environment.meant(int(run.policy(inside))) if goes_in else -1)


def share(program: Any, seed: int) -> float:
    """Return the share of episodes 31 to 100 that lead into a casino that does not pay, over several runs."""
    runs = (visit(program, BAD, N_STEPS, number) for number in range(RUNS * seed, RUNS * (seed + 1)))
    return float(np.mean([np.mean(one.went_in[MIDDLE]) for one in runs]))


def ours(kind: Any, shape: tuple[int, int]) -> Any:
    """Make an agent with the settings of the project."""
    return kind.create(shape, learning_rate=LEARNING_RATE, discount=DISCOUNT, exploration=EpsilonGreedy(EPSILON))


@cache
def our_shares() -> tuple[float, float]:
    """Return what `share` is for double Q-learning and for Q-learning."""
    double, single = (share(program_of(partial(ours, kind)), APART) for kind in (DoubleQLearning, QLearning))
    return double, single


def project_17(answer: Any, seed: int) -> str:
    """Check a program with double Q-learning."""
    for number in range(FAIR_RUNS * seed, FAIR_RUNS * (seed + 1)):
        require_reproducible(answer, partial(Shuffled, FAIR, number), PAYING_STEPS, number)
    found = [
        visit(answer, GOOD, PAYING_STEPS, number) for number in range(PAYING_RUNS * seed, PAYING_RUNS * (seed + 1))
    ]
    right = np.mean([one.plays == GOOD.n_machines - 1 for one in found])
    if right < FEWEST:
        why = "" if nobody_asks_why() else f": {symptom(found)}"
        raise WrongAnswer(
            f"in a casino that pays, where one of {GOOD.n_machines} machines wins 1 on average, the policy goes in and"
            f" plays it in {right:.0%} of {PAYING_RUNS} runs, and it should in {FEWEST:.0%} or more{why}"
        )
    went_in, (double, single) = share(answer, seed), our_shares()
    if went_in > MOST:
        why = (
            ""
            if nobody_asks_why()
            else (
                ": what does the table that learns ask the *other* table? Its own argmax chooses the action in the next"
                " state, and the other table says what that action is worth"
            )
        )
        raise WrongAnswer(
            f"in a casino that does not pay, it goes in in {went_in:.0%} of episodes 31 to 100; double Q-learning does"
            f" in {double:.0%}, Q-learning in {single:.0%}{why}"
        )
    return (
        f"Right: where the casino does not pay, it goes in in {went_in:.0%} of episodes 31 to 100 (ours {double:.0%},"
        f" Q-learning {single:.0%}); where it pays, it finds the machine in {right:.0%} of {PAYING_RUNS} runs."
    )


def symptom(found: list[Visits]) -> str:
    """Return what a program that does not find the machine looks like, and the likely cause."""
    late = np.mean([np.mean(one.went_in[-len(one.went_in) // 4 :]) for one in found])
    if late > OFTEN:
        return (
            "while it learns, it goes in; does the policy take the best action, of the state that it is given, by the"
            " sum of both tables?"
        )
    return (
        "it has learned little; are *both* tables changed, each in about half of the steps (one that keeps its zeros"
        " says 0 of everything)? Is α 0.1, is the best action by the sum of both tables taken but for ε = 0.1 of the"
        " steps, with ties drawn at random, and is the next step begun in the next state?"
    )
