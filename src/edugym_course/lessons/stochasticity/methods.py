"""The players of lesson 8: how they are trained, how they play afterwards, and players with simple rules."""

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from types import MappingProxyType
from typing import Annotated, Any, NamedTuple

import gymnasium
import numpy as np

from edugym.agents.q_learning import QLearning
from edugym.agents.risk_sensitive_q_learning import RiskSensitiveQLearning
from edugym.agents.settings import ActionValues, Table, new
from edugym.agents.strategies import EpsilonGreedy
from edugym.agents.tables import greedy_action
from edugym.envs.golf import SWINGS, Golf
from edugym.experiments.repeat import repeat
from edugym.experiments.results.statistics import Interval, paired_difference
from edugym.experiments.results.tables import Results
from edugym.mdp.protocol import Integers, Random, Reals
from edugym.training.train import train

LAKE = "FrozenLake-v1"
N_STEPS = 300_000
LONG = 3_000_000
"""The training steps of a patient player."""
SHORT = 30_000
"""The training steps for the speed of learning."""
PLAYED = 10_000
REPETITIONS = 30
LEARNING_RATE = 0.02
LOW_RATE = 0.005
"""The learning rate of a patient player."""
EPSILON = 0.1
DISCOUNT = 1.0
LEVEL, TOO_NOISY = 0.015, 0.02
"""The level at which aversion shows in lost balls, and one at which it does not."""
HARDLY = 0.002
"""A player whose share of lost balls is below this loses hardly a ball."""
LEVELS = (0.005, 0.01, 0.0125, 0.015, 0.0175, 0.02, 0.0225)
AVERSE, NEUTRAL, SEEKING = "averse, β = -2", "neutral, β = 0", "seeking, β = 2"
Maker = Callable[..., Any]
RISKS: Mapping[str, float] = MappingProxyType({AVERSE: -2.0, NEUTRAL: 0.0, SEEKING: 2.0})

NEUTRAL_ONLY: Mapping[str, float] = MappingProxyType({NEUTRAL: 0.0})


class Player(NamedTuple):
    """A player that follows a table greedily and keeps the score. It learns nothing else.

    Attributes:
        Q: shape (n_states, n_actions): the table.
        score: shape (1, 2 + hits): how many games were lost (off the course or out of hits), and won with 1, 2, ...
            hits.
        max_hits: of the game.
    """

    Q: ActionValues
    score: Annotated[Integers, Table((1, "scores"))]
    max_hits: int

    def act(self, state: int, rng: Random) -> int:
        """The swing with the highest value."""
        return greedy_action(self.Q, state, rng)

    def learn(self, reward: float, terminated: bool) -> None:
        """Count the hits of a game that is over; its reward tells them."""
        if terminated:
            hits = 0 if reward < 0.0 else 1 + round((1.0 - reward) * self.max_hits)
            self.score[0, hits] += 1

    @classmethod
    def create(cls, task: Golf, Q: Any) -> "Player":
        """A player without any score yet."""
        settings = {"max_hits": task.max_hits}
        return new(cls, task, settings, scores=task.max_hits + 1)._replace(Q=Q)


class Played(NamedTuple):
    """How the greedy policies of a method play.

    Attributes:
        mean: shape (n_repetitions,): the mean return.
        spread: shape (n_repetitions,): the standard deviation of the return.
        lost: shape (n_repetitions,): the share of lost balls (off the course or out of hits).
        games: shape (n_repetitions, 1 + hits): the share of lost games, and of those won with 1, 2, ... hits.
    """

    mean: Reals
    spread: Reals
    lost: Reals
    games: Reals

    @property
    def hits(self) -> Reals:
        """Shape (n_repetitions,): the mean number of hits in the games that were won; NaN where none was."""
        won = self.games[:, 1:]
        with np.errstate(invalid="ignore"):  # 0 / 0 is NaN
            mean: Reals = won @ np.arange(1, 1 + won.shape[1]) / won.sum(axis=1)
        return mean


def attitudes(beta: float) -> dict[str, float]:
    """Return three attitudes to risk, by label: avoiding it with -β, indifferent with 0, seeking it with β."""
    return {f"averse, β = {-beta:g}": -beta, NEUTRAL: 0.0, f"seeking, β = {beta:g}": beta}


def methods_with(
    risks: Mapping[str, float] = RISKS,
    epsilon: float = EPSILON,
    learning_rate: float = LEARNING_RATE,
    discount: float = DISCOUNT,
) -> dict[str, Maker]:
    """Return risk-sensitive Q-learning with several β: functions that make an agent for an environment.

    Args:
        risks: by label, β.
        epsilon: ε of all, from 0 to 1.
        learning_rate: α of all.
        discount: γ of all.
    """
    settings = {"learning_rate": learning_rate, "discount": discount, "exploration": EpsilonGreedy(epsilon)}
    return {label: partial(RiskSensitiveQLearning.create, risk=risk, **settings) for label, risk in risks.items()}


def learn(
    *,
    level: float = LEVEL,
    observe_hits: bool = True,
    risks: Mapping[str, float] = RISKS,
    epsilon: float = EPSILON,
    learning_rate: float = LEARNING_RATE,
    discount: float = DISCOUNT,
    own: Mapping[str, Maker] = MappingProxyType({}),
    n_steps: int = N_STEPS,
    points: int = 10,
    evaluation_episodes: int = 20,
    repetitions: int = REPETITIONS,
    **how: Any,
) -> Results:
    """Train risk-sensitive Q-learning with several β.

    Args:
        level: the stochasticity level of the game.
        observe_hits: whether the agent sees the number of hits.
        risks: by label, β.
        epsilon: ε of all of them.
        learning_rate: α of all of them.
        discount: γ of all of them.
        own: by label, functions that make agents to train beside them.
        n_steps: the training steps of each run.
        points: the number of points of each learning curve.
        evaluation_episodes: the games of each point.
        repetitions: the number of runs of each method.
        **how: more arguments of `edugym.experiments.repeat`, such as `seed` and `jobs`.
    """
    methods = {**methods_with(risks, epsilon, learning_rate, discount), **own}
    game = {"stochasticity_level": level, "observe_hits": observe_hits}
    curve: dict[str, Any] = {"evaluate_every": max(1, n_steps // points), "evaluation_episodes": evaluation_episodes}
    return repeat("Golf", methods, n_steps, parameters=game, repetitions=repetitions, **curve, **how)


def play(
    results: Results, *, level: float = LEVEL, observe_hits: bool = True, n_steps: int = PLAYED
) -> dict[str, Played]:
    """Let all trained agents play greedily; the game is that in which they were trained."""
    task = Golf.create(stochasticity_level=level, observe_hits=observe_hits)
    return {
        method: played([shares_of_games(task, agent.Q, n_steps, i) for i, agent in agents.items()], task.max_hits)
        for method in results.methods
        if (agents := results.complete_agents(method))
    }


def shares_of_games(task: Golf, Q: Any, n_steps: int, seed: int) -> Reals:
    """Return the share of lost games, and of games won with 1, 2, ... hits, of a player who follows a table."""
    player = Player.create(task, Q)
    train(task, player, n_steps, evaluate_every=n_steps, seed=seed)
    shares: Reals = player.score[0] / player.score.sum()
    return shares


def played(shares: Sequence[Reals], max_hits: int) -> Played:
    """Return mean and spread of the returns of several players, from the shares of their games."""
    returns = np.array([-1.0, *(1 - k / max_hits for k in range(max_hits))])
    games = np.array(shares).reshape(-1, len(returns))
    mean = games @ returns
    return Played(mean, np.sqrt(np.maximum(games @ returns**2 - mean**2, 0.0)), games[:, 0], games)


def scripted(nearest: float, farthest: float, chip_beyond: float, task: Golf) -> Reals:
    """Return the table of a player with a rule: a drive, a chip or a putt, by the distance of its cell from the flag.

    Args:
        nearest: it drives from cells that are at least so far away,
        farthest: and at most so far.
        chip_beyond: it chips from the other cells that are farther away than that, and putts from the rest.
        task: the game, in which hits are not observed.
    """
    x, y = np.meshgrid(np.arange(task.width) + 0.5, np.arange(task.length) + 0.5, indexing="ij")
    left = np.hypot(x - task.width / 2, y - (task.length - task.width / 2)).ravel()
    drives = (left >= nearest) & (left <= farthest)
    Q: Reals = np.eye(len(SWINGS))[np.where(drives, 2, np.where(left > chip_beyond, 1, 0))]
    return Q


def play_by_rules(level: float = LEVEL, n_steps: int = 100_000) -> dict[str, tuple[float, float]]:
    """Return the mean and the spread of the returns of players with rules, by what their rules say.

    Some of them throw a coin before each game, and play it by the fast or by the safe plan.
    """
    task = Golf.create(stochasticity_level=level)

    def games(nearest: float, farthest: float, chip_beyond: float) -> Reals:
        return shares_of_games(task, scripted(nearest, farthest, chip_beyond, task), n_steps, 0)

    never = 99.0
    rules = {"only putts": games(never, never, never)}
    for chip_beyond in (1.5, 2.8, 4.0, 6.0):
        rules[f"no drive, chip beyond {chip_beyond:g}"] = games(never, never, chip_beyond)
        for near, far in ((5.0, 9.0), (5.0, 20.0), (6.5, 11.0), (6.5, 20.0), (8.0, 11.0), (8.0, 20.0)):
            rules[f"drive from {near:g} to {far:g} cells, chip beyond {chip_beyond:g}"] = games(near, far, chip_beyond)
    safe, fast = rules[SAFE_RULE], rules[FAST_RULE]
    for share in (0.1, 0.25, 0.5, 0.75):
        rules[f"a coin: the fast plan in {share:.0%} of the games"] = share * fast + (1 - share) * safe
    every = played([*rules.values()], task.max_hits)
    return {rule: (float(every.mean[i]), float(every.spread[i])) for i, rule in enumerate(rules)}


SAFE_RULE, FAST_RULE = "no drive, chip beyond 2.8", "drive from 8 to 20 cells, chip beyond 2.8"


def landings(swing: int, level: float = LEVEL, balls: int = 1_000) -> tuple[Reals, float]:
    """Hit many balls from the tee.

    Args:
        swing: 0 putt, 1 chip, 2 drive.
        level: the stochasticity level.
        balls: how many.

    Returns:
        Where they land, shape (balls, 2), and the share that is lost.
    """
    task, rng = Golf.create(stochasticity_level=level), np.random.default_rng(0)
    tee = task.initial(rng)
    after = [task.transition(tee, swing, rng) for _ in range(balls)]
    return np.array([(ball.x, ball.y) for ball in after]), float(np.mean([task.off_course(ball) for ball in after]))


def learned_value(risk: float, draw: Callable[[Random], float], n_steps: int = 50_000, seed: int = 0) -> float:
    """Let risk-sensitive Q-learning learn the value of a step that pays by chance and ends; mean of the last half.

    Args:
        risk: β.
        draw: draws a reward.
        n_steps: how many steps it takes; the learning rate is 0.02.
        seed: the number from which the rewards are drawn.
    """
    agent, rng = (
        RiskSensitiveQLearning.create((1, 1), risk=risk, learning_rate=LEARNING_RATE),
        np.random.default_rng(seed),
    )
    values = np.zeros(n_steps)
    for step in range(n_steps):
        agent.learn(0, 0, draw(rng), 0, True)
        values[step] = agent.Q[0, 0]
    return float(values[n_steps // 2 :].mean())


def patient(risk: float = 0.0, *, n_steps: int = LONG, repetitions: int = 10, **how: Any) -> Results:
    """Train a player whose values start at 1, with a smaller learning rate, for longer; arguments as in `learn`.

    Its label is that of the neutral player, whatever β it has.
    """
    player = partial(methods_with({NEUTRAL: risk}, learning_rate=LOW_RATE)[NEUTRAL], initial_value=1.0)
    return learn(risks={}, own={NEUTRAL: player}, n_steps=n_steps, repetitions=repetitions, **how)


def share_of_drivers(played: Played) -> float:
    """Return the share of runs that have learned to drive: those that lose more than 1 ball in 100."""
    return float((played.lost > 0.01).mean())


def lead(of: Played, over: Played) -> Interval:
    """Return how much more one player earns on average than another, paired by repetition."""
    return paired_difference(of.mean, over.mean)


def values_on_the_tee(results: Results) -> dict[str, Reals]:
    """Return the values of the three swings from the tee, a mean over the complete runs; hits are observed."""
    return {method: np.mean(_on_the_tee(results, method), axis=0) for method in results.methods}


def first_swings(results: Results, method: str, observe_hits: bool = True) -> Integers:
    """Return the first swing of the greedy policy of every complete run, shape (n,)."""
    swings: Integers = _on_the_tee(results, method, observe_hits).argmax(axis=1)
    return swings


def _on_the_tee(results: Results, method: str, observe_hits: bool = True) -> Reals:
    """Return the values of the three swings from the tee in every complete run, shape (n, 3)."""
    golf = Golf.create()
    row = (golf.width // 2) * golf.length * (golf.max_hits + 1 if observe_hits else 1)
    return np.array([agent.Q[row] for agent in results.complete_agents(method).values()]).reshape(-1, len(SWINGS))


def by_first_swing(
    results: Results, played: Mapping[str, Played], observe_hits: bool = True
) -> dict[str, dict[str, tuple[int, float, float]]]:
    """Return by method and by the first swing of its runs: how many they are, their mean return, their lost balls."""
    table = {}
    for method, one in played.items():
        first = first_swings(results, method, observe_hits)
        runs = {swing: first == k for k, swing in enumerate(SWINGS) if (first == k).any()}
        table[method] = {
            swing: (int(of.sum()), float(one.mean[of].mean()), float(one.lost[of].mean())) for swing, of in runs.items()
        }
    return table


def lake_optimum(steps: int = 100) -> float:
    """Return the best probability to arrive on the slippery lake within the steps of an episode."""
    lake: Any = gymnasium.make(LAKE, is_slippery=True).unwrapped
    P = lake.P
    V = np.zeros(len(P))
    for _ in range(steps):
        V = np.array(
            [max(sum(p * (r + (not ends) * V[after]) for p, after, r, ends in P[s][a]) for a in P[s]) for s in P]
        )
    return float(V[0])


def compare_on_lake(
    slippery: bool,
    rates: Sequence[float] = (1.0, 0.3, 0.05),
    *,
    n_steps: int = 10_000,
    repetitions: int = 6,
    **how: Any,
) -> Results:
    """Train Q-learning with several learning rates on the frozen lake of Gymnasium.

    Args:
        slippery: whether the ice makes the agent slip.
        rates: the learning rates.
        n_steps: the training steps of each run.
        repetitions: the number of runs of each rate.
        **how: more arguments of `edugym.experiments.repeat`.
    """
    settings: dict[str, Any] = {"discount": 0.99, "exploration": EpsilonGreedy(EPSILON), "initial_value": 1.0}
    methods = {f"α = {rate:g}": partial(QLearning.create, learning_rate=rate, **settings) for rate in rates}
    return repeat(
        LAKE,
        methods,
        n_steps,
        parameters={"is_slippery": slippery},
        evaluate_every=max(1, n_steps // 10),
        evaluation_episodes=10 if slippery else 1,
        repetitions=repetitions,
        **how,
    )


def late(results: Results) -> Reals:
    """Return the mean of the last five evaluations of Q-learning in every run, shape (n_repetitions,)."""
    return results.late(NEUTRAL)


def share_learned(results: Results, step: int, best: float) -> Reals:
    """Return how far Q-learning has come after a number of steps, on the way from random play (0) to the best (1)."""
    first = results.at(NEUTRAL, 0)
    share: Reals = (results.at(NEUTRAL, step) - first) / (best - first)
    return share
