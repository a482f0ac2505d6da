"""Bandits (lesson 0b): what it costs to find the best of several arms, and who pays least.

Agents pull the arms of Bandit 10 000 times (10 arms, gap 0.2, rewards 1 or 0): greedy sample averages; ε-greedy with
ε = 0.1, and with an ε that falls as 200/t; optimistic values (learning rate 0.1, first values 1); UCB with c = 0.7;
Thompson sampling with σ = 0.5; the gradient bandit with learning rate 0.1. What counts is the regret, which follows
exactly from the pulls. Beside the lesson's bandit there are one with 5 arms, and one with a gap of 0.4. Explore, then
commit tries each arm 10, 30, 100 and 300 times. Gaps from 0.01 to 1; and arms that drift, where ε-greedy also learns
with a constant learning rate of 0.1. 100 repetitions, each with another best arm; 1000 short ones for greedy,
and 400 where rare runs count. A softmax of the means has a temperature of a tenth of the gap, and of a half.
"""

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Any, NamedTuple

from edugym.experiments.results.claims import Above, Below, Claim, Within
from edugym.experiments.results.statistics import mean_interval, paired_difference
from edugym.mdp.protocol import Reals
from edugym_course.lessons.bandits.figures import GAPS, by_arm, drifting, measure_gaps, over_gaps, regrets
from edugym_course.lessons.bandits.methods import (
    AT_FIRST,
    BOUNDS,
    DECAY,
    EPSILON,
    GAP,
    GRADIENT,
    GREEDY,
    IN_THE_FIGURE,
    N_ARMS,
    N_FIRST,
    N_PULLS,
    REPETITIONS,
    SHORT,
    SLIPS,
    STEADY,
    THOMPSON,
    Pulls,
    pulls,
    slope,
    softmax_of_means,
    softmax_slope,
    stuck,
    tries_first,
)
from edugym_course.report import Report
from edugym_course.reporting import SharedArguments, reporting

Settings = Mapping[str, Any]
SETTINGS: Mapping[str, Settings] = MappingProxyType(
    {
        "with 10 arms and a gap of 0.2": {},
        "with 5 arms": {"n_arms": 5},
        "with a gap of 0.4": {"gap": 0.4},
    }
)
FIRST = next(iter(SETTINGS))
TRIES: Mapping[float, tuple[int, ...]] = MappingProxyType({0.1: (30, 100), GAP: (10, 30, 100, 300), 0.4: (10, 30)})
"""How often explore-then-commit tries each arm first, by the gap."""
RIGHT_TRIES: Mapping[float, int] = MappingProxyType({0.1: 100, GAP: 30, 0.4: 10})
"""Of these the number that costs least, by the gap."""
ENOUGH = 30
"""So often every arm is tried before a greedy agent is greedy, in the control."""
DRIFTING: Mapping[str, Settings] = MappingProxyType(
    {
        "with a gap of 0.2": {"drift": 0.001},
        "with a gap of 0.3": {"drift": 0.001, "gap": 0.3},
        "with 5 arms": {"drift": 0.001, "n_arms": 5},
    }
)
COLD, WARM = 0.1, 0.5
"""Temperatures of a softmax of the means, in gaps."""
HALF = N_PULLS // 2
EARLY = 1_000


class Found(NamedTuple):
    """What was measured in one bandit.

    Attributes:
        methods: by method.
        greedy: many short runs of greedy.
        informed: greedy after some tries of each arm.
        slips: more runs of both kinds of ε-greedy, by method. A falling ε may settle on a worse arm in a rare run.
    """

    methods: Mapping[str, Pulls]
    greedy: Pulls
    informed: Pulls
    slips: Mapping[str, Pulls]


def measure(how: SharedArguments) -> tuple[Any, ...]:
    """Run the experiments."""
    shared = {name: how.shared[name] for name in ("repetitions", "seed", "stop")}
    more, many = ({**shared, "repetitions": times * how.repetitions} for times in (4, 10))
    found = {
        name: Found(
            {method: pulls(method, **settings, **shared) for method in IN_THE_FIGURE},
            pulls(GREEDY, SHORT, **settings, **many),
            pulls(tries_first(ENOUGH), **settings, **more),
            {method: pulls(method, **settings, **more) for method in (SLIPS, DECAY)},
        )
        for name, settings in SETTINGS.items()
    }
    tried = {
        gap: {n: pulls(tries_first(n), gap=gap, **more).regret() for n in numbers} for gap, numbers in TRIES.items()
    }
    gaps = {n_arms: measure_gaps(n_arms=n_arms, **shared) for n_arms in (N_ARMS, 5, 20)}
    drift = {
        name: tuple(
            {method: pulls(method, **{**settings, **change}, **shared) for method in MOVING}
            for change in ({}, {"drift": 0.0})
        )
        for name, settings in DRIFTING.items()
    }
    thompson = {gap: pulls(THOMPSON, gap=gap, **more).regret() for gap in TRIES}
    soft = {
        name: {share: pulls(softmax_of_means(share * _gap(settings)), **settings, **shared) for share in (COLD, WARM)}
        for name, settings in SETTINGS.items()
    }
    return found, (tried, thompson), gaps, drift, soft


def _gap(settings: Settings) -> float:
    return float(settings.get("gap", GAP))


MOVING = (SLIPS, STEADY, BOUNDS, THOMPSON, AT_FIRST)


def judge(
    found: Mapping[str, Found],
    tried: tuple[Mapping[float, Mapping[int, Reals]], Mapping[float, Reals]],
    gaps: Mapping[int, Mapping[str, Sequence[Reals]]],
    drift: Mapping[str, tuple[Mapping[str, Pulls], Mapping[str, Pulls]]],
    soft: Mapping[str, Mapping[float, Pulls]],
) -> Report:
    """Return claims and figures."""
    claims = [claim for name, one in found.items() for claim in [*greedy_claims(name, one), *regret_claims(name, one)]]
    claims += tries_claims(*tried)
    claims += [claim for n_arms, one in gaps.items() for claim in gap_claims(n_arms, one)]
    claims += [claim for name, one in drift.items() for claim in drift_claims(name, *one)]
    claims += [claim for name, one in soft.items() for claim in softmax_claims(name, one, found[name])]
    methods = {method: one for method, one in found[FIRST].methods.items() if method != GREEDY}
    moving, still = next(iter(drift.values()))
    bars = by_arm({method: methods[method] for method in (SLIPS, BOUNDS, THOMPSON)})
    return Report(claims, [regrets(methods), bars, over_gaps(gaps[N_ARMS]), drifting(still, moving)])


report = reporting(measure, judge, REPETITIONS)
"""Run the experiments of the lesson (see `edugym_course.reporting.Reporter`)."""
SETTLED = "share of runs in which the best arm has most of the last tenth of the pulls"
REGRET = f"regret after {N_PULLS} pulls"


def informed(name: str) -> str:
    """Return the claim on greedy after some tries."""
    return f"After {ENOUGH} tries of each arm, {name}, greedy mostly finds the best one"


def greedy_claims(name: str, found: Found) -> list[Claim]:
    """Return the claims on greedy sample averages."""
    settings = SETTINGS[name]
    exact = stuck(settings.get("n_arms", N_ARMS), settings.get("gap", GAP))
    return [
        Claim(
            f"Greedy, {name}, mostly stays with a worse arm",
            f"{SETTLED}, after {SHORT} pulls",
            mean_interval(found.greedy.settled()),
            Below(0.4),
            "the first arm that pays looks better for ever than those never tried",
            (informed(name),),
        ),
        Claim(informed(name), SETTLED, mean_interval(found.informed.settled()), Above(0.85)),
        Claim(
            f"Greedy, {name}, stays with the first arm that pays, as the exact share says",
            f"{SETTLED}, after {SHORT} pulls, less the exact share, {exact:.3f}",
            mean_interval(found.greedy.settled() - exact),
            Within(-0.06, 0.06),
        ),
    ]


def slips_end(name: str) -> str:
    """Return the claim on an ε that falls."""
    return f"With an ε that falls, {name}, the regret grows more slowly late"


def regret_claims(name: str, found: Found) -> list[Claim]:
    """Return the claims on the regret of the other methods."""
    methods, settings = found.methods, SETTINGS[name]
    total = {method: one.regret() for method, one in methods.items()}
    late = slope(EPSILON, settings.get("n_arms", N_ARMS), settings.get("gap", GAP))
    rate = f"regret of a pull in the second half, divided by {late:.4g}, what random pulls in a share ε cost"

    def less(first: str, second: str, limit: float) -> Claim:
        return Claim(
            f"{first[0].upper()}{first[1:]}, {name}, has less regret than {second}",
            f"{REGRET}, less that of {second}",
            paired_difference(total[first], total[second]),
            Below(limit),
        )

    return [
        Claim(
            f"ε-greedy's regret, {name}, goes on growing evenly",
            rate,
            mean_interval(found.slips[SLIPS].between(HALF, N_PULLS) / late),
            Within(0.9, 1.3),
            "a share ε of the pulls stays random",
            (slips_end(name),),
        ),
        Claim(slips_end(name), rate, mean_interval(found.slips[DECAY].between(HALF, N_PULLS) / late), Below(0.5)),
        Claim(
            f"An ε that falls, {name}, has less regret in the end than ε-greedy",
            f"{REGRET}, less that of ε-greedy",
            paired_difference(found.slips[DECAY].regret(), found.slips[SLIPS].regret()),
            Below(-10),
        ),
        Claim(
            f"An ε that falls, {name}, costs more at first than ε-greedy",
            f"regret after {EARLY} pulls, less that of ε-greedy",
            paired_difference(found.slips[DECAY].regret(EARLY), found.slips[SLIPS].regret(EARLY)),
            Above(5),
        ),
        less(BOUNDS, SLIPS, -40),
        less(THOMPSON, SLIPS, -50),
        less(GRADIENT, SLIPS, -30),
        less(THOMPSON, BOUNDS, 0),
        *(
            Claim(
                f"{method[0].upper()}{method[1:]}, {name}, pays far less in the second half than in the first",
                "regret of the second half, less a half of that of the first",
                mean_interval(total[method] - 1.5 * methods[method].regret(HALF)),
                Below(0),
            )
            for method in (BOUNDS, THOMPSON, GRADIENT)
        ),
    ]


def tries_claims(total: Mapping[float, Mapping[int, Reals]], thompson: Mapping[float, Reals]) -> list[Claim]:
    """Return the claims on trying each arm equally often, and then staying with the best."""

    def fewer(gap: float, first: int, second: int, limit: Below | Above) -> Claim:
        compared = "more" if isinstance(limit, Above) else "less"
        return Claim(
            f"At a gap of {gap:g}, {first} tries of each arm cost {compared} than {second}",
            f"{REGRET}, less that after {second} tries of each arm",
            paired_difference(total[gap][first], total[gap][second]),
            limit,
        )

    return [
        *(
            Claim(
                f"{n} tries of each arm, and then the best, cost more than Thompson sampling",
                f"{REGRET}, less that of Thompson sampling",
                paired_difference(total[GAP][n], thompson[GAP]),
                Above(30),
            )
            for n in (10, 100, 300)
        ),
        *(
            Claim(
                f"At a gap of {gap:g}, {n} tries of each arm cost hardly more than Thompson sampling",
                f"{REGRET}, less that of Thompson sampling",
                paired_difference(total[gap][n], thompson[gap]),
                Below(30),
            )
            for gap, n in RIGHT_TRIES.items()
        ),
        fewer(GAP, 10, 30, Above(30)),
        fewer(0.1, 30, 100, Above(0)),
        fewer(0.4, 10, 30, Below(0)),
    ]


def gap_claims(n_arms: int, found: Mapping[str, Sequence[Reals]]) -> list[Claim]:
    """Return the claims that the regret first rises with the gap and then falls."""
    return [
        Claim(
            f"{method}, with {n_arms} arms, pays more at a gap of 0.05 than at one of {other:g}",
            f"{REGRET}, less that at a gap of {other:g}",
            paired_difference(row[GAPS.index(0.05)], row[GAPS.index(other)]),
            Above(10),
        )
        for method, row in found.items()
        for other in (0.01, 0.5)
    ]


def drift_claims(name: str, moving: Mapping[str, Pulls], still: Mapping[str, Pulls]) -> list[Claim]:
    """Return the claims on arms that drift."""
    at_first = f"Where arms drift, {name}, UCB has more if its bonus ends after {N_FIRST} pulls"
    without = f"Without drift, {name}, sample averages are ahead of a constant learning rate"

    def behind(found: Mapping[str, Pulls], other: str) -> Any:
        return paired_difference(found[SLIPS].regret(), found[other].regret())

    less = f"{REGRET} of ε-greedy with sample averages, less that"
    return [
        Claim(
            f"Where arms drift, {name}, sample averages stay behind a constant learning rate",
            f"{less} with a constant learning rate",
            behind(moving, STEADY),
            Above(100),
            "old rewards weigh as much as new ones, and here they say nothing any more",
            (without,),
        ),
        Claim(without, f"{less} with a constant learning rate", behind(still, STEADY), Below(-20)),
        Claim(
            f"Where arms drift, {name}, UCB has less regret than Thompson sampling",
            f"{REGRET}, less that of Thompson sampling",
            paired_difference(moving[BOUNDS].regret(), moving[THOMPSON].regret()),
            Below(-100),
            "its bonus goes on sending it to arms that it seldom pulled",
            (at_first,),
        ),
        Claim(
            at_first,
            f"{REGRET}, less that of Thompson sampling",
            paired_difference(moving[AT_FIRST].regret(), moving[THOMPSON].regret()),
            Above(100),
        ),
    ]


def softmax_claims(name: str, soft: Mapping[float, Pulls], found: Found) -> list[Claim]:
    """Return the claims on a softmax of the means."""
    settings = SETTINGS[name]
    gap = _gap(settings)
    late = softmax_slope(WARM * gap, settings.get("n_arms", N_ARMS), gap)
    return [
        *(
            Claim(
                f"A softmax of the means, {name}, has more regret than ε-greedy at a temperature of {share * gap:g}",
                f"{REGRET}, less that of ε-greedy",
                paired_difference(one.regret(), found.methods[SLIPS].regret()),
                Above(200),
            )
            for share, one in soft.items()
        ),
        Claim(
            f"A softmax of the means, {name}, goes on paying at a temperature of {WARM * gap:g}, as with true means",
            f"regret of a pull in the second half, divided by {late:.4g}, what it would be with the true means",
            mean_interval(soft[WARM].between(HALF, N_PULLS) / late),
            Within(0.9, 1.1),
        ),
    ]
