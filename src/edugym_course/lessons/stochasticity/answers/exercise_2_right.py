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


# %% arrays
def frontier(players):
    names = list(players)
    mean, spread = np.array([players[n] for n in names]).T
    better = (mean[:, None] >= mean) & (spread[:, None] <= spread)
    better &= (mean[:, None] > mean) | (spread[:, None] < spread)
    return [name for name, beaten in zip(names, better.any(axis=0)) if not beaten]
