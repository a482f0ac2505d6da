# %% only the arm
# says: H should become [
# says: only the arm that was pulled moves; all others move the other way
def gradient_update(H, arm, reward, mean, learning_rate):
    pi = np.exp(H) / sum(np.exp(H))
    H[arm] += learning_rate * (reward - mean) * (1 - pi[arm])


# %% only the others
# says: the arm that was pulled does not move
# in: arm by arm
# - H[a] = H[a] + learning_rate * (reward - mean) * (1 - pi[a])
# + pass

# %% no probabilities
# says: π is left out: only the arm that was pulled moves, by a whole step
# in: with an indicator
# - H += learning_rate * (reward - mean) * (indicator - pi)
# + H += learning_rate * (reward - mean) * indicator

# %% no indicator
# says: 1{a = A} is left out, which is 1 for the arm that was pulled
# in: with an indicator
# - H += learning_rate * (reward - mean) * (indicator - pi)
# + H -= learning_rate * (reward - mean) * pi

# %% all move up
# says: the other arms move in the direction of the one that was pulled
# in: arm by arm
# - H[a] = H[a] - learning_rate * (reward - mean) * pi[a]
# + H[a] = H[a] + learning_rate * (reward - mean) * pi[a]

# %% the probability of the arm
# says: all others move by the probability of the arm that was pulled; each moves by its own
# in: arm by arm
# - H[a] = H[a] - learning_rate * (reward - mean) * pi[a]
# + H[a] = H[a] - learning_rate * (reward - mean) * pi[arm]

# %% a whole step
# says: the arm that was pulled moves by a whole step; it moves by 1 − π(A)
# in: arm by arm
# - H[a] = H[a] + learning_rate * (reward - mean) * (1 - pi[a])
# + H[a] = H[a] + learning_rate * (reward - mean)

# %% no exponential
# says: π is H divided by its sum; it is e to the power of H, divided by the sum of that
# in: with an indicator
# - pi = np.exp(H) / sum(np.exp(H))
# + pi = H / sum(H) if sum(H) else H

# %% not divided
# says: e to the power of H is not divided by its sum
# in: with an indicator
# - pi = np.exp(H) / sum(np.exp(H))
# + pi = np.exp(H)

# %% all equal
# says: all arms count as equally probable; π follows from H
# in: with an indicator
# - pi = np.exp(H) / sum(np.exp(H))
# + pi = np.ones(len(H)) / len(H)

# %% no mean
# says: the mean reward is left out
# in: with an indicator
# - H += learning_rate * (reward - mean) * (indicator - pi)
# + H += learning_rate * reward * (indicator - pi)

# %% the mean is added
# says: the mean reward is added; subtract it
# in: with an indicator
# - H += learning_rate * (reward - mean) * (indicator - pi)
# + H += learning_rate * (reward + mean) * (indicator - pi)

# %% the preference in place of the mean
# says: the preference of the arm stands in place of the mean reward
# in: with an indicator
# - H += learning_rate * (reward - mean) * (indicator - pi)
# + H += learning_rate * (reward - H[arm]) * (indicator - pi)

# %% the sign
# says: the sign is wrong: after a good reward the arm gets rarer
# in: with an indicator
# - H += learning_rate * (reward - mean) * (indicator - pi)
# + H -= learning_rate * (reward - mean) * (indicator - pi)

# %% no learning rate
# says: the learning rate is left out
# in: with an indicator
# - H += learning_rate * (reward - mean) * (indicator - pi)
# + H += (reward - mean) * (indicator - pi)

# %% a new array
# says: is what it was before: change the array in place, as in H += ..., and return nothing; H = H + ... makes a new array, which nobody sees
# in: with an indicator
# - H += learning_rate * (reward - mean) * (indicator - pi)
# + H = H + learning_rate * (reward - mean) * (indicator - pi)

# %% a number
# says: H, arm, reward, mean and learning_rate
gradient_update = 0.1


# %% back again
# says: the arm that was pulled moves back again by π(A): its change is 1 − π(A) in all
def gradient_update(H, arm, reward, mean, learning_rate):
    pi = np.exp(H) / sum(np.exp(H))
    H[arm] += learning_rate * (reward - mean) * (1 - pi[arm])
    for a in range(len(H)):
        H[a] -= learning_rate * (reward - mean) * pi[a]


# %% with new probabilities each time
# says: π is worked out again after each change; all changes follow from the preferences before
def gradient_update(H, arm, reward, mean, learning_rate):
    for a in range(len(H)):
        pi = np.exp(H) / sum(np.exp(H))
        H[a] += learning_rate * (reward - mean) * ((a == arm) - pi[a])


# %% all as if pulled
# says: each arm moves by 1 − π(a), as if it had been pulled; for the others 1{a = A} is 0
# in: with an indicator
# - H += learning_rate * (reward - mean) * (indicator - pi)
# + H += learning_rate * (reward - mean) * (1 - pi)

# %% by its probability
# says: the arm that was pulled moves by π(A); it moves by 1 − π(A)
# in: with an indicator
# - H += learning_rate * (reward - mean) * (indicator - pi)
# + H += learning_rate * (reward - mean) * (2 * indicator - 1) * pi

# %% minus H
# says: e has the power of −H; it is that of H
# in: with an indicator
# - pi = np.exp(H) / sum(np.exp(H))
# + pi = np.exp(-H) / sum(np.exp(-H))

# %% as a mean
# says: H(A) moves towards the reward, as a mean does; a preference is no mean
# in: with an indicator
# - H += learning_rate * (reward - mean) * (indicator - pi)
# + H[arm] += learning_rate * (reward - H[arm])

# %% in the place of the old
# says: the change takes the place of the old preferences; add it to them
# in: with an indicator
# - H += learning_rate * (reward - mean) * (indicator - pi)
# + H[:] = learning_rate * (reward - mean) * (indicator - pi)

# %% the logarithm
# says: none of the usual mistakes
# in: with an indicator
# - H += learning_rate * (reward - mean) * (indicator - pi)
# + H += learning_rate * (reward - mean) * np.log(pi)


# %% the pulled arm first
# says: π is worked out again after the first change; all changes follow from the preferences before
def gradient_update(H, arm, reward, mean, learning_rate):
    pi = np.exp(H) / sum(np.exp(H))
    H[arm] += learning_rate * (reward - mean) * (1 - pi[arm])
    pi = np.exp(H) / sum(np.exp(H))
    for a in range(len(H)):
        if a != arm:
            H[a] -= learning_rate * (reward - mean) * pi[a]


# %% only after good rewards
# says: a reward below the mean changes nothing; it makes the arm rarer
# in: with an indicator
# - H += learning_rate * (reward - mean) * (indicator - pi)
# + if reward > mean:
# +     H += learning_rate * (reward - mean) * (indicator - pi)

# %% the size of the difference
# says: a reward below the mean makes the arm likelier; keep the sign of R − m
# in: with an indicator
# - H += learning_rate * (reward - mean) * (indicator - pi)
# + H += learning_rate * abs(reward - mean) * (indicator - pi)

# %% without parentheses
# says: the mean is subtracted after R is multiplied by α: put parentheses around R − m
# in: with an indicator
# - H += learning_rate * (reward - mean) * (indicator - pi)
# + H += (learning_rate * reward - mean) * (indicator - pi)

# %% the likeliest arm
# says: the arm with the highest preference moves up; it is the one that was pulled
# in: with an indicator
# - indicator[arm] = 1
# + indicator[np.argmax(H)] = 1


# %% the arm first
# says: H(A) changes before π is worked out; all changes follow from the preferences before
def gradient_update(H, arm, reward, mean, learning_rate):
    step = learning_rate * (reward - mean)
    H[arm] += step
    H -= step * np.exp(H) / np.exp(H).sum()
