"""The figures of lesson 17."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from edugym.adapters.registration import make_mdp
from edugym.exact.maximisation import expected_maximum
from edugym.experiments.figures.against import Against
from edugym.experiments.figures.sheet import Sheet
from edugym.mdp.protocol import Reals
from edugym_course.lessons.maximisation_bias.methods import (
    DOUBLE,
    EPSILON,
    N_MACHINES,
    Q_LEARNING,
    Tried,
    Walks,
    tried,
    walks,
)

BLOCK = 10
"""So many episodes are one point of a line."""
TRIES = (1, 2, 5, 10, 20, 50, 100)


def visits(found: Mapping[str, Walks], n_machines: int = N_MACHINES, name: str = "visits") -> Sheet:
    """Return how often each method goes in, by episode; dashed, what the best ε-greedy policy does."""
    lines = {label: _in_blocks(one.went_in) for label, one in found.items()}
    return Sheet(name, [[_over_episodes(lines, "share of episodes in the casino", EPSILON / max(2, n_machines))]])


def incomes(found: Mapping[str, Walks], best: float, name: str = "incomes") -> Sheet:
    """Return what each method earns in an episode; dashed, what the best ε-greedy policy earns."""
    lines = {label: _in_blocks(one.earned, 3 * BLOCK) for label, one in found.items()}
    return Sheet(name, [[_over_episodes(lines, "return of an episode", best, 3 * BLOCK)]])


def _in_blocks(by_episode: Reals, size: int = BLOCK) -> list[Reals]:
    """The means of each block of episodes, a row for each block, by run."""
    runs, episodes = by_episode.shape
    blocks: Reals = by_episode[:, : episodes // size * size].reshape(runs, -1, size).mean(axis=2)
    return [*blocks.T]


def _over_episodes(lines: Mapping[str, Sequence[Reals]], y_label: str, best: float, size: int = BLOCK) -> Against:
    n_blocks = len(next(iter(lines.values())))
    middles = [size * (block + 0.5) for block in range(n_blocks)]
    theory = {"best ε-greedy policy": np.full(n_blocks, best)}
    return Against(middles, lines, "", "episode", y_label, theory)


def promises(by_machines: Mapping[str, Sequence[Tried]], exact: Mapping[str, Reals]) -> Sheet:
    """Return what the largest mean promises against the number of tries; dashed, the exact values."""
    lines = {label: [one.largest for one in row] for label, row in by_machines.items()}
    panel = Against(TRIES, lines, "", "tries of each machine", "largest mean payoff", exact, log=True)
    return Sheet("promises", [[panel]])


def measured_promises(**how: Any) -> Sheet:
    """Measure these promises in casinos with 2 and with 10 machines, and compute them."""
    of = {k: f"{k} machines" for k in (10, 2)}
    measured = {label: [tried(n, n_machines=k, **how) for n in TRIES] for k, label in of.items()}
    exact = {
        f"{label}, exact": np.array([expected_maximum(make_mdp("Casino", n_machines=k).payoffs, n) for n in TRIES])
        for k, label in of.items()
    }
    return promises(measured, exact)


def one_setting(n_machines: int, noise: float, n_tables: int, **how: Any) -> Sheet:
    """Return how often three methods go in, in a few runs, for sliders."""
    few: dict[str, Any] = {"repetitions": 20, "n_machines": n_machines, "noise": noise, **how}
    found = {
        Q_LEARNING: walks(Q_LEARNING, 200, **few),
        DOUBLE: walks(DOUBLE, 200, **few),
        f"maxmin Q-learning, N = {n_tables}": walks(Q_LEARNING, 200, n_tables=n_tables, **few),
    }
    return visits(found, n_machines, "one_setting")
