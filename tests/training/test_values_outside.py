"""Arrays and numbers outside the agent that change while it learns: machine code, which reads them once, gives way."""

import re
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
    "a view of it": TABLE + FORGETFUL + "    def learn" + LEARNS + "V = Q[:]",
    "no field": TABLE + LEARNER.replace("self.Q", "Q").replace("Q: np.ndarray\n", "n: int = 0\n"),
    "a variable of a function": "def make(Q):\n" + indent(f"{FORGETFUL}    def learn{LEARNS}return Learner", "    "),
    "a module's": "import store\nQ = store.Q\n" + LEARNER.replace("self.Q[state", "store.Q[state", 1),
    "a number": EPSILON,
    "a number of the class": LEARNER.replace("rate: float", "eps = 0.9\n    rate: float")
    .replace("< 0.1", "< self.eps")
    .replace("        value =", "        Learner.eps *= 0.999\n        value ="),
}


def trained(source: str) -> tuple[Any, ...]:
    """Train the agent, and give its table, its curve and what was left of the notebook's variables."""
    notebook = cell(source)
    table = notebook.get("Q", np.zeros((6, 2)))
    kind = notebook["make"](table) if "make" in notebook else notebook["Learner"]
    agent = kind() if "n" in kind._fields else kind(notebook.get("V", table))
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
    why = r"(the array (store\.)?Q is a field as well|(store\.Q|Q|epsilon|Learner\.eps) changes during the run)"
    with pytest.warns(UserWarning, match=f"Learner .*interpreted.*{why}") as said:
        compiled = trained(OUTSIDE[name])
    assert sum("interpreted" in str(one.message) for one in said) == 1
    assert build.call_count <= 2
    interpret(monkeypatch)
    store.Q = np.zeros((6, 2))
    assert trained(OUTSIDE[name]) == compiled


@pytest.mark.parametrize(
    "reads", ["store.PAY", *(pytest.param(one, marks=pytest.mark.slow) for one in ("PAY[0]", "store.PAY[0]"))]
)
def test_copies_read_a_value_that_changes(reads: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """It counts from the next step on, in a notebook and in a module; after some changes the copies give up."""
    store: Any = ModuleType("store")
    monkeypatch.setitem(sys.modules, "store", store)
    store.PAY = np.zeros(1) if "[" in reads else 0.0
    notebook = cell("import store\nPAY = store.PAY\n" + WALK.replace("else -0.25", f"else {reads}"))
    vector = MDPVectorEnv(MDPEnv(notebook["Walk"](50)), 2)
    vector.reset(seed=0)
    paid = []

    def step(pay: float) -> None:
        if "[" in reads:
            store.PAY[0] = pay
        else:
            store.PAY = pay
        paid.append(vector.step([1, 1])[1][0])

    for k in range(4):
        step(k)
    assert vector.is_compiled
    with pytest.warns(UserWarning, match=f"Walk .*interpreted.* {re.escape(reads.partition('[')[0])} changes"):
        step(4)
    step(5)
    assert not vector.is_compiled
    assert paid == [0, 1, 2, 3, 4, 5]
