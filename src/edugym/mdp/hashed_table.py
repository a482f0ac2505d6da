"""A table with rows only for the keys that occur, in the order in which they first appear."""

import math
from typing import Any, NamedTuple

import numpy as np

from edugym.checks.parameters import MOST_ENTRIES, in_short, true_or_false, whole_number
from edugym.mdp.protocol import Integers
from edugym.system.memory import require_memory

PRIME = 2**31 - 1
FACTOR = 742_938_285
"""The multiplier of a good random generator (Fishman and Moore, 1986): keys that differ little get slots far apart."""


class HashedTable(NamedTuple):
    """Gives every key, an array of numbers, a row of its own: 0, 1, 2, ... in order of first appearance.

    It is exact: keys are compared number by number, so different keys never share a row. Open addressing with linear
    probing (Knuth, The Art of Computer Programming, volume 3, section 6.4, Algorithm L); at most half of the slots are
    ever taken. Memory is reserved for `capacity` keys, and the machine provides it only as rows are used.

    Attributes:
        keys: shape (capacity, length of a key): those met, in order.
        slots: shape (n_slots,): the row of the key that belongs in a slot plus 1; 0 where there is none.
        rows: shape (1,): how many rows are used.
        shares: whether all new keys share the last row when the table is full; if not, they are an error.
    """

    keys: Any
    slots: Integers
    rows: Integers
    shares: bool

    @property
    def used(self) -> int:
        """How many rows are used."""
        return int(self.rows[0])

    @property
    def capacity(self) -> int:
        """How many rows there are."""
        return len(self.keys)

    def row(self, key: Any) -> int:
        """The row of a key, which gets the next free one if it is new.

        Args:
            key: an array with as many numbers as the keys of this table have, in any shape.

        Raises:
            ValueError: the table is full, or a number in the key is not finite.
        """
        slot = self.slot(key)
        if self.slots[slot] > 0:
            return int(self.slots[slot]) - 1
        row = self.rows[0]
        if row == len(self.keys):
            if self.shares:
                return int(row) - 1
            raise ValueError("the hashed table is full: give it a higher capacity, or overflow=True")
        for k in range(key.size):
            self.keys[row, k] = key.flat[k]
        self.slots[slot] = row + 1
        self.rows[0] = row + 1
        return int(row)

    def slot(self, key: Any) -> int:
        """The slot that holds a key, or the free one where it belongs."""
        code = 0
        for k in range(key.size):
            value = key.flat[k]
            if not math.isfinite(value):
                raise ValueError("an observation with a number that is not finite (NaN or infinity) has no row")
            code = (code + int(value % PRIME) + int(value % 1.0 * PRIME)) * FACTOR % PRIME
        slot = (code ^ (code >> 13)) % len(self.slots)
        while self.slots[slot] > 0 and not self.holds(self.slots[slot] - 1, key):
            slot = (slot + 1) % len(self.slots)
        return int(slot)

    def holds(self, row: int, key: Any) -> bool:
        """Whether a row is that of a key."""
        k = 0
        while k < key.size and self.keys[row, k] == key.flat[k]:
            k += 1
        return k == int(key.size)

    @classmethod
    def create(cls, key: Any, capacity: int, overflow: bool = False) -> "HashedTable":
        """An empty table.

        Args:
            key: an array like the keys, of int64 or float64.
            capacity: how many rows there are, from 1 to 2^28.
            overflow: whether all new keys share the last row when the table is full.

        Raises:
            ValueError: a parameter is not as said.
        """
        if not isinstance(key, np.ndarray) or key.dtype not in (np.int64, np.float64):
            raise ValueError(f"key must be an array of int64 or float64, but is {in_short(key)}")
        capacity = whole_number("capacity", capacity, 1, MOST_ENTRIES)
        shares = true_or_false("overflow", overflow)
        require_memory("keys", (capacity, key.size), "take a lower capacity")
        keys = np.zeros((capacity, key.size), key.dtype)
        return cls(keys, np.zeros(2 * capacity + 1, np.int64), np.zeros(1, np.int64), shares)
