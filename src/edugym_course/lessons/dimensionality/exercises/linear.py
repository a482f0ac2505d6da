"""Exercise 2 of lesson 4: semi-gradient Q-learning."""

from collections.abc import Callable, Mapping
from functools import partial
from types import MappingProxyType
from typing import Annotated, Any, NamedTuple

import numpy as np

from edugym_course.grading.agents import agent_with_table, learn_step, require_class, table_of
from edugym_course.grading.cases import FAR_BELOW, from_a_start, starts, telling_draw
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.mistakes import UNUSUAL, NumberCase, compare_all, mistake_in_cases
from edugym_course.grading.own_numbers import step_cost, told_less
from edugym_course.grading.student_code import student_code
from edugym_course.grading.values import all_same, differing, digits, in_brackets, number


class Step(NamedTuple):
    """A case for the update: two states whose features are made up, and what happened."""

    w: Any
    x: Any
    action: int
    reward: float
    x_next: Any
    next_action: int
    terminated: bool
    truncated: bool
    alpha: float
    gamma: float


Rule = Callable[[Step], Any]
PIXELS = (1.0, 0.0, 1.0, 1.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0)
"""The first numbers of every made-up board; its features stand behind them."""


def _board(x: Any) -> Any:
    """Return a board with these features; it is longer, so that who takes it for the features is found out."""
    return np.concatenate((PIXELS, x))


def _moved(
    step: Step,
    target: float,
    *,
    of: float | None = None,
    by: Any = None,
    rate: float | None = None,
    columns: Any = None,
) -> Any:
    """Return the weights after a step towards a target."""
    w = step.w.copy()
    present = _here(step) if of is None else of
    size = (step.alpha if rate is None else rate) * (target - present)
    for column in [step.action] if columns is None else columns:
        w[:, column] += size * (step.x if by is None else by)
    return w


def _target(step: Step, value: Callable[[Any], float] = np.max, gamma: float | None = None, ends: bool = True) -> float:
    """Return the target of Q-learning, or one like it."""
    if step.terminated and ends:
        return step.reward
    return step.reward + (step.gamma if gamma is None else gamma) * float(value(step.x_next @ step.w))


def right_update(step: Step) -> Any:
    """Return the weights after the semi-gradient update of Q-learning."""
    return _moved(step, _target(step))


UPDATES: Mapping[str, Rule] = MappingProxyType(
    {
        "after a terminal state nothing follows: there the target is the reward alone": lambda s: _moved(
            s, _target(s, ends=False)
        ),
        "the target misses the value of the next state": lambda s: _moved(s, s.reward),
        "the discount is missing: multiply the value of the next state by it": lambda s: _moved(
            s, _target(s, gamma=1.0)
        ),
        "take the maximum over the actions in the next state, not the mean": lambda s: _moved(s, _target(s, np.mean)),
        "take the maximum over the actions in the next state, not the minimum": lambda s: _moved(s, _target(s, np.min)),
        "that is the *number* of the best action in the next state; take its value, by max and not by argmax": (
            lambda s: _moved(s, _target(s, lambda q: float(np.argmax(q))))
        ),
        "take the largest value in the next state, and not the largest without its sign": lambda s: _moved(
            s, _target(s, lambda q: float(np.abs(q).max()))
        ),
        "the step is twice as large as it should be: the error times the feature is the whole step": lambda s: _moved(
            s, _target(s), rate=2 * s.alpha
        ),
        "take the maximum over the actions in the next state, not their sum": lambda s: _moved(s, _target(s, np.sum)),
        "in the next state take the best action, not the one that was taken before": lambda s: _moved(
            s, _target(s, lambda q: float(q[s.action]))
        ),
        "in the next state take the best action, not the one that comes next: that is SARSA": lambda s: _moved(
            s, _target(s, lambda q: float(q[s.next_action]))
        ),
        "a truncated episode is treated as terminated, but only its clock ran out: the value of the next state still"
        " counts": lambda s: _moved(s, s.reward if s.truncated else _target(s)),
        "that is the next state's value of the last action alone; take the largest one of all three": lambda s: _moved(
            s, _target(s, lambda q: float(q[-1]))
        ),
        "a feature keeps its sign: multiply by the feature itself": lambda s: _moved(s, _target(s), by=np.abs(s.x)),
        "only the weight of the largest feature moves; all move whose feature is not 0": lambda s: _moved(
            s, _target(s), by=np.where(np.arange(len(s.x)) == s.x.argmax(), s.x, 0.0)
        ),
        "that is the next state's value of action 0 alone; take the largest one of all three": lambda s: _moved(
            s, _target(s, lambda q: float(q[0]))
        ),
        "the target has the features of `state` where those of `next_state` belong": lambda s: _moved(
            s, s.reward + (0.0 if s.terminated else s.gamma * float(np.max(s.x @ s.w)))
        ),
        "the features are missing: each weight moves by the error times *its* feature": lambda s: _moved(
            s, _target(s), by=np.ones_like(s.x)
        ),
        "each weight moves by the error times its feature of `state`, not of `next_state`": lambda s: _moved(
            s, _target(s), by=s.x_next
        ),
        "only the sign of the feature, or whether it is 0, counts here; multiply by the feature itself": (
            lambda s: _moved(s, _target(s), by=(s.x != 0.0).astype(float))
        ),
        "use `self.learning_rate` in place of 0.1: the check takes another one": lambda s: _moved(
            s, _target(s), rate=0.1
        ),
        "use `self.discount` in place of 0.9: the check takes another one": lambda s: _moved(s, _target(s, gamma=0.9)),
        "use `self.learning_rate` and `self.discount` in place of 0.1 and 0.9: the check takes others": lambda s: (
            _moved(s, _target(s, gamma=0.9), rate=0.1)
        ),
        "compute the error once, before any weight moves": lambda s: _in_a_loop(s, lambda w: _target(s)),
        "compute the target and the error once, before any weight moves": lambda s: _in_a_loop(
            s, lambda w: _target(s._replace(w=w))
        ),
        "compute the target once, before any weight moves": lambda s: _in_a_loop(
            s, lambda w: _target(s._replace(w=w)), of=_here(s)
        ),
        "the learning rate is missing": lambda s: _moved(s, _target(s), rate=1.0),
        "the error has the wrong sign: it is the target less the present value": lambda s: _moved(
            s, _target(s), rate=-s.alpha
        ),
        "the present value is missing in the error: target less value": lambda s: _moved(s, _target(s), of=0.0),
        "only the column of the action that was taken changes, not all of them": lambda s: _moved(
            s, _target(s), columns=range(s.w.shape[1])
        ),
        "only the column of the action that was taken changes; the others have learned nothing, whatever their own"
        " error": lambda s: s.w + s.alpha * np.outer(s.x, _target(s) - s.x @ s.w),
        "that is the present state's value of the action that is best in the next state; take that of the next state": (
            lambda s: _moved(s, _target(s, lambda q: float((s.x @ s.w)[q.argmax()])))
        ),
        "the last action is left out of the maximum: range(3) goes through all three": lambda s: _moved(
            s, _target(s, lambda q: float(q[:-1].max()))
        ),
        "action 0 is left out of the maximum": lambda s: _moved(s, _target(s, lambda q: float(q[1:].max()))),
        "that is the largest of all weights; take the largest *value* of the next state": lambda s: _moved(
            s, _target(s, lambda q: float(s.w.max()))
        ),
        "the reward is discounted as well; only the next value should be": lambda s: _moved(
            s, s.reward if s.terminated else s.gamma * (s.reward + float((s.x_next @ s.w).max()))
        ),
        "the reward is discounted as well, also at the end; only the next value should be": lambda s: _moved(
            s, s.gamma * (s.reward + (0.0 if s.terminated else float((s.x_next @ s.w).max())))
        ),
        "the error is squared; the derivative of half its square is the error itself": lambda s: _moved(
            s, (_target(s) - _here(s)) ** 2, of=0.0
        ),
        "half the error squared is the loss; its derivative is the error itself": lambda s: _moved(
            s, 0.5 * (_target(s) - _here(s)) ** 2, of=0.0
        ),
        "the weights are not moved but set: use += instead of =": lambda s: _set(s),
        "that is the full gradient, with the features of the next state in it; the semi-gradient leaves it out": (
            lambda s: _full_gradient(s)
        ),
        "the present value is that of the best action; it should be that of the action that was taken": lambda s: (
            _moved(s, _target(s), of=float(np.max(s.x @ s.w)))
        ),
        "the reward is missing in the target": lambda s: _moved(s, _target(s) - s.reward),
        "it learns nothing after a terminal state; the reward of the last step counts as well": lambda s: (
            s.w.copy() if s.terminated else _moved(s, _target(s))
        ),
        "at the end the target is the reward, not 0": lambda s: _moved(s, 0.0 if s.terminated else _target(s)),
        "the terminal case is the wrong way round": lambda s: _moved(
            s, _target(s, ends=False) if s.terminated else s.reward
        ),
        "nothing changes: change the entries of `self.w` in place": lambda s: s.w.copy(),
        "the step is divided by the sum of the squares of the features; the error times the feature is all": (
            lambda s: _moved(s, _target(s), rate=s.alpha / float(s.x @ s.x))
        ),
        "only the weights of positive features move; a feature below 0 counts as well, with its sign": lambda s: _moved(
            s, _target(s), by=np.maximum(s.x, 0.0)
        ),
        "the features are multiplied in twice": lambda s: _moved(s, _target(s), by=s.x * s.x),
        **starts(
            lambda start: f"all values may be lower: start the search with one of them, not with {start}",
            lambda start: lambda s: _moved(s, _target(s, partial(from_a_start, start=start))),
        ),
    }
)
"""By sentence, what each mistake makes of the weights."""


def _here(step: Step) -> float:
    """Return the present value of the action that was taken."""
    return float(step.x @ step.w[:, step.action])


def _in_a_loop(step: Step, target: Callable[[Any], float], of: float | None = None) -> Any:
    """Return the weights if the error, or with `of` its target alone, is computed again after each has moved."""
    w = step.w.copy()
    for i, feature in enumerate(step.x):
        present = float(step.x @ w[:, step.action]) if of is None else of
        w[i, step.action] += step.alpha * (target(w) - present) * feature
    return w


def _set(step: Step) -> Any:
    w = step.w.copy()
    error = _target(step) - _here(step)
    w[:, step.action] = step.alpha * error * step.x
    return w


def _full_gradient(step: Step) -> Any:
    w = _moved(step, _target(step))
    if not step.terminated:
        values = step.x_next @ step.w
        error = _target(step) - _here(step)
        w[:, int(np.argmax(values))] -= step.alpha * step.gamma * error * step.x_next
    return w


Cost = Annotated[float, step_cost("It still catches as many balls: only the values are lower.")]


def exercise_2(answer: Any, seed: int, cost: Cost = 0.0) -> str:
    """Check the class of an agent with linear features, which learns from rewards less a cost."""
    require_class("MyAgent", answer)
    features = {"features": lambda self, board: np.array(board[len(PIXELS) :], float), "__slots__": ()}
    probe = type("MyAgent", (answer,), features)
    cases = steps_for(seed)
    _check_values(probe, cases)
    outcomes = [_learned(_made(probe, step), step) for step in cases]
    pairs = [(step._replace(reward=step.reward - cost), w) for step, w in zip(cases, outcomes, strict=True)]
    wrong = [not _gives(*pair, right_update) for pair in pairs]
    if any(wrong):
        otherwise = _part_that_is_wrong(pairs, wrong.index(True))
        why = mistake_in_cases(UPDATES, lambda rule: [_gives(*pair, rule) for pair in pairs], wrong, otherwise)
        raise WrongAnswer(f"{_told_update(*pairs[wrong.index(True)])}{told_less(cost)}: {why}")
    return "Right: the error times the features. See it catch:"


def _part_that_is_wrong(pairs: list[tuple[Step, Any]], first: int) -> str:
    """Return what to look at if no usual mistake fits: which weights move, in which proportion, or how far."""
    columns = [np.delete(w - step.w, step.action, axis=1) for step, w in pairs]
    if any(column.any() for column in columns):
        return "other weights move than those of the action, `self.w[:, action]`"
    sizes = [float(step.x @ (w - step.w)[:, step.action] / (step.x @ step.x)) for step, w in pairs]
    along = [_moved(step, size, of=0.0, rate=1.0) for (step, _), size in zip(pairs, sizes, strict=True)]
    if not all(all_same(moved, w) for moved, (_, w) in zip(along, pairs, strict=True)):
        return "the weights of the action do not move in proportion to the features of `state`"
    step, _ = pairs[first]
    target, right = sizes[first] / step.alpha + _here(step), _target(step)
    return (
        "each weight moves in proportion to its feature, and that is right. If the learning rate and the present value"
        f" are right as well, your target is {digits(target, right)} here, and should be {digits(right, target)}"
    )


def steps_for(seed: int) -> list[Step]:
    """Return the cases of a check."""
    return made_up_steps(telling_draw(seed, made_up_steps, [right_update, *UPDATES.values()]))


def made_up_steps(rng: np.random.Generator) -> list[Step]:
    """Make cases up: ordinary steps, steps after which the episode is cut off, and last ones."""
    return [
        _some_step(rng, terminated=k % 3 == 2, truncated=k % 3 == 1, least={3: -30, 4: -int(FAR_BELOW)}.get(k, -3))
        for k in range(9)
    ]


def _some_step(rng: np.random.Generator, terminated: bool, truncated: bool, least: int) -> Step:
    """Make a case up: simple numbers, several features that are not 0, and three different actions.

    These are the one that was taken, the one that comes next, and the best one in the next state. With weights from
    `least` on all values are far below 0.
    """
    while True:
        w = rng.integers(least, least + 7, size=(9, 3)).astype(float)
        x, x_next = (rng.permutation([1.0, 2.0, -1.0, *6 * [0.0]]) for _ in range(2))
        action = int(rng.integers(3))
        values, here = x_next @ w, x @ w
        best = int(np.argmax(values))
        if best != action and len({*values}) == 3 and int(np.argmax(here)) != action and not np.array_equal(x, x_next):
            reward, other = float(rng.integers(2, 5)), 3 - action - best
            return Step(w, x, action, reward, x_next, other, terminated, truncated, 0.25, 0.625)


def _made(cls: Any, step: Step) -> Any:
    """Make an agent of the student's."""
    settings = {"learning_rate": step.alpha, "discount": step.gamma}
    agent = agent_with_table("MyAgent", cls, step.w.shape, settings, "w")
    table_of(agent, "w", step.w.shape)[...] = step.w
    return agent


VALUES: Mapping[str, Callable[[Step, int], float]] = MappingProxyType(
    {
        "that is the sum of the weights; multiply each by its feature": lambda s, a: float(s.w[:, a].sum()),
        "that is one term of the sum; take the sum over all features": lambda s, a: float(s.x[0] * s.w[0, a]),
        "that is the largest value of all actions; take the column of `action`": lambda s, a: float((s.x @ s.w).max()),
        "that is the sum over all actions; take the column of `action`": lambda s, a: float((s.x @ s.w).sum()),
        "a feature is not only 0 or 1: multiply by it": lambda s, a: float((s.w[:, a] * (s.x != 0)).sum()),
        "each weight with a feature above 0 counts once; multiply by the feature, which may be below 0 too": (
            lambda s, a: float((s.w[:, a] * (s.x > 0)).sum())
        ),
        "features below 0 are left out; they count as well, with their sign": lambda s, a: float(
            (s.w[:, a] * np.maximum(s.x, 0.0)).sum()
        ),
        "the features count without their signs; multiply by the feature itself": lambda s, a: float(
            (s.w[:, a] * np.abs(s.x)).sum()
        ),
        "that is the mean; take the sum": lambda s, a: float((s.x * s.w[:, a]).mean()),
        "those are the numbers of the board in place of its features: call self.features(board)": lambda s, a: float(
            PIXELS[: len(s.x)] @ s.w[:, a]
        ),
        "only the largest feature counts here, but several may not be 0: take the sum over all features": (
            lambda s, a: float(s.w[s.x.argmax(), a])
        ),
        "that is the row of w with this number; take the column": lambda s, a: float((s.x[:3] * s.w[a]).sum()),
    }
)
"""By sentence, what each mistake makes of the value of an action."""


def _check_values(probe: Any, cases: list[Step]) -> None:
    """Check the values of all actions; a mistake is best named if it explains all of them."""
    found = []
    for step in [*cases, cases[0]._replace(w=cases[0].w + 0.25)]:  # the last has values that are no whole numbers
        agent = _made(probe, step)
        for action in range(3):
            column = step.w[:, action]
            call = f"value with the features {in_brackets(step.x)} and action {action}, where column {action} of w is "
            mistakes = {why: rule(step, action) for why, rule in VALUES.items()}
            found.append(
                NumberCase(call + in_brackets(column), _value(agent, step, action), float(step.x @ column), mistakes)
            )
    compare_all(found, otherwise=UNUSUAL)


def _value(agent: Any, step: Step, action: int) -> float:
    """Return what the student's `value` gives, a number."""
    with student_code("value(...)"):
        found = agent.value(_board(step.x), action)
    if not np.array_equal(table_of(agent, "w", step.w.shape), step.w):
        raise WrongAnswer("value changes the entries of `self.w`; it should only read them, for `learn` changes them")
    return number("value(...)", found)


def _learned(agent: Any, step: Step) -> Any:
    """Return the weights after the student's `learn`."""
    before = agent.w
    told = {
        "state": _board(step.x),
        "action": step.action,
        "reward": step.reward,
        "next_state": _board(step.x_next),
        "next_action": step.next_action,
        "terminated": step.terminated,
        "truncated": step.truncated,
    }
    learn_step(agent, told)
    if not (np.array_equal(told["state"], _board(step.x)) and np.array_equal(told["next_state"], _board(step.x_next))):
        raise WrongAnswer("learn writes into `state` or `next_state`, which belong to the task: change `self.w` alone")
    if agent.w is not before:
        raise WrongAnswer("learn should change the entries of `self.w` in place, but puts another array there")
    return before.copy()


def _gives(step: Step, found: Any, rule: Rule) -> bool:
    """Whether a rule gives the weights that were found."""
    return all_same(rule(step), found)


def _told_update(step: Step, found: Any) -> str:
    """Return the first part of the sentence: what was expected in which case, and what came."""
    right = right_update(step)
    i, a = differing(right, found)[0]
    change = f"go from {step.w[i, a]:g} to {digits(right[i, a], found[i, a])}"
    change = change if right[i, a] != step.w[i, a] else f"stay at {step.w[i, a]:g}"
    ended = "the episode over" if step.terminated else f"next features {in_brackets(step.x_next)} with the values "
    ended += "" if step.terminated else in_brackets(step.x_next @ step.w)
    return (
        f"with α = {step.alpha:g}, γ = {step.gamma:g}, features {in_brackets(step.x)}, action {step.action} of the"
        f" value {step.x @ step.w[:, step.action]:g}, reward {step.reward:g} and {ended}, w[{i}, {a}] should {change},"
        f" but is {digits(found[i, a], right[i, a])}"
    )
