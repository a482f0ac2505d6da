# ruff: noqa
# Right and wrong answers to the exercises of lesson 5; tests/lessons/test_answers.py tries them all.
# An answer stands in the place of the exercise's cell. Methods without their class replace those of the solution.


# %% exercise 1, right: in one line
# says: Right: corridor 7 with three doors needs 4^22 rows, about 18 million million.
def table_rows(num_doors, length):
    return (num_doors + 1) ** (length * (length - 1) // 2 + 1)


# %% exercise 1, right: with the package's law
def table_rows(num_doors, length):
    return (num_doors + 1) ** memory.window_law(length)


# %% exercise 1, right: with stack_size
def table_rows(num_doors, length):
    window = length * (length - 1) // 2 + 1
    return stack_size(num_doors + 1, window)


# %% exercise 1, right: by a loop over the corridors
def table_rows(num_doors, length):
    rows = num_doors + 1
    for corridor in range(1, length):
        for place in range(corridor):
            rows *= num_doors + 1
    return rows


# %% exercise 1, right: with a sum
def table_rows(num_doors, length):
    window = sum(range(length)) + 1
    return float(num_doors + 1) ** window


# %% exercise 1, right: by trying windows
def table_rows(num_doors, length):
    k = memory.smallest_window(length)
    return (num_doors + 1) ** k


# %% exercise 1, right: with numpy
def table_rows(num_doors, length):
    return np.prod(np.full(int(length * (length - 1) / 2) + 1, num_doors + 1, dtype=float))


# %% exercise 1, wrong: no placeholder replaced
# says: Not solved yet
def table_rows(num_doors, length):
    raise NotImplementedError("not solved yet: replace this line")


# %% exercise 1, wrong: dots
# says: Not solved yet
table_rows = ...


# %% exercise 1, wrong: a number
# says: should be a function
# says: the doors and the length
table_rows = 4**7


# %% exercise 1, wrong: no return
# says: is a `return` missing?
def table_rows(num_doors, length):
    window = length * (length - 1) // 2 + 1
    rows = (num_doors + 1) ** window


# %% exercise 1, wrong: printed
# says: is a `return` missing?
def table_rows(num_doors, length):
    print((num_doors + 1) ** (length * (length - 1) // 2 + 1))


# %% exercise 1, wrong: no mark is forgotten
# says: an unmarked place is an observation too, so there are N + 1 different ones
def table_rows(num_doors, length):
    return num_doors ** (length * (length - 1) // 2 + 1)


# %% exercise 1, wrong: without the present observation
# says: the present observation is in the window as well: L(L-1)/2 steps back, and one
def table_rows(num_doors, length):
    return (num_doors + 1) ** (length * (length - 1) // 2)


# %% exercise 1, wrong: a window of L
# says: a window of L is not enough without the actions: the first mark lies L(L-1)/2 steps back
def table_rows(num_doors, length):
    return (num_doors + 1) ** length


# %% exercise 1, wrong: all steps up to the end
# says: L(L+1)/2 counts the steps to the end of corridor L; the mark that is needed lies only L(L-1)/2 steps back
def table_rows(num_doors, length):
    return (num_doors + 1) ** (length * (length + 1) // 2)


# %% exercise 1, wrong: the entries
# says: that is the number of entries, a row has one for each action; the rows are asked for
def table_rows(num_doors, length):
    return num_doors * (num_doors + 1) ** (length * (length - 1) // 2 + 1)


# %% exercise 1, wrong: with actions
# says: that is the table with the actions in the window; here it shows observations alone
def table_rows(num_doors, length):
    window = max(length, 2 * length - 3)
    return (num_doors + 1) ** window * num_doors ** (window - 1)


# %% exercise 1, wrong: the other law
# says: 2L - 3 belongs to windows with actions; observations alone need L(L-1)/2 + 1
def table_rows(num_doors, length):
    return (num_doors + 1) ** max(length, 2 * length - 3)


# %% exercise 1, wrong: the window
# says: that is the window itself; how many different windows are there?
def table_rows(num_doors, length):
    return length * (length - 1) // 2 + 1


# %% exercise 1, wrong: a product
# says: each observation in the window multiplies the number of rows by N + 1: take the power, not the product
def table_rows(num_doors, length):
    return (num_doors + 1) * (length * (length - 1) // 2 + 1)


# %% exercise 1, wrong: exchanged
# says: base and exponent have changed places
def table_rows(num_doors, length):
    return (length * (length - 1) // 2 + 1) ** (num_doors + 1)


# %% exercise 1, wrong: one corridor too far
# says: that is the window for corridor L + 1
def table_rows(num_doors, length):
    return (num_doors + 1) ** (length * (length + 1) // 2 + 1)


# %% exercise 1, wrong: not halved
# says: L(L-1) should be divided by 2
def table_rows(num_doors, length):
    return (num_doors + 1) ** (length * (length - 1) + 1)


# %% exercise 1, wrong: three doors for ever
# says: should be
def table_rows(num_doors, length):
    return 4 ** (length * (length - 1) // 2 + 1)


# %% exercise 1, wrong: exclusive or
# says: should be
# says: that is none of the usual mistakes, so work it out by hand for a small case
def table_rows(num_doors, length):
    return (num_doors + 1) ^ (length * (length - 1) // 2 + 1)


# %% exercise 1, wrong: two for the unmarked
# says: an unmarked place counts once, not twice: there are N + 1 observations
def table_rows(num_doors, length):
    return (num_doors + 2) ** (length * (length - 1) // 2 + 1)


# %% exercise 1, wrong: the square halved
# says: L^2 / 2 + 1 is not L(L-1)/2 + 1
def table_rows(num_doors, length):
    return (num_doors + 1) ** (length**2 // 2 + 1)


# %% exercise 2, right: concatenate
# says: Right: the history includes the actions. See it race:
def push(self, window, action, seen):
    return np.concatenate((window[2:], np.array([action, seen])))


# %% exercise 2, right: append twice
def push(self, window, action, seen):
    return np.append(np.append(window[2:], action), seen)


# %% exercise 2, right: roll
def push(self, window, action, seen):
    new = np.roll(window, -2)
    new[-2] = action
    new[-1] = seen
    return new


# %% exercise 2, right: by a loop
def push(self, window, action, seen):
    new = np.zeros(len(window), np.int64)
    for i in range(len(window) - 2):
        new[i] = window[i + 2]
    new[len(window) - 2] = action
    new[len(window) - 1] = seen
    return new


# %% exercise 2, right: pairs of digits
def row(self, window):
    number = window[0]
    for i in range(1, len(window), 2):
        number = (number * self.n_actions + window[i]) * self.n_observations + window[i + 1]
    return number


# %% exercise 2, right: observations first
def row(self, window):
    number = 0
    for seen in window[::2]:
        number = number * self.n_observations + seen
    for action in window[1::2]:
        number = number * self.n_actions + action
    return number


# %% exercise 2, right: the latest digit first
def row(self, window):
    number, worth = 0, 1
    for i in range(len(window) - 1, -1, -1):
        number += window[i] * worth
        worth *= self.n_observations if i % 2 == 0 else self.n_actions
    return number


# %% exercise 2, right: actions first
def row(self, window):
    number = 0
    for i in range(self.k - 1):
        number = number * self.n_actions + window[2 * i + 1]
    for i in range(self.k):
        number = number * self.n_observations + window[2 * i]
    return number


# %% exercise 2, wrong: not solved
# says: Not solved yet
def push(self, window, action, seen):
    raise NotImplementedError("not solved yet: replace this line")


# %% exercise 2, wrong: not a class
# says: should be the class
MyWindow = MyWindow(make_mdp("MemoryCorridor"))


# %% exercise 2, wrong: the window is changed
# says: changes the window that it is given, which still belongs to the state before: make a new one, with window.copy()
#   or np.concatenate
def push(self, window, action, seen):
    window[:-2] = window[2:]
    window[-2] = action
    window[-1] = seen
    return window


# %% exercise 2, wrong: no return
# says: is a `return` missing?
def push(self, window, action, seen):
    new = window.copy()
    new[:-2] = window[2:]
    new[-2] = action
    new[-1] = seen


# %% exercise 2, wrong: the wrong order
# says: the action comes before the observation that it leads to
def push(self, window, action, seen):
    return np.concatenate((window[2:], np.array([seen, action])))


# %% exercise 2, wrong: at the front
# says: the latest ones stand at the end of the window, not at its beginning
def push(self, window, action, seen):
    return np.concatenate((np.array([action, seen]), window[:-2]))


# %% exercise 2, wrong: the newest first
# says: the latest ones stand at the *end* of the window
def push(self, window, action, seen):
    return np.concatenate((np.array([seen, action]), window[:-2]))


# %% exercise 2, wrong: nothing moves
# says: nothing moves: the last two entries are overwritten, and the oldest ones stay for ever
def push(self, window, action, seen):
    new = window.copy()
    new[-2] = action
    new[-1] = seen
    return new


# %% exercise 2, wrong: the window grows
# says: entries long, so two go and two come
# says: : the window should stay
def push(self, window, action, seen):
    return np.concatenate((window, np.array([action, seen])))


# %% exercise 2, wrong: only the oldest observation goes
# says: two go and two come
def push(self, window, action, seen):
    return np.concatenate((window[1:], np.array([action, seen])))


# %% exercise 2, wrong: it moves by one
# says: it moves by one entry only; an action *and* an observation are new
def push(self, window, action, seen):
    new = window.copy()
    new[:-1] = window[1:]
    new[-2] = action
    new[-1] = seen
    return new


# %% exercise 2, wrong: rolled the wrong way
# says: it moves the wrong way: the oldest ones should go
def push(self, window, action, seen):
    new = np.roll(window, 2)
    new[-2] = action
    new[-1] = seen
    return new


# %% exercise 2, wrong: the action is left out
# says: the new action is missing; the old one stands in its place
def push(self, window, action, seen):
    new = window.copy()
    new[:-2] = window[2:]
    new[-1] = seen
    return new


# %% exercise 2, wrong: only observations move
# says: only the observations move; the actions should move with them
def push(self, window, action, seen):
    new = window.copy()
    new[:-2:2] = window[2::2]
    new[-2] = action
    new[-1] = seen
    return new


# %% exercise 2, wrong: a list
# says: : give a NumPy array, as the window is one
def push(self, window, action, seen):
    return [*window[2:], action, seen]


# %% exercise 2, wrong: a row without the actions
# says: they differ in an action only, so the action makes no difference to the row
# says: observations and
def row(self, window):
    number = 0
    for seen in window[::2]:
        number = number * self.n_observations + seen
    return number


# %% exercise 2, wrong: a sum
# says: actions, but different windows need different rows:
def row(self, window):
    return sum(window)


# %% exercise 2, wrong: one base for all digits
# says: should be from 0 to
# says: values and an action one with
def row(self, window):
    number = 0
    for entry in window:
        number = number * self.n_observations + entry
    return number


# %% exercise 2, wrong: the bases exchanged
# says: different windows need different rows
def row(self, window):
    number = 0
    for i in range(len(window)):
        if i % 2 == 0:
            number = number * self.n_actions + window[i]
        else:
            number = number * self.n_observations + window[i]
    return number


# %% exercise 2, wrong: rows from 1
# says: should be from 0 to
def row(self, window):
    number = 0
    for i in range(len(window)):
        number = number * (self.n_actions if i % 2 else self.n_observations) + window[i]
    return number + 1


# %% exercise 2, wrong: decimal digits
# says: should be from 0 to
def row(self, window):
    number = 0
    for entry in window:
        number = number * 10 + entry
    return number


# %% exercise 2, wrong: the digit is added too early
# says: multiply by the number of values of the digit that you add, and then add it: n_observations at even indices,
#   n_actions at odd ones
def row(self, window):
    number = 0
    for i in range(len(window)):
        base = self.n_observations if i % 2 == 0 else self.n_actions
        number = (number + window[i]) * base
    return number


# %% exercise 2, wrong: the lesson's numbers
# says: : an observation is a digit with
def row(self, window):
    number = 0
    for i in range(len(window)):
        number = number * (4 if i % 2 == 0 else 3) + window[i]
    return number


# %% exercise 2, wrong: self is missing
# says: n_observations
def row(self, window):
    number = 0
    for i in range(len(window)):
        number = number * (n_observations if i % 2 == 0 else n_actions) + window[i]
    return number


# %% exercise 2, wrong: floats
# says: numbers, but whole numbers are needed, so start from window.copy(), or np.zeros(len(window), np.int64)
def push(self, window, action, seen):
    new = np.zeros(len(window))
    new[:-2] = window[2:]
    new[-2] = action
    new[-1] = seen
    return new


# %% exercise 2, wrong: a float for a row
# says: should be a whole number, but is 0.0
# says: : use `//` for `/`, and 0 for 0.0
def row(self, window):
    row = 0.0
    for i in range(len(window)):
        row = row * (self.n_observations if i % 2 == 0 else self.n_actions) + window[i]
    return row


# %% exercise 2, wrong: the row writes into its window
# says: changes the window that it is given, and that is still needed: only read it
def row(self, window):
    for i in range(1, len(window)):
        window[i] += window[i - 1] * (self.n_observations if i % 2 == 0 else self.n_actions)
    return window[-1]


# %% exercise 2, wrong: at the front, another way
# says: the latest ones stand at the *end* of the window
def push(self, window, action, seen):
    new = window.copy()
    new[2:] = window[:-2]
    new[0], new[1] = seen, action
    return new


# %% exercise 2, wrong: the window as it was
# says: nothing changes; does it return the old window?
def push(self, window, action, seen):
    return window.copy()


# %% exercise 2, wrong: an observation for the action
# says: the old observation stands where the new action should: the window moves by *two* entries
def push(self, window, action, seen):
    new = window.copy()
    new[:-2] = window[2:]
    new[-2], new[-1] = window[-1], seen
    return new


# %% exercise 2, wrong: no action
# says: the new action is missing: 0 stands in its place
def push(self, window, action, seen):
    new = window.copy()
    new[:-2] = window[2:]
    new[-2], new[-1] = 0, seen
    return new


# %% exercise 2, wrong: no observation
# says: the new observation is missing: 0 stands in its place
def push(self, window, action, seen):
    new = window.copy()
    new[:-2] = window[2:]
    new[-2], new[-1] = action, 0
    return new


# %% exercise 2, wrong: the old observation
# says: the new observation is missing; the old one stands in its place
def push(self, window, action, seen):
    new = window.copy()
    new[:-2] = window[2:]
    new[-2] = action
    return new


# %% exercise 2, wrong: actions move
# says: only the actions move; the observations should move with them
def push(self, window, action, seen):
    new = window.copy()
    new[1:-2:2] = window[3::2]
    new[-2], new[-1] = action, seen
    return new


# %% exercise 2, wrong: all else is 0
# says: everything else in the window is lost
def push(self, window, action, seen):
    new = np.zeros(len(window), np.int64)
    new[-2], new[-1] = action, seen
    return new


# %% exercise 2, wrong: exchanged in the middle
# says: the first two entries should go, and action and observation come at the end
def push(self, window, action, seen):
    new = window.copy()
    new[0], new[-1] = seen, action
    return new


# %% exercise 2, wrong: a text
# says: : the window is an array
def push(self, window, action, seen):
    return str(window)


# %% exercise 3, right: the other case first
# says: Right: the state is one note and what is seen, 16 rows with three doors. See it race:
def update(self, notes, place, seen, action):
    notes[place] = action
    if seen < self.num_doors:
        return 0
    return place + 1


# %% exercise 3, right: in two lines
def update(self, notes, place, seen, action):
    notes[place] = action
    return place + 1 if seen == self.num_doors else 0


# %% exercise 3, right: the mark is noted
def update(self, notes, place, seen, action):
    if seen != self.num_doors:
        notes[place] = seen
        return 0
    return place + 1


# %% exercise 3, right: arithmetic
def update(self, notes, place, seen, action):
    notes[place] = action
    return (place + 1) * int(seen == self.num_doors)


# %% exercise 3, right: an empty note means the end
def update(self, notes, place, seen, action):
    last = notes[place] == self.num_doors
    notes[place] = action
    if last:
        return 0
    return place + 1


# %% exercise 3, right: with a local name
def update(self, notes, place, seen, action):
    marked = seen in range(self.num_doors)
    notes[place] = action
    next_place = place + 1
    if marked:
        next_place = 0
    return next_place


# %% exercise 3, right: noted once
def update(self, notes, place, seen, action):
    if notes[place] == self.num_doors:
        notes[place] = action
    if seen == self.num_doors:
        place += 1
    else:
        place = 0
    return place


# %% exercise 3, wrong: not solved
# says: Not solved yet
def update(self, notes, place, seen, action):
    raise NotImplementedError("not solved yet: replace this line")


# %% exercise 3, wrong: an instance
# says: should be the class
Notebook = Notebook(make_mdp("MemoryCorridor"))


# %% exercise 3, wrong: no return
# says: is a `return` missing?
def update(self, notes, place, seen, action):
    notes[place] = action
    place = place + 1 if seen == self.num_doors else 0


# %% exercise 3, wrong: what was seen
# says: it notes what was *seen*, and at an unmarked place that is no door: note the door that was opened
# says: should leave the notes
def update(self, notes, place, seen, action):
    notes[place] = seen
    return place + 1 if seen == self.num_doors else 0


# %% exercise 3, wrong: never back
# says: after the marked door the corridor starts again, so the next place is 0
# says: update(notes, place=
def update(self, notes, place, seen, action):
    notes[place] = action
    return place + 1


# %% exercise 3, wrong: exchanged
# says: the two cases have changed places: after a *marked* door the corridor starts again
def update(self, notes, place, seen, action):
    notes[place] = action
    return 0 if seen == self.num_doors else place + 1


# %% exercise 3, wrong: it stays
# says: the next place is one further, place + 1, where no door is marked
def update(self, notes, place, seen, action):
    notes[place] = action
    return place if seen == self.num_doors else 0


# %% exercise 3, wrong: always back
# says: the next place is always 0: compare what was *seen* with num_doors
def update(self, notes, place, seen, action):
    notes[place] = action
    return 0


# %% exercise 3, wrong: from one
# says: the first place is 0, not 1
def update(self, notes, place, seen, action):
    notes[place] = action
    return place + 1 if seen == self.num_doors else 1


# %% exercise 3, wrong: moves before it writes
# says: the door belongs to the place where it was opened: write the note before you move on
def update(self, notes, place, seen, action):
    place = place + 1 if seen == self.num_doors else 0
    notes[place] = action
    return place


# %% exercise 3, wrong: wipes the notes
# says: all notes are wiped out where the corridor starts again, and they are needed there
def update(self, notes, place, seen, action):
    notes[place] = action
    if seen == self.num_doors:
        return place + 1
    notes[:] = self.num_doors
    return 0


# %% exercise 3, wrong: notes nothing
# says: the marked door is not noted: write every door into `notes[place]`, marked or not (and into `notes` itself, not
#   into a copy)
def update(self, notes, place, seen, action):
    return place + 1 if seen == self.num_doors else 0


# %% exercise 3, wrong: a copy is changed
# says: the marked door is not noted
def update(self, notes, place, seen, action):
    notes = notes.copy()
    notes[place] = action
    return place + 1 if seen == self.num_doors else 0


# %% exercise 3, wrong: the marked door is lost
# says: the marked door is not noted
def update(self, notes, place, seen, action):
    if seen == self.num_doors:
        notes[place] = action
        return place + 1
    return 0


# %% exercise 3, wrong: the place is noted
# says: it notes the place instead of the door
def update(self, notes, place, seen, action):
    notes[place] = place
    return place + 1 if seen == self.num_doors else 0


# %% exercise 3, wrong: compared with the door
# says: compare what was *seen*
def update(self, notes, place, seen, action):
    notes[place] = action
    return place + 1 if action == self.num_doors else 0


# %% exercise 3, wrong: compared with the place
# says: the present place is compared with the number of doors; compare what was *seen* with it
def update(self, notes, place, seen, action):
    notes[place] = action
    return place + 1 if place == self.num_doors else 0


# %% exercise 3, wrong: three doors
# says: 3 stands where self.num_doors should
def update(self, notes, place, seen, action):
    notes[place] = action
    return place + 1 if seen == 3 else 0


# %% exercise 3, wrong: doors below three
# says: 3 stands where self.num_doors should: where there are more doors, 3 is one of them
def update(self, notes, place, seen, action):
    notes[place] = action
    return 0 if seen < 3 else place + 1


# %% exercise 3, wrong: both are returned
# says: should return the next place alone, but returns a
# says: ; the notes are changed in place, so they need not be returned
def update(self, notes, place, seen, action):
    notes[place] = action
    return notes, place + 1 if seen == self.num_doors else 0


# %% exercise 3, wrong: compared instead of written
# says: the marked door is not noted
def update(self, notes, place, seen, action):
    notes[place] == action
    return place + 1 if seen == self.num_doors else 0


# %% exercise 3, wrong: the wrong index
# says: it writes the note to `notes[action]`; the index is the place
def update(self, notes, place, seen, action):
    notes[action] = action
    return place + 1 if seen == self.num_doors else 0


# %% exercise 3, wrong: a share of a place
# says: should be a whole number, but is 1.9
def update(self, notes, place, seen, action):
    notes[place] = action
    return place + 1.9 if seen == self.num_doors else 0


# %% exercise 3, wrong: a float
# says: should be a whole number, but is 1.0
def update(self, notes, place, seen, action):
    notes[place] = action
    return (place + 1.0) if seen == self.num_doors else 0


# %% exercise 3, wrong: the observation as an index
# says: it writes the note to `notes[seen]`; the index is the place
def update(self, notes, place, seen, action):
    notes[seen] = action
    return place + 1 if seen == self.num_doors else 0


# %% exercise 3, wrong: two places further
# says: that is none of the usual mistakes, so follow this step by hand
def update(self, notes, place, seen, action):
    notes[place] = action
    return place + 2 if seen == self.num_doors else 0
