"""What is written on the command line, and the report that `edugym profile` makes of it."""

import html.parser
import re
import signal
import sys
from pathlib import Path
from typing import Any

import pandas
import pytest
from gymnasium.spaces import Discrete
from matplotlib import pyplot

import edugym
from edugym import Ladder, Profile, make_mdp, repeat
from edugym.experiments.profiles import profile as profiles
from edugym.experiments.profiles import tables, verdicts
from edugym.experiments.profiles.ladders import LADDERS
from edugym.experiments.profiles.pictures import OTHERS, Dots, Rungs
from edugym.experiments.profiles.scores import COLUMNS, pooled
from edugym_course import arguments, profiling
from tests.course.test_commands import run
from tests.messages import named


@pytest.mark.parametrize(
    ("text", "value"),
    [("3", 3), ("0.5", 0.5), ("inf", float("inf")), ("None", None), ("[1, 2]", [1, 2]), ("north", "north"), ("", "")],
)
def test_values_are_read_as_python_where_they_can_be(text: str, value: Any) -> None:
    """And else as texts."""
    (read,) = arguments.parameters([f"name={text}"]).values()
    assert (type(read), read) == (type(value), value)


@pytest.mark.parametrize("texts", [["height"], ["=3"], ["1x=3"], ["a b=3"], ["height=3", "height=4"]])
def test_a_parameter_is_a_name_and_a_value(texts: list[str]) -> None:
    """Once; the message shows what came."""
    with pytest.raises(ValueError, match="height .*twice" if len(texts) > 1 else f"name=value.*'{texts[0]}'"):
        arguments.parameters(texts)
    assert arguments.parameters(["a=b=c", "d=1"]) == {"a": "b=c", "d": 1}


MINE = """
from beside import RIGHT


class Table:
    tabular = False

    def __init__(self, environment):
        self.n_actions = environment.action_space.n

    def act(self, state, rng):
        return RIGHT

    def learn(self, reward):
        pass


class Model:
    def predict(self, observation):
        return RIGHT


def make(environment):
    return Table(environment)


model = Model()
number = 3
"""


@pytest.fixture
def mine(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with a student's file, and another one that it imports."""
    (tmp_path / "mine.py").write_text(MINE)
    (tmp_path / "beside.py").write_text("RIGHT = 1")
    (tmp_path / "slip.py").write_text("import beside\nx = beside.LEFT\n")
    (tmp_path / "math.py").write_text("def agent(environment): return environment")
    monkeypatch.delitem(sys.modules, "mine", raising=False)  # of another test
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_agents_of_the_package_and_of_a_file(mine: Path) -> None:
    """Classes, functions and policies; the label is what is written, without the file.

    A file whose name is that of one of Python's modules does not stand in for it.
    """
    texts = ["QLearning", f"{mine}/mine.py:Table", "mine.py:make", "mine.py:model", "SARSA+FrameStack(2, actions=True)"]
    read = arguments.agents(texts)
    assert list(read) == ["QLearning", "Table", "make", "model", "SARSA + FrameStack(2, actions=True)"]
    assert read["QLearning"] == edugym.QLearning.create
    environment = edugym.MDPEnv(make_mdp("Boulder"))
    assert read["Table"](environment).n_actions == read["make"](environment).n_actions == 2
    assert read["model"].predict(0) == 1
    make, wrap = read["SARSA + FrameStack(2, actions=True)"]
    assert make == edugym.SARSA.create
    assert wrap(make_mdp("Boulder")).observation_space == Discrete(11 * 2 * 11)
    assert arguments.agents(["math.py:agent"])["agent"](3) == 3
    assert hasattr(sys.modules["math"], "pi")
    assert type(read["model"]) is sys.modules["mine"].Model


def test_wrappers_come_from_the_inside_to_the_outside() -> None:
    """The first one that is written is the first around the task."""
    (pair,) = arguments.agents(["QLearning + Discretised(3) + DiscreteActions(2)"]).values()
    wrapped = pair[1](make_mdp("Trashbot"))
    assert [type(wrapped).__name__, type(wrapped.mdp).__name__] == ["DiscreteActions", "Discretised"]


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("Qlearning", "one of ActorCritic, .*, or be written FILE.py:NAME, but is Qlearning"),
        ("Boulder", "one of ActorCritic"),
        ("", "but is missing"),
        ("mine.py:nobody", "mine.py has no 'nobody'; it has RIGHT, Table"),
        ("mine.py:number", "number of mine.py must be an agent, or make one, but is 3"),
        ("no.py:Agent", "no.py"),
        ("slip.py:Agent", "slip.py .*line 2 .*AttributeError.*LEFT"),
        ("QLearning + FrameStack", "a wrapper must be one of .*FrameStack.*, but is 'FrameStack'"),
        ("QLearning + Frames(4)", "but is 'Frames\\(4\\)'"),
        ("QLearning + FrameStack(x)", "but is 'FrameStack\\(x\\)'"),
        ("QLearning + FrameStack(", "but is 'FrameStack\\('"),
    ],
)
def test_what_is_no_agent(mine: Path, text: str, says: str) -> None:
    """It says what is allowed."""
    with pytest.raises((ValueError, OSError), match=says):
        arguments.agents([text])


def test_an_agent_is_given_once() -> None:
    """Two of the same label could not be told apart."""
    with pytest.raises(ValueError, match="QLearning is given twice"):
        arguments.agents(["QLearning", "QLearning"])


TUNED = "\n\ndef made(environment, speed=1):\n    return Table(environment)\n"


def test_settings_to_choose_from(mine: Path) -> None:
    """All combinations of those that an agent has, besides itself; its wrappers stay, and who has none is left out."""
    (mine / "mine.py").write_text(MINE + TUNED)
    agents = arguments.agents(["QLearning", "DynaQ + FrameStack(2)", "mine.py:made", "mine.py:model"])
    grids = arguments.grids(agents, ["exploration=EpsilonGreedy(0.2)", "planning_steps=0,5", "speed=2"])
    greedy = "exploration=EpsilonGreedy(0.2)"
    assert {label: [*grid] for label, grid in grids.items()} == {
        "QLearning": ["as given", greedy],
        "DynaQ + FrameStack(2)": ["as given", f"{greedy}, planning_steps=0", f"{greedy}, planning_steps=5"],
        "made": ["as given", "speed=2"],
    }
    assert grids["QLearning"]["as given"] is agents["QLearning"]
    assert grids["QLearning"][greedy]((2, 2)).exploration == edugym.EpsilonGreedy(0.2)
    make, wrap = grids["DynaQ + FrameStack(2)"][f"{greedy}, planning_steps=5"]
    assert make((2, 2)).planning.n == 5
    assert wrap is agents["DynaQ + FrameStack(2)"][1]


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("speed=2", "QLearning, SARSA has no speed"),
        ("learning_rate", "name=value, but not 'learning_rate'"),
        ("learning_rate=", "learning_rate must be values such as .*, but is ''"),
        ("learning_rate=x", "but is 'x'"),
        ("learning_rate=0.5,7", named("learning_rate", 0, 1, 7)),
        ("exploration=EpsilonGreedy(2)", named("epsilon", 0, 1, 2)),
        ("exploration=3", named("exploration", "EpsilonGreedy(0.1)", 3)),
        ("exploration=Greedy(1)", "exploration must be values"),
        ("learning_rate=0.1] + [2", "learning_rate must be values"),
    ],
)
def test_what_is_no_setting_to_choose_from(text: str, says: str) -> None:
    """It says what is allowed."""
    agents = arguments.agents(["QLearning", "SARSA"])
    with pytest.raises(ValueError, match=says):
        arguments.grids(agents, [text])


def wall(height: float, layout_seed: int) -> Any:
    """A low wall."""
    return make_mdp("Boulder", height=int(height), layout_seed=layout_seed)


LOW = Ladder("Boulder", "exploration", "height of the wall", (2, 3), wall, 200)
ARM = next(ladder for ladder in LADDERS if ladder.name == "Trashbot")


class Page(html.parser.HTMLParser):
    """What a page asks of others, and which of its tags are not closed."""

    def __init__(self, text: str) -> None:
        """Read a page."""
        super().__init__()
        self.open: list[str] = []
        self.asks: list[str] = []
        self.ids: list[str] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        """Take note of a tag, and of what it refers to."""
        self.asks += [value or "" for name, value in attributes if name in ("src", "href", "xlink:href")]
        self.ids += [value or "" for name, value in attributes if name == "id"]
        if tag not in ("meta", "br"):
            self.open.append(tag)

    def handle_startendtag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        """A tag without contents."""
        self.handle_starttag(tag, attributes)
        self.handle_endtag(tag)

    def handle_endtag(self, tag: str) -> None:
        """It must be the last one that is open."""
        if tag not in ("meta", "br"):
            assert self.open.pop() == tag


def test_the_command_writes_a_report(mine: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """One HTML file that asks no other host, the same as Markdown, the runs, and a picture."""
    monkeypatch.setattr(profiles, "LADDERS", (LOW, ARM._replace(strengths=(0.9,), n_steps=10)))
    done = run("profile", "QLearning", "mine.py:Table", "--repetitions", "2", "--output", "out")
    assert done.exit_code == 0, done.output
    assert "masters even the rung 3 (height of the wall)" in " ".join(done.output.split())
    assert "QLearning and Table cannot enter." in done.output
    files = sorted(path.name for path in Path("out").iterdir())
    assert files == ["profile.png", "profile.svg", "report.html", "report.md", "runs.csv"]
    text = Path("out/report.html").read_text(encoding="utf-8")
    page = Page(text)
    assert page.open == []
    assert all(re.fullmatch(r"#[\w.-]+", asked) for asked in page.asks)
    assert {asked[1:] for asked in page.asks} <= {*page.ids}
    assert len({*page.ids}) == len(page.ids)
    assert "default-src 'none'" in text
    assert "prefers-color-scheme: dark" in text
    written = Path("out/report.md").read_text(encoding="utf-8")
    assert "| Trashbot | nobody can enter |" in written  # the others have climbed another ladder
    for says in ("QLearning and Table in Trashbot: a table needs", "Boulder: exploration", "2 times on every rung"):
        assert says in written
        assert says in text
    assert len(Path("out/runs.csv").read_text().splitlines()) == 1 + 2 * 2 * 2


def test_the_report_shows_tuned_agents_beside_themselves(mine: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """With what there was to choose, and what the choice cost."""
    monkeypatch.setattr(profiles, "LADDERS", (LOW,))
    tuned = ("--tuned", "learning_rate=1e-9,0.5", "--repetitions", "2")
    done = run("profile", "QLearning", "mine.py:Table", *tuned, "--output", "out")
    assert done.exit_code == 0, done.output
    written = Path("out/report.md").read_text(encoding="utf-8")
    assert "| QLearning | Table | tuned QLearning |" in written
    # Three settings, three times, on two rungs of 200 steps each.
    assert (
        "QLearning had the choice of: as given; learning_rate=1e-09; learning_rate=0.5. It tried them for 3,600"
        in written
    )
    assert len(Path("out/runs.csv").read_text().splitlines()) == 1 + 3 * 2 * 2


def test_a_command_that_is_wrong(tmp_path: Path) -> None:
    """It ends with one sentence."""
    for given, says in (
        (("Nobody",), "an agent must be one of"),
        (("QLearning", "--challenge", "Chess"), "Chess"),
        ((), "give agents, or --all, or --libraries"),
        (("QLearning", "--all"), "give agents, or --all, or --libraries"),
        (("--libraries", "--all"), "give agents, or --all, or --libraries"),
        (("--all", "--tuned", "learning_rate=0.1"), "stored profiles are not tuned"),
        (("QLearning", "--tuned", "learning_rate=7"), "learning_rate"),
    ):
        done = run("profile", *given, "--output", str(tmp_path / "out"))
        assert done.exit_code == 2
        assert says in done.output


@pytest.mark.parametrize("at", ["profile", "tuned_profile"])
def test_ctrl_c_keeps_what_is_done(at: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The folder stays for the same command, which takes from it what was done."""
    signal.signal(signal.SIGINT, signal.default_int_handler)
    monkeypatch.setattr(profiles, "LADDERS", (LOW,))
    original, line = getattr(profiling, at), ("QLearning", "--tuned", "learning_rate=0.5", "--repetitions", "2")

    def interrupted(*given: Any, **how: Any) -> Any:
        original(*given, **how)
        raise KeyboardInterrupt

    monkeypatch.setattr(profiling, at, interrupted)
    done = run("profile", *line, "--output", str(tmp_path / "out"))
    assert done.exit_code == 130
    assert "the same command goes on" in done.output
    assert any((tmp_path / "out" / "unfinished").iterdir())
    monkeypatch.setattr(profiling, at, original)
    again: list[Any] = []

    def counted(task: Any, agents: Any, *given: Any, **how: Any) -> Any:
        again.append(agents)
        return repeat(task, agents, *given, **how)

    monkeypatch.setattr(profiles, "repeat", counted)
    assert run("profile", *line, "--output", str(tmp_path / "out")).exit_code == 0
    assert [name for agents in again for name in agents if name == "QLearning"] == []
    assert bool(again) == (at == "profile")  # then it goes on with the choice


def test_dots_name_the_agents_beside_them_only_where_there_are_some() -> None:
    """The legend has an entry for each agent, and one for all of those beside."""
    found = edugym.profile({"Q": edugym.QLearning.create}, challenges=[LOW], repetitions=2)
    beside = Profile(found.runs.assign(agent="R"), (LOW,), ("R",))
    for others, labels in ((None, ["Q"]), (beside, [OTHERS, "Q"])):
        for drawn in (Dots(found, others), Rungs(found, "Boulder", others)):
            assert sorted(drawn.draw().get_legend_handles_labels()[1]) == sorted(labels)
    assert Rungs(found, "Boulder", found).draw().get_legend_handles_labels()[1] == ["Q"]  # who is here is no other
    others = Profile(beside.runs, (LOW._replace(strengths=(2,)),), ("R",))
    assert Rungs(found, "Boulder", others).draw().get_legend_handles_labels()[1] == ["Q"]
    pyplot.close("all")


def test_the_report_names_those_to_take() -> None:
    """The best, and those whose difference from it may be chance; none where all fail; one beside if it is better."""
    agents = {"Q": edugym.QLearning.create, "nothing": lambda environment: lambda observation: 0}
    found = edugym.profile(agents, challenges=[LOW], repetitions=3)
    assert verdicts.best_agents(found, "Boulder") == ["Q"]
    alone = edugym.profile({"nothing": agents["nothing"]}, challenges=[LOW], repetitions=3)
    assert verdicts.best_agents(alone, "Boulder") == []
    for profile, beside, expected in (
        (found, alone, "Q 1.00 (of 2 tried)"),
        (alone, found, "Q 1.00 (of 2 tried)"),
        (found, found, "Q 1.00 (of 2 tried)"),
        (alone, alone, "nobody of 1 tried is better than random play"),
        (Profile(found.runs[:0], (LOW,), ("P",)), found, "Q 1.00 (of 2 tried)"),  # nobody here has entered
    ):
        assert tables.take_table(profile, pooled(profile, beside))[1][0][2] == expected
    for blank, expected in (({}, "?"), ({"Q": {"Boulder": "it is afraid"}}, "–")):  # not measured, cannot enter
        assert tables.score_table(Profile(found.runs[:0], (LOW,), ("Q",), blank))[1][0][1] == expected
    chance = found.runs.assign(score=found.runs["score"] - 0.01 * (found.runs["repetition"] == 0))
    assert verdicts.better_beside(Profile(chance, (LOW,), ("Q", "nothing")), "Boulder", found) is None


@pytest.mark.parametrize(
    ("scores", "take"),
    [
        ((0.5, 0.5, 0.9, 0.9), ["few"]),
        ((0.5, 0.5, 0.6, 0.9), ["few", "often"]),
        ((0.5, 0.5, 0.2, 0.2), ["often"]),
        ((0.5, 0.5, 0.2, 0.5), ["often", "few"]),
    ],
)
def test_who_has_fewer_repetitions_is_surely_worse_if_the_intervals_lie_apart(
    scores: tuple[float, ...], take: list[str]
) -> None:
    """Two runs with a wide interval do not tell; tables and method say how many there were."""
    first, second, third, fourth = scores
    rows = [
        {"agent": agent, "challenge": "Boulder", "strength": 2, "repetition": number, "score": score}
        for agent, runs in (("often", (first, second, first)), ("few", (third, fourth)))
        for number, score in enumerate(runs)
    ]
    runs = pandas.DataFrame(rows).reindex(columns=list(COLUMNS))
    found = Profile(runs, (LOW._replace(strengths=(2,)),), ("often", "few"))
    assert verdicts.best_agents(found, "Boulder") == take
    assert "Fewer times: few 2." in tables.method(found)
    assert ("in 2 runs" in tables.take_table(found)[1][0][2]) == (take[0] == "few")
