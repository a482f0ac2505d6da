# %% nothing was done
# says: 1 word carries
# says: that is the value with which the cell began
words = 1

# %% the placeholder
# says: Not solved yet
words = ...

# %% divided
# says: that is 0.4 divided by the bits of one word;
# says: the words repeat each other in part, so more are needed
words = math.ceil(0.4 / information(0.1))

# %% divided and rounded down
# says: that is 0.4 divided by the bits of one word, rounded down;
words = int(0.4 / information(0.1))

# %% divided and not rounded
# says: words should be a whole number, since half a word is never said, but is
words = 0.4 / information(0.1)

# %% the last one below
# says: that is the last length that carries less than 0.4 bit; one word more is enough
words = max(L for L in range(1, 40) if information(0.1, L) < 0.4)

# %% one too many
# says: one word less is enough: does the search stop one too late?
words = 1
while information(0.1, words - 1) < 0.4:
    words += 1

# %% the longest message
# says: that is the longest message of this lesson, and fewer are enough
words = 28

# %% from the figure
# says: that is not enough yet
words = 16

# %% on the safe side
# says: fewer words are enough
words = 25

# %% the noise of the other figure
# says: that is the answer for τ = 0.05
words = next(L for L in range(1, 57) if information(0.05, L) >= 0.4)

# %% half a bit
# says: that is where *half* a bit is reached
words = next(L for L in range(1, 57) if information(0.1, L) >= 0.5)
