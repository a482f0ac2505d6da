# %% two tables and a dictionary of names
# slow
def my_program(environment, n_steps, seed):
    rng = np.random.default_rng(seed)
    shape = environment.observation_space.n, environment.action_space.n
    Q1, Q2 = np.zeros(shape), np.zeros(shape)
    state, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        total = Q1[state] + Q2[state]
        if rng.random() < 0.1:
            action = int(rng.integers(shape[1]))
        else:
            action = int(rng.choice(np.flatnonzero(total == total.max())))
        after, reward, terminated, truncated, _ = environment.step(action)
        own, other = (Q1, Q2) if rng.random() < 0.5 else (Q2, Q1)
        target = reward
        if not terminated:
            target += other[after, own[after].argmax()]
        own[state, action] += 0.1 * (target - own[state, action])
        state = after
        if terminated or truncated:
            state, _ = environment.reset()
    return lambda state: int((Q1 + Q2)[state].argmax())


# %% with lists
# slow
def my_program(environment, n_steps, seed):
    rng = np.random.default_rng(seed)
    n_states, n_actions = int(environment.observation_space.n), int(environment.action_space.n)
    tables = [[[0.0] * n_actions for _ in range(n_states)] for _ in range(2)]

    def best(values):
        top = max(values)
        return int(rng.choice([a for a, value in enumerate(values) if value == top]))

    def both(state):
        return [x + y for x, y in zip(tables[0][state], tables[1][state])]

    taken, over = 0, True
    while taken < n_steps or not over:
        if over:
            state, _ = environment.reset(seed=seed if taken == 0 else None)
        action = int(rng.integers(n_actions)) if rng.random() < 0.1 else best(both(state))
        after, reward, terminated, truncated, _ = environment.step(action)
        i = int(rng.integers(2))
        future = 0.0 if terminated else tables[1 - i][after][best(tables[i][after])]
        tables[i][state][action] += 0.1 * (reward + future - tables[i][state][action])
        state, over, taken = after, terminated or truncated, taken + 1
    return lambda state: best(both(state))


# %% the mean over ties, as ours
# slow
# in: two tables and a dictionary of names
# - target += other[after, own[after].argmax()]
# + target += other[after][own[after] == own[after].max()].mean()
