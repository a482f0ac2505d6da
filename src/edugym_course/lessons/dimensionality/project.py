"""The project of lesson 4: a network with one hidden layer that learns Catch from pixels, from a blank file.

What a network learns hangs on its first weights and on its optimiser, so the steps of a program do not give it, as they
give a table. The program is put to the test instead: in riddles of six images, each of which cannot be solved if one
part of the method is missing, and in Catch in changing light, where no image comes twice.
"""

import math
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from edugym.adapters.gymnasium_env import MDPEnv
from edugym.envs.catch import Catch
from edugym.mdp.brightness import Brightness
from edugym_course.grading.curves import symptom
from edugym_course.grading.errors import WrongAnswer, nobody_asks_why
from edugym_course.grading.programs import NAME, Environment, Run, actions_of, returns_of, run_program
from edugym_course.grading.repeats import require_reproducible
from edugym_course.grading.rule import ASKED, TRIAL
from edugym_course.lessons.dimensionality.riddles import (
    BAD,
    CHOOSY,
    DARK,
    EMPTY,
    GOOD,
    LOW,
    N_ACTIONS,
    NEVER_STORED,
    RIDDLES,
    Album,
    Riddle,
)
from edugym_course.lessons.dimensionality.twins import COLUMNS, ROWS, Twins

N_STEPS, RIDDLE_STEPS, RUNS, EPISODES = 10_000, 2_000, 3, 50
CAUGHT = 0.7
"""The share of the balls that the policy must catch in the middle run; random play catches a fifth."""
SOLVED = 0.85
"""The share of the right actions with which a riddle is solved; random play takes a third of them."""
OPPOSITE, UNSOLVED = 0.05, 0.5
"""The share of the right actions of a program that prefers wrong ones, and of one that never solves a riddle."""
CONSTANT = 0.95
"""A program does not explore if the commonest action in each image has this share; with ε = 0.1 it was 0.89 at most."""
GREEDY = 0.75
"""A program that knows the right actions takes this share of them with ε = 0.38; with ε = 0.1 it takes 93 %."""
OFTEN = 250
"""Who sees an image so often and never takes some action there does not try all; with ε = 0.1 it takes each 8 times."""
FEW = 0.4
"""Who catches fewer has hardly learned anything."""
MUCH = 0.1
"""A policy that catches this much less than its program did in training chooses by something else."""
PATIENCE, SLOW_BUT_SOLVED = 5, 0.92
"""A program with this share of right actions in so many times as many steps is only slow; a fixed W1 got 86 %."""
TWIN_STEPS, TWIN_QUESTIONS, TWINS_SOLVED = 4_000, 300, 0.92
MASK = "Is h_j never below 0, and g_j 0 where h_j is 0?"
NOT_CHOOSY = f"It does not solve another riddle, in which {CHOOSY.asks}"
BEYOND = (
    "Its actions change with the image that it is shown after a terminated end, and nothing should hang on it: where"
    " `terminated` is True, the target is R alone, and the program goes on from the image that *reset* gives. (Or is"
    " its maximum over a whole batch, and not over the actions of each row? Or does W1 learn from that image, and not"
    " from the one in which the action was taken?)"
)
TOO_RANDOM = "Is ε larger, have ε and 1 − ε changed places, or are all actions drawn at random?"
FROZEN = (
    "Hidden units that keep their first weights get 39 to 87 %: does the gradient change W1 and b1, and not only W2"
    f" and b2? {MASK} Are the first weights of a layer with n inputs of a size near 1/√n, and not much larger?"
)


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
        why = "" if nobody_asks_why() else _cause_while_training(program, riddle, seed)
        raise WrongAnswer(
            f"in a riddle of six images, the policy of {NAME} takes the right action in {found.played:.0%} of the"
            f" questions after {RIDDLE_STEPS} steps, but while it learned the program took it in {found.trained:.0%}"
            f" of the last ones: with ε = 0.1 it should take the best action nine times of ten. {why}"
        )


def looks_beyond_ends(program: Any, riddle: Riddle, seed: int) -> bool:
    """Whether the image after a terminated end, which no target needs, changes the actions of a program."""
    albums = [Album(riddle, RUNS * seed, last) for last in (GOOD, BAD)]
    first, other = (run_program(program, album, RIDDLE_STEPS, RUNS * seed).steps for album in albums)
    return [step.action for step in first] != [step.action for step in other]


def _cause_while_training(program: Any, riddle: Riddle, seed: int) -> str:
    """Return why the policy may be right, and many actions of the training are not."""
    if riddle is EMPTY:
        return f"In this riddle, {riddle.asks}"
    if looks_beyond_ends(program, riddle, seed):
        return BEYOND
    if (longer := solution(program, riddle, PATIENCE * RIDDLE_STEPS, seed).trained) > GREEDY:
        return (
            f"After {PATIENCE * RIDDLE_STEPS} steps it does so in {longer:.0%}: is ε 0.1 from the first step on, or"
            " does it fall slowly? Or does it learn too slowly: is there an update at every step, with a learning rate"
            " and first weights like those of the text, and does an error move the weights of the action that was"
            " *taken*?"
        )
    return TOO_RANDOM


def never_tried(program: Any, seed: int) -> str:
    """Return a sentence on the action that a program never takes in an image that comes often, "" if there is none."""
    steps = run_program(program, Album(RIDDLES[0], RUNS * seed), RIDDLE_STEPS, RUNS * seed).steps
    taken: dict[bytes, list[int]] = {}
    for step in steps:
        taken.setdefault(step.state.tobytes(), []).append(step.action)
    for actions in taken.values():
        counts = np.bincount(actions, minlength=N_ACTIONS)
        if len(actions) >= OFTEN and not counts.all():
            return (
                f"One of the images comes {len(actions)} times, and there it never takes the action {counts.argmin()}:"
                " is the random action one of *all* n actions, 0 to n - 1, as rng.integers(n) draws it, and is ε 0.1?"
            )
    return ""


def never_explores(program: Any, riddle: Riddle, seed: int) -> bool:
    """Whether a program hardly ever takes another action than the commonest one in an image, in the end."""
    steps = run_program(program, Album(riddle, RUNS * seed), RIDDLE_STEPS, RUNS * seed).steps
    taken: dict[bytes, list[int]] = {}
    for step in steps[-RIDDLE_STEPS // 4 :]:
        taken.setdefault(step.state.tobytes(), []).append(step.action)
    commonest = sum(max(map(actions.count, actions)) for actions in taken.values())
    return commonest > CONSTANT * sum(map(len, taken.values()))


def _cause(program: Any, riddle: Riddle, found: Solution, seed: int) -> str:
    """Return why the policy is not right."""
    if riddle is EMPTY:
        return f"In this riddle, {riddle.asks}"
    if looks_beyond_ends(program, riddle, seed):
        return BEYOND
    if found.trained > SOLVED:
        return (
            "While it learned, it did: does the policy compute the values of the image that it is given, without ε? If"
            " it does, they have changed once more in the last steps: is the learning rate too large, or"
            f" {NEVER_STORED}"
        )
    if found.is_one and riddle is RIDDLES[0]:
        return (
            "It takes the same action for every image. Do its values become NaN? The usual reasons: W2 is changed"
            " before it hands the gradient back to W1, a minus sign is missing, or a learning rate is too large. Or are"
            " all first weights 0, all pixels rounded to 0 or 1, or all stored images one array, and not copies?"
        )
    if riddle is RIDDLES[0] and found.played < OPPOSITE:
        return (
            "It takes the worst actions: is the sign of the gradient wrong, is there an `argmin`, or is another action"
            " or reward stored than that of the step?"
        )
    if never_explores(program, riddle, seed):
        return (
            "In the end it takes the same action nearly each time that it sees an image: does it explore, with ε = 0.1?"
        )
    if untried := never_tried(program, seed):
        return untried
    longer = solution(program, riddle, PATIENCE * RIDDLE_STEPS, seed).played
    if riddle is not RIDDLES[0] and (
        solution(program, CHOOSY, RIDDLE_STEPS, seed).played < OPPOSITE
        or (longer > SOLVED and solution(program, CHOOSY, PATIENCE * RIDDLE_STEPS, seed).played < UNSOLVED)
    ):
        return NOT_CHOOSY
    if longer > SLOW_BUT_SOLVED:
        return (
            f"After {PATIENCE * RIDDLE_STEPS} steps it is {longer:.0%}, so it learns too slowly: likely a learning"
            " rate or first weights that are too small, too few updates, weights that are never learned, or an ε"
            " below 0.1"
        )
    if riddle is not RIDDLES[0] and twins_solved(program, seed) < TWINS_SOLVED:
        return f"Where two pixels together tell the right action, it does not find it either. {FROZEN}"
    if riddle.right.truncated:
        not_cut = riddle._replace(right=riddle.right._replace(truncated=False))
        if solution(program, not_cut, RIDDLE_STEPS, seed).played < SOLVED:
            return (
                "In this riddle, the right action brings 0 and then a better image, and another one 0.7 at once: does"
                " the target have γ max Q(S', a), with γ = 0.9, by weights that learn, or that are brought up to date"
                " again and again, and is the error of the actions that were *not* taken 0?"
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
    if solution(program, CHOOSY, RIDDLE_STEPS, number).played < OPPOSITE:
        return NOT_CHOOSY
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
            "it solves the riddles and catches the balls, but not a harder riddle, in which two pixels together tell"
            f" the right action: after {TWIN_STEPS} steps the policy of {NAME} takes it in {share:.0%} of the"
            f" questions. {FROZEN}"
        )


def project_4(answer: Any, seed: int) -> str:
    """Check a program with a network that learns from pixels."""
    require_reproducible(answer, partial(Album, RIDDLES[0], seed), TRIAL, seed)
    for riddle in RIDDLES:
        check_riddle(answer, riddle, seed)
    share = check_catch(answer, seed)
    check_policy(answer, seed)
    check_twins(answer, seed)
    for riddle in (LOW, CHOOSY, DARK, EMPTY):
        check_riddle(answer, riddle, seed)
    return (
        f"Right: it solves the riddles, and in the middle one of {RUNS} runs on Catch in changing light it catches"
        f" {share:.0%} of the balls; random play catches 20%."
    )
