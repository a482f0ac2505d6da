"""How many bits a word carries, on one axis: for a toy in perfect care, and for the toy that somebody plays."""

import numpy as np

from edugym.rendering.palette import BLUE, GREEN, RED, WHITE, blend
from edugym.rendering.scene import Line, Polygon, Rectangle, Scene, Shape, Text
from edugym_course.lessons.signal.words import bits, joint_table

LEFT, LENGTH, MOST = 1.5, 13.0, 2.0
"""Where the axis begins, how long it is, and how many bits that is."""
MEANING = {0.0: "nothing", 1.0: "which pair of needs", 2.0: "which need"}
"""What somebody knows who is told so many bits, if all needs are equally likely."""


def bits_axis(tau: float = 0.05) -> Scene:
    """Draw what a word carries about the wanted action, by who cares for the toy, at a noise."""
    tables = {"a toy in perfect care": joint_table(tau), "the toy of a player who obeys": joint_table(tau, obeyed=True)}
    shapes: list[Shape] = [Rectangle(LEFT, 3.3, LENGTH, 1.4, fill=blend(GREEN, WHITE, 0.7), outline=None)]
    shapes.append(Line([(LEFT, 4.0), (LEFT + LENGTH, 4.0)], line_width=0.08))
    for tick in np.arange(0.0, MOST + 0.1, 0.5):
        shapes += [Line([(_place(tick), 3.85), (_place(tick), 4.15)], line_width=0.06)]
        shapes += [Text(_place(tick), 5.2, f"{tick:g}", 0.5)]
    shapes += [Text(_place(bit), 5.85, words, 0.42) for bit, words in MEANING.items()]
    shapes.append(Text(LEFT + LENGTH / 2, 6.7, "bits that a word carries about the wanted action", 0.45))
    told = []
    for k, ((who, table), colour) in enumerate(zip(tables.items(), (BLUE, RED), strict=True)):
        carried = abs(bits(table))
        x, tip, end = _place(carried), (3.8, 4.2)[k], (3.3, 4.7)[k]
        shapes.append(Polygon([(x, tip), (x - 0.28, end), (x + 0.28, end)], fill=colour))
        words = f"{who}: {carried:.2f} bit, {100 * float(np.trace(table)):.0f} % of the words are right"
        shapes.append(Rectangle(0.7, 1.3 + 0.8 * k, 0.35, 0.35, fill=colour))
        shapes.append(Text(1.3, 1.48 + 0.8 * k, words, 0.45, anchor="start"))
        told.append(words)
    shapes.append(Text(LEFT + LENGTH / 2, 0.6, f"noise τ = {tau:g}", 0.55))
    return Scene(16.0, 7.3, shapes, title=f"With the noise {tau:g}: {told[0]}; {told[1]}.")


def _place(carried: float) -> float:
    return LEFT + LENGTH * carried / MOST
