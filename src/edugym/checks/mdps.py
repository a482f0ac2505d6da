"""What the methods of an MDP return: each mistake is answered with one sentence.

The sentence names the method, what it returned, the state it was given, and what it should return. The first steps of
a student's MDP are checked in this way; the package's own MDPs are covered by its tests.
"""

import copy
from typing import Any

import numpy as np
from gymnasium import spaces
from numpy.random import Generator as Random

from edugym.checks.interfaces import class_name
from edugym.checks.parameters import in_short
from edugym.checks.values import ANSWERS, GlobalDraws, fits, is_finite_number, kept, same
from edugym.system.packages import is_ours, is_own

CHECKED_STEPS = 200
"""How many of the first steps of students' code are checked in every way."""


def random_steps(mdp: Any, n_steps: int) -> list[Any]:
    """Play random steps in a copy of an MDP, check what a student's methods return, and return the states met.

    Raises:
        ValueError: a method returns what it may not, or the actions have too few or too many names.
    """
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
            f"action_names of {class_name(mdp)} must have a name for each action, {actions.n}, but has {len(names)}"
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


def refuse_nothing(mdp: Any, state: Any, action: Any, next_state: Any, reward: Any = None, ended: Any = None) -> None:
    """Refuse the first of these that is None, the next state or the reward, or else what says whether the task ended.

    Raises:
        ValueError: always.
    """
    if next_state is None:
        raise ValueError(_sentence(mdp, "transition", None, "the next state", state, action))
    if reward is None:
        raise ValueError(_sentence(mdp, "reward", None, "a finite number", state, action, next_state))
    raise ValueError(_sentence(mdp, "terminal", ended, "True or False", next_state))


def refuse_start(task: Any, state: Any) -> None:
    """Refuse a terminal state as the first of an episode: nothing comes after it, yet a step would be taken there.

    Raises:
        ValueError: always.
    """
    raise ValueError(
        f"initial of {class_name(innermost(task))} must return a state that is not terminal, but returned"
        f" {in_short(state)}"
    )


class CheckedMDP:
    """An MDP that checks what its methods return: it does what the MDP inside it does, and draws nothing itself.

    Args:
        mdp: the task.
        steps: for how many transitions everything is checked, also that no method changes a state or draws from global
            streams. Later only what the methods return is checked, which takes less time.
    """

    def __init__(self, mdp: Any, steps: float = CHECKED_STEPS) -> None:
        """See the class."""
        self._mdp, self._left, self._first = mdp, steps, None
        self._draws, self._space = GlobalDraws(class_name(mdp)), mdp.observation_space
        self._rows = int(self._space.n) if isinstance(self._space, spaces.Discrete) and self._space.start == 0 else 0

    def __getattr__(self, name: str) -> Any:
        """Everything else that the MDP has."""
        return getattr(self._mdp, name)

    def initial(self, rng: Random) -> Any:
        """Draw the state in which an episode starts.

        Raises:
            ValueError: it is terminal.
        """
        with self._draws.refused("initial"):
            first = self._first = self._mdp.initial(rng)
        if first is not None and self.terminal(first):
            refuse_start(self._mdp, first)
        return first

    def transition(self, state: Any, action: Any, rng: Random) -> Any:
        """Draw the next state.

        Raises:
            ValueError: it is None, or the state was changed.
        """
        self._left -= 1
        if self._left < 0:  # from here on without a detour; `reward` sees whether it is None
            vars(self).update(transition=self._mdp.transition)
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
        if next_state is None:
            refuse_nothing(self._mdp, state, action, next_state)
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
        terminated = self._mdp.terminal(state) if self._left < 0 else self._unchanging("terminal", (state,))
        if not isinstance(terminated, ANSWERS):
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
                    f"{method} of {class_name(self._mdp)} must return the {which} state, but returned None (is a return"
                    " missing?)"
                )
            raise ValueError(_sentence(self._mdp, "observation", observation, f"an element of {space}", state))


def innermost(mdp: Any) -> Any:
    """Return the MDP inside the package's wrappers."""
    return innermost(mdp.mdp) if is_ours(type(mdp)) and hasattr(mdp, "mdp") else mdp


def _sentence(
    mdp: Any, method: str, returned: Any, allowed: str, state: Any, action: Any = None, next_state: Any = None
) -> str:
    given = f"state {in_short(state)}"
    given += "" if action is None else f", action {in_short(action)}"
    given += "" if next_state is None else f", next state {in_short(next_state)}"
    forgotten = " (is a return missing?)" if returned is None else ""
    return (
        f"{method} of {class_name(mdp)} must return {allowed}, but returned {in_short(returned)} for {given}{forgotten}"
    )


def refuse_change(mdp: Any, method: str, before: Any, now: Any) -> None:
    """Refuse a method that has changed the state that it was given."""
    if not same(before, now):
        raise ValueError(
            f"{method} of {class_name(mdp)} must not change the state that it is given, but turned {in_short(before)}"
            f" into {in_short(now)}: make a new one, for example from a copy"
        )
