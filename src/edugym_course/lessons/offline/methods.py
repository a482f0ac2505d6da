"""What lesson 16 does: nights are collected, and other clocks are judged by them or learned from them."""

import threading
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from edugym.adapters.registration import make_mdp
from edugym.agents.dataset import Dataset, collect
from edugym.agents.fitted_q import FittedValues, fitted_q_evaluation, fitted_q_iteration, pessimistic_q_iteration
from edugym.agents.off_policy_evaluation import Estimate, doubly_robust, importance_sampling
from edugym.exact.model import finite_model
from edugym.exact.policy_evaluation import policy_evaluation
from edugym.exact.tables import FiniteModel
from edugym.exact.value_iteration import value_iteration
from edugym.mdp.protocol import Reals
from edugym_course.lessons.own_problem.morning import Morning

N_NIGHTS = 300
SHARE = 0.97
"""How often a good clock does what is best; else it presses a button at random."""
PENALTY = 1.0
REPETITIONS = 100
AS_IT_IS, UNSEEN_IS_WORST, PESSIMISTIC = "as it is", "unseen is worst", "pessimistic"
RULES = (AS_IT_IS, UNSEEN_IS_WORST, PESSIMISTIC)
ORDINARY, WEIGHTED, PER_DECISION, ROBUST = "ordinary", "weighted", "per decision", "doubly robust"
ESTIMATORS = (ORDINARY, WEIGHTED, PER_DECISION, ROBUST)


@dataclass(frozen=True, eq=False)
class Task:
    """Where nights (episodes) come from. Each is only equal to itself, so that its model is worked out once.

    Attributes:
        mdp: the task.
        lowest: a return that no episode is below.
        discount: γ.
        horizon: the step limit of an episode; None where it ends by itself.
    """

    mdp: Any
    lowest: float
    discount: float = 1.0
    horizon: int | None = None

    @property
    def model(self) -> FiniteModel:
        """The exact model."""
        return _model_of(self)

    def worth(self, policy: Reals) -> float:
        """The exact return of a policy."""
        return policy_evaluation(self.model, policy, self.discount, horizon=self.horizon).start


@cache
def _model_of(task: Task) -> FiniteModel:
    return finite_model(task.mdp)


def morning(**parameters: Any) -> Task:
    """A morning: at worst the clock rings at every step, and she oversleeps."""
    mdp = Morning(**parameters)
    return Task(mdp, -mdp.ring * mdp.length - mdp.late)


MORNING = morning()
BOULDER = Task(make_mdp("Boulder"), 0.0, 0.99, 100)
ROADRUNNER = Task(make_mdp("Roadrunner"), -150.0, 0.99, 50)
"""At worst it falls after 50 steps, each of which costs 1."""


@cache
def best_of(task: Task) -> Reals:
    """The optimal policy of a task."""
    return value_iteration(task.model, task.discount).greedy_policy()


def clock(task: Task, share: float) -> Reals:
    """The policy of a clock that does what is best in this share of its steps, and else presses a button at random."""
    best = best_of(task)
    return share * best + (1 - share) / best.shape[1]


def learn(dataset: Dataset, rule: str, task: Task, penalty: float = PENALTY) -> FittedValues:
    """The values that a rule learns from a dataset."""
    if rule == AS_IT_IS:
        return fitted_q_iteration(dataset, task.discount)
    return pessimistic_q_iteration(dataset, penalty if rule == PESSIMISTIC else 0.0, task.lowest, task.discount)


class Learned(NamedTuple):
    """What was learned from datasets, by rule and run.

    Attributes:
        promised: the return that the learned values promise, by rule; shape (runs,) each.
        kept: the exact return of the greedy policy, likewise.
        gathered: the mean return in the data; shape (runs,).
        best: the best return that there is.
    """

    promised: Mapping[str, Reals]
    kept: Mapping[str, Reals]
    gathered: Reals
    best: float

    def too_much(self, rule: str) -> Reals:
        """How much more a rule promises than its policy keeps, by run."""
        return self.promised[rule] - self.kept[rule]


def learned(
    task: Task = MORNING,
    share: float = SHARE,
    n_nights: int = N_NIGHTS,
    *,
    penalty: float = PENALTY,
    rules: Sequence[str] = RULES,
    repetitions: int = REPETITIONS,
    seed: int = 0,
    stop: threading.Event | None = None,
) -> Learned:
    """Collect nights of a clock, and learn from them by each rule, over repetitions."""
    rows = []
    for number in seeds(seed, repetitions, stop):
        dataset = collect(task.model, clock(task, share), n_nights, seed=number)
        found = [learn(dataset, rule, task, penalty) for rule in rules]
        kept = [task.worth(values.greedy_policy()) for values in found]
        rows.append([dataset.returns(task.discount).mean(), *(values.start for values in found), *kept])
    gathered, *numbers = np.array(rows).reshape(-1, 1 + 2 * len(rules)).T
    promised = dict(zip(rules, numbers[: len(rules)], strict=True))
    kept_by_rule = dict(zip(rules, numbers[len(rules) :], strict=True))
    return Learned(promised, kept_by_rule, gathered, task.worth(best_of(task)))


def imitated(
    task: Task = MORNING,
    share: float = SHARE,
    n_nights: int = N_NIGHTS,
    *,
    repetitions: int = REPETITIONS,
    seed: int = 0,
    stop: threading.Event | None = None,
) -> Reals:
    """The exact return of the policy that takes the most frequent action of the data, over repetitions."""
    kept = []
    for number in seeds(seed, repetitions, stop):
        visits = collect(task.model, clock(task, share), n_nights, seed=number).visits
        kept.append(task.worth(np.eye(visits.shape[1])[visits.argmax(axis=1)]))
    return np.array(kept)


def seeds(seed: int, repetitions: int, stop: threading.Event | None = None) -> Iterator[int]:
    """A seed for each repetition, until somebody stops."""
    for child in np.random.SeedSequence(seed).spawn(repetitions):
        if stop is not None and stop.is_set():
            return
        yield int(child.generate_state(1)[0])


def estimate(dataset: Dataset, policy: Reals, method: str, task: Task) -> Estimate:
    """What a policy is worth, as an estimator says."""
    if method == ROBUST:
        Q = fitted_q_evaluation(dataset, policy, task.discount).Q
        return doubly_robust(dataset, policy, Q, task.discount)
    return importance_sampling(dataset, policy, task.discount, method=method)


class Judged(NamedTuple):
    """What estimators say of a policy that did not act, by estimator and run.

    Attributes:
        values: by estimator, shape (runs,).
        effective: how many nights of the policy itself the data are worth, by run.
        gathered: the mean return in the data, by run.
        exact: what the policy is really worth.
    """

    values: Mapping[str, Reals]
    effective: Reals
    gathered: Reals
    exact: float

    def errors(self, method: str) -> Reals:
        """How far an estimator is off, by run."""
        far: Reals = np.abs(self.values[method] - self.exact)
        return far


def judged(
    task: Task = MORNING,
    share: float = 0.5,
    n_nights: int = 1000,
    *,
    methods: Sequence[str] = ESTIMATORS,
    repetitions: int = REPETITIONS,
    seed: int = 0,
    stop: threading.Event | None = None,
) -> Judged:
    """Let a clock collect nights, and judge the best clock by them, over repetitions."""
    best, rows = best_of(task), []
    for number in seeds(seed, repetitions, stop):
        dataset = collect(task.model, clock(task, share), n_nights, seed=number)
        found = [estimate(dataset, best, method, task) for method in methods]
        gathered = dataset.returns(task.discount).mean()
        rows.append([gathered, found[0].effective_episodes, *(one.value for one in found)])
    gathered, effective, *values = np.array(rows).reshape(-1, 2 + len(methods)).T
    return Judged(dict(zip(methods, values, strict=True)), effective, gathered, task.worth(best))
