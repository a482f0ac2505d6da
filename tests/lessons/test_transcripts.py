"""What the lessons show is what their transcripts say; after a change that is meant, write them again."""

from pathlib import Path

import pytest

from tests.lessons.transcripts import FOLDER, NOTEBOOKS, alike, difference, transcript


@pytest.mark.parametrize("lesson", NOTEBOOKS)
def test_a_lesson_shows_what_its_transcript_says(
    lesson: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """If the change is meant: `python -m tests.lessons.transcripts NAME`, and read the difference."""
    monkeypatch.chdir(tmp_path)
    assert difference((FOLDER / f"{lesson}.txt").read_text(encoding="utf-8"), transcript(lesson)) == []
