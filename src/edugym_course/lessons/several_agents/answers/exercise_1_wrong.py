# %% the sum
# says: that is the sum of both gains, and the mean over the two players is asked
def exploitability(payoffs, first, second):
    return (payoffs @ second).max() - (first @ payoffs).min()


# %% player 0 alone
# says: that is what player 0 gains alone; player 1 has a best answer too
def exploitability(payoffs, first, second):
    return (payoffs @ second).max() - first @ payoffs @ second


# %% player 1 alone
# says: that is what player 1 gains alone; player 0 has a best answer too
def exploitability(payoffs, first, second):
    return first @ payoffs @ second - (first @ payoffs).min()


# %% half of player 0
# says: that is half of what player 0 gains; player 1 has a best answer too
def exploitability(payoffs, first, second):
    return ((payoffs @ second).max() - first @ payoffs @ second) / 2


# %% player 1 wants much
# says: player 1 gets the opposite of the payoff, so its best answer is the column with the *lowest* payoff
def exploitability(payoffs, first, second):
    now = first @ payoffs @ second
    return ((payoffs @ second).max() - now + (first @ payoffs).max() - now) / 2


# %% added
# says: what player 1 gets is the opposite of the payoff: the two are not added
def exploitability(payoffs, first, second):
    return ((payoffs @ second).max() + (first @ payoffs).min()) / 2


# %% twice now
# says: what both get now is counted twice: the payoff of player 1 is the opposite of that of player 0, so the two cancel
def exploitability(payoffs, first, second):
    now = first @ payoffs @ second
    return ((payoffs @ second).max() - now + (-first @ payoffs).max() - now) / 2


# %% of the table
# says: the other's policy is left out: the largest payoff of the table is no answer to a policy
def exploitability(payoffs, first, second):
    return (payoffs.max() - payoffs.min()) / 2


# %% means
# says: these are the means over the actions of the one who answers, and a best answer takes the best of them
def exploitability(payoffs, first, second):
    return ((payoffs @ second).mean() - (first @ payoffs).mean()) / 2


# %% now
# says: that is what the pair is worth to player 0 now; how much more can each get?
def exploitability(payoffs, first, second):
    return first @ payoffs @ second


# %% a sign
# says: the sign is wrong: nobody loses by a best answer
def exploitability(payoffs, first, second):
    return ((first @ payoffs).min() - (payoffs @ second).max()) / 2


# %% printed
# says: is a `return` missing?
def exploitability(payoffs, first, second):
    print(((payoffs @ second).max() - (first @ payoffs).min()) / 2)


# %% axes
# says: exploitability(
def exploitability(payoffs, first, second):
    return ((first @ payoffs).max() - (payoffs @ second).min()) / 2


# %% a row for a number
# says: should be one number
def exploitability(payoffs, first, second):
    return ((payoffs @ second) - (first @ payoffs).min()) / 2


# %% a number
# says: payoffs, first and second
exploitability = 0.5
