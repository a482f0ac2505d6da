# %% one digit
# says: Right: just above -37. The estimate of the lesson gives -30, since it looks at the last step alone. The safe run
#   slips too, and for one step more.
negative_reward = -36.9

# %% two digits
negative_reward = -36.98

# %% three digits
negative_reward = -36.984

# %% by a loop downwards
R = -30.0
while len(exact.best_run(0.1, negative_reward=R - 0.1)) == 5:
    R -= 0.1
negative_reward = R

# %% by bisection
low, high = -100.0, -10.0
while high - low > 0.01:
    middle = (low + high) / 2
    if len(exact.best_run(0.1, negative_reward=middle)) == 5:
        high = middle
    else:
        low = middle
negative_reward = high

# %% over an array
values = np.arange(-45.0, -30.0, 0.1)
negative_reward = min(v for v in values if len(exact.best_run(0.1, negative_reward=v)) - 1 == 4)

# %% by the switch
negative_reward = -38.0
while exact.switch(finite_model(make_mdp("Roadrunner", negative_reward=negative_reward))) < 0.1:
    negative_reward += 0.05
