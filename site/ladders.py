"""The ladders of an agent as pictures for its page: small SVGs in the colours of the page, light or dark."""

from html import escape
from typing import NamedTuple

from edugym import Interval, Profile
from edugym.experiments.profiles.pictures import scores_of
from edugym.experiments.profiles.scores import HALF
from edugym.experiments.profiles.words import written

WIDTH, HEIGHT = 320, 170
LEFT, RIGHT, TOP, BOTTOM = 34, 306, 10, 124
"""The edges of the part in which scores are drawn."""
LOWEST, HIGHEST = -0.25, 1.1
"""The scores at its lower and upper edge; a score beyond is drawn at the edge."""


class Place(NamedTuple):
    """A point of the picture."""

    x: float
    y: float

    def __str__(self) -> str:
        """As SVG writes it."""
        return f"{self.x:.1f},{self.y:.1f}"


def ladder(profile: Profile, agent: str, challenge: str, says: str) -> str:
    """Return the ladder of a challenge as SVG on one line: the score of an agent on each rung, all others in grey.

    Args:
        profile: the profile with all agents.
        agent: the one whose page it is.
        challenge: a challenge that it can enter.
        says: what the picture shows, for those who do not see it.
    """
    climbed = profile.ladder(challenge)
    rungs = profile.rungs(agent, challenge)
    means = [rung.estimate for rung in rungs]
    others = [name for name in scores_of(profile, challenge) if name != agent]
    lines = [[rung.estimate for rung in profile.rungs(other, challenge)] for other in others]
    strengths = zip(_places(means), climbed.strengths, strict=True)
    parts = [
        *(_level(score) for score in (0.0, HALF, 1.0)),
        *(_text(place.x, BOTTOM + 16, written(strength)) for place, strength in strengths),
        _text((LEFT + RIGHT) / 2, HEIGHT - 10, climbed.strength),
        *(f'<polyline class="other" points="{_line(scores)}"/>' for scores in lines),
        f'<polygon class="interval" points="{_band(rungs)}"/>',
        f'<polyline class="own" points="{_line(means)}"/>',
        *(f'<circle class="own" cx="{place.x:.1f}" cy="{place.y:.1f}" r="3.2"/>' for place in _places(means)),
    ]
    size = f'viewBox="0 0 {WIDTH} {HEIGHT}"'
    return f'<div><svg role="img" aria-label="{escape(says)}" {size}>{"".join(parts)}</svg></div>'


def _text(x: float, y: float, text: str, anchor: str = "middle") -> str:
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}">{escape(text)}</text>'


def _level(score: float) -> str:
    """A line at a score, with its number."""
    y = _y(score)
    kind = "half" if score == HALF else "level"
    line = f'<line class="{kind}" x1="{LEFT}" x2="{RIGHT}" y1="{y:.1f}" y2="{y:.1f}"/>'
    return line + _text(LEFT - 7, y + 4, f"{score:g}", "end")


def _line(scores: list[float]) -> str:
    return " ".join(map(str, _places(scores)))


def _band(rungs: list[Interval]) -> str:
    """The interval around the scores: there along its lower edge, and back along the upper one."""
    low, high = _places([rung.low for rung in rungs]), _places([rung.high for rung in rungs])
    return " ".join(map(str, [*low, *reversed(high)]))


def _places(scores: list[float]) -> list[Place]:
    return [Place(_x(k, len(scores)), _y(score)) for k, score in enumerate(scores)]


def _x(rung: int, n_rungs: int) -> float:
    """Where a rung is, from the left."""
    inside = 14
    return LEFT + inside + rung * (RIGHT - LEFT - 2 * inside) / max(1, n_rungs - 1)


def _y(score: float) -> float:
    """Where a score is, from above."""
    return BOTTOM - (min(max(score, LOWEST), HIGHEST) - LOWEST) / (HIGHEST - LOWEST) * (BOTTOM - TOP)
