"""An agent that runs as machine code in an environment that does not."""

from typing import Any

from edugym.compiled.execution import executable
from edugym.mdp.protocol import Random


class MachineAgent:
    """An agent that takes vectors, its methods machine code where that pays: a network is a hundred times as fast.

    Args:
        agent: acts (and learns, in the form that the loops ask for).
        rng: like that from which it will draw.
        state: an observation like those that it will be given.
        expected: how many steps there will be in all.
    """

    def __init__(self, agent: Any, rng: Random, state: Any, expected: int) -> None:
        """See the class."""
        self._agent, self._expected = agent, expected
        self._learn: Any = None
        self._act: Any = executable(act_once, (agent, state, rng), expected=expected, rehearsed=1)

    def act(self, state: Any, rng: Random) -> Any:
        """The agent's action."""
        return self._act(1, self._agent, state, rng)

    def learn(self, *told: Any) -> None:
        """Let the agent learn."""
        if self._learn is None:
            self._learn = executable(learn_once, (self._agent, told), expected=self._expected, rehearsed=1)
        self._learn(1, self._agent, told)


def act_once(n: int, agent: Any, state: Any, rng: Random) -> Any:
    """The agent's action, once whatever `n` is."""
    return agent.act(state, rng)


def learn_once(n: int, agent: Any, told: Any) -> None:
    """Let the agent learn, once whatever `n` is."""
    agent.learn(*told)
