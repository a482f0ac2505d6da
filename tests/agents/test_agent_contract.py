"""What holds for every agent of the package, whatever it learns."""

import copy
import inspect
import itertools
from typing import Any, NamedTuple

import gymnasium
import numpy as np
import pytest
from gymnasium import spaces

from edugym import (
    DQN,
    CountBased,
    EpsilonGreedy,
    GaussianActorCritic,
    GoExplore,
    QLearning,
    RMax,
    load,
    make_mdp,
    save,
    train,
)
from edugym.adapters.double_buffer import DoubleBuffer
from edugym.agents.settings import settings_of
from edugym.agents.traces import Replacing
from edugym.checks.contract import is_on_policy, learner
from edugym.compiled.compiler import compiled
from edugym.mdp.protocol import Random
from edugym.training.loops import off_policy, on_policy, start_off_policy
from edugym.training.trainers import new_log
from tests.agents.case import Case
from tests.agents.cases import AGENTS, CASES, STRATEGIES, package_classes, same

MDPS = ("Boulder", "Golf", "MemoryCorridor")  # states that are numbers, tuples, and hold arrays
REAL_MDPS = ("Trashbot",)  # with actions that are real numbers


def latest(name: str) -> str:
    """The id of the newest version that this Gymnasium has: they change from release to release."""
    return max(key for key in gymnasium.registry if key.startswith(f"{name}-v"))


TOY_TEXT = tuple(map(latest, ("FrozenLake", "CliffWalking", "Taxi", "Blackjack")))
REAL_ENVIRONMENTS = tuple(map(latest, ("Pendulum", "MountainCarContinuous")))


def everywhere(cases: dict[str, Case], whole: tuple[str, ...], real: tuple[str, ...]) -> pytest.MarkDecorator:
    """Each agent in each environment with actions that it can take: of whole numbers, or of real ones."""
    return pytest.mark.parametrize(
        ("case", "name"),
        [
            pytest.param(case, name, id=f"{label}-{name}")
            for label, case in cases.items()
            for name in (real if case.real_actions else whole)
        ],
    )


def somewhere(cases: dict[str, Case]) -> pytest.MarkDecorator:
    """Each agent in one MDP, in turn: compiling is slow, and `train` takes every agent to Boulder as well."""
    in_turn = itertools.cycle(MDPS)
    names = [REAL_MDPS[0] if case.real_actions else next(in_turn) for case in cases.values()]
    return pytest.mark.parametrize(
        ("case", "name"),
        [
            pytest.param(case, name, id=f"{label}-{name}")
            for (label, case), name in zip(cases.items(), names, strict=True)
        ],
    )


class Cycle(NamedTuple):
    """One state and one action that pays 1; it ends the task, or goes on for ever."""

    ends: bool
    max_steps: int = 1

    def initial(self, rng: Random) -> int:
        """The one state."""
        return 0

    def transition(self, state: int, action: int, rng: Random) -> int:
        """Back to it, or to the end."""
        return 1 if self.ends else 0

    def reward(self, state: int, action: int, next_state: int, rng: Random) -> float:
        """Always 1."""
        return 1.0

    def terminal(self, state: int) -> bool:
        """The end."""
        return state == 1

    def observation(self, state: int, rng: Random) -> int:
        """The state."""
        return state

    @property
    def observation_space(self) -> spaces.Discrete:
        """The state and the end."""
        return spaces.Discrete(2)

    @property
    def action_space(self) -> spaces.Discrete:
        """One action."""
        return spaces.Discrete(1)


def run_loop(mdp: Any, agent: Any, n_steps: int, seed: int, compile_it: bool) -> tuple[Any, ...]:
    """Run the loop for `n_steps` and give everything that it left behind."""
    environment_rng, agent_rng = np.random.default_rng([seed, 0]), np.random.default_rng([seed, 1])
    log = new_log()
    view = DoubleBuffer(mdp, agent, is_on_policy(agent))
    mdp, learning = view.mdp, view.of(learner(agent))
    loop: Any = off_policy
    moment: Any = start_off_policy(mdp, environment_rng)
    if is_on_policy(agent):
        loop = on_policy
        moment = (*moment[:2], learning.act(moment[1], agent_rng), *moment[2:])
    arguments = (mdp, learning, 40, environment_rng, agent_rng, log, moment)
    if compile_it:
        loop = compiled(loop, n_steps, *arguments)
    moment = loop(n_steps, *arguments)
    return agent, environment_rng, agent_rng, log, moment


def play_by_hand(env: gymnasium.Env[Any, Any], agent: Any, n_steps: int, agent_rng: Random, first_seed: int) -> Any:
    """The loop as one writes it for any Gymnasium environment; gives the last observation."""
    on = is_on_policy(agent)
    told = learner(agent)
    observation, _ = env.reset(seed=first_seed)
    action = agent.act(observation, agent_rng) if on else None
    for _ in range(n_steps):
        if not on:
            action = agent.act(observation, agent_rng)
        assert env.action_space.contains(action)
        next_observation, reward, terminated, truncated, _ = env.step(action)
        if on:
            next_action = action if terminated else agent.act(next_observation, agent_rng)
            told.learn(observation, action, float(reward), next_observation, next_action, terminated, truncated)
            action = next_action
        else:
            told.learn(observation, action, float(reward), next_observation, terminated, truncated)
        observation = next_observation
        if terminated or truncated:
            observation, _ = env.reset()
            action = agent.act(observation, agent_rng) if on else None
    return observation


def tables(agent: Any) -> list[np.ndarray[Any, Any]]:
    """All arrays in an agent."""
    if isinstance(agent, np.ndarray):
        return [agent]
    return [table for part in agent for table in tables(part)] if isinstance(agent, tuple) else []


def experienced(case: Case, environment: Any) -> Any:
    """A new agent whose value tables are filled at random, so that every update changes something."""
    agent = case.create(environment)
    for table in tables(agent):
        if table.ndim > 1 and table.dtype == np.float64:
            table[...] = np.abs(np.random.default_rng(9).normal(size=table.shape))
    return agent


def test_every_agent_and_every_strategy_of_the_package_is_in_the_table() -> None:
    """No new agent escapes these tests."""
    assert {case.kind for case in AGENTS.values()} == set(package_classes("learn"))
    assert len(AGENTS) >= 4
    assert {type(make((2, 2))) for make in STRATEGIES.values()} == set(package_classes("choose"))


@somewhere(AGENTS)
def test_compiled_is_bit_identical_to_interpreted(case: Case, name: str) -> None:
    """Tables, random streams, sums and the moment at which the loop stops: all the same."""
    mdp = case.fit(make_mdp(name))
    one = run_loop(mdp, experienced(case, mdp), 2_000, 3, compile_it=True)
    other = run_loop(mdp, experienced(case, mdp), 2_000, 3, compile_it=False)
    assert all(map(same, one, other))
    assert not same(one[0], experienced(case, mdp))


@pytest.mark.parametrize("make", STRATEGIES.values(), ids=STRATEGIES)
def test_every_strategy_compiled_is_bit_identical_to_interpreted(make: Any) -> None:
    """The same for every way to explore."""
    mdp = make_mdp("Boulder", height=3)
    one = run_loop(mdp, QLearning.create(mdp, exploration=make(mdp)), 3_000, 1, compile_it=True)
    other = run_loop(mdp, QLearning.create(mdp, exploration=make(mdp)), 3_000, 1, compile_it=False)
    assert all(map(same, one, other))


@everywhere(CASES, (*TOY_TEXT, "edugym/Golf-v0"), (*REAL_ENVIRONMENTS, "edugym/Trashbot-v0"))
def test_a_plain_gymnasium_loop_trains_it(case: Case, name: str) -> None:
    """A hand-written loop needs nothing of ours but the agent and, where observations have parts, the wrapper.

    For agents that take vectors that is Gymnasium's own `FlattenObservation`.
    """
    env = case.fit(gymnasium.make(name))
    agent = experienced(case, env)
    before = copy.deepcopy(agent)
    observation = play_by_hand(env, agent, 150, np.random.default_rng(0), 0)
    assert env.observation_space.contains(observation)
    assert not same(agent, before)
    assert all(not np.isnan(table).any() for table in tables(agent))
    env.close()


@everywhere(AGENTS, TOY_TEXT, REAL_ENVIRONMENTS)
def test_train_in_a_gymnasium_environment_is_that_loop(case: Case, name: str) -> None:
    """`train` with an id gives, bit for bit, what the loop written by hand gives on the same random streams."""
    env = case.fit(gymnasium.make(name))
    by_hand, trained = experienced(case, env), experienced(case, env)
    environment_rng, agent_rng, _, _ = map(np.random.default_rng, np.random.SeedSequence(5).spawn(4))
    observation = play_by_hand(env, by_hand, 300, agent_rng, int(environment_rng.integers(2**31)))
    run = train(name, trained, 300, seed=5, evaluate_every=150)
    assert run.complete
    for agent in (trained, by_hand) if case.vectors else ():  # its room for features and values, as it was used last
        agent.greedy(observation, np.random.default_rng(0))
    assert same(trained, by_hand)
    env.close()


class Unchanged(gymnasium.Wrapper[Any, Any, Any, Any]):
    """A wrapper that changes nothing, but of which `train` cannot know it."""


@everywhere(AGENTS, ("Boulder",), REAL_MDPS)
def test_the_gymnasium_loop_and_machine_code_are_one(case: Case, name: str) -> None:
    """In an environment without chance both give the same run: resets, truncation and all."""
    results = []
    parameters: dict[str, Any] = {"height": 4, "max_steps": 9} if name == "Boulder" else {"max_steps": 15}
    for wrap in (Unchanged, lambda env: env):
        env = wrap(gymnasium.make(f"edugym/{name}-v0", **parameters))
        agent = case.create(env)
        run = train(env, agent, 6_000, seed=2, evaluate_every=1_000, evaluation_episodes=2)
        results.append((agent, run.steps, run.training_returns, run.episodes))
    assert all(map(same, *results))
    assert results[0][3].sum() >= 6_000 // parameters["max_steps"]


@pytest.mark.parametrize("case", [c for c in AGENTS.values() if c.estimates_return], ids=lambda c: c.kind.__name__)
def test_it_bootstraps_at_truncation_and_not_at_termination(case: Case) -> None:
    """Every episode is one step long. Cut off, the step is worth 1 + γ + γ² + ... = 2 at γ = 1/2; as an end, 1.

    At α = 1/2 the first two updates are
        cut off      0 + (1 + 0/2 - 0)/2 = 1/2,  1/2 + (1 + 1/4 - 1/2)/2 = 7/8;
        as an end    0 + (1 - 0)/2 = 1/2,        1/2 + (1 - 1/2)/2 = 3/4.
    """
    for ends, second, limit in ((False, 7 / 8, 2.0), (True, 3 / 4, 1.0)):
        agent = case.create(Cycle(ends))
        train(Cycle(ends), agent, 2)
        assert agent.Q[0, 0] == second
        train(Cycle(ends), agent, 200)
        assert agent.Q[0, 0] == pytest.approx(limit, abs=1e-9)
        assert agent.Q[1, 0] == 0.0


@pytest.mark.parametrize("case", [c for c in AGENTS.values() if not c.real_actions], ids=lambda c: c.kind.__name__)
def test_greedy_takes_the_best_and_never_explores(case: Case) -> None:
    """However much the agent explores while it learns."""
    agent, rng = case.create((2, 3)), np.random.default_rng(0)
    if "exploration" in agent._fields:
        agent = agent._replace(exploration=EpsilonGreedy(1.0))
    for table in tables(agent):
        if table.ndim > 1 and table.dtype == np.float64:
            table[...] = rng.normal(size=table.shape) if case.vectors else [[1.0, 3.0, 2.0], [6.0, 4.0, 5.0]]
    for state, best in enumerate((1, 0)):
        seen = np.eye(2)[state] if case.vectors else state
        chosen = {agent.greedy(seen, rng) for _ in range(40)}
        assert chosen == {int(agent.Q[0].argmax()) if case.vectors else best}


@pytest.mark.parametrize("case", CASES.values(), ids=CASES)
def test_a_saved_agent_goes_on_as_if_nothing_had_happened(case: Case, tmp_path: Any) -> None:
    """Train, save, load, train on: every table is what it is without the break."""
    mdp = case.fit(make_mdp("Trashbot" if case.real_actions else "Golf"))
    agent = case.create(mdp)
    run_loop(mdp, agent, 500, 0, compile_it=False)
    save(agent, tmp_path / "agent.npz")
    loaded = load(tmp_path / "agent.npz")
    assert same(loaded, agent)
    one = run_loop(mdp, agent, 500, 1, compile_it=False)
    other = run_loop(mdp, loaded, 500, 1, compile_it=False)
    assert all(map(same, one, other))
    assert not same(agent, load(tmp_path / "agent.npz"))


@somewhere(AGENTS)
@pytest.mark.parametrize("n_steps", [50_000, 200])
def test_an_agent_for_a_smaller_environment_is_refused(case: Case, name: str, n_steps: int) -> None:
    """`train` names the table; and machine code checks its indices like the interpreter, so that nothing crashes."""
    refused = r"agent must be one for n_inputs" if case.vectors else r"agent must have a table (Q|preferences) of shape"
    mdp = case.fit(make_mdp(name))
    with pytest.raises(ValueError, match=refused):
        train(mdp, case.create((2, 2)), n_steps)
    if not case.vectors:  # those look at as many numbers as they were made for, and no further
        with pytest.raises(IndexError, match="out of bounds"):
            run_loop(mdp, case.create((2, 2)), n_steps, 0, compile_it=n_steps > 200)


@pytest.mark.parametrize("kind", dict.fromkeys(case.kind for case in AGENTS.values()))
@pytest.mark.parametrize(
    ("parameter", "value", "allowed"),
    [
        ("learning_rate", 0, "greater than 0"),
        ("learning_rate", -0.1, "greater than 0"),
        ("learning_rate", 1.5, "greater than 0 and at most 1"),
        ("learning_rate", float("nan"), "greater than 0"),
        ("learning_rate", "0.1", "a number"),
        ("learning_rate", True, "a number"),
        ("discount", -0.1, "from 0 to 1"),
        ("discount", 1.1, "from 0 to 1"),
        ("discount", float("nan"), "from 0 to 1"),
        ("discount", None, "a number"),
    ],
)
def test_settings_out_of_range_are_refused(kind: Any, parameter: str, value: Any, allowed: str) -> None:
    """The message names the parameter, its value and what is allowed; not every agent has a learning rate."""
    if parameter in settings_of(kind):
        with pytest.raises(ValueError, match=rf"{parameter} must be .*{allowed}.*, but is {value!r}"):
            kind.create((4, 2), **{parameter: value})


@pytest.mark.parametrize(
    ("kind", "parameter", "value", "allowed"),
    [
        (CountBased, "bonus", -1, "0 or more"),
        (CountBased, "bonus", float("nan"), "0 or more"),
        (GoExplore, "explore_steps", 0, "1 or more"),
        (GoExplore, "explore_steps", 2.5, "a whole number"),
        (GoExplore, "longest", 0, "1 or more"),
    ],
)
def test_settings_of_one_agent_out_of_range_are_refused(kind: Any, parameter: str, value: Any, allowed: str) -> None:
    """The same for what only one agent has."""
    with pytest.raises(ValueError, match=rf"{parameter} must be .*{allowed}.*, but is {value!r}"):
        kind.create((4, 2), **{parameter: value})


@pytest.mark.parametrize("kind", dict.fromkeys(case.kind for case in AGENTS.values()))
def test_agents_that_are_compared_have_the_same_defaults(kind: Any) -> None:
    """Whoever sets nothing compares algorithms, not settings. Networks and Gaussian policies take smaller steps."""
    expected = {"learning_rate": 0.1, "value_learning_rate": 0.1, "discount": 0.99, "exploration": EpsilonGreedy(0.1)}
    expected |= {"n": 4, "trace_decay": 0.9, "planning_steps": 10, "traces": Replacing()}
    if kind is DQN:
        expected["learning_rate"] = 1e-3
    if kind is GaussianActorCritic:
        expected |= {"learning_rate": 0.01, "value_learning_rate": 0.2}
    if kind is RMax:
        expected["planning_steps"] = 1_000  # as many as value iteration needs to settle
    parameters = inspect.signature(kind.create).parameters
    assert expected.keys() & parameters.keys()
    for name in expected.keys() & parameters.keys():
        assert parameters[name].default == expected[name], name


@pytest.mark.parametrize("kind", dict.fromkeys(case.kind for case in AGENTS.values()))
def test_settings_at_the_ends_of_their_ranges_are_accepted(kind: Any) -> None:
    """A learning rate of 1 and the discounts 0 and 1 are legitimate."""
    for name, value in (("learning_rate", 1), ("discount", 0), ("discount", 1)):
        if name in settings_of(kind):
            assert getattr(kind.create((4, 2), **{name: value}), name) == value
