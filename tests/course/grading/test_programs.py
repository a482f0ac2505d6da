"""Programs from a blank file: what is said of one that breaks the contract, and of a curve that is too low."""

import math
from collections.abc import Callable
from functools import partial
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium import spaces

from edugym import QLearning
from edugym_course.grading import WrongAnswer, curves
from edugym_course.grading.curves import Race, Result, compare_with_ours, lowest, our_results, program_of, symptom
from edugym_course.grading.programs import Recorder, Run, Step, returns_of, run_program
from edugym_course.grading.repeats import require_reproducible
from edugym_course.grading.small_world import SmallWorld

N_STEPS = 60


def plays(
    environment: Any,
    n_steps: int,
    seed: int,
    *,
    act: Callable[[Any], Any] = int,
    policy: Any = lambda state: 0,
    reset: Callable[[Any], Any] = lambda environment: environment.reset(),
    gives_seed: bool = True,
) -> Any:
    """A program that follows the contract, but for what is given."""
    rng = np.random.default_rng(seed)
    environment.reset(seed=seed if gives_seed else None)
    for _ in range(n_steps):
        _, _, terminated, truncated, _ = environment.step(act(rng.integers(3)))
        if terminated or truncated:
            reset(environment)
    return policy


def swallows(environment: Any, n_steps: int, seed: int) -> Any:
    """It catches what it is told."""
    try:
        environment.step(0)
    except Exception:
        return plays(environment, n_steps, seed)


def twice(environment: Any, n_steps: int, seed: int) -> Any:
    """It takes too many steps."""
    plays(environment, n_steps, seed)
    return plays(environment, n_steps, seed, reset=lambda environment: environment.reset())


def samples(environment: Any, n_steps: int, seed: int, *, gives_seed: bool = True) -> Any:
    """It draws from the action space."""
    if gives_seed:
        environment.action_space.seed(seed)
    return plays(environment, n_steps, seed, act=lambda _: environment.action_space.sample())


def reads_both(environment: Any, n_steps: int, seed: int) -> Any:
    """It takes what reset gives for the state."""
    return np.zeros((12, 4))[environment.reset()]


def unpacks_four(environment: Any, n_steps: int, seed: int) -> Any:
    """It unpacks what an old Gym gave."""
    environment.reset()
    _, _, _, _ = environment.step(0)


RIGHT: dict[str, Any] = {
    "as asked": plays,
    "NumPy's whole numbers": partial(plays, act=np.int64),
    "an array without axes": partial(plays, act=np.array),
    "samples of a space with a seed": samples,
}
WRONG: dict[str, tuple[Any, str]] = {
    "nothing": (..., "Not solved yet: my_program is still `...`"),
    "a class": (
        SmallWorld,
        "my_program should be a function of environment, n_steps and seed, but is the class SmallW",
    ),
    "what it gave": (3, "my_program should be a function of environment, n_steps and seed, but is of the type int"),
    "two parameters": (lambda environment, n_steps: None, "takes 2 positional arguments but 3 were given"),
    "no reset": (
        lambda environment, n_steps, seed: environment.step(0),
        "my_program takes a step before the first reset(): begin with state, info = environment.reset(seed=seed)",
    ),
    "no reset, caught": (swallows, "my_program takes a step before the first reset()"),
    "no second reset": (
        partial(plays, reset=lambda environment: None),
        "my_program takes a step after the end of an episode: call reset() when `terminated` or `truncated` is True"
        " (and use these names for nothing else), and go on from the state that it gives",
    ),
    "the seed again": (
        partial(plays, reset=lambda environment: environment.reset(seed=0)),
        "my_program calls reset(seed=...) more than once: give the seed at the first reset only, and call reset() after"
        " that",
    ),
    "no seed": (
        partial(plays, gives_seed=False),
        "my_program gives no seed to its first reset, so two runs with one seed differ: begin with state, info ="
        " environment.reset(seed=seed)",
    ),
    "samples of a space without a seed": (
        partial(samples, gives_seed=False),
        "my_program draws from environment.action_space.sample(), and gives it no seed",
    ),
    "twice": (twice, "calls reset(seed=...) more than once"),
    "too few steps": (
        lambda environment, n_steps, seed: plays(environment, 7, seed),
        f"my_program takes 7 of its {N_STEPS} steps: go on, episode after episode, until all are taken",
    ),
    "too many steps": (
        lambda environment, n_steps, seed: plays(environment, 1000, seed),
        f"my_program begins another episode after its {N_STEPS} steps: count the steps of all episodes",
    ),
    "a list": (
        partial(plays, act=lambda action: [action]),
        "as an action, and it should be one whole number from 0 to 3: take an entry of it",
    ),
    "an array": (partial(plays, act=lambda action: np.array([action])), "it should be one whole number from 0 to 3"),
    "a float": (partial(plays, act=float), "as an action: it should be a whole number from 0 to 3"),
    "a text": (partial(plays, act=str), "as an action: it should be a whole number from 0 to 3"),
    "None": (partial(plays, act=lambda action: None), "chooses None as an action: is a `return` missing?"),
    "counted from 1": (partial(plays, act=lambda action: 4), "chooses the action 4: there are the actions 0 to 3"),
    "below 0": (partial(plays, act=lambda action: -1), "chooses the action -1: there are the actions 0 to 3"),
    "no return": (
        partial(plays, policy=None),
        "my_program(environment, 60, 0) gives None: return the policy, a function from a state to an action",
    ),
    "a table": (
        partial(plays, policy=np.zeros((2, 2))),
        "should return a function from a state to an action, but what it returns is of the type ndarray:"
        " return `lambda state: int(Q[state].argmax())` for a table of action values, and `lambda state:"
        " actions[state]` for an array with an action for each state",
    ),
    "values of one state": (
        partial(plays, policy=np.zeros(4)),
        ": return `lambda state: actions[state]` for an array with an action for each state, and `lambda state:"
        " int(np.argmax(Q))` for the values of a single state",
    ),
    "a class as a policy": (partial(plays, policy=SmallWorld), "what it returns is the class SmallWorld"),
    "both": (reads_both, "reset gives two things: state, info = environment.reset()"),
    "four things": (
        unpacks_four,
        "step gives five things: state, reward, terminated, truncated, info = environment.step(action)",
    ),
}


@pytest.mark.parametrize("name", RIGHT)
def test_a_program_that_keeps_to_the_contract(name: str) -> None:
    """All its steps are there, each with the state that it began in."""
    run = run_program(RIGHT[name], SmallWorld(0), N_STEPS, 0)
    assert len(run.steps) == N_STEPS
    pairs = zip(run.steps, run.steps[1:], strict=False)
    assert all(now.next_state == then.state for now, then in pairs if not (now.terminated or now.truncated))
    assert len(run.returns) == sum(step.terminated or step.truncated for step in run.steps)
    assert all(type(step.action) is int for step in run.steps)


@pytest.mark.parametrize("name", WRONG)
def test_a_program_that_breaks_the_contract(name: str) -> None:
    """One sentence names what it did, and what is allowed."""
    program, says = WRONG[name]
    with pytest.raises(WrongAnswer) as refused:
        run_program(program, SmallWorld(0), N_STEPS, 0)
    assert says in str(refused.value)
    assert "\n" not in str(refused.value)


def test_a_reset_in_the_middle_of_an_episode() -> None:
    """It is refused; two resets without a step between them are not."""
    recorder = Recorder(SmallWorld(0), N_STEPS, 0)
    recorder.reset(seed=0)
    recorder.reset()
    assert recorder.step(0)[2:4] == (False, False)
    says = r"calls reset\(\) in the middle of an episode: go on until `terminated` or `truncated` is True"
    with pytest.raises(WrongAnswer, match=says):
        recorder.reset()


def remembers(runs: list[int], environment: Any, n_steps: int, seed: int) -> Any:
    """A program that knows how often it has run."""
    runs.append(0)
    return plays(environment, n_steps, seed + len(runs))


@pytest.mark.parametrize(
    ("program", "says"),
    [
        (
            partial(remembers, []),
            "my_program does not repeat itself: two runs with seed 5 take different actions. Draw every random number"
            " from rng = np.random.default_rng(seed), and make all that it learns inside the function, so that nothing"
            " is left of the run before",
        ),
        (
            partial(plays, act=lambda action: 0),
            "my_program takes the same actions with seed 5 and with seed 6: it should try actions at random, and draw"
            " them from rng = np.random.default_rng(seed)",
        ),
    ],
)
def test_what_a_seed_must_do(program: Any, says: str) -> None:
    """The same seed gives the same run, and another one another run, unless a program need not draw."""
    require_reproducible(plays, partial(SmallWorld, 0), N_STEPS, 5)
    require_reproducible(partial(plays, act=lambda action: 0), partial(SmallWorld, 0), N_STEPS, 5, draws=False)
    with pytest.raises(WrongAnswer) as refused:
        require_reproducible(program, partial(SmallWorld, 0), N_STEPS, 5)
    assert says in str(refused.value)


@pytest.mark.parametrize(
    ("policy", "says"),
    [
        (lambda state: 7, "the policy that my_program returns chooses the action 7: there are the actions 0 to 3"),
        (lambda: 0, "takes 0 positional arguments but 1 was given"),
        (lambda state: 1 / 0, "raises ZeroDivisionError"),
    ],
)
def test_a_policy_that_fails(policy: Any, says: str) -> None:
    """It is told that it is the policy."""
    assert len(returns_of(lambda state: 1, SmallWorld(0), 3, 0)) == 3
    with pytest.raises(WrongAnswer) as refused:
        returns_of(policy, SmallWorld(0), 3, 0)
    assert says in str(refused.value)


class Line(gymnasium.Env[Any, Any]):
    """Episodes of three steps; an action is one real number, and it is the reward."""

    observation_space = spaces.Discrete(3)
    action_space = spaces.Box(-math.inf, math.inf, (), np.float64)

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[int, dict[str, Any]]:
        """Begin at 0."""
        self.place = 0
        return 0, {}

    def step(self, action: float) -> tuple[int, float, bool, bool, dict[str, Any]]:
        """Go on by one."""
        self.place += 1
        return self.place % 3, action, self.place == 3, False, {}


@pytest.mark.parametrize("act", [float, np.float32, lambda number: np.array([number]), lambda number: [number]])
def test_a_real_action(act: Callable[[Any], Any]) -> None:
    """One number in whatever form is noted as a float."""
    run = run_program(partial(plays, act=act), Line(), N_STEPS, 0)
    assert {type(step.action) for step in run.steps} == {float}


@pytest.mark.parametrize(
    ("action", "says"),
    [
        (None, "chooses None as an action: is a `return` missing?"),
        ([1.0, 2.0], "my_program chooses [1.0, 2.0] as an action, and it should be one real number"),
        ("left", "as an action, and it should be one real number"),
        (math.nan, "my_program chooses nan as an action: does what it learns grow without end?"),
        (math.inf, "my_program chooses inf as an action: does what it learns grow without end?"),
    ],
)
def test_what_is_no_real_action(action: Any, says: str) -> None:
    """One sentence says what came."""
    with pytest.raises(WrongAnswer) as refused:
        run_program(partial(plays, act=lambda number: action), Line(), N_STEPS, 0)
    assert says in str(refused.value)


def test_a_policy_that_remembers() -> None:
    """It is told all that came before in its episode, and nothing of the episode before."""
    told: list[Any] = []

    def policy(history: Any) -> float:
        told.append(history)
        return float(len(history))

    returns = returns_of(policy, Line(), 2, 0, remembers=True)
    assert told == [(0,), (0, 1.0, 1), (0, 1.0, 1, 3.0, 2)] * 2
    assert list(returns) == [9.0, 9.0]


def run_with(returns: list[float]) -> Run:
    """A run of episodes of one step each."""
    return Run([Step(0, 0, reward, 0, True, False) for reward in returns], lambda state: 0)


CURVES: list[tuple[list[float], float, str]] = [
    ([], 0.0, "hardly an episode ended: does the state that your program chooses from change after each step?"),
    (
        [0.0] * 30 + [9.0] * 60 + [1.0] * 30,
        1.0,
        "the returns rise to 9.0 and then fall to 1.0: likely values that grow without end, or a target that goes on"
        " after the end of an episode",
    ),
    (
        [0.1 * k for k in range(120)],
        15.0,
        "the returns rise from 1.4 to 10.4, but slowly: likely a learning rate that is too small, too much"
        " exploration, or steps that are learned from only when the episode is over",
    ),
    (
        [2.0] * 120,
        2.0,
        "the returns do not rise (2.0 in the first quarter, 2.0 in the last): likely an update that changes nothing, or"
        " actions that are not chosen by what was learned",
    ),
    (
        [2.0] * 120,
        -5.0,
        "while it learned, its last episodes brought 2.0, and the policy that it returns brings -5.0: does this policy"
        " look up the state that it is given, and take the *best* action?",
    ),
]


@pytest.mark.parametrize(("returns", "played", "says"), CURVES)
def test_symptoms_of_a_curve(returns: list[float], played: float, says: str) -> None:
    """Each says what was seen, and the likely cause."""
    assert symptom(run_with(returns), played) == says


def test_the_symptom_of_a_policy_alone() -> None:
    """A curve that rises slowly is no reason where the last episodes are as good as ours."""
    assert symptom(run_with(CURVES[2][0]), CURVES[2][1], has_learned=True) == (
        "while it learned, its last episodes were as good as ours, so look at the policy that it returns: does it take"
        " the *best* action, and never a random one?"
    )


def learner(shape: tuple[int, int]) -> QLearning:
    """An agent that learns a small world."""
    return QLearning.create(shape, learning_rate=0.1)


class Notes:
    """An on-policy agent that acts at random, and notes what it is told."""

    def __init__(self) -> None:
        """Nothing yet."""
        self.told = list[tuple[int, int, bool]]()

    def act(self, state: int, rng: Any) -> int:
        """Any action."""
        return int(rng.integers(4))

    greedy = act

    def learn(self, action: int, next_action: int, terminated: bool, truncated: bool) -> None:
        """Note it."""
        self.told.append((action, next_action, terminated or truncated))


def test_our_program_tells_the_next_action() -> None:
    """Which is the one that it takes next, in the same episode."""
    agent = Notes()
    program_of(lambda shape: agent)(SmallWorld(1), 50, 0)
    pairs = [*zip(agent.told, agent.told[1:], strict=False)]
    assert [now[1] for now, _ in pairs if not now[2]] == [then[0] for now, then in pairs if not now[2]]
    assert len({action for action, _, _ in agent.told}) > 1


RACE = Race(partial(SmallWorld, 1), 2000, program_of(learner), episodes=200)


def test_a_race() -> None:
    """Our own program passes with other seeds; one that acts at random does not, and both figures are told."""
    assert compare_with_ours(RACE.ours, RACE, 3).startswith("In the middle one of 5 runs, the last quarter")
    with pytest.raises(WrongAnswer) as refused:
        compare_with_ours(plays, RACE, 0)
    for says in (
        "in the middle one of 5 runs, the last quarter of its training episodes brings ",
        ", which is too low:",
    ):
        assert says in str(refused.value)
    better = max(our_results(RACE), key=lambda result: result.late)
    assert isinstance(better, Result)
    assert better.late > lowest([result.late for result in our_results(RACE)])


def test_a_little_less_than_ours(monkeypatch: pytest.MonkeyPatch) -> None:
    """What is accepted and lies below ours is told to be near enough; what lies among ours needs no such word."""
    assert "near enough" not in compare_with_ours(RACE.ours, RACE, 3)
    monkeypatch.setattr(curves, "lowest", lambda ours: -math.inf)
    assert compare_with_ours(plays, RACE, 0).count("; that is near enough)") == 2


def test_how_low_a_run_may_be() -> None:
    """A standard deviation below the worst of ours; a curve without an episode is below any."""
    assert lowest([1.0, 2.0, 3.0]) == pytest.approx(0.0)
    assert math.isnan(run_with([]).late())
