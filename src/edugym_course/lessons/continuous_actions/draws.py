"""Whether the actions of a program are drawn from the Gaussians that its steps give by the equations of lesson 7."""

import math
from collections import Counter
from collections.abc import Callable, Sequence
from functools import partial
from typing import NamedTuple

from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.programs import NAME, Step, begins
from edugym_course.grading.surprises import SIGMAS
from edugym_course.lessons.continuous_actions.exercises.boxes import BOXES, WIDTH, Gaussians

REPEATED = 3
"""So often one and the same action may come: drawn numbers never do."""

Maker = Callable[[int], Gaussians]
WRONG_SPREADS: dict[str, Maker] = {
    "the standard deviation of the actions is σ² and not σ: NumPy's rng.normal(μ, σ) takes σ itself": partial(
        Gaussians, power=2.0
    ),
    "the actions are drawn with the standard deviation 1, and it should be the σ that is learned": partial(
        Gaussians, power=0.0
    ),
}
"""Those that give the same, from actions with another standard deviation."""


class Fit(NamedTuple):
    """How well the Gaussians of a learner fit the actions of a program.

    Attributes:
        n_steps: the number of actions.
        far: how many σ they lie from μ, as the root of the mean square.
        apart: how far their (a − μ)/σ are from standard normal, as the Kolmogorov-Smirnov distance times √n.
        farthest: how many σ the farthest action lies from μ.
        aside: the mean of (a − μ)/σ, times √n.
        linked: the mean product of (a − μ)/σ in two steps of an episode that follow each other, times √n.
        log: the logarithm of the density of all of them.
    """

    n_steps: int
    far: float
    apart: float
    farthest: float
    aside: float
    linked: float
    log: float

    @property
    def is_usual(self) -> bool:
        """Whether the actions can have been drawn from these Gaussians; if they were, it says no once in 10 000."""
        return self.apart < 2.3 and self.is_one_away

    @property
    def is_one_away(self) -> bool:
        """Whether the actions lie one σ from μ."""
        return abs(self.far - 1) < SIGMAS / math.sqrt(2 * self.n_steps)

    @property
    def is_cut(self) -> bool:
        """Whether the farthest actions are missing: so near are the farthest of drawn ones once in 10 000."""
        return math.erf(self.farthest / math.sqrt(2)) ** self.n_steps < 1e-4


def follow(steps: Sequence[Step], make: Maker) -> tuple[Gaussians, list[tuple[float, float]]]:
    """Let a learner learn from the steps of a run; return it, and how far each action lies from its μ, with its σ."""
    learner, episode, far = make(BOXES * WIDTH), list[Step](), list[tuple[float, float]]()
    for step, first in zip(steps, begins(steps), strict=True):
        if first:
            state = episode[-1].next_state if learner.stale and far else step.state
            episode = episode if learner.keeps else []
        known = step._replace(state=state) if first else step
        mean, spread = learner.gaussian(known.state)
        far.append((step.action - mean, spread))
        episode.append(known._replace(state=step.next_state) if learner.after else known)
        if step.terminated or step.truncated:
            learner.learn(episode)
    if learner.to_the_end and not (step.terminated or step.truncated):
        learner.learn(episode)
    return learner, far


def fit(runs: Sequence[Sequence[Step]], make: Maker) -> Fit:
    """Compare the Gaussians of a learner that learns from the steps of runs with their actions."""
    pairs = [pair for steps in runs for pair in follow(steps, make)[1]]
    z = [off / spread for off, spread in pairs]
    log = -sum(0.5 * (off / spread) ** 2 + math.log(spread) for off, spread in pairs)
    n, below = len(z), [0.5 + 0.5 * math.erf(one / math.sqrt(2)) for one in sorted(z)]
    apart = max(abs(share - (k + 0.5) / n) for k, share in enumerate(below)) * math.sqrt(n)
    is_first = [first for steps in runs for first in begins(steps)]
    products = [one * before for one, before, first in zip(z[1:], z, is_first[1:], strict=False) if not first]
    linked = sum(products) / math.sqrt(max(1, len(products)))
    return Fit(n, math.hypot(*z) / math.sqrt(n), apart, max(map(abs, z)), sum(z) / math.sqrt(n), linked, log)


def require_drawn(runs: Sequence[Sequence[Step]]) -> None:
    """Refuse actions that cannot have been drawn, since one and the same comes again and again."""
    for steps in runs:
        often, times = Counter(step.action for step in steps).most_common(1)[0]
        if times > REPEATED:
            raise WrongAnswer(
                f"in {times} of {len(steps)} steps the action of {NAME} is exactly {often:g}: give the environment what"
                " is drawn, not cut off and not rounded; and draw anew at each step, from one generator that is made"
                " before the first"
            )


def require_gaussian(runs: Sequence[Sequence[Step]]) -> None:
    """Refuse actions that are not drawn from the Gaussians of a program that has the right μ.

    Raises:
        WrongAnswer: it names the likely cause.
    """
    found = fit(runs, Gaussians)
    is_centred = max(abs(found.aside), abs(found.linked)) < SIGMAS
    if not (found.is_usual and is_centred):
        likely = next((sentence for sentence, make in WRONG_SPREADS.items() if fit(runs, make).is_usual), None)
        cause = (
            f"They fit a usual mistake: {likely}"
            if likely and not found.is_usual
            else "Draw each action by rng.normal(μ, σ), anew in each step, with the μ and the σ that its state has now"
        )
        raise WrongAnswer(
            f"{NAME} has the right μ, so (A - μ)/σ, with the μ and the σ that its own steps give by the equations of"
            f" this lesson, should be standard normal. In {found.n_steps} steps its mean is"
            f" {found.aside / math.sqrt(found.n_steps):+.2f}, the root of its mean square {found.far:.2f}, and two in a"
            f" row have the mean product {found.linked / math.sqrt(found.n_steps):+.2f}. {cause}"
        )
    if found.is_cut:
        raise WrongAnswer(
            f"{NAME} has the right μ and σ, but none of its {found.n_steps} actions is farther than"
            f" {found.farthest:.3g} σ from μ: give the environment what is drawn, and do not cut it off"
        )
