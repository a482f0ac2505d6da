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
# says: that is what the *smallest* of the means is on average (or is x_w the mean with w losses?)
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


# %% before is not raised
# says: F(x)^k less F of the value before, which is not raised: take off its power too
# in: the solution of largest_promise
# - before = F**n_machines
# + before = F

# %% F is p
# says: F(x) is the probability of *at most* x: add up the probabilities of all values so far
# in: the solution of largest_promise
# - F += comb(n_tries, wins) * 0.5**n_tries
# + F = comb(n_tries, wins) * 0.5**n_tries

# %% the difference backwards
# says: the sign is wrong: F(x)^k less what it was for the value before, and not the other way round
# in: the solution of largest_promise
# - promise += mean * (F**n_machines - before)
# + promise += mean * (before - F**n_machines)

# %% by the machines
# says: the payoffs are divided by the number of machines; the mean of one machine is over its n tries
# in: the solution of largest_promise
# - mean = (wins * win + (n_tries - wins) * lose) / n_tries
# + mean = (wins * win + (n_tries - wins) * lose) / n_machines

# %% a loss subtracted
# says: a loss is subtracted, but `lose` has its sign already
# in: the solution of largest_promise
# - mean = (wins * win + (n_tries - wins) * lose) / n_tries
# + mean = (wins * win - (n_tries - wins) * lose) / n_tries

# %% only what is won
# says: what the lost tries pay is left out
# in: the solution of largest_promise
# - mean = (wins * win + (n_tries - wins) * lose) / n_tries
# + mean = wins * win / n_tries

# %% one order
# says: comb(n, w) is left out: w wins come in so many orders
# in: the solution of largest_promise
# - F += comb(n_tries, wins) * 0.5**n_tries
# + F += 0.5**n_tries

# %% no probability
# says: comb(n, w) alone is no probability: multiply it by that of one order, 0.5^n
# in: the solution of largest_promise
# - F += comb(n_tries, wins) * 0.5**n_tries
# + F += comb(n_tries, wins)

# %% all equally likely
# says: the n + 1 values are not equally likely: w wins have the probability comb(n, w) 0.5^n
# in: the solution of largest_promise
# - F += comb(n_tries, wins) * 0.5**n_tries
# + F += 1 / (n_tries + 1)

# %% to the power of the wins
# says: one order of n tries has the probability 0.5^n, and not 0.5 to the power of its wins
# in: the solution of largest_promise
# - F += comb(n_tries, wins) * 0.5**n_tries
# + F += comb(n_tries, wins) * 0.5**wins

# %% among the machines
# says: the wins are counted among the machines; they are those of one machine, which has n tries
# in: the solution of largest_promise
# - F += comb(n_tries, wins) * 0.5**n_tries
# + F += comb(n_machines, wins) * 0.5**n_machines

# %% return in the loop
# says: only the first term counts, the value without a win: does `return` stand inside the loop?
# in: the solution of largest_promise
# - before = F**n_machines
# + return promise

# %% nothing added up
# says: only the last term counts, the value with n wins: is `=` written for `+=`?
# in: the solution of largest_promise
# - promise += mean * (F**n_machines - before)
# + promise = mean * (F**n_machines - before)


# %% the best payoff
# says: that is the larger payoff itself; it is the mean only if all tries of a machine are wins
def largest_promise(n_machines, n_tries, win, lose):
    return win


# %% no return
# says: None
def largest_promise(n_machines, n_tries, win, lose):
    print((win + lose) / 2)


# %% simulated
# says: that is near in all cases, and exact in none: draw nothing, and add up the n + 1 terms of the sum
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


# %% F too late
# says: F is added up after the term; for x it must hold the probability of *at most* x
def largest_promise(n_machines, n_tries, win, lose):
    promise, F, before = 0.0, 0.0, 0.0
    for wins in range(n_tries + 1):
        promise += (wins * win + (n_tries - wins) * lose) / n_tries * (F**n_machines - before)
        before = F**n_machines
        F += comb(n_tries, wins) * 0.5**n_tries
    return promise


# %% one try too many
# says: the means are divided by n + 1; there are n tries
# in: the solution of largest_promise
# - mean = (wins * win + (n_tries - wins) * lose) / n_tries
# + mean = (wins * win + (n_tries - wins) * lose) / (n_tries + 1)


# %% a share of the losses
# says: parentheses are missing: the whole sum of payoffs is divided by n
# in: the solution of largest_promise
# - mean = (wins * win + (n_tries - wins) * lose) / n_tries
# + mean = wins * win + (n_tries - wins) * lose / n_tries


# %% no values
# says: the values x are left out; the weights alone add up to 1
# in: the solution of largest_promise
# - promise += mean * (F**n_machines - before)
# + promise += F**n_machines - before


# %% the bias
# says: that is the bias, the promise less the mean of one machine; the promise itself is asked
# in: the solution of largest_promise
# - return promise
# + return promise - (win + lose) / 2


# %% a share of it
# says: the sum is divided by the number of machines; it is what the largest mean is already
# in: the solution of largest_promise
# - return promise
# + return promise / n_machines


# %% F from 1
# says: the probability of no win is left out of F: begin with 0 wins
# in: the solution of largest_promise
# - for wins in range(n_tries + 1):
# + for wins in range(1, n_tries + 1):


# %% to the power of the machines
# says: 0.5 is raised to the power of the number of machines; one order of n tries has the probability 0.5^n
# in: the solution of largest_promise
# - F += comb(n_tries, wins) * 0.5**n_tries
# + F += comb(n_tries, wins) * 0.5**n_machines

# %% the index before the first
# says: F before the first value is 0; in Python the index -1 is that of the *last* entry
# in: with differences of F to the power of k
# - return (x * np.diff(at_most, prepend=0)).sum()
# + return sum(x[w] * (at_most[w] - at_most[w - 1]) for w in range(n_tries + 1))

# %% the power rule
# says: k p F(x)^(k - 1) is right for a density; F grows in steps here, so take differences of F(x)^k
# in: with differences of F to the power of k
# - return (x * np.diff(at_most, prepend=0)).sum()
# + return (x * n_machines * p * np.cumsum(p) ** (n_machines - 1)).sum()

# %% machines and tries swapped
# says: the number of machines and that of tries are swapped
# in: with differences of F to the power of k
# - def largest_promise(n_machines, n_tries, win, lose):
# + def largest_promise(n_tries, n_machines, win, lose):

# %% the complement of F
# says: the values x are [-4, 5] here, F of them [0.5, 1], and what F^2 adds at each [0.25, 0.75]: compare these with
#   yours
# says: here, F of them
# says: , and what F^
# in: with differences of F to the power of k
# - return (x * np.diff(at_most, prepend=0)).sum()
# + return (x * np.diff((1 - at_most ** (1 / n_machines)) ** n_machines, prepend=0)).sum()
