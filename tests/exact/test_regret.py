"""Regret and its bound: by hand, and against simulation."""

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from edugym import action_gaps, finite_model, lai_robbins, make_environment, make_mdp, regret
from tests.messages import named


def model(**parameters: Any) -> Any:
    """The exact model of a bandit."""
    return finite_model(make_mdp("Bandit", **parameters))


def test_gaps() -> None:
    """0 for the best arm, the gap for all others; with drift, a row for each best arm."""
    best = make_mdp("Bandit", n_arms=4).first_best
    assert action_gaps(model(n_arms=4, gap=0.3))[0] == pytest.approx([0.0 if a == best else 0.3 for a in range(4)])
    assert action_gaps(model(n_arms=3, gap=0.3, drift=0.1)) == pytest.approx(0.3 - 0.3 * np.eye(3))


def test_regret_by_hand() -> None:
    """Only pulls of a worse arm cost something, whatever they paid."""
    mdp = make_mdp("Bandit", n_arms=3, gap=0.25)
    best = mdp.first_best
    worse = (best + 1) % 3
    assert regret(finite_model(mdp), [best, worse, worse, best]).tolist() == [0, 0.25, 0.5, 0.5]
    assert regret(finite_model(mdp), np.array([worse])).tolist() == [0.25]
    assert regret(finite_model(mdp), []).tolist() == []
    drifting = model(n_arms=3, gap=0.25, drift=0.5)
    assert regret(drifting, [0, 0, 1], [0, 1, 1]).tolist() == [0, 0.25, 0.25]


@pytest.mark.parametrize(("drift", "seed"), [(0.0, 0), (0.3, 7)])
def test_regret_is_what_the_environment_says(drift: float, seed: int) -> None:
    """Step by step, and on average it is what is missing to the best arm's rewards."""
    env = make_environment("Bandit", n_arms=4, gap=0.5, drift=drift, max_steps=4000)
    env.reset(seed=seed)
    rng, actions, states, told, rewards = np.random.default_rng(seed), [], [], [], []
    for _ in range(4000):
        states.append(env.state)
        actions.append(int(rng.integers(4)))
        _, reward, _, _, info = env.step(actions[-1])
        told.append(info["regret"])
        rewards.append(reward)
    exact = regret(env.finite_model, actions, None if drift == 0 else states)
    assert exact == pytest.approx(np.cumsum(told))
    missing = 4000 * 0.75 - np.sum(rewards)
    assert abs(missing - exact[-1]) < 4 * math.sqrt(4000 * 0.1875)


@pytest.mark.parametrize(
    ("probabilities", "constant"),
    [
        ([0.5, 0.5], 0.0),  # nothing to lose
        ([1.0, 0.3], 0.0),  # a single 0 gives the worse arm away
        ([0.5, 0.0], 0.5 / math.log(2)),  # KL(0, 1/2) = ln 2
        ([0.75, 0.25], 0.5 / (0.5 * math.log(3))),  # KL = 1/4 ln 1/3 + 3/4 ln 3
        ([0.25, 0.75, 0.5], 0.5 / (0.5 * math.log(3)) + 0.25 / (0.5 * math.log(4 / 3))),  # KL(1/2, 3/4) = ln(4/3)/2
        ([0.3, 0.1 + 0.2], 0.0),  # equal but for rounding
        ([0.5, 0.5 - 2.0**-24], 2.0**23),  # KL = 2 gap², where the logarithms of its definition cancel
        ([0.6, *[0.4] * 9], 9 * 0.2 / (0.2 * math.log(1.5))),  # the default task: KL(0.4, 0.6) = 0.2 ln 1.5
    ],
)
def test_the_bound_by_hand(probabilities: list[float], constant: float) -> None:
    """To 1e-12."""
    assert lai_robbins(probabilities) == pytest.approx(constant, rel=1e-12)


@given(st.lists(st.floats(0, 1), min_size=1, max_size=6))
def test_the_bound_against_pinsker(probabilities: list[float]) -> None:
    """KL(p, q) is 2 (q - p)² or more, so that an arm counts at most 1/(2 gap); the order of the arms says nothing."""
    gaps = [max(probabilities) - p for p in probabilities]
    found = lai_robbins(probabilities)
    assert 0 <= found <= sum(0.5 / gap for gap in gaps if gap > 0) * (1 + 1e-6)
    assert lai_robbins(probabilities[::-1]) == pytest.approx(found, rel=1e-9)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: regret(model(n_arms=3), [0, 3]), ("actions", "from 0 to 2", "[0, 3]")),
        (lambda: regret(model(n_arms=3), np.array(1)), ("actions", "list", "array(1)")),
        (lambda: regret(model(n_arms=3, drift=0.1), [0]), ("states", "3")),
        (lambda: regret(model(n_arms=3, drift=0.1), [0, 1], [0]), ("states", "2", "[0]")),
        (lambda: regret(model(n_arms=3, drift=0.1), [0], [5]), ("states", "1", "[5]")),
        (lambda: action_gaps(finite_model(make_mdp("Boulder", height=3))), ("model", "bandit", "0")),
        (lambda: action_gaps(make_mdp("Bandit")), ("model", "finite_model", "Bandit")),
        (lambda: lai_robbins([]), ("probabilities", "from 0 to 1", "[]")),
        (lambda: lai_robbins([0.5, 1.5]), ("probabilities", "from 0 to 1", "1.5")),
    ],
)
def test_mistakes(call: Any, words: tuple[str, ...]) -> None:
    """Each is answered by its name, and by what is allowed."""
    with pytest.raises(ValueError, match=named(*words)):
        call()
