# ruff: noqa
# Right and wrong answers to the exercises of lesson 3; tests/lessons/test_answers.py tries them all.
# An answer stands in the place of the exercise's cell. Methods without their class replace those of the solution.

# %% setup
from functools import partial
from edugym import Greedy, SARSA, Softmax


# %% exercise 1, right: as many days as there are
# says: Right: its targets are made of rewards alone, and it takes no random action. See it race:
def quiet(study):
    return NStepSARSA.create(study, n=10, learning_rate=0.1, discount=1.0, exploration=EpsilonGreedy(0.0))


# %% exercise 1, right: the greedy strategy
def quiet(study):
    return NStepSARSA.create(study, n=math.inf, learning_rate=0.1, discount=1, exploration=Greedy())


# %% exercise 1, right: infinity of NumPy and of float
def quiet(study):
    return NStepSARSA.create(study, n=np.inf, learning_rate=1 / 10, discount=1.0, exploration=EpsilonGreedy(epsilon=0))


# %% exercise 1, right: more steps than there are
def quiet(study):
    return NStepSARSA.create(study, n=1000, learning_rate=0.1, discount=1.0, exploration=EpsilonGreedy(0.0))


# %% exercise 1, right: by the lesson's own maker
quiet = depth.maker(math.inf, epsilon=0.0)


# %% exercise 1, right: partial
quiet = partial(
    NStepSARSA.create, n=float("inf"), learning_rate=0.1, discount=1.0, exploration=EpsilonGreedy(0.0), longest=10
)


# %% exercise 1, right: by _replace
def quiet(study):
    agent = NStepSARSA.create(study, n=math.inf, discount=1.0)
    return agent._replace(exploration=EpsilonGreedy(0.0))


# %% exercise 1, right: settings in a dictionary
settings = {"n": math.inf, "learning_rate": 0.1, "discount": 1.0}
quiet = lambda task: NStepSARSA.create(task, exploration=EpsilonGreedy(0.0), **settings)


# %% exercise 1, wrong: not solved
# says: Not solved yet
def quiet(study):
    raise NotImplementedError("not solved yet: replace this line")


# %% exercise 1, wrong: no return
# says: is a `return` missing?
def quiet(study):
    NStepSARSA.create(study, n=math.inf, learning_rate=0.1, discount=1.0, exploration=EpsilonGreedy(0.0))


# %% exercise 1, wrong: n left out
# says: its targets have 4 rewards
# says: the quiet agent should be that of the experiment, but
def quiet(study):
    return NStepSARSA.create(study, learning_rate=0.1, discount=1.0, exploration=EpsilonGreedy(0.0))


# %% exercise 1, wrong: one step
# says: its targets have 1 reward, and Monte Carlo has n=math.inf
def quiet(study):
    return NStepSARSA.create(study, n=1, learning_rate=0.1, discount=1.0, exploration=EpsilonGreedy(0.0))


# %% exercise 1, wrong: SARSA
# says: its targets have 1 reward
def quiet(study):
    return SARSA.create(study, learning_rate=0.1, discount=1.0, exploration=EpsilonGreedy(0.0))


# %% exercise 1, wrong: nine days
# says: its targets have 9 rewards
def quiet(study):
    return NStepSARSA.create(study, n=9, learning_rate=0.1, discount=1.0, exploration=EpsilonGreedy(0.0))


# %% exercise 1, wrong: too short a memory
# says: its targets have 5 rewards
def quiet(study):
    return NStepSARSA.create(
        study, n=math.inf, longest=5, learning_rate=0.1, discount=1.0, exploration=EpsilonGreedy(0.0)
    )


# %% exercise 1, wrong: discount left out
# says: a discount of 0.99, and it should be 1
# says: it has a discount of
def quiet(study):
    return NStepSARSA.create(study, n=math.inf, learning_rate=0.1, exploration=EpsilonGreedy(0.0))


# %% exercise 1, wrong: another learning rate
# says: a learning rate of 0.01, and it should be 0.1
# says: it has a learning rate of
def quiet(study):
    return NStepSARSA.create(study, n=math.inf, learning_rate=0.01, discount=1.0, exploration=EpsilonGreedy(0.0))


# %% exercise 1, wrong: two settings
# says: a learning rate of 0.5
# says: a discount of 0.9
def quiet(study):
    return NStepSARSA.create(study, n=math.inf, learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0))


# %% exercise 1, wrong: still exploring
# says: ε should be 0, but it is 0.1
# says: the quiet agent never explores, so ε should be 0, but it is
def quiet(study):
    return NStepSARSA.create(study, n=math.inf, learning_rate=0.1, discount=1.0)


# %% exercise 1, wrong: always exploring
# says: ε should be 0, but it is 1
def quiet(study):
    return NStepSARSA.create(study, n=math.inf, learning_rate=0.1, discount=1.0, exploration=EpsilonGreedy(1.0))


# %% exercise 1, wrong: softmax
# says: act(1, rng)
# says: it acts at random
def quiet(study):
    return NStepSARSA.create(study, n=math.inf, learning_rate=0.1, discount=1.0, exploration=Softmax(1.0))


# %% exercise 1, wrong: optimistic values
# says: every value in Q should be 0 at first, but one is 10
def quiet(study):
    return NStepSARSA.create(
        study, n=math.inf, learning_rate=0.1, discount=1.0, exploration=EpsilonGreedy(0.0), initial_value=10.0
    )


# %% exercise 1, wrong: the class
# says: should give an agent, but gives the class NStepSARSA
def quiet(study):
    return NStepSARSA


# %% exercise 1, wrong: called already
# says: quiet should be a function of the task
# says: the task that returns an agent
quiet = (
    NStepSARSA.create(study, n=math.inf, learning_rate=0.1, discount=1.0, exploration=EpsilonGreedy(0.0))
    if "study" in globals()
    else NStepSARSA.create((220, 5), n=math.inf)
)


# %% exercise 1, wrong: one agent for all
# says: two calls of quiet(study) share one table: make a new one in every call
made = NStepSARSA.create((220, 5), n=math.inf, learning_rate=0.1, discount=1.0, exploration=EpsilonGreedy(0.0))


def quiet(study):
    return made


# %% exercise 1, wrong: the task is ignored
# says: should have the shape (220, 2), but has (220, 5)
def quiet(study):
    return NStepSARSA.create((220, 5), n=math.inf, learning_rate=0.1, discount=1.0, exploration=EpsilonGreedy(0.0))


# %% exercise 1, wrong: a setting misspelt
# says: has no setting 'epsilon'
def quiet(study):
    return NStepSARSA.create(study, n=math.inf, learning_rate=0.1, discount=1.0, epsilon=0.0)


# %% exercise 1, wrong: ε for the strategy
# says: exploration must be a strategy
def quiet(study):
    return NStepSARSA.create(study, n=math.inf, learning_rate=0.1, discount=1.0, exploration=0.0)


# %% exercise 1, wrong: n as a text
# says: n must be
def quiet(study):
    return NStepSARSA.create(study, n="inf", learning_rate=0.1, discount=1.0, exploration=EpsilonGreedy(0.0))


# %% exercise 1, wrong: the first of equals
# says: ties should be broken at random, and it takes the first of equals
class First(NStepSARSA):
    __slots__ = ()

    def act(self, state, rng):
        return int(np.flatnonzero(self.Q[state] == self.Q[state].max())[0])


def quiet(study):
    return First.create(study, n=math.inf, learning_rate=0.1, discount=1.0, exploration=EpsilonGreedy(0.0))


# %% exercise 1, wrong: the last of equals
# says: ties should be broken at random, and it takes the last of equals
class Last(NStepSARSA):
    __slots__ = ()

    def act(self, state, rng):
        return int(np.flatnonzero(self.Q[state] == self.Q[state].max())[-1])


def quiet(study):
    return Last.create(study, n=math.inf, learning_rate=0.1, discount=1.0, exploration=EpsilonGreedy(0.0))


# %% exercise 1, wrong: an unusual rate
# says: after two equal episodes with rewards
# says: , the value of the first action should be
# says: : that is no n-step SARSA with a usual learning rate
def quiet(study):
    return NStepSARSA.create(study, n=math.inf, learning_rate=0.37, discount=1.0, exploration=EpsilonGreedy(0.0))


# %% exercise 2, right: a power
# says: Right: one exploring action on the way makes the ratio 0, whatever the others were. With nine later actions, ε =
#   0.1 and N = 5 a target counts 2.1 times or not at all.
def importance_ratio(greedy, epsilon, n_actions):
    later = greedy[1:]
    if not all(later):
        return 0.0
    return (1 - epsilon + epsilon / n_actions) ** -len(later)


# %% exercise 2, right: math.prod
def importance_ratio(greedy, epsilon, n_actions):
    b = 1 - epsilon * (n_actions - 1) / n_actions
    return math.prod(1 / b if is_greedy else 0 for is_greedy in greedy[1:])


# %% exercise 2, right: NumPy
def importance_ratio(greedy, epsilon, n_actions):
    pi = np.array(greedy[1:], float)
    b = np.where(pi == 1, 1 - epsilon + epsilon / n_actions, epsilon / n_actions)
    return np.prod(np.divide(pi, b, out=np.zeros_like(pi), where=b > 0))


# %% exercise 2, right: a loop with indices
def importance_ratio(greedy, epsilon, n_actions):
    rho = 1.0
    for k in range(1, len(greedy)):
        pi = 1.0 if greedy[k] else 0.0
        b = 1 - epsilon + epsilon / n_actions if greedy[k] else epsilon / n_actions
        rho *= pi / b
    return rho


# %% exercise 2, right: it ends early
def importance_ratio(greedy, epsilon, n_actions):
    rho = 1
    for is_greedy in greedy[1:]:
        if not is_greedy:
            return 0
        rho /= 1 - epsilon + epsilon / n_actions
    return rho


# %% exercise 2, right: recursion
def importance_ratio(greedy, epsilon, n_actions):
    if len(greedy) <= 1:
        return 1.0
    rest = importance_ratio(greedy[:-1], epsilon, n_actions)
    return rest / (1 - epsilon + epsilon / n_actions) if greedy[-1] else 0.0


# %% exercise 2, right: logarithms
def importance_ratio(greedy, epsilon, n_actions):
    if False in greedy[1:]:
        return 0.0
    return math.exp(-(len(greedy) - 1) * math.log(1 - epsilon + epsilon / n_actions))


# %% exercise 2, wrong: not solved
# says: Not solved yet
def importance_ratio(greedy, epsilon, n_actions):
    raise NotImplementedError("not solved yet: replace this line")


# %% exercise 2, wrong: a number
# says: should be a function
# says: greedy, epsilon and n_actions
importance_ratio = 2.1


# %% exercise 2, wrong: no return
# says: is a `return` missing?
def importance_ratio(greedy, epsilon, n_actions):
    rho = 1.0
    for is_greedy in greedy[1:]:
        rho *= 1 / (1 - epsilon + epsilon / n_actions) if is_greedy else 0.0


# %% exercise 2, wrong: with the first action
# says: the first entry of `greedy` is A_t, which is not in the product: start at greedy[1]
def importance_ratio(greedy, epsilon, n_actions):
    rho = 1.0
    for is_greedy in greedy:
        rho *= 1 / (1 - epsilon + epsilon / n_actions) if is_greedy else 0.0
    return rho


# %% exercise 2, wrong: two left out
# says: two actions are left out at the start; only A_t is, so start at greedy[1]
def importance_ratio(greedy, epsilon, n_actions):
    rho = 1.0
    for is_greedy in greedy[2:]:
        rho *= 1 / (1 - epsilon + epsilon / n_actions) if is_greedy else 0.0
    return rho


# %% exercise 2, wrong: the last one left out
# says: the last action is left out; the product goes to the end of the list
def importance_ratio(greedy, epsilon, n_actions):
    rho = 1.0
    for k in range(1, len(greedy) - 1):
        rho *= 1 / (1 - epsilon + epsilon / n_actions) if greedy[k] else 0.0
    return rho


# %% exercise 2, wrong: a random action is never the best
# says: a random action may be the best one too, so b takes it with probability 1 − ε + ε/N, not 1 − ε
def importance_ratio(greedy, epsilon, n_actions):
    return (1 / (1 - epsilon)) ** (len(greedy) - 1) if all(greedy[1:]) else 0.0


# %% exercise 2, wrong: one of the others
# says: a random action is one of *all* N actions, so b takes the best one with probability 1 − ε + ε/N
def importance_ratio(greedy, epsilon, n_actions):
    b = 1 - epsilon + epsilon / (n_actions - 1)
    return b ** -(len(greedy) - 1) if all(greedy[1:]) else 0.0


# %% exercise 2, wrong: 1 − ε/N
# says: b takes the best action with probability 1 − ε + ε/N; 1 − ε/N is another number
def importance_ratio(greedy, epsilon, n_actions):
    b = 1 - epsilon / n_actions
    return b ** -(len(greedy) - 1) if all(greedy[1:]) else 0.0


# %% exercise 2, wrong: other actions left out
# says: the greedy policy never takes another action, so its ratio there is 0/b = 0, and it is left out here
def importance_ratio(greedy, epsilon, n_actions):
    rho = 1.0
    for is_greedy in greedy[1:]:
        if is_greedy:
            rho *= 1 / (1 - epsilon + epsilon / n_actions)
    return rho


# %% exercise 2, wrong: the product stops
# says: the product stops at an action that is not greedy; there the factor is 0, and so is the whole product
def importance_ratio(greedy, epsilon, n_actions):
    rho = 1.0
    for is_greedy in greedy[1:]:
        if not is_greedy:
            break
        rho *= 1 / (1 - epsilon + epsilon / n_actions)
    return rho


# %% exercise 2, wrong: one over the probability of what was done
# says: the greedy policy never takes another action: there π is 0, not 1
def importance_ratio(greedy, epsilon, n_actions):
    rho = 1.0
    for is_greedy in greedy[1:]:
        rho /= 1 - epsilon + epsilon / n_actions if is_greedy else epsilon / n_actions
    return rho


# %% exercise 2, wrong: upside down
# says: that is b/π, upside down
def importance_ratio(greedy, epsilon, n_actions):
    rho = 1.0
    for is_greedy in greedy[1:]:
        rho *= (1 - epsilon + epsilon / n_actions) if is_greedy else 0.0
    return rho


# %% exercise 2, wrong: added up
# says: the ratios of the single actions are multiplied, not added
def importance_ratio(greedy, epsilon, n_actions):
    return sum(1 / (1 - epsilon + epsilon / n_actions) for is_greedy in greedy[1:] if is_greedy)


# %% exercise 2, wrong: the mean
# says: the ratios of the single actions are multiplied; that is their mean
def importance_ratio(greedy, epsilon, n_actions):
    return np.mean([1 / (1 - epsilon + epsilon / n_actions) if g else 0.0 for g in greedy[1:]] or [0.0])


# %% exercise 2, wrong: all or nothing
# says: π takes a greedy action with probability 1, but b does not: divide by the probability under b
def importance_ratio(greedy, epsilon, n_actions):
    return 1.0 if all(greedy[1:]) else 0.0


# %% exercise 2, wrong: the probability under b
# says: that is the probability of these actions under b; the ratio is π divided by b
def importance_ratio(greedy, epsilon, n_actions):
    p = 1.0
    for is_greedy in greedy[1:]:
        p *= 1 - epsilon + epsilon / n_actions if is_greedy else epsilon / n_actions
    return p


# %% exercise 2, wrong: set, not multiplied
# says: that is the ratio of one action alone: multiply all of them (is the `return` inside the loop?)
def importance_ratio(greedy, epsilon, n_actions):
    rho = 1.0
    for is_greedy in greedy[1:]:
        rho = 1 / (1 - epsilon + epsilon / n_actions) if is_greedy else 0.0
    return rho


# %% exercise 2, wrong: integer division
# says: not 1 − ε
def importance_ratio(greedy, epsilon, n_actions):
    b = 1 - epsilon + epsilon // n_actions
    return b ** -(len(greedy) - 1) if all(greedy[1:]) else 0.0


# %% exercise 2, wrong: an array
# says: should be one number, but is a
def importance_ratio(greedy, epsilon, n_actions):
    return np.array(greedy[1:]) / (1 - epsilon + epsilon / n_actions)


# %% exercise 2, wrong: the list is used up
# says: changes its list `greedy`; leave it as it is, for the caller still needs it
def importance_ratio(greedy, epsilon, n_actions):
    greedy.pop(0)
    return (1 - epsilon + epsilon / n_actions) ** -len(greedy) if all(greedy) else 0.0


# %% exercise 2, wrong: division by zero
# says: should be
def importance_ratio(greedy, epsilon, n_actions):
    rho = 1.0
    for is_greedy in greedy[1:]:
        rho *= 1 / (1 - epsilon) if is_greedy else 0.0 / (epsilon / n_actions)
    return rho if epsilon < 1 else 1 / (1 - epsilon)


# %% exercise 2, wrong: two parameters
# says: its parameters are not those of the exercise
def importance_ratio(greedy, epsilon):
    return 1 / (1 - epsilon) ** len(greedy[1:])


# %% exercise 2, wrong: 0 where nothing is left
# says: with one action no factor is left, and an empty product is 1
def importance_ratio(greedy, epsilon, n_actions):
    if len(greedy) == 1:
        return 0.0
    return np.prod([is_greedy / (1 - epsilon + epsilon / n_actions) for is_greedy in greedy[1:]])


# %% exercise 2, wrong: ε times N
# says: ε is divided by N, not multiplied: b takes the best action with probability 1 − ε + ε/N
def importance_ratio(greedy, epsilon, n_actions):
    b = 1 - epsilon + epsilon * n_actions
    return math.prod(1 / b if best else 0.0 for best in greedy[1:])


# %% exercise 2, wrong: b where π is 0
# says: at an action that is not greedy the ratio is 0/b = 0, not b itself
def importance_ratio(greedy, epsilon, n_actions):
    b, other = 1 - epsilon + epsilon / n_actions, epsilon / n_actions
    return math.prod(1 / b if best else other for best in greedy[1:])


# %% exercise 2, wrong: it returns in the loop
# says: that is the ratio of the first action alone: multiply all of them (is the `return` inside the loop?)
def importance_ratio(greedy, epsilon, n_actions):
    rho = 1.0
    for best in greedy[1:]:
        rho *= best / (1 - epsilon + epsilon / n_actions)
        return rho
    return rho


# %% exercise 3, right: reversed
# says: Right: greedy actions hand the reward on, and exploring ones do not blur it. See it race:
def hand_back(self, length):
    G = 0.0
    for k in reversed(range(length)):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
        if self.Q[s, a] < max(self.Q[s]):
            G = max(self.Q[s])


# %% exercise 3, right: NumPy's maximum
def hand_back(self, length):
    G = 0.0
    for i in range(1, length + 1):
        k = length - i
        s = self.states[k]
        a = self.actions[k]
        G = self.rewards[k] + self.discount * G
        self.Q[s, a] = self.Q[s, a] + self.learning_rate * (G - self.Q[s, a])
        best = np.max(self.Q[s])
        if best > self.Q[s, a]:
            G = best


# %% exercise 3, right: while
def hand_back(self, length):
    k, G = length - 1, 0.0
    while k >= 0:
        s, a = self.states[k], self.actions[k]
        G = G * self.discount + self.rewards[k]
        self.Q[s, a] = (1 - self.learning_rate) * self.Q[s, a] + self.learning_rate * G
        if self.Q[s, a] != self.Q[s].max():
            G = self.Q[s].max()
        k -= 1


# %% exercise 3, right: an own loop for the maximum
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
        best = self.Q[s, 0]
        for b in range(1, self.Q.shape[1]):
            if self.Q[s, b] > best:
                best = self.Q[s, b]
        G = G if self.Q[s, a] >= best else best


# %% exercise 3, right: by argmax
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
        if a != np.argmax(self.Q[s]):
            G = np.max(self.Q[s])


# %% exercise 3, right: two names
def hand_back(self, length):
    future = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        target = self.rewards[k] + self.discount * future
        error = target - self.Q[s, a]
        self.Q[s, a] += self.learning_rate * error
        if self.Q[s, a] < max(self.Q[s]):
            future = max(self.Q[s])
        else:
            future = target


# %% exercise 3, right: all in learn
def learn(self, state, action, reward, next_state, terminated):
    k = self.length[0]
    self.states[k], self.actions[k], self.rewards[k] = state, action, reward
    self.length[0] += 1
    if terminated:
        G = 0.0
        while self.length[0] > 0:
            self.length[0] -= 1
            k = self.length[0]
            s, a = self.states[k], self.actions[k]
            G = self.rewards[k] + self.discount * G
            self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
            if self.Q[s, a] < max(self.Q[s]):
                G = max(self.Q[s])


# %% exercise 3, right: a row by name
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        row, a = self.Q[self.states[k]], self.actions[k]
        G = self.rewards[k] + self.discount * G
        row[a] += self.learning_rate * (G - row[a])
        if row[a] < row.max():
            G = row.max()


# %% exercise 3, wrong: not solved
# says: Not solved yet
def hand_back(self, length):
    raise NotImplementedError("not solved yet: replace this line")


# %% exercise 3, wrong: the smallest value
# says: Q[
# says: that is none of the usual mistakes, so compare your loop with the three lines, term by term
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
        if self.Q[s, a] > min(self.Q[s]):
            G = min(self.Q[s])


# %% exercise 3, wrong: the best value goes into the update
# says: Q[
# says: episode with states
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        if self.Q[s, a] < max(self.Q[s]):
            G = max(self.Q[s])
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])


# %% exercise 3, wrong: the numbers of Q-learning
# says: G is cut at every action, so only one reward is in each target: cut where Q(S, A) is *below* the largest value
# says: ] should become
def hand_back(self, length):
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        best = 0.0 if k == length - 1 else max(self.Q[self.states[k + 1]])
        self.Q[s, a] += self.learning_rate * (self.rewards[k] + self.discount * best - self.Q[s, a])


# %% exercise 3, wrong: a whole number for G
# says: Q[
def hand_back(self, length):
    G = 0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = int(self.rewards[k] + self.discount * G)
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
        if self.Q[s, a] < max(self.Q[s]):
            G = max(self.Q[s])


# %% exercise 3, wrong: nothing
# says: `hand_back` changes nothing in Q
def hand_back(self, length):
    pass


# %% exercise 3, wrong: Monte Carlo
# says: G is never cut, so this is Monte Carlo: the third line is missing
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])


# %% exercise 3, wrong: always cut
# says: G is cut at every action
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
        G = max(self.Q[s])


# %% exercise 3, wrong: the condition upside down
# says: the condition is upside down: G is cut where the action is *not* the best
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
        if self.Q[s, a] == max(self.Q[s]):
            G = max(self.Q[s])


# %% exercise 3, wrong: asked before the update
# says: whether the action is the best is asked before the update; ask it after
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        exploring = self.Q[s, a] < max(self.Q[s])
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
        if exploring:
            G = max(self.Q[s])


# %% exercise 3, wrong: the loop ends
# says: the loop ends at the exploring action; the steps before it still learn, from the G that was cut
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
        if self.Q[s, a] < max(self.Q[s]):
            break


# %% exercise 3, wrong: it goes on with its own value
# says: where G is cut it goes on with the *largest* value of the state, not with that of the action taken
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
        if self.Q[s, a] < max(self.Q[s]):
            G = self.Q[s, a]


# %% exercise 3, wrong: it goes on with 0
# says: where G is cut it goes on with the largest value of the state, not with 0
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
        if self.Q[s, a] < max(self.Q[s]):
            G = 0.0


# %% exercise 3, wrong: the mean of the row
# says: where G is cut it goes on with the *largest* value of the state, not with the mean
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
        if self.Q[s, a] < max(self.Q[s]):
            G = self.Q[s].mean()


# %% exercise 3, wrong: the larger of the two
# says: G takes the largest value also where it is smaller; max(G, ...) keeps lucky returns
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
        if self.Q[s, a] < max(self.Q[s]):
            G = max(G, max(self.Q[s]))


# %% exercise 3, wrong: discounted twice
# says: the largest value is discounted where G is cut, and once more in the next step
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
        if self.Q[s, a] < max(self.Q[s]):
            G = self.discount * max(self.Q[s])


# %% exercise 3, wrong: forwards
# says: the loop runs forwards; go from the last step to the first
def hand_back(self, length):
    G = 0.0
    for k in range(length):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
        if self.Q[s, a] < max(self.Q[s]):
            G = max(self.Q[s])


# %% exercise 3, wrong: the first step is left out
# says: the first step of the episode, number 0, learns nothing: range(length - 1, -1, -1) ends with 0
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, 0, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
        if self.Q[s, a] < max(self.Q[s]):
            G = max(self.Q[s])


# %% exercise 3, wrong: the last step is left out
# says: the last step of the episode learns nothing: start at length - 1
def hand_back(self, length):
    G = 0.0
    for k in range(length - 2, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
        if self.Q[s, a] < max(self.Q[s]):
            G = max(self.Q[s])


# %% exercise 3, wrong: no discount
# says: the discount is missing: G becomes R + γ G
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + G
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
        if self.Q[s, a] < max(self.Q[s]):
            G = max(self.Q[s])


# %% exercise 3, wrong: all discounted
# says: the reward is discounted too; γ belongs to G only
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.discount * (self.rewards[k] + G)
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
        if self.Q[s, a] < max(self.Q[s]):
            G = max(self.Q[s])


# %% exercise 3, wrong: the reward is not added up
# says: only one reward is in each target: G becomes R + γ G
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k]
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
        if self.Q[s, a] < max(self.Q[s]):
            G = max(self.Q[s])


# %% exercise 3, wrong: the old value is not subtracted
# says: the old value is not subtracted: Q moves by α [G − Q]
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        self.Q[s, a] += self.learning_rate * G
        if self.Q[s, a] < max(self.Q[s]):
            G = max(self.Q[s])


# %% exercise 3, wrong: set at once
# says: Q is set to G at once: move it by α [G − Q]
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        self.Q[s, a] = G
        if self.Q[s, a] < max(self.Q[s]):
            G = max(self.Q[s])


# %% exercise 3, wrong: the sign
# says: Q moves away from the target: the sign is wrong
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        self.Q[s, a] += self.learning_rate * (self.Q[s, a] - G)
        if self.Q[s, a] < max(self.Q[s]):
            G = max(self.Q[s])


# %% exercise 3, wrong: exploring actions learn nothing
# says: exploring actions learn nothing; they do, from what came after them
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        if self.Q[s, a] < max(self.Q[s]):
            G = max(self.Q[s])
            continue
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
        if self.Q[s, a] < max(self.Q[s]):
            G = max(self.Q[s])


# %% exercise 3, wrong: a learning rate of its own
# says: a learning_rate of 0.1: use self.learning_rate
# says: everything fits
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        self.Q[s, a] += 0.1 * (G - self.Q[s, a])
        if self.Q[s, a] < max(self.Q[s]):
            G = max(self.Q[s])


# %% exercise 3, wrong: both numbers of its own
# says: use self.learning_rate
# says: use self.discount
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + 0.9 * G
        self.Q[s, a] += 0.1 * (G - self.Q[s, a])
        if self.Q[s, a] < max(self.Q[s]):
            G = max(self.Q[s])


# %% exercise 3, wrong: Monte Carlo, and without the discount
# says: the third line is missing
# says: discount
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G += self.rewards[k]
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])


# %% exercise 3, wrong: self forgotten
# says: write `self.` before a field
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + discount * G
        self.Q[s, a] += learning_rate * (G - self.Q[s, a])


# %% exercise 3, wrong: one step too many
# says: a value changes that is not on the path: the steps of the episode are 0 to length - 1
def hand_back(self, length):
    G = 0.0
    for k in range(length, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
        if self.Q[s, a] < max(self.Q[s]):
            G = max(self.Q[s])


# %% exercise 3, wrong: a field is set
# says: raises AttributeError
def hand_back(self, length):
    self.G = 0.0


# %% exercise 3, wrong: an agent in place of the class
# says: MyAgent should be the class
MyAgent = NStepSARSA.create((12, 3))


# %% exercise 3, wrong: the episode is never begun anew
# says: after a second episode
def learn(self, state, action, reward, next_state, terminated):
    k = self.length[0]
    self.states[k], self.actions[k], self.rewards[k] = state, action, reward
    self.length[0] = k + 1
    if terminated:
        self.hand_back(k + 1)


# %% exercise 3, wrong: the reward of the next step
# says: `rewards[k]` is R_{k+1} already, the reward after step k
def hand_back(self, length):
    G = 0.0
    for k in range(length - 1, -1, -1):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k + 1] + self.discount * G
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
        best = max(self.Q[s])
        if self.Q[s, a] < best:
            G = best


# %% exercise 3, wrong: the old maximum
# says: the largest value is that of the row before the update; take it after
def hand_back(self, length):
    G = 0.0
    for k in reversed(range(length)):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        best = max(self.Q[s])
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
        if self.Q[s, a] < max(self.Q[s]):
            G = best


# %% exercise 3, wrong: added
# says: where G is cut the largest value takes its place; it is not added
def hand_back(self, length):
    G = 0.0
    for k in reversed(range(length)):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
        if self.Q[s, a] < max(self.Q[s]):
            G += max(self.Q[s])


# %% exercise 3, wrong: the reward discounted
# says: γ belongs to G, not to the reward
def hand_back(self, length):
    G = 0.0
    for k in reversed(range(length)):
        s, a = self.states[k], self.actions[k]
        G = self.discount * self.rewards[k] + G
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
        if self.Q[s, a] < max(self.Q[s]):
            G = max(self.Q[s])


# %% exercise 3, wrong: no rewards
# says: the rewards are missing: G becomes R + γ G
def hand_back(self, length):
    G = 0.0
    for k in reversed(range(length)):
        s, a = self.states[k], self.actions[k]
        G = self.discount * G
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
        if self.Q[s, a] < max(self.Q[s]):
            G = max(self.Q[s])


# %% exercise 3, wrong: minus
# says: the future is subtracted: G becomes R + γ G
def hand_back(self, length):
    G = 0.0
    for k in reversed(range(length)):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] - self.discount * G
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
        if self.Q[s, a] < max(self.Q[s]):
            G = max(self.Q[s])


# %% exercise 3, wrong: set
# says: the old value is lost: Q moves by α [G − Q], so write +=
def hand_back(self, length):
    G = 0.0
    for k in reversed(range(length)):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        self.Q[s, a] = self.learning_rate * (G - self.Q[s, a])
        if self.Q[s, a] < max(self.Q[s]):
            G = max(self.Q[s])


# %% exercise 3, wrong: the weights exchanged
# says: α and 1 − α have changed places
def hand_back(self, length):
    G = 0.0
    for k in reversed(range(length)):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        self.Q[s, a] = self.learning_rate * self.Q[s, a] + (1 - self.learning_rate) * G
        if self.Q[s, a] < max(self.Q[s]):
            G = max(self.Q[s])


# %% exercise 3, wrong: a value after the end
# says: G starts with a value of the state after the end; after a terminal state there is no future
def learn(self, state, action, reward, next_state, terminated):
    k = self.length[0]
    self.states[k], self.actions[k], self.rewards[k] = state, action, reward
    self.states[k + 1] = next_state
    self.length[0] = k + 1
    if terminated:
        self.hand_back(k + 1)
        self.length[0] = 0


def hand_back(self, length):
    G = max(self.Q[self.states[length]])
    for k in reversed(range(length)):
        s, a = self.states[k], self.actions[k]
        G = self.rewards[k] + self.discount * G
        self.Q[s, a] += self.learning_rate * (G - self.Q[s, a])
        if self.Q[s, a] < max(self.Q[s]):
            G = max(self.Q[s])
