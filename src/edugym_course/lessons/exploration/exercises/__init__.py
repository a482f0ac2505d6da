"""The exercises of lesson 1: an exploration rate, an optimistic agent, a better explorer, a frozen lake."""

import math
from collections.abc import Mapping
from functools import partial
from types import MappingProxyType
from typing import Annotated, Any

import gymnasium
import numpy as np

from edugym.adapters.registration import make_mdp
from edugym.agents.q_learning import QLearning
from edugym_course.grading.agents import (
    agent_created_by,
    agent_made_by,
    require_class,
    require_function,
    table_of,
    with_settings,
)
from edugym_course.grading.cases import DISCOUNTS, LEARNING_RATES
from edugym_course.grading.challenge import Challenge
from edugym_course.grading.choices import ChoiceCase, check_all_choices
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.one_step import Q_LEARNING
from edugym_course.grading.own_numbers import ExperimentSeed, Own
from edugym_course.grading.results import check_results
from edugym_course.grading.values import compare, digits, number
from edugym_course.lessons.exploration.exercises.explorer import (
    AT_RANDOM,
    FIRST_OF_EQUALS,
    LAST_OF_EQUALS,
    check_act,
    epsilon_greedy,
)
from edugym_course.lessons.exploration.exercises.explorer import EXPLORER as EXPLORER
from edugym_course.lessons.exploration.methods import (
    DISCOUNT,
    EPSILON,
    GO_EXPLORE,
    LEARNING_RATE,
    METHODS,
    N_STEPS,
    NOVELTY,
    OPTIMIST,
)

ASKED = "the exercise asks for `QLearning`"
WORST_GRIP = "it takes the worst grip"
Height = Annotated[int, Own(tuple(range(60, 161)), "Your wall has height {height}, not 100.")]
Start = Annotated[
    float,
    Own(
        tuple(k / 20 for k in range(21, 81)),
        "In your version all values start at {start}, not at 1.",
    ),
]
Power = Annotated[
    float,
    Own(
        tuple(k / 100 for k in range(20, 81) if k != 50),
        "In your version the bonus fades with another power of the visits: it is $\\beta / n(S')^{{{power}}}$, not"
        " $\\beta / \\sqrt{{n(S')}}$.",
    ),
]


def exercise_1(answer: Any, seed: int, height: Height = 100) -> str:
    """Check the largest ε with which half of the climbs reach the top of a wall."""
    right = _epsilon(height)
    found = number("epsilon", answer)
    mistakes = {
        "that is ε/2, the probability of a wrong grip; of two grips a random action takes the wrong one half of the"
        " time": right / 2,
        f"that is ln 2/{height / 2:g}, an approximation which is a little too large; solve (1 − ε/2)^{height} = 1/2"
        " exactly": math.log(2) / (height / 2),
        f"{height} steps that go wrong with probability ε/2 do not add up to {height} · ε/2; multiply the"
        " probabilities that they go right": 1 / height,
        f"the probabilities of {height} steps do not add up; multiply the probabilities that they go right": 0.5
        / height,
        **{
            f"that is for {steps} steps; from the ground, position 0, to the top, position {height}, there are"
            f" {height}": _epsilon(steps)
            for steps in (height - 1, height + 1)
        },
        f"that solves (1 − ε)^{height / 2:g} = 1/2: it is (1 − ε/2)^{height} that should be 1/2": 1
        - 0.5 ** (2 / height),
        "that is the share of the climbs that reach the top with ε = 0.1, and ε is asked for": 0.95**height,
        f"that is for a wall of height 30, and this one has {height}": _epsilon(30),
        "that is the probability of a *right* step": 0.5 ** (1 / height),
        "a step goes right with probability 1 − ε/2, not ε/2": 2 * 0.5 ** (1 / height),
        "that is in percent; a probability lies between 0 and 1": 100 * right,
        "of two grips a random action takes the wrong one with probability 1/2, not 2/3": 0.75 * right,
        "natural and decimal logarithms are mixed up": 2 * (1 - 10 ** (math.log(0.5) / height)),
        "the sign is wrong: ε is a probability": -right,
        f"that is ln(1/2)/{height / 2:g}, a logarithm, which is negative: solve (1 − ε/2)^{height} = 1/2": math.log(0.5)
        / (height / 2),
        f"1/2 is divided by {height}, and its root is needed, `0.5 ** (1 / {height})`, with these parentheses": 2
        * (1 - 0.5 / height),
        f"1/2 is divided by {height}, and its root is needed, `0.5 ** (1 / {height})`, with these parentheses; and ε is"
        " twice that": 1 - 0.5 / height,
        f"`0.5 ** {height}` is a power, and the root is needed, `0.5 ** (1 / {height})`": 2 * (1 - 0.5**height),
        f"that is ln 2/{height}, an approximation of ε/2; ε is twice that, and (1 − ε/2)^{height} = 1/2 can be solved"
        " exactly": math.log(2) / height,
        f"that is 1/2 to the power of {height}: it is (1 − ε/2)^{height} that should be 1/2": 0.5**height
        if found
        else 1.0,  # an ε of 0 is as near to it, and means something else
        "that is the half of ε/2, the probability of a wrong grip: ε is twice that, and not half of it": right / 4,
        "that is twice too large: ε/2 is the probability of a wrong grip, and ε twice that": 2 * right,
        "that is the value with which the cell began": 0.1,
    }

    def says(epsilon: float) -> str:
        if not 0 <= epsilon <= 1:
            return f"ε = {digits(epsilon, 0.0)} is no probability"
        return f"with ε = {digits(epsilon, right)}, {(1 - epsilon / 2) ** height:.2%} of the climbs reach the top"

    close = abs(found / right - 1) < 0.07
    otherwise = "half should, so ε must be " + ("smaller" if found > right else "larger")
    if not 0 <= found <= 1:
        otherwise = "a probability lies between 0 and 1"
    compare(
        "epsilon",
        answer,
        right,
        mistakes,
        tolerance=1e-6,
        says=says,
        otherwise=f"{otherwise}, by a little: give six digits or more" if close else otherwise,
    )
    return (
        f"Right: ε = {100 * right:.3g} % is little, and yet one wrong grip in {2 / right:.0f} costs half of the climbs."
    )


def _epsilon(height: int) -> float:
    return float(2 * (1 - 0.5 ** (1 / height)))


def exercise_2(answer: Any, seed: int, start: Start = 1.0) -> str:
    """Check the function that makes a greedy Q-learning agent with all values at 1, or at another start."""
    if not isinstance(answer, type) or issubclass(answer, tuple):  # a plain class can be called with the wall as well
        require_function("optimist", answer, "the wall that returns an agent")
    rng = np.random.default_rng(seed)
    for height, n_grips in ((30, 2), (int(rng.integers(4, 9)), 3)):
        wall = make_mdp("Boulder", height=height, n_grips=n_grips, layout_seed=int(rng.integers(1000)))
        make = partial(agent_made_by, "optimist(wall)", answer, wall)
        made, other = make(), make()
        Q = table_of(made, "Q", None)
        other_kind = "" if isinstance(made, QLearning) else f"; and {ASKED}"
        if Q.shape != (height + 1, n_grips):
            raise WrongAnswer(
                f"the table `Q` should have the shape {(height + 1, n_grips)}, a row for each position and a column for"
                f" each grip of the `wall` that `optimist` is given, but has {Q.shape}{other_kind}"
            )
        if np.shares_memory(Q, other.Q):
            raise WrongAnswer("two calls of optimist(wall) share one table: make a new one in every call")
        for state, value in ((int(Q.argmin() // n_grips), Q.min()), (int(Q.argmax() // n_grips), Q.max())):
            compare(
                f"every value in Q[{state}]",
                value,
                start,
                {f"that is the usual first value: `create` has a setting `initial_value`{other_kind}": 0.0},
                otherwise=f"all values should start at {start:g}",
            )
        epsilon = getattr(getattr(made, "exploration", None), "epsilon", 0.0)
        if epsilon != 0.0:
            usual = "" if epsilon != EPSILON else ", the usual one: `create` has a setting `exploration`"
            raise WrongAnswer(
                f"the optimist explores by its values alone, so ε should be 0, but it is {epsilon:g}{usual}"
            )
        try:
            Q_LEARNING.check(make, Q.shape, {"learning_rate": LEARNING_RATE, "discount": DISCOUNT}, seed)
        except WrongAnswer as wrong:
            another = f"{ASKED}, and optimist(wall) returns a `{type(made).__name__}`: " if other_kind else ""
            raise WrongAnswer(f"{another}{wrong}") from None
        Q[1, :], Q[1, 1] = 0.25, 0.5
        Q[2, :], Q[2, 0] = 0.5, -0.5
        one_in = 1 / n_grips
        best, equal = [0.0] * n_grips, [1 / (n_grips - 1)] * n_grips
        best[1], equal[0] = 1.0, 0.0
        at_random = {AT_RANDOM: [one_in] * n_grips}
        mistakes = {
            1: {**at_random, WORST_GRIP: [1.0, *[0.0] * (n_grips - 1)], **epsilon_greedy(best)},
            2: {
                **at_random,
                WORST_GRIP: [1.0, *[0.0] * (n_grips - 1)],
                FIRST_OF_EQUALS: np.eye(n_grips)[1].tolist(),
                LAST_OF_EQUALS: np.eye(n_grips)[-1].tolist(),
                **epsilon_greedy(equal),
            },
        }
        check_all_choices(
            "act(state, rng)",
            [
                ChoiceCase(
                    partial(made.act, state),
                    expected,
                    mistakes[state],
                    {"Q": Q},
                    f"where state = {state} and Q[{state}] = {Q[state].tolist()}",
                )
                for state, expected in ((1, best), (2, equal))
            ],
        )
    return (
        "Right: it never takes a random action, and yet it tries everything, for all that it tries below the top"
        " disappoints it. See it race:"
    )


def exercise_3(answer: Any, seed: int, power: Power = 0.5) -> str:
    """Check the class of an explorer that tries what it has not tried, and learns with a novelty reward."""
    require_class("MyExplorer", answer)
    rng = np.random.default_rng(seed)
    for n_grips in (2, 3):
        height = int(rng.integers(4, 9))
        wall = make_mdp("Boulder", height=height, n_grips=n_grips)
        settings = {
            "learning_rate": float(rng.choice(LEARNING_RATES)),
            "discount": float(rng.choice(DISCOUNTS)),
            "bonus": float(rng.choice([1.5, 3.0, 5.0])),
        }
        make = partial(_explorer, answer, wall, settings)
        EXPLORER.check(make, (height + 1, n_grips), settings | {"power": power}, seed)
        check_act(make, n_grips)
    return (
        "Right: counting tries says what is new here, the bonus says where to go, and no random step is needed. "
        "See it race:"
    )


def _explorer(answer: Any, wall: Any, settings: Mapping[str, float]) -> Any:
    """Make a student's explorer with other settings than its own."""
    return with_settings("MyExplorer", agent_created_by("MyExplorer", answer, "wall", wall), settings, "learn")


def exercise_4(answer: Any, seed: int, experiment_seed: ExperimentSeed = None) -> str:
    """Check the results of the three methods, and of one more, on a frozen lake."""
    lake = gymnasium.make("FrozenLake-v1", map_name="8x8", is_slippery=False)
    asked = {
        "n_steps": N_STEPS,
        "repetitions": 5,
    } | ({} if experiment_seed is None else {"experiment_seed": experiment_seed})
    results = check_results("frozen", answer, asked=asked, methods=METHODS, environment=lake)
    own = [label for label in results.methods if label not in METHODS]
    if not own:
        raise WrongAnswer("frozen should have a fourth method, your own, beside the three of the lesson")
    solved = ", ".join(f"{label} {(results.final(label) >= 1).sum()} of 5" for label in results.methods)
    if (results.final(NOVELTY) >= 1).sum() > 3:
        return f"Right. Runs that solve the lake: {solved}."
    return (
        f"Right. Runs that solve the lake: {solved}. The novelty reward solves walls of this depth in all runs, and"
        " this lake in not all of them. The bonuses are too large, as they were with γ = 0.99 on the low wall: with"
        " β = 0.1 nine of ten runs solve the lake, and all do if it has no holes."
    )


def best_average(height: int, n_grips: int, n_steps: int) -> float:
    """Return the average return over training of an explorer that takes no avoidable step, in expectation.

    No step limit cuts it off. It tries each grip once, on average (N - 1)/2 wrong ones at every height, and needs h + 1
    steps to get back to height h after each: H + (N - 1)/2 · H (H + 1)/2 steps to the top. From then on every greedy
    episode gets there.
    """
    steps = height + (n_grips - 1) / 2 * height * (height + 1) / 2
    return max(0.0, 1.0 - steps / n_steps)


CHALLENGE = Challenge(
    environment="Boulder",
    parameters=MappingProxyType({"height": 60}),
    n_steps=5_000,
    baselines=MappingProxyType(
        {
            GO_EXPLORE: METHODS[GO_EXPLORE],
            "optimistic": OPTIMIST,
            NOVELTY: METHODS[NOVELTY],
        }
    ),
    optimum=1.0,
    best_average=best_average(60, 2, 5_000),
)
"""The open challenge: the highest return within 5 000 steps at height 60."""
