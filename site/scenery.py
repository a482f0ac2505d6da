"""The pictures of a task for the playground, and where the rows of a table lie in them.

Both come from the scenes that the environments draw themselves. What is the same in every picture is the background.
What is not is kept once, and each state has a list of what is to be seen there.
"""

from collections import Counter
from typing import Any

import numpy as np
from places import Map

from edugym.adapters.fitting import tabular
from edugym.mdp.frame_stack import FrameStack
from edugym.mdp.tabular import table_lows, table_sizes
from edugym.rendering.palette import YELLOW
from edugym.rendering.scene import Scene
from edugym.rendering.svg import to_svg


def table(where: Map, mdp: Any, seen: Any) -> dict[str, Any]:
    """Where each row of a table lies.

    Args:
        where: the map of the task.
        mdp: the task.
        seen: the task as an agent sees it.

    Returns:
        `cells`, rectangles; for each observation the index of its cell (-1 for none) and its `layers`; and the `sizes`
        and `lows` of the numbers in an observation. A table may have more rows: one that remembers has a row for each
        observation and each past, and the observation changes fastest.
    """
    space = (mdp if isinstance(seen, FrameStack) else seen).observation_space
    sizes, lows = table_sizes(space), [int(low) for low in table_lows(space)]
    places = [where.place(mdp, _observed(row, sizes, lows)) for row in range(int(np.prod(sizes)))]
    cells = list(dict.fromkeys(cell for cell, _ in places if cell is not None))
    index = {cell: k for k, cell in enumerate(cells)}
    return {
        "cells": [[round(part, 4) for part in cell] for cell in cells],
        "cell": [-1 if cell is None else index[cell] for cell, _ in places],
        "layer": [layer for _, layer in places],
        "rows": int(tabular(seen).observation_space.n),
        "sizes": sizes,
        "lows": lows,
    }


def _observed(row: int, sizes: tuple[int, ...], lows: list[int]) -> tuple[int, ...]:
    return tuple(int(part) + low for part, low in zip(np.unravel_index(row, sizes), lows, strict=True))


def scenery(where: Map, mdp: Any) -> dict[str, Any]:
    """The pictures of a task: size, background, and what changes.

    Returns:
        `width`, `height`, `colour` and `background`; `parts`, elements of SVG, and `moments`, by the numbers that
        decide a picture, the indices of its parts. The first parts, so many as `behind` says, are to be seen in many
        pictures, and no face: they lie behind what an agent knows. Where pictures move without steps, `moves` says how
        instead.
    """
    states = list(where.pictures(mdp))
    scene = where.scene(mdp, states[0])
    drawn = {key_of(where, mdp, state): elements(where.scene(mdp, state)) for state in states}
    moves = where.moves(mdp)
    actors = {element for elements in drawn.values() for element in _from_the_face_on(elements) if not moves}
    common = set.intersection(*map(set, drawn.values())) - actors
    found: dict[str, Any] = {
        "width": scene.width,
        "height": scene.height,
        "colour": scene.background,
        "background": "".join(element for element in elements(scene) if element in common),
    }
    if moves:
        return found | {"moves": moves}
    changing = Counter(element for elements in drawn.values() for element in elements if element not in common)
    usual = [element for element, times in changing.items() if times > 0.6 * len(drawn) and element not in actors]
    parts = {element: k for k, element in enumerate(dict.fromkeys([*usual, *changing]))}
    moments = {key: [parts[element] for element in elements if element in parts] for key, elements in drawn.items()}
    return found | {"parts": list(parts), "behind": len(usual), "moments": moments}


def elements(scene: Scene) -> list[str]:
    """The shapes of a scene as SVG, without title and background."""
    return to_svg(scene).split("\n")[3:-1]


def _from_the_face_on(elements: list[str]) -> list[str]:
    """The face, which is the last that is yellow, and what is drawn after it."""
    yellow = [k for k, element in enumerate(elements) if f'fill="{YELLOW}"' in element and "<circle" in element]
    return elements[yellow[-1] :] if yellow else []


def key_of(where: Map, mdp: Any, state: Any) -> str:
    """The numbers that decide the picture of a state."""

    def part(name: str) -> int:
        if name == "observation":
            return int(mdp.observation(state, np.random.default_rng(0)))
        return int(getattr(state, name[1:]) if name else state)

    return ",".join(str(part(name)) for name in where.look)
