# %% four digits
# says: Right: near 0.0232. By hand: 1.8 p = 0.2, so p = 0.111, which is 1.59 standard deviations on each side: 0.0220.
#   The more a hit costs, the more risk is worth taking.
level = 0.0232

# %% by the function for the crossing
level = exact.crossing(0.02, 0.025, max_hits=5)

# %% by interpolation
levels = [0.022, 0.023, 0.024]
leads = []
for each in levels:
    w = exact.from_the_tee(each, max_hits=5)
    leads.append(w["chip"] - w["drive"])
level = np.interp(0, leads, levels)
