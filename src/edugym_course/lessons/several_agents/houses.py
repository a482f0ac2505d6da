"""The small games of the project of lesson 13: they cannot be played safely if a part of the method is missing."""

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.mdp.protocol import Random, Reals
from edugym_course.lessons.several_agents.methods import DARING

N_ACTIONS, HALL, OVER = 3, 0, 100
"""The actions of each player (player 1 may have fewer); the first place; and from where on the states are those after
the end."""
UNPAID = N_ACTIONS**2
"""How much larger the number of such a state is if chance paid nothing."""
SAFE = ((9.0, 6.0, 12.0), (0.0, -3.0, 3.0), (-6.0, -9.0, -3.0))
"""What player 0 gets in a room in which its first action is best whatever the other does."""
TRAP = ((-2.0, -2.0, -12.0), (-3.0, -3.0, -3.0), (-4.0, -4.0, -3.5))
"""What player 0 gets in a room in which its first action is best until player 1 takes its third. Player 1 gains by all
of its actions, so it has no reason to try another one, but for its random moves."""
NARROW = ((8.0, -2.0), (-2.0, 8.0), (-6.0, -6.0))
"""What player 0 gets in a room in which player 1 has two actions: 3 by the safe policy."""
ROCK = np.array(DARING)
LOADED = ((0.0, -9.0, 6.0), (9.0, 0.0, -5.0), (-6.0, 5.0, 0.0))
"""Rock, paper and scissors in which the safe probabilities are 1/4, 3/10 and 9/20: who rounds them loses."""
WILD = (0.1, 1.5, 0.5, 0.1, 0.5)
"""How much hangs on the actions in each room, from the one that is worth least on.

So neither the best that may happen there nor what one action by itself guarantees says what it is worth, and who goes
by them takes wrong ways.
"""
FOLLY = ((0.2, 12.0), (12.0, 3.0), (12.0, 1.0), (0.2, 12.0), (1.0, 1.0))
"""What player 0 loses in each room by an action that it should never take, and wins if the other takes such a one.

So neither what happens to players who toss a coin nor what happens with random moves says what a room is worth.
"""


class House(NamedTuple):
    """A zero-sum game with a hall, in which the pair of actions decides the next room, and rooms, each of which pays.

    After a room the game is over. What is seen then is the number of some place. Places are numbered from the last to
    the first: so the state 0 is a room, one that follows on others.

    Attributes:
        hall: shape (n_actions, n_other_actions): the place that each pair of actions leads to, a room from 1 on.
        rooms: shape (n_rooms, n_actions, n_other_actions): what player 0 gets.
        seen_at_end: which place is seen after the end, by the number of the pair of actions.
        max_steps: the step limit.
        pays: shape (n_actions, n_other_actions): what player 0 gets in the hall.
        luck: the probability that a room pays.
        is_apart: whether the number that is seen after the end is that of no place.
    """

    hall: Any
    rooms: Reals
    seen_at_end: tuple[int, ...]
    max_steps: int = 50
    pays: Reals = np.zeros((N_ACTIONS, N_ACTIONS))
    luck: float = 1.0
    is_apart: bool = False

    def initial(self, rng: Random) -> int:
        """Any place."""
        return int(rng.random() * (1 + self.rooms.shape[0]))

    def transition(self, state: int, actions: tuple[int, int], rng: Random) -> int:
        """From the hall into a room, or back to it, and from a room to the end."""
        pair = N_ACTIONS * actions[0] + actions[1]
        if state == HALL:
            return int(self.hall[actions[0], actions[1]])
        return OVER + pair + UNPAID * (self.luck < 1 and rng.random() >= self.luck)

    def rewards(self, state: int, actions: tuple[int, int], next_state: int, rng: Random) -> tuple[float, float]:
        """What a room pays, and the hall."""
        paid = float(self.pays[actions] if state == HALL else self.rooms[state - 1, actions[0], actions[1]])
        paid *= next_state < OVER + UNPAID
        return paid, -paid

    def terminal(self, state: int) -> bool:
        """After a room."""
        return state >= OVER

    def observation(self, state: int, player: int, rng: Random) -> int:
        """The number of the place, or what is seen after the end."""
        if state < OVER:
            return self.number(state)
        return 1 + self.rooms.shape[0] if self.is_apart else self.number(self.seen_at_end[(state - OVER) % UNPAID])

    def number(self, place: int) -> int:
        """What is seen in a place."""
        return self.rooms.shape[0] - place

    def observation_space(self, player: int) -> spaces.Discrete:
        """The places, and one number more if another one is seen after the end."""
        return spaces.Discrete(1 + self.rooms.shape[0] + self.is_apart)

    def action_space(self, player: int) -> spaces.Discrete:
        """Three actions; sometimes two for player 1."""
        return spaces.Discrete(self.rooms.shape[1 + player])


class Riddle(NamedTuple):
    """A kind of house, and what must be learned to play it safely.

    Attributes:
        make: makes the house; actions and rooms are numbered anew with each seed.
        asks: what a program that fails here has missed.
        again: where bad luck makes a right program fail at times, how many times as many steps it then has for each of
            two more houses of the same kind, both of which it must play safely; 0 where it fails at once.
    """

    make: Callable[[Random], House]
    asks: str
    again: int = 0


def _turned(table: Any, rng: Random) -> Reals:
    """Return a table with its rows and columns in another order."""
    return np.array(table, float)[np.ix_(rng.permutation(N_ACTIONS), rng.permutation(N_ACTIONS))]


def _rooms(rng: Random) -> House:
    """Two rooms, one of which needs a random policy; it does not matter what is done in the hall."""
    safe = _turned(SAFE, rng)
    while safe.sum(axis=0).argmax() != safe.sum(axis=1).argsort()[1]:  # who takes columns for rows plays the middle one
        safe = _turned(SAFE, rng)
    rooms = np.stack([_turned(LOADED, rng), safe])
    return House(np.ones((N_ACTIONS, N_ACTIONS), int), rooms, (HALL,) * N_ACTIONS**2)


def _pennies(stake: float, folly: tuple[float, float]) -> Reals:
    """Return matching pennies, which is worth 0, with an action more for each player, by which it only loses."""
    own, others = folly
    return np.array([[stake, -stake, others], [-stake, stake, others], [-own, -own, 0.0]])


def _way(rng: Random, seen_at_end: Sequence[int] = (HALL,) * N_ACTIONS**2, max_steps: int = 50) -> House:
    """Five rooms that are worth -3, -1, 0, 1 and 3, and a hall in which the way must be chosen at random."""
    worth = rng.permutation(np.unique(ROCK))
    hall = _turned(ROCK, rng)
    pennies = dict(zip(np.unique(ROCK), map(_pennies, WILD, FOLLY), strict=True))
    rooms = np.stack([_turned(pennies[one], rng) + one for one in worth])
    places = np.array([[1 + int(np.flatnonzero(worth == one)[0]) for one in row] for row in hall])
    return House(places, rooms, tuple(seen_at_end), max_steps)


def _alike(rng: Random) -> House:
    """The same, but after the end some room is seen."""
    return _way(rng, rng.permutation([1, 2, 3, 4, 5, 1, 2, 3, 4]).tolist())


def _cut(rng: Random) -> House:
    """The same, but each episode is cut off after a step."""
    return _way(rng, max_steps=1)


def _soon(rng: Random, at_once: float = 18.5, least: float = 0.0) -> House:
    """A hall with three ways: to a room worth 20, to one worth 0 with `at_once` on the way, or to that one for nothing.

    `least` is added to what both rooms are worth.

    Player 1 has one good action there, and loses 5 by the two others: so it takes the same one nearly always.
    """
    order, good = rng.permutation(N_ACTIONS), int(rng.integers(N_ACTIONS))
    hall, pays = np.ones((N_ACTIONS, N_ACTIONS), int), np.full((N_ACTIONS, N_ACTIONS), 5.0)
    hall[order[0]] = 2
    pays[:, good] = 0.0
    pays[order[1]] += at_once
    rooms = np.stack([_turned(ROCK, rng) / 2 + one + least for one in (0.0, 20.0)])
    return House(hall, rooms, (HALL,) * N_ACTIONS**2, pays=pays)


def _of_two_columns(table: Reals, rng: Random, luck: float = 1.0) -> House:
    """Four rooms with the same table in another order; player 1 has two actions."""
    rooms = np.stack([table[rng.permutation(N_ACTIONS)][:, rng.permutation(2)] for _ in range(4)])
    return House(rng.integers(1, 5, (N_ACTIONS, 2)), rooms, (HALL,) * UNPAID, pays=np.zeros((N_ACTIONS, 2)), luck=luck)


def _chance(rng: Random) -> House:
    """Rooms that pay in eight of ten times, and player 1 has two actions; in each an action is best in the mean.

    Who believes the last reward takes another action whenever the best one was not paid.
    """
    table = np.array([[6.0, 7.0], [2.0, 1.0], [1.0, 2.0]])
    return _of_two_columns(table, rng, luck=0.8)


def _narrow(rng: Random) -> House:
    """Rooms in which player 1 has two actions, and player 0 wins whichever it takes, if it draws one of two at random.

    With a third column of zeros they would be worth 0, and many policies would look as good.
    """
    return _of_two_columns(np.array(NARROW), rng)


def _traps(rng: Random) -> House:
    """Rooms in which the danger shows in random moves of player 1 alone, and a hall in which one can stay at a cost."""
    rooms = np.stack([_turned(TRAP, rng) for _ in range(4)])
    hall, stays = rng.integers(1, 5, (N_ACTIONS, N_ACTIONS)), rng.integers(N_ACTIONS)
    pays = np.zeros(hall.shape)
    hall[stays], pays[stays] = HALL, -1.0
    return House(hall, rooms, (HALL,) * N_ACTIONS**2, pays=pays)


AFTER_THE_END = (
    "after the end a number is seen that other states have, too: what comes then is worth 0, so with `terminated`"
    " the target is R alone (and elsewhere R + γ V(S'), with the value of the matrix game)"
)
BACK = "there an action leads back to the same state, and costs 1: learn from it as from any other step"
ROOMS = Riddle(
    _rooms,
    "its policy should be that of the matrix game Q[state]: is Q[state, action, other_action] moved by α (T - Q) after"
    " every pair of actions, can Q hold fractions, and is the policy returned without the random moves?",
)
CHANCE = Riddle(
    _chance,
    "there chance says whether an action is paid, so one reward tells little: Q moves by α (T - Q), with α about 0.2."
    " (And does each player have as many actions as `action_space` says, and are random ones drawn among all of them?)",
    again=1,
)
TRAPS = Riddle(
    _traps,
    "there player_1 gains by each of its actions, and by one of them a lot, if player_0 does not expect it:"
    " player_1 takes one random action in five, too",
)
RIDDLES = (
    ROOMS,
    CHANCE,
    Riddle(
        _way,
        "it pays nothing and leads to others: the target is R + γ V(S'), with γ = 0.9, where V(S') is the value of the"
        " matrix game of S'. (Is `terminated` read by the name of a player, and is each action tried?)",
    ),
    Riddle(
        _soon,
        "there 18.5 at once is more than 20 a step later: what follows is multiplied by γ = 0.9 (and one action of five"
        " is random, so that all are tried; and Q moves by α (T - Q))",
    ),
    Riddle(
        _narrow,
        "player_1 has two actions there, and player_0 three: a table has a column for each action that player_1 *has*,"
        " and no other",
    ),
    Riddle(
        _alike,
        AFTER_THE_END,
    ),
    Riddle(
        _cut,
        "its episodes are truncated, not terminated: the clock was stopped, and the next state still has its value, so"
        " only `terminated` makes R alone the target; and S' is what step() gave, not what reset() gives after it",
    ),
    TRAPS,
    Riddle(
        partial(_soon, at_once=17.5, least=-30.0),
        "there a room that costs 10 is better than 17.5 at once and then a room that costs 30: what follows is"
        " multiplied by γ = 0.9, and by no less, and it may be far below 0; and Q moves by α (T - Q)",
        again=2,
    ),
)
