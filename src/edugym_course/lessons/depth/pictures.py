"""The buffer of n-step SARSA as a picture."""

from edugym.rendering.palette import BLUE, ORANGE, PAPER, SHADE, WHITE, blend
from edugym.rendering.scene import Line, Rectangle, Scene, Shape, Text

NEW, FIRST = blend(BLUE, WHITE, 0.6), blend(ORANGE, WHITE, 0.4)
"""What has just been stored, and the step whose rewards are complete."""
WIDTH = 1.8
"""Of a box."""


def buffer(n: int = 3, t: int = 5) -> Scene:
    """Draw what n-step SARSA has stored after step t: the episode above, and the places of its arrays below.

    Args:
        n: how many rewards a target has, from 1 to 4.
        t: the last step, from n on.
    """
    first = t - n + 1
    left, shapes = 5.8, list[Shape]()

    def row(y: float, label: str, contents: dict[int, str], coloured: dict[int, str]) -> None:
        """Add a row of boxes, each with the number of its place above."""
        shapes.append(Text(0.3, y + 0.5, label, 0.5, anchor="start"))
        for place, content in sorted(contents.items()):
            x = left + WIDTH * place
            shapes.append(Rectangle(x, y, WIDTH - 0.1, 1.0, 0.1, fill=coloured.get(place, PAPER)))
            shapes.append(Text(x + WIDTH / 2, y + 0.5, content, 0.45))

    steps = range(t + 2)
    old = dict.fromkeys(range(first), SHADE)
    row(0.9, "states so far", {k: f"S{k}" for k in steps}, {**old, first: FIRST, t + 1: NEW})
    row(2.1, "actions, rewards", {k: f"A{k}, R{k + 1}" for k in range(t + 1)}, {**old, first: FIRST, t: NEW})
    kept = range(first, t + 2)
    states = {k % (n + 1): f"S{k}" for k in kept}
    pairs = {k % n: f"A{k}, R{k + 1}" for k in range(first, t + 1)}
    row(4.6, f"states, place k % {n + 1}", states, {first % (n + 1): FIRST, (t + 1) % (n + 1): NEW})
    row(6.6, f"the rest, place k % {n}", pairs, {first % n: FIRST, t % n: NEW})
    for y, places in ((5.85, n + 1), (7.85, n)):
        shapes += [Text(left + WIDTH * place + WIDTH / 2, y, str(place), 0.4) for place in range(places)]
    shapes.append(Text(0.3, 0.4, "the episode", 0.5, anchor="start"))
    shapes.append(Text(0.3, 4.1, f"what is kept, n = {n}", 0.5, anchor="start"))
    shapes.append(Line([(0.3, 3.5), (left + WIDTH * (t + 2), 3.5)]))
    title = (
        f"The buffer of {n}-step SARSA after step {t} of an episode: it holds the states {first} to {t + 1}, and the"
        f" last {n} actions and rewards. What is new overwrites what is oldest. Step {first} learns now."
    )
    return Scene(left + WIDTH * (t + 2) + 0.3, 8.3, shapes, title=title)
