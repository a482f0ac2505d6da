"""Several agents (lesson 13): players who learn against each other in matrix games and in soccer.

All players have ε = 0.2 and first values of 1, and a learning rate that falls from 1 to 0.01, as in Littman (1994);
fictitious play has the constant 0.1. They train for 1 000 000 steps in soccer, with discount 0.9 or 0.8 and contact 1
or 0.5, and in turns; for 300 000 without contact, and for 10 000 in matrix games. 5 repetitions, and twice as many in
matrix games; the seeds are the same for every kind of player. Exploitability is computed exactly from what they have
learned, six times in each run. How often best actions change is counted with Q-learning of a constant learning rate of
0.01 and ε = 0.1, in the second half of 10 000 steps. What pairs choose in the prisoner's dilemma where no action is
best whatever the other does is counted after 1 000 games; 20 times as many repetitions.
"""

from collections.abc import Iterator, Mapping
from itertools import product
from typing import Any

import numpy as np

from edugym.exact.game_model import exploitability
from edugym.experiments.figures.sheet import Sheet, in_pairs
from edugym.experiments.results.claims import Above, Below, Claim, Within
from edugym.experiments.results.statistics import exactly, mean_interval
from edugym.experiments.results.tables import Results
from edugym.training.learned_policy import learned_policy
from edugym_course.lessons.several_agents.figures import exploited, learning
from edugym_course.lessons.several_agents.methods import (
    ALONE,
    BOTH,
    DISCOUNT,
    DOMINANT,
    FICTITIOUS,
    IN_TURNS,
    LEARNERS,
    MINIMAX,
    N_CONTROL,
    N_MATRIX,
    N_STEPS,
    NO_SAFE_ACTION,
    REPETITIONS,
    TAUGHT,
    TOLD,
    against_each_other,
    blind_to_contact,
    can_lose,
    changes,
    choosing,
    compare,
    dilemma,
    in_turns,
    independent,
    losses,
    matrix,
    random_states,
    soccer,
    taught,
    with_best_answers,
)
from edugym_course.report import Report
from edugym_course.reporting import SharedArguments, reporting

SETTINGS: Mapping[str, tuple[float, float]] = {
    "soccer": (1.0, DISCOUNT),
    "soccer with contact 0.5": (0.5, DISCOUNT),
    "soccer with discount 0.8": (1.0, 0.8),
}
"""By name the contact and the discount: the lesson's setting, and two others."""
NO_CONTACT = "soccer without contact"
TURNS: Mapping[str, tuple[float, float]] = {
    "soccer in turns": (1.0, DISCOUNT),
    "soccer in turns with contact 0.5": (0.5, DISCOUNT),
    "soccer in turns with discount 0.8": (1.0, 0.8),
}
"""The same where the players move one after the other: there no state needs a random choice."""
TORN = (2.0, 2.5, 3.0)
"""Temptations at which nobody gains by talking if the other is silent."""
NEAR = 0.6
"""A discount with which the future counts little."""
LATE = 3
"""How many points, the last ones, count as the end of a matrix game."""


def measure(how: SharedArguments) -> tuple[Any, ...]:
    """Run the experiments."""
    twice: dict[str, Any] = {"repetitions": 2 * how.repetitions}  # they are quick
    stop, seeds = how.shared["stop"], range(how.shared["seed"], how.shared["seed"] + how.repetitions)
    by_matrix, by_field, changed = dict[str, Results](), dict[str, Results](), dict[str, dict[bool, list[float]]]()
    for i, name in enumerate((*NO_SAFE_ACTION, *DOMINANT)):
        if not stop.is_set():
            by_matrix[name] = compare(matrix(name), LEARNERS, N_MATRIX, **how(f"matrix_{i}", **twice))
    for name in NO_SAFE_ACTION:
        if not stop.is_set():
            runs = ((learns, seed) for learns, seed in product((True, False), seeds))
            found: dict[bool, list[float]] = {True: [], False: []}
            for learns, seed in runs:
                found[learns].append(changes(against_each_other(name, learns=learns, seed=seed)))
            changed[name] = found
    for i, (name, (contact, discount)) in enumerate(SETTINGS.items()):
        if not stop.is_set():
            learners = BOTH if i else LEARNERS
            by_field[name] = compare(soccer(contact), learners, N_STEPS, discount=discount, **how(f"soccer_{i}"))
    if stop.is_set():
        return ()
    many: dict[str, Any] = {"repetitions": 20 * how.repetitions}
    torn = {one: dilemma(one, **how(f"dilemma_{i}", **many)) for i, one in enumerate(TORN)}
    near = compare(soccer(), {ALONE: independent}, N_STEPS, discount=NEAR, **how("near"))
    control = compare(soccer(0.0), BOTH, N_CONTROL, **how("no_contact"))
    lesson = compare(soccer(), {TAUGHT: taught}, N_STEPS, measure=losses, **how("taught"))
    by_turns = {
        name: compare(in_turns(contact), IN_TURNS, N_STEPS, discount=discount, **how(f"turns_{i}"))
        for i, (name, (contact, discount)) in enumerate(TURNS.items())
    }
    return by_matrix, by_field, changed, control, lesson, by_turns, torn, near


def judge(
    by_matrix: Mapping[str, Results],
    by_field: Mapping[str, Results],
    changed: Mapping[str, Mapping[bool, list[float]]],
    control: Results,
    lesson: Results,
    by_turns: Mapping[str, Results],
    torn: Mapping[float, Results],
    near: Results,
) -> Report:
    """Return claims and figures."""
    claims = [
        *exact_claims(),
        *matrix_claims(by_matrix),
        *change_claims(changed),
        *soccer_claims(by_field, control, lesson),
        *pupil_claims(lesson),
        *turn_claims(by_turns),
        *torn_claims(torn),
        near_claim(near),
    ]
    return Report(claims, figures(by_matrix, {**by_field, NO_CONTACT: control, **by_turns}, lesson))


report = reporting(measure, judge, REPETITIONS)
"""Run the experiments of the lesson (see `edugym_course.reporting.Reporter`)."""


def exploitable(name: str) -> str:
    """Return the claim that two who learn as if alone are exploitable in a matrix game."""
    return f"Two Q-learners in {name} are exploitable by 0.9 or more"


def harmless(name: str) -> str:
    """Return the claim that they are not where one action is best whatever the other does."""
    return f"Two Q-learners in the {name} end in the equilibrium"


def unlike(name: str) -> str:
    """Return the claim that minimax Q-learning does better in soccer."""
    return f"In {name} two Q-learners are more exploitable than two minimax Q-learners"


RANDOM_STATES = "In 56 states of soccer every action by itself guarantees less than a random choice"
NO_RANDOM_STATES = "Without contact there is no such state"
NONE_IN_TURNS = "In soccer in turns there is no such state"
TAUGHT_TOO = "A Q-learner whose opponent plays a safe policy and never learns can be beaten by 0.3 or more"


def unharmed(name: str) -> str:
    """Return the claim that learning alone does no harm where the players move in turns."""
    return f"In {name} two Q-learners are exploitable by less than 0.1"


def pure_pairs(name: str) -> list[float]:
    """Return the exploitability of every pair of policies without chance, computed."""
    game, model = matrix(name)
    n = game.action_space(0).n
    return [exploitability(model, (np.eye(n)[[a]], np.eye(n)[[b]])) for a, b in product(range(n), repeat=2)]


def exact_claims() -> Iterator[Claim]:
    """Yield what is computed and not learned."""
    for name in NO_SAFE_ACTION:
        found = pure_pairs(name)
        quantity = "exploitability of the least exploitable pair, computed"
        statement = f"In {name} every pair of policies without chance is exploitable by 1 or more"
        yield Claim(statement, quantity, exactly(min(found)), Above(1 - 1e-9))
    for name in DOMINANT:
        found = pure_pairs(name)
        statement = f"In the {name} the pair in which both talk is an equilibrium"
        yield Claim(statement, "exploitability, computed", exactly(found[-1]), Within(0.0, 1e-9))
    for statement, known, states in (
        (RANDOM_STATES, soccer(), 56),
        (NO_RANDOM_STATES, soccer(0.0), 0),
        (NONE_IN_TURNS, in_turns(), 0),
    ):
        yield Claim(statement, "states, computed", exactly(random_states(known)), Within(states, states))
    yield Claim(
        "In soccer in turns two who play as if there were no contact are exploitable by 0.3 or more",
        "exploitability, computed",
        exactly(blind_to_contact()),
        Above(0.3),
        remark="So the other matters there, as it does in soccer.",
    )


def matrix_claims(by_matrix: Mapping[str, Results]) -> Iterator[Claim]:
    """Yield the claims on matrix games."""
    quantity = f"exploitability, last {LATE} points of {N_MATRIX} steps"
    for name in NO_SAFE_ACTION:
        results = by_matrix[name]
        yield Claim(
            exploitable(name),
            quantity,
            mean_interval(results.late(ALONE, LATE)),
            Above(0.9),
            "no pair of policies without chance is an equilibrium there, and a Q-learner's policy is without chance",
            (*map(harmless, DOMINANT), f"Two minimax Q-learners in {name} end in the equilibrium"),
        )
        for method in (MINIMAX, FICTITIOUS):
            statement = {
                MINIMAX: f"Two minimax Q-learners in {name} end in the equilibrium",
                FICTITIOUS: f"The average play of two fictitious players in {name} comes close to the equilibrium",
            }[method]
            yield Claim(statement, quantity, mean_interval(results.late(method, LATE)), Below(0.05))
    for name in DOMINANT:
        yield Claim(harmless(name), quantity, mean_interval(by_matrix[name].late(ALONE, LATE)), Below(0.05))


def change_claims(changed: Mapping[str, Mapping[bool, list[float]]]) -> Iterator[Claim]:
    """Yield the claims on how often a Q-learner's best action changes."""
    quantity = "changes of the best action in 1 000 steps, in the second half of training"
    for name, found in changed.items():
        yield Claim(
            f"In {name} the best action of a Q-learner goes on changing while the other learns too",
            quantity,
            mean_interval(found[True]),
            Above(0.5),
            "the other learns, and with what it does the best answer changes",
            tuple(map(settled, changed)),
        )
        yield Claim(settled(name), quantity, mean_interval(found[False]), Below(0.2))


def settled(name: str) -> str:
    """Return the claim that against a player who never learns it comes to rest."""
    return f"In {name} it comes to rest against a player who never learns"


def soccer_claims(by_field: Mapping[str, Results], control: Results, lesson: Results) -> Iterator[Claim]:
    """Yield the claims on soccer: the lesson's setting, two others, no contact, and a safe opponent."""
    for name, results in by_field.items():
        quantity = f"exploitability after {N_STEPS} steps"
        statement = f"In {name} two minimax Q-learners are exploitable by less than 0.1"
        yield Claim(statement, quantity, mean_interval(results.final(MINIMAX)), Below(0.1))
        yield Claim(
            unlike(name),
            f"{quantity}, Q-learning less minimax Q-learning",
            results.difference(ALONE, MINIMAX),
            Above(0.03),
            "some states need a random choice, and a Q-learner has no other policy than its best action",
            (RANDOM_STATES, NONE_IN_TURNS, *map(unharmed, TURNS), TAUGHT_TOO),
        )
    quantity = f"exploitability after {N_CONTROL} steps"
    statement = f"In {NO_CONTACT} two Q-learners are exploitable by less than 0.02"
    yield Claim(statement, quantity, mean_interval(control.final(ALONE)), Below(0.02))
    statement = f"In {NO_CONTACT} two minimax Q-learners are, too"
    yield Claim(statement, quantity, mean_interval(control.final(MINIMAX)), Below(0.02))
    yield Claim(
        TAUGHT_TOO,
        f"what its best opponent wins from it after {N_STEPS} steps",
        mean_interval(lesson.final(TAUGHT)),
        Above(0.3),
        remark="So it is not only that the other learns: here nobody else does.",
    )
    yield Claim(
        "In soccer the average play of two fictitious players is still exploitable by 0.2 or more",
        f"exploitability after {N_STEPS} steps",
        mean_interval(by_field["soccer"].final(FICTITIOUS)),
        Above(0.2),
    )


def pupil_claims(lesson: Results) -> Iterator[Claim]:
    """Yield the claims on what makes one weak who has learned from a safe opponent."""
    known = soccer()
    pupils = [learned_policy(known.game, 0, players[0]) for players in lesson.agents[TAUGHT].values()]
    shares, corrected = zip(*(with_best_answers(known, pupil) for pupil in pupils), strict=True)
    yield Claim(
        "In a third of the states or more such a Q-learner takes no best answer to this opponent",
        "share of the states, computed from what it has learned",
        mean_interval([1 - share for share in shares]),
        Above(1 / 3),
    )
    yield Claim(
        "With best answers there, too, it can be beaten by less than 0.25",
        "what its best opponent wins from it then, computed",
        mean_interval([can_lose(known, 0, policy) for policy in corrected]),
        Below(0.25),
    )


def turn_claims(by_turns: Mapping[str, Results]) -> Iterator[Claim]:
    """Yield the claims on soccer in turns."""
    for name, results in by_turns.items():
        quantity = f"exploitability after {N_STEPS} steps"
        yield Claim(unharmed(name), quantity, mean_interval(results.final(ALONE)), Below(0.1))
        yield Claim(
            f"In {name} they are not more exploitable than two minimax Q-learners",
            f"{quantity}, Q-learning less minimax Q-learning",
            results.difference(ALONE, MINIMAX),
            Below(0.01),
        )
        yield Claim(
            f"In {name} minimax Q-learning that is told whose action counts is less exploitable than without",
            f"{quantity}, minimax Q-learning told less minimax Q-learning",
            results.difference(TOLD, MINIMAX),
            Below(-0.01),
            remark="What it learns is shared by five values; without, each of them is learned by itself.",
        )


def torn_claims(torn: Mapping[float, Results]) -> Iterator[Claim]:
    """Yield the claims on the prisoner's dilemma with two equilibria without chance."""
    for temptation, results in torn.items():
        yield Claim(
            f"In the prisoner's dilemma with temptation {temptation:g} most pairs of Q-learners, not all, talk",
            "share of pairs of which both talk after 1 000 games",
            mean_interval(choosing(results, 1)),
            Within(0.5, 0.97),
        )


def near_claim(near: Results) -> Claim:
    """Return the claim on soccer where the future counts little."""
    return Claim(
        f"In soccer with discount {NEAR:g} little can be won from two Q-learners",
        f"exploitability after {N_STEPS} steps",
        mean_interval(near.final(ALONE)),
        Below(0.1),
    )


def figures(by_matrix: Mapping[str, Results], by_field: Mapping[str, Results], lesson: Results) -> list[Sheet]:
    """Return the figures: exploitability while they learn."""
    return [
        learning({name: by_matrix[name] for name in (*NO_SAFE_ACTION, *DOMINANT)}, top=2.0, name="matrix_games"),
        learning(by_field, name="soccer"),
        in_pairs("taught", [exploited(lesson, "against a safe policy", label="what its best opponent wins")]),
    ]


def warm_up() -> None:
    """Compile what the lesson needs: a few steps of everything."""
    few: dict[str, Any] = {"repetitions": 1, "points": 1}
    for known in (matrix("rock-paper-scissors"), soccer()):
        compare(known, LEARNERS, 6_000, **few)
    compare(soccer(), {TAUGHT: taught}, 6_000, **few)
