# %% no return
# slow
# says: is a `return` missing?
# says: switch(model) for W =
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    for epsilon in np.arange(0.0, 0.2, 0.001):
        policy = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        if policy_evaluation(model, policy, horizon=50).start < fastest:
            break


# %% the number of the lesson
# slow
# says: that is the ε of the lesson's road; compute it from the `model` that is given
# says: and negative_reward =
def switch(model):
    return 0.032


# %% a number, not a function
# says: should be a function of the model
switch = 0.032


# %% the ε-soft return
# slow
# says: that is the first ε above 0 of a search: compare the *return* of the greedy policy, played *without* slips,
#   since the ε-soft return is always lower, and two policies may differ where no run leads
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    for epsilon in np.arange(0.0, 0.2, 0.001):
        if value_iteration(model, epsilon=epsilon, horizon=50).start < fastest:
            return epsilon


# %% the ε-soft return of one step more
# slow
# says: that is where the ε-soft return falls below that of a run with one step more; the slips lower both
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    for epsilon in np.arange(0.0, 0.2, 0.0001):
        if value_iteration(model, epsilon=epsilon, horizon=50).start < fastest - 1:
            return epsilon


# %% too coarse
# slow
# says: that is close: does the search begin at 0, and go in steps of 0.001 or smaller, and is nothing rounded or
#   discounted?
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    for epsilon in np.arange(0.0, 0.2, 0.01):
        policy = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        if policy_evaluation(model, policy, horizon=50).start < fastest:
            return epsilon


# %% in percent
# slow
# says: that is in percent
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    for epsilon in np.arange(0.0, 0.2, 0.0001):
        policy = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        if policy_evaluation(model, policy, horizon=50).start < fastest:
            return 100 * epsilon


# %% the comparison the wrong way round
# slow
# says: the search ends at its first ε: is the return of the fastest run that of *this* `model`, and is it compared,
#   with `<`, with the greedy policy for ε, played *without* slips?
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    for epsilon in np.arange(0.0, 0.2, 0.001):
        policy = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        if policy_evaluation(model, policy, horizon=50).start >= fastest:
            return epsilon


# %% never found
# slow
# says: that is the end of the search: the change was never found; is the comparison the right way round, and is
#   `horizon` 50?
# in: the solution of switch
# - if policy_evaluation(model, policy, horizon=50).start < fastest:
# + if policy_evaluation(model, policy, horizon=50).start > fastest:


# %% the estimate
# slow
# says: that is the estimate, 3 divided by the cost of a fall, not the exact value: plan on the model
def switch(model):
    return 3 / abs(model.mdp.negative_reward)


# %% no parameter
# says: its parameters are not those of the exercise
def switch():
    return 0.032


# %% the reciprocal
# slow
# says: that is 1/ε
def switch(model):
    return 1 / exact.switch(model, tolerance=1e-7)


# %% the other probability
# slow
# says: that is 1 − ε
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    epsilon = 0.0
    while epsilon < 0.2:
        epsilon += 0.001
        policy = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        if policy_evaluation(model, policy, horizon=50).start < fastest:
            return 1 - epsilon
    return 0.2


# %% below 0
# slow
# says: the sign is wrong
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    epsilon = 0.0
    while epsilon < 0.2:
        epsilon += 0.001
        policy = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        if policy_evaluation(model, policy, horizon=50).start < fastest:
            return -epsilon
    return 0.2


# %% half of it
# slow
# says: that is none of the usual mistakes, so print the number of steps of the best run for some ε
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    epsilon = 0.0
    while epsilon < 0.2:
        epsilon += 0.001
        policy = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        if policy_evaluation(model, policy, horizon=50).start < fastest:
            return epsilon / 2
    return 0.2


# %% the ε-soft return in steps of 0.01
# slow
# says: that is the first ε of a search in steps of 0.01: compare the greedy policy, played *without* slips, and not the
#   ε-soft return
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    for epsilon in np.arange(0.01, 0.2, 0.01):
        if value_iteration(model, epsilon=epsilon, horizon=50).start < fastest:
            return epsilon


# %% up to 1, the wrong way round
# slow
# says: that is the end of the search; is the comparison the right way round?
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    for epsilon in np.linspace(0.0, 1.0, 101):
        policy = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        if policy_evaluation(model, policy, horizon=50).start > fastest:
            break
    return epsilon


# %% the estimate of the lesson
# slow
# says: that is the estimate for the lesson's road; compute the exact value from the `model` that is given
def switch(model):
    return 0.03


# %% in percent, by a search
# slow
# says: that is in percent
def switch(model):
    fastest = policy_evaluation(model, value_iteration(model, horizon=50).greedy_policy(), horizon=50).start
    for k in range(200):
        policy = value_iteration(model, epsilon=k / 1000, horizon=50).greedy_policy()
        if policy_evaluation(model, policy, horizon=50).start < fastest:
            return k / 10


# %% the number of the step
# slow
# says: that is 1 000 times ε: is it the number of the step, and not the ε of that step?
def switch(model):
    fastest = policy_evaluation(model, value_iteration(model, horizon=50).greedy_policy(), horizon=50).start
    for k, epsilon in enumerate(np.arange(0, 0.2, 0.001)):
        policy = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        if policy_evaluation(model, policy, horizon=50).start < fastest:
            return k


# %% the first one with the run that is safe at 0.1, which is the fast one on a mild road
# slow
# says: , but is 0: that is none of the usual mistakes
def switch(model):
    safe = policy_evaluation(model, value_iteration(model, epsilon=0.1, horizon=50).greedy_policy(), horizon=50).start
    for epsilon in np.arange(0, 0.2, 0.001):
        policy = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        if policy_evaluation(model, policy, horizon=50).start == safe:
            return epsilon


# %% not called
# says: an array of numbers is needed there: is a call such as `.greedy_policy()` missing?
def switch(model):
    return policy_evaluation(model, value_iteration(model, horizon=50).greedy_policy, horizon=50).start


# %% a search that begins too late
# slow
# says: switch(model) for W = 15 and negative_reward = -137 should be 0.0224, but is 0.03: that is close: does the search
#   begin at 0, and go in steps of 0.001 or smaller, and is nothing rounded or discounted?
def switch(model):
    fastest = policy_evaluation(model, value_iteration(model, horizon=50).greedy_policy(), horizon=50).start
    for epsilon in np.arange(0.03, 0.2, 0.001):
        policy = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        if policy_evaluation(model, policy, horizon=50).start < fastest:
            return epsilon


# %% rounded to two digits, and on the first road the estimate
# slow
# says: that is close: does the search begin at 0, and go in steps of 0.001 or smaller, and is nothing rounded or
#   discounted?
def switch(model):
    return round(exact.switch(model), 2)


# %% a horizon of five steps
# slow
# says: and negative_reward = -1
# says: that is the end of the search: the change was never found; is the comparison the right way round, and is `horizon` 50?
def switch(model):
    fastest = value_iteration(model, horizon=5).start
    for epsilon in np.arange(0.0, 0.2, 0.001):
        policy = value_iteration(model, epsilon=epsilon, horizon=5).greedy_policy()
        if policy_evaluation(model, policy, horizon=5).start < fastest:
            return epsilon
    return 0.2


# %% the lowest of all returns
# slow
# says: that is where the *slowest* run begins, with the lowest of all returns; the best run may change more than once, and
#   its first change is asked for
def switch(model):
    epsilons = np.arange(0.0, 0.2, 0.001)
    policies = [value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy() for epsilon in epsilons]
    return epsilons[np.argmin([policy_evaluation(model, policy, horizon=50).start for policy in policies])]


# %% the last change
# slow
# says: that is where the *slowest* run begins
def switch(model):
    last, before = 0.0, value_iteration(model, horizon=50).start
    for epsilon in np.arange(0.0, 0.2, 0.001):
        policy = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        now = policy_evaluation(model, policy, horizon=50).start
        if now < before:
            last, before = epsilon, now
    return last


# %% the return of the lesson's fastest run
# slow
# says: it is right for the first road of the check only, which is as long as that of the lesson: is the return of its
#   fastest run, −2, written in?
def switch(model):
    for epsilon in np.arange(0.0, 0.2, 0.001):
        policy = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        if policy_evaluation(model, policy, horizon=50).start < -2.001:
            return epsilon


# %% the return in place of its ε
# slow
# says: that is the return of the best run at the ε that is asked for; return this ε
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    for epsilon in np.arange(0.0, 0.2, 0.001):
        policy = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        found = policy_evaluation(model, policy, horizon=50).start
        if found < fastest - 1e-6:
            return found


# %% next finds nothing
# says: StopIteration: next(...) finds nothing: no value passes its test
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    return next(
        epsilon
        for epsilon in np.arange(0.0, 0.02, 0.001)
        if policy_evaluation(model, value_iteration(model, epsilon=epsilon).greedy_policy()).start < fastest - 1e-6
    )


# %% halves on the wrong side
# slow
# says: that is the end of the search: the change was never found; is the comparison the right way round, and is `horizon` 50?
def switch(model):
    def played(epsilon):
        plan = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        return policy_evaluation(model, plan, horizon=50).start

    low, high = 0.0, 0.2
    while high - low > 1e-4:
        middle = (low + high) / 2
        low, high = (middle, high) if played(middle) < played(0.0) else (low, middle)
    return high


# %% only the slips that are no best action
# slow
# says: that is none of the usual mistakes, so print the number of steps of the best run for some ε
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    for epsilon in np.arange(0.0, 0.2, 0.001):
        policy = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        if policy_evaluation(model, policy, horizon=50).start < fastest:
            return epsilon * 2 / 3
    return 0.2
