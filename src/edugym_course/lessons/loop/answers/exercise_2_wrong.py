# %% the first of equals
# says: ties should be broken at random, and it takes the first of equals
# says: choose(values, epsilon, rng)
def choose(values, epsilon, rng):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return np.argmax(values)


# %% the last of equals
# says: ties should be broken at random, and it takes the last of equals
# says: , should choose
def choose(values, epsilon, rng):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return max(range(len(values)), key=lambda action: (values[action], action))


# %% never explores
# says: it never explores: what is `epsilon` for?
def choose(values, epsilon, rng):
    return rng.choice(np.flatnonzero(values == values.max()))


# %% the wrong way round
# says: ε and 1 − ε have changed places: it explores with probability 1 − ε
def choose(values, epsilon, rng):
    if rng.random() > epsilon:
        return rng.integers(len(values))
    return rng.choice(np.flatnonzero(values == values.max()))


# %% the others only
# says: a random action may be the best one too; this one is drawn among the others only
def choose(values, epsilon, rng):
    best = np.flatnonzero(values == values.max())
    if rng.random() < epsilon:
        others = np.flatnonzero(values < values.max())
        return rng.choice(others if len(others) else best)
    return rng.choice(best)


# %% argmin
# says: it takes the *lowest* value
def choose(values, epsilon, rng):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return rng.choice(np.flatnonzero(values == values.min()))


# %% the value
# says: should give the number of an action, a whole number, but gives
def choose(values, epsilon, rng):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return values.max()


# %% four actions
# says: and epsilon = 0.0, should give an action from 0 to 2
def choose(values, epsilon, rng):
    if rng.random() < epsilon:
        return rng.integers(4)
    return rng.choice(np.flatnonzero(values == values.max())) if len(values) == 4 else 3


# %% never the last
# says: the random action is never the last one: `rng.integers(n)` is from 0 to n − 1 already
def choose(values, epsilon, rng):
    if rng.random() < epsilon:
        return rng.integers(len(values) - 1)
    return rng.choice(np.flatnonzero(values == values.max()))


# %% other random numbers
# says: does not draw its random numbers from `rng`, so that no run can be repeated: use rng.random()
def choose(values, epsilon, rng):
    if np.random.random() < epsilon:
        return np.random.randint(len(values))
    return np.random.choice(np.flatnonzero(values == values.max()))


# %% a generator of its own
# says: , the same action in every call, for it takes no random number from `rng`: is a new generator made in it, or none
#   used?
def choose(values, epsilon, rng):
    rng = np.random.default_rng(0)
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return rng.choice(np.flatnonzero(values == values.max()))


# %% sorts the values
# says: changes the table `values`
# says: `: choosing must change nothing
def choose(values, epsilon, rng):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    best = rng.choice(np.flatnonzero(values == values.max()))
    values.sort()
    return best


# %% always random
# says: it always acts at random: it should take the highest value with probability 1 − ε
def choose(values, epsilon, rng):
    return rng.integers(len(values))


# %% action 0 when exploring
# says: its random action is always action 0
def choose(values, epsilon, rng):
    if rng.random() < epsilon:
        return 0
    return rng.choice(np.flatnonzero(values == values.max()))


# %% the number of the highest value
# says: values, epsilon and rng
choose = 1


# %% the search begins at -1
# says: values = [-400.0, -300.0, -500.0]
# says: the search for the highest value starts from -1, and all values may be lower: start from the first one
def choose(values, epsilon, rng):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    best = max(-1.0, values.max())
    return rng.choice(np.flatnonzero(values == best)) if (values == best).any() else 0


# %% never action 0
# says: the random action is never action 0: `rng.integers(n)` is from 0 to n − 1 already
def choose(values, epsilon, rng):
    if rng.random() < epsilon:
        return rng.integers(1, len(values))
    return rng.choice(np.flatnonzero(values == values.max()))


# %% an index into the best
# says: `rng.integers(len(best))` says *which* of the best is taken: the action is `best[...]`
def choose(values, epsilon, rng):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    best = np.flatnonzero(values == values.max())
    return rng.integers(len(best))


# %% 0.1 typed in
# says: it explores with ε = 0.1, whatever `epsilon` is
def choose(values, epsilon, rng):
    if rng.random() < 0.1:
        return rng.integers(len(values))
    return rng.choice(np.flatnonzero(values == values.max()))


# %% nearly equal
# says: values that differ are no ties: compare with ==
def choose(values, epsilon, rng):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return rng.choice(np.flatnonzero(values >= values.max() - 0.001))


# %% any action where several are equal
# says: where several have the highest value it takes any action; take one of *these*
def choose(values, epsilon, rng):
    best = np.flatnonzero(values == values.max())
    if rng.random() < epsilon or len(best) > 1:
        return rng.integers(len(values))
    return best[0]


# %% a share of epsilon
# says: it explores with probability ε/n: a random action is drawn with probability ε, and each has ε/n then
def choose(values, epsilon, rng):
    if rng.random() < epsilon / len(values):
        return rng.integers(len(values))
    return rng.choice(np.flatnonzero(values == values.max()))


# %% without the sign
# says: it takes the largest value without its sign
def choose(values, epsilon, rng):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    sizes = np.abs(values)
    return rng.choice(np.flatnonzero(sizes == sizes.max()))


# %% 0.1 and the first of equals
# says: , should choose action 0 in 8% and action 1 in 77%
# says: in this case it looks like this: it explores with ε = 0.1, whatever `epsilon` is
def choose(values, epsilon, rng):
    if rng.random() < 0.1:
        return rng.integers(len(values))
    return np.argmax(values)


# %% the comparison
# says: : np.flatnonzero(...) gives the indices at which a comparison is true
def choose(values, epsilon, rng):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return rng.choice(values == values.max())


# %% a search from 0
# says: nothing is left to choose from: for which values does that happen?
def choose(values, epsilon, rng):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    highest = 0
    for value in values:
        if value > highest:
            highest = value
    return rng.choice(np.flatnonzero(values == highest))


# %% explores twice
# says: of calls, which is none of the usual mistakes
def choose(values, epsilon, rng):
    if rng.random() < epsilon and rng.random() < epsilon:
        return rng.integers(len(values))
    return rng.choice(np.flatnonzero(values == values.max()))


# %% all of the best
# says: but gives an array: return one of its entries, drawn with rng.choice
def choose(values, epsilon, rng):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return np.flatnonzero(values == values.max())


# %% a search from 0, with its ties
# says: the search for the highest value starts from 0, and all values may be lower: start from the first one
def choose(values, epsilon, rng):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    highest, ties = 0, [0]
    for action, value in enumerate(values):
        if value > highest:
            highest, ties = value, []
        if value == highest:
            ties.append(action)
    return rng.choice(ties)


# %% a search from -1 for the first of equals
# says: the search for the highest value starts from -1, and all values may be lower: start from the first one; and ties should be broken at random
# says: ; and ties should be broken at random
def choose(values, epsilon, rng):
    best, highest = 0, -1
    for action, value in enumerate(values):
        if value > highest:
            best, highest = action, value
    return rng.integers(len(values)) if rng.random() < epsilon else best


# %% explores too often
# says: it explores too often, as if it asked twice whether to: draw rng.random() once, and let `else` do the rest
def choose(values, epsilon, rng):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    if rng.random() < 1 - epsilon:
        return rng.choice(np.flatnonzero(values == values.max()))
    return rng.integers(len(values))


# %% softmax
# says: in the place of the highest value it draws in proportion to e^value: the others come by ε alone
def choose(values, epsilon, rng):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    p = np.exp(values - values.max())
    return rng.choice(len(values), p=p / p.sum())


# %% shuffled in place
# says: changes the table `values`: choosing must change nothing
def choose(values, epsilon, rng):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    rng.shuffle(values)
    return int(values.argmax())
