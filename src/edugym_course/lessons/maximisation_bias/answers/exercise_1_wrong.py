# %% the mean of one machine
# says: that is the mean of one machine; the largest of several is larger: F(x) to the power of the number of machines
def largest_promise(n_machines, n_tries, win, lose):
    return (win + lose) / 2


# %% to the power of the tries
# says: F is raised to the power of the number of tries; raise it to that of the machines
# in: with differences of F to the power of k
# - at_most = np.cumsum(p) ** n_machines
# + at_most = np.cumsum(p) ** n_tries

# %% the smallest
# says: that is what the *smallest* of the means is on average
# in: with differences of F to the power of k
# - at_most = np.cumsum(p) ** n_machines
# + at_most = 1 - (1 - np.cumsum(p)) ** n_machines

# %% no differences
# says: each value is weighed by F(x)^k, the probability that the largest mean is *at most* x; take off what it was for
#   the value before
# in: with differences of F to the power of k
# - return (x * np.diff(at_most, prepend=0)).sum()
# + return (x * at_most).sum()

# %% p to the power of k
# says: each value is weighed by p(x)^k, the probability that *all* machines have this mean
# in: with differences of F to the power of k
# - return (x * np.diff(at_most, prepend=0)).sum()
# + return (x * p**n_machines).sum()

# %% k times p
# says: each value is weighed by k p(x), as if only one machine could be lucky at a time
# in: with differences of F to the power of k
# - return (x * np.diff(at_most, prepend=0)).sum()
# + return (x * p * n_machines).sum()

# %% not a mean
# says: the payoffs are added up; a mean is divided by the number of tries
# in: with differences of F to the power of k
# - x = np.array([(w * win + (n_tries - w) * lose) / n_tries for w in range(n_tries + 1)])
# + x = np.array([(w * win + (n_tries - w) * lose) for w in range(n_tries + 1)])

# %% all wins left out
# says: the value with n wins is left out: there are n + 1 values, from 0 wins to n
# in: the solution of largest_promise
# - for wins in range(n_tries + 1):
# + for wins in range(n_tries):

# %% no wins left out
# says: the value without a win is left out: there are n + 1 values, from 0 wins to n
# in: with differences of F to the power of k
# - return (x * np.diff(at_most, prepend=0)).sum()
# + return (x * np.diff(at_most, prepend=0))[1:].sum()

# %% times the machines
# says: the sum is multiplied by the number of machines; only one of them has the largest mean
# in: with differences of F to the power of k
# - return (x * np.diff(at_most, prepend=0)).sum()
# + return n_machines * (x * np.diff(at_most, prepend=0)).sum()


# %% no return
# says: None
def largest_promise(n_machines, n_tries, win, lose):
    print((win + lose) / 2)


# %% simulated
# says: none of the usual mistakes
def largest_promise(n_machines, n_tries, win, lose):
    rng = np.random.default_rng(0)
    means = rng.choice([win, lose], (1000, n_machines, n_tries)).mean(axis=2)
    return means.max(axis=1).mean()


# %% a list of terms
# says: largest_promise(
# in: with differences of F to the power of k
# - return (x * np.diff(at_most, prepend=0)).sum()
# + return list(x * np.diff(at_most, prepend=0))

# %% a number
# says: n_machines, n_tries, win and lose
largest_promise = 0.558
