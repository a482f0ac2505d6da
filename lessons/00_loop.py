# %% [markdown]
# # The loop: rewards, returns, and a first learner
#
# **The challenge.** Nobody tells the agent what to do. It acts, and now and then it gets a reward. From these rewards
# alone it has to find out which actions are good, also when the reward comes thirty steps later.
#
# **You will be able to** write the loop of agent and environment; say what separates a reward from a return; explain
# what the discount changes; and write an agent in ten lines that takes millions of steps a second.
#
# **Time.** 25 minutes, and 20 more for the exercises. **Before you start.** Two lectures on reinforcement learning, or
# sections 3.1 to 3.6 and 6.5 of Sutton and Barto, *Reinforcement Learning*, 2nd edition. All symbols are in the [table of
# notation](https://github.com/RLG-Leiden/edugym/blob/main/docs/notation.md).
#
# **This page is a program.** Text and cells of code take turns. Click into a cell of code and press Shift and Enter: it
# runs, and its result appears below. Go from top to bottom, since a cell may need the ones above. Change a number and run
# the cell again as often as you like. If you get lost, restart from the menu "Kernel" and run all cells.

# %%
from typing import NamedTuple

import gymnasium as gym
import numpy as np

from edugym import EpsilonGreedy, QLearning, train
from edugym.agents.tables import greedy_action, one_step_target
from edugym.lessons import loop
from edugym.notebook import frames, play, predict, sliders, source

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
# Play it yourself, with the buttons. Each step costs 1 point, an item brings 25 and the exit 50. What is the highest
# total that you can get?

# %%
play("Supermarket", max_steps=100)

# %% [markdown]
# ### The loop
# Agent and environment talk in turns (section 3.1). At time step $t$ the agent is in a **state** $S_t$ and chooses an
# **action** $A_t$. The environment answers with a **reward** $R_{t+1}$, a number, and the next state $S_{t+1}$. In this shop
# the state is the place of the shopper together with what is in the bag. The actions are 0 up, 1 down, 2 left, 3 right.
#
# [Gymnasium](https://gymnasium.farama.org) is how most programs write this down: `reset` begins an episode, and `step`
# takes an action. Take two steps by hand, down and to the right:

# %%
print("the first state:", state)
for action in (1, 3):
    state, reward, terminated, truncated, info = env.step(action)
    print(f"action {action}: state {state}, reward {reward}, terminated {terminated}, truncated {truncated}")

# %% [markdown]
# The state is only a number to the agent: nothing tells it that 88 and 96 are neighbours. Here is the whole loop. The agent
# in it is the simplest one there is: it acts at random.

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
# The same lines run in any environment of Gymnasium, for example in `gym.make("FrozenLake-v1")`.
#
# From the first state to the end is an **episode**. It can end in two ways, and they are not the same:
#
# - **terminated**: the task is over. The shopper is at the exit, and nothing can come after it.
# - **truncated**: somebody stopped the clock, here after 500 steps. The shopper is still somewhere, and could have gone on.
#
# A rule that chooses the actions is called a **policy**. This one is the random policy.
#
# **Predict.** How many points does the random policy get in an episode, on average? *In these lessons you answer before you
# run.* Run the next cell, type your answer into its field, and go on to the cell after it. Nobody grades your answer. Below,
# click on the triangle to read what happened and why.

# %%
random_play = predict("The random policy gets, on average:", unit="points")
random_play

# %%
totals, cut_off = loop.play_at_random(env, episodes=400)  # the loop above, 400 times
print(f"400 episodes: {np.mean(totals):.0f} points on average, and {np.mean(cut_off):.0%} of them are truncated")
print(f"computed from the rules of the shop: {loop.random_return():.0f} points")
random_play.measured(loop.random_return())

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** −313 points. About half of the random episodes do not get to the exit, and pay for 500 steps. This number
# needs no playing: the rules of the shop are known, so it can be computed. The mean of 400 episodes is close to it.
# </details>

# %% [markdown]
# ## The idea: not the reward counts, but the return
#
# The agent does not want the next reward. It wants a high **return**, the sum of all rewards from now on (equation 3.8):
#
# $$
# G_t = R_{t+1} + \gamma R_{t+2} + \gamma^2 R_{t+3} + \dots
# $$
#
# The **discount** $\gamma$, from 0 to 1, says how much the future counts: the next reward counts in full, and one that comes
# $k$ steps after it counts $\gamma^k$ times. With $\gamma = 1$ all count the same, and with $\gamma = 0$ only the next one.
# After a terminal state the return is 0. A second form of this equation (3.9) is the one to remember:
#
# $$
# G_t = R_{t+1} + \gamma G_{t+1}
# $$
#
# It says how to compute returns: *backwards*, from the end. Two steps at a cost of 1, then a step onto an item ($25 - 1$),
# and there the episode ends; $\gamma = 0.5$:

# %%
G = 0  # after the end
for reward in (24, -1, -1):  # the last reward first
    G = reward + 0.5 * G
    print(f"reward {reward:3}, return from here on {G:g}")

# %% [markdown]
# **Reward is not return.** Here is the best way through the shop for $\gamma = 0.95$. The bars are its rewards. The line is
# the return from each step on.

# %%
loop.rewards_and_returns(0.95)

# %% [markdown]
# Nearly all steps of the *best* way have the reward −1, like the steps of any bad way. The reward does not tell that they
# are good. The return does: the line rises towards each item, although the bars stay at −1.
#
# **Predict.** A player knows the reward of every action, and always takes the action with the highest *next reward* (if
# several are equal, one of them at random). The best possible total is 95. What does this player get on average?

# %%
next_reward = predict("Always the highest next reward:", ["more than 47", "from 0 to 47", "less than 0"])
next_reward

# %%
earned = loop.myopic_return()
print(f"highest next reward: {earned:.0f} points, random: {loop.random_return():.0f}, best policy: {loop.OPTIMUM:g}")
next_reward.measured("more than 47" if earned > 47 else "from 0 to 47" if earned >= 0 else "less than 0")

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** −248 points, far below 0 like random play. Where no item and no exit is beside it, all four rewards are −1,
# and this player walks at random too. And beside the exit it leaves, whatever is still missing in its bag.
# </details>

# %% [markdown]
# ### Values: the return to be expected
# So an agent needs to know what return an action *leads to*. That is its **value**. With the best policy from then on it is
# called $q_*(s, a)$, for action $a$ in state $s$ (equation 3.20, here for a world without chance, where $s'$ is the next
# state and $r$ the reward):
#
# $$
# q_*(s, a) = r + \gamma \max_{a'} q_*(s', a') \qquad\qquad v_*(s) = \max_a q_*(s, a)
# $$
#
# It is equation 3.9 once more: the next reward, and then the best return from there on. $v_*(s)$ is the value of the state.
# Whoever knows $q_*$ plays perfectly by looking at four numbers: take the action with the highest *value*. That is the
# **greedy** action. The rules of this shop are known, so a computer can find $q_*$ exactly (lesson 9 shows how), and you can
# see what learning should lead to.
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
# that run; the second cell shows the target:

# %%
source(QLearning.learn)

# %%
source(one_step_target)

# %% [markdown]
# After *terminated* there is no future, so the target is $R$ alone. After *truncated* there is one, and it still counts. That
# is why the two are told apart.
#
# While it learns, the agent must also try what does not look best. **ε-greedy** takes a random action with probability
# $\varepsilon$, and the greedy action otherwise. Now put this agent into the loop, for 1 000 steps:

# %%
agent = QLearning.create(env, learning_rate=0.5, discount=0.99, exploration=EpsilonGreedy(0.1))
rng = np.random.default_rng(0)
state, info = env.reset(seed=0)
for _ in range(1_000):
    action = agent.act(state, rng)
    next_state, reward, terminated, truncated, info = env.step(action)
    agent.learn(state, action, reward, next_state, terminated)
    state = env.reset()[0] if terminated or truncated else next_state
print("values of the four actions in the first state:", agent.Q[8].round(2))

# %% [markdown]
# Watch what this agent does without exploring now, after 1 000 steps. Press the button of the film, or move its slider.

# %%
frames(env, agent, max_steps=40)

# %% [markdown]
# The shopper does not get far. Its table knows that steps cost points, and hardly more: what lies at the end of the way has
# not come back to the entrance yet. And after 20 000 steps more? `train` is the loop that you have just seen, translated into
# machine code.

# %%
train(env, agent, 20_000, seed=1)
frames(env, agent, max_steps=40)

# %% [markdown]
# ## The experiment: who learns the way?
#
# Three players, the same shop, 20 000 steps. One acts at random and learns nothing. One is Q-learning with
# $\gamma = 0.99$. The third is the same Q-learning with $\gamma = 0$: its target is $R$ alone, so it learns rewards, not
# returns. Both learners have $\alpha = 0.5$ and $\varepsilon = 0.1$.
#
# The left panel shows their greedy policies: one episode without exploring, every 250 steps. (The random player stays
# random.) The right panel shows the episodes in which they learn, with their random actions. Lines are means of 30 runs, and
# bands are 95 % intervals. The dashed line is the *optimum*, the best possible total, which is not discounted. The dotted
# line is the best that a policy with 10 % random actions can get on average. Both are computed from the rules.
#
# **Predict.** Over the last 5 000 steps, who has the lowest mean in the left panel?

# %%
worst = predict("The lowest points without exploring:", [loop.RANDOM, loop.MYOPIC, loop.Q_LEARNING])
worst

# %%
results = loop.play_and_learn(n_steps=20_000, repetitions=30)
display(loop.learning_curves(results))
late = {player: results.curves(player).loc[15_000:].to_numpy().mean() for player in results.methods}
for player, points in late.items():
    print(f"{player:20} mean over the last 5 000 steps: {points:5.0f} points")
solved = results.share(loop.Q_LEARNING, loop.OPTIMUM).estimate
print(f"runs of {loop.Q_LEARNING} that end with the optimum: {solved:.0%}")
worst.measured(min(late, key=late.get))

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Q-learning with $\gamma = 0$ is the worst, far below random play. Its table says about −1 for every action,
# except beside an item or the exit. Tiny differences decide, and a greedy policy that comes back to a state in this shop
# does the same again: it goes round and round until the clock stops, while a random player gets out now and then.
#
# The same lines of code with $\gamma = 0.99$ find the optimum in most runs, and a slightly worse way in the others (78
# points with two items, for example). At first this learner is as bad as the other one. It has to meet the items and
# the exit first, by its random actions. Then their value comes back along the way, one state after the other.
# </details>

# %% [markdown]
# ## Your turn: the discount
#
# What is best depends on how much the future counts. With $\gamma = 0.95$ the best way collects all three items.
#
# **Predict.** How many items does the best way collect with $\gamma = 0.85$?

# %%
items = predict("With γ = 0.85 the best way collects ...", ["no item", "one", "two", "all three"])
items

# %%
display(loop.with_discount(gamma=0.85))
items.measured(items.options[loop.items_on(loop.best_way(0.85))])

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** One. Even on this way the exit is the 16th step, and its reward counts $0.85^{15} = 0.09$ times. A further
# item makes the way longer, so that everything after it counts still less. The shop is the same as before: the discount
# belongs to the *question*, not to the world.
# </details>

# %% [markdown]
# The map shows $v_*$ of each cell, with nothing in the bag, and the best action as an arrow. (It is slanted where two
# actions are equally good.) The orange line is the best way to the exit. After an item the bag is another one, so from there
# on the line may run against the arrows. On the right is what each reward on the way counts at the start, and their sum is
# $v_*$ of the start.
#
# *Move a slider and let it go: the cell computes everything again.* At which values of $\gamma$ does the best way change?
# What is best for $\gamma = 0$? And where does the shopper go from each cell when something is in the bag already?

# %%
sliders(
    loop.with_discount,
    gamma=[0.0, 0.5, 0.8, 0.85, 0.88, 0.89, 0.9, 0.92, 0.94, 0.95, 0.97, 0.99, 1.0],
    bag=list(loop.BAGS),
)

# %% [markdown]
# And how should an agent learn? Which settings make it slow, and which make it fail? (The title says with which totals the
# 10 runs end, without exploring.)

# %%
sliders(
    loop.one_learner,
    epsilon=(0.0, 1.0, 0.1),
    alpha=(0.1, 1.0, 0.1),
    gamma=[0.0, 0.5, 0.7, 0.85, 0.95, 0.99, 1.0],
    steps=[5_000, 10_000, 20_000, 50_000, 100_000],
)

# %% [markdown]
# Try $\gamma = 0.85$. The map says that one item is best, which makes 59 points, but the runs end with 76, 78 or 95: they
# keep to a way that they found early. Give them $\varepsilon = 1$ and 100 000 steps, so that they see everything, and they
# do what the map says. (And why does it learn with $\varepsilon = 0$ too? Exercise 2 of lesson 1 is about that.)

# %% [markdown]
# ## See inside: the table while it learns
#
# On the left is what one agent has learned with $\gamma = 0.99$, the highest $Q(s, a)$ in each cell. Cells where it has
# learned nothing are grey. On the right is $v_*$. Move the slider slowly: it is a film of learning.

# %%
sliders(
    loop.learned_beside_exact,
    steps=[0, 500, 1_000, 1_500, 2_000, 2_500, 3_000, 3_500, 4_000, 5_000, 6_000, 8_000, 10_000, 20_000],
    bag=list(loop.BAGS),
)

# %% [markdown]
# With an empty bag the colour starts beside the red item and comes back to the entrance, one cell at a time. In the end the
# value of the entrance is exactly right. For the rest of the way of this agent choose the bags "red", "red and green" and
# "all three".

# %% [markdown]
# ## Predict, then check
#
# The shop has 427 states in which an agent can act: all cells, with all bags that are possible there. After 20 000 steps
# the agent takes a good way, as you saw.
#
# **Predict.** In how many of them is its greedy action a best one?

# %%
everywhere = predict("States in which the agent's greedy action is a best one:", unit="%")
everywhere

# %%
for steps in (0, 20_000):
    agents = [loop.agent_after(steps, seed=seed) for seed in range(10)]
    share = np.mean([loop.right_choices(agent.Q, discount=0.99) for agent in agents])
    print(f"after {steps:6,} steps: a best action in {share:.0%} of the states (mean of 10 agents)")
everywhere.measured(100 * share)

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** In less than half of them. Before the first step, when all values are equal and chance decides, it was 36 %.
# Q-learning does not learn the shop, it learns *its way*. A state that it never visits keeps its first guess. Put this agent
# into another corner with another bag, and it may be lost.
# </details>

# %% [markdown]
# ## Exercises
#
# Each exercise is a cell of code with a gap. Put your code in the place of the line `raise NotImplementedError(...)`, run the cell,
# and then run the cell below it, which checks your answer. The check says more than right or wrong: what was expected, what came, and
# which mistake that looks like. Try as often as you like. Click on a hint to open it.

# %%
from edugym.exercises.loop import exercise_1, exercise_2, exercise_3
from edugym.grading import check

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
    ### END SOLUTION


# %% tags=["check"]
check(exercise_2, choose)
### BEGIN HIDDEN TESTS
check(exercise_2, choose, seed=1, quiet=True)
### END HIDDEN TESTS

# %% [markdown]
# ### Exercise 3: your own agent, in ten lines
# An agent is a class with `act` and `learn`. Write `learn`: one update of Q-learning (equation 6.8). Read
# `self.learning_rate`, which is $\alpha$, `self.discount`, which is $\gamma$, and the table `self.Q`. After *terminated* the
# target is the reward alone.
#
# Below the check your agent races the players of this lesson. You write plain Python, and it is translated into machine code,
# which takes some seconds, once. Then it runs millions of steps a second.
#
# <details><summary>Hint</summary><code>state</code>, <code>action</code>, <code>reward</code> and <code>next_state</code> are
# S, A, R and S'. <code>self.Q[state, action]</code> is one guess, and <code>max(self.Q[next_state])</code> the highest value in
# the next state. First compute the target, then move <code>self.Q[state, action]</code> towards it with
# <code>+=</code>.</details>


# %%
class MyAgent(NamedTuple):
    """Q-learning, in ten lines."""

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
        ### END SOLUTION


# %% tags=["check"] points=2
check(exercise_3, MyAgent)
### BEGIN HIDDEN TESTS
check(exercise_3, MyAgent, seed=1, quiet=True)
### END HIDDEN TESTS
display(loop.race({"my agent": lambda shop: MyAgent(np.zeros((800, 4)))}))
run = train("Supermarket", MyAgent(np.zeros((800, 4))), 3_000_000, evaluate_every=3_000_000)
print("3 million steps took less than 3 seconds:", run.seconds < 3)

# %% [markdown]
# Your agent's line should lie on that of Q-learning with $\gamma = 0.99$: it is the same agent. Now it is yours. Change its
# learning rate or the 0.1 in `act`, and race again.

# %% [markdown]
# ## What you saw
#
# - Agent and environment talk in a loop: state, action, reward, next state. An episode ends *terminated*, with no future, or
#   *truncated*, with one.
# - The reward is what comes next. The return is what comes in all. Acting for the next reward brought −248 points (random
#   play −313, the best policy 95), and learning the next reward alone was even worse than random play.
# - The discount decides what is best: one item, two or three in the same shop.
# - Q-learning found the way without knowing the rules. Where it did not go, it knew nothing.
#
# ### In one paragraph
# *Learn it by heart, or better, say it in your own words.* An agent wants a high return, the discounted sum of all rewards
# from now on: $G_t = R_{t+1} + \gamma G_{t+1}$. A reward alone does not tell whether an action was good, so the agent
# learns values, the returns that it can expect. Q-learning makes the equation of the return into an update: it moves its
# guess for an action towards the reward plus the discounted best guess for the next state, where there is one. Then the
# value of what is far away comes back, one state at a time.
#
# ### What comes next
# The shop was easy in many ways. Each of the next lessons takes one of them away. The cell below shows their environments.
#
# | lesson | environment | what was easy here | what is hard there |
# |---|---|---|---|
# | 1 | Boulder | random steps find an item soon | the only reward is far away: how to *explore*? |
# | 2 | Roadrunner | a random step costs a point | a random step may be deadly: learn the best way, or the safe one? |
# | 3 | Study | there was time for values to come back step by step | the exam comes long after the lecture: *how far back* to look? |
# | 4 | Catch | a table has a row for every state | the state is a picture: too many for a table |
# | 5 | MemoryCorridor | the agent saw the whole state | it sees a part, and must *remember* |
# | 6 | Tamagotchi | what it saw was true | it is told little, and not always the truth |
# | 7 | Trashbot | four actions | actions are numbers, as fine as you like |
# | 8 | Golf | every action did what it should | the ball goes where it wants: is the mean all that counts? |
# | 9 | Supermarket | steps were free | steps are dear: build a model, and *think* before you act |
# | 10 | your own | somebody had written the environment | you write it: states, actions, and a reward that says what you mean |

# %%
loop.nine_challenges()

# %% [markdown]
# ### Limits
# In this shop nothing happens by chance; elsewhere $q_*$ needs a mean over all that can happen (equation 3.20 in full). There
# are only 428 states, so a table can hold a value for every action in each of them. And the best way is known here, so
# that you could see how good the agent is. Mostly nobody knows it.
#
# ### Further reading
# - Sutton and Barto, *Reinforcement Learning*, 2nd edition: 3.1–3.6 (agent, return, values), 6.5 (Q-learning); 1.1–1.5 for
#   the whole story.
# - Watkins and Dayan (1992), *Q-learning*: where the update comes from, and why it converges.
# - Moerland et al. (2023), *EduGym: An environment and notebook suite for reinforcement learning education*: the paper
#   behind the nine environments.
# - [Gymnasium](https://gymnasium.farama.org): the loop that all these environments share.
