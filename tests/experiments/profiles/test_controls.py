"""The controls: random play scores 0 and the best play 1, whatever rewards, actions and states are called."""

from typing import Any, NamedTuple

import numpy as np
import pandas
import pytest

from edugym import Ladder, make_mdp, mean_interval, profile, train
from edugym.envs.trashbot.planning import ScriptedController
from edugym.experiments.profiles.ladders import GOLF, LADDERS, TAMAGOTCHI, TRASHBOT, Bounds, exact_bounds
from edugym.experiments.profiles.scores import Profile
from edugym.mdp.protocol import Random
from edugym_course.lessons.stochasticity.exact import optimum
from tests.experiments.profiles.controls import best_play, random_play
from tests.training.tasks import Ring

NAMES = [ladder.name for ladder in LADDERS]


def short(name: str, every: int = 1) -> Ladder:
    """A ladder for players who learn nothing: no training, and only some of the rungs."""
    ladder = LADDERS[NAMES.index(name)]
    strengths = ladder.strengths[::every]
    if ladder.n_steps is None:  # all rungs are the same to them
        return ladder._replace(strengths=(1,), n_steps=1)
    return ladder._replace(n_steps=1, strengths=strengths)


@pytest.mark.parametrize("every", [3, pytest.param(1, marks=pytest.mark.slow)])
@pytest.mark.parametrize("name", NAMES)
def test_random_play_scores_0(name: str, every: int) -> None:
    """With a 99.9 % interval: nine of 95 % would not all hold."""
    scores = profile({"random": random_play}, challenges=[short(name, every)], seed=1).scores("random", name)
    interval = mean_interval(scores.mean(axis=0), confidence=0.999)
    assert interval.low < 0 < interval.high
    assert interval.high - interval.low < 0.4


def catcher(grid: Any) -> int:
    """Move the paddle below the ball."""
    ball, paddle = int(grid[:-1].max(axis=0).argmax()), int(grid[-1].argmax())
    return 1 + int(np.sign(ball - paddle))


class Told:
    """Does what the toy says."""

    def predict(self, observation: Any) -> tuple[int, None]:
        """The need that the word names."""
        return int(observation[1]) % 4, None


class Notes:
    """Writes down each marked door, and walks through the corridor by its notes."""

    def predict(self, observation: int, state: Any = None) -> tuple[int, Any]:
        """The door, and the notes with the position."""
        doors, position = state or ((), 0)
        if position == len(doors):
            return observation, ((*doors, observation), 0)
        return doors[position], (doors, position + 1)


class Arm(NamedTuple):
    """The scripted controller as an agent."""

    controller: ScriptedController
    tabular: bool = False

    def act(self, state: Any, rng: Random) -> Any:
        """What the controller does."""
        return self.controller.act(state, rng)

    def learn(self, reward: float) -> None:
        """Learn nothing."""


def scripted(environment: Any) -> Arm:
    """The arm for an environment."""
    return Arm(ScriptedController(environment.unwrapped.mdp.action_scale))


BEST = {
    "Boulder": best_play,
    "Roadrunner": best_play,
    "Study": best_play,
    "Catch": lambda environment: catcher,
    "MemoryCorridor": Notes(),
    "Trashbot": scripted,
    "Supermarket": best_play,
}


@pytest.mark.parametrize("name", BEST)
def test_the_best_play_scores_1(name: str) -> None:
    """On every rung."""
    found = profile({"best": BEST[name]}, challenges=[short(name)], repetitions=2)
    assert found.scores("best", name) == pytest.approx(1.0, abs=1e-3)
    assert found.breaks("best", name) == (found.ladder(name).strengths[-1], "never")


def test_who_does_what_the_toy_says_scores_1_where_it_speaks_clearly() -> None:
    """And the more noise, the less."""
    found = profile({"told": Told()}, challenges=[short("Tamagotchi")], repetitions=3)
    means = [rung.estimate for rung in found.rungs("told", "Tamagotchi")]
    assert means[0] == pytest.approx(1.0, abs=1e-3)
    assert means == sorted(means, reverse=True)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "parameters", "stored", "tolerance"),
    [
        *(("Golf", {"stochasticity_level": level}, bounds.random, 0.01) for level, bounds in GOLF.items()),
        *(("Trashbot", {"container_width": width}, bounds.random, 0.01) for width, bounds in TRASHBOT.items()),
        ("Tamagotchi", {}, TAMAGOTCHI.random, 4.0),
        ("Tamagotchi", {"tau": 0.1}, TAMAGOTCHI.random, 4.0),
    ],
)
def test_stored_returns_of_random_play(name: str, parameters: dict[str, Any], stored: float, tolerance: float) -> None:
    """They are played again; the tolerance is some four standard errors."""
    mdp = make_mdp(name, **parameters)
    run = train(mdp, random_play(mdp), 5_000, evaluate_every=5_000, evaluation_episodes=50_000, seed=3)
    assert run.returns.mean() == pytest.approx(stored, abs=tolerance)


def test_stored_returns_of_the_best_golf() -> None:
    """They are planned again."""
    assert {level: round(optimum(level), 3) for level in GOLF} == {level: bounds.best for level, bounds in GOLF.items()}


def test_bounds_of_switches_are_those_of_the_exact_model() -> None:
    """For few switches, whose model is small."""
    ladder = LADDERS[NAMES.index("Switches")]
    assert ladder.bounds is not None
    for n in ladder.strengths[:-2]:
        assert ladder.bounds(n) == pytest.approx(exact_bounds(ladder.make(n, layout_seed=0)))


def flips(environment: Any) -> Any:
    """Flip the first switch that is wrong."""
    return lambda seen: int(np.flatnonzero(np.not_equal(*np.split(np.asarray(seen), 2)))[0])


def test_who_flips_what_is_wrong_scores_1() -> None:
    """On average: how many switches are wrong at the start is chance."""
    scores = profile({"flips": flips}, challenges=[short("Switches")]).scores("flips", "Switches")
    interval = mean_interval(scores.mean(axis=0), confidence=0.999)
    assert interval.low < 1 < interval.high
    assert interval.high - interval.low < 0.2


def test_a_task_without_better_and_worse_play_has_no_score() -> None:
    """The sentence names the task."""
    with pytest.raises(ValueError, match="Ring must be a task in which some play is better than random play"):
        exact_bounds(Ring())


def test_halfway_between_random_and_best_play_the_score_is_a_half() -> None:
    """Of an array as of a number."""
    assert Bounds(-1.0, 3.0).score(np.array([-1.0, 1.0, 3.0])).tolist() == [0.0, 0.5, 1.0]


def test_scores_are_the_callers_own() -> None:
    """They are remembered, so what somebody does with them must change no later answer."""
    strengths, name = LADDERS[0].strengths, LADDERS[0].name
    rows = [{"agent": "A", "challenge": name, "strength": s, "repetition": 0, "score": 0.5} for s in strengths]
    found = Profile(pandas.DataFrame(rows), LADDERS[:1], ("A",))
    found.scores("A", name)[:] = 9.0
    assert found.score("A", name).estimate == 0.5
    found.scores("A", name)[:] = 9.0
    assert found.score("A", name).estimate == 0.5
