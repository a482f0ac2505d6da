# %% nothing was done
# says: with ε = 0.1, 0.59% of the climbs
# says: that is the value with which the cell began
epsilon = 0.1

# %% still the placeholder
# says: Not solved yet
# says: is still `...`; put your answer there.
epsilon = ...

# %% none
# says: Not solved yet
# says: is None; give it a value.
epsilon = None

# %% the wrong grip every time
# says: that is ε/2, the probability of a wrong grip; of two grips a random action takes the wrong one half of the time
epsilon = 1 - 0.5 ** (1 / 100)

# %% the logarithm's approximation
# says: that is ln 2/50, an approximation which is a little too large; solve (1 − ε/2)^100 = 1/2 exactly
epsilon = math.log(2) / 50

# %% 99 steps
# says: that is for 99 steps; from the ground, position 0, to the top, position 100, there are 100
epsilon = 2 * (1 - 0.5 ** (1 / 99))

# %% 101 steps
# says: that is for 101 steps; from the ground, position 0, to the top, position 100, there are 100
epsilon = 2 * (1 - 0.5 ** (1 / 101))

# %% probabilities added up
# says: 100 steps that go wrong with probability ε/2 do not add up to 100 · ε/2; multiply the probabilities that they go
#   right
epsilon = 0.5 / 100 * 2

# %% probabilities added up, wrong every time
# says: the probabilities of 100 steps do not add up; multiply the probabilities that they go right
epsilon = 0.5 / 100

# %% another wall
# says: that is for a wall of height 30, and this one has 100
epsilon = 2 * (1 - 0.5 ** (1 / 30))

# %% a step goes right with probability ε/2
# says: is no probability
# says: a step goes right with probability 1 − ε/2, not ε/2
epsilon = 2 * 0.5 ** (1 / 100)

# %% the probability of a right step
# says: that is the probability of a *right* step
epsilon = 0.5 ** (1 / 100)

# %% in percent
# says: that is in percent; a probability lies between 0 and 1
epsilon = 1.38

# %% a text
# says: : leave the quotes out
epsilon = "0.0138"

# %% a list
# says: : take an entry of it
epsilon = [0.0138]

# %% a truth value
# says: should be a number, but is the truth value
epsilon = (1 - 0.0138 / 2) ** 100 == 0.5

# %% rounded
# says: , by a little: give six digits or more
# says: half should, so ε must be
epsilon = 0.014

# %% a function
# says: should be a number, but is a function: call it, with parentheses
epsilon = lambda height: 2 * (1 - 0.5 ** (1 / height))

# %% two thirds
# says: of two grips a random action takes the wrong one with probability 1/2, not 2/3
epsilon = 1.5 * (1 - 0.5 ** (1 / 100))

# %% two logarithms
# says: natural and decimal logarithms are mixed up
epsilon = 2 * (1 - 10 ** (math.log(0.5) / 100))

# %% below 0
# says: the sign is wrong: ε is a probability
epsilon = -2 * (1 - 0.5 ** (1 / 100))


# %% without parentheses
# says: 1/2 is divided by 100, and its root is needed, `0.5 ** (1 / 100)`, with these parentheses
epsilon = 2 * (1 - 0.5**1 / 100)


# %% without parentheses and twice
# says: 1/2 is divided by 100, and its root is needed, `0.5 ** (1 / 100)`, with these parentheses; and ε is twice that
epsilon = 1 - 0.5**1 / 100


# %% a negative logarithm
# says: that is ln(1/2)/50, a logarithm, which is negative: solve (1 − ε/2)^100 = 1/2
epsilon = 2 * np.log(0.5) / 100


# %% the power of a half
# says: that is 1/2 to the power of 100: it is (1 − ε/2)^100 that should be 1/2
epsilon = 0.5**100


# %% half of the half
# says: that is the half of ε/2, the probability of a wrong grip: ε is twice that, and not half of it
epsilon = (1 - 0.5 ** (1 / 100)) / 2


# %% twice too large
# says: that is twice too large: ε/2 is the probability of a wrong grip, and ε twice that
epsilon = 4 * (1 - 0.5 ** (1 / 100))


# %% no probability
# says: ε = -0.5 is no probability:
# says: a probability lies between 0 and 1
epsilon = -0.5


# %% three digits
# says: half should, so ε must be larger, by a little: give six digits or more
epsilon = 0.013


# %% no exploration
# says: with ε = 0, 100.00% of the climbs reach the top: half should, so ε must be larger
epsilon = 0


# %% the power for the root
# says: ε = 2 is no probability: `0.5 ** 100` is a power, and the root is needed, `0.5 ** (1 / 100)`
epsilon = 2 * (1 - 0.5**100)


# %% the logarithm's approximation of the half
# says: that is ln 2/100, an approximation of ε/2; ε is twice that, and (1 − ε/2)^100 = 1/2 can be solved exactly
epsilon = math.log(2) / 100


# %% a random grip is always wrong, in half of the steps
# says: that solves (1 − ε)^50 = 1/2: it is (1 − ε/2)^100 that should be 1/2
epsilon = 1 - 0.5 ** (1 / 50)


# %% the share of the climbs
# says: that is the share of the climbs that reach the top with ε = 0.1, and ε is asked for
epsilon = (1 - 0.1 / 2) ** 100
