"""The project of lesson 2: SARSA with its A', from a blank file."""

from functools import partial
from typing import Any

import gymnasium
import numpy as np

from edugym.agents.expected_sarsa import ExpectedSARSA
from edugym.agents.q_learning import QLearning
from edugym.agents.sarsa import SARSA
from edugym.agents.tables import epsilon_greedy_action
from edugym_course.grading.curves import Race, compare_with_ours, program_of
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.learners import Learner, mistakes_of_loops, other_settings, other_tables, too_early
from edugym_course.grading.programs import NAME, run_program, shape_of
from edugym_course.grading.replay import best_of, learning
from edugym_course.grading.rule import Rule
from edugym_course.grading.small_world import SmallWorld
from edugym_course.grading.surprises import NATS
from edugym_course.lessons.on_off_policy.methods import CLIFF, CLIFF_STEPS, DISCOUNT, EPSILON
from edugym_course.lessons.on_off_policy.riddles import require_riddles

N_STEPS, CUT_STEPS, LEARNING_RATE = 10_000, 3_000, 0.5
UNSEEN = 0.35
"""The share of the surprises that a mistake may leave which hangs on an action that nobody sees."""


def agent(
    shape: tuple[int, int], kind: Any = SARSA, learning_rate: float = LEARNING_RATE, discount: float = DISCOUNT
) -> Any:
    """Make an agent with the settings of the project."""
    return kind.create(shape, learning_rate=learning_rate, discount=discount)


class FutureAfterTheEnd(SARSA):
    """SARSA that looks up the value of a drawn action after the end, too, most likely the best one."""

    __slots__ = ()

    def learn(
        self, state: int, action: int, reward: float, next_state: int, next_action: int, terminated: bool
    ) -> None:
        """Learn as if nothing ended."""
        drawn = int(self.Q[next_state].argmax()) if terminated else next_action
        super().learn(state, action, reward, next_state, drawn, False)


class MovesTheNext:
    """SARSA that moves Q(S', A') in place of Q(S, A)."""

    def __init__(self, shape: tuple[int, int]) -> None:
        """Know nothing."""
        self.Q = np.zeros(shape)
        self._left: float | None = None

    def act(self, state: int, rng: np.random.Generator) -> int:
        """Choose an action by ε-greedy."""
        return int(epsilon_greedy_action(self.Q, state, EPSILON, rng))

    def learn(
        self, state: int, action: int, reward: float, next_state: int, next_action: int, terminated: bool
    ) -> None:
        """Move the value of the next pair; after an end that is the first one of the next episode."""
        if self._left is not None:
            self._move(state, action, self._left)
        self._left = reward if terminated else None
        if not terminated:
            self._move(next_state, next_action, reward + DISCOUNT * float(self.Q[next_state, next_action]))

    def _move(self, state: int, action: int, target: float) -> None:
        self.Q[state, action] += LEARNING_RATE * (target - self.Q[state, action])


RULE = Rule(
    Learner(agent),
    mistakes_of_loops(agent, on_policy=True)
    | too_early(agent)
    | {
        "the target has max_a Q(S', a), the value of the *best* next action: that is Q-learning": Learner(
            partial(agent, kind=QLearning)
        ),
        "the target has the mean over the next actions: that is expected SARSA": Learner(
            partial(agent, kind=ExpectedSARSA)
        ),
        "Q(S', A') is missing in the target": Learner(partial(agent, discount=0.0)),
        "the target has the value of an action after the end: where `terminated` is True it is the reward alone": (
            Learner(partial(agent, kind=FutureAfterTheEnd), leaves=UNSEEN)
        ),
        "`state, action = next_state, next_action` comes before the update, which then moves Q(S', A') in place of"
        " Q(S, A)": Learner(MovesTheNext, leaves=UNSEEN),
    }
    | other_settings(
        agent,
        discount=("γ", DISCOUNT, (0.95, 0.9, 0.5)),
        learning_rate=("α", LEARNING_RATE, (0.1, 0.25, 0.75, 1.0)),
    )
    | other_tables(agent, (-1.0, 1.0, 10.0)),
    EPSILON,
    truncates=False,
    otherwise="; look at two places: A', whose value is in the target, is the action that is taken next, and is not"
    " drawn a second time; at the end of an episode the target is the reward alone",
)
CLIFF_WALK = Race(
    partial(gymnasium.make, CLIFF, max_episode_steps=CLIFF_STEPS), N_STEPS, program_of(agent), judged=("late",)
)
"""What counts is what it earns while it explores: that is what SARSA learns."""


def require_new_actions(program: Any, seed: int) -> None:
    """Refuse a program that begins an episode, after a truncated one, with the action for the state of the cut.

    Raises:
        WrongAnswer: it does, or it breaks the contract.
    """
    world = SmallWorld(seed)
    steps, logs, before = run_program(program, world, CUT_STEPS, seed).steps, np.zeros(2), None
    right = RULE.right._replace(skips=lambda step: step.truncated)  # who learns from them draws an A' that nobody sees
    for learned, step in learning(steps, right, shape_of(world)):
        if before and before.truncated:
            looks = [best_of(learned, state) for state in (step.state, before.next_state)]
            logs += np.log([EPSILON / len(best) + (1 - EPSILON) * best[step.action] / sum(best) for best in looks])
        before = step
    new, old = logs
    if old > new + NATS:
        raise WrongAnswer(
            f"after an episode that was truncated, {NAME} begins with the action for the state in which the clock"
            " stopped: after every reset() choose a new action, in the state that it gives"
        )


def project_2(answer: Any, seed: int) -> str:
    """Check a program with SARSA."""
    RULE.check(answer, seed)
    require_new_actions(answer, seed)
    require_riddles(answer, seed)
    return f"Right: A' is both in the target and on the road. {compare_with_ours(answer, CLIFF_WALK, seed)}"
