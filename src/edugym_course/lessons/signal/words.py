"""How much the words of Tamagotchi tell, computed over the states of simulated episodes."""

import math
from collections import Counter
from functools import cache
from itertools import combinations_with_replacement
from typing import Any

import numpy as np

from edugym.envs.tamagotchi import Tamagotchi
from edugym.mdp.protocol import Reals


@cache
def information(tau: float, length: int = 1, vocab_size: int = 4) -> float:
    """Return I(message; need), the information in a message about the wanted action, in bits (2 tell it exactly).

    The states are those of a toy in perfect care, which is always given what it wants. Given the state, the words are
    independent, so their order tells nothing, and the numbers of words of each kind have a multinomial distribution.
    Synonyms tell nothing more, so that a larger vocabulary has the information of four words.

    Args:
        tau: the noise.
        length: the number of words in a message.
        vocab_size: the number of different words.
    """
    toy = Tamagotchi.create(tau)
    states = states_met(toy)
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


def joint_table(tau: float, vocab_size: int = 4, *, obeyed: bool = False) -> Reals:
    """Return the probability p(x, y) of every need with every word, for a toy in perfect care, or one that is obeyed.

    The rows are the needs. At most four words are told apart: synonyms are one word here.
    """
    kinds = min(vocab_size, 4)
    toy, joint = Tamagotchi.create(tau), np.zeros((4, kinds))
    for (variables, wanted), share in states_met(toy, obeyed).items():
        weights = np.array([toy.weight(variables, need, wanted) for need in range(4)])
        joint[wanted] += share * np.bincount(np.arange(4) % kinds, weights / weights.sum(), kinds)
    return joint


@cache
def states_met(toy: Tamagotchi, obeyed: bool = False) -> dict[tuple[Any, int], float]:
    """Return the (variables, wanted action) that occur in simulated episodes, with their frequencies.

    Args:
        toy: the toy, which says one word out of four if it is obeyed.
        obeyed: whether it is given what it says, instead of what it wants.
    """
    rng = np.random.default_rng(0)
    counts: Counter[tuple[Any, int]] = Counter()
    for _ in range(200 if obeyed else 20):  # an obeyed toy gets into many more states
        state = toy.initial(rng)
        for _ in range(toy.max_steps):
            counts[state.variables, state.wanted] += 1
            state = toy.transition(state, state.message if obeyed else state.wanted, rng)
            if toy.terminal(state):
                break
    return {state: count / counts.total() for state, count in counts.items()}
