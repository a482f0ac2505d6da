# %% a sum of differences
# says: Right: no reward was needed. Luck is not in it.
def total_regret(p, arms):
    return sum(max(p) - p[arm] for arm in arms)


# %% by counts
def total_regret(p, arms):
    p = np.array(p)
    counts = np.bincount(arms, minlength=len(p))
    return float(counts @ (p.max() - p))


# %% what the best would have earned, less what these earn
def total_regret(p, arms):
    best = sorted(p)[-1]
    return len(arms) * best - sum([p[a] for a in arms])
