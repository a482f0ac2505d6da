"""What is said of two frequent mistakes, and that nothing is said of errors that only look like them."""

import pytest

from edugym import train
from tests.compiled.cells import LEARNER
from tests.training.slips import VALUE, answered, changed, learner, walk

SOURCE = (
    LEARNER.replace("    def act", "    count: object = np.array(0)\n\n    def act")
    + """
    @property
    def early(): return 1
    def late(step): pass
class Plain:
    fixed = property(lambda self: 1)
    def assign(self): self.fixed = 2
"""
)
EXPLAINED = [
    ("self.rate = 1.0", "self.rate NamedTuple np.array([...]) self.rate[0]", AttributeError),
    ("self.Q = self.Q", "self.Q NamedTuple self.Q[:]", AttributeError),
    ("self.count = 1", "self.count NamedTuple self.count[...]", AttributeError),
    ("self.late(1)", "late() (self, step)", TypeError),
    ("self.early", "early() early(self)", TypeError),
]
OTHERS = [
    ("self.missing", "missing", AttributeError),
    ("Plain().assign()", "setter", AttributeError),
    ("self.late(1, 2)", "3", TypeError),
    ("len(3)", "len()", TypeError),
    ("walk().fixed = 3", "walk", NameError),
]


@pytest.mark.parametrize(("line", "names", "error"), EXPLAINED + OTHERS)
def test_what_is_said_of_a_line(line: str, names: str, error: type[Exception]) -> None:
    """A remedy for a field that is assigned, and for a method without self; nothing is added to other errors."""
    agent = learner(changed(SOURCE, VALUE, f"{line}; {VALUE}"))
    says = str(answered(names, lambda: train(walk(), agent, 9), error=error))
    explained = (line, names, error) in EXPLAINED
    assert ("NamedTuple never" in says or "is self" in says) == explained
