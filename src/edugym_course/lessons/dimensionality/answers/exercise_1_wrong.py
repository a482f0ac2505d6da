# %% rows alone
# says: that is the number of rows; each of them holds a number for each of the actions
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return columns * rows * columns
    return 2 ** (rows * columns) if kind == "grid" else 256 ** (rows * columns * 3)


# %% no paddle
# says: the paddle's column is missing: the agent sees it too
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns * 3
    return 3 * (2 ** (rows * columns) if kind == "grid" else 256 ** (rows * columns * 3))


# %% a row for the paddle
# says: the paddle stays in its row, and so it has no row of its own in the observation
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns * rows * columns * 3
    return 3 * (2 ** (rows * columns) if kind == "grid" else 256 ** (rows * columns * 3))


# %% the paper's slip
# says: the ball has a column of its own, with as many values as there are columns
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * rows * columns * 3
    return 3 * (2 ** (rows * columns) if kind == "grid" else 256 ** (rows * columns * 3))


# %% added
# says: the numbers of values are multiplied, not added
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return (rows + columns + columns) * 3
    return 3 * (2 ** (rows * columns) if kind == "grid" else 256 ** (rows * columns * 3))


# %% base and exponent
# says: base and exponent have changed places: each of the pixels has 2 values
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return 3 * ((rows * columns) ** 2 if kind == "grid" else 256 ** (rows * columns * 3))


# %% base and exponent of the image
# says: base and exponent have changed places
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return 2 ** (rows * columns) * 3 if kind == "grid" else (3 * rows * columns) ** 256 * 3


# %% colours as a power
# says: three colours: the exponent is 3 times the number of cells, not the number of cells to the power of 3
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return 2 ** (rows * columns) * 3 if kind == "grid" else 256 ** (rows * columns) ** 3 * 3


# %% a product
# says: the values of the pixels multiply: take 2 to the power of the number of pixels
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return 3 * (2 * rows * columns if kind == "grid" else 256 ** (rows * columns * 3))


# %% what occurs
# says: those are the boards with one ball and one paddle; a dense table has a row for every board that could be written
#   down (or does this branch serve every kind, as after `kind == ... or ...`?)
def table_entries(rows, columns, kind):
    return rows * columns**2 * 3


# %% one number a cell
# says: each cell has three numbers: red, green and blue
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return 3 * (2 if kind == "grid" else 256) ** (rows * columns)


# %% 255 values
# says: from 0 to 255 there are 256 values
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return 3 * (2 ** (rows * columns) if kind == "grid" else 255 ** (rows * columns * 3))


# %% a binary image
# says: a number of the image has 256 values, not 2
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return 3 * 2 ** (rows * columns * (1 if kind == "grid" else 3))


# %% the image is the grid
# says: that is the grid; the image has three numbers for each cell, with 256 values
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return 3 * 2 ** (rows * columns)


# %% actions in the exponent
# says: multiply by the number of actions; do not take the power
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return 2 ** (rows * columns * 3) if kind == "grid" else 256 ** (rows * columns * 3) * 3


# %% actions added in the exponent
# says: multiply by the number of actions at the end, outside of the power
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return 2 ** (rows * columns + 3) if kind == "grid" else 256 ** (rows * columns * 3) * 3


# %% one power for all numbers
# says: each number has its own number of values, so multiply these: there is no power here
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return 3 * 3 ** (rows * columns)
    return 3 * (2 ** (rows * columns) if kind == "grid" else 256 ** (rows * columns * 3))


# %% the grid for the numbers
# says: that is the formula for the grid
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return 2 ** (rows * columns) * 3
    return 3 * (2 ** (rows * columns) if kind == "grid" else 256 ** (rows * columns * 3))


# %% the power of the actions
# says: a row has an entry for each action, so multiply by their number; no power is taken
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return (rows * columns**2) ** 3
    return 3 * (2 ** (rows * columns) if kind == "grid" else 256 ** (rows * columns * 3))


# %% without the last row
# says: the last row belongs to the observations that could be written down, too
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return (rows - 1) * columns**2 * 3
    return 3 * (2 ** (rows * columns) if kind == "grid" else 256 ** (rows * columns * 3))


# %% pixels times actions
# says: that is the number of pixels times the actions
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return rows * columns * 3 if kind == "grid" else 256 ** (rows * columns * 3) * 3


# %% 256 values in the grid
# says: each pixel has 2 values here, not 256
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return 256 ** (rows * columns) * 3 if kind == "grid" else 256 ** (rows * columns * 3) * 3


# %% 3 values in the grid
# says: a pixel of the grid is 0 or 1, and that is all: there are 2 values, not 3
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return 3 ** (rows * columns) * 3 if kind == "grid" else 256 ** (rows * columns * 3) * 3


# %% three numbers for a cell
# says: the grid has one number for each cell, not three
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return 2 ** (rows * columns * 3) * 3 if kind == "grid" else 256 ** (rows * columns * 3) * 3


# %% the sum of the sides
# says: the number of pixels is rows times columns, not their sum
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return 2 ** (rows + columns) * 3 if kind == "grid" else 256 ** (rows * columns * 3) * 3


# %% a product for the image
# says: the values of the numbers multiply: take a power
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return 2 ** (rows * columns) * 3 if kind == "grid" else 256 * rows * columns * 3 * 3


# %% what occurs in the image
# says: those are the boards with one ball and one paddle; a dense table has a row for every image that could be written
#   down (or does this branch serve every kind, as after `kind == ... or ...`?)
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return 2 ** (rows * columns) * 3 if kind == "grid" else rows * columns**2 * 3


# %% colours outside of the exponent
# says: the three colours belong in the exponent
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return 2 ** (rows * columns) * 3 if kind == "grid" else 256 ** (rows * columns) * 3 * 3


# %% a floating overflow
# says: raises OverflowError
def table_entries(rows, columns, kind):
    return float(10) ** 400


# %% whole numbers of NumPy
# says: NumPy's whole numbers overflow here; use Python's `**`
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return np.prod(np.full(rows * columns * (1 if kind == "grid" else 3), 2 if kind == "grid" else 256)) * 3


# %% the default board
# says: should be
# says: that is the board of the lesson, 10 by 5: use `rows` and `columns`
def table_entries(rows, columns, kind):
    return {"vectorised": 750, "grid": 3 * 2**50, "rgb": 3 * 256**150}[kind]


# %% a number
# says: should be a function
# says: rows, columns and kind
table_entries = 3 * 2**50


# %% counted from 0
# says: positions count from 0, but there are still `rows` of them, and `columns`
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return (rows - 1) * (columns - 1) ** 2 * 3
    return {"grid": 2, "rgb": 256**3}[kind] ** (rows * columns) * 3


# %% powers of floats
# says: digits, and floats and numbers of NumPy have no room for it: keep to Python's whole numbers, with `**` and
#   `//`, without `/`, `2.0` or `math.pow`
# says: should be a whole number with
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return columns * rows * columns * 3
    return (2.0 if kind == "grid" else 256.0) ** (rows * columns * (1 if kind == "grid" else 3)) * 3


# %% a board of one row more
# says: an observation is three numbers here, the ball's column, its row and the paddle's column: how many values has each, and how many triples do they make?
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return (rows + 1) * columns * columns * 3
    return {"grid": 2, "rgb": 256**3}[kind] ** (rows * columns) * 3


# %% the board of the lesson for the grid alone
# says: 'grid') should be
# says: that is the board of the lesson, 10 by 5: use `rows` and `columns`
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns**2 * 3
    return 3 * 2**50 if kind == "grid" else 3 * 256 ** (rows * columns * 3)


# %% bytes
# says: those are bytes, 8 for each number; the numbers are asked for
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns * columns * 3 * 8
    return {"grid": 2, "rgb": 256**3}[kind] ** (rows * columns) * 3 * 8


# %% a caret
# says: `^` is no power in Python, that is `**`
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns * columns * 3
    return 2 ^ (rows * columns) * 3 if kind == "grid" else 256 ^ (3 * rows * columns) * 3


# %% a caret, and the actions first
# says: `^` is no power in Python, that is `**` (and it comes after `*`)
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return 3 * rows * columns * columns
    return 3 * 2 ^ (rows * columns) if kind == "grid" else 3 * 256 ^ (3 * rows * columns)


# %% the colours in the base
# says: each of the three colours has 256 values: 256^3 for a cell, not 256 times 3
def table_entries(rows, columns, kind):
    if kind == "vectorised":
        return rows * columns * columns * 3
    return (2 if kind == "grid" else 256 * 3) ** (rows * columns) * 3


# %% a kind that is spelt in another way
# says: that is the formula for the image: is the word "vectorised" spelt as here?
def table_entries(rows, columns, kind):
    if kind == "vectorized":
        return 3 * rows * columns**2
    if kind == "grid":
        return 3 * 2 ** (rows * columns)
    return 3 * 256 ** (3 * rows * columns)


# %% how many numbers are seen
# says: the agent sees three numbers, and a table has a row for all values that these can take together
def table_entries(rows, columns, kind):
    return 3 * {"vectorised": 3, "grid": rows * columns, "rgb": 3 * rows * columns}[kind]


# %% one image less
# says:  should be a number that is
# says:  by
def table_entries(rows, columns, kind):
    return {"vectorised": 3 * rows * columns**2, "grid": 3 * 2 ** (rows * columns)}.get(kind) or 3 * (
        256 ** (3 * rows * columns) - 1
    )


# %% actions are added
# says: multiply by the number of actions, do not add it
def table_entries(rows, columns, kind):
    return {"vectorised": rows * columns**2, "grid": 2 ** (rows * columns)}.get(kind, 256 ** (3 * rows * columns)) + 3


# %% columns alone
# says: the ball's row is missing: it falls, and so it is in another one at each step
def table_entries(rows, columns, kind):
    return 3 * {"vectorised": columns**2, "grid": 2 ** (rows * columns)}.get(kind, 256 ** (3 * rows * columns))


# %% a condition that is always true
# says: (or does this branch serve every kind, as after
def table_entries(rows, columns, kind):
    if kind == "vectorised" or "grid":
        return 3 * rows * columns**2
    return 3 * 256 ** (3 * rows * columns)


# %% the grid and the image have changed places
# says: that is the formula for the image; in the grid each cell has one number, 0 or 1
def table_entries(rows, columns, kind):
    return 3 * {"vectorised": rows * columns**2, "rgb": 2 ** (rows * columns)}.get(kind, 256 ** (3 * rows * columns))


# %% boards with two different pixels
# says: every board that could be written down has a row, also one that never occurs, with no ball or with two: each pixel is 0 or 1, whatever the others are
def table_entries(rows, columns, kind):
    pixels = rows * columns
    if kind == "vectorised":
        return rows * columns**2 * 3
    return 3 * (pixels * (pixels - 1) // 2 if kind == "grid" else 256 ** (3 * pixels))
