"""How agents see tasks: with a memory, in bins, as pixels in changing light, or with one reward made of two."""

from functools import cache, partial
from typing import Any

import numpy as np
from offers import View, as_it_is

import edugym
import edugym.objectives
from edugym_course.lessons.continuous_actions.methods import CELLS, in_a_table
from edugym_course.lessons.dimensionality import methods as dimensionality
from edugym_course.lessons.objectives import methods as objectives


@cache
def window(k: int, actions: bool) -> View:
    """A memory of the last k sights, and of the actions between them if wanted."""
    more = ", actions=True" if actions else ""
    code = f"edugym.FrameStack.create(mdp, k={k}{more})"
    return View(partial(edugym.FrameStack.create, k=k, actions=actions), code)


@cache
def bins(n: int) -> View:
    """A robot arm for a table: n angles for each joint, and the wrist in cells."""
    cells = f"[1, 1, {CELLS}, {CELLS}, 1, 1, 3]"
    code = f"edugym.Discretised.create(edugym.DiscreteActions.create(mdp, {n}), {cells})"
    return View(lambda mdp: in_a_table(n, width=mdp.container_width), code)


DARKEST, ROOM = dimensionality.DARKEST, 30_000
BOARD = 'edugym.make_mdp("Catch", columns=mdp.columns)'
IN_LIGHT = f"edugym.Brightness.create({BOARD}, {DARKEST:g})"


def board(mdp: Any) -> Any:
    """Catch seen as pixels."""
    return edugym.make_mdp("Catch", columns=mdp.columns)


def in_light(mdp: Any) -> Any:
    """The same, brighter or darker at every step."""
    return edugym.Brightness.create(board(mdp), DARKEST)


def hashed(mdp: Any) -> Any:
    """The same with a row for each board that occurs."""
    return edugym.Hashed.create(in_light(mdp), ROOM, overflow=True)


PIXELS = View(board, BOARD, board)
CHANGING = View(in_light, IN_LIGHT, board)
LISTED = View(hashed, f"edugym.Hashed.create({IN_LIGHT}, {ROOM:_}, overflow=True)", board)
STEADY = View(lambda mdp: edugym.Hashed.create(board(mdp), ROOM), f"edugym.Hashed.create({BOARD}, {ROOM:_})", board)


def priced(price: float) -> View:
    """Diver with one reward: the value, less the price of each step."""
    code = f"edugym.objectives.Weighted.create(mdp, (1.0, {price}))"
    return View(lambda mdp: edugym.objectives.Weighted.create(mdp, (1.0, price)), code)


def within_the_air(mdp: Any) -> Any:
    """Diver where treasures that take too long are worth nothing, and steps cost nothing."""
    longest = (objectives.LIMIT - 1) // 2
    values = [value if k <= longest else 0.0 for k, value in enumerate(mdp.treasures)]
    return mdp._replace(treasures=np.array(values), weights=(1.0, 0.0))


ASKED = View(clean=as_it_is)
"""The task as it is; the agent is asked what it knows of each place."""
