"""The pictures of a profile: a radar for the overview, dots with intervals, and a ladder for each challenge."""

import math
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from edugym.experiments.figures.panel import ALONE, Place
from edugym.experiments.figures.sheet import Sheet
from edugym.experiments.figures.style import REFERENCE, add_legend, axes_or_new, dress, stroke
from edugym.experiments.profiles.scores import HALF, Profile
from edugym.experiments.profiles.words import written
from edugym.rendering.palette import INK

if TYPE_CHECKING:
    from matplotlib.axes import Axes

MARKERS = "osD^vPX"
"""The marks of the first, second, ... agent; after the last one the first comes again."""
OTHERS = "other agents"
"""What the legend calls the agents beside a profile."""
NAMED = "line of "
"""The id of a line, before the name of its agent; a page shows the name to whoever rests on the line."""
LOWEST = -0.25
"""The lowest score that a ladder shows."""
NEAR, MOST_ENDS = 0.1, 3
"""Grey lines that end so near to each other have one name, and so many ends are named."""
MOST_LETTERS = 22
"""More letters than these below a ladder stand aslant, so that they do not touch."""
RINGS = (0.25, 0.5, 0.75, 1.0)


class Radar(NamedTuple):
    """The scores of all challenges at a glance: one spoke a challenge, from 0 (or less) in the middle to 1.

    A radar misleads: its area grows with the square of the scores, and depends on the order of the spokes. Where an
    agent cannot enter a challenge, its line has a gap.

    Attributes:
        profile: the profile.
        title: the text above the axes.
    """

    profile: Profile
    title: str = "overview"

    def draw(self, ax: "Axes | None" = None, place: Place = ALONE) -> "Axes":
        """Draw the radar on `ax`, by default in a new figure, and return the axes."""
        ax = axes_or_new(ax)
        names = self.profile.challenges
        angles = np.array([math.pi / 2 - math.tau * k / len(names) for k in range(len(names))])
        spokes = np.stack([np.cos(angles), np.sin(angles)])
        around = np.linspace(0, math.tau, 200)
        for ring in RINGS:
            ax.plot(ring * np.cos(around), ring * np.sin(around), color=INK, linewidth=0.4, alpha=0.4)
        for name, (x, y) in zip(names, spokes.T, strict=True):
            ax.plot([0, x], [0, y], color=INK, linewidth=0.4, alpha=0.4)
            side = "center" if abs(x) < 0.1 else "left" if x > 0 else "right"
            ax.text(1.08 * x, 1.08 * y, name, ha=side, va="center", fontsize=8, color=INK)
        for index, agent in enumerate(self.profile.agents):
            scores = np.array([self.profile.score(agent, name).estimate for name in names])
            x, y = np.clip(scores, 0, 1) * spokes
            look = stroke(index)
            closed = np.append(x, x[0]), np.append(y, y[0])
            mark: dict[str, Any] = {"marker": MARKERS[index % len(MARKERS)], "markersize": 4}
            ax.plot(*closed, color=look.color, linestyle=look.linestyle, linewidth=1.6, label=agent, **mark)
        ax.set_aspect("equal")
        ax.set_xlim(-1.65, 1.65)
        ax.set_ylim(-1.2, 1.2)
        ax.set_axis_off()
        ax.set_title(self.title, color=INK, fontsize=10)
        if place.alone:
            add_legend(ax)
        return ax


class Dots(NamedTuple):
    """The score of every agent in every challenge, with its 95 % interval.

    Attributes:
        profile: the profile.
        beside: another one, whose agents are drawn in grey; None for none.
        title: the text above the axes.
    """

    profile: Profile
    beside: Profile | None = None
    title: str = "score, with 95 % interval"

    def draw(self, ax: "Axes | None" = None, place: Place = ALONE) -> "Axes":
        """Draw the dots on `ax`, by default in a new figure, and return the axes."""
        ax = axes_or_new(ax)
        names, agents = self.profile.challenges, self.profile.agents
        for index, agent in enumerate(agents):
            offset = 0.7 * ((index + 0.5) / len(agents) - 0.5)
            measured = [(k, self.profile.score(agent, name)) for k, name in enumerate(names)]
            found = [(k + offset, score) for k, score in measured if score.n]
            if found:
                y = [place for place, _ in found]
                x = np.array([score.estimate for _, score in found])
                ends = np.array([[score.estimate - score.low, score.high - score.estimate] for _, score in found]).T
                ends = np.where(np.isfinite(ends), ends, 0.0)
                color, mark = stroke(index).color, MARKERS[index % len(MARKERS)]
                ax.errorbar(x, y, xerr=ends, fmt=mark, color=color, markersize=4, linewidth=1.3, label=agent)
        for k, name in enumerate(names):
            others = [score for agent, score in scores_of(self.beside, name).items() if agent not in agents]
            label = OTHERS if k == 0 and self.beside is not None else None
            ax.plot(others, [k] * len(others), "|", color=INK, markersize=9, alpha=0.5, zorder=1, label=label)
        for k in range(1, len(names)):
            ax.axhline(k - 0.5, color=INK, linewidth=0.3, alpha=0.4)
        for value in (0, 1):
            ax.axvline(value, **REFERENCE)
        dress(ax, "0: random play, 1: best play", "", self.title)
        ax.set_yticks(range(len(names)), names)
        ax.set_ylim(len(names) - 0.5, -0.5)
        if place.alone and ax.get_legend_handles_labels()[1]:
            add_legend(ax)
        return ax


class Rungs(NamedTuple):
    """The ladder of a challenge: the mean score on each rung, from easy to hopeless, with its 95 % interval.

    Attributes:
        profile: the profile.
        challenge: one of its challenges.
        beside: another one, whose agents are drawn in grey if they climbed the same rungs; None for none.
    """

    profile: Profile
    challenge: str
    beside: Profile | None = None

    @property
    def title(self) -> str:
        """The name of the challenge."""
        return self.challenge

    def draw(self, ax: "Axes | None" = None, place: Place = ALONE) -> "Axes":
        """Draw the ladder on `ax`, by default in a new figure, and return the axes."""
        ax = axes_or_new(ax)
        ladder = self.profile.ladder(self.challenge)
        x = np.arange(len(ladder.strengths))
        if self.beside and self.beside.ladder(self.challenge).strengths == ladder.strengths:
            scores, ends = scores_of(self.beside, self.challenge), {}
            others = [agent for agent in scores if agent not in self.profile.agents]
            for number, agent in enumerate(sorted(others, key=lambda agent: -scores[agent])):
                means = [rung.estimate for rung in self.beside.rungs(agent, self.challenge)]
                look: dict[str, Any] = {"color": INK, "linewidth": 0.7, "alpha": 0.5, "gid": f"{NAMED}{agent}"}
                ax.plot(x, means, label=None if number else OTHERS, **look)
                ends[agent] = means[-1]
            for name, end in named_ends(ends):
                ax.text(x[-1] + 0.3, max(end, LOWEST), name, va="center", fontsize=7, alpha=0.8, color=INK)
            ax.set_xlim(-0.3, 1.57 * x[-1])
        for index, agent in enumerate(self.profile.agents):
            rungs = self.profile.rungs(agent, self.challenge)
            if any(rung.n == 0 for rung in rungs):
                continue
            low, high = np.array([[rung.low, rung.high] for rung in rungs]).T
            line = stroke(index)
            means = [rung.estimate for rung in rungs]
            mark: dict[str, Any] = {"marker": MARKERS[index % len(MARKERS)], "markersize": 4, "gid": f"{NAMED}{agent}"}
            ax.plot(x, means, color=line.color, linestyle=line.linestyle, linewidth=1.6, label=agent, **mark)
            finite = np.isfinite(low) & np.isfinite(high)
            ax.fill_between(x, low, high, where=finite, color=line.color, alpha=0.16, linewidth=0)
        ax.axhline(HALF, **REFERENCE)
        dress(ax, ladder.strength, "score on the rung", self.title)
        labels = [written(strength) for strength in ladder.strengths]
        ax.set_xticks(x, labels, rotation=40 if sum(map(len, labels)) > MOST_LETTERS else 0)
        ax.set_ylim(LOWEST, 1.1)
        if place.alone and ax.get_legend_handles_labels()[1]:
            add_legend(ax)
        return ax


def named_ends(ends: dict[str, float]) -> list[tuple[str, float]]:
    """The names of lines and where they stand: where several lines end, the first and how many more there are.

    Args:
        ends: the height at which the line of each agent ends, those first that are to be named.
    """
    found: list[tuple[list[str], float]] = []
    for agent, end in ends.items():
        for names, height in found:
            if abs(end - height) < NEAR:
                names.append(agent)
                break
        else:
            found.append(([agent], end))
    return [(f"{names[0]} + {len(names) - 1}" if names[1:] else names[0], end) for names, end in found[:MOST_ENDS]]


def scores_of(profile: Profile | None, challenge: str) -> dict[str, float]:
    """The scores of all agents of a profile that enter a challenge, by label; none where it has no such challenge."""
    if profile is None or challenge not in profile.challenges:
        return {}
    scores = {agent: profile.score(agent, challenge) for agent in profile.agents}
    return {agent: score.estimate for agent, score in scores.items() if score.n}


def picture(profile: Profile, beside: Profile | None = None) -> Sheet:
    """Radar, dots and ladders in one figure."""
    ladders = [Rungs(profile, name, beside) for name in profile.challenges]
    rows = [ladders[first : first + 3] for first in range(0, len(ladders), 3)]
    return Sheet("profile", [[Radar(profile), Dots(profile, beside)], *rows])
