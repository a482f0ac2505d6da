"""The methods of lesson 9 and their settings, and how they are compared."""

import re
from collections.abc import Callable, Mapping
from functools import cache, partial
from typing import Annotated, Any, NamedTuple

import gymnasium
import numpy as np

from edugym.agents.dyna_q import DynaQ
from edugym.agents.prioritised_sweeping import PrioritisedSweeping
from edugym.agents.q_learning import QLearning
from edugym.agents.r_max import RMax
from edugym.agents.settings import Table, new
from edugym.agents.strategies import LinearDecay, ScheduledEpsilonGreedy
from edugym.envs.supermarket import Supermarket
from edugym.exact.model import finite_model
from edugym.exact.tables import FiniteModel
from edugym.experiments.repeat import repeat
from edugym.experiments.results.tables import Results
from edugym.mdp.protocol import Integers, Random

N_STEPS = 10_000
POINTS = 40
EARLY = 2_000
"""The steps in which planning has its lead; after them R-max is done."""
REPETITIONS = 60
DISCOUNT = 0.99
PLANNING_DISCOUNT = 0.95
"""The discount with a given model."""
LEARNING_RATE = 1.0
EPSILON = 0.1
OPTIMUM = 95.0
LOST = -300.0
"""A policy that ends returns more, since it visits no state twice."""
NOISES = (0.0, 0.25, 0.5, 1.0, 1.5)
WRONG = 1.5
"""The noise of the model with which agents learn."""

Q_LEARNING, DYNA_10, DYNA_50, SWEEPING, R_MAX = "Q-learning", "Dyna-10", "Dyna-50", "prioritised sweeping", "R-max"
MORE_RANDOM, DECAYING = "Dyna-10, ε = 0.5", "Dyna-10, ε from 1 to 0.02"


Maker = Callable[..., Any]


def make(
    kind: Any,
    environment: Any,
    *,
    epsilon: tuple[float, float] = (EPSILON, EPSILON),
    given: bool = False,
    learning_rate: float = LEARNING_RATE,
    **settings: Any,
) -> Any:
    """Make an ε-greedy agent for an environment.

    Args:
        kind: its class.
        environment: the environment.
        epsilon: ε at the start and at the end of training. (A constant ε is a schedule too: that spares the compiler
            another agent.)
        given: whether it gets the model of the environment, errors included, in place of learning one.
        learning_rate: α.
        **settings: more settings of the agent, such as another discount.
    """
    exploration = ScheduledEpsilonGreedy.create(LinearDecay(*epsilon, N_STEPS))
    model = {"model": environment.unwrapped.mdp.distorted(exact_model())} if given else {}
    discount = PLANNING_DISCOUNT if given else DISCOUNT
    how: dict[str, Any] = {"exploration": exploration, "learning_rate": learning_rate, "discount": discount}
    return kind.create(environment, **{**how, **model, **settings})


LEARNED: Mapping[str, Maker] = {
    Q_LEARNING: partial(make, QLearning),
    DYNA_10: partial(make, DynaQ, planning_steps=10),
    DYNA_50: partial(make, DynaQ, planning_steps=50),
    SWEEPING: partial(make, PrioritisedSweeping, planning_steps=10),
    R_MAX: partial(RMax.create, discount=DISCOUNT),
}
REMEDIES: Mapping[str, Maker] = {
    MORE_RANDOM: partial(make, DynaQ, planning_steps=10, epsilon=(0.5, 0.5)),
    DECAYING: partial(make, DynaQ, planning_steps=10, epsilon=(1.0, 0.02)),
}
SLOW_DYNA = "Dyna-10, α = 0.1"
GIVEN: Mapping[str, Maker] = {
    SWEEPING: partial(make, PrioritisedSweeping, given=True, planning_steps=1_000),
    DYNA_10: partial(make, DynaQ, given=True, planning_steps=10),
    SLOW_DYNA: partial(make, DynaQ, given=True, planning_steps=10, learning_rate=0.1),
}
"""Agents with a given model: sweeping looks at all that can happen (descriptive), Dyna draws samples (generative)."""


@cache
def exact_model() -> FiniteModel:
    """Return the exact model of the supermarket, which all layouts share."""
    return finite_model(Supermarket.create())


def compare(methods: Mapping[str, Any], *, noise: float = 0.0, n_steps: int = N_STEPS, **how: Any) -> Results:
    """Train several methods: one panel of the figure.

    Args:
        methods: by label, functions that make an agent for an environment.
        noise: the standard deviation of the errors in the rewards of a given model.
        n_steps: the training steps of each run.
        **how: more arguments of `edugym.experiments.repeat`, such as `repetitions`, `seed` and `jobs`.
    """
    every = max(n_steps // POINTS, 1)
    return repeat("Supermarket", methods, n_steps, parameters={"noise": noise}, evaluate_every=every, **how)


def compare_planners(n: int, epsilon: float, learning_rate: float, discount: float, **how: Any) -> Results:
    """Train Q-learning, and Dyna and prioritised sweeping with n updates a step.

    Args:
        n: the updates of a step.
        epsilon: ε of all three.
        learning_rate: α of all three.
        discount: γ of all three.
        **how: more arguments of `compare`.
    """
    settings: dict[str, Any] = {
        "epsilon": (epsilon, epsilon),
        "learning_rate": learning_rate,
        "discount": discount,
    }
    methods = {
        Q_LEARNING: partial(make, QLearning, **settings),
        f"Dyna-{n}": partial(make, DynaQ, planning_steps=n, **settings),
        SWEEPING: partial(make, PrioritisedSweeping, planning_steps=n, **settings),
    }
    return compare(methods, **how)


def with_right_model(makers: Mapping[str, Callable[[Any], Any]]) -> dict[str, Any]:
    """Make agents with the right model, once for all repetitions, of which each gets a copy."""
    environment = gymnasium.make("edugym/Supermarket-v0")
    return {label: maker(environment) for label, maker in makers.items()}


class CountingSweeping(NamedTuple):
    """Prioritised sweeping, with a count of its work. It learns and acts as `PrioritisedSweeping` does.

    Attributes:
        sweeping: the agent, whose budget is one update: it is asked n times.
        targets: shape (1, steps + 1): how many targets each step computed, for an update or for a priority alone; the
            last place holds the number of the step.
        planning_steps: n.
    """

    sweeping: PrioritisedSweeping
    targets: Annotated[Integers, Table((1, "places"))]
    planning_steps: int

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool) -> None:
        """Let it learn, which computes one target: a priority."""
        self.sweeping.learn(state, action, reward, next_state, terminated)
        self.targets[0, self.targets[0, -1]] += 1
        self.targets[0, -1] += 1

    def act(self, state: int, rng: Random) -> int:
        """Let it plan update by update: each computes a target, and one for each outcome that leads to the state."""
        for _ in range(self.planning_steps):
            if self.sweeping.queue.size[0] > 0:
                computed = 1
                outcome = self.sweeping.model.first_into[self.sweeping.queue.items[1] // self.sweeping.Q.shape[1]]
                while outcome >= 0:
                    computed += 1
                    outcome = self.sweeping.model.following_into[outcome]
                self.targets[0, self.targets[0, -1]] += computed
                self.sweeping.plan(rng)
        return self.sweeping.exploration.choose(self.sweeping.Q, state, rng)

    def greedy(self, state: int, rng: Random) -> int:
        """The action with the highest value."""
        return self.sweeping.greedy(state, rng)

    @classmethod
    def create(cls, environment: Any, n_steps: int, planning_steps: int = 10) -> "CountingSweeping":
        """A new agent with the settings of the lesson, for so many steps."""
        sweeping = make(PrioritisedSweeping, environment, planning_steps=1)
        settings = {"planning_steps": planning_steps}
        return new(cls, environment, settings, {"sweeping": sweeping}, places=n_steps + 1)


def targets_computed(results: Results) -> dict[str, Integers]:
    """Return by method how many targets each step computed: shape (n_repetitions, n_steps), or (1, n_steps).

    Q-learning computes one, and Dyna-n computes n more. Prioritised sweeping computes them for priorities too, and
    does nothing while its queue is empty: the same runs are trained again, and counted.

    Args:
        results: what `compare` returned for methods of the lesson, with its seed.
    """
    counted = dict[str, Integers]()
    for method in results.methods:
        curves = results.curves(method)
        n_steps = int(curves.index[-1])
        if method == SWEEPING:
            makers = {method: partial(CountingSweeping.create, n_steps=n_steps)}
            again = compare(makers, n_steps=n_steps, repetitions=curves.shape[1])
            counted[method] = np.array([agent.targets[0, :-1] for agent in again.complete_agents(method).values()])
        else:
            dyna = re.fullmatch(r"Dyna-(\d+)", method)
            counted[method] = np.full((1, n_steps), 1 + int(dyna[1]) if dyna else 1)
    return counted
