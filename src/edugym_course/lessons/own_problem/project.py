"""The project of lesson 10: a Gymnasium environment of one's own, from a blank file."""

import math
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces
from gymnasium.utils.env_checker import check_env

from edugym.adapters.gymnasium_env import MDPEnv
from edugym.checks.interfaces import require_mdp
from edugym.checks.parameters import in_short
from edugym_course.grading.agents import require_class
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.programs import APART, Environment
from edugym_course.grading.student_code import student_code
from edugym_course.grading.values import number
from edugym_course.lessons.own_problem.comparison import NAME, parts, require_same

EPISODES, SCRIPTED, MOST_STEPS = 100, 5, 10_000
"""How many episodes are played at random and with given actions, and how many steps one may take."""
BEGUN, FIRST_STEPS, DIFFERENT, MOMENTS = 60, 50, 5, 30
"""So many episodes are begun without a seed, and with seeds, for a few steps; so many of the latter differ if chance
plays a part that shows; at so many moments of an episode another one is begun."""

Episode = list[tuple[Any, float]]
"""The observations and rewards of an episode; the first reward is 0."""


def project_10(answer: Any, seed: int) -> str:
    """Check an environment: what it returns, that seeds and actions matter, and what Gymnasium's checker says.

    `answer` is its class; or a pair of it and of the same problem in the form of exercise 4, with which it is compared.
    """
    if type(answer) in (tuple, list):  # a problem may be a NamedTuple
        return _compared(answer, seed)
    require_class(NAME, answer)
    if not issubclass(answer, gymnasium.Env):
        raise WrongAnswer(f"{NAME} should inherit from gymnasium.Env: class {NAME}(gymnasium.Env)")
    environment, rng = _made(answer), np.random.default_rng(APART + seed)
    assert isinstance(environment.action_space, spaces.Discrete)
    n_actions = int(environment.action_space.n)
    played = [
        _episode(environment, lambda: int(rng.integers(n_actions)), seed if k == 0 else None) for k in range(EPISODES)
    ]
    script = [int(action) for action in rng.integers(n_actions, size=MOST_STEPS)]
    again, new, other = (_scripted(one, script, seed) for one in (environment, _made(answer), _made(answer)))
    begun = [[_begun(_made(answer), script, number) for _ in range(2)] for number in range(BEGUN)]
    if not (_same(new, other) and all(_same(*pair) for pair in begun)):
        raise WrongAnswer(
            f"two environments with seed {seed} and the same actions differ: begin reset with super().reset(seed=seed),"
            " draw all random numbers from the self.np_random that it makes, and keep nothing in the class itself"
        )
    if not (_same(again, new) and _begins_anew(environment, script, seed, new)):
        raise WrongAnswer(
            f"after {EPISODES} episodes reset(seed={seed}) begins another episode than in a new environment: reset must"
            " set everything anew that an episode changes, and all random numbers should come from self.np_random"
        )
    if not _plays_alone(environment, _made(answer), script, seed, new):
        raise WrongAnswer(
            "an episode changes when another environment of the same class plays beside it: all that changes belongs to"
            " the object. Set it in reset, as self.state = [...], change no list or number of the class, and draw from"
            " self.np_random alone, after super().reset(seed=seed)"
        )
    if not _same(_scripted(_made(answer), [*np.array(script)], seed), new):
        raise WrongAnswer(
            f"with actions such as np.int64({script[0]}) in place of {script[0]} other episodes come. Agents often"
            " choose whole numbers of NumPy, so compare an action by `==`, not by `is`, and do not ask for its type"
        )
    _require_new_luck(answer, script)
    _require_new_start(answer, environment, script, seed)
    repeated = [_scripted(environment, [action] * MOST_STEPS, seed) for action in range(n_actions)]  # each must end
    if all(_same(episode, new) for episode in repeated):
        raise WrongAnswer("whatever the actions are, the same is observed and paid: what should the agent decide?")
    with student_code("Gymnasium's check_env"):
        check_env(_made(answer), skip_render_check=True)
    no_luck = all(
        _same(*(_begun(_made(answer), script[number:], one) for one in (seed, seed + number)))
        for number in range(BEGUN)
    )
    lengths, totals = [len(one) for one in played], [_total(one) for one in played]
    return (
        f"Right{', if there is no chance in it (every seed gives the same episodes)' if no_luck else ''}: Gymnasium's"
        f" checker passes it. Random play takes {np.mean(lengths) - 1:.1f} steps and gets"
        f" {np.mean(totals):.4g}{' in every episode: is there something to learn?' if len({*totals}) == 1 else '.'}"
    )


def _compared(pair: Sequence[Any], seed: int) -> str:
    """Check an environment, and that it plays like the same problem in the form of exercise 4."""
    if len(pair) != 2:
        raise WrongAnswer(f"check {NAME} alone, or two things, ({NAME}, my_problem), but here are {len(pair)}")
    answer, problem = pair
    told = project_10(answer, seed)
    with student_code("my_problem"):
        require_mdp(problem, "my_problem")
        other = MDPEnv(problem)
        if not isinstance(other.action_space, spaces.Discrete):
            raise WrongAnswer(f"the actions of my_problem should be numbered, but are {other.action_space}")
    require_same(_made(answer), other, seed)
    return f"{told} It plays like {type(problem).__name__}."


def _made(answer: Any) -> Environment:
    """Make an environment, and look at its spaces."""
    with student_code(f"{NAME}()"):
        made = answer()
    for name in ("observation_space", "action_space"):
        if not isinstance(getattr(made, name, None), spaces.Space):
            raise WrongAnswer(
                f"{NAME} should set self.{name} in __init__, a space such as gymnasium.spaces.Discrete(4)"
            )
    if not isinstance(made.action_space, spaces.Discrete) or made.action_space.n < 2 or made.action_space.start != 0:
        raise WrongAnswer(
            f"the action space of {NAME} is {made.action_space}, and it should be Discrete(n) with two actions or more"
        )
    environment: Environment = made
    return environment


def _begins_anew(environment: Environment, script: list[int], seed: int, new: Episode) -> bool:
    """Whether a reset with a seed begins the same episode at whatever moment it comes."""
    begun = _begun(environment, script, seed)
    for moment in range(MOMENTS):
        _episode(environment, partial(next, iter(script[moment:])), None, 1 + moment)
        if not _same(_begun(environment, script, seed), begun):
            return False
    return _same(begun, new[: len(begun)])


def _plays_alone(environment: Environment, other: Environment, script: list[int], seed: int, alone: Episode) -> bool:
    """Whether the episodes of `_scripted` stay the same if another environment begins anew before each action."""

    def choose(actions: Iterator[int]) -> int:
        with student_code("step(0)"):
            other.reset(seed=seed + 1)
            other.step(0)
        return next(actions)

    played: Episode = []
    try:
        for index in range(SCRIPTED):
            played += _episode(environment, partial(choose, iter(script)), None if index else seed)
    except WrongAnswer:  # alone it plays without one
        return False
    return _same(played, alone)


def _require_new_luck(answer: Any, script: list[int]) -> None:
    """Refuse an environment whose reset without a seed brings the same luck again and again."""
    environment = _made(answer)
    _begun(environment, script, 0)
    unseeded = [_begun(environment, script, None) for _ in range(BEGUN)]
    if all(_same(one, unseeded[0]) for one in unseeded):
        seeded = [_begun(environment, script, number) for number in range(BEGUN)]
        if sum(not _same(one, seeded[0]) for one in seeded) >= DIFFERENT:
            raise WrongAnswer(
                f"{BEGUN} episodes that begin with reset(), without a seed, are all the same, and with other seeds they"
                " differ: seed is None then, def reset(self, *, seed=None, options=None), and super().reset(seed=seed)"
                " gets it as it is; self.np_random goes on"
            )


def _require_new_start(answer: Any, used: Environment, script: list[int], seed: int) -> None:
    """Refuse an environment whose reset without a seed leaves something of the episodes before.

    With equal generators an environment that was used should play as new ones do. Where new ones with other seeds
    differ, the luck comes from a generator of their own, and nothing is said.
    """
    played: list[list[Episode]] = []
    for index in range(BEGUN):
        new, other = _made(answer), _made(answer)
        new.reset(seed=seed)
        other.reset(seed=seed + 1)
        played.append([])
        for environment in (used, new, other):
            environment.np_random = np.random.default_rng(APART + index)
            played[-1].append(_begun(environment, script, None))
    if all(_same(new, other) for _, new, other in played) and not all(_same(old, new) for old, new, _ in played):
        raise WrongAnswer(
            f"after {EPISODES} episodes reset() begins another one than in a new environment: also without a seed, it"
            " must set everything anew that an episode changes"
        )


def _begun(environment: Environment, script: list[int], seed: int | None) -> Episode:
    """Play the first steps of an episode."""
    return _episode(environment, partial(next, iter(script)), seed, FIRST_STEPS)


def _scripted(environment: Environment, script: list[int], seed: int) -> Episode:
    """Play some episodes, each with the same actions, and return them as one."""
    played: Episode = []
    for index in range(SCRIPTED):
        actions = iter(script)
        played += _episode(environment, partial(next, actions), None if index else seed)
    return played


def _episode(environment: Environment, choose: Callable[[], int], seed: int | None, most: int = MOST_STEPS) -> Episode:
    """Play an episode, or so many steps of one, and check all that comes."""
    with student_code("reset()" if seed is None else "reset(seed=...)"):
        begun: Any = environment.reset() if seed is None else environment.reset(seed=seed)
    if not isinstance(begun, tuple) or len(begun) != 2 or not isinstance(begun[1], dict):
        raise WrongAnswer(
            f"reset should return two things, an observation and a dictionary, `return observation, {{}}`, but returns"
            f" {in_short(begun)}"
        )
    episode = [(_observed(environment, begun[0], "reset"), 0.0)]
    for _ in range(most):
        action = choose()
        with student_code(f"step({action})"):
            came: Any = environment.step(action)
        if not isinstance(came, tuple) or len(came) != 5:
            raise WrongAnswer(
                f"step({action}) should return five things, observation, reward, terminated, truncated and a"
                f" dictionary, but returns {in_short(came)}"
            )
        observation, reward, terminated, truncated, _ = came
        if not _is_in(environment, observation) and _is_in(environment, reward):
            raise WrongAnswer(
                f"step({action}) returns {in_short(came)}: the observation is the first of the five things, and the"
                " reward the second"
            )
        if reward is None:
            raise WrongAnswer(f"step({action}) gives None as the reward, the second of the five: it should be a number")
        for name, ended in (("terminated", terminated), ("truncated", truncated)):
            if not isinstance(ended, bool | np.bool_):
                raise WrongAnswer(
                    f"step({action}) should say by True or False whether it is {name}, but says {in_short(ended)}"
                )
        if isinstance(truncated, np.bool_):
            raise WrongAnswer(
                f"step({action}) says by a {type(truncated).__name__} of NumPy whether it is truncated, and Gymnasium's"
                " checker wants True or False of Python: bool(...)"
            )
        episode.append((_observed(environment, observation, f"step({action})"), number("the reward", reward)))
        if terminated or truncated:
            return episode
    if most < MOST_STEPS:
        return episode
    raise WrongAnswer(
        f"an episode of {NAME} has not ended after {MOST_STEPS} steps, of random actions or of one action again and"
        " again: when is `terminated` or `truncated` True?"
    )


def _is_in(environment: Environment, observation: Any) -> bool:
    return observation is not None and bool(environment.observation_space.contains(observation))


def _observed(environment: Environment, observation: Any, call: str) -> Any:
    """Return a copy of an observation that lies in its space."""
    if not environment.observation_space.contains(observation):
        space, hint = environment.observation_space, ""
        if isinstance(space, spaces.Dict | spaces.Tuple):
            hint = ": does each of its parts lie in the space of that part?"
        elif np.shape(observation) != (space.shape or ()):
            hint = f": it has the shape {np.shape(observation)}, and an element of the space has {space.shape or ()}"
        elif isinstance(space, spaces.Box | spaces.MultiDiscrete) and getattr(observation, "dtype", 0) != space.dtype:
            hint = f": make an array of its kind of numbers, np.array(..., dtype=np.{space.dtype})"
        elif isinstance(space, spaces.Discrete) and not isinstance(observation, int | np.integer):
            hint = ": it should be one whole number, an int"
        else:
            hint = ": is the space too small, should the episode have ended before, or should reset set this anew?"
        raise WrongAnswer(
            f"{call} gives the observation {in_short(observation)}, which is not in the observation space {space}{hint}"
        )
    return parts(observation)


def _same(one: Episode, other: Episode) -> bool:
    """Whether two episodes are the same."""
    return len(one) == len(other) and all(
        len(here) == len(there) and all(map(np.array_equal, here, there)) and reward == other_reward
        for (here, reward), (there, other_reward) in zip(one, other, strict=True)
    )


def _total(episode: Episode) -> float:
    return math.fsum(reward for _, reward in episode)
