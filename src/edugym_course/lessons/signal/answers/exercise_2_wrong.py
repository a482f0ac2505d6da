# %% nothing
# says: Not solved yet
def bits_in(joint):
    raise NotImplementedError


# %% a whole number beyond all real ones
# says: should be a finite number, but is
# says: : is something divided by zero?
def bits_in(joint):
    return 10**400


# %% natural logarithm
# says: the logarithm has the base e; bits need the base 2, `math.log2` or `np.log2`
# in: the solution of bits_in
# - total += joint[x, y] * math.log2(joint[x, y] / (joint[x].sum() * joint[:, y].sum()))
# + total += joint[x, y] * math.log(joint[x, y] / (joint[x].sum() * joint[:, y].sum()))


# %% base 10
# says: the logarithm has the base 10; bits need the base 2, `math.log2` or `np.log2`
def bits_in(joint):
    some = joint > 0
    both = np.outer(joint.sum(axis=1), joint.sum(axis=0))
    return np.sum(joint[some] * np.log10(joint[some] / both[some]))


# %% upside down
# says: the sign is wrong: p(x, y) stands above the line, and p(x) p(y) below
def bits_in(joint):
    some = joint > 0
    both = np.outer(joint.sum(axis=1), joint.sum(axis=0))
    return np.sum(joint[some] * np.log2(both[some] / joint[some]))


# %% zeros
# says: ) gives nan: the logarithm of 0 times 0 is not a number, so leave pairs out that never occur
def bits_in(joint):
    both = np.outer(joint.sum(axis=1), joint.sum(axis=0))
    return np.sum(joint * np.log2(joint / both))


# %% no weights
# says: the weight p(x, y) before the logarithm is missing
def bits_in(joint):
    some = joint > 0
    both = np.outer(joint.sum(axis=1), joint.sum(axis=0))
    return np.sum(np.log2(joint[some] / both[some]))


# %% the wrong weights
# says: the weight before the logarithm should be p(x, y), not p(x) p(y)
def bits_in(joint):
    some = joint > 0
    both = np.outer(joint.sum(axis=1), joint.sum(axis=0))
    return np.sum(both[some] * np.log2(joint[some] / both[some]))


# %% the entropy of the pair
# says: that is −Σ p(x, y) log p(x, y), the entropy of the pair; p(x, y) has to be divided by p(x) p(y)
def bits_in(joint):
    p = joint[joint > 0]
    return -np.sum(p * np.log2(p))


# %% no division
# says: that is Σ p(x, y) log p(x, y): p(x, y) has to be divided by p(x) p(y)
def bits_in(joint):
    total = 0.0
    for p in joint.ravel():
        if p > 0:
            total += p * math.log2(p)
    return total


# %% the entropy of the needs
# says: that is the entropy of x alone: it leaves the message out
def bits_in(joint):
    p = joint.sum(axis=1)
    return -np.sum(p * np.log2(p))


# %% the entropy of the messages
# says: that is the entropy of y alone: it leaves the need out
def bits_in(joint):
    p = joint.sum(axis=0)
    return -np.sum(p * np.log2(p))


# %% what is still open
# says: that is what is still open about x after the message; the information is what the message has told
# in: the solution of bits_in
# - total += joint[x, y] * math.log2(joint[x, y] / (joint[x].sum() * joint[:, y].sum()))
# + total -= joint[x, y] * math.log2(joint[x, y] / joint[:, y].sum())


# %% the columns are missing
# says: p(y) is missing: it divides by p(x) alone
# in: the solution of bits_in
# - total += joint[x, y] * math.log2(joint[x, y] / (joint[x].sum() * joint[:, y].sum()))
# + total += joint[x, y] * math.log2(joint[x, y] / joint[x].sum())


# %% the rows are missing
# says: p(x) is missing: it divides by p(y) alone
# in: the solution of bits_in
# - total += joint[x, y] * math.log2(joint[x, y] / (joint[x].sum() * joint[:, y].sum()))
# + total += joint[x, y] * math.log2(joint[x, y] / joint[:, y].sum())


# %% a mean
# says: that is the *mean* over the pairs; the weights p(x, y) are in the sum already, so add them up
def bits_in(joint):
    both = np.outer(joint.sum(axis=1), joint.sum(axis=0))
    terms = np.zeros(joint.shape)
    some = joint > 0
    terms[some] = joint[some] * np.log2(joint[some] / both[some])
    return terms.mean()


# %% a mean of those that occur
# says: that is the mean over the pairs that occur; the weights p(x, y) are in the sum already
def bits_in(joint):
    both = np.outer(joint.sum(axis=1), joint.sum(axis=0))
    some = joint > 0
    return np.mean(joint[some] * np.log2(joint[some] / both[some]))


# %% return in the loop
# says: only the first row is added up: does the `return` stand inside the loop?
# in: the solution of bits_in
# - return total
# +     return total


# %% return in both loops
# says: the first pair alone: does the `return` stand inside the loops?
# in: the solution of bits_in
# - return total
# +         return total


# %% the last row is left out
# says: the last row is missing in the sum
# in: the solution of bits_in
# - for x in range(joint.shape[0]):
# + for x in range(joint.shape[0] - 1):


# %% no logarithm
# says: the logarithm is missing
def bits_in(joint):
    return np.sum(joint * joint / np.outer(joint.sum(axis=1), joint.sum(axis=0)))


# %% only the right words
# says: only the diagonal is added up; a word that names another need counts too
def bits_in(joint):
    total = 0.0
    for k in range(min(joint.shape)):
        if joint[k, k] > 0:
            total += joint[k, k] * math.log2(joint[k, k] / (joint[k].sum() * joint[:, k].sum()))
    return total


# %% it changes the table
# says: bits_in changes the table that it is given: work with a copy, or with new variables
def bits_in(joint):
    joint /= joint.sum(axis=0)
    return np.sum(joint)


# %% a number
# says: should be a function
bits_in = 2.0


# %% rounded
# says: do not round it
# in: the solution of bits_in
# - return total
# + return round(total, 3)


# %% what is open about y
# says: that is what is still open about y when x is known; the information is what the message has told
def bits_in(joint):
    open_still = 0.0
    for row in joint:
        for p in row:
            if p > 0:
                open_still -= p * math.log2(p / row.sum())
    return open_still


# %% both ways
# says: that is twice the information
def bits_in(joint):
    p_x, p_y = joint.sum(axis=1), joint.sum(axis=0)
    total = 0.0
    for x in range(0, len(p_x)):
        for y in range(len(p_y)):
            if joint[x, y] > 0:
                total += joint[x, y] * math.log2(joint[x, y] / (p_x[x] * p_y[y]))
    return 2 * total


# %% from 1 on
# says: the first row is missing in the sum: indices begin with 0
def bits_in(joint):
    p_x, p_y = joint.sum(axis=1), joint.sum(axis=0)
    total = 0.0
    for x in range(1, len(p_x)):
        for y in range(len(p_y)):
            if joint[x, y] > 0:
                total += joint[x, y] * math.log2(joint[x, y] / (p_x[x] * p_y[y]))
    return total


# %% two bits less what is open
# says: that is 2 bits less the rest; the needs need not be equally likely, and there may be other than four
def bits_in(joint):
    total = 2.0
    for column in joint.T:
        for p in column:
            if p > 0:
                total += p * math.log2(p / column.sum())
    return total


# %% rows and columns changed
# says: that is none of the usual mistakes, so work it out once more by hand
def bits_in(joint):
    total = 0.0
    for x in range(joint.shape[0]):
        for y in range(joint.shape[1]):
            if joint[x, y] > 0:
                total += joint[x, y] * math.log2(joint[x, y] / (joint[x].sum() * joint.sum()))
    return total + 1


# %% entries up to 0.001 left out
# says: very small entries are left out too; leave out only those that are 0
# in: the solution of bits_in
# - if joint[x, y] > 0:
# + if joint[x, y] > 0.001:


# %% entries up to 0.01 left out
# says: very small entries are left out too; leave out only those that are 0
# in: the solution of bits_in
# - if joint[x, y] > 0:
# + if joint[x, y] > 0.01:


# %% entries up to 0.05 left out
# says: small entries are left out too; leave out only those that are 0
# in: the solution of bits_in
# - if joint[x, y] > 0:
# + if joint[x, y] > 0.05:


# %% no brackets
# says: brackets are missing: / p(x) * p(y) divides by p(x) and *multiplies* by p(y)
# in: the solution of bits_in
# - total += joint[x, y] * math.log2(joint[x, y] / (joint[x].sum() * joint[:, y].sum()))
# + total += joint[x, y] * math.log2(joint[x, y] / joint[x].sum() * joint[:, y].sum())


# %% needs equally likely
# says: p(x) is taken to be the same for every need; it is the sum of a row
def bits_in(joint):
    total = 0.0
    for x in range(len(joint)):
        for y in range(joint.shape[1]):
            p = joint[x, y]
            if p > 0:
                total += p * math.log2(p / (joint[:, y].sum() / len(joint)))
    return total


# %% all equally likely
# says: p(x) and p(y) are taken to be the same for every need and every message; they are sums of the table
def bits_in(joint):
    total = 0.0
    for x in range(len(joint)):
        for y in range(joint.shape[1]):
            p = joint[x, y]
            if p > 0:
                total += p * math.log2(p * joint.size)
    return total


# %% overwritten
# says: only the last pair counts: is the sum overwritten in the loop?
def bits_in(joint):
    total = 0.0
    for x in range(len(joint)):
        for y in range(joint.shape[1]):
            p = joint[x, y]
            if p > 0:
                total = p * math.log2(p / (joint[x].sum() * joint[:, y].sum()))
    return total


# %% no signs
# says: a logarithm below 0 counts as well, with its sign
def bits_in(joint):
    total = 0.0
    for x in range(len(joint)):
        for y in range(joint.shape[1]):
            p = joint[x, y]
            if p > 0:
                total += p * abs(math.log2(p / (joint[x].sum() * joint[:, y].sum())))
    return total


# %% one digit
# says: do not round it
def bits_in(joint):
    total = 0.0
    for x in range(len(joint)):
        for y in range(joint.shape[1]):
            p = joint[x, y]
            if p > 0:
                total += p * math.log2(p / (joint[x].sum() * joint[:, y].sum()))
    return round(total, 1)


# %% means
# says: that is the mean of a row and of a column; p(x) and p(y) are their sums
def bits_in(joint):
    total = 0.0
    for x in range(len(joint)):
        for y in range(joint.shape[1]):
            p = joint[x, y]
            if p > 0:
                total += p * math.log2(p / (joint[x].mean() * joint[:, y].mean()))
    return total


# %% likely pairs alone
# says: pairs that are rarer than p(x) p(y) count too, with their sign; leave out only those that never occur
def bits_in(joint):
    total = 0.0
    for x in range(len(joint)):
        for y in range(joint.shape[1]):
            apart = joint[x].sum() * joint[:, y].sum()
            if joint[x, y] > apart:
                total += joint[x, y] * math.log2(joint[x, y] / apart)
    return total


# %% a share
# says: that is a share of the entropy of x; the information itself is asked for
def bits_in(joint):
    needs, messages = joint.sum(axis=1), joint.sum(axis=0)
    entropy = -sum(p * math.log2(p) for p in needs)
    pairs = [(x, y) for x in range(len(needs)) for y in range(len(messages)) if joint[x, y] > 0]
    return sum(joint[x, y] * math.log2(joint[x, y] / (needs[x] * messages[y])) for x, y in pairs) / entropy


# %% a zero ends the row
# says: the first 0 of a row ends the row: `break` leaves the loop, and `continue` goes on with the next pair
def bits_in(joint):
    total = 0.0
    for x in range(len(joint)):
        for y in range(len(joint[x])):
            if joint[x, y] == 0:
                break
            total += joint[x, y] * np.log2(joint[x, y] / (joint[x].sum() * joint[:, y].sum()))
    return total


# %% a zero ends all
# says: the first 0 ends the sum: only that pair adds nothing, and all others count
def bits_in(joint):
    total = 0.0
    for (x, y), p in np.ndenumerate(joint):
        if p == 0:
            return total
        total += p * np.log2(p / (joint[x].sum() * joint[:, y].sum()))
    return total


# %% a small number against zeros
# says: that is close, for all tables: a small number that is added so that no entry is 0 changes the sum; leave out the pairs that never occur
def bits_in(joint):
    p = joint + 1e-4
    return np.sum(p * np.log2(p / np.outer(p.sum(1), p.sum(0))))


# %% the sums in each other's place
# says: raises IndexError: boolean index did not match
# says: two arrays of different sizes meet there: are rows and columns in order?
def bits_in(joint):
    seen = joint > 0
    return np.sum(joint[seen] * np.log2(joint[seen] / np.outer(joint.sum(0), joint.sum(1))[seen]))


# %% from 1 on in both loops
# says: the first row and the first column are missing in the sum: indices begin with 0
def bits_in(joint):
    total = 0.0
    for x in range(1, joint.shape[0]):
        for y in range(1, joint.shape[1]):
            if joint[x, y] > 0:
                total += joint[x, y] * np.log2(joint[x, y] / (joint[x].sum() * joint[:, y].sum()))
    return total


# %% weighted by p(x | y)
# says: p(x | y) should be weighted by p(x, y), and not by itself
def bits_in(joint):
    total = 0.0
    for column in joint.T:
        told = column / column.sum()
        seen = told > 0
        total += np.sum(told[seen] * np.log2(told[seen] / joint.sum(1)[seen]))
    return total


# %% three logarithms without brackets
# says: the weight p(x, y) belongs to all three logarithms: put brackets around their sum
def bits_in(joint):
    total = 0.0
    for (x, y), p in np.ndenumerate(joint):
        if p > 0:
            total += p * math.log2(p) - math.log2(joint[x].sum()) - math.log2(joint[:, y].sum())
    return total


# %% two entropies
# says: H(X) + H(Y) is the sum of two entropies; less that of the pair, H(X, Y), it is the information
def bits_in(joint):
    return -sum((p[p > 0] * np.log2(p[p > 0])).sum() for p in (joint.sum(axis=0), joint.sum(axis=1)))
