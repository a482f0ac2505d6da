# %% as many days as there are
# says: Right: its targets are made of rewards alone, and it takes no random action. See it race:
def quiet(study):
    return NStepSARSA.create(study, n=10, learning_rate=0.1, discount=1.0, exploration=EpsilonGreedy(0.0))


# %% the greedy strategy
def quiet(study):
    return NStepSARSA.create(study, n=math.inf, learning_rate=0.1, discount=1, exploration=Greedy())


# %% infinity of NumPy and of float
def quiet(study):
    return NStepSARSA.create(study, n=np.inf, learning_rate=1 / 10, discount=1.0, exploration=EpsilonGreedy(epsilon=0))


# %% more steps than there are
def quiet(study):
    return NStepSARSA.create(study, n=1000, learning_rate=0.1, discount=1.0, exploration=EpsilonGreedy(0.0))


# %% by the lesson's own maker
quiet = methods.maker(math.inf, epsilon=0.0)

# %% partial
quiet = partial(
    NStepSARSA.create, n=float("inf"), learning_rate=0.1, discount=1.0, exploration=EpsilonGreedy(0.0), longest=10
)


# %% by _replace
def quiet(study):
    agent = NStepSARSA.create(study, n=math.inf, discount=1.0)
    return agent._replace(exploration=EpsilonGreedy(0.0))


# %% settings in a dictionary
settings = {"n": math.inf, "learning_rate": 0.1, "discount": 1.0}
quiet = lambda task: NStepSARSA.create(task, exploration=EpsilonGreedy(0.0), **settings)
