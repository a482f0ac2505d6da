# %% not solved
# says: Not solved yet
def update(self, notes, place, seen, action):
    raise NotImplementedError("not solved yet: replace this line")


# %% an instance
# says: should be the class
Notebook = Notebook(make_mdp("MemoryCorridor"))


# %% no return
# says: is a `return` missing?
def update(self, notes, place, seen, action):
    notes[place] = action
    place = place + 1 if seen == self.num_doors else 0


# %% what was seen
# says: it notes what was *seen*, and at an unmarked place that is no door: note the door that was opened
# says: should leave the notes
def update(self, notes, place, seen, action):
    notes[place] = seen
    return place + 1 if seen == self.num_doors else 0


# %% never back
# says: after the marked door the corridor starts again, so the next place is 0
# says: update(notes, place=
def update(self, notes, place, seen, action):
    notes[place] = action
    return place + 1


# %% exchanged
# says: the two cases have changed places: after a *marked* door the corridor starts again
def update(self, notes, place, seen, action):
    notes[place] = action
    return 0 if seen == self.num_doors else place + 1


# %% it stays
# says: the next place is one further, place + 1, where no door is marked
def update(self, notes, place, seen, action):
    notes[place] = action
    return place if seen == self.num_doors else 0


# %% always back
# says: the next place is always 0: compare what was *seen* with num_doors
def update(self, notes, place, seen, action):
    notes[place] = action
    return 0


# %% from one
# says: the first place is 0, not 1
def update(self, notes, place, seen, action):
    notes[place] = action
    return place + 1 if seen == self.num_doors else 1


# %% moves before it writes
# says: the door belongs to the place where it was opened: write the note before you move on
def update(self, notes, place, seen, action):
    place = place + 1 if seen == self.num_doors else 0
    notes[place] = action
    return place


# %% wipes the notes
# says: all notes are wiped out where the corridor starts again, and they are needed there
def update(self, notes, place, seen, action):
    notes[place] = action
    if seen == self.num_doors:
        return place + 1
    notes[:] = self.num_doors
    return 0


# %% notes nothing
# says: the marked door is not noted: write every door into `notes[place]`, marked or not (and into `notes` itself, not
#   into a copy)
def update(self, notes, place, seen, action):
    return place + 1 if seen == self.num_doors else 0


# %% the place is noted
# says: it notes the place instead of the door
def update(self, notes, place, seen, action):
    notes[place] = place
    return place + 1 if seen == self.num_doors else 0


# %% compared with the place
# says: the present place is compared with the number of doors; compare what was *seen* with it
def update(self, notes, place, seen, action):
    notes[place] = action
    return place + 1 if place == self.num_doors else 0


# %% three doors
# says: 3 stands where self.num_doors should
def update(self, notes, place, seen, action):
    notes[place] = action
    return place + 1 if seen == 3 else 0


# %% doors below three
# says: 3 stands where self.num_doors should: where there are more doors, 3 is one of them
def update(self, notes, place, seen, action):
    notes[place] = action
    return 0 if seen < 3 else place + 1


# %% both are returned
# says: should return the next place alone, but returns a
# says: ; the notes are changed in place, so they need not be returned
def update(self, notes, place, seen, action):
    notes[place] = action
    return notes, place + 1 if seen == self.num_doors else 0


# %% the wrong index
# says: it writes the note to `notes[action]`; the index is the place
def update(self, notes, place, seen, action):
    notes[action] = action
    return place + 1 if seen == self.num_doors else 0


# %% the observation as an index
# says: it writes the note to `notes[seen]`; the index is the place
def update(self, notes, place, seen, action):
    notes[seen] = action
    return place + 1 if seen == self.num_doors else 0


# %% two places further
# says: that is none of the usual mistakes, so follow this step by hand
def update(self, notes, place, seen, action):
    notes[place] = action
    return place + 2 if seen == self.num_doors else 0


# %% the note of the place before
# says: the door belongs to `notes[place]`, not to `notes[place - 1]`
def update(self, notes, place, seen, action):
    notes[place - 1] = action
    return place + 1 if seen == self.num_doors else 0


# %% the note of the next place
# says: the door belongs to `notes[place]`, not to `notes[place + 1]`
def update(self, notes, place, seen, action):
    notes[place + 1] = action
    return place + 1 if seen == self.num_doors else 0
