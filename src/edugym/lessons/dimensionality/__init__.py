"""Dimensionality (lesson 4): tables over the images of Catch, and what they cannot do.

Q-learning trains for 20 000 steps with learning rate 0.5, discount 0.9 and ε-greedy exploration with ε = 0.1, on
positions (a dense table) and on the board of 10 by 5 pixels (a hashed table, with rows for the boards that occur). The
noise is in one pixel (one of 16 levels at random, 150 000 steps) or in all (normal with σ = 0.1, 40 000 steps).
Generalisation: the table and two agents with linear features (learning rate 0.1) train for 40 000 steps with balls from
columns 0, 2 and 4, and are then tested with those from columns 1 and 3. 10 repetitions; the seeds are the same for
every method. Each point of a curve is the mean of 30 greedy evaluation episodes.
"""

import math
from collections.abc import Mapping
from functools import partial
from typing import Any

import numpy as np

from edugym.experiments import How, reporting
from edugym.lessons.dimensionality.figures import (
    boards_figure,
    car_figure,
    costs_figure,
    ever_learned,
    growth,
    join,
    network_figure,
    policy_maps,
    shared_by_column,
    size_sheet,
    stored_networks,
    table_and_network,
    withheld,
)
from edugym.lessons.dimensionality.gym_car import drive, mountain_car
from edugym.lessons.dimensionality.methods import (
    DARKEST,
    GENERAL,
    LEVELS,
    LINEAR,
    N_STEPS,
    NETWORK,
    NUMBERS,
    OFFSET,
    PIXELS,
    POSITIONS,
    SIGMA,
    TABLE,
    TILES,
    Coordinates,
    generalise,
    hashed_dark,
    learn,
    linear,
    network,
    on_board,
    pixels,
    returns_by_column,
    seen,
    steps_to_solve,
    table,
)
from edugym.lessons.dimensionality.networks import METHODS, PPO_IMAGE, STORED, network_claims, train_network
from edugym.lessons.dimensionality.sharing import COLUMN, SMALL
from edugym.lessons.dimensionality.sizes import different_boards, n_weights, new_share, rows_of_table
from edugym.lessons.dimensionality.tasks import COLUMNS, ROWS, TRAINED, WITHHELD, catch
from edugym.lessons.dimensionality.triad import w_to_2w
from edugym.mdp.hashed import Hashed
from edugym.mdp.protocol import Reals
from edugym.plotting.curves import Curves
from edugym.plotting.report import Report
from edugym.plotting.sheet import Sheet
from edugym.results.claims import Above, Below, Claim, Within
from edugym.results.statistics import exactly, mean_interval, paired_difference
from edugym.results.tables import Results

__all__ = [
    "COLUMN",
    "COLUMNS",
    "DARKEST",
    "GENERAL",
    "LEVELS",
    "LINEAR",
    "METHODS",
    "NETWORK",
    "NUMBERS",
    "N_STEPS",
    "OFFSET",
    "PIXELS",
    "POSITIONS",
    "PPO_IMAGE",
    "ROWS",
    "SIGMA",
    "SMALL",
    "STORED",
    "TABLE",
    "TILES",
    "TRAINED",
    "WITHHELD",
    "Coordinates",
    "Hashed",
    "boards_figure",
    "car_figure",
    "catch",
    "compare_sights",
    "costs_figure",
    "different_boards",
    "drive",
    "ever_learned",
    "generalise",
    "growth",
    "hashed_dark",
    "join",
    "learn",
    "linear",
    "mountain_car",
    "n_weights",
    "network",
    "network_claims",
    "network_figure",
    "new_share",
    "on_board",
    "pixels",
    "policy_maps",
    "race",
    "race_networks",
    "report",
    "returns_by_column",
    "rows_of_table",
    "seen",
    "shared_by_column",
    "size_sheet",
    "steps_to_solve",
    "stored_networks",
    "table",
    "table_and_network",
    "train_network",
    "w_to_2w",
    "warm_up",
    "withheld",
]

SLOW, HOPELESS = 150_000, 40_000
"""The training steps with one noisy pixel, and with noise in all."""
REPETITIONS = 10
RANDOM_PLAY = -0.6

ONE_PIXEL, ALL_PIXELS = f"one noisy pixel of {LEVELS} levels", f"noise in all pixels, σ = {SIGMA:g}"


def late(results: Results) -> Reals:
    """Return the mean of the last five evaluations of every run, shape (n_repetitions,)."""
    (label,) = results.methods
    mean: Reals = results.curves(label).iloc[-5:].to_numpy(float).mean(axis=0)
    return mean


def measure(how: How) -> tuple[Any, ...]:
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
    general = generalise(**how())
    tests = {label: returns_by_column(results) for label, results in general.items()}
    return plain, noisy, tests


def judge(plain: Mapping[str, Results], noisy: Mapping[str, Results], tests: Mapping[str, Reals]) -> Report:
    """Return claims and figures."""
    claims = [*size_claims(), *pixel_claims(plain), *noise_claims(plain, noisy), *general_claims(tests)]
    return Report(claims, figures(plain, noisy, tests))


report = reporting(measure, judge, REPETITIONS)
"""Run the experiments of the lesson (see `edugym.experiments.Reporter`)."""


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
            f"2^50 rows; over all images of 150 bytes it would have 10^{math.log10(rows_of_table('rgb')):.0f}",
        ),
        Claim(
            "but while the ball falls, there are no more boards than states: a table needs rows for these only",
            "different boards / states, computed",
            exactly(boards / falling),
            Within(1.0, 1.0),
            f"{boards} boards",
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
            "'a table cannot read pixels' is wrong: it gives a row to each board that occurs",
        ),
        Claim(
            "and catches every ball",
            "greedy return, last five evaluations",
            mean_interval(late(plain[PIXELS])),
            Above(0.99),
        ),
    ]


def noise_claims(plain: Mapping[str, Results], noisy: Mapping[str, Results]) -> list[Claim]:
    """Return the claims on noisy pixels."""
    clean = plain[PIXELS].curves(PIXELS).loc[N_STEPS // 2].to_numpy(float)
    half = noisy[ONE_PIXEL].curves(ONE_PIXEL)
    return [
        Claim(
            f"One noisy pixel slows it: it is behind after {half.index[1]} steps",
            f"greedy return, less that without noise after {N_STEPS // 2}",
            paired_difference(half.iloc[1].to_numpy(float), clean),
            Below(-0.2),
            f"each board has {LEVELS} rows now, and what is learned in one helps none of the others",
        ),
        Claim(
            f"but it gets there, after {SLOW} steps",
            "greedy return, last five evaluations",
            mean_interval(late(noisy[ONE_PIXEL])),
            Above(0.9),
        ),
        Claim(
            "With noise of real numbers every board is new",
            "share of observations never seen before",
            exactly(new_share(pixels(sigma=SIGMA)(0))),
            Above(0.99),
        ),
        Claim(
            f"and a table learns nothing; random play returns {RANDOM_PLAY:g}",
            "greedy return, last five evaluations",
            mean_interval(late(noisy[ALL_PIXELS])),
            Within(RANDOM_PLAY - 0.15, RANDOM_PLAY + 0.15),
        ),
    ]


def general_claims(tests: Mapping[str, Reals]) -> list[Claim]:
    """Return the claims on balls from columns that were withheld in training."""
    seen = f"greedy return, balls from columns {', '.join(map(str, TRAINED))}"
    unseen = f"greedy return, balls from columns {', '.join(map(str, WITHHELD))}"
    return [
        Claim(
            "The table catches all balls as in training",
            seen,
            mean_interval(tests[TABLE][[*TRAINED]].mean(axis=0)),
            Above(0.99),
        ),
        Claim(
            "but it does not generalise: balls from new columns find it as ignorant as at first",
            unseen,
            mean_interval(tests[TABLE][[*WITHHELD]].mean(axis=0)),
            Below(0.0),
            "their rows were never visited",
        ),
        Claim(
            "Linear in the pixels is no way out: it does not learn the balls of training either",
            seen,
            mean_interval(tests[LINEAR][[*TRAINED]].mean(axis=0)),
            Below(0.8),
            "which way to go depends on ball and paddle together, and a sum over pixels cannot say that",
        ),
        Claim(
            "Features that fit do generalise: linear in ball minus paddle, new columns are caught",
            unseen,
            mean_interval(tests[OFFSET][[*WITHHELD]].mean(axis=0)),
            Above(0.95),
            "the knowledge is in the features; a network has to learn it",
        ),
    ]


def figures(plain: Mapping[str, Results], noisy: Mapping[str, Results], tests: Mapping[str, Reals]) -> list[Sheet]:
    """Return the figures: learning curves, sizes of tables, and tests on withheld columns."""
    curves = [Curves(results, label, optimum=1.0) for label, results in {**plain, **noisy}.items()]
    return [Sheet("dimensionality", [curves[:2], curves[2:]]), size_sheet(), withheld(tests), stored_networks()]


def compare_sights(n_steps: int = HOPELESS, repetitions: tuple[int, int] = (30, 5), **how: Any) -> dict[str, Results]:
    """Train a table and a network under every kind of noise.

    Args:
        n_steps: the training steps of each run.
        repetitions: the number of runs of the table, and of the network.
        **how: more arguments of `learn`.

    Returns:
        By a title for each kind of noise, the results of both.
    """
    sights: dict[str, tuple[Any, Any]] = {
        "no noise": (pixels(), seen()),
        ONE_PIXEL: (pixels(levels=LEVELS), seen(levels=LEVELS)),
        ALL_PIXELS: (pixels(sigma=SIGMA, capacity=2 * n_steps), seen(sigma=SIGMA)),
        f"brightness from {DARKEST:g} to 1": (partial(hashed_dark, 2 * n_steps), seen(darkest=DARKEST)),
    }
    of_table, of_network = repetitions
    return {
        title: join(
            [
                learn(hashed, PIXELS, n_steps=n_steps, repetitions=of_table, **how),
                learn(boards, NETWORK, network(), n_steps=n_steps, repetitions=of_network, **how),
            ]
        )
        for title, (hashed, boards) in sights.items()
    }


def race(own: Mapping[str, Any], seen_as: str = "grid", repetitions: int = 5, n_steps: int = N_STEPS) -> Sheet:
    """Train the reader's own agents with balls from three columns, and test them beside the table.

    Args:
        own: by label, functions that make an agent for the board.
        seen_as: what they see: "grid" or "numbers".
        repetitions: the number of runs.
        n_steps: the training steps of each run.
    """
    table_runs = generalise([TABLE], repetitions=repetitions, jobs=1)
    tests = {TABLE: returns_by_column(table_runs[TABLE])}
    for label, make in own.items():
        results = learn(
            catch(seen_as, TRAINED), label, make, n_steps=n_steps, points=2, repetitions=repetitions, jobs=1
        )
        tests[label] = returns_by_column(results, seen_as)
    return withheld(tests)


def race_networks(own: Mapping[str, Any], repetitions: int = 3, n_steps: int = 12_000) -> Sheet:
    """Train the reader's own networks beside that of the lesson, without noise."""
    both = {NETWORK: network(), **own}
    runs = [
        learn(seen(), label, make, n_steps=n_steps, repetitions=repetitions, jobs=1) for label, make in both.items()
    ]
    return table_and_network({"no noise": join(runs)})


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
