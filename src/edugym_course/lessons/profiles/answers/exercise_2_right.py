# %% does not look ahead
# slow
# says: That is the hole: as good as Q-learning in Tamagotchi, and no good in Study.
def make_mine(environment):
    return QLearning.create(environment, discount=0)


# %% another agent that does not look ahead
# slow
def make_mine(environment):
    return SARSA.create(environment, discount=0.0)
