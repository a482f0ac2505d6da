"""Casino: episodes on paper, its payoffs, the exact optimum, and what a learner makes of the noise."""

from math import inf, nan
from typing import Any

import numpy as np
import pytest
from hypothesis import strategies as st

from edugym import QLearning, finite_model, make_environment, make_mdp, mean_interval, value_iteration
from edugym.envs.casino import CASINO, HOME, IN, STREET
from edugym.exact.branching import branches
from tests.contract.described import NO_WHOLE_NUMBER, Parameters, refused

NO_PAYOFF = (-0.1, 1e6 + 1, inf, nan, "1", None, True)
PARAMETERS = Parameters(
    valid=st.fixed_dictionaries(
        {"n_machines": st.integers(1, 6)},
        optional={"noise": st.floats(0, 10), "loss": st.floats(0, 10), "advantage": st.floats(0, 10)},
    ),
    corners=(
        {},
        {"n_machines": 1, "noise": 0},
        {"n_machines": 1000, "noise": 1e6, "loss": 1e6},
        {"n_machines": 3, "loss": 0, "advantage": 1e6},
    ),
    bad=(
        *refused("n_machines", 0, -1, 1001, 10**400, *NO_WHOLE_NUMBER),
        *(bad for name in ("noise", "loss", "advantage") for bad in refused(name, *NO_PAYOFF)),
    ),
    finite=({}, {"n_machines": 1}, {"n_machines": 3, "noise": 0.25, "advantage": 0.5}),
)


def test_episodes() -> None:
    """Home at once, and by the casino; every payoff is one of two."""
    env = make_environment("Casino", noise=0.5, loss=0.25)
    assert env.reset(seed=0) == (STREET, {"machine": -1})
    assert env.step(3) == (HOME, 0.0, True, False, {"machine": -1})
    payoffs = []
    for _ in range(40):
        env.reset()
        assert env.step(IN)[:4] == (CASINO, 0.0, False, False)
        state, payoff, *ends, info = env.step(9)
        assert (state, ends, info) == (HOME, [True, False], {"machine": 9})
        payoffs.append(payoff)
    assert set(payoffs) == {0.25, -0.75}


@pytest.mark.parametrize(
    ("parameters", "action", "payoffs"),
    [
        ({}, 0, {-1.1: 0.5, 0.9: 0.5}),
        ({"noise": 2, "advantage": 0.5}, 9, {-1.6: 0.5, 2.4: 0.5}),
        ({"noise": 2, "advantage": 0.5}, 8, {-2.1: 0.5, 1.9: 0.5}),
        ({"n_machines": 1, "advantage": 0.5}, 0, {-0.6: 0.5, 1.4: 0.5}),
        ({"n_machines": 1, "advantage": 0.5}, 1, {-2.1: 1.0}),
        ({"noise": 0, "loss": 3}, 4, {-3.0: 1.0}),
    ],
)
def test_payoffs(parameters: dict[str, Any], action: int, payoffs: dict[float, float]) -> None:
    """Their probabilities, worked out by hand."""
    mdp = make_mdp("Casino", **parameters)
    found: dict[float, float] = {}
    for p, payoff in branches(lambda rng: mdp.reward(CASINO, action, HOME, rng)):
        found[round(payoff, 12)] = found.get(round(payoff, 12), 0.0) + p
    assert found == payoffs
    assert sorted(mdp.payoffs[action]) == pytest.approx(sorted([*payoffs] * (3 - len(payoffs))))


@pytest.mark.parametrize("n_machines", [1, 2, 10])
@pytest.mark.parametrize("advantage", [0.0, 0.05, 0.3])
def test_the_exact_optimum(n_machines: int, advantage: float) -> None:
    """Of three states: go home, unless the last machine pays; noise changes nothing."""
    mdp = make_mdp("Casino", n_machines=n_machines, advantage=advantage)
    model = finite_model(mdp)
    assert model.states == (STREET, CASINO, HOME)
    values = value_iteration(model, 0.9)
    assert values.start == pytest.approx(0.9 * max(0, advantage - 0.1))
    assert values.Q[STREET, IN] == pytest.approx(0.9 * (advantage - 0.1))
    assert mdp.reward_threshold == pytest.approx(max(0, advantage - 0.1))
    for noise in (0.0, 7.0):
        other = make_mdp("Casino", n_machines=n_machines, advantage=advantage, noise=noise)
        assert value_iteration(finite_model(other), 0.9).Q[STREET] == pytest.approx(values.Q[STREET])


def test_a_learner_goes_in_where_payoffs_are_noisy() -> None:
    """In most of episodes 31 to 100; without noise in few: then an estimate below 0 is true, and stays."""

    def visits(**parameters: Any) -> Any:
        shares = []
        for seed in range(20):
            mdp, rng = make_mdp("Casino", **parameters), np.random.default_rng(seed)
            agent = QLearning.create(mdp, discount=1.0)
            went_in = []
            for _ in range(100):
                state = STREET
                while state != HOME:
                    action = agent.act(state, rng)
                    following = mdp.transition(state, action, rng)
                    payoff = mdp.reward(state, action, following, rng)
                    agent.learn(state, action, payoff, following, terminated=following == HOME)
                    state, last = following, state
                went_in.append(last == CASINO)
            shares.append(float(np.mean(went_in[30:])))
        return mean_interval(shares)

    assert visits().low > 0.5
    assert visits(noise=0.0).high < 0.2
