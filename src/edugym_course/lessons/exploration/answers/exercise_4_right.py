# %% a union of dictionaries
# says: Right. Runs that solve the lake: ε-greedy 0 of 5, novelty reward 0 of 5, Go-Explore 0 of 5, mine 0 of 5. The
#   novelty reward solves walls of this depth in all runs, and this lake in not all of them. The bonuses are too
#   large, as they were with γ = 0.99 on the low wall: with β = 0.1 nine of ten runs solve the lake, and all do if it has no holes.
frozen = repeat(
    lake,
    METHODS | {"mine": lambda e: QLearning.create(e, discount=0.9, initial_value=1.0)},
    20_000,
    repetitions=5,
)

# %% all labels written out
methods = {
    "mine": lambda e: GoExplore.create(e, learning_rate=0.5, discount=0.9, explore_steps=5),
    "Go-Explore": METHODS["Go-Explore"],
    "novelty reward": METHODS["novelty reward"],
    "ε-greedy": METHODS["ε-greedy"],
}
frozen = repeat(lake, methods, n_steps=20_000, repetitions=5)


# %% a function that makes the lake
def make(layout_seed):
    return gym.make("FrozenLake-v1", map_name="8x8", is_slippery=False)


frozen = repeat(make(0), {**METHODS, "mine": CountBased.create}, 20_000, repetitions=5, jobs=1)
