"""Every public function and class, with a valid call of each, and which odd values each of its parameters takes."""

import inspect
import math
import tempfile
from collections.abc import Callable, Mapping
from functools import cache, wraps
from pathlib import Path
from types import MappingProxyType
from typing import Any, NamedTuple

import gymnasium
import numpy as np
import pytest

import edugym
from tests.compiled.cells import WALK, cell

Walk = cell(WALK)["Walk"]


class Odd:
    """An object of no kind that anything asks for."""

    def __repr__(self) -> str:
        """Short, for messages."""
        return "<Odd>"


@cache
def odd_values() -> dict[str, Any]:
    """What is put in place of each argument, by the names that the table below uses."""
    return {
        "None": None, "text": "nonsense", "nan": math.nan, "inf": math.inf, "-1": -1, "0": 0, "2.5": 2.5,
        "1e30": 10**30, "1e400": 10**400, "[]": [], "object": Odd(), "array": np.zeros((2, 3, 4)),
        "agent_class": edugym.QLearning, "task_class": Walk, "function": lambda *_: None,
    }  # fmt: skip


NUMBER, NOT_NEGATIVE, POSITIVE, WHOLE = "-1 0 2.5 1e30", "0 2.5 1e30", "2.5 1e30", "0 1e30 1e400"
EVERYWHERE: dict[str, str] = {
    "action": "0", "confidence": "0", "discount": "0", "epsilon": "0", "goal_size": "0",
    "exploration_bonus": NOT_NEGATIVE, "initial_value": NUMBER, "layout_seed": WHOLE,
    "planning_seconds": "inf 2.5 1e30", "planning_steps": "0",
    "reward_at_goal": NUMBER, "reward_elsewhere": NUMBER,
    "seed": WHOLE, "state": "0", "threshold": NOT_NEGATIVE, "tolerance": POSITIVE, "trace_decay": "0",
}  # fmt: skip
"""Which odd values a parameter of this name takes wherever it stands, with spaces between; it refuses the others."""


class Case(NamedTuple):
    """A valid call.

    Attributes:
        function: what is called.
        given: the arguments that it needs; the others have their defaults.
        takes: by parameter, the odd values that it takes, as in `EVERYWHERE`.
        named: by parameter, another name by which messages may call it: that of the one with which it does not agree.
    """

    function: Callable[..., Any]
    given: dict[str, Any]
    takes: Mapping[str, str] = MappingProxyType({})
    named: Mapping[str, str] = MappingProxyType({})

    @property
    def valid(self) -> dict[str, Any]:
        """All arguments of the valid call, by name."""
        parameters = inspect.signature(self.function).parameters.values()
        return {one.name: one.default for one in parameters if one.default is not one.empty} | self.given


class Known(NamedTuple):
    """What valid calls are made with."""

    walk: Any
    image: Any
    arm: Any
    model: Any
    agent: Any
    results: Any
    interval: Any
    folder: Path


@cache
def known() -> Known:
    """Small ones of each kind."""
    walk, folder = Walk(3), Path(tempfile.mkdtemp())
    agent = edugym.QLearning.create(walk)
    results = edugym.repeat(walk, {"a": agent}, 20, repetitions=2, max_steps=9, evaluate_every=10, jobs=1)
    edugym.save(agent, folder / "agent.npz")
    results.save(folder / "results.csv")
    edugym.share(edugym.make_mdp("Catch"), folder / "catch.py")
    interval = edugym.Interval(1.0, 0.5, 1.5, 9)
    image, arm = edugym.make_mdp("Catch"), edugym.make_mdp("Trashbot")
    return Known(walk, image, arm, edugym.finite_model(walk), agent, results, interval, folder)


def env() -> Any:
    """An environment in an episode."""
    played = edugym.MDPEnv(known().walk)
    played.reset(seed=0)
    return played


def envs() -> Any:
    """Two of them."""
    played = edugym.MDPVectorEnv(edugym.MDPEnv(known().walk), 2)
    played.reset(seed=0)
    return played


def data() -> Any:
    """Three episodes of a walk."""
    return edugym.collect(known().model, [1] * 4, 3, max_steps=9, seed=0)


def in_own_folder(function: Callable[..., Any]) -> Callable[..., Any]:
    """A function that keeps data with Minari, in a folder of its own; where that is missing, the test is skipped."""
    pytest.importorskip("minari")

    @wraps(function)
    def called(*args: Any, **given: Any) -> Any:
        with pytest.MonkeyPatch.context() as patch:
            patch.setenv("MINARI_DATASETS_PATH", tempfile.mkdtemp())
            return function(*args, **given)

    return called


@cache
def written() -> Any:
    """The same three episodes, as Minari has them."""
    return in_own_folder(edugym.write_minari)(data(), known().model, "edugym/walk-v0")


def agent_with(**strategy: Any) -> Any:
    """An agent, whose `create` checks its strategy."""
    return edugym.QLearning.create((4, 2), **strategy)


def scheduled(schedule: Any) -> Any:
    """The same for a schedule."""
    return agent_with(exploration=edugym.ScheduledEpsilonGreedy.create(schedule))


def claimed(expected: Any) -> Any:
    """Whether a claim holds, which checks what is expected."""
    return edugym.Claim("a", "b", known().interval, expected).holds


def walks(**given: Any) -> Any:
    """A ladder of walks, which `profile` checks."""
    fields: dict[str, Any] = {"name": "Walks", "challenge": "a", "strength": "size", "strengths": (3,)}
    fields |= {"make": limited_walk}
    return edugym.Ladder(**(fields | {"n_steps": 9, "evaluation_episodes": 1} | given))


def limited_walk(size: float, layout_seed: int) -> Any:
    """A walk with a step limit."""
    return type("LimitedWalk", (Walk,), {"max_steps": 9, "__slots__": ()})(int(size))


def on_walks(function: Callable[..., Any]) -> Callable[..., Any]:
    """A function that profiles agents, on the ladder of walks where it is given no challenges."""

    @wraps(function)
    def called(challenges: Any = None, **given: Any) -> Any:
        return function(challenges=[walks()] if challenges is None else challenges, **given)

    return called


def profiled(challenges: Any, **given: Any) -> Any:
    """A profile of a small agent."""
    return edugym.profile({"a": edugym.QLearning.create}, challenges=challenges, repetitions=1, jobs=1, **given)


def results(name: str, **given: Any) -> Case:
    """A method of results."""
    return Case(getattr(known().results, name), {"method": "a"} | given)


ANY = "None text nan inf -1 0 2.5 1e30 1e400 [] object array agent_class task_class function"
CALLS: dict[str, Callable[[], Case]] = {
    "Above": lambda: Case(lambda threshold: claimed(edugym.Above(threshold)), {"threshold": 1}, {"threshold": NUMBER}),
    "Below": lambda: Case(lambda threshold: claimed(edugym.Below(threshold)), {"threshold": 1}, {"threshold": NUMBER}),
    "Dataset.create": lambda: Case(
        edugym.Dataset.create,
        {"states": [0], "actions": [1], "rewards": [1.0], "next_states": [1], "terminated": [True],
         "truncated": [False], "probabilities": [0.5], "n_states": 4, "n_actions": 2},
        named={"n_states": "states next_states", "n_actions": "actions"}),
    "collect": lambda: Case(
        edugym.collect, {"model": known().model, "policy": [1] * 4, "n_episodes": 3, "max_steps": 9},
        {"max_steps": "None"}),
    "doubly_robust": lambda: Case(
        edugym.doubly_robust, {"dataset": data(), "policy": [1] * 4, "Q": np.zeros((4, 2))}),
    "fitted_q_evaluation": lambda: Case(
        edugym.fitted_q_evaluation, {"dataset": data(), "policy": [1] * 4}, {"unseen": NUMBER}),
    "fitted_q_iteration": lambda: Case(edugym.fitted_q_iteration, {"dataset": data()}, {"unseen": NUMBER}),
    "importance_sampling": lambda: Case(edugym.importance_sampling, {"dataset": data(), "policy": [1] * 4}),
    "pessimistic_q_iteration": lambda: Case(
        edugym.pessimistic_q_iteration, {"dataset": data(), "penalty": 1.0, "lowest": -9.0},
        {"penalty": NOT_NEGATIVE, "lowest": NUMBER}),
    "divergence": lambda: Case(
        edugym.divergence, {"model": known().model, "policy": [1] * 4, "reference": [[0.5, 0.5]] * 4},
        named={"policy": "reference"}),
    "expected_choice": lambda: Case(edugym.expected_choice, {"payoffs": [[1.0, -1.0]] * 2, "n_tries": 2}),
    "expected_maximum": lambda: Case(edugym.expected_maximum, {"payoffs": [[1.0, -1.0]] * 2, "n_tries": 2}),
    "fit_rewards": lambda: Case(
        edugym.fit_rewards, {"first": [[[1, 0]]], "second": [[[0, 1]]], "prefers_first": [True]},
        {"prior": "2.5"}, {"first": "second", "prefers_first": "comparisons"}),
    "preference": lambda: Case(
        edugym.preference, {"first_return": 1.0, "second_return": 0.0},
        {"noise": POSITIVE, "first_return": f"{NUMBER} array", "second_return": f"{NUMBER} array"},
        {"first_return": "second_return"}),
    "regret": lambda: Case(
        edugym.regret, {"model": edugym.finite_model(edugym.make_mdp("Bandit")), "actions": [0, 1]},
        {"actions": "[]"}),
    "regularised_iteration": lambda: Case(
        edugym.regularised_iteration, {"model": known().model, "reference": [[0.5, 0.5]] * 4, "penalty": 1.0},
        {"penalty": "2.5"}),
    "regularised_policy": lambda: Case(
        edugym.regularised_policy,
        {"values": edugym.value_iteration(known().model), "reference": [[0.5, 0.5]] * 4, "penalty": 1.0},
        {"penalty": "2.5"}),
    "with_rewards": lambda: Case(edugym.with_rewards, {"model": known().model, "rewards": np.zeros((4, 2))}),
    "Within": lambda: Case(
        lambda low, high: claimed(edugym.Within(low, high)), {"low": 0, "high": 2}, {"low": NUMBER, "high": NUMBER}),
    "Claim": lambda: Case(
        lambda **given: edugym.Claim(**given).holds,
        {"statement": "a", "quantity": "b", "measured": known().interval, "expected": edugym.Above(0),
         "reason": "", "tested_by": (), "remark": ""},
        {"statement": "text", "quantity": "text", "reason": "text", "remark": "text", "tested_by": "[]"}),
    "Above.holds": lambda: Case(edugym.Above(0).holds, {"interval": known().interval}),
    "Below.holds": lambda: Case(edugym.Below(0).holds, {"interval": known().interval}),
    "Within.holds": lambda: Case(edugym.Within(0, 2).holds, {"interval": known().interval}),
    "Brightness.create": lambda: Case(edugym.Brightness.create, {"mdp": known().image}, {"low": "0"}),
    "DiscreteActions.create": lambda: Case(edugym.DiscreteActions.create, {"mdp": known().arm, "bins": 2}),
    "Discretised.create": lambda: Case(
        edugym.Discretised.create, {"mdp": known().image, "bins": 2}, {"low": "-1 0", "high": POSITIVE}),
    "EpsilonGreedy": lambda: Case(
        lambda epsilon: agent_with(exploration=edugym.EpsilonGreedy(epsilon)), {"epsilon": 1}),
    "ExponentialDecay": lambda: Case(
        lambda start, end, rate: scheduled(edugym.ExponentialDecay(start, end, rate)),
        {"start": 1, "end": 0, "rate": 0.5}, {"start": "0", "end": "0"}),
    "FiniteModel.action_values": lambda: Case(known().model.action_values, {"V": [0.0] * 4, "discount": 1}),
    "FiniteModel.outcomes": lambda: Case(known().model.outcomes, {"state": 0, "action": 0}),
    "FiniteModel.row": lambda: Case(known().model.row, {"state": 0}),
    "FiniteModel.sample": lambda: Case(
        known().model.sample, {"state": 0, "action": 0, "rng": np.random.default_rng(0)}),
    "FrameStack.create": lambda: Case(edugym.FrameStack.create, {"mdp": known().walk, "k": 2}),
    "FutureGoals": lambda: Case(
        lambda goals: edugym.HindsightQLearning.create((4, 2), hindsight=edugym.FutureGoals(goals)), {"goals": 4}),
    "GaussianActorCritic.create": lambda: Case(
        edugym.GaussianActorCritic.create, {"environment": (2, 1)}, {"spread": POSITIVE}),
    "Hashed.create": lambda: Case(edugym.Hashed.create, {"mdp": known().image}),
    "HashedTable.create": lambda: Case(
        edugym.HashedTable.create, {"key": np.zeros(2), "capacity": 9}, {"key": "array"}),
    "Identity.create": lambda: Case(edugym.Identity.create, {"environment": (2, 1)}, {"constant": NOT_NEGATIVE}),
    "LinearDecay": lambda: Case(
        lambda start, end, steps: scheduled(edugym.LinearDecay(start, end, steps)),
        {"start": 1, "end": 0, "steps": 9}, {"start": "0", "end": "0"}),
    "MDPEnv": lambda: Case(edugym.MDPEnv, {"mdp": known().walk}),
    "MDPEnv.descriptive_model": lambda: Case(env().descriptive_model, {"state": 0, "action": 0}),
    "MDPEnv.generative_model": lambda: Case(env().generative_model, {"state": 0, "action": 0}),
    "MDPEnv.model": lambda: Case(env().model, {"state": 0, "action": 0}),
    "MDPEnv.reset": lambda: Case(env().reset, {}, {"options": ANY}),
    "MDPEnv.step": lambda: Case(lambda action: env().step(action), {"action": 0}),
    "MDPVectorEnv": lambda: Case(
        edugym.MDPVectorEnv, {"env": edugym.MDPEnv(known().walk)}, {"max_episode_steps": "-1"}),
    "MDPVectorEnv.reset": lambda: Case(envs().reset, {}),
    "MDPVectorEnv.showing": lambda: Case(envs().showing, {"i": 1}, {"i": "0"}),
    "MDPVectorEnv.state": lambda: Case(envs().state, {"i": 1}, {"i": "0"}),
    "MDPVectorEnv.step": lambda: Case(lambda actions: envs().step(actions), {"actions": [0, 1]}),
    "NStepSARSA.create": lambda: Case(edugym.NStepSARSA.create, {"environment": (4, 2)}, {"n": "inf"}),
    "NoisyObservation.create": lambda: Case(
        edugym.NoisyObservation.create, {"mdp": known().image}, {"levels": "0", "sigma": NOT_NEGATIVE}),
    "PrioritisedSweeping.create": lambda: Case(
        edugym.PrioritisedSweeping.create, {"environment": (4, 2)}, {"planning_steps": "inf 0"}),
    "RMax.create": lambda: Case(
        edugym.RMax.create, {"environment": (4, 2)}, {"planning_steps": "inf 0", "lowest_return": "-1 0 2.5"}),
    "UCT.create": lambda: Case(edugym.UCT.create, {"environment": (4, 2)}, {"nodes": "None"}),
    "Ladder": lambda: Case(
        lambda **given: profiled([walks(**given)]), walks()._asdict(),
        {"name": "text", "challenge": "text", "strength": "text", "source": "text", "bounds": "None",
         "n_steps": "None"},
        {"n_steps": "strengths"}),
    "Profile.breaks": lambda: Case(profiled([walks()]).breaks, {"agent": "a", "challenge": "Walks"}),
    "Profile.ladder": lambda: Case(profiled([walks()]).ladder, {"challenge": "Walks"}),
    "Profile.rungs": lambda: Case(profiled([walks()]).rungs, {"agent": "a", "challenge": "Walks"}),
    "Profile.score": lambda: Case(profiled([walks()]).score, {"agent": "a", "challenge": "Walks"}),
    "Profile.scores": lambda: Case(profiled([walks()]).scores, {"agent": "a", "challenge": "Walks"}),
    "Profile.steps": lambda: Case(profiled([walks()]).steps, {"agent": "a", "challenge": "Walks"}),
    "Results.at": lambda: results("at", step=10)._replace(takes={"step": "0"}),
    "Results.average": lambda: results("average"),
    "Results.complete_agents": lambda: results("complete_agents"),
    "Results.curves": lambda: results("curves"),
    "Results.difference": lambda: results("difference", other="a"),
    "Results.final": lambda: results("final"),
    "Results.late": lambda: results("late")._replace(takes={"points": "1e30 1e400"}),
    "Results.learned": lambda: results("learned"),
    "Results.load": lambda: Case(edugym.Results.load, {"path": known().folder / "results.csv"}),
    "Results.mean": lambda: results("mean"),
    "Results.renamed": lambda: Case(known().results.renamed, {"label": "b"}, {"label": "text"}),
    "Results.save": lambda: Case(known().results.save, {"path": known().folder / "other.csv"}, {"path": "text"}),
    "Results.share": lambda: results("share", at_least=0)._replace(takes={"at_least": NUMBER}),
    "ScheduledEpsilonGreedy.create": lambda: Case(
        edugym.ScheduledEpsilonGreedy.create, {"schedule": edugym.LinearDecay(1, 0, 9)}),
    "SeparateFrames.create": lambda: Case(edugym.SeparateFrames.create, {"mdp": known().walk, "k": 2}),
    "Softmax": lambda: Case(
        lambda temperature: agent_with(exploration=edugym.Softmax(temperature)),
        {"temperature": 1}, {"temperature": "inf 2.5 1e30"}),
    "Tabular.create": lambda: Case(
        edugym.Tabular.create, {"mdp": edugym.SeparateFrames.create(known().walk, 2)}),
    "TabularObservation": lambda: Case(edugym.TabularObservation, {"env": gymnasium.make("FrozenLake-v1")}),
    "TabularObservation.observation": lambda: Case(
        edugym.TabularObservation(gymnasium.make("FrozenLake-v1")).observation, {"observation": 1},
        {"observation": "0"}),
    "TileCoding.create": lambda: Case(edugym.TileCoding.create, {"environment": (2, 1)}),
    "ThompsonSampling.create": lambda: Case(
        edugym.ThompsonSampling.create, {"environment": (4, 2)}, {"spread": NOT_NEGATIVE}),
    "UCB.create": lambda: Case(edugym.UCB.create, {"environment": (4, 2)}, {"c": NOT_NEGATIVE}),
    "Values.value": lambda: Case(edugym.value_iteration(known().model).value, {"state": 0}),
    "action_gaps": lambda: Case(edugym.action_gaps, {"model": edugym.finite_model(edugym.make_mdp("Bandit"))}),
    "check_mdp": lambda: Case(edugym.check_mdp, {"mdp": known().walk}, {"n_steps": "0"}),
    "finite_horizon": lambda: Case(edugym.finite_horizon, {"model": known().model, "horizon": 3}),
    "finite_model": lambda: Case(edugym.finite_model, {"mdp": known().walk}),
    "lai_robbins": lambda: Case(edugym.lai_robbins, {"probabilities": [0.5, 0.4]}),
    "load": lambda: Case(
        edugym.load, {"path": known().folder / "agent.npz"}, {"kinds": "[] agent_class task_class"}),
    "make_environment": lambda: Case(lambda name: edugym.make_environment(name), {"name": "Boulder"}),
    "make_mdp": lambda: Case(lambda name: edugym.make_mdp(name), {"name": "Boulder"}),
    "mean_interval": lambda: Case(edugym.mean_interval, {"values": [1, 2, 3]}, {"values": "[] array"}),
    "paired_difference": lambda: Case(
        edugym.paired_difference, {"first": [1, 2], "second": [2, 2]}, named={"first": "second"}),
    "policy_evaluation": lambda: Case(
        edugym.policy_evaluation, {"model": known().model, "policy": [1] * 4}),
    "policy_iteration": lambda: Case(edugym.policy_iteration, {"model": known().model}),
    "policy_of": lambda: Case(edugym.policy_of, {"agent": known().agent, "model": known().model}),
    "profile": lambda: Case(
        on_walks(edugym.profile), {"agents": {"a": edugym.QLearning.create}, "repetitions": 1, "jobs": 1},
        {"jobs": "None -1", "checkpoints": "text"}),
    "proportion_interval": lambda: Case(
        edugym.proportion_interval, {"successes": 1, "n": 2}, {"successes": "0"}, {"n": "successes"}),
    "read_mdp": lambda: Case(lambda path: edugym.read_mdp(path), {"path": known().folder / "catch.py"}),
    "read_minari": lambda: Case(
        edugym.read_minari, {"dataset": written(), "model": known().model},
        {"behaviour": "None"}, {"model": "dataset behaviour"}),
    "record_visits": lambda: Case(
        edugym.record_visits, {"agent": known().agent, "environment": known().walk, "n_steps": 10}),
    "repeat": lambda: Case(
        edugym.repeat,
        {"environment": known().walk, "agents": {"a": known().agent}, "n_steps": 9, "repetitions": 1, "max_steps": 9,
         "evaluate_every": 9, "jobs": 1},
        {"max_steps": "None", "evaluate_every": "None 1e30 1e400", "jobs": "None -1", "save_to": "text",
         "checkpoints": "text"}),
    "save": lambda: Case(
        edugym.save, {"agent": known().agent, "path": known().folder / "other.npz"}, {"path": "text"}),
    "share": lambda: Case(edugym.share, {"mdp": known().image, "path": known().folder / "other.py"}),
    "stack_size": lambda: Case(edugym.stack_size, {"n_observations": 2, "k": 2}),
    "table_size": lambda: Case(edugym.table_size, {"environment": known().walk}),
    "train": lambda: Case(
        edugym.train, {"environment": known().walk, "agent": known().agent, "n_steps": 9, "max_steps": 9},
        {"max_steps": "None", "evaluate_every": "1e30 1e400"}),
    "tuned_profile": lambda: Case(
        on_walks(edugym.tuned_profile),
        {"grids": {"a": {"b": edugym.QLearning.create}}, "repetitions": 1, "tuning_repetitions": 1, "jobs": 1},
        {"jobs": "None -1", "checkpoints": "text"}),
    "value_iteration": lambda: Case(edugym.value_iteration, {"model": known().model}),
    "write_minari": lambda: Case(
        in_own_folder(edugym.write_minari),
        {"dataset": data(), "model": known().model, "name": "edugym/walk-v0"}, {"about": ANY}, {"dataset": "model"}),
    "wrapper": lambda: Case(edugym.wrapper, {"kind": edugym.Tabular}),
}  # fmt: skip
