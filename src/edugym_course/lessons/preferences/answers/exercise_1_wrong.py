# %% the second
# says: that is the probability of the *second* night: σ takes first − second
def prefers(first, second, noise):
    return 0.5 * (1 + np.tanh((second - first) / (2 * noise)))


# %% no noise
# says: the noise is left out: divide the difference by it
def prefers(first, second, noise):
    return 0.5 * (1 + np.tanh((first - second) / 2))


# %% times the noise
# says: the difference is multiplied by the noise; more noise brings p closer to 1/2, so divide
def prefers(first, second, noise):
    return 0.5 * (1 + np.tanh((first - second) * noise / 2))


# %% without parentheses
# says: only the second night is divided by the noise: put the difference in parentheses
def prefers(first, second, noise):
    return 1 / (1 + np.exp(-(first - second / noise)))


# %% never wrong
# says: that is 1 or 0, as if the teacher never erred
def prefers(first, second, noise):
    return first > second and 1.0 or 0.0


# %% it overflows
# says: : an exponential overflows, so write σ(x) for x below 0 as e^x / (1 + e^x), and else as 1 / (1 + e^(−x))
def prefers(first, second, noise):
    x = (first - second) / noise
    return np.exp(x) / (1 + np.exp(x))


# %% an exponential alone
# says: that is e^x and no probability: divide it by 1 + e^x
def prefers(first, second, noise):
    return np.exp((first - second) / noise)


# %% no return
# says: gives None: is a `return` missing?
def prefers(first, second, noise):
    x = (first - second) / noise
    1 / (1 + np.exp(-x))


# %% never wrong, but for ties
# says: that is 1, 1/2 or 0, as if the teacher never erred
def prefers(first, second, noise):
    return 0.5 + 0.5 * np.sign(first - second)


# %% the difference
# says: that is x itself, and σ(x) is missing
def prefers(first, second, noise):
    return (first - second) / noise


# %% the logarithm
# says: that is the logarithm of the probability
def prefers(first, second, noise):
    return -np.logaddexp(0, -(first - second) / noise)


# %% the hyperbolic tangent
# says: that is tanh, which goes from −1 to 1; σ goes from 0 to 1
def prefers(first, second, noise):
    return np.tanh((first - second) / noise)


# %% a number
# says: first, second and noise
prefers = 0.5
