"""What the page is told agrees with the package."""

import json
import math
import re
from typing import Any

import kernels
import numpy as np
import playground
import pytest
from offers import Race
from places import MAPS
from races import BOULDER, CASINO, RACES, TAMAGOTCHI, TRASHBOT
from scenery import elements, key_of, scenery, table
from words import WORDS

import edugym
import edugym.objectives
from edugym.adapters.registration import in_course_order
from edugym.mdp.tabular import table_sizes
from edugym.rendering.scene import Text
from edugym.training.trainers import streams

each_race = pytest.mark.parametrize("race", RACES, ids=lambda race: race.environment)


def test_every_environment_of_a_lesson_has_a_race() -> None:
    """In the order of the lessons."""
    names = [entry.name for entry in in_course_order() if entry.lesson]
    assert [race.environment for race in RACES] == names


@each_race
def test_the_menu_can_be_shown(race: Race) -> None:
    """It is JSON; three agents or more race; and "why?" is plain text, three sentences from the lesson."""
    menu = json.loads(json.dumps(playground.menu(race), allow_nan=False))
    assert len(menu["agents"]) >= 3
    assert len(race.actions) in (0, race.agents[0].view.seen(race.mdp(0)).action_space.n)
    assert len({agent["label"] for agent in menu["agents"]}) == len(menu["agents"])
    assert not re.search(r"[$\\{}*^_]", menu["why"])
    assert len(re.findall(r"[.?](?= |$)", menu["why"])) == 3
    assert str(race.strength.values[race.strength.first]).startswith(menu["strength"]["values"][race.strength.first])


def first_state(mdp: Any) -> Any:
    """A state in which an episode begins."""
    return mdp.initial(np.random.default_rng(0))


@each_race
def test_where_the_code_is_changed_the_page_has_what_it_begins_with(race: Race) -> None:
    """A strength and a number of seeds from which the reader chooses, and some hundred thousand steps at most."""
    trial = playground.menu(race)["code"]
    assert trial["strength"] in range(len(race.strength.values))
    assert trial["several"] in playground.SEVERAL
    assert trial["steps"] * trial["several"] <= 500_000


@each_race
def test_the_words_for_everybody_fit_the_task(race: Race) -> None:
    """No mathematics; for every action a name and a sign, with the number that the picture has; letters for codes.

    A sign stands in the middle of its cell, but where it is that of a thing beside it: an arm, or a grip.
    """
    words = WORDS[race.environment]
    assert words.strength
    assert not re.search(r"[$\\{}*^_]|[α-ω]", words.why)
    for k in range(len(race.strength.values)):
        mdp = race.mdp(k)
        seen = playground.played(race, mdp)
        shown = playground.buttons(race, mdp)
        assert {len(names) for names in shown} == {seen.action_space.n}
        assert len(shown) in (1, seen.observation_space.n)
        sizes = dict(zip(race.numbers, table_sizes(race.agents[0].view.places(mdp).observation_space), strict=False))
        assert {name: len(letters) for name, letters in words.codes(mdp).items()}.items() <= sizes.items()
        signs, scene = MAPS[race.environment].marks(mdp), MAPS[race.environment].scene(mdp, first_state(mdp))
        numbers = {name.split()[-1] for names in shown for name in names if name[-1:].isdigit()}
        assert numbers <= {shape.content for shape in scene.shapes if isinstance(shape, Text)}
        assert len(signs) in (0, seen.action_space.n)
        for (x, y, sign), name in zip(signs, shown[0], strict=False):
            assert name.endswith(f" {sign}") if sign.isdigit() else sign == "○" or x == y == 0


@pytest.mark.parametrize(
    ("race", "k", "expected"),
    [
        (CASINO, 0, [0.5 * 0.5 * (-0.1 - 2.1)]),  # in with probability 1/2; then the machine, or what is none
        (TAMAGOTCHI, 0, [-676, 6707]),  # as its docstring has them
        (BOULDER, 6, [8.678e-05]),  # that a fair coin, thrown 200 times, shows heads 20 times in a row
    ],
    ids=["Casino", "Tamagotchi", "Boulder"],
)
def test_simple_players_get_what_is_known(race: Race, k: int, expected: list[float]) -> None:
    """Somebody who moves at random, and somebody who does what the toy says."""
    found = [mean for _, mean in playground.others(race, race.mdp(k))]
    assert found == pytest.approx(expected, rel=0.05)


@each_race
def test_the_code_for_readers_makes_the_agents(race: Race) -> None:
    """Who pastes it gets the task and the agent that race, at the last strength: the code is run here, and compared."""
    mdp = race.mdp(len(race.strength.values) - 1)
    for agent, shown in zip(race.agents, playground.menu(race)["agents"], strict=True):
        names: dict[str, Any] = {"edugym": edugym, "math": math, "mdp": mdp}
        names["mdp"] = eval(shown["seen"] or "mdp", names)
        listed = "".join(f", {name}={value}" for name, value in shown["settings"])
        pasted = eval(f"edugym.{shown['kind']}.create(mdp{listed})", names)
        seen = agent.view.seen(mdp)
        raced = agent.make(seen)
        assert repr(names["mdp"]) in repr(seen)  # which may be within a table
        assert repr(pasted) == repr(raced)
        assert np.shape(pasted.Q) == np.shape(raced.Q)


SLIDERS = {"learning_rate": 0.3, "discount": 0.7, "epsilon": 0.2}


@each_race
def test_every_agent_takes_the_sliders_that_it_says(race: Race) -> None:
    """The page makes it with these settings, so Python must take them; a kernel has a slot for each."""
    mdp = race.mdp(race.strength.first)
    for agent in race.agents:
        moved = {name: SLIDERS[name] for name in agent.takes}
        given = {**agent.settings, **{name: value for name, value in moved.items() if name != "epsilon"}}
        if "epsilon" in moved:
            given["exploration"] = edugym.EpsilonGreedy(moved["epsilon"])
        made = agent.kind.create(agent.view.seen(mdp), **given)
        assert all(getattr(made, name) == value for name, value in moved.items() if name != "epsilon")
        assert "epsilon" not in moved or made.exploration.epsilon == moved["epsilon"]


@each_race
@pytest.mark.parametrize("k", [0, -1])
def test_every_cell_is_in_the_picture(race: Race, k: int) -> None:
    """And every observation has a cell and a layer of its own, but those that cannot be."""
    mdp = race.mdp(range(len(race.strength.values))[k])
    scene = MAPS[race.environment].scene(mdp, first_state(mdp))
    for view in dict.fromkeys(agent.view for agent in race.agents):
        seen = view.places(mdp)
        places = table(MAPS[race.environment], mdp, seen)
        assert places["rows"] % len(places["cell"]) == 0
        assert len(places["cell"]) == len(places["layer"]) == math.prod(places["sizes"])
        assert max(places["cell"]) == len(places["cells"]) - 1
        shown = [spot for spot in zip(places["cell"], places["layer"], strict=True) if spot[0] >= 0]
        assert len(set(shown)) == len(shown) > 0
        if race is TRASHBOT:
            continue  # the arm's reach is larger than the picture
        for x, y, width, height in places["cells"]:
            assert -0.01 <= x <= x + width <= scene.width + 0.01
            assert -0.01 <= y <= y + height <= scene.height + 0.01


@pytest.mark.parametrize(
    "race",
    [
        pytest.param(race, id=race.environment, marks=[pytest.mark.slow] * (race.environment == "Supermarket"))
        for race in RACES
    ],
)
def test_every_state_has_its_picture(race: Race) -> None:
    """Background and parts together are what the environment draws, for states met in a game."""
    mdp, where = race.mdp(race.strength.first), MAPS[race.environment]
    scene = scenery(where, mdp)
    if "moves" in scene:
        return
    rng = np.random.default_rng(0)
    state = mdp.initial(rng)
    for _ in range(200):
        key = key_of(where, mdp, state)
        if race.environment == "MemoryCorridor" and state.length > 10:
            state = mdp.initial(rng)
            continue
        drawn = elements(where.scene(mdp, state))
        shown = [scene["parts"][k] for k in scene["moments"][key]]
        assert [element for element in drawn if element in shown] == shown
        assert all(element in shown or element in scene["background"] for element in drawn)
        state = mdp.transition(state, int(rng.integers(mdp.action_space.n)), rng)
        if mdp.terminal(state):
            state = mdp.initial(rng)


@pytest.mark.parametrize("race", [race for race in RACES if race.is_finite], ids=lambda race: race.environment)
def test_the_optimum_is_the_one_that_the_environment_knows(race: Race) -> None:
    """The exact model and the environment's own sentence agree."""
    mdp = race.measured(race.mdp(race.strength.first))
    assert playground.optimum(mdp) == pytest.approx(mdp.reward_threshold)


def test_the_random_streams_are_those_of_train() -> None:
    """State and increment of each, in words of 64 bits."""
    words = playground.random_streams()[7][2]
    low, high, inc_low, inc_high = (int(word, 16) for word in words)
    state = streams(7)[2].bit_generator.state["state"]
    assert (low | high << 64, inc_low | inc_high << 64) == (state["state"], state["inc"])


def test_a_plan_says_what_a_kernel_is_called_with() -> None:
    """Arrays that are one are one; infinity is text; each slot has a content."""
    values = np.array([1.0, math.inf])
    call = kernels.Call(max, (3, values, (values, np.zeros(2, np.int64)), 0.5, True))
    made = playground.plan(call, kernels.Manifest("", [], 9))
    assert made["slots"] == [3, "@0", 2, "@0", 2, "@1", 2, 0.5, 1]
    assert made["arrays"] == [["float64", 2, [1.0, "Infinity"]], ["int64", 2, [0]]]
    with pytest.raises(ValueError, match="8 slots"):
        playground.plan(call, kernels.Manifest("", [], 8))
