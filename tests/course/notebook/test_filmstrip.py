"""The frames of an episode for pages behind which no kernel stands."""

from pathlib import Path

import pytest

from edugym.rendering.svg import to_svg
from edugym_course.notebook import filmstrip, frames


def test_every_frame_is_kept_and_each_line_once(tmp_path: Path) -> None:
    """Their pictures and the score below them; the whole is much smaller than its frames."""
    film = frames("Supermarket", ["right", "down"] * 5)
    filmstrip.keep(film, tmp_path, "mark")
    [path] = tmp_path.iterdir()
    [strip] = filmstrip.filmstrips(tmp_path)
    assert (path.name, strip.fingerprint) == ("mark.film", "mark")
    drawn = [to_svg(frame.with_caption()).rstrip("\n") for frame in film.frames]
    assert [strip.picture(k) for k in range(len(strip.frames))] == drawn
    assert len(set(strip.lines)) == len(strip.lines)
    assert path.stat().st_size < sum(map(len, drawn)) / 4
    for said, frame in zip(strip.says, film.frames, strict=True):
        assert frame.line.split("\n")[0] in said


def test_a_film_of_pixels_is_an_error(tmp_path: Path) -> None:
    """Only scenes are made of lines."""
    film = frames("CartPole-v1", [0, 1])
    with pytest.raises(ValueError, match="scene"):
        filmstrip.keep(film, tmp_path, "mark")
    assert not [*tmp_path.iterdir()]
