"""The challenge for a class: its rules are checked, and who keeps to them is ranked."""

import re
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest

import edugym
from edugym import Profile
from edugym.experiments.profiles.ladders import LADDERS
from edugym.mdp.protocol import Reals
from edugym_course import agent_profiles, arguments, one_table, one_table_rules
from tests.course.test_commands import run

PAGE = Path(__file__).parents[2] / "docs" / "class-challenge.md"
[SAMPLE] = re.findall(r"```python\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)
SHORT = tuple(
    ladder._replace(strengths=ladder.strengths[:2], n_steps=300, evaluation_episodes=2)
    for ladder in LADDERS
    if ladder.name in ("Boulder", "Golf")
)


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A working directory for files of students."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


def entered(code: str, folder: Path, *options: str) -> Any:
    """What the command says of a submission."""
    (folder / "my_agent.py").write_text(code, encoding="utf-8")
    return run("profile", "my_agent.py:MyAgent", "--one-table", "--repetitions", "2", "--output", "entry", *options)


def test_what_a_table_can_enter() -> None:
    """The challenges in which the package's Q-learning has a stored profile."""
    stored = agent_profiles.load()
    assert stored is not None
    names = [ladder.name for ladder in one_table.ladders()]
    assert names == [name for name in stored.challenges if name not in stored.blank["QLearning"]]


def test_a_submission_is_ranked(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The sample of the page, among the agents of the package in the same challenges."""
    monkeypatch.setattr(one_table, "ladders", lambda: SHORT)
    done = entered(SAMPLE, folder)
    assert done.exit_code == 0, done.output
    said = re.search(r"MyAgent has (-?[\d.]+) points, place (\d+) of (\d+); to beat: (\w+)", done.output)
    assert said is not None
    assert re.search(rf"{said[2]} +MyAgent \(submitted\) +{re.escape(said[1])} \[", done.output)
    assert re.search(r"– +DynaQ", done.output)
    assert (folder / "entry" / "report.html").exists()


START, KEEP = "np.full((n_states, n_actions), 1.0)", "    @classmethod"
WRONG = [
    ("    epsilon: float = 0.1", "    epsilon: float = 0.1\n    seen: list = []", "seen.append", ("one table", "seen")),
    (START, "np.zeros((5 * n_states, n_actions))", "", ("one table", "Q 90", "Boulder")),
    (START, f"{START}, learning_rate=0.1 if n_actions == 2 else 0.5", "", ("nothing tuned", "learning_rate", "0.5")),
    (START, "np.full((n_states, n_actions), 7.0 + n_actions)", "", ("nothing tuned", "first value of Q")),
    ("        return cls(", "        environment.reset()\n        return cls(", "", ("only", "'reset'")),
    ("    epsilon: float = 0.1", "    epsilon: float = 0.1\n    tabular: bool = False", "", ("one table", "tabular")),
]


@pytest.mark.parametrize(("part", "other", "remember", "names"), WRONG, ids=lambda part: str(part)[:12])
def test_a_submission_that_breaks_a_rule_is_refused(
    part: str, other: str, remember: str, names: tuple[str, ...], folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Before anything is scored; the sentence names the rule, and what breaks it."""
    monkeypatch.setattr(one_table, "ladders", lambda: SHORT)
    assert part in SAMPLE
    code = SAMPLE.replace(part, other)
    if remember:
        code = code.replace("        target = reward\n", f"        self.{remember}(state)\n        target = reward\n")
    done = entered(code, folder)
    assert done.exit_code == 2
    for name in names:
        assert name in re.sub(r"[│\s]+", " ", done.output)
    assert not (folder / "entry" / "report.html").exists()


TARGET = "        target = reward\n"
HIDDEN = [
    ("global", "\n\nseen = [0]\n\n\nclass MyAgent", "seen[0] = state", ("one table", "something else changed")),
    ("class", "\n\nclass Seen:\n    all = {}\n\n\nclass MyAgent", "Seen.all[0] = state", ("something else changed",)),
    ("large", "\n\nplan = [*range(9999)]\n\n\nclass MyAgent", "", ("one table", "plan 9,999")),
    ("keys", "\n\nclass MyAgent", "self.seen[reward + self.Q.sum(), state, 0.5] = 0", ("one table", "seen")),
    ("digits", "\n\nclass MyAgent", "self.seen[0] = (self.seen.get(0, 1) << 64) + state", ("one table", "seen")),
    (
        "size",
        "\n\nclass MyAgent",
        "reward = 5.0 if len(self.Q) == 9 else reward",
        ("nothing tuned", "Boulder", "height"),
    ),
    ("hard", "\n\nclass MyAgent", "reward = 5.0 if len(self.Q) > 9 else reward", ("tuned", "Boulder", "height")),
    ("state", "\n\nclass MyAgent", "reward += state", ("nothing tuned", "Q", "numbered")),
]


@pytest.mark.parametrize(("start", "line", "names"), [row[1:] for row in HIDDEN], ids=[row[0] for row in HIDDEN])
def test_what_is_hidden_is_found(
    start: str, line: str, names: tuple[str, ...], folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """In global variables, class attributes, keys and digits; and an agent that knows a task by its size or states."""
    monkeypatch.setattr(one_table, "ladders", lambda: SHORT)
    code = SAMPLE.replace("\n\nclass MyAgent", start)
    if "self.seen" in line:
        code = code.replace("    epsilon: float = 0.1", "    epsilon: float = 0.1\n    seen: dict = None")
        code = code.replace("1.0))", "1.0), seen={})")
    done = entered(code.replace(TARGET, f"        {line or 'pass'}\n{TARGET}"), folder)
    assert done.exit_code == 2, done.output
    for name in names:
        assert name in re.sub(r"[│\s]+", " ", done.output)


ALLOWED = [
    ("import", "\n\nLIMIT = 3\nNAMES = ('a', 'b')\n\n\nclass MyAgent", "int(LIMIT)"),
    ("window", "\n\nclass MyAgent", "self.window.append(state) if len(self.window) < 9 else self.window.pop(0)"),
]


@pytest.mark.parametrize(("start", "line"), [row[1:] for row in ALLOWED], ids=[row[0] for row in ALLOWED])
def test_what_is_within_the_rules_passes(start: str, line: str, folder: Path) -> None:
    """Constants, and a window of the last steps; a table that is a dictionary."""
    code = SAMPLE.replace("\n\nclass MyAgent", start).replace(TARGET, f"        {line}\n{TARGET}")
    if "window" in line:
        code = code.replace("    epsilon: float = 0.1", "    epsilon: float = 0.1\n    window: list = None")
        code = code.replace("1.0))", "1.0), window=[])")
    (folder / "my_agent.py").write_text(code, encoding="utf-8")
    agents = one_table.by_the_rules(arguments.agents(["my_agent.py:MyAgent"]))
    one_table_rules.check_rules(agents, SHORT)


@pytest.mark.parametrize(
    ("line", "says"),
    [
        (("QLearning + FrameStack(2)",), "wrapper"),
        (("QLearning", "--tuned", "learning_rate=0.5"), "--tuned"),
        (("QLearning", "--challenge", "Golf"), "--challenge"),
        (("--all",), "--one-table"),
    ],
)
def test_what_the_rules_leave_no_choice_of(line: tuple[str, ...], says: str, folder: Path) -> None:
    """Wrappers, settings and challenges."""
    done = run("profile", *line, "--one-table", "--output", "entry")
    assert done.exit_code == 2
    assert says in done.output


class Nested(NamedTuple):
    """An agent that keeps things in several ways."""

    Q: Reals
    window: list[tuple[int, float]]
    learning_rate: float = 0.1


class Slotted:
    """An object with a place of its own, and one in its dictionary."""

    __slots__ = ("__dict__", "place")

    def __init__(self) -> None:
        """Fill both."""
        self.place, self.values = 1, {(0, 1): 2.0, "a": np.zeros(3)}


@pytest.mark.parametrize(
    ("kept", "numbers"),
    [
        (3.0, 1),
        (np.zeros((2, 3)), 6),
        (Nested(np.zeros((2, 3)), [(1, 2.0), (3, 4.0)]), 6 + 4 + 1),
        (Slotted(), 1 + 1 + 3),
        ({1, 2}, 2),
        (2**640, 11),
        ("a" * 80, 10),
        ({(2, 3): 1.0, (0.5, 0.5): 1.0}, 1 + 2 + 1),
        ({2: 1.0, 8: 1.0}, 1 + 1 + 1),
        ({(9, 9): 1.0}, 2 + 1),
        ({"a" * 64: 1.0, "a" * 80: 1.0}, 1 + 10 + 1),
        (len, 0),
        (Slotted, 0),
    ],
)
def test_what_an_agent_keeps_is_counted(kept: Any, numbers: int) -> None:
    """In arrays, tuples, lists, objects, and dictionaries, whose keys are free where they are places in a table.

    Functions and classes are none of it.
    """
    assert one_table_rules.numbers_in(kept, (8, 4)) == numbers


@pytest.mark.parametrize("name", sorted(agent_profiles.agents()))
def test_the_package_is_judged_as_submissions_are(name: str) -> None:
    """Who has a place in the ranking passes the check, and no other."""
    ladders = tuple(ladder for ladder in SHORT if ladder.name == "Golf")
    make = getattr(edugym, name).create
    if one_table.has_one_table(name):
        one_table_rules.check_rules(one_table.by_the_rules({name: make}), ladders)
    else:
        with pytest.raises((ValueError, AttributeError)):
            one_table_rules.check_rules(one_table.by_the_rules({name: make}), ladders)


def test_points_are_the_mean_of_the_scores() -> None:
    """Over rungs and challenges; an agent that is missing in one of them has none."""
    import pandas

    rows = [
        {"agent": agent, "challenge": ladder.name, "strength": strength, "repetition": k, "score": score + 0.1 * k}
        for agent, ladder, score in (("a", SHORT[0], 0.2), ("a", SHORT[1], 0.6), ("b", SHORT[0], 1.0))
        for strength in ladder.strengths
        for k in range(2)
    ]
    profile, names = Profile(pandas.DataFrame(rows), SHORT, ("a", "b")), [ladder.name for ladder in SHORT]
    assert one_table.points(profile, "a", names).estimate == pytest.approx(45)
    assert one_table.points(profile, "b", names).n == 0
