"""Partial observability (lesson 5): how much memory the corridor needs, as stacks of frames with and without actions.

On MemoryCorridor with three doors, Q-learning trains for a million steps on stacks of k observations, and on stacks
with the actions between them: learning rate 0.1, discount 0.8, ε-greedy exploration with ε = 0.1. 10 repetitions; the
seeds are the same for every stack. Each point of a learning curve is the mean of 40 greedy evaluation episodes.
Returns are undiscounted.

DQN learns from the same windows with a number for each observation (100 000 steps), and recurrent PPO from single
observations (150 000 steps; its results are stored).

The best policy with full memory returns 1 a step without end; perfect play through corridor L has returned L(L+1)/2.
The state has no finite model, since the corridor grows without end.
"""

from typing import Any

from edugym.experiments.figures.curves import Curves
from edugym.experiments.figures.sheet import Sheet
from edugym.experiments.results.claims import Above, Below, Claim, Within
from edugym.experiments.results.statistics import exactly, mean_interval, paired_difference
from edugym.experiments.results.tables import Results, joined
from edugym.mdp.frame_stack import stack_size
from edugym.mdp.protocol import Reals
from edugym_course.lessons.memory.figures import window_lines
from edugym_course.lessons.memory.lake import learn_blindly
from edugym_course.lessons.memory.network import WINDOWS, learn_with_network, network_claims
from edugym_course.lessons.memory.players import learn, name, remember
from edugym_course.lessons.memory.recurrent import STORED, recurrent_claims
from edugym_course.lessons.memory.windows import DOORS, action_law, best_play, dense_table, smallest_window, window_law
from edugym_course.report import Report
from edugym_course.reporting import SharedArguments, reporting

EARLY = 4_000
"""The steps after which the speed of learning is compared, in runs of `SHORT` steps."""
SHORT = 20_000
REPETITIONS = 10
FRAMES = (1, 2, 3, 4)
WITH_ACTIONS = (2, 3, 4, 5)
LENGTHS = (1, 2, 3, 4, 5, 6)
"""The corridors for which the needed window is computed."""


def measure(how: SharedArguments) -> tuple[Any, ...]:
    """Run the experiments."""
    one = learn(1, **how("frames_1"))
    frames = joined([one, *(learn(k, **how(f"frames_{k}")) for k in FRAMES[1:])])
    with_actions = [learn(k, actions=True, **how(f"frames_and_actions_{k}")) for k in WITH_ACTIONS]
    both = joined([one, *with_actions])  # one frame has no actions between
    quick = joined([learn(k, actions=True, **how(n_steps=SHORT)) for k in (3, 5)])
    networks = joined([learn_with_network(window, **how(f"network_{i}")) for i, window in enumerate(WINDOWS)])
    return frames, both, quick, remember(**how()), networks


def judge(frames: Results, both: Results, quick: Results, watched: Results, networks: Results) -> Report:
    """Return claims and figures."""
    recurrent = STORED.load()
    claims = [
        *window_claims(),
        *frame_claims(frames),
        *action_claims(frames, both, quick),
        notes_claim(watched),
        size_claim(),
        *network_claims(networks),
        *recurrent_claims(recurrent),
    ]
    return Report(claims, figures(frames, both, networks, recurrent))


report = reporting(measure, judge, REPETITIONS)
"""Run the experiments of the lesson (see `edugym_course.reporting.Reporter`)."""


def window_claims() -> list[Claim]:
    """Return the claims on the window that perfect play needs; they are computed by trying all doors."""
    longest = LENGTHS[-1]
    return [
        Claim(
            "Frames alone: perfect play through corridor L needs a window of L(L-1)/2 + 1",
            f"largest deviation for L = 1 to {longest}",
            exactly(max(abs(smallest_window(length) - window_law(length)) for length in LENGTHS)),
            Within(0, 0),
            remark="the mark of the first door was seen once, at the very start",
        ),
        Claim(
            "With the actions in the window, the larger of L and 2L - 3 is enough: linear in place of quadratic",
            f"largest deviation for L = 1 to {longest}",
            exactly(max(abs(smallest_window(length, actions=True) - action_law(length)) for length in LENGTHS)),
            Within(0, 0),
            remark="the door was opened L - 1 steps ago; two marks tell how long the corridor is (section 17.3)",
        ),
        Claim(
            "The best play with 7 observations and actions gets further than corridor 5: it returns far more than 15",
            "expected return of the best policy that was found",
            exactly(best_play(7, actions=True).value),
            Within(23.0, 23.6),
            remark="the window of 2L - 3 is for never erring",
        ),
    ]


def frame_claims(frames: Results) -> list[Claim]:
    """Return the claims on stacks of observations."""
    best = {k: best_play(k).value for k in FRAMES}
    return [
        Claim(
            f"A stack of {k} frame{'s' if k > 1 else ''} returns nearly the best that its window allows, {value:.3g}",
            "greedy return, last five evaluations",
            mean_interval(final(frames, k)),
            Within(0.85 * value, 1.1 * value),
            remark="the window of perfect play through three corridors (6), and a guess" if k == window_law(3) else "",
        )
        for k, value in best.items()
    ]


def action_claims(frames: Results, both: Results, quick: Results) -> list[Claim]:
    """Return the claims on stacks with actions."""
    three, five = (quick.at(name(k), EARLY) for k in (3, 5))
    return [
        *(
            Claim(
                f"With the actions, a stack of {k} remembers more than {k} frames alone",
                "greedy return less that of frames alone",
                paired_difference(final(both, k), final(frames, k)),
                Above(0.5),
            )
            for k in FRAMES[1:]
        ),
        *(
            Claim(
                f"A stack of {k} with actions gets through corridor {k}, or nearly",
                f"greedy return / {k * (k + 1) // 2}",
                mean_interval(final(both, k) / (k * (k + 1) / 2)),
                Above(0.9),
                remark="the paper's 'just above its memory' holds for this window",
            )
            for k in WITH_ACTIONS[:-1]
        ),
        Claim(
            "Longer stacks learn more slowly: five with actions are further from their own final return than three",
            f"share of the final return after {EARLY} steps, k = 5 less k = 3",
            paired_difference(five / final(both, 5), three / final(both, 3)),
            Below(-0.1),
            remark=f"{stack_size(DOORS + 1, 5, DOORS)} rows instead of {stack_size(DOORS + 1, 3, DOORS)}",
        ),
        Claim(
            f"A stack of five with actions still returns more than one of three after {EARLY} steps",
            f"greedy return after {EARLY} steps, k = 5 less k = 3",
            paired_difference(five, three),
            Above(1.0),
        ),
        Claim(
            "In the end a stack of five with actions is ahead of a stack of three",
            "greedy return, k = 5 less k = 3",
            paired_difference(final(both, 5), final(both, 3)),
            Above(2.0),
        ),
    ]


def notes_claim(watched: Results) -> Claim:
    """Return the claim on the right memory."""
    return Claim(
        "A player that notes each marked door never errs",
        "return, of 1000 possible",
        watched.mean("notes"),
        Within(1_000, 1_000),
        remark="it needs L symbols, not a long window",
    )


def size_claim() -> Claim:
    """Return the claim on the dense table of long stacks."""
    return Claim(
        "A dense table over stacks of 25 frames needs 27 petabytes",
        "petabytes, computed",
        exactly(dense_table(25) / 1e15),
        Within(26.5, 27.5),
        remark=f"25 frames are perfect play up to corridor {max(n for n in range(1, 25) if window_law(n) <= 25)}",
    )


def final(results: Results, k: int) -> Reals:
    """Return the mean of the last five evaluations of every run with a stack of k, shape (n_repetitions,)."""
    return results.late(name(k))


def figures(frames: Results, both: Results, networks: Results, recurrent: Results) -> list[Sheet]:
    """Return the figures: learning curves of tables and networks, and the windows that perfect play needs."""
    labels = [name(k) for k in sorted({*FRAMES, *WITH_ACTIONS})]
    panels = [Curves(frames, "frames alone", methods=labels[:-1]), Curves(both, "frames and actions", methods=labels)]
    learned = [Curves(networks, "DQN on windows"), Curves(recurrent, "recurrent PPO, no window")]
    return [Sheet("memory", [panels]), Sheet("window", [[window_lines(LENGTHS)]]), Sheet("networks", [learned])]


def warm_up() -> None:
    """Compile what the lesson needs: a few steps of everything."""
    results = joined([learn(k, actions=k > 1, n_steps=1_000, repetitions=1) for k in (1, 2)])
    for window in WINDOWS:
        learn_with_network(window, n_steps=1_200, repetitions=1)
    remember(repetitions=1)
    learn_blindly([(2, True)], n_steps=50, repetitions=1)
    Sheet("curves", [[Curves(results)]]).draw()
