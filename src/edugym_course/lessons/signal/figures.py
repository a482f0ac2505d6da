"""The figures of lesson 6."""

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from edugym.envs.tamagotchi import NEEDS, Tamagotchi
from edugym.experiments.figures.curves import Curves
from edugym.experiments.figures.lines import Lines
from edugym.experiments.figures.panel import With, on_axes
from edugym.experiments.figures.sheet import Sheet
from edugym.experiments.figures.style import (
    REFERENCE,
    SOFT_REFERENCE,
    dress,
    format_steps,
    stroke,
)
from edugym.experiments.results.statistics import mean_interval
from edugym.experiments.results.tables import Results
from edugym.mdp.protocol import Reals
from edugym.rendering.palette import BLUE, GREEN, INK, ORANGE, RED
from edugym_course.lessons.signal.methods import (
    LENGTHS,
    LONG,
    N_STEPS,
    NOISY,
    OPTIMUM,
    RANDOM_PLAY,
    TAUS,
    Maker,
    conditions,
    late,
    learn,
    noise_label,
    play,
    rows_of_table,
    vote,
)
from edugym_course.lessons.signal.words import information, joint_table

if TYPE_CHECKING:
    from matplotlib.axes import Axes

OBEY, VOTE, LEARNED, LONGER = "obey the first word", "majority vote", "Q-learning", "Q-learning, 1 600 000 steps"
VOTE_FOUR = "majority vote, four words"
STROKES: Mapping[str, int] = MappingProxyType({LEARNED: 0, OBEY: 1, VOTE: 2, VOTE_FOUR: 6, LONGER: 4})
"""The stroke of each player, the same in every figure; those of a reader come after them."""
OWN = (5, 6, 3)


class Points(NamedTuple):
    """What players earn, each at places of its own: means over repetitions, with their 95 % intervals as bands.

    Attributes:
        measured: by label of the player, the places and one row of returns for each: shape (n, repetitions).
        title: the text above the axes.
        x_label: the label of the x axis.
        marked: the player whose points are named.
        marks: the names of its points.
        shift: where they stand from the points, in typographic points: to the right, and up.
        optimum: the optimum, drawn as a dashed line.
        chance: what random actions return, drawn as a dotted line.
    """

    measured: Mapping[str, tuple[Sequence[float], Sequence[Reals]]]
    title: str = ""
    x_label: str = "I(X; Y) in bits, toy in perfect care"
    marked: str = ""
    marks: Sequence[str] = ()
    shift: tuple[float, float] = (6, -9)
    optimum: float = OPTIMUM
    chance: float = RANDOM_PLAY

    @on_axes
    def draw(self, ax: "Axes") -> None:
        """Draw the points."""
        spare = iter(OWN * len(self.measured))
        for label, (x, rows) in self.measured.items():
            look = stroke(STROKES[label] if label in STROKES else next(spare))
            intervals = [mean_interval(row) for row in rows]
            means = [one.estimate for one in intervals]
            ax.plot(x, means, color=look.color, linestyle=look.linestyle, linewidth=1.6, marker="o", ms=4, label=label)
            low, high = [one.low for one in intervals], [one.high for one in intervals]
            ax.fill_between(x, low, high, color=look.color, alpha=0.16, linewidth=0)
        if self.marked:
            ax.margins(y=0.12)  # room for the name of the lowest point
            x, rows = self.measured[self.marked]
            for at, row, text in zip(x, rows, self.marks, strict=True):
                ax.annotate(text, (at, row.mean()), self.shift, textcoords="offset points", fontsize=7, color=INK)
        ax.axhline(self.optimum, label="optimum", **REFERENCE)
        ax.axhline(self.chance, label="random actions", **SOFT_REFERENCE)
        dress(ax, self.x_label, "return", self.title)


def beside(curves: Curves, levels: Mapping[str, float], ticks: Sequence[int] = ()) -> With:
    """Return learning curves, and what other players earn, as level lines.

    Args:
        curves: the curves.
        levels: by label of the player, its mean return.
        ticks: the numbers on the x axis; none: as usual.
    """

    def more(ax: "Axes") -> None:
        for label, level in levels.items():
            look = SOFT_REFERENCE if label not in STROKES else stroke(STROKES[label])._asdict()
            ax.axhline(level, label=label, **{"linewidth": 1.4, **look})
        if ticks:
            ax.set_xticks(ticks)

    return With(curves, more)


class Table(NamedTuple):
    """A table of probabilities, with the numbers in it: which word comes with which need.

    Attributes:
        joint: shape (4, n): the probability of each need together with each word.
        title: the text above the axes.
        words: the name of each word.
    """

    joint: Reals
    title: str = ""
    words: Sequence[str] = NEEDS

    @on_axes
    def draw(self, ax: "Axes") -> None:
        """Draw the table."""
        ax.imshow(self.joint, cmap="Blues", vmin=0.0, vmax=0.5, aspect="auto")
        for (row, column), share in np.ndenumerate(self.joint):
            ax.text(column, row, f"{share:.2f}", ha="center", va="center", fontsize=8, color=INK)
        ax.set_xticks(range(len(self.words)), self.words)
        ax.set_yticks(range(4), NEEDS)
        dress(ax, "word y", "need x", self.title)


class Runs(NamedTuple):
    """The learning curve of every run by itself.

    Attributes:
        steps: shape (n,): the training steps.
        returns: shape (runs, n).
        title: the text above the axes.
    """

    steps: Reals
    returns: Reals
    title: str = ""

    @on_axes
    def draw(self, ax: "Axes") -> None:
        """Draw a line for each run."""
        for row in self.returns:
            ax.plot(self.steps, row, color=stroke(0).color, linewidth=0.7, alpha=0.7)
        ax.axhline(OPTIMUM, **REFERENCE)
        dress(ax, "training steps", "return (greedy)", self.title)
        format_steps(ax)


class Greedy(NamedTuple):
    """What Q-learning has learned to do: how often it answers each word with each action.

    Attributes:
        shares: shape (4 words, 4 actions).
        title: the text above the axes.
    """

    shares: Reals
    title: str = ""

    @on_axes
    def draw(self, ax: "Axes") -> None:
        """Draw a bar for each word."""
        left = np.zeros(len(self.shares))
        for action, colour in enumerate((ORANGE, BLUE, RED, GREEN)):
            ax.barh(range(len(left)), self.shares[:, action], left=left, color=colour, height=0.7, label=NEEDS[action])
            left = left + self.shares[:, action]
        ax.set_yticks(range(len(left)), NEEDS[: len(left)])
        ax.invert_yaxis()
        ax.set_xlim(0.0, 1.0)
        dress(ax, "share of the steps with this word", "word", self.title)


def figures(
    noise: Results,
    words: Results,
    four: Results,
    memory: Results,
    obeyed: Mapping[float, Reals],
    voted: Mapping[int, Reals],
) -> list[Sheet]:
    """Return the figures: learning curves, and returns against information."""
    return [
        Sheet("noise", [[Curves(noise, "noise of one word", optimum=OPTIMUM)]]),
        Sheet(
            "vocabulary",
            [[Curves(words, "words to say it, τ = 0", methods=["4 words", "16 words", "64 words", "2 words"])]],
        ),
        Sheet("memory", [[Curves(memory, "a toy with one word", optimum=OPTIMUM)]]),
        Sheet("information", [information_panels(noise, four, obeyed, voted)]),
    ]


def information_panels(
    noise: Results, four: Results, obeyed: Mapping[float, Reals], voted: Mapping[int, Reals]
) -> tuple[Lines, Lines]:
    """Return what a single word and what long messages carry, against the returns of obeying, voting and learning."""
    curve = four.curves("Q-learning").mean(axis=1)
    one_word = noise.mean(noise_label(NOISY)).estimate
    unknown = np.full(len(LENGTHS), np.nan)

    def learned(steps: int) -> Reals:
        return np.array([one_word, curve[steps], *unknown[2:]])

    players = "obey the first word", "majority vote", f"Q-learning, {N_STEPS} steps", f"Q-learning, {LONG} steps"
    taus = sorted(TAUS, reverse=True)  # from the least information
    single = (
        np.array([obeyed[tau].mean() for tau in taus]),
        unknown[: len(taus)],
        np.array([noise.mean(noise_label(tau)).estimate for tau in taus]),
        unknown[: len(taus)],
    )
    several = (
        np.full(len(LENGTHS), obeyed[NOISY].mean()),
        np.array([voted[length].mean() for length in LENGTHS]),
        learned(N_STEPS),
        learned(LONG),
    )
    x_label, y_label = "I(message; need) in bits", "return"
    return (
        Lines(
            np.array([information(tau) for tau in taus]),
            dict(zip(players, single, strict=True)),
            "one word, τ from ∞ to 0",
            x_label,
            y_label,
        ),
        Lines(
            np.array([information(NOISY, length) for length in LENGTHS]),
            dict(zip(players, several, strict=True)),
            "1 to 28 words, τ = 0.1",
            x_label,
            y_label,
        ),
    )


def joint_tables(taus: Sequence[float] = (0.0, 0.02, 0.05, 0.1)) -> Sheet:
    """Return how often each need comes with each word, at several τ."""
    panels = [Table(joint_table(tau), f"{noise_label(tau)}: {information(tau):.2f} bit") for tau in taus]
    return Sheet("words", [panels[:2], panels[2:]])


def answers(results: Results, tau: float, episodes: int = 5) -> Greedy:
    """Return how often Q-learning answers each word with each action, in greedy episodes of all runs."""
    toy, rng = Tamagotchi.create(tau), np.random.default_rng(0)
    counts = np.zeros((4, 4))
    for agent in results.complete_agents("Q-learning").values():
        for _ in range(episodes):
            state = toy.initial(rng)
            for _ in range(toy.max_steps):
                action = agent.greedy(4 * state.hp + state.message, rng)
                counts[state.message, action] += 1
                state = toy.transition(state, action, rng)
                if toy.terminal(state):
                    break
    return Greedy(counts / counts.sum(axis=1, keepdims=True), noise_label(tau))


def noise_sheet(by_tau: Mapping[float, Results]) -> Sheet:
    """Return the learning curves at several τ."""
    results = conditions({noise_label(tau): one for tau, one in by_tau.items()})
    return Sheet("noise", [[Curves(results, "Q-learning, messages of one word", optimum=OPTIMUM)]])


def one_word_panel(by_tau: Mapping[float, Results], repetitions: int = 10) -> Points:
    """Return what obeying and Q-learning earn, against the information in one word."""
    taus = sorted(by_tau, reverse=True)  # from the least information
    bits = [information(tau) for tau in taus]
    return Points(
        {
            OBEY: (bits, [vote(tau, 1, 1, repetitions=repetitions) for tau in taus]),
            LEARNED: (bits, [late(by_tau[tau], "Q-learning") for tau in taus]),
        },
        "one word, τ from ∞ to 0",
        marked=OBEY,
        marks=[noise_label(tau) for tau in taus],
    )


def messages_panel(
    lengths: Sequence[int] = LENGTHS,
    learned: Mapping[str, Mapping[int, Reals]] = MappingProxyType({}),
    own: Mapping[str, Maker] = MappingProxyType({}),
    *,
    tau: float = NOISY,
    repetitions: int = 10,
) -> Points:
    """Return what players earn with messages of several lengths, against the information in a message.

    Args:
        lengths: the numbers of words.
        learned: by label, the returns of Q-learning for some of the lengths.
        own: by label, players of the reader's own: functions that make one for a task.
        tau: the noise.
        repetitions: the number of runs of each player.
    """
    bits = [information(tau, length) for length in lengths]
    measured: dict[str, tuple[Sequence[float], Sequence[Reals]]] = {
        OBEY: (bits, [vote(tau, length, 1, repetitions=repetitions) for length in lengths]),
        VOTE: (bits, [vote(tau, length, length, repetitions=repetitions) for length in lengths]),
    }
    for label, returns in learned.items():
        measured[label] = ([information(tau, length) for length in returns], [*returns.values()])
    for label, make in own.items():
        parameters = [{"tau": tau, "max_msg_length": length} for length in lengths]
        measured[label] = (bits, [play(make, parameters=one, repetitions=repetitions) for one in parameters])
    title = f"{lengths[0]} to {lengths[-1]} words, τ = {tau:g}"
    shift = (6, -9) if own else (-4, 5)  # away from the other lines
    return Points(measured, title, marked=VOTE, marks=[f"{length}" for length in lengths], shift=shift)


def race(own: Mapping[str, Maker], lengths: Sequence[int] = (1, 4, 8, 28), *, repetitions: int = 5) -> Sheet:
    """Return the figure of the messages with players of the reader's own beside obeying and voting."""
    return Sheet("race", [[messages_panel(lengths, own=own, repetitions=repetitions)]])


def one_toy(tau: float = 0.05, length: int = 1, vocab_size: int = 4, *, repetitions: int = 10, **how: Any) -> Sheet:
    """Return the learning curve of Q-learning on one toy, beside obeying and voting; other arguments as in `learn`."""
    parameters = {"tau": tau, "max_msg_length": length, "vocab_size": vocab_size}
    results = learn(parameters=parameters, repetitions=repetitions, **how)
    bits = abs(information(tau, length, vocab_size))
    title = f"τ = {tau:g}, L = {length}, H = {vocab_size}: {bits:.2f} bit, {rows_of_table(length, vocab_size)} rows"
    levels = {
        OBEY: vote(tau, length, 1, vocab_size=vocab_size).mean(),
        VOTE: vote(tau, length, length, vocab_size=vocab_size).mean(),
        "random actions": RANDOM_PLAY,
    }
    return Sheet("one toy", [[beside(Curves(results, title, optimum=OPTIMUM), levels)]])


def vocabulary_sheet(results: Results) -> Sheet:
    """Return the learning curves with vocabularies of several sizes."""
    return Sheet("vocabulary", [[Curves(results, "words without noise", optimum=OPTIMUM)]])


def memory_sheet(by_label: Mapping[str, Results]) -> Sheet:
    """Return the learning curves with and without the last action, and every run with it."""
    results = conditions(by_label)
    first = next(iter(by_label))
    curves = by_label[first].curves("Q-learning")
    title = f"{curves.shape[1]} runs that see their last action"
    runs = Runs(np.array(curves.index, float), curves.to_numpy(float).T, title)
    return Sheet("memory", [[Curves(results, "a toy with one word", optimum=OPTIMUM), runs]])


def lengths_sheet(by_label: Mapping[str, Results], voted: float) -> Sheet:
    """Return the learning curves with messages of one and of four words at τ = 0.1, beside the vote over four."""
    curves = Curves(conditions(by_label), "messages at τ = 0.1", y_range=(-800.0, 2_000.0))
    return Sheet("lengths", [[beside(curves, {VOTE_FOUR: voted}, range(0, LONG + 1, LONG // 4))]])
