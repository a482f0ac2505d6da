"""What the textbook says is a special case of another method is it: the same updates on the same steps."""

from typing import Any

import numpy as np
import pytest

import edugym as e
from edugym.checks.contract import is_on_policy, learner

SHAPE = (5, 2)
ONE_HOT = e.Identity.create(SHAPE, constant=0.0)  # features that are a table: a 1 in the place of each state
SPECIAL: list[tuple[Any, dict[str, Any], Any]] = [
    (e.CountBased, {"bonus": 0}, e.QLearning),
    (e.DynaQ, {"planning_steps": 0}, e.QLearning),
    (e.ExpectedSARSA, {"exploration": e.Greedy()}, e.QLearning),
    (e.TreeBackup, {"n": 1}, e.QLearning),
    (e.TreeBackup, {"n": 1, "target_policy": e.EpsilonGreedy(0.1)}, e.ExpectedSARSA),
    (e.RiskSensitiveQLearning, {"risk": 0}, e.QLearning),
    (e.NStepSARSA, {"n": 1}, e.SARSA),
    (e.LinearQLearning, {"features": ONE_HOT}, e.QLearning),
    (e.SemiGradientSARSA, {"features": ONE_HOT}, e.SARSA),
    *((e.QLambda, {"trace_decay": 0, "traces": z}, e.QLearning) for z in (e.Accumulating(), e.Replacing(), e.Dutch())),
    *((e.SARSALambda, {"trace_decay": 0, "traces": z}, e.SARSA) for z in (e.Accumulating(), e.Replacing(), e.Dutch())),
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
