# %% an agent of its own
# slow
class Learner:
    def __init__(self, n_actions, rng):
        self.values = {}
        self.n_actions = n_actions
        self.rng = rng

    def row(self, state):
        return self.values.setdefault(int(state), [0.0] * self.n_actions)

    def best(self, state):
        row = self.row(state)
        return int(self.rng.choice([a for a in range(self.n_actions) if row[a] == max(row)]))

    def update(self, s, a, r, s2, over):
        future = 0 if over else max(self.row(s2))
        self.row(s)[a] = 0.5 * self.row(s)[a] + 0.5 * (r + 0.99 * future)


def my_program(env, steps, number):
    rng = np.random.default_rng(number)
    learner, taken = Learner(int(env.action_space.n), rng), 0
    s, _ = env.reset(seed=number)
    env.action_space.seed(number)
    while taken < steps:
        a = env.action_space.sample() if rng.random() < 0.1 else learner.best(s)
        s2, r, terminated, truncated, _ = env.step(a)
        learner.update(s, a, r, s2, terminated)
        taken += 1
        s = env.reset()[0] if terminated or truncated else s2
    return learner.best


# %% episode after episode
# slow
def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng, t, first = np.random.default_rng(seed), 0, True
    while t < n_steps:
        s = environment.reset(seed=seed)[0] if first else environment.reset()[0]
        first = done = False
        while not done:
            a = Q[s].argmax() if rng.random() > 0.1 else rng.integers(len(Q[s]))
            s2, r, end, cut, _ = environment.step(a)
            Q[s, a] += 0.5 * (r + (not end) * 0.99 * Q[s2].max() - Q[s, a])
            s, t, done = s2, t + 1, end or cut
    return Q.argmax(axis=1).__getitem__


# %% ε-greedy written out
# slow
def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    state, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        if rng.random() < 0.1:
            action = rng.integers(len(Q[state]))
        else:
            action = Q[state].argmax()
        next_state, reward, terminated, truncated, _ = environment.step(action)
        target = reward if terminated else reward + 0.99 * Q[next_state].max()
        Q[state, action] += 0.5 * (target - Q[state, action])
        state = next_state
        if terminated or truncated:
            state, _ = environment.reset()
    return lambda state: int(Q[state].argmax())
