"""What the answers to the exercises make possible: the policies under a student's shaping, and a hidden count."""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from gymnasium import spaces

from edugym.exact.model import finite_model
from edugym.exact.policy_evaluation import policy_evaluation
from edugym.exact.value_iteration import value_iteration
from edugym.experiments.figures.sheet import Sheet
from edugym.experiments.results.tables import joined
from edugym.mdp.protocol import Random
from edugym.mdp.wrapper import wrapper
from edugym_course.lessons.own_problem.bedroom import SLEEP, clock
from edugym_course.lessons.own_problem.exact import DISCOUNT, best_policy, random_return, solve
from edugym_course.lessons.own_problem.figures import PolicyMap, names_of, race
from edugym_course.lessons.own_problem.methods import learn, methods_with, true_returns
from edugym_course.lessons.own_problem.morning import Morning


def shaped_policies(shaped_reward: Callable[..., float], seed: int = 0) -> Sheet:
    """Return the best policies of the morning without and with a shaping whose potential was drawn at random.

    Args:
        shaped_reward: the reward with shaping, a function of the reward, the potential, the state, the next state,
            whether that is terminal, and the discount.
        seed: from which the potential of each state is drawn, from 0 to 20.
    """
    mdp = Morning()
    model = finite_model(mdp)
    phi = dict(zip(model.states, np.random.default_rng(seed).uniform(0.0, 20.0, len(model.states)), strict=True))
    rewards = model.rewards.copy()
    for s, a, k in np.argwhere((model.probabilities > 0) & ~model.terminal[:, np.newaxis, np.newaxis]).tolist():
        n = model.successors[s, a, k]
        rewards[s, a, k] = shaped_reward(
            float(model.rewards[s, a, k]),
            phi.__getitem__,
            model.states[s],
            model.states[n],
            bool(model.terminal[n]),
            DISCOUNT,
        )
    times = [clock(time, mdp.length) for time in range(mdp.length)]
    panels = [
        PolicyMap(value_iteration(one, DISCOUNT), names_of(mdp), title, "time", "", times, SLEEP)
        for one, title in ((model, "what I meant"), (model._replace(rewards=rewards), "with a random potential"))
    ]
    return Sheet("shaped", [panels])


@wrapper
class HidesLast(NamedTuple):
    """A problem whose agent does not see the last number of the state.

    Attributes:
        mdp: the problem, which observes several whole numbers.
    """

    mdp: Any

    @property
    def observation_space(self) -> spaces.MultiDiscrete:
        """All numbers but the last."""
        return spaces.MultiDiscrete([int(n) for n in self.mdp.observation_space.nvec[:-1]])

    def observation(self, state: Any, rng: Random) -> tuple[int, int]:
        """Return the first two numbers."""
        return state[0], state[1]


def count_matters(kind: Callable[[], Any], repetitions: int = 20, n_steps: int = 20_000) -> Sheet:
    """Let Q-learning learn a problem whose state is (time, depth, chimes), with and without a look at the chimes.

    The figure also has the clock that was best for a sleeper who hears all chimes.
    """
    mdp = kind()
    method = methods_with()["Q-learning"]
    seen = learn(mdp, {"sees the chimes": method}, n_steps, repetitions=repetitions)
    hidden = learn(HidesLast(mdp), {"does not see them": method}, n_steps, repetitions=repetitions)
    learned = {
        "sees the chimes": true_returns(seen, "sees the chimes", mdp),
        "does not see them": true_returns(hidden, "does not see them", HidesLast(mdp)),
        "the old clock": np.full(repetitions, old_clock(mdp)),
    }
    optimum = solve(mdp).start
    title = f"optimum {optimum:.1f}, the old clock {old_clock(mdp):.1f}"
    return race(joined([seen, hidden]), learned, optimum, random_return(mdp), title)


def old_clock(mdp: Any) -> float:
    """Return what the best policy of `Morning` is worth for a sleeper who hears only some chimes."""
    policy, rows = best_policy(Morning()), finite_model(Morning()).rows
    model = finite_model(mdp)
    return policy_evaluation(model, np.array([policy[rows[state[:2]]] for state in model.states]), DISCOUNT).start
