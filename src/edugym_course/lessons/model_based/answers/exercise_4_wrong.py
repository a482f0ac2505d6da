# %% more sampled updates
# slow
# says: it has a learning rate of 1 and sampled updates, so that a value is whatever the last outcome said, however many
#   updates it makes
# says: Share of evaluation episodes that reach the goal, in the second half of training:
# in: a smaller rate
# - {**methods, "mine": partial(DynaQ.create, learning_rate=0.1, planning_steps=10)},
# + {**methods, "mine": partial(DynaQ.create, planning_steps=20, learning_rate=1.0)},


# %% no model
# slow
# says: should plan, and 'mine' learns from real steps alone
# says: the third method should plan, and
# in: a smaller rate
# - {**methods, "mine": partial(DynaQ.create, learning_rate=0.1, planning_steps=10)},
# + {**methods, "mine": partial(QLearning.create, learning_rate=0.5)},


# %% no planning steps
# slow
# says: learns from real steps alone: make it with DynaQ, PrioritisedSweeping or RMax, and let `planning_steps` be above
#   0
# in: a smaller rate
# - {**methods, "mine": partial(DynaQ.create, learning_rate=0.1, planning_steps=10)},
# + {**methods, "mine": partial(DynaQ.create, learning_rate=0.5, planning_steps=0)},


# %% a rate of nearly 1
# slow
# says: let each value average over many outcomes, by expected updates or by a learning rate such as 0.1
# in: a smaller rate
# - {**methods, "mine": partial(DynaQ.create, learning_rate=0.1, planning_steps=10)},
# + {**methods, "mine": partial(DynaQ.create, learning_rate=0.95)},


# %% two methods
# says: lake_results should have a third method, your own, beside the two of the lesson
lake_results = repeat(lake, methods, 3_000, repetitions=5, evaluation_episodes=10)

# %% one of the two again
# says: are the same agent
lake_results = repeat(lake, {**methods, "mine": methods["Dyna-10"]}, 3_000, repetitions=5, evaluation_episodes=10)

# %% one evaluation episode
# slow
# says: should be an experiment with evaluation_episodes 10, but it has evaluation_episodes 1
lake_results = repeat(
    lake,
    {**methods, "mine": partial(DynaQ.create, learning_rate=1.0, planning_steps=10, expected_updates=True)},
    3_000,
    repetitions=5,
)

# %% R-max after one try
# slow
# says: with known_after=
# says: it estimates each probability from so few tries; on slippery ice an action needs more
lake_results = repeat(
    lake, {**methods, "mine": partial(RMax.create, planning_steps=20)}, 3_000, repetitions=5, evaluation_episodes=10
)

# %% a short sight
# slow
# says: its values average over many outcomes already, so look at its other settings: a discount far below 1 hides a goal
#   that is some steps away; a tiny learning rate takes long, and so do few updates, and many tries before a pair is known
# in: a smaller rate
# - {**methods, "mine": partial(DynaQ.create, learning_rate=0.1, planning_steps=10)},
# + {**methods, "mine": partial(DynaQ.create, planning_steps=2, learning_rate=0.1, discount=0.1)},

# %% a lake without holes
# says: should be an experiment with desc None, but it has desc ["SFFF", "FFFF", "FFFF", "FFFG"]
lake = gym.make("FrozenLake-v1", desc=["SFFF", "FFFF", "FFFF", "FFFG"], is_slippery=True)
lake_results = repeat(lake, methods, 3_000, repetitions=5, evaluation_episodes=10)

# %% a larger lake
# says: should be an experiment with map_name 4x4, but it has map_name 8x8
lake = gym.make("FrozenLake-v1", map_name="8x8", is_slippery=True)
lake_results = repeat(lake, methods, 3_000, repetitions=5, evaluation_episodes=10)


# %% one of one's own that learns from the last outcome
# slow
# says: does each value average over many outcomes, by expected updates or by a learning rate such as 0.1? Over all of
#   them, those that end the episode too? And does it make enough updates?
class Mine(NamedTuple):
    Q: np.ndarray

    def learn(self, state, action, reward, next_state, terminated):
        self.Q[state, action] = reward + (0.0 if terminated else 0.99 * self.Q[next_state].max())

    def act(self, state, rng):
        return int(self.Q[state].argmax())


lake_results = repeat(
    lake, {**methods, "mine": lambda lake: Mine(np.zeros((16, 4)))}, 3_000, repetitions=5, evaluation_episodes=10
)
