# %% a number
# says: should be a function
# says: v and gamma
smallest_error = 3.0


# %% without the cost
# says: the step costs 1, which the error has to pay first: the reward of a bump seems to be e − 1
def smallest_error(v, gamma):
    return (1 - gamma) * v


# %% the cost with the wrong sign
# says: the cost of the step is −1, so solve e − 1 = (1 − γ) v for e: it adds 1
def smallest_error(v, gamma):
    return (1 - gamma) * v - 1


# %% divided
# says: bumping for ever is worth the reward *divided* by 1 − γ
def smallest_error(v, gamma):
    return 1 + v / (1 - gamma)


# %% the value at once
# says: that leaves the future out: one bump alone need not be worth v, for it is followed by more
def smallest_error(v, gamma):
    return 1 + v


# %% gamma v
# says: that compares with γ v; compare with v, what the best way is worth from here
def smallest_error(v, gamma):
    return 1 + gamma * v


# %% 1
# says: that is 1, the error from which a bump pays at all; it must pay more than leaving
def smallest_error(v, gamma):
    return 1


# %% v
# says: that is v itself
def smallest_error(v, gamma):
    return v


# %% without an error
# says: that is what bumping is worth without an error, −1/(1 − γ)
def smallest_error(v, gamma):
    return -1 / (1 - gamma)


# %% the cost comes once
# says: that solves e/(1 − γ) − 1 = v: the cost of 1 comes with every bump
def smallest_error(v, gamma):
    return (1 - gamma) * (v + 1)


# %% plus gamma
# says: the sign of γ is wrong: the sum 1 + γ + γ² + ... is 1/(1 − γ)
def smallest_error(v, gamma):
    return 1 + (1 + gamma) * v


# %% minus
# says: that is 1 − (1 − γ) v: the two terms add up
def smallest_error(v, gamma):
    return 1 - (1 - gamma) * v


# %% the cost twice
# says: the cost is subtracted twice
def smallest_error(v, gamma):
    return 2 + (1 - gamma) * v - gamma


# %% three bumps
# says: only the first three bumps are counted, and there is no end to them
def smallest_error(v, gamma):
    return 1 + v / (1 + gamma + gamma**2)


# %% 500 bumps
# says: only 500 bumps are counted, as in an episode; the plan knows no step limit
def smallest_error(v, gamma):
    return 1 + v / sum(gamma**k for k in range(500))


# %% one parameter
# says: its parameters are not those of the exercise
def smallest_error(v):
    return 1 + v


# %% half of it
# says: solve (e − 1)/(1 − γ) = v for e
def smallest_error(v, gamma):
    return 1 + (1 - gamma) * v / 2


# %% arguments swapped
# says: v and γ have changed places: the function is called with v first
def smallest_error(gamma, v):
    return 1 + (1 - gamma) * v


# %% the sum begins with γ
# says: the sum of the bumps begins with x and not with γ x: the first bump is not discounted
def smallest_error(v, gamma):
    return 1 + (1 - gamma) / gamma * v


# %% no brackets
# says: brackets are missing: v times all of (1 − γ)
def smallest_error(v, gamma):
    return 1 + v * 1 - gamma


# %% a fixed γ
# says: it takes 0.95 for γ: use the `gamma` that the function is given
def smallest_error(v, gamma):
    return 1 + v * (1 - 0.95)


# %% a fixed v
# says: it takes 40 for v: use the `v` that the function is given
def smallest_error(v, gamma):
    return 1 + 40 * (1 - gamma)


# %% a hundred bumps
# says: only 100 bumps are counted, and there is no end to them
def smallest_error(v, gamma):
    return 1 + v / sum(gamma**k for k in range(100))


# %% rounded
# says: is it rounded? Give the number as it is, without round(), int() or //
def smallest_error(v, gamma):
    return round(1 + (1 - gamma) * v, 1)
