# %% nothing is imagined
# says: nothing is planned: are the imagined steps learned from, and enough of them?
def my_program(environment, n_steps, seed):
    n_states, n_actions = environment.observation_space.n, environment.action_space.n
    Q = np.zeros((n_states, n_actions))
    R, S2, ends = np.zeros((n_states, n_actions)), np.zeros((n_states, n_actions), int), np.zeros((n_states, n_actions))
    tried, rng = [], np.random.default_rng(seed)
    s, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        if rng.random() < 0.1:
            a = rng.integers(n_actions)
        else:
            a = rng.choice(np.flatnonzero(Q[s] == Q[s].max()))
        s2, r, terminated, truncated, _ = environment.step(a)
        Q[s, a] = r + 0.95 * (1 - terminated) * Q[s2].max()
        R[s, a], S2[s, a], ends[s, a] = r, s2, terminated
        tried.append((s, a))
        for _ in range(0):
            i, j = tried[rng.integers(len(tried))]
            Q[i, j] = R[i, j] + 0.95 * (1 - ends[i, j]) * Q[S2[i, j]].max()
        s = s2
        if terminated or truncated:
            s, _ = environment.reset()
    return lambda s: int(Q[s].argmax())


# %% pairs that nobody tried
# says: pairs are imagined that were never tried: the model knows nothing of them
def my_program(environment, n_steps, seed):
    n_states, n_actions = environment.observation_space.n, environment.action_space.n
    Q = np.zeros((n_states, n_actions))
    R, S2, ends = np.zeros((n_states, n_actions)), np.zeros((n_states, n_actions), int), np.zeros((n_states, n_actions))
    tried, rng = [], np.random.default_rng(seed)
    s, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        if rng.random() < 0.1:
            a = rng.integers(n_actions)
        else:
            a = rng.choice(np.flatnonzero(Q[s] == Q[s].max()))
        s2, r, terminated, truncated, _ = environment.step(a)
        Q[s, a] = r + 0.95 * (1 - terminated) * Q[s2].max()
        R[s, a], S2[s, a], ends[s, a] = r, s2, terminated
        tried.append((s, a))
        for _ in range(10):
            i, j = rng.integers(n_states), rng.integers(n_actions)
            Q[i, j] = R[i, j] + 0.95 * (1 - ends[i, j]) * Q[S2[i, j]].max()
        s = s2
        if terminated or truncated:
            s, _ = environment.reset()
    return lambda s: int(Q[s].argmax())


# %% rewards alone
# says: γ max_a Q(S', a) is missing in the target
def my_program(environment, n_steps, seed):
    n_states, n_actions = environment.observation_space.n, environment.action_space.n
    Q = np.zeros((n_states, n_actions))
    R, S2, ends = np.zeros((n_states, n_actions)), np.zeros((n_states, n_actions), int), np.zeros((n_states, n_actions))
    tried, rng = [], np.random.default_rng(seed)
    s, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        if rng.random() < 0.1:
            a = rng.integers(n_actions)
        else:
            a = rng.choice(np.flatnonzero(Q[s] == Q[s].max()))
        s2, r, terminated, truncated, _ = environment.step(a)
        Q[s, a] = r
        R[s, a], S2[s, a], ends[s, a] = r, s2, terminated
        tried.append((s, a))
        for _ in range(10):
            i, j = tried[rng.integers(len(tried))]
            Q[i, j] = R[i, j]
        s = s2
        if terminated or truncated:
            s, _ = environment.reset()
    return lambda s: int(Q[s].argmax())


# %% looks beyond the end
# says: the value of a state after the end is looked up
def my_program(environment, n_steps, seed):
    n_states, n_actions = environment.observation_space.n, environment.action_space.n
    Q = np.zeros((n_states, n_actions))
    R, S2, ends = np.zeros((n_states, n_actions)), np.zeros((n_states, n_actions), int), np.zeros((n_states, n_actions))
    tried, rng = [], np.random.default_rng(seed)
    s, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        if rng.random() < 0.1:
            a = rng.integers(n_actions)
        else:
            a = rng.choice(np.flatnonzero(Q[s] == Q[s].max()))
        s2, r, terminated, truncated, _ = environment.step(a)
        Q[s, a] = r + 0.95 * Q[s2].max()
        R[s, a], S2[s, a], ends[s, a] = r, s2, terminated
        tried.append((s, a))
        for _ in range(10):
            i, j = tried[rng.integers(len(tried))]
            Q[i, j] = R[i, j] + 0.95 * Q[S2[i, j]].max()
        s = s2
        if terminated or truncated:
            s, _ = environment.reset()
    return lambda s: int(Q[s].argmax())


# %% truncated is terminated
# says: a truncated episode is learned as a terminated one
def my_program(environment, n_steps, seed):
    n_states, n_actions = environment.observation_space.n, environment.action_space.n
    Q = np.zeros((n_states, n_actions))
    R, S2, ends = np.zeros((n_states, n_actions)), np.zeros((n_states, n_actions), int), np.zeros((n_states, n_actions))
    tried, rng = [], np.random.default_rng(seed)
    s, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        if rng.random() < 0.1:
            a = rng.integers(n_actions)
        else:
            a = rng.choice(np.flatnonzero(Q[s] == Q[s].max()))
        s2, r, terminated, truncated, _ = environment.step(a)
        terminated = terminated or truncated
        Q[s, a] = r + 0.95 * (1 - terminated) * Q[s2].max()
        R[s, a], S2[s, a], ends[s, a] = r, s2, terminated
        tried.append((s, a))
        for _ in range(10):
            i, j = tried[rng.integers(len(tried))]
            Q[i, j] = R[i, j] + 0.95 * (1 - ends[i, j]) * Q[S2[i, j]].max()
        s = s2
        if terminated or truncated:
            s, _ = environment.reset()
    return lambda s: int(Q[s].argmax())


# %% a model of states
# says: ; the model must keep reward, next state and whether the episode ended, for each state *and* action
def my_program(environment, n_steps, seed):
    n_states, n_actions = environment.observation_space.n, environment.action_space.n
    Q = np.zeros((n_states, n_actions))
    R, S2, ends = np.zeros((n_states, n_actions)), np.zeros((n_states, n_actions), int), np.zeros((n_states, n_actions))
    tried, rng = [], np.random.default_rng(seed)
    s, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        if rng.random() < 0.1:
            a = rng.integers(n_actions)
        else:
            a = rng.choice(np.flatnonzero(Q[s] == Q[s].max()))
        s2, r, terminated, truncated, _ = environment.step(a)
        Q[s, a] = r + 0.95 * (1 - terminated) * Q[s2].max()
        R[s], S2[s], ends[s] = r, s2, terminated
        tried.append((s, a))
        for _ in range(10):
            i, j = tried[rng.integers(len(tried))]
            Q[i, j] = R[i, j] + 0.95 * (1 - ends[i, j]) * Q[S2[i, j]].max()
        s = s2
        if terminated or truncated:
            s, _ = environment.reset()
    return lambda s: int(Q[s].argmax())


# %% the old state after a reset
# says: after an end the program goes on from the last state of the old episode: state, info = environment.reset() gives the first state of the new one
def my_program(environment, n_steps, seed):
    n_states, n_actions = environment.observation_space.n, environment.action_space.n
    Q = np.zeros((n_states, n_actions))
    R, S2, ends = np.zeros((n_states, n_actions)), np.zeros((n_states, n_actions), int), np.zeros((n_states, n_actions))
    tried, rng = [], np.random.default_rng(seed)
    s, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        if rng.random() < 0.1:
            a = rng.integers(n_actions)
        else:
            a = rng.choice(np.flatnonzero(Q[s] == Q[s].max()))
        s2, r, terminated, truncated, _ = environment.step(a)
        Q[s, a] = r + 0.95 * (1 - terminated) * Q[s2].max()
        R[s, a], S2[s, a], ends[s, a] = r, s2, terminated
        tried.append((s, a))
        for _ in range(10):
            i, j = tried[rng.integers(len(tried))]
            Q[i, j] = R[i, j] + 0.95 * (1 - ends[i, j]) * Q[S2[i, j]].max()
        s = s2
        if terminated or truncated:
            environment.reset()
    return lambda s: int(Q[s].argmax())


# %% costs
# says: The likely cause: low values are preferred to high ones: is there an `argmin`, or a minus sign too many?
def my_program(environment, n_steps, seed):
    n_states, n_actions = environment.observation_space.n, environment.action_space.n
    Q = np.zeros((n_states, n_actions))
    R, S2, ends = np.zeros((n_states, n_actions)), np.zeros((n_states, n_actions), int), np.zeros((n_states, n_actions))
    tried, rng = [], np.random.default_rng(seed)
    s, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        if rng.random() < 0.1:
            a = rng.integers(n_actions)
        else:
            a = rng.choice(np.flatnonzero(Q[s] == Q[s].min()))
        s2, r, terminated, truncated, _ = environment.step(a)
        Q[s, a] = r + 0.95 * (1 - terminated) * Q[s2].max()
        R[s, a], S2[s, a], ends[s, a] = r, s2, terminated
        tried.append((s, a))
        for _ in range(10):
            i, j = tried[rng.integers(len(tried))]
            Q[i, j] = R[i, j] + 0.95 * (1 - ends[i, j]) * Q[S2[i, j]].max()
        s = s2
        if terminated or truncated:
            s, _ = environment.reset()
    return lambda s: int(Q[s].argmax())
