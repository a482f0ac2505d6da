"""The project of lesson 9: Dyna, from a blank file."""

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces

from edugym.agents.dyna_q import DynaQ
from edugym.agents.q_learning import QLearning
from edugym.agents.tables import greedy_action
from edugym.mdp.protocol import Random
from edugym_course.grading.curves import Race, compare_with_ours, program_of
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.learners import BEYOND, Learner, mistakes_of_loops, other_settings
from edugym_course.grading.programs import APART, NAME, run_program
from edugym_course.grading.rule import Rule
from edugym_course.grading.small_world import ACTIONS, ENDS, GOES_ON, LAYERS, WIDTH, SmallWorld
from edugym_course.lessons.model_based.last_rewards import require_last_rewards
from edugym_course.lessons.model_based.methods import EPSILON, LEARNING_RATE

N_STEPS, PLANNING_STEPS, DISCOUNT, SWEEPS = 2_000, 10, 0.95, 8

CLEARLY = 200.0
"""How many nats tell that nothing is planned: 327 to 1535 where it is so (six seeds), and up to 35 for a program that
draws each pair as often as it was tried, whose rare pairs lag behind ours."""

DRAWN = 0.72
"""The share of the surprises that a mistake in imagined steps may leave, for nobody knows which ones were drawn."""

CORRIDORS, NUMBERS = 20, 300

CELLS, WALK, MOVES, COST = 30, 400, (-1, 0, 1), 1.0
REACHED = {0: 1.6, 1: 2.0, 2: 2.4, 3: 2.7, 5: 3.7, 7: 4.5, 10: 5.8, 15: 7.0, 20: 7.7, 50: 8.7, 100: 9.0}
"""How often a program that imagines so many steps gets through a corridor, a mean of 40, ties broken by either way."""
FEWEST, MOST = 4.9, 6.8
"""How often a program may get there. Six right programs, which draw the pairs in four ways, do so 5.3 to 6.5 times (20
corridors, five seeds); two with five imagined steps up to 4.0 times, and one with twenty 7.3 times or more."""

SHORT_CELLS, SHORT_WALK, MANY_MOVES, LOW_COST = 20, 250, (1,) * 18 + (-1,) * 12, 0.1
"""A corridor with so many actions that a program has tried few of them when it first gets to the end."""
FEWEST_OF_TRIED = 5.2
"""How often a program must get there. Five that draw the pairs in three ways do so 6.0 times or more, and three whose
imagined steps are of any action of a state that was seen 4.3 times at most (20 corridors, six seeds)."""


class Planner:
    """What Dyna comes to: after each step it plans with all that it has seen, until nothing changes.

    Which steps a program imagines cannot be told from its actions. But it imagines so many in a small world without
    chance that its values are soon those of its model.
    """

    def __init__(self, shape: tuple[int, int], discount: float = DISCOUNT) -> None:
        """Know nothing."""
        self.Q = np.zeros(shape)
        self.discount = discount
        self.known = np.zeros(shape, bool)
        self.rewards, self.next_states, self.goes_on = np.zeros(shape), np.zeros(shape, int), np.ones(shape)

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool) -> None:
        """Remember the step, and sweep over all that is known."""
        self.remember(state, action, reward, next_state, not terminated)
        for _ in range(SWEEPS):
            self.sweep()

    def remember(self, state: int, action: int, reward: float, next_state: int, goes_on: bool) -> None:
        """Keep in the model what came of an action."""
        pair = (state, action)
        self.known[pair], self.rewards[pair] = True, reward
        self.next_states[pair], self.goes_on[pair] = next_state, goes_on

    def sweep(self, share: float = 1.0) -> None:
        """Move all values that are known towards their targets, by a share of the way."""
        targets = self.rewards + self.discount * self.goes_on * self.Q.max(axis=1)[self.next_states]
        self.Q = np.where(self.known, self.Q + share * (targets - self.Q), self.Q)

    def act(self, state: int, rng: Random) -> int:
        """Choose an action by ε-greedy."""
        return int(rng.random() * self.Q.shape[1]) if rng.random() < EPSILON else greedy_action(self.Q, state, rng)

    def greedy(self, state: int, rng: Random) -> int:
        """The action with the highest value."""
        return greedy_action(self.Q, state, rng)


class MistakenPlanner(Planner):
    """Plans as little as a program, on average over what it may draw, with a mistake in its imagined steps.

    What such a program learns never comes to rest, so it matters how much it plans.

    Args:
        shape: of the table.
        any_action: whether steps are imagined with actions that were not taken, in the states that were seen; they seem
            to lead to state 0, and to bring nothing.
        stays: whether the model keeps the state that was left in place of the next one.
    """

    def __init__(
        self,
        shape: tuple[int, int],
        any_action: bool = False,
        stays: bool = False,
    ) -> None:
        """Know nothing."""
        super().__init__(shape)
        self.any_action, self.stays = any_action, stays

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool) -> None:
        """Learn from the step, remember it with the mistake, and move all values a part of the way."""
        goes_on = not terminated
        self.Q[state, action] = reward + self.discount * goes_on * self.Q[next_state].max()
        self.remember(state, action, reward, state if self.stays else next_state, goes_on)
        if self.any_action:
            self.known[state] = True
        self.sweep(min(1.0, PLANNING_STEPS / self.known.sum()))


class Tempting(SmallWorld):
    """A small world in which patience matters: to end the episode is worth nearly as much as to go on.

    In every state but the last ones an action ends the episode, for a reward that is 2 % more or less than what the
    best other action is worth with γ. So another γ takes another action in many of the states.
    """

    def __init__(self, seed: int, truncates: bool = True, noisy: bool = False) -> None:
        """Draw an MDP without chance."""
        super().__init__(seed, truncates, noisy)
        rng = np.random.default_rng(APART + seed)
        self._rewards, self._ends[:] = rng.uniform(0.5, 3.0, self._rewards.shape), GOES_ON
        values = np.zeros(LAYERS * WIDTH)
        for place in reversed(range(LAYERS * WIDTH)):
            best = self._rewards[place]
            if place < (LAYERS - 1) * WIDTH:
                layer = (place // WIDTH + 1) * WIDTH
                best = best + DISCOUNT * values[layer + self._next[place, :, 0]]
                stop = rng.integers(ACTIONS)
                nearly = 1 + (0.02 if place % 2 else -0.02)  # in each layer one of either kind
                best[stop] = self._rewards[place, stop] = nearly * np.delete(best, stop).max()
                self._ends[place, stop] = ENDS
            values[place] = best.max()


def small_world(seed: int, truncates: bool = True, noisy: bool = False) -> SmallWorld:
    """Make a world of either kind."""
    return (Tempting if seed % 2 else SmallWorld)(seed, truncates, noisy)


class Corridor(gymnasium.Env[Any, Any]):
    """A corridor: some actions go on, some back, and some stay, others in each cell. Only its end is worth a way.

    How often a program gets there tells how much it plans: the value of the end must come back through all cells. Most
    of the numbers that an observation might be are those of no cell: who imagines steps from them plans little.
    """

    def __init__(self, seed: int, cells: int = CELLS, moves: Sequence[int] = MOVES, cost: float = COST) -> None:
        """Draw the numbers of the cells and the actions."""
        rng = np.random.default_rng(APART + seed)
        self.observation_space, self.action_space = spaces.Discrete(NUMBERS), spaces.Discrete(len(moves))
        self._names = NUMBERS // cells * rng.permutation(cells)
        self._moves = [rng.permutation(moves) for _ in range(cells)]
        self._cost, self._cell = cost, 0

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[int, dict[str, Any]]:
        """Begin in the first cell."""
        super().reset(seed=seed)
        self._cell = 0
        return int(self._names[0]), {}

    def step(self, action: int) -> tuple[int, float, bool, bool, dict[str, Any]]:
        """Move, at a cost; the end brings 10."""
        self._cell = max(0, self._cell + int(self._moves[self._cell][action]))
        is_end = self._cell == len(self._names) - 1
        return int(self._names[self._cell]), 10.0 * is_end - self._cost, is_end, False, {}


def times_reached(program: Any, seed: int, n_steps: int, corridor: Callable[[int], Corridor]) -> float:
    """Return how often a program gets to the end of a corridor, the mean of some."""
    numbers = range(CORRIDORS * seed, CORRIDORS * (seed + 1))
    ends = [
        step.terminated for number in numbers for step in run_program(program, corridor(number), n_steps, number).steps
    ]
    return sum(ends) / CORRIDORS


def require_plans(program: Any, seed: int) -> None:
    """Refuse a program that imagines far fewer or far more steps than ten, or many that were never tried.

    Raises:
        WrongAnswer: it does, or it breaks the contract.
    """
    reached = times_reached(program, seed, WALK, Corridor)
    if not FEWEST <= reached <= MOST:
        as_with = min(set(REACHED) - {PLANNING_STEPS}, key=lambda n: abs(REACHED[n] - reached))
        why = (
            "Is a *new* pair drawn for each of ten imagined steps, from *all* that were tried (each action of a state,"
            " not the latest alone) and from no others? Is it learned from as a real step is, with α = 1, and each real"
            " step at once, too?"
            if reached < FEWEST
            else "Does it imagine ten steps after each real one, and not a whole sweep?"
        )
        raise WrongAnswer(
            f"in corridors of {CELLS} cells, {NAME} gets to the end {reached:.1f} times in {WALK} steps, and with"
            f" {PLANNING_STEPS} imagined steps after each real one it should be some {REACHED[PLANNING_STEPS]:g} times:"
            f" with {as_with} it is {REACHED[as_with]:g} times. {why}"
        )
    many = partial(Corridor, cells=SHORT_CELLS, moves=MANY_MOVES, cost=LOW_COST)
    if (reached := times_reached(program, seed, SHORT_WALK, many)) < FEWEST_OF_TRIED:
        raise WrongAnswer(
            f"in corridors where {len(MANY_MOVES)} actions can be taken, {NAME} gets to the end {reached:.1f} times in"
            f" {SHORT_WALK} steps, and it should be some 7 times; with 3 actions all is well. Are many of the imagined"
            " steps wasted? In a state that was seen, draw one of the actions that were *taken* there: the model knows"
            " nothing of the others"
        )


def dyna(shape: tuple[int, int]) -> DynaQ:
    """Make an agent with the settings of the project."""
    return DynaQ.create(shape, planning_steps=PLANNING_STEPS, learning_rate=LEARNING_RATE, discount=DISCOUNT)


def q_learning(shape: tuple[int, int]) -> QLearning:
    """Make an agent that does not plan."""
    return QLearning.create(shape, learning_rate=LEARNING_RATE, discount=DISCOUNT)


def mistake(**how: Any) -> Learner:
    """Return an agent that makes a mistake in its imagined steps."""
    return Learner(partial(MistakenPlanner, **how), leaves=DRAWN)


LOOPS = mistakes_of_loops(Planner)
RULE = Rule(
    Learner(Planner),
    {
        sentence: learner._replace(leaves=DRAWN) if learner.restarts else learner
        for sentence, learner in LOOPS.items()
        if sentence != BEYOND
    }
    | {f"{BEYOND}, in an imagined step, too: the model must keep `terminated`": LOOPS[BEYOND]._replace(leaves=DRAWN)}
    | {
        "nothing is planned: are the imagined steps learned from, and enough of them, each drawn anew from all that was"
        " tried?": Learner(q_learning, nats=CLEARLY),
        "pairs are imagined that were never tried: the model knows nothing of them; in a state that was seen, draw one"
        " of the actions that were taken there": mistake(any_action=True),
        "the model keeps the state that was left, or an imagined step looks up its value, in place of the next one": (
            mistake(stays=True)
        ),
        "what is behind the decimal point is lost: the model or the table holds whole numbers, as an array with"
        " dtype=int does": Learner(Planner, lambda step, before: step._replace(reward=float(int(step.reward)))),
        "γ max_a Q(S', a) is missing in the target": Learner(partial(Planner, discount=0.0)),
        "γ is 0.99 or 1, and it should be 0.95, in an imagined step, too": Learner(
            partial(Planner, discount=0.99), leaves=DRAWN
        ),
    }
    | other_settings(Planner, discount=("γ", DISCOUNT, (0.9,))),
    EPSILON,
    otherwise="; the model must keep reward, next state and whether the episode ended, for each state *and* action that"
    " was tried; an imagined step brings the reward of the model; a step that is truncated is learned, kept and planned"
    " after like any other",
    noisy=False,
    worlds=8,
    n_steps=500,
    world=small_world,
    looks_closer=False,  # it is done last
)
SHOP = Race(partial(gymnasium.make, "edugym/Supermarket-v0"), N_STEPS, program_of(dyna))


def project_9(answer: Any, seed: int) -> str:
    """Check a program with Dyna."""
    RULE.check(answer, seed)
    require_plans(answer, seed)
    require_last_rewards(answer, seed)
    RULE.look_closer(answer, seed, longer=3)
    return f"Right: it plans with what it has seen. {compare_with_ours(answer, SHOP, seed)}"
