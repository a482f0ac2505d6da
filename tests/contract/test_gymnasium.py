"""Every environment keeps Gymnasium's contract, at its defaults, at the extremes and between them."""

import copy
import json
import math
import os
import pickle
import subprocess
import sys
from operator import attrgetter
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium import spaces
from gymnasium.envs.registration import EnvSpec
from gymnasium.error import ResetNeeded
from gymnasium.utils.env_checker import check_env
from gymnasium.wrappers import TimeLimit
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from edugym.adapters.registration import ENVIRONMENTS, Entry, parameters_of
from edugym.checks.interfaces import step_limit
from edugym.checks.parameters import in_short
from tests.contract.parameters import PARAMETERS, Keywords
from tests.contract.play import Env, Player, every_corner, every_environment, plain

RENDER_MODES = [None, "ansi", "rgb_array", "human"]


def make(entry: Entry, **keywords: Any) -> Env:
    """An environment as its user gets it, all of Gymnasium's wrappers around it."""
    env: Env = gymnasium.make(entry.id, **keywords)
    env.unwrapped.metadata = {**env.unwrapped.metadata, "render_fps": math.inf}  # no waiting between two pictures
    return env


@every_environment
def test_check_env(entry: Entry) -> None:
    """Gymnasium's own checker finds nothing to say (warnings are errors here): without a mode it draws in each one."""
    for keywords, mode in (*(({}, mode) for mode in RENDER_MODES), (PARAMETERS[entry.name].corners[-1], None)):
        env: Any = make(entry, **keywords, render_mode=mode)
        if step_limit(env.unwrapped.mdp) != 1:  # Gymnasium's checker takes a limit of one step for a mistake
            check_env(env.unwrapped, skip_render_check=mode is not None)
        env.close()


@every_corner
def test_make(entry: Entry, keywords: Keywords) -> None:
    """`gymnasium.make` gives the same, in wrappers that check every step; so does its specification, read as JSON."""
    env = make(entry, **keywords)
    assert env.spec is not None
    spec = EnvSpec.from_json(env.spec.to_json())
    assert spec.kwargs == env.spec.kwargs == keywords
    bare = entry.load()(**keywords)
    seen = Player(bare, entry.name).play(50)
    assert Player(env, entry.name).play(50) == Player(gymnasium.make(spec), entry.name).play(50) == seen
    assert env.spec.max_episode_steps == step_limit(bare.mdp)
    assert not isinstance(env, TimeLimit)  # the environment keeps its limit itself


@every_environment
@given(data=st.data())
@settings(max_examples=60, suppress_health_check=[HealthCheck.too_slow])
def test_observations(entry: Entry, data: st.DataObject) -> None:
    """Under any valid parameters every observation lies in its space, and the rest of a step is what it has to be."""
    env = entry.load()(**data.draw(PARAMETERS[entry.name].valid))
    player = Player(env, entry.name, seed=data.draw(st.integers(0, 1000)))
    limit = getattr(env.mdp, "max_steps", math.inf)
    steps = 0
    for _ in range(60):
        assert env.observation_space.contains(player.observation)
        player.observation, reward, terminated, truncated, player.info = env.step(player.choose())
        steps += 1
        assert env.observation_space.contains(player.observation)
        assert (type(reward), type(terminated), type(truncated)) == (float, bool, bool)
        assert math.isfinite(reward)
        assert terminated == env.mdp.terminal(env.state)
        assert truncated == (steps == limit and not terminated)
        assert env.steps == steps <= limit
        if terminated or truncated:
            player.observation, player.info = env.reset()
            assert not env.mdp.terminal(env.state)
            steps = 0


@every_corner
def test_what_the_mdp_itself_shows(entry: Entry, keywords: Keywords) -> None:
    """Whole numbers where its space has whole numbers, and else real ones; the environment only takes them over."""
    mdp, rng = entry.load()(**keywords).mdp, np.random.default_rng(0)
    seen, space = np.asarray(mdp.observation(mdp.initial(rng), rng)), mdp.observation_space
    assert (seen.shape, seen.dtype.kind in "iu") == (space.shape, space.dtype.kind in "iu")


@every_corner
def test_seeds(entry: Entry, keywords: Keywords) -> None:
    """A seed repeats everything after it; where there is chance, different seeds differ, and elsewhere they do not."""

    def play(reset_seed: int) -> str:
        player = Player(make(entry, **keywords), entry.name)
        player.observation, player.info = player.env.reset(seed=reset_seed)
        return str([plain((player.observation, player.info)), *player.play(40)])

    runs = [play(seed) for seed in range(4)]
    assert [play(seed) for seed in range(4)] == runs
    if not keywords:
        chance = len(set(runs)) > 1
        assert chance == PARAMETERS[entry.name].random, "40 steps of play must show the chance: see `Parameters.random`"


@every_environment
def test_random_stream_goes_on(entry: Entry) -> None:
    """A reset without a seed does not start the random stream anew, and a seed gives a stream like Gymnasium's own."""
    env = make(entry)
    player = Player(env, entry.name, seed=3)
    drawn = env.unwrapped.np_random.bit_generator.state
    player.play(100)
    assert (plain(env.unwrapped.np_random) != plain(drawn)) == PARAMETERS[entry.name].random
    before = plain(env.unwrapped.np_random)
    env.reset(seed=3)
    assert plain(env.unwrapped.np_random) == plain(drawn)
    assert (plain(env.unwrapped.np_random) != before) == PARAMETERS[entry.name].random


def digests() -> dict[str, str]:
    """What is seen in each environment, with another layout where there is one."""
    layouts = {e.name: {"layout_seed": 7} if "layout_seed" in parameters_of(e.load()) else {} for e in ENVIRONMENTS}
    return {e.name: repr(Player(e.load()(**layouts[e.name]), e.name, seed=5).play(200)) for e in ENVIRONMENTS}


def test_one_task_in_every_process() -> None:
    """An id, its parameters and a seed name one fixed run, also in another process."""
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path)), "PYTHONHASHSEED": "77"}
    program = f"import json; from {__name__} import digests; print(json.dumps(digests()))"
    command = [sys.executable, "-c", program]
    there = subprocess.run(command, env=environment, capture_output=True, text=True, check=True).stdout
    assert json.loads(there) == digests()


@pytest.mark.parametrize(
    "entry", [e for e in ENVIRONMENTS if "layout_seed" in parameters_of(e.load())], ids=attrgetter("name")
)
def test_layout_seed(entry: Entry) -> None:
    """A layout seed fixes the task, which no seed of `reset` changes; other layout seeds give other tasks."""
    table = PARAMETERS[entry.name]

    def task(**keywords: Any) -> str:
        env = entry.load()(**table.layout, **keywords)
        return repr(plain((tuple(env.mdp), env.finite_model.rewards if table.finite else None)))

    layouts = [task(layout_seed=seed) for seed in range(10)]
    assert len(set(layouts)) > 5
    assert layouts == [task(layout_seed=seed) for seed in range(10)]
    assert layouts[0] == task()
    env = entry.load()(layout_seed=4)
    before = plain(tuple(env.mdp))
    for seed in range(5):
        env.reset(seed=seed)
        assert plain(tuple(env.mdp)) == before


@every_corner
def test_copies_continue_alike(entry: Entry, keywords: Keywords) -> None:
    """A copy, and what was pickled and read again, continue an episode as the environment itself does."""
    player = Player(make(entry, **keywords), entry.name, seed=11)
    player.play(7)
    copied, restored = copy.deepcopy(player), pickle.loads(pickle.dumps(player))
    seen = player.play(60)
    assert copied.play(60) == seen
    assert restored.play(60) == seen
    assert copied.bare.state is not player.bare.state or isinstance(player.bare.state, int | tuple)
    pictures = [one.bare.scene()._repr_svg_() for one in (player, copied, restored)]
    assert pictures == [pictures[0]] * 3


def bad_actions(space: spaces.Space[Any]) -> list[Any]:
    """What is not in an action space."""
    inside = space.sample()
    wrong = [None, "left", math.nan, [inside, inside], {"action": inside}, np.array([[inside]])]
    if isinstance(space, spaces.Discrete):
        n = int(space.n)
        wrong += [-1, n, n + 3, 10**30, -(10**30), 0.0, 0.5, [0]]
        return [*wrong, np.float64(0), np.int64(n), np.int8(-1), np.array([0])]
    if isinstance(space, spaces.MultiDiscrete):
        return [*wrong, 0, inside[:-1], inside.astype(float), space.nvec, -np.ones_like(inside)]
    assert isinstance(space, spaces.Box)
    return [*wrong, 0.0, inside[:-1], np.full_like(inside, math.nan), np.full_like(inside, math.inf)]


@every_corner
def test_bad_actions(entry: Entry, keywords: Keywords) -> None:
    """An action outside the action space raises a ValueError that names both, and nothing happens."""
    env = entry.load()(**keywords)
    player = Player(env, entry.name)
    before = plain((env.state, env.steps, env.last_action, env.np_random))
    for action in bad_actions(env.action_space):
        with pytest.raises(ValueError, match="is not in the action space") as caught:
            pytest.fail(f"{action!r} is taken as an action: {env.step(action)}")
        assert in_short(action) in str(caught.value)
        assert str(env.action_space) in str(caught.value)
        assert plain((env.state, env.steps, env.last_action, env.np_random)) == before
    player.play(5)


@every_environment
def test_reset_is_needed(entry: Entry) -> None:
    """A step before the first reset, and after the end of an episode until the next reset, raises ResetNeeded."""
    env = entry.load()()
    for call in (lambda: env.step(env.action_space.sample()), env.render):
        with pytest.raises(ResetNeeded, match="before the first reset"):
            call()
    player = Player(env, entry.name)
    for _ in range(3):
        over = False
        while not over:
            player.observation, _, terminated, truncated, player.info = env.step(player.choose())
            over = terminated or truncated
        before = plain((env.state, env.steps, env.np_random))
        for _ in range(2):
            with pytest.raises(ResetNeeded, match="of a finished episode"):
                env.step(env.action_space.sample())
        assert plain((env.state, env.steps, env.np_random)) == before
        player.observation, player.info = env.reset()


@every_environment
@pytest.mark.parametrize("mode", ["ansi", "rgb_array", "human"])
def test_rendering_changes_nothing(entry: Entry, mode: str) -> None:
    """Drawing, as often as one likes, leaves the episode and its random stream as they are."""
    drawn, undrawn = (Player(make(entry, render_mode=m), entry.name, seed=9) for m in (mode, None))
    for _ in range(8):
        for _ in range(2):
            frame = drawn.env.render()
            drawn.bare.scene()
        assert drawn.play(1) == undrawn.play(1)
        assert plain(drawn.bare.np_random) == plain(undrawn.bare.np_random)
    if mode == "ansi":
        assert str(frame).strip()
    elif mode == "rgb_array":
        assert isinstance(frame, np.ndarray)
        assert (frame.dtype.name, frame.ndim, frame.shape[2]) == ("uint8", 3, 3)
    else:
        assert frame is None
        copied = copy.deepcopy(drawn)  # without its window
        assert copied.play(2) == drawn.play(2)
        copied.env.close()
    drawn.env.close()
    drawn.env.close()


@every_corner
def test_pictures_at_the_extremes(entry: Entry, keywords: Keywords) -> None:
    """There is a picture of every task; before the first reset always the same, of a state in which one can begin."""
    env = entry.load()(**keywords, render_mode="ansi")
    pictures = {env.scene()._repr_svg_() for _ in range(3)}
    player = Player(env, entry.name)
    for _ in range(30):
        assert env.render().strip()
        player.play(1)
    env.reset(seed=0)
    env.state = env.mdp.initial(np.random.default_rng(0))
    assert pictures == {env.scene()._repr_svg_()}
