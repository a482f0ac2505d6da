"""The exercises of lesson 1: an exploration rate, an optimistic agent, a better explorer, a frozen lake."""

import math
from collections.abc import Callable, Mapping
from functools import partial
from types import MappingProxyType
from typing import Any

import gymnasium
import numpy as np

from edugym.agents.q_learning import QLearning
from edugym.agents.strategies import EpsilonGreedy
from edugym.grading.challenge import Challenge
from edugym.grading.choices import check_choices
from edugym.grading.one_step import Q_LEARNING, made_up_values, one_step_update
from edugym.grading.results import check_results
from edugym.grading.student_code import running
from edugym.grading.updates import Tables, Transition, Update, table_of
from edugym.grading.values import compare, digits, given, number
from edugym.grading.wrong import WrongAnswer
from edugym.lessons.exploration import DISCOUNT, GO_EXPLORE, LEARNING_RATE, METHODS, N_STEPS, NOVELTY
from edugym.registration import make_mdp

HEIGHT = 100  # of the wall in exercise 1
EPSILON = 2 * (1 - 0.5 ** (1 / HEIGHT))


def exercise_1(answer: Any, seed: int) -> str:
    """Check the largest ε with which half of the climbs reach the top of a wall of height 100."""
    mistakes = {
        "that is ε/2, the probability of a wrong grip; of two grips a random action takes the wrong one half of the"
        " time": EPSILON / 2,
        "that is ln 2/50, an approximation which is a little too large; solve (1 − ε/2)^100 = 1/2 exactly": math.log(2)
        / 50,
        "100 steps that go wrong with probability ε/2 do not add up to 100 · ε/2; multiply the probabilities that they"
        " go right": 0.01,
        "the probabilities of 100 steps do not add up; multiply the probabilities that they go right": 0.005,
        "that is for 99 steps; from the ground, position 0, to the top, position 100, there are 100": _epsilon(99),
        "that is for 101 steps; from the ground, position 0, to the top, position 100, there are 100": _epsilon(101),
        "that is for a wall of height 30, and this one has 100": _epsilon(30),
        "that is the probability of a *right* step": 0.5 ** (1 / HEIGHT),
        "a step goes right with probability 1 − ε/2, not ε/2": 2 * 0.5 ** (1 / HEIGHT),
        "that is in percent; a probability lies between 0 and 1": 100 * EPSILON,
        "of two grips a random action takes the wrong one with probability 1/2, not 2/3": 0.75 * EPSILON,
        "natural and decimal logarithms are mixed up": 2 * (1 - 10 ** (math.log(0.5) / HEIGHT)),
        "the sign is wrong: ε = 2 (1 − 0.5^(1/100))": -EPSILON,
        "that is the value with which the cell began": 0.1,
    }

    def says(epsilon: float) -> str:
        if not 0 <= epsilon <= 1:
            return f"ε = {digits(epsilon, 0.0)} is no probability"
        return f"with ε = {digits(epsilon, EPSILON)}, {(1 - epsilon / 2) ** HEIGHT:.2%} of the climbs reach the top"

    found = number("epsilon", answer)
    close = abs(found / EPSILON - 1) < 0.02
    otherwise = "half should, so ε must be " + ("smaller" if found > EPSILON else "larger")
    compare(
        "epsilon",
        answer,
        EPSILON,
        mistakes,
        tolerance=2e-5,
        says=says,
        otherwise=f"{otherwise}, by a little: give four digits or more" if close else otherwise,
    )
    return "Right: ε = 1.38 % is little, and yet one wrong grip in 145 costs half of the climbs."


def _epsilon(height: int) -> float:
    return float(2 * (1 - 0.5 ** (1 / height)))


def explorer_update(
    tables: Tables,
    now: Transition,
    *,
    bonus: float,
    novelty: str = "1/√n",
    counts: str = "entered",
    tries: str = "taken",
    looks_up: str = "entered",
    late: bool = False,
    least: int = 0,
    **one_step: Any,
) -> None:
    """Count, and apply Q-learning on the reward plus β/√n; other arguments than the defaults are mistakes."""
    state, action, next_state = now.state, now.action, now.next_state
    n_states, n_actions = tables["tries"].shape
    old_count = _count(tables, looks_up, now)
    if counts != "nothing":
        tables["visits"][{"entered": next_state, "left": state}[counts]] += 1
    if tries != "nothing":
        swapped = action % n_states, state % n_actions
        tables["tries"][{"taken": (state, action), "next": (next_state, action), "swapped": swapped}[tries]] += 1
    n = max(old_count, least) if late else _count(tables, looks_up, now)
    share = {
        "1/√n": 1 / np.sqrt(n),
        "1/n": 1 / np.float64(n),
        "1/n/2": 1 / np.float64(n) / 2,
        "discounted": one_step["discount"] / np.sqrt(n),
        "√n": np.sqrt(n),
        "1/√(n+1)": 1 / np.sqrt(n + 1),
        "constant": 1.0,
        "first visit": float(n == 1),
        "minus": -1 / np.sqrt(n),
        "none": 0.0,
        "not at the end": 0.0 if now.terminated else 1 / np.sqrt(n),
    }
    one_step_update(tables, now, extra=bonus * share[novelty], **one_step)


def _count(tables: Tables, looks_up: str, now: Transition) -> Any:
    """Return the count that the bonus depends on."""
    if looks_up == "pair":
        return tables["tries"][now.state, now.action]
    return tables["visits"][{"entered": now.next_state, "left": now.state}[looks_up]]


NOVELTY_MISTAKES: Mapping[str, Mapping[str, Any]] = {
    "it counts the state that was left; count the one that was *entered*, next_state": {
        "counts": "left",
        "looks_up": "left",
    },
    "`visits` counts the state that was left; count the one that was *entered*, next_state": {"counts": "left"},
    "the bonus is that of the state that was left; it belongs to the one that was *entered*, next_state": {
        "looks_up": "left"
    },
    "the bonus is computed from the number of tries of the action, n(s, a), and it should come from visits, n(s')": {
        "looks_up": "pair"
    },
    "`visits` does not count": {"counts": "nothing"},
    "`tries` does not count": {"tries": "nothing"},
    "`tries` counts next_state; count the state in which the action was *taken*": {"tries": "next"},
    "state and action have changed places in `tries`": {"tries": "swapped"},
    "the bonus comes from the old count: count first, so that a first visit has n = 1": {"late": True},
    "the bonus comes from the old count, or from 1 at the first visit: count before you divide": {
        "late": True,
        "least": 1,
    },
    "the bonus is β/√(n + 1), one visit too many": {"novelty": "1/√(n+1)"},
    "the root is missing: the bonus is β/√n": {"novelty": "1/n"},
    "`** 1 / 2` is `(... ** 1) / 2`: write `** 0.5` for the root": {"novelty": "1/n/2"},
    "the whole target is discounted; γ belongs to the value of the next state only": {"target": "all discounted"},
    "the bonus is discounted; γ belongs to the value of the next state only": {"novelty": "discounted"},
    "the bonus grows with the count: it is β *divided* by √n": {"novelty": "√n"},
    "the bonus does not fade with the count: it is β/√n": {"novelty": "constant"},
    "only the first visit earns a bonus; every visit earns β/√n": {"novelty": "first visit"},
    "the bonus is subtracted": {"novelty": "minus"},
    "the bonus is missing": {"novelty": "none"},
    "at the end of an episode the bonus is lost: only the *value of the next state* is 0 there": {
        "novelty": "not at the end"
    },
}

EXPLORER = Update(
    rule=explorer_update,
    tables=lambda n_states, n_actions, rng: {
        "visits": rng.integers(0, 9, n_states),
        "tries": rng.integers(0, 5, (n_states, n_actions)),
        "Q": made_up_values(n_states, n_actions, rng),
    },
    mistakes={**NOVELTY_MISTAKES, **Q_LEARNING.mistakes},
    numbers={
        "learning_rate": "everything fits a learning rate of {found:.4g}, not {right:.4g}: use self.learning_rate",
        "discount": "everything fits a discount of {found:.4g}, not {right:.4g}: use self.discount",
        "bonus": "everything fits a first bonus of {found:.4g}, not β = {right:.4g}: use self.bonus",
    },
)


def exercise_2(answer: Any, seed: int) -> str:
    """Check the function that makes a greedy Q-learning agent with all values at 1."""
    given("optimist", answer)
    if isinstance(answer, type) or not callable(answer):
        kind = answer.__name__ if isinstance(answer, type) else type(answer).__name__
        raise WrongAnswer(f"optimist should be a function of the wall that returns an agent, but is of the type {kind}")
    rng = np.random.default_rng(seed)
    for height, n_grips in ((30, 2), (int(rng.integers(4, 9)), 3)):
        wall = make_mdp("Boulder", height=height, n_grips=n_grips, layout_seed=int(rng.integers(1000)))
        make = partial(_made, "optimist(wall)", answer, wall)
        made, other = make(), make()
        Q = table_of(made, "Q", (height + 1, n_grips))
        if np.shares_memory(Q, other.Q):
            raise WrongAnswer("two calls of optimist(wall) share one table: make a new one in every call")
        for state, value in ((int(Q.argmin() // n_grips), Q.min()), (int(Q.argmax() // n_grips), Q.max())):
            compare(
                f"every value in Q[{state}]",
                value,
                1.0,
                {"that is the usual first value: `create` has a setting `initial_value`": 0.0},
                otherwise="all values should start at 1",
            )
        epsilon = getattr(getattr(made, "exploration", None), "epsilon", 0.0)
        if epsilon != 0.0:
            raise WrongAnswer(f"the optimist explores by its values alone, so ε should be 0, but it is {epsilon:g}")
        Q_LEARNING.check(make, Q.shape, {"learning_rate": LEARNING_RATE, "discount": DISCOUNT}, seed)
        Q[1, :], Q[1, 1] = 0.25, 0.5
        Q[2, :], Q[2, 0] = 0.5, -0.5
        one_in = 1 / n_grips
        best, equal = [0.0] * n_grips, [1 / (n_grips - 1)] * n_grips
        best[1], equal[0] = 1.0, 0.0
        check_choices(
            "act(1, rng)",
            partial(made.act, 1),
            best,
            {
                "it acts at random": [one_in] * n_grips,
                "it takes the worst grip": [1.0, *[0.0] * (n_grips - 1)],
                **_epsilon_greedy(best),
            },
            tables={"Q": Q},
            where=f"where Q[1] = {Q[1].tolist()}",
        )
        check_choices(
            "act(2, rng)",
            partial(made.act, 2),
            equal,
            {
                "it acts at random": [one_in] * n_grips,
                "ties should be broken at random, and it takes the first of equals": np.eye(n_grips)[1].tolist(),
                "ties should be broken at random, and it takes the last of equals": np.eye(n_grips)[-1].tolist(),
            },
            tables={"Q": Q},
            where=f"where Q[2] = {Q[2].tolist()}",
        )
    return (
        "Right: it never takes a random action, and yet it tries everything, for whatever it tries disappoints it. "
        "See it race:"
    )


def _epsilon_greedy(best: list[float]) -> dict[str, list[float]]:
    """Return the probabilities of some agents that still explore."""
    return {
        f"it still explores, with ε = {epsilon}": [epsilon / len(best) + (1 - epsilon) * share for share in best]
        for epsilon in (0.05, 0.1, 0.2, 0.5)
    }


def exercise_3(answer: Any, seed: int) -> str:
    """Check the class of an explorer that tries what it has not tried, and learns with a novelty reward."""
    given("MyExplorer", answer)
    if not isinstance(answer, type):
        raise WrongAnswer(f"MyExplorer should be the class, but is of the type {type(answer).__name__}")
    rng = np.random.default_rng(seed)
    for n_grips in (2, 3):
        height = int(rng.integers(4, 9))
        wall = make_mdp("Boulder", height=height, n_grips=n_grips)
        settings = {
            "learning_rate": float(rng.choice([0.125, 0.25, 0.75])),
            "discount": float(rng.choice([0.5, 0.625, 0.75])),
            "bonus": float(rng.choice([1.5, 3.0, 5.0])),
        }
        make = partial(_explorer, answer, wall, settings)
        EXPLORER.check(make, (height + 1, n_grips), settings, seed)
        _check_act(make(), n_grips)
    return (
        "Right: counting tries says what is new here, the bonus says where to go, and no random step is needed. "
        "See it race:"
    )


def _explorer(answer: Any, wall: Any, settings: Mapping[str, float]) -> Any:
    """Make a student's explorer with other settings than its own."""
    made = _made("MyExplorer.create(wall)", answer.create, wall)
    missing = [name for name in settings if not hasattr(made, name)]
    if missing:
        raise WrongAnswer(f"MyExplorer should keep its field `{missing[0]}`, from which `learn` reads the number")
    if hasattr(made, "_replace"):
        return made._replace(**settings)
    for name, value in settings.items():
        setattr(made, name, value)
    return made


def _check_act(agent: Any, n_grips: int) -> None:
    """Check what an explorer does where some grips, all or none were tried."""
    others = n_grips - 1
    same = [1 / n_grips] * n_grips
    last = [0.0] * others + [1.0]
    first = [1.0] + [0.0] * others
    but_first = [0.0] + [1 / others] * others
    untried = "a grip that was never tried comes first, whatever Q says of it"
    cases: list[tuple[list[int], list[float], list[float], dict[str, list[float]]]] = [
        (
            [*range(3, 3 + others), 0],
            [1.0] * others + [-1.0],
            last,
            {untried: [1 / others] * others + [0.0], "it takes the grip that was tried most often": last[::-1]},
        ),
        ([0, *range(1, n_grips)], [-1.0] + [1.0] * others, first, {untried: but_first}),
        (
            [7, *range(1, n_grips)],
            [2.0] + [1.0] * others,
            first,
            {
                "once all grips were tried the *best* one counts, and it takes the one that was tried least": [
                    0.0,
                    1.0,
                    *[0.0] * (others - 1),
                ],
                "once all grips were tried the best one counts, and it takes the worst": but_first,
            },
        ),
        (
            [1, *range(5, 5 + others)],
            [-0.5] + [-0.25] * others,
            but_first,
            {
                "once all grips were tried the *best* one counts, and it takes the one that was tried least": first,
                "ties should be broken at random, and it takes the first of equals": [
                    0.0,
                    1.0,
                    *[0.0] * (others - 1),
                ],
                "ties should be broken at random, and it takes the last of equals": last,
            },
        ),
    ]
    for state, (tries, values, expected, mistakes) in enumerate(cases):
        agent.tries[state], agent.Q[state] = tries, values
        agent.visits[state] = sum(tries)
        check_choices(
            f"act({state}, rng)",
            partial(agent.act, state),
            expected,
            {**mistakes, "it acts at random": same, **_epsilon_greedy(expected)},
            tables={name: getattr(agent, name) for name in ("Q", "visits", "tries")},
            where=f"where tries[{state}] = {tries} and Q[{state}] = {values}",
        )


def _made(call: str, make: Callable[[Any], Any], wall: Any) -> Any:
    """Make a student's agent, and refuse what is none."""
    with running(call):
        made = make(wall)
    given(call, made)
    if isinstance(made, type):
        raise WrongAnswer(
            f"{call} should give an agent, but gives the class {made.__name__}: write {made.__name__}.create"
        )
    missing = [name for name in ("act", "learn") if not hasattr(made, name)]
    if missing:
        raise WrongAnswer(
            f"{call} should give an agent, but what it gives, of the type {type(made).__name__}, has no `{missing[0]}`"
        )
    return made


def exercise_4(answer: Any, seed: int) -> str:
    """Check the results of the three methods, and of one more, on a frozen lake."""
    lake = gymnasium.make("FrozenLake-v1", map_name="8x8", is_slippery=False)
    asked = {
        "environment": "FrozenLake-v1",
        "environment.map_name": "8x8",
        "environment.is_slippery": False,
        "n_steps": N_STEPS,
        "repetitions": 5,
    }
    results = check_results("frozen", answer, asked=asked, methods=METHODS, environment=lake)
    own = [label for label in results.methods if label not in METHODS]
    if not own:
        raise WrongAnswer("frozen should have a fourth method, your own, beside the three of the lesson")
    solved = ", ".join(f"{label} {(results.final(label) >= 1).sum()} of 5" for label in results.methods)
    return (
        f"Right. Runs that solve the lake: {solved}. Novelty helps less here: a hole ends the episode and all later "
        "bonuses with it, and the reward, 14 steps away, is discounted to a quarter of the first bonus."
    )


def best_average(height: int, n_grips: int, n_steps: int) -> float:
    """Return the average return over training of an explorer that takes no avoidable step, in expectation.

    It tries each grip once, on average (N - 1)/2 wrong ones at every height, and needs h + 1 steps to get back to
    height h after each: H + (N - 1)/2 · H (H + 1)/2 steps to the top. From then on every greedy episode gets there.
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
            "optimistic": partial(
                QLearning.create,
                learning_rate=1.0,
                discount=DISCOUNT,
                exploration=EpsilonGreedy(0.0),
                initial_value=1.0,
            ),
            NOVELTY: METHODS[NOVELTY],
        }
    ),
    optimum=1.0,
    best_average=best_average(60, 2, 5_000),
)
"""The open challenge: the highest return within 5 000 steps at height 60."""
