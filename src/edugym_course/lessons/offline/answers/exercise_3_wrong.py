# %% a bonus
# says: the penalty is added; that is a bonus, which draws to what is known badly, as when exploring
# in: lists of targets
# - new[pair] = max(lowest, np.mean(values) - penalty / np.sqrt(len(values)))
# + new[pair] = max(lowest, np.mean(values) + penalty / np.sqrt(len(values)))

# %% over n
# says: the penalty is divided by n; the error of a mean goes down with √n
# in: lists of targets
# - new[pair] = max(lowest, np.mean(values) - penalty / np.sqrt(len(values)))
# + new[pair] = max(lowest, np.mean(values) - penalty / len(values))

# %% always the same
# says: the penalty does not get smaller with n
# in: lists of targets
# - new[pair] = max(lowest, np.mean(values) - penalty / np.sqrt(len(values)))
# + new[pair] = max(lowest, np.mean(values) - penalty)

# %% times the root
# says: the penalty is multiplied by √n; what is known well should cost less
# in: lists of targets
# - new[pair] = max(lowest, np.mean(values) - penalty / np.sqrt(len(values)))
# + new[pair] = max(lowest, np.mean(values) - penalty * np.sqrt(len(values)))

# %% no penalty
# says: the penalty is left out: that is fitted Q as it is, with the lowest value for what is unseen
# in: lists of targets
# - new[pair] = max(lowest, np.mean(values) - penalty / np.sqrt(len(values)))
# + new[pair] = max(lowest, np.mean(values))

# %% counts of states
# says: n counts all steps from the state; it counts those with this action
# in: sums and counts
# - n = np.maximum(counts, 1)
# - return np.where(counts > 0, np.maximum(lowest, sums / n - penalty / n**0.5), lowest)
# + n = np.maximum(counts, 1)
# + m = np.maximum(counts.sum(axis=1, keepdims=True), 1)
# + return np.where(counts > 0, np.maximum(lowest, sums / n - penalty / m**0.5), lowest)

# %% a sum
# says: the targets are added up; fit their mean
# in: lists of targets
# - new[pair] = max(lowest, np.mean(values) - penalty / np.sqrt(len(values)))
# + new[pair] = max(lowest, sum(values) - penalty / np.sqrt(len(values)))

# %% the last one
# says: the last target of each pair stays; fit the mean of all of them
# in: lists of targets
# - new[pair] = max(lowest, np.mean(values) - penalty / np.sqrt(len(values)))
# + new[pair] = max(lowest, values[-1] - penalty / np.sqrt(len(values)))

# %% the best one
# says: the best target of each pair stays; fit the mean of all of them
# in: lists of targets
# - new[pair] = max(lowest, np.mean(values) - penalty / np.sqrt(len(values)))
# + new[pair] = max(lowest, max(values) - penalty / np.sqrt(len(values)))

# %% zeros
# says: pairs without a step are 0; a pessimist gives them the lowest value
# in: lists of targets
# - new = np.full(Q.shape, float(lowest))
# + new = np.zeros(Q.shape)

# %% as before
# says: pairs without a step keep their value; a pessimist gives them the lowest value
# in: lists of targets
# - new = np.full(Q.shape, float(lowest))
# + new = Q.copy()

# %% penalty alone
# says: pairs without a step get the penalty as a value; a pessimist gives them the lowest value
# in: lists of targets
# - new = np.full(Q.shape, float(lowest))
# + new = np.full(Q.shape, -penalty)

# %% no floor
# says: some values are below the lowest one there is
# in: lists of targets
# - new[pair] = max(lowest, np.mean(values) - penalty / np.sqrt(len(values)))
# + new[pair] = np.mean(values) - penalty / np.sqrt(len(values))

# %% beyond the end
# says: what comes after the end is counted: where `terminated` is True the target is the reward alone
# in: lists of targets
# - target = reward if terminated else reward + Q[next_state].max()
# + target = reward + Q[next_state].max()

# %% nothing comes
# says: what comes after a step is left out: where the task goes on, add the largest value of the next state
# in: lists of targets
# - target = reward if terminated else reward + Q[next_state].max()
# + target = reward

# %% the mean value
# says: the next state counts with its mean value; take the largest
# in: lists of targets
# - target = reward if terminated else reward + Q[next_state].max()
# + target = reward if terminated else reward + Q[next_state].mean()

# %% the same action
# says: the next state counts with the value of the same action; take the largest
# in: lists of targets
# - target = reward if terminated else reward + Q[next_state].max()
# + target = reward if terminated else reward + Q[next_state, action]

# %% in place
# says: changes the table Q that it is given: all targets need the old one, so make a new one
# in: lists of targets
# - new = np.full(Q.shape, float(lowest))
# + new = Q
# + new[:] = lowest

# %% the steps
# says: changes the steps that it is given, which others may still need
# in: lists of targets
# - targets = {}
# + targets = {}
# + steps.sort()

# %% one number
# says: should give an array of shape (3, 2), but gives one of shape ()
# in: lists of targets
# - return new
# + return new.max()

# %% a table
# says: steps, Q, penalty and lowest
pessimistic_sweep = np.zeros((3, 2))

# %% a root of both
# says: the penalty is under the root, too; only n is
# in: lists of targets
# - new[pair] = max(lowest, np.mean(values) - penalty / np.sqrt(len(values)))
# + new[pair] = max(lowest, np.mean(values) - np.sqrt(penalty / len(values)))

# %% the last reward lost
# says: the reward of the last step is lost: where `terminated` is True it is the target
# in: lists of targets
# - target = reward if terminated else reward + Q[next_state].max()
# + target = 0.0 if terminated else reward + Q[next_state].max()

# %% ends left out
# says: steps that end are left out; their target is the reward alone
# in: lists of targets
# - target = reward if terminated else reward + Q[next_state].max()
# + if terminated:
# +     continue
# + target = reward if terminated else reward + Q[next_state].max()

# %% the state itself
# says: that is the largest value of the state itself; take that of the *next* state
# in: lists of targets
# - target = reward if terminated else reward + Q[next_state].max()
# + target = reward if terminated else reward + Q[state].max()

# %% the smaller
# says: of the value and the lowest one it takes the smaller; max(...) takes the larger
# in: lists of targets
# - new[pair] = max(lowest, np.mean(values) - penalty / np.sqrt(len(values)))
# + new[pair] = min(lowest, np.mean(values) - penalty / np.sqrt(len(values)))

# %% all steps
# says: n counts all steps that there are; it counts those of the pair
# in: lists of targets
# - new[pair] = max(lowest, np.mean(values) - penalty / np.sqrt(len(values)))
# + new[pair] = max(lowest, np.mean(values) - penalty / np.sqrt(len(steps)))

# %% whole numbers
# says: is it rounded, or stored in an array of whole numbers? An array of floats, as of np.zeros(...), keeps what is behind the decimal point
# in: lists of targets
# - return new
# + return new.astype(int)

# %% a search from 0
# says: the search for the largest value starts at 0, and all may be lower: start at -math.inf
# says: the search for the largest value starts at
# says: , and all may be lower: start at -math.inf
# in: lists of targets
# - target = reward if terminated else reward + Q[next_state].max()
# + target = reward if terminated else reward + max(0, *Q[next_state])

# %% the smallest
# says: the next state counts with its smallest value; take the largest
# in: lists of targets
# - target = reward if terminated else reward + Q[next_state].max()
# + target = reward if terminated else reward + Q[next_state].min()

# %% the worst target
# says: the worst target of each pair stays; fit the mean of all of them
# in: lists of targets
# - new[pair] = max(lowest, np.mean(values) - penalty / np.sqrt(len(values)))
# + new[pair] = max(lowest, min(values) - penalty / np.sqrt(len(values)))

# %% the median
# says: the median of the targets is fitted; fit their mean
# in: lists of targets
# - new[pair] = max(lowest, np.mean(values) - penalty / np.sqrt(len(values)))
# + new[pair] = max(lowest, np.median(values) - penalty / np.sqrt(len(values)))

# %% one more step
# says: pairs with no step are right, so look at those with one step that ends or with one step that goes on or with several steps
# says: pairs with
# says: are right, so look at those with
# says: one step that ends
# says: one step that goes on
# says: several steps
# says: or with
# in: lists of targets
# - new[pair] = max(lowest, np.mean(values) - penalty / np.sqrt(len(values)))
# + new[pair] = max(lowest, np.mean(values) - penalty / np.sqrt(len(values) + 1))

# %% each target above the lowest
# says: each target is held above the lowest value; only their mean, less the penalty, is
# in: lists of targets
# - new[pair] = max(lowest, np.mean(values) - penalty / np.sqrt(len(values)))
# + new[pair] = np.mean([max(lowest, value - penalty / np.sqrt(len(values))) for value in values])

# %% each target above the lowest, before the mean
# says: each target is held above the lowest value; only what comes of their mean is
# in: lists of targets
# - targets.setdefault((state, action), []).append(target)
# + targets.setdefault((state, action), []).append(max(lowest, target))

# %% a table of whole numbers
# says: is it rounded, or stored in an array of whole numbers? An array of floats
# in: lists of targets
# - new = np.full(Q.shape, float(lowest))
# + new = np.full(Q.shape, lowest)


# %% values of the same sweep
# says: some targets use values that this sweep has already changed: they all need those of the table before it
def pessimistic_sweep(steps, Q, penalty, lowest):
    Q = Q.copy()
    for state in range(len(Q)):
        for action in range(Q.shape[1]):
            mine = [step for step in steps if step[:2] == (state, action)]
            targets = [reward + (0 if over else Q[after].max()) for _, _, reward, after, over in mine]
            n = len(targets)
            Q[state, action] = max(lowest, sum(targets) / n - penalty / n**0.5) if n else lowest
    return Q
