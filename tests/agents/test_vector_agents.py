"""Agents of several objectives: their updates by hand, and what they find against the exact front."""

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import edugym
from edugym import objectives
from edugym.agents.strategies import EpsilonGreedy, Greedy
from edugym.compiled import execution
from edugym.experiments.results.statistics import mean_interval
from edugym.objectives import (
    ChebyshevQLearning,
    LagrangianQLearning,
    ParetoQLearning,
    Weighted,
    constrained_optimum,
    exact_front,
    train_vectors,
)
from tests.agents.cases import same
from tests.exact.graphs import loop
from tests.messages import named

DIVER = edugym.make_mdp("Diver")
RNG = np.random.default_rng(0)
AT_RANDOM = EpsilonGreedy(1.0)


def diver(concavity: float = 0.5) -> Any:
    """The task."""
    return edugym.make_mdp("Diver", concavity=concavity)


def vector(*numbers: float) -> Any:
    """A vector of rewards."""
    return np.array(numbers)


def test_chebyshev_by_hand() -> None:
    """With α = 0.5 and γ = 0.5: the closest action of S' is in the target, and z follows the best returns."""
    agent = ChebyshevQLearning.create((2, 2, 2), (1.0, 2.0), learning_rate=0.5, discount=0.5, exploration=Greedy())
    agent.Q[1] = [[8.0, -4.0], [2.0, -1.0]]
    agent.best_returns[:] = [8.0, -1.0]
    agent.episodes[0] = 1
    agent.learn(0, 0, vector(4.0, -2.0), 1, terminated=False, truncated=False)
    # d(1, 0) = max(1 · 0, 2 · 3) = 6 and d(1, 1) = max(1 · 6, 2 · 0) = 6: equal, so the mean vector (5, -2.5)
    assert agent.closeness.tolist() == [[-6.0, -6.0]]
    assert agent.Q[0, 0].tolist() == [0.5 * (4 + 0.5 * 5), 0.5 * (-2 + 0.5 * -2.5)]
    agent.Q[1, 0, 1] = -3.0  # d(1, 0) = 4
    agent.learn(0, 1, vector(0.0, -2.0), 1, terminated=False, truncated=False)
    assert agent.Q[0, 1].tolist() == [0.5 * (0 + 0.5 * 8), 0.5 * (-2 + 0.5 * -3)]
    assert agent.total.tolist() == [4.0, -4.0]
    agent.learn(1, 1, vector(9.0, 0.0), 0, terminated=True, truncated=False)
    assert agent.Q[1, 1].tolist() == [2 + 0.5 * (9 - 2), -1 + 0.5 * (0 - -1)]  # nothing comes after an end
    assert agent.best_returns.tolist() == [13.0, -1.0]
    assert (agent.total.tolist(), agent.episodes[0]) == ([0.0, 0.0], 2)
    assert agent.greedy(1, RNG) == 0


def test_the_distance_is_that_of_whole_returns() -> None:
    """With `whole_returns` what was paid on the way counts; the truncated end of an episode bootstraps."""
    agent = ChebyshevQLearning.create((2, 2, 2), learning_rate=1.0, discount=1.0, margin=1.0, whole_returns=True)
    agent.Q[1] = [[5.0, -1.0], [9.0, -6.0]]
    agent.best_returns[:] = [9.0, -2.0]
    agent.episodes[0] = 1
    agent.learn(0, 0, vector(0.0, -3.0), 1, terminated=False, truncated=True)
    # τ = 1: d(1, 0) = max(|10 - 5|, |-1 - (-3 - 1)|) = 5, d(1, 1) = max(|10 - 9|, |-1 - (-3 - 6)|) = 8
    assert agent.closeness.tolist() == [[-5.0, -8.0]]
    assert agent.Q[0, 0].tolist() == [5.0, -4.0]
    assert agent.best_returns.tolist() == [9.0, -2.0]
    assert agent.so_far.tolist() == [[0.0, 0.0], [0.0, -3.0]]


def test_the_first_episode_is_the_best_so_far() -> None:
    """Also where its returns are below 0."""
    agent = ChebyshevQLearning.create((2, 1, 1))
    agent.learn(0, 0, vector(-7.0), 1, terminated=True, truncated=False)
    assert agent.best_returns.tolist() == [-7.0]


@pytest.mark.parametrize(("terminated", "truncated"), [(True, False), (False, True), (False, False)])
def test_lagrangian_by_hand(terminated: bool, truncated: bool) -> None:
    """The best action at the prices of now is in the target; λ rises by η (limit - G) at the end of an episode."""
    agent = LagrangianQLearning.create(
        (2, 2, 2), [-5.0], learning_rate=0.5, discount=0.5, multiplier_rate=0.1, initial_multiplier=2.0
    )
    agent.Q[1] = [[9.0, -4.0], [2.0, -1.0]]  # q = 9 - 8 and 2 - 2: the first
    agent.learn(0, 1, vector(1.0, -7.0), 1, terminated=terminated, truncated=truncated)
    future = (0.0, 0.0) if terminated else (9.0, -4.0)
    assert agent.Q[0, 1].tolist() == [0.5 * (1 + 0.5 * future[0]), 0.5 * (-7 + 0.5 * future[1])]
    over = terminated or truncated
    assert agent.multipliers.tolist() == pytest.approx([1.0, 2.0 + 0.1 * (-5 - -7) if over else 2.0])
    assert agent.total.tolist() == ([0.0, 0.0] if over else [1.0, -7.0])
    assert agent.greedy(1, RNG) == 0
    agent.multipliers[1] = 3.0  # q = -3 and -1
    assert agent.greedy(1, RNG) == 1


def test_a_price_is_never_below_0() -> None:
    """However far a return lies above the limit."""
    agent = LagrangianQLearning.create((1, 1, 3), [-5.0, 2.0], multiplier_rate=1.0)
    agent.learn(0, 0, vector(0.0, 100.0, 1.5), 0, terminated=True, truncated=False)
    assert agent.multipliers.tolist() == [1.0, 0.0, 0.5]
    assert agent.limits.tolist() == [-math.inf, -5.0, 2.0]


def test_pareto_by_hand() -> None:
    """The mean of the rewards, and of the next state only what nothing else is better than."""
    agent = ParetoQLearning.create((3, 2, 2), discount=0.5, exploration=Greedy())
    agent.learn(1, 0, vector(4.0, -1.0), 2, terminated=True)
    agent.learn(1, 1, vector(2.0, -2.0), 2, terminated=True)  # worse in both
    agent.learn(0, 0, vector(1.0, -1.0), 1, terminated=False)
    assert agent.vectors(0, 0).tolist() == [[1 + 0.5 * 4, -1 + 0.5 * -1]]
    agent.learn(1, 1, vector(8.0, -4.0), 2, terminated=True)  # on average (5, -3), which is worth more
    agent.learn(0, 0, vector(3.0, -1.0), 1, terminated=False)  # on average (2, -1)
    assert agent.vectors(0, 0).tolist() == [[2 + 0.5 * 4, -1.5], [2 + 0.5 * 5, -2.5]]
    assert agent.vectors(0, 1).shape == (0, 2)
    assert agent.front(2).shape == (0, 2)
    agent.learn(0, 1, vector(4.0, -1.5), 1, terminated=True)  # a second way to the first point
    assert agent.front(0).tolist() == [[4.0, -1.5], [4.5, -2.5]]
    agent.look_at(0)
    assert agent.share.tolist() == [[2.0, 1.0]]
    assert agent.greedy(0, RNG) == 0
    player = agent.follow([4.4, -2.5])
    assert (player.act(0, RNG), player.rest.tolist()) == (0, [5.0, -3.0])
    assert player.act(1, RNG) == 1


AGENTS: dict[str, Callable[[Any], Any]] = {
    "Chebyshev": lambda task: ChebyshevQLearning.create(task, (2.0, 9.0)),
    "Chebyshev, whole returns": lambda task: ChebyshevQLearning.create(
        task, (2.0, 9.0), discount=1.0, whole_returns=True
    ),
    "Lagrangian": lambda task: LagrangianQLearning.create(task, [-7.0], initial_values=[100.0, 0.0]),
    "Q-learning": lambda task: edugym.QLearning.create(task),
}


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=[pytest.mark.slow] * (name == "Lagrangian")) for name in AGENTS]
)
def test_machine_code_does_the_same(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Tables, returns and episodes are those of the interpreter, bit for bit."""
    runs = []
    for compile_from in (0, 10**9):
        monkeypatch.setattr(execution, "COMPILE_FROM", compile_from)
        runs.append(train_vectors(diver(), AGENTS[name](diver()), 6_000, max_steps=12, seed=3, evaluate_every=1_500))
    first, second = runs
    assert same(first.agent, second.agent)
    for field in ("steps", "returns", "training_returns", "training_ends"):
        assert np.array_equal(getattr(first, field), getattr(second, field))
    assert first.steps.tolist() == [0, 1_500, 3_000, 4_500, 6_000]
    assert first.complete


def test_the_loop_is_that_of_train() -> None:
    """An agent that learns from one number learns the same as in `edugym.train`; its returns are told apart."""
    one, other = (edugym.QLearning.create(diver()) for _ in range(2))
    run = train_vectors(diver(), one, 3_000, seed=5)
    plain = edugym.train(diver(), other, 3_000, seed=5)
    assert same(one, other)
    assert np.array_equal(run.returns @ [1.0, 4.0], plain.returns)
    assert len(run.training_returns) == plain.episodes.sum()
    assert np.array_equal(np.diff(run.training_ends, prepend=0), -run.training_returns[:, 1])  # -1 for each step


def test_the_loop_is_that_of_the_environment() -> None:
    """A plain loop over `VectorRewardEnv` teaches the same."""
    env, rng = objectives.VectorRewardEnv(diver()), np.random.default_rng(1)
    agent = ParetoQLearning.create(env, exploration=AT_RANDOM)
    state, _ = env.reset(seed=0)
    for _ in range(2_000):
        action = agent.act(state, rng)
        next_state, rewards, terminated, truncated, _ = env.step(action)
        agent.learn(state, action, rewards, next_state, terminated)
        state = env.reset()[0] if terminated or truncated else next_state
    by_loop = ParetoQLearning.create(DIVER, exploration=AT_RANDOM)
    train_vectors("Diver", by_loop, 2_000, seed=2)
    both = np.concatenate([agent.front(0), by_loop.front(0)])
    assert len(agent.front(0)) >= 7
    assert len(np.unique(both.round(9), axis=0)) <= 9


@pytest.mark.parametrize("concavity", [0, 0.5, 1])
def test_pareto_q_learning_finds_the_exact_front(concavity: float) -> None:
    """All nine points at each concavity, and the way to each of them; with nothing learned, none."""
    mdp = diver(concavity)
    front = exact_front(mdp).returns
    agent = ParetoQLearning.create(mdp, discount=1.0, exploration=EpsilonGreedy(0.5))
    assert len(agent.front(0)) == 0
    train_vectors(mdp, agent, 10_000, seed=0, evaluate_every=10_000)
    assert np.allclose(agent.front(0), front, atol=1e-9)
    for point in front:
        player, state, earned = agent.follow(point), 0, np.zeros(2)
        while not mdp.terminal(state):
            action = player.act(state, RNG)
            after = mdp.transition(state, action, RNG)
            earned += mdp.rewards(state, action, after)
            state = after
        assert earned.tolist() == point.tolist()


def nearest(returns: Any, weights: Any, tolerance: float = 0.0) -> int:
    """Which point is closest to the best of all, by the weights."""
    return int((np.array(weights) * (returns.max(axis=0) - returns)).max(axis=1).argmin())


CHEBYSHEV_WEIGHTS = [(2.0, 65.0), (2.0, 35.0), (2.0, 21.0), (2.0, 13.0), (2.0, 8.0), (2.0, 5.3), (2.0, 2.6)]
"""By these, treasures 1 to 7 or so are closest, without ties."""


def chebyshev(mdp: Any, weights: Any, *, whole: bool, seed: int) -> int:
    """The treasure that an agent picks up in the end."""
    agent = ChebyshevQLearning.create(
        mdp, weights, learning_rate=1.0, discount=1.0, exploration=AT_RANDOM, whole_returns=whole
    )
    run = train_vectors(mdp, agent, 30_000, seed=seed, evaluate_every=30_000)
    return int((-run.returns[-1, 1] - 1) / 2)


@pytest.mark.parametrize("concavity", [0, 0.5, 1])
def test_chebyshev_finds_what_its_weights_ask_for(concavity: float) -> None:
    """With whole returns, also in the dent; with the paper's rule often something else (the negative control)."""
    mdp = diver(concavity)
    returns = exact_front(mdp).returns
    asked = [nearest(returns, weights) for weights in CHEBYSHEV_WEIGHTS]
    assert len(set(asked)) >= 4
    for seed in range(3):
        found = {
            whole: [chebyshev(mdp, w, whole=whole, seed=seed) for w in CHEBYSHEV_WEIGHTS] for whole in (True, False)
        }
        assert found[True] == asked
        assert sum(one != other for one, other in zip(found[False], asked, strict=True)) >= 3


@pytest.mark.slow
def test_weighted_sums_never_find_the_dent() -> None:
    """Q-learning on `Weighted` finds the treasure that its weights prefer, and never one of the unsupported ones."""
    mdp = diver(1.0)
    for weights, treasure in (((1.0, 6.0), 0), ((1.0, 4.0), 8)):
        agent = edugym.QLearning.create(mdp, discount=1.0, exploration=AT_RANDOM, learning_rate=1.0)
        run = train_vectors(Weighted.create(mdp, weights), agent, 50_000, seed=0)
        assert run.returns[-1, 1] == -(2 * treasure + 1)


def lagrangian(concavity: float, seed: int) -> tuple[float, float]:
    """The share of dives longer than 7 steps in the second half of training, and the mean value there."""
    agent = LagrangianQLearning.create(
        diver(concavity), [-7.0], discount=1.0, learning_rate=1.0, initial_values=(100.0, 0.0), exploration=Greedy()
    )
    run = train_vectors(diver(concavity), agent, 40_000, seed=seed, evaluate_every=40_000)
    late = run.training_returns[len(run.training_returns) // 2 :]
    return float((late[:, 1] < -7).mean()), float(late[:, 0].mean())


@pytest.mark.parametrize("concavity", [0, 0.5, 1])
def test_the_multiplier_comes_to_the_exact_optimum_on_average(concavity: float) -> None:
    """Value and overruns are those of the best *mean* of policies; where a point lies on the hull, none overruns."""
    exact = constrained_optimum(exact_front(diver(concavity)).returns, -7.0)
    found = [lagrangian(concavity, seed) for seed in range(5)]
    overruns = sum(exact.shares[4:])
    low, high = mean_interval([share for share, _ in found])[1:3]
    assert low - 0.02 < overruns < high + 0.02
    assert np.mean([value for _, value in found]) == pytest.approx(exact.mean[0], abs=0.2)
    assert (overruns == 0.0) == (concavity == 0)


def test_constrained_optimum() -> None:
    """Against every mean of two points, on a fine grid; and where nothing keeps the limit."""
    for seed in range(20):
        rng = np.random.default_rng(seed)
        points, limit = rng.integers(0, 10, (6, 2)), 4.5
        found = constrained_optimum(points, limit)
        keeps = points[points[:, 1] >= limit, 0]
        if not len(keeps):
            assert found.best is None
            assert not found.shares.any()
            assert np.isnan(found.mean).all()
            continue
        assert points[found.best, 0] == keeps.max()
        shares = np.linspace(0, 1, 201)[:, np.newaxis]
        means = np.concatenate([shares * one + (1 - shares) * other for one in points for other in points])
        best = means[means[:, 1] >= limit - 1e-12, 0].max()
        assert best <= found.mean[0] + 1e-9 <= best + 0.1
        assert found.mean.tolist() == (found.shares @ points).tolist()
        assert found.mean[1] >= limit - 1e-9
        assert found.shares.sum() == pytest.approx(1)


class Students:
    """A student's agent, which learns from the vector."""

    def __init__(self, slip: str = "") -> None:
        """With a table."""
        self.Q, self.slip = np.zeros((90, 2, 2)), slip

    def act(self, state: int, rng: Any) -> Any:
        """At random."""
        return {"": int(rng.integers(2)), "action": 7, "nothing": None}.get(self.slip, 0)

    def learn(self, state: int, action: int, rewards: Any, next_state: int, terminated: bool) -> None:
        """With array operations."""
        if self.slip == "nan":
            self.Q[state, action] = np.nan
        self.Q[state, action] += 0.1 * (rewards + (not terminated) * self.Q[next_state].mean(axis=0))
        rewards[:] = 7.0  # it is the agent's own


def test_a_students_agent() -> None:
    """It learns, and may do with its vector what it likes."""
    run = train_vectors("Diver", Students(), 300, seed=0)
    assert run.agent.Q.any()
    assert run.training_returns[:, 0].max() <= 90


@pytest.mark.parametrize(("slip", "says"), [("action", "act"), ("nothing", "return missing"), ("nan", "Q")])
def test_slips_of_agents(slip: str, says: str) -> None:
    """One sentence each."""
    with pytest.raises(ValueError, match=says):
        train_vectors("Diver", Students(slip), 300, seed=0)


@pytest.mark.parametrize("slip", ["one number", "nothing", "too many"])
def test_slips_of_tasks(slip: str) -> None:
    """The vector of rewards is checked."""
    with pytest.raises(ValueError, match=r"what rewards of Graph returns must be an array of numbers of shape \(2,\)"):
        train_vectors(loop(slip), ParetoQLearning.create((3, 2, 2)), 50)


def test_a_task_of_a_student() -> None:
    """An episode may end on its own or be truncated, where the agent bootstraps; it has five steps at most."""
    agent = ChebyshevQLearning.create(loop(), exploration=AT_RANDOM, discount=0.5, learning_rate=1.0)
    run = train_vectors(loop(), agent, 500, seed=0)
    assert len(run.training_returns) > 500 / 5
    assert set(run.training_returns.sum(axis=1)) <= {2.0, 3.0, 4.0, 5.0, 6.0}
    assert (agent.Q[0] != 0).any(axis=1).all()


@pytest.mark.parametrize(
    ("make", "names"),
    [
        (lambda: ChebyshevQLearning.create(edugym.make_mdp("Boulder")), ["several objectives"]),
        (lambda: ChebyshevQLearning.create("Diver"), ["environment", "'Diver'"]),
        (lambda: ChebyshevQLearning.create((2, 2)), ["three numbers", "(2, 2)"]),
        (lambda: ChebyshevQLearning.create((2, 2, 1_001)), ["n_objectives", "1", "1000", "1001"]),
        (lambda: ChebyshevQLearning.create(DIVER, [1, 2, 3]), ["weights", "(2,)"]),
        (lambda: ChebyshevQLearning.create(DIVER, [-1, 2]), ["weights", "0 or more", "[-1, 2]"]),
        (lambda: ChebyshevQLearning.create(DIVER, whole_returns=True), ["discount", "1", "0.99"]),
        (lambda: ChebyshevQLearning.create(DIVER, epsilon=0.1), ["epsilon", "exploration"]),
        (lambda: Weighted.create(DIVER, [0, 0]), ["weights", "not all 0", "[0, 0]"]),
        (lambda: LagrangianQLearning.create(DIVER, -7), ["limits", "(1,)", "-7"]),
        (lambda: LagrangianQLearning.create(DIVER, [math.nan]), ["limits", "finite", "nan"]),
        (lambda: LagrangianQLearning.create(DIVER, [-7], initial_multiplier=-1), ["initial_multiplier", "-1"]),
        (lambda: LagrangianQLearning.create(DIVER, [-7], initial_values=3), ["initial_values", "(2,)", "3"]),
        (lambda: ParetoQLearning.create(DIVER, learning_rate=0.1), ["learning_rate", "discount"]),
        (lambda: ParetoQLearning.create(DIVER).follow(3), ["point", "(2,)", "3"]),
        (lambda: constrained_optimum([[1, math.nan]], 0), ["points", "finite"]),
        (lambda: train_vectors("Diver", edugym.SARSA.create((90, 2)), 9), ["next_action", "rewards"]),
        (lambda: train_vectors("Diver", edugym.QLearning.create((4, 2)), 9), ["Q", "(90, 2)", "(4, 2)"]),
        (lambda: train_vectors("Diver", ParetoQLearning, 9), ["agent", "class"]),
        (lambda: train_vectors("Diver", ParetoQLearning.create(DIVER), 10**15), ["training_returns", "fewer steps"]),
        (lambda: edugym.train("Diver", ParetoQLearning.create(DIVER), 9), ["rewards", "train_vectors"]),
    ],
)
def test_bad_settings(make: Callable[[], Any], names: list[str]) -> None:
    """Each is named, with what is allowed and what came."""
    with pytest.raises(ValueError, match=named(*names)):
        make()
