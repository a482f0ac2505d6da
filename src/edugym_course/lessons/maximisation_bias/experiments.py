"""Maximisation bias (lesson 17): what the largest of several estimates promises, and what remedies gain and cost.

Agents learn for 300 episodes in Casino (10 machines, each loses 0.1 on average, with payoffs 1 above or below; learning
rate 0.1, ε = 0.1, discount 1, first values 0): Q-learning, expected SARSA, double Q-learning and maxmin Q-learning with
2 and with 8 tables. What counts is the share of episodes 31 to 100 that lead into the casino. Beside the lesson's
setting there are a learning rate of 0.3, and 20 machines; the cause is removed by taking away the
noise, and by leaving one machine. After 60 episodes it is noted what Q-learners think of the machines. In casinos that
pay (3 machines, the last of which wins 0.9; 2 machines; a smaller advantage) agents learn for 600 episodes, and the
returns of the first and of the last 300 count, and what 8 tables say in the end. 100 repetitions. Sample means of 1, 5
and 20 tries are compared with exact sums; 1000 repetitions.
"""

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Any

from edugym.adapters.registration import make_mdp
from edugym.envs.casino import CASINO
from edugym.exact.maximisation import expected_choice, expected_maximum
from edugym.experiments.results.claims import Above, Below, Claim, Within
from edugym.experiments.results.statistics import mean_interval, paired_difference
from edugym.mdp.protocol import Reals
from edugym_course.lessons.maximisation_bias.figures import TRIES, incomes, promises, visits
from edugym_course.lessons.maximisation_bias.methods import (
    DOUBLE,
    EIGHT,
    EPSILON,
    EXPECTED,
    IN_THE_FIGURE,
    LONG,
    N_MACHINES,
    PAYING,
    Q_LEARNING,
    REPETITIONS,
    TWO,
    Tried,
    Walks,
    best_income,
    goes_in,
    tried,
    values,
    walks,
)
from edugym_course.report import Report
from edugym_course.reporting import SharedArguments, reporting

Settings = Mapping[str, Any]
SETTINGS: Mapping[str, Settings] = MappingProxyType(
    {
        "in the lesson's casino": {},
        "with a learning rate of 0.3": {"learning_rate": 0.3},
        "with 20 machines": {"n_machines": 20},
    }
)
QUIET: Settings = MappingProxyType({"noise": 0.0})
ALONE: Settings = MappingProxyType({"n_machines": 1})
PAYING_SETTINGS: Mapping[str, Settings] = MappingProxyType(
    {
        "where one of 3 machines pays": {},
        "where one of 2 machines pays": {"n_machines": 2},
        "where one of 3 machines pays less": {"advantage": 0.8},
    }
)
SAMPLED: Mapping[str, dict[str, Any]] = MappingProxyType(
    {
        "5 tries of each of 10 machines": {"n_tries": 5},
        "1 try of each of 2 machines": {"n_tries": 1, "n_machines": 2},
        "20 tries of each of 10 machines": {"n_tries": 20},
        "5 tries for each of 2 tables": {"n_tries": 5, "n_tables": 2},
    }
)
CASINOS: Mapping[str, Settings] = MappingProxyType(
    {"in the lesson's casino": {}, "with more noise": {"noise": 2.0}, "with 20 machines": {"n_machines": 20}}
)
SOON = 60
"""After so many episodes it is noted what Q-learners think of the machines."""
DIFFERENT: Settings = MappingProxyType({"n_tries": 5, "advantage": 0.3})
"""A casino whose last machine wins 0.2 on average."""


def measure(how: SharedArguments) -> tuple[Any, ...]:
    """Run the experiments."""
    shared = {name: how.shared[name] for name in ("repetitions", "seed", "stop")}
    many = {**shared, "repetitions": 10 * how.repetitions}

    def learned(methods: Sequence[str], settings: Settings, n_episodes: int) -> dict[str, Walks]:
        return {method: walks(method, n_episodes, **{**settings, **shared}) for method in methods}

    figure = learned(IN_THE_FIGURE, {}, 300)
    found = {
        name: (
            figure if not settings else learned(IN_THE_FIGURE, settings, 100),
            walks(Q_LEARNING, 100, **{**settings, **QUIET, **shared}),
            walks(Q_LEARNING, 100, **{**settings, **ALONE, **shared}),
        )
        for name, settings in SETTINGS.items()
    }
    paying = {
        name: tuple(
            learned((Q_LEARNING, DOUBLE, TWO, EIGHT), {**PAYING, **settings, **noise}, LONG) for noise in ({}, QUIET)
        )
        for name, settings in PAYING_SETTINGS.items()
    }
    sampled = {name: tried(**case, **many) for name, case in SAMPLED.items()}
    lines = {f"{k} machines": [tried(n, n_machines=k, **many) for n in TRIES] for k in (10, 2)}
    beliefs = {
        name: tuple(
            values(EIGHT, LONG, epsilon=epsilon, **{**PAYING, **settings}, **shared) for epsilon in (EPSILON, 1.0)
        )
        for name, settings in PAYING_SETTINGS.items()
    }
    hopeful = {name: values(Q_LEARNING, SOON, **settings, **shared) for name, settings in CASINOS.items()}
    return found, paying, beliefs, hopeful, sampled, lines, tried(**DIFFERENT, **many)


def judge(
    found: Mapping[str, tuple[Mapping[str, Walks], Walks, Walks]],
    paying: Mapping[str, tuple[Mapping[str, Walks], Mapping[str, Walks]]],
    beliefs: Mapping[str, tuple[Reals, Reals]],
    hopeful: Mapping[str, Reals],
    sampled: Mapping[str, Tried],
    lines: Mapping[str, list[Tried]],
    different: Tried,
) -> Report:
    """Return claims and figures."""
    claims = [claim for name, one in found.items() for claim in visiting_claims(name, *one)]
    claims += [claim for name, one in paying.items() for claim in paying_claims(name, *one)]
    claims += [claim for name, one in beliefs.items() for claim in belief_claims(name, *one)]
    claims += [claim for name, one in hopeful.items() for claim in hope_claims(name, one)]
    claims += [found_out(found["in the lesson's casino"][0][Q_LEARNING])]
    claims += [*sampling_claims(sampled), *second_opinions(sampled["5 tries of each of 10 machines"], different)]
    figure = found["in the lesson's casino"][0]
    cost = paying["where one of 3 machines pays"][0]
    return Report(claims, [visits(figure), incomes(cost, best_income()), promises(lines, {})])


report = reporting(measure, judge, REPETITIONS)
"""Run the experiments of the lesson (see `edugym_course.reporting.Reporter`)."""
SHARE = "share of episodes 31 to 100 in the casino"


def quiet(name: str) -> str:
    """Return the claim on payoffs without noise."""
    return f"Without noise, {name}, Q-learning hardly goes in"


def alone(name: str) -> str:
    """Return the claim on one machine."""
    return f"With one machine, {name}, Q-learning hardly goes in"


def visiting_claims(name: str, methods: Mapping[str, Walks], still: Walks, one: Walks) -> list[Claim]:
    """Return the claims on who goes in where no machine pays."""
    shares = {method: walked.share() for method, walked in methods.items()}
    return [
        Claim(
            f"Q-learning, {name}, goes in far too often",
            f"{SHARE}, less that without noise",
            paired_difference(shares[Q_LEARNING], still.share()),
            Above(0.15),
            "the largest of several noisy values is above the truth",
            (quiet(name), alone(name)),
        ),
        Claim(quiet(name), SHARE, mean_interval(still.share()), Below(0.12)),
        Claim(
            alone(name),
            f"{SHARE}, less that of several machines",
            paired_difference(one.share(), shares[Q_LEARNING]),
            Below(-0.15),
        ),
        Claim(
            f"Double Q-learning, {name}, goes in less often than Q-learning",
            f"{SHARE}, less that of Q-learning",
            paired_difference(shares[DOUBLE], shares[Q_LEARNING]),
            Below(-0.2),
        ),
        Claim(
            f"Maxmin Q-learning with 2 tables, {name}, goes in less often than Q-learning",
            f"{SHARE}, less that of Q-learning",
            paired_difference(shares[TWO], shares[Q_LEARNING]),
            Below(-0.1),
        ),
        Claim(
            f"Expected SARSA, {name}, goes in less often than Q-learning",
            f"{SHARE}, less that of Q-learning",
            paired_difference(shares[EXPECTED], shares[Q_LEARNING]),
            Below(-0.05),
        ),
        Claim(
            f"Expected SARSA, {name}, goes in more often than double Q-learning",
            f"{SHARE}, less that of double Q-learning",
            paired_difference(shares[EXPECTED], shares[DOUBLE]),
            Above(0.05),
        ),
    ]


EARLY = slice(0, 300)
INCOME = "mean return of episodes 301 to 600"


def costly(name: str) -> str:
    """Return the claim on what eight tables cost."""
    return f"Maxmin Q-learning with 8 tables, {name}, earns less than Q-learning"


def free(name: str) -> str:
    """Return the claim that they cost nothing without noise."""
    return f"Without noise, {name}, maxmin Q-learning with 8 tables earns as much"


def paying_claims(name: str, methods: Mapping[str, Walks], still: Mapping[str, Walks]) -> list[Claim]:
    """Return the claims on what remedies cost where a machine pays."""
    income = {method: walked.income() for method, walked in methods.items()}
    quietly = {method: walked.income() for method, walked in still.items()}
    return [
        Claim(
            costly(name),
            f"{INCOME}, less that of Q-learning",
            paired_difference(income[EIGHT], income[Q_LEARNING]),
            Below(-0.3),
            "the smallest of eight noisy values is below the truth",
            (free(name),),
        ),
        Claim(
            free(name),
            f"{INCOME}, less that of Q-learning",
            paired_difference(quietly[EIGHT], quietly[Q_LEARNING]),
            Within(-0.1, 0.05),
        ),
        *(
            Claim(
                f"{method[0].upper()}{method[1:]}, {name}, earns less than Q-learning at first",
                "mean return of episodes 1 to 300, less that of Q-learning",
                paired_difference(methods[method].income(EARLY), methods[Q_LEARNING].income(EARLY)),
                Below(-0.02),
            )
            for method in (DOUBLE, TWO)
        ),
        Claim(
            f"Maxmin Q-learning with 2 tables, {name}, earns more than with 8",
            f"{INCOME}, less that with 8 tables",
            paired_difference(income[TWO], income[EIGHT]),
            Above(0.2),
        ),
    ]


def sent(name: str) -> str:
    """Return the claim on learners whose actions are random."""
    return f"Where its actions are random, {name}, maxmin Q-learning with 8 tables learns more often to go in"


def belief_claims(name: str, of_their_own: Reals, sent_in: Reals) -> list[Claim]:
    """Return the claims on what those learn who stay outside, and those who are sent in, from their action values."""
    share = "share of runs in which going in has the highest value after 600 episodes"
    at_will, at_random = goes_in(of_their_own), goes_in(sent_in)
    return [
        Claim(
            f"Maxmin Q-learning with 8 tables, {name}, mostly does not learn to go in",
            share,
            mean_interval(at_will),
            Below(0.15),
            "whoever stays outside gets few tries that could correct a value that is too low",
            (sent(name),),
        ),
        Claim(
            sent(name),
            f"{share}, less that of those who act by their values",
            paired_difference(at_random, at_will),
            Above(0.25),
        ),
        Claim(
            f"The smallest of 8 values of the machine that wins, {name}, is often below 0",
            "share of runs, after 600 episodes",
            mean_interval((of_their_own[:, CASINO, -1] < 0).astype(float)),
            Above(0.4),
        ),
    ]


def hope_claims(name: str, Q: Reals) -> list[Claim]:
    """Return the claims on what Q-learners think of machines that all lose, from their action values."""
    inside = Q[:, CASINO]
    return [
        Claim(
            f"To Q-learners, {name}, the best machine seems to win",
            f"largest of its values in the casino, after {SOON} episodes",
            mean_interval(inside.max(axis=1)),
            Above(0.03),
        ),
        Claim(
            f"To Q-learners, {name}, an average machine does not",
            f"mean of its values in the casino, after {SOON} episodes",
            mean_interval(inside.mean(axis=1)),
            Below(0.0),
        ),
    ]


def found_out(walked: Walks) -> Claim:
    """Return the claim on what Q-learning does late in the lesson's casino."""
    return Claim(
        "Q-learning, in the lesson's casino, seldom goes in later",
        "share of episodes 201 to 300 in the casino",
        mean_interval(walked.share(slice(200, 300))),
        Below(0.12),
    )


def sampling_claims(sampled: Mapping[str, Tried]) -> list[Claim]:
    """Return the claims that exact sums say what is measured."""
    claims = []
    for name, found in sampled.items():
        case = dict(SAMPLED[name])
        payoffs = make_mdp("Casino", n_machines=case.get("n_machines", N_MACHINES)).payoffs
        exact = expected_maximum(payoffs, case["n_tries"], n_tables=case.get("n_tables", 1))
        claims.append(
            Claim(
                f"After {name}, the largest estimate is on average what the exact sum says",
                f"largest estimate less the exact sum, {exact:.3f}",
                mean_interval(found.largest - exact),
                Within(-0.1, 0.1),
            )
        )
    return claims


def second_opinions(equal: Tried, different: Tried) -> list[Claim]:
    """Return the claims on what new tries say of the machine that looks best."""
    payoffs = make_mdp("Casino", advantage=DIFFERENT["advantage"]).payoffs
    best, exact = float(payoffs.mean(axis=1).max()), expected_choice(payoffs, DIFFERENT["n_tries"])
    return [
        Claim(
            "Where all machines are equal, a second opinion on the one that looks best has no bias",
            "second opinion less the mean payoff",
            mean_interval(equal.second_opinion + 0.1),
            Within(-0.1, 0.1),
        ),
        Claim(
            "Where one machine pays 0.3 more, a second opinion is below what the best machine pays",
            "second opinion less the mean payoff of the best machine, after 5 tries of each",
            mean_interval(different.second_opinion - best),
            Below(-0.1),
        ),
        Claim(
            "There it is on average what the exact sum says",
            f"second opinion less the exact sum, {exact:.3f}",
            mean_interval(different.second_opinion - exact),
            Within(-0.1, 0.1),
        ),
    ]
