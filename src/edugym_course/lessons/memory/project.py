"""The project of lesson 5: Q-learning with a memory of its own, a window of what it saw and did, from a blank file."""

from collections import defaultdict
from collections.abc import Callable
from functools import partial
from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces

from edugym.agents.tables import greedy_action
from edugym.mdp.protocol import Random, Reals
from edugym_course.grading.curves import Race, compare_with_ours, program_of
from edugym_course.grading.learners import Learner, mistakes_of_loops, old_start, other_settings, stays
from edugym_course.grading.programs import run_program
from edugym_course.grading.rule import TRIAL, Rule
from edugym_course.grading.small_world import WIDTH, SmallWorld
from edugym_course.lessons.memory.riddles import require_riddles

N_STEPS, K, LEARNING_RATE, DISCOUNT, EPSILON = 20_000, 3, 0.2, 0.8, 0.1

KEPT = 8
"""How many steps of an episode an agent remembers at most, which its window may cut further."""
History = tuple[Any, ...]
"""O_0, A_0, O_1, ..., O_t: the observations and actions of an episode so far."""
Cut = Callable[[History], History]
"""Makes a window of a history, or what is left of it for the next episode."""


def last(history: History, k: int = K) -> History:
    """The last k observations, and the actions between them."""
    return history[-(2 * k - 1) :]


def emptied(history: History) -> History:
    """What an episode should begin with."""
    return ()


def swapped(history: History) -> History:
    """The last five entries, where each action is noted behind the observation that it led to."""
    pairs = zip(history[2::2], history[1::2], strict=True)
    return (history[0], *(entry for pair in pairs for entry in pair))[-(2 * K - 1) :]


class VeiledWorld(gymnasium.ObservationWrapper[Any, Any, Any]):
    """A small world in which states look alike: all but the first of an episode show one of two observations.

    It has two actions only, so that windows come again.
    """

    def __init__(self, seed: int, truncates: bool = True, noisy: bool = True) -> None:
        """Draw a small world."""
        world = SmallWorld(seed, truncates, noisy)
        super().__init__(world)
        self.observation_space, self.action_space = spaces.Discrete(2 * WIDTH), spaces.Discrete(2)
        self._places = {int(state): place for place, state in enumerate(world.states)}

    def observation(self, observation: int) -> int:
        """What shows of a state."""
        place = self._places[observation]
        return place if place < WIDTH else WIDTH + place % WIDTH


class Windowed:
    """Q-learning on windows.

    Args:
        shape: the second entry is the number of actions.
        window: makes the window of a history.
        left: makes what an episode begins with of the history of the last one.
        left_cut: the same after an episode that was truncated.
        grows: whether what was seen and done is kept in it.
        stale: whether the value of the next window moves, and not that of the old one.
        moves: whether the value in the target is that of the next window, or of the old one.
        learning_rate: α.
        discount: γ.
        first: the values at first.
        epsilon: how far the target is the mean over all next actions, and not the maximum; ε in expected SARSA.
    """

    def __init__(
        self,
        shape: tuple[int, int],
        window: Cut = last,
        left: Cut = emptied,
        left_cut: Cut | None = None,
        grows: bool = True,
        stale: bool = False,
        moves: bool = True,
        learning_rate: float = LEARNING_RATE,
        discount: float = DISCOUNT,
        first: float = 0.0,
        epsilon: float = 0.0,
    ) -> None:
        """Know nothing."""
        self._Q: defaultdict[History, Reals] = defaultdict(lambda: np.full(shape[1], first))
        self._past: History = ()
        self._window, self._grows, self._moves, self._stale = window, grows, moves, stale
        self._left, self._left_cut = left, left_cut or left
        self._learning_rate, self._discount, self._epsilon = learning_rate, discount, epsilon

    def row(self, history: History) -> Reals:
        """The values of the window at the end of a history."""
        return self._Q[self._window(history)]

    def values(self, state: int) -> Reals:
        """The values after an observation."""
        return self.row((*self._past, state))

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool, truncated: bool) -> None:
        """Learn from a step, and remember it."""
        now = (*self._past, state)
        then = (*now, action, next_state) if self._moves else now
        after = self.row(then)
        value = (1 - self._epsilon) * after.max() + self._epsilon * after.mean()
        target = reward if terminated else reward + self._discount * value
        self.move(then if self._stale else now, action, target)
        if self._grows:
            self._past = (*now, action)[-2 * KEPT :]
        if truncated or terminated:
            left = self._left if terminated else self._left_cut
            self._past = left((*now, action, next_state))[-2 * KEPT :]

    def move(self, history: History, action: int, target: float) -> None:
        """Move the value of an action towards a target."""
        self.row(history)[action] += self._learning_rate * (target - self.row(history)[action])

    def forget_episode(self) -> None:
        """Begin with an empty window."""
        self._past = ()

    def act(self, state: int, rng: Random) -> int:
        """Choose an action by ε-greedy."""
        values = self.values(state)
        return int(rng.random() * len(values)) if rng.random() < EPSILON else greedy_action(values[np.newaxis], 0, rng)

    def greedy(self, history: History, rng: Random) -> int:
        """The action with the highest value after a history."""
        return greedy_action(self.row(history)[np.newaxis], 0, rng)


class WindowedSARSA(Windowed):
    """SARSA on windows: a step waits for the action that comes next.

    After one that was cut off, that action is never taken; it most likely is the best one.
    """

    _waiting: tuple[History, int, float] | None = None

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool, truncated: bool) -> None:
        """Learn from the step before, whose next action is known now, and keep this one."""
        if self._waiting is not None:
            before, earlier_action, earlier_reward = self._waiting
            target = earlier_reward + self._discount * float(self.values(state)[action])
            super().move(before, earlier_action, target)
        self._waiting = None if terminated or truncated else ((*self._past, state), action, reward)
        super().learn(state, action, reward, next_state, terminated, truncated)

    def move(self, history: History, action: int, target: float) -> None:
        """Learn from a step to the maximum after an end alone."""
        if self._waiting is None:
            super().move(history, action, target)


def mistake(**how: Any) -> Learner:
    """Return an agent that makes a mistake."""
    return Learner(partial(Windowed, **how))


RULE = Rule(
    Learner(Windowed),
    mistakes_of_loops(Windowed, remembers=True)
    | {
        "the state stays the first one of the episode: is `state = next_state` missing?": Learner(
            partial(Windowed, grows=False), stays
        ),
        "there is no memory: the values hang on the last observation alone": mistake(window=partial(last, k=1)),
        "the actions are missing in the window": mistake(window=lambda history: history[::2][-K:]),
        "the window has two observations, and it should have three": mistake(window=partial(last, k=2)),
        "the window has four observations, and it should have three": mistake(window=partial(last, k=4)),
        "the window has five observations or more, or the whole episode; it should have three": mistake(
            window=partial(last, k=KEPT)
        ),
        "the window has six entries, an action too many at its front": mistake(
            window=lambda history: history[-2 * K :]
        ),
        "each action is noted behind the observation that it led to; it belongs before it": mistake(window=swapped),
        "an episode begins with what is left of the last one in its window: empty it at each reset": mistake(
            left=lambda history: history[:-1]
        ),
        "an episode begins with the last one in its window, with all that it saw: empty it at each reset": mistake(
            left=lambda history: history
        ),
        "after a reset the window stays as it is, and the first action hangs on the old episode: begin the window anew,"
        " with the observation that reset() gives": Learner(
            partial(Windowed, left=lambda history: history[:-1]), old_start
        ),
        "an episode begins with the last one in its window, and an action 0: empty it at each reset": mistake(
            left=lambda history: (*history, 0)
        ),
        "an episode that was truncated leaves its window to the next one: empty it after `truncated`, too": mistake(
            left_cut=lambda history: history[:-1]
        ),
        "the first values are about 1, and not 0": mistake(first=1.0),
        "the value of the *next* window moves: keep the old one, in which the action was taken, until the update is"
        " done": mistake(stale=True),
        "the target has the value of the old window, without what was just done and seen": mistake(moves=False),
        "γ max_a Q(S', a) is missing in the target": mistake(discount=0.0),
        "Q(S', A'), the value of the action that comes next, stands where the maximum should: that is SARSA": Learner(
            WindowedSARSA
        ),
        "the target has the mean over the next actions, as ε-greedy draws them, where the maximum should stand: that is"
        " expected SARSA": mistake(epsilon=EPSILON),
    }
    | other_settings(
        Windowed,
        discount=("γ", DISCOUNT, (1.0, 0.99, 0.9, 0.5)),
        learning_rate=("α", LEARNING_RATE, (0.05, 0.1, 0.5, 1.0)),
    ),
    EPSILON,
    otherwise="; S is the window (O, A, O, A, O) up to the present observation, and S' that with the next one; the"
    " actions in it are those that were *taken*, and each window has values of its own",
    worlds=8,
    world=VeiledWorld,
    remembers=True,
)
CORRIDOR = Race(
    partial(gymnasium.make, "edugym/MemoryCorridor-v0"),
    N_STEPS,
    program_of(Windowed),
    episodes=200,
    judged=("played",),
    remembers=True,
)


def project_5(answer: Any, seed: int) -> str:
    """Check a program with a window."""
    run_program(answer, VeiledWorld(seed), TRIAL, seed, noun="history")
    RULE.check(answer, seed)
    require_riddles(answer, seed)
    return f"Right: what it saw and did is its state. {compare_with_ours(answer, CORRIDOR, seed)}"
