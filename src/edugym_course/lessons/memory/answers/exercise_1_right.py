# %% in one line
# says: Right: corridor 7 with three doors needs 4^22 rows, about 18 million million.
def table_rows(num_doors, length):
    return (num_doors + 1) ** (length * (length - 1) // 2 + 1)


# %% by a loop over the corridors
def table_rows(num_doors, length):
    rows = num_doors + 1
    for corridor in range(1, length):
        for place in range(corridor):
            rows *= num_doors + 1
    return rows


# %% with a sum
def table_rows(num_doors, length):
    window = sum(range(length)) + 1
    return (num_doors + 1) ** window
