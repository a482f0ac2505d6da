"""Profiles (lesson 15): which ladders agents climb, and what of it follows from their equations.

All agents have their defaults, but for what their names say: Q-learning has learning rate 0.1, discount 0.99 and ε =
0.1; R-max knows a pair after one try, or after 10, and its U is 100, or 8000. The ladders are those of
`edugym.profile`: 20 000 steps on each rung of Boulder and Study, 30 000 in Golf and 50 000 in Tamagotchi. 20
repetitions; the seeds and layouts are the same for every agent.
"""

from collections.abc import Sequence
from typing import Any

from edugym.experiments.profiles.ladders import Ladder
from edugym.experiments.profiles.scores import Profile
from edugym.experiments.results.claims import Above, Below, Claim, Within
from edugym.system.files import write_whole
from edugym_course.lessons.profiles import figures
from edugym_course.lessons.profiles.methods import (
    CERTAIN_MESSAGES,
    HOLE,
    Q_LEARNING,
    R_MAX,
    R_MAX_10,
    R_MAX_8000,
    R_MAX_BOTH,
    SHORT_SIGHTED,
    SLOW,
    climb,
    gap,
    on_first_rung,
)
from edugym_course.report import Report
from edugym_course.reporting import SharedArguments, reporting

OF_PROFILES = ("repetitions", "seed", "jobs", "progress", "checkpoints")
NO_CHANCE = "Where no hit misses its aim R-max masters Golf"
BOTH = "With ten tries and U = 8000 R-max masters the first rung of Tamagotchi"
MORE_TRIES = "With ten tries before a pair is known R-max gains in Golf"


def measure(how: SharedArguments) -> tuple[Any, ...]:
    """Make the profiles; none begins after the experiments were stopped."""
    return (
        _climb(how, "r_max", (Q_LEARNING, R_MAX, R_MAX_10), ("Boulder", "Study", "Golf")),
        _climb(how, "tamagotchi", (R_MAX, R_MAX_10, R_MAX_8000, R_MAX_BOTH), (CERTAIN_MESSAGES,), times=3),
        _climb(how, "holes", (Q_LEARNING, SLOW, SHORT_SIGHTED), ("Study", "Tamagotchi")),
    )


def _climb(
    how: SharedArguments, name: str, agents: Sequence[str], challenges: Sequence[str | Ladder], times: int = 1
) -> Profile | None:
    """Climb ladders, with so many times the repetitions of the lesson."""
    if how.shared["stop"].is_set():
        return None
    settings = {key: how.shared[key] for key in OF_PROFILES}
    settings["repetitions"] *= times
    found = climb(agents, challenges, **settings)
    if how.folder is not None:
        write_whole(how.folder / f"{name}.csv", found.runs.to_csv(index=False, lineterminator="\n").encode())
    return found


def judge(by_model: Profile, certain: Profile, holes: Profile) -> Report:
    """Return claims and figures."""
    return Report(
        [*model_claims(by_model), *tamagotchi_claims(certain), *hole_claims(holes)],
        [figures.ladders(by_model, "r_max"), figures.ladders(holes, "holes")],
    )


report = reporting(measure, judge, repetitions=20)
"""Run the experiments of the lesson (see `edugym_course.reporting.Reporter`)."""


def model_claims(found: Profile) -> list[Claim]:
    """Return the claims on R-max: what its equation says is seen in its profile."""
    return [
        *(
            Claim(f"R-max masters {name}", "score over the ladder", found.score(R_MAX, name), Above(0.9))
            for name in ("Boulder", "Study")
        ),
        Claim(
            "In Golf R-max is worse than Q-learning",
            "score, less that of Q-learning",
            gap(found, R_MAX, Q_LEARNING, "Golf"),
            Below(0.0),
            "one try shows one of many things that may happen, and R-max takes it for the only one",
            (NO_CHANCE, MORE_TRIES),
        ),
        Claim(NO_CHANCE, "score on the first rung", on_first_rung(found, R_MAX, "Golf"), Above(0.9)),
        Claim(MORE_TRIES, "score, less that with one try", gap(found, R_MAX_10, R_MAX, "Golf"), Above(0.0)),
    ]


def tamagotchi_claims(found: Profile) -> list[Claim]:
    """Return the claims on R-max where the messages have no noise: what keeps it down there."""
    quantity = "score on the first rung"
    return [
        Claim(
            "Where messages have no noise R-max scores hardly above 0 in Tamagotchi",
            quantity,
            on_first_rung(found, R_MAX, "Tamagotchi"),
            Below(0.1),
            "one try shows one of many outcomes, since the state is hidden, and U is below the best return",
            (BOTH,),
        ),
        Claim(
            "Ten tries alone help it little there",
            quantity,
            on_first_rung(found, R_MAX_10, "Tamagotchi"),
            Within(0.1, 0.4),
        ),
        Claim(
            "U = 8000 alone does not let it master the rung",
            quantity,
            on_first_rung(found, R_MAX_8000, "Tamagotchi"),
            Below(0.6),
        ),
        Claim(BOTH, quantity, on_first_rung(found, R_MAX_BOTH, "Tamagotchi"), Above(0.9)),
    ]


def hole_claims(found: Profile) -> list[Claim]:
    """Return the claims on Q-learning with one other setting: whether its profile has a hole."""
    quantity = "score, less that with the defaults"
    return [
        Claim(
            "In Study Q-learning with a learning rate of nearly 0 is as good as with 0.1",
            quantity,
            gap(found, SLOW, Q_LEARNING, "Study"),
            Within(-0.1, 0.1),
        ),
        Claim(
            "In Tamagotchi it is much worse",
            quantity,
            gap(found, SLOW, Q_LEARNING, "Tamagotchi"),
            Below(-0.3),
        ),
        Claim(
            "In Study Q-learning that does not look ahead has a hole",
            quantity,
            gap(found, SHORT_SIGHTED, Q_LEARNING, "Study"),
            Below(-HOLE),
        ),
        Claim(
            "In Tamagotchi it is as good as with the defaults",
            quantity,
            gap(found, SHORT_SIGHTED, Q_LEARNING, "Tamagotchi"),
            Within(-0.15, 0.15),
        ),
    ]


def warm_up() -> None:
    """Compile what the cells of the lesson need."""
    for agents, challenges in (((Q_LEARNING, R_MAX), ("Boulder", "Study", "Golf")), ((Q_LEARNING,), ("Tamagotchi",))):
        climb(agents, challenges, repetitions=1, jobs=1)
