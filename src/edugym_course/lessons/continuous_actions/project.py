"""The project of lesson 7: REINFORCE with a Gaussian policy that learns its spread too, from a blank file.

Such a program draws all its actions, so none of them is right or wrong. But its own steps tell, by the equations of the
lesson, which μ it should return, and from which Gaussians it should have drawn its actions.
"""

import math
from collections.abc import Sequence
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.checks.parameters import in_short
from edugym_course.grading.curves import Race, compare_with_ours
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.programs import NAME, POLICY, Environment, Policy, Step, run_program
from edugym_course.grading.repeats import require_reproducible
from edugym_course.grading.rule import TRIAL
from edugym_course.grading.student_code import student_code
from edugym_course.lessons.continuous_actions.draws import Maker, fit, follow, require_drawn, require_gaussian
from edugym_course.lessons.continuous_actions.exercises.boxes import (
    LARGEST,
    POLICY_RATE,
    SMALLEST,
    VALUE_RATE,
    Boxes,
    FarPays,
    Gaussians,
    returns_from,
    returns_until,
    score_of_log,
    score_of_mean,
)

N_STEPS, WORLDS, FAR_STEPS = 6_000, 2, 2_000
EARLY = 100, 300
"""After so few steps equal equations give equal μ, whatever the last digits; with large rates after the fewer ones."""
SAME, NEARLY_SAME = 1e-5, 1e-2
"""How far two μ may be apart, in the larger of 1 and their size: after few steps, and after all of them."""

UNBOUNDED = "σ is not kept between 0.2 and 2"
MISTAKES: dict[str, Maker] = {
    "the reward of a step stands in the place of the return G, which sums up all rewards from it to the end": partial(
        Gaussians, returns=lambda rewards, _: rewards
    ),
    "the return sums up the rewards up to a step, and it should be those from it to the end": partial(
        Gaussians, returns=returns_until
    ),
    "each G is that of the next step: is it noted before the reward of its own step is added?": partial(
        Gaussians, returns=lambda rewards, discount: [*returns_from(rewards, discount)[1:], 0.0]
    ),
    "the return is not discounted: γ is 0.8 in the text": partial(
        Gaussians, returns=lambda rewards, _: returns_from(rewards, 1.0)
    ),
    "the returns stand in the reverse order, as in a list that was filled from the last step on: turn it": partial(
        Gaussians, returns=lambda rewards, discount: returns_from(rewards, discount)[::-1]
    ),
    "γ is 0.99, and it should be 0.8": partial(Gaussians, discount=0.99),
    "γ is 0.9, and it should be 0.8": partial(Gaussians, discount=0.9),
    "the baseline is the mean of the returns of the episode, and it should be V(S)": partial(Gaussians, averages=True),
    "all states have the same V: is the index of the state missing where V changes?": partial(Gaussians, shared="V"),
    "the returns of a truncated episode go on with V(S'), and they should stop at its last reward": partial(
        Gaussians, goes_on=True
    ),
    "the factor γ^t counts the steps from the end of the episode, and it should be from its start": partial(
        Gaussians, fades="backwards"
    ),
    "ln σ moves twice as far as it should: the 2 in 2σ² and the square cancel": partial(
        Gaussians, of_log=lambda off, spread: 2 * score_of_log(off, spread)
    ),
    "there is no baseline: the policy moves by G, and it should move by δ = G − V(S)": partial(
        Gaussians, value_rate=0.0
    ),
    "the factor γ^t is missing": partial(Gaussians, fades=False),
    "the factor γ^t is missing where μ moves": partial(Gaussians, fades="ln σ"),
    "the factor γ^t is missing where ln σ moves": partial(Gaussians, fades="μ"),
    "V moves by the TD error, and it should move by G − V(S)": partial(Gaussians, bootstraps="V"),
    "the policy moves away from actions that were better than the baseline: is a minus sign too many?": partial(
        Gaussians, policy_rate=-POLICY_RATE
    ),
    "σ is never learned: ln σ has a score, too": partial(Gaussians, of_log=lambda off, spread: 0.0),
    "the score of ln σ lacks its − 1, so σ grows wherever δ is above 0": partial(
        Gaussians, of_log=lambda off, spread: off / spread * (off / spread)
    ),
    "what is learned is ln σ, with the score of σ: that of ln σ is σ times as large": partial(
        Gaussians, of_log=lambda off, spread: score_of_log(off, spread) / spread
    ),
    "what is learned is σ, with the score of σ: learn ln σ, with its own": partial(Gaussians, itself=True),
    "σ itself moves by the score of ln σ, and ln σ should move by it": partial(
        Gaussians, itself=True, of_log=lambda off, spread: score_of_log(off, spread) * spread
    ),
    "nothing is learned from an episode that is truncated: it is over as well, and its returns stop at its last"
    " reward": partial(Gaussians, cut_short=False),
    "the score of μ is not divided by σ²": partial(Gaussians, of_mean=lambda off, spread: off),
    "the score of μ is divided by σ, and it should be by σ²": partial(
        Gaussians, of_mean=lambda off, spread: off / spread
    ),
    "the score of ln σ is computed with the μ that has just moved: keep A − μ before you change μ": partial(
        Gaussians, moves="μ"
    ),
    "the score of μ is computed with the σ that has just changed: keep σ before you change ln σ": partial(
        Gaussians, moves="σ"
    ),
    "nothing is learned from the last step of an episode: its G is its reward": partial(Gaussians, all_steps=False),
    UNBOUNDED: partial(Gaussians, bounds=(1e-9, 1e9)),
    "σ is kept below 1, and it may grow to 2": partial(Gaussians, bounds=(SMALLEST, 1.0)),
    "σ may fall to 0.1, and it should stay at 0.2 or above": partial(Gaussians, bounds=(0.1, LARGEST)),
    "ln σ is kept between 0.2 and 2, and it is σ that should be; ln σ lies between ln 0.2 and ln 2": partial(
        Gaussians, bounds=(math.exp(SMALLEST), math.exp(LARGEST))
    ),
    "all states have the same μ and σ, and each should have its own": partial(Gaussians, shared="μσ"),
    "all states have the same μ: is the index of the state missing where μ changes?": partial(Gaussians, shared="μ"),
    "σ is 0.5 at first, and it should be 1": partial(Gaussians, first=0.5),
    "ln σ is 1 at first, and it should be 0: then σ is 1": partial(Gaussians, first=math.e),
    "V hardly learns: α^w is 0.1 in the text, and not α^θ": partial(Gaussians, value_rate=POLICY_RATE),
    "the factor γ^t stands in the line of V as well: it belongs to the policy alone": partial(Gaussians, fades="V"),
    "the power of γ is one too large, in γ^t or in G: the first step of an episode has γ^0 = 1, and so has the first"
    " reward of a return": partial(Gaussians, fades="later"),
    "V is 1 at first, and it should be 0": partial(Gaussians, first_value=1.0),
    "the two learning rates, α^θ and α^w, have changed places": partial(
        Gaussians, policy_rate=VALUE_RATE, value_rate=POLICY_RATE
    ),
    "it learns of the states after the actions, and not of those in which they were taken": partial(
        Gaussians, after=True
    ),
    "the first state of an episode is the last one of the episode before: keep what reset() gives": partial(
        Gaussians, stale=True
    ),
    "nothing is learned from the first step of an episode": partial(Gaussians, skips=1),
    "it learns from the last episode, too, which time cut off: drop it, since its returns are not whole": partial(
        Gaussians, to_the_end=True
    ),
    "every step gets the return of the whole episode, and it should be the one from this step on": partial(
        Gaussians, returns=lambda rewards, discount: [returns_from(rewards, discount)[0]] * len(rewards)
    ),
    "δ is the TD error R + γ V(S') − V(S), as in the actor-critic; here it is G − V(S)": partial(
        Gaussians, bootstraps=True
    ),
    "the sign of the score of μ is wrong: it is A − μ above the line": partial(
        Gaussians, of_mean=lambda off, spread: -score_of_mean(off, spread)
    ),
    "the sign of the score of ln σ is wrong: σ should grow where δ and the distance from μ are large": partial(
        Gaussians, of_log=lambda off, spread: -score_of_log(off, spread)
    ),
    "it learns from an action that is cut off at −1 and 1, and not from the one that it drew": partial(
        Gaussians, cut=1.0
    ),
    "the policy learns from G less the V that has just moved: compute δ before you change V": partial(
        Gaussians, fresh=True
    ),
    "all earlier episodes are learned from again at the end of each: empty the lists of the episode when it has learned"
    " from them": partial(Gaussians, keeps=True),
    "all earlier episodes are learned from again at the end of each, the last step first: empty the list of the episode"
    " when it has learned from it": partial(Gaussians, keeps=True, backwards=True),
    **{
        f"the learning rate of the policy, α^θ, is {rate:g}, and it should be {POLICY_RATE:g}": partial(
            Gaussians, policy_rate=rate
        )
        for rate in (0.0005, 0.001, 0.002, 0.0025, 0.01, 0.02, 0.025, 0.05, 0.1)
    },
    **{
        f"the learning rate of V, α^w, is {rate:g}, and it should be {VALUE_RATE:g}": partial(
            Gaussians, value_rate=rate
        )
        for rate in (0.001, 0.01, 0.02, 0.05, 0.2, 0.25, 0.5, 1.0)
    },
}
"""The usual mistakes that give other μ, by their sentences."""


class Returned(NamedTuple):
    """A run of a program, and the μ that its policy returns for the states that came.

    Attributes:
        steps: of the run.
        means: by state.
    """

    steps: Sequence[Step]
    means: dict[int, float]

    def other(self, make: Maker, tolerance: float) -> tuple[int, float] | None:
        """The state in which a learner from the same steps has another μ, the one farthest off, and that μ; or None."""
        learner, _ = follow(self.steps, make)
        other = {state: learner.gaussian(state)[0] for state in self.means}
        apart = {state: abs(mean - other[state]) / max(1.0, abs(mean)) for state, mean in self.means.items()}
        state = max(apart, key=lambda state: apart[state])
        return None if apart[state] < tolerance else (state, other[state])


def check_equations(program: Any, seed: int) -> None:
    """Check that a program returns the μ that its own steps give, and draws its actions from their Gaussians.

    Raises:
        WrongAnswer: it does not; or the program breaks the contract.
    """
    seeds = range(WORLDS * seed, WORLDS * (seed + 1))
    require_reproducible(program, partial(Boxes, seeds[0], truncates=True), TRIAL, seed)
    early = [_returned(program, Boxes(number, truncates=True), number, n) for n in EARLY for number in seeds]
    early.append(_returned(program, Boxes(seeds[0], in_a_row=True), seeds[0], EARLY[-1]))
    require_drawn([run.steps for run in early])
    possible = _require_means(early, SAME, list(MISTAKES))
    late = [_returned(program, Boxes(number, truncates=True), number, N_STEPS) for number in seeds]
    runs = [run.steps for run in late]
    require_drawn(runs)
    _require_means(late, NEARLY_SAME, possible)
    require_gaussian(runs)


def _returned(program: Any, environment: Environment, seed: int, n_steps: int) -> Returned:
    """Run a program, and ask its policy twice for the μ of each state that came: a number, and not drawn."""
    run = run_program(program, environment, n_steps, seed)
    means = {}
    for state in sorted({step.state for step in run.steps}):
        with student_code(POLICY):
            one, again = (run.policy(state) for _ in range(2))
        try:
            means[state], other = (float(np.asarray(mean, float).item()) for mean in (one, again))
        except (TypeError, ValueError):
            raise WrongAnswer(
                f"{POLICY} gives {in_short(one)} for state {state}, and it should be one real number, μ"
            ) from None
        if not math.isfinite(means[state]):
            raise WrongAnswer(
                f"{POLICY} gives {in_short(one)} for state {state}, and it should be one real number, μ: is its"
                " `return` missing, or have the values grown without end?"
            )
        if means[state] != other:
            raise WrongAnswer(
                f"{POLICY} draws its actions: asked twice about state {state}, it gives two different ones. It should"
                " return the mean μ of the state"
            )
    return Returned(run.steps, means)


def _same(runs: Sequence[Returned], tolerance: float, mistakes: Sequence[str]) -> list[str]:
    """Return those of the mistakes that give the very same μ."""
    return [sentence for sentence in mistakes if not any(run.other(MISTAKES[sentence], tolerance) for run in runs)]


def _require_means(runs: Sequence[Returned], tolerance: float, mistakes: Sequence[str]) -> list[str]:
    """Refuse other μ than those that the steps of the runs give by the equations.

    Returns:
        Those of the mistakes that give the very same μ.

    Raises:
        WrongAnswer: they are others; it names the likeliest of these mistakes.
    """
    same = _same(runs, tolerance, mistakes)
    if not same and any(run.other(Gaussians, tolerance) for run in runs[:WORLDS]):
        same = _same(runs[:WORLDS], tolerance, mistakes)
    for run in runs:
        if (found := run.other(Gaussians, tolerance)) is None:
            continue
        state, mean = found
        if same:
            likely = max(same, key=lambda sentence: fit([run.steps for run in runs], MISTAKES[sentence]).log)
            cause = f"A usual mistake gives the very same numbers: {likely}"
        else:
            cause = (
                "No usual mistake gives these numbers. Compare the rates, γ, the bounds of σ and the first values with"
                " those of the text, and the updates with their equations, term by term; does it learn in all states,"
                " from all steps of an episode, and from each once? Does each episode begin with empty lists, and its G"
                " with 0? Does the policy return μ as it is?"
            )
        raise WrongAnswer(
            f"after {len(run.steps)} steps the policy of {NAME} should return μ = {mean:.4g} for state {state}, by its"
            f" own steps and the equations of this lesson, and it returns {run.means[state]:.4g}. {cause}"
        )
    return same


def check_bound(program: Any, seed: int) -> None:
    """Check that σ stops at its upper bound, and μ nowhere: over the boxes they never come so far.

    Raises:
        WrongAnswer: it does not.
    """
    runs = [_returned(program, FarPays(), number, FAR_STEPS) for number in range(2 * seed, 2 * seed + 2)]
    require_drawn([run.steps for run in runs])
    where = f"where the farthest actions pay most, so that σ grows to {LARGEST:g},"
    not_kept = WrongAnswer(f"{where} keep it between {SMALLEST:g} and {LARGEST:g} after each step, and draw with it")
    if _same(runs, NEARLY_SAME, [UNBOUNDED]):
        raise not_kept
    for run in runs:
        if found := run.other(Gaussians, NEARLY_SAME):
            raise WrongAnswer(
                f"{where} the policy of {NAME} should return μ = {found[1]:.4g}, by its own steps, and it returns"
                f" {run.means[found[0]]:.4g}: after each step keep σ between {SMALLEST:g} and {LARGEST:g}, and let μ go"
                " as far as it goes"
            )
    if not fit([run.steps for run in runs], Gaussians).is_usual:
        raise not_kept


def reinforce(environment: Environment, n_steps: int, seed: int, make: Maker = Gaussians) -> Policy:
    """Our program, or one that makes a mistake."""
    assert isinstance(environment.observation_space, spaces.Discrete)
    learner, rng = make(int(environment.observation_space.n)), np.random.default_rng(seed)
    state, episode = environment.reset(seed=seed)[0], list[Step]()
    for _ in range(n_steps):
        action = float(rng.normal(*learner.gaussian(state)))
        next_state, pays, terminated, truncated, _ = environment.step(action)
        of = next_state if learner.after else state
        episode.append(Step(of, action, float(pays), next_state, terminated, truncated))
        state = next_state
        if terminated or truncated:
            learner.learn(episode)
            first = environment.reset()[0]
            state, episode = (state if learner.stale else first), (episode if learner.keeps else [])
    if learner.to_the_end and episode:
        learner.learn(episode)
    return lambda state: learner.gaussian(state)[0]


ARM = Race(partial(Boxes, 0), N_STEPS, reinforce, episodes=20)


def project_7(answer: Any, seed: int) -> str:
    """Check a program with REINFORCE and a learned spread."""
    check_equations(answer, seed)
    check_bound(answer, seed)
    return f"Right: its Gaussians are those of its steps. {compare_with_ours(answer, ARM, seed)}"
