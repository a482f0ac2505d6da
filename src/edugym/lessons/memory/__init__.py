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

from collections.abc import Iterator, Sequence
from functools import partial
from itertools import product
from typing import Annotated, Any, NamedTuple

import numpy as np

from edugym.agents.q_learning import QLearning
from edugym.agents.settings import Counter, Table, new
from edugym.agents.strategies import EpsilonGreedy
from edugym.envs.memory_corridor import MemoryCorridor
from edugym.experiments import How, reporting
from edugym.lessons.memory.network import WINDOWS, learn_with_network, network_claims
from edugym.lessons.memory.recurrent import STORED, recurrent_claims
from edugym.mdp.frame_stack import FrameStack, stack_size
from edugym.mdp.protocol import Integers, Random
from edugym.plotting.curves import Curves
from edugym.plotting.lines import Lines
from edugym.plotting.report import Report
from edugym.plotting.sheet import Sheet
from edugym.results.claims import Above, Below, Claim, Within
from edugym.results.statistics import exactly, mean_interval, paired_difference
from edugym.results.tables import Results
from edugym.training.repeat import repeat

N_STEPS = 1_000_000
EARLY = 4_000
"""The steps after which the speed of learning is compared, in runs of `SHORT` steps."""
SHORT = 20_000
REPETITIONS = 10
LEARNING_RATE = 0.1
DISCOUNT = 0.8
EPSILON = 0.1
DOORS = 3
FRAMES = (1, 2, 3, 4)
WITH_ACTIONS = (2, 3, 4, 5)
LENGTHS = (1, 2, 3, 4, 5, 6)
"""The corridors for which the needed window is computed."""


class Rememberer(NamedTuple):
    """A player with the right memory: it writes down each marked door, and walks through the corridor by its notes.

    Attributes:
        doors: shape (1000,): the right door at each place, as far as it has seen it.
        length: shape (1,): the length of the present corridor, less 1.
        position: shape (1,): its place in it.
    """

    doors: Annotated[Integers, Table((1_000,))]
    length: Counter
    position: Counter

    def act(self, state: int, rng: Random) -> int:
        """Note the marked door at the last place, and open the door in the notes."""
        position = int(self.position[0])
        if position == self.length[0]:
            self.doors[position] = state
            self.length[0] += 1
            self.position[0] = 0
        else:
            self.position[0] += 1
        return int(self.doors[position])

    def learn(self, terminated: bool, truncated: bool) -> None:
        """Start anew after the end of an episode."""
        if terminated or truncated:
            self.length[0] = self.position[0] = 0

    @classmethod
    def create(cls, environment: Any) -> "Rememberer":
        """Create a player without notes."""
        return new(cls, None, {})


def learn(
    k: int,
    actions: bool = False,
    *,
    n_steps: int = N_STEPS,
    learning_rate: float = LEARNING_RATE,
    discount: float = DISCOUNT,
    epsilon: float = EPSILON,
    **how: Any,
) -> Results:
    """Train Q-learning on stacks.

    Args:
        k: the number of observations in a stack.
        actions: whether the actions between them are shown too.
        n_steps: the training steps of each run.
        learning_rate: α.
        discount: γ.
        epsilon: ε of ε-greedy exploration.
        **how: more arguments of `edugym.training.repeat`, such as `repetitions`, `seed` and `jobs`.
    """
    exploration = EpsilonGreedy(epsilon)
    make = partial(QLearning.create, learning_rate=learning_rate, discount=discount, exploration=exploration)
    task = FrameStack.create(MemoryCorridor.create(DOORS), k, actions=actions)
    every = max(n_steps // 25, 1)
    return repeat(task, {name(k): make}, n_steps, evaluate_every=every, evaluation_episodes=40, **how)


def remember(**how: Any) -> Results:
    """Watch the player with the right memory for an episode."""
    max_steps = 1_000
    return repeat("MemoryCorridor", {"notes": Rememberer.create}, max_steps, evaluate_every=max_steps, **how)


def name(k: int) -> str:
    """Return the label of a stack."""
    return f"k = {k}"


def joined(results: Sequence[Results]) -> Results:
    """Join the results of several windows, with the windows as methods."""
    import pandas

    table = pandas.concat([part.table for part in results], ignore_index=True)
    return Results(table, {label: agents for part in results for label, agents in part.agents.items()})


def perfect_play(doors: tuple[int, ...]) -> Iterator[tuple[int, int]]:
    """Yield observation and right door at each step of perfect play, through the corridor with all these doors."""
    for length in range(1, len(doors) + 1):
        for position in range(length):
            yield (doors[position] if position == length - 1 else DOORS), doors[position]


def is_enough(k: int, length: int, actions: bool = False) -> bool:
    """Whether a stack of k tells the right door at every step of perfect play through the corridor of this length."""
    known: dict[Any, int] = {}
    for doors in product(range(DOORS), repeat=length):
        seen, opened = [doors[0]] * (k - 1), [0] * (k - 1)  # as a stack starts
        for observation, door in perfect_play(doors):
            seen.append(observation)
            stack = (*seen[-k:], *opened[len(opened) - k + 1 :]) if actions else (*seen[-k:],)
            if known.setdefault(stack, door) != door:
                return False
            opened.append(door)
    return True


def smallest_window(length: int, actions: bool = False) -> int:
    """Return the smallest stack that allows perfect play through the corridor of a length, by trying all doors."""
    k = 1
    while not is_enough(k, length, actions):
        k += 1
    return k


def window_law(length: int) -> int:
    """Return L(L-1)/2 + 1: the observations from the first mark to the first door of corridor L, and one."""
    return length * (length - 1) // 2 + 1


def action_law(length: int) -> int:
    """Return the window that is enough with the actions: the larger of L and 2L - 3.

    The right door was opened L - 1 steps ago, on the last walk. To look it up, the agent must also tell corridor L from
    L - 1, by the second last mark, which lies up to 2L - 4 steps back in corridor L - 1.
    """
    return max(length, 2 * length - 3)


def dense_table(k: int) -> int:
    """Return the bytes of a dense table of action values over stacks of k observations."""
    return 8 * DOORS * stack_size(DOORS + 1, k)


def measure(how: How) -> tuple[Any, ...]:
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
"""Run the experiments of the lesson (see `edugym.experiments.Reporter`)."""


def window_claims() -> list[Claim]:
    """Return the claims on the window that perfect play needs; they are computed by trying all doors."""
    longest = LENGTHS[-1]
    return [
        Claim(
            "Frames alone: perfect play through corridor L needs a window of L(L-1)/2 + 1",
            f"largest deviation for L = 1 to {longest}",
            exactly(max(abs(smallest_window(length) - window_law(length)) for length in LENGTHS)),
            Within(0, 0),
            "the mark of the first door was seen once, at the very start",
        ),
        Claim(
            "With the actions in the window, the larger of L and 2L - 3 is enough: linear in place of quadratic",
            f"largest deviation for L = 1 to {longest}",
            exactly(max(abs(smallest_window(length, actions=True) - action_law(length)) for length in LENGTHS)),
            Within(0, 0),
            "the door was opened L - 1 steps ago; two marks in the window tell how long the corridor is (section 17.3)",
        ),
    ]


def frame_claims(frames: Results) -> list[Claim]:
    """Return the claims on stacks of observations."""
    expected = {1: (2.2, 3.2), 2: (3.4, 4.1), 3: (4.1, 5.0), 4: (6.5, 7.3)}
    return [
        Claim(
            f"A stack of {k} frame{'s' if k > 1 else ''} returns about {(low + high) / 2:.2g}",
            "greedy return, last five evaluations",
            mean_interval(final(frames, k)),
            Within(low, high),
            "the window of perfect play through three corridors (6), and a guess" if k == window_law(3) else "",
        )
        for k, (low, high) in expected.items()
    ]


def action_claims(frames: Results, both: Results, quick: Results) -> list[Claim]:
    """Return the claims on stacks with actions."""
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
                "the paper's 'just above its memory' holds for this window",
            )
            for k in WITH_ACTIONS[:-1]
        ),
        Claim(
            "Longer stacks learn more slowly: five with actions are further from their own final return than three",
            f"share of the final return after {EARLY} steps, k = 5 less k = 3",
            paired_difference(at(quick, 5, EARLY) / final(both, 5), at(quick, 3, EARLY) / final(both, 3)),
            Below(0.0),
            f"{stack_size(DOORS + 1, 5, DOORS)} rows instead of {stack_size(DOORS + 1, 3, DOORS)}",
        ),
        Claim(
            "and yet they return more by then: the rows for the first, short corridors are few, and are learned first",
            f"greedy return after {EARLY} steps, k = 5 less k = 3",
            paired_difference(at(quick, 5, EARLY), at(quick, 3, EARLY)),
            Above(0.0),
        ),
        Claim(
            "In the end five with actions are ahead of three",
            "greedy return, k = 5 less k = 3",
            paired_difference(final(both, 5), final(both, 3)),
            Above(2.0),
        ),
    ]


def notes_claim(watched: Results) -> Claim:
    """Return the claim on the right memory."""
    return Claim(
        "A player that writes down each marked door never errs: what it takes is L symbols, not a long window",
        "return, of 1000 possible",
        watched.mean("notes"),
        Within(1_000, 1_000),
    )


def size_claim() -> Claim:
    """Return the claim on the dense table of long stacks."""
    return Claim(
        "A dense table over stacks of 25 frames needs 27 petabytes",
        "petabytes, computed",
        exactly(dense_table(25) / 1e15),
        Within(26.5, 27.5),
        f"25 frames are perfect play up to corridor {max(n for n in range(1, 25) if window_law(n) <= 25)}",
    )


def final(results: Results, k: int) -> Any:
    """Return the mean of the last five evaluations of every run with a stack of k, shape (n_repetitions,)."""
    curves = results.curves(name(k)).reindex(columns=range(len(results.final(name(k)))))
    return np.where(np.isnan(results.final(name(k))), np.nan, curves.iloc[-5:].mean())


def at(results: Results, k: int, step: int) -> Any:
    """Return the evaluation after a number of steps of every run with a stack of k, shape (n_repetitions,)."""
    columns = range(len(results.final(name(k))))
    return results.curves(name(k)).reindex([step]).reindex(columns=columns).to_numpy(float)[0]


def figures(frames: Results, both: Results, networks: Results, recurrent: Results) -> list[Sheet]:
    """Return the figures: learning curves of tables and networks, and the windows that perfect play needs."""
    labels = [name(k) for k in sorted({*FRAMES, *WITH_ACTIONS})]
    windows = Lines(
        np.array(LENGTHS, float),
        {
            "frames alone": np.array([smallest_window(length) for length in LENGTHS], float),
            "frames and actions": np.array([smallest_window(length, actions=True) for length in LENGTHS], float),
        },
        "perfect play through corridor L",
        "L",
        "smallest window",
        {"L(L-1)/2 + 1": np.array([window_law(length) for length in LENGTHS], float)},
    )
    panels = [Curves(frames, "frames alone", methods=labels[:-1]), Curves(both, "frames and actions", methods=labels)]
    learned = [Curves(networks, "DQN on windows"), Curves(recurrent, "recurrent PPO, no window")]
    return [Sheet("memory", [panels]), Sheet("window", [[windows]]), Sheet("networks", [learned])]
