# %% nothing
# says: Not solved yet
frozen = None

# %% three methods
# says: frozen should have a fourth method, your own, beside the three of the lesson
frozen = repeat(lake, METHODS, 20_000, repetitions=5)

# %% one of the three again
# says: 'novelty reward' and 'mine' are the same agent
frozen = repeat(lake, {**METHODS, "mine": METHODS["novelty reward"]}, 20_000, repetitions=5)

# %% one agent under four names
# says: 'ε-greedy' and 'novelty reward' are the same agent
frozen = repeat(lake, {label: QLearning.create for label in [*METHODS, "mine"]}, 20_000, repetitions=5)

# %% only the final returns
# says: should be what `repeat(...)` returns, but is of the type ndarray
frozen = repeat(lake, {**METHODS, "mine": QLearning.create}, 20_000, repetitions=5).final("mine")


# %% an experiment for each method
# says: is of the type dict: one call takes all methods, in one dictionary
lake = gym.make("FrozenLake-v1", map_name="8x8", is_slippery=False)
methods = {**METHODS, "short": lambda lake: GoExplore.create(lake, explore_steps=5)}
frozen = {name: repeat(lake, {name: make}, 20_000, repetitions=5) for name, make in methods.items()}
