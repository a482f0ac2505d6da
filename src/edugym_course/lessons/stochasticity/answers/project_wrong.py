# %% Q-learning
# slow
# says: all surprises weigh the same: that is Q-learning
# in: the weight in one line
# - Q[s, a] += 0.4 * 2 / (1 + np.exp(0.5 * delta)) * delta
# + Q[s, a] += 0.4 * delta

# %% the sign
# slow
# says: good surprises weigh more than bad ones: β is below 0
# in: the weight in one line
# - Q[s, a] += 0.4 * 2 / (1 + np.exp(0.5 * delta)) * delta
# + Q[s, a] += 0.4 * 2 / (1 + np.exp(-0.5 * delta)) * delta

# %% no 2
# slow
# says: the steps are half as large as they should be: 2σ(βδ), not σ(βδ), is 1 where δ = 0, and α is 0.4
# in: the weight in one line
# - Q[s, a] += 0.4 * 2 / (1 + np.exp(0.5 * delta)) * delta
# + Q[s, a] += 0.4 / (1 + np.exp(0.5 * delta)) * delta

# %% the reward alone
# slow
# says: γ max_a Q(S', a) is missing in the target
# in: the weight in one line
# - delta = r + 0.9 * (1 - over) * Q[s2].max() - Q[s, a]
# + delta = r - Q[s, a]

# %% beyond the end
# slow
# says: the value of a state after the end is looked up
# in: the weight in one line
# - delta = r + 0.9 * (1 - over) * Q[s2].max() - Q[s, a]
# + delta = r + 0.9 * Q[s2].max() - Q[s, a]

# %% first values of 10
# slow
# says: the first values are about 10, and not 0
# in: the weight in one line
# - Q = np.zeros((environment.observation_space.n, environment.action_space.n))
# + Q = np.full((environment.observation_space.n, environment.action_space.n), 10.0)

# %% the worst at the fork
# slow
# says: a sure payment of 1, or a coin that pays 5 or -2: with β = -0.5 the sure payment is worth more, but the policy takes it in
# says:  runs only; does it take the best action?
# in: the weight in one line
# - return lambda s: int(Q[s].argmax())
# + return lambda s: int(Q[s].argmax() if len(Q) > 4 else Q[s].argmin())

# %% no brackets
# slow
# says: fit a usual mistake:
# says: − Q(S, A) is missing at the end of an episode: put brackets around `... if terminated else ...`
# in: the weight in one line
# - delta = r + 0.9 * (1 - over) * Q[s2].max() - Q[s, a]
# + delta = r if over else r + 0.9 * Q[s2].max() - Q[s, a]

# %% a smaller α
# slow
# says: α is about 0.1, and it should be 0.4
# in: the weight in one line
# - Q[s, a] += 0.4 * 2 / (1 + np.exp(0.5 * delta)) * delta
# + Q[s, a] += 0.1 * 2 / (1 + np.exp(0.5 * delta)) * delta

# %% the value of the same action
# slow
# says: Q(S', A) stands in the target, the value of the action that was taken before; it should be the maximum over the actions in S'
# in: the weight in one line
# - delta = r + 0.9 * (1 - over) * Q[s2].max() - Q[s, a]
# + delta = r + 0.9 * (1 - over) * Q[s2, a] - Q[s, a]

# %% the lowest value
# slow
# says: ; look at two places: the target is R + γ max_a Q(S', a), and R alone where `terminated` is True; and the weight 2σ(βδ) = 2/(1 + exp(−βδ)) has the whole TD error δ in it
# in: the weight in one line
# - delta = r + 0.9 * (1 - over) * Q[s2].max() - Q[s, a]
# + delta = r + 0.9 * (1 - over) * Q[s2].min() - Q[s, a]

# %% a weight by the reward
# slow
# says: the weight is made of the reward, and it should be made of δ
# in: the weight in one line
# - Q[s, a] += 0.4 * 2 / (1 + np.exp(0.5 * delta)) * delta
# + Q[s, a] += 0.4 * 2 / (1 + np.exp(0.5 * r)) * delta

# %% another β
# slow
# says: β is about -1, and it should be -0.5
# in: the weight in one line
# - Q[s, a] += 0.4 * 2 / (1 + np.exp(0.5 * delta)) * delta
# + Q[s, a] += 0.4 * 2 / (1 + np.exp(delta)) * delta

# %% an ε that falls
# slow
# says: actions of my_program are not greedy in the first half of its runs, and
# says: in the second. Their share falls during a run: ε should be the same from the first step to the last, and rng made once
# in: the weight in one line
# - for _ in range(n_steps):
# + for t in range(n_steps):
# - a = rng.integers(len(Q[s])) if rng.random() < 0.1 else Q[s].argmax()
# + a = rng.integers(len(Q[s])) if rng.random() < 0.2 * (1 - t / n_steps) else Q[s].argmax()

# %% an ε that falls by half
# slow
# says: Their share falls during a run: ε should be the same from the first step to the last, and rng made once
# in: the weight in one line
# - for _ in range(n_steps):
# -     a = rng.integers(len(Q[s])) if rng.random() < 0.1 else Q[s].argmax()
# + for step in range(n_steps):
# +     a = rng.integers(len(Q[s])) if rng.random() < 0.1 - 0.05 * step / n_steps else Q[s].argmax()

# %% two weights of an older rule
# slow
# says: Too many of them are the second best action, so chance did not draw them: the equation is another one, or a number in it. Compare
# in: the weight in one line
# - Q[s, a] += 0.4 * 2 / (1 + np.exp(0.5 * delta)) * delta
# + Q[s, a] += 0.4 * (0.5 if delta > 0 else 1.5) * delta

# %% the old maximum
# slow
# says: the maximum is taken over Q(S, a), the state that was left, instead of Q(S', a)
# in: the weight in one line
# - delta = r + 0.9 * (1 - over) * Q[s2].max() - Q[s, a]
# + delta = r + 0.9 * (1 - over) * Q[s].max() - Q[s, a]

# %% a mean
# slow
# says: the mean over the actions of the next state stands where the maximum should
# in: the weight in one line
# - delta = r + 0.9 * (1 - over) * Q[s2].max() - Q[s, a]
# + delta = r + 0.9 * (1 - over) * Q[s2].mean() - Q[s, a]

# %% a maximum from 0
# slow
# says: the maximum starts from 0, and all values may be lower: start from the first one
# in: the weight in one line
# - delta = r + 0.9 * (1 - over) * Q[s2].max() - Q[s, a]
# + delta = r + 0.9 * (1 - over) * max(0.0, Q[s2].max()) - Q[s, a]

# %% a weight by the target
# slow
# says: the weight is made of the target, and it should be made of δ
# in: the weight in one line
# - Q[s, a] += 0.4 * 2 / (1 + np.exp(0.5 * delta)) * delta
# + Q[s, a] += 0.4 * 2 / (1 + np.exp(0.5 * (delta + Q[s, a]))) * delta

# %% never the best one by chance
# slow
# says: or is the random action drawn among the others? (
# says: a random action may be any of them, the best one too
# in: the weight in one line
# - a = rng.integers(len(Q[s])) if rng.random() < 0.1 else Q[s].argmax()
# + a = Q[s].argmax()
# + if rng.random() < 0.1:
# +     a = rng.choice([other for other in range(len(Q[s])) if other != a])

# %% the mean by ε-greedy
# slow
# says: the mean by ε-greedy over the next actions stands where the maximum should: that is expected SARSA
# in: the weight in one line
# - delta = r + 0.9 * (1 - over) * Q[s2].max() - Q[s, a]
# + delta = r + 0.9 * (1 - over) * (0.9 * Q[s2].max() + 0.1 * Q[s2].mean()) - Q[s, a]

# %% the reward is discounted
# slow
# says: fit a usual mistake: the reward is discounted, and γ should stand before the value of the next state alone
# in: the weight in one line
# - delta = r + 0.9 * (1 - over) * Q[s2].max() - Q[s, a]
# + delta = (r if over else 0.9 * (r + Q[s2].max())) - Q[s, a]

# %% a terminal reward is discounted, too
# slow
# says: the reward is discounted, and γ should stand before the value of the next state alone
# says: , at the end of an episode, too
# in: the weight in one line
# - delta = r + 0.9 * (1 - over) * Q[s2].max() - Q[s, a]
# + delta = 0.9 * (r + (1 - over) * Q[s2].max()) - Q[s, a]

# %% β is −0.4
# slow
# says: β is about -0.4, and it should be -0.5
# in: the weight in one line
# - Q[s, a] += 0.4 * 2 / (1 + np.exp(0.5 * delta)) * delta
# + Q[s, a] += 0.4 * 2 / (1 + np.exp(0.4 * delta)) * delta

# %% the state before the end
# says: fit a usual mistake: after an end the program goes on from the state that it left last: state, info = environment.reset() gives the first state of the new episode
# in: the weight in one line
# - s = environment.reset()[0] if over or cut else s2
# + if over or cut:
# +     environment.reset()
# + else:
# +     s = s2

# %% the state moves on too early
# slow
# says: `state = next_state` comes before the update, which then moves a value of S' in place of one of S
# in: tanh and lists
# - error = r - values[s][a] + (0.0 if over else 0.9 * max(values[s2]))
# - values[s][a] += 0.4 * error * (1 + math.tanh(-0.5 * error / 2))
# + error = r - values[s2][a] + (0.0 if over else 0.9 * max(values[s2]))
# + values[s2][a] += 0.4 * error * (1 + math.tanh(-0.5 * error / 2))

# %% nothing from a truncated step
# slow
# says: nothing is learned from a step that is truncated: it is a step like the others
# in: tanh and lists
# - values[s][a] += 0.4 * error * (1 + math.tanh(-0.5 * error / 2))
# + if not cut:
# +     values[s][a] += 0.4 * error * (1 + math.tanh(-0.5 * error / 2))

# %% actions from a copy of the table
# slow
# says: where a state comes twice in an episode, the actions of
# says: nothing is learned before the episode is over, or the actions are chosen by a copy of the table from its beginning. Learn from each step at once, and choose by the table as it is now
# in: the weight in one line
# - s, _ = environment.reset(seed=seed)
# + s, _ = environment.reset(seed=seed)
# + copy = Q.copy()
# - a = rng.integers(len(Q[s])) if rng.random() < 0.1 else Q[s].argmax()
# + a = rng.integers(len(Q[s])) if rng.random() < 0.1 else copy[s].argmax()
# - s = environment.reset()[0] if over or cut else s2
# + s = environment.reset()[0] if over or cut else s2
# + copy = Q.copy() if over or cut else copy

# %% targets from a copy of the table
# slow
# says: max_a Q(S', a) is that of the last reset. Read it from the table as it is now, and learn from each step at once
# in: the weight in one line
# - s, _ = environment.reset(seed=seed)
# + s, _ = environment.reset(seed=seed)
# + copy = Q.copy()
# - delta = r + 0.9 * (1 - over) * Q[s2].max() - Q[s, a]
# + delta = r + 0.9 * (1 - over) * copy[s2].max() - Q[s, a]
# - s = environment.reset()[0] if over or cut else s2
# + s = environment.reset()[0] if over or cut else s2
# + copy = Q.copy() if over or cut else copy

# %% an episode from its last step to its first
# slow
# says: where a state comes twice in an episode,
# in: the weight in one line
# - s, _ = environment.reset(seed=seed)
# + s, _ = environment.reset(seed=seed)
# + noted = []
# - delta = r + 0.9 * (1 - over) * Q[s2].max() - Q[s, a]
# - Q[s, a] += 0.4 * 2 / (1 + np.exp(0.5 * delta)) * delta
# + noted.insert(0, (s, a, r, s2, over))
# + if over or cut:
# +     for s0, a0, r0, s1, end in noted:
# +         delta = r0 + 0.9 * (1 - end) * Q[s1].max() - Q[s0, a0]
# +         Q[s0, a0] += 0.4 * 2 / (1 + np.exp(0.5 * delta)) * delta
# +     noted = []

# %% the weight alone
# slow
# says: δ is missing behind the weight: the step is α times the weight 2σ(βδ), times δ
# in: the weight in one line
# - Q[s, a] += 0.4 * 2 / (1 + np.exp(0.5 * delta)) * delta
# + Q[s, a] += 0.4 * 2 / (1 + np.exp(0.5 * delta))

# %% a seed of its own
# says: calls reset(seed=7) with seed
# says: : give its own `seed` to the environment, reset(seed=seed)
# in: the weight in one line
# - s, _ = environment.reset(seed=seed)
# + s, _ = environment.reset(seed=7)

# %% no surprise in the weight
# slow
# says: δ is missing in the weight: it is 2σ(βδ), and not 2σ(β) for all surprises
# in: tanh and lists
# - values[s][a] += 0.4 * error * (1 + math.tanh(-0.5 * error / 2))
# + values[s][a] += 0.4 * error * (1 + math.tanh(-0.5 / 2))

# %% the target is weighed
# slow
# says: the weight stands before the target alone, and it should be before δ: α 2σ(βδ) δ is the step
# in: tanh and lists
# - values[s][a] += 0.4 * error * (1 + math.tanh(-0.5 * error / 2))
# + old = values[s][a]
# + values[s][a] += 0.4 * ((error + old) * (1 + math.tanh(-0.5 * error / 2)) - old)
