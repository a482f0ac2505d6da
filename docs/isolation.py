"""Write the page of the isolation matrix, `docs/isolation.md`: which remedy helps in which environment.

The figures are measured, so they are kept in `docs/isolation.json`, and page and picture are made from that file.

    python docs/isolation.py              write the page and the picture
    python docs/isolation.py --measure    measure what is not among the stored profiles, then write them (some minutes)
    python docs/isolation.py --check      write nothing; fail if the page is out of date
"""

import argparse
import json
import shutil
import sys
from pathlib import Path
from textwrap import fill
from typing import Any, NamedTuple

import numpy as np
from other_measures import CAPACITY, DIGITS, by_other_measures, other_measures, table

import edugym
from edugym import DiscreteActions, Discretised, FrameStack, Hashed, Interval, QLearning, mean_interval
from edugym.experiments.figures.style import dress, to_bytes
from edugym.experiments.fingerprints import versions
from edugym.experiments.profiles.ladders import LADDERS
from edugym.experiments.profiles.words import rounded
from edugym.mdp.protocol import Reals
from edugym.rendering.palette import INK
from edugym.system.files import write_whole
from edugym_course import agent_profiles
from edugym_course.agent_profiles import REPETITIONS, WRIST
from edugym_course.remedies import NO_CHANGE, REMEDIES, gain, shown

PAGE, DATA = Path(__file__).parent / "isolation.md", Path(__file__).parent / "isolation.json"
UNFINISHED = DATA.with_suffix(".unfinished")
OWN = 0.2
"""An environment's own remedy must gain more than this, with the whole interval."""


def binned(mdp: Any) -> Any:
    """The arm for a table: bins over the wrist, and three turns of each joint."""
    return DiscreteActions.create(Discretised.create(mdp, list(WRIST)), 3)


def remembered(mdp: Any) -> Any:
    """The last four observations, for a table of what occurs."""
    return Hashed.create(FrameStack.create(mdp, 4), CAPACITY)


FRAMED = ("Boulder", "Roadrunner", "Study", "MemoryCorridor", "Tamagotchi", "Golf", "Supermarket")
"""Where a window of 4 frames still has few enough rows for a table."""
MEASURED: dict[str, dict[str, Any]] = {
    "QLearning": {"Catch": (QLearning.create, table), "Trashbot": (QLearning.create, binned)},
    "Frames": dict.fromkeys(FRAMED, (QLearning.create, remembered)),
}
"""Agents with wrappers, as `edugym.profile` takes them, for each challenge in which they are measured here."""


def measure() -> dict[str, Any]:
    """The gains of all remedies: their scores less those without them, for each rung and repetition."""
    stored = agent_profiles.load()
    assert stored is not None
    measured: dict[tuple[str, str], Reals] = {}
    for label, challenges in MEASURED.items():
        for name, agent in challenges.items():
            how: dict[str, Any] = {"repetitions": REPETITIONS, "checkpoints": UNFINISHED}
            measured[label, name] = edugym.profile({label: agent}, challenges=[name], **how).scores(label, name)
            print(label, name, flush=True)
    gains: dict[str, dict[str, Any]] = {remedy.name: {} for remedy in REMEDIES}
    base: dict[str, float] = {}
    for name in stored.challenges:
        scores = {agent: stored.scores(agent, name) for agent in stored.agents}
        scores |= {label: found for (label, challenge), found in measured.items() if challenge == name}
        base[name] = round(float(scores["QLearning"].mean()), DIGITS)
        for remedy in REMEDIES:
            difference = scores[remedy.agent] - scores[remedy.base] if remedy.agent in scores else np.array([np.nan])
            if not np.isnan(difference).any():
                gains[remedy.name][name] = difference.round(DIGITS).tolist()
    shutil.rmtree(UNFINISHED)
    return {"versions": versions(), "base": base, "gains": gains, "others": other_measures()}


def change(rungs: Any) -> Interval:
    """How much more a remedy gains on the harder half of the ladder than on the easier half."""
    gains = np.array(rungs)
    half = len(gains) // 2
    return mean_interval(gains[-half:].mean(axis=0) - gains[:half].mean(axis=0))


INTRODUCTION = f"""Each environment of the course is to isolate one challenge. If it does, the remedy for that challenge
helps there, and the remedies for other challenges do not. This page measures it. The numbers are **gains**: the score
of an agent with the remedy, on the ladder of tasks that `edugym profile` climbs, less that of Q-learning with a table,
paired over {REPETITIONS} repetitions, with a 95 % interval. A score is 0 for random play and 1 for the best play.
Nothing is tuned. SARSA, Q(λ), risk-averse Q-learning, Dyna-Q and the frames change one thing in Q-learning; Go-Explore,
DQN and the actor-critic are agents of their own. Hindsight changes one thing in DQN, so its gain is over DQN. On Catch,
and with frames, the table has a row for each observation that occurs (`Hashed`), on Trashbot it has bins
(`Discretised`, `DiscreteActions`). Where a cell is empty, the agent cannot enter the environment. Bandit, Diver and
Casino [have no ladder](agents.md#how-it-was-measured), so they are not here."""
READING = f"""**Bold** is the environment for which the remedy is meant. There its gain should be above {OWN} with the
whole interval; elsewhere it should be near 0."""


def names(data: dict[str, Any]) -> list[str]:
    """The environments that were measured, in the order of the course."""
    return [ladder.name for ladder in LADDERS if ladder.name in data["base"]]


def matrix(data: dict[str, Any]) -> list[str]:
    """The lines of the table of gains."""
    columns = names(data)
    lines = ["| remedy | " + " | ".join(columns) + " |", "|---" * (len(columns) + 1) + "|"]
    for remedy in REMEDIES:
        cells = []
        for name in columns:
            rungs = data["gains"].get(remedy.name, {}).get(name)
            text = shown(gain(rungs)) if rungs else ""
            cells.append(f"**{text}**" if text and name == remedy.own else text)
        lines.append(f"| {remedy.name} | " + " | ".join(cells) + " |")
    base = [rounded(data["base"][name]) for name in columns]
    return [*lines, "| *Q-learning itself: its score* | " + " | ".join(base) + " |"]


class Findings(NamedTuple):
    """What the measurement says, in sentences.

    Attributes:
        own: whether each environment's own remedy helps there.
        others: where the remedy for another challenge matters.
        strengths: where the strength of a challenge changes what the remedy for another one gains.
        follows: what follows for the course.
    """

    own: list[str]
    others: list[str]
    strengths: list[str]
    follows: list[str]


def findings(data: dict[str, Any]) -> Findings:
    """What the measurement says."""
    found = Findings([], [], [], [])
    passed: list[str] = []
    failed: list[str] = []
    shared: list[str] = []
    for remedy in REMEDIES:
        for name in names(data):
            rungs = data["gains"].get(remedy.name, {}).get(name)
            if not rungs:
                continue
            size, more = gain(rungs), change(rungs)
            if name == remedy.own:
                (passed if size.low > OWN else failed).append(name)
                verdict = "above" if size.low > OWN else "**not above**"
                found.own.append(f"{name}: {remedy.name} gains {shown(size)}, with the whole interval {verdict} {OWN}.")
                continue
            if size.low > NO_CHANGE or size.high < -NO_CHANGE:
                found.others.append(f"{name}: {remedy.name} changes the score by {shown(size)}.")
            if size.low > NO_CHANGE:
                shared.append(f"{name} ({remedy.name})")
            if more.low > NO_CHANGE or more.high < -NO_CHANGE:
                text = "from the easier half of the ladder to the harder one its gain changes by"
                found.strengths.append(f"{name}: {remedy.name}, {text} {shown(more)}.")
    without = [name for name in names(data) if name not in {remedy.own for remedy in REMEDIES}]
    found.own.extend(f"{name}: none of these remedies is meant for it." for name in without)
    if passed:
        found.follows.append(f"A low score in {', '.join(passed)} is raised by the remedy of the lesson.")
    if failed:
        found.follows.append(
            f"In {', '.join(failed)} the remedy of the lesson does not raise the score, on these ladders and at these"
            " settings: a profile does not see what the lesson shows there. In Roadrunner and Catch another strength"
            " would: the price of a fall, measured while learning, and images of which none comes twice."
        )
    if shared:
        found.follows.append(
            f"Other remedies raise the score too: {', '.join(shared)}. A low score there does not tell what is missing."
        )
    return found


def page(data: dict[str, Any]) -> str:
    """Return the page."""
    found = findings(data)
    own = sum(remedy.own in data["gains"].get(remedy.name, {}) for remedy in REMEDIES)
    others = f"{sum(map(len, data['gains'].values())) - own} other cells"
    limit = f"{NO_CHANGE}, with the whole interval:"
    return "\n".join(
        [
            "# Do the environments isolate their challenges?",
            "",
            fill(INTRODUCTION, 120, break_on_hyphens=False),
            "",
            "![The gain of every remedy in every environment](isolation.svg)",
            "",
            *matrix(data),
            "",
            fill(READING, 120),
            "",
            "## Does an environment's own remedy help there?",
            "",
            *items(found.own),
            "",
            "## Is the measure the one that the challenge is about?",
            "",
            *by_other_measures(data["others"]),
            "## Where does the remedy for another challenge matter?",
            "",
            f"In {len(found.others)} of {others} the gain differs from 0 by more than {limit}",
            "",
            *items(found.others),
            "",
            "## Does the strength of a challenge change what other remedies gain?",
            "",
            f"In {len(found.strengths)} of {others} it does, by more than {limit}",
            "",
            *items(found.strengths),
            "",
            "## What follows for the course",
            "",
            *items(found.follows),
            "",
            f"Measured with {data['versions']}, by `python docs/isolation.py --measure`. The numbers stay those"
            " of that version of edugym until they are measured again.",
            "",
        ]
    )


def items(sentences: list[str]) -> list[str]:
    """Sentences as a list."""
    return [f"- {sentence}" for sentence in sentences] or ["- none"]


def picture(data: dict[str, Any]) -> bytes:
    """The matrix as an SVG: purple where a remedy gains, orange where it loses; its own environment has a frame."""
    from matplotlib.figure import Figure
    from matplotlib.patches import Rectangle

    columns = names(data)
    figure = Figure(figsize=(10, 4.6), layout="constrained")
    ax = figure.subplots()
    cells = [[data["gains"].get(remedy.name, {}).get(name) for name in columns] for remedy in REMEDIES]
    gains = np.array([[gain(rungs).estimate if rungs else np.nan for rungs in row] for row in cells])
    ax.imshow(gains, cmap="PuOr", vmin=-1, vmax=1, aspect="auto")
    for (i, j), value in np.ndenumerate(gains):
        if not np.isnan(value):
            ax.text(j, i, rounded(value), ha="center", va="center", fontsize=8)
        if columns[j] == REMEDIES[i].own:
            ax.add_patch(Rectangle((j - 0.48, i - 0.46), 0.96, 0.92, fill=False, edgecolor=INK, linewidth=1.8))
    dress(ax, "", "", "gain in score over Q-learning with a table (of hindsight: over DQN)")
    ax.set_xticks(range(len(columns)), columns)
    ax.set_yticks(range(len(REMEDIES)), [remedy.name for remedy in REMEDIES])
    return to_bytes(figure, "svg")


def main() -> int:
    """Run the command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--measure", action="store_true", help="measure everything again")
    parser.add_argument("--check", action="store_true", help="write nothing, and fail if the page is out of date")
    options = parser.parse_args()
    if options.measure:
        write_whole(DATA, (json.dumps(measure()) + "\n").encode())
    data = json.loads(DATA.read_text(encoding="utf-8"))
    if options.check:
        current = PAGE.read_text(encoding="utf-8") == page(data)
        if not current:
            print(f"{PAGE} is out of date: run python docs/isolation.py", file=sys.stderr)
        return 0 if current else 1
    PAGE.write_text(page(data), encoding="utf-8")
    write_whole(PAGE.with_suffix(".svg"), picture(data))
    return 0


if __name__ == "__main__":
    sys.exit(main())
