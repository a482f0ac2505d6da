"""The priority queue in arrays, against a sorted list."""

from hypothesis import given
from hypothesis import strategies as st

from edugym.agents.heap import Heap
from edugym.agents.settings import new

N = 9
pushes = st.tuples(st.integers(0, N - 1), st.sampled_from([0.5, 1.0, 2.0, 3.0, 7.0]))


def empty() -> Heap:
    """A queue of the numbers below N."""
    return new(Heap, None, {}, **{"items": N, "items + 1": N + 1})


@given(st.lists(st.one_of(pushes, st.none()), max_size=60))
def test_it_is_a_queue_by_priority(operations: list[tuple[int, float] | None]) -> None:
    """Whatever is pushed and popped (None): the highest comes first, and each number is there once."""
    heap = empty()
    there: dict[int, float] = {}
    for operation in operations:
        if operation is not None:
            item, priority = operation
            heap.push(item, priority)
            there[item] = max(priority, there.get(item, 0.0))
        elif there:
            item = heap.pop()
            assert there.pop(item) >= max(there.values(), default=0.0)
        n = heap.size[0]
        assert n == len(there)
        assert {int(heap.items[k]): float(heap.priorities[k]) for k in range(1, n + 1)} == there
        assert all(heap.places[heap.items[k]] == k for k in range(1, n + 1))
        assert (heap.places > 0).sum() == n


def test_by_hand() -> None:
    """A second push raises a priority and never lowers it."""
    heap = empty()
    for item, priority in ((4, 1.0), (2, 5.0), (7, 3.0), (4, 9.0), (2, 0.1)):
        heap.push(item, priority)
    assert [heap.pop() for _ in range(3)] == [4, 2, 7]
    assert heap.size[0] == 0
