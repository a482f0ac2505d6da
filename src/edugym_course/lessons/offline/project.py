"""The project of lesson 16: learn from nights that are given, from a blank file."""

from functools import cache
from typing import Any, NamedTuple

import numpy as np

from edugym.agents.dataset import collect
from edugym.mdp.protocol import Integers
from edugym_course.grading.agents import require_function
from edugym_course.grading.errors import WrongAnswer, nobody_asks_why
from edugym_course.grading.programs import NAME, Policy, actions_of, require_policy
from edugym_course.grading.student_code import student_code
from edugym_course.lessons.offline.methods import PESSIMISTIC, best_of, clock, learn, morning
from edugym_course.lessons.offline.riddles import RIDDLES, log_book
from edugym_course.lessons.offline.sweeps import Step

TASK = morning(length=10, ring=6.0, late=30.0)
"""Longer and dearer than that of the lesson."""
N_NIGHTS, SHARE, PENALTY = 80, 0.25, 2.0
"""So few nights of so bad a clock that neither imitating it nor first values of 0 will do."""
SEEDS = 5
MANY = 5
"""Who misses so many of the riddles is asked about simpler things, too."""
BASICS = (
    "look at what is simple first: the index of each count and value, whether every step is used, and what the policy"
    " returns"
)
OUR_SEEDS = range(100, 140)
LOW, SLACK = 0.1, 0.5
"""The middle run must reach this quantile of our returns, less the slack: ours hardly ever misses it."""


class Run(NamedTuple):
    """What came of a program.

    Attributes:
        kept: the exact return of its policy.
        gathered: the mean return in the data.
        actions: shape (S,): the action in each state, by the rows of the model.
    """

    kept: float
    gathered: float
    actions: Integers


def run(program: Any, seed: int) -> Run:
    """Let a program learn from nights, and evaluate its policy exactly.

    The numbers of the states are dealt out anew for each seed: nobody can write down a policy beforehand.

    Raises:
        WrongAnswer: it breaks the contract, raises an error or does not end.
    """
    model, rng = TASK.model, np.random.default_rng([seed, 1])
    n_states, n_actions, _ = model.successors.shape
    dataset = collect(model, clock(TASK, SHARE), N_NIGHTS, seed=seed)
    number_of = rng.permutation(n_states)
    columns = number_of[dataset.states], dataset.actions, dataset.rewards, number_of[dataset.next_states]
    steps = [*zip(*(column.tolist() for column in (*columns, dataset.terminated)), strict=True)]
    policy = _policy_of(program, steps, n_states, n_actions, seed)
    actions, rows = np.zeros(n_states, int), np.flatnonzero(~model.terminal)
    actions[rows] = actions_of(policy, number_of[rows].tolist(), n_actions)
    return Run(TASK.worth(np.eye(n_actions)[actions]), float(dataset.returns().mean()), actions)


def _policy_of(program: Any, steps: list[Step], n_states: int, n_actions: int, seed: int) -> Policy:
    """Return the policy that a program learns from steps."""
    call = f"{NAME}(steps, {n_states}, {n_actions}, {seed})"
    with student_code(call):
        policy: Policy = program(steps, n_states, n_actions, seed)
    require_policy(call, policy)
    return policy


def unsolved(program: Any, seed: int) -> str:
    """Return what a program does in the first riddle that it does not solve, and why another action is better.

    If it misses many, their number follows. It is "" if the program solves them all.
    """
    missed = list[str]()
    for number, riddle in enumerate(RIDDLES):
        book = log_book(riddle, np.random.default_rng([seed, 2, number]))
        policy = _policy_of(program, book.steps, book.n_states, riddle.n_actions, seed)
        action, _ = actions_of(policy, [book.first, book.never], riddle.n_actions)
        if action != riddle.right:
            missed.append(
                f"{riddle.shows}, and in the first state the program takes action {action} instead of {riddle.right}:"
                f" {riddle.asks}"
            )
    if len(missed) < MANY:
        return missed[0] if missed else ""
    stop = "" if missed[0].endswith(("?", ")")) else "."
    return f"{missed[0]}{stop} (It misses {len(missed)} of {len(RIDDLES)} such log-books, so {BASICS})"


@cache
def our_returns() -> tuple[float, ...]:
    """Return the exact returns of our policies, by pessimistic fitted Q."""
    data = (collect(TASK.model, clock(TASK, SHARE), N_NIGHTS, seed=seed) for seed in OUR_SEEDS)
    return tuple(TASK.worth(learn(one, PESSIMISTIC, TASK, PENALTY).greedy_policy()) for one in data)


def project_16(answer: Any, seed: int) -> str:
    """Check a program that learns from nights alone: what its policy is worth."""
    require_function(NAME, answer, "steps, n_states, n_actions and seed")
    found = [run(answer, SEEDS * seed + number) for number in range(SEEDS)]
    ours, middle = our_returns(), sorted(found, key=lambda one: one.kept)[SEEDS // 2]
    told = f"the middle one of {SEEDS} runs makes a clock worth {middle.kept:.1f}"
    lowest = float(np.quantile(ours, LOW)) - SLACK
    if not middle.kept >= lowest:
        why = "" if nobody_asks_why() else f": {_why(answer, middle, seed)}"
        raise WrongAnswer(f"{told}, and it should be worth {lowest:.1f} or more (ours {np.median(ours):.1f}){why}")
    if missed := unsolved(answer, seed):
        raise WrongAnswer(f"{told}, which is enough (ours {np.median(ours):.1f}). But in another log-book {missed}")
    gathered, best = middle.gathered, TASK.worth(best_of(TASK))
    return f"Right: {told} (ours {np.median(ours):.1f}); the data {gathered:.1f}, the best clock {best:.1f}."


def _why(program: Any, one: Run, seed: int) -> str:
    """Return what a policy that is worth too little looks like, or the riddle that its program does not solve."""
    if len({*one.actions[~TASK.model.terminal].tolist()}) == 1:
        return (
            "it chooses the same action in every state, as it does where all values of a state are equal; does nothing"
            " follow where `terminated` is True (else all values sink), do they change from sweep to sweep, are they"
            " looked up in the state to which they belong, and is the best action taken?"
        )
    if one.kept < one.gathered:
        return (
            "that is worse than the clock that collected the nights; does it take the *best* action, by its own state,"
            " and is no sign wrong?"
        )
    missed = unsolved(program, seed)
    return f"it has learned, but too little{f'. In a log-book of our making {missed}' if missed else ''}"
