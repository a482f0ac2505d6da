# %% the placeholder
# says: Not solved yet
def my_scores(a, mu, sigma):
    raise NotImplementedError("not solved yet: replace this line")


# %% only one
# says: should give two numbers, one for μ and one for ln σ, but gives
# says: : end with `return of_mu, of_log_sigma`
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2


# %% σ, not squared
# says: divide by σ², not by σ
def my_scores(a, mu, sigma):
    return (a - mu) / sigma, (a - mu) ** 2 / sigma**2 - 1


# %% no division
# says: the derivative of (a − μ)² / (2σ²) brings 1/σ² with it; the division is missing
def my_scores(a, mu, sigma):
    return a - mu, (a - mu) ** 2 / sigma**2 - 1


# %% the wrong sign
# says: the sign is wrong: an action above the mean gets likelier if the mean grows
def my_scores(a, mu, sigma):
    return (mu - a) / sigma**2, (a - mu) ** 2 / sigma**2 - 1


# %% half
# says: the 2 of the square and the 2 in 2σ² cancel
def my_scores(a, mu, sigma):
    return (a - mu) / (2 * sigma**2), (a - mu) ** 2 / sigma**2 - 1


# %% twice
# says: the 2 of the square and the 2 in 2σ² cancel; here the 2 is too many
def my_scores(a, mu, sigma):
    return 2 * (a - mu) / sigma**2, (a - mu) ** 2 / sigma**2 - 1


# %% no brackets
# says: set brackets: a − μ is divided as a whole
def my_scores(a, mu, sigma):
    return a - mu / sigma**2, (a - mu) ** 2 / sigma**2 - 1


# %% the logarithm itself
# says: that is ln π (but for a constant), not its derivative
def my_scores(a, mu, sigma):
    return -((a - mu) ** 2) / (2 * sigma**2) - math.log(sigma), (a - mu) ** 2 / sigma**2 - 1


# %% times the variance
# says: that is σ² in the numerator; divide by it
def my_scores(a, mu, sigma):
    return (a - mu) * sigma**2, (a - mu) ** 2 / sigma**2 - 1


# %% exchanged
# says: that is the score of ln σ; the score of μ comes first
def my_scores(a, mu, sigma):
    return (a - mu) ** 2 / sigma**2 - 1, (a - mu) / sigma**2


# %% of σ
# says: that is the derivative with respect to σ; for ln σ multiply it by σ
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, (a - mu) ** 2 / sigma**3 - 1 / sigma


# %% of the variance
# says: that is the derivative with respect to σ²; for ln σ multiply it by 2σ²
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, (a - mu) ** 2 / (2 * sigma**4) - 1 / (2 * sigma**2)


# %% no −1
# says: the term − ln σ is forgotten; its derivative with respect to ln σ is −1
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, (a - mu) ** 2 / sigma**2


# %% the sign of the second
# says: the sign is wrong: σ should grow for actions that are far out
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, 1 - (a - mu) ** 2 / sigma**2


# %% plus 1
# says: the derivative of − ln σ is −1, not +1
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, (a - mu) ** 2 / sigma**2 + 1


# %% half of the second
# says: the exponent −2 of σ gives a factor of 2, which cancels the 2 in 2σ²
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, (a - mu) ** 2 / (2 * sigma**2) - 1


# %% not squared
# says: a − μ should be squared
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, (a - mu) / sigma**2 - 1


# %% σ once
# says: σ is divided by once too little: (a − μ)² is divided by σ²
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, (a - mu) ** 2 / sigma - 1


# %% for single numbers only
# says: my_scores with three actions at once should give three numbers for each score: use + - * / **, and no sum or mean
def my_scores(a, mu, sigma):
    if np.size(a) > 1:
        a = a[0]
    return (a - mu) / sigma**2, (a - mu) ** 2 / sigma**2 - 1


# %% with math
# says: raises TypeError
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, math.exp(2 * math.log(abs(a - mu) / sigma)) - 1


# %% it writes into the actions
# says: changes the array `a`
# says: ` that it is given: `-=` and the like write into an array, so give what you compute a name of its own
# says: my_scores changes the array `
def my_scores(a, mu, sigma):
    a -= mu
    return a / sigma**2, a**2 / sigma**2 - 1


# %% nothing for arrays
# says: with three actions at once gives None: is a `return` missing
# says: my_scores(a, mu, sigma) with three actions at once
def my_scores(a, mu, sigma):
    if np.ndim(a) == 0:
        return (a - mu) / sigma**2, (a - mu) ** 2 / sigma**2 - 1


# %% rounded
# says: do not round it
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, np.round((a - mu) ** 2 / sigma**2 - 1, 3)


# %% the square again
# says: the derivative of a square is not a square
def my_scores(a, mu, sigma):
    return (a - mu) ** 2 / sigma**2, (a - mu) ** 2 / sigma**2 - 1


# %% to the third
# says: the derivative of the square root is taken: divide by σ², once
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**3, (a - mu) ** 2 / sigma**2 - 1


# %% of π
# says: that is the derivative of π, not of ln π
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**3 * np.exp(-((a - mu) ** 2) / (2 * sigma**2)) / np.sqrt(2 * np.pi), (
        a - mu
    ) ** 2 / sigma**2 - 1


# %% less 1/σ
# says: the derivative of − ln σ with respect to ln σ is −1, not −1/σ
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, (a - mu) ** 2 / sigma**2 - 1 / sigma


# %% times the variance, in the second
# says: σ² in the numerator should be σ² below
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, (a - mu) ** 2 * sigma**2 - 1


# %% the first one twice
# says: that is the score of μ; the score of ln σ comes second
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, (a - mu) / sigma**2


# %% brackets
# says: it is (a − μ)² − σ² that is divided by σ²: set brackets
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, (a - mu) ** 2 - sigma**2 / sigma**2


# %% to the third, in the second
# says: divided by σ³ it is the derivative with respect to σ; and there −1/σ belongs to it
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, (a - mu) ** 2 / sigma**3 - 1


# %% plus a half
# says: derive it again from ln π(a), term by term
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, (a - mu) ** 2 / sigma**2 - 0.5


# %% a class
# says: a, mu and sigma
class my_scores:
    pass


# %% a distance
# says: the sign of a − μ counts, so take no absolute value
def my_scores(a, mu, sigma):
    return abs(a - mu) / sigma**2, (a - mu) ** 2 / sigma**2 - 1


# %% whole numbers
# says: `//` cuts off what is behind the decimal point; divide by `/`
def my_scores(a, mu, sigma):
    return (a - mu) // sigma**2, (a - mu) ** 2 / sigma**2 - 1


# %% minus sigma
# says: the derivative of − ln σ with respect to ln σ is −1, not −σ
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, (a - mu) ** 2 / sigma**2 - sigma


# %% minus ln sigma
# says: the derivative of − ln σ with respect to ln σ is −1, not −ln σ
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, (a - mu) ** 2 / sigma**2 - np.log(sigma)


# %% divided by sigma
# says: the derivative with respect to σ is divided by σ; multiply it by σ
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, ((a - mu) ** 2 / sigma**3 - 1 / sigma) / sigma


# %% twice times sigma
# says: the derivative with respect to σ is multiplied by σ²; multiply it by σ
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, sigma**2 * ((a - mu) ** 2 / sigma**3 - 1 / sigma)


# %% one minus too many
# says: the minus before (a − μ)² / (2σ²) and that of the exponent −2 make a plus
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, -((a - mu) ** 2) / sigma**2 - 1


# %% of ln of the variance
# says: that is the derivative with respect to ln σ²; with respect to ln σ it is twice as large
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, ((a - mu) ** 2 / sigma**2 - 1) / 2


# %% a 2 too many
# says: the exponent −2 of σ and the 2 in 2σ² cancel; here the 2 is too many
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, 2 * (a - mu) ** 2 / sigma**2 - 1


# %% one star
# says: σ * 2 is twice σ; its square is σ**2
def my_scores(a, mu, sigma):
    return (a - mu) / sigma * 2, (a - mu) ** 2 / sigma**2 - 1


# %% one star in the second
# says: σ * 2 is twice σ, and (a − μ) * 2 twice a − μ; squares are written **2
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, (a - mu) ** 2 / sigma * 2 - 1


# %% one star above the line
# says: (a − μ) * 2 is twice a − μ; its square is (a − μ)**2
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, (a - mu) * 2 / sigma**2 - 1


# %% the two terms
# says: that is the first term of ln π(a), and not its derivative
def my_scores(a, mu, sigma):
    return -((a - mu) ** 2) / (2 * sigma**2), -np.log(sigma)


# %% a logarithm that is none
# says: `sigma` is σ itself and not ln σ, so no power of e is needed
def my_scores(a, mu, sigma):
    spread = np.exp(sigma)
    return (a - mu) / spread**2, (a - mu) ** 2 / spread**2 - 1


# %% the second term
# says: that is the second term of ln π(a), and not its derivative
def my_scores(a, mu, sigma):
    return (a - mu) / sigma**2, -np.log(sigma)


# %% the square of the first
# says: (a − μ)² is divided by σ², not by σ⁴
def my_scores(a, mu, sigma):
    of_mu = (a - mu) / sigma**2
    return of_mu, of_mu**2 - 1
