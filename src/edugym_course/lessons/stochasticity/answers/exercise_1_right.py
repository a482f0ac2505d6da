# %% four digits
# says: Right: near 0.0232. By hand: 1.8 p = 0.2, so p = 0.111, which is 1.59 standard deviations on each side: 0.0220.
#   The dearer a hit, the more risk it is worth.
level = 0.0232

# %% by a loop
level = 0.015
while exact.from_the_tee(level, max_hits=5)["drive"] >= exact.from_the_tee(level, max_hits=5)["chip"]:
    level += 0.0001

# %% the step before
level = 0.02
while True:
    worth = exact.from_the_tee(level + 0.0001, max_hits=5)
    if worth["chip"] > worth["drive"]:
        break
    level += 0.0001

# %% by bisection
low, high = 0.02, 0.03
while high - low > 1e-5:
    middle = (low + high) / 2
    worth = exact.from_the_tee(middle, max_hits=5)
    if worth["drive"] > worth["chip"]:
        low = middle
    else:
        high = middle
level = low

# %% over an array
levels = np.arange(0.022, 0.025, 0.0001)
leads = [exact.from_the_tee(l, max_hits=5)["drive"] - exact.from_the_tee(l, max_hits=5)["chip"] for l in levels]
level = levels[np.abs(leads).argmin()]

# %% by the function for the crossing
level = exact.crossing(0.02, 0.025, max_hits=5)

# %% by interpolation
levels = [0.022, 0.023, 0.024]
leads = []
for each in levels:
    w = exact.from_the_tee(each, max_hits=5)
    leads.append(w["chip"] - w["drive"])
level = np.interp(0, leads, levels)
