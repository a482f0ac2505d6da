"""The amount of signal on Tamagotchi: what words tell, who obeys them, and what is measured."""

import math
from types import SimpleNamespace
from typing import Any

import gymnasium
import numpy as np
import pytest

from edugym.envs.tamagotchi import Tamagotchi
from edugym.rendering.scene import Polygon
from edugym_course.lessons.signal import figures, methods, moody, pictures, players, words
from tests.course.lessons.made_up import made_up
from tests.experiments.figures.samples import new_axes


def test_information() -> None:
    """A word without noise tells which of four needs it is; longer messages tell more, but never more than the need."""
    assert words.information(0.0) == pytest.approx(2.0, abs=0.01)
    assert words.information(0.0, vocab_size=2) == pytest.approx(1.0, abs=0.01)
    assert words.information(0.1, vocab_size=64) == words.information(0.1)
    assert words.information(0.0, 8) == pytest.approx(words.information(0.0))
    for tau in (0.0, 0.05, math.inf):
        joint = words.joint_table(tau)
        assert joint.sum() == pytest.approx(1.0)
        assert words.bits(joint) == pytest.approx(words.information(tau), abs=1e-9)


def test_what_a_toy_says() -> None:
    """The wanted action is one with the lowest variable; the words of an obeyed toy carry far more."""
    for obeyed in (False, True):
        states = words.states_met(Tamagotchi.create(0.1), obeyed)
        assert sum(states.values()) == pytest.approx(1.0)
        assert all(variables[wanted] == min(variables) for variables, wanted in states)
    clear = words.joint_table(0.0, obeyed=True)
    assert np.array_equal(clear, np.eye(4) * clear.sum(axis=1))
    for tau, bit, right in ((0.02, 0.84, 0.76), (0.05, 0.46, 0.63), (0.1, 0.28, 0.54)):
        heard = words.joint_table(tau, obeyed=True)
        assert words.bits(heard) == pytest.approx(bit, abs=0.01)
        assert np.trace(heard) == pytest.approx(right, abs=0.01)


@pytest.mark.slow
def test_players() -> None:
    """A voter takes the need that most words name; without noise it gets the optimum, and so do turns, nearly."""
    rng = np.random.default_rng(0)
    message = np.array([100, 2, 5, 1, 0])  # synonyms count too; after the words that count none does
    assert players.Voter.create(None, heard=4).act(message, rng) == 1
    assert players.Voter.create(None, heard=1).act(message, rng) == 2
    assert {players.Voter.create(None, heard=2).act(message, rng) for _ in range(50)} == {1, 2}
    for length in (1, 3):
        assert methods.vote(0.0, length, 1, repetitions=2) == pytest.approx([methods.OPTIMUM] * 2, abs=0.01)
    blind = methods.play(players.RoundRobin.create, repetitions=2, parameters={"tau": math.inf})
    assert (blind / methods.OPTIMUM > 0.985).all()
    way = [1, 1, 2, 1, 2, 2]
    assert methods.walk(gymnasium.make("FrozenLake-v1", is_slippery=False), way, episodes=3) == 1.0
    assert methods.walk(gymnasium.make("FrozenLake-v1", is_slippery=True), way, episodes=50) < 0.2


def test_a_mood_lowers_one_variable() -> None:
    """Each of the four as often; the others stay as the toy left them, and none falls below 0."""
    toys: Any = moody.moody_toy(1.0, 20)
    fell = np.zeros(4)
    start = toys.initial(np.random.default_rng(0))._replace(variables=(80, 60, 40, 22), wanted=3)
    for seed in range(100):
        toy = toys.transition(start, 0, np.random.default_rng(seed))
        calm = toys.mdp.transition(start, 0, np.random.default_rng(seed))
        drops = np.subtract(calm.variables, toy.variables)
        fell += drops > 0
        assert sorted(drops) in ([0, 0, 0, 20], [0, 0, 0, 7])
        assert (drops == 7).tolist() == [False, False, False, drops[3] > 0]
    assert fell.min() > 15


def test_the_second_half_of_training() -> None:
    """The last three of five points, whose mean, median and share below 5 count in lesson 6."""
    results = made_up(
        {"Q-learning": [{0: 0.0, 10: 1.0, 20: 5.0, 30: 9.0, 40: 2.0}, dict.fromkeys(range(0, 50, 10), 4.0)]}, 40
    )
    assert methods.late(results, "Q-learning").tolist() == pytest.approx([16 / 3, 4.0])
    assert methods.median_late(results).tolist() == [5.0, 4.0]
    assert methods.time_below(results, "Q-learning", 5.0).tolist() == pytest.approx([1 / 3, 1.0])
    assert methods.after(results, 30).tolist() == [9.0, 4.0]


def test_how_words_are_answered() -> None:
    """Half of the players obey, the others take 1 for 0 and 0 for 1; each word has a row, each action a column."""
    obeys, confused = (
        SimpleNamespace(greedy=lambda row, rng, of=of: of[row % 4]) for of in ((0, 1, 2, 3), (1, 0, 2, 3))
    )
    shares = [
        figures.answers(made_up({"Q-learning": [{10: 0.0}]}, agents={"Q-learning": [agent]}), 0.0).shares
        for agent in (obeys, confused)
    ]
    assert shares[0].tolist() == np.eye(4).tolist()
    assert shares[1][:2].tolist() == np.eye(4)[[1, 0]].tolist()
    bars: list[Any] = [*figures.Greedy(np.array([[0.1, 0.2, 0.3, 0.4], [0.4, 0.3, 0.2, 0.1]])).draw(new_axes()).patches]
    assert [(round(bar.get_x(), 6), round(bar.get_width(), 6)) for bar in bars[::2]] == [
        (0, 0.1), (0.1, 0.2), (0.3, 0.3), (0.6, 0.4),
    ]  # fmt: skip
    assert [bar.get_y() + bar.get_height() / 2 for bar in bars[:2]] == [0.0, 1.0]


@pytest.mark.parametrize("tau", [0.0, 0.05])
def test_both_counts_of_bits_on_one_axis(tau: float) -> None:
    """The marks stand where the bits are, and the title tells both."""
    scene = pictures.bits_axis(tau)
    marks = [np.mean([x for x, _ in shape.points]) for shape in scene.shapes if isinstance(shape, Polygon)]
    carried = [abs(words.bits(words.joint_table(tau, obeyed=obeyed))) for obeyed in (False, True)]
    assert marks == pytest.approx([pictures.LEFT + pictures.LENGTH * one / 2 for one in carried])
    assert all(f"{one:.2f} bit" in scene.title for one in carried)
