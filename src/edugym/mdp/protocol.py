"""The interfaces of MDPs and agents.

An MDP is a `typing.NamedTuple`, so it is immutable. An agent is a NamedTuple too: its fields are fixed, but `act` and
`learn` may change the numbers in its arrays. (An ordinary class also works as an agent, but is not compiled.)

You do not inherit from these protocols: every NamedTuple with the right methods is an MDP or an agent. You may define
it in a notebook cell. The README shows an MDP and an agent. The protocols are there for type checkers and readers.
"""

import inspect
from collections.abc import Callable, Mapping
from typing import Any, Protocol, TypeAlias, TypeVar

import numpy as np
from gymnasium import Space

Integers: TypeAlias = np.ndarray[tuple[int, ...], np.dtype[np.int64]]
Reals: TypeAlias = np.ndarray[tuple[int, ...], np.dtype[np.float64]]
Random: TypeAlias = np.random.Generator

State = TypeVar("State")
Observation = TypeVar("Observation")
Observation_co = TypeVar("Observation_co", covariant=True)
Observation_contra = TypeVar("Observation_contra", contravariant=True)


class MDP(Protocol[State, Observation_co]):
    """A Markov decision process (S, A, p, r), and what the agent observes in each state.

    If the observation does not determine the state, the problem is partially observable (a POMDP). Actions are usually
    the numbers 0, 1, 2 and so on. Methods draw every random number from `rng`. They must not change `state` or
    `action`. The discount belongs to the agent.

    An MDP may also have

    * `max_steps`: the step limit. If neither the MDP nor the call of `train` has one, a training episode ends only in a
      terminal state. An evaluation episode then ends after at most 1000 steps;
    * `reward_threshold`: the mean return at which the task counts as solved. It is None if the best return is not known
      or cannot be reached within the step limit;
    * `action_names`: the names of the actions 0, 1, ..., or a dictionary from names to actions;
    * `scene(state, ...)`: its picture (see `edugym.rendering`);
    * `info(state, ...)`: a dictionary with extra information for plots; agents must not use it;
    * `observe_into(state, rng, out)`, if observations are arrays: writes the observation into the array `out`. This
      saves time, since no new array is made at each step;
    * `goal_space`, if the goal changes from episode to episode: the Gymnasium space of a goal. The second half of an
      observation is then the goal, and the first half, of the same form, what has been achieved: the goal is reached
      where both are equal (see `edugym.HindsightQLearning`);
    * `create(**parameters)`, a class method: check the parameters, draw the layout and return the MDP.

    `scene` and `info` may also have the parameters `last_state`, `last_action`, `actions` (the list of the actions so
    far in this episode) and `steps` (the number of steps so far). EduGym passes them by name. When an episode starts,
    `last_state` and `last_action` are None.
    """

    @property
    def observation_space(self) -> Space[Any]:
        """The Gymnasium space of what the agent sees."""

    @property
    def action_space(self) -> Space[Any]:
        """The Gymnasium space of the actions."""

    def initial(self, rng: Random) -> State:
        """Draw the state in which an episode starts. It must not be terminal."""

    def transition(self, state: State, action: int, rng: Random) -> State:
        """Draw the next state from the dynamics p(s'|s, a)."""

    def reward(self, state: State, action: int, next_state: State, rng: Random) -> float:
        """Draw the reward of a transition; its mean is r(s, a, s')."""

    def terminal(self, state: State) -> bool:
        """Whether `state` is terminal. A step limit truncates an episode; it does not make a state terminal."""

    def observation(self, state: State, rng: Random) -> Observation_co:
        """Draw what the agent sees in this state."""


class Actor(Protocol[Observation_contra]):
    """A policy: it chooses actions."""

    def act(self, state: Observation_contra, rng: Random) -> int:
        """Choose an action. `state` is the observation, which the agent treats as the state.

        For an agent with a table, EduGym turns an observation of several whole numbers into a single one, the number of
        a row in the table. An agent without a table says `tabular = False` in its class. If it also has an attribute
        `n_inputs`, it gets the observation as one flat vector of `n_inputs` numbers. Without `n_inputs` it gets the
        observation unchanged.
        """


class Agent(Actor[Observation_contra], Protocol[Observation_contra]):
    """An agent. Its method `learn` is called after every step.

    `learn` may have any of these parameters, which are passed by name (see `edugym.checks.contract`):

    * `state`, `action`, `reward`, `next_state`: the transition, as the agent observes it;
    * `terminated`: whether `next_state` is terminal;
    * `truncated`: whether a step limit or the Gymnasium environment has cut off the episode in a state that is not
      terminal; the agent still bootstraps from `next_state`;
    * `next_action`: the next action, for on-policy agents such as SARSA. If `learn` has this parameter, the next action
      is chosen before learning; if not, after learning, as in Q-learning. If the episode is truncated, the
      environment never executes `next_action`. If it has terminated, ignore `next_action`.

    Optional:

    * `greedy(state, rng)` returns the greedy action, for evaluation. Without it, `act` is used.
    * `forget_episode()` is for an agent that remembers earlier steps of this episode, for example in eligibility
      traces. `train` calls `forget_episode` once, before the first step, because an earlier run may have stopped within
      an episode. `train` does not call it when an episode ends: your `learn` must clear the memory itself when
      `terminated` or `truncated` is true. If your own loop leaves an episode early, call `forget_episode` yourself.
    """

    @property
    def learn(self) -> Callable[..., None]:
        """Learn from the last step.

        In your agent, write `learn` as an ordinary method. This protocol declares it as a property for one reason: type
        checkers then accept a `learn` with any parameters.
        """


HISTORY = ("last_state", "last_action", "actions", "steps")
"""The parameters that `scene` and `info` of an MDP may have besides the state."""


def history_wanted(method: Callable[..., Any]) -> tuple[str, ...]:
    """The names in `HISTORY` that a method `scene` or `info` takes."""
    parameters = inspect.signature(method).parameters
    return tuple(name for name in HISTORY if name in parameters)


def named_actions(mdp: MDP[Any, Any]) -> dict[str, Any]:
    """A dictionary from names to actions; empty if the actions have no names."""
    names = getattr(mdp, "action_names", ())
    return dict(names) if isinstance(names, Mapping) else {name: action for action, name in enumerate(names)}


def writes_in_place(mdp: Any) -> bool:
    """Whether EduGym may call `observe_into` instead of `observation`.

    If a subclass overrides only `observation`, the answer is no: the inherited `observe_into` would still write what
    the parent class observes.
    """
    observers = {"observation", "observe_into"}
    return "observe_into" in next((vars(kind) for kind in type(mdp).__mro__ if observers & vars(kind).keys()), {})
