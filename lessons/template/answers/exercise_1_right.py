# %% read from the figure
# says: Right: three steps cost 1 each, and the last one pays 1.
best_return = -2

# %% computed
best_return = value_iteration(finite_model(make_mdp("Roadrunner"))).start
