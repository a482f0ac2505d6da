"""UCT: its simulations by hand, beside another implementation, and its choices beside the exact ones."""

import math
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from edugym import (
    UCB,
    UCT,
    EpsilonGreedy,
    Greedy,
    finite_horizon,
    finite_model,
    games,
    make_mdp,
    train,
    value_iteration,
)
from edugym.agents.search_tree import OUTSIDE, ROOT
from edugym.envs.games.soccer import WEST
from edugym.mdp.protocol import Random
from tests.agents.walk import Walk
from tests.messages import named


def drawing(*numbers: float) -> Any:
    """A generator of random numbers that gives those that are written here."""
    return SimpleNamespace(random=iter(numbers).__next__)


def corridor(**settings: Any) -> UCT:
    """0 → 1 → 2 → 3, the end, by action 1, each for -1 and the last for 8; action 0 stays, for -1. γ = 1/2."""
    agent = UCT.create((4, 2), discount=0.5, **settings)
    for state in (0, 1, 2):
        agent.learn(state, 0, -1.0, state, False)
        agent.learn(state, 1, 8.0 if state == 2 else -1.0, state + 1, state == 2)
    return agent


def test_three_simulations_by_hand() -> None:
    """Depth 3 and c = 0: each tries what was not tried, adds a node, and rolls out by actions that are drawn here."""
    agent = corridor(simulations=3, depth=3, c=0)
    agent.tree.plant(0)
    stay, go, any_outcome, first, second = 0.1, 0.6, 0.5, 0.9, 0.1
    # Both actions are untried: the second one replaces the first if 2 x the number is below 1. Then state 0, staying
    # twice: -1 + (-1 - 1/2)/2.
    agent.simulate(drawing(first, any_outcome, stay, any_outcome, stay, any_outcome))
    assert (agent.tree.values[ROOT].tolist(), agent.tree.counts[ROOT].tolist()) == ([-1.75, 0], [1, 0])
    assert (agent.tree.n[0], agent.tree.states[1], agent.tree.first[ROOT].tolist()) == (2, 0, [1, OUTSIDE])
    # The untried action, to state 1, and from there to the end: -1 + (-1 + 8/2)/2.
    agent.simulate(drawing(any_outcome, go, any_outcome, go, any_outcome))
    assert (agent.tree.values[ROOT].tolist(), agent.tree.counts[ROOT].tolist()) == ([-1.75, 0.5], [1, 1])
    # Action 1 is the better one; in its node 2 (state 1) the second action; state 2 is new, and there it stays once.
    agent.simulate(drawing(any_outcome, second, any_outcome, stay, any_outcome))
    assert agent.tree.values[ROOT].tolist() == [-1.75, (0.5 + (-1 + (-1 - 1 / 2) / 2)) / 2]
    assert (agent.tree.values[2].tolist(), agent.tree.counts[2].tolist()) == ([0, -1.5], [0, 1])
    assert (agent.tree.n[0], agent.tree.states[:4].tolist(), agent.tree.first[2].tolist()) == (4, [0, 0, 1, 2], [-1, 3])


def test_the_upper_bound_is_that_of_the_strategy() -> None:
    """Q + c √(ln t / N): at c = 1 the action that was tried four times as often needs a lead of 0.77."""
    agent = corridor(simulations=9)
    agent.tree.plant(0)
    for lead, chosen in ((0.6, 1), (0.8, 0)):
        agent.tree.counts[ROOT], agent.tree.values[ROOT] = [4, 1], [lead, 0.0]
        assert math.sqrt(math.log(6) / 1) - math.sqrt(math.log(6) / 4) == pytest.approx(0.669, abs=1e-3)
        assert agent.select(ROOT, np.random.default_rng(0)) == chosen


class Plain:
    """UCT once more, by recursion over dictionaries, as one writes it on the board."""

    def __init__(self, agent: UCT) -> None:
        """The same settings, and what the agent's model says."""
        self.agent, self.model = agent, agent.model

    def search(self, state: int, rng: Random) -> Any:
        """For each action of the root its count and its value."""
        root: dict[Any, Any] = {}
        for _ in range(self.agent.simulations):
            self.visit(root, state, 0, rng)
        return root["actions"]

    def outcome(self, state: int, action: int, rng: Random) -> int | None:
        """An outcome, drawn as the agent's model draws it; None for an action without one."""
        if not self.model.visits[state, action]:
            return None
        chain, k = [], int(self.model.first[state, action])
        while k >= 0:
            chain.append(k)
            k = int(self.model.following[k])
        left = rng.random() * sum(self.model.weights[k] for k in chain)
        for k in chain[:-1]:
            left -= self.model.weights[k]
            if left < 0:
                return k
        return chain[-1]

    def after(self, k: int) -> tuple[float, int, bool]:
        """Reward, next state, and whether it ends."""
        return float(self.model.rewards[k]), int(self.model.next_states[k]), bool(self.model.ends[k])

    def visit(self, node: dict[Any, Any], state: int, steps: int, rng: Random) -> float:
        """One simulation from a node on; gives its return."""
        if steps == self.agent.depth:
            return 0.0
        n_actions = self.agent.Q.shape[1]
        table = node.setdefault("actions", {a: [0, 0.0] for a in range(n_actions)})
        t = 1 + sum(n for n, _ in table.values())
        bounds = {a: q + self.agent.c * math.sqrt(math.log(t) / n) if n else math.inf for a, (n, q) in table.items()}
        best, ties = 0, 1
        for a in range(1, n_actions):
            if bounds[a] == bounds[best] or abs(bounds[a] - bounds[best]) < 1e-12 * abs(bounds[best]):
                ties += 1
                best = a if rng.random() * ties < 1 else best
            elif bounds[a] > bounds[best]:
                best, ties = a, 1
        table[best][0] += 1
        k = self.outcome(state, best, rng)
        if k is None:
            G = float(self.agent.Q[state, best])
        else:
            reward, after, ends = self.after(k)
            if ends:
                G = reward
            elif (best, k) in node:
                G = reward + self.agent.discount * self.visit(node[best, k], after, steps + 1, rng)
            else:
                node[best, k] = {}
                G = reward + self.agent.discount * self.random_return(after, steps + 1, rng)
        table[best][1] = ((table[best][0] - 1) * table[best][1] + G) / table[best][0]
        return G

    def random_return(self, state: int, steps: int, rng: Random) -> float:
        """The return of random actions."""
        if steps == self.agent.depth:
            return 0.0
        action = int(rng.random() * self.agent.Q.shape[1])
        k = self.outcome(state, action, rng)
        if k is None:
            return float(self.agent.Q[state, action])
        reward, after, ends = self.after(k)
        return reward if ends else reward + self.agent.discount * self.random_return(after, steps + 1, rng)


@pytest.mark.parametrize("given", [True, False])
@pytest.mark.parametrize(("depth", "c"), [(1, 1.0), (5, 0.3), (12, 3.0)])
def test_another_implementation_gives_the_same(given: bool, depth: int, c: float) -> None:
    """With the same random numbers, in the exact model and in one that was learned from 60 steps."""
    mdp = Walk(n=7)
    agent = UCT.create(mdp, model=finite_model(mdp) if given else None, simulations=150, depth=depth, c=c, discount=0.9)
    if not given:
        train(mdp, agent, 60, seed=1, evaluate_every=60)
    for state in range(1, 7):
        agent.search(state, np.random.default_rng(state))
        other = Plain(agent).search(state, np.random.default_rng(state))
        assert [n for n, _ in other.values()] == agent.tree.counts[ROOT].tolist()
        assert [q for _, q in other.values()] == pytest.approx(agent.tree.values[ROOT], abs=1e-12)


def test_with_many_simulations_it_finds_the_best_action() -> None:
    """In every state, the values come near those of dynamic programming as many steps ahead; a few are far off."""
    mdp = Walk(n=6)
    model, rng = finite_model(mdp), np.random.default_rng(0)
    exact = finite_horizon(model, 8, 0.7)[8].Q
    far: list[float] = []
    for simulations in (20, 2_000):
        agent = UCT.create(mdp, model=model, simulations=simulations, depth=8, c=1, discount=0.7)
        actions, errors = [], []
        for state in range(1, 6):
            actions.append(agent.greedy(state, rng))
            assert agent.tree.counts[ROOT].sum() == simulations
            errors.append(abs(agent.tree.values[ROOT].max() - exact[state].max()))
        far.append(max(errors))
    assert actions == exact[1:6].argmax(axis=1).tolist()
    assert far[1] < 0.06 < far[0]


def test_what_the_model_has_never_seen_is_worth_its_initial_value() -> None:
    """0 → 1 for -1 was seen, nothing else: there the simulation ends with 5, or with 5 at once by the other action."""
    agent = UCT.create((3, 2), simulations=50, initial_value=5.0, discount=0.5)
    agent.learn(0, 0, -1.0, 1, False)
    agent.act(0, np.random.default_rng(0))
    assert agent.Q[0].tolist() == [pytest.approx(-1 + 5 / 2), 5.0]
    assert agent.Q[1:].tolist() == [[5.0, 5.0], [5.0, 5.0]]
    assert {agent.greedy(1, np.random.default_rng(k)) for k in range(20)} == {0, 1}  # of which nothing is known
    assert agent.tree.counts[ROOT].tolist() == [0, 0]


def test_no_more_nodes_than_allowed() -> None:
    """With one node only the root learns, and what follows is random: from 0 the end is then three steps away."""
    agent = corridor(simulations=4_000, nodes=1, depth=3, c=1)
    agent.search(0, np.random.default_rng(0))
    assert agent.tree.n[0] == 1
    # By action 1 to state 1, then at random: staying, and -1 for the last step; or going on, and the mean of -1 and 8.
    staying, going = -1 - 1 / 2, -1 + (-1 + 8) / 2 / 2
    assert agent.tree.values[ROOT, 1] == pytest.approx(-1 + (staying + going) / 2 / 2, abs=0.1)
    deep = corridor(simulations=4_000, depth=3, c=1)
    deep.search(0, np.random.default_rng(0))
    assert deep.tree.values[ROOT, 1] == pytest.approx(-1 + (-1 + 8 / 2) / 2, abs=0.1)


def test_act_explores_by_its_strategy_and_keeps_the_values_of_the_root() -> None:
    """`greedy` changes none of them."""
    agent = corridor(simulations=200, depth=3, c=2, exploration=Greedy())
    assert agent.greedy(0, np.random.default_rng(0)) == 1
    assert not agent.Q.any()
    assert agent.act(0, np.random.default_rng(0)) == 1
    assert agent.Q[0].tolist() == agent.tree.values[ROOT].tolist()
    wild = agent._replace(exploration=EpsilonGreedy(1.0))
    assert {wild.act(0, np.random.default_rng(k)) for k in range(20)} == {0, 1}


def test_it_shops_by_simulating() -> None:
    """A few steps before the exit of the Supermarket, with nothing left to get, the way out is found."""
    mdp = make_mdp("Supermarket")
    agent = UCT.create(mdp, model=finite_model(mdp), simulations=400, depth=8, c=50)
    state = 80 * 7 + 8 * 8 + 7  # two steps above the exit, with all three items
    assert agent.greedy(state, np.random.default_rng(0)) == 1


def test_it_plays_soccer_by_simulating() -> None:
    """Against an opponent that it knows, a thousand simulations find a best action everywhere, and five do not."""
    runner = np.zeros((801, 5))
    runner[:, WEST] = 1.0
    mdp = games.against(games.Soccer.create(), 0, runner)
    model = finite_model(mdp)
    exact, seen = value_iteration(model, 0.9), model.observations()
    rows, lost = np.flatnonzero(~model.terminal)[::3], {}
    for n in (5, 1_000):
        agent = UCT.create(mdp, model=model, simulations=n, discount=0.9)
        actions = [agent.greedy(int(seen[row]), np.random.default_rng(row)) for row in rows]
        lost[n] = (exact.V[rows] - exact.Q[rows, actions]).mean()
    assert lost[1_000] == pytest.approx(0.0, abs=1e-9)
    assert lost[5] > 0.005


def test_fewer_simulations_than_actions_are_refused() -> None:
    """The root would have actions without a value."""
    with pytest.raises(ValueError, match=named("simulations", "at least 4", "actions", "3")):
        UCT.create((5, 4), simulations=3)
    assert UCT.create((5, 4), simulations=4).simulations == 4


def test_it_selects_as_the_strategy_does() -> None:
    """Which the tests of strategies compare with equation 2.10."""
    agent = corridor(simulations=9, c=0.7)
    strategy = UCB.create((4, 2), 0.7)
    agent.tree.plant(0)
    agent.tree.values[ROOT] = [0.3, 0.2]
    one, other = np.random.default_rng(0), np.random.default_rng(0)
    for _ in range(30):
        assert agent.select(ROOT, one) == strategy.choose(agent.tree.values, ROOT, other)
    assert agent.tree.counts[ROOT].tolist() == strategy.counts[ROOT].tolist()
