"""The project of lesson 14: learn from a teacher's comparisons alone, from a blank file."""

from collections import Counter
from collections.abc import Sequence
from functools import cache
from typing import Any, NamedTuple

import gymnasium
import numpy as np

from edugym.adapters.gymnasium_env import MDPEnv
from edugym.agents.preferences import preference
from edugym.checks.parameters import in_short
from edugym.exact.policy_evaluation import policy_evaluation
from edugym.exact.regularised import with_rewards
from edugym.mdp.protocol import Integers, Random
from edugym_course.grading.agents import require_function
from edugym_course.grading.errors import WrongAnswer, nobody_asks_why
from edugym_course.grading.programs import NAME, actions_of, require_policy
from edugym_course.grading.repeats import require_repeats
from edugym_course.grading.student_code import student_code
from edugym_course.lessons.own_problem.morning import Morning, State
from edugym_course.lessons.preferences.methods import NOISE, PRIOR, learned_rewards, model_of, tuned
from edugym_course.lessons.preferences.replay import Comparison, Step, likely_mistake
from edugym_course.lessons.preferences.teachers import (
    AT_ONCE,
    DOZERS,
    FEWEST_PATIENT,
    PARTS,
    PATIENT_SEEDS,
    SETTLED,
    TASK,
)

N_ACTIONS, FEW_KINDS, MANY_SEEDS = 3, 0.1, 10
"""The buttons; the share of the compared nights, at most, of which hardly any two differ; and how many resets with one
seed are too many."""
N_COMPARISONS = 300
FEWEST = 20
SEEDS, OTHER_SEEDS = 5, 3
"""Runs with the teacher of the text, and with each who wants something else."""
OUR_SEEDS = range(100, 140)
LOW, SLACK = 0.1, 0.5
"""The middle run must reach this quantile of our returns, less the slack: ours hardly ever misses it."""
ALMOST = 0.6
"""A clock that finds what is paid at once in one of two kinds of nights gets a half of it. In 12 runs each, eight right
programs got all of it."""
NIGHT = "a list of (observation, action, next_observation), one for each step"


class Silent(gymnasium.Wrapper[Any, Any, Any, Any]):
    """An environment whose rewards are always 0, and whose `info` is empty: what is meant only the teacher knows.

    Where a night may begin in several ways, no two in a row begin alike, whatever the seeds are. A night that is begun
    and not played does not count: a right program may reset twice.

    Attributes:
        seeds: how often reset was given each seed.
    """

    def __init__(self, environment: gymnasium.Env[Any, Any], n_starts: int) -> None:
        """Count the seeds that reset is given; a night may begin in so many ways."""
        super().__init__(environment)
        self.seeds = Counter[int]()
        self._n_starts = n_starts
        self._begun: tuple[Any, ...] | None = None
        self._played: tuple[Any, ...] | None = None

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Any, dict[str, Any]]:
        """Begin a night."""
        begun = self.env.reset(seed=seed, options=options)  # it refuses what is no seed
        if seed is not None:
            self.seeds[seed] += 1
        while self._n_starts > 1 and tuple(begun[0]) == self._played:
            begun = self.env.reset()
        self._begun = tuple(begun[0])
        return begun

    def step(self, action: Any) -> tuple[Any, float, bool, bool, dict[str, Any]]:
        """Take a step, and pay nothing."""
        self._played = self._begun
        observation, _, terminated, truncated, _ = self.env.step(action)
        return observation, 0.0, terminated, truncated, {}

    @property
    def unwrapped(self) -> Any:
        """This environment itself: what is below it would give the reward away."""
        return self


class Teacher:
    """Compares nights, so many times, with the noise of the lesson.

    Attributes:
        asked: how often she was asked.
        compared: the nights that she compared, in pairs, and her answers.
        slip: the sentence of the first thing that she refused, "" if there is none.
    """

    def __init__(self, mdp: Morning, most: int, rng: Random) -> None:
        """Know what is meant."""
        self._mdp, self._most, self._rng = mdp, most, rng
        self.asked, self.slip = 0, ""
        self.compared = list[Comparison]()

    def __call__(self, first: Any, second: Any) -> bool:
        """Whether the first night is preferred to the second.

        Raises:
            WrongAnswer: one of them is no night, or she was asked too often.
        """
        if self.asked == self._most:
            self._refuse(f"compare may be called {self._most} times, and this is one time more")
        (first_steps, first_return), (second_steps, second_return) = (self._judged(one) for one in (first, second))
        if first is second:
            self._refuse(
                "compare is given one list twice, of which neither is better: play two nights, and make a new list for"
                " each"
            )
        self.asked += 1
        answer = bool(self._rng.random() < preference(first_return, second_return, NOISE))
        self.compared.append((first_steps, second_steps, answer))
        return answer

    def _judged(self, night: Any) -> tuple[list[Step], float]:
        """Return the steps of a night, and what it is worth to her."""
        if not isinstance(night, list | tuple) or not all(
            isinstance(one, list | tuple) and len(one) == 3 for one in night
        ):
            self._refuse(f"compare takes two nights, each {NIGHT}, but one of them is {in_short(night)}")
        steps = [self._step(one) for one in night]
        rows, ways = model_of(self._mdp).rows, model_of(self._mdp).p
        starts = starts_of(self._mdp)
        state, total = steps[0][0] if steps and steps[0][0] in starts else starts[0], 0.0
        for before, action, after in steps:
            if before != state:
                self._refuse(
                    f"a night has a step from {before} where the one before it ended in {state}: give all the steps of"
                    " one episode, in their order, with `next_observation` last"
                )
            if after not in rows or not ways[rows[before], action, rows[after]]:
                self._refuse(
                    f"no night has a step from {before} to {after} after action {action}: give steps that were taken"
                )
            total += self._mdp.reward(before, action, after, self._rng)
            state = after
        if len(steps) != self._mdp.length:
            self._refuse(f"a night has {self._mdp.length} steps, from reset to the end, but one given has {len(steps)}")
        return steps, total

    def _step(self, step: Any) -> Step:
        """A step of a night, with whole numbers."""
        try:
            (time, depth), action, (next_time, next_depth) = step
            return (int(time), int(depth)), int(action), (int(next_time), int(next_depth))
        except (TypeError, ValueError):
            self._refuse(
                f"a step of a night is (observation, action, next_observation), but one given is {in_short(step)}"
            )
            raise

    def _refuse(self, sentence: str) -> None:
        """Refuse what was given, and remember it: a program may catch the error."""
        self.slip = self.slip or sentence
        raise WrongAnswer(sentence)


class Judged(NamedTuple):
    """What came of a program.

    Attributes:
        meant: the exact return of its policy, as it is meant.
        actions: shape (S,): the action in each state.
        asked: how often it asked the teacher.
        compared: the nights that she compared, in pairs, and her answers.
        same_seed: how often it gave reset one and the same seed.
    """

    meant: float
    actions: Integers
    asked: int
    compared: list[Comparison]
    same_seed: int

    @property
    def nights(self) -> list[tuple[int, ...]]:
        """The actions of the nights that were compared."""
        return [tuple(action for _, action, _ in night) for *pair, _ in self.compared for night in pair]


def starts_of(mdp: Any) -> list[State]:
    """The states in which a night may begin."""
    model = model_of(mdp)
    return [model.states[row] for row in np.flatnonzero(model.initial)]


def judged(program: Any, seed: int, mdp: Any = TASK) -> Judged:
    """Run a program with a seed, and evaluate its policy exactly, as the teacher of an MDP means it.

    Raises:
        WrongAnswer: it breaks the contract, raises an error or does not end.
    """
    call = f"{NAME}(environment, compare, {N_COMPARISONS}, {seed})"
    morning = MDPEnv(mdp)
    morning.reset(seed=1_000_003 + seed)
    environment = Silent(morning, len(starts_of(mdp)))
    teacher = Teacher(mdp, N_COMPARISONS, np.random.default_rng([seed, 1]))
    with student_code(call):
        policy = program(environment, teacher, N_COMPARISONS, seed)
    if teacher.slip:  # the program caught it, and went on
        raise WrongAnswer(teacher.slip)
    require_policy(call, policy, "observation")
    model = model_of(mdp)
    actions = np.zeros(len(model.states), int)
    rows = np.flatnonzero(~model.terminal)
    actions[rows] = actions_of(policy, [np.array(model.states[row]) for row in rows], 3, "observation")
    meant = policy_evaluation(model, actions).start
    same_seed = max(environment.seeds.values(), default=0)
    return Judged(meant, actions, teacher.asked, teacher.compared, same_seed)


@cache
def our_returns() -> tuple[float, ...]:
    """Return the meant returns of our policies: planning on rewards that were learned from random nights."""
    model = model_of(TASK)
    returns = []
    for seed in OUR_SEEDS:
        rewards = learned_rewards(TASK, N_COMPARISONS, NOISE, PRIOR, np.random.default_rng(seed), at_random=True)
        learned = with_rewards(model, rewards)
        reference = np.full_like(rewards, 1 / 3)
        returns.append(policy_evaluation(model, tuned(learned, reference, 0.0)).start)
    return tuple(returns)


def project_14(answer: Any, seed: int) -> str:
    """Check a program that learns from comparisons: what its policy is worth, as it is meant."""
    require_function(NAME, answer, "environment, compare, n_comparisons and seed")
    found = [judged(answer, SEEDS * seed + number) for number in range(SEEDS)]
    if (asked := min(one.asked for one in found)) < FEWEST:
        raise WrongAnswer(f"{NAME} calls compare(first, second) {asked} times, and nothing else says what is wanted")
    _require_fair_nights(found[0])
    require_repeats(found[0].nights, judged(answer, SEEDS * seed).nights, None, SEEDS * seed)  # it need not draw nights
    ours, middle = our_returns(), sorted(found, key=lambda one: one.meant)[SEEDS // 2]
    told = f"the middle one of {SEEDS} runs makes a clock worth {middle.meant:.1f}"
    lowest = float(np.quantile(ours, LOW)) - SLACK
    if not middle.meant >= lowest:
        why = "" if nobody_asks_why() else f": {symptom(middle, found)}"
        raise WrongAnswer(f"{told}, and it should be worth {lowest:.1f} or more (ours {np.median(ours):.1f}){why}")
    _check_other_wishes(answer, seed)
    _check_first_step(answer, seed)
    _check_patience(answer, seed)
    return f"Right: {told} (ours {np.median(ours):.1f}); random buttons {_random():.1f}, the best clock {_best():.1f}."


def _require_fair_nights(run: Judged) -> None:
    """Refuse a program whose nights leave out a button, or have the same luck again and again.

    Raises:
        WrongAnswer: it is so.
    """
    if never := {*range(N_ACTIONS)} - {action for night in run.nights for action in night}:
        raise WrongAnswer(
            f"action {min(never)} is never taken in the nights that {NAME} compares: draw a random button among all of"
            " them"
        )
    if run.same_seed > MANY_SEEDS:
        raise WrongAnswer(
            f"{NAME} gives reset the same seed {run.same_seed} times, and each time the same luck begins: give it to"
            " the first reset alone"
        )


def _check_other_wishes(answer: Any, seed: int) -> None:
    """Check that a program learns what other teachers want, who tell it by their answers alone.

    Raises:
        WrongAnswer: its middle run is too close to random buttons for one of them.
    """
    for wish, who, fewest, why in (DOZERS[seed % len(DOZERS)], *PARTS):
        found = [judged(answer, SEEDS * seed + number, wish).meant for number in range(OTHER_SEEDS)]
        middle, least, most = sorted(found)[OTHER_SEEDS // 2], _random(wish), _best(wish)
        if middle < (lowest := least + fewest * (most - least)):
            raise WrongAnswer(
                f"With a teacher who {who}, the middle one of {OTHER_SEEDS} runs makes a clock worth {middle:.1f} to"
                f" her, and it should be worth {lowest:.1f} or more (random buttons {least:.1f}, the best clock"
                f" {most:.1f}){'' if nobody_asks_why() else f': {why}'}"
            )


def _check_patience(answer: Any, seed: int) -> None:
    """Check that a program counts what comes late in full, and by the best action.

    Raises:
        WrongAnswer: most of its clocks take what is paid at once.
    """
    found = [judged(answer, PATIENT_SEEDS * seed + number, SETTLED).meant for number in range(PATIENT_SEEDS)]
    if (patient := sum(meant > SETTLED.soon for meant in found)) < FEWEST_PATIENT:
        raise WrongAnswer(
            f"Another sleeper stays as she is after the first step. The teacher pays {SETTLED.soon:g} for a ring then,"
            f" or {SETTLED.late:g} for silence in the last step, if she is still asleep. Her answers tell so, and yet"
            f" only {patient} of {PATIENT_SEEDS} clocks wait for it: what comes late counts in full, without a"
            " discount; the value of a state is that of its *best* action, not a mean; rewards are learned by y - p, in"
            " many passes, and a step may be worth another thing with each time, depth *and* action; and Q-learning"
            " needs many nights, with random buttons in them"
        )


def _check_first_step(answer: Any, seed: int) -> None:
    """Check that a program learns from the first step of a night, and from both nights of a pair.

    Raises:
        WrongAnswer: most of its clocks do not take what is paid there in each night.
    """
    found = [judged(answer, OTHER_SEEDS * seed + number, AT_ONCE).meant for number in range(OTHER_SEEDS)]
    if (taken := sum(meant > ALMOST * AT_ONCE.soon for meant in found)) <= OTHER_SEEDS // 2:
        raise WrongAnswer(
            f"One sleeper begins a night asleep or awake, and wakes and falls asleep again in turns, whatever is"
            f" done. The teacher pays {AT_ONCE.soon:g} in the first step, for a chime if she is asleep, and for a ring"
            f" if she is awake, and takes {AT_ONCE.later:g} for the same later. Only {taken} of {OTHER_SEEDS} clocks do"
            " both, and not again: each *time*, depth and action has its own reward, in the first step of *both* nights"
            " too (are the counts of the second night taken from those of the first?), and it belongs where it is"
            " looked up later: by the depth from which the step comes in both places, or by the one to which it leads"
        )


def symptom(run: Judged, runs: Sequence[Judged]) -> str:
    """Return what a policy that is worth too little looks like, and the likely cause; the run is one of some."""
    if len({*run.nights}) < FEW_KINDS * len(run.nights):
        return (
            f"in the {len(run.nights)} nights that you compare only {len({*run.nights})} different rows of actions are"
            " taken: make rng once, before the first night, and draw anew in each step"
        )
    model = model_of(TASK)
    actions = run.actions[~model.terminal]
    mistake = likely_mistake(TASK, [(one.compared, one.actions) for one in runs])
    if mistake and actions.any():  # where nothing is learned, it is the first action
        return f"its actions are mostly those of a usual mistake: {mistake}"
    if len({*actions.tolist()}) == 1:
        return (
            f"it chooses action {actions[0]} in every state: does Q-learning use *your* rewards (those of step are"
            " always 0), are they other than 0 and looked up in the state and the action where they belong, and does"
            " each step begin where the last one ended?"
        )
    by_depth = {(state[1], int(run.actions[row])) for row, state in enumerate(model.states) if not model.terminal[row]}
    if len(by_depth) == len({depth for depth, _ in by_depth}):
        return "it does the same at every time: a state is the time *and* the depth, in the values and in the policy"
    if run.meant < _random() - 2:
        return (
            "that is worse than random buttons: does the *preferred* night gain, so that w grows by α (y - p), and not"
            " by α (p - y), and is the *best* action taken? (Or are few of the comparisons learned from?)"
        )
    if run.meant < _random() + 4:
        return (
            "that is hardly better than random buttons; do the rewards change with every comparison, and does the"
            " policy use them?"
        )
    if run.asked < N_COMPARISONS:
        return f"it asks {run.asked} of {N_COMPARISONS} comparisons; ask them all"
    return (
        "it has learned something; does every step of both nights count, as often as it was taken, with its time, depth"
        " and action, are there enough passes over the comparisons, and enough nights with random actions in them to"
        " learn the policy? Has its target the largest value of the *next* state, without a discount, and in the last"
        " step the reward alone? Does it go on from the next observation, is α large enough, and does the policy take"
        " the best action by these values, and not by the rewards?"
    )


@cache
def _random(mdp: Any = TASK) -> float:
    """The return of random buttons."""
    model = model_of(mdp)
    return policy_evaluation(model, np.full(model.successors.shape[:2], 1 / 3)).start


@cache
def _best(mdp: Any = TASK) -> float:
    """The best return."""
    model = model_of(mdp)
    return policy_evaluation(model, tuned(model, np.zeros(0), 0.0)).start
