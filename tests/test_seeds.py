"""No number of the package is drawn without a seed, so that everything can be repeated."""

import ast

from edugym.system.packages import own_folders

STREAMS = {"default_rng", "SeedSequence", "RandomState", "Random", "PCG64", "manual_seed"}


def test_every_random_stream_has_a_seed() -> None:
    """In every file of the library and of the course; the answers of students are their own."""
    files = [path for folder in own_folders() for path in folder.rglob("*.py") if "answers" not in path.parts]
    assert len(files) > 100
    for path in files:
        for call in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(call, ast.Call) and getattr(call.func, "attr", getattr(call.func, "id", "")) in STREAMS:
                given = [*call.args, *(keyword.value for keyword in call.keywords)]
                assert any(ast.unparse(value) != "None" for value in given), (path, call.lineno)
