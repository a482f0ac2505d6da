"""The project of lesson 7: REINFORCE with a Gaussian policy that learns its spread too, from a blank file.

Such a program draws all its actions, so none of them is right or wrong. But its own steps tell, by the equations of the
lesson, from which Gaussians it should have drawn them. A program whose actions lie elsewhere has other equations.
"""

import math
from collections import Counter
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym_course.grading.curves import Race, compare_with_ours
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.programs import (
    NAME,
    POLICY,
    Environment,
    Policy,
    Step,
    require_reproducible,
    run_program,
)
from edugym_course.grading.replay import TRIAL
from edugym_course.grading.student_code import student_code
from edugym_course.grading.surprises import NATS, SIGMAS
from edugym_course.lessons.continuous_actions.exercises.boxes import (
    BOXES,
    LARGEST,
    POLICY_RATE,
    SMALLEST,
    WIDTH,
    Boxes,
    FarPays,
    Gaussians,
    returns_from,
    returns_until,
    score_of_log,
    score_of_mean,
)

N_STEPS, WORLDS, FAR_STEPS = 6_000, 2, 2_000


Maker = Callable[[int], Gaussians]

MISTAKES: dict[str, Maker] = {
    "the reward of a step stands in the place of the return G, which sums up all rewards from it to the end": partial(
        Gaussians, returns=lambda rewards, _: rewards
    ),
    "the return sums up the rewards up to a step, and it should be those from it to the end": partial(
        Gaussians, returns=returns_until
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
    "there is no baseline: δ = G − V(S), and V is learned too": partial(Gaussians, value_rate=0.0),
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
    "σ is not kept between 0.2 and 2": partial(Gaussians, bounds=(1e-9, 1e9)),
    "ln σ is kept between 0.2 and 2, and it is σ that should be; ln σ lies between ln 0.2 and ln 2": partial(
        Gaussians, bounds=(math.exp(SMALLEST), math.exp(LARGEST))
    ),
    "all states have the same μ and σ, and each should have its own": partial(Gaussians, shared="μσ"),
    "all states have the same μ: is the index of the state missing where μ changes?": partial(Gaussians, shared="μ"),
    "σ is 0.5 at first, and it should be 1": partial(Gaussians, first=0.5),
    "ln σ is 1 at first, and it should be 0: then σ is 1": partial(Gaussians, first=math.e),
    "V hardly learns: α^w is 0.1 in the text, and not α^θ": partial(Gaussians, value_rate=POLICY_RATE),
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
    "the standard deviation of the actions is σ² and not σ: NumPy's rng.normal(μ, σ) takes σ itself": partial(
        Gaussians, power=2.0
    ),
    "the actions are drawn with the standard deviation 1, and it should be the σ that is learned": partial(
        Gaussians, power=0.0
    ),
    "the policy learns from G less the V that has just moved: compute δ before you change V": partial(
        Gaussians, fresh=True
    ),
    "the learning rate of the policy is too large: it is 0.005 in the text": partial(
        Gaussians, policy_rate=5 * POLICY_RATE
    ),
    "the learning rate of the policy is too small: it is 0.005 in the text": partial(
        Gaussians, policy_rate=POLICY_RATE / 5
    ),
}
"""The usual mistakes, by their sentences."""
FOLLOWERS = [partial(Gaussians, value_rate=0.0, policy_rate=share * POLICY_RATE) for share in (0.5, 0.1)]
"""Without a baseline the Gaussians follow the actions, whoever draws them; what a mistake explains must be more."""
KEPT = [partial(Gaussians, keeps=True, backwards=backwards) for backwards in (False, True)]
"""They learn from all episodes so far again and again. The order matters, since states come twice in such a list."""
REPEATED = 0.01
"""The share of the steps in which one and the same action is no chance."""
BEFORE = 1_000
"""So many steps come before most μ that fly away; after that the last digits decide where to."""
EARLY = 300
"""After so many steps a list that is never emptied is found; a program that has one soon needs minutes."""


class Fit(NamedTuple):
    """How well the Gaussians of a learner fit the actions of a program.

    Attributes:
        n_steps: the number of actions.
        far: how many σ they lie from μ, as the root of the mean square.
        apart: how far their (a − μ)/σ are from standard normal, as the Kolmogorov-Smirnov distance times √n.
        log: the logarithm of the density of all of them.
    """

    n_steps: int
    far: float
    apart: float
    log: float

    @property
    def is_usual(self) -> bool:
        """Whether the actions can have been drawn from these Gaussians; if they were, it says no once in 10 000."""
        return self.apart < 2.3 and abs(self.far - 1) < SIGMAS / math.sqrt(2 * self.n_steps)


def fit(runs: Sequence[Sequence[Step]], make: Maker) -> Fit:
    """Let a learner learn from the steps of runs, each from the beginning; compare its Gaussians with the actions."""
    z, log = [], 0.0
    for steps in runs:
        learner, episode = make(BOXES * WIDTH), list[Step]()
        for step in steps:
            mean, spread = learner.gaussian(step.state)
            z.append((step.action - mean) / spread)
            log -= 0.5 * z[-1] * z[-1] + math.log(spread)
            episode.append(step)
            if step.terminated or step.truncated:
                learner.learn(episode)
                episode = episode if learner.keeps else []
    n, below = len(z), [0.5 + 0.5 * math.erf(one / math.sqrt(2)) for one in sorted(z)]
    apart = max(abs(share - (k + 0.5) / n) for k, share in enumerate(below)) * math.sqrt(n)
    return Fit(n, math.hypot(*z) / math.sqrt(n), apart, -math.inf if math.isnan(log) else log)


def check_equations(program: Any, seed: int) -> None:
    """Check that a program draws its actions from the Gaussians that its own steps give.

    If it does, a mistake fits them better by k nats with a probability below e⁻ᵏ.

    Raises:
        WrongAnswer: it does not; or the program breaks the contract.
    """
    seeds = range(WORLDS * seed, WORLDS * (seed + 1))
    require_reproducible(program, partial(Boxes, seeds[0], truncates=True), TRIAL, seed)
    early = [run_program(program, Boxes(number, truncates=True), EARLY, number).steps for number in seeds]
    others = max(fit(early, make).log for make in (Gaussians, *MISTAKES.values()))
    if max(fit(early, make).log for make in KEPT) > others + NATS:
        raise WrongAnswer(
            f"the actions of {NAME} are those of a program that learns from all earlier episodes again at the end of"
            " each: empty the lists of the episode when it has learned from them"
        )
    done = [run_program(program, Boxes(number, truncates=True), N_STEPS, number) for number in seeds]
    _require_means(done[0].policy)
    often, times = Counter(step.action for step in done[0].steps).most_common(1)[0]
    if times > REPEATED * N_STEPS:
        raise WrongAnswer(
            f"in {times} of {N_STEPS} steps the action of {NAME} is exactly {often:g}: give the environment what is"
            " drawn, and do not cut it off"
        )
    runs = [run.steps for run in done]
    right = fit(runs, Gaussians)
    likely, is_better = _likeliest(runs, right)
    if right.is_usual and not is_better:
        return
    if not is_better or not _explains(likely, runs):
        runs = [steps[:BEFORE] for steps in runs]
        likely, is_better = _likeliest(runs, fit(runs, Gaussians))
    if is_better and _explains(likely, runs):
        cause = f"They fit a usual mistake: {likely}"
    else:
        cause = (
            "Compare the rates, γ and the first values with those of the text, and the updates with their equations,"
            " term by term; does it learn in all states, from all steps of an episode, and from each once?"
        )
    raise WrongAnswer(
        f"the actions of {NAME} should lie one σ from μ (the root of the mean square), with the μ and the σ that its"
        f" own steps give by the equations of this lesson, and they lie {right.far:.3g} σ from it. {cause}"
    )


def check_bound(program: Any, seed: int) -> None:
    """Check that σ stops at its upper bound: over the boxes it never comes there.

    Raises:
        WrongAnswer: it does not.
    """
    runs = [run_program(program, FarPays(), FAR_STEPS, number).steps for number in range(2 * seed, 2 * seed + 2)]
    right = fit(runs, Gaussians)
    if not right.is_usual:
        raise WrongAnswer(
            f"where the farthest actions pay most, so that σ grows to {LARGEST:g}, the actions of {NAME} should lie one"
            f" σ from μ (the root of the mean square), and they lie {right.far:.3g} σ from it: after each step keep σ"
            f" between {SMALLEST:g} and {LARGEST:g}"
        )


def _likeliest(runs: Sequence[Sequence[Step]], right: Fit) -> tuple[str, bool]:
    """Return the mistake that makes the actions most probable, and whether the right equations make them less so."""
    logs = {sentence: fit(runs, make).log for sentence, make in MISTAKES.items()}
    likely = max(logs, key=lambda sentence: logs[sentence])
    return likely, logs[likely] > right.log + NATS


def _explains(likely: str, runs: Sequence[Sequence[Step]]) -> bool:
    """Whether the actions can be those of a mistake, and of none that only follows them."""
    found, followed = fit(runs, MISTAKES[likely]), max(fit(runs, make).log for make in FOLLOWERS)
    return found.is_usual and found.log > followed + NATS


def _require_means(policy: Policy) -> None:
    """Refuse a policy that draws its actions."""
    for state in range(BOXES * WIDTH):
        with student_code(POLICY):
            one, other = policy(state), policy(state)
        if not np.array_equal(one, other):
            raise WrongAnswer(
                f"{POLICY} draws its actions: asked twice about state {state}, it gives two of"
                " them. It should return the mean μ of the state"
            )


def reinforce(environment: Environment, n_steps: int, seed: int, make: Maker = Gaussians) -> Policy:
    """Our program, or one that makes a mistake."""
    assert isinstance(environment.observation_space, spaces.Discrete)
    learner, rng = make(int(environment.observation_space.n)), np.random.default_rng(seed)
    state, episode = environment.reset(seed=seed)[0], list[Step]()
    for _ in range(n_steps):
        action = float(rng.normal(*learner.gaussian(state)))
        next_state, pays, terminated, truncated, _ = environment.step(action)
        episode.append(Step(state, action, float(pays), next_state, terminated, truncated))
        state = next_state
        if terminated or truncated:
            learner.learn(episode)
            state, episode = environment.reset()[0], []
    return lambda state: float(learner.mean[state])


ARM = Race(partial(Boxes, 0), N_STEPS, reinforce, episodes=20)


def project_7(answer: Any, seed: int) -> str:
    """Check a program with REINFORCE and a learned spread."""
    check_equations(answer, seed)
    check_bound(answer, seed)
    return f"Right: its Gaussians are those of its steps. {compare_with_ours(answer, ARM, seed)}"
