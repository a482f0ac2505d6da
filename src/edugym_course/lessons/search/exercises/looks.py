"""Exercise 3 of lesson 18: looking ahead exactly, the usual mistakes, and models to look into."""

from collections.abc import Callable, Mapping
from functools import lru_cache, partial
from itertools import accumulate
from typing import Any, NamedTuple

import numpy as np

from edugym_course.grading.cases import telling_draw

Outcomes = list[tuple[float, int, float, bool]]
"""What may follow on an action: probability, next state, reward, terminated."""
Model = Mapping[int, list[Outcomes]]
"""The outcomes of each action of each state."""
LESSONS_DISCOUNT = 0.95
WITHOUT_CHANCE = ("none", "equal", "first", "likely", "best")
"""Mistakes in which no outcome has its probability."""


class Look(NamedTuple):
    """A question for exercise 3: what is a state worth, this many steps ahead?"""

    model: Model
    state: int
    depth: int


def looked_ahead(
    case: Look,
    *,
    choice: str = "best",
    end: str = "right",
    chance: str = "right",
    count: int = 0,
    least: int = 0,
    gamma: str = "right",
    reward: str = "all",
    looked_up: str = "next",
    stored: str = "nothing",
    discount: float = 0.9,
) -> float:
    """Return the value of a state, by recursion; other arguments than the defaults are mistakes."""
    table = dict.fromkeys(case.model, 0.0) if stored == "in place" else dict[int, float]()

    def value(state: int, depth: int) -> float:
        if depth <= 0:
            return 0.0
        if state in table:
            return table[state]
        found = worked_out(state, depth)
        if stored == "by state":
            table[state] = found
        return found

    def worked_out(state: int, depth: int) -> float:
        of_actions, rewards = [], list[float]()
        for outcomes in case.model[state]:
            last = next((k for k, outcome in enumerate(outcomes) if outcome[3]), len(outcomes))
            seen = {"first": outcomes[:1], "likely": [max(outcomes)], "to an end": outcomes[: last + 1]}
            parts = []
            for p, after, r, terminated in seen.get(chance, outcomes):
                if terminated and end == "returned":
                    return r
                following = after if looked_up == "next" else state
                over = {"beyond": False, "upside down": not terminated}.get(end, terminated)
                follows = 0.0 if over else value(following, depth - 1)
                earned = r if reward == "all" or depth <= 1 else 0.0
                of_reward = 1.0 if chance in (*WITHOUT_CHANCE, "future") else p
                of_future = 1.0 if chance in (*WITHOUT_CHANCE, "reward") else p
                if terminated and (end == "dropped" or (end == "dropped early" and depth > 1)):
                    of_reward = 0.0
                if gamma == "all":
                    earned *= discount
                parts.append(of_reward * earned + of_future * factor(depth) * follows)
            total = {"best": max(parts), "last": parts[-1], "equal": sum(parts) / len(parts)}.get(chance, sum(parts))
            rewards.append(sum(p * r for p, _, r, _ in outcomes))
            of_actions.append(total)
        return {
            "best": max(of_actions),
            "number": float(np.argmax(of_actions)),
            "mean": sum(of_actions) / len(of_actions),
            "worst": min(of_actions),
            "by reward": of_actions[int(np.argmax(rewards))],
            "first": of_actions[0],
            "first two": max(of_actions[:2]),
            "last": of_actions[-1],
            "sum": sum(of_actions),
            "from 0": max(0.0, *of_actions),
            "added": max(accumulate(of_actions)),
        }[choice]

    def factor(depth: int) -> float:
        return {"one": 1.0, "power": discount**depth, "lesson's": LESSONS_DISCOUNT}.get(gamma, discount)

    for _ in range(case.depth if stored == "in place" else 0):
        for state in case.model:
            table[state] = worked_out(state, 2)
    return value(case.state, max(case.depth + count, least))


LOOK_MISTAKES: Mapping[str, Mapping[str, Any]] = {
    "the actions are averaged: that is the value of random play; you will take the best": {"choice": "mean"},
    "the actions are added up; you will take the best": {"choice": "sum"},
    "only action 0 is looked at": {"choice": "first"},
    "only actions 0 and 1 are looked at; a state may have more": {"choice": "first two"},
    "only the last action counts: each one overwrites those before it; keep the best": {"choice": "last"},
    "that is the value of the worst action": {"choice": "worst"},
    "the *number* of the best action is returned; return what it is worth": {"choice": "number"},
    "what follows is that of the same state again; it is that of the *next* state": {"looked_up": "same"},
    "it looks beyond the end: where `terminated` is True nothing follows": {"end": "beyond"},
    "something follows only where `terminated` is True; there nothing does": {"end": "upside down"},
    "the action with the best *reward* is taken; take the one with the best value, that of what follows included": {
        "choice": "by reward"
    },
    "only the last outcome of each action counts: is it `=` in place of `+=`?": {"chance": "last"},
    "all outcomes of an action count alike; each has its probability": {"chance": "equal"},
    "the probabilities are left out": {"chance": "none"},
    "only the first outcome of each action is looked at": {"chance": "first"},
    "it looks one step too far: with 0 steps left the value is 0": {"count": 1},
    "it looks one step too short": {"count": -1},
    "with 0 steps left the value is 0: here a step is looked at where none is left": {"least": 1},
    "γ is left out": {"gamma": "one"},
    "the first reward is discounted, too; γ only stands before what follows": {"gamma": "all"},
    "only the last reward counts; each step's is added": {"reward": "last"},
    "the reward of an outcome that ends is returned at once; it is one of several, each with its probability": {
        "end": "returned"
    },
    "the reward of the step that ends the task is lost; only what would follow it is 0": {"end": "dropped"},
    "the reward of a step that ends the task is lost where it is not the last step that is looked at": {
        "end": "dropped early"
    },
    "the best action is looked for from 0 on, and all may be worth less: begin with float('-inf')": {
        "choice": "from 0"
    },
    "the sum is not set back to 0 for each action": {"choice": "added"},
    "only the reward has its probability; what follows has it, too": {"chance": "reward"},
    "only what follows has its probability; the reward has it, too": {"chance": "future"},
    "only the likeliest outcome of each action is looked at": {"chance": "likely"},
    "the best outcome is taken; you choose the action, but chance draws the outcome": {"chance": "best"},
    "the outcomes after one that ends are left out; each has its probability": {"chance": "to an end"},
    "γ has the power of the depth; each call multiplies by it once, and that adds up": {"gamma": "power"},
    "the value of a state is kept, and taken again with other steps left; it depends on both": {"stored": "by state"},
    "the values are overwritten while a sweep still needs the old ones; write those of a sweep into a new table": {
        "stored": "in place"
    },
    "that is the γ of the shop, 0.95; the exercise has another": {"gamma": "lesson's"},
}


def made_up_looks(rng: np.random.Generator) -> list[Look]:
    """Make up models of three states and two or three actions, some outcomes of which end, and questions about them."""
    made = []
    for depth in (1, 2, 3, 3, 0):
        model: dict[int, list[Outcomes]] = {state: [] for state in range(3)}
        for state, actions in model.items():
            for _ in range(3 if state == 1 else 2):
                p = float(rng.choice([0.25, 0.75, 1.0]))
                actions.append(
                    [
                        (share, int(rng.integers(3)), float(rng.integers(-4, 9)), bool(rng.random() < 0.3))
                        for share in (p, 1 - p)
                        if share
                    ]
                )
        made.append(Look(model, int(rng.integers(3)), depth))
    return made


@lru_cache(16)
def telling_looks(seed: int, discount: float) -> tuple[Look, ...]:
    """Return questions that tell all mistakes apart; they are not searched for again with the next answer."""
    right = partial(looked_ahead, discount=discount)
    rules: list[Callable[[Any], Any]] = [right, *(partial(right, **one) for one in LOOK_MISTAKES.values())]
    return tuple(made_up_looks(telling_draw(seed, made_up_looks, rules)))
