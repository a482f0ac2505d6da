"""Dimensionality (lesson 4): tables over the images of Catch, and what they cannot do.

Q-learning trains for 20 000 steps with learning rate 0.5, discount 0.9 and ε-greedy exploration with ε = 0.1, on
positions (a dense table) and on the board of 10 by 5 pixels (a hashed table, with rows for the boards that occur). The
noise is in one pixel (one of 16 levels at random, 150 000 steps) or in all (normal with σ = 0.1, 40 000 steps).
Generalisation: the table and two agents with linear features (learning rate 0.1) train for 40 000 steps with balls from
columns 0, 2 and 4, and are then tested with those from columns 1 and 3. 10 repetitions; the seeds are the same for
every method. Each point of a curve is the mean of 30 greedy evaluation episodes.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from edugym.agents.linear_q_learning import LinearQLearning
from edugym.agents.q_learning import QLearning
from edugym.agents.strategies import EpsilonGreedy
from edugym.envs.catch import Catch
from edugym.exact.model import finite_model
from edugym.experiments import How, reporting
from edugym.lessons.dimensionality.boards import Offset
from edugym.lessons.dimensionality.tasks import COLUMNS, ROWS, TRAINED, WITHHELD, catch
from edugym.mdp.hashed import Hashed
from edugym.mdp.in_place import in_place
from edugym.mdp.noisy_observation import NoisyObservation
from edugym.mdp.protocol import Reals
from edugym.mdp.tabular import table_sizes
from edugym.plotting.curves import Curves
from edugym.plotting.lines import Lines
from edugym.plotting.report import Report
from edugym.plotting.sheet import Sheet
from edugym.results.claims import Above, Below, Claim, Within
from edugym.results.statistics import exactly, mean_interval, paired_difference
from edugym.results.tables import Results
from edugym.training.repeat import repeat
from edugym.training.train import train

N_STEPS = 20_000
SLOW, HOPELESS = 150_000, 40_000
"""The training steps with one noisy pixel, and with noise in all."""
REPETITIONS = 10
LEARNING_RATE, LINEAR_RATE = 0.5, 0.1
DISCOUNT = 0.9
EPSILON = 0.1
LEVELS, SIGMA = 16, 0.1
TEST_EPISODES = 20
RANDOM_PLAY = -0.6

POSITIONS, PIXELS = "positions, dense table", "pixels, hashed table"
ONE_PIXEL, ALL_PIXELS = f"one noisy pixel of {LEVELS} levels", f"noise in all pixels, σ = {SIGMA:g}"
TABLE, LINEAR, OFFSET = "table", "linear in the pixels", "linear in ball minus paddle"


def hashed(levels: int, sigma: float, capacity: int, layout_seed: int) -> Hashed:
    """Return the task with pixels as the rows of a hashed table; Catch has no layout."""
    return Hashed.create(NoisyObservation.create(catch("grid"), levels, sigma), capacity)


def pixels(*, levels: int = 0, sigma: float = 0.0, capacity: int = 10_000) -> Callable[[int], Hashed]:
    """Return a function that makes the task with pixels as the rows of a hashed table, a new table for each run.

    Args:
        levels: of the noise in the first pixel; 0 for none.
        sigma: of the noise in all pixels; 0 for none.
        capacity: of the table.
    """
    return partial(hashed, levels, sigma, capacity)


def learn(task: Any, label: str, make: Any = None, *, n_steps: int = N_STEPS, points: int = 20, **how: Any) -> Results:
    """Train an agent, by default Q-learning with a table.

    Args:
        task: the task, or a function of a layout seed that makes it.
        label: the name of the method.
        make: a function that makes the agent for an environment.
        n_steps: the training steps of each run.
        points: the number of points of the learning curve.
        **how: more arguments of `edugym.training.repeat`, such as `repetitions`, `seed` and `jobs`.
    """
    exploration = EpsilonGreedy(EPSILON)
    make = make or partial(QLearning.create, learning_rate=LEARNING_RATE, discount=DISCOUNT, exploration=exploration)
    return repeat(task, {label: make}, n_steps, evaluate_every=n_steps // points, evaluation_episodes=30, **how)


def linear(features: Any = None) -> Callable[[Any], Any]:
    """Return a function that makes an agent with linear features, by default the pixels themselves."""
    settings = {"learning_rate": LINEAR_RATE, "discount": DISCOUNT, "exploration": EpsilonGreedy(EPSILON)}
    return partial(LinearQLearning.create, **settings, **({} if features is None else {"features": features}))


def generalise(**how: Any) -> dict[str, Results]:
    """Train the table and the linear agents with balls from some columns; arguments as in `learn`."""
    agents = {
        TABLE: ("vectorised", None),
        LINEAR: ("grid", linear()),
        OFFSET: ("grid", linear(Offset.create(ROWS, COLUMNS))),
    }
    return {
        label: learn(catch(seen, TRAINED), label, make, n_steps=2 * N_STEPS, points=4, **how)
        for label, (seen, make) in agents.items()
    }


def returns_by_column(results: Results) -> Reals:
    """Return the mean greedy return of every run with balls from each column, shape (COLUMNS, n_repetitions)."""
    (label,) = results.methods
    tasks = [catch("vectorised" if label == TABLE else "grid", [column]) for column in range(COLUMNS)]
    return np.array(
        [
            [
                train(task, agent, 1, evaluation_episodes=TEST_EPISODES, seed=repetition).returns[0]
                for repetition, agent in results.complete_agents(label).items()
            ]
            for task in tasks
        ]
    )


def late(results: Results) -> Reals:
    """Return the mean of the last five evaluations of every run, shape (n_repetitions,)."""
    (label,) = results.methods
    mean: Reals = results.curves(label).iloc[-5:].to_numpy(float).mean(axis=0)
    return mean


def new_share(task: Any, n_steps: int = 2_000) -> float:
    """Return the share of the observations of random play that were never seen before."""
    rng = np.random.default_rng(0)
    state = task.initial(rng)
    for _ in range(n_steps):
        task.observation(state, rng)
        state = task.transition(state, int(rng.integers(3)), rng)
        if task.terminal(state):
            state = task.initial(rng)
    return int(task.used) / n_steps


def different_boards() -> tuple[int, int]:
    """Return the numbers of states in which the ball still falls, and of different boards among them."""
    task, rng = Catch.create(ROWS, COLUMNS), np.random.default_rng(0)
    falling = [state for state in finite_model(task).states if not task.terminal(state)]
    return len(falling), len({np.asarray(task.observation(state, rng)).tobytes() for state in falling})


def rows_of_table(observation_type: str, rows: int = ROWS, columns: int = COLUMNS) -> int:
    """Return the number of rows of a dense table over all observations of a type."""
    space = Catch.create(rows, columns, observation_type).observation_space
    if observation_type == "vectorised":
        return math.prod(table_sizes(space))
    levels = 2 if observation_type == "grid" else 256
    return int(levels ** math.prod(space.shape or ()))


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
    sizes = range(4, 11)
    bits = {
        seen: np.array([math.log10(rows_of_table(seen, 2 * n, n)) for n in sizes])
        for seen in ("vectorised", "grid", "rgb")
    }
    lines = Lines(
        np.array(sizes, float),
        bits,
        "dense tables",
        "columns (of twice as many rows)",
        "log10 of the rows of the table",
        log=True,
    )
    return [
        Sheet("dimensionality", [curves[:2], curves[2:]]),
        Sheet("table_sizes", [[lines]]),
        Sheet("generalisation", [[withheld_lines(tests)]]),
    ]


def withheld_lines(tests: Mapping[str, Reals]) -> Lines:
    """Return the mean return on balls from each column, of which some were withheld in training."""
    means = {label: by_column.mean(axis=1) for label, by_column in tests.items()}
    title = f"trained with balls from columns {', '.join(map(str, TRAINED))}"
    return Lines(np.arange(float(COLUMNS)), means, title, "column of the ball", "return (greedy)")
