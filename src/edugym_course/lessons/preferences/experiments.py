"""Preferences (lesson 14): rewards that are learned from comparisons, and what comes of following them too far.

A teacher compares pairs of nights on the morning of lesson 10, and prefers the better one with the probability of
Bradley and Terry, noise 1. They are nights of the reference policy: half of the time the best action, half of the time
a random one. A table of rewards is fitted to 100 comparisons (prior 0.1), and followed with penalties β from 30 to 0
for leaving the reference. All returns are exact, at discount 1; gains are over the reference policy. 100 repetitions,
with other nights and other preferences; a fifth of them with 3 000 comparisons, and 30 of Q-learning. Beside
the lesson's morning there are one of 12 steps, and one in which a ring costs 2 and oversleeping 20.
"""

from collections.abc import Mapping
from typing import Any

import numpy as np

from edugym.agents.q_learning import QLearning
from edugym.exact.policies import policy_of
from edugym.exact.policy_evaluation import policy_evaluation
from edugym.exact.regularised import with_rewards
from edugym.experiments.results.claims import Above, Below, Claim, Within
from edugym.experiments.results.statistics import mean_interval, paired_difference
from edugym.mdp.protocol import Reals
from edugym.training.train import train
from edugym_course.lessons.own_problem.morning import Morning
from edugym_course.lessons.preferences.figures import gains
from edugym_course.lessons.preferences.methods import (
    MODEST,
    N_COMPARISONS,
    NOISE,
    PRIOR,
    REPETITIONS,
    Followed,
    followed,
    half_right,
    learned_reward,
    learned_rewards,
    model_of,
    tuned,
)
from edugym_course.report import Report
from edugym_course.reporting import SharedArguments, reporting

MORNINGS: Mapping[str, Morning] = {
    "the lesson's morning": Morning(),
    "a morning of 12 steps": Morning(length=12),
    "a morning with rings at 2 and oversleeping at 20": Morning(ring=2.0, late=20.0),
}
MANY = 3_000
ROUNDS = 4
ENDS = (MODEST, 0.0)
"""The two penalties that are compared."""
BASE, SURE, MORE, RANDOM, IN_ROUNDS = "base", "sure", "more", "random", "rounds"
CHANGES: Mapping[str, dict[str, Any]] = {
    BASE: {},
    SURE: {"noise": 0.0},
    MORE: {"n_comparisons": MANY},
    RANDOM: {"at_random": True},
    IN_ROUNDS: {"rounds": ROUNDS},
}
OF_AGENTS = 30
"""How many runs of Q-learning follow rewards that were learned."""
AGENT_STEPS = 100_000

Found = Mapping[str, Mapping[str, Followed]]


def measure(how: SharedArguments) -> tuple[Any, ...]:
    """Run the experiments."""
    shared = {name: how.shared[name] for name in ("repetitions", "seed", "stop")}
    few = {**shared, "repetitions": max(2, how.repetitions // 5)}  # runs of many comparisons are much alike
    whole = {
        f"{N_COMPARISONS} comparisons": followed(**shared),
        f"{MANY} comparisons": followed(n_comparisons=MANY, **few),
    }
    found = {
        name: {
            change: followed(mdp, penalties=ENDS, **settings, **(few if change == MORE else shared))
            for change, settings in CHANGES.items()
        }
        for name, mdp in MORNINGS.items()
    }
    agents = q_learning_follows(min(OF_AGENTS, how.repetitions), how.shared["seed"], how.shared["stop"])
    return whole, found, agents


def q_learning_follows(repetitions: int, seed: int, stop: Any = None) -> Reals:
    """Let Q-learning follow learned rewards, and compare with planning.

    Returns:
        By run, the learned return of its greedy policy and that of the best policy, and the same two as they are meant:
        shape (4, repetitions).
    """
    mdp, model = Morning(), model_of(Morning())
    rows = []
    for child in np.random.SeedSequence(seed).spawn(repetitions):
        if stop is not None and stop.is_set():
            break
        rewards = learned_rewards(mdp, N_COMPARISONS, NOISE, PRIOR, np.random.default_rng(child))
        learned, task = with_rewards(model, rewards), learned_reward(mdp, rewards)
        agent = QLearning.create(task, learning_rate=0.1, discount=1.0)
        run = train(task, agent, AGENT_STEPS, seed=int(child.generate_state(1)[0]))
        policies = policy_of(run.agent, model, greedy=True), tuned(learned, half_right(mdp), 0.0)
        rows.append([policy_evaluation(judge, policy).start for judge in (learned, model) for policy in policies])
    return np.array(rows).reshape(-1, 4).T


def judge(whole: Mapping[str, Followed], found: Found, agents: Reals) -> Report:
    """Return claims and figures."""
    claims = [claim for name, by_change in found.items() for claim in claims_on(name, by_change)]
    return Report([*claims, *agent_claims(agents)], [gains(whole, second=True)])


report = reporting(measure, judge, REPETITIONS)
"""Run the experiments of the lesson (see `edugym_course.reporting.Reporter`)."""


def falls(name: str) -> str:
    """Return the claim that a learned reward can be followed too far."""
    return f"On {name}, 100 comparisons followed without a penalty gain less than with a penalty of {MODEST:g}"


def enough(name: str) -> str:
    """Return the claim that more comparisons cure it."""
    return f"On {name}, {MANY} comparisons followed without a penalty gain more"


def overrated(name: str) -> str:
    """Return the claim that the reward that was followed promises more than one of other comparisons."""
    return f"On {name}, the reward that was followed promises more than one that was learned from other comparisons"


def claims_on(name: str, by_change: Mapping[str, Followed]) -> list[Claim]:
    """Return the claims on one morning."""
    base, sure, more, random, rounds = by_change.values()
    fall = f"meant return with a penalty of {MODEST:g} less that without one"
    promised = "gain of the policy without a penalty, by the reward that it follows, less that by the other"
    return [
        Claim(
            falls(name),
            fall,
            mean_interval(base.fall()),
            Above(0.2),
            "whoever maximises a reward with errors looks for the errors that promise most",
            (enough(name), overrated(name)),
        ),
        Claim(
            f"On {name}, the learned return rises meanwhile",
            "learned return without a penalty less that with one",
            paired_difference(base.learned[1], base.learned[0]),
            Above(0.3),
        ),
        Claim(
            overrated(name),
            promised,
            paired_difference(base.learned[1], base.second[1]),
            Above(2.0),
        ),
        Claim(
            f"On {name}, after {MANY} comparisons it hardly does",
            promised,
            paired_difference(more.learned[1], more.second[1]),
            Within(-0.5, 0.5),
        ),
        Claim(enough(name), fall, mean_interval(more.fall()), Below(-0.2)),
        Claim(
            f"On {name}, a teacher who is never wrong does not cure it",
            fall,
            mean_interval(sure.fall()),
            Above(0.2),
            remark="So the errors of the teacher are not the reason.",
        ),
        Claim(
            f"On {name}, comparing nights of random actions does not cure it",
            fall,
            mean_interval(random.fall()),
            Above(0.2),
            remark="There every action is compared as often. So rare actions are not the reason.",
        ),
        Claim(
            f"On {name}, 100 comparisons in {ROUNDS} rounds gain more than all at once",
            f"meant return with a penalty of {MODEST:g}, less that of one round",
            paired_difference(rounds.at(MODEST), base.at(MODEST)),
            Above(0.3),
        ),
    ]


def agent_claims(agents: Reals) -> list[Claim]:
    """Return the claims on Q-learning with a learned reward."""
    learned, best, meant, planned = agents
    return [
        Claim(
            f"Q-learning with a learned reward comes close to the best learned return in {AGENT_STEPS} steps",
            "learned return of its greedy policy less the best",
            paired_difference(learned, best),
            Above(-0.5),
        ),
        Claim(
            "What it gains as it is meant is that of planning",
            "meant return of its greedy policy less that of planning on the same reward",
            paired_difference(meant, planned),
            Within(-1.0, 1.0),
        ),
    ]
