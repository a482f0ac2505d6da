"""What a profile holds: the scores of every run, and what follows from them."""

import math
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from edugym.checks.parameters import one_of
from edugym.experiments.profiles.ladders import Ladder
from edugym.experiments.results.statistics import Interval, mean_interval
from edugym.mdp.protocol import Reals

if TYPE_CHECKING:
    import pandas

HALF, NEARLY = 0.5, 0.9
COLUMNS = ("agent", "challenge", "strength", "repetition", "return", "random", "best", "score", "steps", "steps_to_0.9")

KEPT = ("agent", "challenge", "strength", "repetition", "score", "steps_to_0.9")
"""The columns that are needed for what a profile says."""


class Break(NamedTuple):
    """Where an agent breaks: where the mean score first falls below 0.5.

    Attributes:
        strength: the strength there, interpolated between two rungs; the easiest or the hardest rung where the agent
            breaks on none between them.
        where: "at once" if the score is below 0.5 on the easiest rung, "never" if it is on none, else "between".
    """

    strength: float
    where: str


@dataclass(frozen=True)
class Profile:
    """How well each agent does on each rung of each ladder.

    Attributes:
        runs: one row a run (pandas.DataFrame): `agent`, `challenge` (the name of the ladder), `strength`, `repetition`;
            `return`, the mean greedy return at the end; `random` and `best`, the returns that score 0 and 1; `score`;
            `steps`, those of the training on the rung; `steps_to_0.9`, those after which the score first was 0.9, NaN
            if it never was.
        ladders: the ladders, in order.
        agents: the labels of the agents, in order; one may have fewer repetitions than another.
        blank: for each agent, the challenges that it cannot enter, or in which it raised an error, with the reason.
        settings: how the agents came by their settings, in a sentence.
    """

    runs: "pandas.DataFrame"
    ladders: tuple[Ladder, ...]
    agents: tuple[str, ...]
    blank: dict[str, dict[str, str]] = field(default_factory=dict)
    settings: str = "Each agent has its settings as given: nothing was tuned."

    @property
    def challenges(self) -> list[str]:
        """The names of the ladders, in order."""
        return [ladder.name for ladder in self.ladders]

    def ladder(self, challenge: str) -> Ladder:
        """The ladder of a challenge.

        Raises:
            ValueError: the profile has no such challenge.
        """
        one_of("challenge", challenge, self.challenges)
        return self.ladders[self.challenges.index(challenge)]

    def scores(self, agent: str, challenge: str) -> Reals:
        """The score of every run of an agent in a challenge.

        Args:
            agent: one of `agents`.
            challenge: one of `challenges`.

        Returns:
            Shape (n_strengths, n_repetitions); NaN where there is no run.

        Raises:
            ValueError: an argument is none of these.
        """
        return self._table(agent, challenge, "score")

    def score(self, agent: str, challenge: str) -> Interval:
        """The score of an agent in a challenge: the area under its ladder, each rung as wide as the others.

        It is not measured (n = 0) if the agent cannot enter the challenge, or if the profile was interrupted before.

        Args:
            agent: one of `agents`.
            challenge: one of `challenges`.

        Raises:
            ValueError: an argument is none of these.
        """
        return mean_interval(self.scores(agent, challenge).mean(axis=0))

    def rungs(self, agent: str, challenge: str) -> list[Interval]:
        """The score of an agent on each rung of a challenge, from easy to hopeless; arguments as in `score`.

        Raises:
            ValueError: as in `score`.
        """
        return [mean_interval(row) for row in self.scores(agent, challenge)]

    def breaks(self, agent: str, challenge: str) -> Break | None:
        """Where the agent breaks; None where it is not measured. Arguments as in `score`.

        Raises:
            ValueError: as in `score`.
        """
        means = self.scores(agent, challenge).mean(axis=1)
        return None if np.isnan(means).any() else breaking(self.ladder(challenge).strengths, means)

    def steps(self, agent: str, challenge: str) -> float:
        """The median training steps to the score 0.9 on the easiest rung; infinite where half of the runs never do.

        It is NaN where it is not measured. Arguments as in `score`.

        Raises:
            ValueError: as in `score`.
        """
        if np.isnan(self.scores(agent, challenge)[0]).any():
            return math.nan
        steps = self._table(agent, challenge, "steps_to_0.9")[0]
        return float(np.median(np.where(np.isnan(steps), math.inf, steps)))

    def _table(self, agent: str, challenge: str, column: str) -> Reals:
        """A column of the runs, shape (n_strengths, n_repetitions).

        It is remembered, since a page with all agents asks for each some twenty times.
        """
        one_of("agent", agent, list(self.agents))
        strengths = self.ladder(challenge).strengths
        if (agent, challenge, column) in self._tables:
            return self._tables[agent, challenge, column].copy()
        rows = self.runs[(self.runs["agent"] == agent) & (self.runs["challenge"] == challenge)]
        repetitions = range(int(rows["repetition"].max()) + 1) if len(rows) else range(1)
        table = rows.pivot(index="strength", columns="repetition", values=column)
        values: Reals = table.reindex(strengths, columns=repetitions).to_numpy(float)
        self._tables[agent, challenge, column] = values
        return values.copy()

    @cached_property
    def _tables(self) -> dict[tuple[str, str, str], Reals]:
        """What `_table` remembers."""
        return {}


def pooled(profile: Profile, beside: Profile) -> Profile:
    """A profile with the agents of another one behind its own, where these climbed the same rungs in as many steps.

    An agent with a label that is in both is that of the first. Of the runs of the others only the scores are kept, and
    the steps to 0.9.
    """
    import pandas

    known = {ladder.name: (ladder.strengths, ladder.n_steps) for ladder in beside.ladders}
    same = [each.name for each in profile.ladders if known.get(each.name) == (each.strengths, each.n_steps)]
    others = tuple(agent for agent in beside.agents if agent not in profile.agents)
    theirs = beside.runs[beside.runs["agent"].isin(others) & beside.runs["challenge"].isin(same)]
    runs = pandas.concat([part[list(KEPT)] for part in (profile.runs, theirs) if len(part)] or [profile.runs])
    return replace(
        profile,
        runs=runs.reindex(columns=list(COLUMNS)),
        agents=(*profile.agents, *others),
        blank=profile.blank | {agent: beside.blank.get(agent, {}) for agent in others},
    )


def breaking(strengths: tuple[float, ...], means: Reals) -> Break:
    """Where mean scores, one for each strength, first fall below 0.5."""
    below = np.flatnonzero(means < HALF)
    if not len(below):
        return Break(strengths[-1], "never")
    k = int(below[0])
    if k == 0:
        return Break(strengths[0], "at once")
    share = (means[k - 1] - HALF) / (means[k - 1] - means[k])
    return Break(float(strengths[k - 1] + share * (strengths[k] - strengths[k - 1])), "between")
