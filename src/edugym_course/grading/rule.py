"""The equation that a program should learn by, and how a program that learns by another one is told."""

import math
from collections import deque
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import gymnasium
import numpy as np

from edugym.mdp.protocol import Reals
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.learners import LOW, Learner
from edugym_course.grading.programs import (
    NAME,
    POLICY,
    Environment,
    Run,
    Step,
    actions_of,
    begins,
    require_varied_starts,
    run_program,
    shape_of,
)
from edugym_course.grading.repeats import require_reproducible
from edugym_course.grading.replay import best_of, histories, learning, looks_best, replay
from edugym_course.grading.small_world import ACTIONS, SmallWorld
from edugym_course.grading.surprises import (
    BOTH,
    NATS,
    NEAR,
    OTHERS,
    SIGMAS,
    SLACK,
    UNEXPLAINED,
    Surprises,
    likeliest,
    refusal,
    usual_refusal,
)

TRIAL = 300
"""The steps of the runs that must repeat each other."""
ASKED = 200
"""How many observations a policy is asked about."""
RARELY, SELDOM, BY_CHANCE, ENOUGH = 0.25, 0.75, 5.0, 30
"""The shares of its chances below which an action is hardly tried, and tried too seldom if that is so many standard
deviations below them; and how many chances are enough to tell."""
MANY_ACTIONS, EVEN_STEPS, UNEVEN = 7, 8_000, 35.0
"""The actions of a world in which random ones are counted, and the steps there; and how large χ², with six degrees of
freedom, may be: by chance it is larger once in 200 000 times."""
WAITING = 3
"""So many of the last steps may wait for an action that nobody takes any more. A program may have learned from them."""
OTHERWISE = 0.05
"""In which share of the observations a policy may take another action than the best one. No right program does so in
any, but one that computes with fewer digits may."""
FURTHER, LONGER = 500_000, 2
"""How far the seeds of the second look are from those of the first; how many times longer each of its runs is."""
SWAPPED = (
    "An action that looks best is as rare as a random one should be: have ε and 1 − ε changed places, or does the"
    " update move another value than Q(S, A), that of the action taken in the state that was left?"
)
COST, MANY_BELOW_0 = 10.0, 0.2
"""So much less does each step bring in the world in which all values are below 0, before its rewards become so many
times smaller, so that few are whole numbers; and how many actions of a policy may not be the best ones there. With
γ = 0.97 for 0.99 it was 8 %, and 39 % in a search from 0."""
FALLS = "Their share falls during a run: ε should be the same from the first step to the last, and rng made once"
GROWS = (
    "Their share grows during a run: ε should be the same from the first step to the last, and rng made once; or does"
    " a small mistake build up, such as a truncated end that is learned as a terminated one?"
)
TOO_SELDOM = "So it seldom tries an action at random: is ε that of the text to the last step, and rng made once?"
NEVER_FIRST = "These are the first actions of episodes: an action after a reset is drawn by ε-greedy, too"
ONCE = "They come together, in few episodes: draw anew in each step whether its action is random, not once an episode"
MANY = 1.5
"""How many times the expected number there may be then, by chance. If there are more, something else is wrong too."""
LATE = 5.0
"""How many standard deviations too late they may come. By chance it is 0.9 on average: two actions that looked alike to
a program, and do not to our agent, are rare at the beginning. Of 99 runs of right programs, 2.5 was the most."""
MANY_OF_CHANCE = 0.4
"""From which share of those of chance alone the state itself may be another one."""
ELSEWHERE = (
    "Is each action chosen in the state that step() or reset() gave last? A loop inside the loop may have used its"
    " name."
)
FIRST = (
    "It is so in the first step of episodes, and not in the others: after a reset, choose the action anew, in the state"
    " that reset() gives; and does the program learn from the first step of an episode as from the others, and where"
    " `terminated` is True from R alone?"
)


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
        slack: the share by which a right program may try more often than ε says; more where other tasks, which come
            later, tell better what is amiss.
        looks_closer: whether a program takes longer runs too, and may not take the second best action too often. Off
            where that takes long, or where other tasks come first, which tell better what is amiss (`look_closer`).
        costs: whether a policy is asked in a world in which all values are below 0, too.
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
    slack: float = SLACK
    looks_closer: bool = True
    costs: bool = True

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
        is_small = isinstance(self._world(seeds[0]), SmallWorld)
        if is_small:  # does it ask for the number of actions, and reset?
            run_program(program, SmallWorld(seed, n_actions=ACTIONS - 1), TRIAL, seed)
        require_reproducible(program, partial(self._world, seeds[0]), TRIAL, seed)
        shape = shape_of(self._world(seeds[0]))
        done = [run_program(program, self._world(number), self.n_steps, number) for number in seeds]
        runs = [run.steps for run in done]
        number, _ = likeliest(
            [replay(runs, learner, shape, self.epsilon) for learner in self.mistakes.values()],
            sum(map(len, runs)),
            math.log(1 - self.epsilon + self.epsilon / shape[1]),
        )
        runs += self._longer_runs(program, seed) if self.looks_closer else []
        self._require_equation(runs, shape, [*self.mistakes.items()][number], tries)
        self.require_best_actions(done[:1], shape)
        if is_small:
            self._require_even_tries(program, seed)
        if self.costs:
            costly: Any = gymnasium.wrappers.TransformReward(
                self._world(seeds[0]), lambda reward: (float(reward) - COST) / COST
            )
            self.require_best_actions([run_program(program, costly, self.n_steps, seeds[0])], shape, below_0=True)

    def look_closer(self, program: Any, seed: int, tries: float | None = None, longer: int = LONGER) -> None:
        """Check a program that has passed `check` and all else: longer runs show what differs by little.

        Args:
            program: the program.
            seed: the number from which the worlds are drawn.
            tries: its ε, as for `check`.
            longer: how many times longer than in `check` each run is.

        Raises:
            WrongAnswer: too many of its actions do not follow from its steps, or too many are the second best.
        """
        runs = self._longer_runs(program, seed, longer)
        right = Surprises.of(replay(runs, self.right, shape_of(self._world(0)), self.epsilon))
        if not (right.is_usual() and right.are_drawn()):
            raise refusal("small worlds", self.epsilon, right, replace(self, looks_closer=True)._cause(right, tries))
        self._require_steady_tries(runs, right, grows=True)

    def _longer_runs(self, program: Any, seed: int, longer: int = LONGER) -> list[Sequence[Step]]:
        """Run a program longer, in other worlds."""
        numbers = range(FURTHER + self.worlds * seed, FURTHER + self.worlds * (seed + 1))
        return [run_program(program, self._world(one), longer * self.n_steps, one).steps for one in numbers]

    def _world(self, number: int) -> Environment:
        return self.world(number, self.truncates, self.noisy)

    def _require_equation(
        self, runs: Sequence[Sequence[Step]], shape: tuple[int, int], usual: tuple[str, Learner], tries: float | None
    ) -> None:
        """Refuse a program with too many surprises, or such as the likeliest of the usual mistakes explains better."""
        sentence, mistake = usual
        if len({step.action for steps in runs for step in steps}) < shape[1]:
            self._require_tries(runs, shape)
        right = Surprises.of(replay(runs, self.right, shape, self.epsilon))
        likely = Surprises.of(replay(runs, mistake, shape, self.epsilon))
        is_better = likely.explains_better_than(right, mistake.nats)
        first = np.concatenate([begins(steps) for steps in runs])
        if right.among(~first).is_usual(NEAR):
            require_varied_starts(runs)
        late = np.concatenate([np.arange(len(steps)) >= len(steps) / 2 for steps in runs])
        together, alone = right.among(late).once_an_episode(np.cumsum(first)[late], self.epsilon, shape[1])
        is_clear = together > max(alone, float(likely.logs[late].sum())) + NATS
        if is_clear and right.too_many < MANY * right.expected and right.are_drawn():
            raise refusal("small worlds", self.epsilon, right, ONCE)
        if not is_better and (right.is_usual(NEAR) or right.too_many < 0):
            self._require_steady_tries(runs, right)
        if not is_better and right.is_usual(NEAR):
            self._require_tries(runs, shape)
            begun = right.among(first)
            if self.looks_closer and begun.too_many < -SIGMAS * begun.deviation:
                raise refusal(
                    "small worlds",
                    self.epsilon,
                    begun,
                    NEVER_FIRST if begun.found.sum() < begun.expected / 2 else TOO_SELDOM,
                )
            if self._are_drawn(right):
                self._require_steady_tries(runs, right, grows=True)
                if right.is_usual(self.slack):
                    return
        swapped = Surprises.of(replay(runs, self.right._replace(swaps=True), shape, self.epsilon))
        by_chance = -swapped.found.size * math.log(shape[1])
        is_swapped = swapped.explains_better_than(likely) and float(swapped.logs.sum()) > by_chance + NATS
        if is_swapped and swapped.is_usual(slack=0.0):
            cause = SWAPPED if swapped.among(late).is_usual(slack=0.0) else FALLS
        elif right.too_many < -SIGMAS * right.deviation:  # a wrong equation makes more, and not fewer
            cause = TOO_SELDOM
        elif is_better and likely.explains_those_of(right, mistake.leaves) and self._resembles(likely, mistake):
            raise usual_refusal("small worlds", self.epsilon, right, sentence)
        else:
            others = right.among(~first)
            only_first = others.is_usual(NEAR) and others.are_drawn() and not right.among(first).is_usual(NEAR)
            cause = FIRST if only_first else self._cause(right, tries)
        raise refusal("small worlds", self.epsilon, right, cause)

    def _are_drawn(self, right: Surprises) -> bool:
        return right.are_drawn() or not self.looks_closer

    def _resembles(self, likely: Surprises, mistake: Learner) -> bool:
        """Whether what a mistake leaves is drawn by chance, if it should leave nothing else."""
        return likely.are_drawn(BOTH) or mistake.leaves > UNEXPLAINED or not self.looks_closer

    def _require_steady_tries(self, runs: Sequence[Sequence[Step]], right: Surprises, grows: bool = False) -> None:
        """Refuse a program whose ε falls, or one whose ε `grows`, even if it is right on average."""
        when = np.concatenate([np.linspace(0.0, 1.0, len(steps)) for steps in runs])
        early = -right.lateness(when)
        falls = early > SIGMAS or min(early, -right.too_many / right.deviation) > BOTH
        if -early > LATE if grows else falls:
            first, second = (right.among(half).found.sum() for half in (when < 0.5, when >= 0.5))
            raise WrongAnswer(
                f"in small worlds {first:.0f} actions of {NAME} are not greedy in the first half"
                f" of its runs, and {second:.0f} in the second. {GROWS if grows else FALLS}"
            )

    def _require_tries(self, runs: Sequence[Sequence[Step]], shape: tuple[int, int]) -> None:
        """Refuse a program that hardly ever tries one of the actions where another one looks better."""
        tries, chances = self._tries(runs, shape)
        seldom = (tries < SELDOM * chances) & (tries < chances - BY_CHANCE * np.sqrt(chances))
        few = (tries < RARELY * chances) | seldom
        for action in np.flatnonzero(few & (chances > ENOUGH)):
            raise WrongAnswer(
                f"{NAME} tries action {action} only {tries[action]:.0f} times where another one looks better, and with"
                f" ε = {self.epsilon:g} it should be some {chances[action]:.0f} times: is the random action one of"
                " *all* n actions, 0 to n - 1, and each as likely? rng.integers(n) draws so"
            )

    def _tries(self, runs: Sequence[Sequence[Step]], shape: tuple[int, int]) -> tuple[Reals, Reals]:
        """Return how often each action was tried where another one looked better, and how often it should be."""
        tries, chances = np.zeros(shape[1]), np.zeros(shape[1])
        for steps in runs:
            for agent, step in learning(steps, self.right, shape):
                best = best_of(agent, step.state)
                chances += [self.epsilon / len(best) * (not looks) for looks in best]
                tries[step.action] += not best[step.action]
        return tries, chances

    def _require_even_tries(self, program: Any, seed: int) -> None:
        """Refuse a program some of whose random actions are likelier than others, where there are many actions."""
        world = SmallWorld(seed, self.truncates, self.noisy, MANY_ACTIONS)
        tries, chances = self._tries([run_program(program, world, EVEN_STEPS, seed).steps], shape_of(world))
        expected = chances * tries.sum() / chances.sum()
        off = (tries - expected) ** 2 / expected
        if off.sum() > UNEVEN:
            action = int(off.argmax())
            raise WrongAnswer(
                f"of {MANY_ACTIONS} actions {NAME} tries action {action} {tries[action]:.0f} times where another one"
                f" looks better, and by the number of all such tries it should be some {expected[action]:.0f}: a random"
                " action is one of all n, each as likely. rng.integers(n) draws so"
            )

    def require_best_actions(
        self, runs: Sequence[Run], shape: tuple[int, int], most: float = OTHERWISE, below_0: bool = False
    ) -> None:
        """Refuse policies that draw their actions, or whose actions are not those that look best after all steps.

        Args:
            runs: of a program that learns by the equation, each with the policy that it returned.
            shape: of the table.
            most: in which share of the observations, or histories, they may be others.
            below_0: whether all values are below 0. Then much more may differ, for there small mistakes in the equation
                show, of which others tell better.

        Raises:
            WrongAnswer: they are refused.
        """
        noun, plural, look_up = "observation", "observations", "look up the state that it is given"
        if self.remembers:
            noun, plural = "history", "histories"
            look_up = "look up the end of the history that it is given, and a short one as your program does itself"
        other = total = 0
        taken = set[int]()
        for run in runs:
            ((agent, _),) = deque(learning(run.steps, self.right, shape), maxlen=1)
            if self.remembers:
                by_length = sorted(histories(run.steps), key=len)  # who looks up a whole one is found out
                some = by_length[:ASKED] + by_length[-ASKED:]
                asked = [(history, looks_best(agent.row(history).tolist())) for history in some]
            else:
                late = run.steps[-ASKED:]
                waiting = [] if self.truncates else [step.state for step in run.steps[-WAITING:]]
                states = [step.state for step in late if all(step.state != state for state in waiting)]
                asked = [(state, best_of(agent, state)) for state in states]
            clear = [(question, best.index(True)) for question, best in asked if sum(best) == 1]
            found = actions_of(run.policy, [question for question, _ in clear], shape[1], noun)
            other += sum(action != best for action, (_, best) in zip(found, clear, strict=True))
            total += len(clear)
            taken |= {*found}
        if other > (MANY_BELOW_0 if below_0 else most) * total:
            cause = f"does this policy {look_up}, and take the *best* action, by values learned from all steps?"
            if below_0 and len(taken) == 1:
                cause = (
                    "it is always the same one. Does a search for the highest value begin at 0? Begin it at −∞, or take"
                    " `max`"
                )
            elif below_0:
                cause = (
                    "does a search for the highest value begin at 0, in a target? Begin it at −∞, or take `max`. Or"
                    " does a reward lose what is behind its decimal point, as by `int(reward)`? Small mistakes in a"
                    f" number show most there, too, so compare {self.settings}"
                )
            raise WrongAnswer(
                f"{'where all values are below 0, ' * below_0}in {other} of {total} {plural} {POLICY} takes another"
                f" action than the one that the steps of the program make look best: {cause}"
            )

    def _cause(self, right: Surprises, tries: float | None) -> str:
        """Return the likely cause of surprises that no usual mistake explains."""
        found, by_chance = float(right.found.sum()), right.expected / self.epsilon
        if found > 1.1 * by_chance:
            return f"The likely cause: {LOW}"
        if found > 0.9 * by_chance:
            return (
                "So many come from chance alone, or from a table that never changes or is made anew in each episode:"
                " are the actions chosen by the values, with probability 1 − ε, and does the update change that of the"
                " action taken, and no other, by the TD error?"
            )
        compare = (
            f"{self.settings} with those of the text, and the update with its equation, term by term{self.otherwise}"
        )
        if not self._are_drawn(right):
            return (
                "Too many of them are the second best action, so chance did not draw them: the equation is another one,"
                f" or a number in it. Compare {compare}"
            )
        if found < right.expected:
            return TOO_SELDOM
        is_known = tries is not None and abs(tries / self.epsilon - 1) <= NEAR
        if_others = self.epsilon * np.count_nonzero(right.chances)
        is_other = abs(found - if_others) < SIGMAS * right.deviation
        if is_known:
            return f"ε is right, so compare {compare}"
        if is_other and right.are_drawn():
            return (
                f"Is ε about {found / by_chance:.2f}, or is the random action drawn among the others? ({OTHERS}) If"
                f" neither is so, compare {compare}"
            )
        wild = f" {ELSEWHERE}" if found > MANY_OF_CHANCE * by_chance else ""
        if wild and not right.are_drawn():
            return f"Compare {compare}.{wild}"
        return f"Compare {compare}.{wild} If all that is right, ε is about {found / by_chance:.2f}"
