"""Stochasticity in Golf: the claims hold with other seeds than those the lesson shows."""

import numpy as np
import pytest

from edugym import QLearning, Results
from edugym.envs.golf import SWINGS, Golf
from edugym.experiments.figures import Sheet
from edugym_course.lessons.stochasticity import figures, methods
from edugym_course.lessons.stochasticity.exact import (
    certain_value,
    crossing,
    from_the_tee,
    interpolated,
    optimum,
    soft_optimum,
    weighted,
    worth_of,
)
from edugym_course.lessons.stochasticity.figures import Dots
from edugym_course.lessons.stochasticity.methods import (
    AVERSE,
    FAST_RULE,
    LEVEL,
    NEUTRAL,
    RISKS,
    SAFE_RULE,
    SEEKING,
    Played,
    Player,
    lake_optimum,
    landings,
    learn,
    learned_value,
    play,
    play_by_rules,
    share_learned,
    values_on_the_tee,
)
from tests.course.lessons.figures import check_legends


def test_with_little_noise_it_takes_two_hits() -> None:
    """A drive leaves 3.5 cells and a chip then reaches the green; so does the other order. A putt costs a hit."""
    worth = from_the_tee(0.002)
    assert worth["drive"] == pytest.approx(0.9, abs=0.002)
    assert worth["chip"] == pytest.approx(0.9, abs=0.002)
    assert worth["putt"] == pytest.approx(0.8, abs=0.01)


def test_exact_play_against_samples() -> None:
    """A player who drives from the tee and then follows the best swing for the distance cannot beat the exact value.

    A simple player who sees where the ball lies comes close to it.
    """
    golf, rng = Golf.create(), np.random.default_rng(0)
    returns = []
    for _ in range(4_000):
        state, total = golf.initial(rng), 0.0
        while not golf.terminal(state):
            left = np.hypot(golf.width / 2 - state.x, golf.length - golf.width / 2 - state.y)
            action = 2 if left > 8.0 else 1 if left > 3.0 else 0
            next_state = golf.transition(state, action, rng)
            total += golf.reward(state, action, next_state, rng)
            state = next_state
        returns.append(total)
    exact = from_the_tee(LEVEL)["drive"]
    assert exact - 0.02 < np.mean(returns) < exact + 0.02


def test_the_grid_is_fine_enough() -> None:
    """Half as many places on each side change the value of the best swing by less than 0.001."""
    assert from_the_tee(LEVEL, 0.25)["drive"] == pytest.approx(from_the_tee(LEVEL)["drive"], abs=0.001)
    worth = from_the_tee(crossing())
    assert worth["drive"] == pytest.approx(worth["chip"], abs=1e-3)


@pytest.mark.parametrize(("risk", "low", "high", "expected"), [(-2.0, 0.015, 0.018, 0.016), (2.0, 0.04, 0.06, 0.051)])
def test_the_attitude_moves_the_crossing(risk: float, low: float, high: float, expected: float) -> None:
    """Every player stops driving at some level, also the seeking one, and drive and chip are worth the same there."""
    level = crossing(low, high, cell=0.25, risk=risk)
    assert level == pytest.approx(expected, abs=5e-4)
    worth = from_the_tee(level, 0.25, risk=risk)
    assert worth["drive"] == pytest.approx(worth["chip"], abs=1e-3)


def test_interpolated() -> None:
    """On the grid its values, and between them the mean."""
    values = np.array([[0.0, 1.0, 2.0], [4.0, 5.0, 6.0], [0.0, 0.0, 0.0]])
    places = np.array([0.0, 0.0, 0.5, 0.5]), np.array([0.0, 0.5, 0.0, 0.5])
    assert interpolated(values, *places).tolist() == [0.0, 0.5, 2.0, 2.5]


def test_player_counts_hits() -> None:
    """Its score has lost games first, then those won with 1, 2, ... hits."""
    task = Golf.create()
    player = Player.create(task, np.zeros((task.width * task.length, 3)))
    for reward, terminated in ((-1.0, True), (0.0, False), (0.9, True), (0.7, True), (0.1, True), (1.0, True)):
        player.learn(reward, terminated)
    assert player.score[0].tolist() == [1, 1, 1, 0, 1, 0, 0, 0, 0, 0, 1]


def test_playing_changes_nothing_and_agrees_with_the_evaluation() -> None:
    """The mean of the score is the return of the greedy policy."""
    results = learn(n_steps=20_000, repetitions=2, evaluation_episodes=2_000, risks={NEUTRAL: 0.0})
    before = [agent.Q.copy() for agent in results.complete_agents(NEUTRAL).values()]
    played = play(results)[NEUTRAL]
    assert played.mean == pytest.approx(results.final(NEUTRAL), abs=0.06)
    for agent, Q in zip(results.complete_agents(NEUTRAL).values(), before, strict=True):
        assert (agent.Q == Q).all()


def test_without_noise_there_is_no_risk() -> None:
    """Negative control: all three find two hits, and lose no ball."""
    results = learn(level=0.0, n_steps=60_000, repetitions=3)
    for method in (AVERSE, NEUTRAL, SEEKING):
        played = play(results, level=0.0)[method]
        assert played.lost.tolist() == [0.0] * 3
        assert played.spread == pytest.approx(0.0, abs=1e-6)


def test_exact_attitudes() -> None:
    """A tiny β changes nothing; an averse player stops driving earlier, and a seeking one later."""
    neutral, nearly = from_the_tee(LEVEL, 0.25), from_the_tee(LEVEL, 0.25, risk=1e-9)
    for swing, worth in neutral.items():
        assert nearly[swing] == pytest.approx(worth, abs=1e-6)

    def lead(level: float, risk: float) -> float:
        worth = from_the_tee(level, 0.25, risk=risk)
        return worth["drive"] - worth["chip"]

    assert lead(0.0175, -2.0) < 0 < lead(0.0175, 0.0)
    assert lead(0.02, 0.0) < 0 < lead(0.02, 2.0)


def test_worth_of_two_places() -> None:
    """A swing that leads to the green or to the water is worth what the lottery of the two is worth."""
    weights = np.array([[0.75]]), np.array([[1.0]])
    for risk in (-2.0, 0.0, 2.0):
        worth = worth_of(weights, 0.5, np.ones((1, 1)), np.zeros((1, 1)), risk)
        assert worth[0, 0] == pytest.approx(certain_value([0.5, -1.0], [0.75, 0.25], risk), abs=2e-3)


def test_soft_optimum() -> None:
    """Without exploring it is the optimum, and with it less."""
    assert soft_optimum(LEVEL, 0.0) == pytest.approx(optimum(LEVEL))
    assert optimum(LEVEL) - 0.1 < soft_optimum(LEVEL, 0.1) < optimum(LEVEL) - 0.03
    assert from_the_tee(0.0228, max_hits=5)["drive"] > from_the_tee(0.0228, max_hits=5)["chip"]


@pytest.mark.parametrize("risk", [-2.0, 0.0, 2.0])
def test_value_of_normal_rewards(risk: float) -> None:
    """It is mean + β/2 variance, exactly, and that is what is learned."""
    rewards = np.linspace(-1.5, 3.1, 2_001)
    chances = np.exp(-(((rewards - 0.8) / 0.3) ** 2) / 2)
    exact = certain_value(rewards, chances / chances.sum(), risk)
    assert exact == pytest.approx(0.8 + risk / 2 * 0.09, abs=1e-4)
    assert learned_value(risk, lambda rng: rng.normal(0.8, 0.3), seed=5) == pytest.approx(exact, abs=0.02)
    assert weighted(0.0, 0.7) == 0.7


def test_risk_is_not_the_variance() -> None:
    """Of two lotteries with equal mean and variance an averse agent prefers the rare win."""
    rare_loss = certain_value([0.2, -1.8], [0.9, 0.1], -2.0)
    rare_win = certain_value([-0.2, 1.8], [0.9, 0.1], -2.0)
    assert rare_loss < -0.4 < -0.25 < rare_win


def test_where_balls_land() -> None:
    """A drive from the tee loses 2 % of the balls, as the normal distribution says; a chip none."""
    assert landings(2, balls=20_000)[1] == pytest.approx(0.0196, abs=0.003)
    assert landings(1)[1] == 0.0
    assert landings(0, balls=10)[0].shape == (10, 2)


def test_players_with_rules() -> None:
    """The fast plan is near the optimum, the safe one has hardly a spread, and who only putts has none."""
    rules = play_by_rules()
    assert rules[FAST_RULE][0] == pytest.approx(optimum(LEVEL), abs=0.01)
    assert rules[SAFE_RULE] == pytest.approx((0.79, 0.03), abs=0.01)
    assert rules["only putts"] == (-1.0, 0.0)
    coin = rules["a coin: the fast plan in 50% of the games"]
    assert coin[0] == pytest.approx((rules[FAST_RULE][0] + rules[SAFE_RULE][0]) / 2)


@pytest.fixture(scope="module")
def trained() -> Results:
    """The three players with other seeds."""
    return learn(repetitions=12, seed=7)


def test_bad_luck_and_patience(trained: Results) -> None:
    """The drive is valued too low, and half of the runs do not drive; a patient player does, and is at the optimum."""
    believed, played = values_on_the_tee(trained), play(trained)
    assert believed[NEUTRAL][2] < from_the_tee(LEVEL)["drive"] - 0.05
    assert 0.2 < methods.share_of_drivers(played[NEUTRAL]) < 0.85
    patient = play(methods.patient(repetitions=4, seed=7))[NEUTRAL]
    assert methods.share_of_drivers(patient) == 1.0
    assert patient.mean.mean() == pytest.approx(optimum(LEVEL), abs=0.01)


def test_the_order_of_swings(trained: Results) -> None:
    """Runs that drive first earn most, and those that seek risk and chip first lose more balls than they."""
    groups = methods.by_first_swing(trained, play(trained))
    for swings in groups.values():
        assert sum(runs for runs, _, _ in swings.values()) == len(trained.complete_agents(NEUTRAL))
    seeking = groups[methods.SEEKING]
    assert seeking["drive"][1] > seeking["chip"][1]
    assert seeking["drive"][2] < seeking["chip"][2]


def test_first_swings_with_the_hits_hidden() -> None:
    """The tee has another row of the table then."""
    results = methods.learn(observe_hits=False, risks={NEUTRAL: 0.0}, n_steps=2_000, repetitions=2)
    played = play(results, observe_hits=False)
    groups = methods.by_first_swing(results, played, observe_hits=False)[NEUTRAL]
    task = Golf.create()
    rng = np.random.default_rng(0)
    tee = np.ravel_multi_index(task.observation(task.initial(rng), rng), (task.width, task.length))
    first = [SWINGS[int(agent.Q[tee].argmax())] for agent in results.complete_agents(NEUTRAL).values()]
    assert {swing: runs for swing, (runs, _, _) in groups.items()} == {swing: first.count(swing) for swing in first}


def test_shares_of_games(trained: Results) -> None:
    """They add up to 1, and the first is that of lost balls."""
    for one in play(trained).values():
        np.testing.assert_allclose(one.games.sum(axis=1), 1.0)
        assert (one.games[:, 0] == one.lost).all()


def test_figures(trained: Results) -> None:
    """They draw, with labels on all axes and the same methods in the same order."""
    played = play(trained)
    rules = play_by_rules(n_steps=2_000)
    sheets = [
        figures.landings_figure(),
        figures.weights_figure(),
        figures.learning_curves(trained),
        figures.outcomes(played),
        figures.games_figure(played),
        figures.slider_figure(trained, played, 0.0, 0.1),
        figures.race({"own": QLearning.create}, played, repetitions=2, n_steps=2_000),
        Sheet("more", [[figures.frontier_figure(rules, [SAFE_RULE], played)]]),
        Sheet("levels", [[*figures.against_level((0.01, 0.02), repetitions=2, n_steps=2_000)]]),
    ]
    for sheet in sheets:
        assert all(ax.get_xlabel() for ax in sheet.draw().axes)
        check_legends(sheet)
    players = figures.frontier_figure(rules, [SAFE_RULE], played).draw()
    assert players.get_legend_handles_labels()[1] == ["players with rules", "your frontier", *played]
    assert len(np.asarray(players.lines[0].get_xdata())) == len(rules)
    attitudes = figures.crossing_by_attitude((0.015, 0.02))
    assert [*attitudes.lines] == [*RISKS] == [*played]
    assert figures.crossing_lines((0.015, 0.02)).change == pytest.approx(0.0187, abs=1e-4)
    alone = [panel for sheet in sheets[:1] + sheets[3:5] for panel in sheet.rows[0]]
    for panel in (figures.crossing_lines((0.015, 0.02)), attitudes, *sheets[-1].rows[0], *alone):
        assert panel.draw().get_legend() is not None


def test_the_lake() -> None:
    """Within 100 steps the best walker arrives in three of four walks; α = 1 is fine where nothing slips."""
    assert lake_optimum() == pytest.approx(0.74, abs=0.01)
    dry = methods.compare_on_lake(slippery=False, rates=(1.0,), n_steps=2_000, repetitions=2)
    assert (dry.final("α = 1") == 1.0).all()
    icy = methods.compare_on_lake(slippery=True, rates=(1.0,), n_steps=500, repetitions=1)
    assert len(figures.lake_figure(dry, icy, 0.74).draw().axes) == 2


def test_every_number_of_theory_is_drawn() -> None:
    """There are two looks for them; a third has the first again."""
    ax = Dots({}, theory={"one": 1.0, "two": 2.0, "three": 3.0}).draw()
    assert [line.get_label() for line in ax.lines] == ["one", "two", "three"]


def test_what_was_learned_after_some_steps() -> None:
    """From 0 to 3 of 4: three quarters."""
    results = learn(n_steps=60, repetitions=2, points=6, risks={NEUTRAL: 0.0})
    results.table["return"] = results.table["step"].map(lambda step: {0: 0.0, 10: 3.0}.get(step, 4.0))
    assert share_learned(results, 10).tolist() == [0.75, 0.75]


def test_hits_of_games_that_are_won() -> None:
    """Lost games do not count: half of the games take one hit and a quarter take three, so 5/3; nobody wins: NaN."""
    games = np.array([[0.25, 0.5, 0.0, 0.25], [1.0, 0.0, 0.0, 0.0]])
    nothing = np.zeros(2)
    np.testing.assert_allclose(Played(nothing, nothing, nothing, games).hits, [5 / 3, np.nan])
