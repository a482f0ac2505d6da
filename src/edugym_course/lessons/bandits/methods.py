"""What lesson 0b does: agents pull the arms of a bandit. Every pull is noted, so that the regret is known exactly."""

import threading
from collections.abc import Callable, Mapping
from functools import partial
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np

from edugym.adapters.registration import make_mdp
from edugym.agents.gradient_bandit import GradientBandit
from edugym.agents.q_learning import QLearning
from edugym.agents.sample_average import SampleAverage
from edugym.agents.strategies import UCB, EpsilonGreedy, Greedy, ScheduledEpsilonGreedy, Softmax
from edugym.agents.tables import greedy_action
from edugym.agents.thompson_sampling import ThompsonSampling
from edugym.checks.contract import LEARN_PARAMETERS, contract_of, learner
from edugym.compiled.execution import executable
from edugym.mdp.protocol import Integers, Random, Reals
from edugym_course.lessons.maximisation_bias.methods import seeds

N_ARMS, GAP, N_PULLS, REPETITIONS = 10, 0.2, 10_000, 100
SHORT = 300
"""Greedy has found its arm by then."""
EPSILON, LEARNING_RATE, DISCOUNT, BONUS, SPREAD, FALLING = 0.1, 0.1, 0.0, 0.7, 0.5, 200.0


class TryFirst(NamedTuple):
    """Explore, then commit: first try every action equally often, and from then on take the best mean.

    Attributes:
        counts: shape (n_states, n_actions): how often each action was chosen in each state.
        tries: how often each action is tried first, 1 or more.
    """

    counts: Integers
    tries: int

    def choose(self, Q: Reals, state: int, rng: Random) -> int:
        """The action that was tried least, until all were tried often enough; then the best one, ties at random."""
        chosen = int(self.counts[state].argmin())
        if self.counts[state, chosen] >= self.tries:
            chosen = greedy_action(Q, state, rng)
        self.counts[state, chosen] += 1
        return chosen


class BonusAtFirst(NamedTuple):
    """UCB that loses its bonus after some pulls, and takes the best mean from then on.

    Attributes:
        ucb: which chooses at first.
        pulls: how many pulls it chooses.
    """

    ucb: UCB
    pulls: int

    def choose(self, Q: Reals, state: int, rng: Random) -> int:
        """The action with the highest upper bound, and later that with the best mean, ties at random."""
        if self.ucb.counts[state].sum() < self.pulls:
            return self.ucb.choose(Q, state, rng)
        return greedy_action(Q, state, rng)


class OneOverT(NamedTuple):
    """An ε that falls as 1/t: min(1, first / t) at pull t.

    Attributes:
        first: the pull up to which every arm is random, 1 or more.
    """

    first: float

    def value(self, step: int) -> float:
        """ε after `step` pulls."""
        return min(1.0, self.first / (step + 1))


def averages(strategy: Callable[[Any], Any]) -> Callable[[Any], Any]:
    """Return what makes an agent with sample averages that chooses by a strategy of its own."""
    return lambda mdp: SampleAverage.create(mdp, exploration=strategy(mdp))


def constant(**settings: Any) -> Callable[[Any], Any]:
    """Return what makes an agent with a constant step size: Q-learning that does not look ahead."""
    return partial(QLearning.create, **{"learning_rate": LEARNING_RATE, "discount": DISCOUNT, **settings})


RANDOM, GREEDY, SLIPS, DECAY = "random", "greedy", "ε-greedy", "falling ε"
HOPE, BOUNDS, THOMPSON, GRADIENT = "optimistic", "UCB", "Thompson sampling", "gradient bandit"
STEADY, AT_FIRST = "ε-greedy, constant α", "UCB, bonus at first"
N_FIRST = 1000
"""For so many pulls UCB has its bonus, in the control."""
METHODS: Mapping[str, Callable[[Any], Any]] = MappingProxyType(
    {
        RANDOM: averages(lambda mdp: EpsilonGreedy(1.0)),
        GREEDY: averages(lambda mdp: Greedy()),
        SLIPS: averages(lambda mdp: EpsilonGreedy(EPSILON)),
        DECAY: averages(lambda mdp: ScheduledEpsilonGreedy.create(OneOverT(FALLING))),
        HOPE: constant(exploration=Greedy(), initial_value=1.0),
        BOUNDS: averages(partial(UCB.create, c=BONUS)),
        THOMPSON: averages(partial(ThompsonSampling.create, spread=SPREAD)),
        GRADIENT: partial(GradientBandit.create, learning_rate=LEARNING_RATE),
        STEADY: constant(exploration=EpsilonGreedy(EPSILON)),
        AT_FIRST: averages(lambda mdp: BonusAtFirst(UCB.create(mdp, c=BONUS), N_FIRST)),
    }
)
IN_THE_FIGURE = (GREEDY, SLIPS, DECAY, HOPE, BOUNDS, THOMPSON, GRADIENT)


def tries_first(tries: int) -> Callable[[Any], Any]:
    """Return what makes an agent that tries every arm so often, and then stays with the best mean."""
    return averages(lambda mdp: TryFirst(np.zeros((1, mdp.n_arms), np.int64), tries))


def softmax_of_means(temperature: float) -> Callable[[Any], Any]:
    """Return what makes an agent that draws arms by a softmax of their means."""
    return averages(lambda mdp: Softmax(temperature))


def agent_of(method: str | Callable[[Any], Any], mdp: Any) -> Any:
    """Return a new agent with the settings of the lesson: by its label in `METHODS`, or by what makes it."""
    return METHODS[method](mdp) if isinstance(method, str) else method(mdp)


Arms = np.ndarray[tuple[int, ...], np.dtype[np.int16]]
"""Numbers of arms: short ones, since a report keeps some hundred million."""


class Pulls(NamedTuple):
    """What agents did, by run and pull.

    Attributes:
        arms: shape (runs, n_pulls): the arm that was pulled.
        best: shape (runs, n_pulls): the arm that was the best one then.
        gap: Δ, what the pull of another arm costs on average.
    """

    arms: Arms
    best: Arms
    gap: float

    def regret(self, after: int | None = None) -> Reals:
        """The regret of each run after so many pulls, by default after all."""
        missed: Reals = self.gap * (self.arms != self.best)[:, :after].sum(axis=1)
        return missed

    def between(self, first: int, last: int) -> Reals:
        """The regret of one pull on average, from pull `first` + 1 to pull `last`, by run."""
        share: Reals = (self.regret(last) - self.regret(first)) / (last - first)
        return share

    def settled(self) -> Reals:
        """Whether the best arm had most of the last tenth of the pulls, 1 or 0, by run."""
        late = slice(-self.arms.shape[1] // 10, None)
        return np.array((self.arms == self.best)[:, late].mean(axis=1) > 0.5, float)

    def by_rank(self) -> Reals:
        """How often each arm was pulled, the best one first and then from the most pulled: shape (runs, n_arms)."""
        rows = []
        for arms, best in zip(self.arms, self.best, strict=True):
            counts = np.bincount(arms, minlength=self.arms.max() + 1)
            rows.append([counts[best[0]], *sorted(np.delete(counts, best[0]), reverse=True)])
        return np.array(rows, float)


def pull(
    n_pulls: int, mdp: Any, agent: Any, arms: Arms, best: Arms, environment_rng: Random, agent_rng: Random
) -> None:
    """Pull arms, learn, and note every pull and what would have been the best one.

    Args:
        n_pulls: how many.
        mdp: the bandit.
        agent: who pulls.
        arms: shape (n_pulls,): where the arms are noted.
        best: shape (n_pulls,): where the best arms are noted.
        environment_rng: what the bandit draws from.
        agent_rng: what the agent draws from.
    """
    state = mdp.initial(environment_rng)
    for t in range(n_pulls):
        arm = agent.act(0, agent_rng)
        next_state = mdp.transition(state, arm, environment_rng)
        reward = mdp.reward(state, arm, next_state, environment_rng)
        agent.learn(0, arm, reward, 0, False, False)
        arms[t], best[t] = arm, state
        state = next_state


def pulls(
    method: str | Callable[[Any], Any],
    n_pulls: int = N_PULLS,
    *,
    repetitions: int = REPETITIONS,
    seed: int = 0,
    stop: threading.Event | None = None,
    **bandit: Any,
) -> Pulls:
    """Let new agents pull, each in a bandit of its own, in which another arm is the best one.

    Args:
        method: its label in `METHODS`, or what makes an agent.
        n_pulls: how many.
        repetitions: how many agents.
        seed: of the repetitions.
        stop: set by whoever wants no more.
        **bandit: the parameters of Bandit.
    """
    arms, best = np.zeros((2, repetitions, n_pulls), np.int16)
    code, done = None, 0
    for number in seeds(seed, repetitions, stop):
        mdp = make_mdp("Bandit", **bandit, layout_seed=number)
        agent = learner(contract_of(agent_of(method, mdp), LEARN_PARAMETERS), LEARN_PARAMETERS)
        arguments = mdp, agent, arms[done], best[done], *np.random.default_rng(number).spawn(2)
        code = code or executable(pull, arguments, expected=repetitions * n_pulls)
        code(n_pulls, *arguments)
        done += 1
    return Pulls(arms[:done], best[:done], float(bandit.get("gap", GAP)))


def stuck(n_arms: int = N_ARMS, gap: float = GAP) -> float:
    """The probability that the first arm that pays is the best one, exactly, if arms are drawn at random until then."""
    return (1 + gap) / (1 + gap + (n_arms - 1) * (1 - gap))


def slope(epsilon: float, n_arms: int = N_ARMS, gap: float = GAP) -> float:
    """The regret of a pull that is random with probability ε, and else the best arm: ε Δ (n - 1)/n."""
    return epsilon * gap * (n_arms - 1) / n_arms


def softmax_slope(temperature: float, n_arms: int = N_ARMS, gap: float = GAP) -> float:
    """The regret of a pull that is drawn by a softmax of the true means: Δ (n - 1) / (n - 1 + exp(Δ/τ))."""
    return gap * (n_arms - 1) / (n_arms - 1 + float(np.exp(gap / temperature)))
