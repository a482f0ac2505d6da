"""Exercise 3 of lesson 6: what a player does that votes and remembers, and what the usual mistakes do."""

import math
from collections.abc import Callable, Mapping, Sequence
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np

from edugym.mdp.protocol import Integers, Reals
from edugym_course.grading.agents import agent_created_by, table_of
from edugym_course.grading.choices import ChoiceCase, action_of, check_all_choices
from edugym_course.grading.errors import TooSlow, WrongAnswer
from edugym_course.grading.mistakes import LOOKS_LIKE
from edugym_course.grading.student_code import student_code

FOUR_NEEDS = 4
DRAWS = 300
"""Draws for each case when it is asked whether the last action is taken again."""
CALL = "act(observation, rng)"
PICKED_AGAIN = (
    "(If `pick` is called until another action comes: where the last action has the most words alone, that never"
    " happens. Leave it out of the votes, and pick once.)"
)


class Heard(NamedTuple):
    """A case of exercise 3: what is observed, and what was done last."""

    observation: tuple[int, ...]
    last: int

    @property
    def told(self) -> str:
        """The case, for a sentence."""
        return f"where observation = {np.array2string(self.array, separator=', ')} and self.last[0] = {self.last}"

    @property
    def array(self) -> Integers:
        """The observation as a player gets it."""
        return np.array(self.observation, np.int64)

    @property
    def call(self) -> str:
        """The call, for a sentence."""
        return f"act({np.array2string(self.array, separator=', ')}, rng)"


HEARD = (
    Heard((100, 2, 2, 0, 1, 2), 1),
    Heard((100, 1, 5, 1, 2, 6), 1),
    Heard((3, 2, 2, 0, 2, 0), 2),
    Heard((51, 0, 3, 0, 1), 0),
    Heard((77, 5, 1, 0, 2, 6, 9), 3),
    Heard((2, 3), 3),
    Heard((100, 0, 0, 0), -1),
    Heard((40, 7, 7, 2), -1),
    Heard((9, 1, 1, 3, 3, 0), 1),
    Heard((61, 3, 2, 3, 0, 0), -1),
    Heard((70, *13 * (1,), 2, 2), 1),
)
"""What is observed in the check: hit points that name another need than the words, synonyms, ties, a first step, and a
long message that names the last action again and again."""


def heard_beside(loud: float) -> list[Heard]:
    """Return messages whose first word has half a vote more than all others, and half a vote less."""
    return [Heard((60, 3, *(math.floor(loud) + more) * (2,)), -1) for more in (0, 1)]


def probabilities(
    case: Heard,
    *,
    start: int = 1,
    need: str = "k % 4",
    memory: str = "excluded",
    ties: str = "random",
    most: str = "most",
    loud: float = 1.0,
) -> Reals:
    """Return the probability of each action of the listener, if the first word counts as much as `loud` words.

    Other arguments than the defaults are mistakes.
    """
    words = case.observation[start:]
    words = {"first": words[:1], "last": words[-1:], "all but the last": words[:-1]}.get(most, words)
    votes = np.zeros(FOUR_NEEDS)
    for place, word in enumerate(words):
        named = {"k % 4": word % FOUR_NEEDS, "k // 4": word // FOUR_NEEDS, "k": word}[need]
        if named < FOUR_NEEDS:
            votes[named] += loud if place == 0 else 1.0
    if most == "least":
        votes = -votes
    elif most == "named once":
        votes = np.minimum(votes, 1.0)
    if memory in ("excluded", "place among the others") and case.last >= 0:
        votes[case.last] = -np.inf
    elif memory == "set to 0" and case.last >= 0:
        votes[case.last] = 0.0
    elif memory == "one less" and case.last >= 0:
        votes[case.last] -= 1.0
    elif memory == "-1 is the last" or (memory == "0 counts as nothing" and case.last > 0):
        votes[case.last] = -np.inf
    elif memory == "in turn":
        return _only((case.last + 1) % FOUR_NEEDS)
    best = votes == votes.max()
    shares = np.array(best / best.sum())
    if memory == "redrawn" and case.last >= 0:
        return np.where(np.arange(FOUR_NEEDS) == case.last, 0.0, shares + shares[case.last] / (FOUR_NEEDS - 1))
    if memory == "the next one" and case.last >= 0:
        shares[(case.last + 1) % FOUR_NEEDS] += shares[case.last]
        shares[case.last] = 0.0
    elif memory == "place among the others" and case.last >= 0:
        return np.append(np.delete(shares, case.last), 0.0)
    elif memory == "picked twice":
        return np.array(sum(share * _without(votes, action) for action, share in enumerate(shares)))
    if ties == "drawn by votes":
        counts = np.where(np.isfinite(votes), votes, 0.0)
        return counts / counts.sum() if counts.any() else shares
    if ties != "random":
        return _only(int(np.flatnonzero(best)[0 if ties == "first" else -1]))
    return shares


def _without(votes: Reals, action: int) -> Reals:
    """Return the probabilities of the others, if one action is left out of a vote."""
    others = np.where(np.arange(FOUR_NEEDS) == action, -np.inf, votes)
    return np.array((others == others.max()) / (others == others.max()).sum())


def _only(action: int) -> Reals:
    """Return the probabilities of a player that takes one action."""
    shares = np.zeros(FOUR_NEEDS)
    shares[action] = 1.0
    return shares


LISTENER_MISTAKES: Mapping[str, Mapping[str, Any]] = MappingProxyType(
    {
        "that is the vote alone; the action that was taken last should be left out": {"memory": "ignored"},
        "the hit points are counted as a word; the words begin with observation[1]": {"start": 0},
        "the first word is left out; the words begin with observation[1]": {"start": 2},
        "the last word is left out; range(1, len(observation)) goes through all of them": {"most": "all but the last"},
        "only the first word is heard": {"most": "first"},
        "only the last word is heard; is something overwritten in the loop?": {"most": "last"},
        "words from 4 on are not counted: word k names need k % 4": {"need": "k"},
        "word k names need k % 4, the rest of the division, not k // 4": {"need": "k // 4"},
        "the last action gets no votes, but it can still win where all others have none; give it -100": {
            "memory": "set to 0"
        },
        "the last action loses one vote only; it should never be taken": {"memory": "one less"},
        "-1 is no action but says that nothing was done yet, and as an index it is the last entry": {
            "memory": "-1 is the last"
        },
        "action 0 may have been the last one too: compare self.last[0] with -1, or with >= 0": {
            "memory": "0 counts as nothing"
        },
        "it takes the actions in turn and does not listen": {"memory": "in turn"},
        "where the last action has most votes, it takes any other; it should take the one with most words among them": {
            "memory": "redrawn"
        },
        "where the last action has most votes, it takes the one with the next number; it should take the one with most"
        " words among them": {"memory": "the next one"},
        "that is the place of the action in a list of the others, and not the action": {
            "memory": "place among the others"
        },
        "`pick` is called twice, and what was picked first is left out: leave the last action out before you pick, and"
        " pick once": {"memory": "picked twice"},
        "a need that is named twice counts once: += 1 instead of = 1": {"most": "named once"},
        "it draws the needs in proportion to their words; it should take one with the most": {"ties": "drawn by votes"},
        "ties should be broken at random, and it takes the first of equals: call pick(votes, rng)": {"ties": "first"},
        "ties should be broken at random, and it takes the last of equals: call pick(votes, rng)": {"ties": "last"},
        "it takes the need with the *fewest* words": {"most": "least"},
        "it takes the first of equals, and does not leave the last action out": {"ties": "first", "memory": "ignored"},
        "the hit points are counted as a word, and the last action is not left out": {"start": 0, "memory": "ignored"},
    }
)


def _chooser(made: Any, case: Heard) -> Callable[[np.random.Generator], Any]:
    """Return a function that lets a student's player choose in a case."""

    def choose(rng: np.random.Generator) -> Any:
        made.last[0], observation = case.last, case.array
        action = made.act(observation, rng)
        if not np.array_equal(observation, case.array):
            raise WrongAnswer(f"{case.call} changes the observation that it is given: only read it, or copy it first")
        return action

    return choose


def _fails(made: Any, case: Heard) -> bool:
    """Whether a student's player raises an error in a case."""
    try:
        with student_code(case.call):
            _chooser(made, case)(np.random.default_rng(0))
    except WrongAnswer:
        return True
    return False


def check_actions(made: Any, cases: Sequence[Heard], loud: float) -> None:
    """Check what a student's player chooses."""
    asked = []
    for case in cases:
        right = probabilities(case, loud=loud)
        mistakes = {
            sentence: probabilities(case, loud=loud, **change) for sentence, change in LISTENER_MISTAKES.items()
        }
        telling = {sentence: found.tolist() for sentence, found in mistakes.items() if not np.allclose(found, right)}
        asked.append(ChoiceCase(_chooser(made, case), right.tolist(), telling, {}, case.told))
    try:
        check_all_choices(CALL, asked)
    except TooSlow as late:
        raise TooSlow(f"{late} {PICKED_AGAIN}") from None
    except WrongAnswer as wrong:
        if all(_fails(made, case) == (max(case.observation[1:]) >= FOUR_NEEDS) for case in cases):
            raise WrongAnswer(f"{wrong}; word k names need k % 4, and there are more than four words") from None
        if LOOKS_LIKE in str(wrong) or not str(wrong).endswith((*LISTENER_MISTAKES,)):
            _check_left_out(made, cases)
        raise


def made_by(answer: Any) -> Any:
    """Make a student's player."""
    made = agent_created_by("Listener", answer, "toy", None)
    table_of(made, "last", (1,), "i")
    return made


def check_memory(made: Any, cases: list[Heard]) -> None:
    """Check that the action is remembered."""
    wrong, writes = [], False
    for case in cases:
        with student_code(case.call):
            action = action_of(case.call, _chooser(made, case)(np.random.default_rng(1)), FOUR_NEEDS)
        writes = writes or made.last[0] != case.last
        if made.last[0] != action:
            wrong.append((case, action, int(made.last[0])))
    for case, action, last in wrong:
        if last != case.last:
            twice = ": is `pick` called twice? Note the action that you return" if last >= 0 else ""
            raise WrongAnswer(
                f"after {case.call} took action {action}, self.last[0] should be {action}, but is {last}{twice}"
            )
    for case, action, _ in wrong:
        if writes:
            raise WrongAnswer(
                f"after {case.call} took action {action}, self.last[0] should be {action}, but is {case.last}: is"
                " another action noted there than the one that you return?"
            )
        raise WrongAnswer(
            f"{case.call} takes action {action}, but self.last[0] is still {case.last}: write the action into it before"
            " you return"
        )


def _check_left_out(made: Any, cases: Sequence[Heard]) -> None:
    """Check that the last action is never taken again."""
    for case in cases:
        rng, choose = np.random.default_rng(2), _chooser(made, case)
        with student_code(case.call):
            again = sum(choose(rng) == case.last for _ in range(DRAWS))
        if again:
            raise WrongAnswer(
                f"{CALL}, {case.told}, takes action {case.last} in {again / DRAWS:.0%} of calls, but that is the one"
                " that was taken last: it should not be taken again, however many words name it"
            )
