# %% with NumPy
# says: Right: these are the bits of the figures.
def bits_in(joint):
    p_x = joint.sum(axis=1, keepdims=True)
    p_y = joint.sum(axis=0, keepdims=True)
    some = joint > 0
    return np.sum(joint[some] * np.log2(joint[some] / (p_x * p_y)[some]))


# %% from entropies
def entropy(p):
    p = p[p > 0]
    return -np.sum(p * np.log2(p))


def bits_in(joint):
    return entropy(joint.sum(axis=1)) + entropy(joint.sum(axis=0)) - entropy(joint)


# %% entropy less what is open
def bits_in(joint):
    p_x, p_y = joint.sum(axis=1), joint.sum(axis=0)
    before = -sum(p * math.log2(p) for p in p_x if p > 0)
    after = 0.0
    for y in range(len(p_y)):
        for p in joint[:, y] / p_y[y]:
            if p > 0:
                after -= p_y[y] * p * math.log2(p)
    return before - after


# %% natural logarithm, divided
def bits_in(joint):
    total = 0.0
    for x, row in enumerate(joint):
        for y, p in enumerate(row):
            if p != 0:
                total += p * math.log(p / (row.sum() * joint[:, y].sum()))
    return total / math.log(2)


# %% nansum
def bits_in(joint):
    ratio = joint / np.outer(joint.sum(1), joint.sum(0))
    return np.nansum(joint * np.log2(ratio))


# %% with a difference of logarithms
def bits_in(joint):
    total = 0
    rows, columns = joint.shape
    for x in range(rows):
        for y in range(columns):
            p = joint[x][y]
            if p == 0:
                continue
            total = total + p * (math.log2(p) - math.log2(sum(joint[x])) - math.log2(sum(joint[:, y])))
    return total


# %% by the conditional probability
def bits_in(joint):
    total = 0.0
    for y in range(joint.shape[1]):
        p_y = joint[:, y].sum()
        for x in range(joint.shape[0]):
            given_y = joint[x, y] / p_y
            if given_y > 0:
                total += joint[x, y] * np.log2(given_y / joint[x].sum())
    return total
