"""The boxes of the docstrings, written a second time with NumPy: to 1e-12 the agents do the same on random steps."""

import inspect
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np
import pytest

import edugym as eg
from edugym import games
from edugym.mdp.protocol import Reals
from edugym.objectives import ChebyshevQLearning, LagrangianQLearning, ParetoQLearning

N_STATES, N_ACTIONS, OTHERS = 5, 3, 2
ALPHA, GAMMA, LAMBDA, EPSILON, SPREAD = 0.3, 0.9, 0.8, 0.2, 0.7
WEIGHTS, MARGIN, LIMIT, RATE = np.array([1.0, 2.5]), 0.5, -0.3, 0.4
GAME = games.matrix_game(np.zeros((N_ACTIONS, OTHERS)))
HOW: dict[str, Any] = {"learning_rate": ALPHA, "discount": GAMMA}


class Step(NamedTuple):
    """A step, with everything that `learn` of some agent asks for."""

    state: int
    action: int
    other_action: int
    reward: float
    rewards: Reals
    next_state: int
    next_action: int
    terminated: bool
    truncated: bool

    @property
    def over(self) -> bool:
        """Whether the episode ends here."""
        return self.terminated or self.truncated

    @property
    def gamma(self) -> float:
        """What the next state counts."""
        return 0.0 if self.terminated else GAMMA


def random_steps(seed: int, *, forward: bool = False, n: int = 300) -> list[Step]:
    """Episodes that end and others that are cut off; forward, they never come back, and the last state is the end."""
    rng = np.random.default_rng(seed)
    state, action, steps = 0, int(rng.integers(N_ACTIONS)), []
    for _ in range(n):
        following, then = int(rng.integers(state + 1 if forward else 0, N_STATES)), int(rng.integers(N_ACTIONS))
        ends = following == N_STATES - 1 if forward else bool(rng.random() < 0.03)
        cut = not ends and bool(rng.random() < 0.03)
        rewards, other = rng.normal(size=2), int(rng.integers(OTHERS))
        steps.append(Step(state, action, other, float(rewards[0]), rewards, following, then, ends, cut))
        state, action = (0 if ends or cut else following), then
    return steps


def told(agent: Any, step: Step) -> None:
    """Let the agent learn from it."""
    if hasattr(agent, "coin"):
        agent.coin[0] = step.other_action
    agent.learn(**{name: getattr(step, name) for name in inspect.signature(agent.learn).parameters})


def double_q(box: Any, steps: list[Step]) -> None:
    """The box of section 6.7; the other's action is the coin."""
    tables = box.Q1, box.Q2
    for step in steps:
        one, other = tables[step.other_action], tables[1 - step.other_action]
        target = step.reward + step.gamma * other[step.next_state, one[step.next_state].argmax()]
        one[step.state, step.action] += ALPHA * (target - one[step.state, step.action])
    box.Q[:] = (box.Q1 + box.Q2) / 2


def best(values: Reals) -> Reals:
    """The greedy policy, with which expected SARSA is Q-learning."""
    shares: Reals = np.eye(N_ACTIONS)[values.argmax()]
    return shares


def epsilon_greedy(values: Reals) -> Reals:
    """The ε-greedy policy."""
    return EPSILON / N_ACTIONS + (1 - EPSILON) * best(values)


def softmax(values: Reals) -> Reals:
    """The softmax policy."""
    shares: Reals = np.exp(values / SPREAD) / np.exp(values / SPREAD).sum()
    return shares


def expected_sarsa(policy: Callable[[Reals], Reals]) -> Any:
    """Equation 6.9."""

    def learn(box: Any, steps: list[Step]) -> None:
        for step in steps:
            after = box.Q[step.next_state]
            target = step.reward + step.gamma * policy(after) @ after
            box.Q[step.state, step.action] += ALPHA * (target - box.Q[step.state, step.action])

    return learn


def with_traces(kind: str, *, greedy: bool) -> Any:
    """SARSA(λ), or greedy Watkins's Q(λ), with a whole table of traces; those below 10⁻⁹ are dropped."""

    def learn(box: Any, steps: list[Step]) -> None:
        Q, Z, old = box.Q, np.zeros_like(box.Q), 0.0
        for step in steps:
            pair, after = (step.state, step.action), Q[step.next_state]
            following = after.max() if greedy else after[step.next_action]
            delta, change = step.reward + step.gamma * following - Q[pair], Q[pair] - old
            Z[pair] = {"accumulating": Z[pair] + 1, "replacing": 1, "Dutch": (1 - ALPHA) * Z[pair] + 1}[kind]
            cut = step.over or (greedy and after[step.next_action] < following)
            if kind == "Dutch":
                Q += ALPHA * (delta + change) * Z
                Q[pair] -= ALPHA * change
            else:
                Q += ALPHA * delta * Z
            Z *= 0 if cut else GAMMA * LAMBDA
            Z[Z < 1e-9] = 0
            old = following

    return learn


def chebyshev(*, whole: bool) -> Any:
    """Q-learning of vectors; with whole returns γ is 1."""

    def learn(box: Any, steps: list[Step]) -> None:
        total, so_far, episodes = np.zeros(2), np.zeros((N_STATES, 2)), 0
        for step in steps:
            total = total + step.rewards
            so_far[step.next_state] = total
            after = box.Q[step.next_state]
            away = box.best_returns + MARGIN - after - whole * so_far[step.next_state]
            nearest = after[(WEIGHTS * np.abs(away)).max(axis=1).argmin()]
            gamma = 1.0 if whole and not step.terminated else step.gamma
            box.Q[step.state, step.action] += ALPHA * (step.rewards + gamma * nearest - box.Q[step.state, step.action])
            if step.over:
                box.best_returns[:] = np.maximum(box.best_returns, total) if episodes else total
                total, episodes = np.zeros(2), episodes + 1

    return learn


def lagrangian(box: Any, steps: list[Step]) -> None:
    """The best action at the prices of now, and dual ascent at the end of an episode."""
    total = np.zeros(2)
    for step in steps:
        after = box.Q[step.next_state]
        highest = after[(after @ box.multipliers).argmax()]
        box.Q[step.state, step.action] += ALPHA * (step.rewards + step.gamma * highest - box.Q[step.state, step.action])
        total = total + step.rewards
        if step.over:
            box.multipliers[1] = max(0.0, box.multipliers[1] + RATE * (LIMIT - total[1]))
            total = np.zeros(2)


def fictitious_play(box: Any, steps: list[Step]) -> None:
    """Q-learning of pairs of actions, and the best answer to how often the other has chosen each."""
    for step in steps:
        box.others[step.state, step.other_action] += 1
        box.played[step.state, step.action] += 1
        shares = box.others[step.next_state] / box.others[step.next_state].sum()
        target = step.reward + step.gamma * (box.Q[step.next_state] @ shares).max()
        entry = step.state, step.action, step.other_action
        box.Q[entry] += ALPHA * (target - box.Q[entry])


def of_traces(kind: Any, traces: Any) -> Any:
    """SARSA(λ) or Q(λ)."""
    return kind.create((N_STATES, N_ACTIONS), traces=traces, trace_decay=LAMBDA, **HOW)


def of_vectors(whole: bool) -> Any:
    """Chebyshev Q-learning."""
    how = {**HOW, "discount": 1.0} if whole else HOW
    return ChebyshevQLearning.create((N_STATES, N_ACTIONS, 2), WEIGHTS, margin=MARGIN, whole_returns=whole, **how)


def of_a_game() -> Any:
    """Fictitious play, in as many states as there are here."""
    agent: Any = games.FictitiousPlay.create(GAME, 0, **HOW)
    return agent._replace(**{name: np.repeat(getattr(agent, name), N_STATES, axis=0) for name in agent._fields[:3]})


TABLE = N_STATES, N_ACTIONS
TRACES = {"accumulating": eg.Accumulating(), "replacing": eg.Replacing(), "Dutch": eg.Dutch()}
BOXES: dict[str, tuple[Any, Any, str, str]] = {
    "Q-learning": (lambda: eg.QLearning.create(TABLE, **HOW), expected_sarsa(best), "Q", ""),
    "double Q-learning": (lambda: eg.DoubleQLearning.create(TABLE, **HOW), double_q, "Q1 Q2", "Q"),
    "expected SARSA, ε-greedy": (
        lambda: eg.ExpectedSARSA.create(TABLE, exploration=eg.EpsilonGreedy(EPSILON), **HOW),
        expected_sarsa(epsilon_greedy), "Q", "",
    ),
    "expected SARSA, softmax": (
        lambda: eg.ExpectedSARSA.create(TABLE, exploration=eg.Softmax(SPREAD), **HOW),
        expected_sarsa(softmax), "Q", "",
    ),
    **{
        f"{name}, {kind}": (
            lambda agent=agent, traces=traces: of_traces(agent, traces),
            with_traces(kind, greedy=agent is eg.QLambda), "Q", "",
        )
        for name, agent in (("SARSA(λ)", eg.SARSALambda), ("Q(λ)", eg.QLambda))
        for kind, traces in TRACES.items()
    },
    "Chebyshev": (lambda: of_vectors(False), chebyshev(whole=False), "Q", "best_returns"),
    "Chebyshev, whole returns": (lambda: of_vectors(True), chebyshev(whole=True), "Q", "best_returns"),
    "Lagrangian": (
        lambda: LagrangianQLearning.create((*TABLE, 2), [LIMIT], multiplier_rate=RATE, initial_multiplier=1.0, **HOW),
        lagrangian, "Q", "multipliers",
    ),
    "fictitious play": (of_a_game, fictitious_play, "Q", "others played"),
}  # fmt: skip
"""How each is made, its box, the tables that begin with random numbers, and the others that are compared."""


@pytest.mark.parametrize("seed", [0, 1])
@pytest.mark.parametrize("name", BOXES)
def test_the_agent_is_its_box(name: str, seed: int) -> None:
    """In every table."""
    create, learn, random, others = BOXES[name]
    agent, rng = create(), np.random.default_rng(seed)
    for table in random.split():
        getattr(agent, table)[...] = rng.normal(size=getattr(agent, table).shape)
    box = SimpleNamespace(**{table: getattr(agent, table).copy() for table in (*random.split(), *others.split())})
    steps = random_steps(seed)
    for step in steps:
        told(agent, step)
    learn(box, steps)
    for table, expected in vars(box).items():
        assert np.abs(getattr(agent, table) - expected).max() < 1e-12 * max(1.0, np.abs(expected).max())


@pytest.mark.parametrize("seed", range(3))
def test_the_sets_of_pareto_q_learning_are_those_of_its_box(seed: int) -> None:
    """Of every state, after every step."""
    agent = ParetoQLearning.create((*TABLE, 2), discount=GAMMA)
    rewards: dict[tuple[int, int], list[Reals]] = {}
    futures: dict[tuple[int, int], list[Any]] = {}

    def front(state: int) -> list[Any]:
        points = [
            tuple(np.mean(rewards[state, action], axis=0) + GAMMA * np.array(future))
            for action in range(N_ACTIONS)
            for future in futures.get((state, action), [])
        ]
        return sorted(p for p in points if not any(q != p and q[0] >= p[0] and q[1] >= p[1] for q in points))

    for step in random_steps(seed, forward=True, n=150):
        told(agent, step)
        pair = step.state, step.action
        rewards.setdefault(pair, []).append(step.rewards)
        futures[pair] = [(0.0, 0.0)] if step.terminated else front(step.next_state)
        for state in range(N_STATES):
            assert agent.front(state).ravel() == pytest.approx(np.ravel(front(state)), rel=1e-12, abs=1e-12)
