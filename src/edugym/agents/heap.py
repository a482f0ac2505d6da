"""A priority queue in arrays."""

from typing import Annotated, NamedTuple

from edugym.agents.settings import Counter, Table
from edugym.mdp.protocol import Integers, Reals


class Heap(NamedTuple):
    """A binary heap of the numbers 0, 1, ..., each at most once: the highest priority comes out first.

    Place 1 is the root, and the children of place i are 2i and 2i + 1: no priority is higher than its parent's.

    Attributes:
        size: shape (1,): how many numbers are in the queue.
        priorities: shape (n + 1,): the priority at each place.
        items: shape (n + 1,): the number at each place.
        places: shape (n,): the place of each number, 0 for one that is not in the queue.
    """

    size: Counter
    priorities: Annotated[Reals, Table(("items + 1",))]
    items: Annotated[Integers, Table(("items + 1",))]
    places: Annotated[Integers, Table(("items",))]

    def push(self, item: int, priority: float) -> None:
        """Put a number in; one that is there already gets the higher of its two priorities."""
        place = self.places[item]
        if place == 0:
            self.size[0] += 1
            place = self.size[0]
        elif priority <= self.priorities[place]:
            return
        while place > 1 and self.priorities[place // 2] < priority:
            self._put(place, self.items[place // 2], self.priorities[place // 2])
            place //= 2
        self._put(place, item, priority)

    def pop(self) -> int:
        """Take out the number with the highest priority; the queue must not be empty."""
        top = int(self.items[1])
        self.places[top] = 0
        size = self.size[0]
        item, priority = self.items[size], self.priorities[size]  # the last fills the hole, from above
        size -= 1
        self.size[0] = size
        place = 1
        while 2 * place <= size:
            child = 2 * place
            if child < size and self.priorities[child + 1] > self.priorities[child]:
                child += 1
            if self.priorities[child] <= priority:
                break
            self._put(place, self.items[child], self.priorities[child])
            place = child
        if size > 0:
            self._put(place, item, priority)
        return top

    def _put(self, place: int, item: int, priority: float) -> None:
        self.priorities[place] = priority
        self.items[place] = item
        self.places[item] = place
