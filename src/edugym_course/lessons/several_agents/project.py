"""The project of lesson 13: a player that nobody can exploit, from a blank file.

A program trains both players of a game by a loop of its own, and returns the policy of player 0. It is judged by what
the best opponent wins from this policy, computed exactly, in riddles: small games that cannot be played safely if one
part of the method is missing.
"""

from collections.abc import Callable
from typing import Any

import numpy as np
from gymnasium.error import ResetNeeded

from edugym.adapters.parallel_env import PLAYERS, GameEnv
from edugym.checks.parameters import in_short
from edugym.exact.game_model import GameModel, game_model
from edugym.exact.shapley import minimax_value_iteration
from edugym.exact.value_iteration import value_iteration
from edugym.mdp.protocol import Reals
from edugym_course.grading.agents import require_function
from edugym_course.grading.errors import WrongAnswer, nobody_asks_why
from edugym_course.grading.programs import APART, NAME, POLICY, UNSEEDED, require_steps
from edugym_course.grading.student_code import student_code
from edugym_course.lessons.several_agents.houses import (
    AFTER_THE_END,
    BACK,
    CHANCE,
    HALL,
    N_ACTIONS,
    RIDDLES,
    ROOMS,
    TRAPS,
    House,
    Riddle,
)
from edugym_course.lessons.several_agents.methods import DISCOUNT

N_STEPS, TRIAL, LONGER = 6_000, 60, 4
"""Training steps in a riddle, in a first trial, and how many times as long a slow program may take."""
NEAR = 0.2
"""How much less than the value of a place a policy may guarantee there."""
SLOW = 0.6
"""Who still loses much, but less than this share of it after longer training, learns too slowly."""
SURE = 0.99
"""An action with this probability or more leaves nothing to chance."""
NO_CHANCE = (
    "It has no chance in it: the best action against what the other does now is known to the other, too; the policy is"
    " that of the matrix game, as solve_zero_sum finds it. (It has none either where hardly any pair of actions was"
    " tried: are some moves random?)"
)
SAME = (
    "It is the same in each state: does it look up the state that it is given, and has Q[state] one value for each"
    " *pair* of actions, of which only that of the pair just taken moves?"
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
    """Run a program, and return the actions that it took, and its policy by what is seen: shape (n_places, n_actions).

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
    require_steps(len(watched.actions), n_steps, is_over=not watched.agents)
    if policy is None or not callable(policy):
        raise WrongAnswer(
            f"{call} should return the policy of player_0, a function from a state to the probabilities of its actions,"
            f" but returns {in_short(policy)}: for a table that is `lambda state: policy[state]`"
        )
    return watched.actions, np.array([_probabilities(policy, number) for number in range(1 + len(game.rooms))])


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
    if riddle.again and (again := max(_won(program, riddle, seed + one) for one in (1, 2))) < NEAR:
        return again
    place = int(weak.argmax())
    why = "" if nobody_asks_why() else _cause(program, riddle, game, policy, place, seed)
    raise WrongAnswer(
        f"in a small game with {len(weak)} states, who knows the policy of {NAME} wins {weak[place]:.2f} more from it"
        f" in state {game.number(place)} than from a safe one. {why}"
    )


def _won(program: Any, riddle: Riddle, seed: int) -> float:
    """Return the most that can be won from a program in a house of a riddle that is tried again."""
    game = riddle.make(np.random.default_rng(seed))
    return float(weak_points(game_model(game), run(program, game, riddle.again * N_STEPS, seed)[1]).max())


def _cause(program: Any, riddle: Riddle, game: House, policy: Reals, place: int, seed: int) -> str:
    """Return the sentence about what is likely wrong."""
    if riddle is ROOMS:
        if np.abs(policy - 1 / N_ACTIONS).max() < 0.01:
            return (
                "It is random play: does the policy that is returned come from what was learned, and is the last step"
                " of an episode learned from, too?"
            )
        is_same = np.abs(policy - policy[0]).max() == 0
        if is_same and policy[0].max() > SURE:
            return f"{NO_CHANCE} {SAME}"
        if is_same:
            return SAME
        worth = game.rooms[1].sum(axis=1)
        first, second = (policy[game.number(place)] for place in (1, 2))
        if second[worth.argmin()] > SURE:
            return (
                "In one room it takes the worst action: is the reward that of player_0, with its own sign, and are"
                " its actions the rows of the matrix game, and the probabilities that are returned its own?"
            )
        if second[worth.argmax()] < SURE / 2:
            return (
                "In one room an action is best whatever the other does, and it is not taken: are the rows of the matrix"
                " game the actions of player_0, is it the game of the state in which they acted, and does an episode"
                " begin with the state that reset gives?"
            )
        if first.max() > SURE:
            return NO_CHANCE
    if riddle is CHANCE:
        return f"Look at this state: {riddle.asks}"
    if riddle is TRAPS and place == HALL:
        return f"Look at this state: {BACK}"
    apart = game._replace(is_apart=True)
    if riddle is not ROOMS and weak_points(game_model(game), run(program, apart, N_STEPS, seed)[1]).max() < NEAR:
        return f"Look at the end of an episode: {AFTER_THE_END}"
    longer = run(program, game, LONGER * N_STEPS, seed)[1]
    before, after = (weak_points(game_model(game), one).max() for one in (policy, longer))
    if after < max(NEAR, SLOW * before):
        return (
            f"After {LONGER * N_STEPS} steps only {after:.2f} can be won. Either it learns too slowly (is the learning"
            " rate, or the share of random actions, too small, is not every *pair* of actions learned, does player_1"
            " learn from its own reward, and play a policy of its own?), or something disturbs what it learns (is S'"
            " what step() gave last, and is the target R alone with `terminated`?)"
        )
    return f"Look at this state: {riddle.asks}"


def _require_reproducible(program: Any, seed: int) -> None:
    """Refuse a program that does not repeat itself with its seed.

    Raises:
        WrongAnswer: so it is, or it breaks the contract.
    """
    game = TRAPS.make(np.random.default_rng(seed))
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
    n = len(RIDDLES)
    return f"Right: in {n} small games the best opponent wins at most {most:.2f} more from it than from a safe policy."
