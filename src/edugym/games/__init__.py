"""Games of two players: what happens when another learns too, with exact values and exploitability."""

from edugym.games.against import against
from edugym.games.fictitious_play import FictitiousPlay
from edugym.games.fixed_player import FixedPlayer
from edugym.games.learned_policy import learned_policy
from edugym.games.matrix_games import (
    Chicken,
    MatchingPennies,
    PrisonersDilemma,
    RockPaperScissors,
    StagHunt,
    matrix_game,
)
from edugym.games.minimax_q import MinimaxQ
from edugym.games.model import expected_returns, exploitability, game_model
from edugym.games.parallel_env import parallel_env
from edugym.games.policies import uniform_policy
from edugym.games.protocol import table_shape
from edugym.games.shapley import minimax_value_iteration
from edugym.games.soccer import Soccer
from edugym.games.train_players import GameRun, train_players
from edugym.games.zero_sum import solve_zero_sum

__all__ = [
    "Chicken",
    "FictitiousPlay",
    "FixedPlayer",
    "GameRun",
    "MatchingPennies",
    "MinimaxQ",
    "PrisonersDilemma",
    "RockPaperScissors",
    "Soccer",
    "StagHunt",
    "against",
    "expected_returns",
    "exploitability",
    "game_model",
    "learned_policy",
    "matrix_game",
    "minimax_value_iteration",
    "parallel_env",
    "solve_zero_sum",
    "table_shape",
    "train_players",
    "uniform_policy",
]
