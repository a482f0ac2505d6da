"""The amount of signal (lesson 6): what a toy says about its need, and how much of it players and Q-learning use.

On Tamagotchi, Q-learning trains with learning rate 0.02, discount 0.5 and ε-greedy exploration with ε = 0.1 for 200 000
steps, and for 1.6 million where messages of one and of four words are compared. 10 repetitions; the seeds are the same
in every condition. Each point of a learning curve is the mean of 10 greedy evaluation episodes (50 in the long runs).
Players without a table are evaluated for 20 000 steps, about 200 episodes, a repetition. Returns are undiscounted.

The dashed line is the optimum of 6706.85, which planning with the whole state gives (as a test of the environment
shows); the states with their messages are too many for `finite_model`. No policy that sees only the message can do
better, and with noise none can do as well.
"""

import math
from collections.abc import Mapping
from typing import Any

from edugym.envs.tamagotchi import Tamagotchi
from edugym.experiments.results.claims import Above, Below, Claim, Within
from edugym.experiments.results.statistics import exactly, mean_interval, paired_difference
from edugym.experiments.results.tables import Results
from edugym.mdp.protocol import Reals
from edugym_course.lessons.signal.figures import figures
from edugym_course.lessons.signal.methods import (
    FOUR,
    LENGTHS,
    LONG,
    N_STEPS,
    NOISY,
    OPTIMUM,
    RANDOM_PLAY,
    REPETITIONS,
    TAUS,
    VOCABULARIES,
    after,
    conditions,
    late,
    learn,
    learn_with_memory,
    noise_label,
    play,
    rows_of_table,
    time_below,
    vote,
)
from edugym_course.lessons.signal.moody import best_return, moody_toy
from edugym_course.lessons.signal.players import Coin, Meanings, RoundRobin
from edugym_course.lessons.signal.words import information
from edugym_course.report import Report
from edugym_course.reporting import SharedArguments, reporting

MOODS = (0.05, 0.1, 0.3)
"""The probabilities of moods in a step."""
COIN = "With two ambiguous words a player who tosses a coin between their meanings gets more than Q-learning"
CATCHES_UP = f"At the end of {LONG} steps Q-learning with four words is at most 200 behind Q-learning with one"
SEES_ITS_LAST = "Q-learning that observes its last action learns nearly the best play without a message"


def measure(how: SharedArguments) -> tuple[Any, ...]:
    """Run the experiments."""
    by_tau = {tau: learn(parameters={"tau": tau}, **how(f"tau_{tau}")) for tau in TAUS}
    by_vocabulary = {
        size: by_tau[0.0] if size == 4 else learn(parameters={"vocab_size": size}, **how(f"words_{size}"))
        for size in VOCABULARIES
    }
    noise = conditions({noise_label(tau): results for tau, results in by_tau.items()})
    words = conditions({f"{size} words": results for size, results in by_vocabulary.items()})
    one, four = (
        learn(
            n_steps=LONG,
            evaluate_every=N_STEPS // 2,
            evaluation_episodes=50,
            parameters={"tau": NOISY, "max_msg_length": length},
            **how(name),
        )
        for length, name in ((1, "one"), (FOUR, "four"))
    )
    curve: dict[str, Any] = {"evaluate_every": N_STEPS // 40, "evaluation_episodes": 5}
    brief = how(n_steps=N_STEPS // 2, repetitions=4 * how.repetitions, **curve)
    steady = learn(discount=0.9, parameters={"tau": 0.02}, **brief)
    hasty = learn(discount=0.9, learning_rate=0.1, parameters={"tau": 0.02}, **brief)
    memory = conditions(
        {
            "with its last action": learn_with_memory(**how("memory")),
            "without": learn_with_memory(actions=False, **how("no_memory")),
        }
    )
    meanings = {
        size: learn(environment=Meanings(Tamagotchi.create(vocab_size=size)), **how())
        for size in VOCABULARIES
        if size > 4
    }
    coin = play(Coin.create, parameters={"vocab_size": 2}, **how())
    moody = {moods: play(RoundRobin.create, environment=moody_toy(moods), **how()) for moods in MOODS}
    in_turn = play(RoundRobin.create, parameters={"tau": math.inf}, **how())
    obeyed = {tau: vote(tau, 1, 1, **how()) for tau in TAUS}
    voted = {length: vote(NOISY, length, length, **how()) for length in LENGTHS}
    return noise, words, (one, four), (steady, hasty), memory, in_turn, obeyed, voted, (meanings, coin, moody)


def judge(
    noise: Results,
    words: Results,
    lengths: tuple[Results, Results],
    rates: tuple[Results, Results],
    memory: Results,
    in_turn: Reals,
    obeyed: Mapping[float, Reals],
    voted: Mapping[int, Reals],
    without_causes: tuple[Mapping[int, Results], Reals, Mapping[float, Reals]],
) -> Report:
    """Return claims and figures."""
    (one, four), (steady, hasty) = lengths, rates
    meanings, coin, moody = without_causes
    claims = [
        *noise_claims(obeyed, noise),
        rate_claim(hasty, steady),
        *vocabulary_claims(words, meanings, coin),
        *message_claims(voted, one, four),
        *memory_claims(in_turn, moody, memory),
    ]
    return Report(claims, figures(noise, words, four, memory, obeyed, voted))


report = reporting(measure, judge, REPETITIONS)
"""Run the experiments of the lesson (see `edugym_course.reporting.Reporter`)."""


def noise_claims(obeyed: Mapping[float, Reals], noise: Results) -> list[Claim]:
    """Return the claims on the fall of the return with the noise."""
    expected = {0.0: (6700, 6710), 0.02: (5900, 6100), 0.05: (3150, 3450), 0.1: (0, 250), math.inf: (-700, -650)}
    learned = {0.0: (6700, 6710), 0.02: (5700, 6100), 0.05: (2700, 3500), 0.1: (-150, 200), math.inf: (-800, -600)}
    why = {0.0: "this is the optimum", math.inf: f"a word tells nothing; random actions return {RANDOM_PLAY:g}"}
    return [
        Claim(
            f"{player} returns {low} to {high} at {noise_label(tau)}",
            "return",
            measured[tau],
            Within(low, high),
            remark=why.get(tau, ""),
        )
        for player, bounds, measured in (
            ("Doing what the toy says", expected, {tau: mean_interval(obeyed[tau]) for tau in TAUS}),
            ("Q-learning", learned, {tau: mean_interval(late(noise, noise_label(tau))) for tau in TAUS}),
        )
        for tau, (low, high) in bounds.items()
    ]


def rate_claim(hasty: Results, steady: Results) -> Claim:
    """Return the claim on the learning rate, at discount 0.9 and τ = 0.02."""
    label = "Q-learning"
    return Claim(
        "With learning rate 0.1 more evaluations are below 5000 than with 0.02 (τ = 0.02, discount 0.9)",
        "share of evaluations below 5000 in the second half of training, rate 0.1 less rate 0.02",
        paired_difference(time_below(hasty, label, 5_000), time_below(steady, label, 5_000)),
        Above(0.01),
    )


def looks_the_same(size: int) -> str:
    """Return the statement that synonyms which look the same do not slow learning."""
    return f"Where synonyms look the same to the agent, {size} words are learned as fast as four"


def vocabulary_claims(words: Results, meanings: Mapping[int, Results], coin: Reals) -> list[Claim]:
    """Return the claims on synonyms and ambiguous words, at τ = 0."""
    return [
        *(
            Claim(
                f"Synonyms slow learning: {few} words are learned faster than {many}",
                f"return averaged over training, {many} words less {few}",
                words.difference(f"{many} words", f"{few} words", over="training"),
                Below(-500.0),
                "a synonym is learned from nothing, since a table does not generalise",
                tuple(map(looks_the_same, meanings)),
            )
            for few, many in ((4, 16), (16, 64))
        ),
        *(
            Claim(
                looks_the_same(size),
                f"return averaged over training, {size} words less 4",
                paired_difference(results.average("Q-learning"), words.average("4 words")),
                Within(-100.0, 100.0),
            )
            for size, results in meanings.items()
        ),
        Claim(
            "With 16 words, synonyms included, Q-learning still reaches the optimum",
            f"return / {OPTIMUM:.0f}",
            mean_interval(words.final("16 words") / OPTIMUM),
            Within(0.99, 1.001),
        ),
        Claim(
            "Two ambiguous words carry one bit, and Q-learning without memory does no better than random play with it",
            "return",
            words.mean("2 words"),
            Below(RANDOM_PLAY),
            "each word means two needs, and a fixed answer to it never meets one of them",
            (COIN,),
        ),
        Claim(
            COIN,
            "return, coin less Q-learning",
            paired_difference(coin, words.final("2 words")),
            Above(200.0),
        ),
    ]


def message_claims(voted: Mapping[int, Reals], one: Results, four: Results) -> list[Claim]:
    """Return the claims on the length of messages, at τ = 0.1: what they carry, and what is made of it."""
    bits = information(NOISY)
    return [
        Claim(
            "On a toy in perfect care 28 words at τ = 0.1 carry as much information as one word at τ = 0.02",
            "ratio of I(message; need), computed",
            exactly(information(NOISY, 28) / information(0.02)),
            Within(0.9, 1.1),
            remark=f"one word carries {bits:.3f} bit at τ = 0.1, {information(0.02):.2f} at 0.02; 2 bits tell the need",
        ),
        *(
            Claim(
                f"A majority vote over {length} words returns {low} to {high} at τ = 0.1",
                "return",
                mean_interval(voted[length]),
                Within(low, high),
                remark=f"they carry {information(NOISY, length):.2f} bit",
            )
            for length, low, high in ((4, 1700, 2050), (28, 5500, 5800))
        ),
        Claim(
            f"With four words, after {N_STEPS} steps Q-learning gets less than with one, although they carry more",
            "return with four words less that with one",
            paired_difference(after(four, N_STEPS), after(one, N_STEPS)),
            Below(-50.0),
            f"its table has {rows_of_table(FOUR)} rows instead of {rows_of_table(1)}, each visited less often",
            (CATCHES_UP,),
        ),
        Claim(
            CATCHES_UP,
            "return with four words less that with one, last five evaluations",
            paired_difference(four.late("Q-learning"), one.late("Q-learning")),
            Above(-200.0),
            remark="whether it gets ahead in that time does not show in 10 runs",
        ),
        Claim(
            "With four words Q-learning earns less than a majority vote",
            f"return of Q-learning after {LONG} steps less that of the vote, four words",
            paired_difference(after(four, LONG), voted[FOUR]),
            Below(-1000.0),
            remark="a message can carry more than a learner makes of it; the vote has nothing to learn",
        ),
    ]


def in_moods(moods: float) -> str:
    """Return the statement that taking turns fails where the needs cannot be foreseen."""
    return f"With moods in {moods:.0%} of the steps, taking the actions in turn gets less than half of the best"


def memory_claims(in_turn: Reals, moody: Mapping[float, Reals], memory: Results) -> list[Claim]:
    """Return the claims on memory in place of a signal."""
    return [
        Claim(
            "A blind player that takes the four actions in turn gets 99 % of the optimum",
            f"return / {OPTIMUM:.0f}, τ = ∞",
            mean_interval(in_turn / OPTIMUM),
            Within(0.985, 0.995),
            "what was done longest ago is the most urgent, so its memory says what is wanted",
            tuple(map(in_moods, moody)),
        ),
        *(
            Claim(
                in_moods(moods),
                "return / the best with the whole state, computed",
                mean_interval(returns / best_return(moods, 20)),
                Below(0.5),
            )
            for moods, returns in moody.items()
        ),
        Claim(
            SEES_ITS_LAST,
            f"share of evaluations above {0.98 * OPTIMUM:.0f} in the second half of training, one word in all",
            mean_interval(1 - time_below(memory, "with its last action", 0.98 * OPTIMUM)),
            Above(0.5),
        ),
        Claim(
            "Negative control: without its last action and a message Q-learning does no better than random play",
            "return, one word in all",
            memory.mean("without"),
            Below(RANDOM_PLAY),
            "all that it sees is its hit points, and they do not tell what the toy wants",
            (SEES_ITS_LAST,),
        ),
    ]


def warm_up() -> None:
    """Compile what the cells of the lesson need."""
    learn(n_steps=100, evaluate_every=50, repetitions=1, jobs=1)
    learn_with_memory(n_steps=100, evaluate_every=50, repetitions=1, jobs=1)
    play(RoundRobin.create, repetitions=1)
    for length in LENGTHS:
        vote(NOISY, length, length, repetitions=1)
