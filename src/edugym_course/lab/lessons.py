"""The lessons that come with the package, as students get them."""

import json
import re
from pathlib import Path
from typing import Any, NamedTuple

from edugym_course.lab.records import number_of

PACKAGED = Path(__file__).parent / "notebooks"
"""The folder of the lessons in an installed package."""

CHECKOUT = Path(__file__).parents[3] / "notebooks"
"""The same in a checkout, from which `pyproject.toml` copies it into the package."""


class Lesson(NamedTuple):
    """A notebook for students.

    Attributes:
        name: its name, such as "01_exploration".
        text: the contents of its file.
        cells: its cells.
    """

    name: str
    text: str
    cells: list[dict[str, Any]]

    @property
    def number(self) -> str:
        """The number of the lesson."""
        return number_of(self.name)

    @property
    def title(self) -> str:
        """The text of its heading."""
        return self._opening().partition("\n")[0].lstrip("# ")

    @property
    def exercises(self) -> int:
        """The number of its exercises: of the cells that check one."""
        return sum("check" in cell["metadata"].get("tags", []) for cell in self.cells)

    def part(self, label: str) -> str:
        """The text after a bold label of the first cell, such as "Time", in one line; "" if there is none."""
        found = re.search(rf"\*\*{label}\.\*\*(.*?)(?=\*\*[A-Z]|\n\n|\Z)", self._opening(), flags=re.DOTALL)
        return " ".join(found[1].split()) if found else ""

    def _opening(self) -> str:
        return "".join(self.cells[0]["source"])


def student_lessons() -> list[Lesson]:
    """All lessons in the order of the course."""
    folder = PACKAGED if PACKAGED.is_dir() else CHECKOUT
    texts = {path.stem: path.read_text(encoding="utf-8") for path in sorted(folder.glob("[0-9]*_*.ipynb"))}
    return [Lesson(name, text, json.loads(text)["cells"]) for name, text in texts.items()]
