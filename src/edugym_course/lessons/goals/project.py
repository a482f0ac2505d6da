"""The project of lesson 11: a table of universal values with the hindsight 'final', from a blank file."""

from collections import defaultdict
from dataclasses import replace
from functools import partial
from typing import Any

import gymnasium
import numpy as np

from edugym.agents.tables import greedy_action
from edugym.mdp.protocol import Random, Reals
from edugym_course.grading.curves import Race, compare_with_ours, program_of
from edugym_course.grading.learners import LOW, Learner, mistakes_of_loops, other_settings
from edugym_course.grading.programs import Environment, Step
from edugym_course.grading.rule import Rule

N_STEPS, LEARNING_RATE, DISCOUNT, EPSILON = 20_000, 0.5, 0.9, 0.1
CLOSER = 12
"""In so many small worlds programs that pass are looked at once more: in longer runs what is wrong shows no better."""
WORST = -10.0
"""The first value of every action: what it is worth never to reach the goal, -1 / (1 - γ)."""

Pattern = tuple[int, ...]
Row = list[float]  # Python reads one entry of a list sooner than one of an array
Observation = dict[str, Any]


class Hindsight:
    """Q-learning of universal values, with the hindsight 'final'.

    Args:
        shape: the second entry is the number of actions.
        goal: which goal the steps of an episode are learned for when it is over: what its "last" step achieved, or its
            "first"; what was there "before" the last step, or at the "start"; "own", what each step achieves itself;
            "same", the goal that it had; or "none", if they are not learned again.
        when: whether this is done after "all" episodes, or only where the goal was "missed" or "reached"; or after each
            step, for the steps until then ("always").
        order: whether the steps are learned "backwards" or "forwards".
        kept: which of them are learned: "all", all but one ("not last", "not first"), or "only last".
        empties: after which episodes the list of steps is emptied: "all", "reached" or "none".
        reward: whether a step is paid for the "new" goal, or as it was for the "old" one, or "always 0", or "1 and 0".
        ends: whether a step that achieves the new goal ends the episode.
        achieves: which steps achieve it: those that lead to it ("all"), or only the "last".
        returns: whether the target is the return of the steps that are learned again, and not that of Q-learning.
        swaps: whether state and goal have changed places there.
        state_has, next_state_has: which goal stands beside the state, and beside the next one: "new" or "old".
        looks_on: whether the maximum is that of the next state, and not that of the state itself.
        own_looks_on, own_discount: the same and γ where a step is learned for the goal of the episode, if they differ.
        sweeps: how often the steps are learned again.
        own: whether each step is learned at once for the goal of the episode.
        knows_goal: whether values hang on the goal.
        shares_rows: whether all rows of the table are one and the same list.
        least: whether the lowest value looks best.
        first: whether the first of equal values looks best.
        first_value: of every action.
        learning_rate: α.
        discount: γ.
    """

    def __init__(
        self,
        shape: tuple[int, int],
        goal: str = "last",
        when: str = "all",
        order: str = "backwards",
        kept: str = "all",
        empties: str = "all",
        reward: str = "new",
        ends: bool = True,
        achieves: str = "all",
        returns: bool = False,
        swaps: bool = False,
        state_has: str = "new",
        next_state_has: str = "new",
        looks_on: bool = True,
        sweeps: int = 1,
        own: bool = True,
        knows_goal: bool = True,
        least: bool = False,
        first: bool = False,
        first_value: float = WORST,
        learning_rate: float = LEARNING_RATE,
        discount: float = DISCOUNT,
        own_looks_on: bool | None = None,
        own_discount: float | None = None,
        shares_rows: bool = False,
    ) -> None:
        """Know nothing."""
        one = [first_value] * shape[1]
        self._Q: defaultdict[tuple[Pattern, Pattern], Row] = defaultdict(lambda: one if shares_rows else [*one])
        self._steps: list[tuple[Pattern, int, float, Pattern]] = []
        self._goal, self._when, self._order, self._kept, self._empties = goal, when, order, kept, empties
        self._reward, self._ends, self._own, self._knows_goal = reward, ends, own, knows_goal
        self._achieves, self._returns, self._swaps = achieves, returns, swaps
        self._sign = -1.0 if least else 1.0
        self._handicaps = 1e-4 * np.arange(shape[1]) * first
        self._state_has, self._next_state_has = state_has, next_state_has
        self._looks_on, self._sweeps = looks_on, sweeps
        self._learning_rate, self._discount = learning_rate, discount
        self._own_looks_on = looks_on if own_looks_on is None else own_looks_on
        self._own_discount = discount if own_discount is None else own_discount

    def row(self, state: Pattern, goal: Pattern) -> Row:
        """The values of a state, for a goal."""
        return self._Q[state, goal if self._knows_goal else ()]

    def values(self, seen: Observation) -> Reals:
        """The values after an observation."""
        row = self.row(pattern(seen["achieved_goal"]), pattern(seen["desired_goal"]))
        return self._sign * np.array(row) - self._handicaps

    def learn(
        self,
        state: Observation,
        action: int,
        reward: float,
        next_state: Observation,
        terminated: bool,
        truncated: bool,
    ) -> None:
        """Learn a step for its own goal; when the episode is over, learn all its steps for what it achieved."""
        s, then, goal = (
            pattern(part) for part in (state["achieved_goal"], next_state["achieved_goal"], state["desired_goal"])
        )
        if self._own:
            row = self.row(s, goal)
            after = self.row(then, goal) if self._own_looks_on else row
            self._move(row, action, reward if terminated else reward + self._own_discount * max(after))
        self._steps.append((s, action, reward, then))
        if self._when == "always" and not (terminated or truncated):
            self._learn_again(goal)
        if terminated or truncated:
            episodes = {"all": True, "always": True, "missed": not terminated, "reached": terminated, "none": False}
            if episodes[self._when]:
                self._learn_again(goal)
            if episodes[self._empties]:
                self._steps.clear()

    def _learn_again(self, old: Pattern) -> None:
        steps = self._steps
        new = {
            "last": steps[-1][3],
            "first": steps[0][3],
            "before": steps[-1][0],
            "start": steps[0][0],
            "same": old,
        }.get(self._goal)
        chosen = {"all": steps, "not last": steps[:-1], "not first": steps[1:], "only last": steps[-1:]}[self._kept]
        row = (lambda state, goal: self.row(goal, state)) if self._swaps else self.row
        future = 0.0
        for step in self._sweeps * (chosen[::-1] if self._order == "backwards" else chosen):
            s, action, paid, then = step
            goal = then if self._goal == "own" else new
            if goal is None:
                return
            goals, reached = {"new": goal, "old": old}, then == goal
            if self._achieves == "last":
                reached = step is steps[-1]
            honest, one = (0.0, 1.0) if reached else (-1.0, 0.0)
            reward = {"new": honest, "old": paid, "always 0": 0.0, "1 and 0": one}[self._reward]
            future = reward if reached else reward + self._discount * future
            after = row(then, goals[self._next_state_has])
            ends = reached and self._ends
            if self._returns:
                reward, ends = future, True
            self._update(row(s, goals[self._state_has]), action, reward, after, ends)

    def _update(self, row: Row, action: int, reward: float, after: Row, ends: bool) -> None:
        self._move(row, action, reward if ends else reward + self._discount * max(after if self._looks_on else row))

    def _move(self, row: Row, action: int, target: float) -> None:
        row[action] += self._learning_rate * (target - row[action])

    def forget_episode(self) -> None:
        """Forget the steps of an episode."""
        self._steps.clear()

    def act(self, seen: Observation, rng: Random) -> int:
        """Choose an action by ε-greedy."""
        values = self.values(seen)
        return int(rng.random() * len(values)) if rng.random() < EPSILON else self.greedy(seen, rng)

    def greedy(self, seen: Observation, rng: Random) -> int:
        """The action with the highest value."""
        return greedy_action(self.values(seen)[np.newaxis], 0, rng)


def pattern(switches: Any) -> Pattern:
    """A pattern as a key of a table."""
    return tuple(np.asarray(switches).tolist())


def panel(seed: int, truncates: bool = True, noisy: bool = True) -> Environment:
    """A panel with four switches; nothing else of it can be varied, and it always truncates."""
    made: Environment = gymnasium.make("edugym/Switches-v0", n_switches=4)
    return made


def keeps_goal(step: Step, before: Step | None) -> Step:
    """Take the goal of the first episode for that of all."""
    goal = (before or step).state["desired_goal"]
    return step._replace(state={**step.state, "desired_goal": goal})


def mistake(**how: Any) -> Learner:
    """Return an agent that makes a mistake."""
    return Learner(partial(Hindsight, **how))


RULE = Rule(
    Learner(Hindsight),
    mistakes_of_loops(Hindsight)
    | {
        LOW: mistake(least=True),
        "where several actions look best the first is taken, so it flips switch 0 for ever; draw one of them": mistake(
            first=True
        ),
        "the goal is always that of the first episode: each reset gives a new one": Learner(Hindsight, keeps_goal),
        "all rows of the table are one and the same list or array: make a new one for each pair": mistake(
            shares_rows=True
        ),
        "there is no hindsight: nothing is learned again when an episode is over": mistake(goal="none"),
        "the steps are learned again for the goal that the episode *had*; take what its last step achieved": mistake(
            goal="same"
        ),
        "the new goal is what the *first* step achieved, and it should be the last one": mistake(goal="first"),
        "the new goal is the pattern *before* the last step; take what this step achieved, its next state": mistake(
            goal="before"
        ),
        "the new goal is the pattern at the start; take what the last step achieved": mistake(goal="start"),
        "each step gets a goal of its own, what it achieves itself; 'final' has one for an episode": mistake(
            goal="own"
        ),
        "only episodes that missed their goal are learned again; do so after all of them": mistake(when="missed"),
        "only episodes that reached their goal are learned again, and they need it least": mistake(when="reached"),
        "the steps are learned again in the order in which they were taken; begin with the last one, so that the first"
        " hears of the goal in the same sweep": mistake(order="forwards"),
        "the last step is not learned again, and it is the one that achieves the new goal": mistake(kept="not last"),
        "the first step is not learned again; all of the episode should be": mistake(kept="not first"),
        "only the last step is learned again; all of the episode should be": mistake(kept="only last"),
        "the steps so far are learned again after *each* step; wait until the episode is over": mistake(when="always"),
        "the steps of earlier episodes are learned again too: empty the list at each reset": mistake(empties="none"),
        "the list of steps is emptied only where the goal was reached: empty it at each reset": mistake(
            empties="reached"
        ),
        "rewards and ends are the old ones, of the goal that was missed; a step that achieves the new one brings 0 and"
        " ends the episode": mistake(reward="old", ends=False),
        "a step that achieves the new goal is paid as it was, -1; it is paid 0 now": mistake(reward="old"),
        "every step that is learned again is paid 0; only one that achieves the new goal is": mistake(
            reward="always 0"
        ),
        "steps that are learned again are paid 1 and 0; the task pays 0 at the goal and −1 elsewhere": mistake(
            reward="1 and 0"
        ),
        "a step that achieves the new goal ends the episode: its target is the reward alone": mistake(ends=False),
        "not only the last step may achieve the new goal: compare the next state of each step with it": mistake(
            achieves="last"
        ),
        "steps that are learned again have the return of the episode as their target; it is R + γ max_a Q(S', G, a)"
        " here too": mistake(returns=True),
        "state and goal have changed places in the table where the steps are learned again": mistake(swaps=True),
        "in hindsight the maximum is that of Q(S', G, a), and it should be that of Q(S', G', a), with the new goal": (
            mistake(next_state_has="old")
        ),
        "in hindsight Q(S, G, A) moves, and it should be Q(S, G', A), that of the new goal": mistake(state_has="old"),
        "the maximum is that of the state itself: γ max_a Q(S', G, a) asks what comes next": mistake(looks_on=False),
        "the steps are learned again twice over; once is enough": mistake(sweeps=2),
        "the steps are learned in hindsight only; learn each at once for its own goal too": mistake(own=False),
        "γ is missing where the steps are learned again: it is R + γ max_a Q(S', G, a) there too": mistake(
            discount=1.0, own_discount=DISCOUNT
        ),
        "γ is missing where a step is learned at once, for its own goal: it is R + γ max_a Q(S', G, a) there too": (
            mistake(own_discount=1.0)
        ),
        "where a step is learned at once, for its own goal, the maximum is that of the state itself; ask what comes"
        " next": mistake(own_looks_on=False),
        "where the steps are learned again, the maximum is that of the state itself; ask what comes next": mistake(
            looks_on=False, own_looks_on=True
        ),
        "the goal has no part in the values: a row of the table is a pair of a pattern and a goal": mistake(
            knows_goal=False
        ),
        "the goal has no part in the values, and nothing is learned again: this is the Q-learning of one goal": mistake(
            knows_goal=False, goal="none"
        ),
        "all values start at 0, so that what was never tried looks best; they should start at −10": mistake(
            first_value=0.0
        ),
        "γ max_a Q(S', G, a) is missing in the target": mistake(discount=0.0),
        "the old value is lost: α is 0.5 in the text, and Q moves by a half of the difference": mistake(
            learning_rate=1.0
        ),
    }
    | other_settings(
        Hindsight,
        discount=("γ", DISCOUNT, (1.0, 0.95, 0.8, 0.5)),
        learning_rate=("α", LEARNING_RATE, (0.05, 0.1, 0.25, 0.4, 0.6)),
    )
    | {
        f"each first value is about {value:g}, and it should be {WORST:g}": mistake(first_value=value)
        for value in (-20.0, -8.0, -5.0, -1.0)
    },
    EPSILON,
    otherwise=", and the new goal: one for the whole episode, what its last step achieved",
    n_steps=4000,  # the old rewards are seldom seen in what is done: in 2000 they are not surely told
    world=panel,
    looks_closer=False,  # it is done last
    costs=False,  # the rewards of a goal are made up by the program, and its values are below 0 as it is
)
SIX = Race(
    partial(gymnasium.make, "edugym/Switches-v0", n_switches=6),
    N_STEPS,
    program_of(Hindsight),
    episodes=200,
    judged=("played",),
)


def project_11(answer: Any, seed: int) -> str:
    """Check a program with hindsight."""
    RULE.check(answer, seed)
    replace(RULE, worlds=CLOSER).look_closer(answer, seed, longer=1)
    return f"Right: it learns from what it reached. {compare_with_ours(answer, SIX, seed)}"
