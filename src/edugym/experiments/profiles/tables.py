"""The tables and the sentences of the report on a profile."""

import math
import re
from itertools import combinations

from edugym.experiments.profiles.ladders import EXACT, steps_of
from edugym.experiments.profiles.scores import HALF, NEARLY, Profile
from edugym.experiments.profiles.verdicts import best_agents, good_agents, listed, others_of, outcome, surely_worse
from edugym.experiments.profiles.words import WITHOUT_LADDER, rounded, written
from edugym.experiments.results.statistics import Interval

Table = tuple[list[str], list[list[str]]]
"""A heading, and rows."""
TAKE_HEADING = ("your problem has", "challenge", "highest score", "not surely worse", "how far the highest gets")
NAMED_BESIDE = 3
"""Of the agents that are not surely worse than the best, the report names so many besides those that were given."""
NO_MATTER = "none is good"
"""What stands in the place of those that are not surely worse than one that is not good itself."""
BEST = "*"
"""What marks the score of an agent that is best, or not surely worse."""
MOST_COMPARED = 5
"""Among more agents than these, the report does not compare each with each."""


def of_score(score: Interval) -> str:
    """A score with its interval, with two digits; a dash where there is none."""
    if score.n == 0:
        return "–"
    if not math.isfinite(score.low):
        return rounded(score.estimate)
    return f"{rounded(score.estimate)} [{rounded(score.low)},\N{NO-BREAK SPACE}{rounded(score.high)}]"


def absent(profile: Profile, agent: str, challenge: str) -> str:
    """What stands where an agent has no score: a dash where it cannot enter, a question mark where nobody measured."""
    return "–" if challenge in profile.blank.get(agent, {}) else "?"


def with_margin(score: Interval) -> str:
    """A score with the half of its interval, such as 0.37 ± 0.05, which no line break parts."""
    return f"{rounded(score.estimate)} ± {rounded(score.high - score.estimate)}".replace(" ", "\N{NO-BREAK SPACE}")


def take_table(profile: Profile, everybody: Profile | None = None) -> Table:
    """The table that says which agent to take, how far it gets, and where it is weak.

    Args:
        profile: the profile of those that were given.
        everybody: that in which the best are looked for, as `pooled` gives it; None for the same.
    """
    everybody = everybody or profile
    best = {challenge: best_agents(everybody, challenge) for challenge in profile.challenges}
    rows = []
    for challenge, (first, *others) in ((name, found or [""]) for name, found in best.items()):
        ladder = profile.ladder(challenge)
        entered = [agent for agent in everybody.agents if everybody.score(agent, challenge).n]
        row = [ladder.words.problem or ladder.challenge, challenge]
        if not first:
            nobody = f"nobody of {len(entered)} tried is better than random play" if entered else "nobody can enter"
            rows.append([*row, nobody, "–", "–"])
            continue
        score, far = everybody.score(first, challenge), outcome(everybody, first, challenge).of_one
        most = max(everybody.score(agent, challenge).n for agent in entered)
        highest = f"{first} {rounded(score.estimate)}{f' in {score.n} runs' if score.n < most else ''}"
        if score.estimate < HALF:
            nobody = f"nobody of {len(entered)} tried is good: no score is above {rounded(score.estimate)}"
            rows.append([*row, nobody, NO_MATTER, f"what helps: {helps}" if (helps := ladder.words.helps) else "–"])
            continue
        runs = {agent: everybody.score(agent, challenge).n for agent in others}
        shown = [
            f"{agent} ({runs[agent]} runs)" if runs[agent] < most else agent
            for k, agent in enumerate(others)
            if k < NAMED_BESIDE or len(others) == NAMED_BESIDE + 1 or agent in profile.agents
        ]
        more = [f"{len(others) - len(shown)} more"] if len(others) > len(shown) else []
        beside = listed([*shown, *more]) if others else "nobody"
        rows.append([*row, f"{highest} (of {len(entered)} tried)", beside, far + _weakest(everybody, first, best)])
    return [*TAKE_HEADING], rows


def _weakest(profile: Profile, agent: str, best: dict[str, list[str]]) -> str:
    """The challenge in which an agent lies furthest behind the best one, with its score there; "" if it never does."""
    behind = {
        challenge: profile.score(found[0], challenge).estimate - profile.score(agent, challenge).estimate
        for challenge, found in best.items()
        if found and profile.score(agent, challenge).n and agent not in found
    }
    if not behind:
        return ""
    weakest = max(behind, key=lambda challenge: behind[challenge])
    return f"; weakest in {weakest} ({rounded(profile.score(agent, weakest).estimate)})"


def score_table(profile: Profile, beside: Profile | None = None) -> Table:
    """The table of scores; the best agent of another profile stands beside them."""
    rows = []
    for challenge in profile.challenges:
        scores = [
            of_score(score) if (score := profile.score(agent, challenge)).n else absent(profile, agent, challenge)
            for agent in profile.agents
        ]
        others = others_of(profile, beside, challenge)
        best = max(others, key=lambda agent: others[agent]) if others else ""
        shown = "–" if not best else f"{best} {rounded(others[best])}" if others[best] >= HALF else NO_MATTER
        known = [shown] if beside else []
        rows.append([f"{challenge} ({profile.ladder(challenge).challenge})", *scores, *known])
    return ["challenge", *profile.agents, *(["best other agent"] if beside else [])], rows


def table_of_all(profile: Profile) -> Table:
    """The scores of all agents, without intervals; a star marks the best, as `good_agents` names them."""
    names = profile.challenges
    best = {name: good_agents(profile, name) for name in names}
    rows = []
    for agent in profile.agents:
        scores = {name: profile.score(agent, name) for name in names}
        texts = [
            f"{rounded(score.estimate)}{BEST if agent in best[name] else ''}"
            if score.n
            else absent(profile, agent, name)
            for name, score in scores.items()
        ]
        rows.append([agent, *texts])
    return ["agent", *names], rows


def rung_table(profile: Profile, challenge: str) -> Table:
    """The table of a ladder: a row for each rung, a column for each agent that entered; no rows where none did."""
    ladder = profile.ladder(challenge)
    agents = [agent for agent in profile.agents if profile.score(agent, challenge).n]
    if not agents:
        return [], []
    scores = [profile.rungs(agent, challenge) for agent in agents]
    rows = [
        [written(strength), *(rounded(rungs[k].estimate) for rungs in scores)]
        for k, strength in enumerate(ladder.strengths)
    ]
    steps = [profile.steps(agent, challenge) for agent in agents]
    first = f"steps until {NEARLY} on the first rung, median"
    rows.append([first, *(written(count) if math.isfinite(count) else "never" for count in steps)])
    breaks = [profile.breaks(agent, challenge) for agent in agents]
    where = [
        f"at {written(one.strength)}" if one and one.where == "between" else one.where if one else "?" for one in breaks
    ]
    rows.append([f"breaks (falls below {HALF}), interpolated", *where])
    return [ladder.strength, *agents], rows


def sure_differences(profile: Profile) -> list[str]:
    """Which agents are surely better than which others, as `surely_worse` says: sentences."""
    if not 2 <= len(profile.agents) <= MOST_COMPARED:
        return []
    sentences = []
    for one, other in combinations(profile.agents, 2):
        both = [name for name in profile.challenges if profile.score(one, name).n and profile.score(other, name).n]
        better = [name for name in both if surely_worse(profile, name, other, one)]
        worse = [name for name in both if surely_worse(profile, name, one, other)]
        found = [f"better than {other} in {listed(better)}"] if better else []
        if worse:
            found.append(f"worse {'' if better else f'than {other} '}in {listed(worse)}")
        if found:
            sentences.append(f"{one} is surely {', and surely '.join(found)}.")
    rest = "All other differences" if sentences else "All differences"
    return [*sentences, f"{rest} between these agents may be chance."]


def reasons(profile: Profile) -> list[str]:
    """Why agents cannot enter challenges, in sentences; reasons that differ only in their numbers share one."""
    who: dict[tuple[str, str], list[str]] = {}
    for agent, blank in profile.blank.items():
        for challenge, why in blank.items():
            who.setdefault((challenge, why), []).append(agent)
    alike: dict[tuple[str, str], dict[str, str]] = {}
    for (challenge, why), agents in who.items():
        alike.setdefault((listed(agents), re.sub(r"\d+", "0", why)), {})[challenge] = why
    sentences = []
    for (named, _), whys in alike.items():
        first, *_ = whys
        numbers = f" These are the numbers of {first}." if len(set(whys.values())) > 1 else ""
        sentences.append(f"{named} in {listed(list(whys))}: {whys[first]}.{numbers}")
    return sentences


def not_measured(profile: Profile, challenge: str) -> str:
    """Which agents nobody has measured in a challenge, as a sentence; "" where there are none."""
    agents = [
        agent
        for agent in profile.agents
        if not profile.score(agent, challenge).n and absent(profile, agent, challenge) == "?"
    ]
    return f"Not measured here: {listed(agents)}." if agents else ""


def repetitions_of(profile: Profile, agent: str) -> int:
    """How often an agent was trained on each rung."""
    return max((profile.score(agent, challenge).n for challenge in profile.challenges), default=0)


def method(profile: Profile) -> list[str]:
    """How everything was measured, a sentence for each thing."""
    counts = {agent: repetitions_of(profile, agent) for agent in profile.agents}
    repetitions = max(counts.values(), default=0)
    fewer = {agent: count for agent, count in counts.items() if 0 < count < repetitions}
    fewer_said = [f"Fewer times: {listed([f'{agent} {count}' for agent, count in fewer.items()])}."] if fewer else []
    bests = [
        f"The best play in {ladder.name} is {ladder.source}." for ladder in profile.ladders if ladder.source != EXACT
    ]
    named = ", ".join(
        f"{ladder.name} {written(steps_of(ladder, ladder.strengths[0]))}"
        for ladder in profile.ladders
        if ladder.n_steps is not None
    )
    few = [
        f"In {ladder.name} the rungs are numbers of training steps." for ladder in profile.ladders if not ladder.n_steps
    ]
    return [
        f"Every agent trained {repetitions} times on every rung of every ladder, each time with another seed and"
        " layout, and was then evaluated without exploring.",
        *fewer_said,
        "On a rung, 0 is the mean return of random play, 1 that of the best play; below 0 is worse than random play.",
        "The intervals are 95 % intervals over the repetitions. An agent is surely better than another if the interval"
        " of the difference, in pairs of runs with the same seeds and layouts, lies above 0; where one has fewer runs,"
        " if the intervals of their scores do not overlap.",
        profile.settings,
        " ".join([*([f"Training steps on each rung: {named}."] if named else []), *few]),
        f"The best play is {EXACT}, unless said otherwise. {' '.join(bests)}".strip(),
    ]


def without_ladder() -> str:
    """Which environments have no ladder, and why, in a sentence."""
    return f"Not in this report: {listed([f'{name} ({why})' for name, why in WITHOUT_LADDER.items()])}."
