"""Arrays and numbers outside the agent that change while it learns: machine code, which reads them once, gives way."""

import sys
from textwrap import indent
from types import ModuleType
from typing import Any
from unittest.mock import Mock

import numpy as np
import pytest

from edugym import MDPEnv, MDPVectorEnv, train
from edugym.compiled import compiler
from tests.compiled.cells import LEARNER, SLIPPERY, WALK, cell
from tests.training.tasks import interpret

pytestmark = pytest.mark.usefixtures("compiled_at_once")

TABLE = "Q = np.zeros((6, 2))\n"
GREEDY = "    def greedy(self, state, rng):\n        return int(self.Q[state, 1] > self.Q[state, 0])\n"
ACTS, LEARNS = LEARNER.split("    def learn")
FORGETFUL = ACTS.replace("self.Q[state", "Q[state")
"""It looks actions up in the notebook's variable `Q`, where `self.Q` is meant."""
EPSILON = "epsilon = 1.0\n" + LEARNER.replace("< 0.1", "< epsilon").replace(
    "        value =", "        global epsilon\n        epsilon *= 0.999\n        value ="
)
OUTSIDE = {
    "self forgotten": TABLE + FORGETFUL + "    def learn" + LEARNS,
    "self forgotten in greedy": TABLE + LEARNER + GREEDY.replace("self.", ""),
    "no field": TABLE + LEARNER.replace("self.Q", "Q").replace("Q: np.ndarray\n", "n: int = 0\n"),
    "a variable of a function": "def make(Q):\n" + indent(f"{FORGETFUL}    def learn{LEARNS}return Learner", "    "),
    "a module's": "import store\nQ = store.Q\n" + LEARNER.replace("self.Q[state", "store.Q[state", 1),
    "a number": EPSILON,
}


def trained(source: str) -> tuple[Any, ...]:
    """Train the agent, and give its table, its curve and what was left of the notebook's variables."""
    notebook = cell(source)
    table = notebook.get("Q", np.zeros((6, 2)))
    kind = notebook["make"](table) if "make" in notebook else notebook["Learner"]
    agent = kind() if "n" in kind._fields else kind(table)
    run = train(cell(SLIPPERY)["SlipperyWalk"](5, 0.2), agent, 8_000, max_steps=40)
    return table.tolist(), run.returns.tolist(), notebook.get("epsilon")


FAST = ("self forgotten", "no field", "a module's", "a number")


@pytest.mark.parametrize("name", [pytest.param(one, marks=() if one in FAST else pytest.mark.slow) for one in OUTSIDE])
def test_the_same_as_in_the_interpreter(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """One sentence says why, and nothing is compiled again and again."""
    build = Mock(wraps=compiler._build)
    store: Any = ModuleType("store")
    monkeypatch.setitem(sys.modules, "store", store)
    monkeypatch.setattr(compiler, "_build", build)
    store.Q = np.zeros((6, 2))
    why = r"(the array (store\.)?Q is a field as well|(store\.Q|Q|epsilon) changes during the run)"
    with pytest.warns(UserWarning, match=f"Learner .*interpreted.*{why}") as said:
        compiled = trained(OUTSIDE[name])
    assert sum("interpreted" in str(one.message) for one in said) == 1
    assert build.call_count <= 2
    interpret(monkeypatch)
    store.Q = np.zeros((6, 2))
    assert trained(OUTSIDE[name]) == compiled


@pytest.mark.parametrize("is_array", [False, pytest.param(True, marks=pytest.mark.slow)])
def test_copies_read_a_value_that_changes(is_array: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """It counts from the next step on; after some changes the copies give up."""
    store: Any = ModuleType("store")
    monkeypatch.setitem(sys.modules, "store", store)
    store.PAY = np.zeros(1) if is_array else 0.0
    notebook = cell("import store\n" + WALK.replace("else -0.25", f"else store.PAY{'[0]' * is_array}"))
    vector = MDPVectorEnv(MDPEnv(notebook["Walk"](50)), 2)
    vector.reset(seed=0)

    def paid(pay: float) -> float:
        if is_array:
            store.PAY[0] = pay
        else:
            store.PAY = pay
        return float(vector.step([1, 1])[1][0])

    assert [paid(k) for k in range(4)] == [0, 1, 2, 3]
    assert vector.is_compiled
    with pytest.warns(UserWarning, match=r"Walk .*interpreted.* store\.PAY changes"):
        assert paid(4) == 4
    assert paid(5) == 5
    assert not vector.is_compiled
