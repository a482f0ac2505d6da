"""In which steps of a program the action was not one that looked best, and what their number tells."""

import math
from collections.abc import Iterable, Iterator, Sequence
from heapq import heappop, heappush
from itertools import islice
from typing import Any, NamedTuple

import numpy as np

from edugym.mdp.protocol import Reals
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.programs import NAME

SLACK = 0.05
"""The share by which a right program may explore more often. Who draws among the *other* of four does by a third."""
LESS = 0.1
"""The share by which it may explore less often, wherever a larger one is allowed for more."""
NEAR = 0.3
"""How far, as a share of it, ε may be from that of the text where something else is the likely cause."""
NATS = 20.0
"""How much more probable, as a logarithm, a mistake must make the actions than the right equation."""
UNEXPLAINED = 0.25
"""The share of the surprises above those by ε that a mistake leaves at most; one that leaves more is another one."""
SIGMAS, CLEARLY = 4.0, 2.0
"""How many standard deviations are more than chance; and how many more surprises a mistake may leave by chance."""

AT_ONCE = 100
"""How many steps a mistake goes on, before another one that is more probable may."""
BOTH = 3.0
"""How many standard deviations are more than chance where a second number speaks against it too."""

OTHERS = "a random action may be any of them, the best one too"

Row = tuple[bool, float, float, float, float]
"""Of one step: whether its action was a surprise, how likely that was by ε, the logarithm of its probability; and of a
surprise, how many actions that do not look best look worse than it, less how many look better, and the variance of that
number if one of them was drawn at random."""


class Surprises(NamedTuple):
    """In which steps the action was not one that looked best.

    Attributes:
        found: for each step, 1 if it was so, else 0.
        chances: for each step, how likely that was by ε.
        logs: for each step, the logarithm of the probability of its action.
        ranks: for each step, how many actions look worse than the surprise less how many look better; else 0.
        variances: of the ranks, if chance draws a surprise.
    """

    found: Reals
    chances: Reals
    logs: Reals
    ranks: Reals
    variances: Reals

    @classmethod
    def of(cls, rows: Iterable[Row]) -> "Surprises":
        """Those of a replay."""
        return cls(*np.array([*rows], float).T)

    def among(self, steps: Any) -> "Surprises":
        """Those in some of the steps, by their numbers, or by a truth value for each."""
        return Surprises(*(one[steps] for one in self))

    @property
    def expected(self) -> float:
        """How many are to be expected."""
        return float(self.chances.sum())

    @property
    def too_many(self) -> float:
        """How many there are above those that are to be expected."""
        return float(self.found.sum()) - self.expected

    @property
    def deviation(self) -> float:
        """The standard deviation of their number."""
        return math.sqrt(float((self.chances * (1 - self.chances)).sum()))

    def are_drawn(self, sigmas: float = SIGMAS) -> bool:
        """Whether chance may have drawn them, whatever ε is: an equation that is nearly right takes the second best."""
        return float(self.ranks.sum()) <= sigmas * math.sqrt(float(self.variances.sum()))

    def lateness(self, when: Reals) -> float:
        """How many standard deviations too late they come, whatever their number; below 0 if they come too early.

        Args:
            when: for each step, how much of its run was over.
        """
        share = self.found.sum() / self.expected
        off = when - float(self.chances @ when) / self.expected
        variance = float((off * off * share * self.chances * (1 - share * self.chances)).sum())
        return float(off @ (self.found - share * self.chances)) / math.sqrt(max(variance, 1e-9))

    def once_an_episode(self, episodes: Any, epsilon: float, n_actions: int) -> tuple[float, float]:
        """The logarithms of the probability of all actions, if ε is for whole episodes, and if it is for each step.

        Both use the share of random actions that there was, so only how they lie together counts.

        Args:
            episodes: for each step, the number of its episode.
            epsilon: ε, of which the chances were made.
            n_actions: how many actions there are.
        """
        share = min(max(epsilon * self.found.sum() / self.chances.sum(), 1e-3), 1 - 1e-3)
        best = np.where(self.found == 1, 0.0, 1 / (n_actions * (1 - self.chances / epsilon)))
        random = math.log(share) - math.log(n_actions) * np.bincount(episodes)
        with np.errstate(divide="ignore"):
            greedy = math.log(1 - share) + np.bincount(episodes, np.log(best))
        steps = np.log(share / n_actions + (1 - share) * best)
        return float(np.logaddexp(random, greedy).sum()), float(steps.sum())

    def is_usual(self, slack: float = SLACK) -> bool:
        """Whether there are as many as are to be expected, or more by chance and a share of them, or a little fewer."""
        by_chance = SIGMAS * self.deviation
        return -by_chance - min(slack, LESS) * self.expected <= self.too_many <= by_chance + slack * self.expected

    def explains_better_than(self, other: "Surprises", nats: float = NATS) -> bool:
        """Whether it makes the actions more probable, by more than chance.

        If a program has the right equation, and breaks ties at random, a wrong one does so by k nats with a probability
        below e⁻ᵏ (Markov's inequality).
        """
        return bool(self.logs.sum() > other.logs.sum() + nats)

    def explains_those_of(self, other: "Surprises", leaves: float = UNEXPLAINED) -> bool:
        """Whether it leaves few of the surprises of another one; a mistake that is only similar leaves more."""
        return self.too_many < leaves * other.too_many + CLEARLY * self.deviation


def likeliest(replays: Sequence[Iterator[Row]], n_steps: int, highest: float) -> tuple[int, list[Row]]:
    """Return the number of the replay that makes the actions most probable, the first among equals, and its rows.

    No other is played to its end: the one that may still become the likeliest goes on (a best-first search), and most
    mistakes are soon behind.

    Args:
        replays: at least one.
        n_steps: how many steps each has.
        highest: the largest logarithm that a step can have.
    """
    rows: list[list[Row]] = [[] for _ in replays]
    queue = [(-n_steps * highest, number) for number in range(len(replays))]
    while True:
        _, number = heappop(queue)
        mine = rows[number]
        if len(mine) == n_steps:
            return number, mine
        mine += islice(replays[number], AT_ONCE)
        at_most = sum(log for _, _, log, *_ in mine) + (n_steps - len(mine)) * highest
        heappush(queue, (-at_most, number))


def refusal(where: str, epsilon: float, found: Surprises, cause: str) -> WrongAnswer:
    """Return what to say of surprises in some worlds, and of their cause."""
    return WrongAnswer(f"in {_counted(where, epsilon, found)} {cause}")


def usual_refusal(where: str, epsilon: float, found: Surprises, sentence: str, when: str = "") -> WrongAnswer:
    """Return what to say where a usual mistake explains the surprises: first the mistake, as a sentence tells it."""
    stop = "" if sentence.endswith("?") else "."
    how = _counted(where, epsilon, found)
    if found.is_usual():  # their number tells nothing
        how = (
            f"{where} with {found.found.size} steps, the actions follow from the program's own steps by another"
            " equation than that of this lesson."
        )
    return WrongAnswer(f"{when}the actions of {NAME} fit a usual mistake: {sentence}{stop} In {how}")


def _counted(where: str, epsilon: float, found: Surprises) -> str:
    return (
        f"{where} with {found.found.size} steps, {found.found.sum():.0f} actions of {NAME} are not greedy, if it"
        f" learns from its steps by the equation of this lesson, and with ε = {epsilon:g} it should be some"
        f" {found.expected:.0f}."
    )


def require_any_of_two(where: str, others: int, n_steps: int, epsilon: float) -> None:
    """Refuse a program whose random action is never the best one: with two actions it takes the other twice as often.

    Args:
        where: what the two actions are, for the message.
        others: in how many steps the program took another action than the best one.
        n_steps: of so many.
        epsilon: the probability of a random action.

    Raises:
        WrongAnswer: it is never the best one.
    """
    expected = n_steps * epsilon / 2
    if others > 1.5 * expected:  # halfway to twice as many
        raise WrongAnswer(
            f"{where}, {NAME} takes the other one in {others} of {n_steps} late steps, and it should be some"
            f" {expected:.0f}: {OTHERS}"
        )
