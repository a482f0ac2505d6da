"""The agents of lesson 4 on Catch: tables, linear values, and a network, on what they see."""

import copy
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.agents.dqn import DQN
from edugym.agents.linear_q_learning import LinearQLearning
from edugym.agents.q_learning import QLearning
from edugym.agents.semi_gradient_sarsa import SemiGradientSARSA
from edugym.agents.strategies import EpsilonGreedy
from edugym.agents.tile_coding import TileCoding
from edugym.envs.catch import Catch, Fall
from edugym.experiments.repeat import repeat
from edugym.experiments.results.tables import Results
from edugym.mdp.brightness import Brightness
from edugym.mdp.hashed import Hashed
from edugym.mdp.in_place import in_place
from edugym.mdp.protocol import Random, Reals
from edugym.mdp.wrapper import wrapper
from edugym.training.train import train
from edugym_course.lessons.dimensionality.boards import Offset
from edugym_course.lessons.dimensionality.shuffled import in_a_row
from edugym_course.lessons.dimensionality.tasks import COLUMNS, ROWS, TRAINED, catch, darkened, noisy

N_STEPS = 20_000
LEARNING_RATE, LINEAR_RATE, TILE_RATE = 0.5, 0.1, 0.5
NETWORK_RATE, HIDDEN = 1e-3, 64
DISCOUNT = 0.9
EPSILON = 0.1
LEVELS, SIGMA, DARKEST = 16, 0.1, 0.4
TEST_EPISODES = 20

POSITIONS, PIXELS = "table of positions", "table of boards"
TABLE, LINEAR, OFFSET = "table", "linear in the pixels", "linear in ball minus paddle"
TILES, NETWORK, NUMBERS = "tile coding of the positions", "DQN on pixels", "DQN on the positions"


@wrapper
class Coordinates(NamedTuple):
    """Catch seen as three numbers from 0 to 1: column and row of the ball, and column of the paddle.

    Attributes:
        mdp: the task.
        rows: of the board.
        columns: of the board.
    """

    mdp: Any
    rows: int
    columns: int

    @property
    def observation_space(self) -> spaces.Space[Any]:
        """Three numbers."""
        return spaces.Box(0.0, 1.0, (3,), np.float64)

    def observation(self, state: Any, rng: Random) -> Any:
        """The three numbers."""
        numbers = np.empty(3)
        self.observe_into(state, rng, numbers)
        return numbers

    def observe_into(self, state: Any, rng: Random, out: Any) -> None:
        """The same, written into `out`."""
        out[0] = state.ball_x / (self.columns - 1)
        out[1] = state.ball_y / (self.rows - 1)
        out[2] = state.paddle_x / (self.columns - 1)


def seen(levels: int = 0, sigma: float = 0.0, darkest: float = 1.0) -> Any:
    """Return the task with noise in one pixel, noise in all, and a brightness from `darkest` to 1; by default clean."""
    return Brightness.create(noisy(levels, sigma), darkest, 1.0)


def hashed(levels: int, sigma: float, capacity: int, layout_seed: int) -> Hashed:
    """Return the task with pixels as the rows of a hashed table; Catch has no layout."""
    return Hashed.create(noisy(levels, sigma), capacity)


def hashed_dark(capacity: int, layout_seed: int) -> Hashed:
    """Return the darkened task with pixels as the rows of a hashed table."""
    return Hashed.create(darkened(), capacity)


def pixels(*, levels: int = 0, sigma: float = 0.0, capacity: int = 10_000) -> Callable[[int], Hashed]:
    """Return a function that makes the task with pixels as the rows of a hashed table, a new table for each run.

    Args:
        levels: of the noise in the first pixel; 0 for none.
        sigma: of the noise in all pixels; 0 for none.
        capacity: of the table.
    """
    return partial(hashed, levels, sigma, capacity)


def table(**settings: Any) -> Callable[[Any], Any]:
    """Return a function that makes Q-learning with the lesson's settings, or others."""
    default = {"learning_rate": LEARNING_RATE, "discount": DISCOUNT, "exploration": EpsilonGreedy(EPSILON)}
    return partial(QLearning.create, **{**default, **settings})


def linear(features: Any = None, **settings: Any) -> Callable[[Any], Any]:
    """Return a function that makes an agent with linear features, by default the pixels themselves."""
    default = {"learning_rate": LINEAR_RATE, "discount": DISCOUNT, "exploration": EpsilonGreedy(EPSILON)}
    return partial(
        LinearQLearning.create, **{**default, **settings}, **({} if features is None else {"features": features})
    )


def tiles() -> Callable[[Any], Any]:
    """Return a function that makes semi-gradient SARSA with tile coding of the positions."""
    coding = TileCoding.create(catch_numbers(), tiles=[2, 4, 2], tilings=8)
    settings = {"learning_rate": TILE_RATE, "discount": DISCOUNT, "exploration": EpsilonGreedy(EPSILON)}
    return partial(SemiGradientSARSA.create, features=coding, **settings)


def network(kind: Any = DQN, **settings: Any) -> Callable[[Any], Any]:
    """Return a function that makes DQN, or a class like it, with the lesson's settings, or others."""
    default = {
        "hidden": HIDDEN,
        "learning_rate": NETWORK_RATE,
        "discount": DISCOUNT,
        "exploration": EpsilonGreedy(EPSILON),
        "learn_from": 200,
        "copy_every": 100,
    }
    return partial(kind.create, **{**default, **settings})


def catch_numbers(columns: Sequence[int] = range(COLUMNS)) -> Coordinates:
    """Return the task seen as three numbers, with balls from some columns."""
    return Coordinates(catch("grid", columns), ROWS, COLUMNS)


def learn(task: Any, label: str, make: Any = None, *, n_steps: int = N_STEPS, points: int = 20, **how: Any) -> Results:
    """Train an agent, by default Q-learning with a table.

    Args:
        task: the task, or a function of a layout seed that makes it.
        label: the name of the method.
        make: a function that makes the agent for an environment.
        n_steps: the training steps of each run.
        points: the number of points of the learning curve.
        **how: more arguments of `edugym.experiments.repeat`, such as `repetitions`, `seed` and `jobs`.
    """
    every = max(n_steps // points, 1)
    return repeat(task, {label: make or table()}, n_steps, evaluate_every=every, evaluation_episodes=30, **how)


GENERAL: Mapping[str, tuple[str, Callable[[], Any]]] = MappingProxyType(
    {
        TABLE: ("vectorised", table),
        LINEAR: ("grid", linear),
        TILES: ("numbers", tiles),
        OFFSET: ("grid", lambda: linear(Offset.create(ROWS, COLUMNS))),
        NETWORK: ("grid", network),
        NUMBERS: ("numbers", lambda: network(learning_rate=3e-3)),
    }
)
"""What is tested on withheld columns: by label, what the agent sees, and what returns the function that makes it."""


def thrown(what: str, columns: Sequence[int]) -> Any:
    """Return the task with balls from some columns, seen as in `GENERAL`, or as "row"."""
    if what == "row":
        return in_a_row(catch("grid", columns))
    return catch_numbers(columns) if what == "numbers" else catch(what, columns)


def generalise(labels: Sequence[str] = (TABLE, LINEAR, OFFSET), **how: Any) -> dict[str, Results]:
    """Train some of `GENERAL` with balls from three columns; arguments as in `learn`."""
    how = {"n_steps": 2 * N_STEPS, "points": 4, **how}
    return {
        label: learn(thrown(what, TRAINED), label, make(), **how)
        for label, (what, make) in GENERAL.items()
        if label in labels
    }


def returns_by_column(results: Results, what: str | None = None) -> Reals:
    """Return the mean greedy return of every run with balls from each column, shape (COLUMNS, n_repetitions).

    Args:
        results: of one method.
        what: what it sees; by default as `GENERAL` says.
    """
    (label,) = results.methods
    agents = results.complete_agents(label).items()
    tasks = [thrown(what or GENERAL[label][0], [column]) for column in range(COLUMNS)]
    how: dict[str, Any] = {"n_steps": 1, "evaluation_episodes": TEST_EPISODES}  # a copy takes that step
    return np.array(
        [[train(task, copy.deepcopy(agent), seed=i, **how).returns[0] for i, agent in agents] for task in tasks]
    )


def greedy_action(agent: Any, what: str, state: Any, rng: Random) -> int:
    """Return what an agent does in a state without exploring."""
    if what == "vectorised":
        return int(agent.greedy(int(np.ravel_multi_index(state, (COLUMNS, ROWS, COLUMNS))), rng))
    task = thrown(what, range(COLUMNS))
    return int(agent.greedy(np.ravel(task.observation(state, rng)).astype(float), rng))


def play_on(agent: Any, what: str, state: Any, rng: Random) -> tuple[int, bool]:
    """Return what an agent, greedy, does in a state, and whether it then catches the ball."""
    task = Catch.create(ROWS, COLUMNS, "vectorised")
    first = greedy_action(agent, what, state, rng)
    state = task.transition(state, first, rng)
    while not task.terminal(state):
        state = task.transition(state, greedy_action(agent, what, state, rng), rng)
    return first, bool(state.ball_x == state.paddle_x)


def paddle_ends(results: Results, column: int) -> list[int]:
    """Return, for every run of a method of `GENERAL`, where the paddle is, greedy, when a ball from a column lands."""
    (label,) = results.methods
    task, rng = Catch.create(ROWS, COLUMNS, "vectorised"), np.random.default_rng(0)
    ends = []
    for agent in results.complete_agents(label).values():
        state = Fall(column, 0, COLUMNS // 2)
        while not task.terminal(state):
            state = task.transition(state, greedy_action(agent, GENERAL[label][0], state, rng), rng)
        ends.append(state.paddle_x)
    return ends


def on_board(columns: int, kind: str) -> Any:
    """Return the task on a board with so many columns, and twice as many rows."""
    return in_place(Catch.create(2 * columns, columns, kind))


def steps_to_solve(columns: int, *, hidden: int = HIDDEN, **how: Any) -> dict[str, float]:
    """Return, for a table and a network, the steps until the greedy return is 0.99: the median over the runs.

    Args:
        columns: of the board.
        hidden: the hidden units of the network.
        **how: arguments of `learn`.
    """
    both = {TABLE: ("vectorised", table()), NETWORK: ("grid", network(hidden=hidden))}
    found = {}
    for label, (kind, make) in both.items():
        reached = learn(on_board(columns, kind), label, make, points=40, **how).curves(label) >= 0.99
        found[label] = float(np.median(np.where(reached.any(), reached.idxmax(), np.inf)))
    return found
