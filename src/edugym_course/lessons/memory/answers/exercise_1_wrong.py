# %% no placeholder replaced
# says: Not solved yet
def table_rows(num_doors, length):
    raise NotImplementedError("not solved yet: replace this line")


# %% a number
# says: should be a function
# says: the doors and the length
table_rows = 4**7


# %% no mark is forgotten
# says: an unmarked place is an observation too, so there are N + 1 different ones
def table_rows(num_doors, length):
    return num_doors ** (length * (length - 1) // 2 + 1)


# %% without the present observation
# says: the present observation is in the window as well: L(L-1)/2 steps back, and one
def table_rows(num_doors, length):
    return (num_doors + 1) ** (length * (length - 1) // 2)


# %% a window of L
# says: a window of L is not enough without the actions: the first mark lies L(L-1)/2 steps back
def table_rows(num_doors, length):
    return (num_doors + 1) ** length


# %% all steps up to the end
# says: L(L+1)/2 counts the steps to the end of corridor L; the mark that is needed lies only L(L-1)/2 steps back
def table_rows(num_doors, length):
    return (num_doors + 1) ** (length * (length + 1) // 2)


# %% the entries
# says: that is the number of entries, a row has one for each action; the rows are asked for
def table_rows(num_doors, length):
    return num_doors * (num_doors + 1) ** (length * (length - 1) // 2 + 1)


# %% with actions
# says: that is the table with the actions in the window; here it shows observations alone
def table_rows(num_doors, length):
    window = max(length, 2 * length - 3)
    return (num_doors + 1) ** window * num_doors ** (window - 1)


# %% the other law
# says: 2L - 3 belongs to windows with actions; observations alone need L(L-1)/2 + 1
def table_rows(num_doors, length):
    return (num_doors + 1) ** max(length, 2 * length - 3)


# %% the window
# says: that is the window itself; how many different windows are there?
def table_rows(num_doors, length):
    return length * (length - 1) // 2 + 1


# %% a product
# says: each observation in the window multiplies the number of rows by N + 1: take the power, not the product
def table_rows(num_doors, length):
    return (num_doors + 1) * (length * (length - 1) // 2 + 1)


# %% exchanged
# says: base and exponent have changed places
def table_rows(num_doors, length):
    return (length * (length - 1) // 2 + 1) ** (num_doors + 1)


# %% one corridor too far
# says: that is the window for corridor L + 1
def table_rows(num_doors, length):
    return (num_doors + 1) ** (length * (length + 1) // 2 + 1)


# %% not halved
# says: L(L-1) should be divided by 2
def table_rows(num_doors, length):
    return (num_doors + 1) ** (length * (length - 1) + 1)


# %% exclusive or
# says: should be
# says: `^` is no power in Python, that is `**`
def table_rows(num_doors, length):
    return (num_doors + 1) ^ (length * (length - 1) // 2 + 1)


# %% two for the unmarked
# says: an unmarked place counts once too often: there are N + 1 observations
def table_rows(num_doors, length):
    return (num_doors + 2) ** (length * (length - 1) // 2 + 1)


# %% the square halved
# says: L^2 / 2 + 1 is not L(L-1)/2 + 1
def table_rows(num_doors, length):
    return (num_doors + 1) ** (length**2 // 2 + 1)


# %% a power of a float
# says: digits, and floats and numbers of NumPy have no room for it: keep to Python's whole numbers, with `**` and
#   `//`, without `/`, `2.0` or `math.pow`
def table_rows(num_doors, length):
    return (num_doors + 1) ** (length * (length - 1) / 2 + 1)


# %% the base for three doors
# says: 4 is the base for three doors alone; write it with N, the number of doors
def table_rows(num_doors, length):
    return 4 ** (length * (length - 1) // 2 + 1)


# %% one row less
# says: each of the L(L-1)/2 + 1 observations in the window is any of all that there are, whatever the others are: windows that never occur have rows too, and their order counts
def table_rows(num_doors, length):
    return (num_doors + 1) ** (length * (length - 1) // 2 + 1) - 1


# %% no brackets in the law
# says: set brackets: L * L - 1 // 2 multiplies and divides before it subtracts
def table_rows(num_doors, length):
    return (num_doors + 1) ** (length * length - 1 // 2 + 1)


# %% no brackets around the exponent
# says: set brackets around the whole exponent: a power is taken before a product
def table_rows(num_doors, length):
    return (num_doors + 1) ** length * (length - 1) // 2 + 1


# %% no brackets in the base
# says: set brackets around N + 1: a power is taken before the sum
def table_rows(num_doors, length):
    k = length * (length - 1) // 2 + 1
    return num_doors + 1**k


# %% with the actions between them
# says: the window shows observations alone here, so the actions do not multiply the rows
def table_rows(num_doors, length):
    k = length * (length - 1) // 2 + 1
    return (num_doors + 1) ** k * num_doors ** (k - 1)


# %% bytes
# says: those are the bytes of the values; the rows are asked for
def table_rows(num_doors, length):
    return 3 * 8 * (num_doors + 1) ** (length * (length - 1) // 2 + 1)


# %% shorter windows too
# says: the windows of all lengths are added up; an episode starts with copies of its first observation, so all have
#   the full length
def table_rows(num_doors, length):
    k = length * (length - 1) // 2 + 1
    return sum((num_doors + 1) ** shorter for shorter in range(1, k + 1))


# %% the corridor before
# says: that is the window for corridor L - 1
def table_rows(num_doors, length):
    return (num_doors + 1) ** ((length - 1) * (length - 2) // 2 + 1)


# %% one more
# says: L(L-1)/2 observations and the present one make L(L-1)/2 + 1; here is one more
def table_rows(num_doors, length):
    return (num_doors + 1) ** (length * (length - 1) // 2 + 2)


# %% the window of the prediction
# says: 7 is the window of corridor 4 alone; compute it from the length
def table_rows(num_doors, length):
    return (num_doors + 1) ** 7


# %% a third in place of a half, which is 2L - 3 for some lengths
# says: the base
# says:  is right. The window has
# says:  observations here, and you take
def table_rows(num_doors, length):
    return (num_doors + 1) ** (length * (length - 1) // 3 + 1)


# %% a table for each corridor
# says: the tables of all corridors up to L are added up; the window of the longest one serves them all
def table_rows(num_doors, length):
    return sum((num_doors + 1) ** (n * (n - 1) // 2 + 1) for n in range(1, length + 1))


# %% less one
# says: the present observation is added to L(L-1)/2, not subtracted
def table_rows(num_doors, length):
    return (num_doors + 1) ** max(length * (length - 1) // 2 - 1, 0)


# %% marked or not
# says: the window of
# says:  is right. There are
# says:  different observations, and you take
def table_rows(num_doors, length):
    return 2 ** (length * (length - 1) // 2 + 1)
