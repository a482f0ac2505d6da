"""Whether an MDP is one, and what its methods return: each mistake is answered with one sentence.

The sentence names the method, what it returned, the state it was given, and what it should return. The first steps of
a student's MDP are checked in this way; the package's own MDPs are covered by its tests.
"""

import copy
import difflib
import inspect
from collections.abc import Iterable
from typing import Any

import numpy as np
from gymnasium import ActionWrapper, Env, ObservationWrapper, RewardWrapper, Wrapper, spaces
from numpy.random import Generator as Random

from edugym.checks.parameters import in_short, number_of_steps
from edugym.checks.values import GlobalDraws, fits, is_finite_number, kept, same
from edugym.system.packages import is_ours, package_of

METHODS = {
    "initial": ("rng",),
    "transition": ("state", "action", "rng"),
    "reward": ("state", "action", "next_state", "rng"),
    "terminal": ("state",),
    "observation": ("state", "rng"),
}
"""What every MDP has, and what each method takes."""
SPACES = ("observation_space", "action_space")
CHECKED_STEPS = 200
OTHER_NAMES = {
    "initial": ("reset", "start", "initial_state"),
    "transition": ("step", "next_state", "dynamics"),
    "terminal": ("is_terminal", "done", "terminated", "is_done"),
    "observation": ("observe", "obs"),
    "act": ("choose", "choose_action", "select_action", "get_action", "policy"),
    "learn": ("update", "train", "fit"),
    "greedy": ("greedy_act", "act_greedy"),
}
"""What else students call these methods."""


def require_mdp(mdp: Any, name: str = "mdp") -> None:
    """Refuse what is no MDP: it needs five methods and two spaces; its step limit, if any, must be a whole number.

    Args:
        mdp: the value.
        name: of the parameter that it was given for.

    Raises:
        ValueError: something is missing, or is not as it must be.
    """
    if isinstance(mdp, type):
        raise ValueError(f"{name} must be a value, but is {a_class(mdp)}")
    if isinstance(mdp, str):
        raise ValueError(f"{name} must be an MDP, but is the name {mdp!r}: use edugym.make_mdp({mdp!r})")
    if isinstance(mdp, Env) or not any(_has(mdp, method) for method in METHODS):
        raise ValueError(
            f"{name} must be an MDP, a value with the methods {', '.join(METHODS)} and the properties"
            f" {' and '.join(SPACES)}, but is {in_short(mdp)}"
        )
    is_wrapper = "mdp" in getattr(mdp, "_fields", ())
    if is_wrapper and (isinstance(mdp.mdp, type) or not _has(mdp.mdp, "initial")):
        require_mdp(mdp.mdp, f"mdp of {_name(mdp)}")
    for method, parameters in METHODS.items():
        require_method(mdp, method, parameters, METHODS)
    require_spaces(mdp)
    if not is_own(inner := getattr(mdp, "mdp", None)) and is_ours(type(mdp)):
        require_mdp(inner, f"mdp of {_name(mdp)}")
    actions = mdp.action_space
    if isinstance(actions, spaces.Discrete) and actions.start != 0:
        raise ValueError(f"action_space of {_name(mdp)} must number the actions from 0, but is {actions}")
    step_limit(mdp)


def require_task(environment: Any) -> int | None:
    """Refuse what nobody can train in, and return its step limit, or None where it is unknown or there is none.

    Raises:
        ValueError: it is neither an MDP nor a Gymnasium environment, or something in it is missing.
    """
    if hasattr(environment, "act") and not hasattr(environment, "observation_space"):
        kind = environment if isinstance(environment, type) else type(environment)
        raise ValueError(f"environment must come first, before the agent, but is the agent {kind.__name__}")
    if isinstance(environment, type):
        require_mdp(environment, "environment")  # says how to make a value
    require_environment("environment", environment, "an MDP, a Gymnasium environment or a name")
    if isinstance(environment, Env):
        require_env(environment)
        require_spaces(environment)
        inside = getattr(environment.unwrapped, "mdp", None)
        return environment.spec.max_episode_steps if inside is None and environment.spec else step_limit(inside)
    if not is_own(environment):
        require_mdp(environment, "environment")
    return step_limit(environment)


def require_env(env: Env[Any, Any]) -> None:
    """Refuse an environment, or a wrapper in it, whose `reset` or `step` is missing or takes something else.

    Raises:
        ValueError: one of them is not as Gymnasium calls it.
    """
    name = type(env).__name__
    if isinstance(env, Wrapper) and "_observation_space" not in vars(env):
        raise ValueError(f"__init__ of {name} must call super().__init__(env)")
    for kind, method in ((ObservationWrapper, "observation"), (ActionWrapper, "action"), (RewardWrapper, "reward")):
        if isinstance(env, kind) and getattr(type(env), method) is getattr(kind, method):
            raise ValueError(f"{name} must have a method {method}(self, {method})")
    for method, takes, given, named in (
        ("reset", "(self, *, seed=None, options=None)", (), {"seed": None, "options": None}),
        ("step", "(self, action)", ("action",), {}),
    ):
        if getattr(type(env), method) is getattr(Env, method):
            raise ValueError(f"{name} must have a method {method}{takes}")
        signature = inspect.signature(getattr(env, method))
        try:
            signature.bind(*given, **named)
        except TypeError:
            taken = ", ".join(["self", *map(str, signature.parameters.values())])
            raise ValueError(f"{method} of {name} must take {takes}, but takes ({taken})") from None
    if isinstance(env, Wrapper):
        require_env(env.env)


def step_limit(mdp: Any) -> int | None:
    """The number of steps after which an episode of `mdp` is truncated, or None when there is no limit.

    Raises:
        ValueError: `max_steps` is neither None nor a whole number of 1 or more.
    """
    try:
        limit = mdp.max_steps
    except AttributeError:
        if _defines(mdp, "max_steps"):  # `max_steps` is a property whose own code raised this AttributeError: show it
            raise
        return None
    if limit is None:
        return None
    number_of_steps("max_steps", limit)
    return int(limit)


def _defines(mdp: Any, name: str) -> bool:
    """Whether the class of `mdp` defines `name`. If `mdp` is a wrapper, the MDP that it wraps counts too."""
    inner = getattr(mdp, "mdp", None)
    return hasattr(type(mdp), name) or (inner is not None and _defines(inner, name))


def a_class(kind: type) -> str:
    """A class that was given in place of a value, for a message: its name, and how a value is made."""
    made = f"{kind.__name__}.create(...)" if hasattr(kind, "create") else f"{kind.__name__}(...)"
    return f"the class {kind.__name__}: make one with {made}"


def check_mdp(mdp: Any, n_steps: int = CHECKED_STEPS) -> list[Any]:
    """Play some random steps of a student's MDP, and check what its methods return.

    It plays a copy, with a random stream of its own.

    Args:
        mdp: the task.
        n_steps: how many steps to play.

    Returns:
        The states met, in order; an initial one first.

    Raises:
        ValueError: it is no MDP, or one of its methods returns what it may not.
    """
    require_mdp(mdp)
    _require_names(mdp)
    mdp, rng, actions = copy.deepcopy(mdp), np.random.default_rng(0), copy.deepcopy(mdp.action_space)
    actions.seed(0)
    checked = not is_own(mdp)
    first = CheckedMDP(mdp) if checked else mdp
    state = first.initial(rng)
    states = [state]
    if checked:
        first.observation(state, rng)
    for _ in range(n_steps):
        action = actions.sample()
        action = int(action) if isinstance(actions, spaces.Discrete) else action
        if checked:
            state, _, terminated, _ = checked_step(mdp, state, action, rng)
        else:
            state = mdp.transition(state, action, rng)
            terminated = mdp.terminal(state)
        states.append(state)
        if terminated:
            state = mdp.initial(rng)
            states.append(state)
    return states


def _require_names(mdp: Any) -> None:
    """Refuse a list of names of actions that is too short or too long."""
    names, actions = getattr(mdp, "action_names", None), mdp.action_space
    if isinstance(names, tuple | list) and isinstance(actions, spaces.Discrete) and len(names) != actions.n:
        raise ValueError(
            f"action_names of {_name(mdp)} must have a name for each action, {actions.n}, but has {len(names)}"
        )


def checked_step(mdp: Any, state: Any, action: Any, rng: Random) -> tuple[Any, float, bool, Any]:
    """Take one step.

    Returns:
        The next state, the reward, whether the task has ended, and the observation as the MDP returned it.

    Raises:
        ValueError: a method returns what it may not, or changes the state that it was given.
    """
    checked = CheckedMDP(mdp)
    next_state = checked.transition(state, action, rng)
    reward = checked.reward(state, action, next_state, rng)
    terminated = checked.terminal(next_state)
    return next_state, float(reward), bool(terminated), checked.observation(next_state, rng)


def checked_mdp(mdp: Any, steps: float = CHECKED_STEPS, instead_of: tuple[type, ...] = ()) -> Any:
    """Return the MDP with checks around a student's MDP, also where that is inside the package's wrappers.

    Args:
        mdp: the task.
        steps: how many steps are checked in every way.
        instead_of: classes of wrappers that check less; they are left out.
    """
    if is_own(mdp):
        return mdp
    if type(mdp) in instead_of:
        return checked_mdp(mdp.mdp, steps, instead_of)
    if is_ours(type(mdp)) and not is_own(getattr(mdp, "mdp", None)):
        return mdp._replace(mdp=checked_mdp(mdp.mdp, steps, instead_of))
    return CheckedMDP(mdp, steps)


def refuse_nothing(mdp: Any, state: Any, action: Any, next_state: Any) -> None:
    """Refuse a transition, or else a reward, that is None.

    Raises:
        ValueError: always.
    """
    if next_state is None:
        raise ValueError(_sentence(mdp, "transition", None, "the next state", state, action))
    raise ValueError(_sentence(mdp, "reward", None, "a finite number", state, action, next_state))


class CheckedMDP:
    """An MDP that checks what its methods return: it does what the MDP inside it does, and draws nothing itself.

    Args:
        mdp: the task.
        steps: for how many transitions everything is checked, also that no method changes a state or draws from global
            streams. Later only rewards and observations are checked, which takes less time.
    """

    def __init__(self, mdp: Any, steps: float = CHECKED_STEPS) -> None:
        """See the class."""
        self._mdp, self._left, self._first = mdp, steps, None
        self._draws, self._space = GlobalDraws(type(mdp).__name__), mdp.observation_space
        self._rows = int(self._space.n) if isinstance(self._space, spaces.Discrete) and self._space.start == 0 else 0

    def __getattr__(self, name: str) -> Any:
        """Everything else that the MDP has."""
        return getattr(self._mdp, name)

    def initial(self, rng: Random) -> Any:
        """Draw the state in which an episode starts."""
        with self._draws.refused("initial"):
            self._first = self._mdp.initial(rng)
        return self._first

    def transition(self, state: Any, action: Any, rng: Random) -> Any:
        """Draw the next state.

        Raises:
            ValueError: it is None, or the state was changed.
        """
        self._left -= 1
        if self._left < 0:  # from here on without a detour: these two would only cost time
            vars(self).update(transition=self._mdp.transition, terminal=self._mdp.terminal)
            return self._mdp.transition(state, action, rng)
        next_state = self._unchanging("transition", (state,), action, rng)
        if next_state is None:
            raise ValueError(_sentence(self._mdp, "transition", None, "the next state", state, action))
        return next_state

    def reward(self, state: Any, action: Any, next_state: Any, rng: Random) -> Any:
        """Draw the reward.

        Raises:
            ValueError: it is no finite number, or a state was changed.
        """
        if self._left < 0:
            reward = self._mdp.reward(state, action, next_state, rng)
        else:
            reward = self._unchanging("reward", (state, action, next_state), rng)
        if not is_finite_number(reward):
            raise ValueError(_sentence(self._mdp, "reward", reward, "a finite number", state, action, next_state))
        return reward

    def terminal(self, state: Any) -> Any:
        """Whether the task ends in this state.

        Raises:
            ValueError: the answer is neither True nor False, or the state was changed.
        """
        terminated = self._unchanging("terminal", (state,))
        if not isinstance(terminated, bool | np.bool_ | int | np.integer):
            raise ValueError(_sentence(self._mdp, "terminal", terminated, "True or False", state))
        return terminated

    def observation(self, state: Any, rng: Random) -> Any:
        """Draw what the agent sees.

        Raises:
            ValueError: it is not in the observation space, or the state was changed.
        """
        if self._left < 0:
            observation = self._mdp.observation(state, rng)
        else:
            observation = self._unchanging("observation", (state,), rng)
        if not (type(observation) is int and 0 <= observation < self._rows):  # most are
            self._require_observation(observation, state)
        return observation

    def observe_into(self, state: Any, rng: Random, out: Any) -> None:
        """Write into `out` what the agent sees.

        Raises:
            ValueError: it is not in the observation space, or the state was changed.
        """
        before = kept(state)
        mdp: Any = self._mdp  # a method that not every MDP has
        mdp.observe_into(state, rng, out)
        refuse_change(self._mdp, "observe_into", before, state)
        self._require_observation(out, state)

    def _unchanging(self, method: str, given: tuple[Any, ...], *others: Any) -> Any:
        """Return what a method returns for states (and an action) that it may not change, and other arguments."""
        before = [kept(value) for value in given]
        with self._draws.refused(method):
            returned = getattr(self._mdp, method)(*given, *others)
        for was, value in zip(before, given, strict=True):
            refuse_change(self._mdp, method, was, value)
        return returned

    def _require_observation(self, observation: Any, state: Any) -> None:
        space = self._space
        if not fits(space, observation):
            if state is None:  # where nothing is wrong with what is seen, None is a state like others
                method, which = ("initial", "first") if self._first is None else ("transition", "next")
                raise ValueError(
                    f"{method} of {_name(self._mdp)} must return the {which} state, but returned None (is a return"
                    " missing?)"
                )
            raise ValueError(_sentence(self._mdp, "observation", observation, f"an element of {space}", state))


def innermost(mdp: Any) -> Any:
    """Return the MDP inside the package's wrappers."""
    return innermost(mdp.mdp) if is_ours(type(mdp)) and hasattr(mdp, "mdp") else mdp


def is_own(value: Any) -> bool:
    """Whether all classes in a value are the package's own, or Python's and NumPy's, and no student's."""
    if isinstance(value, tuple) and not all(map(is_own, value)):
        return False
    return is_ours(type(value)) or package_of(type(value)) in ("builtins", "numpy")


def require_method(owner: Any, name: str, parameters: tuple[str, ...], others: Iterable[str] = ()) -> None:
    """Refuse a value without such a method, or whose method takes something else.

    Args:
        owner: an MDP or an agent.
        name: of the method.
        parameters: what it is given, in this order; their names are free, but for those that stand in another place.
        others: the names of the other methods, for which this one cannot be misspelt.

    Raises:
        ValueError: there is none, or it does not take these.
    """
    wanted = f"{name}(self, {', '.join(parameters)})"
    if not _has(owner, name):
        candidates = [other for other in dir(owner) if other not in others and not other.startswith("_")]
        near = [other for other in OTHER_NAMES.get(name, ()) if other in candidates]
        near = near or difflib.get_close_matches(name, candidates, 1)
        hint = f"; is {near[0]!r} misspelt?" if near else ""
        if "mdp" in getattr(owner, "_fields", ()) and not near:
            hint = ", or the decorator @edugym.wrapper, which takes it from the MDP inside"
        raise ValueError(f"{_name(owner)} must have a method {wanted}{hint}")
    method = getattr(owner, name)
    if not callable(method):
        raise ValueError(f"{name} of {_name(owner)} must be a method, but is {in_short(method)}")
    signature = inspect.signature(method)
    moved = [taken for taken, given in zip(signature.parameters, parameters, strict=False) if taken != given]
    try:
        signature.bind(*parameters)
        fits_in = not any(taken in parameters for taken in moved)
    except TypeError:
        fits_in = False
    if not fits_in:
        takes = ", ".join(map(str, inspect.signature(getattr(method, "__func__", method)).parameters))
        raise ValueError(f"{name} of {_name(owner)} must take {wanted[len(name) :]}, but takes ({takes})")


def require_environment(name: str, environment: Any, allowed: str = "an MDP or a Gymnasium environment") -> None:
    """Refuse what has nothing of an MDP or a Gymnasium environment.

    Args:
        name: of the parameter that it was given for.
        environment: the value.
        allowed: what it may be, for the message.

    Raises:
        ValueError: it is something else, such as None.
    """
    if hasattr(environment, "num_envs"):
        raise ValueError(f"{name} must be {allowed}, but {type(environment).__name__} holds several: give one of them")
    if not any(hasattr(environment, part) for part in ("observation_space", "transition", "step")):
        wraps = "mdp" in getattr(environment, "_fields", ())
        hint = ": is the decorator @edugym.wrapper missing?" if wraps else ""
        raise ValueError(f"{name} must be {allowed}, but is {in_short(environment)}{hint}")


def require_spaces(task: Any) -> None:
    """Refuse an MDP or an environment without its two spaces.

    Raises:
        ValueError: there is none, or it is no space.
    """
    for name in SPACES:
        if not _has(task, name):
            raise ValueError(f"{_name(task)} must have a property {name}, a Gymnasium space such as spaces.Discrete(2)")
        space = getattr(task, name)
        if not isinstance(space, spaces.Space):
            hint = ": put @property above it" if inspect.ismethod(space) else ""
            raise ValueError(
                f"{name} of {_name(task)} must be a Gymnasium space, such as spaces.Discrete(2),"
                f" but is {in_short(space)}{hint}"
            )


def _has(mdp: Any, name: str) -> bool:
    """Whether there is such an attribute, even if getting it fails inside (which must show, not mean "no")."""
    missing = object()
    return inspect.getattr_static(mdp, name, missing) is not missing or hasattr(mdp, name)


def _name(mdp: Any) -> str:
    return type(mdp).__name__


def _sentence(
    mdp: Any, method: str, returned: Any, allowed: str, state: Any, action: Any = None, next_state: Any = None
) -> str:
    given = f"state {in_short(state)}"
    given += "" if action is None else f", action {in_short(action)}"
    given += "" if next_state is None else f", next state {in_short(next_state)}"
    forgotten = " (is a return missing?)" if returned is None else ""
    return f"{method} of {_name(mdp)} must return {allowed}, but returned {in_short(returned)} for {given}{forgotten}"


def refuse_change(mdp: Any, method: str, before: Any, now: Any) -> None:
    """Refuse a method that has changed the state that it was given."""
    if not same(before, now):
        raise ValueError(
            f"{method} of {_name(mdp)} must not change the state that it is given, but turned {in_short(before)} into"
            f" {in_short(now)}: make a new one, for example from a copy"
        )
