"""Repeated training: pairs, layouts and seeds, the same whatever runs in parallel, and tables that can be saved."""

import copy
import threading
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

import gymnasium
import numpy as np
import pandas as pd
import pytest
from gymnasium.error import DependencyNotInstalled

from edugym import EpsilonGreedy, GoExplore, QLearning, Results, make_mdp, repeat, train
from edugym.envs.boulder import Boulder
from edugym.experiments.configuration import described
from edugym.experiments.results.tables import MEASURED, joined
from edugym.mdp.protocol import Random, Reals
from edugym.system.extras import require
from tests.experiments.experiments import AGENTS, runs, small


def test_one_row_a_point() -> None:
    """Two methods, three repetitions, and points at 0, 500, ..., 2 000."""
    results = small(evaluate_every=500)
    assert len(results.table) == 2 * 3 * 5
    assert results.methods == ["ε-greedy", "novelty"]
    assert sorted(results.table["step"].unique()) == [0, 500, 1000, 1500, 2000]
    assert results.complete
    assert results.table["complete"].all()
    assert results.table["episodes"].sum() > 0


def test_methods_are_paired() -> None:
    """In one repetition all methods have one seed and one layout; in another, others."""
    results = small()
    assert (results.table.groupby("repetition")[["seed", "layout_seed"]].nunique() == 1).all(axis=None)
    assert (runs(results)[["seed", "layout_seed"]].nunique() == 3).all()


def test_a_run_is_what_train_gives() -> None:
    """The table says the seed and layout with which `train` gives the same curve and the same agent."""
    results = small(seed=5)
    row = runs(results).query("method == 'novelty' and repetition == 2").iloc[0]
    wall = make_mdp("Boulder", height=5, layout_seed=int(row["layout_seed"]))
    assert wall.grips.tolist() != make_mdp("Boulder", height=5).grips.tolist()
    run = train(wall, AGENTS["novelty"](wall), 2_000, seed=int(row["seed"]))
    assert results.curves("novelty")[2].tolist() == run.returns.tolist()
    assert (results.agents["novelty"][2].Q == run.agent.Q).all()
    np.testing.assert_array_equal(results.curves("novelty", "training_return")[2], run.training_returns)


def test_a_longer_experiment_begins_with_the_shorter() -> None:
    """Adding repetitions leaves the first ones as they were."""
    fewer, more = small(repetitions=2), small(repetitions=4)
    columns = ["method", "repetition", "seed", "layout_seed", "step", "return"]
    pd.testing.assert_frame_equal(more.table.query("repetition < 2")[columns], fewer.table[columns])


def test_seed_decides() -> None:
    """Another seed is another experiment; the same one is the same."""
    pd.testing.assert_frame_equal(small(seed=1).table, small(seed=1).table)
    assert set(runs(small(seed=1))["seed"]).isdisjoint(runs(small(seed=2))["seed"])


def test_a_fixed_layout_stays() -> None:
    """A user who names a layout gets it in every repetition."""
    results = small(parameters={"height": 5, "layout_seed": 7})
    assert set(runs(results)["layout_seed"]) == {7}
    assert runs(results)["seed"].nunique() == 3
    agents = results.agents["novelty"].values()
    assert len({tuple(agent.Q[:5].argmax(axis=1)) for agent in agents}) == 1  # all have learned the same wall


def test_an_mdp_has_no_layout_to_vary() -> None:
    """It is one fixed task, described by its fields."""
    results = repeat(make_mdp("Boulder", height=4), AGENTS, 500, repetitions=2, jobs=1)
    assert results.table["layout_seed"].isna().all()
    assert set(results.table["environment"]) == {"Boulder"}
    assert set(results.table["environment.height"]) == {4}


def test_agents_are_copied() -> None:
    """An agent that is given serves every repetition as it was, and stays as it was."""
    wall = make_mdp("Boulder", height=4)
    given = QLearning.create(wall, initial_value=0.5)
    results = repeat(
        wall, {"given": given, "made": lambda task: QLearning.create(task, initial_value=0.5)}, 500, jobs=1
    )
    assert (given.Q == 0.5).all()
    for repetition, agent in results.agents["given"].items():
        assert (agent.Q == results.agents["made"][repetition].Q).all()
    assert len({agent.Q.tobytes() for agent in results.agents["given"].values()}) == 10


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


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"environment": "Bolder"}, "environment must be one of Boulder, .*Bolder"),
        ({"environment": "edugym/Bolder-v0"}, "environment must be one of Boulder, .*Bolder"),
        ({"parameters": {"heigth": 3}}, "has no parameter 'heigth'; it has height, n_grips"),
        ({"parameters": {"height": 0}}, "height must be from 1 to 1000000, but is 0"),
        ({"environment": make_mdp("Boulder"), "parameters": {"height": 3}}, "parameters can be given with the name"),
        ({"agents": {}}, "agents must have one"),
        ({"agents": {"Q": QLearning}}, r"agents\['Q'\] must be an agent or a function"),
        (
            {"agents": {"": QLearning.create}},
            "the labels of agents must be texts that are not empty, but one is ''",
        ),
        ({"agents": {1: QLearning.create}}, "the labels of agents must be texts that are not empty, but one is 1"),
        (
            {"agents": {"Q": lambda: None}},
            r"agents\['Q'\] must take the environment, and nothing else: write `lambda environment: ...`",
        ),
        (
            {"agents": {"Q": lambda environment, seed: None}},
            r"agents\['Q'\] must take the environment, and nothing else",
        ),
        (
            {"agents": {"Q": partial(QLearning.create, rate=0.5)}},
            "QLearning has no setting 'rate'; it has learning_rate",
        ),
        ({"agents": {"Q": lambda environment: None}}, r"agents\['Q'\] must make an agent, but made None"),
        ({"agents": {"Q": 3}}, r"agents\['Q'\] must be an agent or a function"),
        ({"n_steps": 0}, "n_steps must be 1 or more, but is 0"),
        ({"repetitions": 0}, "repetitions must be 1 or more, but is 0"),
        ({"seed": -1}, "seed must be 0 or more, but is -1"),
        ({"jobs": 1.0}, "jobs must be a whole number from 1 to 1000, -1 or None, but is 1.0"),
        ({"jobs": True}, "jobs must be a whole number from 1 to 1000, -1 or None, but is True"),
        ({"jobs": 0}, "jobs must be a whole number from 1 to 1000, -1 or None, but is 0"),
        ({"jobs": 10**8}, "jobs must be a whole number from 1 to 1000, -1 or None, but is 100000000"),
        ({"save_to": 5}, "save_to must be a path, but is 5"),
        ({"checkpoints": ""}, "checkpoints must be a path, but is ''"),
        ({"parameters": [1]}, r"parameters must be a dictionary from names to values, but is \[1\]"),
        ({"environment": None}, "environment must be an MDP, a Gymnasium environment or a name, but is None"),
        ({"environment": lambda: None}, r"environment must be a function of layout_seed, .*, but takes \(\)"),
        (
            {"environment": lambda layout_seed: None},
            r"environment that the function makes must be an MDP or a Gymnasium environment, but is None",
        ),
        ({"stop": threading.Event}, "stop must be a threading.Event or None, but is the class Event"),
        ({"stop": "x"}, r"stop must be a threading.Event or None, but is 'x'"),
        (
            {"environment": Boulder},
            r"environment must be an environment or a function that makes one, but is the class Boulder: make one with"
            r" Boulder.create\(\.\.\.\)$",
        ),
        ({"evaluate_every": 0}, "evaluate_every must be 1 or more, but is 0"),
    ],
)
def test_wrong_arguments_are_named(changes: dict[str, Any], message: str) -> None:
    """Each message has the parameter, its value, and what is allowed."""
    arguments: dict[str, Any] = {
        "environment": "Boulder",
        "agents": AGENTS,
        "n_steps": 100,
        "repetitions": 1,
        "jobs": 1,
    } | changes
    with pytest.raises(ValueError, match=message):
        repeat(**arguments)


class Fading(NamedTuple):
    """A schedule that keeps its state in an array: the more often it is asked, the less it explores."""

    asked: Reals

    def action(self, Q: Reals, state: int, rng: Random) -> int:
        """Explore ever less."""
        self.asked[0] += 1
        if rng.random() < 1 / self.asked[0]:
            return int(rng.random() * Q.shape[1])
        return int(Q[state].argmax())


class Fader(NamedTuple):
    """An agent with such a schedule."""

    Q: Reals
    schedule: Fading

    def act(self, state: int, rng: Random) -> int:
        """As the schedule says."""
        return self.schedule.action(self.Q, state, rng)

    def learn(self, state: int, action: int, reward: float, next_state: int) -> None:
        """Learn a little."""
        self.Q[state, action] += 0.1 * (reward - self.Q[state, action])


def test_runs_share_nothing() -> None:
    """A schedule inside a partial or a closure is that of one run, so results do not depend on `jobs`."""

    def run(jobs: int) -> list[pd.DataFrame]:
        schedule = Fading(np.zeros(1))
        agents = {
            "partial": partial(lambda task, schedule: Fader(np.zeros((6, 2)), schedule), schedule=schedule),
            "closure": lambda task: Fader(np.zeros((6, 2)), schedule),
        }
        results = small(300, jobs=jobs, agents=agents)
        assert schedule.asked[0] == 0
        assert all(agent.schedule.asked[0] >= 300 for runs in results.agents.values() for agent in runs.values())
        return [results.curves(method, "training_return") for method in agents]

    for alone, parallel in zip(run(1), run(4), strict=True):
        pd.testing.assert_frame_equal(alone, parallel)
    first, second = run(1)
    pd.testing.assert_frame_equal(first, second)


def test_a_function_of_the_layout_seed() -> None:
    """It gives what the name gives; the settings are those that all layouts share."""
    made = small(environment=lambda layout_seed: Boulder.create(height=5, layout_seed=layout_seed))
    named = small()
    pd.testing.assert_frame_equal(made.table[list(MEASURED)], named.table[list(MEASURED)])
    assert set(made.table["environment.height"]) == {5}
    assert "environment.grips" not in made.table


def test_an_error_ends_all_runs_at_its_line() -> None:
    """The last frame is the student's, and joblib's are not shown."""

    def broken(environment: Any) -> QLearning:
        raise ZeroDivisionError("mine")

    with pytest.raises(ZeroDivisionError, match="mine") as raised:
        repeat("Boulder", {"Q": QLearning.create, "broken": MakesOnce(broken)}, 100, jobs=2)
    assert raised.traceback[-1].name == "broken"
    assert not any("joblib" in str(entry.path) for entry in raised.traceback)


class MakesOnce:
    """A function that is asked once for a description, and fails after that."""

    def __init__(self, then: Any) -> None:
        """What follows."""
        self.then, self.asked = then, 0

    def __call__(self, environment: Any) -> Any:
        """Make an agent, or not."""
        self.asked += 1
        return QLearning.create(environment) if self.asked == 1 else self.then(environment)


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
    assert loaded.complete
    assert loaded.agents == {}
    assert loaded.share("novelty", at_least=1.0) == results.share("novelty", at_least=1.0)
    row = loaded.table.query("method == 'ε-greedy'").iloc[0]
    assert row["agent"] == "QLearning"
    assert row["agent.learning_rate"] == 0.5
    assert row["agent.exploration"] == "EpsilonGreedy"
    assert row["agent.exploration.epsilon"] == 0.1
    assert row["environment"] == "edugym/Boulder-v0"
    assert row["environment.height"] == 10
    assert row["experiment_seed"] == 0
    assert f"numpy {np.__version__}" in row["versions"]
    assert pd.isna(row["agent.bonus"])  # a setting of another method
    assert sorted(file.name for file in path.parent.iterdir()) == ["results.csv", "results.csv.json"]


def test_other_tables_are_not_results(tmp_path: Path) -> None:
    """The message says what is missing."""
    path = tmp_path / "other.csv"
    path.write_text("method,step\nQ,1\n")
    with pytest.raises(ValueError, match="no column 'repetition'"):
        Results.load(path)


def test_results_answer_questions() -> None:
    """Final values, means, shares and differences, from a table made by hand."""
    table = small(repetitions=3, evaluate_every=2_000).table
    table["return"] = np.where(table["step"] == 0, 9.0, table["repetition"] + (table["method"] == "novelty"))
    results = Results(table)
    assert results.final("novelty").tolist() == [1, 2, 3]
    assert results.mean("novelty").estimate == 2
    assert results.share("novelty", at_least=2)[0::3] == (2 / 3, 3)
    assert results.difference("novelty", "ε-greedy")[:3] == (1, 1, 1)


def test_values_of_every_run() -> None:
    """At a step, and late; an incomplete run has none, and a step between two points is named."""
    table = small(repetitions=3, evaluate_every=1_000).table
    table["return"] = table["step"] / 1_000 + table["repetition"]
    table.loc[table["repetition"] == 1, "complete"] = False
    table = table[(table["repetition"] != 1) | (table["step"] < table["n_steps"])]
    results, last = Results(table), table["n_steps"].iloc[0] / 1_000
    np.testing.assert_equal(results.at("novelty", 1_000), [1.0, np.nan, 3.0])
    np.testing.assert_equal(results.late("novelty", 2), [last - 0.5, np.nan, last + 1.5])
    table["training_return"] = 10.0 * table["return"]
    np.testing.assert_equal(
        Results(table).late("novelty", 2, "training_return"), [10.0 * last - 5.0, np.nan, 10.0 * last + 15.0]
    )
    with pytest.raises(ValueError, match=r"step must be a point of the learning curves, \[0, 1000.*, but is 7"):
        results.at("novelty", 7)


def test_joined_under_other_labels() -> None:
    """Tables and agents keep together."""
    parts = {label: small(200, agents={"Q": QLearning.create}, seed=seed) for seed, label in enumerate(("one", "two"))}
    both = joined(part.renamed(label) for label, part in parts.items())
    assert both.methods == ["one", "two"]
    for label, part in parts.items():
        assert both.final(label).tolist() == part.final("Q").tolist()
        assert both.agents[label] is part.agents["Q"]


@pytest.mark.parametrize(("method", "column"), [("Q", "return"), ("novelty", "reward")])
def test_unknown_methods_and_columns_are_named(method: str, column: str) -> None:
    """The message has what there is."""
    with pytest.raises(ValueError, match=r"must be one of .*(novelty|training_return)"):
        small().curves(method, column)


class Optimist(NamedTuple):
    """A value that holds another, tables long and short, and nothing."""

    inner: QLearning
    twice: QLearning
    table: Reals
    blank: Reals
    short: Reals
    limit: int | None


class Plain:
    """An agent that is an ordinary object."""

    def __init__(self) -> None:
        """With a setting, a hidden one, and something else."""
        self.rate = 0.5
        self._hidden = 1
        self.memory = [1, 2]


def test_settings_are_flat() -> None:
    """Each part once, under the path that leads to it; empty tables and None are no settings."""
    inner = QLearning.create((40, 2), exploration=EpsilonGreedy(0.2), initial_value=2.0)
    value = Optimist(inner, inner, np.arange(40.0), np.zeros(50), np.array([1.0, 2.0]), None)
    settings = described(value, "agent")
    table = settings.pop("agent.table")
    assert settings == {
        "agent": "Optimist",
        "agent.inner": "QLearning",
        "agent.inner.Q": '{"shape": [40, 2], "filled_with": 2.0}',
        "agent.inner.learning_rate": 0.1,
        "agent.inner.discount": 0.99,
        "agent.inner.exploration": "EpsilonGreedy",
        "agent.inner.exploration.epsilon": 0.2,
        "agent.short": "[1.0, 2.0]",
    }
    assert table == described(copy.deepcopy(value), "agent")["agent.table"]
    assert table != described(value._replace(table=np.arange(40.0) + 1), "agent")["agent.table"]
    assert described(Plain(), "agent") == {"agent": "Plain", "agent.rate": 0.5}


def test_missing_libraries_are_named() -> None:
    """With what installs them."""
    with pytest.raises(DependencyNotInstalled, match=r'no_such is not installed, run `pip install "edugym\[plot\]"`'):
        require("plot", "numpy", "no_such")


def test_a_function_with_other_parameters_gets_the_layout_by_name() -> None:
    """Such as `create` itself: its first parameter is the height."""
    results = repeat(Boulder.create, AGENTS, 100, repetitions=2, jobs=1)
    layouts = results.table.groupby("repetition", observed=True)["layout_seed"].first()
    for repetition, agent in results.complete_agents(next(iter(AGENTS))).items():
        assert agent.Q.shape == (11, 2), repetition
    assert layouts.nunique() == 2
