# %% with lists
# slow
def my_program(environment, n_steps, seed):
    rng = np.random.default_rng(seed)
    n = int(environment.action_space.n)
    means, pulls = [0.0] * n, [0] * n

    def best():
        top = max(means)
        return int(rng.choice([a for a in range(n) if means[a] == top]))

    taken, over = 0, True
    while taken < n_steps or not over:
        if over:
            environment.reset(seed=seed if taken == 0 else None)
        arm = int(rng.integers(n)) if rng.random() < 0.1 else best()
        _, reward, terminated, truncated, _ = environment.step(arm)
        pulls[arm] += 1
        means[arm] = (means[arm] * (pulls[arm] - 1) + reward) / pulls[arm]
        over, taken = terminated or truncated, taken + 1
    return lambda state: int(np.argmax(means))


# %% sums of rewards
# slow
def my_program(environment, n_steps, seed):
    rng = np.random.default_rng(seed)
    n = environment.action_space.n
    total, N = np.zeros(n), np.zeros(n)
    environment.reset(seed=seed)
    for t in range(n_steps):
        Q = total / np.maximum(N, 1)
        arm = rng.choice(np.flatnonzero(Q == Q.max()))
        if rng.random() < 0.1:
            arm = rng.integers(n)
        _, reward, terminated, truncated, _ = environment.step(int(arm))
        total[arm] += reward
        N[arm] += 1
        if terminated or truncated:
            environment.reset()
    return lambda state: (total / np.maximum(N, 1)).argmax()


# %% a probability for each arm
# slow
def my_program(environment, n_steps, seed):
    rng = np.random.default_rng(seed)
    n = int(environment.action_space.n)
    arms, Q, N = np.arange(n), np.zeros(n, np.float32), np.zeros(n, int)
    environment.reset(seed=seed)
    for t in range(n_steps):
        looks_best = np.flatnonzero(Q == Q.max())
        if rng.random() < 0.1:
            looks_best = arms
        arm = int(rng.choice(n, p=np.isin(arms, looks_best) / len(looks_best)))
        _, reward, terminated, truncated, _ = environment.step(arm)
        N[arm] += 1
        Q[arm] += (reward - Q[arm]) / N[arm]
        if terminated or truncated:
            environment.reset()
    return lambda state: np.argmax(Q)
