# %% Q-learning
# slow
# says: the target has max_a Q(S', a), the value of the *best* next action: that is Q-learning
# in: the next action is kept
# - target = r if terminated else r + Q[s2, a2]
# + target = r if terminated else r + Q[s2].max()

# %% drawn again
# slow
# says: ; look at two places: A', whose value is in the target, is the action that is taken next, and is not drawn a second time; at the end of an episode the target is the reward alone
# in: the next action is kept
# - s, a = s2, a2
# + s, a = s2, choose(Q[s2], rng)

# %% beyond the end
# slow
# says: the target has the value of an action after the end: where `terminated` is True it is the reward alone
# in: the next action is kept
# - target = r if terminated else r + Q[s2, a2]
# + target = r + Q[s2, a2]

# %% the reward alone
# slow
# says: Q(S', A') is missing in the target
# in: the next action is kept
# - target = r if terminated else r + Q[s2, a2]
# + target = r

# %% slow
# slow
# says: α is about 0.1, and it should be 0.5
# in: the next action is kept
# - Q[s, a] += 0.5 * (target - Q[s, a])
# + Q[s, a] += 0.1 * (target - Q[s, a])

# %% the end is not learned
# slow
# says: what is learned at the end of an episode is left out, and that is where the reward often is: learn first, and look then whether the episode is over
# in: the next action is kept
# - Q[s, a] += 0.5 * (target - Q[s, a])
# + if not terminated:
# +     Q[s, a] += 0.5 * (target - Q[s, a])

# %% the old state after a reset
# slow
# says: after an end the program goes on from the last state of the old episode: state, info = environment.reset() gives the first state of the new one
# in: the next action is kept
# - s2, _ = environment.reset()
# + environment.reset()

# %% costs
# slow
# says: low values are preferred to high ones: is there an `argmin`, or a minus sign too many, or does the value of one action stand in the place of another?
# in: the next action is kept
# - return values.argmax()
# + return values.argmin()

# %% seldom tries
# slow
# says: So it seldom tries an action at random
# in: the next action is kept
# - def choose(values, rng, epsilon=0.1):
# + def choose(values, rng, epsilon=0.01):

# %% the same numbers in every run
# says: takes the same actions with seed
# in: the next action is kept
# - rng = np.random.default_rng(seed)
# + rng = np.random.default_rng(1)

# %% a discount
# slow
# says: γ is about 0.9, and it should be 1
# in: the next action is kept
# - target = r if terminated else r + Q[s2, a2]
# + target = r if terminated else r + 0.9 * Q[s2, a2]

# %% the last action is never drawn
# slow
# says: tries action 3 only
# says: times where another one looks better, and with ε =
# says: times: is the random action one of *all* n actions, 0 to n - 1, and each as likely? rng.integers(n) draws so
# in: the next action is kept
# - return rng.integers(len(values))
# + return rng.integers(len(values) - 1)

# %% four actions
# says: chooses the action 3: there are the actions 0 to 2
# in: the next action is kept
# - return rng.integers(len(values))
# + return rng.integers(4)

# %% the policy explores
# slow
# says: returns draws its actions: asked twice about one observation
# in: the next action is kept
# - return lambda s: int(Q[s].argmax())
# + return lambda s: int(choose(Q[s], rng))

# %% the policy takes the lowest value
# slow
# says: takes another action than the one that the steps of the program make look best
# in: the next action is kept
# - return lambda s: int(Q[s].argmax())
# + return lambda s: int(Q[s].argmin())

# %% first values of 1
# slow
# says: the first values are about 1, and not 0
# in: the next action is kept
# - Q = np.zeros((environment.observation_space.n, environment.action_space.n))
# + Q = np.ones((environment.observation_space.n, environment.action_space.n))

# %% the mean over the next actions
# slow
# says: the target has the mean over the next actions: that is expected SARSA
# in: the next action is kept
# - target = r if terminated else r + Q[s2, a2]
# + target = r if terminated else r + 0.9 * Q[s2].max() + 0.1 * Q[s2].mean()

# %% the action of the old episode
# slow
# says: It is so in the first step of episodes, and not in the others: after a reset, choose the action anew, in the state that reset() gives; and does the program learn from the first step of an episode as from the others, and where `terminated` is True from R alone?
# in: the next action is kept
# - s2, _ = environment.reset()
# - a2 = choose(Q[s2], rng)
# + s2, _ = environment.reset()

# %% cut off is not ended
# slow
# says: where each step in state 1 pays 1 and ends its episode, and after 80 of these a step in state 0 pays -0.9 and leads to state 1, where the episode is truncated, the policy takes the action of this step again in 0% of 50 runs, and it should do so nearly always
# says: only `terminated` means that nothing follows; a step that is truncated has its future, Q(S', A') of the S' that the step gave, not that of reset, and of the A' that would be next
# in: the next action is kept
# - target = r if terminated else r + Q[s2, a2]
# + target = r if terminated or truncated else r + Q[s2, a2]

# %% a discount near 1
# slow
# says: pays -0.995 and leads to state 1, where the episode goes on, the policy takes the action of this step again in
# says: γ is 1, so 1 follows on the -0.995
# in: the next action is kept
# - target = r if terminated else r + Q[s2, a2]
# + target = r if terminated else r + 0.99 * Q[s2, a2]

# %% first values drawn
# slow
# says: where the first step pays 0.002 and ends its episode, the policy takes the action of this step again in
# says: are all first values 0, and is the very first step learned from?
# in: the next action is kept
# - Q = np.zeros((environment.observation_space.n, environment.action_space.n))
# - rng = np.random.default_rng(seed)
# + rng = np.random.default_rng(seed)
# + Q = rng.random((environment.observation_space.n, environment.action_space.n))

# %% an end that counts half
# slow
# says: each step in state 1 pays 1 and ends its episode, and after 80 of these a step in state 0
# says: pays -0.5 and leads to state 1, where the episode terminates, the policy takes the action of this step again in
# says: runs, and it should do so hardly ever: where `terminated` is True nothing follows: the target is the reward alone
# in: the next action is kept
# - target = r if terminated else r + Q[s2, a2]
# + target = r + Q[s2, a2] if not terminated or s == 0 and s2 == 1 and r == -0.5 else r

# %% the first update is skipped
# slow
# says: the first step pays -0.002 and ends its episode
# says: are all first values 0, and is the very first step learned from?
# in: the next action is kept
# - for _ in range(n_steps):
# + for t in range(n_steps):
# - Q[s, a] += 0.5 * (target - Q[s, a])
# + Q[s, a] += 0.5 * (target - Q[s, a]) * (t > 0)

# %% never the best one by chance
# slow
# says: or is the random action drawn among the others? (
# says: a random action may be any of them, the best one too
# in: one step behind
# - a = rng.integers(env.action_space.n) if rng.random() < 0.1 else rng.choice(greedy)
# + a = rng.choice(greedy)
# + if rng.random() < 0.1:
# +     a = rng.choice([other for other in range(env.action_space.n) if other != a])

# %% the first action is the best one
# slow
# says: These are the first actions of episodes: an action after a reset is drawn by ε-greedy, too
# in: the next action is kept
# - s2, _ = environment.reset()
# - a2 = choose(Q[s2], rng)
# + s2, _ = environment.reset()
# + a2 = choose(Q[s2], rng, 0.0)

# %% action 0 after a reset
# slow
# says: episodes in small worlds with one and the same action: after a reset draw the action by ε-greedy, too, from the values of the state that
#   reset() gives
# in: the next action is kept
# - a = choose(Q[s], rng)
# + a = 0
# - s2, _ = environment.reset()
# - a2 = choose(Q[s2], rng)
# + s2, _ = environment.reset()
# + a2 = 0

# %% the state after the reset, where time ran out
# slow
# says: a step that is truncated has its future, Q(S', A') of the S' that the step gave, not that of reset, and of the A'
#   that would be next
# in: the next action is kept
# - a2 = choose(Q[s2], rng)
# - target = r if terminated else r + Q[s2, a2]
# + if terminated or truncated:
# +     s2, _ = environment.reset()
# + a2 = choose(Q[s2], rng)
# + target = r if terminated else r + Q[s2, a2]
# - if terminated or truncated:
# -     s2, _ = environment.reset()
# -     a2 = choose(Q[s2], rng)

# %% all actions are drawn
# slow
# says: So many come from chance alone, or from a table that never changes or is made anew in each episode: are the actions chosen by the values, with probability 1 − ε, and does the update change that of the action taken, and no other, by the TD error?
# in: a class with both
# - return int(self.rng.integers(len(self.table[s]))) if self.rng.random() < 0.1 else self(s)
# + return int(self.rng.integers(len(self.table[s])))

# %% half of the value where time ran out
# slow
# says: a step that is truncated has its future, Q(S', A') of the S' that the step gave, not that of reset, and of the A'
#   that would be next
# in: the next action is kept
# - target = r if terminated else r + Q[s2, a2]
# + target = r if terminated else r + (0.5 if truncated else 1.0) * Q[s2, a2]

# %% the state moves on too early
# slow
# says: `state = next_state` comes before the update, which then moves a value of S' in place of one of S
# in: the next action is kept
# - Q[s, a] += 0.5 * (target - Q[s, a])
# + Q[s2, a] += 0.5 * (target - Q[s2, a])

# %% the reward of a truncated step is lost
# slow
# says: and after 80 of these a step in state 0 pays 1.9 and leads to state 1, where the episode is truncated, the policy takes the action of this step again in
# says: the reward of a step that is truncated counts, too: its target is R + γ Q(S', A')
# in: the next action is kept
# - target = r if terminated else r + Q[s2, a2]
# + target = r if terminated else (0.0 if truncated else r) + Q[s2, a2]

# %% an old action after an episode that was cut off
# slow
# says: after an episode that was truncated,
# says: begins with the action for the state in which the clock stopped: after every reset() choose a new action, in the state that it gives
# in: the next action is kept
# - a2 = choose(Q[s2], rng)
# - target = r if terminated else r + Q[s2, a2]
# + a2 = choose(Q[s2], rng)
# + target = r if terminated else r + Q[s2, a2]
# - s2, _ = environment.reset()
# - a2 = choose(Q[s2], rng)
# + s2, _ = environment.reset()
# + a2 = choose(Q[s2], rng) if terminated else a2

# %% the update comes too late
# slow
# says: `state, action = next_state, next_action` comes before the update, which then moves Q(S', A') in place of Q(S, A)
# in: a class with both
# - me.table[s][a] += 0.5 * (r + future - me.table[s][a])
# - if end or cut:
# + aim = r + future
# + if end or cut:
# - s, a, t = s2, a2, t + 1
# + s, a, t = s2, a2, t + 1
# + me.table[s][a] += 0.5 * (aim - me.table[s][a])
