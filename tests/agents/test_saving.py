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

from edugym import UCB, QLearning, Softmax, load, save
from edugym.mdp.protocol import Integers, Random
from tests.agents.cases import same


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


def own_agent() -> OwnAgent:
    """One with all kinds of values in it."""
    Q = np.array([[np.nan, -np.inf, 5e-324], [np.inf, -0.0, 0.1 + 0.2]])
    return OwnAgent(Q, Memory(np.array([2**62, -1]), None), float("inf"), False)


def test_no_pickle_is_in_the_file(tmp_path: Path) -> None:
    """NumPy reads all of it without being allowed to unpickle, and no array holds objects."""
    save(QLearning.create((3, 2), exploration=UCB.create((3, 2))), tmp_path / "agent.npz")
    with np.load(tmp_path / "agent.npz", allow_pickle=False) as file:
        assert set(file.files) == {"structure", "agent.Q", "agent.exploration.counts"}
        assert all(file[name].dtype.kind in "ifU" for name in file.files)


def test_every_bit_of_an_agent_of_ones_own_comes_back(tmp_path: Path) -> None:
    """NaN, infinities, denormals, huge integers, text, None and truth values, and the arrays' types."""
    agent = own_agent()
    small = agent._replace(Q=np.array([[True], [False]]), memory=Memory(np.array([1, 2], np.int8), "ε"))
    for one in (agent, small):
        save(one, tmp_path / "own.npz")
        assert same(load(tmp_path / "own.npz", kinds=[OwnAgent, Memory]), one)


def test_numpy_numbers_come_back_as_pythons(tmp_path: Path) -> None:
    """A setting that was taken from an array is a number like any other."""
    save(QLearning.create((2, 2), learning_rate=np.float64(0.25)), tmp_path / "agent.npz")
    assert type(load(tmp_path / "agent.npz").learning_rate) is float


def test_the_file_has_the_name_that_was_given(tmp_path: Path) -> None:
    """No ending is added, text will do, and nothing else is left behind."""
    save(QLearning.create((2, 2)), str(tmp_path / "my agent"))
    assert os.listdir(tmp_path) == ["my agent"]
    assert load(str(tmp_path / "my agent")).Q.shape == (2, 2)


def test_what_cannot_be_saved_is_refused_and_named(tmp_path: Path) -> None:
    """The message says where in the agent it is, and nothing is written."""
    unsavable: list[Any] = [{"a": 1}, [1, 2], (1, 2), np.array([None]), np.array([1j]), np.array(["a"]), lambda: 0]
    for value in unsavable:
        agent = OwnAgent(np.zeros(1), Memory(np.zeros(1, np.int64), value))
        with pytest.raises(ValueError, match=r"must hold numbers, arrays and NamedTuples, but agent\.memory\.note is"):
            save(agent, tmp_path / "agent.npz")
    assert not os.listdir(tmp_path)


def test_an_unknown_class_is_named(tmp_path: Path) -> None:
    """And how to load it nevertheless."""
    save(own_agent(), tmp_path / "own.npz")
    for kinds, missing in (((), "OwnAgent"), ((OwnAgent,), "Memory")):
        with pytest.raises(ValueError, match=f"kinds must hold the class {missing}"):
            load(tmp_path / "own.npz", kinds)


def test_a_missing_file_is_an_ordinary_error(tmp_path: Path) -> None:
    """As everywhere in Python."""
    with pytest.raises(FileNotFoundError, match=r"nowhere\.npz"):
        load(tmp_path / "nowhere.npz")


class Trap:
    """What a stranger may put into a file: something that writes a file when it is unpickled."""

    def __init__(self, path: Path) -> None:
        """Where to."""
        self.path = path

    def __reduce__(self) -> Any:
        """Called by whoever unpickles it."""
        return Path.touch, (self.path,)


def test_a_strangers_file_runs_no_code(tmp_path: Path) -> None:
    """Objects are refused before they are made."""
    np.savez(tmp_path / "agent.npz", structure=np.array([Trap(tmp_path / "trapped")], object))
    with pytest.raises(ValueError, match="cannot be loaded"):
        load(tmp_path / "agent.npz")
    assert not (tmp_path / "trapped").exists()


def npz(**arrays: Any) -> bytes:
    """A file of arrays."""
    buffer = io.BytesIO()
    np.savez(buffer, **arrays)
    return buffer.getvalue()


def zipped(name: str, content: bytes) -> bytes:
    """A file with one file in it."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as archive:
        archive.writestr(name, content)
    return buffer.getvalue()


def npy(array: np.ndarray[Any, Any], allow_pickle: bool = False) -> bytes:
    """A file of one array."""
    buffer = io.BytesIO()
    np.save(buffer, array, allow_pickle=allow_pickle)
    return buffer.getvalue()


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"Dear agent,",
        b"PK\x03\x04 and then something else",
        npy(np.zeros(3)),
        npz(a=np.zeros(3)),
        npz(structure=np.array("no JSON")),
        npz(structure=np.array("[]")),
        npz(structure=np.array('{"array": "agent.Q"}')),
        npz(structure=np.array('{"kind": "QLearning", "fields": {"Q": {"value": 1}, "colour": {"value": "red"}}}')),
        npz(structure=np.array("[" * 100_000)),
        zipped("structure.npy", b"\x93NUMPY"),
        zipped("structure.npy", npy(np.array([{}]), allow_pickle=True)),
    ],
    ids=itertools.count(),  # the bytes themselves have the time of day in them
)
def test_what_is_no_saved_agent_is_refused(content: bytes, tmp_path: Path) -> None:
    """Text, damaged archives, other arrays, pickled objects: the message names the file."""
    path = tmp_path / "agent.npz"
    path.write_bytes(content)
    with pytest.raises(
        ValueError, match=r"path must name a file that save\(\) wrote, but .*agent\.npz' cannot be loaded"
    ):
        load(path)


@given(data=st.data())
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=150)
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


def test_a_file_cannot_name_any_class_it_likes(tmp_path: Path) -> None:
    """Only NamedTuples of the package, and those that are given, are ever called."""
    for kind in ("Path", "print", "object", "Generator", "ndarray"):
        structure = json.dumps({"kind": kind, "fields": {}})
        (tmp_path / "agent.npz").write_bytes(npz(structure=np.array(structure)))
        with pytest.raises(ValueError, match=f"kinds must hold the class {kind}"):
            load(tmp_path / "agent.npz")


def test_an_unwritable_path_is_an_ordinary_error(tmp_path: Path) -> None:
    """A file in the place of a folder, a folder in the place of the file; a folder that is missing is made."""
    agent = QLearning.create((2, 2))
    save(agent, tmp_path / "new folder" / "agent.npz")
    assert os.listdir(tmp_path / "new folder") == ["agent.npz"]
    (tmp_path / "file").touch()
    with pytest.raises(OSError, match=r"cannot write to .*file.agent\.npz: "):
        save(agent, tmp_path / "file" / "agent.npz")
    (tmp_path / "folder").mkdir()
    with pytest.raises(OSError, match=r"cannot write to .*folder: it is a folder"):
        save(agent, tmp_path / "folder")
    assert sorted(os.listdir(tmp_path)) == ["file", "folder", "new folder"]
