# %% a number
# says: should be a function
# says: greedy, epsilon and n_actions
importance_ratio = 2.1


# %% with the first action
# says: the first entry of `greedy` is A_t, which is not in the product: start at greedy[1]
def importance_ratio(greedy, epsilon, n_actions):
    rho = 1.0
    for is_greedy in greedy:
        rho *= 1 / (1 - epsilon + epsilon / n_actions) if is_greedy else 0.0
    return rho


# %% two left out
# says: two actions are left out at the start; only A_t is, so start at greedy[1]
def importance_ratio(greedy, epsilon, n_actions):
    rho = 1.0
    for is_greedy in greedy[2:]:
        rho *= 1 / (1 - epsilon + epsilon / n_actions) if is_greedy else 0.0
    return rho


# %% the last one left out
# says: the last action is left out; the product goes to the end of the list
def importance_ratio(greedy, epsilon, n_actions):
    rho = 1.0
    for k in range(1, len(greedy) - 1):
        rho *= 1 / (1 - epsilon + epsilon / n_actions) if greedy[k] else 0.0
    return rho


# %% a random action is never the best
# says: a random action may be the best one too, so b takes it with probability 1 − ε + ε/N, not 1 − ε
def importance_ratio(greedy, epsilon, n_actions):
    return (1 / (1 - epsilon)) ** (len(greedy) - 1) if all(greedy[1:]) else 0.0


# %% one of the others
# says: a random action is one of *all* N actions, so b takes the best one with probability 1 − ε + ε/N
def importance_ratio(greedy, epsilon, n_actions):
    b = 1 - epsilon + epsilon / (n_actions - 1)
    return b ** -(len(greedy) - 1) if all(greedy[1:]) else 0.0


# %% 1 − ε/N
# says: b takes the best action with probability 1 − ε + ε/N; 1 − ε/N is another number
def importance_ratio(greedy, epsilon, n_actions):
    b = 1 - epsilon / n_actions
    return b ** -(len(greedy) - 1) if all(greedy[1:]) else 0.0


# %% other actions left out
# says: the greedy policy never takes another action, so its ratio there is 0/b = 0, and it is left out here
def importance_ratio(greedy, epsilon, n_actions):
    rho = 1.0
    for is_greedy in greedy[1:]:
        if is_greedy:
            rho *= 1 / (1 - epsilon + epsilon / n_actions)
    return rho


# %% the product stops
# says: the product stops at an action that is not greedy; there the factor is 0, and so is the whole product
def importance_ratio(greedy, epsilon, n_actions):
    rho = 1.0
    for is_greedy in greedy[1:]:
        if not is_greedy:
            break
        rho *= 1 / (1 - epsilon + epsilon / n_actions)
    return rho


# %% one over the probability of what was done
# says: the greedy policy never takes another action: there π is 0, not 1
def importance_ratio(greedy, epsilon, n_actions):
    rho = 1.0
    for is_greedy in greedy[1:]:
        rho /= 1 - epsilon + epsilon / n_actions if is_greedy else epsilon / n_actions
    return rho


# %% upside down
# says: that is b/π, upside down
def importance_ratio(greedy, epsilon, n_actions):
    rho = 1.0
    for is_greedy in greedy[1:]:
        rho *= (1 - epsilon + epsilon / n_actions) if is_greedy else 0.0
    return rho


# %% added up
# says: the ratios of the single actions are multiplied, not added
def importance_ratio(greedy, epsilon, n_actions):
    return sum(1 / (1 - epsilon + epsilon / n_actions) for is_greedy in greedy[1:] if is_greedy)


# %% the mean
# says: the ratios of the single actions are multiplied; that is their mean
def importance_ratio(greedy, epsilon, n_actions):
    return np.mean([1 / (1 - epsilon + epsilon / n_actions) if g else 0.0 for g in greedy[1:]] or [0.0])


# %% all or nothing
# says: π takes a greedy action with probability 1, but b does not: divide by the probability under b
def importance_ratio(greedy, epsilon, n_actions):
    return 1.0 if all(greedy[1:]) else 0.0


# %% the probability under b
# says: that is the probability of these actions under b; the ratio is π divided by b
def importance_ratio(greedy, epsilon, n_actions):
    p = 1.0
    for is_greedy in greedy[1:]:
        p *= 1 - epsilon + epsilon / n_actions if is_greedy else epsilon / n_actions
    return p


# %% set, not multiplied
# says: that is the ratio of one action alone: multiply all of them (is the `return` inside the loop?)
def importance_ratio(greedy, epsilon, n_actions):
    rho = 1.0
    for is_greedy in greedy[1:]:
        rho = 1 / (1 - epsilon + epsilon / n_actions) if is_greedy else 0.0
    return rho


# %% an array
# says: gives several numbers: the ratio is their product, as of np.prod(...)
def importance_ratio(greedy, epsilon, n_actions):
    return np.array(greedy[1:]) / (1 - epsilon + epsilon / n_actions)


# %% the list is used up
# says: changes its list `greedy`; make a new one, for the caller still needs the old one
def importance_ratio(greedy, epsilon, n_actions):
    greedy.pop(0)
    return (1 - epsilon + epsilon / n_actions) ** -len(greedy) if all(greedy) else 0.0


# %% two parameters
# says: its parameters are not those of the exercise
def importance_ratio(greedy, epsilon):
    return 1 / (1 - epsilon) ** len(greedy[1:])


# %% 0 where nothing is left
# says: with one action no factor is left, and an empty product is 1
def importance_ratio(greedy, epsilon, n_actions):
    if len(greedy) == 1:
        return 0.0
    return np.prod([is_greedy / (1 - epsilon + epsilon / n_actions) for is_greedy in greedy[1:]])


# %% ε times N
# says: ε is divided by N, not multiplied: b takes the best action with probability 1 − ε + ε/N
def importance_ratio(greedy, epsilon, n_actions):
    b = 1 - epsilon + epsilon * n_actions
    return math.prod(1 / b if best else 0.0 for best in greedy[1:])


# %% b where π is 0
# says: at an action that is not greedy the ratio is 0/b = 0, not b itself
def importance_ratio(greedy, epsilon, n_actions):
    b, other = 1 - epsilon + epsilon / n_actions, epsilon / n_actions
    return math.prod(1 / b if best else other for best in greedy[1:])


# %% it returns in the loop
# says: that is the ratio of the first action alone: multiply all of them (is the `return` inside the loop?)
def importance_ratio(greedy, epsilon, n_actions):
    rho = 1.0
    for best in greedy[1:]:
        rho *= best / (1 - epsilon + epsilon / n_actions)
        return rho
    return rho


# %% the number of greedy actions less one
# says: the number of greedy actions less one is that of the later ones only if A_t was greedy too; count in greedy[1:]
def importance_ratio(greedy, epsilon, n_actions):
    if False in greedy[1:]:
        return 0.0
    return (1 / (1 - epsilon + epsilon / n_actions)) ** (sum(greedy) - 1)


# %% N typed in
# says: an N of 5 is written in; use `n_actions`
def importance_ratio(greedy, epsilon, n_actions):
    ratio = 1.0
    for is_greedy in greedy[1:]:
        ratio *= 1 / (1 - epsilon + epsilon / 5) if is_greedy else 0.0
    return ratio


# %% the number of greedy actions less one, whatever the others
# says: the number of greedy actions less one counts A_t, and at an action that is not greedy the ratio is 0
def importance_ratio(greedy, epsilon, n_actions):
    return (1 / (1 - epsilon + epsilon / n_actions)) ** (sum(greedy) - 1)


# %% epsilon typed in
# says: an ε of 0.1 is written in; use `epsilon`
def importance_ratio(greedy, epsilon, n_actions):
    ratio = 1.0
    for is_greedy in greedy[1:]:
        ratio *= 1 / (1 - 0.1 + 0.1 / n_actions) if is_greedy else 0.0
    return ratio


# %% 0.92
# says: 0.92 is written in, for an ε of 0.1 and an N of 5; compute it from `epsilon` and `n_actions`
def importance_ratio(greedy, epsilon, n_actions):
    return 0.92 ** -len(greedy[1:]) if all(greedy[1:]) else 0.0


# %% by chance
# says: b takes the best action with probability 1 − ε + ε/N; ε/N is the part of it that comes by chance
def importance_ratio(greedy, epsilon, n_actions):
    rho = 1.0
    for is_greedy in greedy[1:]:
        rho *= is_greedy / (epsilon / n_actions) if epsilon else np.inf
    return rho


# %% no parentheses
# says: `x / 1 - ε + ε/N` is (x / 1) − ε + ε/N: put what you divide by into parentheses
def importance_ratio(greedy, epsilon, n_actions):
    rho = 1.0
    for is_greedy in greedy[1:]:
        rho *= is_greedy / 1 - epsilon + epsilon / n_actions
    return rho


# %% any
# says: `any` is too weak: one later action that is not greedy is enough to make the ratio 0
def importance_ratio(greedy, epsilon, n_actions):
    return (1 - epsilon + epsilon / n_actions) ** -len(greedy[1:]) if len(greedy) == 1 or any(greedy[1:]) else 0.0


# %% True is exploring
# says: it is 0 where the actions are greedy, and not where one of them is not: True means greedy
def importance_ratio(greedy, epsilon, n_actions):
    rho = 1.0
    for explores in greedy[1:]:
        rho *= (not explores) / (1 - epsilon + epsilon / n_actions)
    return rho


# %% one factor
# says: that is one factor where all later actions are greedy; there are as many as actions
def importance_ratio(greedy, epsilon, n_actions):
    return 1 / (1 - epsilon + epsilon / n_actions) if all(greedy[1:]) else 0.0


# %% it starts at 0
# says: it stays 0: a product starts at 1
def importance_ratio(greedy, epsilon, n_actions):
    rho = 0.0
    for is_greedy in greedy[1:]:
        rho *= is_greedy / (1 - epsilon + epsilon / n_actions)
    return rho


# %% all ratios
# says: gives several numbers: the ratio is their product, as of np.prod(...)
def importance_ratio(greedy, epsilon, n_actions):
    return [is_greedy / (1 - epsilon + epsilon / n_actions) for is_greedy in greedy[1:]]


# %% all but the last
# says: the last action is left out in place of the first, A_t: the later actions are greedy[1:]
def importance_ratio(greedy, epsilon, n_actions):
    earlier = greedy[:-1]
    return (1 - epsilon + epsilon / n_actions) ** -len(earlier) if all(earlier) else 0.0


# %% b divided by π, and so by 0
# says: that is b/π, upside down
def importance_ratio(greedy, epsilon, n_actions):
    rho = 1.0
    for is_greedy in greedy[1:]:
        b = 1 - epsilon + epsilon / n_actions if is_greedy else epsilon / n_actions
        rho *= b / (1 if is_greedy else 0)
    return rho


# %% any of an empty list
# says: `any` is too weak, and False for an empty list: the ratio is 0 if one later action is not greedy, and 1 if there
#   are none
def importance_ratio(greedy, epsilon, n_actions):
    return (1 - epsilon + epsilon / n_actions) ** -len(greedy[1:]) if any(greedy[1:]) else 0.0


# %% looks for an exploring action among the first ten only
# says: False, True], 0.3, 5) should be 0, but is
# says: it is right in 11 of 12 cases: what is special in this one?
def importance_ratio(greedy, epsilon, n_actions):
    if not all(greedy[1:11]):
        return 0.0
    return (1 - epsilon + epsilon / n_actions) ** (1 - len(greedy))


# %% multiplies ten factors at most
# says: ], 0.3, 5) should be 35.43, but is 15.55
def importance_ratio(greedy, epsilon, n_actions):
    return math.prod(float(is_greedy) / (1 - epsilon + epsilon / n_actions) for is_greedy in greedy[1:11])


# %% A_t is asked too
# says: A_t is not in the product, so it does not matter whether it was greedy; ask the later ones only, greedy[1:]
def importance_ratio(greedy, epsilon, n_actions):
    return (1 - epsilon + epsilon / n_actions) ** -(len(greedy) - 1) if all(greedy) else 0.0


# %% greedy or not
# says: the ratio has as many factors as later actions, whether they are greedy or not; with one that is not, it is 0
def importance_ratio(greedy, epsilon, n_actions):
    return (1 - epsilon + epsilon / n_actions) ** -(len(greedy) - 1)


# %% the last one alone
# says: only the last action is asked; the ratio is 0 if *any* later action is not greedy
def importance_ratio(greedy, epsilon, n_actions):
    if not greedy[-1]:
        return 0.0
    return (1 - epsilon + epsilon / n_actions) ** -(len(greedy) - 1)


# %% both policies explore
# says: π is greedy: it takes the best action with probability 1 and the others with 0, not 1 − ε and ε
def importance_ratio(greedy, epsilon, n_actions):
    rho = 1.0
    for is_greedy in greedy[1:]:
        rho *= (1 - epsilon if is_greedy else epsilon) / (1 - epsilon + epsilon / n_actions)
    return rho


# %% minus ε/N
# says: the sign is wrong: b takes the best action with probability 1 − ε *+* ε/N
def importance_ratio(greedy, epsilon, n_actions):
    b = 1 - epsilon - epsilon / n_actions
    return b ** -(len(greedy) - 1) if all(greedy[1:]) else 0.0


# %% the next one alone
# says: only the next action is asked; the ratio is 0 if *any* later action is not greedy
def importance_ratio(greedy, epsilon, n_actions):
    if len(greedy) > 1 and not greedy[1]:
        return 0.0
    return (1 - epsilon + epsilon / n_actions) ** -(len(greedy) - 1)


# %% one factor too few
# says: one factor is missing: there are as many as later actions, len(greedy) − 1
def importance_ratio(greedy, epsilon, n_actions):
    return (1 - epsilon + epsilon / n_actions) ** -(len(greedy) - 2) if all(greedy[1:]) else 0.0


# %% numbers in place of entries
# says: the *number* of the action stands in the product; whether it was greedy is greedy[k]
def importance_ratio(greedy, epsilon, n_actions):
    rho = 1.0
    for k in range(1, len(greedy)):
        rho *= k / (1 - epsilon + epsilon / n_actions)
    return rho
