"""The amount of signal on Tamagotchi: the claims hold with other seeds than those the lesson shows."""

import math

import numpy as np
import pytest

from edugym.envs.tamagotchi import Tamagotchi
from edugym.lessons.signal import (
    LENGTHS,
    OPTIMUM,
    play,
    rows_of_table,
    vote,
)
from edugym.lessons.signal.players import RoundRobin, Voter
from edugym.lessons.signal.words import information, states_in_care


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


def test_states_in_care() -> None:
    """The frequencies sum to 1, and the wanted action is always one with the lowest variable."""
    states = states_in_care(Tamagotchi.create())
    assert sum(states.values()) == pytest.approx(1.0)
    assert all(variables[wanted] == min(variables) for variables, wanted in states)


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
    assert vote(0.0, 3, 3, repetitions=2) == pytest.approx([OPTIMUM, OPTIMUM], abs=0.01)
    blind = play(RoundRobin.create, repetitions=2, parameters={"tau": math.inf})
    assert (blind / OPTIMUM > 0.985).all()


def test_rows_of_table() -> None:
    """The table of four-word messages is 64 times that of one word, and that of 28 words has 7e18 rows."""
    assert rows_of_table(4) == 64 * rows_of_table(1) == 25_856
    assert f"{rows_of_table(28):.0e}" == "7e+18"
