"""The method that a program from a blank file should have, and the usual mistakes, each an agent that makes it."""

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from edugym.checks.contract import learns_from
from edugym.mdp.protocol import Random, Reals
from edugym_course.grading.programs import Step, learn_from
from edugym_course.grading.surprises import NATS, UNEXPLAINED

LOW = (
    "low values are preferred to high ones: is there an `argmin`, or a minus sign too many, or does the value of one"
    " action stand in the place of another?"
)

BEYOND = (
    "the value of a state after the end is looked up; a terminal state has no future, so its target is the reward alone"
)

Maker = Callable[[tuple[int, int]], Any]
"""Makes an agent for the shape of a table."""


class Learner(NamedTuple):
    """A method, or a mistake.

    Attributes:
        make: makes an agent, for the shape of a table. Its values are in its table `Q`, or it has a method
            `values(state)`.
        alter: what it takes a step for, after what it took the step before for (None at the first).
        skips: from which steps it does not learn.
        swaps: whether it takes a random action with probability 1 − ε.
        stale: whether it learns about the state that follows in place of the one in which the action was taken.
        restarts: whether it takes the first state of the next episode for the one that a truncated step led to.
        nats: of a mistake, how much more probable it must make the actions than the right equation, as a logarithm;
            more for one that a right program resembles.
        leaves: of a mistake, the share of the surprises above those by ε that it may leave; more for one that hangs on
            what the steps do not show.
    """

    make: Maker
    alter: Callable[[Step, Step | None], Step] = lambda step, before: step
    skips: Callable[[Step], bool] = lambda step: False
    swaps: bool = False
    stale: bool = False
    restarts: bool = False
    nats: float = NATS
    leaves: float = UNEXPLAINED


def _goes_on(step: Step, before: Step | None) -> Step:
    return step._replace(terminated=False, truncated=step.terminated or step.truncated)


def _ends(step: Step, before: Step | None) -> Step:
    return step._replace(terminated=step.terminated or step.truncated)


def _swapped(step: Step, before: Step | None) -> Step:
    return step._replace(terminated=step.truncated, truncated=step.terminated)


def old_start(step: Step, before: Step | None) -> Step:
    """Take the last state of an episode for the first one of the next."""
    return step._replace(state=before.next_state) if before and (before.terminated or before.truncated) else step


def _last_left(step: Step, before: Step | None) -> Step:
    return step._replace(state=before.state) if before and (before.terminated or before.truncated) else step


def stays(step: Step, before: Step | None) -> Step:
    """Take the first state of an episode for all of its states."""
    return step if before is None or before.terminated or before.truncated else step._replace(state=before.state)


def _costs(step: Step, before: Step | None) -> Step:
    return step._replace(reward=-step.reward)


def mistakes_of_loops(make: Maker, on_policy: bool = False, remembers: bool = False) -> dict[str, Learner]:
    """Return the mistakes that any loop can have, by their sentences.

    Args:
        make: makes the right agent.
        on_policy: whether it learns from the next action. What such a program learns at an end hangs on an action
            that is never taken, so these mistakes are left out; a project may name its own.
        remembers: whether it learns from windows. One that goes on into the next episode is like none that was met.
    """
    beyond_an_end = {
        BEYOND: Learner(make, _goes_on),
        "a truncated episode is learned as a terminated one: somebody stopped the clock, and the next state still has"
        " its value": Learner(make, _ends),
        "`terminated` and `truncated` have changed places: step returns state, reward, terminated, truncated, info": (
            Learner(make, _swapped)
        ),
        "nothing is learned from the last step of an episode: where `terminated` is True, the target is R": Learner(
            make, skips=lambda step: step.terminated
        ),
        "nothing is learned from a step that is truncated: it is a step like the others": Learner(
            make, skips=lambda step: step.truncated
        ),
    }
    if not remembers:
        sentence = "S' is the state after the reset where an episode was truncated: learn first, and reset then"
        beyond_an_end[sentence] = Learner(make, restarts=True)
    return ({} if on_policy else beyond_an_end) | {
        "what is learned at the end of an episode is left out, and that is where the reward often is: learn first, and"
        " look then whether the episode is over": Learner(make, skips=lambda step: step.terminated or step.truncated),
        "after an end the program goes on from the last state of the old episode: state, info = environment.reset()"
        " gives the first state of the new one": Learner(make, old_start),
        "after an end the program goes on from the state that it left last: state, info = environment.reset() gives the"
        " first state of the new episode": Learner(make, _last_left),
        "the state stays the first one of the episode: is `state = next_state` missing?": Learner(make, stays),
        LOW: Learner(make, _costs),
    }


def too_early(make: Maker) -> dict[str, Learner]:
    """Return the mistake of a loop that goes on to the next state before it learns, by its sentence."""
    sentence = "`state = next_state` comes before the update, which then moves a value of S' in place of one of S"
    return {sentence: Learner(make, stale=True)}


class AtTheEnd:
    """An agent that learns from the steps of an episode when it is over."""

    def __init__(self, make: Maker, shape: tuple[int, int]) -> None:
        """Make the agent."""
        self._agent = make(shape)
        self._names, self._steps = learns_from(self._agent), list[Step]()

    @property
    def Q(self) -> Reals:
        """Its table."""
        table: Reals = self._agent.Q
        return table

    def act(self, state: Any, rng: Random) -> int:
        """Choose an action by ε-greedy."""
        return int(self._agent.act(state, rng))

    def learn(self, state: Any, action: int, reward: float, next_state: Any, terminated: bool, truncated: bool) -> None:
        """Note the step."""
        self._steps.append(Step(state, action, reward, next_state, terminated, truncated))
        if terminated or truncated:
            for step in self._steps:
                learn_from(self._agent, self._names, step, step.action)
            self._steps.clear()


class OfTheLastReset:
    """An agent that looks the next state up in a copy of its table, which is made when an episode begins."""

    def __init__(self, make: Maker, shape: tuple[int, int]) -> None:
        """Make the agent; the second half of its table is the copy."""
        self._n_states, n_actions = shape
        self._agent = make((2 * self._n_states, n_actions))
        self._names = learns_from(self._agent)

    @property
    def Q(self) -> Reals:
        """Its table, without the copy."""
        table: Reals = self._agent.Q[: self._n_states]
        return table

    def act(self, state: int, rng: Random) -> int:
        """Choose an action by ε-greedy."""
        return int(self._agent.act(state, rng))

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool, truncated: bool) -> None:
        """Learn from the step and the copy, and copy the table at the end of an episode."""
        step = Step(state, action, reward, self._n_states + next_state, terminated, truncated)
        learn_from(self._agent, self._names, step, action)
        if terminated or truncated:
            self._agent.Q[self._n_states :] = self.Q


def too_late(make: Maker) -> dict[str, Maker]:
    """Return the mistakes that show only where a state comes twice in an episode, by their sentences."""
    return {
        "max_a Q(S', a) is that of the last reset. Read it from the table as it is now, and learn from each step at"
        " once": partial(OfTheLastReset, make),
        "nothing is learned before the episode is over, or the actions are chosen by a copy of the table from its"
        " beginning. Learn from each step at once, and choose by the table as it is now": partial(AtTheEnd, make),
    }


def other_settings(make: Callable[..., Any], **settings: tuple[str, float, Sequence[float]]) -> dict[str, Learner]:
    """Return agents that take other numbers than those of the text, by their sentences.

    Args:
        make: makes the right agent, for the shape of a table and with these settings.
        settings: for each, its symbol, the right number, and others that are told at every seed tried: numbers of other
            lessons, and more and less.
    """
    return {
        f"{symbol} is about {other:g}, and it should be {right:g}": Learner(partial(make, **{name: other}))
        for name, (symbol, right, others) in settings.items()
        for other in others
    }


class _WholeNumbers(np.ndarray[Any, Any]):
    """An array whose entries lose what is behind the decimal point, as those of dtype int do."""

    def __setitem__(self, where: Any, value: Any) -> None:
        """Write what is before the decimal point."""
        super().__setitem__(where, np.trunc(value))


def other_tables(make: Maker, values: Sequence[float] = (1.0, 10.0)) -> dict[str, Learner]:
    """Return agents whose table `Q` does not begin at 0, or holds whole numbers, by their sentences."""

    def begun(value: float, shape: tuple[int, int]) -> Any:
        agent = make(shape)
        agent.Q[...] = value
        return agent

    def cut_off(shape: tuple[int, int]) -> Any:
        agent = make(shape)
        return agent._replace(Q=agent.Q.view(_WholeNumbers))

    return {f"the first values are about {value:g}, and not 0": Learner(partial(begun, value)) for value in values} | {
        "what is behind the decimal point is lost: the table holds whole numbers, as one with dtype=int does": Learner(
            cut_off
        )
    }
