# %% a dictionary
# says: Right: for the image of 10 by 5 cells that is a number with 362 digits.
def table_entries(rows, columns, kind):
    return (
        3
        * {
            "vectorised": columns * rows * columns,
            "grid": 2 ** (rows * columns),
            "rgb": 256 ** (rows * columns * 3),
        }[kind]
    )


# %% by the spaces
def table_entries(rows, columns, kind):
    from edugym.envs.catch import Catch

    space = Catch.create(rows, columns, kind).observation_space
    if kind == "vectorised":
        return int(np.prod(space.nvec)) * 3
    levels = int(space.high.max()) + 1
    return levels ** math.prod(space.shape) * 3
