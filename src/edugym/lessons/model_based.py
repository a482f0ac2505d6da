"""Model-based learning (lesson 9): planning in Supermarket, with a model that is learned or given, right or wrong.

Every method trains for 10 000 steps with discount 0.99, learning rate 1 and ε-greedy exploration with ε = 0.1, except
for R-max, which needs neither rate nor ε. Dyna-Q and prioritised sweeping plan with 10 updates a step (Dyna-50 with
50), R-max with up to 1 000. 60 repetitions (100 of the remedies); the seeds are the same for every method.

The given model has wrong rewards where `noise` is above 0: each repetition has a layout of its own, which draws the
errors, the same for every method; 24 repetitions. With a given model discount is 0.95.

"Final" is the return of the last greedy evaluation episode. A policy that never gets to the exit returns -300 or less.
The best way returns 95.

Time budgets (`step_timeout` and `planning_seconds`) are not compared here: how much an agent plans in a millisecond
differs from machine to machine.
"""

import math
from collections.abc import Callable, Mapping
from functools import cache, partial
from typing import Any, NamedTuple

import gymnasium
import numpy as np

from edugym.agents.dyna_q import DynaQ
from edugym.agents.prioritised_sweeping import PrioritisedSweeping
from edugym.agents.q_learning import QLearning
from edugym.agents.r_max import RMax
from edugym.agents.strategies import LinearDecay, ScheduledEpsilonGreedy
from edugym.envs.supermarket import Supermarket
from edugym.exact.model import finite_model
from edugym.exact.tables import FiniteModel
from edugym.exact.value_iteration import value_iteration
from edugym.experiments import How, reporting
from edugym.mdp.protocol import Reals
from edugym.plotting.curves import Curves
from edugym.plotting.lines import Lines
from edugym.plotting.report import Report
from edugym.plotting.sheet import Sheet
from edugym.results.claims import Above, Below, Claim, Expectation, Within
from edugym.results.statistics import Interval, mean_interval, paired_difference, proportion_interval, share_interval
from edugym.results.tables import Results
from edugym.training.repeat import repeat

N_STEPS = 10_000
POINTS = 40
EARLY = 2_000
"""The steps in which planning has its lead; after them R-max is done."""
REPETITIONS = 60
DISCOUNT = 0.99
PLANNING_DISCOUNT = 0.95
"""The discount with a given model."""
LEARNING_RATE = 1.0
EPSILON = 0.1
OPTIMUM = 95.0
LOST = -300.0
"""A policy that ends returns more, since it visits no state twice."""
NOISES = (0.0, 0.25, 0.5, 1.0, 1.5)
WRONG = 1.5
"""The noise of the model with which agents learn."""

Q_LEARNING, DYNA_10, DYNA_50, SWEEPING, R_MAX = "Q-learning", "Dyna-10", "Dyna-50", "prioritised sweeping", "R-max"
MORE_RANDOM, DECAYING = "Dyna-10, ε = 0.5", "Dyna-10, ε from 1 to 0.02"


def make(
    kind: Any,
    environment: Any,
    *,
    epsilon: tuple[float, float] = (EPSILON, EPSILON),
    given: bool = False,
    learning_rate: float = LEARNING_RATE,
    **settings: Any,
) -> Any:
    """Make an ε-greedy agent for an environment.

    Args:
        kind: its class.
        environment: the environment.
        epsilon: ε at the start and at the end of training. (A constant ε is a schedule too: that spares the compiler
            another agent.)
        given: whether it gets the model of the environment, errors included, in place of learning one.
        learning_rate: α.
        **settings: more settings of the agent.
    """
    exploration = ScheduledEpsilonGreedy.create(LinearDecay(*epsilon, N_STEPS))
    model = {"model": environment.unwrapped.mdp.distorted(exact_model())} if given else {}
    discount = PLANNING_DISCOUNT if given else DISCOUNT
    how: dict[str, Any] = {"exploration": exploration, "learning_rate": learning_rate, "discount": discount}
    return kind.create(environment, **how, **model, **settings)


LEARNED: Mapping[str, Callable[[Any], Any]] = {
    Q_LEARNING: partial(make, QLearning),
    DYNA_10: partial(make, DynaQ, planning_steps=10),
    DYNA_50: partial(make, DynaQ, planning_steps=50),
    SWEEPING: partial(make, PrioritisedSweeping, planning_steps=10),
    R_MAX: partial(RMax.create, discount=DISCOUNT),
}
REMEDIES: Mapping[str, Callable[[Any], Any]] = {
    MORE_RANDOM: partial(make, DynaQ, planning_steps=10, epsilon=(0.5, 0.5)),
    DECAYING: partial(make, DynaQ, planning_steps=10, epsilon=(1.0, 0.02)),
}
SLOW_DYNA = "Dyna-10, learning rate 0.1"
GIVEN: Mapping[str, Callable[[Any], Any]] = {
    SWEEPING: partial(make, PrioritisedSweeping, given=True, planning_steps=1_000),
    DYNA_10: partial(make, DynaQ, given=True, planning_steps=10),
    SLOW_DYNA: partial(make, DynaQ, given=True, planning_steps=10, learning_rate=0.1),
}
"""Agents with a given model: sweeping looks at all that can happen (descriptive), Dyna draws samples (generative)."""


@cache
def exact_model() -> FiniteModel:
    """Return the exact model of the supermarket, which all layouts share."""
    return finite_model(Supermarket.create())


def compare(methods: Mapping[str, Any], *, noise: float = 0.0, n_steps: int = N_STEPS, **how: Any) -> Results:
    """Train several methods: one panel of the figure.

    Args:
        methods: by label, functions that make an agent for an environment.
        noise: the standard deviation of the errors in the rewards of a given model.
        n_steps: the training steps of each run.
        **how: more arguments of `edugym.training.repeat`, such as `repetitions`, `seed` and `jobs`.
    """
    every = max(n_steps // POINTS, 1)
    return repeat("Supermarket", methods, n_steps, parameters={"noise": noise}, evaluate_every=every, **how)


def with_right_model(makers: Mapping[str, Callable[[Any], Any]]) -> dict[str, Any]:
    """Make agents with the right model, once for all repetitions, of which each gets a copy."""
    environment = gymnasium.make("edugym/Supermarket-v0")
    return {label: maker(environment) for label, maker in makers.items()}


def at(results: Results, method: str, step: int) -> Reals:
    """Return the evaluation of every run after a number of steps, shape (n_repetitions,)."""
    values: Reals = results.curves(method).loc[step].to_numpy(float)
    return values


def early(results: Results, method: str) -> Reals:
    """Return the mean of the evaluations in the first steps of every run, shape (n_repetitions,)."""
    mean: Reals = results.curves(method).loc[:EARLY].to_numpy(float).mean(axis=0)
    return mean


def difference(one: Results, method: str, other: Results, compared: str) -> Interval:
    """Return the final return of a method less that of another one, paired by the repetitions that both have."""
    returns, others = one.final(method), other.final(compared)
    shared = min(len(returns), len(others))
    return paired_difference(returns[:shared], others[:shared])


class Plan(NamedTuple):
    """What became of a policy that was planned with a wrong model.

    Attributes:
        total: its return in the supermarket itself.
        bumps: whether it walks into the same wall for ever.
    """

    total: float
    bumps: bool

    @property
    def ends(self) -> bool:
        """Whether it gets to the exit."""
        return self.total > LOST


def follow_plan(noise: float, layout_seed: int, discount: float = PLANNING_DISCOUNT) -> Plan:
    """Plan by value iteration with the model of a noise and layout, and follow the plan in the supermarket itself."""
    task = Supermarket.create(noise, layout_seed=layout_seed)
    model = exact_model()
    chosen = value_iteration(task.distorted(model), discount, tolerance=1e-6).Q.argmax(axis=1)
    s, total = int(model.initial.argmax()), 0.0
    for _ in range(task.max_steps):
        before = s
        total += float(model.rewards[s, chosen[s], 0])
        s = int(model.successors[s, chosen[s], 0])
        if model.terminal[s] or s == before:
            break
    bumps = not model.terminal[s] and s == before
    return Plan(-float(task.max_steps) if bumps else total, bumps)


def measure(how: How) -> tuple[Any, ...]:
    """Run the experiments."""
    learned = compare(LEARNED, **how("learned"))
    more = {"repetitions": 5 * how.repetitions // 3}  # final returns differ much from run to run
    remedied = compare({DYNA_10: LEARNED[DYNA_10], **REMEDIES}, **how("remedies", **more))
    fewer: dict[str, Any] = {"repetitions": max(2 * how.repetitions // 5, 2)}  # the effects of errors are large
    right = compare(with_right_model(GIVEN), **how("noise_0", **fewer))
    wrong = compare(GIVEN, noise=WRONG, **how(f"noise_{WRONG:g}", **fewer))
    whole = {SWEEPING: partial(make, PrioritisedSweeping, given=True, planning_steps=math.inf)}
    at_once = compare(with_right_model(whole), n_steps=1, **how(**fewer))
    layouts = sorted(int(seed) for seed in wrong.table["layout_seed"].unique())
    plans = {noise: [follow_plan(noise, seed) for seed in layouts] for noise in NOISES}
    return learned, remedied, right, wrong, at_once, plans


def judge(
    learned: Results,
    remedied: Results,
    right: Results,
    wrong: Results,
    at_once: Results,
    plans: Mapping[float, list[Plan]],
) -> Report:
    """Return claims and figures."""
    claims = [
        *speed_claims(learned),
        *end_claims(learned, remedied),
        *remedy_claims(learned, remedied),
        *given_claims(right, at_once),
        *plan_claims(plans),
        *noise_claims(right, wrong),
    ]
    return Report(claims, figures(learned, remedied, right, wrong, plans))


report = reporting(measure, judge, REPETITIONS)
"""Run the experiments of the lesson (see `edugym.experiments.Reporter`)."""


def speed_claims(learned: Results) -> list[Claim]:
    """Return the claims on the real steps that learning takes."""
    return [
        Claim(
            f"{method} learns in fewer steps than Q-learning",
            f"greedy return, mean over the first {EARLY} steps, less that of Q-learning",
            paired_difference(early(learned, method), early(learned, Q_LEARNING)),
            Above(0.0),
            "one real step is followed by many updates from memory" if method == DYNA_10 else "",
        )
        for method in (DYNA_10, DYNA_50, SWEEPING)
    ]


def end_claims(learned: Results, remedied: Results) -> list[Claim]:
    """Return the claims on where more planning ends."""
    return [
        *(
            Claim(
                f"{method} ends below Q-learning, which does not plan",
                "final return less that of Q-learning",
                difference(learned, method, learned, Q_LEARNING),
                Below(0.0),
                "it exploits a model that has not seen the whole shop; the paper shows the quick start only",
            )
            for method in (DYNA_10, DYNA_50, SWEEPING)
        ),
        *(
            Claim(
                f"{more} planning does not replace exploration: {method} ends below {DECAYING}",
                f"final return less that of {DECAYING}",
                difference(learned, method, remedied, DECAYING),
                Below(0.0),
                reason,
            )
            for more, method, reason in (
                ("Five times as much", DYNA_50, "planning invents no knowledge: one of the items was never seen"),
                ("Better", SWEEPING, "10 updates where they matter most do more than 10 at random, too soon"),
            )
        ),
    ]


def remedy_claims(learned: Results, remedied: Results) -> list[Claim]:
    """Return the claims on exploring more, and on planning to explore."""
    return [
        *(
            Claim(
                f"More exploration mends it: {method} ends above {DYNA_10} with ε = {EPSILON:g}",
                "final return, difference",
                difference(remedied, method, remedied, DYNA_10),
                Above(0.0),
            )
            for method in (DECAYING, MORE_RANDOM)
        ),
        Claim(
            f"Planning to explore mends it: R-max is at the optimum after {EARLY} steps",
            "share of runs with return 95",
            share_interval(at(learned, R_MAX, EARLY) >= OPTIMUM),
            Above(0.8),
            "what it does not know seems worth going there",
        ),
        *(
            Claim(
                f"{method} is not at the optimum by then",
                f"share of runs with return 95 after {EARLY} steps",
                share_interval(at(learned, method, EARLY) >= OPTIMUM),
                Below(0.5),
            )
            for method in (Q_LEARNING, DYNA_10, DYNA_50, SWEEPING)
        ),
    ]


def given_claims(right: Results, at_once: Results) -> list[Claim]:
    """Return the claims on planning with the right model."""
    return [
        Claim(
            "With the right model given, planning until nothing changes finds the best way before the first step",
            "share of runs with return 95 after one step",
            at_once.share(SWEEPING, OPTIMUM),
            Above(0.8),
            "dynamic programming: nothing is left to explore",
        ),
        Claim(
            "Samples of a generative model are enough: Dyna-10 with the right model given ends with 95",
            "share of runs that end with 95",
            right.share(DYNA_10, OPTIMUM),
            Above(0.8),
            f"it takes {N_STEPS * 10} samples, where sweeping over the descriptive model is done at once",
        ),
    ]


def plan_claims(plans: Mapping[float, list[Plan]]) -> list[Claim]:
    """Return the claims on plans that are made with a wrong model."""
    lost = {noise: [plan for plan in made if not plan.ends] for noise, made in plans.items()}
    share = {noise: proportion_interval(len(lost[noise]), len(plans[noise])) for noise in NOISES}
    statements: dict[float, tuple[str, Expectation]] = {
        0.5: ("With noise 0.5 hardly a plan fails", Below(0.2)),
        1.0: ("With noise 1 a few plans never get to the exit", Within(0.0, 0.5)),
        1.5: ("With noise 1.5 most plans never get to the exit", Above(0.5)),
    }
    return [
        *(
            Claim(statement, f"share of layouts, discount {PLANNING_DISCOUNT:g}", share[noise], expected)
            for noise, (statement, expected) in statements.items()
        ),
        Claim(
            "The reason: a wall that seems to pay for each bump is farmed for ever",
            f"share of the plans that never end, noise {WRONG:g}",
            share_interval([plan.bumps for plan in lost[WRONG]]),
            Above(0.5),
            "an error above 1 makes a step without end worth more than the exit",
        ),
    ]


def noise_claims(right: Results, wrong: Results) -> list[Claim]:
    """Return the claims on agents that learn with a wrong model."""
    return [
        *(
            Claim(
                f"Noise {WRONG:g} in the given model ruins {method}",
                "final return less that without noise",
                difference(wrong, method, right, method),
                Below(-100.0),
                reason,
            )
            for method, reason in (
                (SWEEPING, "all that it learns comes from the model"),
                (DYNA_10, "with learning rate 1 each imagined reward overwrites what was lived"),
            )
        ),
        Claim(
            "With learning rate 0.1 Dyna-10 gets over it in most runs: it loses less than 50",
            "share of runs",
            share_interval(wrong.final(SLOW_DYNA) - right.final(SLOW_DYNA) > -50.0),
            Above(0.7),
            "where it walks, real steps are more frequent than imagined ones, and they win",
        ),
    ]


def figures(
    learned: Results, remedied: Results, right: Results, wrong: Results, plans: Mapping[float, list[Plan]]
) -> list[Sheet]:
    """Return the figures: learning curves, remedies, and the share of plans that fail."""
    y_range = (0.0, 100.0)
    soft = value_iteration(exact_model(), epsilon=EPSILON).start
    greedy = Curves(learned, "learned model", optimum=OPTIMUM, y_range=y_range)
    exploring = Curves(learned, "while exploring", "training_return", soft_optimum=soft, y_range=y_range)
    better = Curves(remedied, "more exploration", optimum=OPTIMUM, y_range=y_range)
    titles = {"given model, right": right, f"given model, noise {WRONG:g}": wrong}
    return [
        Sheet("model_based", [[greedy, exploring]]),
        Sheet("remedies", [[better]]),
        Sheet("given_model", [[Curves(results, title, optimum=OPTIMUM) for title, results in titles.items()]]),
        Sheet("wrong_plans", [[plan_lines(plans)]]),
    ]


def plan_lines(plans: Mapping[float, list[Plan]]) -> Lines:
    """Return the share of plans that never end, against the noise of the model."""
    shares = {noise: mean_interval([not plan.ends for plan in made]).estimate for noise, made in plans.items()}
    return Lines(
        np.array(NOISES),
        {f"discount {PLANNING_DISCOUNT:g}": np.array([shares[noise] for noise in NOISES])},
        "plans by value iteration with a wrong model",
        "noise in the rewards of the model",
        "share that never get to the exit",
    )
