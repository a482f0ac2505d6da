"""What the lab compiles in the background while a student reads: every kind of agent and task that a lesson trains."""

import sys
from typing import Any

import gymnasium
import pytest

from edugym import EpsilonGreedy
from edugym.training.run import Run
from edugym.training.train import train
from edugym_course.lessons import load_experiments

DECAY = "ScheduledEpsilonGreedy(LinearDecay)"
NETWORK = "DQN(Layers, Layers, Layers, Layers, Layers, ReplayMemory, {})"
CATCH = "ThrownFrom(CatchGrid)"
TRAINED: dict[str, dict[str, list[str]]] = {
    "loop": {"Supermarket": ["QLearning(ε)", "RandomPlayer"]},
    "exploration": {},
    "on_off_policy": {
        "CliffWalkingEnv": ["ExpectedSARSA(ε)", "QLearning(ε)", "SARSA(ε)"],
        "Roadrunner": [f"{kind}({how})" for kind in ("ExpectedSARSA", "QLearning", "SARSA") for how in ("ε", DECAY)],
    },
    "depth": {"Study": ["NStepSARSA(LastSteps, ε)"]},
    "dimensionality": {
        f"Brightness(NoisyObservation({CATCH}))": [NETWORK.format("ε")],
        "CatchGrid": [NETWORK.format("ε")],
        f"Coordinates({CATCH})": [NETWORK.format("ε"), "SemiGradientSARSA(TileCoding, ε)"],
        CATCH: [NETWORK.format("ε"), "LinearQLearning(Identity, ε)", "LinearQLearning(Offset, ε)"],
        f"Hashed(Brightness({CATCH}), HashedTable)": ["QLearning(ε)"],
        f"Hashed(NoisyObservation({CATCH}), HashedTable)": ["QLearning(ε)"],
        "SeveralNumbers(Catch)": ["QLearning(ε)"],
        "ThrownFrom(SeveralNumbers(Catch))": ["QLearning(ε)"],
    },
    "memory": {
        "SeparateFrames(FrameStack(MemoryCorridor))": [NETWORK.format(DECAY)],
        "FrameStack(MemoryCorridor)": ["QLearning(ε)"],
        "FrozenLakeEnv": ["QLearning(ε)"],
        "MemoryCorridor": ["Rememberer"],
    },
    "signal": {
        "FrameStack(TabularInPlace(Tamagotchi))": ["QLearning(ε)"],
        "Tamagotchi": ["QLearning(ε)", "RoundRobin", "Voter"],
    },
    "continuous_actions": {
        "Trashbot": ["GaussianActorCritic(TileCoding)"],
        "Discretised(SeveralNumbers(DiscreteActions(Trashbot)))": ["REINFORCE(Episode)"],
        "FrozenLakeEnv": ["REINFORCE(Episode)"],
    },
    "stochasticity": {
        "Golf": ["Player", "RiskSensitiveQLearning(ε)"],
        "GolfWithHits": ["Player", "RiskSensitiveQLearning(ε)"],
        "FrozenLakeEnv": ["QLearning(ε)"],
    },
    "model_based": {
        "Supermarket": [
            f"CountingSweeping(PrioritisedSweeping(TabularModel, Heap, Updates, {DECAY}))",
            f"DynaQ(TabularModel, Updates, {DECAY})",
            f"PrioritisedSweeping(TabularModel, Heap, Updates, {DECAY})",
            f"QLearning({DECAY})",
            "RMax(TabularModel, Sweep, Updates)",
        ]
    },
    "own_problem": {
        "Morning": [
            "CountBased(ε)", "DynaQ(TabularModel, Updates, ε)", "NStepSARSA(LastSteps, ε)", "QLearning(ε)", "SARSA(ε)",
        ],
        "PaidForWakefulness": ["QLearning(ε)"],
        "WithBonus(Morning)": ["QLearning(ε)"],
        "WithPotential(Morning)": ["QLearning(ε)"],
    },
}  # fmt: skip
"""By lesson and task, the agents, each with the classes of what is inside; ε is `EpsilonGreedy`."""
COMPILE_LONG = {"dimensionality", "memory", "signal", "continuous_actions", "model_based"}


def kind(value: Any) -> str:
    """The class of a value, and in brackets those inside it."""
    if isinstance(value, EpsilonGreedy):
        return "ε"
    if isinstance(value, gymnasium.Env):
        return kind(getattr(value.unwrapped, "mdp", type(value.unwrapped).__name__))
    inside = [kind(part) for part in value if hasattr(part, "_fields")] if hasattr(value, "_fields") else []
    name = value if isinstance(value, str) else type(value).__name__
    return f"{name}({', '.join(inside)})" if inside else name


@pytest.mark.parametrize(
    "lesson", [pytest.param(lesson, marks=[pytest.mark.slow] * (lesson in COMPILE_LONG)) for lesson in TRAINED]
)
def test_what_a_lesson_warms_up(lesson: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """All that is trained in it once, for a few steps."""
    found: dict[str, set[str]] = {}

    def noted(environment: Any, agent: Any, *more: Any, **how: Any) -> Run:
        found.setdefault(kind(environment), set()).add(kind(agent))
        return train(environment, agent, *more, **how)

    experiments = load_experiments(lesson)
    for name, module in [*sys.modules.items()]:
        if name.startswith(("edugym.", "edugym_course.")) and vars(module).get("train") is train:
            monkeypatch.setattr(module, "train", noted)
    if hasattr(experiments, "warm_up"):
        experiments.warm_up()
    assert found == {task: {*agents} for task, agents in TRAINED[lesson].items()}
