"""Exercise 2: the imagined target of Dyna-Q+."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Annotated, Any

import numpy as np

from edugym_course.grading.agents import table_of
from edugym_course.grading.cases import STARTS, from_a_start, starts
from edugym_course.grading.errors import WrongAnswer
from edugym_course.grading.mistakes import in_terms, mistake_that_fits
from edugym_course.grading.own_numbers import Own
from edugym_course.grading.student_code import student_code
from edugym_course.grading.values import digits, number, same
from edugym_course.lessons.model_based.exercises.students import SHAPE, Memory, agent_with, memories


def imagined(
    case: Memory,
    *,
    discount: float,
    kappa: float,
    power: float = 0.5,
    root: str = "√τ",
    since: str = "now − last",
    ends: str = "heeded",
    untried: str = "stays",
    asks: str = "pair",
    backup: str = "max",
    target: str = "all",
) -> float:
    """Return the target of an imagined step of Dyna-Q+; other arguments than the defaults are mistakes."""
    s, a = case.state, case.action
    last = case.last[s, a]
    tried = last > 0
    tau = {"now − last": case.now - last, "last": last, "now": case.now, "one more": case.now - last + 1}[since]
    bonus = {
        "√τ": kappa * tau**power,
        "no κ": tau**power,
        "τ": kappa * tau,
        "κ inside": np.sqrt(kappa * tau),
        "minus": -kappa * tau**power,
        "none": 0.0,
        "tried": kappa * tau**power if tried else 0.0,
        "untried": 0.0 if tried else kappa * tau**power,
    }[root]
    stored = case.rewards[s, a], case.next_states[s, a], case.ends[s, a] == 1
    known = {
        "pair": tried,
        "the wrong way round": not tried,
        "state": case.last[s].any(),
        "reward": stored[0] != 0.0,
        "next state": stored[1] != 0,
        "after step 1": last > 1,
        "nothing": True,
    }[asks]
    if not known and untried != "stays":
        own = float(bonus + discount * case.Q[s, a])
        return {"zero": 0.0, "bonus only": float(bonus), "its own value": own}[untried]
    reward, next_state, ended = stored if known else (0.0, s, False)
    row = case.Q[next_state]
    value: Any = {"max": row.max(), "mean": row.mean(), "own": case.Q[s].max(), "same": row[a], "none": 0.0}
    value = {**value, **{f"from {start}": from_a_start(row, start) for start in STARTS}}[backup]
    future = value if ends == "ignored" or ended == (ends == "inverted") else 0.0
    return float(
        {
            "all": reward + bonus + discount * future,
            "no reward": bonus + discount * future,
            "undiscounted": reward + bonus + future,
            "bonus discounted": reward + discount * (bonus + future),
            "no bonus at the end": reward + (0.0 if ended else bonus) + discount * future,
            "difference": reward + bonus + discount * future - case.Q[s, a],
        }[target]
    )


IMAGINED_MISTAKES: Mapping[str, Mapping[str, Any]] = MappingProxyType(
    {
        "the bonus is missing": {"root": "none"},
        "the root is missing: the bonus is κ√τ": {"root": "τ"},
        "κ belongs before the root: κ√τ, not √(κτ)": {"root": "κ inside"},
        "κ is missing: the bonus is κ√τ": {"root": "no κ"},
        "the bonus is subtracted": {"root": "minus"},
        "only actions that were tried get a bonus, and those that were never tried need it most": {"root": "tried"},
        "only actions that were never tried get a bonus; every action does": {"root": "untried"},
        "τ is the time *since* the last try, `now − last`, and that is the time of the last try": {"since": "last"},
        "τ is the time since the last try; subtract `last` from the clock": {"since": "now"},
        "τ is one too large": {"since": "one more"},
        "after a terminal state there is no future: leave γ max_a Q(S', a) out where `ends` is 1": {"ends": "ignored"},
        "the test of `ends` is the wrong way round: the value of the next state counts where it is 0": {
            "ends": "inverted"
        },
        "the test of whether the pair was tried is the wrong way round: `self.last[s, a] == 0` means never": {
            "asks": "the wrong way round"
        },
        "an action that was never tried is imagined to lead back to its own state, so γ max_a Q(s, a) belongs to its"
        " target": {"untried": "bonus only"},
        "for an action that was never tried the target has the *largest* value of the state, max_a Q(s, a), and not the"
        " value of that action": {"untried": "its own value"},
        "an action that was never tried has a target too: reward 0, back to its own state, and the bonus": {
            "untried": "zero"
        },
        "an action that was never tried has nothing in the tables yet, so do not read `next_states` there: it leads"
        " back to its own state": {"asks": "nothing"},
        "that asks whether any action of the state was tried; ask whether this *pair* was tried:"
        " `self.last[s, a] == 0`": {"asks": "state"},
        "a reward may be 0, so it does not say that nothing was tried; ask whether this *pair* was tried:"
        " `self.last[s, a] == 0`": {"asks": "reward"},
        "the next state may be 0, so it does not say that nothing was tried; ask whether this *pair* was tried:"
        " `self.last[s, a] == 0`": {"asks": "next state"},
        "the mean over the actions stands where the maximum should": {"backup": "mean"},
        **starts(
            lambda start: f"the maximum starts from {start}, and all values may be lower: start from the first one",
            lambda start: {"backup": f"from {start}"},
        ),
        "a pair that was tried in step 1 has `last` = 1: only 0 means that it was never tried": {
            "asks": "after step 1"
        },
        "the maximum is taken over Q(s, a) of the state itself instead of the next state": {"backup": "own"},
        "the value of the *same* action stands where the maximum over all actions should": {"backup": "same"},
        "the value of the next state is missing": {"backup": "none"},
        "the value of the next state is not discounted": {"target": "undiscounted"},
        "the bonus is discounted; γ belongs to the value of the next state only": {"target": "bonus discounted"},
        "the reward is missing": {"target": "no reward"},
        "that is the TD error: return the whole target, which `act` puts into Q": {"target": "difference"},
        "at the end of an episode the bonus is lost: only the value of the next state is 0 there": {
            "target": "no bonus at the end"
        },
        "everything fits a discount of 0.99: use self.discount": {"discount": 0.99},
        "everything fits a κ of 0.03: use self.kappa": {"kappa": 0.03},
    }
)
SETTINGS: Mapping[str, Any] = MappingProxyType({"discount": 0.75, "kappa": 2.0})


Power = Annotated[
    float,
    Own(
        tuple(k / 100 for k in range(20, 81) if k != 50),
        "In your version the bonus grows with another power of the time: it is $\\kappa \\tau^{{{power}}}$, not"
        " $\\kappa \\sqrt{{\\tau}}$.",
    ),
]


def exercise_2(answer: Any, seed: int, power: Power = 0.5) -> str:
    """Check the imagined target of Dyna-Q+."""
    agent = agent_with("DynaPlus", answer, SETTINGS, "imagine")
    if not hasattr(agent, "imagine"):
        raise WrongAnswer("DynaPlus should have the method `imagine`")
    cases = [*memories(seed)]
    rule = {**SETTINGS, "power": power}
    right = [imagined(case, **rule) for case in cases]
    found = [_imagined_by(agent, case) for case in cases]
    wrong = [k for k in range(len(cases)) if not same(found[k], right[k])]
    if wrong:
        why = mistake_that_fits(
            IMAGINED_MISTAKES,
            lambda change: all(
                same(imagined(case, **{**rule, **change}), mine) for case, mine in zip(cases, found, strict=True)
            ),
            otherwise=in_terms(found, [_terms(case, rule) for case in cases], [k in wrong for k in range(len(cases))]),
        )
        case, mine, expected = cases[wrong[0]], found[wrong[0]], right[wrong[0]]
        s, a = case.state, case.action
        n = int(case.next_states[s, a])
        told = (
            f"now = {case.now}, last = {case.last[s, a]}, reward = {case.rewards[s, a]:g}, next state = {n}, ends ="
            f" {case.ends[s, a]}, Q[{n}] = {case.Q[n].tolist()}"
            if case.last[s, a]
            else f"now = {case.now}, the action was never tried and Q[{s}] = {case.Q[s].tolist()}"
        )
        raise WrongAnswer(
            f"imagine({s}, {a}), where γ = 0.75, κ = 2, {told}, should be {digits(expected, mine)}, but is"
            f" {digits(mine, expected)}: {why}"
        )
    return (
        "Right: what was not tried for a long time looks better and better, until the agent goes and sees. "
        "See its race:"
    )


def _terms(case: Memory, rule: Mapping[str, Any]) -> dict[str, float]:
    """Return the three numbers that an imagined target adds up."""
    bonus = imagined(case, **{**rule, "target": "no reward", "backup": "none"})
    rest = imagined(case, **{**rule, "target": "no reward"}) - bonus
    reward = imagined(case, **rule) - bonus - rest
    return {"the reward": reward, "the bonus": bonus, "the discounted value that follows": rest}


def _imagined_by(agent: Any, case: Memory) -> float:
    """Return the student's target."""
    tables = {name: getattr(case, name) for name in ("Q", "rewards", "next_states", "ends", "last")}
    states = np.flatnonzero(case.last.any(axis=1))
    tables |= {"clock": np.array([case.now]), "n_seen": np.array([len(states)])}
    tables["seen"] = np.pad(states, (0, SHAPE[0] - len(states)))
    for name, values in tables.items():
        table_of(agent, name, values.shape, values.dtype.kind)[...] = values
    call = f"imagine({case.state}, {case.action})"
    with student_code(call):
        found = agent.imagine(case.state, case.action)
    if any(not np.array_equal(getattr(agent, name), values) for name, values in tables.items()):
        raise WrongAnswer(f"{call} changes a table: it should only return the target, and `act` puts that into Q")
    return number(call, found)
