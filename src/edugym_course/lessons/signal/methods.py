"""The methods of lesson 6, and how they are trained and evaluated."""

import math
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from edugym.agents.q_learning import QLearning
from edugym.agents.strategies import EpsilonGreedy
from edugym.envs.tamagotchi import Tamagotchi
from edugym.experiments.repeat import repeat
from edugym.experiments.results.tables import Results, joined
from edugym.mdp.frame_stack import FrameStack
from edugym.mdp.protocol import Reals
from edugym_course.lessons.signal.players import Voter

Maker = Callable[[Any], Any]

N_STEPS = 200_000
LONG = 1_600_000
REPETITIONS = 10
LEARNING_RATE = 0.02
DISCOUNT = 0.5
EPSILON = 0.1

OPTIMUM, RANDOM_PLAY = 6706.85, -676.0
"""The expected returns of the best policy, and of random actions (see `Tamagotchi`)."""
TAUS = (0.0, 0.02, 0.05, 0.1, math.inf)
NOISY = 0.1
"""The τ at which messages of different lengths are compared."""
VOCABULARIES = (4, 16, 64, 2)
LENGTHS = (1, 4, 8, 16, 28)
"""The lengths of messages for players without a table. 28 is the most that Tamagotchi allows."""
FOUR = 4
"""The length of messages for Q-learning."""


def learner(learning_rate: float = LEARNING_RATE, discount: float = DISCOUNT, epsilon: float = EPSILON) -> Maker:
    """Return a function that makes a Q-learning agent for a task."""
    return partial(QLearning.create, learning_rate=learning_rate, discount=discount, exploration=EpsilonGreedy(epsilon))


def learn(
    *,
    n_steps: int = N_STEPS,
    evaluate_every: int = N_STEPS // 20,
    evaluation_episodes: int = 10,
    learning_rate: float = LEARNING_RATE,
    discount: float = DISCOUNT,
    epsilon: float = EPSILON,
    environment: Any = "Tamagotchi",
    **how: Any,
) -> Results:
    """Train Q-learning.

    Args:
        n_steps: the training steps of each run.
        evaluate_every: the steps between two points of the curve.
        evaluation_episodes: the episodes of each point.
        learning_rate: α.
        discount: γ.
        epsilon: ε of ε-greedy exploration.
        environment: the task.
        **how: more arguments of `edugym.experiments.repeat`, such as `parameters`, `repetitions`, `seed` and `jobs`.
    """
    make = learner(learning_rate, discount, epsilon)
    curve: dict[str, Any] = {"evaluate_every": evaluate_every, "evaluation_episodes": evaluation_episodes}
    return repeat(environment, {"Q-learning": make}, n_steps, **curve, **how)


def learn_with_memory(vocab_size: int = 1, *, actions: bool = True, **how: Any) -> Results:
    """Train Q-learning on a toy that always says the same word, with the last two observations and the action between.

    All it can use is its hit points and its own last action, if `actions`. Other arguments as in `learn`.
    """
    return learn(environment=FrameStack.create(Tamagotchi.create(vocab_size=vocab_size), 2, actions=actions), **how)


def play(maker: Any, environment: Any = "Tamagotchi", **how: Any) -> Reals:
    """Return the mean return of a player without a table in each repetition, shape (n_repetitions,)."""
    n_steps = 20_000
    results = repeat(environment, {"player": maker}, n_steps, evaluate_every=n_steps, **how)
    return results.final("player", "training_return")


def vote(tau: float, length: int, heard: int, *, vocab_size: int = 4, **how: Any) -> Reals:
    """Return the mean return of a voter in each repetition: `heard` words of messages of `length` words count."""
    parameters = {"tau": tau, "max_msg_length": length, "vocab_size": vocab_size}
    return play(partial(Voter.create, heard=heard), parameters=parameters, **how)


def conditions(results: Mapping[str, Results]) -> Results:
    """Join the results of one method under several conditions, with the conditions as methods."""
    return joined(part.renamed(label) for label, part in results.items())


def time_below(results: Results, method: str, threshold: float) -> Reals:
    """Return the share of evaluations in the second half of training below a threshold, shape (n_repetitions,)."""
    returns = results.curves(method).to_numpy(float)
    share: Reals = (returns[len(returns) // 2 :] < threshold).mean(axis=0)
    return share


def late(results: Results, method: str) -> Reals:
    """Return the mean of the evaluations in the second half of training, shape (n_repetitions,)."""
    points = len(results.curves(method))
    return results.late(method, points - points // 2)


def rows_of_table(length: int, vocab_size: int = 4) -> int:
    """Return the number of rows of Q for messages of this length: 101 hit points, and H^length messages with each."""
    rows: int = 101 * vocab_size**length
    return rows


def noise_label(tau: float) -> str:
    """Return the label of a τ."""
    return "τ = ∞" if tau == math.inf else f"τ = {tau:g}"


def compare_vocabularies(sizes: Sequence[int] = VOCABULARIES, **how: Any) -> Results:
    """Train Q-learning without noise on vocabularies of several sizes; arguments as in `learn`."""
    return conditions({f"{size} words": learn(parameters={"vocab_size": size}, **how) for size in sizes})


def after(results: Results, step: int) -> Reals:
    """Return the evaluations of Q-learning after a number of steps, shape (n_repetitions,)."""
    return results.at("Q-learning", step)


def learn_long(length: int = FOUR, learning_rate: float = LEARNING_RATE, *, n_steps: int = LONG, **how: Any) -> Results:
    """Train Q-learning on long messages at τ = 0.1; a point of the curve is the mean of 30 episodes."""
    curve: dict[str, Any] = {"evaluate_every": min(n_steps, N_STEPS // 2), "evaluation_episodes": 30}
    parameters = {"tau": NOISY, "max_msg_length": length}
    return learn(n_steps=n_steps, learning_rate=learning_rate, parameters=parameters, **curve, **how)


def median_late(results: Results) -> Reals:
    """Return the median evaluation of each run of Q-learning in the second half of training."""
    curves = results.curves("Q-learning").to_numpy(float)
    median: Reals = np.median(curves[len(curves) // 2 :], axis=0)
    return median


def walk(environment: Any, actions: Sequence[int], *, episodes: int = 100, seed: int = 0) -> float:
    """Return the mean return of a player that takes the same actions in every episode, until they or it end."""
    total = 0.0
    for episode in range(episodes):
        environment.reset(seed=seed if episode == 0 else None)
        for action in actions:
            _, reward, terminated, truncated, _ = environment.step(action)
            total += float(reward)
            if terminated or truncated:
                break
    return total / episodes
