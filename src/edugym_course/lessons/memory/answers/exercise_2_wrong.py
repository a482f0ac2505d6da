# %% not solved
# says: Not solved yet
def push(self, window, action, seen):
    raise NotImplementedError("not solved yet: replace this line")


# %% not a class
# says: should be the class
MyWindow = MyWindow(make_mdp("MemoryCorridor"))


# %% the window is changed
# says: changes the window that it is given, which still belongs to the state before: make a new one, with window.copy()
#   or np.concatenate
def push(self, window, action, seen):
    window[:-2] = window[2:]
    window[-2] = action
    window[-1] = seen
    return window


# %% no return
# says: is a `return` missing?
# in: the solution of push
# - return new


# %% the wrong order
# says: the action comes before the observation that it leads to
def push(self, window, action, seen):
    return np.concatenate((window[2:], np.array([seen, action])))


# %% at the front
# says: the latest ones stand at the end of the window, not at its beginning
def push(self, window, action, seen):
    return np.concatenate((np.array([action, seen]), window[:-2]))


# %% the newest first
# says: the latest ones stand at the *end* of the window
def push(self, window, action, seen):
    return np.concatenate((np.array([seen, action]), window[:-2]))


# %% nothing moves
# says: nothing moves: the last two entries are overwritten, and the oldest ones stay for ever
# in: the solution of push
# - new[:-2] = window[2:]


# %% the window grows
# says: entries long, so two go and two come
# says: : the window should stay
def push(self, window, action, seen):
    return np.concatenate((window, np.array([action, seen])))


# %% it moves by one
# says: it moves by one entry only; an action *and* an observation are new
# in: the solution of push
# - new[:-2] = window[2:]
# + new[:-1] = window[1:]


# %% rolled the wrong way
# says: it moves the wrong way: the oldest ones should go
def push(self, window, action, seen):
    new = np.roll(window, 2)
    new[-2] = action
    new[-1] = seen
    return new


# %% the action is left out
# says: the new action is missing; the old one stands in its place
# in: the solution of push
# - new[-2] = action


# %% only observations move
# says: only the observations move; the actions should move with them
# in: the solution of push
# - new[:-2] = window[2:]
# + new[:-2:2] = window[2::2]


# %% a list
# says: : give a NumPy array, as the window is one
def push(self, window, action, seen):
    return [*window[2:], action, seen]


# %% a row without the actions
# says: they differ in an action only, so the action makes no difference to the row
# says: observations and
def row(self, window):
    number = 0
    for seen in window[::2]:
        number = number * self.n_observations + seen
    return number


# %% a sum
# says: that is the sum of the entries, which many windows share
# says: actions, but different windows need different rows:
def row(self, window):
    return sum(window)


# %% one base for all digits
# says: an action has n_actions values, not n_observations
# says: should be from 0 to
# says: values and an action one with
def row(self, window):
    number = 0
    for entry in window:
        number = number * self.n_observations + entry
    return number


# %% the digit is added too early
# says: each digit is multiplied as well: multiply the number so far, and add the digit after that
def row(self, window):
    number = 0
    for i in range(len(window)):
        base = self.n_observations if i % 2 == 0 else self.n_actions
        number = (number + window[i]) * base
    return number


# %% the lesson's numbers
# says: use self.n_observations and self.n_actions in place of 4 and 3: the check takes others
# says: : an observation is a digit with
def row(self, window):
    number = 0
    for i in range(len(window)):
        number = number * (4 if i % 2 == 0 else 3) + window[i]
    return number


# %% self is missing
# says: n_observations
def row(self, window):
    number = 0
    for i in range(len(window)):
        number = number * (n_observations if i % 2 == 0 else n_actions) + window[i]
    return number


# %% floats
# says: numbers, but whole numbers of 64 bits are needed, so start from window.copy(), or np.zeros(len(window), np.int64)
# in: the solution of push
# - new = window.copy()
# + new = np.zeros(len(window))


# %% a float for a row
# says: should be a whole number, but is 0.0
# says: : use `//` for `/`, and 0 for 0.0
def row(self, window):
    row = 0.0
    for i in range(len(window)):
        row = row * (self.n_observations if i % 2 == 0 else self.n_actions) + window[i]
    return row


# %% the row writes into its window
# says: changes the window that it is given, and that is still needed: only read it
def row(self, window):
    for i in range(1, len(window)):
        window[i] += window[i - 1] * (self.n_observations if i % 2 == 0 else self.n_actions)
    return window[-1]


# %% the window as it was
# says: nothing changes; does it return the old window?
def push(self, window, action, seen):
    return window.copy()


# %% an observation for the action
# says: the old observation stands where the new action should: the window moves by *two* entries
def push(self, window, action, seen):
    new = window.copy()
    new[:-2] = window[2:]
    new[-2], new[-1] = window[-1], seen
    return new


# %% no action
# says: the new action is missing: 0 stands in its place
def push(self, window, action, seen):
    new = window.copy()
    new[:-2] = window[2:]
    new[-2], new[-1] = 0, seen
    return new


# %% no observation
# says: the new observation is missing: 0 stands in its place
def push(self, window, action, seen):
    new = window.copy()
    new[:-2] = window[2:]
    new[-2], new[-1] = action, 0
    return new


# %% the old observation
# says: the new observation is missing; the old one stands in its place
# in: the solution of push
# - new[-1] = seen


# %% actions move
# says: only the actions move; the observations should move with them
def push(self, window, action, seen):
    new = window.copy()
    new[1:-2:2] = window[3::2]
    new[-2], new[-1] = action, seen
    return new


# %% all else is 0
# says: everything else in the window is lost
def push(self, window, action, seen):
    new = np.zeros(len(window), np.int64)
    new[-2], new[-1] = action, seen
    return new


# %% exchanged in the middle
# says: the first two entries should go, and action and observation come at the end
def push(self, window, action, seen):
    new = window.copy()
    new[0], new[-1] = seen, action
    return new


# %% a text
# says: : the window is an array
def push(self, window, action, seen):
    return str(window)


# %% from 1
# says: the number starts from 1; start from 0
def row(self, window):
    row = 1
    for i, digit in enumerate(window):
        row = row * (self.n_observations if i % 2 == 0 else self.n_actions) + digit
    return row


# %% the last one forgotten
# says: the last entry is left out: range(len(window)) goes through all of them
def row(self, window):
    row = 0
    for i in range(len(window) - 1):
        row = row * (self.n_observations if i % 2 == 0 else self.n_actions) + window[i]
    return row


# %% the first one forgotten
# says: the first entry is left out: indices begin with 0
def row(self, window):
    row = 0
    for i in range(1, len(window)):
        row = row * (self.n_observations if i % 2 == 0 else self.n_actions) + window[i]
    return row


# %% an early return
# says: only the first entry counts: is the `return` inside the loop?
def row(self, window):
    row = 0
    for i, digit in enumerate(window):
        row = row * (self.n_observations if i % 2 == 0 else self.n_actions) + digit
        return row


# %% overwritten
# says: only the last entry counts: is something overwritten in the loop?
def row(self, window):
    for i, digit in enumerate(window):
        row = 0 * (self.n_observations if i % 2 == 0 else self.n_actions) + digit
    return row


# %% exchanged bases
# says: the two numbers of values have changed places: n_observations belongs to even indices
def row(self, window):
    row = 0
    for i, digit in enumerate(window):
        row = row * (self.n_actions if i % 2 == 0 else self.n_observations) + digit
    return row


# %% the base of actions for all
# says: an observation has n_observations values, not n_actions
def row(self, window):
    row = 0
    for digit in window:
        row = row * self.n_actions + digit
    return row


# %% a decimal number
# says: the digits are those of a decimal number: 10 is no number of values here
def row(self, window):
    return int("".join(map(str, window.tolist())))


# %% observations, the newest first
# says: they differ in an action only, so the action makes no difference to the row
def row(self, window):
    return sum(int(digit) * self.n_observations**i for i, digit in enumerate(window[::2]))


# %% powers of both
# says: multiply by the number of values of the digit that you add, and then add it: n_observations at even indices,
#   n_actions at odd ones
def row(self, window):
    row = 0
    for i, digit in enumerate(window):
        row += digit * (self.n_observations if i % 2 == 0 else self.n_actions) ** (i // 2)
    return row


# %% small numbers
# says: gives int8 numbers, but whole numbers of 64 bits are needed
def push(self, window, action, seen):
    return np.append(window[2:], [action, seen]).astype(np.int8)


# %% rows from 1
# says: 1 is added to the number: the rows begin with 0
def row(self, window):
    row = 0
    for i, digit in enumerate(window):
        row = row * (self.n_observations if i % 2 == 0 else self.n_actions) + digit
    return row + 1


# %% the first entry twice
# says: the first entry counts twice: start from 0, or go on with the second
def row(self, window):
    row = window[0]
    for i, digit in enumerate(window):
        row = row * (self.n_observations if i % 2 == 0 else self.n_actions) + digit
    return row
