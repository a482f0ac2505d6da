# %% all pairs at random
# slow
def my_program(environment, n_steps, seed):
    rng = np.random.default_rng(seed)
    me, you = environment.possible_agents
    shape = environment.observation_space(me).n, environment.action_space(me).n, environment.action_space(you).n
    Q = np.zeros(shape)
    solved = {}

    def value(state):
        return solved[state].value if state in solved else 0.0

    seen, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        state = int(seen[me])
        a, o = int(rng.integers(shape[1])), int(rng.integers(shape[2]))
        seen, rewards, terminated, truncated, _ = environment.step({me: a, you: o})
        target = rewards[me]
        if not terminated[me]:
            target += 0.9 * value(int(seen[me]))
        Q[state, a, o] += 0.2 * (target - Q[state, a, o])
        solved[state] = games.solve_zero_sum(Q[state])
        if not environment.agents:
            seen, _ = environment.reset()
    return lambda state: solved[state].first if state in solved else [1 / shape[1]] * shape[1]


# %% a class, lists, and player 1 who answers
# slow
class Player:
    def __init__(self, n_states, n_actions, n_others, seed):
        self.q = [np.zeros((n_actions, n_others)) for _ in range(n_states)]
        self.v = [0.0] * n_states
        self.pi = [np.ones(n_actions) / n_actions for _ in range(n_states)]
        self.rho = [np.ones(n_others) / n_others for _ in range(n_states)]
        self.rng = np.random.default_rng(seed)

    def draw(self, p):
        if self.rng.random() < 0.3:
            return int(self.rng.integers(len(p)))
        return int(np.searchsorted(np.cumsum(p)[:-1], self.rng.random(), side="right"))

    def learn(self, s, a, o, r, s2, over):
        y = r if over else r + 0.9 * self.v[s2]
        self.q[s][a, o] = 0.8 * self.q[s][a, o] + 0.2 * y
        self.v[s], self.pi[s], self.rho[s] = games.solve_zero_sum(self.q[s])


def my_program(environment, n_steps, seed):
    sizes = environment.observation_space("player_0").n, environment.action_space("player_0").n
    both = Player(*sizes, environment.action_space("player_1").n, seed)
    steps = 0
    observations, _ = environment.reset(seed=seed)
    while steps < n_steps:
        s = observations["player_0"]
        a, o = both.draw(both.pi[s]), both.draw(both.rho[s])
        observations, rewards, ends, _, _ = environment.step({"player_0": a, "player_1": o})
        both.learn(s, a, o, rewards["player_0"], observations["player_0"], ends["player_0"])
        steps += 1
        if not environment.agents and steps < n_steps:
            observations, _ = environment.reset()
    return lambda s: both.pi[s]


# %% other random numbers, with bad luck in one game
# slow
# in: the solution of my_program
# - rng = np.random.default_rng(seed)
# + rng = np.random.default_rng(seed)
# + rng.random(5)
