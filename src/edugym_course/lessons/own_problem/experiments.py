"""A problem of one's own (lesson 10): states, actions, dynamics and a reward, and what a careless reward teaches.

The worked example is an alarm clock that decides when to wake a sleeper, with 25 states. Planning on its exact model
finds the best policy for each reward, and what happens under it (discount 1). Agents learn it in 10 000 steps (discount
1, learning rate 0.1, ε = 0.1), 20 repetitions; what they have learned is evaluated exactly. On Roadrunner the reward of
a stall is -1.
"""

from typing import Any

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
from edugym_course.lessons.own_problem.methods import REPETITIONS, as_meant, learn, true_returns
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

REWARDS = {**TASKS, BEST_GUESS: WithPotential(Morning(), value_potential(Morning()))}
"""The same, and the potential that is the best guess of all."""

BUDGETS = (200, 800, 3_200, 12_800)
"""The training steps after which the lesson looks at what was learned."""


def first_stall(negative_reward: float) -> tuple[float, int]:
    """Return the optimum of Roadrunner when a stall and a fall cost so much, and the best first change of speed."""
    model = finite_model(Roadrunner.create(negative_reward=negative_reward))
    values = value_iteration(model, 1.0, horizon=50)
    return values.start, int(values.Q[model.row((0, 0))].argmax()) - 1


def measure(how: SharedArguments) -> tuple[Any, ...]:
    """Run the experiments."""
    returns = as_meant(REWARDS, Morning(), BUDGETS, **how(repetitions=how.repetitions))
    return learn(Morning(), **how("agents")), returns


def judge(agents: Results, returns: dict[str, Reals]) -> Report:
    """Return claims and figures."""
    learned = {method: true_returns(agents, method, Morning()) for method in agents.methods}
    claims = [*exact_claims(), *shaping_claims(), *state_claims(), *learning_claims(learned, returns)]
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
            f"sleep is worth this risk: if rings were free, it would still be {free_rings.late:.2f}",
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
            Below(0.0),
            "the shortest run returns -2",
        ),
        Claim(
            "On Roadrunner with R = -100 the best policy runs",
            "change of speed in the first step",
            exactly(running[1]),
            Above(0.0),
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
            "Ng, Harada and Russell (1999)",
        ),
        Claim(
            "Shaping with a potential lowers the value of every state by its potential",
            "largest |v'(s) - (v(s) - φ(s))|",
            exactly(float(gap)),
            Below(1e-9),
        ),
    ]


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
            Above(0.0),
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
            Below(0.0),
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
