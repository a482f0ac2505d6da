"""An MDP in one file: it is the same one for whoever opens it."""

import ast
import linecache
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import gymnasium
import numpy as np
import pytest
from gymnasium.spaces import Box, Discrete
from typer.testing import CliRunner

from edugym import finite_model, read_mdp, share, value_iteration, wrapper
from edugym.adapters.playing import Game
from edugym.adapters.sharing import _home, source_of
from edugym_course.commands import app
from edugym_course.lessons.own_problem.morning import Morning, WithBonus

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
    file = "/tmp/ipykernel_1/1.py"
    linecache.cache[file] = (len(CELLS), None, CELLS.splitlines(keepends=True), file)
    names: dict[str, Any] = {"__name__": "__main__"}
    exec(compile(CELLS, file, "exec"), names)
    return names


@pytest.mark.parametrize(
    "make",
    [
        lambda cell: cell["Walk"](4, steps=np.array([1, -1])),
        lambda cell: cell["Slow"](np.int64(5), slip=0.125, steps=np.array([1, 2])),
    ],
)
def test_the_file_is_whole(make: Callable[[dict[str, Any]], Any], cell: dict[str, Any], tmp_path: Path) -> None:
    """Everything that the class uses is in it, and nothing else; fields have the values that they had."""
    mdp = make(cell)
    path = share(mdp, tmp_path / "walk_of_mine.py")
    text = path.read_text(encoding="utf-8")
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
    """In a notebook and by the command, with other values of its fields."""
    path = str(share(Morning(), tmp_path / "morning.py"))
    game = Game(path, late=3.0)
    environment: Any = game.environment.unwrapped
    assert environment.mdp.late == 3.0
    assert [*game.actions] == ["stay quiet", "chime", "ring"]
    with pytest.raises(ValueError, match="has no parameter 'lat'; it has length, ring, late"):
        Game(path, lat=3.0)
    said = CliRunner(env={"COLUMNS": "200"}).invoke(app, ["play", str(tmp_path / "missing.py")]).output
    assert "No such file" in said
    said = CliRunner(env={"COLUMNS": "200"}).invoke(app, ["play", path, "--set", "lat=3"]).output
    assert "has no parameter" in said


def test_classes_of_installed_packages_are_imported(tmp_path: Path) -> None:
    """And wrappers keep what is inside them."""
    mdp = WithBonus(Morning(late=7.5), 3.0)
    path = share(mdp, tmp_path / "bonus.py")
    assert "from edugym_course.lessons.own_problem.morning import Morning" in path.read_text(encoding="utf-8")
    assert read_mdp(path) == mdp
    assert gymnasium.spec("WithBonus-v0").id == "WithBonus-v0"


def test_what_cannot_be_shared(tmp_path: Path, cell: dict[str, Any]) -> None:
    """Is refused in a sentence, and no file is left."""
    for name in ("walk.txt", "my-walk.py", "class.py", "1.py"):
        with pytest.raises(ValueError, match="path must be the name of a Python module"):
            share(Morning(), tmp_path / name)
    with pytest.raises(ValueError, match=r"^mdp must be"):
        share(3, tmp_path / "three.py")
    with pytest.raises(ValueError, match=r"^transition of Lost must return the next state"):
        share(Lost(), tmp_path / "lost.py")
    others: tuple[Any, ...] = iter([]), ast.Constant(1), np.array([None, 1])
    for other in others:
        cell["ends"] = {"left": 0, "right": other}
        with pytest.raises(ValueError, match="ends must be made of numbers, texts and arrays to be shared"):
            share(cell["Slow"](5, steps=np.array([1, 2])), tmp_path / "slow.py")
    assert [*tmp_path.iterdir()] == []


def test_a_class_inside_a_function_is_tried_first(tmp_path: Path) -> None:
    """What it takes from the function is not in the file; no file is left."""
    prize = 2.0

    class Prize(Coin):
        __slots__ = ()

        def reward(self, state: int, action: int, next_state: int, rng: Any) -> float:
            return prize

    with pytest.raises(ValueError, match="Prize cannot be shared, since the file alone does not run"):
        share(Prize(), tmp_path / "prize.py")
    assert [*tmp_path.iterdir()] == []


@pytest.mark.parametrize(
    ("name", "member"),
    [
        ("reward", "lambda self, *_: 7.0"),
        ("terminal", "staticmethod(lambda state: True)"),
        ("max_steps", "property(lambda self: 5)"),
    ],
)
def test_a_method_that_was_replaced_later(name: str, member: str, tmp_path: Path, cell: dict[str, Any]) -> None:
    """The text of the class has the old one."""
    exec(f"Walk.{name} = {member}", cell)
    with pytest.raises(ValueError, match=rf"Walk\.{name} was replaced outside the class: write it in the class"):
        share(eval("Walk(3)", cell), tmp_path / "walk.py")
    assert not (tmp_path / "walk.py").exists()


@pytest.mark.parametrize(
    ("drawing", "says"), [("Shape(1)", "name 'Shape' is not defined"), ("Circle(state.x, 2, 1)", "Circle")]
)
def test_a_picture_that_cannot_be_drawn(drawing: str, says: str, tmp_path: Path, cell: dict[str, Any]) -> None:
    """Is refused in a sentence, and no file is left."""
    text = f"class Drawn(Walk):\n    __slots__ = ()\n    def scene(self, state): return {drawing}\n"
    file = "/tmp/ipykernel_1/2.py"
    linecache.cache[file] = (len(text), None, text.splitlines(keepends=True), file)
    exec(compile(text, file, "exec"), cell)
    with pytest.raises(ValueError, match=f"Drawn cannot be shared, since its method scene draws no picture: .*{says}"):
        share(cell["Drawn"](5, steps=np.array([1, 2])), tmp_path / "drawn.py")
    assert [*tmp_path.iterdir()] == []


def test_functions_are_imported_from_where_they_are(tmp_path: Path, cell: dict[str, Any]) -> None:
    """From the outermost module that has them; one's own that has two names cannot be written."""
    text = (
        "def halved(x): return x / 2\n\nclass Rooted(Walk):\n    __slots__ = ()\n"
        "    def reward(self, state, action, next_state, rng): return sqrt(partial(isqrt, 4)())\n"
    )
    file = "/tmp/ipykernel_1/3.py"
    linecache.cache[file] = (len(text), None, text.splitlines(keepends=True), file)
    exec(compile("from math import isqrt, sqrt\nfrom functools import partial", "", "exec"), cell)
    exec(compile(text, file, "exec"), cell)
    path = share(cell["Rooted"](5, steps=np.array([1, 2])), tmp_path / "rooted.py")
    lines = path.read_text(encoding="utf-8").splitlines()
    for line in ("from functools import partial", "from math import isqrt", "from math import sqrt"):
        assert lines.count(line) == 1
    assert read_mdp(path).reward(0, 0, 0, None) == 2**0.5
    cell["sqrt"] = cell["halved"]
    with pytest.raises(ValueError, match="sqrt must be called halved, as it was defined, to be shared"):
        share(cell["Rooted"](5, steps=np.array([1, 2])), tmp_path / "renamed.py")


def test_a_function_with_the_name_of_one_of_pythons(tmp_path: Path, cell: dict[str, Any]) -> None:
    """The student's own is in the file, and `__name__` is not."""
    text = "def abs(x): return 2 * x\n\nclass Other(Walk):\n    __slots__ = ()\n    def name(self): return __name__\n"
    run(text + "    def reward(self, state, action, next_state, rng): return abs(1.5)\n", 4, cell)
    path = share(cell["Other"](5, steps=np.array([1, 2])), tmp_path / "other.py")
    assert read_mdp(path).reward(0, 0, 0, None) == 3
    assert "__name__ =" not in path.read_text(encoding="utf-8")


def run(text: str, number: int, names: dict[str, Any]) -> None:
    """Run one more cell."""
    file = f"/tmp/ipykernel_1/{number}.py"
    linecache.cache[file] = (len(text), None, text.splitlines(keepends=True), file)
    exec(compile(text, file, "exec"), names)


def test_a_decorator_is_part_of_the_class(tmp_path: Path, cell: dict[str, Any]) -> None:
    """The lines above `class` are copied too, and what they use is imported."""
    cell["wrapper"] = wrapper
    text = "@wrapper\nclass Paid(NamedTuple):\n    mdp: Walk\n    def terminal(self, state): return state.x == 0\n"
    run(text, 4, cell)
    path = share(cell["Paid"](cell["Walk"](5, steps=np.array([1, 2]))), tmp_path / "paid.py")
    assert text in path.read_text(encoding="utf-8")
    assert read_mdp(path).initial(None).x == 1


def test_a_cell_that_was_run_again(tmp_path: Path, cell: dict[str, Any]) -> None:
    """Of two classes of one name, neither with a method, the last one is shared; a cell that is no Python is none."""
    run("class Place(NamedTuple):\n    y: int\n    x: int = 1\n", 5, cell)
    run("class Place(NamedTuple):\n    x: int\n    again: bool = True\n", 6, cell)
    linecache.cache["/tmp/ipykernel_1/7.py"] = (8, None, ["%time 1\n"], "/tmp/ipykernel_1/7.py")
    path = share(cell["Walk"](5, steps=np.array([1, 2])), tmp_path / "again.py")
    assert read_mdp(path).initial(None)._fields == ("x", "again")


def test_an_older_cell_that_was_run_again(tmp_path: Path, cell: dict[str, Any]) -> None:
    """The class of that cell is shared, though another cell with the name was new after it."""
    older = "class Place(NamedTuple):\n    x: int\n    first: bool = True\n"
    for number, text in ((5, older), (6, "class Place(NamedTuple):\n    x: int\n    y: int = 1\n")):
        run(text, number, cell)
    exec(compile(older, "/tmp/ipykernel_1/5.py", "exec"), cell)  # IPython knows its lines already
    path = share(cell["Walk"](5, steps=np.array([1, 2])), tmp_path / "older.py")
    assert read_mdp(path).initial(None)._fields == ("x", "first")


@pytest.mark.parametrize("method", ["", "    def twice(self): return 2 * self.x\n"])
def test_a_class_that_a_cell_defines_twice(method: str, tmp_path: Path, cell: dict[str, Any]) -> None:
    """The last one is shared, as it is the one that Python keeps."""
    kinds = ("    y: int\n    x: int = 1\n", "    x: int\n    again: bool = True\n")
    run("\n".join(f"class Place(NamedTuple):\n{fields}{method}" for fields in kinds), 7, cell)
    path = share(cell["Walk"](5, steps=np.array([1, 2])), tmp_path / "twice.py")
    assert read_mdp(path).initial(None)._fields == ("x", "again")


def test_the_source_is_that_of_the_class_with_its_methods(cell: dict[str, Any]) -> None:
    """Also where its cell has defined another of that name before or after it."""
    texts = [f"class Coin(NamedTuple):\n    side: int\n    def value(self): return {n}\n" for n in range(3)]
    run("\n".join(f"{text}Coin{n} = Coin" for n, text in enumerate(texts)), 8, cell)
    assert [source_of(cell[f"Coin{n}"]) + "\n" for n in range(3)] == texts


def test_a_namesake_is_not_imported() -> None:
    """A class that says it is of a module is taken from there only where it is the one that is there."""
    assert _home("Rows", Box) == ("gymnasium.spaces", "Box")
    assert _home("Box", type("Box", (), {"__module__": "gymnasium.spaces"})) is None


def test_what_cannot_be_read(tmp_path: Path) -> None:
    """A file without an MDP, and one whose MDP is wrong."""
    (tmp_path / "empty.py").write_text("x = 1\n")
    with pytest.raises(ValueError, match="must give its MDP the name MDP"):
        read_mdp(tmp_path / "empty.py")
    (tmp_path / "wrong.py").write_text("MDP = 3\n")
    with pytest.raises(ValueError, match="mdp must be an MDP"):
        read_mdp(tmp_path / "wrong.py")
    (tmp_path / "text.txt").write_text("MDP = 3\n")
    with pytest.raises(ValueError, match="path must be a Python file"):
        read_mdp(tmp_path / "text.txt")
    for name in ("missing.py", "missing.txt"):
        with pytest.raises(FileNotFoundError, match=name):
            read_mdp(tmp_path / name)


class Coin(NamedTuple):
    """A class in a file of one's own, which is imported."""

    max_steps: int = 3

    @property
    def observation_space(self) -> Discrete:
        """Heads or tails."""
        return Discrete(2)

    @property
    def action_space(self) -> Discrete:
        """Leave it or throw."""
        return Discrete(2)

    def initial(self, rng: Any) -> int:
        """Heads."""
        return 0

    def transition(self, state: int, action: int, rng: Any) -> int:
        """Throw, or leave it."""
        return int(rng.random() < 0.5) if action else state

    def reward(self, state: int, action: int, next_state: int, rng: Any) -> float:
        """Tails are worth 1."""
        return float(next_state)

    def terminal(self, state: int) -> bool:
        """Never."""
        return False

    def observation(self, state: int, rng: Any) -> int:
        """The side."""
        return state


class Lost(Coin):
    """A task whose first steps show a mistake."""

    __slots__ = ()

    def transition(self, state: Any, action: int, rng: Any) -> Any:
        """No `return`."""


@wrapper
class Holding(NamedTuple):
    """A task with a field of any kind."""

    mdp: Any
    held: Any


@pytest.mark.parametrize(
    "held",
    [
        None, True, -3, 0.1 + 0.2, -0.0, float("inf"), float("-inf"), "it's\n", (), (1,), (1, (2.0, "x")), [], [1, [2]],
        {3}, set(), {}, {"a": [1], (1, 2): None}, Coin(4), (Coin(1), Coin(2)), np.float32(0.1), np.int8(3), np.True_,
        np.array([[1, 2], [3, 4]]), np.array([0.1, -0.0]), np.array([True, False]), np.array([1, 2], np.uint8),
        np.array([0.1], np.float32), np.zeros((0,)), np.array(2.5),
    ],
    ids=repr,
)  # fmt: skip
def test_values_of_every_kind(held: Any, tmp_path: Path) -> None:
    """Numbers, texts, containers and arrays come back as they were, each of its type."""
    read = read_mdp(share(Holding(Coin(), held), tmp_path / "holding.py")).held
    plain = held.item() if isinstance(held, np.generic) else held
    assert type(read) is type(plain)
    if isinstance(held, np.ndarray):
        assert (read.dtype, read.shape) == (held.dtype, held.shape)
    assert repr(read) == repr(plain)


def test_the_lines_of_the_file(cell: dict[str, Any], tmp_path: Path) -> None:
    """How to play it, what is imported, what is used before its use, the MDP, and its registration."""
    text = share(cell["Slow"](5, steps=np.array([1, 2])), tmp_path / "slow.py").read_text(encoding="utf-8")
    assert text.startswith(
        '"""Slow: a problem for reinforcement learning, written with EduGym. To play it: edugym play slow.py"""\n\n'
        "import edugym\nimport gymnasium\nimport math\nimport numpy as np\n"
        "from edugym.rendering.scene import Scene\nfrom edugym.rendering.shapes import Circle\n"
        "from gymnasium.spaces import Discrete as Whole\nfrom typing import NamedTuple\n\n\nclass Place(NamedTuple):\n"
    )
    starts = ["\nSIDE = 3\n", "\nends = {'left': 0, 'right': (4,)}\n", "\ndef moved(", "\nclass Walk(", "\nclass Slow("]
    ends = ["\n\n\nMDP = Slow(size=5, slip=0.25, steps=np.array([1, 2], np.int64))\n\n", 'register("Slow-v0"']
    places = [text.index(part) for part in starts + ends]
    assert places == sorted(places)
    assert [text.count(part) for part in starts + ends] == [1] * 7
    environment = gymnasium.make("Slow-v0", render_mode="rgb_array")
    assert environment.render_mode == "rgb_array"
