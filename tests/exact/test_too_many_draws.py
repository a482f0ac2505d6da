"""Draws and starts that an exact model refuses."""

from typing import Any, NamedTuple

import pytest
from gymnasium import spaces

import edugym


class Far(NamedTuple):
    """A walk whose start is drawn from the places 0 to `n_starts` - 1, and that ends at place 0."""

    n_starts: int
    by_choice: bool = False

    @property
    def observation_space(self) -> spaces.Discrete:
        """The places."""
        return spaces.Discrete(self.n_starts + 2)

    @property
    def action_space(self) -> spaces.Discrete:
        """Two ways to go left."""
        return spaces.Discrete(2)

    def initial(self, rng: Any) -> int:
        """Draw the first place."""
        return int(rng.choice(self.n_starts)) if self.by_choice else int(rng.integers(self.n_starts))

    def transition(self, state: int, action: int, rng: Any) -> int:
        """Go left."""
        return max(state - 1, 0)

    def reward(self, state: int, action: int, next_state: int, rng: Any) -> float:
        """Nothing."""
        return 0.0

    def terminal(self, state: int) -> bool:
        """At the left end."""
        return state == 0

    def observation(self, state: int, rng: Any) -> int:
        """The place."""
        return state


@pytest.mark.parametrize("by_choice", [False, True])
def test_a_draw_from_too_many_values(by_choice: bool) -> None:
    """A list of a billion ways would fill the memory; the sentence names the number and the limit."""
    with pytest.raises(ValueError, match=r"1000000000.*20000"):
        edugym.finite_model(Far(10**9, by_choice))


def test_an_episode_that_starts_at_its_end() -> None:
    """The model would count it as over, and a step would go on from there."""
    with pytest.raises(ValueError, match=r"initial must return a state that is not terminal, but can return 0"):
        edugym.finite_model(Far(5))
