"""The one table of what parameters the environments take. Every environment of the registry has an entry.

An environment joins the contract tests by being registered and by describing its parameters here.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cache
from math import ceil, inf, nan
from typing import Any

import numpy as np
from hypothesis import strategies as st
from hypothesis.strategies import SearchStrategy

from edugym.envs.supermarket import supermarket
from edugym.envs.trashbot.planning import ScriptedController
from edugym.exact.model import finite_model
from edugym.exact.value_iteration import value_iteration

Keywords = dict[str, Any]


@dataclass(frozen=True)
class Bad:
    """A parameter value that must be refused.

    Attributes:
        name: of the parameter.
        value: what it may not be.
        given: the other parameters, where it is wrong only together with them.
    """

    name: str
    value: Any
    given: Keywords = field(default_factory=dict)


@dataclass(frozen=True)
class Parameters:
    """What an environment's constructor takes.

    Attributes:
        valid: draws small tasks of all kinds.
        corners: the defaults and the extremes; every parameter is in one of them at least.
        bad: what must be refused, with a ValueError that names the parameter and the value; likewise.
        finite: tasks with a finite model, small enough to look at every state and action; empty if there is none.
        layout: parameters with which the layout seed makes a difference, to the task or to its model.
        random: whether what happens depends on the seed of `reset`.
        informed: a good action, from `info` and the environment: random play alone would see little of some tasks.
    """

    valid: SearchStrategy[Keywords]
    corners: tuple[Keywords, ...]
    bad: tuple[Bad, ...]
    finite: tuple[Keywords, ...] = ()
    layout: Keywords = field(default_factory=dict)
    random: bool = True
    informed: Callable[[dict[str, Any], Any], Any] | None = None


def refused(name: str, *values: Any, **given: Any) -> tuple[Bad, ...]:
    """Several bad values of one parameter."""
    return tuple(Bad(name, value, given) for value in values)


NO_WHOLE_NUMBER = (0.5, "1", None, True, nan)
NO_STEPS = (0, -1, 2**62 + 1, 10**400, 0.5, "1", True, nan)
"""What no whole number may be."""

LAYOUT_SEEDS = st.integers(0, 2**32)


@st.composite
def golf(draw: st.DrawFn) -> Keywords:
    """Golf courses: the green does not reach the tee."""
    width = draw(st.sampled_from([3, 5, 7, 9]))
    length = draw(st.integers(width, 20))
    return {
        "width": width,
        "length": length,
        "green_radius": draw(st.floats(0.1, length - width / 2, exclude_max=True)),
        "max_hits": draw(st.integers(1, 12)),
        "stochasticity_level": draw(st.floats(0.001, 0.1)),
        "observe_hits": draw(st.booleans()),
    }


@st.composite
def roadrunner(draw: st.DrawFn) -> Keywords:
    """Roads whose start is not in the stop zone."""
    size = draw(st.integers(2, 25))
    return {
        "size": size,
        "max_speed": draw(st.integers(1, 30)),
        "negative_reward": draw(st.floats(-1e6, 0)),
        "stop_zone": draw(st.integers(0, size - 2)),
        "max_steps": draw(st.none() | st.integers(1, 60)),
    }


@st.composite
def study(draw: st.DrawFn) -> Keywords:
    """Plans that a student can carry out."""
    total_days = draw(st.integers(3, 25))
    lectures_needed = draw(st.integers(1, total_days - 2))
    return {
        "total_days": total_days,
        "n_actions": draw(st.integers(2, 8)),
        "lecture_days": draw(st.integers(lectures_needed, total_days - 1)),
        "lectures_needed": lectures_needed,
        "energy_needed": draw(st.integers(0, min(3, total_days - 2 - lectures_needed))),
        "action_reward_noise_mean": draw(st.floats(0, 10)),
        "action_reward_noise_sigma": draw(st.floats(0, 10)),
        "layout_seed": draw(LAYOUT_SEEDS),
    }


def study_well(info: dict[str, Any], env: Any) -> int:
    """Study on the days of lectures and of the exam, and sleep on the others."""
    return 0 if info["lecture"] or env.state.day == env.mdp.total_days - 1 else 1


@st.composite
def trashbot(draw: st.DrawFn) -> Keywords:
    """Arms that have time to deliver the box."""
    action_scale = draw(st.floats(0.05, 0.3))
    enough = ceil(2.5 / action_scale)
    return {
        "n_bins": draw(st.none() | st.integers(2, 12)),
        "container_width": draw(st.floats(0.25, 1.0, exclude_min=True)),
        "action_scale": action_scale,
        "max_steps": draw(st.integers(enough, enough + 60)),
    }


def carry_the_box(_: dict[str, Any], env: Any) -> Any:
    """What the scripted controller does, as nearly as the bins allow."""
    task = env.mdp
    action = ScriptedController(task.action_scale).act(task.observation(env.state, env.np_random), env.np_random)
    return np.rint((action.astype(np.float64) + 1) / 2 * (task.n_bins - 1)).astype(int) if task.n_bins else action


@cache
def shopping() -> dict[int, int]:
    """The best action in every state of the supermarket."""
    model = finite_model(supermarket(500))
    return dict(zip(model.states, value_iteration(model).Q.argmax(axis=1).tolist(), strict=True))


@st.composite
def catch(draw: st.DrawFn) -> Keywords:
    """Boards on which every ball can be caught."""
    rows = draw(st.integers(2, 12))
    kind = draw(st.sampled_from(["grid", "default", "vectorised", "rgb"]))
    return {"rows": rows, "columns": draw(st.integers(1, 2 * rows - 1)), "observation_type": kind}


PARAMETERS: dict[str, Parameters] = {
    "Boulder": Parameters(
        valid=st.fixed_dictionaries(
            {"height": st.integers(1, 15), "n_grips": st.integers(2, 5)},
            optional={"max_steps": st.integers(1, 60), "layout_seed": LAYOUT_SEEDS},
        ),
        corners=(
            {},
            {"height": 1, "max_steps": 1},
            {"height": 100, "max_steps": 120},
            {"height": 3, "n_grips": 50, "layout_seed": 2**63},
        ),
        bad=(
            *refused("height", 0, -1, *NO_WHOLE_NUMBER),
            *refused("n_grips", 1, -2, *NO_WHOLE_NUMBER),
            *refused("max_steps", *NO_STEPS),
            *refused("layout_seed", -1, *NO_WHOLE_NUMBER),
        ),
        finite=({}, {"height": 1}, {"height": 4, "n_grips": 7, "layout_seed": 3}),
        random=False,
        informed=lambda info, _: max(info["right_grip"], 0),
    ),
    "Roadrunner": Parameters(
        valid=roadrunner(),
        corners=(
            {},
            {"size": 2, "max_speed": 1, "stop_zone": 0},
            {"size": 100, "max_speed": 200, "stop_zone": 98, "negative_reward": 0},
            {"size": 30, "stop_zone": 3, "negative_reward": -1, "max_steps": 1},
        ),
        bad=(
            *refused("size", 1, 0, -10, *NO_WHOLE_NUMBER),
            *refused("max_speed", 0, -1, *NO_WHOLE_NUMBER),
            *refused("negative_reward", 1, 0.5, -inf, inf, nan, "-1", None, True),
            *refused("stop_zone", -1, 9, 10, *NO_WHOLE_NUMBER),
            *refused("stop_zone", 1, size=2),
            *refused("max_steps", *NO_STEPS),
        ),
        finite=({}, {"size": 2}, {"size": 15, "max_speed": 3, "stop_zone": 2, "negative_reward": -1}),
        random=False,
        informed=lambda _, env: 2 if env.state.dx < 1 else 1,
    ),
    "Study": Parameters(
        valid=study(),
        corners=(
            {},
            {"total_days": 3, "n_actions": 2, "lecture_days": 1, "lectures_needed": 1, "energy_needed": 0},
            {"total_days": 8, "lecture_days": 7, "lectures_needed": 3, "energy_needed": 3, "layout_seed": 2**63},
            {"total_days": 40, "n_actions": 20, "lecture_days": 15, "lectures_needed": 15},
            {"action_reward_noise_mean": 0, "action_reward_noise_sigma": 0},
            {"action_reward_noise_mean": 1e6, "action_reward_noise_sigma": 1e6},
        ),
        bad=(
            *refused("total_days", 2, 4, 0, -10, *NO_WHOLE_NUMBER),
            *refused("n_actions", 1, 0, *NO_WHOLE_NUMBER),
            *refused("lecture_days", 0, 10, 11, *NO_WHOLE_NUMBER),
            *refused("lectures_needed", 0, 4, -1, *NO_WHOLE_NUMBER),
            *refused("lectures_needed", 3, total_days=5),
            *refused("energy_needed", -1, 4, *NO_WHOLE_NUMBER),
            *refused("energy_needed", 3, total_days=6),
            *refused("action_reward_noise_mean", -0.1, inf, nan, "0", None, True),
            *refused("action_reward_noise_sigma", -0.1, inf, nan, "0", None, True),
            *refused("layout_seed", -1, *NO_WHOLE_NUMBER),
        ),
        finite=({}, {"total_days": 5, "n_actions": 2, "energy_needed": 0}),
        informed=study_well,
    ),
    "Catch": Parameters(
        valid=catch(),
        corners=(
            {},
            {"rows": 2, "columns": 1, "observation_type": "vectorised"},
            {"rows": 2, "columns": 3, "observation_type": "rgb"},
            {"rows": 20, "columns": 39, "observation_type": "default"},
            {"rows": 100, "columns": 199, "observation_type": "vectorised"},
        ),
        bad=(
            *refused("rows", 1, 0, -10, *NO_WHOLE_NUMBER),
            *refused("columns", 0, -1, 20, 1000, *NO_WHOLE_NUMBER),
            *refused("columns", 4, rows=2),
            *refused("observation_type", "pixels", "Grid", "", None, 0),
        ),
        finite=(
            {"observation_type": "vectorised"},
            {"rows": 4, "columns": 7},
            {"rows": 2, "columns": 2, "observation_type": "rgb"},
        ),
        informed=lambda info, _: 1 + (info["ball"][0] > info["paddle"]) - (info["ball"][0] < info["paddle"]),
    ),
    "MemoryCorridor": Parameters(
        valid=st.fixed_dictionaries({"num_doors": st.integers(2, 6)}, optional={"max_steps": st.integers(1, 60)}),
        corners=({}, {"num_doors": 2}, {"num_doors": 40}, {"max_steps": 1}, {"num_doors": 2, "max_steps": 7}),
        bad=(
            *refused("num_doors", 1, 0, -3, *NO_WHOLE_NUMBER),
            *refused("max_steps", None, *NO_STEPS),
        ),
        informed=lambda info, _: info["right_door"],
    ),
    "Tamagotchi": Parameters(
        valid=st.fixed_dictionaries(
            {
                "tau": st.just(0.0) | st.floats(0.001, 10) | st.just(inf),
                "max_msg_length": st.integers(1, 6),
                "vocab_size": st.integers(1, 13),
                "steps_per_episode": st.integers(1, 60),
            }
        ),
        corners=(
            {},
            {"tau": 0.05, "max_msg_length": 4, "vocab_size": 9},
            {"tau": inf, "vocab_size": 1, "max_msg_length": 2},
            {"tau": 1e-300, "vocab_size": 2, "max_msg_length": 56},
            {"tau": 1e300, "vocab_size": 2**31, "steps_per_episode": 1},
        ),
        bad=(
            *refused("tau", -0.1, -inf, nan, "0", None, True),
            *refused("max_msg_length", 0, -1, 29, *NO_WHOLE_NUMBER),
            *refused("max_msg_length", 2, vocab_size=2**31),
            *refused("vocab_size", 0, -4, 2**31 + 1, *NO_WHOLE_NUMBER),
            *refused("steps_per_episode", None, *NO_STEPS),
        ),
        informed=lambda info, _: info["wanted"],
    ),
    "Trashbot": Parameters(
        valid=trashbot(),
        corners=(
            {},
            {"n_bins": 2, "container_width": 0.2500001},
            {"n_bins": 5},
            {"n_bins": 11, "container_width": 1, "action_scale": 0.3, "max_steps": 9},
            {"n_bins": 2**31, "action_scale": 0.001, "max_steps": 2500},
            {"container_width": 0.3, "action_scale": 0.3, "max_steps": 9},
        ),
        bad=(
            *refused("n_bins", 1, 0, -3, 2**31 + 1, 2.5, "3", True, nan),
            *refused("container_width", 0.25, 0, -1, 1.001, inf, nan, "0.5", None, True),
            *refused("action_scale", 0, -0.1, 5e-324, 0.0009, 0.301, inf, nan, "0.2", None, True),
            *refused("max_steps", 11, None, *NO_STEPS),
            *refused("max_steps", 150, action_scale=0.01),
        ),
        random=False,
        informed=carry_the_box,
    ),
    "Golf": Parameters(
        valid=golf(),
        corners=(
            {},
            {"observe_hits": True},
            {"width": 3, "length": 3, "green_radius": 0.5, "max_hits": 1},
            {"width": 21, "length": 60, "max_hits": 100, "observe_hits": True},
            {"stochasticity_level": 0},
            {"stochasticity_level": 0.0, "max_hits": 3, "observe_hits": True},
            {"stochasticity_level": 1e18, "observe_hits": True},
        ),
        bad=(
            *refused("width", 1, 4, -7, *NO_WHOLE_NUMBER),
            *refused("length", 6, 0, *NO_WHOLE_NUMBER),
            *refused("green_radius", 0, -1.0, 13.5, 100, nan, inf, "2", None, True),
            *refused("green_radius", 0.5, stochasticity_level=0),  # whole cells lie half a cell from the flag or more
            *refused("max_hits", 0, *NO_WHOLE_NUMBER),
            *refused("max_hits", 1, stochasticity_level=0),
            *refused("stochasticity_level", -0.1, nan, inf, "a", None, True),
            *refused("observe_hits", 1, "yes", None),
        ),
        finite=({"stochasticity_level": 0}, {"stochasticity_level": 0, "observe_hits": True, "max_hits": 4}),
    ),
    "Supermarket": Parameters(
        valid=st.fixed_dictionaries(
            {"step_timeout": st.floats(0, 1e-5), "noise": st.floats(0, 10)},
            optional={"max_steps": st.integers(1, 60), "layout_seed": LAYOUT_SEEDS},
        ),
        corners=(
            {},
            {"step_timeout": 0.0005},
            {"noise": 1e6, "layout_seed": 2**63},
            {"noise": 1, "max_steps": 1},
        ),
        bad=(
            *refused("step_timeout", -0.1, 3601, inf, nan, "0", None, True),
            *refused("noise", -0.1, inf, nan, "0", None, True),
            *refused("max_steps", None, *NO_STEPS),
            *refused("layout_seed", -1, *NO_WHOLE_NUMBER),
        ),
        finite=({},),
        layout={"noise": 1.0},
        random=False,
        informed=lambda _, env: shopping()[env.state],
    ),
}
