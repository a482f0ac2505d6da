"""No number of the package is drawn without a seed, so that everything can be repeated."""

import ast
from pathlib import Path

import edugym

ROOT = Path(edugym.__path__[0])
STREAMS = {"default_rng", "SeedSequence", "RandomState", "Random", "PCG64", "manual_seed"}


def unseeded(source: str) -> list[str]:
    """Where a random stream begins that is another one each time."""
    calls = [node for node in ast.walk(ast.parse(source)) if isinstance(node, ast.Call)]
    begun = [call for call in calls if ast.unparse(call.func).rpartition(".")[2] in STREAMS]
    return [ast.unparse(call) for call in begun if all(map(says_nothing, values(call)))]


def values(call: ast.Call) -> list[ast.expr]:
    """The arguments of a call."""
    return [*call.args, *(keyword.value for keyword in call.keywords)]


def says_nothing(value: ast.expr) -> bool:
    """Whether it is None."""
    return isinstance(value, ast.Constant) and value.value is None


def test_every_random_stream_has_a_seed() -> None:
    """In every file of the package."""
    found = {path.name: calls for path in ROOT.rglob("*.py") if (calls := unseeded(path.read_text(encoding="utf-8")))}
    assert found == {}


def test_what_has_no_seed() -> None:
    """A call without arguments, or with None; another name for the module hides nothing."""
    source = "a = np.random.default_rng()\nb = default_rng(None)\nc = default_rng(0)\nd = default_rng(seed=s)"
    assert unseeded(source) == ["np.random.default_rng()", "default_rng(None)"]
