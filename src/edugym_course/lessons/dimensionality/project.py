"""The project of lesson 4: a network with one hidden layer that learns Catch from pixels, from a blank file.

What a network learns hangs on its first weights and on its optimiser, so the steps of a program do not give it, as they
give a table. The program is put to the test instead: in riddles of six images, each of which cannot be solved if one
part of the method is missing, and in Catch in changing light, where no image comes twice.
"""

import math
from functools import partial
from typing import Any, NamedTuple

import gymnasium
import numpy as np
from gymnasium import spaces

from edugym.adapters.gymnasium_env import MDPEnv
from edugym.envs.catch import Catch
from edugym.mdp.brightness import Brightness
from edugym_course.grading.curves import symptom
from edugym_course.grading.errors import WrongAnswer, nobody_asks_why
from edugym_course.grading.programs import (
    APART,
    NAME,
    Environment,
    Run,
    actions_of,
    require_reproducible,
    returns_of,
    run_program,
)
from edugym_course.grading.replay import ASKED, TRIAL
from edugym_course.lessons.dimensionality.twins import COLUMNS, ROWS, Twins

N_STEPS, RIDDLE_STEPS, RUNS, EPISODES = 10_000, 2_000, 3, 50
CAUGHT = 0.7
"""The share of the balls that the policy must catch in the middle run; random play catches a fifth."""
SOLVED = 0.85
"""The share of the right actions with which a riddle is solved; random play takes a third of them."""
OPPOSITE = 0.05
GREEDY = 0.6
"""The share of the right actions that a program that knows them takes with ε = 0.6; with 0.1 it takes 93 %."""
FEW = 0.4
"""Who catches fewer has hardly learned anything."""
MUCH = 0.1
"""A policy that catches this much less than its program did in training chooses by something else."""
PATIENCE = 5
"""A program that solves a riddle in this many times as many steps is only slow."""
QUESTIONS, GOOD, BAD = 4, 4, 5
TWIN_STEPS, TWIN_QUESTIONS, TWINS_SOLVED = 4_000, 300, 0.92
MASK = "Is g_j 0 where h_j is 0?"
FROZEN = (
    "Hidden units that keep their first weights get 39 to 87 %: does the gradient change W1 and b1, and not only W2"
    f" and b2? {MASK}"
)


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
    """

    right: Move
    wrong: Move
    asks: str
    good: Move = Move(1.0, GOOD)
    bad: Move = Move(-1.0, GOOD)
    choosy: bool = False


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
"""These two are asked last, so that other mistakes are told by the riddles that ask for them."""


class Album(gymnasium.Env[Any, Any]):
    """A riddle.

    Args:
        riddle: the riddle.
        seed: the number from which the images and the right actions are drawn.
        last: the image that is shown after a terminated end, in the place of that of the riddle.

    Attributes:
        answers: the actions in questions so far, and whether they were right.
    """

    def __init__(self, riddle: Riddle, seed: int, last: int | None = None) -> None:
        """Draw the images; each action is right for some question."""
        rng = np.random.default_rng(APART + seed)
        self.observation_space = spaces.Box(0.0, 1.0, (ROWS, COLUMNS), np.float32)
        self.action_space = spaces.Discrete(3)
        self.answers: list[tuple[int, bool]] = []
        self._images = rng.random((QUESTIONS + 2, ROWS, COLUMNS), np.float32)
        self._right = rng.permutation([0, 1, 2, int(rng.integers(3))])
        self._best = int(rng.integers(3))
        self._riddle, self._image, self._last = riddle, 0, last

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Any, dict[str, Any]]:
        """Begin with any image."""
        super().reset(seed=seed)
        self._image = int(self.np_random.integers(len(self._images)))
        return self._images[self._image].copy(), {}

    def step(self, action: int) -> tuple[Any, float, bool, bool, dict[str, Any]]:
        """Answer."""
        if self._image < QUESTIONS:
            self.answers.append((action, bool(action == self._right[self._image])))
            move = self._riddle.right if self.answers[-1][1] else self._riddle.wrong
        elif self._image == GOOD:
            move = Move(-1.0, GOOD) if self._riddle.choosy and action != self._best else self._riddle.good
        else:
            move = self._riddle.bad
        self._image = move.image if self._last is None or not move.terminated else self._last
        return self._images[self._image].copy(), move.reward, move.terminated, move.truncated, {}


class Solution(NamedTuple):
    """How well a riddle is solved.

    Attributes:
        trained: the share of right answers in the last quarter of the training.
        played: that of the policy.
        is_one: whether the policy takes one action only, in every album.
    """

    trained: float
    played: float
    is_one: bool


def solution(program: Any, riddle: Riddle, n_steps: int, seed: int) -> Solution:
    """Let a program solve a riddle, in several albums; the shares are means over these."""
    found = []
    for number in range(RUNS * seed, RUNS * (seed + 1)):
        trained, played = Album(riddle, number), Album(riddle, number)
        policy = run_program(program, trained, n_steps, number).policy
        returns_of(policy, played, EPISODES, number + 1)
        late = trained.answers[-len(trained.answers) // 4 :]
        shares = (float(np.mean([right for _, right in answers])) for answers in (late, played.answers))
        found.append((*shares, len({action for action, _ in played.answers}) == 1))
    trained_share, played_share, is_one = np.mean(found, axis=0).tolist()
    return Solution(trained_share, played_share, is_one == 1.0)


def check_riddle(program: Any, riddle: Riddle, seed: int) -> None:
    """Check that a program solves a riddle.

    Raises:
        WrongAnswer: it does not, or it breaks the contract.
    """
    found = solution(program, riddle, RIDDLE_STEPS, seed)
    if found.played < SOLVED:
        why = "" if nobody_asks_why() else _cause(program, riddle, found, seed)
        raise WrongAnswer(
            f"in a riddle of six images, the policy of {NAME} takes the right action in {found.played:.0%} of the"
            f" questions after {RIDDLE_STEPS} steps; by chance it would be 33%. {why}"
        )
    if found.trained < GREEDY:
        raise WrongAnswer(
            f"in a riddle of six images, the policy of {NAME} takes the right action in {found.played:.0%} of the"
            f" questions after {RIDDLE_STEPS} steps, but while it learned the program took it in {found.trained:.0%}"
            " of the last ones: with ε = 0.1 it should take the best action nine times of ten. Have ε and 1 − ε changed"
            " places, or are all actions drawn at random?"
        )


def looks_beyond_ends(program: Any, riddle: Riddle, seed: int) -> bool:
    """Whether the image after a terminated end, which no target needs, changes the actions of a program."""
    albums = [Album(riddle, RUNS * seed, last) for last in (GOOD, BAD)]
    first, other = (run_program(program, album, RIDDLE_STEPS, RUNS * seed).steps for album in albums)
    return [step.action for step in first] != [step.action for step in other]


def _cause(program: Any, riddle: Riddle, found: Solution, seed: int) -> str:
    if looks_beyond_ends(program, riddle, seed):
        return (
            "Its actions change with the image that it is shown after a terminated end, so it looks up what comes then:"
            " where `terminated` is True, the target is R alone. (Or is its maximum over a whole batch, and not over"
            " the actions of each row? Does it go on from that image in place of the one that reset gives? Or does W1"
            " learn from it, and not from the image in which the action was taken?)"
        )
    if found.is_one and riddle is not RIDDLES[-1]:  # there values that grow without end may make it so
        return (
            "It takes the same action for every image. Do its values become NaN? The usual reasons: W2 is changed"
            " before it hands the gradient back to W1, a minus sign is missing, or a learning rate is too large. Or are"
            " all first weights 0, so that no pixel counts?"
        )
    if found.trained > SOLVED:
        return "While it learned, it did: does the policy compute the values of the image that it is given, without ε?"
    if riddle is RIDDLES[0] and found.played < OPPOSITE:
        return "It takes the worst actions: is the sign of the gradient wrong, or is there an `argmin`?"
    longer = solution(program, riddle, PATIENCE * RIDDLE_STEPS, seed).played
    if longer > SOLVED:
        return (
            f"After {PATIENCE * RIDDLE_STEPS} steps it is {longer:.0%}, so it learns too slowly: likely a learning"
            " rate or first weights that are too small, too few updates, or weights that are never learned"
        )
    if riddle is not RIDDLES[0] and twins_solved(program, seed) < TWINS_SOLVED:
        return f"Where two pixels together tell the right action, it does not find it either. {FROZEN}"
    if riddle.right.truncated:
        not_cut = riddle._replace(right=riddle.right._replace(truncated=False))
        if solution(program, not_cut, RIDDLE_STEPS, seed).played < SOLVED:
            return (
                "In this riddle, the right action brings 0 and then a better image, and another one 0.7 at once: does"
                " the target have γ max Q(S', a), with γ = 0.9, by weights that learn, or that are brought up to date"
                " again and again?"
            )
    return f"In this riddle, {riddle.asks}"


def board(brightest: bool = False) -> Environment:
    """Catch on a small board, with a new brightness at every step or always the same."""
    task: Any = Brightness.create(Catch.create(ROWS, COLUMNS), low=1.0 if brightest else 0.4)
    return MDPEnv(task)


def caught(program: Any, seed: int, brightest: bool = False) -> tuple[float, Run]:
    """Return the share of the balls that the policy of a program catches, and how it learned."""
    run = run_program(program, board(brightest), N_STEPS, seed)
    return (1 + float(returns_of(run.policy, board(brightest), EPISODES, seed + 1).mean())) / 2, run


def check_catch(program: Any, seed: int) -> float:
    """Check that a program learns Catch in changing light, and return the share of the balls that it catches.

    Raises:
        WrongAnswer: it does not, or it breaks the contract.
    """
    runs = [(*caught(program, number), number) for number in range(RUNS * seed, RUNS * (seed + 1))]
    share, run, number = sorted(runs, key=lambda run: run[0])[RUNS // 2]
    if share >= CAUGHT:
        return share
    why = "" if nobody_asks_why() else _cause_in_catch(program, run, share, number)
    raise WrongAnswer(
        f"it solves the riddles, but in the middle one of {RUNS} runs on Catch in changing light it catches {share:.0%}"
        f" of the balls, and it should be {CAUGHT:.0%} or more: {why}"
    )


def _cause_in_catch(program: Any, run: Run, share: float, number: int) -> str:
    steady, _ = caught(program, number, brightest=True)
    if share < FEW and steady >= CAUGHT:
        return (
            f"in steady light it catches {steady:.0%}: it knows the images that it met, as a table does, and here none"
            " comes twice"
        )
    trained = (1 + run.late()) / 2
    if trained > share + MUCH:  # the policy takes the best action, since it solves the riddles
        return (
            f"while it learned, it caught {trained:.0%} in the end. A policy sees a new image at each step. Does the"
            " program, too, or is `state = next_state` missing?"
        )
    return f"{symptom(run, math.inf)}. {MASK}"  # nothing is wrong with the policy


def twins_solved(program: Any, seed: int) -> float:
    """Return the share of new twins to which the policy of a program answers right, the mean over several runs."""
    shares = []
    for number in range(RUNS * seed, RUNS * (seed + 1)):
        policy, played = run_program(program, Twins(number), TWIN_STEPS, number).policy, Twins(number)
        returns_of(policy, played, TWIN_QUESTIONS, number + 1)
        shares.append(np.mean(played.answers))
    return float(np.mean(shares))


def check_policy(program: Any, seed: int) -> None:
    """Check that the policy takes one action in each image.

    Raises:
        WrongAnswer: it draws its actions, or it breaks the contract.
    """
    album = Album(RIDDLES[0], seed)
    policy = run_program(program, album, TRIAL, seed).policy
    actions_of(policy, [album.reset(seed=number)[0] for number in range(ASKED)], 3, "image")


def check_twins(program: Any, seed: int) -> None:
    """Check that the hidden layer of a program learns.

    Raises:
        WrongAnswer: it does not, or the program breaks the contract.
    """
    if (share := twins_solved(program, seed)) < TWINS_SOLVED:
        raise WrongAnswer(
            "it solves the riddles and catches the balls, but not a last riddle, in which two pixels together tell the"
            f" right action: after {TWIN_STEPS} steps the policy of {NAME} takes it in {share:.0%} of the questions."
            f" {FROZEN}"
        )


def project_4(answer: Any, seed: int) -> str:
    """Check a program with a network that learns from pixels."""
    require_reproducible(answer, partial(Album, RIDDLES[0], seed), TRIAL, seed)
    for riddle in RIDDLES:
        check_riddle(answer, riddle, seed)
    share = check_catch(answer, seed)
    check_policy(answer, seed)
    check_twins(answer, seed)
    check_riddle(answer, LOW, seed)
    check_riddle(answer, CHOOSY, seed)
    return (
        f"Right: it solves the riddles, and in the middle one of {RUNS} runs on Catch in changing light it catches"
        f" {share:.0%} of the balls; random play catches 20%."
    )
