"""The sleepers and teachers of the project of lesson 14: each finds out whether a part of the method is missing."""

from typing import Any, NamedTuple

from edugym.mdp.protocol import Random
from edugym.mdp.wrapper import wrapper
from edugym_course.lessons.own_problem.morning import ASLEEP, AWAKE, CHIME, QUIET, RING, Morning, State

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


@wrapper
class AtOnce(NamedTuple):
    """A sleeper who wakes in every other step, and a teacher who pays for one action in the first, and never again.

    That is a chime if she is asleep then, and a ring if she is awake. Later she takes something for the same, so a
    program without the time misses it. No state after it tells of the action, so a program that does not learn from the
    first step misses it, too. No step leads to the depth from which it comes, so a program that learns by the next
    depth and looks up by this one also does. And since nights begin asleep and awake in turns, a program that learns
    from one night of each pair finds only one of the two.

    Attributes:
        mdp: the morning.
        soon: what she pays.
        later: what she takes for the same later.
    """

    mdp: Any
    soon: float = 4.0
    later: float = 2.0

    def initial(self, rng: Random) -> State:
        """Asleep, or awake."""
        return 0, ASLEEP if rng.random() < 0.5 else AWAKE

    def transition(self, state: State, action: int, rng: Random) -> State:
        """Whatever is done, she wakes, and falls asleep again."""
        return state[0] + 1, AWAKE if state[1] == ASLEEP else ASLEEP

    def reward(self, state: State, action: int, next_state: State, rng: Random) -> float:
        """Pay at first, and take later."""
        time, depth = state
        if action != (CHIME if depth == ASLEEP else RING):
            return 0.0
        return self.soon if time == 0 else -self.later


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
        "after deep sleep comes dozing in most random nights, so a step must not get the credit of its night. Are there"
        " many passes, and is it the error y - p that is learned from, with p by the rewards as they are then? (Or"
        " are too few comparisons asked, is the depth left out, has Q-learning too few nights or too small an α, or is"
        " its largest value that of another state than the next one?)",
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
AT_ONCE = AtOnce(TASK)
