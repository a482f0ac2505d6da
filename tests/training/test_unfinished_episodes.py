"""A run that stops within an episode leaves nothing of it to the next run, wherever that begins."""

import copy
import inspect
from typing import Any

import numpy as np
import pytest

from edugym import QLearning, record_visits, train
from tests.agents.cases import AGENTS, Case, same
from tests.compiled.cells import cell
from tests.training.tasks import Ring

REMEMBERING = {
    label: case for label, case in AGENTS.items() if hasattr(case.kind, "forget_episode") and not case.vectors
}
"""Those with tables, for the ring has no vectors to see."""
remembering = pytest.mark.parametrize("case", REMEMBERING.values(), ids=REMEMBERING)


def memory_of(agent: Any) -> list[str]:
    """The fields in which an agent keeps the episode under way: those that it changes when it forgets it."""
    before = copy.deepcopy(agent)
    agent.forget_episode()
    return [name for name in agent._fields if not same(getattr(before, name), getattr(agent, name))]


@remembering
def test_a_run_that_was_stopped_leaves_nothing(case: Case) -> None:
    """After two steps the ring is back in its first state, where the next run begins: as for a fresh agent."""
    agent = case.create(Ring())
    train(Ring(), agent, 2)
    memory = memory_of(copy.deepcopy(agent))
    assert memory
    tables = [name for name in agent._fields if name not in memory]
    fresh = case.create(Ring())._replace(**{name: copy.deepcopy(getattr(agent, name)) for name in tables})
    for one in (agent, fresh):
        train(Ring(), one, 18, seed=1)
    assert all(same(getattr(agent, name), getattr(fresh, name)) for name in tables)


@remembering
@pytest.mark.parametrize("ends", [(True, False), (False, True)], ids=["terminated", "truncated"])
def test_an_episode_that_has_ended_leaves_nothing(case: Case, ends: tuple[bool, bool]) -> None:
    """An agent that is told to forget it as well learns nothing else in the next one."""
    agents = [case.create(Ring()) for _ in range(2)]
    for agent in agents:
        rng, takes = np.random.default_rng(1), inspect.signature(agent.learn).parameters
        for step in range(7):
            agent.act(step % 2, rng)
            terminated, truncated = ends if step == 3 else (False, False)
            told = {"state": step % 2, "action": 1, "reward": 2.0 + step, "next_state": 1 - step % 2, "next_action": 1}
            told |= {"terminated": terminated, "truncated": truncated}
            agent.learn(**{name: value for name, value in told.items() if name in takes})
            if step == 3 and agent is agents[1]:
                agent.forget_episode()
    for name, one, other in zip(agents[0]._fields, *agents, strict=True):
        if name in ("Q", "preferences", "V"):
            assert one.any()
            np.testing.assert_allclose(one, other, rtol=1e-12)


@remembering
def test_what_records_an_agent_passes_it_on(case: Case) -> None:
    """With counts of its visits, the agent learns the same in two runs as without."""
    plain, watched = case.create(Ring()), case.create(Ring())
    recorder = record_visits(watched, Ring(), 20)
    for n_steps in (2, 18):
        train(Ring(), plain, n_steps)
        train(Ring(), recorder, n_steps)
    assert same(plain, watched)


STUDENT = """
class Student(NamedTuple):
    length: np.ndarray
    def act(self, state, rng): return 0
    def learn(self, state, terminated, truncated): self.length[0] += 1
    def forget_episode(self): self.length[0] = 0
"""


def test_an_agent_of_ones_own() -> None:
    """It is told in an MDP and in a Gymnasium environment; agents without the method are not asked."""
    for environment in (Ring(), "FrozenLake-v1"):
        agent = cell(STUDENT)["Student"](np.full(1, 1_000))
        train(environment, agent, 4)
        assert agent.length[0] == 4
    train(Ring(), QLearning.create(Ring()), 4)
