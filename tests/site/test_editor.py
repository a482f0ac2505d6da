"""The editor of the playground: what a reader may begin with runs, and mistakes are told with their line."""

import re
from pathlib import Path
from typing import Any, NamedTuple

import codemirror
import editor
import edugym_page
import npm
import numpy as np
import playground
import pytest
from offers import Race
from places import MAPS
from races import BOULDER, DIVER, RACES, ROADRUNNER, STUDY
from scenery import scenery, table

import edugym
import edugym.objectives

SHORT = re.findall(r"SHORT = `(.*?)`", (playground.PAGE / "editor.js").read_text(encoding="utf-8"), re.DOTALL)[0]
BOULDER_OF_4 = 'mdp = edugym.make_mdp("Boulder", height=4)'


def made(race: Race, seen: str, k: int | None = None) -> str:
    """The lines that make a task, as an agent sees it; by default at the strength of the race."""
    value = race.strength.values[race.strength.first if k is None else k]
    given = {race.strength.parameter: value, **race.parameters}
    text = ", ".join([repr(race.environment), *(f"{name}={value!r}" for name, value in given.items())])
    return f"mdp = edugym.make_mdp({text})\n" + (f"mdp = {seen}\n" if seen else "")


def run(
    source: str, task: str = BOULDER_OF_4, steps: int = 300, show: Any = lambda *_: None, measured: str | None = None
) -> dict[str, Any]:
    """What comes of a program; Boulder's pictures are decided by the state itself."""
    return edugym_page.run(source, task, steps, 0, 1, show, [""], 10, measured)


def test_the_short_agent_learns() -> None:
    """And nothing is said of it."""
    found = run(SHORT, steps=3_000)
    assert found["curve"][-1] == [3_000, 1.0]
    assert found["said"] == []


def test_the_short_agent_gets_the_settings_of_the_race() -> None:
    """What the page replaces stands in the program, and once: α, γ and ε, so that it learns as fast as Q-learning."""
    text = (playground.PAGE / "editor.js").read_text(encoding="utf-8")
    replaced = re.findall(r"\.replace\('([^']+)', `", text)
    assert len(replaced) == 3
    assert [SHORT.count(part) for part in replaced] == [1, 1, 1]


QUICK, *OTHERS = RACES


@pytest.mark.parametrize(
    "races", [[QUICK], pytest.param(OTHERS, marks=pytest.mark.slow)], ids=["one task", "all others"]
)
def test_all_agents_run_from_their_files(races: list[Race]) -> None:
    """In every task; the settings are those of the lesson."""
    texts = playground.sources(races)
    for race in races:
        for entry in playground.menu(race)["agents"]:
            settings = "".join(f", {name}={value}" for name, value in entry["settings"])
            kind = entry["kind"].rpartition(".")[2]
            source = f"{texts[kind]}\n\nagent = {kind}.create(mdp{settings})\n"
            found = run(source, made(race, entry["seen"]), steps=60, measured=race.measure and race.measure.code)
            assert "curve" in found, (race.environment, entry["label"], found)


MISTAKES = {
    "agent = 3 +": (1, "SyntaxError"),
    "exit()": (1, "SystemExit"),
    "import pandas_": (1, "The page has edugym, numpy"),
    "x = 1": (None, "agent = ..."),
    "agent = 3": (None, "agent must be an object with the methods act and learn"),
    SHORT.replace("target - ", "target - sef."): (17, "NameError"),
    SHORT.replace("return rng.choice(best)", "return 7"): (11, "greedy"),
    SHORT.replace("return rng.choice(best)", "best"): (11, "is a return missing?"),
    SHORT.replace("edugym.QLearning.create(mdp).Q", "[[0, 0]] * 10"): (20, "Q must be an array, but is a list"),
    SHORT.replace("+= 0.1 *", "+= np.nan *"): (15, "terminated False. Is the learning rate too large"),
    SHORT.replace("+= 0.1 *", "+= 0.1 "): (17, "Is a * missing"),
    SHORT.replace("self.Q[next_state].max()", "self.Q[next_state]"): (17, "is .max() or an index"),
    SHORT.replace("self.Q[state, action] +=", "self.Q[action, state] +="): (17, "states from 0 to 4, and actions from"),
    SHORT.replace("edugym.QLearning.create(mdp).Q", "np.zeros((mdp.n_states, 2))"): (20, "edugym.table_size(mdp)"),
}


@pytest.mark.parametrize("source", MISTAKES, ids=lambda source: str(len(source)))
def test_mistakes_are_told_with_their_line(source: str) -> None:
    """In one sentence of the package's own where there is one."""
    line, word = MISTAKES[source]
    found = run(source)
    assert word in found["error"]
    assert found["line"] == line


ENDS = "reward if terminated else reward"
NEXT = " + 0.99 * self.Q[next_state].max()"


@pytest.mark.parametrize(
    ("learns", "forgets"),
    [
        (SHORT, False),
        (SHORT.replace(ENDS, "reward"), True),
        (SHORT.replace(ENDS, "reward").replace(", terminated", ""), True),
        (SHORT.replace(ENDS, "reward").replace(NEXT, ""), False),
    ],
)
def test_an_end_that_is_forgotten(learns: str, forgets: bool) -> None:
    """It is said, also where it changes nothing; an agent that looks at no next state need not look at the end."""
    assert ["not look at terminated" in one for one in run(learns)["said"]] == [True] * forgets


class Parts(NamedTuple):
    """An agent, or a part of one."""

    array: Any
    rest: Any


def test_whole_numbers_have_64_bits() -> None:
    """In arrays of the agent and of its parts; an array in two places stays one; all else stays as it is."""
    counts, values = np.zeros(3, np.int32), np.zeros(3)
    given = edugym_page.with_64_bits(Parts(counts, Parts(values, counts)))
    assert type(given) is Parts
    assert given.array.dtype == np.int64
    assert given.rest.array is values
    assert given.rest.rest is given.array


NO_TABLE = SHORT.replace("self.Q", "self.own").replace("Q: np.ndarray", "own: np.ndarray")
GO_EXPLORE = "agent = edugym.GoExplore.create(mdp)"
OTHER_TABLE = SHORT.replace(".create(mdp)", ".create((9, 2))")
VECTORS = """
class Still:
    tabular = False
    def act(self, state, rng): return 0
    def learn(self, reward): pass
agent = Still()
"""


@pytest.mark.parametrize(
    ("source", "size"),
    [(SHORT, 10), (GO_EXPLORE, 10), (NO_TABLE, 0), (OTHER_TABLE, 0)],
    ids=["Q", "goals", "no table", "another size"],
)
def test_what_the_agent_knows_is_shown(source: str, size: int) -> None:
    """At the beginning, at the end, and between: every step counts; action values where it has a table of them."""
    shown: list[Any] = []
    found = run(source, steps=3_000, show=lambda *given: shown.append(given))
    assert "curve" in found
    assert len(shown) >= 2
    counts = [visits.sum() for visits, _, _ in shown]
    assert counts[0] == 0
    assert counts == sorted(counts)
    assert shown[-1][0][:4].sum() == 3_000
    assert {Q.size for _, Q, _ in shown} == {size}
    assert (shown[-1][1].max(initial=0.0) > 0) == (size > 0)


def test_of_an_agent_without_a_table_games_alone_are_shown() -> None:
    """It runs as elsewhere."""
    shown: list[Any] = []
    assert "curve" in run(VECTORS, show=lambda *given: shown.append(given))
    assert {(visits.size, Q.size) for visits, Q, _ in shown} == {(0, 0)}
    assert shown[-1][2][0][0] == 0


COUNTS = """
class Counts:
    def __init__(self): self.Q, self.calls = np.zeros((10, 2)), np.zeros(1)
    def act(self, state, rng): return int(rng.integers(2))
    def greedy(self, state, rng):
        self.calls[0] += 1
        return int(self.calls[0] % 2)
    def learn(self, state, action, reward): self.Q[state, action] = self.calls[0]
agent = Counts()
"""


@pytest.mark.parametrize("source", [SHORT, GO_EXPLORE, VECTORS, COUNTS], ids=["Q", "goals", "vectors", "counts"])
def test_an_agent_walks_as_it_would_play_now(source: str) -> None:
    """At the end in several games; they change nothing in the run, also where `greedy` changes the agent."""
    shown: list[Any] = []
    found = run(source, steps=3_000, show=lambda *given: shown.append(given[2]))
    assert [*map(len, shown)] == [*[1] * (len(shown) - 1), edugym_page.GAMES]
    heights = [game for games in shown for game in games]
    assert all(game[0] == 0 and (np.diff(game) <= 1).all() for game in heights)
    if source == SHORT:
        assert all(game.tolist() == [0, 1, 2, 3, 4] for game in shown[-1])
    space: dict[str, Any] = dict(edugym_page.NAMES)
    exec(f"{BOULDER_OF_4}\n{source}", space)
    curve = edugym.train(space["mdp"], space["agent"], 3_000, seed=0, evaluation_episodes=1)
    assert found["curve"] == [list(point) for point in zip(curve.steps, curve.returns, strict=True)]


def test_of_another_task_no_game_is_shown() -> None:
    """Its states may decide no picture of the page's; what an agent gets wrong is told by `train` alone."""
    games: list[Any] = []
    assert "curve" in run(f"{BOULDER_OF_4}\n{SHORT}", show=lambda *given: games.extend(given[2]))
    assert "act" in run(SHORT.replace("return rng.choice(best)", "return 7"))["error"]
    assert not any(map(len, games))


@pytest.mark.parametrize("race", RACES, ids=lambda race: race.environment)
def test_games_are_pictures_of_the_page(race: Race) -> None:
    """Every moment of a game is one that the page can draw."""
    mdp, where = race.mdp(race.strength.first), MAPS[race.environment]
    entry = playground.menu(race)["agents"][-1]
    scene = scenery(where, mdp)
    rows = len(table(where, mdp, race.agents[-1].view.of(mdp))["cell"])
    settings = "".join(f", {name}={value}" for name, value in entry["settings"])
    source, games = f"agent = edugym.{entry['kind']}.create(mdp{settings})", list[Any]()
    task, measured = made(race, entry["seen"]), race.measure and race.measure.code
    done = edugym_page.run(source, task, 60, 0, 1, lambda *given: games.extend(given[2]), where.look, rows, measured)
    assert "curve" in done
    moments = np.concatenate(games).reshape(-1, len(where.look))
    assert len(moments) > len(games)
    assert "moves" in scene or {",".join(f"{part:g}" for part in moment) for moment in moments} <= {*scene["moments"]}


def test_of_vectors_the_page_shows_its_own_number() -> None:
    """An agent that takes the vector of rewards is trained on it, and the curve is what the race compares."""
    assert DIVER.measure
    agent = "agent = edugym.objectives.ChebyshevQLearning.create(mdp, (1.0, 8.0), discount=1.0)"
    shown, task = list[Any](), made(DIVER, "")
    found = run(agent, task, 500, lambda *given: shown.append(given[0]), DIVER.measure.code)
    mdp = DIVER.mdp(DIVER.strength.first)
    same = edugym.objectives.ChebyshevQLearning.create(mdp, (1.0, 8.0), discount=1.0)
    expected = eval(DIVER.measure.code, {"run": edugym.objectives.train_vectors(mdp, same, 500)})
    assert [value for _, value in found["curve"]] == expected.tolist()
    assert shown[-1].sum() >= 500
    assert "train_vectors" in run(agent, task)["error"]


@pytest.mark.slow
@pytest.mark.parametrize("race", [BOULDER, ROADRUNNER, STUDY], ids=lambda race: race.environment)
def test_a_change_of_the_code_shows(race: Race) -> None:
    """Where the page begins: with a discount of 0, or with a wrong sign, every run ends lower than those without it."""
    own, trial = playground.own_settings(race.agents[0]), race.trial
    short = SHORT.replace("0.1 * (target", f"{own['learning_rate']} * (target").replace("< 0.1", f"< {own['epsilon']}")
    sources = [
        short.replace("0.99 *", f"{own['discount']} *"),
        short.replace("0.99 *", "0.0 *"),
        short.replace("+= ", "-= "),
    ]
    task, ends = made(race, "", trial.strength), list[list[float]]()
    for source in sources:
        runs = (
            edugym_page.run(source, task, trial.steps, seed, race.episodes, lambda *_: None, [""], 10)
            for seed in (0, 1)
        )
        ends.append([float(np.mean([value for _, value in run["curve"][-10:]])) for run in runs])
    assert min(ends[0]) > max(ends[1] + ends[2])


def test_what_is_interpreted_says_why() -> None:
    """With the line, in a sentence."""
    found = run(SHORT.replace("        target =", "        notes = {}\n        target ="), steps=6_000)
    (said,) = found["said"]
    assert "it makes a dict (line 16)" in said


def test_the_modules_of_the_field_find_each_other() -> None:
    """By the names of files; the page asks for files that are there."""
    written = "import { a } from '@lezer/common';\nexport { b } from \"style-mod\"; // from 'module'"
    assert codemirror.linked(written).count('from "./') == 2
    assert 'from "./lezer-common.js"' in codemirror.linked(written)
    field = (playground.PAGE / "field.js").read_text(encoding="utf-8")
    asked = re.findall(r"'([\w-]+)'", re.findall(r"MODULES = \[(.*?)\]", field)[0])
    assert asked
    assert {f"{name}.js" for name in asked} <= {codemirror.file_of(name) for name in codemirror.VERSIONS}


def test_without_npm_there_is_no_editor(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The page is built all the same."""
    monkeypatch.setattr(npm, "PACKAGES", tmp_path / "npm")
    monkeypatch.setenv("PATH", "")
    assert editor.build(tmp_path / "python") is None
    assert not (tmp_path / "python").exists()


def test_what_is_fetched_is_kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """By the name that was asked for; an archive that is there is not fetched again."""
    script = """#!/bin/sh\necho '[{"filename": "@a/b-1.0.0.tgz"}]'\necho "archive of $5" > "$4/a-b-1.0.0.tgz"\n"""
    (tmp_path / "npm").write_text(script)
    (tmp_path / "npm").chmod(0o700)
    monkeypatch.setattr(npm, "PACKAGES", tmp_path)
    for path in (str(tmp_path), ""):
        monkeypatch.setenv("PATH", path)
        assert npm.fetched("@a/b@1.0").read_text() == "archive of @a/b@1.0\n"
