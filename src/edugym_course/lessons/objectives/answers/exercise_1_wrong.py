# %% better in both
# says: a point goes only if another one is better in *both*; it must go also if one is equal and the other better
# in: every pair
# - if not any(q[0] >= p[0] and q[1] >= p[1] and (q[0] > p[0] or q[1] > p[1]) for q in points):
# + if not any(q[0] > p[0] and q[1] > p[1] for q in points):


# %% no equal ones
# says: of two equal points one has gone: neither is better than the other, so both stay
# in: every pair
# - kept.append(p)
# + if p not in kept:
# +     kept.append(p)


# %% itself
# says: a point is compared with itself, and throws itself out
# in: every pair
# - if not any(q[0] >= p[0] and q[1] >= p[1] and (q[0] > p[0] or q[1] > p[1]) for q in points):
# + if not any(q[0] >= p[0] and q[1] >= p[1] for q in points):


# %% others, by their place
# says: two equal points have thrown each other out: one of the two numbers must be *better*
def pareto_optimal(points):
    kept = []
    for i, p in enumerate(points):
        others = points[:i] + points[i + 1 :]
        if not any(q[0] >= p[0] and q[1] >= p[1] for q in others):
            kept.append(p)
    return kept


# %% better in one
# says: a point goes as soon as another is better in *one* number; it must be at least as good in the other, too
# in: every pair
# - if not any(q[0] >= p[0] and q[1] >= p[1] and (q[0] > p[0] or q[1] > p[1]) for q in points):
# + if not any(q[0] > p[0] or q[1] > p[1] for q in points):


# %% time as a cost
# says: the steps are taken for a cost that should be low, but the second number is the time, minus the steps: more is
#   better
# in: every pair
# - if not any(q[0] >= p[0] and q[1] >= p[1] and (q[0] > p[0] or q[1] > p[1]) for q in points):
# + if not any(q[0] >= p[0] and q[1] <= p[1] and (q[0] > p[0] or q[1] < p[1]) for q in points):


# %% the worst
# says: low values are kept, and high ones should be
# in: every pair
# - if not any(q[0] >= p[0] and q[1] >= p[1] and (q[0] > p[0] or q[1] > p[1]) for q in points):
# + if not any(q[0] <= p[0] and q[1] <= p[1] and (q[0] < p[0] or q[1] < p[1]) for q in points):


# %% the others
# says: these are the points that go: keep the others
# in: every pair
# - if not any(q[0] >= p[0] and q[1] >= p[1] and (q[0] > p[0] or q[1] > p[1]) for q in points):
# + if any(q[0] >= p[0] and q[1] >= p[1] and (q[0] > p[0] or q[1] > p[1]) for q in points):


# %% the sum
# says: only the points with the highest sum are kept; that is one choice of weights
def pareto_optimal(points):
    best = max(value + time for value, time in points)
    return [p for p in points if sum(p) == best]


# %% the value
# says: only the points with the highest value are kept; others take less time
def pareto_optimal(points):
    best = max(value for value, time in points)
    return [p for p in points if p[0] == best]


# %% the hull
# slow
# says: only points that some *weights* prefer are kept; one in a dent is Pareto-optimal, too
def pareto_optimal(points):
    kept = set()
    for weight in np.linspace(0.0001, 0.9999, 20001):
        sums = [(1 - weight) * value + weight * time for value, time in points]
        kept |= {p for p, one in zip(points, sums) if one >= max(sums) - 1e-12}
    return [p for p in points if p in kept]


# %% neighbours
# says: points are compared with their neighbours only; compare each with all others
def pareto_optimal(points):
    kept = []
    for i, p in enumerate(points):
        near = points[max(i - 1, 0) : i] + points[i + 1 : i + 2]
        if not any(q[0] >= p[0] and q[1] >= p[1] and q != p for q in near):
            kept.append(p)
    return kept


# %% sorted
# says: the points are right, and their order is not: keep that of the list
# in: every pair
# - return kept
# + return sorted(kept)


# %% truth values
# says: gives a list of True and False; return the points themselves
# in: arrays
# - return p[~better.any(axis=0)]
# + return (~better.any(axis=0)).tolist()


# %% places
# says: gives whole numbers, the places of points; return the points themselves
# in: arrays
# - return p[~better.any(axis=0)]
# + return np.flatnonzero(~better.any(axis=0))


# %% the values alone
# says: should be a list of points (value, time), but one of them is
# in: arrays
# - return p[~better.any(axis=0)]
# + return p[~better.any(axis=0)][:, 0]


# %% removes from its list
# says: changes its list `points`; make a new one, for the caller still needs the old one
def pareto_optimal(points):
    for p in list(points):
        if any(q[0] >= p[0] and q[1] >= p[1] and q != p for q in points):
            points.remove(p)
    return points


# %% a number
# says: should be a list of points, but is
def pareto_optimal(points):
    return 3


# %% every second one
# says: that is none of the usual mistakes, so compare two points by hand
def pareto_optimal(points):
    return points[::2]


# %% nothing
# says: is a `return` missing?
# in: every pair
# - return kept
# + kept


# %% only the first
# says: only the first of the right points comes: are all of them kept, and all returned?
# in: every pair
# - return kept
# + return kept[:1]


# %% arrays in the place of numbers
# says: each part of a point of
# says: should be one number, but is a ndarray of shape (3, 2): take an entry of it
def pareto_optimal(points):
    table = np.array(points)
    return [(table, table)]


# %% the best of one
# says: only the best ones in one objective are kept; between them lie compromises
# in: every pair
# - if not any(q[0] >= p[0] and q[1] >= p[1] and (q[0] > p[0] or q[1] > p[1]) for q in points):
# + if p[0] == max(q[0] for q in points) or p[1] == max(q[1] for q in points):


# %% for each time
# says: only the best one for each time is kept; another one may be better in both
# in: every pair
# - if not any(q[0] >= p[0] and q[1] >= p[1] and (q[0] > p[0] or q[1] > p[1]) for q in points):
# + if p[0] == max(q[0] for q in points if q[1] == p[1]):


# %% value for a step
# says: only the point with the most value for each step is kept; that is one more way to weigh
# in: every pair
# - if not any(q[0] >= p[0] and q[1] >= p[1] and (q[0] > p[0] or q[1] > p[1]) for q in points):
# + if p[0] / p[1] == min(q[0] / q[1] for q in points):


# %% the same time
# says: of two points with the same time the one with the lower value stays; it must go
# in: every pair
# - if not any(q[0] >= p[0] and q[1] >= p[1] and (q[0] > p[0] or q[1] > p[1]) for q in points):
# + if not any(q[0] >= p[0] and q[1] > p[1] for q in points):


# %% the same value
# says: of two points with the same value the one with more steps stays; it must go
# in: every pair
# - if not any(q[0] >= p[0] and q[1] >= p[1] and (q[0] > p[0] or q[1] > p[1]) for q in points):
# + if not any(q[0] > p[0] and q[1] >= p[1] for q in points):


# %% all stay
# says: no point has gone: is a point compared with others, and left out if one of them dominates it?
# in: every pair
# - if not any(q[0] >= p[0] and q[1] >= p[1] and (q[0] > p[0] or q[1] > p[1]) for q in points):
# + if True:


# %% all must dominate
# says: a point goes only if *all* others dominate it; a single one is enough
# in: every pair
# - if not any(q[0] >= p[0] and q[1] >= p[1] and (q[0] > p[0] or q[1] > p[1]) for q in points):
# + if not all(q[0] >= p[0] and q[1] >= p[1] for q in points if q != p):


# %% one of them
# says: a point is compared with a single other one; compare each with all others
# in: every pair
# - if not any(q[0] >= p[0] and q[1] >= p[1] and (q[0] > p[0] or q[1] > p[1]) for q in points):
# + if not any(q[0] >= p[0] and q[1] >= p[1] and (q[0] > p[0] or q[1] > p[1]) for q in [q for q in points if q != p][:1]):


# %% those before
# says: a point is compared with those before it only; compare each with all others
# in: every pair
# - if not any(q[0] >= p[0] and q[1] >= p[1] and (q[0] > p[0] or q[1] > p[1]) for q in points):
# + if not any(q[0] >= p[0] and q[1] >= p[1] and (q[0] > p[0] or q[1] > p[1]) for q in kept):


# %% those after
# says: a point is compared with those after it only; compare each with all others
def pareto_optimal(points):
    return [
        p
        for i, p in enumerate(points)
        if not any(q[0] >= p[0] and q[1] >= p[1] and (q[0] > p[0] or q[1] > p[1]) for q in points[i:])
    ]


# %% return in the loop
# says: only the first point is looked at: does `return` stand inside the loop?
def pareto_optimal(points):
    kept = []
    for p in points:
        if not any(q[0] >= p[0] and q[1] >= p[1] and (q[0] > p[0] or q[1] > p[1]) for q in points):
            kept.append(p)
        return kept


# %% once for each
# says: a point is appended once for each other one that does not dominate it; look at all of them first
def pareto_optimal(points):
    return [p for p in points for q in points if not (q[0] >= p[0] and q[1] >= p[1] and (q[0] > p[0] or q[1] > p[1]))]


# %% changed on the way
# says: the list is changed while a loop goes through it, which skips points; make a new list
def pareto_optimal(points):
    kept = [*points]
    for p in kept:
        if any(q[0] >= p[0] and q[1] >= p[1] and (q[0] > p[0] or q[1] > p[1]) for q in kept):
            kept.remove(p)
    return kept


# %% a set
# says: each point comes once, and not in the order of the list: keep the order, and points that are equal
def pareto_optimal(points):
    return sorted(
        {p for p in points if not any(q[0] >= p[0] and q[1] >= p[1] and (q[0] > p[0] or q[1] > p[1]) for q in points)}
    )


# %% better than somebody
# says: a point stays if it dominates another one; it stays if no other one dominates it
# in: every pair
# - if not any(q[0] >= p[0] and q[1] >= p[1] and (q[0] > p[0] or q[1] > p[1]) for q in points):
# + if any(p[0] >= q[0] and p[1] >= q[1] and p != q for q in points):


# %% equal points, told apart by `is`
# says: two equal points have thrown each other out: one of the two numbers must be *better*
def pareto_optimal(points):
    return [p for p in points if not any(q[0] >= p[0] and q[1] >= p[1] for q in points if q is not p)]


# %% return as soon as one has gone
# says: only the first point that others dominate has gone: does `return` stand inside the loop?
def pareto_optimal(points):
    for p in points:
        for q in points:
            if q[0] >= p[0] and q[1] >= p[1] and q != p:
                return [other for other in points if other != p]
    return points


# %% appended in the inner loop
# says: a point is appended in the inner loop, before all others were looked at; append it below that loop
def pareto_optimal(points):
    kept = []
    for p in points:
        for q in points:
            if q[0] >= p[0] and q[1] >= p[1] and q != p:
                break
            kept.append(p)
    return kept


# %% the last comparison
# says: only the last comparison of each point counts: is what the earlier ones said overwritten in the loop?
def pareto_optimal(points):
    kept = []
    for p in points:
        for q in points:
            dominated = q[0] >= p[0] and q[1] >= p[1] and q != p
        if not dominated:
            kept.append(p)
    return kept


# %% no point against the last
# says: no point is compared with the last one: does the range of the inner loop end too early?
# in: every pair
# - if not any(q[0] >= p[0] and q[1] >= p[1] and (q[0] > p[0] or q[1] > p[1]) for q in points):
# + if not any(q[0] >= p[0] and q[1] >= p[1] and (q[0] > p[0] or q[1] > p[1]) for q in points[:-1]):


# %% no point against the first
# says: no point is compared with the first one: does the range of the inner loop begin too late?
# in: every pair
# - if not any(q[0] >= p[0] and q[1] >= p[1] and (q[0] > p[0] or q[1] > p[1]) for q in points):
# + if not any(q[0] >= p[0] and q[1] >= p[1] and (q[0] > p[0] or q[1] > p[1]) for q in points[1:]):


# %% all but the last
# says: the last point is not looked at: does the range of the loop end too early?
# in: every pair
# - for p in points:
# + for p in points[:-1]:


# %% all but the first
# says: the first point is not looked at: does the range of the loop begin too late?
# in: every pair
# - for p in points:
# + for p in points[1:]:


# %% a higher value and a higher sum
# says: a point goes if another has the higher value and the higher sum; the time must be at least as good, too
# in: every pair
# - if not any(q[0] >= p[0] and q[1] >= p[1] and (q[0] > p[0] or q[1] > p[1]) for q in points):
# + if not any(q[0] > p[0] and q[0] + q[1] > p[0] + p[1] for q in points):


# %% a generator
# says: gives a generator, which can be gone through once: make a list of it
def pareto_optimal(points):
    return (p for p in points if not any(q[0] >= p[0] and q[1] >= p[1] and q != p for q in points))


# %% the best of each value
# says: only the best one for each value is kept; another one may be better in both
def pareto_optimal(points):
    shortest = {}
    for value, time in points:
        shortest[value] = max(time, shortest.get(value, -float("inf")))
    return [(value, time) for value, time in points if shortest[value] == time]


# %% whole numbers
# says: values are cut to whole numbers, so that two of them may seem equal; compare them as they are
def pareto_optimal(points):
    whole = [(int(value), int(time)) for value, time in points]
    return [p for p, a in zip(points, whole) if not any(b[0] >= a[0] and b[1] >= a[1] and b != a for b in whole)]
