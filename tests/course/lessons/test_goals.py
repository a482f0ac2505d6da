"""Goals on Switches: what is computed exactly, what a network believes, the negative control, and the claims."""

from typing import Any

import numpy as np
import pytest

from edugym import HindsightDQN, finite_model, make_mdp, policy_evaluation, train, value_iteration
from edugym_course.lessons.goals import exercises, experiments, methods, project
from tests.course.lessons.made_up import finals, made_up, measured


@pytest.mark.parametrize("n", [1, 2, 4])
def test_random_play(n: int) -> None:
    """The exact model of all pairs gives the same return, and where the goal alone pays, the same chance."""
    model = finite_model(make_mdp("Switches", n_switches=n))
    random = np.full((len(model.states), n), 1 / n)
    assert experiments.random_return(n) == pytest.approx(policy_evaluation(model, random, horizon=n).start)
    chances = [methods.chance_of_random_play(n, steps) for steps in range(n + 1)]
    assert chances[0] == 0.0
    assert chances[1] == pytest.approx(1 / (2**n - 1))  # one of the n patterns at distance 1, and its switch of n
    assert chances == sorted(chances)
    assert methods.chance_of_random_play(n) == chances[-1] <= n / (2**n - 1)


def test_true_values() -> None:
    """They are those of the exact model, by the distance."""
    mdp = make_mdp("Switches", n_switches=3)
    values = value_iteration(finite_model(mdp), methods.DISCOUNT)
    for state, row in zip(values.model.states, values.Q, strict=True):
        if not mdp.terminal(state):
            assert row.max() == pytest.approx(methods.true_value(mdp.distance(state)), abs=1e-9)


def counter_of_wrong_switches(n: int) -> HindsightDQN:
    """A network whose values are minus the distance: a hidden unit for each way in which a switch can be wrong."""
    agent = HindsightDQN.create(make_mdp("Switches", n_switches=n), hidden=2 * n)
    first, second = agent.dqn.weights
    for k in range(n):
        for is_on in (0, 1):
            unit = 2 * k + is_on
            first[2 * k + is_on, unit] = first[2 * (n + k) + 1 - is_on, unit] = (
                1.0  # the switch is so, and not wanted so
            )
            first[-1, unit] = -1.0
    second[:-1] = -1.0
    return agent


def test_what_a_network_believes() -> None:
    """It is asked about patterns at each distance, in the order of the distances."""
    agents = [counter_of_wrong_switches(3) for _ in range(2)]
    results = made_up({"counts": [{10: 0.0}, {10: 0.0}]}, agents={"counts": agents})
    assert methods.values_by_distance(results, "counts", pairs=5) == pytest.approx(-np.array([[1, 1], [2, 2], [3, 3]]))


def test_goals_of_other_episodes() -> None:
    """They come from steps before the episode, each as likely."""
    steps = [methods.OtherEpisodes().achieved_after(3, 8, k / methods.FAR_BACK) for k in range(methods.FAR_BACK)]
    assert sorted(steps) == [*range(-methods.FAR_BACK, 0)]


@pytest.mark.slow
def test_which_transitions_reach_their_goal() -> None:
    """Hardly one where the goals come from elsewhere; with 'future' more than with 'final'."""
    none, others, final, future = (
        methods.rewarded_share(strategy) for strategy in (methods.NONE, methods.OTHERS, methods.FINAL, methods.FUTURE)
    )
    assert max(none, others) < 0.02 < 0.15 < final < future


@pytest.mark.slow
def test_the_control_has_as_many_transitions() -> None:
    """And as many updates as 'future': only the goals differ."""
    task, counted = make_mdp("Switches", n_switches=3), []
    for strategy in (methods.FUTURE, methods.OTHERS):
        agent = methods.network(strategy, learn_from=20)(task)
        train(task, agent, 60, seed=1)
        counted.append(int(agent.dqn.updates[0]))
        assert 4 * 60 < agent.dqn.steps[0] < 7 * 60
    assert counted[0] == counted[1] > 0


def test_claims() -> None:
    """Each is about the method and the number of switches that it names."""
    every = [methods.NONE, methods.FINAL, methods.FUTURE, methods.OTHERS]
    by_size = {n: finals({one: [-float(n), i - n] for i, one in enumerate(every)}) for n in experiments.STEPS}
    best = {n: methods.best_return(n) for n in by_size}
    long = finals({methods.NONE: [-8.0, -7.0]})
    expected = [round(value - n - best[n], 6) for n in by_size for value in (0.5, 1.0)]
    assert measured(experiments.network_claims(by_size, long)) == [*expected, *[0.0] * 3, *[1.5] * 3, 0.5]
    curve = {0: -8.0, 5: -8.0, 10: -6.0}
    random = made_up({experiments.RANDOM_FUTURE: [curve] * 2, experiments.RANDOM_NONE: [{10: -7.5}] * 2})
    found = measured(experiments.random_claims(random))
    assert found == [round(-22 / 3 - best[8], 6), round(-22 / 3 - experiments.random_return(8), 6), 0.5]
    tables = {
        n: finals({methods.NONE: [1.0 - n] * 2, methods.FUTURE: [2.0 - n, 3.0 - n]}) for n in experiments.OF_TABLES
    }
    assert measured(experiments.table_claims(tables)) == [round(-3 - methods.best_return(4), 6), 1.5, 2.5]
    low = {n: finals({methods.NONE: [1.0 - n] * 2, methods.FUTURE: [4.0 - n, 5.0 - n]}) for n in experiments.LOW_TABLES}
    behind = [round(-2.5 - methods.best_return(7), 6), round(methods.best_return(8) + 3.5, 6)]
    assert measured(experiments.low_table_claims(low)) == [3.5, 3.5, 3.5, *behind]
    shares: Any = {one: [0.1 * i] * 2 for i, one in enumerate(every)}
    assert measured(experiments.memory_claims(shares)) == [0.0, 0.3, 0.1, 0.2]
    agents = {one: [counter_of_wrong_switches(8)] for one in (methods.NONE, methods.FUTURE)}
    believed = made_up({one: [{10: 0.0}] for one in agents}, agents=agents)
    last = -8 - methods.true_value(8)
    assert measured(experiments.value_claims(believed)) == pytest.approx([4 + methods.true_value(4), last, 7.0])


def test_far_shares() -> None:
    """Of what is in the memory only, and by how many switches differ from their goal."""
    results = methods.networks(3, (methods.NONE,), n_steps=40, repetitions=2, jobs=1)
    assert methods.far_shares(results, methods.NONE, far=1) == pytest.approx([1.0, 1.0])
    some, none = (methods.far_shares(results, methods.NONE, far=far) for far in (2, 4))
    assert ((some > 0) & (some < 1)).all()
    assert (none == 0).all()


def test_the_program_of_the_project_by_hand() -> None:
    """Two steps that miss their goal, and are learned again backwards for the pattern in which they end."""
    first, rate, discount = project.WORST, project.LEARNING_RATE, project.DISCOUNT
    agent, missed, reached = project.Hindsight((16, 2)), (0, 1), (1, 1)

    def seen(pattern: tuple[int, int], goal: tuple[int, int]) -> dict[str, Any]:
        return {"achieved_goal": pattern, "desired_goal": goal}

    agent.learn(seen((0, 0), missed), 0, -1.0, seen((1, 0), missed), False, False)
    agent.learn(seen((1, 0), missed), 1, -1.0, seen((1, 1), missed), False, True)
    cost, last = first + rate * (-1 + discount * first - first), first - rate * first
    assert agent.values(seen((0, 0), missed)) == pytest.approx([cost, first])
    assert agent.values(seen((1, 0), reached)) == pytest.approx([first, last])
    again = first + rate * (-1 + discount * last - first)
    assert agent.values(seen((0, 0), reached)) == pytest.approx([again, first])


@pytest.mark.parametrize("seed", range(8))
def test_cases_tell_all_mistakes_of_future(seed: int) -> None:
    """In the first case no two of them draw alike, by more than chance."""
    long = exercises.episodes_of(seed)[-1]
    shares = [exercises.shares_of([then for _, _, then in long[2:]])]
    shares += [exercises.shares_of(draws(long, 2)) for draws in exercises.FUTURE_MISTAKES.values()]
    differences = [np.abs(np.subtract(one, other)).max() for i, one in enumerate(shares) for other in shares[:i]]
    assert min(differences) > 0.14
