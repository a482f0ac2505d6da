"""Exercise 3: R-max."""

from collections.abc import Mapping
from functools import partial
from types import MappingProxyType
from typing import Annotated, Any, NamedTuple

import numpy as np

from edugym_course.grading.agents import learn_step, table_of
from edugym_course.grading.cases import FAR_BELOW, STARTS, from_a_start, starts
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.mistakes import UNUSUAL, mistake_that_fits
from edugym_course.grading.own_numbers import Own
from edugym_course.grading.student_code import student_code
from edugym_course.grading.values import digits, number, same
from edugym_course.lessons.model_based.exercises.students import SHAPE, agent_with

SETTLED = 400
"""After so many sweeps nothing changes any more."""
SETTINGS: Mapping[str, Any] = MappingProxyType({"discount": 0.75})


class Model(NamedTuple):
    """What the agent knows, and its values: its tables by their names."""

    Q: Any
    known: Any
    rewards: Any
    next_states: Any
    ends: Any


def swept(
    model: Model,
    *,
    discount: float,
    cost: float = 0.0,
    ends: str = "heeded",
    unknown: str = "left",
    backup: str = "max",
    target: str = "all",
) -> Any:
    """Return the values that sweeps of R-max settle at; other arguments than the defaults are mistakes."""
    Q, known = model.Q.copy(), model.known
    for _ in range(SETTLED):
        before, left = Q.copy(), np.zeros(SHAPE[0], bool)
        for s, a in np.ndindex(*SHAPE):
            if not known[s, a]:
                left[s : {"break": s + 1, "return": None}.get(unknown, s)] = True
            if left[s]:
                continue
            if unknown == "reward" and model.rewards[s, a] == 0.0:
                continue
            if (not known[s, a] and unknown == "left") or (unknown == "only" and known[s, a]):
                continue
            if not known[s, a] and unknown == "zero":
                Q[s, a] = 0.0
                continue
            row = Q[model.next_states[s, a]]
            value: Any = {"max": row.max(), "mean": row.mean(), "own": Q[s].max(), "same": row[a], "none": 0.0}
            value["table"] = Q.max()
            value = {**value, **{f"from {start}": from_a_start(row, start) for start in STARTS}}[backup]
            if (model.ends[s, a] == 1) == (ends == "heeded") and ends != "ignored":
                value = 0.0
            reward = model.rewards[s, a] - cost
            Q[s, a] = {
                "all": reward + discount * value,
                "all discounted": discount * (reward + value),
                "no reward": discount * value,
                "undiscounted": reward + value,
                "added": Q[s, a] + reward + discount * value,
                "minus": reward - discount * value,
            }[target]
        if np.array_equal(Q, before):
            break
    return Q


SWEEP_MISTAKES: Mapping[str, Mapping[str, Any]] = MappingProxyType(
    {
        "pairs that are not known change as well; leave them at U, which is what makes the agent curious": {
            "unknown": "all"
        },
        "pairs that are not known are set to 0; leave them at U, which is what makes the agent curious": {
            "unknown": "zero"
        },
        "a known pair may have a reward of 0: ask `known`, and not the rewards, which pairs are known": {
            "unknown": "reward"
        },
        "the test of `known` is the wrong way round": {"unknown": "only"},
        "`break` leaves out all actions after the first that is not known: write `continue` there": {
            "unknown": "break"
        },
        "the sweep ends at the first pair that is not known: leave out this pair alone, and go on": {
            "unknown": "return"
        },
        "the test of `ends` is the wrong way round: the value of the next state counts where it is 0": {
            "ends": "inverted"
        },
        "after a terminal state there is no future: leave γ max_a Q(s', a) out where `ends` is 1": {"ends": "ignored"},
        "the mean over the actions stands where the maximum should": {"backup": "mean"},
        "the maximum is taken over the state itself instead of the next state": {"backup": "own"},
        **starts(
            lambda start: f"the maximum starts from {start}, and all values may be lower: start from the first one",
            lambda start: {"backup": f"from {start}"},
        ),
        "the value of the *same* action stands where the maximum over all actions should": {"backup": "same"},
        "the maximum is taken over the whole table instead of the row of the next state": {"backup": "table"},
        "the value of the next state is missing": {"backup": "none"},
        "the value of the next state is not discounted: multiply it by γ": {"target": "undiscounted"},
        "the whole target is discounted; γ belongs to the value of the next state only": {"target": "all discounted"},
        "the reward is missing": {"target": "no reward"},
        "the value of the next state is subtracted": {"target": "minus"},
        "the old value is still in the sum: Q(s, a) *becomes* the target, `=` and not `+=`": {"target": "added"},
        "everything fits a discount of 0.99: use self.discount": {"discount": 0.99},
    }
)


Cost = Annotated[
    float,
    Own(
        tuple(k / 20 for k in range(1, 61)),
        "In your version each step costs {cost}, but only where the agent plans: `learn` remembers the reward as it"
        " is, and `sweep` uses the reward minus {cost}.",
    ),
]


def exercise_3(answer: Any, seed: int, cost: Cost = 0.0) -> str:
    """Check R-max: what it remembers, and how it sweeps, with a cost of each step that is its own."""
    rule = {**SETTINGS, "cost": cost}
    _check_sweep(answer, seed, rule)
    _check_learn(answer, seed, rule)
    return (
        "Right: the unknown is worth U, so the way to it is planned like any other way. In the race its policy goes on"
        " exploring, since it has one table only, until all that matters is known; then it jumps to the optimum:"
    )


def _check_sweep(answer: Any, seed: int, rule: Mapping[str, Any]) -> None:
    rng = np.random.default_rng(seed)
    for rises in (False, True, False):
        agent, model = agent_with("MyRMax", answer, SETTINGS, "sweep"), _some_model(rng, rises)
        for name, values in model._asdict().items():
            table_of(agent, name, SHAPE, values.dtype.kind)[...] = values
        with student_code("sweep()"):
            first = agent.sweep()
            if first is None:
                raise WrongAnswer("sweep() gives None: it should return the largest change of a value")
            changes = agent.Q - model.Q
            for _ in range(SETTLED - 1):
                last = agent.sweep()
        _check_values(agent.Q.copy(), model, rule)
        _check_first(model.Q + changes, model, rule)
        for name, values in model._asdict().items():
            if name != "Q" and not np.array_equal(getattr(agent, name), values):
                raise WrongAnswer(f"sweep() changes the table `{name}`: planning changes Q only")
        if not same(number("sweep()", last), 0.0):
            raise WrongAnswer(
                f"once nothing changes any more, sweep() should return 0, the largest change, but returns {last:.4g}"
            )
        _check_largest(number("sweep()", first), changes, model.known)


def _some_model(rng: np.random.Generator, rises: bool) -> Model:
    """Make a model up: all actions of states 0 and 1 are known, and of the other pairs 6.

    A known pair has a reward of 0, and one leads to state 1, where all values end far below 0; if the
    largest change is one that `rises`, they begin farther below.
    """
    known = rng.permutation(np.repeat([0, 1], [6, 6])).reshape(-1, SHAPE[1])
    known = np.vstack([np.ones((2, SHAPE[1]), np.int64), known])
    next_states = np.where(known, rng.integers(1, SHAPE[0], SHAPE), 0)
    rewards = np.where(known, rng.choice([-2.0, -1.0, 3.0, 6.0], SHAPE), 0.0)
    ends = np.where(known, rng.random(SHAPE) < 0.25, 0).astype(np.int64)
    next_states[0, 1], ends[0, 1:] = 1, 0
    rewards[0, 2], rewards[1], ends[1] = 0.0, rewards[1] - FAR_BELOW, 1
    Q = np.full(SHAPE, 100.0)
    Q[known == 1] = rng.choice([-4.0, 2.0, 60.0], 12)
    Q[0, 0] = 400.0  # it falls by more than others but those of state 1 do
    if rises:
        Q[1] -= 2.5 * FAR_BELOW
        Q[(known == 1) & (next_states == 1)] = -3.0 * FAR_BELOW
    return Model(Q, known, rewards, next_states, ends)


def _check_values(found: Any, model: Model, rule: Mapping[str, Any]) -> None:
    """Check the values after many sweeps."""
    right = swept(model, **rule)
    wrong = np.argwhere(~np.isclose(found, right, atol=1e-6))
    if not len(wrong):
        return
    changed = ~np.isclose(found, model.Q)
    if not changed.any():
        why = "sweep() changes no value: set Q[s, a] to the target"
    elif not changed[1:].any():
        one = " and action 0" if not changed[0, 1:].any() else ""
        why = (
            f"only state 0{one} is swept. `return` ends the loops: write it below both, as far to the left as the first"
            " `for`"
        )
    else:
        untouched = np.flatnonzero((~changed | (model.known == 0)).all(axis=1) & (right != model.Q).any(axis=1))
        left_out = [state for state in untouched if state in (0, SHAPE[0] - 1)]
        why = mistake_that_fits(
            SWEEP_MISTAKES,
            partial(_sweeps_to, found, model, rule),
            otherwise=f"state {left_out[0]} is never swept: are all rows of Q?"
            if left_out
            else _by_its_own_values(found, model, rule),
        )
    s, a = wrong[0]
    what = "known" if model.known[s, a] else "not known"
    raise WrongAnswer(
        f"after many sweeps with γ = {rule['discount']:g}, Q[{s}, {a}], a pair that is {what}, should be"
        f" {digits(right[s, a], found[s, a])}, but is {digits(found[s, a], right[s, a])}: {why}"
    )


def _by_its_own_values(found: Any, model: Model, rule: Mapping[str, Any]) -> str:
    """Return what the first pair should be by the answer's own values, where they do not fit together."""
    future = np.where(model.ends == 1, 0.0, found.max(axis=1)[model.next_states])
    targets = np.where(model.known == 1, model.rewards - rule["cost"] + rule["discount"] * future, model.Q)
    wrong = np.argwhere(~np.isclose(found, targets, atol=1e-6))
    if not len(wrong):
        return UNUSUAL
    s, a = wrong[0]
    if not model.known[s, a]:
        return f"Q[{s}, {a}], a pair that is not known, should stay {model.Q[s, a]:g}, but is {found[s, a]:.5g}"
    reward, n = model.rewards[s, a] - rule["cost"], int(model.next_states[s, a])
    after = (
        "and there the episode ended"
        if model.ends[s, a]
        else f"and γ times the largest value of state {n}, which is {future[s, a]:.5g} in your table"
    )
    return (
        f"Q[{s}, {a}], which is {found[s, a]:.5g}, should add up the reward, {reward:g}, {after}: {targets[s, a]:.5g}"
    )


def _check_first(found: Any, model: Model, rule: Mapping[str, Any]) -> None:
    """Check, after a sweep, the known pairs that end the episode: no order of the pairs changes their values."""
    right = np.where((model.known == 1) & (model.ends == 1), model.rewards - rule["cost"], found)
    for s, a in np.argwhere(~np.isclose(found, right)):
        raise WrongAnswer(
            f"after one sweep Q[{s}, {a}], a pair that ends the episode, should be {right[s, a]:g}, but is"
            f" {digits(found[s, a], right[s, a])}: Q(s, a) *becomes* the target at once; there is no learning rate"
        )


def _sweeps_to(found: Any, model: Model, rule: Mapping[str, Any], change: Mapping[str, Any]) -> bool:
    """Whether a mistake gives the values that were found."""
    return np.allclose(swept(model, **{**rule, **change}), found, atol=1e-6, rtol=1e-6)


def _check_largest(found: float, changes: Any, known: Any) -> None:
    """Check what the first sweep returns."""
    sizes = np.abs(changes)
    largest = sizes.max()
    if same(found, largest):
        return
    s, a = np.unravel_index(sizes.argmax(), sizes.shape)
    hint = f"it is that of Q[{s}, {a}], by {changes[s, a]:+g}"
    if same(found, max(changes.max(), 0.0)):
        hint = "values fall as well as rise, and a fall counts too: `abs(new - old)`"
    elif same(found, max((-changes).max(), 0.0)):
        hint = "values rise as well as fall, and a rise counts too: `abs(new - old)`"
    elif same(found, sizes.sum()):
        hint = "that is the sum of all changes"
    elif same(found, sizes[known == 1][-1]) or same(found, sizes[-1].max()):
        hint = "that is a change of the last state: keep the largest of all, and set it to 0.0 above both loops"
    elif same(found, 0.0):
        hint = "compare the new value with the old one before you store it, and keep the largest change"
    raise WrongAnswer(
        f"the largest change of the first sweep(), without its sign, is {digits(largest, found)}, but it returns"
        f" {digits(found, largest)}: {hint}"
    )


NOT_PLANNED = "a new pair is known now, so `learn` should call self.plan(), which sweeps until nothing changes"


def _check_learn(answer: Any, seed: int, rule: Mapping[str, Any]) -> None:
    rng = np.random.default_rng(seed + 100)
    agent = agent_with("MyRMax", answer, SETTINGS, "sweep")
    names = ("known", "rewards", "next_states", "ends")
    seen: dict[str, Any] = {
        "known": np.zeros(SHAPE, np.int64),
        "rewards": np.zeros(SHAPE),
        "next_states": np.zeros(SHAPE, np.int64),
        "ends": np.zeros(SHAPE, np.int64),
    }
    *others, low, middle, high = [int(s) for s in rng.permutation(np.arange(1, SHAPE[0]))]
    low, middle, high = sorted((low, middle, high))
    # Two ways lead to the middle, from both sides, and then all of its actions become known: one sweep is not enough.
    steps = [(low, 1, middle), (high, 0, middle), *((middle, a, others[a % 2]) for a in range(SHAPE[1]))]
    unplanned = ""  # what to say if the next step changes no value either
    for k, (state, action, next_state) in enumerate([*steps, (low, 1, high)]):
        before = {name: table.copy() for name, table in seen.items()}
        again = k == len(steps)  # a known pair, and something else seems to follow: nothing changes
        ended = k == 3
        reward = float(rng.choice([-1.0, 4.0, 7.0])) if not again else 9.0
        step = {"state": state, "action": action, "reward": reward, "next_state": next_state, "next_action": 0}
        if k:
            agent.Q[middle if again else steps[0][:2]] += 8.0  # what a plan would mend
        unmended = agent.Q.copy()
        call = learn_step(agent, {**step, "terminated": ended, "truncated": False})
        if not again:
            for name, value in zip(names, (1, reward, next_state, int(ended)), strict=True):
                seen[name][state, action] = value
        if not again and all(np.array_equal(getattr(agent, name), before[name]) for name in names):
            raise WrongAnswer(
                f"after {call} nothing is remembered, and the pair is new: `learn` should do nothing only where"
                " self.known[state, action] is 1"
            )
        for name in names:
            _compare_memory(agent, name, seen[name], call, (state, action), next_state, again)
        if again and not np.array_equal(agent.Q, unmended):
            raise WrongAnswer(f"after {call} Q changes: that pair was known already, so `learn` need not plan again")
        right = unmended if again else _planned(seen, rule)
        wrong = np.argwhere(~np.isclose(agent.Q, right, atol=1e-2))
        if not len(wrong):
            continue
        s, a = (state, action) if [state, action] in wrong.tolist() else map(int, wrong[0])
        what = f"after {call} Q[{s}, {a}] should be {right[s, a]:g}, but is {agent.Q[s, a]:.4g}: "
        if not k and np.array_equal(agent.Q, unmended):
            # Either it never plans, or it plans before the new pair is known: the next steps tell.
            unplanned = what
            continue
        if np.array_equal(agent.Q, unmended):
            raise WrongAnswer(f"{unplanned or what}{NOT_PLANNED}")
        if not seen["known"][s, a]:
            raise WrongAnswer(f"{what}a pair that is not known stays at U, so `learn` leaves Q to self.plan()")
        late = [name for name in names if np.allclose(agent.Q, _planned({**seen, name: before[name]}, rule), atol=1e-2)]
        if late:
            hint = f"`{late[0]}` is set only after self.plan(), which cannot use it then: remember first, and plan last"
            raise WrongAnswer(f"{unplanned or what}{hint}")
        raise WrongAnswer(f"{unplanned or what}{NOT_PLANNED}")


def _planned(seen: Mapping[str, Any], rule: Mapping[str, Any]) -> Any:
    """Return the values of a plan with what was seen, from U everywhere."""
    return swept(Model(Q=np.full(SHAPE, 100.0), **seen), **rule)


def _compare_memory(
    agent: Any, name: str, right: Any, call: str, pair: tuple[int, int], next_state: int, again: bool
) -> None:
    """Compare a table of what is remembered."""
    table = table_of(agent, name, SHAPE, right.dtype.kind)
    wrong = np.argwhere(~np.isclose(table, right))
    if len(wrong) == 0:
        return
    s, a = (int(index) for index in wrong[0])
    where = "the pair that was tried" if (s, a) == pair else "a pair that was not tried"
    if again:
        hint = "that pair was known already, and then nothing should change"
    elif next_state != pair[0] and next_state in wrong[:, 0]:
        hint = "it is remembered for next_state; what followed belongs to the pair that was tried, [state, action]"
    elif name == "ends":
        hint = "`ends` should be 1 if `terminated`, else 0"
    elif name == "known":
        hint = "a pair is known, 1, as soon as it was tried once"
    else:
        hint = f"`{name}[state, action]` keeps what followed"
    raise WrongAnswer(
        f"after {call}, {name}[{s}, {a}], of {where}, should be {right[s, a]:g}, but is {table[s, a]:g}: {hint}"
    )
