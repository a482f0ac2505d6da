"""What the textbook says is a special case of another method is it: the same updates on the same steps."""

from typing import Any

import numpy as np
import pytest

import edugym as eg
from edugym.checks.contract import is_on_policy, learner

SHAPE = (5, 2)
ONE_HOT = eg.Identity.create(SHAPE, constant=0.0)  # features that are a table: a 1 in the place of each state
TRACES = (eg.Accumulating(), eg.Replacing(), eg.Dutch())
SPECIAL: list[tuple[Any, dict[str, Any], Any]] = [
    (eg.CountBased, {"bonus": 0}, eg.QLearning),
    (eg.DynaQ, {"planning_steps": 0}, eg.QLearning),
    (eg.ExpectedSARSA, {"exploration": eg.Greedy()}, eg.QLearning),
    (eg.TreeBackup, {"n": 1}, eg.QLearning),
    (eg.TreeBackup, {"n": 1, "target_policy": eg.EpsilonGreedy(0.1)}, eg.ExpectedSARSA),
    (eg.RiskSensitiveQLearning, {"risk": 0}, eg.QLearning),
    (eg.MaxminQLearning, {"n_tables": 1}, eg.QLearning),
    (eg.NStepSARSA, {"n": 1}, eg.SARSA),
    (eg.LinearQLearning, {"features": ONE_HOT}, eg.QLearning),
    (eg.SemiGradientSARSA, {"features": ONE_HOT}, eg.SARSA),
    *((eg.QLambda, {"trace_decay": 0, "traces": traces}, eg.QLearning) for traces in TRACES),
]


@pytest.mark.parametrize(("special", "settings", "general"), SPECIAL)
def test_a_special_case(special: Any, settings: dict[str, Any], general: Any) -> None:
    """To rounding, on random steps, with ends and truncations."""
    one, other, rng = special.create(SHAPE, **settings), general.create(SHAPE), np.random.default_rng(0)
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
