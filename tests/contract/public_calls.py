"""A valid call of every public function and class, and which odd values each of its parameters takes.

Most calls follow from the names of the parameters; `CALLS` has what does not.
"""

import importlib
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
from edugym import games, objectives
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


ROOMS = {
    "figures": "edugym.experiments.figures",
    "statistics": "edugym.experiments.results.statistics",
    "tables": "edugym.experiments.results.tables",
    "deep": "edugym.deep",
    "games": "edugym.games",
    "objectives": "edugym.objectives",
    "notebook": "edugym_course.notebook",
    "grading": "edugym_course.grading",
}
"""Public modules besides `edugym` itself, by the names that the table has for them."""
NUMBER, NOT_NEGATIVE, POSITIVE, WHOLE = "-1 0 2.5 1e30", "0 2.5 1e30", "2.5 1e30", "0 1e30 1e400"
EVERYWHERE: dict[str, str] = {
    "action": "0", "confidence": "0", "discount": "0", "epsilon": "0", "goal_size": "0", "player": "0",
    "exploration_bonus": NOT_NEGATIVE, "initial_value": NUMBER, "layout_seed": WHOLE,
    "planning_seconds": "inf 2.5 1e30", "planning_steps": "0",
    "reward_at_goal": NUMBER, "reward_elsewhere": NUMBER,
    "seed": WHOLE, "state": "0", "threshold": NOT_NEGATIVE, "tolerance": POSITIVE, "trace_decay": "0",
}  # fmt: skip
"""Which odd values a parameter of this name takes wherever it stands, with spaces between; it refuses the others."""


def found(key: str) -> Any:
    """What a key of the table names: a function, a class, or a method, of a class or of one of its instances."""
    room, _, rest = key.partition(".")
    value: Any = importlib.import_module(ROOMS[room]) if room in ROOMS else edugym
    for name in (rest if room in ROOMS else key).split("."):
        value = getattr(value, name)
    owner, _, method = key.rpartition(".")
    return getattr(INSTANCES[owner](), method) if owner in INSTANCES else value


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


def row(
    takes: Mapping[str, str] = MappingProxyType({}),
    function: Callable[..., Any] = found,
    named: Mapping[str, str] = MappingProxyType({}),
    /,
    **given: Any,
) -> Case:
    """A row of the table: what is not `given`, and the function, follow from their names."""
    return Case(function, given, takes, named)


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


@cache
def profile_of_walks() -> Any:
    """A profile of a small agent."""
    return profiled([walks()])


def game_of_one() -> Any:
    """The smallest game: each player has one action."""
    return games.matrix_game([[1]])


def player_of_one() -> Any:
    """A player of it."""
    return edugym.QLearning.create((1, 1))


def diver_env() -> Any:
    """Vectors as rewards, in an episode."""
    env = objectives.VectorRewardEnv(edugym.make_mdp("Diver"))
    env.reset(seed=0)
    return env


INSTANCES: dict[str, Callable[[], Any]] = {
    "Above": lambda: edugym.Above(0), "Below": lambda: edugym.Below(0), "Within": lambda: edugym.Within(0, 2),
    "FiniteModel": lambda: known().model, "Results": lambda: known().results, "Profile": profile_of_walks,
    "MDPEnv": env, "MDPVectorEnv": envs, "objectives.VectorRewardEnv": diver_env,
    "Values": lambda: edugym.value_iteration(known().model),
    "TabularObservation": lambda: edugym.TabularObservation(gymnasium.make("FrozenLake-v1")),
}  # fmt: skip
"""Whose methods are called on an instance."""
USUAL: dict[str, Callable[[], Any]] = {
    "action": lambda: 0, "actions": lambda: [0, 1], "agent": lambda: known().agent, "at_least": lambda: 0,
    "bins": lambda: 2, "challenge": lambda: "Walks", "dataset": data, "environment": lambda: known().walk,
    "game": game_of_one, "i": lambda: 1, "interval": lambda: known().interval, "k": lambda: 2,
    "mdp": lambda: known().walk, "method": lambda: "a", "model": lambda: known().model, "n_steps": lambda: 9,
    "n_tries": lambda: 2, "other": lambda: "a", "payoffs": lambda: [[1.0, -1.0]] * 2, "penalty": lambda: 1.0,
    "player": lambda: 0, "points": lambda: [[1, 2]], "policy": lambda: [1] * 4, "state": lambda: 0,
    "reference": lambda: [[0.5, 0.5]] * 4,
    "games.agent": player_of_one, "games.model": lambda: games.game_model(game_of_one()),
    "games.policies": lambda: ([[1]], [[1]]), "games.policy": lambda: [[1]],
    "objectives.environment": lambda: edugym.make_mdp("Diver"), "objectives.mdp": lambda: edugym.make_mdp("Diver"),
}  # fmt: skip
"""What a parameter without a default gets: of this name anywhere, or in this room."""


def completed(key: str, case: Case) -> Case:
    """A row with its function, and all that the function needs."""
    function, given = found(key) if case.function is found else case.function, dict(case.given)
    for one in inspect.signature(function).parameters.values():
        if one.default is one.empty and one.kind not in (one.VAR_KEYWORD, one.VAR_POSITIONAL) and one.name not in given:
            usual = USUAL.get(f"{key.partition('.')[0]}.{one.name}") or USUAL.get(one.name)
            if not usual:
                pytest.fail(f"{key} has no row in CALLS of public_calls.py that gives it a {one.name}")
            given[one.name] = usual()
    return case._replace(function=function, given=given)


ANY = "None text nan inf -1 0 2.5 1e30 1e400 [] object array agent_class task_class function"
CALLS: dict[str, Callable[[], Case]] = {
    "Above": lambda: row({"threshold": NUMBER}, lambda threshold: claimed(edugym.Above(threshold)), threshold=1),
    "Below": lambda: row({"threshold": NUMBER}, lambda threshold: claimed(edugym.Below(threshold)), threshold=1),
    "Dataset.create": lambda: row(
        {}, found, {"n_states": "states next_states", "n_actions": "actions"}, states=[0], actions=[1], rewards=[1.0],
        next_states=[1], terminated=[True], truncated=[False], probabilities=[0.5], n_states=4, n_actions=2),
    "collect": lambda: row({"max_steps": "None"}, n_episodes=3, max_steps=9),
    "doubly_robust": lambda: row(Q=np.zeros((4, 2))),
    "fitted_q_evaluation": lambda: row({"unseen": NUMBER}),
    "fitted_q_iteration": lambda: row({"unseen": NUMBER}),
    "pessimistic_q_iteration": lambda: row({"penalty": NOT_NEGATIVE, "lowest": NUMBER}, lowest=-9.0),
    "divergence": lambda: row({}, found, {"policy": "reference"}),
    "fit_rewards": lambda: row(
        {"prior": "2.5"}, found, {"first": "second", "prefers_first": "comparisons"},
        first=[[[1, 0]]], second=[[[0, 1]]], prefers_first=[True]),
    "preference": lambda: row(
        {"noise": POSITIVE, "first_return": f"{NUMBER} array", "second_return": f"{NUMBER} array"}, found,
        {"first_return": "second_return"}, first_return=1.0, second_return=0.0),
    "regret": lambda: row({"actions": "[]"}, model=edugym.finite_model(edugym.make_mdp("Bandit"))),
    "regularised_iteration": lambda: row({"penalty": "2.5"}),
    "regularised_policy": lambda: row({"penalty": "2.5"}, values=edugym.value_iteration(known().model)),
    "with_rewards": lambda: row(rewards=np.zeros((4, 2))),
    "Within": lambda: row(
        {"low": NUMBER, "high": NUMBER}, lambda low, high: claimed(edugym.Within(low, high)), low=0, high=2),
    "Claim": lambda: row(
        {"statement": "text", "quantity": "text", "reason": "text", "remark": "text", "tested_by": "[]"},
        lambda **given: edugym.Claim(**given).holds, statement="a", quantity="b", measured=known().interval,
        expected=edugym.Above(0), reason="", tested_by=(), remark=""),
    "Brightness.create": lambda: row({"low": "0"}, mdp=known().image),
    "DiscreteActions.create": lambda: row(mdp=known().arm),
    "Discretised.create": lambda: row({"low": "-1 0", "high": POSITIVE}, mdp=known().image),
    "EpsilonGreedy": lambda: row({}, lambda epsilon: agent_with(exploration=edugym.EpsilonGreedy(epsilon)), epsilon=1),
    "ExponentialDecay": lambda: row(
        {"start": "0", "end": "0"}, lambda start, end, rate: scheduled(edugym.ExponentialDecay(start, end, rate)),
        start=1, end=0, rate=0.5),
    "FiniteModel.action_values": lambda: row(V=[0.0] * 4, discount=1),
    "FiniteModel.sample": lambda: row(rng=np.random.default_rng(0)),
    "FutureGoals": lambda: row(
        {}, lambda goals: edugym.HindsightQLearning.create((4, 2), hindsight=edugym.FutureGoals(goals)), goals=4),
    "GaussianActorCritic.create": lambda: row({"spread": POSITIVE}, environment=(2, 1)),
    "Hashed.create": lambda: row(mdp=known().image),
    "HashedTable.create": lambda: row({"key": "array"}, key=np.zeros(2), capacity=9),
    "Identity.create": lambda: row({"constant": NOT_NEGATIVE}, environment=(2, 1)),
    "LinearDecay": lambda: row(
        {"start": "0", "end": "0"}, lambda start, end, steps: scheduled(edugym.LinearDecay(start, end, steps)),
        start=1, end=0, steps=9),
    "MDPEnv.reset": lambda: row({"options": ANY}),
    "MDPEnv.step": lambda: row({}, lambda action: env().step(action)),
    "MDPVectorEnv": lambda: row({"max_episode_steps": "-1"}, env=edugym.MDPEnv(known().walk)),
    "MDPVectorEnv.showing": lambda: row({"i": "0"}),
    "MDPVectorEnv.state": lambda: row({"i": "0"}),
    "MDPVectorEnv.step": lambda: row({}, lambda actions: envs().step(actions)),
    "NStepSARSA.create": lambda: row({"n": "inf"}),
    "NoisyObservation.create": lambda: row({"levels": "0", "sigma": NOT_NEGATIVE}, mdp=known().image),
    "PrioritisedSweeping.create": lambda: row({"planning_steps": "inf 0"}),
    "RMax.create": lambda: row({"planning_steps": "inf 0", "lowest_return": "-1 0 2.5"}),
    "UCT.create": lambda: row({"nodes": "None"}),
    "Ladder": lambda: row(
        {"name": "text", "challenge": "text", "strength": "text", "source": "text", "bounds": "None",
         "n_steps": "None"}, lambda **given: profiled([walks(**given)]), {"n_steps": "strengths"},
        **walks()._asdict()),
    "Profile.breaks": lambda: row(agent="a"),
    "Profile.rungs": lambda: row(agent="a"),
    "Profile.score": lambda: row(agent="a"),
    "Profile.scores": lambda: row(agent="a"),
    "Profile.steps": lambda: row(agent="a"),
    "Results.at": lambda: row({"step": "0"}, step=10),
    "Results.late": lambda: row({"points": "1e30 1e400"}),
    "Results.load": lambda: row(path=known().folder / "results.csv"),
    "Results.renamed": lambda: row({"label": "text"}, label="b"),
    "Results.save": lambda: row({"path": "text"}, path=known().folder / "other.csv"),
    "Results.share": lambda: row({"at_least": NUMBER}),
    "ScheduledEpsilonGreedy.create": lambda: row(schedule=edugym.LinearDecay(1, 0, 9)),
    "Softmax": lambda: row(
        {"temperature": "inf 2.5 1e30"}, lambda temperature: agent_with(exploration=edugym.Softmax(temperature)),
        temperature=1),
    "Tabular.create": lambda: row(mdp=edugym.SeparateFrames.create(known().walk, 2)),
    "TabularObservation": lambda: row(env=gymnasium.make("FrozenLake-v1")),
    "TabularObservation.observation": lambda: row({"observation": "0"}, observation=1),
    "TileCoding.create": lambda: row(environment=(2, 1)),
    "ThompsonSampling.create": lambda: row({"spread": NOT_NEGATIVE}),
    "UCB.create": lambda: row({"c": NOT_NEGATIVE}),
    "action_gaps": lambda: row(model=edugym.finite_model(edugym.make_mdp("Bandit"))),
    "check_mdp": lambda: row({"n_steps": "0"}),
    "finite_horizon": lambda: row(horizon=3),
    "lai_robbins": lambda: row(probabilities=[0.5, 0.4]),
    "load": lambda: row({"kinds": "[] agent_class task_class"}, path=known().folder / "agent.npz"),
    "make_environment": lambda: row({}, lambda name: edugym.make_environment(name), name="Boulder"),
    "make_mdp": lambda: row({}, lambda name: edugym.make_mdp(name), name="Boulder"),
    "mean_interval": lambda: row({"values": "[] array"}, values=[1, 2, 3]),
    "paired_difference": lambda: row({}, found, {"first": "second"}, first=[1, 2], second=[2, 2]),
    "profile": lambda: row(
        {"jobs": "None -1", "checkpoints": "text"}, on_walks(edugym.profile),
        agents={"a": edugym.QLearning.create}, repetitions=1, jobs=1),
    "proportion_interval": lambda: row({"successes": "0"}, found, {"n": "successes"}, successes=1, n=2),
    "read_mdp": lambda: row({}, lambda path: edugym.read_mdp(path), path=known().folder / "catch.py"),
    "read_minari": lambda: row({"behaviour": "None"}, found, {"model": "dataset behaviour"}, dataset=written()),
    "record_visits": lambda: row(n_steps=10),
    "repeat": lambda: row(
        {"max_steps": "None", "evaluate_every": "None 1e30 1e400", "jobs": "None -1", "save_to": "text",
         "checkpoints": "text"},
        agents={"a": known().agent}, repetitions=1, max_steps=9, evaluate_every=9, jobs=1),
    "save": lambda: row({"path": "text"}, path=known().folder / "other.npz"),
    "share": lambda: row(mdp=known().image, path=known().folder / "other.py"),
    "stack_size": lambda: row(n_observations=2),
    "train": lambda: row({"max_steps": "None", "evaluate_every": "1e30 1e400"}, max_steps=9),
    "tuned_profile": lambda: row(
        {"jobs": "None -1", "checkpoints": "text"}, on_walks(edugym.tuned_profile),
        grids={"a": {"b": edugym.QLearning.create}}, repetitions=1, tuning_repetitions=1, jobs=1),
    "write_minari": lambda: row(
        {"about": ANY}, in_own_folder(edugym.write_minari), {"dataset": "model"}, name="edugym/walk-v0"),
    "wrapper": lambda: row(kind=edugym.Tabular),
}  # fmt: skip
