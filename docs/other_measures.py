"""What the score of a profile does not see in three environments, measured for the page of the isolation matrix.

What is earned while learning in Roadrunner, the risk in Golf, and the steps to a good score in Catch.
"""

from functools import partial
from textwrap import fill
from typing import Any

import numpy as np

import edugym
from edugym import (
    DQN,
    SARSA,
    Brightness,
    Hashed,
    Interval,
    QLearning,
    RiskSensitiveQLearning,
    make_mdp,
    mean_interval,
    repeat,
    train,
)
from edugym.experiments.configuration import planned_runs
from edugym.experiments.profiles.ladders import LADDERS, bounds_of, exact_bounds
from edugym.mdp.protocol import Reals
from edugym.training.trainers import trainer
from edugym_course import agent_profiles
from edugym_course.agent_profiles import REPETITIONS
from edugym_course.remedies import gain, shown

DIGITS = 4
CAPACITY = 200_000


def table(mdp: Any) -> Any:
    """The task for a table of what occurs; it shows the same to a table as the task itself, where that fits one."""
    return Hashed.create(mdp, CAPACITY)


STEPS = {ladder.name: ladder.n_steps or 0 for ladder in LADDERS}
PENALTIES = (-10, -30, -100, -300)
"""What a fall costs in Roadrunner."""
GAMES, WORST = 500, 50
"""Games of Golf, and the worst of them that count."""
DARKEST, SIDES = 0.4, (4, 6, 8)
"""The darkest light on Catch, and the sides of its board, in light that changes."""
LIT = "Catch in changing light"
GOLF = {"Golf": RiskSensitiveQLearning.create, "Golf at -5": partial(RiskSensitiveQLearning.create, risk=-5.0)}
"""The remedy for risk, at its default of -1 and stronger."""


def saved_while_learning(penalty: float) -> list[float]:
    """The share of what Q-learning loses while it learns to run that SARSA does not lose, in each repetition."""
    task = make_mdp("Roadrunner", negative_reward=penalty)
    best = exact_bounds(task).best
    losses = []
    for make in (QLearning.create, SARSA.create):
        how: dict[str, Any] = {"repetitions": REPETITIONS, "evaluate_every": 1_000}
        table = repeat(task, {"it": make}, STEPS["Roadrunner"], **how).table
        runs = table[table["episodes"] > 0].groupby("repetition")
        losses.append(np.array([best - np.average(run["training_return"], weights=run["episodes"]) for _, run in runs]))
    careless, careful = losses
    return rounded_list((careless - careful) / careless.mean())


def games(make: Any) -> Reals:
    """The greedy returns of agents on Golf's ladder as scores, shape (n_strengths, n_repetitions, GAMES), ascending."""
    [ladder] = [ladder for ladder in LADDERS if ladder.name == "Golf"]
    played = []
    for strength in ladder.strengths:
        task = ladder.make(strength, layout_seed=0)
        for planned in planned_runs(["it"], REPETITIONS, 0):
            seed, n_steps = planned.repetition.seed, STEPS["Golf"]
            agent = train(task, make(task), n_steps, evaluate_every=n_steps, seed=seed).agent
            player = trainer(task, agent, seed, None, GAMES * n_steps)
            returns: list[float] = []
            while len(returns) < GAMES:
                returns += player.play_episodes(GAMES - len(returns))
            played.append(bounds_of(ladder, strength, 0).score(np.sort(returns)))
    return np.reshape(played, (len(ladder.strengths), REPETITIONS, GAMES))


def sooner() -> list[Any]:
    """The share of the budget that DQN saves on Catch until its score is 0.9, compared with a table.

    Where a run never gets there, it has used all of the budget.
    """
    stored = agent_profiles.load()
    assert stored is not None
    measured = edugym.profile({"table": (QLearning.create, table)}, challenges=["Catch"], repetitions=REPETITIONS)
    shares = []
    for agent, runs in (("table", measured.runs), ("DQN", stored.runs)):
        own = runs[(runs["agent"] == agent) & (runs["challenge"] == "Catch")]
        steps = own.pivot(index="strength", columns="repetition", values="steps_to_0.9")
        shares.append(steps.fillna(STEPS["Catch"]).to_numpy() / STEPS["Catch"])
    return rounded_list(shares[0] - shares[1])


def in_changing_light() -> list[Any]:
    """What DQN gains over a table on Catch where each image has a brightness of its own."""

    def lit(mdp: Any) -> Any:
        return Brightness.create(mdp, DARKEST)

    agents = {"table": (QLearning.create, lambda mdp: table(lit(mdp))), "network": (DQN.create, lit)}
    [ladder] = [ladder._replace(strengths=SIDES) for ladder in LADDERS if ladder.name == "Catch"]
    found = edugym.profile(agents, challenges=[ladder], repetitions=REPETITIONS)
    return rounded_list(found.scores("network", "Catch") - found.scores("table", "Catch"))


def other_measures() -> dict[str, Any]:
    """The gains by other measures, as lists of shape (n_strengths, n_repetitions), by what they are."""
    found: dict[str, Any] = {
        "Roadrunner": [saved_while_learning(penalty) for penalty in PENALTIES],
        "Catch": sooner(),
        LIT: in_changing_light(),
    }
    plain = games(QLearning.create)
    for name, make in GOLF.items():
        averse = games(make)
        found[f"{name}: spread"] = rounded_list(averse.std(axis=2) - plain.std(axis=2))
        found[f"{name}: worst"] = rounded_list((averse - plain)[:, :, :WORST].mean(axis=2))
        found[f"{name}: mean"] = rounded_list((averse - plain).mean(axis=2))
    return found


def rounded_list(numbers: Reals) -> list[Any]:
    """Numbers as they are stored."""
    found: list[Any] = numbers.round(DIGITS).tolist()
    return found


def by_other_measures(others: dict[str, Any]) -> list[str]:
    """What the other measures say, as the lines of a section."""
    road = ", ".join(
        f"{_without_sign(mean_interval(runs), 'saves', 'adds')} at {price}"
        for price, runs in zip(PENALTIES, others["Roadrunner"], strict=True)
    )
    catch = _without_sign(gain(others["Catch"]), "less", "more", last=True)
    lit = ", ".join(f"{shown(mean_interval(runs))} at {side}" for side, runs in zip(SIDES, others[LIT], strict=True))
    golf = [
        f"the spread (standard deviation) changes by {shown(gain(others[f'{name}: spread']))}, the worst tenth by"
        f" {shown(gain(others[f'{name}: worst']))}, and the mean by {shown(gain(others[f'{name}: mean']))}"
        for name in GOLF
    ]
    texts = [
        "The score is the greedy return at the end. In the three environments whose own remedy does not raise it, other"
        " measures say this.",
        "**Roadrunner** is about what an agent earns *while it learns*: SARSA keeps away from where a slip is dear. In"
        f" {STEPS['Roadrunner']:,} steps on the road of the lesson, Q-learning earns less than the best play. Of this"
        f" loss, by the price of a fall, SARSA {road}. So the remedy helps"
        " where a fall is dear, and costs where it is cheap. The ladder makes the road longer, not the fall dearer, and"
        " the score hides what is saved, since random play, which scores 0, falls in most episodes.",
        "**Golf** is about chance, and its remedy about risk, not about the mean. Of the scores of"
        f" {GAMES} greedy games, with the default risk of -1, {golf[0]}. With a risk of -5, {golf[1]}. So the dislike"
        " of single surprises does not make the worst games better on this ladder; a strong one pays for a smaller"
        " spread with a smaller mean.",
        "**Catch** is about observations of many dimensions. To reach a score of 0.9, DQN needs"
        f" {catch} of the budget than the table; even the largest board has only some 8,000 states. A table fails where"
        f" no image comes twice: with another brightness at every step, from {DARKEST} to 1, DQN's score is above"
        f" the table's by {lit} (the side of the board). So the size of the board is not what makes a network"
        " necessary.",
    ]
    return [line for text in texts for line in (fill(text, 120), "")]


def _without_sign(saved: Interval, saves: str, costs: str, last: bool = False) -> str:
    """A share that is saved, or costs, with a word for its sign in front of it, or behind."""
    word, share = saves, saved
    if saved.estimate < 0:
        word, share = costs, saved._replace(estimate=-saved.estimate, low=-saved.high, high=-saved.low)
    number = shown(share).removeprefix("+")
    return f"{number} {word}" if last else f"{word} {number}"
