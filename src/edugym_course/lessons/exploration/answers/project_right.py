# %% optimism
# slow
def my_program(environment, n_steps, seed):
    rng = np.random.default_rng(seed)
    Q = np.ones((environment.observation_space.n, environment.action_space.n))

    def best(s):
        return int(rng.choice(np.flatnonzero(Q[s] == Q[s].max())))

    s, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        a = best(s)
        s2, r, over, cut, _ = environment.step(a)
        Q[s, a] = r if over else r + 0.5 * Q[s2].max()  # powers of 0.5 are exact, so that ties are ties
        s = environment.reset()[0] if over or cut else s2
    return best


# %% the grip that was tried least
class Climber:
    def __init__(self, n_actions, rng):
        self.tries, self.holds = {}, {}
        self.n_actions, self.rng = n_actions, rng

    def __call__(self, s):
        if s in self.holds:
            return self.holds[s]
        tries = self.tries.setdefault(s, self.rng.random(self.n_actions))
        return int(tries.argmin())


def my_program(env, n_steps, seed):
    me, taken = Climber(env.action_space.n, np.random.default_rng(seed)), 0
    (s, _), over = env.reset(seed=seed), False
    while taken < n_steps:
        if over:
            s, _ = env.reset()
        a = me(s)
        s2, _, end, cut, _ = env.step(a)
        if s2 > s:
            me.holds[s] = a
        else:
            me.tries[s][a] += 1
        s, over, taken = s2, end or cut, taken + 1
    return me


# %% a random grip where none is known
def my_program(environment, n_steps, seed):
    n_states, n_actions = environment.observation_space.n, environment.action_space.n
    known, rng = {}, np.random.default_rng(seed)
    s, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        a = known[s] if s in known else int(rng.integers(n_actions))
        s2, r, over, cut, _ = environment.step(a)
        if s2 > s:
            known[s] = a
        s = environment.reset()[0] if over or cut else s2
    return lambda s: known.get(s, 0)


# %% one grip after another, without chance
def my_program(environment, n_steps, seed):
    grip, n_actions = [0] * environment.observation_space.n, environment.action_space.n
    s, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        s2, _, over, cut, _ = environment.step(grip[s])
        if s2 <= s:
            grip[s] = (grip[s] + 1) % n_actions
        s = environment.reset()[0] if over or cut else s2
    return lambda s: grip[s]
