"""What a profile says in words: how far each agent gets in a challenge, and which ones are best."""

import math
from itertools import groupby
from typing import NamedTuple

import numpy as np

from edugym.experiments.profiles.ladders import in_words, rung_in_words
from edugym.experiments.profiles.pictures import scores_of
from edugym.experiments.profiles.scores import HALF, NEARLY, Profile
from edugym.experiments.profiles.words import written
from edugym.experiments.results.statistics import paired_difference


class Outcome(NamedTuple):
    """How one agent, or several, fare on a ladder, in a few words.

    Attributes:
        of_one: with the verb of one agent, such as "breaks at a wall of height between 12 and 15".
        of_several: with that of several.
        in_short: what stands behind the next agent of which the same is said, such as "between 12 and 15"; "" where
            there is none.
        reached: how far along the ladder, from 0 to the number of rungs; -1 where an agent cannot enter, or is not
            measured.
    """

    of_one: str
    of_several: str
    in_short: str
    reached: float


class Said(NamedTuple):
    """What the report says about a challenge.

    Attributes:
        challenge: the name.
        isolates: what the challenge is.
        sentence: how far each agent gets, and which one gets furthest.
    """

    challenge: str
    isolates: str
    sentence: str


def listed(texts: list[str]) -> str:
    """Texts as a list in a sentence."""
    return texts[0] if len(texts) == 1 else f"{', '.join(texts[:-1])} and {texts[-1]}"


def broken_between(profile: Profile, agent: str, challenge: str) -> tuple[float, float] | None:
    """The two rungs between which an agent breaks, the easier one first; None where it breaks between none."""
    broken = profile.breaks(agent, challenge)
    if broken is None or broken.where != "between":
        return None
    strengths = profile.ladder(challenge).strengths
    first_below = int(np.flatnonzero(profile.scores(agent, challenge).mean(axis=1) < HALF)[0])
    return strengths[first_below - 1], strengths[first_below]


def outcome(profile: Profile, agent: str, challenge: str) -> Outcome:
    """How an agent fares on a ladder."""
    ladder, broken = profile.ladder(challenge), profile.breaks(agent, challenge)
    if broken is None:
        if challenge in profile.blank.get(agent, {}):
            return Outcome("cannot enter", "cannot enter", "", -1.0)
        return Outcome("is not measured", "are not measured", "", -1.0)
    by_steps = ladder.n_steps is None  # then an agent does not break: it needs more steps
    first, last = (rung_in_words(ladder, ladder.strengths[k]) for k in (0, -1))
    if broken.where == "at once":
        even = f"even with {first}" if by_steps else f"even at {first}"
        return Outcome(f"fails {even}", f"fail {even}", "", 0.0)
    if rungs := broken_between(profile, agent, challenge):
        low, high = sorted(rungs)
        short = f"between {written(low)} and {written(high)}"
        words, place = in_words(ladder, short), float(ladder.strengths.index(rungs[1]))
        if by_steps:
            enough = f"{words} to score {HALF:g}"
            return Outcome(f"needs {enough}", f"need {enough}", short, place)
        return Outcome(f"breaks at {words}", f"break at {words}", short, place)
    n_rungs = len(ladder.strengths)
    if profile.rungs(agent, challenge)[-1].estimate >= NEARLY:
        even = f"it even with {last}" if by_steps else f"even {last}"
        return Outcome(f"masters {even}", f"master {even}", "", n_rungs + 1.0)
    even = f"even with {last}" if by_steps else f"even at {last}"
    return Outcome(f"does not break {even}", f"do not break {even}", "", float(n_rungs))


def said(profile: Profile, challenge: str, beside: Profile | None = None) -> Said:
    """What the report says about a challenge; an agent of another profile is named where it is surely better."""
    sentences = [
        f"{text}." for text in (*_standing(profile, challenge, beside), _better(profile, challenge, beside)) if text
    ]
    return Said(challenge, profile.ladder(challenge).challenge, " ".join(sentences))


def _standing(profile: Profile, challenge: str, beside: Profile | None) -> list[str]:
    """How far each agent gets, the one with the highest score first: sentences without their full stops."""
    scores = scores_of(profile, challenge)
    agents = sorted(profile.agents, key=lambda agent: -scores.get(agent, -math.inf))
    outcomes = {agent: outcome(profile, agent, challenge) for agent in agents}
    found: dict[Outcome, list[str]] = {}
    for agent, how in outcomes.items():
        found.setdefault(how, []).append(agent)
    (first, leaders), *_ = found.items()
    sentences = []
    ahead = first.reached == max(how.reached for how in found)  # who breaks later may have the lower score
    if leaders == best_agents(profile, challenge) and len(leaders) == 1 and len(scores) > 1 and ahead:
        among = "Of those that you gave, " if others_of(profile, beside, challenge) else ""
        sentences.append(f"{among}{leaders[0]} gets furthest: it {first.of_one}")
        del found[first]
    for breaks, groups in groupby(found.items(), key=lambda pair: bool(pair[0].in_short)):
        texts: list[str] = []
        for how, agents in groups:
            words = how.in_short if breaks and texts else how.of_one if len(agents) == 1 else how.of_several
            texts.append(f"{listed(agents)} {words}")
        sentences += [listed(texts)] if breaks else texts
    return sentences


def _better(profile: Profile, challenge: str, beside: Profile | None) -> str:
    """How far the best agent of another profile gets, if it is surely better; else ""."""
    better = better_beside(profile, challenge, beside)
    if better is None or beside is None:
        return ""
    how = outcome(beside, better, challenge).of_one
    here = any(profile.score(agent, challenge).n for agent in profile.agents)
    return f"{better}, one of the other agents, {f'is better: it {how}' if here else how}"


def best_agents(profile: Profile, challenge: str) -> list[str]:
    """The agent with the highest score, then those that are not surely worse, by their scores; none where none enters.

    An agent that is not better than random play is none of them.
    """
    scores = {agent: score for agent, score in scores_of(profile, challenge).items() if score > 0}
    best, *others = sorted(scores, key=lambda agent: -scores[agent]) or [""]
    return [best, *(agent for agent in others if not surely_worse(profile, challenge, agent, best))] if best else []


def good_agents(profile: Profile, challenge: str) -> list[str]:
    """The same, where the best one is good, with a score of 0.5 or more; else none: nobody is to be taken there."""
    best = best_agents(profile, challenge)
    return best if best and profile.score(best[0], challenge).estimate >= HALF else []


def surely_worse(profile: Profile, challenge: str, agent: str, best: str) -> bool:
    """Whether the difference of two agents can hardly be chance.

    Agents with as many runs are compared in pairs of runs, since these have the same seeds and layouts: the 95 %
    interval of the difference lies above 0. Else the intervals of their scores lie apart.
    """
    high, low = profile.score(best, challenge), profile.score(agent, challenge)
    if high.n != low.n:
        return low.high < high.low
    ours, theirs = (profile.scores(name, challenge).mean(axis=0) for name in (best, agent))
    return paired_difference(ours, theirs).low > 0


def others_of(profile: Profile, beside: Profile | None, challenge: str) -> dict[str, float]:
    """The scores of the agents of another profile that have none in this one."""
    here = scores_of(profile, challenge)
    return {agent: score for agent, score in scores_of(beside, challenge).items() if agent not in here}


def better_beside(profile: Profile, challenge: str, beside: Profile | None) -> str | None:
    """The best agent of another profile, if it is good and surely better than all here: their intervals lie apart."""
    others = others_of(profile, beside, challenge)
    if beside is None or not others:
        return None
    best = max(others, key=lambda agent: others[agent])
    here = [profile.score(agent, challenge) for agent in profile.agents]
    highest = max((score.high for score in here if score.n), default=-math.inf)
    return best if others[best] >= HALF and beside.score(best, challenge).low > highest else None
