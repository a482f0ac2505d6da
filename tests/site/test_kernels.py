"""Kernels: in Node, with the page's own JavaScript, they do what Python does, bit for bit; a stale one is refused."""

import json
import math
import subprocess
from pathlib import Path
from typing import Any

import kernels
import linker
import numpy as np
import playground
import pytest
from offers import Agent, Race
from races import BOULDER, DIVER, RACES

import edugym
from edugym.objectives import train_vectors
from edugym.training.trainers import streams as fresh_streams
from tests.site.node import KERNELS, NODE, arrays_of, in_node, in_python

needs_node = pytest.mark.skipif(NODE is None, reason="needs Node.js: apt-get install nodejs")
PAIRS = [pytest.param(race, agent, id=f"{race.environment}-{agent.label}") for race in RACES for agent in race.agents]
EXACT = {"fmod", "pow"}
"""Functions of mathematics that have the same last bit everywhere, powers where the exponent is whole."""
SEED, STEPS, EVERY = 3, 2_000, 500
FEWER = {edugym.DQN: 600}
"""Steps of agents that are slow in the interpreter. DQN's update 16 is the first whose power browsers get wrong."""


def first_call(race: Race, agent: Agent) -> kernels.Call:
    """The call of an agent's kernel, with new tables, at the strength that is shown first."""
    return playground.call_of(race, race.mdp(race.strength.first), agent)


def check_same(race: Race, agent: Agent) -> None:
    """Tables, random streams and learning curve are the same, also between two others in the same memory.

    Where a kernel takes a sine from Node, so that a position may differ in its last digit, what the task itself keeps
    is left out: that are the first arrays.
    """
    call = first_call(race, agent)
    steps = FEWER.get(agent.kind, STEPS)
    others = {"before": [playground.random_streams()[0]], "behind": [playground.random_streams()[1]]}
    theirs, ours = in_node(call, SEED, steps, steps // 4, **others), in_python(call, SEED, steps, steps // 4)
    own = len(arrays_of(call.arguments[2].mdp)) if set(theirs.borrowed) - EXACT else 0
    assert theirs.curve == ours.curve
    assert theirs.generators == ours.generators
    assert theirs.arrays[own:] == ours.arrays[own:]


@needs_node
def test_a_kernel_does_what_python_does() -> None:
    """For one agent; the next test has all of them."""
    check_same(BOULDER, BOULDER.agents[0])


@pytest.mark.slow
@needs_node
@pytest.mark.parametrize(("race", "agent"), PAIRS)
def test_every_kernel_does_what_python_does(race: Race, agent: Agent) -> None:
    """Also where exponentials, sines and logarithms are Node's: there in runs as short as these (the page says so)."""
    check_same(race, agent)


NOTED = [
    pytest.param(race, agent, id=f"{race.environment}-{agent.label}")
    for race in RACES
    for agent in race.agents
    if first_call(race, agent).loop in kernels.NOTED
]


@pytest.mark.parametrize(("race", "agent"), NOTED)
def test_what_an_agent_knows_of_a_place_is_asked_of_it(race: Race, agent: Agent) -> None:
    """Of all places that were seen, and of no others; not of all the same."""
    call = first_call(race, agent)
    _, _, training, evaluation, values, carry = call.arguments
    for n_steps in (kernels.BEGIN, 60, kernels.SHOW):
        carry = call.loop(n_steps, 0, training, evaluation, values, carry)
    seen = training.mdp.visits[0] > 0
    assert not values[~seen].any()
    assert len({*map(tuple, values[seen])}) > 2


POWERS = """
const { power } = await import(process.argv[1])
const bases = process.argv.slice(3).map(Number), n = Number(process.argv[2])
const factors = bases.map(base => Array.from({ length: n }, (_, t) => 1 - power(base, t)))
const others = [[2, -3], [2, 0.5], [-1.5, 3], [0, 0], [1e200, 3], [1e-5, 70]]
const same = others.map(([x, n]) => power(x, n) === Math.pow(x, n))
process.stdout.write(JSON.stringify([factors, same]))
"""


@needs_node
def test_adams_corrections_are_those_of_python() -> None:
    """As long as a correction is not 1, which 1 - 0.999^t is from t = 37 450 on. Other powers are the browser's."""
    n, bases = 40_000, (0.9, 0.999)
    power = str(playground.PAGE / "power.js")
    command = [str(NODE), "--input-type=module", "-e", POWERS, power, str(n), *map(str, bases)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    factors, same = json.loads(done.stdout)
    assert factors == [[1.0 - math.pow(base, t) for t in range(n)] for base in bases]
    assert factors[1][-1] == 1.0
    assert all(same)


def draw_whole_numbers(spans: Any, rng: Any, drawn: Any) -> int:
    """Draw one number below each span, again and again."""
    for k in range(len(drawn)):
        drawn[k] = rng.integers(-3, spans[k % len(spans)] - 3)
    return 0


@pytest.mark.slow
@needs_node
def test_kernels_draw_whole_numbers_as_numpy_does() -> None:
    """Of 1 to 2^62 values, with 32 and with 64 random bits: from the same stream come the same numbers."""
    spans = np.array([1, 2, 3, 1_000, 2**32 - 1, 2**32, 2**32 + 1, 3 * 2**40, 2**62], np.int64)
    streams = playground.random_streams()[SEED][:1]
    call = kernels.Call(draw_whole_numbers, (spans, np.random.default_rng(0), np.zeros(900, np.int64)))
    made = kernels.build([call], KERNELS)
    asked = {
        "page": str(playground.PAGE),
        "file": str(KERNELS / f"{call.fingerprint}.wasm"),
        "fingerprint": call.fingerprint,
        "plan": playground.plan(call, made[call.fingerprint]),
        "streams": streams,
    }
    script = Path(__file__).with_name("draw.mjs")
    done = subprocess.run([str(NODE), script], input=json.dumps(asked), capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    expected = np.zeros(900, np.int64)
    draw_whole_numbers(spans, fresh_streams(SEED)[0], expected)
    assert list(map(int, json.loads(done.stdout))) == expected.tolist()


@needs_node
def test_the_page_has_the_numbers_of_train() -> None:
    """What the page shows is what `edugym.train` returns, whichever way the run is cut into calls."""
    agent, mdp = BOULDER.agents[0], BOULDER.mdp(BOULDER.strength.first)
    run = edugym.train(mdp, agent.make(mdp), STEPS, seed=SEED, evaluation_episodes=BOULDER.episodes)
    curve = in_node(first_call(BOULDER, agent), SEED, STEPS, STEPS // 100, chunk=7).curve
    assert [point[:2] for point in curve] == [list(point) for point in zip(run.steps, run.returns, strict=True)]
    while_exploring = [math.nan if point[2] is None else point[2] for point in curve]
    np.testing.assert_array_equal(while_exploring, run.training_returns)


@pytest.mark.slow
@needs_node
@pytest.mark.parametrize(
    "agent",
    [agent for agent in DIVER.agents if agent.label in ("price 6", "distance", "learned price")],
    ids=lambda agent: agent.label,
)
def test_a_race_of_vectors_has_the_numbers_of_train_vectors(agent: Agent) -> None:
    """Of the learning curve a reader's line makes what the page shows, and the tables are the same."""
    assert DIVER.measure
    mdp = agent.view.seen(DIVER.mdp(DIVER.strength.first))
    run = train_vectors(mdp, agent.make(mdp), STEPS, seed=SEED)
    call = first_call(DIVER, agent)
    made = in_node(call, SEED, STEPS, STEPS // 100)
    assert [point[1] for point in made.curve] == eval(DIVER.measure.code, {"run": run}).tolist()
    assert run.agent.Q.tobytes().hex() in made.arrays


@needs_node
def test_a_stale_kernel_is_refused() -> None:
    """A kernel of another fingerprint than that asked for is not loaded, and one that exists is not made again."""
    call = first_call(BOULDER, BOULDER.agents[0])
    file = KERNELS / f"{call.fingerprint}.wasm"
    made = kernels.build([call], KERNELS), file.stat().st_mtime_ns
    assert made == (kernels.build([call], KERNELS), file.stat().st_mtime_ns)
    with pytest.raises(AssertionError, match="stale"):
        in_node(call, SEED, STEPS, EVERY, fingerprint="0" * 16)


@pytest.mark.parametrize("k", [0, -1])
@pytest.mark.parametrize("race", RACES, ids=lambda race: race.environment)
def test_strength_is_data(race: Race, k: int) -> None:
    """One kernel serves all strengths of a task: its types and its code are the same."""
    strengths = range(len(race.strength.values))
    other, first = (
        [call.fingerprint for call in playground.calls(race, at)] for at in (strengths[k], race.strength.first)
    )
    assert other == first


def test_another_code_has_another_fingerprint(monkeypatch: pytest.MonkeyPatch) -> None:
    """The fingerprint follows the code that a kernel reaches, and the types of what it is called with."""
    first = first_call(BOULDER, BOULDER.agents[0]).fingerprint
    assert first_call(BOULDER, BOULDER.agents[0]).fingerprint == first
    assert first_call(BOULDER, BOULDER.agents[1]).fingerprint != first

    def reward(self: Any, state: int, action: int, next_state: int, rng: Any) -> float:
        return 2.0 if next_state == self.height else 0.0

    monkeypatch.setattr(edugym.make_mdp("Boulder").__class__, "reward", reward)
    assert first_call(BOULDER, BOULDER.agents[0]).fingerprint != first


def test_what_is_not_asked_for_is_removed(tmp_path: Any) -> None:
    """Old kernels do not pile up."""
    for name in ("old", "new"):
        (tmp_path / f"{name}.wasm").write_bytes(linker.HEADER)
    kernels.prune(tmp_path, ["new"])
    assert [file.stem for file in tmp_path.iterdir()] == ["new"]


@pytest.mark.parametrize("value", [0, 1, 127, 128, 624_485, 2**32 - 1])
def test_numbers_are_read_as_they_were_written(value: int) -> None:
    """LEB128, the numbers of the binary format."""
    reader = linker.Reader(linker.number(value))
    assert reader.number() == value
    assert reader.over


def test_what_is_no_object_file_is_refused() -> None:
    """The linker names what it was given."""
    with pytest.raises(ValueError, match="object_file"):
        linker.linked(b"ELF", ("run",), {})
    with pytest.raises(ValueError, match="'run'"):
        linker.linked(linker.HEADER, ("run",), {})
