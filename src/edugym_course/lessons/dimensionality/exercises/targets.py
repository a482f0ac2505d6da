"""Exercise 3 of lesson 4: the target of DQN, and the draw from its memory."""

from collections.abc import Callable, Iterator, Mapping
from types import MappingProxyType
from typing import Annotated, Any, NamedTuple

import numpy as np

from edugym.agents.dqn import Layers, forward
from edugym_course.grading.agents import agent_created_by, require_class
from edugym_course.grading.cases import FAR_BELOW, from_a_start, starts, telling_draw
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.mistakes import mistake_in_cases
from edugym_course.grading.own_numbers import step_cost, told_less
from edugym_course.grading.student_code import student_code
from edugym_course.grading.values import digits, in_brackets, number, same
from edugym_course.lessons.dimensionality.open_dqn import OpenDQN

ROWS = (0, 1, 2, 3, 2, 1)
"""The rows of which the targets are checked; an episode ends in row 2."""
NEARLY_1 = 1.0 - 2.0**-40
"""Whoever cuts off n times this has n - 1."""
STALE = (11.0, 17.0, 13.0)
"""What stands in `Q` before: the values of another state."""


class Remembered(NamedTuple):
    """A transition in the memory of a small DQN, with what both networks say of both states.

    Attributes:
        reward: of the transition.
        terminated: whether it ended the episode.
        gamma: the discount.
        action: that was taken.
        old_next: the old network's values of the next state.
        new_next: those of the present network.
        old_here: the old network's values of the state.
        new_here: those of the present network.
    """

    reward: float
    terminated: bool
    gamma: float
    action: int
    old_next: Any
    new_next: Any
    old_here: Any
    new_here: Any


def _bootstrapped(case: Remembered, value: float, gamma: float | None = None, ends: bool = True) -> float:
    if case.terminated and ends:
        return case.reward
    return case.reward + (case.gamma if gamma is None else gamma) * value


def _right(case: Remembered) -> float:
    """Return the target of DQN."""
    return _bootstrapped(case, float(case.old_next.max()))


SIGN = "a reward may be negative: take it as it is"
FROM_STARTS: Mapping[str, Callable[[Remembered], float]] = starts(
    lambda start: f"all values may be lower: the largest one is one of them, and not {start}",
    lambda start: lambda c: _bootstrapped(c, from_a_start(c.old_next, start)),
)
"""The searches for the largest value that only low values tell from the right one."""
OF_SOME_ACTIONS: Mapping[str, Callable[[Remembered], float]] = MappingProxyType(
    {
        "the index is missing: that is the value of action 0, and the largest one is needed": lambda c: _bootstrapped(
            c, c.old_next[0]
        ),
        "the last action is left out of the maximum: its number is the number of actions less 1": lambda c: (
            _bootstrapped(c, c.old_next[:-1].max())
        ),
        "action 0 is left out of the maximum": lambda c: _bootstrapped(c, c.old_next[1:].max()),
    }
)
"""What gives the right target wherever the best action is among those that are looked at."""
TARGETS: Mapping[str, Callable[[Remembered], float]] = MappingProxyType(
    {
        "after a terminal state nothing follows: where `terminated` is 1 the target is the reward alone": lambda c: (
            _bootstrapped(c, c.old_next.max(), ends=False)
        ),
        "the values of the next state come from the old weights, `self.target`": lambda c: _bootstrapped(
            c, c.new_next.max()
        ),
        "the value should be that of the next state, `memory.next_states[row]`": lambda c: _bootstrapped(
            c, c.old_here.max()
        ),
        "the value should be that of the next state, by the old weights `self.target`": lambda c: _bootstrapped(
            c, c.new_here.max()
        ),
        SIGN: lambda c: _bootstrapped(c._replace(reward=abs(c.reward)), c.old_next.max()),
        "the value of the next state is added, not subtracted": lambda c: _bootstrapped(c, -c.old_next.max()),
        "the discount is missing": lambda c: _bootstrapped(c, c.old_next.max(), gamma=1.0),
        "take the largest value, not the mean": lambda c: _bootstrapped(c, c.old_next.mean()),
        "take the largest value, not the smallest": lambda c: _bootstrapped(c, c.old_next.min()),
        "take the largest value, not the sum": lambda c: _bootstrapped(c, c.old_next.sum()),
        "take the best action in the next state, not the one that was taken before": lambda c: _bootstrapped(
            c, c.old_next[c.action]
        ),
        "that is what an earlier call left in `self.Q`: call dqn.forward(self.target, ...) first": lambda c: (
            _bootstrapped(c, max(STALE))
        ),
        "that is the number of the best action; its value is needed": lambda c: _bootstrapped(
            c, float(c.old_next.argmax())
        ),
        "the value of the next state is missing": lambda c: c.reward,
        "at the end of an episode the target is the reward, not 0": lambda c: (
            0.0 if c.terminated else _bootstrapped(c, c.old_next.max())
        ),
        "the terminal case is the wrong way round": lambda c: (
            c.reward + c.gamma * c.old_next.max() if c.terminated else c.reward
        ),
        "the reward is missing": lambda c: _bootstrapped(c, c.old_next.max()) - c.reward,
        "the reward is discounted as well; only the next value should be": lambda c: (
            c.reward if c.terminated else c.gamma * (c.reward + c.old_next.max())
        ),
        "the present value belongs to the error, not to the target": lambda c: (
            _bootstrapped(c, c.old_next.max()) - c.new_here[c.action]
        ),
        "that is the target of double DQN: here the old weights choose the action as well": lambda c: _bootstrapped(
            c, c.old_next[c.new_next.argmax()]
        ),
        "use `self.discount` in place of 0.9: the check takes another one": lambda c: _bootstrapped(
            c, c.old_next.max(), gamma=0.9
        ),
        "take the largest value, and not the largest without its sign": lambda c: _bootstrapped(
            c, float(np.abs(c.old_next).max())
        ),
        **FROM_STARTS,
        **OF_SOME_ACTIONS,
    }
)
"""By sentence, what each mistake gives as a target."""


Cost = Annotated[float, step_cost("(So $y$ is lower, and the lines of the race are others.)")]


def exercise_3(answer: Any, seed: int, cost: Cost = 0.0) -> str:
    """Check the class of a DQN, whose targets have the rewards less a cost."""
    require_class("MyDQN", answer)
    _require_own_methods(answer)
    agent = _made(answer, 4, discount=0.75)
    cases, found = [], []
    for row, case in made_up_memories(agent, drawn_for(agent, seed)):
        before = _tables(agent)
        agent.Q[0] = STALE
        with student_code(f"target_of({row})"):
            target = agent.target_of(row)
        for name, values in _tables(agent).items():
            if not np.array_equal(values, before[name]):
                raise WrongAnswer(
                    f"target_of({row}) changes `self.{name}`; it should only read it, and return a number"
                )
        cases.append(case._replace(reward=case.reward - cost))
        found.append(number(f"target_of({row})", target))
    _check_targets(cases, found, cost)
    for steps, size in ((3, 8), (8, 8), (21, 8), (1, 5), (5, 40)):
        _check_rows(answer, steps, size)
    return "Right: an old network gives the target, and every transition in memory has the same chance. See it learn:"


def _require_own_methods(answer: Any) -> None:
    """Refuse a class whose target and rows are those of the package, or are used by nobody."""
    if not issubclass(answer, OpenDQN):
        raise WrongAnswer(
            "MyDQN should begin with `class MyDQN(OpenDQN):`, as it is OpenDQN that calls `target_of` and `row_for`"
        )
    for name in ("target_of", "row_for"):
        if getattr(answer, name) is getattr(OpenDQN, name):
            raise WrongAnswer(
                f"MyDQN has no method `{name}` of its own, so it uses that of OpenDQN: is the name spelt as in the"
                " exercise, and does the method stand inside the class?"
            )


def _made(answer: Any, memory_size: int, **settings: float) -> Any:
    """Make a small network of the student's: two numbers in, three actions."""
    sizes = {"hidden": 2, "memory_size": memory_size, "batch_size": 2}
    return agent_created_by("MyDQN", answer, "board", (2, 3), {**sizes, **settings})


def _tables(agent: Any) -> dict[str, Any]:
    """Return copies of what a target is computed from, by name."""
    parts = {"memory": agent.memory, "weights": agent.weights, "target": agent.target}
    return {
        f"{part}.{name}": values.copy() for part, fields in parts.items() for name, values in fields._asdict().items()
    }


def made_up_memories(agent: Any, rng: np.random.Generator) -> Iterator[tuple[int, Remembered]]:
    """Yield rows of the memory, each when it is filled."""
    for row in ROWS:
        yield row, _some_memory(agent, row, rng)


def drawn_for(agent: Any, seed: int) -> np.random.Generator:
    """Return the generator from which the memories of a check are drawn."""
    return telling_draw(
        seed, lambda rng: [case for _, case in made_up_memories(agent, rng)], [_right, *TARGETS.values()]
    )


def _some_memory(agent: Any, row: int, rng: np.random.Generator) -> Remembered:
    """Fill a row of the memory with a transition, and make weights up for which the usual mistakes differ."""
    memory = agent.memory
    while True:
        for layers in (agent.weights, agent.target):
            for layer in layers:
                layer[:] = rng.integers(-3, 4, size=layer.shape)
        if row == ROWS[0]:
            agent.target.second[-1] -= FAR_BELOW
        memory.states[:] = rng.integers(0, 3, size=memory.states.shape)
        memory.next_states[:] = rng.integers(0, 3, size=memory.next_states.shape)
        memory.actions[:] = rng.integers(3, size=4)
        memory.rewards[:] = rng.permutation([-2.0, 1.0, 3.0, 4.0])
        memory.terminated[:] = np.roll([0, 0, 1, 0], int(rng.integers(4)))
        memory.terminated[row] = int(row == 2)
        values = [
            _values(weights, state[row])
            for state in (memory.next_states, memory.states)
            for weights in (agent.target, agent.weights)
        ]
        old_next, new_next, old_here, new_here = values
        case = Remembered(
            float(memory.rewards[row]),
            bool(memory.terminated[row]),
            agent.discount,
            int(memory.actions[row]),
            old_next,
            new_next,
            old_here,
            new_here,
        )
        going_on = case._replace(terminated=False)
        elsewhere = {why for why in TARGETS if "terminal" in why or "end of" in why}
        elsewhere |= {SIGN, *FROM_STARTS, *OF_SOME_ACTIONS}
        wrong = [rule(going_on) for why, rule in TARGETS.items() if why not in elsewhere]
        if not any(same(value, _bootstrapped(going_on, old_next.max())) for value in wrong):
            return case


def _values(weights: Layers, x: Any) -> Any:
    """Return the action values of a state."""
    values = np.zeros((1, weights.second.shape[1]))
    forward(weights, np.array(x, float), np.zeros(weights.first.shape[1]), values)
    return values[0]


def _check_targets(cases: list[Remembered], found: list[float], cost: float) -> None:
    pairs = [*zip(cases, found, strict=True)]
    wrong = [not _gives(*pair, _right) for pair in pairs]
    if not any(wrong):
        return
    why = mistake_in_cases(TARGETS, lambda rule: [_gives(*pair, rule) for pair in pairs], wrong)
    case, target = pairs[wrong.index(True)]
    right = _right(case)
    raise WrongAnswer(
        f"with reward {case.reward:g}{told_less(cost)}, terminated = {int(case.terminated)}, γ = {case.gamma:g} and"
        f" the values {in_brackets(case.old_next)} of the next state by the old weights, target_of should return"
        f" {digits(right, target)}, but returns {digits(target, right)}: {why}"
    )


def _gives(case: Remembered, target: float, rule: Callable[[Remembered], float]) -> bool:
    """Whether a rule gives the target that was found."""
    return same(target, float(rule(case)))


def _check_rows(answer: Any, steps: int, size: int) -> None:
    """Check that every transition in memory has the same chance."""
    agent = _made(answer, size)
    agent.steps[0] = steps
    filled = min(steps, size)
    with student_code("row_for(0.5)"):
        again = {str(agent.row_for(0.5)) for _ in range(20)}
    if agent.steps[0] != steps:
        raise WrongAnswer("row_for(0.5) changes `self.steps`: only read it, and return a place")
    if len(again) > 1:
        raise WrongAnswer(
            "row_for(0.5) gives another place in every call: the random number is drawn already, it is `u`"
        )
    where = f"after {steps} transitions, in a memory of {size} places"
    us = [0.0, *((np.arange(120 * filled) + 0.5) / (120 * filled)).tolist()]
    rows = [_row(agent, u) for u in us]
    for u, row in zip(us, rows, strict=True):
        if not 0 <= row < filled:
            raise WrongAnswer(
                f"{where}, row_for({u:.3g}) is {row}, but the places 0 to {filled - 1} are filled:"
                f" {_why_uneven(agent, us, rows, filled)}"
            )
    if np.abs(np.bincount(rows[1:], minlength=filled) - 120).max() > 1:
        why = _why_uneven(agent, us, rows, filled)
        raise WrongAnswer(f"{where}, every filled place should be equally likely: {why}")


def _row(agent: Any, u: float) -> int:
    """Return the place that a student's `row_for` gives, a whole number."""
    call = f"row_for({u:.3g})"
    with student_code(call):
        found = agent.row_for(u)
    row = number(call, found)
    if row != int(row) or isinstance(found, float | np.floating):
        raise WrongAnswer(f"{call} should be a whole number, but is {found!r}: make it one by int(...)")
    return int(row)


def _why_uneven(agent: Any, us: list[float], rows: list[int], filled: int) -> str:
    """Return what is wrong with the places that belong to some random numbers."""
    steps, size = int(agent.steps[0]), len(agent.memory.actions)
    if len({*rows}) == 1 and steps == size:  # and not in a memory that is not full, which was checked before
        return (
            f"it is always place {rows[0]}, now that the memory is just full. Is the number of filled places a"
            " remainder by %, which is 0 here? It is the smaller one of `self.steps[0]` and `len(self.memory.actions)`"
        )
    if len({*rows}) == 1:
        return (
            f"it is always place {rows[0]}, whatever `u` is: multiply `u` by the number of filled places, and cut off"
            " after that, since int(u) is 0"
        )
    n = _row(agent, NEARLY_1) + 1
    if n != filled and rows == [int(u * n) for u in us]:
        if n == filled - 1:
            return f"you draw from {n} places, and {filled} are filled: subtract no 1 from their number"
        return (
            f"you draw from {n} places, and {filled} are filled. Their number is the smaller one of `self.steps[0]` and"
            " `len(self.memory.actions)`"
        )
    if steps > size and max(rows) >= size and {row % size for row in rows} == {*range(size)}:
        return (
            f"that counts the transitions from the first one on, but transition {size} took place 0 again, and so on:"
            f" the place of transition k is k % {size}, with `len(self.memory.actions)` for {size}"
        )
    if rows == [round(u * filled) for u in us]:
        return "round(...) may round up, so that the last place is one too far; cut off by int(...)"
    if rows == [int(u * filled) + 1 for u in us]:
        return "places count from 0, so that the last one is their number less 1"
    if rows[0] < 0:
        return "`u` may be 0, and that belongs to place 0: cut off by int(...), without a rounding up"
    return (
        "multiply `u` by the number of filled places, and cut off by int(...); neither round(...) nor a remainder by %"
        " is even"
    )
