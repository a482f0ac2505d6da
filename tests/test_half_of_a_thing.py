"""What must have two methods is refused with one of them."""

from collections.abc import Callable
from functools import partial
from types import SimpleNamespace
from typing import Any

import pytest

from edugym.agents.features import check_features
from edugym.agents.strategies import check_policy
from edugym.training.train import check_stop

NEEDED: dict[str, tuple[Callable[[Any], None], tuple[str, str]]] = {
    "exploration": (partial(check_policy, "exploration"), ("probability", "expected_value")),
    "features": (partial(check_features, n_inputs=3), ("see", "n_features")),
    "stop": (check_stop, ("is_set", "set")),
}


@pytest.mark.parametrize("name", NEEDED)
def test_one_of_two_methods(name: str) -> None:
    """Whichever is missing, the message says what is wanted; with both there is none."""
    check, methods = NEEDED[name]
    check(SimpleNamespace(n_inputs=3, **dict.fromkeys(methods)))
    for method in methods:
        with pytest.raises(ValueError, match=f"{name} must be a"):
            check(SimpleNamespace(n_inputs=3, **{method: None}))
