"""What an environment's `spec` says of its step limit, which it keeps itself."""

import dataclasses
from typing import Any

from gymnasium.envs.registration import EnvSpec


class FilledSpec(EnvSpec):
    """A specification whose `max_episode_steps` and `reward_threshold` are those of the MDP.

    Gymnasium's wrappers read the limit there. As text it leaves the limit out unless a wrapper has set another one: an
    environment that is made from the text keeps the limit of its parameters, and needs no `TimeLimit` around it, which
    would call an episode truncated that terminates in its last step.
    """

    own_limit: int | None = None

    def to_json(self) -> str:
        """The text from which `EnvSpec.from_json` makes a specification of the same environment."""
        given = {part.name: getattr(self, part.name) for part in dataclasses.fields(EnvSpec) if part.init}
        if self.max_episode_steps == self.own_limit:
            given["max_episode_steps"] = None
        return EnvSpec(**given).to_json()


def filled(spec: EnvSpec | None, mdp: Any, limit: int | None) -> EnvSpec | None:
    """The specification with a step limit and the reward threshold of an MDP."""
    if spec is None:
        return None
    given = {part.name: getattr(spec, part.name) for part in dataclasses.fields(EnvSpec) if part.init}
    if given["reward_threshold"] is None:
        given["reward_threshold"] = getattr(mdp, "reward_threshold", None)
    if given["max_episode_steps"] is None:
        given["max_episode_steps"] = limit
    result = FilledSpec(**given)
    result.own_limit = limit
    return result
