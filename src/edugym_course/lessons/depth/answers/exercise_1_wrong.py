# %% n left out
# slow
# says: its targets have 4 rewards
# says: the quiet agent should be that of the experiment, but
def quiet(study):
    return NStepSARSA.create(study, learning_rate=0.1, discount=1.0, exploration=EpsilonGreedy(0.0))


# %% one step
# slow
# says: its targets have 1 reward, and Monte Carlo has n=math.inf
def quiet(study):
    return NStepSARSA.create(study, n=1, learning_rate=0.1, discount=1.0, exploration=EpsilonGreedy(0.0))


# %% discount left out
# says: a discount of 0.99, and it should be 1
# says: it has a discount of
def quiet(study):
    return NStepSARSA.create(study, n=math.inf, learning_rate=0.1, exploration=EpsilonGreedy(0.0))


# %% another learning rate
# says: a learning rate of 0.01, and it should be 0.1
# says: it has a learning rate of
def quiet(study):
    return NStepSARSA.create(study, n=math.inf, learning_rate=0.01, discount=1.0, exploration=EpsilonGreedy(0.0))


# %% still exploring
# says: ε should be 0, but it is 0.1
# says: the quiet agent never explores, so ε should be 0, but it is
def quiet(study):
    return NStepSARSA.create(study, n=math.inf, learning_rate=0.1, discount=1.0)


# %% softmax
# says: act(state, rng)
# says: act(state, rng), where state = 1
# says: , by chance where one action is right
def quiet(study):
    return NStepSARSA.create(study, n=math.inf, learning_rate=0.1, discount=1.0, exploration=Softmax(1.0))


# %% optimistic values
# says: every value in Q should be 0 at first, but one is 10
def quiet(study):
    return NStepSARSA.create(
        study, n=math.inf, learning_rate=0.1, discount=1.0, exploration=EpsilonGreedy(0.0), initial_value=10.0
    )


# %% called already
# says: quiet should be a function of the task
# says: the task that returns an agent
quiet = (
    NStepSARSA.create(study, n=math.inf, learning_rate=0.1, discount=1.0, exploration=EpsilonGreedy(0.0))
    if "study" in globals()
    else NStepSARSA.create((220, 5), n=math.inf)
)

# %% one agent for all
# says: two calls of quiet(study) share one table: make a new one in every call
made = NStepSARSA.create((220, 5), n=math.inf, learning_rate=0.1, discount=1.0, exploration=EpsilonGreedy(0.0))


def quiet(study):
    return made


# %% the task is ignored
# says: should have the shape (220, 2), but has (220, 5)
def quiet(study):
    return NStepSARSA.create((220, 5), n=math.inf, learning_rate=0.1, discount=1.0, exploration=EpsilonGreedy(0.0))


# %% the first of equals
# says: ties should be broken at random, and it takes the first of equals
class First(NStepSARSA):
    __slots__ = ()

    def act(self, state, rng):
        return int(np.flatnonzero(self.Q[state] == self.Q[state].max())[0])


def quiet(study):
    return First.create(study, n=math.inf, learning_rate=0.1, discount=1.0, exploration=EpsilonGreedy(0.0))


# %% the last of equals
# says: ties should be broken at random, and it takes the last of equals
class Last(NStepSARSA):
    __slots__ = ()

    def act(self, state, rng):
        return int(np.flatnonzero(self.Q[state] == self.Q[state].max())[-1])


def quiet(study):
    return Last.create(study, n=math.inf, learning_rate=0.1, discount=1.0, exploration=EpsilonGreedy(0.0))


# %% an unusual rate
# says: after two equal episodes with rewards
# says: , the value of the first action should be
# says: : that is no n-step SARSA with a usual learning rate
def quiet(study):
    return NStepSARSA.create(study, n=math.inf, learning_rate=0.37, discount=1.0, exploration=EpsilonGreedy(0.0))


# %% infinity without math
# says: name 'inf' is not defined (infinity is math.inf)
def quiet(study):
    return NStepSARSA.create(study, n=inf, learning_rate=0.1, discount=1.0, exploration=EpsilonGreedy(0.0))


# %% at random
# says: it acts at random
class AtRandom(NStepSARSA):
    __slots__ = ()

    def act(self, state, rng):
        return int(rng.integers(self.Q.shape[1]))


def quiet(study):
    return AtRandom.create(study, n=math.inf, learning_rate=0.1, discount=1.0, exploration=EpsilonGreedy(0.0))


# %% learning rate and discount change places
# says: the learning rate and the discount have changed places: learning_rate=0.1 and discount=1
def quiet(study):
    return NStepSARSA.create(study, n=math.inf, learning_rate=1.0, discount=0.1, exploration=EpsilonGreedy(0.0))
