"""What `repeat` returned, against what was asked for."""

from collections.abc import Callable, Mapping
from itertools import combinations
from typing import Any

from edugym.experiments.configuration import described, task
from edugym.experiments.results.tables import Results
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.values import given


def check_results(
    what: str,
    answer: Any,
    *,
    asked: Mapping[str, Any],
    methods: Mapping[str, Callable[[Any], Any]],
    environment: Any,
) -> Results:
    """Check with what an experiment was done.

    Args:
        what: the name of the answer, for the sentence.
        answer: the student's value.
        asked: by the name of a column of the results, what it should hold: "n_steps", "repetitions", ... (see
            `Results.table`).
        methods: by label, functions that make the agents that were asked for; others may be there as well.
        environment: what the agents are made for, made by its id. All of its parameters should be those of the
            experiment, but for the seed of a layout.

    Raises:
        WrongAnswer: it is no results, or those of another experiment.
    """
    given(what, answer)
    if not isinstance(answer, Results):
        hint = ": call it" if callable(answer) else ""
        if isinstance(answer, list | tuple | dict):
            hint = ": one call takes all methods, in one dictionary"
        raise WrongAnswer(
            f"{what} should be what `repeat(...)` returns, but is of the type {type(answer).__name__}{hint}"
        )
    if not answer.complete:
        raise WrongAnswer(f"{what} is not complete: the experiment was stopped, so run its cell again")
    rows = answer.table.groupby("method", sort=False).first()
    spec = environment.spec
    defaults = task(spec.id).settings  # what an environment was not made with, the results do not tell
    told = {str(column): rows[column].iloc[0] for column in rows}
    others = dict.fromkeys(column for column in told if column.startswith("environment."))
    asked_task = task(spec.id, spec.kwargs).settings
    wanted = {"environment": asked_task["environment"]} | others | asked_task | dict(asked)  # the task comes first
    for column, value in wanted.items():
        if column.endswith("layout_seed"):
            continue
        found = told.get(column, defaults.get(column))
        if found != value:
            setting = column.rpartition(".")[2]
            raise WrongAnswer(f"{what} should be an experiment with {setting} {value}, but it has {setting} {found}")
    missing = [label for label in methods if label not in answer.methods]
    if missing:
        there = ", ".join(answer.methods)
        raise WrongAnswer(f"{what} should have the method {missing[0]!r}, but has only {there}: keep the labels")
    agents = answer.table.filter(regex=r"^(method|agent)").groupby("method", sort=False).first()
    for one, other in combinations(agents.index, 2):
        if agents.loc[[one]].to_dict("records") == agents.loc[[other]].to_dict("records"):
            raise WrongAnswer(f"{what} should have different methods, but {one!r} and {other!r} are the same agent")
    for label, make in methods.items():
        for column, value in described(make(environment), "agent").items():
            found = rows.loc[label].get(column)
            if found != value:
                setting = column.rpartition(".")[2]
                raise WrongAnswer(f"{what} should have for {label!r} the {setting} {value}, but it has {found}")
    return answer
