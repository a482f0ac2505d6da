"""An MDP in one file: it is the same one for whoever opens it."""

import linecache
import subprocess
import sys
from pathlib import Path
from typing import Any, NamedTuple

import gymnasium
import numpy as np
import pytest
from gymnasium.spaces import Box

from edugym import finite_model, read_mdp, share, value_iteration, wrapper
from edugym.adapters.playing import Game
from edugym.adapters.sharing import _home
from edugym_course.lessons.own_problem.morning import Morning, WithBonus
from tests.adapters.playing.tasks import Walk

CELLS = """
import math
from typing import NamedTuple
import numpy as np
from gymnasium.spaces import Discrete as Whole
from edugym.rendering.scene import Circle, Scene

SIDE, ends = 3, {"left": 0, "right": (4,)}
time = object()  # has the name of a local variable below, and could not be written
unused = open

class Place(NamedTuple):
    x: int

def moved(x, by):
    return max(x + by, ends["left"])

class Walk(NamedTuple):
    \"\"\"Walk to the right.\"\"\"
    size: int
    slip: float = 0.25
    steps: np.ndarray = np.zeros(2, np.int64)
    observation_space = property(lambda self: Whole(self.size + 1))
    action_space = property(lambda self: Whole(2))
    def initial(self, rng): return Place(SIDE - 2)
    def transition(self, state, action, rng):
        time = state.x
        by = int(self.steps[action])
        return Place(min(moved(time, -by if rng.random() < self.slip else by), self.size))
    def reward(self, state, action, next_state, rng): return math.sqrt(next_state.x)
    def terminal(self, state): return state.x == self.size or state.x == 0
    def observation(self, state, rng): return state.x
    def scene(self, state): return Scene(9.0, 5.0, (Circle(state.x, 2, 1),))

class Slow(Walk):
    __slots__ = ()
    def reward(self, state, action, next_state, rng): return -1.0
"""


@pytest.fixture
def cell(monkeypatch: pytest.MonkeyPatch) -> dict[str, Any]:
    """The names after a notebook's cell was run, as IPython does it: the lines are known, and there is no file."""
    monkeypatch.setattr(linecache, "cache", {})  # the cells of other tests are not in this notebook
    names: dict[str, Any] = {"__name__": "__main__"}
    run(CELLS, names)
    return names


def run(text: str, names: dict[str, Any], file: str | None = None) -> str:
    """Run one more cell, and return its file."""
    file = file or f"/tmp/ipykernel_1/{len(linecache.cache)}.py"
    linecache.cache[file] = (len(text), None, text.splitlines(keepends=True), file)
    exec(compile(text, file, "exec"), names)
    return file


def shared(names: dict[str, Any], mdp: str, folder: Path) -> tuple[str, Any]:
    """The file in which an MDP of these cells is shared, and what it holds."""
    path = share(eval(mdp, names), folder / "shared.py")
    return path.read_text(encoding="utf-8"), read_mdp(path)


SLOW = "Slow(5, steps=np.array([1, 2]))"
WALKING = "Walk(5, steps=np.array([1, 2]))"
REWARD = "    __slots__ = ()\n    def reward(self, state, action, next_state, rng): return"


def test_the_file_is_whole(cell: dict[str, Any], tmp_path: Path) -> None:
    """Everything that the class uses is in it, and nothing else; fields have the values that they had."""
    cell["state"] = cell["by"] = object()  # a parameter with the name of a variable has nothing to do with it
    mdp = cell["Slow"](np.int64(5), slip=0.125, steps=np.array([1, 2]))
    path = share(mdp, tmp_path / "walk_of_mine.py")
    text = path.read_text(encoding="utf-8")
    assert text.startswith('"""Slow: ')
    assert 'edugym play walk_of_mine.py"""' in text.partition("\n")[0]
    assert "unused" not in text
    assert "time = object" not in text
    read = read_mdp(path)
    assert type(read).__name__ == type(mdp).__name__
    models = [finite_model(one) for one in (mdp, read)]
    assert [*map(tuple, models[0].states)] == [*map(tuple, models[1].states)]
    np.testing.assert_array_equal(models[0].p, models[1].p)
    assert value_iteration(models[0], 0.9).start == value_iteration(models[1], 0.9).start
    again = share(read, tmp_path / "again.py")  # what a friend has changed can be passed on
    assert again.read_text(encoding="utf-8").replace("again.py", "walk_of_mine.py") == text


def test_a_friend_opens_it_in_another_process(cell: dict[str, Any], tmp_path: Path) -> None:
    """By Gymnasium's `make`, with the name of the module."""
    share(cell["Walk"](4, steps=np.array([1, -1])), tmp_path / "walk_of_mine.py")
    code = "import gymnasium; print(gymnasium.make('walk_of_mine:Walk-v0', render_mode='ansi').reset(seed=1)[0])"
    done = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True)
    assert done.stdout == "1\n", done.stderr


def test_playing_a_file(tmp_path: Path) -> None:
    """With other values of its fields."""
    game = Game(str(share(Morning(), tmp_path / "morning.py")), late=3.0)
    environment: Any = game.environment.unwrapped
    assert environment.mdp.late == 3.0
    assert [*game.actions] == ["stay quiet", "chime", "ring"]
    with pytest.raises(ValueError, match="'lat'; it has length, ring, late"):
        Game(str(tmp_path / "morning.py"), lat=3.0)
    for name in ("walk.txt", "my-walk.py", "class.py", "1.py"):  # of which others cannot import it
        with pytest.raises(ValueError, match=f"path .*{name}"):
            share(Morning(), tmp_path / name)


def test_classes_of_installed_packages_are_imported(tmp_path: Path) -> None:
    """And wrappers keep what is inside them."""
    mdp = WithBonus(Morning(late=7.5), 3.0)
    text, read = shared({"mdp": mdp}, "mdp", tmp_path)
    assert "from edugym_course.lessons.own_problem.morning import Morning" in text
    assert read == mdp
    assert gymnasium.spec("WithBonus-v0").id == "WithBonus-v0"
    assert _home("Rows", Box) == ("gymnasium.spaces", "Box")  # under any name, if it is the one that is there
    assert _home("Box", type("Box", (), {"__module__": "gymnasium.spaces"})) is None


def drawn(drawing: str) -> str:
    """A class with a picture."""
    return f"class Drawn(Walk):\n    __slots__ = ()\n    def scene(self, state): return {drawing}\n"


@pytest.mark.parametrize(
    ("cells", "mdp", "says"),
    [
        ("", "3", "^mdp must be"),
        ("class Lost(Coin):\n    def transition(self, *_): pass", "Lost()", "^transition of Lost"),
        ("ends = {'left': 0, 'right': iter([])}", SLOW, "ends must be made of numbers, texts and arrays"),
        ("ends = {'left': 0, 'right': np.array([None, 1])}", SLOW, "ends must be made of"),
        ("Walk.reward = lambda self, *_: 7.0", "Walk(3)", r"Walk\.reward was replaced"),
        ("Walk.terminal = staticmethod(lambda state: False)", "Walk(3)", r"Walk\.terminal was replaced"),
        ("Walk.max_steps = property(lambda self: 5)", "Walk(3)", r"Walk\.max_steps was replaced"),
        (drawn("Shape(1)"), WALKING.replace("Walk", "Drawn"), "Drawn .*scene .*name 'Shape' is not defined"),
        (drawn("Circle(state.x, 2, 1)"), WALKING.replace("Walk", "Drawn"), "Drawn .*scene .*Circle"),
        (
            f"def halved(x): return x / 2\nroot = halved\nclass Rooted(Walk):\n{REWARD} root(4)",
            "Rooted(5, steps=np.array([1, 2]))",
            "root must be called halved",
        ),
        (
            "def inside(prize):\n    class Prize(Coin):\n        __slots__ = ()\n"
            "        def reward(self, *_): return prize\n    return Prize()\n",
            "inside(2.0)",
            "Prize cannot be shared",
        ),
    ],
)
def test_what_cannot_be_shared(cells: str, mdp: str, says: str, tmp_path: Path, cell: dict[str, Any]) -> None:
    """Is refused in a sentence, and no file is left."""
    cell["Coin"] = Walk
    run(cells, cell)
    with pytest.raises(ValueError, match=says):
        shared(cell, mdp, tmp_path)
    assert [*tmp_path.iterdir()] == []


@pytest.mark.parametrize(
    ("text", "expected", "once"),
    [
        (  # imported from where they are
            "from math import isqrt, sqrt\nfrom functools import partial\n\n"
            f"class Own(Walk):\n{REWARD} sqrt(partial(isqrt, 4)())\n",
            2**0.5,
            ["from functools import partial\n", "from math import isqrt\n", "from math import sqrt\n"],
        ),
        (  # one's own, with the name of one of Python's; __name__ is not
            f"def abs(x): return 2 * x\n\nclass Own(Walk):\n{REWARD} abs(1.5) * len(__name__)\n",
            3.0 * len("shared"),
            ["def abs(x)"],
        ),
        (  # that call each other
            "def even(n): return n == 0 or odd(n - 1)\ndef odd(n): return n != 0 and even(n - 1)\n\n"
            f"class Own(Walk):\n{REWARD} float(even(3))\n",
            0.0,
            ["def odd", "def even"],
        ),
        (  # that are methods by another name
            "def paid(self, *_): return 7.0\n\nclass Own(Walk):\n    __slots__ = ()\n    reward = paid\n"
            "    def terminal(self, state): return state.x == 0\n",
            7.0,
            ["def paid", "def terminal(self, state): return state.x == 0"],
        ),
    ],
)
def test_functions_that_a_class_uses(
    text: str, expected: float, once: list[str], tmp_path: Path, cell: dict[str, Any]
) -> None:
    """Each is in the file once, with what it uses in turn, or imported."""
    run(text, cell)
    written, read = shared(cell, "Own(5, steps=np.array([1, 2]))", tmp_path)
    assert read.reward(0, 0, 0, None) == expected
    assert [written.count(line) for line in once] == [1] * len(once)
    assert "__name__ =" not in written


def test_a_decorator_is_part_of_the_class(tmp_path: Path, cell: dict[str, Any]) -> None:
    """The lines above `class` are copied too, and what they use is imported."""
    cell["wrapper"] = wrapper
    text = "@wrapper\nclass Paid(NamedTuple):\n    mdp: Walk\n    def terminal(self, state): return state.x == 0\n"
    run(text, cell)
    written, read = shared(cell, f"Paid({WALKING})", tmp_path)
    assert text in written
    assert read.initial(None).x == 1


PLACES = ("    x: int\n    a: bool = True\n", "    y: int\n    x: int = 1\n", "    x: int\n    b: int = 1\n")


@pytest.mark.parametrize(("in_one_cell", "method"), [(False, ""), (True, "    def twice(self): return 2 * self.x\n")])
def test_of_two_classes_of_one_name_the_last_is_shared(
    in_one_cell: bool, method: str, tmp_path: Path, cell: dict[str, Any]
) -> None:
    """It is the one that Python keeps, also of an older cell that is run again; what else is known is no cell."""
    texts = [f"class Place(NamedTuple):\n{fields}{method}" for fields in PLACES]
    for text in ["\n".join(texts)] if in_one_cell else texts:
        file = run(text, cell)
    elsewhere = f"{texts[0]}    # another program's\n"
    linecache.cache["/tmp/ipykernel_1/7.py"] = (8, None, ["%time 1\n"], "/tmp/ipykernel_1/7.py")
    linecache.cache["<not read yet>"] = (lambda: "",)
    linecache.cache["/somewhere/places.py"] = (len(elsewhere), None, elsewhere.splitlines(keepends=True), "places.py")
    assert shared(cell, WALKING, tmp_path)[1].initial(None)._fields == ("x", "b")
    older = file if in_one_cell else "/tmp/ipykernel_1/1.py"
    exec(compile(texts[0], older, "exec"), cell)  # IPython knows its lines already
    written, read = shared(cell, WALKING, tmp_path)
    assert in_one_cell or read.initial(None)._fields == ("x", "a")
    assert "another program's" not in written


@pytest.mark.parametrize(
    ("name", "text", "error", "says"),
    [
        ("empty.py", "x = 1\n", ValueError, "empty.py .*MDP"),  # there is none
        ("wrong.py", "MDP = 3\n", ValueError, "mdp must be an MDP"),
        ("text.txt", "MDP = 3\n", ValueError, "path .*text.txt"),
        ("slip.py", "import numpy\nMDP = nunpy\n", ValueError, "slip.py .*line 2 .*NameError.*nunpy"),
        ("slip.py", "import numpy\nMDP = (\n", ValueError, "slip.py .*line 2 .*SyntaxError"),
        ("slip.py", "MDP = 1\0\n", ValueError, "slip.py .*null bytes"),
        ("missing.py", "", FileNotFoundError, "missing.py"),
        ("missing.txt", "", FileNotFoundError, "missing.txt"),
    ],
)
def test_what_cannot_be_read(name: str, text: str, error: type[Exception], says: str, tmp_path: Path) -> None:
    """A file without an MDP, one whose MDP is wrong, and none."""
    if text:
        (tmp_path / name).write_text(text)
    with pytest.raises(error, match=says):
        read_mdp(tmp_path / name)


@wrapper
class Holding(NamedTuple):
    """A task with a field of any kind."""

    mdp: Any
    held: Any


@pytest.mark.parametrize(
    "held",
    [
        (None, True, -3, 0.1 + 0.2, -0.0, float("inf"), float("-inf"), "it's\n"),
        ((), (1,), (1, (2.0, "x")), [], [1, [2]], {3}, set(), {}, {"a": [1], (1, 2): None}, Walk(5)),
        np.float32(0.1), np.int8(3), np.True_, np.array([[1, 2], [3, 4]]), np.array([0.1, -0.0]),
        np.array([True, False]), np.array([1, 2], np.uint8), np.array([0.1], np.float32), np.zeros((0,)), np.array(2.5),
    ],
    ids=repr,
)  # fmt: skip
def test_values_of_every_kind(held: Any, tmp_path: Path) -> None:
    """Numbers, texts, containers and arrays come back as they were, each of its type."""
    read = read_mdp(share(Holding(Walk(), held), tmp_path / "holding.py")).held
    plain = held.item() if isinstance(held, np.generic) else held
    assert type(read) is type(plain)
    if isinstance(held, np.ndarray):
        assert (read.dtype, read.shape) == (held.dtype, held.shape)
    assert repr(read) == repr(plain)
