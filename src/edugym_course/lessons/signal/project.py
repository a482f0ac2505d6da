"""The project of lesson 6: a listener that learns what words mean from how often they occur, from a blank file."""

from collections import Counter, defaultdict
from collections.abc import Callable, Hashable, Iterable
from functools import partial
from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces

from edugym.agents.tables import greedy_action
from edugym.mdp.protocol import Random, Reals
from edugym_course.grading.curves import Race, compare_with_ours, program_of
from edugym_course.grading.learners import Learner, mistakes_of_loops
from edugym_course.grading.programs import APART, run_program
from edugym_course.grading.rule import TRIAL, Rule
from edugym_course.grading.small_world import ACTIONS, SmallWorld

N_STEPS, LEARNING_RATE, EPSILON = 5_000, 0.01, 0.1
ALIKE = 3_000.0
"""By how much, as a logarithm, a random choice must be more probable: an ε of a half is so by a few hundred."""
TAU, LENGTH = 0.05, 8
"""The noise and the number of words of the toy."""
WORDS, HEARD, NOISE = 6, 4, 0.25
"""A small world has this many words, and this many in a message; this share of them is noise."""


class TalkingWorld(gymnasium.ObservationWrapper[Any, Any, Any]):
    """A small world that is heard, not seen: most words of a message belong to the state, in an order of no meaning.

    An observation looks as that of Tamagotchi. Its hit points say nothing.
    """

    def __init__(self, seed: int, truncates: bool = True, noisy: bool = True, n_actions: int = ACTIONS) -> None:
        """Draw a small world, and two words that each of its states likes."""
        super().__init__(SmallWorld(seed, truncates, noisy, n_actions))
        self.observation_space = spaces.MultiDiscrete([101, *[WORDS] * HEARD])
        assert isinstance(self.env.observation_space, spaces.Discrete)
        self._likes = np.random.default_rng(APART + seed).integers(WORDS, size=(int(self.env.observation_space.n), 2))

    def observation(self, observation: int) -> Any:
        """The hit points and the words."""
        rng = self.np_random
        liked = self._likes[observation, rng.integers(2, size=HEARD)]
        words = np.where(rng.random(HEARD) < NOISE, rng.integers(WORDS, size=HEARD), liked)
        return np.array([rng.integers(101), *words])


Message = np.ndarray[tuple[int, ...], np.dtype[np.int64]]
Weights = Iterable[tuple[Hashable, float]]


def shares(message: Message) -> Weights:
    """How often each word occurs, as a share of the message: what the listener should learn from."""
    return [(word, count / len(message)) for word, count in Counter(message.tolist()).items()]


def counts(message: Message) -> Weights:
    """How often each word occurs."""
    return [(word, share * len(message)) for word, share in shares(message)]


def of_observation(message: Message) -> Weights:
    """How often each word occurs, as a share of the whole observation: the hit points are counted as a word."""
    return [(word, count / (len(message) + 1)) for word, count in Counter(message.tolist()).items()]


def all_but_first(message: Message) -> Weights:
    """All words but the first."""
    return [(word, share / len(message)) for word, share in counts(message[1:])]


def all_but_last(message: Message) -> Weights:
    """All words but the last."""
    return [(word, share / len(message)) for word, share in counts(message[:-1])]


def presence(message: Message) -> Weights:
    """Which words occur, however often."""
    return [(word, 1 / len(message)) for word, _ in shares(message)]


def squares(message: Message) -> Weights:
    """The square of the number of times that each word occurs, divided by the length."""
    return [(word, count**2 / len(message)) for word, count in Counter(message.tolist()).items()]


def kinds(message: Message) -> Weights:
    """The rest of each word divided by the number of actions, as if that were its meaning."""
    return shares(message % ACTIONS)


def first_word(message: Message) -> Weights:
    """The first word alone."""
    return shares(message[:1])


def last_word(message: Message) -> Weights:
    """The last word alone."""
    return shares(message[-1:])


def whole(message: Message) -> Weights:
    """The message as one thing: a row of a table."""
    return [(tuple(message.tolist()), 1.0)]


def of_places(message: Message) -> Weights:
    """Each word at its place."""
    return [(place, 1 / len(message)) for place in enumerate(message.tolist())]


class Listener:
    """A listener whose values are linear in what it takes from a message.

    Args:
        shape: the second entry is the number of actions.
        take: what it takes from a message, with its weight.
        learning_rate: α.
        surprised: whether it learns from R less the value, or from R alone.
        largest: whether the value in the difference is the largest one, and not that of the action.
        largest_words: whether it is the sum of the largest weights of the words.
        move: what it takes from a message to move its weights, with the share of each; by default as `take`.
        one: whether the weights of the action that was taken change, or those of all.
        moved: whether the weights of the message "before" the action move, or of the one "after" it.
        valued: whether the value in the difference is that "before" the action, or "after" it.
        discount: γ, of the largest value after the next message.
        first: the first weights.
        alone: whether each weight learns from R less itself, not less the value of the whole message.
        fully: whether the weights of all words of a message move alike, however often they occur.
        unheard: whether those of all other words move with them.
    """

    def __init__(
        self,
        shape: tuple[int, int],
        take: Callable[[Message], Weights] = shares,
        learning_rate: float = LEARNING_RATE,
        surprised: bool = True,
        largest: bool = False,
        one: bool = True,
        moved: str = "before",
        valued: str = "before",
        discount: float = 0.0,
        first: float = 0.0,
        alone: bool = False,
        fully: bool = False,
        unheard: bool = False,
        largest_words: bool = False,
        move: Callable[[Message], Weights] | None = None,
    ) -> None:
        """Know no word."""
        self._alone, self._fully, self._unheard, self._largest = alone, fully, unheard, largest
        self._n_actions = shape[1]
        self._theta: defaultdict[Hashable, Reals] = defaultdict(lambda: np.full(shape[1], first))
        self._take, self._learning_rate, self._surprised, self._one = take, learning_rate, surprised, one
        self._moved, self._valued, self._discount = moved, valued, discount
        self._largest_words, self._move = largest_words, move or take

    def values(self, state: Message) -> Reals:
        """The value of each action after an observation."""
        terms = (weight * self._theta[word] for word, weight in self._take(state[1:]))
        return sum(terms, np.zeros(self._n_actions))

    def learn(self, state: Message, action: int, reward: float, next_state: Message, terminated: bool) -> None:
        """Move the weights of what was heard."""
        messages = {"before": state, "after": next_state}
        actions = action if self._one else slice(None)
        future = self._discount * self.values(next_state).max() if self._discount and not terminated else 0.0
        values = self.values(messages[self._valued])
        delta = reward + future - (values.max() if self._largest else values[actions]) * self._surprised
        heard = self._move(messages[self._moved][1:])
        if self._largest_words:
            delta = reward - sum(weight * float(self._theta[word].max()) for word, weight in heard)
        for word, weight in [(word, 1.0) for word in range(WORDS)] if self._unheard else heard:
            delta = reward - self._theta[word][actions] if self._alone else delta
            self._theta[word][actions] += self._learning_rate * (1.0 if self._fully else weight) * delta

    def act(self, state: Message, rng: Random) -> int:
        """Choose an action by ε-greedy."""
        return int(rng.random() * self._n_actions) if rng.random() < EPSILON else self.greedy(state, rng)

    def greedy(self, state: Message, rng: Random) -> int:
        """The action with the highest value."""
        return greedy_action(self.values(state)[np.newaxis], 0, rng)


def mistake(**how: Any) -> Learner:
    """Return a listener that makes a mistake."""
    return Learner(partial(Listener, **how))


RULE = Rule(
    Learner(Listener),
    mistakes_of_loops(Listener, on_policy=True)  # with the next reward alone, what comes after an end has no part
    | {
        "each message is learned for itself, as in a row of a table: share what is learned by words": mistake(
            take=whole
        ),
        "the place of a word in the message counts, and it should not": mistake(take=of_places),
        "the first word alone is heard": mistake(take=first_word),
        "the last word alone is heard: is x overwritten in a loop?": mistake(take=last_word),
        "the weights of all words move, and those of the words that are not in the message should stay": mistake(
            unheard=True
        ),
        "a word counts once, however often it occurs: x_w is its share of the message": mistake(take=presence),
        "a word moves once, however often it occurs: `theta[words, a] += ...` adds to a row once, `np.add.at` for each"
        " word": mistake(move=presence),
        "a word that occurs twice is moved twice, each time by 2/L: go through the *different* words, or move each by"
        " 1/L": mistake(move=squares),
        "nothing is learned from the last step of an episode: its reward counts like any other": Learner(
            Listener, skips=lambda step: step.terminated
        ),
        "nothing is learned from a step that is truncated: its reward counts like any other": Learner(
            Listener, skips=lambda step: step.truncated
        ),
        "words with the same rest, divided by the number of actions, share their weights; what a word means has to be"
        " learned": mistake(take=kinds),
        "each weight moves by R − θ, the error of its own word alone; q(O, A) is the sum over all words": mistake(
            alone=True
        ),
        "the weights of all words of a message move alike: the factor x_w(O) is missing in their step": mistake(
            fully=True
        ),
        "the counts are not divided by the length L of the message": mistake(take=counts),
        "the counts are divided by more than L, as by the length L + 1 of the observation: its first entry is no"
        " word": mistake(take=of_observation),
        "the first word of each message is left out: the words begin with entry 1 of the observation": mistake(
            take=all_but_first
        ),
        "the last word of each message is left out: is a `range` too short?": mistake(take=all_but_last),
        "the weights move by R, not by R − q(O, A): without the difference they grow without end": mistake(
            surprised=False
        ),
        "the *largest* value is subtracted from R; it should be q(O, A), that of the action that was taken": mistake(
            largest=True
        ),
        "the sum of the largest weights of the words is subtracted from R; it should be q(O, A), of the action that was"
        " taken": mistake(largest_words=True),
        "the values of all actions are alike: do the weights of all move, or of none, or begin anew in each episode, or"
        " are all actions drawn at random? Learn about the one that was taken": mistake(one=False)._replace(nats=ALIKE),
        "the weights of the *next* message move: those of the message before the action should": mistake(moved="after"),
        "it learns from the *next* message alone: keep the one before the action until its weights have moved": mistake(
            moved="after", valued="after"
        ),
        "the value in R − q(O, A) is that of the *next* message: O is the one before the action": mistake(
            valued="after"
        ),
        **{
            f"the learning rate is much too {size}: it is 0.01 in the text": mistake(learning_rate=rate)
            for size, rate in (("large", 0.5), ("small", 0.001))
        },
        **{
            f"the learning rate is too {size}, as {rate:g}: it is 0.01 in the text": mistake(learning_rate=rate)
            for size, rate in (("large", 0.1), ("large", 0.02), ("small", 0.005))
        },
        "the first weights are 1, and they should be 0": mistake(first=1.0),
        "the first weights are far above 0, as 10, and they should be 0": mistake(first=10.0),
        "γ is 0.5, and it should be 0: the reward stands alone, without the value of the next message": mistake(
            discount=0.5
        ),
        "γ is near 1, and it should be 0: the reward stands alone, without the value of the next message": mistake(
            discount=0.95
        ),
    },
    EPSILON,
    otherwise="; the words are all entries of an observation but the first, and only the weights of the action taken"
    " move",
    world=TalkingWorld,
)
TOY = Race(
    partial(gymnasium.make, "edugym/Tamagotchi-v0", tau=TAU, max_msg_length=LENGTH),
    N_STEPS,
    program_of(Listener),
    episodes=20,
    judged=("played",),
)


def project_6(answer: Any, seed: int) -> str:
    """Check a program with a listener that learns on counts."""
    run_program(answer, TalkingWorld(seed, n_actions=ACTIONS - 1), TRIAL, seed)  # does it ask for their number?
    RULE.check(answer, seed)
    return f"Right: what it learns of a word, it knows in every message. {compare_with_ours(answer, TOY, seed)}"
