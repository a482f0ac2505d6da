"""Common axes of several figures: where a reader turns from one to the next, only what has changed should move."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SMALLEST = 1 / 5
"""What is left of an axis at least: with less of it, curves could not be told apart any more."""


def share_axes(figures: Sequence["Figure"]) -> bool:
    """Give the axes at the same place of several figures the same range.

    An axis keeps its own range where that of some figure would take less than a fifth of the common one, and so does
    one whose values cannot be compared: with another kind of scale or other names, of a picture, or of colours.

    Args:
        figures: of one function, for different arguments; their axes are changed.

    Returns:
        Whether some axis still has another range in another figure.
    """
    rows = [figure.axes for figure in figures]
    if len({len(row) for row in rows}) > 1:
        return True
    differ = False
    for place in zip(*rows, strict=True):
        for side in ("x", "y"):
            ranges = [getattr(axes, f"get_{side}lim")() for axes in place]
            if len(set(ranges)) > 1:
                common = _common([getattr(axes, f"{side}axis") for axes in place], ranges)
                differ = differ or common is None
                for axes in place if common else ():
                    getattr(axes, f"set_{side}lim")(common)
    return differ


def _common(axes: list[Any], ranges: list[tuple[float, float]]) -> tuple[float, float] | None:
    """The range that several axes can share, or None."""
    from matplotlib.ticker import FixedLocator

    fixed = {
        tuple(axis.get_majorticklocs()) if isinstance(axis.get_major_locator(), FixedLocator) else None for axis in axes
    }
    drawn = [axis.axes for axis in axes]
    if len({axis.get_scale() for axis in axes}) > 1 or len(fixed) > 1:
        return None
    if any(
        one.images or hasattr(one, "_colorbar") or low >= high for one, (low, high) in zip(drawn, ranges, strict=True)
    ):
        return None
    common = min(low for low, _ in ranges), max(high for _, high in ranges)
    spans = [high - low for low, high in (axes[0].get_transform().transform(one) for one in [*ranges, common])]
    return common if min(spans) >= SMALLEST * spans[-1] else None
