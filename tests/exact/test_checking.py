"""Models that real steps contradict are refused, and correct ones are not."""

import math
import random
from typing import Any, cast

import numpy as np
import pytest

from edugym import FrameStack
from edugym.exact.checking import FALSE_ALARM, divergence, global_randomness
from edugym.exact.model import finite_model
from tests.compiled.cells import SLIPPERY, WALK, cell

START = "return 0\n"
MOVE = "return max(0, state + 2 * action - 1)"
PAY = "return 1.0 if next_state == self.size else -0.25"
GLOBALS = "import random\nheld = np.random.default_rng(0)\nkept = []\ncounter = [0]\n"


def slip(line: str, code: str) -> str:
    """The walk with one of its lines replaced by several."""
    assert line in WALK
    return GLOBALS + WALK.replace(line, code.replace("\n", "\n        "), 1)


CAUGHT = "try:\n    u = rng.random() % 0.5\nexcept TypeError:\n    u = 0.4\nreturn 0 if u < 0.25 else state + 1"
NOW_AND_THEN = "counter[0] += 1\nif counter[0] % 2:\n    return int(rng.random() < 0.5)\nreturn state"
OFTENER = "u = rng.random()\nreturn 0 if u < (0.9 if type(u) is float else 0.5) else state + 1"


@pytest.mark.parametrize(
    ("line", "code", "reason"),
    [
        (MOVE, "return min(4, state + 1) if type(rng.random()) is float else 0", "a real step leads to 1, which the"),
        (MOVE, "return 0 if str(rng.random())[2] < '5' else state + 1", "not use their value"),
        (MOVE, "return 0 if repr(rng.random())[2] < '5' else state + 1", "a real step leads to 0"),
        (MOVE, CAUGHT, "cannot follow what is done with a random number"),
        (MOVE, "kept.append(rng.random())\nreturn 0 if kept[0] < 0.5 else state + 1", "kept from an earlier call"),
        (MOVE, "return max(0, state + 2 * int(held.random() < 0.5) - 1)", "which the model does not know of"),
        (MOVE, NOW_AND_THEN, r"the probabilities of what can happen after action 0 in state 0 sum to 1\.5"),
        (MOVE, "return max(0, state + 2 * int(np.random.random() < 0.5) - 1)", "draw from np.random or random"),
        (MOVE, "return state + random.randint(-1, 1)", "draw from np.random or random: use the `rng`"),
        (MOVE, OFTENER, r"0 \d+ of \d+ real steps lead to 0, but the model says that its probability is 0\.5"),
        (PAY, "return 1.0 if type(rng.random()) is float else 2.0", r"a real step to 0 pays 1.0, .* says \[2.0\]"),
        (START, "return int(held.random() < 0.5)\n", "at the start a real step leads to"),
    ],
)
def test_a_silently_wrong_model_is_refused(line: str, code: str, reason: str) -> None:
    """Whatever hides from the branching shows in real steps."""
    with pytest.raises(ValueError, match=f"Walk has no finite model: .*{reason}"):
        finite_model(cell(slip(line, code))["Walk"](4))


def test_a_wrapper_of_the_package_hides_nothing() -> None:
    """Only what is the package's own throughout is not compared."""
    walk = cell(slip(MOVE, "return min(4, state + 1) if type(rng.random()) is float else 0"))["Walk"](4)
    with pytest.raises(ValueError, match=r"FrameStack has no finite model: .*a real step leads to"):
        finite_model(cast(Any, FrameStack.create(walk, 2)))


def test_correct_models_are_not_refused() -> None:
    """Rare outcomes and noise in rewards are no contradiction; `isinstance` answers as for a real number."""
    for slipping in (1e-6, 0.001, 0.3, 0.999):
        assert len(finite_model(cell(SLIPPERY)["SlipperyWalk"](30, slipping)).states) == 31
    noisy = slip(PAY, "return rng.normal(state, 5.0) + rng.random() * (rng.integers(3) - 1)")
    assert finite_model(cell(noisy)["Walk"](4)).outcomes(2, 1) == [(1.0, 3, 2.0, False)]
    code = "u = rng.random()\nassert isinstance(u, float) and not isinstance(u, int)\nreturn 0 if u < 0.5 else 3"
    outcomes = finite_model(cell(slip(MOVE, code))["Walk"](4)).outcomes(0, 0)
    assert outcomes == [(0.5, 0, -0.25, False), (0.5, 3, -0.25, False)]


def test_divergence_bounds_the_tail_of_the_binomial_distribution() -> None:
    """The chance of so many or more successes is at most exp(-n divergence), and not much less."""
    n = 40
    for p in (0.01, 0.3, 0.5, 0.9):
        chances = [math.comb(n, k) * p**k * (1 - p) ** (n - k) for k in range(n + 1)]
        for k in range(n + 1):
            tail = sum(chances[k:]) if k >= n * p else sum(chances[: k + 1])
            bound = math.exp(-n * divergence(k / n, p))
            assert tail <= bound * (1 + 1e-9)
            assert bound <= tail * 30
    assert divergence(0.5, 1.0) == divergence(0.5, 0.0) == math.inf
    assert divergence(1.0, 1.0) == divergence(0.0, 0.0) == 0.0
    assert FALSE_ALARM < 1e-9


def test_global_randomness() -> None:
    """Every draw changes it, and the check itself draws nothing."""
    before = global_randomness()
    finite_model(cell(SLIPPERY)["SlipperyWalk"](4, 0.5))
    assert global_randomness() == before
    random.random()
    between = global_randomness()
    assert between != before
    np.random.random()  # noqa: NPY002
    assert global_randomness() != between
