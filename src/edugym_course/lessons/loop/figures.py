"""The figures of lesson 0: learning curves, and what the discount changes."""

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from edugym.adapters.registration import in_course_order, make_mdp
from edugym.agents.q_learning import QLearning
from edugym.exact.value_iteration import value_iteration
from edugym.experiments.figures.curves import Curves
from edugym.experiments.figures.lines import Lines
from edugym.experiments.figures.sheet import Sheet
from edugym.experiments.results.tables import Results
from edugym.mdp.protocol import Reals
from edugym.training.train import train
from edugym_course.lessons.loop.exact import (
    best_table,
    best_way,
    discounted,
    items_on,
    model,
    returns_along,
    rewards_along,
)
from edugym_course.lessons.loop.methods import (
    DISCOUNT,
    EPSILON,
    ITEMS,
    MYOPIC,
    OPTIMUM,
    Q_LEARNING,
    RANDOM,
    learner,
    play_and_learn,
)
from edugym_course.lessons.loop.panels import Picture, RewardBars, ValueMap

BAGS = {
    "empty": 0,
    "red": 4,
    "blue": 2,
    "green": 1,
    "red and blue": 6,
    "red and green": 5,
    "blue and green": 3,
    "all three": 7,
}
"""What can be in the bag, as the state has it."""
RANGE = (-540.0, 120.0)
HARDER = {
    "Boulder": "the only reward is far away: how to explore?",
    "Roadrunner": "a random step may be deadly",
    "Study": "the exam comes long after the lecture",
    "Catch": "states are pictures: too many for a table",
    "MemoryCorridor": "it sees only a part, and must remember",
    "Tamagotchi": "what it is told is not always true",
    "Trashbot": "an action is any value in a range",
    "Golf": "the ball goes where it wants",
    "Supermarket": "a step takes time: think before you act",
}
"""What is harder in each environment than in this lesson."""


def figures(results: Results) -> list[Sheet]:
    """Return the figures: learning curves, V* of the start by discount, and V* along the best way."""
    return [learning_curves(results), Sheet("discount", [[*discount_lines()]])]


def learning_curves(results: Results) -> Sheet:
    """Return the learning curves: of the greedy policies, and while exploring."""
    own = [label for label in results.methods if label not in (Q_LEARNING, MYOPIC, RANDOM)]
    soft = value_iteration(model(), epsilon=EPSILON).start
    methods = [Q_LEARNING, MYOPIC, RANDOM, *own]
    greedy = Curves(
        results,
        "without exploring",
        optimum=OPTIMUM,
        methods=methods,
        y_label="points per episode, without exploring",
        y_range=RANGE,
    )
    exploring = Curves(
        results,
        "while it learns",
        "training_return",
        methods=methods,
        soft_optimum=soft,
        soft_label=f"best with {EPSILON:.0%} random actions".replace("%", " %"),
        y_label="points per episode, while exploring",
        y_range=RANGE,
    )
    return Sheet("loop", [[greedy, exploring]])


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


def rewards_and_returns(discount: float = 0.95) -> Sheet:
    """Return the reward of each step on the best way, and the return from each step on."""
    rewards = rewards_along(best_way(discount))
    title = f"the best way for γ = {discount:g}"
    return Sheet(
        "rewards", [[RewardBars(rewards, title, y_label="reward, return", returns=returns_along(rewards, discount))]]
    )


def with_discount(gamma: float = 0.95, bag: str = "empty") -> Sheet:
    """Return the map of v* with the best actions and the best way, and what each reward on it counts for the start."""
    way = best_way(gamma)
    ends = bool(model().terminal[way[-1]])
    states = tuple(int(model().states[row]) for row in way) if ends and bag == "empty" else ()
    rewards = rewards_along(way) if ends else rewards_along(way)[:30]
    counted = rewards * gamma ** np.arange(len(rewards))
    items = items_on(way)
    found = f"{items} item{'' if items == 1 else 's'}, {len(way) - 1} steps" if ends else "all ways are equal"
    value = discounted(rewards_along(way), gamma)
    return Sheet(
        "with_discount",
        [
            [
                ValueMap(best_table(gamma), f"v* with γ = {gamma:g}, bag: {bag}", BAGS[bag], states),
                RewardBars(counted, f"{found}: v*(start) = {value:.1f}", "k, steps ahead", "what the reward counts"),
            ]
        ],
    )


def agent_after(steps: int, seed: int = 0, discount: float = DISCOUNT) -> QLearning:
    """Return the learner of the lesson after so many steps of training."""
    agent = learner(discount=discount)(make_mdp("Supermarket"))
    if steps:
        train("Supermarket", agent, steps, evaluate_every=steps, seed=seed)
    return agent


def learned_beside_exact(steps: int = 20_000, bag: str = "empty") -> Sheet:
    """Return the map of what one agent has learned after so many steps, beside the map of v*."""
    Q = agent_after(steps).Q
    exact = best_table(DISCOUNT)
    start = int(model().states[int(model().initial.argmax())])
    learned = np.where((Q == 0.0).all(axis=1, keepdims=True), np.nan, Q)
    trained = f"after {steps:,} steps".replace(",", " ")
    mine, ideal = (
        f"{whose}, bag: {bag}\nvalue of the first state: {table[start].max():.1f}"
        for whose, table in ((trained, Q), ("v*", exact))
    )
    return Sheet(
        "learned_beside_exact",
        [
            [
                ValueMap(learned, mine, BAGS[bag], bar=False),
                ValueMap(exact, ideal, BAGS[bag]),
            ]
        ],
    )


def race(own: Mapping[str, Callable[..., Any]], *, n_steps: int = 20_000, repetitions: int = 30, **how: Any) -> Sheet:
    """Return the figure of the lesson with agents of the reader's own beside its three.

    Args:
        own: by label, functions that make an agent for the environment.
        n_steps: the training steps of each run.
        repetitions: the number of runs of each.
        **how: more arguments of `play_and_learn`.
    """
    return learning_curves(play_and_learn(own, n_steps=n_steps, repetitions=repetitions, **how))._replace(name="race")


def nine_challenges() -> Sheet:
    """Return the pictures of the environments of lessons 1 to 9, each with its lesson and what is harder there."""
    entries = [entry for entry in in_course_order() if entry.name in HARDER]
    panels = [Picture(entry.name, f"{entry.lesson}  {entry.name}\n{HARDER[entry.name]}") for entry in entries]
    return Sheet("challenges", [panels[first : first + 3] for first in range(0, len(panels), 3)])
