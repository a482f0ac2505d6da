# %% the answer of the lesson's novelty agent
# says: `tries` does not count
def learn(self, state, action, reward, next_state, terminated):
    self.visits[next_state] += 1
    reward_and_bonus = reward + self.bonus / np.sqrt(self.visits[next_state])
    target = reward_and_bonus if terminated else reward_and_bonus + self.discount * max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% a visit is noted, not counted
# slow
# says: `visits` is set to 1 there
# says: ` is set to 1 there, and it should become one more: write `+= 1`
def learn(self, state, action, reward, next_state, terminated):
    self.tries[state, action] += 1
    self.visits[next_state] = 1


# %% counted down
# slow
# says: `tries` changes by -1 there
# says: there, and every time it should be one more
def learn(self, state, action, reward, next_state, terminated):
    self.visits[next_state] += 1
    self.tries[state, action] -= 1


# %% the state that was left
# says: it counts the state that was left; count the one that was *entered*, next_state
def learn(self, state, action, reward, next_state, terminated):
    self.tries[state, action] += 1
    self.visits[state] += 1
    value = 0.0 if terminated else max(self.Q[next_state])
    target = reward + self.bonus / self.visits[state] ** 0.5 + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% counted too late
# says: the bonus comes from the old count: count first, so that a first visit has n = 1
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state])
    target = reward + self.bonus / self.visits[next_state] ** 0.5 + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])
    self.tries[state, action] += 1
    self.visits[next_state] += 1


# %% one visit too many
# says: the bonus is β/√(n + 1), one visit too many
def learn(self, state, action, reward, next_state, terminated):
    self.tries[state, action] += 1
    self.visits[next_state] += 1
    value = 0.0 if terminated else max(self.Q[next_state])
    target = reward + self.bonus / (self.visits[next_state] + 1) ** 0.5 + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% no root
# says: the root is missing: the bonus is β/√n
def learn(self, state, action, reward, next_state, terminated):
    self.tries[state, action] += 1
    self.visits[next_state] += 1
    value = 0.0 if terminated else max(self.Q[next_state])
    target = reward + self.bonus / self.visits[next_state] + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% self forgotten
# says: write `self.` before a field
def learn(self, state, action, reward, next_state, terminated):
    visits[next_state] += 1


# %% act always greedy
# says: a grip that was never tried comes first, whatever Q says of it
# says: act(state, rng), where state = 0, tries[0] = [3, 0]
def act(self, state, rng):
    return self.greedy(state, rng)


# %% act slips
# says: it still explores, with an ε near 0.1
def act(self, state, rng):
    if rng.random() < 0.1:
        return int(rng.random() * self.Q.shape[1])
    for action in range(self.Q.shape[1]):
        if self.tries[state, action] == 0:
            return action
    return self.greedy(state, rng)


# %% act at random
# says: act(state, rng)
# says: it acts at random
def act(self, state, rng):
    return int(rng.random() * self.Q.shape[1])


# %% always the least tried
# says: once all grips were tried the *best* one counts, and it takes the one that was tried least
# says: act(state, rng), where state = 3
def act(self, state, rng):
    return int(np.argmin(self.tries[state]))


# %% act counts
# says: changes the table `tries`
def act(self, state, rng):
    best = self.greedy(state, rng)
    for action in range(self.Q.shape[1]):
        if self.tries[state, action] == 0:
            best = action
    self.tries[state, best] += 1
    return best


# %% an instance for the class
# says: should be the class
MyExplorer = QLearning.create((4, 2))


# %% Go-Explore under another name
# says: should keep its field `bonus`
class MyExplorer(NamedTuple):
    Q: np.ndarray

    @classmethod
    def create(cls, wall):
        return QLearning.create(wall)


# %% precedence of the root
# says: `** 1 / 2` is `(... ** 1) / 2`: write `** 0.5` for the root
def learn(self, state, action, reward, next_state, terminated):
    self.tries[state, action] += 1
    self.visits[next_state] += 1
    v = 0.0 if terminated else max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (
        reward + self.bonus / self.visits[next_state] ** 1 / 2 + self.discount * v - self.Q[state, action]
    )


# %% the bonus under the discount
# says: the bonus is discounted; γ belongs to the value of the next state only
def learn(self, state, action, reward, next_state, terminated):
    self.tries[state, action] += 1
    self.visits[next_state] += 1
    v = 0.0 if terminated else max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (
        reward + self.discount * (self.bonus / self.visits[next_state] ** 0.5 + v) - self.Q[state, action]
    )


# %% the whole row learns
# slow
# says: 2 entries of `Q` change, and only one should
def learn(self, state, action, reward, next_state, terminated):
    self.tries[state, action] += 1
    self.visits[next_state] += 1
    v = 0.0 if terminated else max(self.Q[next_state])
    self.Q[state] += self.learning_rate * (
        reward + self.bonus / self.visits[next_state] ** 0.5 + self.discount * v - self.Q[state]
    )


# %% counts the visit after it has divided
# says: the bonus comes from the old count, or from 1 at the first visit: count before you divide
def learn(self, state, action, reward, next_state, terminated):
    n = max(1, self.visits[next_state])  # not by zero
    target = reward + self.bonus / np.sqrt(n)
    if not terminated:
        target += self.discount * max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])
    self.visits[next_state] += 1
    self.tries[state, action] += 1


# %% one untried grip at most, by item
# says: `return int(np.where(self.tries[state] == 0)[0].item())` raises ValueError
def act(self, state, rng):
    if (self.tries[state] == 0).any():
        return int(np.where(self.tries[state] == 0)[0].item())
    return self.greedy(state, rng)


# %% only where one grip is left
# says: , rng), where tries[
# says: should choose a grip that was never tried, but chooses 0
def act(self, state, rng):
    if sum(self.tries[state] == 0) == 1:
        return int(self.tries[state].argmin())
    return self.greedy(state, rng)


# %% the count of the wrong state
# says: `visits` counts the state that was left; count the one that was *entered*, next_state
def learn(self, state, action, reward, next_state, terminated):
    self.visits[state] += 1
    self.tries[state, action] += 1
    bonus = self.bonus / max(self.visits[next_state], 0) ** 0.5
    future = 0.0 if terminated else self.discount * self.Q[next_state].max()
    self.Q[state, action] += self.learning_rate * (reward + bonus + future - self.Q[state, action])


# %% the bonus of the wrong state
# says: the bonus is that of the state that was left; it belongs to the one that was *entered*, next_state
def learn(self, state, action, reward, next_state, terminated):
    self.visits[next_state] += 1
    self.tries[state, action] += 1
    bonus = self.bonus / np.sqrt(self.visits[state])
    future = 0.0 if terminated else self.discount * self.Q[next_state].max()
    self.Q[state, action] += self.learning_rate * (reward + bonus + future - self.Q[state, action])


# %% the bonus of the action
# says: the bonus is computed from the number of tries of the action, n(s, a), and it should come from visits, n(s')
def learn(self, state, action, reward, next_state, terminated):
    self.visits[next_state] += 1
    self.tries[state, action] += 1
    bonus = self.bonus / np.sqrt(self.tries[state, action])
    future = 0.0 if terminated else self.discount * self.Q[next_state].max()
    self.Q[state, action] += self.learning_rate * (reward + bonus + future - self.Q[state, action])


# %% no count of states
# says: `visits` does not count
def learn(self, state, action, reward, next_state, terminated):
    self.tries[state, action] += 1
    bonus = self.bonus / np.sqrt(self.visits[next_state])
    future = 0.0 if terminated else self.discount * self.Q[next_state].max()
    self.Q[state, action] += self.learning_rate * (reward + bonus + future - self.Q[state, action])


# %% the last step is not counted
# slow
# says: `tries` does not change there, and every time it should be one more
def learn(self, state, action, reward, next_state, terminated):
    self.visits[next_state] += 1
    if not terminated:
        self.tries[state, action] += 1
    target = reward + self.bonus / np.sqrt(self.visits[next_state])
    if not terminated:
        target += self.discount * self.Q[next_state].max()
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% tries of the next state
# says: `tries` counts next_state; count the state in which the action was *taken*
def learn(self, state, action, reward, next_state, terminated):
    self.visits[next_state] += 1
    self.tries[next_state, action] += 1
    bonus = self.bonus / np.sqrt(self.visits[next_state])
    future = 0.0 if terminated else self.discount * self.Q[next_state].max()
    self.Q[state, action] += self.learning_rate * (reward + bonus + future - self.Q[state, action])


# %% indices exchanged
# says: state and action have changed places in `tries`
def learn(self, state, action, reward, next_state, terminated):
    self.visits[next_state] += 1
    self.tries[action % len(self.tries), state % self.tries.shape[1]] += 1
    bonus = self.bonus / np.sqrt(self.visits[next_state])
    future = 0.0 if terminated else self.discount * self.Q[next_state].max()
    self.Q[state, action] += self.learning_rate * (reward + bonus + future - self.Q[state, action])


# %% all is discounted
# says: the whole target is discounted; γ belongs to the value of the next state only
def learn(self, state, action, reward, next_state, terminated):
    self.visits[next_state] += 1
    self.tries[state, action] += 1
    bonus = self.bonus / np.sqrt(self.visits[next_state])
    future = 0.0 if terminated else self.Q[next_state].max()
    self.Q[state, action] += self.learning_rate * (self.discount * (reward + bonus + future) - self.Q[state, action])


# %% times the root
# says: the bonus grows with the count: it is β *divided* by √n
def learn(self, state, action, reward, next_state, terminated):
    self.visits[next_state] += 1
    self.tries[state, action] += 1
    bonus = self.bonus * np.sqrt(self.visits[next_state])
    future = 0.0 if terminated else self.discount * self.Q[next_state].max()
    self.Q[state, action] += self.learning_rate * (reward + bonus + future - self.Q[state, action])


# %% always the same bonus
# says: the bonus does not fade with the count: it is β/√n
def learn(self, state, action, reward, next_state, terminated):
    self.visits[next_state] += 1
    self.tries[state, action] += 1
    bonus = self.bonus
    future = 0.0 if terminated else self.discount * self.Q[next_state].max()
    self.Q[state, action] += self.learning_rate * (reward + bonus + future - self.Q[state, action])


# %% for the first visit
# says: only the first visit earns a bonus; every visit earns β/√n
def learn(self, state, action, reward, next_state, terminated):
    self.visits[next_state] += 1
    self.tries[state, action] += 1
    bonus = self.bonus if self.visits[next_state] == 1 else 0.0
    future = 0.0 if terminated else self.discount * self.Q[next_state].max()
    self.Q[state, action] += self.learning_rate * (reward + bonus + future - self.Q[state, action])


# %% a penalty
# says: the bonus is subtracted
def learn(self, state, action, reward, next_state, terminated):
    self.visits[next_state] += 1
    self.tries[state, action] += 1
    bonus = self.bonus / np.sqrt(self.visits[next_state])
    future = 0.0 if terminated else self.discount * self.Q[next_state].max()
    self.Q[state, action] += self.learning_rate * (reward - bonus + future - self.Q[state, action])


# %% no bonus
# says: the bonus is missing
def learn(self, state, action, reward, next_state, terminated):
    self.visits[next_state] += 1
    self.tries[state, action] += 1
    bonus = self.bonus / np.sqrt(self.visits[next_state])
    future = 0.0 if terminated else self.discount * self.Q[next_state].max()
    self.Q[state, action] += self.learning_rate * (reward + future - self.Q[state, action])


# %% no bonus at the end
# says: at the end of an episode the bonus is lost: only the *value of the next state* is 0 there
def learn(self, state, action, reward, next_state, terminated):
    self.visits[next_state] += 1
    self.tries[state, action] += 1
    bonus = 0.0 if terminated else self.bonus / np.sqrt(self.visits[next_state])
    future = 0.0 if terminated else self.discount * self.Q[next_state].max()
    self.Q[state, action] += self.learning_rate * (reward + bonus + future - self.Q[state, action])


# %% the worst once all are tried
# says: once all grips were tried the best one counts, and it takes the worst
def act(self, state, rng):
    untried = np.flatnonzero(self.tries[state] == 0)
    if len(untried):
        return int(untried[0])
    worst = np.flatnonzero(self.Q[state] == self.Q[state].min())
    return int(rng.choice(worst))


# %% the last of equals
# says: ties should be broken at random, and it takes the last of equals
def act(self, state, rng):
    untried = np.flatnonzero(self.tries[state] == 0)
    if len(untried):
        return int(untried[0])
    return int(np.flatnonzero(self.Q[state] == self.Q[state].max())[-1])


# %% the bonus under the root
# says: β stands under the root, √(β/n): only n does, β/√n
def learn(self, state, action, reward, next_state, terminated):
    self.tries[state, action] += 1
    self.visits[next_state] += 1
    value = 0.0 if terminated else max(self.Q[next_state])
    target = reward + (self.bonus / self.visits[next_state]) ** 0.5 + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% the bonus outside the brackets
# says: the bonus is added outside the brackets: it is part of the target, of which α is taken
def learn(self, state, action, reward, next_state, terminated):
    self.tries[state, action] += 1
    self.visits[next_state] += 1
    value = 0.0 if terminated else max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])
    self.Q[state, action] += self.bonus / self.visits[next_state] ** 0.5


# %% tried once is not yet tried
# says: a grip that was tried once is tried: only those count that were tried 0 times
def act(self, state, rng):
    for action in range(self.Q.shape[1]):
        if self.tries[state, action] <= 1:
            return action
    return self.greedy(state, rng)


# %% the comparison in place of the grip
# says: : np.flatnonzero(...) gives the indices at which a comparison is true
def act(self, state, rng):
    untried = self.tries[state] == 0
    return rng.choice(untried) if untried.any() else self.greedy(state, rng)


# %% a softmax once all were tried
# says: , by chance where one action is right: it sees a tie where there is none, or it explores, or it draws in proportion to something
def act(self, state, rng):
    new = np.flatnonzero(self.tries[state] == 0)
    if len(new):
        return int(rng.choice(new))
    p = np.exp(self.Q[state])
    return int(rng.choice(len(p), p=p / p.sum()))


# %% tried once is not tried
# says: , by chance where one action is right
def act(self, state, rng):
    new = np.flatnonzero(self.tries[state] < 2)
    if len(new):
        return int(rng.choice(new))
    q = self.Q[state]
    return int(rng.choice(np.flatnonzero(q == q.max())))


# %% leaves the loop at once
# says: the last grip is never tried: does the loop end before it (`range(n)` goes to n − 1 already), or return too early, as in an `else` inside of it?
def act(self, state, rng):
    for action in range(self.Q.shape[1]):
        if self.tries[state, action] == 0:
            return action
        else:
            return self.greedy(state, rng)


# %% the loop begins at 1
# says: grip 0 is never tried: a loop over `range(n)` begins with it
def act(self, state, rng):
    for action in range(1, self.Q.shape[1]):
        if self.tries[state, action] == 0:
            return action
    return self.greedy(state, rng)


# %% a grip that was tried
# says: it takes a grip that *was* tried: is the test of `tries` the wrong way round?
def act(self, state, rng):
    for action in range(self.Q.shape[1]):
        if self.tries[state, action]:
            return action
    return self.greedy(state, rng)


# %% the bonus beside the value
# says: the bonus stands beside the value of the next state, so it is discounted, and lost at the end: it belongs to the reward
def learn(self, state, action, reward, next_state, terminated):
    self.tries[state, action] += 1
    self.visits[next_state] += 1
    future = max(self.Q[next_state]) + self.bonus / np.sqrt(self.visits[next_state])
    target = reward if terminated else reward + self.discount * future
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])
