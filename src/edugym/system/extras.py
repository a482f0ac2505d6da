"""Libraries that only parts of the package need, and how to get them."""

from importlib.util import find_spec

from gymnasium.error import DependencyNotInstalled


def require(extra: str, *libraries: str) -> None:
    """Refuse to go on where a library is missing that an extra of this package brings.

    Args:
        extra: the extra, as in `pip install "edugym[extra]"`.
        *libraries: the names by which they are imported; they are looked for, not imported.

    Raises:
        gymnasium.error.DependencyNotInstalled: one is not installed.
    """
    for library in libraries:
        if find_spec(library) is None:
            raise DependencyNotInstalled(f'{library} is not installed, run `pip install "edugym[{extra}]"`')
