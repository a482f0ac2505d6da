# %% from the largest
# says: Right: the reference, tilted towards what is worth more. An action that it never takes is never taken.
def with_penalty(values, reference, penalty):
    weights = reference * np.exp((values - values.max()) / penalty)
    return weights / weights.sum()


# %% with logarithms
def with_penalty(values, reference, penalty):
    logits = np.log(np.maximum(reference, 1e-300)) + values / penalty
    weights = np.exp(logits - logits.max()) * (reference > 0)
    return (weights / weights.sum()).tolist()
