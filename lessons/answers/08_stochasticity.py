# ruff: noqa
# Right and wrong answers to the exercises of lesson 8; tests/lessons/test_answers.py tries them all.
# An answer stands in the place of the exercise's cell. Methods without their class replace those of the solution.


# %% exercise 1, right: four digits
# says: Right: near 0.0232. By hand: 1.8 p = 0.2, so p = 0.111, which is 1.59 standard deviations on each side: 0.0220.
#   The dearer a hit, the more risk it is worth.
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
# says: that is the crossing with 10 hits; give `max_hits=5` to from_the_tee
level = stochasticity.crossing()

# %% exercise 1, wrong: the hits are forgotten in a loop
# says: that is the crossing with 10 hits
level = 0.018
while stochasticity.from_the_tee(level)["drive"] > stochasticity.from_the_tee(level)["chip"]:
    level += 0.00002

# %% exercise 1, wrong: the estimate, measured from the safe plan
# says: that is an estimate with a cost of 1.6 for a lost ball; the fast plan returns 0.8 now, so it costs 1.8
level = 0.0228

# %% exercise 1, wrong: the estimate by hand
# says: that is the estimate by hand, which takes for granted that both plans do what they should
level = 0.0220

# %% exercise 1, wrong: the lesson's level
# says: that is the lesson's own level; look for the one at which drive and chip are worth the same
level = 0.015

# %% exercise 1, wrong: two digits
# says: too low, as the drive is worth more there
# says: , as the drive is worth more there
level = 0.02

# %% exercise 1, wrong: three digits
# says: ; you are close, look in steps of 0.0001
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
# says: that is the standard deviation of a drive, 100 times the level
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
# says: the sign is wrong
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
# says: frontier(players) with
def frontier(players):
    best = []
    for name, (mean, spread) in players.items():
        if not any(m >= mean and s <= spread and (m, s) != (mean, spread) for m, s in players.values()):
            best.append(name)


# %% exercise 2, wrong: both really better
# says: a player with the same mean and a larger spread is beaten too, and so is one with the same spread and a lower
#   mean; one of the two may be equal
# says: it should give
def frontier(players):
    return [n for n, (m, s) in players.items() if not any(a > m and b < s for a, b in players.values())]


# %% exercise 2, wrong: beats itself
# says: every player is as good as itself, so it must not beat itself: one of the two numbers must be really better
def frontier(players):
    return [n for n, (m, s) in players.items() if not any(a >= m and b <= s for a, b in players.values())]


# %% exercise 2, wrong: equals beat each other
# says: two players with the same two numbers do not beat each other; one of the two must be really better
def frontier(players):
    return [n for n, (m, s) in players.items() if not any(a >= m and b <= s for o, (a, b) in players.items() if o != n)]


# %% exercise 2, wrong: the equal mean
# says: an equal mean is left out: a player with the same mean and a larger spread is beaten too
def frontier(players):
    return [n for n, (m, s) in players.items() if not any(a > m and b <= s for a, b in players.values())]


# %% exercise 2, wrong: the equal spread
# says: an equal spread is left out: a player with the same spread and a lower mean is beaten too
def frontier(players):
    return [n for n, (m, s) in players.items() if not any(a >= m and b < s for a, b in players.values())]


# %% exercise 2, wrong: more spread is better
# says: it takes a *larger* spread as better
def frontier(players):
    return [
        n
        for n, (m, s) in players.items()
        if not any(a >= m and b >= s and (a, b) != (m, s) for a, b in players.values())
    ]


# %% exercise 2, wrong: less mean is better
# says: it takes a *lower* mean as better
def frontier(players):
    return [
        n
        for n, (m, s) in players.items()
        if not any(a <= m and b <= s and (a, b) != (m, s) for a, b in players.values())
    ]


# %% exercise 2, wrong: the wrong way round
# says: it takes a lower mean and a larger spread as better: the comparison is the wrong way round
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
# says: these are the players with the highest mean; a lower mean with a smaller spread is worth choosing too
def frontier(players):
    top = max(m for m, s in players.values())
    return [n for n, (m, s) in players.items() if m == top]


# %% exercise 2, wrong: only the smallest spread
# says: these are the players with the smallest spread; a larger spread with a higher mean is worth choosing too
def frontier(players):
    low = min(s for m, s in players.values())
    return [n for n, (m, s) in players.items() if s == low]


# %% exercise 2, wrong: one number is enough
# says: one better number is enough there to beat a player; the other one must not be worse
def frontier(players):
    return [n for n, (m, s) in players.items() if not any(a > m or b < s for a, b in players.values())]


# %% exercise 2, wrong: everybody
# says: these are all the players: nobody is beaten; is the comparison ever true?
def frontier(players):
    return list(players)


# %% exercise 2, wrong: the pairs
# says: should hold names such as
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
# says: : there may be several
# says: should be a list of names, but is the text
def frontier(players):
    for n, (m, s) in players.items():
        if not any(a >= m and b <= s and (a, b) != (m, s) for a, b in players.values()):
            return n


# %% exercise 2, wrong: appended in the inner loop
# says: more than once: is it appended in the inner loop?
def frontier(players):
    best = []
    for n, (m, s) in players.items():
        for a, b in players.values():
            if not (a >= m and b <= s and (a, b) != (m, s)):
                best.append(n)
    return best


# %% exercise 2, wrong: by mean less spread
# says: these are the players for whom mean minus spread is largest; that is only one taste
def frontier(players):
    top = max(m - s for m, s in players.values())
    return [n for n, (m, s) in players.items() if m - s == top]


# %% exercise 2, wrong: by mean over spread
# says: these are the players for whom mean divided by spread is largest; that is only one taste
def frontier(players):
    top = max(m / s for m, s in players.values())
    return [n for n, (m, s) in players.items() if m / s == top]


# %% exercise 2, wrong: one of two equals
# says: of players with the same two numbers only one is left; they do not beat each other
def frontier(players):
    best = {}
    for n, (m, s) in players.items():
        if (m, s) in best.values():
            continue
        if not any(a >= m and b <= s and (a, b) != (m, s) for a, b in players.values()):
            best[n] = (m, s)
    return list(best)


# %% exercise 2, wrong: beaten by two
# says: a player must be beaten by *one* other player in both numbers, not by one in the mean and another in the spread
def frontier(players):
    names = []
    for n, (m, s) in players.items():
        better_mean = any(a > m for a, b in players.values())
        better_spread = any(b < s for a, b in players.values())
        if not (better_mean and better_spread):
            names.append(n)
    return names


# %% exercise 2, wrong: players are removed
# says: changes the dictionary that it is given; collect the names in a list of their own
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
# says: the players
frontier = ["A", "B"]


# %% exercise 2, wrong: no parameter
# says: its parameters are not those of the exercise
def frontier():
    return []


# %% exercise 2, wrong: a number
# says: should be a list of names, but is a
def frontier(players):
    return len(players)


# %% exercise 3, right: an if and an else
# says: Right: two weights are enough to move the crossing. See it race:
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
# says: good and bad surprises have changed places: κ > 0 avoids risk, so that bad ones weigh 1 + κ (β has the opposite
#   sign)
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 1 + self.kappa if delta > 0 else 1 - self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% exercise 3, wrong: by the reward
# says: it asks whether the *reward* is good; a surprise is good if δ is above 0
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 1 - self.kappa if reward > 0 else 1 + self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% exercise 3, wrong: by the target
# says: it asks whether the *target* is above 0; a surprise is good if δ is
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * max(self.Q[next_state])
    w = 1 - self.kappa if target > 0 else 1 + self.kappa
    self.Q[state, action] += self.learning_rate * w * (target - self.Q[state, action])


# %% exercise 3, wrong: Q-learning
# says: the weight is missing: that is Q-learning
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: the rule of the lesson
# says: that is the weight of Delétang et al., 2σ(βδ); here are two weights, whatever the size of δ
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 2 / (1 + np.exp(self.kappa * delta))
    self.Q[state, action] += self.learning_rate * w * delta


# %% exercise 3, wrong: the rule of the lesson with its sign
# says: that is 2σ(κδ), the weight of Delétang et al., and κ has the opposite sign of β
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 2 / (1 + np.exp(-self.kappa * delta))
    self.Q[state, action] += self.learning_rate * w * delta


# %% exercise 3, wrong: only bad surprises
# says: nothing is learned from good surprises; they weigh 1 − κ
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    if delta < 0:
        self.Q[state, action] += self.learning_rate * (1 + self.kappa) * delta


# %% exercise 3, wrong: good ones without a weight
# says: good surprises have no weight of their own, 1 − κ
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 1.0
    if delta < 0:
        w = 1 + self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% exercise 3, wrong: bad ones without a weight
# says: bad surprises have no weight of their own, 1 + κ
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 1.0
    if delta > 0:
        w = 1 - self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% exercise 3, wrong: the 1 is missing
# says: the 1 is missing in the weights, which are 1 − κ and 1 + κ
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = -self.kappa if delta > 0 else self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% exercise 3, wrong: one weight
# says: the weight is 1 − κ always, for bad surprises too
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    self.Q[state, action] += self.learning_rate * (1 - self.kappa) * delta


# %% exercise 3, wrong: the weight on the target
# says: the weight belongs to the whole δ, not to the target alone
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
# says: the sign is wrong: it moves away from the target
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 1 - self.kappa if delta > 0 else 1 + self.kappa
    self.Q[state, action] -= self.learning_rate * w * delta


# %% exercise 3, wrong: old less target
# says: the sign is wrong: it moves away from the target
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = self.Q[state, action] - (reward + self.discount * value)
    w = 1 + self.kappa if delta > 0 else 1 - self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% exercise 3, wrong: the sign of δ
# says: δ has the wrong sign: it is the target less Q(S, A), not Q(S, A) less the target
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


# %% exercise 3, wrong: the old value
# says: it asks whether the old *value* is above 0; a surprise is good if δ is
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 1 - self.kappa if self.Q[state, action] > 0 else 1 + self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% exercise 3, wrong: always more
# says: the weight is 1 + κ always, for good surprises too
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 1 + self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% exercise 3, wrong: κ alone
# says: κ itself stands where the weight should
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = self.kappa
    self.Q[state, action] += self.learning_rate * w * delta


# %% exercise 3, wrong: half as much
# says: the weights are half as large as they should be
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = (1 - self.kappa if delta > 0 else 1 + self.kappa) / 2
    self.Q[state, action] += self.learning_rate * w * delta


# %% exercise 3, wrong: good surprises only
# says: nothing is learned from bad surprises; they weigh 1 + κ
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    delta = reward + self.discount * value - self.Q[state, action]
    w = 1 - self.kappa if delta > 0 else 0.0
    self.Q[state, action] += self.learning_rate * w * delta
