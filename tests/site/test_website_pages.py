"""What the website is made from: links, docstrings, lessons without solutions, formulas, public names, the survey."""

import json
import re
import subprocess
import sys
from typing import Any
from xml.etree import ElementTree

import agent_pages
import docstrings
import groups
import guides
import lesson_pages
import previews
import projected_pages
import pytest
import reference_pages
import repository
import slider_views
import survey
from races import RACES
from repository import ROOT

import edugym
from edugym.adapters.registration import find, in_course_order
from edugym_course import agent_profiles
from edugym_course.lab.records import number_of
from edugym_course.notebook.widget import WITHOUT_KERNEL

FILM = re.compile(r'(<div class="film">.*?)<script type="application/json">(.*?)</script>\n</div>', re.DOTALL)
FLIPBOOK = re.compile(r'<div class="flipbook".*?</p>\n</div>', re.DOTALL)


@pytest.fixture(scope="module")
def lessons() -> list[lesson_pages.Lesson]:
    """All lessons as pages."""
    return lesson_pages.lessons()


@pytest.mark.parametrize(
    ("link", "leads_to"),
    [
        ("notation.md", "notation.md"),
        ("environments/boulder.md#reward", "../environments/boulder.md#reward"),
        ("../notebooks/01_exploration.ipynb", "../lessons/01_exploration.md"),
        ("../README.md", "../index.md"),
        ("environments/boulder.svg", "../pictures/boulder.svg"),
        ("../LICENSE", "license.md"),
        ("../Makefile", f"{repository.REPOSITORY}/blob/main/Makefile"),
        ("../src/edugym/agents", f"{repository.REPOSITORY}/tree/main/src/edugym/agents"),
        (f"{repository.REPOSITORY}/blob/main/docs/notation.md", "notation.md"),
        ("https://arxiv.org/abs/2311.10590", "https://arxiv.org/abs/2311.10590"),
        ("#below", "#below"),
    ],
)
def test_links_lead_to_pages_or_to_the_repository(link: str, leads_to: str) -> None:
    """A link to a file that is a page leads to the page, any other to the repository, and none changes in code."""
    text = f"[here]({link}) and `[here]({link})`"
    assert (
        repository.with_links(text, "docs/teaching.md", "guides/teaching") == f"[here]({leads_to}) and `[here]({link})`"
    )


def test_links_of_a_release_lead_to_its_own_code(monkeypatch: pytest.MonkeyPatch) -> None:
    """To the tag in `EDUGYM_REF`, from guides, agents and lessons alike."""
    code = """if True:
        import agent_pages, edugym, lesson_pages, repository
        print(repository.with_links("[a](../Makefile)", "docs/teaching.md", "guides/teaching"))
        print(agent_pages.page("QLearning", edugym.QLearning, []))
        print(lesson_pages.lesson(repository.ROOT / "notebooks" / "00_loop.ipynb").text)"""
    monkeypatch.setenv("EDUGYM_REF", "v9.8.7")
    command = [sys.executable, "-c", code]
    done = subprocess.run(command, cwd=ROOT / "site", capture_output=True, text=True, check=True)
    assert "/main/" not in done.stdout
    assert len(set(re.findall(r"/v9\.8\.7/(\w+)", done.stdout))) == 3


def test_a_link_to_nothing_is_an_error() -> None:
    """The message names the file and the link."""
    with pytest.raises(ValueError, match=r"docs/teaching\.md.*nowhere\.md"):
        repository.with_links("[there](nowhere.md)", "docs/teaching.md", "guides/teaching")


def test_sections_come_from_other_files() -> None:
    """A mark becomes the section, without what follows it; a heading that is not there is an error."""
    text = repository.with_sections("<!-- section: README.md # Install and open the lessons -->", "index")
    assert "make lab" in text
    assert "(lessons/00_loop.md)" in text
    assert "Ten lines" not in text
    with pytest.raises(ValueError, match="Three commands"):
        repository.section("README.md", "Three commands")


@pytest.mark.parametrize("change", [{"guides/new": "# New"}, {"guides/license": None}])
def test_every_guide_is_in_one_group(change: dict[str, str | None]) -> None:
    """The list has each once; one that is in no group, and a group's that is not there, are errors."""
    texts = {page: f"# The title of {page}" for page in [*guides.ORDER, "index"]}
    assert re.findall(r"\[.*?\]\(/(.*?)\.md\)", guides.index(texts)) == guides.ORDER
    [name] = change
    with pytest.raises(ValueError, match=name):
        guides.index({page: text for page, text in {**texts, **change}.items() if text})


def test_docstrings_become_markdown() -> None:
    """Google's sections become lists; a list item is one line."""

    def example() -> None:
        """Do it.

            a <- b

        Args:
            first: what comes
                first.
            **others: more.

        Raises:
            ValueError: never.
        """

    assert docstrings.markdown(example) == (
        "Do it.\n\n    a <- b\n\n**Arguments**\n\n- `first`: what comes first.\n- `**others`: more.\n\n"
        "**Raises**\n\n- `ValueError`: never."
    )


def test_every_public_name_is_described() -> None:
    """Each name of the one list is on a page of the reference or, an agent or environment, on its own, in our words."""
    pages = "\n".join([*reference_pages.pages().values(), *agent_pages.pages([]).values()])
    described = re.findall(r"^:+\{py:(?:class|function|data)\} (\w+)", pages, re.MULTILINE)
    described += [e.name for e in in_course_order() if (ROOT / f"docs/environments/{e.name.lower()}.md").exists()]
    assert sorted(described) == sorted(name.name for name in reference_pages.public_names())
    assert (tuple.__doc__ or "").partition("\n")[0] not in pages


def test_lessons_show_no_solutions(lessons: list[lesson_pages.Lesson]) -> None:
    """Nothing that the executed edition has and the students' has not is on the page, nor what a check said."""
    for lesson in lessons:
        student, solved = (_cells(f"{folder}{lesson.name}.ipynb") for folder in ("", "solutions/"))
        changed = [name for name, cell in student.items() if cell["source"] != solved[name]["source"]]
        assert changed, "a lesson has exercises"
        checks = [name for name, cell in student.items() if "check" in cell["metadata"].get("tags", [])]
        known = {line for cell in student.values() for line in _lines(cell["source"])}
        known |= {*re.findall(r"`([^`\n]+)`", (ROOT / f"notebooks/{lesson.name}.ipynb").read_text(encoding="utf-8"))}
        outputs_and_hints = r"^::::\{container\} output\n.*?\n::::$|^<details><summary>Hint.*?</details>"
        code = re.sub(outputs_and_hints, "", lesson.text, flags=re.MULTILINE | re.DOTALL)
        for name in changed + checks:
            assert not [line for line in _lines(solved[name]["source"]) if line not in known and line in code]
            said = [line for output in solved[name]["outputs"] for line in _lines(output.get("text", []))]
            assert not [line for line in said if line in lesson.text]
            assert not any(f"{lesson.name}-{name}-" in path for path in lesson.figures)


def _cells(name: str) -> dict[str, Any]:
    cells = json.loads((ROOT / "notebooks" / name).read_text(encoding="utf-8"))["cells"]
    return {cell["id"]: cell for cell in cells if cell["cell_type"] == "code"}


def _lines(source: list[str]) -> list[str]:
    return [line.strip() for line in source if len(line.strip()) > 20]


def test_lessons_ask_before_they_show(lessons: list[lesson_pages.Lesson]) -> None:
    """Every prediction is a question, and every measurement that answers one is folded; pictures have a text."""
    for lesson in lessons:
        made = len(re.findall(r"^\w+\.measured\(", lesson.text, re.MULTILINE))
        folded = len(re.findall(r'<details class="measured">(?:(?!</details>).)*Measured: ', lesson.text, re.DOTALL))
        assert lesson.text.count('<fieldset class="prediction">') >= folded > 0
        assert made >= folded
        assert "You made no prediction" not in lesson.text
        for asked, ways in re.findall(r"Your prediction\. (.*?)</legend>(.*?)</fieldset>", lesson.text, re.DOTALL):
            assert " " in asked
            assert "<br>" not in asked
            assert ways.count('type="radio"') > 1 or ways.count('type="text"') == 1
        assert WITHOUT_KERNEL not in lesson.text
        pictures = re.findall(r"!\[(.*?)\]\((figures/.*?)\)", lesson.text)
        assert {f"lessons/{path}" for _, path in pictures} == lesson.figures.keys()
        assert all(len(alternative) > 10 for alternative, _ in pictures)


def test_asides_are_folded_and_are_not_projected(lessons: list[lesson_pages.Lesson]) -> None:
    """A fold opens below the heading of each aside and holds no other heading; what is projected has none of it."""
    aside = re.compile(
        rf"^### Aside, [^\n]*\n\n{re.escape(lesson_pages.FOLD)}\n(.*?)\n{re.escape(lesson_pages.FOLD_ENDS)}$",
        re.M | re.S,
    )
    folded = {lesson.name: aside.findall(lesson.text) for lesson in lessons}
    assert {lesson.name: lesson.text.count("\n### Aside") for lesson in lessons} == {
        name: len(found) for name, found in folded.items()
    }
    assert sum(map(len, folded.values())) > 0
    assert not [name for name, found in folded.items() if re.search(r"^#{2,6} ", "".join(found), re.MULTILINE)]
    projected = projected_pages.pages(lessons)
    for name, found in folded.items():
        questions = [question for inside in found for question in re.findall(r"<legend>.*?</legend>", inside)]
        assert not [question for question in questions if question in projected[f"project/{name}"]]
        assert "Aside" not in projected[f"project/{name}"]


def test_a_lesson_has_the_race_of_its_environment(lessons: list[lesson_pages.Lesson]) -> None:
    """Once, below its first sliders, and its code on top; lessons whose environment has no race have none."""
    for lesson in lessons:
        raced = [race.environment for race in RACES if find(race.environment).lesson == number_of(lesson.name)]
        _, *found = lesson.text.split('<details class="live">')
        assert [re.findall("#task=([A-Za-z]+)", part)[0] for part in found] == raced, lesson.name
        assert "sliders(" in lesson.text.split('<details class="live">')[0]
        assert re.findall(r"#task=(\w+)&amp;code=true", lesson.text) == raced


def test_sliders_turn_pictures(lessons: list[lesson_pages.Lesson], monkeypatch: pytest.MonkeyPatch) -> None:
    """Each has a value and a text for every picture, all of one size, and begins with the picture of its default.

    Pictures of a cell that has changed are not shown: its first picture is.
    """
    n_books = 0
    for lesson in lessons:
        assert "release it" not in lesson.text  # nothing is computed on the page
        books = slider_views.views(lesson.name)
        shown = [ElementTree.fromstring(view) for view in FLIPBOOK.findall(lesson.text)]
        n_books += len(shown)
        assert len(shown) == len(books), lesson.name
        for view in shown:
            picture, turns = view.find(".//img"), view.findall("div[@class='turn']")
            assert picture is not None
            for turn in turns:
                pictures = json.loads(turn.attrib["data-pictures"])
                slider = turn.find("input")
                assert slider is not None
                assert [slider.get("min"), slider.get("max")] == ["0", str(len(pictures) - 1)]
                value, file, alternative = pictures[int(slider.attrib["value"])]
                assert value == slider.get("aria-valuetext")
                if turn is turns[0]:
                    assert [file, alternative] == [picture.get("src"), picture.get("alt")]
                assert len({alternative for _, _, alternative in pictures}) == len(pictures)
                for _, path, _ in pictures:
                    assert (ROOT / path.removeprefix("../")).exists()
            [book] = [one for one in books.values() if f"/{one.function}-" in picture.attrib["src"]]
            assert len(turns) == len(book.turns)
            differ = book.axes_differ or any(turn.axes_differ for turn in book.turns)
            assert ("axes change" in "".join(view.itertext())) == differ
            folder = slider_views.FOLDER / lesson.name
            assert differ or len({(folder / turn.files[turn.start]).read_bytes() for turn in book.turns}) == 1
    assert n_books > 0
    monkeypatch.setattr(slider_views, "views", lambda lesson: {})
    without = lesson_pages.lesson(ROOT / "notebooks" / "00_loop.ipynb")
    assert "flipbook" not in without.text
    assert without.text.count("the controls at their first settings") > 0


def test_episodes_are_films(lessons: list[lesson_pages.Lesson]) -> None:
    """Each begins with its first frame and has a text for every frame; only games to play need a kernel."""
    n_films = 0
    for lesson in lessons:
        for drawn, frames in FILM.findall(lesson.text):
            n_films += 1
            view, told = ElementTree.fromstring(f"{drawn}</div>"), json.loads(frames)
            slider, picture = view.find(".//input"), view.find("div[@class='picture']")
            assert slider is not None
            assert picture is not None
            assert int(slider.attrib["max"]) == len(told["frames"]) - 1 == len(told["says"]) - 1
            assert picture.attrib["aria-label"] == told["says"][0]
            first = "\n".join(line for start, end in told["frames"][0] for line in told["lines"][start:end])
            assert ElementTree.tostring(picture[0]).strip() == ElementTree.tostring(ElementTree.fromstring(first))
            assert all(0 <= start < end <= len(told["lines"]) for frame in told["frames"] for start, end in frame)
        for part in lesson.text.split("```python\n"):
            assert lesson_pages.LIVE not in part or re.search(r"^play\(", part, re.MULTILINE), (lesson.name, part)
    assert n_films > 0


def test_formulas_become_mathml_and_their_signs_are_in_the_font(lessons: list[lesson_pages.Lesson]) -> None:
    """No formula has a command that the converter leaves as it is, nor a sign that the font lacks."""
    pytest.importorskip("latex2mathml")
    pytest.importorskip("ziamath")
    mathematics = pytest.importorskip("mathematics")
    text = "\n".join(
        [*(lesson.text for lesson in lessons), (ROOT / "docs" / "notation.md").read_text(encoding="utf-8")]
    )
    formulas = set(re.findall(r"\$\$(.+?)\$\$", text, re.DOTALL)) | set(
        re.findall(r"(?<!\$)\$([^$`\n]+)\$(?!\$)", text)
    )
    assert len(formulas) > 100
    written = "".join(mathematics.mathml(formula) for formula in formulas)
    signs = {int(code, 16) for code in re.findall(r"&#x([0-9A-F]+);", written)}
    assert signs - {0xA0, 0x2009} <= set(mathematics.CHARACTERS)
    with pytest.raises(ValueError, match="unheard"):
        mathematics.mathml(r"\unheard{x}")


def test_headings_of_the_sidebar_have_their_pages(lessons: list[lesson_pages.Lesson]) -> None:
    """Each agent is below one; each heading stands before a page that is there."""
    named = [name for names in groups.AGENT_GROUPS.values() for name in names]
    assert sorted(named) == sorted(agent_pages.AGENTS), "name each agent once in site/groups.py"
    there = {f"{folder}/{lesson.name}" for folder in ("lessons", "project") for lesson in lessons}
    there |= {f"environments/{entry.name.lower()}" for entry in in_course_order()}
    assert groups.FIRST.keys() <= there | {*guides.ORDER, *groups.ORDER}


def test_the_survey_has_the_statements_of_the_lessons(lessons: list[lesson_pages.Lesson]) -> None:
    """The paper's three statements, from the lessons' own text."""
    found = survey.statements(lessons)
    assert len(found) == 3
    assert all("EduGym" in statement for statement in found)
    form = survey.form(lessons)
    assert form.count('type="radio"') == 3 * len(survey.ANSWERS)
    assert all(f">{statement}<" in form for statement in found)
    assert "action=" not in form


def test_an_agents_page_has_equation_code_lessons_and_profile(lessons: list[lesson_pages.Lesson]) -> None:
    """The page shows what runs, with what it calls; and its ladders, or why there is none."""
    page = agent_pages.page("QLearning", edugym.QLearning, lessons)
    for part in ("max_a Q(S', a)", "def learn(", "def one_step_target(", "lessons/01_exploration.md"):
        assert part in page
    profile = agent_profiles.load()
    assert profile is not None
    for challenge in profile.challenges:
        sentence = page.split(f"**[{challenge}](")[1].partition(":::")[0]
        assert ("<svg" in sentence) == (profile.score("QLearning", challenge).n > 0)
    assert "a table needs the actions 0, 1" in page
    assert "No agent is good here." in page  # in MemoryCorridor, where the highest score is 0.39
    assert "MemoryCorridor" not in page.split("### When to take it")[1].partition("### Its ladders")[0]
    assert "Catch</a>, where it is called “Q(λ), places”. There it gets other observations" in agent_pages.page(
        "QLambda", edugym.QLambda, lessons
    )
    sarsa_lambda = agent_pages.page("SARSALambda", edugym.SARSALambda, lessons)
    assert "lessons/03_depth.md" in sarsa_lambda
    assert "Study</a>, where it is called “SARSA(λ)”" in sarsa_lambda
    for name in agent_profiles.agents():
        assert f"{agent_pages.NO_RACE}\n" not in agent_pages.page(name, getattr(edugym, name), lessons), name
    sarsa = agent_pages.page("SARSA", edugym.SARSA, lessons)
    assert re.search(
        r"the one for the challenge of Roadrunner.*differs from that of QLearning.*saves", sarsa, re.DOTALL
    )
    for picture in re.findall(r"<svg.*</svg>", page):
        seen = ElementTree.fromstring(picture)
        own, *others = (line.attrib for line in reversed(seen.findall("polyline")))
        assert len(own["points"].split()) == len(seen.findall("circle"))
        assert len(others) > 10
        assert {line["class"] for line in others} == {"other"}


@pytest.mark.parametrize(("place", "pictures"), [("", 0), ("https://example.org/course", 1)])
def test_a_preview_has_a_picture_where_the_address_is_known(
    place: str, pictures: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Only a whole address can name one; what a page says of itself is text, whatever signs it has."""
    monkeypatch.setattr(previews, "ADDRESS", place)
    tags = previews.tags('Q & "A"', "a < b")
    assert tags.count("og:image") == tags.count(f"{place}/{previews.PICTURE}") == pictures
    assert 'content="Q &amp; &quot;A&quot;"' in tags
    assert tags.count("a &lt; b") == 2
