"""The policy that an agent follows while it is evaluated."""

from typing import Any, NamedTuple

from edugym.agents.tables import greedy_action
from edugym.checks.contract import contract_of
from edugym.checks.values import deep_copy


class GreedyActor(NamedTuple):
    """The policy of an agent in evaluation: always its greedy action."""

    agent: Any

    def act(self, state: Any, rng: Any) -> Any:
        """The agent's greedy action."""
        return self.agent.greedy(state, rng)

    def act_into(self, state: Any, rng: Any, action: Any) -> None:
        """Write the agent's greedy action into the array `action` (for agents whose actions are vectors)."""
        self.agent.greedy_into(state, rng, action)


class GreedyTable(NamedTuple):
    """What evaluation needs of the many agents whose greedy action is the best in a table.

    All of them share the machine code of an evaluation, which takes about a second to compile.
    """

    Q: Any

    def greedy(self, state: Any, rng: Any) -> Any:
        """The same line as in the agents."""
        return greedy_action(self.Q, state, rng)


def actor(agent: Any) -> Any:
    """The policy of an agent in evaluation: `greedy` if the agent has it, else `act` of a copy.

    (`act` may change the agent, for example count a step of a schedule. Evaluation must not change it.)
    """
    contract = contract_of(agent)
    if contract.has_greedy:
        name = _table_of(type(contract.agent)) if contract.is_own else None
        return GreedyActor(GreedyTable(getattr(contract.agent, name)) if name else contract.agent)
    return deep_copy(contract.agent, "evaluation acts by a copy: give it a method greedy(self, state, rng)")


def _table_of(kind: Any) -> str | None:
    """The field in whose place `GreedyTable` has `Q`, if that is the only difference between the two `greedy`."""
    code, line = (one.greedy.__code__ for one in (kind, GreedyTable))
    function, *names = code.co_names
    same = code.co_code == line.co_code and function == "greedy_action" and code.co_varnames == line.co_varnames
    return names[0] if same and names[0] in kind._fields else None
