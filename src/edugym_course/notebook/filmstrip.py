"""The frames of an episode, for a page behind which no kernel stands.

`lessons/build.py --flipbooks` makes them, beside the notebooks: a file of JSON for each film of a lesson. Most lines of
SVG are the same in all frames, so each is written once. The website shows them.
"""

import json
from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path
from typing import NamedTuple

from edugym.rendering.svg import to_svg
from edugym_course.notebook.film import Film

ENDING = ".film"


class Filmstrip(NamedTuple):
    """An episode, frame by frame.

    Attributes:
        fingerprint: of the cell that it belongs to (see `edugym_course.notebook.flipbook.fingerprint`).
        lines: all lines of SVG of all frames, each once.
        frames: for each frame the runs of lines that it consists of: first line, and the line after the last.
        says: what a frame shows, for readers who cannot see it.
    """

    fingerprint: str
    lines: Sequence[str]
    frames: Sequence[Sequence[Sequence[int]]]
    says: Sequence[str]

    def picture(self, frame: int) -> str:
        """A frame as SVG."""
        return "\n".join(line for first, end in self.frames[frame] for line in self.lines[first:end])


def filmstrips(folder: Path) -> list[Filmstrip]:
    """Read all that are in a folder: none if there is no folder."""
    return [Filmstrip(**json.loads(path.read_text(encoding="utf-8"))) for path in sorted(folder.glob(f"*{ENDING}"))]


def keep(film: Film, folder: Path, fingerprint: str) -> None:
    """Write the frames of a film into a folder.

    Args:
        film: the film; its pictures are scenes.
        folder: where to write.
        fingerprint: of the cell that has made the film; the name of the file, too.

    Raises:
        ValueError: a picture is no scene.
    """
    scenes = [frame.with_caption() for frame in film.frames]
    numbers = dict[str, int]()
    frames = [
        _runs([numbers.setdefault(line, len(numbers)) for line in to_svg(scene).splitlines()]) for scene in scenes
    ]
    says = [
        f"{scene.title}; {frame.line}".replace("\n", "; ") for scene, frame in zip(scenes, film.frames, strict=True)
    ]
    strip = Filmstrip(fingerprint, list(numbers), frames, says)
    text = json.dumps(strip._asdict(), separators=(",", ":"), ensure_ascii=False)
    (folder / f"{fingerprint}{ENDING}").write_text(text.replace('","', '",\n"') + "\n", encoding="utf-8")


def _runs(numbers: list[int]) -> list[tuple[int, int]]:
    """Return numbers as runs of consecutive ones, each its first and the one after its last."""
    starts = [0, *(k + 1 for k, (one, after) in enumerate(pairwise(numbers)) if after != one + 1), len(numbers)]
    return [(numbers[start], numbers[end - 1] + 1) for start, end in pairwise(starts)]
