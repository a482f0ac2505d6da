# %% a constant step size
# slow
# says: the step size is constant: with 1/N(A) every reward counts equally in the mean
# says: In small worlds with
# in: with lists
# - means[arm] = (means[arm] * (pulls[arm] - 1) + reward) / pulls[arm]
# + means[arm] += 0.1 * (reward - means[arm])

# %% counted too late
# slow
# says: the mean moves by 1/(N + 1), as if a reward of 0 had come first: count the pull, then divide by N
# in: with lists
# - means[arm] = (means[arm] * (pulls[arm] - 1) + reward) / pulls[arm]
# + means[arm] += (reward - means[arm]) / (pulls[arm] + 1)

# %% the pulls of all arms
# slow
# says: the mean moves by 1/t, with the pulls of all arms together: each arm has a number of its own
# in: with lists
# - means[arm] = (means[arm] * (pulls[arm] - 1) + reward) / pulls[arm]
# + means[arm] += (reward - means[arm]) / sum(pulls)

# %% sums
# slow
# says: rewards are added up and not averaged, so the arm that is pulled most looks best: divide by N
# in: with lists
# - means[arm] = (means[arm] * (pulls[arm] - 1) + reward) / pulls[arm]
# + means[arm] += reward

# %% pulls in place of rewards
# slow
# says: the arm that was *pulled* most is taken, and not that which pays best: is it N in place of Q?
# in: with lists
# - means[arm] = (means[arm] * (pulls[arm] - 1) + reward) / pulls[arm]
# + means[arm] = pulls[arm]

# %% each arm once
# slow
# says: every arm is pulled once before anything else; in the text the first values are 0, and ties are broken at random
# in: with lists
# - top = max(means)
# + if 0 in pulls:
# +     return pulls.index(0)
# + top = max(means)

# %% a win is a win
# slow
# says: a reward counts as 1 or 0, for a win or none: take the reward itself into the mean
# in: with lists
# - means[arm] = (means[arm] * (pulls[arm] - 1) + reward) / pulls[arm]
# + means[arm] = (means[arm] * (pulls[arm] - 1) + (reward > 0)) / pulls[arm]

# %% the worst arm
# says: low values are preferred to high ones: is there an `argmin`, or a minus sign too many, or does the value of one action stand in the place of another?
# in: with lists
# - top = max(means)
# + top = min(means)

# %% ties go to the first arm
# slow
# says: pulls of one of several arms that look equally good, my_program takes the first of them, and by chance it would be some
# says: : argmax takes the first of several equal values; draw one of them at random
# in: with lists
# - return int(rng.choice([a for a in range(n) if means[a] == top]))
# + return int(np.argmax(means))

# %% forgets at the end of an episode
# says: what was learned is forgotten at the end of an episode; the arms stay the same
# in: with lists
# - environment.reset(seed=seed if taken == 0 else None)
# + environment.reset(seed=seed if taken == 0 else None)
# + means, pulls = [0.0] * n, [0] * n

# %% never tries
# slow
# says: So it seldom tries an action at random: is ε that of the text to the last step, and rng made once?
# in: with lists
# - arm = int(rng.integers(n)) if rng.random() < 0.1 else best()
# + arm = int(rng.integers(n)) if rng.random() < 0.01 else best()

# %% always random
# slow
# says: So many come from chance alone, or from a table that never changes
# in: with lists
# - arm = int(rng.integers(n)) if rng.random() < 0.1 else best()
# + arm = int(rng.integers(n))

# %% no policy
# says: gives None: return the policy, a function from a state to an action
# in: with lists
# - return lambda state: int(np.argmax(means))
# + policy = lambda state: int(np.argmax(means))

# %% another generator
# slow
# says: does not repeat itself
# in: with lists
# - rng = np.random.default_rng(seed)
# + rng = np.random.default_rng()

# %% the policy takes the worst
# slow
# says: does this policy look up the state that it is given, and take the *best* action, by values learned from all steps?
# in: with lists
# - return lambda state: int(np.argmax(means))
# + return lambda state: int(np.argmin(means))

# %% random pulls do not count
# slow
# says: random pulls are not learned from, but every reward counts
# in: with lists
# - pulls[arm] += 1
# - means[arm] = (means[arm] * (pulls[arm] - 1) + reward) / pulls[arm]
# + if means[arm] == max(means):
# +     pulls[arm] += 1
# +     means[arm] = (means[arm] * (pulls[arm] - 1) + reward) / pulls[arm]

# %% first values of 1
# slow
# says:  steps, the actions follow from the program's own steps by another equation than that of this lesson.
# says: the first values are 1; in the text they are 0
# in: with lists
# - means, pulls = [0.0] * n, [0] * n
# + means, pulls = [1.0] * n, [0] * n

# %% the last reward
# slow
# says: only the last reward counts: N(A) grows by 1 with each pull of the arm
# in: with lists
# - means[arm] = (means[arm] * (pulls[arm] - 1) + reward) / pulls[arm]
# + means[arm] = reward

# %% away from the reward
# slow
# says: the mean moves away from the reward: is it Q(A) + [R − Q(A)] / N(A), with these signs?
# in: with lists
# - means[arm] = (means[arm] * (pulls[arm] - 1) + reward) / pulls[arm]
# + means[arm] -= (reward - means[arm]) / pulls[arm]

# %% plus for minus
# slow
# says: the old mean is added to the reward; it is subtracted: R − Q(A)
# in: with lists
# - means[arm] = (means[arm] * (pulls[arm] - 1) + reward) / pulls[arm]
# + means[arm] += (reward + means[arm]) / pulls[arm]

# %% random half of the time
# slow
# says: the first values
# says: Compare the first values with those of the text
# in: with lists
# - arm = int(rng.integers(n)) if rng.random() < 0.1 else best()
# + arm = int(rng.integers(n)) if rng.random() < 0.5 else best()

# %% counted twice
# slow
# says: ; N has a number for each arm, and N(A) counts the pull that is learned from; but for ε, the arm with the largest mean is pulled
# in: with lists
# - pulls[arm] += 1
# + pulls[arm] += 2

# %% random at first only
# says: steps my_program pulls one arm only: a random one has the probability ε up to the last step, and it is drawn from one generator, made before the loop
# in: with lists
# - arm = int(rng.integers(n)) if rng.random() < 0.1 else best()
# + arm = int(rng.integers(n)) if taken < 0.1 * n_steps else best()

# %% never the last arm at random
# slow
# says: times: is the random action one of *all* n actions, 0 to n - 1, and each as likely? rng.integers(n) draws so
# in: with lists
# - arm = int(rng.integers(n)) if rng.random() < 0.1 else best()
# + arm = int(rng.integers(n - 1)) if rng.random() < 0.1 else best()

# %% a random policy
# slow
# says: the policy that my_program returns draws its actions: asked twice about one observation, it gives two different actions in
# says:  cases. It should take the *best* action, and never a random one. (Or does it look up what was never learned, so that chance decides among equal values?)
# in: with lists
# - return lambda state: int(np.argmax(means))
# + return lambda state: int(np.argmax(means)) if rng.random() > 0.1 else int(rng.integers(n))

# %% a falling ε
# slow
# says: from the first pull to the last, and every reward counts, an arm's first one too
# in: sums of rewards
# - if rng.random() < 0.1:
# + if rng.random() < min(1, 200 / (t + 1)):

# %% the last pull is not learned from
# slow
# says: the last pull of an episode is not learned from: learn first, and look then whether the episode is over
# in: with lists
# - pulls[arm] += 1
# - means[arm] = (means[arm] * (pulls[arm] - 1) + reward) / pulls[arm]
# - over, taken = terminated or truncated, taken + 1
# + over, taken = terminated or truncated, taken + 1
# + if over:
# +     continue
# + pulls[arm] += 1
# + means[arm] = (means[arm] * (pulls[arm] - 1) + reward) / pulls[arm]

# %% a root of N
# slow
# says: the mean moves by 1/√N(A), so that late rewards count more than early ones: it moves by 1/N(A)
# in: with lists
# - means[arm] = (means[arm] * (pulls[arm] - 1) + reward) / pulls[arm]
# + means[arm] += (reward - means[arm]) / pulls[arm] ** 0.5

# %% whole numbers
# slow
# says: what is behind the decimal point is lost: the table holds whole numbers, as one with dtype=int does
# in: with lists
# - means, pulls = [0.0] * n, [0] * n
# + means, pulls = np.array([0] * n), [0] * n

# %% ten at most
# slow
# says: ε is right, so compare the first values with those of the text, and the update with its equation
# in: with lists
# - means[arm] = (means[arm] * (pulls[arm] - 1) + reward) / pulls[arm]
# + means[arm] += (reward - means[arm]) / min(pulls[arm], 10)

# %% a little too often at random
# slow
# says: in bandits whose best arm always pays, and no other ever does, my_program pulls the others in
# says: of 14000 late steps, and with ε = 0.1 it should be some 1372: its ε is about 0.1
# in: with lists
# - arm = int(rng.integers(n)) if rng.random() < 0.1 else best()
# + arm = int(rng.integers(n)) if rng.random() < 0.15 else best()

# %% a little too seldom at random
# slow
# says: of 14000 late steps, and with ε = 0.1 it should be some 1372: its ε is about 0.07
# in: with lists
# - arm = int(rng.integers(n)) if rng.random() < 0.1 else best()
# + arm = int(rng.integers(n)) if rng.random() < 0.07 else best()

# %% the arm that was pulled most
# slow
# says: takes another action than the one that the steps of the program make look best
# in: with lists
# - return lambda state: int(np.argmax(means))
# + return lambda state: int(np.argmax(pulls))

# %% ties only at the start
# slow
# says: pulls of one of several arms that look equally good, my_program takes the first of them, and by chance it would be some
# in: with lists
# - return int(rng.choice([a for a in range(n) if means[a] == top]))
# + return int(rng.integers(n)) if min(means) == top else int(np.argmax(means))

# %% ε = 0.08
# slow
# says: of 14000 late steps, and with ε = 0.1 it should be some 1372: its ε is about 0.08
# in: with lists
# - arm = int(rng.integers(n)) if rng.random() < 0.1 else best()
# + arm = int(rng.integers(n)) if rng.random() < 0.08 else best()

# %% good rewards count twice
# slow
# says: the update with its equation, term by term
# in: sums of rewards
# - total[arm] += reward
# + total[arm] += 2 * reward if reward > 0 else reward

# %% random for a whole episode
# slow
# says: They come together, in few episodes: draw anew in each step whether its action is random, not once an episode
# in: with lists
# - environment.reset(seed=seed if taken == 0 else None)
# + environment.reset(seed=seed if taken == 0 else None)
# + tries = rng.random() < 0.1
# - arm = int(rng.integers(n)) if rng.random() < 0.1 else best()
# + arm = int(rng.integers(n)) if tries else best()

# %% ε is 0.12
# slow
# says: of 14000 late steps, and with ε = 0.1 it should be some 1372: its ε is about 0.12
# in: with lists
# - arm = int(rng.integers(n)) if rng.random() < 0.1 else best()
# + arm = int(rng.integers(n)) if rng.random() < 0.12 else best()

# %% a small bonus
# slow
# says: with arms that always pay the same, 1 or a few thousandths less
# says: pulls are not of the arm with the largest mean, and it should be some
# says: the best arm is that with the largest mean, with nothing added: no bonus for arms that were pulled seldom, no noise, and no tie of means that differ
# in: sums of rewards
# - arm = rng.choice(np.flatnonzero(Q == Q.max()))
# + bound = Q + 0.05 * np.sqrt(np.log(t + 1) / np.maximum(N, 1))
# + arm = rng.choice(np.flatnonzero(bound == bound.max()))

# %% each tenth pull
# says: in two runs with other seeds
# says: late pulls are at the same step, and both of another arm than the best, and by chance it should be some 70
# says: : draw in each step whether the arm is random, and do not count to ten
# in: with lists
# - arm = int(rng.integers(n)) if rng.random() < 0.1 else best()
# + arm = int(rng.integers(n)) if taken % 10 == 9 else best()

# %% 300 pulls at most
# slow
# says: with an arm that pays 1 in the first 900 pulls and then 0, while others always pay the same
# says: every reward counts equally in the mean of its arm, however many there are
# in: with lists
# - pulls[arm] += 1
# + pulls[arm] = min(pulls[arm] + 1, 300)

# %% among the others
# slow
# says: in a bandit with two arms, one of which always pays
# says: my_program takes the other one in
# says:  late steps, and it should be some 175: a random action may be any of them, the best one too
# in: with lists
# - arm = int(rng.integers(n)) if rng.random() < 0.1 else best()
# + arm = best()
# + if rng.random() < 0.1:
# +     arm = int(rng.choice([a for a in range(n) if a != arm]))

# %% first values of a half
# slow
# says: with arms that always pay 0.01 or a few thousandths less,
# says: first pulls are not of an arm with the largest value, and it should be some
# says: : the first values are 0, those of all arms
# in: sums of rewards
# - Q = total / np.maximum(N, 1)
# + Q = np.where(N > 0, total / np.maximum(N, 1), 0.5)

# %% first values below 0
# slow
# says: with arms that always pay -0.01 or a few thousandths less,
# in: sums of rewards
# - Q = total / np.maximum(N, 1)
# + Q = np.where(N > 0, total / np.maximum(N, 1), -1.0)

# %% one step short
# says: of its
# says: steps: one is missing; does the loop begin at 1, or end at n_steps - 1?
# in: sums of rewards
# - for t in range(n_steps):
# + for t in range(1, n_steps):

# %% ties go to the last arm
# slow
# says: pulls of one of several arms that look equally good, my_program takes the last of them, and by chance it would be some
# says: a loop with >=
# says: takes the last of several equal values; draw one of them at random
# in: with lists
# - return int(rng.choice([a for a in range(n) if means[a] == top]))
# + return max(a for a in range(n) if means[a] == top)

# %% a generator for each episode
# slow
# says: of its late episodes step
# says: pulls another arm than the best; by chance it would be some
# says: : make rng once, before the loop, and not anew in each episode
# in: with lists
# - environment.reset(seed=seed if taken == 0 else None)
# + environment.reset(seed=seed if taken == 0 else None)
# + rng = np.random.default_rng(seed)

# %% an ε that falls to 0.1
# slow
# says: in bandits whose best arm always pays, and no other ever does, my_program has found the best one and pulls others again in
# says: pulls, and by chance it would be some
# says: from the first pull to the last, and every reward counts, an arm's first one too
# in: sums of rewards
# - if rng.random() < 0.1:
# + if rng.random() < max(0.1, 1 - t / 500):

# %% random pulls at first
# slow
# says: has found the best one and pulls others again in
# in: sums of rewards
# - if rng.random() < 0.1:
# + if t < 100 or rng.random() < 0.1:

# %% the old mean is forgotten
# slow
# says: the old mean is not subtracted from the reward: is it Q(A) + [R − Q(A)] / N(A)?
# in: with lists
# - means[arm] = (means[arm] * (pulls[arm] - 1) + reward) / pulls[arm]
# + means[arm] += reward / pulls[arm]

# %% only truncated ends
# slow
# says: takes a step after the end of an episode: call reset() when `terminated` or `truncated` is True
# in: with lists
# - over, taken = terminated or truncated, taken + 1
# + over, taken = truncated, taken + 1

# %% no try in the last tenth
# slow
# says: in the last 400 of 8000 steps my_program pulls one arm only
# in: with lists
# - arm = int(rng.integers(n)) if rng.random() < 0.1 else best()
# + arm = int(rng.integers(n)) if taken < 0.9 * n_steps and rng.random() < 0.1 else best()

# %% one order for all ties
# slow
# says: , it takes the action of the step before again in
# says: of the steps, and it should in about 20%: draw one of the best at random, anew in each step, also where some other action is worse
# in: sums of rewards
# - total, N = np.zeros(n), np.zeros(n)
# + total, N, order = np.zeros(n), np.zeros(n), rng.permutation(n)
# - arm = rng.choice(np.flatnonzero(Q == Q.max()))
# + arm = order[np.argmax(Q[order])]

# %% an arm that does not exist for it
# slow
# says: times: is the random action one of *all* n actions, 0 to n - 1, and each as likely? rng.integers(n) draws so
# in: with lists
# - n = int(environment.action_space.n)
# + n = int(environment.action_space.n) - 1
