# %% Q-learning
# says: the target has max_a Q(S', a), the value of the *best* next action: that is Q-learning
def choose(values, rng, epsilon=0.1):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return values.argmax()


def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    s, _ = environment.reset(seed=seed)
    a = choose(Q[s], rng)
    for _ in range(n_steps):
        s2, r, terminated, truncated, _ = environment.step(a)
        a2 = choose(Q[s2], rng)
        target = r if terminated else r + Q[s2].max()
        Q[s, a] += 0.5 * (target - Q[s, a])
        if terminated or truncated:
            s2, _ = environment.reset()
            a2 = choose(Q[s2], rng)
        s, a = s2, a2
    return lambda s: int(Q[s].argmax())


# %% drawn again
# says: ; look at two places: A', whose value is in the target, is the action that is taken next, and is not drawn a second time; at the end of an episode the target is the reward alone
def choose(values, rng, epsilon=0.1):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return values.argmax()


def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    s, _ = environment.reset(seed=seed)
    a = choose(Q[s], rng)
    for _ in range(n_steps):
        s2, r, terminated, truncated, _ = environment.step(a)
        a2 = choose(Q[s2], rng)
        target = r if terminated else r + Q[s2, a2]
        Q[s, a] += 0.5 * (target - Q[s, a])
        if terminated or truncated:
            s2, _ = environment.reset()
            a2 = choose(Q[s2], rng)
        s, a = s2, choose(Q[s2], rng)
    return lambda s: int(Q[s].argmax())


# %% beyond the end
# says: ; look at two places: A', whose value is in the target, is the action that is taken next, and is not drawn a second time; at the end of an episode the target is the reward alone
def choose(values, rng, epsilon=0.1):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return values.argmax()


def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    s, _ = environment.reset(seed=seed)
    a = choose(Q[s], rng)
    for _ in range(n_steps):
        s2, r, terminated, truncated, _ = environment.step(a)
        a2 = choose(Q[s2], rng)
        target = r + Q[s2, a2]
        Q[s, a] += 0.5 * (target - Q[s, a])
        if terminated or truncated:
            s2, _ = environment.reset()
            a2 = choose(Q[s2], rng)
        s, a = s2, a2
    return lambda s: int(Q[s].argmax())


# %% the reward alone
# says: Q(S', A') is missing in the target
def choose(values, rng, epsilon=0.1):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return values.argmax()


def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    s, _ = environment.reset(seed=seed)
    a = choose(Q[s], rng)
    for _ in range(n_steps):
        s2, r, terminated, truncated, _ = environment.step(a)
        a2 = choose(Q[s2], rng)
        target = r
        Q[s, a] += 0.5 * (target - Q[s, a])
        if terminated or truncated:
            s2, _ = environment.reset()
            a2 = choose(Q[s2], rng)
        s, a = s2, a2
    return lambda s: int(Q[s].argmax())


# %% slow
# says: the learning rate is much too small: it is 0.5 in the text
def choose(values, rng, epsilon=0.1):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return values.argmax()


def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    s, _ = environment.reset(seed=seed)
    a = choose(Q[s], rng)
    for _ in range(n_steps):
        s2, r, terminated, truncated, _ = environment.step(a)
        a2 = choose(Q[s2], rng)
        target = r if terminated else r + Q[s2, a2]
        Q[s, a] += 0.1 * (target - Q[s, a])
        if terminated or truncated:
            s2, _ = environment.reset()
            a2 = choose(Q[s2], rng)
        s, a = s2, a2
    return lambda s: int(Q[s].argmax())


# %% the end is not learned
# says: what is learned at the end of an episode is left out, and that is where the reward often is: learn first, and look then whether the episode is over
def choose(values, rng, epsilon=0.1):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return values.argmax()


def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    s, _ = environment.reset(seed=seed)
    a = choose(Q[s], rng)
    for _ in range(n_steps):
        s2, r, terminated, truncated, _ = environment.step(a)
        a2 = choose(Q[s2], rng)
        target = r if terminated else r + Q[s2, a2]
        if not terminated:
            Q[s, a] += 0.5 * (target - Q[s, a])
        if terminated or truncated:
            s2, _ = environment.reset()
            a2 = choose(Q[s2], rng)
        s, a = s2, a2
    return lambda s: int(Q[s].argmax())


# %% the old state after a reset
# says: after an end the program goes on from the last state of the old episode: state, info = environment.reset() gives the first state of the new one
def choose(values, rng, epsilon=0.1):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return values.argmax()


def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    s, _ = environment.reset(seed=seed)
    a = choose(Q[s], rng)
    for _ in range(n_steps):
        s2, r, terminated, truncated, _ = environment.step(a)
        a2 = choose(Q[s2], rng)
        target = r if terminated else r + Q[s2, a2]
        Q[s, a] += 0.5 * (target - Q[s, a])
        if terminated or truncated:
            environment.reset()
            a2 = choose(Q[s2], rng)
        s, a = s2, a2
    return lambda s: int(Q[s].argmax())


# %% costs
# says: low values are preferred to high ones: is there an `argmin`, or a minus sign too many?
def choose(values, rng, epsilon=0.1):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return values.argmin()


def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    s, _ = environment.reset(seed=seed)
    a = choose(Q[s], rng)
    for _ in range(n_steps):
        s2, r, terminated, truncated, _ = environment.step(a)
        a2 = choose(Q[s2], rng)
        target = r if terminated else r + Q[s2, a2]
        Q[s, a] += 0.5 * (target - Q[s, a])
        if terminated or truncated:
            s2, _ = environment.reset()
            a2 = choose(Q[s2], rng)
        s, a = s2, a2
    return lambda s: int(Q[s].argmax())


# %% seldom tries
# says: So it seldom tries an action at random
def choose(values, rng, epsilon=0.01):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return values.argmax()


def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    s, _ = environment.reset(seed=seed)
    a = choose(Q[s], rng)
    for _ in range(n_steps):
        s2, r, terminated, truncated, _ = environment.step(a)
        a2 = choose(Q[s2], rng)
        target = r if terminated else r + Q[s2, a2]
        Q[s, a] += 0.5 * (target - Q[s, a])
        if terminated or truncated:
            s2, _ = environment.reset()
            a2 = choose(Q[s2], rng)
        s, a = s2, a2
    return lambda s: int(Q[s].argmax())


# %% the same numbers in every run
# says: takes the same actions with seed
def choose(values, rng, epsilon=0.1):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return values.argmax()


def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(1)
    s, _ = environment.reset(seed=seed)
    a = choose(Q[s], rng)
    for _ in range(n_steps):
        s2, r, terminated, truncated, _ = environment.step(a)
        a2 = choose(Q[s2], rng)
        target = r if terminated else r + Q[s2, a2]
        Q[s, a] += 0.5 * (target - Q[s, a])
        if terminated or truncated:
            s2, _ = environment.reset()
            a2 = choose(Q[s2], rng)
        s, a = s2, a2
    return lambda s: int(Q[s].argmax())
