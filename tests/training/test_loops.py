"""The loops of training are the textbook's, however a run is cut into pieces, interpreted or compiled."""

import traceback
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from edugym import LinearDecay, QLearning, ScheduledEpsilonGreedy, make_mdp, train
from edugym.compiled import execution
from edugym.compiled.compiler import compiled
from tests.compiled.cells import LEARNER, cell
from tests.training.slips import VALUE, changed
from tests.training.tasks import Ring, SlipperyWalk, StudentsQLearning, StudentsSarsa, interpret, tell_tale

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


AGENTS: dict[str, Any] = {
    "off-policy": lambda: QLearning.create(
        (7, 2), exploration=ScheduledEpsilonGreedy.create(LinearDecay(1.0, 0.0, 2_000))
    ),
    "on-policy, without greedy": lambda: StudentsSarsa(np.zeros((7, 2))),
    "a student's, without greedy": lambda: StudentsQLearning(np.zeros((7, 2))),
}
each_agent = pytest.mark.parametrize(
    "make",
    [
        pytest.param(make, id=name, marks=[pytest.mark.slow] * name.startswith("a student's"))
        for name, make in AGENTS.items()
    ],
)


@each_agent
def test_compiled_is_interpreted(make: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """Bit for bit, with a limit that cuts episodes off; a run of half the length is the first half."""
    compiled = trained(make(), max_steps=9)
    interpret(monkeypatch)
    assert equal(trained(make(), max_steps=9), compiled)
    assert equal([part[:4] for part in trained(make(), 3_000, max_steps=9)[1:]], [part[:4] for part in compiled[1:]])


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
    """About every fiftieth of a second, however long a step takes; here it takes `seconds`."""
    agent, asked = tell_tale(), [0]

    def is_set() -> bool:
        if agent.told[0] > asked[-1]:
            asked.append(int(agent.told[0]))
        return False

    monkeypatch.setattr("time.perf_counter", lambda: seconds * float(agent.told[0]))
    train(Ring(), agent, 4_000, evaluate_every=4_000, stop=SimpleNamespace(is_set=is_set, set=None))
    assert np.diff(asked)[: len(pieces)].tolist() == pieces


SWINGER = """
class Swinger(NamedTuple):
    sums: np.ndarray
    tabular = False
    def act(self, state, rng):
        return 0.5 * rng.random() - 0.25 + 0.1 * state[2], 0.5 * rng.random() - 0.25
    def learn(self, state, action, reward, next_state):
        self.sums[0] += next_state[3] - state[2]
        self.sums[1] += action[0]
        self.sums[2] += action[1]
        self.sums[3] += reward
"""
"""It turns both joints at random, and sums up what it sees, does and gets."""
ARRAY = SWINGER.replace("return 0.5 *", "return np.array([0.5 *").replace("- 0.25\n    def", "- 0.25])\n    def")
ON_POLICY = ARRAY.replace("next_state):", "next_state, next_action):").replace("+= action[1]", "+= next_action[1]")


@pytest.mark.parametrize(
    "source",
    [pytest.param(SWINGER, id="tuples", marks=pytest.mark.slow), pytest.param(ON_POLICY, id="arrays, on-policy")],
)
def test_compiled_vectors_are_interpreted_ones(source: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """With observations and actions that are tuples or arrays of real numbers: the same sums."""
    one, other = agents = [cell(source)["Swinger"](np.zeros(4)) for _ in range(2)]
    for agent in agents:
        train(make_mdp("Trashbot"), agent, 6_000, seed=2, evaluate_every=3_000)
        interpret(monkeypatch)
    assert one.sums.tolist() == other.sums.tolist()
    assert one.sums.all()


PUSHER = SWINGER[: SWINGER.index("    def act")] + (
    "    def act(self, state, rng): return (0.5,)\n"
    "    def learn(self, action, reward): self.sums[0] += action[0] + (action == (0.5,))\n"
)


def test_a_gymnasium_environment_gets_arrays() -> None:
    """Of a tuple of numbers, where the environment asks for an array; the agent is told what it did."""
    agents: list[Any] = [cell(source)["Swinger"](np.zeros(4)) for source in (PUSHER, SWINGER)]
    assert train("Pendulum-v1", agents[0], 300).episodes.sum() == 1
    assert agents[0].sums[0] == 300 * 1.5
    train("edugym/Trashbot-v0", agents[1], 50)
    assert agents[1].sums[1:3].all()
