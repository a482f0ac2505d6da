# %% in two ways
# says: Right: only the difference counts, in units of the noise, and far apart she is sure.
def prefers(first, second, noise):
    x = (first - second) / noise
    return 1 / (1 + np.exp(-x)) if x >= 0 else np.exp(x) / (1 + np.exp(x))


# %% by the hyperbolic tangent
def prefers(first, second, noise):
    return 0.5 * (1 + np.tanh((first - second) / (2 * noise)))


# %% by logaddexp
def prefers(first, second, noise):
    return np.exp(-np.logaddexp(0, -(first - second) / noise))


# %% an array without axes
def prefers(first, second, noise):
    x = (first - second) / noise
    e = np.exp(-abs(x))
    return np.where(x >= 0, 1 / (1 + e), e / (1 + e))
