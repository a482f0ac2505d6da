# %% no root
# says: the square root is missing
# in: with where
# - return np.where(N > 0, Q + c * np.sqrt(np.log(t) / N), np.inf)
# + return np.where(N > 0, Q + c * np.log(t) / N, np.inf)

# %% the root of the logarithm
# says: the square root is taken of ln t only; N(a) stands below it too
# in: with where
# - return np.where(N > 0, Q + c * np.sqrt(np.log(t) / N), np.inf)
# + return np.where(N > 0, Q + c * np.sqrt(np.log(t)) / N, np.inf)

# %% the root of N
# says: the square root is taken of N(a) only; ln t stands below it too
# in: with where
# - return np.where(N > 0, Q + c * np.sqrt(np.log(t) / N), np.inf)
# + return np.where(N > 0, Q + c * np.log(t) / np.sqrt(N), np.inf)

# %% base 10
# says: the logarithm is that to base 10; ln is np.log
# in: with where
# - return np.where(N > 0, Q + c * np.sqrt(np.log(t) / N), np.inf)
# + return np.where(N > 0, Q + c * np.sqrt(np.log10(t) / N), np.inf)

# %% base 2
# says: the logarithm is that to base 2; ln is np.log
# in: with where
# - return np.where(N > 0, Q + c * np.sqrt(np.log(t) / N), np.inf)
# + return np.where(N > 0, Q + c * np.sqrt(np.log2(t) / N), np.inf)

# %% no logarithm
# says: the logarithm is missing: t itself stands below the root
# in: with where
# - return np.where(N > 0, Q + c * np.sqrt(np.log(t) / N), np.inf)
# + return np.where(N > 0, Q + c * np.sqrt(t / N), np.inf)

# %% the logarithm of N
# says: that is the logarithm of N(a); take that of t, all pulls together
# in: with where
# - return np.where(N > 0, Q + c * np.sqrt(np.log(t) / N), np.inf)
# + return np.where(N > 0, Q + c * np.sqrt(np.log(np.maximum(N, 1)) / N), np.inf)

# %% the present pull does not count
# says: t is the number of pulls so far; the present one counts too
# in: with where
# - t = N.sum() + 1
# + t = max(N.sum(), 1)

# %% the number of arms
# says: t is the number of arms; it counts all pulls, and the present one
# in: with where
# - t = N.sum() + 1
# + t = len(N)

# %% the pulls of one arm
# says: t counts the pulls of one arm only; it counts those of all
# in: with where
# - t = N.sum() + 1
# + t = N.max() + 1

# %% divided by t
# says: ln t is divided by t; divide it by the pulls of the arm
# in: with where
# - return np.where(N > 0, Q + c * np.sqrt(np.log(t) / N), np.inf)
# + return np.where(N > 0, Q + c * np.sqrt(np.log(t) / t), np.inf)

# %% c inside
# says: c stands below the root; it is multiplied with the root
# in: with where
# - return np.where(N > 0, Q + c * np.sqrt(np.log(t) / N), np.inf)
# + return np.where(N > 0, Q + np.sqrt(c * np.log(t) / N), np.inf)

# %% no c
# says: c is left out
# in: with where
# - return np.where(N > 0, Q + c * np.sqrt(np.log(t) / N), np.inf)
# + return np.where(N > 0, Q + np.sqrt(np.log(t) / N), np.inf)

# %% no mean
# says: Q(a) is left out: that is the bonus alone
# in: with where
# - return np.where(N > 0, Q + c * np.sqrt(np.log(t) / N), np.inf)
# + return np.where(N > 0, c * np.sqrt(np.log(t) / N), np.inf)

# %% a lower bound
# says: the bonus is subtracted: that is a *lower* bound
# in: with where
# - return np.where(N > 0, Q + c * np.sqrt(np.log(t) / N), np.inf)
# + return np.where(N > 0, Q - c * np.sqrt(np.log(t) / N), np.inf)

# %% times
# says: the mean is multiplied by the bonus; add it
# in: with where
# - return np.where(N > 0, Q + c * np.sqrt(np.log(t) / N), np.inf)
# + return np.where(N > 0, Q * c * np.sqrt(np.log(t) / N), np.inf)

# %% zero for the untried
# says: an arm that was never pulled gets 0; its bound is np.inf, so that it comes first
# in: the solution of upper_bounds
# - bounds = np.full(len(Q), np.inf)
# + bounds = np.zeros(len(Q))

# %% as if pulled once
# says: an arm that was never pulled counts as if it were pulled once; its bound is np.inf
def upper_bounds(Q, N, c):
    return Q + c * np.sqrt(np.log(N.sum() + 1) / np.maximum(N, 1))


# %% the mean for the untried
# says: an arm that was never pulled gets its mean; its bound is np.inf, so that it comes first
# in: the solution of upper_bounds
# - bounds = np.full(len(Q), np.inf)
# + bounds = Q.copy()

# %% minus infinity for the untried
# says: an arm that was never pulled gets −np.inf, and so it comes last; its bound is np.inf
# in: the solution of upper_bounds
# - bounds = np.full(len(Q), np.inf)
# + bounds = np.full(len(Q), -np.inf)


# %% not a number
# says: : nan comes from 0 divided by 0, or from the root of a negative number
def upper_bounds(Q, N, c):
    return Q + c * np.sqrt(np.log(N.sum() + 1) * 0 / N)


# %% the best arm
# says: gives a single value: return the bounds of all arms, and choose none of them
# in: with where
# - return np.where(N > 0, Q + c * np.sqrt(np.log(t) / N), np.inf)
# + return np.argmax(np.where(N > 0, Q + c * np.sqrt(np.log(t) / N), np.inf))


# %% changes what it is given
# says: changes the arrays that it is given: only return the bounds
def upper_bounds(Q, N, c):
    t = 1 + N.sum()
    Q += c * np.sqrt(np.log(t) / np.maximum(N, 1))
    Q[N == 0] = np.inf
    return Q


# %% a number
# says: Q, N and c
upper_bounds = 1.0

# %% twice the logarithm
# says: ln t is doubled, as some books have it; here c alone says how large the bonus is
# in: with where
# - return np.where(N > 0, Q + c * np.sqrt(np.log(t) / N), np.inf)
# + return np.where(N > 0, Q + c * np.sqrt(2 * np.log(t) / N), np.inf)

# %% one pull more
# says: N(a) + 1 stands in place of N(a)
# in: with where
# - return np.where(N > 0, Q + c * np.sqrt(np.log(t) / N), np.inf)
# + return np.where(N > 0, Q + c * np.sqrt(np.log(t) / (N + 1)), np.inf)

# %% one more than the arms
# says: t is one more than the number of arms; it is one more than that of all pulls
# in: with where
# - t = N.sum() + 1
# + t = len(N) + 1

# %% one pull too many
# says: t is one too large: is 1 added twice?
# in: with where
# - return np.where(N > 0, Q + c * np.sqrt(np.log(t) / N), np.inf)
# + return np.where(N > 0, Q + c * np.sqrt(np.log(1 + t) / N), np.inf)

# %% a t for each arm
# says: each arm has a t of its own, with its own pulls; t counts those of all
# in: with where
# - t = N.sum() + 1
# + t = N + 1

# %% N and t the other way round
# says: N(a) and t have changed places
# in: with where
# - return np.where(N > 0, Q + c * np.sqrt(np.log(t) / N), np.inf)
# + return np.where(N > 0, Q + c * np.sqrt(np.log(np.maximum(N, 1)) / t), np.inf)

# %% the fraction the other way round
# says: the fraction below the root is upside down
# in: with where
# - return np.where(N > 0, Q + c * np.sqrt(np.log(t) / N), np.inf)
# + return np.where(N > 0, Q + c * np.sqrt(N / np.log(t)), np.inf)

# %% one pull more for all
# says: 1 is added to every N(a), so that nothing is divided by 0; leave N(a) as it is, and give an arm that was never pulled the bound np.inf
# in: with where
# - return np.where(N > 0, Q + c * np.sqrt(np.log(t) / N), np.inf)
# + return Q + c * np.sqrt(np.log(t) / (N + 1))

# %% all times c
# says: the mean is multiplied by c too; c belongs to the root alone
# in: with where
# - return np.where(N > 0, Q + c * np.sqrt(np.log(t) / N), np.inf)
# + return np.where(N > 0, c * (Q + np.sqrt(np.log(t) / N)), np.inf)

# %% nearly never pulled
# says: the bound of an arm that was never pulled is np.inf itself, and no other number
# in: with where
# - return np.where(N > 0, Q + c * np.sqrt(np.log(t) / N), np.inf)
# + return Q + c * np.sqrt(np.log(t) / (N + 1e-8))

# %% a large number
# says: the bound of an arm that was never pulled is np.inf itself, and no other number
# in: with where
# - return np.where(N > 0, Q + c * np.sqrt(np.log(t) / N), np.inf)
# + return np.where(N > 0, Q + c * np.sqrt(np.log(t) / N), 1e9)

# %% without the untried
# says: should give an array of shape
# in: with where
# - return np.where(N > 0, Q + c * np.sqrt(np.log(t) / N), np.inf)
# + return (Q + c * np.sqrt(np.log(t) / N))[N > 0]

# %% the mean twice
# says: none of the usual mistakes
# in: with where
# - return np.where(N > 0, Q + c * np.sqrt(np.log(t) / N), np.inf)
# + return np.where(N > 0, 2 * Q + c * np.sqrt(np.log(t) / N), np.inf)


# %% all infinite
# says: as long as one arm was never pulled, all bounds are np.inf; each other arm has a bound of its own
def upper_bounds(Q, N, c):
    if 0 in N:
        return np.full(len(Q), np.inf)
    return Q + c * np.sqrt(np.log(N.sum() + 1) / N)


# %% a running t
# says: t grows from arm to arm; add up the pulls of all arms first
# in: a list
# - t = sum(N) + 1
# + t = 1
# - bounds.append(inf if n == 0 else q + c * sqrt(log(t) / n))
# + t += n
# + bounds.append(inf if n == 0 else q + c * sqrt(log(t) / n))


# %% an array of whole numbers
# says: is it rounded, or stored in an array of whole numbers? An array of floats, as of np.zeros(...), keeps what is
def upper_bounds(Q, N, c):
    bounds = np.full_like(N, 10**9)
    for arm in np.flatnonzero(N):
        bounds[arm] = Q[arm] + c * np.sqrt(np.log(N.sum() + 1) / N[arm])
    return bounds
