"""The exact model and `step` are one truth, and what is not finite has no model."""

from operator import attrgetter
from typing import Any

import numpy as np
import pytest

from edugym.adapters.registration import ENVIRONMENTS, Entry
from edugym.exact.model import finite_model
from edugym.exact.tables import FiniteModel, Outcome
from tests.contract.parameters import PARAMETERS
from tests.contract.play import every_environment, plain
from tests.messages import named

SAMPLES = 400
"""How often each state and action is tried, where there is chance."""
SIGMAS = 6
"""How many standard deviations a frequency may be off: among a million of them none is, by chance."""


@every_environment
def test_tables(entry: Entry) -> None:
    """Probabilities are probabilities, a terminal state leads to itself and pays nothing, and all can be reached."""
    for keywords in PARAMETERS[entry.name].finite:
        mdp = entry.load()(**keywords).mdp
        model = finite_model(mdp)
        n_states, n_actions, width = model.successors.shape
        assert (n_states, n_actions) == (len(model.states), mdp.action_space.n)
        assert model.probabilities.shape == model.rewards.shape == (n_states, n_actions, width)
        assert (model.probabilities >= 0).all()
        for whole in (model.probabilities, model.p, model.initial):
            np.testing.assert_allclose(whole.sum(axis=-1), 1, rtol=0, atol=1e-12)
        assert [bool(mdp.terminal(state)) for state in model.states] == model.terminal.tolist()
        assert model.initial[model.terminal].sum() == 0
        ends = np.flatnonzero(model.terminal)
        assert (len(ends) == 0) == PARAMETERS[entry.name].endless
        assert (model.p[ends, :, ends] == 1).all()
        assert (model.r[ends] == 0).all()
        assert all(model.row(state) == s for s, state in enumerate(model.states))
        assert (model.p[~model.terminal].sum(axis=(0, 1)) + model.initial > 0).all()


@every_environment
def test_steps_follow_the_model(entry: Entry) -> None:
    """From every state, every action has the outcomes of the model, as often as it says; without chance, exactly."""
    for keywords in PARAMETERS[entry.name].finite:
        env = entry.load()(**keywords)
        model: FiniteModel = env.finite_model
        env.reset(seed=1)
        for s in np.flatnonzero(~model.terminal).tolist():
            for action in range(env.action_space.n):
                outcomes = env.descriptive_model(model.states[s], action)
                steps = []
                for _ in range(SAMPLES if len(outcomes) > 1 else 20):
                    env.reset()
                    env.state = model.states[s]
                    _, reward, terminated, _, _ = env.step(action)
                    steps.append((env.state, reward, terminated))
                compare(outcomes, steps)
        starts = np.zeros(len(model.states))
        for _ in range(SAMPLES):
            env.reset()
            starts[model.row(env.state)] += 1
        p = model.initial
        assert (np.abs(starts - SAMPLES * p) <= SIGMAS * np.sqrt(SAMPLES * p * (1 - p))).all()


def compare(outcomes: list[Outcome], steps: list[tuple[Any, float, bool]]) -> None:
    """Compare steps with the model of them."""
    known = {outcome.next_state: outcome for outcome in outcomes}
    assert len(known) == len(outcomes)
    assert {state for state, _, _ in steps} <= set(known)
    for state, outcome in known.items():
        rewards = np.array([reward for next_state, reward, _ in steps if next_state == state])
        assert all(ends == outcome.terminated for next_state, _, ends in steps if next_state == state)
        n, p = len(steps), outcome.probability
        assert abs(len(rewards) - n * p) <= SIGMAS * np.sqrt(n * p * (1 - p))
        if len(rewards) > 1:
            assert abs(rewards.mean() - outcome.reward) <= SIGMAS * rewards.std(ddof=1) / np.sqrt(len(rewards)) + 1e-12


@every_environment
def test_ways_to_ask(entry: Entry) -> None:
    """`model` is a short form of the descriptive and the generative model, which draw nothing from the environment."""
    for keywords in PARAMETERS[entry.name].finite:
        env = entry.load()(**keywords)
        env.reset(seed=0)
        before = plain(env.np_random)
        for state in env.finite_model.states[:50]:
            for action in range(env.action_space.n):
                outcomes = env.descriptive_model(state, action)
                assert env.model(state, action) == env.model(state, action, kind="descriptive") == outcomes
                assert sum(outcome.probability for outcome in outcomes) == pytest.approx(1, abs=1e-12)
                for drawn in (env.generative_model(state, action), env.model(state, action, "generative")):
                    assert drawn.probability == 1
                    assert drawn._replace(probability=0) in [outcome._replace(probability=0) for outcome in outcomes]
        assert plain(env.np_random) == before
        for ask in (env.model, env.descriptive_model, env.generative_model):
            for wrong in (-1, env.action_space.n, 0.5, None):
                with pytest.raises(ValueError, match="is not in the action space"):
                    ask(env.state, wrong)
            for wrong in ("nowhere", None, (), (10**9, 1, 2, 3)):
                with pytest.raises(ValueError, match=named("state", repr(wrong))):
                    ask(wrong, 0)
        with pytest.raises(ValueError, match=named("kind", "'descriptive'", "'generative'", "'exact'")):
            env.model(env.state, 0, kind="exact")


@pytest.mark.parametrize("entry", [e for e in ENVIRONMENTS if not PARAMETERS[e.name].finite], ids=attrgetter("name"))
def test_no_model(entry: Entry) -> None:
    """Tasks that are not in the table as finite say that they are not, and why; no other error gets through."""
    task = entry.load()().mdp
    with pytest.raises(ValueError, match=f"{type(task).__name__} has no finite model: "):
        finite_model(task, max_states=100)
