# %% no logarithm
# says: the logarithm is missing
# in: with a root
# - return q + c * sqrt(log(n_node) / n_action) if n_action > 0 else inf
# + return q + c * sqrt(n_node / n_action) if n_action > 0 else inf

# %% the logarithm of the ratio
# says: that is the logarithm of the ratio; only N(node) has one
# in: with a root
# - return q + c * sqrt(log(n_node) / n_action) if n_action > 0 else inf
# + return q + c * sqrt(log(n_node / n_action)) if n_action > 0 else inf

# %% exchanged
# says: the two numbers are exchanged: the *action* was tried seldom, so its N stands below the line
# in: with a root
# - return q + c * sqrt(log(n_node) / n_action) if n_action > 0 else inf
# + return q + c * sqrt(log(n_action) / n_node) if n_action > 0 else inf

# %% the same bonus for all
# says: N(node, a) is missing: then all actions get the same bonus
# in: with a root
# - return q + c * sqrt(log(n_node) / n_action) if n_action > 0 else inf
# + return q + c * sqrt(log(n_node)) if n_action > 0 else inf

# %% a short root
# says: only the logarithm is under the root; N(node, a) belongs there, too
# in: with a root
# - return q + c * sqrt(log(n_node) / n_action) if n_action > 0 else inf
# + return q + c * sqrt(log(n_node)) / n_action if n_action > 0 else inf

# %% no root
# says: the square root is missing
# in: with a root
# - return q + c * sqrt(log(n_node) / n_action) if n_action > 0 else inf
# + return q + c * log(n_node) / n_action if n_action > 0 else inf

# %% no constant
# says: c is missing
# in: with a root
# - return q + c * sqrt(log(n_node) / n_action) if n_action > 0 else inf
# + return q + sqrt(log(n_node) / n_action) if n_action > 0 else inf

# %% the constant under the root
# says: c stands under the root; it is outside
# in: with a root
# - return q + c * sqrt(log(n_node) / n_action) if n_action > 0 else inf
# + return q + sqrt(c * log(n_node) / n_action) if n_action > 0 else inf

# %% a lower bound
# says: the bonus is subtracted: that is a *lower* bound
# in: with a root
# - return q + c * sqrt(log(n_node) / n_action) if n_action > 0 else inf
# + return q - c * sqrt(log(n_node) / n_action) if n_action > 0 else inf

# %% the bonus alone
# says: Q(node, a) is missing: then the search looks for what is seldom, not for what is good
# in: with a root
# - return q + c * sqrt(log(n_node) / n_action) if n_action > 0 else inf
# + return c * sqrt(log(n_node) / n_action) if n_action > 0 else inf

# %% one more
# says: 1 is added to N(node, a): that makes an action that was never tried look like any other
# in: with a root
# - return q + c * sqrt(log(n_node) / n_action) if n_action > 0 else inf
# + return q + c * sqrt(log(n_node) / (n_action + 1))

# %% zero for what was not tried
# says: should be infinite, but is
# says: an action that was never tried comes first, so its bound is infinite: float('inf')
# in: with a root
# - return q + c * sqrt(log(n_node) / n_action) if n_action > 0 else inf
# + return q + c * sqrt(log(n_node) / n_action) if n_action > 0 else q

# %% divided by zero
# says: raises ZeroDivisionError
# in: with a root
# - return q + c * sqrt(log(n_node) / n_action) if n_action > 0 else inf
# + return q + c * sqrt(log(n_node) / n_action)

# %% a number
# says: q, n_action, n_node and c
upper_bound = 3.5

# %% base 10
# says: ln is the natural logarithm, not that of base 10
# in: with a root
# - return q + c * sqrt(log(n_node) / n_action) if n_action > 0 else inf
# + return q + c * sqrt(np.log10(n_node) / n_action) if n_action > 0 else inf

# %% base 2
# says: ln is the natural logarithm, not that of base 2
# in: with a root
# - return q + c * sqrt(log(n_node) / n_action) if n_action > 0 else inf
# + return q + c * sqrt(np.log2(n_node) / n_action) if n_action > 0 else inf

# %% one choice too many
# says: 1 is added to N(node), which counts all choices already
# in: with a root
# - return q + c * sqrt(log(n_node) / n_action) if n_action > 0 else inf
# + return q + c * sqrt(log(n_node + 1) / n_action) if n_action > 0 else inf

# %% twice the logarithm
# says: some books have a 2 before the logarithm; here c takes its place
# in: with a root
# - return q + c * sqrt(log(n_node) / n_action) if n_action > 0 else inf
# + return q + c * sqrt(2 * log(n_node) / n_action) if n_action > 0 else inf

# %% a mean of the mean
# says: Q(node, a) is a mean already: it is divided by N(node, a) once more
# in: with a root
# - return q + c * sqrt(log(n_node) / n_action) if n_action > 0 else inf
# + return q / n_action + c * sqrt(log(n_node) / n_action) if n_action > 0 else inf

# %% as in AlphaZero
# says: that is the bonus of AlphaZero, √N(node) / (1 + N(node, a)); here it has a logarithm
# in: with a root
# - return q + c * sqrt(log(n_node) / n_action) if n_action > 0 else inf
# + return q + c * sqrt(n_node) / (1 + n_action) if n_action > 0 else inf

# %% a text
# says: should be infinite, but is 'inf': an action that was never tried comes first, so its bound is infinite
# in: with a root
# - return q + c * sqrt(log(n_node) / n_action) if n_action > 0 else inf
# + return q + c * sqrt(log(n_node) / n_action) if n_action > 0 else "inf"

# %% the logarithm of a root
# says: that is the logarithm of a root; it is the root of a logarithm
# in: with a root
# - return q + c * sqrt(log(n_node) / n_action) if n_action > 0 else inf
# + return q + c * log(sqrt(n_node / n_action)) if n_action > 0 else inf

# %% c at Q
# says: c is multiplied with Q(node, a); it belongs to the root
# in: with a root
# - return q + c * sqrt(log(n_node) / n_action) if n_action > 0 else inf
# + return c * q + sqrt(log(n_node) / n_action) if n_action > 0 else inf


# %% c times infinity
# says: should be infinite, but is nan: an action that was never tried comes first, so its bound is infinite: float('inf')
def upper_bound(q, n_action, n_node, c):
    return q + c * (float("inf") if n_action == 0 else (log(n_node) / n_action) ** 0.5)


# %% the logarithm outside
# says: only N(node, a) is under the root; the logarithm belongs there, too
# in: the solution of upper_bound
# - return q + c * (log(n_node) / n_action) ** 0.5
# + return q + c * log(n_node) / n_action**0.5


# %% once is never
# says: should be finite, but is infinite:
# says: this action was tried; only one that was never tried has an infinite bound
# in: the solution of upper_bound
# - if n_action == 0:
# + if n_action <= 1:


# %% the logarithm first
# says: should be infinite, but
# says: raises ValueError
def upper_bound(q, n_action, n_node, c):
    logarithm = log(n_node)
    return q + c * sqrt(logarithm / n_action) if n_action else inf
