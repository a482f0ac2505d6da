"""Bandit: exploration, the beginning (lesson 0b)."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.checks.parameters import between, number_of_steps, whole_number
from edugym.mdp.protocol import Random
from edugym.rendering.icons import smiley
from edugym.rendering.palette import BLUE, INK, PAPER, RED, SHADE, SKY, STONE, WHITE
from edugym.rendering.scene import Circle, Line, Rectangle, Scene, Shape, Text

MOST_ARMS = 1_000
IN_A_ROW, MOST_SHOWN = 5, 40
"""So many machines stand beside each other in the picture, and at most so many in all."""


class Bandit(NamedTuple):
    """Choose among slot machines. Each pays with a probability that nobody tells you.

    ## Description
    Challenge: exploration, in its simplest form. There are n slot machines, called arms. A pull of an arm pays 1 or
    nothing. One arm, the best, pays with probability (1 + Δ)/2, and every other with (1 - Δ)/2, where the gap Δ is the
    strength. There is one state, and an action changes nothing of what comes. So all that an agent needs is the mean
    reward of each arm; but it learns about an arm only by pulling it, and every pull of a worse arm costs Δ on average.
    This cost, added up, is the *regret*. The smaller the gap, the more pulls it takes to tell two arms apart, about
    1/Δ², and the less each of them costs. With `drift` another arm becomes the best one now and then, and what was
    learned becomes old.

    ## Observation space
    `Discrete(1)`: always 0. There is nothing to see.

    ## Action space
    `Discrete(n_arms)`: the arm to pull.

    ## State
    The number of the best arm, from 0 to n - 1. It is not observed. With `drift` = 0 it never changes, so this is an
    MDP with a single state. With `drift` the observation is not Markov. The number of pulls so far, on which the step
    limit depends, is not observed either. (That does no harm to an agent that bootstraps at truncation.)

    ## Dynamics
    Whatever the action: with probability `drift` another arm becomes the best one, drawn uniformly from the n - 1
    others; else the best arm stays the best.

    ## Reward
    1 or 0. It is 1 with probability (1 + Δ)/2 if the arm was the best one before this step, and with (1 - Δ)/2 if not.
    The best expected return of an episode of T pulls is T (1 + Δ)/2: 600 at the defaults (discount 1). Drawing arms
    uniformly returns T (1/2 - Δ/2 + Δ/n): 420 at the defaults.

    ## Initial state
    The best arm is the same at the start of every episode; `layout_seed` says which.

    ## Episode end
    Never terminated; truncated after `max_steps` steps.

    ## Parameters
    - `n_arms` (10): n, how many arms there are, from 2 to 1000.
    - `gap` (0.2): Δ, by how much the best arm pays more often than the others, from 0 to 1. At 0 all arms are the same;
      at 1 the best arm always pays, and the others never do.
    - `drift` (0.0): the probability, at each step, that another arm becomes the best one; from 0 to 1.
    - `max_steps` (1000): the number of steps after which an episode is truncated, from 1 to 2^62.
    - `layout_seed` (0): the seed from which the best arm of the start is drawn, uniformly; 0 or more. That arm is
      `numpy.random.default_rng(layout_seed).integers(n_arms)`.

    ## Info
    - `best_arm`: the arm that is the best one now.
    - `regret`: what the last pull cost on average: Δ if it pulled another arm than the best one, else 0 (also at the
      start).

    ## Choices
    - In the testbed of Sutton and Barto (section 2.3), the mean rewards of ten arms are drawn from a normal
      distribution, and so is the noise. Here rewards are 1 or 0, as those of a slot machine, and all arms but the best
      are alike, so that the gap is the only thing that makes a task harder or easier.
    - Their non-stationary bandit (exercise 2.5) lets all means walk at random. Here the best arm changes its place, so
      that the exact model stays finite.
    - An episode is a whole run of pulls. An agent need not look ahead: learn with discount 0 (or with an agent for
      bandits, such as `edugym.SampleAverage`). With a higher discount all action values get the same amount more,
      which changes nothing of their order in the end.

    ## Algorithms
    `edugym.SampleAverage` is the simple bandit algorithm of Sutton and Barto (section 2.4), ε-greedy with sample
    averages. For arms that drift they have a constant learning rate: `edugym.QLearning` with discount 0. Then there are
    upper confidence bounds, `edugym.UCB`; Thompson sampling, `edugym.ThompsonSampling`; and the gradient bandit,
    `edugym.GradientBandit`. `edugym.regret` works out the regret of given pulls exactly, and `edugym.lai_robbins` how
    slowly it can grow at best.

    ## References
    Robbins (1952), Some aspects of the sequential design of experiments; Lai and Robbins (1985), Asymptotically
    efficient adaptive allocation rules; Sutton and Barto, Reinforcement Learning, 2nd edition, chapter 2. It is not one
    of the nine environments of Moerland et al. (2023), EduGym.
    """

    n_arms: int
    gap: float
    drift: float
    first_best: int  # the best arm at the start of an episode
    max_steps: int

    def initial(self, rng: Random) -> int:
        """The best arm of the layout."""
        return self.first_best

    def transition(self, state: int, action: int, rng: Random) -> int:
        """Whatever is pulled: with probability `drift` one of the other arms becomes the best."""
        if rng.random() < self.drift:
            return (state + 1 + int(rng.random() * (self.n_arms - 1))) % self.n_arms
        return state

    def payoff(self, state: int, action: int) -> float:
        """The probability with which an arm pays: (1 + Δ)/2 for the best, (1 - Δ)/2 for the others."""
        return (1.0 + self.gap) / 2.0 if action == state else (1.0 - self.gap) / 2.0

    def reward(self, state: int, action: int, next_state: int, rng: Random) -> float:
        """1 if the arm pays, else 0."""
        return 1.0 if rng.random() < self.payoff(state, action) else 0.0

    def terminal(self, state: int) -> bool:
        """Never."""
        return False

    def observation(self, state: int, rng: Random) -> int:
        """Nothing: always 0."""
        return 0

    @property
    def observation_space(self) -> spaces.Discrete:
        """A single observation."""
        return spaces.Discrete(1)

    @property
    def action_space(self) -> spaces.Discrete:
        """The arm to pull."""
        return spaces.Discrete(self.n_arms)

    @classmethod
    def create(
        cls, n_arms: int = 10, gap: float = 0.2, drift: float = 0.0, max_steps: int = 1000, layout_seed: int = 0
    ) -> "Bandit":
        """Check the parameters (see the class) and make the task.

        Raises:
            ValueError: a parameter is not as the class says.
        """
        n_arms = whole_number("n_arms", n_arms, 2, MOST_ARMS)
        gap, drift = float(between("gap", gap, 0, 1)), float(between("drift", drift, 0, 1))
        max_steps = number_of_steps("max_steps", max_steps)
        first_best = np.random.default_rng(whole_number("layout_seed", layout_seed, 0)).integers(n_arms)
        return cls(n_arms, gap, drift, int(first_best), max_steps)

    @property
    def reward_threshold(self) -> float | None:
        """The best expected return; None where the best arm changes, unseen."""
        return self.max_steps * (1.0 + self.gap) / 2.0 if self.drift == 0.0 or self.gap == 0.0 else None

    @property
    def action_names(self) -> tuple[str, ...]:
        """The arms by number."""
        return tuple(f"arm {arm}" for arm in range(self.n_arms))

    def info(self, state: int, last_state: int | None, last_action: int | None) -> dict[str, Any]:
        """The best arm, and what the last pull cost on average."""
        missed = last_action is not None and last_state is not None and int(last_action) != int(last_state)
        return {"best_arm": int(state), "regret": self.gap if missed else 0.0}

    def scene(self, state: int, last_action: int | None = None, actions: Sequence[int] = ()) -> Scene:
        """Rows of slot machines, each with the number of its pulls in this episode; the face is at the last one.

        Nothing shows which arm is the best, since a player must find out.
        """
        n = min(self.n_arms, MOST_SHOWN)
        rows, columns = -(-n // IN_A_ROW), min(n, IN_A_ROW)
        width = max(1.5 * columns, 6.0) + 1.0
        left = (width - 1.5 * columns) / 2
        pulls = np.bincount(np.array(actions, np.int64), minlength=n)
        shapes: list[Shape] = [Text(width / 2, 0.5, f"{len(actions)} pull{'' if len(actions) == 1 else 's'}", size=0.5)]
        for arm in range(n):
            x, y = left + 1.5 * (arm % IN_A_ROW), 1.2 + 3.6 * (arm // IN_A_ROW)
            shapes += _machine(x, y, arm, int(pulls[arm]), down=arm == last_action)
        if last_action is None:
            shapes += smiley(width / 2, 0.85 + 3.6 * rows, 0.36)
        elif last_action < n:
            row, column = divmod(int(last_action), IN_A_ROW)
            shapes += smiley(left + 1.5 * column + 0.55, 4.45 + 3.6 * row, 0.36)
        return Scene(width, 1.4 + 3.6 * rows, shapes, SKY, f"Bandit: {len(actions)} pulls", columns=3 * int(width))


def _machine(x: float, y: float, arm: int, pulls: int, down: bool) -> list[Shape]:
    """A slot machine with its number, how often it was pulled, and its lever, which is down after a pull."""
    end = y + (1.9 if down else 0.5)
    return [
        Line(((x + 1.05, y + 1.2), (x + 1.28, y + 1.2), (x + 1.28, end)), line_width=0.08),
        Circle(x + 1.28, end, 0.14, fill=RED, glyph="●" if down else "○"),
        Rectangle(x + 0.05, y, 1.0, 2.5, 0.15, fill=BLUE if down else STONE),
        Text(x + 0.55, y + 0.42, str(arm), size=0.42, colour=WHITE if down else INK),
        Rectangle(x + 0.13, y + 0.85, 0.84, 0.7, 0.06, fill=PAPER if pulls else SHADE),
        Text(x + 0.55, y + 1.2, str(pulls), size=min(0.42, 1.3 / len(str(pulls)))),
        Rectangle(x + 0.25, y + 1.95, 0.6, 0.22, 0.06, fill=INK),
    ]
