"""The agents that plan with a model: what they update and in which order, by hand, and their fixed points."""

import itertools
import math
import time
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from edugym import DynaQ, EpsilonGreedy, PrioritisedSweeping, RMax, finite_model, make_mdp, train
from edugym.agents.heap import Heap
from edugym.agents.planning import Seconds, Updates, budget
from edugym.agents.settings import new
from tests.agents.walk import Walk, exact_values

RNG = np.random.default_rng(0)


def test_the_budget_of_planning(monkeypatch: pytest.MonkeyPatch) -> None:
    """So many updates, or half a second from when planning began, with a clock that is made up."""
    assert [budget(3, None).lasts(done, 0.0) for done in (0, 2, 3)] == [True, True, False]
    assert budget(math.inf, None) == Updates(math.inf)
    clock = iter([7.0, 7.0, 7.49, 7.5, 8.0])
    monkeypatch.setattr(time, "perf_counter", lambda: next(clock))
    planning = budget(3, 0.5)
    assert planning == Seconds(0.5)
    began = planning.start()
    assert [planning.lasts(99, began) for _ in range(4)] == [True, True, False, False]


def test_planning_for_some_time(monkeypatch: pytest.MonkeyPatch) -> None:
    """As long as it was told: the clock that is made up shows a millisecond more each time."""
    agent = DynaQ.create((2, 1), planning_seconds=0.02, learning_rate=0.5)
    agent.learn(0, 0, 2.0, 1, True)
    with monkeypatch.context() as patch:
        patch.setattr(time, "perf_counter", (moment / 1000 for moment in itertools.count()).__next__)
        agent.act(0, RNG)
    assert 1.9999 < agent.Q[0, 0] < 2  # some twenty updates


@pytest.mark.slow
@pytest.mark.usefixtures("compiled_at_once")
def test_planning_for_some_time_is_interpreted() -> None:
    """Machine code has no clock, and who trains such an agent is told."""
    with pytest.warns(UserWarning, match="cannot be compiled and runs interpreted"):
        train(Walk(), DynaQ.create((5, 2), planning_seconds=1e-9), 5_000, seed=0, evaluate_every=5_000)


N = 9
pushes = st.tuples(st.integers(0, N - 1), st.sampled_from([0.5, 1.0, 2.0, 3.0, 7.0]))


@given(st.lists(st.one_of(pushes, st.none()), max_size=60))
def test_the_heap_is_a_queue_by_priority(operations: list[tuple[int, float] | None]) -> None:
    """Whatever is pushed and popped (None): the highest comes first, each number is there once, no push lowers it."""
    heap = new(Heap, None, {}, **{"items": N, "items + 1": N + 1})
    there: dict[int, float] = {}
    for operation in operations:
        if operation is not None:
            item, priority = operation
            heap.push(item, priority)
            there[item] = max(priority, there.get(item, 0.0))
        elif there:
            item = heap.pop()
            assert there.pop(item) >= max(there.values(), default=0.0)
        n = heap.size[0]
        assert n == len(there)
        assert {int(heap.items[k]): float(heap.priorities[k]) for k in range(1, n + 1)} == there
        assert all(heap.places[heap.items[k]] == k for k in range(1, n + 1))
        assert (heap.places > 0).sum() == n


def test_dyna_repeats_the_update() -> None:
    """One pair, α = γ = 1/2: the real step gives Q = 1, and each imagined one halves what is missing to 2."""
    agent = DynaQ.create((2, 1), planning_steps=3, learning_rate=0.5, discount=0.5)
    agent.learn(0, 0, 2.0, 1, True)
    assert agent.Q[0, 0] == 1.0
    agent.act(0, RNG)
    assert agent.Q[0, 0] == 2.0 - 1.0 / 8
    agent.learn(1, 0, 0.0, 0, False)  # Q(1) = (0 + Q(0)/2)/2; nothing is known of an end that bootstraps
    assert agent.Q[1, 0] == (2.0 - 1.0 / 8) / 4


def test_with_a_bonus_dyna_imagines_what_it_has_not_tried_for_long() -> None:
    """κ = 2, α = 1, γ = 1/2: after 9 steps of action 0, it is worth 3 + 2 √0, and action 1, never tried, 2 √9 + Q/2."""
    agent = DynaQ.create((2, 2), planning_steps=1, learning_rate=1, discount=0.5, exploration_bonus=2)
    for _ in range(9):
        agent.learn(0, 0, 3.0, 1, True)
    assert agent.imagined_target(0, 0, RNG) == 3.0
    assert agent.imagined_target(0, 1, RNG) == 2 * math.sqrt(9) + 0.5 * 3.0
    agent.model.steps[0] += 16
    assert agent.imagined_target(0, 0, RNG) == 3.0 + 2 * math.sqrt(16)


def test_without_a_bonus_dyna_imagines_only_what_it_has_tried() -> None:
    """Action 1 keeps its value."""
    agent = DynaQ.create((3, 2), planning_steps=500)
    agent.learn(0, 0, 3.0, 1, False)
    agent.learn(2, 1, 3.0, 1, False)
    agent.act(0, RNG)
    assert np.argwhere(agent.Q).tolist() == [[0, 0], [2, 1]]


@pytest.mark.parametrize(
    ("steps", "given", "settings", "tolerance"),
    [
        (0, True, {"learning_rate": 1, "expected_updates": True}, 1e-8),
        pytest.param(
            *(50_000, False, {"learning_rate": 1, "expected_updates": True, "exploration": EpsilonGreedy(1)}, 0.03),
            marks=pytest.mark.slow,
        ),
        (0, True, {"learning_rate": 0.01, "planning_steps": 200}, 0.1),  # the model as a generator
    ],
)
def test_planning_finds_the_optimum(steps: int, given: bool, settings: Any, tolerance: float) -> None:
    """With the exact model, without a step, and with one that was learned from very many steps."""
    mdp = Walk()
    agent = DynaQ.create(mdp, model=finite_model(mdp) if given else None, discount=0.9, **settings)
    if steps:
        train(mdp, agent, steps, seed=1, evaluate_every=steps)
    for _ in range(300):
        agent.act(1, RNG)
    assert pytest.approx(exact_values(mdp, 0.9), abs=tolerance) == agent.Q
    assert pytest.approx(exact_values(mdp, 0.8), abs=tolerance) != agent.Q


@pytest.mark.parametrize(
    ("settings", "values"),
    [
        ({"planning_steps": 0}, [0, 0, 0, 0]),
        ({"planning_steps": 1}, [0, 0, 8, 0]),
        ({"planning_steps": 2}, [0, 4, 8, 0]),
        ({"planning_steps": 2, "expected_updates": False}, [0, 4, 8, 0]),
        ({"planning_steps": 9, "expected_updates": False}, [2, 4, 8, 0]),
        ({"planning_steps": 99, "threshold": 0}, [2, 4, 8, 0]),  # the queue becomes empty
        ({"planning_steps": 99, "threshold": 3}, [0, 4, 8, 0]),  # changes by 8, 4 and 2: the last is not above it
        ({"planning_steps": 99, "threshold": 4}, [0, 0, 8, 0]),
    ],
)
def test_the_reward_goes_back_one_state_with_every_sweeping_update(settings: Any, values: list[float]) -> None:
    """After one walk 0 → 1 → 2 → 3, the end, where it was paid 8; α = 1, γ = 1/2."""
    agent = PrioritisedSweeping.create((4, 1), learning_rate=1, discount=0.5, **settings)
    for state in (0, 1, 2):
        agent.learn(state, 0, 8.0 if state == 2 else 0.0, state + 1, state == 2)
    assert agent.queue.size[0] == 1
    agent.act(0, RNG)
    assert agent.Q[:, 0].tolist() == values
    if settings["planning_steps"] == 99:
        assert agent.queue.size[0] == 0
        agent.learn(2, 0, 8.0, 3, True)  # nothing changes any more
        assert agent.queue.size[0] == 0


def test_the_largest_change_comes_first() -> None:
    """Three ends that pay 1, 5 and -9: one update a time."""
    agent, order = PrioritisedSweeping.create((4, 1), planning_steps=1, learning_rate=1), []
    for state, reward in ((0, 1.0), (1, 5.0), (2, -9.0)):
        agent.learn(state, 0, reward, 3, True)
    for _ in range(3):
        before = agent.Q.copy()
        agent.act(0, RNG)
        order.append(int(np.flatnonzero(before != agent.Q)[0]))
    assert order == [2, 1, 0]


@pytest.mark.parametrize("slip", [0.0, 0.25])
def test_with_the_exact_model_one_act_finds_the_optimum(slip: float) -> None:
    """Without a step: until the queue of sweeping is empty, and in both tables of R-max."""
    mdp, how = Walk(slip=slip), dict[str, Any](discount=0.9, threshold=1e-12)
    exact, model = exact_values(mdp, 0.9), finite_model(mdp)
    sweeping = PrioritisedSweeping.create(mdp, model=model, planning_steps=np.inf, learning_rate=1, **how)
    sweeping.act(1, RNG)
    assert sweeping.queue.size[0] == 0
    assert pytest.approx(exact, abs=1e-9) == sweeping.Q
    hoping = RMax.create(mdp, model=model, **how)
    hoping.act(1, RNG)
    for table in (hoping.Q, hoping.optimistic):
        assert table[1:-1] == pytest.approx(exact[1:-1], abs=1e-9)


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"expected_updates": False}, r"planning_steps must be finite if updates are sampled, .* but is inf"),
        ({"threshold": 0, "learning_rate": 0.5}, r"planning_steps must be finite .* but is inf"),
        # which does not learn
        ({"model": finite_model(make_mdp("Boulder")), "memory": 9}, r"memory must be left out where .* but is 9"),
    ],
)
def test_planning_without_an_end_is_refused(settings: Any, message: str) -> None:
    """Where the queue never becomes empty, with noisy or ever smaller updates; and memory for a given model."""
    PrioritisedSweeping.create((4, 2), planning_steps=np.inf, threshold=0, learning_rate=1)
    with pytest.raises(ValueError, match=message):
        PrioritisedSweeping.create(make_mdp("Boulder"), planning_steps=np.inf, **settings)


def test_the_unknown_is_hoped_for_and_feared() -> None:
    """U = 10, L = -10, γ = 1/2: (0, 0) pays 1 and leads to 1, of which nothing is known."""
    agent = RMax.create((3, 2), highest_return=10, lowest_return=-10, discount=0.5)
    agent.learn(0, 0, 1.0, 1, False)
    assert {agent.act(0, RNG) for _ in range(20)} == {1}
    assert agent.optimistic.tolist() == [[6, 10], [10, 10], [10, 10]]
    assert agent.Q.tolist() == [[-4, -10], [-10, -10], [-10, -10]]
    assert {agent.greedy(0, RNG) for _ in range(20)} == {0}


def test_r_max_goes_back_to_what_it_has_not_tried() -> None:
    """0 → 1 by action 0, and both actions of 0 tried: the way to the unknown actions of 1 is the best."""
    agent = RMax.create((3, 2), discount=0.9)
    agent.learn(0, 0, -1.0, 1, False)
    agent.learn(0, 1, 50.0, 2, True)
    assert agent.act(0, RNG) == 0  # -1 + 0.9 · 100 > 50
    agent.learn(1, 0, 0.0, 2, True)
    agent.learn(1, 1, 0.0, 2, True)
    assert agent.act(0, RNG) == 1  # now all is known


def test_a_sweep_that_changes_nothing_is_the_last() -> None:
    """Also with θ = 0: the first two updates make values of 1 and 1/2, and the next two change nothing."""
    agent = RMax.create((3, 1), discount=0.5, threshold=0, planning_steps=50)
    agent.learn(1, 0, 1.0, 2, True)
    agent.learn(0, 0, 0.0, 1, False)
    agent.act(0, RNG)
    assert agent.optimistic[:2, 0].tolist() == [0.5, 1.0]
    assert (agent.sweep.settled[0], agent.sweep.next[0]) == (2, 0)


def test_a_pair_is_known_after_m_visits_and_then_stays_so() -> None:
    """M = 2: the mean of the first two rewards, whatever comes then."""
    agent = RMax.create((2, 1), known_after=2)
    for reward, value in ((2.0, 100), (4.0, 3), (99.0, 3)):
        agent.learn(0, 0, reward, 1, True)
        agent.act(0, RNG)
        assert agent.optimistic[0, 0] == value


def test_the_budget_spreads_the_sweep_over_the_steps() -> None:
    """One update an act: the known pairs by turns."""
    agent = RMax.create((3, 1), planning_steps=1, discount=0.5)
    agent.learn(0, 0, 0.0, 1, False)
    agent.learn(1, 0, 8.0, 2, True)
    for values in ([50, 100], [50, 8], [4, 8], [4, 8]):
        agent.act(0, RNG)
        assert agent.optimistic[:2, 0].tolist() == values
