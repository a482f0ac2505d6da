"""A problem of one's own: what rewards teach, exactly, and the call that takes a problem through everything."""

from dataclasses import replace
from itertools import product
from operator import itemgetter
from typing import Any

import build
import numpy as np
import pandas as pd
import pytest
from rules import is_code

from edugym import finite_model, policy_evaluation, value_iteration
from edugym.experiments.results.statistics import mean_interval
from edugym.experiments.results.tables import Results
from edugym.rendering.ansi import to_text
from edugym_course.lessons.own_problem import bedroom, everything, exact, experiments, figures, morning
from tests.course.lessons.made_up import Circle
from tests.course.lessons.shown import check_legends


def test_the_lesson_writes_the_same_class() -> None:
    """The cell in which students read it has the dynamics and the rewards of the package's."""
    cells = build.read_lesson(build.lesson_sources()["10_own_problem"]).cells
    names: dict[str, Any] = {"__name__": "__main__"}
    for cell in [cell.source for cell in cells if is_code(cell)]:
        if "\nfrom typing import NamedTuple\n" in cell:
            exec(cell, names)
        if cell.startswith("class Morning(NamedTuple)"):
            exec(cell, names)
            break
    variants: tuple[dict[str, Any], ...] = ({}, {"length": 5, "ring": 1.5, "late": 7.0})
    for fields in variants:
        mine, theirs = (finite_model(kind(**fields)) for kind in (morning.Morning, names["Morning"]))
        assert mine.states == theirs.states
        np.testing.assert_array_equal(mine.p, theirs.p)
        np.testing.assert_array_equal(mine.r, theirs.r)


def test_what_rewards_teach() -> None:
    """The values that the lesson tells; where the potential is v*, the best action earns v*(s) - φ(s) = 0."""
    shaped = value_iteration(finite_model(experiments.REWARDS[exact.BEST_GUESS]))
    np.testing.assert_allclose(shaped.V, 0.0, atol=1e-9)
    plain = value_iteration(finite_model(morning.Morning()))
    assert np.abs(plain.V).max() > 1
    assert np.array_equal(shaped.greedy_policy(), plain.greedy_policy())
    player = exact.player(morning.Morning())  # in a film
    assert [player(state) for state in plain.model.states] == plain.greedy_policy().argmax(axis=1).tolist()
    nights = {
        label: exact.what_happens(morning.Morning(), exact.best_policy(task))
        for label, task in experiments.TASKS.items()
    }
    assert nights[exact.MEANT].late == pytest.approx(0.135, abs=5e-4)
    assert nights[exact.WAKEFULNESS].sleep == pytest.approx(18.6, abs=0.05)
    assert nights[exact.WAKINGS].wakings == pytest.approx(2.38, abs=5e-3)
    assert nights[exact.POTENTIAL] == pytest.approx(nights[exact.MEANT])
    tricks = [
        exact.what_happens(morning.Morning(), exact.best_policy(morning.WithBonus(morning.Morning(), b))).wakings > 2
        for b in (5.0, 6.0)
    ]
    assert tricks == [False, True]


def test_what_policies_are_worth_by_hand() -> None:
    """In silence nobody wakes, one late ring wakes her with 0.9; a circle costs a thousand; R = -1 stalls."""
    mdp, model = morning.Morning(), finite_model(morning.Morning())
    silent = exact.what_happens(mdp, np.eye(3)[np.zeros(len(model.states), int)])
    assert silent == pytest.approx((6.0, 80.0, 0.0, 0.0, 1.0))
    actions = np.array([2 if state[0] == 7 else 0 for state in model.states])
    loud = exact.what_happens(mdp, np.eye(3)[actions])
    assert loud == pytest.approx((14 - 4 + 0.1 * (1 - 10), 71.0, 1.0, 0.9, 0.1))
    idle = np.eye(2)[np.zeros(5, int)]
    assert exact.worth(finite_model(Circle()), idle, None) == -1_000.0
    assert exact.worth(finite_model(Circle()), idle, 7) == -7.0
    assert experiments.first_stall(-1.0) == (-1.0, -1)
    assert experiments.first_stall(-100.0) == (-2.0, 1)


def test_blind_clocks_are_the_best_of_all() -> None:
    """The search over fixed rules agrees with evaluating each by itself."""
    mdp = morning.Morning(length=3)
    model = finite_model(mdp)
    for part in (0, 1):
        returns = {}
        for actions in product(range(3), repeat=3):
            rule = np.array([actions[min(state[part], 2)] for state in model.states])
            returns[actions] = policy_evaluation(model, rule).start
        value, actions = exact.best_blind(mdp, itemgetter(part))
        assert value == pytest.approx(max(returns.values()))
        assert returns[actions] == pytest.approx(value)


def test_a_problem_goes_through_everything() -> None:
    """It is checked, solved up to its step limit, learned, drawn and told in words."""
    tour = everything.take_through_everything(Circle(12), n_steps=2_000, repetitions=3)
    assert exact.random_return(Circle(12), 12) == tour.random < tour.values.start
    assert all((returns <= tour.values.start + 1e-9).all() for returns in tour.learned.values())
    words = str(tour)
    assert "States: 5, of which 1 are terminal. Actions: 0, 1." in words
    assert "at the first step" in words
    assert [sheet.name for sheet in tour.sheets] == ["policy", "learned"]
    assert tour.sheets[0].rows[0][0].title == "the best first action"
    assert replace(tour, mdp=Circle()).sheets[0].rows[0][0].title == "the best policy"
    for sheet in tour.sheets:
        assert sheet.draw().axes
        check_legends(sheet)
    assert "state" in to_text(tour.picture)
    with pytest.raises(ValueError, match="mdp must be"):
        everything.take_through_everything(3)


@pytest.mark.slow
def test_problems_whose_episodes_may_never_end() -> None:
    """A policy that walks in a circle is cut off; one that is paid for it is no problem."""
    tour = everything.take_through_everything(Circle(), n_steps=300, repetitions=2)
    assert tour.values.start == pytest.approx(-8.0)
    assert all((returns <= -8.0 + 1e-6).all() for returns in tour.learned.values())
    paid = type("Paid", (Circle,), {"__slots__": (), "reward": lambda self, s, a, n, rng: 1.0})
    with pytest.raises(ValueError, match="episodes of Paid may never end, and gather reward without limit"):
        everything.take_through_everything(paid())
    endless = type("Endless", (Circle,), {"__slots__": (), "transition": lambda self, s, a, rng: 0})
    with pytest.raises(ValueError, match="no state of Endless is terminal"):
        everything.take_through_everything(endless())


def test_a_tour_in_words() -> None:
    """From each state half of the steps go on, and half of those by chance: 2 steps a state at best, 4 at random."""
    tour = everything.Tour(Circle(), exact.solve(Circle()), exact.random_return(Circle()), Results(pd.DataFrame()), {})
    words = str(replace(tour, learned={"A": np.array([-9.0, -11.7]), "long label": np.array([-8.0, -8.0])}))
    told = ["-16. Optimum: -8.", f"  long label: {mean_interval([-8.0, -8.0])}", "one action is best in every state"]
    told += [f"{state}: 1 (value {2 * state - 8})" for state in range(4)]
    assert [line for line in told if line not in words] == []
    for most, lines in ((3, 4), (4, 4)):
        assert len(exact.in_words(tour.values, {0: "wait", 1: "go"}, most=most).splitlines()) == lines
    for learned, far in ((-11.7, False), (-11.9, True)):  # 30 % of the way from -8 to -16 is -10.4
        said = str(replace(tour, learned={"A": np.array([-9.0, learned])}))
        assert ("far from the optimum" in said) == far
    for random, easy in ((-8.41, False), (-8.39, True)):
        assert ("hardly more than random actions" in str(replace(tour, random=random))) == easy
    sure = type("Sure", (Circle,), {"__slots__": (), "transition": lambda self, s, a, rng: min(s + 1 + a, 4)})
    assert "are not random." in str(replace(tour, mdp=sure(), values=exact.solve(sure())))


def test_names_and_maps() -> None:
    """Of actions, hours; states that are single numbers stand side by side."""
    names = figures.names_of(morning.Morning())
    assert names == ["stay quiet", "chime", "ring"]
    assert figures.initials(["up", "under"]) == ["0", "1"]
    assert "(7, 2): ring (value -4.9)" in exact.in_words(exact.solve(morning.Morning()), dict(enumerate(names)))
    assert [bedroom.clock(time, 8) for time in (0, 8)] == ["7:10", "8:30"]
    values = exact.solve(Circle())
    assert figures.can_be_drawn(values)
    ax = figures.PolicyMap(values, ["stay", "go"]).draw()
    assert [(text.get_position(), text.get_text()) for text in ax.texts] == [((x, 0), "g") for x in range(4)]
    assert (ax.get_ylabel(), len(ax.get_yticks())) == ("", 0)
