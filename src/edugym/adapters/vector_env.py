"""Any MDP as a Gymnasium vector environment: n copies stepped in one call of machine code."""

import copy
from typing import Any, Generic, NamedTuple

import numpy as np
from gymnasium import spaces
from gymnasium.error import ResetNeeded
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space

from edugym.adapters.columns import Storage, observation_rows, storage
from edugym.adapters.gymnasium_env import RENDERING, M, MDPEnv
from edugym.checks import whole_number
from edugym.compiled.execution import executable
from edugym.mdp.protocol import MDP, Random, step_limit

NO_LIMIT = 2**62
ACTION_OUTSIDE = -1
NOTHING = np.empty(0, np.int64)
TRIED = 100  # steps
MODES = [AutoresetMode.NEXT_STEP, AutoresetMode.SAME_STEP, AutoresetMode.DISABLED]
NEXT_STEP, SAME_STEP, DISABLED = range(3)


class MDPVectorEnv(VectorEnv[Any, Any, Any], Generic[M]):
    """`num_envs` copies of an environment, stepped together: `MDPVectorEnv(MDPEnv(Walk(7)), 1024)`.

    All copies draw from one random stream, in their order: one seed repeats a run, and a single copy does exactly what
    `gymnasium.make` gives. What `reset` and `step` return are new arrays at every call. `infos` is empty, but for
    `"final_obs"` where copies are reset in the same step.

    Args:
        env: one environment, which says what all are.
        num_envs: how many copies, 1 or more.
        autoreset_mode: what becomes of a copy whose episode is over. `"NextStep"`: the next `step` resets it and
            ignores its action. `"SameStep"`: it is reset at once, and its last observation is in
            `infos["final_obs"]`. `"Disabled"`: it waits for `reset(options={"reset_mask": mask})`.

    Raises:
        ValueError: a parameter is not as above.
    """

    def __init__(
        self, env: MDPEnv[M], num_envs: int = 1, autoreset_mode: str | AutoresetMode = AutoresetMode.NEXT_STEP
    ) -> None:
        """See the class."""
        self._env = copy.copy(env)  # to draw with
        whole_number("num_envs", num_envs, 1)
        self.autoreset_mode = AutoresetMode(autoreset_mode)
        self.metadata = {**RENDERING, "autoreset_mode": self.autoreset_mode}
        self.num_envs = num_envs
        self.mdp, self.render_mode = env.mdp, env.render_mode
        self.single_observation_space, self.single_action_space = env.observation_space, env.action_space
        self.observation_space = batch_space(env.observation_space, num_envs)
        self.action_space = batch_space(env.action_space, num_envs)
        self._max_steps = step_limit(env.mdp) or NO_LIMIT
        self._n_actions = int(env.action_space.n) if isinstance(env.action_space, spaces.Discrete) else 0
        self._steps = np.zeros(num_envs, np.int64)
        self._over = np.zeros(num_envs, np.bool_)
        self._states: Storage | None = None
        self._rows: Any = None
        self._code: dict[Any, Any] = {}

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[np.ndarray[Any, Any], dict[str, Any]]:
        """Start an episode in every copy, or in those that `options["reset_mask"]`, booleans of shape (n,), picks.

        Raises:
            ValueError: the mask is something else.
        """
        mask = (options or {}).get("reset_mask", np.ones(self.num_envs, np.bool_))
        if not (isinstance(mask, np.ndarray) and mask.shape == self._over.shape and mask.dtype == np.bool_):
            raise ValueError(f"reset_mask must be an array of {self.num_envs} booleans, but is {mask!r}")
        super().reset(seed=seed)
        if self._states is None:
            self._make_room()
            mask = np.ones(self.num_envs, np.bool_)
        batch = self._batch()
        self._run(reset_copies, self.np_random, mask, self._states, batch)
        return batch.observations.rows, {}

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
        if self._states is None:
            raise ResetNeeded("step before the first reset: call reset() to start the episodes")
        if self.autoreset_mode is AutoresetMode.DISABLED and self._over.any():
            waiting = np.flatnonzero(self._over).tolist()
            raise ResetNeeded(f"step of finished copies {waiting}: call reset(options={{'reset_mask': ...}}) for them")
        array = self._checked(actions)
        batch = self._batch()
        finished = self._run(
            step_copies,
            self.np_random,
            array,
            array if self._n_actions else NOTHING,
            self._n_actions,
            self._max_steps,
            MODES.index(self.autoreset_mode),
            self._states,
            batch,
        )
        if finished == ACTION_OUTSIDE:
            raise ValueError(f"actions {actions!r} are not in the action space {self.action_space}")
        infos: dict[str, Any] = {}
        if finished and self.autoreset_mode is AutoresetMode.SAME_STEP:
            over = batch.terminations | batch.truncations
            infos = {"final_obs": np.full(self.num_envs, None, object), "_final_obs": over}
            for i in np.flatnonzero(over).tolist():
                infos["final_obs"][i] = batch.final_observations.rows[i]
        return batch.observations.rows, batch.rewards, batch.terminations, batch.truncations, infos

    def state(self, i: int) -> Any:
        """The full state of the i-th copy.

        Raises:
            ResetNeeded: before the first reset.
        """
        if self._states is None:
            raise ResetNeeded("there are no states before the first reset")
        return self._states.load(i)

    def showing(self, i: int) -> MDPEnv[M]:
        """An environment that is as the i-th copy now is, until this is called again: to draw it, or for its `info`.

        Stepping or resetting it does not change the copy.
        """
        env = self._env
        env.state = None if self._states is None else self._states.load(i)
        env.steps = int(self._steps[i])
        env.last_state, env.actions = None, []
        return env

    def render(self) -> tuple[Any, ...] | None:
        """Draw every copy, as `render_mode` says."""
        return tuple(self.showing(i).render() for i in range(self.num_envs))

    def close_extras(self, **kwargs: Any) -> None:
        """Close the window, if there is one."""
        self._env.close()

    def _batch(self) -> "Batch":
        """The copies, with new arrays for what the next call gives."""
        n, space = self.num_envs, self.single_observation_space
        shape = space.shape or ()
        finals = n if self.autoreset_mode is AutoresetMode.SAME_STEP else 0
        return Batch(
            self._steps,
            self._over,
            self._rows(np.empty((n, *shape), space.dtype)),
            self._rows(np.empty((finals, *shape), space.dtype)),
            np.empty(n),
            np.empty(n, np.bool_),
            np.empty(n, np.bool_),
        )

    def _make_room(self) -> None:
        """Find out, from some random steps, of what shape and types states and observations are."""
        rng, actions = np.random.default_rng(0), copy.deepcopy(self.single_action_space)
        actions.seed(0)
        state = self.mdp.initial(rng)
        states = [state]
        for _ in range(TRIED):
            over = self.mdp.terminal(state)
            action = int(actions.sample()) if self._n_actions else actions.sample()
            state = self.mdp.initial(rng) if over else self.mdp.transition(state, action, rng)
            states.append(state)
        self._states = storage(states, self.num_envs)
        self._rows = observation_rows(self.mdp, self.mdp.observation(state, rng))

    def _checked(self, actions: Any) -> np.ndarray[Any, Any]:
        array = np.asarray(actions)
        if self._n_actions:  # whether each is an action is looked at in `step_copies`
            fits = array.shape == self.action_space.shape and array.dtype.kind in "iu"
        else:
            fits = array.dtype == self.action_space.dtype and self.action_space.contains(array)
        if not fits:
            raise ValueError(f"actions {actions!r} are not in the action space {self.action_space}")
        return array.astype(np.int64, copy=False) if self._n_actions else array

    def _run(self, loop: Any, *arguments: Any) -> Any:
        """Run one of the loops below over all copies, compiled when it is first needed."""
        if loop not in self._code:
            self._code[loop] = executable(loop, (self.mdp, *arguments), rehearsed=self.num_envs, replayed=False)
        return self._code[loop](self.num_envs, self.mdp, *arguments)

    def __getstate__(self) -> dict[str, Any]:
        """What is pickled and copied: everything but the machine code."""
        return {**self.__dict__, "_code": {}}


class Batch(NamedTuple):
    """The copies less their states, and what a step gives: arrays with one place, or row, for each copy.

    (With the states in it, which may be in a list, Numba would take fifty microseconds a call to see what all this is.)
    """

    steps: Any
    over: Any
    observations: Any
    final_observations: Any
    rewards: Any
    terminations: Any
    truncations: Any


def reset_copies(n: int, mdp: MDP[Any, Any], rng: Random, mask: Any, states: Any, batch: Batch) -> None:
    """Start an episode in the first `n` copies, where `mask` says so, and observe them all."""
    for i in range(n):
        if mask[i]:
            states.store(i, mdp.initial(rng))
            batch.steps[i] = 0
            batch.over[i] = False
        batch.observations.put(i, mdp, states.load(i), rng)


def step_copies(
    n: int,
    mdp: MDP[Any, Any],
    rng: Random,
    actions: Any,
    whole: Any,
    n_actions: int,
    max_steps: int,
    autoreset: int,
    states: Any,
    batch: Batch,
) -> int:
    """Step the first `n` copies, and give the number of episodes that ended, or what is wrong (a negative number)."""
    for i in range(len(whole)):
        if whole[i] < 0 or whole[i] >= n_actions:
            return ACTION_OUTSIDE
    finished = 0
    for i in range(n):
        if batch.over[i] and autoreset == NEXT_STEP:
            state = mdp.initial(rng)
            states.store(i, state)
            batch.observations.put(i, mdp, state, rng)
            batch.steps[i] = 0
            batch.over[i] = False
            batch.rewards[i] = 0.0
            batch.terminations[i] = False
            batch.truncations[i] = False
            continue
        state = states.load(i)
        next_state = mdp.transition(state, actions[i], rng)
        batch.rewards[i] = mdp.reward(state, actions[i], next_state, rng)
        terminated = mdp.terminal(next_state)
        batch.steps[i] += 1
        truncated = batch.steps[i] == max_steps and not terminated
        batch.terminations[i] = terminated
        batch.truncations[i] = truncated
        batch.over[i] = terminated or truncated
        if batch.over[i]:
            finished += 1
            if autoreset == SAME_STEP:
                batch.final_observations.put(i, mdp, next_state, rng)
                next_state = mdp.initial(rng)
                batch.steps[i] = 0
                batch.over[i] = False
        batch.observations.put(i, mdp, next_state, rng)
        states.store(i, next_state)
    return finished
