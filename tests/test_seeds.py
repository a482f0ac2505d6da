"""No number of the package is drawn without a seed, so that everything can be repeated."""

import ast
from collections.abc import Iterator
from pathlib import Path

from edugym.system.packages import own_folders

ASKED = {"seed", "repetitions", "jobs", "progress"}
ALWAYS_THE_SAME = {"panel", "my_program"}
STREAMS = {"default_rng", "SeedSequence", "RandomState", "Random", "PCG64", "manual_seed"}


def parsed() -> Iterator[tuple[Path, ast.Module]]:
    """Every file of the library and of the course; the answers of students are their own."""
    files = [path for folder in own_folders() for path in folder.rglob("*.py") if "answers" not in path.parts]
    assert len(files) > 100
    for path in files:
        yield path, ast.parse(path.read_text(encoding="utf-8"))


def test_every_random_stream_has_a_seed() -> None:
    """Which is not None, at least as it is written."""
    for path, tree in parsed():
        for call in ast.walk(tree):
            if isinstance(call, ast.Call) and getattr(call.func, "attr", getattr(call.func, "id", "")) in STREAMS:
                given = [*call.args, *(keyword.value for keyword in call.keywords)]
                assert any(ast.unparse(value) != "None" for value in given), (path, call.lineno)


def test_what_is_asked_of_a_run_reaches_it() -> None:
    """But for checks of an answer that is one number, and for what is the same with every seed."""
    for path, tree in parsed():
        for made in (node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)):
            takes = {one.arg for one in ast.walk(made.args) if isinstance(one, ast.arg)}
            uses = {one.id for line in made.body for one in ast.walk(line) if isinstance(one, ast.Name)}
            forgets = ASKED & takes - uses if uses else set()
            assert not forgets or made.name in ALWAYS_THE_SAME or made.name.startswith("exercise_"), (path, made.name)
