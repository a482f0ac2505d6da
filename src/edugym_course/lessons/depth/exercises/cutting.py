"""Exercise 3: learning as deep as the actions were greedy, with the mistakes that are usually made in it."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import combinations, permutations, product
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np

from edugym.mdp.protocol import Reals
from edugym_course.grading.cases import FAR_BELOW, STARTS, from_a_start, starts
from edugym_course.grading.errors import nobody_asks_why
from edugym_course.grading.values import all_same, differing, digits, in_brackets
from edugym_course.lessons.depth.exercises.episodes import N_ACTIONS, N_STATES, Episode, make_episode

Settings = Mapping[str, Any]

NO_CHANGE: Settings = MappingProxyType({})
UNUSUAL = "that is none of the usual mistakes"


def hand_back(
    Q: Reals,
    episode: Episode,
    *,
    learning_rate: float,
    discount: float,
    cost: float = 0.0,
    cut: str = "after",
    to: str = "max",
    order: str = "backwards",
    steps: str = "all",
    rewards: str = "plain",
    start: str = "zero",
    step: str = "difference",
    index: str = "states[k]",
    left_over: float = 0.0,
) -> None:
    """Learn from an episode as exercise 3 asks, in place; other arguments than the defaults are mistakes.

    `cost` is subtracted from each reward.
    `left_over` is what stands behind the rewards of the episode in the agent's array: one of a longer episode before.
    """
    last = len(episode.states) - 1
    ks = {
        "all": range(last, -1, -1),
        "not the first": range(last, 0, -1),
        "not the last": range(last - 1, -1, -1),
        "the last": range(last, last - 1, -1),
        "none": range(0),
    }[steps]
    if order == "forwards":
        ks = range(last + 1)
    G = {"zero": 0.0, "value": float(Q[N_STATES - 1].max()), "last": float(Q[episode.states[last]].max())}[start]
    for k in ks:
        s, a, r = k if index == "k" else episode.states[k], episode.actions[k], episode.rewards[k]
        if index == "k + 1":
            r = episode.rewards[k + 1] if k < last else left_over
        r -= cost
        best_before, mine_before = float(Q[s].max()), float(Q[s, a])
        if cut == "first" and mine_before < best_before:
            G = best_before
        if rewards == "of the last step":
            r = episode.rewards[last]
        G = {
            "plain": r + discount * G,
            "of the last step": r + discount * G,
            "undiscounted": r + G,
            "all discounted": discount * (r + G),
            "none": discount * G,
            "only": r,
            "minus": r - discount * G,
            "discounted reward": discount * r + G,
        }[rewards]
        if cut == "too early" and mine_before < best_before:
            G = best_before
        old = mine_before
        skipped = step == "skips exploring" and old < best_before
        if not skipped:
            Q[s, a] = {
                "difference": old + learning_rate * (G - old),
                "skips exploring": old + learning_rate * (G - old),
                "no old": old + learning_rate * G,
                "only": learning_rate * (G - old),
                "weights": learning_rate * old + (1 - learning_rate) * G,
                "minus": old - learning_rate * (G - old),
                "replaced": G,
            }[step]
        best, mine = float(Q[s].max()), float(Q[s, a])
        if to.startswith("from "):
            best = from_a_start(Q[s], int(to.removeprefix("from ")))
        cuts = {
            "after": mine < best,
            "before": mine_before < best_before,
            "below the table": mine < Q.max(),
            "never": False,
            "too early": False,
            "first": False,
            "always": True,
            "inverted": not mine < best,
            "first of equals": a != int(Q[s].argmax()),
            "last of equals": a != N_ACTIONS - 1 - int(Q[s, ::-1].argmax()),
            "not above the others": not mine > float(np.delete(Q[s], a).max()),
        }
        if cut == "stop":
            if mine < best:
                break
        elif cuts[cut]:
            G = {
                "max": best,
                "own": mine,
                "zero": 0.0,
                "mean": float(Q[s].mean()),
                "min": float(Q[s].min()),
                "argmax": float(Q[s].argmax()),
                "old max": best_before,
                "discounted": discount * best,
                "added": G + best,
                "with reward": r + discount * best,
                "whole table": float(Q.max()),
                "larger": max(G, best),
                **{f"from {start}": best for start in STARTS},
            }[to]


MISTAKES: Mapping[str, Mapping[str, Any]] = {
    "G is never cut, so this is Monte Carlo: the third line is missing, or it stands behind the loop": {"cut": "never"},
    "G is cut at every action, so only one reward is in each target: cut where Q(S, A) is *below* the largest value": {
        "cut": "always"
    },
    "the condition is upside down: G is cut where the action is *not* the best": {"cut": "inverted"},
    "G is cut at an action that ties with the best where it is not the *first* of them, as argmax finds it: compare its"
    " value with the largest": {"cut": "first of equals"},
    "G is cut at an action that ties with the best where it is not the *last* of them: compare its value with the"
    " largest": {"cut": "last of equals"},
    "G is cut at an action that ties with the best, and is as good: cut only where its value is *below* the largest": {
        "cut": "not above the others"
    },
    "whether the action is the best is asked before the update; ask it after": {"cut": "before"},
    "G is cut before the update, and the value of the action learns from it; the third line comes after the second": {
        "cut": "too early"
    },
    "G is cut before the reward is added; the third line comes last": {"cut": "first"},
    "it asks whether G is below the largest value; ask whether Q(S, A) is": {"cut": "always", "to": "larger"},
    "where G is cut it goes on with the largest *value*, max; argmax is the number of an action": {"to": "argmax"},
    "the loop ends at the exploring action; the steps before it still learn, from the G that was cut": {"cut": "stop"},
    "where G is cut it goes on with the *largest* value of the state, not with that of the action taken": {"to": "own"},
    "where G is cut it goes on with the largest value of the state, not with 0": {"to": "zero"},
    "where G is cut it goes on with the *largest* value of the state, not with the mean": {"to": "mean"},
    "where G is cut it goes on with the *largest* value of the state, not with the smallest": {"to": "min"},
    "the largest value is that of the row before the update; take it after": {"to": "old max"},
    "the largest value is discounted where G is cut, and once more in the next step": {"to": "discounted"},
    "where G is cut the largest value takes its place; it is not added": {"to": "added"},
    "where G is cut the largest value alone takes its place; the next step adds its own reward": {"to": "with reward"},
    "where G is cut it goes on with the largest value of that state, and not of the whole table": {"to": "whole table"},
    "the largest value is that of the row of the state, and not of the whole table": {
        "cut": "below the table",
        "to": "whole table",
    },
    "G takes the largest value also where it is smaller; max(G, ...) keeps lucky returns": {"to": "larger"},
    **starts(
        lambda start: f"the search for the largest value starts from {start}, and all values may be lower",
        lambda start: {"to": f"from {start}"},
    ),
    "the loop runs forwards; go from the last step to the first": {"order": "forwards"},
    "the first step of the episode, number 0, learns nothing: range(length - 1, -1, -1) ends with 0": {
        "steps": "not the first"
    },
    "the last step of the episode learns nothing: start at length - 1": {"steps": "not the last"},
    "only the last step of the episode learns: is a `return` or a `break` inside the loop?": {"steps": "the last"},
    "`rewards[k]` is R_{k+1} already, the reward after step k": {"index": "k + 1"},
    "`k` is the number of the step; the state of that step is self.states[k]": {"index": "k"},
    "the discount is missing: G becomes R + γ G": {"rewards": "undiscounted"},
    "the reward is discounted too; γ belongs to G only": {"rewards": "all discounted"},
    "γ belongs to G, not to the reward": {"rewards": "discounted reward"},
    "the rewards are missing: G becomes R + γ G": {"rewards": "none"},
    "only one reward is in each target: G becomes R + γ G": {"rewards": "only"},
    "the future is subtracted: G becomes R + γ G": {"rewards": "minus"},
    "every step takes the reward of the last one: write rewards[k]": {"rewards": "of the last step"},
    "the old value is not subtracted: Q moves by α [G − Q]": {"step": "no old"},
    "the old value is lost: Q moves by α [G − Q], so write +=": {"step": "only"},
    "α and 1 − α have changed places": {"step": "weights"},
    "Q moves away from the target: the sign is wrong": {"step": "minus"},
    "Q is set to G at once: move it by α [G − Q]": {"step": "replaced"},
    "exploring actions learn nothing; they do, from what came after them": {"step": "skips exploring"},
    "G starts with a value of the state after the end; after a terminal state there is no future": {"start": "value"},
    "G starts with a value of the last state; after the end there is no future, so it starts at 0": {"start": "last"},
}


HARDLY = 1e-3
"""So much less an action is worth that hardly differs from the best one; by rounding it is 1e-15."""


class Case(NamedTuple):
    """Values before learning, and the episodes to learn from, in order."""

    Q: Reals
    episodes: list[Episode]


def cases(seed: int, learning_rate: float) -> list[Case]:
    """Make cases up: episodes of one to five steps, sometimes a second one, and some that end with a tie."""
    rng = np.random.default_rng(seed)
    values = np.arange(-4.0, 8.5, 0.5)
    no_ties = 0.1 * np.arange(N_ACTIONS)  # so that ties come only where they are made
    far_below = [FAR_BELOW * (np.arange(N_STATES) == rng.integers(N_STATES))[:, np.newaxis] for _ in range(24)]
    return [
        Case(
            rng.choice(values, (N_STATES, N_ACTIONS)) + no_ties - far_below[i],
            [make_episode(1 + i % 5, rng), *([make_episode(3, rng)] if i % 3 == 2 else [])],
        )
        for i in range(24)
    ] + [
        _tie(action, other, learning_rate, rng, lead)
        for lead in (0.0, HARDLY)
        for action, other in permutations(range(N_ACTIONS), 2)
    ]


def _tie(action: int, other: int, learning_rate: float, rng: np.random.Generator, lead: float) -> Case:
    """Make a case up in which another action than the last of an episode has a `lead` after its update."""
    Q, episode = rng.choice(np.arange(-4.0, 8.5, 0.5), (N_STATES, N_ACTIONS)), make_episode(3, rng)
    episode.actions[-1], episode.rewards[-1] = action, 4.0
    Q[episode.states[-1]] = -8.0
    Q[episode.states[-1], action] = -2.0
    Q[episode.states[-1], other] = -2.0 + learning_rate * 6.0 + lead  # exact, whatever the order of its terms
    return Case(Q, [episode])


def outcomes(all_cases: Sequence[Case], settings: Settings) -> Iterator[Reals]:
    """Yield the values after each episode of each case."""
    for Q, episodes in all_cases:
        now, stored = Q.copy(), [0.0] * N_STATES
        for episode in episodes:
            stored[: len(episode.rewards)] = episode.rewards
            hand_back(now, episode, **settings, left_over=stored[len(episode.rewards)])
            yield now.copy()


def explained(all_cases: Sequence[Case], found: Sequence[Reals], settings: Settings) -> str:
    """Return the sentence on values that are not right: the first case in which they differ, and the mistake."""
    right = [*outcomes(all_cases, settings)]
    wrong = next(i for i, (one, other) in enumerate(zip(right, found, strict=True)) if not all_same(one, other))
    steps = [(Q, episode, number) for Q, episodes in all_cases for number, episode in enumerate(episodes)]
    Q, episode, number = steps[wrong]
    before = right[wrong - 1] if number else Q
    elsewhere = np.ones(Q.shape, bool)
    elsewhere[episode.states, episode.actions] = False
    why = _why(all_cases, found, settings)
    if why == UNUSUAL and not all_same(before[elsewhere], found[wrong][elsewhere]):
        why = "a value changes that is not on the path: the steps of the episode are 0 to length - 1"
    elif why == UNUSUAL:
        why += f". {_which_line(episode, right[wrong], found[wrong])}"
    return _where(before, episode, number, right[wrong], found[wrong], settings) + why


def _where(before: Reals, episode: Episode, number: int, right: Reals, found: Reals, settings: Settings) -> str:
    """Return the first part of the sentence: the episode, and the first value that is wrong."""
    rows = ", ".join(f"Q[{s}] = {in_brackets(before[s])}" for s in episode.states)
    start = (
        f"after {'a second' if number else 'an'} episode with states {episode.states}, actions {episode.actions} and"
        f" rewards {in_brackets(episode.rewards)}, where α = {settings['learning_rate']:g}, γ ="
        f" {settings['discount']:g} and {rows}, "
    )
    path = zip(episode.states[::-1], episode.actions[::-1], strict=True)
    first = next((entry for entry in path if not all_same(right[entry], found[entry])), None)
    if first is None:
        s, a = map(int, differing(right, found)[0])
        return start + f"Q[{s}, {a}] should stay {right[s, a]:.4g}, but is {found[s, a]:.4g}: "
    asked, mine = float(right[first]), float(found[first])
    return start + f"Q[{first[0]}, {first[1]}] should become {digits(asked, mine)}, but is {digits(mine, asked)}: "


def _which_line(episode: Episode, right: Reals, found: Reals) -> str:
    """Return which of the three lines to look at: the loop goes backwards, so all is right before the first mistake."""
    pairs = [*zip(episode.states, episode.actions, strict=True)]
    k = max(k for k, pair in enumerate(pairs) if not all_same(right[pair], found[pair]))
    if k + 1 == len(pairs):
        return "It is the last step of the episode, where G is still 0, so look at the first two lines"
    s, a = pairs[k + 1]
    if right[s, a] < right[s].max():
        return (
            "The steps after it are right, and at the next one G is cut: look at the third line, and at γ in the first"
        )
    return (
        "The steps after it are right, and at the next one G is not cut: look at your `if`, and at γ in the first line"
    )


def _why(all_cases: Sequence[Case], found: Sequence[Reals], settings: Settings) -> str:
    """Return the mistake that explains every case, or a number that was written in, or two mistakes together."""

    def fits(change: Settings) -> bool:
        return all(map(all_same, outcomes(all_cases, {**settings, **change}), found))

    if nobody_asks_why():
        return UNUSUAL
    if fits({"steps": "none"}):
        return "`hand_back` changes nothing in Q"
    for sentence, change in MISTAKES.items():
        if fits(change):
            return sentence
    if written := _numbers(fits, settings):
        return written
    for (one, first), (two, second) in combinations(MISTAKES.items(), 2):
        if not first.keys() & second.keys() and fits({**first, **second}):
            return f"{one}; and {two}"
    for sentence, change in MISTAKES.items():
        if written := _numbers(fits, settings, change):
            return f"{sentence}; and {written}"
    return UNUSUAL


def _numbers(fits: Callable[[Settings], bool], settings: Settings, change: Settings = NO_CHANGE) -> str:
    """Return what to say of a learning rate or a discount that was written in as a number."""
    rates = (settings["learning_rate"], 0.1, 0.5, 0.2, 0.01, 1.0)
    discounts = (settings["discount"], 1.0, 0.9, 0.99, 0.95)
    for rate, discount in [*product(rates, discounts)][1:]:
        wrong = {"learning_rate": rate, "discount": discount}
        if fits({**change, **wrong}):
            told = [
                f"a {name} of {value:g}: use self.{name}" for name, value in wrong.items() if value != settings[name]
            ]
            return "everything fits " + "; and ".join(told)
    return ""
