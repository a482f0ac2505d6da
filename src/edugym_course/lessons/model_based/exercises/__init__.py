"""The exercises of lesson 9: an error that pays, Dyna-Q+, R-max, another lake."""

from types import MappingProxyType
from typing import Annotated, Any

import gymnasium

from edugym import RMax
from edugym.agents.planning import Updates
from edugym.system.packages import is_ours
from edugym_course.grading.agents import require_function
from edugym_course.grading.challenge import Challenge
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.mistakes import NumberCase, compare_all
from edugym_course.grading.own_numbers import ExperimentSeed, Own
from edugym_course.grading.results import check_results
from edugym_course.grading.student_code import student_code
from edugym_course.grading.values import number
from edugym_course.lessons.model_based.exercises.imagining import exercise_2 as exercise_2
from edugym_course.lessons.model_based.exercises.sweeping import exercise_3 as exercise_3
from edugym_course.lessons.model_based.methods import DYNA_10, LEARNED, OPTIMUM, Q_LEARNING, R_MAX, SWEEPING

LAKE_STEPS = 3_000
ENOUGH = 0.15
"""A share of goals that averaging reaches and luck does not: rates of 1 with sampled updates get 0.07 at most."""


def _wrong_errors(v: float, gamma: float, cost: float) -> dict[str, float]:
    """Return what the usual mistakes give for the error of a bump, by the sentence that tells of each."""
    bump = f"e − {cost:g}"
    return {
        f"the step costs {cost:g}, which the error has to pay first: the reward of a bump seems to be {bump}": (
            (1 - gamma) * v
        ),
        f"the cost of the step is −{cost:g}, so solve {bump} = (1 − γ) v for e: it adds {cost:g}": (1 - gamma) * v
        - cost,
        "bumping for ever is worth the reward *divided* by 1 − γ": cost + v / (1 - gamma),
        "that leaves the future out: one bump alone need not be worth v, for it is followed by more": cost + v,
        "that compares with γ v; compare with v, what the best way is worth from here": cost + gamma * v,
        f"that is what bumping is worth without an error, −{cost:g}/(1 − γ)": -cost / (1 - gamma),
        f"that solves e/(1 − γ) − {cost:g} = v: the cost of {cost:g} comes with every bump": (1 - gamma) * (v + cost),
        "that is v itself": v,
        f"that is {cost:g}, the error from which a bump pays at all; it must pay more than leaving": cost,
        "the sign of γ is wrong: the sum 1 + γ + γ² + ... is 1/(1 − γ)": cost + (1 + gamma) * v,
        "the cost is subtracted twice": cost + (1 - gamma) * (v + cost),
        f"that is {cost:g} − (1 − γ) v: the two terms add up": cost - (1 - gamma) * v,
        "v and γ have changed places: the function is called with v first": cost + (1 - v) * gamma,
        "the sum of the bumps begins with x and not with γ x: the first bump is not discounted": (
            cost + v * (1 - gamma) / gamma
        ),
        "brackets are missing: v times all of (1 − γ)": cost + v - gamma,
        **{
            f"it takes {fixed:g} for γ: use the `gamma` that the function is given": cost + v * (1 - fixed)
            for fixed in (0.9, 0.95, 0.99)
        },
        "it takes 40 for v: use the `v` that the function is given": cost + 40 * (1 - gamma),
        "only the first three bumps are counted, and there is no end to them": cost + v / (1 + gamma + gamma**2),
        **{
            f"only {n} bumps are counted, and there is no end to them": cost + v * (1 - gamma) / (1 - gamma**n)
            for n in (10, 50, 100, 1_000)
        },
        "only 500 bumps are counted, as in an episode; the plan knows no step limit": (
            cost + v * (1 - gamma) / (1 - gamma**500)
        ),
    }


Cost = Annotated[
    float,
    Own(tuple(k / 4 for k in range(8, 48)), "In your shop every step costs {cost}, and so does a bump: not 1."),
]


def exercise_1(answer: Any, seed: int, cost: Cost = 1.0) -> str:
    """Check the error from which bumping into a wall for ever looks better than anything else."""
    require_function("smallest_error", answer, "v and gamma")
    cases = []
    for v, gamma in ((40.0, 0.75), (8.0 + seed % 4, 0.5), (33.0, 0.875), (48.0, 1 - 2**-9)):  # the last adds up slowly
        call = f"smallest_error({v:g}, {gamma})"
        with student_code(call):
            found = number(call, answer(v, gamma))
        cases.append(NumberCase(call, found, cost + (1 - gamma) * v, _wrong_errors(v, gamma, cost)))
    compare_all(cases, otherwise=f"solve (e − {cost:g})/(1 − γ) = v for e")
    return "Right: the larger γ is, the smaller an error is enough, since a far-sighted plan adds up more bumps."


def plans(agent: Any) -> bool:
    """Whether an agent makes updates with a model; one that the reader wrote is believed to."""
    if not is_ours(type(agent)):
        return True
    return hasattr(agent, "model") and agent.planning != Updates(0.0)


def _why_lost(agent: Any) -> str:
    """Return what may keep an agent that plans from the goal."""
    rate, expected = getattr(agent, "learning_rate", 1.0), getattr(agent, "expected_updates", False)
    if isinstance(agent, RMax) and agent.known_after < 10:
        return (
            f"with known_after={agent.known_after} it estimates each probability from so few tries; on slippery ice an"
            " action needs more"
        )
    if isinstance(agent, RMax) or expected or rate <= 0.5:
        return (
            "its values average over many outcomes already, so look at its other settings: a discount far below 1 hides"
            " a goal that is some steps away; a tiny learning rate takes long, and so do few updates, and many tries"
            " before a pair is known"
        )
    if is_ours(type(agent)) and rate == 1.0:
        return (
            "it has a learning rate of 1 and sampled updates, so that a value is whatever the last outcome said,"
            " however many updates it makes"
        )
    if not is_ours(type(agent)):
        return (
            "does each value average over many outcomes, by expected updates or by a learning rate such as 0.1? Over"
            " all of them, those that end the episode too? And does it make enough updates?"
        )
    return "let each value average over many outcomes, by expected updates or by a learning rate such as 0.1"


def exercise_4(answer: Any, seed: int, experiment_seed: ExperimentSeed = None) -> str:
    """Check the results of three methods, and of one more, on the slippery lake."""
    lake = gymnasium.make("FrozenLake-v1", map_name="4x4", is_slippery=True)
    asked = {
        "n_steps": LAKE_STEPS,
        "repetitions": 5,
        "evaluation_episodes": 10,
    } | ({} if experiment_seed is None else {"experiment_seed": experiment_seed})
    methods = {label: LEARNED[label] for label in (Q_LEARNING, DYNA_10)}
    results = check_results("lake_results", answer, asked=asked, methods=methods, environment=lake)
    own = [label for label in results.methods if label not in methods]
    if not own:
        raise WrongAnswer("lake_results should have a third method, your own, beside the two of the lesson")
    goals = {label: float(results.curves(label).loc[LAKE_STEPS // 2 :].to_numpy().mean()) for label in results.methods}
    agents = {label: next(iter(results.complete_agents(label).values())) for label in own}
    planners = [label for label in own if plans(agents[label])]
    if not planners:
        raise WrongAnswer(
            f"the third method should plan, and {own[0]!r} learns from real steps alone: make it with DynaQ,"
            " PrioritisedSweeping or RMax, and let `planning_steps` be above 0"
        )
    best = max(planners, key=lambda label: goals[label])
    shares = ", ".join(f"{label} {share:.2f}" for label, share in goals.items())
    measured = f"Share of evaluation episodes that reach the goal, in the second half of training: {shares}."
    if goals[best] < ENOUGH:
        raise WrongAnswer(f"{best!r} should get {ENOUGH:g} or more: {_why_lost(agents[best])}. {measured}")
    return (
        f"Right. {measured} A learning rate of 1 with sampled updates fails on slippery ice: each value keeps only the"
        " last outcome. Expected updates, or a lower rate, average over all of them."
    )


CHALLENGE = Challenge(
    environment="Supermarket",
    parameters=MappingProxyType({}),
    n_steps=3_000,
    baselines=MappingProxyType({label: LEARNED[label] for label in (R_MAX, DYNA_10, SWEEPING)}),
    optimum=OPTIMUM,
    best_average=OPTIMUM,
)
"""The open challenge: the highest average return within 3 000 steps. Who knew the shop from the start would get 95."""
