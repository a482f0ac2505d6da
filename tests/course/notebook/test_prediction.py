"""Predictions: asked, answered, and shown beside what was measured."""

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
    [
        ("40", 40.0),
        (" 12.5 ", 12.5),
        ("12,5", 12.5),
        ("30%", 30.0),
        ("1/4", 0.25),
        ("1/0", None),
        ("70 grips", 70.0),
        ("", None),
        ("  ", None),
        ("many", None),
    ],
)
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


def test_a_percentage_of_a_share() -> None:
    """Where a number from 0 to 1 is asked for, 30% is 0.3."""
    prediction = predict("What share of the runs?", unit="(from 0 to 1)")
    answer(prediction, "30%")
    assert prediction.answer == 0.3
    answer(prediction, "0.3")
    assert prediction.answer == 0.3
    answer(prediction, "30%")
    assert "You predicted 0.3. Measured: 0.25." in repr(prediction.measured(0.25))


def test_options() -> None:
    """One is chosen; the comparison says whether it is the one that was measured."""
    prediction = predict("Which is higher?", ["novelty", "Go-Explore"])
    assert "You made no prediction" in repr(prediction.measured("novelty"))
    answer(prediction, "novelty")
    assert repr(prediction.measured("novelty")) == "Measured: novelty, as you predicted."
    assert repr(prediction.measured("Go-Explore")) == "Measured: Go-Explore, you predicted: novelty."
    with pytest.raises(ValueError, match="value must be one of 'novelty', 'Go-Explore', but is 'Q'"):
        prediction.measured("Q")


def test_it_shows_the_question() -> None:
    """With the widget, and where no kernel runs; texts are no markup."""
    prediction = predict("Is a < b?", ["yes", "no"])
    assert "Is a &lt; b?" in texts(prediction.widget)[0]
    bundle = prediction._repr_mimebundle_()
    assert "(a) yes (b) no" in bundle["text/html"]
    assert "&lt;" in predict("a", ["a < b", "c"]).measured("a < b")._repr_html_()


def test_every_word() -> None:
    """Of the question, the field, the comparison, and what stands where no kernel runs."""
    prediction: Any = predict("How high?", unit="grips")
    assert texts(prediction.widget)[0] == "<b>Your prediction.</b> How high?"
    assert (prediction._field.placeholder, prediction._field.description) == ("a number", "grips")
    assert prediction.still() == {"text/html": "Your prediction. How high?"}
    unanswered = "Measured: 41.3 grips. (You made no prediction; the next one is worth a try.) It slips."
    assert repr(prediction.measured(41.26, "It slips.")) == unanswered
    answer(prediction, "40")
    assert repr(prediction.measured(41.26, "It slips.")) == "You predicted 40 grips. Measured: 41.3 grips. It slips."
    assert prediction.measured(41.26)._repr_html_() == "<p>You predicted 40 grips. Measured: 41.3 grips.</p>"
    choice: Any = predict("Which?", ["a", "b", "c"])
    assert choice.still() == {"text/html": "Your prediction. Which?<br>(a) a (b) b (c) c"}
    assert (choice._field.options, choice._field.value) == (("a", "b", "c"), None)
    answer(choice, "c")
    assert repr(choice.measured("b", "By luck.")) == "Measured: b, you predicted: c. By luck."


@pytest.mark.parametrize("question", ["", 3, None])
def test_a_question_must_be_a_text(question: Any) -> None:
    """Or the error says what it is."""
    with pytest.raises(ValueError, match="question must be a text, but is"):
        predict(question)


@pytest.mark.parametrize("options", [["one"], ["same", "same"], "yes", [1, 2], ["one", 2], []])
def test_options_must_differ(options: Any) -> None:
    """Two or more different texts."""
    with pytest.raises(ValueError, match="options must be two or more different texts, but are"):
        predict("Which?", options)


@pytest.mark.parametrize("value", ["forty", None, True])
def test_what_was_measured_must_be_a_number(value: Any) -> None:
    """A lesson that measures something else has made a mistake."""
    with pytest.raises(ValueError, match="value must be a number, but is"):
        predict("How high?").measured(value)
