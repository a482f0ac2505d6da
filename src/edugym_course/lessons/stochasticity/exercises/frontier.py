"""The players of exercise 2 of lesson 8: whom no other one beats, and whom the usual mistakes take for them."""

from collections.abc import Callable, Mapping
from functools import partial
from itertools import pairwise, takewhile
from statistics import fmean

import numpy as np

Pair = tuple[float, float]


def beats(one: Pair, other: Pair) -> bool:
    """Return whether one player has at least the mean and at most the spread of another, and is not alike."""
    return one[0] >= other[0] and one[1] <= other[1] and one != other


def _beats_rounded(one: Pair, other: Pair, digits: int) -> bool:
    """The same by numbers that are rounded."""
    return beats((round(one[0], digits), round(one[1], digits)), (round(other[0], digits), round(other[1], digits)))


def unbeaten(players: Mapping[str, Pair], beats: Callable[[Pair, Pair], bool]) -> set[str]:
    """Return the names of the players that no other one beats, by a rule."""
    return {
        name
        for name, one in players.items()
        if not any(beats(two, one) for other, two in players.items() if other != name)
    }


def _until_beaten(players: Mapping[str, Pair]) -> set[str]:
    """Return the names before the first player that is beaten."""
    return {*takewhile(unbeaten(players, beats).__contains__, players)}


def _chosen_by_weights(players: Mapping[str, Pair]) -> set[str]:
    """Return the names of those with the highest mean less w times the spread, for any w from 0."""
    pairs = [*players.values()]
    # the weights at which two players are equal; between two of them the same ones are highest
    equal = sorted((m - n) / (s - t) for m, s in pairs for n, t in pairs if (m - n) * (s - t) > 0)
    between = [0.0, *equal, 2 * max(equal, default=1.0)]
    sums = [{name: m - w * s for name, (m, s) in players.items()} for w in map(fmean, pairwise(between))]
    return {name for each in sums for name, total in each.items() if total == max(each.values())}


FRONTIER_MISTAKES: Mapping[str, Callable[[Mapping[str, Pair]], set[str]]] = {
    "a player with the same mean and a larger spread is beaten too, and so is one with the same spread and a lower"
    " mean; one of the two may be equal": lambda players: unbeaten(players, lambda a, b: a[0] > b[0] and a[1] < b[1]),
    "two players with the same two numbers do not beat each other; one of the two must be really better": (
        lambda players: unbeaten(players, lambda a, b: a[0] >= b[0] and a[1] <= b[1])
    ),
    "every player is as good as itself, so it must not beat itself: one of the two numbers must be really better": (
        lambda players: set()
    ),
    "after the first player that is beaten nobody is taken: is a variable set to True there, and never back to"
    " False?": _until_beaten,
    "the first player alone is looked at: `return` ends the loop, so write it below, as far to the left as `for`": (
        lambda players: unbeaten(players, beats) & {next(iter(players))}
    ),
    "an equal mean is left out: a player with the same mean and a larger spread is beaten too": (
        lambda players: unbeaten(players, lambda a, b: a[0] > b[0] and a[1] <= b[1])
    ),
    "an equal spread is left out: a player with the same spread and a lower mean is beaten too": (
        lambda players: unbeaten(players, lambda a, b: a[0] >= b[0] and a[1] < b[1])
    ),
    "it takes a *larger* spread as better": (
        lambda players: unbeaten(players, lambda a, b: a[0] >= b[0] and a[1] >= b[1] and a != b)
    ),
    "it takes a *lower* mean as better": (
        lambda players: unbeaten(players, lambda a, b: a[0] <= b[0] and a[1] <= b[1] and a != b)
    ),
    "it takes a lower mean and a larger spread as better: the comparison is the wrong way round": (
        lambda players: unbeaten(players, lambda a, b: beats(b, a))
    ),
    "these are the players that *are* beaten": lambda players: {*players} - unbeaten(players, beats),
    "these are the players with the highest mean; a lower mean with a smaller spread is worth choosing too": (
        lambda players: {name for name, (mean, _) in players.items() if mean == max(m for m, _ in players.values())}
    ),
    "these are the players with the smallest spread; a larger spread with a higher mean is worth choosing too": (
        lambda players: {name for name, (_, spread) in players.items() if spread == min(s for _, s in players.values())}
    ),
    "one better number is enough there to beat a player; the other one must not be worse": (
        lambda players: unbeaten(players, lambda a, b: a[0] > b[0] or a[1] < b[1])
    ),
    "these are all the players: nobody is beaten; is the comparison ever true?": lambda players: {*players},
    "a player must be beaten by *one* other player in both numbers, not by one in the mean and another in the spread": (
        lambda players: {
            name
            for name, (mean, spread) in players.items()
            if not (any(m > mean for m, _ in players.values()) and any(s < spread for _, s in players.values()))
        }
    ),
    **{
        f"it compares numbers that are rounded to {digits} digits, or takes near ones for equal; compare them as they"
        " are": partial(unbeaten, beats=partial(_beats_rounded, digits=digits))
        for digits in (2, 3)
    },
    "these are the players for whom mean minus spread is largest; that is only one taste": (
        lambda players: {n for n, (m, s) in players.items() if m - s == max(a - b for a, b in players.values())}
    ),
    "these are the players for whom mean divided by spread is largest; that is only one taste": (
        lambda players: {n for n, (m, s) in players.items() if m / s == max(a / b for a, b in players.values())}
    ),
    "these are the players with the highest weighted sum of mean and spread, for some weights; a player whom no weights"
    " choose can be one that nobody beats": lambda players: _chosen_by_weights(players),
    "a mean below 0 is left out, and such a player may be one that nobody beats": (
        lambda players: {name for name in unbeaten(players, beats) if players[name][0] > 0}
    ),
    "of players with the same two numbers only one is left; they do not beat each other": (
        lambda players: {
            name
            for name in unbeaten(players, beats)
            if name == next(other for other, pair in players.items() if pair == players[name])
        }
    ),
}


FRONTIER_CASE = ((4, 2), (9, 3), (15, 7), (16, 11), (16, 11), (20, 15), (9, 5), (12, 7), (10, 13), (3, 9))
"""Mean and spread: six on the frontier, two of them alike, which no weighted sum chooses; one is beaten in the spread
alone, and one in the mean."""


def made_up_players(seed: int) -> list[dict[str, Pair]]:
    """Make players up: a case by hand, again with one who beats all others, by chance, one alone, and means below 0."""
    rng = np.random.default_rng(seed)
    few = list(zip(rng.integers(1, 9, 9), rng.integers(1, 9, 9), strict=True))
    cases = []
    for lowest, pairs in (
        (0.6, FRONTIER_CASE),
        (0.6, ((22, 1), *FRONTIER_CASE)),
        (0.3, few),
        (0.3, few[:1]),
        (-0.6, FRONTIER_CASE),
    ):
        scale = float(rng.choice([0.003, 0.004]))  # so small that two digits do not tell them apart
        scale = scale / 10 if pairs == few else scale  # nor three
        order = sorted(rng.permutation(len(pairs)), key=lambda k: k > 1)  # the first two in front, not to be beaten
        players = [(round(lowest + pairs[k][0] * scale, 4), round(pairs[k][1] * scale, 4)) for k in order]
        cases.append({chr(ord("A") + k): (float(mean), float(spread)) for k, (mean, spread) in enumerate(players)})
    return cases
