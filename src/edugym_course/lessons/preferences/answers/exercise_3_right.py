# %% from the largest
# says: Right: the reference, tilted towards what is worth more. An action that it never takes is never taken.
def with_penalty(values, reference, penalty):
    below = np.where(reference > 0, values - values[reference > 0].max(), -np.inf)
    weights = reference * np.exp(below / penalty)
    return weights / weights.sum()


# %% with logarithms
def with_penalty(values, reference, penalty):
    logits = np.where(reference > 0, np.log(np.maximum(reference, 1e-300)) + values / penalty, -np.inf)
    weights = np.exp(logits - logits.max())
    return (weights / weights.sum()).tolist()
