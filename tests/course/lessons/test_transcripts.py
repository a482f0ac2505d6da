"""What each lesson shows is what its transcript says: every claim, figure and printed line."""

from pathlib import Path
from types import SimpleNamespace

import ipywidgets
import pytest

from tests.course.lessons.drawn import numbers
from tests.course.lessons.transcripts import FOLDER, NOTEBOOKS, difference, settings_of, transcript


@pytest.mark.parametrize("lesson", NOTEBOOKS)
def test_a_lesson_shows_what_its_transcript_says(lesson: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """If the change is meant, delete the transcript: this test writes it anew, for you to read what has changed."""
    if lesson == "continuous_actions":
        pytest.importorskip("torch")
    monkeypatch.chdir(tmp_path)
    now, path = transcript(lesson), FOLDER / f"{lesson}.txt"
    if not path.exists():
        path.write_text(now, encoding="utf-8")
        pytest.fail(f"{path} is new: read it, and commit it")
    assert difference(path.read_text(encoding="utf-8"), now) == []


def test_every_transcript_is_of_a_lesson() -> None:
    """Or it would be left behind."""
    assert {path.stem for path in FOLDER.glob("*.txt")} == {*NOTEBOOKS}


@pytest.mark.parametrize(
    ("before", "now"),
    [
        ("title 4.1: [2.5]", "title 4.2: [2.5]"),
        ("[2.5]", "[2.51]"),
        ("[2.5]", "[-2.5]"),
        ("[0]", "[nan]"),
        ("[1, 2]", "[1, 2, 3]"),
        ("one", "one\ntwo"),
        ("one\ntwo", "one"),
    ],
)
def test_what_is_a_difference(before: str, now: str) -> None:
    """Another word, number or line; in data, more than the last digit."""
    assert difference(before, now) != []


def test_last_digits_of_data_may_differ() -> None:
    """On another machine."""
    assert difference("a [1.234e+05, nan] 7", "a [1.235e+05, nan] 7") == []


def test_many_numbers() -> None:
    """Their order counts, and what is not known does not."""
    assert numbers([1.0, 2.0, 3.0, 4.0, float("nan")]) == "[1 .. nan, 5 of mean 2.5, 6]"
    assert numbers([1, 3, 2, 4, 0]) != numbers([1, 2, 3, 4, 0])
    assert numbers([[1, 2], [3, 4]]) == "[1, 2, 3, 4]"


def test_positions_of_sliders() -> None:
    """In the middle nothing stands where it starts, nor at an end if there is more."""
    numbers_of, few = ipywidgets.IntSlider(value=6, min=4, max=12, step=2), ipywidgets.Dropdown(options=["a", "b"])
    tenths, ticked = ipywidgets.FloatSlider(value=0.4, min=0.1, max=0.55, step=0.1), ipywidgets.Checkbox(value=True)
    controls = {"n": numbers_of, "x": tenths, "word": few, "on": ticked}
    assert settings_of(SimpleNamespace(controls=controls)) == {
        "start": {"n": 6, "x": 0.4, "word": "a", "on": True},
        "low": {"n": 4, "x": 0.1, "word": "a", "on": False},
        "middle": {"n": 8, "x": 0.3, "word": "b", "on": False},
        "high": {"n": 12, "x": 0.5, "word": "b", "on": True},
    }
