"""Saving and loading agents: without pickle, and with an error one understands where that is not possible."""

import io
import itertools
import json
import os
import zipfile
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from edugym import UCB, DoubleQLearning, QLearning, Softmax, load, save
from edugym.mdp.protocol import Integers, Random
from tests.agents.cases import same
from tests.messages import named


class Memory(NamedTuple):
    """A part of an agent of one's own."""

    last: Integers
    note: str | None


class OwnAgent(NamedTuple):
    """An agent of one's own."""

    Q: Any
    memory: Any
    learning_rate: float = 0.5
    explores: bool = True
    limit: int = 7

    def act(self, state: int, rng: Random) -> int:
        """Always the same."""
        return 0


def own_agent(Q: Any = ((np.nan, -np.inf, 5e-324), (np.inf, -0.0, 0.1 + 0.2))) -> OwnAgent:
    """One with all kinds of values in it."""
    return OwnAgent(np.asanyarray(Q), Memory(np.array([2**62, -1]), None), float("inf"), False)


@pytest.mark.parametrize(
    "agent",
    [
        own_agent(),
        own_agent([[True], [False]])._replace(memory=Memory(np.array([1, 2], np.int8), "ε")),
        *map(own_agent, (np.zeros((0, 2)), np.zeros(()), np.asfortranarray(np.ones((3, 2))), np.arange(6.0)[::-2])),
    ],
    ids=itertools.count(),
)
def test_every_bit_of_an_agent_of_ones_own_comes_back(agent: OwnAgent, tmp_path: Path) -> None:
    """NaN, infinities, huge integers, text, None and truth values; arrays of any type, shape and order."""
    save(agent, tmp_path / "own.npz")
    loaded = load(tmp_path / "own.npz", kinds=[OwnAgent, Memory])
    assert same(loaded, agent)
    assert loaded.Q.flags.writeable


def test_the_file_has_the_name_that_was_given_and_no_pickle(tmp_path: Path) -> None:
    """No ending is added, text will do, nothing else is left behind; a folder that is missing is made."""
    path = str(tmp_path / "new folder" / "my agent")
    save(QLearning.create((3, 2), learning_rate=np.float64(0.25), exploration=UCB.create((3, 2))), path)
    assert os.listdir(tmp_path / "new folder") == ["my agent"]
    assert type(load(path).learning_rate) is float
    with np.load(path, allow_pickle=False) as file:
        assert set(file.files) == {"structure", "agent.Q", "agent.exploration.counts", "agent.exploration.bounds"}
        assert all(file[name].dtype.kind in "ifU" for name in file.files)


def test_what_cannot_be_saved_is_refused_and_named(tmp_path: Path) -> None:
    """The message says where in the agent it is, and nothing is written: it could not be loaded again."""
    unsavable: list[Any] = [{"a": 1}, [1, 2], (1, 2), np.array([None]), np.array([1j]), np.array(["a"]), lambda: 0]
    good: Any = QLearning.create((3, 2))
    wrong: list[tuple[Any, str]] = [
        *((OwnAgent(np.zeros(1), Memory(np.zeros(1, np.int64), value)), r"agent\.memory\.note") for value in unsavable),
        (good._replace(Q=np.zeros((3, 2), np.int64)), "Q must be"),
        (good._replace(exploration="greedy"), "exploration must be"),
        *((nothing, "agent must be a NamedTuple") for nothing in (3, "agent.npz", QLearning, (1, 2))),
    ]
    for agent, message in wrong:
        with pytest.raises(ValueError, match=message):
            save(agent, tmp_path / "agent.npz")
    (tmp_path / "file").touch()
    for path in (tmp_path / "file" / "agent.npz", tmp_path):
        with pytest.raises(OSError, match="cannot write to "):
            save(good, path)
    assert os.listdir(tmp_path) == ["file"]


def test_an_unknown_class_is_named(tmp_path: Path) -> None:
    """And how to load it nevertheless; a file cannot name any class that it likes."""
    save(own_agent(), tmp_path / "own.npz")
    for kinds, missing in (((), "OwnAgent"), ((OwnAgent,), "Memory"), (OwnAgent, "Memory")):
        with pytest.raises(ValueError, match=f"kinds must hold the class {missing}"):
            load(tmp_path / "own.npz", kinds)
    for kind in ("Path", "print", "object", "Generator", "ndarray"):
        structure = json.dumps({"kind": kind, "fields": {}})
        (tmp_path / "agent.npz").write_bytes(npz(structure=np.array(structure)))
        with pytest.raises(ValueError, match=f"kinds must hold the class {kind}"):
            load(tmp_path / "agent.npz")


class Trap:
    """What a stranger may put into a file: something that does harm when it is unpickled."""

    def __reduce__(self) -> Any:
        """Called by whoever unpickles it."""
        return pytest.fail, ("unpickled",)


def npz(**arrays: Any) -> bytes:
    """A file of arrays."""
    buffer = io.BytesIO()
    np.savez(buffer, **arrays)
    return buffer.getvalue()


def npy(array: np.ndarray[Any, Any]) -> bytes:
    """A file of one array."""
    buffer = io.BytesIO()
    np.save(buffer, array)
    return buffer.getvalue()


def header(shape: str, dtype: str = "<f8") -> bytes:
    """The beginning of a file of an array."""
    words = f"{{'descr': '{dtype}', 'fortran_order': False, 'shape': {shape}, }}".encode().ljust(117) + b"\n"
    return b"\x93NUMPY\x01\x00" + len(words).to_bytes(2, "little") + words


def stored(compression: int = zipfile.ZIP_DEFLATED, raw: bytes = b"", **fields: Any) -> bytes:
    """The file of a Q-learner of which some fields are not as they should be, `raw` in the place of its table."""
    exploration = {"kind": "Greedy", "fields": {}}
    right = {"Q": {"array": "agent.Q"}, "learning_rate": {"value": 0.5}, "exploration": exploration}
    structure = json.dumps({"kind": "QLearning", "fields": right | fields})
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", compression) as archive:
        archive.writestr("structure.npy", npy(np.array(structure)))
        archive.writestr("agent.Q.npy", raw or npy(np.zeros((3, 2))))
        archive.writestr("agent.whole.npy", npy(np.zeros((3, 2), np.int64)))
    return buffer.getvalue()


BROKEN: list[tuple[bytes, str]] = [
    (b"", "it is not in the .npz format"),
    (npy(np.zeros(3)), "it is not in the .npz format"),
    (npz(a=np.zeros(3)), "it holds no agent"),
    (npz(structure=np.array([Trap()], object)), ".+"),  # objects are refused before they are made
    (npz(a=np.zeros(3, complex)), r"a.npy is not an array that save\(\) wrote"),
    (npz(structure=np.array("[" * 100_000)), ".+"),
    (npz(structure=np.array('{"array": "agent.Q"}')), "its structure is damaged"),
    (npz(structure=np.array('{"value": 3}')), "it holds no agent"),
    (npz(structure=np.array('{"value": [1]}')), "its structure is damaged"),
    (npz(structure=np.array('{"kind": "QLearning", "fields": {}}')), "QLearning has other fields than the file: Q"),
    (stored(zeal={"value": 1}, aim={"value": 1}), "QLearning has other fields than the file: aim, zeal"),
    (stored(learning_rate={"value": True}), named("learning_rate", 0, 1, True)),
    (stored(Q={"array": "agent.whole"}), "Q must be an array of float64 with 2 axes.*"),
    (stored(Q={"array": "agent.raw"}), ".*damaged.*"),
    (stored(exploration={"kind": "EpsilonGreedy", "fields": {"epsilon": {"value": 7}}}), named("epsilon", 0, 1, 7)),
    # arrays are as large as they say: no memory is asked for
    *((stored(raw=header(shape) + bytes(48)), ".+") for shape in ("(2, 2)", "(4, 2)", "(10**12,)", "(-3, -2)", "(5,)")),
    # others unpack without a limit
    (stored(zipfile.ZIP_BZIP2), ".* is compressed in a way that save.*"),
]


@pytest.mark.parametrize(("content", "reason"), BROKEN, ids=itertools.count())
def test_what_is_no_saved_agent_is_refused(content: bytes, reason: str, tmp_path: Path) -> None:
    """Text, damaged archives, other arrays, wrong values: one error names the file and says what is wrong with it."""
    (tmp_path / "agent").write_bytes(content)
    with pytest.raises(ValueError, match=rf"path must name a file .*agent' cannot be loaded: {reason}$") as caught:
        load(tmp_path / "agent")
    assert caught.value.__suppress_context__
    assert caught.value.__cause__ is None


def test_a_field_that_is_missing_has_its_default(tmp_path: Path) -> None:
    """As in a file of an earlier version."""
    for content in (stored(), stored(zipfile.ZIP_STORED), stored(raw=header("(3, 2)") + bytes(48))):
        (tmp_path / "agent").write_bytes(content)
        loaded = load(tmp_path / "agent")
        assert (loaded.Q.shape, loaded.discount) == ((3, 2), QLearning.create((3, 2)).discount)


@given(data=st.data())
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=80)
def test_a_damaged_file_is_refused_or_harmless(data: st.DataObject, tmp_path: Path) -> None:
    """Cut anywhere, or with any byte changed: loaded with the right tables, or refused."""
    agent = QLearning.create((3, 2), exploration=Softmax(0.5), initial_value=1.5)
    path = tmp_path / "agent.npz"
    save(agent, path)
    content = bytearray(path.read_bytes())
    if data.draw(st.booleans()):
        del content[data.draw(st.integers(0, len(content) - 1)) :]
    else:
        content[data.draw(st.integers(0, len(content) - 1))] ^= data.draw(st.integers(1, 255))
    path.write_bytes(content)
    loaded, refusal = agent, "cannot be loaded"
    try:
        loaded = load(path)
    except ValueError as error:
        refusal = str(error)
    assert same(loaded, agent)
    assert "cannot be loaded" in refusal


def test_small_files_that_unpack_to_large_ones_are_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """By the sizes that they declare together, to the byte, before anything is unpacked; one may allow more."""
    small, plain = tmp_path / "agent.npz", tmp_path / "plain"
    save(DoubleQLearning.create((1000, 100)), small)
    with zipfile.ZipFile(small) as archive:
        whole = sum(entry.file_size for entry in archive.infolist())
    with np.load(small) as arrays:
        plain.write_bytes(npz(**arrays))  # not compressed, it needs more bytes on the disk than in memory
    sizes = {small: whole, plain: plain.stat().st_size}
    assert small.stat().st_size < 20_000 < whole < sizes[plain]
    for path, size in sizes.items():
        assert load(path, max_bytes=size).Q.shape == (1000, 100)
    monkeypatch.setattr(zipfile.ZipFile, "open", None)
    for path, size in sizes.items():
        with pytest.raises(ValueError, match=f"it holds more than {size - 1} bytes; to allow that, pass a larger"):
            load(path, max_bytes=size - 1)
