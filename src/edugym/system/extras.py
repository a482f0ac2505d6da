"""Libraries that only parts of the package need, and how to get them."""

from importlib.util import find_spec

from gymnasium.error import DependencyNotInstalled

SOURCE = "git+https://github.com/RLG-Leiden/edugym"
"""Where pip installs the package from, which is not on PyPI yet."""


def requirement(extra: str) -> str:
    """What pip is asked for to install the package with an extra."""
    return f"edugym[{extra}] @ {SOURCE}"


def install(extra: str) -> str:
    """The command that installs the package with an extra, from the repository and from a checkout."""
    return f'`pip install "{requirement(extra)}"` (in a checkout of EduGym: `pip install ".[{extra}]"`)'


def require(extra: str, *libraries: str) -> None:
    """Refuse to go on where a library is missing that an extra of this package brings.

    Args:
        extra: the extra, as `pyproject.toml` names it.
        *libraries: the names by which they are imported; they are looked for, not imported.

    Raises:
        gymnasium.error.DependencyNotInstalled: one is not installed.
    """
    for library in libraries:
        if find_spec(library) is None:
            raise DependencyNotInstalled(f"{library} is not installed, run {install(extra)}")
