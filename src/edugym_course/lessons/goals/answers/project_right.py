# %% numbers for patterns
# slow
def my_program(environment, n_steps, seed):
    n = environment.action_space.n
    powers = 2 ** np.arange(n)
    Q, rng = np.full((2**n, 2**n, n), -10.0), np.random.default_rng(seed)
    o, _ = environment.reset(seed=seed)
    s, g = o["achieved_goal"] @ powers, o["desired_goal"] @ powers
    episode = []
    for _ in range(n_steps):
        if rng.random() < 0.1:
            a = int(rng.integers(n))
        else:
            a = int(rng.choice(np.flatnonzero(Q[s, g] == Q[s, g].max())))
        o, r, terminated, truncated, _ = environment.step(a)
        s2 = o["achieved_goal"] @ powers
        target = r if terminated else r + 0.9 * Q[s2, g].max()
        Q[s, g, a] += 0.5 * (target - Q[s, g, a])
        episode.append((s, a, s2))
        s = s2
        if terminated or truncated:
            new = s2
            for s, a, s2 in episode[::-1]:
                r = 0.0 if s2 == new else -1.0
                target = r if s2 == new else r + 0.9 * Q[s2, new].max()
                Q[s, new, a] += 0.5 * (target - Q[s, new, a])
            episode = []
            o, _ = environment.reset()
            s, g = o["achieved_goal"] @ powers, o["desired_goal"] @ powers
    return lambda o: int(Q[o["achieved_goal"] @ powers, o["desired_goal"] @ powers].argmax())


# %% a class
# slow
from collections import defaultdict


class Agent:
    def __init__(self, n, rng):
        self.n, self.rng = n, rng
        self.values = defaultdict(lambda: [-10.0] * n)
        self.path = []

    def pick(self, s, g):
        values = self.values[s, g]
        if self.rng.uniform() < 0.1:
            return int(self.rng.integers(0, self.n))
        highest = max(values)
        return int(self.rng.choice([a for a in range(self.n) if values[a] == highest]))

    def update(self, s, a, s2, g):
        future = 0.0 if s2 == g else -1.0 + 0.9 * max(self.values[s2, g])
        self.values[s, g][a] = 0.5 * self.values[s, g][a] + 0.5 * future

    def hindsight(self):
        _, _, achieved = self.path[-1]
        while self.path:
            self.update(*self.path.pop(), achieved)


def my_program(environment, n_steps, seed):
    agent = Agent(int(environment.action_space.n), np.random.default_rng(seed))
    over, first = True, True
    for _ in range(n_steps):
        if over:
            seen, _ = environment.reset(seed=seed) if first else environment.reset()
            first = False
        s, g = seen["achieved_goal"].tobytes(), seen["desired_goal"].tobytes()
        a = agent.pick(s, g)
        seen, reward, terminated, truncated, _ = environment.step(a)
        s2 = seen["achieved_goal"].tobytes()
        agent.update(s, a, s2, g)
        agent.path.append((s, a, s2))
        over = terminated or truncated
        if over:
            agent.hindsight()

    def policy(seen):
        values = agent.values[seen["achieved_goal"].tobytes(), seen["desired_goal"].tobytes()]
        return int(np.argmax(values))

    return policy
