"""Docstrings as Markdown, and the description of a public name for Sphinx."""

import ast
import inspect
import re
import textwrap
from collections.abc import Iterator
from typing import Any

_SECTIONS = {
    "Args": "Arguments",
    "Attributes": "Attributes",
    "Returns": "Returns",
    "Yields": "Yields",
    "Raises": "Raises",
}
_SECTION = re.compile(rf"^({'|'.join(_SECTIONS)}):\n((?:(?: {{4}}.*)?\n)+)", re.MULTILINE)
_HEADING = re.compile(r"^##+ (.*)$", re.MULTILINE)
"""Those of an environment, which would be headings of the page that it stands on."""
_ITEM = re.compile(r"^(?=\S)", re.MULTILINE)


def markdown(thing: Any) -> str:
    """Return a docstring as Markdown: the sections of Google's style become lists, all else is Markdown already."""
    return _SECTION.sub(_section, (inspect.getdoc(thing) or "") + "\n").strip()


def _section(found: re.Match[str]) -> str:
    title, body = _SECTIONS[found[1]], textwrap.dedent(found[2]).strip()
    if title in ("Returns", "Yields"):
        return f"**{title}**\n\n{body}\n\n"
    items = [re.sub(r"\s+", " ", item).strip() for item in _ITEM.split(body) if item.strip()]
    listed = [re.sub(r"^(\S+?):", r"`\1`:", item) for item in items]
    return f"**{title}**\n\n" + "".join(f"- {item}\n" for item in listed) + "\n"


def summary(thing: Any) -> str:
    """Return the first sentence of a docstring, in one line."""
    text = re.split(r"\n\s*\n", inspect.getdoc(thing) or "", maxsplit=1)[0]
    return re.sub(r"\s+", " ", text).strip()


def source(thing: Any) -> str:
    """Return the source of a function or class, without indentation."""
    return textwrap.dedent(inspect.getsource(thing)).strip()


def _definition(function: Any) -> ast.FunctionDef:
    node = ast.parse(source(function)).body[0]
    assert isinstance(node, ast.FunctionDef)
    return node


def signature(function: Any, *, method: bool = False) -> str:
    """Return the signature of a function as its source has it; that of a method is without `self`."""
    node = _definition(function)
    if method:
        (node.args.posonlyargs or node.args.args).pop(0)
    returned = "" if node.returns is None else f" -> {ast.unparse(node.returns)}"
    return f"({ast.unparse(node.args)}){returned}"


def public_members(kind: type) -> Iterator[tuple[str, Any]]:
    """Yield the documented public methods and properties that a class defines itself, in the order of its source."""
    for name, member in vars(kind).items():
        wrapped = getattr(member, "fget", None) or getattr(member, "func", None) or inspect.unwrap(member)
        function = getattr(wrapped, "__func__", wrapped)
        if not name.startswith("_") and inspect.isfunction(function) and inspect.getdoc(function):
            yield name, member


def described(name: str, thing: Any, module: str = "edugym", docstring: str | None = None) -> str:
    """Return the description of a public name as a directive of Sphinx, with that of its members.

    Args:
        name: the name.
        thing: what has it.
        module: where it is imported from.
        docstring: what to say of a class in place of its docstring, where that stands elsewhere on the page, or of what
            has none.
    """
    if inspect.isfunction(thing):
        return _directive("function", name + signature(thing), markdown(thing), module)
    if not inspect.isclass(thing):
        own = docstring or (summary(thing) if thing.__doc__ != type(thing).__doc__ else "")
        return _directive("data", name, own, module)
    members = [_member(label, member) for label, member in public_members(thing)]
    text = _HEADING.sub(r"**\1**\n", markdown(thing)) if docstring is None else docstring
    return _directive("class", name, "\n\n".join([text, *members]), module, colons=5)


def _member(name: str, member: Any) -> str:
    function = getattr(member, "fget", None) or getattr(member, "func", None)
    if function is not None:
        return _directive("property", name, markdown(function))
    function = inspect.unwrap(getattr(member, "__func__", member))
    is_static = isinstance(member, staticmethod)
    option = ":staticmethod:" if is_static else ":classmethod:" if isinstance(member, classmethod) else ""
    return _directive("method", name + signature(function, method=not is_static), markdown(function), option=option)


def _directive(kind: str, name: str, body: str, module: str = "", option: str = "", colons: int = 4) -> str:
    options = [option] if option else []
    options += [f":module: {module}"] if module else []
    return "\n".join([f"{':' * colons}{{py:{kind}}} {name}", *options, "", body, ":" * colons])
