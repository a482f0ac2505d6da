"""What the tests of the lab share."""

import json
from pathlib import Path

import pytest

from edugym_course.lab import lessons


def notebook(*sources: str) -> str:
    """A notebook with an opening and cells of code, the last of which is a check."""
    opening = "# Doubling: two\n**The challenge.** Small | numbers. **You will be able to** add. **Time.** 1\nminute."
    cells = [{"cell_type": "markdown", "source": opening, "metadata": {}}]
    cells += [{"cell_type": "code", "source": source, "metadata": {}, "outputs": []} for source in sources]
    cells[-1]["metadata"] = {"tags": ["check"]}
    return json.dumps({"cells": cells})


@pytest.fixture
def shipped(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder with the lessons of the package: one."""
    folder = tmp_path / "package"
    folder.mkdir()
    (folder / "01_doubling.ipynb").write_text(notebook("1 + 1", "check"))
    monkeypatch.setattr(lessons, "PACKAGED", folder)
    return folder
