# %% nothing is imagined
# slow
# says: nothing is planned: are the imagined steps learned from, and enough of them, each drawn anew from all that was
#   tried?
# in: a model in arrays
# - for _ in range(10):
# + for _ in range(0):

# %% pairs that nobody tried
# slow
# says: pairs are imagined that were never tried: the model knows nothing of them; in a state that was seen, draw one of the actions that were taken there
# in: a model in arrays
# - i, j = tried[rng.integers(len(tried))]
# + i, j = rng.integers(n_states), rng.integers(n_actions)

# %% rewards alone
# slow
# says: γ max_a Q(S', a) is missing in the target
# in: a model in arrays
# - Q[s, a] = r + 0.95 * (1 - terminated) * Q[s2].max()
# + Q[s, a] = r
# - Q[i, j] = R[i, j] + 0.95 * (1 - ends[i, j]) * Q[S2[i, j]].max()
# + Q[i, j] = R[i, j]

# %% looks beyond the end
# slow
# says: the value of a state after the end is looked up
# in: a model in arrays
# - Q[s, a] = r + 0.95 * (1 - terminated) * Q[s2].max()
# + Q[s, a] = r + 0.95 * Q[s2].max()
# - Q[i, j] = R[i, j] + 0.95 * (1 - ends[i, j]) * Q[S2[i, j]].max()
# + Q[i, j] = R[i, j] + 0.95 * Q[S2[i, j]].max()

# %% truncated is terminated
# slow
# says: a truncated episode is learned as a terminated one
# in: a model in arrays
# - s2, r, terminated, truncated, _ = environment.step(a)
# + s2, r, terminated, truncated, _ = environment.step(a)
# + terminated = terminated or truncated

# %% a truncated step is left out
# slow
# says: nothing is learned from a step that is truncated: it is a step like the others
# in: a model in arrays
# - Q[s, a] = r + 0.95 * (1 - terminated) * Q[s2].max()
# + if truncated:
# +     s, _ = environment.reset()
# +     continue
# + Q[s, a] = r + 0.95 * (1 - terminated) * Q[s2].max()

# %% a model of states
# slow
# says: ; the model must keep reward, next state and whether the episode ended, for each state *and* action that was tried; an imagined step brings the reward of the model; a step that is truncated is learned, kept and planned after like any other
# in: a model in arrays
# - R[s, a], S2[s, a], ends[s, a] = r, s2, terminated
# + R[s], S2[s], ends[s] = r, s2, terminated

# %% the old state after a reset
# slow
# says: after an end the program goes on from the last state of the old episode: state, info = environment.reset() gives the first state of the new one
# in: a model in arrays
# - s, _ = environment.reset()
# + environment.reset()

# %% costs
# slow
# says: low values are preferred to high ones: is there an `argmin`, or a minus sign too many, or does the value of one action stand in the place of another?
# in: a model in arrays
# - a = rng.choice(np.flatnonzero(Q[s] == Q[s].max()))
# + a = rng.choice(np.flatnonzero(Q[s] == Q[s].min()))


# %% no end in the model
# slow
# says: the value of a state after the end is looked up; a terminal state has no future, so its target is the reward alone
# in: a model in arrays
# - Q[i, j] = R[i, j] + 0.95 * (1 - ends[i, j]) * Q[S2[i, j]].max()
# + Q[i, j] = R[i, j] + 0.95 * Q[S2[i, j]].max()

# %% one imagined step
# slow
# says: in corridors of 30 cells, my_program gets to the end
# says: times in 400 steps, and with 10 imagined steps after each real one it should be some 5.8 times:
# says: imagined steps after each real one it should be some
# says:  times.
# says: Is a *new* pair drawn for each of ten imagined steps, from *all* that were tried (each action of a state, not the latest alone) and from no others?
# in: a model in arrays
# - for _ in range(10):
# + for _ in range(1):

# %% no discount
# slow
# says: γ is 0.99 or 1, and it should be 0.95, in an imagined step, too
# in: a model in arrays
# - Q[s, a] = r + 0.95 * (1 - terminated) * Q[s2].max()
# + Q[s, a] = r + (1 - terminated) * Q[s2].max()
# - Q[i, j] = R[i, j] + 0.95 * (1 - ends[i, j]) * Q[S2[i, j]].max()
# + Q[i, j] = R[i, j] + (1 - ends[i, j]) * Q[S2[i, j]].max()

# %% a discount that is too small
# slow
# says: γ is about 0.9, and it should be 0.95
# in: a model in arrays
# - Q[s, a] = r + 0.95 * (1 - terminated) * Q[s2].max()
# + Q[s, a] = r + 0.9 * (1 - terminated) * Q[s2].max()
# - Q[i, j] = R[i, j] + 0.95 * (1 - ends[i, j]) * Q[S2[i, j]].max()
# + Q[i, j] = R[i, j] + 0.9 * (1 - ends[i, j]) * Q[S2[i, j]].max()

# %% five imagined steps
# slow
# says: with 5 it is 3.7 times
# says: Is a *new* pair drawn for each of ten imagined steps, from *all* that were tried (each action of a state, not the latest alone) and from no others? Is it learned from as a real step is, with α = 1, and each real step at once, too?
# in: lists of lists
# - for k in self.rng.choice(len(memories), 10):
# + for k in self.rng.choice(len(memories), 5):

# %% a hundred imagined steps
# slow
# says: with 100 it is 9 times
# says: Does it imagine ten steps after each real one, and not a whole sweep?
# in: lists of lists
# - for k in self.rng.choice(len(memories), 10):
# + for k in self.rng.choice(len(memories), 100):

# %% one pair for all imagined steps
# slow
# says: Is a *new* pair drawn for each of ten imagined steps, from *all* that were tried (each action of a state, not the latest alone) and from no others?
# in: a model in arrays
# - for _ in range(10):
# -     i, j = tried[rng.integers(len(tried))]
# + i, j = tried[rng.integers(len(tried))]
# + for _ in range(10):

# %% a model of the latest action
# slow
# says: from *all* that were tried (each action of a state, not the latest alone)
# in: a model in arrays
# - i, j = tried[rng.integers(len(tried))]
# + i, j = tried[rng.integers(len(tried))]
# + j = next(action for state, action in reversed(tried) if state == i)

# %% real steps are only remembered
# slow
# says: and each real step at once, too?
# in: lists of lists
# - me.improve(s, a, r, s2, over)

# %% actions that nobody tried, in states that were seen
# slow
# says: in a state that was seen, draw one of the actions that were taken there
# in: a model in arrays
# - i, j = tried[rng.integers(len(tried))]
# + i, j = tried[rng.integers(len(tried))][0], rng.integers(n_actions)

# %% any pair, and nothing where it was not tried
# slow
# says: and from no others?
# in: a model in arrays
# - i, j = tried[rng.integers(len(tried))]
# + i, j = int(rng.integers(n_states)), int(rng.integers(n_actions))
# + if (i, j) not in tried:
# +     continue

# %% rewards in whole numbers
# slow
# says: what is behind the decimal point is lost: the model or the table holds whole numbers, as an array with dtype=int
#   does
# in: a model in arrays
# - R, S2, ends = np.zeros((n_states, n_actions)), np.zeros((n_states, n_actions), int), np.zeros((n_states, n_actions))
# + R, S2, ends = np.zeros((3, n_states, n_actions), int)

# %% any action of a state that was seen, and nothing where it was not tried
# slow
# says: in corridors where 30 actions can be taken, my_program gets to the end
# says: times in 250 steps, and it should be some 7 times; with 3 actions all is well. Are many of the imagined steps
#   wasted? In a state that was seen, draw one of the actions that were *taken* there: the model knows nothing of the others
# in: a model in arrays
# - i, j = tried[rng.integers(len(tried))]
# + i, j = tried[rng.integers(len(tried))][0], rng.integers(n_actions)
# + if (i, j) not in tried:
# +     continue

# %% a discount that is nearly right
# slow
# says: the equation is another one, or a number in it
# in: a model in arrays
# - Q[s, a] = r + 0.95 * (1 - terminated) * Q[s2].max()
# + Q[s, a] = r + 0.97 * (1 - terminated) * Q[s2].max()
# - Q[i, j] = R[i, j] + 0.95 * (1 - ends[i, j]) * Q[S2[i, j]].max()
# + Q[i, j] = R[i, j] + 0.97 * (1 - ends[i, j]) * Q[S2[i, j]].max()

# %% first values of one
# slow
# says: is α 1 for real and imagined steps, are the first values 0, and does the model keep what came of each pair *last*, and no older outcome?
# in: a model in arrays
# - Q = np.zeros((n_states, n_actions))
# + Q = np.ones((n_states, n_actions))

# %% the first outcome
# slow
# says: is α 1 for real and imagined steps, are the first values 0, and does the model keep what came of each pair *last*, and no older outcome?
# in: lists of lists
# - me.seen[s, a] = (r, s2, over)
# + me.seen.setdefault((s, a), (r, s2, over))

# %% a list of all steps
# slow
# says: is α 1 for real and imagined steps, are the first values 0, and does the model keep what came of each pair *last*, and no older outcome?
# in: lists of lists
# - self.seen = {}
# + self.seen = []
# - memories = list(self.seen.items())
# - for k in self.rng.choice(len(memories), 10):
# -     (s, a), what = memories[k]
# -     self.improve(s, a, *what)
# + for k in self.rng.choice(len(self.seen), 10):
# +     self.improve(*self.seen[k])
# - me.seen[s, a] = (r, s2, over)
# + me.seen.append((s, a, r, s2, over))

# %% planning goes on with the state
# slow
# says: Is each action chosen in the state that step() or reset() gave last? A loop inside the loop may have used its name.
# in: a model in arrays
# - i, j = tried[rng.integers(len(tried))]
# - Q[i, j] = R[i, j] + 0.95 * (1 - ends[i, j]) * Q[S2[i, j]].max()
# + i, j = tried[rng.integers(len(tried))]
# + s2 = S2[i, j]
# + Q[i, j] = R[i, j] + 0.95 * (1 - ends[i, j]) * Q[s2].max()

# %% the model keeps the old state
# slow
# says: the model keeps the state that was left, or an imagined step looks up its value, in place of the next one
# in: a model in arrays
# - Q[i, j] = R[i, j] + 0.95 * (1 - ends[i, j]) * Q[S2[i, j]].max()
# + Q[i, j] = R[i, j] + 0.95 * (1 - ends[i, j]) * Q[i].max()

# %% γ of the races
# slow
# says: γ is 0.99 or 1, and it should be 0.95, in an imagined step, too
# in: a model in arrays
# - Q[s, a] = r + 0.95 * (1 - terminated) * Q[s2].max()
# + Q[s, a] = r + 0.99 * (1 - terminated) * Q[s2].max()
# - Q[i, j] = R[i, j] + 0.95 * (1 - ends[i, j]) * Q[S2[i, j]].max()
# + Q[i, j] = R[i, j] + 0.99 * (1 - ends[i, j]) * Q[S2[i, j]].max()

# %% the model forgets the end, and the real step does not
# slow
# says: the value of a state after the end is looked up; a terminal state has no future, so its target is the reward alone, in an imagined step, too: the model must keep `terminated`
# says: , in an imagined step, too: the model must keep `terminated`
# in: lists of lists
# - me.seen[s, a] = (r, s2, over)
# + me.seen[s, a] = (r, s2, False)
