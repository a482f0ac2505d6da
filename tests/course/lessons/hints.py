"""All that the checks of exercises may say of a wrong answer: the sentences in their source."""

import ast
from collections.abc import Iterator
from pathlib import Path

FEWEST_LETTERS = 10  # shorter texts, and those without a space, are names and codes
PART = 16  # shorter parts of a sentence with numbers in it are too common to be looked for


def hints(path: Path) -> dict[str, bool]:
    """Return the sentences of a module, and whether each is whole; those with numbers in them come in parts."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    others = {ast.dump(part) for node in ast.walk(tree) for part in _no_hints(node)}
    parts = {id(node) for text in ast.walk(tree) if isinstance(text, ast.JoinedStr) for node in ast.walk(text)}
    return {
        node.value.strip(): id(node) not in parts
        for node in ast.walk(tree)
        if isinstance(node, ast.Constant)
        and isinstance(node.value, str)
        and ast.dump(node) not in others
        and " " in node.value.strip()
        and len(node.value) >= (PART if id(node) in parts else FEWEST_LETTERS)
    }


def _no_hints(node: ast.AST) -> Iterator[ast.AST]:
    """Yield the parts of a node that no wrong answer is told: docstrings, praise, the challenge, codes of mistakes."""
    match node:
        case ast.Expr(part):
            yield part
        case ast.Dict(values=values):
            yield from values
        case ast.Subscript(ast.Dict(keys=keys)) | ast.Attribute(ast.Dict(keys=keys)):
            yield from filter(None, keys)
        case ast.Compare(comparators=parts) | ast.arguments(kw_defaults=parts):
            yield from (end for part in parts if part for end in ast.walk(part))
        case ast.FunctionDef(name=name) if name.startswith("exercise_"):
            yield from (part for end in ast.walk(node) if isinstance(end, ast.Return) for part in ast.walk(end))
        case ast.Assign([ast.Name("CHALLENGE")]):
            yield from ast.walk(node)
