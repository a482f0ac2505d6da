# ruff: noqa
# Right and wrong answers to the exercises of lesson 8; tests/lessons/test_answers.py tries them all.
# An answer stands in the place of the exercise's cell. Methods without their class replace those of the solution.


# %% exercise 1, right: four digits
level = 0.0232

# %% exercise 1, right: by a loop
level = 0.015
while stochasticity.from_the_tee(level, max_hits=5)["drive"] >= stochasticity.from_the_tee(level, max_hits=5)["chip"]:
    level += 0.0001

# %% exercise 1, right: the step before
level = 0.02
while True:
    worth = stochasticity.from_the_tee(level + 0.0001, max_hits=5)
    if worth["chip"] > worth["drive"]:
        break
    level += 0.0001

# %% exercise 1, right: by bisection
low, high = 0.02, 0.03
while high - low > 1e-5:
    middle = (low + high) / 2
    worth = stochasticity.from_the_tee(middle, max_hits=5)
    if worth["drive"] > worth["chip"]:
        low = middle
    else:
        high = middle
level = low

# %% exercise 1, right: over an array
levels = np.arange(0.022, 0.025, 0.0001)
leads = [
    stochasticity.from_the_tee(l, max_hits=5)["drive"] - stochasticity.from_the_tee(l, max_hits=5)["chip"]
    for l in levels
]
level = levels[np.abs(leads).argmin()]

# %% exercise 1, right: by the function for the crossing
level = stochasticity.crossing(0.02, 0.025, max_hits=5)

# %% exercise 1, right: by interpolation
levels = [0.022, 0.023, 0.024]
leads = []
for each in levels:
    w = stochasticity.from_the_tee(each, max_hits=5)
    leads.append(w["chip"] - w["drive"])
level = np.interp(0, leads, levels)

# %% exercise 1, wrong: nothing was done
# says: the value with which the cell began
level = 0.0187

# %% exercise 1, wrong: the placeholder
# says: Not solved yet
level = ...

# %% exercise 1, wrong: none
# says: Not solved yet
level = None

# %% exercise 1, wrong: the hits are forgotten
# says: that is the crossing with 10 hits
level = stochasticity.crossing()

# %% exercise 1, wrong: the hits are forgotten in a loop
# says: that is the crossing with 10 hits
level = 0.018
while stochasticity.from_the_tee(level)["drive"] > stochasticity.from_the_tee(level)["chip"]:
    level += 0.00002

# %% exercise 1, wrong: the estimate, measured from the safe plan
# says: costs 1.8
level = 0.0228

# %% exercise 1, wrong: the estimate by hand
# says: that is the estimate by hand
level = 0.0220

# %% exercise 1, wrong: the lesson's level
# says: the lesson's own level
level = 0.015

# %% exercise 1, wrong: two digits
# says: too low, as the drive is worth more there
level = 0.02

# %% exercise 1, wrong: three digits
# says: look in steps of 0.0001
level = 0.023

# %% exercise 1, wrong: too high
# says: it is too high
level = 0.03

# %% exercise 1, wrong: the comparison the wrong way round
# says: that is the value with which the cell began
level = 0.0187
while stochasticity.from_the_tee(level, max_hits=5)["drive"] < stochasticity.from_the_tee(level, max_hits=5)["chip"]:
    level += 0.0001

# %% exercise 1, wrong: the deviation
# says: that is the standard deviation of a drive
level = 2.32

# %% exercise 1, wrong: in percent of one
# says: is not a level
level = 23.2

# %% exercise 1, wrong: a text
# says: leave the quotes out
level = "0.0232"

# %% exercise 1, wrong: the worth
# says: take an entry of it
level = stochasticity.from_the_tee(0.0232, max_hits=5)

# %% exercise 1, wrong: a negative level
# says: is not a level
level = -0.0232

# %% exercise 1, wrong: the function
# says: call it
level = stochasticity.crossing

# %% exercise 1, wrong: no chance at all
# says: is not a level, a number above 0 and far below 1: it is too low
level = 0

# %% exercise 1, wrong: two steps too far
# says: look in steps of 0.0001
level = 0.0234

# %% exercise 1, wrong: steps of a thousandth
# says: too high
level = 0.0187
while stochasticity.from_the_tee(level, max_hits=5)["drive"] > stochasticity.from_the_tee(level, max_hits=5)["chip"]:
    level += 0.001


# %% exercise 2, right: two loops
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


# %% exercise 2, right: a helper and a comprehension
def beats(a, b):
    return a[0] >= b[0] and a[1] <= b[1] and (a[0] > b[0] or a[1] < b[1])


def frontier(players):
    return [n for n in players if not any(beats(players[o], players[n]) for o in players)]


# %% exercise 2, right: sorted by spread
def frontier(players):
    best = -float("inf")
    found = []
    for spread in sorted({s for _, s in players.values()}):
        top = max(m for m, s in players.values() if s == spread)
        if top > best:
            found += [n for n, pair in players.items() if pair == (top, spread)]
            best = top
    return found


# %% exercise 2, right: arrays
def frontier(players):
    names = list(players)
    mean, spread = np.array([players[n] for n in names]).T
    better = (mean[:, None] >= mean) & (spread[:, None] <= spread)
    better &= (mean[:, None] > mean) | (spread[:, None] < spread)
    return [name for name, beaten in zip(names, better.any(axis=0)) if not beaten]


# %% exercise 2, right: a set
def frontier(players):
    beaten = set()
    for a, (ma, sa) in players.items():
        for b, (mb, sb) in players.items():
            if (ma > mb and sa <= sb) or (ma >= mb and sa < sb):
                beaten.add(b)
    return set(players) - beaten


# %% exercise 2, right: for and else
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


# %% exercise 2, right: a dictionary, whose keys are names
def frontier(players):
    return {
        name: pair
        for name, pair in players.items()
        if all(m < pair[0] or s > pair[1] or (m, s) == pair for m, s in players.values())
    }


# %% exercise 2, wrong: not solved
# says: Not solved yet
def frontier(players):
    raise NotImplementedError("not solved yet: replace this line")


# %% exercise 2, wrong: no return
# says: is a `return` missing?
def frontier(players):
    best = []
    for name, (mean, spread) in players.items():
        if not any(m >= mean and s <= spread and (m, s) != (mean, spread) for m, s in players.values()):
            best.append(name)


# %% exercise 2, wrong: both really better
# says: one of the two may be equal
def frontier(players):
    return [n for n, (m, s) in players.items() if not any(a > m and b < s for a, b in players.values())]


# %% exercise 2, wrong: beats itself
# says: it must not beat itself
def frontier(players):
    return [n for n, (m, s) in players.items() if not any(a >= m and b <= s for a, b in players.values())]


# %% exercise 2, wrong: equals beat each other
# says: do not beat each other
def frontier(players):
    return [n for n, (m, s) in players.items() if not any(a >= m and b <= s for o, (a, b) in players.items() if o != n)]


# %% exercise 2, wrong: the equal mean
# says: an equal mean is left out
def frontier(players):
    return [n for n, (m, s) in players.items() if not any(a > m and b <= s for a, b in players.values())]


# %% exercise 2, wrong: the equal spread
# says: an equal spread is left out
def frontier(players):
    return [n for n, (m, s) in players.items() if not any(a >= m and b < s for a, b in players.values())]


# %% exercise 2, wrong: more spread is better
# says: takes a *larger* spread as better
def frontier(players):
    return [
        n
        for n, (m, s) in players.items()
        if not any(a >= m and b >= s and (a, b) != (m, s) for a, b in players.values())
    ]


# %% exercise 2, wrong: less mean is better
# says: takes a *lower* mean as better
def frontier(players):
    return [
        n
        for n, (m, s) in players.items()
        if not any(a <= m and b <= s and (a, b) != (m, s) for a, b in players.values())
    ]


# %% exercise 2, wrong: the wrong way round
# says: the comparison is the wrong way round
def frontier(players):
    return [
        n
        for n, (m, s) in players.items()
        if not any(a <= m and b >= s and (a, b) != (m, s) for a, b in players.values())
    ]


# %% exercise 2, wrong: the beaten ones
# says: these are the players that *are* beaten
def frontier(players):
    return [
        n for n, (m, s) in players.items() if any(a >= m and b <= s and (a, b) != (m, s) for a, b in players.values())
    ]


# %% exercise 2, wrong: only the highest mean
# says: the players with the highest mean
def frontier(players):
    top = max(m for m, s in players.values())
    return [n for n, (m, s) in players.items() if m == top]


# %% exercise 2, wrong: only the smallest spread
# says: the players with the smallest spread
def frontier(players):
    low = min(s for m, s in players.values())
    return [n for n, (m, s) in players.items() if s == low]


# %% exercise 2, wrong: one number is enough
# says: one better number is enough
def frontier(players):
    return [n for n, (m, s) in players.items() if not any(a > m or b < s for a, b in players.values())]


# %% exercise 2, wrong: everybody
# says: nobody is beaten
def frontier(players):
    return list(players)


# %% exercise 2, wrong: the pairs
# says: should hold names
def frontier(players):
    return [
        (m, s)
        for m, s in players.values()
        if not any(a >= m and b <= s and (a, b) != (m, s) for a, b in players.values())
    ]


# %% exercise 2, wrong: numbers of players
# says: should hold names
def frontier(players):
    pairs = list(players.values())
    return [i for i, (m, s) in enumerate(pairs) if not any(a >= m and b <= s and (a, b) != (m, s) for a, b in pairs)]


# %% exercise 2, wrong: only the first name
# says: there may be several
def frontier(players):
    for n, (m, s) in players.items():
        if not any(a >= m and b <= s and (a, b) != (m, s) for a, b in players.values()):
            return n


# %% exercise 2, wrong: appended in the inner loop
# says: more than once
def frontier(players):
    best = []
    for n, (m, s) in players.items():
        for a, b in players.values():
            if not (a >= m and b <= s and (a, b) != (m, s)):
                best.append(n)
    return best


# %% exercise 2, wrong: by mean less spread
# says: mean minus spread is largest
def frontier(players):
    top = max(m - s for m, s in players.values())
    return [n for n, (m, s) in players.items() if m - s == top]


# %% exercise 2, wrong: by mean over spread
# says: mean divided by spread is largest; that is only one taste
def frontier(players):
    top = max(m / s for m, s in players.values())
    return [n for n, (m, s) in players.items() if m / s == top]


# %% exercise 2, wrong: one of two equals
# says: only one is left
def frontier(players):
    best = {}
    for n, (m, s) in players.items():
        if (m, s) in best.values():
            continue
        if not any(a >= m and b <= s and (a, b) != (m, s) for a, b in players.values()):
            best[n] = (m, s)
    return list(best)


# %% exercise 2, wrong: beaten by two
# says: by *one* other player in both numbers
def frontier(players):
    names = []
    for n, (m, s) in players.items():
        better_mean = any(a > m for a, b in players.values())
        better_spread = any(b < s for a, b in players.values())
        if not (better_mean and better_spread):
            names.append(n)
    return names


# %% exercise 2, wrong: players are removed
# says: changes the dictionary
def frontier(players):
    for n, (m, s) in list(players.items()):
        if any(a >= m and b <= s and (a, b) != (m, s) for a, b in players.values()):
            del players[n]
    return list(players)


# %% exercise 2, wrong: removed while looping
# says: raises RuntimeError
def frontier(players):
    for n, (m, s) in players.items():
        if any(a >= m and b <= s and (a, b) != (m, s) for a, b in players.values()):
            players.pop(n)
    return list(players)


# %% exercise 2, wrong: a list, not a function
# says: should be a function
frontier = ["A", "B"]


# %% exercise 2, wrong: no parameter
# says: its parameters are not those of the exercise
def frontier():
    return []


# %% exercise 2, wrong: a number
# says: should be a list of names
def frontier(players):
    return len(players)


# %% exercise 3, right: an if and an else
def learn(self, state, action, reward, next_state, terminated):
    target = reward
    if not terminated:
        target += self.discount * max(self.Q[next_state])
    delta = target - self.Q[state, action]
    if delta > 0:
        self.Q[state, action] += self.learning_rate * (1 - self.kappa) * delta
    else:
        self.Q[state, action] += self.learning_rate * (1 + self.kappa) * delta


# %% exercise 3, right: the package's functions
def learn(self, state, action, reward, next_state, terminated):
    target = one_step_target(reward, self.discount, best_value(self.Q, next_state), terminated)
    delta = target - self.Q[state, action]
    w = 1 - self.kappa if delta > 0 else 1 + self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% exercise 3, right: by the sign
def learn(self, state, action, reward, next_state, terminated):
    delta = reward + self.discount * np.max(self.Q[next_state]) * (not terminated) - self.Q[state, action]
    self.Q[state, action] += self.learning_rate * (1 - self.kappa * np.sign(delta)) * delta


# %% exercise 3, right: by the absolute value
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else self.Q[next_state].max()
    delta = reward + self.discount * value - self.Q[state, action]
    self.Q[state, action] += self.learning_rate * (delta - self.kappa * abs(delta))


# %% exercise 3, right: an index
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    weight = (1 + self.kappa, 1 - self.kappa)[int(delta > 0)]
    self.Q[state][action] += self.learning_rate * weight * delta


# %% exercise 3, right: a new rate
def learn(self, state, action, reward, next_state, terminated):
    old = self.Q[state, action]
    target = reward if terminated else reward + self.discount * self.Q[next_state].max()
    rate = self.learning_rate * (1 - self.kappa if target >= old else 1 + self.kappa)
    self.Q[state, action] = (1 - rate) * old + rate * target


# %% exercise 3, right: more parameters than needed
def learn(self, state, action, reward, next_state, next_action, terminated, truncated):
    delta = -self.Q[state, action] + reward
    if not terminated:
        delta += self.discount * max(self.Q[next_state])
    weight = 1 + self.kappa
    if delta > 0:
        weight = 1 - self.kappa
    self.Q[state, action] += self.learning_rate * weight * delta


# %% exercise 3, wrong: not solved
# says: Not solved yet
def learn(self, state, action, reward, next_state, terminated):
    raise NotImplementedError("not solved yet: replace this line")


# %% exercise 3, wrong: nothing
# says: changes no table at all
def learn(self, state, action, reward, next_state, terminated): ...


# %% exercise 3, wrong: a local variable
# says: changes no table at all
def learn(self, state, action, reward, next_state, terminated):
    q = self.Q[state, action]
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - q
    w = 1 - self.kappa if delta > 0 else 1 + self.kappa
    q += self.learning_rate * w * delta


# %% exercise 3, wrong: the signs
# says: have changed places
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 1 + self.kappa if delta > 0 else 1 - self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% exercise 3, wrong: by the reward
# says: it asks whether the *reward* is good
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 1 - self.kappa if reward > 0 else 1 + self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% exercise 3, wrong: by the target
# says: it asks whether the *target* is above 0
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * max(self.Q[next_state])
    w = 1 - self.kappa if target > 0 else 1 + self.kappa
    self.Q[state, action] += self.learning_rate * w * (target - self.Q[state, action])


# %% exercise 3, wrong: Q-learning
# says: the weight is missing
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: the rule of the lesson
# says: that is the weight of Delétang
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 2 / (1 + np.exp(self.kappa * delta))
    self.Q[state, action] += self.learning_rate * w * delta


# %% exercise 3, wrong: the rule of the lesson with its sign
# says: κ has the opposite sign of β
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 2 / (1 + np.exp(-self.kappa * delta))
    self.Q[state, action] += self.learning_rate * w * delta


# %% exercise 3, wrong: only bad surprises
# says: nothing is learned from good surprises
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    if delta < 0:
        self.Q[state, action] += self.learning_rate * (1 + self.kappa) * delta


# %% exercise 3, wrong: good ones without a weight
# says: good surprises have no weight of their own
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 1.0
    if delta < 0:
        w = 1 + self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% exercise 3, wrong: bad ones without a weight
# says: bad surprises have no weight of their own
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 1.0
    if delta > 0:
        w = 1 - self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% exercise 3, wrong: the 1 is missing
# says: the 1 is missing
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = -self.kappa if delta > 0 else self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% exercise 3, wrong: one weight
# says: the weight is 1 − κ always
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    self.Q[state, action] += self.learning_rate * (1 - self.kappa) * delta


# %% exercise 3, wrong: the weight on the target
# says: the weight belongs to the whole δ
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    target = reward + self.discount * value
    w = 1 - self.kappa if target > self.Q[state, action] else 1 + self.kappa
    self.Q[state, action] += self.learning_rate * (w * target - self.Q[state, action])


# %% exercise 3, wrong: terminated forgotten
# says: a terminal state has no future
def learn(self, state, action, reward, next_state, terminated):
    delta = reward + self.discount * max(self.Q[next_state]) - self.Q[state, action]
    w = 1 - self.kappa if delta > 0 else 1 + self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% exercise 3, wrong: no old value in the error
# says: − Q(S, A) is missing
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * max(self.Q[next_state])
    w = 1 - self.kappa if target > self.Q[state, action] else 1 + self.kappa
    self.Q[state, action] += self.learning_rate * w * target


# %% exercise 3, wrong: the old value is lost
# says: the old value is lost
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 1 - self.kappa if delta > 0 else 1 + self.kappa
    self.Q[state, action] = self.learning_rate * w * delta


# %% exercise 3, wrong: minus
# says: the sign is wrong
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 1 - self.kappa if delta > 0 else 1 + self.kappa
    self.Q[state, action] -= self.learning_rate * w * delta


# %% exercise 3, wrong: old less target
# says: the sign is wrong
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = self.Q[state, action] - (reward + self.discount * value)
    w = 1 + self.kappa if delta > 0 else 1 - self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% exercise 3, wrong: the sign of δ
# says: δ has the wrong sign
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = self.Q[state, action] - (reward + self.discount * value)
    w = 1 - self.kappa if delta > 0 else 1 + self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% exercise 3, wrong: the mean for the maximum
# says: the mean over the actions
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else np.mean(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 1 - self.kappa if delta > 0 else 1 + self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% exercise 3, wrong: a fixed κ
# says: a κ of 0.5
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 0.5 if delta > 0 else 1.5
    self.Q[state, action] += self.learning_rate * w * delta


# %% exercise 3, wrong: a fixed learning rate
# says: a learning rate of 0.02
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 1 - self.kappa if delta > 0 else 1 + self.kappa
    self.Q[state, action] += 0.02 * w * delta


# %% exercise 3, wrong: no discount
# says: not discounted
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + value - self.Q[state, action]
    w = 1 - self.kappa if delta > 0 else 1 + self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% exercise 3, wrong: self is forgotten
# says: write `self.` before a field
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + discount * value - self.Q[state, action]
    w = 1 - self.kappa if delta > 0 else 1 + self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% exercise 3, wrong: kappa without self
# says: write `self.` before a field
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 1 - kappa if delta > 0 else 1 + kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% exercise 3, wrong: nothing is learned at the end
# says: at the end of an episode nothing is learned
def learn(self, state, action, reward, next_state, terminated):
    if terminated:
        return
    delta = reward + self.discount * max(self.Q[next_state]) - self.Q[state, action]
    w = 1 - self.kappa if delta > 0 else 1 + self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% exercise 3, wrong: the weight is squared
# says: the weight counts twice
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 1 - self.kappa if delta > 0 else 1 + self.kappa
    delta = delta * w
    self.Q[state, action] += self.learning_rate * w * delta


# %% exercise 3, wrong: an agent instead of the class
# says: should be the class
TwoWeights = TwoWeights(np.zeros((3, 3)))


# %% exercise 3, wrong: a field is missing
# says: should keep its field `kappa`
class TwoWeights(NamedTuple):
    Q: np.ndarray
    learning_rate: float = 0.02
    discount: float = 1.0
    epsilon: float = 0.1

    def act(self, state, rng):
        return 0

    def learn(self, state, action, reward, next_state, terminated):
        delta = reward - self.Q[state, action]
        self.Q[state, action] += self.learning_rate * (0.5 if delta > 0 else 1.5) * delta
