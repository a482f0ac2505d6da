"""What single exercises check: numbers, cases, and what is said of answers that are counted or compared."""

import math
from typing import Any

import numpy as np
import pytest

from edugym import SARSA, EpsilonGreedy, NStepSARSA, repeat
from edugym.training.run import Run
from edugym_course.grading import WrongAnswer
from edugym_course.lessons.continuous_actions.exercises import episodes
from edugym_course.lessons.depth import methods as depth
from edugym_course.lessons.depth.exercises import exercise_1 as quiet_exercise
from edugym_course.lessons.dimensionality.shuffled import shuffled_board
from edugym_course.lessons.exploration import exercises as exploration
from edugym_course.lessons.exploration import methods as climbing
from edugym_course.lessons.model_based import methods as planning
from edugym_course.lessons.model_based.plans import used_and_seen
from edugym_course.lessons.stochasticity import exercises as stochasticity
from tests.course.lessons.answers import solution


def test_runs_that_solve_the_lake_are_counted(monkeypatch: pytest.MonkeyPatch) -> None:
    """Those that end at 1: here the first two of Go-Explore, and all of the reader's own agent."""

    def trained(environment: Any, agent: Any, n_steps: int, *, seed: int, **how: Any) -> Run:
        made.append(type(agent).__name__)
        solves = made[-1] == "SARSA" or (made[-1] == "GoExplore" and made.count("GoExplore") <= 2)
        ends = np.array([1.0, 1.0 if solves else 0.99])
        return Run(np.array([0, n_steps]), ends, np.zeros(2), np.zeros(2, int), agent, seed, 0.0, True)

    made: list[str] = []
    monkeypatch.setattr("edugym.experiments.repeat.train", trained)
    how: dict[str, Any] = {"repetitions": 5, "parameters": {"map_name": "8x8", "is_slippery": False}, "jobs": 1}
    answer = repeat("FrozenLake-v1", {**climbing.METHODS, "mine": SARSA.create}, climbing.N_STEPS, **how)
    assert exploration.exercise_4(answer, 0).startswith(
        "Right. Runs that solve the lake: ε-greedy 0 of 5, novelty reward 0 of 5, Go-Explore 2 of 5, mine 5 of 5. "
    )


@pytest.mark.parametrize(
    ("names", "strange"),
    [(["A", "Zoe"], "'Zoe'"), ([0, "A"], "0"), (["A", ("B", 1.0)], r"\('B', 1\.0\)"), ([["A"], "B"], r"\['A'\]")],
)
def test_what_is_no_name_of_a_player(names: list[Any], strange: str) -> None:
    """Another text, a number, a pair, a list."""
    with pytest.raises(WrongAnswer, match=f"should hold names such as 'A', but holds {strange}$"):
        stochasticity.exercise_2(lambda players: names, 0)


def test_pixels_are_shuffled() -> None:
    """The same pixels in an order of the seed's own, in every step the same one."""
    task, rng = shuffled_board(7), np.random.default_rng(0)
    state = task.initial(rng)
    one = task.observation(state, rng)
    assert one.shape == (50,)
    assert sorted(task.order.tolist()) == [*range(50)]
    assert (task.order == shuffled_board(7).order).all()
    assert (task.order != shuffled_board(8).order).any()
    assert {int(task.order[k]) for k in np.flatnonzero(one > 0.5)} == {state.ball_x, 45 + state.paddle_x}


def test_an_answer_is_told_the_whole_episode(monkeypatch: pytest.MonkeyPatch) -> None:
    """The next state and action of a step are those of the step after it; only the last step ends the episode."""
    told: list[dict[str, Any]] = []
    monkeypatch.setattr(episodes, "learn_step", lambda agent, step: told.append(step))
    for case in episodes.cases(0):
        told.clear()
        episodes._learned(solution("07_continuous_actions", 3, "MyREINFORCE"), case)
        assert [step["state"] for step in told] == case.states
        then = [(step["state"], step["action"]) for step in told[1:]]
        assert [(step["next_state"], step["next_action"]) for step in told[:-1]] == then
        ends = [(step["terminated"], step["truncated"]) for step in told]
        assert ends == [(False, False)] * (len(told) - 1) + [(case.terminates, not case.terminates)]


QUIET = [
    ({"learning_rate": 0.01}, "it has a learning rate of 0.01, and it should be 0.1$"),
    ({"learning_rate": 1.0}, "it has a learning rate of 1, and it should be 0.1$"),
    ({"discount": 0}, "it has a discount of 0, and it should be 1$"),
    ({"n": 9}, "its targets have 9 rewards, and Monte Carlo has n=math.inf$"),
    ({"n": 1}, "but its targets have 1 reward, and Monte Carlo has n=math.inf$"),
    ({"n": 3, "learning_rate": 0.5, "discount": 0.9}, "3 rewards, .*; and it has a learning .*; and it has a discount"),
    ({"learning_rate": 0.7}, "the first action should be .*: that is no n-step SARSA with a usual learning rate$"),
]


@pytest.mark.parametrize(("how", "says"), QUIET)
def test_how_deep_and_how_fast_the_quiet_agent_learns(how: dict[str, Any], says: str) -> None:
    """Whatever differs from the agent of the experiment is told, with the number that it has."""
    settings = {"n": math.inf, "learning_rate": 0.1, "discount": 1.0, "exploration": EpsilonGreedy(0.0), **how}
    with pytest.raises(WrongAnswer, match=says):
        quiet_exercise(lambda study: NStepSARSA.create(study, **settings), 0)


@pytest.mark.slow
def test_what_the_solutions_reach() -> None:
    """In lesson 1 the optimist and the explorer solve walls; Monte Carlo needs exploration; R-max and Dyna-Q+ plan."""
    optimist, explorer = (solution("01_exploration", k, name) for k, name in ((2, "optimist"), (3, "MyExplorer")))
    greedy = climbing.EPSILON_GREEDY
    both = {"optimist": optimist, "explorer": explorer.create}
    middle = climbing.compare(30, methods={**both, greedy: climbing.METHODS[greedy]}, repetitions=10)
    assert middle.final("optimist").mean() == 1
    assert middle.final(greedy).mean() < 0.2
    assert climbing.compare(100, methods=both, repetitions=10).final("explorer").mean() > 0.9

    own = {"quiet": solution("03_depth", 1, "quiet"), "mine": solution("03_depth", 3, "MyAgent").create}
    results = depth.compare(depths=depth.BY_DEPTH, own=own, repetitions=40, seed=1)
    assert depth.passes(results, "quiet").mean() < depth.passes(results, depth.MONTE_CARLO).mean() - 0.1
    ends = {method: depth.expected_returns(results, method).mean() for method in results.methods}
    assert ends["mine"] > max(ends[depth.label(n)] for n in depth.BY_DEPTH)
    early = {method: results.curves(method).loc[2_500].mean() for method in results.methods}
    assert early["mine"] > early[depth.ONE_STEP] + 2

    kinds = {"mine": solution("09_model_based", 3, "MyRMax"), "plus": solution("09_model_based", 2, "DynaPlus")}
    results = planning.compare({label: kind.create for label, kind in kinds.items()}, repetitions=5)
    assert (results.final("mine") == planning.OPTIMUM).all()
    policy, seen = used_and_seen(results)["plus"]
    assert policy.mean() < 0.0 < 90.0 < seen.mean()
