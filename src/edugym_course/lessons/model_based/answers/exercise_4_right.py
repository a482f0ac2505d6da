# %% a smaller rate
# slow
# says: Right. Share of evaluation episodes that reach the goal, in the second half of training: Q-learning 0.00,
#   Dyna-10 0.00, mine 0.50. A learning rate of 1 with sampled updates fails on slippery ice: each value keeps only the
#   last outcome. Expected updates, or a lower rate, average over all of them.
lake_results = repeat(
    lake,
    {**methods, "mine": partial(DynaQ.create, learning_rate=0.1, planning_steps=10)},
    3_000,
    repetitions=5,
    evaluation_episodes=10,
)

# %% two of one's own
# slow
lake_results = repeat(
    lake,
    {
        **methods,
        "one": partial(DynaQ.create, learning_rate=0.1, planning_steps=5),
        "two": partial(QLearning.create, learning_rate=0.1),
    },
    3_000,
    repetitions=5,
    evaluation_episodes=10,
)

# %% the id and its parameters
# slow
lake_results = repeat(
    "FrozenLake-v1",
    {**methods, "mine": partial(DynaQ.create, learning_rate=1.0, planning_steps=10, expected_updates=True)},
    3_000,
    repetitions=5,
    evaluation_episodes=10,
    parameters={"map_name": "4x4", "is_slippery": True},
)

# %% the usual lake, which is that one
# slow
# in: a smaller rate
# - lake,
# + gym.make("FrozenLake-v1"),
