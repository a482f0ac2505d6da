"""One-step updates of action values, and the mistakes that are usually made in them: for every lesson that has one."""

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any

import numpy as np

from edugym.mdp.protocol import Reals
from edugym_course.grading.cases import FAR_BELOW, from_a_start, starts
from edugym_course.grading.updates import Tables, Transition, Update


def one_step_update(
    tables: Tables,
    now: Transition,
    *,
    learning_rate: float,
    discount: float,
    extra: float = 0.0,
    backup: str | Callable[[Any, Transition], float] = "max",
    ends: str = "terminated",
    target: str = "all",
    step: str = "difference",
) -> None:
    """Apply Q(S, A) <- Q(S, A) + α [R + γ V(S') - Q(S, A)] to the table "Q", in place.

    Args:
        tables: the tables, by name.
        now: the transition.
        learning_rate: α.
        discount: γ.
        extra: what is added to the reward.
        backup: what V(S') is: "max" for Q-learning, "next action" for SARSA, or a function of the table and the
            transition; any other one is a mistake.
        ends: after which steps V(S') counts as 0, and what else happens there.
        target: what the target is made of.
        step: how Q(S, A) moves to the target.
    """
    Q, entry = tables["Q"], (now.state, now.action)
    if now.terminated and ends == "skipped":
        return
    if now.terminated and ends == "twice":
        Q[entry] += learning_rate * (now.reward + extra - Q[entry])
    old = Q[entry]
    if step == "shrunk first":
        Q[entry] *= 1 - learning_rate
    future = {
        "terminated": not now.terminated,
        "never": True,
        "twice": True,
        "truncated": not (now.terminated or now.truncated),
        "inverted": now.terminated,
    }.get(ends, not now.terminated)
    value = _value(Q, now, backup) if future else 0.0
    reward = now.reward
    aim = {
        "all": reward + extra + discount * value,
        "no reward": extra + discount * value,
        "discounted": discount * reward + extra + discount * value,
        "all discounted": discount * (reward + extra + value),
        "undiscounted": reward + extra + value,
        "discounted twice": reward + extra + discount * discount * value,
        "minus": reward + extra - discount * value,
    }[target]
    if now.terminated and ends == "nothing":
        aim = 0.0
    less = old
    if ends.startswith("brackets"):
        aim, less = _without_brackets(ends, now, aim, old)
    if step == "next row":
        entry = (now.next_state, now.action)
        old = Q[entry]
    Q[entry] = {
        "difference": old + learning_rate * (aim - less),
        "next row": old + learning_rate * (aim - old),
        "shrunk first": (1 - learning_rate) * old + learning_rate * aim,
        "no old": old + learning_rate * aim,
        "only": learning_rate * aim,
        "only difference": learning_rate * (aim - old),
        "minus": old - learning_rate * (aim - old),
        "weights": learning_rate * old + (1 - learning_rate) * aim,
        "rate on old": old + aim - learning_rate * old,
        "rate on reward": aim + (learning_rate - 1) * (reward + extra),
        "old discounted": old + learning_rate * (aim - discount * old),
    }[step]


def _without_brackets(ends: str, now: Transition, aim: float, old: float) -> tuple[float, float]:
    """Return the target, and what is subtracted from it, where `a if terminated else b - Q` has no brackets."""
    if ends == "brackets: R in the target":
        return aim if now.terminated else aim - now.reward, old
    subtracts_at_the_end = ends in ("brackets: -Q at the end", "brackets: only -Q at the end")
    if ends == "brackets: R at the end" and not now.terminated:
        aim -= now.reward
    if ends == "brackets: only -Q at the end" and now.terminated:
        aim = 0.0
    return aim, old if now.terminated == subtracts_at_the_end else 0.0


def _value(Q: Any, now: Transition, backup: str | Callable[[Any, Transition], float]) -> float:
    """Return the value of the next state, or what a mistake takes for it."""
    if not isinstance(backup, str):
        return backup(Q, now)
    row = Q[now.next_state]
    if backup.startswith("from "):
        return from_a_start(row, int(backup.removeprefix("from ")))
    values = {
        "max": row.max(),
        "none": 0.0,
        "mean": row.mean(),
        "min": row.min(),
        "sum": row.sum(),
        "left": Q[now.state].max(),
        "same action": row[now.action],
        "next action": row[now.next_action],
        "old": Q[now.state, now.action],
        "first": row[0],
        "two": row[:2].max(),
        "index": float(row.argmax()),
        "table": Q.max(),
        "size": abs(row).max(),
        "last": row[-1],
    }
    return float(values[backup])


def made_up_values(n_states: int, n_actions: int, rng: np.random.Generator) -> Reals:
    """Return a table of simple values, with a row so far below 0 that no maximum should start from a fixed number."""
    Q: Reals = rng.choice(np.arange(-2.0, 2.25, 0.25), (n_states, n_actions))
    Q[rng.integers(n_states)] -= FAR_BELOW
    return Q


NUMBERS: Mapping[str, str] = MappingProxyType(
    {
        "learning_rate": "a learning rate",
        "discount": "a discount",
        "bonus": "a first bonus",
        "target_epsilon": "an ε_π",
        "kappa": "a κ",
    }
)
"""What the fields of students' agents are called in a sentence."""


def numbers_of(*names: str) -> dict[str, str]:
    """Return what to say of numbers that should be read from the fields of an agent, for `Update.numbers`."""
    return {
        name: f"everything fits {NUMBERS[name]} of {{found:.4g}}, not {{right:.4g}}: use self.{name}" for name in names
    }


Q_LEARNING = Update(
    rule=one_step_update,
    tables=lambda n_states, n_actions, rng: {"Q": made_up_values(n_states, n_actions, rng)},
    mistakes={
        "the value of the next state is missing, γ max_a Q(S', a): without bootstrapping nothing is carried back": {
            "backup": "none"
        },
        "the mean over the actions stands where the maximum should": {"backup": "mean"},
        "the minimum over the actions stands where the maximum should": {"backup": "min"},
        "the sum over the actions stands where the maximum should": {"backup": "sum"},
        "the maximum is taken over Q(S, a), the state that was left, instead of Q(S', a)": {"backup": "left"},
        "Q(S', A), the value of the *same* action, stands where the maximum over all actions should": {
            "backup": "same action"
        },
        "Q(S', A'), the value of the action that comes next, stands where the maximum should: that is SARSA": {
            "backup": "next action"
        },
        "Q(S, A) stands where the maximum of Q(S', a) should": {"backup": "old"},
        **starts(
            lambda start: f"the maximum starts from {start}, and all values may be lower: start from the first one",
            lambda start: {"backup": f"from {start}"},
        ),
        "only the first action of the next state is looked at": {"backup": "first"},
        "only the last action of the next state is looked at": {"backup": "last"},
        "only the first two actions of the next state are looked at, and there may be more": {"backup": "two"},
        "argmax gives the *number* of the best action; its value is needed, max": {"backup": "index"},
        "the maximum is taken over the whole table instead of the row of the next state": {"backup": "table"},
        "the largest absolute value stands where the maximum should": {"backup": "size"},
        "a terminal state has no future: its value is 0, so leave γ max_a Q(S', a) out when `terminated`": {
            "ends": "never"
        },
        "a truncated episode is treated as terminated, but only its clock ran out: the value of the next state still"
        " counts": {"ends": "truncated"},
        "the test of `terminated` is the wrong way round": {"ends": "inverted"},
        "at the end of an episode the reward is lost: only the *value of the next state* is 0 there": {
            "ends": "nothing"
        },
        "at the end of an episode nothing is learned, and that is where the reward is": {"ends": "skipped"},
        "at the end of an episode it learns twice: is an `else` missing?": {"ends": "twice"},
        "− Q(S, A) is missing at the end of an episode: `a if terminated else b - Q` subtracts it from b only, so put"
        " brackets around `a if terminated else b`": {"ends": "brackets: -Q before the end"},
        "− Q(S, A) is missing but at the end of an episode: `a if not terminated else b - Q` subtracts it from b only,"
        " so put brackets around `a if not terminated else b`": {"ends": "brackets: -Q at the end"},
        "Python reads `R + a if terminated else b - Q` as `(R + a) if terminated else (b - Q)`: put brackets around"
        " `a if terminated else b`": {"ends": "brackets: R at the end"},
        "Python reads `R + a if terminated else b` as `(R + a) if terminated else b`: put brackets around `a if"
        " terminated else b`": {"ends": "brackets: R in the target"},
        "Python reads `R + a if not terminated else b - Q` as `(R + a) if not terminated else (b - Q)`: put brackets"
        " around `a if not terminated else b`": {"ends": "brackets: only -Q at the end"},
        "the reward is missing": {"target": "no reward"},
        "the reward is discounted; γ belongs to the value of the next state only": {"target": "discounted"},
        "the value of the next state is not discounted: multiply it by γ": {"target": "undiscounted"},
        "the value of the next state is discounted twice": {"target": "discounted twice"},
        "the value of the next state is subtracted": {"target": "minus"},
        "− Q(S, A) is missing in the brackets: move by a share of the *difference* between target and Q(S, A)": {
            "step": "no old"
        },
        "the old value is lost: write `+=`, for the update is added to Q(S, A)": {"step": "only difference"},
        "the old value is lost: α times the target is not Q(S, A) + α [target − Q(S, A)]": {"step": "only"},
        "the sign is wrong: it moves away from the target": {"step": "minus"},
        "α belongs to the whole bracket, not to Q(S, A) alone": {"step": "rate on old"},
        "α stands before the reward alone: put the whole bracket into parentheses": {"step": "rate on reward"},
        "Q(S, A) is discounted as well: γ belongs to the value of the next state only": {"step": "old discounted"},
        "α and 1 − α have changed places": {"step": "weights"},
        "Q(S, A) changes before the maximum is taken: compute the whole target from the old Q": {
            "step": "shrunk first"
        },
        "it is Q[next_state, action] that changes, and it should be Q[state, action]": {"step": "next row"},
    },
    numbers={
        "learning_rate": "everything fits a learning rate of {found:.4g}, and it should be {right:.4g}",
        "discount": "everything fits a discount of {found:.4g}, and it should be {right:.4g}",
    },
)
"""Q-learning, equation 6.8 of Sutton and Barto."""
