"""What a program learned from a teacher's answers, told by its policy: the right rewards, or those of a mistake."""

from collections.abc import Callable, Sequence

import numpy as np

from edugym.agents.preferences import fit_rewards
from edugym.exact.regularised import with_rewards
from edugym.exact.value_iteration import value_iteration
from edugym.mdp.protocol import Integers, Reals
from edugym_course.lessons.own_problem.morning import Morning, State
from edugym_course.lessons.preferences.methods import PRIOR, model_of

Step = tuple[State, int, State]
Comparison = tuple[Sequence[Step], Sequence[Step], bool]
"""Two nights, and whether the first was preferred."""

ALIKE, CLEARLY = 0.75, 0.12
"""The share of the steps whose states get the action of a mistake, at least, and how much more that must be than with
the right rewards. A right program shares 0.9 of its actions with these; three programs with a mistake shared 0.93, 0.91
and 0.85 with their own, and 0.55 to 0.65 with the right ones."""


class Replay:
    """The actions that follow from some comparisons, in each state, by the right method or a wrong one.

    Attributes:
        visits: shape (S,): how often the nights were in each state.
    """

    def __init__(self, mdp: Morning, comparisons: Sequence[Comparison]) -> None:
        """Count the steps of the nights, and learn the rewards."""
        self._model, self._comparisons = model_of(mdp), comparisons
        self._shape = self._model.successors.shape[:2]
        self._answers = np.array([answer for *_, answer in comparisons])
        first, second = self._counted(lambda step: step[:2])
        self.visits = (first + second).sum(axis=(0, 2))
        self._rewards = fit_rewards(first, second, self._answers, prior=PRIOR)

    def _counted(self, pair: Callable[[Step], tuple[State, int]]) -> tuple[Reals, Reals]:
        """Return how often each night has each pair of a state and an action, for the first and the second nights."""
        first, second = np.zeros((2, len(self._answers), *self._shape))
        for number, (one, other, _) in enumerate(self._comparisons):
            for counts, night in ((first, one), (second, other)):
                for step in night:
                    state, action = pair(step)
                    counts[number, self._model.rows[state], action] += 1
        return first, second

    def _fitted(self, pair: Callable[[Step], tuple[State, int]]) -> Reals:
        """Return the rewards that explain the answers, if each step counts for this state and action."""
        return fit_rewards(*self._counted(pair), self._answers, prior=PRIOR)

    def _best(self, rewards: Reals) -> Integers:
        """Return the actions that are best for some rewards."""
        policy = value_iteration(with_rewards(self._model, rewards)).greedy_policy()
        actions: Integers = policy.argmax(axis=1)
        return actions

    def right(self) -> Integers:
        """Rewards that explain the answers."""
        return self._best(self._rewards)

    def greedy(self) -> Integers:
        """The largest of these rewards, without a look at what follows."""
        actions: Integers = self._rewards.argmax(axis=1)
        return actions

    def after(self) -> Integers:
        """Rewards of the states to which the steps lead, looked up where they begin."""
        return self._best(self._fitted(lambda step: (step[2], step[1])))

    def without_action(self) -> Integers:
        """Rewards that are the same for all actions."""
        return self._best(np.repeat(self._fitted(lambda step: (step[0], 0))[:, :1], self._shape[1], axis=1))

    def without_time(self) -> Integers:
        """Rewards that are the same at all times."""
        fitted = self._fitted(lambda step: ((1, step[0][1]), step[1]))
        return self._best(np.array([fitted[self._model.rows[1, depth]] for _, depth in self._model.states]))

    def summed(self) -> Integers:
        """Rewards that explain the answers by the sum of both nights."""
        first, second = self._counted(lambda step: step[:2])
        return self._best(fit_rewards(first + second, 0 * second, self._answers, prior=PRIOR))

    def opposite(self) -> Integers:
        """Rewards that explain the opposite of the answers."""
        return self._best(-self._rewards)


MISTAKES: dict[str, Callable[[Replay], Integers]] = {
    "the policy takes the action with the largest reward, and it should be that with the largest value, which counts"
    " what comes later, too (or the target of these values lacks that of the next observation)": Replay.greedy,
    "a reward is learned for the observation to which a step leads, and looked up for the one from which it comes: take"
    " the same one in both places": Replay.after,
    "a reward does not hang on the action: each time, depth *and* action has its own": Replay.without_action,
    "a reward does not hang on the time: each *time*, depth and action has its own": Replay.without_time,
    "the counts of both nights are added, and those of the second should be taken from those of the first": (
        Replay.summed
    ),
    "the night that was *not* preferred gains: where the first one was preferred, y is 1, and w grows by α (y - p)"
    " times its counts less those of the second": Replay.opposite,
}
"""The usual mistakes, by their sentences."""


def likely_mistake(mdp: Morning, runs: Sequence[tuple[Sequence[Comparison], Integers]]) -> str:
    """Return the sentence of the mistake that explains best what some policies do, or "".

    Args:
        mdp: the morning.
        runs: of each, the comparisons, and the action in each state of the model.
    """
    replays = [Replay(mdp, comparisons) for comparisons, _ in runs]

    def agreement(method: Callable[[Replay], Integers]) -> float:
        """Return the share of the steps in whose states the policies take the actions of a method."""
        return float(
            np.mean(
                [
                    np.average(method(replay) == actions, weights=replay.visits)
                    for replay, (_, actions) in zip(replays, runs, strict=True)
                ]
            )
        )

    found = {sentence: agreement(method) for sentence, method in MISTAKES.items()}
    sentence = max(found, key=lambda one: found[one])
    is_clear = found[sentence] > max(ALIKE, agreement(Replay.right) + CLEARLY)
    return sentence if is_clear else ""
