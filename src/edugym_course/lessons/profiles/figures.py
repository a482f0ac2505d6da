"""The figures of lesson 15."""

from edugym.agents.q_learning import QLearning
from edugym.agents.strategies import EpsilonGreedy
from edugym.experiments.figures.sheet import Sheet
from edugym.experiments.profiles.pictures import Dots, Rungs
from edugym.experiments.profiles.profile import profile
from edugym.experiments.profiles.scores import Profile


def ladders(found: Profile, name: str = "ladders") -> Sheet:
    """Draw each ladder of a profile."""
    return Sheet(name, [[Rungs(found, challenge) for challenge in found.challenges]])


def scores(found: Profile) -> Sheet:
    """Draw the scores of a profile."""
    return Sheet("scores", [[Dots(found)]])


def one_setting(learning_rate: float = 0.1, discount: float = 0.99, epsilon: float = 0.1) -> Sheet:
    """Draw two ladders of Q-learning, with three runs on each rung."""
    settings = {"learning_rate": learning_rate, "discount": discount, "exploration": EpsilonGreedy(epsilon)}
    agents = {"Q-learning": lambda environment: QLearning.create(environment, **settings)}
    return ladders(profile(agents, challenges=["Study", "Tamagotchi"], repetitions=3))
