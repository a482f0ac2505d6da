"""Predictions: a reader answers before a cell is run, and sees the answer beside what was measured."""

import html
import re
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import ipywidgets

from edugym.checks.parameters import a_number, a_text, in_short, one_of, several
from edugym_course.notebook.widget import NotebookWidget, text_html

NUMBER = re.compile(r"([-+]?[\d.,/]+(?:e[-+]?\d+)?)\s*([^\d]*)")
"""A number as people type it ("12,5", "1/30"), perhaps with its unit."""
WHOLE_OPTIONS = """<style>
.edugym-options label { display: flex; height: auto; line-height: 1.4; }
.edugym-options input { flex: none; order: -1; }
</style>"""
"""Options of several lines, as on a phone, which would overlap otherwise."""


class Prediction(NotebookWidget):
    """A question with a place for the answer.

    Attributes:
        question: the question.
        options: the answers to choose from; None if the answer is a number.
        answer: the answer so far; None if there is none yet.
    """

    def __init__(self, question: str, options: tuple[str, ...] | None, unit: str) -> None:
        """Make the widgets."""
        self.question, self.options, self.unit = question, options, unit
        wide = ipywidgets.Layout(width="auto")
        if options is None:
            whole = {"description_width": "initial"}  # or a long unit is cut off
            self._field = ipywidgets.Text(placeholder="a number", description=unit, style=whole, layout=wide)
        else:
            self._field = ipywidgets.RadioButtons(options=options, value=None, layout=wide)
            self._field.add_class("edugym-options")
        asked = f"{WHOLE_OPTIONS}<b>Your prediction.</b> {html.escape(question)}"
        super().__init__(ipywidgets.HTML(asked), self._field)

    @property
    def answer(self) -> float | str | None:
        """The answer so far: a number, or one of the options."""
        if self.options is not None:
            chosen: str | None = self._field.value
            return chosen
        found = NUMBER.fullmatch(self._field.value.strip())
        if found is None:
            return None
        try:
            number = float(Fraction(found[1].replace(",", ".")))
            return number / 100 if found[2] == "%" and "0 to 1" in self.unit else number
        except (ValueError, ZeroDivisionError):
            return None

    def measured(self, value: Any, explanation: str = "") -> "Comparison":
        """Compare the answer with what was measured, as in `prediction.measured(41.3)`.

        Args:
            value: what was measured: a number, or the option that turned out to be right.
            explanation: a sentence on why.

        Raises:
            ValueError: the value is not a finite number, or not one of the options; or the explanation is no text.
        """
        if self.options is not None:
            one_of("value", value, self.options)
        else:
            value = a_number("value", value)
        a_text("explanation", explanation)
        return Comparison(self.answer, value, self.unit, explanation)

    def still(self) -> dict[str, str]:
        """The question, and the options if there are some."""
        options = "" if self.options is None else " ".join(f"({chr(97 + k)}) {o}" for k, o in enumerate(self.options))
        return {"text/html": text_html(f"Your prediction. {self.question}\n{options}".strip())}


class Comparison:
    """A prediction beside what was measured. In a notebook it shows itself."""

    def __init__(self, answer: Any, value: Any, unit: str, explanation: str) -> None:
        """Keep what it will show."""
        self._parts = answer, value, unit, explanation

    def __repr__(self) -> str:
        """The prediction, what was measured, and the explanation, in words."""
        answer, value, unit, explanation = self._parts
        seen = f"Measured: {_written(value, unit)}."
        if answer is None:
            return " ".join(filter(None, (seen, "(You made no prediction; the next one is worth a try.)", explanation)))
        if isinstance(answer, str):
            verdict = "as you predicted" if answer == value else f"you predicted: {answer}"
            return " ".join(filter(None, (f"Measured: {value}, {verdict}.", explanation)))
        return " ".join(filter(None, (f"You predicted {_written(answer, unit)}.", seen, explanation)))

    def _repr_html_(self) -> str:
        """The same for a notebook."""
        return f"<p>{text_html(repr(self))}</p>"


def _written(value: Any, unit: str) -> str:
    """A number with its unit; in place of a unit there may be a remark in brackets, such as "(from 0 to 1)"."""
    unit = "" if unit.startswith("(") else unit
    return f"{float(value):.3g} {unit}".strip() if not isinstance(value, str) else value


def predict(question: str, options: Sequence[str] | None = None, *, unit: str = "") -> Prediction:
    """Ask for a prediction before a cell is run.

    `height = predict("How high does it get?", unit="grips")` shows a field. In the next cell `height.measured(1.4)`
    shows the answer beside what was measured.

    Args:
        question: the question, one sentence.
        options: the answers to choose from, two or more; by default the answer is a number that is typed.
        unit: the unit of that number.

    Returns:
        The question with a field. As the last value of a cell it shows itself.

    Raises:
        ValueError: the question is not a text, or the options are not two or more different texts.
    """
    if not a_text("question", question).strip():
        raise ValueError(f"question must be a text, but is {question!r}")
    a_text("unit", unit)
    if options is not None:
        texts = several("options", options, str, "two or more different texts")
        if len(set(texts)) < max(2, len(texts)):
            raise ValueError(f"options must be two or more different texts, but is {in_short(options)}")
    return Prediction(question, None if options is None else tuple(options), unit)
