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
from edugym.agents.saving import MOST_BYTES
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
        assert set(file.files) == {"structure", "agent.Q", "agent.exploration.counts", "agent.exploration.bounds"}
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
    for kinds, missing in (((), "OwnAgent"), ((OwnAgent,), "Memory"), (OwnAgent, "Memory")):
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
        zipped("structure.npy", b"raw bytes"),
        npz(structure=np.array('{"value": 3}')),
        npz(structure=np.array('{"value": [1]}')),
        npz(structure=np.array("{}"), a=np.zeros(3)),
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


def stored(structure: Any, arrays: dict[str, bytes], compression: int = zipfile.ZIP_DEFLATED) -> bytes:
    """A file with this structure, and these files for arrays."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", compression) as archive:
        archive.writestr("structure.npy", npy(np.array(json.dumps(structure))))
        for name, content in arrays.items():
            archive.writestr(f"agent.{name}.npy", content)
    return buffer.getvalue()


def q_learning(**fields: Any) -> dict[str, Any]:
    """The structure of an agent, of which some fields are not as they should be."""
    right = {
        "Q": {"array": "agent.Q"},
        "learning_rate": {"value": 0.5},
        "exploration": {"kind": "Greedy", "fields": {}},
    }
    return {"kind": "QLearning", "fields": right | fields}


@pytest.mark.parametrize(
    ("fields", "reason"),
    [
        ({"learning_rate": {"value": "boom"}}, "learning_rate must be a number, .* but is 'boom'"),
        ({"learning_rate": {"value": None}}, "learning_rate must be a number"),
        ({"learning_rate": {"value": True}}, "learning_rate must be a number"),
        ({"learning_rate": {"array": "agent.Q"}}, "learning_rate must be a number"),
        ({"Q": {"value": None}}, "Q must be an array of float64 with 2 axes"),
        ({"Q": {"array": "agent.whole"}}, "Q must be an array of float64 with 2 axes"),
        ({"Q": {"array": "agent.raw"}}, "damaged"),
        ({"exploration": {"value": 3}}, "exploration must be a strategy"),
        (
            {"exploration": {"kind": "EpsilonGreedy", "fields": {"epsilon": {"value": 7}}}},
            "epsilon must be from 0 to 1",
        ),
        (
            {name: {"value": "red"} for name in ("zeal", "colour", "hue", "aim", "name")},
            "QLearning has other fields than the file: aim, colour, hue, name, zeal$",
        ),
    ],
)
def test_values_of_a_file_are_checked(fields: dict[str, Any], reason: str, tmp_path: Path) -> None:
    """As those of a new agent are; a field that is missing has its default."""
    arrays = {"Q": npy(np.zeros((3, 2))), "whole": npy(np.zeros((3, 2), np.int64))}
    path = tmp_path / "agent.npz"
    path.write_bytes(stored(q_learning(), arrays))
    assert load(path).discount == QLearning.create((3, 2)).discount
    path.write_bytes(stored(q_learning(**fields), arrays))
    with pytest.raises(ValueError, match=f"cannot be loaded: .*{reason}") as caught:
        load(path)
    assert caught.value.__suppress_context__
    assert caught.value.__cause__ is None


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        (b"Q,learning_rate", "it is not in the .npz format"),
        (npz(a=np.zeros(3)), "it holds no agent"),
        (npz(a=np.zeros(3, complex)), r"a.npy is not an array that save\(\) wrote"),
        (npz(structure=np.array('{"value": 3}')), "it holds no agent"),
        (npz(structure=np.array('{"value": [1]}')), "its structure is damaged"),
        (npz(structure=np.array('{"kind": "QLearning", "fields": {}}')), "QLearning has other fields than the file: Q"),
    ],
)
def test_what_is_wrong_with_a_file(content: bytes, reason: str, tmp_path: Path) -> None:
    """The sentence ends with it."""
    (tmp_path / "agent").write_bytes(content)
    with pytest.raises(ValueError, match=f"agent' cannot be loaded: {reason}$"):
        load(tmp_path / "agent")


def test_an_error_without_words(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Its name says what is wrong."""

    def full(text: str) -> None:
        raise MemoryError

    save(QLearning.create((3, 2)), tmp_path / "agent")
    monkeypatch.setattr("json.loads", full)
    with pytest.raises(ValueError, match=r"agent' cannot be loaded: MemoryError\(\)$"):
        load(tmp_path / "agent")


def test_a_file_of_just_the_size_that_is_allowed(tmp_path: Path) -> None:
    """One that is not compressed needs more bytes on the disk than in memory."""
    path = tmp_path / "agent"
    save(QLearning.create((1, 1)), path)
    with np.load(path) as arrays:
        path.write_bytes(npz(**arrays))
    size = path.stat().st_size
    assert load(path, max_bytes=size).Q.shape == (1, 1)
    with pytest.raises(ValueError, match=f"it holds more than {size - 1} bytes; to allow that, pass a larger max_byt"):
        load(path, max_bytes=size - 1)


def test_what_could_not_be_loaded_is_not_saved(tmp_path: Path) -> None:
    """The same check stands before the writing."""
    good: Any = QLearning.create((3, 2))
    for agent in (good._replace(Q=np.zeros((3, 2), np.int64)), good._replace(exploration="greedy")):
        with pytest.raises(ValueError, match=r"(Q|exploration) must be"):
            save(agent, tmp_path / "agent.npz")
    for nothing in (3, "agent.npz", QLearning, (1, 2)):
        with pytest.raises(ValueError, match="agent must be a NamedTuple"):
            save(nothing, tmp_path / "agent.npz")
    assert not os.listdir(tmp_path)


def header(shape: str, dtype: str = "<f8") -> bytes:
    """The beginning of a file of an array."""
    words = f"{{'descr': '{dtype}', 'fortran_order': False, 'shape': {shape}, }}".encode().ljust(117) + b"\n"
    return b"\x93NUMPY\x01\x00" + len(words).to_bytes(2, "little") + words


def test_small_files_that_unpack_to_large_ones_are_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """By the sizes that they declare, before anything is unpacked; whoever wants to may allow more."""
    path = tmp_path / "agent.npz"
    save(QLearning.create((1000, 100)), path)
    assert path.stat().st_size < 10_000
    assert load(path, max_bytes=900_000).Q.shape == (1000, 100)
    monkeypatch.setattr(zipfile.ZipFile, "open", None)
    for max_bytes in (100, 100_000, 800_000):
        with pytest.raises(ValueError, match=f"it holds more than {max_bytes} bytes; to allow that, pass a larger"):
            load(path, max_bytes=max_bytes)
    assert MOST_BYTES < 2_000_000_000


def test_all_tables_count_together(tmp_path: Path) -> None:
    """To the byte: of two tables, neither is too large alone."""
    path = tmp_path / "agent.npz"
    save(DoubleQLearning.create((100, 100)), path)
    with zipfile.ZipFile(path) as archive:
        whole = sum(entry.file_size for entry in archive.infolist())
    assert whole > 2 * 80_000
    load(path, max_bytes=whole)
    with pytest.raises(ValueError, match=f"it holds more than {whole - 1} bytes"):
        load(path, max_bytes=whole - 1)


@pytest.mark.parametrize(
    "shape", ["(2, 2)", "(4, 2)", "(1000000000000,)", "(-3, -2)", "(3, 2, 1000000000000, 0)", "(5,)", "(10**9,)"]
)
def test_arrays_are_as_large_as_they_say(shape: str, tmp_path: Path) -> None:
    """A header that promises another size than the file has is not believed: no memory is asked for."""
    path = tmp_path / "agent.npz"
    path.write_bytes(stored(q_learning(), {"Q": header(shape) + bytes(48)}))
    with pytest.raises(ValueError, match="cannot be loaded"):
        load(path)
    path.write_bytes(stored(q_learning(), {"Q": header("(3, 2)") + bytes(48)}))
    assert load(path).Q.shape == (3, 2)


def test_only_the_compression_of_save_is_read(tmp_path: Path) -> None:
    """Others unpack without a limit."""
    path = tmp_path / "agent.npz"
    for compression, is_read in ((zipfile.ZIP_STORED, True), (zipfile.ZIP_BZIP2, False), (zipfile.ZIP_LZMA, False)):
        path.write_bytes(stored(q_learning(), {"Q": npy(np.zeros((3, 2)))}, compression))
        if is_read:
            load(path)
        else:
            with pytest.raises(ValueError, match="compressed in a way that save"):
                load(path)


def test_tables_of_any_shape_and_order_come_back(tmp_path: Path) -> None:
    """Empty ones, too, and those in Fortran's order."""
    for table in (
        np.zeros((0, 2)),
        np.zeros(()),
        np.asfortranarray(np.arange(6.0).reshape(3, 2)),
        np.arange(6.0)[::-2],
    ):
        agent = OwnAgent(table, Memory(np.zeros(0, np.int64), ""))
        save(agent, tmp_path / "own.npz")
        loaded = load(tmp_path / "own.npz", [OwnAgent, Memory])
        np.testing.assert_array_equal(loaded.Q, table)
        assert loaded.Q.shape == table.shape
        assert loaded.Q.flags.writeable
