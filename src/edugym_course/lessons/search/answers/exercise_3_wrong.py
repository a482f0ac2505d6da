# %% the mean
# says: the actions are averaged: that is the value of random play; you will take the best
# in: the solution of look_ahead
# - return max(values)
# + return sum(values) / len(values)

# %% the sum
# says: the actions are added up; you will take the best
# in: the solution of look_ahead
# - return max(values)
# + return sum(values)

# %% action 0
# says: only action 0 is looked at
# in: the solution of look_ahead
# - return max(values)
# + return values[0]

# %% the worst
# says: that is the value of the worst action
# in: the solution of look_ahead
# - return max(values)
# + return min(values)

# %% beyond the end
# says: it looks beyond the end: where `terminated` is True nothing follows
# in: the solution of look_ahead
# - future = 0.0 if terminated else look_ahead(model, next_state, depth - 1)
# + future = look_ahead(model, next_state, depth - 1)

# %% no probabilities
# says: the probabilities are left out
# in: the solution of look_ahead
# - value += probability * (reward + 0.9 * future)
# + value += reward + 0.9 * future

# %% one outcome
# says: only the first outcome of each action is looked at
# in: the solution of look_ahead
# - value += probability * (reward + 0.9 * future)
# + value += reward + 0.9 * future
# + break

# %% too far
# says: it looks one step too far: with 0 steps left the value is 0
# in: the solution of look_ahead
# - if depth == 0:
# + if depth < 0:

# %% too short
# says: it looks one step too short
# in: the solution of look_ahead
# - if depth == 0:
# + if depth == 1:

# %% no discount
# says: γ is left out
# in: the solution of look_ahead
# - value += probability * (reward + 0.9 * future)
# + value += probability * (reward + future)

# %% all discounted
# says: the first reward is discounted, too; γ only stands before what follows
# in: the solution of look_ahead
# - value += probability * (reward + 0.9 * future)
# + value += probability * 0.9 * (reward + future)

# %% the last reward alone
# says: only the last reward counts; each step's is added
# in: the solution of look_ahead
# - value += probability * (reward + 0.9 * future)
# + value += probability * ((reward if depth == 1 else 0) + 0.9 * future)

# %% no return
# says: is a `return` missing?
# in: the solution of look_ahead
# - return max(values)
# + max(values)

# %% a number
# says: model, state and depth
look_ahead = 12

# %% the last reward lost
# says: the reward of the step that ends the task is lost; only what would follow it is 0
# in: the solution of look_ahead
# - value += probability * (reward + 0.9 * future)
# + value += 0.0 if terminated else probability * (reward + 0.9 * future)

# %% from 0 on
# says: the best action is looked for from 0 on, and all may be worth less: begin with float('-inf')
# in: the solution of look_ahead
# - return max(values)
# + return max(0.0, *values)

# %% sums that go on
# says: the sum is not set back to 0 for each action
# in: the solution of look_ahead
# - for outcomes in model[state]:
# -     value = 0.0
# + value = 0.0
# + for outcomes in model[state]:

# %% probability of the reward
# says: only the reward has its probability; what follows has it, too
# in: the solution of look_ahead
# - value += probability * (reward + 0.9 * future)
# + value += probability * reward + 0.9 * future

# %% probability of the future
# says: only what follows has its probability; the reward has it, too
# in: the solution of look_ahead
# - value += probability * (reward + 0.9 * future)
# + value += reward + probability * 0.9 * future

# %% the likeliest outcome
# says: only the likeliest outcome of each action is looked at
# in: the solution of look_ahead
# - for probability, next_state, reward, terminated in outcomes:
# + for _, next_state, reward, terminated in [max(outcomes)]:
# - value += probability * (reward + 0.9 * future)
# + value += reward + 0.9 * future

# %% the best outcome
# says: the best outcome is taken; you choose the action, but chance draws the outcome
# in: the solution of look_ahead
# - value += probability * (reward + 0.9 * future)
# + values.append(reward + 0.9 * future)
# - values.append(value)
# + pass

# %% up to an end
# says: the outcomes after one that ends are left out; each has its probability
# in: the solution of look_ahead
# - value += probability * (reward + 0.9 * future)
# + value += probability * (reward + 0.9 * future)
# + if terminated:
# +     break

# %% a power of γ
# says: γ has the power of the depth; each call multiplies by it once, and that adds up
# in: the solution of look_ahead
# - value += probability * (reward + 0.9 * future)
# + value += probability * (reward + 0.9**depth * future)

# %% the shop's γ
# says: that is the γ of the shop, 0.95; the exercise has another
# in: the solution of look_ahead
# - value += probability * (reward + 0.9 * future)
# + value += probability * (reward + 0.95 * future)

# %% the number of the best action
# says: the *number* of the best action is returned; return what it is worth
# in: in one line
# - return max(action_value(outcomes) for outcomes in model[state]) if depth else 0
# + return np.argmax([action_value(outcomes) for outcomes in model[state]]) if depth else 0


# %% the same state again
# says: what follows is that of the same state again; it is that of the *next* state
def look_ahead(model, state, depth):
    if depth == 0:
        return 0.0
    return max(
        sum(p * (r + 0.9 * look_ahead(model, state, depth - 1) * (not end)) for p, _, r, end in outcomes)
        for outcomes in model[state]
    )


# %% returned at the end
# says: the reward of an outcome that ends is returned at once; it is one of several, each with its probability
def look_ahead(model, state, depth):
    if depth == 0:
        return 0
    values = []
    for outcomes in model[state]:
        value = 0
        for p, after, reward, terminated in outcomes:
            if terminated:
                return reward
            value += p * (reward + 0.9 * look_ahead(model, after, depth - 1))
        values.append(value)
    return max(values)


# %% the wrong way round
# says: something follows only where `terminated` is True; there nothing does
# in: backwards, with a table
# - sum(p * (reward + 0.9 * V[after] * (not terminated)) for p, after, reward, terminated in outcomes)
# + sum(p * (reward + 0.9 * V[after] * terminated) for p, after, reward, terminated in outcomes)


# %% the best reward
# says: the action with the best *reward* is taken; take the one with the best value, that of what follows included
def look_ahead(model, state, depth):
    if depth == 0:
        return 0
    best = max(model[state], key=lambda outcomes: sum(p * r for p, _, r, _ in outcomes))
    return sum(p * (r + 0.9 * look_ahead(model, after, depth - 1) * (not end)) for p, after, r, end in best)


# %% not added
# says: only the last outcome of each action counts: is it `=` in place of `+=`?
def look_ahead(model, state, depth):
    if depth == 0:
        return 0
    values = []
    for outcomes in model[state]:
        for p, after, reward, terminated in outcomes:
            value = p * (reward + (0 if terminated else 0.9 * look_ahead(model, after, depth - 1)))
        values.append(value)
    return max(values)


# %% the last action
# says: only the last action counts: each one overwrites those before it; keep the best
# in: in one line
# - return max(action_value(outcomes) for outcomes in model[state]) if depth else 0
# + return action_value(model[state][-1]) if depth else 0

# %% all outcomes alike
# says: all outcomes of an action count alike; each has its probability
# in: backwards, with a table
# - sum(p * (reward + 0.9 * V[after] * (not terminated)) for p, after, reward, terminated in outcomes)
# + np.mean([reward + 0.9 * V[after] * (not terminated) for p, after, reward, terminated in outcomes])


# %% an end counts in the last step only
# says: the reward of a step that ends the task is lost where it is not the last step that is looked at
def look_ahead(model, state, depth):
    if depth == 0:
        return 0.0
    values = []
    for outcomes in model[state]:
        going_on = [one for one in outcomes if depth == 1 or not one[3]]
        values.append(
            sum(p * (r + (0.0 if end else 0.9 * look_ahead(model, s, depth - 1))) for p, s, r, end in going_on)
        )
    return max(values)


# %% a step is looked at where none is left
# says: with 0 steps left the value is 0: here a step is looked at where none is left
def look_ahead(model, state, depth):
    if depth <= 1:
        return max(sum(p * r for p, s, r, end in outcomes) for outcomes in model[state])
    return max(
        sum(p * (r + (0.0 if end else 0.9 * look_ahead(model, s, depth - 1))) for p, s, r, end in outcomes)
        for outcomes in model[state]
    )


# %% a memory for states
# says: the value of a state is kept, and taken again with other steps left; it depends on both
def look_ahead(model, state, depth):
    known = {}

    def value(here, left):
        if left == 0:
            return 0.0
        if here not in known:
            known[here] = max(
                sum(p * (r + (0 if ended else 0.9 * value(after, left - 1))) for p, after, r, ended in outcomes)
                for outcomes in model[here]
            )
        return known[here]

    return value(state, depth)


# %% sweeps in place
# says: the values are overwritten while a sweep still needs the old ones; write those of a sweep into a new table
def look_ahead(model, state, depth):
    V = dict.fromkeys(model, 0.0)
    for _ in range(depth):
        for s in model:
            V[s] = max(sum(p * (r + 0.9 * V[after] * (not ended)) for p, after, r, ended in row) for row in model[s])
    return V[state]


# %% two actions
# says: only actions 0 and 1 are looked at; a state may have more
def look_ahead(model, state, depth):
    if depth == 0:
        return 0.0

    def value(action):
        rest = model[state][action]
        return sum(p * (r + (0 if ended else 0.9 * look_ahead(model, s, depth - 1))) for p, s, r, ended in rest)

    return max(value(0), value(1))
