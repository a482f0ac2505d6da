# %% the other case first
# says: Right: with three doors a table of 16 rows is enough. See it race:
def update(self, notes, place, seen, action):
    notes[place] = action
    if seen < self.num_doors:
        return 0
    return place + 1


# %% arithmetic
def update(self, notes, place, seen, action):
    notes[place] = action
    return (place + 1) * int(seen == self.num_doors)


# %% with a local name
def update(self, notes, place, seen, action):
    marked = seen in range(self.num_doors)
    notes[place] = action
    next_place = place + 1
    if marked:
        next_place = 0
    return next_place
