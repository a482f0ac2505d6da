"""What the experiments of a lesson give: claims and figures."""

from collections.abc import Sequence
from typing import NamedTuple

from edugym.plotting.sheet import Sheet
from edugym.results.claims import Claim


class Report(NamedTuple):
    """The outcome of the experiments of a lesson.

    Attributes:
        claims: the claims, each with its measurement.
        figures: the figures to draw; none after an interruption.
    """

    claims: Sequence[Claim]
    figures: Sequence[Sheet]
