# ruff: noqa
# Right and wrong answers to the exercises of lesson 0; tests/lessons/test_answers.py tries them all.
# An answer stands in the place of the exercise's cell. Methods without their class replace those of the solution.


# %% setup
from edugym.agents.tables import one_step_target


# %% exercise 1, right: forwards with a growing power
# says: Right. From the last reward to the first, one multiplication a step is enough, and no power of γ is needed.
def discounted_return(rewards, discount):
    total, weight = 0.0, 1.0
    for reward in rewards:
        total += weight * reward
        weight *= discount
    return total


# %% exercise 1, right: powers
def discounted_return(rewards, discount):
    return sum(discount**k * reward for k, reward in enumerate(rewards))


# %% exercise 1, right: recursive
def discounted_return(rewards, discount):
    if not rewards:
        return 0
    return rewards[0] + discount * discounted_return(rewards[1:], discount)


# %% exercise 1, right: NumPy
def discounted_return(rewards, discount):
    return np.dot(rewards, discount ** np.arange(len(rewards)))


# %% exercise 1, right: reversed by a slice
def discounted_return(rewards, discount):
    G = 0
    for r in rewards[::-1]:
        G = discount * G + r
    return G


# %% exercise 1, right: indices
def discounted_return(rewards, discount):
    G = 0
    for t in range(len(rewards) - 1, -1, -1):
        G = rewards[t] + discount * G
    return float(G)


# %% exercise 1, right: reduce
from functools import reduce

discounted_return = lambda rewards, discount: reduce(lambda G, r: r + discount * G, rewards[::-1], 0)


# %% exercise 1, right: an array without axes
def discounted_return(rewards, discount):
    return np.sum(np.array(rewards) * np.power(discount, np.arange(len(rewards))), keepdims=False)


# %% exercise 1, right: from the last reward on
def discounted_return(rewards, discount):
    G = rewards[-1]
    for reward in reversed(rewards[:-1]):
        G = reward + discount * G
    return G


# %% exercise 1, wrong: not solved
# says: Not solved yet
def discounted_return(rewards, discount):
    raise NotImplementedError("not solved yet: replace this line")


# %% exercise 1, wrong: no return
# says: is a `return` missing?
def discounted_return(rewards, discount):
    G = 0
    for reward in reversed(rewards):
        G = reward + discount * G


# %% exercise 1, wrong: the sum
# says: that is the sum without a discount
def discounted_return(rewards, discount):
    return sum(rewards)


# %% exercise 1, wrong: the first reward is discounted
# says: the first reward counts in full, γ^0 = 1; here everything is discounted once too often
def discounted_return(rewards, discount):
    return sum(discount ** (k + 1) * reward for k, reward in enumerate(rewards))


# %% exercise 1, wrong: backwards, all discounted
# says: here everything is discounted once too often
def discounted_return(rewards, discount):
    G = 0
    for reward in reversed(rewards):
        G = discount * (reward + G)
    return G


# %% exercise 1, wrong: forwards with the backward rule
# says: the discount goes the wrong way: the *last* reward counts in full; use reversed(rewards)
def discounted_return(rewards, discount):
    G = 0
    for reward in rewards:
        G = reward + discount * G
    return G


# %% exercise 1, wrong: one discount for all
# says: all later rewards are discounted by the same γ; a reward k steps later counts γ^k times
def discounted_return(rewards, discount):
    return rewards[0] + discount * sum(rewards[1:])


# %% exercise 1, wrong: the discount outside
# says: the whole sum is multiplied by γ once; a reward k steps later counts γ^k times
def discounted_return(rewards, discount):
    return discount * sum(rewards)


# %% exercise 1, wrong: times for power
# says: that is γ · k, and it should be γ^k: `**` is the power
def discounted_return(rewards, discount):
    return sum(discount * k * reward for k, reward in enumerate(rewards))


# %% exercise 1, wrong: base and exponent
# says: the weight is k^γ or γ*k in the place of γ^k: `**` is the power, and γ stands before it
def discounted_return(rewards, discount):
    return sum(k**discount * reward for k, reward in enumerate(rewards))


# %% exercise 1, wrong: the caret
# says: TypeError
def discounted_return(rewards, discount):
    return sum(discount ^ k * reward for k, reward in enumerate(rewards))


# %% exercise 1, wrong: the mean
# says: the mean is taken; a return is a sum
def discounted_return(rewards, discount):
    return sum(discount**k * reward for k, reward in enumerate(rewards)) / max(len(rewards), 1)


# %% exercise 1, wrong: the last one is left out
# says: the last reward is left out
def discounted_return(rewards, discount):
    return sum(discount**k * rewards[k] for k in range(len(rewards) - 1))


# %% exercise 1, wrong: counted from 1
# says: the first reward is left out
def discounted_return(rewards, discount):
    return sum(discount**k * rewards[k] for k in range(1, len(rewards)))


# %% exercise 1, wrong: backwards, but not to the first
# says: the first reward is left out, and the second one counts in full
def discounted_return(rewards, discount):
    G = 0
    for t in range(len(rewards) - 1, 0, -1):
        G = rewards[t] + discount * G
    return G


# %% exercise 1, wrong: return inside the loop
# says: that is the first reward alone
def discounted_return(rewards, discount):
    G = 0
    for k, reward in enumerate(rewards):
        G += discount**k * reward
        return G


# %% exercise 1, wrong: return inside the backward loop
# says: that is the last reward alone
def discounted_return(rewards, discount):
    G = 0
    for reward in reversed(rewards):
        G = reward + discount * G
        return G


# %% exercise 1, wrong: G is overwritten
# says: that is the first reward alone
def discounted_return(rewards, discount):
    G = 0
    for reward in reversed(rewards):
        G = reward
    return G


# %% exercise 1, wrong: all returns
# says: gives several numbers: only the return from the first step on is asked for
def discounted_return(rewards, discount):
    returns = []
    G = 0
    for reward in reversed(rewards):
        G = reward + discount * G
        returns.append(G)
    return returns[::-1]


# %% exercise 1, wrong: the list is used up
# says: changes the list of rewards that it is given: work on a copy, or only read it
def discounted_return(rewards, discount):
    G = 0
    while rewards:
        G = rewards.pop() + discount * G
    return G


# %% exercise 1, wrong: 1 minus the discount
# says: 1 − γ stands in the place of γ
def discounted_return(rewards, discount):
    return sum((1 - discount) ** k * reward for k, reward in enumerate(rewards))


# %% exercise 1, wrong: the discount of the cell above
# says: 0.5, the discount of the cell under equation 3.9, stands where `discount` should
def discounted_return(rewards, discount):
    G = 0.0
    for reward in reversed(rewards):
        G = reward + 0.5 * G
    return G


# %% exercise 1, wrong: the old return is added twice
# says: is the old G added once more, by `+=`? Write `G = reward + discount * G`
def discounted_return(rewards, discount):
    G = 0.0
    for reward in reversed(rewards):
        G += reward + discount * G
    return G


# %% exercise 1, wrong: a number
# says: should be a function
# says: rewards and discount
discounted_return = 4 + 0.5 * 2


# %% exercise 1, wrong: backwards from 1
# says: the discount goes the wrong way, and once too often: the first reward counts in full
def discounted_return(rewards, discount):
    return sum(discount ** (len(rewards) - k) * reward for k, reward in enumerate(rewards))


# %% exercise 1, wrong: divided by powers
# says: the rewards are divided by γ^k; multiply
def discounted_return(rewards, discount):
    return sum(reward / (discount**k or 1.0) for k, reward in enumerate(rewards))


# %% exercise 1, wrong: the plain mean
# says: that is the mean
def discounted_return(rewards, discount):
    return sum(rewards) / len(rewards)


# %% exercise 1, wrong: the last one, discounted
# says: that is the last reward with its discount; add all of them up
def discounted_return(rewards, discount):
    return discount ** (len(rewards) - 1) * rewards[-1]


# %% exercise 1, wrong: two rewards
# says: only the first two rewards count: is `return` inside the loop?
def discounted_return(rewards, discount):
    G = rewards[0]
    for k in range(1, len(rewards)):
        return G + discount * rewards[k]
    return G


# %% exercise 1, wrong: a mean of weights
# says: it is multiplied by 1 − γ; the return is a sum, not a mean
def discounted_return(rewards, discount):
    return (1 - discount) * sum(discount**k * reward for k, reward in enumerate(rewards))


# %% exercise 1, wrong: costs for rewards
# says: the sign is wrong
def discounted_return(rewards, discount):
    return -sum(discount**k * reward for k, reward in enumerate(rewards))


# %% exercise 1, wrong: the discount squared
# says: γ is squared
def discounted_return(rewards, discount):
    return sum(discount ** (2 * k) * reward for k, reward in enumerate(rewards))


# %% exercise 1, wrong: another name in the loop
# says: it stays 0: is `G` changed in the loop?
def discounted_return(rewards, discount):
    G = 0
    for reward in reversed(rewards):
        g = reward + discount * G
    return G


# %% exercise 2, right: rounds about the exploring
# says: Right: an action that ties is as good as the first one, so each of them gets its share.
def choose(values, epsilon, rng):
    if rng.random() >= epsilon:
        best = [a for a in range(len(values)) if values[a] == max(values)]
        return best[int(rng.random() * len(best))]
    return int(rng.random() * len(values))


# %% exercise 2, right: argmax of a shuffled order
def choose(values, epsilon, rng):
    if rng.uniform() < epsilon:
        return int(rng.integers(0, len(values)))
    order = rng.permutation(len(values))
    return int(order[np.argmax(values[order])])


# %% exercise 2, right: probabilities
def choose(values, epsilon, rng):
    n = len(values)
    best = values == values.max()
    p = epsilon / n + (1 - epsilon) * best / best.sum()
    return rng.choice(n, p=p)


# %% exercise 2, right: one loop
def choose(values, epsilon, rng):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    best, ties = 0, 1
    for action in range(1, len(values)):
        if values[action] > values[best]:
            best, ties = action, 1
        elif values[action] == values[best]:
            ties += 1
            if rng.random() < 1 / ties:
                best = action
    return best


# %% exercise 2, right: a tiny noise
def choose(values, epsilon, rng):
    if rng.random() < epsilon:
        return rng.integers(values.size)
    return np.argmax(values + 1e-9 * rng.random(values.size))


# %% exercise 2, right: argwhere
def choose(values, epsilon, rng):
    explore = rng.binomial(1, epsilon)
    if explore:
        return rng.choice(len(values))
    return rng.choice(np.argwhere(values == np.max(values)).ravel())


# %% exercise 2, wrong: not solved
# says: Not solved yet
def choose(values, epsilon, rng):
    raise NotImplementedError("not solved yet: replace this line")


# %% exercise 2, wrong: the first of equals
# says: ties should be broken at random, and it takes the first of equals
# says: choose(values, epsilon, rng)
def choose(values, epsilon, rng):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return np.argmax(values)


# %% exercise 2, wrong: the last of equals
# says: ties should be broken at random, and it takes the last of equals
# says: , should choose
def choose(values, epsilon, rng):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return max(range(len(values)), key=lambda action: (values[action], action))


# %% exercise 2, wrong: never explores
# says: it never explores: what is `epsilon` for?
def choose(values, epsilon, rng):
    return rng.choice(np.flatnonzero(values == values.max()))


# %% exercise 2, wrong: the wrong way round
# says: ε and 1 − ε have changed places: it explores with probability 1 − ε
def choose(values, epsilon, rng):
    if rng.random() > epsilon:
        return rng.integers(len(values))
    return rng.choice(np.flatnonzero(values == values.max()))


# %% exercise 2, wrong: the others only
# says: a random action may be the best one too; this one is drawn among the others only
def choose(values, epsilon, rng):
    best = np.flatnonzero(values == values.max())
    if rng.random() < epsilon:
        others = np.flatnonzero(values < values.max())
        return rng.choice(others if len(others) else best)
    return rng.choice(best)


# %% exercise 2, wrong: argmin
# says: it takes the *lowest* value
def choose(values, epsilon, rng):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return rng.choice(np.flatnonzero(values == values.min()))


# %% exercise 2, wrong: the value
# says: should give the number of an action, a whole number, but gives
def choose(values, epsilon, rng):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return values.max()


# %% exercise 2, wrong: all best actions
# says: return one of its entries, drawn with rng.choice
def choose(values, epsilon, rng):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return np.flatnonzero(values == values.max())


# %% exercise 2, wrong: four actions
# says: should give an action from 0 to 2
def choose(values, epsilon, rng):
    if rng.random() < epsilon:
        return rng.integers(4)
    return rng.choice(np.flatnonzero(values == values.max())) if len(values) == 4 else 3


# %% exercise 2, wrong: never the last
# says: the random action is never the last one: `rng.integers(n)` is from 0 to n − 1 already
def choose(values, epsilon, rng):
    if rng.random() < epsilon:
        return rng.integers(len(values) - 1)
    return rng.choice(np.flatnonzero(values == values.max()))


# %% exercise 2, wrong: one too many
# says: should give an action from 0 to 3, but gives 4
def choose(values, epsilon, rng):
    if rng.random() < epsilon:
        return rng.integers(len(values) + 1)
    return rng.choice(np.flatnonzero(values == values.max()))


# %% exercise 2, wrong: other random numbers
# says: does not draw its random numbers from `rng`, so that no run can be repeated: use rng.random()
def choose(values, epsilon, rng):
    if np.random.random() < epsilon:
        return np.random.randint(len(values))
    return np.random.choice(np.flatnonzero(values == values.max()))


# %% exercise 2, wrong: a generator of its own
# says: makes a new generator in each call, so it draws the same number every time: use the `rng` that it is given
def choose(values, epsilon, rng):
    rng = np.random.default_rng(0)
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return rng.choice(np.flatnonzero(values == values.max()))


# %% exercise 2, wrong: a new seed in each call
# says: it draws the same number every time: use the `rng`
def choose(values, epsilon, rng):
    np.random.seed(1)
    if np.random.rand() < epsilon:
        return np.random.randint(len(values))
    return np.random.choice(np.flatnonzero(values == values.max()))


# %% exercise 2, wrong: no return when greedy
# says: is a `return` missing?
def choose(values, epsilon, rng):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    rng.choice(np.flatnonzero(values == values.max()))


# %% exercise 2, wrong: starts from zero
# says: should choose action 3
def choose(values, epsilon, rng):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    best, highest = 0, 0
    for action, value in enumerate(values):
        if value > highest:
            best, highest = action, value
    return best


# %% exercise 2, wrong: sorts the values
# says: changes the table `values`
# says: `: choosing must change nothing, `learn` does that
def choose(values, epsilon, rng):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    best = rng.choice(np.flatnonzero(values == values.max()))
    values.sort()
    return best


# %% exercise 2, wrong: always random
# says: it always acts at random: it should take the highest value with probability 1 − ε
def choose(values, epsilon, rng):
    return rng.integers(len(values))


# %% exercise 2, wrong: action 0 when exploring
# says: its random action is always action 0
def choose(values, epsilon, rng):
    if rng.random() < epsilon:
        return 0
    return rng.choice(np.flatnonzero(values == values.max()))


# %% exercise 2, wrong: the number of the highest value
# says: values, epsilon and rng
choose = 1


# %% exercise 3, right: in steps
# says: Right: that is all of Q-learning. See it race:
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0
    if not terminated:
        value = np.max(self.Q[next_state])
    error = reward + self.discount * value - self.Q[state, action]
    self.Q[state, action] += self.learning_rate * error


# %% exercise 3, right: a weighted mean
def learn(self, state, action, reward, next_state, terminated):
    target = reward + (1 - terminated) * self.discount * self.Q[next_state].max()
    self.Q[state, action] = (1 - self.learning_rate) * self.Q[state, action] + self.learning_rate * target


# %% exercise 3, right: the package's pieces
def learn(self, state, action, reward, next_state, terminated):
    target = one_step_target(reward, self.discount, max(self.Q[next_state]), terminated)
    self.Q[state][action] += self.learning_rate * (target - self.Q[state][action])


# %% exercise 3, right: a loop for the maximum
def learn(self, state, action, reward, next_state, terminated):
    best = self.Q[next_state, 0]
    for value in self.Q[next_state]:
        if value > best:
            best = value
    if terminated:
        best = 0.0
    self.Q[state, action] += self.learning_rate * (reward + self.discount * best - self.Q[state, action])


# %% exercise 3, right: argmax
def learn(self, state, action, reward, next_state, terminated):
    target = reward
    if not terminated:
        target += self.discount * self.Q[next_state, np.argmax(self.Q[next_state])]
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, right: truncated is taken and not used
def learn(self, state, action, reward, next_state, terminated, truncated):
    if terminated:
        target = reward
    else:
        target = reward + self.discount * max(self.Q[next_state])
    self.Q[state, action] -= self.learning_rate * (self.Q[state, action] - target)


# %% exercise 3, right: parameters in another order
def learn(self, reward, terminated, next_state, action, state):
    target = reward if terminated else reward + self.discount * max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, right: the table is the last field
class MyAgent(NamedTuple):
    learning_rate: float = 0.5
    discount: float = 0.99
    Q: np.ndarray = np.zeros((1, 1))

    def act(self, state, rng):
        return 0

    def learn(self, state, action, reward, next_state, terminated):
        target = reward if terminated else reward + self.discount * max(self.Q[next_state])
        self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, right: settings by name
class MyAgent:
    def __init__(self, Q, **settings):
        self.Q = Q
        self.__dict__.update(settings)

    def act(self, state, rng):
        return 0

    def learn(self, state, action, reward, next_state, terminated):
        target = reward if terminated else reward + self.discount * max(self.Q[next_state])
        self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: not solved
# says: Not solved yet
def learn(self, state, action, reward, next_state, terminated):
    raise NotImplementedError("not solved yet: replace this line")


# %% exercise 3, wrong: nothing after the end is forgotten
# says: a terminal state has no future: its value is 0, so leave γ max_a Q(S', a) out when `terminated`
def learn(self, state, action, reward, next_state, terminated):
    target = reward + self.discount * max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: the reward alone
# says: the value of the next state is missing, γ max_a Q(S', a): without bootstrapping nothing is carried back
def learn(self, state, action, reward, next_state, terminated):
    self.Q[state, action] += self.learning_rate * (reward - self.Q[state, action])


# %% exercise 3, wrong: the mean
# says: the mean over the actions stands where the maximum should
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * self.Q[next_state].mean()
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: no discount
# says: the value of the next state is not discounted: multiply it by γ
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: the old value is missing
# says: − Q(S, A) is missing in the brackets: move by a share of the *difference* between target and Q(S, A)
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * target


# %% exercise 3, wrong: set instead of add
# says: the old value is lost: write `+=`, for the update is added to Q(S, A)
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * max(self.Q[next_state])
    self.Q[state, action] = self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: the state that was left
# says: the maximum is taken over Q(S, a), the state that was left, instead of Q(S', a)
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * max(self.Q[state])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: no self
# says: write `self.` before a field
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + discount * max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: the numbers of the lesson
# says: a learning rate of 0.5
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + 0.99 * max(self.Q[next_state])
    self.Q[state, action] += 0.5 * (target - self.Q[state, action])


# %% exercise 3, wrong: the wrong sign
# says: the sign is wrong: it moves away from the target
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * max(self.Q[next_state])
    self.Q[state, action] -= self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: the brackets
# says: α belongs to the whole bracket, not to Q(S, A) alone
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * max(self.Q[next_state])
    self.Q[state, action] += target - self.learning_rate * self.Q[state, action]


# %% exercise 3, wrong: the test is the wrong way round
# says: the test of `terminated` is the wrong way round
def learn(self, state, action, reward, next_state, terminated):
    target = reward + self.discount * max(self.Q[next_state]) if terminated else reward
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: truncated like terminated
# says: a truncated episode is treated as terminated, but only its clock ran out: the value of the next state still
#   counts
def learn(self, state, action, reward, next_state, terminated, truncated):
    target = reward if terminated or truncated else reward + self.discount * max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: nothing is stored
# says: `learn` changes no table at all; it returns something instead
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * max(self.Q[next_state])
    return self.Q[state, action] + self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: argmax for max
# says: argmax gives the *number* of the best action; its value is needed, max
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * np.argmax(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: the whole row
# says: and only one should
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * max(self.Q[next_state])
    self.Q[state] += self.learning_rate * (target - self.Q[state])


# %% exercise 3, wrong: max of the table
# says: the maximum is taken over the whole table instead of the row of the next state
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * self.Q.max()
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: an instance
# says: should be the class
MyAgent = QLearning.create((6, 3))


# %% exercise 3, wrong: made with brackets
# says: MyAgent should be the class itself, but is what MyAgent(...) makes
# says: (...) makes: leave the brackets out
class MyAgent(NamedTuple):
    Q: np.ndarray
    learning_rate: float = 0.5
    discount: float = 0.99

    def act(self, state, rng):
        return 0

    def learn(self, state, action, reward, next_state, terminated):
        target = reward if terminated else reward + self.discount * max(self.Q[next_state])
        self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


MyAgent = MyAgent(np.zeros((800, 4)))


# %% exercise 3, wrong: a discount without its type
# says: MyAgent should keep its field `discount`
class MyAgent(NamedTuple):
    Q: np.ndarray
    learning_rate: float = 0.5
    discount = 0.99

    def act(self, state, rng):
        return 0

    def learn(self, state, action, reward, next_state, terminated):
        target = reward if terminated else reward + self.discount * max(self.Q[next_state])
        self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: the table has another name
# says: MyAgent should keep its field `Q`, the table
class MyAgent(NamedTuple):
    table: np.ndarray
    learning_rate: float = 0.5
    discount: float = 0.99

    def act(self, state, rng):
        return 0

    def learn(self, state, action, reward, next_state, terminated):
        target = reward if terminated else reward + self.discount * max(self.table[next_state])
        self.table[state, action] += self.learning_rate * (target - self.table[state, action])


# %% exercise 3, wrong: the minimum
# says: the minimum over the actions stands where the maximum should
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else min(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])


# %% exercise 3, wrong: the sum
# says: the sum over the actions stands where the maximum should
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else sum(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])


# %% exercise 3, wrong: the same action
# says: Q(S', A), the value of the *same* action, stands where the maximum over all actions should
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else self.Q[next_state, action]
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])


# %% exercise 3, wrong: the old value
# says: Q(S, A) stands where the maximum of Q(S', a) should
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else self.Q[state, action]
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])


# %% exercise 3, wrong: a maximum that starts from 0
# says: the maximum starts from 0, so a row of negative values counts as 0
def learn(self, state, action, reward, next_state, terminated):
    best = 0.0
    for a in range(self.Q.shape[1]):
        if self.Q[next_state, a] > best and not terminated:
            best = self.Q[next_state, a]
    self.Q[state, action] += self.learning_rate * (reward + self.discount * best - self.Q[state, action])


# %% exercise 3, wrong: the first action
# says: only the first action of the next state is looked at
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else self.Q[next_state, 0]
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])


# %% exercise 3, wrong: the last action
# says: only the last action of the next state is looked at
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else self.Q[next_state, -1]
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])


# %% exercise 3, wrong: two actions
# says: only the first two actions of the next state are looked at, and there may be more
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else max(self.Q[next_state, 0], self.Q[next_state, 1])
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])


# %% exercise 3, wrong: the largest size
# says: the largest absolute value stands where the maximum should
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else np.abs(self.Q[next_state]).max()
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])


# %% exercise 3, wrong: nothing at the end
# says: at the end of an episode the reward is lost: only the *value of the next state* is 0 there
def learn(self, state, action, reward, next_state, terminated):
    target = (reward + self.discount * self.Q[next_state].max()) * (not terminated)
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: the reward discounted
# says: the reward is discounted; γ belongs to the value of the next state only
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else self.Q[next_state].max()
    self.Q[state, action] += self.learning_rate * (self.discount * (reward + value) - self.Q[state, action])


# %% exercise 3, wrong: a share of the target
# says: the old value is lost: α times the target is not Q(S, A) + α [target − Q(S, A)]
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else self.Q[next_state].max()
    self.Q[state, action] = self.learning_rate * (reward + self.discount * value)


# %% exercise 3, wrong: the weights exchanged
# says: α and 1 − α have changed places
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else self.Q[next_state].max()
    self.Q[state, action] += (1 - self.learning_rate) * (reward + self.discount * value - self.Q[state, action])


# %% exercise 3, wrong: the next row
# says: it is Q[next_state, action] that changes, and it should be Q[state, action]
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else self.Q[next_state].max()
    self.Q[next_state, action] += self.learning_rate * (reward + self.discount * value - self.Q[next_state, action])


# %% exercise 3, wrong: the old value shrinks first
# says: Q(S, A) changes before the maximum is taken: compute the whole target from the old Q
def learn(self, state, action, reward, next_state, terminated):
    self.Q[state, action] *= 1 - self.learning_rate
    value = 0.0 if terminated else self.Q[next_state].max()
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value)


# %% exercise 3, wrong: nothing is learned at the end
# says: at the end of an episode nothing is learned, and that is where the reward is
def learn(self, state, action, reward, next_state, terminated):
    if not terminated:
        target = reward + self.discount * self.Q[next_state].max()
        self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: the next action
# says: Q(S', A'), the value of the action that comes next, stands where the maximum should: that is SARSA
def learn(self, state, action, reward, next_state, next_action, terminated):
    value = 0.0 if terminated else self.Q[next_state, next_action]
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])


# %% exercise 3, wrong: discounted twice
# says: the value of the next state is discounted twice
def learn(self, state, action, reward, next_state, terminated):
    value = 0.0 if terminated else self.discount * max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])
