"""Exercise 3 of lesson 13: the update of minimax Q-learning, and the usual mistakes in it."""

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import numpy as np

from edugym.exact.zero_sum import solve_zero_sum
from edugym.mdp.protocol import Reals

LEARNING_RATE, DISCOUNT = 0.5, 0.9


class Step(NamedTuple):
    """A step of a game, as player 0 sees it."""

    state: int
    action: int
    other_action: int
    reward: float
    next_state: int
    terminated: bool


N_STATES, N_ACTIONS, N_OTHERS = 4, 2, 3


def updated(
    Q: Reals,
    V: Reals,
    step: Step,
    *,
    future: str = "V",
    entry: str = "both",
    value: str = "minimax",
    where: str = "state",
    ends: str = "right",
    discounted: str = "right",
    learning_rate: float = LEARNING_RATE,
    discount: float = DISCOUNT,
    sign: float = 1.0,
    cost: float = 0.0,
) -> None:
    """Do an update of minimax Q in place, where a step has a cost; other arguments than the defaults are mistakes."""
    s, a, o, reward, then, terminated = step
    before = Q[s].copy()
    if where == "first":
        V[s] = solve_zero_sum(before).value
    futures: dict[str, Callable[[], Any]] = {
        "V": lambda: V[then],
        "old": lambda: V[s],
        "max": lambda: Q[then].max(),
        "own": lambda: Q[then, :, o].max(),
        "safe": lambda: Q[then].min(axis=1).max(),
        "same": lambda: Q[then, a, o],
        "mean": lambda: Q[then].mean(),
        "solved": lambda: solve_zero_sum(Q[then]).value,
    }
    over = {"never": False, "inverted": not terminated}.get(ends, terminated)
    target = sign * reward - cost + (0.0 if over else discount * futures[future]())
    if discounted == "all":
        target = discount * (sign * reward - cost + (0.0 if over else futures[future]()))
    if terminated and ends in ("lost", "no step"):
        target = 0.0
        if ends == "no step":
            return
    old_V = float(V[s])
    if entry == "copy":
        Q = Q.copy()
    if entry in ("both", "copy"):
        Q[s, a, o] += learning_rate * (target - Q[s, a, o])
    elif entry == "from V":
        Q[s, a, o] += learning_rate * (target - V[s])
    elif entry == "column":
        Q[s, :, o] += learning_rate * (target - Q[s, :, o])
    elif entry == "own":
        Q[s, a] += learning_rate * (target - Q[s, a])
    elif entry == "added":
        Q[s, a, o] += learning_rate * target
    elif entry == "next":
        Q[then, a, o] += learning_rate * (target - Q[then, a, o])
    elif entry == "state":
        Q[s] += learning_rate * (target - Q[s])
    elif entry == "twice":
        for _ in range(2):
            Q[s, a, o] += learning_rate * (target - Q[s, a, o])
    elif entry == "unbracketed":
        Q[s, a, o] = learning_rate * target
    elif entry == "lost":
        Q[s, a, o] = learning_rate * (target - Q[s, a, o])
    if where in ("nowhere", "first") or (where == "not at the end" and terminated):
        return
    k = then if where == "next" else s
    values: dict[str, Callable[[], Any]] = {
        "minimax": lambda: solve_zero_sum(Q[k]).value,
        "max": lambda: Q[k].max(),
        "safe": lambda: Q[k].min(axis=1).max(),
        "second": lambda: Q[k].max(axis=0).min(),
        "mean": lambda: Q[k].mean(axis=1).max(),
        "target": lambda: target,
        "before": lambda: solve_zero_sum(before).value,
        "columns": lambda: solve_zero_sum(Q[k].T).value,
        "axes": lambda: Q[k].min(axis=0).max(),
        "entry": lambda: Q[s, a, o],
        "average": lambda: Q[k].mean(),
        "negative": lambda: -solve_zero_sum(Q[k]).value,
        "worst best": lambda: Q[k].max(axis=1).min(),
        "towards": lambda: old_V + learning_rate * (target - old_V),
        "half": lambda: old_V + 0.5 * (solve_zero_sum(Q[k]).value - old_V),
    }
    V[k] = values[value]()
    for other in range(len(V)) if where == "all" else ():
        V[other] = solve_zero_sum(Q[other]).value


UPDATE_MISTAKES: Mapping[str, Mapping[str, Any]] = {
    "V is not changed: after Q it is the value of the matrix game Q[state]": {"where": "nowhere"},
    "the value of the *next* state is solved anew; it is Q[state] that has changed": {"where": "next"},
    "V is the largest entry of Q[state], as if the other player wanted it too; it is the value of the game": {
        "value": "max"
    },
    "V is what the best single action guarantees, max_a min_o Q; a random choice may guarantee more": {"value": "safe"},
    "V is min_o max_a Q, as if you saw the other's action before you choose": {"value": "second"},
    "V is the best *mean* over the other's actions, as if it tossed a coin": {"value": "mean"},
    "V is set to the target of one step; it is the value of the matrix game Q[state]": {"value": "target"},
    "the game is solved before Q changes; first Q, then V": {"value": "before"},
    "V changes before Q does: the game that it is solved for is the old one; first Q, then V": {"where": "first"},
    "rows and columns have changed places: your actions are the rows of Q[state], and you want a high payoff": {
        "value": "columns"
    },
    "the target has max Q[next_state], as if the other player wanted it too; it is V[next_state]": {"future": "max"},
    "the target takes for granted that the other repeats its action: max_a Q[next_state, a, other_action]; it is"
    " V[next_state]": {"future": "own"},
    "the target has max_a min_o Q[next_state]; a random choice may guarantee more: it is V[next_state]": {
        "future": "safe"
    },
    "the target has Q[next_state, action, other_action]; neither need do the same again": {"future": "same"},
    "the target has V[state]; the future begins in the next state": {"future": "old"},
    "the value of the next state counts after the end; a terminal state has no future, so the target is the reward": {
        "ends": "never"
    },
    "`terminated` is the wrong way round: the value of the next state counts where the game goes on": {
        "ends": "inverted"
    },
    "all entries of Q[state, action] change; the other's action has a number of its own": {"entry": "own"},
    "all entries of Q[state] change; the pair of actions has one number": {"entry": "state"},
    "the step is taken twice; once is enough": {"entry": "twice"},
    "the old value goes wholly, so Q is α times the target: put the target − Q(S, A, O) in parentheses": {
        "entry": "unbracketed"
    },
    "V moves towards the target, and Q stays: first Q, and V is then the value of the matrix game Q[state]": {
        "entry": "none",
        "value": "towards",
    },
    "Q[next_state, ...] changes; the pair of actions was taken in `state`": {"entry": "next"},
    "`=` where `+=` is needed: the old value is lost": {"entry": "lost"},
    "the whole way to the target is gone, as with α = 1; it is 0.5": {"learning_rate": 1.0},
    "the step is a tenth of the way to the target; α is 0.5": {"learning_rate": 0.1},
    "the step is 0.9 of the way to the target; α is 0.5": {"learning_rate": 0.9},
    "the target has the mean of Q[next_state]; it is V[next_state]": {"future": "mean"},
    "V has the wrong sign: it is your own value, and your own actions are the rows": {"value": "negative"},
    "V is min_a max_o Q, with best and worst mixed up; it is the value of the game": {"value": "worst best"},
    "the discount is missing: γ is 0.9": {"discount": 1.0},
    "the value of the next state is missing in the target": {"discount": 0.0},
    "the reward counts with the wrong sign; it is your own": {"sign": -1.0},
    "the reward is discounted, too; only the value of the next state is": {"discounted": "all"},
    "α and γ have changed places: α = 0.5, and γ = 0.9": {"learning_rate": 0.9, "discount": 0.5},
    "the reward of the last step is lost: where `terminated` is True, the target is the reward": {"ends": "lost"},
    "the step that ends the game changes nothing; it has a target too, the reward": {"ends": "no step"},
    "the value moves *away* from the target: the error is the target less the old value": {"learning_rate": -0.5},
    "− Q(S, A, O) is left out: the target takes the place of the error": {"entry": "added"},
    "the error is the target less V[state]; it is the target less the old Q(S, A, O)": {"entry": "from V"},
    "all entries Q[state, :, other_action] change; your own action has a number, too": {"entry": "column"},
    "V is the entry of the two actions that were taken; it is the value of the game": {"value": "entry"},
    "V stays where the game ends; Q[state] has changed there, too": {"where": "not at the end"},
    "what follows is subtracted; it is added to the reward": {"discount": -0.9},
    "Q stays as it was: a number taken out of an array is a copy, so write into Q[state, action, other_action]": {
        "entry": "none"
    },
    "Q is copied, and the copy changes; write into the array that is given": {"entry": "copy"},
    "V is max_o min_a Q, with the axes mixed up; it is the value of the game": {"value": "axes"},
    "V is the mean of Q[state]; it is the value of the game": {"value": "average"},
    "V goes half of the way to the value of the game; it *is* the value of Q[state]": {"value": "half"},
    "the games of all states are solved anew; only that of `state` has changed": {"where": "all"},
    "the target solves the game of the next state anew; its value stands in V[next_state]": {"future": "solved"},
}
"""What each mistake changes in `updated`."""


class Case(NamedTuple):
    """Tables, and a step."""

    Q: Reals
    V: Reals
    step: Step


def cases_of(seed: int) -> list[Case]:
    """Make up tables and steps: ordinary ones, ends, and steps that stay in their state."""
    rng = np.random.default_rng([seed, 13])
    made = []
    for k in range(12):
        Q = rng.integers(-8, 9, (N_STATES, N_ACTIONS, N_OTHERS)) / 2.0
        V = rng.integers(-8, 9, N_STATES) / 2.0
        s, then = map(int, rng.choice(N_STATES, 2, replace=False))
        a, o = int(rng.integers(N_ACTIONS)), int(rng.integers(N_OTHERS))
        reward = float(rng.choice([-2.0, -1.0, 1.0, 3.0]))
        made.append(Case(Q, V, Step(s, a, o, reward, s if k % 6 == 5 else then, k % 3 == 1)))
    return made
