"""Catch beside the Catch of bsuite and of gymnax, and as copies for Stable-Baselines3.

What is not installed is left out: `.venv/bin/pip install bsuite gymnax` (which brings JAX along) adds both.
"""

from importlib import import_module
from importlib.util import find_spec
from typing import Any

import gymnasium
import numpy as np

from benchmarks.contenders import copies, unwrapped
from benchmarks.measure import Comparison, Contender, Work
from edugym.deep import stable_baselines3_env

CATCH = "edugym/Catch-v0"
COPIES, COPIES_FOR_DEEP_AGENTS = 1024, 64
SCANNED = 128
"""Steps that gymnax takes in one call where it may."""


def comparisons() -> list[Comparison]:
    """All with Catch, on its board of 10 rows and 5 columns."""
    grid, coordinates = {"observation_type": "grid"}, {"observation_type": "vectorised"}
    return [
        Comparison(
            "one step of Catch, grid",
            "steps",
            unwrapped("EduGym's Catch, env.unwrapped", CATCH, **grid),
            installed("bsuite", Contender("bsuite's Catch", lambda: bsuite_steps(1))),
        ),
        Comparison(
            f"vector step of Catch, grid, {COPIES} copies",
            "steps",
            copies("EduGym", CATCH, COPIES, **grid),
            [
                copies("the same, SyncVectorEnv", CATCH, COPIES, "sync", **grid),
                *installed("bsuite", Contender("bsuite, one after another", lambda: bsuite_steps(COPIES))),
                *installed(
                    "gymnax",
                    Contender("gymnax, a call for each step", lambda: gymnax_steps(1)),
                    Contender(f"gymnax, {SCANNED} steps in a call", lambda: gymnax_steps(SCANNED)),
                ),
            ],
        ),
        Comparison(
            f"vector step of Catch, coordinates, {COPIES} copies",
            "steps",
            copies("EduGym", CATCH, COPIES, **coordinates),
            [copies("the same, SyncVectorEnv", CATCH, COPIES, "sync", **coordinates)],
            rate_target=100e6,
        ),
        *([] if "stable_baselines3" in absent() else map(for_deep_agents, ("Catch", "MemoryCorridor", "Trashbot"))),
    ]


def absent() -> list[str]:
    """The packages that are not installed, and whose contenders are left out."""
    return [package for package in ("bsuite", "gymnax", "stable_baselines3") if not find_spec(package)]


def installed(package: str, *contenders: Contender) -> list[Contender]:
    """The contenders, if their package is there."""
    return [] if package in absent() else list(contenders)


def bsuite_steps(n: int) -> Work:
    """Some of bsuite's Catch, one after another; an episode that has ended starts again at the next step."""
    catch = import_module("bsuite.environments.catch")
    envs = [catch.Catch(seed=seed) for seed in range(n)]
    for env in envs:
        env.reset()
    actions = np.random.default_rng(0).integers(3, size=(16, n)).tolist()

    def work(amount: int) -> int:
        done = 0
        while done < amount:
            for row in actions:
                for env, action in zip(envs, row, strict=True):
                    env.step(action)
            done += len(actions) * n
        return done

    return work


def gymnax_steps(n_steps: int) -> Work:
    """Gymnax's Catch, compiled for one core, with so many steps in a call; actions are drawn beforehand.

    Of several steps the observations are not kept, but only added up, as an agent within JAX would use them at once.
    """
    jax, gymnax = import_module("jax"), import_module("gymnax")
    env, parameters = gymnax.make("Catch-bsuite")
    together = jax.vmap(env.step, in_axes=(0, 0, 0, None))

    def step(carried: Any, actions: Any) -> Any:
        key, state = carried
        key, for_this_step = jax.random.split(key)
        observation, state, *seen, _ = together(jax.random.split(for_this_step, COPIES), state, actions, parameters)
        return (key, state), (observation if n_steps == 1 else observation.sum(), seen)

    run = jax.jit(lambda carried, actions: jax.lax.scan(step, carried, actions))
    key = jax.random.key(0)
    _, state = jax.vmap(env.reset, in_axes=(0, None))(jax.random.split(key, COPIES), parameters)
    actions = jax.random.randint(key, (n_steps, COPIES), 0, 3)
    began = (key, state)

    def work(amount: int) -> int:
        done, carried = 0, began
        while done < amount:
            carried, seen = run(carried, actions)
            jax.block_until_ready(seen)
            done += n_steps * COPIES
        return done

    return work


def for_deep_agents(name: str) -> Comparison:
    """Copies as an agent of Stable-Baselines3 steps them: by EduGym's adapter, and by its own `DummyVecEnv`."""
    env_id = f"edugym/{name}-v0"

    def ours() -> Work:
        return steps_of_copies(stable_baselines3_env(name, COPIES_FOR_DEEP_AGENTS))

    def theirs() -> Work:
        vec_env = import_module("stable_baselines3.common.vec_env")
        return steps_of_copies(vec_env.DummyVecEnv([lambda: gymnasium.make(env_id)] * COPIES_FOR_DEEP_AGENTS))

    return Comparison(
        f"{COPIES_FOR_DEEP_AGENTS} copies of {name} for Stable-Baselines3",
        "steps",
        Contender("EduGym's adapter", ours),
        [Contender("DummyVecEnv", theirs)],
        ratio_target=5,
    )


def steps_of_copies(envs: Any) -> Work:
    """Random actions for all of them."""
    envs.reset()
    envs.action_space.seed(0)
    actions = [np.array([envs.action_space.sample() for _ in range(envs.num_envs)]) for _ in range(16)]

    def work(amount: int) -> int:
        done = 0
        while done < amount:
            for action in actions:
                envs.step(action)
            done += len(actions) * envs.num_envs
        return done

    return work
