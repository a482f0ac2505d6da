"""What is compared with what. To compare with something else, add a contender to a list."""

from collections.abc import Callable
from functools import partial
from typing import Any

import gymnasium
import numpy as np

from benchmarks import agents, catch, objectives, offline, players, student
from benchmarks.contenders import copies, made, steps_of, unwrapped
from benchmarks.measure import Comparison, Contender, Work
from edugym import EpsilonGreedy, QLearning, make_mdp, train
from edugym.mdp.task import table_size
from edugym_course.lessons.exploration.methods import HEIGHTS, METHODS, N_STEPS, compare

ALPHA, GAMMA, EPSILON = 0.1, 0.99, 0.1
FROZEN_LAKE, CLIFF_WALKING, CART_POLE = (
    max(env_id for env_id in gymnasium.registry if env_id.startswith(f"{name}-v"))
    for name in ("FrozenLake", "CliffWalking", "CartPole")
)


def comparisons(quick: bool = False) -> list[Comparison]:
    """All of them; only some of the agents if it should be quick."""
    more = *catch.comparisons(), *players.comparisons(), *objectives.comparisons(), *offline.comparisons()
    return [*training(), *agents.comparisons(quick), *single_steps(), *vector_steps(), *more]


def training() -> list[Comparison]:
    """Learning in a table: the environment, the agent and the loop between them."""
    boulder = tutorial("as a student writes it", student.Boulder, (11, 2))
    high_boulder = tutorial("only ε-greedy, as a student writes it", partial(student.Boulder, 30), (31, 2), N_STEPS)
    golf = tutorial("as a student writes it", student.Golf, (7, 17, 3))
    our_boulder = tutorial("a student's loop, our environment", partial(gymnasium.make, "edugym/Boulder-v0"), (11, 2))
    unit, runs = "training steps", f"runs of {N_STEPS} steps"
    return [
        Comparison("Q-learning on Boulder", unit, trained("Boulder", q_learning), [boulder, our_boulder], 100e6, 300),
        Comparison("a student's own agent on Boulder", unit, trained("Boulder", students_own), [boulder], None, 300),
        Comparison("Q-learning on Golf", unit, trained("Golf", q_learning), [golf], None, 300),
        Comparison("the figure of the exploration lesson", runs, Contender("EduGym", figure), [high_boulder]),
    ]


def single_steps() -> list[Comparison]:
    """One call of `step` from Python."""
    others = {"FrozenLake": FROZEN_LAKE, "CliffWalking": CLIFF_WALKING, "CartPole": CART_POLE}
    students_boulder = Contender("a student's Boulder, which checks nothing", lambda: steps_of(student.Boulder()))
    students_golf = Contender("a student's Golf, which checks nothing", lambda: steps_of(student.Golf()))
    return [
        Comparison(
            "one step, env.unwrapped",
            "steps",
            unwrapped("EduGym's Boulder", "edugym/Boulder-v0"),
            [*(unwrapped(*other) for other in others.items()), students_boulder],
            rate_target=1e6,
        ),
        Comparison(
            "one step, gymnasium.make",
            "steps",
            made("EduGym's Boulder", "edugym/Boulder-v0"),
            [made(*other) for other in others.items()],
        ),
        Comparison(
            "one step of Golf, env.unwrapped", "steps", unwrapped("EduGym's Golf", "edugym/Golf-v0"), [students_golf]
        ),
    ]


def vector_steps() -> list[Comparison]:
    """One call of `step` for many copies."""
    by_size = [
        Comparison(
            f"vector step, {n} {'copies' if n > 1 else 'copy'}",
            "steps",
            copies("EduGym's Boulder", "edugym/Boulder-v0", n),
            [
                copies("FrozenLake, SyncVectorEnv", FROZEN_LAKE, n, "sync"),
                copies("EduGym's Boulder, SyncVectorEnv", "edugym/Boulder-v0", n, "sync"),
                copies("CartPole, its own vector environment", CART_POLE, n),
            ],
            rate_target=50e6 if n == 1024 else None,
        )
        for n in (1, 64, 1024)
    ]
    by_environment = [
        Comparison(
            f"vector step of {name}, 1024 copies",
            "steps",
            copies("EduGym", f"edugym/{name}-v0", 1024),
            [copies("the same, SyncVectorEnv", f"edugym/{name}-v0", 1024, "sync")],
        )
        for name in ("Golf", "MemoryCorridor")
    ]
    return by_size + by_environment


def trained(name: str, make_agent: Callable[[Any], Any]) -> Contender:
    """Training with EduGym; the curve has its hundred points, whose evaluation episodes come on top."""

    def prepare() -> Work:
        mdp = make_mdp(name)
        train(mdp, make_agent(mdp), 10_000)  # compiled now

        def work(n: int) -> int:
            train(mdp, make_agent(mdp), n)
            return n

        return work

    return Contender("EduGym", prepare)


def q_learning(mdp: Any) -> QLearning:
    """The package's Q-learning."""
    return QLearning.create(mdp, learning_rate=ALPHA, discount=GAMMA, exploration=EpsilonGreedy(EPSILON))


def students_own(mdp: Any) -> student.OwnAgent:
    """The same as a class of a student's own."""
    return student.OwnAgent(np.zeros(table_size(mdp)), ALPHA, GAMMA, EPSILON)


def tutorial(
    name: str, make: Callable[[], gymnasium.Env[Any, Any]], shape: tuple[int, ...], unit: int = 1
) -> Contender:
    """Training as in a tutorial, with a table of this shape, by units of so many steps."""

    def prepare() -> Work:
        env = make()

        def work(n: int) -> int:
            student.q_learning(env, np.zeros(shape), n * unit, ALPHA, GAMMA, EPSILON)
            return n

        return work

    return Contender(name, prepare)


def figure() -> Work:
    """All runs of the figure, on one core, with their curves and the visits of each state."""

    def work(n: int) -> int:
        repetitions = max(1, n // (len(HEIGHTS) * len(METHODS)))
        for height in HEIGHTS:
            compare(height, repetitions=repetitions, jobs=1)
        return len(HEIGHTS) * len(METHODS) * repetitions

    return work
