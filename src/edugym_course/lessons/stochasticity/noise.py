"""What noise does to learning: it delays the way to the optimum, and two causes keep runs from the drive."""

from collections.abc import Mapping

from edugym.experiments.results.claims import Above, Below, Claim, Within
from edugym.experiments.results.statistics import Interval, mean_interval, paired_difference
from edugym.experiments.results.tables import Results
from edugym.mdp.protocol import Reals
from edugym_course.lessons.stochasticity.drive import AS_IT_IS, NO_BAD_LUCK, REST_KNOWN, near_optimum, near_optimum_at
from edugym_course.lessons.stochasticity.exact import optimum
from edugym_course.lessons.stochasticity.methods import LEARNING_RATE, LEVEL, SHORT, TOO_NOISY, late, share_learned

AT_LEVELS = (0.0, 0.01, LEVEL, TOO_NOISY)
"""The levels at which the speed of learning is measured."""
SOON = 1_000
"""The steps after which most runs without noise are near the optimum."""
EASIER = 0.0125
"""A level at which the drive is ahead by more."""
CAUSES = ((LEVEL, LEARNING_RATE), (EASIER, LEARNING_RATE), (LEVEL, LEARNING_RATE / 2))
"""The levels and learning rates at which the rest of the game is what keeps runs from the drive."""
NEAR_THE_CROSSING = 0.0165, LEARNING_RATE
"""A level and a learning rate at which bad luck is enough."""
Causes = Mapping[tuple[float, float], Mapping[str, Reals]]


def keeps_from_the_drive(level: float, rate: float) -> str:
    """Return the statement that the rest of the game keeps runs from the drive."""
    return f"The rest of the game, learned from 0, keeps runs from the drive (level {level:g}, learning rate {rate:g})"


def luck_alone(level: float, rate: float) -> str:
    """Return the statement that bad luck alone does."""
    return f"Bad luck alone keeps most runs from the drive, closer to the crossing (level {level:g}, rate {rate:g})"


def speed_claims(by_level: Mapping[float, Results]) -> list[Claim]:
    """Return the claims on how noise affects learning."""
    quiet = by_level[0.0]
    short_of = {level: optimum(level) - late(results) for level, results in by_level.items()}
    causes = (*(keeps_from_the_drive(*setting) for setting in CAUSES), luck_alone(*NEAR_THE_CROSSING))
    return [
        Claim(
            f"Noise keeps Q-learning from the optimum: after {SHORT} steps it is further below at level {LEVEL:g} than"
            " without noise",
            f"optimum less greedy return, level {LEVEL:g} less 0",
            paired_difference(short_of[LEVEL], short_of[0.0]),
            Above(0.02),
            "noise leads to many cells, whose values start at 0 and are learned rarely; and a few lost balls make the"
            " drive look bad",
            causes,
        ),
        *(
            Claim(
                f"Noise slows Q-learning: at level {level:g}, after {SHORT} steps, fewer runs are within 0.01 of the"
                f" optimum than without noise after {SOON}",
                f"share of runs, level {level:g} after {SHORT} steps less level 0 after {SOON}",
                paired_difference(near_optimum(by_level[level], level), near_optimum_at(quiet, 0.0, SOON)),
                Below(-0.25),
                remark="the paper says so too",
            )
            for level in AT_LEVELS[1:]
        ),
        *(
            Claim(
                f"At level {level:g} the first {SOON} steps bring Q-learning most of the way to the optimum",
                "how far it has come from random play (0) to the optimum (1)",
                mean_interval(share_learned(results, SOON, optimum(level))),
                Above(0.7),
                remark="so what noise delays is the rest of the way",
            )
            for level, results in by_level.items()
            if level in (0.0, LEVEL)
        ),
    ]


def cause_claims(causes: Causes) -> list[Claim]:
    """Return the claims on what keeps runs from the drive, each with one cause taken away."""

    def more(setting: tuple[float, float], without: str) -> Interval:
        return paired_difference(causes[setting][without], causes[setting][AS_IT_IS])

    return [
        *(
            Claim(
                keeps_from_the_drive(*setting),
                "share of runs that start with a drive, with the rest played by a rule less as it is",
                more(setting, REST_KNOWN),
                Above(0.05),
                remark="all that is left of the noise then is bad luck with the first swing",
            )
            for setting in CAUSES
        ),
        *(
            Claim(
                f"Less bad luck alone changes little (level {level:g}, learning rate {rate:g})",
                "share of runs that start with a drive, with steps a quarter as large less as it is",
                more((level, rate), NO_BAD_LUCK),
                Within(-0.3, 0.3),
            )
            for level, rate in CAUSES
        ),
        Claim(
            luck_alone(*NEAR_THE_CROSSING),
            "share of runs that start with a drive, with the rest played by a rule",
            mean_interval(causes[NEAR_THE_CROSSING][REST_KNOWN]),
            Below(0.5),
            "there the drive is ahead by 0.05 only, about as much as one lost ball takes away (0.04)",
        ),
    ]
