# %% with a root
# says: Right: who was tried seldom gets the benefit of the doubt.
def upper_bound(q, n_action, n_node, c):
    return q + c * sqrt(log(n_node) / n_action) if n_action > 0 else inf


# %% with NumPy
def upper_bound(q, n_action, n_node, c):
    if not n_action:
        return np.inf
    return q + c * np.sqrt(np.log(n_node)) / np.sqrt(n_action)
