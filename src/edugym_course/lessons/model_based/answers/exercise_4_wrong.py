# %% more sampled updates
# says: it has a learning rate of 1 and sampled updates, so that a value is whatever the last outcome said, however many
#   updates it makes
# says: Share of evaluation episodes that reach the goal, in the second half of training:
lake_results = repeat(
    lake,
    {**methods, "mine": partial(DynaQ.create, planning_steps=20, learning_rate=1.0)},
    3_000,
    repetitions=5,
    evaluation_episodes=10,
)

# %% fewer sampled updates
# says: however many updates it makes
lake_results = repeat(
    lake,
    {**methods, "mine": partial(DynaQ.create, planning_steps=2, learning_rate=1.0)},
    3_000,
    repetitions=5,
    evaluation_episodes=10,
)

# %% no model
# says: should plan, and 'mine' learns from real steps alone
# says: the third method should plan, and
lake_results = repeat(
    lake,
    {**methods, "mine": partial(QLearning.create, learning_rate=0.5)},
    3_000,
    repetitions=5,
    evaluation_episodes=10,
)

# %% no planning steps
# says: learns from real steps alone: make it with DynaQ, PrioritisedSweeping or RMax, and let `planning_steps` be above
#   0
lake_results = repeat(
    lake,
    {**methods, "mine": partial(DynaQ.create, learning_rate=0.5, planning_steps=0)},
    3_000,
    repetitions=5,
    evaluation_episodes=10,
)

# %% a rate of nearly 1
# says: let each value average over many outcomes, by expected updates or by a learning rate such as 0.1
lake_results = repeat(
    lake,
    {**methods, "mine": partial(DynaQ.create, learning_rate=0.95)},
    3_000,
    repetitions=5,
    evaluation_episodes=10,
)

# %% nothing
# says: Not solved yet
lake_results = None

# %% the placeholder
# says: Not solved yet
lake_results = ...

# %% two methods
# says: lake_results should have a third method, your own, beside the two of the lesson
lake_results = repeat(lake, methods, 3_000, repetitions=5)

# %% one of the two again
# says: are the same agent
lake_results = repeat(lake, {**methods, "mine": methods["Dyna-10"]}, 3_000, repetitions=5, evaluation_episodes=10)

# %% only one's own
# says: keep the labels
lake_results = repeat(
    lake,
    {"mine": SARSA.create},
    3_000,
    repetitions=5,
)

# %% Dyna under another label
# says: keep the labels
lake_results = repeat(
    lake,
    {
        "Q-learning": methods["Q-learning"],
        "Dyna": methods["Dyna-10"],
        "mine": SARSA.create,
    },
    3_000,
    repetitions=5,
)

# %% other settings under the label
# says: for 'Q-learning' the learning_rate 1.0
lake_results = repeat(
    lake,
    {
        **methods,
        "Q-learning": QLearning.create,
        "mine": SARSA.create,
    },
    3_000,
    repetitions=5,
)

# %% 300 steps
# says: n_steps 3000, but it has n_steps 300
lake_results = repeat(
    lake,
    {**methods, "mine": SARSA.create},
    300,
    repetitions=5,
)

# %% ten repetitions
# says: repetitions 5, but it has repetitions 10
lake_results = repeat(lake, {**methods, "mine": SARSA.create}, 3_000)

# %% the shop
# says: environment FrozenLake-v1
lake_results = repeat(
    "Supermarket",
    {**methods, "mine": SARSA.create},
    3_000,
    repetitions=5,
)

# %% not slippery
# says: is_slippery True, but it has is_slippery False
lake = gym.make("FrozenLake-v1", map_name="4x4", is_slippery=False)
lake_results = repeat(
    lake,
    {**methods, "mine": SARSA.create},
    3_000,
    repetitions=5,
)

# %% the large lake
# says: map_name 4x4, but it has map_name 8x8
lake = gym.make("FrozenLake-v1", map_name="8x8", is_slippery=True)
lake_results = repeat(
    lake,
    {**methods, "mine": SARSA.create},
    3_000,
    repetitions=5,
)

# %% the final returns
# says: is of the type ndarray
lake_results = repeat(
    lake,
    {**methods, "mine": SARSA.create},
    3_000,
    repetitions=5,
).final("mine")

# %% the table
# says: is of the type DataFrame
lake_results = repeat(
    lake,
    {**methods, "mine": SARSA.create},
    3_000,
    repetitions=5,
).table

# %% the function
# says: call it
lake_results = repeat

# %% the methods
# says: is of the type dict
lake_results = methods
