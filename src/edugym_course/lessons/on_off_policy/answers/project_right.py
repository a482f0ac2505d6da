# %% one step behind
# slow
def my_program(env, n_steps, seed):
    rng = np.random.default_rng(seed)
    Q = {}

    def value(s):
        return Q.setdefault(int(s), np.zeros(env.action_space.n))

    (s, _), before = env.reset(seed=seed), None
    for _ in range(n_steps):
        greedy = np.flatnonzero(value(s) == value(s).max())
        a = rng.integers(env.action_space.n) if rng.random() < 0.1 else rng.choice(greedy)
        if before is not None:
            s0, a0, r0 = before
            Q[s0][a0] += 0.5 * (r0 + Q[int(s)][a] - Q[s0][a0])
        s2, r, terminated, truncated, _ = env.step(a)
        before = (int(s), a, r)
        if terminated:
            Q[int(s)][a] = 0.5 * Q[int(s)][a] + 0.5 * r
        if terminated or truncated:
            before, (s2, _) = None, env.reset()
        s = s2
    return lambda s: int(value(s).argmax())


# %% a class with both
# slow
class Sarsa:
    def __init__(self, n_states, n_actions, seed):
        self.table = [[0.0] * n_actions for _ in range(n_states)]
        self.rng = np.random.default_rng(seed)

    def __call__(self, s):
        return int(np.argmax(self.table[s]))

    def try_one(self, s):
        return int(self.rng.integers(len(self.table[s]))) if self.rng.random() < 0.1 else self(s)


def my_program(environment, n_steps, seed):
    me = Sarsa(environment.observation_space.n, environment.action_space.n, seed)
    s = environment.reset(seed=seed)[0]
    a, t = me.try_one(s), 0
    while t < n_steps:
        s2, r, end, cut, _ = environment.step(a)
        a2 = me.try_one(s2)
        future = 0.0 if end else me.table[s2][a2]
        me.table[s][a] += 0.5 * (r + future - me.table[s][a])
        if end or cut:
            s2 = environment.reset()[0]
            a2 = me.try_one(s2)
        s, a, t = s2, a2, t + 1
    return me


# %% the next action is kept
# slow
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
        s, a = s2, a2
    return lambda s: int(Q[s].argmax())
