# %% a power
# says: Right: one exploring action on the way makes the ratio 0, whatever the others were. With nine later actions, ε =
#   0.1 and N = 5 a target counts 2.1 times or not at all.
def importance_ratio(greedy, epsilon, n_actions):
    later = greedy[1:]
    if not all(later):
        return 0.0
    return (1 - epsilon + epsilon / n_actions) ** -len(later)


# %% math.prod
def importance_ratio(greedy, epsilon, n_actions):
    b = 1 - epsilon * (n_actions - 1) / n_actions
    return math.prod(1 / b if is_greedy else 0 for is_greedy in greedy[1:])


# %% a loop with indices
def importance_ratio(greedy, epsilon, n_actions):
    rho = 1.0
    for k in range(1, len(greedy)):
        pi = 1.0 if greedy[k] else 0.0
        b = 1 - epsilon + epsilon / n_actions if greedy[k] else epsilon / n_actions
        rho *= pi / b
    return rho
