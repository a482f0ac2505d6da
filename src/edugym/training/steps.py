"""Taking many training steps in short calls, between which Ctrl-C, a stop and the progress bar have their turn."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Generic, Protocol, TypeVar

from edugym.checks.parameters import in_short, true_or_false
from edugym.system.interrupts import SignalGuard, Stopped
from edugym.training.progress import progress_bar


class Learning(Protocol):
    """Something that learns step by step."""

    @property
    def is_compiled(self) -> bool:
        """Whether it runs as machine code by now."""

    def learn(self, at_most: int) -> int:
        """Take training steps for about 0.02 s; return their number."""


Learns = TypeVar("Learns", bound=Learning)


@dataclass(frozen=True)
class Taken(Generic[Learns]):
    """The steps that were taken.

    Attributes:
        learning: what has learned; None if Ctrl-C came before it was made.
        n_steps: how many.
        of: how many there should have been.
        interrupted: whether Ctrl-C ended them.
        loop: the line of the loop in a student's code that Ctrl-C had to end; 0 if there was none.
    """

    learning: Learns | None
    n_steps: int
    of: int
    interrupted: bool
    loop: Any

    def __str__(self) -> str:
        """How far it came."""
        where = f", in the loop at line {self.loop} of your code" if self.loop else ""
        return f"{self.n_steps} of {self.of} steps{where}"


def take_steps(
    n_steps: int,
    begin: Callable[[int], Learns],
    measure: Callable[[int, Learns, Callable[[], bool]], None],
    *,
    measure_every: int,
    stop: Any,
    progress: Any,
) -> Taken[Learns]:
    """Take training steps, and measure every so often.

    Args:
        n_steps: how many.
        begin: makes what learns; it is told how many steps to expect.
        measure: called before the first step, after every `measure_every` steps and after the last. It is given the
            number of steps so far, what learns, and a function that says whether to stop.
        measure_every: the steps between two measurements.
        stop: a `threading.Event` or None. When it is set, no more steps are taken.
        progress: whether to show a progress bar.

    Raises:
        ValueError: `stop` or `progress` is something else.
        Exception: what the student's code raises.
    """
    true_or_false("progress", progress)
    check_stop(stop)
    learning: Learns | None = None
    done, interrupted, guard = 0, False, SignalGuard(stop)
    try:
        with guard, progress_bar(n_steps, "steps", shown=progress) as bar:
            expected = 0 if stop is not None and stop.is_set() else n_steps  # no steps to come: do not compile
            learning = begin(expected)
            measure(done, learning, guard.should_stop)
            while done < n_steps and not guard.should_stop():
                # A call of `learning.learn` lasts about 0.02 s. While it runs machine code, Ctrl-C waits for its end. A
                # run can begin interpreted and become compiled, so we look at `is_compiled` before each call.
                guard.defer(learning.is_compiled)
                steps = learning.learn(at_most=min(n_steps - done, measure_every - done % measure_every))
                done += steps
                if done % measure_every == 0 or done == n_steps:
                    measure(done, learning, guard.should_stop)
                bar.update(steps)
    except Stopped:
        pass
    except KeyboardInterrupt:
        interrupted = True
    return Taken(learning, done, n_steps, interrupted, guard.loop)


def check_stop(stop: Any) -> None:
    """Refuse what is neither an event nor None."""
    if isinstance(stop, type):
        raise ValueError(f"stop must be a threading.Event or None, but is the class {stop.__name__}: add brackets, ()")
    if stop is not None and not (hasattr(stop, "is_set") and hasattr(stop, "set")):
        raise ValueError(f"stop must be a threading.Event or None, but is {in_short(stop)}")
