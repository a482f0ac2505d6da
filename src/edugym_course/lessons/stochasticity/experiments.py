"""Stochasticity (lesson 8): risk-sensitive Q-learning in Golf, and where the long swing stops being worth its risk.

Risk-sensitive Q-learning with β = -2 (averse), 0 (Q-learning) and 2 (seeking) trains for 300 000 steps, about 100 000
games, with learning rate 0.02, ε = 0.1 and discount 1. The agent observes the cell of the ball and, where it says so,
the number of hits. 90 repetitions, or 120 where the hits are hidden, since a few runs are far from the others, and 30
for the speed of learning; the seeds are the same for every method. Then every greedy policy plays for 10 000
steps: mean and standard deviation (*spread*) of its returns and its share of lost balls.

The optimum is that of a player who sees exactly where the ball lies. It is computed by dynamic programming over the
remaining hits, on a grid of an eighth of a cell.

The surprises that β weighs are single TD errors, not returns. In Mihatsch and Neuneier (2002), κ has the opposite sign.
"""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

import numpy as np

from edugym.envs.golf import SWINGS
from edugym.experiments.figures.curves import Curves
from edugym.experiments.figures.lines import Lines
from edugym.experiments.figures.sheet import Sheet
from edugym.experiments.results.claims import Above, Below, Claim, Within
from edugym.experiments.results.statistics import exactly, paired_difference, share_interval
from edugym.experiments.results.tables import Results
from edugym_course.lessons.stochasticity.drive import without_causes
from edugym_course.lessons.stochasticity.exact import crossing, from_the_tee, optimum
from edugym_course.lessons.stochasticity.figures import learning_curves, outcomes
from edugym_course.lessons.stochasticity.methods import (
    AVERSE,
    HARDLY,
    LEARNING_RATE,
    LEVEL,
    LEVELS,
    LONG,
    NEUTRAL,
    REPETITIONS,
    RISKS,
    SEEKING,
    SHORT,
    TOO_NOISY,
    Played,
    compare_on_lake,
    lead,
    learn,
    patient,
    play,
    play_by_rules,
    share_of_drivers,
)
from edugym_course.lessons.stochasticity.noise import (
    AT_LEVELS,
    CAUSES,
    EASIER,
    NEAR_THE_CROSSING,
    Causes,
    cause_claims,
    speed_claims,
)
from edugym_course.report import Report
from edugym_course.reporting import SharedArguments, reporting

SEEKS: Mapping[str, float] = MappingProxyType({SEEKING: RISKS[SEEKING]})
DEARER = "Where a hit costs twice as much (5 hits allowed), the drive is worth its risk up to a higher level"
CHEAPER = "Where a hit costs half as much (20 hits allowed), the drive is worth its risk up to a lower level only"
COSTS = f"At level {TOO_NOISY:g} seeking players earn less than neutral ones"


def measure(how: SharedArguments) -> tuple[Any, ...]:
    """Run the experiments."""
    several: dict[str, Any] = {"repetitions": 3 * how.repetitions}  # a few runs are far from the others
    seen = learn(**how("hits_observed", **several))
    noisy = learn(level=TOO_NOISY, **how("level_0.02", **several))
    hidden = learn(observe_hits=False, **how("hits_hidden", repetitions=4 * how.repetitions))
    brief: dict[str, Any] = {"risks": {NEUTRAL: 0.0}, "n_steps": SHORT, "points": 30, "evaluation_episodes": 30}
    by_level = {level: learn(level=level, **brief, **how(f"speed_{level:g}")) for level in AT_LEVELS}
    known = {(LEVEL, LEARNING_RATE): seen}  # with more points of the curves, but the same training
    causes = {
        (level, rate): without_causes(level, rate, as_it_is=known.get((level, rate)), **how(**several))
        for level, rate in (*CAUSES, NEAR_THE_CROSSING)
    }
    long = how(n_steps=LONG, repetitions=max(2, how.repetitions // 3))
    patience = {
        level: tuple(
            play(one, level=level) for one in (patient(level=level, **long), learn(risks=SEEKS, level=level, **long))
        )
        for level in (LEVEL, EASIER)
    }
    played = (play(seen), play(noisy, level=TOO_NOISY), play(hidden, observe_hits=False))
    return seen, noisy, by_level, causes, patience, *played


def judge(
    seen: Results,
    noisy: Results,
    by_level: Mapping[float, Results],
    causes: Causes,
    patience: Mapping[float, tuple[Mapping[str, Played], ...]],
    played: Mapping[str, Played],
    played_noisy: Mapping[str, Played],
    played_hidden: Mapping[str, Played],
) -> Report:
    """Return claims and figures."""
    claims = [
        *exact_claims(),
        *speed_claims(by_level),
        *cause_claims(causes),
        *risk_claims(played),
        *noisy_claims(played_noisy),
        *hidden_claims(played_hidden),
        *patience_claims({level: (one[NEUTRAL], other[SEEKING]) for level, (one, other) in patience.items()}),
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
            (DEARER, CHEAPER),
        ),
        Claim(
            DEARER,
            "level at which drive and chip are worth the same, computed",
            exactly(crossing(0.02, 0.025, max_hits=5)),
            Within(0.023, 0.0234),
        ),
        Claim(
            CHEAPER,
            "level at which drive and chip are worth the same, computed",
            exactly(crossing(0.015, 0.017, max_hits=20)),
            Within(0.0158, 0.0163),
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
            Above(0.002),
            remark=f"{np.mean(neutral.lost < HARDLY):.0%} of the neutral runs hardly lose any either",
        ),
        Claim(
            "Seeking players lose more balls than neutral ones",
            "share of lost balls, seeking less neutral",
            paired_difference(seeking.lost, neutral.lost),
            Above(0.01),
        ),
        Claim(
            "Aversion narrows the spread of returns",
            "standard deviation of returns, averse less neutral",
            paired_difference(averse.spread, neutral.spread),
            Below(-0.05),
        ),
        Claim(
            "Seeking widens the spread of returns",
            "standard deviation of returns, seeking less neutral",
            paired_difference(seeking.spread, neutral.spread),
            Above(0.08),
        ),
        Claim(
            "Averse players earn less than neutral ones",
            "mean return, averse less neutral",
            paired_difference(averse.mean, neutral.mean),
            Below(-0.01),
            remark=in_balance(averse, neutral),
        ),
        Claim(
            "Averse players take more hits than neutral ones",
            "hits in a game that is won, averse less neutral",
            paired_difference(averse.hits, neutral.hits),
            Above(0.2),
        ),
        Claim(
            "Seeking neither gains nor costs 0.025 on average",
            "mean return, seeking less neutral",
            paired_difference(seeking.mean, neutral.mean),
            Within(-0.025, 0.025),
            remark=in_balance(seeking, neutral),
        ),
        Claim(
            "Seeking players take fewer hits than neutral ones",
            "hits in a game that is won, seeking less neutral",
            paired_difference(seeking.hits, neutral.hits),
            Below(-0.2),
        ),
    ]


def in_balance(one: Played, other: Played) -> str:
    """Return what one player gains over another by fewer lost balls, and by fewer hits in the games that it wins."""
    lost = float(np.mean(other.lost))
    won = (float(np.mean(other.mean)) + lost) / (1 - lost)  # the mean return of the games that are won
    balls = (lost - float(np.mean(one.lost))) * (1 + won)
    hits = float(np.mean(one.mean) - np.mean(other.mean)) - balls
    return f"lost balls bring it {balls:+.2f}, and hits {hits:+.2f}"


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
            COSTS,
            "mean return, seeking less neutral",
            paired_difference(seeking.mean, neutral.mean),
            Below(-0.03),
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
            Above(0.005),
            "β = 2 makes up for another fault: many neutral runs avoid the drive, which is the best swing here",
            (COSTS, gains_nothing(LEVEL), gains_nothing(EASIER)),
        ),
        Claim(
            "Where the agent does not see its hits, seeking players lose more balls than neutral ones",
            "share of lost balls, seeking less neutral, hits not observed",
            paired_difference(seeking.lost, neutral.lost),
            Above(0.01),
        ),
    ]


def gains_nothing(level: float) -> str:
    """Return the statement that seeking gains nothing where the neutral player drives too."""
    return f"Seeking risk gains nothing over a neutral player who is patient, and so drives (level {level:g})"


def patience_claims(players: Mapping[float, tuple[Played, Played]]) -> list[Claim]:
    """Return the claims on a neutral player with good first values and small steps, and a seeking one, both for long.

    Args:
        players: by the level of the game, how the patient and the seeking one play.
    """
    return [
        Claim(
            gains_nothing(level),
            f"mean return after {LONG} steps, seeking less patient",
            lead(seeking, over=one),
            Within(-0.01, 0.01),
            remark=f"{share_of_drivers(one):.0%} of the patient runs take the risk of a drive",
        )
        for level, (one, seeking) in players.items()
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
        if level in (0.0, LEVEL)
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
