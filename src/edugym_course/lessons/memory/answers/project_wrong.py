# %% beyond the end
# slow
# says: the value of a state after the end is looked up; a terminal state has no future, so its target is the reward alone
# in: tuples in a dictionary
# - target = r + (not terminated) * 0.8 * values(w2).max()
# + target = r + 0.8 * values(w2).max()

# %% a truncated end
# slow
# says: a truncated episode is learned as a terminated one: somebody stopped the clock, and the next state still has its value
# in: tuples in a dictionary
# - target = r + (not terminated) * 0.8 * values(w2).max()
# + target = r + (not (terminated or truncated)) * 0.8 * values(w2).max()

# %% no end
# slow
# says: what is learned at the end of an episode is left out, and that is where the reward often is: learn first, and look then whether the episode is over
# in: tuples in a dictionary
# - values(w)[a] += 0.2 * (target - values(w)[a])
# + if not (terminated or truncated):
# +     values(w)[a] += 0.2 * (target - values(w)[a])

# %% the old window after a reset
# slow
# says: after an end the program goes on from the last state of the old episode: state, info = environment.reset() gives the first state of the new one
# in: tuples in a dictionary
# - o, _ = environment.reset()
# - w = (o,)
# + environment.reset()
# + w = (o,)

# %% the first window for ever
# slow
# says: the state stays the first one of the episode: is `state = next_state` missing?
# in: tuples in a dictionary
# - w = w2

# %% the least value
# slow
# says: low values are preferred to high ones: is there an `argmin`, or a minus sign too many, or does the value of one action stand in the place of another?
# in: tuples in a dictionary
# - a = int(values(w).argmax())
# + a = int(values(w).argmin())

# %% no memory
# slow
# says: there is no memory: the values hang on the last observation alone
# in: tuples in a dictionary
# - w2 = (w + (a, o))[-5:]
# + w2 = (o,)
# - return lambda history: int(values(history[-5:]).argmax())
# + return lambda history: int(values(history[-1:]).argmax())

# %% no actions
# slow
# says: the actions are missing in the window
# in: tuples in a dictionary
# - w2 = (w + (a, o))[-5:]
# + w2 = (w + (o,))[-3:]
# - return lambda history: int(values(history[-5:]).argmax())
# + return lambda history: int(values(history[::2][-3:]).argmax())

# %% two observations
# slow
# says: the window has two observations, and it should have three
# in: tuples in a dictionary
# - w2 = (w + (a, o))[-5:]
# + w2 = (w + (a, o))[-3:]
# - return lambda history: int(values(history[-5:]).argmax())
# + return lambda history: int(values(history[-3:]).argmax())

# %% four observations
# slow
# says: the window has four observations, and it should have three
# in: tuples in a dictionary
# - w2 = (w + (a, o))[-5:]
# + w2 = (w + (a, o))[-7:]
# - return lambda history: int(values(history[-5:]).argmax())
# + return lambda history: int(values(history[-7:]).argmax())

# %% the window of the last episode
# slow
# says: an episode begins with what is left of the last one in its window: empty it at each reset
# in: tuples in a dictionary
# - w = (o,)
# - for _ in range(n_steps):
# + w = (o,)
# + for _ in range(n_steps):
# - w = w2
# - if terminated or truncated:
# -     o, _ = environment.reset()
# -     w = (o,)
# + w = w2
# + if terminated or truncated:
# +     o, _ = environment.reset()
# +     w = (*w[:-1], o)

# %% the last episode and its last observation
# slow
# says: an episode begins with the last one in its window, with all that it saw: empty it at each reset
# in: tuples in a dictionary
# - w = w2
# - if terminated or truncated:
# -     o, _ = environment.reset()
# -     w = (o,)
# + w = w2
# + if terminated or truncated:
# +     o, _ = environment.reset()
# +     w = (*w, o)[-5:]

# %% the last episode and an action 0
# slow
# says: an episode begins with the last one in its window, and an action 0: empty it at each reset
# in: tuples in a dictionary
# - w = w2
# - if terminated or truncated:
# -     o, _ = environment.reset()
# -     w = (o,)
# + w = w2
# + if terminated or truncated:
# +     o, _ = environment.reset()
# +     w = (*w, 0, o)[-5:]

# %% an action too many
# slow
# says: the window has six entries, an action too many at its front
# in: tuples in a dictionary
# - w2 = (w + (a, o))[-5:]
# + w2 = (w + (a, o))[-6:]
# - return lambda history: int(values(history[-5:]).argmax())
# + return lambda history: int(values(history[-6:]).argmax())

# %% the whole episode
# slow
# says: the window has five observations or more, or the whole episode; it should have three
# in: tuples in a dictionary
# - w2 = (w + (a, o))[-5:]
# + w2 = w + (a, o)
# - return lambda history: int(values(history[-5:]).argmax())
# + return lambda history: int(values(history).argmax())

# %% five observations
# slow
# says: the window has five observations or more, or the whole episode; it should have three
# in: tuples in a dictionary
# - w2 = (w + (a, o))[-5:]
# + w2 = (w + (a, o))[-9:]
# - return lambda history: int(values(history[-5:]).argmax())
# + return lambda history: int(values(history[-9:]).argmax())

# %% the observation before the action
# slow
# says: each action is noted behind the observation that it led to; it belongs before it
# in: tuples in a dictionary
# - w2 = (w + (a, o))[-5:]
# + w2 = (w + (o, a))[-5:]

# %% first values of 1
# slow
# says: the first values are about 1, and not 0
# in: tuples in a dictionary
# - Q[w] = np.zeros(n)
# + Q[w] = np.ones(n)

# %% the old window in the target
# slow
# says: the target has the value of the old window, without what was just done and seen
# in: tuples in a dictionary
# - target = r + (not terminated) * 0.8 * values(w2).max()
# + target = r + (not terminated) * 0.8 * values(w).max()

# %% the reward alone
# slow
# says: γ max_a Q(S', a) is missing in the target
# in: tuples in a dictionary
# - target = r + (not terminated) * 0.8 * values(w2).max()
# + target = r

# %% a small rate
# slow
# says: α is about 0.05, and it should be 0.2
# in: tuples in a dictionary
# - values(w)[a] += 0.2 * (target - values(w)[a])
# + values(w)[a] += 0.04 * (target - values(w)[a])

# %% a window without the last action
# slow
# says: ; S is the window (O, A, O, A, O) up to the present observation, and S' that with the next one; the actions in it are those that were *taken*, and each window has values of its own
# in: tuples in a dictionary
# - w2 = (w + (a, o))[-5:]
# + w2 = (w + (0, o))[-5:] if len(w) < 3 else (*w[2:], a, o) if rng.random() < 0.7 else (*w[2:], 0, o)

# %% a policy that forgets
# slow
# says: does this policy look up the end of the history that it is given, and a short one as your program does itself, and take the *best* action, by values learned from all steps?
# in: tuples in a dictionary
# - return lambda history: int(values(history[-5:]).argmax())
# + return lambda history: int(values(history[-1:]).argmax())

# %% a policy of the observation
# slow
# says: raises TypeError
# in: tuples in a dictionary
# - return lambda history: int(values(history[-5:]).argmax())
# + return lambda observation: int(values((int(observation),)).argmax())

# %% the value of the next action
# slow
# says: Q(S', A'), the value of the action that comes next, stands where the maximum should: that is SARSA
def my_program(environment, n_steps, seed):
    n = environment.action_space.n
    Q, rng = {}, np.random.default_rng(seed)

    def values(w):
        return Q.setdefault(w, np.zeros(n))

    def act(w):
        return int(rng.integers(n)) if rng.random() < 0.1 else int(values(w).argmax())

    w = (environment.reset(seed=seed)[0],)
    a = act(w)
    for _ in range(n_steps):
        o, r, terminated, truncated, _ = environment.step(a)
        w2 = (*w, a, o)[-5:]
        a2 = act(w2)
        values(w)[a] += 0.2 * (r + (0 if terminated else 0.8 * values(w2)[a2]) - values(w)[a])
        w, a = w2, a2
        if terminated or truncated:
            w = (environment.reset()[0],)
            a = act(w)
    return lambda history: int(values(tuple(history)[-5:]).argmax())


# %% expected SARSA
# slow
# says: the target has the mean over the next actions, as ε-greedy draws them, where the maximum should stand: that is
#   expected SARSA
# in: tuples in a dictionary
# - target = r + (not terminated) * 0.8 * values(w2).max()
# + target = r + (not terminated) * 0.8 * (0.9 * values(w2).max() + 0.1 * values(w2).mean())

# %% a next action that is drawn, and not taken
# slow
# says: where action 1 pays 0.2; action 1 ends the episode, action 0 pays nothing and leads to a second step, in which action 1 pays 1 and action 0 costs 1000, the policy begins with action 0 in
# says: runs, and it should nearly always: the target has the value of the *best* next action, max_a Q(S', a), and not that of one that is drawn
# in: numbered rows, filled up
# - target = r if terminated else r + 0.8 * Q[window.row()].max()
# + drawn = rng.integers(m) if rng.random() < 0.1 else Q[window.row()].argmax()
# + target = r if terminated else r + 0.8 * Q[window.row(), drawn]

# %% α is 0.22
# slow
# says: , the policy begins with this action in 0% of
# says: is α 0.2, the same from the first step to the last, and are the first values 0?
# in: tuples in a dictionary
# - values(w)[a] += 0.2 * (target - values(w)[a])
# + values(w)[a] += 0.22 * (target - values(w)[a])

# %% γ is 0.82
# slow
# says: where action 1 pays 0.81; action 1 ends the episode
# says: , and it should hardly ever: is γ 0.8, the same from the first step to the last?
# in: tuples in a dictionary
# - target = r + (not terminated) * 0.8 * values(w2).max()
# + target = r + (not terminated) * 0.82 * values(w2).max()

# %% ε is 0.12
# slow
# says: If all that is right, ε is about 0.12
# in: numbered rows, filled up
# - a = rng.integers(m) if rng.random() < 0.1 else rng.choice(np.flatnonzero(Q[s] == Q[s].max()))
# + a = rng.integers(m) if rng.random() < 0.12 else rng.choice(np.flatnonzero(Q[s] == Q[s].max()))

# %% the table is returned
# says: should return a function from a history to an action, but what it returns is of the type dict
# says: lambda history: int(Q[window(history)].argmax())
# in: tuples in a dictionary
# - return lambda history: int(values(history[-5:]).argmax())
# + return Q

# %% the window moves too early
# slow
# says: the value of the *next* window moves: keep the old one, in which the action was taken, until the update is done
# in: tuples in a dictionary
# - w2 = (w + (a, o))[-5:]
# + w2 = w = (w + (a, o))[-5:]

# %% a window that is emptied after terminated ends alone
# slow
# says: an episode that was truncated leaves its window to the next one: empty it after `truncated`, too
# in: tuples in a dictionary
# - o, _ = environment.reset()
# - w = (o,)
# + o, _ = environment.reset()
# + w = (o,) if terminated else (*w[:-1], o)[-5:]

# %% filled up by the program, and not by its policy
# slow
# says: does this policy look up the end of the history that it is given, and a short one as your program does itself
# in: numbered rows, filled up
# - window = Window(n, m, history[0])
# + window = Window(n, m, 0)

# %% a new generator in each episode
# slow
# says: So it seldom tries an action at random: is ε that of the text to the last step, and rng made once?
# in: tuples in a dictionary
# - o, _ = environment.reset()
# + (o, _), rng = environment.reset(), np.random.default_rng(seed)

# %% the window goes on after a reset
# slow
# says: after a reset the window stays as it is, and the first action hangs on the old episode: begin the window anew, with the observation that reset() gives
# in: tuples in a dictionary
# - o, _ = environment.reset()
# - w = (o,)
# + environment.reset()
