"""Training two players of a game against each other."""

import math
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from edugym.checks.agents import checked_agent
from edugym.checks.contract import IN_GAMES, Contract, forget_episode, learner
from edugym.checks.games import CheckedGame
from edugym.checks.mdps import CHECKED_STEPS
from edugym.checks.parameters import in_short, number_of_steps, whole_number
from edugym.checks.tracebacks import end_at_students_line
from edugym.compiled.execution import executable
from edugym.mdp.against import against
from edugym.mdp.game_guard import guarded
from edugym.mdp.markov_game import require_game
from edugym.mdp.player_policies import uniform_policy
from edugym.mdp.protocol import Integers, Reals
from edugym.system.interrupts import Interrupted
from edugym.system.packages import is_own
from edugym.training.game_loops import GameLog, play, start
from edugym.training.learned_policy import policy_of
from edugym.training.player_contract import player_contract
from edugym.training.steps import take_steps
from edugym.training.trainers import NO_LIMIT, Chunk


@dataclass(frozen=True)
class GameRun:
    """What one training run of two players produced.

    Attributes:
        steps: shape (n_points,): the number of training steps to each point; the first is at 0.
        policies: for each point the policies of both players, as `exploitability` takes them.
        training_returns: shape (n_points, 2): the mean undiscounted return of each player in the training episodes that
            ended since the previous point; NaN where none ended.
        episodes: shape (n_points,): the number of training episodes that ended since the previous point.
        agents: the trained players. They share their tables with the agents that you passed in.
        seed: the seed from which every random stream of this run comes.
        seconds: the time it took, with compiling.
        complete: False if it was stopped before its last point.
    """

    steps: Integers
    policies: list[tuple[Reals, Reals]]
    training_returns: Reals
    episodes: Integers
    agents: tuple[Any, Any]
    seed: int
    seconds: float
    complete: bool


def train_players(
    game: Any,
    agents: Any,
    n_steps: int,
    *,
    max_steps: int | None = None,
    evaluate_every: int | None = None,
    seed: int = 0,
    progress: bool = False,
    stop: Any = None,
) -> GameRun:
    """Train the two players of a game against each other, both of which learn after every step.

        game = games.Soccer.create()
        agents = games.MinimaxQ.create(game, 0), games.MinimaxQ.create(game, 1)
        run = games.train_players(game, agents, 100_000)
        games.exploitability(games.game_model(game), run.policies[-1], discount=0.9)

    A player is an agent as `edugym.train` takes it, with tables of the shape `table_shape(game, player)`. Its `learn`
    may also have the parameter `other_action`: what the other player has done in the same step. Agents that learn from
    their next action, such as SARSA, are refused. From 5000 steps on, the loop is compiled to machine code where that
    is possible.

    Args:
        game: the game.
        agents: the pair of players 0 and 1; their tables are changed in place. The same agent may play both sides, if
            it fits both.
        n_steps: the number of training steps, 1 or more.
        max_steps: the step at which an episode is truncated; by default the game's own limit, if it has one.
        evaluate_every: the steps between two points; by default `n_steps // 10`, at least 1.
        seed: the seed of all random streams. If you create the agents anew and use the same seed, you get the same
            tables, bit for bit.
        progress: whether to show a progress bar.
        stop: a `threading.Event`. When it is set, training stops early and the `GameRun` so far is returned.

    Raises:
        ValueError: a parameter is not as above, or the game or a player does what it may not.
        Interrupted: Ctrl-C was pressed. Its `partial` is the `GameRun` so far.
    """
    n_steps = number_of_steps("n_steps", n_steps)
    every = max(1, n_steps // 10) if evaluate_every is None else whole_number("evaluate_every", evaluate_every, 1)
    seed = whole_number("seed", seed, 0)
    require_game(game)
    limit = getattr(game, "max_steps", None) if max_steps is None else number_of_steps("max_steps", max_steps)
    contracts = _players(game, agents)
    began, points = time.perf_counter(), _Points(game, contracts)

    def begin(expected: int) -> "_Training":
        return _Training(game, contracts, seed, limit or NO_LIMIT, expected)

    def measure(steps: int, training: "_Training", _: Callable[[], bool]) -> None:
        points.add(steps, training.log)

    try:
        taken = take_steps(n_steps, begin, measure, measure_every=every, stop=stop, progress=progress)
    except Exception as error:
        end_at_students_line(error)
        raise
    run = points.run(seed, time.perf_counter() - began, n_steps)
    if taken.interrupted:
        raise Interrupted(f"after {taken}; the players keep what they have learned", lambda: run)
    return run


def _players(game: Any, agents: Any) -> tuple[Contract, Contract]:
    """The contracts of both players, if they fit the game."""
    if not isinstance(agents, tuple | list) or len(agents) != 2 or hasattr(agents, "_fields"):
        raise ValueError(f"agents must be a pair, player 0 and player 1, but is {in_short(agents)}")
    first, second = (player_contract(game, player, agent) for player, agent in enumerate(agents))
    return first, second


class _Training:
    """Trains both players. The first steps of students' code run interpreted and checked; they are part of the run."""

    def __init__(self, game: Any, contracts: tuple[Contract, Contract], seed: int, limit: int, expected: int) -> None:
        for contract in contracts:
            forget_episode(contract.agent)
        self.log, self._chunk, self._expected = GameLog(np.zeros(2), np.zeros(1, np.int64)), Chunk(), expected
        streams = [np.random.default_rng(child) for child in np.random.SeedSequence(seed).spawn(3)]
        players = [learner(contract, IN_GAMES) for contract in contracts]
        self._is_own = is_own(game) and all(contract.is_own for contract in contracts)
        self._seats = [against(game, player, uniform_policy(game, 1 - player)) for player in (0, 1)]
        self._game, rest = game, (*players, limit, *streams, self.log)
        self._plain = (game if self._is_own else guarded(game), *rest)
        self._slow = self._checked(*self._plain)
        self._carry = start(self._slow[0], streams[0])
        self._steps_to_check = 0 if self._is_own else CHECKED_STEPS
        self._play: Callable[..., Any] = play
        if self._is_own:
            self._compile()

    @property
    def is_compiled(self) -> bool:
        """Whether it runs as machine code by now."""
        return self._play is not play

    def learn(self, at_most: int) -> int:
        """Take training steps for about 0.02 s; return their number."""
        with self._chunk.steps(min(at_most, self._steps_to_check or at_most)) as n_steps:
            self._carry = self._play(n_steps, *(self._plain if self.is_compiled else self._slow), self._carry)
        if self._steps_to_check:
            self._steps_to_check -= n_steps
            if not self._steps_to_check:
                self._compile()
        return n_steps

    def _compile(self) -> None:
        interpreted: Callable[..., Any] = play

        def replay(n: int, *arguments: Any) -> Any:
            *others, carry = arguments
            return interpreted(n, *self._checked(*others, steps=math.inf), carry)

        self._play = executable(play, (*self._plain, self._carry), expected=self._expected, replay=replay)

    def _checked(self, _: Any, first: Any, second: Any, *rest: Any, steps: float = CHECKED_STEPS) -> tuple[Any, ...]:
        """The arguments of `play`, with checks in place of the guard, which explain what is wrong."""
        checked = self._game if is_own(self._game) else CheckedGame(self._game)
        players = (checked_agent(one, seat, steps) for one, seat in zip((first, second), self._seats, strict=True))
        return checked, *players, *rest


class _Points:
    """What is kept of a run so far."""

    def __init__(self, game: Any, contracts: tuple[Contract, Contract]) -> None:
        self._game, self._contracts = game, contracts
        self._points: list[tuple[int, tuple[Reals, Reals], Reals, int]] = []

    def add(self, steps: int, log: GameLog) -> None:
        """Note the policies of now, and the returns since the last point."""
        first, second = (policy_of(self._game, player, contract) for player, contract in enumerate(self._contracts))
        ended = int(log.episodes[0])
        means = log.returns / ended if ended else np.full(2, math.nan)
        self._points.append((steps, (first, second), means, ended))  # Ctrl-C cannot leave half a point
        log.returns[:] = 0.0
        log.episodes[0] = 0

    def run(self, seed: int, seconds: float, n_steps: int) -> GameRun:
        """The run with these points."""
        steps, policies, means, ended = zip(*self._points, strict=True) if self._points else ((),) * 4
        first, second = self._contracts
        return GameRun(
            np.array(steps, np.int64),
            list(policies),
            np.array(means, float).reshape(-1, 2),
            np.array(ended, np.int64),
            (first.agent, second.agent),
            seed,
            seconds,
            complete=bool(steps) and steps[-1] == n_steps,
        )
