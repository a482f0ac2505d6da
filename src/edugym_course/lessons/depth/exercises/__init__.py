"""The exercises of lesson 3: Monte Carlo without exploration, a ratio of importance, and targets that are cut."""

import math
from collections.abc import Mapping
from functools import partial
from types import MappingProxyType
from typing import Annotated, Any

import numpy as np
from gymnasium.spaces import Discrete, MultiDiscrete

from edugym.adapters.registration import make_mdp
from edugym_course.grading.agents import (
    agent_created_by,
    agent_made_by,
    require_class,
    require_function,
    table_of,
    with_settings,
)
from edugym_course.grading.cases import DISCOUNTS, LEARNING_RATES
from edugym_course.grading.challenge import Challenge, Sizes
from edugym_course.grading.choices import ChoiceCase, check_all_choices
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.own_numbers import Own, step_cost
from edugym_course.grading.student_code import student_code
from edugym_course.grading.values import all_same, number, require_unchanged, same
from edugym_course.lessons.depth.exercises.cutting import cases, explained, outcomes
from edugym_course.lessons.depth.exercises.episodes import N_ACTIONS, N_STATES, learn_from
from edugym_course.lessons.depth.exercises.quiet import check_depth
from edugym_course.lessons.depth.exercises.ratio import RatioCase, compare_ratios, ratio
from edugym_course.lessons.depth.methods import LEARNING_RATE, label, maker

Rate = Annotated[
    float,
    Own(
        tuple(k / 200 for k in range(4, 56) if k not in (10, 20, 40)),
        "Your agent has another learning rate: $\\alpha = {rate}$, not 0.1.",
    ),
]
Most = Annotated[
    float,
    Own(
        tuple(k / 20 for k in range(24, 65)),
        "In your version the ratios are cut: a factor of the product that is greater than {most} counts as {most}.",
    ),
]
Cost = Annotated[float, step_cost("($R_{{k+1}} - {cost}$ stands in the first line.) So its line in the race is lower.")]


def exercise_1(answer: Any, seed: int, rate: Rate = LEARNING_RATE) -> str:
    """Check the function that makes a Monte Carlo agent without exploration."""
    require_function("quiet", answer, "the task that returns an agent")
    study = make_mdp("Study", layout_seed=seed)
    shape = int(np.prod(study.observation_space.nvec)), len(study.action_rewards)
    made, other = (agent_made_by("quiet(study)", answer, study) for _ in range(2))
    Q = table_of(made, "Q", shape)
    if np.shares_memory(Q, other.Q):
        raise WrongAnswer("two calls of quiet(study) share one table: make a new one in every call")
    if Q.any():
        raise WrongAnswer(f"every value in Q should be 0 at first, but one is {Q.ravel()[np.abs(Q).argmax()]:g}")
    small = make_mdp("Study", n_actions=2, layout_seed=seed)
    table_of(agent_made_by("quiet(study)", answer, small), "Q", (shape[0], 2))
    epsilon = getattr(getattr(made, "exploration", None), "epsilon", 0.0)
    if epsilon != 0.0:
        raise WrongAnswer(f"the quiet agent never explores, so ε should be 0, but it is {epsilon:g}")
    check_depth(made, study.total_days, seed, rate)
    n_actions = shape[1]
    Q[:] = 0.0
    Q[1, 1], Q[2, :] = 0.5, [-0.5, *[0.25] * (n_actions - 1)]
    others = n_actions - 1
    one = np.eye(n_actions).tolist()
    equals = {
        "ties should be broken at random, and it takes the first of equals": one[1],
        "ties should be broken at random, and it takes the last of equals": one[-1],
    }
    check_all_choices(
        "act(state, rng)",
        [
            ChoiceCase(
                partial(made.act, state),
                expected,
                {"it acts at random": [1 / n_actions] * n_actions, **mistakes},
                {"Q": Q},
                f"where state = {state} and Q[{state}] = {Q[state].tolist()}",
            )
            for state, expected, mistakes in (
                (1, one[1], {}),
                (2, [0.0, *[1 / others] * others], equals),
            )
        ],
    )
    return "Right: its targets are made of rewards alone, and it takes no random action. See it race:"


def exercise_2(answer: Any, seed: int, most: Most = math.inf) -> str:
    """Check the importance-sampling ratio of a greedy policy against an ε-greedy one, with no factor above `most`."""
    require_function("importance_ratio", answer, "greedy, epsilon and n_actions")
    rng = np.random.default_rng(seed)
    length = 4 + int(rng.integers(3))
    epsilon, n_actions = float(rng.choice([0.2, 0.4, 0.5])), int(rng.choice([4, 8]))
    later = 2 + int(rng.integers(length - 2))
    explored = [True] * length
    explored[later - 1] = False
    cases: list[RatioCase] = [
        ([True] * length, epsilon, n_actions),
        ([False] + [True] * (length - 1), epsilon, n_actions),
        (explored, epsilon, n_actions),
        ([True], epsilon, n_actions),
        ([False], epsilon, n_actions),
        ([True, True, False], 0.3, 5),
        ([True, False, False], 0.3, 5),
        ([True, False, True], 0.3, 5),
        ([True] * 14, 0.3, 5),
        ([True] * 12 + [False, True], 0.3, 5),
        ([True] * 3, 0.0, n_actions),
        ([True] * 3, 1.0, n_actions),
    ]
    found: list[Any] = []
    for case in cases:
        try:
            found.append(_answered(answer, *case))
        except WrongAnswer:
            if all(same(one, ratio(*case, most=most)) for one, case in zip(found, cases, strict=False)):
                raise  # an error says more than a wrong number, unless that came first
            break
    compare_ratios(cases, found, most)
    return (
        "Right: one exploring action on the way makes the ratio 0, whatever the others were. With nine later actions, "
        f"ε = 0.1 and N = 5 a target counts {1 / 0.92**9:.1f} times or not at all."
    )


def _answered(answer: Any, greedy: list[bool], epsilon: float, n_actions: int) -> float:
    """Return what a student's function gives, a number."""
    call, mine = f"importance_ratio({greedy}, {epsilon:g}, {n_actions})", list(greedy)
    with student_code(call):
        found = answer(mine, epsilon, n_actions)
    if isinstance(found, list | np.ndarray) and np.ndim(found) == 1:
        raise WrongAnswer(f"{call} gives several numbers: the ratio is their product, as of np.prod(...)")
    require_unchanged(call, "greedy", mine, greedy)
    return number(call, found)


def exercise_3(answer: Any, seed: int, cost: Cost = 0.0) -> str:
    """Check the class of an agent that looks as deep as its actions were greedy, with a cost of each step."""
    require_class("MyAgent", answer)
    rng = np.random.default_rng(seed)
    settings = {"learning_rate": float(rng.choice(LEARNING_RATES)), "discount": float(rng.choice(DISCOUNTS))}
    all_cases, found = cases(seed, settings["learning_rate"]), []
    for Q, episodes in all_cases:
        agent = _small_agent(answer, settings)
        table_of(agent, "Q", Q.shape)[...] = Q
        for episode in episodes:
            learn_from(agent, episode)
            found.append(table_of(agent, "Q", Q.shape).copy())
    rule = {**settings, "cost": cost}
    if not all(map(all_same, outcomes(all_cases, rule), found)):
        raise WrongAnswer(explained(all_cases, found, rule))
    return "Right: the reward passes through greedy actions, and is cut at the others. See it race:"


def _small_agent(answer: Any, settings: Mapping[str, float]) -> Any:
    """Make a student's agent for a small task, with other settings than its own."""
    small = Sizes(MultiDiscrete([2, N_STATES // 2]), Discrete(N_ACTIONS))
    return with_settings("MyAgent", agent_created_by("MyAgent", answer, "study", small), settings, "hand_back")


CHALLENGE = Challenge(
    environment="Study",
    parameters=MappingProxyType(
        {"n_actions": 8, "action_reward_noise_mean": 0.0, "action_reward_noise_sigma": 0.2},
    ),
    n_steps=10_000,
    baselines=MappingProxyType({label(n): maker(n) for n in (1, 3, math.inf)}),
    optimum=10.0,
    best_average=10.0,
)
"""The open challenge: 1 000 episodes with eight actions, none of which costs anything."""
