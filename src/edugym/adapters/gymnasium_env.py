"""Any MDP as a Gymnasium environment."""

import copy
import inspect
from collections.abc import Callable
from functools import cache, partial
from typing import TYPE_CHECKING, Any, Generic, SupportsFloat, TypeVar

import gymnasium
import numpy as np
from gymnasium import spaces
from gymnasium.envs.registration import EnvSpec
from gymnasium.error import ResetNeeded

from edugym.adapters import keys
from edugym.adapters.actions import checked_action
from edugym.adapters.specification import filled
from edugym.checks.interfaces import MDP_ONLY
from edugym.checks.mdps import CHECKED_STEPS, CheckedMDP, checked_step, refuse_nothing, refuse_start
from edugym.checks.parameters import in_short, one_of
from edugym.checks.tracebacks import end_at_students_line
from edugym.checks.values import ANSWERS
from edugym.mdp.protocol import MDP, history_wanted, named_actions
from edugym.mdp.task import bare, task_of

if TYPE_CHECKING:
    from edugym.exact.tables import FiniteModel, Outcome
    from edugym.rendering.scene import Scene

M = TypeVar("M", bound=MDP[Any, Any])

RENDERING: dict[str, Any] = {"render_modes": ["human", "rgb_array", "ansi"], "render_fps": 4}


class MDPEnv(gymnasium.Env[Any, Any], Generic[M]):
    """A Gymnasium environment that plays an MDP: `MDPEnv(Walk(7))`.

    It adds the API: it keeps the state, the random stream and the step limit, and asks the MDP for everything else, the
    picture, the info and the names of the actions included. In the first steps of a student's MDP it checks what the
    methods return (see `edugym.checks.mdps`).

    Args:
        mdp: the task, with `observation_space` and `action_space` (see `edugym.mdp.protocol.MDP`).
        render_mode: `"human"` (a window), `"rgb_array"` (pixels), `"ansi"` (characters) or None.

    Attributes:
        mdp: the task.
        state: the full state of the task, also what the agent does not see; None before the first `reset`.
        steps: how many steps this episode has taken.
        last_state: the state before this one; None at the start of an episode.
        actions: the actions of this episode, in order.
        info_takes: which of `edugym.mdp.protocol.HISTORY` the MDP's `info` asks for.

    Raises:
        ValueError: there is no such render mode, or `mdp` is no MDP (see `edugym.checks.interfaces`).
    """

    metadata = RENDERING
    _spec: EnvSpec | None = None

    def __init__(self, mdp: M, render_mode: str | None = None) -> None:
        """See the class."""
        try:
            task = task_of(mdp, "mdp", MDP_ONLY)
        except Exception as error:
            end_at_students_line(error)
            raise
        mdp = task.played
        one_of("render_mode", render_mode, [None, *self.metadata["render_modes"]])
        self.mdp = mdp
        self.observation_space = mdp.observation_space
        self.action_space = mdp.action_space
        self.render_mode = render_mode
        self.state: Any = None
        self.steps = 0
        self.last_state: Any = None
        self.actions: list[Any] = []
        self._limit = task.max_steps
        self._over = True
        self._shown = as_element_of(mdp.observation_space)
        self._n_actions = int(mdp.action_space.n) if isinstance(mdp.action_space, spaces.Discrete) else 0
        self._window: Any = None
        self._known_model: FiniteModel | None = None
        self._model_rng = np.random.default_rng(0)
        self._info = getattr(mdp, "info", None)
        self.info_takes = history_wanted(mdp.info) if hasattr(mdp, "info") else ()
        self._steps_to_check = 0 if task.is_own else CHECKED_STEPS

    @property
    def spec(self) -> EnvSpec | None:
        """The id, the parameters, the step limit and the reward threshold."""
        return self._spec

    @spec.setter
    def spec(self, spec: EnvSpec | None) -> None:
        self._spec = filled(spec, self.mdp, self._limit)

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Any, dict[str, Any]]:
        """Start an episode.

        Args:
            seed: with a seed, everything after it can be repeated; without one the random stream goes on.
            options: not used.

        Returns:
            The observation and `info`.

        Raises:
            ValueError: the episode would start in a terminal state.
        """
        super().reset(seed=seed)
        if seed is not None:
            self._model_rng = np.random.default_rng([seed, 1])  # planning must not shift what the environment draws
        rng = self.np_random
        mdp = CheckedMDP(self.mdp) if self._steps_to_check else self.mdp
        try:
            self.state = mdp.initial(rng)
            observed = mdp.observation(self.state, rng)
            if mdp.terminal(self.state):
                refuse_start(mdp, self.state)
        except Exception as error:
            end_at_students_line(error)
            raise
        self.steps = 0
        self.last_state, self.actions = None, []
        self._over = False
        observation = self._shown(observed)
        if self.render_mode == "human":
            self.render()
        return observation, self.info()

    def step(self, action: Any) -> tuple[Any, SupportsFloat, bool, bool, dict[str, Any]]:
        """Take one step.

        Args:
            action: an element of `action_space`, or a list or array that stands for one. Numbers beyond the bounds of a
                Box are clipped to them.

        Returns:
            The observation, the reward, whether the task has ended (`terminated`), whether the step limit has cut the
            episode off (`truncated`; never both), and `info`.

        Raises:
            ResetNeeded: there is no episode under way.
            ValueError: the action is not in the action space.
        """
        if self._over:
            why = "before the first reset" if self.state is None else "of a finished episode"
            raise ResetNeeded(f"step {why}: call reset() to start an episode")
        action = self._checked(action)
        mdp, state = self.mdp, self.state
        rng: Any = self._np_random  # there is one since `reset`; the property `np_random` would cost a tenth of a step
        if self._steps_to_check:
            self._steps_to_check -= 1
            try:
                next_state, reward, terminated, observed = checked_step(mdp, state, action, rng)
            except Exception as error:
                end_at_students_line(error)
                raise
        else:
            next_state = mdp.transition(state, action, rng)
            paid = mdp.reward(state, action, next_state, rng)
            if next_state is None or paid is None:
                refuse_nothing(mdp, state, action, next_state)
            reward = float(paid)
            ended = mdp.terminal(next_state)
            if not isinstance(ended, ANSWERS):
                refuse_nothing(mdp, state, action, next_state, paid, ended)
            terminated = bool(ended)
            observed = mdp.observation(next_state, rng)
        observation = self._shown(observed)
        self.steps += 1
        truncated = self.steps == self._limit and not terminated
        self.state, self.last_state = next_state, state
        self.actions.append(action)
        self._over = terminated or truncated
        if self.render_mode == "human":
            self.render()
        return observation, reward, terminated, truncated, self.info()

    @property
    def last_action(self) -> Any:
        """The action that led here; None at the start of an episode."""
        return self.actions[-1] if self.actions else None

    @property
    def only_plays_its_mdp(self) -> bool:
        """Whether its MDP alone gives the same episodes, so that training may run that, as machine code.

        A subclass that extends `reset` or `step` says so itself where it changes nothing by that.
        """
        return type(self).reset is MDPEnv.reset and type(self).step is MDPEnv.step

    def _of_rows(self, rows: Any) -> Any:
        """Observations of the MDP, a row for each of several copies, as elements of the batched observation space.

        They are these already, unless a subclass shows something else, as a goal environment does (see `Switches`).
        """
        return rows

    def info(self) -> dict[str, Any]:
        """What a teacher may want to plot and an agent may not use: a new dictionary at every call."""
        if self._info is None:
            return {}
        if self.info_takes:
            return dict(self._info(self.state, **self._history(self.info_takes)))
        told: dict[str, Any] = self._info(self.state)  # an empty dictionary of arguments would cost a tenth of a step
        return told

    def named_actions(self) -> dict[str, Any]:
        """The actions that a person who plays may choose from, by name: labels for buttons and keys.

        Empty where each action goes by its number.
        """
        return named_actions(self.mdp)

    def get_keys_to_action(self) -> dict[str, Any]:
        """The action for each key of the keyboard, for `gymnasium.utils.play.play`: keys 0, 1, ..., then letters.

        Raises:
            ValueError: there are more actions than keys, or actions that are not named are real numbers.
        """
        actions = keys.named_actions(self)
        return {key: actions[name] for key, name in keys.keys_of(list(actions)).items()}

    def scene(self) -> "Scene":
        """The picture of the present state, or of an initial one before the first `reset`.

        In a notebook it shows itself. An MDP without a picture of its own is shown as text.
        """
        from edugym.rendering.scene import Scene, in_words

        state = self.mdp.initial(np.random.default_rng(0)) if self.state is None else self.state
        draw = getattr(self.mdp, "scene", None)
        if draw is None:
            return in_words(state)
        scene = draw(state, **self._history(history_wanted(draw)))
        if not isinstance(scene, Scene):
            raise ValueError(f"scene of {type(self.mdp).__name__} must return a Scene, but returned {in_short(scene)}")
        return scene

    def _history(self, wanted: tuple[str, ...]) -> dict[str, Any]:
        """Those of `HISTORY` that are wanted."""
        return {name: getattr(self, name) for name in wanted}

    def render(self) -> Any:
        """Draw the present state as `render_mode` says: an array of pixels (height, width, 3), a string, or a window.

        Raises:
            ResetNeeded: there is no state to draw yet.
        """
        if self.state is None:
            raise ResetNeeded("render before the first reset: call reset() to start an episode")
        if self.render_mode == "rgb_array":
            from edugym.rendering.pixels import to_pixels

            return to_pixels(self.scene())
        if self.render_mode == "ansi":
            from edugym.rendering.ansi import to_text

            return to_text(self.scene())
        if self.render_mode == "human":
            from edugym.rendering.window import Window

            if self._window is None:
                self._window = Window(self.spec.id if self.spec else type(self.mdp).__name__)
            self._window.show(self.scene(), self.metadata["render_fps"])
            return None
        gymnasium.logger.warn(
            "render() without a render_mode shows nothing: pass render_mode when you make the environment"
        )
        return None

    def close(self) -> None:
        """Close the window, if there is one."""
        if self._window is not None:
            self._window.close()
            self._window = None

    @property
    def finite_model(self) -> "FiniteModel":
        """The exact model of the task as tables, made when first asked for.

        An MDP may hand out a worse one: it has a method `distorted(model)` then, as Supermarket with `noise` has.

        Raises:
            ValueError: the task is not finite, or the agent does not see its state.
        """
        from edugym.exact.model import finite_model

        if self._known_model is None:
            model = finite_model(self.mdp)
            distorted = getattr(self.mdp, "distorted", None)
            self._known_model = model if distorted is None else distorted(model)
        return self._known_model

    def descriptive_model(self, state: Any, action: Any) -> "list[Outcome]":
        """All outcomes of an action: a list of (probability, next_state, mean reward, terminated).

        Raises:
            ValueError: the task is not finite, or it has no such state or action.
        """
        return self.finite_model.outcomes(state, self._checked(action))

    def generative_model(self, state: Any, action: Any) -> "Outcome":
        """One outcome, (1.0, next_state, reward, terminated), drawn from the model's own random stream.

        Raises:
            ValueError: the task is not finite, or it has no such state or action.
        """
        outcomes = self.descriptive_model(state, action)
        chosen = self._model_rng.choice(len(outcomes), p=[outcome.probability for outcome in outcomes])
        return outcomes[int(chosen)]._replace(probability=1.0)

    def model(self, state: Any, action: Any, kind: str = "descriptive") -> "list[Outcome] | Outcome":
        """The paper's short form of `descriptive_model` and `generative_model`.

        Raises:
            ValueError: the kind is neither, or as in those.
        """
        one_of("kind", kind, ["descriptive", "generative"])
        return self.descriptive_model(state, action) if kind == "descriptive" else self.generative_model(state, action)

    def _checked(self, action: Any) -> Any:
        """The action as the MDP takes it."""
        if type(action) is int and 0 <= action < self._n_actions:
            return action
        try:
            return checked_action(self.action_space, action)
        except ValueError as error:
            if self._n_actions and isinstance(self.observation_space, spaces.MultiDiscrete | spaces.Tuple):
                raise ValueError(
                    f"{error}; if a table gave it: an observation of this environment is several numbers, and"
                    " env = edugym.TabularObservation(env) makes of them the one number of a row"
                ) from None
            raise

    def __getstate__(self) -> dict[str, Any]:
        """Everything but the window, to be pickled or copied."""
        return {**self.__dict__, "_window": None}


@cache
def gymnasium_class(kind: Any, module: str) -> Any:
    """The Gymnasium class of an MDP class that has `create`: `BoulderEnv(height=30)` plays `Boulder.create(height=30)`.

    Args:
        kind: the class of the MDP.
        module: where pickle can find the Gymnasium class, as `<name of kind>Env`.
    """
    parameters = inspect.signature(kind.create).parameters.values()
    drawing = inspect.Parameter("render_mode", inspect.Parameter.KEYWORD_ONLY, default=None)
    signature = inspect.Signature([*parameters, drawing])

    def __init__(self: MDPEnv[Any], *given: Any, render_mode: str | None = None, **parameters: Any) -> None:
        MDPEnv.__init__(self, kind.create(*given, **parameters), render_mode)

    members = {
        "__init__": __init__,
        "__signature__": signature,
        "__module__": module,
        "__doc__": kind.__doc__,
    }
    return type(f"{kind.__name__}Env", (MDPEnv,), members)


def environment_of(environment: Any, name: str = "environment") -> "MDPEnv[Any]":
    """The environment that plays an MDP, given that, the MDP, or what `gymnasium.make` puts around the environment.

    Args:
        environment: one of these.
        name: of the parameter that it was given for.

    Raises:
        ValueError: it is something else, or a wrapper changes what it does.
    """
    inside = bare(environment)
    if isinstance(inside, MDPEnv):
        return inside
    if isinstance(inside, gymnasium.Wrapper) and isinstance(inside.unwrapped, MDPEnv):
        raise ValueError(
            f"{name} must have no wrapper that changes it, but has {type(inside).__name__}: pass its `unwrapped`, and"
            " wrap the copies instead"
        )
    task: Any = task_of(inside, name, MDP_ONLY)
    return MDPEnv(task)


def as_element_of(space: spaces.Space[Any]) -> Callable[[Any], Any]:
    """A function that turns an observation of an MDP into an element of a Gymnasium space, a new array each time."""
    if isinstance(space, spaces.Tuple):
        parts = [as_element_of(part) for part in space.spaces]
        return lambda seen: tuple(part(one) for part, one in zip(parts, seen, strict=True))
    if isinstance(space, spaces.Dict):
        named = {name: as_element_of(part) for name, part in space.spaces.items()}
        return lambda seen: {name: part(seen[name]) for name, part in named.items()}
    if isinstance(space, spaces.Discrete):
        return int
    arrays = isinstance(space, spaces.Box | spaces.MultiDiscrete | spaces.MultiBinary)
    return partial(np.array, dtype=space.dtype) if arrays else copy.deepcopy
