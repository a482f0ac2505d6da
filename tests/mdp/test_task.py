"""The gates: what a user gives is looked at once, and nobody else looks."""

import ast
from collections.abc import Callable
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium.wrappers import TimeLimit, TransformReward

import edugym as eg
from edugym import MDPEnv, QLearning, make_mdp
from edugym.adapters.playing.game import Game
from edugym.checks import contract, interfaces
from edugym.checks.contract import contract_of
from edugym.mdp import task
from edugym.mdp.task import task_of
from tests.training.tasks import Stairs, StudentsQLearning

SOURCES = Path(eg.__file__).parent
GATES = {"checks/interfaces.py", "checks/contract.py", "mdp/markov_game.py", "mdp/multi_objective.py", "mdp/task.py"}


def test_nobody_but_the_gates_looks_at_what_users_give() -> None:
    """The checks behind them are named in no other file of the library, but for those of a strategy's method."""
    behind = {name for name in vars(interfaces) if name.startswith("require_")} | {"step_limit", "require_agent"}
    found = []
    for file in SOURCES.rglob("*.py"):
        names = {node.id for node in ast.walk(ast.parse(file.read_text("utf-8"))) if isinstance(node, ast.Name)}
        place = file.relative_to(SOURCES).as_posix()
        found += [(place, name) for name in names & behind if place not in GATES]
    assert found == [("agents/settings.py", "require_method")]


def the_calls(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """A list that fills with the name of the parameter at each look at an environment, and "agent" at each agent."""
    calls = list[str]()

    def counted(module: Any, name: str, of: Callable[..., str]) -> None:
        original = getattr(module, name)

        def noting(*given: Any, **how: Any) -> Any:
            calls.append(of(*given))
            return original(*given, **how)

        monkeypatch.setattr(module, name, noting)

    counted(task, "require_playable", lambda name, *_: str(name))
    counted(contract, "require_agent", lambda *_: "agent")
    return calls


MDP, STUDENTS = make_mdp("Boulder", height=4), Stairs()


@pytest.mark.parametrize("mdp", [MDP, STUDENTS], ids=["ours", "a student's"])
@pytest.mark.parametrize("made", [lambda mdp: mdp, MDPEnv, lambda mdp: TimeLimit(MDPEnv(mdp), 9)])
def test_train_looks_once(made: Callable[[Any], Any], mdp: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """At the environment and at the agent, however long it takes."""
    environment, agent = made(mdp), StudentsQLearning(np.zeros(eg.table_size(mdp)))
    calls = the_calls(monkeypatch)
    eg.train(environment, agent, 1_000, evaluate_every=100)
    assert calls == ["environment", "agent"]


@pytest.mark.parametrize(
    ("use", "names"),
    [
        (lambda folder: eg.train("Boulder", QLearning.create((11, 2)), 10), ["mdp", "environment", "agent"]),
        (lambda folder: eg.repeat(MDP, {"q": QLearning.create(MDP)}, 9, repetitions=1), ["environment", "agent"]),
        (lambda folder: MDPEnv(MDP), ["mdp"]),
        (lambda folder: eg.MDPVectorEnv(MDPEnv(MDP)), ["mdp", "env"]),
        (lambda folder: eg.finite_model(MDP), ["mdp"]),
        (lambda folder: eg.check_mdp(MDP), ["mdp"]),
        (lambda folder: eg.share(MDP, folder / "wall.py"), ["mdp"]),
        (lambda folder: Game(MDP), ["environment"]),
        (lambda folder: eg.table_size(MDP), ["environment"]),
        (lambda folder: QLearning.create(MDP), ["environment"]),
        (lambda folder: eg.DQN.create(MDP), ["environment"]),
        (lambda folder: eg.record_visits(QLearning.create((4, 2)), MDP, 10), ["environment", "agent"]),
        (lambda folder: eg.Hashed.create(MDP, 8), ["mdp"]),
        (lambda folder: eg.FrameStack.create(MDP, 2), ["mdp"]),
    ],
)
def test_who_passes_the_gates(
    use: Callable[[Path], Any], names: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Whatever takes an environment or an agent does."""
    calls = the_calls(monkeypatch)
    use(tmp_path)
    assert set(calls) == set(names)


@pytest.mark.parametrize("entry", eg.ENVIRONMENTS, ids=lambda entry: entry.name)
def test_all_forms_of_an_environment_are_one_task(entry: Any) -> None:
    """Its name, its id, what Gymnasium makes of it, the environment, and the MDP."""
    mdp = entry.load_mdp().create()
    found = task_of(mdp)
    assert (found.is_mdp, found.is_own, found.max_steps) == (True, True, getattr(mdp, "max_steps", None))
    for given in (entry.name, f"edugym:{entry.id}", gymnasium.make(entry.id), MDPEnv(mdp)):
        same = task_of(given)
        assert type(same.played) is type(mdp)
        assert same[2:] == found[2:]
    assert task_of(found) is found


def test_a_wrapper_or_a_foreign_environment_is_played_itself() -> None:
    """The limit of the steps is known all the same."""
    wrapped = TransformReward(MDPEnv(MDP), lambda reward: -float(reward))
    found = task_of(wrapped)
    assert (found.played, found.is_mdp, found.is_own, found.max_steps) == (wrapped, False, False, MDP.max_steps)
    foreign = task_of(gymnasium.make("CartPole-v1"))
    assert (foreign.is_mdp, foreign.max_steps, foreign.n_inputs) == (False, 500, 4)
    assert task_of(STUDENTS).is_own is False
    assert task_of(STUDENTS).table_shape == eg.table_size(STUDENTS) == (4, 2)


def test_what_an_agent_is() -> None:
    """The package's own and a student's, with a table and with vectors."""
    own, students = contract_of(QLearning.create(MDP)), contract_of(StudentsQLearning(np.zeros((4, 2))))
    vectors = contract_of(eg.DQN.create(MDP))
    assert (own.is_own, students.is_own, vectors.is_own) == (True, False, True)
    assert (own.tabular, own.takes_vectors, vectors.tabular, vectors.takes_vectors) == (True, False, False, True)
    assert own.has_greedy
    assert not own.is_on_policy
    assert contract_of(own) is own
