"""Riddles of six images, each of which cannot be solved if one part of Q-learning with a network is missing."""

from typing import Any, NamedTuple

import gymnasium
import numpy as np
from gymnasium import spaces

from edugym_course.grading.programs import APART
from edugym_course.lessons.dimensionality.twins import COLUMNS, ROWS

QUESTIONS, GOOD, BAD, N_ACTIONS = 4, 4, 5, 3


class Move(NamedTuple):
    """What follows an action: a reward, the next image, and whether the episode ends."""

    reward: float
    image: int
    terminated: bool = True
    truncated: bool = False


class Riddle(NamedTuple):
    """A task with six images: questions with one right action each, and a good and a bad image.

    In the good image every action brings 1, unless `good` says otherwise, and in the bad one −1; then the episode is
    over. So it is in the bad image, unless `bad` says otherwise.

    Attributes:
        right: what follows the right action of a question.
        wrong: what follows another one.
        asks: what must be learned to solve it.
        good: what follows an action in the good image.
        bad: what follows an action in the bad image.
        choosy: whether only one action does that in the good image, and the others bring −1.
        dark: whether half of the episodes begin with a black image, whose question is the only one that counts.
        first: whether action 0 is the right one there, and not another one.
    """

    right: Move
    wrong: Move
    asks: str
    good: Move = Move(1.0, GOOD)
    bad: Move = Move(-1.0, GOOD)
    choosy: bool = False
    dark: bool = False
    first: bool = False


RIDDLES = (
    Riddle(
        Move(1.0, GOOD),
        Move(-1.0, GOOD),
        "the right action brings 1 at once, and another one −1: does the gradient go back through both layers, to the"
        " weights of the action that was taken? Is each image stored with its own action and reward, and as numbers"
        " from 0 to 1, not as whole numbers?",
    ),
    Riddle(
        Move(0.0, GOOD, terminated=False),
        Move(0.0, BAD, terminated=False),
        "the right action brings nothing but a better next image: the target is R + γ max Q(S', a), and S' is the state"
        " of the next step",
    ),
    Riddle(  # who looks beyond a terminated end prefers the image that is shown there
        Move(0.5, BAD),
        Move(0.0, GOOD),
        "the right action brings 0.5, and another one 0: is the reward stored as it is? An array of whole numbers makes"
        " 0 of it",
    ),
    Riddle(
        Move(0.0, GOOD, terminated=False, truncated=True),
        Move(0.7, BAD),
        "after the right action the episode is truncated: the clock was stopped, and the image that step gave (not that"
        " of reset) still has its value, so only `terminated` makes R alone the target",
    ),
    Riddle(  # the good image comes again, so it is worth 2 with γ = 0.9, and 4 with 0.95
        Move(2.5, BAD),
        Move(0.0, GOOD, terminated=False),
        "the right action brings 2.5 at once. Another one leads to an image in which every action brings 0.2 and that"
        " comes again, so that it is worth 0.2 / (1 − γ): is this value multiplied by γ in the target, and is γ 0.9?",
        good=Move(0.2, GOOD, terminated=False, truncated=True),
    ),
)
LOW = Riddle(
    Move(-0.3, GOOD),
    Move(0.0, BAD, terminated=False),
    "the right action brings -0.3 at once, and another one leads to an image in which every action brings -1: is the"
    " largest value the largest of S', however low it is? A search for it that starts with 0 finds 0",
)
CHOOSY = Riddle(
    Move(0.0, GOOD, terminated=False),
    Move(0.0, BAD, terminated=False),
    "the right action leads to an image in which one action brings 1 and the others −1, and another one to an image in"
    " which all bring −0.2: does the target have the *largest* value of S', and not their mean, or that of one action?",
    bad=Move(-0.2, GOOD),  # less than the largest value of the good image, and more than their mean
    choosy=True,
)
DARK = RIDDLES[0]._replace(
    asks="only a black image counts, with which half of the episodes begin. All its pixels are 0, so that W1 does not"
    " matter and the values are those of the biases: are there biases, and does the gradient change b1 and b2?",
    dark=True,
)
NEVER_STORED = "are rows of a batch drawn that were never stored?"
EMPTY = Riddle(
    Move(1.0, GOOD),
    Move(0.5, GOOD),
    "only a black image counts, with which half of the episodes begin. There action 0 brings 1, and the others 0.5. If"
    " your program has a memory, an empty place of it looks like a black image, action 0 and a reward of 0:"
    f" {NEVER_STORED} If it has none: does it learn too slowly?",
    dark=True,
    first=True,
)
"""These four are asked last, so that other mistakes are told by the riddles that ask for them."""


class Album(gymnasium.Env[Any, Any]):
    """A riddle.

    Args:
        riddle: the riddle.
        seed: the number from which the images and the right actions are drawn.
        last: the image that is shown after a terminated end, in the place of that of the riddle.

    Attributes:
        answers: the actions in the questions that count so far, and whether they were right.
    """

    def __init__(self, riddle: Riddle, seed: int, last: int | None = None) -> None:
        """Draw the images; each action is right for some question."""
        rng = np.random.default_rng(APART + seed)
        self.observation_space = spaces.Box(0.0, 1.0, (ROWS, COLUMNS), np.float32)
        self.action_space = spaces.Discrete(N_ACTIONS)
        self.answers: list[tuple[int, bool]] = []
        self._images = rng.random((QUESTIONS + 2, ROWS, COLUMNS), np.float32)
        self._right = rng.permutation([0, 1, 2, int(rng.integers(N_ACTIONS))])
        self._best = int(rng.integers(N_ACTIONS))
        if riddle.dark:
            self._images[0] = 0.0
            # Not 0, unless `first`: where all values are equal, argmax takes action 0.
            of_the_black_one = self._right == 0 if riddle.first else self._right > 0
            self._right = np.roll(self._right, -np.flatnonzero(of_the_black_one)[0])
        self._riddle, self._image, self._last = riddle, 0, last

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Any, dict[str, Any]]:
        """Begin with any image, or with the black one."""
        super().reset(seed=seed)
        self._image = int(self.np_random.integers(len(self._images)))
        if self._riddle.dark and self.np_random.random() < 0.5:
            self._image = 0
        return self._images[self._image].copy(), {}

    def step(self, action: int) -> tuple[Any, float, bool, bool, dict[str, Any]]:
        """Answer."""
        if self._image < QUESTIONS:
            right = bool(action == self._right[self._image])
            if not self._riddle.dark or self._image == 0:
                self.answers.append((action, right))
            move = self._riddle.right if right else self._riddle.wrong
        elif self._image == GOOD:
            move = Move(-1.0, GOOD) if self._riddle.choosy and action != self._best else self._riddle.good
        else:
            move = self._riddle.bad
        self._image = move.image if self._last is None or not move.terminated else self._last
        return self._images[self._image].copy(), move.reward, move.terminated, move.truncated, {}
