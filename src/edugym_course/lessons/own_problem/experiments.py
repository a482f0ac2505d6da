"""A problem of one's own (lesson 10): states, actions, dynamics and a reward, and what a careless reward teaches.

The worked example is an alarm clock that decides when to wake a sleeper, with 25 states. Planning on its exact model
finds the best policy for each reward, and what happens under it (discount 1). Agents learn it in 10 000 steps (discount
1, learning rate 0.1, ε = 0.1), 20 repetitions; what they have learned is evaluated exactly. On Roadrunner the reward of
a stall is -1.
"""

from functools import partial
from typing import Any

import numpy as np

from edugym.agents.q_learning import QLearning
from edugym.envs.roadrunner import Roadrunner
from edugym.exact.model import finite_model
from edugym.exact.value_iteration import value_iteration
from edugym.experiments.figures.sheet import Sheet
from edugym.experiments.results.claims import Above, Below, Claim, Within, beginning
from edugym.experiments.results.statistics import exactly, mean_interval, paired_difference
from edugym.experiments.results.tables import Results
from edugym.mdp.protocol import Reals
from edugym_course.lessons.own_problem.exact import (
    BEST_GUESS,
    MEANT,
    POTENTIAL,
    WAKEFULNESS,
    WAKINGS,
    awake_potential,
    best_blind,
    best_policy,
    random_return,
    solve,
    value_potential,
    what_happens,
)
from edugym_course.lessons.own_problem.figures import Bands, policies, race
from edugym_course.lessons.own_problem.methods import (
    REPETITIONS,
    as_meant,
    learn,
    methods_with,
    started_at,
    true_returns,
)
from edugym_course.lessons.own_problem.morning import Morning, PaidForWakefulness, WithBonus, WithPotential
from edugym_course.report import Report
from edugym_course.reporting import SharedArguments, reporting

TASKS: dict[str, Any] = {
    MEANT: Morning(),
    WAKEFULNESS: PaidForWakefulness(),
    WAKINGS: WithBonus(Morning()),
    POTENTIAL: WithPotential(Morning(), awake_potential(8)),
}
"""The worked example with the reward that was meant, with two careless ones, and with a harmless one."""

RUNS = "On Roadrunner with R = -100 the best policy runs"

REWARDS = {**TASKS, BEST_GUESS: WithPotential(Morning(), value_potential(Morning()))}
"""The same, and the potential that is the best guess of all."""

BUDGETS = (200, 800, 3_200, 12_800)
"""The training steps after which the lesson looks at what was learned."""

NIGHTS = ((8, 10.0), (8, 20.0), (12, 10.0))
"""The steps of a night and the potential of being awake: those of the lesson, and two others."""


def first_stall(negative_reward: float) -> tuple[float, int]:
    """Return the optimum of Roadrunner when a stall and a fall cost so much, and the best first change of speed."""
    model = finite_model(Roadrunner.create(negative_reward=negative_reward))
    values = value_iteration(model, 1.0, horizon=50)
    return values.start, int(values.Q[model.row((0, 0))].argmax()) - 1


Starts = dict[tuple[int, float], tuple[Reals, Reals, Reals, Reals]]
"""By the steps of a night and the bonus: see `starts_compared`."""


def starts_compared(length: int, bonus: float, **how: Any) -> tuple[Reals, Reals, Reals, Reals]:
    """Return what Q-learning's policies are worth after 800 steps, with and without a potential and its initial value.

    Args:
        length: the steps of the night.
        bonus: the potential of being awake.
        **how: more arguments of `repeat`.

    Returns:
        One value for each run: without shaping; with the potential; without shaping where the values start at the
        potential; with the potential where they start at minus the potential.
    """
    task, phi = Morning(length), awake_potential(length, bonus)
    of = partial(_early, task, how)
    shaped = WithPotential(task, phi)
    return of(task), of(shaped), of(task, partial(started_at, phi)), of(shaped, partial(started_at, -phi))


def _early(judge: Any, how: dict[str, Any], task: Any, make: Any = None) -> Reals:
    found: Reals = as_meant({"": task}, judge, BUDGETS[1:2], make=make, **how)[""][0]
    return found


def tables_apart(phi: Reals, n_steps: int = 12_800, seed: int = 0) -> float:
    """Return how far two tables are apart that learn from the same steps: one with a potential, one that starts at it.

    Args:
        phi: the potential, by time and depth, as `WithPotential` takes it.
        n_steps: the steps of a morning that both learn from; the second one chooses the actions.
        seed: of these steps.

    Returns:
        The largest difference of Q(s, a) + φ(s) of the first from Q(s, a) of the second.
    """
    morning, rng = Morning(), np.random.default_rng(seed)
    shaped, task = methods_with()["Q-learning"](morning), WithPotential(morning, phi)
    started: QLearning = started_at(phi, morning)
    state = morning.initial(rng)
    for _ in range(n_steps):
        row = 3 * state[0] + state[1]
        action = started.act(row, rng)
        after = morning.transition(state, action, rng)
        over, next_row = morning.terminal(after), 3 * after[0] + after[1]
        shaped.learn(row, action, task.reward(state, action, after, rng), next_row, over)
        started.learn(row, action, morning.reward(state, action, after, rng), next_row, over)
        state = morning.initial(rng) if over else after
    return float(np.abs(shaped.Q + phi.reshape(-1, 1) - started.Q).max())


def measure(how: SharedArguments) -> tuple[Any, ...]:
    """Run the experiments."""
    returns = as_meant(REWARDS, Morning(), BUDGETS, **how(repetitions=how.repetitions))
    starts = {night: starts_compared(*night, **how()) for night in NIGHTS}
    return learn(Morning(), **how("agents")), returns, starts


def judge(agents: Results, returns: dict[str, Reals], starts: Starts) -> Report:
    """Return claims and figures."""
    learned = {method: true_returns(agents, method, Morning()) for method in agents.methods}
    claims = [*exact_claims(), *shaping_claims(), *start_claims(starts), *state_claims()]
    claims += learning_claims(learned, returns)
    optimum = solve(Morning()).start
    return Report(
        claims,
        [
            policies(TASKS),
            race(agents, learned, optimum, random_return(Morning())),
            Sheet("as_meant", [[learning_lines(returns)]]),
        ],
    )


report = reporting(measure, judge, REPETITIONS)
"""Run the experiments of the lesson (see `edugym_course.reporting.Reporter`)."""


def learning_lines(returns: dict[str, Reals]) -> Bands:
    """Return the lines of what Q-learning's policies are worth as meant, against the training steps."""
    optimum = solve(Morning()).start
    return Bands(
        BUDGETS, returns, "learned from five rewards, judged by one", "training steps", "return as meant", optimum
    )


def exact_claims() -> list[Claim]:
    """Return the claims on what rewards teach; they are exact, so their intervals are points."""
    nights = {label: what_happens(Morning(), best_policy(mdp)) for label, mdp in TASKS.items()}
    free_rings = what_happens(Morning(), best_policy(Morning(ring=0.0)))
    stalling, running = first_stall(-1.0), first_stall(-100.0)
    return [
        Claim(
            "Even the reward that was meant lets the sleeper oversleep, one day in seven",
            "probability of oversleeping under the best policy",
            exactly(nights[MEANT].late),
            Within(0.13, 0.15),
            remark=f"if rings were free, it would still be {free_rings.late:.2f}",
        ),
        Claim(
            "Paid for being awake, the clock wakes the sleeper at dawn",
            "minutes asleep, of 80",
            exactly(nights[WAKEFULNESS].sleep),
            Below(25.0),
        ),
        Claim(
            "Paid for being awake, the clock loses most of the return that was meant",
            "return as meant, of 10.3",
            exactly(nights[WAKEFULNESS].meant),
            Below(3.0),
        ),
        Claim(
            "Paid for each waking, the clock lets the sleeper doze off to wake her again",
            "wakings in an episode",
            exactly(nights[WAKINGS].wakings),
            Above(2.0),
        ),
        Claim(
            "Without a bonus for each waking the sleeper wakes less than once on average",
            "wakings in an episode",
            exactly(nights[MEANT].wakings),
            Below(1.0),
        ),
        Claim(
            "When oversleeping costs 3 the best clock never makes a sound",
            "probability of oversleeping",
            exactly(what_happens(Morning(), best_policy(Morning(late=3.0))).late),
            Above(0.999),
        ),
        Claim("On Roadrunner with R = -1 the optimum is -1", "optimum", exactly(stalling[0]), Within(-1.001, -0.999)),
        Claim(
            "On Roadrunner with R = -1 the best policy stalls in the first step",
            "change of speed in the first step",
            exactly(stalling[1]),
            Within(-1.0, -1.0),
            "a run costs more than giving up: the shortest one returns -2, and a stall R",
            (RUNS,),
        ),
        Claim(
            RUNS,
            "change of speed in the first step",
            exactly(running[1]),
            Within(1.0, 1.0),
        ),
    ]


def shaping_claims() -> list[Claim]:
    """Return the claims on shaping."""
    meant, shaped = solve(Morning()), solve(TASKS[POTENTIAL])
    task = TASKS[POTENTIAL]
    gap = max(abs(shaped.value(s) - (meant.value(s) - task.potential(s))) for s in meant.model.states)
    difference = abs(meant.greedy_policy() - shaped.greedy_policy()).max()
    return [
        Claim(
            "As a potential a bonus for being awake changes no best action",
            "largest difference of the two best policies",
            exactly(float(difference)),
            Below(1e-9),
            remark="Ng, Harada and Russell (1999)",
        ),
        Claim(
            "Shaping with a potential lowers the value of every state by its potential",
            "largest |v'(s) - (v(s) - φ(s))|",
            exactly(float(gap)),
            Below(1e-9),
        ),
        Claim(
            "From the same steps Q-learning with a potential learns the same as Q-learning that starts at it",
            "largest difference of Q(s, a) + φ(s) of the one from Q(s, a) of the other, for three potentials",
            exactly(max(map(tables_apart, (awake_potential(8), awake_potential(8, 5.0), value_potential(Morning()))))),
            Below(1e-9),
            remark="Wiewiora (2003): a potential is an initial value",
        ),
    ]


def told(length: int, bonus: float) -> str:
    """Return a night and a potential in words."""
    return f"{length} steps, potential {bonus:g}"


def cancelled(length: int, bonus: float) -> str:
    """Return the claim that a potential does nothing where the initial values cancel it."""
    return f"With the potential and values that start at minus the potential nothing is lost ({told(length, bonus)})"


def start_claims(starts: Starts) -> list[Claim]:
    """Return the claims on a potential as an initial value."""
    early = f"return as meant after {BUDGETS[1]} steps, less that without shaping"
    claims = []
    for night, (plain, shaped, started, both) in starts.items():
        claims += [
            Claim(
                f"The potential for being awake slows Q-learning down early on ({told(*night)})",
                early,
                paired_difference(shaped, plain),
                Below(-3.0),
                "to Q-learning a potential is an initial value, and this one is far too optimistic",
                tuple(cancelled(*night) for night in starts),
            ),
            Claim(
                f"Without shaping, values that start at the potential slow Q-learning down too ({told(*night)})",
                early,
                paired_difference(started, plain),
                Below(-3.0),
            ),
            Claim(cancelled(*night), early, paired_difference(both, plain), Within(-1.0, 1.0)),
        ]
    return claims


def state_claims() -> list[Claim]:
    """Return the claims on what a clock can do that does not see the whole state."""
    optimum = solve(Morning()).start
    time, _ = best_blind(Morning(), lambda state: state[0])
    sleep, actions = best_blind(Morning(), lambda state: state[1])
    return [
        Claim(
            "A clock that sees the time only loses little",
            "best return of a fixed plan less the optimum",
            exactly(time - optimum),
            Within(-0.5, -0.2),
        ),
        Claim(
            "A clock that does not know the time had best keep quiet",
            "largest action of the best deterministic policy (0 is quiet)",
            exactly(max(actions)),
            Below(0.5),
        ),
        Claim(
            "A clock that does not know the time earns what silence earns", "return", exactly(sleep), Within(5.99, 6.01)
        ),
    ]


def learning_claims(learned: dict[str, Reals], returns: dict[str, Reals]) -> list[Claim]:
    """Return the claims on agents."""
    optimum = solve(Morning()).start
    return [
        *(
            Claim(
                f"{beginning(method)} learns a good clock",
                "expected return of its policy",
                mean_interval(values),
                Above(9.0),
            )
            for method, values in learned.items()
        ),
        Claim(
            "Dyna-10 is ahead of Q-learning",
            "expected return of Dyna-10 less that of Q-learning",
            paired_difference(learned["Dyna-10"], learned["Q-learning"]),
            Above(0.1),
        ),
        Claim(
            "More learning does not mend a careless reward: paid for each waking, Q-learning ends far from the optimum",
            "return as meant after the largest budget, less the optimum",
            mean_interval(returns[WAKINGS][-1] - optimum),
            Below(-5.0),
        ),
        Claim(
            "More learning does not mend a careless reward: paid for being awake, Q-learning ends far from the optimum",
            "return as meant after the largest budget, less the optimum",
            mean_interval(returns[WAKEFULNESS][-1] - optimum),
            Below(-5.0),
        ),
        Claim(
            "With the potential Q-learning ends near the optimum",
            "return as meant after the largest budget, less the optimum",
            mean_interval(returns[POTENTIAL][-1] - optimum),
            Above(-2.0),
        ),
        Claim(
            "Shaping need not help: early on Q-learning with this potential is behind Q-learning without shaping",
            f"return as meant after {BUDGETS[1]} steps, less that without shaping",
            paired_difference(returns[POTENTIAL][1], returns[MEANT][1]),
            Below(-5.0),
            "to Q-learning a potential is an initial value, and this one is far too optimistic",
            tuple(cancelled(*night) for night in NIGHTS),
            "a potential that points the wrong way is a bad hint; it only cannot change the optimum",
        ),
        Claim(
            "Early on Q-learning with the best values as a potential is far ahead of Q-learning without shaping",
            f"return as meant after {BUDGETS[1]} steps, less that without shaping",
            paired_difference(returns[BEST_GUESS][1], returns[MEANT][1]),
            Above(1.0),
        ),
    ]


def warm_up() -> None:
    """Compile what the lesson needs: a few steps of everything."""
    how: dict[str, Any] = {"repetitions": 2}
    race(learn(Morning(), n_steps=40, **how), {}, 0.0, 0.0).draw()
    as_meant(TASKS, Morning(), (40,), **how)
