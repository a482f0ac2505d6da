"""The project of lesson 0b: ε-greedy with sample averages, from a blank file."""

import math
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from edugym.adapters.registration import make_environment
from edugym.agents.q_learning import QLearning
from edugym.agents.sample_average import SampleAverage
from edugym.checks.contract import learns_from
from edugym.mdp.protocol import Reals
from edugym_course.grading.curves import Race, compare_with_ours, program_of
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.learners import LOW, Learner, mistakes_of_loops, other_tables
from edugym_course.grading.programs import SELDOM, Run, Step, learn_from, run_program, shape_of
from edugym_course.grading.replay import replay
from edugym_course.grading.rule import Rule
from edugym_course.grading.surprises import NEAR, SIGMAS, Surprises, require_any_of_two
from edugym_course.grading.ties import require_new_draws
from edugym_course.lessons.bandits.methods import EPSILON, LEARNING_RATE
from edugym_course.lessons.bandits.worlds import CERTAIN_ARMS, FADES, PULLS, Certain, Machines

N_STEPS = 3_000
SHORT_RUNS = 60
"""So many runs of 10 steps are looked at: which of several equal arms is pulled, and what the policy is. After so few
pulls the best arm is often another one than the last, or than the most pulled."""
PAIR_PULLS, LATE_IN_PAIR = 4_000, 3_500
"""With two arms it matters most whether the random one is one of both: the worse arm gets half of the random pulls."""
FAINT, FAINT_RUNS, FAINT_PULLS = 0.01, 20, 16
"""What arms pay where first values other than 0 show, and how many first pulls are looked at there."""
SURE_PULLS, SURE_ARMS = 8_000, 50
"""In a bandit whose best arm always pays, while no other ever does, random pulls alone go to the others in the end.
With so many arms it hardly matters whether the random one is one of all."""
CERTAIN_PULLS = 2_000
LAYOUTS = 0, 1
"""Two such bandits, with another best arm each."""
LATE, TWICE = 7_000, 150
"""So many of these pulls are looked at; in so many steps both runs may pull another arm. It is 67 by chance."""
LAST = 400
"""In so many last pulls some 39 are others than the best one, and hardly ever none."""
AT_ONE_STEP = 0.4
"""The share of the late episodes that may pull another arm at one step of theirs. It is 0.1 by chance."""
EXACTLY = 0.05
"""What a mistake may leave that sticks to one arm: a little of this is in much else that goes wrong."""


class Counting(NamedTuple):
    """Sample averages with a mistake.

    Attributes:
        Q: shape (1, n_arms): the values.
        N: shape (1, n_arms): the pulls.
        plus: what is added to the number of pulls before the mean moves.
        shared: whether the pulls of all arms count for each.
        sums: whether rewards are added up by whole steps.
        counts: whether the arm that was pulled most looks best.
        first: the value of an arm that was never pulled.
        only: whether it learns only from the arms that look best.
        towards: 1, or -1 for a mean that moves away from rewards.
        less: how much of the old mean is subtracted from a reward.
        forgets: whether nothing is left of an episode that has ended.
        power: that of the number of pulls by which the mean moves.
    """

    Q: Reals
    N: Reals
    plus: float = 0.0
    shared: bool = False
    sums: bool = False
    counts: bool = False
    first: float = 0.0
    only: bool = False
    towards: float = 1.0
    less: float = 1.0
    forgets: bool = False
    power: float = 1.0

    def values(self, state: int) -> Reals:
        """What the arms look worth."""
        if self.counts:
            pulls: Reals = self.N[state]
            return pulls
        table: Reals = np.where(self.N[state] == 0, self.first, self.Q[state])
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

    def learn(self, state: int, action: int, reward: float, terminated: bool, truncated: bool) -> None:
        """Move the value of the arm."""
        if self.only and self.Q[state, action] < self.Q[state].max():
            return
        self.N[state, action] += 1
        pulls = (self.N.sum() if self.shared else self.N[state, action]) + self.plus
        step = self.towards * (1.0 if self.sums else 1.0 / pulls**self.power)
        self.Q[state, action] += step * (reward - self.less * self.Q[state, action])
        if self.forgets and (terminated or truncated):
            self.Q[:], self.N[:] = 0.0, 0.0


def right(shape: tuple[int, int]) -> Any:
    """Make an agent with the settings of the project."""
    return SampleAverage.create(shape)


def constant(shape: tuple[int, int], learning_rate: float = LEARNING_RATE) -> Any:
    """Make one with a constant step size."""
    return QLearning.create(shape, learning_rate=learning_rate, discount=0.0)


def counting(shape: tuple[int, int], **mistake: Any) -> Any:
    """Make one with a mistake of `Counting`."""
    return Counting(np.zeros(shape), np.zeros(shape), **mistake)


def _wins(step: Step, before: Step | None) -> Step:
    return step._replace(reward=float(step.reward > 0))


WHOLE_NUMBERS = other_tables(right, ())
"""Many values are equal then, so it explains whatever comes from chance. It still finds an arm that always pays."""
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
        "the mean moves by 1/√N(A), so that late rewards count more than early ones: it moves by 1/N(A)": Learner(
            partial(counting, power=0.5)
        ),
        "rewards are added up and not averaged, so the arm that is pulled most looks best: divide by N": Learner(
            partial(counting, sums=True, less=0.0)
        ),
        "the arm that was *pulled* most is taken, and not that which pays best: is it N in place of Q?": Learner(
            partial(counting, counts=True), leaves=EXACTLY
        ),
        "every arm is pulled once before anything else; in the text the first values are 0, and ties are broken at"
        " random": Learner(partial(counting, first=1e9)),
        "the first values are 1; in the text they are 0": Learner(partial(counting, first=1.0)),
        "only the last reward counts: N(A) grows by 1 with each pull of the arm": Learner(
            partial(constant, learning_rate=1.0)
        ),
        "the mean moves away from the reward: is it Q(A) + [R − Q(A)] / N(A), with these signs?": Learner(
            partial(counting, towards=-1.0)
        ),
        "the old mean is added to the reward; it is subtracted: R − Q(A)": Learner(partial(counting, less=-1.0)),
        "the old mean is not subtracted from the reward: is it Q(A) + [R − Q(A)] / N(A)?": Learner(
            partial(counting, less=0.0)
        ),
        "what was learned is forgotten at the end of an episode; the arms stay the same": Learner(
            partial(counting, forgets=True)
        ),
        "random pulls are not learned from, but every reward counts": Learner(partial(counting, only=True)),
        "a reward counts as 1 or 0, for a win or none: take the reward itself into the mean": Learner(right, _wins),
        "the last pull of an episode is not learned from: learn first, and look then whether the episode is over": (
            Learner(right, skips=lambda step: step.terminated or step.truncated)
        ),
        LOW: mistakes_of_loops(right)[LOW],
    }
    | WHOLE_NUMBERS,
    EPSILON,
    settings="the first values",
    otherwise="; N has a number for each arm, and N(A) counts the pull that is learned from; but for ε, the arm with"
    " the largest mean is pulled",
    worlds=12,
    n_steps=350,
    world=Machines,
    slack=NEAR,
    looks_closer=False,  # it is done last
)
CERTAIN = (
    (
        False,
        "with arms that always pay the same, 1 or a few thousandths less",
        "the best arm is that with the largest mean, with nothing added: no bonus for arms that were pulled seldom, no"
        " noise, and no tie of means that differ",
    ),
    (
        True,
        f"with an arm that pays 1 in the first {FADES} pulls and then 0, while others always pay the same",
        "every reward counts equally in the mean of its arm, however many there are",
    ),
)
TEN_ARMS = Race(partial(make_environment, "Bandit", gap=0.5, max_steps=PULLS), N_STEPS, program_of(right), episodes=30)


def project_0b(answer: Any, seed: int) -> str:
    """Check a program with ε-greedy and sample averages."""
    sure = _sure_arms(answer, seed)
    late = [arms[-LATE:] for arms in sure]
    best = [Counter(arms).most_common(1)[0] for arms in late]
    _require_tries(late, LATE)
    at_once = sum(one != best[0][0] and other != best[1][0] for one, other in zip(*late, strict=True))
    if at_once <= TWICE:
        _require_fresh_numbers(late)
        _require_steady_start(sure)
    pulls, share = LATE * len(LAYOUTS), 1 - 1 / SURE_ARMS
    others = pulls - sum(times for _, times in best)
    tries = others / pulls / share
    impossible = {} if abs(tries / EPSILON - 1) <= NEAR else WHOLE_NUMBERS
    possible = {sentence: mistake for sentence, mistake in RULE.mistakes.items() if sentence not in impossible}
    replace(RULE, mistakes=possible).check(answer, seed, tries)
    _require_tries(late, LAST)
    short = range(SHORT_RUNS * seed, SHORT_RUNS * (seed + 1))
    runs = [run_program(answer, Machines(number), 10, number) for number in short]
    _require_random_ties([tie for run in runs for tie in _ties(run)])
    require_new_draws(answer, seed)
    RULE.require_best_actions(runs, shape_of(Machines(0)), SELDOM)
    for found, sign in ((EPSILON * share, -1), (EPSILON, 1)):  # the random arm may be one of all, or of the others
        if sign * (others - found * pulls) > SIGMAS * math.sqrt(found * (1 - found) * pulls):
            raise WrongAnswer(
                f"in bandits whose best arm always pays, and no other ever does, my_program pulls the others in"
                f" {others} of {pulls} late steps, and with ε = {EPSILON} it should be some"
                f" {EPSILON * share * pulls:.0f}: its ε is about {tries:.2f}"
            )
    if at_once > TWICE:
        raise WrongAnswer(
            f"in two runs with other seeds {at_once} of {LATE} late pulls are at the same step, and both of another arm"
            f" than the best, and by chance it should be some {LATE * EPSILON**2:.0f}: draw in each step whether the"
            " arm is random, and do not count to ten"
        )
    _require_any_arm(answer, seed)
    _require_mean_alone(answer, seed)
    _require_first_values(answer, seed)
    RULE.look_closer(answer, seed, tries)
    return f"Right: every reward counts equally. {compare_with_ours(answer, TEN_ARMS, seed)}"


def _sure_arms(answer: Any, seed: int) -> list[list[int]]:
    """Return the arms that a program pulls in bandits whose best arm always pays, and no other ever does."""
    arms = []
    for number in LAYOUTS:
        sure = make_environment("Bandit", n_arms=SURE_ARMS, gap=1.0, layout_seed=number, max_steps=PULLS)
        run = run_program(answer, sure, SURE_PULLS, len(LAYOUTS) * seed + number)  # other random pulls in each
        arms.append([step.action for step in run.steps[:SURE_PULLS]])
    return arms


def _require_tries(late: list[list[int]], last: int) -> None:
    """Refuse a program that pulls only one arm in its last pulls; `last` says how many."""
    if any(len({*arms[-last:]}) == 1 for arms in late):
        raise WrongAnswer(
            f"in the last {last} of {SURE_PULLS} steps my_program pulls one arm only: a random one has the probability"
            " ε up to the last step, and it is drawn from one generator, made before the loop"
        )


def _require_steady_start(runs: list[list[int]]) -> None:
    """Refuse a program whose ε is larger at first.

    Looked at are the pulls after the first one that pays, to the end of its episode. An arm that was not pulled before
    does not count: some pull each arm once.
    """
    repeated = n_pulls = 0
    for arms in runs:
        best = Counter(arms[-LATE:]).most_common(1)[0][0]
        first = arms.index(best) + 1
        after = range(first, first + -first % PULLS)
        n_pulls += len(after)
        repeated += sum(arms[t] != best and arms[t] in arms[:t] for t in after)
    if repeated > EPSILON * n_pulls + SIGMAS * math.sqrt(EPSILON * (1 - EPSILON) * n_pulls):
        raise WrongAnswer(
            f"in bandits whose best arm always pays, and no other ever does, my_program has found the best one and"
            f" pulls others again in {repeated} of the next {n_pulls} pulls, and by chance it would be some"
            f" {EPSILON * n_pulls:.0f}: ε is {EPSILON} from the first pull to the last, and every reward counts, an"
            " arm's first one too"
        )


def _require_fresh_numbers(late: list[list[int]]) -> None:
    """Refuse a program whose generator begins anew in each episode, so that all have their random pulls at one step."""
    others = np.array([[arm != Counter(arms).most_common(1)[0][0] for arm in arms] for arms in late])
    shares = others.reshape(-1, PULLS).mean(axis=0)
    if shares.max() > AT_ONE_STEP:
        raise WrongAnswer(
            f"in {shares.max():.0%} of its late episodes step {shares.argmax() + 1} pulls another arm than the best;"
            f" by chance it would be some {EPSILON:.0%}: make rng once, before the loop, and not anew in each episode"
        )


def _require_mean_alone(answer: Any, seed: int) -> None:
    """Refuse a program that adds a bonus to the means, or in whose means some rewards count more than others.

    Raises:
        WrongAnswer: it does.
    """
    for fades, shows, why in CERTAIN:
        run = run_program(answer, Certain(seed, fades), CERTAIN_PULLS, seed)
        found = Surprises.of(replay([run.steps], RULE.right, (1, CERTAIN_ARMS), EPSILON))
        if not found.is_usual():
            raise WrongAnswer(
                f"{shows}, {found.found.sum():.0f} of {CERTAIN_PULLS} pulls are not of the arm with the largest mean,"
                f" and it should be some {found.expected:.0f}: {why}"
            )


def _require_first_values(answer: Any, seed: int) -> None:
    """Refuse first values other than 0, where what arms pay is so near 0 that they count.

    Raises:
        WrongAnswer: it has others.
    """
    for scale in (FAINT, -FAINT):
        numbers = range(FAINT_RUNS * seed, FAINT_RUNS * (seed + 1))
        runs = [run_program(answer, Certain(number, False, scale), FAINT_PULLS, number) for number in numbers]
        found = Surprises.of(replay([run.steps for run in runs], RULE.right, (1, CERTAIN_ARMS), EPSILON))
        if not found.is_usual():
            raise WrongAnswer(
                f"with arms that always pay {scale} or a few thousandths less, {found.found.sum():.0f} of"
                f" {found.found.size} first pulls are not of an arm with the largest value, and it should be some"
                f" {found.expected:.0f}: the first values are 0, those of all arms"
            )


def _require_any_arm(answer: Any, seed: int) -> None:
    """Refuse a program whose random arm is never the best one.

    Raises:
        WrongAnswer: it is.
    """
    pair = make_environment("Bandit", n_arms=2, gap=1.0, layout_seed=seed, max_steps=PULLS)
    arms = [step.action for step in run_program(answer, pair, PAIR_PULLS, seed).steps[-LATE_IN_PAIR:]]
    others = LATE_IN_PAIR - Counter(arms).most_common(1)[0][1]
    require_any_of_two("in a bandit with two arms, one of which always pays", others, LATE_IN_PAIR, EPSILON)


def _ties(run: Run) -> Iterator[tuple[int, list[int]]]:
    """Yield each pull of one of several arms that look equally good, and these arms."""
    agent = counting(shape_of(Machines(0)))
    for step in run.steps:
        values = agent.values(step.state)
        equal = np.flatnonzero(np.isclose(values, values.max())).tolist()
        if len(equal) > 1 and step.action in equal:
            yield step.action, equal
        learn_from(agent, learns_from(agent), step, step.action)


def _require_random_ties(ties: Sequence[tuple[int, list[int]]]) -> None:
    """Refuse a program that takes the first of several equal arms, or the last, more often than by chance."""
    chances = np.array([1 / len(equal) for _, equal in ties])
    for which, at, why in (("first", 0, "argmax"), ("last", -1, "a loop with >=")):
        found = sum(action == equal[at] for action, equal in ties)
        if found - chances.sum() > SIGMAS * math.sqrt((chances * (1 - chances)).sum()):
            raise WrongAnswer(
                f"in {found} of {len(ties)} pulls of one of several arms that look equally good, my_program takes the"
                f" {which} of them, and by chance it would be some {chances.sum():.0f}: {why}"
                f" takes the {which} of several equal values; draw one of them at random"
            )
