"""Rewards, returns and the discount in Supermarket: the claims hold with other seeds than those the lesson shows."""

from typing import Any

import build
import gymnasium
import numpy as np
import pytest

from edugym.exact.value_iteration import value_iteration
from edugym_course.lessons.loop import exact, experiments, figures, methods, panels
from edugym_course.notebook import frames
from tests.course.lessons.made_up import made_up, measured
from tests.course.lessons.shown import NOTEBOOKS, run_cell


def test_returns() -> None:
    """1 + 2/2 + 4/4, as backwards; with discount 0 the first reward, with 1 the sum."""
    rewards = np.array([1.0, 2.0, 4.0])
    assert [exact.discounted(rewards, discount) for discount in (0.0, 0.5, 1.0)] == [1.0, 3.0, 7.0]
    assert exact.returns_along(rewards, 0.5).tolist() == [3.0, 4.0, 4.0]
    way = exact.rewards_along(exact.best_way(0.95))
    assert exact.returns_along(way, 0.95)[0] == pytest.approx(value_iteration(exact.model(), 0.95).start)
    assert len(exact.best_way(0.0)) == methods.MAX_STEPS + 1


@pytest.mark.parametrize(("discount", "items"), methods.ITEMS.items())
def test_best_way(discount: float, items: int) -> None:
    """Its discounted rewards are V* of the start, and it collects as many items as the lesson says."""
    way = exact.best_way(discount)
    assert exact.discounted(exact.rewards_along(way), discount) == pytest.approx(
        value_iteration(exact.model(), discount).start
    )
    assert exact.items_on(way) == items


def test_players() -> None:
    """Random play is worst; half of its episodes are truncated, which costs 500 points, and the others end."""
    assert -500.0 < exact.random_return() < exact.leaving_return() < exact.myopic_return() < 0.0 < methods.OPTIMUM
    assert 0.0 < exact.misled() < 1.0
    env = gymnasium.make("edugym/Supermarket-v0")
    env.reset(seed=1)
    env.action_space.seed(3)
    totals, cut_off = methods.play_at_random(env, episodes=300)
    assert 0.35 < np.mean(cut_off) < 0.6
    assert np.mean(totals) == pytest.approx(exact.random_return(), abs=60)
    assert max(total for total, late in zip(totals, cut_off, strict=True) if late) <= -methods.MAX_STEPS + 75


def test_right_choices() -> None:
    """The exact table makes no others, an empty one makes them by chance; the shares of the parts make the whole."""
    assert exact.right_choices(exact.best_table(methods.DISCOUNT), methods.DISCOUNT) == 1.0
    assert 0.25 < exact.right_choices(np.zeros((800, 4)), methods.DISCOUNT) < 0.45
    assert (exact.untried(exact.best_table(methods.DISCOUNT)), exact.untried(np.zeros((800, 4)))) == (0.0, 1.0)
    Q = figures.agent_after(2_000).Q
    share, parts = exact.untried(Q), [exact.right_choices(Q, methods.DISCOUNT, tried) for tried in (False, True)]
    assert share * parts[0] + (1 - share) * parts[1] == pytest.approx(exact.right_choices(Q, methods.DISCOUNT))


def test_first_film() -> None:
    """As the lesson tells, the learner of 2 000 steps walks into the wall at the entrance; the red item is known."""
    namespace: dict[str, Any] = {"display": lambda *_: None}
    for cell in build.read_lesson(NOTEBOOKS["loop"]).cells:
        if any(text in cell.source for text in ("from edugym import", "env = gym.make(", "range(2_000)")):
            run_cell(cell.source, f"<loop, {cell.id}>", namespace)
    env, agent = namespace["env"], namespace["agent"]
    steps = [frame.line for frame in frames(env, agent, max_steps=40).frames][1:]
    assert len(steps) == 40
    assert all(": up, observation 8, reward -1" in step for step in steps)
    assert agent.Q[8].max() < 0.0 < agent.Q[8 * 13].max()  # three steps further


def test_arrows() -> None:
    """One for a single best action, a slanted one for two; none where more are equal, or nothing is known."""
    Q = np.full((800, 4), np.nan)
    Q[8 * 21], Q[8 * 22], Q[8 * 23], Q[8 * 24] = [0, 0, 0, 1], [1, 0, 0, 1], [1, 1, 0, 1], [1, 1, 0, 0]
    assert panels.ValueMap(Q).arrows() == [(2, 1, 0, 1), pytest.approx((2, 2, -(0.5**0.5), 0.5**0.5))]


def test_bags() -> None:
    """The name of each says which items are in it, and a map is that of the bag in its title."""
    worth = {"empty": 0, "red": 4, "blue": 2, "green": 1, "all three": 7}
    assert {name: sum(worth[item] for item in name.split(" and ")) for name in figures.BAGS} == figures.BAGS
    assert sorted(figures.BAGS.values()) == [*range(8)]
    for sheet in (figures.with_discount(0.9, "blue"), figures.learned_beside_exact(0, "blue")):
        maps = [panel for row in sheet.rows for panel in row if isinstance(panel, panels.ValueMap)]
        assert [("bag: blue" in panel.title, panel.items) for panel in maps] == [(True, 2)] * len(maps)
        assert maps
    learned, right = figures.learned_beside_exact(20_000, "red").rows[0]
    start = value_iteration(exact.model(), methods.DISCOUNT).start
    assert learned.title == f"after 20 000 steps, bag: red\nvalue of the first state: {start:.1f}"
    assert right.title == f"v*, bag: red\nvalue of the first state: {start:.1f}"


def test_loop() -> None:
    """One of four runs, and one of two, ends with 95; random play is compared with the exact model."""
    results = made_up(
        {
            methods.Q_LEARNING: [{10: 95.0}, {10: 94.0}, {10: 78.0}, {10: -500.0}],
            methods.MYOPIC: [{10: 95.0}, {10: 95.0}, {10: 0.0}, {10: -500.0}],
            methods.RANDOM: [{10: exact.random_return()}] * 4,
        }
    )
    assert measured(experiments.player_claims(results)) == [1.0, 95.0, 0.25]
    assert measured(experiments.reward_claims(results))[-1] == 0.5
    usual, at_once = (made_up({methods.MYOPIC: [{0: 0.0, 10: 2 * end}] * 4}) for end in (-400, exact.myopic_return()))
    tested, test = experiments.rounding_claims(usual, at_once)
    assert measured([tested, test]) == [round(-400 - exact.random_return(), 6), 1.0]
    assert tested.tested_by == (test.statement,)
