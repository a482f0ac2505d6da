"""Stochasticity (lesson 8): risk-sensitive Q-learning in Golf, and where the long swing stops being worth its risk.

Risk-sensitive Q-learning with β = -2 (averse), 0 (Q-learning) and 2 (seeking) trains for 300 000 steps, about 100 000
games, with learning rate 0.02, ε = 0.1 and discount 1. The agent observes the cell of the ball and, where it says so,
the number of hits. 30 repetitions; the seeds are the same for every method. Then every greedy policy plays for 10 000
steps: mean and standard deviation (*spread*) of its returns and its share of lost balls.

The optimum is that of a player who sees exactly where the ball lies. It is computed by dynamic programming over the
remaining hits, on a grid of an eighth of a cell.

The surprises that β weighs are single TD errors, not returns. In Mihatsch and Neuneier (2002), κ has the opposite sign.
"""

from collections.abc import Mapping
from typing import Any

import numpy as np

from edugym.envs.golf import SWINGS
from edugym.experiments.figures.curves import Curves
from edugym.experiments.figures.lines import Lines
from edugym.experiments.figures.sheet import Sheet
from edugym.experiments.results.claims import Above, Below, Claim, Within
from edugym.experiments.results.statistics import exactly, mean_interval, paired_difference, share_interval
from edugym.experiments.results.tables import Results
from edugym_course.lessons.stochasticity.exact import crossing, from_the_tee, optimum
from edugym_course.lessons.stochasticity.figures import learning_curves, outcomes
from edugym_course.lessons.stochasticity.methods import (
    AVERSE,
    HARDLY,
    LEVEL,
    LEVELS,
    NEUTRAL,
    REPETITIONS,
    SEEKING,
    SHORT,
    TOO_NOISY,
    Played,
    compare_on_lake,
    late,
    learn,
    play,
    play_by_rules,
    share_learned,
    share_on_the_way,
)
from edugym_course.report import Report
from edugym_course.reporting import SharedArguments, reporting


def measure(how: SharedArguments) -> tuple[Any, ...]:
    """Run the experiments."""
    seen, noisy = learn(**how("hits_observed")), learn(level=TOO_NOISY, **how("level_0.02"))
    hidden = learn(observe_hits=False, **how("hits_hidden"))
    brief: dict[str, Any] = {"risks": {NEUTRAL: 0.0}, "n_steps": SHORT, "points": 30, "evaluation_episodes": 30}
    by_level = {level: learn(level=level, **brief, **how(f"speed_{level:g}")) for level in (0.0, LEVEL)}
    played = (play(seen), play(noisy, level=TOO_NOISY), play(hidden, observe_hits=False))
    return seen, noisy, by_level, *played


def judge(
    seen: Results,
    noisy: Results,
    by_level: Mapping[float, Results],
    played: Mapping[str, Played],
    played_noisy: Mapping[str, Played],
    played_hidden: Mapping[str, Played],
) -> Report:
    """Return claims and figures."""
    claims = [
        *exact_claims(),
        *speed_claims(by_level),
        *risk_claims(played),
        *noisy_claims(played_noisy),
        *hidden_claims(played_hidden),
    ]
    return Report(claims, figures(seen, noisy, by_level, played))


report = reporting(measure, judge, REPETITIONS)
"""Run the experiments of the lesson (see `edugym_course.reporting.Reporter`)."""


def exact_claims() -> list[Claim]:
    """Return the claims on the value of drive and chip, computed."""
    return [
        Claim(
            f"At level {LEVEL:g} the risk pays on average: driving from the tee is worth more than chipping",
            "drive less chip, computed",
            exactly(from_the_tee(LEVEL)["drive"] - from_the_tee(LEVEL)["chip"]),
            Within(0.06, 0.08),
        ),
        Claim(
            "Drive and chip are worth the same near level 0.0187",
            "level, computed",
            exactly(crossing()),
            Within(0.0185, 0.0189),
            "with more noise the lost balls cost the drive more than the hit that it saves",
        ),
    ]


def speed_claims(by_level: Mapping[float, Results]) -> list[Claim]:
    """Return the claims on how noise affects learning."""
    short_of = {level: optimum(level) - late(results) for level, results in by_level.items()}
    return [
        Claim(
            f"Noise keeps Q-learning from the optimum: it ends further below at level {LEVEL:g} than without noise",
            f"optimum less greedy return, level {LEVEL:g} less 0",
            paired_difference(short_of[LEVEL], short_of[0.0]),
            Above(0.02),
            "a likely reason: a few lost balls make the drive look bad, and it is then rarely tried",
        ),
        Claim(
            "Noise hardly slows Q-learning: it gets to its own final return as soon as without noise",
            f"share of the final return, averaged over {SHORT} steps, level {LEVEL:g} less 0",
            paired_difference(share_on_the_way(by_level[LEVEL]), share_on_the_way(by_level[0.0])),
            Within(-0.05, 0.05),
            "the paper says that noise slows learning",
        ),
        *(
            Claim(
                f"At level {level:g} Q-learning learns most of what it ever learns in the first 1000 steps",
                "share of the final return above random play, after 1000 steps",
                mean_interval(share_learned(results, 1_000)),
                Above(0.8),
            )
            for level, results in by_level.items()
        ),
    ]


def risk_claims(played: Mapping[str, Played]) -> list[Claim]:
    """Return the claims on aversion and seeking, where it can be seen."""
    averse, neutral, seeking = (played[label] for label in (AVERSE, NEUTRAL, SEEKING))
    return [
        Claim(
            "Most averse players lose hardly a ball",
            "share of runs that lose fewer than 1 ball in 500",
            share_interval(averse.lost < HARDLY),
            Above(0.5),
        ),
        Claim(
            "Neutral players lose more balls than averse ones on average",
            "share of lost balls, neutral less averse",
            paired_difference(neutral.lost, averse.lost),
            Above(0.0),
            f"{np.mean(neutral.lost < HARDLY):.0%} of the neutral runs hardly lose any either",
        ),
        Claim(
            "Seeking players lose more balls than neutral ones",
            "share of lost balls, seeking less neutral",
            paired_difference(seeking.lost, neutral.lost),
            Above(0.0),
        ),
        Claim(
            "Aversion narrows the spread of returns",
            "standard deviation of returns, averse less neutral",
            paired_difference(averse.spread, neutral.spread),
            Below(0.0),
        ),
        Claim(
            "Seeking widens the spread of returns",
            "standard deviation of returns, seeking less neutral",
            paired_difference(seeking.spread, neutral.spread),
            Above(0.0),
        ),
        Claim(
            "Averse players earn less than neutral ones",
            "mean return, averse less neutral",
            paired_difference(averse.mean, neutral.mean),
            Below(0.0),
            "each hit costs 0.1",
        ),
        Claim(
            "Averse players take more hits than neutral ones",
            "hits in a game that is won, averse less neutral",
            paired_difference(averse.hits, neutral.hits),
            Above(0.0),
        ),
        Claim(
            "Seeking neither gains nor costs 0.025 on average",
            "mean return, seeking less neutral",
            paired_difference(seeking.mean, neutral.mean),
            Within(-0.025, 0.025),
            "what seeking players save in hits they lose in balls",
        ),
        Claim(
            "Seeking players take fewer hits than neutral ones",
            "hits in a game that is won, seeking less neutral",
            paired_difference(seeking.hits, neutral.hits),
            Below(0.0),
        ),
    ]


def noisy_claims(played: Mapping[str, Played]) -> list[Claim]:
    """Return the claims on a level at which aversion does not show in lost balls."""
    averse, neutral, seeking = (played[label] for label in (AVERSE, NEUTRAL, SEEKING))
    return [
        Claim(
            f"At level {TOO_NOISY:g} most neutral players lose hardly a ball either",
            "share of runs that lose fewer than 1 ball in 500, neutral",
            share_interval(neutral.lost < HARDLY),
            Above(0.5),
            "beyond 0.0187 the safe swing is also the best one on average",
        ),
        Claim(
            f"At level {TOO_NOISY:g} the spread of most neutral runs is within 0.02 of that of the averse run",
            "share of runs",
            share_interval(abs(averse.spread - neutral.spread) < 0.02),
            Above(0.5),
        ),
        Claim(
            f"At level {TOO_NOISY:g} seeking players earn less than neutral ones",
            "mean return, seeking less neutral",
            paired_difference(seeking.mean, neutral.mean),
            Below(0.0),
        ),
    ]


def hidden_claims(played: Mapping[str, Played]) -> list[Claim]:
    """Return the claims on what seems to pay when hits are hidden."""
    neutral, seeking = played[NEUTRAL], played[SEEKING]
    return [
        Claim(
            "Where the agent does not see its hits, seeking risk seems to pay",
            "mean return, seeking less neutral, hits not observed",
            paired_difference(seeking.mean, neutral.mean),
            Above(0.0),
            "β = 2 makes up for another fault: many neutral runs avoid the drive, which is the best swing here",
        ),
        Claim(
            "Where the agent does not see its hits, seeking players lose more balls than neutral ones",
            "share of lost balls, seeking less neutral, hits not observed",
            paired_difference(seeking.lost, neutral.lost),
            Above(0.0),
        ),
    ]


def figures(
    seen: Results, noisy: Results, by_level: Mapping[float, Results], played: Mapping[str, Played]
) -> list[Sheet]:
    """Return the figures: the exact crossing, learning curves, and the returns of greedy play."""
    worth = {swing: np.array([from_the_tee(level)[swing] for level in LEVELS]) for swing in SWINGS}
    lines = Lines(np.array(LEVELS), worth, "first swing, then best play", "stochasticity level", "expected return")
    curves = [
        Curves(results, f"level {level:g}, hits observed", optimum=optimum(level), y_range=(0.4, 0.9))
        for results, level in ((seen, LEVEL), (noisy, TOO_NOISY))
    ]
    speed = [
        Curves(results, f"Q-learning, level {level:g}", optimum=optimum(level), y_range=(0.0, 1.0))
        for level, results in by_level.items()
    ]
    return [
        Sheet("crossing", [[lines]]),
        Sheet("stochasticity", [curves]),
        Sheet("speed", [speed]),
        outcomes(played)._replace(name="risk"),
    ]


def warm_up() -> None:
    """Compile what the lesson needs: a few steps of everything."""
    results = learn(n_steps=60, repetitions=2)
    learn(observe_hits=False, n_steps=60, repetitions=2)
    learning_curves(results).draw()
    play(results, n_steps=60)
    play_by_rules(n_steps=60)
    compare_on_lake(slippery=True, n_steps=60, repetitions=1)
