"""Any MDP as a Gymnasium vector environment: n copies stepped in one call of machine code."""

import copy
from typing import Any, Generic

import numpy as np
from gymnasium import spaces
from gymnasium.envs.registration import EnvSpec
from gymnasium.error import ResetNeeded
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space

from edugym.adapters.actions import checked_action
from edugym.adapters.columns import copy_of, observation_rows, storage
from edugym.adapters.copies import ACTION_OUTSIDE, MODES, Batch, reset_copies, step_copies
from edugym.adapters.gymnasium_env import RENDERING, M, MDPEnv, environment_of
from edugym.adapters.runner import Runner
from edugym.adapters.specification import filled
from edugym.checks.interfaces import MDP_ONLY
from edugym.checks.mdps import random_steps
from edugym.checks.parameters import in_short, number_of_steps, one_of, whole_number
from edugym.checks.tracebacks import end_at_students_line
from edugym.mdp.protocol import HISTORY, history_wanted
from edugym.mdp.task import task_of

NO_LIMIT = 2**62
MOST_COPIES = 10_000_000
NOTHING = np.empty(0, np.int64)
TRIED = 100  # steps
ARRAYS = (spaces.Discrete, spaces.Box, spaces.MultiDiscrete, spaces.MultiBinary)
"""Spaces of which n elements are one array."""


class MDPVectorEnv(VectorEnv[Any, Any, Any], Generic[M]):
    """`num_envs` copies of an environment, stepped together: `MDPVectorEnv(MDPEnv(Walk(7)), 1024)`.

    All copies draw from one random stream, in their order: one seed repeats a run, and a single copy does exactly what
    `gymnasium.make` gives. What `reset` and `step` return are new arrays at every call. `infos` is empty, but for
    `"final_obs"` where copies are reset in the same step.

    Args:
        env: what all copies are: an environment, what `gymnasium.make` gives, or the MDP itself.
        num_envs: how many copies, from 1 to 10 million.
        autoreset_mode: what becomes of a copy whose episode is over. `"NextStep"`: the next `step` resets it and
            ignores its action. `"SameStep"`: it is reset at once, and its last observation is in
            `infos["final_obs"]`. `"Disabled"`: it waits for `reset(options={"reset_mask": mask})`.
        max_episode_steps: truncate episodes after so many steps, if the MDP's own limit is not lower; None or -1 for
            the MDP's own.

    Raises:
        ValueError: a parameter is not as above, or the steps of the environment do more than those of its MDP.
    """

    _spec: EnvSpec | None = None

    def __init__(
        self,
        env: MDPEnv[M],
        num_envs: int = 1,
        autoreset_mode: str | AutoresetMode = AutoresetMode.NEXT_STEP,
        max_episode_steps: int | None = None,
    ) -> None:
        """See the class."""
        self.closed = True  # Gymnasium closes what is thrown away: until this is made, there is nothing to close
        try:
            env = environment_of(env, "env")
        except Exception as error:
            end_at_students_line(error)
            raise
        if not env.only_plays_its_mdp:
            raise ValueError(
                f"env must do in a step what its MDP does and no more, but {env!r} does more: use Gymnasium's"
                " SyncVectorEnv"
            )
        self._row_space = env.mdp.observation_space
        for name, space in (("observation_space", self._row_space), ("action_space", env.action_space)):
            if not isinstance(space, ARRAYS):
                raise ValueError(
                    f"{name} must be Discrete, Box, MultiDiscrete or MultiBinary in a vector environment, but is"
                    f" {space}"
                )
        self._env = copy.copy(env)  # to draw with
        self.closed = False
        num_envs = whole_number("num_envs", num_envs, 1, MOST_COPIES)
        if not isinstance(autoreset_mode, AutoresetMode):
            one_of("autoreset_mode", autoreset_mode, [mode.value for mode in MODES])
        self.autoreset_mode = AutoresetMode(autoreset_mode)
        self.metadata = {**RENDERING, "autoreset_mode": self.autoreset_mode}
        self.num_envs = num_envs
        self.mdp, self.render_mode = env.mdp, env.render_mode
        self.single_observation_space, self.single_action_space = env.observation_space, env.action_space
        self.observation_space = batch_space(env.observation_space, num_envs)
        self.action_space = batch_space(env.action_space, num_envs)
        task = task_of(env.mdp, "env", MDP_ONLY)
        self._limit, self._is_own = task.max_steps, task.is_own
        if max_episode_steps is not None and not (type(max_episode_steps) is int and max_episode_steps == -1):
            most = number_of_steps("max_episode_steps", max_episode_steps)
            self._limit = most if self._limit is None else min(most, self._limit)
        self._n_actions = int(env.action_space.n) if isinstance(env.action_space, spaces.Discrete) else 0
        self._steps = np.zeros(num_envs, np.int64)
        self._over = np.zeros(num_envs, np.bool_)
        self._runner: Runner | None = None
        self._rows: Any = None
        drawn = getattr(env.mdp, "scene", None)
        asked = (*(history_wanted(drawn) if drawn else ()), *env.info_takes)
        self._asked = {name for name in HISTORY if name in asked}
        self._last_states: Any = None
        self._needed = 0
        self._actions: list[Any] = []  # the last ones, as far as `showing` needs them

    @property
    def spec(self) -> EnvSpec | None:
        """The id, the parameters, the step limit and the reward threshold."""
        return self._spec

    @spec.setter
    def spec(self, spec: EnvSpec | None) -> None:
        self._spec = filled(spec, self.mdp, self._limit)

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Any, dict[str, Any]]:
        """Start an episode in every copy, or in those that `options["reset_mask"]`, booleans of shape (n,), picks.

        Raises:
            ValueError: the options, or the mask in them, are something else.
        """
        if options is not None and not isinstance(options, dict):
            raise ValueError(f"options must be a dictionary or None, but is {in_short(options)}")
        mask = (options or {}).get("reset_mask", np.ones(self.num_envs, np.bool_))
        if not (isinstance(mask, np.ndarray) and mask.shape == self._over.shape and mask.dtype == np.bool_):
            raise ValueError(f"reset_mask must be an array of {self.num_envs} booleans, but is {in_short(mask)}")
        super().reset(seed=seed)
        if self._runner is None:
            try:
                self._runner = self._made_runner()
            except Exception as error:
                end_at_students_line(error)
                raise
            mask = np.ones(self.num_envs, np.bool_)
        batch = self._batch()
        self._runner.run(reset_copies, self.np_random, batch, self._few, mask)
        return self._env._of_rows(batch.observations.rows), {}

    def step(self, actions: Any) -> tuple[Any, Any, Any, Any, dict[str, Any]]:
        """Take one step in every copy.

        Args:
            actions: shape (n, ...): an element of `single_action_space` for each copy.

        Returns:
            Observations of shape (n, ...), rewards, terminations and truncations of shape (n,), and infos.

        Raises:
            ResetNeeded: before the first reset, or for a finished copy where none is reset by itself.
            ValueError: an action is not in the action space; nothing has been stepped then.
        """
        runner = self._runner
        if runner is None:
            raise ResetNeeded("step before the first reset: call reset() to start the episodes")
        if self.autoreset_mode is AutoresetMode.DISABLED and self._over.any():
            waiting = np.flatnonzero(self._over).tolist()
            raise ResetNeeded(f"step of finished copies {waiting}: call reset(options={{'reset_mask': ...}}) for them")
        array = self._checked(actions)
        batch = self._batch()
        last_states = copy_of(runner.states) if "last_state" in self._asked else None
        try:
            finished = runner.run(
                step_copies,
                self.np_random,
                batch,
                self._few,
                array,
                array if self._n_actions else NOTHING,
                self._n_actions,
                self._limit or NO_LIMIT,
                MODES.index(self.autoreset_mode),
            )
        except Exception as error:
            end_at_students_line(error)
            raise
        if finished == ACTION_OUTSIDE:
            raise ValueError(f"actions {in_short(actions)} are not in the action space {self.action_space}")
        if self._asked:
            self._remember(last_states, array)
        infos: dict[str, Any] = {}
        if finished and self.autoreset_mode is AutoresetMode.SAME_STEP:
            over = batch.terminations | batch.truncations
            infos = {"final_obs": np.full(self.num_envs, None, object), "_final_obs": over}
            for i in np.flatnonzero(over).tolist():
                infos["final_obs"][i] = self._env._of_rows(batch.final_observations.rows[i])
        observations = self._env._of_rows(batch.observations.rows)
        return observations, batch.rewards, batch.terminations, batch.truncations, infos

    @property
    def is_compiled(self) -> bool:
        """Whether the copies run as machine code, as far as is known: after the first reset and step."""
        return self._runner is not None and self._runner.is_compiled

    def state(self, i: int) -> Any:
        """The full state of the i-th copy.

        Raises:
            ResetNeeded: before the first reset.
            ValueError: there is no such copy.
        """
        if self._runner is None:
            raise ResetNeeded("there are no states before the first reset")
        return self._runner.state(whole_number("i", i, 0, self.num_envs - 1))

    def showing(self, i: int) -> MDPEnv[M]:
        """An environment that is as the i-th copy now is, until this is called again: to draw it, or for its `info`.

        Its last state and actions are there as far as the picture and the info of the MDP ask for them. Stepping or
        resetting it does not change the copy.

        Raises:
            ValueError: there is no such copy.
        """
        env, i = self._env, whole_number("i", i, 0, self.num_envs - 1)
        env.state = None if self._runner is None else self._runner.state(i)
        env.steps = int(self._steps[i])
        env.last_state, env.actions = None, []
        if env.steps > 0:
            if self._last_states is not None and self._runner is not None:
                env.last_state = self._runner.state(i, self._last_states)
            known = self._actions[-env.steps :]
            env.actions = [int(actions[i]) if self._n_actions else actions[i].copy() for actions in known]
        return env

    def render(self) -> tuple[Any, ...] | None:
        """Draw every copy, as `render_mode` says."""
        return tuple(self.showing(i).render() for i in range(self.num_envs))

    def close_extras(self, **kwargs: Any) -> None:
        """Close the window, if there is one."""
        self._env.close()

    def _remember(self, last_states: Any, actions: np.ndarray[Any, Any]) -> None:
        """Keep the states before a step and its actions, as far as the picture and the info of the MDP ask for them."""
        self._last_states = last_states
        if not {"actions", "last_action"} & self._asked:
            return
        small = np.int8 if 0 < self._n_actions <= 127 else actions.dtype
        self._actions.append(actions.astype(small))
        if "actions" not in self._asked:
            del self._actions[:-1]
        elif len(self._actions) > 2 * self._needed + 16:
            self._needed = int(self._steps.max())
            del self._actions[: len(self._actions) - self._needed]

    def _batch(self) -> Batch:
        """The copies, with new arrays for what the next call gives."""
        return self._batch_of(self._steps, self._over)

    def _few(self, n: int) -> Batch:
        """The same for the first `n` copies, in arrays of their own."""
        return self._batch_of(self._steps[:n].copy(), self._over[:n].copy())

    def _batch_of(self, steps: Any, over: Any) -> Batch:
        n, space = len(steps), self._row_space
        shape = space.shape or ()
        finals = n if self.autoreset_mode is AutoresetMode.SAME_STEP else 0
        return Batch(
            steps,
            over,
            self._rows(np.empty((n, *shape), space.dtype)),
            self._rows(np.empty((finals, *shape), space.dtype)),
            np.zeros(n),  # a reset gives none, and all must be finite
            np.empty(n, np.bool_),
            np.empty(n, np.bool_),
        )

    def _made_runner(self) -> Runner:
        """Choose the storage for states and observations by what some random steps show."""
        states = random_steps(self.mdp, TRIED)
        rng = np.random.default_rng(0)
        self._rows = observation_rows(self.mdp, copy.deepcopy(self.mdp).observation(states[-1], rng))
        places = storage(states, self.num_envs, checked=not self._is_own)
        return Runner(self.mdp, self.num_envs, places, states[0])

    def _checked(self, actions: Any) -> np.ndarray[Any, Any]:
        """The actions as an array of the type that the loops take."""
        if not self._n_actions and isinstance(self.single_action_space, spaces.Box):
            array: np.ndarray[Any, Any] = checked_action(self.action_space, actions)
            return array
        try:
            array = np.asarray(actions)
            fits = array.dtype.kind in "iu" and array.shape == self.action_space.shape
            if fits and self._n_actions:  # whether each is an action is looked at in `step_copies`
                return array.astype(np.int64, copy=False)
            if fits and self.action_space.contains(array.astype(self.action_space.dtype)):
                return array.astype(self.action_space.dtype)
        except (ValueError, TypeError, OverflowError):
            pass
        raise ValueError(f"actions {in_short(actions)} are not in the action space {self.action_space}")
