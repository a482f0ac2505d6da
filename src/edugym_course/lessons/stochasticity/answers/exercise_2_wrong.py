# %% no return
# says: is a `return` missing?
# says: frontier(players) with
def frontier(players):
    best = []
    for name, (mean, spread) in players.items():
        if not any(m >= mean and s <= spread and (m, s) != (mean, spread) for m, s in players.values()):
            best.append(name)


# %% both really better
# says: a player with the same mean and a larger spread is beaten too, and so is one with the same spread and a lower
#   mean; one of the two may be equal
# says: it should give
def frontier(players):
    return [n for n, (m, s) in players.items() if not any(a > m and b < s for a, b in players.values())]


# %% beats itself
# says: every player is as good as itself, so it must not beat itself: one of the two numbers must be really better
def frontier(players):
    return [n for n, (m, s) in players.items() if not any(a >= m and b <= s for a, b in players.values())]


# %% equals beat each other
# says: two players with the same two numbers do not beat each other; one of the two must be really better
def frontier(players):
    return [n for n, (m, s) in players.items() if not any(a >= m and b <= s for o, (a, b) in players.items() if o != n)]


# %% the equal mean
# says: an equal mean is left out: a player with the same mean and a larger spread is beaten too
def frontier(players):
    return [n for n, (m, s) in players.items() if not any(a > m and b <= s for a, b in players.values())]


# %% the equal spread
# says: an equal spread is left out: a player with the same spread and a lower mean is beaten too
def frontier(players):
    return [n for n, (m, s) in players.items() if not any(a >= m and b < s for a, b in players.values())]


# %% more spread is better
# says: it takes a *larger* spread as better
def frontier(players):
    return [
        n
        for n, (m, s) in players.items()
        if not any(a >= m and b >= s and (a, b) != (m, s) for a, b in players.values())
    ]


# %% less mean is better
# says: it takes a *lower* mean as better
def frontier(players):
    return [
        n
        for n, (m, s) in players.items()
        if not any(a <= m and b <= s and (a, b) != (m, s) for a, b in players.values())
    ]


# %% the wrong way round
# says: it takes a lower mean and a larger spread as better: the comparison is the wrong way round
def frontier(players):
    return [
        n
        for n, (m, s) in players.items()
        if not any(a <= m and b >= s and (a, b) != (m, s) for a, b in players.values())
    ]


# %% the beaten ones
# says: these are the players that *are* beaten
def frontier(players):
    return [
        n for n, (m, s) in players.items() if any(a >= m and b <= s and (a, b) != (m, s) for a, b in players.values())
    ]


# %% only the highest mean
# says: these are the players with the highest mean; a lower mean with a smaller spread is worth choosing too
def frontier(players):
    top = max(m for m, s in players.values())
    return [n for n, (m, s) in players.items() if m == top]


# %% only the smallest spread
# says: these are the players with the smallest spread; a larger spread with a higher mean is worth choosing too
def frontier(players):
    low = min(s for m, s in players.values())
    return [n for n, (m, s) in players.items() if s == low]


# %% one number is enough
# says: one better number is enough there to beat a player; the other one must not be worse
def frontier(players):
    return [n for n, (m, s) in players.items() if not any(a > m or b < s for a, b in players.values())]


# %% everybody
# says: these are all the players: nobody is beaten; is the comparison ever true?
def frontier(players):
    return list(players)


# %% the pairs
# says: should hold names such as
def frontier(players):
    return [
        (m, s)
        for m, s in players.values()
        if not any(a >= m and b <= s and (a, b) != (m, s) for a, b in players.values())
    ]


# %% only the first name
# says: : there may be several
# says: should be a list of names, but is the text
def frontier(players):
    for n, (m, s) in players.items():
        if not any(a >= m and b <= s and (a, b) != (m, s) for a, b in players.values()):
            return n


# %% appended in the inner loop
# says: more than once, and once is enough: is it appended in the inner loop, or by two lists that are added?
def frontier(players):
    best = []
    for n, (m, s) in players.items():
        for a, b in players.values():
            if not (a >= m and b <= s and (a, b) != (m, s)):
                best.append(n)
    return best


# %% by mean less spread
# says: these are the players for whom mean minus spread is largest; that is only one taste
def frontier(players):
    top = max(m - s for m, s in players.values())
    return [n for n, (m, s) in players.items() if m - s == top]


# %% by mean over spread
# says: these are the players for whom mean divided by spread is largest; that is only one taste
def frontier(players):
    top = max(m / s for m, s in players.values())
    return [n for n, (m, s) in players.items() if m / s == top]


# %% one of two equals
# says: of players with the same two numbers only one is left; they do not beat each other
def frontier(players):
    best = {}
    for n, (m, s) in players.items():
        if (m, s) in best.values():
            continue
        if not any(a >= m and b <= s and (a, b) != (m, s) for a, b in players.values()):
            best[n] = (m, s)
    return list(best)


# %% beaten by two
# says: a player must be beaten by *one* other player in both numbers, not by one in the mean and another in the spread
def frontier(players):
    names = []
    for n, (m, s) in players.items():
        better_mean = any(a > m for a, b in players.values())
        better_spread = any(b < s for a, b in players.values())
        if not (better_mean and better_spread):
            names.append(n)
    return names


# %% players are removed
# says: changes the dictionary that it is given; collect the names in a list of their own
def frontier(players):
    for n, (m, s) in list(players.items()):
        if any(a >= m and b <= s and (a, b) != (m, s) for a, b in players.values()):
            del players[n]
    return list(players)


# %% a list, not a function
# says: should be a function
# says: the players
frontier = ["A", "B"]


# %% no parameter
# says: its parameters are not those of the exercise
def frontier():
    return []


# %% a number
# says: should be a list of names, but is a
def frontier(players):
    return len(players)


# %% rounded to two digits
# says: it compares numbers that are rounded to 2 digits, or takes near ones for equal; compare them as they are
def frontier(players):
    rounded = {name: (round(mean, 2), round(spread, 2)) for name, (mean, spread) in players.items()}
    return [
        name
        for name, (mean, spread) in rounded.items()
        if not any(m >= mean and s <= spread and (m > mean or s < spread) for m, s in rounded.values())
    ]


# %% rounded to three digits
# says: it compares numbers that are rounded to 3 digits, or takes near ones for equal; compare them as they are
def frontier(players):
    rounded = {name: (round(mean, 3), round(spread, 3)) for name, (mean, spread) in players.items()}
    return [
        name
        for name, (mean, spread) in rounded.items()
        if not any(m >= mean and s <= spread and (m > mean or s < spread) for m, s in rounded.values())
    ]


# %% the best two
# says: more than once, and once is enough: is it appended in the inner loop, or by two lists that are added?
def frontier(players):
    return [max(players, key=lambda name: players[name][0]), min(players, key=lambda name: players[name][1])]


# %% return in the loop
# says: the first player alone is looked at: `return` ends the loop, so write it below, as far to the left as `for`
def frontier(players):
    names = []
    for name, (mean, spread) in players.items():
        for m, s in players.values():
            if m >= mean and s <= spread and (m, s) != (mean, spread):
                break
        else:
            names.append(name)
        return names


# %% the flag stays up
# says: after the first player that is beaten nobody is taken: is a variable set to True there, and never back to False?
# in: two loops
# - names = []
# + names, beaten = [], False
# - beaten = False
# - for other, (m, s) in players.items():
# + for m, s in players.values():


# %% who loses is left out
# says: a mean below 0 is left out, and such a player may be one that nobody beats
def frontier(players):
    kept = []
    for name, (mean, spread) in players.items():
        others = players.values()
        beaten = any(m >= mean and s <= spread and (m > mean or s < spread) for m, s in others)
        if mean > 0 and not beaten:
            kept.append(name)
    return kept


# %% every weight
# says: these are the players with the highest weighted sum of mean and spread, for some weights; a player whom no
#   weights choose can be one that nobody beats
def frontier(players):
    chosen = set()
    for weight in np.linspace(0, 20, 2001):
        worth = {name: mean - weight * spread for name, (mean, spread) in players.items()}
        chosen |= {name for name in worth if worth[name] == max(worth.values())}
    return list(chosen)
