"""What is written on the command line: parameters of environments, and agents with their wrappers."""

import ast
import inspect
import re
from difflib import get_close_matches
from functools import partial
from itertools import product
from pathlib import Path
from typing import Any

import edugym
from edugym.agents.settings import check, settings_of
from edugym.experiments.players import is_policy
from edugym.experiments.profiles.verdicts import listed
from edugym.system.own_files import run_file
from edugym.system.packages import is_ours
from edugym_course.agent_profiles import agents as package_agents
from edugym_course.agent_profiles import kind_of, library_agents

HELP = (
    'Agents of the package (QLearning), of Stable-Baselines3 ("SB3 PPO"), or of a file (my_agent.py:MyAgent; it is run,'
    ' so open only files of people whom you trust), with wrappers if you like ("QLearning + FrameStack(4)").'
)


def path_of(text: str) -> Path:
    """The path that is written in an option; an empty one would silently mean the current folder."""
    import typer

    if not text:
        raise typer.BadParameter("the path is empty; the current folder is written '.'")
    return Path(text)


def parameters(texts: list[str]) -> dict[str, Any]:
    """Read parameters that are written NAME=VALUE.

    Raises:
        ValueError: one is not written so, or is given twice.
    """
    return {name: value(text) for name, text in _pairs(texts).items()}


def _pairs(texts: list[str]) -> dict[str, str]:
    read: dict[str, str] = {}
    for text in texts:
        name, equals, written = text.partition("=")
        if not equals or not name.isidentifier():
            raise ValueError(f"a parameter is written name=value, but not {text!r}")
        if name in read:
            raise ValueError(f"parameter {name} must be set once, but is set twice")
        read[name] = written
    return read


def value(text: str) -> Any:
    """Read a value: a Python literal, a number such as inf, or else the text itself."""
    for read in (ast.literal_eval, float):
        try:
            return read(text)
        except (TypeError, ValueError, SyntaxError):
            continue
    return text


def agents(texts: list[str]) -> dict[str, Any]:
    """Read agents, as `edugym.profile` takes them, by their labels: what is written, without the name of a file.

    Raises:
        ValueError: one is written wrong, is not there, or is given twice.
        OSError: a file cannot be read.
    """
    read: dict[str, Any] = {}
    for text in texts:
        base, *wrappers = (part.strip() for part in re.split(r"\+(?![^(]*\))", text))
        label = " + ".join([base.rpartition(":")[2], *wrappers])
        if label in read:
            raise ValueError(f"each agent must be given once, but {label} is given twice")
        made = _of_file(base) if ":" in base else _of_package(base)
        read[label] = (made, partial(_wrapped, [_wrapper(written) for written in wrappers])) if wrappers else made
    return read


def grids(agents: dict[str, Any], texts: list[str]) -> dict[str, dict[str, Any]]:
    """What agents may choose from, as `edugym.tuned_profile` takes it: themselves, and themselves with settings.

    Args:
        agents: as `agents` reads them.
        texts: settings with their values, such as "learning_rate=0.05,0.5". An agent takes all combinations of those
            that it has; who has none of them is left out.

    Raises:
        ValueError: one is not written so, no agent has such a setting, or one of the package does not take the value.
    """
    read = {name: _values(name, text) for name, text in _pairs(texts).items()}
    made: dict[str, dict[str, Any]] = {}
    missing = {*read}
    for label, agent in agents.items():
        make, *wrap = agent if type(agent) is tuple else (agent,)  # an agent may be a NamedTuple
        own = [name for name in read if _has_setting(make, name)]
        if not own:
            continue
        missing -= {*own}
        for name in own:
            for value in read[name].values():
                _require_allowed(make, name, value)
        made[label] = {"as given": agent}
        for texts_of in product(*(read[name] for name in own)):
            chosen = partial(make, **{name: read[name][text] for name, text in zip(own, texts_of, strict=True)})
            setting = ", ".join(f"{name}={text}" for name, text in zip(own, texts_of, strict=True))
            made[label][setting] = (chosen, *wrap) if wrap else chosen
    if missing:
        raise ValueError(f"a setting to tune must be one of an agent, but {', '.join(agents)} has no {min(missing)}")
    return made


def _values(name: str, text: str) -> dict[str, Any]:
    """Values with commas between them, by how they are written: Python's, or a strategy such as EpsilonGreedy(0.1)."""
    try:
        parts: Any = ast.parse(f"[{text}]", mode="eval").body
        read = {ast.unparse(part): _setting(part) for part in parts.elts}
    except (AttributeError, SyntaxError, TypeError, ValueError):  # no list, or a strategy without what it needs
        read = {}
    if not read:
        raise ValueError(f"{name} must be values such as 0.05,0.5 or EpsilonGreedy(0.2), but is {text!r}")
    return read


def _setting(part: Any) -> Any:
    kind: Any = getattr(edugym, ast.unparse(part.func), None) if isinstance(part, ast.Call) else None
    return kind(*map(ast.literal_eval, part.args)) if hasattr(kind, "choose") else ast.literal_eval(part)


def _has_setting(make: Any, name: str) -> bool:
    """Whether what makes an agent takes a setting of this name."""
    if name in getattr(kind_of(make), "_fields", ()):
        return True
    try:
        return name in [*inspect.signature(make).parameters][1:]  # after the environment
    except (TypeError, ValueError):
        return False  # a policy, which nothing makes


def _require_allowed(make: Any, name: str, value: Any) -> None:
    """Check a setting of an agent of the package, before minutes of training come to it."""
    kind = kind_of(make)
    is_a_class_of_ours = isinstance(kind, type) and is_ours(kind)
    if is_a_class_of_ours and name in settings_of(kind) and hasattr(kind, name):
        check(kind.create((2, 2))._replace(**{name: value}))


def _of_package(name: str) -> Any:
    """The function that makes an agent of the package, or of a library."""
    known = package_agents() | library_agents()
    if name in known:
        return known[name]
    if name.endswith(".py"):
        raise ValueError(f"an agent of a file is written {name}:NAME, with its class or function, but is {name}")
    by_letters = {re.sub(r"[\W_]", "", one).lower(): one for one in known}
    alike = get_close_matches(re.sub(r"[\W_]", "", name).lower(), by_letters, n=1)
    raise ValueError(
        f"an agent must be one of {', '.join(known)}, or be written FILE.py:NAME, but is {name or 'missing'}"
        + (f": did you mean {by_letters[alike[0]]}?" if alike else "")
    )


def _of_file(text: str) -> Any:
    """What makes an agent, from a file: a class, a function of an environment, or a policy."""
    file, _, name = text.rpartition(":")
    path = Path(file)
    module = run_file(path, importable=True)
    found = getattr(module, name, None)
    if found is None:
        names = [one for one in vars(module) if not one.startswith("_")]
        raise ValueError(f"{path.name} has no {name!r}; it has {', '.join(names) or 'nothing'}")
    if inspect.isclass(found):
        create = getattr(found, "create", None)
        fields = [*getattr(found, "_fields", getattr(found, "__dataclass_fields__", ()))]
        if create is None and fields and fields[0] not in ("environment", "env"):
            raise ValueError(
                f"{name} of {path.name} must be made for each environment, so its {listed(fields)} must fit: write a"
                f" function `def make(environment): return {name}(...)`, and give {path.name}:make"
            )
        return create or partial(found)
    if callable(found) or hasattr(found, "act") or is_policy(found):
        return found
    raise ValueError(f"{name} of {path.name} must be an agent, or make one, but is {found!r}")


def _wrapper(text: str) -> partial[Any]:
    """What wraps an MDP, from a text such as FrameStack(4)."""
    known = [one for one in dir(edugym) if "mdp" in getattr(getattr(edugym, one), "_fields", ())]
    name, bracket, _ = text.partition("(")
    try:
        call: Any = ast.parse(text, mode="eval").body
        given = [ast.literal_eval(argument) for argument in call.args]
        named = {str(keyword.arg): ast.literal_eval(keyword.value) for keyword in call.keywords}
    except (AttributeError, SyntaxError, ValueError):  # what is written is no call, or not with plain values
        bracket = ""
    if not bracket or name not in known:
        raise ValueError(
            f"a wrapper must be one of {', '.join(known)} with its values, such as FrameStack(4), but is {text!r}"
        )
    return partial(_wrap, getattr(edugym, name), given, named)


def _wrap(kind: Any, given: list[Any], named: dict[str, Any], mdp: Any) -> Any:
    return kind.create(mdp, *given, **named)


def _wrapped(wrappers: list[partial[Any]], mdp: Any) -> Any:
    """The MDP in all wrappers, the first one innermost."""
    for wrap in wrappers:
        mdp = wrap(mdp)
    return mdp
