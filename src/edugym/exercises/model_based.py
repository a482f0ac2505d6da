"""The exercises of lesson 9: an error that pays, Dyna-Q+, R-max in ten lines, another lake."""

from collections.abc import Callable, Iterator, Mapping
from functools import partial
from types import MappingProxyType
from typing import Any, NamedTuple

import gymnasium
import numpy as np

from edugym.grading.challenge import Challenge
from edugym.grading.results import check_results
from edugym.grading.student_code import running
from edugym.grading.updates import table_of
from edugym.grading.values import compare, digits, given, number, same
from edugym.grading.wrong import WrongAnswer
from edugym.lessons.model_based import DYNA_10, LEARNED, OPTIMUM, Q_LEARNING, R_MAX, SWEEPING

SHAPE = (6, 3)
"""The size of the tables that checks make up."""
SETTLED = 400
"""So many sweeps over them change nothing any more."""
LAKE_STEPS = 3_000
ENOUGH = 0.15
"""The share of goals that tells averaging from luck: rates of 1 with sampled updates get 0.07 at most."""


class Sizes(NamedTuple):
    """Stands for the shop where an agent is made."""

    observation_space: Any = gymnasium.spaces.Discrete(SHAPE[0])
    action_space: Any = gymnasium.spaces.Discrete(SHAPE[1])


def exercise_1(answer: Any, seed: int) -> str:
    """Check the error from which bumping into a wall for ever looks better than anything else."""
    given("smallest_error", answer)
    if not callable(answer):
        raise WrongAnswer(f"smallest_error should be a function, but is of the type {type(answer).__name__}")
    for v, gamma in ((40.0, 0.75), (8.0 + seed % 4, 0.5), (33.0, 0.875)):
        with running(f"smallest_error({v:g}, {gamma})"):
            found = answer(v, gamma)
        right = 1 + (1 - gamma) * v
        compare(
            f"smallest_error({v:g}, {gamma})",
            found,
            right,
            {
                "the step costs 1, which the error has to pay first: the reward of a bump seems to be e − 1": right - 1,
                "the cost of the step is −1, so solve e − 1 = (1 − γ) v for e: it adds 1": right - 2,
                "bumping for ever is worth the reward *divided* by 1 − γ": 1 + v / (1 - gamma),
                "that leaves the future out: one bump alone need not be worth v, for it is followed by more": 1 + v,
                "that compares with γ v; compare with v, what the best way is worth from here": 1 + gamma * v,
                "that is what bumping is worth without an error, −1/(1 − γ)": -1 / (1 - gamma),
                "that solves e/(1 − γ) − 1 = v: the cost of 1 comes with every bump": (1 - gamma) * (v + 1),
                "that is v itself": v,
                "that is 1, the error from which a bump pays at all; it must pay more than leaving": 1.0,
                "the sign of γ is wrong: the sum 1 + γ + γ² + ... is 1/(1 − γ)": 1 + (1 + gamma) * v,
                "the cost is subtracted twice": 1 + (1 - gamma) * (v + 1),
                "that is 1 − (1 − γ) v: the two terms add up": 1 - (1 - gamma) * v,
                "only the first three bumps are counted, and there is no end to them": 1 + v / (1 + gamma + gamma**2),
            },
            otherwise="solve (e − 1)/(1 − γ) = v for e",
        )
    return "Right: the larger γ is, the smaller an error is enough, since a far-sighted plan adds up more bumps."


class Memory(NamedTuple):
    """What the agents of exercises 2 and 3 remember of one pair of state and action, and of the next state."""

    Q: Any
    rewards: Any
    next_states: Any
    ends: Any
    last: Any
    now: int
    state: int
    action: int


def imagined(
    case: Memory,
    *,
    discount: float,
    kappa: float,
    root: str = "√τ",
    since: str = "now − last",
    ends: str = "heeded",
    untried: str = "stays",
    backup: str = "max",
    target: str = "all",
) -> float:
    """Return the target of an imagined step of Dyna-Q+; other arguments than the defaults are mistakes."""
    s, a = case.state, case.action
    last = case.last[s, a]
    tried = last > 0
    tau = {"now − last": case.now - last, "last": last, "now": case.now, "one more": case.now - last + 1}[since]
    bonus = {"√τ": np.sqrt(tau), "τ": tau, "none": 0.0, "tried": np.sqrt(tau) if tried else 0.0}.get(root, 0.0)
    if root == "untried":
        bonus = 0.0 if tried else np.sqrt(tau)
    if root == "minus":
        bonus = -np.sqrt(tau)
    if root == "κ inside":
        bonus = np.sqrt(kappa * tau) / kappa
    reward, next_state, ended = case.rewards[s, a], case.next_states[s, a], case.ends[s, a] == 1
    if not tried:
        if untried == "zero":
            return 0.0
        if untried == "bonus only":
            return float(kappa * bonus)
        if untried == "stays":
            reward, next_state, ended = 0.0, s, False
    if ends == "ignored":
        ended = False
    row = case.Q[next_state]
    value = {"max": row.max(), "mean": row.mean(), "own": case.Q[s].max(), "same": row[a], "none": 0.0}[backup]
    future = 0.0 if ended else discount * value
    if target == "undiscounted" and not ended:
        future = value
    if target == "bonus discounted":
        return float(reward + future + discount * kappa * bonus)
    if target == "no reward":
        reward = 0.0
    if target == "difference":
        return float(reward + kappa * bonus + future - case.Q[s, a])
    if target == "no bonus at the end" and ended:
        bonus = 0.0
    return float(reward + kappa * bonus + future)


IMAGINED_MISTAKES: Mapping[str, Mapping[str, str]] = MappingProxyType(
    {
        "the bonus is missing": {"root": "none"},
        "the root is missing: the bonus is κ√τ": {"root": "τ"},
        "κ belongs before the root: κ√τ, not √(κτ)": {"root": "κ inside"},
        "the bonus is subtracted": {"root": "minus"},
        "only actions that were tried get a bonus, and those that were never tried need it most": {"root": "tried"},
        "only actions that were never tried get a bonus; every action does": {"root": "untried"},
        "τ is the time *since* the last try, `now − last`, and that is the time of the last try": {"since": "last"},
        "τ is the time since the last try; subtract `last` from the clock": {"since": "now"},
        "τ is one too large": {"since": "one more"},
        "after a terminal state there is no future: leave γ max_a Q(S', a) out where `ends` is 1": {"ends": "ignored"},
        "an action that was never tried is imagined to lead back to its own state, so γ max_a Q(s, a) belongs to its"
        " target": {"untried": "bonus only"},
        "an action that was never tried has a target too: reward 0, back to its own state, and the bonus": {
            "untried": "zero"
        },
        "an action that was never tried has nothing in the tables yet, so do not read `next_states` there: it leads"
        " back to its own state": {"untried": "as stored"},
        "the mean over the actions stands where the maximum should": {"backup": "mean"},
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
    }
)


def exercise_2(answer: Any, seed: int) -> str:
    """Check the imagined target of Dyna-Q+."""
    agent = _made("DynaPlus", answer)
    agent = _with("DynaPlus", agent, {"discount": 0.75, "kappa": 2.0})
    if not hasattr(agent, "imagine"):
        raise WrongAnswer("DynaPlus should have the method `imagine`")
    cases = [*_memories(seed)]
    right = [imagined(case, discount=0.75, kappa=2.0) for case in cases]
    found = [_imagined_by(agent, case) for case in cases]
    wrong = [k for k in range(len(cases)) if not same(found[k], right[k])]
    if wrong:
        why = _first_that_fits(
            IMAGINED_MISTAKES,
            lambda change: all(
                same(imagined(case, discount=0.75, kappa=2.0, **change), mine)
                for case, mine in zip(cases, found, strict=True)
            ),
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


def _memories(seed: int) -> Iterator[Memory]:
    """Yield made-up memories: pairs that were tried, that ended the episode, that were never tried."""
    rng = np.random.default_rng(seed)
    for kind in ("tried", "tried", "ended", "ended", "never", "never"):
        Q = rng.choice(np.arange(-2.0, 4.25, 0.25), SHAPE)
        state, other = (int(s) for s in rng.choice(SHAPE[0], 2, replace=False))
        action, now = int(rng.integers(SHAPE[1])), int(rng.integers(40, 60))
        Q[other, (action + 1) % SHAPE[1]] = 5.0
        Q[state, (action + 1) % SHAPE[1]] = 4.5
        rewards, next_states = np.zeros(SHAPE), np.zeros(SHAPE, np.int64)
        ends, last = np.zeros(SHAPE, np.int64), np.zeros(SHAPE, np.int64)
        if kind != "never":
            rewards[state, action] = float(rng.choice([-1.0, 2.0, 3.0]))
            next_states[state, action] = other
            last[state, action] = now - int(rng.choice([9, 16, 25]))
        elif state == 0:
            Q[0], state = Q[0] - 1.0, 1  # what is not in the tables yet is 0, and must not look like the state itself
        ends[state, action] = kind == "ended"
        yield Memory(Q, rewards, next_states, ends, last, now, state, action)


def _imagined_by(agent: Any, case: Memory) -> float:
    """Return the student's target."""
    for name in ("Q", "rewards", "next_states", "ends", "last"):
        values = getattr(case, name)
        table_of(agent, name, SHAPE, values.dtype.kind)[...] = values
    table_of(agent, "clock", (1,), "i")[0] = case.now
    call = f"imagine({case.state}, {case.action})"
    with running(call):
        found = agent.imagine(case.state, case.action)
    if any(not np.array_equal(getattr(agent, name), getattr(case, name)) for name in ("Q", "last", "rewards")):
        raise WrongAnswer(f"{call} changes a table: it should only return the target, and `act` puts that into Q")
    return number(call, found)


def swept(
    case: Memory,
    known: Any,
    *,
    discount: float,
    ends: str = "heeded",
    unknown: str = "left",
    backup: str = "max",
    target: str = "all",
) -> Any:
    """Return the values that sweeps of R-max settle at; other arguments than the defaults are mistakes."""
    Q = case.Q.copy()
    for _ in range(SETTLED):
        for s, a in np.ndindex(*SHAPE):
            if (not known[s, a] and unknown == "left") or (unknown == "only" and known[s, a]):
                continue
            if not known[s, a] and unknown == "zero":
                Q[s, a] = 0.0
                continue
            row = Q[case.next_states[s, a]]
            value = {"max": row.max(), "mean": row.mean(), "own": Q[s].max(), "same": row[a], "none": 0.0}[backup]
            if case.ends[s, a] == 1 and ends == "heeded":
                value = 0.0
            reward = case.rewards[s, a]
            Q[s, a] = {
                "all": reward + discount * value,
                "all discounted": discount * (reward + value),
                "no reward": discount * value,
                "added": Q[s, a] + reward + discount * value,
                "minus": reward - discount * value,
            }[target]
    return Q


SWEEP_MISTAKES: Mapping[str, Mapping[str, str]] = MappingProxyType(
    {
        "pairs that are not known change as well; leave them at U, which is what makes the agent curious": {
            "unknown": "all"
        },
        "pairs that are not known are set to 0; leave them at U, which is what makes the agent curious": {
            "unknown": "zero"
        },
        "the test of `known` is the wrong way round": {"unknown": "only"},
        "after a terminal state there is no future: leave γ max_a Q(s', a) out where `ends` is 1": {"ends": "ignored"},
        "the mean over the actions stands where the maximum should": {"backup": "mean"},
        "the maximum is taken over the state itself instead of the next state": {"backup": "own"},
        "the value of the *same* action stands where the maximum over all actions should": {"backup": "same"},
        "the value of the next state is missing": {"backup": "none"},
        "the whole target is discounted; γ belongs to the value of the next state only": {"target": "all discounted"},
        "the reward is missing": {"target": "no reward"},
        "the value of the next state is subtracted": {"target": "minus"},
        "the old value is still in the sum: Q(s, a) *becomes* the target, `=` and not `+=`": {"target": "added"},
    }
)


def exercise_3(answer: Any, seed: int) -> str:
    """Check R-max in ten lines: what it remembers, and how it sweeps."""
    _check_sweep(answer, seed)
    _check_learn(answer, seed)
    return (
        "Right: the unknown is worth U, so the way to it is planned like any other way. In the race its policy goes on"
        " exploring, since it has one table only, until all that matters is known; then it jumps to the optimum:"
    )


def _check_sweep(answer: Any, seed: int) -> None:
    rng = np.random.default_rng(seed)
    for _ in range(3):
        agent = _with("MyRMax", _made("MyRMax", answer), {"discount": 0.5})
        known = rng.permutation(np.repeat([0, 1], [6, 9])).reshape(-1, SHAPE[1])
        known = np.vstack([np.ones((1, SHAPE[1]), np.int64), known])
        next_states = np.where(known, rng.integers(1, SHAPE[0], SHAPE), 0)
        rewards = np.where(known, rng.choice([-2.0, -1.0, 3.0, 6.0], SHAPE), 0.0)
        ends = np.where(known, rng.random(SHAPE) < 0.25, 0).astype(np.int64)
        Q = np.full(SHAPE, 100.0)
        Q[known == 1] = rng.choice([-4.0, 2.0, 50.0], 12)
        Q[0, 0] = 400.0  # it falls by more than any other value rises
        case = Memory(Q, rewards, next_states, ends, known, 0, 0, 0)
        tables = {"Q": Q, "known": known, "rewards": rewards, "next_states": next_states, "ends": ends}
        for name, values in tables.items():
            table_of(agent, name, SHAPE, values.dtype.kind)[...] = values
        with running("sweep()"):
            first = agent.sweep()
            if first is None:
                raise WrongAnswer("sweep() gives None: it should return the largest change of a value")
            changes = agent.Q - Q
            for _ in range(SETTLED - 1):
                last = agent.sweep()
        right = swept(case, known, discount=0.5)
        wrong = np.argwhere(~np.isclose(agent.Q, right, atol=1e-6))
        if len(wrong):
            found = agent.Q.copy()
            changed = ~np.isclose(found, Q)
            if not changed.any():
                why = "sweep() changes no value: set Q[s, a] to the target"
            elif not changed[1:].any():
                one = " and action 0" if not changed[0, 1:].any() else ""
                why = (
                    f"only state 0{one} is swept. `return` ends the loops: write it below both, as far to the left as"
                    " the first `for`"
                )
            else:
                why = _first_that_fits(SWEEP_MISTAKES, partial(_sweeps_to, found, case))
            s, a = wrong[0]
            what = "known" if known[s, a] else "not known"
            raise WrongAnswer(
                f"after many sweeps with γ = 0.5, Q[{s}, {a}], a pair that is {what}, should be"
                f" {digits(right[s, a], agent.Q[s, a])}, but is {digits(agent.Q[s, a], right[s, a])}: {why}"
            )
        for name, values in tables.items():
            if name != "Q" and not np.array_equal(getattr(agent, name), values):
                raise WrongAnswer(f"sweep() changes the table `{name}`: planning changes Q only")
        if not same(number("sweep()", last), 0.0):
            raise WrongAnswer(
                f"once nothing changes any more, sweep() should return 0, the largest change, but returns {last:.4g}"
            )
        largest = np.abs(changes).max()
        if not same(number("sweep()", first), largest):
            sizes = np.abs(changes)
            hint = "compare the new value with the old one before you store it, and keep the largest change"
            if same(first, max(changes.max(), 0.0)):
                hint = "values fall as well as rise, and a fall counts too: `abs(new - old)`"
            elif same(first, sizes.sum()):
                hint = "that is the sum of all changes"
            elif same(first, sizes[known == 1][-1]) or same(first, sizes[-1].max()):
                hint = "that is a change of the last state: keep the largest of all, and set it to 0.0 above both loops"
            raise WrongAnswer(
                f"the largest change of the first sweep(), without its sign, is {digits(largest, first)}, but it"
                f" returns {digits(first, largest)}: {hint}"
            )


def _sweeps_to(found: Any, case: Memory, change: Mapping[str, str]) -> bool:
    """Whether a mistake gives the values that were found."""
    return np.allclose(swept(case, case.last, discount=0.5, **change), found, atol=1e-6, rtol=1e-6)


NOT_PLANNED = "a new pair is known now, so `learn` should call self.plan(), which sweeps until nothing changes"


def _check_learn(answer: Any, seed: int) -> None:
    rng = np.random.default_rng(seed + 100)
    agent = _with("MyRMax", _made("MyRMax", answer), {"discount": 0.5})
    names = ("known", "rewards", "next_states", "ends")
    seen: dict[str, Any] = {
        "known": np.zeros(SHAPE, np.int64),
        "rewards": np.zeros(SHAPE),
        "next_states": np.zeros(SHAPE, np.int64),
        "ends": np.zeros(SHAPE, np.int64),
    }
    *others, low, middle, high = [int(s) for s in rng.permutation(np.arange(1, SHAPE[0]))]
    low, middle, high = sorted((low, middle, high))
    # Two ways lead to the middle, from both sides, and then all of its actions become known: one sweep is not enough.
    steps = [(low, 1, middle), (high, 0, middle), *((middle, a, others[a % 2]) for a in range(SHAPE[1]))]
    unplanned = ""  # what to say if no later step changes a value either
    for k, (state, action, next_state) in enumerate([*steps, (low, 1, high)]):
        before = {name: table.copy() for name, table in seen.items()}
        again = k == len(steps)  # a known pair, and something else seems to follow: nothing changes
        ended = k == 3
        reward = float(rng.choice([-1.0, 4.0, 7.0])) if not again else 9.0
        call = f"learn({state}, {action}, {reward:g}, {next_state}, {ended})"
        with running(call):
            agent.learn(state, action, reward, next_state, ended)
        if not again:
            for name, value in zip(names, (1, reward, next_state, int(ended)), strict=True):
                seen[name][state, action] = value
        for name in names:
            _compare_memory(agent, name, seen[name], call, (state, action), next_state, again)
        right = _planned(seen)
        wrong = np.argwhere(~np.isclose(agent.Q, right, atol=1e-2))
        if not len(wrong):
            continue
        s, a = (int(index) for index in wrong[0])
        what = f"after {call} Q[{s}, {a}] should be {right[s, a]:g}, but is {agent.Q[s, a]:.4g}: "
        if np.array_equal(agent.Q, np.full(SHAPE, 100.0)):
            # Either it never plans, or it plans before the new pair is known: the next steps tell.
            unplanned = unplanned or what
            continue
        late = [name for name in names if np.allclose(agent.Q, _planned({**seen, name: before[name]}), atol=1e-2)]
        if late:
            hint = f"`{late[0]}` is set only after self.plan(), which cannot use it then: remember first, and plan last"
            raise WrongAnswer(f"{unplanned or what}{hint}")
        raise WrongAnswer(f"{unplanned or what}{NOT_PLANNED}")
    if unplanned:
        raise WrongAnswer(f"{unplanned}{NOT_PLANNED}")


def _planned(seen: Mapping[str, Any]) -> Any:
    """Return the values of a plan with what was seen, from U everywhere."""
    stored = {name: seen[name] for name in ("rewards", "next_states", "ends")}
    case = Memory(Q=np.full(SHAPE, 100.0), **stored, last=seen["known"], now=0, state=0, action=0)
    return swept(case, seen["known"], discount=0.5)


def _compare_memory(
    agent: Any, name: str, right: Any, call: str, pair: tuple[int, int], next_state: int, again: bool
) -> None:
    """Compare a table of what is remembered."""
    table = table_of(agent, name, SHAPE, right.dtype.kind)
    wrong = np.argwhere(~np.isclose(table, right))
    if len(wrong) == 0:
        return
    s, a = (int(index) for index in wrong[0])
    where = "the pair that was tried" if (s, a) == pair else "a pair that was not tried"
    if again:
        hint = "that pair was known already, and then nothing should change"
    elif s == next_state != pair[0]:
        hint = "it is remembered for next_state; what followed belongs to the pair that was tried, [state, action]"
    elif name == "ends":
        hint = "`ends` should be 1 if `terminated`, else 0"
    elif name == "known":
        hint = "a pair is known, 1, as soon as it was tried once"
    else:
        hint = f"`{name}[state, action]` keeps what followed"
    raise WrongAnswer(
        f"after {call}, {name}[{s}, {a}], of {where}, should be {right[s, a]:g}, but is {table[s, a]:g}: {hint}"
    )


def _made(name: str, answer: Any) -> Any:
    """Make the student's agent."""
    given(name, answer)
    if not isinstance(answer, type):
        raise WrongAnswer(f"{name} should be the class, but is of the type {type(answer).__name__}")
    create: Any = getattr(answer, "create", None)
    if create is None:
        raise WrongAnswer(f"{name} should keep its method `create`, which makes a new agent for a shop")
    with running(f"{name}.create(shop)"):
        made = create(Sizes())
    given(f"{name}.create(shop)", made)
    return made


def _with(name: str, agent: Any, settings: Mapping[str, float]) -> Any:
    """Give an agent other settings than its own."""
    for setting in settings:
        if not hasattr(agent, setting):
            raise WrongAnswer(f"{name} should keep its field `{setting}`")
    if hasattr(agent, "_replace"):
        return agent._replace(**settings)
    for setting, value in settings.items():
        setattr(agent, setting, value)
    return agent


def _first_that_fits(mistakes: Mapping[str, Any], fits: Callable[[Any], bool]) -> str:
    """Return the sentence of the mistake that gives what was found in every case."""
    for sentence, change in mistakes.items():
        if fits(change):
            return sentence
    return "that is none of the usual mistakes, so compare your code with the equation, term by term"


def exercise_4(answer: Any, seed: int) -> str:
    """Check the results of three methods, and of one more, on the slippery lake."""
    lake = gymnasium.make("FrozenLake-v1", map_name="4x4", is_slippery=True)
    asked = {
        "environment": "FrozenLake-v1",
        "environment.map_name": "4x4",
        "environment.is_slippery": True,
        "n_steps": LAKE_STEPS,
        "repetitions": 5,
    }
    methods = {label: LEARNED[label] for label in (Q_LEARNING, DYNA_10)}
    results = check_results("lake_results", answer, asked=asked, methods=methods, environment=lake)
    own = [label for label in results.methods if label not in methods]
    if not own:
        raise WrongAnswer("lake_results should have a third method, your own, beside the two of the lesson")
    goals = {label: float(results.curves(label).loc[LAKE_STEPS // 2 :].to_numpy().mean()) for label in results.methods}
    best = max(own, key=lambda label: goals[label])
    shares = ", ".join(f"{label} {share:.2f}" for label, share in goals.items())
    measured = f"Share of evaluation episodes that reach the goal, in the second half of training: {shares}."
    if goals[best] < ENOUGH:
        agent = next(iter(results.complete_agents(best).values()))
        sampled = not getattr(agent, "expected_updates", False) and getattr(agent, "learning_rate", 0.0) == 1.0
        hint = (
            "it has a learning rate of 1 and sampled updates, so that a value is whatever the last outcome said,"
            " however many updates it makes"
            if sampled
            else "let each value average over many outcomes, by expected updates or by a learning rate such as 0.1"
        )
        raise WrongAnswer(f"{best!r} should get {ENOUGH:g} or more: {hint}. {measured}")
    return (
        f"Right. {measured} Chance breaks a rate of 1 with sampled updates: each keeps the last outcome only. Expected"
        " updates, or a lower rate, average over all of them."
    )


CHALLENGE = Challenge(
    environment="Supermarket",
    parameters=MappingProxyType({}),
    n_steps=3_000,
    baselines=MappingProxyType({label: LEARNED[label] for label in (R_MAX, DYNA_10, SWEEPING)}),
    optimum=OPTIMUM,
    best_average=OPTIMUM,
)
"""The open challenge: the highest average return within 3 000 steps. Who knew the shop from the start would get 95."""
