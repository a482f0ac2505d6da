"""What an MDP and a Gymnasium environment must have: methods, their parameters, and spaces.

Each mistake is answered with one sentence. Users' values pass here through one gate, `edugym.mdp.task.task_of`, and
agents through `edugym.checks.contract.contract_of`: nobody else calls these functions.
"""

import difflib
import inspect
from collections.abc import Iterable
from typing import Any

from gymnasium import ActionWrapper, Env, ObservationWrapper, RewardWrapper, Wrapper, spaces
from gymnasium.wrappers import OrderEnforcing, PassiveEnvChecker

from edugym.checks.parameters import in_short, number_of_steps

METHODS = {
    "initial": ("rng",),
    "transition": ("state", "action", "rng"),
    "reward": ("state", "action", "next_state", "rng"),
    "terminal": ("state",),
    "observation": ("state", "rng"),
}
"""What every MDP has, and what each method takes."""
SPACES = ("observation_space", "action_space")
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
# What a parameter may be, as messages say it:
MDP_ONLY = "an MDP"
"""Not even an environment that wraps one."""
MADE = "an MDP or a Gymnasium environment"
"""An object, not the name of one."""
SHAPED = "an MDP, a Gymnasium environment or a shape"
"""Only the sizes of its spaces matter, so two numbers will do."""
NAMED = "an MDP, a Gymnasium environment or a name"
"""A name or id is made into an environment."""
HARMLESS = (OrderEnforcing, PassiveEnvChecker)
"""The wrappers that `gymnasium.make` adds, which change nothing."""


def require_playable(name: str, environment: Any, allowed: str, *, is_mdp: bool, own: bool) -> int | None:
    """Refuse what nobody can play, and return its step limit, or None where there is none or it does not matter.

    Args:
        name: of the parameter that it was given for.
        environment: the value.
        allowed: what it may be: `MDP_ONLY`, `MADE`, `SHAPED` or `NAMED`.
        is_mdp: whether it must be an MDP, and no Gymnasium environment.
        own: whether it is the package's own, the methods of which its tests have looked at.

    Raises:
        ValueError: it is something else, or something in it is missing or not as it must be.
    """
    if allowed == NAMED and hasattr(environment, "act") and not hasattr(environment, "observation_space"):
        kind = environment if isinstance(environment, type) else type(environment)
        raise ValueError(f"{name} must come first, before the agent, but is the agent {kind.__name__}")
    has_a_reward_each = hasattr(environment, "rewards") and not hasattr(environment, "reward")
    if has_a_reward_each and hasattr(environment, "transition") and not isinstance(environment, type):
        raise ValueError(
            f"{name} must be {allowed}, but {class_name(environment)} is a game of two players: train both with"
            " edugym.games.train_players, or give edugym.games.against(game, player, policy) for one of them"
        )
    if allowed != MDP_ONLY:
        require_environment(name, environment, allowed)
    if allowed == SHAPED:  # only its sizes matter: `train` looks at the rest
        require_spaces(environment)
        return None
    mdp, spec = environment, None
    if is_mdp:
        require_mdp(mdp, name, methods=not own)
    else:
        require_env(environment)
        mdp, spec = getattr(environment.unwrapped, "mdp", None), environment.spec
    return spec.max_episode_steps if mdp is None and spec else step_limit(mdp)


def require_mdp(mdp: Any, name: str = "mdp", *, methods: bool = True) -> None:
    """Refuse what is no MDP: it needs five methods and two spaces, and so does the MDP inside a wrapper.

    Args:
        mdp: the value.
        name: of the parameter that it was given for.
        methods: whether to look at what each method takes; the package's tests have looked at its own.

    Raises:
        ValueError: something is missing, or is not as it must be.
    """
    if isinstance(mdp, type):
        raise ValueError(f"{name} must be a value, but is {a_class(mdp)}")
    if isinstance(mdp, str):
        raise ValueError(f"{name} must be an MDP, but is the name {mdp!r}: use edugym.make_mdp({mdp!r})")
    if isinstance(mdp, Env) or not any(_has(mdp, method) for method in METHODS):
        hint = " (an environment of EduGym has one: env.unwrapped.mdp)" if isinstance(mdp, Env) else ""
        raise ValueError(
            f"{name} must be an MDP, a value with the methods {', '.join(METHODS)} and the properties"
            f" {' and '.join(SPACES)}, but is {in_short(mdp)}{hint}"
        )
    if "mdp" in getattr(mdp, "_fields", ()):
        require_mdp(mdp.mdp, f"mdp of {class_name(mdp)}", methods=methods)
    for method, parameters in METHODS.items() if methods else ():
        require_method(mdp, method, parameters, METHODS)
    require_spaces(mdp)
    actions = mdp.action_space
    if isinstance(actions, spaces.Discrete) and actions.start != 0:
        raise ValueError(f"action_space of {class_name(mdp)} must number the actions from 0, but is {actions}")


def require_environment(name: str, environment: Any, allowed: str = MADE) -> None:
    """Refuse what has nothing of an MDP or a Gymnasium environment.

    Args:
        name: of the parameter that it was given for.
        environment: the value.
        allowed: what it may be, for the message.

    Raises:
        ValueError: it is something else, such as None.
    """
    if isinstance(environment, type):
        raise ValueError(f"{name} must be a value, but is {a_class(environment)}")
    if hasattr(environment, "num_envs"):
        raise ValueError(f"{name} must be {allowed}, but {class_name(environment)} holds several: give one of them")
    if not any(hasattr(environment, part) for part in ("observation_space", "transition", "step")):
        wraps = "mdp" in getattr(environment, "_fields", ())
        hint = ": is the decorator @edugym.wrapper missing?" if wraps else ""
        raise ValueError(f"{name} must be {allowed}, but is {in_short(environment)}{hint}")


def require_env(env: Env[Any, Any]) -> None:
    """Refuse an environment, or a wrapper in it, whose `reset` or `step` is missing or takes something else.

    Raises:
        ValueError: one of them is not as Gymnasium calls it, or a space is missing.
    """
    name = class_name(env)
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
    require_spaces(env)


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
        candidates = [
            other
            for other in dir(owner)
            if other not in others and not other.startswith("_") and callable(inspect.getattr_static(owner, other))
        ]
        near = [other for other in OTHER_NAMES.get(name, ()) if other in candidates]
        near = near or difflib.get_close_matches(name, candidates, 1)
        hint = f"; is {near[0]!r} misspelt?" if near else ""
        if "mdp" in getattr(owner, "_fields", ()) and not near:
            hint = ", or the decorator @edugym.wrapper, which takes it from the MDP inside"
        raise ValueError(f"{class_name(owner)} must have a method {wanted}{hint}")
    method = getattr(owner, name)
    if not callable(method):
        raise ValueError(f"{name} of {class_name(owner)} must be a method, but is {in_short(method)}")
    signature = inspect.signature(method)
    moved = [taken for taken, given in zip(signature.parameters, parameters, strict=False) if taken != given]
    try:
        signature.bind(*parameters)
        fits_in = not any(taken in parameters for taken in moved)
    except TypeError:
        fits_in = False
    if not fits_in:
        takes = ", ".join(map(str, inspect.signature(getattr(method, "__func__", method)).parameters))
        raise ValueError(f"{name} of {class_name(owner)} must take {wanted[len(name) :]}, but takes ({takes})")


def require_spaces(environment: Any) -> None:
    """Refuse an MDP or an environment without its two spaces.

    Raises:
        ValueError: there is none, or it is no space.
    """
    for name in SPACES:
        of = class_name(environment)
        if not _has(environment, name):
            raise ValueError(f"{of} must have a property {name}, a Gymnasium space such as spaces.Discrete(2)")
        space = getattr(environment, name)
        if not isinstance(space, spaces.Space):
            hint = ": put @property above it" if inspect.ismethod(space) else ""
            raise ValueError(
                f"{name} of {of} must be a Gymnasium space, such as spaces.Discrete(2), but is {in_short(space)}{hint}"
            )


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
    return None if limit is None else number_of_steps("max_steps", limit)


def a_class(kind: type) -> str:
    """A class that was given in place of a value, for a message: its name, and how a value is made."""
    made = f"{kind.__name__}.create(...)" if hasattr(kind, "create") else f"{kind.__name__}(...)"
    return f"the class {kind.__name__}: make one with {made}"


def class_name(value: Any) -> str:
    """The name of its class, for a message."""
    return type(value).__name__


def _has(owner: Any, name: str) -> bool:
    """Whether there is such an attribute, even if getting it fails inside (which must show, not mean "no")."""
    missing = object()
    return inspect.getattr_static(owner, name, missing) is not missing or hasattr(owner, name)


def _defines(mdp: Any, name: str) -> bool:
    """Whether the class of `mdp` defines `name`. If `mdp` is a wrapper, the MDP that it wraps counts too."""
    inner = getattr(mdp, "mdp", None)
    return hasattr(type(mdp), name) or (inner is not None and _defines(inner, name))
