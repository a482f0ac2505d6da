"""The players of lesson 13, how two of them are trained against each other, and how exploitable they are, exactly."""

from collections.abc import Callable, Mapping
from functools import cache, partial
from pathlib import Path
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np

from edugym.agents.fictitious_play import FictitiousPlay
from edugym.agents.fixed_player import FixedPlayer
from edugym.agents.minimax_q import MinimaxQ
from edugym.agents.q_learning import QLearning
from edugym.agents.strategies import EpsilonGreedy
from edugym.agents.tables import best_value, epsilon_greedy_action, greedy_action, one_step_target
from edugym.envs.games.matrix_games import MatchingPennies, PrisonersDilemma, RockPaperScissors, matrix_game
from edugym.envs.games.soccer import Soccer
from edugym.exact.game_model import GameModel, exploitability, game_model
from edugym.exact.shapley import GameValues, minimax_value_iteration
from edugym.exact.value_iteration import value_iteration
from edugym.experiments.results.tables import Results
from edugym.mdp.markov_game import table_shape
from edugym.mdp.protocol import Random, Reals
from edugym.training.train_players import train_players
from edugym_course.lessons.several_agents.turns import SoccerInTurns, ToldWhoseTurn

ALONE, MINIMAX, FICTITIOUS, TAUGHT = "Q-learning, each alone", "minimax Q-learning", "fictitious play", "taught"
TOLD = "minimax Q, told whose turn it is"
EPSILON, DISCOUNT = 0.2, 0.9
LEFT = 0.01
"""What is left of the learning rate at the end: it falls from 1 to 0.01, as Littman's."""
N_STEPS, N_CONTROL, N_MATRIX = 1_000_000, 300_000, 10_000
"""Training steps in soccer, without contact, where less is enough, and in matrix games."""
POINTS = 5
"""How often exploitability is computed while they learn: besides at the start."""
REPETITIONS = 5
N_CHANGES, EVERY, SLOWLY = 10_000, 50, 0.01
"""Of the runs in which best actions are looked at: their steps, how often, and the learning rate."""
EXACT = 1e-9
"""A difference that is more than rounding."""

Maker = Callable[[Any, int, int, float], Any]
"""Makes a player: of a game, which one (0 or 1), for so many training steps, with a discount."""


class IndependentQ(NamedTuple):
    """Q-learning that takes the other player for a part of the world.

        Q(S, A) <- Q(S, A) + α [R + γ max_a Q(S', a) - Q(S, A)]

    It is `edugym.QLearning` with the learning rate of `MinimaxQ`, which falls, and with its first values and its ε. So
    the two differ in their equation alone.

    Attributes:
        Q: shape (n_observations, n_actions).
        share: shape (1,): what the decay has left of the learning rate.
        decay: the learning rate, 1 at first, is multiplied by this after each step.
        discount: γ.
        epsilon: the probability of a uniformly random action.
    """

    Q: Reals
    share: Reals
    decay: float
    discount: float
    epsilon: float

    def learn(self, state: int, action: int, reward: float, next_state: int, terminated: bool) -> None:
        """Move Q(S, A) towards R + γ max_a Q(S', a)."""
        target = one_step_target(reward, self.discount, best_value(self.Q, next_state), terminated)
        self.Q[state, action] += self.share[0] * (target - self.Q[state, action])
        self.share[0] *= self.decay

    def act(self, state: int, rng: Random) -> int:
        """The best action, but with probability ε any."""
        return epsilon_greedy_action(self.Q, state, self.epsilon, rng)

    def greedy(self, state: int, rng: Random) -> int:
        """The best action."""
        return greedy_action(self.Q, state, rng)


def independent(game: Any, player: int, n_steps: int, discount: float = DISCOUNT, epsilon: float = EPSILON) -> Any:
    """Return a player who learns as if alone."""
    decay = LEFT ** (1 / n_steps)
    return IndependentQ(np.ones(table_shape(game, player)), np.ones(1), decay, discount, epsilon)


def minimax(game: Any, player: int, n_steps: int, discount: float = DISCOUNT, epsilon: float = EPSILON) -> MinimaxQ:
    """Return a minimax Q-learner, with the settings of Littman for so many steps."""
    return MinimaxQ.create(game, player, decay=LEFT ** (1 / n_steps), discount=discount, epsilon=epsilon)


def fictitious(game: Any, player: int, n_steps: int, discount: float = DISCOUNT) -> FictitiousPlay:
    """Return a player who answers the average play of the other."""
    return FictitiousPlay.create(game, player, discount=discount, epsilon=EPSILON, initial_value=1.0)


BOTH: Mapping[str, Maker] = MappingProxyType({ALONE: independent, MINIMAX: minimax})
LEARNERS: Mapping[str, Maker] = MappingProxyType({**BOTH, FICTITIOUS: fictitious})


def told(game: Any, player: int, n_steps: int, discount: float = DISCOUNT) -> ToldWhoseTurn:
    """Return a minimax Q-learner that is told whose action counts, with the same learning rate at each step."""
    updates = n_steps * int(game.action_space(player).n)
    return ToldWhoseTurn(minimax(game, player, updates, discount), player)


IN_TURNS: Mapping[str, Maker] = MappingProxyType({**BOTH, TOLD: told})


class Known(NamedTuple):
    """A game with its exact model."""

    game: Any
    model: GameModel


DARING = ((0.0, -1.0, 3.0), (1.0, 0.0, -1.0), (-3.0, 1.0, 0.0))
"""Rock-paper-scissors in which rock wins 3 from scissors: what player 0 gets."""
MATRIX_GAMES: Mapping[str, Callable[[], Any]] = MappingProxyType(
    {
        "rock-paper-scissors": RockPaperScissors.create,
        "matching pennies": MatchingPennies.create,
        "daring rock-paper-scissors": partial(matrix_game, DARING),
        "prisoner's dilemma": PrisonersDilemma.create,
        "prisoner's dilemma, temptation 4": partial(PrisonersDilemma.create, 4),
        "prisoner's dilemma, temptation 8": partial(PrisonersDilemma.create, 8),
    }
)
NO_SAFE_ACTION, DOMINANT = tuple(MATRIX_GAMES)[:3], tuple(MATRIX_GAMES)[3:]
"""The games whose only equilibrium is random, and those in which one action is best whatever the other does."""


@cache
def matrix(name: str) -> Known:
    """Return a matrix game, by its name, with its model."""
    game = MATRIX_GAMES[name]()
    return Known(game, game_model(game))


@cache
def soccer(contact: float = 1.0) -> Known:
    """Return soccer with its model, which takes a second."""
    game = Soccer.create(contact=contact)
    return Known(game, game_model(game))


@cache
def in_turns(contact: float = 1.0) -> Known:
    """Return soccer in turns with its model."""
    game = SoccerInTurns(Soccer.create(contact=contact))
    return Known(game, game_model(game))


@cache
def solution(contact: float = 1.0, discount: float = DISCOUNT) -> GameValues:
    """Return the safe policies of soccer, computed exactly, and what they are worth."""
    return minimax_value_iteration(soccer(contact).model, discount)


def taught(game: Any, player: int, n_steps: int, discount: float = DISCOUNT) -> Any:
    """Return one who learns as if alone as player 0, and as player 1 one who never learns: a safe policy."""
    if player == 0:
        return independent(game, player, n_steps, discount)
    return FixedPlayer.create(game, player, solution(game.contact, discount).policies[player])


def with_best_answers(known: Known, policy: Any, discount: float = DISCOUNT) -> tuple[float, Reals]:
    """Correct a policy of player 0 in soccer where it is no best answer to a safe player 1.

    Returns:
        The share of the states of the game in which its action is a best answer, and the policy with a best answer in
        the others, too.
    """
    model = known.model.against(0, solution(known.game.contact, discount).policies[1])
    solved, corrected = value_iteration(model, discount), np.array(policy)
    states = known.model.joint[0].states
    playing = [row for row, state in enumerate(states) if not known.game.terminal(state)]
    best = known.model.by_observation(0, solved.greedy_policy())
    wrong = []
    for row in playing:
        seen = known.game.observation(states[row], 0, None)
        if solved.Q[row].max() - corrected[seen] @ solved.Q[row] > EXACT:
            wrong.append(seen)
    corrected[wrong] = best[wrong]
    return 1 - len(wrong) / len(playing), corrected


def random_states(known: Known, discount: float = DISCOUNT) -> int:
    """Return in how many states of a game every action by itself guarantees player 0 less than a random choice."""
    return len(rows_that_need_chance(minimax_value_iteration(known.model, discount)))


def blind_to_contact(discount: float = DISCOUNT) -> float:
    """Return how exploitable two are in soccer in turns who play what would be safe there without contact."""
    policies = minimax_value_iteration(in_turns(0.0).model, discount).policies
    return exploitability(in_turns().model, policies, discount)


def rows_that_need_chance(solved: GameValues) -> Any:
    """Return the numbers of the states in which every action by itself guarantees player 0 less than it could have."""
    without_chance = solved.Q.min(axis=2).max(axis=1)
    return np.flatnonzero(solved.V - without_chance > EXACT)


def with_safe_choices(policies: Any, *, elsewhere: bool, discount: float = DISCOUNT) -> list[Reals]:
    """Return two policies of soccer that are safe where a random choice is needed, or `elsewhere`, and nowhere else."""
    known, solved = soccer(), solution(1.0, discount)
    states = known.model.joint[0].states
    mixed = []
    for player, own in enumerate(policies):
        without_chance = solved.Q.max(axis=1).min(axis=1) if player else solved.Q.min(axis=2).max(axis=1)
        rows = np.flatnonzero(np.abs(solved.V - without_chance) > EXACT)
        needed = [known.game.observation(states[row], player, None) for row in rows]
        policy, other = (solved.policies[player], own) if elsewhere else (own, solved.policies[player])
        policy = np.array(policy)
        policy[needed] = np.asarray(other)[needed]
        mixed.append(policy)
    return mixed


def can_lose(known: Known, player: int, policy: Any, discount: float = DISCOUNT) -> float:
    """Return what the best opponent of a policy wins from it on average: 0 for the solution, where the value is 0."""
    return value_iteration(known.model.against(1 - player, policy), discount).start


def best_answer(known: Known, player: int, policy: Any, discount: float = DISCOUNT) -> Reals:
    """Return the best policy of the other player against a policy of this one, by what the other observes."""
    values = value_iteration(known.model.against(1 - player, policy), discount)
    return known.model.by_observation(1 - player, values.greedy_policy())


def weakest_state(policy: Any) -> tuple[Any, float, float]:
    """Return where a policy of player 0 in soccer guarantees least of what it could, with the ball, and needs chance.

    Returns:
        The state, what a safe policy guarantees there, and what the policy does.
    """
    known, solved = soccer(), solution()
    against = value_iteration(known.model.against(1, policy), DISCOUNT)
    states = [known.model.joint[0].states[row] for row in rows_that_need_chance(solved)]
    mine = [state for state in states if state.ball == 0]
    worst = max(mine, key=lambda state: solved.value(state) + against.value(state))
    return worst, solved.value(worst), -against.value(worst)


def losses(known: Known, policies: Any, discount: float) -> float:
    """Return what the best opponent wins from the policy of player 0, whatever player 1 does now."""
    return can_lose(known, 0, policies[0], discount)


def gains(known: Known, policies: Any, discount: float) -> float:
    """Return how exploitable both are."""
    return exploitability(known.model, policies, discount)


def compare(
    known: Known,
    methods: Mapping[str, Maker],
    n_steps: int,
    *,
    discount: float = DISCOUNT,
    measure: Callable[[Known, Any, float], float] = gains,
    repetitions: int = REPETITIONS,
    seed: int = 0,
    points: int = POINTS,
    stop: Any = None,
    save_to: Path | None = None,
    **_: Any,
) -> Results:
    """Train two players of each kind against each other, and measure what they have learned.

    Args:
        known: the game.
        methods: by label, what makes a player.
        n_steps: the training steps of each run.
        discount: γ of the players, and of the measure.
        measure: what is measured of a pair of policies.
        repetitions: the runs of each method.
        seed: the number from which their seeds are drawn.
        points: how often it is measured, besides at the start.
        stop: an event that ends it.
        save_to: where the table is saved; None saves nothing.

    Returns:
        What was measured, as if it were the return.
    """
    import pandas

    seeds = np.random.SeedSequence(seed).generate_state(repetitions)
    rows: list[dict[str, Any]] = []
    agents: dict[str, dict[int, Any]] = {method: {} for method in methods}
    for method, make in methods.items():
        for repetition, own in enumerate(map(int, seeds)):
            players = [make(known.game, player, n_steps, discount) for player in (0, 1)]
            run = train_players(known.game, players, n_steps, evaluate_every=-(-n_steps // points), seed=own, stop=stop)
            agents[method][repetition] = run.agents
            rows += [
                {
                    "method": method,
                    "repetition": repetition,
                    "seed": own,
                    "step": int(run.steps[i]),
                    "return": measure(known, run.policies[i], discount),
                    "training_return": float(run.training_returns[i, 0]),
                    "episodes": int(run.episodes[i]),
                    "complete": run.complete,
                }
                for i in range(len(run.steps))
            ]
    settings: dict[str, Any] = {"environment": type(known.game).__name__, "discount": discount, "n_steps": n_steps}
    table = pandas.DataFrame(rows).assign(**settings, repetitions=repetitions, runs=repetitions * len(methods))
    results = Results(table, agents)
    if save_to is not None:
        results.save(save_to)
    return results


def dilemma(temptation: float, learning_rate: float = 0.1, epsilon: float = 0.1, **how: Any) -> Results:
    """Let pairs of Q-learners play the prisoner's dilemma for 1 000 games; for `how` see `compare`."""
    game = PrisonersDilemma.create(temptation)
    settings: Any = {"learning_rate": learning_rate, "exploration": EpsilonGreedy(epsilon)}

    def create(game: Any, player: int, n_steps: int, discount: float) -> Any:
        return QLearning.create(table_shape(game, player), **settings)

    return compare(Known(game, game_model(game)), {ALONE: create}, 1_000, points=10, **how)


def choosing(results: Results, action: int) -> Reals:
    """Whether in the end both players of a pair prefer this action, 1 or 0, by pair."""
    ends = [{int(agent.Q[0].argmax()) for agent in both} for both in results.agents[ALONE].values()]
    return np.array([float(end == {action}) for end in ends])


def best_actions(run: Any) -> Any:
    """Return the best action of each player at each point of a run of matrix games: shape (n_points, 2)."""
    return np.array([[int(policy[0].argmax()) for policy in pair] for pair in run.policies])


def against_each_other(name: str, *, learns: bool, seed: int, n_steps: int = N_CHANGES, every: int = EVERY) -> Any:
    """Let a Q-learner play a matrix game, and return the run.

    Args:
        name: of the game.
        learns: whether player 1 learns in the same way; else it draws from the same policy for ever, and takes its
            action 0 in four of five steps.
        seed: of the run.
        n_steps: the training steps.
        every: after how many steps one looks.
    """
    game = matrix(name).game
    first, second = (QLearning.create(table_shape(game, player), learning_rate=SLOWLY) for player in (0, 1))
    n = table_shape(game, 1)[1]
    fixed = FixedPlayer.create(game, 1, [[0.8] + [0.2 / (n - 1)] * (n - 1)])
    return train_players(game, (first, second if learns else fixed), n_steps, evaluate_every=every, seed=seed)


def changes(run: Any) -> float:
    """Return how often the best action of player 0 changes in 1 000 steps, in the second half of a run."""
    actions, every = best_actions(run)[len(run.steps) // 2 :, 0], run.steps[1] - run.steps[0]
    return float(1_000 / every * (actions[1:] != actions[:-1]).mean())
