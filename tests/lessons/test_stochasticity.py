"""Stochasticity in Golf: the claims hold with other seeds than those the lesson shows."""

import numpy as np
import pytest

from edugym.envs.golf import Golf
from edugym.lessons.stochasticity import (
    AVERSE,
    LEVEL,
    NEUTRAL,
    SEEKING,
    Player,
    learn,
    play,
)
from edugym.lessons.stochasticity.exact import crossing, from_the_tee, interpolated


def test_with_little_noise_it_takes_two_hits() -> None:
    """A drive leaves 3.5 cells and a chip then reaches the green; so does the other order. A putt costs a hit."""
    worth = from_the_tee(0.002)
    assert worth["drive"] == pytest.approx(0.9, abs=0.002)
    assert worth["chip"] == pytest.approx(0.9, abs=0.002)
    assert worth["putt"] == pytest.approx(0.8, abs=0.01)


def test_exact_play_against_samples() -> None:
    """A player who drives from the tee and then follows the best swing for the distance cannot beat the exact value.

    A simple player who sees where the ball lies comes close to it.
    """
    golf, rng = Golf.create(), np.random.default_rng(0)
    returns = []
    for _ in range(4_000):
        state, total = golf.initial(rng), 0.0
        while not golf.terminal(state):
            left = np.hypot(golf.width / 2 - state.x, golf.length - golf.width / 2 - state.y)
            action = 2 if left > 8.0 else 1 if left > 3.0 else 0
            next_state = golf.transition(state, action, rng)
            total += golf.reward(state, action, next_state, rng)
            state = next_state
        returns.append(total)
    exact = from_the_tee(LEVEL)["drive"]
    assert exact - 0.02 < np.mean(returns) < exact + 0.02


def test_the_grid_is_fine_enough() -> None:
    """Half as many places on each side change the value of the best swing by less than 0.001."""
    assert from_the_tee(LEVEL, 0.25)["drive"] == pytest.approx(from_the_tee(LEVEL)["drive"], abs=0.001)
    worth = from_the_tee(crossing())
    assert worth["drive"] == pytest.approx(worth["chip"], abs=1e-3)


def test_interpolated() -> None:
    """On the grid its values, and between them the mean."""
    values = np.array([[0.0, 1.0, 2.0], [4.0, 5.0, 6.0], [0.0, 0.0, 0.0]])
    places = np.array([0.0, 0.0, 0.5, 0.5]), np.array([0.0, 0.5, 0.0, 0.5])
    assert interpolated(values, *places).tolist() == [0.0, 0.5, 2.0, 2.5]


def test_player_counts_hits() -> None:
    """Its score has lost games first, then those won with 1, 2, ... hits."""
    task = Golf.create()
    player = Player.create(task, np.zeros((task.width * task.length, 3)))
    for reward, terminated in ((-1.0, True), (0.0, False), (0.9, True), (0.7, True), (0.1, True), (1.0, True)):
        player.learn(reward, terminated)
    assert player.score[0].tolist() == [1, 1, 1, 0, 1, 0, 0, 0, 0, 0, 1]


def test_playing_changes_nothing_and_agrees_with_the_evaluation() -> None:
    """The mean of the score is the return of the greedy policy."""
    results = learn(n_steps=20_000, repetitions=2, evaluation_episodes=2_000, risks={NEUTRAL: 0.0})
    before = [agent.Q.copy() for agent in results.complete_agents(NEUTRAL).values()]
    played = play(results)[NEUTRAL]
    assert played.mean == pytest.approx(results.final(NEUTRAL), abs=0.06)
    for agent, Q in zip(results.complete_agents(NEUTRAL).values(), before, strict=True):
        assert (agent.Q == Q).all()


def test_without_noise_there_is_no_risk() -> None:
    """Negative control: all three find two hits, and lose no ball."""
    results = learn(level=0.0, n_steps=60_000, repetitions=3)
    for method in (AVERSE, NEUTRAL, SEEKING):
        played = play(results, level=0.0)[method]
        assert played.lost.tolist() == [0.0] * 3
        assert played.spread == pytest.approx(0.0, abs=1e-6)
