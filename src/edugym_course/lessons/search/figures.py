"""The figures of lesson 18."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from edugym.agents.uct import UCT
from edugym.experiments.figures.against import Against
from edugym.experiments.figures.lines import Lines
from edugym.experiments.figures.sheet import Sheet
from edugym.mdp.protocol import Reals
from edugym_course.lessons.model_based.maps import FloorMap
from edugym_course.lessons.search.methods import (
    BRANCHES,
    DOOR,
    NUMBERS,
    OPTIMUM,
    SIMULATIONS,
    model_of_map,
    searched,
    searcher,
    shop,
)
from edugym_course.lessons.search.plans import DEPTHS, SOCCER_DEPTHS, in_soccer, in_the_shop, random_play

TREE, ROLL_OUTS = "UCT", "plain roll-outs"
IDLE, COPIES = "more actions that stand still", "more actions that repeat the four"
RIGHT, WRONG = "in the right model", "in the wrong model"
FEW = NUMBERS[:4]


def over_simulations(found: Mapping[str, Sequence[Reals]], numbers: Sequence[int] = NUMBERS) -> Sheet:
    """Return what searches get against the number of simulations; dashed, what they would come to, exactly."""
    theory = {
        "the exact look-ahead": np.full(len(numbers), OPTIMUM),
        "the best action by the values of random play": np.full(len(numbers), random_play()),
    }
    panel = Against(numbers, found, "", "simulations before each step", "return of an episode", theory, log=True)
    return Sheet("over_simulations", [[panel]])


def measured_simulations(**how: Any) -> tuple[Sheet, dict[str, list[Reals]]]:
    """Measure these returns, and return them with their figure."""
    found = {
        TREE: [searched(simulations=number, **how) for number in NUMBERS],
        ROLL_OUTS: [searched(simulations=number, nodes=1, **how) for number in NUMBERS],
    }
    return over_simulations(found), found


def one_setting(depth: int, c: float, **how: Any) -> Sheet:
    """Return the returns of up to 1000 simulations in a few episodes, for sliders."""
    few: dict[str, Any] = {"repetitions": 20, "depth": depth, "c": c, **how}
    found = {
        TREE: [searched(simulations=number, **few) for number in FEW],
        ROLL_OUTS: [searched(simulations=number, nodes=1, **few) for number in FEW],
    }
    panel = Against(FEW, found, "", "simulations before each step", "return of an episode", log=True)
    return Sheet("one_setting", [[panel]])


def over_branches(found: Mapping[str, Sequence[Reals]]) -> Sheet:
    """Return what UCT gets against the number of actions, with as many simulations."""
    panel = Against(BRANCHES, found, "", "number of actions", "return of an episode", log=True)
    return Sheet("over_branches", [[panel]])


def over_depth() -> Sheet:
    """Return what looking ahead is worth against its depth, exactly: in the shop, and in soccer."""
    shops = {RIGHT: in_the_shop(), WRONG: in_the_shop(DOOR)}
    games = {RIGHT: in_soccer(True), WRONG: in_soccer(False)}
    return Sheet(
        "over_depth",
        [
            [
                Lines(np.array(DEPTHS), shops, "Supermarket: the old map", "steps of look-ahead", "expected return"),
                Lines(
                    np.array(SOCCER_DEPTHS), games, "Soccer: another opponent", "steps of look-ahead", "expected return"
                ),
            ]
        ],
    )


def nodes_by_cell(agent: UCT) -> Reals:
    """Return how many nodes of the latest tree are in each cell of the shop, whatever is in the bag, shape (100,)."""
    counts: Reals = np.bincount(agent.tree.states[: agent.tree.n[0]] // 8, minlength=100).astype(float)
    return counts


def tree_maps(simulations: int = SIMULATIONS, cs: Sequence[float] = (1.0, 10.0, 100.0), seed: int = 0) -> Sheet:
    """Return where the nodes of one search from the entrance are, for some constants c."""
    panels = []
    for c in cs:
        agent, start = searcher(model_of_map(), c=c, simulations=simulations), shop().initial(np.random.default_rng(0))
        agent.greedy(start, np.random.default_rng(seed))
        counts = nodes_by_cell(agent)
        Q = np.full((800, 4), np.nan)
        Q[::8] = np.where(counts > 0, np.log10(np.maximum(counts, 1.0)), np.nan)[:, np.newaxis]
        panels.append(FloorMap(Q, f"c = {c:g}", highest=3.0, label="nodes of the tree (log$_{10}$)"))
    return Sheet("tree_maps", [panels])
