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
# says: the marked door is not noted: write every door into `notes[place]`, marked or not (with `=`, not `==`, and into `notes` itself, not
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


# %% both are wrong
# says: that is none of the usual mistakes, so follow this step by hand
def update(self, notes, place, seen, action):
    notes[place] = self.num_doors
    return place + 2 if seen == self.num_doors else 0


# %% two steps at once
# says: what is noted is right. The next place is `place + 1`, or 0 if `seen` is a door
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


# %% index and value
# says: it writes the place to `notes[action]`: index and value have changed places
def update(self, notes, place, seen, action):
    notes[action] = place
    return place + 1 if seen == self.num_doors else 0


# %% doors from 1
# says: it notes the door plus 1; doors count from 0, and N stands for nothing
def update(self, notes, place, seen, action):
    notes[place] = action + 1
    return place + 1 if seen == self.num_doors else 0


# %% seen is a number
# says: `if seen` is true for every door but 0; compare with self.num_doors
def update(self, notes, place, seen, action):
    notes[place] = action
    if seen:
        return place + 1
    return 0


# %% seen is a mark
# says: `if seen` is true for every door but 0, and for no mark as well; compare with self.num_doors
def update(self, notes, place, seen, action):
    notes[place] = action
    return 0 if seen else place + 1


# %% stays there
# says: the finger stays at the marked place; there the corridor starts again, so the next place is 0
def update(self, notes, place, seen, action):
    notes[place] = action
    if seen == self.num_doors:
        place += 1
    return place


# %% a remainder
# says: a corridor may be longer than its number of doors: no remainder is needed, a mark shows the last place
def update(self, notes, place, seen, action):
    notes[place] = action
    return (place + 1) % self.num_doors


# %% no self
# says: write `self.` before a field or a method
def update(self, notes, place, seen, action):
    notes[place] = action
    return place + 1 if seen == num_doors else 0


# %% a list's method
# says: an array keeps its size: write into an entry of it
def update(self, notes, place, seen, action):
    notes.append(action)
    return place + 1 if seen == self.num_doors else 0


# %% back to -1
# says: the first place is 0; −1 is the last line of an array
def update(self, notes, place, seen, action):
    notes[place] = action
    return place + 1 if seen == self.num_doors else -1


# %% the last door
# says: doors are 0 to N - 1, and N itself is no mark: compare with self.num_doors, not with one less
def update(self, notes, place, seen, action):
    notes[place] = action
    return place + 1 if seen == self.num_doors - 1 else 0


# %% one note
# says: the other notes are wiped out, and they are still needed: write into `notes[place]` alone
def update(self, notes, place, seen, action):
    notes[:] = self.num_doors
    notes[place] = action
    return place + 1 if seen == self.num_doors else 0


# %% all lines from here on
# says: the lines behind the place are written as well: the index is the place alone
def update(self, notes, place, seen, action):
    notes[place:] = action
    return place + 1 if seen == self.num_doors else 0


# %% all lines
# says: all lines are written: the index is the place alone
def update(self, notes, place, seen, action):
    notes[:] = action
    return place + 1 if seen == self.num_doors else 0


# %% a note that grows
# says: the door is added to the note that stands there: set it, with = and not with +=
def update(self, notes, place, seen, action):
    notes[place] += action
    return place + 1 if seen == self.num_doors else 0


# %% an empty line for the end
# says: that the next line is empty does not make this the last place: in a first walk it is empty everywhere. Only a
#   mark tells
def update(self, notes, place, seen, action):
    notes[place] = action
    return 0 if notes[place + 1] == self.num_doors else place + 1


# %% the lines up to here
# says: the lines before the place are written as well: the index is the place alone
def update(self, notes, place, seen, action):
    notes[: place + 1] = action
    return place + 1 if seen == self.num_doors else 0


# %% nothing as a note
# says: the next place is right. The note is the door that was opened, `action`, at the index `place` alone
def update(self, notes, place, seen, action):
    notes[place] = self.num_doors
    return place + 1 if seen == self.num_doors else 0


# %% four places
# says: should return 5, but returns 0
# says: what is noted is right. The next place is `place + 1`, or 0 if `seen` is a door
def update(self, notes, place, seen, action):
    notes[place] = action
    return place + 1 if seen == self.num_doors and place < 4 else 0


# %% thirty lines
# says: , ...] (from line 28 on)
# says: the next place is right. The note is the door that was opened, `action`, at the index `place` alone
def update(self, notes, place, seen, action):
    notes[min(place, 30)] = action
    return place + 1 if seen == self.num_doors else 0


# %% an array for the place
# says: should return a whole number, but returns an array: write int(...) around it
def update(self, notes, place, seen, action):
    notes[place] = action
    return np.where(seen == self.num_doors, place + 1, 0)
