"""A class of made-up students: lessons are handed out, come back, and are graded."""

import csv
import json
import math
import re
from collections import Counter
from collections.abc import Callable
from itertools import count
from pathlib import Path
from typing import Any

import build
import nbformat
import pytest
from rules import is_check, without_marks
from typer.testing import CliRunner, Result

from edugym_course import commands
from edugym_course.grading.own_numbers import own_parameters
from edugym_course.teaching.assignment import Assignment, assign
from edugym_course.teaching.grading import needed_steps, submission
from edugym_course.teaching.students import Student, read_students
from tests.course.lessons.test_nbgrader import nbgrader, submit

LESSON = "00_loop"
POINTS = [1, 1, 2]
"""Of the exercises of lesson 0."""


@pytest.fixture(autouse=True)
def known_secrets(monkeypatch: pytest.MonkeyPatch) -> None:
    """Secrets by which no two students of a test happen to share a number that counts."""
    known = (f"secret {number}" for number in count())
    monkeypatch.setattr("edugym_course.teaching.assignment.secrets.token_hex", lambda length: next(known))


def run(*arguments: str | Path) -> Result:
    """What the command says; it must succeed."""
    ran = CliRunner().invoke(commands.app, [*map(str, arguments)])
    assert ran.exit_code == 0, ran.output
    return ran


def handed_out(folder: Path, ids: list[str], lesson: str = LESSON) -> Assignment:
    """A lesson for each student, made from the teachers' edition as it is now."""
    notebook, students = folder / f"{lesson}.ipynb", folder / "class.csv"
    nbformat.write(build.teacher_edition(build.read_lesson(build.lesson_sources()[lesson])), notebook)
    students.write_text("id,name\n" + "".join(f"{name},{name.title()}\n" for name in ids), encoding="utf-8")
    run("assign", notebook, "--students", students, "--output", folder / "assigned")
    return Assignment.read(folder / "assigned" / "teacher" / f"{lesson}.json")


def cells(notebook: Any, role: str) -> dict[str, Any]:
    """The cells of a notebook that nbgrader knows as exercises, or checks, by name."""
    known = {cell.metadata.nbgrader.grade_id: cell for cell in notebook.cells if "nbgrader" in cell.metadata}
    return {name: cell for name, cell in known.items() if name.startswith(role)}


class Work:
    """What a student makes of the lesson that she got."""

    def __init__(self, folder: Path, made: Assignment, student: str) -> None:
        """Begin with the lesson as it was handed out."""
        self.folder, self.made, self.student = folder, made, student
        self.notebook = nbformat.read(
            folder / "assigned" / "handout" / student / f"{made.lesson}.ipynb", as_version=nbformat.NO_CONVERT
        )

    def solve(self, whose: str = "", *numbers: int) -> None:
        """Solve some exercises, by default all, with the numbers of somebody, by default one's own."""
        source = nbformat.read(self.made.source(whose or self.student), as_version=nbformat.NO_CONVERT)
        for name, cell in cells(self.notebook, "exercise").items():
            if not numbers or int(name[-1]) in numbers:
                cell.source = without_marks(cells(source, "exercise")[name].source)

    def write(self, source: str, before: str = "exercise-1") -> None:
        """Add a cell of code."""
        place = self.notebook.cells.index(cells(self.notebook, "exercise")[before])
        self.notebook.cells.insert(place, nbformat.v4.new_code_cell(source))

    def hand_in(self) -> None:
        """Put it where the teacher collects."""
        submit(self.folder, self.student, self.notebook, self.made.lesson)


def breaks_a_cell(work: Work) -> None:
    """All is right, but one cell is no Python."""
    work.solve()
    cells(work.notebook, "exercise")["exercise-2"].source += "\n)"


def edits_a_check(work: Work) -> None:
    """Nothing is solved, and a check says that all is well."""
    cells(work.notebook, "check")["check-1"].source = "print('✓ Right.')"


def replaces_check(work: Work) -> None:
    """Nothing is solved, and `check` is another function."""
    work.write("check = lambda *given, **more: print('✓ Right.')\nexercise_1 = None")


def changes_the_package(work: Work) -> None:
    """A wrong answer, and a grading that finds it right."""
    work.write("import edugym_course.lessons.loop.exercises as e\ne.exercise_1 = lambda answer, seed, after=0: ''")


def never_ends(work: Work) -> None:
    """The first answer is right; a cell after it waits for ever."""
    work.solve()
    work.write("import time\ntime.sleep(10_000)", before="exercise-2")


def turns_to_magic(work: Work) -> None:
    """All is right, with cells of her own that only a notebook understands, and some that fail."""
    work.solve()
    work.write("%matplotlib inline\ndisplay(1)")
    work.write("1 / 0")


def copies_one_answer(work: Work) -> None:
    """Two answers are right, and the third is somebody else's."""
    work.solve()
    work.solve("ada", 3)


def hands_in_another(work: Work) -> None:
    """The whole notebook is somebody else's, with its checks."""
    work.notebook = Work(work.folder, work.made, "ada").notebook
    work.solve("ada")


CLASS: dict[str, tuple[Callable[[Work], None] | None, list[int], str]] = {
    "ada": (Work.solve, [1, 1, 2], ""),
    "bob": (lambda work: work.solve("ada"), [0, 0, 0], "exercises 1, 2 and 3 fit the numbers of Ada (ada)"),
    "cleo": (lambda work: None, [0, 0, 0], ""),
    "dora": (replaces_check, [0, 0, 0], "`check` gets another meaning, which changes nothing"),
    "emil": (breaks_a_cell, [1, 0, 2], ""),
    "fay": (edits_a_check, [0, 0, 0], "check 1 was edited, which changes nothing"),
    "gus": (None, [0, 0, 0], "nothing came in"),
    "hal": (changes_the_package, [0, 0, 0], ""),
    "ivy": (turns_to_magic, [1, 1, 2], ""),
    "jo": (copies_one_answer, [1, 1, 0], "exercise 3 fits the numbers of Ada (ada)"),
    "kim": (hands_in_another, [0, 0, 0], "check 1 is that of Ada (ada)"),
}
"""What each student does, her points, and what the teacher is told of it."""


def graded(folder: Path, made: Assignment, *options: str) -> tuple[dict[str, list[float]], dict[str, str], str]:
    """The points and the remarks by student, and the page of the class."""
    results = folder / "results"
    ran = run("grade", made.path, "--submitted", folder / "submitted", "--output", results, *options)
    assert ("zoe belongs to nobody" in ran.stderr) == (folder / "submitted" / "zoe").exists()
    rows = list(csv.DictReader((results / f"{made.lesson}.csv").read_text(encoding="utf-8").splitlines()))
    points = {row["id"]: [float(row[f"exercise_{task.number}"]) for task in made.tasks] for row in rows}
    assert all(float(row["points"]) == sum(points[row["id"]]) for row in rows)
    page = (results / f"{made.lesson}.html").read_text(encoding="utf-8")
    assert not re.search(r"https?:|src=|<script|<link|url\(", page)
    assert "mean" in (results / f"{made.lesson}.md").read_text(encoding="utf-8")
    return (
        points,
        {row["id"]: next(line for line in ran.output.splitlines() if f"({row['id']}):" in line) for row in rows},
        page,
    )


@pytest.mark.parametrize(
    "ids", [["ada", "bob", "cleo", "dora"], pytest.param([*CLASS], marks=pytest.mark.slow)], ids=["four", "eleven"]
)
def test_a_class(ids: list[str], tmp_path: Path) -> None:
    """Right answers get all points, copied ones none, and the page says whose numbers they fit."""
    made = handed_out(tmp_path, ids)
    assert [task.points for task in made.tasks] == POINTS
    for name in ids:
        does, *_ = CLASS[name]
        if does is not None:
            work = Work(tmp_path, made, name)
            does(work)
            work.hand_in()
    (tmp_path / "submitted" / "zoe").mkdir()
    points, remarks, page = graded(tmp_path, made)
    assert points == {name: CLASS[name][1] for name in ids}
    for name in ids:
        told = CLASS[name][2]
        assert told in remarks[name]
        assert told in page
        assert bool(told) == ("(" in remarks[name].partition(f"({name}):")[2])
    if "emil" in ids:
        assert "there is no choose: its cell raises SyntaxError" in page
        assert "has changed edugym_course.lessons.loop.exercises.exercise_1 inside the package" in page


@pytest.mark.slow
def test_what_never_ends_is_ended(tmp_path: Path) -> None:
    """What was checked before counts."""
    made = handed_out(tmp_path, ["ada"])
    work = Work(tmp_path, made, "ada")
    never_ends(work)
    work.hand_in()
    points, remarks, _ = graded(tmp_path, made, "--seconds", "60")
    assert points == {"ada": [1, 0, 0]}
    assert "it was ended after 60 seconds" in remarks["ada"]


@pytest.mark.slow
@pytest.mark.parametrize("lesson", [name for name in build.lesson_sources() if name != LESSON])
def test_the_other_lessons(lesson: str, tmp_path: Path) -> None:
    """Who solves it with her own numbers gets all points, and who hands in the same gets none."""
    made = handed_out(tmp_path, ["ada", "bob"], lesson)
    for name in made.students:
        work = Work(tmp_path, made, name)
        work.solve("ada")
        work.hand_in()
    points, remarks, _ = graded(tmp_path, made)
    own = [bool(draw.numbers) for draw in made.draws["ada"]]
    all_points = [task.points for task in made.tasks]
    assert points == {"ada": all_points, "bob": [0 if hers else n for hers, n in zip(own, all_points, strict=True)]}
    if all(own):
        numbers = ", ".join(str(task.number) for task in made.tasks[:-1])
        assert f"exercises {numbers} and {made.tasks[-1].number} fit the numbers of Ada (ada)" in remarks["bob"]


@pytest.mark.parametrize("lesson", [*build.lesson_sources()])
def test_what_is_handed_out_gives_nothing_away(lesson: str, tmp_path: Path) -> None:
    """No solution, no hidden seed, nobody else's number, no secret; each exercise says what is one's own."""
    made = handed_out(tmp_path, ["ada", "bob"], lesson)
    ordinary = nbformat.read(tmp_path / f"{lesson}.ipynb", as_version=nbformat.NO_CONVERT)
    for name, draws in made.draws.items():
        work = Work(tmp_path, made, name)
        text = nbformat.writes(work.notebook)
        assert "### BEGIN" not in text
        assert "# own:" not in text
        assert made.secret not in text
        assert not any(str(draw.hidden_seed) in text for draw in draws)
        assert len(work.notebook.cells) == len(ordinary.cells)
        assert text.count("**Your own version.**") == sum(bool(draw.numbers) for draw in draws)
        for check, draw in zip(cells(work.notebook, "check").values(), draws, strict=True):
            assert is_check(check)
            assert f"seed={draw.seed}" in check.source
            assert all(f"{number}={value!r}" in check.source for number, value in draw.numbers.items())
        assert "Ada Lovelace" not in text
    assert made.draws["ada"] != made.draws["bob"]


def test_the_same_again_for_those_who_were_there(tmp_path: Path) -> None:
    """A longer list changes nobody's numbers; another folder has another secret, and other numbers."""
    first = handed_out(tmp_path, ["ada"])
    again = handed_out(tmp_path, ["bob", "ada"])
    assert again.draws["ada"] == first.draws["ada"]
    assert again.secret == first.secret
    other = assign(tmp_path / f"{LESSON}.ipynb", [Student("ada", "Ada")], tmp_path / "other")
    assert other.draws["ada"] != first.draws["ada"]


def test_no_two_of_a_class_share_a_number(tmp_path: Path) -> None:
    """Up to as many students as there are values; beyond that no more share one than must; nobody's changes."""
    lesson = "05_memory"
    few = handed_out(tmp_path, [f"s{number}" for number in range(35)], lesson)
    for place, task in enumerate(few.tasks):
        assert len({*map(str, (draws[place].numbers for draws in few.draws.values()))}) == 35, task
    many = handed_out(tmp_path, [f"s{number}" for number in (*range(60, 34, -1), *range(35))], lesson)
    assert len(many.draws) == 61
    assert {name: many.draws[name] for name in few.draws} == few.draws
    for place, task in enumerate(many.tasks):
        [own] = own_parameters(task.check()).values()
        shared = Counter(str(draws[place].numbers) for draws in many.draws.values())
        assert max(shared.values()) == math.ceil(61 / len(own.values)), task


@pytest.mark.parametrize(
    ("files", "found"),
    [
        (["00_loop.ipynb", "00_loop (1).ipynb", "x.ipynb"], "00_loop.ipynb"),
        (["00_loop (1).ipynb", "05_memory.ipynb"], "00_loop (1).ipynb"),
        (["anything.ipynb"], "anything.ipynb"),
        (["a.ipynb", "b.ipynb"], ""),
        (["00_loop (1).ipynb", "00_loop (2).ipynb"], ""),
        ([], ""),
    ],
)
def test_which_notebook_counts(files: list[str], found: str, tmp_path: Path) -> None:
    """That of the lesson's name, or one that is called nearly so, or the only one."""
    for name in files:
        (tmp_path / "ada").mkdir(exist_ok=True)
        (tmp_path / "ada" / name).touch()
    if found:
        assert submission(tmp_path, "ada", LESSON).name == found
    else:
        with pytest.raises(ValueError, match="not clear which" if files else "nothing came in"):
            submission(tmp_path, "ada", LESSON)


def test_what_has_to_run(tmp_path: Path) -> None:
    """Of the lesson only what the answers need, and it needs no measured cells; each answer is checked once."""
    made = handed_out(tmp_path, ["ada"])
    work = Work(tmp_path, made, "ada")
    steps = needed_steps(work.notebook.cells, work.notebook.cells, made.tasks)
    assert [step["exercise"] for step in steps] == [None, 1, 1, 2, 2, 3, 3]
    without = [cell for cell in work.notebook.cells if not is_check(cell)]
    without.append(nbformat.v4.new_code_cell("import time; time.sleep(1_000)"))  # nothing that counts comes after it
    checked = [step["exercise"] for step in needed_steps(without, work.notebook.cells, made.tasks) if step["check"]]
    assert checked == [1, 2, 3]
    assert needed_steps(without, work.notebook.cells, made.tasks)[-1]["check"]


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("name,number\nada,1\n", "id"),
        ("id,name\n../ada,Ada\n", "line 2.*'../ada'"),
        ("id\nada\nAda\n", "line 3.*'Ada'"),
        ("id\n", "none"),
        ("id,name\n,Ada\n", "line 2.*''"),
    ],
)
def test_lists_that_are_refused(text: str, names: str, tmp_path: Path) -> None:
    """No column of ids, an id that is a path, twice the same, nobody, no id."""
    path = tmp_path / "class.csv"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(ValueError, match=names):
        read_students(path)


def test_a_list_from_a_spreadsheet(tmp_path: Path) -> None:
    """With semicolons and a mark at its beginning; a student without a name is called by her id."""
    path = tmp_path / "class.csv"
    path.write_text("\ufeffid;first_name;last_name\r\ns1;Ada;Lovelace\r\ns2;;\r\n", encoding="utf-8")
    assert read_students(path) == [Student("s1", "Ada Lovelace"), Student("s2", "s2")]


@pytest.mark.parametrize(
    ("arguments", "names"),
    [
        (["assign", "no_such_lesson", "--students", "class.csv"], "no_such_lesson"),
        (["assign", "00_loop", "--students", "nowhere.csv"], "nowhere.csv"),
        (["grade", "nowhere.json"], "nowhere.json"),
        (["grade", "other.json"], "other.json"),
    ],
)
def test_commands_that_are_refused(
    arguments: list[str], names: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """With one sentence that names what is wrong."""
    monkeypatch.chdir(tmp_path)
    Path("class.csv").write_text("id\nada\n")
    Path("other.json").write_text(json.dumps({"lesson": 1}))
    ran = CliRunner(env={"COLUMNS": "300"}).invoke(commands.app, arguments)
    assert ran.exit_code == 2
    assert names in ran.output


@pytest.mark.slow
def test_nbgrader_grades_it_too(tmp_path: Path) -> None:
    """It has one version of each check, so each student's own comes first; docs/teaching.md has the same commands."""
    import shutil

    from nbgrader.api import Gradebook

    made = handed_out(tmp_path, ["ada", "bob", "dora"])
    for name in made.students:
        work = Work(tmp_path, made, name)
        does, *_ = CLASS[name]
        assert does is not None
        does(work)
        work.hand_in()
        shutil.copytree(made.path.parent / "source" / name, tmp_path / "source", dirs_exist_ok=True)
        nbgrader(tmp_path, "generate_assignment", made.lesson, "--force")
        nbgrader(
            tmp_path, "autograde", made.lesson, f"--student={name}", f"--Execute.timeout={10 * build.CELL_SECONDS}"
        )
    with Gradebook(f"sqlite:///{tmp_path / 'gradebook.db'}") as gradebook:
        rows = gradebook.assignment_submissions(made.lesson)
        scores = {row.student.id: (row.score, row.max_score) for row in rows}
    assert scores == {"ada": (4, 4), "bob": (0, 4), "dora": (0, 4)}
