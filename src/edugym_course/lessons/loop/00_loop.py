# %% [markdown]
# # The loop: rewards, returns, and a first learner
#
# **The challenge.** Nobody tells the agent what to do. It acts, and it gets rewards. From these rewards
# alone it has to find out which actions are good, even when the reward comes thirty steps later.
#
# **You will be able to** write the loop of agent and environment; say what separates a reward from a return; explain
# what the discount changes; and complete an agent of about ten lines that takes millions of steps a second.
#
# **Time.** {time} **Before you start.** Two lectures on reinforcement learning, or
# sections 3.1 to 3.6 and 6.5 of Sutton and Barto, *Reinforcement Learning*, 2nd edition. All symbols are in the [table of
# notation](https://github.com/RLG-Leiden/edugym/blob/main/docs/notation.md).
#
# **This page is a program.** Click into a cell of code and press Shift and Enter: it runs, and its result appears below. Go
# from top to bottom. Change a number and run the cell again as often as you like. If you get lost, restart from the menu
# "Kernel" and run all cells.

# %%
from typing import NamedTuple

import gymnasium as gym
import numpy as np

from edugym import EpsilonGreedy, QLearning, TabularObservation, train
from edugym.agents.tables import greedy_action
from edugym_course.lessons.loop import exact, figures, methods
from edugym_course.notebook import frames, play, predict, sliders, source

# %% [markdown]
# ## Meet the environment: a shop
#
# A shopper enters a supermarket and should leave by the exit with three items. The shopper is the **agent**: it chooses
# the actions. Everything else is the **environment**.

# %%
env = gym.make("edugym/Supermarket-v0")
state, info = env.reset(seed=0)
env.unwrapped.scene()

# %% [markdown]
# Play it yourself, with the buttons. Each step costs 1 point, an item brings 25 and the exit 50, so that the step onto
# an item has the reward 24. (The exit pays the same with an empty bag as with a full one, and it ends the visit.) What
# is the highest total that you can get? (The text below tells you.)

# %%
play("Supermarket", max_steps=100)

# %% [markdown]
# ### The loop
# Agent and environment talk in turns (section 3.1). At time step $t$ the agent is in a **state** $S_t$ and chooses an
# **action** $A_t$. The environment answers with a **reward** $R_{t+1}$, a number, and the next state $S_{t+1}$. In this shop
# the state is the place of the shopper and what is in the bag. The actions are 0 up, 1 down, 2 left, 3 right.
#
# Take two steps by hand, down and to the right:

# %%
print("the first state:", state)
for action in (1, 3):
    state, reward, terminated, truncated, info = env.step(action)
    print(f"action {action}: state {state}, reward {reward}, terminated {terminated}, truncated {truncated}")

# %% [markdown]
# The state is only a number to the agent (8 times the number of its cell, plus 4, 2 or 1 for each item in its bag): nothing tells it that 88 and 96 are neighbours. Here is the whole loop, in the
# words of [Gymnasium](https://gymnasium.farama.org), with the simplest agent there is. It acts at random.

# %%
env.action_space.seed(1)
state, info = env.reset(seed=0)
total, steps, terminated, truncated = 0, 0, False, False
while not (terminated or truncated):
    action = env.action_space.sample()
    state, reward, terminated, truncated, info = env.step(action)
    total, steps = total + reward, steps + 1
print(f"{steps} steps, {total:g} points in all, terminated {terminated}, truncated {truncated}")

# %% [markdown]
# From the first state to the end is an **episode**. It can end in two ways, and they are not the same:
#
# - **terminated**: the task is over, and nothing can come after it. The shopper is at the exit.
# - **truncated**: somebody stopped the clock, here after 500 steps (in your own game: 100). The shopper could have
#   gone on.
#
# A rule that chooses the actions is called a **policy**. This one is the random policy.
#
# **Predict.** How many points does the random policy get in an episode, on average? *Run the next cell, type your
# answer into its field, and go on to the cell after it.* Nobody grades your answer. Then click on the triangle before
# "What was measured".

# %%
random_play = predict("The random policy gets, on average:", unit="points")
random_play

# %%
totals, cut_off = methods.play_at_random(env, episodes=400)  # the loop above, 400 times
print(f"400 episodes: {np.mean(totals):.0f} points on average, and {np.mean(cut_off):.0%} of them are truncated")
print(f"computed from the rules of the shop: {exact.random_return():.0f} points")
random_play.measured(exact.random_return())

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** −313 points. About half of the random episodes do not get to the exit, and pay for 500 steps. This number
# needs no playing: it can be computed from the rules of the shop.
# </details>

# %% [markdown]
# ## The idea: what counts is the return, not the reward
#
# The agent does not want the next reward. It wants a high **return**, the *discounted* sum of all rewards from now on
# (equation 3.8):
#
# $$
# G_t = R_{t+1} + \gamma R_{t+2} + \gamma^2 R_{t+3} + \dots
# $$
#
# The **discount** $\gamma$, from 0 to 1, says how much the future counts: a reward that comes $k$ steps after the next one
# counts $\gamma^k$ times. After a terminal state the return is 0. Remember this second form of the equation (3.9):
#
# $$
# G_t = R_{t+1} + \gamma G_{t+1}
# $$
#
# It computes returns *backwards*, from the end. A made-up episode: two steps at a cost of 1, then a last one with the reward
# 24; $\gamma = 0.5$:

# %%
G = 0  # after the end
for reward in (24, -1, -1):  # the last reward first
    G = reward + 0.5 * G
    print(f"reward {reward:3}, return from here on {G:g}")

# %% [markdown]
# *Points* or *total* always means the plain sum of an episode ($\gamma = 1$). *Return* means the discounted sum.
#
# **Reward is not return.** Here is the best way through the shop for $\gamma = 0.95$. The bars are its rewards. The line is
# the return from each step on.

# %%
figures.rewards_and_returns(0.95)

# %% [markdown]
# Nearly all steps of the *best* way have the reward −1, like the steps of any bad way. The reward does not show that
# they are good. The return does: at the entrance it is 34, and 28.5 if two steps are wasted first. (On every way the line rises
# towards an item and falls after it, for that reward is then in the past.) The plain sum of the best way is 95.
#
# **Predict.** A player who knows the rules always takes the action with the highest *next reward* (if several are equal, one of them at random).
# The best possible total is 95. What does this player get on average?

# %%
next_reward = predict(
    "Always the highest next reward:", ["more than half of the best (47 points)", "from 0 to 47", "less than 0"]
)
next_reward

# %%
earned = exact.myopic_return()
print(
    f"highest next reward: {earned:.0f} points, random: {exact.random_return():.0f}, best policy: {methods.OPTIMUM:g}"
)
print(f"at random, but leaves wherever the exit is one step away: {exact.leaving_return():.0f} points")
next_reward.measured(next_reward.options[0 if earned > 47 else 1 if earned >= 0 else 2])

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** −248 points. Where no item and no exit is beside it, all four rewards are −1, and this player walks at
# random too. Beside the exit it leaves, whatever is still missing in its bag. The best policy would not. But that is most of what
# makes this player better than random play: who only leaves earns nearly as much. </details>

# %% [markdown]
# ### Values: the return to be expected
# So an agent needs to know what return an action *leads to*. That is its **value**. With the best policy from then on
# it is called $q_*(s, a)$, for action $a$ in state $s$ (equation 3.20, without chance; $s'$ is the next state, $r$ the reward):
#
# $$
# q_*(s, a) = r + \gamma \max_{a'} q_*(s', a') \qquad\qquad v_*(s) = \max_a q_*(s, a)
# $$
#
# It is equation 3.9 once more: the next reward, and then the best return from there on. (After a terminal state the second
# part is 0.) $v_*(s)$ is the value of the state. To play perfectly, take the action with the highest *value*. That is the
# **greedy** action.
#
# ### Learning: the update of Q-learning
# The agent does *not* know the rules. It keeps a table $Q(s, a)$ of guesses, at first all 0. After each step, from $S$ by
# $A$ to $S'$ with reward $R$, it moves one guess a part of the way towards a better one, the *target*. The part is $\alpha$,
# the **learning rate**. This is **Q-learning** (equation 6.8):
#
# $$
# Q(S, A) \leftarrow Q(S, A) + \alpha \big[ \underbrace{R + \gamma \max_a Q(S', a)}_{\text{target}} - Q(S, A) \big]
# $$
#
# The target is the right side of the equation of $q_*$, with guesses in the place of the true values. These are the lines
# that run. (`one_step_target` is $R + \gamma \max_a Q(S', a)$. After *terminated* there is no future, and it is $R$ alone.
# After *truncated* there is one, and it still counts.)

# %%
source(QLearning.learn)

# %% [markdown]
# To find something better, it should also try what does not look best. **ε-greedy** takes a random
# action with probability $\varepsilon$, and the greedy action otherwise. Now put this agent into the loop, for 2 000
# steps:

# %%
agent = QLearning.create(env, learning_rate=0.5, discount=0.99, exploration=EpsilonGreedy(0.1))
rng = np.random.default_rng(0)
state, info = env.reset(seed=0)
for _ in range(2_000):
    action = agent.act(state, rng)
    next_state, reward, terminated, truncated, info = env.step(action)
    agent.learn(state, action, reward, next_state, terminated)
    state = env.reset()[0] if terminated or truncated else next_state
print("values of the four actions in the first state:", agent.Q[8].round(2))

# %% [markdown]
# What does this agent do without exploring now? Press the button of the film, or move its slider.

# %%
frames(env, agent, max_steps=40)

# %% [markdown]
# The shopper stays at the entrance. Of the four values printed above, the highest is that of action 0, up. That leads nowhere, since nobody leaves by
# the entrance, and without learning the values stay as they are, so it stays where it is at every step. Here the agent knows only that
# steps cost points. Each update carries value one step back, from $S'$ to $S$. And after 20 000 steps more? `train` is the loop that you have just seen,
# translated into machine code.

# %%
train(env, agent, 20_000, seed=1)
frames(env, agent, max_steps=40)

# %% [markdown]
# Now it takes all three items and leaves after 30 steps, with 95 points.
#
# **In other environments.** The loop stays the same. But a table has numbered rows, and in other tasks the agent
# observes more than one number. On the road of lesson 2 there are two, the place of a runner and its speed.
# `TabularObservation` makes them the number of a row. (`train` does so by itself. Images have too many values for a
# table: lesson 4.)

# %%
road = gym.make("edugym/Roadrunner-v0")
print("the road observes", road.reset(seed=0)[0], "in", road.observation_space)
road = TabularObservation(road)  # the only new line
state, info = road.reset(seed=0)
print("its row in a table:", state, "in", road.observation_space)

# %% [markdown]
# ## The experiment: who learns the way?
#
# Three players, the same shop, 20 000 steps. One acts at random. One is Q-learning with $\gamma = 0.99$. The third is the
# same Q-learning with $\gamma = 0$: its target is $R$ alone, so it learns rewards, not returns. Both learners have $\alpha =
# 0.5$ and $\varepsilon = 0.1$.
#
# Every 250 steps each of them plays one episode in which it neither explores nor learns (the random one stays random): so we see what it has learned.
#
# **Predict.** Who has the lowest mean in these episodes, over the last 5 000 steps?

# %%
worst = predict("The lowest points without exploring:", [methods.RANDOM, methods.MYOPIC, methods.Q_LEARNING])
worst

# %%
results = methods.play_and_learn(n_steps=20_000, repetitions=30)
display(figures.learning_curves(results))
late = {player: results.curves(player).loc[15_000:].to_numpy().mean() for player in results.methods}
for player, points in late.items():
    print(f"{player:20} mean over the last 5 000 steps: {points:5.0f} points")
solved = results.share(methods.Q_LEARNING, methods.OPTIMUM).estimate
print(f"runs of {methods.Q_LEARNING} that end with the optimum: {solved:.0%}")
worst.measured(min(late, key=late.get))

# %% [markdown]
# How to read the figure. On the left are the episodes without exploring, on the right those in which they learn, random
# actions included. A line is the mean of 30 runs, and its band shows how sure this mean is (95 % confidence interval). The
# dashed line is the *optimum*, the best possible total. The dotted line is the best mean for a player who takes 10 % random
# actions. (Ignore the right panel before step 500: only lucky, short episodes can have ended by then.)
#
# <details><summary>What was measured</summary>
#
# **Measured.** Q-learning with $\gamma = 0$, in the left panel: far below random play. The same lines of code with
# $\gamma = 0.99$ find the optimum in most runs (here in 28 of 30, and in 24 of 30 on average over 59 other seeds), and in the rest
# a worse way, mostly with two items.
#
# At first its line on the left is as low as that of $\gamma = 0$: it does not learn in these episodes, so it takes the same
# action again and again, often into a wall. While it learns (right) it is soon better than random play: what it
# has tried looks worse than what it has not, so it tries all actions. Then the value of the items and the exit comes
# back along the way, one state after the other. </details>
#
# <details><summary>Why is γ = 0 worse than random play?</summary>
#
# Where the agent has often been, its values are about −1, except beside an item or the exit. With exactly right values
# it would be the player with −248 points from above. But they are not quite right, and in these episodes they do not change. So the
# smallest difference decides, in the same way at every visit, and the shopper stands at a wall or wanders in one part
# of the shop until the clock stops. While it learns (right panel) its values change at every visit and it explores, and it is
# nearly as good as the player with −248 points.
#
# A test: with $\alpha = 1$ a value is exactly −1 after one try, and chance decides between equal values. This player is
# nearly as good as the one with −248 (the next cell). </details>

# %%
at_once = methods.play_and_learn(n_steps=20_000, learning_rate=1.0, repetitions=30).curves(methods.MYOPIC)
print(f"{methods.MYOPIC} and α = 1: {at_once.loc[15_000:].to_numpy().mean():.0f} points")

# %% [markdown]
# ## Your turn: the discount
#
# With $\gamma = 0.95$ the best way collects all three items.
#
# The map below shows $v_*$ of each cell for one bag, and the best action as an arrow. (A slanted arrow: two actions are
# equally good. No arrow: several are, or it is the entrance, "in". White cells are the exit, or hold an item that is not in the bag: whoever
# enters that takes it, and has another bag.) The orange line, the best way from the entrance,
# is drawn on the map of the empty bag alone. After an item the bag is another one, so from there on the line may run against the arrows.
# The right panel always shows this way: what each of its rewards counts at the start.
#
# **Predict.** How many items does the best way (the orange line below) collect with $\gamma = 0.85$?

# %%
items = predict("With γ = 0.85 the best way collects ...", ["no item", "one", "two", "all three"])
items

# %%
display(figures.with_discount(gamma=0.85))
items.measured(items.options[exact.items_on(exact.best_way(0.85))])

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** One. The exit is at least 16 steps away, so that its reward counts at most $0.85^{15} = 0.09$ times.
# Some of the ways with 16 steps pass the red item, so it costs nothing extra. With the green item as well the best way
# has 22 steps, and the return of the whole way would fall, from 6.2 to 5.8: the item brings $25 \cdot 0.85^{14} = 2.6$, but
# the exit comes 6 steps later, and that costs more. The shop is the same as before: the discount belongs to the *question*,
# not to the world. </details>

# %% [markdown]
# *Move a slider and let it go.* At which values of $\gamma$ does the best way change? What is best for $\gamma = 0$?

# %%
sliders(
    figures.with_discount,
    gamma=[0.0, 0.5, 0.8, 0.85, 0.88, 0.89, 0.9, 0.92, 0.94, 0.95, 0.97, 0.99, 1.0],
    bag=list(figures.BAGS),
)

# %% [markdown]
# <details><summary>Answer</summary>
#
# On this slider: at $\gamma = 0$ all ways from the start are equal. From 0.5 to 0.89 one item is best (16 steps), from
# 0.9 to 0.94 two (22 steps), from 0.95 on all three (30 steps).
# </details>

# %% [markdown]
# ## See inside: the table while it learns
#
# On the left is what another agent has learned with $\gamma = 0.99$, the highest $Q(s, a)$ in each cell. In grey cells it
# has learned nothing. In the palest cells it knows only that steps cost points, and there the arrow mostly points to
# what it has tried least, sometimes into a wall. On the right is $v_*$. Move the slider from 0 on: it is a film of
# learning.

# %%
sliders(
    figures.learned_beside_exact,
    steps=[0, 500, 1_000, 1_500, 2_000, 2_500, 3_000, 3_500, 4_000, 5_000, 6_000, 8_000, 10_000, 20_000],
    bag=list(figures.BAGS),
)

# %% [markdown]
# A faint colour starts beside the red item and comes back towards the entrance, one or two cells from picture to picture. Later
# the cells grow darker once more: now the value of the other items and of the exit has come back too. In the end the
# value of the first state, the entrance with an empty bag, is right to one decimal, for this agent. (The rest of the way has the bags "red",
# "red and green" and "all three".)

# %% [markdown]
# ## Predict, then check
#
# An agent can act in 420 states of the shop: each cell but the exit, with each bag that is possible there. After 20 000
# steps the agent takes a good way, as you saw.
#
# **Predict.** In what share of these states is its greedy action a best one?

# %%
everywhere = predict("States in which the agent's greedy action is a best one:", unit="%")
everywhere

# %%
for steps in (0, 20_000):
    agents = [figures.agent_after(steps, seed=seed) for seed in range(10)]
    share = np.mean([exact.right_choices(agent.Q, discount=0.99) for agent in agents])
    print(f"after {steps:6,} steps: a best action in {share:.0%} of the states (mean of 10 agents)")
untried = np.mean([exact.untried(agent.Q) for agent in agents])
for tried, part in ((False, untried), (True, 1 - untried)):
    right = np.mean([exact.right_choices(agent.Q, discount=0.99, tried=tried) for agent in agents])
    print(f"{'tried' if tried else 'never tried'}: {part:.0%} of the states, a best action in {right:.0%} of these")
everywhere.measured(100 * share)

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** In less than half of them. Before the first step, when all values are equal and chance decides, it was
# 36 %. In 20 000 steps with 10 % random actions Q-learning learns *its way* and little else. In about half of the states it never
# acted, and these keep their first values (35 % right, by luck).
# </details>

# %% [markdown]
# ## Exercises
#
# Put your code in the place of the line `raise NotImplementedError(...)`, run the cell, and then run the cell below it,
# which checks your answer. It says what was expected, what came, and which mistake that looks like. Try as often as you
# like. Click on a hint to open it.

# %%
from edugym_course.grading import check
from edugym_course.lessons.loop.exercises import exercise_1, exercise_2, exercise_3

# %% [markdown]
# ### Exercise 1: the return
# Write the function that computes the return of an episode from the list of its rewards, in the order in which they came.
#
# <details><summary>Hint</summary>Go through the rewards from the last to the first with <code>reversed(rewards)</code>, as
# the cell under equation 3.9 did. The return after the end is 0.</details>


# %%
def discounted_return(rewards, discount):
    """Return the discounted sum of a list of rewards."""
    ### BEGIN SOLUTION
    G = 0.0
    # own: G = {after}
    for reward in reversed(rewards):
        G = reward + discount * G
    return G
    ### END SOLUTION


# %% tags=["check"]
check(exercise_1, discounted_return)
### BEGIN HIDDEN TESTS
check(exercise_1, discounted_return, seed=1, quiet=True)
### END HIDDEN TESTS

# %% [markdown]
# ### Exercise 2: choose an action
# Write ε-greedy. `values` is an array with the value of each action in one state. With probability `epsilon` the function
# returns a random action, each with the same probability. Otherwise it returns the action with the highest value, and if
# several have it, one of *these* at random. An action is its index: 0, 1, and so on.
#
# <details><summary>Hint</summary><code>rng.random()</code> is a random number from 0 to 1, and <code>rng.integers(n)</code> a
# random whole number from 0 to n − 1. <code>np.flatnonzero(values == values.max())</code> has the indices of all highest
# values, and <code>rng.choice(indices)</code> takes one of them.</details>


# %%
def choose(values, epsilon, rng):
    """Return an action by ε-greedy, ties broken at random."""
    ### BEGIN SOLUTION
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return rng.choice(np.flatnonzero(values == values.max()))
    # own: return rng.choice(np.flatnonzero(values >= values.max() - {margin}))
    ### END SOLUTION


# %% tags=["check"]
check(exercise_2, choose)
### BEGIN HIDDEN TESTS
check(exercise_2, choose, seed=1, quiet=True)
### END HIDDEN TESTS

# %% [markdown]
# ### Exercise 3: the update of your own agent
# An agent is a class with `act`, `greedy` (for episodes without exploring) and `learn`. Write `learn`: one update of Q-learning (equation 6.8). Read
# `self.learning_rate`, which is $\alpha$, `self.discount`, which is $\gamma$, and the table `self.Q`. After *terminated* the
# target is the reward alone. The class is a `NamedTuple`: its fields are fixed, but the entries of the table `Q` can change.
#
# `act` is the ε-greedy of exercise 2, with $\varepsilon = 0.1$: `int(rng.random() * n)` is a random whole number from 0 to
# n − 1, as `rng.integers(n)` is. (`return choose(self.Q[state], 0.1, rng)`, with your own `choose`, works too, and is slower.) `greedy_action` takes the highest
# value, and one of them at random if several have it.
#
# After the check your agent races the players of this lesson, with a table of 800 rows: 100 cells × 8 bags. You write
# plain Python, and it is translated into machine code, which takes some seconds, once. Then it runs millions of steps a
# second. That works for a `NamedTuple`, and without a `print` in its methods. With a `print`, or with an ordinary class, the cell
# takes a minute or more.
#
# <details><summary>Hint</summary><code>state</code>, <code>action</code>, <code>reward</code> and <code>next_state</code> are
# S, A, R and S'. <code>self.Q[state, action]</code> is one guess, and <code>max(self.Q[next_state])</code> the highest value in
# the next state. First compute the target, then move <code>self.Q[state, action]</code> towards it with
# <code>+=</code>.</details>


# %%
class MyAgent(NamedTuple):
    """Q-learning, in about ten lines."""

    Q: np.ndarray  # shape (n_states, n_actions)
    learning_rate: float = 0.5
    discount: float = 0.99

    def act(self, state, rng):
        """Choose an action by ε-greedy with ε = 0.1."""
        return int(rng.random() * self.Q.shape[1]) if rng.random() < 0.1 else self.greedy(state, rng)

    def greedy(self, state, rng):
        """Choose the action with the highest value."""
        return greedy_action(self.Q, state, rng)

    def learn(self, state, action, reward, next_state, terminated):
        """Learn from one step."""
        ### BEGIN SOLUTION
        target = reward if terminated else reward + self.discount * max(self.Q[next_state])
        self.Q[state, action] += self.learning_rate * (target - self.Q[state, action])
        # own: self.Q[state, action] += self.learning_rate * (target - {cost} - self.Q[state, action])
        ### END SOLUTION


# %% tags=["check"] points=2
check(exercise_3, MyAgent)
### BEGIN HIDDEN TESTS
check(exercise_3, MyAgent, seed=1, quiet=True)
### END HIDDEN TESTS
display(figures.race({"my agent": lambda shop: MyAgent(np.zeros((800, 4)))}))
run = train("Supermarket", MyAgent(np.zeros((800, 4))), 3_000_000, evaluate_every=3_000_000)

# %% [markdown]
# Your agent's line should lie on that of Q-learning with $\gamma = 0.99$: it is the same agent. (With your own `choose`, which draws other random numbers, it lies near it.) The last line trains it for
# 3 million steps: `run.seconds`, in a cell of your own, says how long that took, compiling and evaluating included. Now it is yours. Change its learning rate
# or the 0.1 in `act`, and race again.

# %% [markdown]
# ### From a blank file
# So far you have put lines into code of ours. Now write it all yourself, from an empty cell, with NumPy and Gymnasium only:
# the loop and Q-learning, some 30 lines.
#
# **What it must do.** `my_program(environment, n_steps, seed)` takes `n_steps` steps in a Gymnasium environment, episode after
# episode, and learns from each of them at once. In the end it returns its *policy*: a function that takes a state and returns the
# action with the highest value. All else is up to you: functions, classes, any names, and how ties are broken.
#
# - States and actions are whole numbers from 0. `environment.observation_space.n` and `environment.action_space.n` say how
#   many there are. They differ from one environment to the next.
# - Take $\alpha = 0.5$, $\gamma = 0.99$, $\varepsilon = 0.1$ and first values of 0. Only `terminated` means
#   that nothing follows.
# - Draw all random numbers from `np.random.default_rng(seed)`, and give the seed to the first `reset` alone.
#
# The check runs your program in small worlds of its own and in the shop. It sees the steps that your program takes,
# and no line of it. So the mistake that it names is only the likely one. Try it yourself first, with
# `my_program(gym.make("edugym/Supermarket-v0"), 10_000, seed=0)`. Let it append the points of each episode to a list
# outside of it, and plot them with any library: a learning curve of your own is the best tool to find a mistake.

# %% tags=["project"]
my_program = ...  # your program
### BEGIN PROGRAM


def choose_action(values, epsilon, rng):
    """Return an action by ε-greedy, ties broken at random."""
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return rng.choice(np.flatnonzero(values == values.max()))


def my_program(environment, n_steps, seed):
    """Learn by Q-learning for `n_steps` steps, and return the greedy policy."""
    alpha, gamma, epsilon = 0.5, 0.99, 0.1
    rng = np.random.default_rng(seed)
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    state, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        action = choose_action(Q[state], epsilon, rng)
        next_state, reward, terminated, truncated, _ = environment.step(action)
        target = reward if terminated else reward + gamma * Q[next_state].max()
        Q[state, action] += alpha * (target - Q[state, action])
        state = next_state
        if terminated or truncated:
            state, _ = environment.reset()
    return lambda state: choose_action(Q[state], 0.0, rng)


### END PROGRAM

# %% tags=["project"]
from edugym_course.lessons.loop.project import project_0

check(project_0, my_program)

# %% [markdown]
# ## What you saw
#
# An agent wants a high return, the discounted sum of all rewards from now on: $G_t = R_{t+1} + \gamma G_{t+1}$. A
# reward alone does not tell whether an action was good: acting for the next reward brought −248 points (random play
# −313, the best policy 95), and after 20 000 steps of learning the next reward alone, the agent without exploring was
# still worse than random play (with $\alpha = 0.5$). So the agent learns values, the returns that it can expect. Q-learning moves its guess
# for an action towards the reward plus the discounted best guess for the next state, where there is one. One
# update carries value back by one state, so the value of what is far away comes back by at most one state with each walk along the way. *Now say this in your own words.*
#
# ### What comes next
# The shop was easy in many ways. Lessons 1 to 9 make it harder, one thing at a time; below are their environments. (Lesson 0b
# stays with one state, and asks how much to explore.) In lesson 10 you write your own: states, actions, and a reward that
# says what you mean. And in lesson 11 the goal is another one in each episode.

# %%
figures.nine_challenges()

# %% [markdown]
# ### Limits
# In this shop nothing happens by chance; elsewhere $q_*$ needs a mean over all that can happen (equation 3.20 in full).
# There are only 428 states: the 420 from before, and 8 at the exit, one for each bag. A table has room for them all.
# And the best way is known (lesson 9 shows how to compute it).
#
# ### Further reading
# - Sutton and Barto, *Reinforcement Learning*, 2nd edition: 3.1–3.6 (agent, return, values), 6.5 (Q-learning); 1.1–1.5 for
#   the whole story.
# - Watkins and Dayan (1992), *Q-learning*: the update, from the thesis of Watkins (1989), and a proof that it converges.
# - Moerland et al. (2023), *EduGym: An environment and notebook suite for reinforcement learning education*: the paper
#   behind the nine environments.
