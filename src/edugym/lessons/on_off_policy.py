"""On- and off-policy learning (lesson 2): Q-learning, SARSA and expected SARSA at the edge of a cliff.

On Roadrunner, with its defaults (W = 10, R = -100) and discount 1, every method trains for 200 000 steps with ε-greedy
exploration: ε = 0.1 and learning rate 0.03; in the stop zone, ε = 0.2 and learning rate 0.1. 30 repetitions; the seeds
are the same for every method. "Greedy" is the return of the last evaluation episode. "Online" is the mean return of the
training episodes in the second half of training, explored as the method does.
"""

from collections.abc import Callable, Mapping
from functools import partial
from types import MappingProxyType
from typing import Any

import numpy as np

from edugym.agents.expected_sarsa import ExpectedSARSA
from edugym.agents.q_learning import QLearning
from edugym.agents.sarsa import SARSA
from edugym.agents.strategies import EpsilonGreedy, LinearDecay, ScheduledEpsilonGreedy
from edugym.envs.roadrunner import Roadrunner
from edugym.exact.model import finite_model
from edugym.exact.policy_evaluation import policy_evaluation
from edugym.exact.tables import FiniteModel
from edugym.exact.value_iteration import value_iteration
from edugym.experiments import How, reporting
from edugym.mdp.protocol import Reals
from edugym.plotting.curves import Curves
from edugym.plotting.lines import Lines
from edugym.plotting.report import Report
from edugym.plotting.sheet import Sheet
from edugym.results.claims import Above, Below, Claim, Within
from edugym.results.statistics import Interval, exactly, mean_interval, paired_difference, share_interval
from edugym.results.tables import Results
from edugym.training.repeat import repeat

N_STEPS = 200_000
POINTS = 20
REPETITIONS = 30
DISCOUNT = 1.0
EPSILON = 0.1
LEARNING_RATE = 0.03
Q_LEARNING, SARSA_, EXPECTED_SARSA = "Q-learning", "SARSA", "expected SARSA"
KINDS: Mapping[str, Any] = MappingProxyType({Q_LEARNING: QLearning, SARSA_: SARSA, EXPECTED_SARSA: ExpectedSARSA})

FAST, SAFE = -2.0, -3.0
"""The returns of the shortest run to the target, and of one that takes a step more."""


def compare(
    *,
    epsilon: float = EPSILON,
    learning_rate: float = LEARNING_RATE,
    n_steps: int = N_STEPS,
    repetitions: int = REPETITIONS,
    seed: int = 0,
    parameters: Mapping[str, Any] = MappingProxyType({}),
    environment: str = "Roadrunner",
    **how: Any,
) -> Results:
    """Train the three methods: one panel of the figure.

    Args:
        epsilon: ε of all three, from 0 to 1.
        learning_rate: α of all three.
        n_steps: the training steps of each run.
        repetitions: the number of runs of each method.
        seed: the number from which all seeds are spawned.
        parameters: those of the environment, such as `stop_zone`.
        environment: its name or id.
        **how: more arguments of `edugym.training.repeat`, such as `jobs`, `progress` and `stop`.
    """
    methods = {
        label: partial(kind.create, learning_rate=learning_rate, discount=DISCOUNT, exploration=EpsilonGreedy(epsilon))
        for label, kind in KINDS.items()
    }
    return _train(
        methods, n_steps, environment=environment, parameters=parameters, repetitions=repetitions, seed=seed, **how
    )


def let_epsilon_decay(*, n_steps: int = 2_000_000, **how: Any) -> Results:
    """Train SARSA and expected SARSA while ε falls evenly from 0.1 to 0.001; arguments as in `compare`."""

    def decaying(kind: Any, environment: Any) -> Any:
        exploration = ScheduledEpsilonGreedy.create(LinearDecay(EPSILON, 0.001, n_steps))
        return kind.create(environment, learning_rate=LEARNING_RATE, discount=DISCOUNT, exploration=exploration)

    methods = {label: partial(decaying, KINDS[label]) for label in (SARSA_, EXPECTED_SARSA)}
    return _train(methods, n_steps, **how)


def _train(
    methods: Mapping[str, Callable[..., Any]], n_steps: int, *, environment: str = "Roadrunner", **how: Any
) -> Results:
    return repeat(environment, methods, n_steps, evaluate_every=n_steps // POINTS, **how)


def online(results: Results, method: str) -> Reals:
    """Return the mean return of the training episodes in the second half of training, shape (n_repetitions,)."""
    returns = results.curves(method, "training_return").to_numpy(float)
    episodes = results.curves(method, "episodes").to_numpy(float)
    half = len(returns) // 2
    total = np.nansum(returns[half:] * episodes[half:], axis=0)
    mean: Reals = total / episodes[half:].sum(axis=0)
    return mean


def online_lead(results: Results, method: str, other: str = Q_LEARNING) -> Interval:
    """Return how much more `method` earns online than `other`, paired by repetition."""
    return paired_difference(online(results, method), online(results, other))


def stopping_places(results: Results, method: str, **parameters: Any) -> list[int]:
    """Return where each complete run of a method ends up when it acts greedily: the last x."""
    task = Roadrunner.create(**parameters)
    rng = np.random.default_rng(0)  # for ties
    places = []
    for agent in results.complete_agents(method).values():
        state = task.initial(rng)
        for _ in range(task.max_steps):
            row = state.x * (task.max_speed + 1) + max(state.dx, 0)
            state = task.transition(state, agent.greedy(row, rng), rng)
            if task.terminal(state):
                break
        places.append(int(state.x))
    return places


def best_soft_return(model: FiniteModel, epsilon: float) -> float:
    """Return the expected return of the best policy among those that act at random with probability ε."""
    return value_iteration(model, DISCOUNT, epsilon=epsilon, horizon=50).start


def soft_return_of(model: FiniteModel, epsilon: float, planned_for: float) -> float:
    """Return what the best policy for ε = `planned_for` earns when it acts at random with probability `epsilon`."""
    greedy = value_iteration(model, DISCOUNT, epsilon=planned_for, horizon=50).greedy_policy()
    soft = (1 - epsilon) * greedy + epsilon / greedy.shape[1]
    return policy_evaluation(model, soft, DISCOUNT, horizon=50).start


def switch(model: FiniteModel, low: float = 0.0, high: float = 0.2, tolerance: float = 1e-4) -> float:
    """Return the ε from which on the longer, safer run is the better one, by bisection on the exact model."""
    while high - low > tolerance:
        middle = (low + high) / 2
        if soft_return_of(model, 0.0, planned_for=middle) < FAST:  # the best run for this ε, when nothing slips
            high = middle
        else:
            low = middle
    return (low + high) / 2


def measure(how: How) -> tuple[Any, ...]:
    """Run the experiments."""
    return (
        compare(**how("edge")),
        compare(epsilon=0.2, learning_rate=0.1, parameters={"stop_zone": 2}, **how("zone")),
        compare(parameters={"negative_reward": -10.0}, **how("mild")),
        compare(epsilon=0.01, **how()),
        compare(learning_rate=0.5, **how()),
        let_epsilon_decay(**how()),
    )


def judge(edge: Results, zone: Results, mild: Results, tiny: Results, rough: Results, decayed: Results) -> Report:
    """Return claims and figures."""
    claims = [
        *edge_claims(edge),
        *zone_claims(zone),
        *condition_claims(mild, tiny, rough, decayed),
        switch_claim(),
    ]
    return Report(claims, figures(edge, zone))


report = reporting(measure, judge, REPETITIONS)
"""Run the experiments of the lesson (see `edugym.experiments.Reporter`)."""


def edge_claims(edge: Results) -> list[Claim]:
    """Return the claims at the edge of the cliff, with `stop_zone` = 0."""
    share = {method: edge.share(method, at_least=FAST) for method in KINDS}
    return [
        Claim(
            "Greedy, Q-learning reaches the optimum",
            f"share of runs with return {FAST:g}",
            share[Q_LEARNING],
            Above(0.5),
        ),
        *(
            Claim(
                f"Greedy, {method} takes a longer, safer run",
                f"share of runs with return {FAST:g}",
                share[method],
                Below(0.5),
                "it has learned the values of a policy that slips",
            )
            for method in (SARSA_, EXPECTED_SARSA)
        ),
        *(
            Claim(
                f"While exploring, {method} earns more than Q-learning",
                f"online return of {method} less that of Q-learning",
                online_lead(edge, method),
                Above(0.5),
                "the shortest run is the one from which a slip falls off the cliff",
            )
            for method in (SARSA_, EXPECTED_SARSA)
        ),
    ]


def zone_claims(zone: Results) -> list[Claim]:
    """Return the claims on where the runner stops, with `stop_zone` = 2."""
    stops = {method: stopping_places(zone, method, stop_zone=2) for method in KINDS}
    return [
        Claim(
            "Q-learning stops at the edge",
            "cell where the greedy run ends",
            mean_interval(stops[Q_LEARNING]),
            Above(8.7),
        ),
        Claim(
            "SARSA stops before the edge",
            "cell where the greedy run ends, less that of Q-learning",
            paired_difference(stops[SARSA_], stops[Q_LEARNING]),
            Below(0.0),
            "each cell short of the edge costs 1, and a slip at the edge costs 100",
        ),
    ]


def condition_claims(mild: Results, tiny: Results, rough: Results, decayed: Results) -> list[Claim]:
    """Return the claims on when the difference vanishes, turns round, or cannot be seen."""
    return [
        Claim(
            "With ε = 0.01 the lead of SARSA is gone: it earns less than Q-learning",
            "online return of SARSA less that of Q-learning, ε = 0.01",
            online_lead(tiny, SARSA_),
            Below(0.0),
            "the fast run is best now, but SARSA learned to avoid it early and hardly ever tries it again",
        ),
        Claim(
            "With ε = 0.01 expected SARSA and Q-learning earn the same",
            "online return of expected SARSA less that of Q-learning, ε = 0.01",
            online_lead(tiny, EXPECTED_SARSA),
            Within(-0.05, 0.05),
            "with so few slips the best policies of both are the same run",
        ),
        Claim(
            "Where falling costs only 10, SARSA earns less online than Q-learning",
            "online return of SARSA less that of Q-learning, R = -10",
            online_lead(mild, SARSA_),
            Below(0.0),
            "the fast run is best even with slips; sampling noise keeps SARSA from it, not caution",
        ),
        Claim(
            "Expected SARSA, which has no such noise, earns as much as Q-learning there",
            "online return of expected SARSA less that of Q-learning, R = -10",
            online_lead(mild, EXPECTED_SARSA),
            Within(-0.03, 0.03),
        ),
        Claim(
            "Negative control: with learning rate 0.5 SARSA loses its lead",
            "online return of SARSA less that of Q-learning",
            online_lead(rough, SARSA_),
            Below(0.5),
            "its values then follow the last few samples",
        ),
        Claim(
            "Letting ε decay does not free SARSA from the safe run",
            f"share of runs with return {FAST:g}",
            decayed.share(SARSA_, at_least=FAST),
            Below(0.5),
            "it no longer tries the fast run, so it no longer corrects its values there",
        ),
        Claim(
            "Letting ε decay frees expected SARSA",
            f"share of runs with return {FAST:g}",
            share_interval(decayed.final(EXPECTED_SARSA) >= FAST),
            Above(0.5),
            "its target follows ε at once, in every state that it still visits",
        ),
    ]


def switch_claim() -> Claim:
    """Return the claim on the ε at which the best ε-soft run changes; it is exact, so its interval is a point."""
    epsilon = switch(finite_model(Roadrunner.create()))
    return Claim(
        "The best ε-soft run changes from the fast to the safe one between ε = 0.03 and 0.05",
        "ε on the exact model",
        exactly(epsilon),
        Within(0.03, 0.05),
    )


def figures(edge: Results, zone: Results) -> list[Sheet]:
    """Return the figures: greedy and online learning curves, and the exact returns against ε."""
    model = finite_model(Roadrunner.create())
    zone_model = finite_model(Roadrunner.create(stop_zone=2))
    online_curves = [
        Curves(
            results,
            title,
            column="training_return",
            optimum=best_soft_return(task, 0.0),
            soft_optimum=best_soft_return(task, epsilon),
        )
        for results, title, task, epsilon in (
            (edge, "while exploring", model, EPSILON),
            (zone, "while exploring, stop zone 2", zone_model, 0.2),
        )
    ]
    greedy_curves = [
        Curves(edge, "greedy", optimum=best_soft_return(model, 0.0), y_range=(-4.0, -1.5)),
        Curves(zone, "greedy, stop zone 2", optimum=best_soft_return(zone_model, 0.0), y_range=(-4.0, -1.5)),
    ]
    return [Sheet("on_off_policy", [greedy_curves, online_curves]), Sheet("switch", [[switch_lines(model)]])]


def switch_lines(model: FiniteModel) -> Lines:
    """Return the exact returns of the fast and of the safe run, and the best ε-soft return, against ε."""
    epsilons = np.linspace(0.0, 0.15, 31)
    return Lines(
        epsilons,
        {
            "fast run": np.array([soft_return_of(model, epsilon, 0.01) for epsilon in epsilons]),
            "safe run": np.array([soft_return_of(model, epsilon, EPSILON) for epsilon in epsilons]),
        },
        "what each run is worth when it slips",
        "ε",
        "expected return",
        {"best ε-soft policy": np.array([best_soft_return(model, epsilon) for epsilon in epsilons])},
    )
