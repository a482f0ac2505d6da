# %% weights in an array
# slow
def my_program(environment, n_steps, seed):
    W, N, L = (
        environment.observation_space.nvec[1],
        environment.action_space.n,
        len(environment.observation_space.nvec) - 1,
    )
    theta = np.zeros((W, N))
    rng = np.random.default_rng(seed)

    def shares(o):
        x = np.zeros(W)
        for k in range(1, L + 1):
            x[o[k]] += 1 / L
        return x

    o, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        x = shares(o)
        q = x @ theta
        a = int(rng.integers(N)) if rng.random() < 0.1 else int(q.argmax())
        o2, r, terminated, truncated, _ = environment.step(a)
        delta = r - q[a]
        theta[:, a] += 0.01 * delta * x
        o = o2
        if terminated or truncated:
            o, _ = environment.reset()
    return lambda o: int((shares(o) @ theta).argmax())


# %% a dictionary, word by word
# slow
import random


class Listener:
    def __init__(self, n_actions, seed):
        self.weights = {}
        self.n_actions = n_actions
        self.random = random.Random(seed)

    def q(self, words):
        return [sum(self.weights.get((w, a), 0.0) for w in words) / len(words) for a in range(self.n_actions)]

    def act(self, words, epsilon):
        if self.random.random() < epsilon:
            return self.random.randrange(self.n_actions)
        q = self.q(words)
        return self.random.choice([a for a in range(self.n_actions) if q[a] == max(q)])

    def learn(self, words, a, reward):
        error = reward - self.q(words)[a]
        for w in words:
            self.weights[w, a] = self.weights.get((w, a), 0.0) + 0.01 * error / len(words)


def my_program(environment, n_steps, seed):
    listener = Listener(int(environment.action_space.n), seed)
    steps = 0
    while steps < n_steps:
        _, *words = environment.reset(seed=None if steps else seed)[0]
        over = False
        while steps < n_steps and not over:
            action = listener.act(words, 0.1)
            (_, *next_words), reward, terminated, truncated, _ = environment.step(action)
            listener.learn(words, action, reward)
            words, over, steps = next_words, terminated or truncated, steps + 1
    return lambda observation: listener.act(list(observation[1:]), 0.0)
