# %% [markdown]
# # Model-based RL: Supermarket
#
# **The challenge.** Steps in the world cost time, money, sometimes a broken robot. An agent that knows what its actions
# would do can try them in its head, where no step is spent: it *plans* with a *model*.
#
# **You will be able to** plan with a given model, and with one that the agent learns (Dyna, prioritised sweeping, R-max);
# say what planning can do for an agent, and what it cannot; show what a wrong model does to a plan; and write R-max
# yourself.
#
# **Time.** {time} **Before you start.** You should
# know what a value function, Q-learning and ε-greedy action selection are (Sutton and Barto, 2nd edition, sections
# 3.5, 6.5 and 2.2). All symbols are in the [table of
# notation](https://github.com/RLG-Leiden/edugym/blob/main/docs/notation.md).

# %%
from functools import partial
from typing import NamedTuple

import gymnasium as gym
import numpy as np

from edugym import DynaQ, EpsilonGreedy, PrioritisedSweeping, QLearning, RMax, make_mdp, repeat
from edugym.exact.tables import looked_ahead
from edugym.experiments.figures import Sheet
from edugym.training.attempt import attempt
from edugym_course.lessons.model_based import figures, maps, shops
from edugym_course.lessons.model_based.methods import (
    GIVEN,
    LEARNED,
    REMEDIES,
    SLOW_DYNA,
    WRONG,
    compare,
    compare_planners,
    targets_computed,
    with_right_model,
)
from edugym_course.lessons.model_based.plans import follow_plan, follow_plans, items_found, used_and_seen
from edugym_course.notebook import frames, play, predict, sliders, source

# %% [markdown]
# ## Meet the environment: a shop, three items, one exit
#
# A shopper collects three items and leaves by the exit. Every step costs a little. Leaving is always possible, also
# with an empty bag.

# %%
env = gym.make("edugym/Supermarket-v0").unwrapped
env.reset(seed=0)
env.scene()

# %% [markdown]
# As a Markov decision process:
#
# | | | in words |
# |---|---|---|
# | states | $\mathcal{S} = \{0, \dots, 799\}$ | the cell, and which items are in the bag: 428 of them can be reached |
# | actions | $\mathcal{A} = \{0, 1, 2, 3\}$ | up, down, left, right |
# | dynamics | $p(s' \mid s, a) = 1$ for one $s'$ | the next cell; a wall leaves the shopper where it is |
# | reward | $r(s, a, s') = -1$ | for each step |
# | | $+25$ | for each item, the first time |
# | | $+50$ | at the exit, which is a *terminal* state: the episode ends |
# | discount | $\gamma = 0.99$ | used by the agents; the returns in the figures are not discounted |
#
# After 500 steps an episode is *truncated*: a new one begins, although the task was not at its end. The best way takes
# 30 steps and returns $3 \cdot 25 + 50 - 30 = 95$. These methods are the environment:

# %%
source(type(env.mdp), "transition", "reward", "terminal")

# %% [markdown]
# **Play it yourself, blind.** You see what the agent sees: one number, for the cell and the bag. Play two
# episodes. What do you keep in your head? A map: you know what a step *would* do before you take
# it. That is a model.

# %%
play("Supermarket", blind=True, max_steps=100)

# %% [markdown]
# ## The idea: take steps in your head
#
# ### Learn from real steps alone
# **Q-learning** keeps a table with a value $Q(s, a)$ for each action in each state. After a step from $S$ by $A$ to $S'$
# with reward $R$ it moves one value by the learning rate $\alpha$ towards a target (Sutton and Barto, equation 6.8):
#
# $$
# Q(S, A) \leftarrow Q(S, A) + \alpha \left[ R + \gamma \max_a Q(S', a) - Q(S, A) \right]
# $$
#
# After a terminal state there is no future, and the target is $R$ alone.

# %%
source(QLearning.learn)

# %% [markdown]
# One step, one update, and then the step is forgotten. When the shopper finds the exit, only the *last* cell of its way
# learns that: the value of the exit comes back one cell a walk.
#
# ### If the model is given: dynamic programming
# A **model** says what happens after an action: the probability $p(s' \mid s, a)$ of each next state, and its reward
# $r(s, a, s')$. There are two kinds. A *descriptive* model (the book says: distribution model) gives all that can happen, with probabilities. A *generative*
# model (sample model) only draws samples of it. Supermarket offers both, and they take no step in the world:

# %%
print("descriptive:", env.descriptive_model(8, 3))  # row 0, column 1, with an empty bag; to the right is a wall
sample = env.generative_model(8, 1)  # the same place, down
print("generative: ", (sample.next_state, sample.reward, sample.terminated))

# %% [markdown]
# With a descriptive model an agent needs no experience at all. **Value iteration** sweeps over all states, and each time
# looks one step ahead (equation 4.10; $V(s) = \max_a Q(s, a)$ is the value of a state, 0 after the end):
#
# $$
# Q(s, a) \leftarrow \sum_{s'} p(s' \mid s, a) \left[ r(s, a, s') + \gamma V(s') \right]
# $$
#
# This is called an *expected update*: it takes the mean over all that can happen. The code does it for all states at
# once. (In `sak` each letter is an axis of a table: state, action, and the possible next states.)

# %%
source(looked_ahead)

# %% [markdown]
# Watch the values spread from the exit and the items, one cell a sweep. The maps show the shop with an *empty bag*; the
# arrow is the best action. Cells whose value is not above 0 are cream. (The items stay white: who steps on an item has
# it in the bag.) After 30 sweeps the maps do not change any more, and the best way is known, before the first step.

# %%
maps.dynamic_programming()

# %% [markdown]
# ### If the model must be learned: Dyna
# A model is seldom given. But every real step tells a piece of it. **Dyna** (box of section 8.2) uses each real
# step three times: to learn, to remember, $\text{Model}(S, A) \leftarrow R, S'$,
# and to plan with it. Planning repeats $n$ times:
#
# $$
# \begin{aligned}
# S &\leftarrow \text{a random state that was seen}, \quad A \leftarrow \text{a random action that was taken in } S \\
# R, S' &\leftarrow \text{Model}(S, A) \\
# Q(S, A) &\leftarrow Q(S, A) + \alpha \left[ R + \gamma \max_a Q(S', a) - Q(S, A) \right]
# \end{aligned}
# $$
#
# As this uses one sample of the model, it is called a *sample update*. The model knows nothing but what was tried.
#
# The equations above stand in the middle of this code. (`act` calls `plan` before it chooses. `n_known` counts the
# pairs in the model. `planning.start` and `lasts` count the $n$ updates. In `imagined_target` only the line with
# `self.model.sample` runs here, since `expected_updates` and the bonus are off.)

# %%
source(DynaQ, "learn", "plan", "imagined_target")

# %% [markdown]
# ### Plan where it matters: prioritised sweeping
# Most of Dyna's random updates change nothing. When the exit is found, the useful update is that of the cell before it,
# then that of the cell before *that*. **Prioritised sweeping** (box of section 8.4) works backwards. It keeps a queue of
# the pairs $(s, a)$ whose update would change most. The priority $P$ is the size of the error that the update would
# correct,
#
# $$
# P = \left| R + \gamma \max_a Q(S', a) - Q(S, A) \right| ,
# $$
#
# where $R, S'$ is what the model says of the pair $(S, A)$. A pair gets into the queue if $P$ is above a small
# threshold $\theta$. Each update takes the first pair of the queue, and then looks at all pairs that lead to its state.
# All learning is by planning.

# %% [markdown] tags=["aside"]
# ### Aside: prioritised sweeping in code
# This is `plan`. (An `outcome` is one row of the model: a pair, and what followed. The four lines before `done += 1` walk
# through those that lead to the state `s`. `consider` computes $P$, and puts the pair into the queue if $P$ is large
# enough. In this shop each pair has one outcome, so both branches of the `if` give the same.)

# %%
source(PrioritisedSweeping, "plan")

# %% [markdown]
# ### See it spread
# A shopper walks at random and finds the exit after 518 steps (here without the limit of 500), with an empty bag.
# Q-learning, Dyna and prioritised sweeping have seen that walk ($\alpha = 1$). Now the last two plan.
#
# **Predict.** After 200 updates, who knows a way from the entrance to the exit?

# %%
spread = predict(
    "After 200 updates, a way from the entrance to the exit is known to ...",
    ["neither", "Dyna", "prioritised sweeping", "both"],
)
spread

# %%
display(maps.spreading(200))
knows = maps.who_knows_the_way(200)
spread.measured({(): "neither", ("Dyna", "prioritised sweeping"): "both"}.get(knows, knows[0] if knows else ""))

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Prioritised sweeping does, and Dyna does not: Dyna's table has a value above 0 in two cells only. In
# that of Q-learning it is one cell, the last one before the exit. Grey cells were never seen; cream cells were seen,
# and have no value above 0. Look at the way that prioritised sweeping has found: it passes the items by. The walk met
# none of them.
# </details>

# %% [markdown]
# How many updates does each planner need until the entrance has a colour, a value above 0? Move the slider: its steps
# grow.

# %%
sliders(maps.spreading, updates=[0, 20, 40, 60, 80, 100, 150, 200, 400, 800, 1_200, 1_600, 2_000, 2_400])

# %% [markdown]
# <details><summary>What was measured</summary>
#
# With these draws prioritised sweeping needs between 80 and 100 updates, and Dyna between 1 600 and 2 000.
# </details>

# %% [markdown]
# And in training? One episode of each method, after 1 000 steps of training. Who knows where it is going? (The films
# stop after 60 steps. `LEARNED` has the methods of the lesson, by label.)


# %%
def watch(method, after=1_000):
    """Show one episode of training, after so many steps of training before it."""
    shop = make_mdp("Supermarket")
    return frames(shop, attempt(LEARNED[method], shop, after, seed=3), max_steps=60)


watch("Q-learning")

# %%
watch("Dyna-10")

# %%
watch("prioritised sweeping")

# %% [markdown]
# <details><summary>What the films show</summary>
#
# Dyna-10 leaves after 18 steps with the red item, prioritised sweeping after 39 without the blue one. Q-learning
# still looks for the exit.
# </details>

# %% [markdown]
# ## The experiment: the same steps, more thought
#
# This is the figure of the paper (Moerland et al., 2023), with one method more: Dyna with 50 updates after each step.
#
# | setting | value |
# |---|---|
# | all | $\alpha = 1$ (nothing is random in this shop), $\gamma = 0.99$, ε-greedy with $\varepsilon = 0.1$ |
# | Dyna-10, Dyna-50 | $n = 10$ and $50$ updates a step |
# | prioritised sweeping | at most $n = 10$ updates a step, $\theta = 0.001$ |
# | evaluation | one episode without exploring, every 250 steps of 10 000 |
# | repetitions | 100, the same seeds for all methods; bands are 95 % intervals |
#
# Two black lines come from the exact model: the optimum (dashed), and the best *ε-soft* policy (dotted), which takes a
# random action with probability $\varepsilon = 0.1$ all the time.
#
# The cell after the next is the whole experiment. (Further down `compare` makes this call of `repeat`, with other
# methods.)
#
# **Predict.** The methods with a model will learn in fewer steps. But who has the best policy *at the end*?

# %%
at_the_end = predict(
    "The highest return after 10 000 steps:",
    ["Q-learning", "Dyna-10", "Dyna-50", "prioritised sweeping"],
)
at_the_end

# %%
settings = {"learning_rate": 1.0, "discount": 0.99, "exploration": EpsilonGreedy(0.1)}
planners = {
    "Q-learning": lambda shop: QLearning.create(shop, **settings),
    "Dyna-10": lambda shop: DynaQ.create(shop, planning_steps=10, **settings),
    "Dyna-50": lambda shop: DynaQ.create(shop, planning_steps=50, **settings),
    "prioritised sweeping": lambda shop: PrioritisedSweeping.create(shop, planning_steps=10, **settings),
}
learned = repeat("Supermarket", planners, 10_000, repetitions=100, evaluate_every=250)
display(figures.learning_curves(learned))
for method in learned.methods:
    steps = figures.steps_to(learned, method, 70)
    print(f"{method:20}: half of the runs get 70 by step {steps:5.0f}; at the end {learned.mean(method)}")
at_the_end.measured(max(learned.methods, key=lambda method: learned.final(method).mean()))

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Dyna-10 needs about a quarter of the steps of Q-learning, and the other two planners about a fifth:
# that is what a model is for. (The curves are means, which slow runs pull down.) And then they hardly improve.
# Q-learning ends highest in this shop, and prioritised sweeping, among the first to rise, ends below Dyna-10. (Both panels cut off a bad start.)
# </details>

# %% [markdown] tags=["aside"]
# ### Aside: plan while the world is slow
# Where the world is slow, planning is free. Supermarket can be
# slow: with `step_timeout`, `step` waits until so many seconds have passed since the last one. Meanwhile the agent plans:

# %%
slow_shop = gym.make("edugym/Supermarket-v0", step_timeout=0.02).unwrapped
agent, rng, updates = DynaQ.create(slow_shop, planning_steps=10), np.random.default_rng(0), 0
state, _ = slow_shop.reset(seed=0)
for _ in range(50):
    action = agent.exploration.choose(agent.Q, state, rng)
    next_state, reward, terminated, truncated, _ = slow_shop.step(action)
    agent.learn(state, action, reward, next_state, terminated)
    state = slow_shop.reset()[0] if terminated or truncated else next_state
    while slow_shop.time_until_step() > 0.002:  # seconds
        agent.plan(rng)  # 10 updates
        updates += 10
print("more than 10 updates in the 0.02 seconds of a step, on average:", updates / 50 > 10)

# %% [markdown] tags=["aside"]
# ### Aside: what does a step cost?
# The horizontal axis counts steps, as if planning were free. So let us count time. As a measure of an agent's thought
# we count the targets that it computes; all else is left out. Q-learning computes one a step, and Dyna one more for
# each imagined step. Prioritised sweeping computes one for each update and one for each *priority*: we count both. Say
# a target takes 10 microseconds, and is computed while a step is under way. Then a step takes as long as the world
# needs, or as long as its targets need if that is longer. (The figure computes the time from the number of targets, so
# that it is the same on every machine.)
#
# **Predict.** In a simulator steps may cost nothing, and targets are all that takes time. Who gets a return of 70 first
# then?

# %%
free = predict("If only targets take time, the first to return 70 is ...", [*planners])
free

# %%
targets = targets_computed(learned)
display(figures.clocks(learned, targets))
simulator = figures.Clock(learned, targets, step_ms=0.0, target_us=10.0)
for method in learned.methods:
    early, later = targets[method][:, :500].sum(axis=1).mean(), targets[method][:, 500:].mean()
    print(f"{method:20}: {early:6.0f} targets in the first 500 steps, later {later:4.1f} a step;", end=" ")
    print(f"half of the runs get 70 after {1000 * simulator.seconds_to(method, 70):3.0f} ms")
free.measured(min(learned.methods, key=lambda method: simulator.seconds_to(method, 70)))

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Q-learning, by far. Each planner saves steps, and computes more targets in all.
# Prioritised sweeping computes about 6 100 in its first 500 steps, most of them for priorities. Later its queue is
# mostly empty. Where a step takes a tenth of a second (right), targets are free, and the planners are ahead by minutes.
# A model pays where steps cost much. (The curves are means again, so they get to 70 later than half of the runs.)
# </details>

# %% [markdown]
# How slow must the world be, so that planning pays?


# %%
def one_clock(step_ms=1.0, target_us=10.0):
    """Draw the learning curves over time, where a step and a target take so long."""
    title = f"a step takes {step_ms:g} ms, a target {target_us:g} µs"
    return Sheet("one clock", [[figures.Clock(learned, targets, step_ms, target_us, title)]])


sliders(one_clock, step_ms=[0.0, 0.01, 0.03, 0.1, 0.3, 1.0, 10.0, 100.0], target_us=[1.0, 3.0, 10.0, 30.0, 100.0])

# %% [markdown]
# <details><summary>What was measured</summary>
#
# With 10 µs for a target, the curve of Q-learning is the first to get to 70 where a step takes 0.03 ms or less. From
# 0.1 ms on those of Dyna-10 and prioritised sweeping are ahead of it, and from 0.3 ms on that of Dyna-50 too.
# </details>

# %% [markdown]
# ## Your turn
#
# How many updates are enough? What does a learning rate below 1 do in a
# shop without chance? Does $\gamma$ matter? Move a slider and release it: three methods train again, with 10 repetitions.


# %%
def one_shop(n=10, epsilon=0.1, alpha=1.0, gamma=0.99):
    """Draw the learning curves of Q-learning, and of two planners with n updates a step."""
    results = compare_planners(n, epsilon, alpha, gamma, repetitions=10)
    title = f"n = {n}, ε = {epsilon:g}, α = {alpha:g}, γ = {gamma:g}"
    return Sheet("one shop", [[figures.learning(results, title)]])


sliders(one_shop, n=(0, 40, 2), epsilon=(0.02, 0.9, 0.02), alpha=(0.1, 1.0, 0.1), gamma=(0.9, 0.99, 0.01))

# %% [markdown]
# <details><summary>What was measured</summary>
#
# - $n$: until half of the runs are at 70, ten updates save Dyna some 2 000 steps, and thirty more about one evaluation (100 runs; ten do not show it). Thirty more hardly help prioritised sweeping.
# - $\alpha$: with 0.1 all need at least twice as many steps.
#   Nothing is random, so 1 is fastest.
# - $\gamma$: with 0.9 all three take about as many steps as before. But with 0.94 or less the way with the highest
#   *discounted* return leaves an item out, and returns 78.
# </details>

# %% [markdown]
# ## See inside: knowing and planning are two things
#
# Why do planners end lower? Perhaps they plan badly: their tables do not say what their models know. Or they know too
# little. To tell, take the experience of a run and *plan with it until nothing changes any more*. If a plan
# may use only what the run has tried, what does the best one return?
#
# **Predict.** Dyna-10 ends with a return of about 83. What does the best plan by what it has seen return?

# %%
more_planning = predict("With perfect planning on its own experience, Dyna-10 would return:")
more_planning

# %%
known = used_and_seen(learned)
display(Sheet("known", [[figures.Knowledge(known, "what they do with what they know")]]))
for method in learned.methods:
    found = ", ".join(f"{share:.0%}" for share in items_found(learned, method))
    print(f"{method:20}: runs that have found item 1 (red), 2 (blue), 3 (green): {found}")
more_planning.measured(known["Dyna-10"][1].mean())

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** About 83: planning is not what Dyna lacks. Its policy is the best by what it has
# seen, and so, nearly, are those of the other planners. Many of their runs have missed an item, most often the blue
# one. Q-learning has seen all that the best way needs, and makes less of it.
# </details>

# %% [markdown]
# **Planning invents no knowledge.** A likely reason for what planners miss: only random steps leave their way, and the planners go straight back. If
# so, more exploration should mend it. Two remedies below try that.
#
# Who ends *higher* depends on the shop. The aside tries twelve others: in all of them Dyna-10 gets to know less than
# Q-learning, but it does not always end below it.

# %% [markdown] tags=["aside"]
# ### Aside: is it the shop?
# All of this was one shop. What is general, and what belongs to its map? Let us put the three items elsewhere: twelve
# shops with the same walls, entrance and exit, and the items in places that are drawn at random. (The returns are in
# percent of what the best plan of each shop returns, the means of 10 runs.)
#
# **Predict.** In how many of the twelve shops does Q-learning end above Dyna-10?

# %%
elsewhere = predict("Q-learning ends above Dyna-10 in", unit="of 12 shops")
elsewhere

# %%
others = shops.compare_shops({one: LEARNED[one] for one in ("Q-learning", "Dyna-10")}, repetitions=10)
for method, (returns, seen) in others.items():
    print(f"{method:10}: by shop", *(f"{mean:4.0f}" for mean in returns.mean(axis=1)), f"  mean {returns.mean():.0f}")
    print(f"{'':10}  allowed", *(f"{mean:4.0f}" for mean in seen.mean(axis=1)), f"  mean {seen.mean():.0f}")
ends = {method: other.returns.mean(axis=1) for method, other in others.items()}
elsewhere.measured(int((ends["Q-learning"] > ends["Dyna-10"]).sum()))

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** In 7 of 12, so in about half: ten runs cannot say exactly. In the others it ends below, in some of them far below. So "planning makes the last policy
# worse" is true of our shop, and not of shops. Look at the second line of each method: what the best plan by what it
# has seen would return. (The plan is best for the discounted return, so a policy may return a little more than it.)
# This is the same everywhere. Q-learning gets to know nearly all that a best plan needs in every shop, and in some it does not make a
# policy of it in the time that it has. Dyna-10 gets to know less than Q-learning in each of them, and its policy *is*
# the best plan by what it knows. Who ends higher depends on which of the two costs more there.
# </details>

# %% [markdown]
# ### Explore more
# The first remedy is more random steps for Dyna-10: a constant $\varepsilon = 0.5$, or an $\varepsilon$ that falls from 1
# to 0.02 over the 10 000 steps.
#
# ### Plan to explore: R-max
# The second remedy is to *plan* for what is not known. **R-max** (Brafman and Tennenholtz, 2002) believes that all it has
# not tried is wonderful. A pair $(s, a)$ is *known* when it was tried $m$ times ($m = 1$ is right where nothing is random).
# Known pairs have the values of value iteration with the learned model $\hat p$, $\hat r$. All others have the value
# $U = 100$, which is more than any value in this shop:
#
# $$
# Q(s, a) = \begin{cases}
# \sum_{s'} \hat p(s' \mid s, a) \left[ \hat r(s, a, s') + \gamma \max_{a'} Q(s', a') \right] & \text{if } (s, a) \text{ is known} \\
# U & \text{otherwise}
# \end{cases}
# $$
#
# The agent always takes a best action, and draws only among equals. It plans the way to something unknown like any other way.
# (Q-learning with *optimistic initial values*, section 2.6, does not plan with them.)
#
# The code keeps two tables. `optimistic` is the one above, by which it acts. `Q` has $-100$ in the place of $U$, and
# avoids what is unknown: the policy is evaluated by it. (`sweep` holds the list of known pairs, and where the sweep has
# got to; planning goes on until a whole sweep changes nothing, or until 1 000 updates of a step are made.)

# %%
source(RMax, "learn", "plan", "act")

# %% [markdown]
# (`expected_target` is the right side of the equation.)
#
# The settings are those from above, with 40 repetitions. R-max has no $\varepsilon$ and no $\alpha$.
#
# **Predict.** Dyna-10 ends at the optimum, 95, in some three of ten runs, after 10 000 steps. In how many runs does R-max
# have a policy that returns 95 after 2 000 steps?

# %%
wants_to_know = predict("R-max returns 95 after 2 000 steps in ... of its runs", unit="%")
wants_to_know

# %%
makers = {"Dyna-10": LEARNED["Dyna-10"], **REMEDIES, "R-max": LEARNED["R-max"]}
remedied = compare(makers, repetitions=40)
knowing = figures.Knowledge(used_and_seen(remedied), "what they do with what they know")
display(Sheet("remedies", [[figures.learning(remedied, "remedies", y_range=(0.0, 100.0)), knowing]]))
wants_to_know.measured(100 * np.mean(remedied.curves("R-max").loc[2_000] >= 95))

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** In nearly all runs, and soon after in all. R-max needs no more steps than Dyna-10, and it
# gets everything. More random steps help too (for $\varepsilon = 0.5$ only 100 runs show it surely), but slowly. In the right panel the two dots of each method stay close
# together: what changed is what they have *seen*.
# </details>

# %% [markdown]
# R-max after 300 steps of training: it goes to what it does not know, and turns to the next.

# %%
watch("R-max", after=300)

# %% [markdown]
# ## Predict, then check
# %% [markdown] tags=["aside"]
# ### Aside: plan at the moment of decision
# So far plans went into a table. An agent can also plan at the moment of decision, and forget the plan afterwards
# (sections 8.8 to 8.11): it looks $d$ steps ahead in the model, takes the best first step, and plans again. That is what a
# chess program does. Where the look ahead ends, it uses the values in a table, or 0 if it has none.
#
# The right model is given; $\gamma = 0.99$. The figure has three lines: one for an agent that knows nothing, and two for
# agents with the values of Q-learning or Dyna-10 after 2 000 steps of training. (The right panel shows the upper part of
# the left one.)
#
# **Predict.** An agent has learned nothing: all values are 0 where its look ahead ends. How many steps must it look ahead
# to get all three items and leave, a way of 30 steps?

# %%
depth = predict("To return 95 it must look ahead", unit="steps")
depth

# %%
short = {label: LEARNED[label] for label in ("Q-learning", "Dyna-10")}
beginners = compare(short, n_steps=2_000, repetitions=30)
looking = figures.look_ahead_lines(beginners)
display(Sheet("ahead", [[looking, figures.close(looking, 50.0, 100.0)]]))
depths = [0, 7, 8, 9, 10, 11, 12]
print(f"{'it looks ahead':14}:", *(f"{d:5}" for d in depths))
for method, returns in looking.lines.items():
    print(f"{method:14}:", *(f"{returns[d]:5.0f}" for d in depths))
depth.measured(int(looking.x[looking.lines["knows nothing"] >= 95][0]))

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** 12 steps. With fewer than 8 it sees no positive reward from the entrance, takes the first of equals, and goes nowhere. With 8 it
# gets the first item, and from there the exit, worth 50, looks better than one more item, worth 25: it leaves with a
# return of 59. On its way to the exit it turns to one more item only when it sees that it can have both, the item *and
# the exit behind it*. For the second item that takes 11 steps (a return of 78), and for the third 12.
#
# Good values make a short look enough: Dyna-10 needs none to get its 82. Bad ones can do harm: with a look ahead of 8,
# half-learned values of Q-learning lead the agent astray where zeros do not. Up to a look ahead of 10 Dyna-10 gains
# little. With 11 and 12 it probably gets items that it has never seen: the *given* model knows them.
# </details>

# %% [markdown]
# ### If the model is wrong
# With `noise`, the rewards of the given model have errors: one for each state and action, drawn once from a normal
# distribution with mean 0 and standard deviation $\sigma$. Plan by value iteration with such a model, and follow the
# plan in the real shop.
#
# **Predict.** At $\sigma = 1.5$ an error is about as large as the cost of a step (1), and small beside an item (25) and
# the exit (50). With $\gamma = 0.95$, how many of the plans never get to the exit? (The figure shows $\gamma = 0.9$
# too.)

# %%
never = predict("With noise 1.5, plans that never end:", unit="%")
never

# %%
plans = {discount: follow_plans(range(40), discount) for discount in (0.9, 0.95)}
display(Sheet("wrong plans", [[figures.plan_lines(plans)]]))
lost = [plan for plan in plans[0.95][1.5] if not plan.ends]
print(f"of the plans that never end, {np.mean([plan.bumps for plan in lost]):.0%} walk into one wall for ever")
for discount in (0.95, 0.97):
    with_errors, at_walls_none = (
        sum(not follow_plan(1.5, seed, discount, errors_at_walls=walls).ends for seed in range(40))
        for walls in (True, False)
    )
    print(f"γ = {discount}: {with_errors} of 40 plans never end, and {at_walls_none} without the errors at walls")
never.measured(100 * len(lost) / 40)

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** More than nine of ten. A plan is a search for the largest value, so it finds the largest *errors*. Among
# the 420 states before the exit, with four actions each, some wall seems to pay for each bump. Bumps can go on for
# ever, so a small error adds up, and the more so the larger $\gamma$ is (exercise 1). Up to $\sigma = 0.5$ no plan was lost with $\gamma = 0.9$ or 0.95: no wall pays enough.
#
# Is it the walls? Without the errors of bumps about 70 % of the lost plans get to the exit with $\gamma = 0.95$. With
# $\gamma = 0.97$ all but two of 40 stay lost. A plan that never ends goes round and round, and a bump is only the shortest round.
# </details>

# %% [markdown]
# See what a plan does; each `draw` gives the model other errors. (With noise 0 the model is right. Even then the plan
# leaves out one item where $\gamma$ is 0.94 or less, and two where it is 0.89 or less. The way round by an item costs steps and
# makes the exit come later: together that is more than the item brings.)

# %%
sliders(maps.wrong_plan, noise=(0.0, 3.0, 0.25), draw=(0, 20), gamma=(0.8, 0.99, 0.01))

# %% [markdown] tags=["aside"]
# ### Aside: do real steps save an agent with a wrong model?
# Now agents *learn*, and plan with a given model. Prioritised sweeping makes up to 1 000 expected updates a step, all with
# the model: it needs a descriptive one. Dyna makes 10 sample updates, for which a generative model is enough, and also
# learns from its real steps, which show the real rewards. Each has 10 000 steps, $\varepsilon = 0.1$, $\gamma = 0.95$ and
# 24 repetitions, each with errors of its own; $\alpha = 1$, and for Dyna also 0.1.
#
# **Predict.** The model has the noise $\sigma = 1.5$. Do its real steps save Dyna?

# %%
saved = predict(
    "With the wrong model a good policy is learned, in most runs, by ...",
    ["none", "Dyna with α = 0.1 only", "Dyna with α = 1 only", "Dyna with both"],
)
saved

# %%
right = compare(with_right_model(GIVEN), repetitions=24)
wrong = compare(GIVEN, noise=WRONG, repetitions=24)
display(figures.given_curves(right, wrong))
good = {method: np.median(wrong.final(method)) > 50 for method in wrong.methods}
slow, fast = good[SLOW_DYNA], good["Dyna-10"]
saved.measured(saved.options[slow + 2 * fast])

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Only with $\alpha = 0.1$ (in the right panel). With $\alpha = 1$ a value is what the last update says: one imagined update
# at a wall brings the whole error of the model back. With $\alpha = 0.1$ a value is a mean over many updates. The imagined ones are
# spread evenly over the whole model, and the real ones are all on the way of the agent. Where it walks often, reality
# wins: a bump that disappoints again and again is given up. If that is the reason, then more imagined steps should turn
# it round. With 200 for each real one, 15 of 24 last policies still get to the exit; with 10 all do. So that is a part of the reason at least. With the right
# model (left) the small rate is the slowest, and at the end 9 of its 24 runs still leave an item out. What is best
# depends on how far you trust your model.
# </details>

# %% [markdown]
# ## Exercises
#
# Each exercise has a cell for your answer, and below it a cell that checks it. The check does not only say whether an
# answer is right: it says what was expected, what came, and which mistake that looks like. It runs your code on cases
# that it makes up.

# %%
from edugym_course.grading import check
from edugym_course.lessons.model_based.exercises import CHALLENGE, exercise_1, exercise_2, exercise_3, exercise_4

# %% [markdown]
# ### Exercise 1: how large an error is enough?
# A shopper stands before a wall. To bump into it costs 1, as every step does, and leaves it where it is. In a wrong
# model the reward of that bump has the error $e$, so that it seems to be $e - 1$. The best way from this cell has the
# discounted value $v$. From which $e$ on does it seem better to bump for ever? Write it as a function of $v$ and
# $\gamma$.
#
# <details><summary>Hint</summary>What is the sum of $x + \gamma x + \gamma^2 x + \dots$? Put the reward of a bump in the
# place of $x$, and set the sum equal to $v$.</details>


# %%
def smallest_error(v, gamma):
    """Return the error of a bump above which to bump for ever seems better than a way that is worth v."""
    ### BEGIN SOLUTION
    return 1 + (1 - gamma) * v
    # own: return {cost} + (1 - gamma) * v
    ### END SOLUTION


# %% tags=["check"]
check(exercise_1, smallest_error)
### BEGIN HIDDEN TESTS
check(exercise_1, smallest_error, seed=1, quiet=True)
### END HIDDEN TESTS
display({f"γ = {gamma}": round(smallest_error(40.0, gamma), 3) for gamma in (0.9, 0.95, 0.99)})

# %% [markdown]
# ### Exercise 2: Dyna-Q+, a model that asks to be checked
# Dyna-Q+ (section 8.3) gives a bonus to imagined steps. Let $\tau$ be the number of real steps since the action was
# last taken in that state. An imagined reward $R$ becomes $R + \kappa \sqrt{\tau}$: what was not tried for a long time
# looks better and better. Actions that were *never* taken are imagined too, as if they gave reward 0 and led back to
# their own state. This is not the end of the episode, so the value of that state counts, and there is a bonus: their
# $\tau$ counts from step 0.
#
# The agent remembers in tables what followed each action: `rewards[s, a]`, `next_states[s, a]`, and `ends[s, a]`, which
# is 1 if the episode ended there. `last[s, a]` is the step at which it was last taken, 0 for never, and `clock[0]`
# counts the steps. Complete `imagine`, which returns the target of an imagined step, bonus included. `discount` and
# `kappa` are $\gamma$ and $\kappa$; read them from `self`. Your method is compiled to machine code, so keep it simple:
# numbers, `max`, `if` and loops will do.
#
# Below the check your agent races against Q-learning, Dyna-10 and R-max. The left panel shows their learning curves, and
# the right one what they do with what they know, as in "See inside". Predict: your agent has a bonus that never ends.
# What does its policy return in the end, and what the best plan by what it has seen?
#
# <details><summary>Hint</summary>First find out what the reward, the next state and the end are; for an action that was
# never taken they are 0, the state itself, and no end. The largest value in a row is <code>max(self.Q[s])</code>, and a
# root is <code>** 0.5</code>.</details>


# %%
class DynaPlus(NamedTuple):
    """Dyna-Q+ for worlds without chance."""

    Q: np.ndarray  # shape (n_states, n_actions)
    rewards: np.ndarray  # the same shape, as are the next three
    next_states: np.ndarray
    ends: np.ndarray  # 1 where the episode ended, else 0
    last: np.ndarray  # at which step the action was last taken; 0 for never
    clock: np.ndarray  # shape (1,): how many steps were taken
    seen: np.ndarray  # shape (n_states,): the states in which an action was taken
    n_seen: np.ndarray  # shape (1,): how many these are
    discount: float = 0.99
    kappa: float = 0.03
    planning_steps: int = 10

    @classmethod
    def create(cls, shop):
        """Make a new agent for a shop: nothing is known."""
        shape = n_states, _ = int(shop.observation_space.n), int(shop.action_space.n)
        numbers = [np.zeros(shape, np.int64) for _ in range(3)]
        lists = [np.zeros(1, np.int64), np.zeros(n_states, np.int64), np.zeros(1, np.int64)]
        return cls(np.zeros(shape), np.zeros(shape), *numbers, *lists)

    def learn(self, state, action, reward, next_state, terminated):
        """Remember what followed, and learn from it."""
        if max(self.last[state]) == 0:
            self.seen[self.n_seen[0]] = state
            self.n_seen[0] += 1
        self.clock[0] += 1
        self.last[state, action] = self.clock[0]
        self.rewards[state, action] = reward
        self.next_states[state, action] = next_state
        self.ends[state, action] = 1 if terminated else 0
        self.Q[state, action] = reward + (0.0 if terminated else self.discount * max(self.Q[next_state]))

    def act(self, state, rng):
        """Plan, then take the best action, but a random one with probability 0.1."""
        if self.n_seen[0] > 0:
            for _ in range(self.planning_steps):
                s = self.seen[int(rng.random() * self.n_seen[0])]
                a = int(rng.random() * self.Q.shape[1])
                self.Q[s, a] = self.imagine(s, a)
        if rng.random() < 0.1:
            return int(rng.random() * self.Q.shape[1])
        return self.greedy(state, rng)

    def greedy(self, state, rng):
        """Choose the action with the highest value; among equals, one at random."""
        best, equals = 0, 1
        for action in range(1, self.Q.shape[1]):
            if self.Q[state, action] > self.Q[state, best]:
                best, equals = action, 1
            elif self.Q[state, action] == self.Q[state, best]:
                equals += 1
                if rng.random() * equals < 1.0:
                    best = action
        return best

    def imagine(self, s, a):
        """Return the target of an imagined step, with the bonus."""
        ### BEGIN SOLUTION
        reward, next_state, ended = self.rewards[s, a], self.next_states[s, a], self.ends[s, a] == 1
        if self.last[s, a] == 0:
            reward, next_state, ended = 0.0, s, False
        bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** 0.5
        # own: bonus = self.kappa * (self.clock[0] - self.last[s, a]) ** {power}
        value = 0.0 if ended else max(self.Q[next_state])
        return reward + bonus + self.discount * value
        ### END SOLUTION


# %% tags=["check"] points=2
check(exercise_2, DynaPlus)
### BEGIN HIDDEN TESTS
check(exercise_2, DynaPlus, seed=1, quiet=True)
### END HIDDEN TESTS
display(figures.race({"my Dyna-Q+": DynaPlus.create}))

# %% [markdown]
# Look at the right panel: does it know the shop now? And does it *use* what it knows? Give it smaller values of
# $\kappa$ and race again: `figures.race({"κ = 0.005": lambda shop: DynaPlus.create(shop)._replace(kappa=0.005)})`. Each
# label in the dictionary gets a colour of its own. In a world that changes, the agent must go on asking. In this shop,
# which does not change, it should stop once it knows. That is exercise 3.
#
# <details><summary>What the race shows</summary>It knows the shop (95), but its policy returns about −485: the bonus
# outweighs the rewards. With $\kappa = 0.005$, 19 of our 20 runs got to the exit, and 11 of them returned 95. But look at what it knows, too: with a smaller bonus it tries less, and with
# $\kappa = 0.002$ it knows no more than Dyna-10.</details>

# %% [markdown]
# ### Exercise 3: write R-max
# Write R-max for a world without chance, where one try tells all about an action. `known[s, a]` is 1 for what was
# tried; all else has the value $U = 100$ in `Q` and keeps it. Complete two methods:
#
# - `learn` does nothing if the pair is known. Otherwise it remembers what followed in `rewards`, `next_states` and
#   `ends`, sets `known` to 1, and then calls `self.plan()`, which is there already: it calls your `sweep` until nothing
#   changes.
# - `sweep` goes once over all states and actions. For each *known* pair it sets $Q(s, a)$ to the reward plus
#   $\gamma \max_{a'} Q(s', a')$, or to the reward alone where the episode ended. It returns the largest change of a value
#   (0.0 if nothing changed), without its sign.
#
# Predict: how does its learning curve differ from that of the package's R-max, which keeps a second table for evaluation?
#
# <details><summary>Hint</summary>Two loops, over <code>range(self.Q.shape[0])</code> and
# <code>range(self.Q.shape[1])</code>, and <code>largest = max(largest, abs(new - old))</code>.</details>


# %%
class MyRMax(NamedTuple):
    """R-max for worlds without chance."""

    Q: np.ndarray  # shape (n_states, n_actions): U where nothing is known
    known: np.ndarray  # the same shape, as are the next three: 1 for what was tried, else 0
    rewards: np.ndarray
    next_states: np.ndarray
    ends: np.ndarray  # 1 where the episode ended, else 0
    discount: float = 0.99

    @classmethod
    def create(cls, shop):
        """Make a new agent for a shop: nothing is known, and all is wonderful."""
        shape = int(shop.observation_space.n), int(shop.action_space.n)
        numbers = [np.zeros(shape, np.int64) for _ in range(3)]
        return cls(np.full(shape, 100.0), numbers[0], np.zeros(shape), *numbers[1:])

    def act(self, state, rng):
        """Choose the action with the highest value; among equals, one at random."""
        best, equals = 0, 1
        for action in range(1, self.Q.shape[1]):
            if self.Q[state, action] > self.Q[state, best]:
                best, equals = action, 1
            elif self.Q[state, action] == self.Q[state, best]:
                equals += 1
                if rng.random() * equals < 1.0:
                    best = action
        return best

    def plan(self):
        """Sweep until nothing changes by more than 0.001, at most 100 times."""
        for _ in range(100):
            if self.sweep() < 1e-3:
                return

    def learn(self, state, action, reward, next_state, terminated):
        """Remember a pair that is new, and plan with it."""
        ### BEGIN SOLUTION
        if self.known[state, action] == 0:
            self.known[state, action] = 1
            self.rewards[state, action] = reward
            self.next_states[state, action] = next_state
            self.ends[state, action] = 1 if terminated else 0
            self.plan()
        ### END SOLUTION

    def sweep(self):
        """Update every known pair once, and return the largest change."""
        ### BEGIN SOLUTION
        largest = 0.0
        for s in range(self.Q.shape[0]):
            for a in range(self.Q.shape[1]):
                if self.known[s, a] == 1:
                    value = 0.0 if self.ends[s, a] == 1 else max(self.Q[self.next_states[s, a]])
                    new = self.rewards[s, a] + self.discount * value
                    # own: new = self.rewards[s, a] - {cost} + self.discount * value
                    largest = max(largest, abs(new - self.Q[s, a]))
                    self.Q[s, a] = new
        return largest
        ### END SOLUTION


# %% tags=["check"] points=3
check(exercise_3, MyRMax)
### BEGIN HIDDEN TESTS
check(exercise_3, MyRMax, seed=1, quiet=True)
### END HIDDEN TESTS
display(figures.race({"my R-max": MyRMax.create}, n_steps=5_000, repetitions=8))

# %% [markdown]
# ### Exercise 4: swap in a slippery lake
# The same agents learn in any Gymnasium environment with whole numbers for observations and actions. On FrozenLake the
# ice is slippery: an action goes where it should one time in three, and otherwise to the left or right of that. The
# only reward, 1, is at the goal. Predict first: will Dyna-10 with the settings of the shop be ahead of Q-learning
# here?
#
# Compare *three* methods: `Q-learning` and `Dyna-10` of `LEARNED`, and one of your own. Yours should plan too, with
# settings that fit a world with chance. Call `repeat` with 3 000 steps, 5 repetitions and 10 evaluation episodes, and
# assign the results to `lake_results`. Your method passes if it reaches the goal in at least 15 % of the evaluation
# episodes in the second half of training.
#
# <details><summary>Hint</summary>With $\alpha = 1$ a value is whatever the last sample said. The agents'
# <code>create</code> takes <code>learning_rate</code>, and that of <code>DynaQ</code> also
# <code>expected_updates=True</code>. The call is
# <code>repeat(lake, methods, 3_000, repetitions=5, evaluation_episodes=10)</code>, and <code>partial</code> makes a method:
# <code>partial(DynaQ.create, planning_steps=10, ...)</code>.</details>

# %%
lake = gym.make("FrozenLake-v1", map_name="4x4", is_slippery=True)
methods = {label: LEARNED[label] for label in ("Q-learning", "Dyna-10")}
lake_results = None
### BEGIN SOLUTION
mine = partial(DynaQ.create, learning_rate=1.0, planning_steps=10, expected_updates=True)
lake_results = repeat(lake, {**methods, "expected updates": mine}, 3_000, repetitions=5, evaluation_episodes=10)
# own: lake_results = repeat(lake, {{**methods, "expected updates": mine}}, 3_000, repetitions=5, evaluation_episodes=10, seed={experiment_seed})
### END SOLUTION

# %% tags=["check"]
check(exercise_4, lake_results)

# %% [markdown]
# <details><summary>What was measured</summary>
#
# Q-learning and Dyna-10 both hardly ever arrive; 5 runs cannot tell which is ahead. With $\alpha = 0.1$ Dyna-10 arrives
# in about half of the episodes. Q-learning still seldom does, for two reasons at least. It uses each of its 3 000 steps only once, so the
# rare 1 spreads slowly. And with first values of 0 a fall into a hole teaches nothing: with 0.000001 in place of 0 it arrives in a quarter of the episodes, and with 0.5 in half of them.
# </details>

# %% [markdown]
# ### The open challenge: know the shop in 3 000 steps
# How *early* can an agent take the best way? Write an agent of your own. It is tried in ten runs whose seeds belong to
# your name. Of the task it is told only its observation space and its action space. It needs `act` and `learn`, like
# yours of exercise 3; with a third method `greedy` it is evaluated by that. Its points are its average greedy return
# over 3 000 steps of training, in percent of 95. An agent that knew the shop from the start would get 100 points. Nobody gets them, since the
# shop must be seen first. Until its policy finds the exit it returns −425 at best: three items are worth 75, and the
# 500 steps of the episode cost 500.
#
# Everything is allowed that learns from its own steps; a map of the shop in the code is not. Half a page with it: what
# does your agent know at which time, what does it believe about what it does not know, and where would it fail?


# %%
def my_agent(shop):
    """Make the agent for the challenge; put your own in its place."""
    return RMax.create(shop, planning_steps=100)


CHALLENGE.score(my_agent, "Ada Lovelace")

# %% [markdown]
# ### From a blank file
# Now write it all yourself, from an empty cell, with NumPy and Gymnasium only: Dyna, its model and its loop, some 40
# lines. It learns from each real step, then from ten imagined ones, and chooses the next action after that.
#
# **What it must do.** `my_program(environment, n_steps, seed)` takes `n_steps` steps in a Gymnasium environment, episode after
# episode, and learns from each of them, also from one that is truncated. In the end it returns its *policy*: a function that takes a state and returns the
# action with the highest value. All else is up to you: functions, classes, any names.
#
# - States and actions are whole numbers from 0. `environment.observation_space.n` and `environment.action_space.n` say how
#   many there are. They differ from one environment to the next.
# - Take $\alpha = 1$ (for imagined steps, too), $\gamma = 0.95$ (the lesson's races had 0.99), $\varepsilon = 0.1$, ten imagined steps and first values of 0. Of equal values take any.
# - The model keeps for each pair what came of it *last*: the reward, the next state, and whether the episode terminated.
#   Draw each imagined pair anew from all that were tried: a state that was seen and an action taken there, or a pair at once.
# - Draw all random numbers from `np.random.default_rng(seed)`, and give the seed to the first `reset` alone.
#
# The check runs your program in small worlds of its own and for 2 000 steps in the shop, some ten seconds in all. It sees the steps that your
# program takes, and no line of it. So the mistake that it names is only the likely one.

# %% tags=["project"]
my_program = ...  # your program
### BEGIN PROGRAM


def choose_action(values, epsilon, rng):
    """Return an action by ε-greedy, ties broken at random."""
    if rng.random() < epsilon:
        return rng.integers(len(values))
    return rng.choice(np.flatnonzero(values == values.max()))


def my_program(environment, n_steps, seed):
    """Learn by Dyna for `n_steps` real steps, and return the greedy policy."""
    gamma, epsilon, n_imagined = 0.95, 0.1, 10
    rng = np.random.default_rng(seed)
    Q = np.zeros((environment.observation_space.n, environment.action_space.n))
    model, pairs = {}, []

    def learn(state, action):
        """Learn from what the model remembers of a pair, with α = 1."""
        reward, next_state, terminated = model[state, action]
        Q[state, action] = reward if terminated else reward + gamma * Q[next_state].max()

    state, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        action = int(choose_action(Q[state], epsilon, rng))
        next_state, reward, terminated, truncated, _ = environment.step(action)
        if (state, action) not in model:
            pairs.append((state, action))
        model[state, action] = reward, next_state, terminated
        learn(state, action)
        for number in rng.integers(len(pairs), size=n_imagined):
            learn(*pairs[number])
        state = next_state
        if terminated or truncated:
            state, _ = environment.reset()
    return lambda state: choose_action(Q[state], 0.0, rng)


### END PROGRAM

# %% tags=["project"]
from edugym_course.lessons.model_based.project import project_9

check(project_9, my_program)

# %% [markdown]
# ## What you saw
#
# ### In one paragraph
# *Learn it by heart, or better, say it in your own words.* A model says what an action would do. With it an agent can
# make updates without taking steps, so it needs fewer of them: good where steps cost much. A model may be given, or
# learned from what was tried. Planning spreads what is known through all values, in fewer updates backwards from where
# they change; it adds nothing to what is known. An agent that plans makes the most of what it has seen. If that is the whole
# world, it is done. If not, it stays with what it knows, unless it explores on purpose: slowly by random steps, or
# systematically, if it plans as if the unknown were wonderful. And since a plan is a search for the largest value, it
# is drawn to errors that look like gains.
#
# ### Limits
# The models here are tables, with one row for every state and action that was tried: they cannot say anything about the
# next cell that looks just like this one. In a world with chance a row needs many tries (exercise 4), and in one that
# changes old rows become wrong (Dyna-Q+). All shops here have the same walls: who ends highest in another world is a
# matter of measuring. Large problems need models that generalise, and those are wrong somewhere. The times of the aside
# "what does a step cost?" are computed from counts of targets.
#
# ### Further reading
# - Moerland et al. (2023), *EduGym: An environment and notebook suite for reinforcement learning education*: the
#   paper. It gives random noise in the model and a step time-out as parameters, and shows the first figure.
# - Sutton and Barto, *Reinforcement Learning*, 2nd edition: 4.3–4.4 (dynamic programming), 8.1–8.4 (Dyna, Dyna-Q+,
#   prioritised sweeping), 8.5 (expected and sample updates), 8.8–8.11 (planning to act).
# - Sutton (1990), *Integrated architectures for learning, planning, and reacting*: Dyna and Dyna-Q+.
# - Moore and Atkeson (1993), *Prioritized Sweeping: Reinforcement Learning with Less Data and Less Time*, Machine
#   Learning 13.
# - Brafman and Tennenholtz (2002), *R-max: a general polynomial time algorithm for near-optimal reinforcement learning*.
# - Moerland, Broekens, Plaat and Jonker (2023), *Model-based reinforcement learning: a survey*.
