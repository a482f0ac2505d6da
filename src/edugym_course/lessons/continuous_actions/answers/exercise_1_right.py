# %% in one line
# slow
# says: Right: with 6 joints, 30 cells and 5 bins that is 2.3e+13, 1.5e+09 rows of 15 625 columns. A
#   Gaussian has 6 means in each row.
def preferences(joints, bins, cells):
    return 2 * cells**joints * bins**joints


# %% rows and columns
def preferences(joints, bins, cells):
    holding = 2
    angles = math.prod([cells] * joints)
    actions = len(list(itertools.product(range(bins), repeat=joints)))
    return holding * angles * actions
