# %% [markdown]
# # Exploration: Boulder
#
# **The challenge.** An agent can only learn from rewards that it finds. When the only reward is at the end of a long
# sequence of right choices, random actions do not find it, and something else must drive the agent on.
#
# **You will be able to** explain why random exploration fails on sparse rewards, and by how much; turn a novelty
# reward into four lines of code, and see where it gets stuck; explain how "first return, then explore" avoids that.
#
# **Time.** 45 minutes. **Before you start.** You should know what a value function and Q-learning are (Sutton and
# Barto, 2nd edition, sections 3.5 and 6.5), and ε-greedy action selection (section 2.2).

# %%
from typing import NamedTuple

import gymnasium as gym
import numpy as np

from edugym import CountBased, EpsilonGreedy, GoExplore, QLearning, repeat
from edugym.lessons import exploration
from edugym.notebook import play, sliders, source
from edugym.plotting import Sheet

# %% [markdown]
# ## Meet the environment: a wall on which one grip holds
#
# A climber stands before a wall of height $H$. At every height there are $N$ grips. One of them holds, and the others
# are cracked: a climber who reaches for a cracked grip falls into the rope and is back on the ground. The climber
# sees its own height, and nothing else. It does not see which grip holds.

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
# | dynamics | $p(s+1 \mid s, g_s) = 1$, else $p(0 \mid s, a) = 1$ | the right grip $g_s$ leads up, the others down |
# | reward | $r(s, a, s') = 1$ if $s' = H$, else $0$ | only the top is rewarded |
# | discount | $\gamma = 0.9$ | used by the agents; the returns in the figures are not discounted |
#
# An episode ends at the top (it *terminates*) or after $10 H$ steps (it is *truncated*).
#
# This is the whole environment, the code that runs in every experiment below:

# %%
source(type(env.mdp))

# %% [markdown]
# **Play it yourself.** Climb to the top. How many steps did you need? (The picture shows which grips hold. The agent
# has no picture: cover the wall with your hand, and look only at the position.)

# %%
play("Boulder", height=8, n_grips=2)

# %% [markdown]
# ## The idea: three ways to explore
#
# ### Try at random
# **ε-greedy** takes a random action with probability $\varepsilon$, and otherwise the action that it believes best:
#
# $$
# A = \begin{cases} \text{a random action} & \text{with probability } \varepsilon \\
# \arg\max_a Q(S, a) & \text{otherwise, ties broken at random} \end{cases}
# $$

# %%
source(EpsilonGreedy.choose)

# %% [markdown]
# Before the first reward all values in $Q$ are zero, all actions are tied, and the climber acts at random. To get from
# the ground to the top it needs $H$ right choices in a row, each with probability $1/N$, and a wrong choice sends it
# back to the ground. How many steps does that take? Let $T_h$ be the expected number of steps from the ground to
# height $h$. To get one higher, the climber first gets to $h$ and then takes one more step. With probability $1 - 1/N$
# that step is wrong, and everything starts again:
#
# $$
# T_{h+1} = T_h + 1 + \left(1 - \tfrac{1}{N}\right) T_{h+1}
# \quad\Rightarrow\quad T_{h+1} = N \, (T_h + 1)
# \quad\Rightarrow\quad T_H = N + N^2 + \dots + N^H = \frac{N^{H+1} - N}{N - 1}
# $$
#
# (This holds without a step limit. A limit makes the search a little longer, since it cuts off some good climbs.)

# %%
for height in (10, 30, 100):
    steps = (2 ** (height + 1) - 2) / (2 - 1)
    print(f"height {height:3}: {steps:.3g} steps until a random climber reaches the top for the first time")

# %% [markdown]
# ### Look for what is new
# **Novelty reward.** Let $n(s)$ count how often state $s$ was entered, and pay a bonus for entering a state that was
# rarely entered before. Q-learning then learns from $R^+$, the sum of reward and bonus, where $\beta$ is the size of
# the first bonus:
#
# $$
# \begin{aligned}
# n(S') &\leftarrow n(S') + 1 \\
# R^+ &= R + \beta / \sqrt{n(S')} \\
# Q(S, A) &\leftarrow Q(S, A) + \alpha \left[ R^+ + \gamma \max_a Q(S', a) - Q(S, A) \right]
# \end{aligned}
# $$
#
# Now there is something to learn from at every step. Q-learning backs the bonus up along the path, so that it draws
# the agent to its *frontier*, the edge of what it knows.

# %%
source(CountBased.learn)

# %% [markdown]
# ### First return, then explore
# **Go-Explore** separates getting back from exploring. It keeps an archive of all states that it has met. For each try
# it chooses the least visited state as its *goal*, returns to it *without* exploring, and only then takes 20 random
# steps. To be able to return it learns a table of values for every goal $g$ (where $1\{\cdot\}$ is 1 if the condition
# is true, and 0 otherwise):
#
# $$
# Q(g, S, A) \leftarrow Q(g, S, A) + \alpha \left[ 1\{S' = g\} + \gamma\, 1\{S' \neq g\} \max_a Q(g, S', a) - Q(g, S, A) \right]
# $$
#
# After each try it learns about every state on its path as if that state had been the goal (*hindsight*). The arrays
# in `self.now` hold what changes within a try: the goal, the number of exploring steps, and the path.

# %%
source(GoExplore.act)

# %%
source(GoExplore.learn_to_reach)

# %% [markdown]
# ## The experiment: three walls
#
# This is the paper's figure, computed here and now: three walls, of height 10, 30 and 100, three methods, 20 000
# steps.
#
# | setting | value |
# |---|---|
# | all | tabular Q-learning, learning rate $\alpha = 0.5$, discount $\gamma = 0.9$, ties broken at random |
# | ε-greedy and novelty reward | $\varepsilon = 0.1$ |
# | novelty reward | $\beta = 1$, for the state that is entered |
# | Go-Explore | 20 random steps from each goal |
# | evaluation | one episode without exploring, every 200 steps; episodes last at most $10 H$ steps |
# | repetitions | 10, each on its own wall, the same wall for all methods; bands are 95 % intervals |
#
# Two black lines show what is possible, computed from the exact model of the task: the optimum (dashed), and the
# return of the best *ε-soft* policy, the best that takes a random action with probability $\varepsilon = 0.1$ all the
# time (dotted). Evaluation does not explore, so a learner may rise above the dotted line; an ε-greedy agent cannot
# while it *trains*.


# %%
def figure(heights=(10, 30, 100), n_grips=2, repetitions=10):
    """Draw the learning curves of the three methods, one panel for each height."""
    panels = []
    for height in heights:
        results = exploration.compare(height, n_grips=n_grips, repetitions=repetitions)
        panels.append(exploration.curves(results, height, n_grips))
    return Sheet("learning curves", [panels])


figure()

# %% [markdown]
# ε-greedy solves only the low wall. The novelty reward solves the middle wall as well. Go-Explore solves all three.
# (On the high wall the lines of the other two coincide at 0. On the lower walls even a policy that keeps exploring
# reaches the top in nearly every episode, so that the two black lines coincide.)

# %% [markdown]
# ## Your turn
#
# Move a slider and release it: the whole experiment is computed again. How high can the novelty reward climb? What do
# more grips change, and for which method?


# %%
def one_wall(height=20, n_grips=2):
    """Draw the learning curves of the three methods on walls of one kind."""
    return figure((height,), n_grips)


sliders(one_wall, height=(5, 100, 5), n_grips=(2, 5))

# %% [markdown]
# ## See inside: where do they spend their time?
#
# Each picture is the mean of three training runs on walls of height 100. Time runs to the right and the wall upwards;
# darker means more visits, and white means none.


# %%
def visits_over_the_wall(height=100, repetitions=3):
    """Draw how often each height was visited in the course of training, for every method."""
    results = exploration.compare(height, repetitions=repetitions)
    return Sheet("visits", [exploration.visit_maps(results, height)])


visits_over_the_wall()

# %% [markdown]
# - **ε-greedy** rarely gets higher than a dozen grips, and only by luck. It has nothing to learn from.
# - **Novelty** climbs fast at first, and then ever more slowly: after 20 000 steps its frontier is near 40.
# - **Go-Explore** moves its frontier up steadily, to the top.
#
# Why does novelty slow down? To see something new, the agent must first get back to its frontier, *while it keeps
# taking random actions*. With two grips, an ε-greedy climber takes the wrong grip with probability $\varepsilon/2 =
# 0.05$ at every step, so only a share of $0.95^h$ of its climbs gets back to height $h$. This is called
# **derailment**. Go-Explore returns without exploring, so it cannot derail.


# %%
def climbs_back(height=100, repetitions=10):
    """Draw the share of climbs that reach each height in the second half of training, beside 0.95^height."""
    results = exploration.compare(height, repetitions=repetitions)
    return Sheet("climbs", [[exploration.climb_shares(results, height)]])


climbs_back()

# %% [markdown]
# The novelty agent follows the dashed line, $0.95^h$, as far as all of its runs know the way: up to about 30 here.
# Above that its line drops faster, because the runs have reached different heights. Go-Explore's line is flat. Four of
# five of its climbs end near the ground: after a fall it takes the rest of its 20 random steps from there. The other
# climbs are on their way to a goal, and they arrive.
#
# At height 40, one novelty climb in eight gets back; at height 100, six in a thousand would. And once at its frontier,
# the agent does not know which grip holds. On the first visit it takes the right one about half of the time. After a
# wrong one it is even worse off: the fall has earned a small bonus, too, so the wrong grip now looks better than the
# one that it has not tried, and only a random step will try that one. So slips are what ends its climbs, and also what
# it needs at the frontier. (You will switch them off below.)
#
# The paper gives another reason, **detachment**: the bonus at a frontier fades with every visit, so that the agent may
# turn to another frontier and never come back to this one. A wall has only one frontier, so this experiment cannot
# show detachment. `edugym reproduce exploration` does show that after training the greedy policy of the novelty agent
# still leads to its frontier.
#
# Is it *returning first* that solves the high wall? It is sufficient, but it is not the only way: in exercise 2 you
# meet an agent that solves walls without it.

# %% [markdown]
# ## Predict, then check
#
# Write down your answer before you run the cell below each question. You learn most when you are surprised.
#
# **Predict.** Random steps end most climbs. So switch them off: train the novelty agent with $\varepsilon = 0$ on a
# wall of height 100. How high does it get, compared with about 40?


# %%
def highest_visited(height=100, **settings):
    """Return the highest state that the novelty agent ever visited, a mean over 10 repetitions."""
    method = {"novelty": lambda wall: CountBased.create(wall, **settings)}
    results = exploration.compare(height, methods=method, repetitions=10)
    return np.mean([exploration.frontier(visits) for visits in exploration.visits_of(results, "novelty")])


for epsilon in (0.1, 0.02, 0.0):
    print(f"ε = {epsilon:4}: highest state {highest_visited(exploration=EpsilonGreedy(epsilon)):.1f}")

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** With $\varepsilon = 0$ it hardly leaves the ground: it gets to between 1 and 2 on average. All values
# start at zero, and a fall earns a bonus as well, for entering the ground. So a wrong grip soon looks better than a
# grip that was never tried. The novelty reward pulls the agent back to its frontier, and a random step takes it
# beyond. Exercise 2 shows another way to get beyond: optimistic initial values.
# </details>

# %% [markdown]
# **Predict.** Most textbooks set the discount nearer to 1. Does the novelty agent do better on a wall of height 10
# with $\gamma = 0.99$ than with $\gamma = 0.9$?

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
# **Measured.** All runs with 0.9, and none with 0.99. A climber who never reaches the top collects bonuses for ever;
# at the top the episode ends, and the bonuses end with it. With the higher discount, the many small bonuses of the
# future add up to more than the reward of 1, so the agent is paid for staying away from the top. A bonus changes the
# *task*, not only the exploration.
# </details>

# %% [markdown]
# **Predict.** Does a random climber need more steps on a wall with *three* grips and height 5, or on a wall with two
# grips and height 8?

# %%
print(
    "N = 2, H = 8:",
    exploration.random_search_steps(2, 8),
    "steps;  N = 3, H = 5:",
    exploration.random_search_steps(3, 5),
)
print("measured, for N = 3, H = 5:", round(exploration.watch_random_search(3, 5, climbs=200, repetitions=10).estimate))

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Two grips and height 8 take longer: 510 steps, not 363. Both numbers grow exponentially with the
# height, and the number of grips is the base. The measurement agrees with the formula within a few percent.
# </details>

# %% [markdown]
# ## Exercises
#
# Each exercise has a cell for your answer, and below it a cell that checks it. The check does not only say whether an
# answer is right: it says what was expected, what came, and which mistake that looks like. It runs your code on cases
# that it makes up.

# %%
from edugym.exercises.exploration import CHALLENGE, exercise_1, exercise_2, exercise_3, exercise_4
from edugym.grading import check

# %% [markdown]
# ### Exercise 1: change a parameter
# An ε-greedy climber knows the whole wall and keeps exploring: at every step it takes a random grip with probability
# $\varepsilon$. On a wall of height 100 with two grips, at least half of its climbs should reach the top without a fall.
# What is the largest possible $\varepsilon$? Set `epsilon` to that number, by a formula or with four digits after the
# decimal point.
#
# <details><summary>Hint</summary>A random grip is the wrong one with probability 1/2, so a step goes wrong with
# probability ε/2. What is the probability that 100 steps in a row go right?</details>

# %%
epsilon = 0.1
### BEGIN SOLUTION
epsilon = 2 * (1 - 0.5 ** (1 / 100))
### END SOLUTION

# %% tags=["check"]
check(exercise_1, epsilon)

# %% [markdown]
# ### Exercise 2: optimistic initial values
# Let all values of $Q$ start at 1 instead of 0, and let the agent be greedy ($\varepsilon = 0$). Every action that it
# tries is disappointing, so it goes on to actions that it has not tried yet (Sutton and Barto, section 2.6). Write the
# function that makes this Q-learning agent, with the lesson's learning rate 0.5 and discount 0.9. Before you run the
# check: which of the three walls will it solve?
#
# <details><summary>Hint</summary>One call of QLearning.create is enough. Its settings are learning_rate, discount,
# exploration and initial_value, and EpsilonGreedy(0.0) never explores.</details>


# %%
def optimist(wall):
    """Make a greedy Q-learning agent that values every action at 1 until it has tried it."""
    ### BEGIN SOLUTION
    return QLearning.create(wall, learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0), initial_value=1.0)
    ### END SOLUTION


# %% tags=["check"] points=2
check(exercise_2, optimist)
### BEGIN HIDDEN TESTS
check(exercise_2, optimist, seed=1, quiet=True)
### END HIDDEN TESTS
display(exploration.race({"optimist": optimist}))

# %% [markdown]
# ### Exercise 3: write your own explorer
# You have seen two reasons why the novelty agent is stuck. Its slips end its climbs, but without slips it never tries
# the grip that looks worse. Mend both: let the agent remember what it has tried, so that it needs no slips.
#
# The new agent counts not only how often each state was entered, `visits[state]`, but also how often each grip was
# tried, `tries[state, action]`. Complete two methods:
#
# - `learn` first adds one try of the action in the state, and one visit of the next state. Then it learns as the novelty
#   agent does, with the bonus $\beta / \sqrt{n(S')}$, where $n$ are the visits, and no future after a terminal state.
# - `act` takes a grip that was never tried in this state, if there is one; with several, any of them will do. Otherwise
#   it takes the best grip, which `self.greedy(state, rng)` gives. It never takes a random step.
#
# The fields `learning_rate`, `discount` and `bonus` are $\alpha$, $\gamma$ and $\beta$; read them from `self`. You write
# plain Python, and it runs as machine code, tens of millions of steps a second. Predict: how high will it climb?
#
# <details><summary>Hint</summary>The largest value in the row of the next state is max(self.Q[next_state]). Count
# before you divide. A loop over range(self.Q.shape[1]) visits every grip.</details>


# %%
class MyExplorer(NamedTuple):
    """Q-learning with a novelty reward, which tries every grip once before it prefers one."""

    Q: np.ndarray  # shape (n_states, n_actions)
    visits: np.ndarray  # shape (n_states,): how often each state was entered
    tries: np.ndarray  # shape (n_states, n_actions): how often each action was taken in each state
    learning_rate: float = 0.5
    discount: float = 0.9
    bonus: float = 1.0

    @classmethod
    def create(cls, wall):
        """Make a new agent for a wall: nothing is known, nothing was tried."""
        n_states, n_actions = int(wall.observation_space.n), int(wall.action_space.n)
        tries = np.zeros((n_states, n_actions), np.int64)
        return cls(np.zeros((n_states, n_actions)), np.zeros(n_states, np.int64), tries)

    def greedy(self, state, rng):
        """Choose the grip with the highest value; among equals, one at random."""
        best, equals = 0, 1
        for action in range(1, self.Q.shape[1]):
            if self.Q[state, action] > self.Q[state, best]:
                best, equals = action, 1
            elif self.Q[state, action] == self.Q[state, best]:
                equals += 1
                if rng.random() * equals < 1.0:
                    best = action
        return best

    def act(self, state, rng):
        """Choose a grip that was never tried here, or else the best."""
        ### BEGIN SOLUTION
        for action in range(self.Q.shape[1]):
            if self.tries[state, action] == 0:
                return action
        return self.greedy(state, rng)
        ### END SOLUTION

    def learn(self, state, action, reward, next_state, terminated):
        """Count, and learn from one transition."""
        ### BEGIN SOLUTION
        self.tries[state, action] += 1
        self.visits[next_state] += 1
        novelty = self.bonus / self.visits[next_state] ** 0.5
        value = 0.0 if terminated else max(self.Q[next_state])
        target = reward + novelty + self.discount * value
        self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])
        ### END SOLUTION


# %% tags=["check"] points=3
check(exercise_3, MyExplorer)
### BEGIN HIDDEN TESTS
check(exercise_3, MyExplorer, seed=1, quiet=True)
### END HIDDEN TESTS
display(exploration.race({"my explorer": MyExplorer.create}))

# %% [markdown]
# ### Exercise 4: swap in another environment
# The same agents learn in any Gymnasium environment with whole numbers for observations and actions. FrozenLake with a
# map of 8 by 8, not slippery, is a sparse task too: its only reward is in the far corner, 14 steps away, and a fall into
# one of its holes ends the episode. Predict first: will the novelty reward help as much as on the wall?
#
# Compare *four* methods there: the three in `exploration.METHODS`, and a fourth of your own choice (another agent, or one
# of the three with other settings). Call `repeat` with 20 000 steps and 5 repetitions, and assign the results to `frozen`.
# Can you find a fourth that solves the lake in all five runs?
#
# <details><summary>Hint</summary>repeat takes an environment, a dictionary of methods and the number of steps. A method is
# a function that makes an agent for an environment, and {**exploration.METHODS, "mine": ...} adds one.</details>

# %%
lake = gym.make("FrozenLake-v1", map_name="8x8", is_slippery=False)
frozen = None
### BEGIN SOLUTION
mine = {"optimistic": lambda lake: QLearning.create(lake, discount=0.9, initial_value=1.0)}
frozen = repeat(lake, {**exploration.METHODS, **mine}, 20_000, repetitions=5)
### END SOLUTION

# %% tags=["check"]
check(exercise_4, frozen)

# %% [markdown]
# ### The open challenge: learn to climb in 5 000 steps
# A wall of height 60 with two grips, and 5 000 steps in all: how *early* can an agent know the way? Write an agent of
# your own. It is tried on ten walls that belong to your name, and nobody else has the same ones. Of the task it is told
# only the two spaces. Its points are its average return over training, in percent of what is possible: an explorer that
# takes no avoidable step needs 975 steps on average to reach the top for the first time, and knows the way from then on.
#
# Everything is allowed that learns from its own steps. Half a page with it: what does your agent remember, why does that
# find the top, and where would it fail?


# %%
def my_agent(wall):
    """Make the agent for the challenge; put your own in its place."""
    return GoExplore.create(wall, learning_rate=0.5, discount=0.9, explore_steps=10)


CHALLENGE.score(my_agent, "Ada Lovelace")

# %% [markdown]
# ## What you saw
#
# - Random exploration takes a number of steps that grows exponentially with the depth of the reward. It is not slow,
#   it is hopeless.
# - A novelty reward gives the agent something to learn from at every step. It draws the agent back to its frontier.
# - Getting back *while exploring* fails more often the farther away the frontier is. Returning first, and exploring
#   only then, avoids that. Optimistic initial values are another remedy: what is needed is exploration that is
#   *systematic*, where ε-greedy only slips.
# - A bonus is part of the task as long as it is paid: it can make the agent prefer exploring to the goal.
#
# ### Limits
# A table can count visits of a state. The same picture hardly ever comes twice, so for pictures something must stand
# in for counts (density models, prediction errors). Go-Explore here stores a value for every action in every state for
# every goal, which a wall of height 100 allows and few other tasks do. And the agent must know its state: where the
# state is hidden, it cannot tell whether it has returned.
#
# ### Further reading
# - Moerland et al. (2023), *EduGym: An environment and notebook suite for reinforcement learning education*: the
#   paper.
# - Sutton and Barto, *Reinforcement Learning*, 2nd edition: 2.2–2.7 (exploration in bandits), 8.3 (a bonus for actions
#   that were not tried for a long time).
# - Ecoffet, Huizinga, Lehman, Stanley and Clune (2021), *First return, then explore*: detachment and derailment.
# - Strehl and Littman (2008), *An analysis of model-based interval estimation for Markov decision processes*: the
#   bonus $\beta / \sqrt{n}$.
# - Singh, Barto and Chentanez (2004), *Intrinsically motivated reinforcement learning*: a bonus not for rare states,
#   but for errors in predicting the outcome of skills.
# - Amin, Gomrokchi, Satija, van Hoof and Precup (2021), *A survey of exploration methods in reinforcement learning*.
# - Strens (2000), *A Bayesian framework for reinforcement learning*: the chain on which this wall is based.
