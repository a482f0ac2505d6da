# %% one digit
# says: Right: just above -37. The estimate of the lesson gives -30, since it looks at the last step alone. The safe run
#   slips too, and for one step more.
negative_reward = -36.9

# %% by bisection
low, high = -100.0, -10.0
while high - low > 0.01:
    middle = (low + high) / 2
    if len(exact.best_run(0.1, negative_reward=middle)) == 5:
        high = middle
    else:
        low = middle
negative_reward = high

# %% by the switch
# slow
negative_reward = -38.0
while exact.switch(finite_model(make_mdp("Roadrunner", negative_reward=negative_reward))) < 0.1:
    negative_reward += 0.1

# %% with two digits
# slow
negative_reward = -40.0
while len(exact.best_run(0.1, negative_reward=negative_reward)) > 5:
    negative_reward = round(negative_reward + 0.01, 2)

# %% as exactly as it goes
low, high = -100.0, -10.0
for _ in range(50):
    middle = (low + high) / 2
    low, high = (low, middle) if len(exact.best_run(0.1, negative_reward=middle)) == 5 else (middle, high)
negative_reward = high
