"""What networks remember in the corridor: DQN on a window of separate frames."""

from collections.abc import Mapping
from functools import partial
from types import MappingProxyType
from typing import Any

from edugym.agents.dqn import DQN
from edugym.agents.strategies import LinearDecay, ScheduledEpsilonGreedy
from edugym.envs.memory_corridor import MemoryCorridor
from edugym.experiments.repeat import repeat
from edugym.experiments.results.claims import Above, Claim, Within
from edugym.experiments.results.statistics import paired_difference
from edugym.experiments.results.tables import Results
from edugym.mdp.separate_frames import SeparateFrames

NETWORK_STEPS = 100_000
DISCOUNT = 0.8
LEARNING_RATE = 0.001
LAST_EPSILON = 0.02
WINDOWS: Mapping[str, tuple[int, bool]] = MappingProxyType(
    {"4 observations": (4, False), "7 observations": (7, False), "7 observations and actions": (7, True)}
)
"""The windows: by label, the number of observations, and whether the actions between them are shown."""


def learn_with_network(
    window: str,
    *,
    n_steps: int = NETWORK_STEPS,
    learning_rate: float = LEARNING_RATE,
    discount: float = DISCOUNT,
    **how: Any,
) -> Results:
    """Train DQN on a window; ε falls evenly from 1 to 0.02 in the first fifth of training.

    Args:
        window: a label of `WINDOWS`.
        n_steps: the training steps of each run.
        learning_rate: that of Adam.
        discount: γ.
        **how: more arguments of `edugym.experiments.repeat`, such as `repetitions`, `seed` and `jobs`.
    """
    exploration = ScheduledEpsilonGreedy.create(LinearDecay(1.0, LAST_EPSILON, max(n_steps // 5, 1)))
    make = partial(DQN.create, learning_rate=learning_rate, discount=discount, exploration=exploration)
    k, actions = WINDOWS[window]
    task = SeparateFrames.create(MemoryCorridor.create(), k, actions=actions)
    every = max(n_steps // 20, 1)
    return repeat(task, {window: make}, n_steps, evaluate_every=every, evaluation_episodes=40, **how)


def network_claims(networks: Results) -> list[Claim]:
    """Return the claims on DQN."""
    few, many, acting = WINDOWS
    return [
        Claim(
            "A network on a window of 4 frames gets as far as a table: through corridor 3, and a guess",
            "greedy return of DQN",
            networks.mean(few),
            Within(6.3, 7.5),
        ),
        Claim(
            "A window of 7 frames, whose table would have 16 384 rows, is enough for corridor 4",
            "greedy return of DQN",
            networks.mean(many),
            Within(10.0, 11.5),
            remark="7 = 4 (4 - 1) / 2 + 1; the network learns it within 100 000 steps",
        ),
        Claim(
            "With the actions in the same window the network gets through corridor 5 and further",
            "greedy return of DQN",
            networks.mean(acting),
            Above(15.0),
            remark="7 = 2 * 5 - 3 is enough for corridor 5; a table would have 12 million rows",
        ),
        Claim(
            "Seven frames are worth more than four",
            "greedy return of DQN, 7 frames less 4",
            paired_difference(networks.final(many), networks.final(few)),
            Above(2.0),
        ),
    ]
