# %% by logarithms
# says: Right: ε = 1.38 % is little, and yet one wrong grip in 145 costs half of the climbs.
epsilon = 2 - 2 * math.exp(math.log(0.5) / 100)

# %% a fraction
epsilon = Fraction(27631, 2_000_000)

# %% by bisection
low, high = 0.0, 1.0
for _ in range(60):
    middle = (low + high) / 2
    if (1 - middle / 2) ** 100 >= 0.5:
        low = middle
    else:
        high = middle
epsilon = low
