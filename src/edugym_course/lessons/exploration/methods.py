"""The methods of lesson 1 and their settings, and how they are compared on walls of one kind."""

from collections.abc import Callable, Mapping
from functools import partial
from types import MappingProxyType
from typing import Any

from edugym.adapters.registration import make_mdp
from edugym.agents.count_based import CountBased
from edugym.agents.go_explore import GoExplore
from edugym.agents.q_learning import QLearning
from edugym.agents.strategies import EpsilonGreedy
from edugym.exact.model import finite_model
from edugym.exact.value_iteration import value_iteration
from edugym.experiments.repeat import repeat
from edugym.experiments.results.tables import Results
from edugym.mdp.protocol import Integers
from edugym.training.visits import record_visits

HEIGHTS = (10, 30, 100)
N_STEPS = 20_000
REPETITIONS = 30
DISCOUNT = 0.9
LEARNING_RATE = 0.5
EPSILON = 0.1
BONUS = 1.0
EXPLORE_STEPS = 20
SLIP = EPSILON / 2
"""The probability that an ε-greedy climber takes the wrong one of two grips although it knows the right one."""

EPSILON_GREEDY, NOVELTY, GO_EXPLORE, OPTIMISM = "ε-greedy", "novelty reward", "Go-Explore", "optimism"

Maker = Callable[..., Any]


def paper_methods(
    epsilon: float = EPSILON,
    bonus: float = BONUS,
    discount: float = DISCOUNT,
    learning_rate: float = LEARNING_RATE,
    initial_value: float = 0.0,
) -> dict[str, Maker]:
    """Return the three methods of the paper, by label: functions that make an agent for an environment.

    Args:
        epsilon: ε of ε-greedy and of the novelty reward; Go-Explore does not use it.
        bonus: β, the first bonus of the novelty reward.
        discount: γ of all three.
        learning_rate: α of all three.
        initial_value: the value of every action at first, of ε-greedy and of the novelty reward.
    """
    learning: dict[str, Any] = {"learning_rate": learning_rate, "discount": discount}
    slips: dict[str, Any] = {**learning, "exploration": EpsilonGreedy(epsilon), "initial_value": initial_value}
    return {
        EPSILON_GREEDY: partial(QLearning.create, **slips),
        NOVELTY: partial(CountBased.create, bonus=bonus, **slips),
        GO_EXPLORE: partial(GoExplore.create, explore_steps=EXPLORE_STEPS, **learning),
    }


METHODS: Mapping[str, Maker] = MappingProxyType(paper_methods())


def optimist(
    environment: Any, learning_rate: float = 1.0, discount: float = DISCOUNT, initial_value: float = 1.0
) -> QLearning:
    """Return greedy Q-learning with all values at 1: what it has not tried looks best."""
    return QLearning.create(
        environment,
        learning_rate=learning_rate,
        discount=discount,
        exploration=EpsilonGreedy(0.0),
        initial_value=initial_value,
    )


OPTIMIST: Maker = optimist


def compare(
    height: int,
    *,
    methods: Mapping[str, Maker] = METHODS,
    n_grips: int = 2,
    n_steps: int = N_STEPS,
    repetitions: int = REPETITIONS,
    seed: int = 0,
    **how: Any,
) -> Results:
    """Train every method on walls of one height, and record the visits: one panel of the figure.

    Args:
        height: the height of the walls, 1 or more.
        methods: by label, functions that make an agent for an environment.
        n_grips: the number of grips at every height, 2 or more.
        n_steps: the training steps of each run.
        repetitions: the number of runs of each method, each on a wall of its own.
        seed: the number from which all seeds are spawned.
        **how: more arguments of `edugym.experiments.repeat`, such as `jobs`, `progress` and `stop`.

    Returns:
        The results; `results.agents[method][repetition].visits` has the visits, shape (100, height + 1).
    """

    def recorded(make: Maker, environment: Any) -> Any:
        return record_visits(make(environment), environment, n_steps)

    agents = {label: partial(recorded, make) for label, make in methods.items()}
    return repeat(
        "Boulder",
        agents,
        n_steps,
        repetitions=repetitions,
        seed=seed,
        parameters={"height": height, "n_grips": n_grips},
        **how,
    )


def visits_of(results: Results, method: str) -> list[Integers]:
    """Return the visits of each complete run of a method, each of shape (n_intervals, height + 1)."""
    return [agent.visits for agent in results.complete_agents(method).values()]


def best_return(height: int, epsilon: float = 0.0, n_grips: int = 2) -> float:
    """Return the best expected return of an episode, by planning on the exact model; every layout has the same.

    Args:
        height: the height of the wall, 1 or more.
        epsilon: the probability of a random action in every state; 0 gives the optimum.
        n_grips: the number of grips at every height, 2 or more.
    """
    wall = make_mdp("Boulder", height=height, n_grips=n_grips)
    return value_iteration(finite_model(wall), epsilon=epsilon, horizon=wall.max_steps).start
