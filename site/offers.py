"""What a race is: a task at several strengths, and agents that see it in one way or another; races.py has them."""

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any, NamedTuple

import edugym
from edugym.adapters.fitting import tabular

NONE: Mapping[str, Any] = MappingProxyType({})


def as_it_is(mdp: Any) -> Any:
    """The MDP as it is."""
    return mdp


class View(NamedTuple):
    """How an agent sees a task.

    Attributes:
        of: from the MDP, the MDP as the agent sees it.
        code: the same as Python, for the reader.
        clean: where an agent has no row for a place (see sights.py), from the MDP, what it would see without noise.
    """

    of: Callable[[Any], Any] = as_it_is
    code: str = ""
    clean: Callable[[Any], Any] | None = None

    def seen(self, mdp: Any) -> Any:
        """The MDP as the agent sees it; a table's rows are numbered."""
        return self.of(mdp) if self.clean else tabular(self.of(mdp))

    def places(self, mdp: Any) -> Any:
        """The MDP observed as a place in the picture."""
        return mdp if self.clean else self.of(mdp)


class Agent(NamedTuple):
    """An agent that is offered.

    Attributes:
        label: its name on the page.
        says: what it does, in a few words.
        kind: its class.
        settings: what is not at its default.
        view: how it sees the task.
    """

    label: str
    says: str
    kind: Any
    settings: Mapping[str, Any]
    view: View = View()

    def make(self, task: Any) -> Any:
        """The agent, for the task as it sees it."""
        return self.kind.create(task, **self.settings)

    @property
    def takes(self) -> tuple[str, ...]:
        """Which of the page's sliders set this agent.

        R-max plans from settings of its own, Adam's learning rate has another scale, and whole returns no discount.
        """
        if self.kind is edugym.RMax:
            return ()
        given = {**self.kind._field_defaults, **self.settings}
        explores = isinstance(given.get("exploration"), edugym.EpsilonGreedy)
        known = {
            "learning_rate": "learning_rate" in given and self.kind is not edugym.DQN,
            "discount": "discount" in given and not given.get("whole_returns"),
            "epsilon": explores,
        }
        return tuple(name for name, takes in known.items() if takes)


class Strength(NamedTuple):
    """The one parameter that sets how hard a task is.

    Attributes:
        parameter: its name.
        values: from which the reader chooses.
        first: the index of the value that is shown first.
    """

    parameter: str
    values: tuple[float, ...]
    first: int


class Trial(NamedTuple):
    """Where a reader changes the code: a task in which a change soon shows.

    The unchanged agent learns it within the race, neither at once nor hardly at all.

    Attributes:
        strength: the index of the strength.
        steps: the training steps.
        several: how many seeds race.
    """

    strength: int
    steps: int
    several: int


class Measure(NamedTuple):
    """How agents are compared where that is not by the reward from which they learn.

    They train as in `edugym.objectives.train_vectors`.

    Attributes:
        of: from the task, the task in which agents are evaluated, and which people play.
        says: what the number is, as a caption.
        code: the same number, from the `VectorRun` that a reader has as `run`.
    """

    of: Callable[[Any], Any]
    says: str
    code: str


class Race(NamedTuple):
    """A task, and the agents that race in it.

    Attributes:
        environment: its name.
        question: what the reader bets on.
        rules: the task, in a sentence or two.
        agents: the first three race when the page opens.
        n_steps: the training steps of a race.
        strength: how hard it is.
        trial: what is shown first where a reader changes the code.
        numbers: what the numbers of an observation are; empty where they need no names.
        keys: the keys for the actions, besides 1, 2, ...
        parameters: the other parameters of the environment.
        is_finite: whether it has few states, so that its optimum can be computed exactly.
        actions: what actions are called, where the task itself only has numbers for them.
        outcomes: what a player reads after a step that led on, and after one that did not, if that is not plain.
        measure: how agents are compared, if not by the reward from which they learn.
        episodes: the evaluation episodes of each point of a curve.
        seeds: how many race at first: several where one seed may answer the question otherwise than many.
        answer: what is behind the result, for somebody who has not read the lesson.
    """

    environment: str
    question: str
    rules: str
    agents: tuple[Agent, ...]
    n_steps: int
    strength: Strength
    trial: Trial
    numbers: tuple[str, ...]
    keys: tuple[str, ...] = ()
    parameters: Mapping[str, Any] = NONE
    is_finite: bool = True
    actions: tuple[str, ...] = ()
    outcomes: tuple[str, ...] = ()
    measure: Measure | None = None
    episodes: int = 5
    seeds: int = 1
    answer: str = ""

    def mdp(self, k: int) -> Any:
        """The task at its k-th strength."""
        strength = {self.strength.parameter: self.strength.values[k]}
        return edugym.make_mdp(self.environment, **strength, **self.parameters)

    def measured(self, mdp: Any) -> Any:
        """The task in which agents are evaluated, and which people play."""
        return self.measure.of(mdp) if self.measure else mdp
