"""What an MDP and an agent are: small immutable values with pure functions.

Nothing inherits from these protocols at run time. A `typing.NamedTuple` with the right methods *is* an MDP or an agent,
also when a student writes it in a notebook cell; the protocols say so to the type checker and to the reader.
"""

import inspect
from collections.abc import Callable, Mapping
from typing import Any, Protocol, TypeAlias, TypeVar

import numpy as np
from gymnasium import Space

from edugym.checks import number_of_steps

Integers: TypeAlias = np.ndarray[tuple[int, ...], np.dtype[np.int64]]
Reals: TypeAlias = np.ndarray[tuple[int, ...], np.dtype[np.float64]]
Random: TypeAlias = np.random.Generator

State = TypeVar("State")
Observation = TypeVar("Observation")
Observation_co = TypeVar("Observation_co", covariant=True)
Observation_contra = TypeVar("Observation_contra", contravariant=True)


class MDP(Protocol[State, Observation_co]):
    """A Markov decision process (S, A, p, r) with actions 0, 1, ..., and what the agent sees of its state.

    Every method is a pure function: all randomness comes from `rng`, and a `state` passed in is never written to.
    An MDP may also have

    * `max_steps`: the step limit; without one, episodes end by themselves;
    * `reward_threshold`: the mean return at which the task counts as solved, or None where it is not known;
    * `action_names`: what the actions 0, 1, ... are called, or a dictionary from names to actions;
    * `scene(state, ...)`: its picture (see `edugym.rendering`);
    * `info(state, ...)`: a dictionary of what a teacher may want to plot and an agent may not use;
    * `observe_into(state, rng, out)`: for observations that are arrays, write into `out` what `observation` returns;
      the vector environment then makes no array for each copy;
    * `create(**parameters)`, a class method: check the parameters and make the MDP, layout included.

    After the state, `scene` and `info` may take any of `last_state`, `last_action`, `actions` (all of this episode, in
    order) and `steps`. These are passed by name; at the start of an episode the first two are None.
    """

    @property
    def observation_space(self) -> Space[Any]:
        """The Gymnasium space of what the agent sees."""

    @property
    def action_space(self) -> Space[Any]:
        """The Gymnasium space of the actions."""

    def initial(self, rng: Random) -> State:
        """Draw the state in which an episode starts."""

    def transition(self, state: State, action: int, rng: Random) -> State:
        """Draw the next state from the dynamics p(s'|s, a)."""

    def reward(self, state: State, action: int, next_state: State, rng: Random) -> float:
        """Draw the reward of a transition, r(s, a, s')."""

    def terminal(self, state: State) -> bool:
        """Whether the task ends in this state (a step limit is not an end of the task: it truncates)."""

    def observation(self, state: State, rng: Random) -> Observation_co:
        """Draw what the agent sees in this state."""


class Actor(Protocol[Observation_contra]):
    """Something that chooses actions: a policy."""

    def act(self, state: Observation_contra, rng: Random) -> int:
        """Choose an action in `state`, which is what the agent observes of the environment's state."""


class Agent(Actor[Observation_contra], Protocol[Observation_contra]):
    """An agent that learns from single transitions, after each of them.

    Its method `learn` takes any of these, by name (see `edugym.training.contract`):

    * `state`, `action`, `reward`, `next_state`: the transition, as the agent observes it;
    * `terminated`: whether the task has ended, so that no reward follows;
    * `truncated`: whether a step limit has ended the episode; the agent still bootstraps from `next_state`;
    * `next_action`: the action that it will take next. Taking it makes an agent on-policy (SARSA): the next action is
      chosen before learning, and otherwise (Q-learning) after it.

    It may have a method `greedy(state, rng)`: the action that it believes best, by which it is evaluated. Without one
    it is evaluated by `act`.
    """

    @property
    def learn(self) -> Callable[..., None]:
        """Learn from one transition."""


def step_limit(mdp: MDP[Any, Any]) -> int | None:
    """The number of steps after which an episode of `mdp` is truncated, or None when there is no limit.

    Raises:
        ValueError: `max_steps` is neither None nor a whole number of 1 or more.
    """
    try:
        limit: Any = getattr(mdp, "max_steps")  # noqa: B009
    except AttributeError:
        if _defines(mdp, "max_steps"):  # a mistake inside the property must not mean "no limit"
            raise
        return None
    if limit is None:
        return None
    number_of_steps("max_steps", limit)
    return int(limit)


def _defines(mdp: Any, name: str) -> bool:
    """Whether the class of an MDP, or of one that it wraps, has such a member."""
    inner = getattr(mdp, "mdp", None)
    return hasattr(type(mdp), name) or (inner is not None and _defines(inner, name))


def coerced(value: Any) -> Any:
    """The same MDP or agent with every field of the type that its class declares (an `int` for a `float` becomes one).

    Machine code is made for types, so without this `learning_rate=1` and `learning_rate=0.1` would be compiled twice;
    and small whole numbers of NumPy's would overflow.
    """
    if not (isinstance(value, tuple) and hasattr(value, "_fields")):
        return value
    kinds: dict[str, Any] = {}
    for base in reversed(type(value).__mro__):
        kinds |= inspect.get_annotations(base)
    fields = {}
    for name, field in zip(value._fields, value, strict=True):
        kind = getattr(kinds.get(name), "__forward_arg__", kinds.get(name))  # as text, if it was written so
        kind = getattr(kind, "__origin__", kind)  # of what is annotated with a range
        if kind in (float, "float") and isinstance(field, int | np.number):
            fields[name] = float(field)
        elif kind in (int, "int") and isinstance(field, np.integer):
            fields[name] = int(field)
        else:
            fields[name] = coerced(field)
    return type(value)(**fields)


HISTORY = ("last_state", "last_action", "actions", "steps")
"""What `scene` and `info` of an MDP may take besides the state."""


def history_wanted(method: Callable[..., Any]) -> tuple[str, ...]:
    """Which of `HISTORY` a method `scene` or `info` takes."""
    parameters = inspect.signature(method).parameters
    return tuple(name for name in HISTORY if name in parameters)


def named_actions(mdp: MDP[Any, Any]) -> dict[str, Any]:
    """The actions of an MDP by what they are called; empty where they have no names."""
    names = getattr(mdp, "action_names", ())
    return dict(names) if isinstance(names, Mapping) else {name: action for action, name in enumerate(names)}
