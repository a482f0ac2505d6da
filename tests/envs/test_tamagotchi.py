"""Tamagotchi: steps worked out by hand, what the toy wants and says against closed forms, and what play returns."""

import itertools
import math
from functools import partial
from math import inf, nan
from typing import Any, NamedTuple, get_args

import numpy as np
import pytest
from hypothesis import strategies as st
from scipy import stats

from edugym.adapters.registration import find
from edugym.compiled.execution import executable
from edugym.envs.tamagotchi import Tamagotchi, Toy, meaning
from edugym.exact.branching import branches
from edugym.mdp.protocol import Random
from edugym.rendering.icons import Mood, smiley
from edugym.rendering.palette import GREEN, RED
from edugym.rendering.scene import Rectangle
from edugym.training.loops import play_episodes
from tests.contract.described import NO_STEPS, NO_WHOLE_NUMBER, Parameters, refused

TamagotchiEnv: Any = find("Tamagotchi").load()

PARAMETERS = Parameters(
    valid=st.fixed_dictionaries(
        {
            "tau": st.just(0.0) | st.floats(0.001, 10) | st.just(inf),
            "max_msg_length": st.integers(1, 6),
            "vocab_size": st.integers(1, 13),
            "steps_per_episode": st.integers(1, 60),
        }
    ),
    corners=(
        {},
        {"tau": 0.05, "max_msg_length": 4, "vocab_size": 9},
        {"tau": inf, "vocab_size": 1, "max_msg_length": 2},
        {"tau": 1e-300, "vocab_size": 2, "max_msg_length": 56},
        {"tau": 1e300, "vocab_size": 2**31, "steps_per_episode": 1},
    ),
    bad=(
        *refused("tau", -0.1, -inf, nan, "0", None, True),
        *refused("max_msg_length", 0, -1, 29, *NO_WHOLE_NUMBER),
        *refused("max_msg_length", 2, vocab_size=2**31),  # at most 2^56 messages
        *refused("max_msg_length", 57, vocab_size=2),
        *refused("max_msg_length", 36, vocab_size=3),
        *refused("vocab_size", 0, -4, 2**31 + 1, *NO_WHOLE_NUMBER),
        *refused("steps_per_episode", None, *NO_STEPS),
    ),
    informed=lambda info, _: info["wanted"],
)


PLAY, SLEEP, FEED, CLEAN = range(4)
E = math.e


def task(tau: float = 0.0, max_msg_length: int = 1, vocab_size: int = 4) -> Tamagotchi:
    """A task of 100 steps."""
    return Tamagotchi(tau, max_msg_length, vocab_size, 100)


def after(variables: tuple[int, int, int, int], hp: int, wanted: int, action: int) -> tuple[Any, ...]:
    """The variables, the hit points, the reward and whether it is the end, after an action."""
    mdp, rng, state = task(), np.random.default_rng(0), Toy(variables, hp, wanted, wanted)
    next_state = mdp.transition(state, action, rng)
    return next_state.variables, next_state.hp, mdp.reward(state, action, next_state, rng), mdp.terminal(next_state)


def test_first_steps() -> None:
    """By hand, from a start at which it wants to sleep: sleep, which it wanted, then feed, which it did not."""
    env = TamagotchiEnv()
    observation, info = next(start for seed in range(100) if (start := env.reset(seed=seed))[1]["wanted"] == SLEEP)
    assert (observation.tolist(), info["variables"].tolist()) == ([100, SLEEP], [100] * 4)
    observation, reward, *_, info = env.step(SLEEP)
    assert info["variables"].tolist() == [95, 100, 95, 95]
    assert reward == pytest.approx(50 * E**-1 + 3 * 45 * E**-0.95)  # 70.6
    assert info["wanted"] in (PLAY, FEED, CLEAN)
    assert observation.tolist() == [100, info["wanted"]]
    variables, _, reward, end = after((95, 100, 95, 95), 100, CLEAN, FEED)
    assert (variables, end) == ((80, 85, 100, 80), False)  # 95 + 30 - 10 is more than 100
    assert reward == pytest.approx(2 * 30 * E**-0.8 + 35 * E**-0.85 + 50 * E**-1)


def test_order_of_what_happens() -> None:
    """The variables change by all that is due, and only then are clipped; happiness and hit points come after."""
    assert after((85, 10, 5, 50), 100, SLEEP, PLAY)[0] == (100, 0, 0, 35)  # 85 + 30 - 10; clipped first: 90
    assert after((85, 10, 5, 50), 100, PLAY, PLAY)[0] == (100, 5, 0, 45)
    for wanted, action in itertools.product(range(4), range(4)):
        expected = [40 + (30 if need == action else -5) - (0 if wanted == action else 10) for need in range(4)]
        assert after((40, 40, 40, 40), 100, wanted, action)[0] == tuple(expected)


def test_hit_points() -> None:
    """A tenth of the happiness is added, what comes out is rounded down and stays from 0 to 100; 0 is the end."""
    variables, hp, reward, end = after((90, 90, 90, 90), 50, FEED, FEED)
    assert (variables, hp, end) == ((85, 85, 100, 85), 56, False)  # 50 + 6.327
    assert reward == pytest.approx(3 * 35 * E**-0.85 + 50 * E**-1)
    variables, hp, reward, end = after((0, 0, 0, 0), 50, PLAY, SLEEP)
    assert (variables, hp, end) == ((0, 20, 0, 0), 32, False)  # 50 - 17.456 = 32.54
    assert reward == pytest.approx(-150 - 30 * E**-0.2)
    for hp, left in ((19, 1), (18, 0), (3, 0)):  # 0.54 is less than a hit point
        assert after((0, 0, 0, 0), hp, PLAY, SLEEP)[1::2] == (left, left == 0)
    assert after((100, 100, 100, 100), 99, PLAY, PLAY)[1::2] == (100, False)


def test_what_it_wants() -> None:
    """The lowest variable; among equals each with the same probability, exactly."""
    mdp = task()
    for levels in itertools.product((10, 40, 70), repeat=4):  # in every order, also where a higher level comes first
        variables = (levels[0], levels[1], levels[2], levels[3])
        lowest = [need for need in range(4) if variables[need] == min(variables)]
        chances = dict.fromkeys(lowest, 1 / len(lowest))
        assert distribution(mdp, variables, "wanted") == pytest.approx(chances), variables
    starts = [mdp.initial(np.random.default_rng(seed)).wanted for seed in range(2_000)]
    assert stats.chisquare(np.bincount(starts, minlength=4)).pvalue > 0.001


def distribution(mdp: Tamagotchi, variables: tuple[int, int, int, int], part: str) -> dict[int, float]:
    """The exact probabilities of a part of the state that follows from these variables."""
    total: dict[int, float] = {}
    for p, state in branches(partial(mdp.settled, variables, 50)):
        value = getattr(state, part)
        total[value] = total.get(value, 0.0) + p
    return {value: p for value, p in total.items() if p > 0}


def closed_form(variables: tuple[int, int, int, int], wanted: int, tau: float) -> np.ndarray[Any, Any]:
    """The softmax of the urgencies, by NumPy."""
    u = np.exp(-np.array(variables) / 100)
    u[wanted] += 1e-6
    weights = np.exp((u - u.max()) / tau)
    p: np.ndarray[Any, Any] = weights / weights.sum()
    return p


@pytest.mark.parametrize("tau", [1e-300, 1e-7, 0.01, 0.05, 0.3, 2.0, 1e300, math.inf])
def test_words(tau: float) -> None:
    """A word is about need i with probability softmax(u/tau), exactly."""
    variables = (70, 55, 90, 60)
    exact = distribution(task(tau), variables, "message")
    expected = closed_form(variables, SLEEP, tau)
    assert [exact.get(word, 0.0) for word in range(4)] == pytest.approx(expected, abs=1e-12)


def test_ties_in_the_message() -> None:
    """Among equals the wanted one is named: for certain as tau goes to 0, by a millionth's share else."""
    variables = (40, 40, 40, 40)
    for tau in (0.0, 1e-300, 1e-9):
        for _, state in branches(partial(task(tau).settled, variables, 50)):
            assert state.message == state.wanted
    shares = np.array([task(0.05).weight(variables, need, FEED) for need in range(4)])
    assert shares / shares.sum() == pytest.approx(closed_form(variables, FEED, 0.05), abs=1e-15)
    assert 0.25 < shares[FEED] / shares.sum() < 0.25001


@pytest.mark.parametrize("vocab_size", [1, 2, 3, 4, 5, 6, 9, 12])
def test_vocabulary(vocab_size: int) -> None:
    """With four words or more need i has the words i, i + 4, ..., each as likely; with fewer it has i mod H."""
    mdp = task(0.0, 1, vocab_size)
    for need in range(4):
        chances: dict[int, float] = {}
        for p, word in branches(partial(mdp.word, need)):
            chances[word] = chances.get(word, 0.0) + p
        words = list(range(need, vocab_size, 4)) if vocab_size >= 4 else [need % vocab_size]
        assert chances == pytest.approx({word: 1 / len(words) for word in words})


def test_message() -> None:
    """Words are independent, the first first, and kept as one number: no state holds an array."""
    mdp = task(0.3, 3, 5)
    exact = distribution(mdp, (70, 55, 90, 60), "message")
    one = distribution(task(0.3, 1, 5), (70, 55, 90, 60), "message")
    assert exact == pytest.approx({25 * a + 5 * b + c: one[a] * one[b] * one[c] for a in one for b in one for c in one})
    state = Toy((1, 2, 3, 4), 77, 0, 25 * 4 + 5 * 0 + 2)
    assert mdp.observation(state, np.random.default_rng(0)).tolist() == [77, 4, 0, 2]
    longest = TamagotchiEnv(tau=1.0, max_msg_length=28)
    observation, _ = longest.reset(seed=0)
    assert longest.state.message == sum(int(word) * 4 ** (27 - k) for k, word in enumerate(observation[1:])) > 4**26
    assert {type(part) for part in longest.state} == {int, tuple}


class Obedient(NamedTuple):
    """Does what the first word says."""

    share: float

    def act(self, state: Any, rng: Random) -> int:
        """The need that it is about, with probability `share`, else anything."""
        return int(state[1]) % 4 if rng.random() < self.share else int(rng.random() * 4)


def returns(mdp: Tamagotchi, share: float, n_episodes: int) -> tuple[float, float]:
    """The mean return of an obedient player, and half the width of its 99.9 % interval."""
    log = np.zeros(n_episodes)
    rest = (mdp, Obedient(share), 100, np.random.default_rng(0), np.random.default_rng(1), log)
    executable(play_episodes, rest, rehearsed=1)(n_episodes, *rest)
    return log.mean(), 3.3 * log.std() / math.sqrt(n_episodes)


def test_numbers_in_the_docstring() -> None:
    """What doing what it says returns as the noise grows, and what acting at random does."""
    assert returns(task(), 1.0, 20) == pytest.approx((6706.85, 0.0), abs=0.005)
    for tau, expected in ((0.02, 5993), (0.05, 3317), (0.1, 120), (math.inf, -676)):
        mean, margin = returns(task(tau), 1.0, 4_000)
        assert mean == pytest.approx(expected, abs=margin + 10)
    mean, margin = returns(task(), 0.0, 4_000)
    assert mean == pytest.approx(-676, abs=margin + 1)
    env, totals = TamagotchiEnv(tau=math.inf), []
    for seed in range(60):  # the four in turn, without a look
        env.reset(seed=seed)
        totals.append(sum(float(env.step(step % 4)[1]) for step in range(100)))
    assert np.mean(totals) == pytest.approx(6652, abs=14)


def test_meaning() -> None:
    """What a person reads in the bubble: synonyms by number, ambiguous words by all that they may mean."""
    names = ["play", "sleep", "feed", "clean"]
    assert [meaning(word, 9) for word in range(9)] == [*names, *(f"{name}2" for name in names), "play3"]
    assert [meaning(word, 3) for word in range(3)] == ["play/clean", "sleep", "feed"]
    assert [meaning(word, 2) for word in range(2)] == ["play/feed", "sleep/clean"]
    assert meaning(0, 1) == "play/sleep/feed/clean"
    assert TamagotchiEnv().named_actions() == {name: action for action, name in enumerate(names)}


def test_face() -> None:
    """It smiles above two thirds of its hit points, and is sad in the last third, where the bar is red."""
    env = TamagotchiEnv()
    env.reset(seed=0)
    for hp, mood in ((67, "happy"), (66, "flat"), (34, "flat"), (33, "sad")):
        env.state = env.state._replace(hp=hp)
        shapes = env.scene().shapes
        assert [name for name in get_args(Mood) if smiley(6.0, 7.9, 1.2, name)[-1] in shapes] == [mood]
        colours = {shape.fill for shape in shapes if isinstance(shape, Rectangle)}
        assert colours & {GREEN, RED} == {RED if mood == "sad" else GREEN}
