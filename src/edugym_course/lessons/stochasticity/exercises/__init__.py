"""The exercises of lesson 8: where a risk stops being worth it, players worth choosing, an agent with two weights."""

import math
from collections.abc import Callable, Mapping
from functools import partial
from types import MappingProxyType
from typing import Annotated, Any

import numpy as np

from edugym_course.grading.agents import agent_with_table, require_class, require_function
from edugym_course.grading.cases import DISCOUNTS, LEARNING_RATES
from edugym_course.grading.challenge import Challenge
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.one_step import Q_LEARNING, numbers_of, one_step_update
from edugym_course.grading.own_numbers import Own, step_cost
from edugym_course.grading.student_code import student_code
from edugym_course.grading.updates import Tables, Transition, Update
from edugym_course.grading.values import compare, digits, given, number
from edugym_course.lessons.stochasticity.exact import CROSSINGS, crossing, from_the_tee
from edugym_course.lessons.stochasticity.exercises.frontier import (
    FRONTIER_MISTAKES,
    Pair,
    beats,
    made_up_players,
    unbeaten,
)
from edugym_course.lessons.stochasticity.methods import LEVEL, methods_with

HITS = 5
OPTIMUM = 0.868
"""The best expected return at the lesson's level, computed for a player who sees the ball."""


Careless = Annotated[
    float,
    Own(
        tuple(CROSSINGS),
        "Your player is careless: in your version each swing after the first is a random one with probability"
        " {careless}. That is the argument `epsilon={careless}` of `exact.from_the_tee`. The level is between 0.02 and"
        " 0.05.",
    ),
]


def exercise_1(answer: Any, seed: int, careless: Careless = 0.0) -> str:
    """Check the level at which drive and chip are worth the same, with 5 hits and random swings now and then."""
    expected = CROSSINGS[careless] if careless else crossing(0.02, 0.025, max_hits=HITS)

    def says(level: float) -> str:
        told = f"level = {digits(level, expected)}"
        if not 0 < level <= 1:
            return f"{told} is not a level, a number above 0 and far below 1"
        worth = from_the_tee(level, max_hits=HITS, epsilon=careless)
        return f"at {told} the drive is worth {worth['drive']:.4f} and the chip {worth['chip']:.4f}"

    found = number("level", answer)
    near = abs(found - expected) < 0.001
    why = ", as the drive is worth more there" if found > 0 else ""
    side = f"too low{why}" if found < expected else "too high"
    compare(
        "level",
        answer,
        expected,
        {"that is the value with which the cell began": 0.0187}
        if careless
        else {
            "that is the value with which the cell began": 0.0187,
            "that is the crossing with 10 hits; give `max_hits=5` to from_the_tee": crossing(),
            "that is the lesson's own level; look for the one at which drive and chip are worth the same": LEVEL,
            "that is the estimate by hand, which takes for granted that both plans do what they should": 0.0220,
            "that is an estimate with a cost of 1.6 for a lost ball; the fast plan returns 0.8 now, so it"
            " costs 1.8": 0.0228,
            "that is an estimate with the lesson's cost of 1.9 for a lost ball; the fast plan returns 0.8 now, so it"
            " costs 1.8": 0.0216,
            "that is an estimate with the water on one side only, and it is on both: p / 2 is for each of them": 0.0287,
            "that is the probability p of a lost ball; the level is what gives this probability": 0.2 / 1.8,
            "that is the number of standard deviations, and 3.5 / (100 level) is what it is": 1.593,
            "that is the crossing with places a quarter of a cell apart (`cell=0.25`), which is too coarse here: leave"
            " `cell` out": crossing(0.02, 0.025, cell=0.25, max_hits=HITS),
            "that is the standard deviation of a drive, 100 times the level": 100 * expected,
            "the sign is wrong": -expected,
        },
        tolerance=0.00006,
        says=says,
        otherwise=f"it is {side}" + ("; you are close, look in steps of 0.0001" if near else ""),
    )
    if careless:
        return (
            f"Right: near {expected:.4f}. A player who may waste the next hits takes more risk than one who does not."
        )
    return (
        "Right: near 0.0232. By hand: 1.8 p = 0.2, so p = 0.111, which is 1.59 standard deviations on each side: "
        "0.0220. The more a hit costs, the more risk is worth taking."
    )


Least = Annotated[
    float,
    Own(
        tuple(k / 200 for k in range(80, 121)),
        "Your club is strict: in your version a player whose mean return is below {least} may not play, and is not on"
        " the frontier.",
    ),
]


def exercise_2(answer: Any, seed: int, least: Least = -math.inf) -> str:
    """Check the function that finds the players that no other one beats, and whose mean is not too low."""
    require_function("frontier", answer, "the players")
    cases = made_up_players(seed)
    if math.isfinite(least):
        means = [round(least + steps / 400, 4) for steps in (-1, 1, 6)]  # just too low, just high enough, and high
        cases.append({name: (mean, 0.01 * k) for k, (name, mean) in enumerate(zip("ABC", means, strict=True), start=1)})
    found = [_names(answer, players) for players in cases]
    for players, names in zip(cases, found, strict=True):
        allowed = {name for name, (mean, _) in players.items() if mean >= least}
        right = unbeaten(players, beats) & allowed
        if names == right:
            continue
        if names - allowed:
            name = min(names - allowed)
            raise WrongAnswer(f"{_told(players, names, right)}: the mean of {name} is below {least:g}")
        for sentence, mistake in FRONTIER_MISTAKES.items():
            if not math.isfinite(least) and all(mistake(each) == mine for each, mine in zip(cases, found, strict=True)):
                raise WrongAnswer(f"{_told(players, names, right)}: {sentence}")
        raise WrongAnswer(f"{_told(players, names, right)}: {_one_name(players, names, right)}")
    return "Right. To choose between players on the frontier you need a taste: how much mean is less spread worth?"


def _names(answer: Callable[..., Any], players: Mapping[str, Pair]) -> set[str]:
    """Return the names that an answer gives for some players."""
    call = f"frontier(players) with {len(players)} players"
    mine = dict(players)
    with student_code(call):
        found = answer(mine)
    given(call, found)
    if mine != players:
        raise WrongAnswer(f"{call} changes the dictionary that it is given; collect the names in a list of their own")
    if isinstance(found, str):
        raise WrongAnswer(f"{call} should be a list of names, but is the text {found!r}: there may be several")
    with student_code(call):
        try:
            names = [*found]
        except TypeError:
            raise WrongAnswer(f"{call} should be a list of names, but is a {type(found).__name__}") from None
    strange = [name for name in names if not isinstance(name, str) or name not in players]
    if strange:
        raise WrongAnswer(f"{call} should hold names such as {next(iter(players))!r}, but holds {strange[0]!r}")
    if len(names) != len({*names}):
        raise WrongAnswer(
            f"{call} holds {max(names, key=names.count)!r} more than once, and once is enough: is it appended in the"
            " inner loop, or by two lists that are added?"
        )
    return {*names}


def _told(players: Mapping[str, Pair], names: set[str], right: set[str]) -> str:
    given_players = ", ".join(f"{name} {pair}" for name, pair in players.items())
    return (
        f"of {given_players} it should give {', '.join(sorted(right))}, but gives {', '.join(sorted(names)) or 'none'}"
    )


def _one_name(players: Mapping[str, Pair], names: set[str], right: set[str]) -> str:
    """Return why one name is missing, or too many."""
    if names - right:
        name = min(names - right)
        other = next(other for other, pair in players.items() if beats(pair, players[name]))
        return f"{name} is beaten by {other}"
    return f"nobody beats {min(right - names)}"


def two_weights_update(tables: Tables, now: Transition, *, kappa: float, weigh: str = "δ", **one_step: Any) -> None:
    """Apply Q-learning with a weight of 1 - κ for good surprises and 1 + κ for bad ones; other `weigh` are mistakes."""
    Q, entry, rate = tables["Q"], (now.state, now.action), one_step["learning_rate"]
    step, before = one_step.get("step", "difference"), Q.copy()
    one_step_update(tables, now, **one_step)
    if step == "next row":
        entry = (now.next_state, now.action)
    old, new = float(before[entry]), float(Q[entry])
    moved = new - old
    if step in SIMPLE:  # the surprise is that of the right step
        plain = {"Q": before.copy()}
        one_step_update(plain, now, **{**one_step, "step": "difference"})
        moved = float(plain["Q"][entry]) - old
    delta = moved / rate if rate else 0.0  # a rate of 0 is tried when numbers are fitted to an answer
    good, bad = 1 - kappa, 1 + kappa
    target = delta + old
    weight = {
        "δ": good if delta > 0 else bad,
        "inverted": bad if delta > 0 else good,
        "reward": good if now.reward > 0 else bad,
        "target": good if target > 0 else bad,
        "value": good if old > 0 else bad,
        "none": 1.0,
        "always good": good,
        "always bad": bad,
        "good only": good if delta > 0 else 1.0,
        "bad only": 1.0 if delta > 0 else bad,
        "κ and -κ": -kappa if delta > 0 else kappa,
        "κ alone": kappa,
        "2σ": 1 + np.tanh(-kappa * delta / 2),
        "2σ inverted": 1 + np.tanh(kappa * delta / 2),
        "halves": (good if delta > 0 else bad) / 2,
        "squared": (good if delta > 0 else bad) ** 2,
        "only bad": 0.0 if delta > 0 else bad,
        "only good": good if delta > 0 else 0.0,
        "both": good + bad if delta > 0 else bad,
        "with the size": 1 - kappa * delta,
    }.get(weigh)
    if weight is None:
        its_own = good if delta > 0 else bad
        weight, new = 1.0, old + rate * {"without δ": its_own, "on the target": its_own * target - old}[weigh]
    base = 0.0 if step in ("only", "only difference") else old
    Q[entry] = base + weight * (new - base)


SIMPLE = ("difference", "minus", "no old", "only", "only difference")
"""Steps with one factor, which the weight multiplies."""
WEIGHT_MISTAKES: Mapping[str, Mapping[str, Any]] = {
    "δ has the wrong sign: it is the target less Q(S, A), not Q(S, A) less the target": {
        "step": "minus",
        "weigh": "inverted",
    },
    "good and bad surprises have changed places: whatever the sign of κ, bad ones weigh 1 + κ (κ > 0 avoids risk, as"
    " β < 0 does)": {"weigh": "inverted"},
    "it asks whether the *reward* is good; a surprise is good if δ is above 0": {"weigh": "reward"},
    "it asks whether the *target* is above 0; a surprise is good if δ is": {"weigh": "target"},
    "it asks whether the old *value* is above 0; a surprise is good if δ is": {"weigh": "value"},
    "the weight is missing: that is Q-learning": {"weigh": "none"},
    "the weight is 1 − κ always, for bad surprises too": {"weigh": "always good"},
    "the weight is 1 + κ always, for good surprises too": {"weigh": "always bad"},
    "bad surprises have no weight of their own, 1 + κ": {"weigh": "good only"},
    "good surprises have no weight of their own, 1 − κ": {"weigh": "bad only"},
    "the 1 is missing in the weights, which are 1 − κ and 1 + κ": {"weigh": "κ and -κ"},
    "κ itself stands where the weight should": {"weigh": "κ alone"},
    "that is the weight of Delétang et al., 2σ(βδ); here are two weights, whatever the size of δ": {"weigh": "2σ"},
    "that is 2σ(κδ), the weight of Delétang et al., and κ has the opposite sign of β": {"weigh": "2σ inverted"},
    "the weights are half as large as they should be": {"weigh": "halves"},
    "the weight counts twice": {"weigh": "squared"},
    "nothing is learned from good surprises; they weigh 1 − κ": {"weigh": "only bad"},
    "nothing is learned from bad surprises; they weigh 1 + κ": {"weigh": "only good"},
    "the weight belongs to the whole δ, not to the target alone": {"weigh": "on the target"},
    "δ is missing in the step, which is α times the weight times δ": {"weigh": "without δ"},
    "a good surprise is learned from twice, with both weights: is an `else` missing?": {"weigh": "both"},
    "the weight is 1 − κδ; it should depend on the sign of δ only, whatever its size": {"weigh": "with the size"},
}


def other_weights(wrong: Mapping[str, float], settings: Mapping[str, Any]) -> str:
    """Tell of two other weights: any two are the same as another learning rate and another κ."""
    if wrong.keys() != {"learning_rate", "kappa"}:
        return ""
    scale, kappa = wrong["learning_rate"] / settings["learning_rate"], settings["kappa"]
    good, bad = scale * (1 - wrong["kappa"]), scale * (1 + wrong["kappa"])
    return (
        f"good surprises weigh {good:.3g} and bad ones {bad:.3g}, where 1 − κ is {1 - kappa:.3g} and 1 + κ is"
        f" {1 + kappa:.3g}"
    )


TWO_WEIGHTS = Update(
    rule=two_weights_update,
    tables=Q_LEARNING.tables,
    mistakes={**WEIGHT_MISTAKES, **Q_LEARNING.mistakes},
    numbers=numbers_of("learning_rate", "discount", "kappa"),
    together=other_weights,
)


Cost = Annotated[float, step_cost("This stands in δ. So the agents of the race below play otherwise.")]


def exercise_3(answer: Any, seed: int, cost: Cost = 0.0) -> str:
    """Check the class of an agent that weighs good and bad surprises."""
    require_class("TwoWeights", answer)
    rng = np.random.default_rng(seed)
    for n_states, n_actions, sign in ((6, 3, 1), (5, 2, -1), (7, 4, 1)):
        settings = {
            "learning_rate": float(rng.choice(LEARNING_RATES)),
            "discount": float(rng.choice(DISCOUNTS)),
            "kappa": sign * float(rng.choice([0.3, 0.6, 0.8])),
        }
        make = partial(agent_with_table, "TwoWeights", answer, (n_states, n_actions), settings)
        TWO_WEIGHTS.check(make, (n_states, n_actions), settings | {"extra": -cost}, seed)
    return "Right: two weights are enough to move the crossing. See it race:"


CHALLENGE = Challenge(
    environment="Golf",
    parameters=MappingProxyType({"stochasticity_level": LEVEL, "observe_hits": True}),
    n_steps=5_000,
    baselines=MappingProxyType(methods_with()),
    optimum=OPTIMUM,
    best_average=OPTIMUM,
    column="training_return",
)
"""The open challenge: the highest return of all training games, those with lost balls included, in 5 000 steps."""
