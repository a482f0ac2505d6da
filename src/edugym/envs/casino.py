"""Casino: maximisation bias (lesson 17)."""

from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.checks.parameters import between, whole_number
from edugym.mdp.protocol import Random, Reals
from edugym.rendering.icons import smiley
from edugym.rendering.palette import BRICK, GRASS, INK, PAPER, PURPLE, RED, ROAD, SHADE, SKY, WALL, WHITE, YELLOW
from edugym.rendering.scene import Circle, Polygon, Rectangle, Scene, Shape, Text

STREET, CASINO, HOME = 0, 1, 2
IN = 0
"""The action that goes in; in the street every other one goes home."""
MOST_MACHINES = 1_000
LARGEST_PAYOFF = 1_000_000
IN_A_ROW, MOST_ROWS = 5, 4
"""So many machines the picture shows."""


class Casino(NamedTuple):
    """Go home, or into a casino whose machines all lose: the best estimate among many promises a gain.

    ## Description
    Challenge: maximisation bias. In the street the agent goes home, which pays nothing, or into a casino. There it
    plays one of k machines, and goes home. All machines are equally bad: each loses 0.1 on average, so it is best not
    to go in. But payoffs are noisy. After a few tries some machine looks better than it is, and the maximum over all
    estimates, from which Q-learning learns what the casino is worth, picks just this one. So the casino seems to pay,
    and the agent goes in. The strength is `n_machines`: the more there are, the more the best looking one promises.

    ## Observation space
    `Discrete(3)`: 0 street, 1 casino, 2 home.

    ## Action space
    `Discrete(max(2, n_machines))`. In the street 0 goes in, and every other action goes home. In the casino action a
    plays machine a.

    ## State
    The observed number.

    ## Dynamics
    In the street action 0 leads into the casino, and every other action home. In the casino every action leads home.

    ## Reward
    0 in the street. In the casino machine a pays m_a + `noise` or m_a - `noise`, each with probability 1/2, drawn anew
    every time. The mean m_a is -`loss`; that of the last machine, number k - 1, is `advantage` - `loss`. (With one
    machine there is an action 1 too, which plays none: it costs `loss` + `noise` + 1.) So the best expected return is
    the larger of 0 and `advantage` - `loss` (with the discount γ, of 0 and γ times that). At the defaults the payoffs
    are 0.9 and -1.1, and the best expected return is 0: go home.

    ## Initial state
    In the street.

    ## Episode end
    Terminated at home, after one step or two; never truncated.

    ## Parameters
    - `n_machines` (10): k, how many machines there are, from 1 to 1000.
    - `noise` (1.0): how far a payoff is from its mean, which is also its standard deviation, from 0 to one million.
    - `loss` (0.1): what a machine loses on average, from 0 to one million.
    - `advantage` (0.0): how much more than the others the last machine pays on average, from 0 to one million. If it is
      above `loss`, it is best to go in, and to play the last machine.

    ## Info
    - `machine`: the machine that was played in the last step; -1 if none was.

    ## Choices
    - In Sutton and Barto's example 6.7 payoffs are normal, with mean -0.1 and standard deviation 1. Here they have the
      same mean and the same standard deviation, but only two values. So the mean of n tries has n + 1 values, and what
      the largest of k such means is on average is a finite sum: `edugym.expected_maximum` computes it exactly.
    - There the agent has two actions in the first state ("left" is the casino) and "many" in the second. Here both
      states have the same number of actions, as a Gymnasium environment has. So an agent that acts at random goes in
      once in k episodes, and not every second time.
    - `advantage` is not in the book: where actions really differ, the remedies against the bias have a price.

    ## Algorithms
    The book compares Q-learning with double Q-learning (`edugym.DoubleQLearning`; van Hasselt, 2010). Expected SARSA
    (`edugym.ExpectedSARSA`) learns from a mean that is mostly the maximum. Maxmin Q-learning
    (`edugym.MaxminQLearning`; Lan et al., 2020) takes the maximum over the smallest of several estimates.

    ## References
    Sutton and Barto, 2nd edition, section 6.7: example 6.7 and figure 6.5. It is not one of the nine environments of
    Moerland et al. (2023), EduGym.
    """

    n_machines: int
    payoffs: Reals  # shape (n_actions, 2): the two payoffs of each action in the casino, which are equally likely

    def initial(self, rng: Random) -> int:
        """In the street."""
        return STREET

    def transition(self, state: int, action: int, rng: Random) -> int:
        """In, or home."""
        return CASINO if state == STREET and action == IN else HOME

    def reward(self, state: int, action: int, next_state: int, rng: Random) -> float:
        """The payoff of a machine; nothing in the street."""
        return 0.0 if state == STREET else float(self.payoffs[action, int(rng.random() * 2)])

    def terminal(self, state: int) -> bool:
        """Whether the agent is at home."""
        return state == HOME

    def observation(self, state: int, rng: Random) -> int:
        """The state."""
        return state

    @property
    def observation_space(self) -> spaces.Discrete:
        """Street, casino, home."""
        return spaces.Discrete(3)

    @property
    def action_space(self) -> spaces.Discrete:
        """The machines; in the street 0 goes in."""
        return spaces.Discrete(max(2, self.n_machines))

    @classmethod
    def create(
        cls,
        n_machines: int = 10,
        noise: float = 1.0,
        loss: float = 0.1,
        advantage: float = 0.0,
    ) -> "Casino":
        """Check the parameters (see the class) and make the task.

        Raises:
            ValueError: a parameter is not as the class says.
        """
        n_machines = whole_number("n_machines", n_machines, 1, MOST_MACHINES)
        between("noise", noise, 0, LARGEST_PAYOFF)
        between("loss", loss, 0, LARGEST_PAYOFF)
        between("advantage", advantage, 0, LARGEST_PAYOFF)
        means = np.full(max(2, n_machines), -float(loss))
        means[n_machines - 1] += advantage
        payoffs = np.stack([means + noise, means - noise], axis=1)
        payoffs[n_machines:] = -(loss + noise + 1.0)
        return cls(n_machines, payoffs)

    @property
    def reward_threshold(self) -> float:
        """The best expected return: that of going home, or of the last machine."""
        return max(0.0, float(self.payoffs[self.n_machines - 1].mean()))

    @property
    def action_names(self) -> tuple[str, ...]:
        """What they do in the casino, or in the street."""
        return ("machine 0, or in", *(f"machine {k}, or home" for k in range(1, len(self.payoffs))))

    def info(self, state: int, last_state: int | None, last_action: int | None) -> dict[str, Any]:
        """The machine that was just played."""
        return {"machine": self._machine_played(last_state, last_action)}

    def _machine_played(self, last_state: int | None, last_action: int | None) -> int:
        """Its number, or -1."""
        if last_state is None or last_action is None or int(last_state) != CASINO:
            return -1
        return int(last_action) if last_action < self.n_machines else -1

    def scene(self, state: int, last_state: int | None = None, last_action: int | None = None) -> Scene:
        """A street between a house and a casino; the machine that was played last is lit."""
        state = int(state)
        shown = min(self.n_machines, IN_A_ROW * MOST_ROWS)
        rows, columns = -(-shown // IN_A_ROW), max(min(shown, IN_A_ROW), 4)
        left, width = 5.4, columns + 7.0
        height = 3.8 + 1.6 * rows
        ground = height - 0.6
        played = self._machine_played(last_state, last_action)
        shapes: list[Shape] = [
            Rectangle(0.0, ground, width, 0.6, fill=GRASS, glyph="░"),
            Rectangle(3.4, ground, 1.6, 0.6, fill=ROAD, outline=None, glyph="▒"),
            *_house(0.4, ground),
            Rectangle(left, 0.9, columns + 1.2, ground - 0.9, fill=PURPLE, glyph=" "),
            Rectangle(left + 0.2, 1.3, columns + 0.8, ground - 1.3, fill=PAPER, glyph=" "),
            Rectangle(left + columns / 2 - 1.2, 0.3, 3.6, 0.9, 0.2, fill=YELLOW, glyph=" "),
            Text(left + columns / 2 + 0.6, 0.75, "CASINO", size=0.55),
        ]
        for k in range(shown):
            shapes += _machine(left + 0.7 + k % IN_A_ROW, 1.6 + 1.6 * (k // IN_A_ROW), k, lit=k == played)
        if shown < self.n_machines:
            shapes.append(Text(left + columns + 0.3, ground - 0.5, f"... {self.n_machines}", size=0.36, anchor="end"))
        face = {STREET: 4.2, CASINO: left + 0.9, HOME: 1.7}[state]
        shapes += smiley(face, ground - 0.42, 0.36, "flat" if state == CASINO else "happy")
        where = {STREET: "in the street", CASINO: "in the casino", HOME: "at home"}[state]
        return Scene(width, height, shapes, SKY, f"Casino: {where}", columns=3 * int(width))


def _house(x: float, ground: float) -> list[Shape]:
    """A house whose left wall stands at x."""
    return [
        Rectangle(x, ground - 2.0, 2.6, 2.0, fill=BRICK, glyph=" "),
        Polygon(((x - 0.2, ground - 2.0), (x + 1.3, ground - 3.2), (x + 2.8, ground - 2.0)), fill=RED),
        Rectangle(x + 0.8, ground - 1.3, 1.0, 1.3, fill=WALL, glyph=" "),
        Text(x + 1.3, ground - 1.65, "home", size=0.4, colour=WHITE),
    ]


def _machine(x: float, y: float, k: int, lit: bool) -> list[Shape]:
    """A machine with its number, and a lamp; it lights up after it was played."""
    return [
        Rectangle(x - 0.36, y, 0.72, 1.2, 0.08, fill=YELLOW if lit else SHADE, glyph=" "),
        Rectangle(x - 0.26, y + 0.3, 0.52, 0.36, fill=WHITE, glyph=" "),
        Text(x, y + 0.49, str(k), size=0.28),
        Circle(x, y + 0.15, 0.08, fill=RED if lit else INK, glyph="★" if lit else "·"),
        Rectangle(x - 0.2, y + 0.85, 0.4, 0.1, fill=INK, glyph="="),
    ]
