# ruff: noqa
# Right and wrong answers to the exercises of lesson 6; tests/lessons/test_answers.py tries them all.
# An answer stands in the place of the exercise's cell. Methods without their class replace those of the solution.


# %% exercise 1, right: the number
# says: Right: 22, not 19. The second word tells a part of what the first one has told already, so that information adds
#   up more and more slowly.
words = 22

# %% exercise 1, right: as a float
words = 22.0

# %% exercise 1, right: a loop with a condition
words = 1
while not signal.information(0.1, words) >= 0.4:
    words = words + 1

# %% exercise 1, right: the first of a range
words = next(L for L in range(1, 57) if signal.information(0.1, L) >= 0.4)

# %% exercise 1, right: the smallest of a list
words = min([L for L in range(1, 40) if signal.information(0.1, L) >= 0.4])

# %% exercise 1, right: of NumPy
bits = np.array([signal.information(0.1, L) for L in range(1, 40)])
words = np.searchsorted(bits, 0.4) + 1


# %% exercise 1, right: by a function
def carries(n):
    return signal.information(tau=0.1, length=n)


words = 0
for n in range(1, 30):
    if carries(n) >= 0.4:
        words = n
        break

# %% exercise 1, wrong: nothing was done
# says: 1 word carries
# says: that is the value with which the cell began
words = 1

# %% exercise 1, wrong: the placeholder
# says: Not solved yet
words = ...

# %% exercise 1, wrong: none
# says: Not solved yet
words = None

# %% exercise 1, wrong: divided
# says: that is 0.4 divided by the bits of one word;
# says: the words repeat each other in part, so more are needed
words = math.ceil(0.4 / signal.information(0.1))

# %% exercise 1, wrong: divided and rounded down
# says: that is 0.4 divided by the bits of one word, rounded down;
words = int(0.4 / signal.information(0.1))

# %% exercise 1, wrong: divided and not rounded
# says: words should be a whole number, since half a word is never said, but is
words = 0.4 / signal.information(0.1)

# %% exercise 1, wrong: the last one below
# says: that is the last length that carries less than 0.4 bit; one word more is enough
words = max(L for L in range(1, 40) if signal.information(0.1, L) < 0.4)

# %% exercise 1, wrong: an index
# says: one word more is enough
bits = [signal.information(0.1, L) for L in range(1, 40)]
words = next(k for k, b in enumerate(bits) if b >= 0.4)

# %% exercise 1, wrong: one too many
# says: one word less is enough; is the comparison `<`, and the count read before it grows?
words = 1
while signal.information(0.1, words - 1) < 0.4:
    words += 1

# %% exercise 1, wrong: the longest message
# says: that is the most that the toy can say, and fewer are enough
words = 28

# %% exercise 1, wrong: from the figure
# says: that is not enough yet
words = 16

# %% exercise 1, wrong: on the safe side
# says: fewer words are enough
words = 25

# %% exercise 1, wrong: the noise of the other figure
# says: that is the answer for τ = 0.05
words = next(L for L in range(1, 57) if signal.information(0.05, L) >= 0.4)

# %% exercise 1, wrong: half a bit
# says: that is where *half* a bit is reached
words = next(L for L in range(1, 57) if signal.information(0.1, L) >= 0.5)

# %% exercise 1, wrong: the bits
# says: a whole number
words = signal.information(0.1, 22)

# %% exercise 1, wrong: a text
# says: leave the quotes out
words = "22"

# %% exercise 1, wrong: a list
# says: take an entry of it
words = [L for L in range(1, 40) if signal.information(0.1, L) >= 0.4]

# %% exercise 1, wrong: four words at a time
# says: the answer for τ = 0.05
words = math.ceil(22 / 4)


# %% exercise 2, right: with NumPy
# says: Right: these are the bits of the figures.
def bits_in(joint):
    p_x = joint.sum(axis=1, keepdims=True)
    p_y = joint.sum(axis=0, keepdims=True)
    some = joint > 0
    return np.sum(joint[some] * np.log2(joint[some] / (p_x * p_y)[some]))


# %% exercise 2, right: from entropies
def entropy(p):
    p = p[p > 0]
    return -np.sum(p * np.log2(p))


def bits_in(joint):
    return entropy(joint.sum(axis=1)) + entropy(joint.sum(axis=0)) - entropy(joint)


# %% exercise 2, right: entropy less what is open
def bits_in(joint):
    p_x, p_y = joint.sum(axis=1), joint.sum(axis=0)
    before = -sum(p * math.log2(p) for p in p_x if p > 0)
    after = 0.0
    for y in range(len(p_y)):
        for p in joint[:, y] / p_y[y]:
            if p > 0:
                after -= p_y[y] * p * math.log2(p)
    return before - after


# %% exercise 2, right: natural logarithm, divided
def bits_in(joint):
    total = 0.0
    for x, row in enumerate(joint):
        for y, p in enumerate(row):
            if p != 0:
                total += p * math.log(p / (row.sum() * joint[:, y].sum()))
    return total / math.log(2)


# %% exercise 2, right: nansum
def bits_in(joint):
    ratio = joint / np.outer(joint.sum(1), joint.sum(0))
    return np.nansum(joint * np.log2(ratio))


# %% exercise 2, right: with a difference of logarithms
def bits_in(joint):
    total = 0
    rows, columns = joint.shape
    for x in range(rows):
        for y in range(columns):
            p = joint[x][y]
            if p == 0:
                continue
            total = total + p * (math.log2(p) - math.log2(sum(joint[x])) - math.log2(sum(joint[:, y])))
    return total


# %% exercise 2, right: by the conditional probability
def bits_in(joint):
    total = 0.0
    for y in range(joint.shape[1]):
        p_y = joint[:, y].sum()
        for x in range(joint.shape[0]):
            given_y = joint[x, y] / p_y
            if given_y > 0:
                total += joint[x, y] * np.log2(given_y / joint[x].sum())
    return total


# %% exercise 2, wrong: nothing
# says: Not solved yet
def bits_in(joint):
    raise NotImplementedError


# %% exercise 2, wrong: no return
# says: is a `return` missing?
def bits_in(joint):
    total = 0.0
    for x in range(joint.shape[0]):
        for y in range(joint.shape[1]):
            if joint[x, y] > 0:
                total += joint[x, y] * math.log2(joint[x, y] / (joint[x].sum() * joint[:, y].sum()))


# %% exercise 2, wrong: a whole number beyond all real ones
# says: should be a finite number, but is
# says: : is something divided by zero?
def bits_in(joint):
    return 10**400


# %% exercise 2, wrong: natural logarithm
# says: the logarithm has the base e; bits need the base 2, `math.log2` or `np.log2`
def bits_in(joint):
    total = 0.0
    for x in range(joint.shape[0]):
        for y in range(joint.shape[1]):
            if joint[x, y] > 0:
                total += joint[x, y] * math.log(joint[x, y] / (joint[x].sum() * joint[:, y].sum()))
    return total


# %% exercise 2, wrong: base 10
# says: the logarithm has the base 10; bits need the base 2, `math.log2` or `np.log2`
def bits_in(joint):
    some = joint > 0
    both = np.outer(joint.sum(axis=1), joint.sum(axis=0))
    return np.sum(joint[some] * np.log10(joint[some] / both[some]))


# %% exercise 2, wrong: upside down
# says: the sign is wrong: p(x, y) stands above the line, and p(x) p(y) below
def bits_in(joint):
    some = joint > 0
    both = np.outer(joint.sum(axis=1), joint.sum(axis=0))
    return np.sum(joint[some] * np.log2(both[some] / joint[some]))


# %% exercise 2, wrong: zeros
# says: ) gives nan: the logarithm of 0 times 0 is not a number, so leave pairs out that never occur
def bits_in(joint):
    both = np.outer(joint.sum(axis=1), joint.sum(axis=0))
    return np.sum(joint * np.log2(joint / both))


# %% exercise 2, wrong: zeros in a loop
# says: raises ValueError
def bits_in(joint):
    total = 0.0
    for x in range(joint.shape[0]):
        for y in range(joint.shape[1]):
            total += joint[x, y] * math.log2(joint[x, y] / (joint[x].sum() * joint[:, y].sum()))
    return total


# %% exercise 2, wrong: no weights
# says: the weight p(x, y) before the logarithm is missing
def bits_in(joint):
    some = joint > 0
    both = np.outer(joint.sum(axis=1), joint.sum(axis=0))
    return np.sum(np.log2(joint[some] / both[some]))


# %% exercise 2, wrong: the wrong weights
# says: the weight before the logarithm should be p(x, y), not p(x) p(y)
def bits_in(joint):
    some = joint > 0
    both = np.outer(joint.sum(axis=1), joint.sum(axis=0))
    return np.sum(both[some] * np.log2(joint[some] / both[some]))


# %% exercise 2, wrong: the entropy of the pair
# says: that is −Σ p(x, y) log p(x, y), the entropy of the pair; p(x, y) has to be divided by p(x) p(y)
def bits_in(joint):
    p = joint[joint > 0]
    return -np.sum(p * np.log2(p))


# %% exercise 2, wrong: no division
# says: that is Σ p(x, y) log p(x, y): p(x, y) has to be divided by p(x) p(y)
def bits_in(joint):
    total = 0.0
    for p in joint.ravel():
        if p > 0:
            total += p * math.log2(p)
    return total


# %% exercise 2, wrong: the entropy of the needs
# says: that is the entropy of x alone: it leaves the message out
def bits_in(joint):
    p = joint.sum(axis=1)
    return -np.sum(p * np.log2(p))


# %% exercise 2, wrong: the entropy of the messages
# says: that is the entropy of y alone: it leaves the need out
def bits_in(joint):
    p = joint.sum(axis=0)
    return -np.sum(p * np.log2(p))


# %% exercise 2, wrong: what is still open
# says: that is what is still open about x after the message; the information is what the message has told
def bits_in(joint):
    total = 0.0
    for x in range(joint.shape[0]):
        for y in range(joint.shape[1]):
            if joint[x, y] > 0:
                total -= joint[x, y] * math.log2(joint[x, y] / joint[:, y].sum())
    return total


# %% exercise 2, wrong: the columns are missing
# says: p(y) is missing: it divides by p(x) alone
def bits_in(joint):
    total = 0.0
    for x in range(joint.shape[0]):
        for y in range(joint.shape[1]):
            if joint[x, y] > 0:
                total += joint[x, y] * math.log2(joint[x, y] / joint[x].sum())
    return total


# %% exercise 2, wrong: the rows are missing
# says: p(x) is missing: it divides by p(y) alone
def bits_in(joint):
    total = 0.0
    for x in range(joint.shape[0]):
        for y in range(joint.shape[1]):
            if joint[x, y] > 0:
                total += joint[x, y] * math.log2(joint[x, y] / joint[:, y].sum())
    return total


# %% exercise 2, wrong: a mean
# says: that is the *mean* over the pairs; the weights p(x, y) are in the sum already, so add them up
def bits_in(joint):
    both = np.outer(joint.sum(axis=1), joint.sum(axis=0))
    terms = np.zeros(joint.shape)
    some = joint > 0
    terms[some] = joint[some] * np.log2(joint[some] / both[some])
    return terms.mean()


# %% exercise 2, wrong: a mean of those that occur
# says: that is the mean over the pairs that occur; the weights p(x, y) are in the sum already
def bits_in(joint):
    both = np.outer(joint.sum(axis=1), joint.sum(axis=0))
    some = joint > 0
    return np.mean(joint[some] * np.log2(joint[some] / both[some]))


# %% exercise 2, wrong: return in the loop
# says: only the first row is added up: does the `return` stand inside the loop?
def bits_in(joint):
    total = 0.0
    for x in range(joint.shape[0]):
        for y in range(joint.shape[1]):
            if joint[x, y] > 0:
                total += joint[x, y] * math.log2(joint[x, y] / (joint[x].sum() * joint[:, y].sum()))
        return total


# %% exercise 2, wrong: return in both loops
# says: the first pair alone: does the `return` stand inside the loops?
def bits_in(joint):
    total = 0.0
    for x in range(joint.shape[0]):
        for y in range(joint.shape[1]):
            if joint[x, y] > 0:
                total += joint[x, y] * math.log2(joint[x, y] / (joint[x].sum() * joint[:, y].sum()))
            return total


# %% exercise 2, wrong: the last row is left out
# says: the last row is missing in the sum
def bits_in(joint):
    total = 0.0
    for x in range(joint.shape[0] - 1):
        for y in range(joint.shape[1]):
            if joint[x, y] > 0:
                total += joint[x, y] * math.log2(joint[x, y] / (joint[x].sum() * joint[:, y].sum()))
    return total


# %% exercise 2, wrong: no logarithm
# says: the logarithm is missing
def bits_in(joint):
    return np.sum(joint * joint / np.outer(joint.sum(axis=1), joint.sum(axis=0)))


# %% exercise 2, wrong: only the right words
# says: only the diagonal is added up; a word that names another need counts too
def bits_in(joint):
    total = 0.0
    for k in range(min(joint.shape)):
        if joint[k, k] > 0:
            total += joint[k, k] * math.log2(joint[k, k] / (joint[k].sum() * joint[:, k].sum()))
    return total


# %% exercise 2, wrong: always four by four
# says: raises IndexError
def bits_in(joint):
    total = 0.0
    for x in range(4):
        for y in range(4):
            if joint[x, y] > 0:
                total += joint[x, y] * math.log2(joint[x, y] / (joint[x].sum() * joint[:, y].sum()))
    return total


# %% exercise 2, wrong: rows and columns changed
# says: none of the usual mistakes
def bits_in(joint):
    total = 0.0
    for x in range(joint.shape[0]):
        for y in range(joint.shape[1]):
            if joint[x, y] > 0:
                total += joint[x, y] * math.log2(joint[x, y] / (joint[x].sum() * joint.sum()))
    return total + 1


# %% exercise 2, wrong: it changes the table
# says: bits_in changes the table that it is given: work with a copy, or with new variables
def bits_in(joint):
    joint /= joint.sum(axis=0)
    return np.sum(joint)


# %% exercise 2, wrong: a number
# says: should be a function
bits_in = 2.0


# %% exercise 2, wrong: an array
# says: take an entry of it
def bits_in(joint):
    return joint * np.log2(np.maximum(joint, 1e-9))


# %% exercise 2, wrong: rounded
# says: do not round it
def bits_in(joint):
    total = 0.0
    for x in range(joint.shape[0]):
        for y in range(joint.shape[1]):
            if joint[x, y] > 0:
                total += joint[x, y] * math.log2(joint[x, y] / (joint[x].sum() * joint[:, y].sum()))
    return round(total, 3)


# %% exercise 2, wrong: what is open about y
# says: that is what is still open about y when x is known; the information is what the message has told
def bits_in(joint):
    open_still = 0.0
    for row in joint:
        for p in row:
            if p > 0:
                open_still -= p * math.log2(p / row.sum())
    return open_still


# %% exercise 2, wrong: both ways
# says: that is twice the information
def bits_in(joint):
    p_x, p_y = joint.sum(axis=1), joint.sum(axis=0)
    total = 0.0
    for x in range(0, len(p_x)):
        for y in range(len(p_y)):
            if joint[x, y] > 0:
                total += joint[x, y] * math.log2(joint[x, y] / (p_x[x] * p_y[y]))
    return 2 * total


# %% exercise 2, wrong: from 1 on
# says: the first row is missing in the sum: indices begin with 0
def bits_in(joint):
    p_x, p_y = joint.sum(axis=1), joint.sum(axis=0)
    total = 0.0
    for x in range(1, len(p_x)):
        for y in range(len(p_y)):
            if joint[x, y] > 0:
                total += joint[x, y] * math.log2(joint[x, y] / (p_x[x] * p_y[y]))
    return total


# %% exercise 2, wrong: two bits less what is open
# says: that is 2 bits less the rest; the needs need not be equally likely, and there may be other than four
def bits_in(joint):
    total = 2.0
    for column in joint.T:
        for p in column:
            if p > 0:
                total += p * math.log2(p / column.sum())
    return total


# %% exercise 3, right: with synonyms in a list
# says: Right: message and memory together. See it race:
def act(self, observation, rng):
    votes = np.zeros(4)
    for word in observation[1:]:
        votes[word % 4] += 1
    if self.last[0] != -1:
        votes[self.last[0]] = -1
    self.last[0] = pick(votes, rng)
    return self.last[0]


# %% exercise 3, right: minus infinity
def act(self, observation, rng):
    votes = np.zeros(4)
    for k in range(1, len(observation)):
        votes[int(observation[k]) % 4] += 1.0
    if self.last[0] > -1:
        votes[self.last[0]] = -np.inf
    action = pick(votes, rng)
    self.last[0] = action
    return int(action)


# %% exercise 3, right: it counts need by need
def act(self, observation, rng):
    votes = np.zeros(4)
    for need in range(4):
        for k in range(1, len(observation)):
            if observation[k] % 4 == need:
                votes[need] += 1.0
        if need == self.last[0]:
            votes[need] = -1.0
    action = pick(votes, rng)
    self.last[0] = action
    return action


# %% exercise 3, right: far below
def act(self, observation, rng):
    votes = np.zeros(4)
    for k in range(len(observation) - 1):
        votes[observation[k + 1] % 4] += 1.0
    if self.last[0] >= 0:
        votes[self.last[0]] -= 1000.0
    best = pick(votes, rng)
    self.last[0] = best
    return best


# %% exercise 3, right: a while loop
def act(self, observation, rng):
    votes = np.zeros(4)
    k = 1
    while k < len(observation):
        need = observation[k]
        while need >= 4:
            need -= 4
        votes[need] += 1.0
        k += 1
    if self.last[0] >= 0:
        votes[self.last[0]] = -1.0
    self.last[0] = pick(votes, rng)
    return self.last[0]


# %% exercise 3, right: it draws until it fits
def act(self, observation, rng):
    votes = np.zeros(4)
    for k in range(1, len(observation)):
        votes[observation[k] % 4] += 1.0
    most = -1.0
    for need in range(4):
        if need != self.last[0] and votes[need] > most:
            most = votes[need]
    while True:
        action = int(rng.random() * 4)
        if action != self.last[0] and votes[action] == most:
            self.last[0] = action
            return action


# %% exercise 3, right: bincount
def act(self, observation, rng):
    votes = np.bincount(observation[1:] % 4, minlength=4).astype(float)
    if self.last[0] >= 0:
        votes[self.last[0]] = -1
    self.last[0] = pick(votes, rng)
    return self.last[0]


# %% exercise 3, right: choice among the best
def act(self, observation, rng):
    votes = np.zeros(4)
    for word in observation[1:]:
        votes[word % 4] += 1
    if self.last[0] != -1:
        votes[self.last[0]] = -np.inf
    best = np.flatnonzero(votes == votes.max())
    self.last[0] = rng.choice(best)
    return int(self.last[0])


# %% exercise 3, right: a list for the votes
def act(self, observation, rng):
    votes = [0, 0, 0, 0]
    for word in observation[1:]:
        votes[word % 4] += 1
    if self.last[0] != -1:
        votes[self.last[0]] = -1
    self.last[0] = pick(votes, rng)
    return int(self.last[0])


# %% exercise 3, wrong: the last action from the message
# says: , which is none of the usual mistakes
# says: where self.last[0] =
def act(self, observation, rng):
    votes = np.zeros(4)
    for k in range(1, len(observation)):
        votes[observation[k] % 4] += 1.0
    votes[observation[1] % 4] = -1.0
    action = pick(votes, rng)
    self.last[0] = action
    return action


# %% exercise 3, wrong: a truth value as an action
# says: should give the number of an action
def act(self, observation, rng):
    votes = np.zeros(4)
    for k in range(1, len(observation)):
        votes[observation[k] % 4] += 1.0
    if self.last[0] >= 0:
        votes[self.last[0]] = -1.0
    self.last[0] = pick(votes, rng)
    return votes


# %% exercise 3, wrong: the word itself
# says: should give an action from 0 to 3
def act(self, observation, rng):
    word = observation[1]
    self.last[0] = word
    return int(word)


# %% exercise 3, wrong: nothing
# says: Not solved yet
def act(self, observation, rng):
    raise NotImplementedError


# %% exercise 3, wrong: the vote alone
# says: that is the vote alone; the action that was taken last should be left out
def act(self, observation, rng):
    votes = np.zeros(4)
    for k in range(1, len(observation)):
        votes[observation[k] % 4] += 1.0
    action = pick(votes, rng)
    self.last[0] = action
    return action


# %% exercise 3, wrong: the hit points vote
# says: the hit points are counted as a word; the words begin with observation[1]
def act(self, observation, rng):
    votes = np.zeros(4)
    for k in range(len(observation)):
        votes[observation[k] % 4] += 1.0
    if self.last[0] >= 0:
        votes[self.last[0]] = -1.0
    action = pick(votes, rng)
    self.last[0] = action
    return action


# %% exercise 3, wrong: the last word is lost
# says: the last word is left out; range(1, len(observation)) goes through all of them
def act(self, observation, rng):
    votes = np.zeros(4)
    for k in range(1, len(observation) - 1):
        votes[observation[k] % 4] += 1.0
    if self.last[0] >= 0:
        votes[self.last[0]] = -1.0
    action = pick(votes, rng)
    self.last[0] = action
    return action


# %% exercise 3, wrong: only the first word
# says: only the first word is heard
def act(self, observation, rng):
    votes = np.zeros(4)
    votes[observation[1] % 4] += 1.0
    if self.last[0] >= 0:
        votes[self.last[0]] = -1.0
    action = pick(votes, rng)
    self.last[0] = action
    return action


# %% exercise 3, wrong: the loop overwrites
# says: only the last word is heard; is something overwritten in the loop?
def act(self, observation, rng):
    for k in range(1, len(observation)):
        votes = np.zeros(4)
        votes[observation[k] % 4] += 1.0
    if self.last[0] >= 0:
        votes[self.last[0]] = -1.0
    action = pick(votes, rng)
    self.last[0] = action
    return action


# %% exercise 3, wrong: no synonyms
# says: raises IndexError
def act(self, observation, rng):
    votes = np.zeros(4)
    for k in range(1, len(observation)):
        votes[observation[k]] += 1.0
    if self.last[0] >= 0:
        votes[self.last[0]] = -1.0
    action = pick(votes, rng)
    self.last[0] = action
    return action


# %% exercise 3, wrong: synonyms are not counted
# says: words from 4 on are not counted: word k names need k % 4
def act(self, observation, rng):
    votes = np.zeros(4)
    for need in range(4):
        votes[need] = np.sum(observation[1:] == need)
    if self.last[0] >= 0:
        votes[self.last[0]] = -1.0
    action = pick(votes, rng)
    self.last[0] = action
    return action


# %% exercise 3, wrong: no votes for the last action
# says: the last action gets no votes, but it can still win where all others have none; give it -1
def act(self, observation, rng):
    votes = np.zeros(4)
    for k in range(1, len(observation)):
        votes[observation[k] % 4] += 1.0
    if self.last[0] >= 0:
        votes[self.last[0]] = 0.0
    action = pick(votes, rng)
    self.last[0] = action
    return action


# %% exercise 3, wrong: one vote less
# says: the last action loses one vote only; it should never be taken
def act(self, observation, rng):
    votes = np.zeros(4)
    for k in range(1, len(observation)):
        votes[observation[k] % 4] += 1.0
    if self.last[0] >= 0:
        votes[self.last[0]] -= 1.0
    action = pick(votes, rng)
    self.last[0] = action
    return action


# %% exercise 3, wrong: -1 as an index
# says: -1 is no action but says that nothing was done yet, and as an index it is the last entry
def act(self, observation, rng):
    votes = np.zeros(4)
    for k in range(1, len(observation)):
        votes[observation[k] % 4] += 1.0
    votes[self.last[0]] = -1.0
    action = pick(votes, rng)
    self.last[0] = action
    return action


# %% exercise 3, wrong: action 0 is nothing
# says: action 0 may have been the last one too: compare self.last[0] with -1, or with >= 0
def act(self, observation, rng):
    votes = np.zeros(4)
    for k in range(1, len(observation)):
        votes[observation[k] % 4] += 1.0
    if self.last[0]:
        if self.last[0] > 0:
            votes[self.last[0]] = -1.0
    action = pick(votes, rng)
    self.last[0] = action
    return action


# %% exercise 3, wrong: argmax
# says: ties should be broken at random, and it takes the first of equals: call pick(votes, rng)
def act(self, observation, rng):
    votes = np.zeros(4)
    for k in range(1, len(observation)):
        votes[observation[k] % 4] += 1.0
    if self.last[0] >= 0:
        votes[self.last[0]] = -1.0
    action = int(np.argmax(votes))
    self.last[0] = action
    return action


# %% exercise 3, wrong: argmax of the vote
# says: it takes the first of equals, and does not leave the last action out
def act(self, observation, rng):
    votes = np.zeros(4)
    for k in range(1, len(observation)):
        votes[observation[k] % 4] += 1.0
    action = int(np.argmax(votes))
    self.last[0] = action
    return action


# %% exercise 3, wrong: it forgets
# says: : write the action into it before you return
# says: , but self.last[0] is still
def act(self, observation, rng):
    votes = np.zeros(4)
    for k in range(1, len(observation)):
        votes[observation[k] % 4] += 1.0
    if self.last[0] >= 0:
        votes[self.last[0]] = -1.0
    return pick(votes, rng)


# %% exercise 3, wrong: it remembers another one
# says: , self.last[0] should be
def act(self, observation, rng):
    votes = np.zeros(4)
    for k in range(1, len(observation)):
        votes[observation[k] % 4] += 1.0
    if self.last[0] >= 0:
        votes[self.last[0]] = -1.0
    action = pick(votes, rng)
    self.last[0] = (action + 1) % 4
    return action


# %% exercise 3, wrong: no return
# says: is a `return` missing?
def act(self, observation, rng):
    votes = np.zeros(4)
    for k in range(1, len(observation)):
        votes[observation[k] % 4] += 1.0
    if self.last[0] >= 0:
        votes[self.last[0]] = -1.0
    self.last[0] = pick(votes, rng)


# %% exercise 3, wrong: the field itself
# says: the fields of a NamedTuple are fixed
def act(self, observation, rng):
    votes = np.zeros(4)
    for k in range(1, len(observation)):
        votes[observation[k] % 4] += 1.0
    if self.last[0] >= 0:
        votes[self.last[0]] = -1.0
    self.last = pick(votes, rng)
    return self.last


# %% exercise 3, wrong: the fewest words
# says: it takes the need with the *fewest* words
def act(self, observation, rng):
    votes = np.zeros(4)
    for k in range(1, len(observation)):
        votes[observation[k] % 4] -= 1.0
    if self.last[0] >= 0:
        votes[self.last[0]] = -1000.0
    action = pick(votes, rng)
    self.last[0] = action
    return action


# %% exercise 3, wrong: in turn
# says: it takes the actions in turn and does not listen
def act(self, observation, rng):
    self.last[0] = (self.last[0] + 1) % 4
    return int(self.last[0])


# %% exercise 3, wrong: any other one
# says: where the last action has most votes, it takes any other; it should take the one with most words among them
def act(self, observation, rng):
    votes = np.zeros(4)
    for k in range(1, len(observation)):
        votes[observation[k] % 4] += 1.0
    action = pick(votes, rng)
    if action == self.last[0]:
        action = (action + 1 + int(rng.random() * 3)) % 4
    self.last[0] = action
    return action


# %% exercise 3, wrong: its own random numbers
# says: does not draw its random numbers from `rng`
def act(self, observation, rng):
    votes = np.zeros(4)
    for k in range(1, len(observation)):
        votes[observation[k] % 4] += 1.0
    if self.last[0] >= 0:
        votes[self.last[0]] = -1.0
    best = np.flatnonzero(votes == votes.max())
    action = int(np.random.default_rng().choice(best))
    self.last[0] = action
    return action


# %% exercise 3, wrong: without self
# says: write `self.` before a field
def act(self, observation, rng):
    votes = np.zeros(4)
    for k in range(1, len(observation)):
        votes[observation[k] % 4] += 1.0
    if last[0] >= 0:
        votes[last[0]] = -1.0
    self.last[0] = pick(votes, rng)
    return self.last[0]


# %% exercise 3, wrong: the words are written over
# says: changes the observation that it is given: only read it, or copy it first
def act(self, observation, rng):
    observation[1:] %= 4
    votes = np.zeros(4)
    for k in range(1, len(observation)):
        votes[observation[k]] += 1.0
    if self.last[0] >= 0:
        votes[self.last[0]] = -1.0
    action = pick(votes, rng)
    self.last[0] = action
    return action


# %% exercise 3, wrong: one array for all
# says: two players share one array `last`: make a new one in every call of `create`
shared = np.array([-1])


class Listener(NamedTuple):
    last: np.ndarray

    def act(self, observation, rng):
        votes = np.zeros(4)
        for word in observation[1:]:
            votes[word % 4] += 1.0
        if self.last[0] >= 0:
            votes[self.last[0]] = -1.0
        self.last[0] = pick(votes, rng)
        return self.last[0]

    def learn(self):
        pass

    @classmethod
    def create(cls, environment):
        return cls(shared)


# %% exercise 3, wrong: from the second word on
# says: the first word is left out; the words begin with observation[1]
def act(self, observation, rng):
    votes = np.zeros(4)
    for k in range(2, len(observation)):
        votes[observation[k] % 4] += 1.0
    if self.last[0] >= 0:
        votes[self.last[0]] = -1.0
    self.last[0] = pick(votes, rng)
    return self.last[0]


# %% exercise 3, wrong: the last of equals
# says: ties should be broken at random, and it takes the last of equals: call pick(votes, rng)
def act(self, observation, rng):
    votes = np.zeros(4)
    for k in range(1, len(observation)):
        votes[observation[k] % 4] += 1.0
    if self.last[0] >= 0:
        votes[self.last[0]] = -1.0
    self.last[0] = np.flatnonzero(votes == votes.max())[-1]
    return self.last[0]


# %% exercise 3, wrong: the hit points, and no memory
# says: the hit points are counted as a word, and the last action is not left out
def act(self, observation, rng):
    votes = np.zeros(4)
    for k in range(0, len(observation)):
        votes[observation[k] % 4] += 1.0
    self.last[0] = -1
    self.last[0] = pick(votes, rng)
    return self.last[0]
