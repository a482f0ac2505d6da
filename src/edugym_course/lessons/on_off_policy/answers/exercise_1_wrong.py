# %% nothing was done
# says: that is the value with which the cell began
negative_reward = -100.0

# %% the placeholder
# says: Not solved yet
negative_reward = ...

# %% rounded, to where the safe run is the best
# says: takes 5 steps: that is too low, by a little: take the next higher tenth
negative_reward = -37

# %% the estimate
# says: that is the estimate 3/ε, which leaves out all slips but the last; let best_run work it out exactly
negative_reward = -30.0

# %% a slip is always deadly
# says: that is 1/ε; a random action is the deadly one in only one of three cases, and the rest of the run slips too
negative_reward = -1 / 0.1

# %% no minus, and the right tenth
# says: negative_reward = 36.9: a fall is no gain, so the number must be negative
negative_reward = 36.9

# %% far too low
# says: is below -1 000 000
# says: too low, and the fast run of 4 steps should be best
negative_reward = -1e9

# %% rounded to fives
# says: takes 4 steps
# says: higher than it need be
negative_reward = -35

# %% half a point off
# says: ; you are close, look at every tenth
negative_reward = -36.5

# %% the change of the path
# slow
# says: there the *path* of the safe run changes; the number of its steps changes elsewhere
negative_reward = -100.0
while exact.best_run(0.1, negative_reward=negative_reward)[2] == (2, 1):
    negative_reward += 0.1


# %% all rewards for which the fast run is the best
# says: should be one number, but is a
negative_reward = [-36.9, -36.8, -36.7]


# %% in steps of 0.05
# slow
# says: with negative_reward = -36.95 the best run at ε = 0.1 takes 4 steps
# says: , and so it does for lower numbers: with more digits than one, take the lowest that has them
negative_reward = -38.0
while exact.switch(finite_model(make_mdp("Roadrunner", negative_reward=negative_reward))) < 0.1:
    negative_reward += 0.05

# %% between two tenths
# says: with negative_reward = -36.94 the best run at ε = 0.1 takes 4 steps
negative_reward = -36.94


# %% a fall costs no more than a step
# says: stalls at once
negative_reward = -1.0
