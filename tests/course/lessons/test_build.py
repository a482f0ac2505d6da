"""Tests of the builder of notebooks, on a tiny lesson, and of every lesson that is there."""

import ast
import importlib.metadata
import importlib.util
import json
import subprocess
import sys
from pathlib import Path

import build
import nbformat
import pytest
from nbformat import NotebookNode
from nbformat.v4 import new_code_cell, new_notebook
from rules import is_code, without_solutions

from edugym_course.notebook.flipbook import Flipbook

LESSON = '''\
# %% [markdown]
# # Doubling
# **The challenge.** Numbers are small. **You will be able to** double them. **Time.** {time}
# **Before you start.** Nothing.
# %% [markdown]
# ## Meet the environment
# %%
import ipywidgets
import matplotlib.pyplot as plt


def draw(height: int) -> None:
    """Draws a line."""
    plt.plot([0, height])
    plt.show()
    print("drawn up to", height)
# %% [markdown]
# ## The idea
# $2x = x + x$, and this is no heading:
# ```
# # a comment
# ```
# %%
print(1 + 1)
# %% [markdown] tags=["aside"]
# ### Aside: halves
# Halves are fun.
# %%
half = 1 / 2
# %% [markdown]
# ## The experiment
# %%
draw(3)
# %% [markdown]
# ## Your turn
# %%
_ = ipywidgets.interact(draw, height=(1, 5))
# %% [markdown]
# ## See inside
# %%
print({"b", "a", "c", "d"})
# %% [markdown]
# ## Predict, then check
# **Predict.** What is 2 times 2?
# %%
from edugym_course.notebook import predict

product = predict("2 times 2")
product
# %%
product.measured(2 * 2)
# %% [markdown]
# <details><summary>What was measured</summary> **Measured.** 4. </details>
# %% [markdown]
# ## Exercises
# Write `double`. <details><summary>Hint</summary> Add. </details>
# %%
def double(number: int) -> int:
    """Twice the number."""
    ### BEGIN SOLUTION
    return number + number  # a secret sum
    ### END SOLUTION
# %% tags=["check"] points=2
assert double(4) == 8, f"double(4) is 4 + 4 = 8, not {double(4)}"
# %% [markdown]
# Choose a `factor` that doubles. <details><summary>Hint</summary> It is even. </details>
# %%
factor = 1
### BEGIN SOLUTION
factor = 2  # secret
### END SOLUTION
# %%
assert factor > 1, f"factor = {factor} does not double"
### BEGIN HIDDEN TESTS
assert factor == 2, "secret too"
### END HIDDEN TESTS
# %% [markdown]
# ## What you saw
# ### Limits
# Overflow.
# ### Further reading
# None.
'''


@pytest.fixture
def source(tmp_path: Path) -> Path:
    """The tiny lesson, as a file."""
    path = tmp_path / build.LESSONS / "doubling" / "01_doubling.py"
    path.parent.mkdir(parents=True)
    path.write_text(LESSON, encoding="utf-8")
    return path


def all_editions(source: Path) -> dict[str, NotebookNode]:
    """The three editions of a lesson, not executed, by name."""
    made = build.editions(source, source.parents[4] / "notebooks")
    return dict(zip(["student", "solution", "teacher"], made.values(), strict=True))


def test_editions(source: Path) -> None:
    """Students see no solution and no hidden test; all cells are plain Python; teachers get nbgrader's schema 3."""
    made = all_editions(source)
    text = {name: nbformat.writes(notebook) for name, notebook in made.items()}
    for word in ("secret", "BEGIN", "END"):
        assert word not in text["student"]
        assert word in text["teacher"]
    assert "secret sum" in text["solution"]
    assert "secret too" in text["solution"]
    assert "BEGIN" not in text["solution"]
    assert "/blob/main/notebooks/01_doubling.ipynb" in made["student"].cells[0].source
    for notebook in made.values():
        assert next(filter(is_code, notebook.cells)).source == build.INSTALL
        assert "lesson-feedback.yml&lesson=01_doubling" in notebook.cells[-1].source
        nbformat.validate(notebook)
        assert [cell.id for cell in notebook.cells] == [f"cell-{n:03d}" for n in range(len(notebook.cells))]
        for cell in filter(is_code, notebook.cells):
            assert ast.parse(cell.source).body
            assert cell.outputs == []
            assert cell.execution_count is None
            assert "points" not in cell.metadata
    roles = [cell.metadata["nbgrader"] for cell in made["teacher"].cells if "nbgrader" in cell.metadata]
    exercise = {"schema_version": 3, "task": False, "grade": False, "solution": True, "locked": False}
    check = {"schema_version": 3, "task": False, "grade": True, "solution": False, "locked": True}
    assert roles == [
        exercise | {"grade_id": "exercise-1"},
        check | {"grade_id": "check-1", "points": 2},
        exercise | {"grade_id": "exercise-2"},
        check | {"grade_id": "check-2", "points": 1},
    ]


PROJECT = """\
# %% tags=["project"]
my_program = ...  # your program
### BEGIN PROGRAM
my_program = "a long secret"
### END PROGRAM
# %% tags=["project"]
check(project_1, my_program)
# %% [markdown]
# ## What you saw
"""


def test_a_program_from_a_blank_file(source: Path) -> None:
    """Students and teachers get the empty cell, whose check may fail; the program is in the solution alone."""
    source.write_text(LESSON.replace("# %% [markdown]\n# ## What you saw\n", PROJECT), encoding="utf-8")
    made = all_editions(source)
    for name, notebook in made.items():
        program, check = (cell for cell in notebook.cells if "project" in cell.metadata.get("tags", []))
        assert ("secret" in program.source) == (name == "solution")
        assert program.source.startswith("my_program = ...") == (name != "solution")
        assert check.source == "check(project_1, my_program)"
        assert ("raises-exception" in check.metadata.tags) == (name != "solution")
        assert "nbgrader" not in program.metadata
    broken = PROJECT.replace("check(project_1, my_program)", "1")
    source.write_text(LESSON.replace("# %% [markdown]\n# ## What you saw\n", broken), encoding="utf-8")
    with pytest.raises(build.LessonError, match="a project is two cells with the tag 'project'"):
        build.read_lesson(source)


def test_what_takes_the_place_of_a_solution() -> None:
    """In a function the placeholder raises, even inside a method's loop; elsewhere it does nothing."""
    region = "### BEGIN SOLUTION\n{0}x = 1\n{0}### END SOLUTION"
    method = (
        f"class A:\n    def f(self):\n        for i in [1]:\n            {region.format(' ' * 12)}\n        return x"
    )
    assert 'raise NotImplementedError("not solved yet' in without_solutions(method)
    loop = without_solutions(f"def f(): return 1\nfor i in [1]:\n    {region.format(' ' * 4)}\n")
    assert loop == "def f(): return 1\nfor i in [1]:\n    # Your solution here.\n    pass"
    exec(compile(loop, "cell", "exec"), {})


def test_the_install_cell_keeps_what_is_there(monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing is installed where the package is; where it is not, NumPy and torch are pinned to what is there."""
    commands: list[list[str]] = []
    monkeypatch.setattr(subprocess, "run", lambda command, check: commands.append(command))
    monkeypatch.setattr(importlib.metadata, "version", lambda name: {"numpy": "2.0.1", "torch": "2.6.0+cu124"}[name])
    there = {"edugym", "numpy"}
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: sys if name in there else None)
    exec(build.INSTALL, {})
    assert commands == []
    there.remove("edugym")
    exec(build.INSTALL, {})
    there.add("torch")
    exec(build.INSTALL, {})
    pins = [Path(command[command.index("--constraint") + 1]).read_text().split() for command in commands]
    assert pins == [["numpy==2.0.1"], ["numpy==2.0.1", "torch==2.6.0+cu124"]]
    assert all(command[-1].startswith("edugym[notebook] @ git+https://") for command in commands)


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("## The idea", "## An idea", "the headings must begin so"),
        ("# ## Your turn", "# Play.\n# ## Your turn", "opens its cell"),
        ("**Time.** {time}", "", r"must contain '\*\*Time"),
        ("### Limits", "", "must contain '### Limits'"),
        ("%%\nproduct.measured(2 * 2)", "%% [markdown]\n# 4", "needs next a code cell"),
        ("product.measured(2 * 2)", "print(2 * 2)", "needs next a code cell"),
        ('predict("2 times 2")', "2 * 2", "needs next a code cell"),
        ("<details><summary>What was measured</summary>", "", "needs next a code cell"),
        ('# %%\nprint({"b", "a", "c", "d"})', "", "'## See inside' must have a code cell"),
        ("<details><summary>Hint</summary> Add. </details>", "", "a hint that folds out"),
        ('tags=["check"] points=2', "", "followed by its check"),
        ('# %%\nprint({"b", "a", "c", "d"})', '# %% tags=["check"]\n1', "follows the exercise that it checks"),
        ("    ### END SOLUTION\n", "", "SOLUTION is marked in code by a line"),
        ("    ### BEGIN SOLUTION", "    ## BEGIN SOLUTION", "SOLUTION is marked in code by a line"),
        ("# ## Exercises", "# ## Exercises\n# ### BEGIN SOLUTION\n# ### END SOLUTION", "SOLUTION is marked in code"),
        ('assert factor > 1, f"factor = {factor} does not double"', "# hidden", "a part that students see"),
        ("### BEGIN SOLUTION\nfactor = 2  # secret\n### END SOLUTION", "", "2 to 4 exercises"),
        ("print(1 + 1)", "!pip install numpy", "not valid Python"),
        ("**Time.** {time}", "**Time.** 1 minute, $\alpha$.", r"invisible, but \['\\x07'\] are"),
        ("interact(draw,", "interact(lambda height: height,", "the widget calls lambda height: height"),
        ("# %%\ndraw(3)", "# %%\nprint(3)", "the widget calls draw"),
        ("### Aside: halves", "### Halves", "'### Halves' is marked as an aside, so it must begin with '### Aside: '"),
        (' tags=["aside"]', "", "'### Aside: halves' is an aside, so its cell needs the tag 'aside'"),
        ("# Halves are fun.", "# #### Quarters", "has no other heading in it, but '#### Quarters'"),
        ("half = 1 / 2", "half = 1\n### BEGIN HIDDEN TESTS\nhalf\n### END HIDDEN TESTS", "a check or a project in it"),
        ("# %%\ndraw(3)", "# %%\ndraw(half)", "'half' comes from '### Aside: halves', and whoever skips that has none"),
        ("# %%\ndraw(3)", "# %%\nhalf += 3", "'half' comes from '### Aside: halves'"),
        ("# %%\ndraw(3)", "# %%\nclass Half:\n    size = half", "'half' comes from '### Aside: halves'"),
        ("# Overflow.", "# More. " + "word " * 6_000, r"the main path has 6,\d\d\d words, and"),
    ],
)
def test_a_lesson_that_breaks_a_rule_is_refused(source: Path, old: str, new: str, message: str) -> None:
    """Every rule is broken once, and the message says what to do."""
    assert old in LESSON
    source.write_text(LESSON.replace(old, new, 1), encoding="utf-8")
    with pytest.raises(build.LessonError, match=message):
        build.read_lesson(source)


@pytest.mark.parametrize(
    "code", ["half = 3", "for half in [1]:\n    draw(half)", "draw(*[half for half in [3]])", "(lambda half: half)(3)"]
)
def test_a_name_of_an_aside_may_be_given_anew(source: Path, code: str) -> None:
    """What counts is where the value comes from."""
    source.write_text(LESSON.replace("# %%\ndraw(3)", f"# %%\n{code}\ndraw(3)"), encoding="utf-8")
    build.read_lesson(source)


def test_an_aside_is_folded_below_its_heading(source: Path) -> None:
    """The heading is a cell by itself, with the time; its aside ends before the next heading, or another aside."""
    another = '# %% [markdown] tags=["aside"]\n# ### Aside: thirds\n# %%\nthird = 1 / 3\n'
    mark = "# %% [markdown]\n# ## The experiment\n"
    source.write_text(LESSON.replace(mark, another + mark), encoding="utf-8")
    for notebook in all_editions(source).values():
        folded = [cell.source for cell in notebook.cells if cell.metadata.get("jp-MarkdownHeadingCollapsed")]
        assert folded == ["### Aside, 5 minutes: halves", "### Aside, 5 minutes: thirds"]
        inside = [cell.source for cell in notebook.cells if "aside" in cell.metadata.get("tags", [])]
        assert inside == [folded[0], "Halves are fun.", "half = 1 / 2", folded[1], "third = 1 / 3"]
        opening = notebook.cells[0].source
        assert "**Time.** About 5 minutes for the text, 10 more for the asides, which are folded" in opening
        assert "and 5 more for the exercises (estimated)." in opening


@pytest.mark.slow
def test_building_twice_changes_no_byte(
    source: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """A second build writes nothing, and one that executes again writes the same bytes, which `--check` accepts."""
    root = source.parents[4]
    monkeypatch.setenv("MPLBACKEND", "Agg")
    monkeypatch.setenv("PYTHONHASHSEED", "random")
    assert build.main([], root) == 0
    files = {path: path.read_bytes() for path in (root / "notebooks").rglob("*.ipynb")}
    assert len(files) == 3
    assert build.main(["01_doubling"], root) == 0
    assert capsys.readouterr().out.count("wrote") == 3
    assert build.build(source, root / "notebooks", execute_again=True) == [
        root / "notebooks/solutions/01_doubling.ipynb"
    ]
    assert {path: path.read_bytes() for path in files} == files
    assert build.main(["--check"], root) == 0
    solution = nbformat.read(root / "notebooks/solutions/01_doubling.ipynb", as_version=4)
    outputs = [output for cell in filter(is_code, solution.cells) for output in cell.outputs]
    printed = [output.text for output in outputs if output.output_type == "stream"]
    assert printed[:2] == ["2\n", "drawn up to 3\n"]
    assert sum("image/png" in output.get("data", {}) for output in outputs) == 1
    assert "widget" not in str(outputs)
    assert "widgets" not in solution.metadata


def test_a_change_of_text_executes_nothing(source: Path) -> None:
    """The outputs are those from before; a change of code is told, so that the notebook is executed."""
    made = build.editions(source, source.parents[4] / "notebooks")
    path = [*made][1]
    path.parent.mkdir(parents=True)
    path.write_text(with_an_output(made[path]), encoding="utf-8")
    text = source.read_text(encoding="utf-8")
    source.write_text(text.replace("# # Doubling", "# # Doubling a number", 1), encoding="utf-8")
    assert build.build(source, path.parents[1]) == [*made]
    kept = nbformat.read(path, as_version=4)
    assert "# Doubling a number" in kept.cells[0].source
    assert [output.text for cell in filter(is_code, kept.cells) for output in cell.outputs] == ["done\n"]
    source.write_text(text.replace("half = 1 / 2", "half = 2 / 4", 1), encoding="utf-8")
    assert not build.keep_outputs(path, build.editions(source, path.parents[1])[path])


def with_an_output(notebook: nbformat.NotebookNode) -> str:
    """A notebook whose first cell of code has printed something."""
    cell = next(filter(is_code, notebook.cells))
    cell.outputs, cell.execution_count = [nbformat.v4.new_output("stream", text="done\n")], 1
    return str(nbformat.writes(notebook))


def test_check_names_what_is_not_current(source: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Missing, edited and left-over notebooks are named, and old pictures of sliders; only solutions have outputs."""
    root = source.parents[4]
    made = build.editions(source, root / "notebooks")
    student, solution, teacher = made
    for path in (student, solution):
        path.parent.mkdir(exist_ok=True)
        path.write_text(with_an_output(made[path]), encoding="utf-8")
    (root / "notebooks" / "00_gone.ipynb").touch()
    (root / "notebooks" / ".ipynb_checkpoints").mkdir()
    (root / "notebooks" / ".ipynb_checkpoints" / "01_doubling-checkpoint.ipynb").touch()
    book = Flipbook("draw", "of another cell", [], {}, [1, 1])
    (folder := root / "notebooks" / "flipbooks" / "01_doubling").mkdir(parents=True)
    (folder / "draw.json").write_text(json.dumps(book._asdict()), encoding="utf-8")
    assert build.main(["--check"], root) == 1
    *named, turned = [line.rpartition(": ")[2] for line in capsys.readouterr().err.splitlines()]
    assert turned == "notebooks/flipbooks/01_doubling/draw.json; python lessons/build.py --flipbooks 01_doubling"
    assert named == [str(path.relative_to(root)) for path in (root / "notebooks/00_gone.ipynb", student, teacher)]
    source.write_text(LESSON.replace("1 + 1", "1 + 2"), encoding="utf-8")
    assert not build.is_current(solution, build.editions(source, root / "notebooks")[solution])


def test_the_command_line_names_lessons_and_problems(source: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """An unknown lesson, a broken rule and a notebook too large for GitHub are named, and nothing is written."""
    root = source.parents[4]
    with pytest.raises(SystemExit):
        build.main(["02_tripling"], root)
    assert "no lesson 02_tripling; there are: 01_doubling" in capsys.readouterr().err
    source.write_text(LESSON.replace("## The idea", "## An idea"), encoding="utf-8")
    assert build.main([], root) == 1
    assert "01_doubling.py: the headings must begin so" in capsys.readouterr().err
    assert not (root / "notebooks").exists()
    notebook = new_notebook(cells=[new_code_cell("x = '" + "x" * build.SIZE_LIMIT + "'")])
    with pytest.raises(build.LessonError, match=r"large: the notebook has 2,000,\d\d\d bytes"):
        build.to_text(notebook, "large")


@pytest.mark.slow
def test_an_unsolved_notebook_runs_to_its_end(source: Path) -> None:
    """Checks say what is missing, nothing else fails; a demonstration that needs a solution is an error."""
    student = all_editions(source)["student"]
    build.execute(student, "01_doubling")
    said = [o.evalue for cell in filter(is_code, student.cells) for o in cell.outputs if o.output_type == "error"]
    assert said == ["not solved yet: replace this line", "factor = 1 does not double"]
    source.write_text(LESSON.replace("# Choose a", "# %%\ndouble(1)\n\n# %% [markdown]\n# Choose a"), encoding="utf-8")
    with pytest.raises(build.LessonError, match=r"cell-023 \('double\(1\)'\): NotImplementedError"):
        build.execute(all_editions(source)["student"], "01_doubling")
