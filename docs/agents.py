"""Write the page of the agents, `docs/agents.md`: which agent works with which environment, with return and speed.

The figures are measured, so they are kept in `docs/agents.json`, and the page is made from that file.

    python docs/agents.py              write the page
    python docs/agents.py --measure    measure everything again (some minutes), then write the page
    python docs/agents.py --check      write nothing; fail if something is missing or out of date
"""

import argparse
import importlib
import importlib.metadata
import inspect
import json
import pkgutil
import platform
import sys
import time
from pathlib import Path
from textwrap import fill
from typing import Any

import gymnasium
import numpy as np
from gymnasium.wrappers import FlattenObservation

import edugym
from edugym import agents, finite_model, make_mdp, train, value_iteration
from edugym.adapters.fitting import tabular
from edugym.adapters.registration import in_course_order
from edugym.checks.contract import takes_vectors
from edugym.system.files import write_whole

PAGE, DATA = Path(__file__).parent / "agents.md", Path(__file__).parent / "agents.json"
SEEDS, EPISODES = 3, 20
OUR_STEPS, OTHER_STEPS, OTHER_LIMIT = 100_000, 50_000, 500
OTHERS = ("FrozenLake", "CliffWalking", "Taxi", "Blackjack", "CartPole", "MountainCar", "Pendulum")
TABLES = 200_000_000
"""Larger tables (in numbers) are not tried: Go-Explore has one for every goal."""
MOST_PLANNED = 2_000
"""In tables of more rows R-max is not tried: it plans over all that it knows, again and again."""

SETTING = """Each agent is trained at its defaults: nothing is tuned, so a low return does not mean that the agent
cannot learn the task. An empty cell means that agent and environment do not fit: a table needs observations and
actions that are whole numbers, and `GaussianActorCritic` needs actions that are real numbers (`create` says so); or
that the table is too large, as that of Switches is for `RMax`. Wrappers such as `Discretised`, `Hashed` and
`FrameStack` make more of them fit. Agents with features or a network take observations as vectors. (One exception to
the defaults: on Trashbot, `GaussianActorCritic` has tiles over the wrist and what it holds only.)"""
FIGURES = f"""**Return** is that of the greedy policy after {OUR_STEPS:,} training steps ({OTHER_STEPS:,} in Gymnasium's
environments, with episodes of at most {OTHER_LIMIT} steps): the mean of {EPISODES} episodes for each of {SEEDS} seeds,
not discounted. **Speed** is in million training steps a second on one core, without compiling. *Best possible* comes
from the exact model."""

Cell = dict[str, float]


def agent_classes() -> dict[str, Any]:
    """Return every agent of the package by its name."""
    modules = [
        importlib.import_module(module.name) for module in pkgutil.iter_modules(agents.__path__, "edugym.agents.")
    ]
    found = {
        name: thing
        for module in modules
        for name, thing in vars(module).items()
        if inspect.isclass(thing)
        and thing.__module__ == module.__name__
        and hasattr(thing, "learn")
        and hasattr(thing, "create")
    }
    return dict(sorted(found.items()))


def environment_names() -> list[str]:
    """Return the names of the course's environments, then those of Gymnasium's."""
    return [entry.name for entry in in_course_order()] + list(OTHERS)


def make(name: str) -> Any:
    """Make an environment: the MDP for the course's, the newest version for Gymnasium's."""
    if name not in OTHERS:
        return make_mdp(name)
    return gymnasium.make(max(key for key in gymnasium.registry if key.startswith(f"{name}-v")))


def settings(kind: Any, name: str, environment: Any) -> dict[str, Any]:
    """Return what is not at its default: the features for Trashbot, whose seven numbers have too many tiles."""
    if kind is edugym.GaussianActorCritic and name == "Trashbot":
        return {"features": edugym.TileCoding.create(environment, tiles=[1, 1, 9, 9, 1, 1, 2])}
    return {}


def fitting(kind: Any, name: str) -> tuple[Any, Any] | None:
    """Return an agent at its defaults and the environment as it sees it; None if the two do not fit."""
    environment = make(name)
    try:
        if takes_vectors(kind.create((2, 2))):
            gymnasium_one = isinstance(environment, gymnasium.Env)
            environment = FlattenObservation(environment) if gymnasium_one else environment
        else:
            environment = tabular(environment)
            n_states, n_actions = edugym.table_size(environment)
            if kind is edugym.GoExplore and n_states * n_states * n_actions > TABLES:
                return None
            if kind is edugym.RMax and n_states > MOST_PLANNED:
                return None
        return kind.create(environment, **settings(kind, name, environment)), environment
    except ValueError:
        return None


def measure(kind: Any, name: str) -> Cell | None:
    """Train an agent at its defaults over some seeds; None if it does not fit the environment.

    Returns:
        The mean greedy return at the end, and the steps a second of training, without compiling.
    """
    other = name in OTHERS
    n_steps = OTHER_STEPS if other else OUR_STEPS
    how: dict[str, Any] = {"max_steps": OTHER_LIMIT if other else None, "evaluate_every": n_steps}
    how["evaluation_episodes"] = EPISODES
    fit = fitting(kind, name)
    if fit is None:
        return None
    if not other:
        train(fit[1], fit[0], 5_000, **how | {"evaluate_every": 5_000})  # compiles
    returns, speeds = [], []
    for seed in range(SEEDS):
        agent, environment = fitting(kind, name) or fit
        began = time.process_time()  # which does not count what other programs do meanwhile
        returns.append(float(train(environment, agent, n_steps, seed=seed, **how).returns[-1]))
        speeds.append(n_steps / (time.process_time() - began))
    if max(speeds) > 1e6:  # too short to be timed
        began, many = time.process_time(), 20 * n_steps
        train(environment, agent, many, **how | {"evaluate_every": many})
        speeds.append(many / (time.process_time() - began))
    return {"return": round(float(np.mean(returns)), 3), "speed": float(f"{max(speeds):.2g}")}


def bounds(name: str) -> Cell:
    """Return the best possible return, for environments of the course with an exact model of moderate size."""
    if name in OTHERS:
        return {}
    try:
        return {"best": round(float(value_iteration(finite_model(make(name))).start), 3)}
    except ValueError:  # too many states, or actions that are real numbers
        return {}


def measure_missing(data: dict[str, Any]) -> None:
    """Measure every agent and every environment that the data do not have, and write each as soon as it is measured."""
    new = set(environment_names()) - data["bounds"].keys()
    classes = agent_classes()
    for agent in data["cells"].keys() - classes.keys():
        del data["cells"][agent]
    for agent, kind in classes.items():
        cells = data["cells"].get(agent, {})
        for name in environment_names():
            if agent in data["cells"] and name not in new:
                continue
            cell = measure(kind, name)
            if cell is not None:
                cells[name] = cell
            print(agent, name, cell, flush=True)
        data["cells"][agent] = cells
        write(data)
    data["cells"] = {agent: data["cells"][agent] for agent in classes}
    data["bounds"] = {name: data["bounds"].get(name) or bounds(name) for name in environment_names()}
    write(data)


def write(data: dict[str, Any]) -> None:
    """Write the data whole, or not at all."""
    write_whole(DATA, (json.dumps(data, indent=1) + "\n").encode())


def nothing() -> dict[str, Any]:
    """Return data without a measurement, for this machine."""
    versions = {name: importlib.metadata.version(name) for name in ("edugym", "gymnasium", "numba", "numpy")}
    return {"machine": {"python": platform.python_version(), **versions}, "cells": {}, "bounds": {}}


def table(data: dict[str, Any], names: list[str], what: str) -> list[str]:
    """Return the lines of one table; `what` is "return" or "speed"."""
    lines = ["| | " + " | ".join(names) + " |", "|---" * (len(names) + 1) + "|"]
    for agent, cells in data["cells"].items():
        shown = [written(cells.get(name), what) for name in names]
        if any(shown):
            lines.append(f"| {agent} | " + " | ".join(shown) + " |")
    if what == "return" and any(data["bounds"].get(name) for name in names):
        best = [f"{data['bounds'][name]['best']:.3g}" if data["bounds"].get(name) else "" for name in names]
        lines.append("| *best possible* | " + " | ".join(best) + " |")
    return lines


def written(cell: Cell | None, what: str) -> str:
    """Return a figure as it is shown."""
    if cell is None:
        return ""
    return f"{cell['return']:.3g}" if what == "return" else f"{cell['speed'] / 1e6:.2g}"


def page(data: dict[str, Any]) -> str:
    """Return the page."""
    ours = [entry.name for entry in in_course_order()]
    versions = ", ".join(f"{name} {version}" for name, version in data["machine"].items())
    return "\n".join(
        [
            "# Which agent works with which environment",
            "",
            fill(SETTING, 120),
            "",
            fill(FIGURES, 120),
            "",
            "## The environments of the course: return",
            "",
            *table(data, ours, "return"),
            "",
            "## The environments of the course: speed",
            "",
            *table(data, ours, "speed"),
            "",
            "## Gymnasium's environments: return",
            "",
            *table(data, list(OTHERS), "return"),
            "",
            "## Gymnasium's environments: speed",
            "",
            "These run in Python, so the environment's own speed is the limit.",
            "",
            *table(data, list(OTHERS), "speed"),
            "",
            f"Measured with {versions}, by `python docs/agents.py --measure-all`.",
            "",
        ]
    )


def missing(data: dict[str, Any]) -> list[str]:
    """Return what was added to the package and not measured yet."""
    found = [f"agent {name}" for name in agent_classes().keys() - data["cells"].keys()]
    return sorted(found + [f"environment {name}" for name in set(environment_names()) - data["bounds"].keys()])


def main() -> int:
    """Run the command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--measure", action="store_true", help="measure what is new")
    parser.add_argument("--measure-all", action="store_true", help="measure everything again, which takes an hour")
    parser.add_argument("--check", action="store_true", help="write nothing, and fail if the page is out of date")
    options = parser.parse_args()
    if options.measure or options.measure_all:
        measure_missing(nothing() if options.measure_all else json.loads(DATA.read_text(encoding="utf-8")))
    data = json.loads(DATA.read_text(encoding="utf-8"))
    if not options.check:
        PAGE.write_text(page(data), encoding="utf-8")
        return 0
    stale = [f"{thing} is not in {DATA}" for thing in missing(data)]
    if PAGE.read_text(encoding="utf-8") != page(data):
        stale.append(f"{PAGE} is out of date")
    for line in stale:
        print(f"{line}: run python docs/agents.py --measure", file=sys.stderr)
    return 1 if stale else 0


if __name__ == "__main__":
    sys.exit(main())
