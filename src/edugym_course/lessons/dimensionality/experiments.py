"""Dimensionality (lesson 4): tables over the images of Catch, and what they cannot do.

Q-learning trains for 20 000 steps with learning rate 0.5, discount 0.9 and ε-greedy exploration with ε = 0.1, on
positions (a dense table) and on the board of 10 by 5 pixels (a hashed table, with rows for the boards that occur). The
noise is in one pixel (one of 16 levels at random, 150 000 steps) or in all (normal with σ = 0.1, 40 000 steps).
Generalisation: the table and two agents with linear features (learning rate 0.1) train for 40 000 steps with balls from
columns 0, 2 and 4, and are then tested with those from columns 1 and 3; so is the agent linear in the pixels with other
learning rates (30 repetitions), and DQN (64 hidden units, learning rate
0.001), which also learns under noise. The results of CNNs and of Stable-Baselines3 are stored. 10 repetitions; the
seeds are the same for every method. Each point of a curve is the mean of 30 greedy evaluation episodes.
"""

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from edugym.agents.semi_gradient_sarsa import SemiGradientSARSA
from edugym.experiments.figures.curves import Curves
from edugym.experiments.figures.sheet import Sheet
from edugym.experiments.results.claims import Above, Below, Claim, Within
from edugym.experiments.results.statistics import exactly, mean_interval, paired_difference, share_interval
from edugym.experiments.results.tables import Results
from edugym.mdp.protocol import Reals
from edugym_course.lessons.dimensionality.baird import bairds_weights, growth_of_weights, weights_of_solid
from edugym_course.lessons.dimensionality.figures import shared_by_column, size_sheet, stored_networks, withheld
from edugym_course.lessons.dimensionality.methods import (
    GENERAL,
    LEVELS,
    LINEAR,
    LINEAR_RATE,
    N_STEPS,
    NETWORK,
    OFFSET,
    PIXELS,
    POSITIONS,
    SIGMA,
    TABLE,
    generalise,
    learn,
    linear,
    network,
    pixels,
    returns_by_column,
    seen,
    steps_to_solve,
    thrown,
)
from edugym_course.lessons.dimensionality.networks import STORED, network_claims
from edugym_course.lessons.dimensionality.races import ALL_PIXELS, HOPELESS, ONE_PIXEL, compare_sights
from edugym_course.lessons.dimensionality.sharing import COLUMN, SMALL
from edugym_course.lessons.dimensionality.sizes import different_boards, new_share, rows_of_table
from edugym_course.lessons.dimensionality.tasks import TRAINED, WITHHELD, catch
from edugym_course.lessons.dimensionality.triad import w_to_2w
from edugym_course.report import Report
from edugym_course.reporting import SharedArguments, reporting

SLOW = 150_000
"""The training steps with one noisy pixel."""
REPETITIONS = 10
RANDOM_PLAY = -0.6
RATES = (LINEAR_RATE, 0.03, 0.02, 0.01)
"""Learning rates of the agent linear in the pixels: that of the lesson, and smaller ones."""


def measure(how: SharedArguments) -> tuple[Any, ...]:
    """Run the experiments."""
    plain = {
        POSITIONS: learn(catch("vectorised"), POSITIONS, **how("positions")),
        PIXELS: learn(pixels(), PIXELS, **how("pixels")),
    }
    noisy = {
        ONE_PIXEL: learn(pixels(levels=LEVELS), ONE_PIXEL, n_steps=SLOW, **how("one_pixel")),
        ALL_PIXELS: learn(
            pixels(sigma=SIGMA, capacity=2 * HOPELESS), ALL_PIXELS, n_steps=HOPELESS, **how("all_pixels")
        ),
    }
    network_noisy = learn(seen(sigma=SIGMA), NETWORK, network(), n_steps=HOPELESS, **how("network"))
    general = generalise([TABLE, LINEAR, OFFSET, NETWORK], **how())
    tests = {label: returns_by_column(results) for label, results in general.items()}
    more: dict[str, Any] = {"repetitions": 3 * how.repetitions}  # runs differ much
    return plain, {**noisy, NETWORK: network_noisy}, tests, {rate: in_the_pixels(rate, **how(**more)) for rate in RATES}


def in_the_pixels(rate: float, **how: Any) -> Reals:
    """Return the greedy return by column and run of the agent linear in the pixels, with this learning rate."""
    steps = {"n_steps": 2 * N_STEPS, "points": 4}
    return returns_by_column(learn(thrown("grid", TRAINED), LINEAR, linear(learning_rate=rate), **steps, **how))


def judge(
    plain: Mapping[str, Results],
    noisy: Mapping[str, Results],
    tests: Mapping[str, Reals],
    rates: Mapping[float, Reals],
) -> Report:
    """Return claims and figures."""
    tests = {**tests, **{label: shared_by_column(label) for label in (SMALL, COLUMN)}}
    claims = [*size_claims(), *pixel_claims(plain), *noise_claims(plain, noisy), *general_claims(tests)]
    claims += rate_claims(rates)
    claims += [*sharing_claims(tests), *triad_claims(), *network_claims(STORED.load())]
    return Report(claims, figures(plain, noisy, tests))


report = reporting(measure, judge, REPETITIONS)
"""Run the experiments of the lesson (see `edugym_course.reporting.Reporter`)."""


def size_claims() -> list[Claim]:
    """Return the claims on the sizes of tables, computed."""
    falling, boards = different_boards()
    return [
        Claim(
            "A table over positions has 250 rows",
            "rows, computed",
            exactly(rows_of_table("vectorised")),
            Within(250, 250),
        ),
        Claim(
            "A dense table over all boards of 50 pixels is impossible: it needs 27 petabytes",
            "petabytes, computed",
            exactly(rows_of_table("grid") * 3 * 8 / 1e15),
            Within(26.5, 27.5),
            remark=f"2^50 rows; over all images of 150 bytes it would have 10^{math.log10(rows_of_table('rgb')):.0f}",
        ),
        Claim(
            "While the ball falls, there are as many boards as states: a table needs rows for these boards only",
            "different boards / states, computed",
            exactly(boards / falling),
            Within(1.0, 1.0),
            remark=f"{boards} boards",
        ),
    ]


def pixel_claims(plain: Mapping[str, Results]) -> list[Claim]:
    """Return the claims on hashed tables."""
    curves = [plain[label].curves(label).to_numpy(float) for label in (POSITIONS, PIXELS)]
    return [
        Claim(
            "A hashed table learns from pixels exactly as fast as a dense one from positions",
            "largest difference of the learning curves of all runs",
            exactly(float(np.abs(curves[0] - curves[1]).max())),
            Within(0.0, 0.0),
            remark="'a table cannot read pixels' is wrong: it gives a row to each board that occurs",
        ),
        Claim(
            "A hashed table over pixels catches every ball",
            "greedy return, last five evaluations",
            mean_interval(plain[PIXELS].late(PIXELS)),
            Above(0.99),
        ),
    ]


def noise_claims(plain: Mapping[str, Results], noisy: Mapping[str, Results]) -> list[Claim]:
    """Return the claims on noisy pixels."""
    clean = plain[PIXELS].curves(PIXELS).loc[N_STEPS // 2].to_numpy(float)
    half = noisy[ONE_PIXEL].curves(ONE_PIXEL)
    return [
        Claim(
            f"One noisy pixel slows the hashed table: it is behind after {half.index[1]} steps",
            f"greedy return, less that without noise after {N_STEPS // 2}",
            paired_difference(half.iloc[1].to_numpy(float), clean),
            Below(-0.2),
            f"each board has {LEVELS} rows now, and what is learned in one helps none of the others",
        ),
        Claim(
            f"With one noisy pixel the hashed table catches nearly every ball after {SLOW} steps",
            "greedy return, last five evaluations",
            mean_interval(noisy[ONE_PIXEL].late(ONE_PIXEL)),
            Above(0.9),
        ),
        Claim(
            "With noise of real numbers in all pixels nearly every board is new",
            "share of observations never seen before",
            mean_interval([new_share(pixels(sigma=SIGMA)(0), seed=seed) for seed in range(5)]),
            Above(0.99),
        ),
        Claim(
            f"With noise in all pixels a table learns nothing: it does no better than random play, {RANDOM_PLAY:g}",
            "greedy return, last five evaluations",
            mean_interval(noisy[ALL_PIXELS].late(ALL_PIXELS)),
            Within(RANDOM_PLAY - 0.15, RANDOM_PLAY + 0.15),
        ),
        Claim(
            "With noise in all pixels DQN learns to catch most balls",
            "greedy return of DQN, last five evaluations",
            mean_interval(noisy[NETWORK].late(NETWORK)),
            Above(0.85),
        ),
    ]


def general_claims(tests: Mapping[str, Reals]) -> list[Claim]:
    """Return the claims on balls from columns that were withheld in training."""
    seen = f"greedy return, balls from columns {', '.join(map(str, TRAINED))}"
    unseen = f"greedy return, balls from columns {', '.join(map(str, WITHHELD))}"
    return [
        Claim(
            "The table catches every ball from the columns of training",
            seen,
            mean_interval(tests[TABLE][[*TRAINED]].mean(axis=0)),
            Above(0.99),
        ),
        Claim(
            "The table does not generalise: it misses most balls from new columns",
            unseen,
            mean_interval(tests[TABLE][[*WITHHELD]].mean(axis=0)),
            Below(-0.2),
            remark="their rows were never visited",
        ),
        Claim(
            "Features that fit do generalise: an agent linear in ball minus paddle catches balls from new columns",
            unseen,
            mean_interval(tests[OFFSET][[*WITHHELD]].mean(axis=0)),
            Above(0.95),
            remark="the knowledge is in the features; a network has to learn it",
        ),
    ]


def rate_claims(rates: Mapping[float, Reals]) -> list[Claim]:
    """Return the claims on an agent linear in the pixels, by its learning rate."""
    caught = {rate: by_column > 0.99 for rate, by_column in rates.items()}
    return [
        Claim(
            f"With learning rate {RATES[0]:g} an agent linear in the pixels learns the columns of training in few runs",
            "share of runs that catch all balls from these columns",
            share_interval(caught[RATES[0]][[*TRAINED]].all(axis=0)),
            Below(0.5),
        ),
        Claim(
            "With smaller learning rates it happens in some runs, and not in all",
            f"share of all runs with learning rates {', '.join(f'{rate:g}' for rate in RATES[1:])}",
            share_interval(np.concatenate([caught[rate][[*TRAINED]].all(axis=0) for rate in RATES[1:]])),
            Within(0.1, 0.8),
            remark="a sum over pixels cannot represent the true values, and a policy can be right all the same",
        ),
        *(
            Claim(
                f"With learning rate {rate:g} an agent linear in the pixels is no way out: it misses most new balls",
                f"greedy return, balls from columns {', '.join(map(str, WITHHELD))}",
                mean_interval(rates[rate][[*WITHHELD]].mean(axis=0)),
                Below(-0.5),
                remark="weights that catch every ball exist; it does not find them",
            )
            for rate in rates
        ),
    ]


def sharing_claims(tests: Mapping[str, Reals]) -> list[Claim]:
    """Return the claims on networks and balls from withheld columns."""
    unseen = f"greedy return, balls from columns {', '.join(map(str, WITHHELD))}"
    return [
        Claim(
            "A fully connected network on pixels does not generalise to new columns",
            unseen,
            mean_interval(tests[NETWORK][[*WITHHELD]].mean(axis=0)),
            Below(0.5),
            "weights from pixels that were always 0 do not move",
        ),
        Claim(
            "A small CNN whose last layers have a weight for every place does not generalise to new columns",
            unseen,
            mean_interval(tests[SMALL][[*WITHHELD]].mean(axis=0)),
            Below(0.5),
            remark="results of ten seeds, stored with the package",
        ),
        Claim(
            "A CNN that keeps only the largest output of filters that slide over the columns generalises to new ones",
            unseen,
            mean_interval(tests[COLUMN][[*WITHHELD]].mean(axis=0)),
            Above(0.5),
            remark="results of ten seeds, stored with the package",
        ),
    ]


def triad_claims() -> list[Claim]:
    """Return the claims on the deadly triad, computed and simulated."""
    old = w_to_2w(2_000, 0.9, 0.1, copy_every=20)[-1]
    return [
        Claim(
            "The weight of w and 2w grows for every discount above 1/2",
            "the smallest discount in steps of 0.01 with which it grows",
            exactly(min(gamma for gamma in np.arange(101) / 100 if w_to_2w(2_000, gamma, 0.1)[-1] > 1.0)),
            Within(0.51, 0.51),
        ),
        Claim(
            "An old target slows the growth of this weight and does not stop it",
            "growth rate with a copy every 20 updates, of that without",
            exactly(math.log(old) / math.log(w_to_2w(2_000, 0.9, 0.1)[-1])),
            Within(0.2, 0.6),
        ),
        Claim(
            "In Baird's counterexample the weights of Q-learning grow more than fivefold",
            "largest weight after 1000 steps, of that at the start",
            mean_interval(np.array([growth_of_weights(weights_of_solid(seed=seed)) for seed in range(10)])),
            Above(5.0),
        ),
        Claim(
            "In Baird's counterexample the weights of SARSA do not grow, with the same behaviour and features",
            "largest weight after 1000 steps, of that at the start",
            mean_interval(
                np.array([growth_of_weights(weights_of_solid(SemiGradientSARSA, seed=seed)) for seed in range(10)])
            ),
            Below(1.0),
            "SARSA learns the values of its own behaviour",
            ("In Baird's counterexample the weights of Q-learning grow more than fivefold",),
        ),
    ]


def figures(plain: Mapping[str, Results], noisy: Mapping[str, Results], tests: Mapping[str, Reals]) -> list[Sheet]:
    """Return the figures: learning curves, sizes of tables, weights that diverge, and tests on withheld columns."""
    curves = [Curves(results, label, optimum=1.0) for label, results in {**plain, **noisy}.items()]
    return [
        Sheet("dimensionality", [curves[:2], curves[2:]]),
        size_sheet(),
        bairds_weights(),
        withheld(tests),
        stored_networks(),
    ]


def warm_up() -> None:
    """Compile what the lesson needs: a few steps of everything."""
    few: dict[str, Any] = {"n_steps": 400, "repetitions": 1, "jobs": 1}
    compare_sights(400, (1, 1), points=2, jobs=1)
    learn(catch("vectorised"), POSITIONS, **few)
    general = generalise([*GENERAL], **few)
    for results in general.values():
        returns_by_column(results)
    steps_to_solve(3, **few)
    size_sheet().draw()
