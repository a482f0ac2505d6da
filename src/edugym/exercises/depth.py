"""The exercises of lesson 3: Monte Carlo without exploration, a ratio of importance, and targets that are cut."""

import math
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np

from edugym.grading.challenge import Challenge
from edugym.grading.choices import check_choices
from edugym.grading.student_code import running
from edugym.grading.updates import table_of
from edugym.grading.values import compare, digits, given, same
from edugym.grading.wrong import WrongAnswer
from edugym.lessons.depth import DISCOUNT, LEARNING_RATE, label, maker
from edugym.mdp.protocol import Reals
from edugym.registration import make_mdp
from edugym.training.contract import learns_from

N_STATES, N_ACTIONS = 6, 3
"""The size of the tables on which agents are tried."""


class Episode(NamedTuple):
    """A made-up episode, which terminates.

    Attributes:
        states: the states, all different, without the terminal one.
        actions: the action in each.
        rewards: the reward after each.
    """

    states: list[int]
    actions: list[int]
    rewards: list[float]


def _episode(length: int, rng: np.random.Generator) -> Episode:
    """Make an episode up, of simple numbers."""
    states = [int(state) for state in rng.permutation(N_STATES - 1)[:length]]
    actions = [int(action) for action in rng.integers(N_ACTIONS, size=length)]
    rewards = [float(reward) for reward in rng.choice([-2.0, -1.0, 1.0, 2.0, 4.0], size=length)]
    return Episode(states, actions, rewards)


def _learn(agent: Any, episode: Episode) -> None:
    """Let a student's agent learn from an episode, with whatever its `learn` asks for."""
    try:
        names = learns_from(agent)
    except ValueError as error:
        raise WrongAnswer(str(error)) from None
    last = len(episode.states) - 1
    for k, (state, action, reward) in enumerate(zip(*episode, strict=True)):
        after = episode.states[k + 1] if k < last else N_STATES - 1
        told = {
            "state": state,
            "action": action,
            "reward": reward,
            "next_state": after,
            "next_action": episode.actions[k + 1] if k < last else 0,
            "terminated": k == last,
            "truncated": False,
        }
        with running("learn(" + ", ".join(f"{name}={told[name]}" for name in names) + ")"):
            agent.learn(**{name: told[name] for name in names})


def _told(episode: Episode) -> str:
    return (
        f"states {episode.states}, actions {episode.actions} and rewards {[f'{r:g}' for r in episode.rewards]}".replace(
            "'", ""
        )
    )


def _make(call: str, make: Callable[[Any], Any], study: Any) -> Any:
    """Make a student's agent, and refuse what is none."""
    with running(call):
        made = make(study)
    given(call, made)
    if isinstance(made, type):
        raise WrongAnswer(
            f"{call} should give an agent, but gives the class {made.__name__}: write {made.__name__}.create"
        )
    missing = [name for name in ("act", "learn") if not hasattr(made, name)]
    if missing:
        raise WrongAnswer(
            f"{call} should give an agent, but what it gives, of the type {type(made).__name__}, has no `{missing[0]}`"
        )
    return made


# Exercise 1


def exercise_1(answer: Any, seed: int) -> str:
    """Check the function that makes a Monte Carlo agent without exploration."""
    given("quiet", answer)
    if isinstance(answer, type) or not callable(answer):
        kind = answer.__name__ if isinstance(answer, type) else type(answer).__name__
        raise WrongAnswer(f"quiet should be a function of the task that returns an agent, but is of the type {kind}")
    study = make_mdp("Study", layout_seed=seed)
    shape = int(np.prod(study.observation_space.nvec)), len(study.action_rewards)
    made, other = _make("quiet(study)", answer, study), _make("quiet(study)", answer, study)
    Q = table_of(made, "Q", shape)
    if np.shares_memory(Q, other.Q):
        raise WrongAnswer("two calls of quiet(study) share one table: make a new one in every call")
    if Q.any():
        raise WrongAnswer(f"every value in Q should be 0 at first, but one is {Q.ravel()[np.abs(Q).argmax()]:g}")
    small = make_mdp("Study", n_actions=2, layout_seed=seed)
    table_of(_make("quiet(study)", answer, small), "Q", (shape[0], 2))
    epsilon = getattr(getattr(made, "exploration", None), "epsilon", 0.0)
    if epsilon != 0.0:
        raise WrongAnswer(f"the quiet agent never explores, so ε should be 0, but it is {epsilon:g}")
    _check_depth(made, study, seed)
    n_actions = shape[1]
    Q[:] = 0.0
    Q[1, 1], Q[2, :] = 0.5, [-0.5, *[0.25] * (n_actions - 1)]
    others = n_actions - 1
    for state, expected in ((1, np.eye(n_actions)[1].tolist()), (2, [0.0, *[1 / others] * others])):
        check_choices(
            f"act({state}, rng)",
            partial(made.act, state),
            expected,
            {
                "it acts at random": [1 / n_actions] * n_actions,
                "ties should be broken at random, and it takes the first of equals": np.eye(n_actions)[1].tolist(),
                "ties should be broken at random, and it takes the last of equals": np.eye(n_actions)[-1].tolist(),
            },
            tables={"Q": Q},
            where=f"where Q[{state}] = {Q[state].tolist()}",
        )
    return "Right: its targets are all its own doing, and no action in them is random. See it race:"


def _check_depth(agent: Any, study: Any, seed: int) -> None:
    """Check that an agent learns from whole episodes of ten days, with the rate and discount of the lesson."""
    rng = np.random.default_rng(seed)
    days = study.total_days
    episode = Episode(
        list(range(days)),
        [int(action) for action in rng.integers(2, size=days)],
        [float(reward) for reward in rng.choice([-2.0, -1.0, 1.0, 2.0], size=days - 1)] + [8.0],
    )
    for _ in range(2):
        _learn_row(agent, episode, days)
    found = agent.Q[np.arange(days), episode.actions]
    cases = {
        (n, rate, discount): _values(episode, n, rate, discount)
        for n in (*range(1, days), math.inf)
        for rate in (LEARNING_RATE, 0.01, 0.05, 0.2, 0.3, 0.5, 1.0)
        for discount in (DISCOUNT, 0.9, 0.95, 0.99)
    }
    right = (math.inf, LEARNING_RATE, DISCOUNT)
    if np.allclose(found, cases[right]):
        return
    fits = [case for case, values in cases.items() if np.allclose(found, values)]
    if not fits:
        raise WrongAnswer(
            f"after two equal episodes with rewards {[f'{r:g}' for r in episode.rewards]}, the value of the first action".replace(
                "'", ""
            )
            + f" should be {digits(cases[right][0], found[0])}, but is {digits(found[0], cases[right][0])}: that is not"
            " n-step SARSA with a setting of the lesson"
        )
    n, rate, discount = fits[0]
    wrong = []
    if n != math.inf:
        wrong.append(f"it looks {n:g} step{'s' if n > 1 else ''} deep, and Monte Carlo has n = math.inf")
    if rate != LEARNING_RATE:
        wrong.append(f"it has a learning rate of {rate:g}, and it should be {LEARNING_RATE:g}")
    if discount != DISCOUNT:
        wrong.append(f"it has a discount of {discount:g}, and it should be {DISCOUNT:g}")
    raise WrongAnswer("the quiet agent should be that of the experiment, but " + "; and ".join(wrong))


def _learn_row(agent: Any, episode: Episode, end: int) -> None:
    """Let an agent learn from an episode through the states 0, 1, ..."""
    names = learns_from(agent)
    for k in range(end):
        last = k == end - 1
        told = {
            "state": k,
            "action": episode.actions[k],
            "reward": episode.rewards[k],
            "next_state": k + 1,
            "next_action": 0 if last else episode.actions[k + 1],
            "terminated": last,
            "truncated": False,
        }
        with running("learn(...)"):
            agent.learn(**{name: told[name] for name in names})


def _values(episode: Episode, n: float, rate: float, discount: float) -> Reals:
    """Return the values on a path after two equal episodes of n-step SARSA."""
    days = len(episode.states)
    agent = maker(n, learning_rate=rate, discount=discount, total_days=days)((days + 1, N_ACTIONS))
    for _ in range(2):
        _learn_row(agent, episode, days)
    values: Reals = agent.Q[np.arange(days), episode.actions]
    return values


# Exercise 2


def exercise_2(answer: Any, seed: int) -> str:
    """Check the importance-sampling ratio of a greedy policy against an ε-greedy one."""
    given("importance_ratio", answer)
    if not callable(answer):
        raise WrongAnswer(f"importance_ratio should be a function, but is of the type {type(answer).__name__}")
    rng = np.random.default_rng(seed)
    length = 4 + int(rng.integers(3))
    epsilon, n_actions = float(rng.choice([0.2, 0.4, 0.5])), int(rng.choice([4, 8]))
    later = 2 + int(rng.integers(length - 2))
    explored = [True] * length
    explored[later - 1] = False
    cases = [
        ([True] * length, epsilon, n_actions),
        ([False] + [True] * (length - 1), epsilon, n_actions),
        (explored, epsilon, n_actions),
        ([True], epsilon, n_actions),
        ([False], epsilon, n_actions),
        ([True, True, False], 0.3, 5),
        ([True] * 3, 0.0, n_actions),
        ([True] * 3, 1.0, n_actions),
    ]
    for greedy, eps, n in cases:
        call = f"importance_ratio({greedy}, {eps:g}, {n})"
        mine = list(greedy)
        with running(call):
            found = answer(mine, eps, n)
        if mine != greedy:
            raise WrongAnswer(f"{call} changes its list `greedy`; leave it as it is, for the caller still needs it")
        right = _ratio(greedy, eps, n)
        wrong = {sentence: _ratio(greedy, eps, n, **change) for sentence, change in RATIO_MISTAKES.items()}
        compare(
            call,
            found,
            right,
            {sentence: value for sentence, value in wrong.items() if math.isfinite(value) and not same(value, right)},
        )
    return (
        "Right: one exploring action on the way makes the ratio 0, whatever the others were. With nine later actions, "
        f"ε = 0.1 and N = 5 a target counts {1 / 0.92**9:.1f} times or not at all."
    )


def _ratio(
    greedy: Sequence[bool],
    epsilon: float,
    n_actions: int,
    *,
    skipped: int = 1,
    likely: str = "1 - ε + ε/N",
    otherwise: str = "0",
    how: str = "product",
) -> float:
    """Return the ratio; other arguments than the defaults are mistakes."""
    best = {
        "1 - ε + ε/N": 1 - epsilon + epsilon / n_actions,
        "1 - ε": 1 - epsilon,
        "1 - ε + ε/(N - 1)": 1 - epsilon + epsilon / (n_actions - 1),
        "1 - ε/N": 1 - epsilon / n_actions,
        "1 - ε + ε N": 1 - epsilon + epsilon * n_actions,
    }[likely]
    of_best = 1 / best if best else math.inf
    of_others = {
        "0": 0.0,
        "1": 1.0,
        "ε/N": epsilon / n_actions,
        "N/ε": n_actions / epsilon if epsilon else math.inf,
        "stop": 1.0,
    }[otherwise]
    actions = list(greedy[skipped:] if how != "without last" else greedy[skipped:-1])
    if otherwise == "stop" and False in actions:
        actions = actions[: actions.index(False)]
    factors = [of_best if is_greedy else of_others for is_greedy in actions]
    if how == "inverse":
        return best ** len(factors) if all(actions) else 0.0
    if how == "sum":
        return sum(factors)
    if how == "mean":
        return sum(factors) / len(factors) if factors else 0.0
    if how == "last":
        return factors[-1] if factors else 1.0
    if how == "probability":
        return math.prod(best if is_greedy else epsilon / n_actions for is_greedy in actions)
    if how == "all or nothing":
        return float(all(actions))
    return math.prod(factors)


RATIO_MISTAKES: Mapping[str, Mapping[str, Any]] = {
    "the first entry of `greedy` is A_t, which is not in the product: start at greedy[1]": {"skipped": 0},
    "two actions are left out at the start; only A_t is, so start at greedy[1]": {"skipped": 2},
    "the last action is left out; the product goes to the end of the list": {"how": "without last"},
    "a random action may be the best one too, so b takes it with probability 1 − ε + ε/N, not 1 − ε": {
        "likely": "1 - ε"
    },
    "a random action is one of *all* N actions, so b takes the best one with probability 1 − ε + ε/N": {
        "likely": "1 - ε + ε/(N - 1)"
    },
    "b takes the best action with probability 1 − ε + ε/N; 1 − ε/N is another number": {"likely": "1 - ε/N"},
    "ε is divided by N, not multiplied: b takes the best action with probability 1 − ε + ε/N": {
        "likely": "1 - ε + ε N"
    },
    "the greedy policy never takes another action, so its ratio there is 0/b = 0, and it is left out here": {
        "otherwise": "1"
    },
    "the greedy policy never takes another action: there π is 0, not 1": {"otherwise": "N/ε"},
    "at an action that is not greedy the ratio is 0/b = 0, not b itself": {"otherwise": "ε/N"},
    "the product stops at an action that is not greedy; there the factor is 0, and so is the whole product": {
        "otherwise": "stop"
    },
    "that is b/π, upside down": {"how": "inverse"},
    "that is the probability of these actions under b; the ratio is π divided by b": {"how": "probability"},
    "the ratios of the single actions are multiplied, not added": {"how": "sum"},
    "the ratios of the single actions are multiplied; that is their mean": {"how": "mean"},
    "that is the ratio of the last action alone: multiply all of them": {"how": "last"},
    "π takes a greedy action with probability 1, but b does not: divide by the probability under b": {
        "how": "all or nothing"
    },
}


# Exercise 3


def _hand_back(
    Q: Reals,
    episode: Episode,
    *,
    learning_rate: float,
    discount: float,
    cut: str = "after",
    to: str = "max",
    order: str = "backwards",
    steps: str = "all",
    rewards: str = "plain",
    start: str = "zero",
    step: str = "difference",
) -> None:
    """Learn from an episode as exercise 3 asks, in place; other arguments than the defaults are mistakes."""
    last = len(episode.states) - 1
    ks = {"all": range(last, -1, -1), "not the first": range(last, 0, -1), "not the last": range(last - 1, -1, -1)}[
        steps
    ]
    if order == "forwards":
        ks = range(last + 1)
    G = 0.0 if start == "zero" else float(Q[N_STATES - 1].max()) + (1.0 if start == "one" else 0.0)
    for k in ks:
        s, a, r = episode.states[k], episode.actions[k], episode.rewards[k]
        best_before, mine_before = float(Q[s].max()), float(Q[s, a])
        G = {
            "plain": r + discount * G,
            "undiscounted": r + G,
            "all discounted": discount * (r + G),
            "none": discount * G,
            "only": r,
            "minus": r - discount * G,
            "discounted reward": discount * r + G,
        }[rewards]
        old = mine_before
        skipped = step == "skips exploring" and old < best_before
        if not skipped:
            Q[s, a] = {
                "difference": old + learning_rate * (G - old),
                "skips exploring": old + learning_rate * (G - old),
                "no old": old + learning_rate * G,
                "only": learning_rate * G,
                "weights": learning_rate * old + (1 - learning_rate) * G,
                "minus": old - learning_rate * (G - old),
                "replaced": G,
            }[step]
        best, mine = float(Q[s].max()), float(Q[s, a])
        cuts = {
            "after": mine < best,
            "before": mine_before < best_before,
            "never": False,
            "always": True,
            "inverted": not mine < best,
        }
        if cut == "stop":
            if mine < best:
                break
        elif cuts[cut]:
            G = {
                "max": best,
                "own": mine,
                "zero": 0.0,
                "mean": float(Q[s].mean()),
                "old max": best_before,
                "discounted": discount * best,
                "added": G + best,
                "larger": max(G, best),
            }[to]


HAND_BACK_MISTAKES: Mapping[str, Mapping[str, Any]] = {
    "G is never cut, so this is Monte Carlo: the third line is missing": {"cut": "never"},
    "G is cut at every action, so only one reward is in each target: cut where Q(S, A) is *below* the largest value": {
        "cut": "always"
    },
    "the condition is upside down: G is cut where the action is *not* the best": {"cut": "inverted"},
    "whether the action is the best is asked before the update; ask it after": {"cut": "before"},
    "the loop ends at the exploring action; the steps before it still learn, from the G that was cut": {"cut": "stop"},
    "where G is cut it goes on with the *largest* value of the state, not with that of the action taken": {"to": "own"},
    "where G is cut it goes on with the largest value of the state, not with 0": {"to": "zero"},
    "where G is cut it goes on with the *largest* value of the state, not with the mean": {"to": "mean"},
    "the largest value is that of the row before the update; take it after": {"to": "old max"},
    "the largest value is discounted where G is cut, and once more in the next step": {"to": "discounted"},
    "where G is cut the largest value takes its place; it is not added": {"to": "added"},
    "G takes the largest value also where it is smaller; max(G, ...) keeps lucky returns": {"to": "larger"},
    "the loop runs forwards; go from the last step to the first": {"order": "forwards"},
    "the first step of the episode, number 0, learns nothing: range(length - 1, -1, -1) ends with 0": {
        "steps": "not the first"
    },
    "the last step of the episode learns nothing: start at length - 1": {"steps": "not the last"},
    "the discount is missing: G becomes R + γ G": {"rewards": "undiscounted"},
    "the reward is discounted too; γ belongs to G only": {"rewards": "all discounted"},
    "γ belongs to G, not to the reward": {"rewards": "discounted reward"},
    "the rewards are missing: G becomes R + γ G": {"rewards": "none"},
    "only one reward is in each target: G becomes R + γ G": {"rewards": "only"},
    "the future is subtracted: G becomes R + γ G": {"rewards": "minus"},
    "the old value is not subtracted: Q moves by α [G − Q]": {"step": "no old"},
    "the old value is lost: Q moves by α [G − Q], so write +=": {"step": "only"},
    "α and 1 − α have changed places": {"step": "weights"},
    "Q moves away from the target: the sign is wrong": {"step": "minus"},
    "Q is set to G at once: move it by α [G − Q]": {"step": "replaced"},
    "exploring actions learn nothing; they do, from what came after them": {"step": "skips exploring"},
    "G starts with a value of the state after the end; after a terminal state there is no future": {"start": "value"},
}


def exercise_3(answer: Any, seed: int) -> str:
    """Check the class of an agent that looks as deep as its actions were greedy."""
    given("MyAgent", answer)
    if not isinstance(answer, type):
        raise WrongAnswer(f"MyAgent should be the class, but is of the type {type(answer).__name__}")
    rng = np.random.default_rng(seed)
    settings = {"learning_rate": float(rng.choice([0.25, 0.5, 0.75])), "discount": float(rng.choice([0.5, 0.625]))}
    cases = [(rng.choice(np.arange(-4.0, 8.5, 0.5), (N_STATES, N_ACTIONS)), _lengths(i, rng)) for i in range(24)]
    right, found, told = [], [], []
    for values, episodes in cases:
        agent = _own(answer, settings)
        table_of(agent, "Q", (N_STATES, N_ACTIONS))[...] = values
        expected = values.copy()
        for number, episode in enumerate(episodes):
            before = expected.copy()
            _hand_back(expected, episode, **settings)
            _learn(agent, episode)
            now = table_of(agent, "Q", (N_STATES, N_ACTIONS))
            right.append(expected.copy())
            found.append(now.copy())
            told.append((before, episode, number))
    wrong = [i for i, (one, other) in enumerate(zip(right, found, strict=True)) if not _alike(one, other)]
    if wrong:
        i = wrong[0]
        raise WrongAnswer(_where(*told[i], right[i], found[i], settings) + _why(cases, found, settings))
    return "Right: greedy actions hand the reward on, and exploring ones do not blur it. See it race:"


def _lengths(i: int, rng: np.random.Generator) -> list[Episode]:
    """Return one episode of one, two, three or more steps, and in every third case a second one."""
    return [_episode(1 + i % 5, rng)] + ([_episode(3, rng)] if i % 3 == 2 else [])


def _alike(one: Reals, other: Reals) -> bool:
    return bool(np.allclose(one, other, rtol=1e-9, atol=1e-9, equal_nan=True))


def _own(answer: Any, settings: Mapping[str, float]) -> Any:
    """Make a student's agent for the small tables of the check, with settings of the check."""
    study = _Small()
    made = _make("MyAgent.create(study)", answer.create, study)
    missing = [name for name in settings if not hasattr(made, name)]
    if missing:
        raise WrongAnswer(f"MyAgent should keep its field `{missing[0]}`, from which `hand_back` reads the number")
    if hasattr(made, "_replace"):
        return made._replace(**settings)
    for name, value in settings.items():
        setattr(made, name, value)
    return made


class _Small:
    """What `create` needs of a task, with small tables."""

    def __init__(self) -> None:
        from gymnasium import spaces

        self.observation_space = spaces.MultiDiscrete([2, N_STATES // 2])
        self.action_space = spaces.Discrete(N_ACTIONS)


def _where(
    before: Reals, episode: Episode, number: int, right: Reals, found: Reals, settings: Mapping[str, float]
) -> str:
    """Return the first part of the sentence: the episode, and the first value that is wrong."""
    entries = [(s, a) for s, a in zip(episode.states, episode.actions, strict=True)]
    wrong = [entry for entry in entries[::-1] if not _alike(right[entry], found[entry])]
    which = "a second episode" if number else "an episode"
    rows = ", ".join(f"Q[{s}] = {[round(float(v), 4) for v in before[s]]}" for s in episode.states)
    start = (
        f"after {which} with {_told(episode)}, where α = {settings['learning_rate']:g}, γ = {settings['discount']:g}, "
        f"{rows}, "
    )
    if not wrong:
        s, a = map(int, np.argwhere(~np.isclose(right, found, rtol=1e-9, atol=1e-9))[0])
        return start + f"Q[{s}, {a}] should stay {right[s, a]:.4g}, but is {found[s, a]:.4g}: "
    s, a = wrong[0]
    return (
        start
        + f"Q[{s}, {a}] should become {digits(right[s, a], found[s, a])}, but is {digits(found[s, a], right[s, a])}: "
    )


def _why(cases: Sequence[tuple[Reals, list[Episode]]], found: Sequence[Reals], settings: Mapping[str, float]) -> str:
    """Return the mistake that explains every case, or two together, or a number that was written in."""
    if all(_alike(one, other) for one, other in zip(_untouched(cases), found, strict=True)):
        return "`hand_back` changes nothing in Q"

    def fits(**change: Any) -> bool:
        outcomes = iter(found)
        for values, episodes in cases:
            mine = values.copy()
            for episode in episodes:
                _hand_back(mine, episode, **{**settings, **change})
                if not _alike(mine, next(outcomes)):
                    return False
        return True

    for sentence, change in HAND_BACK_MISTAKES.items():
        if fits(**change):
            return sentence
    for name, value in (("learning_rate", 0.1), ("learning_rate", 1.0), ("discount", 0.9), ("discount", 0.99)):
        if fits(**{name: value}):
            return f"everything fits a {name} of {value:g}, not {settings[name]:g}: use self.{name}"
    for rate, discount in ((0.1, 1.0), (0.1, 0.9), (0.1, 0.99)):
        if fits(learning_rate=rate, discount=discount):
            return "learning rate and discount are written in as numbers: use self.learning_rate and self.discount"
    changes = list(HAND_BACK_MISTAKES.items())
    for i, (one, first) in enumerate(changes):
        for other, second in changes[i + 1 :]:
            if not first.keys() & second.keys() and fits(**first, **second):
                return f"{one}; and {other}"
    return "that is none of the usual mistakes, so compare your loop with the three lines, term by term"


def _untouched(cases: Sequence[tuple[Reals, list[Episode]]]) -> list[Reals]:
    return [values for values, episodes in cases for _ in episodes]


CHALLENGE = Challenge(
    environment="Study",
    parameters=MappingProxyType(
        {"n_actions": 8, "action_reward_noise_mean": 0.0, "action_reward_noise_sigma": 0.2},
    ),
    n_steps=10_000,
    baselines=MappingProxyType({label(n): maker(n) for n in (1, 3, math.inf)}),
    optimum=10.0,
    best_average=10.0,
)
"""The open challenge: 1 000 episodes with eight actions, none of which costs anything."""
