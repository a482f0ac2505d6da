"""Supermarket: a walk that a person can follow, every move, the noise of the model, and the clock."""

import pickle
from functools import cache
from math import inf, nan
from typing import Any

import numpy as np
import pytest
from gymnasium.error import ResetNeeded
from hypothesis import strategies as st

from edugym.envs.supermarket import MAP, Countdown, Supermarket, SupermarketEnv
from edugym.exact.model import finite_model
from edugym.exact.value_iteration import value_iteration
from tests.contract.described import LAYOUT_SEEDS, NO_STEPS, NO_WHOLE_NUMBER, Parameters, refused


@cache
def shopping() -> dict[int, int]:
    """The best action in every state of the supermarket."""
    model = finite_model(Supermarket.create())
    return dict(zip(model.states, value_iteration(model).Q.argmax(axis=1).tolist(), strict=True))


PARAMETERS = Parameters(
    valid=st.fixed_dictionaries(
        {"step_timeout": st.floats(0, 1e-5), "noise": st.floats(0, 10)},
        optional={"max_steps": st.integers(1, 60), "layout_seed": LAYOUT_SEEDS},
    ),
    corners=(
        {},
        {"step_timeout": 0.0005},
        {"noise": 1e6, "layout_seed": 2**63},
        {"noise": 1, "max_steps": 1},
    ),
    bad=(
        *refused("step_timeout", -0.1, 3601, inf, nan, "0", None, True),
        *refused("noise", -0.1, inf, nan, "0", None, True),
        *refused("max_steps", None, *NO_STEPS),
        *refused("layout_seed", -1, *NO_WHOLE_NUMBER),
    ),
    finite=({},),
    layout={"noise": 1.0},
    random=False,
    informed=lambda _, env: shopping()[env.state],
)


MOVES = {"U": 0, "D": 1, "L": 2, "R": 3}
BEST_WALK = "DRRRRRRRDDDLLLDULLLDDDDRRRRRRD"
ITEMS = {(1, 8): 0, (7, 2): 1, (5, 5): 2}


def ravelled(y: int, x: int, *items: int) -> int:
    """The number of a state, as the specification says it."""
    return int(np.ravel_multi_index((y, x, *items), (10, 10, 2, 2, 2)))


def walk(env: SupermarketEnv, moves: str) -> list[tuple[Any, ...]]:
    """What each step gives: observation, reward, terminated, truncated."""
    return [env.step(MOVES[move])[:4] for move in moves]


def test_map() -> None:
    """The map of the specification, entrance, exit, walls and items."""
    rows = MAP.split()
    places = {(y, x): cell for y, row in enumerate(rows) for x, cell in enumerate(row)}
    assert {cell: place for place, cell in places.items() if cell in "se123"} == {
        "s": (0, 1),
        "e": (9, 8),
        **{str(item + 1): place for place, item in ITEMS.items()},
    }
    assert [(len(row), row.count("#")) for row in rows] == [(10, walls) for walls in (9, 2, 2, 7, 2, 4, 4, 4, 2, 9)]


def test_best_walk() -> None:
    """All three items and the exit in 30 steps, and no fewer: 3 x 25 + 50 - 30."""
    env = SupermarketEnv()
    observation, info = env.reset(seed=0)
    assert observation == ravelled(0, 1, 0, 0, 0) == 8
    assert (info["position"].tolist(), info["collected"].tolist()) == ([0, 1], [False, False, False])
    steps = walk(env, BEST_WALK)
    assert steps[0] == (ravelled(1, 1, 0, 0, 0), -1.0, False, False)
    assert steps[7] == (ravelled(1, 8, 1, 0, 0), 24.0, False, False)
    assert steps[-1] == (ravelled(9, 8, 1, 1, 1), 49.0, True, False)
    assert (env.info()["position"].tolist(), env.info()["collected"].tolist()) == ([9, 8], [True, True, True])
    assert (len(steps), sum(reward for _, reward, _, _ in steps)) == (30, 95.0)
    assert [value_iteration(env.finite_model, horizon=steps).start for steps in (None, 30)] == [95.0, 95.0]
    assert value_iteration(env.finite_model, horizon=29).start < 95.0


def test_every_move() -> None:
    """Steps agree with the map, in every state that can be reached and for every action."""
    env, rows = SupermarketEnv(), MAP.split()
    model = env.finite_model
    assert len(model.states) == 428
    for state in model.states:
        y, x, *items = (int(part) for part in np.unravel_index(state, (10, 10, 2, 2, 2)))
        assert rows[y][x] != "#"
        assert (y, x) not in ITEMS or items[ITEMS[y, x]] == 1
        assert env.mdp.terminal(state) == (rows[y][x] == "e")
        if rows[y][x] == "e":
            continue
        for action, (dy, dx) in enumerate([(-1, 0), (1, 0), (0, -1), (0, 1)]):
            to_y, to_x, taken, reward = y + dy, x + dx, list(items), -1.0
            if to_y < 0 or rows[to_y][to_x] == "#":
                to_y, to_x = y, x
            if (to_y, to_x) in ITEMS and not taken[ITEMS[to_y, to_x]]:
                taken[ITEMS[to_y, to_x]] = 1
                reward += 25.0
            if rows[to_y][to_x] == "e":
                reward += 50.0
            env.reset()
            env.state = state
            assert env.step(action)[:3] == (ravelled(to_y, to_x, *taken), reward, (to_y, to_x) == (9, 8))


def test_noise_is_in_the_model_alone() -> None:
    """Every state and action has one error, which all forms of the model share; `step` has none."""
    exact, noisy, plain = SupermarketEnv().finite_model, SupermarketEnv(noise=2.0), SupermarketEnv()
    model = noisy.finite_model
    assert model.states == exact.states
    assert np.array_equal(model.p, exact.p)
    errors = (model.r - exact.r)[~exact.terminal]
    assert np.all(model.r[exact.terminal] == 0.0)
    n = errors.size
    assert len(np.unique(errors.round(9))) == n > 1_600
    assert abs(errors.mean()) < 4 * 2.0 / n**0.5
    assert abs(errors.std() / 2.0 - 1) < 4 / (2 * n) ** 0.5
    state, action = model.states[17], 2
    (outcome,) = noisy.descriptive_model(state, action)
    assert outcome.reward == model.r[17, 2]
    assert {noisy.generative_model(state, action).reward for _ in range(20)} == {outcome.reward}
    for env in (noisy, plain):
        env.reset(seed=0)
    assert walk(noisy, BEST_WALK) == walk(plain, BEST_WALK)
    assert np.array_equal(finite_model(noisy.mdp).rewards, exact.rewards)


def test_noise_comes_from_the_layout_seed() -> None:
    """The errors are the same each time, other ones for another layout seed, and grow with `noise`."""
    exact, env = SupermarketEnv().finite_model.r, SupermarketEnv(noise=1.0)
    before = env.finite_model.r
    env.reset(seed=123)
    for same in (env, pickle.loads(pickle.dumps(env)), SupermarketEnv(noise=1.0)):
        assert np.array_equal(same.finite_model.r, before)
    errors = [SupermarketEnv(noise=noise, layout_seed=seed).finite_model.r - exact for noise, seed in ((3, 0), (1, 1))]
    assert errors[0] == pytest.approx(3 * (before - exact))
    assert abs(np.corrcoef(errors[1].ravel(), (before - exact).ravel())[0, 1]) < 0.1


class FakeClock:
    """A clock that moves by a microsecond whenever it is looked at, and by somewhat more than asked in a sleep."""

    now, looks, asleep = 1000.0, 0, 0.0

    def __call__(self) -> float:
        """Look at it."""
        self.now += 1e-6
        self.looks += 1
        return self.now

    def sleep(self, seconds: float) -> None:
        """Oversleep by a tenth and 0.1 ms, as operating systems may."""
        assert seconds > 0
        self.now += 1.1 * seconds + 1e-4
        self.asleep += 1.1 * seconds + 1e-4


def timed(seconds: float) -> tuple[SupermarketEnv, FakeClock]:
    """An environment with such a clock, started."""
    env, clock = SupermarketEnv(step_timeout=seconds), FakeClock()
    assert env.time_until_step() == 0.0
    env.countdown = Countdown(env.countdown.seconds, clock, clock.sleep)
    env.reset(seed=0)
    return env, clock


@pytest.mark.parametrize("seconds", [0.0, 0.0001, 0.001, 2.0, 60.0])
def test_step_blocks(seconds: float) -> None:
    """A step is done that many seconds after the last return, to a millisecond, but for the time spent planning."""
    env, clock = timed(seconds)
    for planning in (0.0, 0.75 * seconds, 3 * seconds):
        returned, slept = clock.now, clock.asleep
        clock.now += planning
        left = max(0.0, seconds - planning)
        assert env.time_until_step() == pytest.approx(left, abs=1e-5)
        env.step(1)
        assert max(returned + seconds, returned + planning) <= clock.now + 1e-9
        assert clock.now == pytest.approx(returned + planning + left, abs=1e-3)
        assert clock.asleep - slept >= left - 0.0004
    assert clock.looks < 1500


def test_what_is_not_allowed_need_not_wait() -> None:
    """An action outside the action space, or a step too many, is refused at once."""
    env, clock = timed(5.0)
    with pytest.raises(ValueError, match="action 4 is not in the action space"):
        env.step(4)
    assert clock.asleep == 0.0
    assert env.time_until_step() > 4.9
    walk(env, BEST_WALK)
    slept = clock.asleep
    with pytest.raises(ResetNeeded):
        env.step(0)
    assert clock.asleep == slept


def test_interrupted_wait(monkeypatch: pytest.MonkeyPatch) -> None:
    """Who interrupts the wait with Ctrl-C finds everything as it was, and can go on."""

    def interrupted(seconds: float) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(FakeClock, "sleep", staticmethod(interrupted))
    env, _ = timed(5.0)
    with pytest.raises(KeyboardInterrupt):
        env.step(1)
    assert (env.state, env.steps, env.last_action) == (8, 0, None)
    env.countdown = Countdown(0.0)
    assert env.step(1)[0] == ravelled(1, 1, 0, 0, 0)
