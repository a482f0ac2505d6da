"""Players of Tamagotchi without a table: one that votes over the words, and one that listens to nothing."""

from typing import Annotated, Any, NamedTuple

from edugym.agents.settings import Counter, Table, new
from edugym.agents.tables import greedy_action
from edugym.mdp.protocol import Random, Reals
from edugym.mdp.wrapper import wrapper


class Voter(NamedTuple):
    """A player that does what most of the first words name; ties are broken at random. It learns nothing.

    Attributes:
        votes: shape (1, 4): the number of words for each need in the present message.
        heard: the number of words that count; 1 obeys the first word.
        tabular: False, since it reads the words themselves, not the row of a table.
    """

    votes: Annotated[Reals, Table((1, 4))]
    heard: int = 1
    tabular: bool = False

    def act(self, state: Any, rng: Random) -> int:
        """Count the words, of which word k names need k mod 4, and take the need with the most."""
        self.votes[:] = 0.0
        for k in range(self.heard):
            self.votes[0, int(state[1 + k]) % 4] += 1.0
        return greedy_action(self.votes, 0, rng)

    def learn(self, reward: float) -> None:
        """Learn nothing."""

    @classmethod
    def create(cls, environment: Any, heard: int = 1) -> "Voter":
        """Create a player that counts the first `heard` words."""
        return new(cls, None, {"heard": heard})


class RoundRobin(NamedTuple):
    """A player that takes the actions in turn and looks at nothing. It learns nothing.

    Attributes:
        last: shape (1,): the last action.
    """

    last: Counter

    def act(self, state: int, rng: Random) -> int:
        """Take the action after the last one."""
        self.last[0] = (self.last[0] + 1) % 4
        return int(self.last[0])

    def learn(self, reward: float) -> None:
        """Learn nothing."""

    @classmethod
    def create(cls, environment: Any) -> "RoundRobin":
        """Create a player that has done nothing yet."""
        return new(cls, None, {})


@wrapper
class Meanings(NamedTuple):
    """A toy whose synonyms look the same to the agent: of a word it is told which need it names."""

    mdp: Any  # the toy

    def observation(self, state: Any, rng: Random) -> Any:
        """The hit points, and the need that the word names."""
        hp, word = self.mdp.observation(state, rng)
        return hp, word % 4


class Coin(NamedTuple):
    """A player of a toy with two words, each of which names two needs: it tosses a coin between them.

    Attributes:
        tabular: False, since it reads the words themselves, not the row of a table.
    """

    tabular: bool = False

    def act(self, state: Any, rng: Random) -> int:
        """Take one of the two needs k and k + 2 that word k may name."""
        return int(state[1]) + 2 * int(rng.random() * 2)

    def learn(self, reward: float) -> None:
        """Learn nothing."""

    @classmethod
    def create(cls, environment: Any) -> "Coin":
        """Create a player."""
        return cls()
