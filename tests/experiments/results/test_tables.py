"""Tables of results: every number from a table small enough to work it out by hand, and what saving keeps."""

import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest

from edugym import Results
from edugym.experiments.results.rows import MEASURED, with_types
from edugym.experiments.results.tables import joined
from tests.messages import named

NAN = np.nan
STEPS = [0, 10, 30]  # not evenly spaced
CURVES: dict[str, Any] = {  # by method: of each repetition the returns, the training returns and the episodes
    "1": [([0, 4, 8], [NAN, 1, 5], [0, 3, 1]), ([2, 2, 6], [NAN, NAN, NAN], [0, 0, 0]), ([9, 9], [NAN, 9], [0, 9])],
    "NA": [([0, 1, 2], [NAN, 2, 2], [0, 1, 1]), ([0, 0.1 + 0.2, 5], [NAN, 3, 4], [0, 1, 3]), ([0], [NAN], [0])],
}
"""The third repetition of each method was interrupted. Both labels look like something else than a text."""


def table(curves: Any = None, steps: Any = None) -> pd.DataFrame:
    """The rows of such an experiment; one setting for all, one of a method, one of a repetition, one of a run."""
    curves, steps = CURVES if curves is None else curves, STEPS if steps is None else steps
    rows = [
        {
            "method": method, "repetition": i, "seed": 100 + i, "layout_seed": None if i == 1 else 7 * i, "step": step,
            "return": returns[k], "training_return": training[k], "episodes": episodes[k],
            "complete": len(returns) == len(steps), "environment": "Walk", "agent.rate": 0.5 if method == "1" else None,
            "agent.greedy": method == "1", "own": f"{method} {i}", "n_steps": steps[-1],
            "repetitions": max(map(len, curves.values())), "runs": sum(map(len, curves.values())),
        }
        for method, runs in curves.items()
        for i, (returns, training, episodes) in enumerate(runs)
        for k, step in enumerate(steps[: len(returns)])
    ]  # fmt: skip
    return with_types(pd.DataFrame(rows))


RESULTS = Results(table())
WHOLE = Results(table({method: runs[:2] for method, runs in CURVES.items()}))
MIXED = Results(table({"1": CURVES["1"], "NA": CURVES["1"][1::-1]}))
NONE_COMPLETE = Results(table({"1": CURVES["1"][2:]}))


def equal(values: Any, expected: Any) -> None:
    """Whether numbers are equal, NaN too."""
    np.testing.assert_allclose(np.asarray(values), expected, rtol=1e-14)


@pytest.mark.parametrize(
    ("method", "column", "final", "at_10", "late_2"),
    [
        ("1", "return", [8, 6, NAN], [4, 2, NAN], [6, 4, NAN]),
        ("1", "training_return", [5, NAN, NAN], [1, NAN, NAN], [3, NAN, NAN]),
        ("1", "episodes", [1, 0, NAN], [3, 0, NAN], [2, 0, NAN]),
        ("NA", "return", [2, 5, NAN], [1, 0.3, NAN], [1.5, 2.65, NAN]),
    ],
)
def test_values_of_each_run(method: str, column: str, final: Any, at_10: Any, late_2: Any) -> None:
    """The interrupted run has none, though it has points."""
    equal(RESULTS.final(method, column), final)
    equal(RESULTS.at(method, 10, column), at_10)
    equal(RESULTS.late(method, 2, column), late_2)
    equal(RESULTS.late(method, 1, column), final)
    seven = Results(table({"Q": [([64, 32, 16, 8, 4, 2, 1], [NAN] * 7, [0] * 7)]}, [*range(7)]))
    equal(seven.late("Q"), [31 / 5])  # five points, unless told otherwise
    with pytest.raises(ValueError, match=r"points .* 0"):
        seven.late("Q", 0)


def test_a_curve_keeps_what_an_interrupted_run_has() -> None:
    """One row a step, one column a repetition."""
    curve = RESULTS.curves("1")
    assert curve.index.tolist() == STEPS
    assert [*map(int, curve.columns)] == [0, 1, 2]
    equal(curve, [[0, 2, 9], [4, 2, 9], [8, 6, NAN]])
    with pytest.raises(ValueError, match=r"method .*'1', 'NA'.*'Q'"):
        RESULTS.curves("Q")


def test_averages_over_training() -> None:
    """Trapezoids between uneven steps, (10 · 2 + 20 · 6) / 30; training episodes count the same, (3 · 1 + 5) / 4."""
    equal(RESULTS.average("1"), [140 / 30, 100 / 30, NAN])
    equal(RESULTS.average("1", "training_return"), [2, NAN, NAN])
    equal(RESULTS.average("NA", "training_return"), [2, 3.75, NAN])
    with pytest.raises(ValueError, match=r"column .*'episodes'"):
        RESULTS.average("1", "episodes")


def test_runs_that_have_not_begun() -> None:
    """The first of three has no point yet: its value is NaN, and the others stay in their places."""
    begun = Results(RESULTS.table[RESULTS.table["repetition"] != 0])
    for values, second in (
        (begun.final("1"), 6), (begun.at("1", 10), 2), (begun.late("1", 2), 4), (begun.average("1"), 100 / 30),
        (begun.average("NA", "training_return"), 3.75),
    ):  # fmt: skip
        equal(values, [NAN, second, NAN])


def test_means_shares_and_differences() -> None:
    """At the end, or over training; a run without a value does not count, and a value at the threshold does."""
    assert RESULTS.mean("1")[0::3] == (7, 2)
    assert RESULTS.mean("1", "training_return")[0::3] == (5, 1)
    assert RESULTS.mean("1", over="training")[0::3] == (4, 2)
    assert RESULTS.mean("NA", "training_return", "training")[0::3] == (2.875, 2)
    assert RESULTS.share("1", 6)[0::3] == (1, 2)
    assert RESULTS.share("1", 6.1)[0::3] == (0.5, 2)
    assert RESULTS.share("1", 4, over="training")[0::3] == (0.5, 2)
    assert RESULTS.share("1", 5, "training_return")[0::3] == (1, 1)
    assert RESULTS.difference("1", "NA")[0::3] == (3.5, 2)
    assert RESULTS.difference("NA", "1")[0] == -3.5
    assert RESULTS.difference("1", "NA", "training_return")[0::3] == (3, 1)
    assert RESULTS.difference("1", "NA", "training_return", "training")[0::3] == (0, 1)
    with pytest.raises(ValueError, match=r"over .*'end', 'training'.*'middle'"):
        RESULTS.mean("1", over="middle")  # type: ignore[arg-type]


def test_which_runs_are_complete() -> None:
    """All of those that were planned; an agent that was interrupted is left out."""
    assert WHOLE.complete
    assert not RESULTS.complete
    assert not NONE_COMPLETE.complete
    assert Results(table({"1": CURVES["1"][:1]})).complete
    missing = WHOLE.table[(WHOLE.table["method"] == "1") | (WHOLE.table["repetition"] == 0)]
    assert not Results(missing).complete  # a run that never began has no row
    agents = {"1": {0: "first", 1: "second", 2: "third"}, "NA": {2: "third"}}
    assert Results(table(), agents).complete_agents("1") == {0: "first", 1: "second"}
    assert Results(table(), agents).complete_agents("NA") == {}


def test_before_anything_is_complete() -> None:
    """No value is known, and a step that is not there yet is no mistake."""
    equal(NONE_COMPLETE.final("1"), [NAN])
    equal(NONE_COMPLETE.at("1", 30), [NAN])
    assert NONE_COMPLETE.mean("1").n == NONE_COMPLETE.share("1", 0).n == 0
    with pytest.raises(ValueError, match=r"step must be a point of the learning curves, \[0, 10, 30\], but is 20"):
        RESULTS.at("1", 20)
    empty = Results(table()[:0], {"1": {}})
    assert empty.methods == ["1"]
    assert not empty.complete
    assert len(empty.final("1")) == len(empty.average("1")) == 0


def test_labels_and_agents_stay_together() -> None:
    """Methods are in the order in which they were given, also one that has no row yet."""
    assert RESULTS.methods == ["1", "NA"]
    assert Results(table(), {"later": {}, "NA": {}}).methods == ["later", "NA", "1"]
    renamed = Results(table({"1": CURVES["1"]}), {"1": {0: "agent"}}).renamed("Q")
    assert (renamed.methods, renamed.agents) == (["Q"], {"Q": {0: "agent"}})
    assert NONE_COMPLETE.renamed("Q").agents == {}
    both = joined([renamed, RESULTS])
    assert both.methods == ["Q", "1", "NA"]
    assert list(both.table.index) == [*range(len(both.table))]


@pytest.mark.parametrize(
    "results",
    [RESULTS, WHOLE, MIXED, NONE_COMPLETE, Results(table().iloc[:1].copy())],
    ids=["interrupted", "whole", "partly", "one run", "one row"],
)
def test_saving_keeps_everything(results: Results, tmp_path: Path) -> None:
    """Every bit of every number, gaps, types, the order of the columns, and labels that look like numbers or gaps."""
    assert results.save(tmp_path / "results.csv") == tmp_path / "results.csv"
    loaded = Results.load(tmp_path / "results.csv")
    pd.testing.assert_frame_equal(loaded.table, results.table, check_exact=True)
    assert loaded.agents == {}


def test_the_table_is_short(tmp_path: Path) -> None:
    """What is the same in all rows, in those of a method, or in those of a repetition, is in the file beside."""
    path, beside = RESULTS.save(tmp_path / "results.csv"), tmp_path / "results.csv.json"
    assert path.read_text(encoding="utf-8").startswith("method,repetition,step,return,training_return,episodes,own\n")
    assert json.loads(beside.read_text(encoding="utf-8"))["columns"] == list(RESULTS.table.columns)
    Results(RESULTS.table.assign(own=float("nan"))).save(path)
    assert '"own": null' in beside.read_text(encoding="utf-8")  # every JSON reader takes this gap


def test_two_files_that_do_not_belong_together(tmp_path: Path) -> None:
    """A table that was changed, and a file beside it that is something else; without that file it is no table."""
    path, beside = RESULTS.save(tmp_path / "results.csv"), tmp_path / "results.csv.json"
    kept, about = path.read_bytes(), beside.read_bytes()
    path.write_bytes(kept.replace(b"8.0", b"9.0"))
    with pytest.raises(ValueError, match=r"results.csv.json .*results.csv:"):
        Results.load(path)
    path.write_bytes(kept)
    for other in (b"", b"[]", b"{}", about[:-9]):
        beside.write_bytes(other)
        with pytest.raises(ValueError, match=r"results.csv.json .* beside .*results.csv"):
            Results.load(path)
    beside.unlink()
    for column in MEASURED:
        table().drop(columns=column).to_csv(path, index=False)
        with pytest.raises(ValueError, match=f"results.csv .*no column '{column}'"):
            Results.load(path)


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ("(?s).*", "", "No columns"),
        ("(?s).*", "\0a,b\n1,2,3\n", ""),
        ("8.0", "8;0", "could not convert string to float: '8;0'"),
        ("True", "WAHR", "its column 'complete' must hold True or False"),
        ("True\n", "\n", "its column 'complete' must hold True or False"),
        ("True\n", "2\n", "its column 'complete' must hold True or False"),
        (",10,", ",10.5,", "its column 'step' must hold whole numbers"),
        (",10,", ",,", "its column 'step' must hold whole numbers"),
    ],
)
def test_a_table_that_another_program_has_changed(old: str, new: str, says: str, tmp_path: Path) -> None:
    """A spreadsheet with other words or signs, or an empty file."""
    path = tmp_path / "other.csv"
    text = table()[list(MEASURED)].to_csv(index=False)
    changed = re.sub(old, new, text, count=1)
    assert changed != text
    path.write_text(changed)
    with pytest.raises(ValueError, match=f"other.csv is not a table of results: .*{says}"):
        Results.load(path)
    path.write_bytes(text.encode("utf-16"))
    with pytest.raises(ValueError, match=r"other.csv is not a table of results: .*utf-8"):
        Results.load(path)


def test_joined_experiments_of_other_lengths() -> None:
    """Each method has the steps and the repetitions of its own experiment."""
    long = Results(table({"long": [([0, 1, 3, 7], [NAN] * 4, [1] * 4)] * 4}, [0, 10, 30, 40]))
    for parts in ([WHOLE, long], [long, WHOLE]):
        both = joined(parts)
        equal(both.final("long"), long.final("long"))
        equal(both.average("long"), long.average("long"))
        equal(both.final("1"), WHOLE.final("1"))
        equal(both.average("1"), WHOLE.average("1"))
        assert both.complete
        assert not joined([*parts, NONE_COMPLETE.renamed("none")]).complete
    with pytest.raises(ValueError, match=r"parts .* 2 of them have 'long'"):
        joined([long, long])
    begun = long.table.assign(runs=8)  # of a method there is no row yet
    assert not joined([WHOLE, Results(begun)]).complete
    assert not joined([Results(begun), WHOLE]).complete
    wrong: Any
    for wrong in ([], ["results.csv"], [WHOLE, None]):
        with pytest.raises(ValueError, match=named("parts", "Results")):
            joined(wrong)
