"""Write an MDP into one Python file, which a friend can open, play and train on; and read such a file.

The file has the class, whatever else of the notebook the class uses, the settings, and three lines that register it
with Gymnasium. It is Python: **opening it runs it**, so open only files of people whom you trust.
"""

import ast
import contextlib
import inspect
import keyword
import linecache
import re
import symtable
import sys
import tempfile
import textwrap
from collections.abc import Iterator
from pathlib import Path
from types import FunctionType, ModuleType
from typing import Any

import numpy as np

from edugym.adapters.gymnasium_env import MDPEnv
from edugym.checks.parameters import a_path, in_short
from edugym.mdp.task import check_mdp
from edugym.rendering.ansi import to_text
from edugym.system.files import write_whole
from edugym.system.own_files import run_file

TEXT = '''\
"""{name}: a problem for reinforcement learning, written with EduGym. To play it: edugym play {file}"""

{code}


MDP = {value}

gymnasium.registry.pop("{name}-v0", None)  # an older version of it
gymnasium.register("{name}-v0", entry_point=lambda render_mode=None: edugym.MDPEnv(MDP, render_mode))
'''


def share(mdp: Any, path: str | Path) -> Path:
    """Write an MDP, its class and its settings, into a Python file.

    A friend who has EduGym and the file `kiosk.py` can run `edugym play kiosk.py`, and can write
    `edugym.read_mdp("kiosk.py")`, or `gymnasium.make("kiosk:Kiosk-v0")` where Python finds the file.

    Args:
        mdp: the MDP. The class may use imported modules, and functions, classes and plain values of your own.
        path: the file, which ends in .py. An old one is replaced.

    Returns:
        The path.

    Raises:
        ValueError: it is no MDP, the path cannot be the name of a module, the class uses something that cannot be
            written into a file, or its picture cannot be drawn.
        OSError: the file cannot be written.
    """
    path = a_path("path", path)
    if path.suffix != ".py" or not path.stem.isidentifier() or keyword.iskeyword(path.stem):
        raise ValueError(f"path must be the name of a Python module, such as kiosk.py, but is {str(path)!r}")
    check_mdp(mdp)
    parts = _Parts()
    value = parts.text_of(mdp, "the MDP")
    imports = sorted(parts.imports | {"import gymnasium", "import edugym"})
    code = "\n".join(sorted(imports, key=lambda line: line.startswith("from")))
    code += "".join(f"\n\n\n{text}" for text in parts.definitions.values())
    text = TEXT.format(name=type(mdp).__name__, file=path.name, code=code.strip(), value=value)
    _try(text, type(mdp).__name__)
    return write_whole(path, text.encode())


def _try(text: str, name: str) -> None:
    """Refuse a file that could not be read again: its class may use what only the notebook has.

    The picture of the first state is drawn too.

    Raises:
        ValueError: it cannot be read, or not drawn.
    """
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "tried.py")
        file.write_text(text, encoding="utf-8")
        try:
            mdp = read_mdp(file)
        except Exception as error:
            raise ValueError(f"{name} cannot be shared, since the file alone does not run: {error}") from None
        try:
            to_text(MDPEnv(mdp).scene())
        except Exception as error:
            raise ValueError(f"{name} cannot be shared, since its method scene draws no picture: {error}") from None


def read_mdp(path: str | Path, **parameters: Any) -> Any:
    """Open a file that `share` wrote, and return its MDP. **This runs the file**: open only those that you trust.

    Args:
        path: the file.
        parameters: fields of the MDP that should have other values.

    Raises:
        ValueError: the file does not end in .py, it fails, it has no value `MDP`, this is no MDP, or it has no such
            fields.
        OSError: the file cannot be read.
    """
    path = a_path("path", path)
    mdp = getattr(run_file(path), "MDP", None)
    if mdp is None:
        raise ValueError(f"{path.name} must give its MDP the name MDP, as edugym.share does, but has no such name")
    fields = getattr(mdp, "_fields", ())
    unknown = [name for name in parameters if name not in fields]
    if unknown:
        raise ValueError(f"{path.name} has no parameter {unknown[0]!r}; it has {', '.join(fields) or 'none'}")
    mdp = mdp._replace(**parameters) if parameters else mdp
    check_mdp(mdp)
    return mdp


class _Parts:
    """What the file must have besides the MDP.

    Attributes:
        imports: the lines that import something.
        definitions: by name, classes, functions and values of the student's own; what is used comes first.
    """

    def __init__(self) -> None:
        """Nothing yet."""
        self.imports: set[str] = set()
        self.definitions: dict[str, str] = {}
        self._under_way: set[str] = set()

    def text_of(self, value: Any, what: str) -> str:
        """Write a value as Python, and collect what that needs.

        Raises:
            ValueError: the value cannot be written.
        """
        if isinstance(value, np.generic):
            value = value.item()
        if isinstance(value, np.ndarray) and value.dtype.kind in "biuf":
            self.imports.add("import numpy as np")
            return f"np.array({value.tolist()}, np.{value.dtype})"
        if value is None or isinstance(value, bool | int | str):
            return repr(value)
        if isinstance(value, float):
            return repr(value) if np.isfinite(value) else f'float("{value}")'
        if isinstance(value, tuple) and hasattr(value, "_fields"):
            self.need(type(value).__name__, type(value))
            fields = zip(value._fields, value, strict=True)
            return f"{type(value).__name__}({', '.join(f'{n}={self.text_of(part, n)}' for n, part in fields)})"
        if type(value) in (tuple, list, set, dict):
            return self._container(value, what)
        raise ValueError(f"{what} must be made of numbers, texts and arrays to be shared, but is {in_short(value)}")

    def _container(self, value: Any, what: str) -> str:
        if isinstance(value, dict):
            pairs = (f"{self.text_of(key, what)}: {self.text_of(part, what)}" for key, part in value.items())
            return f"{{{', '.join(pairs)}}}"
        inside = ", ".join(self.text_of(part, what) for part in value)
        if isinstance(value, tuple):
            return f"({inside},)" if len(value) == 1 else f"({inside})"
        return f"[{inside}]" if isinstance(value, list) else f"{{{inside}}}" if value else "set()"

    def need(self, name: str, value: Any) -> None:
        """Collect what the file must have so that a name stands for a value there.

        Raises:
            ValueError: it cannot have that.
        """
        if name in self.definitions or name in self._under_way:
            return
        if isinstance(value, ModuleType):
            self.imports.add(f"import {value.__name__}" + ("" if value.__name__ == name else f" as {name}"))
        elif (home := _home(name, value)) is not None:
            module, original = home
            self.imports.add(f"from {module} import {original}" + ("" if original == name else f" as {name}"))
        elif isinstance(value, type | FunctionType):
            self._under_way.add(name)
            text = source_of(value)
            _check_whole(value, text)
            if value.__name__ != name:
                raise ValueError(f"{name} must be called {value.__name__}, as it was defined, to be shared")
            for used in _names(text):
                if (found := _meaning(used, value)) is not _NOTHING:
                    self.need(used, found)
            self.definitions[name] = text
        else:
            self.definitions[name] = f"{name} = {self.text_of(value, name)}"


_NOTHING = object()


def _home(name: str, value: Any) -> tuple[str, str] | None:
    """The installed module from which a value can be imported, and its name there; None for one's own."""
    parts = (getattr(value, "__module__", None) or "").split(".")
    original = getattr(value, "__name__", name)
    for k in range(1, len(parts) + 1):  # gymnasium.spaces before gymnasium.spaces.discrete
        home = ".".join(parts[:k])
        module = sys.modules.get(home)
        if home != "__main__" and getattr(module, "__spec__", None) and getattr(module, original, None) is value:
            return home, original
    return None


def _names(text: str) -> list[str]:
    """The names that a piece of code uses and does not define, in order; Python's own, such as `max`, included."""
    outside = {*_from_outside(symtable.symtable(text, "<shared>", "exec"))}
    nodes = (node for node in ast.walk(ast.parse(text)) if isinstance(node, ast.Name))
    names = dict.fromkeys(node.id for node in nodes)
    return [name for name in names if name in outside and not name.startswith("__")]  # each module has its __name__


def _from_outside(table: symtable.SymbolTable) -> Iterator[str]:
    """The names that no scope of the code has as its own, and the name of the class or function itself."""
    is_whole = table.get_type() == "module"
    for symbol in table.get_symbols():
        if is_whole or symbol.is_global():
            yield symbol.get_name()
    for inside in table.get_children():
        yield from _from_outside(inside)


def _meaning(name: str, user: Any) -> Any:
    """The value of a name where a class or function was defined; `_NOTHING` if it has none there."""
    for function in _functions(user):
        if name in function.__globals__:
            return function.__globals__[name]
    module = sys.modules.get(user.__module__)
    return getattr(module, name, _NOTHING)


def _functions(value: Any) -> Iterator[FunctionType]:
    """A function, or those of a class that were written in it (and not made by `NamedTuple`)."""
    if isinstance(value, FunctionType):
        yield value
        return
    yield from filter(None, (_written(member, value) for member in vars(value).values()))


def _written(member: Any, kind: Any) -> FunctionType | None:
    """The function behind a member of a class (a method, a property), if the student wrote it."""
    inside = getattr(member, "fget", None) or getattr(member, "__func__", None) or member
    return inside if isinstance(inside, FunctionType) and inside.__module__ == kind.__module__ else None


def _check_whole(value: type | FunctionType, text: str) -> None:
    """Refuse a class of which a method was replaced, as by `Walk.reward = other`: its text has the old one.

    Raises:
        ValueError: there is such a method.
    """
    for name, member in vars(value).items() if isinstance(value, type) else ():
        function = _written(member, value)
        if function and "." not in function.__qualname__ and not re.search(rf"\b{name}\s*[:=]", text):
            raise ValueError(
                f"{value.__name__}.{name} was replaced outside the class: write it in the class to share it"
            )


def source_of(value: Any) -> str:
    """The source of a class or function, also of one that was written in a notebook.

    Raises:
        ValueError: it has none.
    """
    try:
        if isinstance(value, FunctionType):
            return textwrap.dedent(inspect.getsource(value)).rstrip()
        return _class_source(value)
    except (OSError, TypeError, SyntaxError) as error:
        raise ValueError(f"{value.__name__} must be written in a cell or a file to be shared: {error}") from None


def _class_source(kind: type) -> str:
    """The source of a class: the lines, in the file of its methods, of the class that has them."""
    functions = (one for one in _functions(kind) if one.__qualname__.startswith(f"{kind.__qualname__}."))
    codes = [function.__code__ for function in functions]  # and not one from elsewhere, as of `reward = other`
    for file in [codes[0].co_filename] if codes else _cells():
        lines = linecache.getlines(file)
        for node in reversed([*ast.walk(ast.parse("".join(lines)))]):  # of two of one name Python keeps the last
            if isinstance(node, ast.ClassDef) and node.name == kind.__name__:
                first, last = min([node.lineno, *(one.lineno for one in node.decorator_list)]), node.end_lineno
                if first <= codes[0].co_firstlineno <= (last or first) if codes else _has_fields(node, kind):
                    return textwrap.dedent("".join(lines[first - 1 : last])).rstrip()
    raise OSError("no source was found")


def _has_fields(node: ast.ClassDef, kind: type) -> bool:
    """Whether the lines of a class without methods declare the fields that it has.

    An older cell may have been run again, so that the last cell with the name is not the one that counts.
    """
    declared = [line.target for line in node.body if isinstance(line, ast.AnnAssign)]
    names = [target.id for target in declared if isinstance(target, ast.Name)]
    return names == [*vars(kind).get("_fields", vars(kind).get("__annotations__", ()))]


def _cells() -> Iterator[str]:
    """The files of a notebook's cells, the last one that was run first."""
    for file, entry in reversed([*linecache.cache.items()]):
        if len(entry) > 2 and ("ipykernel" in file or file.startswith("<")):
            with contextlib.suppress(SyntaxError):  # lines with % are no Python
                ast.parse("".join(entry[2]))
                yield file
