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
