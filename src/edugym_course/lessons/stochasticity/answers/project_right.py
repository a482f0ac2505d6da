# %% tanh and lists
# slow
import math


def my_program(env, n_steps, seed):
    values = [[0.0] * int(env.action_space.n) for _ in range(env.observation_space.n)]
    rng = np.random.default_rng(seed)

    def policy(s):
        return values[s].index(max(values[s]))

    s, taken = env.reset(seed=seed)[0], 0
    while taken < n_steps:
        a = policy(s) if rng.random() >= 0.1 else int(rng.integers(len(values[s])))
        s2, r, over, cut, _ = env.step(a)
        error = r - values[s][a] + (0.0 if over else 0.9 * max(values[s2]))
        values[s][a] += 0.4 * error * (1 + math.tanh(-0.5 * error / 2))
        s, taken = env.reset()[0] if over or cut else s2, taken + 1
    return policy


# %% the weight in one line
# slow
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
    return lambda s: int(Q[s].argmax())


# %% a probability for each action
# slow
def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    s, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        best = Q[s] == Q[s].max()
        a = rng.choice(len(Q[s]), p=0.1 / len(Q[s]) + 0.9 * best / best.sum())
        s2, r, over, cut, _ = environment.step(a)
        delta = r + 0.9 * (1 - over) * Q[s2].max() - Q[s, a]
        Q[s, a] += 0.8 * delta / (1 + np.exp(delta / 2))
        s = environment.reset()[0] if over or cut else s2
    return lambda s: int(Q[s].argmax())
