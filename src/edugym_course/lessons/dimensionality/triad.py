"""The deadly triad in ten lines (Sutton and Barto, sections 11.2 and 11.3): a weight that grows for ever."""

import numpy as np

from edugym.mdp.protocol import Reals


def w_to_2w(n_updates: int, gamma: float, alpha: float, copy_every: int = 1, whole_way: bool = False) -> Reals:
    """Return the weight w after 0, 1, ... updates, from w = 1: the first state has the value w, the second 2w.

    Args:
        n_updates: how many updates there are.
        gamma: the discount.
        alpha: the learning rate.
        copy_every: the target uses an old weight, which is copied after so many updates; 1 for the present weight.
        whole_way: whether the step from the second state, to the end, is learned from as well (on-policy).
    """
    w = old = 1.0
    weights = [w]
    for k in range(1, n_updates + 1):
        w += alpha * (0.0 + gamma * 2.0 * old - w) * 1.0  # from the first state (x = 1) to the second (x = 2)
        if whole_way:
            w += alpha * (0.0 - 2.0 * w) * 2.0  # from the second state to the end
        if k % copy_every == 0:
            old = w
        weights.append(w)
    return np.array(weights)
