"""What the loops ask of an agent, and how its methods are bound: by the names of their parameters."""

import copy
import inspect
from typing import Any, NamedTuple

from edugym.compiled.generated import generated_class

TOLD = ("state", "action", "reward", "next_state", "next_action", "terminated", "truncated")
"""What `learn` may take, by name."""


class GreedyActor(NamedTuple):
    """An agent as it acts when it is evaluated: by the action that it believes best."""

    agent: Any

    def act(self, state: Any, rng: Any) -> Any:
        """The agent's greedy action."""
        return self.agent.greedy(state, rng)

    def act_into(self, state: Any, rng: Any, action: Any) -> None:
        """Write the same into an array."""
        self.agent.greedy_into(state, rng, action)


def is_on_policy(agent: Any) -> bool:
    """Whether the agent learns from the action that it will take next: its `learn` takes `next_action`."""
    return "next_action" in learns_from(agent)


def learns_from(agent: Any) -> tuple[str, ...]:
    """Which of `TOLD` the agent's `learn` takes. Other parameters that have a default keep it.

    Raises:
        ValueError: `agent` is no agent, or its `learn` asks for something else.
    """
    if isinstance(agent, type) or not (hasattr(agent, "act") and hasattr(agent, "learn")):
        raise ValueError(f"agent must be a value with the methods act and learn, but is {agent!r}")
    taken = []
    for name, parameter in inspect.signature(agent.learn).parameters.items():
        if name in TOLD and parameter.kind is not parameter.VAR_POSITIONAL:
            taken.append(name)
        elif parameter.default is parameter.empty and parameter.kind is not parameter.VAR_KEYWORD:
            raise ValueError(
                f"learn of {type(agent).__name__} must take some of {', '.join(TOLD)} by these names, but asks for"
                f" {name!r}"
            )
    return tuple(taken)


def learner(agent: Any) -> Any:
    """The agent in the form that the loops ask for: its `learn` takes all that they tell, in their order.

    The class is written for what the agent takes. For one that learns from `state, action, reward, terminated`:

        def act(self, state, rng):
            return self.agent.act(state, rng)
        def act_into(self, state, rng, action):  # for agents that have it
            self.agent.act_into(state, rng, action)
        def learn(self, state, action, reward, next_state, terminated, truncated):
            self.agent.learn(state=state, action=action, reward=reward, terminated=terminated)

    Raises:
        ValueError: as `learns_from`.
    """
    taken = learns_from(agent)
    told = [name for name in TOLD if name != "next_action" or name in taken]
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


def actor(agent: Any) -> Any:
    """The agent as it acts when it is evaluated. Where acting may leave traces in it, a copy acts."""
    return GreedyActor(agent) if hasattr(agent, "greedy") else copy.deepcopy(agent)
