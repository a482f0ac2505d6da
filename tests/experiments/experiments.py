"""A small experiment, which several tests repeat."""

from functools import partial
from typing import Any

import pandas as pd

from edugym import CountBased, QLearning, Results, repeat

AGENTS: dict[str, Any] = {
    "ε-greedy": partial(QLearning.create, learning_rate=0.5, discount=0.9),
    "novelty": lambda wall: CountBased.create(wall, learning_rate=0.5, discount=0.9),
}


def small(n_steps: int = 2_000, **changes: Any) -> Results:
    """Two methods, three times each, on a low wall."""
    arguments: dict[str, Any] = {"environment": "Boulder", "agents": AGENTS, "repetitions": 3, "jobs": 1} | changes
    if arguments["environment"] == "Boulder":
        arguments.setdefault("parameters", {"height": 5})
    return repeat(n_steps=n_steps, **arguments)


def runs(results: Results) -> pd.DataFrame:
    """One row a run."""
    return results.table.drop_duplicates(["method", "repetition"])


def same(one: Results, other: Results) -> bool:
    """Whether tables and agents are equal."""
    pd.testing.assert_frame_equal(one.table, other.table)
    return all(
        (agent.Q == other.agents[method][repetition].Q).all()
        for method, agents in one.agents.items()
        for repetition, agent in agents.items()
    )
