"""Made-up episodes, and what REINFORCE with a baseline makes of them: rightly, and with the usual mistakes."""

from collections.abc import Mapping
from functools import partial
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np
from gymnasium.spaces import Discrete, MultiDiscrete

from edugym_course.grading.agents import agent_created_by, learn_step, table_of, with_settings
from edugym_course.grading.cases import telling_draw
from edugym_course.grading.challenge import Sizes
from edugym_course.grading.errors import WrongAnswer, nobody_asks_why
from edugym_course.grading.values import all_same, differing
from edugym_course.lessons.continuous_actions.exercises.slips import MISTAKES

SHAPE = (7, 3)
"""The size of the tables."""
STALE = (0.5, 0.25, 0.25)
"""What stands in `probabilities` before `update`: that of another state."""
OLD = 7.0
"""The reward that an earlier, longer episode has left in every place of `rewards`."""
UNWRITTEN = 0
"""What stands in `states` behind the last step: what `create` has put there."""
BUFFER = 200
"""The steps for which `create` has room."""
SETTINGS: Mapping[str, float] = MappingProxyType({"learning_rate": 0.3, "value_learning_rate": 0.25, "discount": 0.8})

EPISODES = (
    (1, True, False),
    (2, True, False),
    (3, False, False),
    (4, True, False),
    (4, False, False),
    (3, True, True),
)
"""Of each made-up episode, its length, whether it terminates, and whether it comes back to its first state."""


class Case(NamedTuple):
    """Tables, and an episode; it terminates, or is cut off."""

    preferences: Any
    V: Any
    states: list[int]
    actions: list[int]
    rewards: list[float]
    terminates: bool


def cases(seed: int) -> list[Case]:
    """Make episodes up, of 1 to 4 steps, in simple numbers; the last one comes back to its first state."""
    rules = [partial(_numbers, {}, True), *(partial(_numbers, change, False) for change in ({}, *MISTAKES.values()))]
    return _drawn(telling_draw(seed, _drawn, rules))


def _drawn(rng: np.random.Generator) -> list[Case]:
    """Draw the episodes."""
    made = []
    for length, terminates, comes_back in EPISODES:
        preferences = rng.choice([-1.0, -0.5, 0.0, 0.5, 1.0], SHAPE)
        V = rng.choice([-1.0, 0.5, 1.5, 2.0], SHAPE[0])
        states = [int(s) for s in rng.permutation(SHAPE[0])[:length]]
        if comes_back:
            states[-1] = states[0]
        actions = [int(a) for a in rng.integers(SHAPE[1], size=length)]
        rewards = [float(r) for r in rng.choice([-2.0, 1.0, 3.0, 4.0], size=length)]
        made.append(Case(preferences, V, states, actions, rewards, terminates))
    return made


def _numbers(change: Mapping[str, Any], backwards: bool, case: Case) -> Any:
    """Return all numbers that learning leaves."""
    return np.concatenate([part.ravel() for part in after(case, change, backwards=backwards)])


def after(case: Case, change: Mapping[str, Any] = MappingProxyType({}), *, backwards: bool = False) -> tuple[Any, Any]:
    """Return preferences and values after learning.

    Args:
        case: the tables and the episode.
        change: which mistake is made.
        backwards: whether the last step is learned from first. Where no state comes twice, it makes no difference.
    """
    theta, V, n = case.preferences.copy(), case.V.copy(), len(case.states)
    if change.get("cut off") == "forgotten" and not case.terminates:
        return theta, V
    rate, value_rate, discount = (change.get(name, right) for name, right in SETTINGS.items())
    if change.get("rates") == "swapped":
        rate, value_rate = value_rate, rate
    if change.get("rates") == "policy":
        value_rate = rate
    kind_of_return = change.get("return", "G")
    if kind_of_return == "goes on":
        follows = discount * V[case.states[-1]]
        returns = _returns([*case.rewards[:-1], case.rewards[-1] + follows], discount, "G")
    else:
        returns = _returns(case.rewards, discount, kind_of_return)
    states, actions, rewards = case.states, case.actions, case.rewards
    if change.get("steps") == "buffer":
        behind, n = BUFFER - n, BUFFER
        states, actions = [*states, *behind * [UNWRITTEN]], [*actions, *behind * [0]]
        returns, rewards = [*returns, *behind * [OLD]], [*rewards, *behind * [OLD]]
    following = [*states[1:], UNWRITTEN]
    seen = set()
    chosen = change.get("steps", range)
    for t in (range(n) if chosen == "buffer" else [*chosen(n)])[:: -1 if backwards else 1]:
        state, action = following[t] if change.get("state") == "next" else states[t], actions[t]
        if change.get("visits") == "one" and state in seen:
            continue
        seen.add(state)
        number = min(t, SHAPE[0] - 1)  # of the step, where a state should stand
        if change.get("state") == "t":
            state = number
        place = number if change.get("V") == "t" else state
        row = {"last": case.states[-1], "t": number}.get(change.get("row", ""), state)
        known = case.V if change.get("values") == "old" else V
        baseline = {
            "V": known[place],
            "none": 0.0,
            "mean": np.mean(case.rewards),
            "mean return": np.mean(returns),
            "largest": known.max(),
        }[change.get("baseline", "V")]
        delta = returns[t] - baseline
        if change.get("delta") in ("TD", "TD, unwritten"):
            ends = t == n - 1 and change["delta"] == "TD"
            delta = rewards[t] + (0.0 if ends else discount * V[following[t]]) - V[place]
        if change.get("value", "moved") == "moved":
            V[place] += value_rate * delta
        elif change.get("value") == "discounted":
            V[place] += value_rate * discount**t * delta
        elif change.get("value") == "set":
            V[place] = value_rate * delta
        elif change.get("value") == "whole":
            V[place] += delta
        elif change.get("value") == "away":
            V[place] -= value_rate * delta
        elif change.get("value") == "return":
            V[place] += value_rate * returns[t]
        if change.get("late"):
            delta = returns[t] - V[place]
        elif change.get("values") == "afterwards":
            delta = returns[t] - case.V[place]
        if change.get("delta") == "return":
            delta = returns[t]
        elif change.get("delta") == "reward":
            delta = rewards[t]
        elif change.get("delta") == "of the mean":
            delta = returns[t] - float(np.mean(returns))
        elif change.get("delta") == "missing":
            delta = 1.0
        power = {"t": discount**t, "none": 1.0, "end": discount ** (n - 1 - t), "next": discount ** (t + 1)}
        power |= {"once": discount, "end+1": discount ** (n - t), "product": discount * t}
        size, kind = rate * power[change.get("power", "t")] * delta, change.get("score", "full")
        if kind == "θ":
            theta[state] += size * (np.eye(SHAPE[1])[action] - theta[state])
            continue
        if change.get("look") == "often":
            for a in range(SHAPE[1]):
                theta[state, a] += size * _score(_softmax(theta[state]), action, kind)[a]
            continue
        looked_at = case.preferences if change.get("look") in ("old", "first") else theta
        seen_from = {"t": number, "first": case.states[0]}.get(change.get("look", ""), state)
        pi = np.array(STALE) if change.get("look") == "never" else _softmax(looked_at[seen_from])
        step = size * np.eye(SHAPE[1])[action] - pi if kind == "no brackets" else size * _score(pi, action, kind)
        if change.get("preferences") == "rows":
            for a in range(SHAPE[1]):
                theta[a] += step[a]
            continue
        theta[row] = step if change.get("preferences") == "set" else theta[row] + step
    return theta, V


def _softmax(row: Any) -> Any:
    """Return the probabilities of the actions."""
    weights = np.exp(row - row.max())
    return weights / weights.sum()


def _returns(rewards: list[float], discount: float, kind: str) -> list[float]:
    """Return the return from each step, or what stands for it."""
    n = len(rewards)
    G = [sum(discount ** (k - t) * rewards[k] for k in range(t, n)) for t in range(n)]
    return {
        "G": G,
        "reward": rewards,
        "undiscounted": [sum(rewards[t:]) for t in range(n)],
        "first": [G[0]] * n,
        "not the first": [rewards[0], *G[1:]],
        "first zero": [0.0, *G[1:]],
        "next": [*(discount * g for g in G[1:]), 0.0],
        "of the next step": [*G[1:], 0.0],
        "past": [sum(discount ** (t - k) * rewards[k] for k in range(t + 1)) for t in range(n)],
        "discounted reward": [discount * g for g in G],
        "absolute": [sum(discount**k * rewards[k] for k in range(t, n)) for t in range(n)],
        "reversed": G[::-1],
        "last": [rewards[-1]] * n,
        "one more": [G[t] + discount ** (n - t) * OLD for t in range(n)],
        "buffer": [G[t] + discount ** (n - t) * OLD / (1.0 - discount) for t in range(n)],
    }[kind]


def _score(pi: Any, action: int, kind: str) -> Any:
    """Return the score of an action, or what stands for it."""
    one = np.eye(len(pi))[action]
    return {
        "full": one - pi,
        "no brackets": one - pi,
        "one": one,
        "own": one * (1.0 - pi),
        "minus": pi - one,
        "pi": one * pi,
        "inverse": one / pi[action],
        "others": -pi,
        "all as taken": 1.0 - pi,
        "plus": one + pi,
        "one or π": one - (1.0 - one) * pi,
        "others plus": one * (1.0 - pi) + (1.0 - one) * pi,
    }[kind]


def check_update(kind: Any, seed: int, cost: float) -> None:
    """Check how a student's agent learns from episodes.

    Args:
        kind: her class.
        seed: the number from which the episodes are drawn.
        cost: what is to be subtracted from each reward.

    Raises:
        WrongAnswer: it learns something else.
    """
    made = cases(seed)
    found = [_learned(kind, case) for case in made]
    if all(
        np.array_equal(theta, case.preferences) and np.array_equal(V, case.V)
        for case, (theta, V) in _pairs(made, found)
    ):
        raise WrongAnswer("update changes neither `preferences` nor `V`: change the entries of these arrays in place")
    shown, made = made, [case._replace(rewards=[reward - cost for reward in case.rewards]) for case in made]
    for told, case, outcome in zip(shown, made, found, strict=True):
        right = after(case)
        if _same(right, outcome) or _same(after(case, backwards=True), outcome):
            continue
        singles = [why for why, change in MISTAKES.items() if _explains(change, made, found)]
        pairs = [] if singles or nobody_asks_why() else _two_mistakes(made, found)
        why = [*singles, *pairs, "that is none of the usual mistakes, so follow this episode by hand"][0]
        raise WrongAnswer(f"{_told(told, right, outcome)}: {why}")


def _pairs(made: list[Case], found: list[Any]) -> Any:
    return list(zip(made, found, strict=True))


def _two_mistakes(made: list[Case], found: list[Any]) -> list[str]:
    """Return the sentence about two mistakes that fit together, if there are such."""
    items = list(MISTAKES.items())
    for i, (one, first) in enumerate(items):
        for other, second in items[i + 1 :]:
            if not first.keys() & second.keys() and _explains({**first, **second}, made, found):
                return [f"{one}; and {other}"]
    return []


def _explains(change: Mapping[str, Any], made: list[Case], found: list[Any]) -> bool:
    """Whether a mistake gives what was found in every case, when the steps are taken in order or backwards."""
    return any(
        all(_same(after(case, change, backwards=backwards), outcome) for case, outcome in _pairs(made, found))
        for backwards in (False, True)
    )


def _same(one: Any, other: Any) -> bool:
    return all(map(all_same, one, other))


def _told(case: Case, right: Any, found: Any) -> str:
    """Return what was expected, and what came."""
    tables = zip(("preferences", "V"), (case.preferences, case.V), right, found, strict=True)
    name, before, expected, mine = next(four for four in tables if len(differing(*four[2:])))
    entry = tuple(int(i) for i in differing(expected, mine)[0])
    index, state = ", ".join(map(str, entry)), entry[0]
    from_, to = f"{before[entry]:.4g}", f"{expected[entry]:.4g}"
    should = f"should stay at {to}" if from_ == to else f"should go from {from_} to {to}"
    return (
        f"after the episode with states {case.states}, actions {case.actions} and rewards {case.rewards}, where"
        f" γ = {SETTINGS['discount']:g}, α^θ = {SETTINGS['learning_rate']:g},"
        f" α^w = {SETTINGS['value_learning_rate']:g}, V[{state}] = {case.V[state]:g} and"
        f" preferences[{state}] = {case.preferences[state].tolist()}, {name}[{index}] {should},"
        f" but is {mine[entry]:.4g}"
    )


def _learned(kind: Any, case: Case) -> tuple[Any, Any]:
    """Return the tables of a student's agent after an episode."""
    task = Sizes(MultiDiscrete([SHAPE[0]]), Discrete(SHAPE[1]))
    agent = agent_created_by("MyREINFORCE", kind, "task", task)
    agent = with_settings("MyREINFORCE", agent, SETTINGS, "update")
    tables = {"preferences": case.preferences, "V": case.V, "probabilities": np.array(STALE)}
    for name, values in tables.items():
        table_of(agent, name, values.shape)[...] = values
    table_of(agent, "rewards", None)[...] = OLD
    last = len(case.states) - 1
    for t, (state, action, reward) in enumerate(zip(case.states, case.actions, case.rewards, strict=True)):
        step = {
            "state": state,
            "action": action,
            "reward": reward,
            "next_state": case.states[t + 1] if t < last else state,
            "next_action": case.actions[t + 1] if t < last else action,
            "terminated": t == last and case.terminates,
            "truncated": t == last and not case.terminates,
        }
        learn_step(agent, step)
    return table_of(agent, "preferences", SHAPE).copy(), table_of(agent, "V", SHAPE[:1]).copy()
