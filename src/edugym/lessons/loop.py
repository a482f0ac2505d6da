"""The loop (lesson 0): rewards, returns and the discount, from random play to the first Q-learning.

In Supermarket a step costs 1, an item pays 25 and the exit 50. Q-learning trains for 60 000 steps with learning rate
0.5 and ε-greedy exploration with ε = 0.1, with discount 0.99 and with discount 0, with which it learns rewards only.
The random player is the same agent with ε = 1. 20 repetitions; the seeds are the same for every method.

"Computed" values come from the exact model of 428 states. An episode is cut off after 500 steps.
"""

from collections.abc import Mapping, Sequence
from functools import cache, partial
from itertools import pairwise
from typing import Any

import numpy as np

from edugym.agents.q_learning import QLearning
from edugym.agents.strategies import EpsilonGreedy
from edugym.envs.supermarket import Supermarket
from edugym.exact.model import finite_model
from edugym.exact.policy_evaluation import policy_evaluation
from edugym.exact.tables import FiniteModel
from edugym.exact.value_iteration import value_iteration
from edugym.experiments import How, reporting
from edugym.mdp.protocol import Integers, Reals
from edugym.plotting.curves import Curves
from edugym.plotting.lines import Lines
from edugym.plotting.report import Report
from edugym.plotting.sheet import Sheet
from edugym.results.claims import Above, Below, Claim, Within
from edugym.results.statistics import exactly, mean_interval
from edugym.results.tables import Results
from edugym.training.repeat import repeat

N_STEPS = 60_000
REPETITIONS = 20
LEARNING_RATE = 0.5
EPSILON = 0.1
DISCOUNT = 0.99
MAX_STEPS = 500
OPTIMUM = 95.0
RANDOM, MYOPIC, Q_LEARNING = "random", "Q-learning, γ = 0", f"Q-learning, γ = {DISCOUNT:g}"
ITEMS = {0.85: 1, 0.9: 2, 0.95: 3, 1.0: 3}
"""How many items the best policy collects with some discounts."""
RETURNS = {1: 59.0, 2: 78.0, 3: OPTIMUM}
"""The return of the shortest way with so many items (discount 1)."""


@cache
def model() -> FiniteModel:
    """Return the exact model."""
    return finite_model(Supermarket.create(max_steps=MAX_STEPS))


def play_and_learn(*, n_steps: int = N_STEPS, learning_rate: float = LEARNING_RATE, **how: Any) -> Results:
    """Train the three: one that never learns from what it does, one that learns rewards, and one that learns returns.

    Args:
        n_steps: the training steps of each run.
        learning_rate: α.
        **how: more arguments of `edugym.training.repeat`, such as `repetitions`, `seed` and `jobs`.
    """
    settings = {RANDOM: (DISCOUNT, 1.0), MYOPIC: (0.0, EPSILON), Q_LEARNING: (DISCOUNT, EPSILON)}
    methods = {
        label: partial(
            QLearning.create, learning_rate=learning_rate, discount=discount, exploration=EpsilonGreedy(epsilon)
        )
        for label, (discount, epsilon) in settings.items()
    }
    return repeat("Supermarket", methods, n_steps, evaluate_every=max(n_steps // 30, 1), **how)


def random_return() -> float:
    """Return what a player who acts at random earns, computed."""
    policy = np.full(model().successors.shape[:2], 0.25)
    return policy_evaluation(model(), policy, horizon=MAX_STEPS).start


def myopic_return() -> float:
    """Return what a player earns who always takes the highest next reward (one of them at random), computed."""
    best = model().r >= model().r.max(axis=1, keepdims=True)
    return policy_evaluation(model(), best / best.sum(axis=1, keepdims=True), horizon=MAX_STEPS).start


def best_way(discount: float) -> list[int]:
    """Return the rows of the model along the best way for a discount; 500 steps if it does not get to the exit."""
    best = value_iteration(model(), discount).Q.argmax(axis=1)
    rows = [int(model().initial.argmax())]
    while not model().terminal[rows[-1]] and len(rows) <= MAX_STEPS:
        rows.append(int(model().successors[rows[-1], best[rows[-1]], 0]))
    return rows


def rewards_along(rows: Sequence[int]) -> Reals:
    """Return the rewards on a way, shape (n_steps,)."""
    return np.array([model().rewards[s, (model().successors[s, :, 0] == n).argmax(), 0] for s, n in pairwise(rows)])


def discounted(rewards: Reals, discount: float) -> float:
    """Return G = R_1 + γ R_2 + γ² R_3 + ... (equation 3.8)."""
    return float((rewards * discount ** np.arange(len(rewards))).sum())


def items_on(rows: Sequence[int]) -> int:
    """Return how many items are collected on a way."""
    return int(model().states[rows[-1]] % 8).bit_count()


def misled() -> float:
    """Return the share of states with different next rewards in which the highest is not on the best way (γ = 1).

    Such a state is one before the exit, or beside an item, when something else should come first.
    """
    Q, r = value_iteration(model()).Q, model().r
    differ: Integers = np.flatnonzero((r.max(axis=1) > r.min(axis=1)) & ~model().terminal)
    myopic = r[differ].argmax(axis=1)
    worse = Q[differ, myopic] < Q[differ].max(axis=1) - 1e-6
    return float(worse.mean())


def measure(how: How) -> tuple[Any, ...]:
    """Run the experiments."""
    return (play_and_learn(**how("loop")),)


def judge(results: Results) -> Report:
    """Return claims and figures."""
    claims = [*player_claims(results), *reward_claims(results), *discount_claims()]
    return Report(claims, figures(results))


report = reporting(measure, judge, REPETITIONS)
"""Run the experiments of the lesson (see `edugym.experiments.Reporter`)."""


def player_claims(results: Results) -> list[Claim]:
    """Return the claims on random play, the optimum, and Q-learning between them."""
    theory = random_return()
    return [
        Claim(
            f"Random play returns {theory:.0f} on average, as the exact model says",
            "return of random play / computed",
            mean_interval(results.average(RANDOM, "training_return") / theory),
            Within(0.95, 1.05),
            "rewards and dynamics together give the return of any policy: nothing needs to be played",
        ),
        Claim(
            "The best policy returns 95",
            "optimum, computed by value iteration",
            exactly(value_iteration(model()).start),
            Within(95.0, 95.0),
        ),
        Claim(
            "Q-learning finds it, without the model",
            "share of runs that end with 95",
            results.share(Q_LEARNING, OPTIMUM),
            Above(0.5),
        ),
    ]


def reward_claims(results: Results) -> list[Claim]:
    """Return the claims on what is wrong with "reward is return"."""
    start = int(model().initial.argmax())
    return [
        Claim(
            "At the start rewards say nothing: all actions have the same",
            "highest less lowest reward, computed",
            exactly(float(np.ptp(model().r[start]))),
            Within(0.0, 0.0),
        ),
        Claim(
            "Where rewards differ, the highest one is not always the best choice",
            "share of such states, computed",
            exactly(misled()),
            Above(0.1),
            "beside the exit the highest reward is to leave, without the other items",
        ),
        Claim(
            "Always taking the highest next reward earns much less than half of the optimum",
            "return, computed",
            exactly(myopic_return()),
            Below(OPTIMUM / 2),
            f"more than random play ({random_return():.0f}): it takes what lies beside it",
        ),
        Claim(
            "Q-learning with discount 0 learns rewards, not returns, and never finds the best way",
            "share of runs that end with 95",
            results.share(MYOPIC, OPTIMUM),
            Below(0.5),
        ),
    ]


def discount_claims() -> list[Claim]:
    """Return the claims on how the discount changes what is best, computed."""
    near, far = best_way(0.85), best_way(1.0)

    def lead(discount: float) -> float:
        return discounted(rewards_along(near), discount) - discounted(rewards_along(far), discount)

    return [
        *(
            Claim(
                f"With discount {discount:g} the best policy collects {items} item{'s' if items > 1 else ''}",
                "undiscounted return, computed",
                exactly(discounted(rewards_along(best_way(discount)), 1.0)),
                Within(RETURNS[items], RETURNS[items]),
                "a reward k steps ahead counts γ^k times" if items == 1 else "",
            )
            for discount, items in ITEMS.items()
        ),
        Claim(
            "The short way with one item is better than the one with three at discount 0.85",
            "discounted return, difference, computed",
            exactly(lead(0.85)),
            Above(0.0),
            "what is best depends on the discount, which belongs to the question and not to the world",
        ),
        Claim(
            "and worse at discount 1",
            "return, difference, computed",
            exactly(lead(1.0)),
            Below(0.0),
        ),
        Claim(
            "With discount 0 all that counts is the next reward: the best policy need not get to the exit",
            "V*(start), computed",
            exactly(value_iteration(model(), 0.0).start),
            Within(-1.0, -1.0),
        ),
    ]


def figures(results: Results) -> list[Sheet]:
    """Return the figures: learning curves, V* of the start by discount, and V* along the best way."""
    greedy = Curves(results, "greedy", optimum=OPTIMUM, methods=[Q_LEARNING, MYOPIC])
    soft = value_iteration(model(), epsilon=EPSILON).start
    methods = [Q_LEARNING, MYOPIC, RANDOM]
    exploring = Curves(results, "while exploring", "training_return", methods=methods, soft_optimum=soft)
    return [Sheet("loop", [[greedy, exploring]]), Sheet("discount", [[*discount_lines()]])]


def discount_lines() -> tuple[Lines, Lines]:
    """Return V* of the start and the undiscounted return against the discount, and V* on the way for several."""
    discounts = np.array([*np.arange(0.5, 1.0, 0.01), 1.0])
    by_discount: Mapping[str, Reals] = {
        "V* of the start": np.array([value_iteration(model(), discount).start for discount in discounts]),
        "undiscounted return of the best policy": np.array(
            [rewards_along(best_way(discount)).sum() for discount in discounts]
        ),
    }
    longest = len(best_way(1.0))
    along = {}
    for discount in ITEMS:
        way = best_way(discount)
        V = value_iteration(model(), discount).V[way]
        along[f"γ = {discount:g}"] = np.append(V, np.full(longest - len(way), np.nan))
    return (
        Lines(discounts, by_discount, "what the discount changes", "discount γ", "return"),
        Lines(np.arange(float(longest)), along, "on the best way", "steps from the start", "V*"),
    )
