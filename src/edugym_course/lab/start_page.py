"""The start page of `edugym lab`: the lessons with picture, time, what to know before, and which are done."""

import base64
from pathlib import Path

from edugym.adapters.gymnasium_env import MDPEnv
from edugym.adapters.registration import ENVIRONMENTS, make_mdp
from edugym.rendering.svg import to_svg
from edugym_course.lab.delivery import deliver, versions
from edugym_course.lab.lessons import Lesson, student_lessons
from edugym_course.lab.records import passed

START_PAGE = "start.md"
PICTURE_SIDE = 120
"""The longer side of a picture, in pixels."""

# The spaces make the column of pictures so wide that JupyterLab does not shrink them.
HEAD = f"""\
# EduGym

A reinforcement-learning course that you can run. Click on a lesson to open it, and run its cells from the top with
Shift+Enter.

| {"&nbsp;" * 24} | lesson |
|---|---|
"""

FOOT = """
Your copies of the lessons are in this folder. Change them as you like: nobody writes over your changes. To get a fresh
copy of a lesson, rename or delete yours, and start `edugym lab` again.

EduGym makes this page anew whenever an exercise is solved. To see the newest, choose *Reload Markdown File from Disk*
in the menu *File*.
"""


def write_start_page(folder: Path) -> Path:
    """Write the start page into a student's folder, and return its path.

    Raises:
        OSError: it cannot be written.
    """
    rows = (row(lesson, folder) for lesson in student_lessons())
    return deliver(HEAD + "".join(rows) + FOOT, folder / START_PAGE)


def row(lesson: Lesson, folder: Path) -> str:
    """The row of a lesson in the table."""
    file = f"{lesson.name}.ipynb"
    later = [f"([{place.stem}]({place.name}))" for place in versions(folder / file)[1:]]
    done = len(passed(folder, lesson.name) & set(range(1, lesson.exercises + 1)))
    parts = [
        " ".join([f"**{lesson.number}. [{lesson.title}]({file})**", *later]),
        lesson.part("The challenge"),
        f"**Time.** {lesson.part('Time')} **Before you start.** {lesson.part('Before you start')}",
        f"**Exercises.** {done} of {lesson.exercises} solved{' ✓' if done == lesson.exercises else ''}",
    ]
    text = "<br>".join(parts).replace("|", "\\|")
    return f"| {picture(lesson)} | {text} |\n"


def picture(lesson: Lesson) -> str:
    """The picture of the environment of a lesson as Markdown; "" for a lesson without one."""
    for entry in ENVIRONMENTS:
        if entry.lesson == lesson.number:
            env = MDPEnv(make_mdp(entry.name))
            env.reset(seed=0)
            width, height = env.scene().size_in_pixels()
            svg = to_svg(env.scene(), round(PICTURE_SIDE * width / max(width, height)))
            return f"![{entry.name}](data:image/svg+xml;base64,{base64.b64encode(svg.encode()).decode()})"
    return ""
