"""The exercises of lesson 2: a milder cliff, the ε at which the best run changes, and an agent with two policies."""

import math
from collections.abc import Mapping
from functools import cache, partial
from types import MappingProxyType
from typing import Annotated, Any, NamedTuple

import numpy as np

from edugym.envs.roadrunner import Roadrunner
from edugym.exact.model import finite_model
from edugym.exact.tables import FiniteModel
from edugym_course.grading.agents import agent_with_table, require_class, require_function
from edugym_course.grading.cases import DISCOUNTS, LEARNING_RATES, from_a_start, starts
from edugym_course.grading.challenge import Challenge
from edugym_course.grading.errors import WrongAnswer, nobody_asks_why
from edugym_course.grading.mistakes import mistake_that_fits
from edugym_course.grading.one_step import Q_LEARNING, made_up_values, numbers_of, one_step_update
from edugym_course.grading.own_numbers import Own, found_once, step_cost
from edugym_course.grading.student_code import student_code
from edugym_course.grading.updates import Tables, Transition, Update
from edugym_course.grading.values import compare, digits, number
from edugym_course.lessons.on_off_policy.exact import FAST, best_run, best_soft_return, soft_return_of, switch
from edugym_course.lessons.on_off_policy.methods import EPSILON, methods_with

CLOSE, FINE = 0.1, 0.011
"""How far a reward is a little too low; and how far it may be from the exact one if it has more digits than one."""
ROUNDING = 1e-6
"""How far a sum of many tenths, or an exact search, may be from the right number."""


Slips = Annotated[
    float,
    Own(
        tuple(k / 400 for k in range(21, 63) if k != 40),
        "Your agent slips with $\\varepsilon = {epsilon}$, not 0.1, here and in the hint.",
    ),
]


def exercise_1(answer: Any, seed: int, epsilon: Slips = EPSILON) -> str:
    """Check the lowest reward of a fall for which the fast run is still the best with some ε."""
    exact = fast_run_ends(epsilon)
    tenth = math.ceil(10 * exact) / 10  # the lowest number with one digit for which the fast run is the best
    mistakes = {
        "that is the value with which the cell began": -100.0,
        "that is the estimate 3/ε, which leaves out all slips but the last; let best_run work it out exactly": -3.0
        / epsilon,
        "that is 1/ε; a random action is the deadly one in only one of three cases, and the rest of the run slips"
        " too": -1.0 / epsilon,
        "there the *path* of the safe run changes; the number of its steps changes elsewhere": _path_changes(epsilon),
    }

    def says(penalty: float) -> str:
        told = f"negative_reward = {digits(penalty, exact)}"
        if penalty < -1_000_000:
            return f"{told} is below -1 000 000"
        steps = len(best_run(epsilon, negative_reward=penalty)) - 1
        does = f"takes {steps} steps" if steps > 1 else "stalls at once"
        return f"with {told} the best run at ε = {epsilon:g} {does}"

    found = number("negative_reward", answer)
    if found > 0.0:
        raise WrongAnswer(
            f"negative_reward = {digits(found, exact)}: a fall is no gain, so the number must be negative"
        )
    near = abs(found - exact) < 1.0
    if exact - CLOSE < found < exact - ROUNDING:
        raise WrongAnswer(f"{says(found)}: that is too low, by a little: take the next higher tenth")
    if exact + FINE < found < tenth - ROUNDING:
        raise WrongAnswer(
            f"{says(found)}, and so it does for lower numbers: with more digits than one, take the lowest that has them"
        )
    side = "too low, and the fast run of 4 steps should be best" if found < exact else "higher than it need be"
    compare(
        "negative_reward",
        answer,
        exact,
        mistakes,
        tolerance=max(tenth - exact, FINE) + ROUNDING,
        says=says,
        otherwise=f"it is {side}" + ("; you are close, look at every tenth" if near else ""),
    )
    return (
        f"Right: just above {math.floor(exact)}. The estimate of the lesson gives {-3 / epsilon:.3g}, since it looks at"
        " the last step alone. The safe run slips too, and for one step more."
    )


@cache
def fast_run_ends(epsilon: float) -> float:
    """Return the reward of a fall at which the fast run stops being the best, by bisection on the exact model."""
    low, high = -4.2 / epsilon, -3.0 / epsilon
    while high - low > ROUNDING:
        middle = (low + high) / 2
        low, high = (low, middle) if len(best_run(epsilon, negative_reward=middle)) == 5 else (middle, high)
    return high


def _path_changes(epsilon: float) -> float:
    """Return the reward of a fall below which the best run of five steps takes its slow step earlier, by bisection."""
    low, high = -10.0 / epsilon, -6.0 / epsilon
    early = best_run(epsilon, negative_reward=low)
    while high - low > 1e-3:
        middle = (low + high) / 2
        low, high = (middle, high) if best_run(epsilon, negative_reward=middle) == early else (low, middle)
    return low


PRECISION = 0.0011
"""A search in steps of 0.001 ends up to 0.001 above the exact value."""
SEARCHED_TO = 0.2
END_OF_SEARCH = (
    "that is the end of the search: the change was never found; is the comparison the right way round, and is"
    " `horizon` 50?"
)
SEARCHED = np.arange(0.0, SEARCHED_TO, 0.001)
"""The ε of such a search."""


class Road(NamedTuple):
    """A road, and what an answer gives for it.

    Attributes:
        call: the call, for the sentence.
        found: the answer's ε.
        expected: the right one.
        mistakes: by sentence, what each mistake gives, and how far from it a search in steps of 0.001 may end.
    """

    call: str
    found: float
    expected: float
    mistakes: Mapping[str, tuple[float, float]]

    def looks_like(self, sentence: str) -> bool:
        """Whether the answer gives what a mistake gives."""
        mistaken, precision = self.mistakes[sentence]
        return abs(self.found - mistaken) <= precision


Calm = Annotated[
    float,
    Own(
        tuple(k / 40 for k in range(28, 70) if k != 40),
        "Your agent slips otherwise: in your version it does so with probability $\\varepsilon / {calm}$. So plan for"
        " that. The change is below 0.35.",
    ),
]


def exercise_2(answer: Any, seed: int, calm: Calm = 1.0) -> str:
    """Check the function that finds the ε at which the best run of a road changes, if the agent slips with ε / calm."""
    require_function("switch", answer, "the model")
    rng = np.random.default_rng(seed)
    ranges = [(10, 60, 90), (int(rng.integers(11, 16)), 110, 200)]
    ranges.append((int(rng.integers(11, 16)), 25, 31))  # the best run changes above 0.1
    ranges.append((int(rng.integers(28, 33)), 150, 200))  # it has eight steps or more, and changes several times
    roads = []
    for size, low, high in ranges:
        task = Roadrunner.create(size=size, negative_reward=-float(rng.integers(low, high)))
        model = finite_model(task)
        call = f"switch(model) for W = {size} and negative_reward = {task.negative_reward:g}"
        with student_code(call):
            found = found_once(answer, call, partial(answer, model))
        slips = found_once(switch, call, partial(switch, model, tolerance=1e-7))
        mistakes = {} if nobody_asks_why() else _switch_mistakes(model, task, slips)
        mistakes = {sentence: (calm * value, precision) for sentence, (value, precision) in mistakes.items()}
        roads.append(Road(call, number(call, found), calm * slips, mistakes))
    for road in roads:
        if abs(road.found - road.expected) > PRECISION:
            near = abs(road.found - road.expected) < 0.0125
            why = mistake_that_fits(
                {sentence: sentence for sentence in road.mistakes},
                lambda sentence: all(one.looks_like(sentence) for one in roads),
                otherwise="that is close: does the search begin at 0, and go in steps of 0.001 or smaller, and is"
                " nothing rounded or discounted?"
                if near
                else END_OF_SEARCH
                if abs(road.found - SEARCHED_TO) <= PRECISION
                else "that is none of the usual mistakes, so print the number of steps of the best run for some ε",
            )
            if [abs(one.found - one.expected) <= PRECISION for one in roads] == [True, False, False, False]:
                why = (
                    "it is right for the first road of the check only, which is as long as that of the lesson: is the"
                    " return of its fastest run, −2, written in?"
                )
            asked, came = digits(road.expected, road.found), digits(road.found, road.expected)
            raise WrongAnswer(f"{road.call} should be {asked}, but is {came}: {why}")
    return (
        "Right: planning on the model finds at once what expected SARSA needs thousands of steps for. (It is close to "
        "3 divided by the cost of a fall where one step more avoids the one deadly action.)"
    )


def _switch_mistakes(model: FiniteModel, task: Roadrunner, right: float) -> dict[str, tuple[float, float]]:
    """Return what the usual mistakes give on a road, and how far from it a search in steps of 0.001 may end."""
    fastest = best_soft_return(model, 0.0)
    one_less = _falls_below(model, fastest - 1)
    estimate = -3.0 / task.negative_reward
    returns = [soft_return_of(model, 0.0, planned_for=epsilon) for epsilon in SEARCHED]
    values = {
        "that is the ε of the lesson's road; compute it from the `model` that is given": 0.03198,
        "that is the estimate for the lesson's road; compute the exact value from the `model` that is given": 0.03,
        "that is the estimate, 3 divided by the cost of a fall, not the exact value: plan on the model": estimate,
        "that is the return of the best run at the ε that is asked for; return this ε": soft_return_of(
            model, 0.0, planned_for=right + PRECISION / 2
        ),
        "that is the first ε above 0 of a search: compare the *return* of the greedy policy, played *without* slips,"
        " since the ε-soft return is always lower, and two policies may differ where no run leads": 0.0010001,
        "that is the first ε of a search in steps of 0.01: compare the greedy policy, played *without* slips, and not"
        " the ε-soft return": 0.010001,
        "that is where the ε-soft return falls below that of a run with one step more; the slips lower both": one_less,
        "that is where the *slowest* run begins, with the lowest of all returns; the best run may change more than"
        " once, and its first change is asked for": float(SEARCHED[np.argmin(returns)]),
        "that is 1 − ε": 1 - right,
        END_OF_SEARCH: SEARCHED_TO,
        "that is the end of the search; is the comparison the right way round?": 1.0,
        "the sign is wrong": -right,
    }
    return {
        "the search ends at its first ε: is the return of the fastest run that of *this* `model`, and is it compared,"
        " with `<`, with the greedy policy for ε, played *without* slips?": (0.0, PRECISION / 3),
        **{sentence: (value, PRECISION) for sentence, value in values.items()},
        "that is in percent": (100 * right, 100 * PRECISION),
        "that is 1 000 times ε: is it the number of the step, and not the ε of that step?": (
            1_000 * right,
            1_000 * PRECISION,
        ),
        "that is 1/ε": (1 / right, PRECISION / right**2),
    }


def _falls_below(model: FiniteModel, value: float, low: float = 0.0, high: float = 0.2) -> float:
    """Return the ε at which the best ε-soft return falls below a value, by bisection."""
    while high - low > 1e-6:
        middle = (low + high) / 2
        low, high = (low, middle) if best_soft_return(model, middle) < value else (middle, high)
    return low


def two_policies_update(
    tables: Tables, now: Transition, *, target_epsilon: float, epsilon: float, mean: str = "π", **one_step: Any
) -> None:
    """Apply expected SARSA with the ε of the target policy; other values of `mean` are mistakes."""

    def value(Q: Any, now: Transition) -> float:
        row = Q[{"left": now.state}.get(mean, now.next_state)]
        p = {"behaviour": epsilon, "inverted": 1 - target_epsilon}.get(mean, target_epsilon)
        others, gamma = np.delete(row, row.argmax()), one_step["discount"]
        best = from_a_start(row, int(mean.removeprefix("from "))) if mean.startswith("from ") else row.max()
        return float(
            {
                "nothing": 0.0,
                "greedy": row.max(),
                "mean": row.mean(),
                "next action": row[now.next_action],
                "sum": (1 - p) * row.max() + p * row.sum(),
                "others": (1 - p) * row.max() + p * others.mean(),
                "all of max": row.max() + p * row.mean(),
                "no random part": (1 - p) * row.max(),
                "only the random part": p * row.mean(),
                "three": (1 - p) * row.max() + p * row.sum() / 3,
                "min": (1 - p) * row.max() + p * row.min(),
                "whole table": (1 - p) * row.max() + p * Q.mean(),
                "sampled": (1 - p) * row.max() + p * row[now.next_action],
                "index": (1 - p) * row.argmax() + p * row.mean(),
                "old": (1 - p) * row.max() + p * Q[now.state, now.action],
                "mean undiscounted": (1 - p) * row.max() + p * row.mean() / gamma,
                "mean left": (1 - p) * row.max() + p * Q[now.state].mean(),
                "max left": (1 - p) * Q[now.state].max() + p * row.mean(),
                "behaviour in max": (1 - epsilon) * row.max() + p * row.mean(),
                "behaviour in mean": (1 - p) * row.max() + epsilon * row.mean(),
                "column": (1 - p) * row.max() + p * Q[:, now.action].mean(),
                "max undiscounted": (1 - p) * row.max() / gamma + p * row.mean(),
                "best twice": (1 - p + p / len(row)) * row.max() + p * row.mean(),
                "divided twice": (1 - p) * row.max() + p * row.mean() / len(row),
                "maximum divided": (1 - p + p / len(row)) * row.max(),
                "states": (1 - p) * row.max() + p * row.sum() / len(Q),
            }.get(mean, (1 - p) * best + p * row.mean())
        )

    one_step_update(tables, now, backup=value, **one_step)


MEAN_MISTAKES: Mapping[str, Mapping[str, Any]] = {
    "the maximum alone is Q-learning, which is right only for ε_π = 0; the random actions of the target policy are"
    " missing": {"mean": "greedy"},
    "the plain mean is right only for ε_π = 1; with probability 1 − ε_π the target policy takes the best action": {
        "mean": "mean"
    },
    "it uses `epsilon`, with which the agent acts; the values should be those of the *target* policy,"
    " `target_epsilon`": {"mean": "behaviour"},
    "it uses `epsilon` before the maximum; both numbers are those of the target policy, `target_epsilon`": {
        "mean": "behaviour in max"
    },
    "it uses `epsilon` before the mean; both numbers are those of the target policy, `target_epsilon`": {
        "mean": "behaviour in mean"
    },
    "ε_π and 1 − ε_π have changed places": {"mean": "inverted"},
    "the mean is that of the state that was left; it belongs to the row of the next state": {"mean": "mean left"},
    "the maximum is that of the state that was left; it belongs to the row of the next state": {"mean": "max left"},
    "the mean is taken over the states, a column of Q; it belongs to the row of the next state": {"mean": "column"},
    "Q(S', A') of the action that comes next stands there: that is SARSA, and A' is chosen with the wrong ε": {
        "mean": "next action"
    },
    "the sum over the actions stands where their mean should": {"mean": "sum"},
    "the mean leaves out the best action; a random action may be the best one too": {"mean": "others"},
    "the maximum counts in full, but it has the probability 1 − ε_π only": {"mean": "all of max"},
    "the mean over the random actions is missing, ε_π mean_a Q(S', a)": {"mean": "no random part"},
    "the best action is missing, (1 − ε_π) max_a Q(S', a)": {"mean": "only the random part"},
    "it divides by 3, but there may be another number of actions: self.Q.shape[1]": {"mean": "three"},
    "the minimum stands where the mean over the actions should": {"mean": "min"},
    "the mean is taken over the whole table instead of the row of the next state": {"mean": "whole table"},
    "Q(S', A') stands where the mean over the actions should; no action has to be drawn": {"mean": "sampled"},
    "the mean is not discounted: γ belongs to the whole bracket": {"mean": "mean undiscounted"},
    "the maximum is not discounted: γ belongs to the whole bracket": {"mean": "max undiscounted"},
    "the best action counts too often: the mean over all actions has it already, with ε_π/n": {"mean": "best twice"},
    "the mean is divided by n once more": {"mean": "divided twice"},
    "the maximum, divided by n, stands where the mean over the actions should": {"mean": "maximum divided"},
    "it divides by the number of states; n is the number of actions, self.Q.shape[1]": {"mean": "states"},
    "argmax gives the *number* of the best action; its value is needed, max": {"mean": "index"},
    **starts(
        lambda start: f"the maximum starts from {start}, and all values may be lower: start from the first one",
        lambda start: {"mean": f"from {start}"},
    ),
    "Q(S, A) stands where the mean of Q(S', a) should": {"mean": "old"},
    "the values are those of the state that was left, Q(S, a), instead of Q(S', a)": {"mean": "left"},
    "a terminal state has no future: its value is 0, so the target is R alone when `terminated`": {"ends": "never"},
    "the value of the next state is missing: without bootstrapping nothing is carried back": {"mean": "nothing"},
}


TWO_POLICIES = Update(
    rule=two_policies_update,
    tables=lambda n_states, n_actions, rng: {"Q": made_up_values(n_states, n_actions, rng)},
    mistakes={
        **MEAN_MISTAKES,
        **{
            sentence: change
            for sentence, change in Q_LEARNING.mistakes.items()
            if "backup" not in change and change != {"ends": "never"}
        },
    },
    numbers=numbers_of("learning_rate", "discount", "target_epsilon"),
)


Cost = Annotated[float, step_cost("So the lines of the race below are others.")]


def exercise_3(answer: Any, seed: int, cost: Cost = 0.0) -> str:
    """Check the class of an agent that acts with one ε and learns the values of another."""
    require_class("TwoPolicies", answer)
    rng = np.random.default_rng(seed)
    for n_states, n_actions, epsilon in ((6, 3, 0.15), (5, 2, 0.9), (7, 4, 0.25)):  # below ε_π, and above it
        settings = {
            "learning_rate": float(rng.choice(LEARNING_RATES)),
            "discount": float(rng.choice(DISCOUNTS)),
            "epsilon": epsilon,
            "target_epsilon": float(rng.choice([0.3, 0.6, 0.8])),
        }
        make = partial(agent_with_table, "TwoPolicies", answer, (n_states, n_actions), settings)
        TWO_POLICIES.check(make, (n_states, n_actions), settings | {"extra": -cost}, seed)
    return (
        "Right: one number says which policy the values belong to. ε_π = 0 is Q-learning, ε_π = ε expected SARSA. See "
        "it race:"
    )


CHALLENGE = Challenge(
    environment="Roadrunner",
    parameters=MappingProxyType({}),
    n_steps=5_000,
    baselines=MappingProxyType(methods_with(EPSILON, 0.1)),
    optimum=FAST,
    best_average=FAST,
    column="training_return",
)
"""The open challenge: the highest return of all training episodes, those with falls included, in 5 000 steps."""
