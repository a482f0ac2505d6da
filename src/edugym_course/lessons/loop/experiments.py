"""The loop (lesson 0): rewards, returns and the discount, from random play to the first Q-learning.

In Supermarket a step costs 1, an item pays 25 and the exit 50. Q-learning trains for 60 000 steps with learning rate
0.5 and ε-greedy exploration with ε = 0.1, with discount 0.99 and with discount 0, with which it learns rewards only.
The random player learns nothing. 20 repetitions; the seeds are the same for every method.

"Computed" values come from the exact model of 428 states. An episode is cut off after 500 steps.
"""

from typing import Any

import numpy as np

from edugym.exact.value_iteration import value_iteration
from edugym.experiments.results.claims import Above, Below, Claim, Within
from edugym.experiments.results.statistics import exactly, mean_interval
from edugym.experiments.results.tables import Results
from edugym_course.lessons.loop.exact import (
    best_way,
    discounted,
    leaving_return,
    misled,
    model,
    myopic_return,
    random_return,
    rewards_along,
)
from edugym_course.lessons.loop.figures import agent_after, figures
from edugym_course.lessons.loop.methods import (
    ITEMS,
    MYOPIC,
    OPTIMUM,
    Q_LEARNING,
    RANDOM,
    REPETITIONS,
    RETURNS,
    play_and_learn,
)
from edugym_course.report import Report
from edugym_course.reporting import SharedArguments, reporting


def warm_up() -> None:
    """Compile what the cells of the lesson need."""
    play_and_learn(n_steps=80, repetitions=1, jobs=1)
    agent_after(80)


def measure(how: SharedArguments) -> tuple[Any, ...]:
    """Run the experiments."""
    return play_and_learn(**how("loop")), play_and_learn(learning_rate=1.0, **how("at_once"))


def judge(results: Results, at_once: Results) -> Report:
    """Return claims and figures."""
    claims = [*player_claims(results), *reward_claims(results), *rounding_claims(results, at_once), *discount_claims()]
    return Report(claims, figures(results))


report = reporting(measure, judge, REPETITIONS)
"""Run the experiments of the lesson (see `edugym_course.reporting.Reporter`)."""


def player_claims(results: Results) -> list[Claim]:
    """Return the claims on random play, the optimum, and Q-learning between them."""
    theory = random_return()
    return [
        Claim(
            f"Random play returns {theory:.0f} on average, as the exact model says",
            "return of random play / computed",
            mean_interval(results.average(RANDOM, "training_return") / theory),
            Within(0.95, 1.05),
            remark="rewards and dynamics together give the return of any policy: nothing needs to be played",
        ),
        Claim(
            "The best policy returns 95",
            "optimum, computed by value iteration",
            exactly(value_iteration(model()).start),
            Within(95.0, 95.0),
        ),
        Claim(
            "Q-learning finds the best policy without the model",
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
            "At the start all actions have the same reward, so rewards do not tell them apart",
            "highest less lowest reward, computed",
            exactly(float(np.ptp(model().r[start]))),
            Within(0.0, 0.0),
        ),
        Claim(
            "Where rewards differ, the highest one is not always the best choice",
            "share of such states, computed",
            exactly(misled()),
            Above(0.1),
            remark="beside the exit the highest reward is to leave, without the other items",
        ),
        Claim(
            "Always taking the highest next reward earns much less than half of the optimum",
            "return, computed",
            exactly(myopic_return()),
            Below(OPTIMUM / 2),
        ),
        Claim(
            "Leaving by the exit as soon as it is beside one is most of what the highest reward gains over random play",
            "gain of random play that leaves so, of the gain of the highest reward, computed",
            exactly((leaving_return() - random_return()) / (myopic_return() - random_return())),
            Within(0.8, 0.95),
            remark=f"random play returns {random_return():.0f}, the highest next reward {myopic_return():.0f}",
        ),
        Claim(
            "Q-learning with discount 0 learns rewards, not returns, and does not find the best way",
            "share of runs that end with 95",
            results.share(MYOPIC, OPTIMUM),
            Below(0.2),
        ),
    ]


def rounding_claims(results: Results, at_once: Results) -> list[Claim]:
    """Return the claims on why the learner of rewards is worse than random play when it does not explore.

    Args:
        results: the results of the lesson.
        at_once: the results with learning rate 1.
    """
    tested = "With learning rate 1 Q-learning with discount 0 earns about as much as the highest next reward"
    return [
        Claim(
            "Without exploring, Q-learning with discount 0 earns at least 50 less than random play",
            f"return averaged over training less {random_return():.0f}, that of random play",
            mean_interval(results.average(MYOPIC) - random_return()),
            Below(-50.0),
            "its values are nearly equal, and the smallest difference decides for the same action at every visit",
            (tested,),
        ),
        Claim(
            tested,
            f"return averaged over training / {myopic_return():.0f}, that of the highest next reward",
            mean_interval(at_once.average(MYOPIC) / myopic_return()),
            Within(0.9, 1.25),
            remark="all values of tried actions are then exactly right, and equal ones are equal",
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
                remark="a reward k steps ahead counts γ^k times" if items == 1 else "",
            )
            for discount, items in ITEMS.items()
        ),
        Claim(
            "The short way with one item is better than the one with three at discount 0.85",
            "discounted return, difference, computed",
            exactly(lead(0.85)),
            Within(0.9, 1.0),
            remark="what is best depends on the discount, which belongs to the question and not to the world",
        ),
        Claim(
            "The short way with one item is worse than the one with three at discount 1",
            "return, difference, computed",
            exactly(lead(1.0)),
            Within(-36.0, -36.0),
        ),
        Claim(
            "With discount 0 all that counts is the next reward: the best policy need not get to the exit",
            "V*(start), computed",
            exactly(value_iteration(model(), 0.0).start),
            Within(-1.0, -1.0),
        ),
    ]
