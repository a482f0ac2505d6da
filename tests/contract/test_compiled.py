"""Machine code does what the interpreter does, bit for bit, for every environment."""

import copy
from typing import Any, NamedTuple

import numpy as np
import pytest
from gymnasium import spaces

from edugym.adapters.fitting import tabular
from edugym.adapters.registration import ENVIRONMENTS, Entry, make_mdp
from edugym.agents.q_learning import QLearning
from edugym.checks.contract import learner
from edugym.checks.interfaces import step_limit
from edugym.compiled.compiler import compiled
from edugym.mdp.protocol import Random
from edugym.training.evaluated import GreedyActor
from edugym.training.loops import off_policy, on_policy, play_episodes, start_off_policy, start_on_policy
from edugym.training.trainers import new_log
from tests.contract.parameters import Keywords
from tests.contract.play import CORNERS, plain

N_STEPS = 2_000
CORNERS_TO_COMPILE = [
    pytest.param(entry, corner, id=f"{entry.name}-{corner or 'defaults'}", marks=pytest.mark.slow if image else ())
    for entry, corner in CORNERS
    for image in [entry.name == "Catch" and corner.get("observation_type") != "vectorised"]
]
"""Code that makes arrays takes ten times as long to compile."""


class Witness(NamedTuple):
    """An on-policy agent that acts at random and writes down everything that it is told.

    Attributes:
        n_actions: how many actions there are.
        time: shape (1,): how much was written down.
        seen, next_seen: shape (N_STEPS, ...): the observations before and after the step.
        told: shape (N_STEPS, 5): the action, the reward, the next action, and the two kinds of end.
    """

    n_actions: int
    time: Any
    seen: Any
    next_seen: Any
    told: Any

    def act(self, state: Any, rng: Random) -> int:
        """Any action."""
        return int(rng.random() * self.n_actions)

    def learn(
        self,
        state: Any,
        action: int,
        reward: float,
        next_state: Any,
        next_action: int,
        terminated: bool,
        truncated: bool,
    ) -> None:
        """Write it down."""
        t = self.time[0]
        self.seen[t] = state
        self.next_seen[t] = next_state
        self.told[t, 0] = action
        self.told[t, 1] = reward
        self.told[t, 2] = next_action
        self.told[t, 3] = 1.0 if terminated else 0.0
        self.told[t, 4] = 1.0 if truncated else 0.0
        self.time[0] += 1


def witness(mdp: Any) -> Witness:
    """A witness of what happens in an MDP."""
    space = mdp.observation_space
    seen = np.zeros((N_STEPS, *(space.shape or ())), space.dtype)
    return Witness(int(mdp.action_space.n), np.zeros(1, np.int64), seen, seen.copy(), np.zeros((N_STEPS, 5)))


def as_table(entry: Entry, **keywords: Any) -> Any:
    """The MDP with its observations as rows of a table, or as it is where they do not fit one."""
    mdp = entry.load()(**keywords).mdp
    if not isinstance(mdp.action_space, spaces.Discrete):
        pytest.skip("agents in loops have whole numbers for actions")
    return mdp if isinstance(mdp.observation_space, spaces.Box) else tabular(mdp)


def bits(value: Any) -> Any:
    """A value that compares with ==, bit for bit: arrays as bytes, since those of pictures have millions of numbers."""
    if isinstance(value, tuple):
        return tuple(map(bits, value))
    return (value.dtype, value.shape, value.tobytes()) if isinstance(value, np.ndarray) else plain(value)


def both(loop: Any, n: int, *arguments: Any) -> tuple[Any, Any]:
    """What a loop gives and leaves in its arguments, interpreted and compiled."""
    outcomes = []
    for run in (loop, compiled(loop, n, *arguments)):
        mine = copy.deepcopy(arguments)
        given = run(n, *mine)
        outcomes.append(bits((given, mine)))
    return outcomes[0], outcomes[1]


@pytest.mark.parametrize(("entry", "keywords"), CORNERS_TO_COMPILE)
def test_on_policy(entry: Entry, keywords: Keywords) -> None:
    """The on-policy loop shows an agent the same, step by step."""
    mdp = as_table(entry, **keywords)
    agent, log, (rng, agent_rng, *others) = witness(mdp), new_log(), np.random.default_rng(1).spawn(4)
    moment = start_on_policy(mdp, agent, *others)
    arguments = (mdp, agent, step_limit(mdp) or 50, rng, agent_rng, log, moment)
    interpreted, machine_code = both(on_policy, N_STEPS, *arguments)
    assert interpreted == machine_code
    _, (_, seen, *_) = interpreted
    assert seen[1] == bits(np.array([N_STEPS]))


@pytest.mark.parametrize("name", ["Golf", "MemoryCorridor"])
def test_off_policy(name: str) -> None:
    """Q-learning learns the same table, and is evaluated alike; the loops know nothing of the task, so two will do."""
    mdp = tabular(make_mdp(name))
    agent, (rng, agent_rng, start_rng) = QLearning.create(mdp), np.random.default_rng(2).spawn(3)
    arguments = mdp, learner(agent), 50, rng, agent_rng, new_log(), start_off_policy(mdp, start_rng)
    interpreted, machine_code = both(off_policy, N_STEPS, *arguments)
    assert interpreted == machine_code
    off_policy(N_STEPS, *arguments)
    interpreted, machine_code = both(play_episodes, 20, mdp, GreedyActor(agent), 50, rng, agent_rng, np.zeros(20))
    assert interpreted == machine_code


@pytest.mark.parametrize(
    "entry",
    [pytest.param(one, id=one.name, marks=[pytest.mark.slow] * (one.name == "Catch")) for one in ENVIRONMENTS],
)
def test_chunks(entry: Entry) -> None:
    """A run in pieces of any size is the same as one run."""
    mdp, outcomes = as_table(entry), []
    for pieces in ([N_STEPS], [1, 2, 997, 700, 300]):
        agent, log, (rng, agent_rng) = witness(mdp), new_log(), np.random.default_rng(3).spawn(2)
        moment = start_on_policy(mdp, agent, rng, agent_rng)
        arguments = (mdp, agent, step_limit(mdp) or 50, rng, agent_rng, log)
        run = compiled(on_policy, N_STEPS, *arguments, moment)
        for n in pieces:
            moment = run(n, *arguments, moment)
        outcomes.append(bits((agent, log, moment, rng, agent_rng)))
    assert outcomes[0] == outcomes[1]
