"""The loops of training: the textbook's, in chunks, compiled or not, for the package's agents and students' own."""

import math
from typing import Any

import gymnasium
import numpy as np
import pytest

from edugym import SARSA, EpsilonGreedy, LinearDecay, QLearning, ScheduledEpsilonGreedy, make_mdp, train
from edugym.compiled import execution
from edugym.mdp.protocol import Random, Reals
from edugym.training import trainers
from tests.training.tasks import SlipperyWalk, Stairs, StudentsQLearning, StudentsSarsa, tell_tale

pytestmark = pytest.mark.usefixtures("compiled_at_once")


@pytest.fixture
def compiled_loops(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The names of the loops that `train` has compiled in this test."""
    names: list[str] = []
    original = execution.executable

    def noted(loop: Any, *arguments: Any, **options: Any) -> Any:
        fast = original(loop, *arguments, **options)
        if fast is not loop:
            names.append(loop.__name__)
        return fast

    monkeypatch.setattr(trainers, "executable", noted)
    return names


@pytest.mark.parametrize("chunk", [1, 7, 6_000])
def test_many_small_chunks_are_one_call(chunk: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Where the loop is cut does not show, compiled or not."""
    mdp, tables = SlipperyWalk(), []
    for size in (100_000, chunk):
        monkeypatch.setattr(trainers, "FIRST_STEPS", size)
        monkeypatch.setattr(trainers, "CALL_SECONDS", math.nan)  # no call is too long or too short
        agents: list[Any] = [QLearning.create(mdp), StudentsSarsa(np.zeros((7, 2)))]
        for n_steps in (500, 6_000):
            runs = [train(mdp, agent, n_steps, evaluate_every=n_steps, seed=5) for agent in agents]
            tables.append([*(agent.Q.copy() for agent in agents), *(run.episodes for run in runs)])
    for one, other in zip(tables[:2], tables[2:], strict=True):
        assert all(map(np.array_equal, one, other))


@pytest.mark.parametrize("most", [0, 900, 10**9])
def test_how_many_episodes_are_played_in_one_call_does_not_show(most: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Evaluation gives the same returns in calls of any length; without `greedy` each episode has its own copy."""
    mdp, calls = SlipperyWalk(), []
    original = trainers.MDPTrainer.play_episodes

    def counted(self: Any, at_most: int) -> list[float]:
        returns = original(self, at_most)
        calls.append(len(returns))
        return returns

    def curves() -> list[Any]:
        agents: list[Any] = [QLearning.create(mdp), StudentsSarsa(np.zeros((7, 2)))]
        how: dict[str, Any] = {"evaluate_every": 2_000, "evaluation_episodes": 9, "max_steps": 100, "seed": 5}
        return [train(mdp, agent, 6_000, **how).returns for agent in agents]

    expected = curves()
    monkeypatch.setattr(trainers, "MOST_STEPS", most)
    monkeypatch.setattr(trainers.MDPTrainer, "play_episodes", counted)
    assert all(map(np.array_equal, curves(), expected))
    assert max(calls[: -4 * 9]) == (1 if most == 0 else 9)
    assert set(calls[-4 * 9 :]) == {1}


def test_short_and_long_runs_agree(compiled_loops: list[str]) -> None:
    """The first 3 000 steps give the same points, whether they are interpreted or the half of 6 000 compiled ones."""

    class Own(StudentsQLearning):
        """New here, and so not compiled by any test before."""

        __slots__ = ()

    mdp = SlipperyWalk()
    short = train(mdp, Own(np.zeros((7, 2))), 3_000, evaluate_every=1_000, seed=8)
    assert not compiled_loops
    long = train(mdp, Own(np.zeros((7, 2))), 6_000, evaluate_every=1_000, seed=8)
    assert compiled_loops == ["play_episodes", "off_policy"]
    for attribute in ("returns", "training_returns", "episodes"):
        assert np.array_equal(getattr(short, attribute), getattr(long, attribute)[:4], equal_nan=True)


def test_a_students_agent_is_the_packages(compiled_loops: list[str]) -> None:
    """Ten lines, a `learn` of five arguments, no `create` and no `greedy`: the same Q-learning, compiled."""
    mdp = SlipperyWalk()
    own = StudentsQLearning(np.zeros((7, 2)))
    train(mdp, own, 10_000, seed=2)
    assert compiled_loops == ["play_episodes", "off_policy"]
    ours = QLearning.create(mdp, learning_rate=0.3, discount=0.9, exploration=EpsilonGreedy(0.2))
    train(mdp, ours, 10_000, seed=2)
    assert pytest.approx(ours.Q, rel=1e-9) == own.Q


def streams(seed: int) -> tuple[Random, Random]:
    """The streams of environment and agent in a run with this seed."""
    environment_rng, agent_rng, _, _ = map(np.random.default_rng, np.random.SeedSequence(seed).spawn(4))
    return environment_rng, agent_rng


def sarsa_by_the_book(mdp: SlipperyWalk, n_steps: int, limit: int, seed: int) -> Reals:
    """The box of section 6.4, with a step limit after which an episode is cut off."""
    environment_rng, agent_rng = streams(seed)
    Q = np.zeros((7, 2))

    def epsilon_greedy(S: int) -> int:
        if agent_rng.random() < 0.2:
            return int(agent_rng.random() * 2)
        if Q[S, 0] == Q[S, 1]:
            return int(agent_rng.random() * 2 < 1.0)
        return int(Q[S].argmax())

    done = 0
    while True:
        S = mdp.initial(environment_rng)
        A = epsilon_greedy(S)
        for step in range(1, limit + 1):
            next_S = mdp.transition(S, A, environment_rng)
            R = mdp.reward(S, A, next_S, environment_rng)
            next_A = A if mdp.terminal(next_S) else epsilon_greedy(next_S)
            bootstrap = 0.0 if mdp.terminal(next_S) else Q[next_S, next_A]
            Q[S, A] = Q[S, A] + 0.3 * (R + 0.9 * bootstrap - Q[S, A])
            S, A = next_S, next_A
            done += 1
            if done == n_steps:
                return Q
            if mdp.terminal(S) or step == limit:
                break


@pytest.mark.parametrize("n_steps", [1, 2, 300, 8_000])
@pytest.mark.parametrize("limit", [1, 2, 7, 10_000])
def test_an_on_policy_agent_is_sarsa_by_the_book(n_steps: int, limit: int) -> None:
    """Choose before learning, bootstrap from the action chosen, also where the episode is cut off: the same bits."""
    agent = StudentsSarsa(np.zeros((7, 2)))
    train(SlipperyWalk(), agent, n_steps, max_steps=limit, evaluate_every=n_steps, seed=6)
    assert np.array_equal(agent.Q, sarsa_by_the_book(SlipperyWalk(), n_steps, limit, 6))


@pytest.mark.parametrize("n_steps", [100, 10_000])
@pytest.mark.parametrize(("limit", "terminated", "truncated"), [(None, 1 / 3, 0), (3, 1 / 3, 0), (2, 0, 1 / 2)])
def test_truncation_is_told_apart_from_termination(
    n_steps: int, limit: int | None, terminated: float, truncated: float
) -> None:
    """`max_steps` cuts an episode off; an end at the very step of the limit is an end."""
    agent = tell_tale()
    run = train(Stairs(), agent, n_steps, max_steps=limit)
    assert agent.told.tolist() == [n_steps, int(n_steps * terminated), int(n_steps * truncated), 0]
    assert run.episodes.sum() == agent.told[1] + agent.told[2]
    assert run.returns[-1] == (3.0 if limit == 2 else 6.0)  # evaluation is cut off too


def test_max_steps_takes_the_place_of_the_environments_own_limit() -> None:
    """Boulder of height 4 has a limit of 40 steps; the agent takes the wrong grip or the right one, always the same."""
    mdp = make_mdp("Boulder", height=4)
    for limit, episodes in ((None, 1_000 // 40), (7, 1_000 // 7), (500, 2)):
        agent = tell_tale()
        assert train(mdp, agent, 1_000, max_steps=limit).episodes.sum() == episodes
        assert agent.told[2] == episodes


def test_an_error_in_a_students_agent_shows_its_line(compiled_loops: list[str]) -> None:
    """Also one that comes only after a thousand steps of machine code, and the tables are as they were then."""

    class Breaks(StudentsQLearning):
        __slots__ = ()

        def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool) -> None:
            self.Q[0, 0] += 1.0
            self.Q[int(self.Q[0, 0]) // 1_000, 1] = 1.0

    agent = Breaks(np.zeros((7, 2)))
    with pytest.raises(IndexError, match="index 7 is out of bounds") as error:
        train(SlipperyWalk(), agent, 100_000)
    assert compiled_loops == ["play_episodes", "off_policy"]
    assert "self.Q[int(self.Q[0, 0]) // 1_000, 1] = 1.0" in str(error.traceback[-1].statement)
    assert agent.Q[0, 0] == 7_000.0


class Unchanged(gymnasium.Wrapper[Any, Any, Any, Any]):
    """A wrapper that `train` does not know: it trains in the Gymnasium environment itself."""


@pytest.mark.parametrize("kind", [SARSA, QLearning])
@pytest.mark.parametrize("wrapped", [False, True])
def test_a_schedule_counts_the_actions_that_are_taken(kind: Any, wrapped: bool) -> None:
    """A decay is as fast for on-policy agents as for others: nobody chooses an action in a terminal state."""
    env = gymnasium.make("edugym/Boulder-v0", height=1, max_steps=10_000)
    exploration = ScheduledEpsilonGreedy.create(LinearDecay(1.0, 0.5, 1_000))
    task = Unchanged(env) if wrapped else env
    train(task, kind.create(env, exploration=exploration), 500)
    assert exploration.step[0] == 500 + (kind is SARSA)  # which has also chosen the action after the last step
