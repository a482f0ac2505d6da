"""Repeated training: pairs, layouts and seeds, the same whatever runs in parallel, and tables that can be saved."""

import copy
import sys
from functools import partial
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import gymnasium
import numpy as np
import pandas as pd
import pytest
from matplotlib import pyplot

from edugym import EpsilonGreedy, GoExplore, Hashed, QLearning, Results, make_mdp, repeat, train
from edugym.envs.boulder import Boulder
from edugym.experiments.configuration import described
from edugym.experiments.figures.curves import Curves
from edugym.experiments.results.rows import MEASURED
from tests.compiled.cells import cell
from tests.experiments.experiments import AGENTS, runs, small


def test_methods_are_paired() -> None:
    """In one repetition all methods have one seed and one layout; in another, others."""
    results = small()
    assert (results.table.groupby("repetition")[["seed", "layout_seed"]].nunique() == 1).all(axis=None)
    assert (runs(results)[["seed", "layout_seed"]].nunique() == 3).all()


def test_where_layouts_come_from() -> None:
    """A layout that is named, or that of an MDP, stays; a function makes one for each seed, by name or place."""
    fixed = runs(small(100, parameters={"height": 5, "layout_seed": 7}))
    assert (set(fixed["layout_seed"]), fixed["seed"].nunique()) == ({7}, 3)
    given = small(100, environment=make_mdp("Boulder", height=4)).table
    assert given["layout_seed"].isna().all()
    assert (set(given["environment"]), set(given["environment.height"])) == ({"Boulder"}, {4})
    made = small(environment=lambda layout_seed: Boulder.create(height=5, layout_seed=layout_seed))
    named = small()
    pd.testing.assert_frame_equal(made.table[list(MEASURED)], named.table[list(MEASURED)])
    row = runs(named).query("method == 'novelty' and repetition == 2").iloc[0]
    wall = make_mdp("Boulder", height=5, layout_seed=int(row["layout_seed"]))
    run = train(wall, AGENTS["novelty"](wall), 2_000, seed=int(row["seed"]))
    assert named.curves("novelty")[2].tolist() == run.returns.tolist()
    assert set(made.table["environment.height"]) == {5}
    assert "environment.grips" not in made.table
    by_name = small(100, environment=Boulder.create)  # its first parameter is the height
    assert runs(by_name)["layout_seed"].nunique() == 3
    assert {agent.Q.shape for agent in by_name.agents["novelty"].values()} == {(11, 2)}


def test_a_policy_plays_however_it_is_given() -> None:
    """Itself, made for each run, or as a function: always grip 1."""
    policy = SimpleNamespace(predict=lambda observation: 1)
    agents: dict[str, Any] = {"given": policy, "made": lambda _: policy, "function": lambda _: policy.predict}
    results = repeat("Boulder", agents, 20, repetitions=2, parameters={"height": 1}, jobs=1)
    given, *others = (results.final(method).tolist() for method in agents)
    assert others == [given, given]


def test_agents_and_tasks_are_copied() -> None:
    """What is given serves every repetition as it was, and stays as it was."""
    wall = Hashed.create(make_mdp("Boulder", height=4), 5)
    given = QLearning.create(wall, initial_value=0.5)
    agents = {"given": given, "made": lambda task: QLearning.create(task, initial_value=0.5)}
    results = repeat(wall, agents, 500, repetitions=4, jobs=1)
    assert (given.Q == 0.5).all()
    assert wall.used == 0
    for repetition, agent in results.agents["given"].items():
        assert (agent.Q == results.agents["made"][repetition].Q).all()
    assert len({agent.Q.tobytes() for agent in results.agents["given"].values()}) == 4


def test_pandas_loads_only_for_the_table(monkeypatch: pytest.MonkeyPatch) -> None:
    """All numbers and figures come without it, and are those of the table."""

    def numbers(results: Results) -> Any:
        found = [results.methods, results.complete, results.last_step]
        for method in AGENTS:
            for column in ("return", "training_return"):
                found += [results.mean(method, column), results.mean(method, column, "training")]
                found += [results.at(method, 1_000, column).tolist(), results.late(method, 2, column).tolist()]
            lines = Curves(results, methods=[method], smooth=2).draw().get_lines()
            found += [np.asarray(line.get_data()).tolist() for line in lines]
            pyplot.close("all")
        return found

    with monkeypatch.context() as without:
        without.setitem(sys.modules, "pandas", None)  # importing it is an error
        results = small()
        alone = numbers(results)
        with pytest.raises(gymnasium.error.DependencyNotInstalled, match="pandas"):
            _ = results.table
    np.testing.assert_equal(numbers(Results(results.table, results.agents)), alone)


def test_any_gymnasium_environment() -> None:
    """By id with parameters, or as it is; one that is given is not touched."""
    agents = {"Q": partial(QLearning.create, learning_rate=0.5, discount=1.0)}
    arguments: dict[str, Any] = {"repetitions": 2, "max_steps": 200, "jobs": 1}
    by_id = repeat("CliffWalking-v1", agents, 3_000, parameters={"is_slippery": True}, **arguments)
    assert set(by_id.table["environment.is_slippery"]) == {True}
    env = gymnasium.make("CliffWalking-v1", is_slippery=True)
    env.reset(seed=0)
    before: Any = copy.deepcopy(env.unwrapped)
    given = repeat(env, agents, 3_000, **arguments)
    after: Any = env.unwrapped
    assert (after.s, after.np_random.random()) == (before.s, before.np_random.random())
    assert by_id.curves("Q").equals(given.curves("Q"))


def test_an_error_ends_all_runs_at_its_line() -> None:
    """The last frame is the student's, and joblib's are not shown."""
    made: list[Any] = []

    def broken(environment: Any) -> QLearning:
        made.append(environment)
        if len(made) > 1:  # the first one is described in the results
            raise ZeroDivisionError("mine")
        return QLearning.create(environment)

    with pytest.raises(ZeroDivisionError, match="mine") as raised:
        repeat("Boulder", {"Q": QLearning.create, "broken": broken}, 100, jobs=2)
    assert raised.traceback[-1].name == "broken"
    assert not any("joblib" in str(entry.path) for entry in raised.traceback)


def test_an_unwritable_file_is_refused_before_the_work(tmp_path: Path) -> None:
    """No agent is made for results that could not be kept."""
    (tmp_path / "file").write_text("")
    made = []
    agents = {"Q": lambda task: made.append(task)}
    for path in (tmp_path / "file" / "results.csv", tmp_path):
        with pytest.raises(OSError, match="cannot write to"):
            repeat("Boulder", agents, 100, save_to=path)
    assert not made


def test_saved_and_loaded_is_the_same(tmp_path: Path) -> None:
    """Every number to its last bit, every setting, and the versions."""
    agents = {**AGENTS, "Go-Explore": GoExplore.create}
    path = tmp_path / "new" / "results.csv"
    results = repeat("Boulder", agents, 1_000, repetitions=2, evaluation_episodes=3, jobs=1, save_to=path)
    loaded = Results.load(path)
    pd.testing.assert_frame_equal(loaded.table, results.table)
    assert (loaded.complete, loaded.agents) == (True, {})
    row = loaded.table.query("method == 'ε-greedy'").iloc[0]
    expected = {
        "agent": "QLearning", "agent.learning_rate": 0.5, "agent.exploration": "EpsilonGreedy",
        "agent.exploration.epsilon": 0.1, "environment": "edugym/Boulder-v0", "environment.height": 10,
    }  # fmt: skip
    assert {column: row[column] for column in expected} == expected
    assert f"numpy {np.__version__}" in row["versions"]
    assert pd.isna(row["agent.bonus"])  # a setting of another method
    assert sorted(file.name for file in path.parent.iterdir()) == ["results.csv", "results.csv.json"]


CLASSES = """
class Fader(NamedTuple):  # the more often it is asked, the less it explores: it has state in a second array
    Q: object
    asked: object
    def act(self, state, rng):
        self.asked[0] += 1
        explores = rng.random() < 1 / self.asked[0]
        return int(rng.random() * self.Q.shape[1]) if explores else int(self.Q[state].argmax())
    def learn(self, state, action, reward, next_state):
        self.Q[state, action] += 0.1 * (reward - self.Q[state, action])

class Optimist(NamedTuple):
    inner: object
    twice: object
    table: object
    blank: object
    short: object
    limit: object

class Plain:
    def __init__(self):
        self.rate, self._hidden, self.memory = 0.5, 1, [1, 2]
"""
NOTEBOOK = cell(CLASSES)
Fader, Optimist, Plain = (NOTEBOOK[name] for name in ("Fader", "Optimist", "Plain"))


def test_runs_share_nothing() -> None:
    """An array inside a partial or a closure is that of one run, so results do not depend on `jobs`."""

    def run(jobs: int) -> list[pd.DataFrame]:
        asked = np.zeros(1)
        agents = {
            "partial": partial(lambda task, asked: Fader(np.zeros((6, 2)), asked), asked=asked),
            "closure": lambda task: Fader(np.zeros((6, 2)), asked),
        }
        results = small(300, jobs=jobs, agents=agents)
        assert asked[0] == 0
        assert all(agent.asked[0] >= 300 for runs in results.agents.values() for agent in runs.values())
        return [results.curves(method, "training_return") for method in agents]

    first, second = run(1)
    for other in (*run(4), second):
        pd.testing.assert_frame_equal(first, other)


def test_settings_are_flat() -> None:
    """Each part once, under the path that leads to it; empty tables and None are no settings."""
    inner = QLearning.create((40, 2), exploration=EpsilonGreedy(0.2), initial_value=2.0)
    value: Any = Optimist(inner, inner, np.arange(40.0), np.zeros(50), np.array([1.0, 2.0]), None)
    settings = described(value, "agent")
    table = settings.pop("agent.table")
    assert settings == {
        "agent": "Optimist", "agent.inner": "QLearning", "agent.inner.Q": '{"shape": [40, 2], "filled_with": 2.0}',
        "agent.inner.learning_rate": 0.1, "agent.inner.discount": 0.99, "agent.inner.exploration": "EpsilonGreedy",
        "agent.inner.exploration.epsilon": 0.2, "agent.short": "[1.0, 2.0]",
    }  # fmt: skip
    assert table == described(copy.deepcopy(value), "agent")["agent.table"]
    assert table != described(value._replace(table=np.arange(40.0) + 1), "agent")["agent.table"]
    assert described(Plain(), "agent") == {"agent": "Plain", "agent.rate": 0.5}
