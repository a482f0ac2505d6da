# %% the number
# says: Right: 22, not 19. The second word tells a part of what the first one has told already, so that information adds
#   up more and more slowly.
words = 22

# %% as a float
words = 22.0

# %% a loop with a condition
words = 1
while not information(0.1, words) >= 0.4:
    words = words + 1

# %% the first of a range
words = next(L for L in range(1, 57) if information(0.1, L) >= 0.4)

# %% the smallest of a list
words = min([L for L in range(1, 40) if information(0.1, L) >= 0.4])

# %% of NumPy
bits = np.array([information(0.1, L) for L in range(1, 40)])
words = np.searchsorted(bits, 0.4) + 1


# %% by a function
def carries(n):
    return information(tau=0.1, length=n)


words = 0
for n in range(1, 30):
    if carries(n) >= 0.4:
        words = n
        break
