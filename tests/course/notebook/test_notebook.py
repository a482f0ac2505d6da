"""What lessons use in notebooks: buttons, films and listings by code, and all of it in a kernel."""

import inspect
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
import rules
from lesson_client import LessonClient
from nbclient.output_widget import OutputWidget
from nbformat import NotebookNode
from nbformat.v4 import new_code_cell, new_notebook

from edugym.adapters.playing import Game, play_episode
from edugym.adapters.registration import make_mdp
from edugym.agents.q_learning import QLearning
from edugym.agents.tables import greedy_action
from edugym.rendering.scene import Scene
from edugym_course.notebook import frames, play, source
from edugym_course.notebook.film import side_by_side
from edugym_course.notebook.widget import WIDGET
from tests.course.notebook.widgets import texts
from tests.messages import named


def test_playing_with_buttons() -> None:
    """Each button takes its step, the end of an episode leaves only a new one, and the history remembers."""
    panel = play("Golf", seed=1, stochasticity_level=0.0)
    assert [button.description for button in panel.actions.values()] == ["putt", "chip", "drive"]
    picture, line, history = texts(panel.widget)
    assert picture.startswith("<svg ")
    assert (line, history) == ("start, observation 3 0, total 0", "No episode finished yet.")
    panel.actions["drive"].click()
    assert texts(panel.widget)[0] != picture
    assert texts(panel.widget)[1] == "step 1: drive, observation 3 10, reward 0, total 0"
    assert not any(button.disabled for button in panel.actions.values())
    panel.actions["chip"].click()
    assert texts(panel.widget)[1:] == [
        "step 2: chip, observation 3 14, reward 0.9, total 0.9<br>Terminated: the task itself has ended.",
        "Episodes finished: 1. Totals: 0.9. Mean: 0.9.",
    ]
    assert all(button.disabled for button in panel.actions.values())
    assert panel.new_episode.button_style == "primary"
    panel.new_episode.click()
    assert texts(panel.widget)[1] == line
    assert not any(button.disabled for button in panel.actions.values())
    assert panel.new_episode.button_style == ""


def test_playing_blind() -> None:
    """The picture comes with the end of the episode, and goes with the next one; the observation is always there."""
    panel = play("Boulder", height=1, blind=True)
    game: Any = panel.game.environment.unwrapped
    right = int(game.mdp.grips[0])
    picture, line, _ = texts(panel.widget)
    assert "<svg" not in picture
    assert "observation 0" in line
    assert "<svg" not in panel.still()["text/html"]
    panel.step(1 - right)
    assert "<svg" not in texts(panel.widget)[0]
    panel.step(right)
    assert "<svg" in texts(panel.widget)[0]
    assert "image/svg+xml" in panel.still()
    panel.reset()
    assert "<svg" not in texts(panel.widget)[0]
    no_boolean: Any = "yes"
    with pytest.raises(ValueError, match=named("blind", True, False, "'yes'")):
        play("Boulder", blind=no_boolean)


def test_what_stands_where_no_kernel_runs() -> None:
    """Beside the widget the notebook stores a picture with the score, whatever the environment draws."""
    panel = play("Boulder", height=3)
    panel.actions["grip 1"].click()
    bundle = panel._repr_mimebundle_()
    assert bundle[WIDGET] == {"version_major": 2, "version_minor": 0, "model_id": panel.widget.model_id}
    assert "step 1: grip 1" in "".join(ElementTree.fromstring(bundle["image/svg+xml"]).itertext())
    assert " at 0x" not in bundle["text/plain"]
    pixels = play("CliffWalking-v1").still()["text/html"]
    assert 'src="data:image/png;base64,' in pixels
    assert pixels.endswith("start, observation 36, total 0")
    characters = play(Game("CliffWalking-v1", picture="ansi")).still()["text/html"]
    assert "<pre>" in characters
    assert "\x1b" not in characters


def test_a_film_of_an_agent() -> None:
    """The slider shows each step, at most 200 unless told otherwise, and the player is tied to it."""
    agent = QLearning.create(make_mdp("Golf"))
    agent.Q[:, 1] = 1.0
    film = frames("Golf", agent, stochasticity_level=0.0, frames_per_second=5)
    assert (film.slider.description, film.slider.min, film.slider.max) == ("step", 0, 3)
    assert (film.player.min, film.player.max, film.player.interval) == (0, 3, 200)
    assert (film._link.source, film._link.target) == ((film.player, "value"), (film.slider, "value"))
    assert texts(film.widget)[1] == "start, observation 3 0, total 0"
    seen = {texts(film.widget)[0]}
    for step in (1, 2, 3):
        film.slider.value = step
        assert texts(film.widget)[1].startswith(f"step {step}: chip, observation 3 {4 * step}")
        seen.add(texts(film.widget)[0])
    assert len(seen) == 4
    assert frames("Golf", agent, frames_per_second=0.1).player.interval == 10_000  # milliseconds
    fails: dict[str, Any] = {"actor": lambda state: 1, "height": 30}
    assert len(frames("Boulder", **fails).frames) == len(play_episode("Boulder", **fails)) == 201
    assert len(frames("Boulder", **fails, max_steps=3).frames) == 4
    with pytest.raises(ValueError, match=named("frames_per_second", 0)):
        frames("Golf", agent, frames_per_second=0)


def test_a_film_without_its_widget() -> None:
    """A few frames side by side, the first and the last among them; the film itself stays out of the page."""
    still = ElementTree.fromstring(frames("Boulder", lambda state: 0, max_steps=50).still()["image/svg+xml"])
    inner = still.findall("{http://www.w3.org/2000/svg}svg")
    first, _, _, last = ("".join(picture.itertext()) for picture in inner)
    assert "start" in first
    assert "step 50" in last
    lefts, widths = ([float(picture.get(name, "")) for picture in inner] for name in ("x", "width"))
    assert lefts == [0, *np.cumsum(widths)[:-1]]
    assert still.get("viewBox") == f"0 0 {sum(widths):.0f} {inner[0].get('height')}"
    page: Any = ElementTree.fromstring(side_by_side([Scene(20, 10, ()), Scene(10, 20, ())]))
    assert page.attrib["viewBox"] == "0 0 720 480"  # as high as the highest
    assert len(ElementTree.fromstring(frames("Boulder", [0]).still()["image/svg+xml"])) == 2
    assert frames("CliffWalking-v1", [0, 0]).still()["text/html"].count("<img ") == 3


def test_listings_are_the_code_that_runs() -> None:
    """Of a class, of a method by itself or by its name, of properties, class methods, functions and values' classes."""
    file = Path(inspect.getfile(QLearning)).read_text(encoding="utf-8")
    learn = source(QLearning, "learn")
    assert learn.module == "edugym.agents.q_learning"
    assert learn.code.startswith("def learn(self")
    assert all(line.strip() in file for line in learn.code.splitlines())
    assert source(QLearning.learn) == learn
    assert source(QLearning.create((2, 2)), "learn") == learn
    assert source(QLearning).code in file
    both = source(QLearning, "act", "create").code
    assert both.index("def act(") < both.index("\n\n@classmethod\ndef create(")
    assert source(type(make_mdp("Golf")), "action_space").code.startswith("@property\ndef action_space(self)")
    assert source(greedy_action).code.startswith("def greedy_action(")
    assert repr(learn) == learn.code
    assert learn._repr_markdown_() == f"From `edugym.agents.q_learning`:\n\n```python\n{learn.code}\n```"
    with pytest.raises(ValueError, match="'unlearn' is none"):
        source(QLearning, "unlearn")
    with pytest.raises(ValueError, match="has none here"):
        source(dict)


CELLS = [
    """
import matplotlib.pyplot as plt
from edugym_course.notebook import play, sliders

def curve(slope=1.0):
    figure, axes = plt.subplots()
    axes.plot([0, slope])
    print("the slope is", slope)
    return axes


def broken(x=1):
    if x == 3:
        raise RuntimeError("three is too much")
    return "well"
""",
    "game = play('Golf', stochasticity_level=0.0)\ngame.actions['drive'].click()\ngame",
    "panel = sliders(curve, slope=(0.0, 2.0))\npanel.controls['slope'].value = 2.0\npanel",
    "failing = sliders(broken, x=(1, 5))\nfailing.controls['x'].value = 3\nfailing.controls['x'].value = 4\nfailing",
    "failing.controls['x'].value = 3",
    "game.step('chip')\ngame.actions['chip'].click()",
]


def test_widgets_in_a_kernel(monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing is shown twice; prints and errors of callbacks go into the widget, and stay there until the next call.

    A callback that says nothing changes no output widget, so that nbclient sends no answer, which could hide a reply.
    """
    notebook = new_notebook(cells=[new_code_cell(source) for source in CELLS])
    client = LessonClient(notebook, timeout=60, kernel_name="python3", extra_arguments=["--log-level=ERROR"])
    send, answered = OutputWidget.send, set()

    def noted(self: OutputWidget, *what: Any) -> None:
        answered.add(client.running)
        send(self, *what)

    monkeypatch.setattr(OutputWidget, "send", noted)
    faults = client.run()
    assert answered == {rules.where(cell) for cell in notebook.cells[2:]}
    for fault, said in zip(faults, ["three is too much", "three is too much", "call reset() to"], strict=True):
        assert said in fault
    _, played, explored, failed, *last = notebook.cells

    [output] = played.outputs
    assert "step 1: drive" in output.data["image/svg+xml"]
    printed, result = explored.outputs
    assert printed.text == "the slope is 1.0\n"  # by the first call, in the cell; the second printed into the widget
    assert set(result.data) == {WIDGET, "text/plain", "image/png"}
    assert [set(output.data) for output in failed.outputs] == [{WIDGET, "text/plain", "text/html"}]
    assert [cell.outputs for cell in last] == [[], []]

    messages = [messages_of(notebook, cell.outputs[-1].data[WIDGET]["model_id"]) for cell in (played, explored, failed)]
    assert [[output["output_type"] for output in outputs] for outputs in messages] == [["error"], ["stream"], ["error"]]
    assert "call reset() to start an episode" in messages[0][0]["evalue"]
    assert messages[1][0]["text"] == "the slope is 2.0\n"
    assert messages[2][0]["evalue"] == "three is too much"


def messages_of(notebook: NotebookNode, model_id: str) -> Any:
    """What the output widget at the end of a panel shows."""
    states = notebook.metadata.widgets["application/vnd.jupyter.widget-state+json"]["state"]
    last = states[model_id]["state"]["children"][-1].removeprefix("IPY_MODEL_")
    return states[last]["state"]["outputs"]
