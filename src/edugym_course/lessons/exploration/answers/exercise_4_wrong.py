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

# %% other settings
# says: for 'ε-greedy' the learning_rate 0.5, but it has 0.1
frozen = repeat(lake, {**METHODS, "ε-greedy": QLearning.create, "mine": SARSA.create}, 20_000, repetitions=5)

# %% 20 steps
# says: n_steps 20000, but it has n_steps 20
frozen = repeat(lake, {**METHODS, "mine": QLearning.create}, 20, repetitions=5)

# %% ten repetitions
# says: repetitions 5, but it has repetitions 10
frozen = repeat(lake, {**METHODS, "mine": QLearning.create}, 20_000)

# %% the wall
# says: environment FrozenLake-v1, but it has environment
frozen = repeat("Boulder", {**METHODS, "mine": QLearning.create}, 20_000, repetitions=5)

# %% the small lake
# says: map_name 8x8, but it has map_name 4x4
lake = gym.make("FrozenLake-v1", map_name="4x4", is_slippery=False)
frozen = repeat(lake, {**METHODS, "mine": QLearning.create}, 20_000, repetitions=5)

# %% a slippery lake
# says: is_slippery False, but it has is_slippery True
lake = gym.make("FrozenLake-v1", map_name="8x8", is_slippery=True)
frozen = repeat(lake, {**METHODS, "mine": QLearning.create}, 20_000, repetitions=5)

# %% only the two favourites
# says: should have the method 'novelty reward'
frozen = repeat(lake, {label: METHODS[label] for label in ("ε-greedy", "Go-Explore")}, 20_000, repetitions=5)

# %% only the final returns
# says: should be what `repeat(...)` returns, but is of the type ndarray
frozen = repeat(lake, {**METHODS, "mine": QLearning.create}, 20_000, repetitions=5).final("mine")

# %% the table alone
# says: is of the type DataFrame
frozen = repeat(lake, {**METHODS, "mine": QLearning.create}, 20_000, repetitions=5).table

# %% the function
# says: call it
frozen = repeat

# %% the methods alone
# says: is of the type dict
frozen = {**METHODS}

# %% labels changed
# says: keep the labels
frozen = repeat(
    lake,
    {
        "greedy": METHODS["ε-greedy"],
        "novelty": METHODS["novelty reward"],
        "go": METHODS["Go-Explore"],
        "mine": QLearning.create,
    },
    20_000,
    repetitions=5,
)

# %% Go-Explore with another number of random steps
# says: explore_steps 20, but it has
frozen = repeat(
    lake,
    {
        **METHODS,
        "Go-Explore": lambda e: GoExplore.create(e, learning_rate=0.5, discount=0.9, explore_steps=40),
        "mine": QLearning.create,
    },
    20_000,
    repetitions=5,
)
