"""What the methods of a student's game return: each mistake is answered with one sentence."""

from typing import Any, NamedTuple

import numpy as np
from numpy.random import Generator as Random

from edugym.checks.interfaces import class_name
from edugym.checks.mdps import refuse_change, refuse_start
from edugym.checks.parameters import in_short
from edugym.checks.values import fits, is_finite_number, kept


class CheckedGame(NamedTuple):
    """A game that checks what its methods return, and that none changes a state; it draws nothing itself.

    Every method raises a ValueError if the game returns what it may not, or changes the state that it is given.

    Attributes:
        game: what it does.
    """

    game: Any

    def initial(self, rng: Random) -> Any:
        """Draw the state in which an episode starts."""
        state = self.game.initial(rng)
        if state is None:
            raise self._mistake("initial", state, "the first state")
        if self.terminal(state):
            refuse_start(self.game, state)
        return state

    def transition(self, state: Any, actions: tuple[int, int], rng: Random) -> Any:
        """Draw the next state."""
        next_state = self._unchanging("transition", state, actions, rng)
        if next_state is None:
            raise self._mistake("transition", next_state, "the next state", state, actions)
        return next_state

    def rewards(self, state: Any, actions: tuple[int, int], next_state: Any, rng: Random) -> tuple[float, float]:
        """Draw the rewards of both players."""
        both = self._unchanging("rewards", state, actions, next_state, rng)
        if not isinstance(both, tuple | list | np.ndarray) or len(both) != 2 or not all(map(is_finite_number, both)):
            raise self._mistake("rewards", both, "a pair of finite numbers, one for each player", state, actions)
        return float(both[0]), float(both[1])

    def terminal(self, state: Any) -> bool:
        """Whether the game is over."""
        over = self._unchanging("terminal", state)
        if not isinstance(over, bool | np.bool_ | int | np.integer):
            raise self._mistake("terminal", over, "True or False", state)
        return bool(over)

    def observation(self, state: Any, player: int, rng: Random) -> Any:
        """Draw what a player sees."""
        seen = self._unchanging("observation", state, player, rng)
        space = self.game.observation_space(player)
        if not fits(space, seen):
            raise self._mistake("observation", seen, f"an element of {space} to player {player}", state)
        return seen

    def observation_space(self, player: int) -> Any:
        """As in the game."""
        return self.game.observation_space(player)

    def action_space(self, player: int) -> Any:
        """As in the game."""
        return self.game.action_space(player)

    def _unchanging(self, method: str, state: Any, *others: Any) -> Any:
        before = kept(state)
        returned = getattr(self.game, method)(state, *others)
        refuse_change(self.game, method, before, state)
        return returned

    def _mistake(self, method: str, returned: Any, allowed: str, state: Any = None, actions: Any = None) -> ValueError:
        given = "" if state is None else f" for state {in_short(state)}"
        given += "" if actions is None else f", actions {in_short(actions)}"
        forgotten = " (is a return missing?)" if returned is None else ""
        return ValueError(
            f"{method} of {class_name(self.game)} must return {allowed}, but returned {in_short(returned)}{given}"
            f"{forgotten}"
        )
