"""Tamagotchi: the amount of signal (lesson 6)."""

import math
import textwrap
from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.checks.parameters import at_least, number_of_steps, whole_number
from edugym.mdp.protocol import Random
from edugym.rendering.icons import Mood, gauge, smiley, speech_bubble
from edugym.rendering.palette import BLUE, GREEN, INK, ORANGE, PAPER, PURPLE, RED, SKY, WHITE, blend
from edugym.rendering.scene import Circle, Polygon, Rectangle, Scene, Shape, Text

NEEDS = ("play", "sleep", "feed", "clean")
TIE_BREAK = 1e-6
"""What is added to the urgency of the wanted action, so that it wins ties in the message."""
URGENCIES = np.array([math.exp(-variable / 100) for variable in range(101)])
"""The urgency of each value of a variable: looking it up is quicker than computing it."""

Variables = tuple[int, int, int, int]


class Toy(NamedTuple):
    """The state: hidden variables, hit points, the wanted action (hidden) and the message.

    Attributes:
        variables: v, how well each of its four needs (play, sleep, food, cleanness) is satisfied, from 0 to 100.
        hp: its hit points, from 0 to 100.
        wanted: the action that it wants next; action i satisfies need i.
        message: its words as the digits of one number in base `vocab_size`; the first word is the leading digit.
    """

    variables: Variables
    hp: int
    wanted: int
    message: int


class Tamagotchi(NamedTuple):
    """Keep a toy happy. What it needs shows only in its messages, which may be noisy.

    ## Description
    Challenge: the amount of state signal (and language). A toy needs to play, to sleep, to be fed and to be cleaned;
    for each it has a hidden variable that falls until it is cared for. At every step it wants one of the four, and an
    action that it does not want harms it. The agent sees only its hit points and what it says. `tau` is the noise of
    what it says: doing what it says returns 6 707 at 0, 5 993 at 0.02, 3 317 at 0.05, 120 at 0.1 and -676 at infinity,
    where it tells nothing and acting at random does as well. (An agent that remembers its last action needs no message:
    taking the four in turn returns 6 652.)

    ## Observation space
    `MultiDiscrete([101, H, ..., H])`: the hit points, then the `max_msg_length` words of the message, each one of 0,
    ..., H - 1, with H = `vocab_size`.

    ## Action space
    `Discrete(4)`: 0 play, 1 sleep, 2 feed, 3 clean.

    ## State
    The four variables v, whole numbers from 0 to 100; the hit points, a whole number from 0 to 100; the action that the
    toy wants; the message; and the number of steps of this episode. The agent sees the hit points and the message only,
    so the observation is not Markov. At `tau` = 0 and with `vocab_size` >= 4, the message still names the best action.

    ## Dynamics
    1. The action's own variable grows by 30, the others fall by 5. If the action is not the wanted one, all four fall
       by another 10. Then they are clipped to 0, ..., 100.
    2. The urgency of need i is u_i = exp(-v_i/100); the happiness is Σ (v_i - 50) u_i.
    3. The hit points change by a tenth of the happiness, are rounded down and clipped to 0, ..., 100.
    4. The toy wants what is most urgent; among equals it chooses at random.
    5. It says `max_msg_length` words, each drawn independently: about need i with probability softmax(u/tau)_i, where
       10^-6 is added to the urgency of the wanted action; at `tau` = 0 always about the wanted action. With H >= 4,
       need i is said with any of the words i, i + 4, i + 8, ..., uniformly (synonyms); with H < 4, with the word i mod
       H, so that a word can mean several needs.

    ## Reward
    The happiness after the action: from -174.6 to 70.6. At the defaults doing what the toy says returns 6 707
    (discount 1); exact planning with the whole state finds nothing better.

    ## Initial state
    All variables and the hit points at 100; what the toy wants first is drawn uniformly.

    ## Episode end
    Terminated when no hit points are left; else truncated after `steps_per_episode` steps.

    ## Parameters
    - `tau` (0.0): the temperature, which is the noise of the message; 0 or more, may be infinite.
    - `max_msg_length` (1): how many words a message has, from 1 to 56. There are at most 2^56 different messages,
      `vocab_size` ** `max_msg_length` (so at most 28 words if `vocab_size` is 4).
    - `vocab_size` (4): H, how many words there are; from 1 to 2^31.
    - `steps_per_episode` (100): from 1 to 2^62.

    ## Info
    - `variables`: how well the toy is off for each of the four needs.
    - `wanted`: the action that it wants.

    ## Choices
    - The paper gives 100 values to the hit points, and lets them start at 100; here they are 0, ..., 100.
    - The paper does not say how the hit points follow from the variables, how urgency and happiness are computed, nor
      what the words mean. Everything under Dynamics that it does not say is our choice. So is the tie-break in the
      message, in favour of the wanted action.
    - A message always has `max_msg_length` words. At `tau` = 0 it names the wanted action only (if `vocab_size` >= 4);
      the paper calls it a perfect description of the four variables.
    - That all variables start at 100 is our choice. The paper gives the happiness a maximum of 75; it is 73.6.
    - The end at 0 hit points carries no penalty of its own. For a good player an early death loses rewards; for a bad
      one it ends negative rewards.
    - In the paper an episode terminates after 100 steps. Here it is truncated then, since the agent does not see the
      number of the step, and the toy lives on. So Q-learning bootstraps from the last observation too.

    ## Algorithms
    The paper runs Q-learning with a table, with more and less noise.

    ## References
    Moerland et al. (2023), EduGym, section 4 f and appendix A.6.
    """

    tau: float
    max_msg_length: int
    vocab_size: int
    steps_per_episode: int

    def initial(self, rng: Random) -> Toy:
        """All variables and the hit points are 100; the want and the message are drawn."""
        return self.settled((100, 100, 100, 100), 100, rng)

    def transition(self, state: Toy, action: int, rng: Random) -> Toy:
        """The variables change, and with them the hit points, by a tenth of the happiness, rounded down."""
        variables = (
            self.changed(state, 0, action),
            self.changed(state, 1, action),
            self.changed(state, 2, action),
            self.changed(state, 3, action),
        )
        hp = math.floor(state.hp + happiness(variables) / 10)
        return self.settled(variables, min(max(hp, 0), 100), rng)

    def changed(self, state: Toy, need: int, action: int) -> int:
        """A variable after an action: 30 more for its own, else 5 less; 10 less if it was not the wanted one."""
        change = 30 if action == need else -5
        if action != state.wanted:
            change -= 10
        return min(max(state.variables[need] + change, 0), 100)

    def settled(self, variables: Variables, hp: int, rng: Random) -> Toy:
        """The toy wants what is most urgent (among equals, one at random), and its message is drawn."""
        wanted = 0
        ties = 1
        for need in range(1, 4):
            if variables[need] < variables[wanted]:
                wanted = need
                ties = 1
            elif variables[need] == variables[wanted]:
                ties += 1
                if rng.random() * ties < 1.0:  # the k-th of the equals replaces the one before with probability 1/k
                    wanted = need
        message = 0
        for _ in range(self.max_msg_length):
            message = message * self.vocab_size + self.word(self.named(variables, wanted, rng), rng)
        return Toy(variables, hp, wanted, message)

    def named(self, variables: Variables, wanted: int, rng: Random) -> int:
        """The need that a word is about: need i with probability softmax(u / τ)."""
        total = 0.0
        for need in range(4):
            total += self.weight(variables, need, wanted)
        draw = rng.random() * total
        for need in range(3):
            draw = draw - self.weight(variables, need, wanted)
            if draw < 0.0:
                return need
        return 3

    def weight(self, variables: Variables, need: int, wanted: int) -> float:
        """exp(u_i / τ) of a need divided by that of the wanted one (with the tie-break): at most 1."""
        if need == wanted:
            return 1.0
        if self.tau == 0.0:
            return 0.0
        return math.exp((urgency(variables[need]) - urgency(variables[wanted]) - TIE_BREAK) / self.tau)

    def word(self, need: int, rng: Random) -> int:
        """A word for need i: one of i, i + 4, i + 8, ... (synonyms); if H < 4, the word i mod H (ambiguous)."""
        if self.vocab_size < 4:
            return need % self.vocab_size
        synonyms = (self.vocab_size - need + 3) // 4
        return need + 4 * int(rng.random() * synonyms)

    def reward(self, state: Toy, action: int, next_state: Toy, rng: Random) -> float:
        """The happiness after the action; low variables weigh most."""
        return happiness(next_state.variables)

    def terminal(self, state: Toy) -> bool:
        """No hit points are left."""
        return state.hp == 0

    def observation(self, state: Toy, rng: Random) -> Any:
        """The hit points, then the words."""
        seen = np.empty(self.max_msg_length + 1, np.int64)
        self.observe_into(state, rng, seen)
        return seen

    def observe_into(self, state: Toy, rng: Random, seen: Any) -> None:
        """The same, written into `seen`, shape (max_msg_length + 1,)."""
        seen[0] = state.hp
        message = state.message
        for k in range(self.max_msg_length, 0, -1):
            seen[k] = message % self.vocab_size
            message = message // self.vocab_size

    @property
    def max_steps(self) -> int:
        """The step limit, which the paper calls `steps_per_episode`."""
        return self.steps_per_episode

    @property
    def observation_space(self) -> spaces.MultiDiscrete:
        """The hit points, 0 to 100, and the words."""
        return spaces.MultiDiscrete(np.array([101] + [self.vocab_size] * self.max_msg_length, np.int64))

    @property
    def action_space(self) -> spaces.Discrete:
        """Play, sleep, feed or clean."""
        return spaces.Discrete(4)

    @classmethod
    def create(
        cls,
        tau: float = 0.0,
        max_msg_length: int = 1,
        vocab_size: int = 4,
        steps_per_episode: int = 100,
    ) -> "Tamagotchi":
        """Check the parameters (see the class) and make the task.

        Raises:
            ValueError: a parameter is not as the class says.
        """
        at_least("tau", tau, 0)
        vocab_size = whole_number("vocab_size", vocab_size, 1, 2**31)
        max_msg_length = whole_number("max_msg_length", max_msg_length, 1, 56)
        if vocab_size**max_msg_length > 2**56:
            longest = max(length for length in range(1, 57) if vocab_size**length <= 2**56)
            raise ValueError(
                f"max_msg_length must be from 1 to {longest} where vocab_size is {vocab_size}, but is {max_msg_length}"
            )
        steps_per_episode = number_of_steps("steps_per_episode", steps_per_episode)
        return cls(float(tau), max_msg_length, vocab_size, steps_per_episode)

    @property
    def reward_threshold(self) -> float | None:
        """At the defaults a little less than the return of obeying the messages, 6707; otherwise None."""
        return 6_600.0 if self == Tamagotchi.create() else None

    @property
    def action_names(self) -> tuple[str, ...]:
        """The buttons of the toy."""
        return NEEDS

    def info(self, state: Toy) -> dict[str, Any]:
        """What the toy feels and wants."""
        return {"variables": np.array(state.variables), "wanted": int(state.wanted)}

    def scene(self, state: Toy, last_action: int | None = None) -> Scene:
        """An egg-shaped toy with four buttons, its face and hit points on the screen, and its words in a bubble."""
        seen = [int(part) for part in self.observation(state, np.random.default_rng(0))]
        hp, words = seen[0], " ".join(meaning(word, self.vocab_size) for word in seen[1:])
        mood: Mood = "happy" if hp > 66 else "flat" if hp > 33 else "sad"
        lines = textwrap.wrap(words, 26, max_lines=3, placeholder=" ...")
        shell = blend(PURPLE, WHITE, 0.35)
        height = 1.0 + 0.8 * len(lines)
        turns = [math.tau * k / 72 for k in range(72)]
        egg = [(6.0 + (4.0 + 0.5 * math.sin(t)) * math.cos(t), 9.2 + 5.1 * math.sin(t)) for t in turns]
        shapes: list[Shape] = [
            Polygon(egg, fill=shell),
            Rectangle(3.4, 6.2, 5.2, 4.6, 0.5, fill=blend(GREEN, PAPER, 0.75)),
            *smiley(6.0, 7.9, 1.2, mood),
            *gauge(4.0, 10.1, 4.0, 0.35, f"HP {hp}", hp / 100, GREEN if hp > 33 else RED),
            *speech_bubble(0.6, 3.6 - height, 10.8, height, "", (6.0, 6.4)),
        ]
        for k, line in enumerate(lines):
            shapes.append(Text(6.0, 4.5 - height + 0.8 * k, line, size=0.65, glyph=f'"{line}"'))
        for action, (need, colour) in enumerate(zip(NEEDS, (ORANGE, BLUE, RED, GREEN), strict=True)):
            x, y = 3.75 + 1.5 * action, 11.75 if action in (0, 3) else 12.05
            pressed = action == last_action
            shapes.append(Circle(x, y, 0.42, fill=INK if pressed else colour, glyph="●" if pressed else "○"))
            shapes.append(Text(x, y + 0.75, need, size=0.45))
        return Scene(12.0, 14.6, shapes, SKY, f"Tamagotchi: HP {hp}, says {words}", columns=44)


def urgency(variable: int) -> float:
    """The lower a variable, the more urgent its need: u = exp(-v/100)."""
    return float(URGENCIES[variable])


def happiness(variables: Variables) -> float:
    """Σ (v - 50) u: from -200, all variables at 0, to 73.6, all at 100."""
    total = 0.0
    for variable in variables:
        total += (variable - 50) * urgency(variable)
    return total


def meaning(word: int, vocab_size: int) -> str:
    """What a word may be about, for a person: "play", a synonym of it, "play2", or "play/feed" if it is ambiguous."""
    if vocab_size < 4:
        return "/".join(NEEDS[need] for need in range(word, 4, vocab_size))
    return NEEDS[word % 4] + (str(word // 4 + 1) if word >= 4 else "")
