"""What a profile says in words: how far each agent gets in a challenge, and which one to take."""

import math
from itertools import groupby
from typing import NamedTuple

import numpy as np

from edugym.experiments.profiles.ladders import Ladder, rung_in_words
from edugym.experiments.profiles.pictures import scores_of
from edugym.experiments.profiles.scores import HALF, NEARLY, Profile
from edugym.experiments.profiles.words import rounded, written
from edugym.experiments.results.statistics import paired_difference


class Outcome(NamedTuple):
    """How one agent, or several, fare on a ladder, in a few words.

    Attributes:
        of_one: with the verb of one agent, such as "breaks at a wall of height 14".
        of_several: with that of several.
        in_short: what stands behind the next agent of which the same is said, such as "at 13"; "" where there is none.
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
        take: the agents to take: the best, and those that cannot be told from it.
        sentence: how far each agent gets, and which one gets furthest.
    """

    challenge: str
    isolates: str
    take: str
    sentence: str


def listed(texts: list[str]) -> str:
    """Texts as a list in a sentence."""
    return texts[0] if len(texts) == 1 else f"{', '.join(texts[:-1])} and {texts[-1]}"


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
    if broken.where == "between":
        near = float(f"{broken.strength:.2g}")  # interpolated: more digits would say too much
        words, place = rung_in_words(ladder, near), along(ladder, broken.strength)
        if by_steps:
            return Outcome(f"needs about {words}", f"need about {words}", f"about {written(near)}", place)
        return Outcome(f"breaks at {words}", f"break at {words}", f"at {written(near)}", place)
    n_rungs = len(ladder.strengths)
    if profile.rungs(agent, challenge)[-1].estimate >= NEARLY:
        even = f"it even with {last}" if by_steps else f"even {last}"
        return Outcome(f"masters {even}", f"master {even}", "", n_rungs + 1.0)
    even = f"even with {last}" if by_steps else f"even at {last}"
    return Outcome(f"does not break {even}", f"do not break {even}", "", float(n_rungs))


def along(ladder: Ladder, strength: float) -> float:
    """How far along the ladder a strength is: 0 on its first rung, 1 on the second."""
    places = dict(sorted(zip(ladder.strengths, range(len(ladder.strengths)), strict=True)))
    return float(np.interp(strength, [*places], [*places.values()]))


def said(profile: Profile, challenge: str, beside: Profile | None = None) -> Said:
    """What the report says about a challenge; an agent of another profile is named where it is surely better."""
    best = best_agents(profile, challenge)
    entered = any(profile.score(agent, challenge).n for agent in profile.agents)
    take = listed(best) if best else "nobody" if entered else "nobody can enter"
    if best and (score := profile.score(best[0], challenge).estimate) < HALF:
        take = f"nobody is good; the best score is {rounded(score)}, of {best[0]}"
    sentences = [
        f"{text}." for text in (*_standing(profile, challenge, best), _better(profile, challenge, beside)) if text
    ]
    return Said(challenge, profile.ladder(challenge).challenge, take, " ".join(sentences))


def _standing(profile: Profile, challenge: str, best: list[str]) -> list[str]:
    """How far each agent gets, the one that gets furthest first: sentences without their full stops."""
    outcomes = {agent: outcome(profile, agent, challenge) for agent in profile.agents}
    found: dict[Outcome, list[str]] = {}
    for agent, how in sorted(outcomes.items(), key=lambda pair: -pair[1].reached):
        found.setdefault(how, []).append(agent)
    (first, leaders), *_ = found.items()
    sentences = []
    if leaders == best and len(leaders) == 1 and sum(how.reached >= 0 for how in outcomes.values()) > 1:
        sentences.append(f"{leaders[0]} gets furthest: it {first.of_one}")
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
    """The agent with the highest score, and those whose difference from it may be chance; none where none enters.

    An agent that is not better than random play is none of them. One with fewer repetitions than others is one of them
    only if it is surely better: its interval lies above that of the best of the others.
    """
    scores = {agent: profile.score(agent, challenge) for agent in profile.agents}
    entered = {agent: score for agent, score in scores.items() if score.n and score.estimate > 0}
    if not entered:
        return []
    most = max(score.n for score in entered.values())
    often = [agent for agent, score in entered.items() if score.n == most]
    best = max(often, key=lambda agent: entered[agent].estimate)
    surely = [agent for agent in entered if agent not in often and entered[agent].low > entered[best].high]
    if surely:
        return sorted(surely, key=lambda agent: -entered[agent].estimate)
    runs = {agent: profile.scores(agent, challenge).mean(axis=0) for agent in often}
    return [best, *(a for a in often if a != best and paired_difference(runs[best], runs[a]).low <= 0)]


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
