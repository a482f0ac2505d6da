"""Search at decision time (lesson 18): what more simulations, more actions and a deeper look are worth.

UCT searches before each step in the exact model of Supermarket (1000 simulations of at most 20 steps, c = 10, discount
0.95; episodes of at most 100 steps; the best return is 95). Plain roll-outs are the same without a tree. Beside these
settings there are a discount of 0.9, and simulations of 30 steps. Returns are those of single episodes, 100 for each
number. More actions stand still, also in the tree or in the roll-outs alone, or repeat the four directions.

The worth of looking some steps ahead is computed exactly, in the right model and in wrong ones: an old map of the shop,
which shows a door where there is a wall; soccer against an opponent who does not play as one thinks; and rewards with
errors, drawn 100 times. What holds UCT back is tried by telling it, in place of roll-outs, what new nodes are
worth, exactly, and with c = 1. In soccer UCT (c = 1) knows the opponent; 400 games. Q-learning (learning rate 1,
ε = 0.1) takes as many steps as UCT simulates before one step.
"""

from collections.abc import Mapping
from itertools import product
from types import MappingProxyType
from typing import Any

import numpy as np

from edugym.experiments.results.claims import Above, Below, Claim, Within
from edugym.experiments.results.statistics import exactly, mean_interval, paired_difference
from edugym.mdp.protocol import Reals
from edugym_course.lessons.search.figures import COPIES, IDLE, ROLL_OUTS, TREE, over_branches, over_depth
from edugym_course.lessons.search.figures import over_simulations as simulations_figure
from edugym_course.lessons.search.methods import (
    BRANCHES,
    DEPTH,
    DISCOUNT,
    DOOR,
    LEARNING_STEPS,
    NUMBERS,
    REPETITIONS,
    C,
    idle_only_in,
    in_crowd,
    learned,
    searched,
    told,
)
from edugym_course.lessons.search.plans import (
    DEPTHS,
    SOCCER_DEPTHS,
    in_soccer,
    in_the_shop,
    mending,
    random_play,
    simulated_in_soccer,
    with_errors,
)
from edugym_course.report import Report
from edugym_course.reporting import SharedArguments, reporting

Settings = Mapping[str, Any]
LESSON = "with the settings of the lesson"
SETTINGS: Mapping[str, Settings] = MappingProxyType(
    {LESSON: {}, "with a discount of 0.9": {"discount": 0.9}, "with simulations of 30 steps": {"depth": 30}}
)
SHORT: Mapping[str, dict[str, Any]] = MappingProxyType(
    {
        LESSON: {"depth": 10, "discount": DISCOUNT},
        "with a discount of 0.9": {"depth": 10, "discount": 0.9},
        "with simulations of 30 steps": {"depth": 8, "discount": DISCOUNT},
    }
)
"""Roll-outs, beside those of each setting, that are so short that the values of random play are better guides."""
CASES = (30, 300, 1_000, 3_000)
MAPS: Mapping[str, dict[str, Any]] = MappingProxyType(
    {
        "of the lesson": {"door": DOOR, "discount": DISCOUNT},
        "with another door": {"door": (6, 3), "discount": DISCOUNT},
        "with a discount of 0.9": {"door": DOOR, "discount": 0.9},
    }
)
USELESS = (7, 6)
"""A wall beside which a door would be no way to anything."""
CONTACTS = (1.0, 0.75, 0.5)
SMALL_C = 1.0
"""With it what is seldom tried counts little."""
PLACES = ("tree", "roll-outs")
"""The one place in which there are actions that stand still."""
SOCCER_NUMBERS = (5, 300)
"""Numbers of simulations before each step of soccer."""
SHALLOW, DEEP = 8, 20
SOCCER_SHALLOW, SOCCER_DEEP = 3, 8


def measure(how: SharedArguments) -> tuple[Any, ...]:
    """Run the experiments."""
    shared = {name: how.shared[name] for name in ("repetitions", "seed", "stop")}
    figure = {
        TREE: {n: searched(simulations=n, **shared) for n in NUMBERS},
        ROLL_OUTS: {n: searched(simulations=n, nodes=1, **shared) for n in NUMBERS},
    }
    short = {
        name: {n: searched(simulations=n, nodes=1, **settings, **shared) for n in CASES[1::2]}
        for name, settings in SHORT.items()
    }
    simulated = {
        name: figure
        if not settings
        else {
            TREE: {n: searched(simulations=n, **settings, **shared) for n in CASES[:3]},
            ROLL_OUTS: {n: searched(simulations=n, nodes=1, **settings, **shared) for n in CASES},
        }
        for name, settings in SETTINGS.items()
    }
    branching = {
        name: {
            label: {n: in_crowd(n, copies=label == COPIES, **settings, **shared) for n in BRANCHES[not_all:]}
            for label in (IDLE, COPIES)
        }
        | {where: {16: idle_only_in(where, **settings, **shared)} for where in PLACES}
        for name, settings in SETTINGS.items()
        for not_all in (0 if name == LESSON else 2,)
    }
    on_maps = {door: searched(door=door, **shared) for door in (None, DOOR, (6, 3))}
    errors = [with_errors(number, (SHALLOW, DEEP)) for number in range(1, 1 + how.repetitions)]
    held_back = {"roll-outs": searched(c=SMALL_C, **shared)}
    for play, c in product(("at random", "well"), (C, SMALL_C)):
        held_back[f"{play}, c = {c:g}"] = told(play, c=c, **shared)
    held_back["old map"] = told("well", door=DOOR, **shared)
    numbers = range(1, 1 + how.repetitions)
    held_back["no step pays"] = np.array([with_errors(number, (SHALLOW,), steps_pay=False)[0] for number in numbers])
    more = {**shared, "repetitions": 4 * how.repetitions}
    played = {contact: {n: simulated_in_soccer(n, contact, **more) for n in SOCCER_NUMBERS} for contact in CONTACTS}
    return simulated, short, branching, on_maps, np.array(errors), learned(**shared), held_back, played


def judge(
    simulated: Mapping[str, Mapping[str, Mapping[int, Reals]]],
    short: Mapping[str, Mapping[int, Reals]],
    branching: Mapping[str, Mapping[str, Mapping[int, Reals]]],
    on_maps: Mapping[tuple[int, int] | None, Reals],
    errors: Reals,
    learners: Reals,
    held_back: Mapping[str, Reals],
    played: Mapping[float, Mapping[int, Reals]],
) -> Report:
    """Return claims and figures."""
    claims = [claim for name, found in simulated.items() for claim in simulation_claims(name, found)]
    claims += [claim for name, found in short.items() for claim in short_claims(name, found)]
    for name, crowds in branching.items():
        claims += branching_claims(name, crowds, simulated[name][TREE][1_000])
    claims += [claim for name, case in MAPS.items() for claim in map_claims(name, **case)]
    claims += [claim for contact in CONTACTS for claim in soccer_claims(contact)]
    claims += [error_claim(errors), *searching_claims(on_maps), learning_claim(learners, on_maps[None])]
    claims += held_back_claims(held_back)
    claims += [claim for contact, games in played.items() for claim in played_claims(contact, games)]
    figure = {label: [*found.values()] for label, found in simulated[LESSON].items()}
    branches = {label: [*branching[LESSON][label].values()] for label in (IDLE, COPIES)}
    return Report(claims, [simulations_figure(figure), over_branches(branches), over_depth()])


report = reporting(measure, judge, REPETITIONS)
"""Run the experiments of the lesson (see `edugym_course.reporting.Reporter`)."""


def warm_up() -> None:
    """Compile the search, in the shop and where there are more actions."""
    searched(simulations=30, repetitions=1)
    in_crowd(8, simulations=30, repetitions=1)


def held_back_claims(got: Mapping[str, Reals]) -> list[Claim]:
    """Return the claims on what holds UCT back: by what judges a new node, and by c."""
    random, well = "what random play is worth from there on", "what good play is worth from there on"
    expected: Mapping[str, tuple[str, Any]] = {
        "roll-outs": (f"UCT with c = {SMALL_C:g} stays below 85", Below(85)),
        f"at random, c = {C:g}": (f"UCT that is told {random} stays below 65", Below(65)),
        f"at random, c = {SMALL_C:g}": (f"UCT that is told {random}, with c = {SMALL_C:g}, does, too", Below(65)),
        f"well, c = {C:g}": (f"UCT that is told {well} stays below 85", Below(85)),
        f"well, c = {SMALL_C:g}": (f"UCT that is told {well}, with c = {SMALL_C:g}, comes to 90 or more", Above(90)),
        "old map": (f"UCT that is told {well} by the old map gets less than -40", Below(-40)),
        "no step pays": ("In a model with errors, if no step seems to pay, 8 steps get 35 or more", Above(35)),
    }
    return [
        Claim(statement, "return", mean_interval(got[name]), threshold)
        for name, (statement, threshold) in expected.items()
    ]


def short_helps(name: str) -> str:
    """Return the claim on roll-outs that are short."""
    return f"In roll-outs of {SHORT[name]['depth']} steps, else {name}, 3000 simulations are worth more than 300"


def simulation_claims(name: str, found: Mapping[str, Mapping[int, Reals]]) -> list[Claim]:
    """Return the claims on the number of simulations."""
    tree, plain = found[TREE], found[ROLL_OUTS]
    return [
        Claim(
            f"UCT with 1000 simulations, {name}, gets more than with 30",
            "return, less that with 30 simulations",
            paired_difference(tree[1_000], tree[30]),
            Above(20),
        ),
        Claim(
            f"Plain roll-outs with 3000 simulations, {name}, get less than with 300",
            "return, less that with 300 simulations",
            paired_difference(plain[3_000], plain[300]),
            Below(0),
            "with more of them the values come to those of random play",
            (short_helps(name),),
        ),
        Claim(
            f"With 1000 simulations, {name}, UCT gets more than plain roll-outs",
            "return, less that of plain roll-outs",
            paired_difference(tree[1_000], plain[1_000]),
            Above(3),
        ),
    ]


def short_claims(name: str, short: Mapping[int, Reals]) -> list[Claim]:
    """Return the claims on short roll-outs, for which the values of random play are better guides."""
    settings = {"depth": DEPTH, **SETTINGS[name]}
    usual = random_play(settings["depth"], settings.get("discount", DISCOUNT))
    return [
        Claim(
            short_helps(name),
            "return, less that with 300 simulations",
            paired_difference(short[3_000], short[300]),
            Above(1),
        ),
        Claim(
            f"The best action by the values of random play is worth more for {SHORT[name]['depth']} steps than for"
            f" {settings['depth']}, {name}",
            f"expected return, less that for {settings['depth']} steps, exactly",
            exactly(random_play(**SHORT[name]) - usual),
            Above(15),
        ),
    ]


def repeated(name: str) -> str:
    """Return the claim on actions that repeat the four directions."""
    return f"Where twelve more actions repeat the four, {name}, UCT gets far more than where they stand still"


def only_in(where: str, name: str) -> str:
    """Return the claim on actions that stand still in one place only."""
    return f"With twelve that stand still only in its {where}, {name}, UCT gets more"


def branching_claims(name: str, crowds: Mapping[str, Mapping[int, Reals]], alone: Reals) -> list[Claim]:
    """Return the claims on the number of actions."""
    idle, copies = crowds[IDLE][16], crowds[COPIES][16]
    return [
        Claim(
            f"With twelve more actions that stand still, {name}, UCT gets less",
            "return, less that with four actions",
            paired_difference(idle, alone),
            Below(-40),
            "they stand still both in its tree and in its roll-outs",
            tuple(only_in(where, name) for where in PLACES),
        ),
        *(
            Claim(
                only_in(where, name),
                "return, less that with twelve such actions in both",
                paired_difference(crowds[where][16], idle),
                Above(25),
            )
            for where in PLACES
        ),
        Claim(
            repeated(name),
            "return, less that where they stand still",
            paired_difference(copies, idle),
            Above(30),
        ),
        Claim(
            f"With twelve more actions that repeat the four, {name}, UCT gets less than with the four",
            "return, less that with four actions",
            paired_difference(copies, alone),
            Below(-2),
            remark="the same 1000 simulations go to four times as many actions of each node",
        ),
    ]


def right_map(name: str) -> str:
    """Return the claim on the right map."""
    return f"On the right map, beside the old one {name}, a deeper look is never worth less"


def mended_map(name: str) -> str:
    """Return the claim on an old map that is mended."""
    return f"On the old map {name}, 20 steps are worth more than 8 if one's own steps mend the map"


def useless_door(name: str) -> str:
    """Return the claim on a door that nobody would use."""
    return f"On a map with a door that leads nowhere, beside the one {name}, 20 steps are worth more than 8"


def never_less(name: str, returns: Reals) -> Claim:
    """Return the claim that a deeper look is never worth less."""
    gain = exactly(float(np.diff(returns).min()))
    return Claim(name, "smallest gain from one depth to the next, exactly", gain, Above(-1e-6))


def map_claims(name: str, door: tuple[int, int], discount: float) -> list[Claim]:
    """Return the claims on looking ahead on maps of the shop, exactly."""
    at = [SHALLOW, DEEP]
    right, old = (in_the_shop(where, discount=discount) for where in (None, door))
    shallow, deep = old[[DEPTHS.index(depth) for depth in at]]
    useless = in_the_shop(USELESS, at, discount)
    more = "expected return with 20 steps, less that with 8, exactly"
    return [
        Claim(
            f"On the old map {name}, 20 steps of look-ahead are worth less than 8",
            more,
            exactly(deep - shallow),
            Below(-50),
            "the longer look gets to a door that is not there",
            (right_map(name), mended_map(name), useless_door(name)),
        ),
        never_less(right_map(name), right),
        Claim(mended_map(name), more, exactly(mending(DEEP, door, discount) - shallow), Above(10)),
        Claim(useless_door(name), more, exactly(useless[1] - useless[0]), Above(10)),
    ]


def soccer_claims(contact: float) -> list[Claim]:
    """Return the claims on looking ahead against an opponent who is another one than one thinks, exactly."""
    knows, thinks = in_soccer(True, contact), in_soccer(False, contact)
    shallow, deep = thinks[[SOCCER_DEPTHS.index(depth) for depth in (SOCCER_SHALLOW, SOCCER_DEEP)]]
    known = f"In soccer with contact {contact:g}, for who knows the opponent a deeper look is never worth less"
    return [
        Claim(
            f"In soccer with contact {contact:g}, against another opponent than one thinks, 8 steps are worth less"
            " than 3",
            "expected return with 8 steps, less that with 3, exactly",
            exactly(deep - shallow),
            Below(-0.2),
            "the model has the wrong opponent",
            (known,),
        ),
        never_less(known, knows),
    ]


def played_claims(contact: float, games: Mapping[int, Reals]) -> list[Claim]:
    """Return the claims on UCT in soccer."""
    few, many = games.values()
    best = float(in_soccer(True, contact)[-1])
    return [
        Claim(
            f"In soccer with contact {contact:g}, UCT wins more with 300 simulations than with 5",
            "return of a game, less that with 5",
            paired_difference(many, few),
            Above(0.1),
        ),
        Claim(
            f"In soccer with contact {contact:g}, UCT with 300 simulations gets as much as the exact look-ahead",
            f"return of a game, less {best:.2f}, what 20 steps of look-ahead are worth exactly",
            mean_interval(many - best),
            Within(-0.2, 0.2),
        ),
    ]


def error_claim(errors: Reals) -> Claim:
    """Return the claim on rewards with errors."""
    return Claim(
        "In a model whose rewards have errors with a standard deviation of 1, 20 steps are worth more than 8",
        "expected return with 20 steps, less that with 8",
        paired_difference(errors[:, 1], errors[:, 0]),
        Above(30),
        remark="so not every wrong model makes a deeper look worse",
    )


def searching_claims(on_maps: Mapping[tuple[int, int] | None, Reals]) -> list[Claim]:
    """Return the claims on UCT on old maps."""
    return [
        Claim(
            f"UCT gets less on an old map with a door at {door} than on the right one",
            "return, less that on the right map",
            paired_difference(found, on_maps[None]),
            Below(-5),
        )
        for door, found in on_maps.items()
        if door
    ]


def learning_claim(learners: Reals, searches: Reals) -> Claim:
    """Return the claim on Q-learning with as many steps as UCT simulates before a single one."""
    return Claim(
        f"Q-learning after {LEARNING_STEPS} steps gets more than UCT, which simulates as many before each step",
        "return, less that of UCT",
        paired_difference(learners, searches),
        Above(3),
    )
