# %% by bisection
# slow
# says: Right: planning on the model finds at once what expected SARSA needs thousands of steps for. (It is close to 3
#   divided by the cost of a fall where one step more avoids the one deadly action.)
def switch(model):
    fastest = value_iteration(model, horizon=50).start
    low, high = 0.0, 0.2
    while high - low > 1e-4:
        middle = (low + high) / 2
        policy = value_iteration(model, epsilon=middle, horizon=50).greedy_policy()
        if policy_evaluation(model, policy, horizon=50).start < fastest:
            high = middle
        else:
            low = middle
    return high


# %% by playing the run
# slow
def switch(model):
    def steps(epsilon):
        policy = value_iteration(model, epsilon=epsilon, horizon=50).greedy_policy()
        state, n = (0, 0), 0
        while not model.terminal[model.row(state)]:
            action = int(policy[model.row(state)].argmax())
            state, n = model.outcomes(state, action)[0].next_state, n + 1
        return n

    return next(e for e in np.arange(0, 0.2, 0.001) if steps(e) > steps(0.0))


# %% which of two policies is better
# slow
def switch(model):
    fast = value_iteration(model, epsilon=1e-6, horizon=50).greedy_policy()
    fastest = policy_evaluation(model, fast, horizon=50).start
    for epsilon in np.arange(0.0, 0.2, 0.0005):
        best = value_iteration(model, epsilon=epsilon, horizon=50)
        if policy_evaluation(model, best.greedy_policy(), horizon=50).start < fastest - 1e-9:
            return float(epsilon)
