# %% in one line
# says: Right: the mean of both scores is 0, so a baseline changes nothing on average. See your policies learn:
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, (a - mu) ** 2 / sigma**2 - 1


# %% standardised
def my_scores(a, mu, sigma):
    z = (a - mu) / sigma
    return z / sigma, z**2 - 1


# %% the derivative with respect to σ, times σ
def my_scores(a, mu, sigma):
    of_sigma = ((a - mu) ** 2 - sigma**2) / sigma**3
    return (a - mu) / sigma**2, sigma * of_sigma


# %% a list
def my_scores(a, mu, sigma):
    return [(a - mu) / sigma**2, (a - mu) ** 2 / sigma**2 - 1]


# %% the variance first
def my_scores(a, mu, sigma):
    variance = sigma * sigma
    distance = a - mu
    return distance / variance, (distance * distance - variance) / variance


# %% minus signs
def my_scores(a, mu, sigma):
    return -(mu - a) / sigma**2, -1 + (mu - a) ** 2 / sigma**2


# %% the lesson's function
def my_scores(a, mu, sigma):
    return release.scores(a, mu, sigma)
