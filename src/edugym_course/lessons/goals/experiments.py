"""Goals (lesson 11): universal values and hindsight, for a network and for a table, on Switches.

`HindsightDQN` has its defaults: 64 hidden units, learning rate 0.001, discount 0.99, ε = 0.1. It trains for 15 000
steps with 7 and 8 switches, and for 25 000 with 9; with 8 switches also for 200 000 without hindsight, and for 60 000
with 'future'. 'future' draws
k = 4 goals for each step. The table, `HindsightQLearning`, has learning rate 1, discount 0.99 and ε = 0.1; its values
start at 0, and it trains for 15 000 steps with 4 and 8 switches, and for 50 000 with 6; they start at -n, and it trains
for 15 000 steps, with n = 7, 8 and 9. 5 repetitions, and twice as many of tables; the seeds are the same for every
method. Each point of a curve is the mean of 100 greedy evaluation episodes, each with another goal.
"The best return" is the best expected one, so such a mean may lie a little above it.
"""

from collections.abc import Mapping
from typing import Any

import numpy as np

from edugym.experiments.figures.sheet import Sheet
from edugym.experiments.results.claims import Above, Below, Claim, Within
from edugym.experiments.results.statistics import exactly, mean_interval, paired_difference
from edugym.experiments.results.tables import Results
from edugym_course.lessons.goals.figures import beliefs, curves
from edugym_course.lessons.goals.methods import (
    FINAL,
    FUTURE,
    N_STEPS,
    N_SWITCHES,
    NONE,
    OTHERS,
    REPETITIONS,
    at_random,
    best_return,
    chance_of_random_play,
    far_shares,
    networks,
    rewarded_share,
    tables,
    true_value,
    values_by_distance,
)
from edugym_course.report import Report
from edugym_course.reporting import SharedArguments, reporting

STEPS = {7: N_STEPS, N_SWITCHES: N_STEPS, 9: 25_000}
"""By the number of switches, how long networks train: the lesson's setting, and two others."""
LONG, LONGER = 200_000, 60_000
"""How long without hindsight, and with 'future', to see whether more time helps."""
OF_TABLES = {4: N_STEPS, 6: 50_000, N_SWITCHES: N_STEPS}
"""The same for tables."""
LOW_TABLES = {7: 2.5, N_SWITCHES: 1.5, 9: 0.7}
"""By the number of switches, n, how much hindsight gains a table whose values start at -n, or more."""
RANDOM_FUTURE, RANDOM_NONE = f"{FUTURE}, ε = 1", f"{NONE}, ε = 1"
LAST = 3
"""How many evaluations, the last ones, count as the end."""
NEAR = 0.5
"""How far from the best return counts as close."""
NOTHING = 1.0
"""How far above the lowest return, -n, counts as having learned next to nothing."""


def measure(how: SharedArguments) -> tuple[Any, ...]:
    """Run the experiments."""
    by_size = {
        n: networks(n, (NONE, FUTURE, FINAL, OTHERS), n_steps=steps, **how(f"networks_{n}"))
        for n, steps in STEPS.items()
    }
    long = networks(strategies=(NONE,), n_steps=LONG, **how("long"))
    longer = networks(strategies=(FUTURE,), n_steps=LONGER, **how("longer"))
    random = at_random(**how("random_flips"))
    more: dict[str, Any] = {"repetitions": 2 * how.repetitions}  # they are quick
    by_table = {n: tables(n, n_steps=steps, **how(f"tables_{n}", **more)) for n, steps in OF_TABLES.items()}
    low = {n: tables(n, first_value=-n, **how(f"low_tables_{n}", **more)) for n in LOW_TABLES}
    seeds = range(how.shared["seed"], how.shared["seed"] + how.repetitions)
    shares = {
        strategy: [rewarded_share(strategy, seed=seed) for seed in seeds if not how.shared["stop"].is_set()]
        for strategy in (NONE, FINAL, FUTURE, OTHERS)
    }
    return by_size, long, longer, random, by_table, low, shares


def judge(
    by_size: Mapping[int, Results],
    long: Results,
    longer: Results,
    random: Results,
    by_table: Mapping[int, Results],
    low: Mapping[int, Results],
    shares: Mapping[str, list[float]],
) -> Report:
    """Return claims and figures."""
    claims = [
        chance_claim(),
        *network_claims(by_size, long),
        *random_claims(random),
        *memory_claims(shares),
        *value_claims(by_size[N_SWITCHES]),
        *longer_claims(by_size[N_SWITCHES], longer),
        *table_claims(by_table),
        *low_table_claims(low),
    ]
    return Report(claims, figures(by_size, random, by_table, low))


report = reporting(measure, judge, REPETITIONS)
"""Run the experiments of the lesson (see `edugym_course.reporting.Reporter`)."""


def learned(n: int, strategy: str) -> str:
    """Return the claim that a network learns with hindsight."""
    return f"With {n} switches and '{strategy}' a network comes close to the best return"


def failed(n: int) -> str:
    """Return the claim that it learns nothing without hindsight."""
    return f"With {n} switches and no hindsight a network learns next to nothing"


def elsewhere(n: int) -> str:
    """Return the negative control: as many transitions, with goals that were not achieved."""
    return f"With {n} switches a network learns next to nothing from goals that other episodes achieved"


def gained(n: int) -> str:
    """Return the claim that hindsight helps a table to which nothing looks better than what it has learned."""
    return f"With {n} switches and first values of −{n} hindsight gains a table {LOW_TABLES[n]} or more"


SELDOM = "Random play reaches the goal of fewer than one episode in 30 with eight switches"
FEWER_PAIRS = "With 7 switches such a table comes within 1.2 of the best return"
FEW_PAIRS = "With 4 switches a table comes close to the best return without hindsight, too"


def chance_claim() -> Claim:
    """Return the claim on random play; it is exact."""
    return Claim(
        SELDOM,
        "share of episodes, computed",
        exactly(chance_of_random_play(N_SWITCHES)),
        Within(0.0, 1 / 30),
    )


def network_claims(by_size: Mapping[int, Results], long: Results) -> list[Claim]:
    """Return the claims on networks, in the lesson's setting and in two others."""
    return [
        *(
            Claim(
                learned(n, strategy),
                f"greedy return, last three evaluations of {STEPS[n]} steps, less the best",
                mean_interval(results.late(strategy, LAST) - best_return(n)),
                Above(-NEAR),
                "transitions that are learned for an achieved goal have the rewards",
                (*map(failed, STEPS), *map(elsewhere, STEPS)),
            )
            for n, results in by_size.items()
            for strategy in (FINAL, FUTURE)
        ),
        *(
            Claim(
                failed(n),
                f"greedy return after {STEPS[n]} steps, less the lowest",
                mean_interval(results.final(NONE) + n),
                Below(NOTHING),
            )
            for n, results in by_size.items()
        ),
        *(
            Claim(
                elsewhere(n),
                f"greedy return after {STEPS[n]} steps, less the lowest",
                mean_interval(results.final(OTHERS) + n),
                Below(NOTHING),
            )
            for n, results in by_size.items()
        ),
        Claim(
            f"With eight switches and no hindsight a network has learned next to nothing after {LONG} steps either",
            "greedy return, less the lowest",
            mean_interval(long.final(NONE) + N_SWITCHES),
            Below(NOTHING),
        ),
    ]


def random_claims(random: Results) -> list[Claim]:
    """Return the claims on agents that flip at random as long as they learn."""
    return [
        Claim(
            "Hindsight is no exploration: from random flips alone a network comes close to the best return",
            "greedy return with 'future', last three evaluations, less the best",
            mean_interval(random.late(RANDOM_FUTURE, LAST) - best_return(N_SWITCHES)),
            Above(-NEAR),
        ),
        Claim(
            "While it learns the same agent reaches its goals as seldom as random play",
            "return while it learns, less that of random play",
            mean_interval(random.average(RANDOM_FUTURE, "training_return") - random_return(N_SWITCHES)),
            Within(-0.1, 0.1),
        ),
        Claim(
            "From random flips without hindsight a network learns next to nothing",
            "greedy return, less the lowest",
            mean_interval(random.final(RANDOM_NONE) + N_SWITCHES),
            Below(NOTHING),
        ),
    ]


def random_return(n: int) -> float:
    """Return the expected return of random play: -1 for each step up to the goal, but for the last."""
    reached = [chance_of_random_play(n, steps) for steps in range(n + 1)]
    return -n + sum(reached[1:])


def memory_claims(shares: Mapping[str, list[float]]) -> list[Claim]:
    """Return the claims on what the memory holds after 1 000 steps, before anything is learned."""
    quantity = "share of the transitions that reach their goal"
    return [
        Claim(
            "Without hindsight fewer than one transition in 100 reaches its goal",
            quantity,
            mean_interval(shares[NONE]),
            Below(0.01),
        ),
        Claim("With goals of other episodes it is no more", quantity, mean_interval(shares[OTHERS]), Below(0.01)),
        Claim("With 'final' it is one in six or more", quantity, mean_interval(shares[FINAL]), Above(1 / 6)),
        Claim("With 'future' it is one in three or more", quantity, mean_interval(shares[FUTURE]), Above(1 / 3)),
    ]


def value_claims(eight: Results) -> list[Claim]:
    """Return the claims on what the networks believe, by the distance."""
    believed = {method: values_by_distance(eight, method) for method in (NONE, FUTURE)}
    true = np.array([true_value(d) for d in range(1, N_SWITCHES + 1)])
    near = np.abs(believed[FUTURE] - true[:, np.newaxis])[:4].max(axis=0)
    return [
        Claim(
            "With 'future' the values are those of the distance, up to 0.8, where it is 4 or less",
            "largest error of the four means",
            mean_interval(near),
            Below(0.8),
        ),
        Claim(
            "With 'future' far goals are taken for nearer than they are",
            "value at distance 8, less the true one",
            mean_interval(believed[FUTURE][-1] - true[-1]),
            Above(0.5),
        ),
        Claim(
            "Without hindsight the values do not depend on the distance",
            "value at distance 1, less that at distance 8",
            mean_interval(believed[NONE][0] - believed[NONE][-1]),
            Within(-0.2, 0.2),
        ),
    ]


def longer_claims(eight: Results, longer: Results) -> list[Claim]:
    """Return the claims on what networks believe that have trained for longer, and on what they learned from."""
    errors = values_by_distance(longer, FUTURE)[-1] - true_value(N_SWITCHES)
    return [
        Claim(
            f"After {LONGER} steps far goals are taken for less than 0.8 nearer",
            "value at distance 8, less the true one",
            mean_interval(errors),
            Below(0.8),
        ),
        Claim(
            "Far goals are as rare in the memory then",
            "share of transitions whose goal is 6 flips away or more, less that after 15000 steps",
            paired_difference(far_shares(longer, FUTURE), far_shares(eight, FUTURE)),
            Within(-0.02, 0.02),
        ),
    ]


def table_claims(by_table: Mapping[int, Results]) -> list[Claim]:
    """Return the claims on tables, with few pairs of a state and a goal and with many."""
    few, some, many = by_table.values()
    return [
        Claim(
            FEW_PAIRS,
            "greedy return, less the best",
            mean_interval(few.final(NONE) - best_return(4)),
            Above(-NEAR),
        ),
        Claim(
            "With 6 switches hindsight gains a table 0.3 or more in 50 000 steps",
            "greedy return with 'future', less that without hindsight",
            some.difference(FUTURE, NONE),
            Above(0.3),
        ),
        Claim(
            "With 8 switches a table whose values start at 0 learns next to nothing with 'future'",
            "greedy return, less the lowest",
            mean_interval(many.final(FUTURE) + N_SWITCHES),
            Below(NOTHING),
            "what was never tried looks better than what hindsight has learned",
            (*map(gained, LOW_TABLES),),
        ),
    ]


def low_table_claims(low: Mapping[int, Results]) -> list[Claim]:
    """Return the claims on tables to which nothing looks better than what they have learned."""
    behind = mean_interval(best_return(N_SWITCHES) - low[N_SWITCHES].final(FUTURE))
    return [
        *(
            Claim(
                gained(n),
                f"greedy return with 'future' after {N_STEPS} steps, less that without hindsight",
                results.difference(FUTURE, NONE),
                Above(LOW_TABLES[n]),
            )
            for n, results in low.items()
        ),
        Claim(
            FEWER_PAIRS,
            "greedy return with 'future', less the best",
            mean_interval(low[7].final(FUTURE) - best_return(7)),
            Above(-1.2),
        ),
        Claim(
            "With 8 switches such a table stays 1.5 or more behind, in the steps in which a network learns all",
            "the best return, less that with 'future'",
            behind,
            Above(1.5),
            "a table learns each pair of a state and a goal by itself, and there are too many of them",
            (FEW_PAIRS, FEWER_PAIRS, learned(N_SWITCHES, FUTURE)),
        ),
    ]


def figures(
    by_size: Mapping[int, Results], random: Results, by_table: Mapping[int, Results], low: Mapping[int, Results]
) -> list[Sheet]:
    """Return the figures: learning curves of networks and tables, and what networks believe."""
    network_curves = [curves(results, n, f"network, {n} switches") for n, results in by_size.items()]
    table_curves = [curves(results, n, f"table, {n} switches") for n, results in by_table.items()]
    low_curves = [curves(results, n, f"table, {n} switches, values from −{n}") for n, results in low.items()]
    return [
        Sheet("goals", [network_curves, table_curves, low_curves]),
        Sheet("random_flips", [[curves(random, N_SWITCHES, "random flips while they learn")]]),
        beliefs(by_size[N_SWITCHES], (NONE, FUTURE)),
    ]


def warm_up() -> None:
    """Compile what the lesson needs: a few steps of everything."""
    few: dict[str, Any] = {"n_steps": 40, "repetitions": 1, "jobs": 1}
    results = networks(strategies=(NONE, FINAL, FUTURE, OTHERS), **few)
    tables(**few)
    tables(first_value=-N_SWITCHES, **few)
    beliefs(results, (FUTURE,)).draw()
