"""A recurrent network as a picture."""

from edugym.rendering.palette import BLUE, GREEN, ORANGE, WHITE, blend
from edugym.rendering.scene import Circle, Line, Rectangle, Scene, Shape, Text

STEPS = ("t − 1", "t", "t + 1")


def recurrent_cell() -> Scene:
    """Draw three steps of a recurrent network, from left to right: the same cell each time."""
    shapes = list[Shape]()
    for k, step in enumerate(STEPS):
        x = 3.5 + 4.5 * k
        memory, before = f"M({step})", f"M({'t − 2' if k == 0 else STEPS[k - 1]})"
        if k == 0:
            shapes += [*_arrow(0.6, 4.0, x - 1.0, 4.0), Text(1.3, 3.5, before, 0.45)]
        to = x + 3.5 if k + 1 < len(STEPS) else x + 2.3
        shapes += [*_arrow(x + 1.0, 4.0, to, 4.0), Text(x + 2.1, 3.5, memory, 0.45)]
        shapes += _arrow(x, 6.6, x, 5.0)
        shapes += _arrow(x, 3.0, x, 1.9)
        shapes.append(Rectangle(x - 1.0, 3.0, 2.0, 2.0, 0.25, fill=blend(ORANGE, WHITE, 0.45)))
        shapes.append(Text(x, 4.0, "u", 0.9))
        shapes.append(Circle(x, 7.3, 0.7, fill=blend(BLUE, WHITE, 0.55)))
        shapes.append(Text(x, 7.3, "O", 0.6))
        shapes.append(Text(x, 8.4, f"observation {step}", 0.42))
        shapes.append(Rectangle(x - 1.0, 0.9, 2.0, 1.0, 0.2, fill=blend(GREEN, WHITE, 0.55)))
        shapes.append(Text(x, 1.4, "policy", 0.5))
    title = (
        "A recurrent network at three steps. At each the same cell u makes the new memory of the old memory and the"
        " observation. The policy reads the memory."
    )
    return Scene(15.8, 9.0, shapes, title=title)


def _arrow(x: float, y: float, to_x: float, to_y: float) -> list[Shape]:
    """Return an arrow along an axis."""
    dx, dy = (0.25 * ((to > at) - (to < at)) for at, to in ((x, to_x), (y, to_y)))
    head = [(to_x - dx - dy * 0.7, to_y - dy - dx * 0.7), (to_x, to_y), (to_x - dx + dy * 0.7, to_y - dy + dx * 0.7)]
    return [Line([(x, y), (to_x, to_y)], line_width=0.08), Line(head, line_width=0.08)]
