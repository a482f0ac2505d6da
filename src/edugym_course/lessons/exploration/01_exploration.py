# %% [markdown]
# # Exploration: Boulder
#
# **The challenge.** An agent can only learn from rewards that it finds. When the only reward is at the end of a long
# sequence of right choices, random actions do not find it, and something else must drive the agent on. *Exploration* is
# to try what may not be best, in order to find out more.
#
# **You will be able to** explain why random exploration fails on sparse rewards, and by how much; turn a novelty
# reward into four lines of code, and say why it slows down; explain how "first return, then explore" avoids that; and write
# an explorer of your own.
#
# **Time.** {time} **Before you start.** You should know what a value function and
# Q-learning are (Sutton and Barto, 2nd edition, sections 3.5 and 6.5), and ε-greedy action selection (section 2.2):
# lesson 0 has them all. All symbols are in the [table of
# notation](https://github.com/RLG-Leiden/edugym/blob/main/docs/notation.md).

# %%
from typing import NamedTuple

import gymnasium as gym
import numpy as np

from edugym import CountBased, EpsilonGreedy, GoExplore, QLearning, make_mdp, record_visits, repeat
from edugym.agents.tables import best_value, epsilon_greedy_action, greedy_action, one_step_target, tied
from edugym.experiments.figures import Sheet
from edugym.experiments.figures.sheet import in_pairs
from edugym.training.attempt import attempt
from edugym_course.lessons.exploration import climbs, figures, fork, optimism, stalling
from edugym_course.lessons.exploration.methods import METHODS, OPTIMIST, compare, paper_methods, visits_of
from edugym_course.notebook import frames, play, predict, sliders, source

# %% [markdown]
# ## Meet the environment: a wall on which one grip holds
#
# A climber stands before a wall of height $H$. At every height there are $N$ grips. One holds, drawn at random for each
# height; who reaches for another falls into the rope and is back on the ground. The climber sees its own height, and
# nothing else.

# %%
env = gym.make("edugym/Boulder-v0", height=8, n_grips=3, layout_seed=18).unwrapped
env.reset(seed=0)
for action in env.mdp.grips[:3]:  # the first three grips that hold
    env.step(int(action))
env.scene()

# %% [markdown]
# As a Markov decision process: $s$ is the state, $a$ the action, $s'$ the next state, and $p$ a probability.
#
# | | | in words |
# |---|---|---|
# | states | $\mathcal{S} = \{0, 1, \dots, H\}$ | the position: 0 is the ground, $H$ the top |
# | actions | $\mathcal{A} = \{0, \dots, N-1\}$ | the grip to reach for |
# | dynamics | $p(s+1 \mid s, a) = 1$ for the right grip | it leads one position up |
# | | $p(0 \mid s, a) = 1$ for the other grips | they lead to the ground |
# | reward | $r(s, a, s') = 1$ if $s' = H$, else $0$ | only the top is rewarded |
# | discount | $\gamma = 0.9$ | used by the agents; the returns in the figures are not discounted |
#
# An episode *terminates* at the top. After $10 H$ steps it is *truncated*: a new episode begins, although the task was
# not at its end.
#
# These five methods are the environment. (`rng` draws random numbers, which the wall does not need.)

# %%
source(type(env.mdp), "initial", "transition", "reward", "terminal", "observation")

# %% [markdown]
# **Play it yourself, blind.** You see what the agent sees: your position. The picture comes when the episode is over.
# How many steps do you need to the top? And what do you *remember* on the way?

# %%
play("Boulder", height=8, n_grips=2, layout_seed=5, blind=True)

# %% [markdown]
# ## The idea: three ways to explore
#
# All three agents of this lesson learn by **Q-learning**, as in lesson 0. It keeps a table with a value $Q(s, a)$ for
# each action in each state. After every step from $S$ by $A$ to $S'$ with reward $R$ it moves one value a little, by the
# learning rate $\alpha$, towards a target (Sutton and Barto, equation 6.8):
#
# $$
# Q(S, A) \leftarrow Q(S, A) + \alpha \left[ R + \gamma \max_a Q(S', a) - Q(S, A) \right]
# $$
#
# After a terminal state there is no future, and the target is $R$ alone. Here are the lines that run, and below them the
# target:

# %%
source(QLearning.learn)

# %%
source(one_step_target)

# %%
source(best_value)

# %% [markdown]
# The agents differ in how they *explore*: in what they do before they know anything.
#
# ### Try at random
# **ε-greedy** takes a random action with probability $\varepsilon$, and otherwise the action that it believes best:
#
# $$
# A = \begin{cases} \text{a random action} & \text{with probability } \varepsilon \\
# \arg\max_a Q(S, a) & \text{otherwise, ties broken at random} \end{cases}
# $$

# %%
source(epsilon_greedy_action)

# %%
source(greedy_action)

# %% [markdown]
# (`replaces(ties, rng)` is true with probability 1/ties: so equal actions are taken equally often. `tied` comes up
# in an aside after exercise 2.)
#
# Before the first reward all values in $Q$ are zero, all actions are tied, and the climber acts at random. This is one
# episode on a wall of height 12, after 600 steps of training.


# %%
def watch(method, height=12, after=600):
    """Show one episode of training, after so many steps of training before it."""
    wall = make_mdp("Boulder", height=height, layout_seed=5)
    actions = attempt(METHODS[method], wall, after, seed=1)
    return frames(wall, actions, max_steps=120)


watch("ε-greedy")

# %% [markdown]
# How long until it reaches the top? It needs $H$ right choices in a row, each with probability $1/N$. Let $m_h$ be the mean
# number of steps from the ground to height $h$, with $m_0 = 0$. To get to height $h + 1$, the climber first gets to $h$
# and then takes one more step. With probability $1 - 1/N$ that step is wrong, and everything starts again:
#
# $$
# m_{h+1} = m_h + 1 + \left(1 - \tfrac{1}{N}\right) m_{h+1}
# \quad\Rightarrow\quad m_{h+1} = N \, (m_h + 1)
# \quad\Rightarrow\quad m_H = N + N^2 + \dots + N^H = \frac{N^{H+1} - N}{N - 1}
# $$
#
# (This holds without a step limit, which cuts off some good climbs.)

# %%
for height in (10, 30, 100):
    steps = (2 ** (height + 1) - 2) / (2 - 1)
    print(f"height {height:3}: {steps:.3g} steps until a random climber reaches the top for the first time")

# %% [markdown]
# ### Look for what is new
# **Novelty reward.** Let $n(s)$ count how often state $s$ was entered, and pay a *bonus* for entering a state that was
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
# the agent to its *frontier*, the highest position so far. Actions are still chosen by ε-greedy. In the code, `visits`
# holds $n(s)$, and `bonus` is $\beta$.

# %%
source(CountBased.learn)

# %% [markdown]
# The same wall, after the same number of steps: it climbs to about the same place again and again.

# %%
watch("novelty reward")

# %% [markdown]
# ### First return, then explore
# **Go-Explore** separates getting back from exploring. It keeps an archive of all states that it has met. For each
# attempt it chooses the least visited of them as its *goal* $g$, returns to it *without* exploring, and only then takes
# 20 random steps. The next attempt begins where this one ended. (To be chosen counts as a visit too, so that the goals take turns.) What changes within an attempt is
# in `self.now`, each number as an array with one entry: `goal[0]` is the goal. (The fields of a `NamedTuple` are fixed,
# the entries of its arrays are not.)

# %%
source(GoExplore, "act", "least_visited")

# %% [markdown]
# To be able to return, it learns a value $Q(g, s, a)$ for every goal: how good is action $a$ in state $s$ if you want to
# get to $g$? Let $1\{\cdot\}$ be 1 if the condition is true, and 0 otherwise. To reach the goal is worth 1, and ends the
# task:
#
# $$
# Q(g, S, A) \leftarrow Q(g, S, A) + \alpha \left[ 1\{S' = g\} + \gamma\, 1\{S' \neq g\} \max_a Q(g, S', a) - Q(g, S,
# A) \right]
# $$
#
# After each attempt it learns about *every* state on its path as if that state had been the goal, from the last step back. This is called
# *hindsight*: an attempt that misses its goal still teaches the way to where it went.
#
# And the reward of the task? It does not guide the exploration. The agent only remembers the state in which it received
# the highest reward so far, `best_state`. When it is evaluated, it goes there.

# %%
source(GoExplore, "learn", "learn_to_reach")

# %% [markdown]
# The same wall once more, after the same number of steps. The climber goes straight up to its goal, and from there
# reaches for random grips, 20 times. Then it has a new goal.

# %%
watch("Go-Explore")

# %% [markdown]
# ## The experiment: three walls
#
# This is the figure of the paper (Moerland et al., 2023): walls of height 10, 30 and 100, two grips, three methods, 20
# 000 steps.
#
# | setting | value |
# |---|---|
# | all | tabular Q-learning, $\alpha = 0.5$, $\gamma = 0.9$, ties broken at random |
# | ε-greedy and novelty reward | $\varepsilon = 0.1$ |
# | novelty reward | $\beta = 1$ |
# | Go-Explore | 20 random steps from each goal |
# | evaluation | one episode without exploring, every 200 steps |
# | repetitions | 100, each on its own wall, the same wall for all methods |
# | bands | 95 % intervals; they have a width even where all 100 runs agree, since the next run might not |
#
# Two black lines come from the exact model: the optimum (dashed), and the best *ε-soft* policy (dotted), which takes a
# random action with probability $\varepsilon = 0.1$ all the time. Evaluation does not explore, so a learner may rise
# above the dotted line; an ε-greedy agent cannot while it *trains*.
#
# The cell after the next is the whole experiment. `record_visits` counts how often an agent is at each height. (Further
# down `compare(height, ...)` does all this, with other settings.)
#
# **Predict.** A random climber needs two billion steps to the top of the middle wall. Which methods will solve it in
# 20 000?

# %%
middle = predict(
    "Which methods solve the wall of height 30?",
    ["none", "Go-Explore", "novelty reward and Go-Explore", "all three"],
)
middle

# %%
settings = {"learning_rate": 0.5, "discount": 0.9}
slips = {**settings, "exploration": EpsilonGreedy(0.1)}
agents = {
    "ε-greedy": lambda wall: record_visits(QLearning.create(wall, **slips), wall, 20_000),
    "novelty reward": lambda wall: record_visits(CountBased.create(wall, bonus=1.0, **slips), wall, 20_000),
    "Go-Explore": lambda wall: record_visits(GoExplore.create(wall, explore_steps=20, **settings), wall, 20_000),
}
walls = {
    height: repeat("Boulder", agents, 20_000, parameters={"height": height}, repetitions=100)
    for height in (10, 30, 100)
}
display(figures.learning_curves(walls))
print("runs that solve height 10 by step 2 000, and heights 10, 30 and 100 at the end:")
for method in METHODS:
    early, at_the_end = walls[10].curves(method).loc[2_000].mean(), [walls[h].final(method).mean() for h in walls]
    print(f"{method:14} {early:4.0%};", *(f"{share:4.0%}" for share in at_the_end))
solvers = [method for method in walls[30].methods if walls[30].final(method).mean() > 0.5]
middle.measured({0: "none", 1: "Go-Explore", 2: "novelty reward and Go-Explore", 3: "all three"}[len(solvers)])

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** ε-greedy solves only the low wall. It is faster than the novelty reward at first, and slower later: after 2 000 steps it solves
# it in about three runs of ten, and the novelty reward in six. The novelty reward solves the middle wall as well.
# Go-Explore solves all three. On the high wall the lines of the other two coincide at 0; the last panel shows how high
# they got. (On the lower walls even a policy that keeps exploring reaches the top in nearly every episode, so the two
# black lines coincide. On the high wall it does so in a quarter only; "See inside" says why.)
# </details>

# %% [markdown]
# ## Your turn
#
# How high can the novelty reward climb? What do more grips change, and for which method? Which methods feel
# $\varepsilon$, and which $\beta$? Move a slider and release it: the experiment is computed again, with 10 repetitions.


# %%
def one_wall(height=20, n_grips=2, epsilon=0.1, beta=1.0, gamma=0.9):
    """Draw the learning curves and the progress of the three methods on walls of one kind."""
    methods = paper_methods(epsilon, beta, gamma)
    results = compare(height, methods=methods, n_grips=n_grips, repetitions=10)
    curves = figures.curves(results, height, n_grips, epsilon)
    progress = figures.progress(results, height, title=f"ε = {epsilon:g}, β = {beta:g}, γ = {gamma:g}")
    return Sheet("one wall", [[curves, progress]])


sliders(
    one_wall,
    height=(5, 100, 5),
    n_grips=(2, 5),
    epsilon=(0.0, 1.0, 0.05),
    beta=(0.0, 5.0, 0.25),
    gamma=(0.5, 0.99, 0.01),
)

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** With ten runs each:
#
# - **height.** The novelty reward solves 20 in all runs, and 40 in about a quarter. At 60 and 80 its frontier ends near 40.
# - **n_grips.** At height 60 the novelty agent gets to 27 with three and to 19 with five. Go-Explore
#   still solves it with three, and with five in nearly all of 100 runs.
# - **ε.** Only the novelty agent feels it much: on height 20 it solves the wall in most runs with 0.05 to 0.5, and in
#   few or none with 0 and from 0.65 on.
# - **β.** Only the novelty agent has it. At height 20 it fails with 0, where it is ε-greedy, and in most runs with 5.
# - **γ.** At height 20 it solves the wall in all runs with 0.8 to 0.95, and in none with 0.99 ("Predict, then check" shows one reason).
# </details>

# %% [markdown]
# ## See inside: where do they spend their time?
#
# Where does each method go in its 20 000 steps on the high wall? Each map is the mean of the 100 runs above. Time runs to
# the right and the wall upwards; darker means more visits, and white means none.

# %%
in_pairs("visits", figures.visit_maps(walls[100], 100))

# %% [markdown]
# - **ε-greedy** gets to about 14 on average, and only by luck. It has nothing to learn from.
# - **Novelty** climbs fast at first, and then ever more slowly: after 20 000 steps its frontier is near 40 on average.
# - **Go-Explore** moves its frontier up steadily, to the top.
#
# ### Why does novelty slow down? The way back
# To see something new, the agent must first get back to its frontier, *while it keeps taking random actions*. A *slip*
# is a random action that is not the one the agent believes best. With
# two grips it happens with probability $\varepsilon/2 = 0.05$ at every step. A *climb* is what lies between two visits
# of the ground. So even a climber who knows the way gets back to height $h$ in only a share of $0.95^h$ of its climbs.
# This is **derailment** (Ecoffet et al., 2021). Does it happen?

# %%
Sheet("climbs", [[figures.climb_shares(walls[100], 100)]])

# %% [markdown]
# Only climbs of the second half of training count. The novelty agent follows the dashed line, $0.95^h$, as far as it
# knows the way by then. Higher places it gets to know later, and in some runs never, so there its line drops faster. Go-Explore returns without exploring, so
# its climbs do not derail. Its line is flat, up to the last positions, because nearly all goals are
# close to the top then. Four of five of its climbs end near the ground: after a fall it takes the rest of its 20 random steps from there.
#
# A climber who knows the way to 40 gets back in one climb of eight ($0.95^{40} = 0.13$); at height 100 it would be
# six in a thousand. An episode of 1 000
# steps has some fifty climbs: that is why the dotted line of the high wall was at 0.25 and not at 0.006.
#
# ### Why does novelty slow down? The grip at the frontier
# **Predict.** At its frontier the agent knows neither of the two grips, so on its first visit it takes the right one half
# of the time. If it took the wrong one, it falls, and comes back some climbs later. How often does it take the right grip
# then?

# %%
again = predict("The right grip on later visits of the frontier:", unit="%")
again

# %%
watched = stalling.watch_frontier(height=100, methods=METHODS, repetitions=50)
display(Sheet("frontier", [[stalling.frontier_lines(watched)]]))
for method in watched.methods:
    shares = [np.mean(stalling.right_grips(watched, method, *visits)) for visits in ((1, 1), (2, 10))]
    print(f"{method:14} right grips on the first visit {shares[0]:.0%}, on later visits {shares[1]:.0%}")
again.measured(100 * np.mean(stalling.right_grips(watched, "novelty reward", first=2)))

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** On the first visit 51 %, on all later ones 5 %, and that is $\varepsilon/2$: it takes the right grip
# only when it slips. Go-Explore and ε-greedy act at random at their frontiers, and take the right grip about half of
# the time. A line ends after the ninth visit, or where
# there were fewer than 30.
# </details>

# %% [markdown]
# Why does it prefer a grip from which it has fallen? Two reasons come to mind. The fall earned a *bonus*, for entering
# the ground. Or it is the *first value*: the wrong grip leads to the ground, where the whole way up begins, and a grip
# that was never tried is worth 0. Remove each, and see whether the effect goes.

# %%
causes = stalling.watch_frontier(height=100, methods=stalling.CAUSES, repetitions=50)
for method in causes.methods:
    print(f"{method:23} right grips on later visits {np.mean(stalling.right_grips(causes, method, 2)):.0%}")

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Without a bonus for the ground nothing changes. With values that start at 10, the discounted sum of a bonus of 1
# in every step, the agent takes the right grip nine times of ten. So it is the first value: what was never tried is worth 0, and even
# the ground is worth more.
# </details>

# %% [markdown]
# So high on the wall novelty slows down for two reasons, the way back and the grip, and they multiply. At a frontier of
# 40, one climb in eight of an agent that knows the way gets back, and one visit in twenty takes the right grip: that
# makes about 160 climbs after each wrong first try.
# And the two pull in opposite directions: slips end the climbs, and slips are what it needs at the frontier. (Exercise
# 3 mends both.)

# %% [markdown] tags=["aside"]
# ### Aside: two branches, and whether a frontier is forgotten
# There is another reason why novelty may get stuck, **detachment**: the bonus at a frontier
# fades with every visit, so that the agent may turn to another frontier and never come back (Ecoffet et al., 2021). One
# wall has one frontier and cannot show that. So here is a wall with two branches of height 100. The first action chooses the
# branch, left or right. The only reward is at the flag, on top of the right-hand one. (The picture shows lower branches.)

# %%
low_fork = fork.Fork.create(height=8, layout_seed=8)
low_fork.scene(8 + 3)  # positions 1 to 8 are the left branch, 9 to 16 the right one

# %% [markdown]
# **Predict.** The novelty agent has climbed some way up one branch, and the bonus there has faded. What does it do in the
# rest of its 20 000 steps?

# %%
two_branches = predict(
    "With two branches, the novelty agent ...",
    ["stays with one branch", "turns to the other branch for good", "turns to the other branch and comes back"],
)
two_branches

# %%
forks = fork.compare_on_fork(repetitions=10)
runs = visits_of(forks, "novelty reward")
display(fork.fork_maps(runs[0]))
print("mean height of the higher frontier:", np.mean([fork.higher_frontier(visits) for visits in runs]))
print("mean number of changes of branch:", np.mean([fork.turns(visits) for visits in runs]))
print("runs that come back to both frontiers:", sum(fork.returns_to(visits) for visits in runs), "of", len(runs))
if np.mean([fork.turns(visits) for visits in runs]) < 1:
    seen = "stays with one branch"
else:
    back = np.mean([fork.returns_to(visits) for visits in runs]) > 0.5
    seen = "turns to the other branch and comes back" if back else "turns to the other branch for good"
two_branches.measured(seen)

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** It turns away, sometimes for thousands of steps, and it comes back: about 15 turns in 20 000 steps, and
# all runs return to both frontiers. So the agent does leave a frontier that it should push on, but lasting detachment
# does *not* appear here. We think that there are two reasons: the bonus $\beta/\sqrt{n}$ fades but never ends, and a table
# does not forget the way, as a neural network can. What two branches do cost is time: the higher of the two frontiers gets
# to 27 on average (to 29 in 300 runs), and the one frontier of a single wall to nearly 40.
# </details>

# %% [markdown]
# ## Predict, then check
#
# **Predict.** Random steps end most climbs. Switch them off: train the novelty agent with $\varepsilon = 0$ on a wall
# of height 100. Its frontier was near 40 with $\varepsilon = 0.1$. Where is it now?

# %%
no_slips = predict("The highest position with ε = 0, a mean over the runs:", unit="grips")
no_slips


# %%
def highest_visited(epsilon, height=100):
    """Return the highest position that the novelty agent ever visited, a mean over 20 repetitions."""
    methods = {"novelty": paper_methods(epsilon)["novelty reward"]}
    results = compare(height, methods=methods, repetitions=20)
    return np.mean([climbs.frontier(visits) for visits in visits_of(results, "novelty")])


print(f"ε = 0.1: highest position {highest_visited(0.1):.1f}")
no_slips.measured(highest_visited(0.0))

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** With $\varepsilon = 0$ it hardly leaves the ground: its highest position is about 1. After the first
# wrong grip the untried one looks worse for ever, and there is no slip that would try it. The novelty reward pulls the
# agent back to its frontier, and a random step takes it beyond.
# </details>

# %% [markdown]
# **Predict.** Often the discount is set nearer to 1. Does the novelty agent do better on a wall of height 10
# with $\gamma = 0.99$ than with $\gamma = 0.9$?

# %%
far_sighted = predict("With γ = 0.99 the novelty agent solves height 10 ...", ["more often", "as often", "less often"])
far_sighted

# %%
shares = {}
for gamma, beta in ((0.9, 1.0), (0.99, 1.0), (0.99, 0.1)):
    methods = {"novelty": paper_methods(bonus=beta, discount=gamma)["novelty reward"]}
    shares[gamma, beta] = compare(10, methods=methods, repetitions=20).final("novelty").mean()
    print(f"γ = {gamma}, β = {beta}: {shares[gamma, beta]:.0%} of the runs end with a policy that reaches the top")
difference = shares[0.99, 1.0] - shares[0.9, 1.0]
far_sighted.measured("more often" if difference > 0.1 else "less often" if difference < -0.1 else "as often")

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** All runs with 0.9, and none with 0.99. At the top the episode ends, and the bonuses end with it. With the higher discount, the many small bonuses of the
# future add up to more than the reward of 1, so the agent is paid for staying away from the top. The test of this is the
# last line: with bonuses of a tenth the reward is worth more again, and all runs reach the top. A bonus changes the
# *task*, not only the exploration.
# </details>

# %% [markdown]
# ## Exercises
#
# Each exercise has a cell for your answer, and below it a cell that checks it. The check does not only say whether an
# answer is right: it says what was expected, what came, and which mistake that looks like. It runs your code on cases
# that it makes up.

# %%
from edugym_course.grading import check
from edugym_course.lessons.exploration.exercises import CHALLENGE, exercise_1, exercise_2, exercise_3, exercise_4

# %% [markdown]
# ### Exercise 1: change a parameter
# An ε-greedy climber knows the whole wall and keeps exploring: at every step it takes a random grip with probability
# $\varepsilon$. On a wall of height 100 with two grips, at least half of its climbs should reach the top without a fall.
# What is the largest possible $\varepsilon$? Set `epsilon` to that number, by a formula or with six digits after the
# decimal point.
#
# <details><summary>Hint</summary>A random grip is the wrong one with probability 1/2, so a step goes wrong with
# probability ε/2. What is the probability that 100 steps in a row go right?</details>

# %%
epsilon = 0.1
### BEGIN SOLUTION
epsilon = 2 * (1 - 0.5 ** (1 / 100))
# own: epsilon = 2 * (1 - 0.5 ** (1 / {height}))
### END SOLUTION

# %% tags=["check"]
check(exercise_1, epsilon)

# %% [markdown]
# ### Exercise 2: optimistic initial values
# Let all values of $Q$ start at 1 instead of 0, and let the agent be greedy ($\varepsilon = 0$). All that it
# tries below the top is disappointing, since $\gamma < 1$, so it goes on to actions that it has not tried yet (Sutton and Barto, section 2.6). Write the
# function that makes this Q-learning agent, with the lesson's learning rate 0.5 and discount 0.9. Before you run the
# check: which of the three walls will it solve?
#
# <details><summary>Hint</summary>One call of <code>QLearning.create</code> is enough. Its first argument is the wall. Its settings are
# <code>learning_rate</code>, <code>discount</code>, <code>exploration</code> and <code>initial_value</code>, and
# <code>EpsilonGreedy(0.0)</code> never explores.</details>


# %%
def optimist(wall):
    """Make a greedy Q-learning agent that values every action at 1 until it has tried it."""
    ### BEGIN SOLUTION
    return QLearning.create(wall, learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0), initial_value=1.0)
    # own: return QLearning.create(wall, learning_rate=0.5, discount=0.9, exploration=EpsilonGreedy(0.0), initial_value={start})
    ### END SOLUTION


# %% tags=["check"] points=2
check(exercise_2, optimist)
### BEGIN HIDDEN TESTS
check(exercise_2, optimist, seed=1, quiet=True)
### END HIDDEN TESTS
display(figures.race({"optimist": optimist}))

# %% [markdown]
# <details><summary>What the race shows</summary>
#
# It solves the low wall and the middle one. On the high wall every run gets to the top, after some 17 000 steps, but few
# policies do: with $\alpha = 0.5$ each disappointment takes only half of the optimism away.
# </details>
#
# **How far does optimism carry?** With the learning rate $\alpha = 1$ the agent believes every step at once. Let it race
# Go-Explore (as before, with $\alpha = 0.5$ and 20 random steps) on the high wall, with two grips and with three.
#
# **Predict.** With two grips both solve it. With *three* grips: whose greedy policy reaches the
# top in more of the evaluations? (Those before the first success count as failures, so whoever learns earlier is
# ahead.)

# %%
three_grips = predict("Height 100, three grips: more often at the top is ...", ["optimism", "Go-Explore"])
three_grips

# %%
methods = {**METHODS, "optimism": OPTIMIST}
panels = []
for n_grips in (2, 3):
    results = compare(100, methods=methods, n_grips=n_grips, repetitions=30)
    panels.append(figures.curves(results, 100, n_grips))
    for method in ("optimism", "Go-Explore"):
        average, first = results.average(method).mean(), optimism.first(results, method)
        print(f"{n_grips} grips: {method:10} {average:4.0%} of all evaluations; first at the top after", end=" ")
        print(f"{np.mean(first):.0f} steps on average (20 000 for a run that never gets there)")
display(Sheet("optimism", [panels]))
three_grips.measured(max(("optimism", "Go-Explore"), key=lambda method: results.average(method).mean()))

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** It is optimism. With $\alpha = 1$ it solves both walls, it first gets to the top sooner than Go-Explore, and
# it is ahead in the evaluations, with two grips hardly, with three clearly. But that is Go-Explore with 20 random steps:
# with 8 it is ahead of optimism with three grips (0.26 against 0.21 in 60 other runs).
# </details>

# %% [markdown] tags=["aside"]
# ### Aside: values that are equal but for rounding
# The first version of this lesson said that Go-Explore is ahead, and it was wrong. With $\alpha = 1$ all values are powers of
# $\gamma$, and many of them are equal. But a computer rounds: $Q + 1 \cdot (T - Q)$ is not always $T$ in the last digit. A
# greedy policy that compares with `==` then finds no tie where there is one, and takes the same one of
# two equal actions each time. With $\gamma = 0.9$ such an optimist reaches the top in 34 % of the evaluations with two
# grips, not in 57 %, and looks worse than Go-Explore. The cause is the rounding: with $\gamma = 0.5$, whose powers a
# computer stores exactly, the same program is as good as ours. So our `greedy_action` takes values as equal if they differ
# by less than $10^{-12}$ of the best one. The next two cells show it.
#
# Three rules follow. Do not ask whether two computed numbers are *equal*, but whether they are close, relative to their size. Do not break ties by
# `argmax`, which takes the first. And before you explain a result, change what should not matter (here $\gamma$), and see
# whether it stays.

# %%
source(tied)

# %%
for label in ("optimism", "optimism, γ = 0.99", "last digit, γ = 0.9", "last digit, γ = 0.5"):
    digits = compare(100, methods={label: optimism.OPTIMISTS[label]}, repetitions=30)
    print(f"two grips: {label:20} {digits.average(label).mean():4.0%} of all evaluations at the top")

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
#   it takes the best grip, ties broken at random: `self.greedy(state, rng)`. It never takes another random step.
#
# The fields `learning_rate`, `discount` and `bonus` are $\alpha$, $\gamma$ and $\beta$; read them from `self`. You write
# plain Python, and it runs as machine code, tens of millions of steps a second. (The race compiles it first, which takes
# ten seconds or more.) Before you run the check: how high will it climb in 20 000 steps?
#
# <details><summary>Hint</summary>The largest value in the row of the next state is
# <code>max(self.Q[next_state])</code>. Count before you divide. A loop over <code>range(self.Q.shape[1])</code> visits
# every grip.</details>


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
        return greedy_action(self.Q, state, rng)

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
        # own: novelty = self.bonus / self.visits[next_state] ** {power}
        value = 0.0 if terminated else max(self.Q[next_state])
        target = reward + novelty + self.discount * value
        self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])
        ### END SOLUTION


# %% tags=["check"] points=3
check(exercise_3, MyExplorer)
### BEGIN HIDDEN TESTS
check(exercise_3, MyExplorer, seed=1, quiet=True)
### END HIDDEN TESTS
display(figures.race({"my explorer": MyExplorer.create}))

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** In the end it solves the high wall in every run shown: systematic trying takes the place of random steps. It needs
# more steps than Go-Explore: it first reaches the top after 12 900 steps on average, and Go-Explore after 9 400 (60 other runs). With $\alpha = 1$ it gets there after 8 000, but then fewer runs end with a policy that solves the wall. On the middle wall its line trembles after 12 000 steps, since the bonus is still paid and still
# moves the values of the grips: with bonuses of 0.3 it does not.
# </details>

# %% [markdown]
# ### Exercise 4: swap in another environment
# The same agents learn in any Gymnasium environment with whole numbers for observations and actions. FrozenLake with a
# map of 8 by 8, not slippery, is a sparse task too: its only reward is in the far corner, 14 steps away, and a fall into
# one of its holes ends the episode. Predict first: will the novelty reward help as much as on the wall?
#
# Compare *four* methods there: the three in `METHODS`, under their names, and a fourth of your own choice
# (another agent, or one of the three with other settings). Call `repeat` with 20 000 steps and 5 repetitions (some 20 seconds), and
# assign the results to `frozen`. Can you find a fourth *without goals* that solves the lake in at least four of the five
# runs?
#
# <details><summary>Hint</summary><code>repeat</code> takes an environment, a dictionary of methods and the number of
# steps. A method is a function that makes an agent for an environment, and
# <code>{**METHODS, "mine": ...}</code> adds one. The number of repetitions is given by its name:
# <code>repeat(lake, methods, 20_000, repetitions=5)</code>.</details>

# %%
lake = gym.make("FrozenLake-v1", map_name="8x8", is_slippery=False)
frozen = None
### BEGIN SOLUTION
mine = {"optimistic": lambda lake: QLearning.create(lake, discount=0.9, initial_value=1.0)}
frozen = repeat(lake, {**METHODS, **mine}, 20_000, repetitions=5)
# own: frozen = repeat(lake, {{**METHODS, **mine}}, 20_000, repetitions=5, seed={experiment_seed})
### END SOLUTION

# %% tags=["check"]
check(exercise_4, frozen)

# %% [markdown]
# ### The open challenge: learn to climb in 5 000 steps
# A wall of height 60 with two grips, and 5 000 steps in all: how *early* can an agent know the way? Write an agent of
# your own. It is tried on ten walls that belong to your name, and nobody else has the same ones. Of the task it is
# told only its observation space and its action space. It needs `act` and `learn`, like yours of exercise 3, which is too slow for this wall. Points:
# the average return of its evaluations during training (by `greedy`, if it has one), in percent of that of an explorer
# that reaches the top after 975 steps, the mean without an avoidable step, and knows the way from then on.
#
# Everything is allowed that learns from its own steps. Write half a page: what does your agent remember, why does that
# find the top, and where would it fail?


# %%
def my_agent(wall):
    """Make the agent for the challenge; put your own in its place."""
    return GoExplore.create(wall, learning_rate=0.5, discount=0.9, explore_steps=10)


CHALLENGE.score(my_agent, "Ada Lovelace")

# %% [markdown]
# ### From a blank file
# Now write it all yourself, from an empty cell, with NumPy and Gymnasium only: a program that finds its way up a wall
# of height 30, in 3 000 steps. How it explores is up to you: by counts, by optimism, by going back first (with some 10 random steps), or by an
# idea of your own. (Optimism with α = 0.5 as in exercise 2, the explorer of exercise 3, and first values far above the reward of the top need more steps.) Some 30 lines are enough.
#
# **What it must do.** `my_program(environment, n_steps, seed)` takes `n_steps` steps in a Gymnasium environment, episode after
# episode. In the end it returns its *policy*: a function that takes a state and returns an action, the same at each visit, and climbs to the top
# without a fall. All else is up to you: functions, classes, any names.
#
# - States and actions are whole numbers from 0. `environment.observation_space.n` and `environment.action_space.n` say how
#   many there are. The walls have two grips or three, and are all different. On some of them an episode
#   is truncated soon, after 35 steps.
# - Draw all random numbers from `np.random.default_rng(seed)`, and give the seed to the first `reset` alone.
#
# The check runs your program on several walls. It sees the steps that your program takes, and no line of it. So the mistake
# that it names is only the likely one, and a mistake that does no harm passes.

# %% tags=["project"]
my_program = ...  # your program
### BEGIN PROGRAM


def my_program(environment, n_steps, seed):
    """Climb as far as the way is known, and try there what was not tried yet; return the way."""
    rng = np.random.default_rng(seed)
    n_states, n_actions = environment.observation_space.n, environment.action_space.n
    known = np.full(n_states, -1)  # the grip that holds at each place, -1 where none is known
    untried = [[int(grip) for grip in rng.permutation(n_actions)] for _ in range(n_states)]

    def policy(state):
        """The grip that holds, or one that was not tried."""
        return int(known[state]) if known[state] >= 0 else untried[state][0]

    state, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        action = policy(state)
        next_state, _, terminated, truncated, _ = environment.step(action)
        if next_state == state + 1:
            known[state] = action
        elif action in untried[state]:
            untried[state].remove(action)
        state = next_state
        if terminated or truncated:
            state, _ = environment.reset()
    return policy


### END PROGRAM

# %% tags=["project"]
from edugym_course.lessons.exploration.project import project_1

check(project_1, my_program)

# %% [markdown]
# ## What you saw
#
# ### In one paragraph
# *Learn it by heart, or better, say it in your own words.* An agent learns only from rewards that it finds, and
# where one wrong choice loses all, undirected random steps find a reward behind $H$ right choices among $N$ actions after
# about $N^H$ climbs. So
# exploration must be directed. A novelty reward makes rarely visited states attractive, optimistic values make untried
# actions attractive, and Go-Explore returns to the edge of what it knows before it explores. They work as far as they
# get back to what they have not tried. Random slips try new actions by chance, and the longer the way, the more often a slip
# ends it.
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
