"""What the website says of each environment to somebody who knows nothing of the field.

The field's own words stand beside these: the challenge in the registry, and the answer to "why?" in the lesson.
"""

from typing import NamedTuple


class Words(NamedTuple):
    """The words for one environment.

    Attributes:
        challenge: what makes it hard, in a few words.
    """

    challenge: str


WORDS = {
    "Boulder": Words("To find the one place that pays, among very many that do not."),
    "Roadrunner": Words("To run fast beside a cliff, when you still stumble now and then."),
    "Study": Words("To find out which of many days earned the reward at the end."),
    "Catch": Words("To recognise what you see, when it never looks the same twice."),
    "MemoryCorridor": Words("To remember what you can no longer see."),
    "Tamagotchi": Words("To do the right thing when you are told only half of the truth."),
    "Trashbot": Words("To move an arm, which can turn by any angle."),
    "Golf": Words("To choose when the same hit ends in another place each time."),
    "Supermarket": Words("To learn from few tries, by thinking about what was tried."),
    "Switches": Words("To learn from a miss: you did reach something, if not what you wanted."),
    "Diver": Words("To want two things at once, a treasure and enough air."),
    "Casino": Words("Not to take luck for skill."),
    "Bandit": Words("To choose between trying something new and what was good so far."),
}
"""By the names of the environments."""
