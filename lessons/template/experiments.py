"""Template (lesson 99): Q-learning and SARSA at the edge of a cliff.

On Roadrunner both train for 20 000 steps with learning rate 0.1, ε = 0.1 and discount 1, in 20 repetitions. The report
of `edugym reproduce` begins with this text: say every setting here.
"""

from typing import Any

from edugym.adapters.registration import make_mdp
from edugym.agents.q_learning import QLearning
from edugym.agents.sarsa import SARSA
from edugym.agents.strategies import EpsilonGreedy
from edugym.exact.model import finite_model
from edugym.exact.value_iteration import value_iteration
from edugym.experiments.figures.curves import Curves
from edugym.experiments.figures.sheet import Sheet
from edugym.experiments.repeat import repeat
from edugym.experiments.results.claims import Above, Claim
from edugym.experiments.results.tables import Results
from edugym_course.report import Report
from edugym_course.reporting import SharedArguments, reporting

Q_LEARNING, SARSA_ = "Q-learning", "SARSA"
TASK = make_mdp("Roadrunner")
OPTIMUM = value_iteration(finite_model(TASK)).start


def compare(epsilon: float = 0.1, learning_rate: float = 0.1, **how: Any) -> Results:
    """Train both methods; other arguments are those of `repeat`."""
    settings: dict[str, Any] = {
        "discount": 1.0,
        "learning_rate": learning_rate,
        "exploration": EpsilonGreedy(epsilon),
    }
    methods = {
        Q_LEARNING: lambda environment: QLearning.create(environment, **settings),
        SARSA_: lambda environment: SARSA.create(environment, **settings),
    }
    return repeat(TASK, methods, **{"n_steps": 20_000, "repetitions": 20, **how})


def learning_curves(results: Results) -> Sheet:
    """Draw the returns while exploring, with the best possible return."""
    return Sheet("comparison", [[Curves(results, "Roadrunner", "training_return", optimum=OPTIMUM, smooth=10)]])


def one_setting(epsilon: float = 0.1, learning_rate: float = 0.1) -> Sheet:
    """Draw what the sliders ask for."""
    return learning_curves(compare(epsilon, learning_rate))


def measure(how: SharedArguments) -> tuple[Any, ...]:
    """Run the experiments; what has a name is saved under it."""
    return (compare(**how("comparison")),)


def judge(results: Results) -> Report:
    """Return claims and figures."""
    return Report(cliff_claims(results), [learning_curves(results)])


report = reporting(measure, judge, repetitions=20)
"""Run the experiments of the lesson (see `edugym_course.reporting.Reporter`)."""


def cliff_claims(results: Results) -> list[Claim]:
    """Return the claims: each sentence of the text that says what was measured is one."""
    return [
        Claim(
            "While exploring SARSA earns more than Q-learning",
            "return averaged over training, less that of Q-learning",
            results.difference(SARSA_, Q_LEARNING, "training_return", over="training"),
            Above(0.0),
            "it learns to keep away from where a slip is deadly",
        ),
        Claim(
            "Without exploring Q-learning ends with the optimum in most runs",
            "share of runs that end with the optimum",
            results.share(Q_LEARNING, at_least=OPTIMUM),
            Above(0.5),
        ),
    ]


def warm_up() -> None:
    """Compile what the cells of the lesson need."""
    compare(n_steps=100, repetitions=1, jobs=1)
