"""The project of lesson 14: learn from a teacher's comparisons alone, from a blank file."""

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
from edugym.mdp.wrapper import wrapper
from edugym_course.grading.agents import require_function
from edugym_course.grading.errors import WrongAnswer, nobody_asks_why
from edugym_course.grading.programs import NAME, actions_of, require_policy
from edugym_course.grading.student_code import student_code
from edugym_course.lessons.own_problem.morning import ASLEEP, AWAKE, CHIME, QUIET, RING, Morning, State
from edugym_course.lessons.preferences.methods import NOISE, PRIOR, learned_rewards, model_of, tuned

TASK = Morning(length=10, ring=6.0, late=30.0)
"""Longer and dearer than that of the lesson: here a clock that does nothing is worth no more than random buttons."""


@wrapper
class Wish(NamedTuple):
    """The same nights for somebody who wants something else.

    Attributes:
        mdp: the morning.
        depths: what each depth of sleep is worth to her, at every step.
        costs: what each action costs her.
    """

    mdp: Any
    depths: tuple[float, float, float]
    costs: tuple[float, float, float]

    def reward(self, state: State, action: int, next_state: State, rng: Random) -> float:
        """The depth of sleep, less the cost of the action."""
        return self.depths[next_state[1]] - self.costs[action]


@wrapper
class Settled(NamedTuple):
    """A sleeper who stays as she is after the first step, and a teacher who pays for a ring then, or for sleep at last.

    A chime wakes her in one night of two, and is not paid: if only a ring woke her, it could share its reward with all
    the steps in which she is awake, and then a discount would take most of that, too.

    Attributes:
        mdp: the morning.
        soon: what she pays for a ring in the first step, which wakes her.
        late: what she pays for silence in the last step, if the sleeper is still asleep.
    """

    mdp: Any
    soon: float = 8.0
    late: float = 11.0

    def transition(self, state: State, action: int, rng: Random) -> State:
        """A ring wakes her in the first step, a chime perhaps, and nothing changes her sleep after it."""
        time, depth = state
        if time > 0:
            return time + 1, depth
        return 1, AWAKE if action == RING or (action == CHIME and rng.random() < 0.5) else ASLEEP

    def reward(self, state: State, action: int, next_state: State, rng: Random) -> float:
        """Pay at once, or in the end."""
        if state[0] == 0:
            return self.soon if action == RING else 0.0
        return self.late if next_state == (TASK.length, ASLEEP) and action == QUIET else 0.0


class Other(NamedTuple):
    """Another teacher, to whom only a part of what can be had is nothing.

    Attributes:
        wish: the morning, as she means it.
        who: what she likes, for the sentence.
        fewest: of the way from random buttons to the best clock, the share that the middle run must go.
        why: which part of the method it takes.
    """

    wish: Wish
    who: str
    fewest: float
    why: str


_ONLY_HERS = (
    "only her answers tell what is wanted: nothing that *you* know of good nights may be in the program, and time,"
    " depth and action may each change what a step is worth"
)
DOZERS = (
    Other(Wish(TASK, (0.0, 3.0, 0.0), (0.0, 0.5, 1.0)), "likes to doze", 0.4, _ONLY_HERS),
    Other(Wish(TASK, (0.0, 3.0, -1.0), (0.5, 2.0, 0.0)), "likes to doze", 0.4, _ONLY_HERS),
)
"""A clock that was written by hand for the teacher of the text is worth little to them; each check asks one of them."""
PARTS = (
    Other(
        Wish(TASK, (0.0, -6.0, 3.0), (0.0, 0.0, 4.0)),
        "hates to doze",
        0.65,
        "after deep sleep comes dozing in most random nights, so a step must not get the credit of its night. Is it the"
        " error y - p that is learned from, with p by the rewards as they are then, and in many passes? (Or are too few"
        " comparisons asked, has each night the same luck, or is the depth left out?)",
    ),
    Other(
        Wish(TASK, (-6.0, 0.0, 8.0), (8.0, 0.0, 0.0)),
        "pays for silence at once, and is paid for it later",
        0.65,
        "is all that follows a step counted, in full and by the best action, with 0 after the end?",
    ),
)
"""Wishes that mislead whoever leaves out a part. Of 18 right programs (tables of other kinds, planning, Q-learning,
policy gradients, rounds, more and less of a prior) the middle run goes 0.8 of the way or more. Without p, or with its
sign wrong, it goes 0.5 with the first; with γ = 0.5, it goes 0.34 with the second."""
SETTLED, PATIENT_SEEDS, FEWEST_PATIENT = Settled(TASK), 8, 7
"""Eight right programs choose sleep in 245 of 245 runs, and one with too few nights of Q-learning in 10 of 15; two with
γ = 0.9 in 2 of 55, two with γ = 0.95 in 31 of 55, and one with a mean in none of 40. Other payments tell no better: the
noise of the teacher blurs small ones, and of large ones both look alike."""
N_COMPARISONS = 300
FEWEST = 20
SEEDS, OTHER_SEEDS = 5, 3
"""Runs with the teacher of the text, and with each who wants something else."""
OUR_SEEDS = range(100, 140)
LOW, SLACK = 0.1, 0.5
"""The middle run must reach this quantile of our returns, less the slack: ours hardly ever misses it."""
NIGHT = "a list of (observation, action, next_observation), one for each step"

Step = tuple[State, int, State]


class Silent(gymnasium.Wrapper[Any, Any, Any, Any]):
    """An environment whose rewards are always 0, and whose `info` is empty: what is meant only the teacher knows."""

    def step(self, action: Any) -> tuple[Any, float, bool, bool, dict[str, Any]]:
        """Take a step, and pay nothing."""
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
        slip: the sentence of the first thing that she refused, "" if there is none.
    """

    def __init__(self, mdp: Morning, most: int, rng: Random) -> None:
        """Know what is meant."""
        self._mdp, self._most, self._rng = mdp, most, rng
        self.asked, self.slip = 0, ""

    def __call__(self, first: Any, second: Any) -> bool:
        """Whether the first night is preferred to the second.

        Raises:
            WrongAnswer: one of them is no night, or she was asked too often.
        """
        if self.asked == self._most:
            self._refuse(f"compare may be called {self._most} times, and this is one time more")
        first_return, second_return = (self._return(night) for night in (first, second))
        if first is second:
            self._refuse("compare is given the same night twice, of which neither is better: play two nights")
        self.asked += 1
        return bool(self._rng.random() < preference(first_return, second_return, NOISE))

    def _return(self, night: Any) -> float:
        """What a night is worth to her."""
        if not isinstance(night, list | tuple) or not all(
            isinstance(one, list | tuple) and len(one) == 3 for one in night
        ):
            self._refuse(f"compare takes two nights, each {NIGHT}, but one of them is {in_short(night)}")
        steps = [self._step(one) for one in night]
        rows, ways = model_of(self._mdp).rows, model_of(self._mdp).p
        state, total = self._mdp.initial(self._rng), 0.0
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
        return total

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
    """

    meant: float
    actions: Integers
    asked: int


def judged(program: Any, seed: int, mdp: Any = TASK) -> Judged:
    """Run a program with a seed, and evaluate its policy exactly, as the teacher of an MDP means it.

    Raises:
        WrongAnswer: it breaks the contract, raises an error or does not end.
    """
    call = f"{NAME}(environment, compare, {N_COMPARISONS}, {seed})"
    environment = Silent(MDPEnv(mdp))
    environment.reset(seed=1_000_003 + seed)
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
    return Judged(policy_evaluation(model, actions).start, actions, teacher.asked)


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
    ours, middle = our_returns(), sorted(found, key=lambda one: one.meant)[SEEDS // 2]
    told = f"the middle one of {SEEDS} runs makes a clock worth {middle.meant:.1f}"
    lowest = float(np.quantile(ours, LOW)) - SLACK
    if not middle.meant >= lowest:
        why = "" if nobody_asks_why() else f": {symptom(middle)}"
        raise WrongAnswer(f"{told}, and it should be worth {lowest:.1f} or more (ours {np.median(ours):.1f}){why}")
    _check_other_wishes(answer, seed)
    _check_patience(answer, seed)
    return f"Right: {told} (ours {np.median(ours):.1f}); random buttons {_random():.1f}, the best clock {_best():.1f}."


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
            " many passes; and Q-learning needs many nights, with random buttons in them"
        )


def symptom(run: Judged) -> str:
    """Return what a policy that is worth too little looks like, and the likely cause."""
    actions = run.actions[~model_of(TASK).terminal]
    if len({*actions.tolist()}) == 1:
        return (
            f"it chooses action {actions[0]} in every state; are the rewards that were learned looked up in the state"
            " and the action where they belong?"
        )
    if run.meant < _random() - 2:
        return "that is worse than random buttons; does the *preferred* night gain, and is the *best* action taken?"
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
        " learn the policy? Has its target the largest value of the *next* state, without a discount, and 0 after the"
        " last step?"
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
