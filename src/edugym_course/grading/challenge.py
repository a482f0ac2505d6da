"""An open challenge: an agent of the student's own, on tasks that belong to a name, against baselines."""

import copy
import hashlib
import math
import unicodedata
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np

from edugym.adapters.registration import make_mdp
from edugym.checks.contract import learner
from edugym.checks.interfaces import MADE
from edugym.checks.parameters import a_number, a_text, in_short, number_of_steps, one_of, whole_number
from edugym.experiments.repeat import MOST_REPETITIONS, repeat
from edugym.experiments.results.statistics import Interval, paired_difference
from edugym.experiments.results.tables import Results
from edugym.mdp.task import task_of
from edugym.training.train import train
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.student_code import student_code
from edugym_course.grading.time_limit import LIMIT
from edugym_course.grading.values import given

YOURS = "your agent"
FIRST_STEPS = 200
"""The training steps that are tried before all tasks are begun, which takes threads that cannot be stopped."""


def seed_from_name(name: str | int) -> int:
    """Return a seed that belongs to a name or a student number: the same on every machine, from 0 to 2^32 - 1.

    Capital letters and spaces make no difference.

    Raises:
        ValueError: the name is empty, or neither a text nor a whole number.
    """
    if isinstance(name, bool | np.bool_) or not isinstance(name, str | int | np.integer):
        raise ValueError(f'name must be a text such as "Ada", or a whole number, but is {in_short(name)}')
    plain = "".join(unicodedata.normalize("NFKC", str(name)).casefold().split())
    if not plain:
        raise ValueError(f"name must have one letter or more, but is {name!r}")
    return int.from_bytes(hashlib.sha256(plain.encode()).digest()[:4], "big")


class Sizes(NamedTuple):
    """All that an agent is told of a task: it finds out about the rest by its own steps.

    Attributes:
        observation_space: what it may observe.
        action_space: what it may do.
    """

    observation_space: Any
    action_space: Any

    def __getattr__(self, name: str) -> Any:
        """Say what there is instead."""
        if name in dir(np.ndarray):
            raise AttributeError(f"the task stands where an array should, which has {name!r}: is `.create` missing?")
        raise AttributeError(
            f"the agent is told `observation_space` and `action_space` only, not {name!r}: it has to find out the rest"
        )


@dataclass(frozen=True)
class Score:
    """How an agent did in a challenge.

    Attributes:
        name: whose tasks it was tried on.
        points: 0 to 100: the average return over training in percent of the best possible one, averaged over the tasks.
            Where returns are negative, the best possible return in percent of the agent's.
        rows: by label, the mean return at the end and the average return over training.
        ahead: how much the average return of the agent is above that of the best baseline, paired by task.
        best_baseline: the label of that baseline.
        results: the learning curves.
    """

    name: str
    points: float
    rows: Mapping[str, tuple[float, float]]
    ahead: Interval
    best_baseline: str
    results: Results

    def __repr__(self) -> str:
        """Return a table, and the points."""
        width = max(map(len, self.rows))
        lines = [f"{'':{width}}  return at the end  average while learning"]
        lines += [f"{label:{width}}  {end:17.2f}  {average:22.2f}" for label, (end, average) in self.rows.items()]
        return "\n".join([*lines, "", self._comparison()])

    def _repr_markdown_(self) -> str:
        rows = "\n".join(f"| {label} | {end:.2f} | {average:.2f} |" for label, (end, average) in self.rows.items())
        return f"| | return at the end | average while learning |\n|---|---:|---:|\n{rows}\n\n{self._comparison()}"

    def _comparison(self) -> str:
        low, high = self.ahead.low, self.ahead.high
        where = "ahead of" if low > 0 else "behind" if high < 0 else "not clearly apart from"
        return (
            f"{self.name}: {self.points:.0f} of 100 points, {where} {self.best_baseline} "
            f"(difference {self.ahead.estimate:+.2f}, 95 % interval {low:+.2f} to {high:+.2f})."
        )


@dataclass(frozen=True)
class Challenge:
    """A task for an agent of the student's own.

    Attributes:
        environment: the name of the environment, an MDP, or a function that makes a task from a `layout_seed`. If there
            is such a parameter, every name has its layouts.
        parameters: its other parameters, if it is given by name.
        n_steps: the training steps.
        baselines: by label, functions that make the agents to beat.
        optimum: the highest return of an episode, by planning on the exact model.
        best_average: the highest average return over training: that of an explorer which takes no avoidable step.
        repetitions: on how many tasks agents are tried; each has a layout of its own.
        column: which returns count: "return" (of evaluation episodes, without exploring) or "training_return" (of all
            training episodes, so that exploring costs).
        best_label: the label of `optimum` and `best_average` in the table.
    """

    environment: Any
    parameters: Mapping[str, Any]
    n_steps: int
    baselines: Mapping[str, Callable[..., Any]]
    optimum: float
    best_average: float
    repetitions: int = 10
    column: str = "return"
    best_label: str = "possible"

    def __post_init__(self) -> None:
        """Refuse an attribute that is not as above."""
        makes = isinstance(self.environment, str) or hasattr(self.environment, "transition")
        if isinstance(self.environment, type) or not (makes or callable(self.environment)):
            given = in_short(self.environment)
            raise ValueError(f"environment must be a name, an MDP or a function of layout_seed, but is {given}")
        for name in ("parameters", "baselines"):
            if not isinstance(getattr(self, name), Mapping):
                raise ValueError(f"{name} must be a dictionary, but is {in_short(getattr(self, name))}")
        number_of_steps("n_steps", self.n_steps)
        a_number("optimum", self.optimum)
        a_number("best_average", self.best_average)
        whole_number("repetitions", self.repetitions, 1, MOST_REPETITIONS)
        one_of("column", self.column, ["return", "training_return"])
        a_text("best_label", self.best_label)

    def score(self, agent: Any, name: str | int) -> Score:
        """Train an agent, and the baselines, on the tasks that belong to a name.

        Args:
            agent: a function that makes the agent. It is called with an object that has `observation_space` and
                `action_space` and nothing else: what the task is like, the agent has to find out.
            name: the student's name or number, from which the layouts come (`seed_from_name`).

        Raises:
            ValueError: the name is empty, or neither a text nor a whole number.
            WrongAnswer: the agent cannot be trained; the message says why.
        """
        seed = seed_from_name(name)
        mdp = self._task(seed)
        sizes = Sizes(mdp.observation_space, mdp.action_space)
        maker = self._maker(agent, sizes)
        with student_code("training your agent", limit=LIMIT):  # what never ends is found here, where it can be stopped
            train(mdp, copy.deepcopy(maker(mdp)), FIRST_STEPS, evaluate_every=FIRST_STEPS)
        with student_code("training your agent", limit=math.inf):
            results = repeat(
                self.environment,
                {YOURS: maker, **{label: _sees_sizes(make, sizes) for label, make in self.baselines.items()}},
                self.n_steps,
                repetitions=self.repetitions,
                seed=seed,
                parameters=self.parameters if isinstance(self.environment, str) else None,
            )
        averages = {label: float(results.average(label, self.column).mean()) for label in results.methods}
        best_baseline = max(self.baselines, key=lambda label: averages[label])
        rows = {label: (float(results.final(label).mean()), averages[label]) for label in results.methods}
        possible = {self.best_label: (self.optimum, self.best_average)}
        return Score(
            str(name),
            self._points(averages[YOURS]),
            MappingProxyType(possible | rows),
            paired_difference(results.average(YOURS, self.column), results.average(best_baseline, self.column)),
            best_baseline,
            results,
        )

    def _task(self, layout_seed: int) -> Any:
        """Return the MDP of one of the tasks."""
        if isinstance(self.environment, str):
            return make_mdp(self.environment, **self.parameters)
        if hasattr(self.environment, "transition"):
            return self.environment
        made = self.environment(layout_seed)
        task_of(made, "the environment that the function makes", MADE)
        return made

    def _points(self, average: float) -> float:
        """Return 0 to 100 points for an average return, or 0 if no episode ended (NaN)."""
        share = average / self.best_average if self.best_average > 0 else self.best_average / min(average, -1e-9)
        return 100.0 * min(share, 1.0) if share > 0 else 0.0

    def _maker(self, agent: Any, sizes: Sizes) -> Callable[[Any], Any]:
        """Refuse what makes no agent."""
        given("your agent", agent)
        if isinstance(agent, type):
            hint = f"such as {agent.__name__}.create" if hasattr(agent, "create") else "that makes one"
            raise WrongAnswer(f"your agent should be a function, {hint}, but is the class {agent.__name__}")
        if not callable(agent) and not hasattr(agent, "act"):
            raise WrongAnswer(f"your agent should be a function that makes an agent, but is {in_short(agent)}")
        if hasattr(agent, "act"):
            raise WrongAnswer(
                "your agent should be a function that makes a new agent, so that no run knows what another has learned,"
                f" but is a {type(agent).__name__}: write `lambda task: ...`"
            )
        with student_code("making your agent"):
            made = agent(sizes)
        given("my_agent(...)", made)
        try:
            learner(made)
        except ValueError as error:
            raise WrongAnswer(str(error)) from None
        return _sees_sizes(agent, sizes)


def _sees_sizes(make: Callable[[Any], Any], sizes: Sizes) -> Callable[[Any], Any]:
    """Return a function that makes an agent without a look at the task."""
    return lambda _: make(sizes)
