# %% the best that was pulled
# says: it is compared with the best arm that was *pulled*; the best of all may never have been
def total_regret(p, arms):
    best = max(p[arm] for arm in arms)
    return sum(best - p[arm] for arm in arms)


# %% the mean of all
# says: it is compared with the mean of all arms; compare with the best one
# in: a sum of differences
# - return sum(max(p) - p[arm] for arm in arms)
# + return sum(sum(p) / len(p) - p[arm] for arm in arms)

# %% an arm that always pays
# says: it is compared with an arm that always pays; compare with the best one that there is
# in: a sum of differences
# - return sum(max(p) - p[arm] for arm in arms)
# + return sum(1 - p[arm] for arm in arms)

# %% how many were wrong
# says: that is the number of pulls of worse arms; each costs as much as its arm pays less
# in: a sum of differences
# - return sum(max(p) - p[arm] for arm in arms)
# + return sum(p[arm] != max(p) for arm in arms)

# %% what they earn
# says: that is what the pulls earn on average; the regret is what the best arm would have earned more
# in: a sum of differences
# - return sum(max(p) - p[arm] for arm in arms)
# + return sum(p[arm] for arm in arms)

# %% the sign
# says: the sign is wrong: a pull of a worse arm makes the regret larger
# in: a sum of differences
# - return sum(max(p) - p[arm] for arm in arms)
# + return sum(p[arm] - max(p) for arm in arms)

# %% squared
# says: the differences are squared
# in: a sum of differences
# - return sum(max(p) - p[arm] for arm in arms)
# + return sum((max(p) - p[arm]) ** 2 for arm in arms)

# %% the mean
# says: that is the regret of a pull on average; add up the regret of all
# in: a sum of differences
# - return sum(max(p) - p[arm] for arm in arms)
# + return np.mean([max(p) - p[arm] for arm in arms])

# %% the last one
# says: that is the regret of the last pull; add up the regret of all
# in: the solution of total_regret
# - cost += max(p) - p[arm]
# + cost = max(p) - p[arm]

# %% each arm once
# says: each arm counts once; it counts as often as it was pulled
# in: a sum of differences
# - return sum(max(p) - p[arm] for arm in arms)
# + return sum(max(p) - p[arm] for arm in set(arms))

# %% without the first
# says: the first pull is left out
# in: a sum of differences
# - return sum(max(p) - p[arm] for arm in arms)
# + return sum(max(p) - p[arm] for arm in arms[1:])


# %% rewards are drawn
# says: rewards were drawn with these probabilities; luck does not count, so subtract p of the arm that was pulled
def total_regret(p, arms):
    rng = np.random.default_rng(0)
    return sum(max(p) - (rng.random() < p[arm]) for arm in arms)


# %% one for each pull
# says: total_regret(
# in: a sum of differences
# - return sum(max(p) - p[arm] for arm in arms)
# + return np.cumsum([max(p) - p[arm] for arm in arms])


# %% no return
# says: None
def total_regret(p, arms):
    print(sum(max(p) - p[arm] for arm in arms))


# %% a number
# says: p and arms
total_regret = 0.6

# %% the number of the best arm
# says: the *number* of the best arm is taken; take its probability
# in: a sum of differences
# - return sum(max(p) - p[arm] for arm in arms)
# + return sum(np.argmax(p) - p[arm] for arm in arms)

# %% without the last
# says: the last pull is left out
# in: a sum of differences
# - return sum(max(p) - p[arm] for arm in arms)
# + return sum(max(p) - p[arm] for arm in arms[:-1])

# %% what the best arm earns
# says: that is what the best arm would have earned on average; subtract what the pulls earn
# in: a sum of differences
# - return sum(max(p) - p[arm] for arm in arms)
# + return len(arms) * max(p)

# %% the gap of the second best
# says: each pull of a worse arm costs as much as one of the second best; it costs the gap of its own arm
# in: a sum of differences
# - return sum(max(p) - p[arm] for arm in arms)
# + return sum((max(p) - sorted(p)[-2]) * (p[arm] < max(p)) for arm in arms)

# %% as many random pulls
# says: that is the regret of as many random pulls; what counts is which arms were pulled
# in: a sum of differences
# - return sum(max(p) - p[arm] for arm in arms)
# + return len(arms) * (max(p) - np.mean(p))

# %% the worst arm
# says: it is compared with the worst arm; compare with the best one
# in: a sum of differences
# - return sum(max(p) - p[arm] for arm in arms)
# + return sum(p[arm] - min(p) for arm in arms)

# %% every arm once
# says: that is the regret of one pull of each arm; what counts is which arms were pulled, and how often
# in: a sum of differences
# - return sum(max(p) - p[arm] for arm in arms)
# + return sum(max(p) - one for one in p)

# %% upside down
# says: none of the usual mistakes
# in: a sum of differences
# - return sum(max(p) - p[arm] for arm in arms)
# + return sum(p[arm] / max(p) for arm in arms)

# %% returns in the loop
# says: that is the regret of the first pull: does the `return` stand inside the loop?
# in: the solution of total_regret
# - cost += max(p) - p[arm]
# + return max(p) - p[arm]

# %% the best arm of the lesson
# says: it is compared with 0.6, which the best arm of the lesson pays; take the largest entry of p
# in: a sum of differences
# - return sum(max(p) - p[arm] for arm in arms)
# + return sum(0.6 - p[arm] for arm in arms)

# %% the gap of the lesson
# says: each pull of a worse arm costs 0.2, as in the lesson; it costs the gap of its own arm
# in: a sum of differences
# - return sum(max(p) - p[arm] for arm in arms)
# + return 0.2 * sum(p[arm] < max(p) for arm in arms)

# %% arm 0
# says: it is compared with arm 0; compare with the best one, whichever that is
# in: a sum of differences
# - return sum(max(p) - p[arm] for arm in arms)
# + return sum(p[0] - p[arm] for arm in arms)


# %% p is sorted in place
# says: changes its list `p`; make a new one, for the caller still needs the old one
def total_regret(p, arms):
    total = sum(max(p) - p[arm] for arm in arms)
    p.sort()
    return total
