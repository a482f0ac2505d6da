"""The figures of lesson 13."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from edugym.experiments.figures.curves import Curves
from edugym.experiments.figures.lines import Lines
from edugym.experiments.figures.panel import With
from edugym.experiments.figures.sheet import Sheet, in_pairs
from edugym.experiments.figures.style import format_steps
from edugym.experiments.results.tables import Results
from edugym_course.lessons.several_agents import methods

if TYPE_CHECKING:
    from matplotlib.axes import Axes

EXPLOITABILITY = "exploitability (exact)"


def exploited(results: Results, title: str, top: float = 0.7, label: str = EXPLOITABILITY) -> Curves:
    """Return how exploitable players are while they learn; an equilibrium is at 0."""
    known: Any = {"soft_optimum": 0.0, "soft_label": "equilibrium"}
    return Curves(results, title, y_label=label, y_range=(-0.02 * top, top), **known)


def learning(by_title: Mapping[str, Results], top: float = 0.7, name: str = "exploitability") -> Sheet:
    """Return a panel for each experiment, by its title, two in a row."""
    return in_pairs(name, [exploited(results, title, top) for title, results in by_title.items()])


ACTIONS = ("rock", "paper", "scissors")
APART = 0.08
"""How far above the line of player 0 that of player 1 is drawn."""


def answers(runs: Mapping[str, Any]) -> Sheet:
    """Return the best actions of both players of rock-paper-scissors in some runs, by their titles."""
    panels = []
    for title, run in runs.items():
        actions = methods.best_actions(run)
        lines = {f"player {player}": actions[:, player] + APART * player for player in (0, 1)}
        panels.append(With(Lines(run.steps.astype(float), lines, title, "training steps", "best action"), _in_steps))
    return Sheet("answers", [panels])


def _in_steps(ax: "Axes") -> None:
    """Name the actions, and draw steps between the points."""
    ax.set_yticks(range(len(ACTIONS)), ACTIONS)
    ax.set_ylim(-0.3, len(ACTIONS) - 0.7)
    for line in ax.lines:
        line.set_drawstyle("steps-post")
    format_steps(ax)


def dilemma(temptation: float, learning_rate: float, epsilon: float, pairs: int = 10) -> Sheet:
    """Return how exploitable pairs of Q-learners in the prisoner's dilemma are, and what they do in the end."""
    results = methods.dilemma(temptation, learning_rate, epsilon, repetitions=pairs)
    silent, talk = (methods.choosing(results, action).sum() for action in (0, 1))
    title = f"temptation {temptation:g}: {silent:.0f} of {pairs} pairs silent, {talk:.0f} talk"
    return Sheet("dilemma", [[exploited(results, title, top=max(2.0, temptation / 2))]])


def one_match(contact: float, discount: float) -> Sheet:
    """Return how exploitable two kinds of players are in soccer, in one run each."""
    results = methods.compare(
        methods.soccer(contact), methods.BOTH, methods.N_STEPS, discount=discount, repetitions=1, points=3
    )
    lines = {method: results.learned(method).values[:, 0] for method in results.methods}
    steps = results.learned(methods.ALONE).steps.astype(float)
    title = f"contact {contact:g}, discount {discount:g}"
    known = {"equilibrium": np.zeros(len(steps))}
    panel = Lines(steps, lines, title, "training steps", EXPLOITABILITY, known)
    return Sheet("one_match", [[With(panel, _from_0)]])


def _from_0(ax: "Axes") -> None:
    """Set the scale of exploitability in soccer."""
    ax.set_ylim(-0.02, 0.7)
    format_steps(ax)
