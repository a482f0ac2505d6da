# %% one reward
# slow
# says: the target has one reward only: that is SARSA
# in: three steps later
# - n = 3
# + n = 1

# %% two rewards
# slow
# says: the target has two rewards, and it should have three
# in: three steps later
# - n = 3
# + n = 2

# %% four rewards
# slow
# says: the target has four rewards, and it should have three
# in: three steps later
# - n = 3
# + n = 4

# %% Monte Carlo
# slow
# says: the target has all rewards to the end of the episode: that is Monte Carlo
# in: three steps later
# - n = 3
# + n = 1000

# %% the next reward
# slow
# says: the target has the next reward alone
# in: three steps later
# - G = sum(0.8**k * r for k, r in enumerate(R[tau : tau + n]))
# - if not over:
# -     G += 0.8**n * Q[S[tau + n], A[tau + n]]
# + G = R[tau]

# %% slow
# slow
# says: α is about 0.1, and it should be 0.5
# in: three steps later
# - Q[S[tau], A[tau]] += 0.5 * (G - Q[S[tau], A[tau]])
# + Q[S[tau], A[tau]] += 0.1 * (G - Q[S[tau], A[tau]])

# %% beyond the end
# slow
# says: ; look at two places: at the end of an episode the targets of *all* pairs that are left are rewards alone, and elsewhere γⁿ Q(S_τ+n, A_τ+n) comes after the n rewards, where A_τ+n is drawn once and then taken; and the lists hold the actions that were taken, in this episode
# in: three steps later
# - if not over:
# -     G += 0.8**n * Q[S[tau + n], A[tau + n]]
# + G += 0.8**n * Q[S[min(tau + n, len(S) - 1)], A[min(tau + n, len(S) - 1)]]

# %% no value
# slow
# says: no value comes after the n rewards: γⁿ Q(S_τ+n, A_τ+n) is missing
# in: three steps later
# - if not over:
# -     G += 0.8**n * Q[S[tau + n], A[tau + n]]

# %% only the last pair at the end
# slow
# says: at the end of an episode only one pair is learned, and the others that are left have rewards to learn from too
# in: three steps later
# - for tau in range(len(R)) if over else [len(R) - n]:
# + for tau in [len(R) - n]:

# %% nothing at the end
# slow
# says: what is learned at the end of an episode is left out, and that is where the reward often is: learn first, and look then whether the episode is over
# in: three steps later
# - for tau in range(len(R)) if over else [len(R) - n]:
# -     if tau < 0 or (over and tau < len(R) - n):
# -         continue
# + for tau in [] if over or len(R) < n else [len(R) - n]:

# %% the lowest value
# slow
# says: low values are preferred to high ones: is there an `argmin`, or a minus sign too many, or does the value of one action stand in the place of another?
# in: three steps later
# - return values.argmax()
# + return values.argmin()

# %% the old state after a reset
# slow
# says: after an end the program goes on from the last state of the old episode: state, info = environment.reset() gives the first state of the new one
# in: three steps later
# - s, _ = environment.reset()
# + environment.reset()

# %% the largest value
# slow
# says: after the rewards comes the largest value of S_τ+n, or a mean near it; it should be that of the action taken, A_τ+n. With the maximum the target is the *uncorrected* one of this lesson; or is A_τ+n drawn twice, for the target and for the step? Draw it once
# in: three steps later
# - G += 0.8**n * Q[S[tau + n], A[tau + n]]
# + G += 0.8**n * Q[S[tau + n]].max()

# %% a value that is not discounted
# slow
# says: the value after the n rewards is not discounted: it is γⁿ Q(S_τ+n, A_τ+n)
# in: three steps later
# - G += 0.8**n * Q[S[tau + n], A[tau + n]]
# + G += Q[S[tau + n], A[tau + n]]

# %% discounted from the start of the episode
# slow
# says: the rewards are discounted from the start of the episode, and they should be from step τ: the first reward of a target has the weight 1
# in: three steps later
# - G = sum(0.8**k * r for k, r in enumerate(R[tau : tau + n]))
# + G = sum(0.8 ** (tau + k) * r for k, r in enumerate(R[tau : tau + n]))

# %% no discount
# slow
# says: γ is about 1, and it should be 0.8
# in: three steps later
# - G = sum(0.8**k * r for k, r in enumerate(R[tau : tau + n]))
# - if not over:
# -     G += 0.8**n * Q[S[tau + n], A[tau + n]]
# + G = sum(R[tau : tau + n])
# + if not over:
# +     G += Q[S[tau + n], A[tau + n]]

# %% an end that is cut off is no end
# says: takes a step after the end of an episode
# in: three steps later
# - over = terminated or truncated
# + over = terminated

# %% nothing where the clock stops
# slow
# says: where an episode is truncated, the actions of my_program fit a usual mistake: nothing is learned from such an episode: all its pairs have the rewards that there are
# in: when the episode is over
# - for tau in range(len(episode)):
# + for tau in range(len(episode) if terminated else 0):

# %% a first reset without the seed
# says:  gives no seed to its first reset, so two runs with one seed differ: begin with state, info = environment.reset(seed=seed)
# in: three steps later
# - t, s = 0, environment.reset(seed=seed)[0]
# + t, s = 0, environment.reset()[0]

# %% a discount a little too large
# slow
# says: γ is about 0.85, and it should be 0.8
# in: three steps later
# - G = sum(0.8**k * r for k, r in enumerate(R[tau : tau + n]))
# + G = sum(0.85**k * r for k, r in enumerate(R[tau : tau + n]))
# - G += 0.8**n * Q[S[tau + n], A[tau + n]]
# + G += 0.85**n * Q[S[tau + n], A[tau + n]]

# %% a power of γ too low
# slow
# says: the value after the n rewards has the weight γⁿ⁻¹, and it should be γⁿ
# in: three steps later
# - G += 0.8**n * Q[S[tau + n], A[tau + n]]
# + G += 0.8 ** (n - 1) * Q[S[tau + n], A[tau + n]]

# %% a power of γ too high
# slow
# says: the value after the n rewards has the weight γⁿ⁺¹, and it should be γⁿ
# in: three steps later
# - G += 0.8**n * Q[S[tau + n], A[tau + n]]
# + G += 0.8 ** (n + 1) * Q[S[tau + n], A[tau + n]]

# %% a value discounted once
# slow
# says: the value after the n rewards has the weight γ, and it should be γⁿ
# in: three steps later
# - G += 0.8**n * Q[S[tau + n], A[tau + n]]
# + G += 0.8 * Q[S[tau + n], A[tau + n]]

# %% the pair before
# slow
# says: the value is that of S_τ+n-1 and A_τ+n-1, one step too early
# in: three steps later
# - G += 0.8**n * Q[S[tau + n], A[tau + n]]
# + G += 0.8**n * Q[S[tau + n - 1], A[tau + n - 1]]

# %% rewards without a discount
# slow
# says: all rewards have the same weight: the first one has the weight 1, the second γ, and the third γ²
# in: three steps later
# - G = sum(0.8**k * r for k, r in enumerate(R[tau : tau + n]))
# + G = sum(R[tau : tau + n])

# %% one weight for all rewards
# slow
# says: all rewards have the same weight: the first one has the weight 1, the second γ, and the third γ²
# in: three steps later
# - G = sum(0.8**k * r for k, r in enumerate(R[tau : tau + n]))
# + G = sum(0.8 * r for r in R[tau : tau + n])

# %% powers backwards
# slow
# says: the powers of γ run backwards: the *first* reward of a target has the weight 1
# in: three steps later
# - G = sum(0.8**k * r for k, r in enumerate(R[tau : tau + n]))
# + G = sum(0.8**k * r for k, r in enumerate(reversed(R[tau : tau + n])))

# %% without the first reward
# slow
# says: the first reward is left out of the target, that of step τ itself, R_τ+1
# in: three steps later
# - G = sum(0.8**k * r for k, r in enumerate(R[tau : tau + n]))
# + G = sum(0.8**k * r for k, r in enumerate(R[tau + 1 : tau + n]))

# %% the mean of the rewards
# slow
# says: the mean of the rewards stands where their sum should
# in: three steps later
# - G = sum(0.8**k * r for k, r in enumerate(R[tau : tau + n]))
# + G = sum(0.8**k * r for k, r in enumerate(R[tau : tau + n])) / len(R[tau : tau + n])

# %% all pairs once more
# slow
# says: at the end of an episode all its pairs are learned, also those that have learned before
# in: three steps later
# - if tau < 0 or (over and tau < len(R) - n):
# + if tau < 0:

# %% half the exploration
# slow
# says: So it seldom tries an action at random: is ε that of the text to the last step, and rng made once?
# in: three steps later
# - def choose(values, rng, epsilon=0.1):
# + def choose(values, rng, epsilon=0.05):

# %% the first pair never learns
# slow
# says: the first pair of an episode is never learned (τ = 0 counts, too), or its action is not chosen by ε-greedy in the state that reset() gives
# in: three steps later
# - if tau < 0 or (over and tau < len(R) - n):
# + if tau < 1 or (over and tau < len(R) - n):

# %% never the best one by chance
# slow
# says: or is the random action drawn among the others? (
# says: a random action may be any of them, the best one too
# in: when the episode is over
# - a = rng.integers(Q.shape[1]) if rng.random() < 0.1 else Q[s].argmax()
# + a = Q[s].argmax()
# + if rng.random() < 0.1:
# +     a = rng.choice([other for other in range(Q.shape[1]) if other != a])

# %% without the last reward
# slow
# says: the last of the n rewards is left out of the target, R_τ+n
# in: three steps later
# - G = sum(0.8**k * r for k, r in enumerate(R[tau : tau + n]))
# + G = sum(0.8**k * r for k, r in enumerate(R[tau : tau + n - 1]))

# %% without the last reward, also at the end
# slow
# says: the last reward of each target is left out: range(τ, k) ends with k − 1
# in: three steps later
# - G = sum(0.8**k * r for k, r in enumerate(R[tau : tau + n]))
# + G = sum(0.8**k * r for k, r in enumerate(R[tau : tau + n][:-1]))

# %% the action before
# slow
# says: the value is that of S_τ+n with the action before: draw A_τ+n first, and learn then
# in: three steps later
# - G += 0.8**n * Q[S[tau + n], A[tau + n]]
# + G += 0.8**n * Q[S[tau + n], A[tau + n - 1]]

# %% rewards in whole numbers
# slow
# says: take `max`. Or does a reward lose what is behind its decimal point, as by `int(reward)`?
# in: three steps later
# - R.append(r)
# + R.append(int(r))

# %% the first action by chance
# slow
# says: the first pair of an episode is never learned (τ = 0 counts, too), or its action is not chosen by ε-greedy in the state that reset() gives
# in: three steps later
# - S, A, R, over = [s], [choose(Q[s], rng)], [], False
# + S, A, R, over = [s], [rng.integers(len(Q[s]))], [], False

# %% rewards one step too early
# slow
# says: the rewards of a target begin one step too early: the first one is R_τ+1, which follows on A_τ
# in: three steps later
# - G = sum(0.8**k * r for k, r in enumerate(R[tau : tau + n]))
# + begin = max(tau - 1, 0)
# + G = sum(0.8**k * r for k, r in enumerate(R[begin : begin + n]))

# %% the newest pair moves
# slow
# says: it is always the value of the newest pair that moves, and it should be that of S_τ and A_τ
# in: three steps later
# - Q[S[tau], A[tau]] += 0.5 * (G - Q[S[tau], A[tau]])
# + Q[S[len(R) - 1], A[len(R) - 1]] += 0.5 * (G - Q[S[len(R) - 1], A[len(R) - 1]])

# %% the last pair never learns
# slow
# says: the last pair of an episode is never learned, and it has its reward
# in: when the episode is over
# - for tau in range(len(episode)):
# + for tau in range(len(episode) - 1):

# %% from the last pair to the first
# slow
# says: an episode is learned from its last pair to its first, and it should be from the oldest pair on
# in: when the episode is over
# - for tau in range(len(episode)):
# + for tau in range(len(episode) - 1, -1, -1):

# %% γⁿ for all values where the clock stops
# slow
# says: where an episode is truncated, the actions of my_program fit a usual mistake: a value after k < n rewards has the weight γⁿ, and it should be γᵏ
# in: a value also where the clock stops
# - G += 0.8 ** (last - tau) * Q[S[last], A[last]]
# + G += 0.8**n * Q[S[last], A[last]]

# %% no discount where the clock stops
# slow
# says: where an episode is truncated, the actions of my_program fit a usual mistake: the value is not discounted: after k rewards it has the weight γᵏ
# in: a value also where the clock stops
# - G += 0.8 ** (last - tau) * Q[S[last], A[last]]
# + G += (1.0 if truncated else 0.8**n) * Q[S[last], A[last]]

# %% γ where the clock stops
# slow
# says: where an episode is truncated, the actions of my_program fit a usual mistake: the value has the weight γ, and after k rewards it should be γᵏ
# in: a value also where the clock stops
# - G += 0.8 ** (last - tau) * Q[S[last], A[last]]
# + G += (0.8 if truncated else 0.8**n) * Q[S[last], A[last]]

# %% the last reward where the clock stops
# slow
# says: where an episode is truncated, the actions of my_program fit a usual mistake: the last reward is lost there
# in: three steps later
# - R.append(r)
# + R.append(0.0 if truncated else r)

# %% the value of the last pair where the clock stops
# slow
# says: where an episode is truncated, the actions of my_program fit a usual mistake: the value is that of the last pair, and it should be one of the state that the last step gave
# in: a value also where the clock stops
# - G += 0.8 ** (last - tau) * Q[S[last], A[last]]
# + where = last - 1 if over else last
# + G += 0.8 ** (last - tau) * Q[S[where], A[where]]

# %% the value of the first state where the clock stops
# slow
# says: where an episode is truncated, the actions of my_program fit a usual mistake: the value is that of the state after the reset; it should be that of the state which the last step gave
# in: a value also where the clock stops
# - S.append(s)
# + if truncated:
# +     s = environment.reset()[0]
# + S.append(s)
# - s, _ = environment.reset()
# + if terminated:
# +     s, _ = environment.reset()

# %% rewards without a discount where the clock stops
# slow
# says: where an episode is truncated, the actions of my_program fit a usual mistake: the rewards are not discounted there: they have the weights 1, γ and γ²
# in: three steps later
# - G = sum(0.8**k * r for k, r in enumerate(R[tau : tau + n]))
# + G = sum(r if truncated else 0.8**k * r for k, r in enumerate(R[tau : tau + n]))

# %% a smaller α where the clock stops
# slow
# says: So look at episodes that are truncated: all pairs that are left learn from the k rewards that there are, with the weights 1, γ, ..., and then, if you like, from γᵏ times a value of the state that the last step gave
# in: a value also where the clock stops
# - Q[S[tau], A[tau]] += 0.5 * (G - Q[S[tau], A[tau]])
# + Q[S[tau], A[tau]] += (0.2 if truncated else 0.5) * (G - Q[S[tau], A[tau]])

# %% nothing more where the clock stops
# slow
# says: where an episode is truncated, the actions of my_program fit a usual mistake: nothing is learned there: all pairs that are left have the rewards that there are
# in: three steps later
# - if tau < 0 or (over and tau < len(R) - n):
# + if tau < 0 or truncated or (over and tau < len(R) - n):

# %% the old value of the pair
# slow
# says: where a state comes twice in an episode, the actions of
# says: what is subtracted from the target is Q(S_τ, A_τ) as it was in step τ. Read it when you update the pair: it may have changed since
# in: three steps later
# - S, A, R, over = [s], [choose(Q[s], rng)], [], False
# + S, A, R, over, old = [s], [choose(Q[s], rng)], [], False, []
# - s, r, terminated, truncated, _ = environment.step(A[-1])
# + old.append(Q[s, A[-1]])
# + s, r, terminated, truncated, _ = environment.step(A[-1])
# - Q[S[tau], A[tau]] += 0.5 * (G - Q[S[tau], A[tau]])
# + Q[S[tau], A[tau]] += 0.5 * (G - old[tau])

# %% one step too late
# slow
# says: each pair is learned one step too late, with a value that comes n + 1 steps after it: after step t learn the pair of τ = t − n + 1
# in: three steps later
# - for tau in range(len(R)) if over else [len(R) - n]:
# + for tau in range(len(R)) if over else [len(R) - n - 1]:
# - G += 0.8**n * Q[S[tau + n], A[tau + n]]
# + G += 0.8**n * Q[S[-1], A[-1]]

# %% lists that go on
# slow
# says: the lists of the last episode go on in the next one: empty them at each reset
# in: three steps later
# - t, s = 0, environment.reset(seed=seed)[0]
# + t, s = 0, environment.reset(seed=seed)[0]
# + S, A, R = [], [], []
# - S, A, R, over = [s], [choose(Q[s], rng)], [], False
# + S, A, over = [*S[: len(R)], s], [*A[: len(R)], choose(Q[s], rng)], False
