"""What agents without a table are shown and told in training: arrays as they are, or vectors."""

from typing import Any

import numpy as np
import pytest
from gymnasium import spaces

from edugym import LinearQLearning, train
from tests.compiled.cells import cell

TWO, FORCE = spaces.Discrete(2), spaces.Box(-9.0, 9.0, (2,), np.float32)
PLANE, BOARD = spaces.Box(-9.0, 9.0, (2,), np.float32), spaces.Box(-9.0, 9.0, (2, 2), np.float32)


DIARIES = """
class Diary(NamedTuple):  # an agent that writes down what it is told
    before: np.ndarray  # the observations before its steps
    after: np.ndarray
    told: np.ndarray  # the action, the reward, the next action, and the two kinds of end
    time: np.ndarray  # how many steps there were
    tabular: bool = False
    def act(self, state, rng): return 0
    def learn(self, state, action, reward, next_state, terminated, truncated):
        self.note(state, action, reward, next_state, 0, terminated, truncated)
    def note(self, state, action, reward, next_state, following, *ends):
        t = self.time[0] % len(self.before)
        self.before[t] = state
        self.after[t] = next_state
        self.told[t, 0] = action
        self.told[t, 1] = reward
        self.told[t, 2] = following
        self.told[t, 3] = 1.0 if ends[0] else 0.0
        self.told[t, 4] = 1.0 if ends[1] else 0.0
        self.time[0] += 1

class VectorDiary(Diary):  # takes vectors, on which its actions depend
    def act(self, state, rng): return int(np.argmax(state)) % 2
    n_inputs = property(lambda self: int(self.before.shape[1]))

class OnPolicyDiary(VectorDiary):  # is told its next action
    def learn(self, state, action, reward, next_state, next_action, terminated, truncated):
        first, following = np.ravel(action)[0], np.ravel(next_action)[0]
        self.note(state, first, reward, next_state, following, terminated, truncated)

class ForceDiary(VectorDiary):  # whose actions are arrays
    def act(self, state, rng): return np.array([np.argmax(state) % 2, 0.5], np.float32)
    def learn(self, state, action, reward, next_state, terminated, truncated):
        self.note(state, action[0], reward, next_state, 0, terminated, truncated)

class WritingDiary(ForceDiary):  # writes its actions into an array that it is given
    def act_into(self, state, rng, action): action[:] = ForceDiary.act(self, state, rng)
    def act(self, state, rng): raise NotImplementedError

class OnPolicyForceDiary(OnPolicyDiary):  # writes in evaluation only: while it learns, an action is kept for later
    act, act_into = ForceDiary.act, WritingDiary.act_into
"""
RINGS = """
class Ring(NamedTuple):  # three states in a ring, the last one terminal; shows an element of a space for each
    observation_space: object
    shown: tuple
    action_space: object = spaces.Discrete(2)
    max_steps = property(lambda self: 3)
    def initial(self, rng): return int(rng.random() * 2)
    def transition(self, state, action, rng): return int(state + 1 + np.ravel(action)[0] + int(rng.random() * 2)) % 3
    def reward(self, state, action, next_state, rng): return float(10 * state + np.sum(action))
    def terminal(self, state): return state == 2
    def observation(self, state, rng): return self.shown[state]

class RingInPlace(Ring):
    def observe_into(self, state, rng, out): out[...] = self.shown[state]
"""
AGENTS, TASKS = cell(DIARIES), cell(RINGS)


def written(kind: str, *shape: int) -> Any:
    """A diary for 40 observations of a shape."""
    return AGENTS[kind](np.zeros((40, *shape)), np.zeros((40, *shape)), np.zeros((40, 5)), np.zeros(1, np.int64))


PAIR = spaces.Tuple((spaces.Discrete(2, start=5), spaces.Discrete(3, start=-1)))
SEEN: dict[str, Any] = {
    "a vector": (PLANE, [np.array([1, 2.0]), np.array([4, 3.0]), np.ones(2)], [[1, 2], [4, 3], [1, 1]]),
    "a tuple of reals": (PLANE, [(1.0, 2.0), (4.0, 3.0), (1.0, 1.0)], [[1, 2], [4, 3], [1, 1]]),
    "a number": (spaces.Box(-9.0, 9.0, (), np.float32), [1.5, -2.5, 0.0], [[1.5], [-2.5], [0]]),
    "a board": (
        BOARD,
        [np.array([[1.0, 2.0], [3.0, 4.0]]), np.eye(2), np.ones((2, 2))],
        [[1, 2, 3, 4], [1, 0, 0, 1], [1, 1, 1, 1]],
    ),
    "a whole number": (spaces.Discrete(3, start=-1), [-1, 1, 0], [[1, 0, 0], [0, 0, 1], [0, 1, 0]]),
    "a pair": (PAIR, [(6, -1), (5, 1), (5, 0)], [[0, 1, 1, 0, 0], [1, 0, 0, 0, 1], [1, 0, 0, 1, 0]]),
    "several": (
        spaces.MultiDiscrete([2, 3], start=[0, 4]),
        [np.array([1, 4]), np.array([0, 6]), np.array([0, 5])],
        [[0, 1, 1, 0, 0], [1, 0, 0, 0, 1], [1, 0, 0, 1, 0]],
    ),
}


@pytest.mark.parametrize(
    ("task", "name", "kind"),
    [
        *(("Ring", name, "VectorDiary") for name in SEEN),
        *(("RingInPlace", name, "VectorDiary") for name in SEEN if name not in ("a number", "a pair")),
        ("Ring", "a vector", "OnPolicyDiary"),
        ("Ring", "a vector", "ForceDiary"),
        ("Ring", "a vector", "WritingDiary"),
        ("RingInPlace", "a whole number", "WritingDiary"),
        ("RingInPlace", "a board", "OnPolicyForceDiary"),
    ],
)
@pytest.mark.filterwarnings("ignore:.* interpreted")
def test_what_is_told_is_what_happened(task: str, name: str, kind: str) -> None:
    """Observations before and after a step, each as a vector and not overwritten by the next, actions and ends."""
    space, shown, vectors = SEEN[name]
    acts = FORCE if "Force" in kind or "Writing" in kind else TWO
    agent = written(kind, len(vectors[0]))
    train(TASKS[task](space, tuple(shown), acts), agent, 40, seed=1)
    place, steps, expected = {tuple(vector): s for s, vector in enumerate(vectors)}, 0, None
    for before, after, told in zip(agent.before.tolist(), agent.after.tolist(), agent.told.tolist(), strict=True):
        state, next_state, steps = place[tuple(before)], place[tuple(after)], steps + 1
        action, reward, next_action, terminated, truncated = told
        assert state == expected or (expected is None and state in (0, 1))
        assert action == np.argmax(before) % 2
        assert (next_state - state - 1 - action) % 3 in (0, 1)
        assert reward == 10 * state + action + (0.5 if acts is FORCE else 0.0)
        assert (terminated, truncated) == (next_state == 2, steps == 3 and next_state != 2)
        if "OnPolicy" in kind and not terminated:
            assert next_action == np.argmax(after) % 2
        expected, steps = (None, 0) if terminated or truncated else (next_state, steps)
    assert len(set(map(tuple, agent.before.tolist()))) == 2
    assert agent.told[:, 3:].any(axis=0).all()


def test_boards_stay_boards() -> None:
    """For an agent that takes what the task shows."""
    space, shown, vectors = SEEN["a board"]
    for task in ("Ring", "RingInPlace"):
        agent = written("Diary", 2, 2)
        train(TASKS[task](space, tuple(shown)), agent, 40, seed=1)
        assert {tuple(board.ravel().tolist()) for board in agent.before} == set(map(tuple, vectors[:2]))
        assert {tuple(board.ravel().tolist()) for board in agent.after} == set(map(tuple, vectors))


WRONG = """
class Wrong(NamedTuple):  # no agent but in its sizes
    n_inputs: int = 4
    n_actions: int = 2
    tabular: bool = False
    def act(self, state, rng): return 0
    def learn(self, state, action): pass
"""


@pytest.mark.parametrize(
    ("actions", "name", "needed"),
    [(TWO, "n_actions", 2), (spaces.Box(0, 1, (3, 2)), "n_actions", 6), (TWO, "n_inputs", 4)],
)
def test_an_agent_of_another_size_is_refused(actions: Any, name: str, needed: int) -> None:
    """The message says which size the environment has."""
    task = TASKS["Ring"](BOARD, tuple(SEEN["a board"][1]), actions)
    fits = cell(WRONG)["Wrong"](n_actions=6 if needed == 6 else 2)
    for given in (needed - 1, needed + 1):
        other: Any = {name: given}
        with pytest.raises(ValueError, match=f"agent must be one for {name} = {needed}, .* but its is {given}$"):
            train(task, fits._replace(**other), 10)
    if actions is TWO:
        train(task, fits, 10)


def test_texts_are_no_vectors() -> None:
    """Which is said where the agent is made."""
    with pytest.raises(ValueError, match="a vector needs observations that are numbers"):
        LinearQLearning.create(TASKS["Ring"](spaces.Text(5), ()))


@pytest.mark.parametrize("seen", [None, 0.5, (0.5,), np.zeros((2, 1))])
def test_an_observation_of_another_shape_is_refused(seen: Any) -> None:
    """It would be stretched to fit, or become NaN."""
    mdp = TASKS["Ring"](PLANE, (seen,) * 3)
    with pytest.raises(ValueError, match="observation of Ring must give what its observation_space says, Box"):
        train(mdp, LinearQLearning.create(mdp), 10)
