"""What takes steps in an environment with random actions, drawn beforehand, to be measured."""

from typing import Any

import gymnasium
import numpy as np

from benchmarks.measure import Contender, Work


def steps_of(env: Any) -> Work:
    """Random actions, drawn beforehand; a new episode where one has ended."""
    env.reset(seed=0)
    actions = np.random.default_rng(0).integers(env.action_space.n, size=1_000).tolist()

    def work(n: int) -> int:
        step, reset = env.step, env.reset
        done = 0
        while done < n:
            for action in actions:
                _, _, terminated, truncated, _ = step(action)
                if terminated or truncated:
                    reset()
            done += len(actions)
        return done

    return work


def unwrapped(name: str, env_id: str, **parameters: Any) -> Contender:
    """An environment without Gymnasium's wrappers."""
    return Contender(name, lambda: steps_of(gymnasium.make(env_id, **parameters).unwrapped))


def made(name: str, env_id: str) -> Contender:
    """An environment as Gymnasium makes it."""
    return Contender(name, lambda: steps_of(gymnasium.make(env_id)))


def copies(name: str, env_id: str, n: int, mode: str | None = None, **parameters: Any) -> Contender:
    """Copies of an environment, stepped together, or one after another in the mode "sync"; they reset themselves."""

    def prepare() -> Work:
        envs: Any = gymnasium.make_vec(env_id, num_envs=n, vectorization_mode=mode, **parameters)
        envs.reset(seed=0)
        actions = list(np.random.default_rng(0).integers(envs.single_action_space.n, size=(16, n)))

        def work(amount: int) -> int:
            done = 0
            while done < amount:
                for action in actions:
                    envs.step(action)
                done += len(actions) * n
            return done

        return work

    return Contender(name, prepare)
