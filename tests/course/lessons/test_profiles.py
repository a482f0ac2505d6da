"""Lesson 15: the stored profiles that it shows, and what its checks say to those who have numbers of their own."""

from contextlib import nullcontext
from typing import Any

import pytest
from matplotlib import pyplot

from edugym import Interval, QLearning
from edugym_course.grading.errors import WrongAnswer
from edugym_course.lessons.profiles import exercises, figures, methods
from edugym_course.lessons.profiles.exercises import OWN_MISTAKE, exercise_1, exercise_2


def test_one_agent_on_all_ladders() -> None:
    """A sentence for each, and a ladder for each that it can enter, where it stands apart from the others."""
    sentences = methods.whole_profile("QLearning")
    assert [sentence.split(" (")[0] for sentence in sentences] == methods.stored().challenges
    assert sum("cannot enter" in sentence for sentence in sentences) == 2
    drawn = [panel for row in figures.all_ladders("QLearning").rows for panel in row]
    assert len(drawn) == len(sentences) - 2
    both = figures.beside_q_learning("GaussianActorCritic").rows[0][0].draw()  # which cannot enter
    assert both.get_legend_handles_labels()[1] == ["QLearning"]
    itself = figures.beside_q_learning("QLearning").rows[0][0].draw()
    assert itself.get_legend_handles_labels()[1] == ["QLearning"]
    pyplot.close("all")


def test_agents_to_choose_from_have_whole_profiles() -> None:
    """One of which some ladder is missing is not among them."""
    stored, chosen = methods.stored(), methods.stored_agents()
    assert {*chosen} >= {"QLearning", "GaussianActorCritic"}
    for agent in stored.agents:
        measured = [name for name in stored.challenges if stored.score(agent, name).n]
        assert (agent in chosen) == (len(measured) + len(stored.blank[agent]) == len(stored.challenges))


class Idle:
    """An agent that knows nothing, and needs no table for it."""

    def act(self, state: Any, rng: Any) -> int:
        """The first action."""
        return 0

    def learn(self, reward: float) -> None:
        """Learn nothing."""


def short_sum(returns: Any, random: Any, best: Any) -> float:
    """The last rung counts three and a half times, and what all count together is forgotten."""
    scores = [(r - low) / (high - low) for r, low, high in zip(returns, random, best, strict=True)]
    return float(sum(scores) + 2.5 * scores[-1]) / len(scores)


def test_a_mean_of_rungs_that_count_differently() -> None:
    """Who divides by the number of rungs hears of it."""
    with pytest.raises(WrongAnswer, match=OWN_MISTAKE):
        exercise_1(short_sum, 0, times=3.5)


@pytest.mark.parametrize(
    ("make", "says"),
    [
        (lambda environment: QLearning.create(environment, discount=0.0), "whose Q starts at 0: use your own number"),
        (lambda environment: Idle(), "without an array Q"),
        (lambda environment: type("Listed", (Idle,), {"Q": [[0.0]]})(), "without an array Q"),
    ],
)
def test_values_that_do_not_start_at_ones_own_number(make: Any, says: str) -> None:
    """It is said before anything is trained."""
    with pytest.raises(WrongAnswer) as raised:
        exercise_2(make, 0, first=0.25)
    assert says in str(raised.value)


@pytest.mark.parametrize(
    ("easy", "hard", "says"),
    [
        ((-0.1, -0.4, 0.2, 20), (-0.9, -1.0, -0.8, 20), ""),  # by chance, as far as one can tell
        ((-0.2, -0.5, 0.1, 20), (-0.9, -1.0, -0.8, 20), "it is worse in both"),
        ((-0.02, -0.03, -0.01, 20), (-0.9, -1.0, -0.8, 20), ""),
        ((-0.4, -0.5, -0.3, 20), (-0.9, -1.0, -0.8, 20), "it is worse in both"),
        ((-0.4, -0.5, -0.3, 20), (0.0, -0.1, 0.1, 20), "it is worse in Tamagotchi"),
        ((0.0, -0.1, 0.1, 20), (-0.4, -0.9, 0.1, 20), "there may be a hole in Study"),
        ((0.0, -0.1, 0.1, 20), (-0.15, -0.3, 0.0, 20), "it has no hole in Study"),
    ],
)
def test_a_hole_has_ground_around_it(easy: Any, hard: Any, says: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """It is surely worse than Q-learning in one game, by the interval, and about as good in the other."""
    gaps = {"Tamagotchi": Interval(*easy), "Study": Interval(*hard)}
    monkeypatch.setattr(exercises, "profile", lambda *_, **how: None)
    monkeypatch.setattr(exercises, "gap", lambda found, one, other, game: gaps[game])
    with nullcontext() if says == "" else pytest.raises(WrongAnswer, match=says):
        exercise_2(QLearning.create, 0)
