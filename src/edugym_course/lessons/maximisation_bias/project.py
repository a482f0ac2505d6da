"""The project of lesson 17: double Q-learning, from a blank file.

Which table learns is drawn by the program, so its steps do not say what it has learned. It is put to the test instead:
with arms of which each pays the same, where it is known which action looks best; in riddles, where it is known how
often the policy says what; in a casino that pays; and in one that does not, where who believes the largest value goes
in.
"""

import math
from collections import Counter
from functools import cache, partial
from typing import Any, NamedTuple

import gymnasium
import numpy as np
from gymnasium import spaces

from edugym.agents.double_q_learning import DoubleQLearning
from edugym.agents.q_learning import QLearning
from edugym.agents.strategies import EpsilonGreedy
from edugym.envs.casino import CASINO, HOME, IN, STREET, Casino
from edugym.mdp.protocol import Integers
from edugym_course.grading.curves import program_of
from edugym_course.grading.errors import WrongAnswer, nobody_asks_why
from edugym_course.grading.programs import APART, Run, run_program
from edugym_course.grading.repeats import require_reproducible
from edugym_course.grading.surprises import SIGMAS, Surprises, require_any_of_two
from edugym_course.grading.ties import require_new_draws
from edugym_course.lessons.maximisation_bias.methods import DISCOUNT, EPSILON, LEARNING_RATE, MIDDLE
from edugym_course.lessons.maximisation_bias.riddles import require_riddles
from edugym_course.lessons.maximisation_bias.tries import require_coin_apart

RUNS, PAYING_RUNS = 60, 10
N_STEPS, PAYING_STEPS = 200, 1_000
MOST = 0.25
"""The largest share of episodes in the casino: right programs have 0.15, with a standard error of 0.025 over so many
runs, and Q-learning 0.65."""
FEWEST = 0.8
"""The smallest share of runs whose policy plays the machine that pays."""
TRIES_LEAST, TRIES_MOST = 0.7, 1.7
"""How many times as often as by ε a program may take another action than the best, in the middle one of a few runs."""
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


ARMS = 50
"""So many that it hardly matters whether a random arm is one of all, or one of the others."""


class Arms(gymnasium.Env[Any, Any]):
    """Arms that pay 1 at each pull.

    Args:
        pulls: how many an episode has, 1 or 2. The second one is made in state 1.
        n_arms: how many arms there are. With many it hardly matters whether a random one is one of all.
    """

    observation_space = spaces.Discrete(2)

    def __init__(self, pulls: int = 1, n_arms: int = ARMS) -> None:
        """Nothing was pulled."""
        self.action_space = spaces.Discrete(n_arms)
        self._pulls, self._left = pulls, pulls

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[int, dict[str, Any]]:
        """Stand before the arms."""
        super().reset(seed=seed)
        self._left = self._pulls
        return 0, {}

    def step(self, action: int) -> tuple[int, float, bool, bool, dict[str, Any]]:
        """Pull an arm."""
        self._left -= 1
        return self._left, 1.0, self._left == 0, False, {}


_WHERE = "where each action ends an episode, "
ARM_RUNS, PULLS, SETTLED = 150, 100, 3
"""After so many pulls of a run its favourite arm hardly changes: every other pull is a try."""
SAME, AGAIN, MET, LEAST, MUCH = 0.7, 0.75, 0.35, 0.8, 0.985
"""Of the runs that begin with one arm; that pull it again when it has paid; whose first ten pulls have an arm twice,
as random ones have in 0.62 of the runs; of the pulls of a run's favourite arm, at least and at most. A right program:
0.02 on average, 0.9, 1, and twice 0.9."""
NONE = 0.1
"""Who draws all arms at random pulls the commonest one in 0.06 of the steps."""
SIGMAS_OF_ARMS = 5.0
"""How far the tries of an arm may be from their mean. Each has some 28, so one that is never tried is 5.3 below it."""
AT_ONCE = 0.4
"""The share of the runs that may try another arm at one step. It is 0.1 by chance."""
PAIR_RUNS, TOGETHER = 30, 0.03
"""In so many runs of episodes of two pulls; the share of those in which both are others than the favourite ones. A
right program: 0.01, and 0.08 for one that is random for a whole episode."""


def require_arms(answer: Any, seed: int) -> tuple[Surprises, Integers]:
    """Refuse a program that does not act by the sum of both tables, with ties drawn and a little chance.

    Returns:
        In which pulls it took another arm than its favourite one, and how often it took each arm then.

    Raises:
        WrongAnswer: it does not.
    """
    numbers = range(ARM_RUNS * seed, ARM_RUNS * (seed + 1))
    pulls = [[step.action for step in run_program(answer, Arms(), PULLS, number).steps] for number in numbers]
    arm, begun = Counter(mine[0] for mine in pulls).most_common(1)[0]
    again = float(np.mean([mine[1] == mine[0] for mine in pulls]))
    others = np.array([[one != Counter(mine).most_common(1)[0][0] for one in mine] for mine in pulls], float)
    favourite = 1 - others.mean()
    told = ""
    if begun > SAME * ARM_RUNS:
        told = (
            f"where all values are equal, it begins with action {arm} in {begun} of {ARM_RUNS} runs: draw one of the"
            " best at random, as in rng.choice(np.flatnonzero(values == values.max()))"
        )
    elif again < AGAIN:
        why = "is ε 0.1, are the first values 0, and is the best action that with the largest *sum* of both tables?"
        if np.mean([len({*mine[:10]}) < 10 for mine in pulls]) < MET:
            why = "does a value move *towards* the target, and is the best action that with the *largest* value?"
        elif favourite < NONE:
            why = (
                "is ε 0.1, is the step that ends an episode learned from, with the target R, and do both tables last"
                " from one episode to the next?"
            )
        elif favourite > LEAST:
            why = "is the best action that with the largest *sum* of both tables?"
        told = (
            "an action that has paid 1, when the values of all others are still 0, is taken again in"
            f" {again:.0%} of {ARM_RUNS} runs, and it should in 90%: {why}"
        )
    elif favourite < LEAST:
        told = (
            f"it takes its favourite action in {favourite:.0%} of {PULLS} steps, and it should in about 90%: is ε 0.1?"
        )
    elif favourite > MUCH:
        told = "it tries no action but the best one: a share ε = 0.1 of its actions are random ones"
    if told:
        raise WrongAnswer(f"{_WHERE}{told}")
    _require_single_tries(answer, seed)
    found = others[:, SETTLED:].ravel()
    none = np.zeros(found.size)
    tries = Surprises(found, np.full(found.size, EPSILON * (1 - 1 / ARMS)), none, none, none)
    return tries, np.bincount(np.array(pulls)[:, SETTLED:].ravel()[found == 1], minlength=ARMS)


def _require_all_arms(tries: Integers) -> None:
    """Refuse a program that tries some arms less often than others.

    Args:
        tries: the second that `require_arms` returns.

    Raises:
        WrongAnswer: it does.
    """
    off = (tries - tries.mean()) / math.sqrt(max(tries.mean(), 1.0))
    if off.max() > SIGMAS_OF_ARMS or off.min() < -SIGMAS_OF_ARMS:
        arm = int(abs(off).argmax())
        raise WrongAnswer(
            f"{_WHERE}it tries action {arm} {tries[arm]} times where another one is its favourite, and an action"
            f" {tries.mean():.0f} times on average: is the random action one of *all* n actions, 0 to n - 1, and each"
            " as likely? rng.integers(n) draws so"
        )


def _require_single_tries(answer: Any, seed: int) -> None:
    """Refuse a program that draws once an episode whether its actions are random."""
    both, single = list[bool](), list[bool]()
    for number in range(PAIR_RUNS * seed, PAIR_RUNS * (seed + 1)):
        taken = [step.action for step in run_program(answer, Arms(2), PULLS, number).steps]
        first, second = (
            [one != Counter(mine).most_common(1)[0][0] for one in mine] for mine in (taken[::2], taken[1::2])
        )
        both += [one and other for one, other in zip(first, second, strict=True)][SETTLED:]
        single += [*first[SETTLED:], *second[SETTLED:]]
    if np.mean(both) > max(TOGETHER, 2 * float(np.mean(single)) ** 2):  # else by chance: ε is too large
        raise WrongAnswer(
            f"where each episode has two steps, in {np.mean(both):.0%} of the episodes both actions are others than the"
            " favourite ones, and it should be about 1%: draw anew in each step whether its action is random, not once"
            " an episode"
        )


def _require_any_arm(answer: Any, seed: int) -> None:
    """Refuse a program whose random action is never the best one."""
    others = 0
    for number in range(PAIR_RUNS * seed, PAIR_RUNS * (seed + 1)):
        taken = [step.action for step in run_program(answer, Arms(n_arms=2), PULLS, number).steps][SETTLED:]
        others += len(taken) - Counter(taken).most_common(1)[0][1]
    where = "where each of two actions ends an episode, and one is a favourite"
    require_any_of_two(where, others, PAIR_RUNS * (PULLS - SETTLED), EPSILON)


def require_steady(tries: Surprises) -> None:
    """Refuse a program whose ε does not stay what it is, or is another one than it should be.

    Args:
        tries: the first that `require_arms` returns.

    Raises:
        WrongAnswer: it is.
    """
    by_step = tries.found.reshape(ARM_RUNS, -1).mean(axis=0)
    if by_step.max() > AT_ONCE:
        raise WrongAnswer(
            f"{_WHERE}step {by_step.argmax() + SETTLED + 1} is another action than its favourite one in"
            f" {by_step.max():.0%} of {ARM_RUNS} runs: draw in each step whether its action is random, and do not count"
            " to ten"
        )
    share, when = f"it should be about {tries.chances[0]:.0%}", np.tile(np.linspace(0, 1, PULLS - SETTLED), ARM_RUNS)
    if abs(tries.lateness(when)) > SIGMAS:
        first, second = (tries.among(half).found.mean() for half in (when < 0.5, when >= 0.5))
        raise WrongAnswer(
            f"{_WHERE}{first:.1%} of its actions are others than its favourite one in the first half of its runs, and"
            f" {second:.1%} in the second, and {share} from the first step to the last: is ε always 0.1?"
        )
    if not tries.is_usual(slack=1 / ARMS):
        raise WrongAnswer(
            f"{_WHERE}{tries.found.mean():.1%} of its actions are others than its favourite one, and {share}: its ε is"
            f" about {tries.found.sum() / tries.expected * EPSILON:.2f}"
        )


class Visits(NamedTuple):
    """What a program did in a casino.

    Attributes:
        run: its run.
        went_in: for each episode, whether it led into the casino.
        plays: the machine that its policy plays; -1 if it goes home.
        tries: the share of the steps in the second half whose action is another one than the policy's.
    """

    run: Run
    went_in: list[bool]
    plays: int
    tries: float


def visit(program: Any, casino: Casino, n_steps: int, seed: int) -> Visits:
    """Run a program in a casino with shuffled numbers, and look at what its policy does."""
    environment = Shuffled(casino, seed)
    run = run_program(program, environment, n_steps, seed)
    street, inside = environment.shown(STREET), environment.shown(CASINO)
    went_in = [step.next_state == inside for step in run.steps if step.state == street]
    goes_in = environment.meant(int(run.policy(street))) == IN
    plays = environment.meant(int(run.policy(inside))) if goes_in else -1
    best = {state: int(run.policy(state)) for state in (street, inside)}
    tries = float(np.mean([step.action != best[step.state] for step in run.steps[n_steps // 2 :]]))
    return Visits(run, went_in, plays, tries)


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


def _require_tries(tries: list[float]) -> None:
    """Refuse a program whose ε is another one than it should be, or does not stay what it is.

    The median of the runs is taken, for a policy that changes its mind in its last steps makes many tries of what was
    best before.

    Raises:
        WrongAnswer: it is.
    """
    found, right = float(np.median(tries)), EPSILON * (1 - 1 / GOOD.n_machines)
    if not TRIES_LEAST * right < found < TRIES_MOST * right:
        raise WrongAnswer(
            f"in the second half of its {PAYING_STEPS} steps in a casino of {GOOD.n_machines} machines, {found:.1%} of"
            f" the actions are others than those of its policy, and it should be about {right:.1%}: is ε"
            f" {EPSILON:g}, from the first step to the last, and is the random action one of all?"
        )


def project_17(answer: Any, seed: int) -> str:
    """Check a program with double Q-learning."""
    for number in range(FAIR_RUNS * seed, FAIR_RUNS * (seed + 1)):
        require_reproducible(answer, partial(Shuffled, FAIR, number), PAYING_STEPS, number)
    tries, of_arms = require_arms(answer, seed)
    require_riddles(answer, seed)
    require_steady(tries)
    _require_all_arms(of_arms)
    _require_any_arm(answer, seed)
    require_new_draws(answer, seed)
    require_coin_apart(answer, seed)
    found = [
        visit(answer, GOOD, PAYING_STEPS, number) for number in range(PAYING_RUNS * seed, PAYING_RUNS * (seed + 1))
    ]
    right = np.mean([one.plays == GOOD.n_machines - 1 for one in found])
    if right < FEWEST:
        why = (
            ""
            if nobody_asks_why()
            else (
                ": it has learned little; is the next step begun in the next state, and is the other table asked about"
                " the *best* action there?"
            )
        )
        raise WrongAnswer(
            f"in a casino that pays, where one of {GOOD.n_machines} machines wins 1 on average, the policy goes in and"
            f" plays it in {right:.0%} of {PAYING_RUNS} runs, and it should in {FEWEST:.0%} or more{why}"
        )
    _require_tries([one.tries for one in found if one.plays == GOOD.n_machines - 1])
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
            f"in a casino that does not pay, {went_in:.0%} of episodes 31 to 100 lead into it; with double Q-learning"
            f" {double:.0%} do, with Q-learning {single:.0%}{why}"
        )
    return (
        f"Right: {went_in:.0%} of episodes 31 to 100 lead into a casino that does not pay ({double:.0%} with ours,"
        f" which takes the mean over ties, and {single:.0%} with Q-learning); where it pays, it finds the machine in"
        f" {right:.0%} of {PAYING_RUNS} runs."
    )
