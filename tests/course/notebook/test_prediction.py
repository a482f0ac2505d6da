"""Predictions: asked, answered, and shown beside what was measured."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from edugym_course.notebook import predict
from tests.course.notebook.widgets import texts


def answer(prediction: Any, value: Any) -> None:
    """Type a number, or choose an option."""
    prediction._field.value = value


@pytest.mark.parametrize(
    ("typed", "number"),
    [("40", 40.0), (" 12.5 ", 12.5), ("12,5", 12.5), ("30%", 30.0), ("1/4", 0.25), ("1/0", None), ("70 grips", 70.0),
     ("", None), ("  ", None), ("many", None)],
)  # fmt: skip
def test_a_number(typed: str, number: float | None) -> None:
    """People type numbers in several ways; what is no number counts as no prediction."""
    prediction = predict("How high does it get?", unit="grips")
    assert prediction.answer is None
    answer(prediction, typed)
    assert prediction.answer == number
    shown = repr(prediction.measured(np.float64(41.26), "It slips."))
    assert ("You predicted " in shown) is (number is not None)
    assert "Measured: 41.3 grips." in shown
    assert shown.endswith("It slips.")


def test_it_shows_the_question() -> None:
    """With the widget, and where no kernel runs; texts are no markup."""
    prediction = predict("Is a < b?", ["yes", "no"])
    assert "Is a &lt; b?" in texts(prediction.widget)[0]
    bundle = prediction._repr_mimebundle_()
    assert "(a) yes (b) no" in bundle["text/html"]
    assert "&lt;" in predict("a", ["a < b", "c"]).measured("a < b")._repr_html_()


def test_a_percentage_of_a_share() -> None:
    """Where a number from 0 to 1 is asked for, 30% is 0.3; what stands in brackets is no unit."""
    prediction = predict("What share of the runs?", unit="(from 0 to 1)")
    for typed in ("30%", "0.3"):
        answer(prediction, typed)
        assert prediction.answer == 0.3
    assert "You predicted 0.3. Measured: 0.25." in repr(prediction.measured(0.25))


def test_options() -> None:
    """One is chosen; the comparison says whether it is the one that was measured."""
    prediction: Any = predict("Which?", ["a", "b", "c"])
    assert (prediction._field.options, prediction._field.value) == (("a", "b", "c"), None)
    unanswered = repr(prediction.measured("a", "By luck."))
    answer(prediction, "a")
    right, wrong = (repr(prediction.measured(value, "By luck.")) for value in "ab")
    assert len({unanswered, right, wrong}) == 3
    for said, measured in ((unanswered, "a"), (right, "a"), (wrong, "b")):
        assert f"Measured: {measured}" in said
        assert said.endswith("By luck.")
    assert "predicted: a" in wrong


@pytest.mark.parametrize(
    ("call", "names"),
    [
        *((lambda question=question: predict(question), f"question .*{question!r}") for question in ("", 3, None)),
        *(
            (lambda options=options: predict("Which?", options), "options .*two or more different")
            for options in (["one"], ["same", "same"], "yes", [1, 2], ["one", 2], [])
        ),
        *(
            (lambda value=value: predict("How high?").measured(value), f"value .*{value}")
            for value in ("x", None, True)
        ),
        (lambda: predict("Which?", ["a", "b"]).measured("Q"), "value .*'a', 'b'.*'Q'"),
    ],
)
def test_what_is_refused(call: Callable[[], Any], names: str) -> None:
    """With its name and value: no question, options that do not differ, and what was not measured."""
    with pytest.raises(ValueError, match=names):
        call()
