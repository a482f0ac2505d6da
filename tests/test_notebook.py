"""What lessons use in notebooks: buttons, sliders, films and listings, by code and in a kernel."""

import base64
import inspect
import io
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import ipywidgets
import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import pytest
from matplotlib.figure import Figure
from nbclient import NotebookClient
from nbformat import NotebookNode
from nbformat.v4 import new_code_cell, new_notebook
from PIL import Image

from edugym.agents.exploration import greedy_action
from edugym.agents.q_learning import QLearning
from edugym.notebook import explore, frames, play, source
from edugym.notebook.panel import WIDGET
from edugym.notebook.sliders import call
from edugym.playing import Game
from edugym.registration import make_mdp
from edugym.rendering.scene import Circle, Scene


@pytest.fixture(autouse=True)
def no_figure_left() -> Iterator[None]:
    """Every test must leave as many figures open as it opened itself: none."""
    plt.switch_backend("agg")
    yield
    assert plt.get_fignums() == []


def texts(widget: Any) -> list[str]:
    """What the HTML widgets inside a widget say, from top to bottom."""
    if isinstance(widget, ipywidgets.HTML):
        return [str(widget.value)]
    return [text for child in getattr(widget, "children", ()) for text in texts(child)]


def test_playing_with_buttons() -> None:
    """Each button takes its step, the end of an episode leaves only a new one, and the history remembers."""
    panel = play("Golf", seed=1, stochasticity_level=0.0)
    assert [button.description for button in panel.actions.values()] == ["putt", "chip", "drive"]
    picture, line, history = texts(panel.widget)
    assert picture.startswith("<svg ")
    assert (line, history) == ("start, observation 3 0, return 0", "No episode finished yet.")
    panel.actions["drive"].click()
    assert texts(panel.widget)[0] != picture
    assert texts(panel.widget)[1] == "step 1: drive, observation 3 10, reward 0, return 0"
    assert not any(button.disabled for button in panel.actions.values())
    panel.actions["chip"].click()
    assert texts(panel.widget)[1:] == [
        "step 2: chip, observation 3 14, reward 0.9, return 0.9<br>Terminated: the task itself has ended.",
        "Episodes finished: 1. Returns: 0.9. Mean: 0.9.",
    ]
    assert all(button.disabled for button in panel.actions.values())
    assert panel.new_episode.button_style == "primary"
    panel.new_episode.click()
    assert texts(panel.widget)[1] == line
    assert not any(button.disabled for button in panel.actions.values())
    assert panel.new_episode.button_style == ""


def test_playing_without_the_widget() -> None:
    """A game can be played by code, before it gets its buttons and after."""
    game = Game("Boulder", height=3)
    game.step("grip 0")
    panel = play(game)
    assert panel.game is game
    assert texts(panel.widget)[1].startswith("step 1: grip 0")
    panel.step(1)
    assert texts(panel.widget)[1].startswith("step 2: grip 1")
    panel.reset()
    assert texts(panel.widget)[1].startswith("start")
    with pytest.raises(ValueError, match="action must be one of 'grip 0', 'grip 1', but is 'grip 2'"):
        panel.step("grip 2")


def test_what_stands_where_no_kernel_runs() -> None:
    """Beside the widget the notebook stores a picture with the score, whatever the environment draws."""
    panel = play("Boulder", height=3)
    panel.actions["grip 1"].click()
    bundle = panel._repr_mimebundle_()
    assert bundle[WIDGET]["model_id"] == panel.widget.model_id
    assert "step 1: grip 1" in "".join(ElementTree.fromstring(bundle["image/svg+xml"]).itertext())
    assert " at 0x" not in bundle["text/plain"]
    pixels = play("CliffWalking-v1").still()["text/html"]
    assert 'src="data:image/png;base64,' in pixels
    assert pixels.endswith("start, observation 36, return 0")
    characters = play(Game("CliffWalking-v1", picture="ansi")).still()["text/html"]
    assert "<pre>" in characters
    assert "\x1b" not in characters


def test_a_film_of_an_agent() -> None:
    """The slider shows each step of what the agent does, and the player is tied to it."""
    agent = QLearning.create(make_mdp("Golf"))
    agent.Q[:, 1] = 1.0
    film = frames("Golf", agent, stochasticity_level=0.0, frames_per_second=5)
    assert (film.slider.min, film.slider.max) == (0, 3)
    assert (film.player.min, film.player.max, film.player.interval) == (0, 3, 200)
    assert (film._link.source, film._link.target) == ((film.player, "value"), (film.slider, "value"))
    assert texts(film.widget)[1] == "start, observation 3 0, return 0"
    seen = {texts(film.widget)[0]}
    for step in (1, 2, 3):
        film.slider.value = step
        assert texts(film.widget)[1].startswith(f"step {step}: chip, observation 3 {4 * step}")
        seen.add(texts(film.widget)[0])
    assert len(seen) == 4
    with pytest.raises(ValueError, match="frames_per_second must be greater than 0"):
        frames("Golf", agent, frames_per_second=0)


def test_a_film_without_its_widget() -> None:
    """A few frames side by side, the first and the last among them; the film itself stays out of the page."""
    still = ElementTree.fromstring(frames("Boulder", lambda state: 0, max_steps=50).still()["image/svg+xml"])
    inner = still.findall("{http://www.w3.org/2000/svg}svg")
    lines = ["".join(picture.itertext()) for picture in inner]
    assert len(inner) == 4
    assert "start" in lines[0]
    assert "step 50" in lines[-1]
    lefts = [float(picture.get("x", "")) for picture in inner]
    widths = [float(picture.get("width", "")) for picture in inner]
    assert lefts == [0, *np.cumsum(widths)[:-1]]
    assert still.get("viewBox") == f"0 0 {sum(widths):.0f} {inner[0].get('height')}"
    short = frames("Boulder", [0])
    assert len(ElementTree.fromstring(short.still()["image/svg+xml"])) == 2
    assert frames("CliffWalking-v1", [0, 0]).still()["text/html"].count("<img ") == 3


def curve(slope: float = 1.0, points: int = 3, colour: str = "red", dashed: bool = False) -> Any:
    """A straight line."""
    _, axes = plt.subplots(figsize=(2, 1))
    axes.plot(np.arange(points) * slope, "--" if dashed else "-", color=colour)
    axes.set_title(f"slope {slope:g}")
    return axes


def test_exploring_with_sliders() -> None:
    """The function is called once at first and once for each change, with what the controls say."""
    calls: list[dict[str, Any]] = []

    def recorded(slope: float = 1.0, points: int = 3, colour: str = "red", dashed: bool = False) -> Any:
        calls.append({"slope": slope, "points": points, "colour": colour, "dashed": dashed})
        return curve(slope, points, colour, dashed)

    panel = explore(recorded, slope=(0.0, 2.0, 0.5), points=(2, 6, 2), colour=["blue", "red"], dashed=True)
    first = {"slope": 1.0, "points": 3, "colour": "red", "dashed": False}
    assert calls == [first]
    before = texts(panel.widget)[1]
    assert before.startswith('<img alt="slope 1" src="data:image/png;base64,')
    for name, value in {"slope": 1.5, "points": 4, "colour": "blue", "dashed": True}.items():
        panel.controls[name].value = value
        first[name] = value
        assert calls[-1] == first
    assert len(calls) == 5
    assert texts(panel.widget)[0] == "Done."
    assert texts(panel.widget)[1].startswith('<img alt="slope 1.5"')
    png = base64.b64decode(panel.still()["image/png"])
    with Image.open(io.BytesIO(png)) as image:
        assert image.format == "PNG"
        assert image.width > 100


def test_the_status_says_that_the_function_is_running() -> None:
    """And afterwards that it is not any more."""
    status: list[str] = []

    def watched(x: int = 1) -> str:
        status.append(texts(panels[0].widget)[0] if panels else "first")
        return f"x is {x}"

    panels: list[Any] = []
    panels.append(explore(watched, x=(1, 3)))
    panels[0].controls["x"].value = 2
    assert status == ["first", "Computing ..."]
    assert texts(panels[0].widget) == ["Done.", "<pre>x is 2</pre>"]


@pytest.mark.parametrize(
    ("allowed", "kind", "value"),
    [
        ((0, 4), ipywidgets.IntSlider, 2),
        ((0, 4.0), ipywidgets.FloatSlider, 2.0),
        ((0, 4, 2), ipywidgets.IntSlider, 2),
        ([1, 2, 5], ipywidgets.SelectionSlider, 2),
        (range(4), ipywidgets.SelectionSlider, 2),
        ([2, "two"], ipywidgets.Dropdown, 2),
        (True, ipywidgets.Checkbox, True),
    ],
)
def test_kinds_of_controls(allowed: Any, kind: type[Any], value: Any) -> None:
    """Each starts from the function's default, and counts only when it is let go."""
    control = explore(lambda x=2: None, x=allowed).controls["x"]
    assert type(control) is kind
    assert control.value == value
    assert control.description == "x"
    assert not getattr(control, "continuous_update", False)


def test_controls_without_a_default() -> None:
    """A slider starts at its low end, a list at its first value, a box as given; widgets are taken as they are."""
    seen: list[tuple[Any, ...]] = []

    def recorded(a: Any, b: Any, c: Any, learning_rate: Any) -> None:
        seen.append((a, b, c, learning_rate))

    logarithmic = ipywidgets.FloatLogSlider(value=0.1, min=-3, max=0)
    panel = explore(recorded, a=(3, 9), b=["x", "y"], c=True, learning_rate=logarithmic)
    assert seen == [(3, "x", True, 0.1)]
    assert panel.controls["learning_rate"] is logarithmic
    assert not logarithmic.continuous_update


@pytest.mark.parametrize(("step", "digits"), [(0.5, ".1f"), (0.25, ".2f"), (0.001, ".3f"), (1e-9, ".6f"), (2.0, ".0f")])
def test_sliders_show_as_many_digits_as_they_have(step: float, digits: str) -> None:
    """Not two for all."""
    control = explore(lambda x=0.0: None, x=(0.0, 4.0, step)).controls["x"]
    assert control.readout_format == digits


@pytest.mark.parametrize(
    ("controls", "message"),
    [
        ({"y": (0, 1)}, "control must be one of 'x', but is 'y'"),
        ({"x": (5, 9)}, "x must be from 5 to 9, but the default of the function is 2"),
        ({"x": [1, 3]}, "x must be one of 1, 3, but is 2"),
        ({"x": (4, 0)}, r"x must be \(low, high\) or .* but is \(4, 0\)"),
        ({"x": (0, 4, 0)}, r"x must be \(low, high\) or .* but is \(0, 4, 0\)"),
        ({"x": []}, r"x must be \(low, high\) or .* but is \[\]"),
        ({"x": "text"}, r"x must be \(low, high\) or .* but is 'text'"),
    ],
)
def test_wrong_controls_are_named(controls: dict[str, Any], message: str) -> None:
    """Before the function is called."""

    def never(x: int = 2) -> None:
        pytest.fail("called")

    with pytest.raises(ValueError, match=message):
        explore(never, **controls)


def grid_of_axes() -> Any:
    """Two axes in an array, as `plt.subplots` returns them."""
    return plt.subplots(1, 2)[1]


def figure_without_pyplot() -> Figure:
    """A figure that no list of open figures knows."""
    figure = Figure()
    figure.subplots().set_title("drawn apart")
    return figure


def nothing_returned() -> None:
    """A figure that is only made."""
    plt.figure().suptitle("made")


@pytest.mark.parametrize(
    ("function", "mime_type", "data", "description"),
    [
        (curve, "image/png", "iVBOR", "slope 1"),
        (grid_of_axes, "image/png", "iVBOR", "grid_of_axes"),
        (figure_without_pyplot, "image/png", "iVBOR", "drawn apart"),
        (nothing_returned, "image/png", "iVBOR", "made"),
        (lambda: Scene(1, 1, (Circle(0.5, 0.5, 0.2),)), "image/svg+xml", "<svg", "<lambda>"),
        (lambda: pd.DataFrame({"method": [1]}), "text/html", "<div>", "<lambda>"),
        (lambda: "a < b", "text/html", "<pre>a &lt; b</pre>", "<lambda>"),
        (lambda: None, "text/html", "", "<lambda>"),
    ],
)
def test_what_functions_return(function: Callable[..., Any], mime_type: str, data: str, description: str) -> None:
    """Figures, axes, scenes, tables and texts are all shown."""
    result = call(function, {})
    assert (result.mime_type, result.description) == (mime_type, description)
    assert result.data.startswith(data)
    assert (result.data == "") == (data == "")


def test_figures_of_others_stay_open() -> None:
    """Only what the function made is closed, also when it fails."""
    own = plt.figure()

    def failing() -> None:
        plt.figure()
        raise RuntimeError("no")

    call(curve, {})
    with pytest.raises(RuntimeError, match="no"):
        call(failing, {})
    assert plt.get_fignums() == [own.number]
    plt.close(own)


def test_a_first_call_that_fails_fails_in_the_cell() -> None:
    """Then there is no widget that could show the error."""

    def failing(x: int = 1) -> None:
        raise RuntimeError("no")

    with pytest.raises(RuntimeError, match="no"):
        explore(failing, x=(1, 2))


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
from typing import NamedTuple

import matplotlib.pyplot as plt
from gymnasium import spaces

from edugym.notebook import explore, play


class Walk(NamedTuple):
    action_names = ("left", "right")
    observation_space = spaces.Discrete(5)
    action_space = spaces.Discrete(2)

    def initial(self, rng):
        return 2

    def transition(self, state, action, rng):
        return state + 2 * action - 1

    def reward(self, state, action, next_state, rng):
        return 1.0

    def terminal(self, state):
        return state in (0, 4)

    def observation(self, state, rng):
        return state


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
    "game = play(Walk())\ngame.actions['right'].click()\ngame",
    "panel = explore(curve, slope=(0.0, 2.0))\npanel.controls['slope'].value = 2.0\npanel",
    "failing = explore(broken, x=(1, 5))\nfailing.controls['x'].value = 3\nfailing.controls['x'].value = 4\nfailing",
    "failing.controls['x'].value = 3",
    "game.step('right')\ngame.actions['right'].click()",
]


def test_widgets_in_a_kernel() -> None:
    """Nothing is shown twice; prints and errors of callbacks go into the widget, and stay there until the next call."""
    notebook = new_notebook(cells=[new_code_cell(source) for source in CELLS])
    NotebookClient(notebook, timeout=60, kernel_name="python3", extra_arguments=["--log-level=ERROR"]).execute()
    _, played, explored, failed, *last = notebook.cells

    [output] = played.outputs
    assert "step 1: right" in output.data["image/svg+xml"]
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
