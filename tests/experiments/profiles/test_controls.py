"""The controls: random play scores 0 and the best play 1, whatever rewards, actions and states are called."""

from functools import partial
from typing import Any, NamedTuple

import numpy as np
import pandas
import pytest
from gymnasium import spaces
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from edugym import Ladder, QLearning, finite_model, make_mdp, mean_interval, policy_evaluation, profile, train
from edugym.envs.trashbot.planning import ScriptedController
from edugym.experiments.profiles.ladders import GOLF, LADDERS, TAMAGOTCHI, TRASHBOT, Bounds, exact_bounds
from edugym.experiments.profiles.scores import Profile
from edugym.mdp.protocol import Integers, Random, Reals
from edugym_course.lessons.stochasticity.exact import optimum
from tests.experiments.profiles.controls import best_play, random_play

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


class Tiny(NamedTuple):
    """A task of few states: the last one ends it, and every step leads to a known state and has a known reward."""

    successors: Integers
    rewards: Reals
    first: int
    last: int
    max_steps: int = 8

    def initial(self, rng: Random) -> int:
        """The first state."""
        return self.first

    def transition(self, state: int, action: int, rng: Random) -> int:
        """The successor."""
        return int(self.successors[state, action])

    def reward(self, state: int, action: int, next_state: int, rng: Random) -> float:
        """The reward."""
        return float(self.rewards[state, action])

    def terminal(self, state: int) -> bool:
        """Whether it is the last state."""
        return state == self.last

    def observation(self, state: int, rng: Random) -> int:
        """The state itself."""
        return state

    @property
    def observation_space(self) -> spaces.Discrete:
        """The states."""
        return spaces.Discrete(len(self.rewards))

    @property
    def action_space(self) -> spaces.Discrete:
        """The actions."""
        return spaces.Discrete(self.rewards.shape[1])


def tiny(seed: int) -> Tiny:
    """A random task."""
    rng = np.random.default_rng(seed)
    n_states, n_actions = int(rng.integers(3, 7)), int(rng.integers(2, 4))
    successors = rng.integers(0, n_states, (n_states, n_actions))
    return Tiny(successors, rng.integers(-4, 5, (n_states, n_actions)).astype(float), 0, n_states - 1)


def has_a_score(task: Tiny) -> bool:
    """Whether some play is better than random play."""
    try:
        exact_bounds(task)
    except ValueError:
        return False
    return True


def scaled(task: Tiny, factor: float) -> Tiny:
    """The task with other rewards."""
    return task._replace(rewards=task.rewards * factor)


def renamed(task: Tiny, actions: Integers) -> Tiny:
    """The task in which action k is the one that was `actions[k]`."""
    return task._replace(successors=task.successors[:, actions], rewards=task.rewards[:, actions])


def permuted(task: Tiny, states: Integers) -> Tiny:
    """The task in which state k is the one that was `states[k]`."""
    new = np.argsort(states)
    first, last = int(new[task.first]), int(new[task.last])
    return Tiny(new[task.successors[states]], task.rewards[states], first, last, task.max_steps)


def worth(task: Tiny, policy: Reals) -> float:
    """The exact score of a policy, shape (n_states, n_actions)."""
    model = finite_model(task)
    value = policy_evaluation(model, policy[list(model.states)], horizon=task.max_steps).start
    return float(exact_bounds(task).score(value))


@given(seed=st.integers(0, 10_000), factor=st.floats(0.01, 100))
@settings(max_examples=40, deadline=None)
def test_exact_scores_do_not_depend_on_the_form_of_the_task(seed: int, factor: float) -> None:
    """Scaled rewards, renamed actions, permuted states; random play has the score 0 in all of them."""
    task, rng = tiny(seed), np.random.default_rng(seed)
    assume(has_a_score(task))
    n_states, n_actions = task.rewards.shape
    policy = rng.dirichlet(np.ones(n_actions), n_states)
    actions, states = rng.permutation(n_actions), rng.permutation(n_states)
    expected = pytest.approx(worth(task, policy), abs=1e-6)
    assert worth(scaled(task, factor), policy) == expected
    assert worth(renamed(task, actions), policy[:, actions]) == expected
    assert worth(permuted(task, states), policy[states]) == expected
    assert worth(task, np.full_like(policy, 1 / n_actions)) == pytest.approx(0, abs=1e-9)
    assert worth(task, policy) <= 1 + 1e-9


class Renamed(NamedTuple):
    """An agent that knows the actions by their old names."""

    agent: Any
    actions: Integers

    def act(self, state: int, rng: Random) -> int:
        """The new name of what the agent does."""
        return int(np.flatnonzero(self.actions == self.agent.act(state, rng))[0])

    def greedy(self, state: int, rng: Random) -> int:
        """The new name of what the agent believes best."""
        return int(np.flatnonzero(self.actions == self.agent.greedy(state, rng))[0])

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool) -> None:
        """Let the agent learn of the action by its old name."""
        self.agent.learn(state, int(self.actions[action]), reward, next_state, terminated)


def learned(task: Tiny, make: Any = QLearning.create) -> Reals:
    """The scores of an agent that learns the task."""
    ladder = Ladder("Tiny", "nothing", "none", (1,), partial(_of, task), 300)
    return profile({"agent": make}, challenges=[ladder], repetitions=3).scores("agent", "Tiny")


def _of(task: Tiny, strength: float, layout_seed: int) -> Tiny:
    return task


@given(seed=st.integers(0, 10_000), power=st.integers(-6, 6))
@settings(max_examples=3, deadline=None)
def test_learned_scores_do_not_depend_on_the_form_of_the_task(seed: int, power: int) -> None:
    """Bit for bit, with rewards scaled by a power of two, which rounds nothing."""
    task, rng = tiny(seed), np.random.default_rng(seed)
    assume(has_a_score(task))
    actions, states = rng.permutation(task.rewards.shape[1]), rng.permutation(len(task.rewards))
    before = learned(task)
    assert learned(scaled(task, 2.0**power)) == pytest.approx(before, abs=1e-12)
    assert learned(permuted(task, states)) == pytest.approx(before, abs=1e-12)

    def make(environment: Any) -> Renamed:
        return Renamed(QLearning.create(environment), actions)

    assert learned(renamed(task, actions), make) == pytest.approx(before, abs=1e-12)


def test_a_task_without_better_and_worse_play_has_no_score() -> None:
    """The sentence names the task."""
    with pytest.raises(ValueError, match="Tiny must be a task in which some play is better than random play"):
        exact_bounds(Tiny(np.array([[1, 1], [1, 1]]), np.ones((2, 2)), 0, 1))


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
