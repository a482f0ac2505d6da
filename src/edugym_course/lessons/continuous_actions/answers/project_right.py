# %% lists of an episode
# slow
def my_program(environment, n_steps, seed):
    n = environment.observation_space.n
    mu, ls, V = np.zeros(n), np.zeros(n), np.zeros(n)
    rng = np.random.default_rng(seed)
    t, s = 0, environment.reset(seed=seed)[0]
    while t < n_steps:
        S, A, R, over = [], [], [], False
        while not over:
            a = rng.normal(mu[s], np.exp(ls[s]))
            S.append(s)
            A.append(a)
            s, r, terminated, truncated, _ = environment.step(a)
            R.append(r)
            t, over = t + 1, terminated or truncated
        for k in range(len(S)):
            G = sum(0.8**i * r for i, r in enumerate(R[k:]))
            delta = G - V[S[k]]
            V[S[k]] += 0.1 * delta
            z = A[k] - mu[S[k]]
            sigma = np.exp(ls[S[k]])
            step = 0.005 * 0.8**k * delta
            mu[S[k]] += step * z / sigma**2
            ls[S[k]] += step * (z**2 / sigma**2 - 1)
            ls[S[k]] = min(max(ls[S[k]], np.log(0.2)), np.log(2))
        s, _ = environment.reset()
    return lambda s: mu[s]


# %% a class without NumPy
import math
import random


class Gauss:
    def __init__(self):
        self.mean, self.log, self.value = 0.0, 0.0, 0.0

    @property
    def sigma(self):
        return math.exp(self.log)

    def learn(self, action, G, weight):
        error = G - self.value
        score_mean = (action - self.mean) / self.sigma**2
        score_log = ((action - self.mean) / self.sigma) ** 2 - 1
        self.mean += 0.005 * weight * error * score_mean
        self.log = max(math.log(0.2), min(math.log(2), self.log + 0.005 * weight * error * score_log))
        self.value += 0.1 * error


def my_program(environment, n_steps, seed):
    rng = random.Random(seed)
    states = {}
    state, _ = environment.reset(seed=seed)
    episode = []
    for _ in range(n_steps):
        gauss = states.setdefault(state, Gauss())
        action = rng.gauss(gauss.mean, gauss.sigma)
        state, reward, terminated, truncated, _ = environment.step(action)
        episode.append((gauss, action, reward))
        if terminated or truncated:
            G = 0.0
            for t, (gauss, action, reward) in reversed(list(enumerate(episode))):
                G = reward + 0.8 * G
                gauss.learn(action, G, 0.8**t)
            episode = []
            state, _ = environment.reset()
    return lambda state: states.setdefault(state, Gauss()).mean
