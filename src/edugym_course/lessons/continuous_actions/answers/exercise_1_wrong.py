# %% a number
# says: should be a function
# says: joints, bins and cells
preferences = 2 * 30**2 * 5**2


# %% without the box
# says: whether the box is held doubles the number of rows
def preferences(joints, bins, cells):
    return cells**joints * bins**joints


# %% rows
# says: that is the number of rows; each row has a column for every action
def preferences(joints, bins, cells):
    return 2 * cells**joints


# %% actions
# says: that is the number of actions alone; how many rows are there?
def preferences(joints, bins, cells):
    return bins**joints


# %% bins added
# says: the bins of the joints are chosen together: n for each of m joints make n^m actions, not n m
def preferences(joints, bins, cells):
    return 2 * cells**joints * bins * joints


# %% one joint's bins
# says: every joint has bins of its own: n^m actions, not n
def preferences(joints, bins, cells):
    return 2 * cells**joints * bins


# %% one angle
# says: every joint has an angle of its own: c^m cells, not c
def preferences(joints, bins, cells):
    return 2 * cells * bins**joints


# %% angles added
# says: the angles are cut together: c^m cells, not c m
def preferences(joints, bins, cells):
    return 2 * cells * joints * bins**joints


# %% all added
# says: both are powers: m joints have c^m cells and n^m actions
def preferences(joints, bins, cells):
    return 2 * cells * bins * joints


# %% no joints
# says: both are powers: m joints have c^m cells and n^m actions; the joints are missing
def preferences(joints, bins, cells):
    return 2 * cells * bins


# %% rows plus columns
# says: cells and bins multiply, they do not add: every row has all columns
def preferences(joints, bins, cells):
    return 2 * cells**joints + bins**joints


# %% a box for each joint
# says: the box is held by the arm, not by each joint: the factor is 2, not 2^m
def preferences(joints, bins, cells):
    return (2 * cells * bins) ** joints


# %% exchanged
# says: base and exponent have changed places: n^m, not m^n
def preferences(joints, bins, cells):
    return 2 * joints**cells * joints**bins


# %% two more
# says: the 2 multiplies the rows, it is not added to them
def preferences(joints, bins, cells):
    return (2 + cells**joints) * bins**joints


# %% three cells for holding
# says: holding has 2 values; in the lesson's wrapper one of the 3 cells is never used
def preferences(joints, bins, cells):
    return 3 * cells**joints * bins**joints


# %% two joints for ever
# says: that is right for two joints; m joints have c^m cells and n^m actions
def preferences(joints, bins, cells):
    return 2 * cells**2 * bins**2


# %% the table of the wrist
# says: that is right for the two coordinates of the wrist in the lesson; here every joint has an angle of its own: c^m
#   cells, not c^2
def preferences(joints, bins, cells):
    return 2 * cells**2 * bins**joints


# %% a quarter
# says: that is none of the usual mistakes, so work it out by hand for a small case
def preferences(joints, bins, cells):
    return 2 * (cells * bins) ** joints / 4


# %% a text
# says: should be a number, but is the text
def preferences(joints, bins, cells):
    return f"{2 * cells**joints * bins**joints}"


# %% another parameter
# says: its parameters are not those of the exercise
def preferences(joints, bins):
    return 2 * 30**joints * bins**joints


# %% the cells squared
# says: the box is a part of the state: multiply by 2, do not square
def preferences(joints, bins, cells):
    return (cells**joints) ** 2 * bins**joints


# %% floats
# says: digits, and floats and numbers of NumPy have no room for it: keep to Python's whole numbers, with `**` and
#   `//`, without `/`, `2.0` or `math.pow`
def preferences(joints, bins, cells):
    return 2.0 * float(cells) ** joints * bins**joints


# %% with numpy
# says: digits, and floats and numbers of NumPy have no room for it: keep to Python's whole numbers, with `**` and
#   `//`, without `/`, `2.0` or `math.pow`
def preferences(joints, bins, cells):
    return np.prod(np.full(joints, cells)) * np.prod(np.full(joints, bins)) * 2


# %% m^n actions
# says: base and exponent of the bins have changed places: n^m, not m^n
def preferences(joints, bins, cells):
    return 2 * cells**joints * joints**bins


# %% m^c cells
# says: base and exponent of the cells have changed places: c^m, not m^c
def preferences(joints, bins, cells):
    return 2 * joints**cells * bins**joints


# %% times, twice
# says: both are powers: m joints have c^m cells and n^m actions, not c m and n m
def preferences(joints, bins, cells):
    return 2 * cells * joints * bins * joints


# %% held in the action too
# says: holding the box belongs to the state alone, not to the action: one factor of 2
def preferences(joints, bins, cells):
    return (2 * cells**joints) * (2 * bins**joints)


# %% the table of the lesson
# says: those are the numbers of the lesson's table: use `joints`, `bins` and `cells`
def preferences(joints, bins, cells):
    return 2 * 30**2 * 5**2


# %% a caret
# says: `^` is no power in Python, that is `**`
def preferences(joints, bins, cells):
    return 2 * cells ^ joints * bins ^ joints


# %% carets in brackets
# says: `^` is no power in Python, that is `**`, here as well
def preferences(joints, bins, cells):
    return 2 * (cells ^ joints) * (bins ^ joints)


# %% one row more, nearly as many as without the box
# says: that is none of the usual mistakes, so work it out by hand for a small case
def preferences(joints, bins, cells):
    return (cells**joints + 1) * bins**joints


# %% NumPy without its import
# says: (`import` it first)
def preferences(joints, bins, cells):
    return 2 * int(random.prod([cells * bins] * joints))


# %% a range too short
# says: one joint is missing: is a range too short, or a power too low?
def preferences(joints, bins, cells):
    size = 2
    for _ in range(1, joints):
        size *= bins * cells
    return size


# %% a joint too many
# says: there is one joint too many in the power of the cells
def preferences(joints, bins, cells):
    return 2 * cells ** (joints + 1) * bins**joints


# %% a binomial
# says: the joints choose one after another, so that order counts and a bin may come twice: n^m, not a binomial
def preferences(joints, bins, cells):
    return 2 * cells**joints * math.comb(bins, joints)
