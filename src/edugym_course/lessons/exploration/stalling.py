"""Why the novelty reward slows down: the grip that an agent takes each time it stands at its frontier."""

from collections.abc import Iterable, Mapping
from functools import partial
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np

from edugym.checks.contract import forget_episode, learner
from edugym.experiments.figures import Lines
from edugym.experiments.repeat import repeat
from edugym.experiments.results.claims import Above, Claim, Within
from edugym.experiments.results.statistics import mean_interval
from edugym.experiments.results.tables import Results
from edugym.mdp.protocol import Integers, Random
from edugym_course.lessons.exploration.methods import METHODS, N_STEPS, NOVELTY, SLIP, Maker, paper_methods

HOPE = 10.0
"""A first value above all that the bonuses of these walls add up to."""
SHOWN = 10
"""The visits of a frontier that are told apart; later ones count as the last."""


class FrontierRecorder(NamedTuple):
    """An agent that acts and learns as the one inside it, and counts which grip it takes at its frontier.

    The frontier is the highest position so far. It moves on when the agent takes the right grip there.

    Attributes:
        agent: the agent.
        learner: the same agent, in the form that the loops ask for.
        frontier: shape (1,): the highest position so far.
        seen: shape (1,): the number of times that the agent stood there.
        visits: shape (SHOWN,): how often a frontier was visited for the first, second, ... time.
        right: shape (SHOWN,): how often the agent then took the right grip.
    """

    agent: Any
    learner: Any
    frontier: Integers
    seen: Integers
    visits: Integers
    right: Integers

    def act(self, state: int, rng: Random) -> int:
        """Choose the agent's action."""
        action: int = self.agent.act(state, rng)
        return action

    def greedy(self, state: int, rng: Random) -> int:
        """Choose the action by which the agent is evaluated."""
        action: int = self.agent.greedy(state, rng)
        return action

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool, truncated: bool) -> None:
        """Count, and let the agent learn."""
        if state == self.frontier[0]:
            visit = min(self.seen[0], len(self.visits) - 1)
            self.visits[visit] += 1
            self.seen[0] += 1
            if next_state > state:
                self.right[visit] += 1
                self.frontier[0] = next_state
                self.seen[0] = 0
        self.learner.learn(state, action, reward, next_state, terminated, truncated)

    def forget_episode(self) -> None:
        """Let the agent forget an episode that was not played to its end."""
        forget_episode(self.agent)


def record_frontier(make: Maker, environment: Any) -> FrontierRecorder:
    """Make an agent, and record what it does at its frontier."""
    agent = make(environment)
    return FrontierRecorder(
        agent,
        learner(agent),
        np.zeros(1, np.int64),
        np.zeros(1, np.int64),
        np.zeros(SHOWN, np.int64),
        np.zeros(SHOWN, np.int64),
    )


def watch_frontier(height: int = 100, *, methods: Mapping[str, Maker] = METHODS, **how: Any) -> Results:
    """Train every method, and record which grip it takes at its frontier.

    Args:
        height: the height of the walls, 1 or more.
        methods: by label, functions that make an agent for an environment.
        **how: more arguments of `edugym.experiments.repeat`, such as `repetitions` and `seed`.
    """
    watched = {label: partial(record_frontier, make) for label, make in methods.items()}
    return repeat("Boulder", watched, N_STEPS, parameters={"height": height}, evaluate_every=N_STEPS, **how)


def right_grips(results: Results, method: str, first: int, last: int = SHOWN) -> list[float]:
    """Return for each run the share of right grips on the visits `first` to `last` of a frontier, counted from 1."""
    visits = slice(first - 1, last)
    runs = results.complete_agents(method).values()
    return [run.right[visits].sum() / run.visits[visits].sum() for run in runs if run.visits[visits].any()]


def without_ground_bonus(environment: Any) -> Any:
    """Return a novelty agent whose bonus for entering the ground is one in a million, from the first time on."""
    agent = METHODS[NOVELTY](environment)
    agent.visits[0] = 10**12
    return agent


NO_GROUND, HOPEFUL = "no bonus for the ground", f"values from {HOPE:g}"
CAUSES: Mapping[str, Maker] = MappingProxyType(
    {
        NOVELTY: METHODS[NOVELTY],
        NO_GROUND: without_ground_bonus,
        HOPEFUL: paper_methods(initial_value=HOPE)[NOVELTY],
    }
)
"""The novelty agent, and the same without what might be the reason why it takes the wrong grip."""


def hopeful(height: int) -> str:
    """Return the claim that the reason is a first value of 0."""
    return f"With values that start at {HOPE:g}, it takes the right grip on nearly all later visits: height {height}"


def stalling_claims(watched: Mapping[int, Results]) -> list[Claim]:
    """Return the claims on the grips that the novelty agent takes at its frontier, by the height of the wall."""
    return [claim for height, results in watched.items() for claim in _stalling_at(height, results, watched)]


def _stalling_at(height: int, results: Results, heights: Iterable[int]) -> list[Claim]:
    tested = tuple(hopeful(height) for height in heights)
    as_a_slip = Within(0.7 * SLIP, 1.5 * SLIP)
    return [
        Claim(
            f"On its first visit of a frontier the novelty agent takes the right one of two grips half of the time:"
            f" height {height}",
            "share of first visits",
            mean_interval(right_grips(results, NOVELTY, 1, 1)),
            Within(0.4, 0.6),
        ),
        Claim(
            f"On later visits it takes the right grip only as often as it slips, ε/2 = {SLIP:g}: height {height}",
            "share of later visits",
            mean_interval(right_grips(results, NOVELTY, 2)),
            as_a_slip,
            "the untried grip is worth 0, and the wrong one leads to the ground, which is worth more",
            tested,
        ),
        Claim(
            f"Without a bonus for the ground it takes the right grip as rarely: height {height}",
            "share of later visits",
            mean_interval(right_grips(results, NO_GROUND, 2)),
            as_a_slip,
            remark="so the bonus that the fall itself earns is not the reason",
        ),
        Claim(
            hopeful(height),
            "share of later visits",
            mean_interval(right_grips(results, HOPEFUL, 2)),
            Above(0.8),
        ),
    ]


def frontier_lines(watched: Results) -> Lines:
    """Return the probability of the right grip on the n-th visit of a frontier, for every method."""
    ns = range(1, SHOWN)
    return Lines(
        np.array(ns, float),
        {method: np.array([_pooled(watched, method, n) for n in ns]) for method in watched.methods},
        "at the frontier, height 100",
        "n-th visit of the frontier",
        "P(right grip)",
        {"a slip: ε/2": np.full(len(ns), SLIP)},
    )


def _pooled(watched: Results, method: str, n: int) -> float:
    """Return the share of right grips on the n-th visits of all frontiers of all runs; NaN for fewer than 30."""
    runs = watched.complete_agents(method).values()
    visits = sum(int(run.visits[n - 1]) for run in runs)
    right = sum(int(run.right[n - 1]) for run in runs)
    return right / visits if visits >= 30 else np.nan
