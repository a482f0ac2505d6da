"""The figures of lesson 15."""

from edugym.agents.q_learning import QLearning
from edugym.agents.strategies import EpsilonGreedy
from edugym.experiments.figures.sheet import Sheet
from edugym.experiments.profiles.pictures import Dots, Rungs
from edugym.experiments.profiles.profile import profile
from edugym.experiments.profiles.scores import Profile
from edugym_course.lessons.profiles.methods import stored


def ladders(found: Profile, name: str = "ladders") -> Sheet:
    """Draw each ladder of a profile."""
    return Sheet(name, [[Rungs(found, challenge) for challenge in found.challenges]])


def scores(found: Profile) -> Sheet:
    """Draw the scores of a profile."""
    return Sheet("scores", [[Dots(found)]])


def all_ladders(*agents: str) -> Sheet:
    """Draw all ladders of stored profiles that one of the agents can enter."""
    found = stored(agents)
    drawn = [Rungs(found, name) for name in found.challenges if any(found.score(agent, name).n for agent in agents)]
    return Sheet("all_ladders", [drawn[first : first + 3] for first in range(0, len(drawn), 3)])


def beside_q_learning(agent: str = "QLearning") -> Sheet:
    """Draw all ladders of an agent, with those of Q-learning."""
    return all_ladders(*dict.fromkeys(("QLearning", agent)))


def one_setting(learning_rate: float = 0.1, discount: float = 0.99, epsilon: float = 0.1) -> Sheet:
    """Draw two ladders of Q-learning, with three runs on each rung, and the scores."""
    settings = {"learning_rate": learning_rate, "discount": discount, "exploration": EpsilonGreedy(epsilon)}
    agents = {"Q-learning": lambda environment: QLearning.create(environment, **settings)}
    found = profile(agents, challenges=["Study", "Tamagotchi"], repetitions=3)
    return Sheet("one_setting", [[*ladders(found).rows[0], Dots(found)]])
