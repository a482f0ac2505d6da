# %% the table is not made
# says: Not solved yet: my_program is still `...`; put your answer there.
my_program = ...


# %% looks beyond the end
# says: the value of a state after the end is looked up; a terminal state has no future, so its target is the reward alone
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
        target = reward + 0.99 * Q[next_state].max()
        Q[state, action] += 0.5 * (target - Q[state, action])
        state = next_state
        if terminated or truncated:
            state, _ = environment.reset()
    return lambda state: int(Q[state].argmax())


# %% truncated is terminated
# says: a truncated episode is learned as a terminated one: somebody stopped the clock, and the next state still has its value
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
        done = terminated or truncated
        target = reward if done else reward + 0.99 * Q[next_state].max()
        Q[state, action] += 0.5 * (target - Q[state, action])
        state = next_state
        if terminated or truncated:
            state, _ = environment.reset()
    return lambda state: int(Q[state].argmax())


# %% the end is not learned
# says: what is learned at the end of an episode is left out, and that is where the reward often is: learn first, and look then whether the episode is over
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
        if terminated or truncated:
            state, _ = environment.reset()
            continue
        target = reward + 0.99 * Q[next_state].max()
        Q[state, action] += 0.5 * (target - Q[state, action])
        state = next_state
    return lambda state: int(Q[state].argmax())


# %% the old state after a reset
# says: after an end the program goes on from the last state of the old episode: state, info = environment.reset() gives the first state of the new one
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
            environment.reset()
    return lambda state: int(Q[state].argmax())


# %% the state stays
# says: the state stays the first one of the episode: is `state = next_state` missing?
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
        if terminated or truncated:
            state, _ = environment.reset()
    return lambda state: int(Q[state].argmax())


# %% the lowest value
# says: low values are preferred to high ones: is there an `argmin`, or a minus sign too many?
def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    state, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        if rng.random() < 0.1:
            action = rng.integers(len(Q[state]))
        else:
            action = Q[state].argmin()
        next_state, reward, terminated, truncated, _ = environment.step(action)
        target = reward if terminated else reward + 0.99 * Q[next_state].max()
        Q[state, action] += 0.5 * (target - Q[state, action])
        state = next_state
        if terminated or truncated:
            state, _ = environment.reset()
    return lambda state: int(Q[state].argmax())


# %% costs
# says: low values are preferred to high ones: is there an `argmin`, or a minus sign too many?
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
        target = -reward if terminated else -reward + 0.99 * Q[next_state].max()
        Q[state, action] += 0.5 * (target - Q[state, action])
        state = next_state
        if terminated or truncated:
            state, _ = environment.reset()
    return lambda state: int(Q[state].argmax())


# %% no future
# says: γ max_a Q(S', a), the value of the next state, is missing in the target
# says: They fit a usual mistake:
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
        target = reward
        Q[state, action] += 0.5 * (target - Q[state, action])
        state = next_state
        if terminated or truncated:
            state, _ = environment.reset()
    return lambda state: int(Q[state].argmax())


# %% the state that was left
# says: the maximum is taken over Q(S, a), the state that was left, instead of Q(S', a)
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
        target = reward if terminated else reward + 0.99 * Q[state].max()
        Q[state, action] += 0.5 * (target - Q[state, action])
        state = next_state
        if terminated or truncated:
            state, _ = environment.reset()
    return lambda state: int(Q[state].argmax())


# %% slow
# says: the learning rate is much too small: it is 0.5 in the text
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
        Q[state, action] += 0.1 * (target - Q[state, action])
        state = next_state
        if terminated or truncated:
            state, _ = environment.reset()
    return lambda state: int(Q[state].argmax())


# %% the target in its place
# says: the old value is lost, as with a learning rate of 1: it should move halfway to the target
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
        Q[state, action] = target
        state = next_state
        if terminated or truncated:
            state, _ = environment.reset()
    return lambda state: int(Q[state].argmax())


# %% seldom tries
# says: So it seldom tries an action at random: is ε that of the text, up to the last step?
def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    state, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        if rng.random() < 0.01:
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


# %% never tries
# says: my_program takes the same actions with seed 0 and with seed 1: it should try actions at random
def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    state, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        if rng.random() < 0.0:
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


# %% tries too much
# says: are not those that its own steps make look best by the equation of this lesson, and with ε = 0.1 it should be some
# says: If all else is right, ε is about 0.
# says: . If ε is right, compare α, γ and the first values with those of the text, and the update with its equation, term by term
def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    state, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        if rng.random() < 0.4:
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


# %% the wrong way round
# says: So many come from chance alone, or from a table that never changes: are the actions chosen by the values, with probability 1 − ε, and does the update change these values?
def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    state, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        if rng.random() > 0.0:
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


# %% the policy of the lowest value
# says: and the policy that it returns brings
# says: does this policy look up the state that it is given, and take the *best* action?
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
    return lambda state: int(Q[state].argmin())


# %% the mean
# says: the mean over the actions of the next state stands where the maximum should
def my_program(environment, n_steps, seed):
    rng = np.random.default_rng(seed)
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    state, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        best = np.flatnonzero(Q[state] == Q[state].max())
        action = rng.integers(Q.shape[1]) if rng.random() < 0.1 else rng.choice(best)
        next_state, reward, terminated, truncated, _ = environment.step(action)
        target = reward if terminated else reward + 0.99 * Q[next_state].mean()
        Q[state, action] += 0.5 * (target - Q[state, action])
        state = environment.reset()[0] if terminated or truncated else next_state
    return lambda state: int(Q[state].argmax())


# %% another discount
# says: the discount is too small: it is 0.99 in the text
def my_program(environment, n_steps, seed):
    rng = np.random.default_rng(seed)
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    state, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        best = np.flatnonzero(Q[state] == Q[state].max())
        action = rng.integers(Q.shape[1]) if rng.random() < 0.1 else rng.choice(best)
        next_state, reward, terminated, truncated, _ = environment.step(action)
        target = reward if terminated else reward + 0.9 * Q[next_state].max()
        Q[state, action] += 0.5 * (target - Q[state, action])
        state = environment.reset()[0] if terminated or truncated else next_state
    return lambda state: int(Q[state].argmax())
