"""The results of repeated training, as one tidy table."""

import os
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from edugym.results.statistics import Interval, mean_interval, paired_difference, share_interval
from edugym.extras import require
from edugym.files import write_whole
from edugym.checks import one_of
from edugym.mdp.protocol import Reals

if TYPE_CHECKING:
    import pandas

MEASURED = (
    "method", "repetition", "seed", "layout_seed", "step", "return", "training_return", "episodes", "complete"
)  # fmt: skip
"""The columns that every table has; the rest say what was done."""


@dataclass(frozen=True)
class Results:
    """Learning curves of several methods over several repetitions, with what is needed to do it all again.

    Attributes:
        table: one row for each point of each learning curve (pandas.DataFrame). Its columns:

            * `method`: the label of the method; `repetition`: 0, 1, ...; `seed` and `layout_seed`: what this repetition
              was made from (the same for every method; no `layout_seed` where the task has none);
            * `step`: after how many training steps; `return`: the mean undiscounted return of the evaluation episodes
              played then, without exploring; `training_return`: the mean return of the training episodes that ended
              since the point before, NaN where none did; `episodes`: how many those are;
            * `complete`: whether this run went on to its last step;
            * `environment`, `environment.height`, ..., `agent`, `agent.learning_rate`, ...: the configuration, one
              column a setting; `n_steps`, `repetitions`, ...: the arguments of the experiment; `versions`: of Python
              and packages.
        agents: the trained agents: `agents["novelty"][3]` is that of repetition 3. Not saved: empty in loaded results.
    """

    table: "pandas.DataFrame"
    agents: dict[str, dict[int, Any]] = field(default_factory=dict)

    @property
    def methods(self) -> list[str]:
        """The labels of the methods, in the order in which they were given."""
        return list(dict.fromkeys([*self.agents, *map(str, self.table["method"].unique())]))

    @property
    def complete(self) -> bool:
        """Whether every planned run was done to its last step."""
        done = self.table[self.table["complete"]][["method", "repetition"]].drop_duplicates()
        return len(done) > 0 and len(done) == int(self.table["runs"].iloc[0])

    def complete_agents(self, method: str) -> dict[int, Any]:
        """The agents of the runs that were done to the last step, by repetition."""
        final = self.final(method)
        return {i: agent for i, agent in self.agents[method].items() if not np.isnan(final[i])}

    def curves(self, method: str, column: str = "return") -> "pandas.DataFrame":
        """The learning curves of a method: one row a step, one column a repetition, NaN where a run had stopped.

        Args:
            method: one of `methods`.
            column: `return` or `training_return`.

        Raises:
            ValueError: an argument is none of these.
        """
        one_of("method", method, self.methods)
        one_of("column", column, ["return", "training_return", "episodes"])
        rows = self.table[self.table["method"] == method]
        return rows.pivot(index="step", columns="repetition", values=column)

    def final(self, method: str, column: str = "return") -> Reals:
        """The last value of every complete run of a method, shape (n_repetitions,), NaN where there is no complete run.

        Args:
            method: one of `methods`.
            column: as in `curves`.

        Raises:
            ValueError: an argument is none of these.
        """
        if self.table.empty:
            return np.empty(0)
        curves = self.curves(method, column).reindex(columns=range(int(self.table["repetitions"].iloc[0])))
        n_steps = int(self.table["n_steps"].iloc[0])
        last: Reals = curves.reindex([n_steps]).to_numpy(float)[0]
        return last

    def mean(self, method: str, column: str = "return") -> Interval:
        """The mean final value of a method, with its interval."""
        return mean_interval(self.final(method, column))

    def share(self, method: str, at_least: float) -> Interval:
        """The share of complete runs whose final return is `at_least` as high, with its interval."""
        final = self.final(method)
        return share_interval(final[~np.isnan(final)] >= at_least)

    def difference(self, method: str, other: str, column: str = "return") -> Interval:
        """How much more the final value of `method` is than that of `other`, by repetition, with its interval."""
        return paired_difference(self.final(method, column), self.final(other, column))

    def save(self, path: str | os.PathLike[str]) -> Path:
        """Write the table as CSV: all of it or, when something goes wrong, nothing.

        Raises:
            OSError: the file cannot be written.
        """
        return write_whole(path, self.table.to_csv(index=False, lineterminator="\n").encode())

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> "Results":
        """Read what `save` wrote.

        Raises:
            OSError: the file cannot be read.
            ValueError: it is not a table of results.
            gymnasium.error.DependencyNotInstalled: pandas is missing.
        """
        require("experiments", "pandas")
        import pandas

        exact = {column: lambda text: float(text or "nan") for column in ("return", "training_return")}
        table = pandas.read_csv(path, converters=exact, keep_default_na=False, na_values=[""])
        missing = [column for column in MEASURED if column not in table]
        if missing:
            raise ValueError(f"{path} is not a table of results: it has no column {missing[0]!r}")
        return cls(with_types(table))


def with_types(table: "pandas.DataFrame") -> "pandas.DataFrame":
    """The table with the types of its columns settled, so that a saved and loaded one equals the first.

    Measured columns have NumPy's types; those of the configuration, which a method may lack, pandas' types with gaps.
    """
    whole = ["repetition", "seed", "step", "episodes"]
    table = table.astype({**dict.fromkeys(whole, "int64"), "return": float, "training_return": float, "complete": bool})
    others = table.columns.difference([*whole, "return", "training_return", "complete"])
    table[others] = table[others].convert_dtypes()
    return table.astype({"layout_seed": "Int64"})
