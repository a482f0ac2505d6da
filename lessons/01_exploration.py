# %% [markdown]
# # Exploration: Boulder
#
# **The challenge.** An agent can only learn from rewards that it finds. When the one reward is at the end of a long
# sequence of right choices, trying at random does not find it, and something else must drive the agent on.
#
# **You will be able to** explain why random exploration fails on sparse rewards, and by how much; turn a novelty
# reward into four lines of code, and see where it gets stuck; explain what "first return, then explore" does about
# that.
#
# **Time.** 45 minutes. **Before you start.** You should know what a value function and Q-learning are (Sutton and
# Barto, 2nd edition, sections 3.5 and 6.5), and ε-greedy action selection (section 2.2).

# %%
from typing import NamedTuple

import gymnasium as gym
import matplotlib.pyplot as plt
import numpy as np

from edugym import CountBased, EpsilonGreedy, GoExplore, QLearning, make_mdp, repeat, train
from edugym.lessons import exploration
from edugym.notebook import explore, play, source
from edugym.plotting import learning_curves, lines, visitation_map

# %% [markdown]
# ## Meet the environment: a wall on which one grip holds
#
# A climber stands before a wall of height $H$. At every height there are $N$ grips. One of them holds; the others are
# cracked, and whoever reaches for one of those is back on the ground, hanging safely in the rope. The climber sees
# how high it is, and nothing else: not which grip holds.

# %%
env = gym.make("edugym/Boulder-v0", height=8, n_grips=3).unwrapped
env.reset(seed=0)
for action in env.mdp.grips[:3]:  # the first three grips that hold
    env.step(int(action))
env.scene()

# %% [markdown]
# As an MDP $(\mathcal{S}, \mathcal{A}, p, r, \gamma)$:
#
# | | | in words |
# |---|---|---|
# | states | $\mathcal{S} = \{0, 1, \dots, H\}$ | the position: 0 is the ground, $H$ the top |
# | actions | $\mathcal{A} = \{0, \dots, N-1\}$ | the grip to reach for |
# | dynamics | $p(s+1 \mid s, g_s) = 1$, else $p(0 \mid s, a) = 1$ | the right grip $g_s$ leads up, others down |
# | reward | $r(s, a, s') = 1$ if $s' = H$, else $0$ | the top only |
# | discount | $\gamma = 0.9$ | the agents' own; the returns shown are not discounted |
#
# And this is the whole environment. It is the code that runs in every experiment below:

# %%
source(type(env.mdp))

# %% [markdown]
# **Play it yourself.** Climb to the top. (The picture shows which grips hold. The agent has no picture: cover the
# wall with your hand, and look only at the position.) How many steps did you need?

# %%
play("Boulder", height=8, n_grips=2)

# %% [markdown]
# ## The idea: three ways to explore
#
# ### Try at random
# **ε-greedy** takes a random action with probability $\varepsilon$, and the one that it believes best otherwise:
#
# $$
# A = \begin{cases} \text{a random action} & \text{with probability } \varepsilon \\
# \arg\max_a Q(S, a) & \text{otherwise, ties broken at random} \end{cases}
# $$

# %%
source(EpsilonGreedy.choose)

# %% [markdown]
# As long as nothing was ever rewarded, all of $Q$ is zero, every action is a tie, and the climber tries at random. A
# climb from the ground to the top then needs $H$ right choices in a row, each with probability $1/N$, and every
# wrong one costs the way up to there again. The expected number of steps until the first success is
#
# $$
# \frac{N^{H+1} - N}{N - 1}
# $$

# %%
for height in (10, 30, 100):
    steps = (2 ** (height + 1) - 2) / (2 - 1)
    print(f"height {height:3}: {steps:.3g} steps until a random climber is on top for the first time")

# %% [markdown]
# ### Look for what is new
# **Novelty reward.** Count how often each state was entered, and pay a bonus for entering one that is rarely
# visited. Then learn from the reward and the bonus together, by the same Q-learning:
#
# $$
# \begin{aligned}
# N(S') &\leftarrow N(S') + 1 \\
# R^+ &= R + \beta / \sqrt{N(S')} \\
# Q(S, A) &\leftarrow Q(S, A) + \alpha \left[ R^+ + \gamma \max_a Q(S', a) - Q(S, A) \right]
# \end{aligned}
# $$
#
# Now there is something to learn from at every step. Backed up along the way, the bonus draws the agent to the edge
# of what it knows.

# %%
source(CountBased.learn)

# %% [markdown]
# ### First return, then explore
# **Go-Explore** does not hope to get back to the edge: it goes there. It keeps an archive of all states that it has
# met. For each try it chooses the one visited least as its *goal*, returns to it *without* exploring, and only then
# acts at random, for 20 steps. To be able to return it learns a table of values for every goal,
#
# $$
# Q(g, S, A) \leftarrow Q(g, S, A) + \alpha \left[ 1\{S' = g\} + \gamma\, 1\{S' \neq g\} \max_a Q(g, S', a) - Q(g, S, A) \right]
# $$
#
# and from each try it learns for every state on the way as if that had been the goal (*hindsight*). What the agent
# is doing is in `self.now`: its goal, how long it has explored, and the steps of this try, in arrays, since a tuple
# cannot change.

# %%
source(GoExplore.act)

# %%
source(GoExplore.learn_to_reach)

# %% [markdown]
# ## The experiment: three walls
#
# This is the paper's figure, computed here and now: walls of height 10, 30 and 100, three methods, 20 000 steps.
#
# | setting | value |
# |---|---|
# | all | tabular Q-learning, learning rate $\alpha = 0.5$, discount $\gamma = 0.9$, ties broken at random |
# | ε-greedy and novelty reward | $\varepsilon = 0.1$ |
# | novelty reward | $\beta = 1$, on the state entered |
# | Go-Explore | 20 random steps from each goal |
# | evaluation | one episode without exploring, every 200 steps; episodes last $10 H$ steps at most |
# | repetitions | 10, each on a wall of its own, the same for all methods; bands are 95 % intervals |
#
# Two dashed lines show what is possible: the optimum, from the exact model of the task, and what the best policy
# gets in an episode that has to explore all the time, with $\varepsilon = 0.1$. (Evaluation does not explore, so a
# learner may be above the second line; while it *trains*, an ε-greedy agent cannot be.)


# %%
def figure(heights=(10, 30, 100), n_grips=2, repetitions=10):
    """The learning curves of the three methods: one panel for each height."""
    fig, axes = plt.subplots(1, len(heights), figsize=(4.4 * len(heights), 3.6), sharey=True, squeeze=False)
    for ax, height in zip(axes[0], heights, strict=True):
        results = exploration.compare(height, n_grips=n_grips, repetitions=repetitions)
        optimum = exploration.best_return(height, n_grips=n_grips)
        soft_optimum = exploration.best_return(height, 0.1, n_grips)
        title = f"height {height}, {n_grips} grips"
        learning_curves(
            results,
            ax,
            share=True,
            optimum=optimum,
            soft_optimum=soft_optimum,
            title=title,
            legend=height == heights[0],
        )
    return fig


_ = figure()
plt.show()

# %% [markdown]
# ε-greedy solves the low wall only. The novelty reward solves the middle one as well. Go-Explore solves all three.
# (On the high wall the lines of the other two lie on each other, at 0. On the lower ones even a policy that goes on
# exploring gets to the top in nearly every episode of $10 H$ steps, so that the two dashed lines cannot be told
# apart.)

# %% [markdown]
# ## Your turn
#
# Move a slider and let it go: all of it is computed again. How high can the novelty reward climb? What do more grips
# change, and for whom?


# %%
def one_wall(height=20, n_grips=2):
    """The learning curves of the three methods on walls of one kind."""
    return figure((height,), n_grips)


explore(one_wall, height=(5, 100, 5), n_grips=(2, 5))

# %% [markdown]
# ## See inside: where do they spend their time?
#
# Each picture shows a training run on a wall of height 100: time to the right, the wall upwards, darker where the
# agent was more often.


# %%
def visits_over_the_wall(height=100, repetitions=3):
    """For every method, how often each height was visited as training went on."""
    results = exploration.compare(height, repetitions=repetitions)
    fig, axes = plt.subplots(1, len(results.methods), figsize=(13, 3.8), sharey=True)
    for ax, method in zip(axes, results.methods, strict=True):
        visits = np.mean(list(exploration.visits_of(results, method)), axis=0)
        visitation_map(visits, exploration.N_STEPS, ax, title=method, y_label="height", colour_bar=False)
    return fig


_ = visits_over_the_wall()
plt.show()

# %% [markdown]
# - **ε-greedy** hardly ever gets higher than a dozen grips, and then by luck. It has nothing to learn from.
# - **Novelty** climbs fast at first, and then ever more slowly: after 20 000 steps its frontier is near 40.
# - **Go-Explore** moves its frontier up steadily, to the top.
#
# Why does novelty slow down? Look at how a climb must succeed. To see something new the agent has to get back to its
# frontier first, *while it keeps taking random actions*. With two grips, an ε-greedy climber takes the wrong one
# with probability
# $\varepsilon/2 = 0.05$ at every step, so that it comes back to height $h$ in a share of $0.95^h$ of its climbs.
# This is called **derailment**. Go-Explore returns without exploring: it cannot derail.


# %%
def climbs_back(height=100, repetitions=10):
    """The share of climbs that came to each height, in the second half of training, beside 0.95 to the power of it."""
    results = exploration.compare(height, repetitions=repetitions)
    shares = {
        method: np.mean(
            [exploration.share_of_climbs(exploration.later(v)) for v in exploration.visits_of(results, method)],
            axis=0,
        )
        for method in results.methods
    }
    heights = np.arange(height + 1.0)
    ax = lines(
        heights, shares, theory={r"$0.95^h$": 0.95**heights}, x_label="height", y_label="share of climbs that get there"
    )
    ax.set(yscale="log", ylim=(1e-4, 1.2))
    return ax


_ = climbs_back()
plt.show()

# %% [markdown]
# The novelty agent follows the dashed line, $0.95^h$, up to where it knows the way, near 30 for the ten runs of this
# figure, and falls off beyond that, where its runs have got to different heights and have learnt less and less.
# Go-Explore's line is flat: of its climbs four in five end near the ground, where its random exploring begins and
# ends; those that are on the way to a goal arrive.
#
# At height 40, one climb in eight comes back; at 100, six in a thousand would. And once back at the frontier, an
# agent that knows nothing of the next height takes the right grip every second time, and then must come back
# *again*, to learn about the one after.
#
# There is a second effect, **detachment**: the bonus at the frontier fades as the frontier is visited, so that the
# agent may turn away from it before it has passed it on. The paper names this as the main reason. Here it is not:
# `edugym reproduce exploration` measures that after training the greedy policy of the novelty agent still leads to
# its frontier.

# %% [markdown]
# ## Predict, then check
#
# Commit yourself to an answer before you run the cell below each question. It is the surprise that teaches.
#
# **Predict.** The slips of ε-greedy end most climbs. So switch them off: train the novelty agent with $\varepsilon =
# 0$ on a wall of height 100. How high does it get, compared with about 40?


# %%
def highest_visited(height=100, **settings):
    """The mean highest state that the novelty agent ever visited, over 10 repetitions."""
    method = {"novelty": lambda wall: CountBased.create(wall, **settings)}
    results = exploration.compare(height, methods=method, repetitions=10)
    return np.mean([exploration.frontier(visits) for visits in exploration.visits_of(results, "novelty")])


for epsilon in (0.1, 0.02, 0.0):
    print(f"ε = {epsilon:4}: highest state {highest_visited(exploration=EpsilonGreedy(epsilon)):.1f}")

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** With $\varepsilon = 0$ it hardly leaves the ground: between 1 and 2 on average. A bonus is paid for
# states that were *entered*, and all values start at zero: as soon as a wrong grip has paid a little (falling to the
# ground is an entered state, too), it looks better than a grip that was never tried. The novelty reward pulls the
# agent back to the edge of what it knows; it is ε that takes the step beyond. Optimistic initial values take it in
# another way: see exercise 2.
# </details>

# %% [markdown]
# **Predict.** Most textbooks set the discount nearer to 1. Does the novelty agent do better on a wall of height 10
# with
# $\gamma = 0.99$ than with $0.9$?

# %%
for discount in (0.9, 0.99):
    method = {"novelty": lambda wall, discount=discount: CountBased.create(wall, discount=discount)}
    results = exploration.compare(10, methods=method, repetitions=10)
    print(
        f"discount {discount}: {results.final('novelty').mean():.0%} of the runs end with a policy that reaches the top"
    )

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** All runs with 0.9; none with 0.99. A climber who never reaches the top collects bonuses for ever; at
# the top the episode ends, and so do they. With a long sight, the small bonuses of all the future add up to more
# than the reward of 1: the agent is paid for staying. A bonus changes the *task*, not only the exploration.
# </details>

# %% [markdown]
# **Predict.** How many steps does a random climber need on a wall with *three* grips and height 5, more or fewer
# than with two grips and height 8?

# %%
print(
    "N = 2, H = 8:",
    exploration.random_search_steps(2, 8),
    "steps;  N = 3, H = 5:",
    exploration.random_search_steps(3, 5),
)
print("watched, for N = 3, H = 5:", round(exploration.watch_random_search(3, 5, climbs=200, repetitions=10).estimate))

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** 510 and 363: fewer. Both grow exponentially with the height; the number of grips is the base. What is
# watched agrees within a few percent.
# </details>

# %% [markdown]
# ## Exercises
#
# ### Exercise 1: change a parameter
# An ε-greedy climber knows the whole wall and keeps exploring with $\varepsilon$. What $\varepsilon$ may it have at
# most, if half of its climbs on a wall of height 100 with two grips are to reach the top? Set `epsilon` to that
# number.
#
# <details><summary>Hint</summary>A random action is the wrong one with probability 1/2, so a step goes wrong with
# probability ε/2. Solve (1 − ε/2)^100 = 1/2.</details>

# %%
epsilon = 0.1
### BEGIN SOLUTION
epsilon = 2 * (1 - 0.5 ** (1 / 100))
### END SOLUTION

# %% tags=["check"]
assert isinstance(epsilon, int | float), f"epsilon must be a number, but is {epsilon!r}"
share = (1 - epsilon / 2) ** 100
assert share > 0.45, (
    f"with ε = {epsilon:.3f} only {share:.1%} of the climbs arrive: every step may go wrong, so ε must be smaller"
)
assert share < 0.55, f"with ε = {epsilon:.3f} as many as {share:.1%} of the climbs arrive: a larger ε is still allowed"

# %% [markdown]
# ### Exercise 2: optimistic initial values
# Start all values of $Q$ from 1 instead of 0, and let the agent be greedy ($\varepsilon = 0$): whatever it tries
# disappoints it, so it tries what it has not tried yet (Sutton and Barto, section 2.6). Write the function that
# makes this agent. Does it solve height 30 in 20 000 steps, where ε-greedy failed?
#
# <details><summary>Hint</summary>`QLearning.create` has a parameter `initial_value`, and `EpsilonGreedy(0.0)` never
# explores. Use the learning rate 0.5 and the discount 0.9 of the lesson.</details>


# %%
def optimist(wall):
    """A greedy Q-learning agent that believes everything to be worth 1 until it has tried it."""
    ### BEGIN SOLUTION
    return QLearning.create(wall, learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0), initial_value=1.0)
    ### END SOLUTION


# %% tags=["check"] points=2
made = optimist(make_mdp("Boulder", height=30))
assert made.Q.min() == made.Q.max() == 1.0, (
    f"all values must start from 1, but they start from {made.Q.min()} to {made.Q.max()}"
)
assert made.exploration.epsilon == 0.0, (
    f"the optimist explores by its values alone: ε must be 0, not {made.exploration.epsilon}"
)
solved = repeat("Boulder", {"optimist": optimist}, 20_000, parameters={"height": 30}).final("optimist").mean()
assert solved > 0.9, f"{solved:.0%} of the runs solve the wall; with learning rate 0.5 and discount 0.9 all should"
### BEGIN HIDDEN TESTS
assert made.learning_rate == 0.5
assert made.discount == 0.9
### END HIDDEN TESTS

# %% [markdown]
# ### Exercise 3: write this agent in ten lines
# Write a Q-learning agent with a novelty reward of your own, from the equations above. Its tables are given; `act`
# is done. Complete `learn`. It is plain Python, and it will run as machine code, tens of millions of steps a second,
# without your doing anything about it.
#
# <details><summary>Hint</summary>Count the state that was entered first, then add 1/√N to the reward. The value of
# the next state is 0 if the episode has terminated, and the highest entry of its row of Q otherwise:
# `max(self.Q[next_state])`.</details>


# %%
class MyExplorer(NamedTuple):
    """Q-learning with a novelty reward."""

    Q: np.ndarray
    visits: np.ndarray

    def act(self, state, rng):
        """ε-greedy with ε = 0.1, ties broken at random."""
        if rng.random() < 0.1 or self.Q[state, 0] == self.Q[state, 1]:
            return int(rng.random() * 2)
        return 0 if self.Q[state, 0] > self.Q[state, 1] else 1

    def learn(self, state, action, reward, next_state, terminated):
        """Learn from one transition, with learning rate 0.5 and discount 0.9."""
        ### BEGIN SOLUTION
        self.visits[next_state] += 1
        bonus = 1.0 / self.visits[next_state] ** 0.5
        value = 0.0 if terminated else max(self.Q[next_state])
        self.Q[state, action] += 0.5 * (reward + bonus + 0.9 * value - self.Q[state, action])
        ### END SOLUTION


# %% tags=["check"] points=3
mine = MyExplorer(np.zeros((4, 2)), np.zeros(4, np.int64))
mine.learn(0, 1, 0.0, 1, False)
assert mine.visits[1] == 1, f"the state that was entered, 1, must be counted once; visits are {mine.visits}"
assert mine.visits[0] == 0, "count the state that was entered, not the one that was left"
assert mine.Q[0, 1] == 0.5, f"after one step without reward, Q[0, 1] is 0.5 * (0 + 1/√1) = 0.5, not {mine.Q[0, 1]}"
mine.learn(0, 1, 0.0, 1, False)
expected = 0.5 + 0.5 * (2**-0.5 - 0.5)
assert abs(mine.Q[0, 1] - expected) < 1e-12, (
    f"the second time the bonus is 1/√2: Q[0, 1] is {expected:.4f}, not {mine.Q[0, 1]:.4f}"
)
mine.Q[2] = 1.0
mine.learn(1, 0, 1.0, 2, True)
assert mine.Q[1, 0] == 1.0, f"a terminated episode has no future: Q[1, 0] is 0.5 * (1 + 1) = 1, not {mine.Q[1, 0]}"
walls = [make_mdp("Boulder", height=30, layout_seed=seed) for seed in range(5)]
runs = [train(wall, MyExplorer(np.zeros((31, 2)), np.zeros(31, np.int64)), 20_000, seed=1) for wall in walls]
tops = sum(run.agent.visits[30] > 0 for run in runs)
assert tops >= 3, f"only {tops} of 5 runs reached the top of a wall of height 30"

# %% [markdown]
# ### Exercise 4: swap in another environment
# The same agents learn in any Gymnasium environment with whole numbers for observations and actions. FrozenLake on a
# map of 8 by 8, not slippery, is a sparse task too: one reward, in the far corner, and holes on the way. Compare the
# three methods there: assign to `frozen` what `repeat` returns for `exploration.METHODS`, 20 000 steps and 5
# repetitions.
#
# (The novelty reward helps less there than on the wall. A hole ends the episode, and with it all bonuses to come;
# and a bonus of 1 is as large as the reward that waits 14 steps away, which is discounted to a quarter.)
#
# <details><summary>Hint</summary>`repeat` takes a Gymnasium environment as its first argument, and a dictionary of
# methods as its second.</details>

# %%
lake = gym.make("FrozenLake-v1", map_name="8x8", is_slippery=False)
frozen = None
### BEGIN SOLUTION
frozen = repeat(lake, exploration.METHODS, 20_000, repetitions=5)
### END SOLUTION

# %% tags=["check"]
assert frozen is not None, "frozen must be what repeat(...) returns"
assert set(frozen.methods) == set(exploration.METHODS), f"all three methods are asked for, not {frozen.methods}"
assert len(frozen.final("Go-Explore")) == 5, "5 repetitions are asked for"
for method in frozen.methods:
    print(f"{method}: {frozen.final(method).mean():.0%} of the runs solve the lake")

# %% [markdown]
# ## What you saw
#
# - Random exploration needs a number of steps that grows exponentially with the depth of the reward. It is not slow:
#   it is hopeless.
# - A novelty reward gives the agent something to learn from at every step. It draws the agent back to the edge of
#   what it knows.
# - Getting back *while exploring* fails more often the deeper the edge is. Returning first and exploring then does
#   not.
# - A bonus is part of the task as long as it is paid: it can make the agent prefer exploring to the goal.
#
# ### Limits
# A table can count how often a state was visited; pictures hardly ever come twice, and counting must be replaced by
# something like it (density models, prediction errors). Go-Explore here stores a value for every pair of a state and
# a goal, which is affordable for a wall of height 100 and not for much else. And a state must say where one is: with
# a hidden state, "return" means nothing.
#
# ### Further reading
# - Sutton and Barto, *Reinforcement Learning*, 2nd edition: 2.2–2.7 (exploration in bandits), 8.3 (a bonus for what
#   was long not tried).
# - Ecoffet, Huizinga, Lehman, Stanley and Clune (2021), *First return, then explore*: detachment and derailment.
# - Chentanez, Barto and Singh (2004), *Intrinsically motivated reinforcement learning*.
# - Amin, Gomrokchi, Satija, van Hoof and Precup (2021), *A survey of exploration methods in reinforcement learning*.
# - Strens (2000), *A Bayesian framework for reinforcement learning*: the chain from which this wall descends.
