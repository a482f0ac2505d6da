"""How much the words of Tamagotchi tell, computed over the states of simulated episodes."""

import math
from functools import cache
from itertools import combinations_with_replacement
from typing import Any

import numpy as np

from edugym.envs.tamagotchi import Tamagotchi
from edugym.mdp.protocol import Reals


@cache
def information(tau: float, length: int = 1, vocab_size: int = 4) -> float:
    """Return I(message; need), the information in a message about the wanted action, in bits (2 tell it exactly).

    The states are those of a toy that is always given what it wants. Given the state, the words are independent, so
    their order tells nothing, and the numbers of words of each kind have a multinomial distribution. Synonyms tell
    nothing more, so that a larger vocabulary has the information of four words.

    Args:
        tau: the noise.
        length: the number of words in a message.
        vocab_size: the number of different words.
    """
    toy = Tamagotchi.create(tau)
    states = states_in_care(toy)
    kinds = min(vocab_size, 4)
    counts = np.array(
        [np.bincount(words, minlength=kinds) for words in combinations_with_replacement(range(kinds), length)]
    )
    ways = math.lgamma(length + 1) - np.vectorize(math.lgamma)(counts + 1.0).sum(axis=1)
    joint = np.zeros((4, len(counts)))
    for (variables, wanted), share in states.items():
        weights = np.array([toy.weight(variables, need, wanted) for need in range(4)])
        word = np.bincount(np.arange(4) % kinds, weights / weights.sum(), kinds)
        with np.errstate(divide="ignore", invalid="ignore"):
            logarithms = np.where(counts > 0, counts * np.log(word), 0.0)
        joint[wanted] += share * np.exp(ways + logarithms.sum(axis=1))
    return bits(joint)


def bits(joint: Reals) -> float:
    """Return the information I(X; Y) in bits, from a table of p(x, y) with a row for every x and a column for every y.

    A pair that never occurs adds nothing.
    """
    p_x = joint.sum(axis=1, keepdims=True)
    p_y = joint.sum(axis=0, keepdims=True)
    possible = joint > 0
    return float(np.sum(joint[possible] * np.log2(joint[possible] / (p_x * p_y)[possible])))


def joint_table(tau: float, vocab_size: int = 4) -> Reals:
    """Return the probability p(x, y) of every need with every word, for a toy that is given what it wants.

    The rows are the needs. At most four words are told apart: synonyms are one word here.
    """
    kinds = min(vocab_size, 4)
    toy, joint = Tamagotchi.create(tau), np.zeros((4, kinds))
    for (variables, wanted), share in states_in_care(toy).items():
        weights = np.array([toy.weight(variables, need, wanted) for need in range(4)])
        joint[wanted] += share * np.bincount(np.arange(4) % kinds, weights / weights.sum(), kinds)
    return joint


def right_words(tau: float, episodes: int = 50) -> float:
    """Return the share of the steps in which the word is right, in the episodes of a player that obeys it."""
    toy, rng = Tamagotchi.create(tau), np.random.default_rng(0)
    right, steps = 0, 0
    for _ in range(episodes):
        state = toy.initial(rng)
        for _ in range(toy.max_steps):
            right, steps = right + (state.message == state.wanted), steps + 1
            state = toy.transition(state, state.message, rng)
            if toy.terminal(state):
                break
    return right / steps


@cache
def states_in_care(toy: Tamagotchi, episodes: int = 20) -> dict[tuple[Any, int], float]:
    """Return the (variables, wanted action) of a toy that is always given what it wants, with their frequencies."""
    rng = np.random.default_rng(0)
    seen: dict[tuple[Any, int], float] = {}
    for _ in range(episodes):
        state = toy.initial(rng)
        for _ in range(toy.max_steps):
            key = (state.variables, state.wanted)
            seen[key] = seen.get(key, 0.0) + 1 / (episodes * toy.max_steps)
            state = toy.transition(state, state.wanted, rng)
    return seen
