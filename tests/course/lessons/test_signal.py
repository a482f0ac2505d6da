"""The amount of signal on Tamagotchi: the claims hold with other seeds than those the lesson shows."""

import math
from typing import Any

import gymnasium
import numpy as np
import pytest

from edugym.envs.tamagotchi import Tamagotchi
from edugym.experiments.figures import Sheet
from edugym_course.lessons.signal import figures, methods, moody
from edugym_course.lessons.signal.methods import LENGTHS, OPTIMUM, play, rows_of_table, vote
from edugym_course.lessons.signal.players import Coin, RoundRobin, Voter
from edugym_course.lessons.signal.words import bits, information, joint_table, states_met
from tests.course.lessons.figures import check_legends


def test_information_of_a_word() -> None:
    """A word without noise tells which of four needs it is, one of two words half of that, and pure noise nothing."""
    assert information(0.0) == pytest.approx(2.0, abs=0.01)
    assert information(0.0, vocab_size=2) == pytest.approx(1.0, abs=0.01)
    assert information(0.0, vocab_size=1) == pytest.approx(0.0, abs=1e-9)
    assert information(math.inf) == pytest.approx(0.0, abs=1e-9)
    assert information(0.1, vocab_size=64) == information(0.1)


def test_information_of_a_message() -> None:
    """Longer messages tell more, but less than the sum of their words, and never more than the need."""
    bits = [information(0.1, length) for length in LENGTHS]
    assert bits == sorted(bits)
    assert bits[1] < LENGTHS[1] * bits[0]
    assert information(0.0, 8) == pytest.approx(information(0.0))


def test_information_by_counting() -> None:
    """The formula agrees with the frequencies of words that the toy really says."""
    toy, rng = Tamagotchi.create(0.02), np.random.default_rng(0)
    joint = np.zeros((4, 4))
    for _ in range(300):
        state = toy.initial(rng)
        for _ in range(toy.max_steps):
            joint[state.wanted, state.message] += 1
            state = toy.transition(state, state.wanted, rng)
    joint /= joint.sum()
    independent = joint.sum(axis=1, keepdims=True) * joint.sum(axis=0)
    counted = (joint * np.log2(joint / independent)).sum()
    assert counted == pytest.approx(information(0.02), abs=0.03)


@pytest.mark.parametrize("obeyed", [False, True])
def test_states_met(obeyed: bool) -> None:
    """The frequencies sum to 1, and the wanted action is always one with the lowest variable."""
    states = states_met(Tamagotchi.create(0.1), obeyed)
    assert sum(states.values()) == pytest.approx(1.0)
    assert all(variables[wanted] == min(variables) for variables, wanted in states)


def test_an_obeyed_toy_says_clearer_things() -> None:
    """Without noise it is a toy in perfect care; with noise its words carry far more, as the lesson says."""
    assert np.array_equal(joint_table(0.0, obeyed=True), np.eye(4) * joint_table(0.0, obeyed=True).sum(axis=1))
    for tau, bit, right in ((0.02, 0.84, 0.76), (0.05, 0.46, 0.63), (0.1, 0.28, 0.54)):
        heard = joint_table(tau, obeyed=True)
        assert bits(heard) == pytest.approx(bit, abs=0.01)
        assert np.trace(heard) == pytest.approx(right, abs=0.01)


def test_voter() -> None:
    """It takes the need that most words name, synonyms included; of the words after those that count it takes none."""
    rng = np.random.default_rng(0)
    message = np.array([100, 2, 5, 1, 0])
    assert Voter.create(None, heard=4).act(message, rng) == 1
    assert Voter.create(None, heard=1).act(message, rng) == 2
    assert {Voter.create(None, heard=2).act(message, rng) for _ in range(50)} == {1, 2}


def test_players() -> None:
    """Obeying returns the optimum without noise, the first of several words is as good, and so is taking turns."""
    assert vote(0.0, 1, 1, repetitions=2) == pytest.approx([OPTIMUM, OPTIMUM], abs=0.01)
    assert vote(0.0, 3, 1, repetitions=2) == pytest.approx([OPTIMUM, OPTIMUM], abs=0.01)
    blind = play(RoundRobin.create, repetitions=2, parameters={"tau": math.inf})
    assert (blind / OPTIMUM > 0.985).all()


def test_rows_of_table() -> None:
    """The table of four-word messages is 64 times that of one word, and that of 28 words has 7e18 rows."""
    assert rows_of_table(4) == 64 * rows_of_table(1) == 25_856
    assert f"{rows_of_table(28):.0e}" == "7e+18"


def test_table_of_words() -> None:
    """Its information is that of one word."""
    for tau in (0.0, 0.05, math.inf):
        joint = joint_table(tau)
        assert joint.sum() == pytest.approx(1.0)
        assert bits(joint) == pytest.approx(information(tau), abs=1e-9)
    assert bits(np.eye(4) / 4) == 2.0


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


def test_moody_toy() -> None:
    """The optimum without moods is that of the toy; obeying without noise gets the optimum with moods, turns do not."""
    assert moody.best_return(0.0, 20) == pytest.approx(OPTIMUM, abs=0.01)
    best = moody.best_return(0.1, 20)
    obeyed = play(Voter.create, environment=moody.moody_toy(), repetitions=4)
    assert obeyed.mean() == pytest.approx(best, rel=0.01)
    assert play(RoundRobin.create, environment=moody.moody_toy(), repetitions=2).mean() < best / 4


def test_coin() -> None:
    """With two words a coin between the two meanings is better than random actions, and far from the optimum."""
    tossed = play(Coin.create, parameters={"vocab_size": 2}, repetitions=2).mean()
    assert -500 < tossed < 0


def test_blind_walk() -> None:
    """The shortest way is always right on firm ice, and hardly ever on slippery ice."""
    way = [1, 1, 2, 1, 2, 2]
    assert methods.walk(gymnasium.make("FrozenLake-v1", is_slippery=False), way, episodes=3) == 1.0
    assert methods.walk(gymnasium.make("FrozenLake-v1", is_slippery=True), way, episodes=50) < 0.2


def test_figures_of_the_lesson() -> None:
    """They draw, and the same player has the same colour everywhere."""
    brief = {"n_steps": 2_000, "evaluate_every": 500, "repetitions": 2}
    by_tau = methods.compare_noise((0.0, 0.1), **brief)
    long = {f"α = {rate}": methods.learn_long(2, rate, n_steps=2_000, repetitions=2) for rate in (0.02, 0.1)}
    memory = {
        "with": methods.learn_with_memory(**brief),
        "without": methods.learn(parameters={"vocab_size": 1}, **brief),
    }
    learned = {figures.LEARNED: {1: methods.late(by_tau[0.1], "Q-learning")}}
    panels = figures.one_word_panel(by_tau, 2), figures.messages_panel((1, 2), learned, repetitions=2)
    colours = [{line.get_label(): line.get_color() for line in panel.draw().lines} for panel in panels]
    shared = colours[0].keys() & colours[1].keys()
    assert {figures.OBEY, figures.LEARNED} <= shared
    assert all(colours[0][label] == colours[1][label] for label in shared)
    answered = figures.answers(by_tau[0.0], 0.0)
    assert answered.shares.sum(axis=1) == pytest.approx(1.0)
    sheets = [
        figures.joint_tables(),
        figures.noise_sheet(by_tau),
        figures.lengths_sheet(long, 1_800.0),
        figures.memory_sheet(memory),
        figures.vocabulary_sheet(methods.compare_vocabularies([4, 16], **brief)),
        figures.one_toy(vocab_size=2, **brief),
        Sheet("answers", [[answered]]),
    ]
    for sheet in sheets:
        assert all(ax.get_xlabel() for ax in sheet.draw().axes)
        check_legends(sheet)
    assert methods.median_late(memory["with"]).shape == (2,)
    assert methods.after(by_tau[0.0], 2_000).shape == (2,)


def test_race() -> None:
    """A player of the reader's own stands beside the others."""
    sheet = figures.race({"mine": RoundRobin.create}, (1, 2), repetitions=2)
    labels = sheet.draw().axes[0].get_legend_handles_labels()[1]
    assert "mine" in labels
