"""Compares a student's `learn` with the correct rule, on small made-up tables and transitions.

The rule is written once, as a function with keyword arguments. Each usual mistake is the same rule with other arguments
("the mean for the maximum": `backup="mean"`), so what it gives in every case is known. Where the student's tables
differ from the rule's, these explanations are tried in turn, and the first that fits all cases is told:

1. `learn` changes nothing;
2. one mistake;
3. wrong numbers, such as a learning rate, which are computed from what came out (none of them 0);
4. two mistakes together;
5. one mistake, and wrong numbers;
6. wrong numbers, 0 among them;
7. a count that does not grow by one.

If none does, it is said which mistake fits the first case that differs and most of the others, or all those that
differ, or that too many entries change.
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from itertools import combinations
from typing import Any, NamedTuple

import numpy as np

from edugym.checks.contract import learns_from
from edugym_course.grading.agents import table_of
from edugym_course.grading.effects import otherwise_counted
from edugym_course.grading.errors import WrongAnswer, nobody_asks_why
from edugym_course.grading.mistakes import UNUSUAL, what_it_looks_like
from edugym_course.grading.student_code import student_code
from edugym_course.grading.values import TOLERANCE, all_same, differing, digits, in_brackets

Tables = dict[str, Any]
"""The arrays of an agent, by the names of its fields."""

Settings = Mapping[str, Any]


class Transition(NamedTuple):
    """What an agent learns from; the names are those of the parameters of `learn`."""

    state: int
    action: int
    reward: float
    next_state: int
    next_action: int
    terminated: bool
    truncated: bool


class Case(NamedTuple):
    """Tables before learning, and the transitions to learn from, in order."""

    tables: Tables
    transitions: list[Transition]


class Difference(NamedTuple):
    """The first entry of a table that differs from the rule.

    Attributes:
        case: the number of the case.
        step: the number of the transition in it.
        table: the name of the table.
        entry: the index of the entry.
    """

    case: int
    step: int
    table: str
    entry: tuple[int, ...]


SHARES = frozenset({"learning_rate", "value_learning_rate", "discount", "target_epsilon"})
"""Settings that lie between 0 and 1, the wrong ones of students as well."""
NEWTON_STEPS = 8  # Gauss-Newton iterations; enough, since rules are products of few numbers

Outcomes = list[list[Tables]]
"""The tables after every transition of every case."""


@dataclass(frozen=True)
class Update:
    """An update rule with the mistakes that are usually made in it.

    Attributes:
        rule: changes tables in place: `rule(tables, transition, **settings)`.
        tables: makes tables up: `tables(n_states, n_actions, rng)`. Take simple numbers, so that a student can follow a
            case by hand, and include negative values, and counts that are 0 and more.
        mistakes: maps the sentence shown to the student to the settings that reproduce the mistake.
        numbers: the settings that are numbers, each with what to say of a wrong one, with {found} and {right} in it.
        together: what to say of the wrong ones, given them and the right settings; "" is to say what `numbers` says.
    """

    rule: Callable[..., None]
    tables: Callable[[int, int, np.random.Generator], Tables]
    mistakes: Mapping[str, Settings]
    numbers: Mapping[str, str]
    together: Callable[[Mapping[str, float], Settings], str] = lambda wrong, settings: ""

    def check(self, make: Callable[[], Any], size: tuple[int, int], settings: Settings, seed: int) -> None:
        """Check the `learn` of an agent.

        Args:
            make: makes the student's agent.
            size: the numbers of states and actions of its tables; 4 states or more.
            settings: the right settings of the rule.
            seed: the number from which the cases are drawn.

        Raises:
            WrongAnswer: it does something else than the rule.
        """
        cases = self.cases(size, seed)
        right = self.outcomes(cases, settings)
        found, names, returned = _run_student(make, cases)
        difference = _first_difference(right, found)
        if difference is not None:
            if nobody_asks_why():  # to find the mistake takes longer than to see that there is one
                raise WrongAnswer(UNUSUAL)
            why = self._diagnosis(cases, right, found, settings, difference, returned)
            if why == UNUSUAL:
                why = self._effects(make, cases, found, settings, difference) or UNUSUAL
            if _first_difference(found, _run_student(make, cases)[0]) is not None:
                why = "a second time it gives something else: `learn` needs no random numbers"
            numbers = {name: settings[name] for name in self.numbers}
            raise WrongAnswer(f"{_describe(cases, right, found, difference, names, numbers)}: {why}")

    def cases(self, size: tuple[int, int], seed: int) -> list[Case]:
        """Make cases up: ordinary steps, ends, cut-off episodes, steps that stay in their state, steps taken twice."""
        rng = np.random.default_rng(seed)
        return [Case(self.tables(*size, rng), steps) for _ in range(4) for steps in _transitions(*size, rng)]

    def outcomes(self, cases: list[Case], settings: Settings) -> Outcomes:
        """Return what the rule makes of every case."""
        return [list(self._outcome(case, settings)) for case in cases]

    def _outcome(self, case: Case, settings: Settings) -> Iterator[Tables]:
        tables = {name: values.copy() for name, values in case.tables.items()}
        with np.errstate(all="ignore"):
            for transition in case.transitions:
                self.rule(tables, transition, **settings)
                yield {name: values.copy() for name, values in tables.items()}

    def _diagnosis(
        self,
        cases: list[Case],
        right: Outcomes,
        found: Outcomes,
        settings: Settings,
        difference: Difference,
        returned: bool,
    ) -> str:
        """Return the sentence about the mistake that fits."""
        before = [[case.tables] * len(case.transitions) for case in cases]
        if _first_difference(before, found) is None:
            hint = "; it returns something instead, which nobody reads" if returned else ""
            return f"`learn` changes no table at all{hint}"
        singles = {sentence: dict(change) for sentence, change in self.mistakes.items()}
        for sentence, change in singles.items():
            if self._fits(cases, found, {**settings, **change}):
                return sentence
        wrong = self._numbers_that_fit(cases, found, settings)
        if wrong and all(wrong.values()):  # a fitted 0 means a missing term: prefer a named mistake, tried below
            return self._describe_numbers(wrong, settings)
        for (one, first), (two, second) in combinations(singles.items(), 2):
            if not first.keys() & second.keys() and self._fits(cases, found, {**settings, **first, **second}):
                return f"{one}; and {two}"
        for sentence, change in singles.items():
            if other := self._numbers_that_fit(cases, found, {**settings, **change}):
                return f"{sentence}; and {self._describe_numbers(other, settings)}"
        if wrong:
            return self._describe_numbers(wrong, settings)
        if counted := _miscounted(cases, right, found, difference):
            return counted
        student, expected = (outcomes[difference.case][difference.step] for outcomes in (found, right))
        is_wrong = [not all(map(_agree, *outcomes)) for outcomes in zip(right, found, strict=True)]
        tried = {why: [*self._explained(cases, found, {**settings, **change})] for why, change in singles.items()}
        if likely := what_it_looks_like(tried, is_wrong):
            return likely
        before = _before(cases, found, difference)[difference.table]
        changed, right_ones = (differing(before, after[difference.table]).tolist() for after in (student, expected))
        if len(changed) > len(right_ones):
            return f"{len(changed)} entries of `{difference.table}` change, and only one should"
        if len(changed) == len(right_ones) == 1 and changed != right_ones:
            moved, entry = (", ".join(map(str, one[0])) for one in (changed, right_ones))
            name = difference.table
            return f"another entry changes than should, {name}[{moved}] and not {name}[{entry}]"
        return UNUSUAL

    def _effects(
        self, make: Callable[[], Any], cases: list[Case], found: Outcomes, settings: Settings, difference: Difference
    ) -> str:
        """Return which number counts otherwise than it should in the entry that differs first."""
        before, now = _before(cases, found, difference), cases[difference.case].transitions[difference.step]

        def by_the_rule(tables: Tables, reward: float) -> float:
            (after,) = self._outcome(Case(tables, [now._replace(reward=reward)]), settings)
            return float(after[difference.table][difference.entry])

        def by_the_answer(tables: Tables, reward: float) -> float:
            (((after,),), _, _) = _run_student(make, [Case(tables, [now._replace(reward=reward)])])
            return float(after[difference.table][difference.entry])

        return otherwise_counted(before, now.reward, by_the_rule, by_the_answer)

    def _fits(self, cases: list[Case], found: Outcomes, settings: Settings) -> bool:
        """Whether the rule with these settings does what the answer does, in every case."""
        return all(self._explains(case, tables, settings) for case, tables in zip(cases, found, strict=True))

    def _explained(self, cases: list[Case], found: Outcomes, settings: Settings) -> list[bool]:
        """Return for each case whether the rule with these settings does what the answer does."""
        return [self._explains(case, tables, settings) for case, tables in zip(cases, found, strict=True)]

    def _explains(self, case: Case, found: list[Tables], settings: Settings) -> bool:
        return all(map(_agree, self._outcome(case, settings), found))

    def _numbers_that_fit(self, cases: list[Case], found: Outcomes, settings: Settings) -> dict[str, float]:
        """Return the numbers that are wrong (a learning rate, a discount) if those explain it all; else none.

        Gauss and Newton's method fits them to the first transition of every case; what it finds must fit all others.
        """
        firsts = [Case(case.tables, case.transitions[:1]) for case in cases]
        student = _entries([steps[:1] for steps in found])
        right = np.array([settings[name] for name in self.numbers], float)
        numbers = right.copy()
        for _ in range(NEWTON_STEPS):
            points = [numbers, *(numbers + row for row in np.eye(len(numbers)))]
            at, *beside = (
                _entries(self.outcomes(firsts, {**settings, **dict(zip(self.numbers, map(float, point), strict=True))}))
                for point in points
            )
            if not all(np.isfinite(entries).all() for entries in (student, at, *beside)):
                return {}
            slopes = np.array(beside).T - at[:, np.newaxis]
            step = np.linalg.lstsq(slopes, student - at, rcond=None)[0]
            numbers = numbers + step
            if np.abs(step).max(initial=0.0) < TOLERANCE:
                break
        numbers = np.where(np.abs(numbers - numbers.round(6)) < 1e-8, numbers.round(6), numbers)
        fitted = dict(zip(self.numbers, map(float, numbers), strict=True))
        if any(not 0 <= value <= 1 for name, value in fitted.items() if name in SHARES):
            return {}  # nobody writes a discount of 2.8: the fit is an accident
        wrong = {name: value for name, value in fitted.items() if value != settings[name]}
        return wrong if self._fits(cases, found, {**settings, **fitted}) else {}

    def _describe_numbers(self, wrong: Mapping[str, float], settings: Settings) -> str:
        return self.together(wrong, settings) or "; and ".join(
            self.numbers[name].format(found=value, right=settings[name]) for name, value in wrong.items()
        )


def _miscounted(cases: list[Case], right: Outcomes, found: Outcomes, difference: Difference) -> str:
    """Return what is wrong with a count that should have grown by one, or ""."""
    case, step, table, entry = difference
    before = _before(cases, found, difference)[table]
    if before.dtype.kind != "i" or right[case][step][table][entry] != before[entry] + 1:
        return ""
    now = found[case][step][table][entry]
    counted = [right[k][0][table] != cases[k].tables[table] for k in range(len(cases))]
    if all((found[k][0][table][grows] == 1).all() for k, grows in enumerate(counted)):
        return f"`{table}` is set to 1 there, and it should become one more: write `+= 1`"
    if now == before[entry]:
        return f"`{table}` does not change there, and every time it should be one more"
    return f"`{table}` changes by {now - before[entry]:+g} there, and every time it should be one more"


def _before(cases: list[Case], found: Outcomes, difference: Difference) -> Tables:
    """Return the tables of the answer before the transition that made the difference."""
    return found[difference.case][difference.step - 1] if difference.step else cases[difference.case].tables


def _entries(outcomes: Outcomes) -> Any:
    """Return all entries of all tables in one row."""
    return np.concatenate(
        [np.ravel(values).astype(float) for steps in outcomes for tables in steps for values in tables.values()]
    )


def _transitions(n_states: int, n_actions: int, rng: np.random.Generator) -> Iterator[list[Transition]]:
    """Yield the transitions of cases of every kind."""

    def draw(stays: bool = False, **end: bool) -> Transition:
        state, other = map(int, rng.choice(n_states, 2, replace=False))
        action, next_action = (int(rng.integers(n_actions)) for _ in range(2))
        reward = float(rng.choice([-2.0, -1.0, 1.0, 2.0, 3.0]))
        ends = {"terminated": False, "truncated": False} | end
        return Transition(state, action, reward, state if stays else other, next_action, **ends)

    ordinary, again = draw(), draw()
    yield [ordinary]
    yield [draw(terminated=True)]
    yield [draw(truncated=True)]
    yield [draw(stays=True)]
    yield [again, again, again._replace(reward=0.0)]
    yield [draw(), draw(), draw(truncated=True), draw(terminated=True)]


def _run_student(make: Callable[[], Any], cases: list[Case]) -> tuple[Outcomes, tuple[str, ...], bool]:
    """Run the student's `learn` on every case.

    Returns:
        What came out, the parameters that `learn` takes, and whether it ever returned something.
    """
    outcomes: Outcomes = []
    names: tuple[str, ...] = ()
    returned = False
    for case in cases:
        agent = make()
        try:
            names = learns_from(agent)
        except ValueError as error:
            raise WrongAnswer(str(error)) from None
        for table, values in case.tables.items():
            table_of(agent, table, values.shape, values.dtype.kind)[...] = values
        after: list[Tables] = []
        for transition in case.transitions:
            told = {name: getattr(transition, name) for name in names}
            with student_code(f"learn({_arguments(told)})"):
                returned = agent.learn(**told) is not None or returned
            after.append(
                {
                    table: table_of(agent, table, values.shape, values.dtype.kind).copy()
                    for table, values in case.tables.items()
                }
            )
        outcomes.append(after)
    return outcomes, names, returned


def _first_difference(right: Outcomes, found: Outcomes) -> Difference | None:
    """Return the first entry in which two outcomes differ."""
    for case, (steps, student) in enumerate(zip(right, found, strict=True)):
        for step, (tables, student_tables) in enumerate(zip(steps, student, strict=True)):
            for name, values in tables.items():
                wrong = differing(values, student_tables[name])
                if len(wrong):
                    return Difference(case, step, name, tuple(map(int, wrong[0])))
    return None


def _agree(one: Tables, other: Tables) -> bool:
    return all(all_same(values, other[name]) for name, values in one.items())


def _describe(
    cases: list[Case],
    right: Outcomes,
    found: Outcomes,
    difference: Difference,
    names: tuple[str, ...],
    numbers: Settings,
) -> str:
    """Return the first part of the sentence: what was expected in which case, and what came.

    For a value it gives all that is needed to follow the case by hand; for a count the call is enough.
    """
    number, step, table, entry = difference
    before = right[number][step - 1] if step else cases[number].tables
    now = cases[number].transitions[step]
    old, expected, student = (
        float(tables[table][entry]) for tables in (before, right[number][step], found[number][step])
    )
    known = [f"{name} = {value:g}" for name, value in numbers.items()]
    known += [
        f"{name}[{now.next_state}] = {_short(values[now.next_state])}"
        for name, values in before.items()
        if values.ndim == 1 or values.dtype.kind == "f"
    ]
    where = f" where {', '.join(known)}," if before[table].dtype.kind == "f" else ""
    should = (
        f"go from {digits(old, student)} to {digits(expected, student)}"
        if expected != old
        else f"stay {digits(old, student)}"
    )
    call = f"learn({_arguments({name: getattr(now, name) for name in names})})"
    index = ", ".join(map(str, entry))
    return f"after {call},{where} {table}[{index}] should {should}, but is {digits(student, expected)}"


def _short(values: Any) -> str:
    return in_brackets(values) if np.ndim(values) else f"{values:.4g}"


def _arguments(told: Settings) -> str:
    return ", ".join(
        f"{name}={value:g}" if isinstance(value, float) else f"{name}={value}" for name, value in told.items()
    )
