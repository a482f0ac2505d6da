"""Learning in hindsight: the updates by hand, the goals that are drawn, and what it is for, with controls that fail."""

from collections import defaultdict
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import edugym as eg
from edugym.agents.dqn import ReplayMemory
from edugym.exact.branching import branches
from edugym.mdp.protocol import Reals
from edugym.training import trainers
from tests.agents.cases import same
from tests.messages import named

RNG = np.random.default_rng(0)
STRATEGIES = [eg.NoHindsight(), eg.FinalGoal(), eg.FutureGoals(1), eg.FutureGoals(3)]
HALVES: dict[str, Any] = {"learning_rate": 0.5, "discount": 0.5, "reward_at_goal": 2.0, "reward_elsewhere": -1.0}


def row(state: int, goal: int) -> int:
    """The row of a table for a state and a goal, where there are four of each."""
    return 4 * state + goal


def for_four(**settings: Any) -> eg.HindsightQLearning:
    """A table for four states, which are the goals, and two actions; α = γ = 1/2."""
    return eg.HindsightQLearning.create((16, 2), n_goals=4, **HALVES, **settings)


def test_an_episode_by_hand() -> None:
    """From 0 to 2 and to 1, with the goal 3, which it misses: then it learns how to reach 1, the last step first."""
    agent = for_four(hindsight=eg.FinalGoal())
    agent.learn(row(0, 3), 0, -1.0, row(2, 3), False, False)
    assert agent.Q[row(0, 3)].tolist() == [-1 / 2, 0]
    assert np.count_nonzero(agent.Q) == 1  # the episode goes on
    agent.learn(row(2, 3), 1, -1.0, row(1, 3), False, True)
    assert agent.Q[row(2, 3)].tolist() == [0, -1 / 2]
    assert agent.Q[row(2, 1)].tolist() == [0, 2 / 2]  # the goal 1 is achieved: nothing comes after it
    assert agent.Q[row(0, 1)].tolist() == [(-1 + 1 / 2) / 2, 0]
    assert np.count_nonzero(agent.Q) == 4
    assert agent.episode.length[0] == 0


def test_future_goals_by_hand() -> None:
    """The first step is learned for what the second achieved, and for what it achieved itself."""
    agent = for_four(hindsight=eg.FutureGoals(2))
    agent.episode.draws[:2] = [[0.5, 0.49], [0.0, 0.99]]
    agent.learn(row(0, 3), 0, -1.0, row(2, 3), False, False)
    agent.learn(row(2, 3), 1, -1.0, row(1, 3), False, True)
    assert agent.Q[row(2, 1)].tolist() == [0, 2 / 2 + (2 - 2 / 2) / 2]  # twice
    assert agent.Q[row(0, 1)].tolist() == [(-1 + 1.5 / 2) / 2, 0]
    assert agent.Q[row(0, 2)].tolist() == [2 / 2, 0]
    assert np.count_nonzero(agent.Q) == 5


def learned(Q: Reals, steps: list[tuple[int, int, int]], goal: int, hindsight: Any, draws: Any) -> None:
    """The same as in the class's docstring, with NumPy's indices, and without a thought for speed."""
    table = Q.reshape(4, 4, 2)

    def update(s: int, a: int, then: int, g: int, reward: float, over: bool) -> None:
        table[s, g, a] += 0.5 * (reward + (0.0 if over else 0.5 * table[then, g].max()) - table[s, g, a])

    for s, a, then in steps:
        update(s, a, then, goal, -1.0, False)
    for t, (s, a, then) in reversed(list(enumerate(steps))):
        later = [after for _, _, after in steps[t:]]
        goals = {
            eg.NoHindsight: [],
            eg.FinalGoal: later[-1:],
            eg.FutureGoals: [later[int(u * len(later))] for u in draws[t]],
        }[type(hindsight)]
        for g in goals:
            update(s, a, then, g, 2.0 if then == g else -1.0, then == g)


chains: Any = st.lists(st.tuples(st.integers(0, 3), st.integers(0, 1), st.integers(0, 3)), min_size=1, max_size=6)


@given(st.sampled_from(STRATEGIES), st.lists(st.tuples(chains, st.integers(0, 3)), min_size=1, max_size=3))
def test_hindsight_against_a_reference(hindsight: Any, episodes: list[tuple[list[tuple[int, int, int]], int]]) -> None:
    """Over several episodes, in which states are met twice and the goals change."""
    agent, Q, rng = for_four(hindsight=hindsight, longest=6), np.zeros((16, 2)), np.random.default_rng(5)
    for steps, goal in episodes:
        for t, (s, a, then) in enumerate(steps):
            agent.act(row(s, goal), rng)
            last = t + 1 == len(steps)
            agent.learn(row(s, goal), a, -1.0, row(then, goal), False, last)
        learned(Q, steps, goal, hindsight, agent.episode.draws)
    assert np.array_equal(agent.Q, Q)


@pytest.mark.parametrize(("t", "length"), [(0, 1), (0, 5), (3, 5), (4, 5)])
def test_which_goals_are_drawn(t: int, length: int) -> None:
    """'final': the last; 'future': each from this step on, evenly."""
    assert eg.FinalGoal().achieved_after(t, length, 0.3) == length - 1
    shares = defaultdict[int, float](float)
    for probability, step in branches(lambda rng: eg.FutureGoals().achieved_after(t, length, rng.random())):
        shares[step] += probability
    assert shares == pytest.approx(dict.fromkeys(range(t, length), 1 / (length - t)))


def memory_of(agent: eg.HindsightDQN) -> list[tuple[Any, ...]]:
    """The transitions in the memory of a network, in their order."""
    memory: ReplayMemory = agent.dqn.memory
    return [
        tuple(part[k].tolist() for part in memory) for k in range(min(int(agent.dqn.steps[0]), len(memory.actions)))
    ]


def test_the_memory_of_the_network_by_hand() -> None:
    """Of an episode of three steps with the goal 0.25: what it reached last becomes the goal; the first comes twice."""
    agent = eg.HindsightDQN.create(
        (2, 2), goal_size=1, hindsight=eg.FinalGoal(), memory_size=8, learn_every=2, reward_at_goal=2.0
    )
    for t, (before, after) in enumerate(((0.0, 0.5), (0.5, 0.75), (0.75, 0.5))):
        agent.learn(np.array([before, 0.25]), t % 2, -3.0, np.array([after, 0.25]), False, t == 2)
    assert memory_of(agent) == [
        ([0.0, 0.25], 0, -3.0, [0.5, 0.25], 0),
        ([0.5, 0.25], 1, -3.0, [0.75, 0.25], 0),
        ([0.75, 0.25], 0, -3.0, [0.5, 0.25], 0),
        ([0.0, 0.5], 0, 2.0, [0.5, 0.5], 1),
        ([0.5, 0.5], 1, -1.0, [0.75, 0.5], 0),
        ([0.75, 0.5], 0, 2.0, [0.5, 0.5], 1),
        ([0.0, 0.5], 0, 2.0, [0.5, 0.5], 1),
    ]
    assert agent.length[0] == 0


@pytest.mark.parametrize("hindsight", STRATEGIES)
@pytest.mark.parametrize("n", [1, 3])
def test_the_network_learns_in_every_fourth_step_of_the_environment(hindsight: Any, n: int) -> None:
    """Whatever hindsight adds to the memory, and however short the episodes are."""
    mdp = eg.make_mdp("Switches", n_switches=n)
    agent = eg.HindsightDQN.create(mdp, hindsight=hindsight, learn_from=1, learn_every=4, hidden=3, batch_size=2)
    eg.train(mdp, agent, 80, seed=0)
    assert agent.dqn.updates[0] == 80 / 4
    assert (agent.dqn.steps[0] > 80) == (hindsight.goals > 0)


def test_what_fits_no_pairs_is_refused() -> None:
    """A wrapper that shows something else, a wrong number of goals, or what is no strategy."""
    mdp = eg.make_mdp("Switches", n_switches=2)
    cases: list[tuple[Any, Any, dict[str, Any], str]] = [
        (eg.HindsightQLearning, eg.FrameStack.create(mdp, 2), {}, r"environment must show a pair \(state, goal\), 4²"),
        (eg.HindsightDQN, eg.FrameStack.create(mdp, 2), {}, r"environment must show a pair .* 4 numbers each"),
        (eg.HindsightQLearning, (16, 2), {"n_goals": 8}, "n_goals must be 1, or the root of 16 .* but is 8"),
        (eg.HindsightDQN, (6, 2), {"goal_size": 2}, "goal_size must be 0, or half of the 6 .* but is 2"),
        (eg.HindsightDQN, (6, 2), {"memory_size": 8}, "memory_size must be 9 or more, .* but is 8"),
        (eg.HindsightQLearning, (16, 2), {"hindsight": "future"}, r"hindsight must be .* but is 'future'"),
        (eg.HindsightDQN, (6, 2), {"hindsight": eg.FinalGoal}, r"hindsight must be .* but is .*FinalGoal"),
        (eg.HindsightQLearning, (16, 2), {"hindsight": eg.FutureGoals(0)}, named("goals", 1, 1000, 0)),
        (eg.HindsightQLearning, (16, 2), {"longest": 0}, named("longest", 1, 0)),
        (eg.HindsightDQN, (6, 2), {"hiden": 2}, named("hiden")),
    ]
    for kind, environment, settings, says in cases:
        with pytest.raises(ValueError, match=says):
            kind.create(environment, **settings)


@pytest.mark.parametrize("kind", [eg.HindsightQLearning, pytest.param(eg.HindsightDQN, marks=pytest.mark.slow)])
@pytest.mark.parametrize(
    "hindsight", [eg.FutureGoals(2), *(pytest.param(other, marks=pytest.mark.slow) for other in STRATEGIES[:2])]
)
def test_machine_code_and_the_interpreter_are_one(kind: Any, hindsight: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """In Switches, where there are goals, to the last bit; the memory of the network is filled several times."""
    mdp, few = (
        eg.make_mdp("Switches", n_switches=3),
        {"hidden": 4, "batch_size": 3, "memory_size": 100, "learn_from": 9},
    )
    results = []
    for compiles in (True, False):
        agent = kind.create(mdp, hindsight=hindsight, **(few if kind is eg.HindsightDQN else {}))
        with monkeypatch.context() as patch:
            if not compiles:
                patch.setattr(trainers, "executable", lambda loop, *given, **how: loop)
            playing = trainers.trainer(mdp, agent, 3, None, 10_000)
        assert playing.is_compiled == compiles
        steps = 0
        while steps < 1_500:
            steps += playing.learn(1_500 - steps)
        results.append((agent, playing.play_episodes(1)[0]))
    assert all(map(same, *results))


def test_without_goals_or_hindsight_it_is_q_learning() -> None:
    """On the same steps, in an environment whose goal never changes, and where nothing is learned in hindsight."""
    cases: list[dict[str, Any]] = [{}, {"n_goals": 4, "hindsight": eg.NoHindsight()}]
    for settings in cases:
        agent, plain, rng = eg.HindsightQLearning.create((16, 2), **settings), eg.QLearning.create((16, 2)), RNG
        for _ in range(200):
            s, a, then, over = *(int(rng.integers(n)) for n in (16, 2, 16)), bool(rng.random() < 0.2)
            agent.act(s, rng)
            agent.learn(s, a, -1.0, then, False, over)
            plain.learn(s, a, -1.0, then, False)
        assert np.array_equal(agent.Q, plain.Q)
        assert agent.Q.any()


def returns_of(kind: Any, n: int, n_steps: int, hindsight: Any, seed: int, **settings: Any) -> float:
    """The mean greedy return at the end, of 100 episodes with n switches."""
    mdp = eg.make_mdp("Switches", n_switches=n)
    agent = kind.create(mdp, hindsight=hindsight, **settings)
    run = eg.train(mdp, agent, n_steps, seed=seed, evaluate_every=n_steps, evaluation_episodes=100)
    return float(run.returns[-1])


def best_return(n: int) -> float:
    """The best expected return with n switches: 1 less than the mean distance, below 0."""
    best: float = eg.make_mdp("Switches", n_switches=n).reward_threshold
    return best


LEARNERS: list[tuple[int, int, Any, bool]] = [
    (8, 20_000, eg.FinalGoal(), True),
    (8, 20_000, eg.NoHindsight(), False),
    (8, 200_000, eg.NoHindsight(), False),
    (6, 200_000, eg.NoHindsight(), True),
    (14, 80_000, eg.FutureGoals(4), True),
    (14, 80_000, eg.FinalGoal(), True),
    (14, 80_000, eg.NoHindsight(), False),
]
"""How many switches, how many steps, the hindsight, and whether a network learns to bring the pattern about."""


@pytest.mark.slow
def test_a_network_learns_eight_switches() -> None:
    """Near the best return, over seeds; without learning it gets no further than random play, near the worst, -8."""
    kind, hindsight = eg.HindsightDQN, eg.FutureGoals(4)
    returns = eg.mean_interval([returns_of(kind, 8, 20_000, hindsight, seed) for seed in range(5)])
    assert returns.low > best_return(8) - 1.0
    assert returns_of(kind, 8, 20_000, hindsight, 0, learning_rate=5e-324) < 0.1 - 0.95 * 8


@pytest.mark.slow
@pytest.mark.parametrize(("n", "n_steps", "hindsight", "learns"), LEARNERS)
def test_how_many_switches_a_network_learns(n: int, n_steps: int, hindsight: Any, learns: bool) -> None:
    """It ends near the best return, or near the worst, -n: of random play and less."""
    returns = eg.mean_interval([returns_of(eg.HindsightDQN, n, n_steps, hindsight, seed) for seed in range(5)])
    if learns:
        assert returns.low > best_return(n) - 1.0
    else:
        assert returns.high < 0.1 - 0.95 * n


def test_hindsight_saves_a_table_some_steps() -> None:
    """Six switches, before all is learned: a higher return than without, over seeds."""
    with_it, without = (
        [returns_of(eg.HindsightQLearning, 6, 50_000, hindsight, seed, learning_rate=1.0) for seed in range(8)]
        for hindsight in (eg.FutureGoals(4), eg.NoHindsight())
    )
    assert eg.mean_interval(np.subtract(with_it, without)).low > 0.0
    assert max(with_it) < best_return(6) - 0.2
