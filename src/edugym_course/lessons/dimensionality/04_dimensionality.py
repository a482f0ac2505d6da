# %% [markdown]
# # Dimensionality: Catch
#
# **The challenge.** The same small task can be seen as three numbers, as fifty, or as an image. The more numbers an
# agent sees, the more different observations there *can* be. For a table another question counts: does the same
# observation ever come a second time?
#
# **You will be able to** compute how large a table must be, and say when a table over boards of pixels works after all; write the
# update of Q-learning with features instead of a table; follow the main lines of
# DQN, with its gradient computed by hand; and predict what an agent knows about situations that it has never met.
#
# **Time.** {time} **Before you start.** You
# should know Q-learning (Sutton and Barto, 2nd edition, section 6.5), ε-greedy action selection (section 2.2), and what
# a derivative is. All symbols are in the [table of
# notation](https://github.com/RLG-Leiden/edugym/blob/main/docs/notation.md).

# %%
import copy
from typing import Any, NamedTuple

import gymnasium as gym
import numpy as np

from edugym import DQN, EpsilonGreedy, LinearQLearning, QLearning, make_mdp, repeat
from edugym.agents import dqn, features
from edugym.agents.tables import greedy_action
from edugym.experiments.results.tables import joined
from edugym_course.lessons.dimensionality import (
    figures,
    gym_car,
    methods,
    networks,
    pictures,
    races,
    sharing,
    sizes,
    tasks,
)
from edugym_course.lessons.dimensionality.open_dqn import OpenDQN
from edugym_course.lessons.dimensionality.triad import w_to_2w
from edugym_course.notebook import frames, play, predict, sliders, source

# %% [markdown]
# ## Meet the environment: one task, seen in three ways
#
# A ball falls from the top of a board. The agent moves a paddle along the bottom, and has to catch it.

# %%
env = gym.make("edugym/Catch-v0", observation_type="grid").unwrapped
env.reset(seed=3)
for action in (2, 2, 1):
    env.step(action)
env.scene()

# %% [markdown]
# | | | in words |
# |---|---|---|
# | states | column and row of the ball, column of the paddle | columns from 0 to 4, rows from 0 to 9 |
# | actions | $\mathcal{A} = \{0, 1, 2\}$ | left, stay, right |
# | dynamics | the paddle moves by one column, then the ball falls by one row | at the edge the paddle stays |
# | reward | 1 or $-1$ at the end, 0 before | for a ball that is caught, or missed |
# | start | the ball in any column of the top row | the paddle in the middle |
# | discount | $\gamma = 0.9$ | used by the agents; returns in the figures are not discounted |
#
# The *optimum*, the best possible expected return, is 1: every ball can be caught. Random play returns $-0.6$ on
# average.
#
# The agent does not see this picture. It sees the state $s$ in one of three ways, and each of them tells the whole
# state while the ball falls:

# %%
for kind in ("vectorised", "grid", "rgb"):
    space = make_mdp("Catch", observation_type=kind).observation_space
    print(f"{kind:10} {int(np.prod(space.shape)):3} numbers: {space}")
observation, _ = env.reset(seed=3)
print(observation.astype(int))

# %% [markdown]
# "vectorised" is the state itself: the *positions*. "grid" is the *board* above, with a 1 at the ball and at the
# paddle; each of its 50 numbers is a *pixel*. "rgb" is an *image*: red, green and blue for each of the 50 cells.
#
# **Play it yourself, blind.** You see "grid" as ten lines of five numbers. An agent starts with less: it does not even know that two pixels are neighbours.

# %%
play("Catch", blind=True)

# %% [markdown]
# ## The idea: from a table to a network
#
# ### A table has a row for every observation
# Q-learning keeps one number $Q(s, a)$ for each observation and action, and moves it towards a target by the learning
# rate $\alpha$ (equation 6.8). The numbers of one observation are a *row* of the table.
#
# $$
# Q(S, A) \leftarrow Q(S, A) + \alpha \left[ R + \gamma \max_a Q(S', a) - Q(S, A) \right]
# $$

# %%
source(QLearning.learn)

# %% [markdown]
# A *dense* table has a row for every observation that could be written down. With 50 pixels that are 0 or 1 there are
# $2^{50}$ of them; with 150 numbers from 0 to 255 there are $256^{150}$.

# %%
positions, grid, image = (sizes.rows_of_table(kind) for kind in ("vectorised", "grid", "rgb"))
print(f"positions: {positions} rows")
print(f"grid:      {grid:.3g} rows, or {grid * 3 * 8 / 1e15:.0f} petabytes (three numbers of 8 bytes a row)")
print(f"image:     a number of rows with {len(str(image))} digits")
figures.size_sheet()

# %% [markdown]
# The y axis is the *power of ten*, and it is logarithmic: at $10^2$ a number has a hundred
# digits. The line of the network, which we will come to, counts weights, all others rows. Only 195 boards can be seen while the ball falls, one
# for each state that can occur (less than $5 \cdot 9 \cdot 5$, since the paddle starts in the middle). So a table could
# hold rows for those boards alone. A *hashed* table does: it gives a row to each board when it is seen for the first
# time.
#
# ### Features: rows that share
# In a table each row is learned alone. To learn about many states at once, describe a state by some numbers, its
# *features* $x_1(s), x_2(s), \dots$, and let the value be a weighted sum of them, with weights $w_{ia}$ for each
# feature $i$ and action $a$ (section 9.4; for actions 10.1):
#
# $$
# \hat q(s, a, w) = \sum_i x_i(s)\, w_{ia}
# $$
#
# The weights are learned like this. Call the target $y = R + \gamma \max_a \hat q(S', a, w)$ ($R$ alone if $S'$ is
# terminal). We want the squared error $\frac{1}{2} \left[ y - \hat q(S, A, w) \right]^2$ to become smaller. Its
# derivative with respect to a weight $w_{iA}$ of the action taken is $-\left[ y - \hat q(S, A, w) \right] x_i(S)$ if we
# take $y$ for a constant; for other actions it is 0. So a step of size $\alpha$ down the slope is
#
# $$
# w_{iA} \leftarrow w_{iA} + \alpha \left[ y - \hat q(S, A, w) \right] x_i(S) \qquad \text{for all } i
# $$
#
# But $y$ is no constant: it depends on $w$ as well, through the value of $S'$. That part of the derivative is left out.
# Hence the name *semi-gradient* (section 9.3). In the code, each computation of a value also writes the features of its
# state into `features`. So the value of $S$ is computed last, and `follow_gradient` uses its features. (`at_once`, by
# which the step is divided, is 1 here.)

# %%
source(LinearQLearning.learn)

# %%
source(features.follow_gradient)

# %% [markdown]
# A table is a special case: one feature for each state, which is 1 in this state and 0 elsewhere. Then the sum has one
# term, and the update is that of Q-learning.
#
# ### A network: features that are learned
# Somebody has to invent good features. A neural network with a *hidden layer* learns them. Its hidden units $h$ are
# features made from the pixels $x$. Each is a weighted sum, cut off at 0. The action values are weighted sums of these.
# $b_1$ and $b_2$ are numbers added to each sum, the *biases*. All these numbers together are called $\theta$.
#
# $$
# h = \max(0,\; W_1 x + b_1), \qquad Q(s, \cdot\,; \theta) = W_2 h + b_2
# $$
#
# In the code `first[i, j]` is the weight from input $i$ to hidden unit $j$, and `second[j, a]` that from hidden unit
# $j$ to action $a$. The biases come last: `first[len(x), j]` and `second[len(h), a]`.

# %%
source(dqn.forward)

# %% [markdown]
# DQN (section 16.5) learns $\theta$ by the same idea, with three additions:
#
# - **A memory.** The latest 10 000 transitions $(S, A, R, S')$ are kept, each with a note whether $S'$ is terminal.
#   Every four steps a *batch* of 32 of them is drawn at random. Those in a batch have little to do with each other.
# - **A target that is held still.** The targets are computed with an older copy $\theta^-$ of the weights, brought up
#   to date every 100 updates. (The aside on the deadly triad shows why.)
# - **A loss that does not explode.** The loss $L(\delta)$ is $\frac{1}{2} \delta^2$ for errors
#   $\delta = Q(S, A; \theta) - y$ up to 1 in size, and grows only linearly beyond. (This error is the value less the target, since we go *down* the slope of the loss.)
#
# Learning starts after 200 steps. Adam chooses the size of the step for each weight (see below).
#
# $$
# y = R + \gamma \max_a Q(S', a; \theta^-), \qquad
# \theta \leftarrow \theta - \text{a step of Adam along the gradient of the mean of } L\bigl(Q(S, A; \theta) - y\bigr)
# $$
#
# If $S'$ is terminal, $y = R$. In the code `self.target` is $\theta^-$, the old *weights*, and `target` is $y$. `batch`
# holds the places in the memory that were drawn. `act` draws them, since it is the only method that gets random
# numbers.

# %%
source(DQN, "learn", "add_gradient")

# %% [markdown] tags=["aside"]
# ### Aside: the rest of the agent
# These lines say how it acts, how it remembers, when an update is due, and how the old weights become new. The memory
# is written from its beginning again when it is full, hence `%`. (Weights, like counters, stand in arrays, since the
# fields of a `NamedTuple` are fixed: `self.steps[0]` is a number.)

# %%
source(DQN, "act", "write_values", "remember", "is_due")

# %%
source(dqn.copy)

# %% [markdown]
# ### Watch it
# This is one run of DQN after 12 000 steps, greedy; it has never seen anything but 50 pixels. It misses the balls from one
# of the five columns. From which? Change `seed` in the last line: with 3, 2, 1, 0, 4 the ball falls from column 0, 1,
# 2, 3, 4.

# %%
first_network = methods.learn(methods.seen(), methods.NETWORK, methods.network(), n_steps=12_000, repetitions=1, seed=1)
player, rng = first_network.agents[methods.NETWORK][0], np.random.default_rng(0)


def choose(board):
    """Choose the greedy action of the network for a board."""
    return player.greedy(np.ravel(board), rng)


frames("Catch", choose, seed=2)

# %% [markdown]
# ## The experiment: what does a table see in pixels?
#
# | setting | value |
# |---|---|
# | all | $\gamma = 0.9$, ε-greedy with $\varepsilon = 0.1$ |
# | table | Q-learning, $\alpha = 0.5$, all values start at 0, ties broken at random; 30 repetitions |
# | network | DQN, 64 hidden units, Adam with learning rate 0.001; 5 repetitions, so its bands are wide |
# | evaluation | 30 greedy episodes at each point |
#
# A line in the figures is the mean over the repetitions, and the band its 95 % confidence interval, which can pass
# above 1.
#
# First without noise. One table has a row for each of the 250 positions. The other is a hashed table of boards.
#
# The cell after the next is the whole experiment, once for positions and once for boards. Both have the same seeds, so
# run 7 of one table sees the same balls as run 7 of the other.
#
# **Predict.** How fast does the table of boards learn, compared with the table of positions?

# %%
slower = predict(
    "The table of boards learns ...",
    ["not at all: there are too many boards", "more slowly", "exactly as fast, number for number"],
)
slower

# %%
settings = {"learning_rate": 0.5, "discount": 0.9, "exploration": EpsilonGreedy(0.1)}
how = {"repetitions": 30, "evaluate_every": 250, "evaluation_episodes": 30, "jobs": 1}


def table(task):
    """Make Q-learning with a table for a task."""
    return QLearning.create(task, **settings)


by_position = repeat(tasks.catch("vectorised"), {methods.POSITIONS: table}, 5_000, **how)
by_board = repeat(methods.pixels(), {methods.PIXELS: table}, 5_000, **how)
display(figures.table_and_network({"no noise": joined([by_position, by_board])}))
curves = [one.curves(one.methods[0]).to_numpy() for one in (by_position, by_board)]
print(f"largest difference between the two, in all {curves[0].shape[1]} runs: {np.abs(curves[0] - curves[1]).max():g}")
slower.measured(slower.options[2 if (curves[0] == curves[1]).all() else 1])

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Exactly as fast. For a table the names of its rows mean nothing: "position (2, 3, 1)" and "the board
# with these two ones" are two names of the same row. So it is wrong that "a table cannot read pixels".
# </details>
#
# Now the pixels get noisy, in three ways. The first pixel takes one of 16 levels at random, at every step. Or all
# pixels get normal noise ($\sigma = 0.1$), cut off at 0 and 1. Or the whole board is darkened at every step by a random
# factor between 0.4 and 1.
#
# **Predict.** In how many of the three does the table come to a return above 0.5 within 30 000 steps?

# %%
sees = predict("The table gets above 0.5 in ...", ["none of the three", "one", "two", "all three"])
sees

# %%
panels = races.compare_sights(30_000, repetitions=(30, 5))
display(figures.table_and_network(panels))
late = {title: {m: r.curves(m).iloc[-5:].to_numpy().mean() for m in r.methods} for title, r in panels.items()}
for title, means in late.items():
    print(f"{title:30}", ", ".join(f"{label}: {mean:.2f}" for label, mean in means.items()), "(mean of five points)")
sees.measured(sees.options[sum(int(means[methods.PIXELS] > 0.5) for means in list(late.values())[1:])])

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** In one, that with one noisy pixel. It makes 16 rows of every board, and each is learned alone, so the
# table needs many more steps. With noise of real numbers, or a new brightness at every step, no board comes a second
# time. Every row is new, and the table acts at random for ever. The network learns in all four panels. One reason may
# be that its values are a continuous function of the pixels: boards that differ a little have values that differ a
# little. </details>

# %% [markdown]
# ## Your turn
#
# What decides how fast the table learns? Left: the size of the board. Right: the levels of one noisy pixel, on the
# usual board. Change $\varepsilon$, $\alpha$ and $\gamma$. Which matters? (10 repetitions of 20 000 steps.)


# %%
def one_table(columns=5, levels=16, epsilon=0.1, alpha=0.5, gamma=0.9):
    """Draw the learning curves of a table."""
    return figures.boards_figure(columns, levels, epsilon=epsilon, alpha=alpha, gamma=gamma)


ranges = {"columns": (2, 12), "levels": [2, 4, 16, 64, 256]}
sliders(one_table, **ranges, epsilon=(0.0, 1.0, 0.05), alpha=(0.05, 1.0, 0.05), gamma=(0.1, 1.0, 0.05))

# %% [markdown]
# <details><summary>What came out</summary>
#
# The columns and the levels matter most. On five columns without noise every setting of the other three that we
# tried came to 1 within 3 000 steps. One reason may be that only the column of the ball is random, so without noise a
# large $\alpha$ does no harm. All episodes have one length, so $\gamma$ only scales the values. With 16 levels $\alpha = 1$ ended at 0.68
# and $\varepsilon = 1$ at 0.76, instead of 0.84 (60 runs). </details>

# %% [markdown] tags=["aside"]
# ### Aside: turn the knobs of the network
# How much slower are fewer hidden units? What does a learning rate that is ten times larger
# do? How much noise does the network bear? (3 runs of 5 000 steps as thin lines, and their mean.)


# %%
def one_network(hidden=64, sigma=0.0, alpha=0.001, epsilon=0.1, gamma=0.9):
    """Draw the learning curve of DQN."""
    return figures.network_figure(hidden, sigma, alpha=alpha, gamma=gamma, epsilon=epsilon)


rates = {"alpha": [0.0001, 0.0003, 0.001, 0.003, 0.01], "epsilon": (0.0, 1.0, 0.05), "gamma": (0.1, 1.0, 0.05)}
sliders(one_network, hidden=[2, 4, 16, 64], sigma=(0.0, 0.3, 0.05), **rates)

# %% [markdown]
# <details><summary>What came out, as the mean of ten runs at 5 000 steps (to about 0.2)</summary>
#
# 2, 4 and 16 hidden units came to -0.30, -0.35 and 0.27, and 64 to 0.75. The learning rate
# 0.01 was *faster* here: with it 16 units came to 0.39 by step 2 500 and 0.85 by step 5 000, and 64 to 0.79 and 0.96. With $\sigma$ = 0.1, 0.2 and 0.3 the return was 0.45, -0.15 and -0.46. But 5 000 steps
# are few: with $\sigma = 0.1$ it came to 0.99 in the 30 000 steps above. </details>

# %% [markdown]
# ## See inside: one gradient step by hand
#
# Take the smallest network: two inputs, two hidden units, two actions. We choose its weights: 0.5 from $x_1$ to $h_1$
# and $-1$ from $x_1$ to $h_2$; 1 and 1 from $x_2$; 0.8 and 0.2 from $h_1$ to the two action values; $-0.4$ and 0.6 from
# $h_2$. Action 0 has the bias 0.1, and all other biases are 0.

# %%
tiny = DQN.create((2, 2), hidden=2, memory_size=1, batch_size=1, learning_rate=0.01)
tiny.weights.first[:] = [[0.5, -1.0], [1.0, 1.0], [0.0, 0.0]]
tiny.weights.second[:] = [[0.8, 0.2], [-0.4, 0.6], [0.1, 0.0]]
tiny.remember([1.0, 0.0], 0, 1.0, [0.0, 0.0], True)  # in state (1, 0), action 0 gave reward 1 and ended the episode

# %% [markdown]
# **Forward**, by hand, for the state $x = (1, 0)$:
#
# $$
# h = \max\bigl(0, (0.5, -1)\bigr) = (0.5,\, 0), \qquad
# Q = (0.5 \cdot 0.8 + 0.1,\;\; 0.5 \cdot 0.2) = (0.5,\, 0.1)
# $$
#
# The episode ended, so the target is $y = R = 1$. Action 0 was taken, so the error is $\delta = 0.5 - 1 = -0.5$, and
# its size is below 1: the derivative of the loss with respect to $Q(s, 0)$ is $-0.5$. With respect to $Q(s, 1)$ it is
# 0, since the loss does not contain it.
#
# **Backward** the chain rule goes from the values to the weights (`by_hand` in the code below):
#
# - The weight from $h_1$ to $Q(s, 0)$ is multiplied by $h_1 = 0.5$: its derivative is $0.5 \cdot (-0.5) = -0.25$. The
#   bias has $-0.5$. The weight from $h_2$ has 0, since $h_2 = 0$.
# - $h_1$ itself has the derivative $0.8 \cdot (-0.5) = -0.4$. $h_2$ was cut off at 0, where a small change of its sum
#   changes nothing, so it has 0.
# - The weight from $x_1$ to $h_1$ has $1 \cdot (-0.4) = -0.4$, and so has the bias of $h_1$.
#
# Below, Adam takes a step with this gradient, in both layers.
#
# **Predict.** $x_2 = 0$ in this state. How far does this step move the weight from $x_2$ to $h_1$?

# %%
moved = predict("The weight from an input that is 0 ...", ["moves like the others", "moves half as far", "stays"])
moved

# %%
by_hand = [[-0.4, 0.0], [0.0, 0.0], [-0.4, 0.0]], [[-0.25, 0.0], [0.0, 0.0], [-0.5, 0.0]]
tiny.add_gradient(0)
print("the agent's gradient, first layer: ", tiny.gradient.first.tolist())
print("second layer:", tiny.gradient.second.tolist())
print("the same as by hand:", all(map(np.allclose, by_hand, (tiny.gradient.first, tiny.gradient.second))))
before = tiny.weights.first.copy()
tiny.updates[0] += 1
for name in ("first", "second"):
    layers = [getattr(part, name) for part in (tiny.weights, tiny.gradient, tiny.mean, tiny.square)]
    dqn.adam(*layers, tiny.adam_rate)
print("changes of the first layer: ", np.round(tiny.weights.first - before, 4).tolist())
tiny.write_values([1.0, 0.0])
print(f"Q(s, 0) was 0.5, should become 1, and is {tiny.Q[0, 0]:.4f}")
moved.measured("stays" if tiny.weights.first[1, 0] == before[1, 0] else "moves like the others")

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** It stays. *A weight learns only from states in which its input is not 0.* (Adam's average can still move
# it for a while. A weight whose input was always 0 never moves.) And see what
# Adam does: in its first step each weight with a gradient moves by the learning rate, 0.01, however large the gradient
# is. Later steps follow an average of the gradients, divided by an average of their size.
# </details>

# %% [markdown] tags=["aside"]
# ### Aside: the way backward, and Adam, in code
# These are the lines that went backward, and those of Adam. The rate in `adam` is the learning rate with a correction
# for averages that start at 0 (in step 1 it is 0.0032, and the quotient is 3.16). The draw from memory comes in
# exercise 3.

# %%
source(dqn.slope_of_loss)

# %%
source(dqn.backward)

# %%
source(DQN, "adam_rate")

# %%
source(dqn.adam)

# %% [markdown]
# ## Predict, then check
#
# ### Balls from columns that were never seen
# Now balls fall from columns 0, 2 and 4 only, in all of training (40 000 steps). Then we test six agents, greedy, with
# balls from columns 1 and 3:
#
# | agent | what it learns from | how |
# |---|---|---|
# | table | the positions | Q-learning, $\alpha = 0.5$ |
# | linear in the pixels | one feature for each pixel, and a constant | semi-gradient Q-learning, $\alpha = 0.1$ |
# | tile coding of the positions | 8 overlapping grids of tiles (9.5.4) | semi-gradient SARSA, $\alpha = 0.5/8$ |
# | linear in ball minus paddle | a feature for each difference, -4 to 4 | semi-gradient Q-learning, $\alpha = 0.1$ |
# | DQN on pixels | 50 pixels | the network |
# | DQN on the positions | three numbers, each divided by its largest value | the same network, learning rate 0.003 |
#
# (A tile is at most two columns wide, and at most three rows of the board high. SARSA takes the value of the next action
# in place of the maximum. Each agent has ten runs, and 20 test balls from each column.)
#
# **Predict.** How many of the six catch, on average over their runs, at least 9 of 10 balls from the columns that they never saw?

# %%
unseen = predict("Balls from withheld columns are caught by ...", unit="of the six agents")
unseen

# %%
general = methods.generalise([*methods.GENERAL], repetitions=10)
tests = {label: methods.returns_by_column(results) for label, results in general.items()}
display(figures.withheld(tests))
generalises = []
for label, by_column in tests.items():
    known, new = (by_column[[*columns]].mean() for columns in (tasks.TRAINED, tasks.WITHHELD))
    print(f"{label:29} training columns {known:5.2f}, withheld columns {new:5.2f}")
    generalises += [label] * int(new >= 0.8)  # a return of 0.8 is 9 balls of 10
unseen.measured(len(generalises))

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** One: the agent that sees ball minus paddle. DQN on pixels is on average no better on new columns than the
# table, and its runs differ much. (Linear in the pixels does not even learn the training columns, but for one run of ten: see the aside.)
#
# SARSA with tile coding does worst. It shares between neighbouring columns, and mostly goes where it would go for a ball
# next to this one: sharing can be wrong as well. (Q-learning with the same tiles caught column 1 in 22 of 60 runs, and
# column 3 in 8.)
# </details>
#
# ### The picture that explains it
# Each cell is a state, with the ball in row 5 of the board. The arrow is what the agent does there; • is stay. A cell
# is green if the agent then catches the ball, and red if not (low down, nobody may get there in time; in the frames the table's green is luck). The frames are for balls from the withheld columns.
#
# Runs differ much, so move `run` as well.


# %%
def maps(ball_row=5, run=2):
    """Draw what four of the agents do."""
    shown = [methods.TABLE, methods.NETWORK, methods.NUMBERS, methods.OFFSET]
    return figures.policy_maps(general, shown, ball_row, run)


sliders(maps, ball_row=(0, 8), run=(0, 9))

# %% [markdown]
# The table has never met the states in the frames; its values there are still 0, and it moves at random. Ball minus
# paddle has met the same differences with other balls. But why does DQN on pixels know so little? In one of its ten
# runs, from which pixels has any weight ever had a gradient other than 0?

# %%
touched = figures.ever_learned(general[methods.NETWORK].agents[methods.NETWORK][0])
for row in touched:
    print(" ".join("learned" if cell else "   -   " for cell in row))

# %% [markdown]
# In columns 1 and 3 there was never a ball, so these pixels were always 0, except at the bottom, where the paddle is,
# and a weight from an input that is always 0 never moves. A ball there is multiplied by weights as they were drawn at first. Moving
# these weights is not enough: with noise in training ($\sigma = 0.1$) all move, and still most of 30 runs missed every withheld ball.
#
# **An agent carries over to new states only what its weights share between states.** A table shares nothing. This
# network on pixels shares much between boards in which the same pixels are lit, as with noise. But a ball in column 1
# and a ball in column 2 light different pixels, so no weight that reads the ball from the pixels is shared. Ball minus paddle shares
# all that matters, and there a person has done the work.

# %% [markdown] tags=["aside"]
# ### Aside: where the paddle goes instead
# What do the agents do with balls from columns 1 and 3? This is where the paddle ends, in each of ten runs. The last
# agent is DQN on pixels once more, with 0 for all weights of the pixels that are not marked "learned".

# %%
cut = copy.deepcopy(general[methods.NETWORK])
for agent in cut.agents[methods.NETWORK].values():
    agent.weights.first[:-1][~figures.ever_learned(agent).ravel()] = 0.0
shown = {label: general[label] for label in (methods.TILES, methods.NUMBERS, methods.OFFSET, methods.NETWORK)}
for column in tasks.WITHHELD:
    print(f"ball from column {column}:")
    for label, results in {**shown, "the same, those weights at 0": cut}.items():
        print(f"    {label:29}", *methods.paddle_ends(results, column))

# %% [markdown]
# Tile coding mostly goes where it would go for a ball next to this one. On the positions, where 1 lies between 0 and 2, DQN seems to interpolate, at least for column 1: it is right in 8 of 10
# runs for column 1, and in 5 for column 3. On pixels it ends anywhere. With
# 0 for the weights that never moved the network does not see the ball at all, and the paddle ends in the middle.
#
# Why did the agent that is linear in the pixels learn so little? With $\alpha = 0.02$ or 0.01 a third of its runs or more
# learn the training columns. One reason may be that its sum has no term for ball and paddle together, so it cannot represent the true values.
# Weights exist that catch every ball. But even where balls fall from all five columns in training, Q-learning ends with
# such weights in few runs: in about one of ten with $\alpha = 0.02$.

# %% [markdown] tags=["aside"]
# ### Aside: can a network share more?
# A *convolutional* network (CNN) uses the same weights at every place: a *filter*, a small array of weights, slides
# over the image. Two of them were trained for 30 000 steps on images of balls from columns 0, 2 and 4, by PPO of
# Stable-Baselines3 (a policy gradient method, chapter 13). We stored the results of ten seeds each.
#
# - The **small CNN** has two layers of filters, each of 3 by 3. After them comes a layer with a weight for every place
#   of the board, as in most networks for games.
# - The **CNN over columns** has filters as high as the board and 9 columns wide, so one filter sees ball and paddle at
#   any distance. They slide from left to right, also beyond the edges. Of each filter only the largest output counts,
#   wherever it is. No weight belongs to a column.

# %%
pictures.filters()

# %% [markdown]
# **Predict.** Which of the two catches balls from the withheld columns?

# %%
cnns = predict(
    "The withheld balls are caught ...", ["by both", "by the small CNN", "by the CNN over columns", "by none"]
)
cnns

# %%
with_cnns = {**tests, **{label: figures.shared_by_column(label) for label in (sharing.SMALL, sharing.COLUMN)}}
display(figures.withheld(with_cnns))
small, column = (with_cnns[label][[*tasks.WITHHELD]].mean() for label in (sharing.SMALL, sharing.COLUMN))
print(f"withheld columns: small CNN {small:.2f}, CNN over columns {column:.2f}")
cnns.measured(cnns.options[{(True, True): 0, (True, False): 1, (False, True): 2}.get((small > 0.8, column > 0.8), 3)])

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** The CNN over columns does: in nine of ten runs it catches the balls from both columns, in the tenth from
# one. The small CNN catches them from both in one run, from one in three, and from none in six. One reason may be that
# its filters are shared, but the layer after them is not. (The two differ in the size of their filters as well.) Here,
# too, a person chose the form. So "deep learning generalises" is too simple.
# </details>

# %% [markdown] tags=["aside"]
# ### Aside: a weight that grows for ever, and the deadly triad
# Why does DQN hold its target still? Here is the smallest example of the trouble (section 11.2). Two states have one
# weight $w$ together: the first has the feature $x = 1$, so its value is $w$; the second has $x = 2$, so its value is
# $2w$. All rewards are 0, so $w$ should become 0. Suppose that only the step from the first state to the second is
# learned from, again and again:
#
# $$
# w \leftarrow w + \alpha \left[ 0 + \gamma \, 2w - w \right] \cdot 1 = \left( 1 + \alpha (2 \gamma - 1) \right) w
# $$

# %%
source(w_to_2w)

# %% [markdown]
# **Predict.** $\alpha = 0.1$, $w = 1$ at first. Above which discount $\gamma$ does $w$ grow for ever? (In the figure,
# where $\gamma = 0.9$, look at the black line. The two others are explained below it.)

# %%
bound = predict("w grows for ever when γ is above ...", unit="(from 0 to 1)")
bound

# %%
display(figures.growth())
grows = [gamma for gamma in np.arange(0, 101) / 100 if w_to_2w(2_000, gamma, 0.1)[-1] > 1.0]
print(f"the smallest γ in steps of 0.01 with which w grows: {grows[0]}")
bound.measured(grows[0] - 0.01)

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Above one half. The factor $1 + \alpha (2 \gamma - 1)$ is larger than 1 for every
# $\gamma > \frac{1}{2}$, and no $\alpha$ helps. Each update moves $w$ towards the target $2 \gamma w$. But the
# target moves as well, $2 \gamma$ times as far: if $2 \gamma > 1$, the gap grows.
# </details>
#
# Three things come together here. Sutton and Barto call them the *deadly triad* (section 11.3): **function
# approximation** (states share a weight), **bootstrapping** (the target contains a learned value), and **off-policy
# learning** (the policy leaves the second state as often as it comes there, but that step is never learned from). With
# the step sizes of the slider below, nothing grows for ever in this example if any one of the three is missing. The
# dotted line shows one case: it learns from the step to the end as well, as on-policy learning does.
#
# DQN has all three. Its old target does not remove the danger: with $\theta^-$ held still, $w$ moves towards
# $2 \gamma w^-$ ($w^-$ is the old copy), so it still grows if $\gamma > \frac{1}{2}$, but from one copy to the next it
# grows at most by the factor $2 \gamma$, however many updates lie between them. The dashed line shows that. Van Hasselt
# et al. (2018) looked for such growth in DQN on many games: values became too large at times, but hardly ever without
# end.


# %%
def triad(gamma=0.9, alpha=0.1, copy_every=20):
    """Draw the weight of the two states."""
    return figures.growth(gamma, alpha, copy_every)


sliders(triad, gamma=(0.0, 1.0, 0.05), alpha=(0.05, 0.2, 0.05), copy_every=[1, 5, 20, 50])

# %% [markdown] tags=["aside"]
# ### Aside: networks from a library, on the grid and on the image
# Stable-Baselines3 has DQN and PPO; the package has a PPO of its own. Ten runs of each are stored:
#
# | method | network | copies of the task | learning rate |
# |---|---|---:|---|
# | DQN, grid | fully connected | 8 | 0.001 |
# | PPO, grid | fully connected | 64 | 0.002 |
# | our PPO, grid | fully connected | 64 | 0.002, falling to 0 |
# | DQN, image | the small CNN | 8 | 0.001 |
# | PPO, image | the small CNN | 64 | 0.001 |
#
# PPO also learned from a darkened image: with a new brightness, from 0.4 to 1, at every step. **One run is trained
# now**, PPO on the image for 12 000 steps: the thin black line.
#
# **Predict.** An image has 150 numbers of 256 levels, the grid 50 of two. How many steps does PPO need on the
# image to get to a mean return of 0.9, compared with the grid?

# %%
more = predict("PPO on the image needs ...", ["at most twice as many steps", "2 to 10 times as many", "more"])
more

# %%
live = {}
try:
    live["PPO with a CNN, trained now"] = networks.train_network(networks.PPO_IMAGE, 12_000, seed=1)
except ImportError:
    print("Stable-Baselines3, of the extra deep, is not installed here; these are the stored runs alone.")
stored = networks.STORED.load()
display(figures.stored_networks(live))
needed = {label: int((stored.curves(label).mean(axis=1) >= 0.9).idxmax()) for label in networks.METHODS}
for label, steps in needed.items():
    print(f"{label:30} a mean return of 0.9 after {steps:6} steps")
ratio = needed["PPO with a CNN, image"] / needed["PPO, grid"]
more.measured(more.options[0 if ratio <= 2 else 1 if ratio <= 10 else 2])

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Not more: 10 240 against 14 336. PPO is tested every 2 048 steps, so the difference is two tests. The
# median run first gets there after about 10 000 steps in both cases. Afterwards four runs on the grid fall back, and
# one on the image. Settings and networks differ as well, so this compares two recipes, not two observations. And the
# image is not as rich as it sounds: only seven of the 256 levels occur, in no more than 220 images (195 while the ball falls).
#
# The darkened image took as many steps as the plain one. A new brightness at every step, which was the end of the
# table, does not hold up this network.
# </details>

# %% [markdown] tags=["aside"]
# ### Aside: what a larger board costs
# **Predict.** The board grows from 3 columns and 6 rows to 9 columns and 18 rows, so that about 30 times as many boards
# can occur. How many times as many steps does a table need to a return of 0.99? (The next cell but one takes about 20
# seconds.)

# %%
factor = predict("The table needs ... times as many steps:", unit="times")
factor

# %%
costs = {
    n: methods.steps_to_solve(n, n_steps=steps, repetitions=3)
    for n, steps in {3: 2_000, 5: 16_000, 7: 24_000, 9: 40_000}.items()
}
display(figures.costs_figure(costs))
for n, steps in costs.items():
    _, boards = sizes.different_boards(2 * n, n)
    table, network = steps.values()
    print(f"{n} columns: {boards:4} boards occur, table {table:6.0f} steps, DQN {network:6.0f} steps")
factor.measured(costs[9][methods.TABLE] / costs[3][methods.TABLE])

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** 80 times as many in these three runs; in other sets of ten runs and more it was 65 to 100 times. So the steps
# grow faster than the boards (counted in episodes, which are longer too: 24 times). DQN needs more steps than the table on all four boards, but the ratio falls with the size of the board. (These numbers vary much from run to run. With 9 columns one run of DQN in six does not get there in 40 000 steps. The
# agents are tested 40 times in training. What counts is the first time that all 30 test balls are caught, and of the
# runs the median.) </details>

# %% [markdown] tags=["aside"]
# ### Aside: a car on a hill
# MountainCar is an environment of Gymnasium. Its observation is two real numbers, position and speed, so that a table
# over observations would meet a new row at nearly every step. The car is too weak for the hill, and must swing up. Each
# step costs 1, and episodes end after 1 000 steps at the latest. Both agents are semi-gradient SARSA with $\gamma = 1$
# and $\varepsilon = 0$, in 3 runs of 20 000 steps. (All values start at 0 and every step costs 1. So what was not tried
# looks best, and this is probably why tiles need no other exploration.) One has position and speed themselves as
# features, and a constant, the other one 8 tilings of 8 by 8 tiles (as in section 10.1).
#
# **Predict.** After training the weights are held still. Whose greedy policy gets up the hill?

# %%
hill = predict("The hill is climbed, in all three runs, by ...", ["both", "tile coding", "the linear one", "none"])
hill

# %%
car = gym_car.drive()
display(figures.car_figure(car))
for label in car.methods:
    print(f"{label}: return of the greedy policy at the end of each run {car.final(label).astype(int).tolist()}")
straight, tiled = (bool((car.final(label) > -1_000).all()) for label in car.methods)
hill.measured(hill.options[0 if straight and tiled else 1 if tiled else 2 if straight else 3])

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Tile coding only. (The figure shows episodes of training, single runs as thin lines. There the linear
# agent sometimes gets up, while its weights still change. With its weights held still it hardly ever does.) A value linear in
# position and speed is a plane, one for each action. Planes cannot have the shape of the true values. They could still
# rank the actions well: the rule "push the way you move" is linear and gets up. This agent did not find it. Its step
# size and the scale of its features differ as well.
# </details>

# %% [markdown]
# ## Exercises
#
# Each exercise has a cell for your answer, and below it a cell that checks it, on cases that it makes up. It says what
# was expected, what came, and which mistake that looks like.

# %%
from edugym_course.grading import check
from edugym_course.lessons.dimensionality.exercises import CHALLENGE, exercise_1, exercise_2, exercise_3

# %% [markdown]
# ### Exercise 1: how large is a dense table?
# Write a function that returns how many *numbers* a dense table for Catch holds: one for every pair of an observation
# that could be written down and one of the three actions. `kind` is "vectorised", "grid" or "rgb".
#
# <details><summary>Hint</summary>First how many numbers are in an observation, and how many values each can take. In
# "vectorised" the ball has a column and a row, and the paddle a column. Python has whole numbers of any size, so
# <code>256 ** 150</code> is no problem.</details>


# %%
def table_entries(rows, columns, kind):
    """Return how many numbers a dense table holds, for a board of this size, seen in this way."""
    ### BEGIN SOLUTION
    if kind == "vectorised":
        observations = columns * rows * columns
    elif kind == "grid":
        observations = 2 ** (rows * columns)
    else:
        observations = 256 ** (rows * columns * 3)
    return observations * 3
    # own: return observations * {actions}
    ### END SOLUTION


# %% tags=["check"]
check(exercise_1, table_entries)
### BEGIN HIDDEN TESTS
check(exercise_1, table_entries, seed=1, quiet=True)
### END HIDDEN TESTS

# %% [markdown]
# ### Exercise 2: semi-gradient Q-learning
# Write an agent with linear features. A board comes as 50 numbers, line by line from the top. `features(board)` is
# there already: it returns the array $x(s)$ with a 1 for how far the ball is to the right of the paddle, from -4 to 4.
# Complete two methods:
#
# - `value(board, action)` returns $\hat q(s, a, w)$. `self.w[i, action]` is $w_{ia}$, so `self.w[:, action]` are all
#   weights of an action.
# - `learn(...)` makes the semi-gradient update of Q-learning. `state` and `next_state` are boards, and `terminated`
#   says whether the episode is over. Change the entries of `self.w` in place.
#
# Your agent is then trained with balls from columns 0, 2 and 4, and tested as in "Balls from columns that were never
# seen". It trains for 6 000 steps, the table beside it for 40 000, as there. Afterwards change the features, for
# instance to the column of the ball alone (still nine numbers), and see what it still knows. It may still catch the balls that it has seen. (The check makes up features of its own, in
# which several are not 0, so use `self.features`.)
#
# <details><summary>Hint</summary>The value is <code>np.sum(x * self.w[:, action])</code>. In <code>learn</code>, first
# compute the features of <code>state</code>, then the target, then change the weights of the action that was taken. A
# terminal state is worth 0.</details>


# %%
class MyAgent(NamedTuple):
    """Semi-gradient Q-learning with features of one's own."""

    w: Any
    learning_rate: float = 0.1
    discount: float = 0.9
    epsilon: float = 0.1
    tabular: bool = False

    def features(self, board):
        """Return a 1 for how far the ball is to the right of the paddle, from -4 to 4."""
        ball, paddle = 0, 0
        for pixel in range(50):
            if board[pixel] > 0 and pixel < 45:
                ball = pixel % 5
            elif board[pixel] > 0:
                paddle = pixel % 5
        x = np.zeros(9)
        x[ball - paddle + 4] = 1.0
        return x

    def value(self, board, action):
        """Return the value of an action."""
        ### BEGIN SOLUTION
        return np.sum(self.features(board) * self.w[:, action])
        ### END SOLUTION

    def learn(self, state, action, reward, next_state, terminated):
        """Make the semi-gradient update of Q-learning."""
        ### BEGIN SOLUTION
        x = self.features(state)
        target = reward
        # own: target = reward - {cost}
        if not terminated:
            best = self.value(next_state, 0)
            for a in range(1, 3):
                best = max(best, self.value(next_state, a))
            target += self.discount * best
        error = target - self.value(state, action)
        self.w[:, action] += self.learning_rate * error * x
        ### END SOLUTION

    def greedy(self, state, rng):
        """Return the action with the highest value; ties are broken at random."""
        values = np.zeros((1, 3))
        for a in range(3):
            values[0, a] = self.value(state, a)
        return greedy_action(values, 0, rng)

    def act(self, state, rng):
        """Choose an action, ε-greedy."""
        if rng.random() < self.epsilon:
            return int(rng.random() * 3)
        return self.greedy(state, rng)


# %% tags=["check"] points=2
check(exercise_2, MyAgent)
### BEGIN HIDDEN TESTS
check(exercise_2, MyAgent, seed=1, quiet=True)
### END HIDDEN TESTS
display(races.race({"my agent": lambda task: MyAgent(np.zeros((9, 3)))}))

# %% [markdown]
# ### Exercise 3: the heart of DQN
# `OpenDQN` is DQN, except that two parts of it are methods of their own. Write them:
#
# - `target_of(row)` returns the target $y$ for the transition at the place `row` of the memory. `memory.rewards[row]`
#   is its reward, `memory.next_states[row]` the next state as an array, and `memory.terminated[row]` is 1 if the
#   episode ended there, else 0. `dqn.forward(weights, x, self.h, self.Q)` writes the action values of an array `x` into
#   `self.Q`: `self.Q[0, a]` is that of action `a`. The weights are `self.weights` ($\theta$) or the old ones,
#   `self.target` ($\theta^-$, not $y$). The discount is `self.discount`.
# - `row_for(u)` returns the place (0, 1, ...) of a transition to learn from, for a random number `u` from 0 to 1
#   (1 excluded). Every transition that is in the memory must be equally likely. `self.steps[0]` is the number of
#   transitions so far. The memory has `len(self.memory.actions)` places, filled from place 0 on. When all are full, new
#   transitions take the places of the oldest.
#
# The race shows your network beside the lesson's (thin lines: 2 runs of 8 000 steps). If your draw is the lesson's, the
# two lines lie on each other; any other fair draw is right, too, and gives another line. It takes a minute to compile your class, and some
# minutes to run one that cannot be compiled (such as one with a generator, `max(... for a in ...)`).
#
# <details><summary>Hint</summary>The lines of <code>add_gradient</code> and <code>act</code> of DQN do the same:
# <code>source(DQN, "add_gradient", "act")</code>. Their <code>forward</code> is <code>dqn.forward</code> here. Write
# the target without <code>one_step_target</code>, with an <code>if</code>. The number of filled places is the smaller
# one of two numbers.</details>


# %%
class MyDQN(OpenDQN):
    """DQN with a target and a draw from memory of one's own."""

    __slots__ = ()

    def target_of(self, row):
        """Return the target for the transition at a place of the memory."""
        memory = self.memory
        ### BEGIN SOLUTION
        if memory.terminated[row] == 1:
            return memory.rewards[row]
            # own: return memory.rewards[row] - {cost}
        dqn.forward(self.target, memory.next_states[row], self.h, self.Q)
        return memory.rewards[row] + self.discount * self.Q[0].max()
        # own: return memory.rewards[row] - {cost} + self.discount * self.Q[0].max()
        ### END SOLUTION

    def row_for(self, u):
        """Return the place in the memory that a random number stands for."""
        ### BEGIN SOLUTION
        filled = min(self.steps[0], len(self.memory.actions))
        return int(u * filled)
        ### END SOLUTION


# %% tags=["check"] points=3
check(exercise_3, MyDQN)
### BEGIN HIDDEN TESTS
check(exercise_3, MyDQN, seed=1, quiet=True)
### END HIDDEN TESTS
display(races.race_networks({"my DQN": methods.network(MyDQN)}))

# %% [markdown]
# ### The open challenge: a shuffled, noisy board
# The 50 pixels stand in another order, and every one has noise with $\sigma = 0.1$. There
# are 8 000 steps. Points (at least 0) are the average greedy return over training, in percent of 1, the optimum. So it
# counts how *fast* your agent learns. The `task` that `my_agent` gets has an `observation_space` and an `action_space`,
# and nothing else. Your agent is trained ten times, in ten orders drawn from your name; it has the methods of exercise 2. (The DQN of this lesson,
# `DQN.create(task, discount=0.9, learn_from=200, copy_every=100)`, gets some 22 points on average; with 16 names it got 12 to 29.)
#
# Half a page with it: what does your agent share between boards? Does the shuffling make it harder for a table, for
# DQN, and why? What did you know about the task that the agent did not have to learn?


# %%
def my_agent(task):
    """Make the agent for the challenge; put your own in its place."""
    return LinearQLearning.create(task, learning_rate=0.05, discount=0.9)


CHALLENGE.score(my_agent, "Ada Lovelace")

# %% [markdown]
# ### From a blank file: a network that catches
# Write a program with a network that plays Catch from pixels: the whole of it, with no agent of this package. The state $S$ is an image with pixels $x$ (here: any array of numbers from 0 to 1). With the network and the target
# of this lesson, let $\delta = Q(S, A; \theta) - y$. The derivatives of the squared error $\frac{1}{2} \delta^2$ of one transition are, by the chain rule,
#
# $$
# \text{by } W_2[A, j]: \; \delta\, h_j, \qquad
# \text{by } W_1[j, i]: \; g_j\, x_i \quad \text{with } g_j = \delta\, W_2[A, j] \text{ if } h_j > 0, \text{ else } 0.
# $$
#
# and those by the biases $b_2[A]$ and $b_1[j]$ are $\delta$ and $g_j$. (In these formulas a row of a matrix belongs to a unit; in the code of this lesson it is a column.) With
# a batch of images as the rows of a matrix, each of these is one line of NumPy. With NumPy the check takes about a minute. You may use PyTorch, which finds the gradient itself; then it takes some minutes. (Compute $y$ under `torch.no_grad()`: the gradient must not run through the target.) (The
# notebook with the solutions has both.)
#
# **What it must do.** `my_program(environment, n_steps, seed)` takes `n_steps` steps in a Gymnasium environment,
# episode after episode, and learns the values of actions. In the end it returns its *policy*, a function from an image
# to the best action. All else is up to you: a memory or none, Q-learning or SARSA, any optimiser.
#
# - An image is an array of `environment.observation_space.shape`, of numbers from 0 to 1; flatten it first, and store a copy. An episode may be truncated: then $S'$ is not terminal. The actions are the whole
#   numbers from 0 to `environment.action_space.n - 1`.
# - Take $\gamma = 0.9$, $\varepsilon = 0.1$ and 64 hidden units. The first weights should be random, of a size
#   near $1/\sqrt n$ for a layer with $n$ inputs; biases may begin at 0.
# - Two ways work in so few steps: Adam with a learning rate of 0.001, a memory, and a batch of 32 after *every* step (after every fourth is too slow here); or
#   no memory, and plain gradient descent from each step once, with 0.05 for Q-learning and 0.1 for SARSA.
# - Draw all random numbers from `np.random.default_rng(seed)`, and give the seed to the first `reset` alone. (PyTorch
#   needs `torch.manual_seed(seed)` besides.)
#
# The check has three parts. In each task your program learns three times, from the beginning:
#
# 1. Five *riddles*, with 2 000 steps each. A riddle is a task with six images that asks for one part of the method.
# 2. Catch, with 10 000 steps, on a board of 5 by 5 pixels that is darkened by a new factor at every step. The policy of
#    the middle one of the three runs has to catch 70 % of the balls.
# 3. Five harder riddles. In one of them two pixels together tell the right action (this one has 4 000 steps). In
#    another one all later values are negative; and in two a black image
#    counts.
#
# The check sees what your program does, and no line of it. So the mistake that it names is only the likely one. It
# cannot find a mistake that does no harm *in these tasks*. Some mistakes in the gradient are such, for many wrong gradients still point downhill: compare yours with
# $(L(\theta + d) - L(\theta - d)) / 2 d$ for a few single weights and a small $d$, where $L$ is $\frac{1}{2} \delta^2$ with $y$ held fast.

# %% tags=["project"]
my_program = ...  # your program
### BEGIN PROGRAM


def forward(theta, x):
    """Return the hidden units and the action values of images, one in each row of x."""
    W1, b1, W2, b2 = theta
    h = np.maximum(0.0, x @ W1 + b1)
    return h, h @ W2 + b2


def gradients(theta, x, actions, y):
    """Return the gradient of the mean squared error of a batch, for each array of theta."""
    rows = np.arange(len(x))
    h, values = forward(theta, x)
    error = np.zeros_like(values)
    error[rows, actions] = (values[rows, actions] - y) / len(x)
    back = (error @ theta[2].T) * (h > 0)
    return x.T @ back, back.sum(axis=0), h.T @ error, error.sum(axis=0)


def my_program(environment, n_steps, seed):
    """Learn Q-learning with a network for `n_steps` steps, and return the greedy policy."""
    gamma, epsilon, alpha, n_hidden, batch_size, copy_every = 0.9, 0.1, 0.001, 64, 32, 100
    rng = np.random.default_rng(seed)
    n_pixels, n_actions = int(np.prod(environment.observation_space.shape)), int(environment.action_space.n)
    W1 = rng.normal(0.0, np.sqrt(2 / n_pixels), (n_pixels, n_hidden))
    W2 = rng.normal(0.0, np.sqrt(1 / n_hidden), (n_hidden, n_actions))
    theta = [W1, np.zeros(n_hidden), W2, np.zeros(n_actions)]
    old = copy.deepcopy(theta)
    means, squares = ([np.zeros_like(weights) for weights in theta] for _ in range(2))  # of the gradients, for Adam
    memory = []

    def best(image):
        """Return the action with the highest value."""
        return int(forward(theta, np.ravel(image))[1].argmax())

    state, _ = environment.reset(seed=seed)
    for t in range(1, n_steps + 1):
        action = int(rng.integers(n_actions)) if rng.random() < epsilon else best(state)
        next_state, reward, terminated, truncated, _ = environment.step(action)
        memory.append((np.ravel(state), action, reward, np.ravel(next_state), terminated))
        state = environment.reset()[0] if terminated or truncated else next_state
        batch = [memory[k] for k in rng.integers(len(memory), size=batch_size)]
        x, actions, rewards, next_x, ended = map(np.array, zip(*batch, strict=True))
        y = rewards + gamma * (1 - ended) * forward(old, next_x)[1].max(axis=1)
        for weights, gradient, mean, square in zip(theta, gradients(theta, x, actions, y), means, squares, strict=True):
            mean += 0.1 * (gradient - mean)
            square += 0.001 * (gradient**2 - square)
            weights -= alpha * mean / (1 - 0.9**t) / (np.sqrt(square / (1 - 0.999**t)) + 1e-8)
        if t % copy_every == 0:
            old = copy.deepcopy(theta)
    return best


def my_torch_program(environment, n_steps, seed):
    """Do the same in PyTorch; check it with `check(project_4, my_torch_program)` where PyTorch is installed."""
    import torch
    from torch.nn import Flatten, Linear, ReLU, Sequential, functional

    torch.manual_seed(seed)
    rng = np.random.default_rng(seed)
    n_pixels, n_actions = int(np.prod(environment.observation_space.shape)), int(environment.action_space.n)
    net = Sequential(Flatten(), Linear(n_pixels, 64), ReLU(), Linear(64, n_actions))
    old, optimiser, memory = copy.deepcopy(net), torch.optim.Adam(net.parameters(), lr=0.001), []

    def best(image):
        return int(net(torch.as_tensor(image)[None]).argmax())

    state, _ = environment.reset(seed=seed)
    for t in range(1, n_steps + 1):
        action = int(rng.integers(n_actions)) if rng.random() < 0.1 else best(state)
        next_state, reward, terminated, truncated, _ = environment.step(action)
        memory.append((state, action, np.float32(reward), next_state, np.float32(terminated)))
        state = environment.reset()[0] if terminated or truncated else next_state
        batch = [memory[k] for k in rng.integers(len(memory), size=32)]
        x, actions, rewards, next_x, ended = (torch.as_tensor(np.array(part)) for part in zip(*batch, strict=True))
        with torch.no_grad():
            y = rewards + 0.9 * (1 - ended) * old(next_x).amax(dim=1)
        loss = functional.mse_loss(net(x)[torch.arange(32), actions], y)
        optimiser.zero_grad()
        loss.backward()
        optimiser.step()
        if t % 100 == 0:
            old.load_state_dict(net.state_dict())
    return best


### END PROGRAM

# %% tags=["project"]
from edugym_course.lessons.dimensionality.project import project_4

check(project_4, my_program)

# %% [markdown]
# ## What you saw
#
# ### In one paragraph
# *Learn it by heart, or better, say it in your own words.* A table learns each observation alone, and knows nothing of
# those that it has not met. Function approximation gives states weights in common, so that what is learned in one
# changes the others. That is its use and its danger. It carries over to new states what the weights share. A
# network with pixels as inputs shares much between images in which the same pixels are lit. But a
# weight that reads one column alone learns nothing from the balls in another.
#
# ### Limits
# Catch is a very small task, which nobody needs a network for. Few runs were made of the networks, and their settings
# were chosen by a few trials. The statements on generalisation are about this board and these five columns. And a ball
# is caught in exactly one column, which is a hard test for interpolation: the column beside it is a miss.
#
# ### Further reading
# - Moerland et al. (2023), *EduGym: An environment and notebook suite for reinforcement learning education*: the paper,
#   which compares a table and DQN on Catch.
# - Sutton and Barto, *Reinforcement Learning*, 2nd edition: 9.3 and 9.4 (semi-gradient, linear methods), 9.5.4 (tile
#   coding), 9.7 (networks), 10.1 (MountainCar), 11.2 and 11.3 (divergence, the deadly triad), 16.5 (DQN).
# - Mnih et al. (2015), *Human-level control through deep reinforcement learning*: DQN.
# - Van Hasselt et al. (2018), *Deep reinforcement learning and the deadly triad*: how often it really happens.
# - LeCun et al. (1998), *Gradient-based learning applied to document recognition*: convolutional networks.
# - Kirk et al. (2023), *A survey of zero-shot generalisation in deep reinforcement learning*.
