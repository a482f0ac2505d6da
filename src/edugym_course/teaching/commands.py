"""The commands for teachers: hand out a lesson, and grade what comes back."""

from pathlib import Path
from typing import Annotated, Literal

import typer

from edugym.system.files import write_whole
from edugym_course.arguments import path_of


def assign(
    lesson: Annotated[
        str,
        typer.Argument(help="In a checkout a name, such as 01_exploration; else the path of the teacher's notebook."),
    ],
    students: Annotated[
        Path, typer.Option(parser=path_of, metavar="LIST", help="A CSV file with a column id and, if you like, name.")
    ],
    output: Annotated[Path, typer.Option(parser=path_of, metavar="FOLDER", help="The folder to write to.")] = Path(
        "assigned"
    ),
) -> None:
    """For teachers: make a lesson for each student, with numbers of her own.

    OUTPUT/handout/ID is for the student ID. OUTPUT/teacher is for nobody else: it has the secret from which the numbers
    come, the solutions, and the hidden tests. With a longer list, the same command makes the lessons of those who
    came late, and leaves the others' numbers as they are.
    """
    from edugym_course.teaching import assignment
    from edugym_course.teaching.students import read_students

    try:
        made = assignment.assign(assignment.teacher_edition(lesson), read_students(students), output)
    except (OSError, ValueError) as error:
        raise typer.BadParameter(str(error)) from error
    for place, task in enumerate(made.tasks):
        given = [draws[place].numbers for draws in made.draws.values()]
        most = max(map(given.count, given))
        own = f"own {' and '.join(given[0])}" if given[0] else "the same for all, with other cases"
        shared = f", which up to {most} students share" if given[0] and most > 1 else ""
        typer.echo(f"Exercise {task.number}: {own}{shared}.")
    count = len(made.students)
    typer.echo(
        f"{count} lessons to hand out are in {output / assignment.HANDOUT}. Keep {made.path.parent} to yourself."
    )


def handout(
    lesson: Annotated[
        str,
        typer.Argument(help="In a checkout a name, such as 01_exploration; else the path of the teacher's notebook."),
    ],
    system: Annotated[Literal["otter", "classroom"], typer.Option("--for", help="Otter-Grader, or GitHub Classroom.")],
    output: Annotated[Path, typer.Option(parser=path_of, metavar="FOLDER", help="The folder to write to.")] = Path(
        "handout"
    ),
) -> None:
    """For teachers: make a lesson for Otter-Grader or GitHub Classroom.

    For Otter it is OUTPUT/LESSON.ipynb, a master notebook for `otter assign`; it has the solutions. For GitHub
    Classroom OUTPUT is a template repository whose workflow grades every push; it has no solutions.
    """
    from edugym_course.teaching import handouts
    from edugym_course.teaching.assignment import read_lesson, teacher_edition

    try:
        notebook = teacher_edition(lesson)
        if system == "classroom":
            handouts.classroom_repository(read_lesson(notebook), notebook.stem, output)
            typer.echo(f"{output} is a template repository for GitHub Classroom.")
        else:
            master = handouts.otter_master(read_lesson(notebook), notebook.stem)
            write_whole(output / notebook.name, master.encode())
            typer.echo(f"Now: otter assign {output / notebook.name} FOLDER")
    except (OSError, ValueError) as error:
        raise typer.BadParameter(str(error)) from error


def grade(
    assigned: Annotated[
        Path, typer.Argument(parser=path_of, help="What `edugym assign` wrote: assigned/teacher/01_exploration.json.")
    ],
    submitted: Annotated[
        Path,
        typer.Option(parser=path_of, metavar="FOLDER", help="It has a folder ID with each student's notebook."),
    ] = Path("submitted"),
    output: Annotated[
        Path, typer.Option(parser=path_of, metavar="FOLDER", help="The folder for the results of the class.")
    ] = Path("results"),
    seconds: Annotated[float, typer.Option(min=1, help="The longest time for one student.")] = 600,
) -> None:
    """For teachers: grade what came back, with the checks of each student's own numbers.

    It runs the students' code on this machine, as you: use a container for people whom you do not trust. The results of
    the class are OUTPUT/LESSON.html, and the same as .md and .csv.
    """
    from edugym_course.teaching import grading, page
    from edugym_course.teaching.assignment import Assignment

    try:
        assignment = Assignment.read(assigned)
        for name in grading.strangers(assignment, submitted):
            typer.echo(f"edugym: {submitted / name} belongs to nobody on the list", err=True)
        graded = []
        for one in grading.grade(assignment, submitted, seconds):
            graded.append(one)
            remarks = "; ".join([*page.belongs(one, assignment), *one.remarks])
            typer.echo(f"{one.student.name} ({one.student.id}): {one.points:g}{f' ({remarks})' if remarks else ''}")
        for ending, text in (("html", page.as_html), ("md", page.markdown), ("csv", page.as_csv)):
            write_whole(output / f"{assignment.lesson}.{ending}", text(assignment, graded).encode())
    except (OSError, ValueError) as error:
        raise typer.BadParameter(str(error)) from error
    typer.echo(f"The results are in {output / assignment.lesson}.html, .md and .csv.")
