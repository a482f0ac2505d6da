# %% the other row
# says: that is the probability of row 1, and that of row 0 is asked
# in: solved as a game
# - return games.solve_zero_sum(payoffs).first[0]
# + return games.solve_zero_sum(payoffs).first[1]

# %% of player 1
# says: with it player 0 itself does not care which row it takes; it is player 1 who must not care about the column
# in: solved as a game
# - return games.solve_zero_sum(payoffs).first[0]
# + return games.solve_zero_sum(payoffs).second[0]

# %% of player 1, the other
# says: that is the probability of column 1 for player 1; that of row 0 for player 0 is asked
# in: solved as a game
# - return games.solve_zero_sum(payoffs).first[0]
# + return games.solve_zero_sum(payoffs).second[1]

# %% the value
# says: that is the value of the game, and the probability of row 0 is asked
# in: solved as a game
# - return games.solve_zero_sum(payoffs).first[0]
# + return games.solve_zero_sum(payoffs).value

# %% a coin
# says: a coin is right only if the payoffs are as even as in matching pennies
def safe_probability(payoffs):
    return 0.5


# %% below the line
# says: a sign below the line is wrong: the difference of the two columns is p (a − b) + (1 − p)(c − d)
def safe_probability(payoffs):
    (a, b), (c, d) = payoffs
    return (d - c) / (a - b + c - d)


# %% above the line
# says: the sign is wrong: p (a − b) = (1 − p)(d − c)
def safe_probability(payoffs):
    (a, b), (c, d) = payoffs
    return (c - d) / (a - b - c + d)


# %% a ratio
# says: that is the ratio p / (1 − p), not p
def safe_probability(payoffs):
    (a, b), (c, d) = payoffs
    return (d - c) / (a - b)


# %% both probabilities
# says: take an entry of it
# in: solved as a game
# - return games.solve_zero_sum(payoffs).first[0]
# + return games.solve_zero_sum(payoffs).first


# %% the signs below
# says: below the line stands a + b − c − d; it is a − b − c + d
def safe_probability(payoffs):
    (a, b), (c, d) = payoffs
    return (d - c) / (a + b - c - d) if a + b != c + d else 0.0


# %% all below
# says: below the line stands a + b + c + d; it is a − b − c + d
def safe_probability(payoffs):
    (a, b), (c, d) = payoffs
    return (d - c) / (a + b + c + d)


# %% upside down
# says: the fraction is upside down: a probability is at most 1
def safe_probability(payoffs):
    (a, b), (c, d) = payoffs
    return (a - b - c + d) / (d - c)


# %% no parentheses
# says: parentheses are missing: Python divides before it subtracts
def safe_probability(payoffs):
    (a, b), (c, d) = payoffs
    return d - c / (a or 1) - b - c + d


# %% a percentage
# says: that is a percentage; a probability goes from 0 to 1
def safe_probability(payoffs):
    (a, b), (c, d) = payoffs
    return 100 * (d - c) / (a - b - c + d)


# %% that of the example
# says: that is the answer to the example above; do the same with letters
def safe_probability(payoffs):
    (a, b), (c, d) = payoffs
    return 0.4


# %% column 0 pays nothing
# says: with it column 0 pays nothing; both columns must pay the same
def safe_probability(payoffs):
    (a, b), (c, d) = payoffs
    return c / (c - a)


# %% shares of the payoffs
# says: payoffs are no probabilities: the share of row 0 in their sum means nothing
def safe_probability(payoffs):
    (a, b), (c, d) = payoffs
    return (a + b) / (a + b + c + d)


# %% the better mean
# says: that is the row with the better mean, without chance; who knows it takes the worse column
def safe_probability(payoffs):
    (a, b), (c, d) = payoffs
    return 1.0 if a + b > c + d else 0.0


# %% the better minimum
# says: that is the row whose worst payoff is the better one; a random choice guarantees more
def safe_probability(payoffs):
    (a, b), (c, d) = payoffs
    return 1.0 if min(a, b) > min(c, d) else 0.0


# %% one sign below
# says: below the line stands a − b + c + d; it is a − b − c + d
def safe_probability(payoffs):
    (a, b), (c, d) = payoffs
    return (d - c) / (a - b + c + d)


# %% a sign above
# says: c and d are added above the line; it is d − c
def safe_probability(payoffs):
    (a, b), (c, d) = payoffs
    return (c + d) / (a - b - c + d)


# %% two left out below
# says: b and c are left out below the line; it is a − b − c + d
def safe_probability(payoffs):
    return (payoffs[1, 1] - payoffs[1, 0]) / (payoffs[0, 0] + payoffs[1, 1])


# %% a and b the wrong way round below
# says: below the line stands −a + b − c + d; it is a − b − c + d
def safe_probability(payoffs):
    (a, b), (c, d) = payoffs
    return (d - c) / (d - c + b - a)


# %% parentheses below the line alone
# says: parentheses are missing above the line: Python divides before it subtracts
def safe_probability(payoffs):
    (a, b), (c, d) = payoffs
    return d - c / (a - b - c + d)


# %% the columns of player 1, with a sign
# says: the sign is wrong, and with it player 0 itself would not care which row it takes; it is player 1 who must not care about the column
def safe_probability(payoffs):
    (a, b), (c, d) = payoffs
    return (b - d) / (a - b - c + d)
