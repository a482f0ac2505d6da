# %% ε-greedy
# says: 3000 steps do not reach the top: the highest place is
# says: , and at the foot of the wall it takes wrong grips as often as by chance, though it has seen which ones hold: below the top there is no reward to learn from, so remember what was tried and what held (is `state = next_state` missing?). With optimistic first values: is γ below 1, does the target have the value of the *next* state, and can the table hold fractions?
def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    s, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        a = rng.integers(len(Q[s])) if rng.random() < 0.1 else rng.choice(np.flatnonzero(Q[s] == Q[s].max()))
        s2, r, over, cut, _ = environment.step(a)
        Q[s, a] += 0.5 * (r + 0.9 * (not over) * Q[s2].max() - Q[s, a])
        s = environment.reset()[0] if over or cut else s2
    return lambda s: int(Q[s].argmax())


# %% slips on the known way
# says: of the steps begin below place 3: likely it still tries where it knows the way, at random or by a bonus, and falls; go the known way without trying, and try at its end. Or it loses the way: is what was learned kept from one episode to the next, and is a step that is truncated learned as any other?
# in: a random grip where none is known
# - a = known[s] if s in known else int(rng.integers(n_actions))
# + a = known[s] if s in known and rng.random() > 0.3 else int(rng.integers(n_actions))


# %% the wrong grip again
# says: on a wall of height 30 with 2 grips,
# says:  times, though it sends the climber to the ground every time: remember what did not hold, and try something else there (count a try where it *began*)
def my_program(environment, n_steps, seed):
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    rng = np.random.default_rng(seed)
    N = np.zeros_like(Q[:, 0])
    s, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        a = rng.integers(len(Q[s])) if rng.random() < 0.01 else rng.choice(np.flatnonzero(Q[s] == Q[s].max()))
        s2, r, over, cut, _ = environment.step(a)
        N[s2] += 1
        r += 1 / N[s2]
        Q[s, a] += 0.5 * (r + 0.9 * (not over) * Q[s2].max() - Q[s, a])
        s = environment.reset()[0] if over or cut else s2
    return lambda s: int(Q[s].argmax())


# %% the policy forgets the way
# says: , the program reached the top
# says:  times while it learned, but the policy that it returns does so in 0 of 20 climbs of
# says: steps: does it remember the way, and go it without trying anything? Did it learn fast enough (with α = 1 one try is enough), from the state that reset gives in each episode, and are all first values and bonuses below what the top brings?
# in: a random grip where none is known
# - return lambda s: known.get(s, 0)
# + return lambda s: 0

# %% two grips for three
# says: grip 2 was never tried, and no other one holds: is what was tried first preferred for ever, are the 3 grips not all counted
# in: a random grip where none is known
# - a = known[s] if s in known else int(rng.integers(n_actions))
# + a = known[s] if s in known else int(rng.integers(2))

# %% the policy seldom tries
# says: draws its actions: asked twice about one state, it gives two different actions in
# in: a random grip where none is known
# - return lambda s: known.get(s, 0)
# + return lambda s: known[s] if rng.random() > 0.1 else int(rng.integers(n_actions))

# %% the policy hardly ever tries
# says: but the policy that it returns does so in
# says:  of 20 climbs of
# in: a random grip where none is known
# - return lambda s: known.get(s, 0)
# + return lambda s: known[s] if rng.random() > 0.01 else int(rng.integers(n_actions))

# %% the policy tries
# says: draws its actions: asked twice about one state, it gives two different actions in
# in: a random grip where none is known
# - return lambda s: known.get(s, 0)
# + return lambda s: known[s] if rng.random() > 0.5 else int(rng.integers(n_actions))

# %% two grips
# says: raises IndexError
# in: a random grip where none is known
# - known, rng = {}, np.random.default_rng(seed)
# + known, tries, rng = {}, [0, 0], np.random.default_rng(seed)
# - s2, r, over, cut, _ = environment.step(a)
# + tries[a] += 1
# + s2, r, over, cut, _ = environment.step(a)

# %% reads the answer
# says: raises
# in: a random grip where none is known
# - a = known[s] if s in known else int(rng.integers(n_actions))
# + a = environment.unwrapped.mdp.grips[s]

# %% without chance, and stays
# says: grips not all counted, or does the update move another value than that of the grip taken, at the place that was left?
# in: one grip after another, without chance
# - s = environment.reset()[0] if over or cut else s2
# + s = environment.reset()[0] if over or cut else s

# %% only two grips, without chance
# says: grip 2 was never tried, and no other one holds
# in: one grip after another, without chance
# - grip[s] = (grip[s] + 1) % n_actions
# + grip[s] = 1 - grip[s]

# %% stops at the top
# says: of its 3000 steps: go on, episode after episode, until all are taken
# in: one grip after another, without chance
# - s = environment.reset()[0] if over or cut else s2
# + if over:
# +     break
# + s = environment.reset()[0] if cut else s2

# %% one step too many
# says: steps, and
# says: were asked for: 1 too many; is there a `<=` in place of `<`, or does the loop end at n_steps + 1?
# in: one grip after another, without chance
# - for _ in range(n_steps):
# + for _ in range(n_steps + 1):

# %% a policy that counts its steps
# says: the policy that my_program returns draws its actions: asked twice about one state, it gives two different actions
# in: one grip after another, without chance
# - return lambda s: grip[s]
# + calls = iter(range(10**9))
# + return lambda s: grip[next(calls) % (len(grip) - 1)]

# %% goes on from the old state
# says: , where an episode is truncated after 35 steps
# says: where no episode is truncated they do. Does it go on from the state that reset() gives, after each episode, is what was learned kept, and is a step that is truncated learned as any other, with the value of its next state? If so,
# in: one grip after another, without chance
# - s = environment.reset()[0] if over or cut else s2
# + s = s2
# + if over or cut:
# +     environment.reset()

# %% optimism and random grips
# slow
# says: on a wall of height 30 with 3 grips, where an episode is truncated after 35 steps
# in: optimism
# - a = best(s)
# + a = best(s) if rng.random() > 0.1 else int(rng.integers(len(Q[s])))

# %% the last grip is not known
# says: steps: does it remember the way, and go it without trying anything? Did it learn fast enough (with α = 1 one try is enough), from the state that reset gives in each episode, and are all first values and bonuses below what the top brings?
# in: one grip after another, without chance
# - return lambda s: grip[s]
# + return lambda s: grip[s] if s < len(grip) - 2 else 0

# %% optimism without a discount
# says: With optimistic first values: is γ below 1, does the target have the value of the *next* state, and can the table hold fractions?
# in: optimism
# - Q[s, a] = r if over else r + 0.5 * Q[s2].max()  # powers of 0.5 are exact, so that ties are ties
# + Q[s, a] = r if over else r + Q[s2].max()

# %% steps beyond the last one
# says: were asked for: 2 too many; look after *each* step whether all are taken
# says: look after *each* step whether all are taken
# in: optimism
# - for _ in range(n_steps):
# + for _ in range(n_steps + 2):
