# %% [markdown]
# # Partial observability: MemoryCorridor
#
# **The challenge.** What an agent sees is not always enough to know what to do. It must then remember what it saw
# before, and decide *what* to remember.
#
# **You will be able to** say what makes an observation different from a state; turn a table that forgets into one that
# remembers, with a window; compute how long that window must be; say what belongs in it;
# and write a memory with a table of 16 rows that does better than a window with millions.
#
# **Time.** {time} **Before you start.** You should know what a value function and
# Q-learning are (Sutton and Barto, 2nd edition, sections 3.5 and 6.5), and ε-greedy action selection (section 2.2). For
# the two networks near the end it helps to know what DQN is (section 16.5). All symbols are in the
# [table of notation](https://github.com/RLG-Leiden/edugym/blob/main/docs/notation.md).

# %%
from typing import Any, NamedTuple

import gymnasium as gym
import numpy as np
from gymnasium import spaces

from edugym import (
    EpsilonGreedy,
    FrameStack,
    QLearning,
    SeparateFrames,
    make_mdp,
    repeat,
    stack_size,
    wrapper,
)
from edugym.experiments.figures import Curves, Sheet
from edugym.experiments.results.tables import joined
from edugym_course.lessons.memory import figures, lake, network, pictures, players, recurrent, windows
from edugym_course.notebook import frames, play, predict, sliders, source

# %% [markdown]
# ## Meet the environment: doors that are marked once
#
# An agent walks through a corridor. At every place one of $N = 3$ doors is unlocked: the *right* door. The first
# corridor has one place. Each time the agent gets through, it is back at the start, and the corridor has one more place
# at its end. **Only at the last place is the right door marked**, by a lamp. At the other places the agent must know it
# from before.

# %%
env = gym.make("edugym/MemoryCorridor-v0").unwrapped
_, info = env.reset(seed=1)
for _ in range(5):  # to the last place of corridor 3; `info` is for us, no agent may look at it
    _, _, _, _, info = env.step(info["right_door"])
env.scene()

# %% [markdown]
# (In the title "door 3 of 3" is the third place of a corridor with three. The doors at each place are 0, 1 and 2.)
#
# In this lesson the agent does not see the state $s$. It sees an *observation* $o$, which tells only a part of it.
#
# | | | in words |
# |---|---|---|
# | states | the right doors, $L$, $p$ | all right doors of the episode; the length $L$ of the corridor; the place $p$, from 0 to $L - 1$ |
# | observations | $o \in \{0, 1, \dots, N\}$ | at the last place the number of the right door, elsewhere $N$: "no mark" |
# | actions | $\mathcal{A} = \{0, \dots, N-1\}$ | the door to open |
# | dynamics | $p$ grows by 1; after the last place $L$ grows by 1 and $p = 0$ | if the door is right |
# | | the episode *terminates* | if the door is wrong |
# | reward | 1 for a right door, 0 for a wrong one | |
# | discount | $\gamma = 0.8$ | used by Q-learning and DQN in the corridor; returns in the figures are not discounted |
#
# A task whose observations do not tell the state is a *partially observable* Markov decision process. The right doors
# are drawn anew in every episode. After 1 000 steps an episode is *truncated*.
#
# Corridors $1, 2, \dots, L$ have $1 + 2 + \dots + L = L(L+1)/2$ places in all. An agent that gets through corridor 3
# and errs at the first place of corridor 4 has a return of 6. The optimum is 1 000: a right door in each of the 1 000
# steps.
#
# These methods are the environment. In the code the right doors follow from `seed`, $p$ is `position`, and `opened` is
# a wrong door, or −1.

# %%
source(type(env.mdp), "transition", "reward", "terminal", "observation")

# %% [markdown]
# **Play it yourself, blind.** You see what the agent sees, a number; 3 means "no mark". What do you keep in mind, the
# marks that you saw or the doors that you opened?

# %%
play("MemoryCorridor", blind=True)

# %% [markdown]
# ## The idea: make a state out of the past
#
# What an agent could know at step $t$ is its *history*: all observations and all of its own actions so far,
#
# $$
# H_t = O_0, A_0, O_1, A_1, \dots, A_{t-1}, O_t
# $$
#
# Of the state nothing more can be known. (The rewards tell
# nothing: until the end each is 1.) So decisions based on the history are the best ones
# possible. But histories grow without end, and a long one hardly ever comes twice. The agent needs something short
# that stands for it: an *agent state*, a function of the history (Sutton and Barto, section 17.3). A good one keeps
# what matters for the future and forgets the rest. This lesson has two of them, and a third in an aside.
#
# ### A window
# Keep the last $k$ observations, and forget all before them:
#
# $$
# \text{observations alone:} \quad (O_{t-k+1}, \dots, O_{t-1}, O_t)
# $$
#
# The "$k$th-order history" of section 17.3 keeps the actions as well. Our windows have those between the observations:
#
# $$
# \text{observations and actions:} \quad (O_{t-k+1}, A_{t-k+1}, \dots, O_{t-1}, A_{t-1}, O_t)
# $$
#
# The package does this outside of the agent: it turns the task into one that *shows* the window, as one whole number,
# the row of a table. The observations are the digits of that number, and the oldest ones are dropped from it. (Such
# windows are also called frame stacks. An episode starts with $k$ copies of the first observation, and with action 0
# between them.) In the code `n_recent` is the number of rows that a window would have without its oldest observation (and the action
# after it), so `row % n_recent` drops these two. `inner` is the state of the corridor.

# %%
source(FrameStack, "transition", "observation")

# %% [markdown]
# Q-learning stays as it is. The window takes the place of the state $S$. After each step it moves one value a little,
# by the learning rate $\alpha$, towards a target (equation 6.8):
#
# $$
# Q(S, A) \leftarrow Q(S, A) + \alpha \left[ R + \gamma \max_a Q(S', a) - Q(S, A) \right]
# $$

# %%
source(QLearning.learn)

# %% [markdown]
# Q-learning with a window of 2 observations, without actions: one greedy episode after 50 000 steps of training. In the
# film each frame shows one step, and its "observation" is the row of the window *after* that step. The row at which the
# agent decided stands in the frame before. The number of a row is 4 times the older observation plus the newer one, so row 15
# is (3, 3): no mark, twice. At which row does it err?

# %%
two = players.learn(2, n_steps=50_000, repetitions=1)
frames(FrameStack.create(make_mdp("MemoryCorridor"), 2), two.agents["k = 2"][0], seed=4)

# %% [markdown]
# <details><summary>What you see</summary>
#
# It errs at row 7: mark 1, then no mark. In corridor 2 this row means "open the door that was marked", door 1. But here
# it is the first place of corridor 3. The right door of that place is 0, and it was marked three steps ago, out of the
# window. One row, two right doors. </details>
#
# ### Notes
# A window keeps everything for a short while. The opposite is to keep a little for ever. This player is made by hand,
# and learns nothing: it writes down each marked door, and opens the doors in its notes. (It counts the places, and so
# it knows where the mark is. Two names mean something else here than above: `state` is the observation, and `length` is
# the last place of the corridor, $L - 1$.)

# %%
source(players.Rememberer, "act", "learn")

# %%
print("returns of ten episodes:", players.remember(repetitions=10).final("notes").astype(int).tolist())
frames("MemoryCorridor", players.Rememberer.create(None), seed=4, max_steps=60)

# %% [markdown]
# ## The experiment: what is a window worth?
#
# Q-learning with windows of $k = 1, 2, 3, 4$ observations, and with the actions between them (there also $k = 5$). With
# $k = 1$ there is no action between, so that line is the same in both panels.
#
# | setting | value |
# |---|---|
# | all | tabular, $\alpha = 0.1$, $\gamma = 0.8$, ε-greedy with $\varepsilon = 0.1$, all values start at 0, ties broken at random |
# | training | 100 000 steps |
# | evaluation | 40 greedy episodes every 4 000 steps; their mean return |
# | repetitions | 50; bands are 95 % intervals |
#
# The dotted lines show the best play that we could find for an agent that has no other memory than the window. Where the window does
# not tell the right door, this play guesses. (With full memory it is 1 000.)
#
# The first half of the cell after the next is the whole experiment: one task for each window. (`players.learn_all` makes these calls too;
# with `actions=True` the window shows actions.)
#
# **Predict.** With $k = 4$ the agent sees the last four observations, but not its actions. It chose its actions itself.
# Does it help to show them to it?

# %%
helps = predict(
    "With its actions in the window of 4, its return at the end is ...",
    ["the same, up to 0.5", "higher by more than 0.5", "lower by more than 0.5: the table has 27 times as many rows"],
)
helps

# %%
settings = {"learning_rate": 0.1, "discount": 0.8, "exploration": EpsilonGreedy(0.1)}
curve = {"evaluate_every": 4_000, "evaluation_episodes": 40}
runs = []
for k in (1, 2, 3, 4):
    task = FrameStack.create(make_mdp("MemoryCorridor"), k)
    agents = {f"k = {k}": lambda task: QLearning.create(task, **settings)}
    runs.append(repeat(task, agents, 100_000, repetitions=50, jobs=2, **curve))
alone = joined(runs)
how = {"n_steps": 100_000, "repetitions": 50, "jobs": 2}
both = players.learn_all([1, 2, 3, 4, 5], actions=True, **how)
display(figures.compare_windows(alone, both))
for results, title in ((alone, "observations alone"), (both, "observations and actions")):
    means = ", ".join(f"{label}: {players.late(results, label).mean():.1f}" for label in results.methods)
    print(f"{title:24} {means}  (mean of the last five points)")
gain = players.late(both, "k = 4").mean() - players.late(alone, "k = 4").mean()
same, higher, lower = helps.options
helps.measured(same if abs(gain) <= 0.5 else higher if gain > 0 else lower)

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** It helps a lot: 9.7 instead of 6.9. The agent did choose its actions, but a table forgets them at once.
#
# All tables come close to the best play with their window. So Q-learning is not the problem: what is missing was thrown
# away before the agent saw it.
# </details>

# %% [markdown]
# ## Your turn
#
# Choose a window and the number of doors, and compare observations alone with observations and actions. What do
# $\varepsilon$ and $\gamma$ change? Try $\gamma = 0$, and explain what you see. (10 repetitions of 50 000
# steps. For $k = 1$ the two lines are the same.)


# %%
def one_window(k=3, doors=3, epsilon=0.1, alpha=0.1, gamma=0.8):
    """Draw the learning curves of one window, without and with actions."""
    return figures.one_window(k, doors, epsilon=epsilon, learning_rate=alpha, discount=gamma)


sliders(
    one_window,
    k=(1, 4),
    doors=(2, 4),
    epsilon=(0.0, 0.5, 0.01),
    alpha=(0.01, 1.0, 0.01),
    gamma=(0.0, 0.99, 0.01),
)

# %% [markdown]
# <details><summary>What they change</summary>
#
# All numbers are for $k = 3$ with actions, means over 200 runs. The given settings end at 7.1.
#
# - With $\varepsilon = 0$ it ends at 6.5. In each row the first door that was right gets a value above 0. All others
#   stay at 0, so the agent never tries them there, even where another door is right more often. With any other ε of the slider it tries them, and 0.5 ends
#   at 7.1 too.
# - With $\gamma = 0$ it ends at 7.1.
#
# Why does γ = 0 do as well? Every right door is rewarded at once. The difficulty of this task is not that rewards come
# late, but that the *information* comes early and is needed late. </details>

# %% [markdown]
# ## See inside: the sliding window
#
# This is an episode without an error, at the first place of corridor 4. The upper row shows what the agent saw ("–" is
# no mark), the lower row the doors that it opened. The orange frame is the window. Which is the right door? The arrows
# point to where it was marked, and to where it was opened last. (At a marked place there are no arrows.)


# %%
def window(step=6, k=4, actions=False):
    """Draw an episode up to a step, with the window on it."""
    return figures.walk_figure((2, 0, 1, 1), step, k, actions, f"step {step}, k = {k}")


sliders(window, step=(0, 9), k=(1, 8), actions=False)

# %% [markdown]
# **Predict.** Observations alone, corridor 4. How long must the window be, so that the mark of its door is in it at the *first*
# place of corridor 4? Move the sliders if you like.

# %%
needed = predict("The smallest window for corridor 4:", unit="observations")
needed

# %%
display(Sheet("laws", [[figures.window_lines([1, 2, 3, 4, 5, 6])]]))
for length in (2, 3, 4, 5, 6):
    shortest, with_actions = windows.smallest_window(length), windows.smallest_window(length, actions=True)
    print(f"corridor {length}: {shortest:2} observations alone, {with_actions} with actions")
needed.measured(windows.smallest_window(4))

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Seven. The numbers were found by trying all sequences of doors: a window is enough for corridor $L$ if
# it never looks the same at two moments that need different doors, in all corridors up to $L$. The circles are the two
# laws below.
# </details>
#
# **The law for observations alone.** The door at place 0 was marked once, at step 0. For later places the mark is nearer. Corridors $1, \dots, L-1$ take
# $L(L-1)/2$ steps. So at the first place of corridor $L$ the mark lies $L(L-1)/2$ steps back, and the window must hold
# one observation more, the present one:
#
# $$
# k = \frac{L(L-1)}{2} + 1
# $$
#
# **The law with actions.** Every door was opened on the last walk, $L - 1$ steps ago. So $k = L$ looks like enough. It
# is not quite. Here are two moments that look the same in a window of 4 with actions, and need different doors:

# %%
figures.twin_figure(4, 4, actions=True)

# %% [markdown]
# Is it in corridor 4, where the right door was opened 3 steps ago, or in corridor 3, where it was opened 2 steps ago?
# It must also know the length of the corridor. Two marks would tell it: the last two are as many steps apart as the
# previous corridor is long.
#
# Say that corridor $L$ is the longest one that must be played without an error. Up to corridor $L - 1$ the window must hold
# both marks. That takes $2L - 3$ observations (the aside below counts them). A single mark then means corridor $L$, where
# the last walk must fit, which takes $L$. The longer one counts:
#
# $$
# k = \max(L,\; 2L - 3)
# $$
#
# The window grows linearly instead of quadratically. But each action in it multiplies the rows by 3. From corridor 6 on
# the table with actions is the smaller one, and soon both are too large. (A row has a value for each of 3 actions, and
# a value has 8 bytes. The paper's example is a window of 25 observations.)

# %%
print(f"a window of 25 observations alone: {3 * 8 * stack_size(4, 25):.1e} bytes, 27 petabytes (27 million gigabytes)")
for length in range(3, 9):
    k_alone, k_both = windows.window_law(length), windows.action_law(length)
    alone_bytes, both_bytes = 3 * 8 * stack_size(4, k_alone), 3 * 8 * stack_size(4, k_both, 3)
    print(f"corridor {length}: observations alone, k = {k_alone:2}, {alone_bytes:7.2g} bytes;", end="  ")
    print(f"with actions, k = {k_both:2}, {both_bytes:7.2g} bytes")

# %% [markdown] tags=["aside"]
# ### Aside: where the law with actions comes from
# In every corridor *shorter* than $L$ the agent must see two marks, to know its length: with one alone, two corridors look the
# same where their doors agree. (In corridors 1 and 2 the copies at the start stand in for one.) That is hardest at the
# last unmarked place of corridor $L - 1$, where the second last mark lies $2L - 4$ steps back. (The lower picture above
# is this moment for $L = 4$: one more entry, four steps back, would show the mark of step 0.) With the present
# observation that makes $2L - 3$.

# %% [markdown]
# ## Predict, then check
#
# ### "A larger table returns less at first"
# **Predict.** With actions, $k = 5$ has 144 times as many rows as $k = 3$. Early in training, after about 1 000 steps,
# does it return less?

# %%
early = predict(
    "After 1 000 steps k = 5 returns ...", ["less than k = 3", "as much as k = 3, up to 0.3", "more than k = 3"]
)
early

# %%
quick = players.learn_all([1, 2, 3, 4, 5], actions=True, n_steps=2_000, repetitions=100, evaluate_every=250)
display(Sheet("early", [[Curves(quick, "with actions, early")]]))
at = {label: quick.curves(label).loc[750:1_250].to_numpy().mean() for label in ("k = 3", "k = 5")}
for label, value in at.items():
    best = windows.best_play(int(label[4:]), actions=True).value
    print(f"{label}: return {value:.1f} near step 1 000, {value / best:.0%} of the best play with its window")
    stopped = players.learn(int(label[4:]), actions=True, n_steps=1_000, repetitions=100)
    tables = [agent.Q for agent in stopped.agents[label].values()]
    changed = np.mean([np.any(Q != 0, axis=1).sum() for Q in tables])
    print(f"  after 1 000 steps {changed:.0f} of its {len(tables[0])} rows have a value other than 0")
difference = at["k = 5"] - at["k = 3"]
early.measured(
    "as much as k = 3, up to 0.3" if abs(difference) <= 0.3 else f"{'more' if difference > 0 else 'less'} than k = 3"
)

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** It returns more: 6.9 against 6.0. The larger table is further from *its own* best. But 144 times as many
# rows are not 144 times as much to learn: after 1 000 steps only about 74 of its 82 944 rows have a value other than 0,
# and about 50 of the 576 rows of the smaller one. We think that is why it is not behind. </details>

# %% [markdown]
# ### A network on the window
# A table has a row for every window, and what it learns in one row does not carry over to similar ones. A network can
# learn "open the door that was opened 4 steps ago" once. DQN is Q-learning with a network in the place of the table,
# trained on batches of remembered steps (lesson 4 is about networks). The window comes to it as separate numbers, each
# of them as a vector with a single 1. The target has the same form as before, but its values come from an older copy of
# the network (section 16.5). A step down the gradient takes the place of the change of one entry. (The paper takes the
# DQN of Stable-Baselines3, and this is the package's own: its curves are not those of the paper.)

# %% [markdown]
# ### Seven observations
# Two agents with DQN train for 80 000 steps. One sees 7 observations, the other one also the actions between them. Each
# has 3 repetitions, so the bands are wide. It takes 10 to 40 seconds.
#
# <details><summary>The settings of DQN</summary>
#
# | setting | value |
# |---|---|
# | network | one hidden layer of 64 units |
# | update | every 4 steps after the first 1 000, by Adam with learning rate 0.001 |
# | batch | 32 of the last 10 000 steps |
# | older copy of the network | made every 250 updates |
# | discount | $\gamma = 0.8$ |
# | exploring | $\varepsilon$ falls evenly from 1 to 0.02 in the first 16 000 steps |
#
# </details>
#
# **Predict.** By the law, 7 observations with actions are enough for corridor 5, since $2 \cdot 5 - 3 = 7$. Perfect
# play through corridor 5 returns 15. What will DQN return at the end, on average over the last fifth of training?

# %%
far = predict("DQN on 7 observations with actions returns about ...", ["below 13", "15, give or take 2", "above 17"])
far

# %%
labels = ("7 observations", "7 observations and actions")
trained = [network.learn_with_network(label, n_steps=80_000, repetitions=3, jobs=2) for label in labels]
networks = joined(trained)
display(figures.network_figure(networks))
for label in networks.methods:
    print(f"{label:26}: {players.late(networks, label).mean():.1f} (mean of the last five points)")
reached = players.late(networks, "7 observations and actions").mean()
far.measured("below 13" if reached < 13 else "15, give or take 2" if reached <= 17 else "above 17")

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** A little more than 21. That is what perfect play through corridor 6 would return, and the law promises
# corridor 5.
# </details>
#
# One of the three agents with actions, greedy. It sees 7 observations and 6 actions, and nothing of the place or the
# length that stand in the picture.

# %%
corridor = SeparateFrames.create(make_mdp("MemoryCorridor"), 7, actions=True)
agent, rng = networks.agents["7 observations and actions"][0], np.random.default_rng(0)


def choose(window):
    """Choose the greedy action of the agent for a window."""
    return agent.greedy(spaces.flatten(corridor.observation_space, window), rng)


frames(corridor, choose, seed=4, max_steps=60)

# %% [markdown]
# How can it be more than 15? The law is for agents that *never* err. The next figure puts the law beside the best play
# that we found, and what was learned.

# %%
display(figures.worth((alone, both), networks))
print(f"best play with 7 observations and actions returns {windows.best_play(7, actions=True).value:.1f} on average")
for length, share in enumerate(windows.best_play(7, actions=True).through[:7], start=1):
    print(f"  it gets through corridor {length} in {share:.0%} of all episodes")

# %% [markdown]
# Three things come together.
#
# 1. Every right door of corridors 6 and 7 is still *in* the window of 7: it was opened 5 or 6 steps ago. What is
#    missing (except at the first place of corridor 6) is the second last mark, which tells how long the corridor is.
# 2. The actions make the right length likelier in corridor 6. In a corridor of length $L$, each door that the agent has just
#    opened on this walk is the same as the one opened $L - 1$ steps before it. A wrong length fits only by chance, in one
#    case of three for each door that can be compared. (This window has six doors: it can test length 5 by at most two of them, length 6 by one, and length 7 by none.)
# 3. Where nothing tells the length, the best play guesses.
#
# So the best play with this window gets through corridor 6 in 85 % of all episodes, and returns 23 on average. DQN
# comes close.

# %% [markdown] tags=["aside"]
# ### Aside: a memory that is learned
# A *recurrent* network has a memory $M_t$, some numbers that it changes at every step by a function $u$ whose weights
# are learned. For recurrent PPO, an agent that learns its policy directly, $u$ is an *LSTM*, a small network that keeps numbers from step to step:
#
# $$
# M_t = u(M_{t-1}, O_t)
# $$
#
# The window and the notes are such functions as well (there $u$ may use the action too, as in section 17.3 of the
# book), but somebody wrote them.

# %%
pictures.recurrent_cell()

# %% [markdown]
# Recurrent PPO sees one observation at a time, no window, and never its own actions. It has to learn what to keep. It
# learns from 64 copies of the task at once, by the policy gradient (PPO), with an LSTM of 64 units. A run takes half a
# minute or more, so **nothing is trained here**: these are the stored results of ten seeds, 150 000 steps each
# (learning rate 0.003, discount 0.9, 32 steps a round, batches of 512, 4 epochs).
#
# **Predict.** Where does it end?

# %%
learned = predict(
    "At the end of its training recurrent PPO returns ...",
    ["less than DQN on 7 observations", "more than that, less than DQN with actions", "more than DQN with actions"],
)
learned

# %%
stored = recurrent.STORED.load()
display(figures.network_figure(networks, stored))
ends = np.sort(stored.final(recurrent.RECURRENT))
print(f"recurrent PPO: mean {ends.mean():.1f}; the ten seeds: {', '.join(f'{end:.1f}' for end in ends)}")
below, above = (players.late(networks, label).mean() for label in ("7 observations", "7 observations and actions"))
learned.measured(learned.options[0 if ends.mean() < below else 1 if ends.mean() < above else 2])

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** It ends near 16, between the two. Its mean still rose in the last third of the training. (The numbers of steps are not a race. PPO collects rounds of 64 · 32 steps, uses each round 4 times, and
# throws it away. DQN draws its batches from the last 10 000 steps.) </details>

# %% [markdown] tags=["aside"]
# ### Aside: the same with eyes shut, on a frozen lake
# FrozenLake is an environment of Gymnasium: a lake of 4 by 4 fields, where the agent walks from the upper left to the
# lower right corner, around four holes. Here it is not slippery, and the agent has its *eyes shut*: every observation
# is 0. One of the shortest ways is down, down, right, right, down, right. Its eyes are shut by a wrapper of a few
# lines:

# %%
source(lake.EyesShut)

# %% [markdown]
# Q-learning sees the lake through a window: 6 observations alone, or $k$ observations with the $k - 1$ actions between
# them. ($\alpha = 0.1$, $\gamma = 0.9$, $\varepsilon = 0.1$, 20 000 steps, episodes of at most 100 steps, 10
# repetitions.)
#
# **Predict.** How many of its own last actions must the blind agent remember, so that most of the runs learn the way
# to the goal?

# %%
counts = ["none", "1", "2", "3", "4", "no number is enough"]
blind = predict("The fewest actions with which most runs get there:", counts)
blind

# %%
walks = lake.learn_blindly([(6, False), (2, True), (3, True), (4, True), (5, True)], repetitions=10, jobs=2)
for label in walks.methods:
    print(f"{label:19}: return at the end of each run {walks.final(label).astype(int).tolist()}")
solved = [number for number, label in zip(counts, walks.methods, strict=False) if walks.final(label).mean() > 0.5]
blind.measured(solved[0] if solved else counts[-1])

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Two. Six observations of nothing are still nothing. With its last two actions the agent can know where
# it is on the way. On the way above, *down, down* is followed by right, *down, right* by right, *right, right* by down,
# and *right, down* by right. (At the start the window holds *left, left*, which is action 0 two times.) One action is
# too little: *down* is followed by down once, and by right another time. The other ways do not help: of all 256 rules
# from one last action to the next one, none gets to the goal.
#
# Of 120 more runs with two actions 101 got there, of 120 with three also 101, and of 80 with four 77: "enough to know"
# does not yet mean "learned".
# </details>

# %% [markdown]
# ## Exercises
#
# Each exercise has a cell for your answer, and below it a cell that checks it. The check does not only say whether an
# answer is right: it says what was expected, what came, and which mistake that looks like. It runs your code on cases
# that it makes up.

# %%
from edugym_course.grading import check
from edugym_course.lessons.memory.exercises import CHALLENGE, exercise_1, exercise_2, exercise_3

# %% [markdown]
# ### Exercise 1: how large is the table?
# A corridor has $N$ doors at every place. How many *rows* has a table over windows of observations alone, if the window
# is just long enough that the agent never errs up to the end of corridor $L$? Write the function. A table has one row
# for every window that could be written down, whether it ever occurs or not.
#
# <details><summary>Hint</summary>First the length of the window, from the law above. Then: how many different
# observations are there at each step, and how many different sequences of that length?</details>


# %%
def table_rows(num_doors, length):
    """Return the number of rows of the table, for so many doors and for the corridor of this length."""
    ### BEGIN SOLUTION
    window = length * (length - 1) // 2 + 1
    return (num_doors + 1) ** window
    # own: return (num_doors + {looks}) ** window
    ### END SOLUTION


# %% tags=["check"]
check(exercise_1, table_rows)
### BEGIN HIDDEN TESTS
check(exercise_1, table_rows, seed=1, quiet=True)
### END HIDDEN TESTS

# %% [markdown]
# ### Exercise 2: put the action in
# Write the window of the lesson yourself. A window is an array of $2k - 1$ whole numbers in order of time, the oldest
# first: observation, action, observation, ..., action, observation. Complete two methods:
#
# - `push` gets the window, the action that was just taken, and what was seen after it. It returns the next window: the
#   oldest observation and the oldest action go, the new action and the new observation come at the end. It must not
#   change the array that it gets, which still belongs to the state before.
# - `row` returns the number of the row for a window: a whole number from 0 to the number of rows less 1, and a
#   different one for every window. An observation has `self.n_observations` possible values, an action
#   `self.n_actions`.
#
# The race shows Q-learning on your window, with $k = 4$, beside the two windows of the lesson, for 20 000 steps. If
# your window is right, its line lies on that of the lesson's window with actions. (`@wrapper` passes on what the class
# does not define, and `inside` is for pictures.)
#
# <details><summary>Hint</summary>For <code>push</code>: copy the window, move all entries by two places (<code>new[:-2]
# = window[2:]</code>), and fill in the last two. For <code>row</code>: the number 352 is made from its digits by (3 ·
# 10 + 5) · 10 + 2, from the left. Do the same, but multiply by the number of values of the digit that you are about to
# add. The entries at even indices are observations. Code that cannot be compiled is right too. A warning says so, and
# the race takes longer. Following this hint avoids it.</details>


# %%
class Seen(NamedTuple):
    """A state of the corridor, and the window on the way to it."""

    inner: Any
    window: np.ndarray


@wrapper
class MyWindow(NamedTuple):
    """A task seen through a window of observations and actions."""

    mdp: Any
    k: int = 4
    n_observations: int = 4
    n_actions: int = 3

    @property
    def observation_space(self):
        """The rows of the table."""
        return spaces.Discrete(self.n_observations**self.k * self.n_actions ** (self.k - 1))

    def push(self, window, action, seen):
        """Return the next window."""
        ### BEGIN SOLUTION
        new = window.copy()
        new[:-2] = window[2:]
        new[-2] = action
        new[-1] = seen
        return new
        ### END SOLUTION

    def row(self, window):
        """Return the number of the row for a window."""
        ### BEGIN SOLUTION
        row = 0
        for i in range(len(window)):
            values = self.n_observations if i % 2 == 0 else self.n_actions
            row = row * values + window[i]
        return row
        # own: return (row + {shift}) % (self.n_observations**self.k * self.n_actions ** (self.k - 1))
        ### END SOLUTION

    def initial(self, rng):
        """Start with k copies of the first observation, and action 0 between them."""
        inner = self.mdp.initial(rng)
        window = np.zeros(2 * self.k - 1, np.int64)
        window[::2] = self.mdp.observation(inner, rng)
        return Seen(inner, window)

    def transition(self, state, action, rng):
        """Take a step in the task, and push what was done and seen."""
        inner = self.mdp.transition(state.inner, action, rng)
        return Seen(inner, self.push(state.window, action, self.mdp.observation(inner, rng)))

    def reward(self, state, action, next_state, rng):
        """Return the reward of the task."""
        return self.mdp.reward(state.inner, action, next_state.inner, rng)

    def terminal(self, state):
        """Say whether the task ends."""
        return self.mdp.terminal(state.inner)

    def observation(self, state, rng):
        """Show the row."""
        return self.row(state.window)

    def inside(self, state):
        """Return the state of the task, for its picture."""
        return state.inner


# %% tags=["check"] points=2
check(exercise_2, MyWindow)
### BEGIN HIDDEN TESTS
check(exercise_2, MyWindow, seed=1, quiet=True)
### END HIDDEN TESTS
display(figures.race({"my window": MyWindow(make_mdp("MemoryCorridor"))}, n_steps=20_000, repetitions=10))

# %% [markdown]
# ### Exercise 3: write the right memory
# The window of 7 with actions has 12 million rows, and still errs at times in corridor 6. Give the agent a notebook
# instead. It has a line for every place, and the agent keeps a finger on the line of the present place. What Q-learning
# sees is the note under the finger and the present observation, no more. That makes $(N + 1)^2 = 16$ rows. What a note
# *means* is for Q-learning to find out.
#
# Write `update`, which is called after every step. (After a wrong door the episode is over, and then it does not matter
# what `update` does.) It gets the `notes` (an array, at first with $N$ in every line, for "nothing"), the present
# `place`, what was `seen` there (the marked door, or $N$ for no mark), and the `action`. It does two things:
#
# - It writes the door that was opened into the line of the place. (Unlike in exercise 2 `notes` is a copy already, so change it in place.)
# - It returns the next place: one further, or 0 if this was the last place of the corridor. How does the agent know
#   that?
#
# Before you run the check: how far will Q-learning get in 20 000 steps? The race shows it beside the lesson's windows
# of 4, without and with actions.
#
# <details><summary>Hint</summary>Only the last place of a corridor has a mark. <code>self.num_doors</code> is N, and
# <code>seen == self.num_doors</code> says that there is no mark.</details>


# %%
class Noted(NamedTuple):
    """A state of the corridor, the notes, and the place of the finger."""

    inner: Any
    notes: np.ndarray
    place: int


@wrapper
class Notebook(NamedTuple):
    """A corridor with a notebook: it shows the note of the present place, and the observation."""

    mdp: Any
    num_doors: int = 3

    @property
    def observation_space(self):
        """One row for every note and every observation."""
        return spaces.Discrete((self.num_doors + 1) ** 2)

    def update(self, notes, place, seen, action):
        """Note the door that was opened, and return the next place."""
        ### BEGIN SOLUTION
        notes[place] = action
        if seen == self.num_doors:
            return place + 1
            # own: return (place + {stride}) % len(notes)
        return 0
        ### END SOLUTION

    def initial(self, rng):
        """Start with empty notes at place 0."""
        return Noted(self.mdp.initial(rng), np.full(1_001, self.num_doors), 0)  # enough for 1 000 steps

    def transition(self, state, action, rng):
        """Take a step in the corridor, and bring the notes up to date."""
        notes = state.notes.copy()
        seen = self.mdp.observation(state.inner, rng)
        place = self.update(notes, state.place, seen, action)
        return Noted(self.mdp.transition(state.inner, action, rng), notes, place)

    def reward(self, state, action, next_state, rng):
        """Return the reward of the corridor."""
        return self.mdp.reward(state.inner, action, next_state.inner, rng)

    def terminal(self, state):
        """Say whether a wrong door was opened."""
        return self.mdp.terminal(state.inner)

    def observation(self, state, rng):
        """Show the note and the observation as one number."""
        return state.notes[state.place] * (self.num_doors + 1) + self.mdp.observation(state.inner, rng)

    def inside(self, state):
        """Return the state of the corridor, for its picture."""
        return state.inner


# %% tags=["check"] points=3
check(exercise_3, Notebook)
### BEGIN HIDDEN TESTS
check(exercise_3, Notebook, seed=1, quiet=True)
### END HIDDEN TESTS
notebook = {"my notebook": Notebook(make_mdp("MemoryCorridor"))}
display(figures.race(notebook, n_steps=20_000, repetitions=10, log=True, evaluation_episodes=5))

# %% [markdown]
# <details><summary>What the race shows</summary>
#
# The axis is logarithmic. Q-learning with the notebook is at 1 000, the optimum, by the second point of the curve, and
# stays there. (Of 100 runs 92 are there after 100 steps, and all after 200.) It has only two things to learn: at a mark open the marked door, and elsewhere the noted one. "Hidden state
# needs a long window" is wrong. It needs the *right* memory, here one door for each place.
# </details>

# %% [markdown]
# ### The open challenge: marks in a secret script
# A corridor with ten doors, and with marks that are *signs*: sign 4 may mean door 7. Each door has its own sign,
# drawn from your name for each of ten runs, and the same in all episodes of a run, so it can be learned. Episodes are cut off after 100
# steps, and there are 5 000 steps in all. **All training episodes count**, from the first one on, and each with the
# same weight.
#
# Write an agent with `act(state, rng)` and `learn`, whose memory is inside; `state` is the observation. Of the task it is told only the two spaces:
# observations 0 to 9 are signs, 10 is "no mark". `learn` asks by name for what it needs: `state`, `action`, `reward`,
# `next_state`, and `terminated` and `truncated`, which tell it when an episode is over. `my_agent` returns a new agent.
# If it is a `NamedTuple` of arrays, like `QLearning`, it is compiled; a plain class works too, more slowly. Give it no
# method `greedy`: then a copy of it is evaluated, and its own memory stays as it is.
#
# A new agent is trained in each of the ten runs. Your points are the mean return of its training episodes, in
# percent of 64, and at most 100. 64 is what an agent gets *on average* that keeps the right notes, never tries a door
# twice for a sign for which it was wrong, and never tries a door that already belongs to another sign. Ten runs have
# luck in them: one such agent gets between 90 and 100 points, depending on the name. (The column "return at the end"
# plays an episode without `learn`. It means little for agents whose memory is in `learn`, and does not count, but `act` must not crash there.)
#
# Half a page with it: what does your agent keep from step to step, what from episode to episode, and what of it was
# your knowledge and not learned? In which task would that be wrong?


# %%
def my_agent(corridor):
    """Make the agent for the challenge; put your own in its place."""
    return QLearning.create(corridor, learning_rate=0.5, discount=0.0)


CHALLENGE.score(my_agent, "Ada Lovelace")

# %% [markdown]
# ### From a blank file
# Now write it all yourself, from an empty cell, with NumPy and Gymnasium only: Q-learning with a memory of its own, and its
# loop, some 35 lines. Nobody shows your agent a window now. It gets single observations, and keeps the last three of
# them and the two actions between them. This window takes the place of the state, in a dictionary, say:
#
# $$
# S_t = (O_{t-2}, A_{t-2}, O_{t-1}, A_{t-1}, O_t)
# $$
#
# An episode begins with a window of $O_0$ alone: $S_0 = (O_0)$ and $S_1 = (O_0, A_0, O_1)$ are shorter. (Or fill them up
# in front with $O_0$ and action 0, as `FrameStack` does, in the policy, too.)
#
# **What it must do.** `my_program(environment, n_steps, seed)` takes `n_steps` steps in a Gymnasium environment, episode after
# episode, and learns from each of them. In the end it returns its *policy*. A policy must remember too, so it is a function
# of the **history**: it takes the tuple $(O_0, A_0, O_1, A_1, \dots, O_t)$ of the present episode, and returns the action with the
# highest value. All else is up to you: functions, classes, any names, and how ties are broken.
#
# - Observations and actions are whole numbers from 0. `environment.observation_space.n` and `environment.action_space.n` say
#   how many there are. They differ from one environment to the next.
# - Take $\alpha = 0.2$, $\gamma = 0.8$, $\varepsilon = 0.1$ and first values of 0 (in the lesson above α was 0.1). After a step with `terminated` the
#   target is $R$ alone; after a truncated one the next window still has its value.
# - Draw all random numbers from `np.random.default_rng(seed)`, and give the seed to the first `reset` alone.
#
# The check runs your program in small worlds of its own, in which states look alike, and for 20 000 steps in the
# corridor, some twenty seconds in all. It sees the steps that your program takes, and no line of it. So the mistake that it names is only the likely
# one.

# %% tags=["project"]
my_program = ...  # your program
### BEGIN PROGRAM


def choose_action(values, epsilon, rng):
    """Return an action by ε-greedy, ties broken at random."""
    if rng.random() < epsilon:
        return int(rng.integers(len(values)))
    return int(rng.choice(np.flatnonzero(values == values.max())))


def my_program(environment, n_steps, seed):
    """Learn by Q-learning on windows for `n_steps` steps, and return the greedy policy."""
    alpha, gamma, epsilon, k = 0.2, 0.8, 0.1, 3
    rng = np.random.default_rng(seed)
    Q = {}

    def window(history):
        """Return the last k observations, and the actions between them."""
        return history[-(2 * k - 1) :]

    def row(window):
        """Return the values of a window, 0 where it is new."""
        return Q.setdefault(window, np.zeros(environment.action_space.n))

    state = (environment.reset(seed=seed)[0],)
    for _ in range(n_steps):
        action = choose_action(row(state), epsilon, rng)
        observation, reward, terminated, truncated, _ = environment.step(action)
        next_state = window((*state, action, observation))
        target = reward if terminated else reward + gamma * row(next_state).max()
        row(state)[action] += alpha * (target - row(state)[action])
        state = next_state
        if terminated or truncated:
            state = (environment.reset()[0],)
    return lambda history: choose_action(row(window(history)), 0.0, rng)


### END PROGRAM

# %% tags=["project"]
from edugym_course.lessons.memory.project import project_5

check(project_5, my_program)

# %% [markdown]
# ## What you saw
#
# ### In one paragraph
# *Learn it by heart, or better, say it in your own words.* An observation is what an agent sees, and a state is what
# decides the future. Where states that look alike want different actions, the agent must build a state of its own from its history, and the history
# includes its own actions. A window is the simplest way: it keeps everything for a short time, and its table grows
# exponentially with its length. A better memory keeps only what matters. Somebody must know what that is, or a network
# must learn it.
#
# ### Limits
# In the corridor the past tells *everything* that matters. In many tasks the history leaves the state uncertain, and
# the best agent state is a probability for every state, a *belief*. Our best play with a window was found by a search
# that may miss better ones. And the bands of DQN come from three runs.
#
# ### Further reading
# - Moerland et al. (2023), *EduGym: An environment and notebook suite for reinforcement learning education*: the paper.
#   There a table and DQN with stacked frames are compared with recurrent PPO.
# - Sutton and Barto, *Reinforcement Learning*, 2nd edition: 17.3 (observations and state, $k$th-order history, the
#   state-update function).
# - Kaelbling, Littman and Cassandra (1998), *Planning and acting in partially observable stochastic domains*: beliefs.
# - Lin and Mitchell (1992), *Memory approaches to reinforcement learning in non-Markovian domains*: window and
#   recurrent Q-learning.
# - Hausknecht and Stone (2015), *Deep recurrent Q-learning for partially observable MDPs*.
# - Hochreiter and Schmidhuber (1997): the LSTM.
# - Ni, Eysenbach and Salakhutdinov (2022), *Recurrent model-free RL can be a strong baseline for many POMDPs*.
