"""Several agents: what is computed of games, how players are compared, the riddles of the project, and the claims."""

import itertools
import threading
from typing import Any

import numpy as np
import pytest

from edugym import games
from edugym.envs.games.soccer import EAST, NORTH, STAND, WEST, Field
from edugym_course.lessons.several_agents import exercises, experiments, houses, methods, project
from edugym_course.lessons.several_agents.exercises import gains, update
from edugym_course.lessons.several_agents.turns import FieldInTurn
from tests.course.lessons.made_up import finals, made_up, measured


def test_the_falling_q_learner_is_q_learning() -> None:
    """But for its learning rate, which falls with every step."""
    agent = methods.independent(methods.matrix("matching pennies").game, 0, n_steps=2, discount=0.5)
    agent.learn(0, 1, 3.0, 0, terminated=False)
    assert agent.Q.tolist() == [[1.0, 3.5]]  # all the way to 3 + 0.5
    agent.learn(0, 1, 1.0, 0, terminated=True)
    assert agent.Q[0, 1] == pytest.approx(3.5 + 0.1 * (1.0 - 3.5))


@pytest.mark.parametrize("name", [*methods.NO_SAFE_ACTION, *methods.DOMINANT])
def test_pairs_without_chance(name: str) -> None:
    """Their exploitability is that of the tables: in no game without a safe action is any of them safe."""
    payoffs = methods.matrix(name).game.payoffs
    n = payoffs.shape[0]
    by_hand = [
        (payoffs[:, b, 0].max() - payoffs[a, b, 0] + payoffs[a, :, 1].max() - payoffs[a, b, 1]) / 2
        for a, b in itertools.product(range(n), repeat=2)
    ]
    assert experiments.pure_pairs(name) == pytest.approx(by_hand)


@pytest.mark.slow
def test_what_a_policy_loses() -> None:
    """It is what the best opponent wins; a safe policy loses nothing, and random play the same in both seats."""
    field, solved = methods.soccer(), methods.solution()
    random = games.uniform_policy(field.game, 0)
    assert methods.can_lose(field, 0, solved.policies[0]) == pytest.approx(0.0, abs=1e-9)
    assert methods.can_lose(field, 0, random) == pytest.approx(games.exploitability(field.model, (random, random), 0.9))
    answer = methods.best_answer(field, 0, random)
    returns = games.expected_returns(field.model, (random, answer), 0.9)
    assert returns[1] == pytest.approx(methods.can_lose(field, 0, random))


def test_safe_choices() -> None:
    """In 56 states of each player one comes from the solution, or in all others; with both halves nothing is lost."""
    field = methods.soccer()
    random = [games.uniform_policy(field.game, player) for player in (0, 1)]
    there, elsewhere = (methods.with_safe_choices(random, elsewhere=where) for where in (False, True))
    for player, own in enumerate(random):
        assert (there[player] != own).any(axis=1).sum() == 56
        assert ((there[player] == own) | (elsewhere[player] == own)).all()
    both = methods.with_safe_choices(there, elsewhere=True)
    assert games.exploitability(field.model, both, 0.9) == pytest.approx(0.0, abs=1e-9)
    assert games.exploitability(field.model, elsewhere, 0.9) < games.exploitability(field.model, there, 0.9)


def test_where_a_policy_is_weak() -> None:
    """The state needs a random choice, and the solution guarantees more there than the policy; itself, no more."""
    game, solved = methods.soccer().game, methods.solution()
    certain = np.eye(5)[solved.policies[0].argmax(axis=1)]
    state, possible, guaranteed = methods.weakest_state(certain)
    assert state.ball == 0
    assert possible == pytest.approx(solved.value(state))
    assert guaranteed < possible - 0.01
    assert 0 < solved.policies[0][game.observation(state, 0, np.random.default_rng(0))].max() < 1
    _, possible, guaranteed = methods.weakest_state(solved.policies[0])
    assert guaranteed == pytest.approx(possible)


def test_players_are_compared(tmp_path: Any) -> None:
    """Each method has the same seeds; a run is measured at its points, and the table is saved."""
    known = methods.matrix("prisoner's dilemma")
    results = methods.compare(known, methods.BOTH, 400, repetitions=2, points=2, save_to=tmp_path / "table.csv")
    assert results.methods == [methods.ALONE, methods.MINIMAX]
    assert results.learned(methods.ALONE).steps.tolist() == [0, 200, 400]
    assert results.final(methods.MINIMAX).tolist() == [0.0, 0.0]
    assert len({*results.table["seed"]}) == 2
    assert (tmp_path / "table.csv").exists()
    stop = threading.Event()
    stop.set()
    assert not methods.compare(known, methods.BOTH, 400, repetitions=1, stop=stop).complete


def test_a_safe_teacher_never_learns() -> None:
    """It is player 1, with the safe policy."""
    game = methods.soccer().game
    pupil, teacher = (methods.taught(game, player, 10) for player in (0, 1))
    assert isinstance(pupil, methods.IndependentQ)
    assert np.array_equal(teacher.policy, methods.solution().policies[1])


@pytest.mark.parametrize("learns", [True, False])
def test_changes(learns: bool) -> None:
    """A learner who meets another goes on changing its best action; against a fixed one it finds the answer to it."""
    run = methods.against_each_other("matching pennies", learns=learns, seed=1, n_steps=4_000)
    assert (methods.changes(run) > 1.0) == learns
    late = methods.best_actions(run)[len(run.steps) // 2 :, 0].tolist()
    changed = sum(one != other for one, other in itertools.pairwise(late))
    assert methods.changes(run) == pytest.approx(1_000 * changed / (run.steps[-1] - run.steps[len(run.steps) // 2]))
    if not learns:
        assert methods.best_actions(run)[-1].tolist() == [0, 0]


@pytest.mark.parametrize("riddle", range(len(houses.RIDDLES)))
@pytest.mark.parametrize("seed", range(4))
def test_riddles_need_what_they_ask_for(riddle: int, seed: int) -> None:
    """What is computed exactly is safe everywhere, and at random nobody is; nor without chance, but in two of them."""
    game = houses.RIDDLES[riddle].make(np.random.default_rng(seed))
    model = games.game_model(game)
    solved = games.minimax_value_iteration(model, methods.DISCOUNT)
    assert project.weak_points(model, solved.policies[0]).max() < 1e-9
    certain = np.eye(3)[solved.policies[0].argmax(axis=1)]
    is_unsafe = project.weak_points(model, certain).max() > project.NEAR
    assert is_unsafe == (houses.RIDDLES[riddle] not in (houses.CHANCE, houses.TRAPS))
    assert project.weak_points(model, games.uniform_policy(game, 0)).max() > project.NEAR


@pytest.mark.parametrize("seed", range(8))
def test_cases_tell_all_mistakes_apart(seed: int) -> None:
    """No two of them give the same in all cases, and none gives what is right."""
    pairs = [gains.exploitability(pair) for pair in gains.pairs(seed)]
    mixed = [gains.mixed(payoffs) for payoffs in gains.games_of(seed)]
    for cases in (pairs, mixed):
        given = {tuple(round(case[mistake], 9) for case in cases) for mistake in cases[0]}
        assert len(given) == len(cases[0])
    updates = [
        np.concatenate([part.ravel() for case in update.cases_of(seed) for part in exercises._after(case, mistake)])
        for mistake in ({}, *update.UPDATE_MISTAKES.values())
    ]
    for one, other in itertools.combinations(updates, 2):
        assert not np.allclose(one, other)


def test_claims() -> None:
    """Each is about the game and the players that it names."""
    names = [*methods.NO_SAFE_ACTION, *methods.DOMINANT]
    by_matrix = {
        name: finals({method: [i + k / 10] * 2 for k, method in enumerate(methods.LEARNERS)})
        for i, name in enumerate(names)
    }
    found = measured(experiments.matrix_claims(by_matrix))
    assert found == [0.0, 0.1, 0.2, 1.0, 1.1, 1.2, 2.0, 2.1, 2.2, 3.0, 4.0, 5.0]
    changed = {"one": {True: [3.0, 5.0], False: [0.0, 0.1]}}
    assert measured(experiments.change_claims(changed)) == [4.0, 0.05]
    by_field = {
        name: finals({methods.ALONE: [0.4 + i] * 2, methods.MINIMAX: [0.1] * 2, methods.FICTITIOUS: [0.3] * 2})
        for i, name in enumerate(experiments.SETTINGS)
    }
    control = finals({methods.ALONE: [0.01] * 2, methods.MINIMAX: [0.02] * 2})
    lesson = made_up({methods.TAUGHT: [{10: 0.5}] * 2})
    found = measured(experiments.soccer_claims(by_field, control, lesson))
    assert found == [0.1, 0.3, 0.1, 1.3, 0.1, 2.3, 0.01, 0.02, 0.5, 0.3]
    turns = finals({methods.ALONE: [0.01] * 2, methods.MINIMAX: [0.02] * 2, methods.TOLD: [0.0] * 2})
    assert measured(experiments.turn_claims({"in turns": turns})) == [0.01, -0.01, -0.02]


def test_pupil() -> None:
    """A safe policy is a best answer to a safe opponent everywhere; where another is not, it gets one."""
    known, safe = methods.soccer(), methods.solution().policies[0]
    share, corrected = methods.with_best_answers(known, safe)
    assert share == 1.0
    assert (corrected == safe).all()
    never_moves = np.eye(5)[[STAND] * len(safe)]
    share, corrected = methods.with_best_answers(known, never_moves)
    assert 0 < share < 1
    assert methods.with_best_answers(known, corrected)[0] == 1.0
    assert methods.can_lose(known, 0, corrected) < methods.can_lose(known, 0, never_moves)
    agents = {methods.TAUGHT: [(methods.independent(known.game, 0, 10),)] * 2}
    pupils = made_up({methods.TAUGHT: [{10: 0.5}] * 2}, agents=agents)
    wrong, lost = measured(experiments.pupil_claims(pupils))
    assert 0 < wrong < 1
    assert 0 < lost < 1


def test_told_whose_turn() -> None:
    """What one action of the player who moves brings is learned for all actions of the other, and nothing else."""
    game = methods.in_turns().game
    for player in (0, 1):
        learner = methods.told(game, player, 1_000)
        learner.learn(player, 2, 3, 0.5, 4, True)  # the state of this number is one in which this player moves
        learner.learn(1 - player, 2, 3, 0.5, 4, True)
        Q = learner.learner.Q
        assert (Q[player, 2] < 1).all()
        assert (np.delete(Q[player], 2, axis=0) == 1).all()
        assert (Q[1 - player, :, 3] < 1).all()
        assert (np.delete(Q[1 - player], 3, axis=1) == 1).all()


def test_soccer_in_turns() -> None:
    """Only the player whose turn it is moves, and contact costs the ball as in soccer."""
    game, rng = methods.in_turns().game, np.random.default_rng(0)
    state = FieldInTurn(Field(6, 7, 0), 0)
    moved = game.transition(state, (EAST, WEST), rng)
    assert moved == (Field(6, 7, 1), 1)
    after = game.transition(moved, (STAND, NORTH), rng)
    assert after == (Field(6, 2, 1), 0)
    assert game.rewards(state, (EAST, WEST), after, rng) == (0.0, 0.0)
    goal = game.transition(FieldInTurn(Field(9, 6, 0), 0), (EAST, STAND), rng)
    assert game.terminal(goal)
    assert game.rewards(state, (EAST, STAND), goal, rng) == (1.0, -1.0)
    fields = [FieldInTurn(Field(a, a - 1, ball), turn) for a in range(1, 20) for ball in (0, 1) for turn in (0, 1)]
    seen = {game.observation(one, 0, rng) for one in fields}
    assert len(seen) == len(fields)
    assert max(seen) < game.observation_space(0).n <= 1.1 * max(seen)
    assert game.action_names == game.soccer.action_names
