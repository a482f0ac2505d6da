# %% no ratio
# says: ρ is left out
# in: from the end
# - value = V + rho * (reward + value - Q[state, action])
# + value = V + reward + value - Q[state, action]

# %% upside down
# says: ρ is upside down: π, the policy to be judged, goes above b, which acted
# in: from the end
# - rho = target[state, action] / behaviour[state, action]
# + rho = behaviour[state, action] / target[state, action]

# %% the largest value
# says: V(s) is the largest value of the state; π does not always take that action, so take the mean by π
# in: from the end
# - V = target[state] @ Q[state]
# + V = Q[state].max()

# %% the mean by b
# says: V(s) is the mean by b; it is π that is judged
# in: from the end
# - V = target[state] @ Q[state]
# + V = behaviour[state] @ Q[state]

# %% the action's value
# says: V(s) is the value of the action that was taken; it is the mean by π over all actions
# in: from the end
# - V = target[state] @ Q[state]
# + V = Q[state, action]

# %% no V
# says: V(s) is left out: the believed values are only taken off, and never added
# in: from the end
# - value = V + rho * (reward + value - Q[state, action])
# + value = rho * (reward + value - Q[state, action])

# %% no Q
# says: Q(s, a) is left out: then the believed values are counted, and the rewards as well
# in: from the end
# - value = V + rho * (reward + value - Q[state, action])
# + value = V + rho * (reward + value)

# %% V for Q
# says: V(s) is taken off; it is the value of the action that was taken, Q(s, a)
# in: from the end
# - value = V + rho * (reward + value - Q[state, action])
# + value = V + rho * (reward + value - V)

# %% later outside
# says: what comes later is not weighed by ρ: it belongs into the parentheses, beside the reward
# in: from the end
# - value = V + rho * (reward + value - Q[state, action])
# + value = V + rho * (reward - Q[state, action]) + value

# %% nothing later
# says: what comes later is left out
# in: from the end
# - value = V + rho * (reward + value - Q[state, action])
# + value = V + rho * (reward - Q[state, action])

# %% forwards
# says: the steps are gone through forwards; what a step is worth needs what comes after it, so begin at the end
# in: from the end
# - for state, action, reward in reversed(episode):
# + for state, action, reward in episode:

# %% in place
# says: changes something that it is given, which others may still need
# in: from the end
# - value = 0.0
# + episode.reverse()
# + episode.reverse()
# + Q -= 1.0
# + value = 0.0

# %% no return
# says: gives None: is a `return` missing?
# in: from the end
# - return value
# + print(end="")

# %% a number
# says: episode, target, behaviour and Q
doubly_robust_value = 0.5

# %% a plain mean
# says: V(s) is the plain mean of the values; each action counts as often as π takes it
# in: from the end
# - V = target[state] @ Q[state]
# + V = Q[state].mean()

# %% the reward alone
# says: ρ stands before the reward alone; it goes before the whole parentheses
# in: from the end
# - value = V + rho * (reward + value - Q[state, action])
# + value = V + rho * reward + value - Q[state, action]

# %% V in the parentheses
# says: ρ goes before V(s), too; V(s) stands in front of it
# in: from the end
# - value = V + rho * (reward + value - Q[state, action])
# + value = rho * (V + reward + value - Q[state, action])

# %% twice
# says: what comes later is counted twice: the new value takes the place of the old one
# in: from the end
# - value = V + rho * (reward + value - Q[state, action])
# + value += V + rho * (reward + value - Q[state, action])

# %% a product
# says: ρ is the product over the steps; here it is that of one step, for the value has the later ones
# in: from the end
# - value = 0.0
# + value, rho = 0.0, 1.0
# - rho = target[state, action] / behaviour[state, action]
# + rho *= target[state, action] / behaviour[state, action]

# %% one step
# says: only the last step is looked at: does a `return` stand inside the loop?
# in: from the end
# - value = V + rho * (reward + value - Q[state, action])
# + value = V + rho * (reward + value - Q[state, action])
# + return value

# %% Q outside
# says: ρ stands before the reward and what comes later; it goes before − Q(s, a), too
# in: from the end
# - value = V + rho * (reward + value - Q[state, action])
# + value = V + rho * (reward + value) - Q[state, action]

# %% importance sampling
# says: the believed values play no part: that is importance sampling
# in: from the end
# - value = V + rho * (reward + value - Q[state, action])
# + value = rho * (reward + value)

# %% less what comes later
# says: an episode of one step is right, so look at what comes later, and at where it is kept
# in: from the end
# - value = V + rho * (reward + value - Q[state, action])
# + value = V + rho * (reward - value - Q[state, action])

# %% a ratio squared
# says: that is wrong from one step on: an episode of one step is worth V(s) + ρ (R − Q(s, a))
# in: from the end
# - rho = target[state, action] / behaviour[state, action]
# + rho = (target[state, action] / behaviour[state, action]) ** 2
