"""Search at decision time: the tasks with more actions and with wrong maps, what is exact, and the project's model."""

from typing import Any

import numpy as np
import pytest

from edugym import finite_model, make_mdp, mean_interval, paired_difference, value_iteration
from edugym_course.grading.errors import WrongAnswer
from edugym_course.lessons.search import figures, methods, plans, project
from edugym_course.lessons.search.exercises import riddles


def test_more_actions_bring_nothing_new() -> None:
    """They stand still, or repeat the four; the best return stays what it was."""
    shop = methods.shop()
    rng = np.random.default_rng(0)
    for state in (8, 88, 80 * 5 + 8 * 4):
        for action in range(16):
            here = methods.crowd(16).transition(state, action, rng)
            assert here == (shop.transition(state, action, rng) if action < 4 else state)
            copied = methods.crowd(16, copies=True).transition(state, action, rng)
            assert copied == shop.transition(state, action % 4, rng)
    for copies in (False, True):
        model = methods.model_of_crowd(8, copies)
        assert plans.looking_ahead(model, model, (20,)) == pytest.approx([methods.OPTIMUM])


def test_looking_ahead_is_what_a_player_gets_who_does_it() -> None:
    """One that plans for eight steps before each of its own; on an old map it does not notice."""
    truth = finite_model(make_mdp("Supermarket", max_steps=100))
    for door, depth, expected in ((None, 20, 95.0), (methods.DOOR, 8, 59.0), (methods.DOOR, 20, -50.0)):
        assert plans.in_the_shop(door, (depth,)) == pytest.approx([expected])
    s, total = int(truth.initial.argmax()), 0.0
    shop, rng = methods.shop(), np.random.default_rng(0)
    V = [np.zeros(len(truth.states))]
    for _ in range(20):
        V.append(np.where(truth.terminal, 0.0, truth.action_values(V[-1], methods.DISCOUNT).max(axis=1)))
    for _ in range(100):
        action = int(truth.action_values(V[19], methods.DISCOUNT)[s].argmax())
        state = truth.states[s]
        after = shop.transition(state, action, rng)
        total += shop.reward(state, action, after, rng)
        s = truth.row(after)
        if truth.terminal[s]:
            break
    assert total == methods.OPTIMUM


def test_a_map_is_mended_by_ones_own_steps() -> None:
    """Two steps are lost at a door that is not there; on the right map there is nothing to mend."""
    assert plans.mending(12, door=(7, 3)) == 93.0
    assert plans.mending(20, door=(7, 6)) == 95.0


def test_sweeps_of_value_iteration() -> None:
    """Far fewer are needed from the entrance on than in all states, and one fewer is not enough."""
    sweeps = plans.sweeps_needed()
    assert sweeps.from_entrance < sweeps.everywhere
    assert sweeps.pairs == 4 * 420
    assert plans.in_the_shop(None, (sweeps.from_entrance - 1, sweeps.from_entrance)) == pytest.approx([78.0, 95.0])


def test_the_wrong_model_is_the_cause() -> None:
    """In soccer and in the shop a deeper look is never worth less in the right model, and it is in the wrong one."""
    for right, wrong in (
        (plans.in_the_shop(), plans.in_the_shop(methods.DOOR)),
        (plans.in_soccer(True), plans.in_soccer(False)),
    ):
        assert np.diff(right).min() > -1e-9
        assert np.diff(wrong).min() < -0.4 * np.ptp(right)
    errors = np.array([plans.with_errors(number, (8, 20)) for number in range(12)])
    assert errors[:, 1].mean() > errors[:, 0].mean() + 20


@pytest.mark.slow
def test_a_tree_is_worth_more_than_roll_outs() -> None:
    """And with more simulations these come to their limit; runs repeat, and differ with the seed."""
    how: Any = {"repetitions": 20, "seed": 3}
    tree, plain = methods.searched(**how), methods.searched(nodes=1, **how)
    assert paired_difference(tree, plain).low > 0
    many = mean_interval(methods.searched(nodes=1, simulations=3_000, **how))
    assert many.high < 70
    assert plans.random_play() == pytest.approx(59)
    few: Any = {"repetitions": 3, "simulations": 30}
    again, other = (methods.searched(seed=seed, **few).tolist() for seed in (3, 4))
    assert again == methods.searched(seed=3, **few).tolist()
    assert again != other


@pytest.mark.slow
def test_roll_outs_suffer_more_from_actions_than_the_tree() -> None:
    """Where the actions repeat the four, little is lost."""
    how: Any = {"repetitions": 8, "seed": 3}
    idle, copies = methods.in_crowd(16, **how), methods.in_crowd(16, copies=True, **how)
    assert paired_difference(copies, idle).low > 40


def test_nodes_are_counted_by_cell() -> None:
    """Each simulation adds one at most, and the root is at the entrance."""
    agent = methods.searcher(methods.model_of_map(), simulations=50)
    agent.greedy(8, np.random.default_rng(0))
    counts = figures.nodes_by_cell(agent)
    assert counts[1] >= 1
    assert counts.sum() == agent.tree.n[0] <= 51


def test_the_model_of_the_project_says_what_may_be_asked() -> None:
    """Numbers are dealt out anew; what is asked is counted, and what no search would ask is refused."""
    riddle = riddles.RIDDLES[2]
    models = [project.Model(riddle, seed) for seed in range(20)]
    assert len({model.number(riddles.ROOT) for model in models}) > 5
    assert {model.meant(0) for model in models} == {0, 1, 2}
    model = models[0]
    root, into = model.number(riddles.ROOT), [model.meant(action) for action in range(3)].index(0)
    reward, state, ended = model(root, into)
    assert (reward, state, ended) == (0.0, model.number(1), False)
    assert model(state, into)[::2] == (10.0, True)
    assert model.from_root.tolist() == [1, 0, 0]
    with pytest.raises(WrongAnswer, match="goes on after the end"):
        model(state, into)
    assert "after the end" in model.slip


def test_told_what_new_nodes_are_worth() -> None:
    """The values are those of the model, by what is seen, and the search takes them in place of a roll-out."""
    model, entrance = methods.model_of_map(), int(methods.shop().initial(np.random.default_rng(0)))
    well, random = methods.worth("well"), methods.worth("at random")
    assert well[entrance] == pytest.approx(value_iteration(model, methods.DISCOUNT).start)
    assert (random <= well + 1e-9).all()
    agent = methods.KnownLeaves(*methods.searcher(model, simulations=4))
    agent.Q[:] = well[:, np.newaxis]
    agent.search(entrance, np.random.default_rng(0))
    outcomes = [model.outcomes(entrance, action)[0] for action in range(4)]
    told = [outcome.reward + methods.DISCOUNT * well[int(outcome.next_state)] for outcome in outcomes]
    assert agent.tree.values[0].tolist() == pytest.approx(told)


def test_no_step_pays() -> None:
    """Where no step may seem to pay, the short look is seldom cut off."""
    worth = {pay: [plans.with_errors(k, (8,), steps_pay=pay)[0] for k in range(1, 31)] for pay in (True, False)}
    cut_off = [sum(one == -methods.MAX_STEPS for one in worth[pay]) for pay in (True, False)]
    assert cut_off == [7, 1]
