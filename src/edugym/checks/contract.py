"""What an agent is, and how the loops call it: the names of the parameters of `learn` decide what it is told.

`contract_of` is the gate: what a user gives as an agent becomes a `Contract`; later code does not inspect the
input again.
"""

import difflib
import inspect
from typing import Any, NamedTuple

import numpy as np

from edugym.checks.interfaces import a_class, require_method
from edugym.checks.parameters import coerced, in_short
from edugym.system.generated import generated_class
from edugym.system.packages import is_own

LEARN_PARAMETERS = ("state", "action", "reward", "next_state", "next_action", "terminated", "truncated")
"""The names of the parameters that `learn` may have."""
IN_GAMES = (*(name for name in LEARN_PARAMETERS if name != "next_action"), "other_action")
"""The same for players of games: they learn before they choose the next action, and see what the other player did."""
FOR_OBJECTIVES = (*(name for name in LEARN_PARAMETERS if name != "next_action"), "rewards")
"""The same for agents of several objectives, which see the vector of rewards beside the reward."""
METHODS = {
    "act": ("state", "rng"),
    "learn": ("state", "action", "reward", "next_state", "terminated"),
    "greedy": ("state", "rng"),
}
"""The methods of an agent with their usual parameters.

`learn` may have any of `LEARN_PARAMETERS`; `greedy` is optional.
"""
OTHER_NAMES = {"done": "terminated", "observation": "state", "next_observation": "next_state", "obs": "state"}
"""Other names that students give these parameters."""
ELSEWHERE = {
    "rng": ": draw random numbers in act, which takes it.",
    "other_action": ": only in a game is there another player; edugym.games.train_players passes its action.",
    "rewards": ": only edugym.objectives.train_vectors passes vectors.",
    "next_action": ": here an agent learns before it chooses its next action.",
}
"""What to say about a parameter that `learn` may not have here."""
TABLES = frozenset({"Q", "V", "W", "H", "q", "v", "w", "Q1", "Q2", "weights", "values", "preferences"})
"""Names that students give tables of real numbers."""


class Contract(NamedTuple):
    """What a user gave as an agent, looked at once.

    Attributes:
        agent: the agent, with NumPy numbers in its fields made Python numbers.
        learns_from: which of `LEARN_PARAMETERS` its `learn` has.
        is_own: whether it is made of nothing but the package's own classes.
        has_greedy: whether it has `greedy`, the policy of its evaluation.
        tabular: whether it takes observations as rows of a table.
        takes_vectors: whether it takes observations as flat vectors of numbers.
    """

    agent: Any
    learns_from: tuple[str, ...]
    is_own: bool
    has_greedy: bool
    tabular: bool
    takes_vectors: bool

    @property
    def is_on_policy(self) -> bool:
        """Whether it learns from the action that it will take next, like SARSA: the loop chooses that first."""
        return "next_action" in self.learns_from


def contract_of(agent: Any, may_learn_from: tuple[str, ...] = LEARN_PARAMETERS) -> Contract:
    """Look at what a user gave as an agent, and refuse what is not one.

    Args:
        agent: an agent, or a `Contract`, which is returned.
        may_learn_from: the names of the parameters that its `learn` may have.

    Raises:
        ValueError: something is missing or not as it must be, see `require_agent`; or `learn` has a
            parameter without a default that is not in `may_learn_from`.
    """
    if isinstance(agent, Contract):
        return agent
    own = is_own(agent)
    require_agent(agent, own=own)
    takes, tabular = _taken(agent, may_learn_from), getattr(agent, "tabular", True) is not False
    return Contract(coerced(agent), takes, own, hasattr(recorded(agent), "greedy"), tabular, takes_vectors(agent))


def recorded(agent: Any) -> Any:
    """The agent itself, where something around it records what it does (see `edugym.record_visits`)."""
    return getattr(agent, "recorded", agent)


def takes_vectors(agent: Any) -> bool:
    """Whether an agent takes vectors of numbers: it has no table, and says how long they are."""
    return getattr(agent, "tabular", True) is False and hasattr(agent, "n_inputs")


def learns_from(agent: Any) -> tuple[str, ...]:
    """Which of `LEARN_PARAMETERS` the agent's `learn` has."""
    return contract_of(agent).learns_from


def is_on_policy(agent: Any) -> bool:
    """Whether the agent learns from the action that it will take next."""
    return contract_of(agent).is_on_policy


def require_agent(agent: Any, *, own: bool = False) -> None:
    """Refuse what is not an agent. An agent needs the methods `act` and `learn`, and may have `greedy`.

    Args:
        agent: the value.
        own: whether it is made only of this package's classes, whose methods tests already cover; their signatures are
            not checked.

    Raises:
        ValueError: it is a class; `act` or `learn` is missing; `act` or `greedy` does not take (state, rng), or
            `greedy` is misspelt; `learn` has no `self`; a table contains NaN, or has an integer or bool dtype.
    """
    needed = "agent must be an object with the methods act and learn, but is"
    if isinstance(agent, type):
        raise ValueError(f"{needed} {a_class(agent)}")
    _require_tables(agent, own)
    if own and hasattr(agent, "act") and hasattr(agent, "learn"):
        return
    if not any(hasattr(agent, name) for name in METHODS):
        hint = ": call it, and give what it makes" if inspect.isroutine(agent) else ""
        if hasattr(agent, "training_returns"):
            raise ValueError(f"{needed} a Run: give its agent, run.agent")
        raise ValueError(f"{needed} {in_short(agent)}{hint}")
    require_method(agent, "act", METHODS["act"], METHODS)
    if not callable(getattr(agent, "learn", None)):
        require_method(agent, "learn", METHODS["learn"], METHODS)
    if hasattr(agent, "greedy") or difflib.get_close_matches("greedy", dir(agent), 1, 0.8):
        require_method(agent, "greedy", METHODS["greedy"], METHODS)
    function = getattr(agent.learn, "__func__", None)
    if function is not None and next(iter(inspect.signature(function).parameters), "") in LEARN_PARAMETERS:
        raise ValueError(f"learn of {type(agent).__name__} must have self as its first parameter")


def _taken(agent: Any, allowed: tuple[str, ...]) -> tuple[str, ...]:
    """Which of the allowed parameters the agent's `learn` has, in its order.

    Any other parameter must have a default, which is used; `**` parameters are allowed and get nothing.

    Raises:
        ValueError: it has another parameter without a default.
    """
    taken = []
    for name, parameter in inspect.signature(agent.learn).parameters.items():
        if name in allowed and parameter.kind is not parameter.VAR_POSITIONAL:
            taken.append(name)
        elif parameter.default is parameter.empty and parameter.kind is not parameter.VAR_KEYWORD:
            near = difflib.get_close_matches(name, (*OTHER_NAMES, *allowed), 1)
            meant = f": is {OTHER_NAMES.get(near[0], near[0])!r} meant?" if near else "."
            meant = ELSEWHERE.get(name, meant)
            raise ValueError(
                f"learn of {type(agent).__name__} has the parameter {name!r}{meant} The parameters of learn without a"
                f" default must be among {', '.join(allowed)}, for example"
                f" learn(self, {', '.join(METHODS['learn'])})"
            )
    return tuple(taken)


def tables_of(agent: Any) -> dict[str, np.ndarray[Any, Any]]:
    """Those arrays of an agent that are meant for real numbers: fields and attributes whose name is in `TABLES`."""
    fields = agent._asdict() if hasattr(agent, "_asdict") else getattr(agent, "__dict__", {})
    return {name: table for name, table in fields.items() if name in TABLES and isinstance(table, np.ndarray)}


def _require_tables(agent: Any, own: bool) -> None:
    """Refuse tables of values that cannot hold fractions, or that contain NaN."""
    kind = type(agent).__name__
    if own and "Q" in getattr(agent, "_fields", ()) and not isinstance(agent.Q, np.ndarray):
        raise ValueError(f"Q of {kind} must be an array, but is {in_short(agent.Q)}: use {kind}.create(environment)")
    for name, table in tables_of(agent).items():
        if table.dtype.kind in "bui":
            raise ValueError(
                f"{name} of {kind} must be an array of float, but its dtype is {table.dtype},"
                f" which cannot hold fractions: make it with np.zeros({table.shape})"
            )
        if table.dtype.kind == "f" and np.isnan(table).any():
            where = tuple(np.argwhere(np.isnan(table))[0].tolist())
            raise ValueError(f"{name} of {kind} must hold numbers, but {name}{list(where)} is nan")


def learner(agent: Any, passed: tuple[str, ...] = LEARN_PARAMETERS) -> Any:
    """Wrap an agent, so that a loop can call every agent's `learn` in the same way.

    The wrapper's `learn` takes state, action, reward, next state, whether the episode has terminated and whether it was
    truncated; for on-policy agents also the next action. It passes on only those that the agent's own `learn` takes.

    Compiled code needs to know the arguments of a call beforehand, so the class of the wrapper is generated. For an
    agent that learns from `state, action, reward, terminated` it contains:

        def act(self, state, rng):
            return self.agent.act(state, rng)
        def act_into(self, state, rng, action):  # for agents whose actions are vectors
            self.agent.act_into(state, rng, action)
        def learn(self, state, action, reward, next_state, terminated, truncated):
            self.agent.learn(state=state, action=action, reward=reward, terminated=terminated)

    Args:
        agent: the agent, or its contract.
        passed: what the loop passes to `learn`, in this order; the next action only to agents that take it.

    Raises:
        ValueError: as `contract_of`.
    """
    agent, taken, *_ = contract_of(agent, passed)
    told = [name for name in passed if name != "next_action" or name in taken]
    lines = [
        "    agent: object",
        "    def act(self, state, rng):",
        "        return self.agent.act(state, rng)",
        "    def act_into(self, state, rng, action):",
        "        self.agent.act_into(state, rng, action)",
        f"    def learn(self, {', '.join(told)}):",
        f"        self.agent.learn({', '.join(f'{name}={name}' for name in taken)})",
    ]
    return generated_class("Learner", lines, {})(agent)


def forget_episode(agent: Any) -> None:
    """Tell an agent that a run begins, so that it drops what it remembers of an unfinished episode (see `Agent`)."""
    if hasattr(agent, "forget_episode"):
        agent.forget_episode()
