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
