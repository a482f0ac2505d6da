"""The ladders in plain words, for readers who know none of the environments."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import NamedTuple


class Words(NamedTuple):
    """A ladder in plain words; each is "" where nobody has written it.

    Attributes:
        problem: what a problem has that is like this challenge.
        about: what the task is, and what makes a rung harder.
        rung: a rung, with {} for its strength.
        helps: what helps where no agent by itself is good.
    """

    problem: str = ""
    about: str = ""
    rung: str = ""
    helps: str = ""


NO_WORDS = Words()
WORDS: Mapping[str, Words] = MappingProxyType(
    {
        "Boulder": Words(
            "a reward that random play hardly ever finds",
            "Climb a wall. Only the top gives a reward, and one wrong grip leads back to the ground. The higher the"
            " wall, the more rarely chance finds the reward.",
            "a wall of height {}",
        ),
        "Roadrunner": Words(
            "the best play right beside a disaster (disasters while learning are free)",
            "Run along a road to the edge of a cliff, in as few steps as possible, and do not fall. Only the play"
            " after training counts: falls while learning cost nothing. The longer the road, the more positions and"
            " speeds there are to learn about.",
            "a road of length {}",
        ),
        "Study": Words(
            "a reward that comes long after the action that earned it",
            "Study on the day of the only lecture, to pass an exam on the last day. Nothing else has a reward. The more"
            " days, the more steps may lie between that lecture and the exam.",
            "{} days until the exam",
        ),
        "Catch": Words(
            "observations of many numbers, such as pictures",
            "Catch a falling ball with a paddle, and see the board as a grid of zeros and ones. The larger the board,"
            " the more numbers an observation has.",
            "a board of side {}",
        ),
        "MemoryCorridor": Words(
            "choices that depend on what was seen some steps ago",
            "Open the right doors of a corridor that gets one door longer each time. Only the last door is marked, so"
            " the earlier ones must be remembered. The longer the corridor, the more there is to remember.",
            "a corridor of length {}",
            "a wrapper that shows the last observations, too: QLearning scores 0.4, and QLearning + FrameStack(4) 0.7",
        ),
        "Tamagotchi": Words(
            "observations that are noisy messages about what counts (not noisy rewards)",
            "Give a toy what it needs. What it needs shows only in a message. The more noise, the less the message"
            " tells.",
            "a noise of {}",
        ),
        "Trashbot": Words(
            "actions that are real numbers, such as the turns of a robot's joints",
            "Turn the two joints of a robot arm, by real numbers, and drop a box into a container. The narrower the"
            " container, the more exactly the arm must move.",
            "a container of width {}",
        ),
        "Golf": Words(
            "actions whose outcome is a matter of chance",
            "Get a ball onto the green in few hits. A hit misses its aim by chance, a hard one by more. The more noise,"
            " the farther it misses.",
            "a noise of {}",
        ),
        "Supermarket": Words(
            "few real steps to learn from, since each is dear",
            "Collect three things in a supermarket, and leave by the exit. The task is the same on every rung, but"
            " there are fewer steps in which to learn it.",
            "{} training steps",
        ),
        "Switches": Words(
            "another goal in each episode",
            "Flip switches until they show a pattern, another one in each episode. Every step costs 1 until it is"
            " there. The more switches, the more patterns, and the more rarely chance finds the right one.",
            "{} switches",
        ),
    }
)
"""By the name of the ladder."""
WITHOUT_LADDER: Mapping[str, str] = MappingProxyType(
    {
        "Bandit": "every agent that explores plays the best arm in the end",
        "Casino": "good and bad play differ by 0.1, and returns scatter by up to 1: a score would be mostly luck",
        "Diver": "its reward is a vector",
    }
)
"""Why an environment has no ladder."""


def written(strength: float) -> str:
    """A strength as a reader likes it: at most three digits, and a space between thousands."""
    if abs(strength) >= 1000:
        return f"{strength:,.0f}".replace(",", "\N{NO-BREAK SPACE}")
    return f"{strength:.3g}"


def rounded(number: float) -> str:
    """A number with two digits, where 0 has no sign."""
    return f"{round(number, 2) + 0.0:.2f}"
