# %% [markdown]
# # Goals: Switches
#
# **The challenge.** An agent is told a goal, another one in each episode, and is rewarded only when it gets there. With
# many goals it hardly ever does. Has it nothing to learn from then?
#
# **You will be able to** write the values of an agent with many goals, and say what a network gains over a table there;
# learn from an episode that missed its goal, by hindsight; and say why hindsight neither explores nor changes the task.
#
# **Time.** {time} **Before you start.** You should know Q-learning (Sutton and Barto,
# 2nd edition, section 6.5) and, for the experiments, what DQN does with its memory: lesson 4, or section 16.5. All
# symbols are in the [table of notation](https://github.com/RLG-Leiden/edugym/blob/main/docs/notation.md).

# %%
import gymnasium as gym
import numpy as np

from edugym import (
    EpsilonGreedy,
    FinalGoal,
    FutureGoals,
    HindsightDQN,
    HindsightQLearning,
    NoHindsight,
    make_mdp,
    repeat,
)
from edugym_course.lessons.goals import figures, methods
from edugym_course.notebook import frames, play, predict, sliders, source

# %% [markdown]
# ## Meet the environment: a panel of switches
#
# There are $n$ switches, each on or off. The cards above them show how they should be: the *goal* $g$. It is another one in
# each episode, and so is the start.

# %%
env = gym.make("edugym/Switches-v0", n_switches=8).unwrapped
env.reset(seed=2)
env.scene()

# %% [markdown]
# | | | in words |
# |---|---|---|
# | states | $s$, and the goal $g$ | two patterns of $n$ switches; the agent sees both |
# | actions | $\mathcal{A} = \{0, \dots, n - 1\}$ | the switch to flip |
# | dynamics | one switch of $s$ changes | nothing is random, and $g$ has no part in it |
# | reward | $r(s', g) = 0$ if $s' = g$, else $-1$ | only the goal itself counts, however close the agent came |
# | discount | $\gamma = 0.99$ | used by the agents; returns in the figures are not discounted |
#
# An episode *terminates* at the goal. After $n$ steps it is *truncated*. If $d$ switches are wrong (the *distance* of $s$
# from $g$), the best return is $-(d - 1)$, and with the discount $-(1 + \gamma + \dots + \gamma^{d-2})$. So we know
# exactly what is best, and can look how far an agent is from it.
#
# In the code a pattern is a whole number, with a binary digit for each switch: 0110 is 6. `s ^ m` turns over the digits of s where m has a 1.

# %%
source(type(env.mdp), "transition", "reward", "terminal")

# %% [markdown]
# **Play it yourself.** For you it is easy: you compare the cards with the switches. An agent sees 16 digits (a network sees each as two numbers: 1 0 or 0 1), and nobody has
# told it which digit of the goal belongs to which switch.

# %%
play("Switches", n_switches=8)

# %% [markdown]
# How often does an agent that flips at random get to its goal? Computed exactly:

# %%
for n in (2, 4, 6, 8, 10, 13):
    chance = methods.chance_of_random_play(n)
    print(f"{n:2} switches, {2**n:4} patterns: {chance:7.2%} of the episodes, one in {1 / chance:.0f}")

# %% [markdown]
# In $n$ steps it meets at most $n$ of the other $2^n - 1$ patterns, so the chance is below $n / (2^n - 1)$. In all other
# episodes every reward is $-1$, whatever it does.

# %% [markdown]
# ## The idea: learn for the goal that was reached
#
# ### One value for each goal
# What is best in a state depends on the goal. So the value gets one more argument: $Q(s, g, a)$ is the return that we
# expect if we take action $a$ in state $s$, and $g$ is the goal. This is a *universal* value (Schaul et al., 2015; in a table
# Kaelbling, 1993). Q-learning stays as it is, with the same $g$ on both sides:
#
# $$
# Q(S, g, A) \leftarrow Q(S, g, A) + \alpha \left[ R + \gamma \max_a Q(S', g, a) - Q(S, g, A) \right]
# $$
#
# ### An episode, seen again
# Three switches are off, 000, and should be on: $g = 111$. (Switch 0 is the first digit.) The agent flips switch 0, switch 1, and switch 0 again. It
# has reached 010, and missed its goal. But *if* the goal had been 010, the same steps would have been a success:
#
# | step | $s$ | $a$ | $s'$ | $r(s', g)$ for $g = 111$ | $r(s', g')$ for $g' = 010$ | terminated for $g'$ |
# |---|---|---|---|---|---|---|
# | 0 | 000 | 0 | 100 | $-1$ | $-1$ | no |
# | 1 | 100 | 1 | 110 | $-1$ | $-1$ | no |
# | 2 | 110 | 0 | 010 | $-1$ | $0$ | yes |
#
# This is *hindsight* (Andrychowicz et al., 2017): when the episode is over, learn its steps again for a goal $g'$ that it
# did reach. (Go-Explore in lesson 1 does so for every state on its path.) Two things must be true of the task. The goal
# has no part in the dynamics, so that the steps would have been the same. And we know $r(s', g')$ for any goal, so that we
# can ask for the rewards. The task stays the same; we only ask it about another goal. And Q-learning is off-policy (lesson 2), so it
# may learn from steps that were meant for another goal.
#
# Which goals $g'$? Two strategies are usual. 'final' takes what the last step achieved. 'future' draws, for each step and $k$
# times, one of the steps from there on, and takes what it achieved. (In the code both return the number of that step; `draw` is
# a random number from 0 to below 1.)

# %%
source(FinalGoal.achieved_after)

# %%
source(FutureGoals.achieved_after)

# %%
source(HindsightQLearning, "learn_in_hindsight", "update")

# %% [markdown]
# (A row of its table is a pair of a state and a goal, S‖G in the code. `reward_at_goal` is 0, and `reward_elsewhere` is $-1$.) Here it
# learns from the episode above, with 'final' and $\alpha = 1$, the last step first. (The number of a row is 8 times the pattern, plus the goal.) All values were $-9$ before, so that you see which have changed.

# %%
agent = HindsightQLearning.create(
    make_mdp("Switches", n_switches=3), learning_rate=1.0, hindsight=FinalGoal(), initial_value=-9.0
)
goal, patterns = 0b111, [0b000, 0b100, 0b110, 0b010]
for t, action in enumerate((0, 1, 0)):
    agent.learn(8 * patterns[t] + goal, action, -1.0, 8 * patterns[t + 1] + goal, terminated=False, truncated=t == 2)
for row, action in np.argwhere(agent.Q != -9.0):
    print(f"Q({row // 8:03b}, {row % 8:03b}, {action}) = {agent.Q[row, action]:.2f}")

# %% [markdown]
# For the goal 111 it has learned three numbers below $-9$: it did not get there, and knows no more. For the goal 010 it
# knows the way: 0 for the last flip, $-1$ for the one before, $-1.99$ for the first. (It may not be the best
# way. A single flip leads from 000 to 010.)
#
# ### The same for a network
# A table learns each pair of a state and a goal alone. A network that sees both patterns has one set of weights for all
# pairs. `HindsightDQN` is the DQN of lesson 4; its memory gets each transition again, with other goals.
#
# Other libraries do it in the same way. They ask a *goal environment* for its rewards, by a convention of
# Gymnasium-Robotics: an observation is a dictionary with what is achieved and what is desired, and `compute_reward` takes
# any achieved and any desired goal.

# %%
seen, _ = env.reset(seed=2)
print({name: part.tolist() for name, part in seen.items()})
print("reward for its goal:", env.compute_reward(seen["achieved_goal"], seen["desired_goal"], {}))
print("and if the goal were what is there:", env.compute_reward(seen["achieved_goal"], seen["achieved_goal"], {}))

# %% [markdown]
# ## The experiment: eight switches
#
# | setting | value |
# |---|---|
# | all | DQN with its defaults: 64 hidden units, Adam with learning rate 0.001, $\gamma = 0.99$, $\varepsilon = 0.1$, a memory of the last 10 000 transitions |
# | hindsight | none, 'final', or 'future' with $k = 4$ |
# | training | 15 000 steps |
# | evaluation | 100 greedy episodes every 1 500 steps, each with another goal |
# | repetitions | 5; bands are 95 % intervals |
#
# The dashed line is the best expected return, $-3.02$: start and goal are drawn at random, and are never equal, so 4.02 switches are wrong on average at first. The lowest return is
# $-8$.
#
# **Predict.** Which of them learn to reach their goals?

# %%
who = predict(
    "After 15 000 steps, close to the best return are ...",
    ["none of the three", "'future' only", "'final' and 'future'", "all three"],
)
who

# %%
task = make_mdp("Switches", n_switches=8)
agents = {
    "no hindsight": lambda task: HindsightDQN.create(task, hindsight=NoHindsight()),
    "future": lambda task: HindsightDQN.create(task, hindsight=FutureGoals(4)),
    "final": lambda task: HindsightDQN.create(task, hindsight=FinalGoal()),
}
eight = repeat(task, agents, n_steps=15_000, repetitions=5, evaluate_every=1_500, evaluation_episodes=100)
display(figures.learning_curves({"8 switches": (8, eight)}))
ends = {method: eight.final(method).mean() for method in eight.methods}
print("at the end:", ", ".join(f"{method} {mean:.2f}" for method, mean in ends.items()))
close = tuple(method for method, mean in ends.items() if mean > methods.best_return(8) - 0.5)
names = {(): "none of the three", ("future",): "'future' only", ("future", "final"): "'final' and 'future'"}
who.measured(names.get(close, "all three"))

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** 'final' and 'future', and 'future' gets there first. Without hindsight the network has learned nothing at
# all, not even in 200 000 steps (it returned −7.97; in the paper, with other settings, plain DQN managed up to 13 switches). (The end may lie a little above the dashed
# line, if 100 episodes happen to have somewhat nearer goals.)
# </details>

# %% [markdown]
# Watch one greedy episode of the network with 'future'.

# %%
frames(task, methods.greedily(task, eight.agents["future"][0]), seed=2)

# %% [markdown]
# ## Your turn
#
# With how many switches does a network still learn without hindsight? (3 runs of 10 000 steps.)


# %%
def one_network(n_switches=5, hindsight="no hindsight", epsilon=0.1):
    """Draw the learning curves of three networks."""
    return figures.one_setting(n_switches, hindsight, exploration=EpsilonGreedy(epsilon))


sliders(one_network, n_switches=(2, 9), hindsight=["no hindsight", "final", "future"], epsilon=(0.0, 1.0, 0.1))

# %% [markdown]
# <details><summary>What came out</summary>
#
# In 10 000 steps and without hindsight four switches were learned, five hardly, and six not at all.
# </details>

# %% [markdown]
# ## See inside: where are the rewards?
#
# DQN learns from what is in its memory. Here is the memory after 1 000 steps of networks that have not learned yet ($\varepsilon = 0.1$). How many
# of its transitions reach their goal?

# %%
for strategy in ("no hindsight", "final", "future"):
    share = np.mean([methods.rewarded_share(strategy, seed=seed) for seed in range(10)])
    print(f"{strategy:12}: {share:.1%} of the transitions reach their goal")

# %% [markdown]
# Now ask the networks what they believe: the value of the best action,
# by how many switches are wrong. The dashed line is true.

# %%
display(figures.beliefs(eight, ("no hindsight", "future")))
longer = methods.networks(strategies=("future",), n_steps=60_000, repetitions=1)
print(f"distance 8: the true value is {methods.true_value(8):.1f}")
for steps, results in ((15_000, eight), (60_000, longer)):
    value, far = methods.values_by_distance(results, "future")[-1].mean(), methods.far_shares(results, "future").mean()
    print(f"{steps} steps: {value:.1f}; in {far:.1%} of its transitions the goal is 6 flips away or more")

# %% [markdown]
# Without hindsight all is the same to the network, one flip from the goal or eight. (Its values lie below $-8$, the cost of a
# whole episode. At a truncation the agent bootstraps, as it should, as if it could go on flipping.) With 'future' the
# network has learned a distance. It knows near goals best, and takes far ones for nearer than they are. Four times
# as many steps later the value at distance 8 is nearly right (one network), so it had not learned for long enough. Our
# guess why it takes so long: far goals are rare in its memory.

# %% [markdown]
# ## Predict, then check
#
# ### Is hindsight a way to explore?
# Two agents that do not even try: with $\varepsilon = 1$ they flip at random from the first step to the last, one with
# 'future' and one without hindsight. So both hardly ever reach their goal while they learn, one time in 37.
#
# **Predict.** In the end they act greedily. What can the one with 'future' do?

# %%
at_random = predict(
    "Having flipped at random only, it returns ...",
    ["about −8: it has learned nothing", "about −5: it has learned half of it", "about −3: as much as with ε = 0.1"],
)
at_random

# %%
blind = methods.at_random()
display(figures.learning_curves({"random flips": (8, blind)}))
for method in blind.methods:
    earned = blind.average(method, "training_return").mean()
    print(f"{method}: while it learns {earned:.2f}, greedy in the end {blind.final(method).mean():.2f}")
end = blind.final("future, ε = 1").mean()
at_random.measured(at_random.options[0 if end < -6.5 else 1 if end < -4.0 else 2])

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** About −3, as much as with ε = 0.1. While it learned it reached its goals no more often than random play. So
# hindsight did not help by exploring: all flips were random. It makes more of the same flips, of which the other
# agent made nothing. And there *is* something to learn from a goal that was missed: from each episode it
# learns how to reach the patterns that it *did* reach.
# </details>

# %% [markdown]
# ### Is it only more data?
# With 'future' five times as many transitions go into the memory (the network makes hardly more updates). Perhaps their number helps, and not their goals? Take as $g'$ a
# pattern that one of the last episodes achieved, but not *this* one. As many transitions go into the memory as with 'future', with honest rewards, and
# only the goals are others. (In the code a step before the episode has a negative number.)

# %%
source(methods.OtherEpisodes.achieved_after)

# %% [markdown]
# **Predict.** What does the network learn with such goals?

# %%
elsewhere = predict("With goals of other episodes it learns ...", ["as fast", "more slowly", "nothing"])
elsewhere

# %%
control = methods.networks(8, ("goals of other episodes",))
display(figures.learning_curves({"goals of other episodes": (8, control)}))
end = control.final("goals of other episodes").mean()
share = methods.rewarded_share("goals of other episodes")
print(f"at the end {end:.2f}; {share:.1%} of the first transitions reach their goal")
elsewhere.measured("nothing" if end < -7.5 else "more slowly" if end < -3.5 else "as fast")

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Nothing. A goal from elsewhere is nearly always missed, too. Our guess: what helps are
# goals that were *achieved*, since more transitions reach them. With seven and with nine switches it learned next
# to nothing, either.
# </details>

# %% [markdown]
# ### And a table?
# Now a table with 'future', and $\alpha = 1$, since nothing is random. With four switches a table
# learns all in 15 000 steps, with hindsight or without. With eight there are $4^8 = 65\,536$ pairs of a state and a goal,
# and eight actions in each. All values start at 0.
#
# **Predict.** What does the table with 'future' return after 15 000 steps with eight switches?

# %%
tabular = predict("The table with 'future' returns ...", unit="(from −8 to −3.02)")
tabular

# %%
four, both, low = methods.tables(4), methods.tables(8), methods.tables(8, first_value=-8.0)
by_title = {"table, 4 switches": (4, four), "table, 8 switches": (8, both), "8 switches, values start at −8": (8, low)}
display(figures.learning_curves(by_title))
print("all values in the table with eight switches:", *np.unique(both.agents["future"][0].Q).round(2))
print(f"with first values of −8 it returns {low.final('future').mean():.1f} with 'future'")
tabular.measured(both.final("future").mean())

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** About −7.9, as if it had learned nothing. Every reward is 0 or $-1$, so no value can be higher than the
# first ones, 0. For each goal a flip that was never tried is worth 0, so the maximum at the next pattern stays 0 while such a flip is left there. A flip that misses the goal is therefore
# worth $-1$, however far the goal is, and the last flip is worth 0, like one that was never tried. So the greedy policy prefers what was never tried. (This is the optimism of lesson 1.) On the right the values start at
# $-8$: this table returns about −5.2 with 'future', and about −7.8 without hindsight.
#
# It is still far behind the network. It makes at most 75 000 updates for its 524 288 numbers, and each tells of one pair
# alone. (Seven switches have a quarter of the pairs; there, with 'future' and first values of −7, a table came to −3.3, and the best is −2.5.) Our reading: the network has
# *generalised*, over states and over goals.
# </details>

# %% [markdown]
# ## Exercises
#
# Each exercise has a cell for your answer, and below it a cell that checks it: it says what was expected, what came, and
# which mistake that looks like. Patterns are numbers here, as 6 for 110.

# %%
from edugym_course.grading import check
from edugym_course.lessons.goals.exercises import exercise_1, exercise_2, exercise_3

# %% [markdown]
# ### Exercise 1: the greedy action for a goal
# `Q` is an array of universal values, `Q[state, goal, action]`. Return the action with the highest value for a state and a goal.
#
# <details><summary>Hint</summary><code>Q[state, goal]</code> is a row with a number for each action.</details>


# %%
def greedy(Q, state, goal):
    """Return the action with the highest value in a state, for a goal."""
    ### BEGIN SOLUTION
    return int(np.argmax(Q[state, goal]))
    # own: return int(np.argmax(Q[state, goal] - {dear} * (np.arange(Q.shape[2]) == 0)))
    ### END SOLUTION


# %% tags=["check"]
check(exercise_1, greedy)
### BEGIN HIDDEN TESTS
check(exercise_1, greedy, seed=1, quiet=True)
### END HIDDEN TESTS

# %% [markdown]
# ### Exercise 2: 'final'
# `steps` is an episode that is over, a list of `(state, action, next_state)`. Return its transitions for the goal that its
# last step achieved: a list of `(state, goal, action, reward, next_state, terminated)`, in the same order. Rewards are those
# of Switches. Mind that an episode may reach a pattern more than once.
#
# <details><summary>Hint</summary>The last step is <code>steps[-1]</code>. For each step the reward and
# <code>terminated</code> follow from one question: is its next state the goal?</details>


# %%
def final(steps):
    """Return the transitions of an episode, as if what it achieved last had been its goal."""
    ### BEGIN SOLUTION
    goal = steps[-1][2]
    transitions = []
    for state, action, next_state in steps:
        reached = next_state == goal
        transitions.append((state, goal, action, 0.0 if reached else -1.0, next_state, reached))
        # own: transitions.append((state, goal, action, 0.0 if reached else -{cost}, next_state, reached))
    return transitions
    ### END SOLUTION


# %% tags=["check"] points=2
check(exercise_2, final)
### BEGIN HIDDEN TESTS
check(exercise_2, final, seed=1, quiet=True)
### END HIDDEN TESTS

# %% [markdown]
# ### Exercise 3: 'future'
# Return a goal for the step number `t` of such an episode: what a random step from `t` on achieved, `t` itself included, each
# step as likely. Draw from `rng`, a generator of NumPy.
#
# <details><summary>Hint</summary><code>rng.integers(low, high)</code> draws a whole number from low to high − 1.</details>


# %%
def future_goal(steps, t, rng):
    """Return a pattern that the episode achieved in step t or later."""
    ### BEGIN SOLUTION
    _, _, achieved = steps[rng.integers(t, len(steps))]
    # own: _, _, achieved = steps[rng.integers(min(t + {gap}, len(steps) - 1), len(steps))]
    return achieved
    ### END SOLUTION


# %% tags=["check"] points=2
check(exercise_3, future_goal)
### BEGIN HIDDEN TESTS
check(exercise_3, future_goal, seed=1, quiet=True)
### END HIDDEN TESTS

# %% [markdown]
# ### From a blank file
# Now write it all yourself, from an empty cell, with NumPy and Gymnasium only: a table of universal values with the
# hindsight 'final', and its loop, some 40 lines. `reset` and `step` give dictionaries here. Under `"achieved_goal"` is the
# pattern $S$ of the switches, an array of 0 and 1, and under `"desired_goal"` is $G$. As a table take a dictionary with the
# key `(tuple(S), tuple(G))`, say.
#
# **What it must do.** `my_program(environment, n_steps, seed)` takes `n_steps` steps, episode after episode. It learns each
# step at once, for the goal of the episode:
#
# $$
# Q(S, G, A) \leftarrow Q(S, G, A) + \alpha \left[ R + \gamma \max_a Q(S', G, a) - Q(S, G, A) \right]
# $$
#
# Where `terminated` is True, the target is $R$ alone. When an episode is over, whether it reached its goal or not, it
# learns all steps of it again, for the goal $G'$ that the last step achieved (also if $G' = G$). **The last step comes
# first**, so that the value of the goal reaches the first step in the same sweep. Each step that achieves $G'$ has the target 0 alone, wherever it stands in the episode; every other one has
# the target $-1 + \gamma \max_a Q(S', G', a)$. (The episode that is cut off by `n_steps` need not be learned again.) In the end the program returns its *policy*:
# a function that takes such a dictionary, and returns the action with the highest value; it is asked about pairs that were
# never met, too.
#
# - Take $\alpha = 0.5$, $\gamma = 0.9$, $\varepsilon = 0.1$ and first values of $-10$. This is $-1 / (1 - \gamma)$, what it is
#   worth never to reach the goal. At first all values are equal, so break ties at random while it learns.
# - `environment.action_space.n` says how many switches there are.
# - Draw all random numbers from `np.random.default_rng(seed)`, and give the seed to the first `reset` alone.
#
# The check runs your program with four switches, and for 20 000 steps with six: a good program comes to about −2.6 there (the best is −2.05), and one without
# hindsight stays below −4. The check takes a minute or two. It sees the steps that your program takes, and no line of it. So the mistake that it names is only the
# likely one.

# %% tags=["project"]
my_program = ...  # your program
### BEGIN PROGRAM


def choose_action(values, epsilon, rng):
    """Return an action by ε-greedy, ties broken at random."""
    if rng.random() < epsilon:
        return int(rng.integers(len(values)))
    return int(rng.choice(np.flatnonzero(values == values.max())))


def my_program(environment, n_steps, seed):
    """Learn by Q-learning with the hindsight 'final' for `n_steps` steps, and return the greedy policy."""
    alpha, gamma, epsilon = 0.5, 0.9, 0.1
    rng = np.random.default_rng(seed)
    Q = {}

    def row(pattern, goal):
        """Return the values of a pattern for a goal, −10 where they are new."""
        return Q.setdefault((pattern, goal), np.full(environment.action_space.n, -10.0))

    def learn(pattern, action, next_pattern, goal):
        """Learn a step for a goal: its own, or another one."""
        reached = next_pattern == goal
        target = 0.0 if reached else -1.0 + gamma * row(next_pattern, goal).max()
        row(pattern, goal)[action] += alpha * (target - row(pattern, goal)[action])

    seen, _ = environment.reset(seed=seed)
    steps = []
    for _ in range(n_steps):
        pattern, goal = tuple(seen["achieved_goal"]), tuple(seen["desired_goal"])
        action = choose_action(row(pattern, goal), epsilon, rng)
        seen, _, terminated, truncated, _ = environment.step(action)
        steps.append((pattern, action, tuple(seen["achieved_goal"])))
        learn(*steps[-1], goal)
        if terminated or truncated:
            achieved = steps[-1][2]
            for step in reversed(steps):
                learn(*step, achieved)
            seen, _ = environment.reset()
            steps = []
    return lambda seen: int(row(tuple(seen["achieved_goal"]), tuple(seen["desired_goal"])).argmax())


### END PROGRAM

# %% tags=["project"]
from edugym_course.lessons.goals.project import project_11

check(project_11, my_program)

# %% [markdown]
# ## What you saw
#
# - With eight switches random play reaches its goal in one of 37 episodes, and a network without hindsight learned nothing.
# - With hindsight, 'final' or 'future', it came to the best return. With 'future' it did so even when all its flips were
#   random.
# - With goals that the same episode had *not* achieved the effect was gone, in the time that 'future' takes.
# - With eight switches a table whose values start at 0 gained nothing: what it had never tried looked at least as good as all that it had found. From −8 it gained about
#   2.5, and the network about 5. A table learns each pair of a state and a goal by itself.
#
# ### In one paragraph
# *Learn it by heart, or better, say it in your own words.* A universal value Q(s, g, a) says what an action is worth for a goal.
# An episode that misses its goal still reaches others, and hindsight learns its steps again for these, with the rewards that
# the task would have paid. This changes neither the task nor the steps it learns from: more transitions reach their goal.
# A network then generalises over states and goals (our reading); a table learns each pair by itself.
#
# ### Limits
# Goals must have no part in the dynamics, the reward for any goal must be known, and the method must be off-policy. Hindsight
# finds nothing that the agent never does: where random play stays near its start, as on the wall of lesson 1, so do the
# goals that it learns. And what it adds for a goal comes only from episodes that reached it: in a random
# task it overrates actions that were lucky. (None of this was measured here.)
#
# ### Further reading
# - Andrychowicz et al. (2017), *Hindsight experience replay*: the method, and the task of this lesson (section 3.1). They
#   also try goals from the whole training, 'random'.
# - Schaul, Horgan, Gregor and Silver (2015), *Universal value function approximators*.
# - Kaelbling (1993), *Learning to achieve goals*: a table over states and goals, learned for all goals at once.
# - Sutton and Barto, *Reinforcement Learning*, 2nd edition: 5.5 and 6.5 (learning off-policy), 16.5 (DQN), 17.1 (many questions
#   at once: general value functions).
