# %% the worst action
# says: every action gains, and one gains most
# says: in a task in which
# says: , it finds the right action in
# says: searches: is the action with the highest value returned, and does an action that was never tried come first in its node, as if its bound were infinite? Is each reward in G, also in the tree?
# in: nodes are objects
# - return max(tried, key=root.mean)
# + return min(tried, key=root.mean)

# %% untried is worth 0
# says: is the action with the highest value returned, and does an action that was never tried come first in its node, as if its bound were infinite? Is each reward in G, also in the tree?
# in: a loop and a path
# - untried = np.flatnonzero(N[node] == 0)
# + untried = []
# - bonus = 5 * np.sqrt(np.log(N[node].sum() + 1) / N[node])
# + bonus = 5 * np.sqrt(np.log(N[node].sum() + 1) / (N[node] + 1))

# %% no exploration
# says: the best action seldom pays, but then much
# says: is there an exploration term, c √(ln N(node) / N(node, a)), and is a value the *mean* of all returns? Else one bad try is the last one
# in: a loop and a path
# - bonus = 5 * np.sqrt(np.log(N[node].sum() + 1) / N[node])
# + bonus = 0

# %% the latest return
# says: is there an exploration term, c √(ln N(node) / N(node, a)), and is a value the *mean* of all returns?
# in: nodes are objects
# - return sum(self.returns[action]) / len(self.returns[action])
# + return self.returns[action][-1]

# %% the c of the shop
# says: every action ends the task
# says: , the actions should be simulated about
# says: times, but are
# says: c is 10, as in the shop; here it is 5
# in: a loop and a path
# - bonus = 5 * np.sqrt(np.log(N[node].sum() + 1) / N[node])
# + bonus = 10 * np.sqrt(np.log(N[node].sum()) / N[node])

# %% no logarithm
# says: the logarithm is missing
# in: a loop and a path
# - bonus = 5 * np.sqrt(np.log(N[node].sum() + 1) / N[node])
# + bonus = 5 * np.sqrt(N[node].sum() / N[node])

# %% base 10
# says: ln is the natural logarithm, not that of base 10
# in: a loop and a path
# - bonus = 5 * np.sqrt(np.log(N[node].sum() + 1) / N[node])
# + bonus = 5 * np.sqrt(np.log10(N[node].sum()) / N[node])

# %% twice the logarithm
# says: some books have a 2 before the logarithm; here c takes its place
# in: a loop and a path
# - bonus = 5 * np.sqrt(np.log(N[node].sum() + 1) / N[node])
# + bonus = 5 * np.sqrt(2 * np.log(N[node].sum()) / N[node])

# %% c under the root
# says: c stands under the root; it is outside
# in: a loop and a path
# - bonus = 5 * np.sqrt(np.log(N[node].sum() + 1) / N[node])
# + bonus = np.sqrt(5 * np.log(N[node].sum()) / N[node])

# %% a short root
# says: only the logarithm is under the root; N(node, a) belongs there, too
# in: a loop and a path
# - bonus = 5 * np.sqrt(np.log(N[node].sum() + 1) / N[node])
# + bonus = 5 * np.sqrt(np.log(N[node].sum())) / N[node]

# %% no root
# says: the square root is missing
# in: a loop and a path
# - bonus = 5 * np.sqrt(np.log(N[node].sum() + 1) / N[node])
# + bonus = 5 * np.log(N[node].sum()) / N[node]

# %% ε-greedy
# says: is the action in a node the one with the highest Q(node, a) + 5 √(ln N(node) / N(node, a))?
# in: a loop and a path
# - bonus = 5 * np.sqrt(np.log(N[node].sum() + 1) / N[node])
# + bonus = 1000 * (rng.random() < 0.1) * rng.random(n_actions)

# %% no tree
# says: what follows the best action is good only if one goes on well
# says: it looks as if all later actions were random: in the tree, choose them by their upper bounds, too, and pass on the whole return, R + γ G, to the node before
# in: nodes are objects
# - node.children[action, after] = Node(n_actions)
# + pass

# %% one node for two states
# says: chance says where the best action leads, and each place wants another action
# says: is a node a state with the way to it? After one action two states may follow, and each is a node of its own
# in: a loop and a path
# - node = (*node, action, here)
# + node = (*node, action)

# %% the last reward
# slow
# says: two losses come before a gain
# says: do all rewards of a simulation count, those in the tree and those of the roll-out, and not only the last one?
# in: nodes are objects
# - G += 0.9 * visit(child, after, left - 1)
# + G = 0.9 * visit(child, after, left - 1)

# %% the last reward of the roll-out
# slow
# says: do all rewards of a simulation count, those in the tree and those of the roll-out, and not only the last one?
# in: a loop and a path
# - G += weight * reward
# + G = weight * reward

# %% no discount
# slow
# says: a larger reward comes eight steps later
# says: is what follows a step discounted by γ = 0.9, in the tree and in the roll-outs? (The shop has another γ.)
# in: nodes are objects
# - G += 0.9 * visit(child, after, left - 1)
# + G += visit(child, after, left - 1)

# %% no discount in the roll-out
# slow
# says: a larger reward comes eight steps later
# says: is what follows a step discounted by γ = 0.9, in the tree and in the roll-outs? (The shop has another γ.)
# in: a loop and a path
# - weight *= 0.9
# + weight *= 1

# %% five steps
# slow
# says: a reward comes nine steps later that is worth waiting for
# says: does each simulation look
# says: steps ahead, with a roll-out after the tree, and is γ not below 0.9?
# in: nodes are objects
# - visit(root, state, 10)
# + visit(root, state, 5)

# %% an action without a simulation
# slow
# says: all actions lose, and there are fewer simulations than actions
# says: an action that was not simulated from the root has no value: choose among those that were
# in: a loop and a path
# - return int(np.argmax(np.where(N[()] > 0, Q[()], -np.inf)))
# + return int(np.argmax(Q[()]))

# %% the bound in the end
# slow
# says: two actions are nearly as good as the best one
# says: is the action in the end the one with the highest value, without the exploration term?
# in: a loop and a path
# - return int(np.argmax(np.where(N[()] > 0, Q[()], -np.inf)))
# + bounds = np.where(N[()] > 0, Q[()] + 5 * np.sqrt(np.log(n_simulations) / np.maximum(N[()], 1)), -np.inf)
# + return int(np.argmax(bounds))

# %% beyond the end
# says: goes on after the end, from the state
# says: : where the model says that it ends, the simulation is over
# in: nodes are objects
# - if not ended:
# + if True:

# %% always from the root
# says: asks for a step from the root more than
# says: times, which is n_simulations: a search is a loop of so many, each from the root, and after a step a simulation goes on from the *next* state
# in: a loop and a path
# - reward, here, ended = model(here, int(rng.integers(n_actions)))
# + reward, here, ended = model(state, int(rng.integers(n_actions)))

# %% from the state before
# says: asks for a step from the state
# says: , but its simulation is in
# says: : go on from the state that the model gave, and ask it for each step that you take, once and in order
# in: a loop and a path
# - for _ in range(len(path), 10):
# + before = here
# + for _ in range(len(path), 10):
# - reward, here, ended = model(here, int(rng.integers(n_actions)))
# + reward, after, ended = model(before, int(rng.integers(n_actions)))
# + before, here = here, after

# %% an index for a state
# says: asks for a step from
# says: , which is no state that the model gave
# in: nodes are objects
# - G += 0.9 * visit(child, after, left - 1)
# + G += 0.9 * visit(child, after + 100, left - 1)

# %% without a depth
# slow
# says: simulates more than
# says: steps in a row: each simulation looks
# says: steps ahead
# in: nodes are objects
# - visit(root, state, 10)
# + visit(root, state, 100)

# %% one simulation less
# says: simulates from the root
# says: times, and it should
# says: times: a search is a loop of n_simulations, each from the root to its end
# in: nodes are objects
# - for _ in range(n_simulations):
# + for _ in range(n_simulations - 1):

# %% a generator without a seed
# slow
# says: my_program does not repeat itself: two searches with seed
# says: simulate different actions. Draw every random number from rng = np.random.default_rng(seed)
# in: a loop and a path
# - rng = np.random.default_rng(seed)
# + rng = np.random.default_rng()

# %% a state for an action
# says: the action that is given to the model
# in: nodes are objects
# - reward, after, ended = model(here, action)
# + reward, after, ended = model(here, float(action))

# %% the count
# says: what my_program(
# says: returns should give
# in: nodes are objects
# - return max(tried, key=root.mean)
# + return max(len(returns) for returns in root.returns)

# %% a number
# says: model, n_actions, state, n_simulations and seed
my_program = 3

# %% the action that was simulated most often
# slow
# says: one action pays most, and each is simulated once
# says: is the action with the highest *value* returned, and not the one that was simulated most often? Is the root in the tree from the start, so that the first simulation takes an action there?
# in: a loop and a path
# - return int(np.argmax(np.where(N[()] > 0, Q[()], -np.inf)))
# + return int(np.argmax(N[()]))

# %% the untried ones in order
# slow
# says: my_program begins every search with the action 0, though none was tried yet: among equals draw one at random, and begin the generator with the seed that is given
# in: a loop and a path
# - action = int(rng.choice(untried))
# + action = int(untried[0])

# %% γ = 0.8
# slow
# says: in a task in which a reward comes nine steps later that is worth waiting for
# says: steps ahead, with a roll-out after the tree, and is γ not below 0.9?
# in: a loop and a path
# - weight *= 0.9
# + weight *= 0.8
# - G = reward + 0.9 * G
# + G = reward + 0.8 * G

# %% the highest return
# slow
# says: one action seldom pays much, and the others pay more on average
# says: is a value the *mean* of all returns, and not the highest of them?
# in: a loop and a path
# - Q[visited][action] += (G - Q[visited][action]) / N[visited][action]
# + Q[visited][action] = G if N[visited][action] == 1 else max(G, Q[visited][action])

# %% γ = 0.95, as in the shop
# slow
# says: in a task in which a larger reward comes eight steps later
# says: discounted by γ = 0.9, in the tree and in the roll-outs? (The shop has another γ.)
# in: a loop and a path
# - weight *= 0.9
# + weight *= 0.95
# - G = reward + 0.9 * G
# + G = reward + 0.95 * G

# %% one action for a whole roll-out
# slow
# says: each later action that differs from the one before is paid, and there is one simulation for each action
# says: is each action of a roll-out drawn anew?
# in: a loop and a path
# - G, weight = 0.0, 1.0
# + G, weight, again = 0.0, 1.0, int(rng.integers(n_actions))
# - reward, here, ended = model(here, int(rng.integers(n_actions)))
# + reward, here, ended = model(here, again)

# %% the highest value of a node
# slow
# says: 100 simulations are too few to forget the bad tries after an action
# says: is the return of the simulation passed on to the node before, and not the highest value of the node after, and is c the same in every node?
# in: a loop and a path
# - Q[visited][action] += (G - Q[visited][action]) / N[visited][action]
# + Q[visited][action] += (G - Q[visited][action]) / N[visited][action]
# + G = Q[visited][N[visited] > 0].max()


# %% two levels
# says: what follows the best action is good only if one goes on well two steps later
# says: the tree has too few levels, or a return does not come back: does each simulation add a node, also below those that it has added before, and pass on R + γ G, and not R alone?
# in: nodes are objects
# - if node is not None and child is None:
# + if node is root and child is None:


# %% γ = 0.92
# slow
# says: discounted by γ = 0.9, in the tree and in the roll-outs? (The shop has another γ.)
# in: nodes are objects
# - G += 0.9 * visit(child, after, left - 1)
# + G += 0.92 * visit(child, after, left - 1)


# %% γ = 0.89
# slow
# says: steps ahead, with a roll-out after the tree, and is γ not below 0.9?
# in: nodes are objects
# - G += 0.9 * visit(child, after, left - 1)
# + G += 0.89 * visit(child, after, left - 1)


# %% the rewards on the way through the tree
# slow
# says: two losses come before a gain
# says: do all rewards of a simulation count, those in the tree and those of the roll-out, and not only the last one?
# in: a loop and a path
# - G = reward + 0.9 * G
# + G = (reward if visited == path[-1][0] else 0.0) + 0.9 * G


# %% a generator for each simulation
# slow
# says: my_program ends many simulations with the same
# says: actions: make rng once, before the loop of simulations, or each of them draws the same random numbers
# in: a loop and a path
# - node, here, path, rewards, ended = (), state, [], [], False
# + rng = np.random.default_rng(seed)
# + node, here, path, rewards, ended = (), state, [], [], False

# %% the number of the simulation in each logarithm
# slow
# says: in a task in which each state is reached in one way only, simulation
# says: takes another action in the tree than the one with the highest bound Q(node, a) + 5 √(ln N(node) / N(node, a))
# says: in ln N(node), N(node) counts the choices in *this* node, and not all simulations
# in: a loop and a path
# - for _ in range(n_simulations):
# + for k in range(n_simulations):
# - bonus = 5 * np.sqrt(np.log(N[node].sum() + 1) / N[node])
# + bonus = 5 * np.sqrt(np.log(k + 1) / N[node])

# %% the new mean is passed on
# slow
# says: what is passed on to the node before is the return of *this* simulation, and not the new mean of the node
# in: a loop and a path
# - Q[visited][action] += (G - Q[visited][action]) / N[visited][action]
# + Q[visited][action] = G = Q[visited][action] + (G - Q[visited][action]) / N[visited][action]

# %% discounted twice
# slow
# says: in a node returns are discounted from this node on, and not once more from the root
# in: a loop and a path
# - Q[visited][action] += (G - Q[visited][action]) / N[visited][action]
# + Q[visited][action] += (G * 0.9 ** (len(visited) // 2) - Q[visited][action]) / N[visited][action]

# %% the whole roll-out in the tree
# slow
# says: each simulation adds *one* node, and not every state of its roll-out
# in: a loop and a path
# - if node != ():
# + if False:

# %% another c below the root
# slow
# says: c is 5 below the root, too; it looks as if it were 10 there
# in: a loop and a path
# - bonus = 5 * np.sqrt(np.log(N[node].sum() + 1) / N[node])
# + bonus = (5 if node == () else 10) * np.sqrt(np.log(N[node].sum() + 1) / N[node])

# %% the most frequent one, and among those the best
# slow
# says: every action ends the task, and one has a very lucky return near the end
# says: , it returns an action with the mean
# says: , and another one has
# says: : return the action with the highest *value*, and not the one that was simulated most often
# in: a loop and a path
# - return int(np.argmax(np.where(N[()] > 0, Q[()], -np.inf)))
# + return max(range(n_actions), key=lambda a: (N[()][a], Q[()][a]))

# %% the first simulation rolls out from the root
# slow
# says: in a task in which one action pays most, and each is simulated once
# in: a loop and a path
# - if node != ():
# + if True:

# %% the tree has no last step
# slow
# says: my_program simulates more than 10 steps in a row: each simulation looks 10 steps ahead
# in: a loop and a path
# - while len(path) < 10 and not ended:
# + while not ended:

# %% a roll-out that leaves out the last action
# slow
# says:  last steps of its simulations: is the random action of a roll-out one of *all* n actions, 0 to n - 1?
# in: a loop and a path
# - reward, here, ended = model(here, int(rng.integers(n_actions)))
# + reward, here, ended = model(here, int(rng.integers(n_actions - 1)))

# %% the tree of the search before
# slow
# says: my_program does not repeat itself: two searches with seed
# says: simulate different actions. Draw every random number from rng = np.random.default_rng(seed), and make the tree inside the function, so that nothing is left of the search before
# in: a loop and a path
# - N, Q = {}, {}
# + N, Q = vars(my_program).setdefault("kept", ({}, {}))


# %% a search for the highest bound that begins at 0
# slow
# says: every return is far below 0
# says: takes another action in the tree than the one with the highest bound
# says: does the search for the highest bound begin at 0? Begin it at −∞, or take `max`
# in: a loop and a path
# - action = int(np.argmax(Q[node] + bonus))
# + action = int(np.argmax(Q[node] + bonus)) if (Q[node] + bonus).max() > 0 else 0


# %% an untried action is worth 100
# slow
# says: returns are in the thousands
# says: is an action that was never tried always taken first? Its bound is ∞, and not a large number
# in: a loop and a path
# - if len(untried):
# + if len(untried) and Q[node].max() < 100:
# - bonus = 5 * np.sqrt(np.log(N[node].sum() + 1) / N[node])
# + bonus = 5 * np.sqrt(np.log(N[node].sum() + 1) / np.maximum(N[node], 1))
