# %% [markdown]
# # Maximisation bias: the best estimate is not the estimate of the best
#
# **The challenge.** Every machine in a casino loses. But payoffs are noisy, and after a few tries some machine looks good. Q-learning
# believes the one that looks best, and goes in.
#
# **You will be able to** say why the largest of several estimates is too high, and compute by how much; write double Q-learning
# and maxmin Q-learning; and say what these remedies cost.
#
# **Time.** {time} **Before you start.** You should know Q-learning (Sutton and Barto, 2nd edition, section 6.5). This
# lesson is about their section 6.7. All symbols are in the [table of
# notation](https://github.com/RLG-Leiden/edugym/blob/main/docs/notation.md).

# %%
import numpy as np

from edugym import DoubleQLearning, MaxminQLearning, expected_choice, expected_maximum, make_mdp, mean_interval
from edugym.envs.casino import CASINO, IN, STREET, Casino
from edugym_course.lessons.maximisation_bias import figures, methods
from edugym_course.notebook import play, predict, sliders, source

# %% [markdown]
# ## Meet the environment: a street, and a casino
#
# You stand in the street. Go home, and nothing happens. Or go into the casino, play one of its machines, and then go home.
#
# | | | in words |
# |---|---|---|
# | states | $s \in \{0, 1, 2\}$ | street, casino, home |
# | actions | $\mathcal{A} = \{0, \dots, k - 1\}$ | in the street 0 goes in, and every other action goes home; in the casino action $a$ plays machine $a$. |
# | dynamics | $p(s' \mid s, a)$ | nothing is random here |
# | reward | $r$ | a machine pays 0.9 or −1.1, each with probability 1/2: −0.1 on average |
# | discount | $\gamma = 1$ | an episode has one step or two |

# %%
source(Casino, "transition", "reward")

# %% [markdown]
# **Play it yourself.** Play some machines. Which one would you play again?

# %%
play(make_mdp("Casino"))

# %% [markdown]
# All ten machines are the same. So the exact values are simple: the casino is worth −0.1, and it is best to go home, for 0.

# %% [markdown]
# ## The idea: the maximum picks the lucky one
#
# ### What does the largest of ten means promise?
# Try each machine $n$ times, and let $Q(a)$ be the mean of its payoffs. On average $Q(a)$ is −0.1, as it should be. But we want the value of
# the *casino*, and Q-learning takes $\max_a Q(a)$ for it.
#
# **Predict.** Try each of the ten machines five times, and take the largest mean. Do this many times. What is the largest mean
# *on average*?

# %%
largest = predict("On average the largest of ten means is ...", unit="coins (each machine loses 0.1)")
largest

# %%
rng = np.random.default_rng(1)
means = rng.choice([0.9, -1.1], (10, 5)).mean(axis=1)
print("one draw of ten means:", means.round(1))
print(f"their average is {means.mean():.2f}, the largest {means.max():.2f}, and the truth -0.10")
machines = make_mdp("Casino").payoffs
print(f"largest, 1000 draws: {mean_interval(methods.tried(5).largest)}, exact {expected_maximum(machines, 5):.3f}")
largest.measured(expected_maximum(machines, 5))

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** 0.56, computed exactly: ten machines that all lose promise a gain of more than half a coin. Noise does average out in *each* mean. In their maximum
# it does not, for the maximum looks for the mean with the largest error. Good and bad luck cancel out only if you do not choose.
# </details>

# %% [markdown]
# The difference from the truth is the *maximisation bias*. It can be computed without any simulation. Let $F(x)$ be the probability that the mean of
# one machine is at most $x$. The largest of $k$ means is at most $x$ if all of them are: with probability $F(x)^k$. A mean
# of $n$ tries has only $n + 1$ values $x_0 < \dots < x_n$, so
#
# $$
# \mathrm{E}\left[\max_a Q(a)\right] = \sum_{i=0}^{n} x_i \left( F(x_i)^k - F(x_{i-1})^k \right)
# $$
#
# with $F(x_{-1}) = 0$. `expected_maximum` is this sum. (Exercise 1 is to write it.) The figure shows it in black, and simulations in colour.

# %%
figures.measured_promises()

# %% [markdown]
# More tries make the bias smaller, and more machines make it larger. With *one* machine there is none: there is nothing to choose.
#
# ### Two remedies
# **Double Q-learning** keeps two tables. A coin says which one learns. It chooses the best action by its own values, and asks the *other* table what
# that action is worth. With probability 1/2
#
# $$
# Q_1(S, A) \leftarrow Q_1(S, A) + \alpha \left[ R + \gamma\, Q_2\!\left(S', \arg\max_a Q_1(S', a)\right) - Q_1(S, A) \right]
# $$
#
# and else the same with $Q_1$ and $Q_2$ swapped. If a machine looks good in $Q_1$ by luck, $Q_2$ has had luck of its own. An agent acts $\varepsilon$-greedily by the mean of both tables.
# (Where several actions are best in $Q_1$, our code takes the mean of $Q_2$ over them. `act` throws the coin that says which table learns.)

# %%
source(DoubleQLearning, "learn")

# %% [markdown]
# **Maxmin Q-learning** keeps $N$ tables, and takes the *smallest* of their values for each action. One table, drawn at random, learns:
#
# $$
# Q(s, a) = \min_i Q_i(s, a), \qquad
# Q_i(S, A) \leftarrow Q_i(S, A) + \alpha \left[ R + \gamma \max_a Q(S', a) - Q_i(S, A) \right]
# $$
#
# It acts $\varepsilon$-greedily by $Q(s, a)$. The maximum is too high, the minimum is too low, and the number of tables sets the balance. With one table it is Q-learning.

# %%
source(MaxminQLearning, "learn")

# %% [markdown]
# ## The experiment: who goes in?
#
# This is after figure 6.5 of the book. There payoffs are normal; ours have the same mean and the same spread,
# but two values only, so that the bias can be computed. And in the book's street there are two actions, so that by chance one goes in every
# second time; here there are ten.
#
# | setting | value |
# |---|---|
# | machines | $k = 10$, each with payoffs −0.1 ± 1 |
# | learners | $\alpha = 0.1$, $\varepsilon = 0.1$, $\gamma = 1$, first values 0 |
# | repetitions | 100; bands are 95 % intervals |
#
# The dashed line is the best policy that takes a random action in a share $\varepsilon$ of its steps: it enters the casino in 1 % of the episodes. Expected
# SARSA (section 6.6 of the book) learns from the mean over what its $\varepsilon$-greedy policy does next.
#
# **Predict.** In which order, from the most visits to the fewest, are Q-learning, expected SARSA and double Q-learning in episodes 31 to 100?

# %%
order = predict(
    "From the most visits to the fewest ...",
    [
        "Q-learning, expected SARSA, double Q-learning",
        "expected SARSA, Q-learning, double Q-learning",
        "double Q-learning, Q-learning, expected SARSA",
        "all three go in equally often",
    ],
)
order

# %%
found = {method: methods.walks(method) for method in methods.IN_THE_FIGURE}
display(figures.visits(found))
share = {method: one.share().mean() for method, one in found.items()}
for method, visits in share.items():
    later = found[method].share(slice(200, 300)).mean()
    print(f"{method:25} goes in: {visits:4.0%} of episodes 31 to 100, {later:4.0%} of 201 to 300")
q, expected, double = share["Q-learning"], share["expected SARSA"], share["double Q-learning"]
order.measured(order.options[0 if q > expected + 0.05 > double + 0.1 else 1 if expected > q else 3])

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Q-learning, expected SARSA, double Q-learning: 71 %, 46 % and 9 %. At first nobody knows the casino, and all go in by chance, in one of ten episodes. Then some machine has paid.
# Q-learning believes it, goes in, and plays it until it has lost enough; then it plays the next one. In the last 100 episodes it
# seldom goes in. In episodes 31 to 100 maxmin Q-learning with two
# tables goes in less often than Q-learning, too: 11 %. In the last 100 it goes in no less often than Q-learning. Why, and why expected SARSA still goes in then, we have not tested.
# </details>

# %% [markdown]
# ## Your turn
#
# How much does it take? Change the number of machines, the noise, and the number of tables. (20 runs. What happens without any
# noise, and with eight tables, you predict below.)


# %%
def one_setting(n_machines=10, noise=1.0, n_tables=2):
    """Draw how often three methods go in."""
    return figures.one_setting(n_machines, noise, n_tables)


sliders(one_setting, n_machines=[2, 5, 10, 20], noise=[0.5, 1.0, 2.0], n_tables=[1, 2, 4])

# %% [markdown]
# <details><summary>What to look for</summary>
#
# The more machines there are, the more often Q-learning goes in, although by chance one goes in the less often: in
# one of $k$ episodes. With less noise it goes in less often, though with 20 machines 20 runs are too few to tell a noise of 1 from 2.
# With one table maxmin Q-learning is Q-learning (with other random numbers). With four it goes in about as often as by chance with 10 or 20 machines, and less often with 2 or 5.
# </details>

# %% [markdown]
# ## See inside: what a learner believes
#
# One Q-learner, after 60 episodes. What does it think each machine is worth?

# %%
casino = make_mdp("Casino")
learner = methods.agent_of("Q-learning", casino)
went_in, earned = methods.walk(casino, learner, 60, seed=9)
print("Q in the casino:", learner.Q[CASINO].round(2))
print(f"truth: -0.10 each; their mean is {learner.Q[CASINO].mean():.2f}, and the largest {learner.Q[CASINO].max():.2f}")
print(f"going in seems to be worth {learner.Q[0, 0]:.2f}, and it went in {went_in.sum():.0f} times in 60 episodes")

# %% [markdown]
# The largest value is well above the truth, and that one is what the street learns from. Is this learner an exception? Here are a hundred:

# %%
Q_values = methods.values("Q-learning", 60)[:, CASINO]
print(f"mean of the ten values: {mean_interval(Q_values.mean(axis=1))}, largest: {mean_interval(Q_values.max(axis=1))}")
print(f"still 0: {(Q_values == 0).mean():.0%} of the values")

# %% [markdown]
# On average the ten values are a little too high, for they begin at 0: the values of machines that were not tried, 23 % of all, are still 0, and the
# others still hold a part of that 0. The largest is much too high: it promises a gain.

# %% [markdown]
# ## Predict, then check
#
# ### Is it the noise?
# Take the cause away: every machine pays −0.1, always.
#
# **Predict.** In which share of episodes 31 to 100 does Q-learning go in now? (With noise it was 71 %.)

# %%
quiet = predict("Without noise it goes in ...", unit="% of the time")
quiet

# %%
still = methods.walks("Q-learning", 100, noise=0.0).share().mean()
print(f"no noise: {still:.0%}")
print(f"with noise, {methods.RIGHT_AT_FIRST}: {methods.walks(methods.RIGHT_AT_FIRST, 100).share().mean():.0%}")
quiet.measured(100 * still)

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** 9 %, about what chance gives (10 %). Until all ten machines have been tried, the largest value in the casino is 0, the
# first value of a machine that was not tried; so home and casino seem equally good. So most of the 71 % comes from the noise. But noise alone does little here: from first values that are right it goes in in 1 %.
# </details>

# %% [markdown]
# ### Has the second opinion a bias?
# Two tables; each has its own five tries of every machine. One says which machine is best, the other what that machine is worth. Now let the machines differ: nine
# lose 0.1 as before, and the tenth *wins* 0.2 on average. So the casino is worth 0.2.
#
# **Predict.** On average the other table says of the machine that looks best ...

# %%
second = predict("The second opinion is on average ...", ["above 0.2", "0.2, since it has no bias", "below 0.2"])
second

# %%
for advantage in (0.0, 0.3):
    machines_now = make_mdp("Casino", advantage=advantage).payoffs
    truth = machines_now.mean(axis=1).max()
    first = expected_maximum(machines_now, 5)
    other = expected_choice(machines_now, 5)
    simulated = mean_interval(methods.tried(5, advantage=advantage, repetitions=10_000, seed=1).second_opinion)
    print(f"truth {truth:5.2f}: largest mean {first:.2f}, second opinion {other:.3f}, 10 000 draws: {simulated}")
print(f"the machine that wins was chosen with a probability of {(other + 0.1) / 0.3:.0%}")
second.measured(second.options[0 if other > truth + 0.02 else 2 if other < truth - 0.02 else 1])

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Below 0.2: it is −0.04. The second opinion is right about the machine *that was chosen*. But after five tries only 20 % of the choices are the best machine, and
# every other machine is worth less. So this estimator is not without bias. It is never too high on average: it has no bias where all machines are equal, and a
# downward one where a worse machine may be chosen. Double Q-learning asks for such a second opinion in each update that does not end the episode. The exact sum needs no simulation here either
# (`expected_choice`).
# </details>

# %% [markdown]
# ### What does the remedy cost?
# A casino that pays: of three machines the last one pays 1.9 or −0.1, so 0.9 on average, and the others lose 0.1. Now it is best to go in.
#
# **Predict.** Who earns the least in episodes 301 to 600?

# %%
poorest = predict(
    "The least earns ...",
    ["Q-learning", "double Q-learning", "maxmin Q-learning, N = 8", "nobody: all have found the machine by then"],
)
poorest

# %%
learners = ("Q-learning", "double Q-learning", "maxmin Q-learning, N = 2", "maxmin Q-learning, N = 8")
paying = {method: methods.walks(method, methods.LONG, repetitions=50, **methods.PAYING) for method in learners}
display(figures.incomes(paying, methods.best_income()))
income = {method: one.income().mean() for method, one in paying.items()}
for method, earned in income.items():
    early = paying[method].income(slice(0, 300)).mean()
    print(f"{method:25} earns {early:.2f} in episodes 1 to 300, {earned:.2f} in 301 to 600")
least = min(income, key=income.get)
poorest.measured(least if income[least] < max(income.values()) - 0.05 else poorest.options[-1])

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** Maxmin Q-learning, N = 8, by far: it earns 0.03, where Q-learning earns 0.76. Double Q-learning and maxmin Q-learning with two tables earn less than Q-learning in the first 300 episodes.
# </details>
#
# Is it the bias? Without noise there is no bias, and an agent that acts at random tries the machine whatever it believes:

# %%
for method in learners[:-1]:
    quiet_walks = methods.walks(method, methods.LONG, repetitions=50, noise=0.0, **methods.PAYING)
    print(f"without noise {method} earns {quiet_walks.income(slice(0, 300)).mean():.2f} in episodes 1 to 300")
still = methods.walks(learners[-1], methods.LONG, repetitions=20, noise=0.0, **methods.PAYING).income().mean()
print(f"without noise {learners[-1]} earns {still:.2f} late; the best ε-greedy policy {methods.best_income():.2f}")
for actions, epsilon in (("its own", methods.EPSILON), ("random", 1.0)):
    eight = methods.values(learners[-1], methods.LONG, epsilon=epsilon, **methods.PAYING)
    goes_in, entry, machine = methods.goes_in(eight), eight[:, STREET, IN] < 0, eight[:, CASINO, 2] < 0
    print(f"N = 8, actions {actions}: {goes_in.mean():.0%} of the runs prefer to go in;", end=" ")
    print(f"{entry.mean():.0%} put going in below 0, and {machine.mean():.0%} the machine")

# %% [markdown]
# With N = 8, yes. Without noise it earns 0.77, nearly the most there is (0.78). With noise the smallest of eight values of going in is below 0 in all runs (and in 83 % of them that of the good machine), so the agent stays outside. And whoever
# stays outside gets few tries that could correct the value: with random actions 74 % of the runs learn in 600 episodes that going in is best, and with its own 0 %. Of the small losses of double Q-learning and N = 2 in the first 300 episodes,
# a part is no bias: without noise they earn 0.68 and 0.73 there, and Q-learning 0.76. Each of their tables learns from a part of the steps.
#
# So pessimism is not free. Who thinks too much of a place goes there, and sees. Who thinks too little of it stays away for long.

# %% [markdown]
# How much of the bias do more tables take away? Here is the largest estimate on average in the casino that does *not* pay, where each table has had its own $n$ tries of each machine (computed, not simulated):

# %%
print("tries   " + "".join(f"N = {n_tables:<6}" for n_tables in (1, 2, 4, 8)))
for n_tries in (1, 5, 20, 100):
    promised = [expected_maximum(machines, n_tries, n_tables=n_tables) for n_tables in (1, 2, 4, 8)]
    print(f"{n_tries:5}   " + "".join(f"{value:<10.2f}" for value in promised))

# %% [markdown]
# The truth is −0.10 everywhere. One table promises too much, and eight promise too little. With four the bias is nearly gone, *for ten equal machines*. A learner's tables begin at 0 and learn in turns, so
# these numbers are not theirs.

# %% [markdown]
# ## Exercises
#
# Each exercise has a cell for your answer, and below it a cell that checks it: it says what was expected, what came, and
# which mistake that looks like.

# %%
from edugym_course.grading import check
from edugym_course.lessons.maximisation_bias.exercises import exercise_1, exercise_2, exercise_3

# %% [markdown]
# ### Exercise 1: what the largest mean promises
# Each of `n_machines` machines pays `win` or `lose`, each with probability 1/2, and `win` is the larger one. Each was tried `n_tries` times. Return what the largest of their mean
# payoffs is on average, exactly: the sum above.
#
# <details><summary>Hint</summary>The number of wins of one machine goes from 0 to n. It is w with the probability
# <code>comb(n_tries, w) * 0.5**n_tries</code>, and F is the sum of these so far.</details>

# %%
from math import comb


def largest_promise(n_machines, n_tries, win, lose):
    """Return what the largest mean payoff is on average."""
    ### BEGIN SOLUTION
    promise, F, before = 0.0, 0.0, 0.0
    for wins in range(n_tries + 1):
        F += comb(n_tries, wins) * 0.5**n_tries
        # own: F += comb(n_tries, wins) * {chance}**wins * (1 - {chance}) ** (n_tries - wins)
        mean = (wins * win + (n_tries - wins) * lose) / n_tries
        promise += mean * (F**n_machines - before)
        before = F**n_machines
    return promise
    ### END SOLUTION


# %% tags=["check"] points=2
check(exercise_1, largest_promise)
### BEGIN HIDDEN TESTS
check(exercise_1, largest_promise, seed=1, quiet=True)
### END HIDDEN TESTS

# %% [markdown]
# ### Exercise 2: the update of double Q-learning
# Change `Q1` if `first` is True, and else `Q2`: one entry, in place. Both are arrays of shape (S, A). Where several actions are best, take any of them. Return nothing.
#
# <details><summary>Hint</summary>First give the two tables the names <code>own</code> and <code>other</code>. Then there is one update to
# write. An array changes for everybody who holds it.</details>


# %%
def double_update(Q1, Q2, first, state, action, reward, next_state, terminated, learning_rate, discount):
    """Learn from one step by double Q-learning."""
    ### BEGIN SOLUTION
    own, other = (Q1, Q2) if first else (Q2, Q1)
    target = reward
    # own: target = reward - {cost}
    if not terminated:
        target += discount * other[next_state, own[next_state].argmax()]
    own[state, action] += learning_rate * (target - own[state, action])
    ### END SOLUTION


# %% tags=["check"] points=2
check(exercise_2, double_update)
### BEGIN HIDDEN TESTS
check(exercise_2, double_update, seed=1, quiet=True)
### END HIDDEN TESTS

# %% [markdown]
# ### Exercise 3: the target of maxmin Q-learning
# `tables` is an array of shape (N, S, A). Return the target of an update, a number.
#
# <details><summary>Hint</summary><code>tables[:, next_state]</code> has shape (N, A). Over which axis goes the minimum?</details>


# %%
def maxmin_target(tables, reward, next_state, terminated, discount):
    """Return the target of maxmin Q-learning."""
    ### BEGIN SOLUTION
    if terminated:
        return reward
        # own: return reward - {cost}
    return reward + discount * tables[:, next_state].min(axis=0).max()
    # own: return reward - {cost} + discount * tables[:, next_state].min(axis=0).max()
    ### END SOLUTION


# %% tags=["check"]
check(exercise_3, maxmin_target)
### BEGIN HIDDEN TESTS
check(exercise_3, maxmin_target, seed=1, quiet=True)
### END HIDDEN TESTS

# %% [markdown]
# ### From a blank file
# Now write double Q-learning from an empty cell, with NumPy alone: some 20 lines.
#
# **What it must do.** `my_program(environment, n_steps, seed)` takes `n_steps` steps in a Gymnasium environment, episode after
# episode, and returns its policy, a function from a state to the best action. States and actions are whole numbers, from 0 to
# `environment.observation_space.n - 1` and `environment.action_space.n - 1`.
#
# - $\alpha = 0.1$, $\gamma = 1$, $\varepsilon = 0.1$, and first values of 0. The update is that of exercise 2; only `terminated` means that nothing follows.
# - To *act*, the best action is that with the largest sum $Q_1(s, a) + Q_2(s, a)$. Among equals draw one at random, anew in each step: in the beginning all are equal.
# - Random numbers come from `rng = np.random.default_rng(seed)`, also the coin. It is a fair one: draw another number for it than the one that is compared with $\varepsilon$. The first reset is `environment.reset(seed=seed)`.
#
# The check first runs it in tiny tasks, many of one or two steps. In each of them the best action in the end hangs on one part of the method. Then it runs it in casinos whose states and
# actions are numbered anew each time. Where no machine pays, it must enter in less than a quarter of episodes 31 to 100 (right programs do in 6 to 22 %); where one pays, its policy must play that one in four of five runs.
# <details><summary>A plan</summary>Reset. In each step: choose the action, step, throw the coin, change one table by exercise 2, and go on from the next state, or
# from a new reset if <code>terminated</code> or <code>truncated</code> is True. (The target of a step that is merely truncated has its
# future.)</details>

# %% tags=["project"]
my_program = ...  # your program


### BEGIN PROGRAM
def my_program(environment, n_steps, seed):
    """Learn by double Q-learning."""
    rng = np.random.default_rng(seed)
    n_actions = environment.action_space.n
    Q = np.zeros((2, environment.observation_space.n, n_actions))

    def best(state):
        values = Q[0, state] + Q[1, state]
        return rng.choice(np.flatnonzero(values == values.max()))

    state, _ = environment.reset(seed=seed)
    for _ in range(n_steps):
        action = rng.integers(n_actions) if rng.random() < 0.1 else best(state)
        next_state, reward, terminated, truncated, _ = environment.step(action)
        own, other = rng.permutation(2)
        future = 0.0 if terminated else Q[other, next_state, Q[own, next_state].argmax()]
        Q[own, state, action] += 0.1 * (reward + future - Q[own, state, action])
        state = next_state
        if terminated or truncated:
            state, _ = environment.reset()
    return best


### END PROGRAM

# %% tags=["project"]
from edugym_course.lessons.maximisation_bias.project import project_17

check(project_17, my_program)

# %% [markdown]
# ## What you saw
#
# - Ten machines that lose 0.1 each promise 0.56 after five tries of each: the largest of several estimates is too high, though each one is right on average.
# - The bias is a finite sum, and simulation agrees with it. It grows with the number of machines, and gets smaller with the number of tries.
# - Q-learning entered the casino in 71 % of episodes 31 to 100, expected SARSA in 46 %, double Q-learning in 9 %. Without noise Q-learning did so in 9 %, and with right first values in 1 or 2 %.
# - A second opinion has no bias where all actions are equal. Where a worse one may be chosen its bias is downward: −0.04 where the truth was 0.2.
# - Maxmin Q-learning sets the balance by its number of tables. With eight it stayed outside a casino that pays, for all 600 episodes.
#
# ### In one paragraph
# *Learn it by heart, or better, say it in your own words.* Q-learning takes the largest of its estimates for the value of a state. The largest one is
# mostly one that was lucky, so the value is too high, the more so the more actions there are. If one set of experiences chooses the
# action and another one says what it is worth, the luck of the choice does not count; but the choice may be wrong, and then the value is
# too low. Both remedies of this lesson move the bias, and both had a price where a machine paid.
#
# ### Limits
# A table and an episode of two steps show the bias itself. In longer tasks it is carried back from state to state, and
# a network spreads it to states that look alike; that is where double DQN comes from. Here $\alpha$ stays 0.1, so a value is no mean of all
# tries: recent ones count more. The exact sums are for means. In a casino that does not pay, the bias only harms. Elsewhere it is also a reason to
# try what is uncertain: lesson 1 has agents that are too hopeful on purpose.
#
# ### Further reading
# - Thrun and Schwartz (1993), *Issues in using function approximation for reinforcement learning*: the bias.
# - van Hasselt (2010), *Double Q-learning*; van Hasselt, Guez and Silver (2016), *Deep reinforcement learning with double Q-learning*.
# - Lan, Pan, Fyshe and White (2020), *Maxmin Q-learning: controlling the estimation bias of Q-learning*.
# - Smith and Winkler (2006), *The optimizer's curse*: the same in decisions of firms.
# - Sutton and Barto, *Reinforcement Learning*, 2nd edition: 6.7 (example 6.7, figure 6.5), 6.6 (expected SARSA).
