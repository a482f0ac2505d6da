"""What holds for every agent of the package, whatever it learns."""

import copy
import inspect
import itertools
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium import spaces
from gymnasium.wrappers import FlattenObservation

from edugym import (
    DQN,
    ENVIRONMENTS,
    UCT,
    EpsilonGreedy,
    GaussianActorCritic,
    GoExplore,
    Hashed,
    HindsightDQN,
    HindsightQLearning,
    MDPEnv,
    PrioritisedSweeping,
    RMax,
    SemiGradientSARSA,
    TabularObservation,
    TreeBackup,
    load,
    make_mdp,
    save,
    table_size,
    train,
)
from edugym.agents.settings import settings_of
from edugym.agents.traces import Replacing
from edugym.checks.contract import is_on_policy, learner
from edugym.mdp.protocol import Random
from edugym.training.evaluated import actor
from tests.agents.cases import AGENTS, CASES, STRATEGIES, Case, lasting, package_classes, same

KINDS = {case.kind: case for case in reversed(AGENTS.values())}
"""The first case of every agent."""
every_agent = pytest.mark.parametrize("case", KINDS.values(), ids=[kind.__name__ for kind in KINDS])


def latest(name: str) -> str:
    """The id of the newest version that this Gymnasium has: they change from release to release."""
    return max(key for key in gymnasium.registry if key.startswith(f"{name}-v"))


WHOLE = (*map(latest, ("FrozenLake", "CliffWalking", "Taxi", "Blackjack")), "edugym/Golf-v0")
REAL = (*map(latest, ("Pendulum", "MountainCarContinuous")), "edugym/Trashbot-v0")


IN_TURN = [itertools.cycle(WHOLE), itertools.cycle(REAL)]


class Cycle(gymnasium.Env[Any, Any]):
    """One state and one action that pays 1; each step ends the task, or is the last before a truncation."""

    observation_space = spaces.Discrete(2)
    action_space: Any = spaces.Discrete(1)

    def __init__(self, ends: bool) -> None:
        """Which of both."""
        self.ends = ends

    def reset(self, **how: Any) -> Any:
        """The one state."""
        return 0, {}

    def step(self, action: int) -> Any:
        """To the end, or back."""
        return int(self.ends), 1.0, self.ends, not self.ends, {}


def play_by_hand(
    env: gymnasium.Env[Any, Any], agent: Any, n_steps: int, agent_rng: Random, first_seed: int | None
) -> Any:
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
    assert set(KINDS) == set(package_classes("learn"))
    assert len(KINDS) >= 4
    assert {type(make((2, 2))) for make in STRATEGIES.values()} == set(package_classes("choose"))


@pytest.mark.parametrize(
    ("case", "name"), [(case, next(IN_TURN[case.real_actions])) for case in CASES.values()], ids=CASES
)
def test_train_in_a_gymnasium_environment_is_a_loop_written_by_hand(case: Case, name: str) -> None:
    """Bit for bit, on the same random streams. That loop needs nothing of ours but the agent, and perhaps a wrapper."""
    env = case.fit(gymnasium.make(name))
    by_hand, trained = experienced(case, env), experienced(case, env)
    before = copy.deepcopy(by_hand)
    environment_rng, agent_rng, _, _ = map(np.random.default_rng, np.random.SeedSequence(5).spawn(4))
    observation = play_by_hand(env, by_hand, 150, agent_rng, int(environment_rng.integers(2**31)))
    assert env.observation_space.contains(observation)
    assert not same(by_hand, before)
    assert all(not np.isnan(table).any() for table in tables(by_hand))
    trains_there = not name.startswith("edugym/")  # which `train` plays by its MDP, with other random streams
    if trains_there:
        assert train(name, trained, 150, seed=5, evaluate_every=150).complete
        for agent in (trained, by_hand) if case.vectors else ():  # its room for features, as it was used last
            agent.greedy(observation, np.random.default_rng(0))
        assert same(lasting(trained), lasting(by_hand))
    env.close()


def made(entry: Any) -> Any:
    """An environment of the course, so small that an agent may have a table of all pairs of its states."""
    return gymnasium.make(entry.id, n_switches=3) if entry.name == "Switches" else gymnasium.make(entry.id)


def as_a_student_makes_it(case: Case, entry: Any) -> Any:
    """An environment of the course for a loop of one's own: one visible step after `gymnasium.make`."""
    if case.vectors:
        return FlattenObservation(made(entry))
    if entry.name == "Catch":  # a table over its images has a row for each that has occurred
        task: Any = Hashed.create(make_mdp("Catch"), capacity=250)
        env = MDPEnv(task)
        state, rng = env.reset(seed=0)[0], np.random.default_rng(0)
        while env.mdp.used < 210:  # all that are possible, so that an evaluation adds none
            state, _, terminated, truncated, _ = env.step(int(rng.integers(3)))
            state = env.reset()[0] if terminated or truncated else state
        return env
    return TabularObservation(made(entry))


@pytest.mark.parametrize("entry", ENVIRONMENTS, ids=lambda entry: entry.name)
@every_agent
def test_the_plain_loop_gives_the_tables_of_train_in_every_environment_of_the_course(case: Case, entry: Any) -> None:
    """Bit for bit, where the environment draws from the random stream that `train` gives to it."""
    if case.real_actions != isinstance(entry.load_mdp().create().action_space, spaces.Box):
        pytest.skip("real numbers for actions, or not")
    if entry.name == "Switches" and case.vectors:
        pytest.skip("its flattened dictionary has the achieved goal too, which a network of `train` does not see")
    env, again = as_a_student_makes_it(case, entry), as_a_student_makes_it(case, entry)
    by_hand, trained = experienced(case, env), experienced(case, env)
    before = copy.deepcopy(by_hand)
    env.unwrapped.np_random, agent_rng, _, _ = map(np.random.default_rng, np.random.SeedSequence(5).spawn(4))
    observation = play_by_hand(env, by_hand, 150, agent_rng, first_seed=None)
    train(
        again.unwrapped if isinstance(again.unwrapped.mdp, Hashed) else made(entry),
        trained,
        150,
        seed=5,
        evaluate_every=150,
    )
    for agent in (trained, by_hand) if case.vectors else ():  # its room for features, as it was used last
        agent.greedy(observation, np.random.default_rng(0))
    assert same(lasting(trained), lasting(by_hand))
    assert not same(by_hand, before)


@pytest.mark.parametrize("name", ["Roadrunner", "Study", "Golf", "Tamagotchi"])
def test_an_action_from_a_table_that_was_indexed_with_an_observation_is_refused_with_the_remedy(name: str) -> None:
    """The argmax over several rows at once is a number beyond the last action."""
    env: Any = gymnasium.make(f"edugym/{name}-v0")
    env.reset(seed=0)
    observation, Q = np.arange(len(env.observation_space.nvec)), np.zeros(table_size(env))
    Q[1, -1] = 1.0
    with pytest.raises(ValueError, match=r"^action .* is not in .* env = edugym.TabularObservation\(env\)"):
        env.step(np.argmax(Q[observation]))


class Unchanged(gymnasium.Wrapper[Any, Any, Any, Any]):
    """A wrapper that changes nothing, but of which `train` cannot know it."""


BUILT_SLOWLY = (
    *(DQN, UCT, GaussianActorCritic, HindsightDQN, HindsightQLearning),
    *(SemiGradientSARSA, PrioritisedSweeping, RMax, GoExplore, TreeBackup),
)
BUILT_FAST = [case for case in KINDS.values() if case.kind not in BUILT_SLOWLY]


@pytest.mark.parametrize(
    "case",
    [pytest.param(c, marks=() if c in BUILT_FAST else pytest.mark.slow, id=name) for name, c in CASES.items()],
)
def test_the_gymnasium_loop_and_machine_code_are_one(case: Case) -> None:
    """In an environment without chance both give the same run to the last bit: resets, truncation and all."""
    results = []
    name, parameters = "Boulder", dict[str, Any](height=4, max_steps=9)
    if case.real_actions:
        name, parameters = "Trashbot", {"max_steps": 15}
    for wrap in (Unchanged, lambda env: env):
        env = wrap(gymnasium.make(f"edugym/{name}-v0", **parameters))
        agent = case.create(env)
        run = train(env, agent, 5_000, seed=2, evaluate_every=1_000, evaluation_episodes=2)
        results.append((agent, run.steps, run.training_returns, run.episodes))
    assert all(map(same, *results))
    assert results[0][3].sum() >= 5_000 // parameters["max_steps"]


@pytest.mark.parametrize("case", [c for c in AGENTS.values() if c.estimates_return], ids=lambda c: c.kind.__name__)
def test_it_bootstraps_at_truncation_and_not_at_termination(case: Case) -> None:
    """Every episode is one step long. Cut off, the step is worth 1 + γ + γ² + ... = 2 at γ = 1/2; as an end, 1."""
    for ends, second, limit in ((False, 1 / 2 + (1 + 1 / 4 - 1 / 2) / 2, 2.0), (True, 1 / 2 + (1 - 1 / 2) / 2, 1.0)):
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
    evaluated = actor(agent)
    for table in tables(agent):
        if case.vectors and table.ndim > 1 and table.dtype == np.float64:
            table[...] = rng.normal(size=table.shape)
        elif table.shape[-2:] == (2, 3) and table.dtype == np.float64:
            table[...] = [[1.0, 3.0, 2.0], [6.0, 4.0, 5.0]]
    for state, best in enumerate((1, 0)):
        seen = np.eye(2)[state] if case.vectors else state
        chosen = {policy(seen, rng) for policy in (agent.greedy, evaluated.act) for _ in range(40)}
        assert chosen == {int(agent.Q[0].argmax()) if case.vectors else best}


@pytest.mark.parametrize("case", [c for c in AGENTS.values() if not c.real_actions], ids=lambda c: c.kind.__name__)
def test_greedy_draws_one_of_the_best(case: Case) -> None:
    """Where all values are equal, each action is as likely: its share of the draws is within 4 standard errors."""
    agent, rng, n = case.create((2, 3)), np.random.default_rng(0), 600
    for table in tables(agent):
        if table.dtype == np.float64:
            table[...] = 0.5
    seen = np.eye(2)[1] if case.vectors else 1
    counts = np.bincount([agent.greedy(seen, rng) for _ in range(n)], minlength=3)
    assert counts == pytest.approx(n / 3, abs=4 * (2 * n) ** 0.5 / 3)


@pytest.mark.parametrize("case", CASES.values(), ids=CASES)
def test_a_saved_agent_goes_on_as_if_nothing_had_happened(case: Case, tmp_path: Any) -> None:
    """Train, save, load, train on: every table is what it is without the break."""
    mdp = case.fit(make_mdp("Trashbot" if case.real_actions else "Golf"))
    agent = case.create(mdp)
    train(mdp, agent, 300, seed=0)
    save(agent, tmp_path / "agent.npz")
    loaded = load(tmp_path / "agent.npz")
    assert same(loaded, agent)
    for one in (agent, loaded):
        train(mdp, one, 300, seed=1)
    assert same(agent, loaded)
    assert not same(agent, load(tmp_path / "agent.npz"))


@every_agent
def test_an_agent_for_a_smaller_environment_is_refused(case: Case) -> None:
    """`train` names the table, and its size."""
    refused = r"agent must be one for n_inputs" if case.vectors else r"agent must have a table (Q|preferences) of shape"
    mdp = case.fit(make_mdp("Trashbot" if case.real_actions else "Golf"))
    with pytest.raises(ValueError, match=refused):
        train(mdp, case.create((2, 2)), 200)


@every_agent
def test_settings(case: Case) -> None:
    """Whoever sets nothing compares algorithms, not settings. A rate of 1 and discounts of 0 and 1 will do."""
    expected = {"discount": 0.99, "exploration": EpsilonGreedy(0.1), "n": 4, "trace_decay": 0.9, "traces": Replacing()}
    if not case.vectors:
        expected |= {"learning_rate": 0.1, "value_learning_rate": 0.1}
    signature = inspect.signature(case.kind.create)
    signature.bind("environment")
    for name in expected.keys() & signature.parameters.keys():
        assert signature.parameters[name].default == expected[name], name
    for name, value in (("learning_rate", 1), ("discount", 0), ("discount", 1)):
        if name in settings_of(case.kind):
            assert getattr(case.kind.create((4, 2), **{name: value}), name) == value
