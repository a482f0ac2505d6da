"""Profiles: who can enter, what is kept, and what follows from the scores."""

import math
import operator
import re
import signal
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pandas
import pytest

import edugym
from edugym import Interrupted, Ladder, Profile, QLearning, profile
from edugym.checks.parameters import whole_number
from edugym.experiments.configuration import planned_runs
from edugym.experiments.profiles import tuning
from edugym.experiments.profiles.ladders import LADDERS
from edugym.experiments.profiles.scores import COLUMNS, Break, breaking
from edugym.experiments.profiles.tuning import other_seed, with_untuned
from edugym.mdp.frame_stack import FrameStack
from edugym.mdp.protocol import Reals
from edugym.training.run import Run
from tests.compiled.cells import WALK, cell

Walk = cell(WALK)["Walk"]


def walk(size: float, layout_seed: int) -> Any:
    """A walk of some size."""
    made = Walk(int(size))
    return type("LimitedWalk", (Walk,), {"max_steps": 20, "__slots__": ()})(*made)


WALKS = Ladder("Walks", "distance", "size", (3, 5), walk, 400)


def keys(found: Profile) -> list[tuple[Any, ...]]:
    """The runs without what was measured."""
    return list(found.runs[["agent", "challenge", "strength", "repetition"]].itertuples(index=False, name=None))


def test_every_agent_runs_on_every_rung() -> None:
    """With the same bounds, and scores that follow from them; the scores of one agent do not depend on others."""
    agents = {"Q": QLearning.create, "SARSA": edugym.SARSA.create}
    found = profile(agents, challenges=[WALKS], repetitions=3)
    assert keys(found) == [(agent, "Walks", size, i) for size in (3, 5) for agent in agents for i in range(3)]
    runs = found.runs
    expected = (runs["return"] - runs["random"]) / (runs["best"] - runs["random"])
    assert runs["score"].to_numpy() == pytest.approx(expected.to_numpy())
    assert runs["best"].to_dict() == {i: 0.5 if runs["strength"][i] == 3 else 0.0 for i in runs.index}
    assert found.scores("Q", "Walks") == pytest.approx(1.0)
    assert found.score("Q", "Walks") == (1.0, 1.0, 1.0, 3)
    assert found.breaks("Q", "Walks") == Break(5, "never")
    assert 0 < found.steps("Q", "Walks") < 400
    for ask in (found.scores, found.score, found.rungs, found.breaks, found.steps):
        with pytest.raises(ValueError, match=r"agent .*Q.*SARSA.*nobody"):
            ask("nobody", "Walks")
        with pytest.raises(ValueError, match=r"challenge .*Walks.*Boulder"):
            ask("Q", "Boulder")
    alone = profile({"Q": QLearning.create}, challenges=[WALKS], repetitions=3, jobs=1)
    assert alone.runs.equals(runs[runs["agent"] == "Q"].reset_index(drop=True))


def test_who_cannot_enter_is_blank_and_not_zero() -> None:
    """A table cannot choose the angles of an arm; the sentence says why."""
    found = profile({"Q": QLearning.create}, challenges=["Trashbot", WALKS], repetitions=2)
    assert list(found.blank["Q"]) == ["Trashbot"]
    assert "a table needs" in found.blank["Q"]["Trashbot"]
    assert found.score("Q", "Trashbot").n == 0
    assert found.breaks("Q", "Trashbot") is None
    assert math.isnan(found.steps("Q", "Trashbot"))
    for challenges, told in ((["Trashbot"], "cannot enter Trashbot"), (["Trashbot", "Catch"], "can enter none")):
        with pytest.raises(ValueError, match=re.escape(f"agents['Q'] {told}") + ".*a table needs"):
            profile({"Q": QLearning.create}, challenges=challenges)


class LateMistake(NamedTuple):
    """Fails after 250 steps."""

    steps: Any

    def act(self, state: int, rng: Any) -> int:
        """Go right."""
        return 1

    def learn(self, reward: float) -> None:
        """Count, and ask for what is not there."""
        self.steps[0] += 1
        if self.steps[0] > 250:
            raise KeyError("Q")


def test_a_late_mistake_costs_its_agent_one_challenge_and_others_nothing() -> None:
    """It is said at once, and stands in the report."""
    makers = {"late": lambda environment: LateMistake(np.zeros(1, int)), "Q": QLearning.create}
    with pytest.warns(UserWarning, match="'late' has no score in Walks: .*KeyError"):
        found = profile(makers, challenges=[WALKS], repetitions=2)
    assert "KeyError" in found.blank["late"][WALKS.name]
    assert found.score("late", WALKS.name).n == 0
    assert found.score("Q", WALKS.name).n == 2


def test_a_policy_is_judged_and_not_trained_and_blank_where_it_does_not_fit() -> None:
    """A function whose parameter is an observation is a policy, not a function that makes one."""
    acted = []

    def right(observation: int) -> int:
        acted.append(observation)
        return 1

    found = profile({"right": right}, challenges=[WALKS, "Trashbot"], repetitions=2, jobs=1)
    assert found.score("right", WALKS.name).estimate == pytest.approx(1, abs=0.05)
    assert "right" in found.blank["right"]["Trashbot"]
    assert len(acted) < 800, "two runs on two rungs of 400 steps would be 1600"


@pytest.mark.parametrize(
    ("asked", "said"),
    [("observation_space.n", "a table needs observations"), ("observation_space.m", "AttributeError")],
)
def test_a_students_agent_that_fails_in_a_challenge_is_blank_there(asked: str, said: str) -> None:
    """Whatever it raises: it may ask a space for what it does not have. Why it fits no table is a sentence."""

    def make(environment: Any) -> QLearning:
        if environment.observation_space.shape:
            operator.attrgetter(asked)(environment)
        return QLearning.create((int(environment.observation_space.n), int(environment.action_space.n)))

    found = profile({"mine": make}, challenges=["Catch", WALKS], repetitions=2)
    assert list(found.blank["mine"]) == ["Catch"]
    assert said in found.blank["mine"]["Catch"]


def test_who_asks_for_the_number_of_rows_is_given_rows() -> None:
    """It learns the same table as the package's agent where the observations are several numbers."""

    def make(environment: Any) -> QLearning:
        return QLearning.create((int(environment.observation_space.n), int(environment.action_space.n)))

    exam = LADDERS[2]._replace(strengths=(5,), n_steps=500, evaluation_episodes=10)
    found = profile({"mine": make, "Q": QLearning.create}, challenges=[exam], repetitions=2)
    assert found.score("mine", "Study") == found.score("Q", "Study")


def test_wrappers_are_part_of_an_agent() -> None:
    """Two observations are enough for a corridor of two places, one is not."""
    corridor = LADDERS[4]._replace(strengths=(2,), n_steps=4_900, evaluation_episodes=10)  # not worth compiling
    agents = {"one": QLearning.create, "two": (QLearning.create, lambda mdp: FrameStack.create(mdp, 2))}
    found = profile(agents, challenges=[corridor], repetitions=3)
    assert found.score("one", "MemoryCorridor").high < 0.8
    assert found.score("two", "MemoryCorridor").low > 0.9


def test_a_table_that_would_fill_the_memory_is_not_made() -> None:
    """It is one that the agent cannot enter with; the sentence says at which rung, and how large it would be."""
    agents = {"stack": (QLearning.create, lambda mdp: FrameStack.create(mdp, 4))}
    found = profile(agents, challenges=["Boulder", WALKS], repetitions=2)
    assert list(found.blank["stack"]) == ["Boulder"]
    assert "a table for height of the wall 100 would have 208,120,802 numbers" in found.blank["stack"]["Boulder"]


class Model:
    """A model as libraries have it."""

    def predict(self, observation: Any, deterministic: bool = False) -> Any:
        """To the right, if it is to act as it believes best."""
        assert deterministic
        return np.array(1)


@pytest.mark.parametrize("policy", [Model(), lambda environment: Model(), lambda environment: lambda observation: 1])
def test_policies_written_for_gymnasium(policy: Any) -> None:
    """An object with `predict`, or a function that makes one, or that makes a function of observations."""
    assert profile({"right": policy}, challenges=[WALKS], repetitions=2).scores("right", "Walks") == pytest.approx(1.0)


@pytest.mark.parametrize("action", [None, 2, -1, "left", 0.5, (0, 1)])
def test_an_action_that_is_none(action: Any) -> None:
    """The sentence names the policy, what it returned and what is allowed."""

    def to_nowhere(observation: Any) -> Any:
        return action

    found = re.escape(str(action).strip("'"))
    with pytest.raises(ValueError, match=f"to_nowhere must return .*from 0 to 1, but returned '?{found}"):
        profile({"lost": lambda environment: to_nowhere}, challenges=[WALKS], repetitions=1, jobs=1)


def test_ctrl_c_keeps_what_is_done_and_the_same_call_goes_on(tmp_path: Path) -> None:
    """The first rung is complete; the second call makes agents for the second one alone, and gives the same."""
    signal.signal(signal.SIGINT, signal.default_int_handler)
    log = tmp_path / "log"  # a file: what an agent's code holds in memory tells two experiments apart

    def make(environment: Any) -> QLearning:
        with log.open("a") as lines:
            lines.write(f"{environment.observation_space.n} ")
        if len(log.read_text().split()) == 7:  # two are tried, and of each rung one is described and two are trained
            signal.raise_signal(signal.SIGINT)
        return QLearning.create(environment)

    def run() -> Profile:
        return profile({"Q": make}, challenges=[WALKS], repetitions=2, jobs=1, checkpoints=tmp_path / "kept")

    with pytest.raises(Interrupted, match="1 of 2 rungs are complete; the same call goes on from there") as raised:
        run()
    assert {strength for _, _, strength, _ in keys(raised.value.partial)} == {3}
    assert raised.value.partial.score("Q", "Walks").n == 0
    assert raised.value.partial.rungs("Q", "Walks")[0].n == 2
    before = len(log.read_text())
    found = run()
    assert log.read_text()[before:].split() == ["4", *4 * ["6"]]  # both rungs are tried, and the second is climbed
    assert found.runs.equals(profile({"Q": QLearning.create}, challenges=[WALKS], repetitions=2).runs)


def test_an_agent_may_train_itself(tmp_path: Path) -> None:
    """It gets the budget and the seeds that others get; each finished run is kept, and Ctrl-C loses no other."""
    log = tmp_path / "log"  # as above

    class Learner(NamedTuple):
        environment: Any

        def train(self, n_steps: int, *, evaluate_every: int, evaluation_episodes: int, seed: int) -> Run:
            with log.open("a") as lines:
                lines.write(f"{seed} ")
            if len(log.read_text().split()) == 2:
                raise KeyboardInterrupt
            steps = np.arange(0, n_steps + 1, evaluate_every)
            returns: Reals = steps / n_steps - 1
            return Run(steps, returns, np.zeros(len(steps)), steps, self, seed, 0.0, True)

    def run() -> Profile:
        how: dict[str, Any] = {"challenges": [WALKS], "repetitions": 2, "jobs": 1, "checkpoints": tmp_path / "kept"}
        return profile({"own": lambda environment: Learner(environment)}, **how)

    with pytest.raises(Interrupted):
        run()
    found = run()
    first, second = (planned.repetition.seed for planned in planned_runs(["own"], 2, 0))
    assert [*map(int, log.read_text().split())] == [first, second, second, first, second]
    assert found.runs["return"].tolist() == [0.0] * 4
    assert found.runs["steps"].tolist() == [400] * 4
    assert found.score("own", "Walks").n == 2


def test_who_trains_itself_and_refuses_a_rung_is_blank_there() -> None:
    """Networks may need more steps than a rung has; the other challenges and the other agents go on."""

    class Learner(NamedTuple):
        environment: Any

        def train(self, n_steps: int, *, evaluate_every: int, evaluation_episodes: int, seed: int) -> Run:
            whole_number("n_steps", n_steps, 300)
            steps = np.array([0, n_steps])
            return Run(steps, np.zeros(2), np.zeros(2), steps, self, seed, 0.0, True)

    few = WALKS._replace(
        name="Few",
        strengths=(400, 200),
        n_steps=None,
        strength="steps",
        make=lambda steps, layout_seed: walk(3, layout_seed),
    )
    agents = {"own": lambda environment: Learner(environment), "Q": QLearning.create}
    found = profile(agents, challenges=[few, WALKS], repetitions=2, jobs=1)
    assert list(found.blank["own"]) == ["Few"]
    assert found.blank["own"]["Few"].startswith("the rung 200 (steps): n_steps must be")
    assert found.blank["Q"] == {}
    assert found.score("own", "Few").n == 0
    assert found.score("own", "Walks").n == found.score("Q", "Few").n == 2


@pytest.mark.parametrize(
    ("means", "expected"),
    [
        ([1.0, 0.9, 0.8], Break(30, "never")),
        ([0.4, 1.0, 1.0], Break(10, "at once")),
        ([1.0, 0.75, 0.25], Break(25, "between")),
        ([1.0, 0.0, 1.0], Break(15, "between")),
    ],
)
def test_where_an_agent_breaks(means: list[float], expected: Break) -> None:
    """The first crossing of 0.5, interpolated."""
    assert breaking((10, 20, 30), np.array(means)) == expected


def test_median_steps() -> None:
    """Infinite where half of the runs never get there."""
    for steps, expected in (([100, 300, math.nan], 300.0), ([100, math.nan, math.nan], math.inf)):
        rows = [("Q", "Walks", size, i, 0.0, 0.0, 1.0, 1.0, 400, steps[i]) for size in (3, 5) for i in range(3)]
        found = Profile(pandas.DataFrame(rows, columns=list(COLUMNS)), (WALKS,), ("Q",))
        assert found.steps("Q", "Walks") == expected


def test_agents_choose_their_settings_on_other_seeds_and_layouts() -> None:
    """The better one, for each challenge; who cannot enter is blank; and it says what there was to choose."""
    grid = {
        "never": partial(QLearning.create, learning_rate=1e-9),
        "fast": partial(QLearning.create, learning_rate=0.5),
    }
    agents: dict[str, Any] = {"Q": grid, "SARSA": {"default": edugym.SARSA.create}}
    tuned = edugym.tuned_profile(agents, tuning_repetitions=2, challenges=[WALKS, "Trashbot"], repetitions=3)
    assert tuned.chosen == {"Q": {"Walks": "fast"}, "SARSA": {"Walks": "default"}}
    assert tuned.profile.blank["Q"].keys() == {"Trashbot"}
    plain = profile({"Q": grid["fast"]}, challenges=[WALKS], repetitions=3)
    assert tuned.profile.scores("Q", "Walks").tolist() == plain.scores("Q", "Walks").tolist()
    # Two settings, on two rungs of 400 steps each, twice; one setting.
    assert (
        "Q had the choice of: never; fast. It tried them for 3,200 steps, and took: fast (Walks)"
        in tuned.profile.settings
    )
    assert "SARSA had the choice of: default. It tried them for 1,600 steps" in tuned.profile.settings
    both = with_untuned(profile({"Q": grid["never"]}, challenges=[WALKS, "Trashbot"], repetitions=3), tuned)
    assert both.agents == ("Q", "tuned Q", "tuned SARSA")
    assert both.blank.keys() == {*both.agents}
    assert both.score("tuned Q", "Walks").estimate == pytest.approx(1.0)
    assert both.score("Q", "Walks").estimate < 0.9
    for seed in range(3):
        for part in ("seed", "layout_seed"):
            runs, others = (
                {getattr(run.repetition, part) for run in planned_runs(["Q"], 20, one)}
                for one in (seed, other_seed(seed))
            )
            assert not runs & others


def test_settings_that_fail_after_they_were_chosen_are_blank(monkeypatch: pytest.MonkeyPatch) -> None:
    """As by an error that comes with other seeds only."""

    def failing(agents: Any, **how: Any) -> Profile:
        found = profile(agents, **how)
        if agents.keys() == {"Q"}:  # not "Q, default", as in the first round
            return replace(found, runs=found.runs.iloc[:0], blank={"Q": {"Walks": "it failed"}})
        return found

    monkeypatch.setattr(tuning, "profile", failing)
    tuned = edugym.tuned_profile({"Q": {"default": QLearning.create}}, tuning_repetitions=1, challenges=[WALKS])
    assert tuned.profile.blank["Q"] == {"Walks": "it failed"}


@pytest.mark.slow
def test_scores_are_stable() -> None:
    """Of two profiles with other seeds, 95 % of the cells agree: their intervals meet."""
    agents = {"Q": QLearning.create, "Go-Explore": edugym.GoExplore.create, "SARSA(λ)": edugym.SARSALambda.create}
    names = [ladder.name for ladder in LADDERS if ladder.name not in ("Catch", "Trashbot")]
    first, second = (profile(agents, challenges=names, seed=seed) for seed in (1, 2))
    cells = [(first.score(agent, name), second.score(agent, name)) for agent in agents for name in names]
    agree = [one.low <= other.high and other.low <= one.high for one, other in cells]
    assert np.mean(agree) >= 0.95
