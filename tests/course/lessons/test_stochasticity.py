"""Stochasticity in Golf: what is exact, what is counted, and what the claims measure."""

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from edugym.envs.golf import Golf
from edugym_course.lessons.stochasticity import drive, exact, experiments, figures, methods, noise
from tests.course.lessons.made_up import made_up, measured
from tests.experiments.figures.samples import new_axes

SHARES = [0.1, 0.0, 0.2, 0.3, 0.1, 0.1, 0.05, 0.05, 0.0, 0.05, 0.05]


def test_exact_values() -> None:
    """With little noise it takes two hits; the grid is fine enough; exploring costs, and attitudes move the swing."""
    worth = exact.from_the_tee(0.002)
    assert worth["drive"] == pytest.approx(0.9, abs=0.002)
    assert worth["putt"] == pytest.approx(0.8, abs=0.01)
    fine, neutral = exact.from_the_tee(methods.LEVEL), exact.from_the_tee(methods.LEVEL, 0.25)
    assert neutral["drive"] == pytest.approx(fine["drive"], abs=0.001)
    optimum = exact.optimum(methods.LEVEL)
    assert exact.soft_optimum(methods.LEVEL, 0.0) == pytest.approx(optimum)
    assert optimum - 0.1 < exact.soft_optimum(methods.LEVEL, 0.1) < optimum - 0.03
    few_hits = exact.from_the_tee(0.0228, max_hits=5)
    assert few_hits["drive"] > few_hits["chip"]
    assert exact.from_the_tee(methods.LEVEL, 0.25, risk=1e-9) == pytest.approx(neutral, abs=1e-6)


@pytest.mark.parametrize(
    ("risk", "low", "high", "expected"),
    [(-2.0, 0.015, 0.018, 0.016), (0.0, 0.015, 0.025, exact.crossing()), (2.0, 0.04, 0.06, 0.051)],
)
def test_the_attitude_moves_the_crossing(risk: float, low: float, high: float, expected: float) -> None:
    """Every player stops driving at some level, also the seeking one, and drive and chip are worth the same there."""
    level = exact.crossing(low, high, cell=0.25, risk=risk)
    assert level == pytest.approx(expected, abs=5e-4)
    worth = exact.from_the_tee(level, 0.25, risk=risk)
    assert worth["drive"] == pytest.approx(worth["chip"], abs=1e-3)
    lines: Any = figures.crossing_by_attitude((low, high), {"theirs": risk}).panel
    assert lines.lines["theirs"][0] > 0 > lines.lines["theirs"][1]


def test_shares_by_hand() -> None:
    """On a grid its values, and between them the mean; who has learned 3 of 4 has learned three quarters."""
    values = np.array([[0.0, 1.0, 2.0], [4.0, 5.0, 6.0], [0.0, 0.0, 0.0]])
    places = np.array([0.0, 0.0, 0.5, 0.5]), np.array([0.0, 0.5, 0.0, 0.5])
    assert exact.interpolated(values, *places).tolist() == [0.0, 0.5, 2.0, 2.5]
    results = made_up({methods.NEUTRAL: [{0: 0.0, 10: 3.0, **dict.fromkeys(range(20, 70, 10), 4.0)}] * 2})
    assert methods.share_learned(results, 10, 4.0).tolist() == [0.75, 0.75]
    assert drive.near_optimum_at(results, 0.0, 0).tolist() == [0, 0]
    assert drive.near_optimum_at(results, 0.0, 20).tolist() == [1, 1]


def test_games_are_counted() -> None:
    """Lost ones first, then those won with 1, 2, ... hits, which return 1.1 - k / 10; a lost one returns -1."""
    task = Golf.create()
    player = methods.Player.create(task, np.zeros((task.width * task.length, 3)))
    for reward, terminated in ((-1.0, True), (0.0, False), (0.9, True), (0.7, True), (0.1, True), (1.0, True)):
        player.learn(reward, terminated)
    assert player.score[0].tolist() == [1, 1, 1, 0, 1, 0, 0, 0, 0, 0, 1]
    games = np.array([[0.25, 0.5, 0.0, 0.25], [1.0, 0.0, 0.0, 0.0]])
    nothing = np.zeros(2)
    np.testing.assert_allclose(methods.Played(nothing, nothing, nothing, games).hits, [5 / 3, np.nan])
    one = methods.played([np.array(SHARES), np.eye(11)[3]], 10)
    returns = np.array([-1.0, 1.0, 0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2, 0.1])
    mean = float(np.dot(SHARES, returns))
    assert one.mean.tolist() == pytest.approx([mean, 0.8])
    assert one.spread.tolist() == pytest.approx([np.dot(SHARES, (returns - mean) ** 2) ** 0.5, 0.0], abs=1e-7)
    assert one.lost.tolist() == [0.1, 0.0]


@pytest.mark.slow
def test_playing_changes_nothing_and_agrees_with_the_evaluation() -> None:
    """The mean of the score is the return of the greedy policy."""
    results = methods.learn(n_steps=20_000, repetitions=2, evaluation_episodes=2_000, risks={methods.NEUTRAL: 0.0})
    before = [agent.Q.copy() for agent in results.complete_agents(methods.NEUTRAL).values()]
    played = methods.play(results)[methods.NEUTRAL]
    assert played.mean == pytest.approx(results.final(methods.NEUTRAL), abs=0.06)
    for agent, Q in zip(results.complete_agents(methods.NEUTRAL).values(), before, strict=True):
        assert (agent.Q == Q).all()


@pytest.mark.parametrize("risk", [-2.0, 0.0, 2.0])
def test_value_of_a_lottery(risk: float) -> None:
    """Of normal rewards mean + β/2 variance, which is what is learned; of two places what the lottery is worth."""
    rewards = np.linspace(-1.5, 3.1, 2_001)
    chances = np.exp(-(((rewards - 0.8) / 0.3) ** 2) / 2)
    computed = exact.certain_value(rewards, chances / chances.sum(), risk)
    assert computed == pytest.approx(0.8 + risk / 2 * 0.09, abs=1e-4)
    assert methods.learned_value(risk, lambda rng: rng.normal(0.8, 0.3), seed=5) == pytest.approx(computed, abs=0.02)
    assert exact.weighted(0.0, 0.7) == 0.7
    weights = np.array([[0.75]]), np.array([[1.0]])
    worth = exact.worth_of(weights, 0.5, np.ones((1, 1)), np.zeros((1, 1)), risk)
    assert worth[0, 0] == pytest.approx(exact.certain_value([0.5, -1.0], [0.75, 0.25], risk), abs=2e-3)


def test_the_slippery_lake_by_hand() -> None:
    """The goal is six slips of luck away, by three ways; without a limit 14 of 17 episodes get there."""
    best = [methods.lake_optimum(steps) for steps in (5, 6, 100, 2_000)]
    assert best[:2] == [0.0, pytest.approx(3 / 3**6)]
    assert 0.7 < best[2] < best[3] == pytest.approx(14 / 17)


def test_fixed_rules() -> None:
    """A drive loses 2 % of the balls, a chip none; the fast plan is near the optimum, the safe one has no spread."""
    assert methods.landings(2, balls=20_000)[1] == pytest.approx(0.0196, abs=0.003)
    assert methods.landings(1)[1] == 0.0
    assert methods.landings(0, balls=10)[0].shape == (10, 2)
    rules = methods.play_by_rules()
    assert rules[methods.FAST_RULE][0] == pytest.approx(exact.optimum(methods.LEVEL), abs=0.01)
    assert rules[methods.SAFE_RULE] == pytest.approx((0.79, 0.03), abs=0.01)
    assert rules["only putts"] == (-1.0, 0.0)
    coin = rules["a coin: the fast plan in 50% of the games"]
    assert coin[0] == pytest.approx((rules[methods.FAST_RULE][0] + rules[methods.SAFE_RULE][0]) / 2)


def test_stochasticity() -> None:
    """Four runs of each player; 1 ball in 500 is no more hardly a ball, and 0.02 no more within 0.02."""

    def player(lost: list[float], spread: list[float], mean: float, hits: int) -> methods.Played:
        games = np.zeros((4, 11))
        games[:, hits] = 1.0
        return methods.Played(np.full(4, mean), np.array(spread), np.array(lost), games)

    players = {
        methods.AVERSE: player([0.0, 0.001, 0.0019, 0.01], [0.1] * 4, 0.7, 3),
        methods.NEUTRAL: player([0.0, 0.0021, 0.01, 0.02], [0.119, 0.0, 0.3, 0.081], 0.8, 2),
        methods.SEEKING: player([0.04] * 4, [0.5] * 4, 0.75, 1),
    }
    lost = [(0.0321 - 0.0129) / 4, 0.04 - 0.0321 / 4]
    spread = [0.1 - 0.125, 0.5 - 0.125]
    claims = experiments.risk_claims(players)
    assert measured(claims) == pytest.approx([0.75, *lost, *spread, -0.1, 1.0, -0.05, -1.0], abs=1e-6)
    assert claims[1].remark == "25% of the neutral runs hardly lose any either"
    balance = experiments.in_balance(players[methods.SEEKING], players[methods.NEUTRAL])
    assert balance == "lost balls bring it -0.06, and hits +0.01"  # 1.81 for each of 0.032 balls
    assert measured(experiments.noisy_claims(players)) == [0.25, 0.5, -0.05]
    assert measured(experiments.hidden_claims(players)) == pytest.approx([-0.05, lost[1]], abs=1e-6)


def test_only_the_first_swing_is_chosen() -> None:
    """A rule plays on to the end, so a game has one step; a drive pays 0.87 and a chip 0.79, as with the safe plan."""
    game: Any = drive.first_swing_only(methods.LEVEL)
    rng = np.random.default_rng(1)
    tee = game.initial(rng)
    for swing, expected in ((1, 0.79), (2, 0.865)):
        balls = [game.transition(tee, swing, rng) for _ in range(3_000)]
        assert all(game.terminal(ball) for ball in balls)
        returns = [game.reward(tee, swing, ball, rng) for ball in balls]
        assert np.mean(returns) == pytest.approx(expected, abs=0.02)


def test_what_is_taken_away() -> None:
    """Each method of four runs, and how many more of them start with a drive."""
    starts = {drive.AS_IT_IS: [0, 0, 0, 1], drive.NO_BAD_LUCK: [0, 0, 1, 1], drive.REST_KNOWN: [1, 1, 0, 1]}
    one = {label: np.array(values, float) for label, values in starts.items()}
    claims = noise.cause_claims(dict.fromkeys((*noise.CAUSES, noise.NEAR_THE_CROSSING), one))
    assert measured(claims) == [0.5] * 3 + [0.25] * 3 + [0.75]
    found = drive.without_causes(n_steps=60, repetitions=2)
    assert [*found] == [drive.AS_IT_IS, drive.NO_BAD_LUCK, drive.REST_KNOWN, drive.NEITHER]
    assert all({*runs} <= {0.0, 1.0} and len(runs) == 2 for runs in found.values())


def test_runs_of_the_experiment_are_those_as_it_is() -> None:
    """Curves with more points are of the same training, so these runs need not be done again."""
    brief: dict[str, Any] = {"n_steps": 600, "repetitions": 8, "seed": 1}
    known = methods.learn(**brief)
    again = drive.without_causes(**brief)[drive.AS_IT_IS]
    assert 0 < again.mean() < 1
    assert drive.without_causes(as_it_is=known, **brief)[drive.AS_IT_IS].tolist() == again.tolist()


def test_figures_of_games() -> None:
    """Bars of lost games first, six hits or more in one; mean, spread and lost balls have a panel each."""
    two = {"one": methods.played([np.array(SHARES)], 10), "other": methods.played([np.eye(11)[2], np.eye(11)[0]], 10)}
    ax = figures.Games(two).draw(new_axes())
    bars: list[Any] = [*ax.patches]
    assert [bar.get_height() for bar in bars[:7]] == pytest.approx([0.1, 0.0, 0.2, 0.3, 0.1, 0.1, 0.2])
    assert [bar.get_height() for bar in bars[7:]] == [0.5, 0.0, 0.5, 0.0, 0.0, 0.0, 0.0]
    assert [bar.get_x() for bar in (bars[0], bars[7], bars[8])] == pytest.approx([-0.4, 0.0, 1.0])
    assert [label.get_text() for label in ax.get_xticklabels()] == ["lost", "1", "2", "3", "4", "5", "6+"]
    lost = np.array([0.0, 0.01, 0.011, 0.02])
    first = methods.Played(np.full(4, 0.7), np.full(4, 0.2), lost, np.zeros((4, 11)))
    other = methods.Played(np.full(4, 0.6), np.full(4, 0.3), lost[::-1], np.zeros((4, 11)))
    panels: Any = figures.outcomes({"one": first, "other": other}).rows[0]
    assert [panel.title for panel in panels] == ["mean", "spread", "lost balls"]
    assert [[values.tolist()[0] for values in panel.measured.values()] for panel in panels] == [
        [0.7, 0.6], [0.2, 0.3], [0.0, 0.02],
    ]  # fmt: skip
    assert methods.share_of_drivers(first) == 0.5
    assert methods.lead(first, other).estimate == pytest.approx(0.1)
    learned: Any = figures.frontier_figure({"a": (0.5, 0.1), "b": (0.6, 0.2)}, ["b"], {"one": first})
    assert learned.learned == {"one": (pytest.approx(0.7), pytest.approx(0.2))}


@pytest.mark.parametrize("hits", [True, False])
def test_runs_by_their_first_swing(hits: bool) -> None:
    """Two of three drive: how many, their mean return, and their share of lost balls; hits may be hidden."""
    task = Golf.create(observe_hits=hits)
    rng = np.random.default_rng(0)
    shape = (task.width, task.length, *[task.max_hits + 1] * hits)
    tee = np.ravel_multi_index(tuple(task.observation(task.initial(rng), rng)), shape)
    agents = [SimpleNamespace(Q=np.zeros((int(np.prod(shape)), 3))) for _ in range(3)]
    for agent, swing in zip(agents, (2, 1, 2), strict=True):
        agent.Q[tee, swing] = swing
    label = methods.NEUTRAL
    results = made_up({label: [{10: 0.0}] * 3}, agents={label: agents})
    one = methods.Played(np.array([0.5, 0.7, 0.9]), np.zeros(3), np.array([0.02, 0.0, 0.04]), np.zeros((3, 11)))
    groups = methods.by_first_swing(results, {label: one}, observe_hits=hits)[label]
    assert groups == {"chip": (1, 0.7, 0.0), "drive": (2, pytest.approx(0.7), pytest.approx(0.03))}
    if hits:
        assert methods.values_on_the_tee(results)[label] == pytest.approx([0.0, 1 / 3, 4 / 3])
