"""Games of two players: what happens when another learns too, with exact values and exploitability."""

from edugym.adapters.parallel_env import parallel_env
from edugym.agents.fictitious_play import FictitiousPlay
from edugym.agents.fixed_player import FixedPlayer
from edugym.agents.minimax_q import MinimaxQ
from edugym.envs.games.matrix_games import (
    Chicken,
    MatchingPennies,
    PrisonersDilemma,
    RockPaperScissors,
    StagHunt,
    matrix_game,
)
from edugym.envs.games.soccer import Soccer
from edugym.exact.game_model import expected_returns, exploitability, game_model
from edugym.exact.shapley import minimax_value_iteration
from edugym.exact.zero_sum import solve_zero_sum
from edugym.mdp.against import against
from edugym.mdp.markov_game import table_shape
from edugym.mdp.player_policies import uniform_policy
from edugym.training.learned_policy import learned_policy
from edugym.training.train_players import GameRun, train_players

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
