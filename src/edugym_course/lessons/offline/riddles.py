"""Log-books in which a careful reader has one choice only: riddles that nobody solves who leaves out a part."""

from collections import Counter
from collections.abc import Iterator, Mapping
from types import MappingProxyType
from typing import NamedTuple

from edugym.mdp.protocol import Random
from edugym_course.lessons.offline.sweeps import Step

LENGTH = 10
N_ACTIONS = 3
FIRST = "first"
"""The state in which every night of a riddle begins."""
AFTERWARDS = "afterwards"
"""The states of the rest of a night, in which all actions are tried and none matters."""

Move = tuple[str, int, float]
"""A state, which is another one at each step of the night, an action, and its reward."""
Place = tuple[str, int]
"""A state, and the step of the night."""


class Riddle(NamedTuple):
    """A log-book of 80 nights, each of ten steps.

    Attributes:
        nights: how many nights there are of each kind, and the moves that they begin with.
        right: what a careful reader does in the first state.
        shows: what the log-book shows, for the sentence.
        asks: which part of the method it takes.
        rest: the reward of each step after the moves.
        n_actions: how many actions there are.
        placed: of some nights, their number in the log-book, and their kind, an index of `nights`; the others come in
            any order.
    """

    nights: tuple[tuple[int, tuple[Move, ...]], ...]
    right: int
    shows: str
    asks: str
    rest: float = 1.0
    n_actions: int = N_ACTIONS
    placed: Mapping[int, int] = MappingProxyType({})


def _corridor(name: str, action: int, first: float, last: float, between: float = 0.0) -> tuple[Move, ...]:
    """A night with a first and a last reward, and the same reward in each step between."""
    inner = tuple((name, 0, between) for _ in range(LENGTH - 2))
    return ((FIRST, action, first), *inner, (name, 0, last))


def _of_all_nights(n_rooms: int = 14) -> Riddle:
    """Action 0 leads to one of several rooms, and what is good in each was found in two nights alone.

    Those of four rooms are both even or odd, and both at the start or at the end, and in other nights there the room is
    met: so a half of the nights misses one, whichever it is. Of nights that are drawn, others are missing.
    """
    rooms = [(f"room {room}", room % N_ACTIONS, (room + 1) % N_ACTIONS) for room in range(n_rooms)]
    goods = [(2, ((FIRST, 0, 0.0), (name, good, 10.0))) for name, good, _ in rooms]
    bads = [(3, ((FIRST, 0, 0.0), (name, bad, -80.0))) for name, _, bad in rooms]
    return Riddle(
        (*goods, *bads, (10, ((FIRST, 1, 0.0), ("even", 0, 6.0)))),
        right=0,
        shows=(
            f"action 0 leads to one of {n_rooms} states, in each of which one action brought 10, in two nights alone,"
            " and another cost 80; action 1 leads to a state that brought 6 in each of 10 nights"
        ),
        asks=(
            "does the program learn from *all* nights, from the first to the last, and from those of a rare pair?"
            " (With a learning rate that does not fall, what is learned last counts more than in a mean.)"
        ),
        placed={0: 0, 2: 0, 1: 1, 3: 1, 76: 2, 78: 2, 77: 3, 79: 3}
        | {41: n_rooms, 40: n_rooms + 1, 5: n_rooms + 2, 4: n_rooms + 3},
    )


RIDDLES = (
    Riddle(
        ((70, ((FIRST, 0, 1.0),)), (10, ((FIRST, 1, 3.0),))),
        right=1,
        shows="action 0 brought 1 in each of 70 nights, and action 1 brought 3 in each of 10",
        asks="what counts is the *mean* of the targets, not their sum or their number; a penalty is small beside that",
    ),
    Riddle(
        (
            (20, ((FIRST, 1, 1.0), ("choice", 0, 4.0))),
            (20, ((FIRST, 1, 1.0), ("choice", 1, -40.0))),
            *((number, ((FIRST, 0, 0.0), ("none", action, 1.0))) for action, number in enumerate((14, 13, 13))),
        ),
        right=1,
        shows=(
            "action 1 leads to a choice between 4 and −40, and action 0 to a state in which every action brings 1; so"
            " action 1 is better by 4"
        ),
        asks="the value of the next state is the *largest* of its row",
    ),
    _of_all_nights(),
    Riddle(
        ((40, _corridor("near", 0, 3.0, 6.9)), (40, _corridor("far", 2, 0.0, 10.0))),
        right=2,
        shows="action 0 brings 3 at once and 6.9 in the last step, and action 2 brings 10 in the last step",
        asks=(
            "a target is R (in the last step, too) plus the value of the *next* state, without discount, with new sums"
            " in each sweep, and ten sweeps or more. (Or are values whole numbers, as in np.full(..., -90)?)"
        ),
    ),
    Riddle(
        ((40, _corridor("dear", 1, -5.0, -5.0, -5.0)), (40, _corridor("dearer", 2, -7.0, -7.0, -7.0))),
        right=1,
        shows="action 1 cost 5 in each step of 40 nights, action 2 cost 7, and action 0 was never tried",
        asks="what was never tried gets the lowest value, −90, and not 0 or the lowest *reward*",
    ),
    Riddle(
        (
            (2, ((FIRST, 0, 8.0), ("good", 0, 10.0))),
            (38, ((FIRST, 0, 0.0), ("bad", 0, 0.0))),
            (40, ((FIRST, 1, 3.0), ("fair", 0, 0.0))),
        ),
        right=1,
        shows=(
            "action 0 brought 8, and 10 in the next step, in the first night and in the last, and nothing in 38 others;"
            " action 1 brought 3 in each of 40"
        ),
        asks="every step counts in the mean of its pair, with its own reward and next state (+= adds, and = forgets)",
        placed={0: 0, 79: 0},
    ),
    Riddle(
        (
            (25, ((FIRST, 0, 0.0), ("well", 0, 3.0))),
            (15, ((FIRST, 0, 0.0), ("ill", 0, -20.0))),
            (40, ((FIRST, 1, 0.0), ("so-so", 0, 0.0))),
        ),
        right=1,
        shows=(
            "action 0 led in 25 nights to a state that brought 3, and in 15 to another that cost 20, and action 1 in 40"
            " to one that brought 0"
        ),
        asks=(
            "what is seldom counts in the mean, too; a median forgets it, and so does the most frequent next state. (Or"
            " is an action that was never tried worth 0 in the targets, where it should be worth −90?)"
        ),
    ),
    Riddle(
        (
            (39, ((FIRST, 2, 0.0), ("well", 0, 6.0))),
            (1, ((FIRST, 2, 0.0), ("ill", 0, -20.0))),
            (40, ((FIRST, 1, 0.0), ("so-so", 0, 1.0))),
        ),
        right=2,
        shows=(
            "action 2 led in 39 nights to a state that brought 6, and in one to another that cost 20, and action 1 in"
            " 40 to one that brought 1"
        ),
        asks=(
            "what counts is the *mean* of the targets of a pair, not the lowest of them, and not the value of the worst"
            " next state"
        ),
    ),
    Riddle(
        ((40, ((FIRST, 2, 1.9), ("nearly two", 0, 1.9))), (40, ((FIRST, 0, 1.1), ("two", 0, 2.1)))),
        right=2,
        shows="action 2 brought 1.9 twice in each of 40 nights, and action 0 brought 1.1 and then 2.1 in each of 40",
        asks="does a reward lose what is behind its decimal point, as by int(reward)?",
    ),
    Riddle(
        ((78, ((FIRST, 2, 7.0),)), (2, ((FIRST, 1, 5.0),))),
        right=2,
        shows="action 2 brought 7 in each of 78 nights, and action 1 brought 5 in each of 2",
        asks="a mean divides the sum by the *number* of the steps of its pair",
    ),
    Riddle(
        (
            (1, ((FIRST, 0, -80.0),)),
            (24, ((FIRST, 0, 3.0),)),
            (30, ((FIRST, 1, 0.0),)),
            (24, ((FIRST, 2, 3.0),)),
            (1, ((FIRST, 2, -80.0),)),
        ),
        right=1,
        shows=(
            "action 0 cost 80 in the first night and brought 3 in 24 others, action 2 cost 80 in the last night and"
            " brought 3 in 24 others, and action 1 brought 0 in each of 30"
        ),
        asks="the first night counts, and so does the last",
        placed={0: 0, 79: 4},
    ),
    Riddle(
        ((79, ((FIRST, 2, 1.0),)), (1, ((FIRST, 1, 1.1),))),
        right=2,
        shows="action 2 brought 1 in each of 79 nights, and action 1 brought 1.1 in one night",
        asks="what rests on one step is little to go by: *subtract* a penalty, the larger the fewer the"
        " steps with this state *and* action",
    ),
    Riddle(
        (
            (39, ((FIRST, 0, 0.0), ("mostly", 0, 1.0))),
            (1, ((FIRST, 0, 0.0), ("mostly", 2, 1.1))),
            (40, ((FIRST, 2, 0.0), ("always", 1, 1.05))),
        ),
        right=2,
        shows=(
            "action 0 leads to a state in which action 0 brought 1 in 39 nights and action 2 brought 1.1 in one, and"
            " action 2 to a state in which action 1 brought 1.05 in each of 40"
        ),
        asks="the penalty is part of the value of the next state, too: subtract it in each sweep, not only in the end",
    ),
    Riddle(
        ((80, ((FIRST, 2, -5.0),)),),
        right=2,
        shows="action 2 cost 5 at once in each of 80 nights, and the other two were never tried",
        asks="what was never tried is worth −90: what another action of its state brought tells nothing of it",
    ),
    Riddle(
        (
            (39, _corridor("mostly late", 0, 0.0, 1.0, 1.0)),
            (1, (*_corridor("mostly late", 0, 0.0, 1.0, 1.0)[:-1], ("mostly late", 2, 1.1))),
            (40, _corridor("always late", 2, 0.0, 1.05, 1.0)),
        ),
        right=2,
        shows=(
            "action 0 leads to a last step in which action 0 brought 1 in 39 nights and action 2 brought 1.1 in one,"
            " and action 2 to a last step that brought 1.05 in each of 40"
        ),
        asks="the penalty belongs to the last step of a night, too",
    ),
    Riddle(
        ((40, ((FIRST, 3, 6.0),)), (40, ((FIRST, 0, 1.0),))),
        right=3,
        shows="there are four actions, action 3 brought 6 in each of 40 nights, and action 0 brought 1 in each of 40",
        asks="n_actions says how many there are",
        n_actions=4,
    ),
)


class LogBook(NamedTuple):
    """What a program is given.

    Attributes:
        steps: the nights, one after the other.
        n_states: how many states there are.
        first: the number of the state in which every night begins.
        never: that of a state which no night has.
    """

    steps: list[Step]
    n_states: int
    first: int
    never: int


def log_book(riddle: Riddle, rng: Random) -> LogBook:
    """Return the log-book of a riddle: the nights in any order, the numbers of the states dealt out anew."""
    placed = dict(riddle.placed)
    others = Counter({kind: number for kind, (number, _) in enumerate(riddle.nights)}) - Counter(placed.values())
    drawn = iter(rng.permutation([*others.elements()]).tolist())
    order = [placed[night] if night in placed else next(drawn) for night in range(others.total() + len(placed))]
    nights = [[*_moves(riddle, riddle.nights[kind][1], night)] for night, kind in enumerate(order)]
    places = {place: None for night in nights for place, *_ in night}
    named = [*places, ("end", LENGTH), ("never", 0)]
    number_of = dict(zip(named, rng.permutation(len(named)).tolist(), strict=True))
    steps = list[Step]()
    for night in nights:
        afters = [*(place for place, *_ in night[1:]), ("end", LENGTH)]
        for (place, action, reward), after in zip(night, afters, strict=True):
            steps.append((number_of[place], action, reward, number_of[after], after[1] == LENGTH))
    return LogBook(steps, len(number_of), number_of[FIRST, 0], number_of["never", 0])


def _moves(riddle: Riddle, begins: tuple[Move, ...], night: int) -> Iterator[tuple[Place, int, float]]:
    """Yield the steps of a night: its moves, and then what does not matter."""
    rest = [(AFTERWARDS, (night + step) % N_ACTIONS, riddle.rest) for step in range(LENGTH - len(begins))]
    for step, (name, action, reward) in enumerate([*begins, *rest]):
        yield (name, step), action, reward
