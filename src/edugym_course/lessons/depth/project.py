"""The project of lesson 3: n-step SARSA from its definition, from a blank file."""

import math
from functools import partial
from typing import Any

import gymnasium

from edugym.adapters.fitting import tabular
from edugym.agents.n_step_sarsa import NStepSARSA
from edugym_course.grading.again import require_no_mistake
from edugym_course.grading.curves import Race, compare_with_ours, program_of
from edugym_course.grading.learners import Learner, mistakes_of_loops, other_settings, other_tables
from edugym_course.grading.programs import Environment
from edugym_course.grading.rule import Rule
from edugym_course.lessons.depth.cuts import require_cuts
from edugym_course.lessons.depth.slips import DISCOUNT, LEARNING_RATE, N, discounted, slips
from edugym_course.lessons.depth.targets import EPSILON

N_STEPS = 5_000


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
        "after the rewards comes the largest value of S_τ+n, or a mean near it; it should be that of the action taken,"
        " A_τ+n. With the maximum the target is the *uncorrected* one of this lesson; or is A_τ+n drawn twice, for the"
        " target and for the step? Draw it once": Learner(partial(slips, largest=True)),
        "no value comes after the n rewards: γⁿ Q(S_τ+n, A_τ+n) is missing": Learner(partial(slips, bootstrap=0.0)),
        "at the end of an episode only one pair is learned, and the others that are left have rewards to learn from"
        " too": Learner(partial(slips, last_only=True)),
        "the value after the n rewards is not discounted: it is γⁿ Q(S_τ+n, A_τ+n)": Learner(
            partial(slips, bootstrap=1.0)
        ),
        "the rewards are discounted from the start of the episode, and they should be from step τ: the first reward of"
        " a target has the weight 1": Learner(partial(slips, from_start=True)),
        "the value after the n rewards has the weight γⁿ⁻¹, and it should be γⁿ": Learner(
            partial(slips, bootstrap=DISCOUNT ** (N - 1))
        ),
        "the value after the n rewards has the weight γⁿ⁺¹, and it should be γⁿ": Learner(
            partial(slips, bootstrap=DISCOUNT ** (N + 1))
        ),
        "the value after the n rewards has the weight γ, and it should be γⁿ": Learner(
            partial(slips, bootstrap=DISCOUNT)
        ),
        "the value is that of S_τ+n-1 and A_τ+n-1, one step too early": Learner(partial(slips, early=True)),
        "all rewards have the same weight: the first one has the weight 1, the second γ, and the third γ²": Learner(
            partial(slips, total=sum)
        ),
        "the powers of γ run backwards: the *first* reward of a target has the weight 1": Learner(
            partial(slips, total=lambda rewards: discounted(rewards[::-1]))
        ),
        "the first reward is left out of the target, that of step τ itself, R_τ+1": Learner(
            partial(slips, total=lambda rewards: discounted(rewards[1:]))
        ),
        "the mean of the rewards stands where their sum should": Learner(
            partial(slips, total=lambda rewards: discounted(rewards) / len(rewards))
        ),
        "at the end of an episode all its pairs are learned, also those that have learned before": Learner(
            partial(slips, again=True)
        ),
        "the last of the n rewards is left out of the target, R_τ+n": Learner(
            partial(slips, total=lambda rewards: discounted(rewards[: N - 1]))
        ),
        "the rewards of a target begin one step too early: the first one is R_τ+1, which follows on A_τ": Learner(
            partial(slips, shift=1)
        ),
        "it is always the value of the newest pair that moves, and it should be that of S_τ and A_τ": Learner(
            partial(slips, newest=True)
        ),
        "the last reward of each target is left out: range(τ, k) ends with k − 1": Learner(
            partial(slips, total=lambda rewards: discounted(rewards[:-1]))
        ),
        "each pair is learned one step too late, with a value that comes n + 1 steps after it: after step t learn the"
        " pair of τ = t − n + 1": Learner(partial(slips, late=True)),
        "the lists of the last episode go on in the next one: empty them at each reset": Learner(
            partial(slips, keeps=True)
        ),
        "the value is that of S_τ+n with the action before: draw A_τ+n first, and learn then": Learner(
            partial(slips, stale_action=True)
        ),
        "the first pair of an episode is never learned (τ = 0 counts, too), or its action is not chosen by ε-greedy in"
        " the state that reset() gives": Learner(partial(slips, begin=1)),
        "the last pair of an episode is never learned, and it has its reward": Learner(partial(slips, forgotten=1)),
        "an episode is learned from its last pair to its first, and it should be from the oldest pair on": Learner(
            partial(slips, backwards=True)
        ),
    }
    | other_settings(
        agent,
        discount=("γ", DISCOUNT, (1.0, 0.99, 0.95, 0.9, 0.85, 0.75, 0.7, 0.6, 0.5)),
        learning_rate=("α", LEARNING_RATE, (0.1, 0.25, 0.4, 0.6, 0.75, 1.0)),
    )
    | other_tables(agent),
    EPSILON,
    truncates=False,
    otherwise="; look at two places: at the end of an episode the targets of *all* pairs that are left are rewards"
    " alone, and elsewhere γⁿ Q(S_τ+n, A_τ+n) comes after the n rewards, where A_τ+n is drawn once and then taken; and"
    " the lists hold the actions that were taken, in this episode",
)
STUDY = Race(study, N_STEPS, program_of(agent), episodes=20)


def project_3(answer: Any, seed: int) -> str:
    """Check a program with n-step SARSA."""
    RULE.check(answer, seed)
    require_cuts(answer, seed)
    require_todays_values(answer, seed)
    return f"Right: n rewards, and then a value. {compare_with_ours(answer, STUDY, seed)}"


def require_todays_values(program: Any, seed: int) -> None:
    """Refuse a program that keeps Q(S_τ, A_τ) from step τ, and subtracts it when the pair is learned.

    Such a program differs where a pair comes twice within n steps. So do programs that wait for the end of an episode,
    and they are not judged here.

    Raises:
        WrongAnswer: it does, or it breaks the contract.
    """
    mistake = (
        "what is subtracted from the target is Q(S_τ, A_τ) as it was in step τ. Read it when you update the pair: it"
        " may have changed since"
    )
    require_no_mistake(program, seed, slips, {mistake: partial(slips, old=True)}, EPSILON, truncates=False)
