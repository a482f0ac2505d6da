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


# %% a share
# says: that is the share of the first return; returns may be negative, and only their difference counts
def prefers(first, second, noise):
    return first / (first + second) if first + second else 0.0


# %% a normal distribution
# says: that is the distribution function of a normal distribution; σ is 1 / (1 + e^(−x))
def prefers(first, second, noise):
    from math import erf, sqrt

    return (1 + erf((first - second) / noise / sqrt(2))) / 2


# %% the noise outside
# says: σ itself is divided by the noise; divide the difference
def prefers(first, second, noise):
    return 1 / (1 + np.exp(second - first)) / noise


# %% the noise squared
# says: the difference is divided by the square of the noise
def prefers(first, second, noise):
    return 1 / (1 + np.exp((second - first) / noise**2))


# %% twice the noise
# says: the difference is divided by twice the noise
def prefers(first, second, noise):
    return 1 / (1 + np.exp((second - first) / noise / 2))


# %% cut at ten
# says: : the difference is cut off too early
def prefers(first, second, noise):
    x = np.clip((first - second) / noise, -10, 10)
    return 1 / (1 + np.exp(-x))


# %% the difference twice
# says: the difference counts twice: with tanh, σ(x) is (1 + tanh(x / 2)) / 2
def prefers(first, second, noise):
    return (1 + np.tanh((first - second) / noise)) / 2


# %% it overflows in math
# says: raises OverflowError: math range error (the exponential of a number above 709 is too large: write it with a negative exponent)
import math


def prefers(first, second, noise):
    return 1 / (1 + math.exp(-(first - second) / noise))


# %% the noise taken off
# says: : that is σ(0), and should be σ(1)
# says: that is σ(
# says: ), and should be σ(
def prefers(first, second, noise):
    return 0.5 * (1 + np.tanh((first - second - noise) / 2))


# %% the difference is cut off
# says: and should be σ(2.5)
def prefers(first, second, noise):
    x = np.clip(first - second, -100, 100) / noise
    return 1 / (1 + np.exp(-x))


# %% the sign of the first night decides
# says: : an exponential overflows, so write σ(x) for x below 0 as e^x / (1 + e^x), and else as 1 / (1 + e^(−x))
def prefers(first, second, noise):
    x = (first - second) / noise
    return 1 / (1 + np.exp(-x)) if first >= 0 else np.exp(x) / (1 + np.exp(x))
