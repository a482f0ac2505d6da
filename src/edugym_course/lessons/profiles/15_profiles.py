# %% [markdown]
# # Profiles: what is my agent good at?
#
# **The challenge.** Each lesson asked which agent is good at one problem. Now turn the question round: here is an agent; at which
# problems is it good, how hard may they become, and could you have known it from its equation?
#
# **You will be able to** read a profile and say where an agent breaks; predict from an equation on which ladders an agent
# climbs high; and build an agent whose profile has a given hole.
#
# **Time.** {time} **Before you start.** You should know Q-learning (lesson 1; Sutton and Barto, 2nd edition, section 6.5) and
# planning with a learned model (lesson 9; section 8.2). It is a good last lesson. All symbols are in the
# [table of notation](https://github.com/RLG-Leiden/edugym/blob/main/docs/notation.md).

# %%
import gymnasium as gym
import numpy as np

from edugym import QLearning, RMax
from edugym.experiments.profiles.ladders import LADDERS
from edugym.experiments.profiles.profile import profile
from edugym_course.lessons.profiles import figures, methods
from edugym_course.notebook import play, predict, sliders, source

# %% [markdown]
# ## Meet the environment: ten ladders
#
# Ten environments of this course each isolate one challenge, with a parameter that is its strength. So each is a *ladder* of tasks. Each
# rung is a task of its own: the same challenge, a little stronger. (In the supermarket the task stays, and the steps of its training get fewer.)

# %%
for ladder in LADDERS:
    first, last = ladder.strengths[0], ladder.strengths[-1]
    print(f"{ladder.name:14} {ladder.strength} from {first:g} to {last:g}: {ladder.challenge}")

# %% [markdown]
# Take Boulder. On the first rung of its ladder the wall has 8 levels, and on the last it has 100. This is the first:

# %%
boulder = LADDERS[0]
gym.make("edugym/Boulder-v0", height=boulder.strengths[0]).unwrapped.scene()

# %% [markdown]
# Climb the first rung yourself, a wall with other grips, seeing only what an agent sees. At each height one of the two grips holds, the same one in every episode, and a wrong grip takes you back to the ground.
# How many wrong grips do you take until you reach the top for the first time? Then think of 100 levels. (Who remembers what failed takes one wrong grip a level, at most; who does not would need some $2^{100}$ climbs.)

# %%
play("Boulder", height=boulder.strengths[0], layout_seed=1, blind=True)

# %% [markdown]
# On each rung an agent trains for a fixed number of steps, from the beginning: what it has learned on one rung is forgotten on the next. Then it
# plays 10 to 100 episodes without exploring. All agents get the same number of steps on a rung, and nothing is tuned.

# %% [markdown]
# ## The idea: one scale for all rewards
#
# A return of −40 may be good in one task and bad in another. So a return $G$ is measured between that of random play and that of the
# best play (from the exact model, or else the best that is known):
#
# $$
# x = \frac{G - G_\text{random}}{G_\text{best} - G_\text{random}}
# $$
#
# 0 is random play and 1 the best play; below 0 is worse than random play, and by chance a mean of some episodes may be above 1. The *score* in a challenge is the mean of $x$ over the rungs. The agent
# *breaks* where the mean of $x$ over its runs first falls below 0.5, interpolated between two rungs.
#
# Here Q-learning climbs Study. There an exam comes after 5, 10, 20, 40, 80 or 160 days. Two of the five actions do nothing. To pass, study on the one day of a lecture, sleep once (going out would undo it), and study on
# the last day. Nothing but the exam has a reward.

# %%
study = profile({"Q-learning": QLearning.create}, challenges=["Study"], repetitions=5)
for days, rung in zip(study.ladder("Study").strengths, study.rungs("Q-learning", "Study"), strict=True):
    print(f"{days:3} days: {rung.estimate:.2f}")
print(f"score {study.score('Q-learning', 'Study').estimate:.2f}")
print(f"breaks at {study.breaks('Q-learning', 'Study').strength:.0f} days")

# %% [markdown]
# Read the rungs before the score. Where it breaks is not known to the day: with other random numbers five runs broke at some 40 to 90 days. Two agents with the same score may fail at different strengths.

# %% [markdown]
# ## The experiment: read a profile from an equation
#
# R-max plans with a model of what it has seen. A pair of a state and an action that it has not tried yet gets a high value
# $U$, so it goes and tries it, if it knows a way:
#
# $$
# Q^+(s, a) = \begin{cases}
# \sum_{s'} \hat p(s' \mid s, a) \left[ \hat r(s, a, s') + \gamma \max_{a'} Q^+(s', a') \right] & \text{if } (s, a) \text{ is known} \\
# U & \text{otherwise}
# \end{cases}
# $$
#
# A pair is known after $m$ tries. The estimates $\hat p$ and $\hat r$ of its probabilities and rewards come from these $m$ tries and never change again. In the code
# $Q^+$ is `optimistic`, $m$ is `known_after` (1 by default), and $U$ is `highest_return` (100). (`given` says whether an exact model was handed in: not here. `becomes_known` adds the pair to those that it plans with.)
# By $Q^+$ it acts while it learns. It is scored by a second table, `Q`, with the same equation, in which $-100$ stands in the place of $U$: what is not known is not trusted.

# %%
source(RMax, "learn", "act", "greedy")

# %% [markdown]
# | setting | value |
# |---|---|
# | agents | Q-learning ($\alpha = 0.1$, $\gamma = 0.99$, $\varepsilon = 0.1$) and R-max ($m = 1$, $U = 100$, $\gamma = 0.99$), their defaults |
# | Boulder and Study | 20 000 steps on each rung; each action has one outcome |
# | Golf | 30 000 steps on each rung; on the first rung every hit meets its aim, and from rung to rung it misses by more (a player hits the ball onto the green in as few hits as possible; a hard hit misses by more than a soft one, and a ball that leaves the course is lost) |
# | repetitions | 5, with other random numbers; both agents meet the same five |
#
# First Boulder and Study, where R-max needs to see everything only once:

# %%
certain = methods.climb(["Q-learning", "R-max"], ["Boulder", "Study"])
for agent in certain.agents:
    print(agent, *(f"{name} {certain.score(agent, name).estimate:.2f}" for name in certain.challenges))
figures.ladders(certain)

# %% [markdown]
# (A band is a 95 % confidence interval, and below the dashed line an agent breaks.) R-max scores 1 on every rung of both. Now Golf, in which Q-learning scores about 0.7.
#
# **Predict.** Look at the equation. How does R-max do in Golf?

# %%
in_golf = predict("In Golf the score of R-max is ...", ["higher than that of Q-learning", "the same", "lower"])
in_golf

# %%
golf = methods.climb(["Q-learning", "R-max"], ["Golf"])
display(figures.ladders(golf))
for agent in golf.agents:
    print(f"{agent}: {golf.score(agent, 'Golf').estimate:.2f}, breaks at {golf.breaks(agent, 'Golf').strength:.2g}")
less = methods.gap(golf, "R-max", "Q-learning", "Golf")
in_golf.measured("lower" if less.high < 0 else "the same" if less.low < 0 else "higher than that of Q-learning")

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Lower: 0.62 against 0.73. It scores 1 where no hit misses its aim, and loses most at a noise of 0.03 (near it, it first falls below 0.5, and so it breaks). From 0.1 on these five runs do not tell the two apart. The score alone would not have told you that: look at the rungs.
# </details>

# %% [markdown]
# ## Your turn
#
# Two ladders of Q-learning, Study and Tamagotchi, with three runs on each rung. Which settings move one ladder and leave the other as it is?
# (In Tamagotchi a pet tells by a message, noisy on the higher rungs, which action it wants. Each wrong one makes it less happy, and an unhappy pet loses hit points. Every step has its reward, and an agent has 50 000 steps.
# Try the ends of the sliders, too. Where the three runs differ much, a band may be taller than the frame.)

# %%
figures.one_setting()

# %%
sliders(figures.one_setting, learning_rate=(0.05, 1.0, 0.05), discount=(0.0, 0.99, 0.11), epsilon=(0.0, 1.0, 0.1))

# %% [markdown]
# <details><summary>What came out</summary>
#
# - *The learning rate and* $\varepsilon$ hardly moved Study anywhere on their sliders: its scores were 0.59 to 0.73. Tamagotchi fell from 0.69 to 0.07 without exploration. With a learning rate of 1 it fell to 0.10 here, and to about 0.3 on average in other runs. With both at once it scored 0.65: two settings that are bad alone need not be so together.
# - *One setting* left Tamagotchi nearly as it was, and not Study. You will find it in exercise 2: only the very end of its slider does it.
# </details>

# %% [markdown]
# ## See inside: why is R-max low in Golf?
#
# Read the equation: one try shows one of many things that may happen, and R-max believes that it is the only one. Is that
# the reason? Take the cause away and look. With $m = 10$ a pair is known after ten tries, so $\hat p$ has seen some of the misses.

# %%
tries = methods.climb(["R-max", "R-max, 10 tries"], ["Golf"])
for agent in tries.agents:
    print(agent, *(f"{rung.estimate:.2f}" for rung in tries.rungs(agent, "Golf")))
figures.ladders(tries)

# %% [markdown]
# With ten tries it climbs higher on the rungs in the middle, and its score over the ladder is higher. On the first rung, where no hit misses, both score 1: without the
# noise one try is enough. So the reason passes two tests. They are weak ones: without noise Q-learning scores 1 too, and ten tries also change how R-max explores.
#
# (On the noisiest rung ten tries score less: what is seldom tried keeps its −100, and is feared too much. With −1 in its place the score is that of one try again, in 80 runs.)
#
# **Two causes at once.** In Tamagotchi R-max scores about 0 on every rung, even where messages have no noise. There, too, one try shows one of many outcomes, since the agent sees
# hit points and a message, and not the state. And $U = 100$ is not high there: the best play gets 6 707. This is the score where messages have no noise:
#
# | | $U = 100$ | $U = 8000$ |
# |---|---|---|
# | $m = 1$ | 0.02 | 0.12 (100 runs: 7 of them score 1, and half of them less than 0.03) |
# | $m = 10$ | 0.2 (20 runs) | nearly 1 |
#
# It does not help much to take away only one of the causes.

# %% [markdown]
# ## Predict, then check
#
# Give Q-learning a learning rate of 0.000001. After 20 000 steps its values have hardly moved from 0.
#
# **Predict.** Its score in Study, where the default has about 0.7, is now ...

# %%
slow = predict(
    "With α = 0.000001 the score in Study ...", ["falls to about 0", "falls by half", "stays about the same"]
)
slow

# %%
holes = methods.climb(["Q-learning", "α = 0.000001"], ["Study", "Tamagotchi"])
display(figures.scores(holes))
gaps = {name: methods.gap(holes, "α = 0.000001", "Q-learning", name) for name in holes.challenges}
for name, difference in gaps.items():
    print(f"{name}: {difference.estimate:+.2f} against the default")
change = gaps["Study"].estimate
slow.measured("stays about the same" if change > -0.15 else "falls by half" if change > -0.45 else "falls to about 0")

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** It stays about the same in Study, and falls in Tamagotchi. A greedy player asks only which value is the largest, not how large it is. In Study, a
# tiny value on the right action is enough in these 20 000 steps. In Tamagotchi, too, if every action is tried equally often: with $\varepsilon = 1$ the same $\alpha$ scores 0.71 (20 runs).
# With so small an $\alpha$ a value is nearly a sum of rewards, so what is taken most often leads; that is our guess.
# </details>
#
# So "this setting is bad" is no sentence about an agent. It is a sentence about an agent with all its settings, a challenge and a number of steps.

# %% [markdown]
# ### The whole profile: one agent on all ladders
#
# All ladders together are the profile of an agent. To climb them takes a while, so here is one that is stored with the course: ten runs on each
# rung, at the defaults. An agent *masters* a ladder if it never breaks and has 0.9 or more on the last rung.
# It *cannot enter* one that is not made for it: a table takes no pictures, as in Catch, and no actions of real numbers, as in Trashbot.

# %%
for sentence in methods.whole_profile("QLearning"):
    print(sentence)
figures.all_ladders("QLearning")

# %% [markdown]
# Q-learning masters no ladder up to its last rung. (Where a rung is near 0.5, as on the road of length 80, other runs may break a rung later, or earlier.) Choose another agent (first RMax, NStepSARSA and QLambda of lesson 3, or DynaQ of lesson 9), and say of each ladder that you know, before you look, whether it climbs higher. (Roadrunner is from lesson 2, MemoryCorridor from 5, Supermarket from 9, and Switches from 11.) Which part of
# its idea should help there?

# %%
sliders(figures.beside_q_learning, agent=methods.stored_agents())

# %% [markdown]
# <details><summary>What came out, as the score less that of Q-learning</summary>
#
# - *RMax*: Boulder and Supermarket +0.6, Study +0.3, Roadrunner and Switches +0.2; but Golf −0.1, where one try shows one of many outcomes, and Tamagotchi −0.7 (see above).
# - *RMax* in MemoryCorridor: −0.25, all of it on the first rung. Is one try the reason here, too? No: with ten tries or a hundred the score is the same −0.5 there. The reason is the −100: an episode of this rung is cut off after one step, not terminated, so nothing is ever tried behind the right door, and what is there stays
#   at −100. So that door is worth 1 + 0.99 · (−100), and a wrong one, which terminates the episode, 0. With 0 in the place of −100, as Q-learning has it, R-max scores 1 on this rung.
# - *DynaQ*, *NStepSARSA* and *QLambda*, which carry a value back over many steps at once, or replay them: Supermarket +0.4, +0.3 and +0.35, Study +0.3, +0.2 and +0.3, Roadrunner +0.2, +0.1 and +0.2, Golf +0.05, +0.2 and +0.15. In Tamagotchi *QLambda* has −0.1. Which of these differences does that reason not explain? (We have not tested it by taking it away.)
# </details>

# %% [markdown]
# ## Exercises

# %%
from edugym_course.grading import check
from edugym_course.lessons.profiles.exercises import exercise_1, exercise_2

# %% [markdown]
# ### Exercise 1: the score of a ladder
# Write the score of a ladder. Three arrays have a number for each rung: `returns` the return of the agent, `random` that of random play, and `best` that of the best play.
#
# <details><summary>Hint</summary>The equation of this lesson gives one number for each rung.</details>


# %%
def ladder_score(returns, random, best):
    """Return the score: the mean over the rungs."""
    ### BEGIN SOLUTION
    scores = (returns - random) / (best - random)
    return np.mean(scores)
    # own: return (np.sum(scores) + ({times} - 1) * scores[-1]) / (len(scores) - 1 + {times})
    ### END SOLUTION


# %% tags=["check"] points=2
check(exercise_1, ladder_score)
### BEGIN HIDDEN TESTS
check(exercise_1, ladder_score, seed=1, quiet=True)
### END HIDDEN TESTS

# %% [markdown]
# ### Exercise 2: build a hole
# Build an agent that is as good as Q-learning in Tamagotchi (or nearly), and no good in Study. Changing one setting is enough. The check
# trains your agent and Q-learning on both ladders, five times on each rung (some minutes for a class of your own, which is not compiled; `from edugym import table_size`; `table_size(environment)` gives the shape of its table). A hole is a score that is surely lower by 0.2: the whole 95 % interval of the difference lies below −0.2.
# The settings of `QLearning.create(environment, ...)` are `learning_rate`, `discount`, `initial_value` and `exploration`, as in `EpsilonGreedy(0.1)` of `edugym`.
#
# <details><summary>Hint</summary>In which of the two does an action matter only much later? Which symbol in $Q(S, A) \leftarrow Q(S, A) + \alpha [R + \gamma \max_a Q(S', a) - Q(S, A)]$ lets it see that?</details>


# %%
def make_mine(environment):
    """Return an agent for an environment."""
    ### BEGIN SOLUTION
    return QLearning.create(environment, discount=0.0)
    # own: return QLearning.create(environment, discount=0.0, initial_value={first})
    ### END SOLUTION


# %% tags=["check"] points=3
check(exercise_2, make_mine)
### BEGIN HIDDEN TESTS
check(exercise_2, make_mine, seed=1, quiet=True)
### END HIDDEN TESTS

# %% [markdown]
# More holes to build, with `profile` as the judge: an agent that breaks in Boulder, but not in Golf; one that
# gets further than Q-learning in MemoryCorridor (a wrapper is part of an agent: after `from edugym import FrameStack`, that is `(QLearning.create, lambda mdp: FrameStack.create(mdp, 4))`). Why
# can the one with frames not enter Roadrunner? (`profile({"mine": ...}, challenges=["Roadrunner"])` says it, in its error.)

# %% [markdown]
# ## What you saw
#
# An agent is not good or bad. It is good at some challenges, up to some strength, and often its equation says which: what it averages over, how far it looks ahead, what it
# tries. A reason that is read from an equation is a prediction, and a ladder tests it.
#
# In the terminal, `edugym profile QLearning my_agent.py:MyAgent` climbs all ladders that your agent can enter and writes a page, on which your agent stands beside all of the
# course ([how to read it](https://github.com/RLG-Leiden/edugym/blob/main/docs/profiles.md)). In [a challenge for a
# class](https://github.com/RLG-Leiden/edugym/blob/main/docs/class-challenge.md) everybody builds one agent for all ladders, with one table and without tuning.
#
# ### Limits
# Nothing is tuned, so a low score does not mean that an agent cannot learn a task. Each rung has one budget of training steps; with more of them, an agent may break later. The
# intervals are those of three, five or ten runs.
#
# ### Further reading
# - Osband et al. (2020), *Behaviour suite for reinforcement learning*: profiles of agents over tasks that each isolate one
#   thing, shown as a radar.
# - Brafman and Tennenholtz (2002), *R-max*: how many tries make a pair known, and what they guarantee.
# - Sutton and Barto, *Reinforcement Learning*, 2nd edition: 8.1 to 8.3.
