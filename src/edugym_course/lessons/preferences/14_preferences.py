# %% [markdown]
# # Preferences: a teacher compares
#
# **The challenge.** Nobody can write down the reward, but somebody can say which of two nights was better. So a reward is learned from such
# comparisons, and an agent follows it. How far may it follow a reward that was learned?
#
# **You will be able to** write the probability of a preference, and learn rewards from comparisons by gradient steps;
# tune a policy to a learned reward with a penalty for leaving a reference policy; measure over-optimisation; and say
# what helps against it and what does not.
#
# **Time.** {time} **Before you start.** You should know
# value iteration (Sutton and Barto, 2nd edition, section 4.4), and the morning of lesson 10, which is shown again here. All symbols
# are in the [table of notation](https://github.com/RLG-Leiden/edugym/blob/main/docs/notation.md).

# %%
import numpy as np

from edugym import (
    finite_model,
    fit_rewards,
    policy_evaluation,
    preference,
    regularised_iteration,
    regularised_policy,
    value_iteration,
    with_rewards,
)
from edugym_course.lessons.own_problem.morning import Morning
from edugym_course.lessons.preferences import figures, methods
from edugym_course.notebook import play, predict, sliders, source

# %% [markdown]
# ## Meet the environment: the morning again, without its reward
#
# An alarm clock may stay quiet, chime or ring, every ten minutes from 7:10 on. At 8:30 the episode ends;
# here an episode is called a night. The sleeper is fast asleep at first. She should sleep as long as possible, and be awake in the end.
#
# | | | in words |
# |---|---|---|
# | states | $s = (t, d)$ | the steps that have passed, and the depth of sleep: 0 awake, 1 dozing, 2 fast asleep |
# | actions | $\mathcal{A} = \{0, 1, 2\}$ | stay quiet, chime, ring |
# | dynamics | $p(s' \mid s, a)$ | a ring nearly always wakes her, a chime makes her sleep lighter, in silence her sleep gets deeper |
# | reward | $r(s, a, s')$ | **hidden from the clock**: only the teacher knows it |
# | discount | $\gamma = 1$ | a night has eight steps |
#
# In lesson 10 we chose the numbers of the reward by feeling: 4 for a ring, 10 for oversleeping. Here we keep that
# reward as what is *meant*, so that we can measure how good a clock really is. But the clock
# never sees it.

# %%
source(Morning, "transition", "reward")

# %% [markdown]
# **Play it yourself.** Play two nights. Which one was better? You can say that, even if you forget all the numbers.

# %%
play(Morning())

# %% [markdown]
# The clock comes from a factory. Half of the time it does what is best, half of the time it presses a button at random. This is
# the *reference policy* $\pi_{\text{ref}}$. A language model that imitates texts is such a policy: not good enough, but
# far better than chance. (We make it from the optimum, so it knows a part of what is meant.)

# %%
model = finite_model(Morning())
reference = methods.half_right(Morning())
print(f"random buttons: {policy_evaluation(model, np.full_like(reference, 1 / 3)).start:6.2f}")
print(f"reference:      {policy_evaluation(model, reference).start:6.2f}")
print(f"optimum:        {value_iteration(model).start:6.2f}")

# %% [markdown]
# ## The idea: find rewards that explain the preferences
#
# ### What a preference says
# A teacher sees two nights, worth $G_1$ and $G_2$ to her, and says which one she prefers. She is not always right. In the model of
# Bradley and Terry (1952) she prefers the first with probability
#
# $$
# p = \sigma\!\left(\frac{G_1 - G_2}{\tau}\right), \qquad \sigma(x) = \frac{1}{1 + e^{-x}}
# $$
#
# The noise $\tau$ says how often she errs. Two nights that are equally good are a toss of a coin; if one is better by much more than
# $\tau$, she is sure.

# %%
for noise in (0.1, 1.0, 10.0):
    told = ", ".join(f"{difference}: {preference(difference, 0.0, noise):.2f}" for difference in (0, 1, 3, 10))
    print(f"τ = {noise:4}: p of the first, if it is better by {told}")

# %% [markdown]
# ### Rewards as weights
# Let $\hat r(s, a)$ be a table of rewards that we do not know yet. A night is then worth the sum of the $\hat r$ of its steps. We look
# for the table under which the preferences that the teacher gave are most likely. One gradient step for one comparison is
#
# $$
# \hat r(s, a) \leftarrow \hat r(s, a) + \alpha\, (y - p)\, \bigl[ n_1(s, a) - n_2(s, a) \bigr]
# $$
#
# where $y$ is 1 if she preferred the first night and else 0, $p$ is what the table says about that (with $\tau = 1$: rewards are
# learned in units of the noise), and $n_1$, $n_2$ count how often
# each night took action $a$ in state $s$. It reads like the updates that you know: a rate, an error, and where to put it.
# What surprises most is learned most. The package makes the logarithm of the likelihood of all comparisons as large as possible, by Newton's method. A *prior* $\lambda$ takes
# $\frac{\lambda}{2} \sum \hat r^2$ off it: the larger $\lambda$ is, the smaller the rewards are on the whole, and those that nothing is known of stay 0.
#
# ### Follow the reward, with a penalty
# Now we have a reward, and any method of this course can maximise it. In practice one does not maximise it freely: each step is charged for
# leaving the reference policy, with a *penalty* $\beta$. The policy maximises
#
# $$
# \mathrm{E}\left[ \sum_t \hat r(S_t, A_t) - \beta\, D(S_t) \right], \qquad
# D(s) = \sum_a \pi(a \mid s) \ln \frac{\pi(a \mid s)}{\pi_{\text{ref}}(a \mid s)}
# $$
#
# $D$ is the Kullback-Leibler divergence, in *nats*: 0 if the policy does in $s$ what the reference does, and the larger
# the further it goes. The best policy is known in closed form. With $Q(s, a) = \hat r(s, a) + \sum_{s'} p(s' \mid s, a)\, V(s')$, as in value
# iteration, the maximum becomes a soft one,
#
# $$
# V(s) = \beta \ln \sum_a \pi_{\text{ref}}(a \mid s)\, e^{Q(s, a) / \beta}, \qquad
# \pi(a \mid s) = \pi_{\text{ref}}(a \mid s)\, e^{(Q(s, a) - V(s)) / \beta}
# $$
#
# With a large $\beta$ the policy stays with the reference. As $\beta$ goes to 0, it only follows the reward.

# %% [markdown]
# ## The experiment: a hundred comparisons
#
# The factory shows a teacher a hundred pairs of nights ($\tau = 1$). This is the whole experiment, once:

# %%
rng = np.random.default_rng(1)
first, first_returns = methods.nights(model, reference, 100, rng)  # visits (100, S, A), returns (100,)
second, second_returns = methods.nights(model, reference, 100, rng)
prefers_first = rng.random(100) < preference(first_returns, second_returns, noise=1.0)

learned = with_rewards(model, fit_rewards(first, second, prefers_first))
for penalty in (30.0, 3.0, 1.0):
    values = regularised_iteration(learned, reference, penalty)
    policy = regularised_policy(values, reference, penalty)
    by_learned, by_meant = (policy_evaluation(judge, policy).start for judge in (learned, model))
    print(f"β = {penalty:5}: learned return {by_learned:5.2f}, meant return {by_meant:5.2f}")

# %% [markdown]
# (Only differences of learned returns mean something. A number that is added to the rewards of all nights alike changes no
# comparison.)
#
# | setting | value |
# |---|---|
# | comparisons | 100 pairs of nights of the reference policy, $\tau = 1$ |
# | learned reward | a table, prior 0.1 |
# | policies | the best ones for $\beta$ from 30 to 0.1, and for $\beta = 0$; all returns are exact |
# | repetitions | 100, each with other nights and other preferences; bands are 95 % intervals |
#
# The x axis is how far the policy goes from the reference: the sum of $D$ over the steps of a night, on average. The thin black dashed line at the top is
# the best gain over the reference that there is, 10.1. Learned and meant gains are on different scales, so look at where a line rises and falls, not at its height. (An aside says why.)
#
# **Predict.** We lower the penalty, so that the policy follows the learned reward more and more. What does the *meant* return do?

# %%
further = predict(
    "With less and less penalty the meant return ...",
    ["rises to the end", "rises, and stays at its highest", "rises, and then falls", "falls from the start"],
)
further

# %%
hundred = methods.followed()
display(figures.gains({"100 comparisons": hundred}))
meant = hundred.meant.mean(axis=1)
print(f"meant gain: highest {meant.max():.2f}, at the end {meant[-1]:.2f}")
print(f"fall from β = 0.5, where the gain is highest, to β = 0: {hundred.fall().mean():.2f}")
further.measured("rises, and then falls" if meant.max() - meant[-1] > 0.3 else "rises to the end")

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** It rises, and then falls. Up to some three nats from the reference, as far as the
# best clock would go, both returns rise together. Then the learned one
# still rises, and the meant one falls by about 1. This is called *over-optimisation* (Gao, Schulman and Hilton, 2023, measured it
# with language models). What the clock gets better at, from there on, is no longer what the teacher wants. The clock itself cannot see it:
# by its own reward all goes well.
# </details>

# %% [markdown]
# ## Your turn
#
# Does the fall go away with more comparisons? Is a weaker prior (rewards may be large) better or worse? (30 runs.)


# %%
def one_setting(n_comparisons=100, noise=1.0, prior=0.1):
    """Draw what the policies gain, by the learned and by the meant reward."""
    return figures.one_setting(n_comparisons, noise, prior)


sliders(one_setting, n_comparisons=[10, 30, 100, 300, 1000], noise=[1.0, 3.0, 10.0], prior=[0.01, 0.1, 1.0, 10.0])

# %% [markdown]
# <details><summary>What came out</summary>
#
# From its highest point the gain fell by 1.6 with 10 comparisons, 0.6 to 0.8 with 30 to 300, and 0.3 with 1 000. A weaker prior was worse, a stronger one reached a higher top. With $\tau = 3$ it fell more; with $\tau = 10$
# and 100 comparisons the clock became worse than the factory's, while the learned return rose as ever.
# </details>

# %% [markdown]
# ## See inside: a second opinion
#
# Let another hundred comparisons, of other nights, teach a *second* reward. Nobody follows it. It only judges the policies that
# follow the first:

# %%
thousands = methods.followed(n_comparisons=3000, repetitions=20)
figures.gains({"100 comparisons": hundred, "3000 comparisons": thousands}, second=True)

# %% [markdown]
# Compare the first learned reward with the
# *second* one: both were learned in the same way, and each is as good as the other. On the left they disagree more and more. In
# the end the second promises half as much for these policies, and it *falls*, as the meant reward does. So the first reward
# is too high in just those places where its policy goes. That is no accident: each learned reward has errors, some too high
# and some too low, and whoever looks for the highest return goes where they are too high. (So does Q-learning with its
# maximum: the maximisation bias of Sutton and Barto, section 6.7. There a second table is one remedy.)
#
# On the right there are 3 000 comparisons, in 20 repetitions. The errors are small, both rewards agree, and the meant return rises nearly to the end. (Both
# promise only half of what is meant: an aside says why.)
#
# The reference matters, too: ours was made from the best clock. With a penalty for leaving *random buttons* the meant
# return only rises, to the same 7.4 at $\beta = 0$, and never to 8.3 (100 runs).

# %% [markdown] tags=["aside"]
# ### Aside: why both promise only half
# The luck of a step shows in the state that comes next, which has a reward of its own in the table. But after the last step
# none comes: whether she is awake at 8:30 looks like noise. And rewards are learned in units of the noise, so more of it makes all of them smaller.
#
# We test this with two teachers. For one, only the last step has no luck: it brings what it brings *on average*. For the other, all steps but the last are so. If the reason is right, rewards learned from the first
# promise a gain of about 10.1 for the best clock, and those from the second do not:

# %%
on_average = (model.probabilities * model.rewards).sum(axis=2, keepdims=True)
last = np.array([time == 7 for time, _ in model.states])[:, None, None]
best_clock = value_iteration(model).greedy_policy()
for name, steps in {"the last step": last, "all steps but the last": ~last}.items():
    paid = model._replace(rewards=np.where(steps, on_average, model.rewards))
    (one, its_return), (other, other_return) = (methods.nights(paid, reference, 3000, rng) for _ in range(2))
    answers = rng.random(3000) < preference(its_return, other_return, noise=1.0)
    fair = with_rewards(model, fit_rewards(one, other, answers))
    promised = policy_evaluation(fair, best_clock).start - policy_evaluation(fair, reference).start
    print(f"without the luck of {name}, the gain that is promised of the best clock: {promised:.1f}")

# %% [markdown]
# ## Predict, then check
#
# ### Is it the teacher's fault?
# Many would say: the teacher errs, so her reward is wrong. She errs in 3 or 4 of a hundred comparisons. Would one who never errs, $\tau = 0$, cure it?
#
# **Predict.** A hundred comparisons, none of them wrong. How far does the meant return fall from $\beta = 0.5$ to $\beta = 0$?

# %%
never_wrong = predict(
    "With a teacher who is never wrong the fall is ...", ["gone", "about half as large", "about as large"]
)
never_wrong

# %%
sure = methods.followed(noise=0.0)
display(figures.gains({"τ = 1": hundred, "τ = 0": sure}))
share = sure.fall().mean() / hundred.fall().mean()
print(f"the fall: {hundred.fall().mean():.2f} with τ = 1, {sure.fall().mean():.2f} with τ = 0")
never_wrong.measured(never_wrong.options[0 if share < 0.25 else 1 if share < 0.65 else 2])

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** About as large. A hundred answers, all of them right, still say little about a table of 66 numbers (22 states, three actions). Errors of the teacher make
# the fall larger, if there are many (the sliders show $\tau = 10$); but without any the return still falls.
# </details>

# %% [markdown]
# ### Is it what was hardly ever tried?
# The reference policy rings at 7:10 in one night of six, and so in some 33 of the 200 nights that were compared. Perhaps the learned
# reward is wrong only about such rare actions? Then compare nights of *random* buttons, in which every action comes as often as
# any other.
#
# **Predict.** The rewards are learned from a hundred pairs of random nights, and followed with the same penalties for leaving the
# factory's clock. Does it still fall, and is the clock better or worse with $\beta = 0.5$?

# %%
everywhere = predict(
    "With comparisons of random nights ...",
    [
        "the fall is gone, and the clock is better",
        "the fall is gone, and the clock is worse",
        "it falls, and the clock is worse",
    ],
)
everywhere

# %%
random = methods.followed(at_random=True)
display(figures.gains({"nights of the reference": hundred, "random nights": random}))
print(f"the fall: {hundred.fall().mean():.2f} of the reference, {random.fall().mean():.2f} of random nights")
at_modest = [mine.at(methods.MODEST).mean() for mine in (hundred, random)]
print(f"meant gain with β = {methods.MODEST}: {at_modest[0]:.2f} and {at_modest[1]:.2f}")
worse = at_modest[1] < at_modest[0]
everywhere.measured(everywhere.options[2 if random.fall().mean() > 0.3 else 1 if worse else 0])

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** It falls, and the clock is worse. So rare *actions* are not all of it. Rare *states* may be a part: in random
# nights she is seldom fast asleep at eight, and in the nights of a good clock she is.
# </details>

# %% [markdown]
# ### Ask again
# That suggests another way to spend a hundred comparisons. Ask about 25 pairs of the reference, learn a reward from all answers so far, tune the clock with $\beta = 0.5$; let
# *this* clock make the next 25 pairs; and so on, four rounds in all. Each round asks about what the clock does now. (In the figure on the right a second clock has asked for the second reward in the same way.)
#
# **Predict.** In four rounds, and followed with $\beta = 0.5$, the meant gain is ... (with all at once it is about 8.3).

# %%
in_rounds = predict("In four rounds of 25 the meant gain is ...", unit="(at most 10.1)")
in_rounds

# %%
rounds = methods.followed(rounds=4)
display(figures.gains({"100 at once": hundred, "4 rounds of 25": rounds}, second=True))
print(f"all at once {hundred.at(methods.MODEST).mean():.2f}, in four rounds {rounds.at(methods.MODEST).mean():.2f}")
in_rounds.measured(rounds.at(methods.MODEST).mean())

# %% [markdown]
# <details><summary>What was measured</summary>
#
# **Measured.** About 9.1: the same number of answers, asked where the clock is now, is worth 0.8 more. The fall is
# smaller and not gone.
# </details>

# %% [markdown]
# ## Exercises
#
# Each exercise has a cell for your answer, and below it a cell that checks it: it says what was expected, what came, and
# which mistake that looks like.

# %%
from edugym_course.grading import check
from edugym_course.lessons.preferences.exercises import exercise_1, exercise_2, exercise_3

# %% [markdown]
# ### Exercise 1: the probability of a preference
# Return the probability with which a teacher with noise $\tau$ (`noise`, above 0) prefers a night worth `first` to one worth `second`. It should
# also give a number for nights that differ by 10 000.
#
# <details><summary>Hint</summary><code>math.exp(1000)</code> is an error, <code>np.exp(1000)</code> is infinite, with a warning, and <code>np.exp(-1000)</code> is 0. So write σ(x) in two ways, and take
# the one in which the exponent is negative.</details>


# %%
def prefers(first, second, noise):
    """Return the probability that the first night is preferred."""
    ### BEGIN SOLUTION
    x = (first - second) / noise
    # own: x = (first + {lead} - second) / noise
    if x >= 0:
        return 1 / (1 + np.exp(-x))
    return np.exp(x) / (1 + np.exp(x))
    ### END SOLUTION


# %% tags=["check"]
check(exercise_1, prefers)
### BEGIN HIDDEN TESTS
check(exercise_1, prefers, seed=1, quiet=True)
### END HIDDEN TESTS

# %% [markdown]
# ### Exercise 2: learn from one comparison
# `rewards` is a table $\hat r$, shape (S, A). A night is a list of pairs `(state, action)` of whole numbers. `prefers_first` is True or False. Make one
# gradient step, $\tau = 1$, and return the *new* table. Mind that a night may take the same action in the same state more than
# once.
#
# <details><summary>Hint</summary>First work out p: the return of a night is the sum of the rewards of its steps. All the steps are weighed by the
# same number, α (y − p): added for the first night, subtracted for the second.</details>


# %%
def learn(rewards, first, second, prefers_first, learning_rate):
    """Return the rewards after one gradient step for one comparison."""
    ### BEGIN SOLUTION
    first_return = sum(rewards[state, action] for state, action in first)
    second_return = sum(rewards[state, action] for state, action in second)
    p = 1 / (1 + np.exp(-(first_return - second_return)))
    error = float(prefers_first) - p
    # own: error = ({sure} if prefers_first else 1 - {sure}) - p
    rewards = rewards.copy()
    for state, action in first:
        rewards[state, action] += learning_rate * error
    for state, action in second:
        rewards[state, action] -= learning_rate * error
    return rewards
    ### END SOLUTION


# %% tags=["check"] points=2
check(exercise_2, learn)
### BEGIN HIDDEN TESTS
check(exercise_2, learn, seed=1, quiet=True)
### END HIDDEN TESTS

# %% [markdown]
# ### Exercise 3: the policy with a penalty
# `values` holds $Q(s, a)$ for one state, and `reference` the probabilities $\pi_{\text{ref}}(a \mid s)$. Return the probabilities of the
# best policy there, for a penalty $\beta$ (`penalty`) that may also be very small.
#
# <details><summary>Hint</summary>V(s) only makes the probabilities sum to 1. And you may subtract the same number from all values
# first, which changes nothing: the largest value among the actions that the reference takes. Then none of their exponentials overflows, and one of them is 1. Leave out the actions that it never takes: they may be worth more, and theirs would overflow.</details>


# %%
def with_penalty(values, reference, penalty):
    """Return the probability of each action."""
    ### BEGIN SOLUTION
    taken = reference > 0
    weights = np.zeros(len(values))
    weights[taken] = reference[taken] * np.exp((values[taken] - values[taken].max()) / penalty)
    # own: weights[taken] = reference[taken] * np.exp((values[taken] - values[taken].max()) / ({times} * penalty))
    return weights / weights.sum()
    ### END SOLUTION


# %% tags=["check"] points=2
check(exercise_3, with_penalty)
### BEGIN HIDDEN TESTS
check(exercise_3, with_penalty, seed=1, quiet=True)
### END HIDDEN TESTS

# %% [markdown]
# ### From a blank file
# Until now the package played the nights and learned the rewards. Now write all of it, from an empty cell, with NumPy and
# Gymnasium alone: some 40 lines.
#
# **What it must do.** `my_program(environment, compare, n_comparisons, seed)` returns a policy, a function from an observation to
# an action, always the same action for an observation.
#
# - `environment` is a morning, as a Gymnasium environment. An observation is an array, (time, depth) (make a tuple of it for a key), and
#   `environment.observation_space.nvec` says how many there are of both, counting the time after the last step. The rewards of the environment are always 0. Its
#   nights are longer than those above, and the costs are others: only the teacher knows them.
# - `compare(first, second)` asks the teacher: True if she prefers the first night. A night is a list of `(observation, action,
#   next_observation)`, one for each step from `reset` to the end. She may be asked at most `n_comparisons` times (the check allows 300).
# - You may play as many nights as you like, to be compared, and to learn a policy for the rewards that you have learned.
#   Q-learning needs many, and often a random action: the solution takes 3 000 nights, $\alpha = 0.1$ and $\varepsilon = 0.3$.
# - A night has no discount: what comes late counts in full. It ends with `terminated`, after the last action.
# - Draw all random numbers from `np.random.default_rng(seed)`, and give the seed to the first `reset` alone.
#
# How you learn from her answers is up to you, but each combination of time, depth and action may be worth something else; the check sees only what your clock is worth. Her answers are few, so one pass over them is rarely enough (the solution makes 500, with a step of 0.02 for the sum over all comparisons).
#
# The check works out exactly what your policy is worth to the teacher, for five seeds. The middle one should be worth 4.3 or more; planning on rewards from random nights gives 8.1, and random buttons are worth much less than 0. Then it lets three *other* teachers answer, who want something
# else, and two more whose sleepers sleep otherwise (in one of these a night may begin in two ways). Only their answers tell what, so a clock that you wrote by hand will not please them. Your program runs some 26 times in all. So count the steps of a night in an
# array, once; with a loop over the steps in each pass the check takes minutes.
# <details><summary>A plan</summary>Play pairs of random nights (there is no factory's clock here), and ask. Write a table of rewards, and make many gradient steps of exercise 2.
# Then learn a policy by Q-learning, with your rewards in the place of those of the environment.</details>

# %% tags=["project"]
my_program = ...  # your program


### BEGIN PROGRAM
def my_program(environment, compare, n_comparisons, seed):
    """Learn rewards from comparisons of random nights, then Q-learning with these rewards."""
    rng = np.random.default_rng(seed)
    shape = (*environment.observation_space.nvec, 3)

    def night_of(choose):
        """Play a night, and return its steps."""
        observation, _ = environment.reset()
        steps, over = [], False
        while not over:
            action = choose(tuple(observation))
            next_observation, _, terminated, truncated, _ = environment.step(action)
            steps.append((tuple(observation), action, tuple(next_observation)))
            observation, over = next_observation, terminated or truncated
        return steps

    def visits(steps):
        """How often a night took each action in each state."""
        table = np.zeros(shape)
        for (time, depth), action, _ in steps:
            table[time, depth, action] += 1
        return table.ravel()

    differences, preferred = [], []
    for _ in range(n_comparisons):
        first, second = (night_of(lambda state: int(rng.integers(3))) for _ in range(2))
        preferred.append(float(compare(first, second)))
        differences.append(visits(first) - visits(second))
    differences, preferred = np.array(differences), np.array(preferred)

    rewards = np.zeros(differences.shape[1])
    for _ in range(500):
        p = 0.5 * (1 + np.tanh(differences @ rewards / 2))
        rewards += 0.02 * (differences.T @ (preferred - p) - 0.1 * rewards)
    rewards = rewards.reshape(shape)

    Q = np.zeros(shape)

    def explore(state):
        """Epsilon-greedy."""
        return int(rng.integers(3)) if rng.random() < 0.3 else int(Q[state].argmax())

    for _ in range(3_000):
        for state, action, next_state in night_of(explore):
            target = rewards[state][action] + Q[next_state].max()  # after the last step it is 0
            Q[state][action] += 0.1 * (target - Q[state][action])
    return lambda observation: int(Q[tuple(observation)].argmax())


### END PROGRAM

# %% tags=["project"]
from edugym_course.lessons.preferences.project import project_14

check(project_14, my_program)

# %% [markdown]
# ## What you saw
#
# - Rewards can be learned from comparisons: a hundred of them, and a penalty, took a clock from a return of 0.2 to more
#   than 8.
# - Here, followed too far, the learned return still rises and the meant one falls.
# - A teacher who is never wrong did not cure it, nor did nights in which every action is tried as often. Thirty times as many comparisons did.
# - A second reward, learned from other comparisons, saw the fall on average. The first one could not.
# - The same number of comparisons, asked in rounds about what the policy does now, made a better clock. A stronger prior made the fall smaller ("Your turn").
#
# ### In one paragraph
# *Learn it by heart, or better, say it in your own words.* A teacher who compares two pieces of behaviour tells which has the higher
# return, with noise. The rewards that make her answers most likely are a model of what she wants, with errors. A policy that
# maximises such a reward looks for the places where it is too high. So I follow it with a
# penalty for leaving a policy that I know to be good, and with new comparisons of what the policy does now.
#
# ### Limits
# Here the model is known, all returns are exact, and the teacher is a formula. People are tired, disagree with each other, and may like
# what looks good. A table cannot generalise from one state to another, and a network can, for better or worse. All nights have
# eight steps: where episodes end early, even a number that is added to all rewards changes what is best, and no comparison of nights of
# equal length can tell it. And methods that skip the reward and change the policy directly (direct preference optimisation)
# are not in this lesson.
#
# ### Further reading
# - Christiano, Leike, Brown, Martic, Legg and Amodei (2017), *Deep reinforcement learning from human preferences*.
# - Gao, Schulman and Hilton (2023), *Scaling laws for reward model overoptimization*: such curves for language models.
# - Bradley and Terry (1952), *Rank analysis of incomplete block designs*.
# - Levine (2018), *Reinforcement learning and control as probabilistic inference*: where the soft maximum comes from.
# - Rafailov, Sharma, Mitchell, Ermon, Manning and Finn (2023), *Direct preference optimization*: the policy with a penalty, read backwards.
# - Sutton and Barto, *Reinforcement Learning*, 2nd edition: 4.4 (value iteration), 6.7 (maximisation bias), 17.4 (designing rewards).
