"""The players of lesson 7: REINFORCE on a table with actions in bins, and an actor-critic with a Gaussian policy."""

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

import gymnasium
import numpy as np

from edugym.agents.gaussian_actor_critic import GaussianActorCritic
from edugym.agents.reinforce import REINFORCE
from edugym.agents.tile_coding import TileCoding
from edugym.envs.trashbot.task import Trashbot
from edugym.experiments.repeat import repeat
from edugym.experiments.results.tables import Results, joined
from edugym.mdp.discretised import DiscreteActions, Discretised
from edugym_course.lessons.continuous_actions.ppo import CONTINUOUS

BINS = (3, 5, 9)
N_STEPS = 100_000
WIDTH = 0.45
"""The default width of the container."""
CELLS = 30
"""Into how many cells of a table each coordinate of the wrist is cut."""
LEARNING_RATE = 0.4
"""Both learning rates of REINFORCE."""
DISCOUNT = 0.99
TILES = 20
ACTOR_RATE, CRITIC_RATE = 0.02, 0.4
"""The learning rates of the Gaussian actor-critic."""
SPREAD = 0.5
"""σ of its policy."""
OPTIMISM = 1.0
"""What its critic expects of every state at first."""


def name(n_bins: int) -> str:
    """Return the label of a number of bins."""
    return f"{n_bins} bins"


def in_a_table(n_bins: int, cells: int = CELLS, width: float = WIDTH) -> Any:
    """Return Trashbot for a table: actions in bins, and the wrist in cells.

    Args:
        n_bins: how many values each joint has.
        cells: into how many cells each coordinate of the wrist is cut.
        width: of the container.
    """
    task = DiscreteActions.create(Trashbot.create(container_width=width), n_bins)
    return Discretised.create(task, [1, 1, cells, cells, 1, 1, 3])


def tiles_on_the_wrist(task: Any, tiles: int = TILES) -> TileCoding:
    """Return tile coding of what matters: the two coordinates of the wrist, and whether the box is held."""
    return TileCoding.create(task, tiles=[1, 1, tiles, tiles, 1, 1, 2], tilings=8)


def gaussian(
    task: Any,
    spread: float = SPREAD,
    actor_rate: float = ACTOR_RATE,
    critic_rate: float = CRITIC_RATE,
    discount: float = DISCOUNT,
    tiles: int = TILES,
) -> GaussianActorCritic:
    """Return a Gaussian actor-critic for Trashbot with continuous actions.

    Args:
        task: the MDP, or anything with its two spaces.
        spread: σ.
        actor_rate: α^θ.
        critic_rate: α^w.
        discount: γ.
        tiles: into how many tiles each coordinate of the wrist is divided.
    """
    return GaussianActorCritic.create(
        task,
        features=tiles_on_the_wrist(task, tiles),
        spread=spread,
        learning_rate=actor_rate,
        value_learning_rate=critic_rate,
        discount=discount,
        initial_value=OPTIMISM,
    )


def learn_bins(
    n_bins: int,
    *,
    n_steps: int = N_STEPS,
    cells: int = CELLS,
    width: float = WIDTH,
    learning_rate: float = LEARNING_RATE,
    baseline: bool = True,
    discount: float = DISCOUNT,
    **how: Any,
) -> Results:
    """Train REINFORCE on a table, with actions in bins.

    Args:
        n_bins: how many values each joint has.
        n_steps: the training steps of each run.
        cells: into how many cells each coordinate of the wrist is cut.
        width: of the container.
        learning_rate: α^θ, and α^w too.
        baseline: whether a baseline is learned.
        discount: γ.
        **how: more arguments of `edugym.experiments.repeat`, such as `repetitions`, `seed` and `jobs`.
    """
    rates = {"learning_rate": learning_rate, "value_learning_rate": learning_rate if baseline else 0.0}
    make = partial(REINFORCE.create, longest=200, discount=discount, **rates)
    return _learn(in_a_table(n_bins, cells, width), {name(n_bins): make}, n_steps, how)


def learn_continuous(*, n_steps: int = N_STEPS, width: float = WIDTH, **how: Any) -> Results:
    """Train the Gaussian actor-critic.

    Args:
        n_steps: the training steps of each run.
        width: of the container.
        **how: settings of `gaussian`, and more arguments of `edugym.experiments.repeat`.
    """
    own = {key: how.pop(key) for key in ("spread", "actor_rate", "critic_rate", "discount", "tiles") if key in how}
    return _learn(Trashbot.create(container_width=width), {CONTINUOUS: partial(gaussian, **own)}, n_steps, how)


def _learn(task: Any, makers: Mapping[str, Any], n_steps: int, how: Mapping[str, Any]) -> Results:
    """Train; each point of a curve is one greedy episode, since nothing in it is random but ties."""
    return repeat(task, makers, n_steps, **{"evaluate_every": max(n_steps // 25, 1), **how})


def learn_all(bins: Sequence[int] = BINS, **how: Any) -> Results:
    """Train REINFORCE with several numbers of bins, and the Gaussian actor-critic.

    Args:
        bins: the numbers of bins.
        **how: arguments that both `learn_bins` and `learn_continuous` have, and those of `edugym.experiments.repeat`.
    """
    return joined([*(learn_bins(n, **how) for n in bins), learn_continuous(**how)])


def steps_to(results: Results, label: str, goal: float, column: str = "return") -> Any:
    """Return the training steps after which the return is first at a goal or above it, shape (n_repetitions,).

    A run that never gets there counts with all its steps.
    """
    curves = results.curves(label, column)
    reached = curves.to_numpy(float) >= goal
    steps = curves.index.to_numpy(float)
    return np.where(reached.any(axis=0), steps[reached.argmax(axis=0)], steps[-1])


class Drawing:
    """A policy of PPO that draws its actions, as in training.

    Args:
        agent: the networks that `PPO.train` returns.
        seed: of the actions.
    """

    def __init__(self, agent: Any, seed: int = 0) -> None:
        """See the class."""
        import torch

        self.agent, self.generator = agent, torch.Generator().manual_seed(seed)

    def __call__(self, seen: Any) -> Any:
        """Return an action, shape (2,), for an observation."""
        import torch

        with torch.no_grad():
            policy = self.agent.policy(self.agent.actor(self.agent.inputs_of(np.asarray(seen)[None])))
            actions = torch.normal(policy.mean, policy.log_std.exp(), generator=self.generator)
            return self.agent.for_environment(actions)[0]


def frozen_lake(n_steps: int = 20_000, *, learning_rate: float = 0.2, **how: Any) -> Results:
    """Train REINFORCE, with and without a baseline, on a frozen lake that is not slippery.

    Args:
        n_steps: the training steps of each run.
        learning_rate: α^θ, and α^w where there is a baseline.
        **how: more arguments of `edugym.experiments.repeat`, such as `repetitions` and `seed`.
    """
    lake = gymnasium.make("FrozenLake-v1", is_slippery=False)
    settings: dict[str, Any] = {"learning_rate": learning_rate, "discount": 0.95, "longest": 200}
    makers = {
        "with a baseline": partial(REINFORCE.create, value_learning_rate=learning_rate, **settings),
        "without": partial(REINFORCE.create, value_learning_rate=0.0, **settings),
    }
    return repeat(lake, makers, n_steps, **{"evaluate_every": max(n_steps // 20, 1), **how})
