# %% the placeholder
# says: Not solved yet
level = ...

# %% the hits are forgotten
# says: that is the crossing with 10 hits; give `max_hits=5` to from_the_tee
level = exact.crossing()

# %% the estimate, measured from the safe plan
# says: that is an estimate with a cost of 1.6 for a lost ball; the fast plan returns 0.8 now, so it costs 1.8
level = 0.0228

# %% the estimate by hand
# says: that is the estimate by hand, which takes for granted that both plans do what they should
level = 0.0220

# %% the lesson's level
# says: that is the lesson's own level; look for the one at which drive and chip are worth the same
level = 0.015

# %% two digits
# says: too low, as the drive is worth more there
# says: , as the drive is worth more there
level = 0.02

# %% three digits
# says: ; you are close, look in steps of 0.0001
level = 0.023

# %% the comparison the wrong way round
# says: that is the value with which the cell began
level = 0.0187
while exact.from_the_tee(level, max_hits=5)["drive"] < exact.from_the_tee(level, max_hits=5)["chip"]:
    level += 0.0001

# %% the deviation
# says: that is the standard deviation of a drive, 100 times the level
level = 2.32

# %% a negative level
# says: the sign is wrong
level = -0.0232

# %% the estimate with the lesson's cost
# says: that is an estimate with the lesson's cost of 1.9 for a lost ball; the fast plan returns 0.8 now, so it costs 1.8
from statistics import NormalDist

level = round(3.5 / (100 * -NormalDist().inv_cdf(0.2 / 1.9 / 2)), 4)

# %% the estimate with one side
# says: that is an estimate with the water on one side only, and it is on both: p / 2 is for each of them
from statistics import NormalDist

level = round(3.5 / (100 * -NormalDist().inv_cdf(0.2 / 1.8)), 4)

# %% the probability
# says: that is the probability p of a lost ball; the level is what gives this probability
level = (0.8 - 0.6) / 1.8

# %% the number of standard deviations
# says: that is the number of standard deviations, and 3.5 / (100 level) is what it is
level = 1.59

# %% coarse places
# says: that is the crossing with places a quarter of a cell apart (`cell=0.25`), which is too coarse here: leave `cell` out
level = round(exact.crossing(0.02, 0.025, cell=0.25, max_hits=5), 4)

# %% the first level at which the chip is worth more
# says: it is too high; you are close, look in steps of 0.0001
level = 0.0233
