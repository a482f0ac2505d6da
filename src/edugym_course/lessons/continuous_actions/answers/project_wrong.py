# %% the reward of the step
# says: the reward of a step stands in the place of the return G, which sums up all rewards from it to the end
# in: lists of an episode
# - G = sum(0.8**i * r for i, r in enumerate(R[k:]))
# + G = R[k]

# %% the return so far
# says: the return sums up the rewards up to a step, and it should be those from it to the end
# in: lists of an episode
# - G = sum(0.8**i * r for i, r in enumerate(R[k:]))
# + G = sum(0.8 ** (k - i) * r for i, r in enumerate(R[: k + 1]))

# %% no discount
# says: the return is not discounted: γ is 0.8 in the text
# in: lists of an episode
# - G = sum(0.8**i * r for i, r in enumerate(R[k:]))
# + G = sum(R[k:])

# %% no baseline
# says: there is no baseline: the policy moves by G, and it should move by δ = G − V(S)
# in: lists of an episode
# - delta = G - V[S[k]]
# + delta = G

# %% no γ^t
# says:  steps the policy of
# says:  should return μ =
# says: , by its own steps and the equations of this lesson, and it returns
# says: A usual mistake gives the very same numbers:
# says: the factor γ^t is missing
# in: lists of an episode
# - step = 0.005 * 0.8**k * delta
# + step = 0.005 * delta

# %% the other way
# says: the policy moves away from actions that were better than the baseline: is a minus sign too many?
# in: lists of an episode
# - step = 0.005 * 0.8**k * delta
# + step = -0.005 * 0.8**k * delta

# %% a fixed σ
# says: σ is never learned: ln σ has a score, too
# in: lists of an episode
# - ls[S[k]] += step * (z**2 / sigma**2 - 1)

# %% no minus one
# says: the score of ln σ lacks its − 1, so σ grows wherever δ is above 0
# in: lists of an episode
# - ls[S[k]] += step * (z**2 / sigma**2 - 1)
# + ls[S[k]] += step * z**2 / sigma**2

# %% the score of σ
# says: what is learned is ln σ, with the score of σ: that of ln σ is σ times as large
# in: lists of an episode
# - ls[S[k]] += step * (z**2 / sigma**2 - 1)
# + ls[S[k]] += step * (z**2 / sigma**3 - 1 / sigma)

# %% not divided
# says: the score of μ is not divided by σ²
# in: lists of an episode
# - mu[S[k]] += step * z / sigma**2
# + mu[S[k]] += step * z

# %% divided by σ
# says: the score of μ is divided by σ, and it should be by σ²
# in: lists of an episode
# - mu[S[k]] += step * z / sigma**2
# + mu[S[k]] += step * z / sigma

# %% the variance
# slow
# says:  has the right μ, so (A - μ)/σ, with the μ and the σ that its own steps give by the equations of this lesson, should be standard normal. In
# says:  steps its mean is
# says: , the root of its mean square
# says: , and two in a row have the mean product
# says: They fit a usual mistake:
# says: the standard deviation of the actions is σ² and not σ: NumPy's rng.normal(μ, σ) takes σ itself
# in: lists of an episode
# - a = rng.normal(mu[s], np.exp(ls[s]))
# + a = rng.normal(mu[s], np.exp(ls[s]) ** 2)

# %% a large rate
# says: the learning rate of the policy, α^θ, is 0.025, and it should be 0.005
# in: lists of an episode
# - step = 0.005 * 0.8**k * delta
# + step = 0.025 * 0.8**k * delta

# %% a small rate
# says: the learning rate of the policy, α^θ, is 0.001, and it should be 0.005
# in: lists of an episode
# - step = 0.005 * 0.8**k * delta
# + step = 0.001 * 0.8**k * delta

# %% values that hardly learn
# says: the learning rate of V, α^w, is 0.01, and it should be 0.1
# in: lists of an episode
# - V[S[k]] += 0.1 * delta
# + V[S[k]] += 0.01 * delta

# %% a wide start
# says: No usual mistake gives these numbers. Compare the rates, γ, the bounds of σ and the first values with those of the text, and the updates with their equations, term by term; does it learn in all states, from all steps of an episode, and from each once? Does each episode begin with empty lists, and its G with 0? Does the policy return μ as it is?
# in: lists of an episode
# - mu, ls, V = np.zeros(n), np.zeros(n), np.zeros(n)
# + mu, ls, V = np.zeros(n), np.full(n, 0.5), np.zeros(n)

# %% no bounds
# slow
# says: σ is not kept between 0.2 and 2
# in: lists of an episode
# - ls[S[k]] = min(max(ls[S[k]], np.log(0.2)), np.log(2))

# %% one Gaussian for all states
# says: all states have the same μ and σ, and each should have its own
# in: lists of an episode
# - a = rng.normal(mu[s], np.exp(ls[s]))
# + a = rng.normal(mu[0], np.exp(ls[0]))
# - V[S[k]] += 0.1 * delta
# + V[S[k]] += 0.1 * delta
# + S[k] = 0
# - return lambda s: mu[s]
# + return lambda s: mu[0]

# %% a list as an action
# says: as an action, and it should be one real number
# in: lists of an episode
# - a = rng.normal(mu[s], np.exp(ls[s]))
# + a = rng.normal([mu[s], mu[s]], np.exp(ls[s]))

# %% a policy that goes elsewhere
# says: Does the policy return μ as it is?
# in: lists of an episode
# - return lambda s: mu[s]
# + return lambda s: -mu[s]

# %% lists that are never emptied
# says: all earlier episodes are learned from again at the end of each, the last step first: empty the list of the episode when it has learned from it
# in: a class without NumPy
# - episode = []
# - state, _ = environment.reset()
# + state, _ = environment.reset()

# %% lists that are never emptied, from the first step
# slow
# says: all earlier episodes are learned from again at the end of each: empty the lists of the episode when it has learned from them
# in: lists of an episode
# - t, s = 0, environment.reset(seed=seed)[0]
# - while t < n_steps:
# -     S, A, R, over = [], [], [], False
# + t, s = 0, environment.reset(seed=seed)[0]
# + S, A, R = [], [], []
# + while t < n_steps:
# +     over = False

# %% a policy that draws
# says: the policy that
# says:  returns draws its actions: asked twice about state
# says: , it gives two different ones. It should return the mean μ of the state
# in: lists of an episode
# - return lambda s: mu[s]
# + return lambda s: rng.normal(mu[s], np.exp(ls[s]))

# %% the μ that has moved
# says: the score of ln σ is computed with the μ that has just moved: keep A − μ before you change μ
# in: lists of an episode
# - ls[S[k]] += step * (z**2 / sigma**2 - 1)
# + ls[S[k]] += step * ((A[k] - mu[S[k]]) ** 2 / sigma**2 - 1)

# %% the σ that has changed
# says: the score of μ is computed with the σ that has just changed: keep σ before you change ln σ
# in: lists of an episode
# - mu[S[k]] += step * z / sigma**2
# - ls[S[k]] += step * (z**2 / sigma**2 - 1)
# - ls[S[k]] = min(max(ls[S[k]], np.log(0.2)), np.log(2))
# + ls[S[k]] += step * (z**2 / sigma**2 - 1)
# + ls[S[k]] = min(max(ls[S[k]], np.log(0.2)), np.log(2))
# + mu[S[k]] += step * z / np.exp(ls[S[k]]) ** 2

# %% all steps but the last
# says: nothing is learned from the last step of an episode: its G is its reward
# in: lists of an episode
# - for k in range(len(S)):
# + for k in range(len(S) - 1):

# %% always σ = 1
# slow
# says: the actions are drawn with the standard deviation 1, and it should be the σ that is learned
# in: lists of an episode
# - a = rng.normal(mu[s], np.exp(ls[s]))
# + a = rng.normal(mu[s], 1)

# %% the V that has moved
# says: the policy learns from G less the V that has just moved: compute δ before you change V
# in: lists of an episode
# - V[S[k]] += 0.1 * delta
# + V[S[k]] += 0.1 * delta
# + delta = G - V[S[k]]

# %% bounds of ln σ
# says: ln σ is kept between 0.2 and 2, and it is σ that should be; ln σ lies between ln 0.2 and ln 2
# in: lists of an episode
# - ls[S[k]] = min(max(ls[S[k]], np.log(0.2)), np.log(2))
# + ls[S[k]] = min(max(ls[S[k]], 0.2), 2)

# %% one μ
# says: all states have the same μ: is the index of the state missing where μ changes?
# in: lists of an episode
# - mu[S[k]] += step * z / sigma**2
# + mu += step * z / sigma**2

# %% σ of 0.5 at first
# says: σ is 0.5 at first, and it should be 1
# in: lists of an episode
# - mu, ls, V = np.zeros(n), np.zeros(n), np.zeros(n)
# + mu, ls, V = np.zeros(n), np.log(0.5) * np.ones(n), np.zeros(n)

# %% ln σ of 1 at first
# says: ln σ is 1 at first, and it should be 0: then σ is 1
# in: lists of an episode
# - mu, ls, V = np.zeros(n), np.zeros(n), np.zeros(n)
# + mu, ls, V = np.zeros(n), np.ones(n), np.zeros(n)

# %% one rate for both
# says: V hardly learns: α^w is 0.1 in the text, and not α^θ
# in: lists of an episode
# - V[S[k]] += 0.1 * delta
# + V[S[k]] += 0.005 * delta

# %% the return of the whole episode
# says: every step gets the return of the whole episode, and it should be the one from this step on
# in: lists of an episode
# - G = sum(0.8**i * r for i, r in enumerate(R[k:]))
# + G = sum(0.8**i * r for i, r in enumerate(R))

# %% the TD error
# says: δ is the TD error R + γ V(S') − V(S), as in the actor-critic; here it is G − V(S)
# in: lists of an episode
# - G = sum(0.8**i * r for i, r in enumerate(R[k:]))
# + G = R[k] + (0.8 * V[S[k + 1]] if k + 1 < len(S) else 0.0)

# %% μ away
# says: the sign of the score of μ is wrong: it is A − μ above the line
# in: lists of an episode
# - mu[S[k]] += step * z / sigma**2
# + mu[S[k]] += step * (mu[S[k]] - A[k]) / sigma**2

# %% σ the other way
# says: the sign of the score of ln σ is wrong: σ should grow where δ and the distance from μ are large
# in: lists of an episode
# - ls[S[k]] += step * (z**2 / sigma**2 - 1)
# + ls[S[k]] += step * (1 - z**2 / sigma**2)

# %% learned from a cut-off action
# says: it learns from an action that is cut off at −1 and 1, and not from the one that it drew
# in: lists of an episode
# - A.append(a)
# + A.append(min(max(a, -1), 1))

# %% an action that is cut off
# says:  steps the action of
# says: : give the environment what is drawn, not cut off and not rounded; and draw anew at each step, from one generator that is made before the first
# in: lists of an episode
# - a = rng.normal(mu[s], np.exp(ls[s]))
# + a = np.clip(rng.normal(mu[s], np.exp(ls[s])), -1, 1)

# %% nothing after a truncation
# says: my_program takes a step after the end of an episode
# in: lists of an episode
# - t, over = t + 1, terminated or truncated
# + t, over = t + 1, terminated

# %% σ itself
# says: what is learned is σ, with the score of σ: learn ln σ, with its own
# in: lists of an episode
# - ls[S[k]] += step * (z**2 / sigma**2 - 1)
# - ls[S[k]] = min(max(ls[S[k]], np.log(0.2)), np.log(2))
# + ls[S[k]] = np.log(min(max(sigma + step * (z**2 / sigma**3 - 1 / sigma), 0.2), 2))

# %% nothing is learned where time ran out
# says: nothing is learned from an episode that is truncated: it is over as well, and its returns stop at its last reward
# in: lists of an episode
# - for k in range(len(S)):
# + for k in range(0 if truncated else len(S)):

# %% returns in the reverse order
# says: the returns stand in the reverse order, as in a list that was filled from the last step on: turn it
# in: lists of an episode
# - G = sum(0.8**i * r for i, r in enumerate(R[k:]))
# + G = sum(0.8**i * r for i, r in enumerate(R[len(R) - 1 - k :]))

# %% the usual discount
# says: γ is 0.99, and it should be 0.8
# in: lists of an episode
# - G = sum(0.8**i * r for i, r in enumerate(R[k:]))
# + G = sum(0.99**i * r for i, r in enumerate(R[k:]))
# - step = 0.005 * 0.8**k * delta
# + step = 0.005 * 0.99**k * delta

# %% the mean of the returns
# says: the baseline is the mean of the returns of the episode, and it should be V(S)
# in: lists of an episode
# - delta = G - V[S[k]]
# + delta = G - np.mean([sum(0.8**i * r for i, r in enumerate(R[j:])) for j in range(len(R))])

# %% one V
# says: all states have the same V: is the index of the state missing where V changes?
# in: lists of an episode
# - delta = G - V[S[k]]
# - V[S[k]] += 0.1 * delta
# + delta = G - V[0]
# + V[0] += 0.1 * delta

# %% goes on where time ran out
# says: the returns of a truncated episode go on with V(S'), and they should stop at its last reward
# in: lists of an episode
# - for k in range(len(S)):
# + R[-1] += 0.8 * V[s] * truncated
# + for k in range(len(S)):

# %% counted from the end
# says: the factor γ^t counts the steps from the end of the episode, and it should be from its start
# in: lists of an episode
# - step = 0.005 * 0.8**k * delta
# + step = 0.005 * 0.8 ** (len(S) - 1 - k) * delta

# %% twice as far
# says: ln σ moves twice as far as it should: the 2 in 2σ² and the square cancel
# in: lists of an episode
# - ls[S[k]] += step * (z**2 / sigma**2 - 1)
# + ls[S[k]] += 2 * step * (z**2 / sigma**2 - 1)

# %% the discount of other lessons
# says: γ is 0.9, and it should be 0.8
# in: lists of an episode
# - G = sum(0.8**i * r for i, r in enumerate(R[k:]))
# + G = sum(0.9**i * r for i, r in enumerate(R[k:]))
# - step = 0.005 * 0.8**k * delta
# + step = 0.005 * 0.9**k * delta

# %% γ^t for ln σ alone
# says: the factor γ^t is missing where μ moves
# in: lists of an episode
# - mu[S[k]] += step * z / sigma**2
# + mu[S[k]] += 0.005 * delta * z / sigma**2

# %% γ^t for μ alone
# says: the factor γ^t is missing where ln σ moves
# in: lists of an episode
# - ls[S[k]] += step * (z**2 / sigma**2 - 1)
# + ls[S[k]] += 0.005 * delta * (z**2 / sigma**2 - 1)

# %% the TD error for V alone
# says: V moves by the TD error, and it should move by G − V(S)
# in: lists of an episode
# - V[S[k]] += 0.1 * delta
# + V[S[k]] += 0.1 * (R[k] + (0.8 * V[S[k + 1]] if k + 1 < len(S) else 0.0) - V[S[k]])

# %% no upper bound
# slow
# says: where the farthest actions pay most, so that σ grows to 2,
# says:  keep it between 0.2 and 2 after each step, and draw with it
# in: lists of an episode
# - ls[S[k]] = min(max(ls[S[k]], np.log(0.2)), np.log(2))
# + ls[S[k]] = max(ls[S[k]], np.log(0.2))

# %% the upper bound is 1
# says: σ is kept below 1, and it may grow to 2
# in: lists of an episode
# - ls[S[k]] = min(max(ls[S[k]], np.log(0.2)), np.log(2))
# + ls[S[k]] = min(max(ls[S[k]], np.log(0.2)), 0.0)

# %% γ^t for V
# says: the factor γ^t stands in the line of V as well: it belongs to the policy alone
# in: lists of an episode
# - V[S[k]] += 0.1 * delta
# + V[S[k]] += 0.1 * 0.8**k * delta

# %% γ^(t + 1)
# says: the power of γ is one too large, in γ^t or in G: the first step of an episode has γ^0 = 1, and so has the first reward of a return
# in: lists of an episode
# - step = 0.005 * 0.8**k * delta
# + step = 0.005 * 0.8 ** (k + 1) * delta

# %% the state that reset() gives is lost
# says: the first state of an episode is the last one of the episode before: keep what reset() gives
# in: lists of an episode
# - s, _ = environment.reset()
# + environment.reset()

# %% nothing from the first step
# says: nothing is learned from the first step of an episode
# in: lists of an episode
# - for k in range(len(S)):
# + for k in range(1, len(S)):

# %% the last episode, which time cut off
# says: it learns from the last episode, too, which time cut off: drop it, since its returns are not whole
# in: a class without NumPy
# - return lambda state: states.setdefault(state, Gauss()).mean
# + G = 0.0
# + for t, (gauss, action, reward) in reversed(list(enumerate(episode))):
# +     G = reward + 0.8 * G
# +     gauss.learn(action, G, 0.8**t)
# + return lambda state: states.setdefault(state, Gauss()).mean

# %% V of 1 at first
# says: V is 1 at first, and it should be 0
# in: lists of an episode
# - mu, ls, V = np.zeros(n), np.zeros(n), np.zeros(n)
# + mu, ls, V = np.zeros(n), np.zeros(n), np.ones(n)

# %% rates that have changed places
# says: the two learning rates, α^θ and α^w, have changed places
# in: lists of an episode
# - V[S[k]] += 0.1 * delta
# + V[S[k]] += 0.005 * delta
# - step = 0.005 * 0.8**k * delta
# + step = 0.1 * 0.8**k * delta

# %% the states after
# says: it learns of the states after the actions, and not of those in which they were taken
# in: lists of an episode
# - S.append(s)
# - A.append(a)
# - s, r, terminated, truncated, _ = environment.step(a)
# + A.append(a)
# + s, r, terminated, truncated, _ = environment.step(a)
# + S.append(s)

# %% cut off for the environment alone
# says:  steps the action of
# says: : give the environment what is drawn, not cut off and not rounded; and draw anew at each step, from one generator that is made before the first
# in: lists of an episode
# - s, r, terminated, truncated, _ = environment.step(a)
# + s, r, terminated, truncated, _ = environment.step(min(max(a, -1), 1))

# %% cut off far out
# slow
# says: : give the environment what is drawn, not cut off and not rounded; and draw anew at each step, from one generator that is made before the first
# in: lists of an episode
# - s, r, terminated, truncated, _ = environment.step(a)
# + s, r, terminated, truncated, _ = environment.step(min(max(a, -3), 3))

# %% means that are cut off
# slow
# says:  should return μ =
# says: , by its own steps, and it returns
# says: : after each step keep σ between 0.2 and 2, and let μ go as far as it goes
# in: lists of an episode
# - return lambda s: mu[s]
# + return lambda s: np.clip(mu[s], -1, 1)

# %% the last episode goes on with V
# says: No usual mistake gives these numbers.
# in: a class without NumPy
# - return lambda state: states.setdefault(state, Gauss()).mean
# + G = states.setdefault(state, Gauss()).value
# + for t, (gauss, action, reward) in reversed(list(enumerate(episode))):
# +     G = reward + 0.8 * G
# +     gauss.learn(action, G, 0.8**t)
# + return lambda state: states.setdefault(state, Gauss()).mean

# %% a rate of 0.15 for V
# says: No usual mistake gives these numbers.
# in: lists of an episode
# - V[S[k]] += 0.1 * delta
# + V[S[k]] += 0.15 * delta

# %% rounded means
# says: Does the policy return μ as it is?
# in: lists of an episode
# - return lambda s: mu[s]
# + return lambda s: round(mu[s], 1)

# %% a uniform draw
# says: Draw each action by rng.normal(μ, σ), anew in each step, with the μ and the σ that its state has now
# in: lists of an episode
# - a = rng.normal(mu[s], np.exp(ls[s]))
# + a = mu[s] + 1.7320508 * np.exp(ls[s]) * rng.uniform(-1, 1)

# %% all means
# says: , and it should be one real number, μ
# in: lists of an episode
# - return lambda s: mu[s]
# + return lambda s: mu

# %% one draw for the whole episode
# slow
# says: not cut off and not rounded; and draw anew at each step, from one generator that is made before the first
# in: lists of an episode
# - S, A, R, over = [], [], [], False
# + S, A, R, over, z0 = [], [], [], False, rng.standard_normal()
# -         a = rng.normal(mu[s], np.exp(ls[s]))
# +         a = mu[s] + np.exp(ls[s]) * z0

# %% noise that stays a while
# slow
# says: Draw each action by rng.normal(μ, σ), anew in each step, with the μ and the σ that its state has now
# in: lists of an episode
# - t, s = 0, environment.reset(seed=seed)[0]
# + t, z0, s = 0, 0.0, environment.reset(seed=seed)[0]
# -         a = rng.normal(mu[s], np.exp(ls[s]))
# +         z0 = 0.6 * z0 + 0.8 * rng.standard_normal()
# +         a = mu[s] + np.exp(ls[s]) * z0

# %% a Gaussian that is cut at 2.5 σ
# slow
# says: σ from μ: give the environment what is drawn, and do not cut it off
# in: lists of an episode
# - a = rng.normal(mu[s], np.exp(ls[s]))
# + a = mu[s] + np.exp(ls[s]) * np.clip(rng.standard_normal(), -2.5, 2.5)

# %% a new generator at each step
# says: not cut off and not rounded; and draw anew at each step, from one generator that is made before the first
# in: lists of an episode
# - a = rng.normal(mu[s], np.exp(ls[s]))
# + a = np.random.default_rng(seed).normal(mu[s], np.exp(ls[s]))

# %% σ may fall to 0.1
# says: σ may fall to 0.1, and it should stay at 0.2 or above
# in: lists of an episode
# - ls[S[k]] = min(max(ls[S[k]], np.log(0.2)), np.log(2))
# + ls[S[k]] = min(max(ls[S[k]], np.log(0.1)), np.log(2))

# %% an array with the mean of each state
# says: it returns is of the type ndarray: return `lambda state: actions[state]` for an array with an action for each state
# in: lists of an episode
# - return lambda s: mu[s]
# + return mu

# %% a policy that returns nothing
# says: , and it should be one real number, μ: is its `return` missing, or have the values grown without end?
# in: lists of an episode
# - return lambda s: mu[s]
# + return lambda s: None

# %% the middle of another state
# slow
# says: Draw each action by rng.normal(μ, σ), anew in each step, with the μ and the σ that its state has now
# in: lists of an episode
# - a = rng.normal(mu[s], np.exp(ls[s]))
# + a = rng.normal(mu[s - 1], np.exp(ls[s]))

# %% a little above the middle
# slow
# says: Draw each action by rng.normal(μ, σ), anew in each step, with the μ and the σ that its state has now
# in: lists of an episode
# - a = rng.normal(mu[s], np.exp(ls[s]))
# + a = rng.normal(mu[s] + 0.05, np.exp(ls[s]))

# %% the first four steps of an episode
# slow
# says: No usual mistake gives these numbers. Compare the rates, γ, the bounds of σ and the first values with those of the text, and the updates with their equations, term by term; does it learn in all states, from all steps of an episode, and from each once? Does each episode begin with empty lists, and its G with 0? Does the policy return μ as it is?
# in: lists of an episode
# - for k in range(len(S)):
# + for k in range(min(len(S), 4)):

# %% a return that is noted too early
# slow
# says: each G is that of the next step: is it noted before the reward of its own step is added?
# in: lists of an episode
# - G = sum(0.8**i * r for i, r in enumerate(R[k:]))
# + G = sum(0.8**i * r for i, r in enumerate(R[k + 1 :]))

# %% σ moves by the score of ln σ
# slow
# says: σ itself moves by the score of ln σ, and ln σ should move by it
# in: lists of an episode
# - ls[S[k]] += step * (z**2 / sigma**2 - 1)
# + ls[S[k]] = np.log(max(sigma + step * (z**2 / sigma**2 - 1), 0.01))
