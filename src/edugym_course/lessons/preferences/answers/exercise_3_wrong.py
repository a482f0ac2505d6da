# %% no reference
# says: the reference is left out: that is a softmax of the values alone
def with_penalty(values, reference, penalty):
    weights = np.exp((values - values.max()) / penalty)
    return weights / weights.sum()


# %% times the penalty
# says: the values are multiplied by the penalty; a large penalty keeps to the reference, so divide
def with_penalty(values, reference, penalty):
    weights = reference * np.exp((values - values.max()) * penalty)
    return weights / weights.sum()


# %% not normalised
# says: they do not sum to 1: divide by their sum
def with_penalty(values, reference, penalty):
    below = np.where(reference > 0, values - values[reference > 0].max(), -np.inf)
    return reference * np.exp(below / penalty)


# %% it overflows
# says: : an exponential overflows, or all of them are 0; first subtract the largest value *among the actions that the reference takes* from all values, and leave the others out: they may be worth more, and 0 times infinity is NaN
def with_penalty(values, reference, penalty):
    weights = reference * np.exp(values / penalty)
    return weights / weights.sum()


# %% the wrong sign
# says: the sign is wrong: an action with a higher value becomes more likely
def with_penalty(values, reference, penalty):
    weights = reference * np.exp((values.min() - values) / penalty)
    return weights / weights.sum()


# %% greedy
# says: that is the greedy policy, which is what a penalty of 0 would give
def with_penalty(values, reference, penalty):
    policy = np.zeros(len(values))
    policy[np.argmax(np.where(reference > 0, values, -np.inf))] = 1
    return policy


# %% added
# says: the reference is added to the exponentials; multiply by it
def with_penalty(values, reference, penalty):
    weights = reference + np.exp((values - values.max()) / penalty)
    return weights / weights.sum()


# %% one number
# says: should give an array of shape (3,), but gives one of shape ()
def with_penalty(values, reference, penalty):
    return penalty


# %% no penalty
# says: the penalty is left out: divide the values by it
# in: from the largest
# - weights = reference * np.exp(below / penalty)
# + weights = reference * np.exp(below)


# %% the reference
# says: that is the reference: the values play no part
# in: from the largest
# - weights = reference * np.exp(below / penalty)
# + weights = reference * 1.0


# %% squared
# says: the reference is multiplied in twice
# in: from the largest
# - weights = reference * np.exp(below / penalty)
# + weights = reference * reference * np.exp(below / penalty)


# %% where it acts
# says: it matters only whether the reference takes an action, and it should matter how often
# in: from the largest
# - weights = reference * np.exp(below / penalty)
# + weights = (reference > 0) * np.exp(below / penalty)


# %% in place
# says: changes one of the arrays that it is given: make a new one
# in: from the largest
# - weights = reference * np.exp(below / penalty)
# + values -= values.max()
# + weights = reference * np.exp(below / penalty)


# %% negative zero by zero
# says: should give finite numbers, but gives
# says: : is something divided by 0?
# in: from the largest
# - weights = reference * np.exp(below / penalty)
# + weights = reference * np.exp(below) / (penalty - penalty)


# %% words
# says: should give an array of numbers of shape (3,), but gives 'more'
# in: from the largest
# - return weights / weights.sum()
# + return "more"


# %% an array
# says: values, reference and penalty
with_penalty = np.ones(3)


# %% from the largest of all
# says: an exponential overflows, or all of them are 0
# in: from the largest
# - below = np.where(reference > 0, values - values[reference > 0].max(), -np.inf)
# + below = values - values.max()


# %% the reference in the exponent
# says: the reference is added inside the exponential; it is multiplied by the exponential
def with_penalty(values, reference, penalty):
    exponents = values / penalty + reference
    weights = np.exp(exponents - exponents.max())
    return weights / weights.sum()


# %% the reference times the values
# says: the reference is multiplied by the values; it is multiplied by the exponential
def with_penalty(values, reference, penalty):
    exponents = reference * values / penalty
    weights = np.exp(exponents - exponents.max())
    return weights / weights.sum()


# %% the penalty squared
# says: beside the reference, action 1 gains on action 2 by e^-3.6, and should by e^((Q(s, 1) − Q(s, 2)) / β) = e^-1.8
def with_penalty(values, reference, penalty):
    values = np.where(reference > 0, values, -np.inf)
    weights = reference * np.exp((values - values.max()) / penalty**2)
    return weights / weights.sum()


# %% the reference last
# says: they do not sum to 1: divide by their sum, last of all
def with_penalty(values, reference, penalty):
    values = np.where(reference > 0, values, -np.inf)
    weights = np.exp((values - values.max()) / penalty)
    return reference * weights / weights.sum()


# %% the best one where the penalty is small
# says: and in the others it looks like this: that is the greedy policy, which is what a penalty of 0 would give
def with_penalty(values, reference, penalty):
    values = np.where(reference > 0, values, -np.inf)
    if penalty < 1e-3:
        return np.eye(len(values))[values.argmax()]
    weights = reference * np.exp((values - values.max()) / penalty)
    return weights / weights.sum()


# %% the sign, and an overflow
# says: the sign is wrong: an action with a higher value becomes more likely
def with_penalty(values, reference, penalty):
    weights = reference * np.exp(-(values - values.max()) / penalty)
    return weights / weights.sum()


# %% never quite never
# says: should give [0.0, 0.
# says: an action that the reference never takes keeps the probability 0
def with_penalty(values, reference, penalty):
    logits = np.log(np.maximum(reference, 1e-8)) + values / penalty
    weights = np.exp(logits - logits.max())
    return weights / weights.sum()


# %% a penalty of a hundredth or more
# says: beside the reference, action 0 gains on action 1 by e^0.01, and should by e^((Q(s, 0) − Q(s, 1)) / β) = e^1
def with_penalty(values, reference, penalty):
    taken = reference > 0
    weights = np.zeros(len(values))
    weights[taken] = reference[taken] * np.exp((values[taken] - values[taken].max()) / max(penalty, 0.01))
    return weights / weights.sum()


# %% a little more than the penalty
# says: beside the reference, action
# says: gains on action
# says: by e^
# says: , and should by e^((Q(s,
# says: ) − Q(s,
# says: )) / β) = e^
def with_penalty(values, reference, penalty):
    taken = reference > 0
    weights = np.zeros(len(values))
    weights[taken] = reference[taken] * np.exp((values[taken] - values[taken].max()) / (penalty + 1e-3))
    return weights / weights.sum()


# %% what is never taken counts as 0
# says: first subtract the largest value *among the actions that the reference takes* from all values
def with_penalty(values, reference, penalty):
    worth = np.where(reference > 0, values, 0)
    weights = reference * np.exp((worth - worth.max()) / penalty)
    return weights / weights.sum()


# %% what is never taken is not left out
# says: and leave the others out: they may be worth more
def with_penalty(values, reference, penalty):
    weights = reference * np.exp((values - values[reference > 0].max()) / penalty)
    return weights / weights.sum()
