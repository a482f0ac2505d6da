"""Whether an environment plays like the same problem in the form of exercise 4."""

import math
from collections import defaultdict
from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.adapters.gymnasium_env import MDPEnv
from edugym.checks.parameters import in_short
from edugym.exact.model import finite_model
from edugym.exact.tables import FiniteModel
from edugym.mdp.protocol import Reals
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.programs import APART, Environment
from edugym_course.grading.student_code import student_code
from edugym_course.grading.values import number

NAME = "MyEnvironment"
DIFFERS = f"{NAME} and your problem differ: "
COMPARED, ENOUGH, SIGMAS = 20_000, 50, 5.0
"""How many steps are compared; how many from a place, at least; how many standard deviations are more than chance."""
MOST_STATES, MODEL_SECONDS = 5_000, 300.0
"""The largest problem whose exact model is looked at, and the seconds of processor time that this may take."""
DRAWS = 5
"""So many draws of a reward are the same only where there is no chance in it."""


class _Steps(NamedTuple):
    """Steps of random play.

    Attributes:
        starts: the first observations of all episodes.
        after: by an observation and an action, what came each time: the next observation, the reward, and whether the
            episode terminated.
        returns: the sum of the rewards of each episode that ended.
    """

    starts: list[Any]
    after: dict[tuple[Any, int], list[tuple[Any, float, bool]]]
    returns: list[float]


def require_same(environment: Environment, problem: MDPEnv[Any], seed: int) -> None:
    """Refuse an environment that plays otherwise than the problem does, and say where.

    Places that random play often comes to are compared by their shares and means; rare ones by the exact model, which
    knows what can never come; and all together by the returns.
    """
    _require_same_form(environment, problem)
    with student_code(NAME):
        mine = _steps(environment, seed)
    with student_code("my_problem"):
        other = _steps(problem, seed)
    _require_same_places(mine, other)
    _require_possible(mine, problem.mdp)
    if _differ(*map(np.array, (mine.returns, other.returns))):
        raise WrongAnswer(
            f"{DIFFERS}random play gets {np.mean(mine.returns):.4g} in an episode of {NAME}, and"
            f" {np.mean(other.returns):.4g} in your problem"
        )


def _require_same_form(environment: Environment, problem: MDPEnv[Any]) -> None:
    """Refuse observations that cannot be compared with those of the problem."""
    mine, other = (one.reset(seed=0)[0] for one in (environment, problem))
    if isinstance(mine, dict) or np.size(_plain(mine)) != np.size(_plain(other)):
        raise WrongAnswer(
            f"an episode begins with the observation {in_short(mine)} in {NAME}, and with {in_short(other)} in your"
            " problem: to be compared they should have one form"
        )


def _steps(environment: Environment, seed: int) -> _Steps:
    """Play at random, with other numbers than those that the environment draws."""
    assert isinstance(environment.action_space, spaces.Discrete)
    rng, n_actions = np.random.default_rng(APART + seed), int(environment.action_space.n)
    steps, total = _Steps([], defaultdict(list), []), 0.0
    observation, over = None, True
    for count in range(COMPARED):
        if over:
            observation = _plain((environment.reset() if count else environment.reset(seed=seed))[0])
            steps.starts.append(observation)
        action = int(rng.integers(n_actions))
        came, reward, terminated, truncated, _ = environment.step(action)
        over, paid = bool(terminated or truncated), number("the reward", reward)
        steps.after[observation, action].append((_plain(came), paid, bool(terminated)))
        observation, total = _plain(came), total + paid
        if over:
            steps.returns.append(total)
            total = 0.0
    return steps


def parts(observation: Any) -> list[Any]:
    """Return copies of all arrays and numbers of an observation, which may be a dictionary or a tuple of others."""
    if isinstance(observation, dict):
        observation = tuple(observation[name] for name in sorted(observation))
    if isinstance(observation, tuple):
        return [part for one in observation for part in parts(one)]
    return [np.array(observation)]


def _plain(observation: Any) -> Any:
    """Return an observation as a number, or as a tuple of numbers."""
    numbers = [number for part in parts(observation) for number in np.ravel(part).tolist()]
    return numbers[0] if len(numbers) == 1 else tuple(numbers)


def _require_same_places(mine: _Steps, other: _Steps) -> None:
    """Refuse other shares of next observations and of ends, and other mean rewards, after the same."""
    if not {*mine.starts} & {*other.starts}:
        raise WrongAnswer(
            f"{DIFFERS}an episode begins with {mine.starts[0]} in {NAME}, and with {other.starts[0]} in your problem:"
            " do both observe the same, in the same form?"
        )
    _require_same_share(mine.starts, other.starts, f"{DIFFERS}an episode begins with ")
    for observation, action in sorted(mine.after.keys() | other.after.keys(), key=str):
        here, there = (steps.after.get((observation, action), []) for steps in (mine, other))
        if min(len(here), len(there)) < ENOUGH:
            if max(len(here), len(there)) > 2 * ENOUGH and not (here and there):
                raise WrongAnswer(
                    f"{DIFFERS}in {COMPARED} random steps the action {action} is taken at the observation {observation}"
                    f" {len(here)} times in {NAME}, and {len(there)} times in your problem"
                )
            continue
        where = f"{DIFFERS}{_after(observation, action)}"
        _require_same_share([came for came, *_ in here], [came for came, *_ in there], f"{where}there follows ")
        ends, other_ends = (
            ["it terminates" if terminated else None for *_, terminated in steps] for steps in (here, there)
        )
        _require_same_share(ends, other_ends, where)
        rewards, others = (np.array([reward for _, reward, _ in steps]) for steps in (here, there))
        if _differ(rewards, others):
            raise WrongAnswer(
                f"{where}the reward is {rewards.mean():.4g} on average in {NAME}, and {others.mean():.4g} in your"
                " problem"
            )


def _after(observation: Any, action: int) -> str:
    return f"after the action {action} at the observation {observation}, "


def _require_possible(mine: _Steps, problem: Any) -> None:
    """Refuse a step that the problem never takes, however rarely random play comes there.

    It can be told where the problem has a finite model, and shows its whole state.
    """
    rng = np.random.default_rng(0)
    with student_code("my_problem", limit=MODEL_SECONDS):
        try:
            model = finite_model(problem, MOST_STATES)
        except ValueError:
            return
        seen = [_plain(problem.observation(state, rng)) for state in model.states]
        again = [_plain(problem.observation(state, rng)) for state in model.states]
    if len({*seen}) < len(seen) or seen != again:
        return
    states, shown = dict(zip(seen, model.states, strict=True)), dict(zip(model.states, seen, strict=True))
    known = {place: came for place, came in mine.after.items() if place[0] in states}  # others begin an episode
    for (observation, action), came in known.items():
        possible = _possible(model, states[observation], action, shown)
        for step in came:
            if not any(_is_same(step, one) for one in possible):
                raise WrongAnswer(
                    f"{DIFFERS}{_after(observation, action)}{_told(step)} in {NAME}, and in your problem"
                    f" {' or '.join(map(_told, possible))}"
                )
    _require_likely({place: (came, _shares(model, states[place[0]], place[1], shown)) for place, came in known.items()})


def _require_likely(places: dict[tuple[Any, int], tuple[list[tuple[Any, float, bool]], dict[Any, float]]]) -> None:
    """Refuse next observations that come more or less often than by the exact model, in all places together.

    The sum of Pearson's X² of all places is compared with its mean and its variance (Haldane, 1937).
    """
    excess = variance = 0.0
    worst, says = 0.0, ""
    for (observation, action), (came, shares) in places.items():
        n, k = len(came), len(shares)
        if n * min(shares.values()) < 1 or k == 1:
            continue
        found = {after: sum(step[0] == after for step in came) for after in shares}
        apart = {after: (found[after] - n * share) ** 2 / (n * share) for after, share in shares.items()}
        excess += sum(apart.values()) - (k - 1)
        variance += 2 * (k - 1) + (sum(1 / share for share in shares.values()) - k * k - 2 * k + 2) / n
        after = max(apart, key=lambda after: apart[after])
        if apart[after] > worst:
            worst = apart[after]
            says = (
                f"{_after(observation, action)}there follows {after} in {found[after]} of {n} cases in {NAME}, and in"
                f" {shares[after]:.0%} in your problem"
            )
    if excess > SIGMAS * math.sqrt(variance):
        raise WrongAnswer(f"{DIFFERS}chance is another in many places; in one of them, {says}")


def _shares(model: FiniteModel, state: Any, action: int, shown: dict[Any, Any]) -> dict[Any, float]:
    """The probability of each next observation."""
    shares: dict[Any, float] = defaultdict(float)
    for probability, after, *_ in model.outcomes(state, action):
        shares[shown[after]] += probability
    return shares


def _possible(
    model: FiniteModel, state: Any, action: int, seen: dict[Any, Any]
) -> list[tuple[Any, float | None, bool]]:
    """All that can follow: the next observation, the reward (None if chance is in it), and whether that is the end."""
    assert model.mdp is not None
    rng, possible = np.random.default_rng(0), list[tuple[Any, float | None, bool]]()
    for _, after, mean, ends in model.outcomes(state, action):
        drawn = {float(model.mdp.reward(state, action, after, rng)) for _ in range(DRAWS)}
        possible.append((seen[after], mean if len(drawn) == 1 else None, ends))
    return possible


def _is_same(step: tuple[Any, float, bool], one: tuple[Any, float | None, bool]) -> bool:
    """Whether a step is one of those that can follow."""
    (came, paid, over), (after, reward, ends) = step, one
    return came == after and over == ends and (reward is None or math.isclose(paid, reward, rel_tol=1e-6, abs_tol=1e-6))


def _told(step: tuple[Any, float | None, bool]) -> str:
    came, reward, ends = step
    paid = "a reward that is drawn" if reward is None else f"the reward {reward:.4g}"
    return f"there follows {came} with {paid}{' and the end' if ends else ''}"


def _require_same_share(mine: list[Any], other: list[Any], says: str) -> None:
    """Refuse shares that differ by more than chance, of whatever there is but None."""
    for what in sorted({*other, *mine} - {None}, key=str):
        shares, others = (np.array([one == what for one in values], float) for values in (mine, other))
        if _differ(shares, others):
            raise WrongAnswer(
                f"{says}{what} in {shares.mean():.0%} of all cases in {NAME}, and in {others.mean():.0%} in your"
                " problem"
            )


def _differ(here: Reals, there: Reals) -> bool:
    """Whether two means differ by more than chance."""
    chance = np.concatenate([here, there]).std() * math.sqrt(1 / len(here) + 1 / len(there))
    return bool(abs(here.mean() - there.mean()) > SIGMAS * chance + 1e-9)
