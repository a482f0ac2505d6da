# %% with synonyms in a list
# says: Right: message and memory together. See it race:
def act(self, observation, rng):
    votes = np.zeros(4)
    for word in observation[1:]:
        votes[word % 4] += 1
    if self.last[0] != -1:
        votes[self.last[0]] = -1
    self.last[0] = pick(votes, rng)
    return self.last[0]


# %% minus infinity
def act(self, observation, rng):
    votes = np.zeros(4)
    for k in range(1, len(observation)):
        votes[int(observation[k]) % 4] += 1.0
    if self.last[0] > -1:
        votes[self.last[0]] = -np.inf
    action = pick(votes, rng)
    self.last[0] = action
    return int(action)


# %% it counts need by need
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


# %% far below
def act(self, observation, rng):
    votes = np.zeros(4)
    for k in range(len(observation) - 1):
        votes[observation[k + 1] % 4] += 1.0
    if self.last[0] >= 0:
        votes[self.last[0]] -= 1000.0
    best = pick(votes, rng)
    self.last[0] = best
    return best


# %% a while loop
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


# %% it draws until it fits
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


# %% bincount
def act(self, observation, rng):
    votes = np.bincount(observation[1:] % 4, minlength=4).astype(float)
    if self.last[0] >= 0:
        votes[self.last[0]] = -1
    self.last[0] = pick(votes, rng)
    return self.last[0]


# %% choice among the best
def act(self, observation, rng):
    votes = np.zeros(4)
    for word in observation[1:]:
        votes[word % 4] += 1
    if self.last[0] != -1:
        votes[self.last[0]] = -np.inf
    best = np.flatnonzero(votes == votes.max())
    self.last[0] = rng.choice(best)
    return int(self.last[0])


# %% a list for the votes
def act(self, observation, rng):
    votes = [0, 0, 0, 0]
    for word in observation[1:]:
        votes[word % 4] += 1
    if self.last[0] != -1:
        votes[self.last[0]] = -1
    self.last[0] = pick(votes, rng)
    return int(self.last[0])
