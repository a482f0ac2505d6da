"""The survey: the three statements at the end of every lesson, answered on a page that sends nothing anywhere."""

import re

from lesson_pages import Lesson

ANSWERS = ("strongly disagree", "disagree", "neither", "agree", "strongly agree")


def statements(lessons: list[Lesson]) -> list[str]:
    """Return the statements as the lessons have them, without marks of Markdown."""
    closing = lessons[0].text.partition("### Before you go")[2]
    return [line.replace("*", "") for line in re.findall(r"^- (.*)$", closing, re.MULTILINE)]


def form(lessons: list[Lesson]) -> str:
    """Return the form, in HTML."""
    choices = "".join(f'<option value="{lesson.name}">{lesson.title}</option>' for lesson in lessons)
    questions = "".join(
        f"<fieldset><legend>{statement}</legend>"
        + "".join(
            f'<label><input type="radio" name="s{number}" value="{answer}"> {answer}</label>' for answer in ANSWERS
        )
        + "</fieldset>"
        for number, statement in enumerate(statements(lessons), 1)
    )
    return (
        f'<form id="survey"><p><label>Lesson <select name="lesson"><option value="">all</option>'
        f"{choices}</select></label></p>"
        f"{questions}"
        '<p><label>Remarks<br><textarea name="remarks" rows="4" cols="50"></textarea></label></p>'
        '<p><button type="submit">Save my answers as a file</button> <button type="button" id="survey-link">'
        'Make a link of my answers</button></p><p id="survey-says" role="status"></p></form>'
    )
