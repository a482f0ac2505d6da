"""The agents of lesson 15, and their profiles."""

from collections.abc import Sequence
from dataclasses import replace
from functools import cache, partial
from typing import Any

from edugym.agents.q_learning import QLearning
from edugym.agents.r_max import RMax
from edugym.experiments.profiles.ladders import LADDERS, Ladder
from edugym.experiments.profiles.profile import profile
from edugym.experiments.profiles.scores import Profile
from edugym.experiments.profiles.verdicts import said
from edugym.experiments.results.statistics import Interval, mean_interval, paired_difference
from edugym_course import agent_profiles

Q_LEARNING, R_MAX, R_MAX_10 = "Q-learning", "R-max", "R-max, 10 tries"
R_MAX_8000, R_MAX_BOTH = "R-max, U = 8000", "R-max, 10 tries, U = 8000"
SLOW, SHORT_SIGHTED = "α = 0.000001", "γ = 0"
AGENTS = {
    Q_LEARNING: QLearning.create,
    R_MAX: RMax.create,
    R_MAX_10: partial(RMax.create, known_after=10),
    R_MAX_8000: partial(RMax.create, highest_return=8000.0),
    R_MAX_BOTH: partial(RMax.create, known_after=10, highest_return=8000.0),
    SLOW: partial(QLearning.create, learning_rate=0.000001),
    SHORT_SIGHTED: partial(QLearning.create, discount=0.0),
}
"""All at their defaults, but for what their names say."""
REPETITIONS = 5
HOLE = 0.2
"""How much lower a score must be to count as a hole."""
CERTAIN_MESSAGES = next(ladder for ladder in LADDERS if ladder.name == "Tamagotchi")._replace(strengths=(0.0,))
"""The first rung of Tamagotchi alone."""
WITH_AND_WITHOUT = ("Tamagotchi", "Study")
"""The ladder on which an agent should be as good as before, and that of the hole."""
TRAINING = "training what make_mine returns"


@cache
def stored(agents: tuple[str, ...] = ()) -> Profile:
    """Return the profiles that are stored with the course, by default of all agents."""
    found = agent_profiles.load()
    assert found is not None  # it comes with the package
    return replace(found, agents=agents) if agents else found


def stored_agents() -> list[str]:
    """Return the agents with a stored profile of all ladders that they can enter."""
    found = stored()
    return [
        agent
        for agent in found.agents
        if all(found.score(agent, name).n or name in found.blank[agent] for name in found.challenges)
    ]


def whole_profile(agent: str) -> list[str]:
    """Return how far an agent gets on each ladder, a sentence a challenge."""
    found = stored((agent,))
    return [f"{name} ({found.ladder(name).challenge}). {said(found, name).sentence}" for name in found.challenges]


def climb(names: Sequence[str], challenges: Sequence[str | Ladder], **how: Any) -> Profile:
    """Profile agents of the lesson; other arguments are those of `edugym.profile`."""
    return profile(
        {name: AGENTS[name] for name in names}, **{"challenges": challenges, "repetitions": REPETITIONS, **how}
    )


def mean_scores(found: Profile, agent: str, challenge: str) -> Any:
    """Return the score of each repetition: the mean over the rungs."""
    return found.scores(agent, challenge).mean(axis=0)


def gap(found: Profile, first: str, second: str, challenge: str) -> Interval:
    """Return how much better the first agent is, in pairs of runs with the same seeds and layouts."""
    return paired_difference(mean_scores(found, first, challenge), mean_scores(found, second, challenge))


def on_first_rung(found: Profile, agent: str, challenge: str) -> Interval:
    """Return the score on the easiest rung."""
    return mean_interval(found.scores(agent, challenge)[0])


def compared(easy: Interval, hard: Interval) -> str:
    """Return how much better an agent is than Q-learning, in a few words."""
    return f"Tamagotchi {easy.estimate:+.2f}, Study {hard.estimate:+.2f} against Q-learning"
