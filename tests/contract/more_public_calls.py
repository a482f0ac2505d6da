"""As `public_calls`, of the rooms that are not at the top of `edugym`: figures, statistics, widgets, grading."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import edugym
from edugym import deep, objectives
from edugym.experiments import figures
from edugym_course import grading, notebook
from tests.contract.public_calls import ANY, NOT_NEGATIVE, NUMBER, WHOLE, Case, diver_env, known, player_of_one, row


def drawn(kind: Any, takes: dict[str, str], /, **given: Any) -> Case:
    """A panel, which checks its attributes when it is drawn."""
    return Case(lambda **attributes: kind(**attributes).draw(), kind._field_defaults | given, takes)


def right(answer: Any, seed: int) -> str:
    """An exercise that any answer solves."""
    return f"{type(answer).__name__} {seed}"


def challenge() -> Any:
    """A small one."""
    return grading.Challenge("Boulder", {"height": 3}, 9, {"b": edugym.SARSA.create}, 1.0, 1.0, 1)


CALLS: dict[str, Callable[[], Case]] = {
    "figures.Curves": lambda: drawn(
        figures.Curves,
        {"title": "text", "methods": "[]", "optimum": NUMBER, "soft_optimum": NUMBER, "soft_label": "text",
         "y_label": "text"},
        results=known().results),
    "figures.Curves.draw": lambda: Case(lambda ax: figures.Curves(known().results).draw(ax), {"ax": None}),
    "figures.Curves.points": lambda: row({}, figures.Curves(known().results).points),
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
    "games.Chicken.create": lambda: row({"crash": NUMBER}),
    "games.PrisonersDilemma.create": lambda: row({"temptation": NUMBER}),
    "games.StagHunt.create": lambda: row({"hare": NUMBER}),
    "games.matrix_game": lambda: row({"second": "None"}, first=[[1]]),
    "games.MinimaxQ.create": lambda: row({"decay": "0"}),
    "games.train_players": lambda: row({"evaluate_every": "1e30 1e400"}, agents=[player_of_one()] * 2),
    "games.Soccer.create": lambda: row({"contact": "0"}),
    "games.parallel_env": lambda: pytest.importorskip("pettingzoo") and row({"render_mode": "None"}),
    "games.solve_zero_sum": lambda: row(payoffs=[[1]]),
    "objectives.ChebyshevQLearning.create": lambda: row(
        {"weights": "None", "margin": NOT_NEGATIVE, "whole_returns": ""}),
    "objectives.LagrangianQLearning.create": lambda: row(
        {"initial_values": "None", "multiplier_rate": NOT_NEGATIVE}, limits=[-7.0]),
    "objectives.Weighted.create": lambda: row(weights=[1, 4]),
    "objectives.constrained_optimum": lambda: row({"limit": NUMBER}, limit=0),
    "objectives.train_vectors": lambda: row(
        {"max_steps": "None", "evaluate_every": "None 1e30 1e400", "stop": "None"},
        environment="Diver", agent=objectives.ParetoQLearning.create(edugym.make_mdp("Diver"))),
    "objectives.VectorRewardEnv.reset": lambda: row({"options": ANY}),
    "objectives.VectorRewardEnv.step": lambda: row({}, lambda action: diver_env().step(action)),
    "statistics.exactly": lambda: row({"value": NUMBER}, value=1),
    "statistics.share_interval": lambda: row({"values": "[] array"}, values=[0, 1]),
    "statistics.by_point": lambda: row(values=np.zeros((2, 3))),
    "tables.joined": lambda: row(parts=[known().results]),
    "deep.PPO.create": lambda: row({"clip": "2.5 1e30", "entropy_bonus": NOT_NEGATIVE}),
    "deep.PPO.train": lambda: row(
        {"evaluate_every": "1e30 1e400", "seed": "0"},
        deep.PPO.create(known().walk, num_envs=2, length=2, epochs=1, minibatches=1).train,
        n_steps=4, evaluation_episodes=1),
    "deep.stable_baselines3_env": lambda: row(
        {"num_envs": "None"}, lambda environment, num_envs: deep.stable_baselines3_env(environment, num_envs),
        num_envs=2),
    "deep.stable_baselines3_run": lambda: row(
        {"num_envs": "None", "policy": "None", "parameters": "None", "evaluate_every": "None 1e30 1e400", "seed": "0"},
        lambda environment, algorithm, n_steps, **others: deep.stable_baselines3_run(
            environment, algorithm, n_steps, **others),
        algorithm="A2C", n_steps=10, num_envs=2, policy="MlpPolicy", parameters={}, evaluate_every=10,
        evaluation_episodes=1, seed=0),
    "notebook.frames": lambda: Case(
        lambda *, actor, environment, seed, max_steps, frames_per_second: notebook.frames(
            environment, actor, seed=seed, max_steps=max_steps, frames_per_second=frames_per_second),
        {"environment": known().walk, "actor": known().agent, "seed": 0, "max_steps": 9, "frames_per_second": 4},
        {"actor": "[] function", "frames_per_second": "2.5"}, {"actor": "action"}),
    "notebook.play": lambda: Case(
        lambda *, environment, blind, seed: notebook.play(environment, blind=blind, seed=seed),
        {"environment": known().walk, "blind": False, "seed": 0}, {"seed": f"None {WHOLE}"}),
    "notebook.predict": lambda: row({"question": "text", "unit": "text"}, question="a?"),
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
    "grading.seed_from_name": lambda: row({"name": "text -1 0 1e30 1e400"}, name="Ada"),
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
    return row(takes, kinds[name].load_mdp().create)
