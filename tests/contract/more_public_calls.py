"""As `public_calls`, of the rooms that are not at the top of `edugym`: figures, statistics, widgets, grading."""

from collections.abc import Callable
from typing import Any

import numpy as np

import edugym
from edugym import deep, games, objectives
from edugym.experiments import figures
from edugym.experiments.results import statistics, tables
from edugym_course import grading, notebook
from tests.contract.public_calls import ANY, NOT_NEGATIVE, NUMBER, WHOLE, Case, known


def drawn(kind: Any, takes: dict[str, str], /, **given: Any) -> Case:
    """A panel, which checks its attributes when it is drawn."""
    return Case(lambda **attributes: kind(**attributes).draw(), kind._field_defaults | given, takes)


def right(answer: Any, seed: int) -> str:
    """An exercise that any answer solves."""
    return f"{type(answer).__name__} {seed}"


def challenge() -> Any:
    """A small one."""
    return grading.Challenge("Boulder", {"height": 3}, 9, {"b": edugym.SARSA.create}, 1.0, 1.0, 1)


def game_of_one() -> Any:
    """The smallest game: each player has one action."""
    return games.matrix_game([[1]])


def diver_env() -> Any:
    """Vectors as rewards, in an episode."""
    env = objectives.VectorRewardEnv(edugym.make_mdp("Diver"))
    env.reset(seed=0)
    return env


def player_of_one() -> Any:
    """A player of it."""
    return edugym.QLearning.create((1, 1))


CALLS: dict[str, Callable[[], Case]] = {
    "figures.Curves": lambda: drawn(
        figures.Curves,
        {"title": "text", "methods": "[]", "optimum": NUMBER, "soft_optimum": NUMBER, "soft_label": "text",
         "y_label": "text"},
        results=known().results),
    "figures.Curves.draw": lambda: Case(lambda ax: figures.Curves(known().results).draw(ax), {"ax": None}),
    "figures.Curves.points": lambda: Case(figures.Curves(known().results).points, {"method": "a"}),
    "figures.Lines": lambda: drawn(
        figures.Lines, {"title": "text", "x_label": "text", "y_label": "text"}, x=[1, 2], lines={"a": [1, 2]}, theory={}
    )._replace(named={"x": "lines"}),
    "figures.Lines.draw": lambda: Case(lambda ax: figures.Lines(np.ones(1), {"a": np.ones(1)}).draw(ax), {"ax": None}),
    "figures.Sheet": lambda: drawn(
        figures.Sheet, {"name": "text", "rows": "[]"}, name="a", rows=[[figures.Curves(known().results)]]),
    "figures.VisitMap": lambda: drawn(
        figures.VisitMap, {"title": "text", "y_label": "text"}, visits=np.ones((2, 3)), n_steps=9),
    "figures.VisitMap.draw": lambda: Case(lambda ax: figures.VisitMap(np.ones((2, 3)), 9).draw(ax), {"ax": None}),
    "figures.save_figure": lambda: Case(
        figures.save_figure,
        {"figure": figures.Curves(known().results).draw(), "path": known().folder / "figure"}, {"path": "text"}),
    "games.Chicken.create": lambda: Case(games.Chicken.create, {}, {"crash": NUMBER}),
    "games.PrisonersDilemma.create": lambda: Case(games.PrisonersDilemma.create, {}, {"temptation": NUMBER}),
    "games.StagHunt.create": lambda: Case(games.StagHunt.create, {}, {"hare": NUMBER}),
    "games.MatchingPennies.create": lambda: Case(games.MatchingPennies.create, {}),
    "games.RockPaperScissors.create": lambda: Case(games.RockPaperScissors.create, {}),
    "games.against": lambda: Case(
        games.against, {"game": game_of_one(), "player": 0, "policy": [[1]]}, {"player": "0"}),
    "games.expected_returns": lambda: Case(
        games.expected_returns, {"model": games.game_model(game_of_one()), "policies": ([[1]], [[1]])}),
    "games.exploitability": lambda: Case(
        games.exploitability, {"model": games.game_model(game_of_one()), "policies": ([[1]], [[1]])}),
    "games.game_model": lambda: Case(games.game_model, {"game": game_of_one()}),
    "games.matrix_game": lambda: Case(games.matrix_game, {"first": [[1]]}, {"second": "None"}),
    "games.FictitiousPlay.create": lambda: Case(
        games.FictitiousPlay.create, {"game": game_of_one(), "player": 0}, {"player": "0"}),
    "games.FixedPlayer.create": lambda: Case(
        games.FixedPlayer.create, {"game": game_of_one(), "player": 0, "policy": [[1]]}, {"player": "0"}),
    "games.MinimaxQ.create": lambda: Case(
        games.MinimaxQ.create, {"game": game_of_one(), "player": 0}, {"player": "0", "decay": "0"}),
    "games.learned_policy": lambda: Case(
        games.learned_policy, {"game": game_of_one(), "player": 0, "agent": player_of_one()}, {"player": "0"}),
    "games.train_players": lambda: Case(
        games.train_players, {"game": game_of_one(), "agents": [player_of_one()] * 2, "n_steps": 9},
        {"evaluate_every": "1e30 1e400"}),
    "games.Soccer.create": lambda: Case(games.Soccer.create, {}, {"contact": "0"}),
    "games.minimax_value_iteration": lambda: Case(
        games.minimax_value_iteration, {"model": games.game_model(games.matrix_game([[1]]))}),
    "games.parallel_env": lambda: Case(games.parallel_env, {"game": game_of_one()}, {"render_mode": "None"}),
    "games.solve_zero_sum": lambda: Case(games.solve_zero_sum, {"payoffs": [[1]]}),
    "games.table_shape": lambda: Case(games.table_shape, {"game": game_of_one(), "player": 0}, {"player": "0"}),
    "games.uniform_policy": lambda: Case(games.uniform_policy, {"game": game_of_one(), "player": 0}, {"player": "0"}),
    "objectives.ChebyshevQLearning.create": lambda: Case(
        objectives.ChebyshevQLearning.create, {"environment": edugym.make_mdp("Diver")},
        {"weights": "None", "margin": NOT_NEGATIVE, "whole_returns": ""}),
    "objectives.LagrangianQLearning.create": lambda: Case(
        objectives.LagrangianQLearning.create, {"environment": edugym.make_mdp("Diver"), "limits": [-7.0]},
        {"initial_values": "None", "multiplier_rate": NOT_NEGATIVE}),
    "objectives.ParetoQLearning.create": lambda: Case(
        objectives.ParetoQLearning.create, {"environment": edugym.make_mdp("Diver")}),
    "objectives.Weighted.create": lambda: Case(
        objectives.Weighted.create, {"mdp": edugym.make_mdp("Diver"), "weights": [1, 4]}),
    "objectives.constrained_optimum": lambda: Case(
        objectives.constrained_optimum, {"points": [[1, 2]], "limit": 0}, {"limit": NUMBER}),
    "objectives.table_shape": lambda: Case(objectives.table_shape, {"environment": edugym.make_mdp("Diver")}),
    "objectives.train_vectors": lambda: Case(
        objectives.train_vectors,
        {"environment": "Diver", "agent": objectives.ParetoQLearning.create(edugym.make_mdp("Diver")), "n_steps": 9},
        {"max_steps": "None", "evaluate_every": "None 1e30 1e400", "stop": "None"}),
    "objectives.VectorRewardEnv": lambda: Case(objectives.VectorRewardEnv, {"mdp": edugym.make_mdp("Diver")}),
    "objectives.VectorRewardEnv.descriptive_model": lambda: Case(
        diver_env().descriptive_model, {"state": 0, "action": 0}),
    "objectives.VectorRewardEnv.generative_model": lambda: Case(
        diver_env().generative_model, {"state": 0, "action": 0}),
    "objectives.VectorRewardEnv.model": lambda: Case(diver_env().model, {"state": 0, "action": 0}),
    "objectives.VectorRewardEnv.reset": lambda: Case(diver_env().reset, {}, {"options": ANY}),
    "objectives.VectorRewardEnv.step": lambda: Case(lambda action: diver_env().step(action), {"action": 0}),
    "objectives.exact_front": lambda: Case(objectives.exact_front, {"mdp": edugym.make_mdp("Diver")}),
    "objectives.pareto_front": lambda: Case(objectives.pareto_front, {"points": [[1, 2]]}),
    "objectives.supported": lambda: Case(objectives.supported, {"points": [[1, 2]]}),
    "statistics.exactly": lambda: Case(statistics.exactly, {"value": 1}, {"value": NUMBER}),
    "statistics.share_interval": lambda: Case(statistics.share_interval, {"values": [0, 1]}, {"values": "[] array"}),
    "statistics.by_point": lambda: Case(statistics.by_point, {"values": np.zeros((2, 3))}),
    "tables.joined": lambda: Case(tables.joined, {"parts": [known().results]}),
    "deep.PPO.create": lambda: Case(
        deep.PPO.create, {"environment": known().walk}, {"clip": "2.5 1e30", "entropy_bonus": NOT_NEGATIVE}),
    "deep.PPO.train": lambda: Case(
        deep.PPO.create(known().walk, num_envs=2, length=2, epochs=1, minibatches=1).train,
        {"n_steps": 4, "evaluation_episodes": 1}, {"evaluate_every": "1e30 1e400", "seed": "0"}),
    "deep.stable_baselines3_env": lambda: Case(
        lambda environment, num_envs: deep.stable_baselines3_env(environment, num_envs),
        {"environment": known().walk, "num_envs": 2}, {"num_envs": "None"}),
    "deep.stable_baselines3_run": lambda: Case(
        lambda environment, algorithm, n_steps, **others: deep.stable_baselines3_run(
            environment, algorithm, n_steps, **others),
        {"environment": known().walk, "algorithm": "A2C", "n_steps": 10, "num_envs": 2, "policy": "MlpPolicy",
         "parameters": {}, "evaluate_every": 10, "evaluation_episodes": 1, "seed": 0},
        {"num_envs": "None", "policy": "None", "parameters": "None", "evaluate_every": "None 1e30 1e400", "seed": "0"}),
    "notebook.frames": lambda: Case(
        lambda *, actor, environment, seed, max_steps, frames_per_second: notebook.frames(
            environment, actor, seed=seed, max_steps=max_steps, frames_per_second=frames_per_second),
        {"environment": known().walk, "actor": known().agent, "seed": 0, "max_steps": 9, "frames_per_second": 4},
        {"actor": "[] function", "frames_per_second": "2.5"}, {"actor": "action"}),
    "notebook.play": lambda: Case(
        lambda *, environment, blind, seed: notebook.play(environment, blind=blind, seed=seed),
        {"environment": known().walk, "blind": False, "seed": 0}, {"seed": f"None {WHOLE}"}),
    "notebook.predict": lambda: Case(notebook.predict, {"question": "a?"}, {"question": "text", "unit": "text"}),
    "notebook.predict.measured": lambda: Case(
        notebook.predict("a?").measured, {"value": 3}, {"value": NUMBER, "explanation": "text"}),
    "notebook.sliders": lambda: Case(
        lambda *, function, x: notebook.sliders(function, x=x), {"function": lambda x: str(x), "x": (0, 3)},
        named={"function": "control"}),
    "notebook.source": lambda: Case(
        lambda *, subject, names: notebook.source(subject, names), {"subject": edugym.QLearning, "names": "act"},
        {"subject": "agent_class"}, {"subject": "names"}),
    "grading.Challenge": lambda: Case(
        lambda **given: grading.Challenge(**given).score(edugym.QLearning.create, "Ada"),
        {"environment": "Boulder", "parameters": {"height": 3}, "n_steps": 9, "baselines": {"b": edugym.SARSA.create},
         "optimum": 1.0, "best_average": 1.0, "repetitions": 1, "column": "return", "best_label": "best"},
        {"optimum": NUMBER, "best_average": NUMBER, "best_label": "text"}),
    "grading.Challenge.score": lambda: Case(
        challenge().score, {"agent": edugym.QLearning.create, "name": "Ada"},
        {"name": "text -1 0 1e30 1e400"},
        {"agent": "my_agent"}),
    "grading.check": lambda: Case(
        grading.check, {"exercise": right, "answer": 3, "quiet": True}, {"answer": ANY, "exercise": "function"}),
    "grading.seed_from_name": lambda: Case(
        grading.seed_from_name, {"name": "Ada"}, {"name": "text -1 0 1e30 1e400"}),
    "Bandit.create": lambda: of_environment("Bandit", gap="0", drift="0"),
    "Casino.create": lambda: of_environment("Casino", noise="0 2.5", loss="0 2.5", advantage="0 2.5"),
    "Diver.create": lambda: of_environment("Diver", concavity="0"),
    "Golf.create": lambda: of_environment("Golf", green_radius="2.5", stochasticity_level="0 2.5"),
    "Roadrunner.create": lambda: of_environment("Roadrunner", negative_reward="-1 0", stop_zone="0"),
    "Study.create": lambda: of_environment(
        "Study", energy_needed="0", action_reward_noise_mean="0 2.5", action_reward_noise_sigma="0 2.5"),
    "Supermarket.create": lambda: of_environment("Supermarket", noise="0 2.5"),
    "Tamagotchi.create": lambda: of_environment("Tamagotchi", tau="inf 0 2.5 1e30"),
}  # fmt: skip


def of_environment(name: str, **takes: str) -> Case:
    """`create` of an environment of the course."""
    kinds = {entry.name: entry for entry in edugym.ENVIRONMENTS}
    return Case(kinds[name].load_mdp().create, {}, takes)
