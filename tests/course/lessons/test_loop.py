"""Rewards, returns and the discount in Supermarket: the claims hold with other seeds than those the lesson shows."""

import gymnasium
import numpy as np
import pytest

from edugym.exact.value_iteration import value_iteration
from edugym_course.lessons.loop.exact import (
    best_table,
    best_way,
    discounted,
    items_on,
    leaving_return,
    misled,
    model,
    myopic_return,
    random_return,
    returns_along,
    rewards_along,
    right_choices,
    untried,
)
from edugym_course.lessons.loop.experiments import warm_up
from edugym_course.lessons.loop.figures import (
    BAGS,
    agent_after,
    learned_beside_exact,
    nine_challenges,
    race,
    rewards_and_returns,
    with_discount,
)
from edugym_course.lessons.loop.methods import (
    DISCOUNT,
    ITEMS,
    MAX_STEPS,
    MYOPIC,
    OPTIMUM,
    Q_LEARNING,
    RANDOM,
    play_and_learn,
    play_at_random,
)
from edugym_course.lessons.loop.panels import ValueMap
from tests.course.lessons.figures import check_legends


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
    """Random play is worst, leaving and the next reward are a little better, and all are far from the optimum."""
    assert -500.0 < random_return() < leaving_return() < myopic_return() < 0.0 < OPTIMUM
    assert 0.0 < misled() < 1.0


def test_half_of_the_random_episodes_are_truncated() -> None:
    """As the lesson says; those that are cost 500 points, but for items, and the others end with the exit."""
    env = gymnasium.make("edugym/Supermarket-v0")
    env.reset(seed=1)
    env.action_space.seed(3)
    totals, cut_off = play_at_random(env, episodes=300)
    assert 0.35 < np.mean(cut_off) < 0.6
    assert np.mean(totals) == pytest.approx(random_return(), abs=60)
    assert max(total for total, late in zip(totals, cut_off, strict=True) if late) <= -MAX_STEPS + 75


def test_the_discount_makes_the_difference() -> None:
    """The same agent, steps and seeds, with discount 0 and 0.99."""
    results = play_and_learn(n_steps=20_000, repetitions=4, seed=3)
    assert results.difference(Q_LEARNING, MYOPIC).low > 100.0


def test_returns_backwards() -> None:
    """1 + (2 + 4/2)/2, as forwards."""
    rewards = np.array([1.0, 2.0, 4.0])
    assert returns_along(rewards, 0.5).tolist() == [3.0, 4.0, 4.0]
    way = rewards_along(best_way(0.95))
    assert returns_along(way, 0.95)[0] == pytest.approx(value_iteration(model(), 0.95).start)


def test_the_exact_table_makes_right_choices_only() -> None:
    """An empty one makes them by chance, since all are equal."""
    assert right_choices(best_table(DISCOUNT), DISCOUNT) == 1.0
    assert 0.25 < right_choices(np.zeros((800, 4)), DISCOUNT) < 0.45
    assert (untried(best_table(DISCOUNT)), untried(np.zeros((800, 4)))) == (0.0, 1.0)


def test_an_agent_knows_its_way_and_not_the_shop() -> None:
    """As the lesson says: the value of the start is right in most runs, and half of the choices are."""
    agents = [agent_after(20_000, seed=seed) for seed in range(20, 26)]
    start = value_iteration(model(), DISCOUNT).start
    assert np.median([agent.Q[8].max() for agent in agents]) == pytest.approx(start, abs=0.1)
    assert 0.4 < np.mean([right_choices(agent.Q, DISCOUNT) for agent in agents]) < 0.55
    assert 0.3 < np.mean([untried(agent.Q) for agent in agents]) < 0.65
    unseen, seen = (np.mean([right_choices(agent.Q, DISCOUNT, tried) for agent in agents]) for tried in (False, True))
    assert unseen < 0.4 < 0.5 < seen < 0.65


def test_shares_of_the_parts_make_the_whole() -> None:
    """Tried states and the others, weighted by their numbers."""
    Q = agent_after(2_000).Q
    share, parts = untried(Q), [right_choices(Q, DISCOUNT, tried) for tried in (False, True)]
    assert share * parts[0] + (1 - share) * parts[1] == pytest.approx(right_choices(Q, DISCOUNT))


def test_learning_rewards_is_worse_than_random_play() -> None:
    """Over the last steps, without exploring."""
    results = play_and_learn(n_steps=20_000, repetitions=8, seed=5)
    late = {player: results.curves(player).loc[15_000:].to_numpy().mean() for player in results.methods}
    assert late[MYOPIC] < late[RANDOM] - 50 < late[Q_LEARNING]
    assert late[RANDOM] == pytest.approx(random_return(), abs=60)


def test_arrows() -> None:
    """One for a single best action, a slanted one for two; none where more are equal, or nothing is known."""
    Q = np.full((800, 4), np.nan)
    Q[8 * 21], Q[8 * 22], Q[8 * 23], Q[8 * 24] = [0, 0, 0, 1], [1, 0, 0, 1], [1, 1, 0, 1], [1, 1, 0, 0]
    assert ValueMap(Q).arrows() == [(2, 1, 0, 1), pytest.approx((2, 2, -(0.5**0.5), 0.5**0.5))]


def test_figures() -> None:
    """Every one is drawn, at the ends of the sliders too."""
    warm_up()
    sheets = [with_discount(gamma, bag) for gamma in (0.0, 1.0) for bag in ("empty", "all three")]
    sheets += [rewards_and_returns(), learned_beside_exact(0), learned_beside_exact(500, "red"), nine_challenges()]
    for sheet in sheets:
        assert sheet.draw().axes
        check_legends(sheet)
    assert [len(row) for row in nine_challenges().rows] == [3, 3, 3]
    mine = race({"mine": lambda shop: agent_after(0)}, n_steps=80, repetitions=2)
    assert {text.get_text() for text in mine.draw().legends[0].get_texts()} >= {"mine", Q_LEARNING, MYOPIC, RANDOM}


def test_bags() -> None:
    """The name of each says which items are in it; a map is that of the bag in its title."""
    worth = {"empty": 0, "red": 4, "blue": 2, "green": 1, "all three": 7}
    assert {name: sum(worth[item] for item in name.split(" and ")) for name in BAGS} == BAGS
    assert sorted(BAGS.values()) == [*range(8)]
    for sheet in (with_discount(0.9, "blue"), learned_beside_exact(0, "blue")):
        maps = [panel for row in sheet.rows for panel in row if isinstance(panel, ValueMap)]
        assert [("bag: blue" in panel.title, panel.items) for panel in maps] == [(True, 2)] * len(maps)
        assert maps


def test_learned_beside_exact_names_the_bag_that_is_drawn() -> None:
    """The value of the first state is the same for every bag; the map is not."""
    learned, exact = learned_beside_exact(20_000, "red").rows[0]
    start = value_iteration(model(), DISCOUNT).start
    assert learned.title == f"after 20 000 steps, bag: red\nvalue of the first state: {start:.1f}"
    assert exact.title == f"v*, bag: red\nvalue of the first state: {start:.1f}"
