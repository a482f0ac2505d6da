# %% when the episode is over
# slow
def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng, t = np.random.default_rng(seed), 0
    s, _ = environment.reset(seed=seed)
    while t < n_steps:
        episode, over = [], False
        while not over and t < n_steps:
            a = rng.integers(Q.shape[1]) if rng.random() < 0.1 else Q[s].argmax()
            s2, r, terminated, truncated, _ = environment.step(a)
            over = terminated or truncated
            episode.append((s, a, r))
            s, t = s2, t + 1
        if not over:
            break
        for tau in range(len(episode)):
            G, weight = 0.0, 1.0
            for _, _, r in episode[tau : tau + 3]:
                G, weight = G + weight * r, 0.8 * weight
            if tau + 3 < len(episode):
                G += weight * Q[episode[tau + 3][:2]]
            s, a, _ = episode[tau]
            Q[s, a] += 0.5 * (G - Q[s, a])
        s, _ = environment.reset()
    return lambda s: int(Q[s].argmax())


# %% three steps later
# slow
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
            s, r, terminated, truncated, _ = environment.step(A[-1])
            over = terminated or truncated
            t += 1
            S.append(s)
            A.append(choose(Q[s], rng))
            R.append(r)
            for tau in range(len(R)) if over else [len(R) - n]:
                if tau < 0 or (over and tau < len(R) - n):
                    continue
                G = sum(0.8**k * r for k, r in enumerate(R[tau : tau + n]))
                if not over:
                    G += 0.8**n * Q[S[tau + n], A[tau + n]]
                Q[S[tau], A[tau]] += 0.5 * (G - Q[S[tau], A[tau]])
        s, _ = environment.reset()
    return lambda s: int(Q[s].argmax())


# %% a value also where the clock stops
# slow
def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    n = 3

    def choose(values):
        return rng.integers(len(values)) if rng.random() < 0.1 else rng.choice(np.flatnonzero(values == values.max()))

    t, s = 0, environment.reset(seed=seed)[0]
    while t < n_steps:
        S, A, R, over = [s], [choose(Q[s])], [], False
        while not over:
            s, r, terminated, truncated, _ = environment.step(A[-1])
            over = terminated or truncated
            t += 1
            S.append(s)
            A.append(choose(Q[s]))
            R.append(r)
            for tau in range(len(R)) if over else [len(R) - n]:
                if tau < 0 or (over and tau < len(R) - n):
                    continue
                G = sum(0.8**k * r for k, r in enumerate(R[tau : tau + n]))
                if not terminated:
                    last = min(tau + n, len(R))
                    G += 0.8 ** (last - tau) * Q[S[last], A[last]]
                Q[S[tau], A[tau]] += 0.5 * (G - Q[S[tau], A[tau]])
        s, _ = environment.reset()
    return lambda s: int(Q[s].argmax())


# %% a value where the clock stops, after three rewards only
# slow
# in: a value also where the clock stops
# - if not terminated:
# -     last = min(tau + n, len(R))
# -     G += 0.8 ** (last - tau) * Q[S[last], A[last]]
# + if tau + n < len(S) and not terminated:
# +     G += 0.8**n * Q[S[tau + n], A[tau + n]]
