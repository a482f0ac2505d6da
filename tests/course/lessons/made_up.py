"""Results and agents that are made up, so that what claims measure can be worked out by hand."""

from collections.abc import Iterable, Mapping, Sequence
from types import SimpleNamespace
from typing import Any, NamedTuple

import pandas as pd
from gymnasium.spaces import Discrete

from edugym.experiments.results.claims import Claim
from edugym.experiments.results.tables import Results

Curve = Mapping[int, float]


def finals(returns: Mapping[str, Sequence[float]], n_steps: int = 10) -> Results:
    """Return results with one point, after the last step: the return of each run, by method."""
    return made_up({method: [{n_steps: value} for value in values] for method, values in returns.items()}, n_steps)


def made_up(
    curves: Mapping[str, Sequence[Curve]],
    n_steps: int = 10,
    agents: Mapping[str, Sequence[Any]] | None = None,
    **columns: Any,
) -> Results:
    """Return results with the return of each run of each method by step, which is the training return too.

    Each point stands for one episode. A column is one value, or a list of one for each repetition.
    """
    rows = [
        {"method": method, "repetition": i, "step": step, "return": value, "training_return": value, "episodes": 1}
        | {name: values[i] if isinstance(values, list) else values for name, values in columns.items()}
        for method, runs in curves.items()
        for i, run in enumerate(runs)
        for step, value in run.items()
    ]
    several = {"n_steps": n_steps, "repetitions": max(len(runs) for runs in curves.values()), "complete": True}
    by_run = {method: dict(enumerate((agents or {}).get(method, []))) for method in curves}
    return Results(pd.DataFrame(rows).assign(**several), by_run)


def follower(actions: Mapping[int, int], **more: Any) -> Any:
    """Return an agent that takes these actions by the rows of its table, in all others action 0."""
    return SimpleNamespace(greedy=lambda row, rng: actions.get(row, 0), **more)


def measured(claims: Iterable[Claim]) -> list[float]:
    """Return what the claims measure, without the intervals, to six digits."""
    return [round(claim.measured.estimate, 6) for claim in claims]


class Circle(NamedTuple):
    """A problem of a student's own: action 0 never ends an episode, and every step costs."""

    max_steps: int | None = None
    states: int = 5
    actions: int = 2

    @property
    def observation_space(self) -> Discrete:
        """Five states, or as many as there are."""
        return Discrete(self.states)

    @property
    def action_space(self) -> Discrete:
        """Stay or go, and others that do what staying does."""
        return Discrete(self.actions)

    def initial(self, rng: Any) -> int:
        """The beginning."""
        return 0

    def transition(self, state: int, action: int, rng: Any) -> int:
        """Stay, or go on with luck."""
        return state + 1 if action == 1 and rng.random() < 0.5 else state

    def reward(self, state: int, action: int, next_state: int, rng: Any) -> float:
        """Each step costs."""
        return -1.0

    def terminal(self, state: int) -> bool:
        """At the end."""
        return state == self.states - 1

    def observation(self, state: int, rng: Any) -> int:
        """The state."""
        return state
