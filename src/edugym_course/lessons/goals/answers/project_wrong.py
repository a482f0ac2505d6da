# %% no hindsight
# slow
# says: there is no hindsight: nothing is learned again when an episode is over
# in: numbers for patterns
# - for s, a, s2 in episode[::-1]:
# + for s, a, s2 in []:

# %% the goal that it had
# slow
# says: the steps are learned again for the goal that the episode *had*; take what its last step achieved
# in: numbers for patterns
# - new = s2
# + new = g

# %% the goal of the first step
# slow
# says: the new goal is what the *first* step achieved, and it should be the last one
# in: numbers for patterns
# - new = s2
# + new = episode[0][2]

# %% before the last step
# slow
# says: the new goal is the pattern *before* the last step; take what this step achieved, its next state
# in: numbers for patterns
# - new = s2
# + new = episode[-1][0]

# %% the start as a goal
# slow
# says: the new goal is the pattern at the start; take what the last step achieved
# in: numbers for patterns
# - new = s2
# + new = episode[0][0]

# %% a goal for each step
# slow
# says: each step gets a goal of its own, what it achieves itself; 'final' has one for an episode
# in: numbers for patterns
# - for s, a, s2 in episode[::-1]:
# + for s, a, s2 in episode[::-1]:
# +     new = s2

# %% only where it missed
# slow
# says: only episodes that missed their goal are learned again; do so after all of them
# in: numbers for patterns
# - for s, a, s2 in episode[::-1]:
# + for s, a, s2 in episode[::-1] if truncated else []:

# %% only where it arrived
# slow
# says: only episodes that reached their goal are learned again, and they need it least
# in: numbers for patterns
# - for s, a, s2 in episode[::-1]:
# + for s, a, s2 in episode[::-1] if terminated else []:

# %% first to last
# slow
# says: the steps are learned again in the order in which they were taken; begin with the last one, so that the first hears of the goal in the same sweep
# in: numbers for patterns
# - for s, a, s2 in episode[::-1]:
# + for s, a, s2 in episode:

# %% without the last step
# slow
# says: the last step is not learned again, and it is the one that achieves the new goal
# in: numbers for patterns
# - for s, a, s2 in episode[::-1]:
# + for s, a, s2 in episode[-2::-1]:

# %% the last step alone
# slow
# says: only the last step is learned again; all of the episode should be
# in: numbers for patterns
# - for s, a, s2 in episode[::-1]:
# + for s, a, s2 in episode[-1:]:

# %% a list that grows
# slow
# says: the steps of earlier episodes are learned again too: empty the list at each reset
# in: numbers for patterns
# - episode = []
# - o, _ = environment.reset()
# + o, _ = environment.reset()

# %% old rewards
# slow
# says: rewards and ends are the old ones, of the goal that was missed; a step that achieves the new one brings 0 and ends the episode
# in: numbers for patterns
# - r = 0.0 if s2 == new else -1.0
# - target = r if s2 == new else r + 0.9 * Q[s2, new].max()
# + r = 0.0 if s2 == g else -1.0
# + target = r if s2 == g else r + 0.9 * Q[s2, new].max()

# %% paid for every step
# slow
# says: every step that is learned again is paid 0; only one that achieves the new goal is
# in: numbers for patterns
# - r = 0.0 if s2 == new else -1.0
# + r = 0.0

# %% no end at the new goal
# slow
# says: a step that achieves the new goal ends the episode: its target is the reward alone
# in: numbers for patterns
# - target = r if s2 == new else r + 0.9 * Q[s2, new].max()
# + target = r + 0.9 * Q[s2, new].max()

# %% the old goal in the maximum
# slow
# says: in hindsight the maximum is that of Q(S', G, a), and it should be that of Q(S', G', a), with the new goal
# in: numbers for patterns
# - target = r if s2 == new else r + 0.9 * Q[s2, new].max()
# + target = r if s2 == new else r + 0.9 * Q[s2, g].max()

# %% the old goal in the value
# slow
# says: in hindsight Q(S, G, A) moves, and it should be Q(S, G', A), that of the new goal
# in: numbers for patterns
# - Q[s, new, a] += 0.5 * (target - Q[s, new, a])
# + Q[s, g, a] += 0.5 * (target - Q[s, g, a])

# %% in hindsight only
# slow
# says: the steps are learned in hindsight only; learn each at once for its own goal too
# in: numbers for patterns
# - Q[s, g, a] += 0.5 * (target - Q[s, g, a])
# + pass

# %% values from 0
# slow
# says: all values start at 0, so that what was never tried looks best; they should start at −10
# in: numbers for patterns
# - Q, rng = np.full((2**n, 2**n, n), -10.0), np.random.default_rng(seed)
# + Q, rng = np.zeros((2**n, 2**n, n)), np.random.default_rng(seed)

# %% no future
# slow
# says: γ max_a Q(S', G, a) is missing in the target
# in: numbers for patterns
# - target = r if terminated else r + 0.9 * Q[s2, g].max()
# + target = r
# - target = r if s2 == new else r + 0.9 * Q[s2, new].max()
# + target = r

# %% no discount
# slow
# says: γ is about 1, and it should be 0.9
# in: numbers for patterns
# - target = r if terminated else r + 0.9 * Q[s2, g].max()
# + target = r if terminated else r + Q[s2, g].max()
# - target = r if s2 == new else r + 0.9 * Q[s2, new].max()
# + target = r if s2 == new else r + Q[s2, new].max()

# %% the whole difference
# slow
# says: the old value is lost: α is 0.5 in the text, and Q moves by a half of the difference
# in: numbers for patterns
# - Q[s, g, a] += 0.5 * (target - Q[s, g, a])
# + Q[s, g, a] = target
# - Q[s, new, a] += 0.5 * (target - Q[s, new, a])
# + Q[s, new, a] = target

# %% small steps
# slow
# says: α is about 0.05, and it should be 0.5
# in: numbers for patterns
# - Q[s, g, a] += 0.5 * (target - Q[s, g, a])
# + Q[s, g, a] += 0.05 * (target - Q[s, g, a])
# - Q[s, new, a] += 0.5 * (target - Q[s, new, a])
# + Q[s, new, a] += 0.05 * (target - Q[s, new, a])

# %% the least value
# slow
# says: low values are preferred to high ones: is there an `argmin`, or a minus sign too many, or does the value of one action stand in the place of another?
# in: numbers for patterns
# - a = int(rng.choice(np.flatnonzero(Q[s, g] == Q[s, g].max())))
# + a = int(rng.choice(np.flatnonzero(Q[s, g] == Q[s, g].min())))

# %% beyond the end
# slow
# says: the value of a state after the end is looked up; a terminal state has no future, so its target is the reward alone
# in: numbers for patterns
# - target = r if terminated else r + 0.9 * Q[s2, g].max()
# + target = r + 0.9 * Q[s2, g].max()

# %% a truncated end
# slow
# says: a truncated episode is learned as a terminated one: somebody stopped the clock, and the next state still has its value
# in: numbers for patterns
# - target = r if terminated else r + 0.9 * Q[s2, g].max()
# + target = r if terminated or truncated else r + 0.9 * Q[s2, g].max()

# %% the first of equals
# slow
# says: where several actions look best the first is taken, so it flips switch 0 for ever; draw one of them
# in: numbers for patterns
# - a = int(rng.choice(np.flatnonzero(Q[s, g] == Q[s, g].max())))
# + a = int(Q[s, g].argmax())

# %% patterns without goals
# slow
# says: the goal has no part in the values: a row of the table is a pair of a pattern and a goal
# in: numbers for patterns
# - if rng.random() < 0.1:
# + g = 0
# + if rng.random() < 0.1:
# - target = r if s2 == new else r + 0.9 * Q[s2, new].max()
# + target = r if s2 == new else r + 0.9 * Q[s2, 0].max()
# - Q[s, new, a] += 0.5 * (target - Q[s, new, a])
# + Q[s, 0, a] += 0.5 * (target - Q[s, 0, a])
# - return lambda o: int(Q[o["achieved_goal"] @ powers, o["desired_goal"] @ powers].argmax())
# + return lambda o: int(Q[o["achieved_goal"] @ powers, 0].argmax())

# %% rewards as they were
# slow
# says: a step that achieves the new goal is paid as it was, -1; it is paid 0 now
# in: numbers for patterns
# - r = 0.0 if s2 == new else -1.0
# + r = 0.0 if s2 == g else -1.0

# %% a list that grows until the goal
# slow
# says: the list of steps is emptied only where the goal was reached: empty it at each reset
# in: numbers for patterns
# - episode = []
# - o, _ = environment.reset()
# + episode = [] if terminated else episode
# + o, _ = environment.reset()

# %% the maximum of the state itself
# slow
# says: the maximum is that of the state itself: γ max_a Q(S', G, a) asks what comes next
# in: numbers for patterns
# - target = r if terminated else r + 0.9 * Q[s2, g].max()
# + target = r if terminated else r + 0.9 * Q[s, g].max()
# - target = r if s2 == new else r + 0.9 * Q[s2, new].max()
# + target = r if s2 == new else r + 0.9 * Q[s, new].max()

# %% two sweeps
# slow
# says: the steps are learned again twice over; once is enough
# in: numbers for patterns
# - for s, a, s2 in episode[::-1]:
# + for s, a, s2 in 2 * episode[::-1]:

# %% after every step
# slow
# says: the steps so far are learned again after *each* step; wait until the episode is over
# in: numbers for patterns
# - if terminated or truncated:
# -     new = s2
# -     for s, a, s2 in episode[::-1]:
# -         r = 0.0 if s2 == new else -1.0
# -         target = r if s2 == new else r + 0.9 * Q[s2, new].max()
# -         Q[s, new, a] += 0.5 * (target - Q[s, new, a])
# + new = s2
# + for s, a, s2 in episode[::-1]:
# +     r = 0.0 if s2 == new else -1.0
# +     target = r if s2 == new else r + 0.9 * Q[s2, new].max()
# +     Q[s, new, a] += 0.5 * (target - Q[s, new, a])
# + s = new
# + if terminated or truncated:

# %% the return in hindsight
# slow
# says: steps that are learned again have the return of the episode as their target; it is R + γ max_a Q(S', G, a) here too
# in: numbers for patterns
# - new = s2
# + new, target = s2, 0.0
# - target = r if s2 == new else r + 0.9 * Q[s2, new].max()
# + target = r if s2 == new else r + 0.9 * target

# %% values from −8
# slow
# says: each first value is about -8, and it should be -10
# in: numbers for patterns
# - Q, rng = np.full((2**n, 2**n, n), -10.0), np.random.default_rng(seed)
# + Q, rng = np.full((2**n, 2**n, n), -8.0), np.random.default_rng(seed)

# %% a larger discount
# slow
# says: γ is about 0.95, and it should be 0.9
# in: numbers for patterns
# - target = r if terminated else r + 0.9 * Q[s2, g].max()
# + target = r if terminated else r + 0.95 * Q[s2, g].max()
# - target = r if s2 == new else r + 0.9 * Q[s2, new].max()
# + target = r if s2 == new else r + 0.95 * Q[s2, new].max()

# %% the goals of 'future'
# slow
# says: , and the new goal: one for the whole episode, what its last step achieved
# in: numbers for patterns
# - for s, a, s2 in episode[::-1]:
# + for t, (s, a, s2) in [*enumerate(episode)][::-1]:
# +     new = episode[rng.integers(t, len(episode))][2]

# %% without the first step
# slow
# says: the first step is not learned again; all of the episode should be
# in: numbers for patterns
# - for s, a, s2 in episode[::-1]:
# + for s, a, s2 in episode[:0:-1]:

# %% one and zero
# slow
# says: steps that are learned again are paid 1 and 0; the task pays 0 at the goal and −1 elsewhere
# in: numbers for patterns
# - r = 0.0 if s2 == new else -1.0
# + r = 1.0 if s2 == new else 0.0

# %% only the last step achieves it
# slow
# says: not only the last step may achieve the new goal: compare the next state of each step with it
# in: numbers for patterns
# - for s, a, s2 in episode[::-1]:
# -     r = 0.0 if s2 == new else -1.0
# -     target = r if s2 == new else r + 0.9 * Q[s2, new].max()
# + for k, (s, a, s2) in enumerate(episode[::-1]):
# +     target = 0.0 if k == 0 else -1.0 + 0.9 * Q[s2, new].max()

# %% the goal before the state
# slow
# says: state and goal have changed places in the table where the steps are learned again
# in: numbers for patterns
# - target = r if s2 == new else r + 0.9 * Q[s2, new].max()
# - Q[s, new, a] += 0.5 * (target - Q[s, new, a])
# + target = r if s2 == new else r + 0.9 * Q[new, s2].max()
# + Q[new, s, a] += 0.5 * (target - Q[new, s, a])

# %% Q-learning without goals
# slow
# says: the goal has no part in the values, and nothing is learned again: this is the Q-learning of one goal
def my_program(environment, n_steps, seed):
    n = environment.action_space.n
    rng, Q = np.random.default_rng(seed), {}
    o, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        s = tuple(o["achieved_goal"])
        row = Q.setdefault(s, np.full(n, -10.0))
        greedy = int(rng.choice(np.flatnonzero(row == row.max())))
        a = int(rng.integers(n)) if rng.random() < 0.1 else greedy
        o, r, terminated, truncated, _ = environment.step(a)
        after = Q.setdefault(tuple(o["achieved_goal"]), np.full(n, -10.0))
        row[a] += 0.5 * (r + 0.9 * (0.0 if terminated else after.max()) - row[a])
        if terminated or truncated:
            o, _ = environment.reset()
    return lambda o: int(np.argmax(Q[tuple(o["achieved_goal"])]))


# %% goals of 'future' in place of 'final'
# slow
# says: actions of my_program are not greedy, if it learns from its steps by the equation of this lesson, and with ε = 0.1 it should be some
# in: numbers for patterns
# - for s, a, s2 in episode[::-1]:
# + for i in reversed(range(len(episode))):
# +     s, a, s2 = episode[i]
# +     new = episode[rng.integers(i, len(episode))][2]

# %% never the best one by chance
# slow
# says: or is the random action drawn among the others? (
# says: a random action may be any of them, the best one too
# in: a class
# - return int(self.rng.integers(0, self.n))
# + return int(self.rng.choice([other for other in range(self.n) if other != np.argmax(values)]))

# %% no γ in hindsight
# slow
# says: γ is missing where the steps are learned again: it is R + γ max_a Q(S', G, a) there too
# in: numbers for patterns
# - target = r if s2 == new else r + 0.9 * Q[s2, new].max()
# + target = r if s2 == new else r + Q[s2, new].max()

# %% no γ for the own goal
# slow
# says: γ is missing where a step is learned at once, for its own goal: it is R + γ max_a Q(S', G, a) there too
# in: numbers for patterns
# - target = r if terminated else r + 0.9 * Q[s2, g].max()
# + target = r if terminated else r + Q[s2, g].max()

# %% the own maximum of the state itself
# slow
# says: where a step is learned at once, for its own goal, the maximum is that of the state itself; ask what comes next
# in: numbers for patterns
# - target = r if terminated else r + 0.9 * Q[s2, g].max()
# + target = r if terminated else r + 0.9 * Q[s, g].max()

# %% the maximum of the state itself in hindsight
# slow
# says: where the steps are learned again, the maximum is that of the state itself; ask what comes next
# in: numbers for patterns
# - target = r if s2 == new else r + 0.9 * Q[s2, new].max()
# + target = r if s2 == new else r + 0.9 * Q[s, new].max()

# %% the goal of the first episode
# slow
# says: the goal is always that of the first episode: each reset gives a new one
# in: numbers for patterns
# - o, _ = environment.reset()
# - s, g = o["achieved_goal"] @ powers, o["desired_goal"] @ powers
# + o, _ = environment.reset()
# + s = o["achieved_goal"] @ powers

# %% one row for all pairs
# slow
# says: all rows of the table are one and the same list or array: make a new one for each pair
# in: a class
# - self.values = defaultdict(lambda: [-10.0] * n)
# + row = [-10.0] * n
# + self.values = defaultdict(lambda: row)
