"""What the docstring of an environment says of it is complete and true: pages and lessons are made from it."""

import inspect
import math
import re
from typing import Any

from edugym.adapters.registration import Entry
from tests.contract.parameters import Keywords
from tests.contract.play import Player, every_corner, every_environment

HEADINGS = [
    "Description", "Observation space", "Action space", "State", "Dynamics", "Reward", "Initial state", "Episode end",
    "Parameters", "Info", "Choices", "Algorithms", "References",
]  # fmt: skip


def sections(entry: Entry) -> dict[str, str]:
    """The sections of the class docstring, in their order."""
    text = inspect.getdoc(entry.load_mdp()) or ""
    _, *parts = re.split(r"^## (.+)\n", text, flags=re.MULTILINE)
    return dict(zip(parts[::2], map(str.strip, parts[1::2]), strict=True))


@every_environment
def test_headings(entry: Entry) -> None:
    """All headings are there, in the one order, and something stands under each."""
    assert list(sections(entry)) == HEADINGS
    assert all(sections(entry).values())
    assert (entry.load_mdp().__doc__ or "").splitlines()[0].endswith(".")


@every_environment
def test_parameters(entry: Entry) -> None:
    """The section names exactly the constructor's parameters, in their order, with the true default values."""
    constructor = inspect.signature(entry.load()).parameters
    assert list(constructor)[-1] == "render_mode"
    defaults = {name: parameter.default for name, parameter in constructor.items() if name != "render_mode"}
    described = re.findall(r"^- `(\w+)` \((.+?)\): \S", sections(entry)["Parameters"], re.MULTILINE)
    assert [name for name, _ in described] == list(defaults)
    env = entry.load()()
    for name, says in described:
        value = eval(says.strip("`"), {"inf": math.inf, "pi": math.pi}, defaults)
        if defaults[name] is None and value is not None:  # worked out from the other parameters
            assert getattr(env.mdp, name) == value
        else:
            assert (value, type(value) is bool) == (defaults[name], type(defaults[name]) is bool)


@every_corner
def test_info(entry: Entry, keywords: Keywords) -> None:
    """`info` has exactly the keys that the section lists, after every reset and every step."""
    listed = re.findall(r"^- `(\w+)`: \S", sections(entry)["Info"], re.MULTILINE)
    assert len(set(listed)) == len(listed)
    player = Player(entry.load()(**keywords), entry.name)
    assert sorted(player.info) == sorted(listed)
    infos: list[dict[str, Any]] = [seen[-1] for seen in player.play(60)]
    assert len(infos) >= 60
    assert all(sorted(info) == sorted(listed) for info in infos)


@every_environment
def test_spaces(entry: Entry) -> None:
    """The sections on spaces name the kind of space that there is at the defaults."""
    env = entry.load()()
    for heading, space in (("Observation space", env.observation_space), ("Action space", env.action_space)):
        assert f"`{type(space).__name__}(" in sections(entry)[heading]


@every_environment
def test_end(entry: Entry) -> None:
    """An episode that terminates at its step limit is not truncated, and the section on its end says so."""
    end = sections(entry)["Episode end"]
    assert "Terminated" not in end or re.search(
        r"; else truncated\s+after|never\s+truncated|no episode\s+is truncated", end
    )
