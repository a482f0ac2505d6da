"""Rewards, returns and the discount in Supermarket: the claims hold with other seeds than those the lesson shows."""

import numpy as np
import pytest

from edugym.exact.value_iteration import value_iteration
from edugym.lessons.loop import (
    ITEMS,
    MAX_STEPS,
    MYOPIC,
    OPTIMUM,
    Q_LEARNING,
    best_way,
    discounted,
    items_on,
    misled,
    model,
    myopic_return,
    play_and_learn,
    random_return,
    rewards_along,
)


def test_discounted_by_hand() -> None:
    """1 + 2/2 + 4/4; with discount 0 the first reward, with 1 the sum."""
    rewards = np.array([1.0, 2.0, 4.0])
    assert [discounted(rewards, discount) for discount in (0.0, 0.5, 1.0)] == [1.0, 3.0, 7.0]


@pytest.mark.parametrize(("discount", "items"), ITEMS.items())
def test_best_way(discount: float, items: int) -> None:
    """Its discounted rewards are V* of the start, and it collects as many items as the lesson says."""
    way = best_way(discount)
    assert discounted(rewards_along(way), discount) == pytest.approx(value_iteration(model(), discount).start)
    assert items_on(way) == items


def test_without_a_future_there_is_no_way() -> None:
    """With discount 0 all steps look the same."""
    assert len(best_way(0.0)) == MAX_STEPS + 1


def test_players() -> None:
    """Random play is worst, the next reward a little better, and both are far from the optimum."""
    assert -500.0 < random_return() < myopic_return() < 0.0 < OPTIMUM
    assert 0.0 < misled() < 1.0


def test_the_discount_makes_the_difference() -> None:
    """The same agent, steps and seeds, with discount 0 and 0.99."""
    results = play_and_learn(n_steps=20_000, repetitions=4, seed=3)
    assert results.difference(Q_LEARNING, MYOPIC).low > 100.0
