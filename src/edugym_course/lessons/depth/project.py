"""The project of lesson 3: n-step SARSA from its definition, from a blank file."""

import math
from functools import partial
from typing import Any

import gymnasium

from edugym.adapters.fitting import tabular
from edugym.agents.n_step_sarsa import NStepSARSA
from edugym_course.grading.curves import Race, compare_with_ours, program_of
from edugym_course.grading.programs import Environment
from edugym_course.grading.replay import Learner, Rule, mistakes_of_loops
from edugym_course.lessons.depth.targets import EPSILON

N_STEPS, N, LEARNING_RATE, DISCOUNT = 5_000, 3, 0.5, 0.99


def agent(
    shape: tuple[int, int], n: float = N, learning_rate: float = LEARNING_RATE, discount: float = DISCOUNT
) -> NStepSARSA:
    """Make an agent with the settings of the project."""
    return NStepSARSA.create(shape, n=n, learning_rate=learning_rate, discount=discount)


def study() -> Environment:
    """Make the environment, eight days with numbered states."""
    made: Environment = tabular(gymnasium.make("edugym/Study-v0", total_days=8))
    return made


RULE = Rule(
    Learner(agent),
    mistakes_of_loops(agent, on_policy=True)
    | {
        "the target has one reward only: that is SARSA": Learner(partial(agent, n=1)),
        "the target has two rewards, and it should have three": Learner(partial(agent, n=2)),
        "the target has four rewards, and it should have three": Learner(partial(agent, n=4)),
        "the target has all rewards to the end of the episode: that is Monte Carlo": Learner(
            partial(agent, n=math.inf)
        ),
        "the target has the next reward alone": Learner(partial(agent, n=1, discount=0.0)),
        "the learning rate is much too small: it is 0.5 in the text": Learner(partial(agent, learning_rate=0.1)),
    },
    EPSILON,
    truncates=False,
    otherwise="; look at two places: at the end of an episode the targets of *all* pairs that are left are made of"
    " rewards alone, and elsewhere the value γⁿ Q(S_τ+n, A_τ+n) comes after the n rewards",
)
STUDY = Race(study, N_STEPS, program_of(agent), episodes=20)


def project_3(answer: Any, seed: int) -> str:
    """Check a program with n-step SARSA."""
    RULE.check(answer, seed)
    return f"Right: n rewards, and then a value. {compare_with_ours(answer, STUDY, seed)}"
