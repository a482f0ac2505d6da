"""The figures of lesson 7."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from edugym.agents.features import linear_value
from edugym.envs.trashbot.geometry import SHOULDER_Y, arm
from edugym.envs.trashbot.task import Trashbot
from edugym.experiments.figures.curves import Curves
from edugym.experiments.figures.panel import With
from edugym.experiments.figures.sheet import Sheet
from edugym.experiments.figures.style import stroke
from edugym.experiments.repeat import repeat
from edugym.experiments.results.tables import Results, joined
from edugym.mdp.tabular import Tabular
from edugym_course.lessons.continuous_actions.exact import best_return
from edugym_course.lessons.continuous_actions.methods import (
    ACTOR_RATE,
    CELLS,
    DISCOUNT,
    LEARNING_RATE,
    SPREAD,
    WIDTH,
    in_a_table,
    learn_bins,
    learn_continuous,
    name,
)
from edugym_course.lessons.continuous_actions.panels import (
    BestReturns,
    Climbs,
    Landscape,
    Map,
    Noise,
    Places,
    Slope,
    run_by_run,
    with_best,
)
from edugym_course.lessons.continuous_actions.ppo import ACTIONS
from edugym_course.lessons.continuous_actions.release import (
    Scores,
    climb,
    climb_in_bins,
    estimates,
    scores,
    two_containers,
)

SHOWN_BINS = (2, 3, 4, 5, 6, 7, 9)
"""The numbers of bins for which everything is tried in the lesson."""
FOLLOWED = (0, 60, 250, 1_000)
"""The updates after which a policy is shown."""


def exact_figure(width: float = WIDTH, bins: Sequence[int] = SHOWN_BINS) -> Sheet:
    """Return where the box can be let go with so many bins, and the best return."""
    places = Places(bins, width, f"where the box can be let go, width {width:g}")
    return Sheet("exact", [[places, BestReturns(bins, width)]])


def curves(results: Results, title: str = "", width: float = WIDTH, **look: Any) -> With:
    """Return learning curves, with the best return that each number of bins allows."""
    labels = [label for label in ACTIONS if label in results.methods]
    best = {label: best_return(ACTIONS[label], width) for label in labels}
    strokes = {label: stroke(i) for i, label in enumerate(ACTIONS)}
    return with_best(Curves(results, title, methods=labels, y_range=(-2.1, 5.2), strokes=strokes, **look), best)


def ppo_figure(stored: Results) -> Sheet:
    """Return the stored runs of PPO, played with drawn actions and with the likeliest ones."""
    return Sheet(
        "ppo",
        [
            [
                curves(stored, "PPO, actions drawn", column="training_return", y_label="return"),
                curves(stored, "PPO, likeliest actions", y_label="return"),
            ]
        ],
    )


def one_setting(
    bins: int = 5,
    cells: int = CELLS,
    *,
    alpha: float = LEARNING_RATE,
    sigma: float = SPREAD,
    actor_rate: float = ACTOR_RATE,
    gamma: float = DISCOUNT,
    width: float = WIDTH,
    n_steps: int = 40_000,
    repetitions: int = 4,
) -> Sheet:
    """Return the learning curves of REINFORCE on a table, and of the Gaussian actor-critic, with settings of one's own.

    Args:
        bins: how many values each joint has in the table.
        cells: into how many cells each coordinate of the wrist is cut.
        alpha: both learning rates of REINFORCE.
        sigma: σ.
        actor_rate: α^θ of the Gaussian actor-critic.
        gamma: γ of both.
        width: of the container.
        n_steps: the training steps of each run.
        repetitions: the number of runs of each.
    """
    how: dict[str, Any] = {"n_steps": n_steps, "repetitions": repetitions, "discount": gamma, "width": width}
    table = learn_bins(bins, cells=cells, learning_rate=alpha, **how)
    real = learn_continuous(spread=sigma, actor_rate=actor_rate, **how)
    title = (
        f"{bins} bins, {cells} cells, α = {alpha:g}; σ = {sigma:g}, actor's rate {actor_rate:g};"
        f"\nγ = {gamma:g}, width {width:g}"
    )
    strokes = {"REINFORCE, table": stroke(6), "Gaussian actor-critic": stroke(3)}
    both = joined([one.renamed(label) for one, label in zip((table, real), strokes, strict=True)])
    return Sheet("one_setting", [[run_by_run(Curves(both, title, y_range=(-2.1, 5.2), strokes=strokes))]])


def gradient_figure(mu: float = 0.6, sigma: float = 0.5, n: int = 1_000, baseline: float = 0.0, seed: int = 0) -> Sheet:
    """Return a Gaussian policy over the reward, and the slope of J beside its estimate from n actions."""
    estimate = float(estimates(mu, sigma, n, baseline=baseline, seed=seed)[0].mean())
    policy = Landscape({"policy": (mu, sigma)}, title=f"μ = {mu:g}, σ = {sigma:g}")
    title = f"slope from {n} actions, b = {baseline:g}: {estimate:.2f}"
    return Sheet("gradient", [[policy, Slope(mu, sigma, estimate, title)]])


def noise_figure(policies: Mapping[str, tuple[float, float]]) -> Sheet:
    """Return how noisy the estimated slope is, for every baseline."""
    return Sheet("noise", [[Noise(policies)]])


def narrowing(
    mu: float = -0.8, sigma: float = 1.0, alpha: float = 0.01, baseline: bool = True, n_updates: int = 1_000
) -> Sheet:
    """Return one Gaussian policy while it learns μ and σ, and the mean reward of 100 such policies."""
    runs = climb(mean=mu, spread=sigma, rate=alpha, baseline=baseline, n_updates=n_updates)
    shown = [t for t in FOLLOWED if t <= n_updates]
    policies = {f"update {t}": (float(runs.means[t, 0]), float(runs.spreads[t, 0])) for t in shown}
    climbed = {"with a baseline" if baseline else "without a baseline": runs}
    right = Climbs(climbed, f"100 policies, α = {alpha:g}", (4 if baseline else 5,))
    left = Landscape(policies, title=f"one of them, from μ = {mu:g}, σ = {sigma:g}")
    return Sheet("narrowing", [[left, right]])


def baseline_figure(alpha: float = 0.01, n_updates: int = 2_000) -> Sheet:
    """Return the mean reward of 100 Gaussian policies, with a baseline and without."""
    runs = {
        label: climb(baseline=on, rate=alpha, n_updates=n_updates)
        for label, on in (("with a baseline", True), ("without a baseline", False))
    }
    return Sheet("baseline", [[Climbs(runs, "100 policies")]])


def peaks(
    mu: float = -1.0, sigma: float = 0.5, bins: int = 10, n_updates: int = 2_000
) -> tuple[Sheet, dict[str, float]]:
    """Return Gaussian policies and policies in bins where there are two containers, and the share at the rich one."""
    runs = {
        "Gaussian": climb(mean=mu, spread=sigma, n_updates=n_updates, pays=two_containers),
        f"{bins} bins": climb_in_bins(bins, rate=0.1, n_updates=n_updates),
    }
    title = f"two containers; μ = {mu:g}, σ = {sigma:g} at first"
    start = Landscape({"Gaussian, at first": (mu, sigma)}, two_containers, title, (-3.5, 3.5))
    found = {label: float((runs[label].means[-1] > 0.5).mean()) for label in runs}
    shares = ", ".join(f"{label} {share:.0%}" for label, share in found.items())
    return Sheet("peaks", [[start, Climbs(runs, f"at the rich container in the end:\n{shares}", (3, 6))]]), found


def climb_race(score: Scores) -> Sheet:
    """Return the lesson's figure with scores of the reader's own beside those of the lesson."""
    runs = {"the lesson's scores": climb(score=scores), "my scores": climb(score=score)}
    return Sheet("scores", [[Climbs(runs, "100 policies of each", (4, 6))]])


def race(own: Mapping[str, Any], *, n_bins: int = 5, n_steps: int = 40_000, repetitions: int = 8, **how: Any) -> Sheet:
    """Return REINFORCE of the package with and without a baseline, beside agents of the reader's own, with 5 bins.

    Args:
        own: by label, functions that make an agent for a task with a table.
        n_bins: how many values each joint has.
        n_steps: the training steps of each run.
        repetitions: the number of runs of each.
        **how: more arguments of `edugym.experiments.repeat`.
    """
    both: dict[str, Any] = {"n_steps": n_steps, "repetitions": repetitions, **how}
    parts = [
        learn_bins(n_bins, baseline=on, **both).renamed(label)
        for label, on in (("REINFORCE with baseline", True), ("without baseline", False))
    ]
    every = max(n_steps // 25, 1)
    mine = {"repetitions": repetitions, "evaluate_every": every, **how}
    parts.append(repeat(in_a_table(n_bins), dict(own), n_steps, **mine))
    results = joined(parts)
    best = dict.fromkeys(results.methods[:1], best_return(n_bins))
    strokes = {label: stroke(i) for i, label in enumerate(results.methods, start=4)}
    curves = Curves(results, f"{n_bins} bins, {CELLS} cells", y_range=(-2.1, 5.2), strokes=strokes)
    return Sheet("race", [[with_best(curves, best)]])


def lake_figure(lake: Results) -> Sheet:
    """Return the learning curves of REINFORCE on the frozen lake, with a baseline and without."""
    strokes = {label: stroke(i) for i, label in enumerate(lake.methods, start=4)}
    return Sheet("lake", [[Curves(lake, "FrozenLake", smooth=3, y_range=(-0.05, 1.1), strokes=strokes)]])


def maps(table: Any, real: Any, n_bins: int = 5, n: int = 120) -> Sheet:
    """Return what a table and tile coding have learned of the places of the wrist with the box, and their ways.

    Args:
        table: an agent that has learned with `n_bins` bins on a table.
        real: a Gaussian actor-critic.
        n_bins: of the table.
        n: the number of places along each axis.
    """
    grid = np.linspace(-1.0, 1.0, n, endpoint=False) + 1.0 / n
    cells = np.minimum(((grid + 1.0) / 2.0 * CELLS).astype(int), CELLS - 1)
    of_table = table.V.reshape(CELLS, CELLS, 3)[:, :, 2][np.ix_(cells, cells)].T
    of_tiles = np.array(
        [
            [linear_value(real.features, real.value_weights, (0.0, 0.0, x, y, 0.0, 0.0, 1.0), 0) for x in grid]
            for y in grid
        ]
    )
    return Sheet(
        "maps",
        [
            [
                Map(of_table, way(in_a_table(n_bins), table), f"a table, {name(n_bins)}"),
                Map(of_tiles, way(Trashbot.create(), real), "tile coding, continuous actions"),
            ]
        ],
    )


def way(task: Any, agent: Any) -> Any:
    """Return the places of the wrist in a greedy episode, from the shoulder, shape (n_steps, 2)."""
    shown: Any = Tabular.create(task) if getattr(agent, "tabular", True) else task
    rng = np.random.default_rng(0)
    state, places = shown.initial(rng), []
    for _ in range(40):
        now = arm(state.shoulder, state.elbow)
        places.append((now.wrist_x, now.wrist_y - SHOULDER_Y))
        if shown.terminal(state):
            break
        state = shown.transition(state, agent.greedy(shown.observation(state, rng), rng), rng)
    return np.array(places)
