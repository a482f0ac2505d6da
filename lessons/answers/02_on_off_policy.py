# ruff: noqa
# Right and wrong answers to the exercises of lesson 2; tests/lessons/test_answers.py tries them all.
# An answer stands in the place of the exercise's cell. Methods without their class replace those of the solution.


# %% exercise 1, right: one digit
negative_reward = -36.9

# %% exercise 1, right: two digits
negative_reward = -36.98

# %% exercise 1, right: three digits
negative_reward = -36.984

# %% exercise 1, right: by a loop downwards
R = -30.0
while len(on_off_policy.best_run(0.1, negative_reward=R - 0.1)) == 5:
    R -= 0.1
negative_reward = R

# %% exercise 1, right: by bisection
low, high = -100.0, -10.0
while high - low > 0.01:
    middle = (low + high) / 2
    if len(on_off_policy.best_run(0.1, negative_reward=middle)) == 5:
        high = middle
    else:
        low = middle
negative_reward = high

# %% exercise 1, right: over an array
values = np.arange(-45.0, -30.0, 0.1)
negative_reward = min(v for v in values if len(on_off_policy.best_run(0.1, negative_reward=v)) - 1 == 4)

# %% exercise 1, right: by the switch
negative_reward = -38.0
while on_off_policy.switch(finite_model(make_mdp("Roadrunner", negative_reward=negative_reward))) < 0.1:
    negative_reward += 0.05

# %% exercise 1, wrong: nothing was done
# says: the value with which the cell began
negative_reward = -100.0

# %% exercise 1, wrong: the placeholder
# says: Not solved yet
negative_reward = ...

# %% exercise 1, wrong: none
# says: Not solved yet
negative_reward = None

# %% exercise 1, wrong: rounded, to where the safe run is the best
# says: takes 5 steps: that is too low, by a little: take the next higher tenth
negative_reward = -37

# %% exercise 1, wrong: the estimate
# says: that is the estimate 3/ε
negative_reward = -30.0

# %% exercise 1, wrong: a slip is always deadly
# says: that is 1/ε
negative_reward = -1 / 0.1

# %% exercise 1, wrong: no minus
# says: the number must be negative
negative_reward = 37.0

# %% exercise 1, wrong: no minus, and the right tenth
# says: negative_reward = 36.9: a fall is no gain, so the number must be negative
negative_reward = 36.9

# %% exercise 1, wrong: the estimate without its minus
# says: the number must be negative
negative_reward = 3 / 0.1

# %% exercise 1, wrong: far too low
# says: is below -1 000 000
negative_reward = -1e9

# %% exercise 1, wrong: rounded to tens
# says: the best run at ε = 0.1 takes 5 steps
# says: it is too low
negative_reward = -40

# %% exercise 1, wrong: rounded to fives
# says: takes 4 steps
# says: higher than it need be
negative_reward = -35

# %% exercise 1, wrong: half a point off
# says: look at every tenth
negative_reward = -36.5

# %% exercise 1, wrong: half a point off on the other side
# says: you are close
negative_reward = -37.5

# %% exercise 1, wrong: a text
# says: leave the quotes out
negative_reward = "-37"

# %% exercise 1, wrong: the run itself
# says: take an entry of it
negative_reward = on_off_policy.best_run(0.1, negative_reward=-37)

# %% exercise 1, wrong: the function
# says: call it
negative_reward = on_off_policy.best_run

# %% exercise 1, wrong: zero
# says: takes 1 step: it is higher than it need be
negative_reward = 0

# %% exercise 1, wrong: the change of the path
# says: the *path* of the safe run changes
negative_reward = -100.0
while on_off_policy.best_run(0.1, negative_reward=negative_reward)[2] == (2, 1):
    negative_reward += 0.1

# %% exercise 1, wrong: one digit too few states
# says: it is too low
negative_reward = -100.0
while len(on_off_policy.best_run(0.1, negative_reward=negative_reward)) > 6:
    negative_reward += 0.1
negative_reward -= 1


# %% exercise 2, right: by bisection
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    low, high = 0.0, 0.2
    while high - low > 1e-4:
        middle = (low + high) / 2
        policy = value_iteration(model, epsilon=middle, horizon=50).greedy_policy()
        if policy_evaluation(model, policy, horizon=50).start < fastest:
            high = middle
        else:
            low = middle
    return high


# %% exercise 2, right: with bounds for rounding
def switch(model):
    best = value_iteration(model).start
    epsilon = 0.0
    while True:
        epsilon += 0.0005
        values = value_iteration(model, epsilon=epsilon, horizon=50)
        if policy_evaluation(model, values.greedy_policy(), horizon=50).start < best - 0.5:
            return epsilon


# %% exercise 2, right: the change of the return
def switch(model):
    def greedy_return(epsilon):
        plan = value_iteration(model, epsilon=epsilon, horizon=60)
        return policy_evaluation(model, plan.greedy_policy(), horizon=60).start

    epsilons = np.linspace(0, 0.2, 201)
    returns = np.array([greedy_return(epsilon) for epsilon in epsilons])
    return epsilons[np.argmax(returns < returns[0])]


# %% exercise 2, right: without a horizon
def switch(model):
    fastest = value_iteration(model).start
    for i in range(201):
        policy = value_iteration(model, epsilon=i / 1000).greedy_policy()
        if policy_evaluation(model, policy).start != fastest:
            return i / 1000


# %% exercise 2, right: from above
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    epsilon = 0.2
    while epsilon > 0:
        policy = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        if policy_evaluation(model, policy, horizon=50).start == fastest:
            break
        epsilon -= 0.001
    return epsilon + 0.001


# %% exercise 2, right: by playing the run
def switch(model):
    def steps(epsilon):
        policy = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        state, n = (0, 0), 0
        while not model.terminal[model.row(state)]:
            action = int(policy[model.row(state)].argmax())
            state, n = model.outcomes(state, action)[0].next_state, n + 1
        return n

    return next(e for e in np.arange(0, 0.2, 0.001) if steps(e) > steps(0.0))


# %% exercise 2, right: which of two policies is better
def switch(model):
    fast = value_iteration(model, epsilon=1e-6, horizon=50).greedy_policy()
    fastest = policy_evaluation(model, fast, horizon=50).start
    for epsilon in np.arange(0.0, 0.2, 0.0005):
        best = value_iteration(model, epsilon=epsilon, horizon=50)
        if policy_evaluation(model, best.greedy_policy(), horizon=50).start < fastest - 1e-9:
            return float(epsilon)


# %% exercise 2, wrong: not solved
# says: Not solved yet
def switch(model):
    raise NotImplementedError("not solved yet: replace this line")


# %% exercise 2, wrong: no return
# says: is a `return` missing?
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    for epsilon in np.arange(0.0, 0.2, 0.001):
        policy = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        if policy_evaluation(model, policy, horizon=50).start < fastest:
            break


# %% exercise 2, wrong: the number of the lesson
# says: the ε of the lesson's road
def switch(model):
    return 0.032


# %% exercise 2, wrong: a number, not a function
# says: should be a function of the model
switch = 0.032


# %% exercise 2, wrong: the ε-soft return
# says: played *without* slips
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    for epsilon in np.arange(0.0, 0.2, 0.001):
        if value_iteration(model, epsilon=epsilon, horizon=50).start < fastest:
            return epsilon


# %% exercise 2, wrong: the slipping policy is evaluated
# says: played *without* slips
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    for epsilon in np.arange(0.0, 0.2, 0.001):
        greedy = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        soft = (1 - epsilon) * greedy + epsilon / 3
        if policy_evaluation(model, soft, horizon=50).start < fastest:
            return epsilon


# %% exercise 2, wrong: the ε-soft return of one step more
# says: the slips lower both
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    for epsilon in np.arange(0.0, 0.2, 0.0001):
        if value_iteration(model, epsilon=epsilon, horizon=50).start < fastest - 1:
            return epsilon


# %% exercise 2, wrong: too coarse
# says: look in steps of 0.001 or smaller
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    for epsilon in np.arange(0.0, 0.2, 0.01):
        policy = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        if policy_evaluation(model, policy, horizon=50).start < fastest:
            return epsilon


# %% exercise 2, wrong: in percent
# says: in percent
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    for epsilon in np.arange(0.0, 0.2, 0.0001):
        policy = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        if policy_evaluation(model, policy, horizon=50).start < fastest:
            return 100 * epsilon


# %% exercise 2, wrong: the comparison the wrong way round
# says: the search ends at its first ε
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    for epsilon in np.arange(0.0, 0.2, 0.001):
        policy = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        if policy_evaluation(model, policy, horizon=50).start >= fastest:
            return epsilon


# %% exercise 2, wrong: never found
# says: the end of the search
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    for epsilon in np.arange(0.0, 0.2, 0.001):
        policy = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        if policy_evaluation(model, policy, horizon=50).start > fastest:
            return epsilon
    return 0.2


# %% exercise 2, wrong: the estimate
# says: that is the estimate, 3 divided by
def switch(model):
    return 3 / abs(model.mdp.negative_reward)


# %% exercise 2, wrong: epsilon is not given to the planner
# says: is a `return` missing?
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    for epsilon in np.arange(0.0, 0.2, 0.001):
        policy = value_iteration(model, horizon=50).greedy_policy()
        if policy_evaluation(model, policy, horizon=50).start < fastest:
            return epsilon


# %% exercise 2, wrong: the policy for the values
# says: raises
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    for epsilon in np.arange(0.0, 0.2, 0.001):
        policy = value_iteration(model, epsilon=epsilon, horizon=50)
        if policy_evaluation(model, policy, horizon=50).start < fastest:
            return epsilon


# %% exercise 2, wrong: values instead of their start
# says: raises
def switch(model):
    fastest = value_iteration(model, horizon=50)
    for epsilon in np.arange(0.0, 0.2, 0.001):
        policy = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        if policy_evaluation(model, policy, horizon=50) < fastest.start:
            return epsilon


# %% exercise 2, wrong: the lesson's model
# says: the ε of the lesson's road
def switch(model):
    return on_off_policy.switch(finite_model(make_mdp("Roadrunner")))


# %% exercise 2, wrong: a list
# says: take an entry of it
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    found = []
    for epsilon in np.arange(0.0, 0.2, 0.01):
        policy = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        if policy_evaluation(model, policy, horizon=50).start < fastest:
            found.append(epsilon)
    return found


# %% exercise 2, wrong: no parameter
# says: its parameters are not those of the exercise
def switch():
    return 0.032


# %% exercise 3, right: a sum and a length
def learn(self, state, action, reward, next_state, terminated):
    row = self.Q[next_state]
    v = (1 - self.target_epsilon) * row.max() + self.target_epsilon * row.sum() / len(row)
    if terminated:
        v = 0
    self.Q[state, action] += self.learning_rate * (reward + self.discount * v - self.Q[state, action])


# %% exercise 3, right: probabilities of the actions
def learn(self, state, action, reward, next_state, terminated):
    n = self.Q.shape[1]
    best = np.argmax(self.Q[next_state])
    value = 0.0
    for a in range(n):
        p = self.target_epsilon / n
        if a == best:
            p += 1 - self.target_epsilon
        value += p * self.Q[next_state, a]
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, right: the package's functions
def learn(self, state, action, reward, next_state, terminated):
    value = epsilon_greedy_value(self.Q, next_state, self.target_epsilon)
    target = one_step_target(reward, self.discount, value, terminated)
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, right: a weighted mean of old and new
def learn(self, state, action, reward, next_state, terminated):
    e = self.target_epsilon
    future = (1 - e) * np.max(self.Q[next_state]) + e * self.Q[next_state].mean()
    target = reward + self.discount * future * (not terminated)
    self.Q[state, action] = (1 - self.learning_rate) * self.Q[state, action] + self.learning_rate * target


# %% exercise 3, right: the error first
def learn(self, state, action, reward, next_state, terminated):
    delta = reward - self.Q[state, action]
    if not terminated:
        delta += self.discount * (1 - self.target_epsilon) * max(self.Q[next_state])
        delta += self.discount * self.target_epsilon * sum(self.Q[next_state]) / self.Q.shape[1]
    self.Q[state, action] += self.learning_rate * delta


# %% exercise 3, right: more parameters than needed
def learn(self, state, action, reward, next_state, next_action, terminated, truncated):
    value = 0.0
    if not terminated:
        value = self.target_epsilon * np.mean(self.Q[next_state])
        value = value + (1.0 - self.target_epsilon) * self.Q[next_state].max()
    self.Q[state][action] += self.learning_rate * (reward + self.discount * value - self.Q[state][action])


# %% exercise 3, right: a plain class
class TwoPolicies:
    def __init__(self, Q, learning_rate=0.03, discount=1.0, epsilon=0.1, target_epsilon=0.1):
        self.Q, self.learning_rate, self.discount = Q, learning_rate, discount
        self.epsilon, self.target_epsilon = epsilon, target_epsilon

    @classmethod
    def create(cls, environment, **settings):
        return cls(np.zeros(table_size(environment)), **settings)

    def act(self, state, rng):
        if rng.random() < self.epsilon:
            return int(rng.integers(self.Q.shape[1]))
        return int(rng.choice(np.flatnonzero(self.Q[state] == self.Q[state].max())))

    def learn(self, state, action, reward, next_state, terminated):
        value = (1 - self.target_epsilon) * self.Q[next_state].max() + self.target_epsilon * self.Q[next_state].mean()
        target = reward + (0.0 if terminated else self.discount * value)
        self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: not solved
# says: Not solved yet
def learn(self, state, action, reward, next_state, terminated):
    raise NotImplementedError("not solved yet: replace this line")


# %% exercise 3, wrong: nothing
# says: changes no table at all
def learn(self, state, action, reward, next_state, terminated): ...


# %% exercise 3, wrong: the target is returned
# says: it returns something instead
def learn(self, state, action, reward, next_state, terminated):
    value = (1 - self.target_epsilon) * max(self.Q[next_state]) + self.target_epsilon * np.mean(self.Q[next_state])
    return reward + self.discount * value


# %% exercise 3, wrong: Q-learning
# says: the maximum alone is Q-learning
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: SARSA
# says: that is SARSA
def learn(self, state, action, reward, next_state, next_action, terminated):
    target = reward if terminated else reward + self.discount * self.Q[next_state, next_action]
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: the other epsilon
# says: with which the agent acts
def learn(self, state, action, reward, next_state, terminated):
    value = (1 - self.epsilon) * max(self.Q[next_state]) + self.epsilon * np.mean(self.Q[next_state])
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: weights interchanged
# says: have changed places
def learn(self, state, action, reward, next_state, terminated):
    value = self.target_epsilon * max(self.Q[next_state]) + (1 - self.target_epsilon) * np.mean(self.Q[next_state])
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: the sum for the mean
# says: the sum over the actions
def learn(self, state, action, reward, next_state, terminated):
    value = (1 - self.target_epsilon) * max(self.Q[next_state]) + self.target_epsilon * sum(self.Q[next_state])
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: the mean of the others
# says: a random action may be the best one too
def learn(self, state, action, reward, next_state, terminated):
    row = self.Q[next_state]
    others = (sum(row) - max(row)) / (len(row) - 1)
    value = (1 - self.target_epsilon) * max(row) + self.target_epsilon * others
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: three actions
# says: it divides by 3
def learn(self, state, action, reward, next_state, terminated):
    row = self.Q[next_state]
    value = (1 - self.target_epsilon) * max(row) + self.target_epsilon * sum(row) / 3
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: terminated forgotten
# says: a terminal state has no future
def learn(self, state, action, reward, next_state, terminated):
    value = (1 - self.target_epsilon) * max(self.Q[next_state]) + self.target_epsilon * np.mean(self.Q[next_state])
    target = reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: only the mean
# says: the plain mean is right only for
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * np.mean(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: the maximum in full
# says: the maximum counts in full
def learn(self, state, action, reward, next_state, terminated):
    value = max(self.Q[next_state]) + self.target_epsilon * np.mean(self.Q[next_state])
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: the mean is missing
# says: the mean over the random actions is missing
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * (1 - self.target_epsilon) * max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: the number of the best action
# says: argmax gives the *number*
def learn(self, state, action, reward, next_state, terminated):
    row = self.Q[next_state]
    value = (1 - self.target_epsilon) * np.argmax(row) + self.target_epsilon * np.mean(row)
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: the mean of the whole table
# says: the mean is taken over the whole table
def learn(self, state, action, reward, next_state, terminated):
    value = (1 - self.target_epsilon) * max(self.Q[next_state]) + self.target_epsilon * np.mean(self.Q)
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: the state that was left
# says: the state that was left
def learn(self, state, action, reward, next_state, terminated):
    value = (1 - self.target_epsilon) * max(self.Q[state]) + self.target_epsilon * np.mean(self.Q[state])
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: no brackets around the two terms
# says: Q(S, A)
def learn(self, state, action, reward, next_state, terminated):
    value = (1 - self.target_epsilon) * max(self.Q[next_state]) + self.target_epsilon * np.mean(self.Q[next_state])
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] = self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: a fixed learning rate
# says: a learning rate of 0.03
def learn(self, state, action, reward, next_state, terminated):
    value = (1 - self.target_epsilon) * max(self.Q[next_state]) + self.target_epsilon * np.mean(self.Q[next_state])
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += 0.03 * (target - self.Q[state, action])


# %% exercise 3, wrong: a fixed target policy
# says: an ε_π of 0.1
def learn(self, state, action, reward, next_state, terminated):
    value = 0.9 * max(self.Q[next_state]) + 0.1 * np.mean(self.Q[next_state])
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: no discount
# says: not discounted
def learn(self, state, action, reward, next_state, terminated):
    value = (1 - self.target_epsilon) * max(self.Q[next_state]) + self.target_epsilon * np.mean(self.Q[next_state])
    target = reward if terminated else reward + value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: self is forgotten
# says: write `self.` before a field
def learn(self, state, action, reward, next_state, terminated):
    value = (1 - target_epsilon) * max(self.Q[next_state]) + target_epsilon * np.mean(self.Q[next_state])
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: nothing is learned at the end
# says: at the end of an episode nothing is learned
def learn(self, state, action, reward, next_state, terminated):
    if terminated:
        return
    value = (1 - self.target_epsilon) * max(self.Q[next_state]) + self.target_epsilon * np.mean(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])


# %% exercise 3, wrong: an agent instead of the class
# says: should be the class
class Agent(NamedTuple):
    Q: np.ndarray


TwoPolicies = Agent(np.zeros((3, 3)))


# %% exercise 3, wrong: a field is missing
# says: should keep its field `target_epsilon`
class TwoPolicies(NamedTuple):
    Q: np.ndarray
    learning_rate: float = 0.03
    discount: float = 1.0
    epsilon: float = 0.1

    def act(self, state, rng):
        return 0

    def learn(self, state, action, reward, next_state, terminated):
        target = reward if terminated else reward + self.discount * max(self.Q[next_state])
        self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])
