"""What the textbook says is a special case of another method is it: the same updates on the same steps."""

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
import pytest

from edugym import (
    SARSA,
    Accumulating,
    CountBased,
    Dutch,
    DynaQ,
    EpsilonGreedy,
    ExpectedSARSA,
    Greedy,
    Identity,
    LinearQLearning,
    NStepSARSA,
    QLambda,
    QLearning,
    Replacing,
    RiskSensitiveQLearning,
    SARSALambda,
    SemiGradientSARSA,
    TreeBackup,
)
from edugym.checks.contract import is_on_policy, learner

SHAPE = (5, 2)
TRACES = (Accumulating(), Replacing(), Dutch())


def one_hot(kind: Any) -> Any:
    """An agent on features that are a table: a 1 in the place of each state, and no constant."""
    return kind.create(SHAPE, features=Identity.create(SHAPE, constant=0.0))


SPECIAL: dict[str, tuple[Callable[[], Any], Any]] = {
    "counting without a bonus": (lambda: CountBased.create(SHAPE, bonus=0), QLearning),
    "Dyna-Q without planning": (lambda: DynaQ.create(SHAPE, planning_steps=0), QLearning),
    "expected SARSA, greedy": (lambda: ExpectedSARSA.create(SHAPE, exploration=Greedy()), QLearning),
    "tree backup of one step": (lambda: TreeBackup.create(SHAPE, n=1), QLearning),
    "tree backup of one step, soft": (
        lambda: TreeBackup.create(SHAPE, n=1, target_policy=EpsilonGreedy(0.1)), ExpectedSARSA
    ),
    "neutral to risk": (lambda: RiskSensitiveQLearning.create(SHAPE, risk=0), QLearning),
    "n-step SARSA of one step": (lambda: NStepSARSA.create(SHAPE, n=1), SARSA),
    "Q-learning on a table of features": (lambda: one_hot(LinearQLearning), QLearning),
    "SARSA on a table of features": (lambda: one_hot(SemiGradientSARSA), SARSA),
    **{
        f"Q(0), {trace}": (partial(QLambda.create, SHAPE, trace_decay=0, traces=trace), QLearning) for trace in TRACES
    },
    **{
        f"SARSA(0), {trace}": (partial(SARSALambda.create, SHAPE, trace_decay=0, traces=trace), SARSA)
        for trace in TRACES
    },
}  # fmt: skip


@pytest.mark.parametrize(("special", "general"), SPECIAL.values(), ids=SPECIAL)
def test_a_special_case(special: Callable[[], Any], general: Any) -> None:
    """To rounding, on random steps, with ends and truncations."""
    one, other, rng = special(), general.create(SHAPE), np.random.default_rng(0)
    on_features = hasattr(one, "features")
    s, a = 0, 0
    for _ in range(500):
        n, b = int(rng.integers(5)), int(rng.integers(2))
        reward, terminated, truncated = float(rng.normal()), bool(rng.random() < 0.1), bool(rng.random() < 0.1)
        ends = terminated, truncated and not terminated
        seen, after = (np.eye(5)[s], np.eye(5)[n]) if on_features else (s, n)
        for agent, before, then in ((one, seen, after), (other, s, n)):
            more = (b,) if is_on_policy(agent) else ()
            learner(agent).learn(before, a, reward, then, *more, *ends)
        s, a = n, b
    table = one.weights[:-1] if on_features else one.Q
    assert pytest.approx(other.Q, rel=1e-9) == table
    assert other.Q.all()
