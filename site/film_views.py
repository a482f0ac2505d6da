"""The films of a lesson on its page: episodes to step through or to play, for no kernel stands behind the page.

`site.js` draws the frames. Before each film stands the picture of the notebook, four frames side by side; it is seen
without JavaScript, and on paper.
"""

import html
import json

from slider_views import FOLDER

from edugym_course.notebook.filmstrip import Filmstrip, filmstrips

VIEW = """<div class="film">
<div class="turn"><button type="button">Play</button><label for="{name}">step</label>
<input type="range" id="{name}" min="0" max="{last}" value="0" aria-valuetext="{says}" autocomplete="off"/>
<output for="{name}" style="min-width: {longest}ch">0</output></div>
<div class="picture" role="img" aria-label="{says}">
{picture}
</div>
<script type="application/json">{frames}</script>
</div>"""


def views(lesson: str) -> dict[str, Filmstrip]:
    """Return the films of a lesson by the fingerprints of their cells: a cell that has changed finds none."""
    return {film.fingerprint: film for film in filmstrips(FOLDER / lesson)}


def shown(film: Filmstrip, name: str) -> str:
    """Return a film as HTML; `name` is its own on the page."""
    frames = {"lines": film.lines, "frames": film.frames, "says": film.says}
    last = len(film.frames) - 1
    return VIEW.format(
        name=name,
        last=last,
        longest=len(str(last)),
        says=html.escape(film.says[0]),
        picture=film.picture(0),
        frames=json.dumps(frames, separators=(",", ":"), ensure_ascii=False).replace("</", "<\\/"),
    )
