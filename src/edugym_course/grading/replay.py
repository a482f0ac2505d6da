"""Which equation explains the actions that a program chose: its own steps are learned from once more.

What a tabular method has learned follows from its steps. So the steps of a program are given to an agent of ours, which
says before each of them which actions look best. A program with the same equation takes one of these, but for ε of its
steps. Every other one is a surprise, and of these there must not be too many. The same is tried with agents that make
the usual mistakes: one that makes the actions much more probable than the right equation does is the likely cause.
"""

import math
from collections import deque
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from heapq import heappop, heappush
from itertools import islice
from typing import Any, NamedTuple

import numpy as np

from edugym.agents.tables import tied
from edugym.checks.contract import learns_from
from edugym.mdp.protocol import Reals
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.programs import (
    NAME,
    POLICY,
    Environment,
    Run,
    Step,
    actions_of,
    learn_from,
    require_reproducible,
    run_program,
    shape_of,
)
from edugym_course.grading.small_world import ACTIONS, SmallWorld
from edugym_course.grading.surprises import NATS, SIGMAS, SLACK, UNEXPLAINED, Row, Surprises

TRIAL = 300
"""The steps of the runs that must repeat each other."""
ASKED = 200
"""How many observations a policy is asked about."""
RARELY, ENOUGH = 0.25, 30
"""The share of its chances below which an action is hardly tried; and how many chances are enough to tell."""
AT_ONCE = 100
"""How many steps a mistake goes on, before another one that is more probable may."""
SWAPPED = "ε and 1 − ε have changed places: an action is drawn at random with probability ε"
FALLS = "Their share falls during a run: ε should be the same from the first step to the last"
FIRST = (
    "It is so in the first step of episodes, and not in the others: after a reset, choose the action anew, in the state"
    " that reset() gives"
)
LOW = "low values are preferred to high ones: is there an `argmin`, or a minus sign too many?"


Maker = Callable[[tuple[int, int]], Any]
"""Makes an agent for the shape of a table."""


class Learner(NamedTuple):
    """A method, or a mistake.

    Attributes:
        make: makes an agent, for the shape of a table. Its values are in its table `Q`, or it has a method
            `values(state)`.
        alter: what it takes a step for, after what it took the step before for (None at the first).
        skips: from which steps it does not learn.
        swaps: whether it takes a random action with probability 1 − ε.
        restarts: whether it takes the first state of the next episode for the one that a truncated step led to.
        nats: of a mistake, how much more probable it must make the actions than the right equation, as a logarithm;
            more for one that a right program resembles.
        leaves: of a mistake, the share of the surprises above those by ε that it may leave; more for one that hangs on
            what the steps do not show.
    """

    make: Maker
    alter: Callable[[Step, Step | None], Step] = lambda step, before: step
    skips: Callable[[Step], bool] = lambda step: False
    swaps: bool = False
    restarts: bool = False
    nats: float = NATS
    leaves: float = UNEXPLAINED


def _goes_on(step: Step, before: Step | None) -> Step:
    return step._replace(terminated=False, truncated=step.terminated or step.truncated)


def _ends(step: Step, before: Step | None) -> Step:
    return step._replace(terminated=step.terminated or step.truncated)


def _is_over(before: Step | None) -> bool:
    """Whether an episode begins after a step, or with the first one."""
    return before is None or before.terminated or before.truncated


def _old_start(step: Step, before: Step | None) -> Step:
    return step._replace(state=before.next_state) if before and (before.terminated or before.truncated) else step


def stays(step: Step, before: Step | None) -> Step:
    """Take the first state of an episode for all of its states."""
    return step if before is None or before.terminated or before.truncated else step._replace(state=before.state)


def _costs(step: Step, before: Step | None) -> Step:
    return step._replace(reward=-step.reward)


def mistakes_of_loops(make: Maker, on_policy: bool = False, remembers: bool = False) -> dict[str, Learner]:
    """Return the mistakes that any loop can have, by their sentences.

    Args:
        make: makes the right agent.
        on_policy: whether it learns from the next action. What such a program learns beyond an end cannot be told from
            its steps, for it hangs on an action that is never taken.
        remembers: whether it learns from windows. One that goes on into the next episode is like none that was met.
    """
    beyond_an_end = {
        "the value of a state after the end is looked up; a terminal state has no future, so its target is the reward"
        " alone": Learner(make, _goes_on),
        "a truncated episode is learned as a terminated one: somebody stopped the clock, and the next state still has"
        " its value": Learner(make, _ends),
    }
    if not remembers:
        sentence = "S' is the state after the reset where an episode was truncated: learn first, and reset then"
        beyond_an_end[sentence] = Learner(make, restarts=True)
    return ({} if on_policy else beyond_an_end) | {
        "what is learned at the end of an episode is left out, and that is where the reward often is: learn first, and"
        " look then whether the episode is over": Learner(make, skips=lambda step: step.terminated or step.truncated),
        "after an end the program goes on from the last state of the old episode: state, info = environment.reset()"
        " gives the first state of the new one": Learner(make, _old_start),
        "the state stays the first one of the episode: is `state = next_state` missing?": Learner(make, stays),
        LOW: Learner(make, _costs),
    }


def other_settings(make: Callable[..., Any], **settings: tuple[str, float, Sequence[float]]) -> dict[str, Learner]:
    """Return agents that take other numbers than those of the text, by their sentences.

    Args:
        make: makes the right agent, for the shape of a table and with these settings.
        settings: for each, its symbol, the right number, and others that are told at every seed tried: numbers of other
            lessons, and more and less.
    """
    return {
        f"{symbol} is about {other:g}, and it should be {right:g}": Learner(partial(make, **{name: other}))
        for name, (symbol, right, others) in settings.items()
        for other in others
    }


class _WholeNumbers(np.ndarray[Any, Any]):
    """An array whose entries lose what is behind the decimal point, as those of dtype int do."""

    def __setitem__(self, where: Any, value: Any) -> None:
        """Write what is before the decimal point."""
        super().__setitem__(where, np.trunc(value))


def other_tables(make: Maker, values: Sequence[float] = (1.0, 10.0)) -> dict[str, Learner]:
    """Return agents whose table `Q` does not begin at 0, or holds whole numbers, by their sentences."""

    def begun(value: float, shape: tuple[int, int]) -> Any:
        agent = make(shape)
        agent.Q[...] = value
        return agent

    def cut_off(shape: tuple[int, int]) -> Any:
        agent = make(shape)
        return agent._replace(Q=agent.Q.view(_WholeNumbers))

    return {f"the first values are about {value:g}, and not 0": Learner(partial(begun, value)) for value in values} | {
        "what is behind the decimal point is lost: the table holds whole numbers, as one with dtype=int does": Learner(
            cut_off
        )
    }


def replay(runs: Sequence[Sequence[Step]], learner: Learner, shape: tuple[int, int], epsilon: float) -> Iterator[Row]:
    """Let new agents learn from the steps of a program, one from each run, and yield what each step was to them."""
    epsilon = 1 - epsilon if learner.swaps else epsilon
    for steps in runs:
        for agent, step in _learning(steps, learner, shape):
            best = _best(agent, step.state)
            share = (1 - epsilon) * best[step.action] / sum(best)
            yield not best[step.action], epsilon * (1 - sum(best) / len(best)), math.log(epsilon / len(best) + share)


def _learning(steps: Sequence[Step], learner: Learner, shape: tuple[int, int]) -> Iterator[tuple[Any, Step]]:
    """Let a new agent learn from the steps of a run; yield it before each, with the step as it takes it."""
    agent = learner.make(shape)
    names = learns_from(agent)
    waiting: Step | None = None
    before: Step | None = None
    for real, after in zip(steps, [*steps[1:], None], strict=True):
        restarted = real._replace(next_state=after.state) if learner.restarts and after and real.truncated else real
        step = before = learner.alter(restarted, before)
        yield agent, step
        if waiting is not None:
            learn_from(agent, names, waiting, step.action)
        waiting = None
        if learner.skips(real):
            getattr(agent, "forget_episode", bool)()  # its list of steps, if it has one
        elif "next_action" in names and not real.terminated:
            waiting = step
        else:
            learn_from(agent, names, step, step.action)


def _best(agent: Any, state: Any) -> list[bool]:
    """Which actions look best to an agent."""
    return _looks_best(agent.values(state) if hasattr(agent, "values") else agent.Q[state])


def _looks_best(row: Reals) -> list[bool]:
    values = row.tolist()
    return [tied(value, max(values)) for value in values]


def histories(steps: Sequence[Step]) -> list[tuple[Any, ...]]:
    """Return for each step of a run what came before it in its episode: O_0, A_0, O_1, ..., O_t."""
    found, history = [], tuple[Any, ...]()
    for step in steps:
        history = (*history, step.state)
        found.append(history)
        history = () if step.terminated or step.truncated else (*history, step.action)
    return found


def likeliest(replays: Sequence[Iterator[Row]], n_steps: int, highest: float) -> tuple[int, list[Row]]:
    """Return the number of the replay that makes the actions most probable, the first among equals, and its rows.

    No other is played to its end: the one that may still become the likeliest goes on (a best-first search), and most
    mistakes are soon behind.

    Args:
        replays: at least one.
        n_steps: how many steps each has.
        highest: the largest logarithm that a step can have.
    """
    rows: list[list[Row]] = [[] for _ in replays]
    queue = [(-n_steps * highest, number) for number in range(len(replays))]
    while True:
        _, number = heappop(queue)
        mine = rows[number]
        if len(mine) == n_steps:
            return number, mine
        mine += islice(replays[number], AT_ONCE)
        at_most = sum(log for _, _, log in mine) + (n_steps - len(mine)) * highest
        heappush(queue, (-at_most, number))


@dataclass(frozen=True)
class Rule:
    """The equation that a program should learn by.

    Attributes:
        right: the method.
        mistakes: the usual mistakes, by the sentence that tells of each.
        epsilon: how often the program should try a random action.
        truncates: whether episodes are truncated in the small worlds; not for a method that needs the action after the
            last.
        settings: what of the text to compare where no mistake fits.
        otherwise: what to ask then, besides.
        noisy: whether chance plays a part in the small worlds.
        worlds: in how many small worlds a program is tried.
        n_steps: how many steps it takes in each.
        world: makes one, with the arguments of `SmallWorld`.
        remembers: whether the policy that is returned is given the history of an episode, O_0, A_0, O_1, ..., O_t, in
            the place of O_t alone. The agents of the rule then have a method `row(history)`, the values at its end.
    """

    right: Learner
    mistakes: Mapping[str, Learner]
    epsilon: float
    truncates: bool = True
    settings: str = "α, γ and the first values"
    otherwise: str = ""
    noisy: bool = True
    worlds: int = 2
    n_steps: int = 2000
    world: Callable[[int, bool, bool], Environment] = SmallWorld
    remembers: bool = False

    def check(self, program: Any, seed: int, tries: float | None = None) -> None:
        """Check that the actions of a program follow from its steps by the equation.

        Args:
            program: the program.
            seed: the number from which the worlds are drawn.
            tries: its ε, if that is known from a task in which the update hardly matters.

        Raises:
            WrongAnswer: they do not; or the program breaks the contract.
        """
        seeds = range(self.worlds * seed, self.worlds * (seed + 1))
        worlds = [partial(self.world, number, self.truncates, self.noisy) for number in seeds]
        if isinstance(worlds[0](), SmallWorld):  # does it ask for the number of actions, and reset when cut short?
            run_program(program, SmallWorld(seed, n_actions=ACTIONS - 1), TRIAL, seed)
        require_reproducible(program, worlds[0], TRIAL, seed)
        done = [
            run_program(program, world(), self.n_steps, number) for number, world in zip(seeds, worlds, strict=True)
        ]
        runs = [run.steps for run in done]
        shape = shape_of(worlds[0]())
        right = Surprises.of(replay(runs, self.right, shape, self.epsilon))
        number, rows = likeliest(
            [replay(runs, learner, shape, self.epsilon) for learner in self.mistakes.values()],
            sum(map(len, runs)),
            math.log(1 - self.epsilon + self.epsilon / shape[1]),
        )
        likely, (sentence, mistake) = Surprises.of(rows), [*self.mistakes.items()][number]
        is_better = likely.explains_better_than(right, mistake.nats)
        if right.is_usual() and not is_better:
            self._require_steady_tries(runs, right)
            self._require_tries(runs, shape)
            self.require_best_actions(done[:1], shape)
            return
        swapped = Surprises.of(replay(runs, self.right._replace(swaps=True), shape, self.epsilon))
        if swapped.explains_better_than(likely) and swapped.is_usual(slack=0.0):
            late = np.concatenate([np.arange(len(steps)) >= len(steps) / 2 for steps in runs])
            cause = SWAPPED if swapped.among(late).is_usual(slack=0.0) else FALLS
        elif is_better and likely.explains_those_of(right, mistake.leaves):
            cause = f"They fit a usual mistake: {sentence}"
        else:
            first = np.concatenate([[*map(_is_over, [None, *steps[:-1]])] for steps in runs])
            only_first = right.among(~first).is_usual() and not right.among(first).is_usual()
            cause = FIRST if only_first else self._cause(right, tries)
        raise WrongAnswer(
            f"in small worlds with {right.found.size} steps, {right.found.sum():.0f} actions of {NAME} are not those"
            " that its own steps make look best by the equation of this lesson, and with ε ="
            f" {self.epsilon:g} it should be some {right.expected:.0f}. {cause}"
        )

    def _require_steady_tries(self, runs: Sequence[Sequence[Step]], right: Surprises) -> None:
        """Refuse a program whose ε falls, even if it is right on average."""
        when = np.concatenate([np.linspace(0.0, 1.0, len(steps)) for steps in runs])
        if right.lateness(when) < -SIGMAS:
            early, late = (right.among(half).found.sum() for half in (when < 0.5, when >= 0.5))
            raise WrongAnswer(
                f"in small worlds {early:.0f} actions of {NAME} are not those that its own steps make look best in the"
                f" first half of its runs, and {late:.0f} in the second. {FALLS}"
            )

    def _require_tries(self, runs: Sequence[Sequence[Step]], shape: tuple[int, int]) -> None:
        """Refuse a program that hardly ever tries one of the actions where another one looks better."""
        tries, chances = np.zeros(shape[1]), np.zeros(shape[1])
        for steps in runs:
            for agent, step in _learning(steps, self.right, shape):
                best = _best(agent, step.state)
                chances += [self.epsilon / len(best) * (not looks) for looks in best]
                tries[step.action] += not best[step.action]
        for action in np.flatnonzero((tries < RARELY * chances) & (chances > ENOUGH)):
            raise WrongAnswer(
                f"{NAME} tries the action {action} {tries[action]:.0f} times where another one looks better, and with"
                f" ε = {self.epsilon:g} it should be some {chances[action]:.0f} times: is the random action one of"
                " *all* n actions, 0 to n - 1? rng.integers(n) draws one of these"
            )

    def require_best_actions(self, runs: Sequence[Run], shape: tuple[int, int], most: float = UNEXPLAINED) -> None:
        """Refuse policies that draw their actions, or whose actions are not those that look best after all steps.

        Args:
            runs: of a program that learns by the equation, each with the policy that it returned.
            shape: of the table.
            most: in which share of the observations, or histories, they may be others.

        Raises:
            WrongAnswer: they are refused.
        """
        noun, plural, look_up = "observation", "observations", "state"
        if self.remembers:
            noun, plural, look_up = "history", "histories", "end of the history"
        other = total = 0
        for run in runs:
            ((agent, _),) = deque(_learning(run.steps, self.right, shape), maxlen=1)
            if self.remembers:
                longest = sorted(histories(run.steps), key=len)[-ASKED:]  # who looks up a whole one is found out
                asked = [(history, _looks_best(agent.row(history))) for history in longest]
            else:
                asked = [(step.state, _best(agent, step.state)) for step in run.steps[-ASKED:]]
            clear = [(question, best.index(True)) for question, best in asked if sum(best) == 1]
            found = actions_of(run.policy, [question for question, _ in clear], shape[1], noun)
            other += sum(action != best for action, (_, best) in zip(found, clear, strict=True))
            total += len(clear)
        if other > most * total:
            raise WrongAnswer(
                f"in {other} of {total} {plural} {POLICY} takes another action than the one"
                f" that the steps of the program make look best: does this policy look up the {look_up} that it is"
                " given, and take the *best* action?"
            )

    def _cause(self, right: Surprises, tries: float | None) -> str:
        """Return the likely cause of surprises that no usual mistake explains."""
        found, by_chance = float(right.found.sum()), right.expected / self.epsilon
        if found < right.expected:
            return "So it seldom tries an action at random: is ε that of the text, up to the last step?"
        if found > 1.1 * by_chance:
            return f"The likely cause: {LOW}"
        if found > 0.9 * by_chance:
            return (
                "So many come from chance alone, or from a table that never changes: are the actions chosen by the"
                " values, with probability 1 − ε, and does the update change these values?"
            )
        is_known = tries is not None and abs(tries / self.epsilon - 1) <= SLACK
        unknown = f"If all else is right, ε is about {found / by_chance:.2f}. If ε is right, compare"
        return (
            f"{'ε is right, so compare' if is_known else unknown} {self.settings} with those of the text, and the"
            f" update with its equation, term by term{self.otherwise}"
        )
