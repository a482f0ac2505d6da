# %% the number
# says: Right: 22, not 19. The second word tells a part of what the first one has told already, so that information adds
#   up more and more slowly.
words = 22

# %% the first of a range
words = next(L for L in range(1, 57) if information(0.1, L) >= 0.4)

# %% of NumPy
# slow
bits = np.array([information(0.1, L) for L in range(1, 40)])
words = np.searchsorted(bits, 0.4) + 1
