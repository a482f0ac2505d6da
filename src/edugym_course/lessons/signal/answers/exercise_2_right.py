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


# %% natural logarithm, divided
def bits_in(joint):
    total = 0.0
    for x, row in enumerate(joint):
        for y, p in enumerate(row):
            if p != 0:
                total += p * math.log(p / (row.sum() * joint[:, y].sum()))
    return total / math.log(2)
