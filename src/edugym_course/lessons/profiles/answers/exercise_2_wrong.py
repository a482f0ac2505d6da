# %% nothing
# says: Not solved yet
def make_mine(environment):
    raise NotImplementedError


# %% nothing has changed
# slow
# says: : it has no hole in Study, since its score there is not surely lower by
# says: which part of the equation lets Q-learning see what comes much later?
def make_mine(environment):
    return QLearning.create(environment)


# %% hardly learns
# slow
# says: : it is worse in Tamagotchi, where it should be as good as before
def make_mine(environment):
    return QLearning.create(environment, learning_rate=0.000001)


# %% learns nothing
# slow
# says: : it is worse in both, and a hole has ground around it
def make_mine(environment):
    agent = QLearning.create(environment, discount=0.0, learning_rate=0.000001)
    return agent


# %% a learning rate that is too large for the ground
# slow
# says: : it is worse in both, and a hole has ground around it
def make_mine(environment):
    return QLearning.create(environment, discount=0.0, learning_rate=0.9)


# %% a learner that never explores and never moves
# says: make_mine
def make_mine(environment):
    QLearning.create(environment, discount=0.0)


# %% looks ahead a little
# slow
# says: its discount is low, but something of a late reward still comes through, and a greedy player asks only which value
#   is the largest, not how large it is
def make_mine(environment):
    return QLearning.create(environment, discount=0.1)


# %% no agent yet
# says: has no `act`: call it, with the environment in brackets
def make_mine(environment):
    return QLearning.create


# %% no function
# says: an environment
make_mine = "QLearning"


# %% a table for one task
# says: your agent cannot enter
def make_mine(environment):
    return QLearning.create(make_mdp("Study"), discount=0.0)


# %% high first values
# slow
# says: : there may be a hole in Study, but
# says: runs do not make it sure (95 % interval
# says: ): make it deeper
def make_mine(environment):
    return QLearning.create(environment, initial_value=100.0)
