# %% in one line
# says: Right: the mean of both scores is 0, so a baseline changes nothing on average. See your policies learn:
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, (a - mu) ** 2 / sigma**2 - 1


# %% the variance first
def my_scores(a, mu, sigma):
    variance = sigma * sigma
    distance = a - mu
    return distance / variance, (distance * distance - variance) / variance


# %% the lesson's function
def my_scores(a, mu, sigma):
    return release.scores(a, mu, sigma)
