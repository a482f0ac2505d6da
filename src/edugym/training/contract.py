"""How the training loops call an agent: the names of the parameters of `learn` decide which arguments it gets."""

import copy
import inspect
from typing import Any, NamedTuple

from edugym.compiled.generated import generated_class

LEARN_PARAMETERS = ("state", "action", "reward", "next_state", "next_action", "terminated", "truncated")
"""The names of the parameters that `learn` may have."""


class GreedyActor(NamedTuple):
    """The policy of an agent in evaluation: always its greedy action."""

    agent: Any

    def act(self, state: Any, rng: Any) -> Any:
        """The agent's greedy action."""
        return self.agent.greedy(state, rng)

    def act_into(self, state: Any, rng: Any, action: Any) -> None:
        """Write the same into an array."""
        self.agent.greedy_into(state, rng, action)


def is_on_policy(agent: Any) -> bool:
    """Whether `learn` takes `next_action`, as that of SARSA does: then the next action is chosen before learning."""
    return "next_action" in learns_from(agent)


def learns_from(agent: Any) -> tuple[str, ...]:
    """Which of `LEARN_PARAMETERS` the agent's `learn` takes. Other parameters need a default, which is used.

    Raises:
        ValueError: the agent has no `act` or `learn`, or `learn` has another parameter without a default.
    """
    if isinstance(agent, type) or not (hasattr(agent, "act") and hasattr(agent, "learn")):
        raise ValueError(f"agent must be a value with the methods act and learn, but is {agent!r}")
    taken = []
    for name, parameter in inspect.signature(agent.learn).parameters.items():
        if name in LEARN_PARAMETERS and parameter.kind is not parameter.VAR_POSITIONAL:
            taken.append(name)
        elif parameter.default is parameter.empty and parameter.kind is not parameter.VAR_KEYWORD:
            allowed = ", ".join(LEARN_PARAMETERS)
            raise ValueError(
                f"learn of {type(agent).__name__} may only have the parameters {allowed}, and others with a default,"
                f" but it has {name!r}"
            )
    return tuple(taken)


def learner(agent: Any) -> Any:
    """Wrap an agent. The wrapper's `learn` accepts all arguments of a loop, in order.

    It passes to the agent's `learn` only those that it takes.

    Compiled code needs to know the arguments of a call beforehand, so the class of the wrapper is generated. For an
    agent that learns from `state, action, reward, terminated` it contains:

        def act(self, state, rng):
            return self.agent.act(state, rng)
        def act_into(self, state, rng, action):  # always generated; it works only if the agent has it
            self.agent.act_into(state, rng, action)
        def learn(self, state, action, reward, next_state, terminated, truncated):
            self.agent.learn(state=state, action=action, reward=reward, terminated=terminated)

    Raises:
        ValueError: as `learns_from`.
    """
    taken = learns_from(agent)
    told = [name for name in LEARN_PARAMETERS if name != "next_action" or name in taken]
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
    """The policy of an agent in evaluation: `greedy` if the agent has it, else `act` of a copy.

    (`act` may change the agent, for example count a step of a schedule. Evaluation must not change it.)
    """
    return GreedyActor(agent) if hasattr(agent, "greedy") else copy.deepcopy(agent)
