"""The project of lesson 13: a player that nobody can exploit, from a blank file.

A program trains both players of a game by a loop of its own, and returns the policy of player 0. It is judged by what
the best opponent wins from this policy, computed exactly, in riddles: small games that cannot be played safely if one
part of the method is missing.
"""

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces
from gymnasium.error import ResetNeeded

from edugym.adapters.parallel_env import PLAYERS, GameEnv
from edugym.checks.parameters import in_short
from edugym.exact.game_model import GameModel, game_model
from edugym.exact.shapley import minimax_value_iteration
from edugym.exact.value_iteration import value_iteration
from edugym.mdp.protocol import Random, Reals
from edugym_course.grading.agents import require_function
from edugym_course.grading.errors import WrongAnswer, nobody_asks_why
from edugym_course.grading.programs import APART, ENOUGH, NAME, POLICY, UNSEEDED
from edugym_course.grading.student_code import student_code
from edugym_course.lessons.several_agents.methods import DARING, DISCOUNT

N_STEPS, TRIAL, LONGER = 6_000, 60, 4
"""Training steps in a riddle, in a first trial, and how many times as long a slow program may take."""
NEAR = 0.2
"""How much less than the value of a place a policy may guarantee there."""
SLOW = 0.6
"""Who still loses much, but less than this share of it after longer training, learns too slowly."""
SURE = 0.99
"""An action with this probability or more leaves nothing to chance."""
N_ACTIONS, HALL, OVER = 3, 0, 100
"""The actions of each player; the first place; and from where on the states are those after the end."""
SAFE = ((9.0, 6.0, 12.0), (0.0, -3.0, 3.0), (-6.0, -9.0, -3.0))
"""What player 0 gets in a room in which its first action is best whatever the other does."""
ROCK = np.array(DARING)
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

    After a room the game is over. What is seen then is the number of some place.

    Attributes:
        hall: shape (n_actions, n_actions): the room that each pair of actions leads to, from 1 on.
        rooms: shape (n_rooms, n_actions, n_actions): what player 0 gets.
        seen_at_end: which place is seen after the end, by the number of the pair of actions.
        max_steps: the step limit.
        pays: what player 0 gets in the hall for each pair of actions.
    """

    hall: Any
    rooms: Reals
    seen_at_end: tuple[int, ...]
    max_steps: int = 50
    pays: Reals = np.zeros((N_ACTIONS, N_ACTIONS))

    def initial(self, rng: Random) -> int:
        """Any place."""
        return int(rng.random() * (1 + self.rooms.shape[0]))

    def transition(self, state: int, actions: tuple[int, int], rng: Random) -> int:
        """From the hall into a room, and from a room to the end."""
        pair = N_ACTIONS * actions[0] + actions[1]
        return int(self.hall[actions[0], actions[1]]) if state == HALL else OVER + pair

    def rewards(self, state: int, actions: tuple[int, int], next_state: int, rng: Random) -> tuple[float, float]:
        """What a room pays, and the hall."""
        paid = float(self.pays[actions] if state == HALL else self.rooms[state - 1, actions[0], actions[1]])
        return paid, -paid

    def terminal(self, state: int) -> bool:
        """After a room."""
        return state >= OVER

    def observation(self, state: int, player: int, rng: Random) -> int:
        """The place, or what is seen after the end."""
        return self.seen_at_end[state - OVER] if state >= OVER else state

    def observation_space(self, player: int) -> spaces.Discrete:
        """The places."""
        return spaces.Discrete(1 + self.rooms.shape[0])

    def action_space(self, player: int) -> spaces.Discrete:
        """The three actions."""
        return spaces.Discrete(N_ACTIONS)


class Riddle(NamedTuple):
    """A kind of house, and what must be learned to play it safely.

    Attributes:
        make: makes the house; actions and rooms are numbered anew with each seed.
        asks: what a program that fails here has missed.
    """

    make: Callable[[Random], House]
    asks: str


def _turned(table: Any, rng: Random) -> Reals:
    """Return a table with its rows and columns in another order."""
    return np.array(table, float)[np.ix_(rng.permutation(N_ACTIONS), rng.permutation(N_ACTIONS))]


def _rooms(rng: Random) -> House:
    """Two rooms, one of which needs a random policy; it does not matter what is done in the hall."""
    safe = _turned(SAFE, rng)
    while safe.sum(axis=0).argmax() != safe.sum(axis=1).argsort()[1]:  # who takes columns for rows plays the middle one
        safe = _turned(SAFE, rng)
    rooms = np.stack([_turned(ROCK, rng), safe])
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


def _soon(rng: Random, at_once: float = 18.5) -> House:
    """A hall in which player 0 chooses between a room that is worth 20, so much at once, and nothing.

    Player 1 has one good action there, and loses 5 by the two others: so it takes the same one nearly always.
    """
    order, good = rng.permutation(N_ACTIONS), int(rng.integers(N_ACTIONS))
    hall, pays = np.ones((N_ACTIONS, N_ACTIONS), int), np.full((N_ACTIONS, N_ACTIONS), 5.0)
    hall[order[0]] = 2
    pays[:, good] = 0.0
    pays[order[1]] += at_once
    rooms = np.stack([_turned(ROCK, rng) / 2 + one for one in (0.0, 20.0)])
    return House(hall, rooms, (HALL,) * N_ACTIONS**2, pays=pays)


ROOMS = Riddle(
    _rooms,
    "its policy should be that of the matrix game Q[state]: is Q[state, action, other_action] learned from every pair"
    " of actions, and is the policy returned without the random moves?",
)
RIDDLES = (
    ROOMS,
    Riddle(
        _way,
        "it pays nothing and leads to others: the target is R + γ V(S'), with γ = 0.9, where V(S') is"
        " the value of the matrix game of S'. (Is `terminated` read by the name of a player?)",
    ),
    Riddle(
        _soon,
        "there 18.5 at once is more than 20 a step later: what follows is multiplied by γ = 0.9 (and one action of five"
        " is random, so that all are tried)",
    ),
    Riddle(
        partial(_soon, at_once=17.5),
        "there 20 a step later is more than 17.5 at once: what follows is multiplied by γ = 0.9, and by no less",
    ),
    Riddle(
        _alike,
        "after the end a number is seen that other states have, too: what comes then is worth 0, so with `terminated`"
        " the target is R alone",
    ),
    Riddle(
        _cut,
        "its episodes are truncated, not terminated: the clock was stopped, and the next state still has its value, so"
        " only `terminated` makes R alone the target",
    ),
)


class Watched:
    """The game as a program sees it: a parallel environment that notes what is done, and shows nothing else.

    Attributes:
        actions: the pairs of actions so far.
    """

    def __init__(self, game: House, n_steps: int, seed: int) -> None:
        """Let at most `n_steps` be taken, and those to the end of the episode."""
        self.possible_agents = [*PLAYERS]
        self.actions: list[tuple[int, int]] = []
        self._env, self._most, self._seed = GameEnv(game), n_steps, APART + seed
        self._has_begun, self._is_new = False, False

    @property
    def agents(self) -> list[str]:
        """Who plays: both, or nobody when the episode is over."""
        return self._env.agents

    def observation_space(self, agent: str) -> Any:
        """The numbers of places."""
        return self._env.observation_space(agent)

    def action_space(self, agent: str) -> Any:
        """The numbers of actions."""
        return self._env.action_space(agent)

    def reset(self, seed: int | None = None, options: Any = None) -> Any:
        """Begin an episode."""
        if self._has_begun and seed is not None:
            raise WrongAnswer(
                f"{NAME} calls reset(seed=...) more than once: give the seed at the first reset only, and call reset()"
                " after that"
            )
        if not self._has_begun and seed is None:
            raise WrongAnswer(f"{NAME} {UNSEEDED} environment.reset(seed=seed)")
        if self._has_begun and not self._is_new and self.agents:
            raise WrongAnswer(
                f"{NAME} calls reset() in the middle of an episode: go on until `environment.agents` is empty"
            )
        first, self._has_begun, self._is_new = None if self._has_begun else self._seed, True, True
        return self._env.reset(seed=first)

    def step(self, actions: Any) -> Any:
        """Let both act."""
        if self._is_new and len(self.actions) >= self._most:
            raise WrongAnswer(
                f"{NAME} begins another episode after its {self._most} steps: count the steps of all episodes"
            )
        came, self._is_new = self._env.step(actions), False
        first, second = (int(actions[name]) for name in PLAYERS)
        self.actions.append((first, second))
        return came


def run(program: Any, game: House, n_steps: int, seed: int) -> tuple[list[tuple[int, int]], Reals]:
    """Run a program, and return the actions that it took and its policy: shape (n_places, n_actions).

    Raises:
        WrongAnswer: it breaks the contract.
    """
    require_function(NAME, program, "environment, n_steps and seed")
    call, watched = f"{NAME}(environment, {n_steps}, {seed})", Watched(game, n_steps, seed)
    with student_code(call):
        try:
            policy = program(watched, n_steps, seed)
        except ResetNeeded:
            raise WrongAnswer(
                f"{NAME} takes a step where no episode is under way: call reset() at first, and whenever"
                " `environment.agents` is empty"
            ) from None
    if len(watched.actions) < ENOUGH * n_steps:
        raise WrongAnswer(
            f"{NAME} takes {len(watched.actions)} of its {n_steps} steps: go on, episode after episode, until all are"
            " taken"
        )
    if policy is None or not callable(policy):
        raise WrongAnswer(
            f"{call} should return the policy of player_0, a function from a state to the probabilities of its actions,"
            f" but returns {in_short(policy)}: for a table that is `lambda state: policy[state]`"
        )
    return watched.actions, np.array([_probabilities(policy, place) for place in range(1 + len(game.rooms))])


def _probabilities(policy: Callable[[int], Any], place: int) -> Reals:
    """Return what a policy says of a place.

    Raises:
        WrongAnswer: it is no probability for each action.
    """
    call = POLICY
    with student_code(call):
        given = policy(place)
        found = np.asarray(given, float)
    wrong = found.shape != (N_ACTIONS,) or not (found >= 0).all() or abs(found.sum() - 1) > 1e-6
    if wrong:
        one = ": that is one action, and the probability of each is asked" if found.ndim == 0 else ""
        raise WrongAnswer(
            f"{call} should give {N_ACTIONS} probabilities that sum to 1, one for each action, but for state {place} it"
            f" gives {in_short(given)}{one}"
        )
    return found


def weak_points(model: GameModel, policy: Reals) -> Reals:
    """Return for each place how much less than its value a policy guarantees there, computed exactly."""
    values = minimax_value_iteration(model, DISCOUNT)
    against = value_iteration(model.against(1, policy), DISCOUNT)
    return np.array([values.value(place) + against.value(place) for place in range(policy.shape[0])])


def check_riddle(program: Any, riddle: Riddle, seed: int) -> float:
    """Check that a program plays a riddle safely, and return the most that can be won from it.

    Raises:
        WrongAnswer: it does not, or it breaks the contract.
    """
    game = riddle.make(np.random.default_rng(seed))
    model = game_model(game)
    _, policy = run(program, game, N_STEPS, seed)
    weak = weak_points(model, policy)
    if weak.max() < NEAR:
        return float(weak.max())
    place = int(weak.argmax())
    why = "" if nobody_asks_why() else _cause(program, riddle, game, policy, place, seed)
    raise WrongAnswer(
        f"in a small game with {len(weak)} states, who knows the policy of {NAME} wins {weak[place]:.2f} more from it"
        f" in state {place} than from a safe one. {why}"
    )


def _cause(program: Any, riddle: Riddle, game: House, policy: Reals, place: int, seed: int) -> str:
    """Return the sentence about what is likely wrong."""
    if riddle is ROOMS:
        if np.abs(policy - 1 / N_ACTIONS).max() < 0.01:
            return (
                "It is random play: does the policy that is returned come from what was learned, and is the last step"
                " of an episode learned from, too?"
            )
        worth = game.rooms[1].sum(axis=1)
        if policy[2, worth.argmin()] > SURE:
            return (
                "In one room it takes the worst action: is the reward that of player_0, with its own sign, and are"
                " its actions the rows of the matrix game, and the probabilities that are returned its own?"
            )
        if policy[2, worth.argmax()] < SURE / 2:
            return (
                "In one room an action is best whatever the other does, and it is not taken: are the rows of the matrix"
                " game the actions of player_0, is it the game of the state in which they acted, and does an episode"
                " begin with the state that reset gives?"
            )
        if policy[1].max() > SURE:
            return (
                "It has no chance in it: the best action against what the other does now is known to the other, too;"
                " the policy is that of the matrix game, as solve_zero_sum finds it. (It has none either"
                " where hardly any pair of actions was tried: are some moves random?)"
            )
    longer = run(program, game, LONGER * N_STEPS, seed)[1]
    before, after = (weak_points(game_model(game), one).max() for one in (policy, longer))
    if after < max(NEAR, SLOW * before):
        return (
            f"After {LONGER * N_STEPS} steps only {after:.2f} can be won, so it learns too slowly: is the learning"
            " rate, or the share of random actions, too small, is not every *pair* of actions learned, does player_1"
            " learn from its own reward, or does something count that comes after `terminated`?"
        )
    return f"Look at this state: {riddle.asks}"


def _require_reproducible(program: Any, seed: int) -> None:
    """Refuse a program that does not repeat itself with its seed.

    Raises:
        WrongAnswer: so it is, or it breaks the contract.
    """
    game = RIDDLES[1].make(np.random.default_rng(seed))
    first, again = (run(program, game, TRIAL, seed)[0] for _ in range(2))
    if first != again:
        raise WrongAnswer(
            f"{NAME} does not repeat itself: two runs with seed {seed} take different actions. Draw every random number"
            " from rng = np.random.default_rng(seed), and make all that it learns inside the function"
        )


def project_13(answer: Any, seed: int) -> str:
    """Check a program that trains two players and returns the policy of the first."""
    _require_reproducible(answer, seed)
    most = max(check_riddle(answer, riddle, seed) for riddle in RIDDLES)
    return f"Right: in six small games the best opponent wins at most {most:.2f} more from it than from a safe policy."
