# %% late dives count for nothing
# slow
def my_program(environment, n_steps, seed):
    rng = np.random.default_rng(seed)
    Q = np.zeros((90, 2))
    state, _ = environment.reset(seed=seed)
    steps = 0
    for _ in range(n_steps):
        action = int(rng.integers(2))
        after, value, terminated, truncated, _ = environment.step(action)
        steps += 1
        reward = value if steps <= 7 else 0.0
        Q[state, action] += 0.5 * ((reward if terminated else reward + Q[after].max()) - Q[state, action])
        state = after
        if terminated or truncated:
            state, _ = environment.reset()
            steps = 0
    return lambda state: int(Q[state].argmax())


# %% remembers the best dive
# slow
def my_program(environment, n_steps, seed):
    rng = np.random.default_rng(seed)
    best, highest = [], -1.0
    state, _ = environment.reset(seed=seed)
    dive = []
    for _ in range(n_steps):
        action = int(rng.integers(2))
        dive.append((state, action))
        state, value, terminated, truncated, _ = environment.step(action)
        if terminated and len(dive) <= 7 and value > highest:
            best, highest = dive, value
        if terminated or truncated:
            state, _ = environment.reset()
            dive = []
    way = dict(best)
    return lambda state: way.get(state, 0)


# %% sets of vectors
# slow
def my_program(environment, n_steps, seed):
    rng = np.random.default_rng(seed)
    ways = {}

    def good(state):
        points = {p for action in (0, 1) for p in ways.get((state, action), ())}
        return {p for p in points if not any(q != p and q[0] >= p[0] and q[1] <= p[1] for q in points)}

    def best(state):
        left = 7 - (state // 9 + state % 9 - start)
        values = [max((v for v, t in ways.get((state, a), ()) if t <= left), default=-1.0) for a in (0, 1)]
        return int(np.argmax(values))

    start, _ = environment.reset(seed=seed)  # in row 0, so its number is its column
    state = start
    for _ in range(n_steps):
        action = int(rng.integers(2))
        after, value, terminated, truncated, _ = environment.step(action)
        ways[state, action] = {(value, 1)} if terminated else {(value + v, 1 + t) for v, t in good(after) if t < 30}
        state = after
        if terminated or truncated:
            state, _ = environment.reset()
    return best


# %% plans with what it saw
# slow
def my_program(environment, n_steps, seed):
    rng = np.random.default_rng(seed)
    after, worth = {}, {}
    start, _ = environment.reset(seed=seed)
    s = start
    for _ in range(n_steps):
        a = int(rng.integers(2))
        s2, r, end, cut, _ = environment.step(a)
        after[s, a], worth[s, a] = (None if end else s2), r
        s = environment.reset()[0] if end or cut else s2

    def best(s, left):
        if s is None or not left:
            return (0.0 if s is None else -np.inf), 0
        ways = [(worth[s, a] + best(after[s, a], left - 1)[0], a) for a in (0, 1) if (s, a) in after]
        return max(ways, default=(-np.inf, 0))

    policy, left = {}, 7
    while start is not None and left:
        policy[start] = best(start, left)[1]
        start, left = after[start, policy[start]], left - 1
    return lambda state: policy.get(state, 0)


# %% one plan for each column
# slow
def my_program(environment, n_steps, seed):
    rng = np.random.default_rng(seed)
    taken, highest, kept = 0, 0.0, {}
    while taken < n_steps:
        out = int(rng.integers(9))
        state, _ = environment.reset(seed=None if taken else seed)
        path, total, over, steps = {}, 0.0, False, 0
        while not over:
            path[state] = int(steps < out)
            state, value, terminated, truncated, _ = environment.step(path[state])
            total, steps = total + value, steps + 1
            over = terminated or truncated
        taken += steps
        if steps <= 7 and total > highest:
            highest, kept = total, path
    return lambda state: kept.get(state, 0)
