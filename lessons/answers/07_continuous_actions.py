# ruff: noqa
# Right and wrong answers to the exercises of lesson 7; tests/lessons/test_answers.py tries them all.
# An answer stands in the place of the exercise's cell. Methods without their class replace those of the solution.


# %% setup
import itertools
import math


# %% exercise 1, right: in one line
# says: Right: with 6 joints, 30 cells and 5 bins that are 2.3e+13. A Gaussian has one mean for each joint.
def preferences(joints, bins, cells):
    return 2 * cells**joints * bins**joints


# %% exercise 1, right: one power
def preferences(joints, bins, cells):
    return 2 * (cells * bins) ** joints


# %% exercise 1, right: a loop
def preferences(joints, bins, cells):
    n = 2
    for joint in range(joints):
        n *= cells * bins
    return n


# %% exercise 1, right: with pow
def preferences(joints, bins, cells):
    return pow(cells, joints) * pow(bins, joints) * 2


# %% exercise 1, right: as a float
def preferences(joints, bins, cells):
    return 2.0 * float(cells) ** joints * bins**joints


# %% exercise 1, right: rows and columns
def preferences(joints, bins, cells):
    holding = 2
    angles = math.prod([cells] * joints)
    actions = len(list(itertools.product(range(bins), repeat=joints)))
    return holding * angles * actions


# %% exercise 1, right: with numpy
def preferences(joints, bins, cells):
    return np.prod(np.full(joints, cells)) * np.prod(np.full(joints, bins)) * 2


# %% exercise 1, wrong: dots
# says: Not solved yet
preferences = ...


# %% exercise 1, wrong: the placeholder
# says: Not solved yet
def preferences(joints, bins, cells):
    raise NotImplementedError("not solved yet: replace this line")


# %% exercise 1, wrong: a number
# says: should be a function
# says: joints, bins and cells
preferences = 2 * 30**2 * 5**2


# %% exercise 1, wrong: no return
# says: is a `return` missing?
def preferences(joints, bins, cells):
    n = 2 * cells**joints * bins**joints


# %% exercise 1, wrong: printed
# says: is a `return` missing?
def preferences(joints, bins, cells):
    print(2 * cells**joints * bins**joints)


# %% exercise 1, wrong: without the box
# says: whether the box is held doubles the number of rows
def preferences(joints, bins, cells):
    return cells**joints * bins**joints


# %% exercise 1, wrong: rows
# says: that is the number of rows; each row has a column for every action
def preferences(joints, bins, cells):
    return 2 * cells**joints


# %% exercise 1, wrong: actions
# says: that is the number of actions alone; how many rows are there?
def preferences(joints, bins, cells):
    return bins**joints


# %% exercise 1, wrong: bins added
# says: the bins of the joints are chosen together: n for each of m joints make n^m actions, not n m
def preferences(joints, bins, cells):
    return 2 * cells**joints * bins * joints


# %% exercise 1, wrong: one joint's bins
# says: every joint has bins of its own: n^m actions, not n
def preferences(joints, bins, cells):
    return 2 * cells**joints * bins


# %% exercise 1, wrong: one angle
# says: every joint has an angle of its own: c^m cells, not c
def preferences(joints, bins, cells):
    return 2 * cells * bins**joints


# %% exercise 1, wrong: angles added
# says: the angles are cut together: c^m cells, not c m
def preferences(joints, bins, cells):
    return 2 * cells * joints * bins**joints


# %% exercise 1, wrong: all added
# says: both are powers: m joints have c^m cells and n^m actions
def preferences(joints, bins, cells):
    return 2 * cells * bins * joints


# %% exercise 1, wrong: no joints
# says: both are powers: m joints have c^m cells and n^m actions; the joints are missing
def preferences(joints, bins, cells):
    return 2 * cells * bins


# %% exercise 1, wrong: rows plus columns
# says: cells and bins multiply, they do not add: every row has all columns
def preferences(joints, bins, cells):
    return 2 * cells**joints + bins**joints


# %% exercise 1, wrong: a box for each joint
# says: the box is held by the arm, not by each joint: the factor is 2, not 2^m
def preferences(joints, bins, cells):
    return (2 * cells * bins) ** joints


# %% exercise 1, wrong: exchanged
# says: base and exponent have changed places: n^m, not m^n
def preferences(joints, bins, cells):
    return 2 * joints**cells * joints**bins


# %% exercise 1, wrong: two more
# says: the 2 multiplies the rows, it is not added to them
def preferences(joints, bins, cells):
    return (2 + cells**joints) * bins**joints


# %% exercise 1, wrong: three cells for holding
# says: holding has 2 values, yes and no; in the lesson's wrapper one of the 3 cells is never used
def preferences(joints, bins, cells):
    return 3 * cells**joints * bins**joints


# %% exercise 1, wrong: two joints for ever
# says: that is right for two joints; m joints have c^m cells and n^m actions
def preferences(joints, bins, cells):
    return 2 * cells**2 * bins**2


# %% exercise 1, wrong: the table of the wrist
# says: that is right for the two coordinates of the wrist in the lesson; here every joint has an angle of its own: c^m
#   cells, not c^2
def preferences(joints, bins, cells):
    return 2 * cells**2 * bins**joints


# %% exercise 1, wrong: a quarter
# says: that is none of the usual mistakes, so work it out by hand for a small case
def preferences(joints, bins, cells):
    return 2 * (cells * bins) ** joints / 4


# %% exercise 1, wrong: a text
# says: should be a number, but is the text
def preferences(joints, bins, cells):
    return f"{2 * cells**joints * bins**joints}"


# %% exercise 1, wrong: another parameter
# says: its parameters are not those of the exercise
def preferences(joints, bins):
    return 2 * 30**joints * bins**joints


# %% exercise 1, wrong: the cells squared
# says: the box is a part of the state: multiply by 2, do not square
def preferences(joints, bins, cells):
    return (cells**joints) ** 2 * bins**joints


# %% exercise 2, right: in one line
# says: Right: the mean of both scores is 0, so a baseline changes nothing on average. See your policies learn:
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, (a - mu) ** 2 / sigma**2 - 1


# %% exercise 2, right: standardised
def my_scores(a, mu, sigma):
    z = (a - mu) / sigma
    return z / sigma, z**2 - 1


# %% exercise 2, right: the derivative with respect to σ, times σ
def my_scores(a, mu, sigma):
    of_sigma = ((a - mu) ** 2 - sigma**2) / sigma**3
    return (a - mu) / sigma**2, sigma * of_sigma


# %% exercise 2, right: a list
def my_scores(a, mu, sigma):
    return [(a - mu) / sigma**2, (a - mu) ** 2 / sigma**2 - 1]


# %% exercise 2, right: the variance first
def my_scores(a, mu, sigma):
    variance = sigma * sigma
    distance = a - mu
    return distance / variance, (distance * distance - variance) / variance


# %% exercise 2, right: minus signs
def my_scores(a, mu, sigma):
    return -(mu - a) / sigma**2, -1 + (mu - a) ** 2 / sigma**2


# %% exercise 2, right: the lesson's function
def my_scores(a, mu, sigma):
    return arms.scores(a, mu, sigma)


# %% exercise 2, wrong: the placeholder
# says: Not solved yet
def my_scores(a, mu, sigma):
    raise NotImplementedError("not solved yet: replace this line")


# %% exercise 2, wrong: dots
# says: Not solved yet
my_scores = ...


# %% exercise 2, wrong: no return
# says: is a `return` missing?
def my_scores(a, mu, sigma):
    of_mu, of_log_sigma = (a - mu) / sigma**2, (a - mu) ** 2 / sigma**2 - 1


# %% exercise 2, wrong: only one
# says: should give two numbers, one for μ and one for ln σ, but gives
# says: : end with `return of_mu, of_log_sigma`
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2


# %% exercise 2, wrong: σ, not squared
# says: divide by σ², not by σ
def my_scores(a, mu, sigma):
    return (a - mu) / sigma, (a - mu) ** 2 / sigma**2 - 1


# %% exercise 2, wrong: no division
# says: the derivative of (a − μ)² / (2σ²) brings 1/σ² with it; the division is missing
def my_scores(a, mu, sigma):
    return a - mu, (a - mu) ** 2 / sigma**2 - 1


# %% exercise 2, wrong: the wrong sign
# says: the sign is wrong: an action above the mean gets likelier if the mean grows
def my_scores(a, mu, sigma):
    return (mu - a) / sigma**2, (a - mu) ** 2 / sigma**2 - 1


# %% exercise 2, wrong: half
# says: the 2 of the square and the 2 in 2σ² cancel
def my_scores(a, mu, sigma):
    return (a - mu) / (2 * sigma**2), (a - mu) ** 2 / sigma**2 - 1


# %% exercise 2, wrong: twice
# says: the 2 of the square and the 2 in 2σ² cancel; here the 2 is too many
def my_scores(a, mu, sigma):
    return 2 * (a - mu) / sigma**2, (a - mu) ** 2 / sigma**2 - 1


# %% exercise 2, wrong: no brackets
# says: set brackets: a − μ is divided as a whole
def my_scores(a, mu, sigma):
    return a - mu / sigma**2, (a - mu) ** 2 / sigma**2 - 1


# %% exercise 2, wrong: the logarithm itself
# says: that is ln π (but for a constant), not its derivative
def my_scores(a, mu, sigma):
    return -((a - mu) ** 2) / (2 * sigma**2) - math.log(sigma), (a - mu) ** 2 / sigma**2 - 1


# %% exercise 2, wrong: times the variance
# says: that is σ² in the numerator; divide by it
def my_scores(a, mu, sigma):
    return (a - mu) * sigma**2, (a - mu) ** 2 / sigma**2 - 1


# %% exercise 2, wrong: exchanged
# says: that is the score of ln σ; the score of μ comes first
def my_scores(a, mu, sigma):
    return (a - mu) ** 2 / sigma**2 - 1, (a - mu) / sigma**2


# %% exercise 2, wrong: of σ
# says: that is the derivative with respect to σ; for ln σ multiply it by σ
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, (a - mu) ** 2 / sigma**3 - 1 / sigma


# %% exercise 2, wrong: of the variance
# says: that is the derivative with respect to σ²; for ln σ multiply it by 2σ²
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, (a - mu) ** 2 / (2 * sigma**4) - 1 / (2 * sigma**2)


# %% exercise 2, wrong: no −1
# says: the term − ln σ is forgotten; its derivative with respect to ln σ is −1
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, (a - mu) ** 2 / sigma**2


# %% exercise 2, wrong: the sign of the second
# says: the sign is wrong: σ should grow for actions that are far out
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, 1 - (a - mu) ** 2 / sigma**2


# %% exercise 2, wrong: plus 1
# says: the derivative of − ln σ is −1, not +1
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, (a - mu) ** 2 / sigma**2 + 1


# %% exercise 2, wrong: half of the second
# says: the exponent −2 of σ gives a factor of 2, which cancels the 2 in 2σ²
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, (a - mu) ** 2 / (2 * sigma**2) - 1


# %% exercise 2, wrong: not squared
# says: a − μ should be squared
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, (a - mu) / sigma**2 - 1


# %% exercise 2, wrong: σ once
# says: σ is divided by once too little: (a − μ)² is divided by σ²
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, (a - mu) ** 2 / sigma - 1


# %% exercise 2, wrong: for single numbers only
# says: my_scores with three actions at once should give three numbers for each score: use + - * / **
def my_scores(a, mu, sigma):
    if np.size(a) > 1:
        a = a[0]
    return (a - mu) / sigma**2, (a - mu) ** 2 / sigma**2 - 1


# %% exercise 2, wrong: with math
# says: raises TypeError
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, math.exp(2 * math.log(abs(a - mu) / sigma)) - 1


# %% exercise 2, wrong: σ undefined
# says: is not defined
def my_scores(a, mu, sigma):
    return (a - mu) / s**2, (a - mu) ** 2 / s**2 - 1


# %% exercise 2, wrong: it writes into the actions
# says: changes the array `a`
# says: ` that it is given: `-=` and the like write into an array, so give what you compute a name of its own
# says: my_scores changes the array `
def my_scores(a, mu, sigma):
    a -= mu
    return a / sigma**2, a**2 / sigma**2 - 1


# %% exercise 2, wrong: nothing for arrays
# says: with three actions at once gives None: is a `return` missing
# says: my_scores(a, mu, sigma) with three actions at once
def my_scores(a, mu, sigma):
    if np.ndim(a) == 0:
        return (a - mu) / sigma**2, (a - mu) ** 2 / sigma**2 - 1


# %% exercise 2, wrong: rounded
# says: do not round it
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, np.round((a - mu) ** 2 / sigma**2 - 1, 3)


# %% exercise 2, wrong: the square again
# says: the derivative of a square is not a square
def my_scores(a, mu, sigma):
    return (a - mu) ** 2 / sigma**2, (a - mu) ** 2 / sigma**2 - 1


# %% exercise 2, wrong: to the third
# says: the derivative of the square root is taken: divide by σ², once
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**3, (a - mu) ** 2 / sigma**2 - 1


# %% exercise 2, wrong: of π
# says: that is the derivative of π, not of ln π
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**3 * np.exp(-((a - mu) ** 2) / (2 * sigma**2)) / np.sqrt(2 * np.pi), (
        a - mu
    ) ** 2 / sigma**2 - 1


# %% exercise 2, wrong: less 1/σ
# says: the derivative of − ln σ with respect to ln σ is −1, not −1/σ
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, (a - mu) ** 2 / sigma**2 - 1 / sigma


# %% exercise 2, wrong: times the variance, in the second
# says: σ² in the numerator should be σ² below
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, (a - mu) ** 2 * sigma**2 - 1


# %% exercise 2, wrong: the first one twice
# says: that is the score of μ; the score of ln σ comes second
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, (a - mu) / sigma**2


# %% exercise 2, wrong: brackets
# says: it is (a − μ)² − σ² that is divided by σ²: set brackets
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, (a - mu) ** 2 - sigma**2 / sigma**2


# %% exercise 2, wrong: to the third, in the second
# says: divided by σ³ it is the derivative with respect to σ; and there −1/σ belongs to it
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, (a - mu) ** 2 / sigma**3 - 1


# %% exercise 2, wrong: plus a half
# says: derive it again from ln π(a), term by term
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, (a - mu) ** 2 / sigma**2 - 0.5


# %% exercise 2, wrong: a class
# says: a, mu and sigma
class my_scores:
    pass


# %% exercise 3, right: returns first, then the steps in order
# says: Right: returns minus a baseline, times the score. See it race:
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, right: backwards
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        state = self.states[t]
        delta = G - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, right: the power of γ under way
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    power = 1.0
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * power * delta * score
        power *= self.discount


# %% exercise 3, right: with the function of the package
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        size = self.learning_rate * self.discount**t * delta
        follow_log_gradient(self.preferences, state, self.actions[t], self.probabilities, size)


# %% exercise 3, right: a sum for each return
def update(self, n):
    for t in range(n):
        G = 0.0
        for k in range(t, n):
            G += self.discount ** (k - t) * self.rewards[k]
        state, action = self.states[t], self.actions[t]
        delta = G - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        step = self.learning_rate * self.discount**t * delta
        for a in range(len(self.probabilities)):
            self.preferences[state, a] -= step * self.probabilities[a]
        self.preferences[state, action] += step


# %% exercise 3, right: with arrays
def update(self, n):
    G = np.zeros(n + 1)
    for t in range(n - 1, -1, -1):
        G[t] = self.rewards[t] + self.discount * G[t + 1]
    for t in range(n):
        s = self.states[t]
        delta = G[t] - self.V[s]
        self.look(s)
        score = -self.probabilities
        score[self.actions[t]] += 1
        self.preferences[s] += self.learning_rate * self.discount**t * delta * score
        self.V[s] += self.value_learning_rate * delta


# %% exercise 3, right: the policy before the baseline
def update(self, n):
    for t in range(n - 1, -1, -1):
        if t < n - 1:
            self.rewards[t] += self.discount * self.rewards[t + 1]
    for t in range(n):
        s = self.states[t]
        self.look(s)
        delta = self.rewards[t] - self.V[s]
        for a in range(len(self.probabilities)):
            chosen = int(a == self.actions[t])
            self.preferences[s, a] += self.learning_rate * self.discount**t * delta * (chosen - self.probabilities[a])
        self.V[s] = (1 - self.value_learning_rate) * self.V[s] + self.value_learning_rate * self.rewards[t]


# %% exercise 3, right: parameters of learn in another order
def learn(self, truncated, action, state, terminated, reward):
    t = self.length[0]
    self.states[t], self.actions[t], self.rewards[t] = state, action, reward
    self.length[0] = t + 1
    if terminated or truncated:
        self.update(self.length[0])
        self.length[0] = 0


# %% exercise 3, right: a plain class
class MyREINFORCE:
    learning_rate, value_learning_rate, discount = 0.4, 0.4, 0.99

    def __init__(self, n_states, n_actions):
        self.preferences, self.V = np.zeros((n_states, n_actions)), np.zeros(n_states)
        self.probabilities, self.rewards = np.zeros(n_actions), np.zeros(200)
        self.states, self.actions, self.length = np.zeros(200, int), np.zeros(200, int), np.zeros(1, int)

    @classmethod
    def create(cls, task):
        return cls(int(np.prod(task.observation_space.nvec)), int(task.action_space.n))

    def look(self, state):
        softmax(self.preferences, state, self.probabilities)

    def act(self, state, rng):
        self.look(state)
        return draw_action(self.probabilities, rng)

    def learn(self, state, action, reward, terminated, truncated):
        t = self.length[0]
        self.states[t], self.actions[t], self.rewards[t] = state, action, reward
        self.length[0] = t + 1
        if terminated or truncated:
            self.update(self.length[0])
            self.length[0] = 0

    def update(self, n):
        G = 0.0
        for t in range(n - 1, -1, -1):
            G = self.rewards[t] + self.discount * G
            self.rewards[t] = G
        for t in range(n):
            state = self.states[t]
            delta = self.rewards[t] - self.V[state]
            self.V[state] += self.value_learning_rate * delta
            self.look(state)
            for a in range(len(self.probabilities)):
                score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
                self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: the placeholder
# says: Not solved yet
def update(self, n):
    raise NotImplementedError("not solved yet: replace this line")


# %% exercise 3, wrong: nothing
# says: update changes neither `preferences` nor `V`: change the entries of these arrays in place
def update(self, n):
    pass


# %% exercise 3, wrong: no γ^t
# says: the factor γ^t is missing in the step of the preferences
# says: and preferences[
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * delta * score


# %% exercise 3, wrong: γ from the end
# says: the power of γ counts the steps from the *end*; t counts from the start
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount ** (n - 1 - t) * delta * score


# %% exercise 3, wrong: one power too many
# says: the power of γ is one too high: the first step has γ^0 = 1
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount ** (t + 1) * delta * score


# %% exercise 3, wrong: no baseline
# says: V(S_t) is not subtracted: δ is the return less the baseline
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: G for δ in the policy
# says: V moves, but the preferences move by G instead of δ
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * self.rewards[t] * score


# %% exercise 3, wrong: V stays
# says: the baseline V does not change
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: V set
# says: V is set to α^w δ; write `+=`
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] = self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: V by the whole δ
# says: V moves by the whole δ; multiply it by α^w
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: V by G
# says: V moves by α^w G instead of α^w δ
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * self.rewards[t]
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: δ after V
# says: δ is computed again after V has changed; use the one from before
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        delta = self.rewards[t] - self.V[state]
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: the rates exchanged
# says: the two learning rates have changed places
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.value_learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: one rate
# says: V has a learning rate of its own, value_learning_rate
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: rewards for returns
# says: that is the reward R_{t+1}, not the return G_t
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: not discounted
# says: the return is not discounted: G_t = R_{t+1} + γ G_{t+1}
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: the return of the whole episode
# says: every step gets the return of the whole episode; it should be the one from step t on
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = G - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: without its own reward
# says: the return G_t begins with the reward R_{t+1} = rewards[t], which is missing
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        reward = self.rewards[t]
        self.rewards[t] = self.discount * G
        G = reward + self.discount * G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: from the start
# says: it adds the rewards from the start up to step t; the return adds those from step t on
def update(self, n):
    G = 0.0
    for t in range(n):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: the reward discounted too
# says: the reward R_{t+1} itself is discounted; only what follows it should be
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.discount * (self.rewards[t] + G)
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: no π
# says: π is missing in the score: it is 1{a = A} − π(a|S)
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = 1.0 if a == self.actions[t] else 0.0
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: only the action taken
# says: only the preference of the action that was taken changes; all others change by −π
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            if a != self.actions[t]:
                continue
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: the sign
# says: the sign of the score is wrong: it is 1{a = A} − π(a|S)
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] -= self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: π added
# says: π should be subtracted in the score, not added
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) + self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: no 1{a = A}
# says: 1{a = A} is missing: the action that was taken gets 1 − π, the others −π
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = -self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: not looked
# says: the probabilities are those of another state: call self.look(state) first
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: the last step missing
# says: the last step of the episode is left out: its number is n − 1
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n - 1):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: the whole buffer
# says: it goes through the whole of `rewards`; this episode has only its first n steps
def update(self, n):
    G = 0.0
    for t in range(len(self.rewards) - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: the first step missing
# says: the first step of the episode is left out: range(n - 1, -1, -1) goes down to 0
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(1, n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: two mistakes
# says: ; and
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * delta * score


# %% exercise 3, wrong: self forgotten
# says: is not defined
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: one index
# says: after the episode with states
# says: that is none of the usual mistakes, so follow this episode by hand
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: a list of rewards
# says: the table `rewards` should be a NumPy array, but is a list
def create(cls, task):
    n_states, n_actions = int(np.prod(task.observation_space.nvec)), int(task.action_space.n)
    episode = np.zeros(200, np.int64), np.zeros(200, np.int64), [0.0] * 200, np.zeros(1, np.int64)
    return cls(np.zeros((n_states, n_actions)), np.zeros(n_states), np.zeros(n_actions), *episode)


# %% exercise 3, wrong: lists of preferences
# says: the table `preferences` should be a NumPy array, but is a list
def create(cls, task):
    n_states, n_actions = int(np.prod(task.observation_space.nvec)), int(task.action_space.n)
    episode = np.zeros(200, np.int64), np.zeros(200, np.int64), np.zeros(200), np.zeros(1, np.int64)
    return cls([[0.0] * n_actions for _ in range(n_states)], np.zeros(n_states), np.zeros(n_actions), *episode)


# %% exercise 3, wrong: a baseline for each action
# says: the table `V` should have the shape (7,)
def create(cls, task):
    n_states, n_actions = int(np.prod(task.observation_space.nvec)), int(task.action_space.n)
    episode = np.zeros(200, np.int64), np.zeros(200, np.int64), np.zeros(200), np.zeros(1, np.int64)
    return cls(np.zeros((n_states, n_actions)), np.zeros((n_states, n_actions)), np.zeros(n_actions), *episode)


# %% exercise 3, wrong: whole rewards
# says: loses what is behind the decimal point
def create(cls, task):
    n_states, n_actions = int(np.prod(task.observation_space.nvec)), int(task.action_space.n)
    episode = np.zeros(200, np.int64), np.zeros(200, np.int64), np.zeros(200, np.int64), np.zeros(1, np.int64)
    return cls(np.zeros((n_states, n_actions)), np.zeros(n_states), np.zeros(n_actions), *episode)


# %% exercise 3, wrong: create gives the class back
# says: gives the class MyREINFORCE
def create(cls, task):
    return cls


# %% exercise 3, wrong: no create
# says: MyREINFORCE should keep its method `create`
class MyREINFORCE(NamedTuple):
    preferences: np.ndarray
    V: np.ndarray


# %% exercise 3, wrong: it learns from terminated episodes alone
# says: an episode that is cut off is over as well: call `update` also when `truncated`
def learn(self, state, action, reward, terminated, truncated):
    t = self.length[0]
    self.states[t], self.actions[t], self.rewards[t] = state, action, reward
    self.length[0] = t + 1
    if terminated:
        self.update(self.length[0])
    if terminated or truncated:
        self.length[0] = 0


# %% exercise 3, wrong: one reward too many
# says: the return begins with rewards[n], which an earlier episode has left there: the last reward of n steps is
#   rewards[n - 1]
def update(self, n):
    G = 0.0
    for t in range(n, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, right: first the baseline of every step, then the policy
def update(self, n):
    G, deltas = 0.0, np.zeros(n)
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        deltas[t] = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * deltas[t]
    for t in range(n):
        state = self.states[t]
        delta = deltas[t]
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: the first visit alone
# says: a state that comes twice is updated twice, once for each step
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        if state in self.states[:t]:
            continue
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: the last visit alone
# says: a state that comes twice is updated twice
def update(self, n):
    G, seen = 0.0, []
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        state = self.states[t]
        if state in seen:
            continue
        seen.append(state)
        delta = G - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: every δ before any change
# says: δ is computed with V from before the episode; it should be V as the updates so far have left it
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    deltas = self.rewards[:n] - self.V[self.states[:n]]
    for t in range(n):
        state = self.states[t]
        delta = deltas[t]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: every π before any change
# says: the probabilities are those from before the episode; they should be those of the preferences as the updates so
#   far have left them
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    scores = np.zeros((n, len(self.probabilities)))
    for t in range(n):
        self.look(self.states[t])
        scores[t] = -self.probabilities
        scores[t, self.actions[t]] += 1
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.preferences[state] += self.learning_rate * self.discount**t * delta * scores[t]


# %% exercise 3, wrong: the TD error
# says: that is the TD error of the actor-critic; here δ is the return less V(S_t)
def update(self, n):
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        if t < n - 1:
            delta += self.discount * self.V[self.states[t + 1]]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: the TD error, behind the end too
# says: that is the TD error of the actor-critic, and at the last step it looks up states[n], which is not of this
#   episode; here δ is the return less V(S_t)
def update(self, n):
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] + self.discount * self.V[self.states[t + 1]] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: looked at for each action
# says: the probabilities change between the actions of one step: call self.look(state) once, before that loop
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        for a in range(len(self.probabilities)):
            self.look(state)
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: the first return missing
# says: the return of the first step is missing, rewards[0] is still the reward: range(n - 1, -1, -1) goes down to 0
def update(self, n):
    G = 0.0
    for t in range(n - 1, 0, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: the first return 0
# says: the return of the first step is missing, it is still 0: range(n - 1, -1, -1) goes down to 0
def update(self, n):
    G = np.zeros(n + 1)
    for t in range(n - 1, 0, -1):
        G[t] = self.rewards[t] + self.discount * G[t + 1]
    for t in range(n):
        state = self.states[t]
        delta = G[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: the state after the step
# says: that is the state after the step, states[t + 1], not S_t
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t + 1]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: V away
# says: V moves away from the return: the sign is wrong
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] -= self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: discounted from the start
# says: G_t is discounted from step t on, and not from the start of the episode
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G += self.discount**t * self.rewards[t]
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: the last reward
# says: every step gets the last reward alone
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[n - 1]
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: times π
# says: the score is that of ln π; here the derivative of the preference is multiplied by π
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = self.probabilities[a] if a == self.actions[t] else 0.0
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: divided by π
# says: that is 1/π for the action taken; the score of a softmax is 1{a = A} − π(a|S)
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = 1.0 / self.probabilities[a] if a == self.actions[t] else 0.0
            self.preferences[state, a] += self.learning_rate * self.discount**t * delta * score


# %% exercise 3, wrong: the last state
# says: the preferences of the last state change in every step, not those of S_t
def update(self, n):
    G = 0.0
    for t in range(n - 1, -1, -1):
        G = self.rewards[t] + self.discount * G
        self.rewards[t] = G
    for t in range(n):
        state = self.states[t]
        delta = self.rewards[t] - self.V[state]
        self.V[state] += self.value_learning_rate * delta
        self.look(state)
        for a in range(len(self.probabilities)):
            score = (1.0 if a == self.actions[t] else 0.0) - self.probabilities[a]
            self.preferences[self.states[n - 1], a] += self.learning_rate * self.discount**t * delta * score
