"""One call that takes any finite problem through everything: check, size, picture, optimum, agents, comparison."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from edugym.adapters.gymnasium_env import MDPEnv
from edugym.exact.values import Values
from edugym.experiments.figures.sheet import Sheet
from edugym.experiments.results.statistics import mean_interval
from edugym.experiments.results.tables import Results
from edugym.mdp.protocol import Reals
from edugym.mdp.task import check_mdp, task_of
from edugym_course.lessons.own_problem.exact import in_words, random_return, solve
from edugym_course.lessons.own_problem.figures import PolicyMap, can_be_drawn, names_of, race
from edugym_course.lessons.own_problem.methods import Maker, learn, methods_with, true_returns

FEW = ("Q-learning", "SARSA", "Dyna-10")
"""The agents for a new problem; each must be compiled for it, which takes some seconds."""


@dataclass(frozen=True, repr=False)
class Tour:
    """What was found out about a problem. In a notebook `print` shows the words, and `sheets` the figures.

    Attributes:
        mdp: the problem.
        values: the optimum, by planning on the exact model.
        random: the expected return of random actions.
        results: the learning curves.
        learned: by label of the agent, what each run's policy is worth, exactly.
    """

    mdp: Any
    values: Values
    random: float
    results: Results
    learned: Mapping[str, Reals]

    @property
    def picture(self) -> Any:
        """The picture of the first state."""
        return MDPEnv(self.mdp).scene()

    @property
    def sheets(self) -> list[Sheet]:
        """The best policy, where it can be drawn, and the comparison of the agents."""
        drawn = can_be_drawn(self.values)
        title = "the best policy" if task_of(self.mdp).max_steps is None else "the best first action"
        maps = [Sheet("policy", [[PolicyMap(self.values, names_of(self.mdp), title)]])] if drawn else []
        return [*maps, race(self.results, self.learned, self.values.start, self.random)]

    def __str__(self) -> str:
        """Return all of it in words."""
        model = self.values.model
        chance = ((model.probabilities > 0).sum(axis=2) > 1).any()
        names = names_of(self.mdp)
        lines = [
            "Checked: 200 random steps of it are as they must be.",
            f"States: {len(model.states)}, of which {int(model.terminal.sum())} are terminal. Actions:"
            f" {', '.join(names)}.",
            "The dynamics are " + ("random." if chance else "not random."),
            f"Expected return of random actions: {self.random:.4g}. Optimum: {self.values.start:.4g}.",
            "The best action in each state" + (", at the first step:" if task_of(self.mdp).max_steps else ":"),
            in_words(self.values, dict(enumerate(names)), most=30),
            "What the agents' policies are worth in the end (mean over runs, 95 % interval):",
            *(f"{label:>12}: {mean_interval(values)}" for label, values in self.learned.items()),
        ]
        return "\n".join(lines + warnings_about(self))


def warnings_about(tour: Tour) -> list[str]:
    """Return sentences on what makes a problem too easy, or no problem."""
    values, found = tour.values, []
    if values.start - tour.random < 0.05 * max(1.0, abs(values.start)):
        found.append(
            "Look again: the best policy earns hardly more than random actions, so there is nothing to learn. (Does it"
            " matter how long it takes? The discount is 1.)"
        )
    policy = values.greedy_policy()[~values.model.terminal]
    if (policy > 0).all(axis=0).any():
        found.append("Look again: one action is best in every state, so there is nothing to decide.")
    if any(
        mean_interval(learned).estimate < values.start - 0.3 * (values.start - tour.random)
        for learned in tour.learned.values()
    ):
        found.append("An agent is far from the optimum: is a variable missing in its observation, or time to learn?")
    return found


def take_through_everything(
    mdp: Any, *, methods: Mapping[str, Maker] | None = None, n_steps: int = 10_000, repetitions: int = 10, seed: int = 0
) -> Tour:
    """Check a problem, solve it exactly, let agents learn it, and compare them with the optimum and random actions.

    Args:
        mdp: the problem: a finite MDP whose observations are whole numbers.
        methods: by label, functions that make the agents; by default Q-learning, SARSA and Dyna-10 (discount 1,
            learning rate 0.1, ε = 0.1).
        n_steps: the training steps of each run.
        repetitions: the runs of each agent.
        seed: the number from which all seeds are spawned.

    Raises:
        ValueError: the problem is not as it must be; the sentence says what is wrong.
    """
    check_mdp(mdp)
    values = solve(mdp)
    makers = {label: methods_with()[label] for label in FEW} if methods is None else methods
    results = learn(mdp, makers, n_steps, repetitions=repetitions, seed=seed)
    learned = {label: true_returns(results, label, mdp) for label in makers}
    return Tour(mdp, values, random_return(mdp, task_of(mdp).max_steps), results, learned)
