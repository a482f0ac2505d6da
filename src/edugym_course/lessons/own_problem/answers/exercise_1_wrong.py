# %% nothing was done
# says: that is the value with which the cell began
late = 10.0

# %% the placeholder
# says: Not solved yet
late = ...

# %% a ring that never fails
# says: a ring fails with probability 0.1; then she is dozing, which is worth 1 and costs `late`
late = 6

# %% compared with the chime
# says: compare the ring with staying quiet, which is better there than a chime
late = 5.2 / 0.9

# %% dozing is worth nothing
# says: when the ring fails she is dozing, and that is worth 1
late = 6 / 0.9

# %% sleep is worth nothing after silence
# says: who stays asleep has slept: staying quiet is worth 2 − late
late = 3.9 / 0.9

# %% sleep is worth nothing at all
# says: staying quiet is worth 2 − late, and a failed ring 1 − late, as sleep is worth its depth
late = 4 / 0.9

# %% the cost of a ring
# says: that is the cost of a ring alone
late = 4.0

# %% the probabilities exchanged
# says: 0.9 and 0.1 have changed places: a ring *wakes* her with probability 0.9
late = 51

# %% negative
# says: late is a cost, and the reward function subtracts it: it is above 0
late = -6.5556

# %% a reward of zero
# says: best to stay quiet
# says: too low for a ring
late = 2.0

# %% too large
# says: higher than it need be
late = 8

# %% one digit
# says: ; you are close, but is it rounded, and not cut off, to two digits after the decimal point?
late = 6.6

# %% the decimal point
# says: that is ten times as much, or the decimal point is in the wrong place
late = 590 / 9

# %% fast asleep after a ring that fails
# says: when the ring fails she is dozing, which is worth 1, and no longer fast asleep, worth 2
# says: at 8:20 when she is fast asleep, for a ring is worth
# says: there and silence
late = (2 + 4 - 0.2) / 0.9

# %% dozing is a cost
# says: when the ring fails she dozes, which is worth 1: that speaks for the ring, and so it is subtracted
late = (2 + 4 + 0.1) / 0.9

# %% a ring for nothing
# says: the ring itself costs 4, and that is missing
late = (2 - 0.1) / 0.9

# %% never late after a ring
# says: when the ring fails she is late as well, and that costs `late` once more
late = 2 + 4 - 0.1
