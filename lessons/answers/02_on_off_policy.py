# ruff: noqa
# Right and wrong answers to the exercises of lesson 2; tests/lessons/test_answers.py tries them all.
# An answer stands in the place of the exercise's cell. Methods without their class replace those of the solution.


# %% exercise 1, right: one digit
# says: Right: just above -37. The estimate of the lesson gives -30, since it looks at the last step alone. The safe run
#   slips too, and for one step more.
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
# says: that is the value with which the cell began
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
# says: that is the estimate 3/ε, which leaves out all slips but the last; let best_run work it out exactly
negative_reward = -30.0

# %% exercise 1, wrong: a slip is always deadly
# says: that is 1/ε; a random action is the deadly one in only one of three cases, and the rest of the run slips too
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
# says: too low, and the fast run of 4 steps should be best
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
# says: ; you are close, look at every tenth
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
# says: there the *path* of the safe run changes; the number of its steps changes elsewhere
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
# says: Right: planning on the model finds at once what expected SARSA needs thousands of steps for. (It is close to 3
#   divided by the cost of a fall where one step more avoids the one deadly action.)
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
# says: switch(model) for W =
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    for epsilon in np.arange(0.0, 0.2, 0.001):
        policy = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        if policy_evaluation(model, policy, horizon=50).start < fastest:
            break


# %% exercise 2, wrong: the number of the lesson
# says: that is the ε of the lesson's road; compute it from the `model` that is given
# says: and negative_reward =
def switch(model):
    return 0.032


# %% exercise 2, wrong: a number, not a function
# says: should be a function of the model
switch = 0.032


# %% exercise 2, wrong: the ε-soft return
# says: that is the first ε above 0 of a search: compare the *return* of the greedy policy, played *without* slips,
#   since the ε-soft return is always lower, and two policies may differ where no run leads
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
# says: that is where the ε-soft return falls below that of a run with one step more; the slips lower both
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    for epsilon in np.arange(0.0, 0.2, 0.0001):
        if value_iteration(model, epsilon=epsilon, horizon=50).start < fastest - 1:
            return epsilon


# %% exercise 2, wrong: too coarse
# says: that is close, but look in steps of 0.001 or smaller
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    for epsilon in np.arange(0.0, 0.2, 0.01):
        policy = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        if policy_evaluation(model, policy, horizon=50).start < fastest:
            return epsilon


# %% exercise 2, wrong: in percent
# says: that is in percent
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    for epsilon in np.arange(0.0, 0.2, 0.0001):
        policy = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        if policy_evaluation(model, policy, horizon=50).start < fastest:
            return 100 * epsilon


# %% exercise 2, wrong: the comparison the wrong way round
# says: the search ends at its first ε: is the return of the fastest run that of *this* `model`, and is it compared,
#   with `<`, with the greedy policy for ε, played *without* slips?
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    for epsilon in np.arange(0.0, 0.2, 0.001):
        policy = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        if policy_evaluation(model, policy, horizon=50).start >= fastest:
            return epsilon


# %% exercise 2, wrong: never found
# says: that is the end of the search: the change was never found; is the comparison the right way round?
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    for epsilon in np.arange(0.0, 0.2, 0.001):
        policy = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        if policy_evaluation(model, policy, horizon=50).start > fastest:
            return epsilon
    return 0.2


# %% exercise 2, wrong: the estimate
# says: that is the estimate, 3 divided by the cost of a fall, not the exact value: plan on the model
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


# %% exercise 2, wrong: the reciprocal
# says: that is 1/ε
def switch(model):
    return 1 / on_off_policy.switch(model, tolerance=1e-7)


# %% exercise 2, wrong: the other probability
# says: that is 1 − ε
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    epsilon = 0.0
    while epsilon < 0.2:
        epsilon += 0.001
        policy = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        if policy_evaluation(model, policy, horizon=50).start < fastest:
            return 1 - epsilon
    return 0.2


# %% exercise 2, wrong: below 0
# says: the sign is wrong
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    epsilon = 0.0
    while epsilon < 0.2:
        epsilon += 0.001
        policy = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        if policy_evaluation(model, policy, horizon=50).start < fastest:
            return -epsilon
    return 0.2


# %% exercise 2, wrong: half of it
# says: that is none of the usual mistakes, so print the number of steps of the best run for some ε
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    epsilon = 0.0
    while epsilon < 0.2:
        epsilon += 0.001
        policy = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        if policy_evaluation(model, policy, horizon=50).start < fastest:
            return epsilon / 2
    return 0.2


# %% exercise 2, wrong: the ε-soft return in steps of 0.01
# says: that is the first ε of a search in steps of 0.01: compare the greedy policy, played *without* slips, and not the
#   ε-soft return
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    for epsilon in np.arange(0.01, 0.2, 0.01):
        if value_iteration(model, epsilon=epsilon, horizon=50).start < fastest:
            return epsilon


# %% exercise 2, wrong: up to 1, the wrong way round
# says: that is the end of the search; is the comparison the right way round?
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    for epsilon in np.linspace(0.0, 1.0, 101):
        policy = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        if policy_evaluation(model, policy, horizon=50).start > fastest:
            break
    return epsilon


# %% exercise 3, right: a sum and a length
# says: Right: one number says which policy the values belong to. ε_π = 0 is Q-learning, ε_π = ε expected SARSA. See it
#   race:
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
# says: ; it returns something instead, which nobody reads
def learn(self, state, action, reward, next_state, terminated):
    value = (1 - self.target_epsilon) * max(self.Q[next_state]) + self.target_epsilon * np.mean(self.Q[next_state])
    return reward + self.discount * value


# %% exercise 3, wrong: Q-learning
# says: the maximum alone is Q-learning, which is right only for ε_π = 0; the random actions of the target policy are
#   missing
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: SARSA
# says: Q(S', A') of the action that comes next stands there: that is SARSA, and A' is chosen with the wrong ε
def learn(self, state, action, reward, next_state, next_action, terminated):
    target = reward if terminated else reward + self.discount * self.Q[next_state, next_action]
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: the other epsilon
# says: it uses `epsilon`, with which the agent acts; the values should be those of the *target* policy,
#   `target_epsilon`
def learn(self, state, action, reward, next_state, terminated):
    value = (1 - self.epsilon) * max(self.Q[next_state]) + self.epsilon * np.mean(self.Q[next_state])
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: weights interchanged
# says: ε_π and 1 − ε_π have changed places
def learn(self, state, action, reward, next_state, terminated):
    value = self.target_epsilon * max(self.Q[next_state]) + (1 - self.target_epsilon) * np.mean(self.Q[next_state])
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: the sum for the mean
# says: the sum over the actions stands where their mean should
def learn(self, state, action, reward, next_state, terminated):
    value = (1 - self.target_epsilon) * max(self.Q[next_state]) + self.target_epsilon * sum(self.Q[next_state])
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: the mean of the others
# says: the mean leaves out the best action; a random action may be the best one too
def learn(self, state, action, reward, next_state, terminated):
    row = self.Q[next_state]
    others = (sum(row) - max(row)) / (len(row) - 1)
    value = (1 - self.target_epsilon) * max(row) + self.target_epsilon * others
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: three actions
# says: it divides by 3, but there may be another number of actions: self.Q.shape[1]
def learn(self, state, action, reward, next_state, terminated):
    row = self.Q[next_state]
    value = (1 - self.target_epsilon) * max(row) + self.target_epsilon * sum(row) / 3
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: terminated forgotten
# says: a terminal state has no future: its value is 0, so the target is R alone when `terminated`
def learn(self, state, action, reward, next_state, terminated):
    value = (1 - self.target_epsilon) * max(self.Q[next_state]) + self.target_epsilon * np.mean(self.Q[next_state])
    target = reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: only the mean
# says: the plain mean is right only for ε_π = 1; with probability 1 − ε_π the target policy takes the best action
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * np.mean(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: the maximum in full
# says: the maximum counts in full, but it has the probability 1 − ε_π only
def learn(self, state, action, reward, next_state, terminated):
    value = max(self.Q[next_state]) + self.target_epsilon * np.mean(self.Q[next_state])
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: the mean is missing
# says: the mean over the random actions is missing, ε_π mean_a Q(S', a)
def learn(self, state, action, reward, next_state, terminated):
    target = reward if terminated else reward + self.discount * (1 - self.target_epsilon) * max(self.Q[next_state])
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: the number of the best action
# says: argmax gives the *number* of the best action; its value is needed, max
def learn(self, state, action, reward, next_state, terminated):
    row = self.Q[next_state]
    value = (1 - self.target_epsilon) * np.argmax(row) + self.target_epsilon * np.mean(row)
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: the mean of the whole table
# says: the mean is taken over the whole table instead of the row of the next state
def learn(self, state, action, reward, next_state, terminated):
    value = (1 - self.target_epsilon) * max(self.Q[next_state]) + self.target_epsilon * np.mean(self.Q)
    target = reward if terminated else reward + self.discount * value
    self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])


# %% exercise 3, wrong: the state that was left
# says: the values are those of the state that was left, Q(S, a), instead of Q(S', a)
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


# %% exercise 3, wrong: the random part alone
# says: the best action is missing, (1 − ε_π) max_a Q(S', a)
def learn(self, state, action, reward, next_state, next_action, terminated):
    p, row = self.target_epsilon, self.Q[next_state]
    value = 0.0 if terminated else p * row.mean()
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])


# %% exercise 3, wrong: the minimum for the mean
# says: the minimum stands where the mean over the actions should
def learn(self, state, action, reward, next_state, next_action, terminated):
    p, row = self.target_epsilon, self.Q[next_state]
    value = 0.0 if terminated else (1 - p) * row.max() + p * row.min()
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])


# %% exercise 3, wrong: the next action for the mean
# says: Q(S', A') stands where the mean over the actions should; no action has to be drawn
def learn(self, state, action, reward, next_state, next_action, terminated):
    p, row = self.target_epsilon, self.Q[next_state]
    value = 0.0 if terminated else (1 - p) * row.max() + p * row[next_action]
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])


# %% exercise 3, wrong: the old value for the mean
# says: Q(S, A) stands where the mean of Q(S', a) should
def learn(self, state, action, reward, next_state, next_action, terminated):
    p, row = self.target_epsilon, self.Q[next_state]
    value = 0.0 if terminated else (1 - p) * row.max() + p * self.Q[state, action]
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])


# %% exercise 3, wrong: no next state
# says: the value of the next state is missing: without bootstrapping nothing is carried back
def learn(self, state, action, reward, next_state, next_action, terminated):
    p, row = self.target_epsilon, self.Q[next_state]
    value = 0.0 if terminated else 0.0
    self.Q[state, action] += self.learning_rate * (reward + self.discount * value - self.Q[state, action])
