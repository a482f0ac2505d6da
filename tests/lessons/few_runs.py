"""Experiments in few runs, for tests of what lessons show; whether their claims hold is the matter of other tests."""

import functools
from typing import Any

from edugym.results.tables import Results
from edugym.training import repeat as module
from edugym.training.repeat import repeat


class Again(dict[int, Any]):
    """The agents of a few runs, which stand for those of all others too."""

    def __missing__(self, run: int) -> Any:
        """Return an agent of the runs that there are."""
        return self[run % len(self)]


@functools.wraps(repeat)
def few_runs(*arguments: Any, most: int = 2, **how: Any) -> Results:
    """Return the results of `repeat` with so many repetitions at most."""
    results = repeat(*arguments, **how | {"repetitions": min(how.get("repetitions", 10), most)})
    return Results(results.table, {method: Again(agents) for method, agents in results.agents.items()})


def limit_runs() -> None:
    """Let all experiments of this process, in whatever module is imported from now on, take two runs."""
    module.repeat = few_runs
