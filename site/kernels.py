"""The kernels of the playground: what trains, evaluates and plays, as WebAssembly that was compiled ahead of time.

A kernel is one function. `race` (one for agents that are on-policy, one for the others) begins, trains and evaluates,
with the very loops that `edugym.train` runs, so the page has the same numbers as `edugym.train`; `play` takes one step
of an environment for a person. Each is compiled for the types of an MDP and an agent. Sizes and settings are data.

A kernel is known by the fingerprint of all that determines it: the code that it reaches, the types of its arguments,
the versions of the compilers, and the files that make a kernel. Its file carries the fingerprint in its name and in
itself. Change any code, and the page asks for another file: a stale kernel is never loaded.
"""

import hashlib
import json
from collections.abc import Callable, Iterable
from concurrent.futures import ProcessPoolExecutor
from functools import cache
from multiprocessing import get_context
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import wasm
from linker import notes_of
from sights import arrays_in, noted, write_values

from edugym.adapters.fitting import fitted
from edugym.checks.contract import contract_of
from edugym.compiled.code import code_of
from edugym.experiments.fingerprints import versions
from edugym.mdp.protocol import Random
from edugym.mdp.task import task_of
from edugym.system.files import write_whole
from edugym.training.loops import off_policy, on_policy, play_episodes, start_off_policy, start_on_policy
from edugym.training.trainers import MDPTrainer

COMPILER = ("linker.py", "pcg64.ll", "wasm.py")
"""The files that make a kernel of a loop."""
BEGIN = -1
"""The number of steps, or the action, that asks for a new beginning."""
SHOW = -2
"""The number of steps that asks for what an agent knows."""


class Training(NamedTuple):
    """What the loops of `edugym.training.loops` train with, by their names."""

    mdp: Any
    learner: Any
    limit: int
    environment_rng: Random
    agent_rng: Random
    log: Any


class Evaluation(NamedTuple):
    """What `edugym.training.loops.play_episodes` is called with; the returns are written into `returns`."""

    mdp: Any
    actor: Any
    limit: int
    environment_rng: Random
    actor_rng: Random
    returns: Any


def race_off_policy(n_steps: int, n_episodes: int, training: Training, evaluation: Evaluation, carry: Any) -> Any:
    """Evaluate in `n_episodes` episodes; then take `n_steps` training steps, or begin if that is `BEGIN`."""
    if n_steps == BEGIN:
        return start_off_policy(training.mdp, training.environment_rng)
    evaluate(n_episodes, evaluation)
    mdp, learner, limit, environment_rng, agent_rng, log = training
    return off_policy(n_steps, mdp, learner, limit, environment_rng, agent_rng, log, carry)


def race_on_policy(n_steps: int, n_episodes: int, training: Training, evaluation: Evaluation, carry: Any) -> Any:
    """The same for agents that learn from the action that they will take next."""
    if n_steps == BEGIN:
        return start_on_policy(training.mdp, training.learner, training.environment_rng, training.agent_rng)
    evaluate(n_episodes, evaluation)
    mdp, learner, limit, environment_rng, agent_rng, log = training
    return on_policy(n_steps, mdp, learner, limit, environment_rng, agent_rng, log, carry)


def race_noted(
    n_steps: int, n_episodes: int, training: Training, evaluation: Evaluation, values: Any, carry: Any
) -> Any:
    """Like `race_off_policy` in a task with notes; if the number of steps is `SHOW`, write the values of all places."""
    return race_off_policy(after_showing(n_steps, training, values), n_episodes, training, evaluation, carry)


def race_noted_on_policy(
    n_steps: int, n_episodes: int, training: Training, evaluation: Evaluation, values: Any, carry: Any
) -> Any:
    """The same for agents that learn from the action that they will take next."""
    return race_on_policy(after_showing(n_steps, training, values), n_episodes, training, evaluation, carry)


def after_showing(n_steps: int, training: Training, values: Any) -> int:
    """The steps to take: none where the values of all places are asked for, and then written."""
    if n_steps == SHOW:
        write_values(training.mdp, values)
        return 0
    return n_steps


NOTED = race_noted, race_noted_on_policy
"""The loops of agents that have no row for a place."""


def evaluate(n_episodes: int, evaluation: Evaluation) -> None:
    """Play so many episodes, if any."""
    if n_episodes > 0:
        mdp, actor, limit, environment_rng, actor_rng, returns = evaluation
        play_episodes(n_episodes, mdp, actor, limit, environment_rng, actor_rng, returns)


def play(action: int, mdp: Any, limit: int, environment_rng: Random, carry: Any) -> Any:
    """Take one step of an environment, or begin an episode if the action is `BEGIN`.

    Returns:
        The state, its observation, the steps and the return so far, the reward, and whether the episode is terminated
        or truncated.
    """
    if action == BEGIN:
        state, observation, steps, total = start_off_policy(mdp, environment_rng)
        return state, observation, steps, total, 0.0, False, False
    state, _, steps, total, _, _, _ = carry
    next_state = mdp.transition(state, action, environment_rng)
    reward = mdp.reward(state, action, next_state, environment_rng)
    terminated = mdp.terminal(next_state)
    observation = mdp.observation(next_state, environment_rng)
    steps += 1
    return next_state, observation, steps, total + reward, reward, terminated, steps == limit and not terminated


class Call(NamedTuple):
    """A call of a kernel.

    Attributes:
        loop: what is compiled.
        arguments: what it is called with at first.
    """

    loop: Callable[..., Any]
    arguments: tuple[Any, ...]

    @property
    def fingerprint(self) -> str:
        """A hash of all that determines the kernel."""
        text = (code_of(self.loop, self.arguments).fingerprint, str(wasm.signature_of(self.arguments)), _tools())
        return hashlib.sha256(repr(text).encode()).hexdigest()[:16]


class _Opened(MDPTrainer):
    """The trainer that `edugym.train` uses, with what it calls its loops with."""

    def race(self, n_episodes: int, measured: Any) -> Call:
        """The call that races, with room for the returns of so many evaluation episodes in the task `measured`."""
        loop = race_on_policy if self._contract.is_on_policy else race_off_policy
        training = Training(*self._plain_arguments)
        return Call(loop, (BEGIN, 0, training, self._measuring(n_episodes, measured), self._carry))

    def race_noted(self, places: Any, clean: Any, n_episodes: int, measured: Any) -> Call:
        """The same with notes, see sights.py; evaluation leaves none."""
        training = Training(*self._plain_arguments)
        notes = noted(training.mdp, places, clean, self._contract)
        values = np.zeros((notes.visits.size, int(training.mdp.action_space.n)))
        evaluation, loop = self._measuring(n_episodes, measured), NOTED[self._contract.is_on_policy]
        return Call(loop, (BEGIN, 0, training._replace(mdp=notes), evaluation, values, self._carry))

    def _measuring(self, n_episodes: int, measured: Any) -> Evaluation:
        usual = Evaluation(*self._evaluation(n_episodes))
        return usual if measured is None else usual._replace(mdp=measured)

    def play(self) -> Call:
        """The call that lets a person play."""
        mdp, _, limit, rng, *_ = self._plain_arguments
        return Call(play, (BEGIN, mdp, limit, rng, (*start_off_policy(mdp, rng), 0.0, False, False)))


def _opened(mdp: Any, agent: Any) -> _Opened:
    contract = contract_of(agent)
    task = fitted(task_of(mdp), contract)
    return _Opened(task, contract, 0, task.max_steps, 0)


def race_of(mdp: Any, agent: Any, n_episodes: int, measured: Any = None) -> Call:
    """The call that lets an agent race in an MDP, and evaluates it in so many episodes at a time.

    They are episodes of another task if one is given as `measured`.
    """
    return _opened(mdp, agent).race(n_episodes, measured)


def noted_race_of(mdp: Any, places: Any, clean: Any, agent: Any, n_episodes: int, measured: Any = None) -> Call:
    """The same for an agent that has no row for a place. The task is also given as a place, and without noise."""
    before = [(array, array.copy()) for array in arrays_in(mdp)]
    call = _opened(mdp, agent).race_noted(places, clean, n_episodes, measured)
    for array, fresh in before:  # a hashed table has observed since then
        array[...] = fresh
    return call


def play_of(mdp: Any, agent: Any) -> Call:
    """The call that lets a person play an MDP, seen as this agent sees it."""
    return _opened(mdp, agent).play()


@cache
def _tools() -> str:
    """What makes kernels: the versions of libraries, and the contents of files."""
    contents = (Path(__file__).with_name(file).read_bytes() for file in COMPILER)
    return versions("llvmlite") + hashlib.sha256(b"".join(contents)).hexdigest()


class Manifest(NamedTuple):
    """What a kernel says of itself.

    Attributes:
        fingerprint: by which it is known.
        slots: of its arguments, then of its results: name and kind of each.
        results: the number of slots of its arguments.
    """

    fingerprint: str
    slots: list[tuple[str, str]]
    results: int


def manifest_of(module: bytes) -> Manifest:
    """What a kernel says of itself."""
    return Manifest(**json.loads(notes_of(module)[wasm.NOTE]))


def build(calls: Iterable[Call], folder: Path, jobs: int = 2) -> dict[str, Manifest]:
    """Compile what the folder does not hold yet.

    Args:
        calls: the calls to compile.
        folder: where the kernels are kept, each as `<fingerprint>.wasm`.
        jobs: how many processes compile.

    Returns:
        The manifests by fingerprint.

    Raises:
        CompilationError: a call cannot be compiled.
    """
    folder.mkdir(parents=True, exist_ok=True)
    wanted = {call.fingerprint: call for call in calls}
    missing = {key: call for key, call in wanted.items() if not (folder / f"{key}.wasm").exists()}
    with ProcessPoolExecutor(jobs, get_context("spawn"), wasm.install) as pool:
        modules = pool.map(_compiled, missing, missing.values()) if missing else ()
        for key, module in zip(missing, modules, strict=True):
            write_whole(folder / f"{key}.wasm", module, synced=False)  # half a kernel would never be made again
    return {key: manifest_of((folder / f"{key}.wasm").read_bytes()) for key in wanted}


def prune(folder: Path, wanted: Iterable[str]) -> None:
    """Remove the kernels that nobody asks for any more, by their fingerprints."""
    kept = set(wanted)
    for file in folder.glob("*.wasm"):
        if file.stem not in kept:
            file.unlink()


def _compiled(fingerprint: str, call: Call) -> bytes:
    return wasm.compiled(*call, fingerprint)
