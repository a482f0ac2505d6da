# %% the table is not made
# says: Not solved yet: my_program is still `...`; put your answer there.
my_program = ...

# %% looks beyond the end
# slow
# says: the value of a state after the end is looked up; a terminal state has no future, so its target is the reward alone
# in: ε-greedy written out
# - target = reward if terminated else reward + 0.99 * Q[next_state].max()
# + target = reward + 0.99 * Q[next_state].max()

# %% truncated is terminated
# slow
# says: a truncated episode is learned as a terminated one: somebody stopped the clock, and the next state still has its value
# in: ε-greedy written out
# - target = reward if terminated else reward + 0.99 * Q[next_state].max()
# + done = terminated or truncated
# + target = reward if done else reward + 0.99 * Q[next_state].max()

# %% the end is not learned
# slow
# says: what is learned at the end of an episode is left out, and that is where the reward often is: learn first, and look then whether the episode is over
# in: ε-greedy written out
# - target = reward if terminated else reward + 0.99 * Q[next_state].max()
# + if terminated or truncated:
# +     state, _ = environment.reset()
# +     continue
# + target = reward + 0.99 * Q[next_state].max()
# - state = next_state
# - if terminated or truncated:
# -     state, _ = environment.reset()
# + state = next_state

# %% the old state after a reset
# says: after an end the program goes on from the last state of the old episode: state, info = environment.reset() gives the first state of the new one
# in: ε-greedy written out
# - state, _ = environment.reset()
# + environment.reset()

# %% the state stays
# says: the state stays the first one of the episode: is `state = next_state` missing?
# in: ε-greedy written out
# - state = next_state

# %% the lowest value
# slow
# says: low values are preferred to high ones: is there an `argmin`, or a minus sign too many, or does the value of one action stand in the place of another?
# in: ε-greedy written out
# - action = Q[state].argmax()
# + action = Q[state].argmin()

# %% costs
# says: low values are preferred to high ones: is there an `argmin`, or a minus sign too many, or does the value of one action stand in the place of another?
# in: ε-greedy written out
# - target = reward if terminated else reward + 0.99 * Q[next_state].max()
# + target = -reward if terminated else -reward + 0.99 * Q[next_state].max()

# %% no future
# slow
# says: γ max_a Q(S', a), the value of the next state, is missing in the target
# says: fit a usual mistake:
# in: ε-greedy written out
# - target = reward if terminated else reward + 0.99 * Q[next_state].max()
# + target = reward

# %% the state that was left
# slow
# says: the maximum is taken over Q(S, a), the state that was left, instead of Q(S', a)
# in: ε-greedy written out
# - target = reward if terminated else reward + 0.99 * Q[next_state].max()
# + target = reward if terminated else reward + 0.99 * Q[state].max()

# %% slow
# slow
# says: α is about 0.1, and it should be 0.5
# in: ε-greedy written out
# - Q[state, action] += 0.5 * (target - Q[state, action])
# + Q[state, action] += 0.1 * (target - Q[state, action])

# %% the target in its place
# slow
# says: the old value is lost, as with a learning rate of 1: it should move halfway to the target
# in: ε-greedy written out
# - Q[state, action] += 0.5 * (target - Q[state, action])
# + Q[state, action] = target

# %% seldom tries
# slow
# says: So it seldom tries an action at random: is ε that of the text to the last step, and rng made once?
# in: ε-greedy written out
# - if rng.random() < 0.1:
# + if rng.random() < 0.01:

# %% never tries
# says: my_program takes the same actions with seed 0 and with seed 1: it should try actions at random
# in: ε-greedy written out
# - if rng.random() < 0.1:
# + if rng.random() < 0.0:

# %% tries too much
# slow
# says: are not greedy, if it learns from its steps by the equation of this lesson, and with ε = 0.1 it should be some
# says: If all that is right, ε is about 0.
# says: Compare α, γ and the first values with those of the text, and the update with its equation, term by term
# in: ε-greedy written out
# - if rng.random() < 0.1:
# + if rng.random() < 0.4:

# %% the wrong way round
# slow
# says: in its table all actions of a state are worth the same, or it does not look there: does the update change the value of the action taken, and no other, are the actions chosen by the values with probability 1 − ε, and is the table made once, and not in each episode?
# in: ε-greedy written out
# - if rng.random() < 0.1:
# + if rng.random() > 0.0:

# %% the policy of the lowest value
# slow
# says: observations the policy that my_program returns takes another action than the one that the steps of the program make look best: does this policy look up the state that it is given, and take the *best* action, by values learned from all steps?
# in: ε-greedy written out
# - return lambda state: int(Q[state].argmax())
# + return lambda state: int(Q[state].argmin())

# %% the mean
# slow
# says: the mean over the actions of the next state stands where the maximum should
# in: ε-greedy written out
# - target = reward if terminated else reward + 0.99 * Q[next_state].max()
# + target = reward if terminated else reward + 0.99 * Q[next_state].mean()

# %% another discount
# slow
# says: γ is about 0.9, and it should be 0.99
# in: ε-greedy written out
# - target = reward if terminated else reward + 0.99 * Q[next_state].max()
# + target = reward if terminated else reward + 0.9 * Q[next_state].max()

# %% the policy explores
# slow
# says: the policy that my_program returns draws its actions: asked twice about one observation
# in: ε-greedy written out
# - return lambda state: int(Q[state].argmax())
# + return lambda state: int(Q[state].argmax() if rng.random() > 0.1 else rng.integers(len(Q[state])))

# %% the old value is not subtracted
# slow
# says: − Q(S, A) is missing in the brackets, so the values grow and grow
# in: ε-greedy written out
# - Q[state, action] += 0.5 * (target - Q[state, action])
# + Q[state, action] += 0.5 * target

# %% a mean of the targets
# slow
# says: the learning rate falls with the number of updates, and it is 0.5 in the text
# in: ε-greedy written out
# - Q = np.zeros((environment.observation_space.n, environment.action_space.n))
# + Q = np.zeros((environment.observation_space.n, environment.action_space.n))
# + N = np.zeros_like(Q)
# - Q[state, action] += 0.5 * (target - Q[state, action])
# + N[state, action] += 1
# + Q[state, action] += (target - Q[state, action]) / N[state, action]

# %% the same action again
# slow
# says: Q(S', A), the value of the *same* action, stands where the maximum over all actions should
# in: ε-greedy written out
# - target = reward if terminated else reward + 0.99 * Q[next_state].max()
# + target = reward if terminated else reward + 0.99 * Q[next_state, action]

# %% reset before it learns
# slow
# says: S' is the state after the reset where an episode was truncated: learn first, and reset then
# in: ε-greedy written out
# - target = reward if terminated else reward + 0.99 * Q[next_state].max()
# + if terminated or truncated:
# +     next_state, _ = environment.reset()
# + target = reward if terminated else reward + 0.99 * Q[next_state].max()
# - state = next_state
# - if terminated or truncated:
# -     state, _ = environment.reset()
# + state = next_state


# %% a table of whole numbers
# slow
# says: what is behind the decimal point is lost: the table holds whole numbers, as one with dtype=int does
def my_program(environment, n_steps, seed):
    rng = np.random.default_rng(seed)
    Q = np.zeros((environment.observation_space.n, environment.action_space.n), dtype=int)
    s, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        best = np.flatnonzero(Q[s] == Q[s].max())
        a = int(rng.integers(Q.shape[1]) if rng.random() < 0.1 else rng.choice(best))
        s2, r, end, cut, _ = environment.step(a)
        Q[s, a] = Q[s, a] + 0.5 * (r + 0.99 * (0 if end else Q[s2].max()) - Q[s, a])
        s = environment.reset()[0] if end or cut else s2
    return lambda s: int(Q[s].argmax())


# %% the value of the next action
# slow
# says: Q(S', A'), the value of the action that is taken next, stands where the maximum should
def my_program(environment, n_steps, seed):
    rng = np.random.default_rng(seed)
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))

    def act(s):
        best = np.flatnonzero(Q[s] == Q[s].max())
        return int(rng.integers(Q.shape[1]) if rng.random() < 0.1 else rng.choice(best))

    s, _ = environment.reset(seed=seed)
    a = act(s)
    for _ in range(n_steps):
        s2, r, end, cut, _ = environment.step(a)
        a2 = act(s2)
        Q[s, a] += 0.5 * (r + 0.99 * (0 if end else Q[s2, a2]) - Q[s, a])
        s, a = s2, a2
        if end or cut:
            s, _ = environment.reset()
            a = act(s)
    return lambda s: int(Q[s].argmax())


# %% the best action learns
# slow
# says: the value of the action that looks best moves, and it should be that of the action that was taken
# in: ε-greedy written out
# - target = reward if terminated else reward + 0.99 * Q[next_state].max()
# + action = Q[state].argmax()
# + target = reward if terminated else reward + 0.99 * Q[next_state].max()


# %% half of the ε
# slow
# says: So it seldom tries an action at random: is ε that of the text to the last step, and rng made once?
def my_program(environment, n_steps, seed):
    rng = np.random.default_rng(seed)
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    s, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        best = np.flatnonzero(Q[s] == Q[s].max())
        a = int(rng.integers(Q.shape[1]) if rng.random() < 0.05 else rng.choice(best))
        s2, r, end, cut, _ = environment.step(a)
        Q[s, a] += 0.5 * (r + 0.99 * (0 if end else Q[s2].max()) - Q[s, a])
        s = environment.reset()[0] if end or cut else s2
    return lambda s: int(Q[s].argmax())


# %% an ε that grows
# slow
# says: in small worlds
# says: in the second. Their share grows during a run: ε should be the same from the first step to the last, and rng made once; or does a small mistake build up, such as a truncated end that is learned as a terminated one?
# in: ε-greedy written out
# - if rng.random() < 0.1:
# + if rng.random() < 0.05 + 0.15 * _ / n_steps:

# %% never the best one by chance
# slow
# says: or is the random action drawn among the others? (
# says: a random action may be any of them, the best one too
# in: ε-greedy written out
# - action = rng.integers(len(Q[state]))
# + action = rng.choice(np.flatnonzero(np.arange(len(Q[state])) != Q[state].argmax()))

# %% actions from a space without a seed
# slow
# says: draws from environment.action_space.sample(), and gives it no seed, so two runs with one seed differ: draw from
#   rng = np.random.default_rng(seed), or begin with environment.action_space.seed(seed)
# in: ε-greedy written out
# - action = rng.integers(len(Q[state]))
# + action = environment.action_space.sample()

# %% γ is forgotten
# slow
# says: In worlds where small differences decide, with 60
# says: γ is larger than 0.99; is it missing?
# in: episode after episode
# - Q[s, a] += 0.5 * (r + (not end) * 0.99 * Q[s2].max() - Q[s, a])
# + Q[s, a] += 0.5 * (r + (not end) * Q[s2].max() - Q[s, a])

# %% first values of −1
# slow
# says: the first values are below 0
# in: episode after episode
# - Q = np.zeros((environment.observation_space.n, environment.action_space.n))
# + Q = -np.ones((environment.observation_space.n, environment.action_space.n))

# %% first values that are drawn
# slow
# says: Are α, γ and the first values those of the text, the first values all the same, and the values neither rounded nor cut off?
# in: episode after episode
# - Q = np.zeros((environment.observation_space.n, environment.action_space.n))
# + Q = np.random.default_rng(seed).random((environment.observation_space.n, environment.action_space.n))

# %% = for +=
# slow
# says: the old value is lost: `=` stands where `+=` should, so that Q(S, A) + is missing before the step
# in: episode after episode
# - Q[s, a] += 0.5 * (r + (not end) * 0.99 * Q[s2].max() - Q[s, a])
# + Q[s, a] = 0.5 * (r + (not end) * 0.99 * Q[s2].max() - Q[s, a])

# %% the whole row
# slow
# says: in its table all actions of a state are worth the same, or it does not look there: does the update change the value of the action taken, and no other, are the actions chosen by the values with probability 1 − ε, and is the table made once, and not in each episode?
# in: an agent of its own
# - self.row(s)[a] = 0.5 * self.row(s)[a] + 0.5 * (r + 0.99 * future)
# + self.values[int(s)] = [0.5 * self.row(s)[a] + 0.5 * (r + 0.99 * future)] * self.n_actions

# %% nothing for the last step
# slow
# says: the last reward of an episode is lost: after a terminated step the target is R, and not 0
# in: episode after episode
# - Q[s, a] += 0.5 * (r + (not end) * 0.99 * Q[s2].max() - Q[s, a])
# + Q[s, a] += 0.5 * ((not end) * (r + 0.99 * Q[s2].max()) - Q[s, a])

# %% an environment of its own
# says: takes no step in the environment that it is given: does it make one of its own?
# in: episode after episode
# - Q = np.zeros((environment.observation_space.n, environment.action_space.n))
# + environment = __import__("gymnasium").make("edugym/Supermarket-v0")
# + Q = np.zeros((environment.observation_space.n, environment.action_space.n))

# %% the state moves on too early
# slow
# says: `state = next_state` comes before the update, which then moves a value of S' in place of one of S
# in: ε-greedy written out
# - Q[state, action] += 0.5 * (target - Q[state, action])
# - state = next_state
# + state = next_state
# + Q[state, action] += 0.5 * (target - Q[state, action])

# %% nothing from a truncated step
# slow
# says: nothing is learned from a step that is truncated: it is a step like the others
# in: ε-greedy written out
# - Q[state, action] += 0.5 * (target - Q[state, action])
# + if not truncated:
# +     Q[state, action] += 0.5 * (target - Q[state, action])

# %% ε a little too small
# slow
# says: So it seldom tries an action at random: is ε that of the text to the last step, and rng made once?
# in: ε-greedy written out
# - if rng.random() < 0.1:
# + if rng.random() < 0.078:

# %% the reward is discounted too
# slow
# says: the reward is discounted as well, and γ belongs to the value of the next state alone
# in: ε-greedy written out
# - target = reward if terminated else reward + 0.99 * Q[next_state].max()
# + target = reward if terminated else 0.99 * (reward + Q[next_state].max())

# %% nothing from the last step
# slow
# says: nothing is learned from the last step of an episode: where `terminated` is True, the target is R
# in: ε-greedy written out
# - Q[state, action] += 0.5 * (target - Q[state, action])
# + if not terminated:
# +     Q[state, action] += 0.5 * (target - Q[state, action])

# %% γ = 0.97
# slow
# says: γ is smaller than 0.99
# in: episode after episode
# - Q[s, a] += 0.5 * (r + (not end) * 0.99 * Q[s2].max() - Q[s, a])
# + Q[s, a] += 0.5 * (r + (not end) * 0.97 * Q[s2].max() - Q[s, a])

# %% first values of 0.5
# slow
# says: the first values are above 0
# in: episode after episode
# - Q = np.zeros((environment.observation_space.n, environment.action_space.n))
# + Q = np.full((environment.observation_space.n, environment.action_space.n), 0.5)

# %% a maximum that starts from 0
# slow
# says: where all values are below 0, in
# says: does a search for the highest value begin at 0, in a target? Begin it at −∞, or take `max`
# in: episode after episode
# - Q[s, a] += 0.5 * (r + (not end) * 0.99 * Q[s2].max() - Q[s, a])
# + Q[s, a] += 0.5 * (r + (not end) * 0.99 * max(0.0, *Q[s2]) - Q[s, a])

# %% expected SARSA
# slow
# says: the mean over the actions of ε-greedy stands where the maximum should: that is expected SARSA
# in: episode after episode
# - Q[s, a] += 0.5 * (r + (not end) * 0.99 * Q[s2].max() - Q[s, a])
# + Q[s, a] += 0.5 * (r + (not end) * 0.99 * (0.9 * Q[s2].max() + 0.1 * Q[s2].mean()) - Q[s, a])

# %% away from the target
# slow
# says: a minus sign stands where a plus should, so that the values move away from their targets: the update is Q(S, A) + α [target − Q(S, A)]
# in: ε-greedy written out
# - Q[state, action] += 0.5 * (target - Q[state, action])
# + Q[state, action] -= 0.5 * (target - Q[state, action])

# %% without brackets
# slow
# says: the brackets are missing, and α multiplies the target alone: it is α [target − Q(S, A)]
# in: ε-greedy written out
# - Q[state, action] += 0.5 * (target - Q[state, action])
# + Q[state, action] += 0.5 * target - Q[state, action]

# %% the whole target
# slow
# says: the target is not multiplied by α: it is Q(S, A) + α [target − Q(S, A)]
# in: ε-greedy written out
# - Q[state, action] += 0.5 * (target - Q[state, action])
# + Q[state, action] = 0.5 * Q[state, action] + target

# %% the number of the best action
# slow
# says: the target has the *number* of the best next action, as `argmax` gives it; it should be its value, `max`
# in: ε-greedy written out
# - target = reward if terminated else reward + 0.99 * Q[next_state].max()
# + target = reward if terminated else reward + 0.99 * Q[next_state].argmax()

# %% learns from the best actions alone
# slow
# says: nothing is learned from random actions: a step teaches something whatever chose its action
# in: ε-greedy written out
# - Q[state, action] += 0.5 * (target - Q[state, action])
# + if Q[state, action] == Q[state].max():
# +     Q[state, action] += 0.5 * (target - Q[state, action])

# %% terminated and truncated swapped
# slow
# says: `terminated` and `truncated` have changed places: step returns state, reward, terminated, truncated, info
# in: ε-greedy written out
# - target = reward if terminated else reward + 0.99 * Q[next_state].max()
# + target = reward if truncated else reward + 0.99 * Q[next_state].max()


# %% a copy of the table from the last reset
# slow
# says: where a state comes twice in an episode, the actions of
# says: max_a Q(S', a) is that of the last reset. Read it from the table as it is now, and learn from each step at once
# in: ε-greedy written out
# - state, _ = environment.reset(seed=seed)
# + state, _ = environment.reset(seed=seed)
# + copy = Q.copy()
# - target = reward if terminated else reward + 0.99 * Q[next_state].max()
# + target = reward if terminated else reward + 0.99 * copy[next_state].max()
# - if terminated or truncated:
# + if terminated or truncated:
# +     copy = Q.copy()

# %% a policy whose search begins at 0
# slow
# says: where all values are below 0, in
# says: takes another action than the one that the steps of the program make look best: it is always the same one. Does a search for the highest value begin at 0? Begin it at −∞, or take `max`
# in: an agent of its own
# - return learner.best
# + return lambda state: int(np.argmax(np.maximum(learner.row(state), 0.0)))


# %% a table for each episode
# slow
# says: are the actions chosen by the values with probability 1 − ε, and is the table made once, and not in each episode?
# in: an agent of its own
# - taken += 1
# + taken += 1
# + learner.values = {} if terminated or truncated else learner.values

# %% random actions among four
# slow
# says: of 7 actions
# says:  times where another one looks better, and by the number of all such tries it should be some
# says: : a random action is one of all n, each as likely. rng.integers(n) draws so
# in: ε-greedy written out
# - action = rng.integers(len(Q[state]))
# + action = rng.integers(min(4, len(Q[state])))

# %% the first and the last action half as often
# slow
# says: is the random action one of *all* n actions, 0 to n - 1, and each as likely? rng.integers(n) draws so
# in: ε-greedy written out
# - action = rng.integers(len(Q[state]))
# + action = round(rng.random() * (len(Q[state]) - 1))

# %% the value of an action that is drawn
# slow
# says: ; the target has max_a Q(S', a), the *largest* value of S', and not that of an action that is drawn
# in: episode after episode
# - Q = np.zeros((environment.observation_space.n, environment.action_space.n))
# + Q = np.zeros((environment.observation_space.n, environment.action_space.n))
# + def drawn(values):
# +     return values.argmax() if rng.random() > 0.1 else rng.integers(len(values))
# - Q[s, a] += 0.5 * (r + (not end) * 0.99 * Q[s2].max() - Q[s, a])
# + Q[s, a] += 0.5 * (r + (not end) * 0.99 * Q[s2, drawn(Q[s2])] - Q[s, a])
