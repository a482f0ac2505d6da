"""Go-Explore, step by step: the archive, the way back, the exploration, and what is learned in hindsight."""

from collections import defaultdict
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from edugym import GoExplore
from edugym.exact.branching import branches
from edugym.mdp.protocol import Reals

RNG = np.random.default_rng(0)


def explorer(n_states: int = 3, explore_steps: int = 2, longest: int = 10) -> GoExplore:
    """An agent for a small chain with the actions left and right, α = γ = 1/2."""
    how = {"learning_rate": 0.5, "discount": 0.5, "explore_steps": explore_steps}
    return GoExplore.create((n_states, 2), longest=longest, **how)


def walk(agent: GoExplore, *steps: tuple[int, int, int], reward: float = 0.0, **end: bool) -> None:
    """Act, then learn from (state, action, next state), whatever it would have done; `end` is of the last step."""
    for k, (state, action, next_state) in enumerate(steps):
        agent.act(state, RNG)
        last = k == len(steps) - 1
        agent.learn(state, action, reward, next_state, last and "terminated" in end, last and "truncated" in end)


def test_the_first_try_by_hand() -> None:
    """From 0 two random steps, right and right, to 2; only then it learns."""
    agent = explorer()
    agent.act(0, RNG)
    assert agent.visits.tolist() == [2, 0, 0]  # met, and chosen as the only goal there is
    assert (agent.now.goal[0], agent.now.explored[0]) == (0, 1)  # already there: exploring
    agent.learn(0, 1, 0.0, 1, False, False)
    assert not agent.Q.any()  # the try goes on
    agent.act(1, RNG)
    agent.learn(1, 1, 0.0, 2, False, False)
    assert agent.visits.tolist() == [2, 1, 1]
    assert agent.Q[1:, :, 1].tolist() == [[1 / 2, 0, 0], [1 / 8, 1 / 2, 0]]  # towards 1, and towards 2
    assert agent.now.length[0] == 0  # and the try is over


def test_it_returns_before_it_explores() -> None:
    """To the least visited state by the values for that goal, greedily; there it starts to count its random steps."""
    agent = explorer(4)
    agent.visits[:] = [5, 4, 1, 3]
    agent.Q[2] = [[0.0, 0.2], [0.0, 0.5], [0.0, 0.0], [0.9, 0.0]]
    agent.Q[3] = 7.0 - agent.Q[2]  # another goal's values, which would lead elsewhere
    explored = []
    for state, action, next_state in ((0, 1, 1), (1, 1, 2), (2, 1, 3), (3, 0, 2)):
        taken = agent.act(state, RNG)
        assert (taken, agent.now.goal[0]) == (action, 2) or state > 1
        explored.append(int(agent.now.explored[0]))
        agent.learn(state, action, 0.0, next_state, False, False)
    assert explored == [0, 0, 1, 2]  # once begun, it explores also where it is not at the goal
    assert agent.now.length[0] == 0
    assert agent.visits.tolist() == [5, 5, 4, 4]  # 2: chosen once, entered twice


def test_it_explores_evenly_and_returns_without_exploring() -> None:
    """Both actions come at the goal; on the way there only the best one does."""
    agent, rng, actions = explorer(explore_steps=1_000, longest=2_000), np.random.default_rng(1), []
    agent.Q[0] = [1.0, 0.0]
    for _ in range(400):
        actions.append(agent.act(0, rng))
        agent.learn(0, 1, 0.0, 0, False, False)
    assert abs(sum(actions) - 200) < 5 * 10  # five standard deviations of √(400/4)
    agent.now.explored[0], agent.now.goal[0] = 0, 0
    assert {agent.act(1, rng) for _ in range(200)} == {0}


def test_the_goal_is_the_least_visited_of_the_archive() -> None:
    """Among equals each is as likely; what was never visited is not in the archive."""
    for visits, goals in (([0, 2, 9], [1]), ([2, 0, 2], [0, 2]), ([1, 1, 1], [0, 1, 2])):
        agent, probabilities = explorer(), defaultdict[int, float](float)
        agent.visits[:] = visits
        for probability, goal in branches(agent.least_visited):
            probabilities[goal] += probability
        assert probabilities == pytest.approx(dict.fromkeys(goals, 1 / len(goals)))


@pytest.mark.parametrize("end", ["terminated", "truncated"])
def test_the_end_of_the_episode_ends_the_try(end: str) -> None:
    """On the way to its goal: what was met until then is learned, and the next action begins a new try."""
    agent = explorer()
    agent.visits[:] = [9, 9, 1]
    walk(agent, (0, 0, 0), (0, 1, 1), **{end: True})
    assert agent.Q[1, 0].tolist() == [(0.5 * 0.5) / 2, 1 / 2]  # the step before: γ max_a Q(1, 0, a) = 1/4
    assert agent.now.length[0] == 0
    agent.visits[:] = [1, 9, 9]
    agent.act(1, RNG)
    assert agent.now.goal[0] == 0


def test_a_try_is_no_longer_than_its_memory() -> None:
    """After `longest` steps it is learned from and a new one begins, far from the goal or not."""
    agent = explorer(longest=3)
    for n, length in enumerate((1, 2, 0, 1, 2, 0)):
        agent.visits[:] = [9, 9, 1]
        walk(agent, (0, 1, 1))
        assert agent.now.length[0] == length
        assert agent.Q[1, 0, 1] > 0 or n < 2


def test_it_exploits_the_best_reward_it_met() -> None:
    """It goes to where the best reward was met, the first of equals; a punishment is better than nothing."""
    agent = explorer()
    for reward, next_state, best in ((-5.0, 1, 1), (-7.0, 2, 1), (0.5, 2, 2), (0.5, 1, 2), (0.0, 0, 2)):
        walk(agent, (0, 0, next_state), reward=reward, terminated=True)
        assert agent.best_state[0] == best
    agent.Q[:2], agent.Q[2] = [1.0, 0.0], [0.0, 1.0]
    assert {agent.greedy(state, RNG) for state in range(3) for _ in range(20)} == {1}


def learned_in_hindsight(Q: Reals, steps: list[tuple[int, int, int]]) -> Reals:
    """The same as in the class's docstring, as one would write it without a thought for speed."""
    for last in range(len(steps)):
        goal = steps[last][2]
        for state, action, next_state in reversed(steps[: last + 1]):
            target = 1.0 if next_state == goal else 0.5 * max(Q[goal, next_state])
            Q[goal, state, action] += 0.5 * (target - Q[goal, state, action])
    return Q


chains: Any = st.lists(st.tuples(st.integers(0, 3), st.integers(0, 1), st.integers(0, 3)), min_size=1, max_size=8)


@given(st.lists(chains, min_size=1, max_size=3))
def test_hindsight_learns_backwards_for_every_state_met(tries: list[list[tuple[int, int, int]]]) -> None:
    """Against a straightforward reference, over several tries, with states met twice."""
    agent = explorer(4, explore_steps=100, longest=8)
    Q: Reals = np.zeros((4, 4, 2))
    for steps in tries:
        walk(agent, *steps, terminated=True)
        Q = learned_in_hindsight(Q, steps)
    assert np.array_equal(agent.Q, Q)
