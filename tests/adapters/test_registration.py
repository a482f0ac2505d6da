"""The registry, in this process and in fresh ones that import nothing but Gymnasium."""

import inspect
import json
import subprocess
import sys
from typing import Any

import gymnasium
import pytest
from gymnasium.envs.registration import EnvSpec
from gymnasium.error import NameNotFound

import edugym
from edugym import ENVIRONMENTS, make_environment, make_mdp, register_environments
from edugym.adapters.registration import find, in_snake_case, parameters_of, specification
from edugym.mdp.task import full_id

HEAVY = [
    "numba", "pygame", "matplotlib", "pandas", "scipy", "joblib", "ipywidgets", "IPython", "torch", "tqdm", "typer",
]  # fmt: skip


def in_a_fresh_process(code: str) -> str:
    """What a program prints."""
    done = subprocess.run([sys.executable, "-W", "error", "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_importing_is_light() -> None:
    """`import edugym` registers everything and draws no random number; playing imports one module, and no compiler."""
    code = f"""
import sys, json, random
import numpy
before = numpy.random.get_state()[1].tolist(), random.getstate()
import edugym, gymnasium
assert (numpy.random.get_state()[1].tolist(), random.getstate()) == before
assert all(entry.id in gymnasium.registry for entry in edugym.ENVIRONMENTS)
def imported():
    return [name for name in sys.modules if name in {HEAVY} or name.startswith("edugym.envs.")]
seen = [imported()]
env = gymnasium.make("edugym/Boulder-v0")
env.reset(seed=0)
env.step(0)
print(json.dumps([*seen, imported()]))
"""
    assert json.loads(in_a_fresh_process(code)) == [[], ["edugym.envs.boulder"]]


def test_ids_that_name_the_package() -> None:
    """`edugym:edugym/...` imports the package by itself, in `make` and in `make_vec`, for every environment."""
    code = f"""
import gymnasium
for name in {[entry.name for entry in ENVIRONMENTS]}:
    env = gymnasium.make(f"edugym:edugym/{{name}}-v0")
    env.reset(seed=0)
    envs = gymnasium.make_vec(f"edugym:edugym/{{name}}-v0", num_envs=2)
    print(type(env.unwrapped).__name__, type(envs.unwrapped).__name__, envs.num_envs)
"""
    expected = [f"{entry.name}Env MDPVectorEnv 2" for entry in ENVIRONMENTS]
    assert in_a_fresh_process(code).splitlines() == expected


def test_entries() -> None:
    """Every entry has an id, a class, a challenge and, if any, a lesson of its own; nothing is registered twice."""
    before = dict(gymnasium.registry)
    register_environments()  # a second call says nothing
    assert gymnasium.registry == before
    for part in ("name", "challenge"):
        assert len({getattr(entry, part) for entry in ENVIRONMENTS}) == len(ENVIRONMENTS)
    lessons = [entry.lesson for entry in ENVIRONMENTS if entry.lesson is not None]
    assert len(set(lessons)) == len(lessons) >= 9
    for entry in ENVIRONMENTS:
        assert entry.id == f"edugym/{entry.name}-v0"
        assert find(entry.name) is find(entry.id) is entry
        kind, task = entry.load(), entry.load_mdp()
        env: Any = gymnasium.make(entry.id, render_mode="ansi")
        assert type(env.unwrapped) is kind
        assert (kind.__name__, env.render_mode) == (f"{entry.name}Env", "ansi")
        parameters, of_the_task = (inspect.signature(made).parameters for made in (kind, task.create))
        if kind.__module__ != entry.module:  # made of the task alone
            assert [*parameters] == [*of_the_task, "render_mode"]
            assert kind.__doc__ == task.__doc__
        assert parameters["render_mode"].default is None
        assert type(make_mdp(entry.name)) is type(make_mdp(entry.id)) is type(kind().mdp)


def test_unknown_names() -> None:
    """A name that is not there is answered with those that are."""
    for call in (find, make_mdp):
        for name in ("Boulders", "", "edugym/Boulder-v1"):
            with pytest.raises(ValueError, match=f"environment must be one of .*Boulder, .*, but is {name!r}"):
                call(name)
    with pytest.raises(NameNotFound):
        gymnasium.make("edugym/Boulders-v0")
    for module in (edugym, edugym.adapters.registration):
        with pytest.raises(AttributeError, match="has no attribute 'make_Boulders_vector'"):
            _ = module.make_Boulders_vector


def test_public_names() -> None:
    """Every public name is there, and is what its home module calls so."""
    assert set(dir(edugym)) > {entry.name for entry in edugym.ENVIRONMENTS}
    for name in dir(edugym):
        value = getattr(edugym, name)
        home = getattr(value, "__module__", "edugym")
        assert home.startswith("edugym"), name
        assert getattr(value, "__name__", name) == name


def test_file_names_and_ids() -> None:
    """Words are divided by lines, and abbreviations stay whole; the name alone is an id, other ids stay."""
    names = ["Boulder", "MemoryCorridor", "QLearning", "DQN", "PPOAgent", "NStepSarsa2"]
    files = ["boulder", "memory_corridor", "q_learning", "dqn", "ppo_agent", "n_step_sarsa2"]
    assert [*map(in_snake_case, names)] == files
    for name in ("Boulder", "Boulder-v0", "edugym:Boulder", "edugym:edugym/Boulder-v0"):
        assert full_id(name) == "edugym/Boulder-v0"
    assert [*map(full_id, ("Boulder-v1", "CartPole-v1"))] == ["Boulder-v1", "CartPole-v1"]


def test_what_a_specification_refuses(monkeypatch: pytest.MonkeyPatch) -> None:
    """And what there is instead; an environment that takes any keyword gets it."""
    copies = EnvSpec("Copies-v0", vector_entry_point="edugym:any")
    for spec in (copies, EnvSpec("Open-v0", entry_point=lambda size=3, **more: make_environment("Boulder"))):
        monkeypatch.setitem(gymnasium.registry, spec.id, spec)
    assert specification("Open-v0", {"colour": 1})[0].id == "Open-v0"
    for name, parameters, says in (
        ("Bolder", {}, "environment must be one of .*Boulder, .*, or an id of Gymnasium's; .*Bolder"),
        ("CartPole-v1", {"x": 1}, "CartPole-v1 has no parameter 'x'; it has sutton_barto_reward"),
        ("Boulder", {"height": 3, "n": 1}, "Boulder has no parameter 'n'; it has height, n_grips, max_st.*, layout"),
        ("Copies-v0", {}, "env.* must exist as a single one, but 'Copies-v0' is a vector of copies"),
    ):
        with pytest.raises(ValueError, match=f"^{says}"):
            specification(name, parameters)


def test_specifications() -> None:
    """With all parameters and their defaults; an environment of the course knows what it was made with."""
    assert specification("Boulder", {"height": 3})[1] == {
        "height": 10, "n_grips": 2, "max_steps": None, "layout_seed": 0,
    }  # fmt: skip
    assert specification("CartPole-v1", {})[0].id == "CartPole-v1"
    assert [*parameters_of(lambda a, b=3, render_mode=None: None)] == ["a", "b"]
    env = make_environment("Boulder", height=4, render_mode="ansi")
    assert env.spec.kwargs == {"height": 4, "render_mode": "ansi"}
    assert repr(gymnasium.make(env.spec).unwrapped.mdp) == repr(env.mdp)  # type: ignore[attr-defined]
