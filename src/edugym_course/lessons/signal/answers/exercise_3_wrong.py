# %% the last action from the message
# says: act(observation, rng)
# says: where observation =
# says: of calls, but that is the one that was taken last: it should not be taken again, however many words name it
# says: and self.last[0] =
# in: the solution of act
# - if self.last[0] >= 0:
# -     votes[self.last[0]] = -100.0
# + votes[observation[1] % 4] = -1.0


# %% the vote alone
# says: that is the vote alone; the action that was taken last should be left out
# in: the solution of act
# - if self.last[0] >= 0:
# -     votes[self.last[0]] = -100.0


# %% the hit points vote
# says: the hit points are counted as a word; the words begin with observation[1]
# in: the solution of act
# - for k in range(1, len(observation)):
# + for k in range(len(observation)):
# - votes[self.last[0]] = -100.0
# + votes[self.last[0]] = -1.0


# %% the last word is lost
# says: the last word is left out; range(1, len(observation)) goes through all of them
# in: the solution of act
# - for k in range(1, len(observation)):
# + for k in range(1, len(observation) - 1):
# - votes[self.last[0]] = -100.0
# + votes[self.last[0]] = -1.0


# %% only the first word
# says: only the first word is heard
def act(self, observation, rng):
    votes = np.zeros(4)
    votes[observation[1] % 4] += 1.0
    if self.last[0] >= 0:
        votes[self.last[0]] = -1.0
    action = pick(votes, rng)
    self.last[0] = action
    return action


# %% the loop overwrites
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


# %% synonyms are not counted
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


# %% no votes for the last action
# says: the last action gets no votes, but it can still win where all others have none; give it -100
# in: the solution of act
# - votes[self.last[0]] = -100.0
# + votes[self.last[0]] = 0.0


# %% one vote less
# says: the last action loses one vote only; it should never be taken
# in: the solution of act
# - votes[self.last[0]] = -100.0
# + votes[self.last[0]] -= 1.0


# %% -1 as an index
# says: -1 is no action but says that nothing was done yet, and as an index it is the last entry
# in: the solution of act
# - if self.last[0] >= 0:
# -     votes[self.last[0]] = -100.0
# + votes[self.last[0]] = -1.0


# %% action 0 is nothing
# says: action 0 may have been the last one too: compare self.last[0] with -1, or with >= 0
# in: the solution of act
# - if self.last[0] >= 0:
# -     votes[self.last[0]] = -100.0
# + if self.last[0]:
# +     if self.last[0] > 0:
# +         votes[self.last[0]] = -1.0


# %% argmax
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


# %% argmax of the vote
# says: it takes the first of equals, and does not leave the last action out
def act(self, observation, rng):
    votes = np.zeros(4)
    for k in range(1, len(observation)):
        votes[observation[k] % 4] += 1.0
    action = int(np.argmax(votes))
    self.last[0] = action
    return action


# %% it forgets
# says: : write the action into it before you return
# says: , but self.last[0] is still
def act(self, observation, rng):
    votes = np.zeros(4)
    for k in range(1, len(observation)):
        votes[observation[k] % 4] += 1.0
    if self.last[0] >= 0:
        votes[self.last[0]] = -1.0
    return pick(votes, rng)


# %% it remembers another one
# says: , self.last[0] should be
# in: the solution of act
# - votes[self.last[0]] = -100.0
# + votes[self.last[0]] = -1.0
# - self.last[0] = action
# + self.last[0] = (action + 1) % 4


# %% the fewest words
# says: it takes the need with the *fewest* words
# in: the solution of act
# - votes[observation[k] % 4] += 1.0
# + votes[observation[k] % 4] -= 1.0
# - votes[self.last[0]] = -100.0
# + votes[self.last[0]] = -1000.0


# %% in turn
# says: it takes the actions in turn and does not listen
def act(self, observation, rng):
    self.last[0] = (self.last[0] + 1) % 4
    return int(self.last[0])


# %% any other one
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


# %% without self
# says: write `self.` before a field
def act(self, observation, rng):
    votes = np.zeros(4)
    for k in range(1, len(observation)):
        votes[observation[k] % 4] += 1.0
    if last[0] >= 0:
        votes[last[0]] = -1.0
    self.last[0] = pick(votes, rng)
    return self.last[0]


# %% the words are written over
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


# %% one array for all
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


# %% from the second word on
# says: the first word is left out; the words begin with observation[1]
def act(self, observation, rng):
    votes = np.zeros(4)
    for k in range(2, len(observation)):
        votes[observation[k] % 4] += 1.0
    if self.last[0] >= 0:
        votes[self.last[0]] = -1.0
    self.last[0] = pick(votes, rng)
    return self.last[0]


# %% the last of equals
# says: ties should be broken at random, and it takes the last of equals: call pick(votes, rng)
def act(self, observation, rng):
    votes = np.zeros(4)
    for k in range(1, len(observation)):
        votes[observation[k] % 4] += 1.0
    if self.last[0] >= 0:
        votes[self.last[0]] = -1.0
    self.last[0] = np.flatnonzero(votes == votes.max())[-1]
    return self.last[0]


# %% the hit points, and no memory
# says: the hit points are counted as a word, and the last action is not left out
def act(self, observation, rng):
    votes = np.zeros(4)
    for k in range(0, len(observation)):
        votes[observation[k] % 4] += 1.0
    self.last[0] = -1
    self.last[0] = pick(votes, rng)
    return self.last[0]


# %% the word divided by four
# says: word k names need k % 4, the rest of the division, not k // 4
def act(self, observation, rng):
    votes = np.zeros(4)
    for k in range(1, len(observation)):
        votes[observation[k] // 4] += 1.0
    if self.last[0] >= 0:
        votes[self.last[0]] = -100.0
    self.last[0] = pick(votes, rng)
    return self.last[0]


# %% the next number
# says: where the last action has most votes, it takes the one with the next number; it should take the one with most
#   words among them
def act(self, observation, rng):
    votes = np.zeros(4)
    for i in range(1, len(observation)):
        votes[observation[i] % 4] += 1
    action = pick(votes, rng)
    if action == self.last[0]:
        action = (action + 1) % 4
    self.last[0] = action
    return action


# %% a place in a list
# says: that is the place of the action in a list of the others, and not the action
def act(self, observation, rng):
    others = [a for a in range(4) if a != self.last[0]]
    votes = np.array([sum(word % 4 == a for word in observation[1:]) for a in others])
    self.last[0] = pick(votes, rng)
    return self.last[0]


# %% written before it is left out
# says: `pick` is called twice, and what was picked first is left out: leave the last action out before you pick, and
#   pick once
def act(self, observation, rng):
    votes = np.zeros(4)
    for i in range(1, len(observation)):
        votes[observation[i] % 4] += 1
    self.last[0] = pick(votes, rng)
    votes[self.last[0]] = -100
    self.last[0] = pick(votes, rng)
    return self.last[0]


# %% named or not
# says: a need that is named twice counts once: += 1 instead of = 1
def act(self, observation, rng):
    votes = np.zeros(4)
    for word in observation[1:]:
        votes[word % 4] = 1
    if self.last[0] >= 0:
        votes[self.last[0]] = -100
    self.last[0] = pick(votes, rng)
    return self.last[0]


# %% in proportion
# says: it draws the needs in proportion to their words; it should take one with the most
def act(self, observation, rng):
    votes = np.zeros(4)
    for i in range(1, len(observation)):
        votes[observation[i] % 4] += 1
    if self.last[0] >= 0:
        votes[self.last[0]] = 0
    if votes.sum() == 0:
        votes = np.array([float(a != self.last[0]) for a in range(4)])
    action = int(rng.choice(4, p=votes / votes.sum()))
    self.last[0] = action
    return action


# %% ten votes less
# says: of calls, but that is the one that was taken last: it should not be taken again, however many words name it
# says: , takes action
def act(self, observation, rng):
    votes = np.zeros(4)
    for i in range(1, len(observation)):
        votes[observation[i] % 4] += 1
    if self.last[0] >= 0:
        votes[self.last[0]] -= 10
    self.last[0] = pick(votes, rng)
    return self.last[0]


# %% half the votes
# says: of calls, but that is the one that was taken last: it should not be taken again, however many words name it
def act(self, observation, rng):
    votes = np.zeros(4)
    for i in range(1, len(observation)):
        votes[observation[i] % 4] += 1
    if self.last[0] >= 0:
        votes[self.last[0]] /= 2
    self.last[0] = pick(votes, rng)
    return self.last[0]


# %% remembers the first word
# says: self.last[0] should be
def act(self, observation, rng):
    votes = np.zeros(4)
    for i in range(1, len(observation)):
        votes[observation[i] % 4] += 1
    if self.last[0] >= 0:
        votes[self.last[0]] = -100
    action = pick(votes, rng)
    self.last[0] = observation[1] % 4
    return action


# %% ties go to the next one
# says: , the same action in every call, for it takes no random number from `rng`
def act(self, observation, rng):
    votes = np.zeros(4)
    for i in range(1, len(observation)):
        votes[observation[i] % 4] += 1
    if self.last[0] >= 0:
        votes[self.last[0]] = -100
        votes[(self.last[0] + 1) % 4] += 0.5
    self.last[0] = pick(votes, rng)
    return self.last[0]


# %% the last action is forgotten when all is well
# says: takes action 1 in 100% of calls, but that is the one that was taken last
# in: the solution of act
# - if self.last[0] >= 0:
# + if self.last[0] >= 0 and observation[0] < 100:


# %% every second word
# says: , by chance where one action is right: it sees a tie where there is none
def act(self, observation, rng):
    votes = np.zeros(4)
    for word in observation[1::2]:
        votes[word % 4] += 1
    if self.last[0] >= 0:
        votes[self.last[0]] = -1
    action = pick(votes, rng)
    self.last[0] = action
    return action


# %% two votes less
# says: of calls, but that is the one that was taken last: it should not be taken again, however many words name it
def act(self, observation, rng):
    votes = np.zeros(4)
    for word in observation[1:]:
        votes[word % 4] += 1
    if self.last[0] >= 0:
        votes[self.last[0]] -= 2
    action = pick(votes, rng)
    self.last[0] = action
    return action


# %% words without their need
# says: ; word k names need k % 4, and there are more than four words
def act(self, observation, rng):
    votes = np.zeros(4)
    for word in observation[1:]:
        votes[word] += 1
    if self.last[0] >= 0:
        votes[self.last[0]] = -100
    self.last[0] = pick(votes, rng)
    return self.last[0]


# %% picked for the memory, and for the answer
# says: : is `pick` called twice? Note the action that you return
# in: the solution of act
# - return action
# + return pick(votes, rng)


# %% what has most words is noted
# says: : is another action noted there than the one that you return?
def act(self, observation, rng):
    votes = np.zeros(4)
    for word in observation[1:]:
        votes[word % 4] += 1
    most = pick(votes, rng)
    if self.last[0] >= 0:
        votes[self.last[0]] = -100
    action = pick(votes, rng)
    self.last[0] = most
    return action


# %% picked again and again
# slow
# says: (If `pick` is called until another action comes: where the last action has the most words alone, that never happens. Leave it out of the votes, and pick once.)
def act(self, observation, rng):
    votes = np.zeros(4)
    for word in observation[1:]:
        votes[word % 4] += 1
    action = pick(votes, rng)
    while action == self.last[0]:
        action = pick(votes, rng)
    self.last[0] = action
    return action
