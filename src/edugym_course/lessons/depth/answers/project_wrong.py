# %% one reward
# says: the target has one reward only: that is SARSA
def choose(values, rng, epsilon=0.1):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return values.argmax()


def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    n = 1
    t, s = 0, environment.reset(seed=seed)[0]
    while t < n_steps:
        S, A, R, over = [s], [choose(Q[s], rng)], [], False
        while not over:
            s, r, over, truncated, _ = environment.step(A[-1])
            t += 1
            S.append(s)
            A.append(choose(Q[s], rng))
            R.append(r)
            for tau in range(len(R)) if over else [len(R) - n]:
                if tau < 0 or (over and tau < len(R) - n):
                    continue
                G = sum(0.99**k * r for k, r in enumerate(R[tau : tau + n]))
                if not over:
                    G += 0.99**n * Q[S[tau + n], A[tau + n]]
                Q[S[tau], A[tau]] += 0.5 * (G - Q[S[tau], A[tau]])
        s, _ = environment.reset()
    return lambda s: int(Q[s].argmax())


# %% two rewards
# says: the target has two rewards, and it should have three
def choose(values, rng, epsilon=0.1):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return values.argmax()


def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    n = 2
    t, s = 0, environment.reset(seed=seed)[0]
    while t < n_steps:
        S, A, R, over = [s], [choose(Q[s], rng)], [], False
        while not over:
            s, r, over, truncated, _ = environment.step(A[-1])
            t += 1
            S.append(s)
            A.append(choose(Q[s], rng))
            R.append(r)
            for tau in range(len(R)) if over else [len(R) - n]:
                if tau < 0 or (over and tau < len(R) - n):
                    continue
                G = sum(0.99**k * r for k, r in enumerate(R[tau : tau + n]))
                if not over:
                    G += 0.99**n * Q[S[tau + n], A[tau + n]]
                Q[S[tau], A[tau]] += 0.5 * (G - Q[S[tau], A[tau]])
        s, _ = environment.reset()
    return lambda s: int(Q[s].argmax())


# %% four rewards
# says: the target has four rewards, and it should have three
def choose(values, rng, epsilon=0.1):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return values.argmax()


def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    n = 4
    t, s = 0, environment.reset(seed=seed)[0]
    while t < n_steps:
        S, A, R, over = [s], [choose(Q[s], rng)], [], False
        while not over:
            s, r, over, truncated, _ = environment.step(A[-1])
            t += 1
            S.append(s)
            A.append(choose(Q[s], rng))
            R.append(r)
            for tau in range(len(R)) if over else [len(R) - n]:
                if tau < 0 or (over and tau < len(R) - n):
                    continue
                G = sum(0.99**k * r for k, r in enumerate(R[tau : tau + n]))
                if not over:
                    G += 0.99**n * Q[S[tau + n], A[tau + n]]
                Q[S[tau], A[tau]] += 0.5 * (G - Q[S[tau], A[tau]])
        s, _ = environment.reset()
    return lambda s: int(Q[s].argmax())


# %% Monte Carlo
# says: the target has all rewards to the end of the episode: that is Monte Carlo
def choose(values, rng, epsilon=0.1):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return values.argmax()


def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    n = 1000
    t, s = 0, environment.reset(seed=seed)[0]
    while t < n_steps:
        S, A, R, over = [s], [choose(Q[s], rng)], [], False
        while not over:
            s, r, over, truncated, _ = environment.step(A[-1])
            t += 1
            S.append(s)
            A.append(choose(Q[s], rng))
            R.append(r)
            for tau in range(len(R)) if over else [len(R) - n]:
                if tau < 0 or (over and tau < len(R) - n):
                    continue
                G = sum(0.99**k * r for k, r in enumerate(R[tau : tau + n]))
                if not over:
                    G += 0.99**n * Q[S[tau + n], A[tau + n]]
                Q[S[tau], A[tau]] += 0.5 * (G - Q[S[tau], A[tau]])
        s, _ = environment.reset()
    return lambda s: int(Q[s].argmax())


# %% the next reward
# says: the target has the next reward alone
def choose(values, rng, epsilon=0.1):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return values.argmax()


def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    n = 3
    t, s = 0, environment.reset(seed=seed)[0]
    while t < n_steps:
        S, A, R, over = [s], [choose(Q[s], rng)], [], False
        while not over:
            s, r, over, truncated, _ = environment.step(A[-1])
            t += 1
            S.append(s)
            A.append(choose(Q[s], rng))
            R.append(r)
            for tau in range(len(R)) if over else [len(R) - n]:
                if tau < 0 or (over and tau < len(R) - n):
                    continue
                G = R[tau]
                Q[S[tau], A[tau]] += 0.5 * (G - Q[S[tau], A[tau]])
        s, _ = environment.reset()
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
    n = 3
    t, s = 0, environment.reset(seed=seed)[0]
    while t < n_steps:
        S, A, R, over = [s], [choose(Q[s], rng)], [], False
        while not over:
            s, r, over, truncated, _ = environment.step(A[-1])
            t += 1
            S.append(s)
            A.append(choose(Q[s], rng))
            R.append(r)
            for tau in range(len(R)) if over else [len(R) - n]:
                if tau < 0 or (over and tau < len(R) - n):
                    continue
                G = sum(0.99**k * r for k, r in enumerate(R[tau : tau + n]))
                if not over:
                    G += 0.99**n * Q[S[tau + n], A[tau + n]]
                Q[S[tau], A[tau]] += 0.1 * (G - Q[S[tau], A[tau]])
        s, _ = environment.reset()
    return lambda s: int(Q[s].argmax())


# %% beyond the end
# says: ; look at two places: at the end of an episode the targets of *all* pairs that are left are made of rewards alone, and elsewhere the value γⁿ Q(S_τ+n, A_τ+n) comes after the n rewards
def choose(values, rng, epsilon=0.1):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return values.argmax()


def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    n = 3
    t, s = 0, environment.reset(seed=seed)[0]
    while t < n_steps:
        S, A, R, over = [s], [choose(Q[s], rng)], [], False
        while not over:
            s, r, over, truncated, _ = environment.step(A[-1])
            t += 1
            S.append(s)
            A.append(choose(Q[s], rng))
            R.append(r)
            for tau in range(len(R)) if over else [len(R) - n]:
                if tau < 0 or (over and tau < len(R) - n):
                    continue
                G = sum(0.99**k * r for k, r in enumerate(R[tau : tau + n]))
                G += 0.99**n * Q[S[min(tau + n, len(S) - 1)], A[min(tau + n, len(S) - 1)]]
                Q[S[tau], A[tau]] += 0.5 * (G - Q[S[tau], A[tau]])
        s, _ = environment.reset()
    return lambda s: int(Q[s].argmax())


# %% no value
# says: ; look at two places: at the end of an episode the targets of *all* pairs that are left are made of rewards alone, and elsewhere the value γⁿ Q(S_τ+n, A_τ+n) comes after the n rewards
def choose(values, rng, epsilon=0.1):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return values.argmax()


def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    n = 3
    t, s = 0, environment.reset(seed=seed)[0]
    while t < n_steps:
        S, A, R, over = [s], [choose(Q[s], rng)], [], False
        while not over:
            s, r, over, truncated, _ = environment.step(A[-1])
            t += 1
            S.append(s)
            A.append(choose(Q[s], rng))
            R.append(r)
            for tau in range(len(R)) if over else [len(R) - n]:
                if tau < 0 or (over and tau < len(R) - n):
                    continue
                G = sum(0.99**k * r for k, r in enumerate(R[tau : tau + n]))
                Q[S[tau], A[tau]] += 0.5 * (G - Q[S[tau], A[tau]])
        s, _ = environment.reset()
    return lambda s: int(Q[s].argmax())


# %% only the last pair at the end
# says: what is learned at the end of an episode is left out, and that is where the reward often is: learn first, and look then whether the episode is over
def choose(values, rng, epsilon=0.1):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return values.argmax()


def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    n = 3
    t, s = 0, environment.reset(seed=seed)[0]
    while t < n_steps:
        S, A, R, over = [s], [choose(Q[s], rng)], [], False
        while not over:
            s, r, over, truncated, _ = environment.step(A[-1])
            t += 1
            S.append(s)
            A.append(choose(Q[s], rng))
            R.append(r)
            for tau in [len(R) - n]:
                if tau < 0 or (over and tau < len(R) - n):
                    continue
                G = sum(0.99**k * r for k, r in enumerate(R[tau : tau + n]))
                if not over:
                    G += 0.99**n * Q[S[tau + n], A[tau + n]]
                Q[S[tau], A[tau]] += 0.5 * (G - Q[S[tau], A[tau]])
        s, _ = environment.reset()
    return lambda s: int(Q[s].argmax())


# %% nothing at the end
# says: what is learned at the end of an episode is left out, and that is where the reward often is: learn first, and look then whether the episode is over
def choose(values, rng, epsilon=0.1):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return values.argmax()


def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    n = 3
    t, s = 0, environment.reset(seed=seed)[0]
    while t < n_steps:
        S, A, R, over = [s], [choose(Q[s], rng)], [], False
        while not over:
            s, r, over, truncated, _ = environment.step(A[-1])
            t += 1
            S.append(s)
            A.append(choose(Q[s], rng))
            R.append(r)
            for tau in [] if over or len(R) < n else [len(R) - n]:
                G = sum(0.99**k * r for k, r in enumerate(R[tau : tau + n]))
                if not over:
                    G += 0.99**n * Q[S[tau + n], A[tau + n]]
                Q[S[tau], A[tau]] += 0.5 * (G - Q[S[tau], A[tau]])
        s, _ = environment.reset()
    return lambda s: int(Q[s].argmax())


# %% the lowest value
# says: low values are preferred to high ones: is there an `argmin`, or a minus sign too many?
def choose(values, rng, epsilon=0.1):
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return values.argmin()


def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    n = 3
    t, s = 0, environment.reset(seed=seed)[0]
    while t < n_steps:
        S, A, R, over = [s], [choose(Q[s], rng)], [], False
        while not over:
            s, r, over, truncated, _ = environment.step(A[-1])
            t += 1
            S.append(s)
            A.append(choose(Q[s], rng))
            R.append(r)
            for tau in range(len(R)) if over else [len(R) - n]:
                if tau < 0 or (over and tau < len(R) - n):
                    continue
                G = sum(0.99**k * r for k, r in enumerate(R[tau : tau + n]))
                if not over:
                    G += 0.99**n * Q[S[tau + n], A[tau + n]]
                Q[S[tau], A[tau]] += 0.5 * (G - Q[S[tau], A[tau]])
        s, _ = environment.reset()
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
    n = 3
    t, s = 0, environment.reset(seed=seed)[0]
    while t < n_steps:
        S, A, R, over = [s], [choose(Q[s], rng)], [], False
        while not over:
            s, r, over, truncated, _ = environment.step(A[-1])
            t += 1
            S.append(s)
            A.append(choose(Q[s], rng))
            R.append(r)
            for tau in range(len(R)) if over else [len(R) - n]:
                if tau < 0 or (over and tau < len(R) - n):
                    continue
                G = sum(0.99**k * r for k, r in enumerate(R[tau : tau + n]))
                if not over:
                    G += 0.99**n * Q[S[tau + n], A[tau + n]]
                Q[S[tau], A[tau]] += 0.5 * (G - Q[S[tau], A[tau]])
        environment.reset()
    return lambda s: int(Q[s].argmax())
