# %% the best action
# slow
# says: in a small game with
# says:  states, who knows the policy of
# says:  more from it in state
# says:  than from a safe one.
# says: It has no chance in it: the best action against what the other does now is known to the other, too; the policy is that of the matrix game, as solve_zero_sum finds it. (It has none either where hardly any pair of actions was tried: are some moves random?)
# in: all pairs at random
# - return lambda state: solved[state].first if state in solved else [1 / shape[1]] * shape[1]
# + return lambda state: np.eye(shape[1])[Q[state].mean(axis=1).argmax()]

# %% random play
# slow
# says: It is random play: does the policy that is returned come from what was learned, and is the last step of an episode learned from, too?
# in: all pairs at random
# - return lambda state: solved[state].first if state in solved else [1 / shape[1]] * shape[1]
# + return lambda state: [1 / shape[1]] * shape[1]

# %% the reward of the other
# slow
# says: In one room it takes the worst action: is the reward that of player_0, with its own sign, and are its actions the rows of the matrix game, and the probabilities that are returned its own?
# in: all pairs at random
# - target = rewards[me]
# + target = rewards[you]

# %% columns
# slow
# says: In one room an action is best whatever the other does, and it is not taken: are the rows of the matrix game the actions of player_0, is it the game of the state in which they acted, and does an episode begin with the state that reset gives?
# in: all pairs at random
# - solved[state] = games.solve_zero_sum(Q[state])
# + solved[state] = games.solve_zero_sum(Q[state].T)

# %% half at random
# slow
# says: Look at this state:
# says: its policy should be that of the matrix game Q[state]: is Q[state, action, other_action] moved by α (T - Q) after every pair of actions, can Q hold fractions, and is the policy returned without the random moves?
# in: all pairs at random
# - return lambda state: solved[state].first if state in solved else [1 / shape[1]] * shape[1]
# + return lambda state: 0.6 * solved[state].first + 0.4 / shape[1]

# %% reward alone
# slow
# says: it pays nothing and leads to others: the target is R + γ V(S'), with γ = 0.9, where V(S') is the value of the matrix game of S'. (Is `terminated` read by the name of a player, and is each action tried?)
# in: all pairs at random
# - target += 0.9 * value(int(seen[me]))
# + target += 0.0

# %% as if the other were kind
# slow
# says: it pays nothing and leads to others: the target is R + γ V(S'), with γ = 0.9, where V(S') is the value of the matrix game of S'. (Is `terminated` read by the name of a player, and is each action tried?)
# in: all pairs at random
# - return solved[state].value if state in solved else 0.0
# + return Q[state].max()

# %% no discount
# slow
# says: there 18.5 at once is more than 20 a step later: what follows is multiplied by γ = 0.9 (and one action of five is random, so that all are tried; and Q moves by α (T - Q))
# in: all pairs at random
# - target += 0.9 * value(int(seen[me]))
# + target += value(int(seen[me]))

# %% a reset after each step
# says: calls reset() in the middle of an episode: go on until `environment.agents` is empty
# in: all pairs at random
# - if not environment.agents:
# + if terminated:

# %% beyond the end
# slow
# says: Look at the end of an episode: after the end a number is seen that other states have, too: what comes then is worth 0, so with `terminated` the target is R alone (and elsewhere R + γ V(S'), with the value of the matrix game)
# in: all pairs at random
# - if not terminated[me]:
# -     target += 0.9 * value(int(seen[me]))
# + target += 0.9 * value(int(seen[me]))

# %% cut off is over
# slow
# says: its episodes are truncated, not terminated: the clock was stopped, and the next state still has its value, so only `terminated` makes R alone the target; and S' is what step() gave, not what reset() gives after it
# in: all pairs at random
# - if not terminated[me]:
# + if not terminated[me] and not truncated[me]:

# %% too slow
# slow
# says: After
# says: can be won. Either it learns too slowly (is the learning rate, or the share of random actions, too small, is not every *pair* of actions learned, does player_1 learn from its own reward, and play a policy of its own?), or something disturbs what it learns (is S' what step() gave last, and is the target R alone with `terminated`?)
# in: all pairs at random
# - Q[state, a, o] += 0.2 * (target - Q[state, a, o])
# + Q[state, a, o] += 0.2 * (target - Q[state, a, o]) * (rng.random() < 0.07)

# %% a number for a policy
# says: probabilities that sum to 1, one for each action, but for state
# says: : that is one action, and the probability of each is asked
# in: all pairs at random
# - return lambda state: solved[state].first if state in solved else [1 / shape[1]] * shape[1]
# + return lambda state: int(Q[state].mean(axis=1).argmax())

# %% a table for a policy
# says: should return the policy of player_0, a function from a state to the probabilities of its actions, but returns
# says: : for a table that is `lambda state: policy[state]`
# in: all pairs at random
# - return lambda state: solved[state].first if state in solved else [1 / shape[1]] * shape[1]
# + return Q

# %% one episode
# says:  steps: go on, episode after episode, until all are taken
# in: a class, lists, and player 1 who answers
# - while steps < n_steps:
# + while environment.agents:
# - if not environment.agents and steps < n_steps:
# -     observations, _ = environment.reset()

# %% no reset
# says:  takes a step where no episode is under way: call reset() at first, and whenever `environment.agents` is empty
# in: all pairs at random
# - if not environment.agents:
# -     seen, _ = environment.reset()

# %% the seed again
# says:  calls reset(seed=...) more than once: give the seed at the first reset only, and call reset() after that
# in: all pairs at random
# - seen, _ = environment.reset()
# + seen, _ = environment.reset(seed=seed)

# %% other numbers every time
# says:  does not repeat itself: two runs with seed
# says:  take different actions. Draw every random number from rng = np.random.default_rng(seed), and make all that it learns inside the function
# in: all pairs at random
# - rng = np.random.default_rng(seed)
# + rng = np.random.default_rng()

# %% twice as many steps
# says:  begins another episode after its
# says:  steps: count the steps of all episodes
# in: all pairs at random
# - for _ in range(n_steps):
# + for _ in range(2 * n_steps):

# %% one action for both
# says: actions must be a dictionary with one action for each of player_0, player_1
# in: all pairs at random
# - seen, rewards, terminated, truncated, _ = environment.step({me: a, you: o})
# + seen, rewards, terminated, truncated, _ = environment.step((a, o))

# %% an agent for a program
# says: environment, n_steps and seed
my_program = games.MinimaxQ


# %% one action by itself is what a place is worth
# slow
# says: it pays nothing and leads to others: the target is R + γ V(S'), with γ = 0.9, where V(S') is the value of the matrix game of S'. (Is `terminated` read by the name of a player, and is each action tried?)
# in: all pairs at random
# - return solved[state].value if state in solved else 0.0
# + return Q[state].min(axis=1).max()

# %% γ = 0.8
# slow
# says: there a room that costs 10 is better than 17.5 at once and then a room that costs 30: what follows is multiplied by γ = 0.9, and by no less, and it may be far below 0; and Q moves by α (T - Q)
# in: all pairs at random
# - target += 0.9 * value(int(seen[me]))
# + target += 0.8 * value(int(seen[me]))


# %% goes on from the end
# slow
# says: does an episode begin with the state that reset gives?
# in: all pairs at random
# - seen, _ = environment.reset()
# + environment.reset()


# %% γ = 0.95
# slow
# says: there 18.5 at once is more than 20 a step later: what follows is multiplied by γ = 0.9 (and one action of five is random, so that all are tried; and Q moves by α (T - Q))
# in: all pairs at random
# - target += 0.9 * value(int(seen[me]))
# + target += 0.95 * value(int(seen[me]))


# %% γ = 0.85
# slow
# says: there a room that costs 10 is better than 17.5 at once and then a room that costs 30: what follows is multiplied by γ = 0.9, and by no less, and it may be far below 0; and Q moves by α (T - Q)
# in: all pairs at random
# - target += 0.9 * value(int(seen[me]))
# + target += 0.85 * value(int(seen[me]))


# %% a place is worth what coins bring
# slow
# says: it pays nothing and leads to others: the target is R + γ V(S'), with γ = 0.9, where V(S') is the value of the matrix game of S'. (Is `terminated` read by the name of a player, and is each action tried?)
# in: all pairs at random
# - return solved[state].value if state in solved else 0.0
# + return Q[state].mean()


# %% a place is worth what is won from random play
# slow
# says: it pays nothing and leads to others: the target is R + γ V(S'), with γ = 0.9, where V(S') is the value of the matrix game of S'. (Is `terminated` read by the name of a player, and is each action tried?)
# in: all pairs at random
# - return solved[state].value if state in solved else 0.0
# + return solved[state].first @ Q[state].mean(axis=1) if state in solved else 0.0


# %% a place is worth what comes with the random moves
# slow
# says: it pays nothing and leads to others: the target is R + γ V(S'), with γ = 0.9, where V(S') is the value of the matrix game of S'. (Is `terminated` read by the name of a player, and is each action tried?)
# in: all pairs at random
# - return solved[state].value if state in solved else 0.0
# + return 0.8 * solved[state].value + 0.2 * Q[state].mean() if state in solved else 0.0


# %% a twentieth at random
# slow
# says: is the policy returned without the random moves?
# in: all pairs at random
# - return lambda state: solved[state].first if state in solved else [1 / shape[1]] * shape[1]
# + return lambda state: 0.95 * solved[state].first + 0.05 / shape[1]

# %% no seed for the environment
# says: gives no seed to its first reset, so two runs with one seed differ: begin with
# in: all pairs at random
# - seen, _ = environment.reset(seed=seed)
# + seen, _ = environment.reset()


# %% no learning rate
# slow
# says: there chance says whether an action is paid, so one reward tells little: Q moves by α (T - Q), with α about 0.2. (And does each player have as many actions as `action_space` says, and are random ones drawn among all of them?)
# in: all pairs at random
# - Q[state, a, o] += 0.2 * (target - Q[state, a, o])
# + Q[state, a, o] = target


# %% the actions of player 0 for both
# slow
# says: action 2 is not in the action space of player_1, Discrete(2)
# in: all pairs at random
# - shape = environment.observation_space(me).n, environment.action_space(me).n, environment.action_space(you).n
# + shape = environment.observation_space(me).n, environment.action_space(me).n, environment.action_space(me).n


# %% one policy for all states
# slow
# says: It is the same in each state: does it look up the state that it is given, and has Q[state] one value for each *pair* of actions, of which only that of the pair just taken moves?
# in: all pairs at random
# - return lambda state: solved[state].first if state in solved else [1 / shape[1]] * shape[1]
# + return lambda _: solved[state].first


# %% one step too few
# slow
# says: is missing; does the loop begin at 1, or end at n_steps - 1?
# in: all pairs at random
# - for _ in range(n_steps):
# + for _ in range(1, n_steps):


# %% Q is set to the step
# slow
# says: Q moves by α (T - Q), with α about 0.2.
# in: all pairs at random
# - Q[state, a, o] += 0.2 * (target - Q[state, a, o])
# + Q[state, a, o] = 0.2 * (target - Q[state, a, o])


# %% player 1 tries nothing
# slow
# says: there player_1 gains by each of its actions, and by one of them a lot, if player_0 does not expect it: player_1 takes one random action in five, too
# in: a class, lists, and player 1 who answers
# - def draw(self, p):
# -     if self.rng.random() < 0.3:
# + def draw(self, p, epsilon=0.3):
# +     if self.rng.random() < epsilon:
# - a, o = both.draw(both.pi[s]), both.draw(both.rho[s])
# + a, o = both.draw(both.pi[s]), both.draw(both.rho[s], 0.0)


# %% the best action of one state for all
# slow
# says: It is the same in each state: does it look up the state that it is given
# in: all pairs at random
# - return lambda state: solved[state].first if state in solved else [1 / shape[1]] * shape[1]
# + return lambda _: np.eye(shape[1])[Q[state].mean(axis=1).argmax()]

# %% nothing from a step that leads back
# slow
# says: Look at this state: there an action leads back to the same state, and costs 1: learn from it as from any other step
# in: all pairs at random
# - Q[state, a, o] += 0.2 * (target - Q[state, a, o])
# + if terminated[me] or int(seen[me]) != state:
# +     Q[state, a, o] += 0.2 * (target - Q[state, a, o])

# %% no future in the state 0
# slow
# says: in a small game with
# in: all pairs at random
# - if not terminated[me]:
# + if not terminated[me] and seen[me]:

# %% probabilities in tenths
# slow
# says: in a small game with 3 states
# in: all pairs at random
# - return lambda state: solved[state].first if state in solved else [1 / shape[1]] * shape[1]
# + tenths = {state: np.round(game.first, 1) for state, game in solved.items()}
# + return lambda state: tenths[state] / tenths[state].sum() if state in solved else [1 / shape[1]] * shape[1]

# %% as many columns as player 0 has actions
# slow
# says: player_1 has two actions there, and player_0 three: a table has a column for each action that player_1 *has*, and no other
# in: all pairs at random
# - Q = np.zeros(shape)
# + Q = np.zeros((shape[0], shape[1], shape[1]))


# %% no value below −5
# slow
# says: there a room that costs 10 is better than 17.5 at once and then a room that costs 30: what follows is multiplied by γ = 0.9, and by no less, and it may be far below 0; and Q moves by α (T - Q)
# in: all pairs at random
# - return solved[state].value if state in solved else 0.0
# + return max(-5.0, solved[state].value) if state in solved else 0.0
