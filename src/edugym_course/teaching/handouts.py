"""A lesson in the form that other grading systems want: Otter-Grader, and GitHub Classroom."""

from copy import deepcopy
from pathlib import Path
from textwrap import indent
from typing import Any

from edugym.system.extras import requirement
from edugym.system.files import write_whole
from edugym_course.teaching.assignment import Assignment, Draw, Task, handed_out, tasks_of
from edugym_course.teaching.marks import is_code, is_exercise, without_marks, without_solutions
from edugym_course.teaching.students import Student

INSTALL = requirement("teach")
"""What pip installs to grade a lesson."""

SEEDS = (0, 1)
"""From which the cases of the two tests are drawn: that of the check in the lesson, and another one."""

WHOEVER = Student("student", "This copy")
"""To whom a repository belongs."""

SETTINGS = f"""\
# ASSIGNMENT CONFIG
name: {{name}}
init_cell: false
export_cell: false
check_all_cell: false
requirements:
    - {INSTALL}
tests:
    ok_format: false
generate:
    pdf: false
"""

TEST = """\
# HIDDEN
def passes(env):
    import edugym_course.grading
    import {module}

    edugym_course.grading.check({module}.{function}, eval({answer!r}, env), seed={seed}, quiet=True)
"""
"""It imports what it calls: a student may have given another meaning to `check` and `exercise_1`."""

WORKFLOW = """\
# Grades the lesson whenever it is pushed, and reports the points to GitHub Classroom.
name: Grade the lesson
on: [push, workflow_dispatch]
permissions:
  actions: read
  checks: write
  contents: read
jobs:
  grade:
    if: github.actor != 'github-classroom[bot]'
    runs-on: ubuntu-latest
    timeout-minutes: 30
    steps:
      - uses: actions/checkout@v4
      - uses: actions/setup-python@v5
        with:
          python-version: "3.12"
          cache: pip
          cache-dependency-path: .github/edugym/requirements.txt
      - name: Install
        run: pip install --requirement .github/edugym/requirements.txt
      - name: Grade
        run: |
          mkdir -p submitted/{student}
          cp {lesson}.ipynb submitted/{student}/
          edugym grade .github/edugym/{lesson}.json --submitted submitted --output results
          cat results/{lesson}.md >> "$GITHUB_STEP_SUMMARY"
{tests}
      - name: Report
        if: always()
        uses: classroom-resources/autograding-grading-reporter@v1
        env:
{results}
        with:
          runners: {runners}
"""

PASSED = "import csv; row = next(csv.DictReader(open('results/{lesson}.csv'))); exit(row['exercise_{number}'] == '0')"
"""A program that fails if an exercise got no points."""

WORKFLOW_TEST = """\
      - name: Exercise {number}
        id: exercise-{number}
        if: always()
        uses: classroom-resources/autograding-command-grader@v1
        with:
          test-name: Exercise {number}
          command: python -c "{passed}"
          timeout: 1
          max-score: {points:g}"""

README = f"""\
# {{title}}

Open `{{lesson}}.ipynb` with JupyterLab, solve its exercises, and push. Each push is graded: see *Actions*.

    pip install "{requirement("lab")}"
    jupyter lab {{lesson}}.ipynb

Work in the cells below each exercise. The cell after it checks your answer, as often as you like. What stands in
`.github` belongs to the grading: changes there are seen by your teacher.
"""


def otter_master(lesson: Any, name: str) -> str:
    """Return the text of the master notebook from which `otter assign` makes what students get, and an autograder.

    Args:
        lesson: the teacher's notebook.
        name: what Otter calls the assignment.

    Raises:
        ValueError: the notebook is none of a lesson.
    """
    from nbformat import writes
    from nbformat.v4 import new_code_cell, new_raw_cell

    tasks = iter(tasks_of(lesson))
    cells = [new_raw_cell(SETTINGS.format(name=name))]
    for cell in lesson.cells:
        if is_exercise(cell):
            task = next(tasks)
            cells += [
                new_raw_cell(
                    f"# BEGIN QUESTION\nname: exercise_{task.number}\npoints: {task.points:g}\nall_or_nothing: true"
                ),
                new_raw_cell("# BEGIN SOLUTION"),
                new_code_cell(_with_prompt(cell.source)),
                new_raw_cell("# END SOLUTION"),
                new_raw_cell("# BEGIN TESTS"),
                *(new_code_cell(_otter_test(task, seed)) for seed in SEEDS),
                new_raw_cell("# END TESTS"),
                new_raw_cell("# END QUESTION"),
            ]
        elif is_code(cell):
            cells.append(new_code_cell(without_solutions(cell.source), metadata=cell.metadata))
        else:
            cells.append(cell)
    made = deepcopy(lesson)
    made.cells = cells
    return str(writes(made))


def _with_prompt(source: str) -> str:
    """Return a solution, and what students get in its place, with the marks of Otter."""
    lines = ["# BEGIN SOLUTION NO PROMPT", without_marks(source), "# END SOLUTION"]
    return "\n".join([*lines, "''' # BEGIN PROMPT", without_solutions(source), "'''; # END PROMPT"])


def _otter_test(task: Task, seed: int) -> str:
    return TEST.format(**vars(task), seed=seed)


def classroom_repository(lesson: Any, name: str, folder: Path) -> None:
    """Write the template repository of an assignment of GitHub Classroom.

    Args:
        lesson: the teacher's notebook.
        name: the name of the lesson, such as "03_depth".
        folder: the folder to write to.

    Raises:
        ValueError: the notebook is none of a lesson.
        OSError: something cannot be written.
    """
    import nbformat

    tasks = tasks_of(lesson)
    grading = folder / ".github" / "edugym"
    draws = {WHOEVER.id: [Draw({}, *SEEDS) for _ in tasks]}
    assignment = Assignment(name, "", tasks, {WHOEVER.id: WHOEVER}, draws, grading / f"{name}.json")
    assignment.write()
    given = nbformat.writes(handed_out(lesson)).encode()
    names = [f"exercise-{task.number}" for task in tasks]
    workflow = WORKFLOW.format(
        lesson=name,
        student=WHOEVER.id,
        tests="\n".join(_workflow_test(task, name) for task in tasks),
        results=indent("\n".join(f"{_variable(n)}: ${{{{ steps.{n}.outputs.result }}}}" for n in names), " " * 10),
        runners=",".join(names),
    )
    readme = README.format(lesson=name, title=lesson.cells[0].source.partition("\n")[0].lstrip("# "))
    for path, content in {
        folder / f"{name}.ipynb": given,
        assignment.source(WHOEVER.id): given,
        grading / "requirements.txt": f"{INSTALL}\n".encode(),
        folder / ".github" / "workflows" / "classroom.yml": workflow.encode(),
        folder / "README.md": readme.encode(),
        folder / ".gitignore": b"submitted/\nresults/\n.ipynb_checkpoints/\n",
    }.items():
        write_whole(path, content)


def _workflow_test(task: Task, lesson: str) -> str:
    passed = PASSED.format(lesson=lesson, number=task.number)
    return WORKFLOW_TEST.format(number=task.number, points=task.points, passed=passed)


def _variable(name: str) -> str:
    """Return the name of the variable from which the reporter reads the result of a test."""
    return f"{name.upper()}_RESULTS"
