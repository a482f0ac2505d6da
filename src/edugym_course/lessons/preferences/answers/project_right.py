# %% gradient steps and planning by counting
# slow
def my_program(environment, compare, n_comparisons, seed):
    rng = np.random.default_rng(seed)
    length, depths = (int(n) for n in environment.observation_space.nvec)
    counts = np.full((length, depths, 3, depths), 1e-9)

    def play():
        state, _ = environment.reset()
        night = []
        while True:
            action = int(rng.integers(3))
            after, _, terminated, truncated, _ = environment.step(action)
            night.append((state, action, after))
            counts[state[0], state[1], action, after[1]] += 1
            state = after
            if terminated or truncated:
                return night

    w = np.zeros((length, depths, 3))
    asked = []
    for _ in range(n_comparisons):
        one, other = play(), play()
        asked.append((one, other, compare(one, other)))
    for _ in range(60):
        for k in rng.permutation(len(asked)):
            one, other, likes = asked[k]
            x = sum(w[s[0], s[1], a] for s, a, _ in one) - sum(w[s[0], s[1], a] for s, a, _ in other)
            error = likes - 0.5 * (1 + np.tanh(x / 2))
            for night, sign in ((one, 1.0), (other, -1.0)):
                for s, a, _ in night:
                    w[s[0], s[1], a] += 0.05 * sign * error
        w *= 0.99
    for _ in range(500):
        play()
    p = counts / counts.sum(axis=3, keepdims=True)
    V, best = np.zeros(depths), {}
    for time in reversed(range(length - 1)):
        Q = w[time] + p[time] @ V
        V = Q.max(axis=1)
        for depth in range(depths):
            best[time, depth] = int(Q[depth].argmax())
    return lambda observation: best[int(observation[0]), int(observation[1])]


# %% visits as vectors
# slow
def my_program(environment, compare, n_comparisons, seed):
    rng = np.random.default_rng(seed)
    shape = (*environment.observation_space.nvec, 3)

    def night_of(choose):
        observation, _ = environment.reset()
        steps, over = [], False
        while not over:
            action = choose(tuple(observation))
            next_observation, _, terminated, truncated, _ = environment.step(action)
            steps.append((tuple(observation), action, tuple(next_observation)))
            observation, over = next_observation, terminated or truncated
        return steps

    def visits(steps):
        table = np.zeros(shape)
        for (time, depth), action, _ in steps:
            table[time, depth, action] += 1
        return table.ravel()

    differences, preferred = [], []
    for _ in range(n_comparisons):
        first, second = (night_of(lambda state: int(rng.integers(3))) for _ in range(2))
        preferred.append(float(compare(first, second)))
        differences.append(visits(first) - visits(second))
    differences, preferred = np.array(differences), np.array(preferred)

    rewards = np.zeros(differences.shape[1])
    for _ in range(500):
        p = 0.5 * (1 + np.tanh(differences @ rewards / 2))
        rewards += 0.02 * (differences.T @ (preferred - p) - 0.1 * rewards)
    rewards = rewards.reshape(shape)

    Q = np.zeros(shape)

    def explore(state):
        return int(rng.integers(3)) if rng.random() < 0.3 else int(Q[state].argmax())

    for _ in range(3_000):
        for state, action, next_state in night_of(explore):
            target = rewards[state][action] + Q[next_state].max()  # after the last step it is 0
            Q[state][action] += 0.1 * (target - Q[state][action])
    return lambda observation: int(Q[tuple(observation)].argmax())
