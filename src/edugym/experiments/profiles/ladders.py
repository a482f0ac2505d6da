"""The ladders: for each challenge tasks from easy to hopeless, with the returns of random and of best play."""

import inspect
import math
from collections.abc import Callable, Mapping
from functools import cache, partial
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np

from edugym.adapters.registration import find, make_mdp
from edugym.checks.parameters import (
    a_text,
    in_short,
    number_of_steps,
    several,
    true_or_false,
    whole_number,
)
from edugym.exact.model import finite_model
from edugym.exact.policy_evaluation import policy_evaluation
from edugym.exact.value_iteration import value_iteration
from edugym.experiments.profiles.words import NO_WORDS, WORDS, Words, written
from edugym.mdp.task import task_of
from edugym.training.train import MOST_EPISODES

EXACT = "the optimum of the exact model"


class Bounds(NamedTuple):
    """The returns between which a task is scored.

    Attributes:
        random: the expected return of random play, which scores 0.
        best: that of the best play that is known, which scores 1.
    """

    random: float
    best: float

    def score(self, value: Any) -> Any:
        """The score of a return, or of an array of returns."""
        return (value - self.random) / (self.best - self.random)


class Ladder(NamedTuple):
    """A challenge at several strengths.

    Attributes:
        name: the name of the environment.
        challenge: what it isolates.
        strength: what the strengths are, such as "height".
        strengths: from easy to hopeless; each is a rung of the ladder.
        make: called with a strength and `layout_seed=...`, it makes the MDP of a rung.
        n_steps: the training steps of each rung; None where the strength is the number of steps.
        evaluation_episodes: the episodes of an evaluation.
        bounds: called with a strength, it gives the `Bounds` of the rung; None takes them from the exact model.
        one_layout: whether the bounds are those of any layout, so that the exact model of one is enough.
        source: where the best play comes from.
        words: the same for readers who do not know the environment.
    """

    name: str
    challenge: str
    strength: str
    strengths: tuple[float, ...]
    make: Callable[..., Any]
    n_steps: int | None
    evaluation_episodes: int = 10
    bounds: Callable[[float], Bounds] | None = None
    one_layout: bool = False
    source: str = EXACT
    words: Words = NO_WORDS


def checked(ladder: Ladder) -> Ladder:
    """Refuse a ladder with a field that is not as its class says.

    Raises:
        ValueError: it names the field.
    """
    for name in ("name", "challenge", "strength", "source"):
        a_text(name, getattr(ladder, name))
    if not isinstance(ladder.words, Words):
        raise ValueError(f"words must be Words, but is {in_short(ladder.words)}")
    for name, text in ladder.words._asdict().items():
        a_text(f"words.{name}", text)
    needed = "a tuple of one or more finite numbers, each of them once"
    strengths: list[Any] = several("strengths", ladder.strengths, object, needed)
    finite = all(isinstance(strength, int | float) and math.isfinite(strength) for strength in strengths)
    if not strengths or not finite or len({*strengths}) < len(strengths):
        raise ValueError(f"strengths must be {needed}, but is {in_short(ladder.strengths)}")
    if ladder.n_steps is None:
        for strength in strengths:
            number_of_steps("strengths", strength)
    else:
        number_of_steps("n_steps", ladder.n_steps)
    whole_number("evaluation_episodes", ladder.evaluation_episodes, 1, MOST_EPISODES)
    _check_function("make", ladder.make, {"layout_seed": 0})
    if ladder.bounds is not None:
        _check_function("bounds", ladder.bounds, {})
        for strength in strengths:
            bounds = ladder.bounds(strength)
            if not isinstance(bounds, Bounds) or not bounds.random < bounds.best:
                raise ValueError(
                    f"bounds must be a function that returns Bounds, the best return above that of random play, but"
                    f" {in_short(ladder.bounds)} returns {in_short(bounds)} for {strength}"
                )
    true_or_false("one_layout", ladder.one_layout)
    return ladder


def _check_function(name: str, function: Any, named: dict[str, Any]) -> None:
    """Refuse what is no function of a strength and of what is passed by name."""
    needed = " and ".join(["a strength", *named])
    if isinstance(function, type) or not callable(function):
        raise ValueError(f"{name} must be a function of {needed}, but is {in_short(function)}")
    try:
        inspect.signature(function).bind(1, **named)
    except TypeError:
        taken = ", ".join(map(str, inspect.signature(function).parameters.values()))
        raise ValueError(f"{name} must be a function of {needed}, but {in_short(function)} takes ({taken})") from None


def steps_of(ladder: Ladder, strength: float) -> int:
    """The training steps of a rung."""
    return int(strength) if ladder.n_steps is None else ladder.n_steps


def rung_in_words(ladder: Ladder, strength: float) -> str:
    """A rung in words, such as "a wall of height 14"."""
    return in_words(ladder, written(strength))


def in_words(ladder: Ladder, strength: str) -> str:
    """What is said of a rung, or of several: their strength is a text, such as "between 12 and 15"."""
    return (ladder.words.rung or f"the rung {{}} ({ladder.strength})").replace("{}", strength)


def bounds_of(ladder: Ladder, strength: float, layout_seed: int) -> Bounds:
    """The bounds of a rung.

    Raises:
        ValueError: there are none, and the task has no exact model.
    """
    if ladder.bounds is not None:
        return ladder.bounds(strength)
    return _exact_bounds_of(ladder.make, strength, 0 if ladder.one_layout else layout_seed)


def exact_bounds(mdp: Any) -> Bounds:
    """The bounds of a task with an exact model.

    Raises:
        ValueError: it has none, or no play is better than random play.
    """
    model, limit = finite_model(mdp), task_of(mdp).max_steps
    n_states, n_actions, _ = model.successors.shape
    uniform = np.full((n_states, n_actions), 1 / n_actions)
    random = policy_evaluation(model, uniform, horizon=limit).start
    best = value_iteration(model, horizon=limit).start
    if not best - random > 1e-9 * max(1.0, abs(best)):
        raise ValueError(f"{type(mdp).__name__} must be a task in which some play is better than random play")
    return Bounds(float(random), float(best))


@cache
def _exact_bounds_of(make: Callable[..., Any], strength: float, layout_seed: int) -> Bounds:
    return exact_bounds(make(strength, layout_seed=layout_seed))


def boulder(height: float, layout_seed: int) -> Any:
    """A wall."""
    return make_mdp("Boulder", height=int(height), layout_seed=layout_seed)


def roadrunner(size: float, layout_seed: int) -> Any:
    """A road; who falls, stalls, or stands still for the whole episode pays the same."""
    most = 2 * int(size)
    return make_mdp("Roadrunner", size=int(size), negative_reward=-float(most), max_steps=most)


def study(total_days: float, layout_seed: int) -> Any:
    """Days before an exam for which one lecture is enough; nothing but the exam has a reward."""
    plan = {"lecture_days": 1, "lectures_needed": 1, "energy_needed": 0}
    quiet = {"action_reward_noise_mean": 0.0, "action_reward_noise_sigma": 0.0}
    return make_mdp("Study", total_days=int(total_days), layout_seed=layout_seed, **plan, **quiet)


def catch(size: float, layout_seed: int) -> Any:
    """A square board, seen as a grid."""
    return make_mdp("Catch", rows=int(size), columns=int(size))


def memory_corridor(length: float, layout_seed: int) -> Any:
    """The steps that lead through the corridors up to a length."""
    return make_mdp("MemoryCorridor", max_steps=_steps_through(length))


def tamagotchi(tau: float, layout_seed: int) -> Any:
    """A toy whose messages are noisy."""
    return make_mdp("Tamagotchi", tau=tau)


def trashbot(container_width: float, layout_seed: int) -> Any:
    """An arm with continuous actions, and a container."""
    return make_mdp("Trashbot", container_width=container_width)


def golf(stochasticity_level: float, layout_seed: int) -> Any:
    """A course on which every hit misses its aim a little."""
    return make_mdp("Golf", stochasticity_level=stochasticity_level)


def supermarket(n_steps: float, layout_seed: int) -> Any:
    """Always the same supermarket; to stand still for the whole episode costs about as much as random play."""
    return make_mdp("Supermarket", max_steps=100)


def switches(n_switches: float, layout_seed: int) -> Any:
    """A panel, with as many steps in an episode as there are switches."""
    return make_mdp("Switches", n_switches=int(n_switches))


def _steps_through(length: float) -> int:
    """The steps of perfect play through the corridors of length 1, 2, ..., up to this one."""
    return int(length) * (int(length) + 1) // 2


def _corridor_bounds(length: float) -> Bounds:
    """Random play opens the right one of three doors, and goes on, with probability 1/3."""
    steps = _steps_through(length)
    return Bounds(sum(3.0**-step for step in range(1, steps + 1)), float(steps))


def _switch_bounds(n_switches: float) -> Bounds:
    """Random play moves the number of wrong switches up or down by one: a Markov chain of few states."""
    n = int(n_switches)
    wrong = np.arange(n + 1)
    probability = np.array([0.0, *(math.comb(n, d) for d in wrong[1:])]) / (2**n - 1)
    best, random = -float(probability @ (wrong - 1)), 0.0
    for _ in range(n):  # the steps of an episode, each of which costs 1 unless it reaches the goal
        down, up = probability * wrong / n, probability * (n - wrong) / n
        probability = np.append(down[1:], 0.0) + np.append(0.0, up[:-1])
        probability[0] = 0.0
        random -= float(probability.sum())
    return Bounds(random, best)


def _stored(bounds: Mapping[float, Bounds], strength: float) -> Bounds:
    return bounds[strength]


def _always(bounds: Bounds, strength: float) -> Bounds:
    return bounds


TAMAGOTCHI = Bounds(-676.2, 6707.0)
"""No message tells more than the whole state, with which exact planning does no better than to do what is wanted."""
GOLF: Mapping[float, Bounds] = MappingProxyType(
    {
        0.0: Bounds(0.196, 0.9),
        0.015: Bounds(0.173, 0.868),
        0.03: Bounds(-0.108, 0.772),
        0.06: Bounds(-0.510, 0.744),
        0.1: Bounds(-0.727, 0.490),
        0.2: Bounds(-0.912, -0.202),
        0.3: Bounds(-0.947, -0.491),
    }
)
TRASHBOT: Mapping[float, Bounds] = MappingProxyType(
    {
        0.9: Bounds(-1.113, 5.0),
        0.7: Bounds(-1.100, 5.0),
        0.55: Bounds(-1.105, 5.0),
        0.45: Bounds(-1.130, 5.0),
        0.35: Bounds(-1.165, 5.0),
        0.3: Bounds(-1.179, 5.0),
    }
)
"""The returns of random play, as means of 40 000 to a million episodes; a test plays them again."""


def _ladder(name: str, strength: str, strengths: tuple[float, ...], make: Callable[..., Any], **rest: Any) -> Ladder:
    words = WORDS.get(name, NO_WORDS)
    return Ladder(name, find(name).challenge, strength, strengths, make, words=words, **rest)


LADDERS: tuple[Ladder, ...] = (
    _ladder("Boulder", "height of the wall", (8, 10, 12, 15, 20, 30, 100), boulder, n_steps=20_000, one_layout=True),
    _ladder("Roadrunner", "length of the road", (10, 20, 40, 60, 80, 160), roadrunner, n_steps=20_000, one_layout=True),
    _ladder("Study", "days until the exam", (5, 10, 20, 40, 80, 160), study, n_steps=20_000, one_layout=True),
    _ladder("Catch", "side of the board", (4, 6, 8, 10, 14, 20), catch, n_steps=20_000, one_layout=True),
    _ladder(
        "MemoryCorridor",
        "length of the corridor",
        (1, 2, 3, 4, 5, 6),
        memory_corridor,
        n_steps=100_000,
        evaluation_episodes=50,
        bounds=_corridor_bounds,
        source="a right door in every step, as a player with a memory opens it",
    ),
    _ladder(
        "Tamagotchi",
        "noise τ of the messages",
        (0, 0.01, 0.02, 0.03, 0.05, 0.1),
        tamagotchi,
        n_steps=50_000,
        bounds=partial(_always, TAMAGOTCHI),
        source="that of a player who knows what the toy wants; exact planning finds nothing better",
    ),
    _ladder(
        "Trashbot",
        "width of the container",
        (0.9, 0.7, 0.55, 0.45, 0.35, 0.3),
        trashbot,
        n_steps=100_000,
        bounds=partial(_stored, TRASHBOT),
        source="that of a program written for this arm; no return is higher",
    ),
    _ladder(
        "Golf",
        "noise of the hits",
        (0, 0.015, 0.03, 0.06, 0.1, 0.2, 0.3),
        golf,
        n_steps=30_000,
        evaluation_episodes=100,
        bounds=partial(_stored, GOLF),
        source="that which planning finds for a player who sees exactly where the ball lies",
    ),
    _ladder(
        "Supermarket",
        "training steps",
        (20_000, 10_000, 7_000, 5_000, 2_000, 1_000, 500),
        supermarket,
        n_steps=None,
        one_layout=True,
    ),
    _ladder(
        "Switches",
        "number of switches",
        (2, 3, 4, 5, 6, 8),
        switches,
        n_steps=20_000,
        evaluation_episodes=50,
        bounds=_switch_bounds,
    ),
)
"""A ladder for every environment of the course, in its order."""
