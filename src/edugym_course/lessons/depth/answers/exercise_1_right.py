# %% as many days as there are
# says: Right: its targets are made of rewards alone, and it takes no random action. See it race:
def quiet(study):
    return NStepSARSA.create(study, n=10, learning_rate=0.1, discount=1.0, exploration=EpsilonGreedy(0.0))


# %% by the lesson's own maker
quiet = methods.maker(math.inf, epsilon=0.0)

# %% settings in a dictionary
settings = {"n": math.inf, "learning_rate": 0.1, "discount": 1.0}
quiet = lambda task: NStepSARSA.create(task, exploration=EpsilonGreedy(0.0), **settings)
