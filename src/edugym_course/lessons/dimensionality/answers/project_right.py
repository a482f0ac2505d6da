# %% SARSA from each step once
# slow
def my_program(environment, n_steps, seed):
    rng = np.random.default_rng(seed)
    n, k = np.prod(environment.observation_space.shape), environment.action_space.n
    W, b = rng.normal(0, np.sqrt(2 / n), (64, n)), np.zeros(64)
    V, c = rng.normal(0, 0.1, (k, 64)), np.zeros(k)

    def q(x):
        h = np.maximum(0, W @ x + b)
        return h, V @ h + c

    def act(x):
        return rng.integers(k) if rng.random() < 0.1 else np.argmax(q(x)[1])

    x = np.ravel(environment.reset(seed=seed)[0])
    a = act(x)
    for _ in range(n_steps):
        o, r, terminated, truncated, _ = environment.step(a)
        x2 = np.ravel(o)
        a2 = act(x2)
        h, Q = q(x)
        delta = r - Q[a] if terminated else r + 0.9 * q(x2)[1][a2] - Q[a]
        g = V[a] * (h > 0)
        V[a] += 0.05 * delta * h
        c[a] += 0.05 * delta
        W += 0.05 * delta * np.outer(g, x)
        b += 0.05 * delta * g
        x, a = x2, a2
        if terminated or truncated:
            x = np.ravel(environment.reset()[0])
            a = act(x)
    return lambda o: int(np.argmax(q(np.ravel(o))[1]))


# %% a memory in arrays
# slow
import itertools


class Network:
    def __init__(self, sizes, rng):
        self.W = [rng.normal(size=(m + 1, n)) * np.sqrt(2 / m) for m, n in itertools.pairwise(sizes)]

    def layers(self, x):
        ones = np.ones((len(x), 1))
        x = np.hstack([x, ones])
        h = np.hstack([np.maximum(x @ self.W[0], 0), ones])
        return x, h, h @ self.W[1]

    def best(self, image):
        return int(self.layers(image.reshape(1, -1))[2].argmax())

    def learn(self, x, a, y):
        x, h, q = self.layers(x)
        d = np.where(np.arange(q.shape[1]) == a[:, None], q - y[:, None], 0.0).clip(-1, 1)
        back = (d @ self.W[1].T * (h > 0))[:, :-1]
        self.W[1] -= 0.2 * h.T @ d / len(x)
        self.W[0] -= 0.2 * x.T @ back / len(x)


def my_program(environment, n_steps, seed):
    rng = np.random.default_rng(seed)
    n, k = environment.observation_space.shape[0] * environment.observation_space.shape[1], environment.action_space.n
    network = Network([n, 64, k], rng)
    old = network
    S, S2 = np.zeros((2, n_steps, n))
    A, R, goes_on = np.zeros(n_steps, int), np.zeros(n_steps), np.zeros(n_steps)
    s, _ = environment.reset(seed=seed)
    for t in range(n_steps):
        if t % 50 == 0:
            old = copy.deepcopy(network)
        a = network.best(s) if rng.random() > 0.1 else rng.integers(k)
        s2, r, terminated, truncated, _ = environment.step(a)
        S[t], A[t], R[t], S2[t], goes_on[t] = s.ravel(), a, r, s2.ravel(), not terminated
        s = s2
        i = rng.integers(t + 1, size=32)
        y = R[i] + 0.9 * goes_on[i] * old.layers(S2[i])[2].max(axis=1)
        network.learn(S[i], A[i], y)
        if terminated or truncated:
            s, _ = environment.reset()
    return network.best
