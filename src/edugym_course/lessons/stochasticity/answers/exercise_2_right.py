# %% two loops
# says: Right. To choose between players on the frontier you need a taste: how much mean is less spread worth?
def frontier(players):
    names = []
    for name, (mean, spread) in players.items():
        beaten = False
        for other, (m, s) in players.items():
            if m >= mean and s <= spread and (m, s) != (mean, spread):
                beaten = True
        if not beaten:
            names.append(name)
    return names


# %% a helper and a comprehension
def beats(a, b):
    return a[0] >= b[0] and a[1] <= b[1] and (a[0] > b[0] or a[1] < b[1])


def frontier(players):
    return [n for n in players if not any(beats(players[o], players[n]) for o in players)]


# %% sorted by spread
def frontier(players):
    best = -float("inf")
    found = []
    for spread in sorted({s for _, s in players.values()}):
        top = max(m for m, s in players.values() if s == spread)
        if top > best:
            found += [n for n, pair in players.items() if pair == (top, spread)]
            best = top
    return found


# %% arrays
def frontier(players):
    names = list(players)
    mean, spread = np.array([players[n] for n in names]).T
    better = (mean[:, None] >= mean) & (spread[:, None] <= spread)
    better &= (mean[:, None] > mean) | (spread[:, None] < spread)
    return [name for name, beaten in zip(names, better.any(axis=0)) if not beaten]


# %% a set
def frontier(players):
    beaten = set()
    for a, (ma, sa) in players.items():
        for b, (mb, sb) in players.items():
            if (ma > mb and sa <= sb) or (ma >= mb and sa < sb):
                beaten.add(b)
    return set(players) - beaten


# %% for and else
def frontier(players):
    left = []
    for name in players:
        mean, spread = players[name]
        for other in players:
            m, s = players[other]
            if other != name and m >= mean and s <= spread and m - s > mean - spread:
                break
        else:
            left.append(name)
    return left


# %% a dictionary, whose keys are names
def frontier(players):
    return {
        name: pair
        for name, pair in players.items()
        if all(m < pair[0] or s > pair[1] or (m, s) == pair for m, s in players.values())
    }
