"""A program from a blank file: it is run on environments that note every step, and judged by these steps alone.

The contract is the same in all lessons. `my_program(environment, n_steps, seed)` takes `n_steps` steps in a Gymnasium
environment by a loop of its own, and returns its policy: a function from an observation to the best action by what it
has learned. Everything else is the student's.
"""

import math
import operator
import re
from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from typing import Any, NamedTuple

import gymnasium
import numpy as np
from gymnasium import spaces

from edugym.checks.parameters import in_short
from edugym.mdp.protocol import Reals
from edugym_course.grading.agents import require_function
from edugym_course.grading.choices import action_of
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.student_code import student_code

Environment = gymnasium.Env[Any, Any]
Policy = Callable[[Any], Any]
Program = Callable[[Environment, int, int], Policy]

NAME = "my_program"
POLICY = f"the policy that {NAME} returns"
ENOUGH = 0.9
"""The share of the steps that a program must take if it ends with an episode."""
UNSEEDED = "gives no seed to its first reset, so two runs with one seed differ: begin with"
"""What is said of a program without a seed, before how its first reset should look."""
FEWEST_STARTS, ALIKE = 200, 0.97
"""Of more episodes than so many, the share that begins with one action: by ε-greedy with four it is 0.93 at most."""
APART = 1_000_003
"""How far the seed of an environment is from that of a program: two generators with one seed draw the same numbers."""
SELDOM = 0.02
"""The share of the observations in which a policy may draw its action, among equals where ours sees no tie."""
GYMNASIUM = {
    "only integers|unhashable type: 'dict'": "reset gives two things: state, info = environment.reset()",
    "'Recorder' object has no attribute": "a program is told `observation_space` and `action_space`, and what reset and"
    " step give, and nothing else of the environment",
    "values to unpack": "step gives five things: state, reward, terminated, truncated, info = environment.step(action)",
}.items()
"""What often lies behind an error in a program that uses Gymnasium, by what its message contains."""


class Step(NamedTuple):
    """A step, as the environment saw it."""

    state: Any
    action: Any
    reward: float
    next_state: Any
    terminated: bool
    truncated: bool


class Recorder(gymnasium.Wrapper[Any, Any, Any, Any]):
    """An environment that notes every step, and refuses those that no environment allows.

    It shows no more than what an agent may know: no info, and not the environment itself.

    Attributes:
        steps: the steps so far.
        given_seed: the seed that the first reset gave, None if it gave none.
        slip: the sentence of the first thing that was refused, "" if there is none.
    """

    def __init__(
        self, environment: Environment, n_steps: float, seed: int, who: str = NAME, fixed: int | None = None
    ) -> None:
        """Note the steps of `who`: at most `n_steps`, and then those to the end of the episode under way.

        The environment draws from the seed that the first reset gives, or from `seed` if it gives none; with `fixed`,
        always from that.
        """
        super().__init__(environment)
        environment.action_space.seed(seed)
        self._chance = environment.action_space.np_random
        self._unused = self._chance.bit_generator.state
        self.steps: list[Step] = []
        self.given_seed: int | None = None
        self.slip = ""
        self._most, self._seed, self._who, self._fixed = n_steps, seed, who, fixed
        self._state: Any = None
        self._is_new, self._is_over, self._has_begun = False, True, False

    @property
    def unwrapped(self) -> Environment:
        """This environment: what is inside would tell the way."""
        return self

    @property
    def samples_unseeded(self) -> bool:
        """Whether actions were drawn from the action space, and it was not given a seed."""
        chance = self.env.action_space.np_random  # a seed puts another one into its place
        return chance is self._chance and chance.bit_generator.state != self._unused

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Any, dict[str, Any]]:
        """Begin an episode."""
        if self._has_begun and seed is not None:
            self._refuse(
                "calls reset(seed=...) more than once: give the seed at the first reset only, and call reset() after"
                " that"
            )
        if not self._is_over and not self._is_new:
            self._refuse("calls reset() in the middle of an episode: go on until `terminated` or `truncated` is True")
        if not self._has_begun:
            self.given_seed = seed
            seed = APART + (self._fixed if self._fixed is not None else self._seed if seed is None else seed)
        state, _ = self.env.reset(seed=seed, options=options)
        self._state, self._has_begun, self._is_new, self._is_over = state, True, True, False
        return state, {}

    def step(self, action: Any) -> tuple[Any, float, bool, bool, dict[str, Any]]:
        """Take a step."""
        if not self._has_begun:
            self._refuse("takes a step before the first reset(): begin with state, info = environment.reset(seed=seed)")
        if self._is_over:
            self._refuse(
                "takes a step after the end of an episode: call reset() when `terminated` or `truncated` is True (and"
                " use these names for nothing else), and go on from the state that it gives"
            )
        if self._is_new and len(self.steps) >= self._most:
            self._refuse(f"begins another episode after its {self._most} steps: count the steps of all episodes")
        taken = self._allowed(action)
        state, reward, terminated, truncated, _ = self.env.step(taken)
        self.steps.append(Step(self._state, taken, float(reward), state, bool(terminated), bool(truncated)))
        self._state, self._is_new, self._is_over = state, False, bool(terminated or truncated)
        return state, float(reward), bool(terminated), bool(truncated), {}

    def _allowed(self, action: Any) -> Any:
        """Return an action that the environment can take, or refuse it."""
        space = self.env.action_space
        if action is None:
            self._refuse("chooses None as an action: is a `return` missing?")
        if isinstance(space, spaces.Box):
            return self._real(action)
        assert isinstance(space, spaces.Discrete)
        most = int(space.n) - 1
        if isinstance(action, list | tuple) or np.ndim(action):
            self._refuse(
                f"chooses {in_short(action)} as an action, and it should be one whole number from 0 to {most}: take an"
                " entry of it"
            )
        try:
            number = operator.index(action)
        except TypeError:
            self._refuse(f"chooses {in_short(action)} as an action: it should be a whole number from 0 to {most}")
        if not 0 <= number <= most:
            self._refuse(f"chooses the action {number}: there are the actions 0 to {most}")
        return number

    def _real(self, action: Any) -> float:
        """Return an action that is one real number, or refuse it."""
        try:
            number = float(np.asarray(action, float).item())
        except (TypeError, ValueError):
            self._refuse(f"chooses {in_short(action)} as an action, and it should be one real number")
        if not math.isfinite(number):
            self._refuse(f"chooses {number} as an action: does what it learns grow without end?")
        return number

    def _refuse(self, what: str) -> Any:
        self.slip = self.slip or f"{self._who} {what}"
        raise WrongAnswer(self.slip)


class Run(NamedTuple):
    """What a program did in an environment.

    Attributes:
        steps: all its steps.
        policy: what it returned.
        given_seed: the seed that it gave to its environment.
    """

    steps: Sequence[Step]
    policy: Policy
    given_seed: int | None = None

    @property
    def returns(self) -> Reals:
        """The returns of the episodes that ended, without a discount."""
        totals, total = [], 0.0
        for step in self.steps:
            total += step.reward
            if step.terminated or step.truncated:
                totals.append(total)
                total = 0.0
        return np.array(totals)

    def late(self, share: float = 0.25) -> float:
        """The mean return of the last episodes, a share of all; NaN if none ended."""
        returns = self.returns
        return float(returns[-math.ceil(share * len(returns)) :].mean()) if len(returns) else math.nan


def run_program(
    program: Any,
    environment: Environment,
    n_steps: int,
    seed: int,
    environment_seed: int | None = None,
    noun: str = "state",
) -> Run:
    """Run a program, with the seed that it gives to the environment or with another one.

    `noun` says what its policy is given.

    Raises:
        WrongAnswer: it breaks the contract, raises an error or does not end.
    """
    require_function(NAME, program, "environment, n_steps and seed")
    call = f"{NAME}(environment, {n_steps}, {seed})"
    recorder = Recorder(environment, n_steps, seed, fixed=environment_seed)
    try:
        with student_code(call):
            policy = program(recorder, n_steps, seed)
    except WrongAnswer as wrong:
        told = [hint for pattern, hint in GYMNASIUM if re.search(pattern, str(wrong))]
        raise type(wrong)("; ".join([str(wrong), *told])) from None
    if recorder.slip:  # the program caught it, and went on
        raise WrongAnswer(recorder.slip)
    if not recorder.steps:
        raise WrongAnswer(f"{NAME} takes no step in the environment that it is given: does it make one of its own?")
    require_steps(len(recorder.steps), n_steps, recorder.steps[-1].terminated or recorder.steps[-1].truncated)
    if recorder.given_seed is None:
        raise WrongAnswer(f"{NAME} {UNSEEDED} state, info = environment.reset(seed=seed)")
    if recorder.samples_unseeded:
        raise WrongAnswer(
            f"{NAME} draws from environment.action_space.sample(), and gives it no seed, so two runs with one seed"
            " differ: draw from rng = np.random.default_rng(seed), or begin with environment.action_space.seed(seed)"
        )
    require_policy(call, policy, noun, is_real=isinstance(environment.action_space, spaces.Box))
    return Run(recorder.steps, policy, recorder.given_seed)


def require_steps(taken: int, n_steps: int, is_over: bool) -> None:
    """Refuse a program that takes too few steps, or too many.

    Args:
        taken: how many it takes.
        n_steps: how many were asked for.
        is_over: whether an episode ends with the last one: some programs end with an episode.

    Raises:
        WrongAnswer: it does.
    """
    if taken == n_steps - 1 and not is_over:
        raise WrongAnswer(
            f"{NAME} takes {taken} of its {n_steps} steps: one is missing; does the loop begin at 1, or end at"
            " n_steps - 1?"
        )
    if taken < (ENOUGH if is_over else 1) * n_steps:
        raise WrongAnswer(
            f"{NAME} takes {taken} of its {n_steps} steps: go on, episode after episode, until all are taken"
        )
    if taken > n_steps and not is_over:
        why = "is there a `<=` in place of `<`, or does the loop end at n_steps + 1?"
        if taken > n_steps + 1:
            why = "look after *each* step whether all are taken"
        raise WrongAnswer(
            f"{NAME} takes {taken} steps, and {n_steps} were asked for: {taken - n_steps} too many; {why}"
        )


def begins(steps: Sequence[Step]) -> list[bool]:
    """Return for each step of a run whether an episode begins with it."""
    return [True, *(step.terminated or step.truncated for step in steps[:-1])]


def require_varied_starts(runs: Iterable[Sequence[Step]]) -> None:
    """Refuse a program that begins all its episodes with one action, where ε-greedy would often take another.

    Raises:
        WrongAnswer: it does.
    """
    alike = n_episodes = 0
    for steps in runs:
        begun = Counter(step.action for step, first in zip(steps, begins(steps), strict=True) if first)
        alike += begun.most_common(1)[0][1]
        n_episodes += begun.total()
    if n_episodes > FEWEST_STARTS and alike > ALIKE * n_episodes:
        raise WrongAnswer(
            f"{NAME} begins {alike} of {n_episodes} episodes in small worlds with one and the same action: after a"
            " reset draw the action by ε-greedy, too, from the values of the state that reset() gives"
        )


def require_policy(call: str, policy: Any, noun: str = "state", is_real: bool = False) -> None:
    """Refuse a returned value that cannot be called with an observation, or a state: `noun` says what it is called.

    `is_real` says whether actions are real numbers.
    """
    what = f"a function from {'an' if noun[0] in 'aeiou' else 'a'} {noun} to an action"
    if policy is None:
        raise WrongAnswer(f"{call} gives None: return the policy, {what}")
    if isinstance(policy, type) or not callable(policy):
        kind = f"the class {policy.__name__}" if isinstance(policy, type) else f"of the type {type(policy).__name__}"
        at = {"state": noun, "history": "window(history)"}.get(noun, f"tuple({noun})")
        actions = f"`lambda {noun}: actions[{at}]` for an array with an action for each {noun}"
        if is_real:
            ways = actions
        elif isinstance(policy, np.ndarray) and policy.ndim == 1:
            ways = f"{actions}, and `lambda {noun}: int(np.argmax(Q))` for the values of a single state"
        else:
            ways = f"`lambda {noun}: int(Q[{at}].argmax())` for a table of action values, and {actions}"
        raise WrongAnswer(f"{call} should return {what}, but what it returns is {kind}: return {ways}")


def actions_of(policy: Policy, observations: Iterable[Any], n_actions: int, noun: str = "state") -> list[int]:
    """Return the action that a policy takes for each observation, or state; each is asked for twice.

    Raises:
        WrongAnswer: the policy fails, takes no action that there is, or draws its actions.
    """
    pairs = list[list[int]]()
    for observation in observations:
        what = f"the policy of {NAME}, for the {noun} {observation},"
        with student_code(what):
            pairs.append([action_of(what, policy(observation), n_actions) for _ in range(2)])
    drawn = sum(one != again for one, again in pairs)
    if drawn > SELDOM * len(pairs):
        raise WrongAnswer(
            f"{POLICY} draws its actions: asked twice about one {noun}, it gives two different actions in {drawn} of"
            f" {len(pairs)} cases. It should take the *best* action, and never a random one. (Or does it look up what"
            " was never learned, so that chance decides among equal values?)"
        )
    return [one for one, _ in pairs]


def returns_of(policy: Policy, environment: Environment, episodes: int, seed: int, remembers: bool = False) -> Reals:
    """Play episodes by a policy, and return their returns.

    Args:
        policy: the policy.
        environment: where it plays.
        episodes: how many.
        seed: of the environment.
        remembers: whether it is given the history of the episode, O_0, A_0, O_1, ..., O_t, in the place of O_t alone.

    Raises:
        WrongAnswer: the policy fails, or chooses no action that there is.
    """
    recorder = Recorder(environment, math.inf, seed, POLICY)
    for _ in range(episodes):
        state, _ = recorder.reset()
        history: tuple[Any, ...] = (state,)
        over = False
        while not over:
            with student_code(POLICY):
                action = policy(history if remembers else state)
            state, _, terminated, truncated, _ = recorder.step(action)
            history, over = (*history, recorder.steps[-1].action, state), terminated or truncated
    return Run(recorder.steps, policy).returns


def shape_of(environment: Environment) -> tuple[int, int]:
    """Return the shape of a table for an environment: how many numbers an observation can be, and how many actions."""
    assert isinstance(environment.action_space, spaces.Discrete)
    return spaces.flatdim(environment.observation_space), int(environment.action_space.n)


def learn_from(agent: Any, names: Sequence[str], step: Step, next_action: int) -> None:
    """Let an agent of the package learn from a step; `names` are what its `learn` asks for."""
    agent.learn(**{name: next_action if name == "next_action" else getattr(step, name) for name in names})
