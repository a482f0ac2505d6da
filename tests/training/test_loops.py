"""The loops of training are the textbook's, however a run is cut into pieces, interpreted or compiled."""

import traceback
from typing import Any

import gymnasium
import numpy as np
import pytest

from edugym import (
    SARSA,
    EpsilonGreedy,
    LinearDecay,
    MDPEnv,
    QLearning,
    ScheduledEpsilonGreedy,
    make_mdp,
    train,
)
from edugym.compiled import execution
from edugym.compiled.compiler import compiled
from edugym.mdp.protocol import Reals
from tests.compiled.cells import LEARNER, cell
from tests.training.slips import VALUE, changed
from tests.training.tasks import (
    Ring,
    SlipperyWalk,
    Stairs,
    StudentsQLearning,
    StudentsSarsa,
    interpret,
    tell_tale,
)

pytestmark = pytest.mark.usefixtures("compiled_at_once")


@pytest.fixture
def compiled_loops(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The names of the loops that are compiled in this test."""
    names: list[str] = []

    def noted(loop: Any, *arguments: Any, **options: Any) -> Any:
        names.append(loop.__name__)
        return compiled(loop, *arguments, **options)

    monkeypatch.setattr(execution, "compiled", noted)
    return names


def trained(agent: Any, n_steps: int = 6_000, **how: Any) -> list[Any]:
    """What a run has learned, and its curve."""
    run = train(SlipperyWalk(), agent, n_steps, **{"seed": 5, "evaluate_every": 1_000, **how})
    return [agent.Q, run.returns, run.training_returns, run.episodes]


def equal(one: list[Any], other: list[Any]) -> bool:
    """Whether all numbers are the same."""
    return all(np.array_equal(a, b, equal_nan=True) for a, b in zip(one, other, strict=True))


def scheduled(kind: Any) -> Any:
    """An agent that explores less and less."""
    return kind.create((7, 2), exploration=ScheduledEpsilonGreedy.create(LinearDecay(1.0, 0.0, 2_000)))


AGENTS = {
    "off-policy": lambda: scheduled(QLearning),
    "on-policy, without greedy": lambda: StudentsSarsa(np.zeros((7, 2))),
    "a student's, without greedy": lambda: StudentsQLearning(np.zeros((7, 2))),
}
each_agent = pytest.mark.parametrize("make", AGENTS.values(), ids=AGENTS)


@each_agent
def test_compiled_is_interpreted(make: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """Bit for bit; a run of half the length is the first half."""
    compiled = trained(make())
    interpret(monkeypatch)
    assert equal(trained(make()), compiled)
    assert equal([part[:4] for part in trained(make(), 3_000)[1:]], [part[:4] for part in compiled[1:]])


@each_agent
def test_neither_cuts_nor_evaluation_change_what_is_learned(make: Any) -> None:
    """However often, however long and with which limit an agent is evaluated; also where a run is interpreted."""
    runs = []
    for n_steps in (1_200, 6_000):
        for every, episodes in ((n_steps, 1), (60, 1), (7, 3)):
            agent = make()
            run = train(SlipperyWalk(), agent, n_steps, evaluate_every=every, evaluation_episodes=episodes)
            runs.append((n_steps, agent.Q.tobytes(), run.episodes.sum()))
            if hasattr(agent, "exploration"):
                assert agent.exploration.step[0] == n_steps
    assert len(set(runs)) == 2
    curves = [trained(make(), evaluation_episodes=9, max_steps=limit)[1] for limit in (400, 20_000)]
    assert equal(curves[:1], curves[1:])  # several episodes in one call of machine code, or one


def test_a_students_agent_is_the_packages() -> None:
    """Ten lines, a `learn` of five arguments, no `create` and no `greedy`: the same Q-learning."""
    own, settings = StudentsQLearning(np.zeros((7, 2))), {"learning_rate": 0.3, "discount": 0.9}
    ours = QLearning.create(SlipperyWalk(), **settings, exploration=EpsilonGreedy(0.2))
    for agent in (own, ours):
        train(SlipperyWalk(), agent, 10_000, seed=2)
    assert pytest.approx(ours.Q, rel=1e-9) == own.Q


def sarsa_by_the_book(mdp: Any, n_steps: int, limit: int, seed: int) -> Reals:
    """The box of section 6.4, with a step limit after which an episode is cut off."""
    environment_rng, agent_rng, _, _ = map(np.random.default_rng, np.random.SeedSequence(seed).spawn(4))
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


@pytest.mark.parametrize(("n_steps", "limit"), [(300, 1), (300, 7), (300, 10_000), (8_000, 2), (8_000, 10_000)])
def test_an_on_policy_agent_is_sarsa_by_the_book(n_steps: int, limit: int) -> None:
    """Choose before learning, bootstrap from the action chosen, also where the episode is cut off: the same bits."""
    agent = StudentsSarsa(np.zeros((7, 2)))
    train(SlipperyWalk(), agent, n_steps, max_steps=limit, evaluate_every=n_steps, seed=6)
    assert np.array_equal(agent.Q, sarsa_by_the_book(SlipperyWalk(), n_steps, limit, 6))


@pytest.mark.parametrize("n_steps", [102, 10_002])
@pytest.mark.parametrize(("limit", "ended", "cut"), [(None, 1 / 3, 0), (3, 1 / 3, 0), (2, 0, 1 / 2)])
@pytest.mark.parametrize("wrapped", [False, True], ids=["MDP", "Gymnasium"])
def test_truncation_is_told_apart(wrapped: bool, n_steps: int, limit: int | None, ended: float, cut: float) -> None:
    """`max_steps` cuts an episode off; an end at the very step of the limit is an end."""
    agent = tell_tale()
    task = gymnasium.Wrapper(MDPEnv(Stairs())) if wrapped else Stairs()
    run = train(task, agent, n_steps, max_steps=limit)
    assert agent.told.tolist() == [n_steps, int(n_steps * ended), int(n_steps * cut), 0]
    assert run.episodes.sum() == agent.told[1] + agent.told[2]
    assert run.returns[-1] == (3.0 if limit == 2 else 6.0)  # evaluation is cut off too


def test_max_steps_takes_the_place_of_the_environments_own_limit() -> None:
    """Boulder of height 4 has a limit of 40 steps; the agent takes the wrong grip or the right one, always the same."""
    for limit, episodes in ((None, 1_000 // 40), (7, 1_000 // 7), (500, 2)):
        agent = tell_tale()
        assert train(make_mdp("Boulder", height=4), agent, 1_000, max_steps=limit).episodes.sum() == episodes
        assert agent.told[2] == episodes


def test_an_error_in_a_students_agent_shows_its_line(compiled_loops: list[str]) -> None:
    """Also one that comes only after a thousand steps of machine code, and the tables are as they were then."""
    line = "self.Q[int(self.Q[0, 0]) // 1_000, 1] = 1.0"
    Breaks = cell(changed(LEARNER, VALUE, f"self.Q[0, 0] += 1.0; {line}; return\n        {VALUE}"))["Learner"]
    train(SlipperyWalk(), Breaks(np.zeros((7, 2))), execution.COMPILE_FROM - 1)
    assert not compiled_loops
    agent = Breaks(np.zeros((7, 2)))
    with pytest.raises(IndexError, match="index 7 is out of bounds") as error:
        train(SlipperyWalk(), agent, 100_000)
    assert len(compiled_loops) == 2
    assert line in (traceback.extract_tb(error.tb)[-1].line or "")
    assert agent.Q[0, 0] == 7_000.0


@pytest.mark.parametrize("kind", [SARSA, QLearning])
@pytest.mark.parametrize("wrapped", [False, True])
def test_a_schedule_counts_the_actions_that_are_taken(kind: Any, wrapped: bool) -> None:
    """A decay is as fast for on-policy agents as for others: nobody chooses an action in a terminal state."""
    env = gymnasium.make("edugym/Boulder-v0", height=1, max_steps=10_000)
    agent = scheduled(kind)._replace(Q=np.zeros((2, 2)))
    train(gymnasium.Wrapper(env) if wrapped else env, agent, 500)
    assert agent.exploration.step[0] == 500 + (kind is SARSA)  # which has also chosen the action after the last step


class Clock:
    """An order to stop, which never comes, and notes when it is asked for; each step takes `seconds`."""

    def __init__(self, agent: Any, seconds: float) -> None:
        """See the class."""
        self.agent, self.seconds, self.asked = agent, seconds, [0]

    def now(self) -> float:
        """The time."""
        return self.seconds * float(self.agent.told[0])

    def is_set(self) -> bool:
        """No."""
        if self.agent.told[0] > self.asked[-1]:
            self.asked.append(int(self.agent.told[0]))
        return False

    def set(self) -> None:
        """It cannot be."""


@pytest.mark.parametrize(
    ("seconds", "pieces"),
    [
        (1e-9, [50, 100, 50, 200, 400, 800]),  # twice as many while that is fast; after 200 the checks end
        (2**-12, [50, 50, 50, 50, 50]),  # more than half of the time that a piece may take
        (2**-10, [50, 20, 20, 20]),
        (9.0, [50, 1, 1, 1]),  # never none
    ],
)
def test_how_often_it_looks_for_an_order_to_stop(seconds: float, pieces: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """About every fiftieth of a second, however long a step takes."""
    agent = tell_tale()
    clock = Clock(agent, seconds)
    monkeypatch.setattr("time.perf_counter", clock.now)
    train(Ring(), agent, 4_000, evaluate_every=4_000, stop=clock)
    assert np.diff(clock.asked)[: len(pieces)].tolist() == pieces
