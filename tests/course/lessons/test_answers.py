"""Checks of exercises, on right and wrong answers: every lesson's folder `answers` is found by its place."""

import ast
import re
from collections import Counter
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from types import ModuleType

import build
import pytest

from edugym.experiments import repeat as repeating
from edugym_course.grading import agents, choices, curves, mistakes, programs, replay, results, updates, values
from edugym_course.grading.errors import folded
from edugym_course.grading.one_step import Q_LEARNING
from tests.course.lessons.answers import (
    LONG,
    Answer,
    Exercise,
    functions_of,
    namespace_after,
    read_answers,
    read_exercises,
    read_project,
    verdict,
)
from tests.messages import named

LESSONS = [*build.lesson_sources()]
ANSWERS = [answer for lesson in LESSONS for answer in read_answers(lesson)[1]]
GRADING = build.ROOT / "tests" / "course" / "grading"
FEWEST_WRONG, FEWEST_RIGHT = 5, 2
FEWEST_WRONG_PROGRAMS, FEWEST_RIGHT_PROGRAMS = 4, 1  # besides the one in the lesson
FEWEST_LETTERS = 10  # shorter texts, and those without a space, are names and codes
PART = 16  # shorter parts of a sentence with numbers in it are too common to be looked for


def hints(path: Path) -> dict[str, bool]:
    """Return the sentences of a module, and whether each is whole; those with numbers in them come in parts."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    others = {ast.dump(part) for node in ast.walk(tree) for part in _no_hints(node)}
    parts = {id(node) for text in ast.walk(tree) if isinstance(text, ast.JoinedStr) for node in ast.walk(text)}
    return {
        node.value.strip(): id(node) not in parts
        for node in ast.walk(tree)
        if isinstance(node, ast.Constant)
        and isinstance(node.value, str)
        and ast.dump(node) not in others
        and " " in node.value.strip()
        and len(node.value) >= (PART if id(node) in parts else FEWEST_LETTERS)
    }


def _no_hints(node: ast.AST) -> Iterator[ast.AST]:
    """Yield the parts of a node that no wrong answer is told: docstrings, praise, the challenge, own numbers."""
    match node:
        case ast.Expr(part):
            yield part
        case ast.Dict(values=values):
            yield from values
        case ast.Subscript(ast.Dict(keys=keys)) | ast.Attribute(ast.Dict(keys=keys)):
            yield from filter(None, keys)
        case ast.Compare(comparators=parts) | ast.arguments(kw_defaults=parts):
            yield from (end for part in parts if part for end in ast.walk(part))
        case ast.FunctionDef(name=name) if name.startswith(("exercise_", "project_")):
            yield from (part for end in ast.walk(node) if isinstance(end, ast.Return) for part in ast.walk(end))
        case ast.Assign([ast.Name("CHALLENGE" | "OWN_MISTAKE")]):
            yield from ast.walk(node)
        case ast.Call(func=ast.Name("Own" | "step_cost" | "use_your_own")):
            yield from ast.walk(node)


@cache
def exercises_of(lesson: str) -> tuple[tuple[str, str], list[Exercise]]:
    """What runs before every answer, and the exercises of a lesson."""
    imports, exercises = read_exercises(build.lesson_sources()[lesson])
    return (imports, read_answers(lesson)[0]), exercises


def checked_by(answer: Answer) -> Exercise:
    """The exercise, or the project, that an answer is for."""
    if answer.exercise:
        return exercises_of(answer.lesson)[1][answer.exercise - 1]
    project = read_project(build.lesson_sources()[answer.lesson])
    assert project, f"{answer.lesson} has answers to a project, and no project"
    return project


@cache
def hints_of(lesson: str) -> dict[str, bool]:
    """All that the checks of a lesson may say of a wrong answer, and whether it is a whole sentence."""
    folder = build.lesson_sources()[lesson].parent
    paths = [*folder.glob("exercises.py"), *folder.glob("exercises/*.py"), *folder.glob("project.py")]
    return {hint: whole for path in paths for hint, whole in hints(path).items()}


@pytest.mark.parametrize(
    "answer",
    [
        pytest.param(
            answer,
            marks=[pytest.mark.slow] * answer.slow,
            id=f"{answer.lesson}-{answer.exercise}-{answer.name}",
        )
        for answer in ANSWERS
    ],
)
def test_an_answer(answer: Answer, capsys: pytest.CaptureFixture[str]) -> None:
    """A right one passes, with one line; a wrong one is refused in one sentence that says which mistake it is."""
    said = verdict(answer, checked_by(answer), exercises_of(answer.lesson)[0])
    printed = capsys.readouterr().out
    assert (said == "") == answer.right, said or "the check accepts it"
    assert [line.startswith("✓ ") for line in printed.splitlines()].count(True) == int(answer.right)
    if answer.right:
        assert all(f"{folded(f'✓ {words}')}\n" in printed for words in answer.says)
        return
    for words in answer.says:
        assert words in said
        longer = {hint for hint in hints_of(answer.lesson) if words in hint and words != hint and hint in said}
        assert words not in hints_of(answer.lesson) or not longer, "a hint that contains this one"
    assert "\n" not in said
    assert len(said) < 700


@pytest.mark.parametrize("path", build.lesson_sources().values(), ids=lambda path: path.stem)
def test_every_exercise_has_answers(path: Path) -> None:
    """Five wrong and two right ones or more for each exercise, one of them with its praise, and no two alike."""
    _, exercises = exercises_of(path.stem)
    answers = [answer for answer in ANSWERS if answer.lesson == path.stem]
    counts = Counter((answer.exercise, answer.right) for answer in answers)
    for number, exercise in enumerate(exercises, start=1):
        assert exercise.check, f"exercise {number} is checked by no call of `check`"
        assert counts[number, False] >= FEWEST_WRONG
        assert counts[number, True] >= FEWEST_RIGHT
        assert any(answer.says for answer in answers if answer.exercise == number and answer.right)
    if read_project(path):
        assert counts[0, False] >= FEWEST_WRONG_PROGRAMS
        assert counts[0, True] >= FEWEST_RIGHT_PROGRAMS
    assert len({(answer.exercise, answer.code) for answer in answers}) == len(answers)


def edited(edits: str, folder: Path, monkeypatch: pytest.MonkeyPatch) -> str:
    """The code of a wrong answer that edits a right one, "a walk"."""
    (folder / "answers").mkdir()
    (folder / "answers" / "project_right.py").write_text(WALK, encoding="utf-8")
    (folder / "answers" / "project_wrong.py").write_text(f"# %% too far\n# says: x\n{edits}", encoding="utf-8")
    monkeypatch.setattr(build, "lesson_sources", lambda: {"99_walk": folder / "99_walk.py"})
    return read_answers("99_walk")[1][-1].code


WALK = """# %% a walk
def walk(n):
    for _ in range(n):
        if rest():
            sleep()
        step()
    sleep()
"""


def test_an_edit_of_a_right_answer(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """One edit after another; new lines are indented as those they replace, and may be none."""
    edits = "# in: a walk\n# - if rest():\n# -     sleep()\n# - step()\n# + if go():\n# +     step()\n# - sleep()\n"
    code = edited(edits, tmp_path, monkeypatch)
    assert code == "def walk(n):\n    for _ in range(n):\n        if go():\n            step()\n"


def test_functions_of_a_solution() -> None:
    """Methods stand at the left margin; docstrings are left out, and the other lines are as they were."""
    method = '    def act(self):\n        """Choose,\n        at random."""\n        return 3  # for now\n'
    found = functions_of(f"x = 1\n\n\nclass Agent:\n{method}\n\ndef make():\n    return Agent()\n")
    assert found == {"act": "def act(self):\n    return 3  # for now\n", "make": "def make():\n    return Agent()\n"}


@pytest.mark.parametrize(
    ("edits", "says"),
    [
        (
            "# in: a walk\n# - step()\n# + 1 + step()\n# - 1 + step()\n# - sleep()\n",
            "0 times, not once:\n1 + step()\nsleep",
        ),
        ("# in: a run\n# - step()\n", "no right answer to this exercise is called 'a run'"),
        ("# in: a walk\n# - step()\nleap()\n", "only lines '# - ...' and '# + ...'"),
        ("# in: a walk\n# + leap()\n# - step()\n", "only lines '# - ...' and '# + ...'"),
        ("# in: a walk\n# - leap()\n# + step()\n", "0 times, not once:\nleap()"),
        ("# in: a walk\n# - sleep()\n", "2 times, not once:\nsleep()"),
    ],
)
def test_an_edit_that_does_not_fit(edits: str, says: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The error names the file, the answer, and what the right answer lacks."""
    with pytest.raises(AssertionError, match=rf"project_wrong\.py: 'too far': .*{re.escape(says)}"):
        edited(edits, tmp_path, monkeypatch)


@pytest.mark.parametrize("lesson", LESSONS)
def test_every_hint_is_told(lesson: str) -> None:
    """Whatever a check may say of a wrong answer stands, word for word, behind a `# says:` of its lesson."""
    told = {words for answer in ANSWERS if answer.lesson == lesson for words in answer.says}
    all_of_it = "\n".join(told)
    assert hints_of(lesson)
    assert not {hint for hint, whole in hints_of(lesson).items() if hint not in (told if whole else all_of_it)}


@pytest.mark.parametrize(
    "module",
    [agents, choices, curves, mistakes, programs, replay, results, updates, values],
    ids=lambda module: module.__name__.rpartition(".")[2],
)
def test_every_shared_hint_is_told(module: ModuleType) -> None:
    """What the checks of several lessons say stands behind a `# says:`, or in the tests of `edugym_course.grading`."""
    told = [words for answer in ANSWERS for words in answer.says]
    for text in (path.read_text(encoding="utf-8") for path in GRADING.glob("test_*.py")):
        told += [text.replace("\\", ""), *map(str, (getattr(node, "value", "") for node in ast.walk(ast.parse(text))))]
    all_of_it = "\n".join(told)
    assert not {hint for hint in hints(Path(str(module.__file__))) if hint not in all_of_it}


def test_every_mistake_of_q_learning_is_told() -> None:
    """Several exercises share them; each is told in one of them or more."""
    told = {words for answer in ANSWERS for words in answer.says}
    assert not {sentence for sentence in Q_LEARNING.mistakes if sentence not in told}


@pytest.mark.parametrize(
    "lesson",
    [
        pytest.param(lesson, marks=[pytest.mark.slow] * (lesson in ("02_on_off_policy", "15_profiles")))
        for lesson in LESSONS
    ],
)
def test_solutions_pass_and_placeholders_are_not_solved_yet(lesson: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """The lesson's own solution of an exercise is right, and counts; its empty cell is told that it is empty."""
    counted: list[tuple[str, int]] = []
    monkeypatch.setattr("edugym_course.grading.checking.record_passed", lambda *passed: counted.append(passed))
    before, exercises = exercises_of(lesson)
    for number, exercise in enumerate(exercises, start=1):
        solved = Answer(lesson, number, True, "solution", (), exercise.solution)
        empty = Answer(lesson, number, False, "placeholder", (), exercise.placeholder)
        counted.clear()
        assert verdict(solved, exercise, before) == ""
        n_counted = len(counted)
        said = verdict(empty, exercise, before)
        assert "Not solved yet" in said or "began" in said
        assert ({*counted}, len(counted)) == ({(lesson.partition("_")[2], number)}, n_counted)  # the empty one does not


def test_answers_leave_nothing_behind() -> None:
    """The setup of some leaves training out, which later tests need."""
    trains = vars(repeating)["train"]
    for lesson in LESSONS:
        with namespace_after(*exercises_of(lesson)[0]):
            pass
        assert vars(repeating)["train"] is trains, lesson


@pytest.mark.parametrize("lesson", LESSONS)
def test_an_answer_of_another_kind_is_called_by_its_name(lesson: str) -> None:
    """Whatever is asked for, an object that is nothing of the kind is refused by the name that the cell uses."""
    before, exercises = exercises_of(lesson)
    for number, exercise in enumerate(exercises, start=1):
        name = exercise.check.partition(", ")[2].partition(")")[0]
        other = Answer(lesson, number, False, "an object", (), f"{name} = object()")
        assert re.search(named(name), verdict(other, exercise, before))


@pytest.mark.parametrize(
    "lesson",
    [
        pytest.param(name, marks=[pytest.mark.slow] * (name in LONG))
        for name, path in build.lesson_sources().items()
        if read_project(path)
    ],
)
def test_programs_pass_and_empty_cells_are_not_solved_yet(lesson: str) -> None:
    """The lesson's own program is right; its empty cell is told that it is empty."""
    project = read_project(build.lesson_sources()[lesson])
    assert project
    before = exercises_of(lesson)[0]
    assert verdict(Answer(lesson, 0, True, "program", (), project.solution), project, before) == ""
    assert "Not solved yet" in verdict(Answer(lesson, 0, False, "empty", (), project.placeholder), project, before)
