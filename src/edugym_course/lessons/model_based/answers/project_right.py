# %% lists of lists
# slow
class Dyna:
    def __init__(self, n_states, n_actions, rng):
        self.values = [[0.0] * n_actions for _ in range(n_states)]
        self.seen = {}
        self.rng = rng

    def policy(self, s):
        return int(np.argmax(self.values[s]))

    def improve(self, s, a, r, s2, over):
        self.values[s][a] = r + (0 if over else 0.95 * max(self.values[s2]))

    def dream(self):
        memories = list(self.seen.items())
        for k in self.rng.choice(len(memories), 10):
            (s, a), what = memories[k]
            self.improve(s, a, *what)


def my_program(env, n_steps, seed):
    rng = np.random.default_rng(seed)
    me = Dyna(env.observation_space.n, env.action_space.n, rng)
    s, _ = env.reset(seed=seed)
    for _ in range(n_steps):
        a = int(rng.integers(env.action_space.n)) if rng.random() < 0.1 else me.policy(s)
        s2, r, over, cut, _ = env.step(a)
        me.seen[s, a] = (r, s2, over)
        me.improve(s, a, r, s2, over)
        me.dream()
        s = env.reset()[0] if over or cut else s2
    return me.policy


# %% a model in arrays
# slow
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
            s, _ = environment.reset()
    return lambda s: int(Q[s].argmax())


# %% a state first, then one of its actions
# slow
def my_program(environment, n_steps, seed):
    rng = np.random.default_rng(seed)
    n = environment.action_space.n
    Q, memory, s = {}, {}, None

    def values(s):
        return [Q.get((s, a), 0.0) for a in range(n)]

    def best(s):
        v = values(s)
        return max(range(n), key=v.__getitem__)

    def learn(s, a):
        r, s2, goes_on = memory[s][a]
        Q[s, a] = r + 0.95 * max(values(s2)) if goes_on else r

    for step in range(n_steps):
        if s is None:
            s = environment.reset(seed=None if step else seed)[0]
        a = best(s) if rng.random() > 0.1 else int(rng.integers(n))
        s2, r, over, cut, _ = environment.step(a)
        memory.setdefault(s, {})[a] = r, s2, not over
        learn(s, a)
        for _ in range(10):
            i = [*memory][rng.integers(len(memory))]
            learn(i, [*memory[i]][rng.integers(len(memory[i]))])
        s = None if over or cut else s2
    return best
