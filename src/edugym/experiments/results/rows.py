"""The rows of a table of results in plain lists: they wait there for somebody to ask for a pandas table."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from edugym.mdp.protocol import Integers, Reals

if TYPE_CHECKING:
    import pandas

MEASURED = (
    "method", "repetition", "seed", "layout_seed", "step", "return", "training_return", "episodes", "complete"
)  # fmt: skip
"""The columns that every table has; the other columns hold the configuration."""

WHOLE = ("repetition", "seed", "step", "episodes")
"""The columns that must hold a whole number in every row."""


@dataclass(frozen=True)
class Rows:
    """The rows of a table of results. Few programs need the table itself, and pandas takes half a second to import.

    Attributes:
        measured: the columns `MEASURED`: a list each, with one value a row.
        configuration: by method: the settings, which are the same in all rows of the method.
    """

    measured: dict[str, list[Any]]
    configuration: dict[str, dict[str, Any]]

    def __len__(self) -> int:
        """The number of rows."""
        return len(self.measured["method"])

    def __getitem__(self, column: str) -> NDArray[Any]:
        """The values of a column, one a row; None where a method lacks the setting."""
        if column in self.measured:
            values = self.measured[column]
        else:
            values = [self.configuration[method].get(column) for method in self.measured["method"]]
        return np.array(values) if values else np.empty(0, object)

    def table(self) -> "pandas.DataFrame":
        """The same rows as a table."""
        import pandas

        configuration = pandas.DataFrame.from_dict(self.configuration, orient="index")
        configuration = configuration.dropna(axis="columns", how="all")
        return with_types(pandas.DataFrame(self.measured, columns=list(MEASURED)).join(configuration, on="method"))


def with_types(table: "pandas.DataFrame") -> "pandas.DataFrame":
    """The table with settled column types, so that saving and loading gives the same table.

    Measured columns get NumPy's types. Columns of the configuration get pandas' types that allow gaps, since a method
    may lack a setting.
    """
    table = table.astype({**dict.fromkeys(WHOLE, "int64"), "return": float, "training_return": float, "complete": bool})
    others = table.columns.difference([*WHOLE, "return", "training_return", "complete"])
    table[others] = table[others].convert_dtypes()
    return table.astype({"layout_seed": "Int64"})


@dataclass(frozen=True)
class Learned:
    """The learning curves of a method.

    Attributes:
        steps: shape (n_points,): the training steps.
        repetitions: shape (n_repetitions,): which repetitions have a point.
        values: shape (n_points, n_repetitions): NaN where a repetition has no point.
    """

    steps: Integers
    repetitions: Integers
    values: Reals

    @classmethod
    def of(cls, rows: "Rows | pandas.DataFrame", method: str, column: str) -> "Learned":
        """Arrange the values of a column."""
        chosen = np.asarray(rows["method"]) == method
        step, repetition, value = (np.asarray(rows[name])[chosen] for name in ("step", "repetition", column))
        steps, point = np.unique(step.astype(int), return_inverse=True)
        repetitions, place = np.unique(repetition.astype(int), return_inverse=True)
        values = np.full((len(steps), len(repetitions)), np.nan)
        values[point, place] = value.astype(float)
        return cls(steps, repetitions, values)

    def of_repetitions(self, n: int) -> Reals:
        """The values of repetitions 0 to n - 1, shape (n_points, n)."""
        values, planned = np.full((len(self.steps), n), np.nan), self.repetitions < n
        values[:, self.repetitions[planned]] = self.values[:, planned]
        return values
