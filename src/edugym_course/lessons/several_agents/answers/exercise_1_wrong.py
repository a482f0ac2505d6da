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


# %% the larger gain
# says: that is the larger one of both gains, and the mean over the two players is asked
def exploitability(payoffs, first, second):
    rows, columns, now = payoffs @ second, first @ payoffs, first @ payoffs @ second
    return max(rows.max() - now, now - columns.min())


# %% the gains subtracted
# says: the gains are subtracted; the mean of both is asked
def exploitability(payoffs, first, second):
    rows, columns, now = payoffs @ second, first @ payoffs, first @ payoffs @ second
    return (rows.max() - now - (now - columns.min())) / 2


# %% by the actions
# says: the sum of both gains is divided by the number of actions; there are two players
def exploitability(payoffs, first, second):
    rows, columns, now = payoffs @ second, first @ payoffs, first @ payoffs @ second
    return (rows.max() - columns.min()) / len(rows)


# %% the highest column taken off
# says: player 1 takes the column with the highest payoff, and it wants the lowest
def exploitability(payoffs, first, second):
    rows, columns, now = payoffs @ second, first @ payoffs, first @ payoffs @ second
    return (rows.max() - now + now - columns.max()) / 2


# %% no minus sign
# says: player 1 gets the opposite of the payoff: its best answer lacks a minus sign
def exploitability(payoffs, first, second):
    rows, columns, now = payoffs @ second, first @ payoffs, first @ payoffs @ second
    return (rows.max() - now + columns.max() + now) / 2


# %% swapped
# says: the policies are swapped: payoffs @ second is what each row is worth, and first @ payoffs each column. (Or
#   have all payoffs another sign?)
def exploitability(payoffs, first, second):
    rows, columns, now = payoffs @ second, first @ payoffs, first @ payoffs @ second
    return (columns.max() - now + now - rows.min()) / 2


# %% against a die
# says: the best answers are those to a player who takes each action equally often; answer the policy that is given
def exploitability(payoffs, first, second):
    rows, columns, now = payoffs @ second, first @ payoffs, first @ payoffs @ second
    return (payoffs.mean(axis=1).max() - now + now - payoffs.mean(axis=0).min()) / 2


# %% numbers of actions
# says: argmax and argmin are the *numbers* of actions; what they pay is needed
def exploitability(payoffs, first, second):
    rows, columns, now = payoffs @ second, first @ payoffs, first @ payoffs @ second
    return (rows.argmax() - now + now - columns.argmin()) / 2


# %% the number of a row
# says: argmax is the *number* of a row; what it pays is needed
def exploitability(payoffs, first, second):
    rows, columns, now = payoffs @ second, first @ payoffs, first @ payoffs @ second
    return (rows.argmax() - now + now - columns.min()) / 2


# %% beyond the game
# says: that compares with the value of the game; a gain is what a best answer gets beyond what the player gets now
def exploitability(payoffs, first, second):
    rows, columns, now = payoffs @ second, first @ payoffs, first @ payoffs @ second
    return abs(now - games.solve_zero_sum(payoffs).value)


# %% below the game
# says: that is what the policy of player 0 loses to its best opponent; the mean of both gains is asked
def exploitability(payoffs, first, second):
    rows, columns, now = payoffs @ second, first @ payoffs, first @ payoffs @ second
    return games.solve_zero_sum(payoffs).value - columns.min()


# %% sizes
# says: the absolute value of each difference is taken; a best answer is the best of them, with its sign
def exploitability(payoffs, first, second):
    rows, columns, now = payoffs @ second, first @ payoffs, first @ payoffs @ second
    return (abs(rows - now).max() + abs(columns - now).max()) / 2


# %% most probable
# says: the most probable action stands for each policy; all of them count, by their probabilities
def exploitability(payoffs, first, second):
    rows, columns, now = payoffs @ second, first @ payoffs, first @ payoffs @ second
    return (payoffs[:, second.argmax()].max() - payoffs[first.argmax()].min()) / 2


# %% both at once
# says: both players change at once, so that nothing is gained; each answers the policy that the other has now
def exploitability(payoffs, first, second):
    rows, columns, now = payoffs @ second, first @ payoffs, first @ payoffs @ second
    best = payoffs[rows.argmax(), columns.argmin()]
    return (best - now + now - best) / 2


# %% the smaller gain
# says: that is the smaller one of both gains, and the mean over the two players is asked
def exploitability(payoffs, first, second):
    rows, columns, now = payoffs @ second, first @ payoffs, first @ payoffs @ second
    return min(rows.max() - now, now - columns.min())


# %% half of player 1
# says: that is half of what player 1 gains; player 0 has a best answer too
def exploitability(payoffs, first, second):
    rows, columns, now = payoffs @ second, first @ payoffs, first @ payoffs @ second
    return (now - columns.min()) / 2


# %% one is halved
# says: only the second gain is halved: put the sum in parentheses
def exploitability(payoffs, first, second):
    rows, columns, now = payoffs @ second, first @ payoffs, first @ payoffs @ second
    return rows.max() - now + (now - columns.min()) / 2


# %% the worst answer
# says: the answer of player 0 is the worst one: the best answer is the row with the highest payoff
def exploitability(payoffs, first, second):
    rows, columns, now = payoffs @ second, first @ payoffs, first @ payoffs @ second
    return (rows.min() - now + now - columns.min()) / 2


# %% the table is shifted in place
# says: changes its array `payoffs`; make a new one, for the caller still needs the old one
def exploitability(payoffs, first, second):
    payoffs -= first @ payoffs @ second
    return ((payoffs @ second).max() - (first @ payoffs).min()) / 2


# %% absolute values
# says: absolute values are compared; a best answer is the best payoff, with its sign
def exploitability(payoffs, first, second):
    return (abs(payoffs @ second).max() + abs(first @ payoffs).max()) / 2


# %% its own probabilities
# says: payoffs are multiplied by how often the player itself takes the action; whoever answers takes the best one always
def exploitability(payoffs, first, second):
    return ((first * (payoffs @ second)).max() - ((first @ payoffs) * second).min()) / 2


# %% means, added
# says: the means over the actions of the one who answers are added; the best action counts, and half of the sum
def exploitability(payoffs, first, second):
    now = first @ payoffs @ second
    return (payoffs @ second - now).mean() + (now - first @ payoffs).mean()


# %% half of the gain of player 1 is what both get now
# says: half of what player 0 gains
# says: half of what player 1 gains
# says: which of them is another one in your code?
def exploitability(payoffs, first, second):
    now = first @ payoffs @ second
    return ((payoffs @ second).max() - now + now / 4) / 2
