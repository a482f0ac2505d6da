# %% Q-learning
# says: all surprises weigh the same: that is Q-learning
def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    s, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        a = rng.integers(len(Q[s])) if rng.random() < 0.1 else Q[s].argmax()
        s2, r, over, cut, _ = environment.step(a)
        delta = r + 0.9 * (1 - over) * Q[s2].max() - Q[s, a]
        Q[s, a] += 0.4 * delta
        s = environment.reset()[0] if over or cut else s2
    return lambda s: int(Q[s].argmax())


# %% the sign
# says: good surprises weigh more than bad ones: β is below 0
def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    s, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        a = rng.integers(len(Q[s])) if rng.random() < 0.1 else Q[s].argmax()
        s2, r, over, cut, _ = environment.step(a)
        delta = r + 0.9 * (1 - over) * Q[s2].max() - Q[s, a]
        Q[s, a] += 0.4 * 2 / (1 + np.exp(-0.5 * delta)) * delta
        s = environment.reset()[0] if over or cut else s2
    return lambda s: int(Q[s].argmax())


# %% no 2
# says: the weight is half as large as it should be: 2σ(βδ) is 1 where δ = 0
def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    s, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        a = rng.integers(len(Q[s])) if rng.random() < 0.1 else Q[s].argmax()
        s2, r, over, cut, _ = environment.step(a)
        delta = r + 0.9 * (1 - over) * Q[s2].max() - Q[s, a]
        Q[s, a] += 0.4 / (1 + np.exp(0.5 * delta)) * delta
        s = environment.reset()[0] if over or cut else s2
    return lambda s: int(Q[s].argmax())


# %% the reward alone
# says: γ max_a Q(S', a) is missing in the target
def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    s, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        a = rng.integers(len(Q[s])) if rng.random() < 0.1 else Q[s].argmax()
        s2, r, over, cut, _ = environment.step(a)
        delta = r - Q[s, a]
        Q[s, a] += 0.4 * 2 / (1 + np.exp(0.5 * delta)) * delta
        s = environment.reset()[0] if over or cut else s2
    return lambda s: int(Q[s].argmax())


# %% beyond the end
# says: the value of a state after the end is looked up
def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    s, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        a = rng.integers(len(Q[s])) if rng.random() < 0.1 else Q[s].argmax()
        s2, r, over, cut, _ = environment.step(a)
        delta = r + 0.9 * Q[s2].max() - Q[s, a]
        Q[s, a] += 0.4 * 2 / (1 + np.exp(0.5 * delta)) * delta
        s = environment.reset()[0] if over or cut else s2
    return lambda s: int(Q[s].argmax())


# %% first values of 10
# says: ; the weight 2σ(βδ) = 2/(1 + exp(−βδ)) has the whole TD error δ in it
def my_program(environment, n_steps, seed):
    Q = np.full((environment.observation_space.n, environment.action_space.n), 10.0)
    rng = np.random.default_rng(seed)
    s, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        a = rng.integers(len(Q[s])) if rng.random() < 0.1 else Q[s].argmax()
        s2, r, over, cut, _ = environment.step(a)
        delta = r + 0.9 * (1 - over) * Q[s2].max() - Q[s, a]
        Q[s, a] += 0.4 * 2 / (1 + np.exp(0.5 * delta)) * delta
        s = environment.reset()[0] if over or cut else s2
    return lambda s: int(Q[s].argmax())


# %% the worst at the fork
# says: a sure payment of 1, or a coin that pays 5 or -2: with β = -0.5 the sure payment is worth more, but the policy takes it in
# says:  runs only; does it take the best action?
def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    s, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        a = rng.integers(len(Q[s])) if rng.random() < 0.1 else Q[s].argmax()
        s2, r, over, cut, _ = environment.step(a)
        delta = r + 0.9 * (1 - over) * Q[s2].max() - Q[s, a]
        Q[s, a] += 0.4 * 2 / (1 + np.exp(0.5 * delta)) * delta
        s = environment.reset()[0] if over or cut else s2
    return lambda s: int(Q[s].argmin())


# %% no brackets
# says: They fit a usual mistake:
# says: − Q(S, A) is missing at the end of an episode: put brackets around `... if terminated else ...`
def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    s, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        a = rng.integers(len(Q[s])) if rng.random() < 0.1 else Q[s].argmax()
        s2, r, over, cut, _ = environment.step(a)
        delta = r if over else r + 0.9 * Q[s2].max() - Q[s, a]
        Q[s, a] += 0.4 * 2 / (1 + np.exp(0.5 * delta)) * delta
        s = environment.reset()[0] if over or cut else s2
    return lambda s: int(Q[s].argmax())


# %% a smaller α
# says: α is 0.1, or some other number far below 0.4
def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    s, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        a = rng.integers(len(Q[s])) if rng.random() < 0.1 else Q[s].argmax()
        s2, r, over, cut, _ = environment.step(a)
        delta = r + 0.9 * (1 - over) * Q[s2].max() - Q[s, a]
        Q[s, a] += 0.1 * 2 / (1 + np.exp(0.5 * delta)) * delta
        s = environment.reset()[0] if over or cut else s2
    return lambda s: int(Q[s].argmax())
