"""Where the parts of widgets stand."""

from typing import Any
from xml.etree import ElementTree

import ipywidgets

from edugym.rendering.scene import Scene
from edugym_course.notebook import frames, play, predict
from edugym_course.notebook.film import side_by_side
from edugym_course.notebook.widget import WIDGET


def test_the_question_stands_above_its_field() -> None:
    """Both over the whole width, whether a number is typed or an option chosen."""
    for prediction in (predict("How high?", unit="grips"), predict("Which?", ["one", "two"])):
        question, field, *_ = prediction.widget.children
        assert prediction.question in question.value
        assert field.layout.width == "auto"
        assert field.value in ("", None)


def test_many_buttons_begin_a_new_row() -> None:
    """Beside the picture, if there is room; each is as wide as its text, which it shows also when it is cut off."""
    panel = play("Golf")
    picture, controls = panel.widget.children[0].children
    buttons, again, line, history = controls.children
    assert isinstance(picture, ipywidgets.HTML)
    assert buttons.children == tuple(panel.actions.values())
    assert again is panel.new_episode
    assert (line.value[:5], history.value[:2]) == ("start", "No")
    for box in (panel.widget.children[0], buttons):
        assert (box.layout.flex_flow, box.layout.width) == ("row wrap", "auto")
    assert [(button.tooltip, button.layout.width) for button in buttons.children] == [
        (name, "auto") for name in panel.actions
    ]
    assert {button.layout.min_width for button in buttons.children} == {"148px"}
    assert (again.description, controls.layout.width) == ("New episode", "360px")


def test_pictures_of_different_heights_side_by_side() -> None:
    """From left to right, in a frame as high as the highest."""
    pictures = [Scene(20, 10, ()), Scene(10, 20, ())]
    page: Any = ElementTree.fromstring(side_by_side(pictures))
    assert page.attrib["viewBox"] == "0 0 720 480"
    assert [part.attrib["x"] for part in page] == ["0", "480"]


def test_a_film_of_no_step() -> None:
    """Is one picture."""
    film = frames("Golf", [])
    assert film.still()["image/svg+xml"].count("<svg") == 2


def test_the_slider_of_a_film_stands_above_its_picture() -> None:
    """Beside the button that plays it; what happened stands below."""
    film = frames("Golf", [])
    controls, picture, line, _ = film.widget.children
    assert controls.children == (film.player, film.slider)
    assert (picture.value[:4], line.value[:5]) == ("<svg", "start")


def test_what_jupyter_is_told() -> None:
    """By which version of its protocol the widget is shown; with another one nothing would be."""
    panel = play("Golf")
    view = panel._repr_mimebundle_()[WIDGET]
    assert view == {"version_major": 2, "version_minor": 0, "model_id": panel.widget.model_id}
