# %% a fraction
# says: Right: 59/9. Below it the best clock lets her sleep on when she is fast asleep at 8:20. Nothing in its code says
#   so but a number.
late = 59 / 9

# %% NumPy's number
late = np.float32(6.5556)

# %% by bisection
low, high = 0.0, 20.0
while high - low > 1e-4:
    middle = (low + high) / 2
    if -4 + 0.1 * (1 - middle) > 2 - middle:
        high = middle
    else:
        low = middle
late = high
