"""The results of repeated training, as one tidy table."""

import hashlib
import io
import json
import os
from collections import Counter
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, TypeAlias

import numpy as np

from edugym.checks.parameters import a_number, a_path, a_text, in_short, one_of, several, whole_number
from edugym.experiments.results.rows import MEASURED, WHOLE, Learned, Rows, with_types
from edugym.experiments.results.statistics import Interval, mean_interval, paired_difference, share_interval
from edugym.mdp.protocol import Integers, Reals
from edugym.system.extras import require
from edugym.system.files import write_whole

if TYPE_CHECKING:
    import pandas

IN_EVERY_ROW = ("method", "repetition", "step", "return", "training_return", "episodes")
"""The columns that a saved table always has; of the others, those whose values vary within a run."""

Period: TypeAlias = Literal["end", "training"]
"""What one value of a run is taken from: the last point of its learning curve, or the average over all of training."""


class Results:
    """Learning curves of several methods over several repetitions, with what is needed to repeat the experiment.

    Attributes:
        table: one row for each point of each learning curve (pandas.DataFrame). Its columns:

            * `method`: the label of the method; `repetition`: 0, 1, ...; `seed` and `layout_seed`: the seeds of this
              repetition, the same for every method (`layout_seed` is empty where the task has no layout);
            * `step`: the training steps so far; `return`: the mean undiscounted return of the evaluation episodes that
              were played at this step, without exploring; `training_return`: the mean undiscounted return of the
              training episodes that ended since the point before, NaN where none did; `episodes`: their number;
            * `complete`: whether this run reached its last step;
            * `environment`, `environment.height`, ..., `agent`, `agent.learning_rate`, ...: the configuration, one
              column a setting; `n_steps`, `repetitions`, ...: the arguments of the experiment; `versions`: of Python
              and packages.
        agents: the trained agents: `agents["novelty"][3]` is that of repetition 3. They are not saved, so loaded
            results have none.
    """

    def __init__(self, table: "pandas.DataFrame | Rows", agents: dict[str, dict[int, Any]] | None = None) -> None:
        """Keep a table, or the rows for one, and the agents by method and repetition."""
        self._rows = table
        self.agents: dict[str, dict[int, Any]] = {} if agents is None else agents

    def __repr__(self) -> str:
        """Which methods there are, and how many rows."""
        return f"<Results of {', '.join(self.methods)}: {len(self._rows)} rows>" if len(self._rows) else "<no Results>"

    @property
    def table(self) -> "pandas.DataFrame":
        """One row for each point of each learning curve; see the class."""
        if isinstance(self._rows, Rows):
            require("experiments", "pandas")
            self._rows = self._rows.table()
        return self._rows

    @property
    def methods(self) -> list[str]:
        """The labels of the methods, in the order in which they were given."""
        return list(dict.fromkeys([*self.agents, *map(str, np.asarray(self._rows["method"]).tolist())]))

    @property
    def complete(self) -> bool:
        """Whether every planned run reached its last step."""
        rows = self._rows
        ends = zip(rows["method"], rows["repetition"], rows["complete"], strict=True)
        done = {(method, repetition) for method, repetition, complete in ends if complete}
        return len(done) > 0 and len(done) == int(np.asarray(rows["runs"])[0])

    @property
    def last_step(self) -> int:
        """The training steps of the last point of all learning curves; 0 if there is none."""
        return int(np.max(self._rows["step"])) if len(self._rows) else 0

    def complete_agents(self, method: str) -> dict[int, Any]:
        """The agents of the complete runs of a method, by repetition."""
        final = self.final(method)
        return {i: agent for i, agent in self.agents[method].items() if not np.isnan(final[i])}

    def curves(self, method: str, column: str = "return") -> "pandas.DataFrame":
        """The learning curves of a method: one row a step, one column a repetition, NaN after an interruption.

        Args:
            method: one of `methods`.
            column: "return", "training_return" or "episodes".

        Raises:
            ValueError: an argument is none of these.
            gymnasium.error.DependencyNotInstalled: pandas is missing.
        """
        learned = self.learned(method, column)
        require("experiments", "pandas")
        import pandas

        repetitions = pandas.Index(learned.repetitions, name="repetition")
        return pandas.DataFrame(learned.values, pandas.Index(learned.steps, name="step"), repetitions)

    def learned(self, method: str, column: str = "return") -> Learned:
        """The learning curves of a method as arrays; arguments and errors as in `curves`."""
        one_of("method", method, self.methods)
        one_of("column", column, ["return", "training_return", "episodes"])
        return Learned.of(self._rows, method, column)

    def final(self, method: str, column: str = "return") -> Reals:
        """The last value of every complete run of a method.

        Args:
            method: one of `methods`.
            column: as in `curves`.

        Returns:
            Shape (n_repetitions,); NaN where a run is not complete.

        Raises:
            ValueError: an argument is none of these.
        """
        if not len(self._rows):
            return np.empty(0)
        learned = self.learned(method, column)
        curves = learned.of_repetitions(self._planned(method, "repetitions"))
        at_end = np.flatnonzero(learned.steps == self._planned(method, "n_steps"))
        return curves[at_end[0]] if len(at_end) else np.full(curves.shape[1], np.nan)

    def _planned(self, method: str, what: str) -> int:
        """The steps or repetitions of the experiment of a method: joined results come from several."""
        rows = np.flatnonzero(np.asarray(self._rows["method"]) == method)
        return int(np.asarray(self._rows[what])[rows[0] if len(rows) else 0])

    def at(self, method: str, step: int, column: str = "return") -> Reals:
        """The value of every complete run of a method after a number of training steps.

        Args:
            method: one of `methods`.
            step: the training steps; the learning curves have a point there.
            column: as in `curves`.

        Returns:
            Shape (n_repetitions,); NaN where a run is not complete.

        Raises:
            ValueError: an argument is none of these.
        """
        steps, curves = self._complete_curves(method, column)
        step = whole_number("step", step, 0)
        here = np.flatnonzero(steps == step)
        if not len(here) and not np.isnan(self.final(method)).all():
            points = in_short(steps.tolist())
            raise ValueError(f"step must be a point of the learning curves, {points}, but is {in_short(step)}")
        return curves[here[0]] if len(here) else np.full(curves.shape[1], np.nan)

    def late(self, method: str, points: int = 5, column: str = "return") -> Reals:
        """The mean of the last points of the learning curve of every complete run of a method.

        Args:
            method: one of `methods`.
            points: the number of points, 1 or more.
            column: as in `curves`.

        Returns:
            Shape (n_repetitions,); NaN where a run is not complete, or where one of these points has no value.

        Raises:
            ValueError: an argument is none of these.
        """
        points = whole_number("points", points, 1)
        _, curves = self._complete_curves(method, column)
        values: Reals = curves[-points:].mean(axis=0)
        return values

    def _complete_curves(self, method: str, column: str = "return") -> tuple[Integers, Reals]:
        """The steps, and the learning curves with a column for every repetition; NaN in those not complete."""
        final, learned = self.final(method), self.learned(method, column)
        curves = learned.of_repetitions(len(final))
        curves[:, np.isnan(final)] = np.nan
        return learned.steps, curves

    def average(self, method: str, column: str = "return") -> Reals:
        """The average over training of every complete run of a method: how well it did while it learned.

        Args:
            method: one of `methods`.
            column: "return" (the area under the learning curve, by trapezoids, divided by the training steps) or
                "training_return" (the mean return of all training episodes that ended, each with the same weight).

        Returns:
            Shape (n_repetitions,); NaN where a run is not complete, or where no episode ended.

        Raises:
            ValueError: an argument is none of these.
        """
        one_of("column", column, ["return", "training_return"])
        if not len(self._rows):
            return np.empty(0)
        steps, values = self._complete_curves(method, column)
        averages: Reals
        if column == "return":
            averages = np.asarray(np.trapezoid(values, steps, axis=0)) / self._planned(method, "n_steps")
        else:
            _, episodes = self._complete_curves(method, "episodes")
            with np.errstate(invalid="ignore"):  # 0 / 0 is NaN: no episode ended, or the run is not complete
                averages = np.nansum(values * episodes, axis=0) / np.nansum(episodes, axis=0)
        return averages

    def mean(self, method: str, column: str = "return", over: Period = "end") -> Interval:
        """The mean of a method over its complete runs, with its interval.

        Args:
            method: one of `methods`.
            column: as in `final` or, over training, as in `average`.
            over: "end" takes the last value of each run (`final`), "training" its average over training (`average`).

        Raises:
            ValueError: an argument is none of these.
        """
        return mean_interval(self._values(method, column, over))

    def share(self, method: str, at_least: float, column: str = "return", over: Period = "end") -> Interval:
        """The share of complete runs with a value of `at_least` this much; other arguments as in `mean`.

        Raises:
            ValueError: `at_least` is no number, or as in `mean`.
        """
        a_number("at_least", at_least)
        values = self._values(method, column, over)
        return share_interval(values[~np.isnan(values)] >= at_least)

    def difference(self, method: str, other: str, column: str = "return", over: Period = "end") -> Interval:
        """The mean of `method` minus `other`, paired by repetition; other arguments as in `mean`.

        Raises:
            ValueError: as in `mean`.
        """
        one_of("other", other, self.methods)
        return paired_difference(self._values(method, column, over), self._values(other, column, over))

    def _values(self, method: str, column: str, over: Period) -> Reals:
        """One value of each complete run."""
        one_of("over", over, ["end", "training"])
        return self.final(method, column) if over == "end" else self.average(method, column)

    def renamed(self, label: str) -> "Results":
        """The results of a single method under another label.

        Raises:
            ValueError: the label is no text.
        """
        a_text("label", label)
        agents = [*self.agents.values()]
        return Results(self.table.assign(method=label), {label: agents[0]} if agents else {})

    def save(self, path: str | os.PathLike[str]) -> Path:
        """Write the table as a compact CSV file, and a JSON file beside it with what is the same in all rows.

        The JSON file has the name of the CSV file with `.json` added. It holds the configuration, seeds and layout
        seeds, and a hash of the CSV file, so that two files that do not belong together are noticed.

        Raises:
            ValueError: the path is none.
            OSError: a file cannot be written.
        """
        path = a_path("path", path)
        import pandas

        rest = self.table
        about: dict[str, Any] = {"columns": list(rest.columns)}
        for key in ("all", "method", "repetition"):
            groups = rest[key] if key in rest else pandas.Series("", rest.index)
            grouped = rest.drop(columns=list(IN_EVERY_ROW)).groupby(groups, sort=False)
            different = grouped.nunique(dropna=False).max()
            same = [column for column in different.index if different[column] <= 1]
            about[key] = {
                str(group): {column: _plain(rows[column].iloc[0]) for column in same} for group, rows in grouped
            }
            rest = rest.drop(columns=same)
        contents = _csv(rest)
        about["sha256"] = hashlib.sha256(contents).hexdigest()
        write_whole(_beside(path), (json.dumps(about, ensure_ascii=False, indent=1) + "\n").encode())
        return write_whole(path, contents)

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> "Results":
        """Read a table that `save` wrote.

        Raises:
            OSError: a file cannot be read.
            ValueError: the file is not a table of results, or the JSON file beside it belongs to another one.
            gymnasium.error.DependencyNotInstalled: pandas is missing.
        """
        require("experiments", "pandas")
        import pandas

        path = a_path("path", path)
        contents = path.read_bytes()
        exact = {column: lambda text: float(text or "nan") for column in ("return", "training_return")}
        try:
            table = pandas.read_csv(
                io.BytesIO(contents), converters=exact, dtype={"method": str}, keep_default_na=False, na_values=[""]
            )
        except ValueError as error:
            raise ValueError(f"{path} is not a table of results: {str(error).strip()}") from None
        if _beside(path).exists():
            about = _read_about(path, contents)
            shared = {}
            for key in ("all", "method", "repetition"):
                groups = table[key].map(str) if key in table else [""] * len(table)
                for column in next(iter(about[key].values()), {}):
                    shared[column] = [about[key][group][column] for group in groups]
            table = pandas.concat([table, pandas.DataFrame(shared)], axis="columns")[about["columns"]]
        missing = [column for column in MEASURED if column not in table]
        if missing:
            raise ValueError(f"{path} is not a table of results: it has no column {missing[0]!r}")
        for column in (*WHOLE, "complete"):
            values = pandas.to_numeric(table[column], errors="coerce").to_numpy(float)
            is_flag = column == "complete"
            if not (np.isin(values, (0, 1)) if is_flag else values % 1 == 0).all():
                needed = "True or False" if is_flag else "whole numbers"
                raise ValueError(f"{path} is not a table of results: its column {column!r} must hold {needed}")
        return cls(with_types(table))


def _beside(path: str | os.PathLike[str]) -> Path:
    """The path of the JSON file that belongs to a CSV file."""
    return Path(f"{os.fspath(path)}.json")


def _read_about(path: str | os.PathLike[str], contents: bytes) -> dict[str, Any]:
    """Read the JSON file beside a CSV file with these contents."""
    try:
        about: dict[str, Any] = json.loads(_beside(path).read_bytes())
        belongs = about["sha256"] == hashlib.sha256(contents).hexdigest()
    except (ValueError, TypeError, KeyError):
        raise ValueError(f"{_beside(path)} is not the file that `save` wrote beside {path}") from None
    if not belongs:
        raise ValueError(f"{_beside(path)} belongs to other results than {path}: one of them was changed alone")
    return about


def _csv(table: "pandas.DataFrame") -> bytes:
    return table.to_csv(index=False, lineterminator="\n").encode()


def _plain(value: Any) -> Any:
    """A number, text or boolean as JSON can hold it, and None for no value."""
    plain = value.item() if isinstance(value, np.generic) else value
    return plain if isinstance(plain, bool | int | float | str) and plain == plain else None


def joined(parts: Iterable[Results]) -> Results:
    """Join the results of several experiments whose methods have different labels.

    Raises:
        ValueError: there is none, one is something else, or two of them have a method of the same label.
    """
    import pandas

    parts = several("parts", parts, Results, "one or more Results")
    if not parts:
        raise ValueError("parts must be one or more Results, but is []")
    counts = Counter(label for part in parts for label in part.methods)
    for label in counts:
        if counts[label] > 1:
            raise ValueError(f"parts must have methods of different labels, but {counts[label]} of them have {label!r}")
    table = pandas.concat([part.table for part in parts], ignore_index=True)
    if len(table):
        table["runs"] = sum(int(part.table["runs"].iloc[0]) for part in parts if len(part.table))
    return Results(table, {label: agents for part in parts for label, agents in part.agents.items()})
